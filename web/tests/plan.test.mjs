// The page that plans tests: from a list of parts to a run sheet with results, kept by the server.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { execFileSync } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { after, afterEach, before, test } from 'node:test';
import { accessibility, look, program, screenshots, settled, start } from './support/browser.mjs';
import { phone } from './support/phone.mjs';

const lab = join(import.meta.dirname ?? new URL('.', import.meta.url).pathname, '../../examples/lab');
let explorer;
before(async () => {
  explorer = await start();
});
after(() => explorer.stop());
// A browser has few connections for one server, and each window that listens holds one.
afterEach(() => Promise.all(explorer.context.pages().slice(1).map((page) => page.close())));

const nameOf = (page, i) => page.getByRole('textbox', { name: `Name of part ${i}`, exact: true });
const sheetRows = (page) => page.locator('.run-sheet tbody tr');
const planned = (page, most = 60_000) => page.locator('.verdict h2').waitFor({ timeout: most });
const sheetButton = (page, test, result) => page.locator('.sheets').getByRole('button', { name: `Test ${test}: ${result}`, exact: true });
const press = (page, test, result = 'pass') => sheetButton(page, test, result).click();
const give = (page, name, buffer) => page.getByLabel('A file with a list of parts').setInputFiles({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(buffer) });
const setUps = (page) => page.locator('.run-sheet td.set-up').evaluateAll((cells) => cells.map((cell) => cell.textContent));
const open = (page, group) => page.locator('.group summary', { hasText: group }).click();

/** A window that may look only: it does not have the token. */
async function withoutToken(fragment) {
  const page = await explorer.context.newPage();
  await page.goto(`${explorer.server.origin}/${fragment}`);
  await settled(page);
  return page;
}

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
  const page = await explorer.open('#/plan', { mayFail: /422/ });
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('fewer than two parts').waitFor();
  await nameOf(page, 1).fill('Pump');
  await nameOf(page, 2).fill('Pump');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('“Pump” is in the list twice').waitFor();
  await nameOf(page, 2).fill('Motor');
  await page.getByRole('textbox', { name: 'Cost of putting in part 2', exact: true }).fill('1,000');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('may be a thousand or one').waitFor();
  await page.getByRole('textbox', { name: 'Cost of putting in part 2', exact: true }).fill('2');
  await nameOf(page, 3).fill('Valve');
  await open(page, 'What must meet');
  await page.getByRole('textbox', { name: 'Must never be in one set-up' }).fill('Pump, Motr');
  await page.locator('.group summary', { hasText: 'What must meet' }).click();
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText("Forbidden pairs, row 1: there is no part 'Motr'").waitFor();
  assert.ok(await page.getByRole('textbox', { name: 'Must never be in one set-up' }).isVisible(), 'the group at fault opens');
  await look(page, 'plan-fault');
});

test('nine parts: the sheet of the documents, the bound in words, the alternatives', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByText('17 tests, 20 changes, cost 117').waitFor();
  await page.getByText('No plan is cheaper').waitFor();
  assert.equal(await sheetRows(page).count(), 17);
  assert.equal(await sheetRows(page).last().locator('td.of-sum').textContent(), '117');
  await page.getByText(/Compared with \d+ other plans/).click();
  await page.locator('.compared').getByRole('cell', { name: 'double-change design' }).first().waitFor();
  await look(page, 'plan-nine');
});

test('parts are pasted from a spreadsheet, with costs, slots and quantities; what is not used is said', async () => {
  const page = await explorer.open('#/plan');
  await nameOf(page, 1).focus();
  await page.evaluate(() => {
    const clipboardData = new DataTransfer();
    clipboardData.setData('text', 'part\tprice\tslot\tQty\tVendor\nRiesling\t9,50\twhite\t2\tx\nMerlot\t11\tred\t1\ty\nPinot\t7,25\tred\t\tz\nMalbec\t8\tred\t3\t\n');
    document.activeElement.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }));
  });
  await page.getByText('4 parts, 4 pasted').waitFor();
  await page.getByText("not used: 'Vendor'").waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), 'Riesling');
  const field = (label) => page.getByRole('textbox', { name: label, exact: true }).or(page.getByRole('combobox', { name: label, exact: true }));
  assert.equal(await field('Cost of putting in part 1').inputValue(), '9.5');
  assert.equal(await field('Slot of part 1').inputValue(), 'white');
  assert.equal(await field('How many there are of part 4').inputValue(), '3');
  await open(page, 'Slots');
  assert.equal(await field('Name of slot 2').inputValue(), 'red');
  await field('Most of slot 2').fill('1');
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('2');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  assert.equal(await sheetRows(page).count(), 3, 'two reds never meet');
});

