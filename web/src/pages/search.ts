import { get, hasToken, post, type About, type Kind, type SearchJob } from '../lib/api';
import { announce, field, fill, h, select } from '../lib/dom';
import { listen, retryNow } from '../lib/events';
import { cellDetail } from '../lib/source';
import { changes, count, kinds } from '../lib/words';
import { about } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { jobList } from './search/list';
import { watch, type Watch } from './search/watch';
import { found } from './search/words';

const times: readonly (readonly [string, string])[] = [
  ['10', '10 seconds'],
  ['60', '1 minute'],
  ['600', '10 minutes'],
  ['3600', '1 hour'],
  ['28800', '8 hours'],
];

/** Why nothing can be started here, and what helps; null if it can. */
function hindrance({ write }: About): HTMLElement | null {
  if (!write) {
    return h(
      'p',
      { class: 'note' },
      'This server was started with ',
      h('code', {}, '--no-write'),
      ': it searches nothing and keeps nothing. Start ',
      h('code', {}, 'changeover serve'),
      ' without it, or search on the command line: ',
      h('code', {}, 'changeover search 20 5'),
      '.',
    );
  }
  if (!hasToken()) {
    return h(
      'p',
      { class: 'note' },
      'This window may look and not start anything: it was opened without the token. Open the address that ',
      h('code', {}, 'changeover serve'),
      ' printed in its terminal; it ends in ',
      h('code', {}, '?token=…'),
      '.',
    );
  }
  return null;
}

