// The map of all cells on a canvas: v to the right, k downwards; zoomed and panned by pointer,
// fingers and keys. A cell has its number as soon as there is room for it. What the map shows, the
// table below it says to those who do not see it.
import type { Atlas, AtlasCell } from '../../lib/atlas';
import { stride } from '../../lib/canvas';
import { announce, h } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { inkOn } from '../../lib/colours';
import { Drawing } from '../../parts/drawing';
import { inCell, mayFit, say, smallest as smallestLetters, type Written } from './map_words';
import { paintOf, type Paint } from './paint';
import { Pixels } from './pixels';

export interface Window {
  k: { from: number; to: number };
  v: { from: number; to: number };
}

export interface AtlasMap {
  readonly element: HTMLElement;
  show(
    atlas: Atlas,
    how: { measure: string; written: Written; passes: (cell: AtlasCell) => boolean },
  ): void;
  /** Brings a window into sight. */
  look(window: Partial<Window>): void;
  /** Cells that are wholly or partly in sight. */
  seen(): Window;
  /** Whether cells are in sight, faintly, that are outside of the window that was asked for. */
  showsBeyond(): boolean;
  /** Marks a cell; null marks none. */
  mark(v: number | null, k?: number): void;
  zoom(factor: number): void;
  fit(): void;
}

interface Listener {
  /** A cell is pointed at, or none. */
  pointed(cell: AtlasCell | null): void;
  /** A cell is chosen by a click, a tap or a key. */
  chosen(cell: AtlasCell): void;
  /** It is to be opened. */
  opened(cell: AtlasCell): void;
  /** Another part of the map is in sight. */
  moved(): void;
}

const margin = { left: 44, top: 40, right: 12, bottom: 10 };
const largest = { x: 78, y: 40 };

