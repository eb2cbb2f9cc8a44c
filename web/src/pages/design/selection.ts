// What is chosen of a design, for all views of it: an element or a pair, and a range of blocks.
// Each view shows it and may change it.
import type { Design } from '../../lib/api';
import { number } from '../../lib/words';
import { Choice, type Stays } from '../../parts/stays';
import type { View } from '../../shell/router';
import type { Steps } from './steps';

export class Chosen extends Choice {
  constructor(
    private readonly view: View,
    readonly design: Design,
  ) {
    super();
    const names = (view.params.get('sel') ?? '').split('~').filter(Boolean);
    const indices = names.map((name) => this.index(name)).filter((x) => x >= 0);
    this.elements = [...new Set(indices)].slice(0, 2);
    const [from, to] = [Number(view.params.get('from')), Number(view.params.get('to'))];
    const b = design.blocks.length;
    if (Number.isInteger(from) && Number.isInteger(to) && from >= 1 && to >= from && from <= b) {
      this.range = { from, to: Math.min(b, to) };
    }
  }

  override name(x: number): string {
    return this.design.labels?.[x] ?? String(x);
  }

  /** "3" or "3 7", by names. What is wrong with them; empty if they are chosen. */
  chooseByName(text: string): string {
    const names = text.split(/[\s,]+/).filter(Boolean);
    const found = names.map((name) => this.index(name));
    const none = found.findIndex((x) => x < 0);
    if (none >= 0) {
      return this.design.labels
        ? `No element is named “${names[none]}”.`
        : `Elements are 0 to ${this.design.v - 1}.`;
    }
    if (found.length > 2) {
      return 'Write one element, or two.';
    }
    this.choose([...new Set(found)]);
    return '';
  }

  private index(name: string): number {
    const at = this.design.labels
      ? this.design.labels.indexOf(name)
      : /^\d+$/.test(name)
        ? Number(name)
        : -1;
    return at < this.design.v ? at : -1;
  }

  protected override remember(): void {
    const { elements, range } = this;
    this.view.go(
      {
        sel: elements.length > 0 ? elements.map((x) => this.name(x)).join('~') : null,
        from: range?.from ?? null,
        to: range?.to ?? null,
      },
      { quiet: true },
    );
  }

  /** Browsers refuse links that change with each frame of a drag. */
  private note = 0;
  protected override rememberSoon(): void {
    window.clearTimeout(this.note);
    this.note = window.setTimeout(() => !this.view.signal.aborted && this.remember(), 150);
  }

  /** In words: where an element is, when a pair meets. */
  words(steps: Steps, stays: Stays): string {
    const [x, y] = this.elements;
    if (x === undefined) {
      return '';
    }
    if (y === undefined) {
      const mine = stays.of(x);
      const blocks = mine.reduce((sum, [from, to]) => sum + to - from + 1, 0);
      return (
        `${this.name(x)} is in ${number(blocks)} of ${number(steps.b)} blocks, in ` +
        `${number(mine.length)} ${mine.length === 1 ? 'stay' : 'stays'}`
      );
    }
    const shared = stays.shared(x, y);
    const times = shared.reduce((sum, [from, to]) => sum + to - from + 1, 0);
    return shared.length === 0
      ? `${this.name(x)} and ${this.name(y)} are never together`
      : `${this.name(x)} and ${this.name(y)} are first together in block ` +
          `${number(shared[0]![0])}; together in ${number(times)} ` +
          `${times === 1 ? 'block' : 'blocks'}, newly covered ` +
          `${shared.length === 1 ? 'once' : `${number(shared.length)} times`}`;
  }
}
