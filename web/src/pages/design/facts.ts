// A design in numbers: what a researcher asks of one. What each means is said on its name.
import type { CatalogEntry, Design } from '../../lib/api';
import { fill, h, type Child } from '../../lib/dom';
import { cellDetail } from '../../lib/source';
import type { Symmetry } from '../../lib/symmetry';
import { termsOf } from '../../lib/terms';
import { changeWord, count, number, setsOf } from '../../lib/words';
import type { Stays } from '../../parts/stays';
import { asText } from '../../parts/downloads';
import { badge } from '../../parts/status';
import { link } from '../../shell/router';

/** So many pairs are named. */
const mostNamed = 6;
/** Of more elements in all blocks together pairs and subsets are not counted. */
const mostCounted = 400_000;

const cellLink = ({ v, k, change, kind, strength }: Design): string =>
  link('cell', { v, k, change, kind, strength: strength === 2 ? null : strength });

/** What newly covers pairs: how often each pair is newly covered, by `x·v + y` with x < y. */
function newlyCovered({ v, kind, blocks }: Design): Map<number, number> {
  const times = new Map<number, number>();
  blocks.forEach((block, i) => {
    const before = new Set(
      i > 0 ? blocks[i - 1] : kind === 'circular' && blocks.length > 1 ? blocks.at(-1) : [],
    );
    block.forEach((x, at) =>
      block.slice(at + 1).forEach((y) => {
        if (!before.has(x) || !before.has(y)) {
          const pair = Math.min(x, y) * v + Math.max(x, y);
          times.set(pair, (times.get(pair) ?? 0) + 1);
        }
      }),
    );
  });
  return times;
}

/** "12: 0–3, 1–7 twice, 2–5 three times and 4 more pairs". */
function excessOf(design: Design): string | null {
  const { v, k, blocks, labels } = design;
  if ((design.strength ?? 2) !== 2 || blocks.length * k * k > mostCounted * 4) {
    return null;
  }
  const name = (x: number): string => labels?.[x] ?? String(x);
  const again = [...newlyCovered(design)].filter(([, times]) => times > 1);
  const excess = again.reduce((sum, [, times]) => sum + times - 1, 0);
  if (excess === 0) {
    return '0';
  }
  const named = again
    .sort(([, one], [, other]) => other - one)
    .slice(0, mostNamed)
    .map(
      ([pair, times]) =>
        `${name(Math.floor(pair / v))}–${name(pair % v)}${times > 2 ? `\u00a0(${times - 1}×)` : ''}`,
    );
  const left = again.length - named.length;
  return (
    `${number(excess)}: newly covered again ${named.join(', ')}` +
    (left > 0 ? ` and ${count(left, 'more pair')}` : '')
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
    `${number(subsets.size)} different of ${count(k - change, 'element')}` +
    `; at least ${number(disjoint)} are disjoint` +
    (used.size === v ? ', an expansion set' : '')
  );
}

/** The checksum that labels have, where this window may compute one. */
async function checksumOf(design: Design): Promise<string | null> {
  if (!window.crypto.subtle || design.blocks.length * design.k > mostCounted) {
    return null;
  }
  const { labels, ...bare } = design;
  const lines = asText(bare as Design)
    .split('\n')
    .filter((line) => line !== '' && !line.startsWith('#'));
  const bytes = new TextEncoder().encode(lines.map((line) => `${line}\n`).join(''));
  const digest = new Uint8Array(await window.crypto.subtle.digest('SHA-256', bytes));
  return [...digest].map((byte) => byte.toString(16).padStart(2, '0')).join('');
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
    symmetry && symmetry.order !== '1' && chip(`group of order ${groupOf(symmetry)}`),
  );
}

const groupOf = ({ order }: Symmetry): string =>
  order.length > 15 ? `about 10^${order.length - 1}` : number(Number(order));

export function facts(
  design: Design,
  stays: Stays,
  symmetry: Symmetry | null,
  signal: AbortSignal,
): HTMLElement {
  const verdict = design.verdict;
  const strength = design.strength ?? 2;
  const terms = termsOf(strength);
  const rotations =
    symmetry && symmetry.rotations > 1 ? `, ${count(symmetry.rotations, 'rotation')}` : '';
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
      `order ${groupOf(symmetry)}${rotations}`,
      'relabellings of the elements that map the design to itself',
    ]);
  }
  rows.push(['stays', staysOf(design, stays), 'how often elements are introduced']);
  if (unchanged !== null) {
    rows.push(['unchanged subsets', unchanged, terms.unchanged]);
  }
  if (design.label) {
    rows.push(
      ['source', source, 'who made it, or the construction that does'],
      ['date', date, 'when it came into the catalog'],
    );
    entryOf(design, signal).then(
      (entry) => {
        fill(
          source,
          !entry
            ? 'a construction'
            : [
                h(
                  'a',
                  { href: link('theorems', { construction: entry.construction }) },
                  entry.construction,
                ),
                entry.credit.who && `, ${entry.credit.who}`,
              ],
        );
        fill(date, entry?.credit.date || 'not known');
      },
      () => [source, date].forEach((place) => fill(place, 'not known')),
    );
  }
  rows.push([
    'SHA-256',
    h('span', { class: 'code small' }, checksum),
    'of the blocks, one a line; a label ends with its first eight digits',
  ]);
  checksumOf(design).then(
    (found) => fill(checksum, found ?? 'is in the file with the blocks'),
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
        h(
          'tr',
          {},
          h('th', { scope: 'row' }, h('dfn', { title: meaning }, name)),
          h('td', {}, value),
        ),
      ),
    ),
  );
}
