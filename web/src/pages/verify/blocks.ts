// The blocks in place: what is introduced and what leaves at every step, wrong steps marked, and
// the way to them.
import { announce, fill, h, type Child } from '../../lib/dom';
import { count, number, setsOf } from '../../lib/words';
import { virtualList } from '../../parts/virtual';
import type { View } from '../../shell/router';
import type { Report } from './check';
import { wrongSteps } from './verdict';

/** What is wrong with a list too long to be shown, in words. */
export function defects({ answer, blocks }: Report): HTMLElement {
  const { uncovered, uncovered_examples } = answer.details;
  const more = (known: number, all: number) =>
    all > known && h('li', {}, `and ${number(all - known)} more`);
  return h(
    'section',
    {},
    h('h2', {}, 'Blocks'),
    h(
      'p',
      { class: 'note' },
      `The list is checked, but its ${number(blocks.b)} blocks are too many to be shown here.`,
    ),
    ...(answer.bad_steps.length > 0
      ? [
          h('h3', {}, 'Wrong steps'),
          h(
            'ul',
            {},
            answer.bad_steps.map(({ why }) => h('li', {}, why)),
            more(answer.bad_steps.length, answer.details.bad_steps),
          ),
        ]
      : []),
    ...(uncovered_examples.length > 0
      ? [
          h('h3', {}, 'In no block'),
          h('p', {}, uncovered_examples.map((set) => `{${set.join(', ')}}`).join(' ')),
          h('ul', {}, more(uncovered_examples.length, uncovered)),
        ]
      : []),
  );
}

