// A drawing that is looked at from near and from far: what timeline, matrix and map share. It has
// two layers, so that what follows the pointer does not wait for all the rest; pointers, fingers,
// the wheel and keys move it and zoom it.
import { clear, placeTip, resize } from '../lib/canvas';
import { h } from '../lib/dom';

/** What is drawn. */
interface Layers {
  /** Draws with `pen` what stays while the pointer moves. */
  still(): void;
  /** Draws over it, with `screen`. */
  over(): void;
}

/** What pointers and keys do. Places are in CSS pixels from the corner of the canvas. */
export interface Hand {
  /** A pointer is over a place, or over none. */
  point(event: PointerEvent | null): void;
  click(event: PointerEvent): void;
  /** Moves what is in sight by so many pixels. */
  drag(x: number, y: number): void;
  /** Zooms around a place, which stays where it is. */
  zoomAt(factor: number, x: number, y: number): void;
  /** Zooms around what is looked at; 0 shows everything. */
  zoom(factor: number): void;
  /** The wheel moves sideways; without it the page does. */
  aside?(pixels: number): void;
  keys: Readonly<Record<string, () => void>>;
}

/** Movements of a pointer that are smaller than this are a click. */
const steady = 4;

export class Drawing {
  readonly canvas: HTMLCanvasElement;
  readonly tip = h('div', { class: 'atlas-tip', hidden: true });
  readonly screen: CanvasRenderingContext2D;
  readonly pen: CanvasRenderingContext2D;
  /** 0 until it is known. */
  width = 0;
  height = 0;
  private readonly kept = document.createElement('canvas');
  private stale = true;
  private frame = 0;

  constructor(
    name: string,
    what: string,
    label: string,
    private readonly layers: Layers,
    private readonly signal: AbortSignal,
  ) {
    this.canvas = h('canvas', {
      class: `${name}-canvas`,
      tabindex: 0,
      role: 'application',
      'aria-roledescription': what,
      'aria-label': label,
    });
    this.screen = this.canvas.getContext('2d')!;
    this.pen = this.kept.getContext('2d')!;
    signal.addEventListener('abort', () => cancelAnimationFrame(this.frame));
  }

  /** Draws all of it at once. */
  readonly now = (): void => {
    this.stale = true;
    this.draw();
  };
  /** Draws all of it in the next frame. */
  readonly later = (): void => {
    this.stale = true;
    this.soon();
  };
  /** Draws what lies over it in the next frame. */
  readonly soon = (): void => {
    if (this.frame === 0) {
      this.frame = requestAnimationFrame(() => {
        this.frame = 0;
        this.draw();
      });
    }
  };

  private draw(): void {
    if (this.width === 0) {
      return;
    }
    if (this.stale) {
      this.stale = false;
      clear(this.pen, this.width, this.height);
      this.layers.still();
    }
    clear(this.screen, this.width, this.height);
    this.screen.drawImage(this.kept, 0, 0, this.width, this.height);
    this.layers.over();
  }

  /** Calls `fit` whenever a place has a size, with its width and height. */
  fitInto(place: HTMLElement, fit: (width: number, height: number) => void): void {
    const sizes = new ResizeObserver(() => {
      if (place.clientWidth > 0) {
        fit(place.clientWidth, place.clientHeight);
      }
    });
    sizes.observe(place);
    this.signal.addEventListener('abort', () => sizes.disconnect());
  }

  /** Sets the size, and says whether it is another one. */
  size(width: number, height: number): boolean {
    if (width === this.width && height === this.height) {
      return false;
    }
    [this.width, this.height] = [width, height];
    resize(this.canvas, width, height);
    resize(this.kept, width, height);
    return true;
  }

  /** Shows words beside the pointer; without words none. */
  say(event: PointerEvent | null, words: string | null): void {
    this.tip.hidden = event === null || words === null;
    if (event && words !== null) {
      placeTip(this.tip, this.canvas, event, words);
    }
  }

  follow(hand: Hand): void {
    this.followPointers(hand);
    this.canvas.addEventListener('wheel', (event) => this.turn(event, hand), { passive: false });
    const keys: Hand['keys'] = {
      '+': () => hand.zoom(1.5),
      '=': () => hand.zoom(1.5),
      '-': () => hand.zoom(1 / 1.5),
      '0': () => hand.zoom(0),
      ...hand.keys,
    };
    this.canvas.addEventListener('keydown', (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) {
        return;
      }
      // What the pointer rests on is not what the keys choose.
      hand.point(null);
      const act = keys[event.key];
      if (act) {
        event.preventDefault();
        act();
      }
    });
  }

  private followPointers(hand: Hand): void {
    const { canvas } = this;
    const down = new Map<number, { x: number; y: number }>();
    /** Where a click would be one, and whether it is none any more. */
    let from = { x: 0, y: 0 };
    let moved = false;
    canvas.addEventListener('pointerdown', (event) => {
      from = { x: event.clientX, y: event.clientY };
      moved = down.size > 0;
      down.set(event.pointerId, from);
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener('pointermove', (event) => {
      const before = down.get(event.pointerId);
      if (!before) {
        hand.point(event);
        return;
      }
      const here = { x: event.clientX, y: event.clientY };
      const [other, third] = [...down].filter(([id]) => id !== event.pointerId);
      if (other && !third) {
        const far = (place: { x: number; y: number }): number =>
          Math.max(20, Math.hypot(place.x - other[1].x, place.y - other[1].y));
        const box = canvas.getBoundingClientRect();
        const middle = [(here.x + other[1].x) / 2, (here.y + other[1].y) / 2] as const;
        hand.zoomAt(far(here) / far(before), middle[0] - box.left, middle[1] - box.top);
      } else if (!other) {
        if (!moved && Math.hypot(here.x - from.x, here.y - from.y) <= steady) {
          return;
        }
        moved = true;
        hand.point(null);
        hand.drag(here.x - before.x, here.y - before.y);
      }
      down.set(event.pointerId, here);
    });
    canvas.addEventListener('pointerup', (event) => {
      if (down.delete(event.pointerId) && !moved && event.button === 0) {
        hand.click(event);
      }
    });
    canvas.addEventListener('pointercancel', (event) => down.delete(event.pointerId));
    canvas.addEventListener('pointerleave', () => hand.point(null));
  }

  /** Without a key the page scrolls, unless the wheel moves sideways. */
  private turn(event: WheelEvent, hand: Hand): void {
    if (event.ctrlKey || event.metaKey) {
      event.preventDefault();
      const box = this.canvas.getBoundingClientRect();
      const [x, y] = [event.clientX - box.left, event.clientY - box.top];
      hand.zoomAt(Math.exp(-event.deltaY * 0.0025 * (event.deltaMode === 1 ? 20 : 1)), x, y);
    } else if (hand.aside && (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY))) {
      event.preventDefault();
      hand.aside(event.deltaX || event.deltaY);
    }
  }
}
