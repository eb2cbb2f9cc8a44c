// The test that tells most, put into the sheet before the tests that are left.
import type { Diagnosis } from '../../lib/api';
import { decimal, exact, type Job } from './job';
import { withLater } from './handover';
import { isDone, numbersOf, step, type Outcome, type Test } from './outcome';

/** Of a model: the parameter and the value that each part of a plan stands for. */
export function valuesOf({ tests }: Outcome): Map<string, readonly [string, string]> {
  const found = new Map<string, readonly [string, string]>();
  for (const { parts, values } of tests) {
    Object.entries(values ?? {}).forEach((pair, i) => found.set(parts[i] ?? '', pair));
  }
  return found;
}

/** "OS = Windows" for a value of a model, "part Fan" for a part. */
export function partWords(outcome: Outcome): (part: string) => string {
  const values = valuesOf(outcome);
  return (part) => {
    const pair = values.get(part);
    return pair ? `${pair[0]} = ${pair[1]}` : `part ${part}`;
  };
}

/** The values of a set-up, parameter by parameter; null if its plan is of parts. */
function valuesIn(outcome: Outcome, setUp: readonly string[]): Record<string, string> | null {
  const parameters = Object.keys(outcome.tests.find(({ values }) => values)?.values ?? {});
  const known = valuesOf(outcome);
  return parameters.length === 0
    ? null
    : Object.fromEntries(
        parameters.map((parameter, i) => {
          const part = setUp[i] ?? '';
          return [parameter, known.get(part)?.[1] ?? part];
        }),
      );
}

/** What a test costs after the one before it. Jobs with a table of costs have no diagnosis. */
function costOf(job: Job, outcome: Outcome, i: number): number {
  const bench = job.benches.find(({ name }) => name === outcome.tests[i]!.bench);
  const [own, factor] = [bench?.testCost.trim() || '', bench?.changeFactor.trim() || '1'];
  const parts = new Map(job.parts.map(({ name, cost }) => [name, cost]));
  const changes = step(outcome, i)
    .in.map((name) => parts.get(name) ?? job.changeCost)
    .reduce((sum, cost) => sum + cost, 0);
  return exact(
    (own === '' ? job.testCost : decimal(own, 'Cost of a test')) +
      decimal(factor, 'Factor of changes') * changes,
  );
}

/** What becomes of the totals when one bench has this much more to do. */
function withMore(outcome: Outcome, bench: string | null, cost: number, changes: number): Outcome {
  const benches = outcome.benches?.map((each) =>
    each.name === bench ? { ...each, end: exact(each.end + cost) } : each,
  );
  const early = benches !== undefined && outcome.cost !== outcome.together;
  const all = early
    ? Math.max(outcome.cost, ...benches.map(({ end }) => end))
    : exact(outcome.cost + cost);
  const [plan, ...others] = outcome.alternatives;
  return {
    ...outcome,
    benches: benches ?? null,
    cost: all,
    together: exact(outcome.together + cost),
    changes: outcome.changes + changes,
    alternatives: plan
      ? [{ ...plan, tests: plan.tests + 1, changes: plan.changes + changes, cost: all }, ...others]
      : [],
  };
}

/** Where hours were planned, those after the new test are no longer right. */
function withoutTimes(outcome: Outcome, bench: string | null): Outcome {
  const late = (test: Test) => test.bench === bench && !isDone(test) && test.span !== undefined;
  if (!outcome.tests.some(late)) {
    return outcome;
  }
  const note =
    `A test was added${bench === null ? '' : ` to ${bench}`}: when the tests after it begin is ` +
    `known again once the remaining tests are replanned.`;
  return {
    ...outcome,
    tests: outcome.tests.map((test) => {
      const { when, ends, span, ...rest } = test;
      return late(test) ? rest : test;
    }),
    notes: [...outcome.notes.filter((each) => each !== note), note],
  };
}

/** The test that tells most, as the next one of the sheet; the test after it costs anew. */
export function withNext(
  outcome: Outcome,
  next: NonNullable<Diagnosis['next']>,
  job: Job,
): Outcome {
  const places = outcome.places.map(
    ({ number }) => next.places.find((place) => place.number === number)?.part ?? null,
  );
  const bench = outcome.benches?.find(({ down }) => !down)?.name ?? null;
  const whole = places.filter(Boolean).length === next.set_up.length;
  const values = valuesIn(outcome, next.set_up);
  const test: Test = {
    bench,
    parts: next.set_up,
    places: whole ? places : null,
    cost: next.cost,
    ...(values ? { values } : {}),
    ...{ result: '', notes: '', by: '', at: '' },
  };
  const open = outcome.tests.findIndex((each) => each.bench === bench && !isDone(each));
  const at = open < 0 ? outcome.tests.length : open;
  const tests = [...outcome.tests];
  // It takes the number of the one before which it stands.
  const numbers = numbersOf(outcome);
  tests.splice(at, 0, open < 0 ? test : { ...test, number: numbers[open]! });
  for (let i = at + 1; i < tests.length; ++i) {
    if (tests[i]!.bench === bench) {
      tests[i] = { ...tests[i]!, number: numbers[i - 1]! + 1 };
    }
  }
  if (open >= 0) {
    tests.forEach((each, i) => (tests[i] = withLater(each, bench, numbers[open]!)));
  }
  let [cost, changes] = [next.cost, next.put_in.length];
  if (open >= 0) {
    const later = tests[at + 1]!;
    const more = { ...outcome, tests };
    const anew = costOf(job, more, at + 1);
    cost = exact(cost + anew - later.cost);
    changes += step(more, at + 1).in.length - step(outcome, at).in.length;
    tests[at + 1] = { ...later, cost: anew };
  }
  return withoutTimes(withMore({ ...outcome, tests }, bench, cost, changes), bench);
}
