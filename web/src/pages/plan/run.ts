// A run that the server keeps: results of two windows meet, and survive a closed browser.
import { get, post, ApiError, type Run, type RunHead } from '../../lib/api';
import { listen } from '../../lib/events';
import { keysOf, type Outcome, type State } from './outcome';
import { packed, unpacked } from './store';

const nameKey = 'changeover-name';

export function ownName(): string {
  return localStorage.getItem(nameKey) ?? '';
}

export function keepOwnName(name: string): void {
  localStorage.setItem(nameKey, name.trim().slice(0, 60));
}

export interface Kept {
  id: string;
  revision: number;
  sheet: number;
}

/** The state without results: these are kept one by one. */
function sheetOf(state: State): Record<string, unknown> {
  const outcome: Outcome | null = state.outcome && {
    ...state.outcome,
    tests: state.outcome.tests.map((test) => ({ ...test, result: '', notes: '', by: '', at: '' })),
  };
  return packed({ ...state, outcome }) as unknown as Record<string, unknown>;
}

/**
 * Keeps a sheet with its results: a new run, or in the place of the sheet that `run` has. @throws
 * ApiError 409 if another came meanwhile.
 */
export async function keepRun(state: State, run: Kept | null, signal: AbortSignal): Promise<Kept> {
  const { tests } = state.outcome!;
  const names = keysOf(state.outcome!);
  const results = tests.flatMap(({ result, notes, by, at }, i) =>
    result === '' && notes === '' ? [] : [{ test: names[i]!, result, notes, by, at }],
  );
  const kept = await post(
    'run',
    {},
    {
      ...(run ? { id: run.id, sheet_revision: run.sheet } : {}),
      title: state.job.title,
      tests: tests.length,
      sheet: sheetOf(state),
      results,
    },
    signal,
  );
  return { id: kept.id, revision: kept.revision, sheet: kept.sheet_revision };
}

/** Writes down the result of one test. @throws ApiError as keepRun() */
export async function keepResult(
  state: State,
  i: number,
  run: Kept,
  signal: AbortSignal,
): Promise<Kept> {
  const { result, notes } = state.outcome!.tests[i]!;
  const test = keysOf(state.outcome!)[i]!;
  const kept = await post(
    'run/result',
    { id: run.id },
    { test, result, notes, by: ownName(), sheet_revision: run.sheet },
    signal,
  );
  return { id: kept.id, revision: kept.revision, sheet: kept.sheet_revision };
}

export async function forgetRun(id: string, signal: AbortSignal): Promise<void> {
  await post('run/remove', { id }, undefined, signal);
}

/** Puts the results of a run onto its sheet. */
export function withResults(outcome: Outcome, run: Run): void {
  const names = keysOf(outcome);
  const results = new Map(run.results.map((each) => [each.test, each]));
  outcome.tests.forEach((test, i) => {
    const { result = '', notes = '', by = '', at = '' } = results.get(names[i]!) ?? {};
    Object.assign(test, { result, notes, by, at });
  });
}

/** @throws ApiError; Error for a sheet that this page cannot read. */
export async function openRun(
  id: string,
  signal: AbortSignal,
): Promise<{ state: State; run: Kept }> {
  const found = await get('run?id', { id }, signal);
  const state = unpacked(found.sheet);
  if (!state) {
    throw new Error('The sheet of this run cannot be read by this version of the page.');
  }
  if (state.outcome) {
    withResults(state.outcome, found);
  }
  return { state, run: { id, revision: found.revision, sheet: found.sheet_revision } };
}

export async function keptRuns(signal: AbortSignal): Promise<RunHead[]> {
  try {
    return await get('run', {}, signal);
  } catch (fault) {
    if (fault instanceof ApiError) {
      return []; // An older server, or none: the page works without.
    }
    throw fault;
  }
}

/** Hears of every change to a run that another window made. */
export function watchRun(
  id: string,
  known: () => Kept,
  changed: (run: Run) => void,
  removed: () => void,
  signal: AbortSignal,
): void {
  const look = async () => {
    const run = await get('run?id', { id }, signal).catch(() => null);
    if (run && !signal.aborted && run.revision > known().revision) {
      changed(run);
    }
  };
  listen(
    {
      run: (event) =>
        event.id === id &&
        (event.removed ? removed() : event.revision > known().revision && void look()),
      state: (state) => state === 'open' && void look(),
    },
    signal,
  );
}
