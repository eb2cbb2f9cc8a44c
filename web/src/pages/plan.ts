import { h } from '../lib/dom';
import { count } from '../lib/words';
import { link, type Page, type View } from '../shell/router';
import { mayStart } from './plan/ask';
import { PlanPage } from './plan/page';
import { openRun } from './plan/run';
import { load } from './plan/store';

const lost =
  'This link does not hold a whole job (it may have been cut), and this browser does not have ' +
  'it either. Open it where it was made, or create it again.';

async function render(view: View): Promise<void> {
  const writes = await mayStart();
  const asked = view.params.get('run');
  let opened: Awaited<ReturnType<typeof openRun>> | null = null;
  let fault: unknown = null;
  if (asked) {
    try {
      opened = await openRun(asked, view.signal);
    } catch (why) {
      fault = why;
    }
  }
  const given = opened ? null : await load(view.params);
  if (view.signal.aborted) {
    return;
  }
  const page = new PlanPage(view, opened?.state ?? given?.state ?? null, writes);
  page.draw();
  if (opened) {
    page.follow(opened.run);
    page.sayKept('');
  } else if (fault) {
    page.say(fault);
  } else if (given?.other) {
    const { id, title, done, tests, when } = given.other;
    page.note(
      `This is the job as the link has it. This browser has it, too, as of ` +
        `${new Date(when).toLocaleString()}, ${done} of ${count(tests, 'test')} done: `,
      h('a', { href: link('plan', { id }) }, `open that ${title}`),
      '. What you change here is kept beside it.',
    );
    page.keepBeside();
  } else if (given?.state.outcome) {
    await page.keepHere();
  } else if ((view.params.has('s') || view.params.has('id')) && !given) {
    page.say(new Error(lost));
  }
}

export const plan: Page = { path: 'plan', title: 'Plan', live: true, render };
