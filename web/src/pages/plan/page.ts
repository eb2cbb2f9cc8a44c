// The page Plan: a job, its sheet, and what is written down on it.
import { ApiError, get, type Run } from '../../lib/api';
import { announce, fill, h } from '../../lib/dom';
import { count } from '../../lib/words';
import { problem, type View } from '../../shell/router';
import { sheetActions } from './actions';
import { follow } from './ask';
import { Diagnosing } from './diagnosing';
import { inWords, keyIn, othersOf, readFrom, readWords, requestOf, unitIn } from './document';
import { readFile, readParts } from './files';
import { acceptFiles, filePick } from './drop';
import { jobForm } from './form';
import { headline } from './headline';
import { JobBox } from './job_box';
import { emptyJob, FieldFault, type Job, type Part } from './job';
import { withNext } from './insertion';
import { introduction } from './introduction';
import { keptHere, keptOnServer, keptWords } from './keeping';
import { keptList } from './kept';
import { livePanel, measureOf } from './live';
import { modelWords, showSlip } from './model_faults';
import { nextTests } from './next';
import {
  isDone,
  onBenches,
  outcomeOf,
  verdictOf,
  type Place,
  type State,
  type Test,
} from './outcome';
import { keepResult, keepRun, openRun, ownName, watchRun, withResults, type Kept } from './run';
import { Patience } from './patience';
import { printedRules } from './printed';
import { diagnosisOf, whatIfHere } from './questions';
import { askedWith, forbidding, oneOfEach } from './revised';
import { runSheet } from './sheet';
import { keep as keepState, newId } from './store';
import { timeWords } from './times';
import { compared } from './what_if';
import { workbookLink } from './workbook';

export class PlanPage {
  private state: State;
  /** The run on the server, once there is one. */
  private run: Kept | null = null;
  private watching: AbortController | null = null;
  private planning: AbortController | null = null;
  /** Whether that plan is of a separate job, and not of the rest of the sheet. */
  private anew = false;
  /** What is drawn of the sheet, and what it listens to. */
  private drawing = new AbortController();
  private refreshSheet: () => void = () => undefined;
  /** Tests whose results the server does not have yet. */
  private readonly unsaved = new Set<number>();
  private saving: Promise<void> = Promise.resolve();
  private readonly introduction = introduction((job) => this.useExample(job));
  private readonly result = h('div', { class: 'result' });
  private readonly fault = h('div', { class: 'plan-fault no-print' });
  private readonly news = h('div', { class: 'plan-news no-print' });
  private readonly keeping = h('div', { class: 'keeping no-print' });
  private readonly stale = h(
    'p',
    { class: 'note no-print', hidden: true },
    'The job has changed since this sheet was planned. Plan again, or replan the remaining ' +
      'tests if some are done.',
  );
  private readonly form = jobForm(
    () => this.changed(),
    () => this.planAgain(),
    (text) => this.pasted(text),
    () => this.pick.click(),
    (dayBegins) => this.retimed(dayBegins),
  );
  private readonly pick = filePick((file) => void this.take(file));
  private readonly box = new JobBox(
    this.form.element,
    () => this.formOr(this.state.job),
    this.form.go,
  );

  /** What a fault says may be mended now. */
  private faulty = false;
  /** What was said of a file that was read. */
  private told: readonly string[] = [];
  private readonly diagnosing = new Diagnosing({
    ask: () => diagnosisOf(this.form.read(), this.state.outcome!, this.view.signal),
    add: (next) => {
      this.state.outcome = withNext(this.state.outcome!, next, this.form.read());
      this.show();
      void this.keepSheet();
      this.result.querySelector('.next-tests')?.scrollIntoView({ block: 'nearest' });
    },
    forbid: (faults) => this.revise(forbidding(this.form.read(), faults)),
    fail: (fault) => this.say(fault),
  });

  constructor(
    private readonly view: View,
    state: State | null,
    private readonly writes: boolean,
  ) {
    this.state = state ?? { id: newId(), job: emptyJob(), outcome: null };
  }

  draw(): void {
    fill(
      this.view.root,
      this.introduction.element,
      this.pick,
      keptList(this.writes, this.view.signal),
      this.box.element,
      this.news,
      this.fault,
      this.result,
    );
    acceptFiles(this.view.root, (file) => void this.take(file));
    this.form.set(this.state.job);
    if (this.state.outcome) {
      this.show();
    }
  }

  /** Shows a run of the server, and what others write into it. */
  follow(run: Kept): void {
    this.run = run;
    this.watching?.abort();
    this.watching = new AbortController();
    const stop = () => this.watching?.abort();
    this.view.signal.addEventListener('abort', stop, { once: true });
    watchRun(
      run.id,
      () => this.run!,
      (found) => this.heard(found),
      () => {
        this.run = null;
        stop();
        this.sayKept('This run was removed from the server; this window still has it.');
      },
      this.watching.signal,
    );
  }

