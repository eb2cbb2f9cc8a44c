// An order of loads, drawn: numbers with the bound, what simple orders cost, curves, and the steps
// themselves.
import type { Ordered } from '../../lib/api';
import { token } from '../../lib/canvas';
import { h, scroll, type Child } from '../../lib/dom';
import { bytes, count, number } from '../../lib/words';
import { ladder } from '../../parts/ladder';
import { reason } from '../../parts/recipe';
import { letterWidth, virtualList } from '../../parts/virtual';
import { naive } from './naive';

export interface Asked {
  /** null: as many as the pairs name. */
  items: number | null;
  room: number;
  /** Of these on an accelerator, where pairs meet; null: one level. */
  fastRoom: number | null;
  bytesPerItem: number | null;
  workers: number;
  /** Of a search, in seconds; 0: none. */
  seconds: number;
  prefetch: boolean;
  /** Two items a line. */
  pairs: string | null;
  /** An item and its bytes a line; then `memory` counts, and not `room`. */
  sizes: string | null;
  memory: number | null;
  fastMemory: number | null;
  epochs: number;
  /** No item at two workers. */
  disjoint: boolean;
}

/**
 * What is compared with: orders for the places that are not kept for what is loading, if some are.
 * An order for all places may have fewer loads, but these then wait for what is evicted.
 */
interface Bounds {
  /** null: no place is kept. */
  kept: { room: number } | null;
  loads: number;
  /** Of the busiest worker. */
  makespan: number | undefined;
}

function boundsOf({ order }: Ordered): Bounds {
  const { order_bound: loads, order_room: room } = order;
  return loads === undefined || room === undefined
    ? { kept: null, loads: order.lower_bound, makespan: order.makespan_bound }
    : { kept: { room }, loads, makespan: order.order_makespan_bound };
}

function over(loads: number, { kept, loads: bound }: Bounds): string {
  const none = kept
    ? `no order for the other ${number(kept.room)} has fewer`
    : 'no order has fewer';
  return loads <= bound ? none : `${none} than ${number(bound)}, so ${atMost(loads, bound)}`;
}

const atMost = (loads: number, bound: number, who = 'this one'): string =>
  `${who} has at most ${((100 * (loads - bound)) / bound).toFixed(1)}\u00a0% more than the least ` +
  'possible';

/** The same of the busiest of several workers. */
function shareOver(loads: number, bound: number, kept: boolean): string {
  const words =
    loads <= bound
      ? 'no other way to share the work makes that fewer'
      : `one worker has at least ${number(bound)} however the work is shared, so ` +
        atMost(loads, bound, `the busiest, with ${number(loads)},`);
  return kept ? `With ${keptWords}, ${words}` : words[0]!.toUpperCase() + words.slice(1);
}

/** What is read, and the least that can be: by all, or by the busiest of several workers. */
function readWords(answer: Ordered, size: number): string {
  const { bytes: read, makespan } = answer;
  const { kept, loads, makespan: spanBound } = boundsOf(answer);
  const least = kept ? loads * size : answer.bytes_bound;
  if (makespan === undefined || spanBound === undefined) {
    if (read <= least) {
      return ` ${bytes(read)} are read; less is not possible.`;
    }
    const more = answer.order.memory === undefined ? '' : `, so ${atMost(read, least)}`;
    return ` ${bytes(read)} are read; less than ${bytes(least)} is not possible${more}.`;
  }
  const most = answer.makespan_bytes ?? makespan * size;
  const bound = kept ? spanBound * size : (answer.makespan_bytes_bound ?? spanBound * size);
  return (
    ` ${bytes(read)} are read, ${bytes(most)} of them by the busiest worker; ` +
    (most > bound
      ? `however the work is shared, one worker reads at least ${bytes(bound)}.`
      : 'no other way to share the work makes that less.')
  );
}

/** What is said of disjoint workers. */
const apart = ' that step together and never hold one item twice';

const inEpochs = ({ order }: Ordered): string =>
  order.epochs === undefined ? '' : ` in each of ${count(order.epochs, 'epoch')}`;

