// What is wrong with a model, in its own lines.
import { excerpt } from '../../parts/excerpt';

const placed = /^model:(\d+):(?:(\d+):)? /;

/** How many letters must be written anew, at most `most`. */
function distance(one: string, other: string, most: number): number {
  if (Math.abs(one.length - other.length) > most) {
    return most + 1;
  }
  let row = Array.from({ length: other.length + 1 }, (_, i) => i);
  for (let i = 1; i <= one.length; ++i) {
    const next = [i];
    for (let j = 1; j <= other.length; ++j) {
      next[j] = Math.min(
        row[j]! + 1,
        next[j - 1]! + 1,
        row[j - 1]! + (one[i - 1] === other[j - 1] ? 0 : 1),
      );
    }
    row = next;
  }
  return row[other.length]!;
}

/** The parameters of a model in the language of PICT or ACTS. */
const parametersIn = (model: string): string[] =>
  model.split('\n').flatMap((line) => {
    const name = /^\s*([^#[\]:"=]+?)\s*(?:\([^)]*\)\s*)?:/.exec(line)?.[1];
    return name ? [name] : [];
  });

/** The name that was meant, if one is nearly the same. */
export function meant(message: string, model: string): string | null {
  const wrong = /no parameter is called '(.+?)'/.exec(message)?.[1];
  if (!wrong) {
    return null;
  }
  const most = Math.max(1, Math.floor(wrong.length / 3));
  const near = parametersIn(model)
    .map((name) => [distance(wrong.toLowerCase(), name.toLowerCase(), most), name] as const)
    .filter(([far]) => far <= most)
    .sort(([one], [other]) => one - other);
  return near[0]?.[1] ?? null;
}

/** "Line 4, column 4: …" of a message about a model, with the name that was meant. */
export function modelWords(message: string, model: string): string {
  const name = meant(message, model);
  return (
    message.replace(placed, (_, line: string, column?: string) =>
      column ? `Line ${line}, column ${column}: ` : `Line ${line}: `,
    ) + (name ? `. Did you mean '${name}'?` : '')
  );
}

/** The lines around it, if the message names one. */
export async function modelExcerpt(message: string, model: string): Promise<HTMLElement | null> {
  const found = placed.exec(message);
  return found ? excerpt(model, Number(found[1]), found[2] ? Number(found[2]) : undefined) : null;
}
