// What the map says: of a cell in words, and in the cell as far as there is room.
import type { AtlasCell } from '../../lib/atlas';
import { count } from '../../lib/words';

export type Written = 'b' | 'gap';

export function say(cell: AtlasCell): string {
  const known =
    cell.status === 'impossible'
      ? 'no design exists'
      : cell.b === null
        ? `no design is known, at least ${count(cell.lower ?? 0, 'block')}`
        : `${count(cell.b, 'block')}, ` +
          `${cell.status === 'minimum' ? 'minimum' : `lower bound ${cell.lower}`}`;
  return `v ${cell.v}, k ${cell.k}: ${known}`;
}

/** Letters are at least so high, in pixels. */
export const smallest = 8.5;
/** How wide a digit is, in heights of letters, and what is left free beside a number. */
const digit = 0.64;
const free = 3;

/** Whether one digit has room in cells that are so wide. */
export const mayFit = (wide: number): boolean => wide >= free + digit * smallest;

/**
 * The number in a cell and the height of its letters; null if it has no room. Where no design is
 * known it is the bound.
 */
export function inCell(
  cell: AtlasCell,
  written: Written,
  wide: number,
  highest: number,
): { text: string; size: number; bound: boolean } | null {
  const sizeOf = (text: string): number =>
    Math.min(highest, Math.floor(((wide - free) / (text.length * digit)) * 2) / 2);
  const bound = cell.b === null && written === 'b';
  if (written === 'gap' && cell.gap === null) {
    return null;
  }
  const text =
    written === 'b' ? String(cell.b ?? cell.lower) : cell.gap === 0 ? '=' : `+${cell.gap}`;
  const size = sizeOf(text);
  return size < smallest ? null : { text, size, bound };
}
