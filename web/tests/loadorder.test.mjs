// The page of load orders.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { look, program, settled } from './support/browser.mjs';
import { inSight, phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

const steps = (page) => page.getByRole('list', { name: /^The .* steps$/ }).getByRole('listitem');

test('what is missing is said', async (explorer) => {
  const page = await explorer.open('#/loadorder');
  // It begins with an example.
  await page.getByRole('heading', { name: /loads in/ }).waitFor();
  assert.equal(await page.getByRole('spinbutton', { name: 'Items' }).inputValue(), '64');
  await page.getByRole('spinbutton', { name: 'Items' }).fill('');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('write how many there are').waitFor();
  await page.getByRole('spinbutton', { name: 'Items' }).fill('20');
  await page.getByRole('spinbutton', { name: 'Room' }).fill('1');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('at least 2').waitFor();
  const room = page.getByRole('spinbutton', { name: 'Room' });
  assert.ok(await room.evaluate((it) => it === document.activeElement));
  assert.equal(await room.getAttribute('aria-invalid'), 'true');
  await page.getByRole('spinbutton', { name: 'Room' }).fill('5');
  await page.getByRole('textbox', { name: 'Bytes per item' }).fill('2 boxes');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('“2 boxes” is not a size').waitFor();
  await look(page, 'loadorder-fault');
});

test('strip and timeline have one scale, however few or many steps there are', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=20&room=8&workers=3');
  await page.getByRole('combobox', { name: 'Worker', exact: true }).selectOption('0');
  const tip = page.locator('.timeline .atlas-tip');
  const canvas = page.locator('.timeline-canvas');
  /** What the timeline has below the middle of a step of the strip. */
  const below = async (step, steps) => {
    const { width } = await page.locator('.timeline-strip').boundingBox();
    await canvas.hover({ position: { x: 64 + ((step - 0.5) / steps) * (width - 72), y: 28 } });
    return /step (\d+)/.exec(await tip.textContent())?.[1];
  };
  await canvas.waitFor();
  for (const step of [1, 4, 8]) {
    assert.equal(await below(step, 8), String(step));
  }
  await page.setViewportSize({ width: 390, height: 844 });
  await page.waitForFunction(() => document.querySelector('.timeline-canvas').clientWidth < 390);
  assert.equal(await below(8, 8), '8', 'also in a window of another size');
  await page.setViewportSize({ width: 1280, height: 900 });
  await page.goto(page.url().replace(/#.*/, '#/loadorder?items=64&room=16'));
  await page.getByText(/loads in \d+ steps/).waitFor();
  const steps = Number(
    /in (\d+) steps/.exec(await page.getByRole('heading', { name: /loads in/ }).textContent())[1],
  );
  assert.equal(await below(steps, steps), String(steps));
});

test('a phone shows every item of a step', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=64&room=16&workers=3');
  await page.setViewportSize({ width: 390, height: 844 });
  const row = steps(page).first();
  await row.locator('strong').waitFor();
  await page.waitForFunction(() => document.querySelector('.virtual .line.long'));
  const cut = await row.evaluate((line) => {
    const words = document.createRange();
    words.selectNodeContents(line);
    const [text, frame] = [words, line.closest('.virtual')].map((each) =>
      each.getBoundingClientRect(),
    );
    return text.right > frame.right || text.bottom > line.getBoundingClientRect().bottom + 1;
  });
  assert.equal(cut, false, 'the first step has all its items in sight');
  assert.equal((await row.locator('strong').textContent()).split(' ').length, 16);
});

test('an answer that was cut short says so', async (explorer) => {
  const page = await explorer.open('#/loadorder');
  await page.getByText('independent checker').waitFor();
  assert.equal(await page.getByText('The time was up').count(), 0);
  await page.route('**/api/loadorder*', async (route) => {
    const response = await route.fetch();
    await route.fulfill({ response, json: { ...(await response.json()), time_is_up: true } });
  });
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByText('The time was up').waitFor();
});

test('twelve items, room for four: the fewest loads, beside simple orders', async (explorer) => {
  const page = await explorer.open('#/loadorder');
  await page.getByRole('spinbutton', { name: 'Items' }).fill('12');
  await page.getByRole('spinbutton', { name: 'Room' }).fill('4');
  await page.getByRole('textbox', { name: 'Bytes per item' }).fill('2 GB');
  await page.getByRole('textbox', { name: 'Bytes per item' }).press('Enter');
  await page.getByRole('heading', { name: '24 loads in 21 steps' }).waitFor();
  await page.getByText('no order has fewer', { exact: false }).first().waitFor();
  await page.getByText('48.0 GB are read').waitFor();
  // 3 stay and 9, 6, 3 pass: 12 + 9 + 6 + 3 loads; 2 stay: 12 + 10 + … + 2; pair by pair: 12 · 11.
  const loads = async (name) =>
    await page
      .getByRole('row', { name: new RegExp(`^${name}`) })
      .getByRole('cell')
      .first()
      .textContent();
  assert.equal(await loads('lower bound'), '24');
  assert.equal(await loads('block nested loops'), '30');
  assert.equal(await loads('halves'), '42');
  assert.equal(await loads('pair by pair'), '132');
  assert.equal(await steps(page).count(), 21);
  assert.match(await steps(page).first().textContent(), /load \d+ \d+ \d+ \d+/);
  assert.match(new URL(page.url()).hash, /items=12&room=4&bytes=2\+GB/);
  await page.locator('.timeline-canvas').waitFor();
  const [, ...words] = (await page.locator('.command code').textContent())
    .replace('order.jsonl', '-')
    .split(' ');
  const lines = String(execFileSync(program, words));
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download JSON lines' }).click(),
  ]);
  assert.equal(
    readFileSync(await download.path(), 'utf8'),
    lines,
    'the command line writes the same file',
  );
  await look(page, 'loadorder-twelve');
  await page.reload();
  await settled(page);
  await page.getByRole('heading', { name: '24 loads in 21 steps' }).waitFor();
});

