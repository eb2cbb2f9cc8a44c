// Which pairs have met: a square for each pair of elements, drawn on a canvas.
import { pixelOf, token } from '../../lib/canvas';
import { fill, h } from '../../lib/dom';
import { setsOf } from '../../lib/words';
import type { Sets } from './sets';
import type { Steps } from './steps';

export interface Coverage {
  readonly element: HTMLElement;
  /** Shows what has met after `n` blocks; the pairs of block n stand out. */
  show(n: number): void;
  /** What is known of the pair at a place of the map, in words; empty on the diagonal. */
  pairAt(event: MouseEvent): string;
  /** The pair at a place; null on the diagonal. */
  elementsAt(event: MouseEvent): [number, number] | null;
  /** Shows what is chosen. */
  light(elements: readonly number[]): void;
  /** Reads the colours of the theme again. */
  recolour(): void;
}

function colours(): Record<'ground' | 'met' | 'anew' | 'line' | 'mark', string> {
  return {
    ground: token('--sunken'),
    met: token('--met'),
    anew: token('--leave'),
    line: token('--ground'),
    mark: token('--mark'),
  };
}

/** Part of the way from one pixel to another. */
function mixed(from: number, to: number, share: number): number {
  let pixel = 0xff;
  for (const bits of [16, 8, 0]) {
    const [a, z] = [(from >>> bits) & 0xff, (to >>> bits) & 0xff];
    pixel = (pixel << 8) | Math.round(a + (z - a) * share);
  }
  return pixel >>> 0;
}

/**
 * Null if there are too many elements to tell their pairs apart. `sets`: what must meet, where it
 * is more than pairs; a square is then as dark as the share of the sets with this pair that have
 * met.
 */
export function coverage(steps: Steps, sets: Sets | null = null): Coverage | null {
  const { first, v } = steps;
  if (!first) {
    return null;
  }
  const side = Math.max(1, Math.min(32, Math.floor(512 / v)));
  const gap = side >= 5 ? 1 : 0;
  const canvas = h('canvas', {
    width: v * side,
    height: v * side,
    class: 'coverage-map',
    role: 'img',
  });
  const over = h('canvas', {
    width: v * side,
    height: v * side,
    class: 'coverage-over',
    'aria-hidden': 'true',
  });
  const both = h('div', { class: 'coverage-both' }, canvas, over);
  const rail = (way: string): HTMLElement =>
    h('div', { class: `coverage-names ${way}`, 'aria-hidden': 'true' });
  const [across, down] = [rail('across'), rail('down')];
  const frame = h('div', { class: 'coverage-frame' }, across, down, both);
  const short = (x: number): string => steps.names[x]!.slice(0, 5);
  const letters = Math.max(...steps.names.map((_, x) => short(x).length));
  frame.style.setProperty('--letters', String(letters));
  const apart = Math.max(1, Math.ceil((7 * letters + 5) / side));
  const pen = canvas.getContext('2d')!;
  let lit: readonly number[] = [];
  let paint = colours();
  let shown = -1;

  function square(x: number, y: number, colour: string): void {
    pen.fillStyle = colour;
    pen.fillRect(x * side, y * side, side - gap, side - gap);
  }

  /** A pixel a pair, which is enlarged: a square each would take longer than a frame may. */
  const small = h('canvas', { width: v, height: v });
  function all(n: number): void {
    const top = small.getContext('2d')!;
    const image = top.createImageData(v, v);
    const pixels = new Uint32Array(image.data.buffer);
    const [line, ground, anew, before] = [paint.line, paint.ground, paint.anew, paint.met].map(
      pixelOf,
    ) as [number, number, number, number];
    if (sets) {
      const [now, then] = [sets.metByPair(n), sets.metByPair(n - 1)];
      now.forEach((met, i) => {
        pixels[i] = met > then[i]! ? anew : mixed(ground, before, met / sets.withPair);
      });
    } else {
      first!.forEach((met, i) => {
        pixels[i] = met === 0 || met > n ? ground : met === n ? anew : before;
      });
    }
    for (let x = 0; x < v; ++x) {
      pixels[x * v + x] = line;
    }
    top.putImageData(image, 0, 0);
    pen.imageSmoothingEnabled = false;
    pen.drawImage(small, 0, 0, canvas.width, canvas.height);
    if (gap > 0) {
      pen.fillStyle = paint.line;
      for (let x = 1; x <= v; ++x) {
        pen.fillRect(x * side - gap, 0, gap, canvas.height);
        pen.fillRect(0, x * side - gap, canvas.width, gap);
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

  /** Names beside the squares, as many as there is room for, and those of what is chosen. */
  function names(): void {
    const shown = steps.names
      .map((_, x) => x)
      .filter(
        (x) => lit.includes(x) || (x % apart === 0 && !lit.some((at) => Math.abs(at - x) < apart)),
      );
    for (const [names, way] of [
      [across, 'left'],
      [down, 'top'],
    ] as const) {
      fill(
        names,
        shown.map((x) => {
          const name = h(
            'span',
            { class: lit.includes(x) ? 'lit' : (x / apart) % 2 === 1 ? 'second' : '' },
            short(x),
          );
          name.style.setProperty(way, `${(100 * (x + 0.5)) / v}%`);
          return name;
        }),
      );
    }
  }

  function light(): void {
    names();
    const top = over.getContext('2d')!;
    top.clearRect(0, 0, over.width, over.height);
    top.strokeStyle = paint.mark;
    top.lineWidth = 2;
    for (const x of lit) {
      top.strokeRect(x * side, 1, side, over.height - 2);
      top.strokeRect(1, x * side, over.width - 2, side);
    }
    if (lit.length === 2) {
      // Around its squares only: they say whether the pair has met.
      const [x, y] = lit as [number, number];
      top.lineWidth = 4;
      top.strokeRect(x * side, y * side, side, side);
      top.strokeRect(y * side, x * side, side, side);
    }
  }

  function placeAt(event: MouseEvent): [number, number] | null {
    const box = canvas.getBoundingClientRect();
    const x = Math.floor(((event.clientX - box.left) / box.width) * v);
    const y = Math.floor(((event.clientY - box.top) / box.height) * v);
    return x === y || x < 0 || y < 0 || x >= v || y >= v ? null : [x, y];
  }

  return {
    element: frame,
    elementsAt: placeAt,
    light(elements) {
      lit = elements;
      light();
    },
    show(n) {
      if (!sets && n === shown + 1 && shown > 0) {
        block(shown, (met) => (met === shown ? paint.met : null));
        block(n, (met) => (met === n ? paint.anew : null));
      } else if (n !== shown) {
        all(n);
      }
      shown = n;
      canvas.setAttribute(
        'aria-label',
        `Map of ${setsOf(sets?.t ?? 2)}: ${(sets?.met ?? steps.pairs!)[n]} of ` +
          `${sets?.all ?? steps.allPairs} have met after block ${n}`,
      );
    },
    pairAt(event) {
      const place = placeAt(event);
      if (!place) {
        return '';
      }
      const [x, y] = place;
      const met = first[x * v + y]!;
      if (sets) {
        return (
          `${steps.names[y]} and ${steps.names[x]}: ${sets.metByPair(shown)[x * v + y]} of the ` +
          `${sets.withPair} ${setsOf(sets.t)} with both have met`
        );
      }
      return (
        `${steps.names[y]} and ${steps.names[x]}: ` +
        `${met === 0 ? 'never together' : `first together in block ${met}`}`
      );
    },
    recolour() {
      paint = colours();
      if (shown > 0) {
        all(shown);
      }
      light();
    },
  };
}
