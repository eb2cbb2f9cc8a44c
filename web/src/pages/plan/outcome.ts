// What was planned: tests with their places, costs and results, as the page keeps them.
import type { Benches, Plan, Planned } from '../../lib/api';
import { fromWords, givesWords, withHandovers, withoutHandovers } from './handover';
import type { Given, Got } from './handover';
import { exact, namesIn, type Job, type Unit } from './job';

/** A place of the bench: its number, and of which slot it is. */
export interface Place {
  number: number;
  slot: string | null;
}

export interface Test {
  /** On which bench, if there are several. */
  bench: string | null;
  /** Its number in its list, which it keeps; without it the one after that of the test before. */
  number?: number;
  parts: string[];
  /** By place; null is an empty place. Without places there is no such list. */
  places: (string | null)[] | null;
  cost: number;
  /** Of a model: a value for each parameter. */
  values?: Record<string, string>;
  /** When it begins on its bench, as the plan has it. */
  when?: string;
  /** When it ends there. */
  ends?: string;
  /** The same two as times since the start, in the unit of costs. */
  span?: [begin: number, end: number];
  /** Parts that were given up while the bench waited, and are put in again. */
  again?: string[];
  gives?: Given[];
  gets?: Got[];
  /** "pass", "fail", …, as it was written; '' is none. */
  result: string;
  notes: string;
  by: string;
  at: string;
}

/** A way to run the tests, known by its numbers alone. */
export interface Alternative {
  name: string;
  tests: number;
  changes: number;
  cost: number;
}

export interface Outcome {
  /** `start`: what is mounted there before its first test; `hours`: how long its day is. */
  benches:
    { name: string; down: boolean; end: number; start: string[]; hours: number | null }[] | null;
  /** What is mounted before the first test, on one bench. */
  start: string[];
  places: Place[];
  tests: Test[];
  /**
   * Of the tests that the last planning was about: those done before are not in it. Of benches that
   * are to be done early, the end of the last test.
   */
  cost: number;
  bound: number;
  /** The fewest tests that a plan can have, if the plan is to have few. */
  fewestTests?: number;
  /** When all can be done at the soonest, of benches with hours. */
  soonest?: string | null;
  /** Of all benches together. */
  together: number;
  reason: string;
  changes: number;
  met: { what: 'pairs' | 'triples'; needed: number; tested: number };
  budget: number | null;
  unit: Exclude<Unit, '' | 'money'> | null;
  /** The day and hour when all is done, of benches with hours. */
  finish: string | null;
  /** The plan itself is the first. */
  alternatives: Alternative[];
  notes: string[];
  testCost: number;
  changeCost: number;
  /** How many tests were done when this was planned. */
  doneBefore: number;
  /** The number of the plan on the server that made it; it forgets old ones. */
  plan?: number | null;
}

export interface State {
  id: string;
  job: Job;
  outcome: Outcome | null;
}

export type Verdict = 'pass' | 'fail' | 'done' | 'not run' | 'other' | '';

/** What a result says, in the words that the planner reads. */
export function verdictOf({ result }: Pick<Test, 'result'>): Verdict {
  const word = result.trim().toLowerCase();
  return word === ''
    ? ''
    : /^(pass(ed)?|ok|okay|good|green|yes|y|p|✓)\b/.test(word)
      ? 'pass'
      : /^(fail(ed|ure|s)?|bad|red|no|n|f|error|✗|x)\b/.test(word)
        ? 'fail'
        : /^(done|run)\b/.test(word)
          ? 'done'
          : /^(not run|skipped|blocked)\b/.test(word)
            ? 'not run'
            : 'other';
}

/** Whether it was run, with whatever result. */
export function isDone(test: Test): boolean {
  const verdict = verdictOf(test);
  return verdict !== '' && verdict !== 'not run';
}

/** The number of each test in its list. */
export function numbersOf({ tests }: Pick<Outcome, 'tests'>): number[] {
  const last = new Map<string | null, number>();
  return tests.map(({ bench, number }) => {
    const n = number ?? (last.get(bench) ?? 0) + 1;
    last.set(bench, n);
    return n;
  });
}

/** What a test is called: its number in its list. */
export function namesOf(outcome: Outcome): string[] {
  const numbers = numbersOf(outcome);
  return outcome.tests.map(({ bench }, i) =>
    bench === null ? String(numbers[i]) : `${bench} ${numbers[i]}`,
  );
}

