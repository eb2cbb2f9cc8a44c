// What is asked of the server about a sheet.
import { post, type Diagnosis } from '../../lib/api';
import { h, type Child } from '../../lib/dom';
import { forDiagnosis, forWhatIf } from './document';
import type { Job } from './job';
import { isDone, type Outcome, type Test } from './outcome';
import { askedWith, atCosts } from './revised';
import { whatIf, whyNoWhatIf } from './what_if';

/** What its failed tests say, of the job as it is now. */
export async function diagnosisOf(
  job: Job,
  outcome: Outcome,
  signal: AbortSignal,
): Promise<Diagnosis> {
  const asked = forDiagnosis(askedWith(job, outcome, outcome.tests, outcome.places));
  return (await post('plan', {}, asked, signal)).diagnosis!;
}

/** The comparison of costs below it. `form`: the job as it is now; `revise` plans the rest of another one after these tests. */
export function whatIfHere(
  job: Job,
  outcome: Outcome,
  form: () => Job,
  revise: (job: Job, tests: Test[]) => void,
  signal: AbortSignal,
): Child {
  const whyNot = whyNoWhatIf(job, outcome);
  if (whyNot !== '') {
    return outcome.benches === null && h('p', { class: 'hint no-print' }, whyNot);
  }
  const done = () => outcome.tests.filter(isDone);
  const ask = async () => {
    const asked = forWhatIf(askedWith(job, outcome, done(), outcome.places));
    const { what_if: found } = await post('plan', {}, asked, signal);
    return found!;
  };
  return whatIf(
    job,
    outcome,
    ask,
    (test, change, times) => revise(atCosts(form(), test, change, times), done()),
    signal,
  );
}
