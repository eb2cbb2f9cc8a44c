// Writing down the result of a test: two buttons, pass and fail; pressed again they take it back.
import { h } from '../../lib/dom';
import { verdictOf, type Test } from './outcome';

export interface ResultButtons {
  readonly element: HTMLElement;
  refresh(): void;
}

/** `written` is called after `test.result` has changed. */
export function resultButtons(
  test: Test,
  name: string,
  written: () => void,
  texts = { pass: '✓', fail: '✗' },
): ResultButtons {
  const make = (word: 'pass' | 'fail', text: string) =>
    h(
      'button',
      {
        type: 'button',
        class: `result-${word}`,
        'aria-label': `Test ${name}: ${word}`,
        title: word,
        onclick: () => {
          const now = verdictOf(test);
          test.result = now === word || (word === 'pass' && now === 'done') ? '' : word;
          written();
        },
      },
      h('span', { 'aria-hidden': 'true' }, text),
    );
  const pass = make('pass', texts.pass);
  const fail = make('fail', texts.fail);
  const other = h('small', { class: 'result-other' });
  const refresh = () => {
    const now = verdictOf(test);
    pass.setAttribute('aria-pressed', String(now === 'pass' || now === 'done'));
    fail.setAttribute('aria-pressed', String(now === 'fail'));
    const unusual =
      now === 'other' || now === 'not run' || (now === 'fail' && !/^fail$/i.test(test.result));
    other.textContent = [unusual ? test.result : '', test.by].filter(Boolean).join(' · ');
    other.title = test.at ? `${test.by} ${new Date(test.at).toLocaleString()}` : '';
  };
  refresh();
  return {
    element: h(
      'div',
      { class: 'results', role: 'group', 'aria-label': `Result of test ${name}` },
      pass,
      fail,
      other,
    ),
    refresh,
  };
}
