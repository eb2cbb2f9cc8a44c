import { post, type Ordered } from '../lib/api';
import { announce, field, fill, h, select } from '../lib/dom';
import { save } from '../lib/save';
import { longestWord, pack, unpack } from '../lib/share';
import { count } from '../lib/words';
import { copyButton } from '../parts/copy';
import { link, problem, type Page, type View } from '../shell/router';
import { bytesOf } from './loadorder/naive';
import { memory, shares } from './loadorder/memory';
import { comparison, headline, jsonLines, levels, stepList, type Asked } from './loadorder/order';

/** What the page begins with. */
const usual = { items: '64', room: '16' };
const times: readonly (readonly [string, string])[] = [
  ['0', 'no search'],
  ['2', '2 seconds'],
  ['10', '10 seconds'],
  ['25', '25 seconds'],
];

function commandOf({ items, room, fastRoom, workers, pairs, seconds, prefetch }: Asked): string {
  const what = pairs ? '--pairs pairs.txt' : `--items ${items}`;
  return (
    `changeover loadorder ${what} --room ` +
    `${room}${fastRoom !== null ? ` --fast-room ${fastRoom}` : ''}` +
    `${workers > 1 ? ` --workers ${workers}` : ''}` +
    `${seconds > 0 ? ` --time ${seconds}s` : ''}${prefetch ? ' --prefetch' : ''} --json -o ` +
    `order.jsonl`
  );
}

