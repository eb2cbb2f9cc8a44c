// Ranges as they stand in links and on the command line: `3..12`, `..40`, `5`.

export interface Range {
  from: number;
  to: number;
}

/** Null if it is not a range. */
export function readRange(text: string): Range | null {
  const found = /^\s*(\d*)\s*(?:(\.\.+|[-–—…])\s*(\d*))?\s*$/.exec(text);
  if (!found || (!found[1] && !found[3])) {
    return null;
  }
  const to = found[2] ? found[3] : found[1];
  const range = { from: Number(found[1] || 0), to: to ? Number(to) : Infinity };
  return range.from <= range.to ? range : null;
}
