import { post, type Ordered } from '../lib/api';
import { announce, fill, h } from '../lib/dom';
import { save } from '../lib/save';
import { count, number } from '../lib/words';
import { copyButton } from '../parts/copy';
import { chosenExample, leadToResult } from '../parts/lead';
import { link, problem, type Page, type View } from '../shell/router';
import { loadForm } from './loadorder/form';
import { memory, shares } from './loadorder/memory';
import { comparison, headline, jsonLines, levels, stepList, type Asked } from './loadorder/order';

function commandOf(asked: Asked): string {
  const { fastRoom, fastMemory, bytesPerItem, workers, epochs, seconds } = asked;
  const words = [
    'changeover loadorder',
    asked.pairs && '--pairs pairs.txt',
    asked.items !== null && !asked.pairs && `--items ${asked.items}`,
    asked.sizes === null ? `--room ${asked.room}` : `--sizes sizes.txt --memory ${asked.memory}`,
    fastRoom !== null && `--fast-room ${fastRoom}`,
    fastMemory !== null && `--fast-memory ${fastMemory}`,
    bytesPerItem !== null && `--item-bytes ${bytesPerItem}`,
    workers > 1 && `--workers ${workers}`,
    asked.disjoint && '--disjoint',
    epochs > 1 && `--epochs ${epochs}`,
    seconds > 0 && `--time ${seconds}s`,
    asked.prefetch && '--prefetch',
    '--json -o order.jsonl',
  ];
  return words.filter(Boolean).join(' ');
}

/** The request of it. */
function requestOf(asked: Asked): Record<string, unknown> {
  const { items, fastRoom, bytesPerItem } = asked;
  return {
    ...(items !== null ? { items } : {}),
    ...(asked.sizes === null
      ? { room: asked.room }
      : { sizes: { text: asked.sizes }, memory: asked.memory }),
    ...(fastRoom !== null ? { fast_room: fastRoom } : {}),
    ...(asked.fastMemory !== null ? { fast_memory: asked.fastMemory } : {}),
    ...(asked.workers > 1 ? { workers: asked.workers } : {}),
    ...(asked.disjoint ? { disjoint: true } : {}),
    ...(asked.epochs > 1 ? { epochs: asked.epochs } : {}),
    ...(asked.seconds > 0 ? { seconds: asked.seconds } : {}),
    ...(asked.prefetch ? { prefetch: true } : {}),
    ...(bytesPerItem !== null ? { item_bytes: bytesPerItem } : {}),
    ...(asked.pairs ? { pairs: { text: asked.pairs } } : {}),
  };
}

