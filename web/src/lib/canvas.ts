// What drawings on a canvas share: colours of the theme, sharp pixels, ticks, a tip beside the
// pointer.

/** A colour or a font of the theme. */
export function token(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

/**
 * Distances between lines of a scale: 1, 2, 5, 10, 20, …, so that they are at least so many pixels
 * apart.
 */
export function stride(pixels: number, least: number): number {
  for (let unit = 1; ; unit *= 10) {
    for (const step of [1, 2, 5]) {
      if (step * unit * pixels >= least) {
        return step * unit;
      }
    }
  }
}

/** "#rrggbb" as a pixel of ImageData that is read 32 bits at a time. */
export function pixelOf(colour: string): number {
  const at = (i: number): number => parseInt(colour.slice(i, i + 2), 16);
  return ((0xff << 24) | (at(5) << 16) | (at(3) << 8) | at(1)) >>> 0;
}

/** Gives a canvas the pixels of the screen. */
export function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
  const ratio = devicePixelRatio || 1;
  canvas.width = Math.round(width * ratio);
  canvas.height = Math.round(height * ratio);
}

/** Begins a drawing: empty, in CSS pixels. */
export function clear(pen: CanvasRenderingContext2D, width: number, height: number): void {
  const ratio = devicePixelRatio || 1;
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
}

/** Puts a tip beside the pointer, within the canvas. */
export function placeTip(
  tip: HTMLElement,
  canvas: HTMLCanvasElement,
  event: MouseEvent,
  words: string,
): void {
  tip.textContent = words;
  const box = canvas.getBoundingClientRect();
  const rightmost = box.width - tip.offsetWidth - 4;
  tip.style.left = `${Math.max(4, Math.min(rightmost, event.clientX - box.left + 14))}px`;
  tip.style.top = `${Math.max(2, event.clientY - box.top - 38)}px`;
}

/** Colours side by side, to be stretched by its style. */
export function colourBar(colours: readonly string[]): HTMLCanvasElement {
  const bar = document.createElement('canvas');
  bar.className = 'colour-bar';
  [bar.width, bar.height] = [colours.length, 1];
  const pen = bar.getContext('2d');
  colours.forEach((colour, i) => {
    if (pen) {
      pen.fillStyle = colour;
      pen.fillRect(i, 0, 1, 1);
    }
  });
  return bar;
}
