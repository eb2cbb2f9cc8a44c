// Where a job is kept: all of it in the link as long as it is short, and in this browser in any
// case.
import { longestWord, pack, unpack } from '../../lib/share';
import { emptyBench, emptyJob, namesIn, type Bench, type Job, type Part, type Slot } from './job';
import type { Given, Got } from './handover';
import { isDone, type Outcome, type State, type Test } from './outcome';

const prefix = 'changeover-job-';
const mostKept = 30;

/** What differs from an empty job, and tests with numbers for names: short enough for a link. */
interface Small {
  id: string;
  job: Record<string, unknown>;
  outcome: null | (Omit<Outcome, 'tests'> & { names: string[]; tests: unknown[][] });
}

function differing<T extends object>(all: T, usual: T): Partial<T> {
  return Object.fromEntries(
    Object.entries(all).filter(
      ([key, value]) => JSON.stringify(value) !== JSON.stringify(usual[key as keyof T]),
    ),
  ) as Partial<T>;
}

export function packed({ id, job, outcome }: State): Small {
  const { parts, benches, ...rest } = job;
  const small: Record<string, unknown> = differing(rest, emptyJob());
  if (parts.length > 0) {
    small['parts'] = parts.map(({ name, cost, slot, quantity, gone }) => {
      const row: unknown[] = [name, cost, slot, quantity, gone ? 1 : 0];
      while (row.length > 1 && [null, '', 0].includes(row.at(-1) as null)) {
        row.pop();
      }
      return row;
    });
  }
  if (benches.length > 0) {
    small['benches'] = benches.map((bench) => differing(bench, emptyBench()));
  }
  if (!outcome) {
    return { id, job: small, outcome: null };
  }
  const names: string[] = [];
  const number = (name: string) => {
    const i = names.indexOf(name);
    return i < 0 ? names.push(name) - 1 : i;
  };
  const tests = outcome.tests.map((test) => [
    test.places
      ? test.places.map((name) => (name === null ? -1 : number(name)))
      : test.parts.map(number),
    test.places ? 1 : 0,
    test.cost,
    test.bench,
    test.result,
    test.notes,
    test.by,
    test.at,
    test.when ?? null,
    test.values ?? null,
    test.places ? test.parts.map(number) : null,
    test.span || test.ends ? [...(test.span ?? [null, null]), test.ends ?? null] : null,
    test.number ?? null,
    test.again || test.gives || test.gets
      ? { again: test.again, gives: test.gives, gets: test.gets }
      : null,
  ]);
  return { id, job: small, outcome: { ...outcome, names, tests } };
}

const isText = (x: unknown): x is string => typeof x === 'string';
const isNumber = (x: unknown): x is number => typeof x === 'number' && Number.isFinite(x);
const isList = (x: unknown): x is unknown[] => Array.isArray(x);
const isObject = (x: unknown): x is Record<string, unknown> =>
  typeof x === 'object' && x !== null && !Array.isArray(x);
const isRow = (x: unknown): x is [string, ...unknown[]] => isList(x) && isText(x[0]);

/** Takes the fields of `usual` that have the same type there; anything else is refused. */
function like<T extends object>(usual: T, given: Record<string, unknown>): T | null {
  for (const [key, value] of Object.entries(given)) {
    if (!(key in usual) || (value !== null && typeof value !== typeof usual[key as keyof T])) {
      return null;
    }
  }
  return { ...usual, ...given } as T;
}

function jobIn(given: Record<string, unknown>): Job | null {
  const { parts = [], benches = [], slots = [], atOnce = emptyJob().atOnce, ...rest } = given;
  if (
    !isList(parts) ||
    !parts.every(isRow) ||
    !isList(benches) ||
    !benches.every(isObject) ||
    !isList(slots) ||
    !slots.every(isObject)
  ) {
    return null;
  }
  const job = like(emptyJob(), rest);
  const readBenches = benches.map((bench) => like(emptyBench(), bench));
  const readSlots = slots.map((slot) => like<Slot>({ name: '', least: '', most: '' }, slot));
  if (
    !job ||
    readBenches.includes(null) ||
    readSlots.includes(null) ||
    !(atOnce === null || isNumber(atOnce)) ||
    Object.values(job).includes(null)
  ) {
    return null;
  }
  const known =
    ['parts', 'model'].includes(job.source) && ['all', 'only', 'skip'].includes(job.pairMode);
  return known
    ? {
        ...job,
        atOnce,
        benches: readBenches as Bench[],
        slots: readSlots as Slot[],
        parts: parts.map(([name, cost, slot, quantity, gone]): Part => ({
          name,
          cost: isNumber(cost) ? cost : null,
          slot: isText(slot) ? slot : '',
          quantity: isNumber(quantity) ? quantity : null,
          gone: Boolean(gone),
        })),
      }
    : null;
}

