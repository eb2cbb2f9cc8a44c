// Long tables in pieces: rows are made as the reader comes near to them.
import { h } from '../lib/dom';

/** Few enough that a frame with a piece is a short one. */
const piece = 40;

export interface Rows<T> {
  readonly body: HTMLTableSectionElement;
  /** Put behind the table: asks for more when it comes into sight. */
  readonly more: HTMLElement;
  show(items: readonly T[]): void;
}

export function rows<T>(draw: (item: T) => HTMLTableRowElement, signal: AbortSignal): Rows<T> {
  const body = h('tbody');
  const button = h('button', { type: 'button', class: 'plain', onclick: () => add() }, 'More rows');
  const more = h('p', { class: 'more', hidden: true }, button);
  let waiting: readonly T[] = [];
  let shown = 0;
  function add(): void {
    const part = document.createDocumentFragment();
    for (const item of waiting.slice(shown, shown + piece)) {
      part.append(draw(item));
    }
    shown = Math.min(waiting.length, shown + piece);
    body.append(part);
    more.hidden = shown >= waiting.length;
    button.textContent = `More rows (${shown} of ${waiting.length} shown)`;
    // Says once more whether it is in sight, in the next frame.
    watcher.unobserve(more);
    watcher.observe(more);
  }
  const watcher = new IntersectionObserver(
    (seen) => seen.some((each) => each.isIntersecting) && add(),
    { rootMargin: '1200px' },
  );
  watcher.observe(more);
  signal.addEventListener('abort', () => watcher.disconnect());
  return {
    body,
    more,
    show(items) {
      waiting = items;
      shown = 0;
      body.replaceChildren();
      add();
    },
  };
}
