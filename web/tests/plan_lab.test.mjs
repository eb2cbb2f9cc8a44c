// The page that plans tests, for a lab: files as they come, models, benches, failures, and runs
// that several windows fill in.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { look } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
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

const lab = join(dirname(fileURLToPath(import.meta.url)), '../../examples/lab');
test(
  'a workbook as a lab has it: slots, quantities and forbidden pairs are in the form, and ' +
    'are obeyed',
  async (explorer) => {
    const page = await explorer.open('#/plan');
    const folder = mkdtempSync(join(tmpdir(), 'changeover-book-'));
    const book = join(folder, 'stock.xlsx');
    const sheets = ['inventory', 'slots', 'never'].map(
      (name, i) =>
        `${['Inventory', 'Slots', 'Never'][i]}=${join(lab, 'server_week', `${name}.csv`)}`,
    );
    execFileSync('python3', [join(lab, 'workbook.py'), 'make', book, ...sheets]);
    await give(page, 'stock.xlsx', readFileSync(book));
    await page.getByText('16 parts', { exact: true }).waitFor();
    await page.getByText("slots from 'Slots', forbidden pairs from 'Never'").waitFor();
    await page.getByText('CPU 1, DIMM 4, NIC 1–2').waitFor();
    await page.getByText('2 forbidden').waitFor();
    await page.getByRole('textbox', { name: 'Cost of a test' }).fill('25');
    await briefly(page);
    await page.getByRole('button', { name: 'Plan', exact: true }).click();
    await planned(page);
    await page.getByText(/\d+ tests, \d+ changes, \d+ minutes/).waitFor();
    await page.getByText('on the clock').waitFor();
    for (const set of await setUps(page)) {
      assert.ok(!(set.includes('CX-6') && set.includes('PSU 800')), set);
      assert.equal((set.match(/CPU/g) ?? []).length, 1);
    }
    // A column for each slot: no test needs more than three lines, on the screen as on paper, which
    // is wide then.
    for (const { height } of await sheetRows(page).evaluateAll((rows) =>
      rows.map((row) => row.getBoundingClientRect()),
    )) {
      assert.ok(height < 90, `a row of the sheet is ${height} px high`);
    }
    const paper = (await page.pdf({ preferCSSPageSize: true })).toString('latin1');
    assert.equal(paper.match(/\/Type \/Page\b/g).length, 1, 'one page');
    const [, width, high] = /MediaBox \[0 0 ([\d.]+) ([\d.]+)\]/.exec(paper);
    assert.ok(Number(width) > Number(high), 'landscape');
    await look(page, 'plan-server');
    await phone(page, 'plan-server');
    await page.setViewportSize({ width: 1280, height: 900 });

    // The workbook that the page gives is a whole question: with results filled in it comes back as
    // a run.
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('link', { name: 'Workbook' }).click(),
    ]);
    const filled = join(folder, 'filled.xlsx');
    execFileSync('python3', [
      join(lab, 'workbook.py'),
      'play',
      await download.path(),
      filled,
      '2',
      'X710,CD8',
    ]);
    const next = await explorer.open('#/plan');
    await briefly(next);
    await give(next, 'filled.xlsx', readFileSync(filled));
    await planned(next);
    await next.getByText('2 tests done; for the rest').waitFor();
    await next.locator('.sheet-progress', { hasText: /^2 of/ }).waitFor();
  },
);

test('a model of parameters: one value of each, its rules obeyed', async (explorer) => {
  const page = await explorer.open('#/plan');
  await give(page, 'shop.txt', readFileSync(join(lab, 'web_shop/model.txt')));
  await page
    .getByRole('radio', { name: 'Parameters with values' })
    .and(page.locator(':checked'))
    .waitFor();
  await give(page, 'costs.csv', readFileSync(join(lab, 'web_shop/costs.csv')));
  await page.locator('.group summary', { hasText: '12 rows' }).waitFor();
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('6');
  await briefly(page);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  const rows = await sheetRows(page).evaluateAll((all) =>
    all.map((row) => [...row.querySelectorAll('.of-value')].map((cell) => cell.textContent)),
  );
  assert.ok(rows.length >= 16);
  for (const [os, browser] of rows) {
    assert.ok(browser !== 'Safari' || os === 'macOS 14', `${os} ${browser}`);
  }
  assert.match(await page.locator('.verdict').textContent(), /another value costs what its row/);
  assert.ok(!(await page.locator('#main').textContent()).includes('Tick “gone”'));
  await look(page, 'plan-model');
});

