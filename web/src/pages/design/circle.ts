// The design on a circle, turned by its own symmetry: elements are placed so that the automorphism
// is a rotation, and the blocks of one turn are drawn; all others are their images.
import { hues } from '../../lib/colours';
import { field, fill, h, select, svg } from '../../lib/dom';
import { cyclesOf, type Symmetry } from '../../lib/symmetry';
import { count, indexed, number } from '../../lib/words';
import { theme } from '../../shell/theme';
import type { Chosen } from './selection';

/** Shorter cycles say nothing on a ring: their elements stand in columns. */
const shortestRing = 7;

/** More blocks than this on one picture are a tangle. */
const mostDrawn = 8;

/**
 * Where each element is on a picture of 600 by 600: cycles of one length share a ring, turned
 * against each other.
 */
export function places(symmetry: Symmetry): { x: number; y: number }[] {
  const cycles = cyclesOf(symmetry.map);
  const found: { x: number; y: number }[] = [];
  const rings = cycles.filter((cycle) => cycle.length > 1);
  const fixed = cycles.filter((cycle) => cycle.length === 1).flat();
  rings.forEach((cycle, ring) => {
    const radius = 272 - (rings.length > 1 ? (ring * 200) / rings.length : 0);
    cycle.forEach((x, i) => {
      const angle = (2 * Math.PI * (i + (ring % 2) / 2)) / cycle.length - Math.PI / 2;
      found[x] = { x: 300 + radius * Math.cos(angle), y: 300 + radius * Math.sin(angle) };
    });
  });
  fixed.forEach(
    (x, i) =>
      (found[x] = {
        x: 300 + (fixed.length > 1 ? 26 * Math.cos((2 * Math.PI * i) / fixed.length) : 0),
        y: 300 + (fixed.length > 1 ? 26 * Math.sin((2 * Math.PI * i) / fixed.length) : 0),
      }),
  );
  return found;
}

/** Between neighbours of a ring, or between rings. */
function leastDistance(symmetry: Symmetry, at: readonly { x: number; y: number }[]): number {
  const rings = cyclesOf(symmetry.map).filter((cycle) => cycle.length > 1);
  const neighbours = rings.map(([a, b]) =>
    Math.hypot(at[a!]!.x - at[b!]!.x, at[a!]!.y - at[b!]!.y),
  );
  return Math.min(200 / rings.length, ...neighbours);
}

/**
 * `wide`: how many pixels it is shown wide, if that is little. Elements are larger then, and have
 * names only where these can be read.
 */
export function circlePicture(
  symmetry: Symmetry,
  blocks: readonly (readonly number[])[],
  names: (x: number) => string,
  drawn: readonly number[],
  lit: readonly number[],
  wide = 600,
): SVGElement {
  const at = places(symmetry);
  const colours = hues(mostDrawn, theme());
  const marks: SVGElement[] = [];
  drawn.forEach((index, i) => {
    const block = blocks[index]!;
    const centre = {
      x: block.reduce((sum, x) => sum + at[x]!.x, 0) / block.length,
      y: block.reduce((sum, x) => sum + at[x]!.y, 0) / block.length,
    };
    const around = [...block].sort(
      (a, b) =>
        Math.atan2(at[a]!.y - centre.y, at[a]!.x - centre.x) -
        Math.atan2(at[b]!.y - centre.y, at[b]!.x - centre.x),
    );
    const polygon = svg('polygon', {
      points: around.map((x) => `${at[x]!.x.toFixed(1)},${at[x]!.y.toFixed(1)}`).join(' '),
      class: 'circle-block',
      stroke: colours[i % colours.length]!,
      fill: colours[i % colours.length]!,
    });
    polygon.append(svg('title', {}, `Block ${index + 1}: ${block.map(names).join(', ')}`));
    marks.push(polygon);
  });
  const inSome = new Set(drawn.flatMap((index) => blocks[index]!));
  const pixel = 600 / wide;
  const r = Math.min(Math.max(14, 13 * pixel), 0.45 * leastDistance(symmetry, at));
  // No smaller than can be read, if it is not too wide for its circle then.
  const size = wide >= 600 ? 0.93 * r : Math.max(0.93 * r, 8.5 * pixel);
  const longest = Math.max(...at.map((_, x) => names(x).length));
  const named = size <= 0.93 * r || 0.6 * size * longest <= 2 * r;
  const outside = Math.max(0, r + 2 * pixel - 28);
  at.forEach((place, x) => {
    marks.push(
      svg(
        'g',
        {
          class: `circle-point${lit.includes(x) ? ' lit' : inSome.has(x) ? ' in' : ''}`,
          'data-x': x,
        },
        svg('circle', { cx: place.x.toFixed(1), cy: place.y.toFixed(1), r: r.toFixed(1) }),
        ...(named
          ? [
              svg(
                'text',
                {
                  x: place.x.toFixed(1),
                  y: (place.y + 0.355 * size).toFixed(1),
                  'font-size': size.toFixed(1),
                },
                names(x),
              ),
            ]
          : []),
      ),
    );
  });
  const side = 600 + 2 * outside;
  return svg(
    'svg',
    {
      viewBox: `${-outside} ${-outside} ${side} ${side}`,
      class: 'circle-picture',
      role: 'img',
      'aria-label': `Elements on a circle; ${drawn.length} blocks of one turn`,
    },
    ...marks,
  );
}

/** How wide a cell of a line is, in pixels. */
const cellWidth = 46;

/** Whether the longest cycle is too short for a circle. */
export const hasShortCycles = (symmetry: Symmetry): boolean =>
  (cyclesOf(symmetry.map)[0]?.length ?? 0) < shortestRing;

