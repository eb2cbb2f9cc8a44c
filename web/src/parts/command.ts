// A command line as pages show it: no line is broken inside of a word.
import type { Cell } from '../lib/api';
import { h } from '../lib/dom';
import { copyButton } from './copy';

export function command(line: string): HTMLElement {
  return h(
    'code',
    {},
    line.split(' ').flatMap((word, i) => [i > 0 ? ' ' : null, h('span', { class: 'word' }, word)]),
  );
}

/** A command line that can be copied: the button stays beside it, however many lines it takes. */
export function toCopy(line: string): HTMLElement {
  return h(
    'div',
    { class: 'to-copy' },
    command(line),
    copyButton('Copy', () => line),
  );
}

/** What the verbs that take a cell are told of it. */
export const cellArguments = ({ v, k, change, kind, strength = 2 }: Cell): string =>
  `${v} ${k} --change ${change} --${kind}${strength > 2 ? ` --strength ${strength}` : ''}`;
