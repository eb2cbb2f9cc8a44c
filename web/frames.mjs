// How smoothly the pages move: the times between frames while a pointer, a wheel or a key moves
// what a page draws, as the browser's own clock has them. Of each: how many frames there were, the
// middle one, the longest of twenty, the longest, how many took more than 50 ms, and the longest
// task of the page, all in milliseconds.
//
//     node frames.mjs [WORDS]        only what has these words in its name
import { readFileSync } from 'node:fs';
import { start } from './tests/support/browser.mjs';

const large = '#/design?v=253&k=4&change=1&kind=linear';
const moves = 60;

/** A pointer goes through these corners of an element, in shares of its size. */
async function along(page, element, corners, { pressed = false } = {}) {
  const box = await element.boundingBox();
  const at = ([x, y]) => [box.x + x * box.width, box.y + y * box.height];
  await page.mouse.move(...at(corners[0]));
  if (pressed) {
    await page.mouse.down();
  }
  const legs = corners.length - 1;
  for (let i = 1; i <= moves; ++i) {
    const leg = Math.min(legs - 1, Math.floor((i / moves) * legs));
    const share = (i / moves) * legs - leg;
    const [one, other] = [at(corners[leg]), at(corners[leg + 1])];
    await page.mouse.move(
      one[0] + share * (other[0] - one[0]),
      one[1] + share * (other[1] - one[1]),
    );
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  if (pressed) {
    await page.mouse.up();
  }
}

/** The wheel with Ctrl, in and out again. */
async function wheel(page, element) {
  const box = await element.boundingBox();
  await page.mouse.move(box.x + 0.6 * box.width, box.y + 0.6 * box.height);
  await page.keyboard.down('Control');
  for (let i = 0; i < moves; ++i) {
    await page.mouse.wheel(0, i < moves / 2 ? -60 : 60);
    await page.evaluate(() => new Promise(requestAnimationFrame));
  }
  await page.keyboard.up('Control');
}

const zigzag = [
  [0.2, 0.2],
  [0.9, 0.4],
  [0.3, 0.8],
  [0.8, 0.9],
];
const tab = (page, name) => page.getByRole('tab', { name }).click();
const over = (which) => async (page) => along(page, page.locator(which), zigzag);
const dragged = (which) => async (page) =>
  along(
    page,
    page.locator(which),
    [
      [0.8, 0.7],
      [0.3, 0.4],
      [0.8, 0.6],
    ],
    { pressed: true },
  );
const turned = (which) => async (page) => wheel(page, page.locator(which));
const closer = (which, times) => async (page) => {
  await page.locator(which).focus();
  for (let i = 0; i < times; ++i) {
    await page.keyboard.press('+');
  }
};

/** Name, page, what is waited for, what comes before and what is measured. */
const all = [
  ['Catalog, pointing', '#/catalog', '.atlas-canvas', null, over('.atlas-canvas')],
  ['Catalog, wheel', '#/catalog', '.atlas-canvas', null, turned('.atlas-canvas')],
  [
    'Catalog, panning with numbers in the cells',
    '#/catalog',
    '.atlas-canvas',
    closer('.atlas-canvas', 3),
    dragged('.atlas-canvas'),
  ],
  [
    'Design, steps, holding the arrow key',
    `${large}&show=steps`,
    '.block-text',
    null,
    async (page) => {
      for (let i = 0; i < moves; ++i) {
        await page.keyboard.press('ArrowRight');
        await page.evaluate(() => new Promise(requestAnimationFrame));
      }
    },
  ],
  [
    'Design, steps, dragging the slider',
    `${large}&show=steps`,
    '.block-text',
    null,
    async (page) =>
      along(
        page,
        page.getByRole('slider', { name: 'Block' }),
        [
          [0.01, 0.5],
          [0.99, 0.5],
        ],
        { pressed: true },
      ),
  ],
  [
    'Design, pointing at pairs in Steps',
    `${large}&show=steps`,
    '.coverage-over',
    null,
    over('.coverage-over'),
  ],
  [
    'Design, stays, pointing',
    `${large}&show=stays`,
    '.timeline-canvas',
    null,
    over('.timeline-canvas'),
  ],
  [
    'Design, stays, wheel',
    `${large}&show=stays`,
    '.timeline-canvas',
    null,
    turned('.timeline-canvas'),
  ],
  [
    'Design, stays, panning',
    `${large}&show=stays`,
    '.timeline-canvas',
    closer('.timeline-canvas', 4),
    dragged('.timeline-canvas'),
  ],
  [
    'Design, coverage, pointing',
    `${large}&show=coverage`,
    '.matrix-canvas',
    null,
    over('.matrix-canvas'),
  ],
  [
    'Design, coverage, pointing where numbers are',
    `${large}&show=coverage`,
    '.matrix-canvas',
    closer('.matrix-canvas', 8),
    over('.matrix-canvas'),
  ],
  [
    'Design, coverage, wheel',
    `${large}&show=coverage`,
    '.matrix-canvas',
    null,
    turned('.matrix-canvas'),
  ],
  ['Design, opening Coverage', large, '.block-text', null, (page) => tab(page, 'Coverage')],
  ['Design, opening Stays', large, '.block-text', null, (page) => tab(page, 'Stays')],
  ['Design, opening Array', large, '.block-text', null, (page) => tab(page, 'Array')],
  ['Design, opening Blocks', large, '.block-text', null, (page) => tab(page, 'Blocks')],
  [
    'Design, choosing an element beside Blocks',
    `${large}&show=blocks`,
    'pre.blocks',
    null,
    async (page) => {
      await page.getByRole('textbox', { name: 'Select an element or a pair' }).fill('7');
      await page.keyboard.press('Enter');
    },
  ],
];

const load = () => readFileSync('/proc/loadavg', 'utf8').split(' ')[0];
const words = process.argv[2] ?? '';
const explorer = await start();
for (const [name, fragment, ready, before, act] of all.filter(([name]) => name.includes(words))) {
  const page = await explorer.open(fragment);
  await page.locator(ready).first().waitFor({ timeout: 60_000 });
  await page.waitForLoadState('networkidle');
  await before?.(page);
  await page.waitForTimeout(500);
  await page.evaluate(() => {
    const seen = (globalThis.seen = { frames: [], tasks: [], ends: false });
    seen.watcher = new PerformanceObserver((list) =>
      seen.tasks.push(...list.getEntries().map(({ duration }) => duration)),
    );
    seen.watcher.observe({ entryTypes: ['longtask'] });
    let then = performance.now();
    const look = () => {
      const now = performance.now();
      seen.frames.push(now - then);
      then = now;
      if (!seen.ends) {
        requestAnimationFrame(look);
      }
    };
    requestAnimationFrame(look);
  });
  await act(page);
  await page.waitForTimeout(400);
  const { frames, tasks } = await page.evaluate(() => {
    globalThis.seen.ends = true;
    return { frames: globalThis.seen.frames, tasks: globalThis.seen.tasks };
  });
  const sorted = [...frames].sort((a, b) => a - b);
  const at = (share) => sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))];
  console.log(
    `${name}: ${frames.length} frames, ${at(0.5).toFixed(0)}, ${at(0.95).toFixed(0)}, ` +
      `${at(1).toFixed(0)}; above 50 ms ${frames.filter((each) => each > 50).length}; ` +
      `longest task ${Math.max(0, ...tasks).toFixed(0)}; load ${load()}`,
  );
  await page.close();
}
await explorer.stop();
