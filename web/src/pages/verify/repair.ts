// A list that is no design: what becomes of it with few blocks changed.
import { address, askWith, type Design, type Repaired } from '../../lib/api';
import { fill, h, type Child } from '../../lib/dom';
import { count, number } from '../../lib/words';
import { problem } from '../../shell/router';

/** Longer lists are not compared line by line. */
const mostCompared = 3000;

interface Line {
  sign: '' | '+' | '−';
  block: readonly number[];
}

/** What stays, goes and comes, in order: a longest common subsequence of blocks. */
export function compared(
  before: readonly (readonly number[])[],
  after: readonly (readonly number[])[],
): Line[] {
  const key = (block: readonly number[]): string => [...block].sort((a, b) => a - b).join(' ');
  const [a, b] = [before.map(key), after.map(key)];
  const width = b.length + 1;
  const longest = new Uint16Array((a.length + 1) * width);
  for (let i = a.length - 1; i >= 0; --i) {
    for (let j = b.length - 1; j >= 0; --j) {
      longest[i * width + j] =
        a[i] === b[j]
          ? longest[(i + 1) * width + j + 1]! + 1
          : Math.max(longest[(i + 1) * width + j]!, longest[i * width + j + 1]!);
    }
  }
  const lines: Line[] = [];
  let [i, j] = [0, 0];
  while (i < a.length || j < b.length) {
    if (i < a.length && j < b.length && a[i] === b[j]) {
      lines.push({ sign: '', block: after[j]! });
      ++i;
      ++j;
    } else if (
      j >= b.length ||
      (i < a.length && longest[(i + 1) * width + j]! >= longest[i * width + j + 1]!)
    ) {
      lines.push({ sign: '−', block: before[i++]! });
    } else {
      lines.push({ sign: '+', block: after[j++]! });
    }
  }
  return lines;
}

/** Lists of at most so many blocks are repaired without being asked. */
const atOnce = 200;
/** So many unchanged blocks are shown around a change, and all of a list that is short. */
const around = 1;
const mostWhole = 40;

function changes(lines: readonly Line[], name: (x: number) => string): Child[] {
  const shown = new Set<number>(lines.length <= mostWhole ? lines.keys() : []);
  lines.forEach(({ sign }, i) => {
    if (sign !== '') {
      for (let j = i - around; j <= i + around; ++j) {
        shown.add(j);
      }
    }
  });
  const found: Child[] = [];
  let gap = false;
  lines.forEach(({ sign, block }, i) => {
    if (!shown.has(i)) {
      if (!gap) {
        found.push(h('li', { class: 'repair-gap' }, '⋮'));
      }
      gap = true;
      return;
    }
    gap = false;
    const words = block.map(name).join(' ');
    found.push(
      h(
        'li',
        { class: sign === '+' ? 'repair-new' : sign === '−' ? 'repair-old' : '' },
        h('span', { class: 'repair-sign' }, sign || '\u00a0'),
        sign === '−' ? h('s', {}, words) : words,
        sign !== '' && h('span', { class: 'repair-why' }, sign === '−' ? 'removed' : 'added'),
      ),
    );
  });
  return found;
}

/** A list to be repaired. */
export interface Given {
  query: object;
  body: string | Blob;
  blocks: readonly (readonly number[])[];
  name(x: number): string;
  /** "Repair without x": what is done differently. */
  title?: string;
  /** It is not begun without being asked. */
  later?: boolean;
}

/**
 * The list without the blocks that hold one of these names, which are no elements then; null if
 * nothing would be left of it.
 */
export function withoutNames(
  design: Design,
  names: readonly string[],
): Pick<Given, 'body' | 'blocks' | 'name' | 'title'> | null {
  const { v, k, change, kind, labels = [] } = design;
  const odd = new Set(names.map((name) => labels.indexOf(name)));
  const left = labels.filter((_, x) => !odd.has(x));
  const place = new Map(left.map((name, i) => [labels.indexOf(name), i]));
  const blocks = design.blocks
    .filter((block) => !block.some((x) => odd.has(x)))
    .map((block) => block.map((x) => place.get(x)!));
  if (blocks.length < 2 || left.length !== v - names.length || left.length <= k) {
    return null;
  }
  const header = `# changeover design v=${left.length} k=${k} change=${change} kind=${kind}`;
  const lines = blocks.map((block) => block.map((x) => left[x]!).join(' '));
  return {
    body: [header, `# labels: ${left.join(' ')}`, ...lines, ''].join('\n'),
    blocks,
    name: (x) => left[x] ?? String(x),
    title: `Repair without ${names.join(' and ')}`,
  };
}

export function repairOffer(
  given: Given,
  take: (design: Design) => void,
  open: (design: Design) => void,
  signal: AbortSignal,
): HTMLElement {
  const place = h('div', { role: 'status' });
  const ask = h(
    'button',
    {
      type: 'button',
      onclick: async () => {
        ask.disabled = true;
        fill(place, h('p', { class: 'hint' }, 'Looking for a repair …'));
        try {
          const response = await askWith(address('repair', given.query), {
            method: 'POST',
            headers: { 'Content-Type': 'text/plain; charset=utf-8' },
            body: given.body,
            signal,
          });
          show((await response.json()) as Repaired);
        } catch (fault) {
          if (!signal.aborted) {
            fill(place, problem(fault));
          }
        }
        ask.disabled = false;
      },
    },
    'Suggest a repair',
  );

  function show({ design, kept, given: had }: Repaired): void {
    if (!design) {
      fill(
        place,
        h(
          'p',
          {},
          'No repair was found within ten seconds. `changeover search --repair FILE` can ' +
            'search for longer.',
        ),
      );
      return;
    }
    const b = design.blocks.length;
    // Long lists are not compared: what the program kept is counted.
    const lines = b + had <= mostCompared ? compared(given.blocks, design.blocks) : null;
    const of = (sign: Line['sign']): number | undefined =>
      lines?.filter((line) => line.sign === sign).length;
    const same = of('') ?? kept;
    const [gone, come] = [of('−') ?? had - kept, of('+') ?? b - kept];
    fill(
      place,
      h(
        'p',
        {},
        h('strong', {}, `A design with ${count(b, 'block')}`),
        ', verified. ',
        `It keeps ${number(same)} of your ${count(had, 'block')}, `,
        h('span', { class: 'repair-count old' }, `removes ${gone === 0 ? 'none' : number(gone)}`),
        ' and ',
        h('span', { class: 'repair-count new' }, `adds ${come === 0 ? 'none' : number(come)}`),
        '.',
      ),
      lines && h('ol', { class: 'repair-lines' }, changes(lines, given.name)),
      h(
        'div',
        { class: 'row' },
        h('button', { type: 'button', onclick: () => take(design) }, 'Use the repaired list'),
        h(
          'button',
          { type: 'button', class: 'plain', onclick: () => open(design) },
          'Open in the viewer',
        ),
      ),
    );
  }
  // Short lists are repaired in a moment: no need to be asked.
  if (!given.later && given.blocks.length > 0 && given.blocks.length <= atOnce) {
    ask.click();
  }
  return h(
    'section',
    { class: 'repair' },
    h('h2', {}, given.title ?? 'Repair'),
    h(
      'p',
      {},
      ask,
      ' ',
      h('span', { class: 'hint' }, 'with as many blocks as now, or a few more if none is found'),
    ),
    place,
  );
}
