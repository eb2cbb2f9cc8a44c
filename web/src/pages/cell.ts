import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const cell: Page = {
  path: 'cell',
  title: 'Cell',
  hidden: true,
  render(view: View) {
    fill(view.root, h('h1', {}, 'Cell'));
  },
};
