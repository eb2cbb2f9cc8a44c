// What if tests or changes cost more or less: the alternatives in order, and the prices at which they change places.
import { field, fill, h, scroll, select } from '../../lib/dom';
import { number } from '../../lib/words';
import { plot, type Line, type Plot } from '../../parts/plot';
import { about, type Alternative, type Outcome } from './job';

/** What an alternative costs at other prices: its changes keep their proportions. */
export function costAt(each: Alternative, planned: { testCost: number; changeCost: number }, testCost: number, changeCost: number): number {
  const changes = each.cost - each.tests * planned.testCost;
  const scale = planned.changeCost > 0 ? changes * (changeCost / planned.changeCost) : each.changes * changeCost;
  return each.tests * testCost + scale;
}

export type Price = 'test' | 'change';

export interface Range {
  from: number;
  to: number | null;
  best: Alternative;
}

/** Which alternative is cheapest from which price on, the other one being `fixed`: the lower envelope of lines. */
export function ranges(outcome: Outcome, price: Price, fixed: number): Range[] {
  const at = (each: Alternative, x: number) => (price === 'change' ? costAt(each, outcome, fixed, x) : costAt(each, outcome, x, fixed));
  const lines = outcome.alternatives.map((each) => ({ each, at: at(each, 0), slope: at(each, 1) - at(each, 0) }));
  const result: Range[] = [];
  let from = 0;
  let best = lines.reduce((one, other) => (other.at < one.at || (other.at === one.at && other.slope < one.slope) ? other : one));
  for (;;) {
    let next: typeof best | null = null;
    let cross = Infinity;
    for (const line of lines) {
      if (line.slope < best.slope) {
        const meet = (line.at - best.at) / (best.slope - line.slope);
        if (meet < cross || (meet === cross && next && line.slope < next.slope)) {
          cross = meet;
          next = line;
        }
      }
    }
    result.push({ from, to: next ? cross : null, best: best.each });
    if (!next) {
      return result;
    }
    from = cross;
    best = next;
  }
}

/** A slider from a sixteenth to sixteen times `base`, with a field for the number itself. */
function price(label: string, base: number, changed: () => void): { element: HTMLElement; value(): number; reset(): void } {
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
    oninput: () => ((box.value = String(round(middle * 2 ** (Number(slider.value) / 10)))), changed()),
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
    element: h('div', { class: 'field price' }, h('label', { for: id }, label), h('div', { class: 'price-controls' }, box, slider)),
    value: () => Math.max(0, Number(box.value) || 0),
    reset() {
      box.value = String(base);
      slider.value = '0';
    },
  };
}

