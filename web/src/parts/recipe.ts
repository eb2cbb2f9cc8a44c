// How a design is made: the tree of constructions, each with what it does, and who found it.
import type { TreeNode } from '../lib/api';
import { scholarly, work } from '../lib/citations';
import { h, type Child } from '../lib/dom';
import { mathText } from '../lib/mathematics';
import { termsOf } from '../lib/terms';
import { changeWord, count, number } from '../lib/words';
import { link } from '../shell/router';
import { badge } from './status';

/** "circular DCCD(61,4)" */
export function shortName(cell: { v: number; k: number; change: number; kind: string }): string {
  const family =
    cell.change === 1 ? 'SCCD' : cell.change === 2 ? 'DCCD' : `${cell.change}-change design `;
  return `${cell.kind} ${family}(${cell.v},${cell.k})`;
}

/**
 * Plain text with mathematics as the program writes it (`2*n_j >= 3k`), with theorems and works as
 * links.
 */
export function reason(text: string): Child[] {
  return scholarly(text, (theorem) => link('theorems', { theorem }));
}

/**
 * What the signs mean that the program uses and does not define in its reasons; null if it used
 * none.
 */
export function defined(text: string, strength = 2): HTMLElement | null {
  const terms = termsOf(strength);
  const used = [terms.introductions, terms.occurrences, terms.surplus].filter((meaning) =>
    text.includes(meaning.slice(0, 3)),
  );
  return used.length === 0
    ? null
    : h('p', { class: 'hint defined' }, mathText(`Here ${used.join('; ')}.`));
}

/** A citation without its brackets. */
export function citation(text: string): Child[] {
  // What is said of a theorem of ours behind the place in the work has its own link.
  const key =
    /^\[([A-Za-z]+\d{4}[a-z]?)((?:, [^\]]*?)??)((?:, [^,\]]*docs\/theorems[^\]]*)?)\]$/.exec(text);
  return key
    ? [work(key[1]!, key[2]), ...reason(key[3]!)]
    : reason(text.startsWith('[') ? text.replace(/^\[|\]$/g, '') : text);
}

const isOurs = (text: string): boolean => /^\[docs\/theorems\.md, /.test(text);

/** How a tree is told. */
interface Telling {
  /** Of the design, and of those that it is made of. */
  strength?: number | undefined;
  /** What the elements of the design are called, if not 0, 1, 2, …: base blocks are of these. */
  labels?: readonly string[] | undefined;
  /** Who found it, and how, stands elsewhere on the page. */
  withoutOrigin?: boolean;
}

/** What a design is made by, without its origin if that is told elsewhere and more follows it. */
export function told(explanation: string, { labels, withoutOrigin }: Telling = {}): string {
  const text = withoutOrigin
    ? explanation.replace(/^Written down in the catalog as .*?; \d{4}-\d\d-\d\d\.(?: (?=\S)|$)/, '')
    : explanation;
  if (!labels) {
    return text;
  }
  return text
    .replace(/Develop the base blocks? .*? over \d+ copies of/g, (all) =>
      all.replace(
        /\{(\d+(?:,\d+)*)\}/g,
        (_, numbers: string) =>
          `{${numbers
            .split(',')
            .map((x) => labels[Number(x)] ?? x)
            .join(', ')}}`,
      ),
    )
    .replace(/: \d+j \+ i is i of copy j, written i_j/, ': i_j is i of copy j')
    .replace(/; \d+ is fixed, written ∞/, '')
    .replace(/ and a fixed element/, ' and a fixed element ∞');
}

/** So many base blocks stand in a sentence; of longer lists so many are shown at first. */
const inSentence = 4;
const atFirst = 3;

/** "Develop the base blocks …" with each block in one piece, and a long list folded. */
function explained(text: string): Child[] {
  const found = /^(.*?Develop the base blocks? )((?:\{[^}]*\}(?:, )?)+)( .*)$/s.exec(text);
  const blocks = found?.[2]!.match(/\{[^}]*\}/g) ?? [];
  if (!found || blocks.length <= inSentence) {
    return reason(text);
  }
  const item = (block: string): HTMLElement => h('li', {}, reason(block));
  const list = h('ul', { class: 'base-blocks' }, blocks.slice(0, atFirst).map(item));
  const rest = h('li', {}, '');
  const all = h(
    'button',
    {
      type: 'button',
      class: 'plain small',
      onclick: () => {
        rest.remove();
        list.append(...blocks.slice(atFirst).map(item));
        list.tabIndex = -1;
        list.focus({ preventScroll: true });
      },
    },
    `${number(blocks.length - atFirst)} more`,
  );
  rest.append(all);
  list.append(rest);
  return [...reason(found[1]!), list, ...reason(found[3]!.trimStart())];
}

function node(tree: TreeNode, telling: Telling, depth: number): HTMLElement {
  const { strength = 2 } = telling;
  // Names are those of the whole design.
  const explanation = told(
    tree.explanation,
    depth === 0 ? telling : { ...telling, labels: undefined },
  );
  const text = h(
    'div',
    { class: 'recipe-node' },
    h(
      'p',
      {},
      h(
        'a',
        {
          href: link('cell', {
            v: tree.v,
            k: tree.k,
            change: tree.change,
            kind: tree.kind,
            strength: strength === 2 ? null : strength,
          }),
        },
        shortName(tree),
        strength > 2 && `, t\u00a0=\u00a0${strength}`,
      ),
      tree.verdict?.valid !== false && `, ${count(tree.b, 'block')} `,
      tree.verdict?.tight && h('span', { class: 'badge good' }, 'tight'),
      tree.verdict?.minimum === 'proved' && [' ', badge('minimum')],
    ),
    h(
      'div',
      { class: 'recipe-words' },
      'by ',
      h(
        'a',
        { href: link('theorems', { construction: tree.construction }) },
        h('strong', {}, tree.construction),
      ),
      ...(explanation === '' ? [', as History says'] : [': ', ...explained(explanation)]),
    ),
    tree.citation &&
      !/^\[(elementary|src\/.*)\]$/.test(tree.citation) &&
      // A theorem of ours is named as the picture of the recipe names it.
      h('p', { class: 'hint' }, isOurs(tree.citation) && 'Changeover, ', citation(tree.citation)),
  );
  if (tree.inputs.length === 0) {
    return h('li', {}, text);
  }
  return h(
    'li',
    {},
    text,
    h(
      'details',
      { open: depth < 6 },
      h(
        'summary',
        {},
        tree.inputs.length === 1 ? 'from one design' : `from ${number(tree.inputs.length)} designs`,
      ),
      h(
        'ul',
        {},
        tree.inputs.map((each) => node(each, telling, depth + 1)),
      ),
    ),
  );
}

export function recipeTree(tree: TreeNode, telling: Telling = {}): HTMLElement {
  return h(
    'ul',
    {
      class: 'recipe',
      'aria-label': `How the ${tree.kind} ${changeWord(tree.change)} design is made`,
    },
    node(tree, telling, 0),
  );
}
