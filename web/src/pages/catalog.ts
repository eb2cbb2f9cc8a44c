// Home: what is known, as a heat map and as a table, and a box to look one design up.
import type { Kind, TableCell } from '../lib/api';
import { announce, field, fill, h, select } from '../lib/dom';
import { readRange } from '../lib/range';
import { completeness, heatmap, table, type Measure, type TableQuery } from '../lib/source';
import { changes, changeWord, kinds, number, ratio } from '../lib/words';
import { badge, gap, glossary } from '../parts/status';
import { isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { theme, withTheme } from '../shell/theme';
import { cellTable } from './catalog/cells';
import { heatMap, sayCell } from './catalog/heat_map';
import { lookUp } from './catalog/look_up';
import { completenessTable, totals } from './catalog/totals';

const measures: readonly (readonly [Measure, string])[] = [
  ['ratio', 'blocks / bound'],
  ['gap', 'blocks over the bound'],
  ['status', 'status'],
];

export const catalog: Page = {
  path: 'catalog',
  title: 'Catalog',
  async render(view: View) {
    const frozen = isCopy();
    const state = {
      change: Number(view.params.get('change') ?? 2),
      kind: (view.params.get('kind') ?? 'circular') as Kind,
      k: view.params.get('k') ?? '3..12',
      v: view.params.get('v') ?? '5..50',
      measure: (view.params.get('measure') ?? 'ratio') as Measure,
    };
    let cells = new Map<string, TableCell>();
    let asking = new AbortController();
    let painting = new AbortController();
    view.signal.addEventListener('abort', () => {
      asking.abort();
      painting.abort();
    });

    const readout = h('div', { class: 'readout', 'aria-live': 'off' });
    const said = h('div');
    const sums = h('div', { class: 'sums' });
    const map = heatMap(
      (v, k) => sayCell(cells.get(`${v}.${k}`) ?? none(v, k)),
      (v, k) => {
        read(cells.get(`${v}.${k}`) ?? none(v, k));
        view.go({ at: `${v}.${k}` }, { quiet: true });
        map.mark(v, k);
      },
      (v, k) => (window.location.hash = link('cell', { v, k, change: state.change, kind: state.kind })),
    );
    const list = cellTable(view);
    const complete = h('details', { class: 'completeness' }, h('summary', {}, 'How complete the whole catalog is, by block size'), h('div', { class: 'inside' }));

    function none(v: number, k: number): TableCell {
      return { v, k, change: state.change, kind: state.kind, b: null, lower_bound: null, status: 'open', construction: null, label: null };
    }

    function read(cell: TableCell): void {
      const measure = gap(cell);
      const to = { v: cell.v, k: cell.k, change: cell.change, kind: cell.kind };
      fill(
        readout,
        h('h2', {}, `v = ${cell.v}, k = ${cell.k} `, badge(cell.status)),
        h(
          'dl',
          { class: 'facts' },
          h('dt', {}, 'blocks'),
          h('dd', {}, cell.b === null ? 'none known' : number(cell.b)),
          h('dt', {}, 'lower bound'),
          h('dd', {}, cell.lower_bound === null ? '–' : number(cell.lower_bound), measure ? ` (gap ${measure}, b / bound ${ratio(cell.b!, cell.lower_bound!)})` : ''),
          h('dt', {}, 'construction'),
          h('dd', {}, cell.construction ?? '–'),
        ),
        h('p', {}, h('a', { href: link('cell', to) }, 'Bounds, recipe, history'), cell.b !== null && [' · ', h('a', { href: link('design', to) }, 'The design')]),
      );
    }

    const query = (): TableQuery => ({ change: state.change, kind: state.kind, k: state.k, v: state.v });

    /** The latest picture that was asked for is the one that counts. */
    function askMap(): Promise<string> {
      painting.abort();
      painting = new AbortController();
      return heatmap(query(), state.measure, theme(), painting.signal);
    }

    async function drawMap(svg: Promise<string>): Promise<void> {
      map.show(await svg);
      const at = /^(\d+)\.(\d+)$/.exec(view.params.get('at') ?? '');
      if (at) {
        map.mark(Number(at[1]), Number(at[2]));
      }
    }

    async function refresh(): Promise<void> {
      asking.abort();
      asking = new AbortController();
      const signal = asking.signal;
      fill(said);
      map.element.setAttribute('aria-busy', 'true');
      fill(complete.lastElementChild!);
      complete.dataset['for'] = '';
      if (complete.open) {
        void fillCompleteness();
      }
      try {
        const svg = askMap();
        svg.catch(() => undefined);
        // The table first: it says what the cells of the map are.
        const answer = await table(query(), signal);
        // The picture of a static copy has more cells than the table if that is of a part of the range.
        const pictured = frozen ? await table({ ...query(), k: '', v: '' }, signal) : answer;
        cells = new Map(pictured.map((cell) => [`${cell.v}.${cell.k}`, cell]));
        list.show(answer);
        fill(sums, totals(answer));
        const at = cells.get(view.params.get('at') ?? '');
        at ? read(at) : fill(readout, h('p', { class: 'hint' }, 'Point at a cell of the map, or walk through it by the arrow keys: what is known is said here.'));
        await drawMap(svg);
        announce(`${answer.length} cells`);
      } catch (fault) {
        if (!signal.aborted && !(fault instanceof DOMException && fault.name === 'AbortError')) {
          fill(said, problem(fault));
        }
      }
      if (!signal.aborted) {
        map.element.removeAttribute('aria-busy');
      }
    }

    async function fillCompleteness(): Promise<void> {
      const wanted = `${state.change}.${state.kind}`;
      if (complete.dataset['for'] === wanted) {
        return;
      }
      complete.dataset['for'] = wanted;
      const inside = complete.lastElementChild!;
      const { signal } = asking;
      const { change, kind } = state;
      try {
        fill(inside, h('p', { class: 'hint' }, 'Counting…'));
        const answer = await completeness(signal);
        if (!signal.aborted) {
          fill(inside, completenessTable(answer, change, kind));
        }
      } catch (fault) {
        if (!signal.aborted) {
          fill(inside, problem(fault));
        }
      }
    }
    complete.addEventListener('toggle', () => complete.open && void fillCompleteness());

    /** The same table in other colours. */
    async function recolour(): Promise<void> {
      const svg = askMap();
      const { signal } = painting;
      try {
        await drawMap(svg);
        fill(said);
      } catch (fault) {
        if (!signal.aborted) {
          fill(said, problem(fault));
        }
      }
    }

    function set(name: keyof typeof state, value: string): void {
      Object.assign(state, { [name]: name === 'change' ? Number(value) : value });
      view.go({ [name]: value }, { quiet: true });
      void (name === 'measure' && cells.size > 0 ? recolour() : refresh());
    }
    const range = (name: 'k' | 'v'): HTMLInputElement => {
      const input = h('input', {
        type: 'text',
        class: 'range',
        value: state[name],
        autocomplete: 'off',
        onchange: () => {
          const good = readRange(input.value) !== null;
          good ? input.removeAttribute('aria-invalid') : input.setAttribute('aria-invalid', 'true');
          if (good) {
            set(name, input.value.trim());
          } else {
            fill(said, problem(new Error(`“${input.value}” is no range: write it as 3..12, or one number.`)));
          }
        },
      });
      return input;
    };

    fill(
      view.root,
      h('div', { class: 'title-row' }, h('h1', {}, 'Change covering designs'), lookUp(() => state)),
      h(
        'p',
        {},
        'Lists of blocks, each ', h('var', {}, 'k'), ' of ', h('var', {}, 'v'), ' elements, in which every two elements are together in some block, and each block differs from the one before in exactly ', h('var', {}, 'm'),
        ' elements. A cell of the map is a pair of parameters; the fewer blocks, the better.',
      ),
      glossary(),
      h(
        'div',
        { class: 'row controls' },
        field('Change number', select(String(state.change), changes, (value) => set('change', value))),
        field('Kind', select(state.kind, kinds, (value) => set('kind', value))),
        field('k, block size', range('k')),
        field('v, elements', range('v')),
        frozen && h('p', { class: 'hint' }, 'This static copy draws the whole range that it has; the table follows k and v.'),
        field('Colour says', select(state.measure, measures, (value) => set('measure', value))),
      ),
      said,
      h('div', { class: 'map-and-readout' }, map.element, readout),
      sums,
      list.element,
      complete,
    );
    document.title = `${state.kind} ${changeWord(state.change)} designs · Changeover`;
    let first = true;
    withTheme(view.signal, () => {
      if (!first) {
        void recolour();
      }
      first = false;
    });
    await refresh();
  },
};
