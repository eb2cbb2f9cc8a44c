import { h } from '../lib/dom';

export interface More {
  readonly element: HTMLButtonElement;
  open(now: boolean): void;
}

/**
 * On a phone a button that shows what stands after it, which is hidden until then; elsewhere all is
 * in sight. `what`: "controls"
 */
export function more(what: string, opened = false): More {
  const element = h('button', {
    type: 'button',
    class: 'plain more-controls',
    onclick: () => open(element.getAttribute('aria-expanded') === 'false'),
  });
  function open(now: boolean): void {
    element.setAttribute('aria-expanded', String(now));
    element.textContent = `${now ? 'Fewer' : 'More'} ${what}`;
  }
  open(opened);
  return { element, open };
}
