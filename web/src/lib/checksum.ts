// The checksum of a design: of its blocks as text, one a line.

/** More elements in all blocks together than this are too many for a page. */
const mostSummed = 5_000_000;

/**
 * The SHA-256 of b blocks of k elements, in hexadecimal digits; a label ends with the first eight.
 * Null where the browser has none or the blocks are too many.
 */
export async function checksumOf(
  b: number,
  k: number,
  block: (i: number) => { join(between: string): string },
): Promise<string | null> {
  if (!globalThis.crypto?.subtle || b * k > mostSummed) {
    return null;
  }
  let text = '';
  for (let i = 0; i < b; ++i) {
    text += `${block(i).join(' ')}\n`;
  }
  const digest = await crypto.subtle.digest('SHA-256', new TextEncoder().encode(text));
  return [...new Uint8Array(digest)].map((byte) => byte.toString(16).padStart(2, '0')).join('');
}
