// The glossary: one list, a click away on every page, with an address for each term.
import { fill, h, type Child } from '../lib/dom';
import { mathText } from '../lib/mathematics';
import { glossary, seeAlso, termAt } from '../lib/terms';
import { link } from './router';

/**
 * The terms, and a field that finds some of them. `chosen`: one that is marked; `left` is called
 * when a term's address is followed.
 */
export function termList(
  id: string,
  chosen: string | null,
  left: () => void = () => undefined,
): { find: HTMLElement; list: HTMLElement } {
  const list = h('dl', { class: 'facts terms' });
  const find = h('input', {
    type: 'search',
    id,
    placeholder: 'tight, bound, load …',
    autocomplete: 'off',
    oninput: () => show(),
  });
  function show(): void {
    const words = find.value.toLowerCase().trim();
    const shown = glossary.filter(([term, meaning]) =>
      `${term} ${meaning}`.toLowerCase().includes(words),
    );
    fill(
      list,
      shown.length > 0
        ? shown.flatMap(([term, meaning]): Child[] => {
            const mark = term === chosen ? { class: 'chosen', tabindex: -1 } : {};
            const to = link('glossary', { term: termAt(term) });
            const also = seeAlso[term] ?? [];
            return [
              h(
                'dt',
                mark,
                h('dfn', {}, mathText(term)),
                h(
                  'a',
                  { class: 'term-link', href: to, onclick: left, 'aria-label': `Link to ${term}` },
                  '#',
                ),
              ),
              h(
                'dd',
                term === chosen ? { class: 'chosen' } : {},
                mathText(meaning),
                also.length > 0 && [
                  h('span', { class: 'see-also' }, '. See also '),
                  ...also.flatMap((each, i): Child[] => [
                    i > 0 && ', ',
                    h('a', { href: link('glossary', { term: termAt(each) }), onclick: left }, each),
                  ]),
                ],
              ),
            ];
          })
        : [h('dt', {}, 'Nothing found')],
    );
  }
  show();
  return {
    find: h('div', { class: 'field' }, h('label', { for: find.id }, 'Find a term'), find),
    list,
  };
}

let dialog: HTMLDialogElement | null = null;

function made(chosen: string | null): HTMLDialogElement {
  const { find, list } = termList('glossary-find', chosen, () => dialog?.close());
  const close = h(
    'button',
    { type: 'button', class: 'plain', onclick: () => dialog?.close() },
    'Close',
  );
  const element = h(
    'dialog',
    { class: 'glossary', 'aria-labelledby': 'glossary-title' },
    h('div', { class: 'dialog-head' }, h('h2', { id: 'glossary-title' }, 'Glossary'), find, close),
    h(
      'div',
      { class: 'dialog-body scroll', tabindex: 0, role: 'region', 'aria-label': 'Terms' },
      list,
    ),
  );
  element.addEventListener('click', (event) => event.target === element && element.close());
  document.body.append(element);
  return element;
}

/** Over the page, which stays where it is read. `term`: the one that is asked for. */
export function openGlossary(term: string | null = null): void {
  dialog?.remove();
  dialog = made(term);
  dialog.showModal();
  const marked = dialog.querySelector<HTMLElement>('dt.chosen');
  marked?.scrollIntoView({ block: 'center' });
  marked?.focus({ preventScroll: true });
}
