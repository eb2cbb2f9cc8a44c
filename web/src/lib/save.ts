import { h } from './dom';

/**
 * An address of that text, for the browser to take a file from. It stays for a minute: a busy
 * machine begins to take it long after the click.
 */
export function addressOf(text: string, type: string): string {
  const address = URL.createObjectURL(new Blob([text], { type }));
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
  return address;
}

/** Hands a text that the page made to the browser, as a file to keep. */
export function save(name: string, text: string, type: string): void {
  h('a', { href: addressOf(text, type), download: name }).click();
}