/** What a test is kept by: its place in its list, which has no gaps. */
export const keysOf = ({ tests }: Outcome): string[] =>
  namesOf({ tests: tests.map(({ bench }) => ({ bench })) } as Outcome);

/** "test 2", "Bench 1, test 2": a name of namesOf() in a sentence. */
export function testName({ bench }: Test, name: string): string {
  return bench === null ? `test ${name}` : `${bench}, test ${name.slice(bench.length + 1)}`;
}

/**
 * Tests that were read from files name no bench: the sheet that was planned here says it, by the
 * set-up.
 */
export function onBenches(done: readonly Test[], sheet: Outcome | null): Test[] {
  const open = sheet?.benches ? [...sheet.tests] : [];
  return done.map((test) => {
    const i =
      test.bench === null
        ? open.findIndex(
            ({ parts }) =>
              parts.length === test.parts.length &&
              parts.every((name) => test.parts.includes(name)),
          )
        : -1;
    const [planned] = i < 0 ? [] : open.splice(i, 1);
    return planned ? { ...planned, result: test.result, notes: test.notes } : test;
  });
}

/** The test before this one on the same bench. */
export function before(tests: readonly Test[], i: number): Test | null {
  for (let j = i - 1; j >= 0; --j) {
    if (tests[j]!.bench === tests[i]!.bench) {
      return tests[j]!;
    }
  }
  return null;
}

/** What is mounted on a bench before its first test. */
function startOf({ benches, start }: Outcome, bench: string | null): readonly string[] {
  return bench === null ? start : (benches?.find(({ name }) => name === bench)?.start ?? []);
}

/** What is taken out for a test and what is put in. */
export function step(outcome: Outcome, i: number): { out: string[]; in: string[] } {
  const { parts: now, bench } = outcome.tests[i]!;
  const earlier = before(outcome.tests, i)?.parts ?? startOf(outcome, bench);
  const again = new Set(outcome.tests[i]!.again);
  return {
    out: earlier.filter((name) => !now.includes(name) || again.has(name)),
    in: now.filter((name) => !earlier.includes(name) || again.has(name)),
  };
}

/** Of an open test: the failed one that had the same parts; -1 is none. */
export function repeated(tests: readonly Test[], i: number): number {
  const { parts } = tests[i]!;
  return verdictOf(tests[i]!) !== ''
    ? -1
    : tests.findIndex(
        (other) =>
          verdictOf(other) === 'fail' &&
          other.parts.length === parts.length &&
          other.parts.every((name) => parts.includes(name)),
      );
}

/** "repeats failed test 2"; '' for a test that does not. */
export function repeats(outcome: Outcome, i: number): string {
  const failed = repeated(outcome.tests, i);
  return failed < 0
    ? ''
    : `repeats failed ${testName(outcome.tests[failed]!, namesOf(outcome)[failed]!)}`;
}

/** Plans of before numbered no step. */
const numbered = ({ step: number }: { step?: number }): { number?: number } =>
  number === undefined ? {} : { number };

const untested = { result: '', notes: '', by: '', at: '' };

/** A time on one of the days. Its hour is in the unit of costs. */
interface DayTime {
  day?: number;
  hour?: number;
  date?: string;
}

function clock(time: DayTime | null | undefined, unit: Outcome['unit']): string | null {
  const { day, hour, date } = time ?? {};
  if (day === undefined || hour === undefined) {
    return null;
  }
  const minutes = Math.round(hour * hoursOf[unit ?? 'hours'] * 60);
  const [hours, rest] = [Math.floor(minutes / 60), String(minutes % 60).padStart(2, '0')];
  return `${date ?? `day ${day}`}, ${hours}:${rest}`;
}

/**
 * What was mounted before the first test of a bench: where tests were done, the plan begins with
 * what the last of them left there.
 */
function started(planned: string[], asked: string, done: readonly Test[]): string[] {
  return done.length > 0 ? namesIn(asked) : planned;
}

/** Notes of the planner as a page says them. */
export const noted = (notes: readonly string[]): string[] =>
  notes.map((note) =>
    note
      .replace(
        /: the question is that of its hidden sheet [\w-]+/,
        ': the job was read from the workbook',
      )
      .replace(
        /^done: (\d+ of \d+ tests?) (?:has a result and is|have a result and are) done$/,
        (_, some: string) =>
          `${some} ${/^1 /.test(some) ? 'is done and stays' : 'are done and stay'}.`,
      ),
  );