  /** Another window has written into the run. */
  private heard(found: Run): void {
    if (found.sheet_revision !== this.run!.sheet) {
      this.interrupt('it was of the sheet before.');
      void this.reopen('This run was replanned in another window.');
      return;
    }
    this.run = { ...this.run!, revision: found.revision };
    const { tests } = this.state.outcome!;
    const before = tests.map(verdictOf).join();
    const mine = [...this.unsaved].map((i) => [i, { ...tests[i]! }] as const);
    withResults(this.state.outcome!, found);
    mine.forEach(([i, { result, notes }]) => Object.assign(tests[i]!, { result, notes }));
    this.refreshSheet();
    if (before !== tests.map(verdictOf).join()) {
      this.interrupt('a result came from another window. Replan to count it.');
    }
  }

  /** What the stream may not have told yet. */
  private async listenOnce(signal: AbortSignal): Promise<void> {
    const { run } = this;
    const found = run && (await get('run?id', { id: run.id }, signal).catch(() => null));
    found && this.heard(found);
    signal.throwIfAborted();
  }

  /** A plan for the rest of this sheet is of no use any more. */
  private interrupt(why: string): void {
    if (!this.anew) {
      this.planning?.abort(new Error(`The plan was stopped: ${why}`));
    }
  }

  private async reopen(why: string): Promise<void> {
    try {
      const { state, run } = await openRun(this.run!.id, this.view.signal);
      this.unsaved.clear();
      this.state = state;
      this.run = run;
      this.form.set(state.job);
      this.show();
      fill(this.news, h('p', { class: 'note', role: 'status' }, why));
    } catch (fault) {
      this.say(fault);
    }
  }

  private changed(): void {
    this.stale.hidden = this.state.outcome === null;
    if (this.faulty) {
      this.clear();
    }
  }

  say(fault: unknown): void {
    if (this.view.signal.aborted) {
      return;
    }
    const message = fault instanceof Error ? fault.message : '';
    const key = fault instanceof FieldFault ? fault.key : keyIn(message);
    this.clear();
    this.faulty = true;
    const placed = key !== null && this.form.show(key, this.fault);
    if (placed || !this.state.outcome) {
      this.box.open();
    }
    const { model } = this.formOr(this.state.job);
    const words = modelWords(inWords(message));
    const said = fault instanceof ApiError ? new ApiError(words, fault.status) : fault;
    fill(this.fault, problem(said));
    this.fault.scrollIntoView({ block: 'nearest' });
    void showSlip(message, model, this.fault.firstElementChild!, this.form).then(() =>
      this.fault.scrollIntoView({ block: 'nearest' }),
    );
  }

  /** What comes next is said below the job. */
  private clear(): void {
    this.faulty = false;
    this.news.after(this.fault);
    fill(this.fault);
  }

  note(...words: (Node | string)[]): void {
    this.clear();
    fill(this.fault, h('p', { class: 'note', role: 'status' }, words));
  }

  private useExample(job: Job): void {
    this.tell([]);
    this.form.set(job);
    void this.plan([], [], true);
  }

  /** What was done is not lost: the job that it belongs to stays where it is kept. */
  private startAnew(): void {
    this.state.id = newId();
    this.run = null;
    this.watching?.abort();
    this.unsaved.clear();
    fill(this.news);
  }

  private planAgain(): void {
    const begun = this.state.outcome?.tests.some((test) => verdictOf(test) !== '') ?? false;
    void this.plan([], [], this.run !== null || begun);
  }

  private async pasted(text: string): Promise<Part[] | null> {
    try {
      const { job, notes } = await readParts(text, emptyJob(), this.view.signal);
      this.clear();
      const read = notes.filter((note) => /header|not used/.test(note));
      this.form.told(read.map(readWords), unitIn(read));
      return job.parts;
    } catch (fault) {
      this.say(fault);
      return null;
    }
  }

  private tell(notes: readonly string[]): void {
    this.told = notes;
    const list = h('ul', {}, ...notes.map((note) => h('li', {}, note)));
    fill(this.news, notes.length > 0 && h('div', { class: 'note', role: 'status' }, list));
  }

  /** The notes of the plan say some of it again. */
  private tellOnce(): void {
    const bare = (note: string) => note.replace(/^[^\s:]+: /, '');
    const again = new Set(this.state.outcome!.notes.map(bare));
    this.tell(this.told.filter((note) => !again.has(bare(note))));
  }

  private formOr(other: Job): Job {
    try {
      return this.form.read();
    } catch {
      return other;
    }
  }

