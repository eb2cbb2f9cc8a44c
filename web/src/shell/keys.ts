// The keys of the page that is open, in a window: "?" shows it, and so does a button.
import { fill, h } from '../lib/dom';

type Row = readonly [keys: string, what: string];
/** Keys, and where they work. */
type Group = readonly [where: string, rows: readonly Row[]];

const drawn: readonly Row[] = [
  ['+ −', 'zoom'],
  ['0', 'show all'],
];
const stays: Group = [
  'In the picture of stays, once it has the focus',
  [
    ['← → or A D', 'earlier, later'],
    ['W S', 'zoom'],
    ...drawn,
    ['↑ ↓', 'to another row'],
    ['Enter', 'choose the row'],
    ['Esc', 'choose none'],
  ],
];

const everywhere: Group = [
  'On every page',
  [
    ['?', 'these keys'],
    ['Tab, Shift Tab', 'to the next or previous link, field or picture'],
    ['Esc', 'close a window'],
  ],
];

const ofPages: Readonly<Record<string, readonly Group[]>> = {
  catalog: [
    [
      'On the map, once it has the focus',
      [
        ['← → ↑ ↓', 'to the next cell'],
        ['Home, End', 'to the first or last cell of the row'],
        ['Enter', 'open the cell'],
        ...drawn,
      ],
    ],
  ],
  cell: [
    [
      'On this page',
      [
        ['← →', 'one element less or more'],
        ['↑ ↓', 'block size smaller or larger by 1'],
      ],
    ],
  ],
  design: [
    [
      'On this page',
      [
        ['← →', 'the block before or after'],
        ['Home, End', 'the first or last block'],
        ['Space', 'play or stop'],
      ],
    ],
    [
      'On the names of the pictures',
      [
        ['← →', 'another picture'],
        ['Home, End', 'the first or last picture'],
      ],
    ],
    stays,
    [
      'In the picture of coverage, once it has the focus',
      [['← → ↑ ↓', 'to another pair'], ...drawn, ['Esc', 'choose none']],
    ],
  ],
  loadorder: [
    stays,
    ['In the list of steps', [['↑ ↓ Page Up, Page Down, Home, End', 'scroll the list']]],
  ],
  plan: [
    [
      'In the list of parts',
      [
        ['↑ ↓', 'the same field of another row'],
        ['Enter', 'the next row'],
      ],
    ],
    ['In the run sheet', [['↑ ↓', 'the same field of another test']]],
  ],
  verify: [
    ['In the field of the list', [['Ctrl Enter', 'check it']]],
    ['In the list of blocks', [['↑ ↓ Page Up, Page Down, Home, End', 'scroll the list']]],
  ],
};

const groupsOf = (path: string): readonly Group[] => [...(ofPages[path] ?? []), everywhere];

let dialog: HTMLDialogElement | null = null;

function made(): HTMLDialogElement {
  const element = h('dialog', { class: 'glossary keys', 'aria-labelledby': 'keys-title' });
  element.addEventListener('click', (event) => event.target === element && element.close());
  document.body.append(element);
  return element;
}

export function openKeys(path: string): void {
  const window = (dialog ??= made());
  fill(
    window,
    h(
      'div',
      { class: 'dialog-head' },
      h('h2', { id: 'keys-title' }, 'Keys of this page'),
      h('button', { type: 'button', class: 'plain', onclick: () => window.close() }, 'Close'),
    ),
    h(
      'div',
      { class: 'dialog-body' },
      groupsOf(path).flatMap(([where, rows]) => [
        h('h3', {}, where),
        h(
          'dl',
          { class: 'facts' },
          rows.map(([keys, what]) => [h('dt', {}, h('kbd', {}, keys)), h('dd', {}, what)]).flat(),
        ),
      ]),
    ),
  );
  window.showModal();
}

/** "?" opens the window, unless it is written into a field. */
export function followQuestionMark(path: () => string): void {
  document.addEventListener('keydown', (event) => {
    const writes =
      event.target instanceof Element && event.target.closest('input, select, textarea') !== null;
    if (event.key === '?' && !writes && !document.querySelector('dialog[open]')) {
      event.preventDefault();
      openKeys(path());
    }
  });
}