export const hoursOf = { seconds: 1 / 3600, minutes: 1 / 60, hours: 1 };

/** The same places first, as they were numbered; then new ones. */
function placed(test: Test, from: readonly Place[], to: readonly Place[]): Test {
  if (!test.places) {
    return test;
  }
  const places = to.map(({ number, slot }) => {
    const i = from.findIndex((each) => each.number === number && each.slot === slot);
    return i < 0 ? null : (test.places![i] ?? null);
  });
  return { ...test, places: places.filter(Boolean).length === test.parts.length ? places : null };
}

function ofPlan(plan: Plan, job: Job, done: readonly Test[], places: readonly Place[]): Outcome {
  const triples = plan.triples_needed > 0;
  const tests = plan.steps.map((each): Test => ({
    bench: null,
    ...numbered(each),
    parts: each.set_up,
    places: each.places,
    cost: each.cost,
    ...(each.values ? { values: each.values } : {}),
    ...untested,
  }));
  const { changes, cost } = plan;
  return {
    benches: null,
    start: started(plan.start, job.start, done),
    places: plan.places,
    tests: [...done.map((test) => placed(test, places, plan.places)), ...tests],
    cost,
    bound: plan.lower_bound.cost,
    ...(plan.objective === 'tests' ? { fewestTests: plan.lower_bound.tests } : {}),
    together: cost,
    reason: plan.lower_bound.reason,
    changes,
    met: {
      what: triples ? 'triples' : 'pairs',
      needed: triples ? plan.triples_needed : plan.pairs_needed,
      tested: triples ? plan.triples_tested : plan.pairs_tested,
    },
    budget: plan.budget,
    unit: plan.cost_unit,
    finish: null,
    alternatives: [
      { name: 'this plan', tests: plan.tests, changes, cost },
      ...plan.candidates
        .filter(
          (each) => each.tests !== plan.tests || each.changes !== changes || each.cost !== cost,
        )
        .map(({ name, tests: n, changes: c, cost: sum }) => ({
          name,
          tests: n,
          changes: c,
          cost: sum,
        })),
    ],
    notes: noted(plan.notes),
    testCost: job.testCost,
    changeCost: job.changeCost,
    doneBefore: done.length,
  };
}

function ofBenches(
  plan: Benches,
  job: Job,
  done: readonly Test[],
  places: readonly Place[],
): Outcome {
  const triples = plan.triples_needed > 0;
  const early = plan.objective !== 'cost';
  const tests = plan.sheets.flatMap((sheet) => [
    ...done
      .filter(({ bench }) => bench === sheet.name)
      // The clock starts again: when they were to run no longer counts.
      .map(({ span, when, ends, ...test }) => placed(withoutHandovers(test), places, plan.places)),
    ...sheet.steps.map((each): Test => {
      const when = clock(each, plan.cost_unit);
      const ends = clock(each.finish, plan.cost_unit);
      return {
        bench: sheet.name,
        ...numbered(each),
        parts: each.set_up,
        places: each.places,
        cost: each.cost,
        ...(each.values ? { values: each.values } : {}),
        ...(when ? { when } : {}),
        ...(ends ? { ends } : {}),
        span: [each.begin, each.end],
        ...(each.again ? { again: each.again } : {}),
        ...untested,
      };
    }),
  ]);
  withHandovers(tests, plan.handovers ?? []);
  const cost = early ? plan.makespan : plan.cost;
  return {
    benches: plan.sheets.map(({ name, down, end, start, hours }) => ({
      name,
      hours,
      down,
      end,
      start: started(
        start,
        job.benches.find((each) => each.name === name)?.start ?? '',
        done.filter(({ bench }) => bench === name),
      ),
    })),
    start: [],
    places: plan.places,
    tests,
    cost,
    bound: early ? plan.lower_bound.makespan : plan.lower_bound.cost,
    ...(plan.objective === 'tests' ? { fewestTests: plan.lower_bound.tests } : {}),
    together: plan.cost,
    reason: early ? plan.lower_bound.makespan_reason : plan.lower_bound.cost_reason,
    changes: plan.changes,
    met: {
      what: triples ? 'triples' : 'pairs',
      needed: triples ? plan.triples_needed : plan.pairs_needed,
      tested: triples ? plan.triples_tested : plan.pairs_tested,
    },
    budget: plan.budget,
    // Where benches have hours, costs are hours unless the job says what else they are.
    unit: plan.cost_unit ?? (plan.sheets.some(({ hours }) => hours !== null) ? 'hours' : null),
    finish: clock(plan.finish, plan.cost_unit),
    soonest: clock(plan.lower_bound.finish, plan.cost_unit),
    alternatives: [
      { name: 'this plan', tests: plan.tests, changes: plan.changes, cost },
      ...plan.candidates.slice(1).map((each) => ({
        name: each.name,
        tests: each.tests,
        changes: each.changes,
        cost: early ? each.makespan : each.cost,
      })),
    ],
    notes: noted(plan.notes),
    testCost: job.testCost,
    changeCost: job.changeCost,
    doneBefore: done.length,
  };
}

