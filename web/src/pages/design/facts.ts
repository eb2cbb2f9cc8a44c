// A design in numbers: what a researcher asks of one. What each means is said on its name.
import type { CatalogEntry, Design } from '../../lib/api';
import { checksumOf } from '../../lib/checksum';
import { fill, h, type Child } from '../../lib/dom';
import { cellDetail } from '../../lib/source';
import { groupWords, orderWords, type Symmetry } from '../../lib/symmetry';
import { termsOf } from '../../lib/terms';
import { changeWord, count, indexed, number, setsOf } from '../../lib/words';
import { factName } from '../../parts/knowl';
import type { Stays } from '../../parts/stays';
import { badge } from '../../parts/status';
import { link } from '../../shell/router';
import { madeBy } from '../cell/designs';
import { timesOf } from './times';

/** So many pairs are named. */
const mostNamed = 6;
/** Of more elements in all blocks together pairs and subsets are not counted. */
const mostCounted = 400_000;
/** Nor of more elements: a number is kept for each pair. */
const mostPaired = 2_000;

const cellLink = ({ v, k, change, kind, strength }: Design): string =>
  link('cell', { v, k, change, kind, strength: strength === 2 ? null : strength });

/** "3 pairs newly covered twice: 2–5, 1–7, 0–3"; "12: newly covered again 2–5 (3×), 0–3 and 4 more pairs". */
function excessOf(design: Design): string | null {
  const { v, k, blocks, labels } = design;
  if ((design.strength ?? 2) !== 2 || v > mostPaired || blocks.length * k * k > mostCounted * 4) {
    return null;
  }
  const name = (x: number): string => indexed(labels?.[x] ?? String(x));
  const counts = timesOf(design);
  const again: [pair: number, times: number][] = [];
  counts.forEach((times, pair) => {
    if (times > 1 && Math.floor(pair / v) < pair % v) {
      again.push([pair, times]);
    }
  });
  const excess = again.reduce((sum, [, times]) => sum + times - 1, 0);
  if (excess === 0) {
    return '0';
  }
  const named = again
    .sort(([, one], [, other]) => other - one)
    .slice(0, mostNamed)
    .map(
      ([pair, times]) =>
        // No line ends within a pair.
        `${name(Math.floor(pair / v))}\u2060–\u2060${name(pair % v)}${times > 2 ? `\u00a0(${times - 1}×)` : ''}`,
    );
  const left = again.length - named.length;
  const twice = again[0]![1] === 2;
  return (
    (twice
      ? `${count(again.length, 'pair')} newly covered twice: `
      : `${number(excess)}: newly covered again `) +
    named.join(', ') +
    (left > 0 ? ` and ${twice ? `${number(left)} more` : count(left, 'more pair')}` : '')
  );
}

/** "3 elements have 2, 17 have 3". */
function staysOf({ v, kind, blocks }: Design, stays: Stays): string {
  const counts = new Map<number, number>();
  for (let x = 0; x < v; ++x) {
    const all = stays.of(x);
    // A stay of a circular design goes on from the last block to the first.
    const goesOn =
      kind === 'circular' && all.length > 1 && all[0]![0] === 1 && all.at(-1)![1] === blocks.length;
    const n = all.length - (goesOn ? 1 : 0);
    counts.set(n, (counts.get(n) ?? 0) + 1);
  }
  const all = [...counts].sort(([one], [other]) => one - other);
  const [least, most] = [all[0]![0], all.at(-1)![0]];
  return all.length > 5
    ? `${number(least)} to ${number(most)}`
    : all.map(([n, elements]) => `${count(elements, 'element')} with ${number(n)}`).join(', ');
}

/** How many of the unchanged subsets differ, and how many at most are disjoint, taken in turn. */
function unchangedOf({ kind, blocks, k, change, v }: Design): string | null {
  if (blocks.length < 2 || blocks.length * k > mostCounted || k === change) {
    return null;
  }
  const steps = kind === 'circular' ? blocks.length : blocks.length - 1;
  const subsets = new Map<string, number[]>();
  for (let i = 0; i < steps; ++i) {
    const next = new Set(blocks[(i + 1) % blocks.length]);
    const subset = blocks[i]!.filter((x) => next.has(x)).sort((x, y) => x - y);
    subsets.set(subset.join(), subset);
  }
  const used = new Set<number>();
  let disjoint = 0;
  for (const subset of subsets.values()) {
    if (subset.every((x) => !used.has(x))) {
      subset.forEach((x) => used.add(x));
      ++disjoint;
    }
  }
  return (
    `${number(subsets.size)} different ones, of ${count(k - change, 'element')} each; ` +
    `${number(disjoint)} of them, or more, have no element in common` +
    (used.size === v ? ', an expansion set' : '')
  );
}

