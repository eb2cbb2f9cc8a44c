// Pages that need the program itself. In a static copy they say how to get it.
import { fill, h } from '../lib/dom';
import { command } from '../parts/command';
import { isCopy } from './about';
import { link, type Page } from './router';

/** What does the same without pages. */
const commands: Record<string, string> = {
  plan: 'changeover plan parts.csv -k 4',
  loadorder: 'changeover loadorder --items 64 --room 16',
  search: 'changeover search 20 5 --circular --time 1m',
  verify: 'changeover verify FILE',
};

export function whereThereIsAServer(page: Page): Page {
  return {
    ...page,
    render(view) {
      if (!isCopy()) {
        return page.render(view);
      }
      fill(
        view.root,
        h('h1', {}, page.title),
        h(
          'p',
          { class: 'note' },
          'These pages are a static copy, and this one needs the program: install Changeover ' +
            'and run ',
          h('code', {}, 'changeover serve'),
          '; it opens the same pages with this one at work.',
        ),
        commands[page.path] && h('p', {}, 'On the command line: ', command(commands[page.path]!)),
        h(
          'p',
          {},
          'The ',
          h('a', { href: link('catalog') }, 'catalog'),
          ' and the ',
          h('a', { href: link('theorems') }, 'theorems'),
          ' are here.',
        ),
      );
    },
  };
}
