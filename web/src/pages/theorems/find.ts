// One field that finds theorems, constructions and works by their words.
import { fill, h } from '../../lib/dom';
import { count } from '../../lib/words';

/** Parts of one kind, each with the text that is looked through. */
export interface Shelf {
  /** "theorem": what one of them is called. */
  noun: string;
  texts: readonly string[];
  show(i: number, shows: boolean): void;
  /** Called with how many are left. */
  left(some: number): void;
  /** The way to the first of them that is left. */
  go(): void;
}

export interface Find {
  input: HTMLInputElement;
  element: HTMLElement;
}

/** @param changed called when other parts are shown, with what was written */
export function findField(
  value: string,
  shelves: readonly Shelf[],
  changed: (words: string) => void,
): Find {
  const said = h('p', { class: 'hint find-says', role: 'status' });
  const input = h('input', {
    type: 'search',
    id: 'find',
    value,
    autocomplete: 'off',
    spellcheck: 'false',
    placeholder: 'tight, benches, Bean',
    oninput: () => {
      sift();
      changed(input.value.trim());
    },
  });
  function sift(): void {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    const found = shelves.map(({ texts, show, left }) => {
      const hits = texts.map((text) => words.every((word) => text.toLowerCase().includes(word)));
      hits.forEach((shows, i) => show(i, shows));
      const some = hits.filter(Boolean).length;
      left(some);
      return some;
    });
    const all = found.reduce((sum, some) => sum + some, 0);
    if (words.length === 0) {
      fill(said);
    } else if (all === 0) {
      fill(said, 'Nothing here says that. Try fewer words.');
    } else {
      fill(
        said,
        shelves
          .map(({ noun, go }, i) => ({ noun, go, some: found[i]! }))
          .filter(({ some }) => some > 0)
          .flatMap(({ noun, go, some }, i) => [
            i > 0 && ', ',
            h('button', { type: 'button', class: 'link', onclick: go }, count(some, noun)),
          ]),
      );
    }
  }
  sift();
  return {
    input,
    element: h(
      'div',
      { class: 'find', role: 'search' },
      h('div', { class: 'field' }, h('label', { for: input.id }, 'Find'), input),
      said,
    ),
  };
}
