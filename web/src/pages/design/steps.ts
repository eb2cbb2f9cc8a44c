// What happens from block to block: who enters, who leaves, in which slot of a memory of k, and
// which pairs are newly covered.
import type { Design } from '../../lib/api';
import { indexed } from '../../lib/words';

/** Of how many elements first meetings are kept pair by pair; beyond, pairs are only counted. */
export const mostMapped = 512;
/**
 * Beyond so many elements pairs are not counted either: that would take more memory than a page
 * should.
 */
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
  readonly v: number;
  readonly k: number;
  readonly b: number;
  readonly names: string[];
  /** pairs[n] is the number of pairs that are together in one of the first n blocks. */
  readonly pairs: Int32Array | null;
  /** first[x·v + y] is the first block with x and y, 0 if there is none; for few elements only. */
  readonly first: Int32Array | null;

  /** The elements of one block after the other. */
  private readonly flat: Int32Array;
  /** The slots after every 64th block. */
  private readonly kept: Int32Array[] = [];
  private readonly slots: Int32Array;
  private met: Uint8Array | null;
  private readonly mark: Int32Array;
  private stamp = 0;
  /** Blocks that are walked through. */
  private walked = 0;

  private constructor({ v, blocks, labels }: Pick<Design, 'v' | 'blocks' | 'labels'>) {
    this.v = v;
    this.b = blocks.length;
    this.k = blocks[0]?.length ?? 0;
    this.names = labels?.map(indexed) ?? Array.from({ length: v }, (_, i) => String(i));
    this.flat = Int32Array.from(blocks.flat());
    this.first = v <= mostMapped ? new Int32Array(v * v) : null;
    this.pairs = v <= mostCounted ? new Int32Array(this.b + 1) : null;
    this.met = this.first || !this.pairs ? null : new Uint8Array(Math.ceil((v * v) / 8));
    this.mark = new Int32Array(v);
    this.slots = new Int32Array(this.k).fill(-1);
  }

  /** All at once. */
  static of(design: Pick<Design, 'v' | 'blocks' | 'labels'>): Steps {
    const steps = new Steps(design);
    while (!steps.work(Infinity)) {
      // work() does it all.
    }
    return steps;
  }

  /**
   * In pieces of some milliseconds, so that a page with a long design does not freeze. `progress`
   * is told shares from 0 to 1.
   */
  static async soon(
    design: Pick<Design, 'v' | 'blocks' | 'labels'>,
    signal: AbortSignal,
    progress: (share: number) => void,
  ): Promise<Steps> {
    const steps = new Steps(design);
    while (!steps.work(performance.now() + 25)) {
      progress(steps.walked / steps.b);
      await new Promise((resolve) => setTimeout(resolve, 0));
      signal.throwIfAborted();
    }
    return steps;
  }

  /** Goes on until `deadline`; true when all is done. */
  private work(deadline: number): boolean {
    const late = (i: number): boolean => i % 64 === 0 && performance.now() > deadline;
    for (; this.walked < this.b; ++this.walked) {
      if (late(this.walked + 1)) {
        return false;
      }
      this.walkTo(this.walked + 1);
    }
    this.met = null;
    return true;
  }

  /** The elements of block n, from 1. */
  block(n: number): Int32Array {
    return this.flat.subarray((n - 1) * this.k, n * this.k);
  }

  get allPairs(): number {
    return (this.v * (this.v - 1)) / 2;
  }

  private walkTo(n: number): void {
    const { entered } = this.advance(n, this.slots);
    if (n % every === 0) {
      this.kept.push(this.slots.slice());
    }
    if (!this.pairs) {
      return;
    }
    const { v, first, met } = this;
    const block = this.block(n);
    let count = this.pairs[n - 1]!;
    for (const x of entered) {
      for (const y of block) {
        if (x === y) {
          continue;
        }
        const place = x < y ? x * v + y : y * v + x;
        if (first) {
          if (first[place] === 0) {
            first[place] = n;
            first[x < y ? y * v + x : x * v + y] = n;
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

  /**
   * Puts block n into the slots, which hold the block before: who enters takes the place of one who
   * leaves.
   */
  private advance(n: number, slots: Int32Array): { entered: number[]; left: number[] } {
    const block = this.block(n);
    const { mark } = this;
    const inBlock = ++this.stamp;
    const inSlots = ++this.stamp;
    for (const element of block) {
      mark[element] = inBlock;
    }
    const free: number[] = [];
    const left: number[] = [];
    for (let i = 0; i < slots.length; ++i) {
      const element = slots[i]!;
      if (element >= 0 && mark[element] === inBlock) {
        mark[element] = inSlots;
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
      if (mark[element] !== inSlots) {
        mark[element] = inSlots;
        slots[free[entered.length]!] = element;
        entered.push(element);
      }
    }
    return { entered, left };
  }

  step(n: number): Step {
    const before = Math.floor((n - 1) / every);
    const slots = before > 0 ? this.kept[before - 1]!.slice() : new Int32Array(this.k).fill(-1);
    let change: { entered: number[]; left: number[] } = { entered: [], left: [] };
    for (let i = before * every + 1; i <= n; ++i) {
      change = this.advance(i, slots);
    }
    return { number: n, slots, ...change };
  }
}
