// What memory holds, step by step: items as rows, steps as columns; workers beside each other with
// what each has to do.
import type { Ordered } from '../../lib/api';
import { field, fill, h, scroll, select } from '../../lib/dom';
import { bytes, count, number } from '../../lib/words';
import { Choice, Stays } from '../../parts/stays';
import { byFirst } from '../../parts/thumbnail';
import { timeline } from '../../parts/timeline';
import type { Asked } from './order';

/** More than this is not drawn: items, and items in memory over all steps. */
const mostItems = 3000;
const mostHeld = 3_000_000;
/** So many workers are drawn below each other. */
const mostWorkers = 8;
/** And so many without being asked. */
const mostAtFirst = 4;
/** All of them, in the choice of one. */
const every = 'all';

class Picked extends Choice {
  constructor(private readonly names: readonly string[]) {
    super();
  }

  override name(x: number): string {
    return this.names[x] ?? String(x);
  }
}

/** The steps of one worker, or of the one order, drawn: of memory, or of the accelerator. */
function drawn(
  answer: Ordered,
  worker: number | undefined,
  fast: boolean,
  signal: AbortSignal,
): HTMLElement {
  const steps = answer.steps
    .filter((step) => step.worker === worker)
    .map((step) =>
      fast
        ? { load: step.fast_load ?? [], evict: step.fast_evict ?? [] }
        : { load: step.load, evict: step.evict },
    );
  const names = [...new Set(steps.flatMap((step) => step.load.map(String)))];
  const numbers = names.every((name) => /^\d+$/.test(name));
  names.sort((a, b) => (numbers ? Number(a) - Number(b) : a < b ? -1 : 1));
  const index = new Map(names.map((name, i) => [name, i]));
  const held = new Set<number>();
  const blocks: number[][] = [];
  let size = 0;
  for (const step of steps) {
    step.evict.forEach((item) => held.delete(index.get(String(item))!));
    step.load.forEach((item) => held.add(index.get(String(item))!));
    size += held.size;
    if (names.length > mostItems || size > mostHeld) {
      return h(
        'p',
        { class: 'note' },
        'This order has too many items or steps to be drawn; the list of steps has them.',
      );
    }
    blocks.push([...held]);
  }
  const v = names.length;
  const met = new Uint8Array(v * v);
  const pairs = new Int32Array(blocks.length + 1);
  blocks.forEach((block, i) => {
    let fresh = 0;
    const before = new Set(i > 0 ? blocks[i - 1] : []);
    for (const x of block) {
      if (before.has(x)) {
        continue;
      }
      for (const y of block) {
        if (x !== y && met[x * v + y] === 0) {
          met[x * v + y] = met[y * v + x] = 1;
          ++fresh;
        }
      }
    }
    pairs[i + 1] = pairs[i]! + fresh;
  });
  const choice = new Picked(names);
  const stays = new Stays({ v, blocks });
  const said = h('div', { class: 'selected' });
  const tell = (): void => {
    const [x, y] = choice.elements;
    const shared = x !== undefined && y !== undefined ? stays.shared(x, y) : [];
    fill(
      said,
      x === undefined
        ? h(
            'span',
            { class: 'hint' },
            'Click an item to see when it is loaded; click a second one to see when both are ' +
              'there.',
          )
        : [
            h('span', { class: 'selected-key' }),
            h(
              'span',
              {},
              y === undefined
                ? `${names[x]} is loaded ${count(stays.of(x).length, 'time')}: in ${stays
                    .of(x)
                    .map(([from]) => `step ${number(from)}`)
                    .slice(0, 8)
                    .join(', ')}${stays.of(x).length > 8 ? ' …' : ''}.`
                : shared.length === 0
                  ? `${names[x]} and ${names[y]} are never together here.`
                  : `${names[x]} and ${names[y]} are first together in step ` +
                    `${number(shared[0]![0])}.`,
            ),
            h(
              'button',
              { type: 'button', class: 'plain small', onclick: () => choice.choose([]) },
              'Clear',
            ),
          ],
    );
  };
  choice.follow(signal, tell);
  tell();
  const line = timeline(
    {
      v,
      b: blocks.length,
      names,
      pairs,
      allPairs: Math.max(1, pairs.at(-1)!),
      sets: 'pairs',
      stays,
      step: 'step',
      item: 'item',
    },
    choice,
    byFirst(blocks, v),
    signal,
  );
  return h('div', {}, said, line.element);
}

