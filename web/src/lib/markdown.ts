// The little Markdown that docs/theorems.md uses, as a tree: paragraphs, headings, lists, tables,
// indented formulas; in them emphasis, code, links, and subscripts and superscripts as mathematics
// writes them: B_{i+1}, x_p, T′^2.
//
// Reading makes plain data, so it needs no browser; `lib/markup.ts` makes nodes of it.

export type Inline =
  | { is: 'text'; text: string }
  | { is: 'em' | 'strong' | 'sub' | 'sup'; inside: Inline[] }
  | { is: 'code'; text: string }
  | { is: 'link'; to: string; inside: Inline[] };

export type Part =
  | { is: 'paragraph'; inside: Inline[] }
  | { is: 'heading'; level: number; inside: Inline[] }
  | { is: 'formula'; lines: Inline[][] }
  | { is: 'list'; ordered: boolean; start: number; items: Part[][] }
  | { is: 'table'; head: Inline[][]; rows: Inline[][][] };

const bullet = /^( {0,3})(?:([-*+])|(\d{1,9})[.)])( +)/;

export function parse(markdown: string): Part[] {
  return parts(markdown.replace(/\r\n?/g, '\n').replace(/\t/g, '    ').split('\n'));
}

function blank(line: string | undefined): boolean {
  return line === undefined || line.trim() === '';
}

function tableRow(line: string): string[] {
  return line
    .trim()
    .replace(/^\||\|$/g, '')
    .split('|')
    .map((cell) => cell.trim());
}

function isRule(line: string | undefined): boolean {
  return (
    line !== undefined &&
    /^\s*\|?\s*:?-{2,}:?\s*(\|\s*:?-{2,}:?\s*|\|)*\|?\s*$/.test(line) &&
    line.includes('|')
  );
}

function parts(lines: readonly string[]): Part[] {
  const found: Part[] = [];
  let i = 0;
  while (i < lines.length) {
    const line = lines[i]!;
    if (blank(line)) {
      ++i;
      continue;
    }
    const heading = /^(#{1,6})\s+(.*?)\s*#*$/.exec(line);
    if (heading) {
      found.push({ is: 'heading', level: heading[1]!.length, inside: inline(heading[2]!) });
      ++i;
      continue;
    }
    if (/^ {4}/.test(line)) {
      const formula: string[] = [];
      while (
        i < lines.length &&
        (/^ {4}/.test(lines[i]!) || (blank(lines[i]) && /^ {4}/.test(lines[i + 1] ?? '')))
      ) {
        formula.push(lines[i++]!.slice(4));
      }
      found.push({ is: 'formula', lines: formula.map(inline) });
      continue;
    }
    if (line.includes('|') && isRule(lines[i + 1])) {
      const head = tableRow(line).map(inline);
      i += 2;
      const rows: Inline[][][] = [];
      while (i < lines.length && lines[i]!.includes('|') && !blank(lines[i])) {
        rows.push(tableRow(lines[i++]!).map(inline));
      }
      found.push({ is: 'table', head, rows });
      continue;
    }
    if (bullet.test(line)) {
      const [list, next] = readList(lines, i);
      found.push(list);
      i = next;
      continue;
    }
    const text: string[] = [];
    while (
      i < lines.length &&
      !blank(lines[i]) &&
      !/^#{1,6}\s/.test(lines[i]!) &&
      !(text.length > 0 && interrupts(lines[i]!))
    ) {
      text.push(lines[i++]!.trim());
    }
    found.push({ is: 'paragraph', inside: inline(text.join('\n')) });
  }
  return found;
}

/** A bullet ends a paragraph; a number does so only if the list begins with it at 1. */
function interrupts(line: string): boolean {
  const found = bullet.exec(line);
  return found !== null && (found[2] !== undefined || found[3] === '1');
}

function readList(lines: readonly string[], from: number): [Part, number] {
  const first = bullet.exec(lines[from]!)!;
  const ordered = first[3] !== undefined;
  const items: Part[][] = [];
  let i = from;
  while (i < lines.length) {
    const mark = bullet.exec(lines[i]!);
    if (!mark || (mark[3] !== undefined) !== ordered || mark[1]!.length !== first[1]!.length) {
      break;
    }
    const indent = mark[0].length;
    const item = [lines[i]!.slice(indent)];
    ++i;
    while (i < lines.length) {
      const line = lines[i]!;
      const inside = line.startsWith(' '.repeat(indent));
      if (blank(line)) {
        // A gap belongs to the item if what follows is indented below it.
        let next = i;
        while (next < lines.length && blank(lines[next])) {
          ++next;
        }
        if (next < lines.length && lines[next]!.startsWith(' '.repeat(indent))) {
          item.push('');
          i = next;
          continue;
        }
        break;
      }
      if (!inside && bullet.test(line)) {
        break;
      }
      item.push(inside ? line.slice(indent) : line.trimStart());
      ++i;
    }
    items.push(parts(item));
    let next = i;
    while (next < lines.length && blank(lines[next])) {
      ++next;
    }
    if (next < lines.length && bullet.test(lines[next]!)) {
      i = next;
    }
  }
  return [{ is: 'list', ordered, start: ordered ? Number(first[3]) : 1, items }, i];
}

/** The index behind the bracket that closes the one at `at`, or −1. */
function closing(text: string, at: number, open: string, close: string): number {
  let depth = 0;
  for (let i = at; i < text.length; ++i) {
    if (text[i] === open) {
      ++depth;
    } else if (text[i] === close && --depth === 0) {
      return i + 1;
    }
  }
  return -1;
}

const letter = /[\p{L}\p{M}\p{N})\]′*]/u;

