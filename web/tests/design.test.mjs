// A design: pictures, the player, facts, downloads.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { look, program, settled } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

const params = (page) => new URLSearchParams(page.url().split('?').at(-1));

test('the player is moved by keys, and its block is in the link', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5&at=7');
  const words = page.locator('.block-text');
  await words.filter({ hasText: 'Block 7 of 29' }).waitFor();
  assert.equal(await page.locator('.slots .entering').count(), 2);
  assert.equal(await page.locator('.slots del').count(), 2);
  // The pairs that are new are named, and the blocks around stand below, each element in its slot.
  const [, n, pairs] = /(\d+) pairs meet for the first time here: (.*)\./.exec(
    await page.locator('.step-words p').last().textContent(),
  );
  assert.equal(pairs.split(', ').length, Number(n));
  assert.deepEqual(await page.locator('.around-blocks th').allTextContents(), [
    '5',
    '6',
    '7',
    '8',
    '9',
    '10',
  ]);
  assert.deepEqual(
    (await page.locator('.around-blocks .own td').allTextContents()).join(' '),
    (await page.locator('.slots .name').allTextContents()).join(' '),
  );
  await page.keyboard.press('ArrowRight');
  await words.filter({ hasText: 'Block 8 of 29' }).waitFor();
  await page.keyboard.press('End');
  await words.filter({ hasText: 'Block 29 of 29' }).waitFor();
  assert.match(await page.locator('.met').textContent(), /190 of 190 pairs have met \(100 %\)/);
  await page.keyboard.press('ArrowRight');
  await words.filter({ hasText: 'Block 29 of 29' }).waitFor();
  await page.waitForURL(/at=29/);
  await page.reload();
  await settled(page);
  await words.filter({ hasText: 'Block 29 of 29' }).waitFor();
  await page.keyboard.press('Home');
  await words.filter({ hasText: 'Block 1 of 29' }).waitFor();
  await page.getByLabel('Speed').selectOption('200');
  await page.locator('h1').click();
  await page.keyboard.press(' ');
  await words.filter({ hasText: 'Block 29 of 29' }).waitFor();
  await page.getByRole('button', { name: 'Play' }).waitFor();
});

test('a design of strength 3 is told in triples', async (explorer) => {
  const page = await explorer.open(
    '#/design?v=8&k=5&change=2&kind=circular&strength=3&show=steps&at=8',
  );
  await page.locator('.met', { hasText: '56 of 56 triples have met (100 %)' }).waitFor();
  await page.getByRole('button', { name: 'First block' }).click();
  await page.locator('.met', { hasText: '10 of 56 triples have met' }).waitFor();
  const [, named] = /10 triples meet for the first time here: (.*)\./.exec(
    await page.locator('.step-words').textContent(),
  );
  assert.ok(
    named.split(', ').every((triple) => /^\d\S*–\S*\d\S*–\S*\d$/.test(triple)),
    named,
  );
  await page.getByText('every step and every triple was checked').waitFor();
  assert.match(
    await page.getByRole('link', { name: 'Its place on the map' }).getAttribute('href'),
    /strength=3/,
  );
  await page.getByRole('tab', { name: 'Coverage' }).click();
  await page.getByText('The block with which all triples').waitFor();
  const often = await page.locator('.matrix-key tbody td.number').allTextContents();
  assert.equal(
    often.reduce((sum, n) => sum + Number(n), 0),
    56,
  );
  await look(page, 'design-triples');
});

test('slider and number lead to a block; keys of a field stay with it', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5&show=steps');
  await page.getByLabel('Block', { exact: true }).fill('12');
  await page.locator('.block-text', { hasText: 'Block 12 of 29' }).waitFor();
  await page.getByLabel('Number of the block').fill('3');
  await page.getByLabel('Number of the block').press('Enter');
  await page.locator('.block-text', { hasText: 'Block 3 of 29' }).waitFor();
  await page.keyboard.press('ArrowLeft');
  await page.locator('.block-text', { hasText: 'Block 3 of 29' }).waitFor();
});

