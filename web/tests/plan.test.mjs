// The page that plans tests: from a list of parts to a run sheet that is ticked off.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { accessibility, look, screenshots, settled, start } from './support/browser.mjs';

let explorer;
before(async () => {
  explorer = await start();
});
after(() => explorer.stop());

const nameOf = (page, i) => page.getByRole('textbox', { name: `Name of part ${i}`, exact: true });
const sheetRows = (page) => page.locator('.run-sheet tbody tr');
const planned = (page) => page.locator('.verdict h2').waitFor();

/** Nine parts, three at a time, one a test, five a change: the example of docs/plan.md. */
async function planNine(page) {
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('9');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('3');
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('1');
  await page.getByRole('textbox', { name: 'Cost of a change' }).fill('5');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
}

test('what is missing is said where it is missing', async () => {
  const page = await explorer.open('#/plan');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('fewer than two parts').waitFor();
  await nameOf(page, 1).fill('Pump');
  await nameOf(page, 2).fill('Pump');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('“Pump” is in the list twice').waitFor();
  await nameOf(page, 2).fill('Motor');
  await page.getByRole('textbox', { name: 'Cost of putting in part 2' }).fill('1,000');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('may be a thousand or one').waitFor();
  await look(page, 'plan-fault');
});

test('nine parts: the sheet of the documents, the bound in words, the alternatives', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByText('17 tests, 20 changes, cost 117').waitFor();
  await page.getByText('No plan is cheaper').waitFor();
  assert.equal(await sheetRows(page).count(), 17);
  assert.equal(await sheetRows(page).last().locator('td').last().textContent(), '117');
  await page.locator('.what-if').getByRole('cell', { name: 'double-change design' }).first().waitFor();
  await page.locator('.what-if .u-over').waitFor();
  await look(page, 'plan-nine');
});

test('parts are pasted from a spreadsheet, headings passed over', async () => {
  const page = await explorer.open('#/plan');
  await nameOf(page, 1).focus();
  await page.evaluate(() => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text', 'part\tprice\nRiesling\t9,50\nMerlot\t11\nPinot\t7,25\nMalbec\t8\n');
    document.activeElement.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  });
  await page.getByText('4 parts, 4 pasted').waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), 'Riesling');
  assert.equal(await page.getByRole('textbox', { name: 'Cost of putting in part 1', exact: true }).inputValue(), '9.5');
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('2');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  assert.equal(await sheetRows(page).count(), 6);
});

test('columns that the page does not use, and files that are no text, are refused by name', async () => {
  const page = await explorer.open('#/plan');
  const give = (name, text) =>
    page.getByLabel('A file with a list of parts').setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });
  const refused = (words) => page.getByRole('alert').getByText(words).waitFor();
  await give('slots.csv', 'part,cost,slot\nDebian,4,OS\nFedora,2,OS\nChrome,1,browser\n');
  await refused('the column “slot” is not used on this page');
  await look(page, 'plan-refused');
  await give('bare.csv', 'Debian,4,OS\nFedora,2,OS\n');
  await refused('column 3 is not used on this page');
  await give('book.xlsx', 'PK\u0003\u0004\u0014\u0000\u0006\u0000');
  await refused('this file is not text');
  assert.equal(await nameOf(page, 1).inputValue(), '');
  await give('good.csv', 'cost,part\n4,Debian\n2,Fedora\n1,Chrome\n');
  await nameOf(page, 3).waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), 'Debian');
  assert.equal(await page.getByRole('textbox', { name: 'Cost of putting in part 1', exact: true }).inputValue(), '4');
});

test('a list comes from a CSV file; pairs that need not meet are left out', async () => {
  const page = await explorer.open('#/plan');
  await page
    .getByLabel('A file with a list of parts')
    .setInputFiles({ name: 'parts.csv', mimeType: 'text/csv', buffer: Buffer.from('"Pump, large",4\nMotor,2\nValve,1\n') });
  await page.getByText('3 parts', { exact: true }).waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), 'Pump, large');
  await nameOf(page, 1).fill('Pump');
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('2');
  await page.getByRole('combobox', { name: 'Pairs' }).selectOption('skip');
  await page.getByRole('textbox', { name: /^Pairs/ }).fill('Pump, Motr');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('“Motr” is not in the list').waitFor();
  await page.getByRole('textbox', { name: /^Pairs/ }).fill('Pump, Motor');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  assert.equal(await sheetRows(page).count(), 2);
});

test('the whole job is in the link, with what is done', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByRole('checkbox', { name: 'Test 1 is done' }).check();
  await page.getByRole('checkbox', { name: 'Test 2 is done' }).check();
  await page.getByText('2 of 17 tests done; 22 of 117 spent.').waitFor();
  await page.getByText('The link of this page holds the whole job').waitFor();
  const set = await sheetRows(page).nth(5).locator('td').nth(4).textContent();
  await page.waitForTimeout(200);
  const fragment = new URL(page.url()).hash;
  await page.evaluate(() => localStorage.clear());
  const other = await explorer.open(fragment);
  await other.getByText('2 of 17 tests done').waitFor();
  assert.equal(await sheetRows(other).nth(5).locator('td').nth(4).textContent(), set);
  assert.equal(await nameOf(other, 9).inputValue(), '9');
});

