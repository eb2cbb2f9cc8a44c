// What the failed tests say: which part or pair explains them, and the test that tells most next.
import type { Diagnosis } from '../../lib/api';
import { h, type Child } from '../../lib/dom';
import { count } from '../../lib/words';

const name = (fault: readonly string[]) =>
  fault.length === 1 ? `part ${fault[0]}` : `${fault[0]} with ${fault[1]}`;

function explained(
  label: string,
  { left, explanations }: NonNullable<Diagnosis['next']>['if_it_fails'],
): HTMLElement {
  const shown = (explanations as unknown as string[][][])
    .slice(0, 6)
    .map((each) => each.map(name).join(' and '));
  const explained =
    left === 0
      ? 'nothing explains all results'
      : `${count(left, 'explanation')} ${left === 1 ? 'is' : 'are'} left`;
  const some = shown.length > 0 ? `: ${shown.join('; ')}${left > shown.length ? '; …' : ''}` : '';
  return h('li', {}, `${label}, ${explained}${some}.`);
}

/** `add` puts the next test on the sheet, `forbid` the faults into the pairs that must not meet. */
export function diagnosisPanel(
  found: Diagnosis,
  add: () => void,
  forbid: (faults: string[][]) => void,
): HTMLElement {
  const proven = found.faults as unknown as string[][];
  const suspects = found.suspects as unknown as string[][];
  const { next } = found;
  const pairs = proven.filter((fault) => fault.length === 2);
  const body: Child[] = [
    h('h2', {}, 'What the failures say'),
    h('p', {}, `${count(found.passed, 'test')} passed, ${found.failed} failed.`),
    proven.length > 0
      ? h('p', {}, h('strong', {}, `At fault, proven: ${proven.map(name).join('; ')}.`))
      : null,
    suspects.length > 0
      ? h(
          'details',
          { open: suspects.length <= 12 },
          h('summary', {}, `${count(suspects.length, 'suspect')}`),
          h('p', {}, suspects.map(name).join('; '), '.'),
        )
      : null,
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
      h('p', { class: 'set-up' }, next.set_up.join(', ')),
      h('p', {}, `${next.why.charAt(0).toUpperCase()}${next.why.slice(1)}.`),
      h(
        'ul',
        {},
        explained('If it fails', next.if_it_fails),
        explained('If it passes', next.if_it_passes),
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