/** What fits at once. */
function places({ order }: Ordered): string {
  const { memory, fast_memory: fastMemory, room, fast_room: fastRoom } = order;
  const [whole, some] =
    memory === undefined
      ? [`room for ${number(room)}`, fastRoom === undefined ? '' : `${number(fastRoom)} of them`]
      : [
          `${bytes(memory)} of memory`,
          fastMemory === undefined ? '' : `${bytes(fastMemory)} of it`,
        ];
  return some === '' ? whole : `${whole}, ${some} on an accelerator`;
}

function epochWords({ order: { epoch_loads: loads = [] } }: Ordered): HTMLElement | null {
  const [first, ...later] = loads;
  if (first === undefined || later.length === 0) {
    return null;
  }
  const [least, most] = [Math.min(...later), Math.max(...later)];
  return h(
    'p',
    {},
    `${count(first, 'load')} in the first epoch, ` +
      `${least === most ? '' : `${number(least)} to `}${number(most)} in ` +
      `${later.length === 1 ? 'the other' : 'each later one'}.`,
  );
}

const keptWords = 'one place kept for the item that is loading';

/** From so many blocks to so many loads; '' where the reason is not one of blocks. */
function lastStep(why: string, room: number, bound: number): string {
  const blocks = Number(/(\d+)\D*$/.exec(why)?.[1]);
  return /^loads from number \d+ on make blocks/.test(why) && room + blocks - 1 === bound
    ? `The first block takes ${count(room, 'load')}, each of the ${number(blocks - 1)} after it at ` +
        `least one: ${number(room)} + ${number(blocks - 1)} = ${number(bound)} loads.`
    : '';
}

/** The reasons of all bounds that are shown, each with what it is of. */
function reasons(answer: Ordered): [of: string, why: string][] {
  const { order } = answer;
  const { kept } = boundsOf(answer);
  const all = kept ? `With all ${number(order.room)} places: ` : '';
  const rest = kept ? `With room for ${number(kept.room)}: ` : '';
  const together = (bound: number): string =>
    `${kept ? 'all' : 'All'} workers together have at least ${count(bound, 'load')}: `;
  const found: [string, string | undefined][] =
    order.makespan_bound === undefined
      ? [
          [rest, order.order_bound_reason],
          [all, order.bytes_bound_reason ?? order.lower_bound_reason],
        ]
      : [
          [rest, order.order_makespan_bound_reason],
          [all, order.makespan_bytes_bound_reason ?? order.makespan_bound_reason],
          [all + together(order.lower_bound), order.lower_bound_reason],
        ];
  return found.flatMap(([of, why]): [string, string][] => (why === undefined ? [] : [[of, why]]));
}

/**
 * `search` looks for fewer loads for so many seconds; `before` are the loads without this search, if
 * that was asked.
 */
