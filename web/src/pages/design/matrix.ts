// All pairs of elements as a matrix: below the diagonal when they first meet, above it how often
// they are newly covered. Zoomed and panned; a pair is chosen by a click, and the blocks that are
// chosen elsewhere stand out.
import { pixelOf, token } from '../../lib/canvas';
import { inkOn, scale } from '../../lib/colours';
import { h } from '../../lib/dom';
import { number, setsOf } from '../../lib/words';
import { Drawing } from '../../parts/drawing';
import { theme } from '../../shell/theme';
import type { Chosen } from './selection';
import type { Sets } from './sets';
import type { Steps } from './steps';
import { timesOf } from './times';

export interface Matrix {
  readonly element: HTMLElement;
  order(rows: readonly number[]): void;
  /** How many pairs, or larger sets, are newly covered how often, by the number of times. */
  often(): Map<number, number>;
}

/** A column and a row. */
interface Place {
  x: number;
  y: number;
}

/** Of the names and, outside of them, of what they are. */
const margin = 52;
/** What is left of a pixel outside of the blocks that are chosen. */
const faintly = 0x38ffffff;

/**
 * Null if there are too many elements to keep their pairs apart. `sets`: what must meet, where it
 * is more than pairs. Below the diagonal stands then when all sets with a pair have met, above it
 * how often they are newly covered beyond once.
 */
