import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const plan: Page = {
  path: 'plan',
  title: 'Plan',
  live: true,
  render(view: View) {
    fill(view.root, h('h1', {}, 'Plan'));
  },
};
