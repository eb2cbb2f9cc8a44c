// Mathematics as the program and docs/theorems.md write it (`2*n_j >= 3k`, `B_{i+1}`, `⌈(v−k)/2⌉`),
// found in plain text and turned into TeX. What is not surely mathematics stays text.

import { depthAt, join } from './formula_tex';
import { greek, symbols } from './signs';

/** `breaks`: a line may end behind it. */
export type Piece = { text: string } | { tex: string; text: string; breaks?: boolean };

const operators = new Set([
  '≤',
  '≥',
  '<=',
  '>=',
  '<',
  '>',
  '=',
  '≠',
  '≡',
  '≢',
  '+',
  '−',
  '-',
  '±',
  '·',
  '*',
  '/',
  '∖',
  '∪',
  '∩',
  '⊂',
  '∈',
]);
const closers: Record<string, string> = { '(': ')', '[': ']', '{': '}', '⌈': '⌉', '⌊': '⌋' };
const opened = new Set(Object.keys(closers));
const closed = new Set(Object.values(closers));
const functions = new Set(['ceil', 'floor', 'max', 'min', 'gcd', 'log']);
const designs = new Set(['SCCD', 'DCCD']);
/** Pairs of letters that are words wherever they stand. */
const words = new Set(
  (
    'a A am an as at be by do go he if in is it me my no of on or so to up us we ' +
    'If In It So To On At By No Of We An As Is Be vs'
  ).split(' '),
);
/** Other pairs of small letters that are not products: units, endings and short forms. */
const shorts = new Set(
  'cf ch cm dr ff ft hr kb kg km lb md ml mm mr ms ns pp ps px py st th'.split(' '),
);
/** What joins letters to what is beside them, with a blank. */
const joined = { before: /[=≤≥<>+−·] $/, behind: /^ [=≤≥<>+−·] / };

/** Whether small letters side by side are a product: `tp + 1`, `≤ nk`, `sn` have no other reading. */
function isProduct(pair: string, before: string, behind: string): boolean {
  return (
    /^[_(+−·*/)]/.test(behind) ||
    joined.before.test(before) ||
    joined.behind.test(behind) ||
    (!/[aeiouy]/.test(pair) && !shorts.has(pair) && !/[./]$/.test(before) && !/^\.\w/.test(behind))
  );
}

/**
 * Whether a letter that can be a word is a variable where it stands: it has an index, is beside a
 * sign of mathematics, or where no article can be.
 */
function isNamed(sign: string, before: string, behind: string): boolean {
  if (sign.length > 1) {
    return false;
  }
  const article = sign === 'a' || sign === 'A';
  return (
    /^(?:[_^]| [=≤≥≠≡<>+−·∖∪∩⊂∈] )/.test(behind) ||
    // "A is part of B".
    (sign === 'A' && /^ (?:is|has|meets|lies) /.test(behind)) ||
    (article && /[\d(−+·/]$/.test(before) && /^[,−+·/]/.test(behind)) ||
    (article && /[\d−+·/]$|[=≤≥<>+−·] $/.test(before) && /^(?:$|[,.;:)]| [+−·/] )/.test(behind)) ||
    (sign === 'a' && /\s$/.test(before) && /^[,.;:]/.test(behind)) ||
    (sign === 'a' && (/[−+·] $/.test(before) || /^ in [A-Z](?!\p{L})/u.test(behind))) ||
    // No article within a sentence is a capital.
    (sign === 'A' && (/[\p{Ll},;]\s$/u.test(before) || /^[+−∖]/.test(behind))) ||
    (sign === 'A' && /^(?:, | and )[A-Z](?!\p{L})/u.test(behind))
  );
}

export interface Token {
  kind: 'number' | 'variable' | 'function' | 'design' | 'operator' | 'open' | 'close' | 'comma';
  from: number;
  to: number;
  /** Without scripts. */
  sign: string;
  tex: string;
}

const letter = /\p{L}/u;

