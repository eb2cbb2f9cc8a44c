// A small table to type in: a row a thing, a column a field; the last row is always empty.
import { h, fill } from '../../lib/dom';

export interface Column<T> {
  key: keyof T & string;
  title: string;
  /** For screen readers, before the number of the row. */
  label: string;
  hint?: string;
  kind?: 'number' | 'wide' | 'check';
  /** A function is asked again whenever the form has changed. */
  placeholder?: string | (() => string);
  /** Of cards: shown once more is asked for, or something is in it. */
  rare?: boolean;
}

export interface Rows<T> {
  readonly element: HTMLElement;
  read(): T[];
  set(rows: readonly T[]): void;
  /** Says anew what empty fields stand for. */
  refresh(): void;
}

/** As `cards` a row is a frame with its fields side by side, as many as there is room for. */
export function rowsTable<T extends object>(
  label: string,
  columns: readonly Column<T>[],
  empty: () => T,
  changed: () => void,
  as: 'table' | 'cards' = 'table',
): Rows<T> {
  const body = h('tbody');
  const inputs = (row: Element) => [...row.querySelectorAll('input')];
  const isEmpty = (row: Element) =>
    inputs(row).every((input) =>
      input.type === 'checkbox' ? !input.checked : input.value.trim() === '',
    );

  const rareKeys = columns.flatMap(({ key, rare }) => (rare ? [key] : []));
  const usual = empty();

  function makeRow(data: T): HTMLTableRowElement {
    const whole = rareKeys.some((key) => data[key] !== usual[key]);
    const opener = h(
      'button',
      {
        type: 'button',
        class: 'plain small',
        'aria-expanded': String(whole),
        onclick: () => {
          const opened = row.classList.toggle('whole-card');
          opener.setAttribute('aria-expanded', String(opened));
          opener.textContent = opened ? 'Less' : 'More';
        },
      },
      whole ? 'Less' : 'More',
    );
    const row: HTMLTableRowElement = h(
      'tr',
      { class: whole ? 'whole-card' : null },
      columns.map(({ key, kind, title, hint, placeholder, rare }) => {
        const value = data[key];
        const input =
          kind === 'check'
            ? h('input', { type: 'checkbox', checked: Boolean(value) })
            : h('input', {
                type: 'text',
                class: kind ?? null,
                value: String(value),
                placeholder:
                  typeof placeholder === 'function' ? placeholder() : (placeholder ?? null),
                autocomplete: 'off',
                spellcheck: 'false',
              });
        return h(
          'td',
          {
            class: [kind === 'check' && 'centre', rare && 'rare'].filter(Boolean).join(' ') || null,
            'data-label': title,
            title: hint ?? null,
          },
          input,
        );
      }),
      h(
        'td',
        {},
        rareKeys.length > 0 && opener,
        rareKeys.length > 0 && ' ',
        h(
          'button',
          {
            type: 'button',
            class: 'plain small',
            'aria-label': 'Take this row off',
            onclick: () => (row.remove(), settle(), changed()),
          },
          '×',
        ),
      ),
    );
    return row;
  }

  function settle(): void {
    const last = body.rows[body.rows.length - 1];
    if (!last || !isEmpty(last)) {
      body.append(makeRow(empty()));
    }
    [...body.rows].forEach((row, i) =>
      inputs(row).forEach((input, j) =>
        input.setAttribute('aria-label', `${columns[j]!.label} ${i + 1}`),
      ),
    );
  }

  const element = h(
    'div',
    { class: 'scroll rows-frame', role: 'region', 'aria-label': label, tabindex: -1 },
    h(
      'table',
      { class: as === 'cards' ? 'rows cards' : 'rows', oninput: () => (settle(), changed()) },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          columns.map(({ title, hint }) => h('th', { title: hint ?? null }, title)),
          h('th', {}, h('span', { class: 'unseen' }, 'take off')),
        ),
      ),
      body,
    ),
  );
  return {
    element,
    read: () =>
      [...body.rows]
        .filter((row) => !isEmpty(row))
        .map(
          (row) =>
            Object.fromEntries(
              inputs(row).map((input, i) => [
                columns[i]!.key,
                input.type === 'checkbox' ? input.checked : input.value.trim(),
              ]),
            ) as T,
        ),
    set(rows) {
      fill(body, rows.map(makeRow));
      settle();
    },
    refresh() {
      for (const row of body.rows) {
        inputs(row).forEach((input, i) => {
          const { placeholder } = columns[i]!;
          if (typeof placeholder === 'function') {
            input.placeholder = placeholder();
          }
        });
      }
    },
  };
}
