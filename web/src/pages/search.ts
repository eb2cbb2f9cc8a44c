import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const search: Page = {
  path: 'search',
  title: 'Search',
  live: true,
  render(view: View) {
    fill(view.root, h('h1', {}, 'Search'));
  },
};
