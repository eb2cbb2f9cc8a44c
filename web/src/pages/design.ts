// One design: its pictures, its blocks, and a player that steps through them.
import { ApiError, type Design } from '../lib/api';
import { field, fill, h, scroll, select, type Child } from '../lib/dom';
import { cellOfLabel, designOf, explain, isCell, type Asked } from '../lib/source';
import { mostLooked, symmetryOf } from '../lib/symmetry';
import { waiting } from '../lib/wait';
import { count, nameOf, setsOf, setWord } from '../lib/words';
import { copyButton } from '../parts/copy';
import { dossierLink } from '../parts/dossier';
import { asText, downloads } from '../parts/downloads';
import { askedOf } from '../parts/fields';
import { recipeTree } from '../parts/recipe';
import { byFirst } from '../parts/thumbnail';
import { tabs, type Tab } from '../parts/tabs';
import { about, isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { chips, facts } from './design/facts';
import { citation } from './cell/designs';
import { arrayView } from './design/array';
import { circleView, hasShortCycles } from './design/circle';
import { matrix } from './design/matrix';
import { blockScale, matrixKey } from './design/matrix_key';
import { recipePicture, savePicture } from './design/pictures';
import { openPlayer } from './design/player';
import { Chosen } from './design/selection';
import { Sets } from './design/sets';
import { Steps } from './design/steps';
import { Stays } from '../parts/stays';
import { timeline, type Order } from '../parts/timeline';

const orders: readonly (readonly [string, string])[] = [
  ['first', 'of first blocks'],
  ['stays', 'of numbers of stays'],
  ['given', 'as numbered'],
];

/** More blocks than this are not put into the page as text. */
const mostText = 20_000;

function recipeTab(asked: Asked, design: Design, panel: HTMLElement, signal: AbortSignal): void {
  const place = h('div');
  const image = h('div');
  fill(panel, place, image);
  waiting(explain(asked, signal), signal, () =>
    fill(place, h('p', { class: 'hint' }, 'Asking how it is made…')),
  ).then(
    (found) => {
      if (!found) {
        fill(
          place,
          h(
            'p',
            {},
            design.recipe
              ? `Made by ${design.recipe.construction}, as its file says.`
              : 'The blocks are all that is known of this design: nothing says how it was made.',
          ),
        );
        return;
      }
      fill(
        place,
        recipeTree(found.tree, {
          ...design,
          // Who found it, and how, stands in the facts.
          withoutOrigin: /; \d{4}-\d\d-\d\d\. \S/.test(found.tree.explanation),
        }),
      );
      if (found.tree.inputs.length > 0) {
        void recipePicture(asked, image, signal);
      }
    },
    (fault: unknown) => !signal.aborted && fill(place, problem(fault)),
  );
}

/** So many lines are laid out at once, when they come into sight: all of them take too long. */
const linesAtOnce = 200;

/** Lines as parts that the browser skips while they are out of sight. */
function inParts(text: string): HTMLElement[] {
  const lines = text.split(/(?<=\n)/);
  const parts: HTMLElement[] = [];
  for (let i = 0; i < lines.length; i += linesAtOnce) {
    const some = lines.slice(i, i + linesAtOnce);
    const part = h('span', { class: 'lines' }, some.join(''));
    part.style.setProperty('--lines', String(some.length));
    parts.push(part);
  }
  return parts;
}

function textTab(design: Design, panel: HTMLElement): void {
  const short = design.blocks.length > mostText;
  const shown = short ? { ...design, blocks: design.blocks.slice(0, mostText) } : design;
  fill(
    panel,
    h(
      'p',
      {},
      copyButton('Copy the blocks', () => asText(design)),
      ' ',
      h(
        'span',
        { class: 'hint' },
        'One block a line, in order, as every verb of the program reads it.',
      ),
    ),
    h(
      'pre',
      { class: 'blocks', tabindex: 0, role: 'region', 'aria-label': 'Blocks as text' },
      inParts(asText(shown)),
    ),
    short &&
      h(
        'p',
        { class: 'hint' },
        `The first ${mostText} of ${design.blocks.length} blocks; download the design for all.`,
      ),
  );
}

function verified(asked: Asked, design: Design, frozen: boolean): string {
  if (!design.verdict) {
    return 'Not verified: open it on the page Verify.';
  }
  if (!design.verdict.valid) {
    return `Refuted: not every ${setWord(design.strength ?? 2)} is covered, or a step is wrong.`;
  }
  const when = frozen
    ? 'when this copy was written'
    : 'local' in asked
      ? 'on the page Verify'
      : 'before it was shown';
  return (
    `Verified ${when}: every step and every ${setWord(design.strength ?? 2)} was checked, by ` +
    `code that shares nothing with what made the design.`
  );
}

/** How to cite a design of the catalog, and what a paper says of it. */
function forAPaper(design: Design, frozen: boolean, signal: AbortSignal): Child[] {
  const { label } = design;
  if (!label) {
    return [];
  }
  const [button, shown] = citation(label, signal);
  return [
    h('h2', {}, 'For a paper'),
    h(
      'p',
      { class: 'buttons' },
      !frozen && [
        dossierLink({ label }, 'html', 'Write-up', true),
        ' ',
        dossierLink({ label }, 'latex', 'Write-up in LaTeX', true),
        ' ',
      ],
      button,
    ),
    shown,
  ];
}

/** Where to go from here. */
function whatNext(design: Design, frozen: boolean): HTMLElement {
  const { v, k, change, kind, strength, verdict } = design;
  const cell = { v, k, change, kind, strength: strength === 2 ? null : strength };
  return h(
    'ul',
    { class: 'next-links' },
    ...[
      { v: v - 1, k },
      { v: v + 1, k },
      { v, k: k - 1 },
      { v, k: k + 1 },
    ]
      .filter((next) => !frozen && next.k > change && next.v >= next.k)
      .slice(0, 2)
      .map((next) =>
        h(
          'li',
          {},
          h(
            'a',
            { href: link('cell', { ...cell, ...next }) },
            `The cell of v = ${next.v}, k = ${next.k}`,
          ),
        ),
      ),
    h(
      'li',
      {},
      h(
        'a',
        { href: link('catalog', { change, kind, strength: cell.strength, at: `${v}.${k}` }) },
        'Its place on the map',
      ),
    ),
    !frozen &&
      verdict?.minimum !== 'proved' &&
      h('li', {}, h('a', { href: link('search', cell) }, 'Search for one with fewer blocks')),
  );
}

export const design: Page = {
  path: 'design',
  title: 'Design',
  hidden: true,
  async render(view: View) {
    const asked = askedOf(view.params);
    if (!asked) {
      fill(
        view.root,
        h('h1', {}, 'Which design?'),
        h(
          'p',
          {},
          'Choose a cell in the ',
          h('a', { href: link('catalog') }, 'catalog'),
          ', paste a design on the page ',
          h('a', { href: link('verify') }, 'Verify'),
          ', or write a label into the address, as #/design?label=20.5.2.circular.29.17482f88.',
        ),
      );
      return;
    }
    const frozen = isCopy();
    let shown: Design;
    try {
      shown = await waiting(designOf(asked, view.signal), view.signal, () =>
        fill(view.root, h('h1', {}, 'Design'), h('p', { class: 'hint' }, 'Asking for the design…')),
      );
    } catch (fault) {
      if (view.signal.aborted) {
        return;
      }
      const cell = isCell(asked) ? asked : 'label' in asked ? cellOfLabel(asked.label) : null;
      // Where none can exist, the message says why.
      const none =
        isCell(asked) && fault instanceof ApiError && /^nothing is known/i.test(fault.message);
      fill(
        view.root,
        h('h1', {}, none ? 'No design is known' : 'No design to show'),
        none
          ? h(
              'p',
              { class: 'note', role: 'alert' },
              `No ${nameOf(asked)} is known`,
              (asked.strength ?? 2) > 2 && `, with strength ${asked.strength}`,
              '.',
            )
          : problem(
              'label' in asked && fault instanceof ApiError && fault.status === 404 && !frozen
                ? new Error(`The catalog has no design with the label ${asked.label}.`)
                : fault,
            ),
        none &&
          h(
            'p',
            { class: 'buttons' },
            h('a', { class: 'button', href: link('search', { ...asked }) }, 'Search for one'),
          ),
        cell &&
          h(
            'p',
            {},
            h(
              'a',
              { href: link('cell', { ...cell }) },
              `What is known of v = ${cell.v}, k = ${cell.k}`,
            ),
          ),
        h('p', {}, h('a', { href: link('catalog') }, 'The catalog')),
      );
      return;
    }
    const b = shown.blocks.length;
    const name = nameOf(shown);
    document.title = `(${shown.v},${shown.k},${b}) ${shown.kind} m = ${shown.change} · Changeover`;

    const chosen = new Chosen(view, shown);
    const share = h('progress', { max: 1, value: 0, 'aria-label': 'Pairs are being counted' });
    const steps = await waiting(
      Steps.soon(shown, view.signal, (done) => (share.value = done)),
      view.signal,
      () =>
        fill(
          view.root,
          h('h1', {}, name[0]!.toUpperCase() + name.slice(1)),
          h('p', {}, 'Counting pairs … ', share),
        ),
    );
    const stays = new Stays(shown);
    const sets = Sets.of(shown);
    const strength = shown.strength ?? 2;
    const counted = strength === 2 || sets !== null;
    const symmetries = b * shown.k <= mostLooked ? symmetryOf(shown) : null;
    const symmetry = shown.kind === 'circular' ? symmetries : null; // Of linear ones no circle.
    const save = (
      which: 'array' | 'stays' | 'coverage' | 'circle',
      how: () => object,
      signal: AbortSignal,
    ): HTMLElement | false => !frozen && savePicture(which, asked, shown, how, signal);
    const range = (): object => chosen.range ?? {};
    const orderOf = (which: Order): number[] =>
      which === 'given'
        ? Array.from({ length: shown.v }, (_, x) => x)
        : which === 'first'
          ? byFirst(shown.blocks, shown.v)
          : byFirst(shown.blocks, shown.v).sort((x, y) => stays.of(x).length - stays.of(y).length);

    const all: Tab[] = [
      {
        name: 'steps',
        title: 'Steps',
        draw: (panel, signal) =>
          openPlayer(panel, steps, sets, shown, {
            at: Number(view.params.get('at')) || 1,
            speed: view.params.get('speed') ?? '3',
            signal,
            chosen,
            moved: (at, speed) =>
              view.go(
                { at: at === 1 ? null : at, speed: speed === '3' ? null : speed },
                { quiet: true },
              ),
          }),
      },
      {
        name: 'array',
        title: 'Array',
        draw: (panel, signal) => {
          arrayView(steps, chosen, panel, signal);
          panel.append(h('p', {}, save('array', range, signal) || ''));
        },
      },
      {
        name: 'stays',
        title: 'Stays',
        draw: (panel, signal) => {
          let order = (view.params.get('order') ?? 'first') as Order;
          const line = timeline(
            {
              v: steps.v,
              b: steps.b,
              names: steps.names,
              pairs: counted ? (sets?.met ?? steps.pairs) : null,
              allPairs: sets?.all ?? steps.allPairs,
              sets: setsOf(strength),
              stays,
              step: 'block',
              item: 'element',
            },
            chosen,
            orderOf(order),
            signal,
          );
          const pairs = matrix(steps, sets, chosen, signal, 420);
          pairs?.order(orderOf(order));
          fill(
            panel,
            h(
              'p',
              { class: 'hint' },
              'A row for each element, a bar for each stay. Drag on the strip to choose ' +
                'blocks, drag below to pan',
              h('span', { class: 'with-wheel' }, '; Ctrl + wheel or + and − zoom'),
              sets
                ? `. A square for each pair has the colour of the block with which all ` +
                    `${setsOf(strength)} that have the pair have met.`
                : '. A square for each pair has the colour of the block in which the pair first ' +
                    'meets; pairs that first meet in the blocks in sight are lit.',
            ),
            h(
              'div',
              { class: 'row' },
              field(
                'Order of elements',
                select(order, orders, (value) => {
                  order = value as Order;
                  line.order(orderOf(order));
                  pairs?.order(orderOf(order));
                  view.go({ order: value === 'first' ? null : value }, { quiet: true });
                }),
              ),
              save('stays', () => ({ ...range(), order }), signal),
            ),
            h(
              'div',
              { class: pairs ? 'stays-and-pairs' : '' },
              line.element,
              pairs && h('div', {}, pairs.element, blockScale(steps.b, signal)),
            ),
          );
        },
      },
      {
        name: 'coverage',
        title: 'Coverage',
        draw: (panel, signal) => {
          const pairs = matrix(steps, sets, chosen, signal);
          if (!pairs) {
            fill(panel, h('p', { class: 'note' }, 'Pairs are drawn for up to 512 elements.'));
            return;
          }
          const sort = (order: string): void => pairs.order(orderOf(order as Order));
          let order = view.params.get('order') ?? 'first';
          sort(order);
          fill(
            panel,
            h(
              'div',
              { class: 'row' },
              field(
                'Order of elements',
                select(order, orders, (value) => {
                  order = value;
                  sort(order);
                  view.go({ order: value === 'first' ? null : value }, { quiet: true });
                }),
              ),
              // The program draws pairs.
              strength === 2 && save('coverage', () => ({ order }), signal),
              chosen.range &&
                h(
                  'span',
                  { class: 'hint' },
                  `Lit: pairs ${sets ? 'that are complete with' : 'that first meet in'} blocks ` +
                    `${chosen.range.from} to ${chosen.range.to}. `,
                  h(
                    'button',
                    {
                      type: 'button',
                      class: 'plain small',
                      onclick: (event) => {
                        chosen.setRange(null);
                        (event.target as HTMLElement).parentElement!.remove();
                      },
                    },
                    'Show all',
                  ),
                ),
            ),
            h(
              'div',
              { class: 'pairs-and-key' },
              pairs.element,
              matrixKey(b, pairs, sets?.t ?? 2, signal),
            ),
          );
        },
      },
      ...(symmetry && symmetry.rotations > 1
        ? [
            {
              name: 'circle',
              title: hasShortCycles(symmetry) ? 'Cycles' : 'Circle',
              draw: (panel: HTMLElement, signal: AbortSignal) => {
                circleView(symmetry, chosen, panel, signal);
                // The program draws rings.
                const drawn = !hasShortCycles(symmetry) && save('circle', () => ({}), signal);
                panel.append(h('p', {}, drawn || ''));
              },
            },
          ]
        : []),
      {
        name: 'recipe',
        title: 'Recipe',
        draw: (panel, signal) => recipeTab(asked, shown, panel, signal),
      },
      { name: 'blocks', title: 'Blocks', draw: (panel) => textTab(shown, panel) },
    ];
    const selected = h('div', { class: 'selected-words' });
    const notSelected = h('div', { role: 'alert' });
    const wantedElements = h('input', {
      type: 'text',
      id: 'select-elements',
      autocomplete: 'off',
      placeholder: shown.labels ? `${shown.labels[0]} ${shown.labels[1]}` : '3 or 3 7',
      'aria-label': 'Select an element or a pair',
    });
    const bySelf = h(
      'form',
      {
        class: 'select-form',
        onsubmit: (event) => {
          event.preventDefault();
          const wrong = chosen.chooseByName(wantedElements.value);
          wrong === ''
            ? wantedElements.removeAttribute('aria-invalid')
            : wantedElements.setAttribute('aria-invalid', 'true');
          fill(notSelected, wrong && h('p', { class: 'problem' }, wrong));
          wrong ? fill(selected) : tell();
        },
      },
      wantedElements,
      h('button', { type: 'submit', class: 'plain small' }, 'Select'),
    );
    const tell = (): void => {
      fill(notSelected);
      wantedElements.removeAttribute('aria-invalid');
      const words = chosen.words(steps, stays);
      fill(
        selected,
        words
          ? [
              h('span', { class: 'selected-key' }),
              h('span', {}, `${words}.`),
              h(
                'button',
                { type: 'button', class: 'plain small', onclick: () => chosen.choose([]) },
                'Clear',
              ),
            ]
          : h(
              'span',
              { class: 'hint' },
              'Click an element or a pair in any view, or write it here, to see it in all of them.',
            ),
      );
    };
    chosen.follow(view.signal, tell);
    tell();
    const from =
      shown.label ??
      ('local' in asked
        ? 'of this window, in no catalog'
        : 'file' in asked
          ? `file ` +
            `${(await about()).files.find((each) => each.index === asked.file)?.name ?? asked.file}`
          : 'job' in asked
            ? `found by search ${asked.job}`
            : '');
    const start = view.params.get('show') ?? 'steps';
    fill(
      view.root,
      h(
        'h1',
        {},
        `${name[0]!.toUpperCase()}${name.slice(1)}` +
          `${strength > 2 ? `, strength ${strength}` : ''}: ` +
          `${count(b, 'block')}`,
      ),
      h(
        'p',
        { class: 'under' },
        from && [shown.label === from ? h('span', { class: 'code' }, from) : from, ' · '],
        h(
          'a',
          {
            href: link('cell', {
              v: shown.v,
              k: shown.k,
              change: shown.change,
              kind: shown.kind,
              strength: shown.strength === 2 ? null : shown.strength,
            }),
          },
          'bounds, history and citation',
        ),
      ),
      chips(shown, symmetries),
      h('div', { class: 'selected' }, bySelf, notSelected, selected),
      tabs('What to show of the design', all, start, view.signal, (which) =>
        view.go({ show: which }, { quiet: true }),
      ),
      h(
        'div',
        { class: 'design-columns' },
        h(
          'div',
          {},
          h('h2', {}, 'In numbers'),
          h(
            'p',
            {
              class: `verdict ${shown.verdict ? (shown.verdict.valid ? 'valid' : 'invalid') : ''}`,
            },
            verified(asked, shown, frozen),
          ),
          scroll('The design in numbers', facts(shown, stays, symmetries, view.signal)),
        ),
        h(
          'div',
          {},
          h('h2', {}, 'Download'),
          downloads(asked, shown, frozen),
          forAPaper(shown, frozen, view.signal),
          h('h2', {}, 'What next'),
          whatNext(shown, frozen),
        ),
      ),
    );
  },
};
