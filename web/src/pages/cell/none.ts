// What is said of cells for which there is nothing to show.
import type { Cell } from '../../lib/api';
import { h } from '../../lib/dom';
import { rangeWords } from '../../lib/words';
import { reason } from '../../parts/recipe';
import { about } from '../../shell/about';
import { link } from '../../shell/router';
import { at } from './address';

/** Why blocks with more elements than there are cannot be, as of other cells without designs. */
export function tooLarge({ v, k }: Cell): HTMLElement {
  return h(
    'p',
    { class: 'note' },
    h('strong', {}, 'There is none: '),
    reason(`a block is a subset of the v elements, so v >= k = ${k}, and v is ${v}`),
    '.',
  );
}

/** Where v and k were likely exchanged. */
export function exchanged(cell: Cell): HTMLElement | false {
  return (
    cell.k > cell.v &&
    cell.v >= 2 &&
    h(
      'p',
      {},
      'If v and k were exchanged: ',
      h('a', { href: at(cell, { v: cell.k, k: cell.v }) }, `v = ${cell.k}, k = ${cell.v}`),
      '.',
    )
  );
}

/** What a static copy says of a cell that it does not have, and the way to those that it has. */
export async function beyondTheCopy(cell: Cell): Promise<HTMLElement> {
  const { range } = await about();
  const { change, kind } = cell;
  const there = range?.changes.includes(change) ? { change, kind } : {};
  const lacks = range && !range.changes.includes(change);
  const changes = range?.changes.join(' and ') ?? '';
  return h(
    'p',
    { class: 'note', role: 'status' },
    'This static copy does not have it',
    range &&
      `: it has designs with ${lacks ? `m\u00a0=\u00a0${changes}, ` : ''}${rangeWords(range)}` +
        `${lacks ? `, and none with m\u00a0=\u00a0${change}` : ''}`,
    '. See those ',
    h('a', { href: link('catalog', there) }, 'on the map'),
    '; ',
    h('code', {}, 'changeover serve'),
    ' on a machine of your own shows every cell and design.',
  );
}
