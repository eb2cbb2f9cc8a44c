// The table of cells: sorted and filtered by what the link says.
import type { TableCell } from '../../lib/api';
import { append, fill, h, scroll, select } from '../../lib/dom';
import { number, ratio } from '../../lib/words';
import { badge, gap, statuses } from '../../parts/status';
import { rows } from '../../parts/rows';
import { link, type View } from '../../shell/router';

interface Column {
  name: string;
  title: string;
  numeric: boolean;
  hint?: string;
  value(cell: TableCell): number | string | null;
}

const columns: readonly Column[] = [
  { name: 'v', title: 'v', numeric: true, value: (cell) => cell.v },
  { name: 'k', title: 'k', numeric: true, value: (cell) => cell.k },
  { name: 'b', title: 'blocks', numeric: true, value: (cell) => cell.b },
  { name: 'bound', title: 'bound', numeric: true, hint: 'the greatest lower bound that is proved', value: (cell) => cell.lower_bound },
  { name: 'gap', title: 'gap', numeric: true, hint: 'blocks over the lower bound', value: gap },
  { name: 'ratio', title: 'b / bound', numeric: true, value: (cell) => (cell.b !== null && cell.lower_bound ? cell.b / cell.lower_bound : null) },
  { name: 'status', title: 'status', numeric: false, value: (cell) => cell.status },
  { name: 'by', title: 'construction', numeric: false, value: (cell) => cell.construction },
];

export interface CellTable {
  readonly element: HTMLElement;
  show(cells: readonly TableCell[]): void;
}

export function compare(a: number | string | null, b: number | string | null): number {
  if (a === null || b === null) {
    return a === b ? 0 : a === null ? 1 : -1;
  }
  return typeof a === 'number' && typeof b === 'number' ? a - b : String(a) < String(b) ? -1 : a === b ? 0 : 1;
}

export function cellTable(view: View): CellTable {
  let all: readonly TableCell[] = [];
  const list = rows<TableCell>((cell) => {
    const measure = gap(cell);
    return h(
      'tr',
      {},
      h('td', { class: 'number' }, h('a', { href: link('cell', { v: cell.v, k: cell.k, change: cell.change, kind: cell.kind }), 'aria-label': `v = ${cell.v}, k = ${cell.k}` }, cell.v)),
      h('td', { class: 'number' }, cell.k),
      h('td', { class: 'number' }, cell.b === null ? '–' : number(cell.b)),
      h('td', { class: 'number' }, cell.lower_bound === null ? '–' : number(cell.lower_bound)),
      h('td', { class: 'number' }, measure ?? '–'),
      h('td', { class: 'number' }, cell.b !== null && cell.lower_bound ? ratio(cell.b, cell.lower_bound) : '–'),
      h('td', {}, badge(cell.status)),
      h('td', {}, cell.construction && h('a', { href: link('theorems', { construction: cell.construction }) }, cell.construction)),
      h('td', { class: 'label' }, cell.label ? h('a', { href: link('design', { label: cell.label }) }, cell.label) : ''),
    );
  }, view.signal);

  const summary = h('p', { class: 'hint', role: 'status' });
  const empty = h('p', { class: 'note', hidden: true }, 'No cell is like that. ', h('button', { type: 'button', class: 'plain', onclick: () => clear() }, 'Clear the filters'));
  const heads = columns.map((column) => {
    const button = h('button', { type: 'button', class: 'sort', title: column.hint ?? null, onclick: () => sortBy(column) }, column.title);
    return h('th', { scope: 'col', class: column.numeric ? 'number' : null }, button);
  });
  const constructions = h('select', { onchange: () => changed({ by: constructions.value }) });
  const status = select(view.params.get('status') ?? '', statuses, (value) => changed({ status: value }));
  const least = h('input', { type: 'number', min: 0, value: view.params.get('gap') ?? '', placeholder: '0', onchange: () => changed({ gap: least.value }) });

  function changed(changes: Record<string, string | null>): void {
    view.go(changes, { quiet: true });
    draw();
  }
  function clear(): void {
    status.value = least.value = constructions.value = '';
    changed({ status: null, gap: null, by: null });
    status.focus();
  }
  function sortBy(column: Column): void {
    const now = view.params.get('sort') ?? 'k';
    changed({ sort: now === column.name ? `-${column.name}` : column.name });
  }

  function draw(): void {
    const sort = view.params.get('sort') ?? 'k';
    const column = columns.find((each) => each.name === sort.replace(/^-/, '')) ?? columns[1]!;
    const sign = sort.startsWith('-') ? -1 : 1;
    heads.forEach((head, i) => {
      columns[i] === column ? head.setAttribute('aria-sort', sign > 0 ? 'ascending' : 'descending') : head.removeAttribute('aria-sort');
    });
    const wanted = { status: view.params.get('status'), by: view.params.get('by'), gap: Number(view.params.get('gap') ?? 0) };
    const shown = all.filter(
      (cell) => (!wanted.status || cell.status === wanted.status) && (!wanted.by || cell.construction === wanted.by) && (wanted.gap <= 0 || (gap(cell) ?? -1) >= wanted.gap),
    );
    shown.sort((a, b) => {
      const [x, y] = [column.value(a), column.value(b)];
      // What is not known comes last, whichever way.
      const order = x === null || y === null ? compare(x, y) : sign * compare(x, y);
      return order || a.k - b.k || a.v - b.v;
    });
    list.show(shown);
    fill(summary, shown.length === all.length ? `${number(all.length)} cells` : `${number(shown.length)} of ${number(all.length)} cells`);
    empty.hidden = shown.length > 0;
  }

  const field = (text: string, control: HTMLElement, id: string): HTMLElement => {
    control.id = id;
    return h('div', { class: 'field' }, h('label', { for: id }, text), control);
  };
  const element = h(
    'section',
    { 'aria-labelledby': 'cells' },
    h('h2', { id: 'cells' }, 'Cells'),
    h('div', { class: 'row' }, field('Status', status, 'filter-status'), field('Gap at least', least, 'filter-gap'), field('Construction', constructions, 'filter-by'), summary),
    empty,
    scroll('Table of cells',
      h('table', { class: 'cells' }, h('thead', {}, h('tr', {}, heads, h('th', { scope: 'col' }, 'label'))), list.body),
    ),
    list.more,
  );
  return {
    element,
    show(cells) {
      all = cells;
      const names = [...new Set(cells.map((cell) => cell.construction).filter((name): name is string => name !== null))].sort();
      const by = view.params.get('by') ?? '';
      fill(constructions);
      append(constructions, ['', ...names, ...(by && !names.includes(by) ? [by] : [])].map((name) => h('option', { value: name, selected: name === by }, name || 'any')));
      draw();
    },
  };
}