test('a link to an older state does not undo what was done since', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByText('The link of this page holds the whole job').waitFor();
  const older = new URL(page.url()).hash;
  await page.getByRole('checkbox', { name: 'Test 1 is done', exact: true }).check();
  await page.waitForFunction((hash) => location.hash !== hash, older);
  const other = await explorer.open(older);
  await other.getByText('0 of 17 tests done').waitFor();
  await other.getByRole('link', { name: 'open that Run sheet' }).click();
  await other.getByText('1 of 17 tests done; 16 of 117 spent').waitFor();
});

test('the rest is planned anew after some tests, without a part that is gone', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  for (const i of [1, 2, 3]) {
    await page.getByRole('checkbox', { name: `Test ${i} is done`, exact: true }).check();
  }
  const before = await sheetRows(page).evaluateAll((rows) => rows.slice(0, 3).map((row) => row.cells[4].textContent));
  await page.getByRole('checkbox', { name: 'Part 8 is gone' }).check();
  await page.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await page.getByText('3 tests done; for the rest:').waitFor();
  const sets = await sheetRows(page).evaluateAll((rows) => rows.map((row) => row.cells[4].textContent));
  assert.deepEqual(sets.slice(0, 3), before);
  const names = sets.slice(3).map((set) => set.split(', '));
  assert.ok(names.every((set) => !set.includes('8')));
  const met = new Set();
  for (const set of sets.map((each) => each.split(', '))) {
    set.forEach((one) => set.forEach((other) => one < other && met.add(`${one} ${other}`)));
  }
  const left = ['1', '2', '3', '4', '5', '6', '7', '9'];
  assert.ok(left.every((one) => left.every((other) => one >= other || met.has(`${one} ${other}`))));
  await look(page, 'plan-rest');
});

test('sliders put the alternatives into another order at once, and plan anew', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  const first = page.locator('.what-if table').first().locator('tbody tr').first().locator('td').first();
  assert.equal(await first.textContent(), 'this plan');
  let asked = 0;
  page.on('request', (request) => request.url().includes('api/plan') && ++asked);
  await page.getByRole('slider', { name: 'A test costs' }).focus();
  await page.keyboard.press('End');
  await page.getByText('The double-change design would be cheaper').or(page.getByText('The ordered covering would be cheaper')).waitFor();
  assert.notEqual(await first.textContent(), 'this plan');
  assert.equal(asked, 0);
  await page.getByRole('button', { name: 'Replan at these costs' }).click();
  await page.getByText('12 tests, 25 changes').waitFor();
  assert.equal(asked, 1);
});

test('the sheet is downloaded as CSV that the command line reads back', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByRole('checkbox', { name: 'Test 1 is done', exact: true }).check();
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download CSV' }).click()]);
  const lines = readFileSync(await download.path(), 'utf8')
    .trim()
    .split('\n');
  assert.equal(lines.length, 18);
  assert.match(lines[0], /^step,take_out,put_in,slot_1,slot_2,slot_3,cost,cost_so_far,result$/);
  assert.match(lines[1], /,16,16,done$/);
});

test('on paper there is the sheet alone, with boxes', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.emulateMedia({ media: 'print' });
  assert.ok(!(await page.locator('.plan-form').isVisible()));
  assert.ok(!(await page.locator('.what-if').isVisible()));
  assert.ok(await page.getByRole('checkbox', { name: 'Test 17 is done' }).isVisible());
  await page.setViewportSize({ width: 680, height: 960 });
  await page.screenshot({ path: join(screenshots, 'plan-print.png') });
  await page.emulateMedia({ media: 'screen' });
});

test('a job too long for a link is kept in this browser, and a link to one that is not says so', async () => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('90');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('5');
  await page.getByRole('combobox', { name: 'Search for' }).selectOption('1');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.locator('.verdict h2').waitFor({ timeout: 60_000 });
  await page.getByText('too long for a link').waitFor();
  assert.ok(page.url().length < 200);
  const rows = await sheetRows(page).count();
  await page.reload();
  await settled(page);
  await page
    .locator('.run-sheet tbody tr')
    .nth(rows - 1)
    .waitFor();
  const other = await explorer.open('#/plan?id=nowhere');
  await other.getByRole('alert').getByText('this browser does not have it either').waitFor();
});

test('the keyboard alone: rows by Enter and arrows, ticks by arrows and Space', async () => {
  const page = await explorer.open('#/plan');
  await nameOf(page, 1).focus();
  for (const name of ['A', 'B', 'C', 'D']) {
    await page.keyboard.type(name);
    await page.keyboard.press('Enter');
  }
  assert.equal(await nameOf(page, 4).inputValue(), 'D');
  await page.keyboard.type('E');
  for (let i = 0; i < 3; ++i) {
    await page.keyboard.press('Tab');
  }
  await page.keyboard.press('Enter');
  await page.getByText('4 parts', { exact: true }).waitFor();
  await page.getByRole('button', { name: 'Plan', exact: true }).focus();
  await page.keyboard.press('Enter');
  await planned(page);
  await page.getByRole('checkbox', { name: 'Test 1 is done', exact: true }).focus();
  await page.keyboard.press('Space');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Space');
  await page.getByText('2 of 3 tests done').waitFor();
});

test('on a phone nothing scrolls sideways but the frames', async () => {
  const page = await explorer.open('#/plan');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByRole('link', { name: 'Try an example' }).click();
  await planned(page);
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await look(page, 'plan-phone');
  assert.deepEqual(await accessibility(page), []);
});