test('a workbook as a lab has it: slots, quantities and forbidden pairs are in the form, and are obeyed', async () => {
  const page = await explorer.open('#/plan');
  const folder = mkdtempSync(join(tmpdir(), 'changeover-book-'));
  const book = join(folder, 'stock.xlsx');
  const sheets = ['inventory', 'slots', 'never'].map((name, i) => `${['Inventory', 'Slots', 'Never'][i]}=${join(lab, 'server_week', `${name}.csv`)}`);
  execFileSync('python3', [join(lab, 'workbook.py'), 'make', book, ...sheets]);
  await give(page, 'stock.xlsx', readFileSync(book));
  await page.getByText('16 parts', { exact: true }).waitFor();
  await page.getByText("slots from 'Slots', forbidden pairs from 'Never'").waitFor();
  await page.getByText('CPU 1, DIMM 4, NIC 1–2').waitFor();
  await page.getByText('2 forbidden').waitFor();
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('25');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  await page.getByText(/6 tests, \d+ changes, cost 2\d\d minutes/).waitFor();
  await page.getByText('on the clock').waitFor();
  for (const set of await setUps(page)) {
    assert.ok(!(set.includes('CX-6') && set.includes('PSU 800')), set);
    assert.equal((set.match(/CPU/g) ?? []).length, 1);
  }
  await look(page, 'plan-server');

  // The workbook that the page gives is a whole question: with results filled in it comes back as a run.
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('link', { name: 'Workbook' }).click()]);
  const filled = join(folder, 'filled.xlsx');
  execFileSync('python3', [join(lab, 'workbook.py'), 'play', await download.path(), filled, '2', 'X710,CD8']);
  const next = await explorer.open('#/plan');
  await give(next, 'filled.xlsx', readFileSync(filled));
  await planned(next);
  await next.getByText('2 tests done; for the rest').waitFor();
  await next.locator('.sheet-progress', { hasText: /^2 of/ }).waitFor();
});

test('a model of parameters: one value of each, its rules obeyed', async () => {
  const page = await explorer.open('#/plan');
  await give(page, 'shop.txt', readFileSync(join(lab, 'web_shop/model.txt')));
  await page.getByRole('radio', { name: 'Parameters with values' }).and(page.locator(':checked')).waitFor();
  await give(page, 'costs.csv', readFileSync(join(lab, 'web_shop/costs.csv')));
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('6');
  await page.getByRole('combobox', { name: 'Search for' }).selectOption('1');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  const rows = await sheetRows(page).evaluateAll((all) => all.map((row) => [...row.querySelectorAll('.of-value')].map((cell) => cell.textContent)));
  assert.ok(rows.length >= 16);
  for (const [os, browser] of rows) {
    assert.ok(browser !== 'Safari' || os === 'macOS 14', `${os} ${browser}`);
  }
  await look(page, 'plan-model');
});

test('files that are none of these are refused by name', async () => {
  const page = await explorer.open('#/plan', { mayFail: /422/ });
  await give(page, 'book.xlsx', 'PK\u0003\u0004\u0014\u0000\u0006\u0000');
  await page.getByRole('alert').getByText('book.xlsx').waitFor();
  await give(page, 'picture.png', Buffer.from([0x89, 0x50, 0xff, 0xfe]));
  await page.getByRole('alert').getByText('neither text in UTF-8 nor a workbook').waitFor();
  await give(page, 'twice.csv', 'part,cost\na,1\na,2\n');
  await page.getByRole('alert').getByText('twice.csv').waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), '');
  await give(page, 'good.csv', 'cost,part\n4,Debian\n2,Fedora\n1,Chrome\n');
  await nameOf(page, 3).waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), 'Debian');
});

