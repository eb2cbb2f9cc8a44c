// The designs of a cell: who made them, when and how, what they are from, how to cite them. The
// first is the best; the others are its history.
import type { CatalogEntry, CellDetail } from '../../lib/api';
import { work } from '../../lib/citations';
import { fill, h, type Child } from '../../lib/dom';
import { cite } from '../../lib/source';
import { count } from '../../lib/words';
import { copyButton } from '../../parts/copy';
import { badge } from '../../parts/status';
import { link, problem } from '../../shell/router';

/** A design whose blocks are written down, and which no construction made, was found. */
export function madeBy(construction: string): Child[] {
  const found = construction === 'found' || construction === 'literal';
  return found
    ? [h('a', { href: link('theorems', { construction: 'found' }) }, 'Found'), ' and written down']
    : ['Made by ', h('a', { href: link('theorems', { construction }) }, construction)];
}

function origin(entry: CatalogEntry, best: boolean, signal: AbortSignal): HTMLElement {
  const { who, date, program, command } = entry.credit;
  const shown = h('div', { class: 'bibtex', role: 'status' });
  const button = h(
    'button',
    {
      type: 'button',
      class: 'plain small',
      'aria-label': `Cite ${entry.label}`,
      'aria-expanded': 'false',
      onclick: () => void show(),
    },
    'Cite',
  );
  async function show(): Promise<void> {
    if (shown.childElementCount > 0) {
      fill(shown);
      button.setAttribute('aria-expanded', 'false');
      return;
    }
    try {
      const text = await cite(entry.label, signal);
      fill(
        shown,
        h('pre', { tabindex: 0 }, text),
        copyButton('Copy', () => text),
      );
      button.setAttribute('aria-expanded', 'true');
    } catch (fault) {
      if (!signal.aborted) {
        fill(shown, problem(fault));
      }
    }
  }
  return h(
    'li',
    { class: best ? 'origin best' : 'origin' },
    h(
      'p',
      { class: 'origin-head' },
      h('time', { datetime: date || null }, date || 'no date'),
      h('strong', {}, count(entry.b, 'block')),
      h('a', { class: 'code', href: link('design', { label: entry.label }) }, entry.label),
      (best || entry.retracted) && badge(entry.status),
      button,
    ),
    h(
      'p',
      {},
      madeBy(entry.construction),
      who && ` · ${who}`,
      program && ` · ${program}`,
      entry.cites.length > 0 &&
        [' · from ', entry.cites.map((key, i) => [i > 0 ? ', ' : '', work(key)]).flat()].flat(),
    ),
    command && h('p', {}, h('code', {}, command)),
    entry.note && h('p', { class: 'hint' }, entry.note),
    entry.retracted && h('p', { class: 'hint' }, `Retracted: ${entry.retracted}`),
    shown,
  );
}

export function origins(detail: CellDetail, signal: AbortSignal): Child[] {
  if (detail.designs.length === 0) {
    return [];
  }
  return [
    h('h2', {}, 'History, credit and citation'),
    h(
      'ol',
      { class: 'origins', reversed: true },
      detail.designs.map((entry, i) => origin(entry, i === 0, signal)),
    ),
  ];
}