export function inline(text: string): Inline[] {
  const found: Inline[] = [];
  let plain = '';
  const flush = (): void => {
    if (plain !== '') {
      found.push({ is: 'text', text: plain });
      plain = '';
    }
  };
  const push = (item: Inline): void => {
    flush();
    found.push(item);
  };
  for (let i = 0; i < text.length;) {
    const here = text[i]!;
    if (here === '\\' && /[\\`*_{}[\]()#+\-.!|<>^]/.test(text[i + 1] ?? '')) {
      plain += text[i + 1];
      i += 2;
      continue;
    }
    if (here === '`') {
      const fence = /^`+/.exec(text.slice(i))![0];
      const end = text.indexOf(fence, i + fence.length);
      if (end > 0) {
        push({
          is: 'code',
          text: text
            .slice(i + fence.length, end)
            .replace(/\s+/g, ' ')
            .trim(),
        });
        i = end + fence.length;
        continue;
      }
    }
    if (here === '*') {
      const marks = text.startsWith('**', i) ? '**' : '*';
      const end = emphasisEnd(text, i + marks.length, marks);
      if (end > 0) {
        push({
          is: marks === '**' ? 'strong' : 'em',
          inside: inline(text.slice(i + marks.length, end)),
        });
        i = end + marks.length;
        continue;
      }
    }
    if (here === '[') {
      const end = closing(text, i, '[', ']');
      if (end > 0 && text[end] === '(') {
        const done = closing(text, end, '(', ')');
        if (done > 0) {
          push({
            is: 'link',
            to: text.slice(end + 1, done - 1),
            inside: inline(text.slice(i + 1, end - 1)),
          });
          i = done;
          continue;
        }
      }
    }
    if ((here === '_' || here === '^') && i > 0 && letter.test(text[i - 1]!)) {
      const rest = text.slice(i + 1);
      const braced = rest.startsWith('{') ? closing(text, i + 1, '{', '}') : -1;
      const bare = /^(?:\p{N}+|\p{L}\p{M}*′?)/u.exec(rest)?.[0];
      // A word after a word is a name (a_file), and no subscript.
      const word = bare !== undefined && /^\p{L}/u.test(bare) && /^\p{L}{2}/u.test(rest);
      if (braced > 0) {
        push({ is: here === '_' ? 'sub' : 'sup', inside: inline(text.slice(i + 2, braced - 1)) });
        i = braced;
        continue;
      }
      if (bare !== undefined && !word) {
        push({ is: here === '_' ? 'sub' : 'sup', inside: [{ is: 'text', text: bare }] });
        i += 1 + bare.length;
        continue;
      }
    }
    plain += here;
    ++i;
  }
  flush();
  return found;
}

/** Where emphasis that begins before `from` ends, or −1: not after a blank, not inside code. */
function emphasisEnd(text: string, from: number, marks: string): number {
  if (/\s/.test(text[from] ?? ' ')) {
    return -1;
  }
  for (let i = from; i < text.length; ++i) {
    if (text[i] === '`') {
      const end = text.indexOf('`', i + 1);
      i = end > 0 ? end : i;
    } else if (text.startsWith('**', i) && marks === '*') {
      ++i;
    } else if (text.startsWith(marks, i) && i > from && !/\s/.test(text[i - 1]!)) {
      return i;
    }
  }
  return -1;
}
