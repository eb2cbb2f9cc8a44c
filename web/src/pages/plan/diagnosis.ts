// What the failed tests say: which part or pair explains them, and the test that tells most next.
import type { Diagnosis } from '../../lib/api';
import { h, type Child } from '../../lib/dom';
import { capital, count, number } from '../../lib/words';

type Name = (fault: readonly string[]) => string;
/** What can be at fault: parts, or values of a model. */
type Kind = 'parts' | 'values';

/** So few explanations are named; of more it is said how many there are. */
const fewNamed = 2;

function explained(
  label: string,
  name: Name,
  { left, explanations }: NonNullable<Diagnosis['next']>['if_it_fails'],
): HTMLElement {
  const shown = (explanations as unknown as string[][][]).map((each) =>
    each.map(name).join(' and '),
  );
  const explained =
    left === 0
      ? 'nothing explains all results'
      : `${count(left, 'explanation')} ${left === 1 ? 'is' : 'are'} left`;
  const some = left > 0 && left <= fewNamed ? `: ${shown.slice(0, left).join('; ')}` : '';
  return h('li', {}, `${label}, ${explained}${some}.`);
}

/** Why a test was chosen: what it rules out, and the whole of it in details. */
function whyChosen(why: string): Child[] {
  const [, all, out] =
    /of the (\d+) explanations, so either result rules out at least (\d+);/.exec(why) ?? [];
  return all === undefined || out === undefined
    ? [h('p', {}, `${capital(why)}.`)]
    : [
        h(
          'p',
          {},
          `Either result rules out ${2 * Number(out) === Number(all) ? '' : 'at least '}${out} ` +
            `of the ${all}.`,
        ),
        h('details', {}, h('summary', {}, 'Why this test'), h('p', {}, `${capital(why)}.`)),
      ];
}

/** How many faults there must be, and how many ways there are to explain the failures. */
function whatIsNew(found: Diagnosis, kind: Kind): Child[] {
  const { at_least: least, explanations_known: known } = found;
  if (known === 0) {
    return [];
  }
  const all =
    found.failed === 1 ? 'the failure' : found.failed === 2 ? 'both failures' : 'all failures';
  const [one, some] =
    kind === 'values'
      ? ['value or pair of values', 'values and pairs']
      : ['part or pair', 'parts and pairs'];
  const many = `${found.all_explanations ? '' : 'at least '}${number(known)}`;
  const alone = known === 1 && found.all_explanations;
  return [
    h(
      'p',
      {},
      h(
        'strong',
        {},
        least === 1
          ? `One ${one} alone explains ${all}.`
          : least === 2
            ? `No single ${one} explains ${all}, so at least two are at fault.`
            : `No ${least - 1} ${some} explain ${all}, so at least ${least} are at fault.`,
        !alone &&
          (least === 1
            ? ` ${many[0]!.toUpperCase()}${many.slice(1)} do so equally well.`
            : ` ${many[0]!.toUpperCase()}${many.slice(1)} sets of ${least} do so.`),
      ),
    ),
    h(
      'p',
      { class: 'hint' },
      `Every test that failed had ${least === 1 ? 'it' : 'one of them'}, and no test that passed.`,
    ),
  ];
}

/** Where several are at fault together they are those of the explanations, each once. */
function suspectsOf(found: Diagnosis): string[][] {
  const alone = found.suspects as unknown as string[][];
  const together = (found.explanations as unknown as string[][][]).flat();
  return alone.length > 0
    ? alone
    : [...new Map(together.map((fault) => [JSON.stringify(fault), fault])).values()];
}

/** What may be at fault, by the failed test that has it. */
function suspectsBy(tests: readonly FailedTest[], suspects: string[][], name: Name): Child {
  const lists = tests.flatMap(({ name: test, parts }): [string, string[][]][] => {
    const there = suspects.filter((suspect) => suspect.every((part) => parts.includes(part)));
    return there.length > 0
      ? [[`${test.charAt(0).toUpperCase()}${test.slice(1)} failed. Suspects in it`, there]]
      : [];
  });
  const placed = new Set(lists.flatMap(([, there]) => there));
  const rest = suspects.filter((suspect) => !placed.has(suspect));
  return h(
    'details',
    { open: suspects.length <= 24 },
    h('summary', {}, count(suspects.length, 'suspect')),
    h(
      'ul',
      {},
      [...lists, ...(rest.length > 0 ? [['Others', rest] as const] : [])].map(([words, there]) =>
        h('li', {}, `${words}: ${there.map(name).join('; ')}.`),
      ),
    ),
  );
}

export interface FailedTest {
  readonly name: string;
  readonly parts: readonly string[];
}

/**
 * `words` says what a part is; `add` puts the next test on the sheet, `forbid` the faults into
 * the pairs that must not meet.
 */
export function diagnosisPanel(
  found: Diagnosis,
  failed: readonly FailedTest[],
  words: (part: string) => string,
  kind: Kind,
  add: () => void,
  forbid: (faults: string[][]) => void,
): HTMLElement {
  const bare = (part: string) => words(part).replace(/^part /, '');
  const name: Name = (fault) =>
    fault.length === 1 ? words(fault[0]!) : fault.map(bare).join(' with ');
  const proven = found.faults as unknown as string[][];
  const suspects = suspectsOf(found);
  const { next } = found;
  const pairs = proven.filter((fault) => fault.length === 2);
  const body: Child[] = [
    h('h2', {}, 'What the failures say'),
    h('p', {}, `${count(found.passed, 'test')} passed, ${found.failed} failed.`),
    proven.length > 0
      ? h('p', {}, h('strong', {}, `At fault, proven: ${proven.map(name).join('; ')}.`))
      : null,
    ...(proven.length > 0 ? [] : whatIsNew(found, kind)),
    suspects.length > 0 ? suspectsBy(failed, suspects, name) : null,
    found.contradictions.length > 0
      ? h(
          'p',
          { class: 'problem' },
          `${count(found.contradictions.length, 'failure')} had only what passed elsewhere: a ` +
            `fault that comes and goes, or a wrong result.`,
        )
      : null,
  ];
  if (next) {
    body.push(
      h('h3', {}, 'The test that tells most'),
      h('p', { class: 'set-up' }, next.set_up.map(bare).join(', ')),
      ...whyChosen(next.why),
      h(
        'ul',
        {},
        explained('If it fails', name, next.if_it_fails),
        explained('If it passes', name, next.if_it_passes),
      ),
      h(
        'div',
        { class: 'row' },
        h('button', { type: 'button', onclick: add }, 'Make it the next test'),
      ),
    );
  } else if (proven.length > 0) {
    body.push(
      h('p', {}, 'Nothing is left to find out: replace what is at fault, or forbid it and replan.'),
    );
  }
  if (pairs.length > 0) {
    body.push(
      h(
        'div',
        { class: 'row' },
        h(
          'button',
          { type: 'button', class: 'plain', onclick: () => forbid(pairs) },
          `Forbid ${pairs.map(name).join('; ')}`,
        ),
      ),
    );
  }
  if (found.unread > 0) {
    body.push(
      h(
        'p',
        { class: 'hint' },
        `${count(found.unread, 'result')} could not be read; write pass or fail.`,
      ),
    );
  }
  return h('section', { class: 'diagnosis note no-print', 'aria-label': 'Diagnosis' }, body);
}
