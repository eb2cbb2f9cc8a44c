// The glossary: one list, a click away on every page.
import { fill, h } from '../lib/dom';
import { mathText } from '../lib/mathematics';
import { glossary } from '../lib/terms';

let dialog: HTMLDialogElement | null = null;

function made(): HTMLDialogElement {
  const list = h('dl', { class: 'facts' });
  const find = h('input', {
    type: 'search',
    id: 'glossary-find',
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
        ? shown
            .map(([term, meaning]) => [
              h('dt', {}, h('dfn', {}, term)),
              h('dd', {}, mathText(meaning)),
            ])
            .flat()
        : [h('dt', {}, 'Nothing found')],
    );
  }
  const close = h(
    'button',
    { type: 'button', class: 'plain', onclick: () => dialog?.close() },
    'Close',
  );
  const element = h(
    'dialog',
    { class: 'glossary', 'aria-labelledby': 'glossary-title' },
    h(
      'div',
      { class: 'dialog-head' },
      h('h2', { id: 'glossary-title' }, 'Glossary'),
      h('div', { class: 'field' }, h('label', { for: find.id }, 'Find a term'), find),
      close,
    ),
    h(
      'div',
      { class: 'dialog-body scroll', tabindex: 0, role: 'region', 'aria-label': 'Terms' },
      list,
    ),
  );
  element.addEventListener('click', (event) => event.target === element && element.close());
  show();
  document.body.append(element);
  return element;
}

export function openGlossary(): void {
  dialog ??= made();
  dialog.showModal();
}
