// What if changes or tests cost more or less: the library searches at every price where another
// plan takes the lead.
import type { WhatIf } from '../../lib/api';
import { fill, h, scroll } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { plot, type Line } from '../../parts/plot';
import { about, type Job } from './job';
import type { Outcome } from './outcome';

/** Of a plan when all changes cost `factor` times what they do. */
export function costAt(
  plan: { tests: number; cost: number },
  testCost: number,
  factor: number,
): number {
  return plan.tests * testCost + factor * (plan.cost - plan.tests * testCost);
}

const sizeOf = (plan: { tests: number; changes: number }) =>
  `${count(plan.tests, 'test')}, ${count(plan.changes, 'change')}`;

/** Plans are told apart by their sizes, and where these are the same by what they cost, too. */
export function namesOf(
  plans: readonly { tests: number; changes: number; cost: number }[],
): string[] {
  const sizes = plans.map(sizeOf);
  return plans.map(({ cost }, i) =>
    sizes.filter((each) => each === sizes[i]).length > 1
      ? `${sizes[i]}, cost ${about(cost)}`
      : sizes[i]!,
  );
}

/** A slider from a sixteenth to sixteen times, with a field for the number itself. */
function price(
  label: string,
  base: number,
  changed: () => void,
): { element: HTMLElement; value(): number; reset(): void } {
  const middle = base > 0 ? base : 1;
  const id = `price-${label.replaceAll(' ', '-')}`;
  const round = (value: number) => Number(value.toPrecision(3));
  const slider = h('input', {
    type: 'range',
    min: -40,
    max: 40,
    step: 1,
    value: 0,
    'aria-label': `${label}, as a slider`,
    oninput: () => (
      (box.value = String(round(middle * 2 ** (Number(slider.value) / 10)))),
      changed()
    ),
  });
  const box = h('input', {
    type: 'number',
    id,
    min: 0,
    step: 'any',
    value: base,
    oninput: () => {
      const value = Number(box.value);
      slider.value = String(value > 0 ? Math.round(10 * Math.log2(value / middle)) : -40);
      changed();
    },
  });
  return {
    element: h(
      'div',
      { class: 'field price' },
      h('label', { for: id }, label),
      h('div', { class: 'price-controls' }, box, slider),
    ),
    value: () => Math.max(0, Number(box.value) || 0),
    reset() {
      box.value = String(base);
      slider.value = '0';
    },
  };
}

/** Why the library compares no plans of this job; '' if it does. */
export function whyNoWhatIf(job: Job, outcome: Outcome): string {
  return outcome.benches
    ? 'The comparison of costs covers one bench only.'
    : outcome.met.what === 'triples'
      ? 'The comparison of costs covers pairs only, and in this job every three parts must meet.'
      : job.changeCosts !== ''
        ? 'The comparison of costs covers one cost per part only, and in this job a change ' +
          'costs by what is replaced.'
        : '';
}

