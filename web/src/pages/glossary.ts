// The glossary as a page: `#/glossary?term=tight` is the address of a term.
import { fill, h } from '../lib/dom';
import { termOf } from '../lib/terms';
import { termList } from '../shell/glossary';
import type { Page, View } from '../shell/router';

export const glossary: Page = {
  path: 'glossary',
  title: 'Glossary',
  hidden: true,
  render(view: View) {
    const asked = view.params.get('term');
    const chosen = asked === null ? null : termOf(asked);
    const { find, list } = termList('glossary-page-find', chosen);
    fill(
      view.root,
      h('h1', {}, 'Glossary'),
      asked !== null &&
        chosen === null &&
        h('p', { class: 'note', role: 'alert' }, `There is no term “${asked}” here.`),
      h(
        'p',
        {},
        'The words that the program, its pages and its documentation use, in the order in which ' +
          'a newcomer meets them. The link of a term is its address.',
      ),
      find,
      list,
    );
    const marked = list.querySelector<HTMLElement>('dt.chosen');
    marked?.scrollIntoView({ block: 'center', behavior: 'instant' });
    marked?.focus({ preventScroll: true });
  },
};
