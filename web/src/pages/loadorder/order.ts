// An order of loads, drawn: numbers with the bound, what simple orders cost, curves, and the steps themselves.
import { h, scroll, type Child } from '../../lib/dom';
import { bytes, count, number } from '../../lib/words';
import { plot } from '../../parts/plot';
import { virtualList } from '../../parts/virtual';
import { naive } from './naive';

export interface Answer {
  loads: number;
  lower_bound: number;
  reason?: string;
  method?: string;
  explanation?: string;
  bytes: number;
  bytes_bound: number;
  step_count?: number;
  steps: { step: number; worker?: number; load: number[]; evict: number[] }[];
  truncated: boolean;
  sample_every?: number;
  memory: number[];
  pairs_done: number[];
  makespan?: number;
  makespan_bound?: number;
  worker_loads?: number[];
}

export interface Asked {
  items: number;
  room: number;
  bytesPerItem: number | null;
  workers: number;
  pairs: [number, number][] | null;
}

function over(loads: number, bound: number): string {
  return loads <= bound
    ? 'no order has fewer'
    : `no order has fewer than ${number(bound)}, so this one has at most ${((100 * (loads - bound)) / bound).toFixed(1)} % more than the least possible`;
}

export function headline(answer: Answer, asked: Asked): HTMLElement {
  const steps = answer.step_count ?? answer.steps.length;
  const shared = answer.makespan !== undefined && answer.makespan_bound !== undefined;
  return h(
    'div',
    { class: 'verdict valid', role: 'status' },
    h('h2', {}, `${count(answer.loads, 'load')} in ${count(steps, 'step')}`),
    h(
      'p',
      {},
      shared
        ? `For ${count(asked.workers, 'worker')}; the busiest has ${count(answer.makespan!, 'load')}: ${over(answer.makespan!, answer.makespan_bound!)}.`
        : `${asked.pairs ? count(asked.pairs.length, 'pair') : `All ${number((asked.items * (asked.items - 1)) / 2)} pairs`} of ${count(asked.items, 'item')}, with room for ${number(asked.room)}: ${over(answer.loads, answer.lower_bound)}.`,
      asked.bytesPerItem !== null &&
        ` ${bytes(answer.bytes)} are read${shared || answer.bytes <= answer.bytes_bound ? '' : `; less than ${bytes(answer.bytes_bound)} is not possible`}.`,
    ),
    h('p', { class: 'hint' }, 'Every step was read and every pair counted by a program of its own.'),
    answer.reason &&
      h(
        'details',
        {},
        h('summary', {}, 'Why not fewer'),
        h('p', {}, shared ? `All workers together have at least ${count(answer.lower_bound, 'load')}: ` : '', answer.reason),
      ),
    answer.explanation && h('details', {}, h('summary', {}, 'Where the order comes from'), h('p', {}, answer.explanation)),
  );
}

export function comparison(answer: Answer, asked: Asked): HTMLElement | null {
  if (asked.pairs || asked.workers > 1) {
    return null;
  }
  const simple = naive(asked.items, asked.room);
  if (simple.length === 0) {
    return null;
  }
  const rows: [name: string, how: string, loads: number, own: boolean][] = [
    ['lower bound', 'no order has fewer', answer.lower_bound, false],
    ['this order', 'below, step by step', answer.loads, true],
    ...simple
      .sort((one, other) => one.loads - other.loads)
      .map(({ name, how, loads }): [string, string, number, boolean] => [name, how, loads, false]),
  ];
  return h(
    'section',
    {},
    h('h2', {}, 'Beside simple orders'),
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
              h('td', { class: 'number' }, `× ${(loads / answer.lower_bound).toFixed(3)}`),
              asked.bytesPerItem !== null && h('td', { class: 'number' }, bytes(loads * asked.bytesPerItem)),
              h('td', { class: 'meaning' }, how),
            ),
          ),
        ),
      ),
    ),
  );
}

export function curves(answer: Answer, asked: Asked, signal: AbortSignal): HTMLElement {
  const steps = answer.step_count ?? answer.steps.length;
  const every = answer.sample_every ?? Math.max(1, Math.round(steps / answer.memory.length));
  const chart = plot({
    label: `Items in memory and pairs that have met, step by step: at the end ${answer.pairs_done.at(-1) ?? 0} pairs; never more than ${asked.room} items`,
    x: asked.workers > 1 ? 'step, one worker after another' : 'step',
    y: 'items in memory',
    right: 'pairs that have met',
    signal,
    fromZero: true,
    yText: (y) => (Number.isInteger(y) ? number(y) : ''),
    rightText: (y) => (y >= 1e6 ? `${y / 1e6} M` : y >= 1e4 ? `${y / 1e3} k` : String(y)),
  });
  chart.set(
    answer.memory.map((_, i) => Math.min(i * every + 1, steps)),
    [
      { label: 'items in memory', colour: 1, values: answer.memory, steps: true },
      { label: 'pairs that have met', colour: 2, values: answer.pairs_done, right: true, dash: [8, 4] },
    ],
  );
  return h('section', {}, h('h2', {}, 'Step by step'), chart.element);
}

export function stepList(answer: Answer): HTMLElement {
  const shared = answer.steps.some(({ worker }) => worker !== undefined);
  const list = virtualList({
    label: `The ${number(answer.steps.length)} steps`,
    rows: answer.steps.length,
    row(i) {
      const { step, worker, load, evict } = answer.steps[i]!;
      const parts: Child[] = [
        h('span', { class: 'block-number' }, shared ? `${worker} · ${number(step)}` : number(step)),
        h('span', { class: 'load' }, 'load ', h('strong', {}, load.join(' '))),
        evict.length > 0 && h('span', { class: 'block-out' }, 'evict ', evict.join(' ')),
      ];
      return h('div', { class: 'block' }, parts);
    },
  });
  return h(
    'section',
    {},
    h('h2', {}, 'Steps'),
    shared && h('p', { class: 'hint' }, 'Worker · step'),
    list.element,
    answer.truncated &&
      h(
        'p',
        { class: 'hint' },
        `These are the first ${number(answer.steps.length)} of ${number(answer.step_count ?? 0)} steps; the command below writes all of them.`,
      ),
  );
}

export function jsonLines(answer: Answer, asked: Asked): string {
  const { loads, lower_bound, method, explanation, reason } = answer;
  const first = {
    items: asked.items,
    room: asked.room,
    loads,
    steps: answer.step_count ?? answer.steps.length,
    lower_bound,
    lower_bound_reason: reason,
    method,
    explanation,
  };
  return [first, ...answer.steps].map((line) => JSON.stringify(line)).join('\n') + '\n';
}
