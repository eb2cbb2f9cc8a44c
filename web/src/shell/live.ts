// Pages that need the program itself. In a static copy they say how to get it.
import { fill, h } from '../lib/dom';
import { isCopy } from './about';
import { link, type Page } from './router';

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
