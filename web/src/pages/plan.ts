import { announce, field, fill, h, select } from '../lib/dom';
import { save } from '../lib/save';
import { count } from '../lib/words';
import { link, problem, type Page, type View } from '../shell/router';
import { ask } from './plan/ask';
import { headline } from './plan/headline';
import {
  csv,
  decimal,
  emptyJob,
  exampleJob,
  exact,
  partsOf,
  type Job,
  type Outcome,
  type PairMode,
  type State,
  type Test,
} from './plan/job';
import { keptList } from './plan/kept';
import { partsGrid } from './plan/parts';
import { runSheet } from './plan/sheet';
import { keep as keepState, load, newId } from './plan/store';
import { whatIf } from './plan/what_if';

const pairModes: readonly (readonly [PairMode, string])[] = [
  ['all', 'every two parts must meet'],
  ['only', 'only the pairs listed must meet'],
  ['skip', 'the pairs listed need not meet'],
];
const times: readonly (readonly [string, string])[] = [
  ['0', 'as long as it brings something'],
  ['1', '1 second'],
  ['5', '5 seconds'],
  ['30', '30 seconds'],
  ['60', '1 minute'],
];

async function render(view: View): Promise<void> {
  const given = await load(view.params);
  const state: State = given?.state ?? { id: newId(), job: emptyJob(), outcome: null };
  if (view.signal.aborted) {
    return;
  }
  let planning: AbortController | null = null;
  const result = h('div', { class: 'result' });
  const fault = h('div', { class: 'no-print' });
  const kept = h('p', { class: 'hint no-print', role: 'status' });
  const stale = h(
    'p',
    { class: 'note no-print', hidden: true },
    'The job has changed since this sheet was planned. Plan again, or plan the rest if some tests are done.',
  );

  const grid = partsGrid(changed);
  const title = h('input', { type: 'text', value: state.job.title, oninput: changed });
  const atOnce = h('input', { type: 'number', min: 2, value: state.job.atOnce, oninput: changed });
  const testCost = h('input', { type: 'text', inputmode: 'decimal', class: 'cost', value: state.job.testCost, oninput: changed });
  const changeCost = h('input', { type: 'text', inputmode: 'decimal', class: 'cost', value: state.job.changeCost, oninput: changed });
  const pairMode = select(state.job.pairMode, pairModes, () => ((pairsField.hidden = pairMode.value === 'all'), changed()));
  const pairs = h('textarea', {
    class: 'pairs-text',
    spellcheck: 'false',
    placeholder: 'Motor A, Cooler\nMotor B, Cooler',
    oninput: changed,
  });
  pairs.value = state.job.pairs;
  const pairsField = field('Pairs, two parts a line with a comma between', pairs);
  pairsField.hidden = state.job.pairMode === 'all';
  const seconds = select(String(state.job.seconds), times, changed);
  const go = h('button', { type: 'submit' }, 'Plan');
  const many = h('input', {
    type: 'number',
    min: 2,
    max: 1000,
    placeholder: '12',
    'aria-label': 'How many parts, to be called 1, 2, 3, …',
  });
  const pick = h('input', {
    type: 'file',
    accept: '.csv,.tsv,.txt,text/csv,text/plain',
    class: 'unseen',
    tabindex: -1,
    'aria-label': 'A file with a list of parts',
    onchange: () => pick.files?.[0] && void takeFile(pick.files[0]),
  });

  function changed(): void {
    stale.hidden = state.outcome === null;
  }
  async function takeFile(file: File): Promise<void> {
    try {
      grid.set(partsOf(await file.text()));
      changed();
      fill(fault);
    } catch (why) {
      fill(fault, problem(why));
    }
    pick.value = '';
  }

  function readJob(): Job {
    return {
      title: title.value.trim() || 'Run sheet',
      parts: grid.read(),
      atOnce: Number(atOnce.value),
      testCost: decimal(testCost.value, 'Cost of a test'),
      changeCost: decimal(changeCost.value, 'Cost of a change'),
      pairMode: pairMode.value as PairMode,
      pairs: pairs.value,
      seconds: Number(seconds.value),
    };
  }

  async function keep(): Promise<void> {
    try {
      const { s, id, whole } = await keepState(state);
      if (view.signal.aborted) {
        return;
      }
      view.go({ s, id }, { quiet: true });
      kept.textContent = whole
        ? 'The link of this page holds the whole job with its sheet and what is done; this browser keeps it, too.'
        : 'This job is too long for a link: it is kept in this browser, and the link opens it only here. Download it as CSV to pass it on.';
    } catch {
      kept.textContent = 'This browser has no room to keep the job: download it as CSV before you leave.';
    }
  }

  async function run(done: readonly Test[]): Promise<void> {
    planning?.abort();
    const mine = (planning = new AbortController());
    const stop = () => mine.abort();
    view.signal.addEventListener('abort', stop, { once: true });
    fill(fault);
    go.disabled = true;
    try {
      const job = readJob();
      fill(
        fault,
        h(
          'p',
          { class: 'note', role: 'status' },
          `Planning, for ${count(job.seconds || 10, 'second')} at most … `,
          h('button', { type: 'button', class: 'plain', onclick: stop }, 'Stop'),
        ),
      );
      const outcome = await ask(job, done, mine.signal);
      state.job = job;
      state.outcome = outcome;
      fill(fault);
      stale.hidden = true;
      show(outcome);
      result.scrollIntoView({ block: 'start' });
      announce(`${count(outcome.tests.length, 'test')}, cost ${outcome.cost}`);
      await keep();
    } catch (why) {
      if (!view.signal.aborted) {
        fill(fault, mine.signal.aborted ? h('p', { class: 'note' }, 'Stopped.') : problem(why));
        fault.scrollIntoView({ block: 'nearest' });
      }
    } finally {
      view.signal.removeEventListener('abort', stop);
      if (planning === mine) {
        go.disabled = false;
      }
    }
  }

  function show(outcome: Outcome): void {
    const { job } = state;
    const replan = h(
      'button',
      { type: 'button', class: 'plain', onclick: () => run(outcome.tests.filter((test) => test.done)) },
      'Replan the remaining tests',
    );
    const ticked = () => {
      replan.disabled = !outcome.tests.some((test) => test.done);
      void keep();
    };
    const sheet = runSheet(outcome, ticked, view.signal);
    replan.disabled = !outcome.tests.some((test) => test.done);
    fill(
      result,
      headline(job, outcome),
      stale,
      h(
        'div',
        { class: 'row no-print' },
        h('button', { type: 'button', class: 'plain', onclick: () => window.print() }, 'Print the sheet'),
        h('button', { type: 'button', class: 'plain', onclick: () => save('run_sheet.csv', csv(outcome), 'text/csv') }, 'Download CSV'),
        replan,
        h('span', { class: 'hint' }, 'Tick what is done. A part broke? Tick “gone” in the list, then plan the rest.'),
      ),
      kept,
      h(
        'div',
        { class: 'plan-parts' },
        sheet.element,
        whatIf(
          outcome,
          job.parts.some((part) => part.cost !== null),
          (test, change) => (
            (testCost.value = String(test)),
            (changeCost.value = String(change)),
            scalePrices(outcome, change),
            run(outcome.tests.filter((each) => each.done))
          ),
          view.signal,
        ),
      ),
    );
  }

  /** The parts' own costs keep their proportion to the cost for all. */
  function scalePrices(outcome: Outcome, change: number): void {
    if (outcome.changeCost > 0 && change !== outcome.changeCost) {
      grid.set(
        grid.read().map((part) => ({ ...part, cost: part.cost === null ? null : exact((part.cost * change) / outcome.changeCost) })),
      );
    }
  }

  const form = h(
    'form',
    {
      class: 'plan-form no-print',
      onsubmit: (event) => {
        event.preventDefault();
        if (state.outcome?.tests.some((test) => test.done)) {
          // What was done is not lost: the job that it belongs to stays in this browser.
          state.id = newId();
        }
        void run([]);
      },
    },
    h(
      'div',
      { class: 'plan-input' },
      h(
        'section',
        { 'aria-label': 'Parts' },
        h('h2', {}, 'Parts'),
        h('p', { class: 'hint' }, 'Type, or paste two columns from a spreadsheet into the first field: name, cost of putting it in.'),
        grid.element,
        h(
          'div',
          { class: 'row' },
          h('button', { type: 'button', class: 'plain', onclick: () => pick.click() }, 'CSV file …'),
          pick,
          h(
            'span',
            { class: 'together' },
            many,
            h(
              'button',
              {
                type: 'button',
                class: 'plain',
                onclick: () => (
                  grid.set(
                    Array.from({ length: Math.min(1000, Number(many.value || 12)) }, (_, i) => ({ name: String(i + 1), cost: null })),
                  ),
                  changed()
                ),
              },
              'numbered parts',
            ),
          ),
          h('button', { type: 'button', class: 'plain', onclick: () => (grid.set([]), changed()) }, 'Clear'),
        ),
      ),
      h(
        'section',
        { 'aria-label': 'Costs and rules' },
        h('h2', {}, 'Costs and rules'),
        field('How many fit at once', atOnce),
        field('Cost of a test', testCost),
        field('Cost of a change', changeCost, 'of putting a part in, where the list does not say; taking out is free'),
        field('Pairs', pairMode),
        pairsField,
        field('Title of the sheet', title),
        field('Search for', seconds),
        h('div', { class: 'row' }, go),
      ),
    ),
  );
  fill(
    view.root,
    h('h1', { class: 'no-print' }, 'Plan tests'),
    h(
      'p',
      { class: 'no-print' },
      'You have parts, and room for some of them at once. Every two of them have to be tested together. A test costs something, and so does every part that is put in: which set-ups, and in which order? ',
      h('a', { href: link('plan'), onclick: (event) => (event.preventDefault(), useExample()) }, 'Try an example'),
      '.',
    ),
    keptList(),
    form,
    fault,
    result,
  );
  function useExample(): void {
    state.id = newId();
    grid.set(exampleJob.parts);
    title.value = exampleJob.title;
    atOnce.value = String(exampleJob.atOnce);
    testCost.value = String(exampleJob.testCost);
    changeCost.value = String(exampleJob.changeCost);
    void run([]);
  }
  grid.set(state.job.parts);
  if (state.outcome) {
    show(state.outcome);
    if (!given?.other) {
      await keep();
    }
  } else if ((view.params.has('s') || view.params.has('id')) && !given) {
    fill(
      fault,
      problem(
        new Error(
          'This link does not hold a whole job (it may have been cut), and this browser does not have it either. Open it where it was made, or make it anew.',
        ),
      ),
    );
  }
  if (given?.other) {
    const { id, title: name, done, tests, when } = given.other;
    fill(
      fault,
      h(
        'p',
        { class: 'note' },
        `This is the job as the link has it. This browser has it, too, as of ${new Date(when).toLocaleString()}, ${done} of ${count(tests, 'test')} done: `,
        h('a', { href: link('plan', { id }) }, `open that ${name}`),
        '. What you change here is kept beside it.',
      ),
    );
    state.id = newId();
  }
}

export const plan: Page = { path: 'plan', title: 'Plan', live: true, render };