test('pairs that need not meet are left out', async () => {
  const page = await explorer.open('#/plan');
  await give(page, 'parts.csv', '"Pump, large",4\nMotor,2\nValve,1\n');
  await page.getByText('3 parts', { exact: true }).waitFor();
  assert.equal(await nameOf(page, 1).inputValue(), 'Pump, large');
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('2');
  await open(page, 'What must meet');
  await page.getByRole('combobox', { name: 'Pairs' }).selectOption('skip');
  await page.getByRole('textbox', { name: /^Pairs/ }).fill('Pump, Motr');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByRole('alert').getByText('“Pump” is not in the list').waitFor();
  await page.getByRole('textbox', { name: /^Pairs/ }).fill('"Pump, large", Motor');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  assert.equal(await sheetRows(page).count(), 2);
});

test('a search is seen while it goes on, and the best so far is kept', async () => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('30');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('5');
  await page.getByRole('combobox', { name: 'Search for' }).selectOption('600');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByText('no plan costs less than').waitFor({ timeout: 60_000 });
  await look(page, 'plan-live');
  await page.getByRole('button', { name: 'Stop and keep the best' }).click();
  await planned(page);
  assert.ok((await sheetRows(page).count()) > 40);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByText('no plan costs less than').waitFor({ timeout: 60_000 });
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.getByText('Cancelled.').waitFor();
});

test('two windows write into one run, which outlives both; a window without the token only looks', async () => {
  const one = await explorer.open('#/plan');
  await planNine(one);
  await press(one, 1);
  await one.getByText('This run is kept on the server').waitFor();
  await one.getByLabel('Results are signed').fill('Ann');
  await one.getByLabel('Results are signed').blur();
  await one.waitForFunction(() => location.hash.includes('run='));
  const fragment = new URL(one.url()).hash;
  const two = await explorer.open(fragment);
  await two.locator('.sheet-progress', { hasText: /^1 of 17/ }).waitFor();
  await press(two, 2, 'fail');
  await one.locator('.sheet-progress', { hasText: '2 of 17 tests done, 1 failed' }).waitFor();
  await press(one, 3);
  await two.locator('.sheet-progress', { hasText: /^3 of 17/ }).waitFor();
  await one.getByRole('textbox', { name: 'Notes on test 3', exact: true }).fill('a bit loud');
  await one.getByRole('textbox', { name: 'Notes on test 3', exact: true }).blur();
  await two.waitForFunction(() => document.querySelectorAll('.run-sheet input.notes')[2]?.value === 'a bit loud');
  await one.close();
  await two.close();
  const later = await explorer.open(fragment);
  await later.locator('.sheet-progress', { hasText: '3 of 17 tests done, 1 failed' }).waitFor();
  await later.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await later.getByText('3 tests done; for the rest:').waitFor();
  const looking = await withoutToken(fragment);
  await looking.getByText('3 tests done; for the rest:').waitFor();
  assert.equal(await looking.getByRole('button', { name: 'Keep this run on the server' }).count(), 0);
  await later.goto(`${explorer.server.origin}/#/plan`);
  await later.getByText(/Runs on this server/).click();
  await later.getByRole('link', { name: 'Run sheet' }).first().waitFor();
  await look(later, 'plan-runs');
});

test('the failures say which pair is at fault, and which test tells most', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  // Parts 2 and 5 do not work together.
  for (let i = 1; i <= 17; ++i) {
    const names = (await page.locator('.run-sheet td.set-up').nth(i - 1).textContent()).split(', ');
    await press(page, i, names.includes('2') && names.includes('5') ? 'fail' : 'pass');
  }
  await page.getByRole('button', { name: 'What is at fault?' }).click();
  const panel = page.getByRole('region', { name: 'Diagnosis' });
  await panel.waitFor();
  for (let i = 0; i < 6 && !(await panel.getByText('At fault, proven: 2 with 5').isVisible()); ++i) {
    await panel.getByRole('button', { name: 'Make it the next test' }).click();
    const names = (await page.locator('.next-test .set-up').textContent()).replace('Then in', '').split(', ');
    const failed = names.includes('2') && names.includes('5');
    await page.locator('.next-test').getByRole('button', { name: failed ? /fail/ : /pass/ }).click();
    await page.getByRole('button', { name: 'What is at fault?' }).click();
    await panel.waitFor();
    await page.waitForTimeout(300);
  }
  await panel.getByText('At fault, proven: 2 with 5').waitFor();
  await look(page, 'plan-diagnosis');
  await panel.getByRole('button', { name: 'Forbid 2 with 5' }).click();
  await page.getByText(/tests done; for the rest: 0 tests/).waitFor();
});

