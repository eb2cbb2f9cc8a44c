// What the page Plan is for, and examples to try.
import { h } from '../../lib/dom';
import { link } from '../../shell/router';
import { examples } from './examples';
import type { Job } from './job';

export function introduction(use: (job: Job) => void): HTMLElement[] {
  const example = ([name, job]: (typeof examples)[number]): HTMLElement =>
    h('a', { href: link('plan'), onclick: (event) => (event.preventDefault(), use(job)) }, name);
  return [
    h('h1', { class: 'no-print' }, 'Plan tests'),
    h(
      'p',
      { class: 'no-print' },
      'A set-up holds some of your parts, and every two parts must be tested together. This ' +
        'page plans the set-ups and their order at the least cost of tests and of parts put in.',
    ),
    h(
      'p',
      { class: 'no-print drop-hint' },
      'Drop a file anywhere: a parts list or a workbook, a run sheet with results, a PICT ' +
        'model, a list of benches. Or try an example: ',
      examples.flatMap((each, i) => [i > 0 ? ', ' : null, example(each)]),
      '.',
    ),
  ];
}