test('tabs by arrow keys, in the link', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5');
  await page.locator('.block-text', { hasText: 'Block 1 of 29' }).waitFor();
  await page.getByRole('tab', { name: 'Steps' }).focus();
  await page.keyboard.press('ArrowRight');
  await page.locator('.array-table td').first().waitFor();
  await page.keyboard.press('ArrowRight');
  await page.getByLabel('Order of elements').waitFor();
  assert.equal(params(page).get('show'), 'stays');
  await page.getByLabel('Order of elements').selectOption('stays');
  assert.equal(params(page).get('order'), 'stays');
  await page.reload();
  await settled(page);
  assert.equal(await page.getByLabel('Order of elements').inputValue(), 'stays');
  await page.getByRole('tab', { name: 'Coverage' }).click();
  await page.locator('.matrix-canvas').waitFor();
  // What the colours mean stands beside the picture, with the number of pairs of each: together all
  // pairs.
  const often = await page.locator('.matrix-key tbody td.number').allTextContents();
  assert.equal(
    often.reduce((sum, n) => sum + Number(n), 0),
    190,
  );
  assert.equal(
    await page.getByRole('tab', { name: 'Circle' }).count(),
    0,
    'this design has no symmetry',
  );
  await page.getByRole('tab', { name: 'Recipe' }).click();
  await page.locator('.recipe-node', { hasText: 'found' }).waitFor();
  await page.getByRole('tab', { name: 'Blocks' }).click();
  assert.equal((await page.locator('pre.blocks').textContent()).trim().split('\n').length, 30);
});

test('what is chosen in one view is lit in all', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5&at=12');
  await page.locator('.slots button', { hasText: /^2$/ }).click();
  await page.locator('.selected-words', { hasText: /^2 is in \d+ of 29 blocks/ }).waitFor();
  await page.getByRole('tab', { name: 'Array' }).click();
  await page.locator('.array-table td.lit').first().waitFor();
  await page.locator('.array-table td', { hasText: /^13/ }).first().click();
  await page
    .locator('.selected-words', { hasText: '2 and 13 are first together in block 12' })
    .waitFor();
  assert.equal(params(page).get('sel'), '2~13');
  await page.reload();
  await settled(page);
  await page.locator('.selected-words', { hasText: '2 and 13' }).waitFor();
  await page.getByRole('tab', { name: 'Stays' }).click();
  await page.locator('.timeline-canvas').focus();
  await page.keyboard.press('ArrowDown');
  await page
    .locator('.selected-words', { hasText: /is in \d+ of 29 blocks, in \d+ stay/ })
    .waitFor();
  await page.keyboard.press('+');
  await page.keyboard.press('+');
  await page.waitForURL(/from=\d+/);
  await page.keyboard.press('0');
  await page.keyboard.press('Escape');
  assert.equal(params(page).get('sel'), null);
  const pairs = page.locator('.matrix-canvas');
  const { width } = await pairs.boundingBox();
  await pairs.click({ position: { x: width * 0.5, y: width * 0.8 } });
  await page.locator('.selected-words', { hasText: /first together in block/ }).waitFor();
  await page.getByRole('button', { name: 'Clear' }).click();
  await page.locator('.selected-words', { hasText: 'Click an element' }).waitFor();
  await page.getByLabel('Select an element or a pair').fill('4, 11');
  await page.getByLabel('Select an element or a pair').press('Enter');
  await page.locator('.selected-words', { hasText: /^4 and 11 / }).waitFor();
  await page.getByLabel('Select an element or a pair').fill('4 99');
  await page.getByLabel('Select an element or a pair').press('Enter');
  assert.equal(
    await page.getByLabel('Select an element or a pair').getAttribute('aria-invalid'),
    'true',
  );
});

test('a design that is developed shows its symmetry', async (explorer) => {
  const page = await explorer.open('#/design?v=61&k=4&kind=circular&show=circle');
  await page.getByText('6 base blocks make all 366 in 61 turns').waitFor();
  assert.equal(await page.locator('.circle-block').count(), 6);
  const before = await page.locator('.circle-block').first().getAttribute('points');
  await page.getByRole('button', { name: 'Turn on' }).click();
  await page.getByText('Turn 2 of 61: blocks 7 to 12').waitFor();
  assert.notEqual(await page.locator('.circle-block').first().getAttribute('points'), before);
  const waiting = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Save as SVG' }).click();
  assert.match((await waiting).suggestedFilename(), /^61\.4\.2\.circular\.366\..*circle\.svg$/);
  // On a phone, too, the names can be read.
  await page.setViewportSize({ width: 390, height: 844 });
  await page.waitForFunction(() =>
    [...document.querySelectorAll('.circle-picture text')].every(
      (text) => Number(text.getAttribute('font-size')) * text.getScreenCTM().a >= 8,
    ),
  );
  assert.equal(await page.locator('.circle-picture text').count(), 61);
});

