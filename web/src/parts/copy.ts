// A button that copies text, and says whether it did.
import { announce, h } from '../lib/dom';

export function copyButton(words: string, text: () => string | Promise<string>): HTMLButtonElement {
  const button = h(
    'button',
    {
      type: 'button',
      class: 'plain small',
      onclick: async () => {
        try {
          await navigator.clipboard.writeText(await text());
          button.textContent = 'Copied';
          announce('Copied');
        } catch {
          button.textContent = 'Not copied';
          announce('The browser did not let this page copy. Mark the text and copy it by hand.');
        }
        setTimeout(() => (button.textContent = words), 2000);
      },
    },
    words,
  );
  return button;
}
