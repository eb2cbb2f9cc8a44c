// What the colours of the matrix of pairs mean, and how many pairs there are of each.
import { colourBar } from '../../lib/canvas';
import { scale } from '../../lib/colours';
import { fill, h } from '../../lib/dom';
import { number, setsOf } from '../../lib/words';
import { theme } from '../../shell/theme';
import type { Matrix } from './matrix';

const kinds: readonly (readonly [string, string])[] = [
  ['never', 'never'],
  ['once', 'once'],
  ['twice', 'twice'],
  ['more', 'more often'],
];

/** The colours of the blocks, from the first to the last. */
export function blockScale(b: number, signal: AbortSignal): HTMLElement {
  const bar = h('div', { class: 'matrix-scale' });
  const paint = (): void =>
    fill(
      bar,
      colourBar(scale(theme())),
      h('span', {}, 'block 1'),
      h('span', {}, `block ${number(b)}`),
    );
  paint();
  document.addEventListener('themechange', paint, { signal });
  return bar;
}

export function matrixKey(
  b: number,
  pairs: Matrix,
  strength: number,
  signal: AbortSignal,
): HTMLElement {
  const several = setsOf(strength);
  const often = pairs.often();
  const sums = [
    often.get(0) ?? 0,
    often.get(1) ?? 0,
    often.get(2) ?? 0,
    [...often].reduce((sum, [n, of]) => sum + (n > 2 ? of : 0), 0),
  ];
  const most = Math.max(0, ...often.keys());
  return h(
    'div',
    { class: 'matrix-key' },
    h('h2', {}, 'Below the diagonal'),
    h(
      'p',
      {},
      strength === 2
        ? 'The block in which the pair first meets.'
        : `The block with which all ${several} that have the pair have met.`,
    ),
    blockScale(b, signal),
    h('h2', {}, 'Above the diagonal'),
    h(
      'p',
      {},
      strength === 2
        ? 'How often the pair is newly covered. Once is enough: each further time is excess.'
        : [
            `How often ${several} that have the pair are newly covered beyond once: the excess. `,
            ...[
              ['once', 'none'],
              ['twice', 'one'],
              ['more', 'more'],
            ].flatMap(([name, words]) => [
              h('span', { class: 'whole' }, h('span', { class: `key key-${name}` }), ` ${words}`),
              ' ',
            ]),
          ],
    ),
    h(
      'table',
      {},
      h(
        'thead',
        {},
        h('tr', {}, h('th', {}, 'newly covered'), h('th', { class: 'number' }, several)),
      ),
      h(
        'tbody',
        {},
        kinds.map(([name, words], i) =>
          sums[i]! > 0 || i === 1
            ? h(
                'tr',
                {},
                h(
                  'td',
                  {},
                  strength === 2 && [h('span', { class: `key key-${name}` }), ' '],
                  i === 3 && most > 3 ? `${words}, up to ${number(most)} times` : words,
                ),
                h('td', { class: 'number' }, number(sums[i]!)),
              )
            : null,
        ),
      ),
    ),
    h(
      'p',
      { class: 'hint' },
      'Point at a square to read its pair; click it to see the pair in all views.',
    ),
  );
}
