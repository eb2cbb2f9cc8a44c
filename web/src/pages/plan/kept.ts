// The runs of this server and the jobs of this browser, to open again or to forget.
import { h, fill } from '../../lib/dom';
import { count } from '../../lib/words';
import { link, problem } from '../../shell/router';
import { forgetRun, keptRuns } from './run';
import { forget, keptJobs } from './store';
import { dayOf } from './times';

interface Entry {
  href: string;
  title: string;
  said: string;
  forget(): Promise<void> | void;
}

function list(heading: string, entries: readonly Entry[]): HTMLElement {
  const item = (entry: Entry): HTMLElement => {
    const row: HTMLElement = h(
      'li',
      {},
      h('a', { href: entry.href }, entry.title),
      ` ${entry.said} `,
      h(
        'button',
        {
          type: 'button',
          class: 'plain small',
          'aria-label': `Forget ${entry.title}`,
          onclick: () =>
            void Promise.resolve(entry.forget()).then(
              () => row.remove(),
              (fault: unknown) => row.append(problem(fault)),
            ),
        },
        '×',
      ),
    );
    return row;
  };
  return h(
    'details',
    {},
    h('summary', {}, `${heading} (${entries.length})`),
    h('ul', {}, entries.map(item)),
  );
}

/** "30 Nov, 22:02" */
function whenOf(when: number | string): string {
  const time = new Date(when);
  const year = time.getFullYear() === new Date().getFullYear() ? '' : ` ${time.getFullYear()}`;
  const minutes = String(time.getMinutes()).padStart(2, '0');
  return `${dayOf(time)}${year}, ${time.getHours()}:${minutes}`;
}

const doneOf = (done: number, tests: number) =>
  tests > 0 ? `${done} of ${count(tests, 'test')} done, ` : '';

export function keptList(mayForget: boolean, signal: AbortSignal): HTMLElement {
  const box = h('div', { class: 'kept no-print' });
  const jobs = keptJobs();
  const here =
    jobs.length === 0
      ? null
      : list(
          'Jobs in this browser',
          jobs.map((job) => ({
            href: link('plan', { id: job.id }),
            title: job.title,
            said: `${doneOf(job.done, job.tests)}${whenOf(job.when)}`,
            forget: () => forget(job.id),
          })),
        );
  fill(box, here);
  void keptRuns(signal).then(
    (runs) => {
      if (runs.length > 0 && !signal.aborted) {
        const there = list(
          'Runs on this server',
          runs.map((run) => ({
            href: link('plan', { run: run.id }),
            title: run.title,
            said: `${doneOf(run.done, run.tests)}${whenOf(run.changed)}`,
            forget: () =>
              mayForget
                ? forgetRun(run.id, signal)
                : Promise.reject(
                    new Error(
                      'This window may only look: open the address that “changeover serve” ' +
                        'printed.',
                    ),
                  ),
          })),
        );
        fill(box, there, here);
      }
    },
    () => undefined,
  );
  return box;
}
