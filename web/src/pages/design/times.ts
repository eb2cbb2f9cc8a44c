// How often each pair of elements is newly covered.
import type { Design } from '../../lib/api';

/**
 * The block before block i, from 0. Before the first one of a circular design is the last, unless
 * it is the same: one block alone introduces all of its elements.
 */
export function blockBefore(
  blocks: readonly (readonly number[])[],
  i: number,
  circular: boolean,
): readonly number[] {
  return i > 0 ? blocks[i - 1]! : circular && blocks.length > 1 ? blocks.at(-1)! : [];
}

/**
 * How often each pair x, y is newly covered, at x·v + y and at y·v + x: it is together in a block
 * and was not in the block before. Takes 4·v² bytes and b·k² steps.
 */
export function timesOf({ v, kind, blocks }: Pick<Design, 'v' | 'kind' | 'blocks'>): Int32Array {
  const times = new Int32Array(v * v);
  const before = new Uint8Array(v);
  blocks.forEach((block, i) => {
    before.fill(0);
    blockBefore(blocks, i, kind === 'circular').forEach((x) => (before[x] = 1));
    block.forEach((x, at) => {
      for (let other = at + 1; other < block.length; ++other) {
        const y = block[other]!;
        if (!before[x] || !before[y]) {
          ++times[x * v + y]!;
          ++times[y * v + x]!;
        }
      }
    });
  });
  return times;
}
