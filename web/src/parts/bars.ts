// Thin bars, thousands of them, as one picture: a rectangle each takes longer than a frame may.
import { pixelOf } from '../lib/canvas';

/**
 * Puts a bar into its row, in pixels of the screen; it may begin before 0 and end beyond the width.
 */
export type Put = (from: number, long: number, colour: string, faint: boolean) => void;

/** What is left of a faint colour: 0.6 of it. */
const faintly = 0x99ffffff;

/** A picture with a row of pixels for each row of bars. */
export class Bars {
  private readonly canvas = document.createElement('canvas');
  private readonly pen = this.canvas.getContext('2d')!;
  private image: ImageData | null = null;
  private readonly known = new Map<string, number>();

  /** `barsOf` hands the bars of a row to `put`, one after another; later ones lie on top. */
  draw(wide: number, rows: number, barsOf: (row: number, put: Put) => void): HTMLCanvasElement {
    if (this.image?.width !== wide || this.image.height !== rows) {
      [this.canvas.width, this.canvas.height] = [wide, rows];
      this.image = this.pen.createImageData(wide, rows);
    }
    const pixels = new Uint32Array(this.image.data.buffer);
    pixels.fill(0);
    for (let row = 0; row < rows; ++row) {
      barsOf(row, (from, long, colour, faint) => {
        const first = Math.round(from);
        const end = Math.max(first + 1, Math.round(from + long));
        if (first >= wide || end <= 0) {
          return;
        }
        let pixel = this.known.get(colour);
        if (pixel === undefined) {
          pixel = pixelOf(colour);
          this.known.set(colour, pixel);
        }
        pixels.fill(
          faint ? pixel & faintly : pixel,
          row * wide + Math.max(0, first),
          row * wide + Math.min(wide, end),
        );
      });
    }
    this.pen.putImageData(this.image, 0, 0);
    return this.canvas;
  }
}