test('files that are none of these are refused by name', async (explorer) => {
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

test('a search is seen while it goes on, and the best so far is kept', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('30');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('5');
  await page.getByRole('combobox', { name: 'Time to search' }).selectOption('600');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.locator('.live').getByText('no plan costs less than').waitFor({ timeout: 60_000 });
  await look(page, 'plan-live');
  await page.getByRole('button', { name: 'Stop and keep the best' }).click();
  await planned(page);
  assert.ok((await sheetRows(page).count()) > 40);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page.locator('.live').getByText('no plan costs less than').waitFor({ timeout: 60_000 });
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.getByText('Cancelled.').waitFor();
});

test('no result is lost while another plan is made', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('30');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('5');
  const time = page.getByRole('combobox', { name: 'Time to search' });
  await time.selectOption('1');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  await press(page, 1);
  await page.waitForFunction(() => location.hash.includes('run='));
  const other = await explorer.open(new URL(page.url()).hash);
  await time.selectOption('600');
  const replan = page.getByRole('button', { name: 'Replan the remaining tests' });
  await replan.click();
  await page.locator('.result[inert]').waitFor();
  const second = sheetButton(page, 2, 'pass');
  await second.scrollIntoViewIfNeeded();
  const { x, y } = await second.boundingBox();
  await page.mouse.click(x + 5, y + 5);
  await page.getByText(/^1 of \d+ tests done;/).waitFor();
  await press(other, 3, 'fail');
  await page.getByText('stopped: a result came from another window').waitFor();
  await page.getByText(/^2 of \d+ tests done, 1 failed;/).waitFor();
  assert.equal(await page.locator('.result[inert]').count(), 0);
  await time.selectOption('1');
  await replan.click();
  await page.getByText('2 tests done; for the rest').waitFor();
});

test('a plan is heard of without events, and with the server away', async (explorer) => {
  const page = await explorer.open('#/plan', { mayFail: /ERR_/ });
  await page.route('**/api/events', (route) => route.abort());
  let away = 0;
  await page.route('**/api/plan/job?*', (route) =>
    ++away <= 2 ? route.abort() : route.continue(),
  );
  await planNine(page);
  assert.ok(away > 2);
});

test('two windows write into one run; without the token: look only', async (explorer) => {
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
  await two.waitForFunction(
    () => document.querySelectorAll('.run-sheet input.notes')[2]?.value === 'a bit loud',
  );
  await one.close();
  await two.close();
  const later = await explorer.open(fragment);
  await later.locator('.sheet-progress', { hasText: '3 of 17 tests done, 1 failed' }).waitFor();
  await later.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await later.getByText('3 tests done; for the rest:').waitFor();
  const looking = await withoutToken(explorer, fragment);
  await looking.getByText('3 tests done; for the rest:').waitFor();
  assert.equal(
    await looking.getByRole('button', { name: 'Keep this run on the server' }).count(),
    0,
  );
  await later.goto(`${explorer.server.origin}/#/plan`);
  await later.getByText(/Runs on this server/).click();
  await later.getByRole('link', { name: 'Run sheet' }).first().waitFor();
  await look(later, 'plan-runs');
});

test('the workbook is in other windows and after a reload, if of this sheet', async (explorer) => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  await page.getByRole('link', { name: 'Workbook' }).waitFor();
  await page.waitForURL(/[?&]s=/);
  await page.reload();
  await planned(page);
  await page.getByRole('link', { name: 'Workbook' }).waitFor();
  await page.getByRole('button', { name: 'Keep this run on the server' }).click();
  await page.waitForURL(/run=/);
  const other = await withoutToken(explorer, `#/plan?run=${/run=([^&]+)/.exec(page.url())[1]}`);
  await planned(other);
  await other.getByRole('link', { name: 'Workbook' }).waitFor();

  // The server has another plan under that number: its workbook is not that of this sheet.
  await other.route('**/api/plan/job*', async (route) => {
    const answer = await (await route.fetch()).json();
    answer.answer.plan.steps.reverse();
    await route.fulfill({ json: answer });
  });
  await other.reload();
  await planned(other);
  await other.waitForLoadState('networkidle');
  assert.equal(await other.getByRole('link', { name: 'Workbook' }).count(), 0);
});

