// What is wrong with a model, in its own lines.
import { excerpt } from '../../parts/excerpt';

const placed = /^model:(\d+):(?:(\d+):)? /;

/** Whether a message says in which line of the model the fault is. */
export const isPlaced = (message: string): boolean => placed.test(message);

/** "Line 4, column 4: …" of a message about a model. */
export function modelWords(message: string): string {
  return message.replace(placed, (_, line: string, column?: string) =>
    column ? `Line ${line}, column ${column}: ` : `Line ${line}: `,
  );
}

/** The lines around it, if the message names one. */
export async function modelExcerpt(message: string, model: string): Promise<HTMLElement | null> {
  const found = placed.exec(message);
  return found ? excerpt(model, Number(found[1]), found[2] ? Number(found[2]) : undefined) : null;
}