/**
 * A line for each cycle, an element beside the next: the automorphism moves each one place on. The
 * cycles are columns, or rows where these are too many for the width. Fixed elements stand last.
 */
function orbits(
  symmetry: Symmetry,
  block: readonly number[],
  names: (x: number) => string,
  lit: readonly number[],
  wide: number,
): HTMLElement {
  const cycles = cyclesOf(symmetry.map);
  const moved = cycles.filter((cycle) => cycle.length > 1);
  const fixed = cycles.filter((cycle) => cycle.length === 1).flat();
  const columns = Array.from({ length: moved[0]?.length ?? 0 }, (_, i) =>
    moved.map((cycle) => cycle[i]),
  );
  const lines = wide > 0 && wide < moved.length * cellWidth ? moved : columns;
  const inBlock = new Set(block);
  const cell = (x: number | undefined): HTMLElement => {
    if (x === undefined) {
      return h('td', { class: 'none' });
    }
    const words = [inBlock.has(x) ? 'in' : '', lit.includes(x) ? 'lit' : ''].filter(Boolean);
    return h('td', { class: words.join(' ') || null, 'data-x': x }, names(x));
  };
  return h(
    'table',
    { class: 'orbits' },
    h('caption', { class: 'unseen' }, 'Cycle by cycle; elements of the block are filled'),
    h(
      'tbody',
      {},
      lines.map((line) => h('tr', {}, line.map(cell))),
      fixed.length > 0 && h('tr', { class: 'fixed' }, fixed.map(cell)),
    ),
  );
}

export function circleView(
  symmetry: Symmetry,
  chosen: Chosen,
  panel: HTMLElement,
  signal: AbortSignal,
): void {
  const { blocks } = chosen.design;
  const { shift, rotations, map } = symmetry;
  let turn = 0;
  const short = hasShortCycles(symmetry);
  let which = shift <= mostDrawn && !short ? 'all' : '0';
  const place = h('div', {
    class: 'circle-place',
    onclick: (event) => {
      const point = (event.target as Element).closest<SVGElement>('[data-x]');
      if (point) {
        chosen.toggle(Number(point.dataset['x']));
      }
    },
  });
  const said = h('p', { class: 'circle-says', role: 'status' });
  const named = (x: number): string => indexed(chosen.name(x));
  const cycles = cyclesOf(map).filter((cycle) => cycle.length > 1);
  const shape =
    cycles.length === 0
      ? ''
      : [...new Set(cycles.map((cycle) => cycle.length))]
          .map((length) =>
            count(
              cycles.filter((cycle) => cycle.length === length).length,
              `cycle of length ${length}`,
              `cycles of length ${length}`,
            ),
          )
          .join(', ');
  const fixed = map.reduce((sum, y, x) => sum + (x === y ? 1 : 0), 0);

  let wide = 0;
  const sizes = new ResizeObserver(() => {
    if (place.clientWidth !== wide) {
      wide = place.clientWidth;
      draw();
    }
  });
  sizes.observe(place);
  signal.addEventListener('abort', () => sizes.disconnect());

  function draw(): void {
    const base = which === 'all' ? Array.from({ length: shift }, (_, i) => i) : [Number(which)];
    const drawn = base.map((i) => i + turn * shift);
    fill(
      place,
      short
        ? orbits(symmetry, blocks[drawn[0]!]!, named, chosen.elements, wide)
        : (circlePicture(
            symmetry,
            blocks,
            named,
            drawn,
            chosen.elements,
            Math.min(600, wide || 600),
          ) as unknown as Node),
    );
    const [first, last] = [number(drawn[0]! + 1), number(drawn.at(-1)! + 1)];
    const shown = drawn.length === 1 ? `block ${first}` : `blocks ${first} to ${last}`;
    fill(said, `Turn ${turn + 1} of ${number(rotations)}: ${shown}.`);
  }
  const step = (by: number): void => {
    turn = (turn + by + rotations) % rotations;
    draw();
  };
  const options: [string, string][] = [
    ...(shift <= mostDrawn && !short ? ([['all', `all ${shift}`]] as [string, string][]) : []),
    ...Array.from({ length: Math.min(shift, 200) }, (_, i): [string, string] => [
      String(i),
      String(i + 1),
    ]),
  ];
  chosen.follow(signal, draw);
  document.addEventListener('themechange', draw, { signal });
  fill(
    panel,
    h(
      'div',
      { class: short ? 'circle-view short' : 'circle-view' },
      h(
        'div',
        {},
        h(
          'p',
          { class: 'hint' },
          (short
            ? 'The elements, cycle by cycle; those of the block are filled. To move each one place on ' +
              'along its cycle, the last to the first, is an automorphism: '
            : 'A rotation of the picture by one place is an automorphism: ') +
            `it maps every block to the one ${count(shift, 'place')} later. ` +
            `${shift === 1 ? 'One block makes' : `${number(shift)} base blocks make`} all ` +
            `${number(blocks.length)} in ${number(rotations)} turns; on the elements: ` +
            `${shape}${fixed > 0 ? `, ${count(fixed, 'fixed point')}` : ''}.`,
        ),
        h(
          'div',
          { class: 'row' },
          shift > 1 &&
            field(
              'Base block',
              select(which, options, (value) => {
                which = value;
                draw();
              }),
            ),
          h(
            'div',
            { class: 'row tight' },
            h(
              'button',
              {
                type: 'button',
                class: 'plain',
                'aria-label': 'Turn back',
                onclick: () => step(-1),
              },
              '↺',
            ),
            h(
              'button',
              { type: 'button', class: 'plain', 'aria-label': 'Turn on', onclick: () => step(1) },
              '↻',
            ),
          ),
          said,
        ),
      ),
      place,
    ),
  );
  draw();
}
