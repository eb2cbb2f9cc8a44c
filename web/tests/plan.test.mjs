// The page that plans tests: from a list of parts to a run sheet with results.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { look, program, screenshots, settled } from './support/browser.mjs';
import { inSight, phone } from './support/phone.mjs';
import {
  briefly,
  give,
  hurried,
  nameOf,
  open,
  planNine,
  planned,
  press,
  setUps,
  sheetButton,
  sheetRows,
  withoutToken,
} from './support/plan.mjs';
import { ownServer, test } from './support/tests.mjs';

ownServer();

test('before a plan: what will come, and an example by one press', async (explorer) => {
  const page = await explorer.open('#/plan');
  const picture = page.getByRole('img', { name: /^Eight tests of four parts/ });
  await picture.waitFor();
  await page.getByText('How it works, in three steps').click();
  await page.getByText('Press Plan. You get the set-ups in their order').waitFor();
  await hurried(page);
  await page.getByRole('button', { name: 'Try it: a pump bench' }).click();
  await planned(page);
  await page.getByRole('heading', { name: 'Pump bench' }).waitFor();
  assert.ok(await picture.isHidden(), 'the plan itself is there now');
});

test('what is missing is said where it is missing', async (explorer) => {
  const page = await explorer.open('#/plan', { mayFail: /422/ });
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  const alert = page.getByRole('alert');
  await alert.getByText('fewer than two parts').waitFor();
  await page.locator('.plan-what', { has: alert }).waitFor();
  await nameOf(page, 1).fill('Pump');
  assert.equal(await alert.count(), 0, 'what is being mended is no longer at fault');
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
  await page
    .getByRole('alert')
    .getByText("Forbidden pairs, row 1: there is no part 'Motr'")
    .waitFor();
  assert.ok(
    await page.getByRole('textbox', { name: 'Must never be in one set-up' }).isVisible(),
    'the group at fault opens',
  );
  // A refusal stands in the field that it speaks of.
  const within = (name) => page.locator('.field', { has: page.getByRole('textbox', { name }) });
  await within('Must never be in one set-up').getByRole('alert').waitFor();
  const room = page.getByRole('spinbutton', { name: 'How many fit at once' });
  await room.fill('1');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.locator('.field', { has: room }).getByText('a pair needs room for two').waitFor();
  await room.fill('3');
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('1,000');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await within('Cost of a test').getByRole('alert').getByText('may be a thousand').waitFor();
  await look(page, 'plan-fault');
});

test('nine parts: the sheet of the documents, bound and alternatives', async (explorer) => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByText('17 tests, 20 changes, cost 117').waitFor();
  await page.getByText('No plan is cheaper').waitFor();
  assert.equal(await sheetRows(page).count(), 17);
  assert.equal(await sheetRows(page).last().locator('td.of-sum').textContent(), '117');
  await page.getByText(/Compared with \d+ other plans/).click();
  await page
    .locator('.compared')
    .getByRole('cell', { name: 'double-change design' })
    .first()
    .waitFor();
  await look(page, 'plan-nine');
});