test('with a budget plans are compared for the whole job, and it is said', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('9');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.locator('.group summary', { hasText: 'Budget' }).click();
  await page.getByRole('textbox', { name: 'Budget' }).fill('20');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  await page.getByText('The comparison is of the whole job, without the budget.').waitFor();
  await page.getByRole('button', { name: 'Compare plans by cost' }).click();
  await page
    .getByRole('region', { name: 'Which plan is cheapest when' })
    .waitFor({ timeout: 60_000 });
});

test(
  'a run that is replanned in one window is so in the others; parts that stay keep their ' +
    'places',
  async (explorer) => {
    const one = await explorer.open('#/plan');
    await hurried(one);
    await one.getByRole('link', { name: 'a server with slots' }).click();
    await planned(one);
    const earlier = await setUps(one);
    await press(one, 1);
    await press(one, 2);
    await one.waitForFunction(() => location.hash.includes('run='));
    const fragment = new URL(one.url()).hash;
    const two = await explorer.open(fragment);
    const looking = await withoutToken(explorer, fragment);
    await one.getByRole('checkbox', { name: 'Part 11 is gone' }).check();
    await one.getByRole('button', { name: 'Replan the remaining tests' }).click();
    await one.getByText('2 tests done; for the rest').waitFor();
    const later = await setUps(one);
    assert.deepEqual(later.slice(0, 2), earlier.slice(0, 2));
    assert.ok(later.slice(2).every((set) => !set.includes('P5520')));
    for (const other of [two, looking]) {
      await other.getByText('replanned in another window').waitFor();
      assert.deepEqual(await setUps(other), later);
    }
    await press(one, 3, 'fail');
    await two.locator('.sheet-progress', { hasText: /3 of \d+ tests done, 1 failed/ }).waitFor();
    await press(looking, 4);
    await looking.getByText('This window may only look').waitFor();
    await looking
      .locator('.sheet-progress', { hasText: /3 of \d+ tests done, 1 failed/ })
      .waitFor();
  },
);

test('the failures say which pair is at fault, and which test tells most', async (explorer) => {
  const page = await explorer.open('#/plan');
  await planNine(page);
  // Parts 2 and 5 do not work together.
  for (let i = 1; i <= 17; ++i) {
    const names = (
      await page
        .locator('.run-sheet td.set-up')
        .nth(i - 1)
        .textContent()
    ).split(', ');
    await press(page, i, names.includes('2') && names.includes('5') ? 'fail' : 'pass');
  }
  await page.getByRole('button', { name: 'What is at fault?' }).click();
  const panel = page.getByRole('region', { name: 'Diagnosis' });
  await panel.waitFor();
  for (
    let i = 0;
    i < 6 && !(await panel.getByText('At fault, proven: 2 with 5').isVisible());
    ++i
  ) {
    await panel.getByRole('button', { name: 'Make it the next test' }).click();
    const names = (await page.locator('.next-test .set-up').textContent())
      .replace('Then in', '')
      .split(', ');
    const failed = names.includes('2') && names.includes('5');
    await page
      .locator('.next-test')
      .getByRole('button', { name: failed ? /fail/ : /pass/ })
      .click();
    await page.getByRole('button', { name: 'What is at fault?' }).click();
    await page.getByText('Weighing the results').waitFor({ state: 'detached' });
    await panel.waitFor();
  }
  await panel.getByText('At fault, proven: 2 with 5').waitFor();
  await look(page, 'plan-diagnosis');
  await panel.getByRole('button', { name: 'Forbid 2 with 5' }).click();
  await page.getByText(/tests done; for the rest: 0 tests/).waitFor();
});

