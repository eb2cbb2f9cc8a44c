// What is known of a cell, in a word and in numbers.
import { h } from '../lib/dom';

const meanings: Record<string, string> = {
  minimum:
    'No design with these parameters has fewer blocks: the number of blocks is a proved lower ' +
    'bound.',
  'best-known': 'The best design known; one with fewer blocks may exist.',
  impossible: 'There is no design with these parameters.',
  open: 'No design is known, and none is excluded.',
};

export const statuses: readonly (readonly [string, string])[] = [
  ['', 'any'],
  ['known', 'with a design'],
  ['minimum', 'minimum'],
  ['best-known', 'best known'],
  ['open', 'open'],
  ['impossible', 'impossible'],
];

export function badge(status: string): HTMLElement {
  return h(
    'span',
    { class: `badge ${status.replace(/[^a-z]/g, '-')}`, title: meanings[status] ?? null },
    status.replace('-', ' '),
  );
}
