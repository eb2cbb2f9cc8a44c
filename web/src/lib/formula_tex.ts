// Tokens of mathematics as TeX.
import type { Token } from './formula';

/** Where the number, letter, bracket or `C(v,2)` at a place ends; −1 if none of them is there. */
function operandEnd(tokens: readonly Token[], at: number): number {
  const [token, next] = [tokens[at], tokens[at + 1]];
  const binomial = token?.sign === 'C' && next?.sign === '(' && next.from === token.to;
  return token?.sign === '(' || binomial
    ? closing(tokens, binomial ? at + 1 : at)
    : token?.kind === 'number' || (token?.kind === 'variable' && token.sign !== '…')
      ? at
      : -1;
}

/** The fraction that begins at a place outside of brackets, and its last token; null if none does. */
function fractionAt(
  tokens: readonly Token[],
  at: number,
  text: string,
): { tex: string; end: number } | null {
  const before = tokens[at - 1];
  const over = operandEnd(tokens, at) + 1;
  const end = over > 0 && tokens[over]?.sign === '/' ? operandEnd(tokens, over + 1) : -1;
  const next = tokens[end + 1];
  if (
    end < 0 ||
    depthAt(tokens, at) !== 0 ||
    (before && before.kind !== 'operator' && before.kind !== 'comma') ||
    (next && next.kind !== 'operator' && next.kind !== 'comma')
  ) {
    return null;
  }
  const bare = (from: number, to: number): string =>
    join(
      tokens[from]!.sign === '(' ? tokens.slice(from + 1, to - 1) : tokens.slice(from, to),
      text,
    );
  return { tex: `\\frac{${bare(at, over)}}{${bare(over + 1, end + 1)}}`, end };
}

/** TeX of tokens: `ceil(…)` and `C(v,2)` as they are set; `a/b` as a fraction where it may be high. */
export function join(tokens: readonly Token[], text: string, high = false): string {
  let tex = '';
  for (let i = 0; i < tokens.length; ++i) {
    const fraction = high ? fractionAt(tokens, i, text) : null;
    if (fraction) {
      tex += fraction.tex;
      i = fraction.end;
      continue;
    }
    const token = tokens[i]!;
    const next = tokens[i + 1];
    const binomial =
      token.kind === 'variable' &&
      token.sign === 'C' &&
      token.to - token.from === 1 &&
      next?.sign === '(' &&
      next.from === token.to;
    const rounded = token.kind === 'function' && (token.sign === 'ceil' || token.sign === 'floor');
    if ((binomial || rounded) && next) {
      const end = closing(tokens, i + 1);
      if (end > 0) {
        const inside = tokens.slice(i + 2, end);
        const comma = inside.findIndex(
          (each, at) => each.sign === ',' && depthAt(inside, at) === 0,
        );
        if (rounded) {
          const [open, close] =
            token.sign === 'ceil' ? ['\\lceil ', '\\rceil '] : ['\\lfloor ', '\\rfloor '];
          tex += `${open}${join(inside, text)}${close}`;
          i = end;
          continue;
        }
        if (comma > 0) {
          tex +=
            `\\tbinom{${join(inside.slice(0, comma), text)}}{` +
            `${join(inside.slice(comma + 1), text)}}`;
          i = end;
          continue;
        }
      }
    }
    if (token.kind === 'function' && tex !== '' && i > 0) {
      tex += ' ';
    }
    tex += token.sign === 'mod' && tokens[i - 1]?.kind === 'open' ? '\\mathrm{mod}\\; ' : token.tex;
    const gap = next ? text.slice(token.to, next.from) : '';
    if (gap.length >= 2 && !gap.includes('\n')) {
      tex += '\\quad ';
    } else if (token.kind === 'comma' && token.sign !== ':') {
      tex += gap === '' ? '' : '\\, ';
    }
  }
  return tex;
}

function closing(tokens: readonly Token[], open: number): number {
  let depth = 0;
  for (let i = open; i < tokens.length; ++i) {
    depth += tokens[i]!.kind === 'open' ? 1 : tokens[i]!.kind === 'close' ? -1 : 0;
    if (depth === 0) {
      return i;
    }
  }
  return -1;
}

export function depthAt(tokens: readonly Token[], at: number): number {
  return tokens
    .slice(0, at)
    .reduce(
      (depth, each) => depth + (each.kind === 'open' ? 1 : each.kind === 'close' ? -1 : 0),
      0,
    );
}
