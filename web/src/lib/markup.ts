// Markdown as nodes. Text stays text: no HTML comes in with it.
import { scholarly } from './citations';
import { h, type Child } from './dom';
import { inline, parse, type Inline, type Part } from './markdown';
import { displayed, type Line } from './mathematics';

/**
 * Where a link of the text leads in these pages; null: it is shown as words only. Code is asked for
 * in its backticks.
 */
type Links = (to: string) => string | null;

/** Text and its scripts as they were written: B_{i+1}. */
function written(part: Inline): string | null {
  switch (part.is) {
    case 'text':
      return part.text;
    case 'sub':
    case 'sup': {
      const inside = part.inside.map(written);
      return inside.includes(null) ? null : `${part.is === 'sub' ? '_' : '^'}{${inside.join('')}}`;
    }
    default:
      return null;
  }
}

function nodes(parts: readonly Inline[], links: Links): Child[] {
  const found: Child[] = [];
  let text = '';
  const flush = (): void => {
    found.push(...scholarly(text, (number) => `#/theorems?theorem=${number}`));
    text = '';
  };
  for (const part of parts) {
    const plain = written(part);
    if (plain !== null) {
      text += plain;
      continue;
    }
    flush();
    switch (part.is) {
      case 'text':
        break;
      case 'code': {
        const to = links(`\`${part.text}\``);
        const code = h('code', {}, part.text);
        found.push(to === null ? code : h('a', { href: to }, code));
        break;
      }
      case 'link': {
        const to = links(part.to);
        found.push(
          to === null
            ? h('span', {}, nodes(part.inside, links))
            : h('a', { href: to }, nodes(part.inside, links)),
        );
        break;
      }
      default:
        found.push(h(part.is, {}, nodes(part.inside, links)));
    }
  }
  flush();
  return found;
}

/** Text as it was written, without its marks. */
function plainLine(parts: readonly Inline[]): string {
  return parts
    .map(
      (part) =>
        written(part) ??
        (part.is === 'text' || part.is === 'code' ? part.text : plainLine(part.inside)),
    )
    .join('');
}

/**
 * Lines of a displayed formula. What is emphasized is said of what stands before it: "if v ≤ 2k",
 * "hence"; what follows it begins a line.
 */
function displayLines(parts: readonly Inline[]): Line[] {
  const lines: Line[] = [];
  let text = '';
  for (const part of parts) {
    if (part.is === 'em') {
      lines.push({ text, condition: plainLine(part.inside) });
      text = '';
    } else {
      text += plainLine([part]);
    }
  }
  return text.trim() === '' && lines.length > 0 ? lines : [...lines, { text }];
}

function block(part: Part, links: Links): HTMLElement {
  const inside = (parts: readonly Inline[]): Child[] => nodes(parts, links);
  switch (part.is) {
    case 'paragraph':
      return h('p', {}, ...inside(part.inside));
    case 'heading':
      return h(part.level <= 2 ? 'h3' : 'h4', {}, ...inside(part.inside));
    case 'formula':
      return h(
        'div',
        { class: 'formula scroll', tabindex: 0, role: 'group', 'aria-label': 'Formula' },
        displayed(part.lines.flatMap(displayLines)),
      );
    case 'list': {
      const items = part.items.map((item) => {
        const only = item.length === 1 && item[0]!.is === 'paragraph' ? item[0] : null;
        return h(
          'li',
          {},
          ...(only ? inside(only.inside) : item.map((each) => block(each, links))),
        );
      });
      return part.ordered
        ? h('ol', { start: part.start === 1 ? null : part.start }, items)
        : h('ul', {}, items);
    }
    case 'table': {
      // Few columns with much in them stand below each other on a phone, with their names.
      const wide = (row: Inline[][]): number =>
        row.reduce((sum, cell) => sum + plainLine(cell).length, 0);
      const long = part.head.length < 6 && Math.max(...part.rows.map(wide)) > 30;
      const names = part.head.map((cell) => plainLine(cell).replace(/[{}]/g, ''));
      return h(
        'div',
        { class: 'scroll', tabindex: 0, role: 'group', 'aria-label': 'Table' },
        h(
          'table',
          { class: long ? 'long' : null },
          h(
            'thead',
            {},
            h(
              'tr',
              {},
              part.head.map((cell) =>
                cell.length > 0 ? h('th', { scope: 'col' }, ...inside(cell)) : h('td'),
              ),
            ),
          ),
          h(
            'tbody',
            {},
            part.rows.map((row) =>
              h(
                'tr',
                {},
                row.map((cell, i) => h('td', { 'data-label': names[i]! }, ...inside(cell))),
              ),
            ),
          ),
        ),
      );
    }
  }
}

export function markup(markdown: string, links: Links = () => null): HTMLElement[] {
  return parse(markdown).map((part) => block(part, links));
}

/** One line of text with mathematics in it. */
export function line(text: string): Child[] {
  return nodes(inline(text), () => null);
}