async function render(view: View): Promise<void> {
  const { params } = view;
  const word = params.get('pairs');
  const linked = word ? await unpack(word) : null;
  if (view.signal.aborted) {
    return;
  }
  let running: AbortController | null = null;
  const items = h('input', {
    type: 'number',
    min: 1,
    value: params.get('items') ?? (params.has('pairs') ? '' : usual.items),
    placeholder: '64',
  });
  const room = h('input', {
    type: 'number',
    min: 2,
    value: params.get('room') ?? usual.room,
    placeholder: '16',
  });
  const fast = h('input', {
    type: 'number',
    min: 2,
    value: params.get('fast') ?? '',
    placeholder: 'none',
  });
  const size = h('input', {
    type: 'text',
    class: 'cost',
    value: params.get('bytes') ?? '',
    placeholder: '2 GB',
    autocomplete: 'off',
  });
  const workers = h('input', {
    type: 'number',
    min: 1,
    value: params.get('workers') ?? '',
    placeholder: '1',
  });
  // A link may ask for a time that is not in the list.
  const asks = String(Math.max(0, Number(params.get('time')) || 0));
  const time = select(
    asks,
    times.some(([seconds]) => seconds === asks) ? times : [...times, [asks, `${asks} seconds`]],
    () => undefined,
  );
  const ahead = h('input', { type: 'checkbox', checked: params.has('prefetch') });
  const pairs = h('textarea', {
    class: 'pairs-text',
    spellcheck: 'false',
    placeholder: '0 5\n1 5\n…',
  });
  pairs.value = typeof linked === 'string' ? linked : '';
  const some = h(
    'details',
    { open: pairs.value !== '' },
    h('summary', {}, 'Only some pairs'),
    field(
      'Pairs, two items a line',
      pairs,
      'items have names, or numbers from 0; with names the field Items may stay empty',
    ),
  );
  const go = h('button', { type: 'submit' }, 'Find an order');
  const result = h('div', { class: 'result' });

  function read(): Asked {
    const [p, c, w] = [Number(items.value), Number(room.value), Number(workers.value || 1)];
    const named = items.value === '' && pairs.value.trim() !== '';
    if (!named && (!Number.isInteger(p) || p < 1)) {
      throw new Error('Items: write how many there are, such as 64.');
    }
    if (room.value === '' || !Number.isInteger(c) || c < 2) {
      throw new Error(
        'Room: write how many items are in memory at once, at least 2; with less no pair ever ' +
          'meets.',
      );
    }
    const there = fast.value === '' ? null : Number(fast.value);
    if (there !== null && (!Number.isInteger(there) || there < 2 || there > c)) {
      throw new Error(
        `Accelerator: write 2 to ${c}, how many of the items in memory are on it, or ` +
          'leave it empty.',
      );
    }
    return {
      items: named ? null : p,
      room: c,
      fastRoom: there,
      workers: w,
      seconds: Number(time.value),
      prefetch: ahead.checked,
      bytesPerItem: size.value.trim() === '' ? null : bytesOf(size.value),
      pairs: pairs.value.trim() === '' ? null : pairs.value,
    };
  }

  async function run(): Promise<void> {
    running?.abort();
    const mine = (running = new AbortController());
    const stop = () => mine.abort();
    view.signal.addEventListener('abort', stop, { once: true });
    go.disabled = true;
    try {
      const asked = read();
      const packed = asked.pairs ? await pack(asked.pairs) : null;
      view.go(
        {
          items: asked.items,
          room: asked.room,
          fast: asked.fastRoom,
          bytes: size.value.trim(),
          workers: asked.workers > 1 ? asked.workers : null,
          time: asked.seconds > 0 ? asked.seconds : null,
          prefetch: asked.prefetch ? 1 : null,
          pairs: packed !== null && packed.length <= longestWord ? packed : null,
        },
        { quiet: true },
      );
      fill(
        result,
        h(
          'p',
          { class: 'note', role: 'status' },
          asked.seconds > 0
            ? `Searching for up to ${asked.seconds} s … `
            : 'Looking for an order … ',
          h('button', { type: 'button', class: 'plain', onclick: stop }, 'Stop'),
        ),
      );
      const answer = await post(
        'loadorder',
        {},
        {
          ...(asked.items !== null ? { items: asked.items } : {}),
          room: asked.room,
          ...(asked.fastRoom !== null ? { fast_room: asked.fastRoom } : {}),
          ...(asked.workers > 1 ? { workers: asked.workers } : {}),
          ...(asked.seconds > 0 ? { seconds: asked.seconds } : {}),
          ...(asked.prefetch ? { prefetch: true } : {}),
          ...(asked.bytesPerItem !== null ? { bytes_per_item: asked.bytesPerItem } : {}),
          ...(asked.pairs ? { pairs: { text: asked.pairs } } : {}),
        },
        mine.signal,
      );
      show(answer, asked);
      announce(count(answer.loads, 'load'));
    } catch (fault) {
      if (!view.signal.aborted) {
        fill(result, mine.signal.aborted ? h('p', { class: 'note' }, 'Stopped.') : problem(fault));
      }
    } finally {
      view.signal.removeEventListener('abort', stop);
      if (running === mine) {
        go.disabled = false;
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

  function show(answer: Ordered, asked: Asked): void {
    const command = commandOf(asked);
    fill(
      result,
      h(
        'div',
        { class: 'columns loadorder-parts loadorder-head' },
        headline(answer, asked),
        shares(answer, asked) ?? levels(answer, asked) ?? comparison(answer, asked),
      ),
      asked.workers > 1 && levels(answer, asked),
      memory(answer, mine()),
      h(
        'div',
        { class: 'columns loadorder-parts' },
        h('div', {}, stepList(answer)),
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
                onclick: () => save('order.jsonl', jsonLines(answer), 'application/jsonl'),
              },
              'Download JSON lines',
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
              'The command line can also search for longer (--time), take items of different size ' +
                '(--sizes) and write back what changes (--write-back).',
            ),
          ),
        ),
      ),
    );
  }

  const form = h(
    'form',
    {
      novalidate: true,
      onsubmit: (event) => {
        event.preventDefault();
        void run();
      },
    },
    h(
      'div',
      { class: 'row top' },
      field('Items', items, 'partitions, images, …'),
      field('Room', room, 'items in memory at once'),
      field('Accelerator', fast, 'so many of these on it'),
      field('Bytes per item', size, 'optional'),
      field('Workers', workers, 'each with this room'),
      field('Search', time, 'for fewer loads'),
      h(
        'div',
        { class: 'field' },
        h('span', { class: 'hint' }, '\u00a0'),
        h('label', { class: 'check ahead' }, ahead, 'Load ahead'),
        h('small', { class: 'hint' }, 'while pairs are computed'),
      ),
      h('div', { class: 'field' }, h('span', { class: 'hint' }, '\u00a0'), go),
    ),
    some,
  );
  fill(
    view.root,
    h('h1', {}, 'Load order'),
    h(
      'p',
      {},
      'Items lie on a disk, and only some fit into memory. Each pair must be in memory ' +
        'together once, to compute distances or a Gram matrix, or to train on edges between ' +
        'partitions. This page says what to load and what to evict at each step, with as few ' +
        'loads as possible. Try ',
      h(
        'a',
        { href: link('loadorder', { items: 64, room: 16, bytes: '2 GB' }) },
        '64 items, room for 16',
      ),
      ', ',
      h(
        'a',
        { href: link('loadorder', { items: 64, room: 16, fast: 4 }) },
        '4 of these on an accelerator',
      ),
      ' or ',
      h(
        'a',
        { href: link('loadorder', { items: 1000, room: 100, workers: 8 }) },
        '1000 items for 8 workers',
      ),
      '.',
    ),
    form,
    result,
  );
  await run();
}

export const loadorder: Page = { path: 'loadorder', title: 'Load order', live: true, render };