test('three benches: a sheet each; a part is on one bench at a time', async (explorer) => {
  const page = await explorer.open('#/plan');
  await give(page, 'parts.csv', readFileSync(join(lab, 'benches/parts.csv')));
  await page.getByText('12 parts', { exact: true }).waitFor();
  await give(page, 'benches.csv', readFileSync(join(lab, 'benches/benches.csv')));
  await page.locator('.group summary', { hasText: '3 benches' }).waitFor();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('4');
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('1.5');
  await briefly(page);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  for (const bench of ['North', 'South', 'Night']) {
    await page.getByRole('heading', { name: bench }).first().waitFor();
  }
  await page.getByText('day 1, 8:00').first().waitFor();
  assert.ok((await page.locator('.next-test').count()) >= 1);
  assert.equal(await page.getByText('What if').count(), 0, 'costs are compared on one bench only');
  // A test begins when the one before it on its bench ends or, where a bench waits for a part or a
  // day is over, later; the last one's end is that of the bench.
  const minutes = (time) => {
    const [, day, hour, minute] = /^day (\d+), (\d+):(\d\d)$/.exec(time).map(Number);
    return (day * 24 + hour) * 60 + minute;
  };
  for (const sheet of await page.locator('.bench-sheet').all()) {
    const begins = await sheet.locator('td.of-when').allInnerTexts();
    const ends = await sheet.locator('td.of-sum').allTextContents();
    assert.match(ends.join(), /^(day \d+, \d+:\d\d,?)+$/);
    begins.slice(1).forEach((begin, i) => {
      assert.ok(minutes(begin) >= minutes(ends[i]), `${ends[i]}, then ${begin}`);
    });
    assert.match(await sheet.locator('h3').textContent(), new RegExp(`, done on ${ends.at(-1)}$`));
  }

  // Its workbook holds the whole question: on a page that knows nothing it comes back with results,
  // each on the sheet of its bench.
  const folder = mkdtempSync(join(tmpdir(), 'changeover-benches-'));
  const [planned_, half, filled] = ['week.xlsx', 'half.xlsx', 'filled.xlsx'].map((name) =>
    join(folder, name),
  );
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    page.getByRole('link', { name: 'Workbook' }).click(),
  ]);
  await download.saveAs(planned_);
  const sheetOf = (of, bench) =>
    of.locator('.bench-sheet', { has: of.getByRole('heading', { name: new RegExp(`^${bench}`) }) });
  // Parts that go to another bench are said below a set-up.
  const setUpsOf = (of, bench, rows = 'tr') =>
    sheetOf(of, bench)
      .locator(`${rows} td.set-up`)
      .evaluateAll((cells) =>
        cells.map((cell) => {
          const copy = cell.cloneNode(true);
          copy.querySelectorAll('.hand-over').forEach((line) => line.remove());
          return copy.textContent;
        }),
      );
  const sorted = (texts) => texts.map((text) => text.split(', ').sort());
  const [north, south_] = [await setUpsOf(page, 'North'), await setUpsOf(page, 'South')];
  const play = (from, to, tests, bench) =>
    execFileSync('python3', [
      '-c',
      'import sys; sys.path.insert(0, sys.argv[1]); import workbook; ' +
        'workbook.fill(sys.argv[2], sys.argv[3], workbook.play(int(sys.argv[4]), []), sys.argv[5])',
      lab,
      from,
      to,
      String(tests),
      bench,
    ]);
  play(planned_, half, 2, 'North');
  play(half, filled, 1, 'South');
  const fresh = await explorer.open('#/plan');
  await fresh.getByRole('combobox', { name: 'Time to search' }).selectOption('5');
  await give(fresh, 'week.xlsx', readFileSync(planned_));
  await fresh.getByText('week.xlsx: the job was read from the workbook').waitFor();
  await fresh.locator('.group summary', { hasText: '3 benches' }).waitFor();
  assert.equal(
    await fresh.getByRole('spinbutton', { name: 'How many fit at once' }).inputValue(),
    '4',
  );
  await give(fresh, 'filled.xlsx', readFileSync(filled));
  await fresh.getByText('3 tests done; for the rest').waitFor({ timeout: 60_000 });
  await fresh.locator('.sheet-progress', { hasText: /^3 of \d+ tests done/ }).waitFor();
  assert.deepEqual(sorted(await setUpsOf(fresh, 'North', 'tr.done')), sorted(north.slice(0, 2)));
  assert.deepEqual(sorted(await setUpsOf(fresh, 'South', 'tr.done')), sorted(south_.slice(0, 1)));
  await look(fresh, 'plan-benches-workbook');
  await give(page, 'benches.csv', readFileSync(join(lab, 'benches/benches.csv')));
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await page
    .locator('.sheet-progress', { hasText: /^0 of \d+ tests done/ })
    .waitFor({ timeout: 60_000 });
  const south = await setUpsOf(page, 'South');
  assert.ok(south.every((set) => !set.includes('H100')));
  await press(page, 'North 1');
  await page.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await page.getByText('1 test done; for the rest').waitFor({ timeout: 60_000 });
  await look(page, 'plan-benches');
});

