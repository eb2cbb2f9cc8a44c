// The list of parts: a grid to type in, that takes what a spreadsheet copies.
import { announce, fill, h } from '../../lib/dom';
import { count } from '../../lib/words';
import { decimal, partOf, type Part } from './job';

export interface Grid {
  readonly element: HTMLElement;
  /** @throws Error with a line that can be shown. */
  read(): Part[];
  set(parts: readonly Part[]): void;
  names(): string[];
}

/** What is said of a field where its column has no head. */
const labels: Record<string, string> = { cost: 'cost', slot: 'slot', quantity: 'how many' };
/** Rows beyond these are drawn a few at a time, so that a long list does not hold up the page. */
const piece = 150;

/**
 * `pasted` reads what a spreadsheet copies; null: it could not be read, which was said.
 * `changedSlots` hears which slots the parts are of.
 */
export function partsGrid(
  changed: () => void,
  pasted: (text: string) => Promise<Part[] | null>,
  changedSlots: (slots: string[]) => void,
): Grid {
  const body = h('tbody');
  const size = h('p', { class: 'hint', role: 'status' });
  let drawing = 0;

  type Inputs = [
    name: HTMLInputElement,
    cost: HTMLInputElement,
    slot: HTMLInputElement,
    quantity: HTMLInputElement,
    gone: HTMLInputElement,
  ];
  const inputs = (row: Element) => [...row.querySelectorAll('input')] as Inputs;

  function renumber(): void {
    [...body.rows].forEach((row, i) => {
      row.cells[0]!.textContent = String(i + 1);
      const [name, cost, slot, quantity, gone] = inputs(row);
      name.setAttribute('aria-label', `Name of part ${i + 1}`);
      cost.setAttribute('aria-label', `Cost of putting in part ${i + 1}`);
      slot.setAttribute('aria-label', `Slot of part ${i + 1}`);
      quantity.setAttribute('aria-label', `How many there are of part ${i + 1}`);
      gone.setAttribute('aria-label', `Part ${i + 1} is gone`);
    });
    const named = [...body.rows].filter((row) => inputs(row)[0].value.trim() !== '');
    size.textContent = count(named.length, 'part');
    sayQuantities();
    changedSlots(
      [...new Set(named.map((row) => inputs(row)[2].value.trim()))].filter((slot) => slot !== ''),
    );
  }

  /** Once it is said of one part how many there are, there is one of each other. */
  function sayQuantities(): void {
    const all = [...body.rows].map((row) => inputs(row)[3]);
    const usual = all.some(({ value }) => value.trim() !== '') ? '1' : 'any';
    all.forEach((input) => (input.placeholder = usual));
  }

  function makeRow(part: Part): HTMLTableRowElement {
    const gone = h('input', {
      type: 'checkbox',
      checked: part.gone,
      onchange: () => (row.classList.toggle('gone', gone.checked), changed()),
    });
    const text = (kind: string, value: string | number | null, more: Record<string, string> = {}) =>
      h(
        'td',
        { class: `of-${kind}`, 'data-label': labels[kind] ?? null },
        h('input', {
          type: 'text',
          class: kind,
          value: value ?? '',
          autocomplete: 'off',
          spellcheck: 'false',
          ...more,
        }),
      );
    const row: HTMLTableRowElement = h(
      'tr',
      { class: part.gone ? 'gone' : null },
      h('td', { class: 'number' }),
      text('name', part.name, { placeholder: 'name' }),
      text('cost', part.cost, { inputmode: 'decimal', placeholder: 'usual' }),
      text('slot', part.slot, { list: 'slot-names' }),
      text('quantity', part.quantity, { inputmode: 'numeric', placeholder: 'any' }),
      h('td', { class: 'of-gone', 'data-label': 'gone' }, gone),
      h(
        'td',
        { class: 'of-off' },
        h(
          'button',
          {
            type: 'button',
            class: 'plain small',
            title: 'Take this part off the list',
            'aria-label': 'Take this part off the list',
            onclick: () => (
              move(row, 1) || move(row, -1),
              row.remove(),
              keepOneEmpty(),
              renumber(),
              changed()
            ),
          },
          '×',
        ),
      ),
    );
    return row;
  }

  function keepOneEmpty(): void {
    const last = body.rows[body.rows.length - 1];
    if (!last || inputs(last).some(({ type, value }) => type === 'text' && value !== '')) {
      body.append(makeRow(partOf('')));
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
      oninput: () => (keepOneEmpty(), sayQuantities(), changed()),
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
        void pasted(text).then((parts) => {
          if (!parts) {
            return;
          }
          // From this row on: what is pasted goes in the place of what is there.
          let at: Element | null = row;
          for (let i = 0; i < parts.length && at; ++i) {
            const next: Element | null = at.nextElementSibling;
            at.remove();
            at = next;
          }
          put(parts, at);
          announce(`${count(parts.length, 'part')} pasted`);
          size.textContent += `, ${parts.length} pasted`;
          changed();
        });
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
        h('th', { class: 'of-cost', title: 'Of putting it in' }, 'cost'),
        h('th', { class: 'of-slot' }, 'slot'),
        h(
          'th',
          { class: 'of-quantity', title: 'How many there are. All empty: enough for every bench' },
          'how many',
        ),
        h('th', {}, 'gone'),
        h('th', {}, h('span', { class: 'unseen' }, 'take off')),
      ),
    ),
    body,
  );
  table.addEventListener('change', renumber);
  const element = h(
    'div',
    {},
    h('div', { class: 'scroll parts-frame', tabindex: -1 }, table),
    size,
  );

  return {
    element,
    read() {
      return [...body.rows].flatMap((row) => {
        const [name, cost, slot, quantity, gone] = inputs(row);
        const text = name.value.trim();
        if ([name, cost, slot, quantity].every((input) => input.value.trim() === '')) {
          return [];
        }
        const what = text || `part ${row.cells[0]!.textContent}`;
        const many = quantity.value.trim();
        if (many !== '' && !/^[1-9]\d{0,5}$/.test(many)) {
          throw new Error(
            `${what}: “${many}” is not how many there are: write a whole number from 1`,
          );
        }
        return [
          {
            name: text,
            cost: cost.value.trim() === '' ? null : decimal(cost.value, what),
            slot: slot.value.trim(),
            quantity: many === '' ? null : Number(many),
            gone: gone.checked,
          },
        ];
      });
    },
    set(parts) {
      fill(body);
      put(parts, null);
    },
    names: () =>
      [...body.rows].map((row) => inputs(row)[0].value.trim()).filter((name) => name !== ''),
  };
}