/** Parts of a test that are put in again, or go from one bench to another. */
function movedIn({ again, gives, gets }: Record<string, unknown>): Partial<Test> {
  const moves = (list: unknown): list is Record<string, unknown>[] =>
    isList(list) &&
    list.every((each) => isObject(each) && isText(each['part']) && isText(each['bench']));
  const isGiven = (each: Record<string, unknown>) =>
    isNumber(each['test']) && isText(each['when']) && typeof each['before'] === 'boolean';
  return {
    ...(isList(again) && again.every(isText) ? { again } : {}),
    ...(moves(gives) && gives.every(isGiven) ? { gives: gives as unknown as Given[] } : {}),
    ...(moves(gets) ? { gets: gets as unknown as Got[] } : {}),
  };
}

function testIn(row: unknown, names: readonly string[]): Test | null {
  if (!isList(row)) {
    return null;
  }
  const [set, placed, cost, bench, result, notes, by, at, when, values, order, span, number, more] =
    row;
  const numbers = (list: unknown): list is number[] =>
    isList(list) && list.every((i) => isNumber(i) && i >= -1 && i < names.length);
  const good =
    numbers(set) &&
    isNumber(cost) &&
    (bench === null || isText(bench)) &&
    [result, notes, by, at].every(isText) &&
    (order === null || numbers(order));
  if (!good || (values !== null && !(isObject(values) && Object.values(values).every(isText)))) {
    return null;
  }
  const parts = ((order as number[] | null) ?? set).filter((i) => i >= 0).map((i) => names[i]!);
  return {
    bench,
    ...(isNumber(number) ? { number } : {}),
    parts,
    places: placed ? set.map((i) => (i < 0 ? null : names[i]!)) : null,
    cost,
    ...(isText(when) ? { when } : {}),
    ...(isList(span) && isText(span[2]) ? { ends: span[2] } : {}),
    ...(isList(span) && isNumber(span[0]) && isNumber(span[1]) ? { span: [span[0], span[1]] } : {}),
    ...(isObject(more) ? movedIn(more) : {}),
    ...(values === null ? {} : { values: values as Record<string, string> }),
    result: result as string,
    notes: notes as string,
    by: by as string,
    at: at as string,
  };
}

/** Sheets of before say nothing of what was mounted at first; the job does. */
function startIn(given: unknown, asked: string): string[] | null {
  if (given !== undefined) {
    return isList(given) && given.every(isText) ? given : null;
  }
  try {
    return namesIn(asked);
  } catch {
    return [];
  }
}

