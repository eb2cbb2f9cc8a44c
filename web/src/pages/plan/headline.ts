// What a plan comes to, in words.
import { h, type Child } from '../../lib/dom';
import { capital, count, number } from '../../lib/words';
import { exact, moneyOf, type Job } from './job';
import { clockOf } from './sheet';
import { namesOf, repeated, testName, verdictOf, type Outcome } from './outcome';
import { whyNotLess } from './reasons';
import { piecesInWords, severalOf } from './shared';
import { timeWords } from './times';

type Money = (cost: number) => string;

export function gapInWords(cost: number, bound: number, money: Money): string {
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

/** What a plan is judged by: when its last test ends, or else what all of it costs. */
const isEarly = (job: Job, { benches }: Outcome): boolean =>
  benches !== null && job.objective !== 'cost';

/** How far the number of tests is above the lower bound. */
function testsGap({ fewestTests, tests, doneBefore, met }: Outcome): string {
  if (fewestTests === undefined || met.tested < met.needed) {
    return '';
  }
  const all = `No plan for all ${met.what} has fewer`;
  return tests.length - doneBefore === fewestTests
    ? `${all} tests. `
    : `${all} than ${count(fewestTests, 'test')}. `;
}

function gap(job: Job, outcome: Outcome, money: Money): string {
  const { budget, cost, bound, met, soonest, unit } = outcome;
  if (budget !== null && met.tested < met.needed) {
    return (
      `The budget of ${money(budget)} pays for ${number(met.tested)} of ` +
      `${number(met.needed)} ${met.what}.`
    );
  }
  const words = gapInWords(cost, bound, money);
  if (!isEarly(job, outcome)) {
    return unit ? timed(words, unit) : words;
  }
  return words
    .replace('No plan is cheaper', 'No plan is done earlier')
    .replace(/No plan costs less than (\S+),/, (_, least: string) =>
      soonest
        ? `No plan is done before ${timeWords(soonest, job.dayBegins)},`
        : unit
          ? `No plan is done in less than ${least} ${unit},`
          : `No plan is done before ${least},`,
    )
    .replace('so this one is at most', 'so this one takes at most')
    .replace('above the least possible', 'longer than the least possible');
}

const isStop = (note: string): boolean => /^the time limit stopped|^nothing better/.test(note);

/** That the search was stopped, and a longer one if there may be. */
function stopped({ seconds }: Job, outcome: Outcome, longer: (seconds: number) => void): Child[] {
  const note = outcome.notes.find(isStop);
  const more = seconds > 0 && seconds < 60 ? 60 : 600;
  return note === undefined || exact(outcome.cost) <= exact(outcome.bound)
    ? []
    : [
        note.startsWith('the time limit')
          ? ' The search ended with its time. '
          : ` The search ended, as ${note}. `,
        seconds < more &&
          h(
            'button',
            { type: 'button', class: 'plain small no-print', onclick: () => longer(more) },
            `Search ${more === 60 ? '1 minute' : '10 minutes'} for less`,
          ),
      ];
}

/** Why a bound is far off where parts go from bench to bench. */
function waiting({ tests, cost, bound }: Outcome): string {
  return tests.some(({ gets }) => gets) && cost > 1.1 * bound
    ? ' This bound counts little of how benches wait for each other’s parts.'
    : '';
}

/** The same of costs that are times. */
function timed(words: string, unit: string): string {
  return words
    .replace('No plan is cheaper', 'No plan takes less')
    .replace(/No plan costs less than (\S+),/, `No plan takes less than $1 ${unit},`)
    .replace('How little it could cost', 'How little it could take');
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

/** "5 parameters, 15 values" of a model of which each value is in a test; '' for others. */
function modelSize({ tests, benches, met, doneBefore }: Outcome): string {
  const rows = tests.flatMap(({ values }) => (values ? [Object.entries(values)] : []));
  const parameters = rows[0]?.length ?? 0;
  if (parameters === 0 || doneBefore > 0 || met.tested < met.needed) {
    return '';
  }
  const values = new Set(rows.flat().map(([parameter, value]) => `${parameter}\n${value}`)).size;
  const several = benches ? `, ${count(benches.length, 'bench', 'benches')}` : '';
  return `${count(parameters, 'parameter')}, ${count(values, 'value')}${several}`;
}

/** What a test and a change cost, with what says it first. */
function costWords(job: Job, { testCost, changeCost, unit }: Outcome, money: Money): string {
  const costs = unit ? 'takes' : 'costs';
  const of = (cost: number) =>
    unit ? count(cost, unit.slice(0, -1), unit).replace(/^\S+/, money(cost)) : money(cost);
  const byRow = job.changeCosts.trim() !== '' ? 'what its row of costs says, else ' : '';
  const test = `A test ${costs} ${of(testCost)}; `;
  if (job.source === 'model') {
    return `${test}setting another value ${costs} ${byRow}${of(changeCost)}.`;
  }
  const byPart = job.parts.some((part) => part.cost !== null) ? 'what the list says, else ' : '';
  return (
    `${test}putting a part in ${costs} ${byRow}${byPart}${of(changeCost)}; taking out ` +
    `${unit ? 'takes no time' : 'is free'}.`
  );
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

/** What it comes to, in sentences: what is wanted first stands first. */
function comesTo(job: Job, outcome: Outcome, money: Money): string[] {
  const { benches, unit, finish, together, cost, changes } = outcome;
  const tests = count(outcome.tests.length - outcome.doneBefore, 'test');
  const several = (benches?.length ?? 0) > 1 ? ' together' : '';
  const size = `${tests}, ${count(changes, 'change')}`;
  const whole = benches ? together : cost;
  const work = unit
    ? `${money(whole)} ${unit}${benches ? ' of work' : outcome.doneBefore > 0 ? ' more' : ''}${several}`
    : `cost ${money(whole)}${several}`;
  const ends = finish
    ? `done on ${timeWords(finish, job.dayBegins)}`
    : unit
      ? `done after ${money(cost)} ${unit}`
      : `done at ${money(cost)}, with costs as times`;
  return isEarly(job, outcome)
    ? [ends, `${size}, ${work}`]
    : [`${size}, ${work}${benches && finish ? `, ${ends}` : ''}`];
}

/** Who has one of each cannot run a plan with a part on two benches. */
function needsSeveral(job: Job, outcome: Outcome, oneOfEach: () => void): HTMLElement | null {
  const several = severalOf(job, outcome);
  return several.length === 0
    ? null
    : h(
        'p',
        { class: 'needs-several' },
        `The benches use ${piecesInWords(several)} at the same time. `,
        h(
          'span',
          { class: 'no-print' },
          'If there are fewer, write under “how many” what there is. ',
        ),
        h(
          'button',
          { type: 'button', class: 'plain small no-print', onclick: oneOfEach },
          'I have one of each',
        ),
      );
}

export interface Leads {
  /** To the choice whether failed tests count. */
  trust(): void;
  /** To a plan for which there is one of each part. */
  oneOfEach(): void;
  /** To a search of so many seconds. */
  longer(seconds: number): void;
}

export function headline(job: Job, outcome: Outcome, leads: Leads): HTMLElement {
  const { doneBefore, met } = outcome;
  const money = moneyOf([
    outcome.testCost,
    outcome.changeCost,
    outcome.cost,
    outcome.bound,
    outcome.together,
    ...outcome.tests.map(({ cost }) => cost),
  ]);
  const clock = clockOf(outcome.unit);
  const all = exact(outcome.tests.reduce((sum, { cost }) => sum + cost, 0));
  const what = modelSize(outcome) || inShort(job, outcome.benches?.length) || count(0, 'part');
  // How many are done is said already, and that the search was stopped is a sentence.
  const notes = outcome.notes.filter(
    (note) => (doneBefore === 0 || !/done and stays?\.$/.test(note)) && !isStop(note),
  );
  return h(
    'div',
    { class: 'verdict valid' },
    h('h2', { tabindex: -1 }, job.title),
    h(
      'p',
      {},
      doneBefore > 0 ? `${count(doneBefore, 'test')} done; for the rest: ` : `${what}: `,
      comesTo(job, outcome, money).flatMap((words, i): Child[] => [
        i > 0 && '. ',
        h('strong', {}, i > 0 ? capital(words) : words),
      ]),
      clock && !outcome.benches
        ? doneBefore > 0
          ? ` (${clock(all)} on the clock)`
          : `, ${clock(all)} on the clock`
        : null,
      `. ${testsGap(outcome)}${gap(job, outcome, money)}${waiting(outcome)}`,
      ...stopped(job, outcome, leads.longer),
    ),
    needsSeveral(job, outcome, leads.oneOfEach),
    ...again(job, outcome, leads.trust),
    outcome.reason ? whyNotLess(outcome.reason, money(outcome.bound)) : null,
    notes.length > 0
      ? h(
          'details',
          { class: 'no-print', open: notes.some((note) => note.startsWith('A test was added')) },
          h('summary', {}, `${count(notes.length, 'note')} on the job`),
          h(
            'ul',
            {},
            notes.map((note) => h('li', {}, note)),
          ),
        )
      : null,
    h(
      'p',
      { class: 'hint' },
      `${costWords(job, outcome, money)} `,
      doneBefore > 0
        ? `${number(met.needed)} needed ${met.what} were left`
        : `${count(met.needed, met.what.slice(0, -1), met.what)} ` +
            `${met.needed === 1 ? 'is' : 'are'} needed`,
      met.tested === met.needed
        ? `, and ${met.needed === 1 ? 'it is' : 'all are'} tested`
        : `, and ${number(met.tested)} of them are tested`,
      ', counted by an independent checker.',
    ),
  );
}
