// The cells around one: what they need, coloured by how far from their bounds they are.
import type { Cell } from '../../lib/api';
import { h } from '../../lib/dom';
import { atlasNear } from '../../lib/source';
import { count } from '../../lib/words';
import { link } from '../../shell/router';
import { inkOn } from '../../lib/colours';
import { paintOf } from '../catalog/paint';

const around = { v: 4, k: 2 };

/** The cell itself where no design exists: framed as every other cell is. */
function noneHere(): HTMLElement {
  return h(
    'span',
    { class: 'here', 'aria-current': 'true', title: 'this cell: there is no design' },
    '–',
    h('span', { class: 'unseen' }, ' this cell: there is no design'),
  );
}

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
    const open = ks.some((k) =>
      vs.some((v) => {
        const { status, b, lower } = atlas.cell(v, k)!;
        return status !== 'impossible' && b === null && lower !== null;
      }),
    );
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
                const here = v === cell.v && k === cell.k;
                if (each.status === 'impossible') {
                  return h('td', {}, here && noneHere());
                }
                const words = String(each.b ?? each.lower ?? '?');
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
                      (each.b !== null
                        ? count(each.b, 'block')
                        : each.lower === null
                          ? 'no design known'
                          : `no design known, at least ${count(each.lower, 'block')}`),
                    class: each.b === null ? 'bound' : null,
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
      open
        ? h(
            'p',
            { class: 'hint' },
            'In italics: no design is known; it would have at least so many blocks.',
          )
        : '',
    );
  }
  draw();
  document.addEventListener('themechange', draw, { signal });
  return place;
}
