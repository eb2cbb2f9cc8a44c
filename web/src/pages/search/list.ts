// The searches of the server, running ones and those that ended, kept up to date row by row: the
// focus stays where it is.
import type { SearchJob } from '../../lib/api';
import { fill, h, scroll } from '../../lib/dom';
import { number } from '../../lib/words';
import { shortName } from '../../parts/recipe';
import { found, seconds, stateWords, wayWords } from './words';

export interface JobList {
  readonly element: HTMLElement;
  update(job: SearchJob): void;
  /** All that there are, the latest first. */
  set(jobs: readonly SearchJob[]): void;
  select(id: string | null): void;
}

interface Row {
  element: HTMLTableRowElement;
  update(job: SearchJob): void;
}

export function jobList(chosen: (id: string) => void): JobList {
  const rows = new Map<string, Row>();
  const body = h('tbody');
  const table = scroll(
    'Searches',
    h(
      'table',
      { class: 'searches of-server' },
      h(
        'thead',
        {},
        h(
          'tr',
          {},
          ['design', 'method', 'state', 'best', 'bound', 'time'].map((name, i) =>
            h('th', { scope: 'col', class: i > 3 ? 'number' : null }, name),
          ),
        ),
      ),
      body,
    ),
  );
  let selected: string | null = null;

  function makeRow(job: SearchJob): Row {
    const open = h(
      'button',
      { type: 'button', class: 'as-link', onclick: () => chosen(String(job.id)) },
      `${shortName(job)}${job.strength > 2 ? `, t = ${job.strength}` : ''}`,
    );
    const [state, best, bound, time] = [
      h('td'),
      h('td'),
      h('td', { class: 'number' }),
      h('td', { class: 'number' }),
    ];
    const element = h(
      'tr',
      {},
      h('td', {}, open),
      h('td', {}, wayWords[job.way]),
      state,
      best,
      bound,
      time,
    );
    return {
      element,
      update(now) {
        fill(state, h('span', { class: `badge ${now.state}` }, stateWords[now.state]));
        best.textContent = found(now);
        bound.textContent = now.lower_bound === null ? '–' : number(now.lower_bound);
        time.textContent = seconds(now.seconds);
        const own = selected === String(now.id);
        element.classList.toggle('own', own);
        own ? open.setAttribute('aria-current', 'true') : open.removeAttribute('aria-current');
      },
    };
  }

  const known = new Map<string, SearchJob>();
  const element = h('section', {}, h('h2', {}, 'Searches'), table);
  function show(): void {
    element.hidden = known.size === 0;
  }
  function update(job: SearchJob): void {
    const id = String(job.id);
    known.set(id, job);
    let row = rows.get(id);
    if (!row) {
      row = makeRow(job);
      rows.set(id, row);
      body.prepend(row.element);
    }
    row.update(job);
    show();
  }
  show();
  return {
    element,
    update,
    set(jobs) {
      const ids = new Set(jobs.map(({ id }) => String(id)));
      for (const [id, row] of rows) {
        if (!ids.has(id)) {
          row.element.remove();
          rows.delete(id);
          known.delete(id);
        }
      }
      [...jobs].sort((one, other) => Number(one.id) - Number(other.id)).forEach(update);
      show();
    },
    select(id) {
      selected = id;
      for (const [each, row] of rows) {
        row.update(known.get(each)!);
      }
    },
  };
}
