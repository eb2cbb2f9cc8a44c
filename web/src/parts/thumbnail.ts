// A design at a glance: a row for each element, in the order of their first blocks, a bar for each
// stay.
import type { Design } from '../lib/api';
import { token } from '../lib/canvas';
import { h } from '../lib/dom';

/** Elements in the order in which they are introduced. */
export function byFirst(blocks: readonly (readonly number[])[], v: number): number[] {
  const order: number[] = [];
  const seen = new Uint8Array(v);
  for (const block of blocks) {
    for (const x of block) {
      if (!seen[x]) {
        seen[x] = 1;
        order.push(x);
      }
    }
  }
  for (let x = 0; x < v; ++x) {
    if (!seen[x]) {
      order.push(x);
    }
  }
  return order;
}

export function thumbnail(
  { v, blocks }: Pick<Design, 'v' | 'blocks'>,
  words: string,
  signal: AbortSignal,
): HTMLCanvasElement {
  const [width, height] = [520, 320];
  const canvas = h('canvas', {
    width,
    height,
    class: 'thumbnail',
    role: 'img',
    'aria-label': words,
  });
  const row = new Int32Array(v);
  byFirst(blocks, v).forEach((x, i) => (row[x] = i));
  function draw(): void {
    const pen = canvas.getContext('2d');
    if (!pen) {
      return;
    }
    pen.fillStyle = token('--ground');
    pen.fillRect(0, 0, width, height);
    const [w, high] = [width / blocks.length, height / v];
    const gap = high > 3 ? 1 : 0;
    const [kept, fresh] = [token('--met'), token('--accent')];
    blocks.forEach((block, i) => {
      const before = i > 0 ? new Set(blocks[i - 1]) : null;
      for (const x of block) {
        pen.fillStyle = before?.has(x) ? kept : fresh;
        pen.fillRect(i * w, row[x]! * high, Math.max(w, 0.7), Math.max(high - gap, 0.7));
      }
    });
  }
  draw();
  document.addEventListener('themechange', draw, { signal });
  return canvas;
}