test(
  'parts are pasted from a spreadsheet, with costs, slots and quantities; what is not used ' +
    'is said',
  async (explorer) => {
    const page = await explorer.open('#/plan');
    await nameOf(page, 1).focus();
    await page.evaluate(() => {
      const clipboardData = new DataTransfer();
      clipboardData.setData(
        'text',
        'part\tprice\tslot\tQty\tVendor\nRiesling\t9,50\twhite\t2\tx\n' +
          'Merlot\t11\tred\t1\ty\nPinot\t7,25\tred\t\tz\nMalbec\t8\tred\t3\t\n',
      );
      document.activeElement.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
      );
    });
    await page.getByText('4 parts, 4 pasted').waitFor();
    await page.getByText('not used: “Vendor”').waitFor();
    assert.equal(await nameOf(page, 1).inputValue(), 'Riesling');
    const field = (label) =>
      page
        .getByRole('textbox', { name: label, exact: true })
        .or(page.getByRole('combobox', { name: label, exact: true }));
    assert.equal(await field('Cost of putting in part 1').inputValue(), '9.5');
    assert.equal(await field('Slot of part 1').inputValue(), 'white');
    assert.equal(await field('How many there are of part 4').inputValue(), '3');
    // Slots that the list names hold one part each, and the bench as many as the slots.
    assert.equal(await field('Name of slot 2').inputValue(), 'red');
    await page.locator('.group.set summary', { hasText: 'white 1, red 1' }).waitFor();
    assert.equal(
      await page.getByRole('spinbutton', { name: 'How many fit at once' }).inputValue(),
      '',
    );
    await page.getByRole('button', { name: 'Plan', exact: true }).click();
    await planned(page);
    assert.equal(await sheetRows(page).count(), 3, 'two reds never meet');
    assert.deepEqual(await page.locator('.run-sheet thead th').allTextContents(), [
      'result',
      'test',
      'white',
      'red',
      'cost',
      'so far',
      'notes',
    ]);
    assert.match((await setUps(page))[1], /^white Riesling\s+red \w+$/);
    assert.match(await sheetRows(page).nth(1).locator('.replaced').textContent(), /^for \w+$/);
  },
);

test('pairs that need not meet are left out', async (explorer) => {
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

test('without the token the whole job is in the link, with what is done', async (explorer) => {
  const page = await withoutToken(explorer, '#/plan');
  await planNine(page);
  await page.getByText('The link of this page holds the whole job').waitFor();
  for (const test of [1, 2]) {
    const before = new URL(page.url()).hash;
    await press(page, test);
    await page.waitForFunction((hash) => location.hash !== hash, before);
  }
  await page.getByText('2 of 17 tests done; 22 of 117 spent.').waitFor();
  const set = (await setUps(page))[5];
  const fragment = new URL(page.url()).hash;
  await page.evaluate(() => localStorage.clear());
  const other = await explorer.open(fragment);
  await other.getByText('2 of 17 tests done').waitFor();
  assert.equal((await setUps(other))[5], set);
  assert.equal(await nameOf(other, 9).inputValue(), '9');
});

test('a link to an older state does not undo what was done since', async (explorer) => {
  const page = await withoutToken(explorer, '#/plan');
  await planNine(page);
  await page.getByText('The link of this page holds the whole job').waitFor();
  const older = new URL(page.url()).hash;
  await press(page, 1);
  await page.waitForFunction((hash) => location.hash !== hash, older);
  const other = await withoutToken(explorer, older);
  await other.getByText('0 of 17 tests done').waitFor();
  await other.getByRole('link', { name: 'open that Run sheet' }).click();
  await other.getByText('1 of 17 tests done; 16 of 117 spent').waitFor();
});

test('the rest is replanned after some tests, without a part that is gone', async (explorer) => {
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
  assert.deepEqual(
    sets.slice(0, 3),
    earlier.map((set) => set.split(', ').sort()),
  );
  assert.ok(sets.slice(3).every((set) => !set.includes('8')));
  const met = new Set();
  for (const set of sets) {
    set.forEach((one) => set.forEach((other) => one < other && met.add(`${one} ${other}`)));
  }
  const left = ['1', '2', '3', '4', '5', '6', '7', '9'];
  assert.ok(left.every((one) => left.every((other) => one >= other || met.has(`${one} ${other}`))));
  await look(page, 'plan-rest');
});

test('what if: the library says which plan is cheapest when, and plans anew', async (explorer) => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByRole('textbox', { name: 'Cost of a change' }).fill('1');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByText('12 tests, 25 changes').waitFor();
  await page.getByRole('button', { name: 'Compare plans by cost' }).click();
  const table = page.getByRole('region', { name: 'Which plan is cheapest when' });
  await table.waitFor({ timeout: 60_000 });
  assert.deepEqual(await table.locator('tbody tr').first().locator('td').allTextContents(), [
    '0 – 1',
    '12 tests, 25 changesdouble-change design',
  ]);
  await page.locator('.what-if .u-over').waitFor();
  // Each line has a name of its own, which the table has, too.
  const names = await page.locator('.what-if .u-legend th .u-label').allTextContents();
  assert.equal(new Set(names.slice(1)).size, names.length - 1, names.join('; '));
  assert.equal(names[1], '12 tests, 25 changes');
  const markers = await page
    .locator('.what-if .u-legend .u-marker')
    .evaluateAll((all) => all.map((each) => getComputedStyle(each).borderBottomStyle));
  assert.equal(markers[1], 'solid');
  assert.ok(
    markers.slice(2).every((style) => style === 'dashed'),
    markers.join(),
  );
  await page.getByRole('slider', { name: 'A change costs' }).focus();
  await page.keyboard.press('End');
  await page.locator('.what-if p[role="status"]', { hasText: '17 tests and 20 changes' }).waitFor();
  await page.getByRole('button', { name: 'Replan at these costs' }).click();
  await page.getByText('17 tests, 20 changes').first().waitFor();
});

test('the sheet is downloaded as CSV that the command line reads back', async (explorer) => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await press(page, 1);
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('button', { name: 'Download CSV' }).click(),
  ]);
  const path = await download.path();
  const lines = readFileSync(path, 'utf8').trim().split('\n');
  assert.equal(lines.length, 18);
  assert.match(
    lines[0],
    /^step,take_out,put_in,slot_1,slot_2,slot_3,cost,cost_so_far,result,notes$/,
  );
  assert.match(lines[1], /,16,16,pass,$/);
  const again = execFileSync(
    program,
    [
      'plan',
      '--items',
      '9',
      '-k',
      '3',
      '--test-cost',
      '1',
      '--change-cost',
      '5',
      '--done',
      path,
      '--json',
    ],
    { encoding: 'utf8' },
  );
  assert.equal(JSON.parse(again).tests_done, 1);
});

