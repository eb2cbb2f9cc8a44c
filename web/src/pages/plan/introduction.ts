// What the page Plan is for, what comes of it, and examples to try.
import { h } from '../../lib/dom';
import { link } from '../../shell/router';
import { sheetPicture } from '../home';
import { examples } from './examples';
import type { Job } from './job';

export interface Introduction {
  readonly element: HTMLElement;
  /** Once there is a sheet, what comes need not be said. */
  planned(): void;
}

const steps = [
  'List your parts below, or drop a file anywhere: a parts list or a workbook, a run sheet with ' +
    'results, a PICT model, a list of benches.',
  'Say how many fit at once, and what a test and a change cost.',
  'Press Plan. You get the set-ups in their order, what to take out and put in, the cost, how ' +
    'far it is from the least possible, and a sheet for the results.',
];

export function introduction(use: (job: Job) => void): Introduction {
  const [[, first], ...others] = examples;
  const example = ([name, job]: (typeof others)[number]): HTMLElement =>
    h('a', { href: link('plan'), onclick: (event) => (event.preventDefault(), use(job)) }, name);
  const element = h(
    'div',
    { class: 'plan-introduction no-print' },
    h(
      'div',
      {},
      h('h1', {}, 'Plan tests'),
      h(
        'p',
        {},
        'A set-up holds some of your parts, and every two parts must be tested together. This ' +
          'page plans the set-ups and their order at the least cost of tests and of parts put in.',
      ),
      h(
        'p',
        { class: 'plan-try' },
        h('button', { type: 'button', onclick: () => use(first) }, 'Try it: a pump bench'),
        ' or ',
        others.flatMap((each, i) => [i > 0 ? ', ' : null, example(each)]),
      ),
      h(
        'details',
        { class: 'plan-comes' },
        h('summary', {}, 'How it works, in three steps'),
        h(
          'ol',
          {},
          steps.map((words) => h('li', {}, words)),
        ),
      ),
    ),
    h(
      'figure',
      { class: 'plan-comes' },
      h('div', { class: 'door-picture' }, sheetPicture()),
      h(
        'figcaption',
        { class: 'hint' },
        'A plan looks like this: nine parts A to I, four at a time, in eight tests. Coloured: put in ' +
          'for this test. In the end every two parts were in a test together.',
      ),
    ),
  );
  return { element, planned: () => element.classList.add('planned') };
}