test('the steps bring all pairs together, and come as JSON lines', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=12&room=4');
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download JSON lines' }).click(),
  ]);
  const [first, ...rest] = readFileSync(await download.path(), 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  assert.equal(first.loads, 24);
  const memory = new Set();
  const met = new Set();
  let loads = 0;
  for (const { load, evict } of rest) {
    evict.forEach((item) => assert.ok(memory.delete(item)));
    loads += load.length;
    load.forEach((item) => memory.add(item));
    assert.ok(memory.size <= 4);
    for (const one of memory) {
      for (const other of memory) {
        one < other && met.add(`${one} ${other}`);
      }
    }
  }
  assert.equal(met.size, 66);
  assert.equal(loads, 24);
});

/** Letters and digits of a reason, as it is said or as it is set. */
const letters = (text) =>
  text
    .normalize('NFKD')
    .replace(/[Σ∑]|ceil|C(?=\()|docs.theorems.md/g, '')
    .replace(/[^\p{L}\p{N}]/gu, '');

/** Opens a page and its reasons: what they say, and the order that the server sent. */
async function reasonsOf(explorer, at) {
  const page = await explorer.open('#/loadorder?items=3&room=2');
  await page.getByRole('heading', { name: /loads in/ }).waitFor();
  const answers = page.waitForResponse(/api.loadorder/);
  await page.goto(page.url().replace(/#.*/, at));
  const { order } = await (await answers).json();
  const why = page.locator('details', { hasText: 'Why not fewer' });
  await page.getByRole('heading', { name: new RegExp(`^${order.loads} loads in`) }).waitFor();
  await why.locator('summary').click();
  await page.waitForFunction(() => document.querySelectorAll('.verdict .math.plain').length === 0);
  const said = (await why.locator('p:not(.last-step)').allTextContents()).map(letters);
  return { page, order, why, said };
}

test('the reason is that of the number that is shown, with formulas and links', async (explorer) => {
  const one = await reasonsOf(explorer, '#/loadorder?items=64&room=16');
  assert.deepEqual(one.said, [letters(one.order.lower_bound_reason)]);
  const { order } = one;
  const [room, after] = [16, order.lower_bound - 16];
  await one.why
    .getByText(`takes 16 loads, each of the ${after} after it at least one: ${room} + ${after} = `)
    .waitFor();
  assert.ok((await one.why.locator('math').count()) > 0);
  await one.why.getByRole('link', { name: 'Theorem 5' }).waitFor();
  await one.page.close();
  // Of the busiest worker, and then of all together.
  const three = await reasonsOf(explorer, '#/loadorder?items=64&room=16&workers=3');
  assert.equal(three.said[0], letters(three.order.makespan_bound_reason));
  assert.ok(three.said[1].endsWith(letters(three.order.lower_bound_reason)));
  await three.page.getByText(`one worker has at least ${three.order.makespan_bound}`).waitFor();
});

test('a place kept for what loads: what is compared has that place free, too', async (explorer) => {
  const { page, order, said } = await reasonsOf(explorer, '#/loadorder?items=20&room=6&prefetch=1');
  assert.equal(order.order_room, 5);
  assert.ok(order.order_bound > order.lower_bound);
  await page.getByText(/no order for the other 5 has fewer/).waitFor();
  await page.getByText(`there the bound is ${order.lower_bound}`).waitFor();
  assert.ok(said[0].endsWith(letters(order.order_bound_reason)));
  const first = (name) =>
    page
      .getByRole('row', { name: new RegExp(`^${name}`) })
      .getByRole('cell')
      .first()
      .textContent();
  assert.equal(await first('lower bound'), String(order.order_bound));
  // 4 stay and 20, 16, 12, 8, 4 pass.
  assert.equal(await first('block nested loops'), '60');
  await look(page, 'loadorder-kept');
});

test('the steps begin with those of the worker that is looked at', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=1000&room=100&workers=8');
  const list = page.getByRole('group', { name: /^The \d+ steps$/ });
  await list.waitFor({ timeout: 60_000 });
  assert.ok(await page.getByRole('button', { name: 'Download JSON lines' }).isEnabled());
  for (const worker of ['2', '7', '0']) {
    await page.getByLabel('Worker', { exact: true }).selectOption(worker);
    await page.waitForFunction((worker) => {
      const frame = document.querySelector('.virtual').getBoundingClientRect();
      const rows = [...document.querySelectorAll('.virtual .line')];
      const top = rows.find((row) => row.getBoundingClientRect().bottom > frame.top + 4);
      return top?.querySelector('.block-number').textContent === `${worker} · 1`;
    }, worker);
  }
});

test('workers share the pairs', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=30&room=6&workers=3');
  await page.getByText('For 3 workers; the busiest has').waitFor();
  await page.getByText('Worker · step').waitFor();
  await page.getByText('--workers 3').waitFor();
  const shares = page.getByRole('region', { name: 'Loads and pairs of each worker' });
  assert.equal(await shares.locator('tbody tr').count(), 3);
  const pairs = (await shares.locator('tbody tr td:nth-of-type(3)').allTextContents()).map(Number);
  assert.equal(
    pairs.reduce((sum, each) => sum + each, 0),
    (30 * 29) / 2,
  );
  await page.getByLabel('Worker', { exact: true }).selectOption('2');
  await page.locator('.timeline-canvas').focus();
  await page.keyboard.press('ArrowDown');
  await page.locator('.selected', { hasText: /is loaded \d+ time/ }).waitFor();
  await look(page, 'loadorder-workers');
});

test('two levels: what both move, stays on each, loads that start early', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=24&room=12');
  await page.getByRole('heading', { name: /loads in/ }).waitFor();
  await page.getByRole('spinbutton', { name: 'Accelerator' }).fill('13');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('write 2 to 12').waitFor();
  await page.getByRole('spinbutton', { name: 'Accelerator' }).fill('4');
  await page.getByRole('checkbox', { name: 'Load ahead' }).check();
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByText('4 of them on an accelerator').waitFor();
  await page.getByText(/\d+ of \d+ loads start in a step before/).waitFor();
  const table = page.getByRole('region', { name: 'What both levels move' });
  const moves = async (name) =>
    Number(
      await table
        .getByRole('row', { name: new RegExp(`^${name}`) })
        .getByRole('cell')
        .first()
        .textContent(),
    );
  assert.ok((await moves('disk')) >= 24);
  assert.ok((await moves('memory')) > (await moves('disk')));
  await page.getByLabel('Level', { exact: true }).selectOption('accelerator');
  await page.locator('.timeline-canvas').waitFor();
  await page
    .locator('.block', { hasText: /transfer \d+/ })
    .first()
    .waitFor();
  assert.match(new URL(page.url()).hash, /room=12&fast=4/);
  await page.locator('.command code', { hasText: '--room 12 --fast-room 4 --prefetch' }).waitFor();
  await look(page, 'loadorder-levels');
  await phone(page, 'loadorder-levels');
});

