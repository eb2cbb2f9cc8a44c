// What simple orders cost, to compare with: all pairs of P items, C of them in memory at once.

import { count } from '../../lib/words';

export interface Naive {
  name: string;
  how: string;
  loads: number;
}

/**
 * `stay` items stay while all later ones pass through what is left of the memory; then the next
 * `stay` are loaded.
 */
export function nestedLoops(items: number, stay: number): number {
  let loads = 0;
  for (let from = 0; from < items; from += stay) {
    loads += items - from;
  }
  return loads;
}

const stay = (n: number): string => `${count(n, 'item')} ${n === 1 ? 'stays' : 'stay'}`;

export function naive(items: number, room: number): Naive[] {
  if (items <= room) {
    return [];
  }
  const half = Math.floor(room / 2);
  return [
    {
      name: 'halves',
      how: `${stay(half)}, the others pass ${room - half} at a time`,
      loads: nestedLoops(items, half),
    },
    {
      name: 'block nested loops',
      how: `${stay(room - 1)}, the others pass one by one`,
      loads: nestedLoops(items, room - 1),
    },
    {
      name: 'pair by pair',
      how: 'both items of every pair are loaded for it',
      loads: items * (items - 1),
    },
  ];
}

const units: Record<string, number> = {
  '': 1,
  b: 1,
  byte: 1,
  bytes: 1,
  k: 1e3,
  kb: 1e3,
  m: 1e6,
  mb: 1e6,
  g: 1e9,
  gb: 1e9,
  t: 1e12,
  tb: 1e12,
  kib: 2 ** 10,
  mib: 2 ** 20,
  gib: 2 ** 30,
  tib: 2 ** 40,
};

/** "512 MB", "1.5 GiB", "4096". @throws Error with a line that can be shown. */
export function bytesOf(text: string): number {
  const found = /^\s*(\d+(?:\.\d+)?)\s*([a-z]*)\s*$/i.exec(text);
  const unit = units[found?.[2]?.toLowerCase() ?? '?'];
  if (!found || unit === undefined) {
    throw new Error(
      `“${text}” is not a size: write bytes, or a number with kB, MB, GB, KiB, MiB or GiB`,
    );
  }
  return Math.round(Number(found[1]) * unit);
}
