// Parts that go from one bench to another, where there are few of them: what to take out in time,
// and where a part comes from.
import type { Benches } from '../../lib/api';
import { before, isDone, numbersOf, verdictOf, type Outcome, type Test } from './outcome';

/** To be taken out after a test, as a test of another bench needs it. */
export interface Given {
  part: string;
  bench: string;
  /** The number of that test. */
  test: number;
  /** When it begins, as the plan has it; '' is not known. */
  when: string;
  /** Before this test, and not after it. */
  before: boolean;
}

/** Put in, as it comes from that bench. */
export interface Got {
  part: string;
  bench: string;
}

type Handover = Benches['handovers'][number];

/**
 * Writes them onto tests. What is to be taken out before the first test that is planned is said of
 * the one that was done last.
 */
export function withHandovers(tests: Test[], handovers: readonly Handover[]): void {
  const planned = (bench: string, step: number | null) =>
    tests.find((test) => test.bench === bench && test.number === step);
  for (const { part, from, to, step, early, after } of handovers) {
    const getting = planned(to, step);
    getting && (getting.gets = [...(getting.gets ?? []), { part, bench: from }]);
    const own = tests.filter(({ bench }) => bench === from);
    const last = own.filter(isDone).at(-1);
    const giving = after === null ? (last ?? own[0]) : planned(from, after);
    if (early && giving) {
      const before = after === null && !last;
      const when = getting?.when ?? '';
      giving.gives = [...(giving.gives ?? []), { part, bench: to, test: step, when, before }];
    }
  }
}

/** Without them, as the sheet is planned again. */
export function withoutHandovers({ gives, gets, ...test }: Test): Test {
  return test;
}

/** "Battery and Screen" */
const listed = (names: readonly string[]): string =>
  names.length > 1 ? `${names.slice(0, -1).join(', ')} and ${names.at(-1)!}` : names.join('');

/** Those that one test needs are one line. `lead` says when, as "after this test ". */
function lines(
  given: readonly Given[],
  time: (planned: string) => string,
  lead: (before: boolean) => string,
): string[] {
  const by = new Map<string, Given[]>();
  for (const each of given) {
    const key = JSON.stringify([each.before, each.bench, each.test]);
    by.set(key, [...(by.get(key) ?? []), each]);
  }
  return [...by.values()].map((some) => {
    const [{ bench, test, when, before }] = some as [Given];
    const at = when === '' ? '' : `, ${time(when)}`;
    return (
      `${lead(before)}take out ${listed(some.map(({ part }) => part))}: ` +
      `${bench} needs ${some.length > 1 ? 'them' : 'it'} for test ${test}${at}`
    );
  });
}

/** "after this test take out Battery: Bench 2 needs it for test 2, day 2, 11:00", a line each. */
export const givesWords = ({ gives = [] }: Test, time: (planned: string) => string): string[] =>
  lines(gives, time, (before) => (before ? 'before this test ' : 'after this test '));

/** "from Bench 1" of a part that a test puts in; '' if it comes from no bench. */
export function fromWords({ gets = [] }: Test, part: string): string {
  const found = gets.find((each) => each.part === part);
  return found ? `from ${found.bench}` : '';
}

/** "Battery comes from Bench 1", a line each. */
export const gotWords = ({ gets = [] }: Test): string[] =>
  [...new Set(gets.map(({ bench }) => bench))].map((bench) => {
    const parts = gets.filter((each) => each.bench === bench).map(({ part }) => part);
    return `${listed(parts)} ${parts.length > 1 ? 'come' : 'comes'} from ${bench}`;
  });

/** What another bench has had by the time that a test begins, so that it is out already. */
export function outAlready({ tests }: Outcome, i: number): ReadonlySet<string> {
  const { gives = [] } = tests[i]!;
  const earlier = before(tests, i);
  return new Set(
    [...gives.filter((each) => each.before), ...(earlier?.gives ?? [])].map(({ part }) => part),
  );
}

/** After a test was put before test `from` of a bench: those behind it have the next number. */
export const withLater = (test: Test, bench: string | null, from: number): Test =>
  test.gives
    ? {
        ...test,
        gives: test.gives.map((each) =>
          each.bench === bench && each.test >= from ? { ...each, test: each.test + 1 } : each,
        ),
      }
    : test;

/** What is to be taken off a bench now: its last test is done, and one that needs it is not. */
export function givesNow(
  outcome: Outcome,
  bench: string | null,
  time: (planned: string) => string,
): string[] {
  const { tests } = outcome;
  const numbers = numbersOf(outcome);
  const own = tests.filter((test) => test.bench === bench);
  const next = own.find((test) => verdictOf(test) === '');
  const last = next ? own[own.indexOf(next) - 1] : own.at(-1);
  const due = [
    ...(last?.gives ?? []).filter(({ before }) => !before),
    ...(next?.gives ?? []).filter(({ before }) => before),
  ].filter(({ bench: to, test: number }) =>
    tests.some((test, i) => test.bench === to && numbers[i] === number && verdictOf(test) === ''),
  );
  return lines(due, time, () => 'now ');
}
