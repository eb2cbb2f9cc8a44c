// Planning: what is asked of the server, and its answer as the page keeps it.
import { post } from '../../lib/api';
import { changeWord } from '../../lib/words';
import { checkJob, exact, step, wantedPairs, type Alternative, type Job, type Outcome, type Test } from './job';

interface Answer {
  tests: { number: number; parts: (string | number)[]; cost: number; done: boolean }[];
  cost: number;
  bound: number | null;
  reason?: string;
  alternatives: { change: number | null; name?: string; tests: number; changes: number; cost: number; bound: number | null }[];
  verified: boolean;
}

/** Plans what is not done yet. Tests that were done stay as they were. */
export async function ask(job: Job, done: readonly Test[], signal: AbortSignal): Promise<Outcome> {
  checkJob(job);
  const pairs = wantedPairs(job);
  const left = job.parts.filter((part) => !part.gone);
  const names = new Set(left.map(({ name }) => name));
  const doneNow = done.map(({ parts }) => parts.filter((name) => names.has(name))).filter((parts) => parts.length > 0);
  const answer = await post<Answer>(
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
  const price = new Map(left.map(({ name, cost }) => [name, cost ?? job.changeCost]));
  const rest: Test[] = answer.tests.filter((test) => !test.done).map(({ parts }) => ({ parts: parts.map(String), cost: 0, done: false }));
  const tests = [...done.map((test) => ({ ...test, done: true })), ...rest];
  let cost = 0;
  let changes = 0;
  for (let i = done.length; i < tests.length; ++i) {
    const put = step(tests, i).in;
    tests[i]!.cost = exact(job.testCost + put.reduce((sum, name) => sum + (price.get(name) ?? job.changeCost), 0));
    cost = exact(cost + tests[i]!.cost);
    changes += put.length;
  }
  const others = answer.alternatives
    .map(({ change, name, ...numbers }): Alternative => ({
      name: name ?? (change === null ? 'local search' : `${changeWord(change)} design`),
      tests: numbers.tests,
      changes: numbers.changes,
      cost: numbers.cost,
    }))
    .filter((each) => each.tests !== rest.length || each.changes !== changes || exact(each.cost) !== cost);
  return {
    tests,
    cost,
    bound: answer.bound,
    reason: answer.reason ?? '',
    alternatives: [{ name: 'this plan', tests: rest.length, changes, cost }, ...others],
    testCost: job.testCost,
    changeCost: job.changeCost,
    doneBefore: done.length,
  };
}