/** Scripts behind a variable: `_x`, `_{i+1}`, `^2`, `²`, `′`. */
function scripts(text: string, at: number): { to: number; tex: string } {
  let tex = '';
  let to = at;
  for (;;) {
    const rest = text.slice(to);
    const found = /^[_^](\{[^{}]*(?:\{[^{}]*\}[^{}]*)*\}|\d+|[A-Za-zℓ](?![A-Za-z]))/.exec(rest);
    if (found) {
      const inside = found[1]!.startsWith('{') ? found[1]!.slice(1, -1) : found[1]!;
      tex += `${rest[0]}{${texOf(inside)}}`;
      to += found[0].length;
      continue;
    }
    const mark = { '²': '^2', '³': '^3', '′': "'", '*': '' }[rest[0] ?? ''];
    if (mark && rest[0] !== '*') {
      tex += mark;
      to += 1;
      continue;
    }
    return { to, tex };
  }
}

/**
 * The token at a place; null if what stands there is no mathematics. `sure`: all of the text is a
 * formula.
 */
function tokenAt(text: string, at: number, sure: boolean): Token | null {
  const rest = text.slice(at);
  const make = (kind: Token['kind'], sign: string, tex: string, length = sign.length): Token => ({
    kind,
    from: at,
    to: at + length,
    sign,
    tex,
  });
  const number = /^\d+(?:[.]\d+)?/.exec(rest);
  if (number) {
    const end = scripts(text, at + number[0].length);
    const grouped = /^\d{5,}$/.test(number[0])
      ? number[0].replace(/\B(?=(\d{3})+$)/g, '\\,')
      : number[0];
    return { ...make('number', number[0], grouped + end.tex), to: end.to };
  }
  const double = /^(?:>=|<=|:=|\.\.\.)/.exec(rest);
  if (double) {
    return make(double[0] === '...' ? 'variable' : 'operator', double[0], symbols[double[0]]!);
  }
  const here = String.fromCodePoint(rest.codePointAt(0)!);
  if (letter.test(here)) {
    const run = /^\p{L}\p{M}*(?:\p{L}\p{M}*)*/u.exec(rest)![0];
    const plain = run.normalize('NFD').replace(/\p{M}/gu, '');
    if (functions.has(plain) && (rest[run.length] === '(' || plain === 'max' || plain === 'min')) {
      const under = scripts(text, at + run.length);
      const tex = plain === 'ceil' || plain === 'floor' ? '' : `\\${plain}${under.tex} `;
      return { ...make('function', plain, tex), to: under.to };
    }
    if (plain === 'mod' && /^ ?\d|^ ?[a-z](?![a-z])/.test(rest.slice(3))) {
      return make('operator', 'mod', '\\bmod ');
    }
    if (designs.has(plain)) {
      return rest[run.length] === '(' ? make('design', plain, `\\mathrm{${plain}}`) : null;
    }
    const before = text[at - 1] ?? ' ';
    if (
      /[\p{L}'’_]/u.test(before) ||
      (before === '-' && /\p{L}{2}-$/u.test(text.slice(Math.max(0, at - 3), at))) ||
      (plain.length === 1 && /^['’]/.test(rest.slice(run.length))) ||
      (plain === 's' && /['’]/.test(before))
    ) {
      return null;
    }
    const product = [...run.normalize('NFD').matchAll(/\p{L}\p{M}*/gu)].map(([each]) => each);
    const bound = /\d/.test(before);
    if (product.length > 2 && !(bound && product.length <= 3)) {
      return null;
    }
    const behind = rest.slice(run.length);
    const named = isNamed(plain, text.slice(Math.max(0, at - 2), at), behind);
    if (
      !sure &&
      !named &&
      (words.has(plain) ||
        (product.length === 2 &&
          !bound &&
          !/[A-Z]/.test(plain) &&
          !isProduct(plain, text.slice(Math.max(0, at - 2), at), behind)))
    ) {
      return null;
    }
    if (/^-\p{L}{2}/u.test(rest.slice(run.length))) {
      return null; // "m-change", "k-subsets"
    }
    const index = product.length === 1 ? /^\d+/.exec(behind)?.[0] : undefined;
    const end = scripts(text, at + run.length + (index?.length ?? 0));
    const tex = product.map((each) => {
      const base = each[0]!;
      const sign = greek[base] ?? base;
      return each.includes('\u0304') ? `\\bar{${sign}}` : sign;
    });
    return {
      kind: 'variable',
      from: at,
      to: end.to,
      sign: plain,
      tex: tex.join('') + (index ? `_{${index}}` : '') + end.tex,
    };
  }
  if (here === '∞') {
    const end = scripts(text, at + 1);
    return { ...make('variable', here, '\\infty ' + end.tex), to: end.to };
  }
  if (opened.has(here)) {
    return make('open', here, symbols[here]!);
  }
  if (closed.has(here)) {
    const end = scripts(text, at + 1);
    return { ...make('close', here, symbols[here]! + end.tex), to: end.to };
  }
  if (here === ',' || here === ':' || here === ';') {
    return make('comma', here, here);
  }
  if (here === '…') {
    return make('variable', here, symbols[here]!);
  }
  if (here === '-') {
    // A hyphen is a minus between signs of mathematics only: "3-subsets" and "end-to-end" are
    // words.
    const next = /^-\s*(\p{L}+|.)/u.exec(rest)?.[1] ?? '';
    return letter.test(next) && (next.length > 2 || words.has(next)) && !sure
      ? null
      : make('operator', here, symbols[here]!);
  }
  return here in symbols
    ? make(operators.has(here) ? 'operator' : 'variable', here, symbols[here]!)
    : null;
}

/** A text that is a formula as a whole; words in it stay words. `high`: with fractions. */
export function texOf(formula: string, high = false): string {
  let tex = '';
  let tokens: Token[] = [];
  const flush = (): void => {
    tex += join(tokens, formula, high);
    tokens = [];
  };
  for (let i = 0; i < formula.length;) {
    if (formula[i] === ' ' || formula[i] === '\n') {
      const gap = /^[ \n]+/.exec(formula.slice(i))![0].length;
      if (gap >= 2 && tokens.length > 0) {
        flush();
        tex += '\\quad ';
      }
      i += gap;
      continue;
    }
    const token = tokenAt(formula, i, true);
    if (token && !(token.kind === 'variable' && words.has(token.sign) && token.sign.length > 1)) {
      tokens.push(token);
      i = token.to;
      continue;
    }
    const word = /^(?:\p{L}[\p{L}\p{M}]*|.)/u.exec(formula.slice(i))![0];
    flush();
    const plain = word.replace(/[\\{}$&#^_%~]/g, '');
    tex += /^[.,;]$/.test(plain) ? `\\text{${plain}}` : `\\text{ ${plain} }`;
    i += word.length;
  }
  flush();
  return tex;
}

/** Relations have room of their own: wide gaps around them, which help in a text, are none. */
const closeTo = (formula: string): string => formula.replace(/ +([≤≥=≡≢≠<>]|:=|<=|>=) +/g, ' $1 ');

/**
 * A text that is a formula as a whole, in groups that stay together if there is room, and these in
 * parts between which a line may end. Groups begin behind a comma and a gap and with a word, parts
 * with a relation, or with a sign of a sum where they are long; brackets are never cut.
 */
export function partsOf(written: string): { tex: string; text: string }[][] {
  const formula = closeTo(written);
  const cuts = { groups: [0], relations: [] as number[], sums: [] as number[] };
  let depth = 0;
  let last: Token | 'word' | null = null;
  for (let i = 0; i < formula.length;) {
    const gap = /^[ \n]*/.exec(formula.slice(i))![0].length;
    if (gap > 0) {
      i += gap;
      if (depth === 0 && last !== null && (gap >= 2 || (last !== 'word' && last.sign === ','))) {
        cuts.groups.push(i);
        last = null;
      }
      continue;
    }
    const token = tokenAt(formula, i, true);
    if (!token || (token.kind === 'variable' && words.has(token.sign) && token.sign.length > 1)) {
      const word = /^(?:\p{L}[\p{L}\p{M}]*|.)/u.exec(formula.slice(i))![0];
      if (depth === 0 && last !== null && last !== 'word' && letter.test(word)) {
        cuts.groups.push(i);
      }
      last = 'word';
      i += word.length;
      continue;
    }
    depth += token.kind === 'open' ? 1 : token.kind === 'close' ? -1 : 0;
    if (token.kind === 'operator' && token.sign !== '/' && depth === 0 && last && last !== 'word') {
      if (last.kind !== 'operator') {
        (relations.has(token.sign) ? cuts.relations : cuts.sums).push(i);
      }
    }
    last = token;
    i = token.to;
  }
  // A letter with its index is not a part by itself.
  const split = (from: number, to: number, at: readonly number[]): [number, number][] => {
    const starts = [from, ...at.filter((each) => each > from + 7 && each < to - 2)];
    return starts.map((start, i) => [start, starts[i + 1] ?? to]);
  };
  return cuts.groups.map((start, n) =>
    split(start, cuts.groups[n + 1] ?? formula.length, cuts.relations)
      .flatMap(([from, to]) =>
        to - from <= longest + 6 ? [[from, to] as const] : split(from, to, cuts.sums),
      )
      .map(([from, to]) => {
        const text = formula.slice(from, to);
        return { tex: `${from > start ? '{}' : ''}${texOf(text, true)}`, text };
      }),
  );
}

/** Only what is balanced and neither begins nor ends with what joins. */
function trimmed(tokens: Token[]): Token[] {
  let list = tokens;
  for (;;) {
    const first = list[0];
    const last = list.at(-1);
    if (!first || !last) {
      return [];
    }
    if (
      last.kind === 'comma' ||
      last.kind === 'operator' ||
      last.kind === 'function' ||
      last.kind === 'design' ||
      last.kind === 'open'
    ) {
      list = list.slice(0, -1);
      continue;
    }
    if (
      first.kind === 'comma' ||
      first.kind === 'close' ||
      (first.kind === 'operator' && !'−-±'.includes(first.sign))
    ) {
      list = list.slice(1);
      continue;
    }
    const open: number[] = [];
    let extra = -1;
    list.forEach((each, i) => {
      if (each.kind === 'open') {
        open.push(i);
      } else if (each.kind === 'close' && open.pop() === undefined && extra < 0) {
        extra = i;
      }
    });
    if (extra >= 0) {
      list = list.slice(0, extra);
      continue;
    }
    if (open.length > 0) {
      list = open[0] === 0 ? list.slice(1) : list.slice(0, open[0]);
      continue;
    }
    return list;
  }
}

const relations = new Set([':=', '=', '≤', '≥', '<=', '>=', '<', '>', '≡', '≢', '≠']);
const sums = new Set(['+', '−', '-', '·', '*']);
/** Longer formulas, in letters, are set in parts, between which lines can end. */
const longest = 24;

/** A long list, a part for some members. */
function listed(tokens: readonly Token[]): Token[][] {
  const found: Token[][] = [[]];
  const open: string[] = [];
  tokens.forEach((token) => {
    found.at(-1)!.push(token);
    token.kind === 'open' ? open.push(token.sign) : token.kind === 'close' && open.pop();
    // What stands in brackets after a name is one thing.
    if (token.sign === ',' && found.at(-1)!.length >= 8 && !open.includes('(')) {
      found.push([]);
    }
  });
  return found.filter((part) => part.length > 0);
}

/**
 * A formula in parts that begin with a relation, or with a sign of a sum where that is not enough.
 */
function parts(tokens: Token[]): Token[][] {
  const length = (some: readonly Token[]): number =>
    some.length === 0 ? 0 : some.at(-1)!.to - some[0]!.from;
  const cut = (some: Token[], at: ReadonlySet<string>): Token[][] => {
    const found: Token[][] = [[]];
    some.forEach((token, i) => {
      if (
        i > 0 &&
        token.kind === 'operator' &&
        at.has(token.sign) &&
        depthAt(some, i) === 0 &&
        some[i - 1]!.kind !== 'operator'
      ) {
        found.push([]);
      }
      found.at(-1)!.push(token);
    });
    // A letter by itself is no line: "b" stays with "≥ ⌈1830/5⌉".
    return found.length > 1 && length(found[0]!) <= 5
      ? [[...found[0]!, ...found[1]!], ...found.slice(2)]
      : found;
  };
  return length(tokens) <= longest
    ? [tokens]
    : cut(tokens, relations)
        .flatMap((part) => (length(part) <= longest + 6 ? [part] : cut(part, sums)))
        .flatMap((part) => (length(part) <= longest ? [part] : listed(part)));
}

/** Whether it is worth setting: a number alone is not, a list of numbers neither. */
function isMathematics(tokens: readonly Token[]): boolean {
  return (
    tokens.some(
      (each) =>
        each.kind === 'variable' ||
        each.kind === 'operator' ||
        each.kind === 'function' ||
        each.kind === 'design' ||
        each.sign === '{',
    ) && !(tokens.length === 1 && (tokens[0]!.sign === '…' || tokens[0]!.kind === 'number'))
  );
}

/** The text in pieces, mathematics with its TeX. Together the pieces are the text. */
export function pieces(text: string): Piece[] {
  const found: Piece[] = [];
  let plain = '';
  const say = (words: string): void => {
    plain += words;
  };
  const flush = (): void => {
    if (plain !== '') {
      found.push({ text: plain });
      plain = '';
    }
  };
  let i = 0;
  while (i < text.length) {
    const tokens: Token[] = [];
    let at = i;
    let depth = 0;
    while (at < text.length) {
      const gap = /^[ \n]*/.exec(text.slice(at))![0].length;
      const token = at + gap < text.length ? tokenAt(text, at + gap, false) : null;
      const last = tokens.at(-1);
      if (!token || (gap > 0 && !last)) {
        break;
      }
      // Two things side by side with a blank between are two things: "at most 9 of", "k m".
      const value = (each: Token): boolean =>
        each.kind === 'number' || each.kind === 'variable' || each.kind === 'close';
      if (
        last &&
        gap > 0 &&
        (value(last) || last.kind === 'comma') &&
        (token.kind === 'number' ||
          token.kind === 'variable' ||
          token.kind === 'function' ||
          token.kind === 'design' ||
          token.kind === 'open') &&
        !(last.kind === 'comma' && (depth > 0 || tokens.at(-2)?.sign === '…')) &&
        !(
          last.kind === 'comma' &&
          tokens.at(-2)?.kind === 'number' &&
          /^\d+(?:, \d+)*, …/.test(text.slice(at + gap))
        ) &&
        token.sign !== '…' &&
        last.sign !== '…' &&
        !greek[last.sign]?.includes('sum')
      ) {
        break;
      }
      if (
        gap > 0 &&
        token.kind === 'open' &&
        last &&
        last.kind !== 'operator' &&
        last.kind !== 'open'
      ) {
        break;
      }
      depth += token.kind === 'open' ? 1 : token.kind === 'close' ? -1 : 0;
      if (depth < 0) {
        break;
      }
      tokens.push(token);
      at = token.to;
    }
    const list = trimmed(tokens);
    if (list.length > 0 && isMathematics(list)) {
      say(text.slice(i, list[0]!.from));
      flush();
      const end = list.at(-1)!.to;
      const cut = parts(list);
      cut.forEach((part, n) => {
        const next = cut[n + 1]?.[0]!.from ?? end;
        found.push({
          tex: `${n > 0 ? '{}' : ''}${join(part, text)}`,
          text: text.slice(part[0]!.from, next),
          ...(n + 1 < cut.length ? { breaks: true } : {}),
        });
      });
      i = end;
      continue;
    }
    const skip =
      list.length > 0
        ? list.at(-1)!.to - i
        : /^(?:\p{L}[\p{L}\p{M}]*|.)/su.exec(text.slice(i))![0].length;
    say(text.slice(i, i + skip));
    i += skip;
  }
  flush();
  return found;
}
