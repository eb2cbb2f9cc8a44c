// What is seen of the catalog, to take along: CSV, JSON and LaTeX.
import type { AtlasCell, Selection } from '../../lib/atlas';
import { h } from '../../lib/dom';
import { save } from '../../lib/save';
import { changeWord } from '../../lib/words';

export function asCsv(cells: readonly AtlasCell[]): string {
  const lines = cells.map((cell) =>
    [
      cell.v,
      cell.k,
      cell.change,
      cell.kind,
      cell.strength,
      cell.b ?? '',
      cell.lower ?? '',
      cell.status,
      cell.tight,
      cell.economical,
      cell.order ?? '',
      cell.construction ?? '',
      cell.label ?? '',
    ].join(','),
  );
  const head =
    'v,k,change,kind,strength,b,lower_bound,status,tight,economical,group_order,construction,label';
  return `${[head, ...lines].join('\n')}\n`;
}

export function asJson(cells: readonly AtlasCell[]): string {
  const list = cells.map(
    ({
      v,
      k,
      change,
      kind,
      strength,
      b,
      lower,
      status,
      tight,
      economical,
      order,
      construction,
      label,
    }) =>
      JSON.stringify({
        v,
        k,
        change,
        kind,
        strength,
        b,
        lower_bound: lower,
        status,
        tight,
        economical,
        ...(order === null ? {} : { group_order: order }),
        construction,
        label,
      }),
  );
  return `[\n${list.join(',\n')}\n]\n`;
}

/** More columns than this do not fit on a page. */
const mostColumns = 14;

/**
 * Tables with a row for each v and a column for each k, as many as it takes; proved minima are
 * bold, others have their bound below.
 */
export function asLatex(cells: readonly AtlasCell[], selection: Selection): string {
  const ks = [...new Set(cells.map((cell) => cell.k))].sort((a, b) => a - b);
  const vs = [...new Set(cells.map((cell) => cell.v))].sort((a, b) => a - b);
  const at = new Map(cells.map((cell) => [`${cell.v}.${cell.k}`, cell]));
  const entry = (cell: AtlasCell | undefined): string =>
    !cell || cell.status === 'impossible'
      ? ''
      : cell.b === null
        ? `$\\ge${cell.lower}$`
        : cell.gap === 0
          ? `$\\mathbf{${cell.b}}$`
          : `$${cell.b}_{${cell.lower}}$`;
  const name =
    `${selection.kind} ${changeWord(selection.change)} covering ` +
    `designs${selection.strength > 2 ? ` of strength ${selection.strength}` : ''}`;
  let text = '% Needs \\usepackage{booktabs,longtable}\n';
  for (let from = 0; from < ks.length; from += mostColumns) {
    const some = ks.slice(from, from + mostColumns);
    text += `\\begin{longtable}{r${'r'.repeat(some.length)}}\n`;
    text +=
      `\\caption{Numbers of blocks of the best known ${name}; bold: proved minimum, ` +
      `otherwise with the lower bound as index.}\\\\\n`;
    text +=
      `\\toprule\n$v$ & ${some.map((k) => `$k=${k}$`).join(' & ')} ` +
      `\\\\\n\\midrule\n\\endhead\n`;
    for (const v of vs) {
      const row = some.map((k) => entry(at.get(`${v}.${k}`)));
      if (row.some((each) => each !== '')) {
        text += `${v} & ${row.join(' & ')} \\\\\n`;
      }
    }
    text += '\\bottomrule\n\\end{longtable}\n';
  }
  return text;
}

export function takeAlong(
  cells: () => readonly AtlasCell[],
  selection: () => Selection,
): HTMLElement {
  const name = (ending: string): string => {
    const { change, kind, strength } = selection();
    return `cells-m${change}-${kind}${strength > 2 ? `-t${strength}` : ''}.${ending}`;
  };
  const button = (words: string, act: () => void): HTMLElement =>
    h('button', { type: 'button', class: 'plain small', onclick: act }, words);
  return h(
    'div',
    { class: 'take', role: 'group', 'aria-label': 'Download the cells that are listed' },
    h('span', { class: 'hint' }, 'Download:'),
    button('CSV', () => save(name('csv'), asCsv(cells()), 'text/csv')),
    button('LaTeX', () => save(name('tex'), asLatex(cells(), selection()), 'application/x-tex')),
    button('JSON', () => save(name('json'), asJson(cells()), 'application/json')),
  );
}
