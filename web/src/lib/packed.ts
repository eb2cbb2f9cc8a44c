// Designs of a static export: many in one small file, step by step.
// apps/changeover/serve/export/packed_designs.hpp has the format.
import type { Design } from './api';

type Head = Omit<Design, 'blocks'> & { label: string; way: 'steps' | 'blocks'; at: number };

/** The designs of a file, by their labels; blocks are made when a design is asked for. */
export class PackedShelf {
  private readonly heads = new Map<string, Head>();
  private readonly bytes: Uint8Array;

  constructor(file: Uint8Array) {
    const end = file.indexOf(10);
    for (const head of JSON.parse(new TextDecoder().decode(file.subarray(0, end))) as Head[]) {
      this.heads.set(head.label, head);
    }
    this.bytes = file.subarray(end + 1);
  }

  labels(): string[] {
    return [...this.heads.keys()];
  }

  /** A whole label, or the beginning of one that only one design has. */
  find(label: string): Design | null {
    const known = this.heads.get(label) ?? this.only(label);
    return known ? this.unpacked(known) : null;
  }

  private only(beginning: string): Head | undefined {
    const found = [...this.heads.values()].filter((head) => head.label.startsWith(`${beginning}.`));
    return found.length === 1 ? found[0] : undefined;
  }

  private unpacked({ way, at, ...head }: Head): Design {
    const { v, k, change: m } = head;
    const wide = v > 256;
    const view = new DataView(this.bytes.buffer, this.bytes.byteOffset, this.bytes.byteLength);
    let place = at;
    const next = (): number => {
      const value = wide ? view.getUint16(place, true) : view.getUint8(place);
      place += wide ? 2 : 1;
      return value;
    };
    const row = (length: number): number[] => Array.from({ length }, next);
    const b = head.verdict!.b;
    if (way === 'blocks') {
      let last = new Array<number>(k).fill(0);
      return {
        ...head,
        blocks: Array.from(
          { length: b },
          () => (last = row(k).map((step, j) => (last[j]! + step) % v)),
        ),
      };
    }
    const memory = row(k);
    const columns = Array.from({ length: m }, () => ({ places: row(b - 1), elements: row(b - 1) }));
    const ordered = (): number[] => [...memory].sort((x, y) => x - y);
    const blocks = [ordered()];
    const before = new Array<number>(m).fill(0);
    for (let i = 0; i + 1 < b; ++i) {
      columns.forEach(({ places, elements }, j) => {
        before[j] = (before[j]! + elements[i]!) % v;
        memory[places[i]!] = before[j]!;
      });
      blocks.push(ordered());
    }
    return { ...head, blocks };
  }
}
