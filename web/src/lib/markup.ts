// Markdown as nodes. Text stays text: no HTML comes in with it.
import { h, type Child } from './dom';
import { inline, parse, type Inline, type Part } from './markdown';

/** Where a link of the text leads in these pages; null: it is shown as words only. */
type Links = (to: string) => string | null;

function nodes(parts: readonly Inline[], links: Links): Child[] {
  return parts.map((part) => {
    switch (part.is) {
      case 'text':
        return part.text;
      case 'code':
        return h('code', {}, part.text);
      case 'link': {
        const to = links(part.to);
        return to === null ? h('span', {}, nodes(part.inside, links)) : h('a', { href: to }, nodes(part.inside, links));
      }
      default:
        return h(part.is, {}, nodes(part.inside, links));
    }
  });
}

function block(part: Part, links: Links): HTMLElement {
  const inside = (parts: readonly Inline[]): Child[] => nodes(parts, links);
  switch (part.is) {
    case 'paragraph':
      return h('p', {}, ...inside(part.inside));
    case 'heading':
      return h(part.level <= 2 ? 'h3' : 'h4', {}, ...inside(part.inside));
    case 'formula':
      return h('div', { class: 'formula scroll', tabindex: 0, role: 'group', 'aria-label': 'Formula' }, part.lines.map((line) => h('div', {}, ...inside(line))));
    case 'list': {
      const items = part.items.map((item) => {
        const only = item.length === 1 && item[0]!.is === 'paragraph' ? item[0] : null;
        return h('li', {}, ...(only ? inside(only.inside) : item.map((each) => block(each, links))));
      });
      return part.ordered ? h('ol', { start: part.start === 1 ? null : part.start }, items) : h('ul', {}, items);
    }
    case 'table':
      return h(
        'div',
        { class: 'scroll', tabindex: 0, role: 'group', 'aria-label': 'Table' },
        h(
          'table',
          {},
          h('thead', {}, h('tr', {}, part.head.map((cell) => (cell.length > 0 ? h('th', { scope: 'col' }, ...inside(cell)) : h('td'))))),
          h('tbody', {}, part.rows.map((row) => h('tr', {}, row.map((cell) => h('td', {}, ...inside(cell)))))),
        ),
      );
  }
}

export function markup(markdown: string, links: Links = () => null): HTMLElement[] {
  return parse(markdown).map((part) => block(part, links));
}

/** One line of text with mathematics in it. */
export function line(text: string): Child[] {
  return nodes(inline(text), () => null);
}
