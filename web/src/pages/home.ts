// The start page: three doors, one for each kind of question.
import { fill, h, svg, type Child } from '../lib/dom';
import { atlasOf, isHeld } from '../lib/source';
import { count, number, rangeWords } from '../lib/words';
import { command } from '../parts/command';
import { copyButton } from '../parts/copy';
import { about, isCopy } from '../shell/about';
import { link, type Page, type View } from '../shell/router';
import { lookUp } from './catalog/look_up';
import { paintOf } from './catalog/paint';
import { Steps } from './design/steps';
import { keptJobs } from './plan/store';

const list = (text: string): number[][] =>
  text.split(';').map((block) => block.trim().split(' ').map(Number));
/** Nine parts, four at a time: a circular DCCD(9,4). */
const tests = list('1 3 7 8;2 5 7 8;0 2 3 8;2 3 4 5;1 2 3 6;0 1 5 6;0 1 4 7;4 6 7 8');
/** Twelve items, room for four: a tight linear SCCD(12,4). */
const loads = list(
  '0 1 2 3;0 2 3 4;2 3 4 5;2 3 5 6;2 5 6 7;2 5 7 8;1 5 7 8;1 7 8 9;3 7 8 9;3 7 8 10;3 7 8 11;0 ' +
    '7 8 11;4 7 8 11;4 6 8 11;1 4 6 11;1 4 10 11;4 9 10 11;2 9 10 11;5 9 10 11;0 5 9 10;0 6 9 10',
);

/** Slots from top to bottom, tests from left to right; what was exchanged stands out. */
export function sheetPicture(): SVGElement {
  const steps = Steps.of({ v: 9, blocks: tests });
  const [w, gap, top] = [38, 4, 22];
  const marks: SVGElement[] = [];
  for (let i = 1; i <= steps.b; ++i) {
    marks.push(
      svg('text', { x: (i - 1) * (w + gap) + w / 2, y: 14, class: 'picture-faint' }, String(i)),
    );
    const { slots, entered } = steps.step(i);
    slots.forEach((part, row) => {
      const fresh = i > 1 && entered.includes(part);
      const [x, y] = [(i - 1) * (w + gap), top + row * (26 + gap)];
      marks.push(
        svg('rect', {
          x,
          y,
          width: w,
          height: 26,
          rx: 4,
          class: fresh ? 'picture-fresh' : 'picture-kept',
        }),
        svg(
          'text',
          { x: x + w / 2, y: y + 17.5, class: fresh ? 'picture-on' : 'picture-text' },
          String.fromCharCode(65 + part),
        ),
      );
    });
  }
  return svg(
    'svg',
    {
      viewBox: `0 0 ${tests.length * (w + gap) - gap} ${top + 4 * 30}`,
      role: 'img',
      'aria-label': 'Eight tests of four parts; from one to the next two parts are exchanged',
    },
    ...marks,
  );
}

/** A row for each item, a bar for each time that it is in memory. */
export function memoryPicture(): SVGElement {
  const v = 12;
  const [w, row] = [22, 11.4];
  const marks: SVGElement[] = [];
  for (let x = 0; x < v; ++x) {
    for (let from = 0; from < loads.length; ++from) {
      if (!loads[from]!.includes(x) || (from > 0 && loads[from - 1]!.includes(x))) {
        continue;
      }
      let to = from;
      while (loads[to + 1]?.includes(x)) {
        ++to;
      }
      marks.push(
        svg('rect', {
          x: from * w,
          y: x * row,
          width: (to - from + 1) * w - 2,
          height: row - 2.6,
          rx: 3,
          class: 'picture-kept strong',
        }),
        svg('rect', {
          x: from * w,
          y: x * row,
          width: 5,
          height: row - 2.6,
          rx: 2,
          class: 'picture-fresh',
        }),
      );
    }
  }
  return svg(
    'svg',
    {
      viewBox: `0 0 ${loads.length * w} ${v * row}`,
      role: 'img',
      'aria-label':
        'Twelve items, four of them in memory at a time: a bar for each time that an item is held',
    },
    ...marks,
  );
}

/** The catalog's map, small. */
function mapPicture(view: View): HTMLElement {
  const canvas = h('canvas', {
    width: 157 * 3,
    height: 38 * 5,
    role: 'img',
    'aria-label': 'Map of the catalog: dark cells are proved minima',
  });
  const draw = async (): Promise<void> => {
    if (!(await isHeld({ v: 20, k: 5, change: 2, kind: 'circular' }))) {
      return;
    }
    const atlas = await atlasOf({ change: 2, kind: 'circular', strength: 2 });
    const pen = canvas.getContext('2d');
    if (!pen || view.signal.aborted) {
      return;
    }
    const paint = paintOf(atlas, 'ratio');
    canvas.width = atlas.columns * 3;
    canvas.height = atlas.rows * 5;
    canvas.style.objectFit = atlas.rows < 19 ? 'contain' : 'fill';
    for (const cell of atlas.cells()) {
      if (cell.status !== 'impossible') {
        pen.fillStyle = paint.of(cell);
        pen.fillRect((cell.v - atlas.v.from) * 3, (cell.k - atlas.k.from) * 5, 3, 5);
      }
    }
    canvas.classList.add('drawn');
  };
  const again = (): void => void draw().catch(() => undefined);
  document.addEventListener('themechange', again, { signal: view.signal });
  again();
  return canvas;
}

