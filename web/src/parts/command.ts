// A command line as pages show it: no line is broken inside of a word.
import { h } from '../lib/dom';

export function command(line: string): HTMLElement {
  return h(
    'code',
    {},
    line.split(' ').flatMap((word, i) => [i > 0 ? ' ' : null, h('span', { class: 'word' }, word)]),
  );
}
