// One search, watched: best and bound as they were over time, how fast it goes, and what can be
// done with what it found.
import { get, post, type SearchJob } from '../../lib/api';
import { fill, h, scroll } from '../../lib/dom';
import { cellDetail } from '../../lib/source';
import { count, nameOf, number } from '../../lib/words';
import { ladder } from '../../parts/ladder';
import { plot } from '../../parts/plot';
import { link, problem } from '../../shell/router';
import { isNew, plainly, rate, result, seconds, size, times, wayWords } from './words';

export interface Watch {
  readonly element: HTMLElement;
  /** When it is there as the server knows it. */
  readonly shown: Promise<void>;
  /** News of this search. */
  update(job: SearchJob): void;
}

/** The points are asked for no more often than this, in milliseconds. */
const pause = 1000;

export function watch(id: string, mayAct: boolean, signal: AbortSignal): Watch {
  const name = h('p', { class: 'watch-name' });
  const title = h('h2', { class: 'watch-result', tabindex: -1 });
  const words = h('p', { class: 'watch-state', role: 'status' });
  const message = h('p', { class: 'hint' });
  const progress = h('progress', { max: 1, value: 0, 'aria-label': 'Time used' });
  const said = h('p', { role: 'status' });
  let stopping = false;
  const stop = h(
    'button',
    {
      type: 'button',
      class: 'plain',
      onclick: () => (
        (stopping = true),
        act(stop, post('search/stop', { id }, undefined, signal), () =>
          stopping ? 'Stopping …' : '',
        )
      ),
    },
    'Stop',
  );
  const open = h('a', { class: 'button', href: link('design', { job: id }) }, 'Open the design');
  const why = h('a', { class: 'button plain' });
  const again = h('a', { class: 'button plain' }, 'Search again …');
  const keep = h(
    'button',
    {
      type: 'button',
      class: 'plain',
      onclick: () =>
        act(keep, post('search/keep', { id }, undefined, signal), ({ label, already }) => [
          already ? 'Your catalog has it already: ' : 'Added to your catalog: ',
          h('a', { href: link('design', { label }) }, label),
          '.',
        ]),
    },
    'Add to my catalog',
  );
  const chart = plot({
    label:
      'The best number of blocks over time, with the lower bound; the last numbers are in the text',
    x: 'seconds',
    y: 'blocks',
    signal,
    yText: number,
    whole: true,
  });
  const speed = plot({
    label: 'Speed over time',
    x: 'seconds',
    y: 'a second',
    height: 160,
    signal,
    fromZero: true,
    yText: rate,
  });
  const speeds = h('details', {}, h('summary', {}, 'Speed'), speed.element);
  const figures = h('dl', { class: 'figures' });
  const reached = h('div', {});
  const advice = h('p', { class: 'advice', role: 'status' });
  const decided = h('div', { class: 'decisions' });
  const next = h('div', { class: 'row next-steps' }, open, keep, why, again);
  const element = h(
    'section',
    { class: 'watch' },
    name,
    title,
    words,
    h('div', { class: 'row' }, progress, stop, next),
    said,
    advice,
    figures,
    reached,
    message,
    decided,
    chart.element,
    speeds,
  );

  async function act<T>(
    button: HTMLButtonElement,
    asked: Promise<T>,
    done: (answer: T) => string | (string | Node)[],
  ): Promise<void> {
    button.disabled = true;
    try {
      fill(said, done(await asked));
    } catch (fault) {
      button.disabled = false;
      if (!signal.aborted) {
        fill(said, problem(fault));
      }
    }
  }

  /** As it was asked for last. */
  let curve: NonNullable<SearchJob['points']> = [];
  let asking = false;
  let wanted = false;
  /** Blocks of the best design of the cell; null until that is asked for. */
  let held: number | null = null;
  let heldAsked = false;
  function askHeld(job: SearchJob): void {
    heldAsked = true;
    const { v, k, change, kind, strength } = job;
    cellDetail({ v, k, change, kind, ...(strength === 2 ? {} : { strength }) }, signal).then(
      ({ best }) => {
        held = best?.b ?? null;
        wanted = true; // The bar is drawn again with it.
        void points();
      },
      () => undefined,
    );
  }
  async function points(): Promise<void> {
    if (asking) {
      wanted = true;
      return;
    }
    asking = true;
    try {
      const job = await get('search?id', { id }, signal);
      curve = job.points ?? [];
      show(job);
      advise(job);
      const points = (job.points ?? []).filter(
        (point, i, all) => i === 0 || point.seconds > all[i - 1]!.seconds,
      );
      // A curve of less than a second says nothing, nor do two flat ones.
      const levels = new Set(points.map((point) => `${point.best} ${point.lower_bound}`));
      speeds.hidden = points.length < 2 || points.at(-1)!.seconds < 1;
      chart.element.hidden = speeds.hidden || levels.size < 2;
      if (points.length > 1) {
        chart.set(
          points.map((point) => point.seconds),
          [
            {
              label: 'best',
              colour: 1,
              values: points.map((point) => point.best),
              steps: true,
              width: 3,
            },
            {
              label: 'lower bound',
              colour: 3,
              values: points.map((point) => point.lower_bound ?? job.lower_bound),
              dash: [8, 4],
              steps: true,
            },
          ],
        );
        speed.set(
          points.map((point) => point.seconds),
          [
            {
              label: `${job.unit} a second`,
              colour: 6,
              values: points.map((point) => point.rate),
              width: 1,
            },
          ],
        );
      }
    } catch (fault) {
      if (!signal.aborted && title.textContent === '') {
        fill(
          element,
          problem(fault),
          h(
            'p',
            {},
            'The server forgets its searches when it stops. What was kept is in your catalog.',
          ),
        );
      }
    }
    setTimeout(() => {
      asking = false;
      if (wanted && !signal.aborted) {
        wanted = false;
        void points();
      }
    }, pause);
  }

  /** When the best became better, and whether it pays to go on. */
  function advise(job: SearchJob): void {
    const points = job.points ?? [];
    let last: number | null = null;
    points.forEach((point, i) => {
      const before = points[i - 1]?.best ?? job.start_best;
      if (point.best !== null && before !== null && before !== undefined && point.best < before) {
        last = point.seconds;
      }
    });
    const since = last === null ? job.seconds : job.seconds - last;
    const gap = job.best === null || job.lower_bound === null ? null : job.best - job.lower_bound;
    const facts: [string, string][] = [
      ['gap', gap === null ? '–' : number(gap)],
      ['best', job.best === null ? '–' : number(job.best)],
      ['lower bound', job.lower_bound === null ? '–' : number(job.lower_bound)],
      [
        'last improvement',
        last === null
          ? job.state === 'running'
            ? 'none yet'
            : 'none'
          : job.state === 'running'
            ? `${seconds(since)} ago`
            : `after ${seconds(last)}`,
      ],
    ];
    const running = job.state === 'running';
    const open = job.decisions.find(({ outcome }) => outcome === 'running');
    if (job.way === 'exact') {
      facts[3] = open
        ? ['deciding now', count(open.blocks, 'block')]
        : [
            'numbers decided',
            number(job.decisions.filter(({ outcome }) => outcome !== 'unknown').length),
          ];
    }
    fill(
      figures,
      facts.map(([name, value]) => h('div', {}, h('dt', {}, name), h('dd', {}, value))),
    );
    if (!heldAsked) {
      askHeld(job);
    }
    // The cell may have a better design than what this way of searching begins with.
    const behind = held !== null && (job.best === null || held < job.best);
    const own = job.best === null ? (running ? 'none yet' : 'none') : number(job.best);
    fill(
      reached,
      behind
        ? ladder(job.lower_bound, held, { beside: [own, 'this search'] })
        : ladder(job.lower_bound, job.best, {
            start: job.start_best,
            reached: isNew(job) ? 'this search' : 'best known',
          }),
    );
    fill(
      advice,
      gap === 0
        ? 'Nothing is left to find: the best has as many blocks as the lower bound, so it is a ' +
            'minimum.'
        : behind && held === job.lower_bound
          ? 'The cell has its minimum already: at best this search finds another design with as ' +
            'many blocks.'
          : running && job.way === 'exact'
            ? `Is there a design with ${count(open?.blocks ?? job.lower_bound ?? 1, 'block')}? A ` +
              `solver looks for one, or for a proof that there is none. How long that takes ` +
              `cannot be told.`
            : running && job.seconds > 20 && since > job.seconds / 2
              ? `No improvement for ${seconds(since)}, more than half of the time: stopping, ` +
                `another seed or another way may pay more than waiting.`
              : running
                ? 'Still early: most searches improve in their first minute.'
                : gap !== null && gap > 0
                  ? `A gap of ${number(gap)} is left. A longer search, another seed or another ` +
                    `way may close it.`
                  : '',
    );
  }

  /** Of an exact search: each number of blocks and its result. */
  function showDecisions(job: SearchJob): void {
    const outcomes = {
      running: 'being decided',
      found: 'there is one',
      none: 'there is none: the proof was checked',
      unknown: 'not decided',
    };
    fill(
      decided,
      job.decisions.length === 0
        ? null
        : scroll(
            'Decided number by number',
            h(
              'table',
              {},
              h(
                'thead',
                {},
                h(
                  'tr',
                  {},
                  h('th', { class: 'number' }, 'blocks'),
                  h('th', {}, 'is there a design?'),
                  h('th', { class: 'number' }, 'time'),
                  h('th', { class: 'number' }, 'proof'),
                ),
              ),
              h(
                'tbody',
                {},
                job.decisions.map(({ blocks, outcome, seconds: took, steps }) =>
                  h(
                    'tr',
                    { class: outcome },
                    h('td', { class: 'number' }, number(blocks)),
                    h('td', {}, outcomes[outcome]),
                    h('td', { class: 'number' }, seconds(took)),
                    h('td', { class: 'number' }, steps === 0 ? '' : size(steps)),
                  ),
                ),
              ),
            ),
          ),
    );
  }

  function show(job: SearchJob): void {
    showDecisions(job);
    const running = job.state === 'running';
    const whole = nameOf(job);
    name.textContent =
      `${whole[0]!.toUpperCase()}${whole.slice(1)}` +
      `${job.strength > 2 ? `, strength ${job.strength}` : ''}: ${wayWords[job.way]}`;
    title.textContent = result(job);
    const known = job.best !== null && job.best === job.lower_bound;
    element.classList.toggle('settled', known && !running);
    const states = { running: 'Running', done: 'Done', stopped: 'Stopped', failed: 'Failed' };
    const bound =
      job.lower_bound === null
        ? 'no lower bound is known'
        : `the lower bound is ${number(job.lower_bound)}`;
    words.textContent =
      `${states[job.state]} ${!running && job.seconds < 0.5 ? 'at once' : `after ${seconds(job.seconds)}`}` +
      `${running ? ` of ${seconds(job.limit)}` : ''}${known ? '' : `; ${bound}`}.`;
    // What the figures and the table say already is not said again.
    message.textContent =
      job.way === 'exact' && job.decisions.length > 0 && job.state !== 'failed'
        ? ''
        : job.message === 'nothing better was found'
          ? ''
          : job.message.startsWith('minimum: as many blocks as the lower bound')
            ? job.message.replace(/^minimum: as many blocks as the lower bound(; )?/, '')
            : `${running && job.message !== '' ? 'Now: ' : ''}${plainly(job.message)}`;
    message.classList.toggle('problem', job.state === 'failed');
    progress.hidden = !running;
    progress.value = Math.min(1, job.seconds / job.limit);
    if (!running && stopping) {
      stopping = false;
      fill(said);
    }
    stop.hidden = !running || !mayAct;
    open.hidden = running || job.best === null;
    keep.hidden = running || !isNew(job) || !mayAct;
    const { v, k, change, kind, strength, way } = job;
    const cell = { v, k, change, kind, strength: strength === 2 ? null : strength };
    why.href = link('cell', cell);
    why.textContent = known
      ? 'Why none has fewer'
      : job.best === null
        ? 'What is known of it'
        : 'What is known of the gap';
    why.hidden = running;
    // Longer, and where chance decides from another beginning.
    again.href = link('search', {
      ...cell,
      way: way === 'local' ? null : way,
      seconds: times.find(([s]) => Number(s) > job.limit)?.[0] ?? times.at(-1)![0],
      seed: way === 'exact' ? null : job.seed + 1,
    });
    again.hidden = running || known || !mayAct || (held !== null && held === job.lower_bound);
    // What comes next stands first: what was found, or another try.
    const instead = !again.hidden && !isNew(job);
    if (instead !== (next.firstElementChild === again)) {
      instead ? next.prepend(again) : next.append(again);
    }
    again.classList.toggle('plain', !instead);
    open.classList.toggle('plain', instead);
  }
  [stop, open, keep, why, again, speeds].forEach((each) => (each.hidden = true));
  return {
    element,
    shown: points(),
    update(job) {
      show(job);
      advise({ ...job, points: curve });
      void points();
    },
  };
}