test('loads ahead, and a search', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=20&room=6&prefetch=1&time=2');
  await page
    .getByText(/\d+ of 190 pairs are computed while items load/)
    .waitFor({ timeout: 60_000 });
  await page.getByText('Searched for 2 s').waitFor();
  await page.locator('.command code', { hasText: '--time 2s --prefetch' }).waitFor();
  await page
    .getByText(/pairs meanwhile/)
    .first()
    .waitFor();
});

test('only some pairs: they are in the link', async (explorer) => {
  const page = await explorer.open('#/loadorder', { mayFail: /status of 422/ });
  await page.getByText('Only some pairs').click();
  await page.getByRole('spinbutton', { name: 'Items' }).fill('6');
  await page.getByRole('spinbutton', { name: 'Room' }).fill('2');
  const pairs = page.getByRole('textbox', { name: /^Pairs/ });
  await pairs.fill('0 1\n1 9\n');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page
    .getByRole('alert')
    .getByText('pairs:2:3: item 9 does not exist; items are 0 to 5')
    .waitFor();
  await pairs.fill('0 1\n1 2\n# the end\n2 3\n');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('heading', { name: '4 loads' }).waitFor();
  const other = await explorer.open(new URL(page.url()).hash);
  await other.getByRole('heading', { name: '4 loads' }).waitFor();
  await other.getByRole('textbox', { name: /^Pairs/ }).fill('cat dog\ndog "big ape"\n');
  await other.getByRole('spinbutton', { name: 'Items' }).fill('');
  await other.getByRole('button', { name: 'Find an order' }).click();
  await other.getByText('2 pairs of 3 items').waitFor();
  await other.locator('.load', { hasText: 'big ape' }).waitFor();
  await look(other, 'loadorder-names');
});

