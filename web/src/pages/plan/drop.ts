// Files that are given to the page.
import { h } from '../../lib/dom';

/** Files that are dropped onto `place` go to `take`, the first of each drop. */
export function acceptFiles(place: HTMLElement, take: (file: File) => void): void {
  const over = (event: DragEvent, on: boolean) => {
    if (event.dataTransfer?.types.includes('Files')) {
      event.preventDefault();
      place.classList.toggle('dropping', on);
    }
  };
  place.addEventListener('dragover', (event) => over(event, true));
  place.addEventListener(
    'dragleave',
    (event) => event.relatedTarget === null && over(event, false),
  );
  place.addEventListener('drop', (event) => {
    over(event, false);
    const file = event.dataTransfer?.files[0];
    if (file) {
      take(file);
    }
  });
}

/** A field to choose such a file, unseen: a button presses it. */
export function filePick(take: (file: File) => void): HTMLInputElement {
  const pick = h('input', {
    type: 'file',
    class: 'unseen',
    tabindex: -1,
    accept: '.csv,.tsv,.txt,.xlsx,.pict,.model,.json,text/csv,text/plain',
    'aria-label': 'A file with a list of parts',
    onchange: () => {
      const file = pick.files?.[0];
      pick.value = ''; // The same file can be chosen again.
      file && take(file);
    },
  });
  return pick;
}
