// The run sheet: what to take out and put in, test by test, what is then mounted, and its result.
import { h, scroll, type Child } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { exact, moneyOf } from './job';
import {
  before,
  isDone,
  namesOf,
  numbersOf,
  repeats,
  step,
  verdictOf,
  type Outcome,
  type Place,
  type Test,
} from './outcome';
import { fromWords, givesWords, outAlready } from './handover';
import { resultButtons } from './results';
import { skippedWords } from './skipped';
import { idleOf, timeStrip } from './strip';

const piece = 200;

export interface Sheet {
  readonly element: HTMLElement;
  /** After results have changed. */
  refresh(): void;
}

/** 75 minutes as 1:15; of a sheet without a unit the cost itself. */
export function clockOf(unit: Outcome['unit']): ((cost: number) => string) | null {
  if (unit === null) {
    return null;
  }
  const minutes = { seconds: 1 / 60, minutes: 1, hours: 60 }[unit];
  return (cost) => {
    const all = Math.round(cost * minutes);
    return `${Math.floor(all / 60)}:${String(all % 60).padStart(2, '0')}`;
  };
}

/** When a test ends, without its day if that is the day on which it begins. */
function endOf(when: string, ends: string): string {
  const day = /^.*, /.exec(when)?.[0] ?? '';
  return day !== '' && ends.startsWith(day) ? ends.slice(day.length) : ends;
}

/** A name breaks at its spaces only if it is long. */
function unbroken(name: string): Child {
  return name.length <= 24 && /[ -]/.test(name) ? h('span', { class: 'whole' }, name) : name;
}

/** `more` says what stands small behind a name. */
function named(names: readonly string[], more: (name: string) => string): Child[] {
  return names.flatMap((name, i) => [i > 0 ? ', ' : null, unbroken(name), behind(more(name))]);
}

const behind = (words: string): Child =>
  words === '' ? null : h('small', { class: 'behind' }, ` ${words}`);

/** What is mounted, slot by slot, in the order of the places; what was put in stands out. */
export function setUp(test: Test, places: readonly Place[], fresh: ReadonlySet<string>): Child[] {
  const shown = (name: string) =>
    fresh.has(name) ? h('strong', {}, unbroken(name)) : unbroken(name);
  const listed = (names: readonly string[]): Child[] =>
    names.flatMap((name, i) => [i > 0 ? ', ' : null, shown(name)]);
  if (test.values) {
    return Object.entries(test.values).map(([parameter, value], i) =>
      h(
        'span',
        { class: 'of-slot-group' },
        h('span', { class: 'slot-name' }, parameter),
        ' ',
        fresh.has(test.parts[i] ?? '') ? h('strong', {}, value) : value,
      ),
    );
  }
  if (!test.places) {
    return listed(test.parts);
  }
  const slots = [...new Set(places.map(({ slot }) => slot))];
  const inSlot = (slot: string | null) =>
    places.flatMap((place, i) =>
      place.slot === slot && test.places![i] ? [test.places![i]!] : [],
    );
  if (slots.every((slot) => slot === null)) {
    return listed(inSlot(null));
  }
  return slots.flatMap((slot) => {
    const names = inSlot(slot);
    return names.length > 0
      ? [
          h(
            'span',
            { class: 'of-slot-group' },
            h('span', { class: 'slot-name' }, slot ?? 'free'),
            ' ',
            ...listed(names),
          ),
        ]
      : [];
  });
}

/** More columns than that make a line unreadable. */
const mostSlots = 9;

/**
 * The slots that get a column each; null if the sheet has none, too many, or tests whose places are
 * not known.
 */
function slotColumns({ places, tests }: Outcome): (string | null)[] | null {
  const slots = [...new Set(places.map(({ slot }) => slot))];
  const whole = tests.every(
    ({ places: filled, values }) => filled !== null && values === undefined,
  );
  return whole && slots.length <= mostSlots && slots.some((slot) => slot !== null) ? slots : null;
}

