// Mathematics in the pages: what lib/formula.ts finds, set as MathML by Temml. Until that is there (it is fetched when it is first
// needed) formulas stand as they are written.
import { h, type Child } from './dom';
import { pieces, texOf } from './formula';

type Setter = (tex: string, place: HTMLElement, display: boolean) => void;

let setter: Setter | null = null;
let asked = false;
/** Formulas that wait for the setter. */
let waiting: [HTMLElement, string, boolean][] = [];

async function ask(): Promise<void> {
  const temml = await import('temml');
  setter = (tex, place, displayMode) => {
    const before = place.textContent ?? '';
    try {
      temml.default.render(tex, place, { displayMode, throwOnError: true });
    } catch {
      place.textContent = before;
    }
    place.classList.remove('plain');
  };
  for (const [place, tex, display] of waiting) {
    setter(tex, place, display);
  }
  waiting = [];
}

function set(place: HTMLElement, tex: string, display: boolean): HTMLElement {
  if (setter) {
    setter(tex, place, display);
    return place;
  }
  waiting.push([place, tex, display]);
  if (!asked) {
    asked = true;
    // Without it formulas stay as they are written.
    ask().catch(() => undefined);
  }
  return place;
}

/** A text with its formulas set. */
export function mathText(text: string): Child[] {
  return pieces(text).flatMap((piece): Child[] => ('tex' in piece ? [set(h('span', { class: 'math plain' }, piece.text), piece.tex, false), ...(piece.breaks ? [h('wbr')] : [])] : [piece.text]));
}

/** One formula, in TeX. */
export function formula(tex: string, plain: string): HTMLElement {
  return set(h('span', { class: 'math plain' }, plain), tex, false);
}

/** Lines of a formula that stands alone. What is said of a line (`*if …*`) is a column of its own. */
export function displayed(lines: readonly string[]): HTMLElement {
  const place = h('div', { class: 'math plain display' }, lines.join('\n'));
  const rows = lines.map((line) => {
    const [left, condition] = line.includes('*') ? line.split('*', 2) : [line, undefined];
    return condition === undefined ? texOf(left!.trim()) : `${texOf(left!.trim())} & ${texOf(condition.trim())}`;
  });
  return set(place, rows.length === 1 && !rows[0]!.includes(' & ') ? rows[0]! : `\\begin{array}{ll}${rows.join(' \\\\ ')}\\end{array}`, true);
}
