import {
  get,
  hasToken,
  post,
  type About,
  type Kind,
  type SearchJob,
  type SearchOrder,
  type SearchWay,
} from '../lib/api';
import { work } from '../lib/citations';
import { announce, field, fill, h, select } from '../lib/dom';
import { listen, retryNow } from '../lib/events';
import { cellDetail } from '../lib/source';
import { changes, count, kinds } from '../lib/words';
import { about } from '../shell/about';
import { narrow } from '../parts/lead';
import { more } from '../parts/more';
import { link, problem, type Page, type View } from '../shell/router';
import { beginning } from './search/begin';
import { jobList } from './search/list';
import { watch, type Watch } from './search/watch';
import { found, times } from './search/words';

const ways: readonly (readonly [SearchWay, string, string])[] = [
  [
    'local',
    'local search',
    'Starts from the best design known and changes it step by step. It suits cells with a ' +
      'small gap.',
  ],
  [
    'base-blocks',
    'base blocks',
    'Builds designs with a symmetry from a few blocks and their images. It suits large v.',
  ],
  [
    'exact',
    'exact, with proof',
    'Goes up from the lower bound: a SAT solver finds a design with so many blocks, or proves ' +
      'that there is none, and the proof is checked. It suits small v only.',
  ],
  [
    'locked',
    'locked sets',
    'Looks for a design with certain elements in its first or last block, or with an expansion ' +
      'set, as constructions need them.',
  ],
];
const strengths: readonly (readonly [string, string])[] = [
  ['2', 'pairs (t = 2)'],
  ['3', 'triples (t = 3)'],
  ['4', 'quadruples (t = 4)'],
];

/** Of a local search in a cell without a design. */
const fromNothing =
  'Starts from random blocks, because no design is known yet, and changes them step by step.';