test('three benches: a sheet each, with its times; a part is on one bench at a time', async () => {
  const page = await explorer.open('#/plan');
  await give(page, 'parts.csv', readFileSync(join(lab, 'benches/parts.csv')));
  await page.getByText('12 parts', { exact: true }).waitFor();
  await give(page, 'benches.csv', readFileSync(join(lab, 'benches/benches.csv')));
  await page.locator('.group summary', { hasText: '3 benches' }).waitFor();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('4');
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('1.5');
  await page.getByRole('combobox', { name: 'Search for' }).selectOption('5');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  for (const bench of ['North', 'South', 'Night']) {
    await page.getByRole('heading', { name: bench }).first().waitFor();
  }
  await page.getByText('day 1, 0:00').first().waitFor();
  assert.ok((await page.locator('.next-test').count()) >= 1);
  const south = await page.locator('.bench-sheet', { hasText: 'South' }).locator('td.set-up').allTextContents();
  assert.ok(south.every((set) => !set.includes('H100')));
  await press(page, 'North 1');
  await page.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await page.getByText('1 test done; for the rest').waitFor({ timeout: 60_000 });
  await look(page, 'plan-benches');
});

test('a window without the token keeps the whole job in its link, with what is done', async () => {
  const page = await withoutToken('#/plan');
  await planNine(page);
  await press(page, 1);
  await press(page, 2);
  await page.getByText('2 of 17 tests done; 22 of 117 spent.').waitFor();
  await page.getByText('The link of this page holds the whole job').waitFor();
  const set = (await setUps(page))[5];
  await page.waitForTimeout(200);
  const fragment = new URL(page.url()).hash;
  await page.evaluate(() => localStorage.clear());
  const other = await explorer.open(fragment);
  await other.getByText('2 of 17 tests done').waitFor();
  assert.equal((await setUps(other))[5], set);
  assert.equal(await nameOf(other, 9).inputValue(), '9');
});

test('a link to an older state does not undo what was done since', async () => {
  const page = await withoutToken('#/plan');
  await planNine(page);
  await page.getByText('The link of this page holds the whole job').waitFor();
  const older = new URL(page.url()).hash;
  await press(page, 1);
  await page.waitForFunction((hash) => location.hash !== hash, older);
  const other = await withoutToken(older);
  await other.getByText('0 of 17 tests done').waitFor();
  await other.getByRole('link', { name: 'open that Run sheet' }).click();
  await other.getByText('1 of 17 tests done; 16 of 117 spent').waitFor();
});

test('the rest is planned anew after some tests, without a part that is gone', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  for (const i of [1, 2, 3]) {
    await press(page, i);
  }
  const earlier = (await setUps(page)).slice(0, 3);
  await page.getByRole('checkbox', { name: 'Part 8 is gone' }).check();
  await page.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await page.getByText('3 tests done; for the rest:').waitFor();
  const sets = (await setUps(page)).map((set) => set.split(', ').sort());
  assert.deepEqual(sets.slice(0, 3), earlier.map((set) => set.split(', ').sort()));
  assert.ok(sets.slice(3).every((set) => !set.includes('8')));
  const met = new Set();
  for (const set of sets) {
    set.forEach((one) => set.forEach((other) => one < other && met.add(`${one} ${other}`)));
  }
  const left = ['1', '2', '3', '4', '5', '6', '7', '9'];
  assert.ok(left.every((one) => left.every((other) => one >= other || met.has(`${one} ${other}`))));
  await look(page, 'plan-rest');
});

