// The check of a list without a program behind the page, as in a static copy: reads the text of one
// block a line, or the JSON of a design, and counts steps and pairs as the program does. A test
// (export.test.mjs) holds it to `changeover verify --json`.
//
// Cost: O(b·k·(m + 1)) for the pairs, v² bits of memory for them.
import { ApiError, type Design, type Kind, type Verified } from '../../lib/api';

/** What the form says instead of the text; an empty string is nothing. */
export interface Declared {
  v: string;
  change: string;
  kind: string;
}

interface List {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  blocks: number[][];
  labels: string[] | null;
  /** Names, if few stand among numbers. */
  odd: string[];
}

/** More elements than this have too many pairs for a page. */
const mostElements = 20_000;
const [mostSteps, mostPairs] = [100, 200];
/** So few names among so many numbers may be slips of the hand. */
const [fewNames, manyNumbers] = [2, 3];

const isNumber = (word: string): boolean => /^(0|[1-9]\d{0,8})$/.test(word);

function refuse(message: string, line?: number, column?: number): never {
  throw new ApiError(message, 400, line, column);
}

function whole(name: string, text: string, least: number): number {
  if (!isNumber(text) || Number(text) < least) {
    refuse(`${name}=${text}: bad value; give a whole number from ${least}`);
  }
  return Number(text);
}

interface Row {
  line: number;
  words: { text: string; column: number }[];
}

