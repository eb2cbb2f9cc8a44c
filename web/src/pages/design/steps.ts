// What happens from block to block: who enters, who leaves, in which slot of a memory of k, and which pairs meet anew.
import type { Design } from '../../lib/api';

/** Of how many elements first meetings are kept pair by pair; beyond, pairs are only counted. */
export const mostMapped = 512;
/** Beyond so many elements pairs are not counted either: that would take more memory than a page should. */
const mostCounted = 20_000;
const every = 64;

export interface Step {
  /** From 1. */
  number: number;
  /** Slot by slot, −1 where nothing is. */
  slots: Int32Array;
  /** Elements that were not in the block before; of the first block all. */
  entered: number[];
  /** Elements of the block before that are not in this one. */
  left: number[];
}

export class Steps {
  readonly b: number;
  readonly v: number;
  readonly names: string[];
  /** The element with that number in each place of each block. */
  private readonly flat: Int32Array;
  private readonly starts: Int32Array;
  /** The slots after every 64th block. */
  private readonly kept: Int32Array[] = [];
  private width = 0;
  /** pairs[n] is the number of pairs that are together in one of the first n blocks. */
  readonly pairs: Int32Array | null;
  /** first[x·v + y] is the first block with x and y, 0 if there is none; for few elements only. */
  readonly first: Int32Array | null;

  constructor(design: Pick<Design, 'v' | 'blocks' | 'labels'>) {
    const { blocks } = design;
    this.b = blocks.length;
    const index = new Map<string, number>();
    if (design.labels) {
      design.labels.forEach((label, i) => index.set(label, i));
      this.names = [...design.labels];
    } else {
      this.names = Array.from({ length: design.v }, (_, i) => String(i));
      this.names.forEach((name, i) => index.set(name, i));
    }
    const number = (element: number | string): number => {
      const name = String(element);
      let found = index.get(name);
      if (found === undefined) {
        found = this.names.length;
        index.set(name, found);
        this.names.push(name);
      }
      return found;
    };
    this.starts = new Int32Array(this.b + 1);
    let total = 0;
    blocks.forEach((block, i) => {
      total += block.length;
      this.width = Math.max(this.width, block.length);
      this.starts[i + 1] = total;
    });
    this.flat = new Int32Array(total);
    let at = 0;
    const numbered = !design.labels;
    for (const block of blocks) {
      for (const element of block) {
        this.flat[at++] = numbered && typeof element === 'number' && element >= 0 && element < design.v ? element : number(element);
      }
    }
    this.v = this.names.length;
    this.first = this.v <= mostMapped ? new Int32Array(this.v * this.v) : null;
    this.pairs = this.v <= mostCounted ? new Int32Array(this.b + 1) : null;
    this.walk();
  }

  /** The elements of block n, from 1. */
  block(n: number): Int32Array {
    return this.flat.subarray(this.starts[n - 1], this.starts[n]);
  }

  get allPairs(): number {
    return (this.v * (this.v - 1)) / 2;
  }

  private walk(): void {
    const met = this.first || !this.pairs ? null : new Uint8Array(Math.ceil((this.v * this.v) / 8));
    let count = 0;
    let slots: Int32Array = new Int32Array(this.width).fill(-1);
    for (let n = 1; n <= this.b; ++n) {
      const { entered } = this.advance(n, slots);
      if (n % every === 0) {
        this.kept.push(slots.slice());
      }
      if (!this.pairs) {
        continue;
      }
      const block = this.block(n);
      for (const x of entered) {
        for (const y of block) {
          if (x === y) {
            continue;
          }
          const place = x < y ? x * this.v + y : y * this.v + x;
          if (this.first) {
            if (this.first[place] === 0) {
              this.first[place] = n;
              this.first[x < y ? y * this.v + x : x * this.v + y] = n;
              ++count;
            }
          } else if ((met![place >> 3]! & (1 << (place & 7))) === 0) {
            met![place >> 3]! |= 1 << (place & 7);
            ++count;
          }
        }
      }
      this.pairs[n] = count;
    }
  }

  /** Puts block n into the slots, which hold the block before: who enters takes the place of one who leaves. */
  private advance(n: number, slots: Int32Array): { entered: number[]; left: number[] } {
    const block = this.block(n);
    const now = new Set(block);
    const free: number[] = [];
    const left: number[] = [];
    const stayed = new Set<number>();
    for (let i = 0; i < slots.length; ++i) {
      const element = slots[i]!;
      if (element >= 0 && now.has(element)) {
        stayed.add(element);
      } else {
        if (element >= 0) {
          left.push(element);
        }
        free.push(i);
        slots[i] = -1;
      }
    }
    const entered: number[] = [];
    for (const element of block) {
      if (!stayed.has(element)) {
        entered.push(element);
        stayed.add(element);
        slots[free[entered.length - 1]!] = element;
      }
    }
    return { entered, left };
  }

  step(n: number): Step {
    const before = Math.floor((n - 1) / every);
    const slots = before > 0 ? this.kept[before - 1]!.slice() : new Int32Array(this.width).fill(-1);
    let change: { entered: number[]; left: number[] } = { entered: [], left: [] };
    for (let i = before * every + 1; i <= n; ++i) {
      change = this.advance(i, slots);
    }
    return { number: n, slots, ...change };
  }

  /** Pairs that meet for the first time in block n. */
  newPairs(n: number): number | null {
    return this.pairs ? this.pairs[n]! - this.pairs[n - 1]! : null;
  }
}