test('on paper there is the sheet alone, with boxes', async (explorer) => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await press(page, 1);
  await page.emulateMedia({ media: 'print' });
  // What is written down is as black as the rest; the other box is not there.
  assert.deepEqual(
    await sheetButton(page, 1, 'pass').evaluate((button) => {
      const { color, backgroundColor } = getComputedStyle(button);
      return [color, backgroundColor];
    }),
    ['rgb(0, 0, 0)', 'rgba(0, 0, 0, 0)'],
    'a sign in black on the paper',
  );
  assert.ok(!(await sheetButton(page, 1, 'fail').isVisible()));
  assert.ok(!(await page.locator('.plan-form').isVisible()));
  assert.ok(!(await page.locator('.what-if').isVisible()));
  assert.ok(!(await page.locator('.next-tests').isVisible()));
  assert.ok(await sheetButton(page, 17, 'pass').isVisible());
  await page.setViewportSize({ width: 680, height: 960 });
  if (screenshots) {
    await page.screenshot({ path: join(screenshots, 'plan-print.png') });
  }
  await page.emulateMedia({ media: 'screen' });
});

test('a job too long for a link is kept; a link to one that is not says so', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('90');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('5');
  await briefly(page);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  await page.getByText('too long for a link').waitFor();
  assert.ok(page.url().length < 200);
  const rows = await sheetRows(page).count();
  await page.reload();
  await settled(page);
  await sheetRows(page)
    .nth(rows - 1)
    .waitFor();
  const other = await explorer.open('#/plan?id=nowhere');
  await other.getByRole('alert').getByText('this browser does not have it either').waitFor();
  const gone = await explorer.open(`#/plan?run=${'0'.repeat(24)}`, { mayFail: /404/ });
  await gone.getByRole('alert').getByText('no longer stored here').waitFor();
});

