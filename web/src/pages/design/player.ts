// Stepping through a design: the memory of k slots, who enters and leaves, and which pairs have met
// so far.
import type { Design } from '../../lib/api';
import { fill, h, scroll, select } from '../../lib/dom';
import { count, number, percent, setWord, setsOf } from '../../lib/words';
import { busyKey } from '../../parts/fields';
import { coverage } from './coverage';
import type { Chosen } from './selection';
import type { Sets } from './sets';
import { Steps } from './steps';

const speeds: readonly (readonly [string, string])[] = [
  ['1', '1/s'],
  ['3', '3/s'],
  ['10', '10/s'],
  ['30', '30/s'],
  ['200', '200/s'],
];

/** More new sets than that are not named. */
const mostSets = 20;
/** So many blocks are seen beside each other. */
const seen = 6;

interface Options {
  /** The block to begin with, from 1. */
  at: number;
  speed: string;
  signal: AbortSignal;
  chosen: Chosen;
  /** Called a moment after the block or the speed has changed. */
  moved(at: number, speed: string): void;
}

/** Fills `panel` with the player. `sets`: what must meet, where it is more than pairs. */
export function openPlayer(
  panel: HTMLElement,
  steps: Steps,
  sets: Sets | null,
  design: Design,
  options: Options,
): void {
  fill(panel, player(steps, sets, design, options));
}

