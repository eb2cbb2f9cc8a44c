// A long list of which only the rows in sight exist.
//
// Rows are equally high, unless their texts may be longer than a line. The list scrolls in its own
// frame, which takes the focus: arrow keys,
// Page Up and Down, Home and End scroll it as any browser does. Screen readers are told each row's
// number and how many there are.
import { fill, h } from '../lib/dom';

export interface VirtualList {
  readonly element: HTMLElement;
  /** Brings row i into the middle of the frame, or to its top. */
  goTo(i: number, place?: 'middle' | 'top'): void;
  /** Redraws the visible rows after their content has changed. */
  refresh(): void;
}

interface Options {
  label: string;
  rows: number;
  /** Of a row, in CSS pixels: as the style of `.virtual .line` makes it. */
  height?: number;
  /** How many letters row i has: what is longer than the frame is wide goes on in further lines. */
  letters?(i: number): number;
  row(i: number): HTMLElement;
}

/**
 * Browsers lose elements higher than some 10 million pixels; longer lists are scrolled in
 * proportion.
 */
const highest = 8_000_000;

/** Of a letter, at most, and of what stands before the text. */
export const letterWidth = 9.5;
const before = 76;
/** Of each further line. */
const lineHeight = 24;

export function virtualList({ label, rows, height = 28, letters, row }: Options): VirtualList {
  const body = h('div', { class: 'virtual-rows' });
  const space = h('div', { class: 'virtual-space', role: 'list', 'aria-label': label }, body);
  const element = h(
    'div',
    { class: 'virtual', tabindex: 0, role: 'group', 'aria-label': label },
    space,
  );
  /** Where each row begins, and the last one ends. */
  let starts: (i: number) => number = (i) => i * height;
  let real = rows * height;
  let total = 0;
  let wide = -1;
  let drawn = '';

  function measure(): void {
    if (letters) {
      const fit = Math.max(8, Math.floor((element.clientWidth - before) / letterWidth));
      const places = new Float64Array(rows + 1);
      for (let i = 0; i < rows; ++i) {
        const lines = Math.max(1, Math.ceil(letters(i) / fit));
        places[i + 1] = places[i]! + height + (lines - 1) * lineHeight;
      }
      starts = (i) => places[i]!;
      real = places[rows]!;
      drawn = '';
    }
    total = Math.min(real, highest);
    space.style.height = `${total}px`;
  }
  /** The row at a place. */
  function rowAt(place: number): number {
    let low = 0;
    let high = rows;
    while (low < high) {
      const middle = (low + high) >> 1;
      starts(middle + 1) <= place ? (low = middle + 1) : (high = middle);
    }
    return low;
  }

  function draw(): void {
    if (element.clientWidth !== wide) {
      wide = element.clientWidth;
      measure();
    }
    const seen = element.clientHeight || 400;
    const travel = Math.max(1, total - seen);
    const realTravel = Math.max(0, real - seen);
    const top = total < real ? (element.scrollTop / travel) * realTravel : element.scrollTop;
    const from = Math.max(0, rowAt(top) - 5);
    const to = Math.min(rows, rowAt(top + seen) + 6);
    if (drawn !== `${from} ${to}`) {
      drawn = `${from} ${to}`;
      const lines = [];
      for (let i = from; i < to; ++i) {
        const line = row(i);
        line.classList.add('line');
        line.setAttribute('role', 'listitem');
        line.setAttribute('aria-posinset', String(i + 1));
        line.setAttribute('aria-setsize', String(rows));
        if (starts(i + 1) - starts(i) > height) {
          line.classList.add('long');
          line.style.height = `${starts(i + 1) - starts(i)}px`;
        }
        lines.push(line);
      }
      fill(body, lines);
    }
    body.style.transform = `translateY(${starts(from) - top + element.scrollTop}px)`;
  }

  element.addEventListener('scroll', () => requestAnimationFrame(draw), { passive: true });
  new ResizeObserver(draw).observe(element);
  measure();
  requestAnimationFrame(draw);
  return {
    element,
    goTo(i, place = 'middle') {
      const seen = element.clientHeight || 400;
      const wanted =
        place === 'top' ? starts(i) : Math.max(0, (starts(i) + starts(i + 1) - seen) / 2);
      const realTravel = Math.max(1, real - seen);
      element.scrollTop = total < real ? (wanted / realTravel) * (total - seen) : wanted;
      draw();
    },
    refresh() {
      drawn = '';
      draw();
    },
  };
}
