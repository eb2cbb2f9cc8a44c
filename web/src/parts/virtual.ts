// A long list of which only the rows in sight exist.
//
// Rows are equally high. The list scrolls in its own frame, which takes the focus: arrow keys,
// Page Up and Down, Home and End scroll it as any browser does. Screen readers are told each row's
// number and how many there are.
import { fill, h } from '../lib/dom';

export interface VirtualList {
  readonly element: HTMLElement;
  /** Brings row i into the middle of the frame. */
  goTo(i: number): void;
  /** Redraws the visible rows after their content has changed. */
  refresh(): void;
}

interface Options {
  label: string;
  rows: number;
  /** Of a row, in CSS pixels: as the style of `.virtual .line` makes it. */
  height?: number;
  row(i: number): HTMLElement;
}

/**
 * Browsers lose elements higher than some 10 million pixels; longer lists are scrolled in
 * proportion.
 */
const highest = 8_000_000;

export function virtualList({ label, rows, height = 28, row }: Options): VirtualList {
  const body = h('div', { class: 'virtual-rows' });
  const space = h('div', { class: 'virtual-space', role: 'list', 'aria-label': label }, body);
  const element = h(
    'div',
    { class: 'virtual', tabindex: 0, role: 'group', 'aria-label': label },
    space,
  );
  const total = Math.min(rows * height, highest);
  space.style.height = `${total}px`;
  let drawn = '';

  function draw(): void {
    const seen = element.clientHeight || 400;
    const travel = Math.max(1, total - seen);
    const realTravel = Math.max(0, rows * height - seen);
    const top =
      total < rows * height ? (element.scrollTop / travel) * realTravel : element.scrollTop;
    const from = Math.max(0, Math.floor(top / height) - 5);
    const to = Math.min(rows, Math.ceil((top + seen) / height) + 5);
    if (drawn !== `${from} ${to}`) {
      drawn = `${from} ${to}`;
      const lines = [];
      for (let i = from; i < to; ++i) {
        const line = row(i);
        line.classList.add('line');
        line.setAttribute('role', 'listitem');
        line.setAttribute('aria-posinset', String(i + 1));
        line.setAttribute('aria-setsize', String(rows));
        lines.push(line);
      }
      fill(body, lines);
    }
    body.style.transform = `translateY(${from * height - top + element.scrollTop}px)`;
  }

  element.addEventListener('scroll', () => requestAnimationFrame(draw), { passive: true });
  new ResizeObserver(draw).observe(element);
  requestAnimationFrame(draw);
  return {
    element,
    goTo(i) {
      const seen = element.clientHeight || 400;
      const wanted = Math.max(0, (i + 0.5) * height - seen / 2);
      const realTravel = Math.max(1, rows * height - seen);
      element.scrollTop = total < rows * height ? (wanted / realTravel) * (total - seen) : wanted;
      draw();
    },
    refresh() {
      drawn = '';
      draw();
    },
  };
}