/** What was planned after these tests, whose places are `places`. */
export function outcomeOf(
  planned: Planned,
  job: Job,
  done: readonly Test[],
  places: readonly Place[],
): Outcome {
  if (planned.plan) {
    return ofPlan(planned.plan, job, done, places);
  }
  if (planned.benches) {
    return ofBenches(planned.benches, job, done, places);
  }
  throw new Error('the server answered no plan');
}

/** A spreadsheet would compute what begins like a formula. */
const safe = (name: string) => (/^[=+\-@\t]/.test(name) ? `'${name}` : name);
const quote = (field: string) =>
  /[",\n]/.test(field) ? `"${field.replaceAll('"', '""')}"` : field;

/** What goes from bench to bench with a test, as the library writes it. */
const handedOver = (test: Test, time: (planned: string) => string): string =>
  [
    ...(test.gets ?? []).map(({ part }) => `${part} ${fromWords(test, part)}`),
    ...givesWords(test, time),
  ].join('; ');

/**
 * The run sheet as CSV with the columns of the command line, which reads it back as `--done`.
 * `time` says a time of the plan as people do.
 */
export function csv(
  outcome: Outcome,
  time: (planned: string) => string = (planned) => planned,
): string {
  const { tests, places, benches } = outcome;
  const names = namesOf(outcome);
  const parameters = Object.keys(tests.find((test) => test.values)?.values ?? {});
  const width = Math.max(
    places.length,
    ...tests.map((test) => (test.places ? 0 : test.parts.length)),
  );
  const heads = Array.from({ length: width }, (_, i) => {
    const place = places[i];
    return place
      ? `slot_${place.number}${place.slot === null ? '' : ` ${place.slot}`}`
      : `slot_${i + 1}`;
  });
  const handsOver = tests.some(({ gets }) => gets !== undefined);
  const sums = new Map<string | null, number>();
  const rows = tests.map((test, i) => {
    const sum = exact((sums.get(test.bench) ?? 0) + test.cost);
    sums.set(test.bench, sum);
    const { out, in: put } = step(outcome, i);
    const row = test.places ?? test.parts;
    return [
      ...(benches ? [safe(test.bench ?? '')] : []),
      benches ? names[i]!.slice((test.bench ?? '').length + 1) : names[i]!,
      ...(parameters.length > 0
        ? parameters.map((name) => safe(test.values?.[name] ?? ''))
        : [
            safe(out.join(', ')),
            safe(put.join(', ')),
            ...(handsOver ? [safe(handedOver(test, time))] : []),
            ...heads.map((_, j) => safe(row[j] ?? '')),
          ]),
      String(test.cost),
      String(sum),
      test.result,
      safe(test.notes),
    ];
  });
  const head = [
    ...(benches ? ['bench'] : []),
    'step',
    ...(parameters.length > 0
      ? parameters
      : ['take_out', 'put_in', ...(handsOver ? ['hand_over'] : []), ...heads]),
    'cost',
    'cost_so_far',
    'result',
    'notes',
  ];
  return [head, ...rows].map((row) => row.map(quote).join(',')).join('\n') + '\n';
}

/** A sheet without a test. */
export function blank(job: Job): Outcome {
  return {
    benches: null,
    start: namesIn(job.start),
    places: [],
    tests: [],
    cost: 0,
    bound: 0,
    together: 0,
    reason: '',
    changes: 0,
    met: { what: 'pairs', needed: 0, tested: 0 },
    budget: null,
    unit: null,
    finish: null,
    alternatives: [],
    notes: [],
    testCost: job.testCost,
    changeCost: job.changeCost,
    doneBefore: 0,
  };
}
