// A job as it is asked again: with tests that were done, with other costs, with more rules.
import type { Job as Request } from '../../../answers';
import { requestOf, withDone } from './document';
import { exact, lineOf, type Job } from './job';
import { blank, csv, verdictOf, type Outcome, type Place, type Test } from './outcome';

/** The document with the tests that were done, as a run sheet with all its rows. */
export function askedWith(
  job: Job,
  sheet: Outcome | null,
  tests: readonly Test[],
  places: readonly Place[],
): Request {
  const request = requestOf(job);
  if (!tests.some((test) => verdictOf(test) !== '')) {
    return request;
  }
  const done: Outcome = {
    ...(sheet ?? blank(job)),
    benches: tests.some(({ bench }) => bench !== null) ? [] : null,
    tests: [...tests],
    places: [...places],
  };
  return withDone(request, job, csv(done));
}

/** At other costs; the parts' own keep their proportion to the cost for all. */
export function atCosts(job: Job, testCost: number, changeCost: number, times: number): Job {
  const parts = job.parts.map((part) => ({
    ...part,
    cost: part.cost === null ? null : exact(part.cost * times),
  }));
  return { ...job, testCost, changeCost: exact(changeCost), parts };
}

/** Without pairs that fail together. */
export function forbidding(job: Job, faults: readonly string[][]): Job {
  const rows = faults.map((fault) => lineOf([...fault, 'failed together']));
  return { ...job, never: [job.never.trim(), ...rows].filter(Boolean).join('\n') };
}

/** With one of each part. */
export const oneOfEach = (job: Job): Job => ({
  ...job,
  parts: job.parts.map((part) => ({ ...part, quantity: 1 })),
});
