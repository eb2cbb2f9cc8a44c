// When the tests of several benches run: a lane for each bench, a bar for each test.
import { h, type Child } from '../../lib/dom';
import { about } from './job';
import { hoursOf, isDone, namesOf, testName, verdictOf, type Outcome } from './outcome';
import { dayWords } from './times';

const steps = [0.25, 0.5, 1, 2, 3, 4, 6, 8, 12, 24];

/** Hours in the unit of costs. */
const inUnit = (hours: number, unit: Outcome['unit']): number => hours / hoursOf[unit ?? 'hours'];

/**
 * How long the longest day of the benches that work is, in the unit of costs; a bench without hours
 * works day and night. null: no days.
 */
function dayOf({ benches, unit }: Outcome): number | null {
  const up = (benches ?? []).filter(({ down }) => !down);
  return up.every(({ hours }) => hours === null)
    ? null
    : inUnit(Math.max(...up.map(({ hours }) => hours ?? 24)), unit);
}

/** How long a bench could work until then: its nights are over sooner than those of others. */
function worked(at: number, hours: number | null, day: number | null): number {
  return hours === null || day === null
    ? at
    : Math.floor(at / day) * hours + Math.min(hours, at % day);
}

/** How long a bench waits between its tests; 0 where times are not known. */
export function idleOf(outcome: Outcome, name: string): number {
  const bench = outcome.benches?.find((each) => each.name === name);
  const timed = outcome.tests.filter((test) => test.bench === name && test.span);
  const [first, last] = [timed[0]?.span, timed.at(-1)?.span];
  if (!bench || !first || !last) {
    return 0;
  }
  const day = dayOf(outcome);
  const own = bench.hours === null ? null : inUnit(bench.hours, outcome.unit);
  const work = timed.reduce((sum, { cost }) => sum + cost, 0);
  const idle = worked(last[1], own, day) - worked(first[0], own, day) - work;
  return Math.max(0, Math.round(idle * 1e6) / 1e6);
}

/** The lines below the lanes: hours, or days where there are many. */
function ticks(
  end: number,
  day: number | null,
  nameOf: (day: number) => string,
): { at: number; text: string; day: boolean }[] {
  const wanted = end / 10;
  const many = day !== null && end > 4 * day;
  const step = steps.find((each) => each >= wanted) ?? Math.ceil(wanted / 24) * 24;
  const found: { at: number; text: string; day: boolean }[] = [];
  if (day === null) {
    for (let at = 0; at <= end; at += step) {
      found.push({ at, text: about(at), day: false });
    }
    return found;
  }
  const every = many ? Math.ceil(wanted / day) : 1;
  for (let today = 0; today * day < end; ++today) {
    if (today % every === 0) {
      found.push({ at: today * day, text: nameOf(today), day: true });
    }
    for (let at = step; !many && at < day && today * day + at <= end; at += step) {
      found.push({ at: today * day + at, text: about(at), day: false });
    }
  }
  return found;
}

/** The dates of days, by their number from 0, as far as tests that begin or end on them say them. */
function datesOf({ tests }: Outcome, day: number | null): Map<number, string> {
  const found = new Map<number, string>();
  for (const { when = '', ends = '', span } of day === null ? [] : tests) {
    const [first, last] = [dayWords(when), dayWords(ends)];
    if (first !== null && last !== null && span) {
      found.set(Math.floor(span[0] / day! + 1e-9), first);
      found.set(Math.ceil(span[1] / day! - 1e-9) - 1, last);
    }
  }
  return found;
}

export interface Strip {
  readonly element: HTMLElement;
  refresh(): void;
}

/**
 * `time` says a time of the plan as people do; `go` shows the row of a test. null: the times of no
 * test are known.
 */
export function timeStrip(
  outcome: Outcome,
  time: (planned: string) => string,
  go: (test: number) => void,
): Strip | null {
  const { benches, tests, unit } = outcome;
  const end = Math.max(0, ...tests.map(({ span }) => span?.[1] ?? 0));
  if (!benches || end === 0) {
    return null;
  }
  const names = namesOf(outcome);
  const day = dayOf(outcome);
  const part = (at: number) => `${((100 * at) / end).toFixed(3)}%`;
  const placed = <E extends HTMLElement>(element: E, from: number, until?: number): E => {
    element.style.left = part(from);
    element.style.width = until === undefined ? '' : part(until - from);
    return element;
  };
  const dates = datesOf(outcome, day);
  const bars = new Map<number, HTMLElement>();
  const lane = ({ name, down, hours }: NonNullable<Outcome['benches']>[number]): Child[] => {
    const own = hours === null ? null : inUnit(hours, unit);
    const nights: Child[] = [];
    if (own !== null && day !== null && own < day) {
      for (let today = 0; today * day + own < end; ++today) {
        const from = today * day + own;
        const until = Math.min(end, (today + 1) * day);
        nights.push(
          placed(h('span', { class: 'night', title: `${name} is not at work` }), from, until),
        );
      }
    }
    const ownBars = tests.flatMap((test, i): Child[] => {
      if (test.bench !== name || !test.span) {
        return [];
      }
      const [from, until] = test.span;
      const said =
        `${testName(test, names[i]!)}: ` +
        (test.when
          ? `begins ${time(test.when)}, ends ${test.ends ? time(test.ends) : about(until)}`
          : `${about(from)} to ${about(until)}`);
      const bar = h(
        'button',
        {
          type: 'button',
          class: 'bar',
          tabindex: -1, // The table below has the same tests.
          title: said,
          'aria-label': said,
          onclick: () => go(i),
        },
        h('span', { 'aria-hidden': 'true' }, names[i]!.slice(name.length + 1)),
      );
      bars.set(i, bar);
      return [placed(bar, from, until)];
    });
    return [
      h('span', { class: 'lane-name' }, name),
      h('div', { class: down ? 'lane down' : 'lane' }, nights, ownBars),
    ];
  };
  const what = day !== null || unit === 'hours' ? 'hours' : (unit ?? 'cost as time');
  const element = h(
    'section',
    { class: 'time-strip', 'aria-label': 'When the tests run' },
    h('div', { class: 'lanes' }, benches.flatMap(lane), [
      h('span', { class: 'lane-name hint' }, what),
      h(
        'div',
        { class: 'axis', 'aria-hidden': 'true' },
        ticks(end, day, (today) => dates.get(today) ?? `day ${today + 1}`)
          .filter(({ at }) => at < 0.97 * end) // A last one would stand outside.
          .map(({ at, text, day: begins }) =>
            placed(h('span', { class: begins ? 'tick day' : 'tick' }, text), at),
          ),
      ),
    ]),
  );
  const refresh = (): void => {
    for (const [i, bar] of bars) {
      const verdict = verdictOf(tests[i]!);
      bar.classList.toggle('done', isDone(tests[i]!));
      bar.classList.toggle('failed', verdict === 'fail');
    }
  };
  refresh();
  return { element, refresh };
}