  private async take(file: File): Promise<void> {
    try {
      const { job, done, notes, fault } = await readFile(
        file,
        this.formOr(emptyJob()), // What cannot be read is replaced by the file.
        () => requestOf(this.form.read()),
        this.view.signal,
      );
      this.clear();
      this.form.set(job);
      this.form.told(readFrom(file.name, notes), unitIn(notes));
      this.tell(othersOf(file.name, notes));
      this.stale.hidden = this.state.outcome === null;
      if (fault) {
        this.say(fault);
      } else if (done.tests.length > 0) {
        await this.plan(onBenches(done.tests, this.state.outcome), done.places, true);
      } else {
        announce(`${file.name} was read`);
      }
    } catch (fault) {
      this.say(fault);
    }
  }

  /** `anew`: of a separate job; the sheet that is there stays what it is. */
  private async plan(
    tests: readonly Test[],
    places: readonly Place[],
    anew = false,
  ): Promise<void> {
    this.planning?.abort();
    this.anew = anew;
    const mine = (this.planning = new AbortController());
    const best = new AbortController();
    const stop = () => mine.abort();
    this.view.signal.addEventListener('abort', stop, { once: true });
    this.clear();
    this.form.go.disabled = true;
    this.setOld(true);
    try {
      const job = this.form.read();
      const request = askedWith(job, this.state.outcome, tests, places);
      const live = livePanel(
        measureOf(job, tests.some(isDone)),
        () => best.abort(),
        stop,
        mine.signal,
      );
      const patience = new Patience(job.seconds === 0);
      const cancel = h('button', { type: 'button', class: 'plain', onclick: stop }, 'Cancel');
      this.box.fold();
      if (this.writes) {
        fill(this.fault, live.element);
        this.box.leadTo(live.line, live.rest, 'nearest');
      } else {
        this.note(`Planning, for ${count(job.seconds || 10, 'second')} at most … `, cancel);
        this.box.leadTo(cancel, this.fault, 'nearest');
      }
      const found = await follow(request, mine.signal, best.signal, (each) => {
        live.hear(each);
        patience.isOut(each) && best.abort();
      });
      anew ? this.startAnew() : await this.listenOnce(mine.signal);
      const done = tests.filter(isDone);
      const now = this.formOr(job);
      this.state = {
        id: this.state.id,
        job: { ...job, dayBegins: now.dayBegins },
        outcome: {
          ...patience.noted(outcomeOf(found.planned, job, done, places)),
          plan: found.job,
        },
      };
      this.unsaved.clear();
      const atWork = this.box.holdsFocus();
      fill(this.fault, found.message ? h('p', { class: 'note' }, found.message) : null);
      this.stale.hidden = JSON.stringify(now) === JSON.stringify(this.state.job);
      this.setOld(false); // It takes the focus.
      this.show();
      this.tellOnce();
      if (!atWork) {
        this.box.leadTo(this.result.querySelector('h2')!, this.result, 'start');
      }
      announce(
        `${count(this.state.outcome!.tests.length, 'test')}, cost ${this.state.outcome!.cost}`,
      );
      await this.keepSheet();
    } catch (why) {
      if (!this.view.signal.aborted) {
        mine.signal.aborted ? this.cancelled(mine) : this.say(why);
      }
    } finally {
      this.view.signal.removeEventListener('abort', stop);
      if (this.planning === mine) {
        this.setOld(false);
        this.form.go.disabled = false;
        mine.abort();
        this.box.takeBack();
      }
    }
  }

  private cancelled(planning: AbortController): void {
    if (this.planning !== planning) {
      return; // Another one has begun, and is shown there.
    }
    if (!this.state.outcome) {
      this.box.open();
    }
    const why: unknown = planning.signal.reason;
    this.note(why instanceof DOMException ? 'Cancelled.' : (why as Error).message);
  }

  /** While another plan is made nothing can be written on the sheet before it, which would be lost. */
  private setOld(old: boolean): void {
    this.result.classList.toggle('old', old);
    this.result.inert = old;
  }

  private show(): void {
    const { state } = this;
    const outcome = state.outcome!;
    this.introduction.planned();
    this.drawing.abort();
    const drawing = (this.drawing = new AbortController());
    this.view.signal.addEventListener('abort', () => drawing.abort(), { once: true });
    this.box.fold();
    const written = (i: number) => void this.written(i);
    const time = (planned: string) => timeWords(planned, state.job.dayBegins);
    const sheet = runSheet(state.job.title, outcome, time, written, drawing.signal);
    const next = nextTests(outcome, time, written);
    const actions = sheetActions(
      state.job.title,
      outcome,
      time,
      state.job.changeCosts === '',
      workbookLink(state.job.title, outcome, drawing.signal),
      () => void this.plan(outcome.tests, outcome.places),
      () => void this.diagnosing.ask(outcome),
    );
    this.diagnosing.show(outcome);
    this.refreshSheet = () => {
      sheet.refresh();
      next.refresh();
      actions.refresh();
      this.diagnosing.refresh(outcome);
    };
    this.refreshSheet();
    fill(
      this.result,
      headline(state.job, outcome, {
        trust: () => (this.box.open(), this.form.trust()),
        oneOfEach: () => this.revise(oneOfEach(this.form.read())),
        longer: (seconds) => this.revise({ ...this.form.read(), seconds }),
      }),
      this.stale,
      next.element,
      actions.element,
      this.diagnosing.element,
      sheet.element,
      printedRules(state.job, outcome.notes),
      this.keeping,
      compared(outcome),
      whatIfHere(
        state.job,
        outcome,
        () => this.form.read(),
        (job, tests) => this.revise(job, tests),
        drawing.signal,
      ),
    );
  }

