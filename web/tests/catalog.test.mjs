// The catalog: map, filters, table, what is taken along, look-up.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { look, settled } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

const small = '#/catalog?k=3..6&v=5..30';
const params = (page) => new URLSearchParams(page.url().split('?').at(-1));
const map = (page) => page.locator('.atlas-canvas');
const readout = (page, text) => page.locator('.readout h2', { hasText: text }).waitFor();

test('the map is walked through by arrow keys, and a cell opens', async (explorer) => {
  const page = await explorer.open(`${small}&change=2&kind=circular&at=12.4`);
  await readout(page, 'v = 12, k = 4');
  await map(page).focus();
  await page.keyboard.press('ArrowRight');
  await readout(page, 'v = 13, k = 4');
  assert.equal(params(page).get('at'), '13.4');
  await page.keyboard.press('ArrowDown');
  await readout(page, 'v = 13, k = 5');
  await page
    .locator('[aria-live=polite]', { hasText: /^v 13, k 5: \d+ blocks/ })
    .waitFor({ state: 'attached' });
  await page.keyboard.press('End');
  await readout(page, 'v = 160, k = 5');
  await page.keyboard.press('Home');
  await readout(page, 'v = 5, k = 5');
  await page.keyboard.press('Enter');
  await page.waitForURL(/#\/cell.*k=5/);
  await page.goBack();
  await settled(page);
  assert.equal(params(page).get('at'), '5.5');
});

test('a click opens a cell, hovering says what it is, a drag pans', async (explorer) => {
  const page = await explorer.open(small);
  const box = await map(page).boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  const tip = page.locator('.atlas-tip', { hasText: /v \d+ {2}k \d+/ });
  await tip.waitFor();
  // Keys choose another cell than the pointer rests on.
  await map(page).press('ArrowRight');
  await tip.waitFor({ state: 'hidden' });
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2 - 120, box.y + box.height / 2, { steps: 5 });
  await page.mouse.up();
  await page.waitForFunction(
    () => !document.querySelectorAll('input.range')[1].value.startsWith('5..'),
  );
  assert.ok(!page.url().includes('#/cell'), 'a drag opens nothing');
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  await page.waitForURL(/#\/cell/);
});

test('zooming changes the window, the table and the link', async (explorer) => {
  const page = await explorer.open('#/catalog');
  assert.equal(params(page).get('v'), null);
  const inSight = async () =>
    Number((await page.locator('.totals strong').first().textContent()).replace(/\D/g, ''));
  const all = await inSight();
  assert.ok(all > 5000);
  assert.equal(await page.locator('.filter-says').textContent(), '', 'said once');
  await map(page).focus();
  for (let i = 0; i < 6; ++i) {
    await page.keyboard.press('+');
  }
  await page.waitForURL(/v=\d+\.\.\d+/);
  await page.waitForFunction(
    (n) => Number(document.querySelector('.totals strong').textContent.replace(/\D/g, '')) < n / 10,
    all,
  );
  await page.keyboard.press('0');
  await page.waitForFunction(
    (n) => Number(document.querySelector('.totals strong').textContent.replace(/\D/g, '')) === n,
    all,
  );
  await page.getByRole('button', { name: 'Zoom in' }).click();
  await page.getByRole('button', { name: 'All cells' }).click();
});

test('sorting and filters are in the link, and filters say what they leave', async (explorer) => {
  const page = await explorer.open(small);
  await page.getByRole('button', { name: 'gap', exact: true }).click();
  await page.getByRole('button', { name: 'gap', exact: true }).click();
  assert.equal(params(page).get('sort'), '-gap');
  await page.getByLabel('Status').selectOption('best-known');
  await page.getByLabel('Gap at least').fill('2');
  await page.getByLabel('Gap at least').press('Tab');
  const gaps = async () =>
    (await page.locator('table.cells tbody tr td:nth-child(5)').allTextContents()).map(Number);
  const found = await gaps();
  assert.ok(
    found.length > 0 && found.every((gap, i) => gap >= 2 && (i === 0 || gap <= found[i - 1])),
  );
  assert.match(
    await page.locator('.filter-says').textContent(),
    new RegExp(
      `^${found.length} of \\d+ cells in sight: best known, not proved minimum, at least 2 ` +
        `blocks over the bound`,
    ),
  );
  await page.reload();
  await settled(page);
  assert.deepEqual(await gaps(), found);
  assert.equal(await page.locator('th[aria-sort=descending]').textContent(), 'gap');
  await page.getByRole('button', { name: 'Clear the filters' }).click();
  assert.ok((await gaps()).length > found.length);
});

test('all tight designs with a group of order > 1', async (explorer) => {
  const page = await explorer.open(`${small}&change=2&kind=circular`);
  await page.getByLabel('tight').check();
  await page.getByLabel('group of order > 1').check();
  await page.locator('.filter-says', { hasText: 'tight, with a group of order > 1' }).waitFor();
  const orders = await page.locator('table.cells td.group').allTextContents();
  assert.ok(
    orders.length > 3 && orders.every((order) => order !== '' && order !== '1'),
    orders.join(),
  );
  assert.ok((await page.locator('table.cells tbody .badge.good').count()) === orders.length);
});

test('what is listed is taken along', async (explorer) => {
  const page = await explorer.open('#/catalog?k=4..5&v=8..10&change=1&kind=linear');
  const taken = async (name) => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name, exact: true }).click(),
    ]);
    return readFileSync(await download.path(), 'utf8');
  };
  const csv = (await taken('CSV')).trim().split('\n');
  assert.equal(csv.length, 7);
  assert.match(csv[0], /^v,k,change,kind,strength,b,lower_bound,status/);
  assert.match(csv[1], /^8,4,1,linear,2,9,9,minimum,/);
  const json = JSON.parse(await taken('JSON'));
  assert.equal(json.length, 6);
  assert.equal(json[0].b, 9);
  const latex = await taken('LaTeX');
  assert.match(latex, /\\begin\{longtable\}\{rrr\}/);
  assert.match(latex, /8 & \$\\mathbf\{9\}\$ & /);
});

