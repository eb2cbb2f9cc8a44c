// The designs of a cell that have a label, with credit and how to cite them; and how the best one became better.
import type { CatalogEntry, CellDetail } from '../../lib/api';
import { fill, h, scroll, type Child } from '../../lib/dom';
import { cite } from '../../lib/source';
import { number } from '../../lib/words';
import { copyButton } from '../../parts/copy';
import { badge } from '../../parts/status';
import { link, problem } from '../../shell/router';

export function designsTable(detail: CellDetail, signal: AbortSignal): Child[] {
  if (detail.designs.length === 0) {
    return [];
  }
  const shown = h('div', { class: 'bibtex', role: 'status' });
  async function show(entry: CatalogEntry): Promise<void> {
    try {
      const text = await cite(entry.label, signal);
      fill(shown, h('h3', {}, 'BibTeX of ', h('span', { class: 'code' }, entry.label), ' ', copyButton('Copy', () => text)), h('pre', { tabindex: 0 }, text));
    } catch (fault) {
      if (!signal.aborted) {
        fill(shown, problem(fault));
      }
    }
  }
  return [
    h('h2', {}, 'In the catalog'),
    scroll('Designs in the catalog',
      h(
        'table',
        {},
        h('thead', {}, h('tr', {}, ['blocks', 'label', 'status', 'credit', 'cites', 'citation'].map((title, i) => h('th', { scope: 'col', class: i === 0 ? 'number' : null }, title)))),
        h(
          'tbody',
          {},
          detail.designs.map((entry) => {
            const { who, date, program, command } = entry.credit;
            return h(
              'tr',
              {},
              h('td', { class: 'number' }, number(entry.b)),
              h('td', {}, h('a', { class: 'code', href: link('design', { label: entry.label }) }, entry.label)),
              h('td', {}, badge(entry.status), entry.retracted && h('div', { class: 'hint' }, entry.retracted)),
              h('td', { class: 'reason' }, [who, date, program].filter(Boolean).join(', '), command && h('div', {}, h('code', {}, command))),
              h('td', {}, entry.cites.join(', ') || '–'),
              h('td', {}, h('button', { type: 'button', class: 'plain small', 'aria-label': `BibTeX of ${entry.label}`, onclick: () => void show(entry) }, 'BibTeX')),
            );
          }),
        ),
      ),
    ),
    shown,
  ];
}

export function historyList(detail: CellDetail): Child[] {
  return detail.history.length === 0
    ? []
    : [
        h('h2', {}, 'History'),
        h(
          'ol',
          { class: 'history' },
          detail.history.map((each) =>
            h('li', {}, h('time', { datetime: each.date }, each.date || 'no date'), ': ', h('a', { href: link('design', { label: each.label }) }, `${number(each.b)} blocks`), each.credit && ` by ${each.credit}`, each.how && h('div', { class: 'hint' }, each.how)),
          ),
        ),
      ];
}
