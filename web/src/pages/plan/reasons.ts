// Why no plan costs less, a line for each thing that there must be at least.
import { h, type Child } from '../../lib/dom';
import { mathText } from '../../lib/mathematics';
import { link } from '../../shell/router';
import { linesOf } from './reason_lines';

const sentence = (words: string): string =>
  `${words.charAt(0).toUpperCase()}${words.slice(1)}${/[.!?]$/.test(words) ? '' : '.'}`;

/** Which of our theorems proves it, by what it says. */
const provenBy = (reason: string): string | null =>
  /tested only with what/.test(reason)
    ? '18'
    : /must meet among themselves/.test(reason)
      ? '28'
      : /new pairs/.test(reason)
        ? '23'
        : null;

/** The lines, and where the proof is. */
export function whyNotLess(reason: string, bound: string): HTMLElement {
  const lines = linesOf(reason, bound);
  const theorem = provenBy(reason);
  return h(
    'details',
    { class: 'no-print why-not-less' },
    h('summary', {}, 'Why not less'),
    h(
      'ul',
      {},
      lines.map(({ said, why }): Child =>
        said === ''
          ? h('li', {}, mathText(sentence(why)))
          : h('li', {}, h('strong', {}, said), ': ', mathText(`${why.replace(/[.]$/, '')}.`)),
      ),
    ),
    theorem &&
      h(
        'p',
        { class: 'hint' },
        'The proof is in ',
        h('a', { href: link('theorems', { theorem }) }, `Theorem ${theorem}`),
        '.',
      ),
  );
}
