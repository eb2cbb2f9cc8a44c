import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const design: Page = {
  path: 'design',
  title: 'Design',
  hidden: true,
  render(view: View) {
    fill(view.root, h('h1', {}, 'Design'));
  },
};
