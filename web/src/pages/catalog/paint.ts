// What the colours of the map say, and the legend that says it.
import { colourBar } from '../../lib/canvas';
import type { Atlas, AtlasCell } from '../../lib/atlas';
import { token } from '../../lib/canvas';
import { hues, scale } from '../../lib/colours';
import { h } from '../../lib/dom';
import { theme } from '../../shell/theme';

export const measures: readonly (readonly [string, string])[] = [
  ['ratio', 'blocks / bound'],
  ['gap', 'blocks − bound'],
  ['status', 'status'],
  ['construction', 'construction'],
];

interface Ink {
  text: string;
  faint: string;
  line: string;
  ground: string;
  accent: string;
  font: string;
}

export interface Paint {
  readonly ink: Ink;
  of(cell: AtlasCell): string;
  readonly legend: HTMLElement;
}

function key(colour: string, words: string): HTMLElement {
  const square = h('span', { class: 'legend-key' });
  square.style.background = colour;
  return h('li', {}, square, words);
}

/** More constructions than this share one colour. */
const mostHues = 10;

/** `bounds`: the map says how many blocks a design would have at least where none is known. */
export function paintOf(atlas: Atlas, measure: string, bounds = true): Paint {
  const ink: Ink = {
    text: token('--text'),
    faint: token('--faint'),
    line: token('--line'),
    ground: token('--ground'),
    accent: token('--mark'),
    font: token('--text-font'),
  };
  const settled = token('--settled');
  const open = token('--sunken');
  const none = (cell: AtlasCell): string | null =>
    cell.b === null ? open : cell.gap === 0 ? settled : null;
  const minimum = key(settled, 'proved minimum');
  const lacks =
    atlas.cells().some(({ status }) => status === 'open') &&
    key(open, `no design known${bounds ? '; in italics its bound' : ''}`);
  const blank =
    atlas.cells().some(({ status }) => status === 'impossible') &&
    key('transparent', 'blank: there can be none');
  if (measure === 'construction') {
    const often = new Map<string, number>();
    for (const cell of atlas.cells()) {
      if (cell.construction) {
        often.set(cell.construction, (often.get(cell.construction) ?? 0) + 1);
      }
    }
    const names = [...often].sort(([, a], [, b]) => b - a).map(([name]) => name);
    const colours = hues(mostHues + 1, theme());
    const number = new Map(names.map((name, i) => [name, Math.min(i, mostHues)]));
    return {
      ink,
      of: (cell) => (cell.construction === null ? open : colours[number.get(cell.construction)!]!),
      legend: h(
        'ul',
        { class: 'legend' },
        names.slice(0, mostHues).map((name, i) => key(colours[i]!, name)),
        names.length > mostHues && key(colours[mostHues]!, `${names.length - mostHues} others`),
        blank,
      ),
    };
  }
  const colours = scale(theme());
  if (measure === 'status') {
    const best = colours[Math.floor(colours.length * 0.3)]!;
    return {
      ink,
      of: (cell) => none(cell) ?? best,
      legend: h('ul', { class: 'legend' }, minimum, key(best, 'best known'), lacks, blank),
    };
  }
  const value = (cell: AtlasCell): number =>
    measure === 'gap' ? cell.gap! : cell.b! / cell.lower! - 1;
  const values = atlas
    .cells()
    .filter((cell) => cell.gap !== null && cell.gap > 0)
    .map(value)
    .sort((a, b) => a - b);
  // Half by rank, half by size: the whole scale is used, and what is twice as far off still looks
  // further.
  const top = values[Math.floor((values.length - 1) * 0.995)] ?? 1;
  const place = (x: number): number => {
    let low = 0;
    let high = values.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      values[middle]! < x ? (low = middle + 1) : (high = middle);
    }
    return 0.5 * (low / Math.max(1, values.length)) + 0.5 * Math.sqrt(Math.min(1, x / top));
  };
  const at = (x: number): string =>
    colours[Math.min(colours.length - 1, Math.floor(place(x) * colours.length))]!;
  const known = new Map<number, string>();
  const ends = [
    values[0] ?? 0,
    values.find((x) => place(x) >= 0.5) ?? 0,
    values.at(-1) ?? 0,
  ] as const;
  const said = (x: number): string =>
    measure === 'gap' ? `+${x}` : (1 + x).toFixed(x < 0.1 ? 3 : 2);
  const bar = colourBar(colours);
  return {
    ink,
    of(cell) {
      const plain = none(cell);
      if (plain !== null) {
        return plain;
      }
      const x = value(cell);
      const found = known.get(x) ?? at(x);
      known.set(x, found);
      return found;
    },
    legend: h(
      'ul',
      { class: 'legend' },
      minimum,
      values.length > 0 &&
        h(
          'li',
          { class: 'legend-scale' },
          measure === 'gap' ? 'blocks − bound' : 'blocks / bound',
          h(
            'span',
            { class: 'legend-ticks' },
            bar,
            h('span', {}, said(ends[0])),
            h('span', {}, said(ends[1])),
            h('span', {}, said(ends[2])),
          ),
        ),
      lacks,
      blank,
    ),
  };
}
