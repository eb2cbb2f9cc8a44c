// The array as the field prints it: blocks as columns, an element keeps its row as long as it
// stays, a star marks what is introduced.
import { fill, h, scroll } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { field } from '../../lib/dom';
import type { Chosen } from './selection';
import type { Steps } from './steps';

/** So many blocks at once: more are slow to draw and to look through. */
function pageOf(k: number): number {
  return Math.max(10, Math.min(60, Math.floor(1600 / k)));
}

export function arrayView(
  steps: Steps,
  chosen: Chosen,
  panel: HTMLElement,
  signal: AbortSignal,
): void {
  const { b, k, names } = steps;
  const most = pageOf(k);
  let page = Math.min(b, most);
  let from = chosen.range?.from ?? 1;
  const start = h('input', {
    type: 'number',
    min: 1,
    max: b,
    value: from,
    onchange: () => go(Number(start.value) || 1),
  });
  const earlier = h(
    'button',
    { type: 'button', class: 'plain', onclick: () => go(from - page) },
    '← earlier',
  );
  const later = h(
    'button',
    { type: 'button', class: 'plain', onclick: () => go(from + page) },
    'later →',
  );
  const atOnce = h('span', { class: 'hint' });
  const paging = h(
    'div',
    { class: 'row' },
    field(`From block, of ${number(b)}`, start),
    h('div', { class: 'row tight' }, earlier, later),
    atOnce,
  );
  const body = h('div', {
    onclick: (event) => {
      const cell = (event.target as Element).closest<HTMLElement>('[data-x]');
      if (cell) {
        chosen.toggle(Number(cell.dataset['x']));
      }
    },
    onkeydown: (event) => {
      const cell = (event.target as Element).closest<HTMLElement>('[data-x]');
      if (cell && ['Enter', ' '].includes((event as KeyboardEvent).key)) {
        event.preventDefault();
        chosen.toggle(Number(cell.dataset['x']));
      }
    },
  });

  function go(to: number): void {
    from = Math.round(to);
    draw();
  }
  let drawnAt = 0;
  /** So many columns stand side by side: nothing scrolls sideways. */
  let fit = 4;
  const width = Math.max(34, 8 * (Math.max(...names.map((name) => name.length)) + 1) + 14);
  function draw(): void {
    drawnAt = panel.clientWidth;
    fit = Math.max(4, Math.floor(((drawnAt || 320) - 2) / (width + 2)));
    // Whole rows, and all blocks where these are few.
    const bandsOfPage = Math.max(1, Math.min(drawnAt < 500 ? 3 : 4, Math.floor(most / fit)));
    page = b <= 4 * fit && b <= 2 * most ? b : Math.min(b, fit * bandsOfPage);
    from = Math.max(1, Math.min(b - page + 1, from));
    start.value = String(from);
    earlier.disabled = from === 1;
    later.disabled = from + page > b;
    paging.hidden = b <= page;
    fill(atOnce, `${count(page, 'block')} at a time`);
    const columns = Array.from({ length: page }, (_, i) => steps.step(from + i));
    const lit = chosen.elements;
    const starred = columns.map(
      (column) =>
        new Set(
          column.number === 1 && chosen.design.kind === 'circular' ? fresh(1) : column.entered,
        ),
    );
    const bands = Array.from({ length: Math.ceil(columns.length / fit) }, (_, i) =>
      columns.slice(i * fit, (i + 1) * fit),
    );
    fill(
      body,
      bands.map((band, n) => {
        const shown = table(band, starred.slice(n * fit), lit);
        shown.style.width = `${band.length * (width + 2) + 2}px`;
        return shown;
      }),
    );
  }

  function table(
    columns: readonly ReturnType<Steps['step']>[],
    starred: readonly ReadonlySet<number>[],
    lit: readonly number[],
  ): HTMLElement {
    return h(
      'table',
      { class: 'array-table' },
      h(
        'caption',
        { class: 'unseen' },
        `Blocks ${columns[0]!.number} to ${columns.at(-1)!.number}`,
      ),
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          columns.map((column) =>
            h(
              'th',
              { scope: 'col' },
              h('span', { class: 'block-index' }, 'B', h('sub', {}, column.number)),
            ),
          ),
        ),
      ),
      h(
        'tbody',
        {},
        Array.from({ length: k }, (_, row) =>
          h(
            'tr',
            {},
            columns.map((column, i) => {
              const x = column.slots[row]!;
              const star = starred[i]!.has(x);
              const words = [
                star ? 'fresh' : '',
                lit.includes(x) ? 'lit' : '',
                lit.length === 2 &&
                lit.every((each) => column.slots.includes(each)) &&
                lit.includes(x)
                  ? 'met'
                  : '',
              ]
                .filter(Boolean)
                .join(' ');
              return h(
                'td',
                { class: words || null, 'data-x': x },
                names[x],
                star && h('sup', {}, '*'),
              );
            }),
          ),
        ),
      ),
    );
  }
  /** Of the first block of a circular design: what the last one does not have. */
  function fresh(n: number): number[] {
    const before = new Set(steps.block(n === 1 ? b : n - 1));
    return [...steps.block(n)].filter((x) => !before.has(x));
  }
  chosen.follow(signal, draw);
  fill(
    panel,
    h(
      'p',
      { class: 'hint' },
      'A column for each block, as the field prints them. An element keeps its row as long as ' +
        'it stays; a star marks what is introduced. Click an element to see it everywhere.',
    ),
    paging,
    scroll('Array of blocks', body),
  );
  draw();
  const sizes = new ResizeObserver(() => {
    if (panel.clientWidth !== drawnAt) {
      draw();
    }
  });
  sizes.observe(panel);
  signal.addEventListener('abort', () => sizes.disconnect());
}
