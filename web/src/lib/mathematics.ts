// Mathematics in the pages: what lib/formula.ts finds, set as MathML by Temml. Until that is there
// (it is fetched when it is first needed) formulas stand as they are written.
import { h, type Child } from './dom';
import { partsOf, pieces } from './formula';

type Setter = (tex: string, place: HTMLElement, display: boolean) => void;

let setter: Setter | null = null;
let asked = false;
/** Formulas that are to be set, and whether that is under way. */
let waiting: [HTMLElement, string, boolean][] = [];
let setting = false;
/** Whether some came, or the page moved, since they were put in order. */
let unordered = false;
/** So long, in milliseconds, formulas are set before the page may draw and listen again. */
const slice = 16;
/** More formulas than that are set in the order in which they are seen. */
const few = 30;

async function ask(): Promise<void> {
  const temml = await import('temml');
  setter = (tex, place, display) => {
    const before = [...place.childNodes];
    try {
      temml.default.render(display ? `\\displaystyle ${tex}` : tex, place, { throwOnError: true });
    } catch {
      place.replaceChildren(...before);
    }
    place.classList.remove('plain');
  };
}

function inSight([place]: [HTMLElement, string, boolean]): boolean {
  // Where something is that the browser leaves out would have it laid out.
  if (!place.checkVisibility({ contentVisibilityAuto: true })) {
    return false;
  }
  const { top, bottom } = place.getBoundingClientRect();
  return bottom >= 0 && top <= window.innerHeight;
}

/** Sets some formulas, those in sight first; a page of hundreds does not stand still for them. */
function work(): void {
  const deadline = performance.now() + slice;
  if (unordered && waiting.length > few) {
    const seen = waiting.map(inSight);
    waiting = [...waiting.filter((_, i) => seen[i]), ...waiting.filter((_, i) => !seen[i])];
  }
  unordered = false;
  let done = 0;
  do {
    const next = waiting[done++];
    next && setter!(next[1], next[0], next[2]);
  } while (done < waiting.length && performance.now() < deadline);
  waiting = waiting.slice(done);
  setting = waiting.length > 0;
  setting && setTimeout(work, 0);
}

// What is read now comes first, and paper has all.
window.addEventListener('scroll', () => (unordered = true), { capture: true, passive: true });
window.addEventListener('beforeprint', () => {
  waiting.splice(0).forEach(([place, tex, display]) => setter?.(tex, place, display));
});

/** A formula as it is written, until it is set: `x_{p}` with its index. */
function written(plain: string): Child[] {
  return plain.split(/([_^](?:\{[^{}]*\}|\w))/).map((piece, i) => {
    if (i % 2 === 0) {
      return piece;
    }
    const index = piece.slice(1).replace(/^\{|\}$/g, '');
    return h(piece.startsWith('_') ? 'sub' : 'sup', {}, index);
  });
}

function set(place: HTMLElement, tex: string, display: boolean): HTMLElement {
  waiting.push([place, tex, display]);
  unordered = true;
  if (setter && !setting) {
    setting = true;
    queueMicrotask(work); // Before the page is drawn, if there are few.
  } else if (!asked) {
    asked = true;
    setting = true;
    // Without it formulas stay as they are written.
    ask().then(work, () => undefined);
  }
  return place;
}

/** A text with its formulas set. */
export function mathText(text: string): Child[] {
  return pieces(text).flatMap((piece): Child[] =>
    'tex' in piece
      ? [
          set(h('span', { class: 'math plain' }, written(piece.text)), piece.tex, false),
          ...(piece.breaks ? [h('wbr')] : []),
        ]
      : [piece.text],
  );
}

/** One formula, in TeX. */
export function formula(tex: string, plain: string): HTMLElement {
  return set(h('span', { class: 'math plain' }, written(plain)), tex, false);
}

/**
 * Lines of a formula that stands alone. What is said of a line (`*if …*`) is a separate column;
 * where there is little room it stands below, and lines end between parts.
 */
export function displayed(lines: readonly string[]): HTMLElement {
  const parts = (text: string): Child[] =>
    partsOf(text.trim()).flatMap((group) => [
      h(
        'span',
        {},
        group.flatMap((part) => [
          set(h('span', { class: 'math plain' }, written(part.text)), part.tex, true),
          h('wbr'),
        ]),
      ),
      h('wbr'),
    ]);
  return h(
    'div',
    { class: 'displayed' },
    lines.flatMap((each): Child[] => {
      const [left, condition] = each.split('*', 2);
      return [
        h('div', { class: condition === undefined ? 'whole' : null }, parts(left!)),
        condition !== undefined && h('div', { class: 'condition' }, parts(condition)),
      ];
    }),
  );
}