function player(steps: Steps, sets: Sets | null, design: Design, options: Options): HTMLElement {
  const strength = design.strength ?? 2;
  const [one, several] = [setWord(strength), setsOf(strength)];
  /** How many sets have met after so many blocks; null: they are too many to be counted. */
  const metAfter = sets?.met ?? (strength === 2 ? steps.pairs : null);
  const all = sets?.all ?? steps.allPairs;
  const b = steps.b;
  const circular = design.kind === 'circular';
  const { chosen } = options;
  let at = Math.min(b, Math.max(1, options.at));
  let speed = speeds.some(([each]) => each === options.speed) ? options.speed : '3';
  let playing = false;
  let timer = 0;
  let note = 0;

  const map = coverage(steps, sets);
  const pair = h('div', { class: 'pair' }, '\u00a0');
  map?.element.addEventListener(
    'pointermove',
    (event) => (pair.textContent = map.pairAt(event) || '\u00a0'),
  );
  map?.element.addEventListener('click', (event) => {
    const place = map.elementsAt(event);
    if (place) {
      chosen.choose(place.every((x) => chosen.elements.includes(x)) ? [] : place);
    }
  });
  map?.element.addEventListener('pointerleave', () => (pair.textContent = '\u00a0'));
  // Many slots are drawn small, below the words, so that the words keep their place.
  const many = design.k > 24;
  const slots = h('ol', {
    class: many ? 'slots many' : 'slots',
    'aria-label': 'Memory: the block, slot by slot',
  });
  const words = h('div', { class: 'step-words' });
  const around = h('tbody');
  const met = h('p', { class: 'met' });
  const bar = h('progress', {
    max: all || 1,
    value: 0,
    'aria-label': `${several[0]!.toUpperCase()}${several.slice(1)} that have met`,
  });
  const slider = h('input', {
    type: 'range',
    min: 1,
    max: b,
    value: at,
    step: 1,
    'aria-label': 'Block',
    oninput: () => go(Number(slider.value)),
  });
  const where = h('input', {
    type: 'number',
    min: 1,
    max: b,
    value: at,
    'aria-label': 'Number of the block',
    onchange: () => go(Number(where.value) || 1),
  });
  const button = (sign: string, label: string, keys: string, act: () => void): HTMLButtonElement =>
    h(
      'button',
      {
        type: 'button',
        class: 'plain',
        'aria-label': label,
        title: `${label} (${keys})`,
        onclick: act,
      },
      sign,
    );
  const first = button('«', 'First block', 'Home', () => go(1));
  const back = button('‹', 'Block before', '←', () => go(at - 1));
  const play = button('Play', 'Play', 'space', () => toggle());
  const next = button('›', 'Next block', '→', () => go(at + 1));
  const last = button('»', 'Last block', 'End', () => go(b));
  play.classList.remove('plain');
  play.classList.add('play');

  /** The sets that first meet in this block, by names. */
  function freshSets(): string[] {
    if (sets) {
      return sets.fresh(at).map((set) => set.map((x) => steps.names[x]).join('–\u2060'));
    }
    const block = [...steps.block(at)];
    return block.flatMap((x, i) =>
      block
        .slice(i + 1)
        .flatMap((y) =>
          steps.first![x * steps.v + y] === at ? [`${steps.names[x]}–\u2060${steps.names[y]}`] : [],
        ),
    );
  }

  /** A block as a row, each element in its slot. */
  function rowOf(n: number): HTMLElement {
    const { slots: memory, entered } = steps.step(n);
    return h(
      'tr',
      { class: n === at ? 'own' : null, 'aria-current': n === at ? 'step' : null },
      h(
        'th',
        { scope: 'row' },
        h(
          'button',
          { type: 'button', class: 'as-link', tabindex: -1, onclick: () => go(n) },
          number(n),
        ),
      ),
      [...memory].map((x) =>
        h(
          'td',
          {
            class:
              [n > 1 && entered.includes(x) ? 'in' : '', chosen.elements.includes(x) ? 'lit' : '']
                .join(' ')
                .trim() || null,
          },
          x < 0 ? '' : steps.names[x]!,
        ),
      ),
    );
  }

  function show(): void {
    const { slots: memory, entered, left } = steps.step(at);
    const isNew = new Set(entered);
    // Who left a slot stands below who took it, in the order in which both were found.
    const gone = at > 1 ? steps.step(at - 1).slots : null;
    const focused = [...slots.children].findIndex((each) => each.contains(document.activeElement));
    fill(
      slots,
      [...memory].map((element, i) => {
        const before = gone?.[i] ?? -1;
        const entering = element >= 0 && isNew.has(element) && at > 1;
        const lit = chosen.elements.includes(element);
        return h(
          'li',
          {
            class:
              `${element < 0 ? 'empty' : entering ? 'entering' : 'staying'}` +
              `${lit ? ' lit' : ''}`,
          },
          element < 0
            ? h('span', { class: 'name' })
            : h(
                'button',
                {
                  type: 'button',
                  class: 'name',
                  'aria-pressed': String(lit),
                  onclick: () => chosen.toggle(element),
                },
                steps.names[element]!,
              ),
          h(
            'span',
            { class: 'gone' },
            before >= 0 && before !== element ? h('del', {}, steps.names[before]!) : '\u00a0',
          ),
        );
      }),
    );
    if (focused >= 0) {
      slots.children[focused]?.querySelector('button')?.focus();
    }
    const list = (elements: number[]): string =>
      elements.map((each) => steps.names[each]).join(', ') || 'none';
    const fresh = metAfter ? metAfter[at]! - metAfter[at - 1]! : null;
    fill(
      words,
      h(
        'p',
        { class: 'block-text' },
        `Block ${number(at)} of ${number(b)}: `,
        h(
          'span',
          { class: 'code' },
          `{${[...steps.block(at)].map((each) => steps.names[each]).join(', ')}}`,
        ),
      ),
      at === 1
        ? h(
            'p',
            {},
            'The first block: all its elements come in.',
            circular && ' As the design is circular, it also follows the last one.',
          )
        : h(
            'p',
            {},
            h('span', { class: 'in' }, `Introduced: ${list(entered)}`),
            ' · ',
            h('span', { class: 'out' }, `leaving: ${list(left)}`),
            ` · unchanged: ${steps.block(at).length - entered.length}`,
          ),
      fresh !== null &&
        h(
          'p',
          {},
          `${count(fresh, one)} ${fresh === 1 ? 'meets' : 'meet'} for the first time here`,
          fresh > 0 && fresh <= mostSets && (sets || steps.first)
            ? `: ${freshSets().join(', ')}.`
            : '.',
        ),
    );
    if (!many) {
      const top = Math.max(1, Math.min(at - 2, b - seen + 1));
      fill(
        around,
        Array.from({ length: Math.min(seen, b) }, (_, i) => rowOf(top + i)),
      );
    }
    if (metAfter) {
      const done = metAfter[at]!;
      bar.value = done;
      fill(
        met,
        h('strong', {}, number(done)),
        ` of ${number(all)} ${several} have met (${percent(done, all)})`,
      );
    }
    map?.show(at);
    slider.value = String(at);
    slider.setAttribute('aria-valuetext', `block ${at} of ${b}`);
    if (document.activeElement !== where) {
      where.value = String(at);
    }
    for (const [button, off] of [
      [first, at === 1],
      [back, at === 1],
      [next, at === b],
      [last, at === b],
    ] as const) {
      off ? button.setAttribute('aria-disabled', 'true') : button.removeAttribute('aria-disabled');
    }
  }

  function go(n: number): void {
    const to = Math.min(b, Math.max(1, Math.round(n)));
    if (to !== at) {
      at = to;
      show();
    }
    remember();
  }

  function remember(): void {
    window.clearTimeout(note);
    note = window.setTimeout(
      () => !options.signal.aborted && options.moved(at, speed),
      playing ? 1000 : 150,
    );
  }

  function toggle(): void {
    playing = !playing;
    play.textContent = playing ? 'Pause' : 'Play';
    play.setAttribute('aria-label', playing ? 'Pause' : 'Play');
    if (playing) {
      if (at === b) {
        go(1);
      }
      let then = performance.now();
      let owed = 0;
      const tick = (now: number): void => {
        if (!playing || options.signal.aborted) {
          return;
        }
        owed += ((now - then) * Number(speed)) / 1000;
        then = now;
        const whole = Math.floor(Math.min(owed, b));
        if (whole > 0) {
          owed -= whole;
          // Fast play steps over blocks in one picture, but counts them all.
          go(at + whole);
        }
        if (at === b) {
          toggle();
        } else {
          timer = requestAnimationFrame(tick);
        }
      };
      timer = requestAnimationFrame(tick);
    } else {
      cancelAnimationFrame(timer);
      remember();
    }
  }

  const keys: Record<string, () => void> = {
    ArrowLeft: () => go(at - 1),
    ArrowRight: () => go(at + 1),
    Home: () => go(1),
    End: () => go(b),
    ' ': toggle,
  };
  document.addEventListener(
    'keydown',
    (event) => {
      const act = keys[event.key];
      const press = event.key === ' ' ? ', button, a, summary' : '';
      if (act && !event.shiftKey && !busyKey(event, press)) {
        event.preventDefault();
        if (playing && event.key !== ' ') {
          toggle();
        }
        act();
      }
    },
    { signal: options.signal },
  );
  document.addEventListener('themechange', () => map?.recolour(), { signal: options.signal });
  options.signal.addEventListener('abort', () => {
    playing = false;
    cancelAnimationFrame(timer);
    window.clearTimeout(note);
  });

  chosen.follow(options.signal, () => {
    show();
    map?.light(chosen.elements);
  });
  show();
  map?.light(chosen.elements);
  return h(
    'div',
    { class: 'player' },
    h(
      'div',
      { class: 'player-left' },
      h(
        'div',
        { class: 'transport', role: 'group', 'aria-label': 'Steps' },
        first,
        back,
        play,
        next,
        last,
        where,
        h('span', { class: 'hint' }, `of ${number(b)}`),
        h(
          'label',
          { class: 'speed' },
          'Speed ',
          select(speed, speeds, (value) => {
            speed = value;
            remember();
          }),
        ),
      ),
      slider,
      many ? null : slots,
      words,
      metAfter
        ? [met, bar]
        : h('p', { class: 'hint' }, `There are too many ${several} to be counted in a page.`),
      many
        ? slots
        : scroll(
            'Blocks before and after',
            h(
              'table',
              { class: 'around-blocks' },
              h('caption', {}, 'Blocks before and after; bold is introduced'),
              around,
            ),
          ),
    ),
    map
      ? h(
          'figure',
          { class: 'player-map' },
          map.element,
          h(
            'figcaption',
            { class: 'hint' },
            'A square for each pair of elements. ',
            h('span', { class: 'key key-anew' }),
            sets ? ` in a ${one} that first meets in this block, ` : ' meets in this block, ',
            h('span', { class: 'key key-met' }),
            sets ? ` all ${several} with the pair have met; paler: some, ` : ' has met, ',
            h('span', { class: 'key key-not' }),
            sets ? ' none.' : ' not yet.',
            pair,
          ),
        )
      : h('p', { class: 'hint' }, 'The map of pairs is drawn for up to 512 elements.'),
  );
}