/** `ask` has the library look; `planAnew` plans at other prices, `times` those of changes now. */
export function whatIf(
  job: Job,
  outcome: Outcome,
  ask: () => Promise<WhatIf>,
  planAnew: (testCost: number, changeCost: number, times: number) => void,
  signal: AbortSignal,
): HTMLElement {
  const { testCost, changeCost } = outcome;
  // Where parts have costs of their own, all costs grow by the same factor.
  const byPart = job.parts.some((part) => part.cost !== null);
  const base = byPart ? 1 : changeCost;
  const narrowed = [
    job.budget.trim() === '' ? '' : 'the budget',
    job.weights.trim() === '' ? '' : 'priorities',
  ]
    .filter(Boolean)
    .join(' and ');
  const place = h('div', {});
  const said = h('p', { role: 'status' });
  const test = price('A test costs', testCost, settle);
  const change = price(byPart ? 'All change costs, times' : 'A change costs', base, settle);
  const times = () => (base > 0 ? change.value() / base : 1);
  const anew = h(
    'button',
    {
      type: 'button',
      class: 'plain',
      onclick: () =>
        planAnew(test.value(), byPart ? changeCost * times() : change.value(), times()),
    },
    'Replan at these costs',
  );
  const look = h(
    'button',
    { type: 'button', class: 'plain', onclick: () => void search() },
    'Compare plans by cost',
  );
  let found: WhatIf | null = null;
  let redraw = (): void => undefined;

  /** How much more a change costs beside a test than it did. */
  const factor = () =>
    testCost > 0 && base > 0 && test.value() > 0 ? times() / (test.value() / testCost) : null;
  const isOwn = () => test.value() === testCost && change.value() === base;
  /** The same as the library counts: the ratio of costs, or that factor. */
  const unitOf = () => (found && /factor/.test(found.by) ? 1 : changeCost / testCost);
  const rangeAt = (at: number) =>
    found?.ranges.find(
      ({ from, to }) => (from === null || at >= from) && (to === null || at < to),
    ) ?? null;

  function settle(): void {
    const same = isOwn();
    anew.disabled = same;
    const here = factor();
    const mark = same ? 'These are your costs. ' : '';
    if (!found || here === null) {
      said.textContent =
        same || look.disabled ? mark : 'Replan to see what is cheapest at these costs.';
      return;
    }
    const at = here * unitOf();
    const best = rangeAt(at);
    const other = found.ranges.find(({ to }) => to === at); // costs as much just here
    const mine = rangeAt(unitOf());
    const withSize = ({ plan }: NonNullable<typeof best>) =>
      `${count(plan.tests, 'test')} and ${count(plan.changes, 'change')}`;
    said.textContent = !best
      ? ''
      : other && other !== best
        ? `${mark}Two plans are cheapest here: one with ${withSize(other)}, and one with ` +
          `${withSize(best)}.`
        : best === mine
          ? `${mark}The plan with ${withSize(best)} is cheapest ` +
            `${found.ranges.length === 1 ? 'whatever changes cost' : 'here'}.`
          : `The plan with ${withSize(best)} would be cheaper. Replan to get it, or a better one.`;
    redraw();
  }

  async function search(): Promise<void> {
    look.disabled = true;
    settle();
    fill(
      place,
      h(
        'p',
        { class: 'hint', role: 'status' },
        'Searching at each price where another plan takes the lead …',
      ),
    );
    try {
      found = await ask();
      if (!signal.aborted) {
        show(found);
        settle();
      }
    } catch (fault) {
      if (!signal.aborted) {
        look.disabled = false;
        settle();
        fill(place, h('p', { class: 'problem', role: 'alert' }, (fault as Error).message));
      }
    }
  }

  function show(answer: WhatIf): void {
    const notes =
      answer.notes.length > 0 &&
      h(
        'ul',
        { class: 'hint' },
        answer.notes.map((note) => h('li', {}, note)),
      );
    if (answer.ranges.length === 1) {
      fill(place, notes); // It is said above that the same plan is cheapest everywhere.
      return;
    }
    const unit = unitOf();
    const plans = answer.ranges.map(({ plan }) => plan);
    const last = Math.max(2 * unit, ...answer.ranges.map(({ from }) => 1.4 * (from ?? 0)));
    const names = namesOf(plans);
    // Where another plan takes the lead the lines have their corners.
    const xs = [
      ...new Set([
        ...Array.from({ length: 61 }, (_, i) => (last * i) / 60),
        ...answer.ranges.flatMap(({ from }) => (from === null || from > last ? [] : [from])),
      ]),
    ].sort((one, other) => one - other);
    const costs = plans.map((plan) => xs.map((x) => costAt(plan, testCost, x / unit)));
    const least = xs.map((_, i) => Math.min(...costs.map((each) => each[i]!)));
    const chart = plot({
      label:
        'How much more each plan costs than the cheapest one, by what a change costs; where ' +
        'which is cheapest is in the table',
      x: /factor/.test(answer.by) ? 'all change costs × …' : 'cost of a change',
      y: 'more than the cheapest',
      signal,
      xText: (x) => about(/factor/.test(answer.by) ? x : x * testCost),
      yText: about,
      mark: () => (factor() ?? 1) * unit,
      markText: () => (isOwn() ? 'your costs' : 'these costs'),
      fromZero: true,
    });
    const lines = plans.slice(0, 6).map((_, i): Line => ({
      label: names[i]!,
      colour: i + 1,
      width: 2,
      ...(i === 0 ? {} : { dash: [8, 2 + 2 * i] }),
      values: costs[i]!.map((cost, at) => cost - least[at]!),
    }));
    const body = h('tbody');
    const price = (ratio: number) => about(/factor/.test(answer.by) ? ratio : ratio * testCost);
    const span = ({ from, to }: WhatIf['ranges'][number]) =>
      to === null ? `${price(from ?? 0)} and more` : `${price(from ?? 0)} – ${price(to)}`;
    redraw = () => {
      const now = rangeAt((factor() ?? 1) * unit);
      fill(
        body,
        answer.ranges.map((range, i) =>
          h(
            'tr',
            { class: range === now ? 'own' : null },
            h('td', { class: 'number' }, span(range)),
            h(
              'td',
              {},
              h('span', { class: `swatch line-${i + 1}`, 'aria-hidden': 'true' }),
              names[i]!,
              h('span', { class: 'hint made-by' }, range.plan.name),
            ),
          ),
        ),
      );
      chart.redraw();
    };
    fill(
      place,
      chart.element,
      scroll(
        'Which plan is cheapest when',
        h(
          'table',
          {},
          h(
            'thead',
            {},
            h(
              'tr',
              {},
              h(
                'th',
                { class: 'number' },
                /factor/.test(answer.by) ? 'change costs\u00a0×' : 'cost of a change',
              ),
              h('th', {}, 'cheapest plan'),
            ),
          ),
          body,
        ),
      ),
      notes,
    );
    chart.set(xs, lines);
  }

  settle();
  return h(
    'section',
    { class: 'what-if no-print', 'aria-label': 'What if' },
    h('h2', {}, 'What if'),
    h(
      'p',
      {},
      'Fewer tests need more changes. Which plan is cheapest depends on the cost of a test and ' +
        'the cost of a change.',
    ),
    narrowed &&
      h('p', { class: 'hint' }, `The comparison is of the whole job, without ${narrowed}.`),
    h('div', { class: 'row' }, test.element, change.element),
    h(
      'div',
      { class: 'row actions' },
      look,
      h(
        'button',
        { type: 'button', class: 'plain', onclick: () => (test.reset(), change.reset(), settle()) },
        'Reset to my costs',
      ),
      anew,
    ),
    said,
    place,
  );
}