export function headline(
  answer: Ordered,
  asked: Asked,
  search: (seconds: number) => void,
  before: number | null,
): HTMLElement {
  const { order } = answer;
  const pairs = answer.pairs / (order.epochs ?? 1);
  const { loads, makespan, workers } = order;
  const bounds = boundsOf(answer);
  const { kept, makespan: spanBound } = bounds;
  const given = kept ? ' with a place kept' : '';
  const shared = makespan !== undefined && spanBound !== undefined && workers !== undefined;
  const searchButton = (seconds: number) =>
    h(
      'button',
      { type: 'button', class: 'plain', onclick: () => search(seconds) },
      `Search ${seconds} seconds for fewer`,
    );
  const open = shared ? makespan > spanBound : loads > bounds.loads;
  const longer =
    open && asked.sizes === null && asked.seconds < longest ? [' ', searchButton(longest)] : null;
  return h(
    'div',
    { class: 'verdict valid', role: 'status' },
    h('h2', {}, `${count(loads, 'load')} in ${count(order.steps, 'step')}`),
    shared
      ? ladder(spanBound, makespan, { of: 'loads', reached: 'the busiest', given })
      : asked.sizes === null &&
          ladder(bounds.loads, loads, { of: 'loads', reached: 'this order', given }),
    h(
      'p',
      {},
      shared
        ? `For ${count(workers, 'worker')}${asked.disjoint ? apart : ''}` +
            `${inEpochs(answer)}; the busiest has ${count(makespan, 'load')}. ` +
            `${shareOver(makespan, spanBound, kept !== null)}.`
        : `${asked.pairs ? count(pairs, 'pair') : `All ${count(pairs, 'pair')}`} of ` +
            `${count(order.items, 'item')}${inEpochs(answer)}, with ${places(answer)}` +
            `${kept ? `, ${keptWords}` : ''}` +
            `${asked.sizes === null ? `: ${over(loads, bounds)}` : ''}.`,
      (asked.bytesPerItem !== null || asked.sizes !== null) &&
        readWords(answer, asked.bytesPerItem ?? 1),
    ),
    kept &&
      h(
        'p',
        { class: 'hint' },
        `An order for all ${number(order.room)} places may have fewer loads, but then they wait `,
        'for what is evicted: ',
        shared && order.makespan_bound !== undefined
          ? `there some worker has at least ${number(order.makespan_bound)}.`
          : `there the bound is ${number(order.lower_bound)}.`,
      ),
    epochWords(answer),
    order.overlapped !== undefined &&
      h(
        'p',
        {},
        `${number(order.overlapped)} of ${number(order.pairs ?? pairs)} pairs are computed `,
        'while items load.',
      ),
    order.loads_ahead !== undefined &&
      h(
        'p',
        {},
        `${number(order.loads_ahead)} of ${count(loads, 'load')} start in a step before the ` +
          'transfer that needs them, and run while pairs are computed.',
      ),
    answer.time_is_up === true
      ? h(
          'p',
          {},
          'The time was up before everything was tried: this is the best order so far. The ' +
            'command line has no such limit.',
        )
      : asked.seconds > 0
        ? h('p', {}, searchedWords(asked.seconds, makespan ?? loads, before, shared), longer)
        : asked.sizes === null && open && h('p', {}, searchButton(10)),
    asked.sizes === null &&
      asked.room > order.items &&
      h(
        'p',
        { class: 'hint' },
        `Room for ${number(asked.room)} is more than all ${count(order.items, 'item')}: some of it ` +
          'stays empty.',
      ),
    h('p', { class: 'hint' }, 'An independent checker read every step and counted every pair.'),
    h(
      'details',
      {},
      h('summary', {}, 'Why not fewer'),
      reasons(answer).map(([of, why]) => {
        const last =
          lastStep(why, kept?.room ?? order.room, bounds.loads) ||
          lastStep(why, order.room, order.lower_bound);
        return h(
          'div',
          {},
          h('p', {}, of, reason(why)),
          last !== '' && h('p', { class: 'last-step' }, last),
        );
      }),
    ),
    h(
      'details',
      {},
      h('summary', {}, 'Where the order comes from'),
      h('p', {}, reason(order.explanation)),
    ),
  );
}

/** How long the page searches at most, in seconds. */
const longest = 25;

function searchedWords(
  seconds: number,
  loads: number,
  before: number | null,
  shared: boolean,
): string {
  const who = shared ? ' of the busiest worker' : '';

  return before === null
    ? `Searched for ${seconds} s for fewer loads.`
    : loads < before
      ? `A search of ${seconds} s found an order with ${number(before - loads)} fewer loads${who} ` +
        `than the ${number(before)} before.`
      : `A search of ${seconds} s found no order with fewer loads${who}.`;
}

