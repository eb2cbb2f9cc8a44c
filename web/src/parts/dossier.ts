// What a paper says of a cell or a design: the program writes it.
import type { Cell } from '../lib/api';
import { h } from '../lib/dom';
import { dossierAddress } from '../lib/source';

/** A link that opens it in another window; as a button, if `button` says so. */
export function dossierLink(
  of: Cell | { label: string },
  format: 'html' | 'latex' | 'markdown',
  words: string,
  button = false,
): HTMLElement {
  return h(
    'a',
    {
      class: button ? 'button plain' : null,
      href: dossierAddress(of, format),
      target: '_blank',
      rel: 'noopener',
    },
    words,
  );
}
