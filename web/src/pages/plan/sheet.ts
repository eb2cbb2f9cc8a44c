// The run sheet: what to take out and put in, test by test, and what has been done.
import { h, scroll } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { exact, moneyOf, step, type Outcome } from './job';

const piece = 200;

export interface Sheet {
  readonly element: HTMLElement;
  /** After a test was ticked. */
  refresh(): void;
}

/** `ticked` is called after a test was ticked or unticked in `outcome`. */
export function runSheet(outcome: Outcome, ticked: () => void, signal: AbortSignal): Sheet {
  const { tests } = outcome;
  const body = h('tbody');
  const progress = h('progress', { max: tests.length, value: 0, 'aria-label': 'Tests done' });
  const said = h('p', { class: 'sheet-progress', role: 'status' });
  let sum = 0;
  const sums = tests.map(({ cost }) => (sum = exact(sum + cost)));
  const whole = sum;
  const money = moneyOf(tests.map(({ cost }) => cost));

  function refresh(): void {
    const done = tests.filter((test) => test.done);
    const spent = exact(done.reduce((total, { cost }) => total + cost, 0));
    progress.value = done.length;
    said.textContent = `${number(done.length)} of ${count(tests.length, 'test')} done; ${money(spent)} of ${money(whole)} spent.`;
    const next = tests.findIndex((test) => !test.done);
    [...body.rows].forEach((row, i) => {
      row.classList.toggle('done', tests[i]!.done);
      row.classList.toggle('next', i === next);
    });
  }

  function makeRow(i: number): HTMLTableRowElement {
    const test = tests[i]!;
    const { out, in: put } = step(tests, i);
    const box = h('input', {
      type: 'checkbox',
      checked: test.done,
      'aria-label': `Test ${i + 1} is done`,
      onchange: () => {
        test.done = box.checked;
        refresh();
        ticked();
      },
    });
    const fresh = new Set(put);
    return h(
      'tr',
      {},
      h('td', { class: 'centre' }, box),
      h('td', { class: 'number' }, number(i + 1)),
      h('td', { class: 'leave' }, out.length > 0 ? out.join(', ') : '–'),
      h('td', { class: 'enter' }, put.length > 0 ? put.join(', ') : '–'),
      h(
        'td',
        {},
        test.parts.flatMap((name, j) => [j > 0 ? ', ' : null, fresh.has(name) ? h('strong', {}, name) : name]),
      ),
      h('td', { class: 'number' }, money(test.cost)),
      h('td', { class: 'number' }, money(sums[i]!)),
    );
  }

  let drawn = 0;
  function draw(): void {
    if (signal.aborted) {
      return;
    }
    const part = document.createDocumentFragment();
    for (const last = Math.min(tests.length, drawn + piece); drawn < last; ++drawn) {
      part.append(makeRow(drawn));
    }
    body.append(part);
    drawn < tests.length ? requestAnimationFrame(draw) : refresh();
  }
  draw();
  refresh();

  const table = h(
    'table',
    {
      class: 'run-sheet',
      onkeydown: (event) => {
        const { key, target } = event as KeyboardEvent;
        const row = (target as Element).closest('tbody tr');
        const other = key === 'ArrowDown' ? row?.nextElementSibling : key === 'ArrowUp' ? row?.previousElementSibling : null;
        if (other) {
          event.preventDefault();
          other.querySelector('input')?.focus();
        }
      },
    },
    h('caption', { class: 'unseen' }, 'Run sheet'),
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', {}, 'done'),
        h('th', { class: 'number' }, 'test'),
        h('th', {}, 'take out'),
        h('th', {}, 'put in'),
        h('th', {}, 'what is in'),
        h('th', { class: 'number' }, 'cost'),
        h('th', { class: 'number' }, 'so far'),
      ),
    ),
    body,
  );
  return { element: h('div', {}, h('div', { class: 'row no-print' }, progress, said), scroll('Run sheet', table)), refresh };
}
