// What to do now: the next test of each bench, with what to take out and put in, large enough for a
// phone beside the bench.
import { fill, h } from '../../lib/dom';
import { capital } from '../../lib/words';
import { moneyOf } from './job';
import { fromWords, givesNow, givesWords, gotWords } from './handover';
import { namesOf, numbersOf, repeats, step, testName, verdictOf, type Outcome } from './outcome';
import { resultButtons } from './results';
import { setUp } from './sheet';

export interface Next {
  readonly element: HTMLElement;
  refresh(): void;
}

/** `time` says a time of the plan as people do. */
export function nextTests(
  outcome: Outcome,
  time: (planned: string) => string,
  written: (test: number) => void,
): Next {
  const element = h('div', { class: 'next-tests no-print' });
  const names = namesOf(outcome);
  const numbers = numbersOf(outcome);
  const sentence = (words: string) => h('p', { class: 'hand-over' }, `${capital(words)}.`);
  const money = moneyOf(outcome.tests.map(({ cost }) => cost));
  const named = (i: number) => testName(outcome.tests[i]!, names[i]!);
  function card(i: number): HTMLElement {
    const test = outcome.tests[i]!;
    const { out, in: put } = step(outcome, i);
    // On an empty bench what is put in is all that is then in.
    const all = out.length === 0 && put.length === test.parts.length;
    const of = Math.max(...numbers.filter((_, at) => outcome.tests[at]!.bench === test.bench));
    const from = (part: string) => [part, fromWords(test, part)].filter(Boolean).join(' ');
    const again = repeats(outcome, i);
    const same = out.length === 0 && put.length === 0;
    const line = (label: string, kind: string, parts: string[]) =>
      h(
        'p',
        { class: kind },
        h('span', { class: 'label' }, label),
        parts.length > 0 ? parts.join(', ') : 'nothing',
      );
    return h(
      'section',
      { class: 'next-test', 'aria-label': `Next: ${named(i)}` },
      h(
        'h3',
        {},
        `Next: ${named(i)} of\u00a0${of} `,
        h(
          'span',
          { class: 'hint' },
          `${outcome.unit ? 'takes' : 'costs'} ${money(test.cost)}` +
            `${outcome.unit ? ` ${outcome.unit}` : ''}` +
            `${test.when ? `, begins ${time(test.when)}` : ''}`,
        ),
      ),
      again !== '' &&
        h('p', { class: 'repeats' }, `${capital(again)}: same parts, tested once more.`),
      same && h('p', { class: 'same' }, 'Change nothing.'),
      ...(test.values || all || same
        ? []
        : [
            out.length > 0 ? line('Take out', 'leave', out) : null,
            line('Put in', 'enter', put.map(from)),
          ]),
      h(
        'p',
        { class: 'set-up' },
        h(
          'span',
          { class: 'label' },
          test.values ? 'Set' : all ? 'Put in' : same ? 'In it' : 'Then in',
        ),
        ...setUp(test, outcome.places, new Set(put)),
      ),
      ...givesNow(outcome, test.bench, time).map(sentence),
      ...(all ? gotWords(test) : []).map(sentence),
      ...givesWords(test, time).map(sentence),
      resultButtons(test, names[i]!, () => written(i), { pass: '✓ pass', fail: '✗ fail' }).element,
    );
  }
  /** Of a bench whose tests are done: what others need of it. */
  function leftOver(bench: string | null): HTMLElement | null {
    const gives = givesNow(outcome, bench, time);
    return gives.length === 0
      ? null
      : h(
          'section',
          { class: 'next-test', 'aria-label': `Next: ${bench}` },
          h('h3', {}, `${bench}: all its tests are done`),
          gives.map(sentence),
        );
  }
  function refresh(): void {
    const benches = [...new Set(outcome.tests.map(({ bench }) => bench))];
    const next = benches
      .map((bench) =>
        outcome.tests.findIndex((test) => test.bench === bench && verdictOf(test) === ''),
      )
      .filter((i) => i >= 0);
    const over = benches.filter((bench) => !next.some((i) => outcome.tests[i]!.bench === bench));
    fill(element, next.map(card), over.map(leftOver));
  }
  refresh();
  return { element, refresh };
}
