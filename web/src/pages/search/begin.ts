// What the page shows before a search is chosen: searches to try, with their outcomes, and cells of
// the selection where something may be found.
import type { Kind, SearchWay } from '../../lib/api';
import { fill, h, scroll } from '../../lib/dom';
import { atlasOf } from '../../lib/source';
import { changeWord, count, number } from '../../lib/words';
import { shortName } from '../../parts/recipe';
import { link } from '../../shell/router';
import { wayWords } from './words';

interface Example {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength?: number;
  way: SearchWay;
  seconds: number;
  outcome: string;
  took: string;
}

/** Each was run with `changeover search` on one thread of a machine with two cores. */
const examples: readonly Example[] = [
  {
    v: 9,
    k: 5,
    change: 2,
    kind: 'linear',
    way: 'exact',
    seconds: 60,
    outcome: 'the minimum is 6 blocks: there is no design with 5, and the proof was checked',
    took: '1 s',
  },
  {
    v: 31,
    k: 4,
    change: 2,
    kind: 'circular',
    way: 'base-blocks',
    seconds: 60,
    outcome: 'a tight design with 93 blocks, made of 3 base blocks',
    took: '1 s',
  },
  {
    v: 12,
    k: 5,
    change: 1,
    kind: 'linear',
    strength: 3,
    way: 'local',
    seconds: 10,
    outcome: 'a first design, of 44 to 46 blocks; it covers all triples',
    took: '10 s, its limit',
  },
];

const mostCells = 8;

/** @return the section, and a function that shows cells of a selection in it. */
export function beginning(): {
  element: HTMLElement;
  show(change: number, kind: Kind, strength: number): void;
} {
  const cells = h('div', {});
  let asked = '';
  const head = (...names: [string, boolean][]): HTMLElement =>
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        names.map(([name, right]) =>
          h('th', { scope: 'col', class: right ? 'number' : null }, name),
        ),
      ),
    );
  const trials = h(
    'div',
    {},
    h('h2', {}, 'Searches to try'),
    h('p', {}, 'A link fills in the form; Start begins the search.'),
    scroll(
      'Searches to try',
      h(
        'table',
        { class: 'searches trials' },
        head(['design', false], ['method', false], ['outcome', false], ['time', false]),
        h(
          'tbody',
          {},
          examples.map(({ outcome, took, ...search }) =>
            h(
              'tr',
              {},
              h(
                'td',
                {},
                h('a', { href: link('search', { ...search }) }, shortName(search)),
                search.strength && `, t\u00a0=\u00a0${search.strength}`,
              ),
              h('td', {}, wayWords[search.way]),
              h('td', {}, outcome),
              h('td', {}, took),
            ),
          ),
        ),
      ),
    ),
    h('p', { class: 'hint' }, 'Times of one thread of a machine with two cores.'),
  );

  async function ask(change: number, kind: Kind, strength: number): Promise<void> {
    const mine = (asked = `${change}.${kind}.${strength}`);
    const all = (await atlasOf({ change, kind, strength })).cells();
    if (mine !== asked) {
      return;
    }
    const close = all
      .filter(({ gap }) => gap === 1)
      .sort((one, other) => one.v - other.v || one.k - other.k);
    const known = all.filter(({ b }) => b !== null);
    const found = known.filter(({ construction }) => construction === 'found').length;
    const words = `${kind} ${changeWord(change)} designs`;
    fill(
      cells,
      h('h2', {}, 'Cells with a gap of 1'),
      close.length === 0
        ? h('p', {}, `None of the ${words} in the catalog is one block above its lower bound.`)
        : [
            h(
              'p',
              {},
              `In ${count(close.length, 'cell')} of the ${words} the best one has one block more ` +
                'than the lower bound. A search may find one without that block, or prove that ' +
                'there is none.',
            ),
            h(
              'table',
              { class: 'searches' },
              head(['design', false], ['blocks', true], ['bound', true]),
              h(
                'tbody',
                {},
                close.slice(0, mostCells).map((cell) =>
                  h(
                    'tr',
                    {},
                    h(
                      'td',
                      {},
                      h(
                        'a',
                        {
                          href: link('search', {
                            v: cell.v,
                            k: cell.k,
                            change,
                            kind,
                            strength: strength === 2 ? null : strength,
                          }),
                        },
                        shortName(cell),
                      ),
                    ),
                    h('td', { class: 'number' }, number(cell.b!)),
                    h('td', { class: 'number' }, number(cell.lower!)),
                  ),
                ),
              ),
            ),
            h(
              'p',
              {},
              h(
                'a',
                {
                  href: link('catalog', {
                    change,
                    kind,
                    strength: strength === 2 ? null : strength,
                    measure: 'gap',
                    gap: 1,
                    status: 'best-known',
                  }),
                },
                'All cells with a gap on the map',
              ),
              '.',
            ),
          ],
      known.length > 0 &&
        h(
          'p',
          { class: 'hint' },
          `Searches found ${number(found)} of the ${number(known.length)} best designs of this ` +
            'kind; constructions make the others.',
        ),
    );
  }

  return {
    element: h('section', { class: 'search-begin' }, trials, cells),
    show(change, kind, strength) {
      // What cannot be asked is said where the form is.
      ask(change, kind, strength).catch(() => fill(cells));
    },
  };
}
