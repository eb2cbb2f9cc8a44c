// Fields that are folded away until they are wanted; folded, their heading says what is set.
import { h, type Child } from '../lib/dom';

export interface Group {
  readonly element: HTMLDetailsElement;
  readonly name: HTMLElement;
  /** Says what is set now. */
  refresh(): void;
}

/** `said`: what is set, in a few words; empty if nothing is. */
export function group(heading: string, said: () => string, ...content: Child[]): Group {
  const state = h('span', { class: 'group-state' });
  const name = h('span', { class: 'group-name' }, heading);
  const element = h(
    'details',
    { class: 'group' },
    h('summary', {}, name, state),
    h('div', { class: 'group-body' }, content),
  );
  return {
    element,
    name,
    refresh() {
      const words = said();
      state.textContent = words;
      element.classList.toggle('set', words !== '');
    },
  };
}
