// Which numbers (of blocks, of loads) are impossible, open and reached: the lower bound, the best
// that is known and what lies between them, side by side.
import { h } from '../lib/dom';
import { number } from '../lib/words';

const span = (from: number, to: number): string =>
  from === to ? number(from) : `${number(from)}–${number(to)}`;

/**
 * Null: not known. `start`: the best before a search; `reached`: what the best is; `given`: under
 * which condition the others are impossible. `beside`: what stands after them, and its words.
 */
export function ladder(
  bound: number | null,
  best: number | null,
  {
    start = best,
    of = 'blocks',
    reached = 'best known',
    given = '',
    beside = null as readonly [string, string] | null,
  } = {},
): HTMLElement {
  const least = bound ?? 1;
  const rungs: (readonly [string, string, string])[] = [];
  if (least > 1) {
    rungs.push(['none', least === 2 ? '1' : `up to ${number(least - 1)}`, `impossible${given}`]);
  }
  if (best === null) {
    rungs.push(['open', `${number(least)} or more`, 'open']);
  } else {
    if (best > least) {
      rungs.push(['open', span(least, best - 1), 'open']);
    }
    rungs.push(['best', number(best), bound === best ? 'the minimum' : reached]);
    if (start !== null && start > best) {
      rungs.push(['gained', span(best + 1, start), 'improved on']);
    }
  }
  return h(
    'ol',
    { class: 'ladder', 'aria-label': `Numbers of ${of}` },
    rungs.map(([state, blocks, words]) =>
      h('li', { class: state }, h('strong', {}, blocks), h('span', {}, words)),
    ),
    beside && h('li', { class: 'beside' }, h('strong', {}, beside[0]), h('span', {}, beside[1])),
  );
}
