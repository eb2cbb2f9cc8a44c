// What a plan comes to, in words.
import { h } from '../../lib/dom';
import { count } from '../../lib/words';
import { exact, moneyOf, type Job, type Outcome } from './job';

function gapInWords(outcome: Outcome): string {
  const { cost, bound } = outcome;
  if (exact(cost) <= exact(bound)) {
    return 'No plan is cheaper: this is the lower bound.';
  }
  if (bound <= 0) {
    return 'How little it could cost is not known.';
  }
  const money = moneyOf([cost, bound]);
  return `No plan costs less than ${money(bound)}, so this one is at most ${((100 * (cost - bound)) / bound).toFixed(1)} % above the least possible.`;
}

export function headline(job: Job, outcome: Outcome): HTMLElement {
  const rest = outcome.tests.length - outcome.doneBefore;
  const changes = outcome.alternatives[0]!.changes;
  const money = moneyOf([outcome.testCost, outcome.changeCost, ...outcome.tests.map(({ cost }) => cost)]);
  return h(
    'div',
    { class: 'verdict valid' },
    h('h2', {}, job.title),
    h(
      'p',
      {},
      outcome.doneBefore > 0
        ? `${count(outcome.doneBefore, 'test')} done; for the rest: `
        : `${count(job.parts.filter((part) => !part.gone).length, 'part')}, ${job.atOnce} at a time: `,
      h('strong', {}, `${count(rest, 'test')}, ${count(changes, 'change')}, cost ${money(outcome.cost)}`),
      `. ${gapInWords(outcome)}`,
    ),
    outcome.reason && h('details', { class: 'no-print' }, h('summary', {}, 'Why not less'), h('p', {}, outcome.reason)),
    h(
      'p',
      { class: 'hint' },
      `A test costs ${money(outcome.testCost)}; putting a part in costs ${job.parts.some((part) => part.cost !== null) ? `what the list says, else ${money(outcome.changeCost)}` : money(outcome.changeCost)}; taking out is free. Every pair that must meet does: checked by an independent checker.`,
    ),
  );
}
