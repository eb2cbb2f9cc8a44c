// What is wrong with a model, in its own lines.
import { h } from '../../lib/dom';
import { excerpt, lineRange } from '../../parts/excerpt';

const placed = /^model:(\d+):(?:(\d+):)? /;

/** Whether a message says in which line of the model the fault is. */
export const isPlaced = (message: string): boolean => placed.test(message);

/** "Line 4, column 4: …" of a message about a model. */
export function modelWords(message: string): string {
  return message.replace(placed, (_, line: string, column?: string) =>
    column ? `Line ${line}, column ${column}: ` : `Line ${line}: `,
  );
}

/** How long the word is that begins there: a name in brackets, a text in quotes, or what it is. */
export function wordLength(line: string, column: number): number {
  const rest = line.slice(column - 1);
  return (/^(\[[^\]]*\]?|"[^"]*"?|[\p{L}\p{N}_.-]+)/u.exec(rest)?.[0] ?? rest.slice(0, 1)).length;
}

/** What is wrong at a place of the model. */
interface Slip {
  /** From where to where, in the text. */
  readonly from: number;
  readonly to: number;
  /** The lines around it. */
  readonly lines: HTMLElement;
  /** What the model may mean in its place, as it is written there; null: nothing is near. */
  readonly meant: string | null;
}

/** null: the message names no line. Columns count bytes. */
async function slipOf(message: string, model: string): Promise<Slip | null> {
  const [found, at, byte] = placed.exec(message) ?? [];
  if (!found || !at) {
    return null;
  }
  const [from, end] = lineRange(model, Number(at));
  const line = model.slice(from, end);
  const bytes = new TextEncoder().encode(line);
  const column = byte
    ? new TextDecoder().decode(bytes.slice(0, Number(byte) - 1)).length + 1
    : undefined;
  const length = column === undefined ? line.length : wordLength(line, column);
  const lines = await excerpt(model, Number(at), column, length);
  const [, wrong, right] = /called '([^']*)'; did you mean '([^']*)'\?$/.exec(message) ?? [];
  const begin = from + (column ?? 1) - 1;
  const word = model.slice(begin, begin + length);
  const meant =
    wrong !== undefined && right !== undefined && word.includes(wrong)
      ? word.replace(wrong, () => right)
      : null;
  return { from: begin, to: begin + length, lines, meant };
}

/** The field of the model. */
interface Field {
  /** Selects these letters, in sight. */
  mark(from: number, to: number): void;
  /** Writes a text in their place. */
  write(from: number, to: number, text: string): void;
}

/** Marks it in the field, and below what is said of it shows its lines and offers to mend it. */
export async function showSlip(
  message: string,
  model: string,
  said: Element,
  field: Field,
): Promise<void> {
  const slip = await slipOf(message, model);
  if (!slip || !said.isConnected) {
    return;
  }
  const { from, to, meant } = slip;
  field.mark(from, to);
  said.after(slip.lines);
  if (meant !== null) {
    const write = () => field.write(from, to, meant);
    said.append(
      ' ',
      h('button', { type: 'button', class: 'plain small', onclick: write }, `Write ${meant}`),
    );
  }
}