export function comparison(answer: Ordered, asked: Asked): HTMLElement | null {
  const alike = asked.sizes === null && asked.epochs === 1;
  if (asked.pairs || asked.workers > 1 || asked.fastRoom !== null || !alike) {
    return null;
  }
  const { kept, loads: bound } = boundsOf(answer);
  const simple = naive(answer.order.items, kept?.room ?? asked.room);
  if (simple.length === 0) {
    return null;
  }
  const rows: [name: string, how: string, loads: number, own: boolean][] = [
    ['lower bound', 'no order has fewer', bound, false],
    ['this order', 'below, step by step', answer.loads, true],
    ...simple
      .sort((one, other) => one.loads - other.loads)
      .map(({ name, how, loads }): [string, string, number, boolean] => [name, how, loads, false]),
  ];
  return h(
    'section',
    {},
    h('h2', {}, 'Beside simple orders'),
    kept &&
      h(
        'p',
        { class: 'hint' },
        `All of them for ${number(kept.room)} places: one is kept for the item that is loading.`,
      ),
    scroll(
      'Loads of this order and of simple ones',
      h(
        'table',
        {},
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', {}, 'order'),
            h('th', { class: 'number' }, 'loads'),
            h('th', { class: 'number' }, 'of the bound'),
            asked.bytesPerItem !== null && h('th', { class: 'number' }, 'read'),
            h('th', {}, 'how'),
          ),
        ),
        h(
          'tbody',
          {},
          rows.map(([name, how, loads, own]) =>
            h(
              'tr',
              { class: own ? 'own' : null },
              h('th', { scope: 'row' }, name),
              h('td', { class: 'number' }, number(loads)),
              h('td', { class: 'number' }, `× ${(loads / bound).toFixed(3)}`),
              asked.bytesPerItem !== null &&
                h('td', { class: 'number' }, bytes(loads * asked.bytesPerItem)),
              h('td', { class: 'meaning' }, how),
            ),
          ),
        ),
      ),
    ),
  );
}

/** What both levels move, beside the least that they can. */
export function levels({ order }: Ordered, asked: Asked): HTMLElement | null {
  const { transfers, transfer_bound: fewest } = order;
  if (transfers === undefined || fewest === undefined) {
    return null;
  }
  const rows: [name: string, moves: number, bound: number][] = [
    ['disk to memory', order.loads, order.lower_bound],
    ['memory to accelerator', transfers, fewest],
  ];
  return h(
    'section',
    {},
    h('h2', {}, 'Both levels'),
    scroll(
      'What both levels move',
      h(
        'table',
        { class: 'levels' },
        h(
          'thead',
          {},
          h(
            'tr',
            {},
            h('th', {}, 'from and to'),
            h('th', { class: 'number' }, 'moves'),
            h('th', { class: 'number' }, 'at least'),
            h('th', { class: 'number' }, 'of the bound'),
            asked.bytesPerItem !== null && h('th', { class: 'number' }, 'moved'),
          ),
        ),
        h(
          'tbody',
          {},
          rows.map(([name, moves, bound]) =>
            h(
              'tr',
              {},
              h('th', { scope: 'row' }, name),
              h('td', { class: 'number' }, number(moves)),
              h('td', { class: 'number' }, number(bound)),
              h('td', { class: 'number' }, `× ${(moves / bound).toFixed(3)}`),
              asked.bytesPerItem !== null &&
                h('td', { class: 'number' }, bytes(moves * asked.bytesPerItem)),
            ),
          ),
        ),
      ),
    ),
    h(
      'p',
      { class: 'hint' },
      'Pairs meet on the accelerator; what is there stays in memory, too. The column “at least” ' +
        'holds for every order with this room in memory and on the accelerator.',
    ),
  );
}

/** Names of several words have commas between. */
function listed(items: (number | string)[]): string {
  return items.join(items.some((item) => /\s/.test(String(item))) ? ', ' : ' ');
}

/** How wide a text of the list is, in letters of virtualList(). */
let measuring: CanvasRenderingContext2D | null = null;
function wide(text: string, bold: boolean): number {
  measuring ??= document.createElement('canvas').getContext('2d')!;
  measuring.font = `${bold ? '700 ' : ''}16px ${token('--text-font')}`;
  return measuring.measureText(text).width / letterWidth;
}
/** What is left between two kinds of moves, in letters. */
const between = 2;

/** Moves of one kind stand below each other if they are no wider, in letters. */
const widestColumn = 13;
/** So many steps tell how wide columns are. */
const looked = 400;

/** How wide the columns of moves are, in letters; 0 of a kind that no step has. */
function columnsOf(
  steps: Ordered['steps'],
): [load: number, evict: number, come: number, leave: number] {
  const widest = (items: (step: Ordered['steps'][number]) => (number | string)[] | undefined) =>
    Math.min(
      widestColumn,
      Math.max(
        0,
        ...steps
          .slice(0, looked)
          // Not where memory is filled.
          .filter(({ evict, fast_evict: leave = [] }) => evict.length + leave.length > 0)
          .map((step) => items(step) ?? [])
          .map((some) => (some.length === 0 ? 0 : wide(`transfer ${listed(some)}`, true))),
      ),
    );
  return [
    widest(({ load }) => load),
    widest(({ evict }) => evict),
    widest(({ fast_load: come }) => come),
    widest(({ fast_evict: leave }) => leave),
  ];
}

