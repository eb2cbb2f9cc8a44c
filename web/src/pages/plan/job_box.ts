// The box with the form of a job. In a narrow window it folds to one line while a plan is made and
// read, so that the result is not far below it; and the focus goes along.
import { fill, h } from '../../lib/dom';
import { lead, narrow } from '../../parts/lead';
import { inShort } from './headline';
import type { Job } from './job';

export class JobBox {
  readonly element: HTMLDetailsElement;
  private readonly summary = h('summary', {}, 'The job');

  /** `job`: what the line says of it when the box is folded. */
  constructor(
    private readonly content: HTMLElement,
    private readonly job: () => Job,
    private readonly go: HTMLButtonElement,
  ) {
    this.element = h(
      'details',
      { class: 'job-box no-print', open: true, ontoggle: () => this.refresh() },
      this.summary,
      content,
    );
  }

  private refresh(): void {
    const line = this.element.open ? '' : inShort(this.job());
    fill(this.summary, line ? [line, ': ', h('span', { class: 'as-link' }, 'change')] : 'The job');
  }

  open(): void {
    this.element.open = true;
  }

  /** Only where the form would hide what comes after it. */
  fold(): void {
    this.element.open &&= !narrow();
    this.refresh();
  }

  /** Whether the reader is at work in the form, and should be left there. */
  holdsFocus(): boolean {
    return this.content.contains(document.activeElement);
  }

  /** Takes the reader to what is new: `focus` is said, and `shown` is in sight with the job's line. */
  leadTo(focus: HTMLElement, shown: HTMLElement, block: ScrollLogicalPosition): void {
    lead(focus, narrow() ? this.element : shown, block);
  }

  /** What had the focus is gone: the reader goes on where the plan was asked for. */
  takeBack(): void {
    if (document.activeElement === document.body) {
      (this.element.open ? this.go : this.summary).focus({ preventScroll: true });
    }
  }
}
