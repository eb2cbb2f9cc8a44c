// The table of cells: sorted as the link says.
import type { AtlasCell } from '../../lib/atlas';
import { h, scroll } from '../../lib/dom';
import { constructions } from '../../lib/source';
import { number, ratio } from '../../lib/words';
import { badge } from '../../parts/status';
import { rows } from '../../parts/rows';
import { link, type View } from '../../shell/router';

interface Column {
  name: string;
  title: string;
  numeric: boolean;
  hint?: string;
  value(cell: AtlasCell): number | string | null;
}

const columns: readonly Column[] = [
  { name: 'v', title: 'v', numeric: true, value: (cell) => cell.v },
  { name: 'k', title: 'k', numeric: true, value: (cell) => cell.k },
  { name: 'b', title: 'blocks', numeric: true, value: (cell) => cell.b },
  {
    name: 'bound',
    title: 'bound',
    numeric: true,
    hint: 'the greatest proved lower bound',
    value: (cell) => cell.lower,
  },
  {
    name: 'gap',
    title: 'gap',
    numeric: true,
    hint: 'blocks over the lower bound',
    value: (cell) => cell.gap,
  },
  {
    name: 'ratio',
    title: 'b / bound',
    numeric: true,
    value: (cell) => (cell.b !== null && cell.lower ? cell.b / cell.lower : null),
  },
  { name: 'status', title: 'status', numeric: false, value: (cell) => cell.status },
  {
    name: 'group',
    title: 'group',
    numeric: true,
    hint: 'order of the automorphism group',
    value: (cell) => (cell.order === null ? null : Number(cell.order)),
  },
  { name: 'by', title: 'construction', numeric: false, value: (cell) => cell.construction },
];

export interface CellTable {
  readonly element: HTMLElement;
  /** Without those whose parameters cannot be. */
  show(cells: readonly AtlasCell[], withGroups: boolean): void;
}

export function compare(a: number | string | null, b: number | string | null): number {
  if (a === null || b === null) {
    return a === b ? 0 : a === null ? 1 : -1;
  }
  return typeof a === 'number' && typeof b === 'number'
    ? a - b
    : String(a) < String(b)
      ? -1
      : a === b
        ? 0
        : 1;
}

/** "24", or "10^12" for what is too long. */
function shortOrder(order: string): string {
  return order.length <= 9 ? number(Number(order)) : `≈ 10^${order.length - 1}`;
}

export function cellTable(view: View): CellTable {
  let all: readonly AtlasCell[] = [];
  const summaries = new Map<string, string>();
  constructions(view.signal).then(
    (known) => {
      known.forEach(({ name, summary }) => summaries.set(name, summary));
      all.length > 0 && draw();
    },
    () => undefined, // The names are links.
  );
  const list = rows<AtlasCell>((cell) => {
    const to = {
      v: cell.v,
      k: cell.k,
      change: cell.change,
      kind: cell.kind,
      strength: cell.strength === 2 ? null : cell.strength,
    };
    return h(
      'tr',
      {},
      h(
        'td',
        { class: 'number' },
        h('a', { href: link('cell', to), 'aria-label': `v = ${cell.v}, k = ${cell.k}` }, cell.v),
      ),
      h('td', { class: 'number' }, cell.k),
      h('td', { class: 'number' }, cell.b === null ? '–' : number(cell.b)),
      h('td', { class: 'number' }, cell.lower === null ? '–' : number(cell.lower)),
      h('td', { class: 'number' }, cell.gap ?? '–'),
      h('td', { class: 'number' }, cell.b !== null && cell.lower ? ratio(cell.b, cell.lower) : '–'),
      h(
        'td',
        {},
        badge(cell.status),
        cell.tight && [' ', h('span', { class: 'badge good' }, 'tight')],
      ),
      h('td', { class: 'number group' }, cell.order === null ? '' : shortOrder(cell.order)),
      h(
        'td',
        {},
        cell.construction &&
          h(
            'a',
            {
              href: link('theorems', { construction: cell.construction }),
              title: summaries.get(cell.construction) ?? null,
            },
            cell.construction,
          ),
      ),
      h(
        'td',
        { class: 'label' },
        cell.label
          ? h('a', { href: link('design', { label: cell.label }) }, cell.label)
          : cell.b !== null && h('a', { href: link('design', to) }, 'made when asked for'),
      ),
    );
  }, view.signal);
  const heads = columns.map((column) =>
    h(
      'th',
      { scope: 'col', class: [column.numeric ? 'number' : '', column.name].join(' ').trim() },
      h(
        'button',
        {
          type: 'button',
          class: 'sort',
          title: column.hint ?? null,
          onclick: () => sortBy(column),
        },
        column.title,
      ),
    ),
  );

  function sortBy(column: Column): void {
    const now = view.params.get('sort') ?? 'k';
    view.go({ sort: now === column.name ? `-${column.name}` : column.name }, { quiet: true });
    draw();
  }

  function draw(): void {
    const sort = view.params.get('sort') ?? 'k';
    const column = columns.find((each) => each.name === sort.replace(/^-/, '')) ?? columns[1]!;
    const sign = sort.startsWith('-') ? -1 : 1;
    heads.forEach((head, i) => {
      columns[i] === column
        ? head.setAttribute('aria-sort', sign > 0 ? 'ascending' : 'descending')
        : head.removeAttribute('aria-sort');
    });
    const shown = [...all].sort((a, b) => {
      const [x, y] = [column.value(a), column.value(b)];
      // What is not known comes last, whichever way.
      const order = x === null || y === null ? compare(x, y) : sign * compare(x, y);
      return order || a.k - b.k || a.v - b.v;
    });
    list.show(shown);
  }

  const table = h(
    'table',
    { class: 'cells' },
    h('caption', { class: 'unseen' }, 'The cells that the map shows and the filters leave'),
    h('thead', {}, h('tr', {}, heads, h('th', { scope: 'col' }, 'label'))),
    list.body,
  );
  return {
    element: h('div', {}, scroll('Table of cells', table), list.more),
    show(cells, withGroups) {
      all = cells;
      table.classList.toggle('with-groups', withGroups);
      draw();
    },
  };
}
