// Terms of the glossary where they stand in a text: their sentence on hover, focus or a tap, and the
// glossary, opened at them, on a press.
import { fill, h } from '../lib/dom';
import { mathText } from '../lib/mathematics';
import { glossary, termAt } from '../lib/terms';
import { openGlossary } from '../shell/glossary';
import { link } from '../shell/router';

/** Words of texts, as patterns, and the terms that they are. */
const words: readonly (readonly [pattern: string, term: string])[] = [
  ['unchanged subsets?', 'unchanged subset'],
  ['expansion sets?', 'expansion set'],
  ['base blocks?', 'base block'],
  ['newly covered', 'newly covered'],
  ['lower bound', 'lower bound'],
  ['best known', 'best known'],
  ['automorphisms?', 'automorphism, group'],
  ['tight', 'tight'],
  ['economical', 'economical'],
  ['excess', 'excess'],
  ['introduced', 'introduced'],
  // The noun: parts stay mounted, too.
  ['(?<=\\b(?:the|a|its|their|of|maximal|two|three) )stays?', 'stay'],
  ['recipe', 'recipe'],
];
const meanings = new Map(glossary);
const pattern = new RegExp(`\\b(?:${words.map(([each]) => `(${each})`).join('|')})\\b`, 'i');
const left = '.badge, a, button, code, math, .math, h1, h2, h3, summary, label, svg';

let tip: HTMLElement | null = null;
let shownFor: HTMLElement | null = null;

function hide(): void {
  tip?.remove();
  shownFor = null;
}
// The page that was left stays in sight until the next one has something to show.
window.addEventListener('hashchange', hide);

function show(anchor: HTMLElement, meaning: string): void {
  tip ??= h('div', { class: 'knowl', role: 'tooltip', id: 'knowl' });
  fill(tip, mathText(meaning));
  document.body.append(tip);
  shownFor = anchor;
  const { left: x, bottom, top } = anchor.getBoundingClientRect();
  const { offsetWidth, offsetHeight } = tip;
  const room = document.documentElement.clientWidth - offsetWidth - 8;
  tip.style.left = `${window.scrollX + Math.max(8, Math.min(x, room))}px`;
  const below = bottom + offsetHeight + 8 < window.innerHeight;
  tip.style.top = `${window.scrollY + (below ? bottom + 4 : top - offsetHeight - 4)}px`;
}

function termLink(text: string, term: string): HTMLElement {
  const meaning = meanings.get(term)!;
  let first = false;
  const anchor: HTMLElement = h(
    'a',
    {
      class: 'term',
      href: link('glossary', { term: termAt(term) }),
      'aria-description': meaning,
      onmouseenter: () => show(anchor, meaning),
      onmouseleave: hide,
      onfocus: () => show(anchor, meaning),
      onblur: hide,
      // A finger has no hover: the first tap says what it means, the second opens the glossary.
      onpointerdown: (event) => {
        first = (event as PointerEvent).pointerType === 'touch' && shownFor !== anchor;
        if (first) {
          show(anchor, meaning);
        }
      },
      onpointercancel: () => (first = false), // It became a scroll.
      // Its place in the glossary is shown over the page; as a link it opens another window.
      onclick: (event) => {
        const { ctrlKey, metaKey, shiftKey } = event as MouseEvent;
        if (ctrlKey || metaKey || shiftKey) {
          return;
        }
        event.preventDefault();
        if (!first) {
          hide();
          openGlossary(term);
        }
        first = false;
      },
      onkeydown: (event) => (event as KeyboardEvent).key === 'Escape' && hide(),
    },
    text,
  );
  return anchor;
}

/** What facts are called, and the terms that they are. */
const named: Readonly<Record<string, string>> = {
  'lower bound': 'lower bound',
  tight: 'tight',
  economical: 'economical',
  excess: 'excess',
  stays: 'stay',
  'unchanged subsets': 'unchanged subset',
  group: 'automorphism, group',
};

/** The name of a fact: as a term of the glossary if it is one, else with what it means. */
export function factName(name: string, meaning: string): HTMLElement {
  const term = named[name];
  return h(
    'dfn',
    { title: term === undefined ? meaning : null },
    term === undefined ? name : termLink(name, term),
  );
}

/** Links the first place of each term below `root`. */
export function linkTerms(root: Element): void {
  const known = new Set<string>();
  const walker = document.createTreeWalker(root, NodeFilter.SHOW_TEXT);
  const texts: Text[] = [];
  while (walker.nextNode()) {
    const text = walker.currentNode as Text;
    if (!text.parentElement?.closest(left)) {
      texts.push(text);
    }
  }
  for (const text of texts) {
    let rest: Text = text;
    for (let from = 0; ;) {
      const found = pattern.exec(rest.data.slice(from));
      if (!found) {
        break;
      }
      const term = words[found.slice(1).findIndex((each) => each !== undefined)]![1];
      const at = from + found.index;
      if (known.has(term)) {
        from = at + found[0].length;
        continue;
      }
      known.add(term);
      const word = rest.splitText(at);
      rest = word.splitText(found[0].length);
      word.replaceWith(termLink(found[0], term));
      from = 0;
    }
  }
}
