// The cells of the map as a picture with a pixel each, which is enlarged: a square for each of
// thousands of cells takes longer than a frame may.
import type { Atlas, AtlasCell } from '../../lib/atlas';
import { pixelOf } from '../../lib/canvas';
import type { Paint } from './paint';

/** What is left of the colour of a cell that is not looked for: an eighth. */
const faintly = 0x1fffffff;

export class Pixels {
  private readonly canvas = document.createElement('canvas');
  private madeFor: readonly unknown[] = [];

  /** Made again where something that it depends on has changed. */
  of(
    atlas: Atlas,
    paint: Paint,
    passing: (cell: AtlasCell) => boolean,
    ...others: readonly unknown[]
  ): HTMLCanvasElement {
    const now = [atlas, paint, ...others];
    if (now.length !== this.madeFor.length || now.some((each, i) => each !== this.madeFor[i])) {
      this.madeFor = now;
      this.make(atlas, paint, passing);
    }
    return this.canvas;
  }

  private make(atlas: Atlas, paint: Paint, passing: (cell: AtlasCell) => boolean): void {
    [this.canvas.width, this.canvas.height] = [atlas.columns, atlas.rows];
    const pen = this.canvas.getContext('2d')!;
    const image = pen.createImageData(atlas.columns, atlas.rows);
    const pixels = new Uint32Array(image.data.buffer);
    const known = new Map<string, number>();
    atlas.cells().forEach((cell, i) => {
      if (cell.status === 'impossible') {
        return;
      }
      const colour = paint.of(cell);
      let pixel = known.get(colour);
      if (pixel === undefined) {
        pixel = pixelOf(colour);
        known.set(colour, pixel);
      }
      pixels[i] = passing(cell) ? pixel : pixel & faintly;
    });
    pen.putImageData(image, 0, 0);
  }
}
