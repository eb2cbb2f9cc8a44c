// What is known of a cell, in a word and in numbers.
import type { TableCell } from '../lib/api';
import { h } from '../lib/dom';

const meanings: Record<string, string> = {
  minimum: 'No design with these parameters has fewer blocks: the number of blocks is a proved lower bound.',
  'best-known': 'The best design known; one with fewer blocks may exist.',
  impossible: 'There is no design with these parameters.',
  unknown: 'No design is known, and none is excluded.',
};

export const statuses: readonly (readonly [string, string])[] = [
  ['', 'any'],
  ['minimum', 'minimum'],
  ['best-known', 'best known'],
  ['unknown', 'unknown'],
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
  const terms: [string, string][] = [
    ['change covering design', 'A list of blocks, each k of v elements, in which every two elements are together in some block and consecutive blocks differ in exactly m elements.'],
    ['circular, linear', 'In a circular design the first block follows the last one as any block follows the one before; in a linear one it need not.'],
    ['introduced, leaving, unchanged', 'In a step from one block to the next, m elements leave, m are introduced, and k − m stay unchanged.'],
    ['minimum', meanings['minimum']!],
    ['best known', meanings['best-known']!],
    ['lower bound', 'A number of blocks that no design can be below, with a proof.'],
    ['tight', 'Every pair is newly covered exactly once.'],
    ['economical', 'The number of blocks is the counting bound: pairs to cover, divided by the pairs that a step newly covers, rounded up.'],
    ['excess', 'Newly covered pairs, counted with repetition, less the number of pairs.'],
  ];
  return h(
    'details',
    { class: 'glossary' },
    h('summary', {}, 'What the words mean'),
    h('dl', { class: 'facts' }, terms.map(([term, meaning]) => [h('dt', {}, h('dfn', {}, term)), h('dd', {}, meaning)]).flat()),
  );
}
