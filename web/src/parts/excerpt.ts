// Where in a text something is wrong: the lines around it, with the place marked.
import { h } from '../lib/dom';
import { number } from '../lib/words';

const around = 2;
const widest = 120;

/** Lines `line - around` to `line + around` of a text or file, read no further than needed. */
async function linesAround(
  source: string | Blob,
  line: number,
): Promise<{ first: number; lines: string[] }> {
  const first = Math.max(1, line - around);
  const last = line + around;
  const lines: string[] = [];
  const reader = new Blob([source]).stream().pipeThrough(new TextDecoderStream()).getReader();
  let current = 1;
  let rest = '';
  for (;;) {
    const { done, value } = await reader.read();
    const pieces = (rest + (value ?? '')).split('\n');
    rest = done ? '' : pieces.pop()!;
    for (const piece of pieces) {
      if (current >= first && current <= last) {
        lines.push(piece);
      }
      ++current;
    }
    if (done || current > last) {
      void reader.cancel();
      return { first, lines };
    }
  }
}

/** From `column` on so many letters are marked. */
export async function excerpt(
  source: string | Blob,
  line: number,
  column: number | undefined,
  length = 1,
): Promise<HTMLElement> {
  const { first, lines } = await linesAround(source, line);
  return h(
    'pre',
    {
      class: 'excerpt',
      tabindex: 0,
      'aria-label': `Line ${line} of the text and what is around it`,
    },
    lines.map((text, i) => {
      const here = first + i === line;
      // A very long line is cut to what is around the place.
      const from = here && column && column > widest ? column - widest / 2 : 1;
      const shown = text.slice(from - 1, from - 1 + widest).replaceAll('\t', ' ');
      const at = column ? column - from : -1;
      const marked =
        here && at >= 0
          ? [
              shown.slice(0, at),
              h('mark', {}, shown.slice(at, at + length) || '\u00a0'),
              shown.slice(at + length),
            ]
          : [shown];
      return h(
        'span',
        { class: here ? 'excerpt-line here' : 'excerpt-line' },
        h('span', { class: 'excerpt-number' }, number(first + i)),
        from > 1 ? '…' : '',
        marked,
        text.length > from - 1 + widest ? '…' : '',
        '\n',
      );
    }),
  );
}

/** The offset in `text` at which a line begins, and its length. */
export function lineRange(text: string, line: number): [from: number, to: number] {
  let from = 0;
  for (let i = 1; i < line; ++i) {
    const next = text.indexOf('\n', from);
    if (next < 0) {
      break;
    }
    from = next + 1;
  }
  const end = text.indexOf('\n', from);
  return [from, end < 0 ? text.length : end];
}