/** The blocks of a text as words, and what its comments declare. */
function rowsOf(text: string): { rows: Row[]; said: Record<string, string>; labels: string[] } {
  const rows: Row[] = [];
  const said: Record<string, string> = {};
  const labels: string[] = [];
  text.split(/\r?\n/).forEach((whole, at) => {
    const header = /^#\s*changeover design\s+(.*)$/.exec(whole);
    for (const pair of header?.[1]!.split(/\s+/) ?? []) {
      const [name, value] = pair.split('=');
      said[name!] = value ?? '';
    }
    labels.push(...(/^#\s*labels:\s+(.*\S)/.exec(whole)?.[1]!.split(/\s+/) ?? []));
    const words = [...whole.replace(/#.*/, '').matchAll(/\S+/g)].map((word) => ({
      text: word[0],
      column: word.index + 1,
    }));
    if (words.length > 0) {
      rows.push({ line: at + 1, words });
    }
  });
  return { rows, said, labels };
}

function checkRows(rows: Row[]): void {
  if (rows.length === 0) {
    refuse('no blocks; write one block a line');
  }
  const k = rows[0]!.words.length;
  rows.forEach(({ line, words }, i) => {
    const seen = new Set<string>();
    for (const { text, column } of words) {
      if (/[[\]{}(),;=<>]/.test(text)) {
        refuse(
          `${text} is not an element; this copy reads one block a line, elements with blanks ` +
            'between them, and the JSON of a design. `changeover verify` reads more formats',
          line,
          column,
        );
      }
      if (seen.has(text)) {
        refuse(`block ${i + 1} has ${text} twice; correct one of them`, line, column);
      }
      seen.add(text);
    }
    if (words.length !== k) {
      refuse(
        `block ${i + 1} has ${words.length} elements, the blocks before have ${k}; correct one ` +
          'of them',
        line,
      );
    }
  });
}

function fromText(text: string, declared: Declared): List {
  const { rows, said, labels } = rowsOf(text);
  checkRows(rows);
  const named = declared.v || said['v'];
  const words = rows.flatMap((row) => row.words);
  const [numbers, names] = [new Set<string>(), new Set<string>()];
  for (const { text: word } of words) {
    (isNumber(word) ? numbers : names).add(word);
  }
  const sorted = [...numbers].sort((a, b) => Number(a) - Number(b));
  // Numbers have their order; names, and numbers among them, are taken as they come.
  const met = names.size > 0 ? [...new Set(words.map((word) => word.text))] : sorted;
  let order = labels.length > 0 ? labels : met;
  if (named && labels.length === 0) {
    const v = whole('v', named, 1);
    if (v > mostElements) {
      refuse(`v=${v} is too many for a page; \`changeover verify\` has no such limit`);
    }
    const above = sorted.find((word) => Number(word) >= v);
    if (names.size === 0 && above === undefined) {
      order = Array.from({ length: v }, (_, i) => String(i));
    } else if (order.length > v) {
      refuse(`there are ${order.length} elements, more than v=${v}; correct them, or v`);
    } else if (names.size === 0) {
      refuse(`element ${above} is not below v=${v}; elements are numbers from 0`);
    }
  }
  const at = new Map(order.map((word, i) => [word, i]));
  const blocks = rows.map(({ line, words: block }) =>
    block
      .map(
        ({ text: word, column }) =>
          at.get(word) ?? refuse(`${word} is not among the labels`, line, column),
      )
      .sort((a, b) => a - b),
  );
  const plain = order.every((word, i) => word === String(i));
  const v = named && labels.length === 0 ? Math.max(order.length, Number(named)) : order.length;
  // Elements that are in no block have the next free numbers.
  const taken = new Set(order);
  for (let n = v; order.length < v; ++n) {
    taken.has(String(n)) || order.push(String(n));
  }
  const odd = plain ? [] : order.filter((word) => !isNumber(word));
  return {
    ...completed(blocks, v, declared.change || said['change'], declared.kind || said['kind']),
    labels: plain ? null : order,
    odd: odd.length <= fewNames && order.length - odd.length >= manyNumbers ? odd : [],
  };
}

function fromJson(text: string, declared: Declared): List {
  let design: Partial<Design>;
  try {
    design = JSON.parse(text) as Partial<Design>;
  } catch (fault) {
    refuse(`this begins as JSON and is none: ${(fault as Error).message}`);
  }
  const { blocks, v, k, change, kind, labels } = design;
  const fits =
    typeof v === 'number' &&
    v <= mostElements &&
    Array.isArray(blocks) &&
    blocks.length > 0 &&
    blocks.every(
      (block) =>
        Array.isArray(block) &&
        block.length === (k ?? blocks[0]!.length) &&
        new Set(block).size === block.length &&
        block.every((x) => Number.isInteger(x) && x >= 0 && x < v),
    );
  if (!fits || (design.strength ?? 2) !== 2) {
    refuse(
      'this JSON is not a design of strength 2 with "v" and "blocks" of numbers below it; ' +
        '`changeover verify` says what is wrong',
    );
  }
  return {
    ...completed(
      blocks.map((block) => [...block].sort((a, b) => a - b)),
      v,
      declared.change || (change ? String(change) : ''),
      declared.kind || kind,
    ),
    labels: labels ?? null,
    odd: [],
  };
}

/** What is not said: the change number is that of the first step, and a design is linear. */
function completed(
  blocks: number[][],
  v: number,
  change: string | undefined,
  kind: string | undefined,
): Omit<List, 'labels' | 'odd'> {
  const k = blocks[0]!.length;
  if (kind && kind !== 'linear' && kind !== 'circular') {
    refuse(`kind=${kind}: bad value; give linear or circular`);
  }
  if (v > mostElements) {
    refuse(`${v} elements are too many for a page; \`changeover verify FILE\` has no such limit`);
  }
  const before = new Set(blocks[0]);
  const first = blocks[1]?.filter((x) => !before.has(x)).length ?? 0;
  const m = change ? whole('change', change, 1) : first || Math.min(2, k);
  if (m > k) {
    refuse(`change = ${m} is more than the ${k} elements of a block; give at most k`);
  }
  return { v, k, change: m, kind: (kind ?? '') === 'circular' ? 'circular' : 'linear', blocks };
}

const two = (n: number): number => (n * n - n) / 2;

/** The pairs that are in blocks: bit y of row x, y < x. */
class Pairs {
  private readonly bits: Uint32Array;
  count = 0;
  constructor(private readonly v: number) {
    this.bits = new Uint32Array(Math.ceil(two(v) / 32) + 1);
  }
  private static place(x: number, y: number): number {
    return x > y ? two(x) + y : two(y) + x;
  }
  has(x: number, y: number): boolean {
    const at = Pairs.place(x, y);
    return (this.bits[at >>> 5]! & (1 << (at & 31))) !== 0;
  }
  add(x: number, y: number): void {
    if (!this.has(x, y)) {
      const at = Pairs.place(x, y);
      this.bits[at >>> 5]! |= 1 << (at & 31);
      ++this.count;
    }
  }
  each(visit: (x: number, y: number, missing: boolean) => void): void {
    for (let y = 1; y < this.v; ++y) {
      for (let x = 0; x < y; ++x) {
        visit(x, y, !this.has(x, y));
      }
    }
  }
}

/** What one pass over the blocks counts. */
interface Counts {
  pairs: Pairs;
  bad: { from: number; to: number; changes: number }[];
  covered: number;
  introductions: number[];
  occurrences: number[];
  meetings: number[];
  unchanged: Set<string>;
  kept: Set<number>;
}

function counted({ v, k, change, kind, blocks }: List): Counts {
  const zeros = (): number[] => new Array<number>(v).fill(0);
  const counts: Counts = {
    pairs: new Pairs(v),
    bad: [],
    covered: 0,
    introductions: zeros(),
    occurrences: zeros(),
    meetings: zeros(),
    unchanged: new Set(),
    kept: new Set(),
  };
  const b = blocks.length;
  const circular = kind === 'circular' && b > 1;
  blocks.forEach((block, i) => {
    const has = i > 0 || circular;
    const last = new Set(has ? blocks[(i + b - 1) % b] : []);
    const fresh = block.filter((x) => !last.has(x));
    const kept = block.filter((x) => last.has(x));
    if (has && fresh.length !== change) {
      counts.bad.push({ from: i === 0 ? b : i, to: i + 1, changes: fresh.length });
    }
    if (has) {
      counts.unchanged.add(kept.join(' '));
      kept.forEach((x) => counts.kept.add(x));
    }
    counts.covered += two(k) - two(k - fresh.length);
    block.forEach((x) => ++counts.occurrences[x]!);
    fresh.forEach((x) => {
      ++counts.introductions[x]!;
      counts.meetings[x]! += k - 1;
    });
    kept.forEach((x) => (counts.meetings[x]! += fresh.length));
    for (const x of i === 0 ? block : fresh) {
      block.forEach((y) => y !== x && counts.pairs.add(x, y));
    }
  });
  // The first block is looked at last where the circle closes.
  counts.bad.sort((one, other) => (one.to === 1 ? 1 : other.to === 1 ? -1 : one.to - other.to));
  return counts;
}

/** What holds for every list: what pairs need, and how fast elements come in. */
function boundOf({ v, k, change: m }: List): { blocks: number; name: string; reason: string } {
  if (v === k) {
    return { blocks: 1, name: 'trivial', reason: 'one block holds all elements' };
  }
  const most = two(k) - two(k - m);
  const [all, first] = [two(v), two(k)];
  const counting = Math.ceil((all - first) / most) + 1;
  const reach = Math.ceil((v - k) / m);
  return counting >= 2 * reach + 1
    ? {
        blocks: counting,
        name: 'counting',
        reason:
          `the first block covers C(${k},2) = ${first} of C(${v},2) = ${all} pairs, each later ` +
          `one newly covers at most ${most}: ` +
          `b >= ceil((${all} - ${first}) / ${most}) + 1 = ${counting}`,
      }
    : {
        blocks: 2 * reach + 1,
        name: 'end to end',
        reason:
          `at most ${m} elements enter a step, so some x is in none of the first ` +
          `ceil((${v}-${k})/${m}) = ${reach} blocks and some y in none of the last ${reach}: ` +
          `b >= 2*${reach} + 1 = ${2 * reach + 1}`,
      };
}

function verdictOf(list: List): Verified {
  const { v, k, change, kind, blocks, labels } = list;
  const counts = counted(list);
  const b = blocks.length;
  const all = two(v);
  const name = (x: number): string | number => labels?.[x] ?? x;
  const fixed = counts.occurrences.flatMap((times, x) => (times === b ? [x] : []));
  const never = kind === 'circular' && b > 1 ? two(fixed.length) : 0;
  const excess = counts.covered - (counts.pairs.count - never);
  const uncovered: number[][] = [];
  const surplus = counts.meetings.map((met) => met - (v - 1));
  counts.pairs.each((x, y, missing) => {
    if (missing) {
      ++surplus[x]!;
      ++surplus[y]!;
      if (uncovered.length < mostPairs) {
        uncovered.push([x, y]);
      }
    }
  });
  if (never > 0) {
    fixed.forEach((x) => (surplus[x]! += fixed.length - 1));
  }
  const missing = all - counts.pairs.count;
  const valid = counts.bad.length === 0 && missing === 0;
  const most = two(k) - two(k - change);
  const counting =
    v === k
      ? 1
      : kind === 'circular'
        ? Math.ceil(all / most)
        : Math.ceil((all - two(k)) / most) + 1;
  const bound = boundOf(list);
  const tight = valid && excess === 0 && never === 0;
  const economical = valid && b === counting;
  return {
    valid,
    verdict: {
      valid,
      tight,
      economical,
      b,
      lower_bound: bound.blocks,
      minimum: valid && b === bound.blocks ? 'proved' : 'unknown',
    },
    bound: { name: bound.name, reason: bound.reason },
    details: {
      ...{ v, k, change, kind, strength: 2, valid, tight, economical, b },
      counting_bound: counting,
      bad_steps: counts.bad.length,
      bad_step_examples: counts.bad.slice(0, 20),
      subsets: all,
      uncovered: missing,
      uncovered_examples: uncovered.slice(0, 20).map((pair) => pair.map(name)),
      covered: counts.covered,
      never_newly_covered: never,
      excess,
      fixed: fixed.map(name),
      degree_identity: valid && surplus.reduce((sum, e) => sum + e, 0) === 2 * excess,
      unchanged_subsets: counts.unchanged.size,
      never_unchanged: surplus.flatMap((_, x) => (counts.kept.has(x) ? [] : [name(x)])),
      elements: surplus.map((e, x) => ({
        element: name(x),
        introductions: counts.introductions[x]!,
        blocks: counts.occurrences[x]!,
        covered: counts.meetings[x]!,
        excess: e,
      })),
    },
    names_among_numbers: list.odd,
    bad_steps: counts.bad.slice(0, mostSteps).map(({ from, to, changes }) => ({
      block: to,
      why:
        `from block ${from} to block ${to}${to < from ? ' (the circle closes)' : ''}: ` +
        `${changes} ${changes === 1 ? 'element' : 'elements'} changed, not ${change}`,
    })),
    uncovered_pairs: uncovered,
    design: {
      format: 'changeover-design/1',
      ...{ v, k, change, kind, blocks },
      ...(labels ? { labels } : {}),
    },
  };
}

/** @throws ApiError with line and column if the text is not a list of blocks. */
export function verifyAlone(text: string, declared: Declared): Verified {
  const plain = text.replace(/^\ufeff/, '');
  return verdictOf(
    /^\s*\{\s*"/.test(plain) ? fromJson(plain, declared) : fromText(plain, declared),
  );
}