/** What is in a slot; what was put in stands out, and beside it what it replaces. */
function inSlot(
  slot: string | null,
  tests: readonly Test[],
  i: number,
  places: readonly Place[],
  out: readonly string[],
  put: ReadonlySet<string>,
  from: (part: string) => string,
): Child[] {
  const earlier = before(tests, i)?.places ?? null;
  const left = new Set(out);
  const many = places.filter((place) => place.slot === slot).length > 1;
  return places.flatMap((place, at): Child[] => {
    const now = place.slot === slot ? (tests[i]!.places?.[at] ?? null) : null;
    const was = place.slot === slot ? (earlier?.[at] ?? null) : null;
    const gone = was !== null && left.has(was) ? was : null;
    // Where there are several parts, a part and what it replaces share a line if they are short.
    const kind =
      many && now !== null && now.length + (gone ?? '').length <= 26 ? 'place whole' : 'place';
    return now === null
      ? gone === null
        ? []
        : [h('span', { class: 'place leave' }, unbroken(gone), ' out'), ' ']
      : [
          h(
            'span',
            { class: kind },
            put.has(now) ? h('strong', { class: 'enter' }, unbroken(now)) : unbroken(now),
            put.has(now) && behind(from(now)),
            ...(put.has(now) && gone !== null
              ? [
                  ' ',
                  h(
                    'small',
                    { class: gone.length <= 24 ? 'replaced whole' : 'replaced' },
                    'for ',
                    gone,
                  ),
                ]
              : []),
          ),
          ' ',
        ];
  });
}

/**
 * `time` says a time of the plan as people do; `written` is called with the number of a test whose
 * result or notes have changed.
 */
