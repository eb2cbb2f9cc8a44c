// When things are there, from step to step, and what is chosen of them.
import { announce } from '../lib/dom';

/** One or two elements and a range of steps: each view shows them and may change them. */
export class Choice {
  /** None, one or two elements. */
  elements: number[] = [];
  /** A range of blocks, from 1; null: all. */
  range: { from: number; to: number } | null = null;
  private readonly listeners = new Set<() => void>();

  name(x: number): string {
    return String(x);
  }

  /** Keeps what is chosen somewhere. */
  protected remember(): void {
    // Nowhere, unless a page has a place for it.
  }

  /** The same for what may change with each frame. */
  protected rememberSoon(): void {
    this.remember();
  }

  /** Calls back at each change until `signal` is aborted. */
  follow(signal: AbortSignal, listener: () => void): void {
    this.listeners.add(listener);
    signal.addEventListener('abort', () => this.listeners.delete(listener));
  }

  /** A first element, a second to it; one that is chosen already goes; a third starts again. */
  toggle(x: number): void {
    this.choose(
      this.elements.includes(x)
        ? this.elements.filter((each) => each !== x)
        : this.elements.length === 2
          ? [x]
          : [...this.elements, x],
    );
  }

  choose(elements: number[]): void {
    this.elements = elements;
    this.remember();
    this.tell();
    announce(
      elements.length === 0
        ? 'Nothing selected'
        : elements.length === 1
          ? `${this.name(elements[0]!)} selected`
          : `Pair ${elements.map((x) => this.name(x)).join(', ')} selected`,
    );
  }

  setRange(range: { from: number; to: number } | null): void {
    const same = this.range?.from === range?.from && this.range?.to === range?.to;
    this.range = range;
    if (!same) {
      this.rememberSoon();
      this.tell();
    }
  }

  private tell(): void {
    this.listeners.forEach((listener) => listener());
  }
}

/** When each element is there: stays as [first block, last block], from 1. */
export class Stays {
  private readonly list: [number, number][][];

  constructor({ v, blocks }: { v: number; blocks: readonly (readonly number[])[] }) {
    this.list = Array.from({ length: v }, () => []);
    blocks.forEach((block, i) => {
      for (const x of block) {
        const mine = this.list[x]!;
        const last = mine.at(-1);
        last && last[1] === i ? (last[1] = i + 1) : mine.push([i + 1, i + 1]);
      }
    });
  }

  of(x: number): readonly [number, number][] {
    return this.list[x]!;
  }

  /** The stay that contains a block, if there is one. */
  at(x: number, block: number): [number, number] | null {
    const found = this.list[x]![this.from(x, block)];
    return found && found[0] <= block ? found : null;
  }

  /** Index of the first stay that does not end before a block. */
  from(x: number, block: number): number {
    const mine = this.list[x]!;
    let low = 0;
    let high = mine.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      mine[middle]![1] < block ? (low = middle + 1) : (high = middle);
    }
    return low;
  }

  /** Where two elements are together. */
  shared(x: number, y: number): [number, number][] {
    const [a, b] = [this.list[x]!, this.list[y]!];
    const found: [number, number][] = [];
    for (let i = 0, j = 0; i < a.length && j < b.length;) {
      const from = Math.max(a[i]![0], b[j]![0]);
      const to = Math.min(a[i]![1], b[j]![1]);
      if (from <= to) {
        found.push([from, to]);
      }
      a[i]![1] < b[j]![1] ? ++i : ++j;
    }
    return found;
  }
}
