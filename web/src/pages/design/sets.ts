// Which t elements are together in a block, for designs of strength t > 2: in which block each of
// these sets is first together, and how often it is newly covered.
import type { Design } from '../../lib/api';
import { choose } from '../../lib/atlas';
import { blockBefore } from './times';

/** More sets, or sets in blocks, than this are not counted in a page. */
const mostSets = 4_000_000;
const mostVisits = 20_000_000;

export class Sets {
  readonly all: number;
  /** met[n] is the number of sets that are together in one of the first n blocks. */
  readonly met: Int32Array;
  /** The first block with each set, by its rank; 0 if there is none. */
  readonly first: Int32Array;
  /** How often each is newly covered: it was not together in the block before. */
  readonly times: Uint16Array;
  /** binomial[i][n] is C(n, i + 1): the rank of c_0 < c_1 < … is the sum of binomial[i][c_i]. */
  private readonly binomial: Float64Array[];

  private constructor(
    readonly v: number,
    readonly t: number,
    private readonly blocks: readonly (readonly number[])[],
    circular: boolean,
  ) {
    this.all = choose(v, t);
    this.binomial = Array.from({ length: t }, (_, i) =>
      Float64Array.from({ length: v }, (_, n) => choose(n, i + 1)),
    );
    this.first = new Int32Array(this.all);
    this.times = new Uint16Array(this.all);
    this.met = new Int32Array(blocks.length + 1);
    const before = new Uint8Array(v);
    blocks.forEach((block, i) => {
      before.fill(0);
      blockBefore(blocks, i, circular).forEach((x) => (before[x] = 1));
      let fresh = 0;
      this.eachOf(block, (set, rank) => {
        if (!set.every((x) => before[x] === 1)) {
          ++this.times[rank]!;
        }
        if (this.first[rank] === 0) {
          this.first[rank] = i + 1;
          ++fresh;
        }
      });
      this.met[i + 1] = this.met[i]! + fresh;
    });
  }

  /** Null for pairs, which are counted elsewhere, and for what is too much for a page. */
  static of({ v, k, strength = 2, kind, blocks }: Design): Sets | null {
    return strength > 2 &&
      choose(v, strength) <= mostSets &&
      blocks.length * choose(k, strength) <= mostVisits
      ? new Sets(v, strength, blocks, kind === 'circular')
      : null;
  }

  /** The sets of t of these elements, each in increasing order, with their ranks. */
  eachOf(elements: ArrayLike<number>, visit: (set: readonly number[], rank: number) => void): void {
    const sorted = Array.from(elements).sort((a, b) => a - b);
    const set: number[] = [];
    const from = (start: number, rank: number): void => {
      if (set.length === this.t) {
        visit(set, rank);
        return;
      }
      for (let i = start; i <= sorted.length - (this.t - set.length); ++i) {
        const x = sorted[i]!;
        set.push(x);
        from(i + 1, rank + this.binomial[set.length - 1]![x]!);
        set.pop();
      }
    };
    from(0, 0);
  }

  /** The sets that are first together in block n. */
  fresh(n: number): number[][] {
    const found: number[][] = [];
    this.eachOf(this.blocks[n - 1]!, (set, rank) => {
      if (this.first[rank] === n) {
        found.push([...set]);
      }
    });
    return found;
  }

  /** How many sets have a pair. */
  get withPair(): number {
    return choose(this.v - 2, this.t - 2);
  }

  /** Of each pair x, y at x·v + y: how many sets with both are together in the first n blocks. */
  metByPair(n: number): Int32Array {
    return this.byPair((rank) => (this.first[rank]! > 0 && this.first[rank]! <= n ? 1 : 0));
  }

  /** The same: how often sets with both are newly covered beyond once. */
  excessByPair(): Int32Array {
    return this.byPair((rank) => Math.max(0, this.times[rank]! - 1));
  }

  /** The same: the block in which the last set with both is first together; 0 if one never is. */
  completeByPair(): Int32Array {
    const never = this.blocks.length + 1;
    const last = this.byPair((rank) => this.first[rank]! || never, Math.max);
    return last.map((n) => (n === never ? 0 : n));
  }

  /** A number for each pair out of numbers for the sets with both. */
  private byPair(
    of: (rank: number) => number,
    join = (sum: number, each: number): number => sum + each,
  ): Int32Array {
    const { v } = this;
    const sums = new Int32Array(v * v);
    this.eachOf(
      Array.from({ length: v }, (_, x) => x),
      (set, rank) => {
        const each = of(rank);
        for (let i = 0; each > 0 && i < set.length; ++i) {
          for (let j = 0; j < set.length; ++j) {
            if (i !== j) {
              const pair = set[i]! * v + set[j]!;
              sums[pair] = join(sums[pair]!, each);
            }
          }
        }
      },
    );
    return sums;
  }
}