test('a random cell is one of those that are listed', async (explorer) => {
  const page = await explorer.open('#/catalog?k=4&v=8..9&change=1&kind=linear');
  await page.getByRole('button', { name: 'Random cell' }).click();
  await page.waitForURL(/#\/cell\?v=[89]&k=4&change=1&kind=linear/, { waitUntil: 'commit' });
});

test('long tables are drawn in pieces', async (explorer) => {
  const page = await explorer.open('#/catalog');
  const rows = page.locator('table.cells tbody tr');
  // Rows come until the end of them is far below the window, and no more.
  await page.waitForFunction(
    () => document.querySelector('.more').getBoundingClientRect().top > innerHeight + 1200,
  );
  const first = await rows.count();
  assert.ok(first >= 40 && first <= 160, `${first} rows at first`);
  await page.getByRole('button', { name: /More rows/ }).scrollIntoViewIfNeeded();
  await rows.nth(first).waitFor();
});

test('another change number, kind, strength and range are another table', async (explorer) => {
  const page = await explorer.open(small);
  await page.getByLabel('Change number').selectOption('1');
  await page.getByLabel('Kind').selectOption('linear');
  await page.getByLabel('k, block size').fill('4..5');
  await page.getByLabel('k, block size').press('Enter');
  await page.locator('.totals li', { hasText: /^5\d cells/ }).waitFor();
  assert.deepEqual(
    [...new Set(await page.locator('table.cells tbody tr td:nth-child(2)').allTextContents())],
    ['4', '5'],
  );
  await page.getByLabel('v, elements').fill('30..5');
  await page.getByLabel('v, elements').press('Enter');
  await page.getByRole('alert').filter({ hasText: 'not a range' }).waitFor();
  assert.equal(params(page).get('kind'), 'linear');
  await page.getByLabel('Covers').selectOption('3');
  await page.locator('table.cells a[href*="strength=3"]').first().waitFor();
});

test('of triples few designs are known: the first that is read has one', async (explorer) => {
  const page = await explorer.open('#/catalog?strength=3');
  await page.locator('.readout', { hasText: /blocks\d/ }).waitFor();
  await page.getByText(/A design is known for \d+ of these 340 cells/).waitFor();
  await page.getByRole('button', { name: 'Show only those with a design' }).click();
  await page.locator('.filter-says', { hasText: 'in sight: with a design' }).waitFor();
  const blocks = await page
    .locator('table.cells tbody tr td:nth-child(3)')
    .evaluateAll((cells) => cells.map((cell) => cell.textContent));
  assert.ok(blocks.length > 30 && blocks.every((b) => /^\d+$/.test(b)), blocks.join());
  assert.equal(await page.getByLabel('Status').inputValue(), 'known');
});

test('a better design that a publication reports is on the card of its cell', async (explorer) => {
  const page = await explorer.open('#/catalog?change=1&kind=linear&at=26.6');
  await page.locator('.readout', { hasText: /blocks64.*reported63, Bean 2026/ }).waitFor();
  await page.goto(page.url().replace(/#.*/, '#/search?v=26&k=6&change=1&kind=linear'));
  await page
    .locator('.search-known', { hasText: 'Bean 2026 reports one with 63 blocks' })
    .waitFor();
});

test('cells are counted in the range that is chosen', async (explorer) => {
  const page = await explorer.open('#/catalog?strength=3&k=4..6&v=5..30');
  const [, known, all] = /known for (\d+) of these (\d+) cells/.exec(
    await page.locator('.lacking p').textContent(),
  );
  assert.match(
    await page.locator('.totals').textContent(),
    new RegExp(`^${all} cells ?${known} with a design`),
  );
  assert.ok(Number(all) < 100, all);
  const beyond = page.locator('.legend li', { hasText: 'outside the range' });
  await beyond.waitFor();
  await page.getByRole('button', { name: 'All cells' }).click();
  await beyond.waitFor({ state: 'hidden' });
  await page.getByText(/of these 340 cells/).waitFor();
});

test('where no design is known the map has the bound, and the page says so', async (explorer) => {
  const page = await explorer.open('#/catalog?strength=3&at=20.5');
  const words = page.locator('.lacking p');
  await words.waitFor();
  assert.match(await words.textContent(), /A design is known for \d+ of these 340 cells/);
  await page.locator('.legend', { hasText: 'in italics its bound' }).waitFor();
  const details = page.getByRole('complementary', { name: 'Details of the selected cell' });
  await details.getByText('127', { exact: true }).waitFor();
  await details.getByRole('link', { name: 'Search for a design' }).click();
  await page.waitForURL(/#\/search\?v=20&k=5&change=2&kind=circular&strength=3/, {
    waitUntil: 'commit',
  });
  // Pairs have a design everywhere, so there is nothing to say.
  await page.goto(page.url().replace(/#.*/, '#/catalog'));
  await page.locator('table.cells a').first().waitFor();
  assert.equal(await page.locator('.lacking p').count(), 0);
  assert.equal(await page.locator('.legend', { hasText: 'no design known' }).count(), 0);
});

test('another measure paints the same table anew', async (explorer) => {
  const page = await explorer.open(small);
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  const picture = () => map(page).evaluate((canvas) => canvas.toDataURL());
  const before = await picture();
  await page.getByLabel('Colour by').selectOption('gap');
  const gap = await picture();
  await page.getByLabel('Colour by').selectOption('construction');
  await page
    .locator('.legend', { hasText: 'cut' })
    .or(page.locator('.legend', { hasText: 'found' }))
    .first()
    .waitFor();
  assert.equal(new Set([before, gap, await picture()]).size, 3);
  await page.getByLabel('Numbers', { exact: true }).selectOption('gap');
  assert.deepEqual(
    asked.filter((path) => !path.startsWith('/api/atlas')),
    [],
  );
  assert.equal(params(page).get('measure'), 'construction');
});

test('the look-up box leads to cells, labels and the page Verify', async (explorer) => {
  const page = await explorer.open(small);
  const box = page.getByLabel('Look up a design');
  await box.fill('kangaroo');
  await box.press('Enter');
  await page.getByRole('alert').filter({ hasText: 'kangaroo' }).waitFor();
  await box.fill('20 5');
  await box.press('Enter');
  await page
    .getByRole('heading', { name: /Circular double-change covering design on 20 elements/ })
    .waitFor();
  await page.goBack();
  await settled(page);
  await page.getByLabel('Look up a design').evaluate((input) => {
    const data = new DataTransfer();
    data.setData('text', '0 1 2\n1 2 3\n');
    input.dispatchEvent(
      new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }),
    );
  });
  await page.waitForURL(/#\/verify/);
  await page.getByRole('heading', { name: 'Verify', level: 1 }).waitFor();
});

test('a checksum leads to its design; filters that leave no cell are said', async (explorer) => {
  const page = await explorer.open('#/catalog?blocks=88&by=cyclic');
  await readout(page, 'No cell is left');
  await page.getByRole('button', { name: 'Clear the filters' }).click();
  await readout(page, 'v = 20, k = 5');
  const label = await page.locator('table.cells td.label a').nth(30).textContent();
  await page.getByLabel('Look up a design').fill(label.split('.').at(-1));
  await page.keyboard.press('Enter');
  await page.waitForURL((url) => url.hash.endsWith(`label=${label}`));
  await page.goto(page.url().replace(/#.*/, '#/home'));
  await page.getByLabel('Look up a design').fill('00000000');
  await page.keyboard.press('Enter');
  await page.getByRole('alert').filter({ hasText: 'No best design has a checksum' }).waitFor();
});

test('completeness by block size', async (explorer) => {
  const page = await explorer.open(small);
  await page.getByText('Completeness by block size').click();
  await page.locator('details.completeness[open]').waitFor();
  await page.locator('.completeness meter').first().waitFor();
});

test('it looks right', async (explorer) => {
  const page = await explorer.open(`${small}&at=20.5`);
  await look(page, 'catalog');
  const more = page.getByRole('button', { name: 'More controls' });
  assert.equal(await more.count(), 0, 'a desktop has room for all controls');
  await phone(page, 'catalog');
  assert.ok(!(await page.getByLabel('Colour by').isVisible()), 'on a phone the map comes first');
  await more.click();
  await page.getByLabel('Colour by').waitFor();
  await page.getByRole('button', { name: 'Fewer controls' }).click();
  await page.getByLabel('Colour by').waitFor({ state: 'hidden' });
  await page.close();
  const all = await explorer.open('#/catalog?tight=1');
  await look(all, 'catalog-tight');
  await all.close();
});

test('ranges of an address that are none are said, and blank cells are in the legend', async (explorer) => {
  const page = await explorer.open('#/catalog?k=5..3&v=zz');
  await page.getByRole('alert').filter({ hasText: 'k = 5..3 and v = zz' }).waitFor();
  await page.locator('.legend', { hasText: 'blank: there can be none' }).waitFor();
});