/** `chosen` is called when another worker is looked at. */
export function memory(
  answer: Ordered,
  signal: AbortSignal,
  chosen: (worker: number) => void,
): HTMLElement {
  const workers = [...new Set(answer.steps.map((step) => step.worker))].filter(
    (worker): worker is number => worker !== undefined,
  );
  const hasLevels = answer.order.fast_room !== undefined;
  const place = h('div');
  let leaving = new AbortController();
  signal.addEventListener('abort', () => leaving.abort());
  const show = (): void => {
    leaving.abort();
    leaving = new AbortController();
    const fast = level.value === 'fast';
    if (whose.value === every) {
      fill(
        place,
        workers.map((worker) =>
          h(
            'section',
            { 'aria-label': `Worker ${worker}` },
            h('h3', {}, `Worker ${worker}`),
            drawn(answer, worker, fast, leaving.signal),
          ),
        ),
      );
      return;
    }
    const worker = workers.length > 1 ? Number(whose.value) : workers[0];
    fill(place, drawn(answer, worker, fast, leaving.signal));
  };
  const whose = select(
    workers.length > 1 && workers.length <= mostAtFirst ? every : String(workers[0] ?? ''),
    [
      ...(workers.length > 1 && workers.length <= mostWorkers ? [[every, 'all'] as const] : []),
      ...workers.map((worker) => [String(worker), String(worker)] as const),
    ],
    (worker) => {
      show();
      if (worker !== every) {
        chosen(Number(worker));
      }
    },
  );
  const level = select(
    'memory',
    [
      ['memory', 'memory'],
      ['fast', 'accelerator'],
    ],
    show,
  );
  show();
  return h(
    'section',
    {},
    h('h2', {}, 'What memory holds'),
    h(
      'div',
      { class: 'row memory-head' },
      workers.length > 1 && field('Worker', whose),
      hasLevels && field('Level', level),
      h(
        'p',
        { class: 'hint' },
        `A row for each item, a bar for each time that it is ` +
          `${hasLevels ? 'there' : 'in memory'}: `,
        h('span', { class: 'key key-loaded' }),
        ' loaded, ',
        h('span', { class: 'key key-met' }),
        ' held. Drag on the strip to choose steps',
        h('span', { class: 'with-wheel' }, '; Ctrl + wheel or + and − zoom'),
        '.',
      ),
    ),
    answer.truncated &&
      h(
        'p',
        { class: 'hint' },
        `The first ${number(answer.steps.length)} of ${number(answer.step_count)} steps.`,
      ),
    place,
  );
}

/** What each worker has to do, beside each other. */
export function shares(answer: Ordered, asked: Asked): HTMLElement | null {
  const loads = answer.worker_loads;
  const pairs = answer.worker_pairs;
  if (!loads || !pairs || loads.length < 2) {
    return null;
  }
  const most = Math.max(...loads);
  const inBytes = asked.bytesPerItem !== null || asked.sizes !== null;
  const busiest = loads.filter((each) => each === most).length;
  return h(
    'section',
    {},
    h('h2', {}, 'Workers side by side'),
    scroll(
      'Loads and pairs of each worker',
      h(
        'table',
        { class: 'shares' },
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', { scope: 'col' }, 'worker'),
            h('th', { scope: 'col', class: 'number' }, 'loads'),
            h('td'),
            inBytes && h('th', { scope: 'col', class: 'number' }, 'read'),
            h('th', { scope: 'col', class: 'number' }, 'pairs'),
          ),
        ),
        h(
          'tbody',
          {},
          loads.map((each, i) =>
            h(
              'tr',
              { class: busiest < loads.length && each === most ? 'own' : null },
              h('th', { scope: 'row' }, i),
              h('td', { class: 'number' }, number(each)),
              h(
                'td',
                {},
                h(
                  'meter',
                  {
                    min: 0,
                    max: Math.max(1, most),
                    value: each,
                    'aria-label': count(each, 'load'),
                  },
                  count(each, 'load'),
                ),
              ),
              inBytes &&
                h(
                  'td',
                  { class: 'number' },
                  bytes(answer.worker_bytes?.[i] ?? each * (asked.bytesPerItem ?? 1)),
                ),
              h('td', { class: 'number' }, number(pairs[i]!)),
            ),
          ),
        ),
      ),
    ),
    h(
      'p',
      { class: 'hint' },
      'Each pair is computed by one worker. ',
      busiest === loads.length
        ? 'All workers load as much.'
        : busiest === 1
          ? 'The busiest worker is marked.'
          : 'The busiest workers are marked.',
    ),
  );
}
