// Small pictures of examples.
import type { Cell } from '../../lib/api';
import { fill, h } from '../../lib/dom';
import { designOf, isHeld } from '../../lib/source';
import { symmetryOf } from '../../lib/symmetry';
import { shortName } from '../../parts/recipe';
import { thumbnail } from '../../parts/thumbnail';
import { link } from '../../shell/router';
import { circlePicture, hasShortCycles } from '../design/circle';

/**
 * Pictures of examples are made when they come into sight, one after the other: on a circle if the
 * design is turned by a symmetry, otherwise its stays.
 */
export class Gallery {
  private readonly watcher: IntersectionObserver;
  private readonly cells = new Map<Element, Cell>();
  private readonly captions = new Map<Element, HTMLElement>();
  private queue: Promise<void> = Promise.resolve();

  constructor(private readonly signal: AbortSignal) {
    this.watcher = new IntersectionObserver(
      (seen) => {
        for (const { target, isIntersecting } of seen) {
          if (isIntersecting) {
            this.watcher.unobserve(target);
            this.queue = this.queue.then(() => this.show(target));
          }
        }
      },
      { rootMargin: '300px' },
    );
    signal.addEventListener('abort', () => this.watcher.disconnect());
    document.addEventListener(
      'themechange',
      () => this.cells.forEach((_, place) => this.watcher.observe(place)),
      { signal },
    );
  }

  add(cell: Cell): HTMLElement {
    const place = h('span', { class: 'small-picture' });
    const caption = h('small', { class: 'hint' });
    this.captions.set(place, caption);
    this.cells.set(place, cell);
    this.watcher.observe(place);
    return h(
      'a',
      { class: 'example', href: link('design', { ...cell }) },
      place,
      h(
        'span',
        {},
        `Example: ${shortName(cell)}`,
        (cell.strength ?? 2) > 2 && `, strength ${cell.strength}`,
      ),
      caption,
    );
  }

  private async show(place: Element): Promise<void> {
    try {
      const cell = this.cells.get(place)!;
      if (!(await isHeld(cell))) {
        return;
      }
      const design = await designOf(cell, this.signal);
      const symmetry = symmetryOf(design);
      const turned =
        !hasShortCycles(symmetry) &&
        symmetry.rotations > 2 &&
        symmetry.shift <= 6 &&
        design.v <= 80;
      const image = turned
        ? circlePicture(
            symmetry,
            design.blocks,
            (x) => design.labels?.[x] ?? String(x),
            Array.from({ length: symmetry.shift }, (_, i) => i),
            [],
            place.clientWidth,
          )
        : thumbnail(design, '', this.signal);
      image.setAttribute('aria-hidden', 'true');
      image.removeAttribute('role');
      image.removeAttribute('aria-label');
      fill(place, image as Node);
      this.captions.get(place)!.textContent = turned
        ? 'Base blocks on the circle of elements'
        : 'A row of stays for each element';
    } catch {
      // The link is there all the same.
    }
  }
}
