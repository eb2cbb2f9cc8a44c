// The catalog: all cells as a map and as a table, and what is known of the one that is pointed at.
import type { Kind } from '../lib/api';
import type { Atlas, AtlasCell, Selection } from '../lib/atlas';
import { work } from '../lib/citations';
import { announce, field, fill, h, select } from '../lib/dom';
import { readRange } from '../lib/range';
import { addGroups, atlasOf, cellDetail, completeness } from '../lib/source';
import { changes, changeWord, count, kinds, number, ratio } from '../lib/words';
import { more } from '../parts/more';
import { badge } from '../parts/status';
import { about, isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { atlasMap } from './catalog/atlas_map';
import { cellTable } from './catalog/cells';
import { filters } from './catalog/filters';
import { lookUp } from './catalog/look_up';
import type { Written } from './catalog/map_words';
import { measures, paintOf } from './catalog/paint';
import { takeAlong } from './catalog/taken';
import { completenessTable, totals } from './catalog/totals';

const strengths: readonly (readonly [string, string])[] = [
  ['2', 'pairs (t = 2)'],
  ['3', 'triples (t = 3)'],
  ['4', 'quadruples (t = 4)'],
];
const writtens: readonly (readonly [Written, string])[] = [
  ['b', 'blocks'],
  ['gap', 'blocks − bound'],
];

function linkOf(cell: AtlasCell): Record<string, string | number | null> {
  return {
    v: cell.v,
    k: cell.k,
    change: cell.change,
    kind: cell.kind,
    strength: cell.strength === 2 ? null : cell.strength,
  };
}

/** What is to be said where most cells in sight have no design; null elsewhere. */
function whatLacks(
  inSight: readonly AtlasCell[],
  onlyKnown: (() => void) | null,
): HTMLElement | null {
  const possible = inSight.filter((cell) => cell.status !== 'impossible');
  const known = possible.filter((cell) => cell.b !== null).length;
  return 2 * known >= possible.length
    ? null
    : h(
        'p',
        {},
        `A design is known for ${number(known)} of these ${count(possible.length, 'cell')}. ` +
          'A number in italics says how many blocks a design would have at least. ' +
          `${isCopy() ? '' : 'Select such a cell to search for its first design. '}`,
        onlyKnown && [
          h(
            'button',
            { type: 'button', class: 'as-link', onclick: onlyKnown },
            'Show only those with a design',
          ),
          '.',
        ],
      );
}

/** The cell that is read before one is chosen: it has a design. */
function firstRead(atlas: Atlas): AtlasCell | null {
  const usual = atlas.cell(20, 5);
  return usual && usual.b !== null
    ? usual
    : atlas
        .cells()
        .reduce<AtlasCell | null>(
          (best, cell) => (cell.b !== null && cell.b > (best?.b ?? 0) ? cell : best),
          null,
        );
}

export const catalog: Page = {
  path: 'catalog',
  title: 'Catalog',
  async render(view: View) {
    const param = (name: string, otherwise: string): string => view.params.get(name) ?? otherwise;
    const copied = isCopy() ? (await about()).range : undefined;
    const selection = (): Selection => ({
      change: Number(param('change', '2')),
      kind: param('kind', 'circular') as Kind,
      strength: Number(param('strength', '2')),
    });
    let atlas: Atlas | null = null;
    let listed: AtlasCell[] = [];
    let asked = 0;

    const readout = h('aside', { class: 'readout', 'aria-label': 'Details of the selected cell' });
    const said = h('div');
    const legend = h('div', { class: 'legend-place' });
    const lacking = h('div', { class: 'lacking' });
    const beyond = h(
      'li',
      { hidden: true },
      h('span', { class: 'legend-key beyond' }),
      'outside the range',
    );
    const sums = h('div', { class: 'sums' });
    const list = cellTable(view);
    const complete = h(
      'details',
      { class: 'completeness' },
      h('summary', {}, 'Completeness by block size'),
      h('div', { class: 'inside' }),
    );
    const sift = filters(view, () => void redraw());
    const take = takeAlong(() => listed, selection);
    const kRange = range('k');
    const vRange = range('v');

    const map = atlasMap(view.signal, {
      pointed: (cell) => cell && read(cell),
      chosen(cell) {
        read(cell);
        view.go({ at: `${cell.v}.${cell.k}` }, { quiet: true });
      },
      opened: (cell) => (window.location.hash = link('cell', linkOf(cell))),
      moved: () => soon(),
    });

    /** A design that a publication reports is on no map: it is asked for when a cell is read. */
    let reading = 0;
    function addReport(cell: AtlasCell, list: HTMLElement): void {
      window.clearTimeout(reading);
      if (cell.gap === 0 || cell.status === 'impossible') {
        return;
      }
      reading = window.setTimeout(() => {
        cellDetail(cell, view.signal).then(
          ({ reported }) =>
            reported &&
            list.append(
              h('dt', {}, 'reported'),
              h('dd', {}, `${number(reported.blocks)}, `, work(reported.cites)),
            ),
          () => undefined, // All else is there.
        );
      }, 200);
    }
    view.signal.addEventListener('abort', () => window.clearTimeout(reading));

    function read(cell: AtlasCell): void {
      const facts: [string, string][] = [
        ['blocks', cell.b === null ? 'none known' : number(cell.b)],
        ['lower bound', cell.lower === null ? '–' : number(cell.lower)],
        [
          'gap',
          cell.gap === null
            ? '–'
            : cell.gap === 0
              ? 'none'
              : `${number(cell.gap)} (b / bound ${ratio(cell.b!, cell.lower!)})`,
        ],
        ['made by', cell.construction === 'found' ? 'a search' : (cell.construction ?? '–')],
        ...(cell.order !== null
          ? ([
              [
                'group',
                cell.order.length > 12
                  ? `order ≈ 10^${cell.order.length - 1}`
                  : `order ${number(Number(cell.order))}`,
              ],
            ] as [string, string][])
          : []),
      ];
      const list = h(
        'dl',
        { class: 'facts' },
        facts.map(([name, value]) => [h('dt', {}, name), h('dd', {}, value)]).flat(),
      );
      addReport(cell, list);
      fill(
        readout,
        h('h2', {}, `v = ${cell.v}, k = ${cell.k} `),
        h(
          'p',
          { class: 'badges' },
          badge(cell.status),
          cell.tight && [' ', h('span', { class: 'badge good' }, 'tight')],
        ),
        list,
        h(
          'p',
          {},
          h('a', { href: link('cell', linkOf(cell)) }, 'Bounds, recipe, history'),
          cell.b !== null
            ? [h('br'), h('a', { href: link('design', linkOf(cell)) }, 'The design, step by step')]
            : !isCopy() && [
                h('br'),
                h('a', { href: link('search', linkOf(cell)) }, 'Search for a design'),
              ],
        ),
      );
    }

    // ---- what is in sight ----
    let timer = 0;
    function soon(): void {
      window.clearTimeout(timer);
      timer = window.setTimeout(() => !view.signal.aborted && follow(true), 120);
    }
    view.signal.addEventListener('abort', () => window.clearTimeout(timer));

    /** Table, sums and link follow the part of the map that is in sight. */
    function follow(tell: boolean): void {
      if (!atlas) {
        return;
      }
      const { k, v } = map.seen();
      const whole =
        k.from === atlas.k.from &&
        k.to === atlas.k.to &&
        v.from === atlas.v.from &&
        v.to === atlas.v.to;
      kRange.value = `${k.from}..${k.to}`;
      vRange.value = `${v.from}..${v.to}`;
      if (tell) {
        view.go(
          { k: whole ? null : kRange.value, v: whole ? null : vRange.value },
          { quiet: true },
        );
      }
      const inSight = atlas
        .cells(k, v)
        .filter(
          (cell) => cell.status !== 'impossible' || view.params.get('status') === 'impossible',
        );
      listed = inSight.filter(sift.passes());
      list.show(listed, atlas.knowsGroups);
      fill(sums, totals(listed));
      const onlyKnown = param('status', '') === 'known' ? null : () => sift.only('known');
      fill(lacking, whatLacks(inSight, onlyKnown));
      beyond.hidden = !map.showsBeyond();
      sift.say(listed.length, inSight.length);
    }

    function paint(): void {
      if (atlas) {
        const measure = param('measure', 'ratio');
        map.show(atlas, {
          measure,
          written: param('number', 'b') as Written,
          passes: sift.passes(),
        });
        const list = paintOf(atlas, measure, param('number', 'b') === 'b').legend;
        list.append(beyond);
        fill(legend, list);
      }
    }

    async function redraw(): Promise<void> {
      const mine = ++asked;
      try {
        const wanted = selection();
        const next = await atlasOf(wanted);
        if (sift.needsGroups() && !next.knowsGroups) {
          const waits =
            'Counting symmetries of all designs in this selection: a few seconds, once.';
          atlas ? sift.wait(waits) : fill(said, h('p', { class: 'note', role: 'status' }, waits));
          await addGroups(next, view.signal);
        }
        if (view.signal.aborted || mine !== asked) {
          return;
        }
        fill(said);
        const other = atlas !== next;
        atlas = next;
        anyCell.disabled = false;
        if (other) {
          sift.offer(atlas.constructions);
          document.title = `${wanted.kind} ${changeWord(wanted.change)} designs · Changeover`;
          if (complete.open) {
            void fillCompleteness();
          }
        }
        paint();
        follow(false);
        const at = /^(\d+)\.(\d+)$/.exec(view.params.get('at') ?? '');
        // Something is there to be read from the beginning.
        const first = firstRead(atlas);
        const cell = at
          ? atlas.cell(Number(at[1]), Number(at[2]))
          : first && sift.passes()(first)
            ? first
            : (listed.find(({ b }) => b !== null) ?? listed[0] ?? null);
        if (cell && cell.status !== 'impossible') {
          read(cell);
          map.mark(cell.v, cell.k);
        } else if (!at && listed.length === 0 && atlas.cells().length > 0) {
          map.mark(null);
          fill(
            readout,
            h('h2', {}, 'No cell is left'),
            h('p', { class: 'hint' }, 'The filters below leave none of those in sight.'),
          );
        } else {
          fill(
            readout,
            h('h2', {}, 'Details of the selected cell'),
            h(
              'p',
              { class: 'hint' },
              'Select a cell with the mouse, a finger or the arrow keys. Enter opens it.',
            ),
          );
        }
        announce(count(listed.length, 'cell'));
      } catch (fault) {
        if (!view.signal.aborted) {
          sift.wait('');
          fill(said, problem(fault));
        }
      }
    }

    async function fillCompleteness(): Promise<void> {
      const { change, kind } = selection();
      const inside = complete.lastElementChild!;
      complete.dataset['for'] = `${change}.${kind}`;
      fill(inside, h('p', { class: 'hint' }, 'Counting …'));
      try {
        const answer = await completeness(view.signal);
        if (complete.dataset['for'] === `${change}.${kind}`) {
          fill(inside, completenessTable(answer, change, kind));
        }
      } catch (fault) {
        if (!view.signal.aborted) {
          fill(inside, problem(fault));
        }
      }
    }
    complete.addEventListener('toggle', () => complete.open && void fillCompleteness());

    function set(name: string, value: string, otherwise: string): void {
      view.go(
        {
          [name]: value === otherwise ? null : value,
          ...(name === 'strength' ? { k: null, v: null, at: null } : {}),
        },
        { quiet: true },
      );
      void redraw();
    }
    function range(name: 'k' | 'v'): HTMLInputElement {
      const input = h('input', {
        type: 'text',
        class: 'range',
        value: param(name, name === 'k' ? '3..40' : '4..160'),
        autocomplete: 'off',
        onchange: () => {
          const [k, v] = [readRange(kRange.value), readRange(vRange.value)];
          const good = readRange(input.value) !== null;
          good ? input.removeAttribute('aria-invalid') : input.setAttribute('aria-invalid', 'true');
          if (!good) {
            fill(
              said,
              problem(
                new Error(`“${input.value}” is not a range. Write it as 3..12, or one number.`),
              ),
            );
          } else if (k && v) {
            fill(said);
            map.look({ k, v });
            follow(true);
          }
        },
      });
      return input;
    }
    const choice = (
      label: string,
      name: string,
      otherwise: string,
      options: readonly (readonly [string, string])[],
    ): HTMLElement =>
      field(
        label,
        select(param(name, otherwise), options, (value) => set(name, value, otherwise)),
      );
    const button = (words: string, label: string, act: () => void): HTMLElement =>
      h(
        'button',
        { type: 'button', class: 'plain', 'aria-label': label, title: label, onclick: act },
        words,
      );

    function random(): void {
      const from =
        listed.length > 0 ? listed : (atlas?.cells().filter((cell) => cell.b !== null) ?? []);
      const cell = from[Math.floor(Math.random() * from.length)];
      if (cell) {
        window.location.hash = link('cell', linkOf(cell));
      }
    }

    // Until there are cells there is none to open.
    const anyCell = h(
      'button',
      { type: 'button', class: 'plain small', disabled: true, onclick: random },
      'Random cell',
    );

    if (view.params.has('k') || view.params.has('v')) {
      const [k, v] = [readRange(param('k', '')), readRange(param('v', ''))];
      map.look({ ...(k ? { k } : {}), ...(v ? { v } : {}) });
    }
    fill(
      view.root,
      h(
        'div',
        { class: 'title-row' },
        h(
          'div',
          {},
          h('h1', {}, 'Catalog'),
          h(
            'p',
            { class: 'lead' },
            'The best known design for every choice of v elements, block size k and change ' +
              'number m. A cell of the map is one choice. Zoom in to read how many blocks it ' +
              'needs.',
          ),
        ),
        lookUp(selection),
      ),
      h(
        'div',
        { class: 'row controls' },
        choice(
          'Change number',
          'change',
          '2',
          changes.filter(([change]) => !copied || copied.changes.includes(Number(change))),
        ),
        choice('Kind', 'kind', 'circular', kinds),
        choice('Covers', 'strength', '2', strengths),
        more('controls').element,
        choice('Colour by', 'measure', 'ratio', measures),
        choice('Numbers', 'number', 'b', writtens),
        field('k, block size', kRange),
        field('v, elements', vRange),
        h(
          'div',
          { class: 'zooms', role: 'group', 'aria-label': 'Zoom' },
          button('−', 'Zoom out', () => map.zoom(1 / 1.6)),
          button('+', 'Zoom in', () => map.zoom(1.6)),
          button('All', 'All cells', () => map.fit()),
        ),
      ),
      said,
      h(
        'div',
        { class: 'map-and-readout' },
        h(
          'div',
          { class: 'map-place' },
          map.element,
          h(
            'div',
            { class: 'map-foot' },
            legend,
            lacking,
            h(
              'p',
              { class: 'hint' },
              h(
                'span',
                { class: 'with-wheel' },
                'Ctrl + wheel or two fingers zoom, dragging pans.',
              ),
              h('span', { class: 'with-fingers' }, 'Two fingers zoom, dragging pans.'),
            ),
          ),
        ),
        h('div', { class: 'map-side' }, readout, sift.element),
      ),
      h('div', { class: 'row sums-row' }, sums, take, anyCell),
      list.element,
      complete,
    );
    document.addEventListener('themechange', paint, { signal: view.signal });
    const wrong = (['k', 'v'] as const).filter(
      (name) => view.params.has(name) && readRange(param(name, '')) === null,
    );
    const asWritten = wrong.map((name) => `${name} = ${param(name, '')}`).join(' and ');
    await redraw();
    if (wrong.length > 0 && !view.signal.aborted) {
      const what = wrong.length === 1 ? 'which is not a range' : 'which are not ranges';
      fill(
        said,
        problem(
          new Error(
            `The address asks for ${asWritten}, ${what}: all ${wrong.join(' and ')} are shown. ` +
              'Write 3..12, or one number.',
          ),
        ),
      );
    }
    // The other selections are fetched while nothing else happens, one after another, so that
    // choosing one takes no time and does not wait for all of them.
    const others = [1, 2, 3].flatMap((change) =>
      (['circular', 'linear'] as const).map((kind) => ({ change, kind, strength: 2 })),
    );
    const ahead = (): void => {
      const next = isCopy() || view.signal.aborted ? undefined : others.shift();
      if (next) {
        void atlasOf(next)
          .catch(() => undefined)
          .then(() => requestIdleCallback(ahead));
      }
    };
    const idle = window.setTimeout(ahead, 1500);
    view.signal.addEventListener('abort', () => window.clearTimeout(idle));
  },
};
