// The designs of a cell: who made them, when and how, what they are from, how to cite them. The
// first is the best; the others are its history.
import type { CatalogEntry, CellDetail } from '../../lib/api';
import { work } from '../../lib/citations';
import { fill, h, type Child } from '../../lib/dom';
import { cite } from '../../lib/source';
import { count } from '../../lib/words';
import { copyButton } from '../../parts/copy';
import { reason } from '../../parts/recipe';
import { badge } from '../../parts/status';
import { link, problem } from '../../shell/router';

/** Where the blocks of a design that no construction made are from. */
const sources: Readonly<Record<string, readonly [before: string, linked: string, after: string]>> =
  {
    found: ['', 'Found', ' and written down'],
    literal: ['', 'Found', ' and written down'],
    developed: ['', 'Found', ' by a search for base blocks'],
    printed: ['', 'Printed', ' in a publication'],
  };

export function madeBy(construction: string): Child[] {
  const [before, linked, after] = sources[construction] ?? ['Made by ', construction, ''];
  const of = construction === 'literal' ? 'found' : construction;
  return [before, h('a', { href: link('theorems', { construction: of }) }, linked), after];
}

/** A button that shows BibTeX, and where it shows it. */
export function citation(label: string | null, signal: AbortSignal): [HTMLElement, HTMLElement] {
  const shown = h('div', { class: 'bibtex', role: 'status' });
  const button = h(
    'button',
    {
      type: 'button',
      class: 'plain small',
      'aria-label': `Cite ${label ?? 'the catalog'}`,
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
      const text = await cite(label, signal);
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
  return [button, shown];
}

/** `best`: it has as few blocks as any that is known; `shown`: it is the one that the page shows. */
function origin(
  entry: CatalogEntry,
  best: boolean,
  shownHere: boolean,
  signal: AbortSignal,
): HTMLElement {
  const { who, date, program, command } = entry.credit;
  const printed = entry.construction === 'printed';
  const [button, shown] = citation(entry.label, signal);
  return h(
    'li',
    { class: shownHere ? 'origin best' : 'origin' },
    h(
      'p',
      { class: 'origin-head' },
      h('time', { datetime: date || null }, date || 'no date'),
      h('strong', {}, count(entry.b, 'block')),
      h('a', { class: 'code', href: link('design', { label: entry.label }) }, entry.label),
      (best || entry.retracted) && badge(entry.status),
      shownHere && h('span', { class: 'hint' }, 'shown here'),
      button,
    ),
    h(
      'p',
      {},
      madeBy(entry.construction),
      // Of a printed design the works are the source, and who put it down only entered it.
      who && !printed && ` · ${who}`,
      program && !printed && ` · ${program}`,
      entry.cites.length > 0 &&
        [
          printed ? ': ' : ' · from ',
          entry.cites.map((key, i) => [i > 0 ? ', ' : '', work(key)]).flat(),
        ].flat(),
      printed && who && ` · Entered by ${who}${program && ` with ${program}`}`,
    ),
    command && h('p', {}, h('code', {}, command)),
    entry.note && h('p', { class: 'hint' }, reason(entry.note)),
    entry.retracted && h('p', { class: 'hint' }, `Retracted: ${entry.retracted}`),
    shown,
  );
}

/** More than these are folded. */
const mostAtOnce = 4;

export function origins(detail: CellDetail, signal: AbortSignal): Child[] {
  const { best, designs } = detail;
  if (designs.length === 0) {
    return best ? [h('h2', {}, 'History, credit and citation'), notKept(best, signal)] : [];
  }
  const list = (from: number, to: number): HTMLElement =>
    h(
      'ol',
      { class: 'origins', reversed: true },
      designs
        .slice(from, to)
        .map((entry) => origin(entry, entry.b === best?.b, entry.label === best?.label, signal)),
    );
  const first = designs.length > mostAtOnce + 1 ? mostAtOnce : designs.length;
  return [
    h('h2', {}, 'History, credit and citation'),
    list(0, first),
    first < designs.length &&
      h(
        'details',
        {},
        h('summary', {}, `${count(designs.length - first, 'more design')} of this cell`),
        list(first, designs.length),
      ),
  ];
}

/** A design that the catalog does not have: a construction makes it whenever it is asked for. */
function notKept({ construction }: { construction: string }, signal: AbortSignal): HTMLElement {
  const [button, shown] = citation(null, signal);
  return h(
    'div',
    {},
    h(
      'p',
      {},
      'The catalog does not hold this design, so it has no label and no date: ',
      h('a', { href: link('theorems', { construction }) }, construction),
      ' makes the same blocks whenever they are asked for. Cite the works that “How it is made” ' +
        'names, and the program with its catalog. ',
      button,
    ),
    shown,
  );
}