export interface StepList {
  readonly element: HTMLElement;
  /** Brings the first step of a worker to the top of the list. */
  goTo(worker: number): void;
}

export function stepList(answer: Ordered): StepList {
  const shared = answer.steps.some(({ worker }) => worker !== undefined);
  const starts = new Set(
    answer.steps.filter((step, i) => step.epoch !== answer.steps[i - 1]?.epoch),
  );
  const columns = columnsOf(answer.steps);
  /** What a step does with items; its column stays where it does nothing with any. */
  /** Where memory is filled, a step has many items and no columns. */
  const fills = ({ evict, fast_evict: leave = [] }: Ordered['steps'][number]): boolean =>
    evict.length + leave.length === 0;
  const move = (
    column: number,
    kind: string,
    words: Child[],
    aligned: boolean,
  ): HTMLElement | false => {
    if (words.length === 0 && (!aligned || columns[column] === 0)) {
      return false;
    }
    const place = h('span', { class: `move ${kind}` }, words);
    aligned && place.style.setProperty('--column', `${columns[column]! * letterWidth}px`);
    return place;
  };
  const list = virtualList({
    label: `The ${number(answer.steps.length)} steps`,
    rows: answer.steps.length,
    letters(i) {
      const { load, evict, fast_load: come = [], fast_evict: leave = [] } = answer.steps[i]!;
      const kinds: [(number | string)[], string, boolean][] = [
        [load, 'load ', true],
        [evict, 'evict ', false],
        [come, 'transfer ', false],
        [leave, 'take off ', false],
      ];
      return kinds.reduce(
        (sum, [items, verb, bold], column) =>
          sum +
          Math.max(
            fills(answer.steps[i]!) ? 0 : columns[column]!,
            items.length > 0 ? wide(verb, false) + wide(listed(items), bold) + between : 0,
          ),
        0,
      );
    },
    row(i) {
      const { step, worker, load, evict, before, compute, epoch } = answer.steps[i]!;
      const { fast_load: come = [], fast_evict: leave = [] } = answer.steps[i]!;
      const aligned = !fills(answer.steps[i]!);
      const parts: Child[] = [
        h('span', { class: 'block-number' }, shared ? `${worker} · ${number(step)}` : number(step)),
        move(
          0,
          'load',
          load.length > 0
            ? ['load ', h('strong', {}, listed(load))]
            : come.length + evict.length + leave.length === 0
              ? ['load nothing']
              : [],
          aligned,
        ),
        move(1, 'block-out', evict.length > 0 ? ['evict ', listed(evict)] : [], aligned),
        epoch !== undefined &&
          starts.has(answer.steps[i]!) &&
          h('span', { class: 'hint' }, `epoch ${number(epoch)} begins`),
        move(2, '', come.length > 0 ? ['transfer ', listed(come)] : [], aligned),
        move(3, 'block-out', leave.length > 0 ? ['take off ', listed(leave)] : [], aligned),
        before &&
          compute &&
          h(
            'span',
            { class: 'hint' },
            `${count(before.length + compute.length, 'pair')} meanwhile`,
          ),
      ];
      return h('div', { class: 'block' }, parts);
    },
  });
  const element = h(
    'section',
    {},
    h('h2', {}, 'Steps'),
    shared && h('p', { class: 'hint' }, 'Worker · step'),
    list.element,
    answer.truncated &&
      h(
        'p',
        { class: 'hint' },
        `These are the first ${number(answer.steps.length)} of ${number(answer.step_count)} ` +
          `steps; the command below writes all of them.`,
      ),
  );
  return {
    element,
    goTo(worker) {
      list.goTo(
        answer.steps.findIndex((step) => step.worker === worker),
        'top',
      );
    },
  };
}

export function jsonLines({ order, steps }: Ordered): string {
  return [order, ...steps].map((line) => JSON.stringify(line)).join('\n') + '\n';
}
