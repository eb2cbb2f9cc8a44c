// The verdict on a cell: how few blocks are known, and whether fewer can be.
import type { Cell, CellDetail } from '../../lib/api';
import { counted } from '../../lib/atlas';
import { work } from '../../lib/citations';
import { h, type Child } from '../../lib/dom';
import { count, number, ratio } from '../../lib/words';
import { cellArguments, command } from '../../parts/command';
import { dossierLink } from '../../parts/dossier';
import { ladder } from '../../parts/ladder';
import { lead } from '../../parts/lead';
import { reason } from '../../parts/recipe';
import { badge } from '../../parts/status';
import { link } from '../../shell/router';
import { madeBy } from './designs';

/** What a publication reports and the catalog cannot verify. */
function reported(detail: CellDetail): Child[] {
  return detail.reported
    ? [
        `A design with ${count(detail.reported.blocks, 'block')} is reported by `,
        work(detail.reported.cites),
        '; the blocks are not held here, so this is not verified.',
      ]
    : [];
}

export function summary(
  cell: Cell,
  detail: CellDetail,
  frozen: boolean,
  figure: HTMLElement,
): HTMLElement {
  if (detail.impossible) {
    return h(
      'p',
      { class: 'note' },
      h('strong', {}, 'There is none: '),
      reason(detail.impossible),
      '.',
    );
  }
  const best = detail.best;
  if (!best) {
    return h(
      'div',
      { class: 'known' },
      h(
        'div',
        { class: 'known-words' },
        ladder(detail.lower_bound, null),
        h('p', {}, 'No design with these parameters is known. ', reported(detail)),
        !frozen &&
          h(
            'p',
            { class: 'buttons' },
            h('a', { class: 'button', href: link('search', { ...cell }) }, 'Search for one'),
          ),
      ),
    );
  }
  const over = detail.lower_bound === null ? 0 : best.b - detail.lower_bound;
  const strongest = detail.bounds[0];
  const { tight } = counted({ ...cell, strength: cell.strength ?? 2, b: best.b });
  return h(
    'div',
    { class: 'known' },
    h(
      'p',
      { class: 'figure' },
      h('strong', {}, number(best.b)),
      h(
        'span',
        {},
        ` ${best.b === 1 ? 'block' : 'blocks'} `,
        badge(best.status),
        tight && [' ', h('span', { class: 'badge good' }, 'tight')],
      ),
    ),
    h(
      'div',
      { class: 'known-words' },
      ladder(detail.lower_bound, best.b),
      over > 0 &&
        h(
          'p',
          {},
          `${count(over, 'block')} over the lower bound ${number(detail.lower_bound!)} (b / ` +
            `bound ${ratio(best.b, detail.lower_bound!)}). A design with fewer blocks may exist.`,
        ),
      detail.reported && h('p', {}, reported(detail)),
      best.status === 'minimum' &&
        h(
          'p',
          {},
          h('strong', {}, 'No design has fewer blocks'),
          strongest
            ? [
                ': ',
                h(
                  'a',
                  {
                    href: link('cell', { ...cell }),
                    onclick: (event) => {
                      event.preventDefault();
                      const target = document.getElementById('lower-bounds');
                      target && lead(target, target, 'start');
                    },
                  },
                  /bound|proofs/.test(strongest.name)
                    ? `${strongest.name} ↓`
                    : `${strongest.name} bound ↓`,
                ),
              ]
            : detail.reason && [': ', ...reason(detail.reason)],
          '.',
        ),
      h(
        'p',
        {},
        madeBy(best.construction),
        best.label && [
          ', label ',
          h('a', { class: 'code', href: link('design', { label: best.label }) }, best.label),
        ],
        '.',
      ),
      h(
        'p',
        { class: 'buttons' },
        openDesign(cell, best.b),
        ' ',
        !frozen && dossierLink(cell, 'html', 'Write-up for a paper', true),
        ' ',
        !frozen &&
          best.status !== 'minimum' &&
          h(
            'a',
            { class: 'button plain', href: link('search', { ...cell }) },
            'Search for a better one',
          ),
      ),
    ),
    figure,
  );
}

/** The program shows designs of so many blocks, or elements in all blocks together. */
const mostShown = { blocks: 200_000, elements: 25_000_000 };

export const isTooLong = (cell: Cell, b: number): boolean =>
  b > mostShown.blocks || b * cell.k > mostShown.elements;

function openDesign(cell: Cell, b: number): HTMLElement {
  return isTooLong(cell, b)
    ? h(
        'span',
        { class: 'hint' },
        `${number(b)} blocks are too many for a page. This writes them: `,
        command(`changeover design ${cellArguments(cell)} --format text -o FILE`),
      )
    : h('a', { class: 'button', href: link('design', { ...cell }) }, 'Open the design');
}
