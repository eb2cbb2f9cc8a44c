// Mathematics in the pages: what lib/formula.ts finds, set as MathML by Temml. Until that is there
// (it is fetched when it is first needed) formulas stand as they are written.
import { h, type Child } from './dom';
import { partsOf, pieces } from './formula';

type Setter = (tex: string, place: HTMLElement, display: boolean) => void;

let setter: Setter | null = null;
let asked: Promise<void> | null = null;
/** Formulas that are to be set, and whether that is under way. */
let waiting: [HTMLElement, string, boolean][] = [];
let setting = false;
/** How many at the front are in sight, and how many at the end came since they were put in order. */
let front = 0;
let fresh = 0;
/** Whether the page moved since then. */
let moved = false;
/** What waits for those in sight. */
let after: (() => void)[] = [];
/** So long, in milliseconds, formulas are set before the page may draw and listen again. */
const slice = 16;
/** More formulas than that are set in the order in which they are seen. */
const few = 30;

async function bring(): Promise<void> {
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

/** Fetches what sets formulas: a page that has many begins with it. */
export function prepare(): Promise<void> {
  return (asked ??= bring());
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
  if (waiting.length > few && (moved || fresh > 0)) {
    // To look at all of them each time takes longer than to set them.
    const old = moved ? [] : waiting.slice(0, waiting.length - fresh);
    const looked = waiting.slice(old.length);
    const seen = looked.map(inSight);
    const nearest = looked.filter((_, i) => seen[i]);
    front = moved ? nearest.length : front + nearest.length;
    waiting = [...nearest, ...old, ...looked.filter((_, i) => !seen[i])];
  }
  moved = false;
  fresh = 0;
  let done = 0;
  do {
    const next = waiting[done++];
    next && setter!(next[1], next[0], next[2]);
  } while (done < waiting.length && performance.now() < deadline);
  waiting = waiting.slice(done);
  front = Math.max(0, front - done);
  if (front === 0) {
    after.splice(0).forEach((call) => call());
  }
  setting = waiting.length > 0;
  setting && setTimeout(work, 0);
}

/** Begins to set them. Of many it must be known which are in sight, and that is after a frame. */
function begin(): void {
  if (waiting.length <= few) {
    work();
    return;
  }
  let begun = false;
  const once = (): void => {
    if (!begun) {
      begun = true;
      work();
    }
  };
  requestAnimationFrame(() => setTimeout(once, 0));
  setTimeout(once, 200); // A window behind others has no frames.
}

// What is read now comes first, and paper has all.
window.addEventListener('scroll', () => (moved = true), { capture: true, passive: true });
window.addEventListener('beforeprint', () => {
  waiting.splice(0).forEach(([place, tex, display]) => setter?.(tex, place, display));
  front = fresh = 0;
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
  ++fresh;
  if (setter && !setting) {
    setting = true;
    queueMicrotask(begin); // Before the page is drawn, if there are few.
  } else if (!setting) {
    setting = true;
    // Without it formulas stay as they are written.
    prepare().then(begin, () => after.splice(0).forEach((call) => call()));
  }
  return place;
}

/** Calls back when the formulas in sight are set: what is not seen yet can wait for them. */
export function afterSight(call: () => void): void {
  setting ? after.push(call) : setTimeout(call, 0);
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

/** A line of a formula that stands alone, and what is said of it: "if v ≤ 2k". */
export interface Line {
  readonly text: string;
  readonly condition?: string;
}

/**
 * Lines of a formula that stands alone. What is said of a line is a separate column; where there is
 * little room it stands below, and lines end between parts.
 */
export function displayed(lines: readonly Line[]): HTMLElement {
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
    lines.flatMap(({ text, condition }): Child[] => [
      h('div', { class: condition === undefined ? 'whole' : null }, parts(text)),
      condition !== undefined && h('div', { class: 'condition' }, parts(condition)),
    ]),
  );
}
