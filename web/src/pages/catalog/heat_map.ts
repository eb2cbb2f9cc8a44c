// The server's picture of a table, made a thing to walk through: pointer, finger or arrow keys choose a cell.
import type { TableCell } from '../../lib/api';
import { fill, h, picture } from '../../lib/dom';

export interface HeatMap {
  readonly element: HTMLElement;
  /** Puts a picture in the place of the one that is shown. */
  show(svg: string): void;
  /** Marks a cell, without moving the focus. */
  mark(v: number, k: number): void;
}

const steps: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

/** `say` names a cell in words; `chosen` is called when a cell is pointed at or focused, `open` when it is clicked or entered. */
export function heatMap(say: (v: number, k: number) => string, chosen: (v: number, k: number) => void, open: (v: number, k: number) => void): HeatMap {
  const element = h('div', { class: 'heat-map scroll picture', role: 'group', 'aria-label': 'Heat map of the table. Arrow keys move through its cells, Enter opens one.', tabindex: -1 }, h('p', { class: 'hint' }, 'Asking for the table…'));
  let cells = new Map<string, SVGElement>();
  let current: SVGElement | null = null;
  let down = 1;
  const ring = document.createElementNS('http://www.w3.org/2000/svg', 'g');
  ring.setAttribute('class', 'ring');
  ring.append(document.createElementNS(ring.namespaceURI, 'rect'), document.createElementNS(ring.namespaceURI, 'rect'));

  const place = (rect: Element): [number, number] => [Number(rect.getAttribute('data-v')), Number(rect.getAttribute('data-k'))];
  const cellAt = (target: EventTarget | null): SVGElement | null => (target instanceof Element ? target.closest<SVGElement>('.cell') : null);

  function choose(rect: SVGElement, focus: boolean): void {
    if (current && current !== rect) {
      current.classList.remove('chosen');
      current.setAttribute('tabindex', '-1');
    }
    current = rect;
    const [v, k] = place(rect);
    rect.classList.add('chosen');
    rect.setAttribute('tabindex', '0');
    rect.setAttribute('role', 'link');
    rect.setAttribute('aria-label', say(v, k));
    for (const side of ['x', 'y', 'width', 'height']) {
      for (const line of ring.children) {
        line.setAttribute(side, rect.getAttribute(side) ?? '0');
      }
    }
    rect.parentNode?.appendChild(ring);
    if (focus) {
      rect.focus();
    }
  }

  element.addEventListener('pointerover', (event) => {
    const rect = cellAt(event.target);
    if (rect && event.pointerType === 'mouse') {
      chosen(...place(rect));
    }
  });
  element.addEventListener('focusin', (event) => {
    const rect = cellAt(event.target);
    if (rect) {
      chosen(...place(rect));
    }
  });
  element.addEventListener('click', (event) => {
    const rect = cellAt(event.target);
    if (!rect) {
      return;
    }
    // A finger cannot point: its first tap chooses, the second opens.
    const finger = (event as PointerEvent).pointerType === 'touch' && rect !== current;
    choose(rect, true);
    chosen(...place(rect));
    if (!finger) {
      open(...place(rect));
    }
  });
  element.addEventListener('keydown', (event) => {
    const rect = cellAt(event.target);
    if (!rect) {
      return;
    }
    const [v, k] = place(rect);
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      open(v, k);
      return;
    }
    const step = steps[event.key];
    let next: SVGElement | undefined;
    if (step) {
      next = neighbour(v, k, step[0], step[1] * down);
    } else if (event.key === 'Home' || event.key === 'End') {
      const row = [...cells.values()].filter((each) => place(each)[1] === k).sort((a, b) => place(a)[0] - place(b)[0]);
      next = event.key === 'Home' ? row[0] : row.at(-1);
    } else {
      return;
    }
    event.preventDefault();
    if (next) {
      choose(next, true);
    }
  });

  /** The next cell in that direction; over a few that are missing, too. */
  function neighbour(v: number, k: number, dv: number, dk: number): SVGElement | undefined {
    for (let i = 1; i <= 8; ++i) {
      const found = cells.get(`${v + dv * i}.${k + dk * i}`);
      if (found) {
        return found;
      }
    }
    return undefined;
  }

  return {
    element,
    show(svg) {
      const drawn = picture(svg);
      drawn.setAttribute('role', 'group');
      const width = drawn.viewBox.baseVal.width || Number(drawn.getAttribute('width'));
      drawn.style.setProperty('--width', `${width}px`);
      cells = new Map();
      for (const rect of drawn.querySelectorAll<SVGElement>('.cell')) {
        const [v, k] = place(rect);
        cells.set(`${v}.${k}`, rect);
      }
      // Rows go down with k or up, as the picture has them: the arrow keys follow what is seen.
      const rects = [...cells.values()];
      const byK = [...rects].sort((a, b) => place(a)[1] - place(b)[1]);
      down = Number(byK[0]?.getAttribute('y')) > Number(byK.at(-1)?.getAttribute('y')) ? -1 : 1;
      const old = current ? place(current) : null;
      const focused = current !== null && document.activeElement === current;
      current = null;
      fill(element, drawn);
      const again = old ? cells.get(`${old[0]}.${old[1]}`) : undefined;
      const first = again ?? rects[0];
      if (first) {
        choose(first, focused);
        if (!again) {
          ring.remove();
        }
      }
    },
    mark(v, k) {
      const rect = cells.get(`${v}.${k}`);
      if (rect && rect !== current) {
        choose(rect, false);
      }
    },
  };
}

export function sayCell(cell: TableCell): string {
  const known = cell.b === null ? cell.status : `${cell.b} blocks, ${cell.status === 'minimum' ? 'minimum' : `lower bound ${cell.lower_bound ?? 'unknown'}`}`;
  return `v ${cell.v}, k ${cell.k}: ${known}`;
}