export function runSheet(
  title: string,
  outcome: Outcome,
  time: (planned: string) => string,
  written: (test: number) => void,
  signal: AbortSignal,
): Sheet {
  const { tests, places, benches } = outcome;
  const names = namesOf(outcome);
  const numbers = numbersOf(outcome);
  const money = moneyOf(tests.map(({ cost }) => cost));
  const clock = clockOf(outcome.unit);
  const unit = outcome.unit ? ` ${outcome.unit}` : '';
  const progress = h('progress', { max: tests.length, value: 0, 'aria-label': 'Tests done' });
  const said = h('p', { class: 'sheet-progress', role: 'status' });
  const skipped = h('p', { class: 'hint no-print', role: 'status' });
  const refreshers: (() => void)[] = [];
  const sums = new Map<string | null, number>();
  const sumAt = tests.map(({ bench, cost }) => {
    const sum = exact((sums.get(bench) ?? 0) + cost);
    sums.set(bench, sum);
    return sum;
  });
  const whole = exact(tests.reduce((sum, { cost }) => sum + cost, 0));
  const hasTimes = tests.some(({ when }) => when !== undefined);
  const spent = outcome.unit ?? (hasTimes ? 'hours' : 'cost');
  const parameters = Object.keys(tests.find(({ values }) => values !== undefined)?.values ?? {});
  const ofModel = parameters.length > 0;
  const slots = ofModel ? null : slotColumns(outcome);
  const rows: HTMLTableRowElement[] = [];

  function refresh(): void {
    const done = tests.filter(isDone);
    const failed = tests.filter((test) => verdictOf(test) === 'fail').length;
    const spent = exact(done.reduce((total, { cost }) => total + cost, 0));
    progress.value = done.length;
    said.textContent =
      `${number(done.length)} of ${count(tests.length, 'test')} ` +
      `done${failed > 0 ? `, ${number(failed)} failed` : ''}; ${money(spent)} of ` +
      `${money(whole)}${unit} spent.`;
    skipped.textContent = skippedWords(outcome);
    skipped.hidden = skipped.textContent === '';
    const next = new Set<number>();
    for (const bench of new Set(tests.map((test) => test.bench))) {
      const i = tests.findIndex((test) => test.bench === bench && verdictOf(test) === '');
      if (i >= 0) {
        next.add(i);
      }
    }
    rows.forEach((row, i) => {
      const verdict = verdictOf(tests[i]!);
      row.classList.toggle('done', verdict !== '');
      row.classList.toggle('failed', verdict === 'fail');
      row.classList.toggle('next', next.has(i));
    });
    refreshers.forEach((each) => each());
  }

  function makeRow(i: number): HTMLTableRowElement {
    const test = tests[i]!;
    const { out, in: put } = step(outcome, i);
    const buttons = resultButtons(test, names[i]!, () => written(i));
    const notes = h('input', {
      type: 'text',
      class: 'notes',
      value: test.notes,
      'aria-label': `Notes on test ${names[i]}`,
      onchange: () => ((test.notes = notes.value), written(i)),
    });
    refreshers.push(() => {
      buttons.refresh();
      if (document.activeElement !== notes) {
        notes.value = test.notes;
      }
    });
    const again = h('small', { class: 'repeats' });
    refreshers.push(() => {
      again.textContent = repeats(outcome, i);
      again.hidden = again.textContent === '';
    });
    const list = (parts: string[], none: string, more: (part: string) => string) =>
      parts.length > 0 ? named(parts, more) : none;
    const isOut = outAlready(outcome, i);
    const from = (part: string) => fromWords(test, part);
    const handed = givesWords(test, time).map((line) => h('small', { class: 'hand-over' }, line));
    const same = out.length === 0 && put.length === 0;
    const begins = test.when ? time(test.when) : '';
    const ends = test.ends ? time(test.ends) : '';
    rows[i] = h(
      'tr',
      {},
      h('td', { class: 'of-result' }, buttons.element),
      h('td', { class: 'number of-number' }, number(numbers[i]!)),
      hasTimes
        ? h(
            'td',
            { class: 'of-when', 'data-label': 'begins' },
            begins,
            ends === '' ? null : h('span', { class: 'of-end' }, ` · ends ${endOf(begins, ends)}`),
          )
        : null,
      ...(test.values || slots
        ? []
        : [
            h(
              'td',
              { class: 'leave', 'data-label': 'take out' },
              list(out, '–', (part) => (isOut.has(part) ? 'is out' : '')),
            ),
            h(
              'td',
              { class: 'enter', 'data-label': 'put in' },
              list(put, same ? 'change nothing' : '–', from),
            ),
          ]),
      ...(slots ?? []).map((slot) =>
        h(
          'td',
          {
            class:
              places.filter((place) => place.slot === slot).length > 2
                ? 'in-slot several'
                : 'in-slot',
            'data-label': slot ?? 'other',
          },
          inSlot(slot, tests, i, places, out, new Set(put), from),
        ),
      ),
      ...(slots
        ? []
        : test.values
          ? Object.entries(test.values).map(([parameter, value]) =>
              h(
                'td',
                { class: 'of-value', 'data-label': parameter },
                value === before(tests, i)?.values?.[parameter] ? value : h('strong', {}, value),
              ),
            )
          : [
              h(
                'td',
                { class: 'set-up', 'data-label': 'then in' },
                setUp(test, places, new Set(put)),
                handed,
              ),
            ]),
      h('td', { class: 'number of-cost', 'data-label': spent }, money(test.cost)),
      h(
        'td',
        {
          class: hasTimes ? 'of-sum' : 'number of-sum',
          'data-label': hasTimes ? 'ends' : 'so far',
        },
        ends !== '' || hasTimes ? ends : clock ? clock(sumAt[i]!) : money(sumAt[i]!),
      ),
      h('td', { class: 'of-notes', 'data-label': 'notes' }, slots ? handed : null, again, notes),
    );
    return rows[i]!;
  }

  function tableOf(indices: readonly number[], label: string): HTMLElement {
    const body = h('tbody');
    let drawn = 0;
    function draw(): void {
      if (signal.aborted) {
        return;
      }
      const part = document.createDocumentFragment();
      for (const last = Math.min(indices.length, drawn + piece); drawn < last; ++drawn) {
        const row = makeRow(indices[drawn]!);
        part.append(row);
      }
      body.append(part);
      drawn < indices.length ? requestAnimationFrame(draw) : refresh();
    }
    draw();
    return scroll(
      label,
      h(
        'table',
        {
          class:
            (ofModel ? 'run-sheet of-model' : slots ? 'run-sheet of-slots' : 'run-sheet') +
            (hasTimes ? ' timed' : ''),
          onkeydown: (event) => {
            const { key, target } = event as KeyboardEvent;
            const row = (target as Element).closest('tbody tr');
            const other =
              key === 'ArrowDown'
                ? row?.nextElementSibling
                : key === 'ArrowUp'
                  ? row?.previousElementSibling
                  : null;
            if (row && other) {
              event.preventDefault();
              const place = [...row.querySelectorAll<HTMLElement>('button, input')].indexOf(
                target as HTMLElement,
              );
              [...other.querySelectorAll<HTMLElement>('button, input')][
                Math.max(0, place)
              ]?.focus();
            }
          },
        },
        h('caption', { class: 'unseen' }, label),
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', {}, 'result'),
            h('th', { class: 'number' }, 'test'),
            hasTimes ? h('th', {}, 'begins') : null,
            ...(ofModel
              ? parameters.map((name) => h('th', {}, name))
              : slots
                ? slots.map((slot) => h('th', {}, slot ?? 'other'))
                : [h('th', {}, 'take out'), h('th', {}, 'put in'), h('th', {}, 'what is in')]),
            h('th', { class: 'number' }, spent),
            hasTimes
              ? h('th', {}, 'ends')
              : h('th', { class: 'number' }, clock ? 'clock' : 'so far'),
            h('th', { class: 'of-notes' }, 'notes'),
          ),
        ),
        body,
      ),
    );
  }

  const lists = benches
    ? benches.map(({ name, down, end }) => {
        const indices = tests.flatMap(({ bench }, i) => (bench === name ? [i] : []));
        const sum = sums.get(name) ?? 0;
        const last = tests[indices.at(-1) ?? -1]?.ends;
        const done = last
          ? `, done on ${time(last)}`
          : end > sum
            ? unit
              ? `, done ${money(end)}${unit} after the start`
              : `, done at ${money(end)}`
            : '';
        const idle = idleOf(outcome, name);
        const waits =
          idle > 0 ? `, ${money(idle)}${idle === 1 ? unit.slice(0, -1) : unit} idle` : '';
        const work = unit ? `${money(sum)}${unit} of work` : `cost ${money(sum)}`;
        return h(
          'section',
          { class: 'bench-sheet' },
          h('p', { class: 'only-print bench-title' }, `${title}: ${name}`),
          h('p', { class: 'only-print' }, 'Run by ', h('span', {}), ' on ', h('span', {})),
          h(
            'h3',
            {},
            h('span', { class: 'no-print' }, name),
            h(
              'span',
              { class: 'hint' },
              down ? ' out of order' : ` ${count(indices.length, 'test')}, ${work}${waits}${done}`,
            ),
          ),
          indices.length > 0
            ? tableOf(indices, `Run sheet of ${name}`)
            : h('p', { class: 'hint' }, 'No test is planned for it.'),
        );
      })
    : [
        tableOf(
          tests.map((_, i) => i),
          'Run sheet',
        ),
      ];
  const strip = timeStrip(outcome, time, (i) => {
    rows[i]?.scrollIntoView({ block: 'center' });
    rows[i]?.querySelector('button')?.focus({ preventScroll: true });
  });
  refreshers.push(() => strip?.refresh());
  refresh();
  return {
    element: h(
      'div',
      { class: 'sheets' },
      h('div', { class: 'row no-print' }, progress, said),
      skipped,
      strip?.element,
      strip && outcome.doneBefore > 0
        ? h('p', { class: 'hint' }, 'Time starts again with the first test that is left.')
        : null,
      benches
        ? null
        : h('p', { class: 'only-print' }, 'Run by ', h('span', {}), ' on ', h('span', {})),
      lists,
    ),
    refresh,
  };
}
