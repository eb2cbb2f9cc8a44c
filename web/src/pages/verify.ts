import { fill, h } from '../lib/dom';
import type { Page, View } from '../shell/router';

export const verify: Page = {
  path: 'verify',
  title: 'Verify',
  live: true,
  render(view: View) {
    fill(view.root, h('h1', {}, 'Verify'));
  },
};
