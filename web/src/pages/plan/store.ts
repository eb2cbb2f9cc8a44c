// Where a job is kept: all of it in the link as long as it is short, and in this browser in any case.
import { longestWord, pack, unpack } from '../../lib/share';
import type { Alternative, Job, Outcome, PairMode, State, Test } from './job';

const prefix = 'changeover-plan-';
const mostKept = 30;

type Packed = [
  id: string,
  job: [
    title: string,
    parts: [name: string, cost: number | null, gone: 0 | 1][],
    atOnce: number,
    testCost: number,
    changeCost: number,
    pairMode: PairMode,
    pairs: string,
    seconds: number,
  ],
  outcome:
    | null
    | [
        tests: [parts: string[], cost: number, done: 0 | 1][],
        cost: number,
        bound: number,
        reason: string,
        alternatives: [string, number, number, number][],
        testCost: number,
        changeCost: number,
        doneBefore: number,
      ],
];

function packed({ id, job, outcome }: State): Packed {
  return [
    id,
    [
      job.title,
      job.parts.map(({ name, cost, gone }) => [name, cost, gone ? 1 : 0]),
      job.atOnce,
      job.testCost,
      job.changeCost,
      job.pairMode,
      job.pairs,
      job.seconds,
    ],
    outcome && [
      outcome.tests.map(({ parts, cost, done }) => [parts, cost, done ? 1 : 0]),
      outcome.cost,
      outcome.bound,
      outcome.reason,
      outcome.alternatives.map(({ name, tests, changes, cost }) => [name, tests, changes, cost]),
      outcome.testCost,
      outcome.changeCost,
      outcome.doneBefore,
    ],
  ];
}

const isText = (x: unknown): x is string => typeof x === 'string';
const isNumber = (x: unknown): x is number => typeof x === 'number' && Number.isFinite(x);
const isNumberOrNull = (x: unknown): x is number | null => x === null || isNumber(x);
const isList = (x: unknown): x is unknown[] => Array.isArray(x);

/** Links come from anywhere: what is not a state is null. */
export function unpacked(value: unknown): State | null {
  if (!isList(value)) {
    return null;
  }
  const [id, job, outcome] = value;
  if (!isText(id) || !/^[\w-]{1,40}$/.test(id) || !isList(job)) {
    return null;
  }
  const [title, parts, atOnce, testCost, changeCost, pairMode, pairs, seconds] = job;
  if (
    !isText(title) ||
    !isList(parts) ||
    ![atOnce, testCost, changeCost, seconds].every(isNumber) ||
    !['all', 'only', 'skip'].includes(pairMode as string) ||
    !isText(pairs)
  ) {
    return null;
  }
  if (!parts.every((part) => isList(part) && isText(part[0]) && isNumberOrNull(part[1]))) {
    return null;
  }
  const read: Job = {
    title,
    parts: (parts as [string, number | null, number][]).map(([name, cost, gone]) => ({ name, cost, ...(gone ? { gone: true } : {}) })),
    atOnce: atOnce as number,
    testCost: testCost as number,
    changeCost: changeCost as number,
    pairMode: pairMode as PairMode,
    pairs,
    seconds: seconds as number,
  };
  if (outcome === null) {
    return { id, job: read, outcome: null };
  }
  if (!isList(outcome)) {
    return null;
  }
  const [tests, cost, bound, reason, alternatives, plannedTest, plannedChange, doneBefore] = outcome;
  const good =
    isList(tests) &&
    tests.every((test) => isList(test) && isList(test[0]) && test[0].every(isText) && isNumber(test[1])) &&
    [cost, bound, plannedTest, plannedChange, doneBefore].every(isNumber) &&
    isText(reason) &&
    isList(alternatives) &&
    alternatives.length > 0 &&
    alternatives.every((each) => isList(each) && isText(each[0]) && each.slice(1, 4).length === 3 && each.slice(1, 4).every(isNumber));
  if (!good) {
    return null;
  }
  const result: Outcome = {
    tests: (tests as [string[], number, number][]).map(([names, each, done]): Test => ({ parts: names, cost: each, done: Boolean(done) })),
    cost: cost as number,
    bound: bound as number,
    reason,
    alternatives: (alternatives as [string, number, number, number][]).map(([name, count, changes, each]): Alternative => ({
      name,
      tests: count,
      changes,
      cost: each,
    })),
    testCost: plannedTest as number,
    changeCost: plannedChange as number,
    doneBefore: doneBefore as number,
  };
  return { id, job: read, outcome: result };
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
    const { when, state } = JSON.parse(localStorage.getItem(prefix + id) ?? 'null') as { when: number; state: unknown };
    const read = unpacked(state);
    return read && { when, state: read };
  } catch {
    return null;
  }
}

function keptOf({ when, state: { id, job, outcome } }: { when: number; state: State }): Kept {
  const tests = outcome?.tests ?? [];
  return { id, title: job.title, when, tests: tests.length, done: tests.filter(({ done }) => done).length };
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

/** Keeps the state and returns the parameters of its link. `whole` says whether the link has all of it. @throws if this browser has no room left. */
export async function keep(state: State): Promise<{ s: string | null; id: string; whole: boolean }> {
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
  const same = here === null || JSON.stringify(packed(here.state)) === JSON.stringify(packed(linked));
  return { state: linked, other: same ? null : keptOf(here) };
}

export function newId(): string {
  return crypto.getRandomValues(new Uint32Array(2)).reduce((text, n) => text + n.toString(36), '');
}
