// How much is known: of the range that is shown, and of the whole catalog by block size.
import type { Completeness } from '../../lib/api';
import type { AtlasCell } from '../../lib/atlas';
import { h, scroll } from '../../lib/dom';
import { number } from '../../lib/words';

export function totals(cells: readonly AtlasCell[]): HTMLElement {
  const possible = cells.filter((cell) => cell.status !== 'impossible');
  const known = possible.filter((cell) => cell.b !== null);
  const minimum = known.filter((cell) => cell.status === 'minimum').length;
  const ratios = known.filter((cell) => cell.lower).map((cell) => cell.b! / cell.lower!);
  const mean =
    ratios.length > 0 ? ratios.reduce((sum, each) => sum + each, 0) / ratios.length : null;
  const facts: [string, string][] = [
    ...(known.length === possible.length
      ? ([['cells, all with a design', number(known.length)]] as [string, string][])
      : ([
          ['cells', number(possible.length)],
          ['with a design', number(known.length)],
        ] as [string, string][])),
    [
      'proved minimum',
      possible.length > 0
        ? `${number(minimum)} (${Math.round((100 * minimum) / possible.length)} %)`
        : '0',
    ],
    ['mean of b / bound', mean === null ? '–' : mean.toFixed(4)],
  ];
  return h(
    'ul',
    { class: 'totals', 'aria-label': 'What is known in this range' },
    facts.map(([name, value]) => h('li', {}, h('strong', {}, value), ' ', name)),
  );
}

/** The catalog's completeness for one change number and kind: one row per block size. */
export function completenessTable(
  all: readonly Completeness[],
  change: number,
  kind: string,
): HTMLElement {
  const mine = all.filter((each) => each.change === change && each.kind === kind);
  if (mine.length === 0) {
    return h('p', {}, 'The catalog has no designs of this change number and kind.');
  }
  return scroll(
    'Completeness by block size',
    h(
      'table',
      {},
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          ['strength', 'k', 'v', 'cells', 'proved minimum', '', 'mean of b / bound'].map(
            (name, i) =>
              h(
                'th',
                { scope: 'col', class: i === 2 || i === 5 ? null : 'number' },
                name || h('span', { class: 'unseen' }, 'share'),
              ),
          ),
        ),
      ),
      h(
        'tbody',
        {},
        mine.map((each) =>
          h(
            'tr',
            {},
            h('td', { class: 'number' }, each.strength),
            h('td', { class: 'number' }, each.k),
            h('td', {}, `${each.v_from} … ${each.v_to}`),
            h('td', { class: 'number' }, number(each.cells)),
            h('td', { class: 'number' }, number(each.minimum)),
            h(
              'td',
              {},
              h(
                'meter',
                {
                  min: 0,
                  max: each.cells,
                  value: each.minimum,
                  'aria-label': `${Math.round((100 * each.minimum) / each.cells)} % proved minimum`,
                },
                `${Math.round((100 * each.minimum) / each.cells)} %`,
              ),
            ),
            h('td', { class: 'number' }, each.mean_ratio.toFixed(4)),
          ),
        ),
      ),
    ),
  );
}
