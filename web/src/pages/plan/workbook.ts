// The sheet as a workbook: the server makes it of the plan that it has followed, as long as it
// remembers that plan.
import { address, get, type Benches, type Plan, type Planned } from '../../lib/api';
import { h } from '../../lib/dom';
import { fileOf } from './job';
import { isDone, type Outcome } from './outcome';

const setUpsOf = (steps: readonly { set_up: string[] }[]): string[][] =>
  steps.map(({ set_up: names }) => names);

/** The set-ups of a plan, bench by bench, as text that can be compared. */
function planned({ plan, benches }: { plan?: Plan; benches?: Benches }): string {
  return JSON.stringify(
    benches
      ? benches.sheets.map((sheet) => [sheet.name, setUpsOf(sheet.steps)])
      : [[null, setUpsOf(plan?.steps ?? [])]],
  );
}

/** The same of what this page shows. The tests that were done before it was planned come first. */
function shown({ tests, benches, doneBefore }: Outcome): string {
  let before = doneBefore;
  const open = tests.filter((test) => !(before > 0 && isDone(test) && before--));
  const of = (name: string | null) =>
    open.filter(({ bench }) => bench === name).map(({ parts }) => parts);
  return JSON.stringify(benches ? benches.map(({ name }) => [name, of(name)]) : [[null, of(null)]]);
}

/**
 * A link to the workbook, hidden until the server says that it has this plan; where the sheet is
 * another one since, why there is none.
 */
export function workbookLink(
  title: string,
  outcome: Outcome,
  signal: AbortSignal,
): HTMLElement | null {
  const { plan: id } = outcome;
  if (id === undefined || id === null) {
    return null;
  }
  const link = h(
    'a',
    {
      class: 'button plain',
      hidden: true,
      href: address('plan/file', { id, format: 'xlsx' }),
      download: `${fileOf(title)}.xlsx`,
    },
    'Workbook',
  );
  const why = h(
    'span',
    { class: 'hint', hidden: true },
    'The workbook is of the plan before a test was added: replan the remaining tests to get one.',
  );
  get('plan/job', { id }, signal).then(
    ({ answer }) => {
      const same = Boolean(answer) && planned(answer as Planned) === shown(outcome);
      link.hidden = !same;
      why.hidden = same || !answer;
    },
    () => undefined, // The server has forgotten the plan, or was restarted.
  );
  return h('span', { class: 'together' }, link, why);
}
