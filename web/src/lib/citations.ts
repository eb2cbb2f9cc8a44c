// The works that are cited, by the keys that the program uses: `[Bean2026]`, `[ChafeeStevens2025,
// Theorem 10]`.
import references from '../../references.json';
import { h, type Child } from './dom';
import { mathText } from './mathematics';

const works: Readonly<Record<string, { name: string; text: string; url: string | null }>> =
  references;

export const cited: readonly (readonly [key: string, text: string, url: string | null])[] =
  Object.entries(works).map(([key, { text, url }]) => [key, text, url]);

/** A work as people name it: "Bean 2026", "Chafee and Stevens 2025". */
export const spoken = (key: string): string => works[key]?.name ?? key;

/**
 * A work, linked to where it can be read, or to the list of references. `place` follows its name:
 * "Theorem 10".
 */
export function work(key: string, place = ''): Child {
  const known = works[key];
  const words = spoken(key) + place;
  return known
    ? h(
        'a',
        {
          href: known.url ?? `#/theorems?reference=${key}`,
          title: known.text,
          rel: known.url ? 'noreferrer' : null,
        },
        words,
      )
    : words;
}

/** Text with formulas set, works linked, and theorems of docs/theorems.md linked by `theorem`. */
export function scholarly(text: string, theorem: (number: string) => string): Child[] {
  const found: Child[] = [];
  const pattern = new RegExp(
    [
      /(\d+\.\d+\.\d+\.(?:circular|linear)(?:\.t\d+)?\.\d+\.[0-9a-f]{8})/, // a label
      /((?:changeover )?search \d+ \d+ [^;:]*|changeover \d[\w.]*|\d{4}-\d\d-\d\d)/,
      /`([^`]+)`/,
      /\[([A-Z][A-Za-z]+(?:\d{4}[a-z]?|-\d)?)((?:,\s[^\]\[]*)?)\]/,
      /docs\/theorems\.md,\s(Theorem|Proposition|Lemma)\s(\d+)/,
      /(?<=the stays of )Theorem (\d+)/,
    ]
      .map((each) => each.source)
      .join('|'),
  );
  let rest = text;
  for (let match = pattern.exec(rest); match; match = pattern.exec(rest)) {
    const [all, label, verbatim, code, key, place, what, number, ours] = match;
    found.push(...mathText(rest.slice(0, match.index)));
    if (label !== undefined) {
      found.push(h('a', { class: 'code', href: `#/design?label=${label}` }, label));
    } else if (verbatim !== undefined) {
      found.push(verbatim.includes('search') ? h('code', {}, verbatim.trim()) : verbatim);
    } else if (code !== undefined) {
      found.push(h('code', {}, code));
    } else if (key !== undefined) {
      found.push(
        ...(key in works ? ['[', work(key, (place ?? '').replace(/\s+/g, ' ')), ']'] : [all]),
      );
    } else if (ours !== undefined) {
      found.push(h('a', { href: theorem(ours) }, `Theorem ${ours}`));
    } else {
      found.push(
        what === 'Theorem'
          ? h('a', { href: theorem(number!) }, `Theorem ${number}`)
          : `${what} ${number}`,
      );
    }
    rest = rest.slice(match.index + all.length);
  }
  found.push(...mathText(rest));
  return found;
}
