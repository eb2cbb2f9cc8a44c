// All cells of one change number, kind and strength, as the map of the catalog holds them: columns,
// by k, then v.
import type { AtlasDocument, GroupsDocument, Kind } from './api';

export interface Selection {
  change: number;
  kind: Kind;
  strength: number;
}

export interface AtlasCell extends Selection {
  v: number;
  k: number;
  b: number | null;
  lower: number | null;
  /** Blocks over the lower bound. */
  gap: number | null;
  status: 'minimum' | 'best-known' | 'open' | 'impossible';
  construction: string | null;
  label: string | null;
  tight: boolean;
  economical: boolean;
  /** Of its automorphism group, in decimal; null while that is not known. */
  order: string | null;
}

/** C(n, t) for small t. */
export function choose(n: number, t: number): number {
  let product = 1;
  for (let i = 0; i < t; ++i) {
    product = (product * (n - i)) / (i + 1);
  }
  return n < t ? 0 : product;
}

/**
 * Whether so many blocks newly cover every t-subset exactly once, and whether they are as many as
 * counting asks for at least.
 */
export function counted(cell: {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength: number;
  b: number;
}): { tight: boolean; economical: boolean } {
  const { v, k, change, kind, strength: t, b } = cell;
  const all = choose(v, t);
  const first = kind === 'linear' ? choose(k, t) : 0;
  const each = choose(k, t) - choose(k - change, t);
  const steps = kind === 'linear' ? b - 1 : b;
  if (v === k || b < 2) {
    return { tight: b === 1 && v === k, economical: b === 1 };
  }
  return {
    tight: first + steps * each === all,
    economical: steps === Math.ceil((all - first) / each),
  };
}

export class Atlas {
  readonly selection: Selection;
  readonly k: { from: number; to: number };
  readonly v: { from: number; to: number };
  readonly constructions: readonly string[];
  private orders: readonly (string | null)[] | null = null;
  /** Cells that were asked for: a map asks for all of them again and again. */
  private made: AtlasCell[] = [];

  constructor(private readonly document: AtlasDocument) {
    this.selection = { change: document.change, kind: document.kind, strength: document.strength };
    this.k = { from: document.k_from, to: document.k_to };
    this.v = { from: document.v_from, to: document.v_to };
    this.constructions = document.constructions;
  }

  get columns(): number {
    return this.v.to - this.v.from + 1;
  }

  get rows(): number {
    return this.k.to - this.k.from + 1;
  }

  get knowsGroups(): boolean {
    return this.orders !== null;
  }

  addGroups({ order }: GroupsDocument): void {
    this.orders = order;
    this.made = [];
  }

  has(v: number, k: number): boolean {
    return v >= this.v.from && v <= this.v.to && k >= this.k.from && k <= this.k.to;
  }

  cell(v: number, k: number): AtlasCell | null {
    if (!this.has(v, k)) {
      return null;
    }
    const i = (k - this.k.from) * this.columns + (v - this.v.from);
    return (this.made[i] ??= this.make(v, k, i));
  }

  private make(v: number, k: number, i: number): AtlasCell {
    const b = this.document.b[i] ?? null;
    const lower = this.document.lower_bound[i] ?? null;
    const by = this.document.construction[i] ?? null;
    const hash = this.document.label[i] ?? null;
    const { change, kind, strength } = this.selection;
    const facts =
      b === null
        ? { tight: false, economical: false }
        : counted({ v, k, change, kind, strength, b });
    return {
      v,
      k,
      change,
      kind,
      strength,
      b,
      lower,
      gap: b === null || lower === null ? null : b - lower,
      status:
        lower === null
          ? 'impossible'
          : b === null
            ? 'open'
            : b === lower
              ? 'minimum'
              : 'best-known',
      construction: by === null ? null : this.constructions[by]!,
      label:
        hash === null || b === null
          ? null
          : `${v}.${k}.${change}.${kind}${strength > 2 ? `.t${strength}` : ''}.${b}.${hash}`,
      ...facts,
      order: this.orders?.[i] ?? null,
    };
  }

  /** The cells of a window, by k, then v. */
  cells(k = this.k, v = this.v): AtlasCell[] {
    const found: AtlasCell[] = [];
    for (let row = Math.max(k.from, this.k.from); row <= Math.min(k.to, this.k.to); ++row) {
      for (
        let column = Math.max(v.from, this.v.from);
        column <= Math.min(v.to, this.v.to);
        ++column
      ) {
        found.push(this.cell(column, row)!);
      }
    }
    return found;
  }
}