test('what is on a bench before its first test is not put in', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('6');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await open(page, 'Several benches');
  await page.getByRole('button', { name: '2 alike' }).click();
  await page.getByRole('textbox', { name: 'What is now on bench 1' }).fill('1, 2');
  await briefly(page);
  let answer;
  page.on('response', async (response) => {
    if (/plan\/job\?/.test(response.url())) {
      answer = (await response.json().catch(() => null))?.answer ?? answer;
    }
  });
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  await page.waitForFunction(() => document.querySelector('.actions a:not([hidden])'));
  const put = await page
    .locator('.bench-sheet')
    .first()
    .locator('tbody td.enter')
    .allTextContents();
  const wanted = answer.benches.sheets[0].steps.map((step) => step.put_in.join(', ') || '–');
  assert.deepEqual(put, wanted);
  assert.ok(!/\b[12]\b/.test(wanted[0]), wanted[0]);
  const card = page.locator('.next-test').first();
  assert.equal(await card.locator('.enter').innerText(), `Put in${wanted[0]}`);
});

test('a replanned test that failed before says so, and what the failures say stays', async (explorer) => {
  const page = await explorer.open('#/plan');
  await hurried(page);
  await page.getByRole('button', { name: 'Try it: a pump bench' }).click();
  await planned(page);
  await press(page, '1', 'pass');
  await press(page, '2', 'fail');
  await page.getByRole('button', { name: 'What is at fault?' }).click();
  await page.getByRole('heading', { name: 'What the failures say' }).waitFor();
  await page.getByRole('button', { name: 'Replan the remaining tests' }).click();
  await page.getByText('2 tests done; for the rest').waitFor({ timeout: 60_000 });
  await page.getByRole('heading', { name: 'What the failures say' }).waitFor();
  await page.getByText('Pairs that met only in the failed test count as untested').waitFor();
  const setsOf = (rows) =>
    page
      .locator(`.run-sheet ${rows} td.set-up`)
      .evaluateAll((all) => all.map(({ textContent }) => textContent.split(', ').sort().join()));
  const [failed] = await setsOf('tr.failed');
  const again = (await setsOf('tr:not(.done)')).filter((set) => set === failed).length;
  assert.ok(again > 0, 'no test repeats the failed one');
  assert.equal(await page.locator('.run-sheet .repeats:visible').count(), again);
  await page.getByRole('button', { name: 'Count them as tested' }).click();
  const choice = page.getByRole('checkbox', { name: /^What met only in failed tests/ });
  assert.ok(await choice.evaluate((it) => it === document.activeElement));
  await press(page, '3', 'pass');
  await page.getByRole('heading', { name: 'What the failures say' }).waitFor({ state: 'detached' });
});