async function render(view: View): Promise<void> {
  const form = await loadForm(view.params, () => void run(true));
  if (view.signal.aborted) {
    return;
  }
  const { go } = form;
  let running: AbortController | null = null;
  const said = h('div', { class: 'load-said' });
  const result = h('div', { class: 'result load-result' });
  /** What the order that is shown answers, and its loads. */
  let shown: { question: string; loads: number } | null = null;

  /** `waited`: the reader asked for it, and is taken to the answer. */
  async function run(waited: boolean): Promise<void> {
    running?.abort();
    const mine = (running = new AbortController());
    const stop = () => mine.abort();
    view.signal.addEventListener('abort', stop, { once: true });
    go.disabled = true;
    let misread = false;
    let waiting: ReturnType<typeof setInterval> | undefined;
    try {
      form.clear();
      const asked = form.read();
      view.go(await form.linked(asked), { quiet: true });
      const question = JSON.stringify({ ...asked, seconds: 0 });
      const before = shown?.question === question ? shown.loads : null;
      const bar = h('progress', {
        max: Math.max(1, asked.seconds),
        value: 0,
        'aria-label': 'Time',
      });
      const note = h(
        'p',
        { class: 'note searching', role: 'status' },
        asked.seconds > 0
          ? `Searching for up to ${asked.seconds} s for fewer loads${before === null ? '' : ` than ${number(before)}`} … `
          : 'Looking for an order … ',
        asked.seconds > 0 && bar,
        h('button', { type: 'button', class: 'plain', onclick: stop }, 'Stop'),
      );
      fill(said, note);
      // The order that is there stays, as long as it answers the same question.
      before === null ? fill(result) : result.classList.add('old');
      result.inert = before !== null;
      waiting = setInterval(() => (bar.value += 0.5), 500);
      const answer = await post('loadorder', {}, requestOf(asked), mine.signal);
      show(answer, asked, asked.seconds > 0 ? before : null);
      fill(said);
      shown = { question, loads: answer.order.makespan ?? answer.loads };
      announce(count(answer.loads, 'load'));
    } catch (fault) {
      if (!view.signal.aborted) {
        misread = form.fault(fault);
        const words = mine.signal.aborted ? h('p', { class: 'note' }, 'Stopped.') : problem(fault);
        fill(said, misread ? null : words);
      }
    } finally {
      clearInterval(waiting);
      view.signal.removeEventListener('abort', stop);
      if (running === mine) {
        result.classList.remove('old');
        result.inert = false;
        go.disabled = false;
        if (waited && !misread && !view.signal.aborted) {
          leadToResult(form.element, go, result);
        }
      }
    }
  }

  /** Each answer's drawings end when the next is there. */
  let drawing = new AbortController();
  view.signal.addEventListener('abort', () => drawing.abort());
  function mine(): AbortSignal {
    drawing.abort();
    drawing = new AbortController();
    return drawing.signal;
  }

  function show(answer: Ordered, asked: Asked, before: number | null): void {
    const command = commandOf(asked);
    const steps = stepList(answer);
    fill(
      result,
      h(
        'div',
        { class: 'columns loadorder-parts loadorder-head' },
        headline(answer, asked, (seconds) => (form.searchFor(seconds), void run(true)), before),
        shares(answer, asked) ?? levels(answer, asked) ?? comparison(answer, asked),
      ),
      asked.workers > 1 && levels(answer, asked),
      memory(answer, mine(), steps.goTo),
      h(
        'div',
        { class: 'columns loadorder-parts' },
        h('div', {}, steps.element),
        h(
          'div',
          {},
          h(
            'section',
            {},
            h('h2', {}, 'The order as a file'),
            h(
              'button',
              {
                type: 'button',
                class: 'plain',
                disabled: answer.truncated,
                'aria-describedby': answer.truncated ? 'not-all-steps' : null,
                onclick: () => save('order.jsonl', jsonLines(answer), 'application/jsonl'),
              },
              'Download JSON lines',
            ),
            answer.truncated &&
              h(
                'p',
                { id: 'not-all-steps', class: 'hint' },
                `Only ${number(answer.steps.length)} of ${number(answer.step_count)} steps are ` +
                  'here; the command below writes all of them to a file.',
              ),
          ),
          h(
            'section',
            {},
            h('h2', {}, 'On the command line'),
            h(
              'div',
              { class: 'command' },
              h('code', { tabindex: 0 }, command),
              copyButton('Copy', () => command),
            ),
            h(
              'p',
              { class: 'hint' },
              'The command line can also search for longer (--time), weigh what pairs cost ' +
                '(--pair-cost) and write back what changes (--write-back).',
            ),
          ),
        ),
      ),
    );
  }

  fill(
    view.root,
    h('h1', {}, 'Load order'),
    h(
      'p',
      {},
      'Items lie on a disk, and only some fit into memory. Every two items must be in memory ' +
        'together at some time, to compute distances or a Gram matrix, or to train on edges between ' +
        'partitions. This page says what to load and what to evict at each step, with as few ' +
        'loads as possible. Try ',
      h(
        'a',
        {
          href: link('loadorder', { items: 64, room: 16, bytes: '2 GB' }),
          onclick: chosenExample.take,
        },
        '64 items, room for 16',
      ),
      ', ',
      h(
        'a',
        {
          href: link('loadorder', { items: 64, room: 16, fast: 4 }),
          onclick: chosenExample.take,
        },
        '4 on an accelerator',
      ),
      ' or ',
      h(
        'a',
        {
          href: link('loadorder', { items: 1000, room: 100, workers: 8 }),
          onclick: chosenExample.take,
        },
        '1000 items for 8 workers',
      ),
      '.',
    ),
    form.element,
    said,
    result,
  );
  await run(chosenExample.taken());
}

export const loadorder: Page = { path: 'loadorder', title: 'Load order', live: true, render };
