// The server's pictures of a design: which, in which order of elements, of which blocks.
import type { Design } from '../../lib/api';
import { field, fill, h, picture, select } from '../../lib/dom';
import { draw, type Asked, type DrawQuery, type PictureName } from '../../lib/source';
import { number } from '../../lib/words';
import { problem, type View } from '../../shell/router';
import { theme } from '../../shell/theme';

/** So many blocks at once: more are slow to draw and to look through. */
function pageOf(k: number): number {
  return Math.max(10, Math.min(100, Math.floor(2000 / k)));
}

const orders: readonly (readonly [string, string])[] = [
  ['first', 'of first blocks'],
  ['stays', 'of numbers of stays'],
  ['given', 'as numbered'],
];

const captions: Record<PictureName, string> = {
  array: 'Blocks as columns, as the field prints them: an element keeps its row as long as it stays, and a star marks those that are introduced.',
  stays: 'A row for each element, a bar for each stay: from the block where it is introduced to the one where it leaves.',
  circle: 'Elements on a circle: base blocks and their differences if the design is developed under a rotation, else blocks with the pairs that they newly cover.',
  coverage: 'A square for each pair of elements: below the diagonal the block of their first meeting, above it how often they are newly covered when that is not once.',
  recipe: 'The tree of constructions.',
};

export function drawn(name: PictureName, asked: Asked, design: Design, view: View, panel: HTMLElement, signal: AbortSignal): void {
  const b = design.blocks.length;
  const page = pageOf(design.k);
  const paged = name === 'array' || name === 'stays';
  const ordered = name === 'stays' || name === 'coverage';
  const wanted = (param: string, otherwise: number): number => {
    const value = Number(view.params.get(param));
    return Number.isInteger(value) && value >= 1 && value <= b ? value : otherwise;
  };
  let from = wanted('from', 1);
  let to = Math.max(from, wanted('to', Math.min(b, from + page - 1)));
  let order = view.params.get('order') ?? 'first';
  let asking = new AbortController();
  signal.addEventListener('abort', () => asking.abort());

  const place = h('div', { class: `picture scroll ${name}`, tabindex: 0, role: 'region', 'aria-label': `Picture: ${name}` });
  const first = h('input', { type: 'number', min: 1, max: b, onchange: () => range(Number(first.value), to) });
  const last = h('input', { type: 'number', min: 1, max: b, onchange: () => range(from, Number(last.value)) });
  const earlier = h('button', { type: 'button', class: 'plain', onclick: () => range(from - (to - from + 1), from - 1) }, '← earlier');
  const later = h('button', { type: 'button', class: 'plain', onclick: () => range(to + 1, to + (to - from + 1)) }, 'later →');
  let svg = '';
  const save = h('a', {
    class: 'button plain small',
    href: '#',
    download: `${design.label ?? `${design.v}.${design.k}.${design.change}.${design.kind}.${b}`}.${name}.svg`,
    onclick: () => {
      save.href = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
    },
  }, 'Save this picture');
  save.hidden = true;

  function range(low: number, high: number): void {
    const length = Math.max(0, Math.min(b - 1, high - low));
    from = Math.min(b, Math.max(1, Math.round(low) || 1));
    to = Math.min(b, Math.max(from, Math.round(Math.max(high, from + (low < 1 ? length : 0))) || b));
    view.go({ from: from === 1 ? null : from, to: to === Math.min(b, from + page - 1) ? null : to }, { quiet: true });
    void show();
  }

  async function show(): Promise<void> {
    asking.abort();
    asking = new AbortController();
    const mine = asking.signal;
    first.value = String(from);
    last.value = String(to);
    earlier.disabled = from === 1;
    later.disabled = to === b;
    place.setAttribute('aria-busy', 'true');
    const query: DrawQuery = { picture: name, theme: theme(), ...(ordered ? { order } : {}), ...(paged ? { from, to } : {}) };
    try {
      const text = await draw(asked, query, mine);
      if (text === null) {
        fill(place, h('p', { class: 'note' }, 'A static copy has no pictures of single designs. On a machine of your own ', h('code', {}, `changeover draw ${design.label ?? `${design.v} ${design.k}`} --picture ${name} -o picture.svg`), ' draws this one, and ', h('code', {}, 'changeover serve'), ' shows them all.'));
      } else {
        svg = text;
        const image = picture(text);
        const width = image.viewBox.baseVal.width || Number(image.getAttribute('width')) || 0;
        image.style.setProperty('--width', `${width}px`);
        fill(place, image);
        save.hidden = false;
      }
    } catch (fault) {
      if (!mine.aborted) {
        fill(place, problem(fault));
        save.hidden = true;
      }
    }
    if (!mine.aborted) {
      place.removeAttribute('aria-busy');
    }
  }

  fill(
    panel,
    h('p', { class: 'hint' }, captions[name]),
    h(
      'div',
      { class: 'row picture-controls' },
      ordered && field('Order of elements', select(order, orders, (value) => {
        order = value;
        view.go({ order: value === 'first' ? null : value }, { quiet: true });
        void show();
      })),
      paged && b > 1 && [field('From block', first), field(`to, of ${number(b)}`, last), b > page && h('div', { class: 'row tight' }, earlier, later)].filter((each) => each !== false),
      save,
    ),
    place,
  );
  document.addEventListener('themechange', () => void show(), { signal });
  void show();
}
