import { ApiError, address, hasToken, post, type Design, type Kind } from '../lib/api';
import { field, fill, h, select, type Child } from '../lib/dom';
import { keepLocal, keepText, keptText } from '../lib/local';
import { longestWord, pack, unpack } from '../lib/share';
import { bytes, changes, kinds } from '../lib/words';
import { command, toCopy } from '../parts/command';
import { asText } from '../parts/downloads';
import { chosenExample, leadToResult } from '../parts/lead';
import { cellDetail, isHeld } from '../lib/source';
import { about, isCopy } from '../shell/about';
import { link, problem, type Page, type View } from '../shell/router';
import { blockList, defects } from './verify/blocks';
import type { Declared } from './verify/alone';
import { check, type Report } from './verify/check';
import { citation } from './verify/citation';
import { examples } from './verify/examples';
import { excerpt, lineRange } from '../parts/excerpt';
import { repairOffer, withoutNames, type Given } from './verify/repair';
import { alsoCircular, elementTable, facts, headline } from './verify/verdict';

/** Larger texts are not put into the field, only named. */
const longestShown = 1_000_000;
/** Elements in all blocks together, beyond which the viewer would take its time. */
const longestViewed = 2_000_000;
/** A file that was chosen is there when one comes back to the page, but not after a reload. */
let file: File | null = null;

function designOf({
  blocks: { v, k, b, change, kind, strength, labels, blocks },
  answer,
}: Report): Design {
  const list = Array.from({ length: b }, (_, i) => [...blocks.subarray(i * k, (i + 1) * k)]);
  return {
    format: 'changeover-design/1',
    v,
    k,
    change,
    kind,
    ...(strength === 2 ? {} : { strength }),
    blocks: list,
    ...(labels ? { labels } : {}),
    verdict: answer.verdict,
  };
}

/** Below the form until something is checked. */
function whatComes(): Child[] {
  const parts: [string, string][] = [
    ['Steps', 'each wrong one is marked in the list, with what leaves and what is introduced'],
    ['Pairs', 'each one that is in no block is named, with the blocks of its two elements'],
    ['Quality', 'tight, economical, minimum; the lower bound, and how far above it the list is'],
    ['What next', 'a repair of a list that is nearly a design; a citation of one that is known'],
  ];
  return [
    h('h2', {}, 'What the answer says'),
    h(
      'dl',
      { class: 'facts' },
      parts.map(([name, words]) => [h('dt', {}, name), h('dd', {}, words)]).flat(),
    ),
    h('p', {}, 'On the command line: ', command('changeover verify FILE')),
  ];
}

/** The best lower bound of a static copy, where it has the cell: the worker knows simple ones. */
async function takeKeptBound({ answer, blocks }: Report, signal: AbortSignal): Promise<void> {
  const { v, k, change, kind } = blocks;
  const cell = { v, k, change, kind };
  if (!(await isHeld(cell))) {
    return;
  }
  const [best] = (await cellDetail(cell, signal)).bounds;
  if (best && best.blocks > answer.verdict.lower_bound) {
    answer.bound = best;
    answer.verdict.lower_bound = best.blocks;
    answer.verdict.minimum = answer.valid && best.blocks === blocks.b ? 'proved' : 'unknown';
  }
}

/** Where there is no server, a list is mended on a machine of one's own. */
function mendElsewhere(): HTMLElement {
  return h(
    'section',
    { class: 'repair' },
    h('h2', {}, 'Repair'),
    h('p', {}, 'The program finds a design near to this list:'),
    toCopy('changeover search --repair FILE'),
  );
}

async function firstText(view: View): Promise<string> {
  const example = examples.find(({ name }) => name === view.params.get('example'));
  if (example) {
    return example.text;
  }
  const word = view.params.get('text');
  const linked = word ? await unpack(word) : null;
  return typeof linked === 'string'
    ? linked
    : view.params.has('pasted') || view.params.has('kept')
      ? (keptText() ?? '')
      : '';
}

