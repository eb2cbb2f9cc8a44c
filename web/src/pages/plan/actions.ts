// What can be done with a run sheet as a whole.
import { h } from '../../lib/dom';
import { save } from '../../lib/save';
import { fileOf } from './job';
import { csv, verdictOf, type Outcome } from './outcome';

export interface Actions {
  readonly element: HTMLElement;
  refresh(): void;
}

/** `time` says a time of the plan as people do. `mayDiagnose`: whether the faults of this job can be told from results. */
export function sheetActions(
  title: string,
  outcome: Outcome,
  time: (planned: string) => string,
  mayDiagnose: boolean,
  workbook: HTMLElement | null,
  replanned: () => void,
  diagnosed: () => void,
): Actions {
  const button = (words: string, act: () => void): HTMLButtonElement =>
    h('button', { type: 'button', class: 'plain', onclick: act }, words);
  const replan = button('Replan the remaining tests', replanned);
  const diagnose = button('What is at fault?', diagnosed);
  const element = h(
    'div',
    { class: 'row actions no-print' },
    replan,
    diagnose,
    button('Print the sheet', () => window.print()),
    button('Download CSV', () => save(`${fileOf(title)}.csv`, csv(outcome, time), 'text/csv')),
    workbook,
  );
  const refresh = (): void => {
    const verdicts = outcome.tests.map(verdictOf);
    replan.disabled = verdicts.every((verdict) => verdict === '');
    diagnose.hidden = !mayDiagnose || !verdicts.includes('fail');
  };
  return { element, refresh };
}
