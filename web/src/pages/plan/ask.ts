// Planning: what is asked of the server, and its answer as the page keeps it.
import { post, type Plan } from '../../lib/api';
import { checkJob, wantedPairs, type Job, type Outcome, type Test } from './job';

/** Plans what is not done yet. Tests that were done stay as they were. */
export async function ask(job: Job, done: readonly Test[], signal: AbortSignal): Promise<Outcome> {
  checkJob(job);
  const pairs = wantedPairs(job);
  const left = job.parts.filter((part) => !part.gone);
  const names = new Set(left.map(({ name }) => name));
  const doneNow = done.map(({ parts }) => parts.filter((name) => names.has(name))).filter((parts) => parts.length > 0);
  const answer = await post(
    'plan',
    {},
    {
      parts: left.map(({ name, cost }) => ({ name, cost: cost ?? job.changeCost })),
      at_once: job.atOnce,
      test_cost: job.testCost,
      change_cost: job.changeCost,
      ...(pairs ? { pairs } : {}),
      ...(doneNow.length > 0 ? { done: doneNow } : {}),
      ...(job.seconds > 0 ? { seconds: job.seconds } : {}),
    },
    signal,
  );
  const { steps, tests, changes, cost, lower_bound: bound, candidates } = answer.plan as Plan;
  return {
    tests: [
      ...done.map((test) => ({ ...test, done: true })),
      ...steps.map((step): Test => ({ parts: step.set_up, cost: step.cost, done: false })),
    ],
    cost,
    bound: bound.cost,
    reason: bound.reason,
    alternatives: [
      { name: 'this plan', tests, changes, cost },
      ...candidates.filter((each) => each.tests !== tests || each.changes !== changes || each.cost !== cost),
    ],
    testCost: job.testCost,
    changeCost: job.changeCost,
    doneBefore: done.length,
  };
}