export function whatIf(
  outcome: Outcome,
  byPart: boolean,
  planAnew: (testCost: number, changeCost: number) => void,
  signal: AbortSignal,
): HTMLElement {
  // This plan, those that are the cheapest at some price, and others as far as there are colours.
  const most = 6;
  const best = ranges(outcome, 'change', outcome.testCost || 1).map((range) => range.best);
  const plotted = [...new Set([outcome.alternatives[0]!, ...best, ...outcome.alternatives])].slice(0, most);
  const test = price('A test costs', outcome.testCost, draw);
  const change = price(byPart ? 'A change costs, where the list does not say' : 'A change costs', outcome.changeCost, draw);
  const body = h('tbody');
  const where = h('tbody');
  const said = h('p', { role: 'status' });
  const anew = h(
    'button',
    { type: 'button', class: 'plain', onclick: () => planAnew(test.value(), change.value()) },
    'Replan at these costs',
  );
  let along: Price = 'change';
  const axis = select(
    along,
    [
      ['change', 'by what a change costs'],
      ['test', 'by what a test costs'],
    ],
    (value) => {
      along = value as Price;
      fill(chartPlace, (chart = chartAlong()).element);
      draw();
    },
  );
  const chartPlace = h('div', {});
  const chartAlong = (): Plot =>
    plot({
      label: `What each alternative costs, by the cost of a ${along}; the numbers are in the tables`,
      x: `cost of a ${along}`,
      y: 'cost of all tests',
      signal,
      xText: about,
      yText: about,
      mark: () => (along === 'change' ? change : test).value(),
      fromZero: true,
    });
  let chart = chartAlong();
  fill(chartPlace, chart.element);

  function draw(): void {
    const [t, c] = [test.value(), change.value()];
    const ranked = outcome.alternatives
      .map((each, i) => ({ each, i, cost: costAt(each, outcome, t, c) }))
      .sort((one, other) => one.cost - other.cost || one.i - other.i);
    const least = ranked[0]!.cost;
    fill(
      body,
      ranked.map(({ each, cost }) =>
        h(
          'tr',
          { class: each === outcome.alternatives[0] ? 'own' : null },
          h('td', {}, h('span', { class: `swatch line-${plotted.indexOf(each) + 1}`, 'aria-hidden': 'true' }), each.name),
          h('td', { class: 'number' }, number(each.tests)),
          h('td', { class: 'number' }, number(each.changes)),
          h('td', { class: 'number' }, about(cost)),
          h('td', { class: 'number' }, cost === least ? 'least' : `+${((100 * (cost - least)) / (least || 1)).toFixed(1)} %`),
        ),
      ),
    );
    const best = ranked[0]!.each;
    const same = t === outcome.testCost && c === outcome.changeCost;
    said.textContent = same
      ? 'These are your costs. Move a slider to see which plan would be cheapest.'
      : best === outcome.alternatives[0]
        ? 'This plan stays the cheapest of them; a new plan may suit these costs better.'
        : `The ${best.name} would be cheaper than this plan. Replan to get it, or a better one.`;
    anew.disabled = same;
    const here = along === 'change' ? c : t;
    const found = ranges(outcome, along, along === 'change' ? t : c);
    fill(
      where,
      found.map(({ from, to, best: cheapest }) =>
        h(
          'tr',
          { class: here >= from && (to === null || here < to) ? 'own' : null },
          h('td', { class: 'number' }, about(from)),
          h('td', { class: 'number' }, to === null ? 'any' : about(to)),
          h('td', {}, cheapest.name),
          h('td', { class: 'number' }, number(cheapest.tests)),
          h('td', { class: 'number' }, number(cheapest.changes)),
        ),
      ),
    );
    const far = Math.max(2 * here, 2 * (along === 'change' ? outcome.changeCost : outcome.testCost), 1.3 * (found.at(-1)?.from ?? 0)) || 1;
    const xs = Array.from({ length: 61 }, (_, i) => (far * i) / 60);
    chart.set(
      xs,
      plotted.map((each, i): Line => ({
        label: each.name,
        colour: i + 1,
        width: i === 0 ? 3 : 1.5,
        ...(i === 0 ? {} : { dash: [8, 2 + 2 * i] }),
        values: xs.map((x) => (along === 'change' ? costAt(each, outcome, t, x) : costAt(each, outcome, x, c))),
      })),
    );
  }
  draw();
  return h(
    'section',
    { class: 'what-if no-print' },
    h('h2', {}, 'What if'),
    h(
      'p',
      {},
      'Fewer tests need more changes, and the other way round. Which plan is cheapest depends on what a test costs beside a change.',
    ),
    h(
      'div',
      { class: 'row' },
      test.element,
      change.element,
      h('button', { type: 'button', class: 'plain', onclick: () => (test.reset(), change.reset(), draw()) }, 'My costs'),
      anew,
    ),
    said,
    scroll(
      'Alternatives',
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
        body,
      ),
    ),
    h('h3', {}, 'Where they break even'),
    h('div', { class: 'row' }, field('Plot', axis)),
    chartPlace,
    scroll(
      'Where they break even',
      h(
        'table',
        {},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', { class: 'number' }, 'from'),
            h('th', { class: 'number' }, 'to'),
            h('th', {}, 'cheapest'),
            h('th', { class: 'number' }, 'tests'),
            h('th', { class: 'number' }, 'changes'),
          ),
        ),
        where,
      ),
    ),
  );
}