test('stays are dragged, and zoomed with two fingers', async (explorer) => {
  const page = await explorer.open('#/design?v=61&k=4&kind=circular&show=stays');
  const canvas = page.locator('.timeline-canvas');
  await canvas.focus();
  for (let i = 0; i < 4; ++i) {
    await page.keyboard.press('+');
  }
  await page.waitForURL(/from=\d+/);
  const from = () => Number(params(page).get('from'));
  const begun = from();
  const { x, y, width } = await canvas.boundingBox();
  const [middle, high] = [x + width / 2, y + 60];
  await page.mouse.move(middle, high);
  await page.mouse.down();
  await page.mouse.move(middle - 30, high, { steps: 3 });
  await page.mouse.move(middle - 120, high, { steps: 3 });
  await page.mouse.up();
  await page.waitForFunction((n) => Number(/from=(\d+)/.exec(location.hash)?.[1]) > n, begun);
  assert.equal(params(page).get('sel'), null, 'who drags chooses nothing');
  await page.mouse.click(middle, high, { button: 'right' });
  assert.equal(params(page).get('sel'), null, 'nor does another button');
  await page.keyboard.press('Escape');
  await page.mouse.click(middle, high);
  await page.waitForURL(/sel=/);
  await page.keyboard.press('Escape');
  await page.keyboard.press('0');
  await page.waitForURL((url) => !url.hash.includes('from='));
  const touch = await page.context().newCDPSession(page);
  const fingers = (type, apart) =>
    touch.send('Input.dispatchTouchEvent', {
      type,
      touchPoints: (apart === null ? [] : [-apart, apart]).map((by, id) => ({
        x: middle + by,
        y: high,
        id,
      })),
    });
  await fingers('touchStart', 40);
  for (const apart of [60, 80, 100, 120]) {
    await fingers('touchMove', apart);
  }
  await fingers('touchEnd', null);
  await page.waitForURL(/from=\d+/);
  assert.equal(params(page).get('sel'), null);
});

test('ten thousand blocks are drawn, zoomed and panned without a pause', async (explorer) => {
  const page = await explorer.open('#/design?v=253&k=4&change=1&kind=linear&show=stays');
  const canvas = page.locator('.timeline-canvas');
  await canvas.waitFor();
  assert.ok(Number((await page.locator('h1').textContent()).replace(/\D/g, '').slice(-5)) > 10_000);
  await canvas.focus();
  const slowest = await page.evaluate(async () => {
    const target = document.querySelector('.timeline-canvas');
    let worst = 0;
    for (const key of ['+', '+', '+', '+', 'd', 'd', 'a', '+', '+', 'd', '-', '-', '-', 'd', '0']) {
      const began = performance.now();
      target.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
      worst = Math.max(worst, performance.now() - began);
    }
    return worst;
  });
  console.log(`slowest of 15 pictures: ${slowest.toFixed(0)} ms`);
});

test('a long design is drawn in parts', async (explorer) => {
  const page = await explorer.open('#/design?v=253&k=13&kind=circular&show=array');
  await page.locator('.array-table td').first().waitFor();
  assert.equal(await page.getByLabel('From block').inputValue(), '1');
  // Whole rows at a time.
  const shown = await page.locator('.array-table th').count();
  const rows = await page.locator('.array-table').count();
  assert.equal(await page.locator('.array-table').last().locator('th').count(), shown / rows);
  await page.getByRole('button', { name: /later/ }).click();
  assert.equal(await page.getByLabel('From block').inputValue(), String(shown + 1));
  await page.getByRole('tab', { name: 'Steps' }).click();
  await page.locator('canvas.coverage-map').waitFor();
  await page.keyboard.press('End');
  await page.locator('.met', { hasText: '(100 %)' }).waitFor();
});

test('by label, and a label that does not exist', async (explorer) => {
  const page = await explorer.open('#/design?label=20.5.2.circular.29.17482f88');
  assert.match(await page.locator('.under').textContent(), /20\.5\.2\.circular\.29\.17482f88/);
  await page.close();
  const none = await explorer.open('#/design?label=20.5.2.circular.29.00000000', {
    mayFail: /status of 404/,
  });
  await none.getByRole('alert').getByText('no design with the label').waitFor();
  await none.getByRole('link', { name: 'What is known of v = 20, k = 5' }).waitFor();
  await none.close();
  const which = await explorer.open('#/design');
  await which.getByRole('heading', { name: 'Which design?' }).waitFor();
  await which.close();
});

