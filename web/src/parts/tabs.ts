// Tabs: one panel at a time, arrow keys between them.
import { fill, h } from '../lib/dom';

export interface Tab {
  name: string;
  title: string;
  /** Draws the panel. The signal is aborted when another tab is chosen. */
  draw(panel: HTMLElement, signal: AbortSignal): void;
}

export function tabs(
  label: string,
  all: readonly Tab[],
  start: string,
  signal: AbortSignal,
  chosen: (name: string) => void,
): HTMLElement {
  let leaving = new AbortController();
  signal.addEventListener('abort', () => leaving.abort());
  const panel = h('div', { role: 'tabpanel', id: 'panel', tabindex: -1 });
  const buttons = all.map((tab) =>
    h(
      'button',
      {
        type: 'button',
        role: 'tab',
        id: `tab-${tab.name}`,
        'aria-controls': panel.id,
        onclick: (event) => {
          open(tab, true);
          // Who points does not walk through the tabs by keys: keys are the panel's.
          if ((event as MouseEvent).detail > 0) {
            panel.focus({ preventScroll: true });
          }
        },
      },
      tab.title,
    ),
  );

  function open(tab: Tab, tell: boolean): void {
    leaving.abort();
    leaving = new AbortController();
    buttons.forEach((button, i) => {
      button.setAttribute('aria-selected', String(all[i] === tab));
      button.tabIndex = all[i] === tab ? 0 : -1;
    });
    panel.setAttribute('aria-labelledby', `tab-${tab.name}`);
    fill(panel);
    tab.draw(panel, leaving.signal);
    if (tell) {
      chosen(tab.name);
    }
  }
  const list = h(
    'div',
    {
      role: 'tablist',
      'aria-label': label,
      onkeydown: (event) => {
        const now = buttons.indexOf(document.activeElement as HTMLButtonElement);
        const to = { ArrowRight: now + 1, ArrowLeft: now - 1, Home: 0, End: buttons.length - 1 }[
          (event as KeyboardEvent).key
        ];
        if (now >= 0 && to !== undefined) {
          event.preventDefault();
          const i = (to + buttons.length) % buttons.length;
          buttons[i]!.focus();
          open(all[i]!, true);
        }
      },
    },
    buttons,
  );
  open(all.find((tab) => tab.name === start) ?? all[0]!, false);
  return h('div', { class: 'tabs' }, list, panel);
}
