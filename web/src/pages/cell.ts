// One cell: what is known of its parameters, why, from whom, and since when.
import type { Cell, CellDetail } from '../lib/api';
import { fill, h, scroll, type Child } from '../lib/dom';
import { cellDetail, designOf, explain } from '../lib/source';
import { waiting } from '../lib/wait';
import { changeWord, count, nameOf, number, ratio } from '../lib/words';
import { copyButton } from '../parts/copy';
import { downloads } from '../parts/downloads';
import { busyKey, cellOf } from '../parts/fields';
import { reason, recipeTree } from '../parts/recipe';
import { badge, glossary } from '../parts/status';
import { isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { designsTable, historyList } from './cell/designs';

function at(cell: Cell, changes: Partial<Cell> = {}): string {
  return link('cell', { ...cell, ...changes });
}

/** The cells beside this one. Arrow keys go there, too. */
function neighbours(cell: Cell): HTMLElement {
  const step = (words: string, changes: Partial<Cell>, key?: string): HTMLElement => h('li', {}, h('a', { href: at(cell, changes), 'aria-keyshortcuts': key ?? null }, words));
  return h(
    'nav',
    { class: 'neighbours', 'aria-label': 'Neighbouring cells' },
    h(
      'ul',
      {},
      cell.v > 2 && step(`← v = ${cell.v - 1}`, { v: cell.v - 1 }, 'ArrowLeft'),
      step(`v = ${cell.v + 1} →`, { v: cell.v + 1 }, 'ArrowRight'),
      cell.k > 2 && step(`↑ k = ${cell.k - 1}`, { k: cell.k - 1 }, 'ArrowUp'),
      step(`↓ k = ${cell.k + 1}`, { k: cell.k + 1 }, 'ArrowDown'),
      step(cell.kind === 'circular' ? 'linear' : 'circular', { kind: cell.kind === 'circular' ? 'linear' : 'circular' }),
      [1, 2, 3].filter((m) => m !== cell.change).map((m) => step(changeWord(m), { change: m })),
      h('li', {}, h('a', { href: link('catalog', { change: cell.change, kind: cell.kind, at: `${cell.v}.${cell.k}` }) }, 'in the heat map')),
    ),
  );
}

function walk(view: View, cell: Cell): void {
  const moves: Record<string, Partial<Cell>> = { ArrowLeft: { v: cell.v - 1 }, ArrowRight: { v: cell.v + 1 }, ArrowUp: { k: cell.k - 1 }, ArrowDown: { k: cell.k + 1 } };
  document.addEventListener(
    'keydown',
    (event) => {
      const move = moves[event.key];
      if (move && !busyKey(event) && !event.shiftKey && (move.v ?? 2) >= 2 && (move.k ?? 2) >= 2) {
        event.preventDefault();
        window.location.hash = at(cell, move);
      }
    },
    { signal: view.signal },
  );
}

/** The name of the bound that the best design attains, in words. */
function argument(detail: CellDetail): string {
  const best = detail.best;
  if (!best || best.status !== 'minimum') {
    return '';
  }
  return `its ${count(best.b, 'block')} are the lower bound “${detail.bounds[0]!.name}”: ${detail.reason}`;
}

/** What a publication reports and nobody here can verify. */
function reported(detail: CellDetail): Child[] {
  return detail.reported ? [`${number(detail.reported.blocks)} reported [${detail.reported.cites}], blocks not held here.`] : [];
}

function summary(cell: Cell, detail: CellDetail, frozen: boolean): HTMLElement {
  if (detail.impossible) {
    return h('p', { class: 'note' }, h('strong', {}, 'There is none: '), reason(detail.impossible), '.');
  }
  const best = detail.best;
  if (!best) {
    return h('p', { class: 'note' }, 'No design with these parameters is known. ', !frozen && [h('a', { href: link('search', { ...cell }) }, 'Search for one'), '.'], ' ', reported(detail));
  }
  const over = detail.lower_bound === null ? 0 : best.b - detail.lower_bound;
  const why = argument(detail);
  return h(
    'div',
    { class: 'known' },
    h('p', { class: 'figure' }, h('strong', {}, number(best.b)), h('span', {}, ` ${best.b === 1 ? 'block' : 'blocks'} `, badge(best.status))),
    h(
      'div',
      {},
      over > 0 && h('p', {}, `${count(over, 'block')} over the lower bound ${number(detail.lower_bound!)} (b / bound ${ratio(best.b, detail.lower_bound!)}). A design with fewer blocks may exist.`),
      detail.reported && h('p', {}, reported(detail)),
      why && h('p', {}, 'Minimum: ', reason(why), '.'),
      h('p', {}, 'Made by ', h('a', { href: link('theorems', { construction: best.construction }) }, best.construction), best.label && [', catalog label ', h('a', { class: 'code', href: link('design', { label: best.label }) }, best.label)], '.'),
      h(
        'p',
        { class: 'buttons' },
        h('a', { class: 'button', href: link('design', { ...cell }) }, 'Open the design'),
        ' ',
        !frozen && best.status !== 'minimum' && h('a', { class: 'button plain', href: link('search', { ...cell }) }, 'Search for a better one'),
      ),
    ),
  );
}

function bounds(detail: CellDetail): Child[] {
  return [
    h('h2', {}, 'Lower bounds'),
    detail.bounds.length === 0
      ? h('p', {}, detail.reason ? reason(detail.reason) : 'None is known.')
      : scroll('Lower bounds',
          h(
            'table',
            { class: 'bounds' },
            h('thead', {}, h('tr', {}, h('th', { scope: 'col', class: 'number' }, 'blocks'), h('th', { scope: 'col' }, 'bound'), h('th', { scope: 'col' }, 'reason'))),
            h('tbody', {}, detail.bounds.map((bound) => h('tr', {}, h('td', { class: 'number' }, number(bound.blocks)), h('td', {}, bound.name), h('td', { class: 'reason' }, reason(bound.reason))))),
          ),
        ),
  ];
}

function offers(detail: CellDetail): Child[] {
  const others = detail.offers.filter((offer) => offer.construction !== detail.best?.construction || offer.b !== detail.best.b);
  return others.length === 0
    ? []
    : [
        h('h2', {}, 'Other constructions'),
        scroll('Other constructions',
          h(
            'table',
            {},
            h('thead', {}, h('tr', {}, h('th', { scope: 'col', class: 'number' }, 'blocks'), h('th', { scope: 'col' }, 'construction'))),
            h('tbody', {}, others.map((offer) => h('tr', {}, h('td', { class: 'number' }, number(offer.b)), h('td', {}, h('a', { href: link('theorems', { construction: offer.construction }) }, offer.construction))))),
          ),
        ),
      ];
}

export const cell: Page = {
  path: 'cell',
  title: 'Cell',
  hidden: true,
  async render(view: View) {
    const wanted = cellOf(view.params);
    if (!wanted) {
      fill(view.root, h('h1', {}, 'Which cell?'), h('p', {}, 'A cell has v elements and blocks of k: choose one in the ', h('a', { href: link('catalog') }, 'catalog'), ', or write it into the address, as #/cell?v=20&k=5&change=2&kind=circular.'));
      return;
    }
    const name = nameOf(wanted);
    document.title = `(${wanted.v},${wanted.k}) ${wanted.kind} m = ${wanted.change} · Changeover`;
    const head = h('h1', {}, name[0]!.toUpperCase() + name.slice(1), (wanted.strength ?? 2) > 2 ? `, strength ${wanted.strength}` : '');
    const body = h('div', { class: 'cell-body' });
    const begin = (): void => fill(view.root, head, neighbours(wanted), body);
    walk(view, wanted);
    const frozen = isCopy();
    let detail: CellDetail;
    try {
      detail = await waiting(cellDetail(wanted, view.signal), view.signal, () => {
        begin();
        fill(body, h('p', { class: 'hint' }, 'Asking what is known…'));
      });
    } catch (fault) {
      fill(body);
      begin();
      throw fault;
    }
    const recipe = h('div', { class: 'recipe-place' }, h('p', { class: 'hint' }, 'Asking…'));
    begin();
    const files = h('div', {}, !frozen && downloads(wanted, null, false));
    fill(
      body,
      summary(wanted, detail, frozen),
      glossary(),
      bounds(detail),
      detail.best && [h('h2', {}, 'How it is made'), recipe],
      designsTable(detail, view.signal),
      offers(detail),
      historyList(detail),
      detail.best && [h('h2', {}, 'Download the best design'), files],
      !frozen && h('p', { class: 'hint' }, 'On the command line: ', h('code', {}, command(wanted)), ' ', copyButton('Copy', () => command(wanted))),
    );
    if (!detail.best) {
      return;
    }
    const tasks: Promise<void>[] = [
      explain(wanted, view.signal).then((found) => fill(recipe, found ? recipeTree(found.tree) : h('p', {}, 'Nothing is known of how it was made.'))),
    ];
    if (frozen) {
      tasks.push(designOf(wanted, view.signal).then((design) => fill(files, downloads(wanted, design, true))));
    }
    for (const each of await Promise.allSettled(tasks)) {
      if (each.status === 'rejected' && !view.signal.aborted) {
        fill(recipe, problem(each.reason));
      }
    }
  },
};

function command(cell: Cell): string {
  return `changeover explain ${cell.v} ${cell.k} --change ${cell.change} --${cell.kind}${(cell.strength ?? 2) > 2 ? ` --strength ${cell.strength}` : ''}`;
}
