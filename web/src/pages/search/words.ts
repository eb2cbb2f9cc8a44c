// What a search is doing, in words.
import type { SearchJob } from '../../lib/api';
import { count, number } from '../../lib/words';

/** How long a search may take, in seconds. */
export const times: readonly (readonly [string, string])[] = [
  ['10', '10 seconds'],
  ['60', '1 minute'],
  ['600', '10 minutes'],
  ['3600', '1 hour'],
  ['28800', '8 hours'],
];

export function seconds(s: number): string {
  const whole = Math.round(s);
  return whole < 100
    ? `${whole} s`
    : whole < 6000
      ? `${Math.floor(whole / 60)} min ${whole % 60} s`
      : `${Math.floor(whole / 3600)} h ${Math.floor((whole % 3600) / 60)} min`;
}

export const stateWords: Record<SearchJob['state'], string> = {
  running: 'running',
  done: 'done',
  stopped: 'stopped',
  failed: 'failed',
};

export const wayWords: Record<SearchJob['way'], string> = {
  local: 'local search',
  exact: 'exact, with proof',
  'base-blocks': 'base blocks',
  locked: 'locked sets',
};

/** Whether the search has a design that was not known before it. */
export function isNew({ best, start_best: start }: SearchJob): boolean {
  return best !== null && (start === null || best < start);
}

/** Whether it is the first design of its cell. Other ways may set out from nothing anywhere. */
function isFirst(job: SearchJob): boolean {
  return job.way === 'local' && job.state !== 'running' && job.start_best === null && isNew(job);
}

/** "87 blocks, 3 fewer than were known" */
export function found(job: SearchJob): string {
  const { best, start_best: start, lower_bound: bound } = job;
  if (best === null) {
    return job.state === 'running' ? 'nothing yet' : 'nothing found';
  }
  const better =
    start !== null && best < start
      ? `, ${number(start - best)} fewer than were known`
      : isFirst(job)
        ? ', the first design'
        : job.state !== 'running' && !isNew(job) && best !== bound
          ? ', no better'
          : '';
  return count(best, 'block') + better + (best === bound ? ', the minimum' : '');
}

/** The result as a headline: "87 blocks, 3 fewer than were known" */
export function result(job: SearchJob): string {
  const { state, best, lower_bound: bound } = job;
  if (state === 'failed') {
    return 'The search failed';
  }
  if (state === 'running') {
    return best === null
      ? 'Searching: nothing yet'
      : isNew(job) || best === bound
        ? `Searching: ${found(job)} so far`
        : `Searching for fewer than ${count(best, 'block')}`;
  }
  return best === null
    ? 'No design was found'
    : isFirst(job)
      ? `The first design: ${count(best, 'block')}${best === bound ? ', the minimum' : ''}`
      : !isNew(job) && best !== bound
        ? `No better design was found: ${count(best, 'block')}, as before`
        : found(job);
}

export function rate(perSecond: number): string {
  return perSecond >= 1e6
    ? `${(perSecond / 1e6).toFixed(1)} M/s`
    : perSecond >= 1e3
      ? `${(perSecond / 1e3).toFixed(0)} k/s`
      : `${Math.round(perSecond)}/s`;
}

/** A size in kB: "340 kB", "12 MB" */
export function size(kilobytes: number): string {
  return kilobytes < 1000
    ? `${number(kilobytes)} kB`
    : kilobytes < 1e6
      ? `${(kilobytes / 1000).toFixed(kilobytes < 10_000 ? 1 : 0)} MB`
      : `${(kilobytes / 1e6).toFixed(1)} GB`;
}

/** What a search says at its end, in words for who has not read its output. */
export function plainly(message: string): string {
  const none =
    /^No base blocks found \(([^)]*)\): of (\d+) shapes? tried the SAT solver says none exist in (\d+)\.$/.exec(
      message,
    );
  if (!none) {
    return message;
  }
  const [, why, tried, refuted] = none;
  const all =
    tried === refuted
      ? `for ${tried === '1' ? 'it' : 'each'} a SAT solver proved that it gives no design`
      : refuted === '0'
        ? 'none was decided'
        : `for ${refuted} of them a SAT solver proved that it gives no design; the others are open`;
  const shapes = count(Number(tried), 'shape');
  const were = tried === '1' ? 'was' : 'were';
  return (
    'No base blocks were found. A shape is a number of base blocks and a cyclic group that moves ' +
    `them. ${
      why === 'exhausted'
        ? `All that fit, ${shapes}, ${were} tried`
        : `${shapes} ${were} tried before the search ended (${why})`
    }: ${all}.`
  );
}
