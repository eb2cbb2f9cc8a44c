// What a plan comes to, in words.
import { h, type Child } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { exact, moneyOf, type Job } from './job';
import { clockOf } from './sheet';
import { namesOf, repeated, testName, verdictOf, type Outcome } from './outcome';
import { whyNotLess } from './reasons';

export function gapInWords(cost: number, bound: number, money: (cost: number) => string): string {
  if (exact(cost) <= exact(bound)) {
    return 'No plan is cheaper: this is the lower bound.';
  }
  if (bound <= 0) {
    return 'How little it could cost is not known.';
  }
  return (
    `No plan costs less than ${money(bound)}, so this one is at most ` +
    `${((100 * (cost - bound)) / bound).toFixed(1)}\u00a0% above the least possible.`
  );
}

function gap(outcome: Outcome, money: (cost: number) => string): string {
  const { budget, benches, cost, bound, met, finish } = outcome;
  if (budget !== null && met.tested < met.needed) {
    return (
      `The budget of ${money(budget)} pays for ${number(met.tested)} of ` +
      `${number(met.needed)} ${met.what}.`
    );
  }
  if (!benches) {
    return gapInWords(cost, bound, money);
  }
  const words = gapInWords(cost, bound, money);
  if (outcome.together === cost && benches.length === 1) {
    return words;
  }
  // When the last test ends, and how much work there is on all benches, are two things.
  const unit = outcome.unit ?? (finish ? 'hours' : null);
  const end = finish
    ? `on ${finish}`
    : unit
      ? `${money(cost)} ${unit} after the start`
      : `at ${money(cost)}, with costs as times`;
  const sooner = words
    .replace('No plan is cheaper', 'No plan is done earlier')
    .replace(/No plan costs less than (\S+),/, (_, least: string) =>
      outcome.soonest
        ? `No plan is done before ${outcome.soonest},`
        : unit
          ? `No plan is done in less than ${least} ${unit},`
          : `No plan is done before ${least},`,
    )
    .replace('so this one is at most', 'so this one takes at most')
    .replace('above the least possible', 'longer than the least possible');
  return `The last test ends ${end}. ${sooner}`;
}

/** What is to be tested, in a few words; empty if nothing is there yet. */
export function inShort(job: Job, benches = 0): string {
  const parts = job.parts.filter((part) => !part.gone).length;
  return job.source === 'model'
    ? `The model${benches > 0 ? `, ${count(benches, 'bench', 'benches')}` : ''}`
    : parts === 0
      ? ''
      : `${count(parts, 'part')}` +
        `${job.atOnce === null ? '' : `, ${job.atOnce} at a time`}` +
        `${benches > 0 ? `, ${count(benches, 'bench', 'benches')}` : ''}`;
}

/** What a change costs, with what says it first. */
function changing(job: Job, cost: string): string {
  const byRow = job.changeCosts.trim() !== '' ? 'what its row of costs says, else ' : '';
  if (job.source === 'model') {
    return `setting another value costs ${byRow}${cost}`;
  }
  const byPart = job.parts.some((part) => part.cost !== null) ? 'what the list says, else ' : '';
  return `putting a part in costs ${byRow}${byPart}${cost}; taking out is free`;
}

/** Why a test is there that failed before. `trust` leads to the choice. */
function again(job: Job, outcome: Outcome, trust: () => void): Child[] {
  const { tests, benches, doneBefore } = outcome;
  // On one bench those that were done before are the first ones.
  const earlier = benches ? tests : tests.slice(0, doneBefore);
  const failed = earlier.filter((test) => verdictOf(test) === 'fail').length;
  if (doneBefore === 0 || failed === 0 || job.trustFailed) {
    return [];
  }
  const names = namesOf(outcome);
  const named = (i: number) => testName(tests[i]!, names[i]!);
  const twice = tests.flatMap((_, i) => {
    const first = repeated(tests, i);
    return first < 0 ? [] : [`${named(first)} comes again as ${named(i)}`];
  });
  return [
    h(
      'p',
      {},
      `Pairs that met only in ${failed === 1 ? 'the failed test' : 'failed tests'} count as ` +
        `untested${twice.length > 0 ? `, so ${twice.join(', and ')}` : ''}. `,
      h(
        'button',
        { type: 'button', class: 'as-link no-print', onclick: trust },
        'Count them as tested',
      ),
    ),
  ];
}

/** `trust` leads to the choice whether failed tests count. */
export function headline(job: Job, outcome: Outcome, trust: () => void): HTMLElement {
  const rest = outcome.tests.length - outcome.doneBefore;
  const money = moneyOf([
    outcome.testCost,
    outcome.changeCost,
    outcome.cost,
    outcome.bound,
    outcome.together,
    ...outcome.tests.map(({ cost }) => cost),
  ]);
  const clock = clockOf(outcome.unit);
  const several = (outcome.benches?.length ?? 0) > 1;
  const what = inShort(job, outcome.benches?.length) || count(0, 'part');
  const whole = outcome.benches ? outcome.together : outcome.cost;
  return h(
    'div',
    { class: 'verdict valid' },
    h('h2', { tabindex: -1 }, job.title),
    h(
      'p',
      {},
      outcome.doneBefore > 0
        ? `${count(outcome.doneBefore, 'test')} done; for the rest: `
        : `${what}: `,
      h(
        'strong',
        {},
        `${count(rest, 'test')}, ${count(outcome.changes, 'change')}, ` +
          (several && outcome.unit
            ? `${money(whole)} ${outcome.unit} of work on all benches together`
            : `cost ${money(whole)}${outcome.unit ? ` ${outcome.unit}` : ''}`) +
          (several && !outcome.unit ? ' of all benches together' : ''),
      ),
      clock && !outcome.benches ? `, ${clock(whole)} on the clock` : null,
      `. ${gap(outcome, money)}`,
    ),
    ...again(job, outcome, trust),
    outcome.reason ? whyNotLess(outcome.reason, money(outcome.bound)) : null,
    outcome.notes.length > 0
      ? h(
          'details',
          { class: 'no-print', open: outcome.notes.length <= 2 },
          h('summary', {}, `${count(outcome.notes.length, 'note')} on the job`),
          h(
            'ul',
            {},
            outcome.notes.map((note) => h('li', {}, note)),
          ),
        )
      : null,
    h(
      'p',
      { class: 'hint' },
      `A test costs ${money(outcome.testCost)}; ${changing(job, money(outcome.changeCost))}. `,
      `${number(outcome.met.tested)} of ${number(outcome.met.needed)} needed ` +
        `${outcome.met.what} are tested, counted by an independent checker.`,
    ),
  );
}
