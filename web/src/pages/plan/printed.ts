// Rules of a job that the person who runs its tests must know, below the printed sheet.
import { h, type Child } from '../../lib/dom';
import { neverRows } from './document';
import type { Job } from './job';

function rowsOf(job: Job): string[][] {
  try {
    return neverRows(job);
  } catch {
    return []; // Such a list is not planned.
  }
}

/** `notes`: those of the plan; what cannot meet is printed. */
export function printedRules(job: Job, notes: readonly string[]): HTMLElement | null {
  const never = rowsOf(job);
  const broken = job.parts.filter(({ gone }) => gone).map(({ name }) => name);
  const lines: Child[] = [
    never.length > 0 && h('h3', {}, 'Must never be in one set-up'),
    never.length > 0 &&
      h(
        'ul',
        {},
        never.map(([one = '', other = '', ...why]) =>
          h(
            'li',
            {},
            h('strong', {}, one),
            ' and ',
            h('strong', {}, other),
            why.length > 0 ? `: ${why.filter(Boolean).join(', ')}` : '',
          ),
        ),
      ),
    ...notes.filter((note) => /cannot meet/.test(note)).map((note) => h('p', {}, `Note: ${note}`)),
    broken.length > 0 && h('p', {}, 'Gone: ', broken.join(', ')),
  ].filter(Boolean);
  return lines.length > 0 ? h('section', { class: 'only-print printed-rules' }, lines) : null;
}
