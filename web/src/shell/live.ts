// Pages that need the program itself. In a static copy they say what they answer, the command that
// answers the same, and how to get it.
import { fill, h, type Child } from '../lib/dom';
import { memoryPicture, sheetPicture } from '../pages/home';
import { toCopy } from '../parts/command';
import { isCopy } from './about';
import { link, type Page } from './router';

interface Elsewhere {
  /** The heading of the page, if it is not its name. */
  readonly title?: string;
  /** What the page is for, in a sentence. */
  readonly what: string;
  /** What comes of it. */
  readonly picture?: () => Node;
  /** What does the same without pages. */
  readonly command: (asked: URLSearchParams) => string;
  /** What is said of it. */
  readonly more?: Child[];
}

/** The options of a search that an address has. */
function searching(asked: URLSearchParams): string {
  const [v, k] = [asked.get('v') ?? '20', asked.get('k') ?? '5'].map((n) => Number(n));
  const change = Number(asked.get('change') ?? 2);
  const strength = Number(asked.get('strength') ?? 2);
  return [
    `changeover search ${v} ${k}`,
    asked.get('kind') === 'linear' ? '--linear' : '--circular',
    change === 2 ? '' : `--change ${change}`,
    strength === 2 ? '' : `--strength ${strength}`,
    '--time 1m',
  ]
    .filter(Boolean)
    .join(' ');
}

const parts = 'name,cost\npump A,5\npump B,5\nvalve,2\nfilter,1\nheater,3\nsensor,1';

const elsewhere: Record<string, Elsewhere> = {
  plan: {
    title: 'Plan tests',
    what:
      'A set-up holds some of your parts, and every two parts must be tested together. The ' +
      'program lists the set-ups in the order that costs least.',
    picture: sheetPicture,
    command: () => 'changeover plan parts.csv -k 3 --test-cost 10 --format html -o sheet.html',
    more: [
      h('p', {}, 'parts.csv has a line for each part, and what it costs to put it in:'),
      h('pre', { class: 'elsewhere' }, parts),
    ],
  },
  loadorder: {
    what:
      'Items lie on a disk, a few fit into memory, and every two must meet there. The program ' +
      'orders the loads so that there are as few as possible.',
    picture: memoryPicture,
    command: () => 'changeover loadorder --items 64 --room 16',
  },
  search: {
    title: 'Search for designs',
    what:
      'A search looks for a design with fewer blocks than are known, or proves that there is ' +
      'none.',
    command: searching,
  },
};

export function whereThereIsAServer(page: Page): Page {
  return {
    ...page,
    render(view) {
      if (!isCopy()) {
        return page.render(view);
      }
      const there = elsewhere[page.path];
      fill(
        view.root,
        h('h1', {}, there?.title ?? page.title),
        there && h('p', { class: 'lead' }, there.what),
        there?.picture && h('div', { class: 'door-picture elsewhere' }, there.picture()),
        h(
          'p',
          { class: 'note' },
          'These pages are a copy for reading, and this one needs the program. ',
          h('a', { href: link('get') }, 'Get the program'),
          ', and ',
          h('code', {}, 'changeover serve --open'),
          ' shows this page at work.',
        ),
        there && [
          h('h2', {}, 'On the command line'),
          toCopy(there.command(view.params)),
          ...(there.more ?? []),
        ],
        h(
          'p',
          {},
          'Here are the ',
          h('a', { href: link('catalog') }, 'catalog'),
          ' of designs and the ',
          h('a', { href: link('theorems') }, 'theorems'),
          '.',
        ),
      );
    },
  };
}