test('a model with a slip is there to be mended, with its place marked', async (explorer) => {
  const page = await explorer.open('#/plan', { mayFail: /422/ });
  await give(
    page,
    'shop.txt',
    'OS: Debian, Windows\nBrowser: Firefox, Edge\nIF [Browsr] = "Edge" THEN [OS] = "Windows";\n',
  );
  const model = page.locator('.model .field').first();
  await model.getByText('Line 3, column 4: no parameter is called').waitFor();
  await model.locator('.excerpt-line.here', { hasText: 'Browsr' }).waitFor();
  assert.equal(await model.locator('.excerpt mark').innerText(), '[Browsr]');
  const text = model.locator('textarea');
  assert.equal(
    await text.evaluate((it) => it.value.slice(it.selectionStart, it.selectionEnd)),
    '[Browsr]',
  );
  await page.getByText('Read from shop.txt.').waitFor();
  await model.getByRole('button', { name: 'Write [Browser]' }).click();
  assert.match(await text.inputValue(), /IF \[Browser\] = "Edge"/);
  assert.equal(await page.getByText('Read from shop.txt.').count(), 0, 'it is another text now');
  assert.equal(await model.locator('.excerpt').count(), 0);
  await briefly(page);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
});

test('benches are cards with all of their fields, and tests say when they begin and end', async (explorer) => {
  const page = await explorer.open('#/plan');
  await hurried(page);
  await page.getByRole('link', { name: 'three benches' }).click();
  await planned(page);
  await open(page, 'Several benches');
  const frame = page.getByRole('region', { name: 'Benches' });
  assert.equal(await frame.evaluate((it) => it.scrollWidth - it.clientWidth), 0);
  const down = (bench) => frame.getByRole('checkbox', { name: `Out of order, bench ${bench}` });
  assert.ok(await down(2).isVisible(), 'a card with a rare field that is used is open');
  assert.ok(!(await down(1).isVisible()));
  await frame.getByRole('button', { name: 'More' }).first().click();
  assert.ok(await down(1).isVisible());
  // A bar for each test, as long as the test: it leads to its row.
  const bars = page.locator('.time-strip .bar');
  assert.equal(await bars.count(), await page.locator('.run-sheet tbody tr').count());
  await page.getByRole('button', { name: /^South, test 1: begins day 1/ }).click();
  const row = page.locator('.bench-sheet', { hasText: 'South' }).locator('tbody tr').first();
  assert.ok(await row.evaluate((it) => it.contains(document.activeElement)));
  await page.getByText(/hours of work together/).waitFor();
  await page.setViewportSize({ width: 390, height: 844 });
  const when = page.locator('.run-sheet tbody .of-when').first();
  assert.match(await when.innerText(), /^day 1, \d+:\d\d · ends \d+:\d\d$/);
  assert.ok(await page.locator('.run-sheet tbody .of-sum').first().isHidden());
});

test('a part on two benches is said, one of each is a press away, and days begin when they do', async (explorer) => {
  const page = await explorer.open('#/plan');
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('6');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('3');
  await open(page, 'Several benches');
  await page.getByRole('button', { name: '2 alike' }).click();
  await page.getByRole('textbox', { name: 'Hours of work a day' }).fill('8');
  const room = page.getByRole('textbox', { name: 'How many parts fit on bench 1' });
  assert.equal(await room.getAttribute('placeholder'), '3');
  await briefly(page);
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
  await page
    .getByText(/: done on day \d+, \d+:\d\d\. \d+ tests, \d+ changes, \d+ hours of/)
    .waitFor();
  await page.getByText(/A test takes 3 hours; putting a part in takes 1 hour/).waitFor();
  const begins = page.locator('td.of-when').first();
  assert.match(await begins.innerText(), /^day 1, 8:00/);
  await page.getByLabel('Day begins at').fill('06:30');
  await page.getByText('begins day 1, 6:30').first().waitFor();
  assert.match(await begins.innerText(), /^day 1, 6:30/);
  const twice = page.getByText(/The benches use two of .* at the same time/);
  await twice.waitFor();
  await page.getByRole('button', { name: 'I have one of each' }).click();
  await twice.waitFor({ state: 'detached', timeout: 60_000 });
  const many = page.getByRole('textbox', { name: 'How many there are of part 1' });
  assert.equal(await many.inputValue(), '1');
  // A later test first: what was passed over is said.
  await press(page, 'Bench 1 2');
  await page.getByText(/^Bench 1, test 1 has no result/).waitFor();
});