export function blockList(report: Report, view: View): HTMLElement {
  const { answer, blocks } = report;
  const { k, b, change, kind } = blocks;
  const nameOf = (x: number) => blocks.labels?.[x] ?? String(x);
  const wrong = wrongSteps(report);
  const isWrong = new Set(wrong);
  let inPlace = view.params.get('order') !== 'file';
  let pair: number[] = [];

  function row(i: number): HTMLElement {
    const from = (inPlace ? blocks.placed : blocks.blocks).subarray(i * k, (i + 1) * k);
    const first = i === 0 && kind === 'linear';
    const before = first
      ? null
      : new Set(blocks.blocks.subarray((i === 0 ? b - 1 : i - 1) * k, (i === 0 ? b : i) * k));
    const now = new Set(from);
    const out = before ? [...before].filter((x) => !now.has(x)) : [];
    const elements: Child[] = [...from].map((x) => {
      const words = [before && !before.has(x) ? 'in' : '', pair.includes(x) ? 'of-pair' : '']
        .filter(Boolean)
        .join(' ');
      return h('span', { class: words ? `element ${words}` : 'element' }, nameOf(x));
    });
    const bad = isWrong.has(i);
    return h(
      'div',
      { class: bad ? 'block bad' : 'block' },
      h('span', { class: 'block-number' }, bad ? '✗ ' : '', number(i + 1)),
      h('span', { class: 'block-elements' }, elements),
      before &&
        h(
          'span',
          { class: 'block-out' },
          out.length > 0 ? 'out ' : '',
          out.map((x) => h('s', {}, nameOf(x), ' ')),
        ),
      bad &&
        h(
          'strong',
          { class: 'block-why' },
          blocks.introduced[i] === 0
            ? 'nothing changes'
            : `${count(blocks.introduced[i]!, 'element')} ` +
                `${blocks.introduced[i] === 1 ? 'changes' : 'change'}`,
          h('span', { class: 'block-should' }, `, ${change} should`),
        ),
    );
  }

  const list = virtualList({ label: `The ${number(b)} blocks`, rows: b, row });

  // ---- wrong steps ----
  let current = -1;
  const where = h('span', { class: 'hint' });
  function goToStep(next: number): void {
    current = (next + wrong.length) % wrong.length;
    const i = wrong[current]!;
    list.goTo(i);
    where.textContent =
      `${number(current + 1)} of ${number(wrong.length)}: the step from ` +
      `block ${number(i === 0 ? b : i)} to block ${number(i + 1)}`;
    announce(`${where.textContent}: ${blocks.introduced[i]} elements change, ${change} should`);
  }
  const steps =
    wrong.length > 0 &&
    h(
      'div',
      { class: 'row' },
      h(
        'button',
        {
          type: 'button',
          class: 'plain',
          onclick: () => goToStep(current - 1),
          disabled: wrong.length < 2,
        },
        '‹ Previous wrong step',
      ),
      h(
        'button',
        { type: 'button', class: 'plain', onclick: () => goToStep(current + 1) },
        'Next wrong step ›',
      ),
      where,
    );

  // ---- uncovered pairs ----
  const said = h('p', { class: 'note', role: 'status', hidden: true });
  function blocksWith(x: number): number[] {
    const found: number[] = [];
    for (let i = 0; i < b; ++i) {
      if (blocks.blocks.subarray(i * k, (i + 1) * k).includes(x)) {
        found.push(i);
      }
    }
    return found;
  }
  function inWords(found: number[]): string {
    if (found.length === 0) {
      return 'no block';
    }
    const shown = found.slice(0, 12).map((i) => number(i + 1));
    return (
      `${found.length === 1 ? 'block' : 'blocks'} ` +
      `${shown.join(', ')}${found.length > 12 ? ` and ${number(found.length - 12)} more` : ''}`
    );
  }
  function show(set: number[], button: HTMLElement): void {
    pair = set;
    view.go({ pair: set.map(nameOf).join(' ') }, { quiet: true });
    for (const each of pairs.querySelectorAll('[aria-pressed=true]')) {
      each.setAttribute('aria-pressed', 'false');
    }
    button.setAttribute('aria-pressed', 'true');
    const found = set.map(blocksWith);
    said.hidden = false;
    const where = set.map((x, i) => `${nameOf(x)} is in ${inWords(found[i]!)}`);
    said.textContent = `${where.join('; ')}. No block has all of them.`;
    // To the place where the two are nearest to each other.
    const [one = [], other = []] = found;
    let best: [number, number] | null = null;
    for (const i of one.slice(0, 2000)) {
      for (const j of other.slice(0, 2000)) {
        if (!best || Math.abs(i - j) < Math.abs(best[0] - best[1])) {
          best = [i, j];
        }
      }
    }
    list.refresh();
    const target = best ? Math.min(...best) : (one[0] ?? other[0]);
    if (target !== undefined) {
      list.goTo(target);
    }
  }
  const wantedPair = view.params.get('pair');
  let first: (() => void) | null = null;
  const pairs = h(
    'div',
    {
      class: 'pairs',
      role: 'group',
      'aria-label': `The ${setsOf(blocks.strength)} that are in no block`,
    },
    answer.uncovered_pairs.map((set) => {
      const button = h(
        'button',
        {
          type: 'button',
          class: 'plain pair',
          'aria-pressed': 'false',
          onclick: () => show(set, button),
        },
        `{${set.map(nameOf).join(', ')}}`,
      );
      if (wantedPair === set.map(nameOf).join(' ')) {
        first = () => show(set, button);
      }
      return button;
    }),
  );
  const more = answer.details.uncovered - answer.uncovered_pairs.length;
  const missing =
    answer.details.uncovered > 0 &&
    h(
      'section',
      { class: 'verify-missing' },
      h('h2', {}, 'In no block'),
      h(
        'p',
        { class: 'hint' },
        `Choose one of the ${setsOf(blocks.strength)} to see where its elements are.`,
      ),
      pairs,
      more > 0 && h('p', { class: 'hint' }, `and ${number(more)} more`),
      said,
    );

  const order = h('input', {
    type: 'checkbox',
    id: 'in-place',
    checked: inPlace,
    onchange: () => {
      inPlace = order.checked;
      view.go({ order: inPlace ? null : 'file' }, { quiet: true });
      list.refresh();
    },
  });
  requestAnimationFrame(() => {
    if (first) {
      first();
    } else if (wrong.length > 0) {
      goToStep(0);
    }
  });
  const box = h('div', {});
  fill(
    box,
    missing,
    h(
      'section',
      { class: 'verify-blocks' },
      h('h2', {}, 'Blocks'),
      h(
        'p',
        { class: 'hint' },
        h('dfn', { class: 'element in' }, 'Introduced'),
        ': was not in the block before. ',
        h('s', {}, 'Out'),
        ': was in the block before, and is no more.',
      ),
      steps,
      h(
        'div',
        { class: 'check' },
        order,
        h('label', { for: 'in-place' }, 'Elements keep their place while they stay'),
      ),
      list.element,
    ),
  );
  return box;
}