test('items that differ in size, and epochs, are folded until wanted', async (explorer) => {
  const page = await explorer.open('#/loadorder', { mayFail: /status of 422/ });
  const sizes = page.getByRole('textbox', { name: /^Sizes/ });
  assert.ok(await sizes.isHidden());
  await page.getByText('Items that differ in size').click();
  await sizes.fill('a 3 GB\nb 4GB\nc 5 GB\nd 500 MB\n');
  assert.ok(await page.getByRole('spinbutton', { name: 'Room' }).isDisabled());
  await page.getByRole('spinbutton', { name: 'Items' }).fill('');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('write how many bytes are in memory').waitFor();
  const memory = page.getByRole('textbox', { name: 'Memory', exact: true });
  await memory.fill('8 GB');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('items b and c have 9000000000 bytes').waitFor();
  await memory.fill('10 GB');
  await page.getByText('Several epochs').click();
  await page.getByRole('spinbutton', { name: 'Epochs' }).fill('2');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByText('All 6 pairs of 4 items in each of 2 epochs, with 10.0 GB').waitFor();
  await page.getByText(/GB are read; less/).waitFor();
  await page.getByText(/loads in the first epoch, \d+ in the other/).waitFor();
  await page.getByText('epoch 2 begins').waitFor();
  await page
    .locator('.command code', { hasText: '--sizes sizes.txt --memory 10000000000 --epochs 2' })
    .waitFor();
  await look(page, 'loadorder-sizes');
  const loads = await page.getByRole('heading', { name: /loads in/ }).textContent();
  const other = await explorer.open(new URL(page.url()).hash);
  await other.getByRole('heading', { name: loads }).waitFor();
  assert.equal(
    await other.getByRole('textbox', { name: 'Memory', exact: true }).inputValue(),
    '10 GB',
  );
  await phone(other, 'loadorder-sizes');
});

test('workers that never hold one item twice', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=24&room=4');
  await page.getByRole('heading', { name: /loads in/ }).waitFor();
  await page.getByText('Items that change').click();
  await page.getByRole('checkbox', { name: /^Workers step together/ }).check();
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('write how many workers share them').waitFor();
  await page.getByRole('spinbutton', { name: 'Workers' }).fill('3');
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByText('For 3 workers that step together and never hold one item twice').waitFor();
  await page.locator('.command code', { hasText: '--workers 3 --disjoint' }).waitFor();
  assert.match(new URL(page.url()).hash, /workers=3.*disjoint=1/);
  // At no step two of them hold one item.
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download JSON lines' }).click(),
  ]);
  const [, ...steps] = readFileSync(await download.path(), 'utf8')
    .trim()
    .split('\n')
    .map((line) => JSON.parse(line));
  const held = [new Set(), new Set(), new Set()];
  for (let i = 0; i < steps.length; i += 3) {
    const together = steps.slice(i, i + 3);
    together.forEach(({ worker, evict }) => evict.forEach((item) => held[worker].delete(item)));
    together.forEach(({ worker, load }) => load.forEach((item) => held[worker].add(item)));
    const all = held.flatMap((items) => [...items]);
    assert.equal(new Set(all).size, all.length);
  }
});