/** "0, 1,2" as elements. @throws Error with a line that can be shown. */
function elementsOf(name: string, text: string): number[] {
  const words = text.split(/[\s,]+/).filter(Boolean);
  if (words.some((word) => !/^\d{1,6}$/.test(word))) {
    throw new Error(`${name}: write numbers of elements, such as 0, 1, 2.`);
  }
  return words.map(Number);
}

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
      'This window may look and not start anything: it was opened without the token. Open the ' +
        'address that ',
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
  const v = h('input', {
    type: 'number',
    min: 3,
    value: params.get('v') ?? '',
    placeholder: '20',
    oninput: () => soon(),
  });
  const k = h('input', {
    type: 'number',
    min: 2,
    value: params.get('k') ?? '',
    placeholder: '5',
    oninput: () => soon(),
  });
  const change = select(params.get('change') ?? '2', changes, () => look());
  const kind = select(params.get('kind') ?? 'circular', kinds, () => look());
  const time = select(params.get('seconds') ?? '60', times, (seconds) =>
    view.go({ seconds }, { quiet: true }),
  );
  /** A whole number; what is wrong with it is marked until it is written anew. */
  const whole = (name: string, least: number): HTMLInputElement => {
    const input = h('input', {
      type: 'number',
      min: least,
      value: params.get(name) ?? 1,
      oninput: () => input.removeAttribute('aria-invalid'),
      onchange: () => view.go({ [name]: input.value }, { quiet: true }),
    });
    return input;
  };
  const threads = whole('threads', 1);
  const seed = whole('seed', 0);
  const strength = select(params.get('strength') ?? '2', strengths, () => look());
  const blocks = h('input', {
    type: 'number',
    min: 1,
    value: params.get('blocks') ?? '',
    placeholder: 'fewest',
    onchange: () => view.go({ blocks: blocks.value }, { quiet: true }),
  });
  const about_way = h('p', { class: 'hint' });
  const way = select(
    params.get('way') ?? 'local',
    ways.map(([name, title]) => [name, title] as const),
    () => look(),
  );
  const firstBlock = h('input', {
    type: 'text',
    value: params.get('first') ?? '',
    placeholder: '0, 1, 2',
    autocomplete: 'off',
  });
  const lastBlock = h('input', {
    type: 'text',
    value: params.get('last') ?? '',
    placeholder: '',
    autocomplete: 'off',
  });
  const expansion = h('input', { type: 'checkbox', checked: params.has('expansion') });
  const locks = h(
    'div',
    { class: 'row' },
    field('In the first block', firstBlock),
    field('In the last block', lastBlock),
    h(
      'label',
      { class: 'check' },
      expansion,
      'unchanged subsets together hold every other element, each once',
    ),
  );
  const start = h(
    'button',
    { type: 'submit', class: 'always', disabled: hindered !== null },
    'Start',
  );
  /** Whether there is nothing to find. A proof of that can be made all the same. */
  let settled = false;
  function nameStart(): void {
    const idle = settled && way.value !== 'exact';
    start.textContent = idle ? 'Search all the same' : 'Start';
    start.classList.toggle('plain', idle);
  }
  way.addEventListener('change', nameStart);
  const known = h('p', { class: 'search-known', role: 'status' });
  const fault = h('div', {});
  const stream = h('p', { class: 'hint stream', role: 'status' });
  const list = jobList((id) => (choose(id, true), fillIn(id)));
  const place = h('div', {});
  const before = beginning();
  const states = new Map<string, SearchJob['state']>();
  let watched: Watch | null = null;
  let watching: AbortController | null = null;
  let chosen: string | null = null;

  /** What is known of the cell that was written, before it is searched. */
  let looking: AbortController | null = null;
  function look(): void {
    view.go(
      {
        v: v.value,
        k: k.value,
        change: change.value,
        kind: kind.value,
        strength: strength.value === '2' ? null : strength.value,
        way: way.value === 'local' ? null : way.value,
      },
      { quiet: true },
    );
    fill(about_way, ways.find(([name]) => name === way.value)?.[2] ?? '');
    locks.hidden = way.value !== 'locked';
    blocks.parentElement!.hidden = way.value === 'exact';
    seed.parentElement!.hidden = way.value === 'exact';
    looking?.abort();
    looking = new AbortController();
    signal.addEventListener('abort', () => looking?.abort(), { once: true });
    before.show(Number(change.value), kind.value as Kind, Number(strength.value));
    // Where more will be said, its room is kept.
    known.classList.toggle('asked', v.value !== '' && k.value !== '');
    if (v.value === '' || k.value === '') {
      known.textContent = 'Write v and k to see what is known of them.';
      return;
    }
    const mine = looking.signal;
    const cell = {
      v: Number(v.value),
      k: Number(k.value),
      change: Number(change.value),
      kind: kind.value as Kind,
      ...(strength.value === '2' ? {} : { strength: Number(strength.value) }),
    };
    cellDetail(cell, mine).then(
      ({ best, lower_bound: bound, impossible, reported }) => {
        const words = impossible
          ? `There is no such design: ${impossible}`
          : best === null
            ? `No design is known yet` +
              `${bound ? `; none has fewer than ${count(bound, 'block')}` : ''}.`
            : best.b === bound
              ? `Gap 0: a design with ${count(best.b, 'block')} is known, and none has fewer. ` +
                `There is nothing to find.`
              : `Gap ${best.b - (bound ?? 0)}: a design with ${count(best.b, 'block')} is known; ` +
                `none has fewer than ${bound ?? '?'}.`;
        if (way.value === 'local' && best === null && !impossible) {
          fill(about_way, fromNothing);
        }
        const nothing = impossible || (best !== null && best.b === bound);
        settled = Boolean(nothing);
        nameStart();
        fill(
          known,
          h('strong', {}, words),
          ' ',
          reported && [
            work(reported.cites),
            ` reports one with ${count(reported.blocks, 'block')}, which is not held here. `,
          ],
          h('a', { href: link('cell', cell) }, 'More about these parameters'),
          nothing
            ? [
                ', or ',
                h(
                  'a',
                  {
                    href: link('catalog', {
                      change: cell.change,
                      kind: cell.kind,
                      strength: cell.strength,
                      gap: 1,
                    }),
                  },
                  'cells with a gap',
                ),
                ', where something may be found',
              ]
            : null,
          '.',
        );
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
    before.element.hidden = watched !== null;
    const now = watched;
    void now?.shown.then(
      () =>
        focus &&
        now === watched &&
        now.element.scrollIntoView({ block: narrow() ? 'start' : 'nearest' }),
    );
  }

  /** The searches as they were last asked for. */
  let asked: readonly SearchJob[] = [];
  /** The form says what the search is of, so that it can be begun again or changed. */
  function fillIn(id: string): void {
    const job = asked.find((each) => String(each.id) === id);
    if (job) {
      [v.value, k.value] = [String(job.v), String(job.k)];
      [change.value, kind.value] = [String(job.change), job.kind];
      [strength.value, way.value] = [String(job.strength), job.way];
      look();
    }
  }

  async function refresh(): Promise<void> {
    try {
      const jobs = await get('search', {}, signal);
      const first = asked.length === 0;
      asked = jobs;
      list.set(jobs);
      if (first && chosen !== null && v.value === '' && k.value === '') {
        fillIn(chosen);
      }
      jobs.forEach((job) => states.set(String(job.id), job.state));
      const now = jobs.find((job) => String(job.id) === chosen);
      if (now) {
        watched?.update(now);
      } else if (chosen !== null && states.has(chosen)) {
        // The server was restarted and does not know this search.
        states.delete(chosen);
        choose(chosen);
      }
    } catch (why) {
      if (!signal.aborted) {
        fill(stream, (why as Error).message);
      }
    }
  }

  const named: readonly (readonly [string, HTMLInputElement])[] = [
    ['v', v],
    ['k', k],
    ['threads', threads],
    ['seed', seed],
    ['blocks', blocks],
    ['In the first block', firstBlock],
    ['In the last block', lastBlock],
  ];

  async function begin(): Promise<void> {
    fill(fault);
    if (v.value === '' || k.value === '') {
      fill(fault, problem(new Error('Write v, the number of elements, and k, the block size.')));
      (v.value === '' ? v : k).focus();
      return;
    }
    start.disabled = true;
    named.forEach(([, input]) => input.removeAttribute('aria-invalid'));
    try {
      const order: SearchOrder = {
        v: Number(v.value),
        k: Number(k.value),
        change: Number(change.value),
        kind: kind.value as Kind,
        seconds: Number(time.value),
        threads: Number(threads.value || 1),
        ...(strength.value === '2' ? {} : { strength: Number(strength.value) }),
        ...(way.value === 'local' ? {} : { way: way.value as SearchWay }),
        ...(way.value === 'exact' ? {} : { seed: Number(seed.value || 1) }),
        ...(blocks.value !== '' && way.value !== 'exact' ? { blocks: Number(blocks.value) } : {}),
      };
      if (way.value === 'locked') {
        const [first, last] = [
          elementsOf('In the first block', firstBlock.value),
          elementsOf('In the last block', lastBlock.value),
        ];
        Object.assign(
          order,
          first.length > 0 ? { first } : {},
          last.length > 0 ? { last } : {},
          expansion.checked ? { expansion_set: true } : {},
        );
        view.go(
          { first: first.join(','), last: last.join(','), expansion: expansion.checked ? 1 : null },
          { quiet: true },
        );
      }
      const { id } = await post('search', {}, order, signal);
      choose(String(id), true);
      await refresh();
    } catch (why) {
      if (!signal.aborted) {
        fill(fault, problem(why));
        // "threads: write 1 to 2, …" is about that field.
        const wrong = named.find(([name]) => (why as Error).message.startsWith(`${name}: `))?.[1];
        wrong?.setAttribute('aria-invalid', 'true');
        wrong?.focus();
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
      'A search looks for a design with fewer blocks than are known, or proves that there is ' +
        'none. It runs on this machine, also after this page is closed. Each design that it ' +
        'finds is verified.',
    ),
    h(
      'form',
      {
        class: 'search-form',
        novalidate: true,
        onsubmit: (event) => {
          event.preventDefault();
          void begin();
        },
      },
      h(
        'div',
        { class: 'row' },
        field('Elements v', v),
        field('Block size k', k),
        field('Change number', change),
        field('Kind', kind),
        field('Covers', strength),
      ),
      known,
      h(
        'div',
        { class: 'row' },
        field('Method', way),
        field('Time', time),
        more('options').element,
        field('Threads', threads),
        field('Seed', seed),
        field('Blocks wanted', blocks),
        start,
      ),
      about_way,
      locks,
    ),
    hindered,
    fault,
    stream,
    h('div', { class: 'search-now' }, place, list.element),
    before.element,
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
          fill(stream, now === 'open' ? '' : '\u00a0');
        }
        stream.dataset['state'] = now;
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
