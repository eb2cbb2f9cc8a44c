// The glossary as a page: `#/glossary?term=tight` is the address of a term.
import { fill, h } from '../lib/dom';
import { termAt, termOf } from '../lib/terms';
import { termList } from '../shell/glossary';
import { link, type Page, type View } from '../shell/router';

/** Five blocks, circular, each with what enters; the terms are told of them. */
const rows: readonly (readonly [stays: string, enters: string, covers: string])[] = [
  ['a b', 'c', 'a c, b c'],
  ['b c', 'd', 'b d, c d'],
  ['c d', 'e', 'c e, d e'],
  ['d e', 'a', 'a d, a e'],
  ['a e', 'b', 'a b, b e'],
];

function example(): HTMLElement {
  const term = (words: string, of: string): HTMLElement =>
    h('a', { href: link('glossary', { term: termAt(of) }) }, words);
  return h(
    'section',
    { class: 'glossary-example' },
    h('h2', {}, 'The words at work'),
    h(
      'p',
      {},
      'Elements a, b, c, d, e; five blocks of three; each step changes one element, and the first ' +
        'block follows the last: a circular SCCD(5, 3).',
    ),
    h(
      'table',
      {},
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          ['block', 'unchanged', 'introduced', 'newly covered'].map((name) =>
            h('th', { scope: 'col' }, name),
          ),
        ),
      ),
      h(
        'tbody',
        {},
        rows.map(([stays, enters, covers], i) =>
          h(
            'tr',
            {},
            h('th', { scope: 'row' }, `B${i + 1}`),
            h('td', {}, stays),
            h('td', {}, h('strong', {}, enters)),
            h('td', {}, covers),
          ),
        ),
      ),
    ),
    h(
      'ul',
      {},
      h(
        'li',
        {},
        'c is ',
        term('introduced', 'introduced'),
        ' in B1 and is ',
        term('leaving', 'leaving'),
        ' in B3: its only ',
        term('stay', 'stay'),
        ' is B1 to B3.',
      ),
      h('li', {}, 'B1 and B2 have the ', term('unchanged subset', 'unchanged subset'), ' b c.'),
      h(
        'li',
        {},
        'Each of the 10 pairs is ',
        term('newly covered', 'newly covered'),
        ' exactly once, so the ',
        term('excess', 'excess'),
        ' is 0 and the design is ',
        term('tight', 'tight'),
        '.',
      ),
      h(
        'li',
        {},
        'Each step newly covers 2 pairs, so no design has fewer than 10 / 2 = 5 blocks: the ',
        term('lower bound', 'lower bound'),
        ' is 5, and this design is ',
        term('minimum', 'minimum'),
        '.',
      ),
      h(
        'li',
        {},
        'Read as a linear design that ends with B5 it is not tight: in B1 all three pairs are ' +
          'newly covered, so a b is newly covered twice, in B1 and B5: the excess is 1.',
      ),
    ),
    h(
      'p',
      {},
      h('a', { href: link('design', { v: 5, k: 3, change: 1, kind: 'circular' }) }, 'Its pictures'),
    ),
  );
}

export const glossary: Page = {
  path: 'glossary',
  title: 'Glossary',
  hidden: true,
  render(view: View) {
    const asked = view.params.get('term');
    const chosen = asked === null ? null : termOf(asked);
    const { find, list } = termList('glossary-page-find', chosen);
    fill(
      view.root,
      h('h1', {}, 'Glossary'),
      asked !== null &&
        chosen === null &&
        h('p', { class: 'note', role: 'alert' }, `There is no term “${asked}” here.`),
      h(
        'p',
        {},
        'The words that the program, its pages and its documentation use, in the order in which ' +
          'a newcomer meets them. The sign # beside a term is a link to it.',
      ),
      h('div', { class: 'glossary-columns' }, h('div', {}, find, list), example()),
    );
    const marked = list.querySelector<HTMLElement>('dt.chosen');
    marked?.scrollIntoView({ block: 'center', behavior: 'instant' });
    marked?.focus({ preventScroll: true });
  },
};
