import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const loadorder: Page = {
  path: 'loadorder',
  title: 'Load order',
  live: true,
  render(view: View) {
    fill(view.root, h('h1', {}, 'Load order'));
  },
};
