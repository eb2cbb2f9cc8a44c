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
