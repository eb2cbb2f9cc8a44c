// What is asked of an order of loads: the usual fields, and the rest in groups that open.
import { field, fill, h, select } from '../../lib/dom';
import { longestWord, pack, unpack } from '../../lib/share';
import { count, number } from '../../lib/words';
import { group } from '../../parts/group';
import { more } from '../../parts/more';
import { problem } from '../../shell/router';
import { bytesOf } from './naive';
import type { Asked } from './order';

/** What the page begins with. */
const usual = { items: '64', room: '16' };
const times: readonly (readonly [string, string])[] = [
  ['0', 'no search'],
  ['2', '2 seconds'],
  ['10', '10 seconds'],
  ['25', '25 seconds'],
];
/** Longer texts that a link has packed. */
const texts = ['pairs', 'sizes'] as const;

export interface LoadForm {
  readonly element: HTMLElement;
  readonly go: HTMLButtonElement;
  /** @throws Error with a line that can be shown. */
  read(): Asked;
  /** What the link says of it. */
  linked(asked: Asked): Promise<Record<string, string | number | null>>;
  /** Writes how long is searched, one of the times that are offered. */
  searchFor(seconds: number): void;
  /** Says what is wrong with a field beside it; false if it is not of a field. */
  fault(why: unknown): boolean;
  clear(): void;
}

const lines = (text: string): number =>
  text.split('\n').filter((line) => line.trim() !== '' && !line.trim().startsWith('#')).length;

/** What is wrong with a field. */
class Misread extends Error {
  constructor(
    message: string,
    readonly control: HTMLElement,
  ) {
    super(message);
  }
}