test('a design of this window, and none', async (explorer) => {
  const page = await explorer.open('#/design?local=1');
  await page.getByRole('alert').filter({ hasText: 'no pasted design' }).waitFor();
  await page.evaluate(() =>
    sessionStorage.setItem(
      'changeover-local',
      JSON.stringify({
        format: 'changeover-design/1',
        v: 4,
        k: 3,
        change: 1,
        kind: 'linear',
        labels: ['ann', 'bob', 'cy', 'dee'],
        blocks: [
          [0, 1, 2],
          [0, 1, 3],
          [1, 2, 3],
        ],
        verdict: {
          valid: true,
          tight: false,
          economical: true,
          b: 3,
          lower_bound: 3,
          minimum: 'proved',
        },
      }),
    ),
  );
  await page.reload();
  await settled(page);
  await page.getByRole('heading', { name: /3 blocks/ }).waitFor();
  await page.getByRole('tab', { name: 'Steps' }).click();
  await page.keyboard.press('ArrowRight');
  await page.locator('.in', { hasText: 'Introduced: dee' }).waitFor();
  const waiting = page.waitForEvent('download');
  await page.getByRole('link', { name: 'CSV', exact: true }).click();
  assert.equal((await waiting).suggestedFilename(), '4.3.1.linear.3.csv');
});

test('a file of the command line is what is shown first', async (explorer) => {
  const folder = mkdtempSync(join(tmpdir(), 'changeover-file-'));
  writeFileSync(join(folder, 'mine.txt'), 'a b c\na b d\nb c d\n');
  const other = await explorer.another({ serve: [join(folder, 'mine.txt')] });
  try {
    const page = await other.open();
    await page.waitForURL(/#\/design\?file=1/);
    await page.locator('.under', { hasText: 'mine.txt' }).waitFor();
    await page.getByRole('tab', { name: 'Steps' }).click();
    await page.keyboard.press('ArrowRight');
    await page.locator('.in', { hasText: 'Introduced: d' }).waitFor();
    const map = page.locator('canvas.coverage-map');
    // The names stand beside their squares.
    assert.deepEqual(await page.locator('.coverage-names.down span').allTextContents(), [
      'a',
      'b',
      'c',
      'd',
    ]);
    const [whole, name] = [
      await map.boundingBox(),
      await page.locator('.coverage-names.across span').nth(3).boundingBox(),
    ];
    assert.ok(Math.abs(name.x + name.width / 2 - (whole.x + (whole.width * 3.5) / 4)) < 2);
    const { width } = await map.boundingBox();
    await map.hover({ position: { x: (width * 3.5) / 4, y: width / 8 } });
    await page.locator('.pair', { hasText: 'a and d: first together in block 2' }).waitFor();
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});

test('it looks right', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5&at=7');
  await look(page, 'design-steps');
  await phone(page, 'design-steps');
  const tabs = await page.getByRole('tab').evaluateAll((all) =>
    all.map((tab) => {
      const { left, right, height } = tab.getBoundingClientRect();
      return { left, right, height };
    }),
  );
  assert.equal(tabs.length, 6);
  assert.ok(tabs.every(({ left, right, height }) => left >= 0 && right <= 390 && height >= 36));
  await page.setViewportSize({ width: 1280, height: 900 });
  for (const name of ['Array', 'Stays', 'Coverage', 'Recipe', 'Blocks']) {
    await page.getByRole('tab', { name }).click();
    await look(page, `design-${name.toLowerCase()}`);
  }
  await page.getByRole('tab', { name: 'Array' }).click();
  await phone(page, 'design-array');
  await page.getByRole('tab', { name: 'Stays' }).click();
  await phone(page, 'design-stays');
  await page.close();
  const circle = await explorer.open('#/design?v=61&k=4&kind=circular&show=circle');
  await look(circle, 'design-circle');
  await circle.close();
});

test('what cannot be selected is said', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5&show=recipe');
  const field = page.getByRole('textbox', { name: 'Select an element or a pair' });
  const alert = page.getByRole('alert').filter({ hasText: 'Elements are 0 to 19.' });
  for (const wrong of ['3 99', 'x']) {
    await field.fill(wrong);
    await field.press('Enter');
    await alert.waitFor();
    assert.equal(await field.getAttribute('aria-invalid'), 'true');
  }
  await field.fill('3 7');
  await field.press('Enter');
  await alert.waitFor({ state: 'detached' });
  // Below a short tab there is no empty band.
  await page.locator('.recipe').waitFor();
  const panel = await page.getByRole('tabpanel').boundingBox();
  const text = await page.locator('.recipe').boundingBox();
  assert.ok(panel.height < text.height + 60, `${panel.height} ${text.height}`);
});