function outcomeIn(given: Record<string, unknown>, job: Job): Outcome | null {
  const { names, tests, benches, places, alternatives, met, notes, unit, finish, budget, ...rest } =
    given;
  if (
    !isList(names) ||
    !names.every(isText) ||
    !isList(tests) ||
    !isList(places) ||
    !isList(alternatives) ||
    !isList(notes) ||
    !isObject(met)
  ) {
    return null;
  }
  const read = tests.map((row) => testIn(row, names));
  const start = startIn(rest['start'], benches === null ? job.start : '');
  const numbers = ['cost', 'bound', 'together', 'changes', 'testCost', 'changeCost', 'doneBefore'];
  const good =
    !read.includes(null) &&
    start !== null &&
    numbers.every((key) => isNumber(rest[key])) &&
    isText(rest['reason']) &&
    notes.every(isText) &&
    (budget === null || isNumber(budget)) &&
    (finish === null || isText(finish)) &&
    (rest['soonest'] == null || isText(rest['soonest'])) &&
    [null, 'seconds', 'minutes', 'hours'].includes(unit as null) &&
    ['pairs', 'triples'].includes(met['what'] as string) &&
    isNumber(met['needed']) &&
    isNumber(met['tested']) &&
    alternatives.length > 0 &&
    alternatives.every(
      (each) =>
        isObject(each) &&
        isText(each['name']) &&
        ['tests', 'changes', 'cost'].every((key) => isNumber(each[key])),
    ) &&
    places.every(
      (each) =>
        isObject(each) &&
        isNumber(each['number']) &&
        (each['slot'] === null || isText(each['slot'])),
    ) &&
    (benches === null ||
      (isList(benches) &&
        benches.every(
          (each) =>
            isObject(each) &&
            isText(each['name']) &&
            isNumber(each['end']) &&
            startIn(each['start'], '') !== null,
        )));
  const asked = (name: unknown) => job.benches.find((each) => each.name === name)?.start ?? '';
  return good && (rest['plan'] === undefined || rest['plan'] === null || isNumber(rest['plan']))
    ? ({
        ...rest,
        start,
        benches:
          (benches as Outcome['benches'])?.map((each) => ({
            ...each,
            start: startIn(each.start, asked(each.name)),
            hours: isNumber(each.hours) ? each.hours : null,
          })) ?? null,
        places,
        alternatives,
        met,
        notes,
        unit,
        finish,
        budget,
        tests: read,
      } as Outcome)
    : null;
}

/** Links come from anywhere: what is not a state is null. */
export function unpacked(value: unknown): State | null {
  if (!isObject(value)) {
    return null;
  }
  const { id, job, outcome } = value;
  if (!isText(id) || !/^[\w-]{1,40}$/.test(id) || !isObject(job)) {
    return null;
  }
  const read = jobIn(job);
  const planned = read && isObject(outcome) ? outcomeIn(outcome, read) : null;
  return read && (outcome === null || planned) ? { id, job: read, outcome: planned } : null;
}

export interface Kept {
  id: string;
  title: string;
  tests: number;
  done: number;
  when: number;
}

function entry(id: string): { when: number; state: State } | null {
  try {
    const { when, state } = JSON.parse(localStorage.getItem(prefix + id) ?? 'null') as {
      when: number;
      state: unknown;
    };
    const read = unpacked(state);
    return read && { when, state: read };
  } catch {
    return null;
  }
}

function keptOf({ when, state: { id, job, outcome } }: { when: number; state: State }): Kept {
  const tests = outcome?.tests ?? [];
  return { id, title: job.title, when, tests: tests.length, done: tests.filter(isDone).length };
}

/** The jobs of this browser, the last one first. */
export function keptJobs(): Kept[] {
  return Object.keys(localStorage)
    .filter((key) => key.startsWith(prefix))
    .flatMap((key) => {
      const found = entry(key.slice(prefix.length));
      return found ? [keptOf(found)] : [];
    })
    .sort((one, other) => other.when - one.when);
}

export function forget(id: string): void {
  localStorage.removeItem(prefix + id);
}

/**
 * Keeps the state and returns the parameters of its link. `whole` says whether the link has all of
 * it. @throws if this browser has no room left.
 */
export async function keep(
  state: State,
): Promise<{ s: string | null; id: string; whole: boolean }> {
  const small = packed(state);
  localStorage.setItem(prefix + state.id, JSON.stringify({ when: Date.now(), state: small }));
  for (const { id } of keptJobs().slice(mostKept)) {
    forget(id);
  }
  const word = await pack(small);
  const whole = word.length <= longestWord;
  return { s: whole ? word : null, id: state.id, whole };
}

export interface Loaded {
  state: State;
  /** This browser has kept the same job in another state than the link. */
  other: Kept | null;
}

/** What a link holds, else what this browser has kept under its name. */
export async function load(params: URLSearchParams): Promise<Loaded | null> {
  const word = params.get('s');
  const linked = word ? unpacked(await unpack(word)) : null;
  const here = entry(linked?.id ?? params.get('id') ?? '');
  if (!linked) {
    return here && { state: here.state, other: null };
  }
  const same =
    here === null || JSON.stringify(packed(here.state)) === JSON.stringify(packed(linked));
  return { state: linked, other: same ? null : keptOf(here) };
}

export function newId(): string {
  return crypto.getRandomValues(new Uint32Array(2)).reduce((text, n) => text + n.toString(36), '');
}
