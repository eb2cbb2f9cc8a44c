// The list of parts: a grid to type in, that takes what a spreadsheet copies.
import { announce, fill, h } from '../../lib/dom';
import { count } from '../../lib/words';
import { decimal, partsOf, type Part } from './job';

export interface Grid {
  readonly element: HTMLElement;
  /** @throws Error with a line that can be shown. */
  read(): Part[];
  set(parts: readonly Part[]): void;
}

/** Rows beyond these are drawn a few at a time, so that a long list does not hold up the page. */
const piece = 150;

export function partsGrid(changed: () => void): Grid {
  const body = h('tbody');
  const size = h('p', { class: 'hint', role: 'status' });
  let drawing = 0;

  function inputs(row: Element): [name: HTMLInputElement, cost: HTMLInputElement, gone: HTMLInputElement] {
    return [...row.querySelectorAll('input')] as [HTMLInputElement, HTMLInputElement, HTMLInputElement];
  }

  function renumber(): void {
    [...body.rows].forEach((row, i) => {
      row.cells[0]!.textContent = String(i + 1);
      const [name, cost, gone] = inputs(row);
      name.setAttribute('aria-label', `Name of part ${i + 1}`);
      cost.setAttribute('aria-label', `Cost of putting in part ${i + 1}`);
      gone.setAttribute('aria-label', `Part ${i + 1} is gone`);
    });
    size.textContent = `${count([...body.rows].filter((row) => inputs(row)[0].value.trim() !== '').length, 'part')}`;
  }

  function makeRow(part: Part): HTMLTableRowElement {
    const gone = h('input', {
      type: 'checkbox',
      checked: part.gone ?? false,
      onchange: () => (row.classList.toggle('gone', gone.checked), changed()),
    });
    const row: HTMLTableRowElement = h(
      'tr',
      { class: part.gone ? 'gone' : null },
      h('td', { class: 'number' }),
      h('td', {}, h('input', { type: 'text', class: 'name', value: part.name, spellcheck: 'false', autocomplete: 'off' })),
      h(
        'td',
        {},
        h('input', {
          type: 'text',
          class: 'cost',
          inputmode: 'decimal',
          value: part.cost ?? '',
          placeholder: 'as below',
          autocomplete: 'off',
        }),
      ),
      h('td', { class: 'centre' }, gone),
      h(
        'td',
        {},
        h(
          'button',
          {
            type: 'button',
            class: 'plain small',
            title: 'Take this part off the list',
            'aria-label': 'Take this part off the list',
            onclick: () => (move(row, 1) || move(row, -1), row.remove(), keepOneEmpty(), renumber(), changed()),
          },
          '×',
        ),
      ),
    );
    return row;
  }

  function keepOneEmpty(): void {
    const last = body.rows[body.rows.length - 1];
    if (!last || inputs(last)[0].value !== '' || inputs(last)[1].value !== '') {
      body.append(makeRow({ name: '', cost: null }));
      renumber();
    }
  }

  /** Moves the focus to the same column of a row above or below. */
  function move(row: Element, by: number): boolean {
    const other = by > 0 ? row.nextElementSibling : row.previousElementSibling;
    if (!other) {
      return false;
    }
    const column = Math.max(0, inputs(row).indexOf(document.activeElement as HTMLInputElement));
    inputs(other)[column]?.focus();
    return true;
  }

  function put(parts: readonly Part[], at: Element | null): void {
    const mine = ++drawing;
    let from = 0;
    const more = () => {
      if (mine !== drawing) {
        return;
      }
      const part = document.createDocumentFragment();
      parts.slice(from, from + piece).forEach((each) => part.append(makeRow(each)));
      from += piece;
      body.insertBefore(part, at);
      if (from < parts.length) {
        requestAnimationFrame(more);
      } else {
        keepOneEmpty();
        renumber();
      }
    };
    more();
  }

  const table = h(
    'table',
    {
      class: 'parts-grid',
      oninput: () => (keepOneEmpty(), changed()),
      onkeydown: (event) => {
        const { key, target } = event as KeyboardEvent;
        const row = (target as Element).closest('tbody tr');
        if (!row || target instanceof HTMLButtonElement) {
          return;
        }
        const by = key === 'ArrowDown' || key === 'Enter' ? 1 : key === 'ArrowUp' ? -1 : 0;
        if (by !== 0) {
          event.preventDefault();
          move(row, by);
        }
      },
      onpaste: (event) => {
        const text = (event as ClipboardEvent).clipboardData?.getData('text') ?? '';
        const row = (event.target as Element).closest('tbody tr');
        if (!row || !/[\t\n;]/.test(text.trim())) {
          return;
        }
        event.preventDefault();
        try {
          const pasted = partsOf(text);
          // From this row on: what is pasted goes in the place of what is there.
          let at: Element | null = row;
          for (let i = 0; i < pasted.length && at; ++i) {
            const next: Element | null = at.nextElementSibling;
            at.remove();
            at = next;
          }
          put(pasted, at);
          announce(`${count(pasted.length, 'part')} pasted`);
          size.textContent += `, ${pasted.length} pasted`;
          changed();
        } catch (fault) {
          size.textContent = (fault as Error).message;
        }
      },
    },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { class: 'number' }, '#'),
        h('th', {}, 'part'),
        h('th', {}, 'cost of putting it in'),
        h('th', {}, 'gone'),
        h('th', {}, h('span', { class: 'unseen' }, 'take off')),
      ),
    ),
    body,
  );
  const element = h('div', {}, h('div', { class: 'scroll parts-frame', tabindex: -1 }, table), size);

  return {
    element,
    read() {
      return [...body.rows].flatMap((row) => {
        const [name, cost, gone] = inputs(row);
        const text = name.value.trim();
        if (text === '' && cost.value.trim() === '') {
          return [];
        }
        return [
          {
            name: text,
            cost: cost.value.trim() === '' ? null : decimal(cost.value, text || `part ${row.cells[0]!.textContent}`),
            ...(gone.checked ? { gone: true } : {}),
          },
        ];
      });
    },
    set(parts) {
      fill(body);
      put(parts, null);
    },
  };
}