test('the keyboard alone: rows by Enter and arrows, results by Space', async (explorer) => {
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

test('on a phone: what to do next first, each test a card', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.setViewportSize({ width: 390, height: 844 });
  await hurried(page);
  await page.getByRole('button', { name: 'a pump bench' }).click();
  await planned(page);
  assert.ok(!(await page.locator('.plan-form').isVisible()), 'the form makes room');
  assert.ok(await page.locator('.next-test').getByText('Put in').isVisible());
  await page.locator('.next-test').getByRole('button', { name: /pass/ }).click();
  await page.locator('.next-test h3', { hasText: 'test 2 of' }).waitFor();
  await phone(page, 'plan');
});

test('on a phone the form folds to a line, and what is found comes into sight', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  const line = page.locator('.job-box > summary');
  const form = page.locator('.plan-form');
  const best = page.locator('.live-line');
  assert.equal(await line.textContent(), 'The job');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('30');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('4');
  await page.getByRole('combobox', { name: 'Time to search' }).selectOption('600');
  const go = page.getByRole('button', { name: 'Plan', exact: true });
  await go.click();

  // While it searches: what is found so far has the focus, and stays wherever one reads.
  await best.getByText('no plan costs less than').waitFor({ timeout: 60_000 });
  assert.equal(await line.textContent(), '30 parts, 4 at a time: change');
  assert.ok(!(await form.isVisible()));
  assert.ok(await best.evaluate((element) => element === document.activeElement));
  assert.ok(await inSight(line));
  assert.ok(await inSight(page.getByRole('button', { name: 'Stop and keep the best' })));
  await line.click();
  for (const place of ['What is combined', 'Time to search']) {
    await page.getByLabel(place).evaluate((element) => element.scrollIntoView());
    assert.ok(await inSight(best), `at “${place}”`);
  }
  await phone(page, 'plan-searching');

  // Given up: the form is there again, where the reader was.
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.getByText('Cancelled.').waitFor();
  assert.ok(await form.isVisible());
  assert.ok(await go.evaluate((element) => element === document.activeElement));

  // Found: nothing moves when it is asked not to, so it is there at once.
  await briefly(page);
  await page.keyboard.press('Enter');
  await planned(page);
  const heading = page.locator('.verdict h2');
  await page.waitForFunction(() => document.activeElement?.matches('.verdict h2'));
  assert.ok(await inSight(heading));
  assert.ok(await inSight(line));
  assert.ok(!(await form.isVisible()));
  await page.keyboard.press('Shift+Tab');
  assert.ok(await line.evaluate((element) => element === document.activeElement));
  await page.keyboard.press('Enter');
  await form.waitFor();
  assert.equal(await line.textContent(), 'The job');

  // What cannot be planned leaves the form open, with the reason beside its field.
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('dear');
  await page.keyboard.press('Enter');
  await page.locator('.problem').waitFor();
  assert.ok(await form.isVisible());
});

test('a part without a slot is named where the room is asked for', async (explorer) => {
  const page = await explorer.open('#/plan', { mayFail: /422/ });
  await page
    .getByLabel('A file with a list of parts')
    .setInputFiles(join(dirname(fileURLToPath(import.meta.url)), '../../examples/server.csv'));
  await page.getByText('Read from server.csv.').waitFor();
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.getByText('NIC 10G has no slot, so say how many parts fit at once').waitFor();
});

test('where parts have costs of their own all of them grow together', async (explorer) => {
  const page = await explorer.open('#/plan');
  await hurried(page);
  await page.getByRole('link', { name: 'a server with slots' }).click();
  await planned(page);
  const times = page.getByRole('spinbutton', { name: 'All change costs, times', exact: true });
  assert.equal(await times.inputValue(), '1');
  assert.ok(await page.getByRole('button', { name: 'Replan at these costs' }).isDisabled());
  await times.fill('2');
  assert.ok(await page.getByRole('button', { name: 'Replan at these costs' }).isEnabled());
});
