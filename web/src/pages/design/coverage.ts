// Which pairs have met: a square for each pair of elements, drawn on a canvas.
import { h } from '../../lib/dom';
import type { Steps } from './steps';

export interface Coverage {
  readonly element: HTMLElement;
  /** Shows what has met after `n` blocks; the pairs of block n stand out. */
  show(n: number): void;
  /** What is known of the pair at a place of the map, in words; empty on the diagonal. */
  pairAt(event: MouseEvent): string;
  /** Takes the colours of the theme anew. */
  recolour(): void;
}

function colours(): Record<'ground' | 'met' | 'anew' | 'line', string> {
  const style = getComputedStyle(document.documentElement);
  const token = (name: string): string => style.getPropertyValue(name).trim();
  return { ground: token('--sunken'), met: token('--met'), anew: token('--leave'), line: token('--ground') };
}

/** Null if there are too many elements to tell their pairs apart. */
export function coverage(steps: Steps): Coverage | null {
  const { first, v } = steps;
  if (!first) {
    return null;
  }
  const side = Math.max(1, Math.min(32, Math.floor(512 / v)));
  const canvas = h('canvas', { width: v * side, height: v * side, class: 'coverage-map', role: 'img' });
  const pen = canvas.getContext('2d')!;
  let paint = colours();
  let shown = -1;

  function square(x: number, y: number, colour: string): void {
    pen.fillStyle = colour;
    const gap = side >= 5 ? 1 : 0;
    pen.fillRect(x * side, y * side, side - gap, side - gap);
  }

  function all(n: number): void {
    pen.fillStyle = paint.line;
    pen.fillRect(0, 0, canvas.width, canvas.height);
    for (let x = 0; x < v; ++x) {
      for (let y = 0; y < v; ++y) {
        const met = first![x * v + y]!;
        square(x, y, x === y ? paint.line : met === 0 || met > n ? paint.ground : met === n ? paint.anew : paint.met);
      }
    }
  }

  /** Only the pairs of block n change their colour. */
  function block(n: number, colour: (met: number) => string | null): void {
    const elements = steps.block(n);
    for (const x of elements) {
      for (const y of elements) {
        const to = x === y ? null : colour(first![x * v + y]!);
        if (to) {
          square(x, y, to);
        }
      }
    }
  }

  return {
    element: canvas,
    show(n) {
      if (n === shown + 1 && shown > 0) {
        block(shown, (met) => (met === shown ? paint.met : null));
        block(n, (met) => (met === n ? paint.anew : null));
      } else if (n !== shown) {
        all(n);
      }
      shown = n;
      canvas.setAttribute('aria-label', `Map of pairs: ${steps.pairs![n]} of ${steps.allPairs} have met after block ${n}`);
    },
    pairAt(event) {
      const box = canvas.getBoundingClientRect();
      const x = Math.floor(((event.clientX - box.left) / box.width) * v);
      const y = Math.floor(((event.clientY - box.top) / box.height) * v);
      if (x === y || x < 0 || y < 0 || x >= v || y >= v) {
        return '';
      }
      const met = first[x * v + y]!;
      return `${steps.names[y]} and ${steps.names[x]}: ${met === 0 ? 'never together' : `first together in block ${met}`}`;
    },
    recolour() {
      paint = colours();
      if (shown > 0) {
        all(shown);
      }
    },
  };
}
