// Tests that were passed over: later ones on their bench have results.
import { isDone, namesOf, testName, verdictOf, type Outcome } from './outcome';

/** So many are named. */
const mostNamed = 4;

/** "Test 1 has no result, but a later test has one …"; '' where results came in order. */
export function skippedWords(outcome: Outcome): string {
  const { tests } = outcome;
  const names = namesOf(outcome);
  const last = new Map(
    tests.flatMap((test, i) => (isDone(test) ? [[test.bench, i] as const] : [])),
  );
  const passed = tests.flatMap((test, i) =>
    verdictOf(test) === '' && i < (last.get(test.bench) ?? -1) ? [testName(test, names[i]!)] : [],
  );
  if (passed.length === 0) {
    return '';
  }
  const one = passed.length === 1;
  const named = passed.slice(0, mostNamed).join('; ');
  const more = passed.length > mostNamed ? ` and ${passed.length - mostNamed} more` : '';
  return (
    `${named[0]!.toUpperCase()}${named.slice(1)}${more} ${one ? 'has' : 'have'} no result, but a ` +
    `later test has one. ${one ? 'Was it' : 'Were they'} skipped? To replan counts ` +
    `${one ? 'it' : 'them'} as not run, and tests ${one ? 'its' : 'their'} pairs later.`
  );
}