async function render(view: View): Promise<void> {
  let running: AbortController | null = null;
  const text = h('textarea', {
    spellcheck: 'false',
    autocomplete: 'off',
    autocapitalize: 'off',
    placeholder: '0 1 2 3\n2 3 4 5\n…',
    'aria-label': 'The design: one block per line, or any format that Changeover reads',
  });
  const chosen = h('div', { class: 'note chosen', hidden: true });
  const result = h('div', { class: 'result' });
  const pick = h('input', {
    type: 'file',
    class: 'unseen',
    tabindex: -1,
    'aria-label': 'A file with a design',
    onchange: () => pick.files?.[0] && take(pick.files[0]),
  });
  const v = h('input', {
    type: 'number',
    min: 2,
    value: view.params.get('v') ?? '',
    placeholder: 'as in the file',
    onchange: () => view.go({ v: v.value }, { quiet: true }),
  });
  const change = select(
    view.params.get('change') ?? '',
    [['', 'as in the file'], ...changes],
    (value) => view.go({ change: value }, { quiet: true }),
  );
  const kind = select(view.params.get('kind') ?? '', [['', 'as in the file'], ...kinds], (value) =>
    view.go({ kind: value as Kind }, { quiet: true }),
  );
  const go = h('button', { type: 'submit' }, 'Check');

  function show(content: string): void {
    file = null;
    pick.value = '';
    text.value = content;
    text.hidden = false;
    chosen.hidden = true;
  }
  function showFile(content: File): void {
    file = content;
    text.hidden = true;
    chosen.hidden = false;
    fill(
      chosen,
      h(
        'p',
        {},
        h('strong', {}, content.name),
        `, ${bytes(content.size)}: too long to be shown here, and checked all the same.`,
      ),
      h('button', { type: 'button', class: 'plain', onclick: () => show('') }, 'Take it away'),
    );
  }
  async function take(content: File): Promise<void> {
    view.go({ example: null, text: null, pasted: null, pair: null }, { quiet: true });
    content.size > longestShown ? showFile(content) : show(await content.text());
    await run(true);
  }

  /** The text goes into the link if it is short, else into the storage of this window. */
  async function remember(content: string): Promise<void> {
    const example = examples.find((each) => each.text === content);
    const word = example ? null : await pack(content);
    const short = word !== null && word.length <= longestWord;
    if (!example && !short) {
      keepText(content);
    }
    view.go(
      {
        example: example?.name ?? null,
        text: short ? word : null,
        kept: example || short ? null : 1,
        pasted: null,
      },
      { quiet: true },
    );
  }

  /** `asked`: the reader waits for it, and is taken to the verdict. */
  async function run(asked: boolean): Promise<void> {
    const body = file ?? text.value;
    if (typeof body === 'string' && body.trim() === '') {
      fill(
        result,
        problem(
          new Error(
            'There is nothing to check yet: paste a design, choose a file, or take one of the ' +
              'examples.',
          ),
        ),
      );
      text.focus();
      return;
    }
    running?.abort();
    const mine = (running = new AbortController());
    const stop = () => mine.abort();
    view.signal.addEventListener('abort', stop, { once: true });
    go.disabled = true;
    fill(
      result,
      h(
        'p',
        { class: 'note', role: 'status' },
        typeof body === 'string' ? 'Checking …' : `Checking ${bytes(body.size)} … `,
        h('button', { type: 'button', class: 'plain', onclick: stop }, 'Stop'),
      ),
    );
    try {
      if (typeof body === 'string') {
        await remember(body);
      }
      const report = await check(
        {
          url: address('verify', declared()),
          body,
          ...(isCopy() ? { alone: declared() } : {}),
        },
        mine.signal,
      );
      if (isCopy()) {
        await takeKeptBound(report, mine.signal);
      }
      const head = h(
        'div',
        { class: 'verify-head' },
        headline(report, asCircular(report)),
        actions(report, body),
      );
      const list = report.blocks.shown ? blockList(report, view) : defects(report);
      const mended = !report.answer.valid && report.blocks.shown;
      fill(
        result,
        !mended && head,
        h(
          'div',
          { class: mended ? 'verify-parts mended' : 'verify-parts' },
          mended ? h('div', {}, head, list) : list,
          h(
            'div',
            {},
            mended ? (isCopy() ? mendElsewhere() : mend(report, body)) : null,
            report.answer.valid && report.blocks.b > 1 && citation(report, mine.signal),
            facts(report),
            elementTable(report),
          ),
        ),
      );
    } catch (fault) {
      if (!mine.signal.aborted) {
        await showFault(fault, body);
      } else if (!view.signal.aborted && running === mine) {
        fill(result, h('p', { class: 'note' }, 'Stopped.'));
      }
    } finally {
      view.signal.removeEventListener('abort', stop);
      if (running === mine) {
        go.disabled = false;
        if (asked && !view.signal.aborted) {
          leadToResult(drop, go, result);
        }
      }
    }
  }

  function declared(): Declared {
    return { v: v.value, change: change.value, kind: kind.value };
  }

  function asCircular(report: Report): Child {
    return alsoCircular(report, () => {
      kind.value = 'circular';
      view.go({ kind: 'circular' }, { quiet: true });
      void run(true);
    });
  }

  function mend(report: Report, body: string | Blob): HTMLElement {
    const design = designOf(report);
    const { change: m, kind: way, strength } = design;
    const query = { change: m, kind: way, ...(strength ? { strength } : {}) };
    const offer = (given: Given): HTMLElement =>
      repairOffer(
        given,
        (repaired) => {
          show(asText(repaired));
          change.value = kind.value = v.value = '';
          view.go({ v: null, change: null, kind: null, example: null }, { quiet: true });
          void run(true);
        },
        (repaired) => {
          keepLocal(repaired);
          window.location.hash = link('design', { local: 1 });
        },
        view.signal,
      );
    const odd = report.answer.names_among_numbers;
    const without = odd.length > 0 ? withoutNames(design, odd) : null;
    return h(
      'div',
      {},
      without && offer({ query, ...without }),
      offer({
        query: { ...query, v: v.value },
        body,
        blocks: design.blocks,
        name: (x) => design.labels?.[x] ?? String(x),
        ...(without ? { title: `Repair with ${odd.join(' and ')}`, later: true } : {}),
      }),
    );
  }

  async function showFault(fault: unknown, body: string | Blob): Promise<void> {
    const line = fault instanceof ApiError ? fault.line : undefined;
    fill(
      result,
      h(
        'h2',
        {},
        fault instanceof ApiError && fault.status === 0
          ? 'This was not checked'
          : 'This could not be read',
      ),
      problem(fault),
      line && (await excerpt(body, line, (fault as ApiError).column)),
      line &&
        typeof body === 'string' &&
        h(
          'button',
          {
            type: 'button',
            class: 'plain',
            onclick: () => (text.focus(), text.setSelectionRange(...lineRange(text.value, line))),
          },
          `Go to line ${line} in the text`,
        ),
    );
  }

  function actions(report: Report, body: string | Blob): HTMLElement {
    const said = h('span', { role: 'status' });
    const add = h(
      'button',
      {
        type: 'button',
        class: 'plain',
        onclick: async () => {
          add.disabled = true;
          try {
            const { label, already } = await post(
              'catalog/add',
              { v: v.value, change: change.value, kind: kind.value },
              body,
              view.signal,
            );
            fill(
              said,
              already ? 'Your catalog has it already: ' : 'Added to your catalog: ',
              h('a', { href: link('design', { label }) }, label),
              '.',
            );
          } catch (fault) {
            add.disabled = false;
            fill(said, problem(fault));
          }
        },
      },
      'Add to my catalog',
    );
    const row = h(
      'div',
      { class: 'row actions' },
      report.blocks.shown &&
        report.blocks.blocks.length <= longestViewed &&
        h(
          'a',
          {
            class: 'button plain',
            href: link('design', { local: 1 }),
            onclick: () => keepLocal(designOf(report)),
          },
          'Open in the viewer',
        ),
      h(
        'a',
        {
          class: 'button plain',
          href: link('cell', {
            v: report.blocks.v,
            k: report.blocks.k,
            change: report.blocks.change,
            kind: report.blocks.kind,
            strength: report.blocks.strength === 2 ? null : report.blocks.strength,
          }),
        },
        'What is known for these parameters',
      ),
    );
    if (report.answer.valid && report.blocks.b > 1 && !isCopy()) {
      about().then(
        ({ write }) => {
          if (write && hasToken()) {
            row.append(add, said);
          } else {
            row.append(
              h(
                'span',
                { class: 'hint' },
                write
                  ? 'To add it to your catalog, open the address that changeover serve ' +
                      'printed, with its token.'
                  : 'This server was started with --no-write: it adds nothing to a catalog.',
              ),
            );
          }
        },
        () => undefined,
      );
    }
    return row;
  }

  const drop = h(
    'form',
    {
      class: 'verify-form',
      onsubmit: (event) => {
        event.preventDefault();
        view.go({ pair: null }, { quiet: true });
        void run(true);
      },
      ondragover: (event) => {
        event.preventDefault();
        drop.classList.add('over');
      },
      ondragleave: () => drop.classList.remove('over'),
      ondrop: (event) => {
        event.preventDefault();
        drop.classList.remove('over');
        const dropped = (event as DragEvent).dataTransfer?.files[0];
        if (dropped) {
          void take(dropped);
        }
      },
    },
    h('div', { class: 'verify-input' }, text, chosen),
    h(
      'div',
      { class: 'verify-options' },
      h(
        'div',
        { class: 'row' },
        go,
        h(
          'button',
          { type: 'button', class: 'plain', onclick: () => pick.click() },
          'Choose a file …',
        ),
        pick,
      ),
      h(
        'div',
        { class: 'row' },
        field('Elements v', v),
        field('Change number', change),
        field('Kind', kind),
      ),
      h(
        'p',
        { class: 'hint' },
        isCopy()
          ? [
              'One block per line, or the JSON of a design; ',
              h('code', {}, 'changeover verify'),
              ' reads more formats. ',
            ]
          : 'One block per line, JSON, CSV, GAP, Sage, designtheory.org or the La Jolla ' +
              'repository: the format is recognised. ',
        'You can drop a file here. If the text does ' +
          'not say it, the change number is that of the first step, and the design is linear.',
      ),
    ),
  );
  text.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' && (event.ctrlKey || event.metaKey)) {
      drop.requestSubmit();
    }
  });
  fill(
    view.root,
    h('h1', {}, 'Verify a design'),
    h(
      'p',
      {},
      'Is a list of blocks a change covering design, and of what quality? Every pair of ' +
        'elements must be in some block, and every step to the next block must change exactly ' +
        'm elements.',
    ),
    h(
      'p',
      { class: 'examples' },
      'Try ',
      examples
        .map(({ name, title }, i) => [
          i === 0 ? '' : ', ',
          h('a', { href: link('verify', { example: name }), onclick: chosenExample.take }, title),
        ])
        .flat(),
      '.',
    ),
    drop,
    result,
  );
  const start = await firstText(view);
  if (view.signal.aborted) {
    return;
  }
  if (start !== '') {
    show(start);
  } else if (file) {
    showFile(file);
  } else {
    fill(result, whatComes());
  }
  if (start !== '' || file) {
    await run(chosenExample.taken());
  }
}

export const verify: Page = { path: 'verify', title: 'Verify', render };
