// The jobs of this browser, to open again or to forget.
import { h, fill } from '../../lib/dom';
import { count } from '../../lib/words';
import { link } from '../../shell/router';
import { forget, keptJobs } from './store';

export function keptList(): HTMLElement | null {
  const jobs = keptJobs();
  if (jobs.length === 0) {
    return null;
  }
  const box = h('details', { class: 'kept no-print' });
  const item = (job: (typeof jobs)[number]): HTMLElement => {
    const row: HTMLElement = h(
      'li',
      {},
      h('a', { href: link('plan', { id: job.id }) }, job.title),
      ` ${job.tests > 0 ? `${job.done} of ${count(job.tests, 'test')} done, ` : ''}${new Date(job.when).toLocaleString()} `,
      h(
        'button',
        { type: 'button', class: 'plain small', 'aria-label': `Forget ${job.title}`, onclick: () => (forget(job.id), row.remove()) },
        '×',
      ),
    );
    return row;
  };
  fill(box, h('summary', {}, `Jobs in this browser (${jobs.length})`), h('ul', {}, jobs.map(item)));
  return box;
}
