// How fast the pages are: first contentful paint and the moment when what was asked for is drawn,
// in milliseconds; each page in a window of its own, on a server that has just started and then
// again. Medians of five.
//
//     node times.mjs
import { start } from './tests/support/browser.mjs';

// A page of one word shows what the browser and this machine take by themselves.
const nothing = 'data:text/html,<p class="word">nothing';
const pages = [
  ['A page of one word', nothing, '.word'],
  ['Start', '#/home', '.door-picture canvas.drawn'],
  ['Catalog', '#/catalog', 'table.cells tbody tr'],
  ['Cell', '#/cell?v=40&k=6&change=2&kind=circular', '.recipe-node'],
  ['Design', '#/design?v=40&k=6&change=2&kind=circular', '.block-text'],
  [
    'Design, 10,625 blocks',
    '#/design?v=253&k=4&change=1&kind=linear&show=stays',
    '.timeline-canvas',
  ],
  ['Theorems', '#/theorems', '.statement .prose p'],
  ['Plan', '#/plan', '.job-box input'],
  ['Search', '#/search?v=40&k=6&change=2&kind=circular', 'form button'],
  ['Load order', '#/loadorder?items=64&room=16', '.timeline-canvas'],
  ['Verify', '#/verify?example=good', '.verdict'],
];
const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

async function visit(explorer, place, ready) {
  const page = await explorer.context.newPage();
  // The page itself looks at the clock, once it has drawn: it may have more to do afterwards.
  await page.addInitScript((what) => {
    const look = () => {
      if (globalThis.drawnAt === undefined && document.querySelector(what)) {
        watcher.disconnect();
        globalThis.drawnAt = null;
        requestAnimationFrame(() => setTimeout(() => (globalThis.drawnAt = performance.now()), 0));
      }
    };
    const watcher = new MutationObserver(look);
    watcher.observe(document, { childList: true, subtree: true, attributes: true });
  }, ready);
  const address = place === nothing ? place : explorer.server.address + place;
  await page.goto(address, { waitUntil: 'commit' });
  await page.waitForFunction(() => typeof globalThis.drawnAt === 'number', null, {
    timeout: 60_000,
  });
  const there = await page.evaluate(() => globalThis.drawnAt);
  const paint = await page.evaluate(
    () => performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? performance.now(),
  );
  await page.close();
  return { paint, there };
}

for (const [name, fragment, ready] of pages) {
  const explorer = await start();
  const cold = await visit(explorer, fragment, ready);
  const warm = [];
  for (let i = 0; i < 5; ++i) {
    warm.push(await visit(explorer, fragment, ready));
  }
  console.log(
    `${name}: first paint ${median(warm.map(({ paint }) => paint)).toFixed(0)}, all ` +
      `${median(warm.map(({ there }) => there)).toFixed(0)}; on a server just started ` +
      `${cold.paint.toFixed(0)} and ${cold.there.toFixed(0)}`,
  );
  await explorer.stop().catch((fault) => console.log(fault.message.split('\n')[0]));
}

// Choosing another selection of the catalog, once the first one is there.
const explorer = await start();
const page = await explorer.open('#/catalog');
await page.locator('table.cells a').first().waitFor();
await page.waitForLoadState('networkidle');
for (const [change, kind] of [
  ['1', 'circular'],
  ['3', 'circular'],
  ['3', 'linear'],
  ['2', 'linear'],
  ['1', 'linear'],
]) {
  const began = Date.now();
  await page.getByLabel('Change number').selectOption(change);
  await page.getByLabel('Kind').selectOption(kind);
  await page.locator('table.cells a').first().waitFor({ timeout: 120_000 });
  await page.waitForFunction(
    ([m, k]) =>
      document
        .querySelector('table.cells a')
        ?.getAttribute('href')
        ?.includes(`change=${m}&kind=${k}`),
    [change, kind],
    { timeout: 120_000 },
  );
  console.log(`selection m = ${change}, ${kind}: ${Date.now() - began}`);
}
await page.close();
await explorer.stop();