test('a long order: the list to its end, the rest on the command line', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=700&room=20');
  await page.getByText('These are the first 10 000').waitFor({ timeout: 60_000 });
  const list = page.getByRole('group', { name: 'The 10 000 steps' });
  await list.focus();
  await page.keyboard.press('End');
  await page.locator('.block-number', { hasText: /^10\s000$/ }).waitFor();
  const download = page.getByRole('button', { name: 'Download JSON lines' });
  assert.ok(await download.isDisabled());
  const why = await download.getAttribute('aria-describedby');
  await page
    .locator(`#${why}`, { hasText: /^Only 10\s000 of \d\d\s\d{3} steps are here/ })
    .waitFor();
  await look(page, 'loadorder-long');
});

test('on a phone nothing scrolls sideways but the frames', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=64&room=16&bytes=2+GB');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.locator('.timeline-canvas').waitFor();
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await phone(page, 'loadorder');
});

test('on a phone what few need comes on demand, and at a fault', async (explorer) => {
  const page = await explorer.open('#/loadorder', { mayFail: /status of 422/ });
  await page.setViewportSize({ width: 390, height: 844 });
  const [fast, epochs] = ['Accelerator', 'Epochs'].map((name) =>
    page.getByRole('spinbutton', { name, includeHidden: true }),
  );
  const more = page.getByRole('button', { name: /^(More|Fewer) options$/ });
  assert.equal(await more.getAttribute('aria-expanded'), 'false');
  assert.ok(await fast.isHidden());
  assert.ok(await page.getByText('Several epochs').isHidden());
  await more.click();
  await fast.waitFor();
  await page.getByText('Several epochs').click();
  await epochs.fill('0');
  await more.click();
  await epochs.waitFor({ state: 'hidden' });
  await page.getByRole('button', { name: 'Find an order' }).click();
  await page.getByRole('alert').getByText('Epochs').waitFor();
  await epochs.waitFor();
  assert.equal(await more.getAttribute('aria-expanded'), 'true');
  // What a link asks for is in sight.
  const other = await explorer.open('#/loadorder?items=20&room=5&fast=3');
  await other.setViewportSize({ width: 390, height: 844 });
  await other.getByRole('spinbutton', { name: 'Accelerator' }).waitFor();
});

test('on a phone the answer comes into sight when it was asked for', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=20&room=5');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const answer = page.locator('.result h2').first();
  await answer.waitFor();
  assert.equal(await page.evaluate(() => window.scrollY), 0, 'a link is read from its top');
  for (const act of [
    () => page.getByRole('button', { name: 'Find an order' }).click(),
    () => page.getByRole('link', { name: '64 items, room for 16' }).click(),
  ]) {
    await page.evaluate(() => (document.activeElement.blur(), window.scrollTo(0, 0)));
    await act();
    await page.waitForFunction(() => document.activeElement?.matches('.result h2'));
    assert.ok(await inSight(answer));
  }
});

test('both levels fit a phone, and a step takes as many lines as it needs', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=64&room=16&fast=4');
  await page.setViewportSize({ width: 1600, height: 900 });
  const first = page.getByRole('listitem').filter({ hasText: /^1load/ });
  await first.waitFor();
  assert.equal(await first.evaluate((it) => it.offsetHeight), 28);
  await page.setViewportSize({ width: 390, height: 844 });
  const frame = page.getByRole('region', { name: 'What both levels move' });
  assert.equal(await frame.evaluate((it) => it.scrollWidth - it.clientWidth), 0);
});

test('why the busiest worker cannot have fewer loads is counted with one load less', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=64&room=16&workers=4&prefetch=1');
  await page.getByText('the busiest has 51 loads. With one place kept').waitFor();
  await page.getByText('Why not fewer').click();
  await page
    .getByText(/With room for 15: one of 4 workers .* and with 43 loads it brings at most \d+/)
    .waitFor();
});

test('workers are seen below each other, and an open gap is searched by one press', async (explorer) => {
  const page = await explorer.open('#/loadorder?items=12&room=4&workers=3');
  await page.getByRole('combobox', { name: 'Worker', exact: true }).selectOption('all');
  await page.locator('.timeline-canvas').nth(2).waitFor();
  assert.equal(await page.locator('.timeline-canvas').count(), 3);
  const wide = await explorer.open('#/loadorder?items=6&room=9');
  await wide.getByText('Room for 9 is more than all 6 items').waitFor();
  const open = await explorer.open('#/loadorder?items=30&room=6&workers=3');
  await open.getByRole('button', { name: 'Search 10 seconds for fewer' }).click();
  // The order that is there stays until another one is.
  await open.locator('.load-result.old .verdict').waitFor();
  await open
    .getByText(
      /A search of 10 s found (no order with|an order with \d+) fewer loads of the busiest/,
    )
    .waitFor({ timeout: 60_000 });
  await open.waitForURL(/time=10/);
});
