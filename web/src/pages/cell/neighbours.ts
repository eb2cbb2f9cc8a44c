// The cells around one: what they need, coloured by how far from their bounds they are.
import type { Cell } from '../../lib/api';
import { h } from '../../lib/dom';
import { atlasNear } from '../../lib/source';
import { count } from '../../lib/words';
import { link } from '../../shell/router';
import { inkOn } from '../../lib/colours';
import { paintOf } from '../catalog/paint';

const around = { v: 4, k: 2 };

/** Null where the map does not reach. */
export async function neighbourhood(cell: Cell, signal: AbortSignal): Promise<HTMLElement | null> {
  const strength = cell.strength ?? 2;
  const near = await atlasNear(cell, around, signal);
  if (!near?.has(cell.v, cell.k) || signal.aborted) {
    return null;
  }
  const atlas = near;
  const ks = Array.from({ length: 2 * around.k + 1 }, (_, i) => cell.k - around.k + i).filter(
    (k) => k >= atlas.k.from && k <= atlas.k.to,
  );
  const vs = Array.from({ length: 2 * around.v + 1 }, (_, i) => cell.v - around.v + i).filter(
    (v) => v >= atlas.v.from && v <= atlas.v.to,
  );
  const place = h('div', { class: 'around' });
  function draw(): void {
    const paint = paintOf(atlas, 'ratio');
    place.replaceChildren(
      h(
        'table',
        { class: 'around-table' },
        h('caption', { class: 'unseen' }, 'Numbers of blocks of the cells around this one'),
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('td', {}, h('var', {}, 'k'), ' \\ ', h('var', {}, 'v')),
            vs.map((v) => h('th', { scope: 'col' }, v)),
          ),
        ),
        h(
          'tbody',
          {},
          ks.map((k) =>
            h(
              'tr',
              {},
              h('th', { scope: 'row' }, k),
              vs.map((v) => {
                const each = atlas.cell(v, k)!;
                if (each.status === 'impossible') {
                  return h('td', {}, '');
                }
                const here = v === cell.v && k === cell.k;
                const words = each.b === null ? '?' : String(each.b);
                const square = h(
                  'a',
                  {
                    href: link('cell', {
                      ...cell,
                      v,
                      k,
                      strength: strength === 2 ? null : strength,
                    }),
                    'aria-label':
                      `v = ${v}, k = ${k}: ` +
                      `${each.b === null ? 'no design known' : count(each.b, 'block')}`,
                    'aria-current': here ? 'true' : null,
                    title: `v = ${v}, k = ${k}`,
                  },
                  words,
                );
                const colour = paint.of(each);
                square.style.background = colour;
                square.style.color = inkOn(colour);
                return h('td', {}, square);
              }),
            ),
          ),
        ),
      ),
    );
  }
  draw();
  document.addEventListener('themechange', draw, { signal });
  return place;
}