test('squares of a selected pair keep their colour', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5&at=4&sel=3~7');
  const middle = await page.locator('.coverage-over').evaluate((canvas) => {
    const side = canvas.width / 20;
    const at = [Math.floor(3.5 * side), Math.floor(7.5 * side)];
    return [...canvas.getContext('2d').getImageData(...at, 1, 1).data];
  });
  assert.deepEqual(middle, [0, 0, 0, 0]);
  await page.goto(page.url().replace(/#.*/, '#/design?v=20&k=5&show=coverage'));
  const colours = await page
    .locator('.key-more')
    .evaluate((key) => [
      getComputedStyle(key).backgroundColor,
      getComputedStyle(document.documentElement).getPropertyValue('--mark'),
    ]);
  assert.notEqual(colours[0], 'rgb(214, 0, 108)', colours[1]);
});

test('what a researcher asks of a design, how to cite it, and its write-up', async (explorer) => {
  const page = await explorer.open('#/design?v=40&k=6&change=2&kind=circular');
  const fact = (name) =>
    page.locator('.fact-table tr', { has: page.locator('th', { hasText: name }) }).locator('td');
  const cell = ['40', '6', '--change', '2', '--circular'];
  const text = execFileSync(program, ['design', ...cell, '--format', 'text']);
  const verified = JSON.parse(execFileSync(program, ['verify', '--json', '-'], { input: text }));
  const { excess } = verified.details;
  await page.waitForFunction(() => !/…$/m.test(document.querySelector('.fact-table').innerText));
  assert.match(
    await fact('excess').innerText(),
    new RegExp(`^(${excess}: newly covered again |${excess} pairs newly covered twice: )`),
  );
  assert.equal(await fact('group').innerText(), 'order 1');
  const stays = verified.details.elements.map(({ introductions }) => introductions);
  const said = [...new Set(stays)]
    .sort((one, other) => one - other)
    .map((n) => `${stays.filter((each) => each === n).length} elements with ${n}`);
  assert.equal(await fact(/^stays/).innerText(), said.join(', '));
  assert.match(
    await fact('unchanged subsets').innerText(),
    new RegExp(`^${verified.details.unchanged_subsets} different`),
  );
  const label = (await page.locator('.under .code').innerText()).trim();
  assert.ok((await fact('SHA-256').innerText()).startsWith(label.split('.').at(-1)));
  await fact('source').getByRole('link', { name: 'concatenate-groups' }).waitFor();
  assert.match(await fact('date').innerText(), /^\d{4}-\d\d-\d\d$/);
  await page.locator('.chips', { hasText: '1 over the bound 87' }).waitFor();
  await page.getByRole('button', { name: `Cite ${label}` }).click();
  await page.locator('.bibtex pre', { hasText: label }).waitFor();
  const address = await page
    .getByRole('link', { name: 'Write-up', exact: true })
    .getAttribute('href');
  const answer = await page.request.get(new URL(address, page.url()).href);
  assert.match(await answer.text(), /A circular DCCD\(40,6\) with 88 blocks/);
  // What the catalog writes down has its words from there.
  const written = '9.4.2.circular.8.235d6c95';
  await page.goto(page.url().replace(/#.*/, `#/design?label=${written}`));
  await page.locator('.under .code', { hasText: written }).waitFor();
  await fact('source').getByText('Found and written down').waitFor();
  const [known] = (
    await (
      await page.request.get(new URL('api/cell?v=9&k=4&change=2&kind=circular', page.url()).href)
    ).json()
  ).designs.filter((each) => each.label === written);
  await fact('SHA-256').getByText(known.hash, { exact: true }).waitFor();
  await page.goBack();
  await page.locator('.under .code', { hasText: label }).waitFor();
  // The array is as wide as the page, at every width.
  await page.getByRole('tab', { name: 'Array' }).click();
  for (const width of [1280, 700, 390]) {
    await page.setViewportSize({ width, height: 900 });
    await page.waitForTimeout(200);
    const over = await page
      .getByRole('region', { name: 'Array of blocks' })
      .evaluate((frame) => frame.scrollWidth - frame.clientWidth);
    assert.ok(over <= 0, `${width}: ${over}`);
  }
});