/** The form as the link fills it. */
export async function loadForm(params: URLSearchParams, submitted: () => void): Promise<LoadForm> {
  const given = Object.fromEntries(
    await Promise.all(
      texts.map(async (name) => {
        const word = params.get(name);
        const text = word ? await unpack(word) : null;
        return [name, typeof text === 'string' ? text : ''] as const;
      }),
    ),
  );
  const whole = (name: string, least: number, placeholder: string, value?: string) =>
    h('input', {
      type: 'number',
      min: least,
      value: params.get(name) ?? value ?? '',
      placeholder,
      oninput: touched,
    });
  const size = (name: string, placeholder: string) =>
    h('input', {
      type: 'text',
      class: 'cost',
      value: params.get(name) ?? '',
      placeholder,
      autocomplete: 'off',
      oninput: touched,
    });
  const list = (name: (typeof texts)[number], placeholder: string) => {
    const area = h('textarea', {
      class: 'pairs-text',
      spellcheck: 'false',
      placeholder,
      oninput: touched,
    });
    area.value = given[name]!;
    return area;
  };

  const isNamed = params.has('pairs') || params.has('sizes');
  const items = whole('items', 1, '64', isNamed ? '' : usual.items);
  const room = whole('room', 2, '16', usual.room);
  const fast = whole('fast', 2, 'none');
  const each = size('bytes', '2 GB');
  const workers = whole('workers', 1, '1');
  // A link may ask for a time that is not in the list.
  const asks = String(Math.max(0, Number(params.get('time')) || 0));
  const time = select(
    asks,
    times.some(([seconds]) => seconds === asks) ? times : [...times, [asks, `${asks} seconds`]],
    () => undefined,
  );
  const ahead = h('input', { type: 'checkbox', checked: params.has('prefetch') });
  const pairs = list('pairs', '0 5\n1 5\n…');
  const sizes = list('sizes', '0 2 GB\n1 500 MB\n…');
  const memory = size('memory', '16 GB');
  const fastMemory = size('fastmemory', 'none');
  const epochs = whole('epochs', 1, '1');
  const disjoint = h('input', {
    type: 'checkbox',
    checked: params.has('disjoint'),
    onchange: touched,
  });
  const go = h('button', { type: 'submit' }, 'Find an order');
  const others = more(
    'options',
    ['fast', 'bytes', 'time', 'prefetch', 'epochs', 'disjoint', ...texts].some((name) =>
      params.has(name),
    ),
  );

  const groups = [
    group(
      'Only some pairs',
      () => (lines(pairs.value) === 0 ? '' : count(lines(pairs.value), 'pair')),
      field(
        'Pairs, two items a line',
        pairs,
        'items have names, or numbers from 0; with names the field Items may stay empty',
      ),
    ),
    group(
      'Items that differ in size',
      () => (lines(sizes.value) === 0 ? '' : count(lines(sizes.value), 'size')),
      field(
        'Sizes, an item and its bytes a line',
        sizes,
        'or the bytes of items 0, 1, … in turn; the field Items may stay empty',
      ),
      h(
        'div',
        { class: 'row top' },
        field('Memory', memory, 'bytes in memory at once, in place of Room'),
        field('Memory of an accelerator', fastMemory, 'bytes that fit on it at once'),
      ),
    ),
    group(
      'Several epochs',
      () => (Number(epochs.value) > 1 ? `${number(Number(epochs.value))} epochs` : ''),
      field(
        'Epochs',
        epochs,
        'every pair meets in each of them, back and forth: what is in memory at the end of one ' +
          'stays for the next',
      ),
    ),
    group(
      'Items that change',
      () => (disjoint.checked ? 'no item at two workers' : ''),
      h(
        'label',
        { class: 'check' },
        disjoint,
        'Workers step together and never hold one item twice, so that items may change',
      ),
      h('p', { class: 'hint' }, 'For two workers or more; it does not go with Load ahead.'),
    ),
  ];
  function touched(): void {
    groups.forEach((every) => every.refresh());
    // Of items with sizes the bytes count.
    const sized = lines(sizes.value) > 0;
    [room, fast, each].forEach((control) => (control.disabled = sized));
  }
  groups[0]!.element.open = lines(pairs.value) > 0;
  groups[1]!.element.open = lines(sizes.value) > 0;
  touched();

  /** Opens what has the field, so that what is said of it can be mended. */
  function wrong(control: HTMLElement, words: string): Error {
    const folded = control.closest('details');
    if (folded) {
      folded.open = true;
    }
    others.open(true);
    return new Misread(words, control);
  }

  function readSizes(): Pick<Asked, 'sizes' | 'memory' | 'fastMemory'> {
    if (lines(sizes.value) === 0) {
      if (memory.value.trim() !== '' || fastMemory.value.trim() !== '') {
        throw wrong(sizes, 'Memory: bytes count if items differ in size; write the sizes, too.');
      }
      return { sizes: null, memory: null, fastMemory: null };
    }
    if (memory.value.trim() === '') {
      throw wrong(memory, 'Memory: write how many bytes are in memory at once, such as 16 GB.');
    }
    const inBytes = sizes.value.replace(
      /(\d+(?:\.\d+)?)[ \t]*([kmgt]i?b?)[ \t]*$/gim,
      (_, value: string, unit: string) => String(bytesOf(value + unit)),
    );
    return {
      sizes: inBytes,
      memory: bytesOf(memory.value),
      fastMemory: fastMemory.value.trim() === '' ? null : bytesOf(fastMemory.value),
    };
  }

  function read(): Asked {
    const [p, c, w] = [Number(items.value), Number(room.value), Number(workers.value || 1)];
    const sized = readSizes();
    const named = items.value === '' && (pairs.value.trim() !== '' || sized.sizes !== null);
    if (!named && (!Number.isInteger(p) || p < 1)) {
      throw wrong(items, 'Items: write how many there are, such as 64.');
    }
    if (sized.sizes === null && (room.value === '' || !Number.isInteger(c) || c < 2)) {
      throw wrong(
        room,
        'Room: write how many items are in memory at once, at least 2; with less no pair ever ' +
          'meets.',
      );
    }
    const there = fast.value === '' || sized.sizes !== null ? null : Number(fast.value);
    if (there !== null && (!Number.isInteger(there) || there < 2 || there > c)) {
      throw wrong(
        fast,
        `Accelerator: write 2 to ${c}, how many of the items in memory are on it, or ` +
          'leave it empty.',
      );
    }
    const times = Number(epochs.value || 1);
    if (!Number.isInteger(times) || times < 1) {
      throw wrong(epochs, 'Epochs: write how many there are, such as 10, or leave it empty.');
    }
    if (disjoint.checked && w < 2) {
      throw wrong(disjoint, 'Items that change: write how many workers share them, at least 2.');
    }
    return {
      ...sized,
      items: named ? null : p,
      room: c,
      fastRoom: there,
      workers: w,
      seconds: Number(time.value),
      prefetch: ahead.checked,
      bytesPerItem: each.value.trim() === '' || sized.sizes !== null ? null : bytesOf(each.value),
      pairs: pairs.value.trim() === '' ? null : pairs.value,
      epochs: times,
      disjoint: disjoint.checked,
    };
  }

  async function linked(asked: Asked): Promise<Record<string, string | number | null>> {
    const packed = async (text: string | null): Promise<string | null> => {
      const word = text === null ? null : await pack(text);
      return word !== null && word.length <= longestWord ? word : null;
    };
    const sized = asked.sizes !== null;
    return {
      items: asked.items,
      room: sized ? null : asked.room,
      fast: asked.fastRoom,
      bytes: sized ? null : each.value.trim(),
      workers: asked.workers > 1 ? asked.workers : null,
      time: asked.seconds > 0 ? asked.seconds : null,
      prefetch: asked.prefetch ? 1 : null,
      pairs: await packed(asked.pairs),
      sizes: await packed(sized ? sizes.value : null),
      memory: sized ? memory.value.trim() : null,
      fastmemory: sized ? fastMemory.value.trim() : null,
      epochs: asked.epochs > 1 ? asked.epochs : null,
      disjoint: asked.disjoint ? 1 : null,
    };
  }

  const said = h('div', { class: 'misread' });
  function clear(): void {
    fill(said);
    [items, room, fast, memory, sizes, epochs, disjoint].forEach((each) =>
      each.removeAttribute('aria-invalid'),
    );
  }
  function fault(why: unknown): boolean {
    if (!(why instanceof Misread)) {
      return false;
    }
    const { control } = why;
    fill(said, problem(why));
    (control.closest('.row') ?? control.closest('.field') ?? control).after(said);
    control.setAttribute('aria-invalid', 'true');
    control.focus();
    return true;
  }
  const element = h(
    'form',
    {
      class: 'loads-form',
      novalidate: true,
      onsubmit: (event) => {
        event.preventDefault();
        submitted();
      },
    },
    h(
      'div',
      { class: 'row top' },
      field('Items', items, 'partitions, images, …'),
      field('Room', room, 'items in memory at once'),
      field('Workers', workers, 'each with this room'),
      others.element,
      field('Accelerator', fast, 'items on it at once'),
      field('Bytes per item', each, 'optional'),
      field('Search', time, 'for fewer loads'),
      h(
        'div',
        { class: 'field' },
        h('span', { class: 'hint' }, '\u00a0'),
        h('label', { class: 'check ahead' }, ahead, 'Load ahead'),
        h('small', { class: 'hint' }, 'while pairs are computed'),
      ),
      h('div', { class: 'field always' }, h('span', { class: 'hint' }, '\u00a0'), go),
    ),
    h(
      'div',
      { class: 'groups' },
      groups.map((every) => every.element),
    ),
  );
  const searchFor = (seconds: number): void => {
    time.value = String(seconds);
  };
  return { element, go, read, linked, searchFor, fault, clear };
}
