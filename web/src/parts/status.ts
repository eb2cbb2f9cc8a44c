// What is known of a cell, in a word and in numbers.
import type { TableCell } from '../lib/api';
import { h } from '../lib/dom';
import { terms } from '../lib/terms';

const meanings: Record<string, string> = {
  minimum: 'No design with these parameters has fewer blocks: the number of blocks is a proved lower bound.',
  'best-known': 'The best design known; one with fewer blocks may exist.',
  impossible: 'There is no design with these parameters.',
  open: 'No design is known, and none is excluded.',
};

export const statuses: readonly (readonly [string, string])[] = [
  ['', 'any'],
  ['minimum', 'minimum'],
  ['best-known', 'best known'],
  ['open', 'open'],
  ['impossible', 'impossible'],
];

export function badge(status: string): HTMLElement {
  return h('span', { class: `badge ${status.replace(/[^a-z]/g, '-')}`, title: meanings[status] ?? null }, status.replace('-', ' '));
}

/** Blocks over the lower bound; null if either is not known. */
export function gap(cell: Pick<TableCell, 'b' | 'lower_bound'>): number | null {
  return cell.b === null || cell.lower_bound === null ? null : cell.b - cell.lower_bound;
}

/** The terms that a newcomer meets first, to be opened. */
export function glossary(): HTMLElement {
  const list: [string, string][] = [
    ['change covering design', 'a list of blocks, each k of v elements, in which every two elements are together in some block and consecutive blocks differ in exactly m elements'],
    ['kind', terms.kind],
    ['introduced', terms.introduced],
    ['leaving', terms.leaving],
    ['unchanged', terms.unchanged],
    ['covered', terms.covered],
    ['lower bound', terms.bound],
    ['minimum', terms.minimum],
    ['best known', 'one with fewer blocks may exist, but nobody has found it'],
    ['tight', terms.tight],
    ['economical', terms.economical],
    ['excess', terms.excess],
  ];
  return h(
    'details',
    { class: 'glossary' },
    h('summary', {}, 'What the words mean'),
    h('dl', { class: 'facts' }, list.map(([term, meaning]) => [h('dt', {}, h('dfn', {}, term)), h('dd', {}, meaning)]).flat()),
  );
}
