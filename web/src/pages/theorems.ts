import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const theorems: Page = {
  path: 'theorems',
  title: 'Theorems',
  
  render(view: View) {
    fill(view.root, h('h1', {}, 'Theorems'));
  },
};