/** The entry of the catalog that has this label. */
async function entryOf(design: Design, signal: AbortSignal): Promise<CatalogEntry | null> {
  if (!design.label) {
    return null;
  }
  const { designs } = await cellDetail(design, signal);
  return designs.find(({ label }) => label === design.label) ?? null;
}

/** What is known of a design at a glance, below its title. */
export function chips(design: Design, symmetry: Symmetry | null): HTMLElement | null {
  const { verdict } = design;
  if (!verdict?.valid) {
    return null;
  }
  const gap = design.blocks.length - verdict.lower_bound;
  const chip = (words: string): HTMLElement => h('span', { class: 'badge' }, words);
  return h(
    'p',
    { class: 'chips' },
    verdict.minimum === 'proved'
      ? badge('minimum')
      : chip(`${number(gap)} over the bound ${number(verdict.lower_bound)}`),
    verdict.tight && h('span', { class: 'badge good' }, 'tight'),
    !verdict.tight && verdict.economical && h('span', { class: 'badge good' }, 'economical'),
    symmetry && symmetry.order !== '1' && chip(`group of order ${orderWords(symmetry)}`),
  );
}

/** Who made it, or the construction that does. */
function sourceOf({ recipe }: Design, entry: CatalogEntry | null): Child[] {
  const construction = entry?.construction ?? recipe?.construction;
  return construction
    ? [...madeBy(construction), entry?.credit.who && `; ${entry.credit.who}`]
    : ['not known'];
}

export function facts(
  design: Design,
  stays: Stays,
  symmetry: Symmetry | null,
  signal: AbortSignal,
): HTMLElement {
  const verdict = design.verdict;
  const strength = design.strength ?? 2;
  const terms = termsOf(strength);
  const unchanged = unchangedOf(design);
  const excess = excessOf(design);
  const later = (): HTMLElement => h('span', {}, '…');
  const [source, date, checksum] = [later(), later(), later()];
  const rows: [name: string, value: Child | Child[], meaning: string][] = [
    [
      'v, k, m',
      `${number(design.v)}, ${number(design.k)}, ${number(design.change)} ` +
        `(${changeWord(design.change)})`,
      `v: ${terms.v}; k: ${terms.k}; m: ${terms.change}`,
    ],
    ['kind', design.kind, terms.kind],
    ...(strength > 2
      ? ([
          [
            'strength t',
            `${strength} (${setsOf(strength)})`,
            'every t elements are together in some block, and not only every two',
          ],
        ] as [string, string, string][])
      : []),
    ['blocks b', h('strong', {}, number(design.blocks.length)), terms.blocks],
  ];
  if (verdict) {
    rows.push([
      'lower bound',
      [number(verdict.lower_bound), ' ', h('a', { href: cellLink(design) }, 'why')],
      terms.bound,
    ]);
  }
  if (excess !== null) {
    rows.push(['excess', excess, terms.excess]);
  }
  if (symmetry) {
    rows.push([
      'group',
      groupWords(symmetry),
      'relabellings of the elements that map the design to itself',
    ]);
  }
  rows.push(['stays', staysOf(design, stays), 'how often elements are introduced']);
  if (unchanged !== null) {
    rows.push(['unchanged subsets', unchanged, terms.unchanged]);
  }
  if (design.label || design.recipe) {
    rows.push(['source', source, 'who made it, or the construction that does']);
  }
  if (design.label) {
    rows.push(['date', date, 'when it came into the catalog']);
  }
  rows.push([
    'SHA-256',
    h('span', { class: 'code small' }, checksum),
    'of the blocks, one a line; a label ends with its first eight digits',
  ]);
  void entryOf(design, signal)
    .catch(() => null) // All else is there.
    .then(async (entry) => {
      fill(source, sourceOf(design, entry));
      entry?.credit.date ? fill(date, entry.credit.date) : date.closest('tr')?.remove();
      const { blocks, k } = design;
      return entry?.hash ?? (await checksumOf(blocks.length, k, (i) => blocks[i]!));
    })
    .then(
      (hash) => fill(checksum, hash ?? 'is in the file with the blocks'),
      () => fill(checksum, 'not computed'),
    );
  return h(
    'table',
    { class: 'fact-table' },
    h('caption', { class: 'unseen' }, 'The design in numbers'),
    h(
      'tbody',
      {},
      rows.map(([name, value, meaning]) =>
        h('tr', {}, h('th', { scope: 'row' }, factName(name, meaning)), h('td', {}, value)),
      ),
    ),
  );
}
