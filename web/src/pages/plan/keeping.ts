// Where the sheet is kept, said below it.
import { linkForOthers } from '../../lib/api';
import { field, h, type Child } from '../../lib/dom';
import { copyButton } from '../../parts/copy';
import { link } from '../../shell/router';
import type { Job } from './job';
import { keepOwnName, ownName } from './run';

/** What is said of a sheet in this browser; `whole`: the link has all of it. */
export function keptWords(job: Job, whole: boolean): string {
  // A model has no list of parts.
  const gone =
    job.source === 'model'
      ? ''
      : 'A part broke? Tick “gone” in the list, then replan the remaining tests. ';
  return whole
    ? `${gone}The link of this page holds the whole job with its sheet and what is done; this ` +
        'browser keeps it, too.'
    : 'This job is too long for a link: it is kept in this browser, and the link opens it only ' +
        'here. Download it as CSV to pass it on.';
}

/** In this browser. `keep` brings the sheet to the server, if that may be. */
export function keptHere(words: string, keep: (() => void) | null): Child[] {
  return [
    h('p', { class: 'hint', role: 'status' }, words),
    keep &&
      h(
        'button',
        { type: 'button', class: 'plain small', onclick: keep },
        'Keep this run on the server',
      ),
  ];
}

/** On the server, as the run `id`. */
export function keptOnServer(words: string, id: string, writes: boolean): Child[] {
  const name = h('input', {
    type: 'text',
    class: 'own-name',
    value: ownName(),
    autocomplete: 'name',
    placeholder: 'your name',
    onchange: () => keepOwnName(name.value),
  });
  return [
    h(
      'p',
      { class: 'hint', role: 'status' },
      words ||
        'This run is kept on the server: what you write down is seen in every window that ' +
          'has it open, and is there when you come back.',
    ),
    h(
      'div',
      { class: 'row' },
      field('Results are signed', name),
      writes &&
        copyButton('Copy a link for others', () => linkForOthers(link('plan', { run: id }))),
    ),
  ];
}