export function atlasMap(signal: AbortSignal, listener: Listener): AtlasMap {
  const drawing = new Drawing(
    'atlas',
    'map',
    'Map of cells, v from left to right, k from top to bottom. Arrow keys choose a cell, ' +
      'Enter opens it, plus and minus zoom, 0 shows everything. The table below has the same ' +
      'numbers.',
    { still: () => atlas && paint && drawStill(atlas, paint), over: drawChosen },
    signal,
  );
  const { canvas, screen, pen, later, soon } = drawing;
  const element = h('div', { class: 'atlas' }, canvas, drawing.tip);
  const pixels = new Pixels();
  let atlas: Atlas | null = null;
  let paint: Paint | null = null;
  let written: Written = 'b';
  let passes: (cell: AtlasCell) => boolean = () => true;
  /** Pixels a cell, and the cell at the corner, in cells from the first. */
  const scale = { x: 8, y: 14 };
  const corner = { x: 0, y: 0 };
  let wanted: Partial<Window> | null = null;
  /** A window that was asked for and is smaller than what is in sight: the rest is faint. */
  let limit: Window | null = null;
  let chosen: { v: number; k: number } | null = null;
  let pointed: { v: number; k: number } | null = null;

  const room = () => ({
    x: drawing.width - margin.left - margin.right,
    y: drawing.height - margin.top - margin.bottom,
  });
  const smallest = () => ({
    x: Math.min(largest.x, room().x / (atlas?.columns ?? 1)),
    y: Math.min(largest.y, room().y / (atlas?.rows ?? 1)),
  });

  function clamp(): void {
    if (!atlas) {
      return;
    }
    const least = smallest();
    scale.x = Math.min(largest.x, Math.max(least.x, scale.x));
    scale.y = Math.min(largest.y, Math.max(least.y, scale.y));
    corner.x = Math.max(0, Math.min(atlas.columns - room().x / scale.x, corner.x));
    corner.y = Math.max(0, Math.min(atlas.rows - room().y / scale.y, corner.y));
    const whole = scale.x <= least.x * 1.001 && scale.y <= least.y * 1.001;
    canvas.style.touchAction = whole ? 'pan-y' : 'none';
    element.classList.toggle('zoomed', !whole);
  }

  const left = (x: number): number => margin.left + (x - corner.x) * scale.x;
  const top = (y: number): number => margin.top + (y - corner.y) * scale.y;
  const gapNow = (): number => (scale.x >= 7 && scale.y >= 7 ? 1 : 0);
  function within(on: CanvasRenderingContext2D): void {
    on.save();
    on.beginPath();
    on.rect(margin.left, margin.top, room().x, room().y);
    on.clip();
  }
  const isWhole = (middle: { x: number; y: number }, wide: number, high: number): boolean =>
    middle.x - wide / 2 >= margin.left &&
    middle.x + wide / 2 <= margin.left + room().x &&
    middle.y - high / 2 >= margin.top &&
    middle.y + high / 2 <= margin.top + room().y;
  const isOutside = (cell: AtlasCell): boolean =>
    limit !== null &&
    (cell.v < limit.v.from || cell.v > limit.v.to || cell.k < limit.k.from || cell.k > limit.k.to);
  const passing = (cell: AtlasCell): boolean => !isOutside(cell) && passes(cell);

  function drawChosen(): void {
    if (!atlas || !paint) {
      return;
    }
    const { text, ground, accent } = paint.ink;
    const gap = gapNow();
    within(screen);
    for (const [place, colour, wide] of [
      [pointed, text, 1.5],
      [chosen, accent, 3],
    ] as const) {
      if (place && atlas.has(place.v, place.k)) {
        const [at, down] = [left(place.v - atlas.v.from), top(place.k - atlas.k.from)];
        screen.lineWidth = wide + 2;
        screen.strokeStyle = ground;
        screen.strokeRect(at - 1, down - 1, scale.x - gap + 2, scale.y - gap + 2);
        screen.lineWidth = wide;
        screen.strokeStyle = colour;
        screen.strokeRect(at - 1, down - 1, scale.x - gap + 2, scale.y - gap + 2);
      }
    }
    screen.restore();
  }

  function drawStill(atlas: Atlas, paint: Paint): void {
    const { width, height } = drawing;
    const { text, faint, line, font } = paint.ink;
    const first = { x: Math.floor(corner.x), y: Math.floor(corner.y) };
    const last = {
      x: Math.min(atlas.columns - 1, Math.ceil(corner.x + room().x / scale.x)),
      y: Math.min(atlas.rows - 1, Math.ceil(corner.y + room().y / scale.y)),
    };
    const gap = gapNow();
    within(pen);
    pen.imageSmoothingEnabled = false;
    pen.drawImage(
      pixels.of(atlas, paint, passing, passes, limit),
      corner.x,
      corner.y,
      room().x / scale.x,
      room().y / scale.y,
      margin.left,
      margin.top,
      room().x,
      room().y,
    );
    for (let x = first.x; gap > 0 && x <= last.x; ++x) {
      pen.clearRect(left(x + 1) - gap, margin.top, gap, room().y);
    }
    for (let y = first.y; gap > 0 && y <= last.y; ++y) {
      pen.clearRect(margin.left, top(y + 1) - gap, room().x, gap);
    }
    const highest = Math.min(13, scale.y - 3);
    const numbers = highest >= smallestLetters && mayFit(scale.x);
    let styled = '';
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    for (let y = first.y; y <= last.y; ++y) {
      for (let x = first.x; x <= last.x; ++x) {
        const cell = atlas.cell(atlas.v.from + x, atlas.k.from + y)!;
        if (cell.status === 'impossible') {
          continue;
        }
        const [at, down] = [left(x), top(y)];
        const sought = passing(cell);
        if (cell.b === null) {
          pen.globalAlpha = sought ? 1 : 0.12;
          pen.strokeStyle = numbers ? line : faint;
          pen.strokeRect(at + 0.5, down + 0.5, scale.x - gap - 1, scale.y - gap - 1);
          pen.globalAlpha = 1;
        }
        const inside = numbers && sought ? inCell(cell, written, scale.x, highest) : null;
        if (inside) {
          const style = `${inside.bound ? 'italic ' : ''}${inside.size}px ${font}`;
          if (style !== styled) {
            pen.font = styled = style;
          }
          const middle = { x: at + (scale.x - gap) / 2, y: down + (scale.y - gap) / 2 + 0.5 };
          // A number that the edge would cut reads as another one.
          const edge = x === first.x || x >= last.x - 1 || y === first.y || y >= last.y - 1;
          if (!edge || isWhole(middle, pen.measureText(inside.text).width, inside.size)) {
            pen.fillStyle = inside.bound ? faint : inkOn(paint.of(cell));
            pen.fillText(inside.text, middle.x, middle.y);
          }
        }
      }
    }
    pen.restore();
    // The scales.
    pen.fillStyle = faint;
    pen.strokeStyle = line;
    pen.font = `12px ${font}`;
    pen.textAlign = 'center';
    pen.textBaseline = 'alphabetic';
    const step = { x: stride(scale.x, 34), y: stride(scale.y, 12) };
    for (
      let v = Math.ceil((atlas.v.from + corner.x) / step.x) * step.x;
      v <= atlas.v.from + last.x;
      v += step.x
    ) {
      const at = left(v - atlas.v.from) + (scale.x - gap) / 2;
      if (at >= margin.left && at <= width - margin.right) {
        pen.fillText(String(v), at, margin.top - 7);
      }
    }
    pen.textAlign = 'right';
    pen.textBaseline = 'middle';
    pen.font = `${step.y * scale.y < 15 ? 11 : 12}px ${font}`;
    for (
      let k = Math.ceil((atlas.k.from + corner.y) / step.y) * step.y;
      k <= atlas.k.from + last.y;
      k += step.y
    ) {
      const at = top(k - atlas.k.from) + (scale.y - gap) / 2;
      if (at >= margin.top && at <= height - margin.bottom) {
        pen.fillText(String(k), margin.left - 8, at);
      }
    }
    pen.fillStyle = text;
    pen.textAlign = 'left';
    pen.textBaseline = 'alphabetic';
    pen.font = `italic 600 13px ${font}`;
    pen.fillText('v', margin.left, 13);
    pen.fillText('k', 12, margin.top + 12);
    pen.font = `12px ${font}`;
    pen.fillStyle = faint;
    pen.fillText('elements →', margin.left + 12, 13);
  }

  function cellAt(event: { clientX: number; clientY: number }): AtlasCell | null {
    const box = canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    if (
      !atlas ||
      x < margin.left ||
      y < margin.top ||
      x > drawing.width - margin.right ||
      y > drawing.height - margin.bottom
    ) {
      return null;
    }
    const cell = atlas.cell(
      atlas.v.from + Math.floor(corner.x + (x - margin.left) / scale.x),
      atlas.k.from + Math.floor(corner.y + (y - margin.top) / scale.y),
    );
    return cell?.status === 'impossible' ? null : cell;
  }

  function zoomAt(factor: number, x: number, y: number): void {
    limit = null;
    const [cx, cy] = [
      corner.x + (x - margin.left) / scale.x,
      corner.y + (y - margin.top) / scale.y,
    ];
    scale.x *= factor;
    // Rows are high enough sooner than columns are wide.
    scale.y *= Math.sqrt(factor);
    clamp();
    corner.x = cx - (x - margin.left) / scale.x;
    corner.y = cy - (y - margin.top) / scale.y;
    clamp();
    later();
    listener.moved();
  }

  /** What has room, whether it was asked for or not. */
  function inRoom(atlas: Atlas): Window {
    const to = (
      from: number,
      at: number,
      space: number,
      per: number,
      most: number,
    ): { from: number; to: number } => ({
      from: Math.min(most, from + Math.floor(at + 0.001)),
      to: Math.min(most, from + Math.ceil(at + space / per - 0.001) - 1),
    });
    return {
      v: to(atlas.v.from, corner.x, room().x, scale.x, atlas.v.to),
      k: to(atlas.k.from, corner.y, room().y, scale.y, atlas.k.to),
    };
  }

  function seen(): Window {
    if (!atlas) {
      return { k: { from: 3, to: 40 }, v: { from: 4, to: 160 } };
    }
    if (drawing.width === 0) {
      return { k: atlas.k, v: atlas.v, ...wanted }; // It is not laid out yet.
    }
    const all = inRoom(atlas);
    const within = (a: { from: number; to: number }, b: { from: number; to: number }) => ({
      from: Math.max(a.from, b.from),
      to: Math.min(a.to, b.to),
    });
    return limit ? { v: within(all.v, limit.v), k: within(all.k, limit.k) } : all;
  }

  function showsBeyond(): boolean {
    if (!atlas || !limit || drawing.width === 0) {
      return false;
    }
    const { k, v } = inRoom(atlas);
    return atlas.cells(k, v).some((cell) => cell.status !== 'impossible' && isOutside(cell));
  }

  function lookAt({ k, v }: Partial<Window>): void {
    if (!atlas || drawing.width === 0) {
      wanted = { ...(k ? { k } : {}), ...(v ? { v } : {}) };
      return;
    }
    const [kk, vv] = [k ?? atlas.k, v ?? atlas.v];
    limit = k || v ? { k: kk, v: vv } : null;
    scale.x = room().x / (Math.min(vv.to, atlas.v.to) - Math.max(vv.from, atlas.v.from) + 1);
    scale.y = room().y / (Math.min(kk.to, atlas.k.to) - Math.max(kk.from, atlas.k.from) + 1);
    corner.x = Math.max(vv.from, atlas.v.from) - atlas.v.from;
    corner.y = Math.max(kk.from, atlas.k.from) - atlas.k.from;
    clamp();
    later();
  }

  function choose(cell: AtlasCell, into: boolean): void {
    chosen = { v: cell.v, k: cell.k };
    if (into && atlas) {
      // Into sight.
      if (isOutside(cell)) {
        limit = null;
      }
      const [x, y] = [cell.v - atlas.v.from, cell.k - atlas.k.from];
      corner.x = Math.min(x, Math.max(corner.x, x + 1 - room().x / scale.x));
      corner.y = Math.min(y, Math.max(corner.y, y + 1 - room().y / scale.y));
      clamp();
      listener.moved();
    }
    later();
    listener.chosen(cell);
  }

  function wordsOf(cell: AtlasCell): string {
    const bound = cell.gap === 0 ? 'minimum' : `bound ${number(cell.lower ?? 0)}`;
    const known =
      cell.b === null
        ? `no design known, at least ${count(cell.lower ?? 0, 'block')}`
        : `${count(cell.b, 'block')}, ${bound}`;
    return `v ${cell.v}  k ${cell.k}   ${known}`;
  }

  /** Moves what is in sight by so many pixels. */
  function pan(x: number, y: number): void {
    limit = null;
    corner.x += x / scale.x;
    corner.y += y / scale.y;
    clamp();
    later();
    listener.moved();
  }

  function go(to: AtlasCell | undefined): void {
    if (to) {
      choose(to, true);
      announce(say(to));
    }
  }
  /** From what is chosen to the next cell that there is. */
  function step(x: number, y: number): void {
    const from = chosen ?? { v: seen().v.from - x, k: seen().k.from - y };
    for (let i = 1; i <= 160; ++i) {
      const next = atlas?.cell(from.v + i * x, from.k + i * y);
      if (next?.status !== 'impossible') {
        go(next ?? undefined);
        return;
      }
    }
  }
  /** The cells of the row of what is chosen. */
  function row(): AtlasCell[] {
    const k = chosen?.k ?? seen().k.from;
    return (atlas?.cells({ from: k, to: k }) ?? []).filter(({ status }) => status !== 'impossible');
  }

  drawing.follow({
    point(event) {
      const cell = event && cellAt(event);
      pointed = cell && { v: cell.v, k: cell.k };
      listener.pointed(cell);
      drawing.say(event, cell && wordsOf(cell));
      soon();
    },
    click(event) {
      const cell = cellAt(event);
      if (cell) {
        const again = chosen?.v === cell.v && chosen.k === cell.k;
        choose(cell, false);
        if (again || event.pointerType !== 'touch') {
          listener.opened(cell);
        }
      }
    },
    drag: (x, y) => pan(-x, -y),
    zoomAt,
    zoom: (factor) => (factor === 0 ? fit() : zoom(factor)),
    aside: (pixels) => pan(pixels, 0),
    keys: {
      ArrowLeft: () => step(-1, 0),
      ArrowRight: () => step(1, 0),
      ArrowUp: () => step(0, -1),
      ArrowDown: () => step(0, 1),
      Enter: () => {
        const cell = chosen && atlas?.cell(chosen.v, chosen.k);
        if (cell) {
          listener.opened(cell);
        }
      },
      Home: () => go(row()[0]),
      End: () => go(row().at(-1)),
    },
  });
  canvas.addEventListener('focus', soon);

  function zoom(factor: number): void {
    const at =
      chosen && atlas
        ? {
            x: margin.left + (chosen.v - atlas.v.from - corner.x + 0.5) * scale.x,
            y: margin.top + (chosen.k - atlas.k.from - corner.y + 0.5) * scale.y,
          }
        : { x: margin.left + room().x / 3, y: margin.top + room().y / 3 };
    zoomAt(factor, at.x, at.y);
  }
  function fit(): void {
    lookAt({});
    listener.moved();
  }

  drawing.fitInto(element, (wide, high) => {
    const before = drawing.width > 0 && atlas ? seen() : null;
    if (!drawing.size(wide, high)) {
      return;
    }
    if (atlas) {
      const whole =
        before &&
        before.v.to - before.v.from + 1 === atlas.columns &&
        before.k.to - before.k.from + 1 === atlas.rows;
      lookAt(wanted ?? (whole ? {} : before) ?? {});
      wanted = null;
    }
    drawing.now();
  });

  return {
    element,
    show(next, how) {
      const other =
        atlas === null ||
        atlas.columns !== next.columns ||
        atlas.rows !== next.rows ||
        atlas.k.from !== next.k.from;
      atlas = next;
      // No higher than all of its rows need.
      element.style.maxHeight = `${margin.top + margin.bottom + next.rows * largest.y + 2}px`;
      written = how.written;
      passes = how.passes;
      paint = paintOf(next, how.measure, how.written === 'b');
      if (other && drawing.width > 0) {
        lookAt(wanted ?? {});
        wanted = null;
      }
      clamp();
      drawing.now();
    },
    look: lookAt,
    seen,
    showsBeyond,
    mark(v, k = 0) {
      chosen = v === null ? null : { v, k };
      soon();
    },
    zoom,
    fit,
  };
}