  /** Plans the rest anew, of another job. */
  private revise(job: Job, tests = this.state.outcome!.tests): void {
    this.form.set(job);
    void this.plan(tests, this.state.outcome!.places);
  }

  /** When days begin is a matter of the page: the plan stays. */
  private retimed(dayBegins: string): void {
    if (!this.state.outcome || this.state.job.dayBegins === dayBegins) {
      return;
    }
    this.state.job = { ...this.state.job, dayBegins };
    this.show();
    void this.keepSheet();
  }

  /** A result was written down. */
  private async written(i: number): Promise<void> {
    if (this.run && !this.writes) {
      await this.reopen(
        'This window may only look: to write results down, open the address that “changeover ' +
          'serve” printed, or the link that “Copy a link for others” gives.',
      );
      return;
    }
    const test = this.state.outcome!.tests[i]!;
    Object.assign(test, { by: ownName(), at: new Date().toISOString() });
    this.refreshSheet();
    if (!this.writes) {
      await this.keepHere();
      return;
    }
    this.unsaved.add(i);
    this.saving = this.saving.then(() => this.saveResults());
    await this.saving;
  }

  /** Writes what the server does not have yet; tries again while it does not answer. */
  private async saveResults(): Promise<void> {
    const { signal } = this.view;
    try {
      if (!this.run) {
        this.unsaved.clear();
        await this.keepSheet(true);
        return;
      }
      for (const i of [...this.unsaved]) {
        this.unsaved.delete(i);
        try {
          this.run = await keepResult(this.state, i, this.run, signal);
        } catch (fault) {
          this.unsaved.add(i);
          throw fault;
        }
      }
      await this.keepHere();
    } catch (fault) {
      if (signal.aborted) {
        return;
      }
      if (fault instanceof ApiError && fault.status === 409) {
        await this.reopen(fault.message);
        return;
      }
      await this.keepHere();
      this.sayKept(
        `Not on the server yet: ${(fault as Error).message} This browser has it, and tries again.`,
      );
      setTimeout(
        () =>
          !signal.aborted &&
          this.unsaved.size > 0 &&
          (this.saving = this.saving.then(() => this.saveResults())),
        5000,
      );
    }
  }

  /** Keeps the sheet: on the server once results are written, else in browser and link. */
  private async keepSheet(begin = false): Promise<void> {
    try {
      if (this.writes && (this.run || begin)) {
        const run = await keepRun(this.state, this.run, this.view.signal);
        if (!this.run) {
          this.follow(run);
        }
        this.run = run;
      }
      await this.keepHere();
    } catch (fault) {
      if (fault instanceof ApiError && fault.status === 409) {
        await this.reopen(fault.message);
      } else if (!this.view.signal.aborted) {
        await this.keepHere();
        this.sayKept(`Not on the server: ${(fault as Error).message}`);
      }
    }
  }

  /** The link has another state than this browser: what is changed from now on has its own name. */
  keepBeside(): void {
    this.state.id = newId();
  }

  private turn = 0;

  async keepHere(): Promise<void> {
    const turn = ++this.turn;
    try {
      const { s, id, whole } = await keepState(this.state);
      // A link to a later state may be packed sooner.
      if (this.view.signal.aborted || turn !== this.turn) {
        return;
      }
      this.view.go(this.run ? { run: this.run.id, s: null, id: null } : { s, id, run: null }, {
        quiet: true,
      });
      this.sayKept(this.run ? '' : keptWords(this.state.job, whole));
    } catch {
      this.sayKept(
        this.run
          ? ''
          : 'This browser has no room to keep the job: download it as CSV before you leave.',
      );
    }
  }

  sayKept(words: string): void {
    const { run } = this;
    fill(
      this.keeping,
      run
        ? keptOnServer(words, run.id, this.writes)
        : keptHere(
            words,
            this.writes && this.state.outcome !== null ? () => void this.keepSheet(true) : null,
          ),
    );
  }
}