function door(
  title: string,
  question: string,
  picture: Node,
  shown: { to: string; words: string },
  what: Child[],
  to: string,
  action: string,
): HTMLElement {
  return h(
    'li',
    { class: 'door' },
    h('h2', {}, title),
    h('p', { class: 'question' }, question),
    h('div', { class: 'door-picture' }, h('a', { href: shown.to, title: shown.words }, picture)),
    h('p', {}, what),
    h('p', { class: 'door-action' }, h('a', { class: 'button', href: to }, action)),
  );
}

/** What was begun in this browser; before anything was, how the command line is asked. */
function goOn(): HTMLElement {
  const begun = keptJobs().slice(0, 3);
  const lines = [
    'changeover plan parts.csv -k 4 --test-cost 10',
    'changeover loadorder --items 64 --room 16',
    'changeover design 20 5',
  ];
  return begun.length > 0
    ? h(
        'div',
        {},
        h('h2', {}, 'Go on with'),
        h(
          'ul',
          { class: 'plain-list' },
          begun.map(({ id, title, done, tests }) =>
            h(
              'li',
              {},
              h('a', { href: link('plan', { id }) }, title),
              tests > 0 ? ` ${done} of ${count(tests, 'test')} done` : '',
            ),
          ),
        ),
      )
    : h(
        'div',
        {},
        h('h2', {}, 'On the command line'),
        h(
          'ul',
          { class: 'plain-list commands' },
          lines.map((line) =>
            h(
              'li',
              {},
              h(
                'div',
                { class: 'command' },
                command(line),
                copyButton('Copy', () => line),
              ),
            ),
          ),
        ),
      );
}

export const home: Page = {
  path: 'home',
  title: 'Start',
  hidden: true,
  render(view: View) {
    const frozen = isCopy();
    const counts = h('span', {}, '\u00a0');
    fill(
      view.root,
      h(
        'div',
        { class: 'title-row' },
        h(
          'div',
          {},
          h('h1', {}, 'Every pair together, with as few changes as possible'),
          h(
            'p',
            { class: 'lead' },
            'A change covering design is a list of blocks of equal size in which every two ' +
              'elements meet and each block differs from the one before in the same number of ' +
              'elements. Use one to plan tests or to order loads, or study the designs themselves.',
          ),
        ),
        lookUp(() => ({ change: 2, kind: 'circular' })),
      ),
      h(
        'ul',
        { class: 'doors' },
        door(
          'Test parts',
          'Which set-ups, in which order?',
          sheetPicture(),
          {
            to: link('design', { v: 9, k: 4, change: 2, kind: 'linear' }),
            words: 'Nine parts, four at a time, test by test',
          },
          [
            'Parts are mounted a few at a time, and every two must be tried together. Get a ' +
              'run sheet with the fewest changes.',
          ],
          link('plan'),
          frozen ? 'How to plan tests' : 'Plan tests',
        ),
        door(
          'Load data',
          'What to read when memory is small?',
          memoryPicture(),
          {
            to: link('loadorder', { items: 12, room: 4 }),
            words: 'Twelve items, room for four, step by step',
          },
          [
            'Items lie on a disk, a few fit into memory, and every two must meet there. Get an ' +
              'order with the fewest loads.',
          ],
          link('loadorder'),
          frozen ? 'How to order loads' : 'Order loads',
        ),
        door(
          'Study designs',
          'How few blocks are possible?',
          mapPicture(view),
          { to: link('catalog'), words: 'The map of the catalog' },
          [counts, ' Each is verified, and each bound has its reason.'],
          link('catalog'),
          'Browse the catalog',
        ),
      ),
      h(
        'section',
        { class: 'home-more', 'aria-label': 'More' },
        h(
          'div',
          {},
          h('h2', {}, 'Other pages'),
          h(
            'ul',
            { class: 'plain-list' },
            h(
              'li',
              {},
              h('a', { href: link('verify') }, 'Verify'),
              ' a list of blocks of your own',
            ),
            !frozen &&
              h(
                'li',
                {},
                h('a', { href: link('search') }, 'Search'),
                ' for a design with fewer blocks',
              ),
            h(
              'li',
              {},
              h('a', { href: link('theorems') }, 'Theorems'),
              ' and constructions, with proofs',
            ),
          ),
        ),
        !frozen && goOn(),
      ),
    );
    about().then(
      ({ catalog, range }) =>
        fill(
          counts,
          range
            ? `Here are the designs with ${rangeWords(range)}.`
            : `${number(catalog.designs)} designs in ${number(catalog.cells)} cells.`,
        ),
      () => undefined,
    );
  },
};