async function render(view: View): Promise<void> {
  const { params, signal } = view;
  const server = await about();
  if (signal.aborted) {
    return;
  }
  const hindered = hindrance(server);
  const v = h('input', { type: 'number', min: 3, value: params.get('v') ?? '', placeholder: '20', oninput: () => soon() });
  const k = h('input', { type: 'number', min: 2, value: params.get('k') ?? '', placeholder: '5', oninput: () => soon() });
  const change = select(params.get('change') ?? '2', changes, () => look());
  const kind = select(params.get('kind') ?? 'circular', kinds, () => look());
  const time = select(params.get('seconds') ?? '60', times, (seconds) => view.go({ seconds }, { quiet: true }));
  const threads = h('input', {
    type: 'number',
    min: 1,
    value: params.get('threads') ?? 1,
    onchange: () => view.go({ threads: threads.value }, { quiet: true }),
  });
  const seed = h('input', {
    type: 'number',
    min: 0,
    value: params.get('seed') ?? 1,
    onchange: () => view.go({ seed: seed.value }, { quiet: true }),
  });
  const start = h('button', { type: 'submit', disabled: hindered !== null }, 'Start');
  const known = h('p', { class: 'hint search-known', role: 'status' });
  const fault = h('div', {});
  const stream = h('p', { class: 'hint stream', role: 'status' });
  const list = jobList((id) => choose(id, true));
  const place = h('div', {});
  const states = new Map<string, SearchJob['state']>();
  let watched: Watch | null = null;
  let watching: AbortController | null = null;
  let chosen: string | null = null;

  /** What is known of the cell that was written, before it is searched. */
  let looking: AbortController | null = null;
  function look(): void {
    view.go({ v: v.value, k: k.value, change: change.value, kind: kind.value }, { quiet: true });
    looking?.abort();
    looking = new AbortController();
    signal.addEventListener('abort', () => looking?.abort(), { once: true });
    if (v.value === '' || k.value === '') {
      known.textContent = '';
      return;
    }
    const mine = looking.signal;
    const cell = { v: Number(v.value), k: Number(k.value), change: Number(change.value), kind: kind.value as Kind };
    cellDetail(cell, mine).then(
      ({ best, lower_bound: bound, impossible }) => {
        const words = impossible
          ? `There is no such design: ${impossible}`
          : best === null
            ? `No design is known yet${bound ? `; none has fewer than ${count(bound, 'block')}` : ''}.`
            : best.b === bound
              ? `Known: ${count(best.b, 'block')}, and no design has fewer. There is nothing to find.`
              : `Known: ${count(best.b, 'block')}; no design has fewer than ${bound ?? '?'}.`;
        fill(known, words, ' ', h('a', { href: link('cell', cell) }, 'More about these parameters'));
      },
      (why: unknown) => !mine.aborted && fill(known, (why as Error).message),
    );
  }

  let timer: ReturnType<typeof setTimeout> | undefined;
  function soon(): void {
    clearTimeout(timer);
    timer = setTimeout(() => signal.aborted || look(), 300);
  }

  function choose(id: string | null, focus = false): void {
    chosen = id;
    watching?.abort();
    watching = new AbortController();
    signal.addEventListener('abort', () => watching?.abort(), { once: true });
    view.go({ id }, { quiet: true });
    list.select(id);
    watched = id === null ? null : watch(id, hindered === null, watching.signal);
    fill(place, watched?.element);
    if (focus) {
      watched?.element.scrollIntoView({ block: 'nearest' });
    }
  }

  async function refresh(): Promise<void> {
    try {
      const jobs = await get('search', {}, signal);
      list.set(jobs);
      jobs.forEach((job) => states.set(String(job.id), job.state));
      const now = jobs.find((job) => String(job.id) === chosen);
      if (now) {
        watched?.update(now);
      } else if (chosen !== null && states.has(chosen)) {
        // The server was started anew and knows nothing of it.
        states.delete(chosen);
        choose(chosen);
      }
    } catch (why) {
      if (!signal.aborted) {
        fill(stream, (why as Error).message);
      }
    }
  }

  async function begin(): Promise<void> {
    fill(fault);
    view.go({ v: v.value, k: k.value, change: change.value, kind: kind.value }, { quiet: true });
    if (v.value === '' || k.value === '') {
      fill(fault, problem(new Error('Write v, the number of elements, and k, the size of the blocks.')));
      (v.value === '' ? v : k).focus();
      return;
    }
    start.disabled = true;
    try {
      const { id } = await post(
        'search',
        {},
        {
          v: Number(v.value),
          k: Number(k.value),
          change: Number(change.value),
          kind: kind.value as Kind,
          seconds: Number(time.value),
          threads: Number(threads.value || 1),
          seed: Number(seed.value || 1),
        },
        signal,
      );
      choose(String(id), true);
      await refresh();
    } catch (why) {
      if (!signal.aborted) {
        fill(fault, problem(why));
      }
    }
    start.disabled = false;
  }

  fill(
    view.root,
    h('h1', {}, 'Search for designs'),
    h(
      'p',
      {},
      'A local search tries to find a design with fewer blocks than are known. It runs on this machine, goes on when this page is closed, and what it finds is verified. It ends at once if the best design known is a minimum.',
    ),
    h(
      'form',
      {
        novalidate: true,
        onsubmit: (event) => {
          event.preventDefault();
          void begin();
        },
      },
      h('div', { class: 'row' }, field('elements v', v), field('block size k', k), field('changes', change), field('kind', kind)),
      h('div', { class: 'row' }, field('for', time), field('threads', threads), field('seed', seed), start),
      known,
    ),
    hindered,
    fault,
    stream,
    place,
    list.element,
  );
  look();
  choose(params.get('id'));
  listen(
    {
      search(job) {
        const id = String(job.id);
        list.update(job);
        if (id === chosen) {
          watched?.update(job);
        }
        if (states.get(id) === 'running' && job.state !== 'running') {
          announce(`Search ${id} has ended: ${found(job)}`);
        }
        states.set(id, job.state);
      },
      state(now, retryIn) {
        if (now === 'waiting') {
          fill(
            stream,
            h('strong', {}, 'The server does not answer. '),
            `Trying again in ${count(retryIn, 'second')}. If it was stopped, start `,
            h('code', {}, 'changeover serve'),
            ' again. ',
            h('button', { type: 'button', class: 'plain small', onclick: retryNow }, 'Try now'),
          );
        } else {
          fill(stream, now === 'open' ? 'Live: this page follows the searches as they go.' : '\u00a0');
        }
        stream.classList.toggle('problem', now === 'waiting');
        if (now === 'open') {
          void refresh();
        }
      },
    },
    signal,
  );
  await refresh();
}

export const search: Page = { path: 'search', title: 'Search', live: true, render };
