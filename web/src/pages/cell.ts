// One cell: what is known of its parameters, why, from whom, since when, and how many designs there
// are.
import { ApiError, type Cell, type CellDetail, type Design, type TreeNode } from '../lib/api';
import { fill, h, scroll, type Child } from '../lib/dom';
import { formula } from '../lib/mathematics';
import { cellDetail, constructions, designOf, explain, isHeld } from '../lib/source';
import { groupWords, mostLooked, symmetryOf } from '../lib/symmetry';
import { waiting } from '../lib/wait';
import { changeWord, count, nameOf, number } from '../lib/words';
import { cellArguments, command, toCopy } from '../parts/command';
import { dossierLink } from '../parts/dossier';
import { downloads } from '../parts/downloads';
import { busyKey, cellOf } from '../parts/fields';
import { linkTerms } from '../parts/knowl';
import { defined, reason, recipeTree } from '../parts/recipe';
import { thumbnail } from '../parts/thumbnail';
import { isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { at } from './cell/address';
import { beyondTheCopy, exchanged, tooLarge } from './cell/none';
import { origins } from './cell/designs';
import { neighbourhood } from './cell/neighbours';
import { isTooLong, summary } from './cell/summary';

/** The same with other parameters. Arrow keys go to neighbours, too. */
function others(cell: Cell): HTMLElement {
  const step = (words: string, changes: Partial<Cell>, key?: string): HTMLElement =>
    h('li', {}, h('a', { href: at(cell, changes), 'aria-keyshortcuts': key ?? null }, words));
  return h(
    'nav',
    { class: 'neighbours', 'aria-label': 'Neighbouring cells' },
    h(
      'ul',
      {},
      cell.v > cell.k && step(`← v = ${cell.v - 1}`, { v: cell.v - 1 }, 'ArrowLeft'),
      step(`v = ${cell.v + 1} →`, { v: cell.v + 1 }, 'ArrowRight'),
      cell.k > 2 && step(`↑ k = ${cell.k - 1}`, { k: cell.k - 1 }, 'ArrowUp'),
      cell.k < cell.v && step(`↓ k = ${cell.k + 1}`, { k: cell.k + 1 }, 'ArrowDown'),
      step(cell.kind === 'circular' ? 'linear' : 'circular', {
        kind: cell.kind === 'circular' ? 'linear' : 'circular',
      }),
      [1, 2, 3].filter((m) => m !== cell.change).map((m) => step(changeWord(m), { change: m })),
      h(
        'li',
        {},
        h(
          'a',
          {
            href: link('catalog', {
              change: cell.change,
              kind: cell.kind,
              strength: cell.strength === 2 ? null : cell.strength,
              at: `${cell.v}.${cell.k}`,
            }),
          },
          'on the map',
        ),
      ),
    ),
  );
}

function walk(view: View, cell: Cell): void {
  const moves: Record<string, Partial<Cell>> = {
    ArrowLeft: { v: cell.v - 1 },
    ArrowRight: { v: cell.v + 1 },
    ArrowUp: { k: cell.k - 1 },
    ArrowDown: { k: cell.k + 1 },
  };
  document.addEventListener(
    'keydown',
    (event) => {
      const move = moves[event.key];
      const { v, k } = { ...cell, ...move };
      if (move && !busyKey(event) && !event.shiftKey && k >= 2 && k <= Math.max(v, cell.k)) {
        event.preventDefault();
        void isHeld({ ...cell, ...move }).then(
          (held) => held && !view.signal.aborted && (window.location.hash = at(cell, move)),
        );
      }
    },
    { signal: view.signal },
  );
}

function bounds(detail: CellDetail): Child[] {
  if (detail.impossible) {
    return []; // The reason stands above.
  }
  return [
    h('h2', { id: 'lower-bounds', tabindex: -1 }, 'Lower bounds'),
    detail.bounds.length === 0
      ? h('p', {}, detail.reason ? reason(detail.reason) : 'None is known.')
      : scroll(
          'Lower bounds',
          h(
            'table',
            { class: 'bounds' },
            h(
              'thead',
              {},
              h(
                'tr',
                {},
                h('th', { scope: 'col', class: 'number' }, 'blocks'),
                h('th', { scope: 'col' }, 'bound'),
                h('th', { scope: 'col' }, 'reason'),
              ),
            ),
            h(
              'tbody',
              {},
              detail.bounds.map((bound) =>
                h(
                  'tr',
                  {},
                  h('td', { class: 'number' }, number(bound.blocks)),
                  h('td', {}, bound.name),
                  h(
                    'td',
                    { class: 'reason' },
                    reason(bound.reason),
                    defined(bound.reason, detail.strength),
                  ),
                ),
              ),
            ),
          ),
        ),
  ];
}

/** How many designs there are, where all of them were made. */
function howMany(detail: CellDetail): Child[] {
  const all = detail.classified;
  if (!all) {
    const { best, v, k, change, kind, strength } = detail;
    return best && strength === 2
      ? [
          h('h2', {}, 'How many there are'),
          h(
            'p',
            {},
            `Designs with ${count(best.b, 'block')} were not counted. `,
            command(`changeover classify ${v} ${k} ${best.b} --change ${change} --${kind}`),
            ' counts them; only small parameters are within reach.',
          ),
        ]
      : [];
  }
  const groups = all.groups.map(
    ({ order, classes }) => `${number(classes)} with a group of order ${number(order)}`,
  );
  return [
    h('h2', {}, 'How many there are'),
    h(
      'p',
      {},
      h('strong', {}, count(all.classes, 'class', 'classes')),
      ` of designs with ${count(all.b, 'block')}, up to names of the elements`,
      detail.kind === 'circular' && ' and rotation',
      `, or ${number(all.standard_forms)} up to names alone (standard forms). `,
      all.tight > 0 &&
        (all.tight === all.classes
          ? 'All are tight. '
          : `${number(all.tight)} of the classes are tight. `),
      'There are no others: an exhaustive search found them, and each was verified.',
    ),
    h(
      'ul',
      {},
      groups.map((each) => h('li', {}, each)),
    ),
  ];
}

function offers(detail: CellDetail): Child[] {
  const rest = detail.offers.filter(
    (offer) => offer.construction !== detail.best?.construction || offer.b !== detail.best.b,
  );
  return rest.length === 0
    ? []
    : [
        h('h2', {}, 'Other constructions'),
        scroll(
          'Other constructions',
          h(
            'table',
            {},
            h(
              'thead',
              {},
              h(
                'tr',
                {},
                h('th', { scope: 'col', class: 'number' }, 'blocks'),
                h('th', { scope: 'col' }, 'construction'),
              ),
            ),
            h(
              'tbody',
              {},
              rest.map((offer) =>
                h(
                  'tr',
                  {},
                  h('td', { class: 'number' }, number(offer.b)),
                  h(
                    'td',
                    {},
                    h(
                      'a',
                      { href: link('theorems', { construction: offer.construction }) },
                      offer.construction,
                    ),
                    h('span', { class: 'hint what', 'data-construction': offer.construction }),
                  ),
                ),
              ),
            ),
          ),
        ),
      ];
}

/** What each construction does, in a phrase. */
function sayWhat(root: HTMLElement, signal: AbortSignal): void {
  const places = [...root.querySelectorAll<HTMLElement>('[data-construction]')];
  if (places.length === 0) {
    return;
  }
  constructions(signal).then(
    (all) =>
      places.forEach((place) => {
        const summary = all.find(({ name }) => name === place.dataset['construction'])?.summary;
        fill(place, summary ? [' ', ...reason(summary)] : []);
      }),
    () => undefined, // The names are links.
  );
}

const rowsAre = 'A row for each element, a bar for each stay. ';

/** Whether a design of so many blocks of k elements is shown as a picture. */
const isDrawn = (b: number | undefined, k: number): boolean =>
  b !== undefined && b * k <= mostLooked && b <= 20_000;

/** What is below the picture keeps its place when that comes. */
function keepRoom(figure: HTMLElement): void {
  fill(
    figure,
    h('span', { class: 'thumbnail room' }),
    h('figcaption', { class: 'hint' }, rowsAre, '\u00a0'),
  );
}

/** The design as a picture, and what its symmetries are. */
function picture(cell: Cell, design: Design, place: HTMLElement, signal: AbortSignal): void {
  const b = design.blocks.length;
  if (!isDrawn(b, design.k)) {
    return;
  }
  const symmetry = symmetryOf(design);
  fill(
    place,
    h(
      'a',
      {
        href: link('design', { ...cell, show: 'stays' }),
        'aria-label': 'The design, step by step',
      },
      thumbnail(
        design,
        `Stays of the ${number(design.v)} elements over ${count(b, 'block')}`,
        signal,
      ),
    ),
    h(
      'figcaption',
      { class: 'hint' },
      rowsAre,
      symmetry.order === '1' ? 'No symmetry.' : `Group of ${groupWords(symmetry)}.`,
    ),
  );
}

function showAround(cell: Cell, place: HTMLElement, signal: AbortSignal): void {
  place.classList.add('coming');
  const come = (): void => place.classList.remove('coming');
  neighbourhood(cell, signal).then(
    (map) => {
      map && fill(place, h('h2', {}, 'Around this cell'), map);
      come();
    },
    come, // All else is there.
  );
}

export const cell: Page = {
  path: 'cell',
  title: 'Cell',
  hidden: true,
  async render(view: View) {
    const wanted = cellOf(view.params);
    if (!wanted || wanted.v < 1 || wanted.k < 1) {
      fill(
        view.root,
        h('h1', {}, 'Which cell?'),
        h(
          'p',
          {},
          'The address does not name one: v and k must be whole numbers from 1 on, and kind ' +
            'circular or linear. ' +
            'Choose a cell in the ',
          h('a', { href: link('catalog') }, 'catalog'),
          ', or write it into the address, as ',
          h(
            'a',
            { href: link('cell', { v: 20, k: 5, change: 2, kind: 'circular' }) },
            '#/cell?v=20&k=5&change=2&kind=circular',
          ),
          '.',
        ),
      );
      return;
    }
    const name = nameOf(wanted);
    const strength = wanted.strength ?? 2;
    const short = wanted.change === 1 ? 'SCCD' : wanted.change === 2 ? 'DCCD' : '';
    document.title = `(${wanted.v},${wanted.k}) ${wanted.kind} m = ${wanted.change} · Changeover`;
    const head = h(
      'h1',
      {},
      name[0]!.toUpperCase() + name.slice(1),
      strength > 2 ? `, strength ${strength}` : '',
    );
    const under = h(
      'p',
      { class: 'under' },
      short && [
        `${wanted.kind} `,
        formula(
          `\\mathrm{${short}}(${wanted.v},\\,${wanted.k})`,
          `${short}(${wanted.v}, ${wanted.k})`,
        ),
        ...(strength > 2 ? [', ', formula(`t = ${strength}`, `t = ${strength}`)] : []),
        ', ',
      ],
      `cell ${wanted.v}.${wanted.k}.${wanted.change}.${wanted.kind}` +
        `${strength > 2 ? `.t${strength}` : ''}`,
    );
    const body = h('div', { class: 'cell-body' });
    const begin = (): void => fill(view.root, head, under, body);
    walk(view, wanted);
    const frozen = isCopy();
    if (frozen && !(await isHeld(wanted))) {
      begin();
      fill(body, await beyondTheCopy(wanted), exchanged(wanted));
      return;
    }
    if (wanted.k > wanted.v) {
      const around = h('section', { class: 'around-place', 'aria-label': 'Cells around this one' });
      begin();
      fill(body, tooLarge(wanted), exchanged(wanted), others(wanted), around);
      showAround(wanted, around, view.signal);
      return;
    }
    let detail: CellDetail;
    try {
      detail = await waiting(cellDetail(wanted, view.signal), view.signal, () => {
        begin();
        fill(body, h('p', { class: 'hint' }, 'Asking what is known …'));
      });
    } catch (fault) {
      if (frozen && fault instanceof ApiError && fault.status === 404) {
        begin();
        fill(body, await beyondTheCopy(wanted), exchanged(wanted));
        return;
      }
      fill(body);
      begin();
      throw fault;
    }
    const recipe = h('div', { class: 'recipe-place' }, h('p', { class: 'hint' }, 'Asking …'));
    begin();
    const isLong = detail.best !== null && isTooLong(wanted, detail.best.b);
    const files = h('div', {}, !frozen && downloads(wanted, null, false));
    const figure = h('figure', { class: 'known-picture' });
    if (isDrawn(detail.best?.b, wanted.k)) {
      keepRoom(figure);
    }
    const around = h('section', { class: 'around-place', 'aria-label': 'Cells around this one' });
    fill(
      body,
      summary(wanted, detail, frozen, figure),
      others(wanted),
      h(
        'div',
        { class: 'cell-columns' },
        h(
          'div',
          {},
          // Where there is nothing to say of designs, the neighbours stand in their place.
          detail.impossible ? around : bounds(detail),
          detail.best && [h('h2', {}, 'How it is made'), recipe],
          origins(detail, view.signal),
        ),
        h(
          'div',
          { class: 'cell-side' },
          !detail.impossible && around,
          detail.best && !isLong && [h('h2', {}, 'Download the best design'), files],
          !frozen && detail.best && forAPaper(wanted),
          offers(detail),
          howMany(detail),
          !frozen && [h('h2', {}, 'On the command line'), toCopy(explaining(wanted))],
        ),
      ),
    );
    showAround(wanted, around, view.signal);
    linkTerms(body);
    sayWhat(body, view.signal);
    if (!detail.best) {
      return;
    }
    // Without it the page is whole all the same.
    const drawn = detail.best.b <= 20_000 ? designOf(wanted, view.signal).catch(() => null) : null;
    const named = async (tree: TreeNode): Promise<HTMLElement> => {
      const ofBaseBlocks = / over \d+ copies of /.test(tree.explanation);
      return recipeTree(tree, {
        strength: detail.strength,
        labels: ofBaseBlocks ? (await drawn)?.labels : undefined,
        withoutOrigin: detail.designs.length > 0,
      });
    };
    const tasks: Promise<void>[] = [
      explain(wanted, view.signal).then(async (found) =>
        fill(
          recipe,
          found ? await named(found.tree) : h('p', {}, 'How this design was made is not known.'),
        ),
      ),
    ];
    if (drawn) {
      tasks.push(
        drawn.then((design) => {
          if (!design) {
            fill(figure);
            return;
          }
          picture(wanted, design, figure, view.signal);
          if (frozen) {
            fill(files, downloads(wanted, design, true));
          }
        }),
      );
    }
    for (const each of await Promise.allSettled(tasks)) {
      if (each.status === 'rejected' && !view.signal.aborted) {
        fill(recipe, problem(each.reason));
      }
    }
  },
};

const explaining = (cell: Cell): string => `changeover explain ${cellArguments(cell)}`;

function forAPaper(cell: Cell): HTMLElement {
  return h(
    'p',
    { class: 'hint' },
    'The write-up, with bounds, construction, blocks, how to check and what to cite, also as ',
    dossierLink(cell, 'latex', 'LaTeX'),
    ' or ',
    dossierLink(cell, 'markdown', 'Markdown'),
    '.',
  );
}
