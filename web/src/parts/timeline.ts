// Stays over time, as a profiler shows them: a row for each element or item, a bar for each time
// that it is there. Zoomed, panned and brushed; the strip above has the whole design and the part
// that is in sight.
import { inkOn } from '../lib/colours';
import { clear, resize, stride, token } from '../lib/canvas';
import { h } from '../lib/dom';
import { number } from '../lib/words';
import { Bars } from './bars';
import { Drawing } from './drawing';
import type { Choice, Stays } from './stays';

export type Order = 'first' | 'stays' | 'given';

export interface Timeline {
  readonly element: HTMLElement;
  /** Rows from top to bottom. */
  order(rows: readonly number[]): void;
}

export interface TimelineData {
  v: number;
  b: number;
  names: readonly string[];
  /** How many pairs, or larger sets, have met after so many steps; null: not counted. */
  pairs: ArrayLike<number> | null;
  allPairs: number;
  /** What these are called: pairs. */
  sets: string;
  stays: Stays;
  /** What a step and an element are called. */
  step: string;
  item: string;
}

const left = 64;
const axis = 24;
/** Pixels a step when one looks closest; few steps are as wide as the strip above them. */
const widest = 40;
/** Pixels at the beginning of a bar that say: put in here. */
const widestMark = 14;

