// Where the reader is taken when what they asked for is there.

/** Whether a form and its result do not stand side by side, and one hides the other. */
export const narrow = (): boolean => !window.matchMedia('(min-width: 50rem)').matches;

/**
 * The focus goes to `focus`, which is said; `shown` comes into sight: to the top of a narrow window,
 * elsewhere as far as `block` asks. Windows that are asked to move nothing jump: base.css.
 */
export function lead(focus: HTMLElement, shown: Element, block: ScrollLogicalPosition): void {
  focus.focus({ preventScroll: true });
  shown.scrollIntoView({ block: narrow() ? 'start' : block });
}

/**
 * Takes the reader from a form whose button was pressed to its result, whose first heading gets the
 * focus; who writes in the form of a wide window is left there.
 */
export function leadToResult(form: HTMLElement, button: HTMLElement, result: HTMLElement): void {
  const { activeElement } = document;
  if (!narrow() && form.contains(activeElement) && activeElement !== button) {
    return;
  }
  const heading = result.querySelector<HTMLElement>('h2');
  if (heading) {
    heading.tabIndex = -1;
    lead(heading, narrow() ? result : (heading.closest('.verdict') ?? heading), 'nearest');
  } else {
    result.scrollIntoView({ block: 'nearest' });
  }
}

/**
 * Whether the page that is drawn next was asked for by one of its own examples: what these say is
 * waited for, as after a button, and what a link from elsewhere says is read from its top.
 */
export const chosenExample = {
  now: false,
  take(event: Event): void {
    const { ctrlKey, metaKey, shiftKey } = event as MouseEvent;
    chosenExample.now = !(ctrlKey || metaKey || shiftKey); // Else it opens in another window.
  },
  taken(): boolean {
    const { now } = chosenExample;
    chosenExample.now = false;
    return now;
  },
};
