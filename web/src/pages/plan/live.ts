// A plan while it is searched for: the best so far against what no plan can undercut.
import { h } from '../../lib/dom';
import type { PlanJob } from '../../lib/api';
import { plot } from '../../parts/plot';
import { count } from '../../lib/words';
import { about, type Job } from './job';
import { calendarOf } from './times';

export interface Live {
  readonly element: HTMLElement;
  /** The best cost and its bound, which stay in sight. */
  readonly line: HTMLElement;
  readonly rest: HTMLElement;
  hear(job: PlanJob): void;
}

/** What a plan is measured by while it is searched: words for it, and the axis. */
interface Measure {
  /** The best one in large letters. */
  head(best: number): string;
  said(best: number, tests: string): string;
  bound(least: number): string;
  axis: string;
}

/** `begun`: some tests are done, and this is of the rest. */
export function measureOf(job: Job, begun: boolean): Measure {
  const left = (tests: string) => (begun ? `${tests} left` : tests);
  const several = job.benches.some(({ name }) => name !== '');
  const hours = job.hours.trim() !== '' || job.benches.some((bench) => bench.hours.trim() !== '');
  const unit = job.unit === '' && several && hours ? 'hours' : job.unit;
  const calendar = several && job.objective !== 'cost' ? calendarOf(job) : null;
  if (calendar) {
    return {
      head: calendar,
      said: (best, tests) =>
        `is the end of the best so far: ${about(best)} ${unit} to the last test, ${left(tests)}`,
      bound: (least) => `no plan is done before ${calendar(least)}`,
      axis: `${unit} to the end`,
    };
  }
  if (several && job.objective !== 'cost') {
    const what = unit === '' ? 'cost' : unit;
    return {
      head: about,
      said: (_, tests) => `${what} to the last test are the best so far, with ${left(tests)}`,
      bound: (least) => `no plan takes less than ${about(least)}`,
      axis: `${what} to the end`,
    };
  }
  return unit === ''
    ? {
        head: about,
        said: (_, tests) => `is the best cost so far, with ${left(tests)}`,
        bound: (least) => `no plan costs less than ${about(least)}`,
        axis: 'cost',
      }
    : {
        head: about,
        said: (_, tests) => `${unit} are the best so far, with ${left(tests)}`,
        bound: (least) => `no plan takes less than ${about(least)}`,
        axis: unit,
      };
}

/** `best` asks for the best so far, `give_up` for nothing. */
export function livePanel(
  measure: Measure,
  best: () => void,
  giveUp: () => void,
  signal: AbortSignal,
): Live {
  const cost = h('strong', { class: 'live-best' }, '…');
  const said = h('span', {}, 'Looking for a first plan');
  const bar = h('progress', { max: 1, 'aria-label': 'How much of the time has gone' });
  const phase = h('p', { class: 'hint', role: 'status' });
  const stop = h(
    'button',
    { type: 'button', disabled: true, onclick: () => ((stop.disabled = true), best()) },
    'Stop and keep the best',
  );
  const chart = plot({
    label: 'The best plan so far and the lower bound, by time',
    x: 'seconds',
    y: measure.axis,
    height: 150,
    signal,
    yText: about,
  });
  const drawn = h('div', { hidden: true }, chart.element);
  const points: { at: number; best: number | null; bound: number }[] = [];
  const line = h('div', { class: 'live-line note', tabindex: -1 }, cost, ' ', said);
  const rest = h(
    'div',
    { class: 'live-rest note' },
    bar,
    phase,
    h('div', { class: 'live-chart' }, drawn),
    h(
      'div',
      { class: 'row' },
      stop,
      h('button', { type: 'button', class: 'plain', onclick: giveUp }, 'Cancel'),
    ),
  );
  const element = h('section', { class: 'live no-print', 'aria-label': 'Search' }, line, rest);
  return {
    element,
    line,
    rest,
    hear(job) {
      bar.max = job.limit;
      bar.value = Math.min(job.limit, job.seconds);
      phase.textContent =
        `${job.phase}; ${count(Math.floor(job.seconds), 'second')} of ` + `${job.limit} at most`;
      if (job.best === null || job.bound === null) {
        return;
      }
      stop.disabled = false;
      cost.textContent = measure.head(job.best);
      const above = job.bound > 0 ? (100 * (job.best - job.bound)) / job.bound : null;
      const gap =
        above === null
          ? ''
          : above <= 0
            ? ': this is the least'
            : ` (${above.toFixed(1)}\u00a0% above)`;
      said.textContent =
        `${measure.said(job.best, count(job.tests ?? 0, 'test'))}; ` +
        `${measure.bound(job.bound)}${gap}.`;
      if (points.length === 0) {
        points.push({ at: 0, best: null, bound: job.bound }); // The axis begins there.
      }
      points.push({ at: job.seconds, best: job.best, bound: job.bound });
      if (points.length > 1) {
        drawn.hidden = false;
        chart.set(
          points.map(({ at }) => at),
          [
            {
              label: 'best so far',
              colour: 1,
              width: 3,
              steps: true,
              values: points.map((point) => point.best),
            },
            {
              label: 'lower bound',
              colour: 2,
              dash: [6, 4],
              values: points.map((point) => point.bound),
            },
          ],
        );
      }
    },
  };
}
