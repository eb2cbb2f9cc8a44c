// What the verdict says, with its reasons: first in a sentence, then fact by fact, then element by
// element.
import { h, type Child } from '../../lib/dom';
import { formula, mathText } from '../../lib/mathematics';
import { termsOf } from '../../lib/terms';
import { count, nameOf, number, ratio, setsOf } from '../../lib/words';
import { factName } from '../../parts/knowl';
import { defined, reason } from '../../parts/recipe';
import { virtualList } from '../../parts/virtual';
import type { Report } from './check';

/** Longer lists of elements are cut. */
const mostNamed = 20;

/** Blocks (from 0) at whose step the number of changes is wrong. */
export function wrongSteps({ blocks: { b, change, kind, introduced } }: Report): number[] {
  const wrong: number[] = [];
  for (let i = kind === 'circular' ? 0 : 1; i < b; ++i) {
    if (introduced[i] !== change) {
      wrong.push(i);
    }
  }
  return wrong;
}

/** The first wrong steps: ": from block 5 to block 6". */
function placesOf(report: Report): string[] {
  const wrong = report.blocks.shown ? wrongSteps(report) : [];
  const { b } = report.blocks;
  const named = wrong
    .slice(0, 3)
    .map((i) => `from block ${number(i === 0 ? b : i)} to block ${number(i + 1)}`);
  return wrong.length === 0
    ? []
    : [`: ${named.join(', ')}`, wrong.length > 3 ? ` and ${number(wrong.length - 3)} more` : ''];
}

function reasons(report: Report): Child[] {
  const { answer, blocks } = report;
  const { details, verdict, bound } = answer;
  if (answer.valid) {
    const what =
      verdict.minimum === 'proved'
        ? 'It is minimum: no design with these parameters has fewer blocks.'
        : `No design has fewer than ${count(verdict.lower_bound, 'block')}; whether one has ` +
          `fewer than this is not known.`;
    const steps =
      blocks.b === 1
        ? 'with one block there is no step'
        : `every step changes ${count(blocks.change, 'element')}`;
    return [
      h(
        'p',
        {},
        `Every one of the ${number(details.subsets)} ${setsOf(blocks.strength)} is in a block, ` +
          `and ${steps}. ${what}`,
      ),
      bound &&
        h('p', { class: 'reason' }, `Lower bound (${bound.name}): `, reason(bound.reason), '.'),
      bound && defined(bound.reason, blocks.strength),
    ];
  }
  const list: Child[] = [];
  if (details.bad_steps > 0) {
    list.push(
      h(
        'li',
        {},
        `${count(details.bad_steps, 'step')} ${details.bad_steps === 1 ? 'does' : 'do'} not ` +
          `change exactly ${count(blocks.change, 'element')}`,
        ...placesOf(report),
        '.',
      ),
    );
  }
  if (details.uncovered > 0) {
    list.push(
      h(
        'li',
        {},
        `${number(details.uncovered)} of ${number(details.subsets)} ${setsOf(blocks.strength)} ` +
          `${details.uncovered === 1 ? 'is' : 'are'} in no block.`,
      ),
    );
  }
  const names = answer.names_among_numbers;
  if (names.length > 0) {
    list.push(
      h(
        'li',
        {},
        `All elements are numbers but ${placesOfNames(report)}: perhaps a slip of the hand.`,
      ),
    );
  }
  return [h('ul', {}, list)];
}

/** How many elements of the first block the last one lacks. */
function changesAtEnd({ blocks: { b, k, blocks } }: Report): number {
  const last = new Set(blocks.subarray((b - 1) * k));
  return blocks.subarray(0, k).filter((x) => !last.has(x)).length;
}

/** A linear list that is a circular design, too: what that is worth, and a way to check it. */
export function alsoCircular(report: Report, check: () => void): Child {
  const { answer, blocks } = report;
  const { b, v, k, change: m, kind, strength, shown } = blocks;
  if (!answer.valid || !shown || kind !== 'linear' || b < 3 || changesAtEnd(report) !== m) {
    return null;
  }
  // Each step newly covers as many pairs; if all together are those that there are, each is once.
  const tight = strength === 2 && b * m * (2 * k - m - 1) === v * (v - 1) && m < k;
  return h(
    'p',
    {},
    `The last block and the first differ in ${count(m, 'element')}, too, so it is also a ` +
      `circular design${tight ? ', and a tight one' : ''}. `,
    h('button', { type: 'button', class: 'plain small', onclick: check }, 'Take it as circular'),
  );
}

