// A design in numbers, and what each of them means.
import type { Design } from '../../lib/api';
import { h, type Child } from '../../lib/dom';
import { mathText } from '../../lib/mathematics';
import { termsOf } from '../../lib/terms';
import { changeWord, number, setsOf } from '../../lib/words';
import { link } from '../../shell/router';

export function facts(design: Design): HTMLElement {
  const verdict = design.verdict;
  const b = design.blocks.length;
  const strength = design.strength ?? 2;
  const terms = termsOf(strength);
  const yes = (so: boolean, bad = false): Child =>
    h('span', { class: `badge ${so ? 'good' : bad ? 'impossible' : ''}` }, so ? 'yes' : 'no');
  const cell = link('cell', {
    v: design.v,
    k: design.k,
    change: design.change,
    kind: design.kind,
    strength: design.strength === 2 ? null : design.strength,
  });
  const rows: [string, Child | Child[], string][] = [
    ['elements v', number(design.v), terms.v],
    ['block size k', number(design.k), terms.k],
    ['change number m', [number(design.change), ` (${changeWord(design.change)})`], terms.change],
    ['kind', design.kind, terms.kind],
    ...(strength > 2
      ? ([
          [
            'strength t',
            `${strength} (${setsOf(strength)})`,
            'every t elements are together in some block, and not only every two',
          ],
        ] as [string, string, string][])
      : []),
    ['blocks b', h('strong', {}, number(b)), terms.blocks],
  ];
  if (verdict) {
    const status =
      verdict.minimum === 'proved'
        ? h('span', { class: 'badge minimum' }, 'proved')
        : h('span', { class: 'badge' }, 'not known');
    rows.push(
      [
        'lower bound',
        [number(verdict.lower_bound), ' ', h('a', { href: cell }, 'why')],
        terms.bound,
      ],
      ['valid', yes(verdict.valid, true), terms.valid],
      ['minimum', status, `means: ${terms.minimum}`],
      ['tight', yes(verdict.tight), `means: ${terms.tight}`],
      ['economical', yes(verdict.economical), `means: it ${terms.economical}`],
    );
  }
  return h(
    'table',
    { class: 'fact-table' },
    h('caption', { class: 'unseen' }, 'The design in numbers'),
    h(
      'tbody',
      {},
      rows.map(([name, value, meaning]) =>
        h(
          'tr',
          {},
          h('th', { scope: 'row' }, h('dfn', {}, name)),
          h('td', {}, value),
          h('td', { class: 'hint' }, mathText(meaning)),
        ),
      ),
    ),
  );
}
