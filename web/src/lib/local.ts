// What one page hands to another within this window: a design that is in no catalog, and a text to
// be checked.
//
// Both survive a reload as long as they fit into the storage of a window (some 5 MB); a larger one
// lasts as long as the page itself.
import type { Design } from './api';

const designKey = 'changeover-local';
const textKey = 'changeover-text';
/**
 * Elements in all blocks together: beyond, the text of a design would not fit into that storage.
 */
const mostStored = 1_000_000;
let design: Design | null = null;
let text: string | null = null;

function store(key: string, value: string): void {
  try {
    sessionStorage.setItem(key, value);
  } catch {
    sessionStorage.removeItem(key);
  }
}

/** The design that `#/design?local=1` shows. */
export function keepLocal(shown: Design): void {
  design = shown;
  if (shown.blocks.length * shown.k <= mostStored) {
    store(designKey, JSON.stringify(shown));
  } else {
    sessionStorage.removeItem(designKey);
  }
}

export function localDesign(): Design | null {
  const kept = sessionStorage.getItem(designKey);
  design ??= kept === null ? null : (JSON.parse(kept) as Design);
  return design;
}

/** A text that was pasted elsewhere: `#/verify?pasted=1` checks it at once. */
export function keepText(pasted: string): void {
  text = pasted;
  store(textKey, pasted);
}

export function keptText(): string | null {
  text ??= sessionStorage.getItem(textKey);
  return text;
}