/** The blocks in which names stand among numbers: " in block 7". */
function placesOfNames({ answer, blocks: { shown, labels, blocks, k } }: Report): string {
  const places = answer.names_among_numbers.map((name) => {
    const x = labels?.indexOf(name) ?? -1;
    const at = shown && x >= 0 ? blocks.indexOf(x) : -1;
    return at < 0 ? name : `${name} in block ${number(Math.floor(at / k) + 1)}`;
  });
  return places.join(' and ');
}

export function headline(report: Report, circular: Child = null): HTMLElement {
  const { answer, blocks } = report;
  if (answer.valid && blocks.b === 1) {
    return h(
      'div',
      { class: 'verdict valid', role: 'status' },
      h('h2', { tabindex: -1 }, '✓ Valid, but trivial'),
      h(
        'p',
        {},
        `One block with all ${count(blocks.v, 'element')}: every two are together in it, and there ` +
          'is no step. Is a list of blocks meant? Write one block a line.',
      ),
    );
  }
  const name = `${nameOf(blocks)}${blocks.strength === 2 ? '' : ` of strength ${blocks.strength}`}`;
  return h(
    'div',
    { class: `verdict ${answer.valid ? 'valid' : 'invalid'}`, role: 'status' },
    h('h2', { tabindex: -1 }, answer.valid ? '✓ Valid' : '✗ Not a design'),
    h(
      'p',
      {},
      answer.valid ? 'A ' : 'Taken as a ',
      h('strong', {}, name),
      `, with ${count(blocks.b, 'block')}.`,
    ),
    reasons(report),
    circular,
  );
}

function yes(value: boolean): string {
  return value ? 'yes' : 'no';
}

/** A table of what is so, and what it means. */
export function facts({ answer, blocks }: Report): HTMLElement {
  const { details, verdict } = answer;
  const terms = termsOf(blocks.strength);
  const times =
    answer.valid && blocks.b > verdict.lower_bound
      ? ` (b is ${ratio(blocks.b, verdict.lower_bound)} times as much)`
      : '';
  const rows: [term: string, value: string, meaning: string][] = [
    ['elements v', number(blocks.v), terms.v],
    ['block size k', number(blocks.k), terms.k],
    ['change number m', number(blocks.change), terms.change],
    ['kind', blocks.kind, terms.kind],
    ['blocks b', number(blocks.b), terms.blocks],
    [
      'lower bound',
      verdict.lower_bound > 0 ? `${number(verdict.lower_bound)}${times}` : 'not known',
      terms.bound,
    ],
    ['valid', yes(answer.valid), terms.valid],
    ['tight', yes(verdict.tight), `means: ${terms.tight}`],
    ['economical', yes(verdict.economical), `means: it ${terms.economical}`],
    [
      'minimum',
      verdict.minimum === 'proved' ? 'yes, proved' : answer.valid ? 'not known' : 'no',
      `means: ${terms.minimum}`,
    ],
    [
      'excess',
      `${number(details.excess)} of ${number(details.covered)} newly covered`,
      terms.excess,
    ],
  ];
  return h(
    'section',
    { class: 'verify-facts' },
    h('h2', {}, 'Facts'),
    h(
      'table',
      { class: 'facts fact-table' },
      h(
        'tbody',
        {},
        rows.map(([term, value, meaning]) =>
          h('tr', {}, h('th', { scope: 'row' }, factName(term, meaning)), h('td', {}, value)),
        ),
      ),
    ),
    details.fixed.length > 0 &&
      h(
        'p',
        {},
        `In every block: ${details.fixed.slice(0, mostNamed).join(', ')}`,
        details.fixed.length > mostNamed && ` and ${number(details.fixed.length - mostNamed)} more`,
        '.',
      ),
  );
}

export function elementTable({ answer, blocks: { strength } }: Report): HTMLElement {
  const terms = termsOf(strength);
  const { elements } = answer.details;
  const head = h(
    'div',
    { class: 'element-row head', 'aria-hidden': 'true' },
    ['x', 'i_x', 'r_x', 'e_x'].map((name) => h('span', {}, formula(name, name))),
  );
  const list = virtualList({
    label: 'Elements: how often each is introduced, in how many blocks it is, and its excess',
    rows: elements.length,
    row: (i) => {
      const { element, introductions, blocks, excess } = elements[i]!;
      return h(
        'div',
        { class: 'element-row' },
        [element, introductions, blocks, excess].map((value) =>
          h('span', {}, typeof value === 'number' ? number(value) : value),
        ),
      );
    },
  });
  return h(
    'section',
    { class: 'verify-elements' },
    h('h2', {}, 'Element by element'),
    h(
      'p',
      { class: 'hint' },
      mathText(`${terms.introductions}; ${terms.occurrences}; ${terms.surplus}.`),
    ),
    head,
    list.element,
  );
}