export function matrix(
  steps: Steps,
  sets: Sets | null,
  chosen: Chosen,
  signal: AbortSignal,
  largest = 720,
): Matrix | null {
  const { v, b, first } = steps;
  if (!first) {
    return null;
  }
  const meet = sets?.completeByPair() ?? first;
  const drawing = new Drawing(
    'matrix',
    'matrix',
    `Pairs of ${v} elements. Arrow keys choose a pair, plus and minus zoom, 0 shows everything.`,
    { still: drawStill, over: drawPointed },
    signal,
  );
  const { canvas, screen, pen, later } = drawing;
  const element = h('div', { class: 'matrix' }, canvas, drawing.tip);
  let rows: number[] = Array.from({ length: v }, (_, x) => x);
  let cell = 0;
  const corner = { x: 0, y: 0 };
  let pointed: Place | null = null;

  const room = (): number => drawing.width - margin;
  const least = (): number => room() / v;
  function clamp(): void {
    cell = Math.min(Math.max(36, least()), Math.max(least(), cell));
    for (const way of ['x', 'y'] as const) {
      corner[way] = Math.max(0, Math.min(v - room() / cell, corner[way]));
    }
  }

  /** How often each pair is newly covered; counted when it is first asked for. */
  let often: Int32Array | null = null;
  const times = (): Int32Array =>
    (often ??= sets ? sets.excessByPair().map((more) => more + 1) : timesOf(chosen.design));

  /** Squares: a pixel each, enlarged. They are recoloured where what they depend on has changed. */
  const small = document.createElement('canvas');
  small.width = small.height = v;
  const top = small.getContext('2d')!;
  const image = top.createImageData(v, v);
  let colouredFor: readonly unknown[] = [];
  function colourSmall(
    shadeOf: (i: number, j: number, when: number, n: number) => number,
    shades: readonly string[],
    range: { from: number; to: number } | null,
  ): void {
    const counts = times();
    const pixels = new Uint32Array(image.data.buffer);
    const colours = shades.map(pixelOf);
    const ground = pixelOf(token('--ground'));
    for (let i = 0; i < v; ++i) {
      const y = rows[i]!;
      for (let j = 0; j < v; ++j) {
        const x = rows[j]!;
        const when = meet[x * v + y]!;
        const inside = !range || (when >= range.from && when <= range.to);
        const colour = x === y ? ground : colours[shadeOf(i, j, when, counts[x * v + y]!)]!;
        pixels[i * v + j] = inside ? colour : colour & faintly;
      }
    }
    top.putImageData(image, 0, 0);
  }

  function drawSmall(
    shadeOf: (i: number, j: number, when: number, n: number) => number,
    shades: readonly string[],
    range: { from: number; to: number } | null,
  ): void {
    const now = [rows, range?.from, range?.to, theme()];
    if (now.some((each, i) => each !== colouredFor[i])) {
      colouredFor = now;
      colourSmall(shadeOf, shades, range);
    }
    pen.imageSmoothingEnabled = false;
    pen.drawImage(
      small,
      corner.x,
      corner.y,
      room() / cell,
      room() / cell,
      margin,
      margin,
      room(),
      room(),
    );
  }

  /** Both squares of a pair. */
  function outline(top: CanvasRenderingContext2D, { x, y }: Place, colour: string): void {
    for (const [i, j] of [
      [x, y],
      [y, x],
    ] as const) {
      const [left, above] = [
        margin + (i - corner.x) * cell - 1,
        margin + (j - corner.y) * cell - 1,
      ];
      top.lineWidth = 4;
      top.strokeStyle = token('--ground');
      top.strokeRect(left, above, cell + 1, cell + 1);
      top.lineWidth = 2;
      top.strokeStyle = colour;
      top.strokeRect(left, above, cell + 1, cell + 1);
    }
  }
  function within(top: CanvasRenderingContext2D): void {
    top.save();
    top.beginPath();
    top.rect(margin, margin, room(), room());
    top.clip();
  }

  function drawPointed(): void {
    if (pointed) {
      within(screen);
      outline(screen, pointed, token('--text'));
      screen.restore();
    }
  }

  function drawStill(): void {
    const side = drawing.width;
    const colours = scale(theme());
    const counts = times();
    const range = chosen.range;
    const lit = chosen.elements;
    const [sunken, faint, mark, met, often, leave] = [
      '--sunken',
      '--faint',
      '--mark',
      '--met',
      '--often',
      '--leave',
    ].map(token) as [string, string, string, string, string, string];
    const gap = 1;
    within(pen);
    const last = {
      x: Math.min(v - 1, Math.ceil(corner.x + room() / cell)),
      y: Math.min(v - 1, Math.ceil(corner.y + room() / cell)),
    };
    // Colours by their places: a name for each square would take most of the time.
    const all = [...colours, faint, sunken, met, often, leave];
    const many = colours.length;
    const never = many + 4;
    const shadeOf = (i: number, j: number, when: number, n: number): number =>
      when === 0
        ? never
        : j > i
          ? many + Math.min(3, n)
          : Math.min(many - 1, Math.floor(((when - 1) / b) * many));
    drawSmall(shadeOf, all, range);
    // Lines between squares, and numbers where they fit.
    if (cell >= 5) {
      for (let i = Math.floor(corner.y); i <= last.y; ++i) {
        pen.clearRect(margin, margin + (i + 1 - corner.y) * cell - gap, room(), gap);
      }
      for (let j = Math.floor(corner.x); j <= last.x; ++j) {
        pen.clearRect(margin + (j + 1 - corner.x) * cell - gap, margin, gap, room());
      }
    }
    const font = `${cell >= 30 ? 11 : 9}px ${token('--text-font')}`;
    for (let i = Math.floor(corner.y); cell >= 24 && i <= last.y; ++i) {
      for (let j = Math.floor(corner.x); j <= last.x; ++j) {
        const [x, y] = [rows[j]!, rows[i]!];
        const when = meet[x * v + y]!;
        if (x === y || (range && (when < range.from || when > range.to))) {
          continue;
        }
        const n = counts[x * v + y]!;
        const [px, py] = [margin + (j - corner.x) * cell, margin + (i - corner.y) * cell];
        pen.fillStyle = inkOn(all[shadeOf(i, j, when, n)]!);
        pen.font = font;
        pen.textAlign = 'center';
        pen.textBaseline = 'middle';
        pen.fillText(
          j > i ? (n === 1 ? '' : String(sets ? n - 1 : n)) : String(when),
          px + cell / 2,
          py + cell / 2,
        );
      }
    }
    pen.globalAlpha = 1;
    // Rows and columns of what is chosen.
    const rowOf = (x: number): number => rows.indexOf(x);
    const cross = (i: number, colour: string): void => {
      pen.strokeStyle = colour;
      pen.lineWidth = 1.5;
      pen.strokeRect(margin + (i - corner.x) * cell - 0.5, margin, cell, room());
      pen.strokeRect(margin, margin + (i - corner.y) * cell - 0.5, room(), cell);
    };
    lit.forEach((x) => cross(rowOf(x), mark));
    if (lit.length === 2) {
      outline(pen, { x: rowOf(lit[0]!), y: rowOf(lit[1]!) }, mark);
    }
    pen.restore();
    pen.font = `12px ${token('--text-font')}`;
    pen.fillStyle = faint;
    pen.textBaseline = 'middle';
    pen.textAlign = 'left';
    pen.fillText('element →', margin, 10);
    pen.save();
    pen.translate(9, margin);
    pen.rotate(-Math.PI / 2);
    pen.textAlign = 'right';
    pen.fillText('← element', 0, 0);
    pen.restore();
    // Names across are apart as far as the longest of them is wide.
    const longest = Math.min(5, Math.max(...steps.names.map(({ length }) => length)));
    const [step, stepAcross] = [16, 7 * longest + 9].map((pixels) =>
      Math.max(1, Math.ceil(pixels / cell)),
    ) as [number, number];
    const strongAt = lit.map(rowOf);
    for (let i = 0; i < v; ++i) {
      const strong = strongAt.includes(i);
      // Is there room, and no name that is chosen in the way?
      const fits = (each: number): boolean =>
        strong || (i % each === 0 && strongAt.every((at) => Math.abs(at - i) >= each));
      pen.fillStyle = strong ? mark : faint;
      const name = steps.names[rows[i]!]!.slice(0, 5);
      const across = margin + (i - corner.x + 0.5) * cell;
      const down = margin + (i - corner.y + 0.5) * cell;
      pen.textBaseline = 'middle';
      pen.textAlign = 'center';
      if (across > margin && across + name.length * 3.5 < side && fits(stepAcross)) {
        pen.fillText(name, across, margin - 9);
      }
      pen.textAlign = 'right';
      if (down > margin && down < side - 4 && fits(step)) {
        pen.fillText(name, margin - 6, down);
      }
    }
  }

  function hit(event: { clientX: number; clientY: number }): Place | null {
    const box = canvas.getBoundingClientRect();
    const x = Math.floor(corner.x + (event.clientX - box.left - margin) / cell);
    const y = Math.floor(corner.y + (event.clientY - box.top - margin) / cell);
    return x < 0 ||
      y < 0 ||
      x >= v ||
      y >= v ||
      x === y ||
      event.clientX - box.left < margin ||
      event.clientY - box.top < margin
      ? null
      : { x, y };
  }
  function zoomAt(factor: number, px: number, py: number): void {
    const [cx, cy] = [corner.x + (px - margin) / cell, corner.y + (py - margin) / cell];
    cell *= factor;
    clamp();
    corner.x = cx - (px - margin) / cell;
    corner.y = cy - (py - margin) / cell;
    clamp();
    later();
  }

  const go = (dx: number, dy: number): void => {
    const [x, y] =
      chosen.elements.length === 2
        ? [rows.indexOf(chosen.elements[1]!), rows.indexOf(chosen.elements[0]!)]
        : [0, 1];
    let [nx, ny] = [x + dx, y + dy];
    if (nx === ny) {
      [nx, ny] = [nx + dx, ny + dy];
    }
    if (nx >= 0 && ny >= 0 && nx < v && ny < v) {
      chosen.choose([rows[ny]!, rows[nx]!]);
    }
  };
  function wordsOf(place: Place): string {
    const [x, y] = [rows[place.x]!, rows[place.y]!];
    const when = meet[x * v + y]!;
    if (sets) {
      const several = setsOf(sets.t);
      const more = times()[x * v + y]! - 1;
      return (
        `${steps.names[y]} and ${steps.names[x]}: ` +
        `${when === 0 ? `not all ${several} with both meet` : `all ${several} with both have met with block ${number(when)}`}` +
        `, newly covered beyond once: ${number(more)}`
      );
    }
    const covered = times()[x * v + y] === 1 ? 'once' : `${times()[x * v + y]} times`;
    const met = `first together in block ${number(when)}, newly covered ${covered}`;
    return `${steps.names[y]} and ${steps.names[x]}: ${when === 0 ? 'never together' : met}`;
  }
  drawing.follow({
    point(event) {
      pointed = event && hit(event);
      drawing.say(event, pointed && wordsOf(pointed));
      drawing.soon();
    },
    click(event) {
      const here = hit(event);
      if (here) {
        const pair = [rows[here.y]!, rows[here.x]!];
        chosen.choose(pair.every((x) => chosen.elements.includes(x)) ? [] : pair);
      }
    },
    drag(x, y) {
      corner.x -= x / cell;
      corner.y -= y / cell;
      clamp();
      later();
    },
    zoomAt,
    zoom: (factor) =>
      factor === 0
        ? zoomAt(1e-9, margin, margin)
        : zoomAt(factor, drawing.width / 2, drawing.width / 2),
    keys: {
      ArrowLeft: () => go(-1, 0),
      ArrowRight: () => go(1, 0),
      ArrowUp: () => go(0, -1),
      ArrowDown: () => go(0, 1),
      Escape: () => chosen.choose([]),
    },
  });

  drawing.fitInto(element, (wide) => {
    const side = Math.min(wide, largest);
    if (drawing.size(side, side)) {
      canvas.style.width = canvas.style.height = `${side}px`;
      const begun = cell > 0;
      cell = 0;
      clamp();
      // What stands beside it is drawn first: both in one frame take too long.
      begun ? drawing.now() : later();
    }
  });
  chosen.follow(signal, later);
  document.addEventListener('themechange', later, { signal });
  return {
    element,
    often() {
      const counts = times();
      const found = new Map<number, number>();
      sets?.times.forEach((n) => found.set(n, (found.get(n) ?? 0) + 1));
      for (let x = 0; !sets && x < v; ++x) {
        for (let y = 0; y < x; ++y) {
          const n = counts[x * v + y]!;
          found.set(n, (found.get(n) ?? 0) + 1);
        }
      }
      return new Map([...found].sort(([a], [z]) => a - z));
    },
    order(next) {
      rows = [...next];
      later();
    },
  };
}