export function timeline(
  steps: TimelineData,
  chosen: Choice,
  first: readonly number[],
  signal: AbortSignal,
): Timeline {
  const { v, b, stays } = steps;
  const drawing = new Drawing(
    'timeline',
    'timeline',
    `${v} ${steps.item}s over ${b} ${steps.step}s. Up and down choose one, left ` +
      `and right move, plus and minus zoom, 0 shows everything. Enter selects.`,
    { still: drawStill, over: drawPointed },
    signal,
  );
  const { canvas, screen, pen, later } = drawing;
  const strip = h('canvas', {
    class: 'timeline-strip',
    role: 'img',
    'aria-label':
      `From the first step to the last: how many ${steps.sets} have met, and the part in sight. ` +
      'Drag to choose a part.',
  });
  const place = h('div', { class: 'timeline-place' }, canvas, drawing.tip);
  const element = h('div', { class: 'timeline' }, strip, place);
  const bars = new Bars();
  const thin = strip.getContext('2d')!;
  let rows: number[] = [];
  let rowOf = new Int32Array(v);
  /** Pixels a block, the block at the left edge (from 0), pixels a row, the first row in sight. */
  let scale = 4;
  let at = 0;
  let row = 8;
  let top = 0;
  let pointed: { x: number; block: number } | null = null;
  let key = 0;

  const room = (): number => drawing.width - left - 8;
  const least = (): number => room() / b;
  const begins = (): number => Math.min(widestMark, Math.max(2, scale * 0.35));
  /** Where steps are narrow only long stays have room for a mark where they begin. */
  const marked = (from: number, long: number): boolean =>
    (scale >= 3 || long >= 5) && (from > 1 || steps.item === 'item');
  function setOrder(next: readonly number[]): void {
    rows = [...next];
    rowOf = new Int32Array(v);
    rows.forEach((x, i) => (rowOf[x] = i));
    later();
  }

  function clamp(): void {
    scale = Math.max(least(), Math.min(widest, scale));
    at = Math.max(0, Math.min(b - room() / scale, at));
    top = Math.max(0, Math.min(v - (drawing.height - axis) / row, top));
  }
  /** Another part is in sight. */
  function moved(): void {
    clamp();
    later();
    const whole = scale <= least() * 1.001;
    chosen.setRange(
      whole ? null : { from: Math.floor(at) + 1, to: Math.min(b, Math.ceil(at + room() / scale)) },
    );
  }

  function drawPointed(): void {
    if (pointed) {
      screen.fillStyle = token('--text');
      screen.globalAlpha = 0.14;
      const [x, y] = [
        left + (pointed.block - 1 - at) * scale,
        axis + (rowOf[pointed.x]! - top) * row,
      ];
      screen.fillRect(Math.max(x, left), axis, Math.max(scale, 1), drawing.height);
      screen.fillRect(left, Math.max(y, axis), room(), row);
      screen.globalAlpha = 1;
    }
  }

  function drawStill(): void {
    drawStrip();
    const { width, height } = drawing;
    const font = token('--text-font');
    const [kept, fresh, faint, line, mark, leave, sunken] = [
      '--met',
      '--accent',
      '--faint',
      '--line',
      '--mark',
      '--leave',
      '--sunken',
    ].map(token) as [string, string, string, string, string, string, string];
    const [a, z] = [Math.floor(at) + 1, Math.min(b, Math.ceil(at + room() / scale))];
    const x = (block: number): number => left + (block - 1 - at) * scale;
    const picked = chosen.elements;
    const lit = new Set(picked);
    pen.save();
    pen.beginPath();
    pen.rect(left, axis, room(), height - axis);
    pen.clip();
    const gap = row >= 5 ? 1.5 : row >= 3 ? 0.7 : 0;
    // Setting a colour takes as long as a bar.
    let colour = '';
    const paint = (next: string): void => {
      if (next !== colour) {
        pen.fillStyle = colour = next;
      }
    };
    const isThin = row < 3;
    if (isThin) {
      const ratio = devicePixelRatio || 1;
      const wide = Math.round(room() * ratio);
      const begin = Math.floor(top);
      const shown = Math.min(v, Math.ceil(top + (height - axis) / row)) - begin;
      const picture = bars.draw(wide, shown, (i, put) => {
        const each = rows[begin + i]!;
        const mine = stays.of(each);
        const strong = lit.has(each);
        const faint = lit.size > 0 && !strong;
        if (strong) {
          put(0, wide, sunken, false);
        }
        for (let j = stays.from(each, a); j < mine.length && mine[j]![0] <= z; ++j) {
          const [from, to] = mine[j]!;
          const start = (from - 1 - at) * scale * ratio;
          const long = ((to - from + 1) * scale - (scale >= 4 ? 1 : 0)) * ratio;
          put(start, long, strong ? mark : kept, faint);
          if (marked(from, long / ratio)) {
            put(start, Math.min(long, begins() * ratio), fresh, faint);
          }
        }
      });
      pen.imageSmoothingEnabled = false;
      pen.drawImage(picture, left, axis + (begin - top) * row, room(), shown * row);
    }
    for (let i = Math.floor(top); !isThin && i < v && axis + (i - top) * row < height; ++i) {
      const each = rows[i]!;
      const y = axis + (i - top) * row;
      const mine = stays.of(each);
      const strong = lit.has(each);
      if (strong) {
        paint(sunken);
        pen.fillRect(left, y, room(), row);
      }
      pen.globalAlpha = lit.size > 0 && !strong ? 0.6 : 1;
      for (let j = stays.from(each, a); j < mine.length && mine[j]![0] <= z; ++j) {
        const [from, to] = mine[j]!;
        const start = x(from);
        const long = Math.max((to - from + 1) * scale - (scale >= 4 ? 1 : 0), 0.8);
        paint(strong ? mark : kept);
        pen.fillRect(start, y, long, row - gap);
        if (marked(from, long)) {
          paint(fresh);
          pen.fillRect(start, y, Math.min(long, begins()), row - gap);
        }
        if (row >= 12 && long >= 22) {
          pen.globalAlpha = 1;
          paint(inkOn(strong ? mark : kept));
          pen.font = `10px ${font}`;
          pen.textAlign = 'center';
          pen.textBaseline = 'middle';
          pen.fillText(steps.names[each]!, start + long / 2 + 2, y + (row - gap) / 2);
          pen.globalAlpha = lit.size > 0 && !strong ? 0.6 : 1;
        }
      }
    }
    pen.globalAlpha = 1;
    // Where a pair is together.
    if (picked.length === 2) {
      pen.fillStyle = leave;
      for (const [from, to] of stays.shared(picked[0]!, picked[1]!)) {
        for (const each of picked) {
          const y = axis + (rowOf[each]! - top) * row;
          pen.fillRect(x(from), y, Math.max((to - from + 1) * scale - 1, 1.5), row - gap);
        }
      }
    }
    pen.restore();
    // Scales.
    pen.fillStyle = faint;
    pen.strokeStyle = line;
    pen.font = `12px ${font}`;
    pen.textAlign = 'center';
    pen.textBaseline = 'alphabetic';
    const step = stride(scale, 52);
    for (let n = Math.max(step, Math.ceil(a / step) * step); n <= z; n += step) {
      const half = pen.measureText(number(n)).width / 2;
      pen.fillText(number(n), Math.min(x(n) + scale / 2, width - half - 1), axis - 8);
      pen.beginPath();
      pen.moveTo(Math.round(x(n) + scale / 2) + 0.5, axis - 4);
      pen.lineTo(Math.round(x(n) + scale / 2) + 0.5, axis);
      pen.stroke();
    }
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    const rowStep = stride(row, 13);
    // No name is cut in half at the bottom.
    for (let i = Math.floor(top); i < v && axis + (i - top + 0.5) * row < height - 5; ++i) {
      const strong = lit.has(rows[i]!);
      if (i % rowStep === 0 || strong) {
        pen.fillStyle = strong ? mark : faint;
        pen.font = `${strong ? '700 ' : ''}12px ${font}`;
        pen.fillText(steps.names[rows[i]!]!.slice(0, 8), left - 8, axis + (i - top + 0.5) * row);
      }
    }
    pen.textAlign = 'left';
    pen.fillStyle = faint;
    pen.font = `12px ${font}`;
    pen.fillText(steps.step, 8, axis - 12);
    if (rows.length * row > 120) {
      pen.save();
      pen.translate(10, axis);
      pen.rotate(-Math.PI / 2);
      pen.textAlign = 'right';
      pen.fillText(`← ${steps.item}`, 0, 0);
      pen.restore();
    }
  }

  function drawStrip(): void {
    const high = strip.clientHeight;
    clear(thin, drawing.width, high);
    const [faint, met, accent] = [token('--faint'), token('--met'), token('--accent')];
    if (steps.pairs) {
      thin.fillStyle = met;
      thin.globalAlpha = 0.55;
      thin.beginPath();
      thin.moveTo(left, high);
      for (let i = 0; i <= room(); i += 2) {
        thin.lineTo(
          left + i,
          high -
            ((high - 4) * steps.pairs[Math.min(b, Math.floor((i / room()) * b) + 1)]!) /
              Math.max(1, steps.allPairs),
        );
      }
      thin.lineTo(left + room(), high);
      thin.fill();
      thin.globalAlpha = 1;
    }
    for (const each of chosen.elements) {
      thin.fillStyle = token('--mark');
      for (const [from, to] of stays.of(each)) {
        thin.fillRect(
          left + ((from - 1) / b) * room(),
          chosen.elements.indexOf(each) * 6,
          Math.max(1, ((to - from + 1) / b) * room()),
          4,
        );
      }
    }
    thin.fillStyle = faint;
    thin.font = `11px ${token('--text-font')}`;
    thin.textBaseline = 'middle';
    thin.fillText(steps.sets, 8, high / 2 - 7);
    thin.fillText('met', 8, high / 2 + 7);
    const [from, to] = [
      left + (at / b) * room(),
      left + (Math.min(b, at + room() / scale) / b) * room(),
    ];
    thin.fillStyle = token('--text');
    thin.globalAlpha = 0.13;
    thin.fillRect(left, 0, from - left, high);
    thin.fillRect(to, 0, left + room() - to, high);
    thin.globalAlpha = 1;
    thin.strokeStyle = accent;
    thin.lineWidth = 2;
    thin.strokeRect(from + 1, 1, Math.max(4, to - from - 2), high - 2);
  }

  function zoomAt(factor: number, px: number): void {
    const block = at + (px - left) / scale;
    scale *= factor;
    clamp();
    at = block - (px - left) / scale;
    moved();
  }

  function hit(event: { clientX: number; clientY: number }): { x: number; block: number } | null {
    const box = canvas.getBoundingClientRect();
    const [px, py] = [event.clientX - box.left, event.clientY - box.top];
    const block = Math.floor(at + (px - left) / scale) + 1;
    const i = Math.floor(top + (py - axis) / row);
    return py < axis || i < 0 || i >= v || block < 1 || block > b || px < left
      ? px < left && i >= 0 && i < v && py >= axis
        ? { x: rows[i]!, block: 0 }
        : null
      : { x: rows[i]!, block };
  }

  const shift = (pixels: number): void => {
    at += pixels / scale;
    moved();
  };
  const choose = (by: number): void => {
    key = Math.max(0, Math.min(v - 1, key + by));
    chosen.choose([rows[key]!]);
    top = Math.min(key, Math.max(top, key + 1 - (drawing.height - axis) / row));
    clamp();
    later();
  };
  const zoom = (factor: number): void =>
    factor === 0 ? zoomAt(1e-9, left) : zoomAt(factor, left + room() / 2);
  drawing.follow({
    point(event) {
      const here = event && hit(event);
      pointed = here && here.block > 0 ? here : null;
      const stay = pointed && stays.at(pointed.x, pointed.block);
      drawing.say(
        event,
        pointed &&
          `${steps.names[pointed.x]}, ${steps.step} ${number(pointed.block)}: ` +
            `${stay ? `stays from ${number(stay[0])} to ${number(stay[1])}` : 'not there'}`,
      );
      drawing.soon();
    },
    click(event) {
      const here = hit(event);
      if (here) {
        key = rowOf[here.x]!;
        chosen.toggle(here.x);
      }
    },
    drag(x, y) {
      top -= y / row;
      shift(-x);
    },
    zoomAt,
    zoom,
    aside: shift,
    keys: {
      ArrowLeft: () => shift(-0.2 * room()),
      ArrowRight: () => shift(0.2 * room()),
      a: () => shift(-0.2 * room()),
      d: () => shift(0.2 * room()),
      ArrowUp: () => choose(-1),
      ArrowDown: () => choose(1),
      w: () => zoom(1.5),
      s: () => zoom(1 / 1.5),
      Enter: () => chosen.toggle(rows[key]!),
      Escape: () => chosen.choose([]),
    },
  });

  // The strip: a drag chooses blocks, a click moves there.
  let brush: number | null = null;
  const blockAt = (event: PointerEvent): number =>
    Math.max(
      0,
      Math.min(b, ((event.clientX - strip.getBoundingClientRect().left - left) / room()) * b),
    );
  strip.addEventListener('pointerdown', (event) => {
    brush = blockAt(event);
    strip.setPointerCapture(event.pointerId);
  });
  strip.addEventListener('pointermove', (event) => {
    if (brush === null) {
      return;
    }
    const to = blockAt(event);
    if (Math.abs(to - brush) * (room() / b) > 5) {
      scale = room() / Math.max(3, Math.abs(to - brush));
      at = Math.min(brush, to);
      moved();
    }
  });
  strip.addEventListener('pointerup', (event) => {
    if (brush !== null && Math.abs(blockAt(event) - brush) * (room() / b) <= 5) {
      at = brush - room() / scale / 2;
      moved();
    }
    brush = null;
  });

  drawing.fitInto(place, (wide) => {
    if (wide === drawing.width) {
      return;
    }
    const whole = drawing.width === 0 || scale <= least() * 1.001;
    const begun = drawing.width > 0;
    row = Math.max(2, Math.min(18, (Math.min(560, window.innerHeight * 0.6) - axis) / v));
    const high = Math.min(Math.max(600, window.innerHeight * 0.6), axis + Math.ceil(v * row) + 2);
    place.style.height = `${high}px`;
    drawing.size(wide, high);
    resize(strip, wide, strip.clientHeight);
    if (!begun) {
      const range = chosen.range;
      scale = range ? room() / (range.to - range.from + 1) : least();
      at = range ? range.from - 1 : 0;
    } else if (whole) {
      scale = least();
    }
    clamp();
    drawing.now();
  });
  chosen.follow(signal, later);
  document.addEventListener('themechange', later, { signal });
  setOrder(first);
  return { element, order: setOrder };
}
