// A static copy offers no link to what it does not have: such a link becomes the words that it had.
import { h } from '../lib/dom';
import { cellOfLabel, isCell, isHeld } from '../lib/source';
import { askedOf } from '../parts/fields';
import { placeOf } from './router';

async function leadsNowhere(href: string): Promise<boolean> {
  const { path, params } = placeOf(href);
  if (path !== 'cell' && path !== 'design') {
    return false;
  }
  const asked = askedOf(params);
  const cell =
    asked === null || isCell(asked) ? asked : 'label' in asked ? cellOfLabel(asked.label) : null;
  return cell !== null && !(await isHeld(cell));
}

async function prune(anchor: HTMLAnchorElement): Promise<void> {
  if (!(await leadsNowhere(anchor.getAttribute('href')!))) {
    return;
  }
  // Of a list of places to go, what cannot be gone to is nothing.
  const item = anchor.closest('nav li');
  item
    ? item.remove()
    : anchor.replaceWith(h('span', { class: anchor.className }, ...anchor.childNodes));
}

/** Looks at all links that come into `root`, before they are drawn. */
export function withoutLinksBeyond(root: HTMLElement): void {
  new MutationObserver((changes) => {
    for (const node of changes.flatMap(({ addedNodes }) => [...addedNodes])) {
      if (node instanceof HTMLElement) {
        const inside = node.querySelectorAll<HTMLAnchorElement>('a[href^="#/"]');
        [node, ...inside].forEach(
          (each) =>
            each.matches('a[href^="#/"]') &&
            void prune(each as HTMLAnchorElement).catch(() => undefined),
        );
      }
    }
  }).observe(root, { childList: true, subtree: true });
}
