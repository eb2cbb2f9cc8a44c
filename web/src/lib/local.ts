// What one page hands to another: a design that is in no file and no catalog, and text that somebody pasted.
// Both live as long as the window.
import type { Design } from './api';

const designKey = 'changeover-local-design';
const textKey = 'changeover-pasted';

/** Keeps a design for `#/design?local=1`. False if the browser has no room for it. */
export function keepLocal(design: Design): boolean {
  return keep(designKey, JSON.stringify(design));
}

export function localDesign(): Design | null {
  const text = sessionStorage.getItem(designKey);
  return text === null ? null : (JSON.parse(text) as Design);
}

/** Keeps text for `#/verify?pasted=1`, which takes it as its input. */
export function keepPasted(text: string): boolean {
  return keep(textKey, text);
}

export function pasted(): string | null {
  return sessionStorage.getItem(textKey);
}

function keep(key: string, text: string): boolean {
  try {
    sessionStorage.setItem(key, text);
    return true;
  } catch {
    return false;
  }
}