/** What was compared with the plan. */
export function compared(outcome: Outcome): HTMLElement | null {
  const { alternatives } = outcome;
  if (alternatives.length < 2) {
    return null;
  }
  const least = alternatives[0]!.cost;
  return h(
    'details',
    { class: 'compared no-print' },
    h('summary', {}, `Compared with ${count(alternatives.length - 1, 'other plan')}`),
    scroll(
      'What was compared',
      h(
        'table',
        {},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', {}, 'plan'),
            h('th', { class: 'number' }, 'tests'),
            h('th', { class: 'number' }, 'changes'),
            h('th', { class: 'number' }, 'cost'),
            h('th', { class: 'number' }, 'more'),
          ),
        ),
        h(
          'tbody',
          {},
          alternatives.map((each, i) =>
            h(
              'tr',
              { class: i === 0 ? 'own' : null },
              h('td', {}, each.name),
              h('td', { class: 'number' }, number(each.tests)),
              h('td', { class: 'number' }, number(each.changes)),
              h('td', { class: 'number' }, about(each.cost)),
              h(
                'td',
                { class: 'number' },
                i === 0
                  ? ''
                  : `${each.cost >= least ? '+' : ''}` +
                      `${((100 * (each.cost - least)) / (least || 1)).toFixed(1)} %`,
              ),
            ),
          ),
        ),
      ),
    ),
  );
}
