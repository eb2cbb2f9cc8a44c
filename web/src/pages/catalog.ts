import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const catalog: Page = {
  path: 'catalog',
  title: 'Catalog',
  
  render(view: View) {
    fill(view.root, h('h1', {}, 'Catalog'));
  },
};