test('what if: the library says which plan is cheapest when, and plans anew', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByRole('textbox', { name: 'Cost of a change' }).fill('1');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByText('12 tests, 25 changes').waitFor();
  await page.getByRole('button', { name: 'Find which plan is cheapest when' }).click();
  const table = page.getByRole('region', { name: 'Which plan is cheapest when' });
  await table.waitFor({ timeout: 60_000 });
  assert.deepEqual(await table.locator('tbody tr').first().locator('td').allTextContents(), ['0', '1', 'double-change design', '12', '25']);
  await page.locator('.what-if .u-over').waitFor();
  await page.getByRole('slider', { name: 'A change costs' }).focus();
  await page.keyboard.press('End');
  await page.locator('.what-if p[role="status"]', { hasText: '17 tests, 20 changes' }).waitFor();
  await page.getByRole('button', { name: 'Replan at these costs' }).click();
  await page.getByText('17 tests, 20 changes').first().waitFor();
});

test('the sheet is downloaded as CSV that the command line reads back', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await press(page, 1);
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Download CSV' }).click()]);
  const path = await download.path();
  const lines = readFileSync(path, 'utf8').trim().split('\n');
  assert.equal(lines.length, 18);
  assert.match(lines[0], /^step,take_out,put_in,slot_1,slot_2,slot_3,cost,cost_so_far,result,notes$/);
  assert.match(lines[1], /,16,16,pass,$/);
  const again = execFileSync(program, ['plan', '--items', '9', '-k', '3', '--test-cost', '1', '--change-cost', '5', '--done', path, '--json'], { encoding: 'utf8' });
  assert.equal(JSON.parse(again).tests_done, 1);
});

test('on paper there is the sheet alone, with boxes', async () => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.emulateMedia({ media: 'print' });
  assert.ok(!(await page.locator('.plan-form').isVisible()));
  assert.ok(!(await page.locator('.what-if').isVisible()));
  assert.ok(!(await page.locator('.next-tests').isVisible()));
  assert.ok(await sheetButton(page, 17, 'pass').isVisible());
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
  await planned(page);
  await page.getByText('too long for a link').waitFor();
  assert.ok(page.url().length < 200);
  const rows = await sheetRows(page).count();
  await page.reload();
  await settled(page);
  await sheetRows(page).nth(rows - 1).waitFor();
  const other = await explorer.open('#/plan?id=nowhere');
  await other.getByRole('alert').getByText('this browser does not have it either').waitFor();
  const gone = await explorer.open(`#/plan?run=${'0'.repeat(24)}`, { mayFail: /404/ });
  await gone.getByRole('alert').getByText('not kept here any more').waitFor();
});

test('the keyboard alone: rows by Enter and arrows, results by arrows and Space', async () => {
  const page = await explorer.open('#/plan');
  await nameOf(page, 1).focus();
  for (const name of ['A', 'B', 'C', 'D']) {
    await page.keyboard.type(name);
    await page.keyboard.press('Enter');
  }
  assert.equal(await nameOf(page, 4).inputValue(), 'D');
  await page.keyboard.type('E');
  for (let i = 0; i < 5; ++i) {
    await page.keyboard.press('Tab');
  }
  await page.keyboard.press('Enter');
  await page.getByText('4 parts', { exact: true }).waitFor();
  await page.getByRole('button', { name: 'Plan', exact: true }).focus();
  await page.keyboard.press('Enter');
  await planned(page);
  await sheetButton(page, 1, 'pass').focus();
  await page.keyboard.press('Space');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Space');
  await page.getByText('2 of 3 tests done').waitFor();
});

test('on a phone: what to do next first, each test a card', async () => {
  const page = await explorer.open('#/plan');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByRole('link', { name: 'a pump bench' }).click();
  await planned(page);
  assert.ok(!(await page.locator('.plan-form').isVisible()), 'the form makes room');
  assert.ok(await page.locator('.next-test').getByText('Put in').isVisible());
  await page.locator('.next-test').getByRole('button', { name: /pass/ }).click();
  await page.locator('.next-test h3', { hasText: 'test 2 of' }).waitFor();
  await phone(page, 'plan');
  assert.deepEqual(await accessibility(page), []);
});
