// The symmetries of a design: which rotations of its blocks extend to its elements, and which
// elements are twins.
//
// An element is known by its column, the list of blocks that contain it. A rotation by s blocks is
// an automorphism exactly if every column moved by s is a column again; the smallest such s divides
// the number of blocks.
import type { Design } from './api';
import { count, number } from './words';

export interface Symmetry {
  /** Rotations of the blocks that extend to the elements, the identity among them. */
  rotations: number;
  /**
   * By how many blocks the smallest of them turns; the number of blocks if there is only the
   * identity.
   */
  shift: number;
  /** What it does to the elements. */
  map: Int32Array;
  /** Classes of two or more elements that are in the same blocks. */
  twins: number[][];
  /** Of the group, in decimal. */
  order: string;
}

/** Beyond so many elements in all blocks together, a page does not look. */
export const mostLooked = 2_000_000;

export function symmetryOf({ v, kind, blocks }: Pick<Design, 'v' | 'kind' | 'blocks'>): Symmetry {
  const b = blocks.length;
  const columns: number[][] = Array.from({ length: v }, () => []);
  blocks.forEach((block, i) => block.forEach((x) => columns[x]!.push(i)));
  const byColumn = new Map<string, number[]>();
  columns.forEach((column, x) => {
    const key = column.join();
    const same = byColumn.get(key);
    same ? same.push(x) : byColumn.set(key, [x]);
  });
  const twins = [...byColumn.values()].filter((same) => same.length > 1);

  function moved(shift: number): Int32Array | null {
    const map = new Int32Array(v);
    for (const same of byColumn.values()) {
      const column = columns[same[0]!]!;
      const cut = column.findIndex((i) => i + shift >= b);
      const turned =
        cut < 0
          ? column.map((i) => i + shift)
          : [
              ...column.slice(cut).map((i) => i + shift - b),
              ...column.slice(0, cut).map((i) => i + shift),
            ];
      const to = byColumn.get(turned.join());
      if (to?.length !== same.length) {
        return null;
      }
      same.forEach((x, j) => (map[x] = to[j]!));
    }
    return map;
  }

  let shift = b;
  let map: Int32Array | null = null;
  for (let s = 1; kind === 'circular' && s < b && !map; ++s) {
    if (b % s === 0) {
      map = moved(s);
      shift = map ? s : b;
    }
  }
  let order = BigInt(b > 0 ? b / shift : 1);
  for (const same of twins) {
    for (let n = 2; n <= same.length; ++n) {
      order *= BigInt(n);
    }
  }
  return {
    rotations: b > 0 ? b / shift : 1,
    shift,
    map: map ?? Int32Array.from({ length: v }, (_, x) => x),
    twins,
    order: order.toString(),
  };
}

/** The order of the group; a long one by its power of ten. */
export const orderWords = ({ order }: Symmetry): string =>
  order.length > 15 ? `about 10^${order.length - 1}` : number(Number(order));

/** "order 7, 7 rotations". */
export const groupWords = (symmetry: Symmetry): string =>
  `order ${orderWords(symmetry)}` +
  (symmetry.rotations > 1 ? `, ${count(symmetry.rotations, 'rotation')}` : '');

/** The cycles of a map, the longest first. */
export function cyclesOf(map: Int32Array): number[][] {
  const seen = new Uint8Array(map.length);
  const cycles: number[][] = [];
  for (let start = 0; start < map.length; ++start) {
    const cycle: number[] = [];
    for (let x = start; !seen[x]; x = map[x]!) {
      seen[x] = 1;
      cycle.push(x);
    }
    if (cycle.length > 0) {
      cycles.push(cycle);
    }
  }
  return cycles.sort((a, b) => b.length - a.length);
}
