// The catalog: heat map, table, look-up.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { look, settled, start } from './support/browser.mjs';
import { phone } from './support/phone.mjs';

let explorer;
before(async () => {
  explorer = await start();
});
after(() => explorer.stop());

const small = '#/catalog?k=3..6&v=5..30';
const params = (page) => new URLSearchParams(page.url().split('?').at(-1));

test('the heat map is walked through by arrow keys, and a cell opens', async () => {
  const page = await explorer.open(`${small}&change=2&kind=circular`);
  const cell = page.locator('.heat-map .cell[data-v="12"][data-k="4"]');
  await cell.hover();
  await page.locator('.readout h2', { hasText: 'v = 12, k = 4' }).waitFor();
  assert.equal(params(page).get('at'), '12.4');
  await page.reload();
  await settled(page);
  await page.locator('.readout h2', { hasText: 'v = 12, k = 4' }).waitFor();
  await page.locator('.heat-map .cell[tabindex="0"]').focus();
  const before = await page.locator('.heat-map .cell[tabindex="0"]').boundingBox();
  await page.keyboard.press('ArrowRight');
  await page.locator('.readout h2', { hasText: 'v = 13, k = 4' }).waitFor();
  await page.keyboard.press('ArrowDown');
  const below = page.locator('.heat-map .cell[tabindex="0"]');
  assert.ok((await below.boundingBox()).y > before.y, 'down goes down, as the picture has it');
  assert.match(await below.getAttribute('aria-label'), /^v 13, k [35]: /);
  const [v, k] = [await below.getAttribute('data-v'), await below.getAttribute('data-k')];
  await page.keyboard.press('Home');
  await page.locator('.readout h2', { hasText: `k = ${k}` }).waitFor();
  assert.equal(v, '13');
  await page.keyboard.press('Enter');
  await page.waitForURL(new RegExp(`#/cell.*k=${k}`));
  await page.goBack();
  await settled(page);
  assert.equal(params(page).get('at').split('.')[1], k);
  await page.close();
});

test('sorting and filters are in the link', async () => {
  const page = await explorer.open(small);
  await page.getByRole('button', { name: 'gap', exact: true }).click();
  await page.getByRole('button', { name: 'gap', exact: true }).click();
  assert.equal(params(page).get('sort'), '-gap');
  await page.getByLabel('Status').selectOption('best-known');
  await page.getByLabel('Gap at least').fill('2');
  await page.getByLabel('Gap at least').press('Tab');
  const gaps = async () => (await page.locator('table.cells tbody tr td:nth-child(5)').allTextContents()).map(Number);
  const found = await gaps();
  assert.ok(found.length > 0 && found.every((gap, i) => gap >= 2 && (i === 0 || gap <= found[i - 1])));
  await page.reload();
  await settled(page);
  assert.deepEqual(await gaps(), found);
  assert.equal(await page.locator('th[aria-sort=descending]').textContent(), 'gap');
  await page.getByLabel('Gap at least').fill('9999');
  await page.getByLabel('Gap at least').press('Tab');
  await page.getByRole('button', { name: 'Clear the filters' }).click();
  assert.ok((await gaps()).length > found.length);
  await page.close();
});

test('long tables are drawn in pieces', async () => {
  const page = await explorer.open('#/catalog');
  const shown = () => page.locator('table.cells tbody tr').count();
  assert.equal(await shown(), 100);
  await page.getByRole('button', { name: /More rows/ }).scrollIntoViewIfNeeded();
  await page.locator('table.cells tbody tr').nth(150).waitFor();
  await page.close();
});

test('another change number, kind and range are another table', async () => {
  const page = await explorer.open(small);
  await page.getByLabel('Change number').selectOption('1');
  await page.getByLabel('Kind').selectOption('linear');
  await page.getByLabel('k, block size').fill('4..5');
  await page.getByLabel('k, block size').press('Enter');
  await page.locator('[aria-live=polite]', { hasText: /^5\d cells$/ }).waitFor({ state: 'attached' });
  assert.deepEqual([...new Set(await page.locator('table.cells tbody tr td:nth-child(2)').allTextContents())], ['4', '5']);
  await page.getByLabel('v, elements').fill('30..5');
  await page.getByLabel('v, elements').press('Enter');
  await page.getByRole('alert').filter({ hasText: 'no range' }).waitFor();
  assert.equal(params(page).get('kind'), 'linear');
  await page.close();
});

test('another measure is another picture of the same table', async () => {
  const page = await explorer.open(small);
  const asked = [];
  page.on('request', (request) => asked.push(new URL(request.url()).pathname));
  await page.getByLabel('Colour says').selectOption('gap');
  await page.getByLabel('Colour says').selectOption('status');
  await page.locator('.heat-map text', { hasText: 'best known' }).first().waitFor();
  assert.deepEqual([...new Set(asked)], ['/api/heatmap']);
  assert.equal(params(page).get('measure'), 'status');
  assert.equal(await page.locator('.problem').count(), 0);
  await page.close();
});

test('the look-up box leads to cells, labels and the page Verify', async () => {
  const page = await explorer.open(small);
  const box = page.getByLabel('Look up a design');
  await box.fill('kangaroo');
  await box.press('Enter');
  await page.getByRole('alert').filter({ hasText: 'kangaroo' }).waitFor();
  await box.fill('20 5');
  await box.press('Enter');
  await page.getByRole('heading', { name: /Circular double-change covering design on 20 elements/ }).waitFor();
  await page.goBack();
  await settled(page);
  await page.getByLabel('Look up a design').evaluate((input) => {
    const data = new DataTransfer();
    data.setData('text', '0 1 2\n1 2 3\n');
    input.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
  });
  await page.waitForURL(/#\/verify/);
  await page.getByRole('heading', { name: 'Verify', level: 1 }).waitFor();
  await page.close();
});

test('completeness by block size', async () => {
  const page = await explorer.open(small);
  await page.locator('rect.cell').first().waitFor(); // the map moves what is below it
  await page.getByText('How complete the whole catalog is').click();
  await page.locator('details.completeness[open]').waitFor();
  await page.locator('.completeness meter').first().waitFor();
  await page.close();
});

test('completeness of another kind, chosen while the first is counted', async () => {
  const page = await explorer.open(`${small}&kind=circular`);
  await page.locator('rect.cell').first().waitFor();
  let answer;
  const looked = new Promise((resolve) => (answer = resolve));
  let asked = 0;
  await page.route('**/api/completeness', async (route) => {
    asked += 1;
    await looked;
    await route.continue().catch(() => undefined); // the first was given up
  });
  await page.getByText('How complete the whole catalog is').click();
  await page.locator('.completeness .hint', { hasText: 'Counting' }).waitFor();
  const second = page.waitForRequest('**/api/completeness');
  await page.getByLabel('Kind').selectOption('linear');
  await second;
  await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve))));
  // That the first was given up is nobody's business.
  assert.equal(await page.locator('.completeness .inside').innerText(), 'Counting…');
  answer();
  await page.locator('.completeness meter').first().waitFor();
  assert.equal(asked, 2);
  await page.close();
});

test('it looks right', async () => {
  const page = await explorer.open(`${small}&at=20.5`);
  await look(page, 'catalog');
  await phone(page, 'catalog');
  await page.close();
});
