// A cell: bounds, recipe, designs of the catalog, neighbours.
import assert from 'node:assert/strict';
import { look, settled } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

test('what is known, and why', async (explorer) => {
  const page = await explorer.open('#/cell?v=108&k=5&change=2&kind=circular');
  assert.match(
    await page.locator('.known').textContent(),
    /\d+ blocks.*best known.*over the lower bound \d+/s,
  );
  assert.match(
    await page.getByRole('list', { name: 'Numbers of blocks' }).textContent(),
    /^up to \d+impossible\d+(–\d+)?open\d+best known$/,
  );
  await page.locator('table.bounds math').first().waitFor();
  await page.locator('canvas.thumbnail').waitFor();
  await page.locator('#top a[aria-current=true]', { hasText: 'Catalog' }).waitFor();
  await page.locator('.around-table a[aria-current]', { hasText: /^\d+$/ }).waitFor();
  assert.equal(await page.locator('.around-table tbody tr').count(), 5);
  assert.match(await page.locator('table.bounds').textContent(), /counting.*stays/s);
  assert.match(
    await page.locator('.recipe').first().textContent(),
    /concatenate-groups.*Theorem 15.*found/s,
  );
  await page.getByRole('link', { name: 'Theorem 15', exact: true }).first().click();
  await page.locator('#theorem-15.chosen').waitFor();
  await page.goBack();
  await settled(page);
  await page.getByRole('button', { name: /^Cite/ }).first().click();
  await page.locator('.bibtex pre', { hasText: '@misc{' }).waitFor();
});

test('a minimum says by which argument', async (explorer) => {
  const page = await explorer.open('#/cell?v=20&k=5');
  assert.match(
    await page.locator('.known').textContent(),
    /29.*minimum.*No design has fewer blocks: degree bound/s,
  );
  assert.equal(await page.getByRole('link', { name: 'Search for a better one' }).count(), 0);
  // What made it is a construction that the page Theorems has, in the summary and in the history.
  for (const to of await page
    .locator('a[href*="construction="]')
    .evaluateAll((links) => links.map((link) => link.getAttribute('href')))) {
    assert.ok(!to.includes('literal'), to);
  }
  await page.getByRole('link', { name: 'Open the design' }).click();
  await page.getByRole('heading', { name: /29 blocks/ }).waitFor();
});

test('how many there are, and what others report', async (explorer) => {
  const page = await explorer.open('#/cell?v=9&k=4&change=1&kind=circular');
  await page.getByText('2 classes').waitFor();
  await page.getByText('1 with a group of order 3').waitFor();
  await page.goto(page.url().replace(/#.*/, '#/cell?v=26&k=6&change=1&kind=linear'));
  const bean = page.locator('.known a', { hasText: 'Bean 2026' });
  await bean.waitFor();
  assert.match(await bean.getAttribute('href'), /^https:\/\/arxiv\.org/);
});

test('the head of a cell names the strength, and says what the recipe says', async (explorer) => {
  const page = await explorer.open('#/cell?v=8&k=4&change=2&kind=circular&strength=3');
  assert.match(await page.locator('.under').textContent(), /DCCD.*t\s*=\s*3.*cell 8\.4\.2/s);
  assert.deepEqual(await page.locator('.known .figure .badge').allTextContents(), [
    'minimum',
    'tight',
  ]);
  await page
    .locator('.recipe')
    .getByRole('link', { name: /DCCD\(8,4\), t.=.3/ })
    .waitFor();
});

test('where none exists, the cell is framed among its neighbours', async (explorer) => {
  const page = await explorer.open('#/cell?v=6&k=5&change=5');
  for (const width of [1280, 390]) {
    await page.setViewportSize({ width, height: 844 });
    await page.locator('.around-table [aria-current]', { hasText: 'there is no design' }).waitFor();
    const columns = await page
      .locator('.around-table th[scope=col]')
      .evaluateAll((all) => all.map((each) => each.getBoundingClientRect().width));
    assert.ok(Math.min(...columns) > 28, `columns are ${columns} px wide at ${width} px`);
    assert.ok(Math.max(...columns) - Math.min(...columns) < 4, `columns: ${columns}`);
  }
  await page.setViewportSize({ width: 1280, height: 900 });
  const place = (locator) => locator.boundingBox();
  const around = await place(page.getByRole('heading', { name: 'Around this cell' }));
  const side = await place(page.getByRole('heading', { name: 'On the command line' }));
  assert.ok(around.x < side.x && Math.abs(around.y - side.y) < 4, 'side by side');
});

test('beyond the catalog, too, all is in one place', async (explorer) => {
  for (const cell of ['v=300&k=6&change=2&kind=circular', 'v=30&k=9&change=4&kind=linear']) {
    const page = await explorer.open(`#/cell?${cell}`);
    await page.getByRole('heading', { name: 'How many there are' }).waitFor();
    await page.getByText('The catalog does not hold this design').waitFor();
    await page.getByRole('button', { name: 'Cite the catalog' }).click();
    await page.locator('.bibtex pre', { hasText: '@misc{changeover-catalog' }).waitFor();
    await page.locator('.around-table a[aria-current]', { hasText: /^\d+$/ }).waitFor();
    assert.equal(await page.locator('.around-table tbody tr').count(), 5);
    await page.close();
  }
});

test('of many designs the first are shown, the others unfolded', async (explorer) => {
  const page = await explorer.open('#/cell?v=10&k=4&change=1&kind=circular');
  await page.locator('summary', { hasText: 'more designs of this cell' }).click();
  assert.ok((await page.locator('.origin:visible').count()) > 10);
  assert.equal(await page.locator('.origin.best').count(), 1);
});

test('arrow keys lead to the neighbours', async (explorer) => {
  const page = await explorer.open('#/cell?v=20&k=5');
  await page.keyboard.press('ArrowRight');
  await page.getByRole('heading', { name: /21 elements in blocks of 5/ }).waitFor();
  await page.keyboard.press('ArrowDown');
  await page.getByRole('heading', { name: /21 elements in blocks of 6/ }).waitFor();
  await page.getByRole('link', { name: 'linear', exact: true }).click();
  await page.getByRole('heading', { name: /^Linear/ }).waitFor();
  await settled(page);
});

test('what does not exist, and addresses without a cell', async (explorer) => {
  const page = await explorer.open('#/cell?v=6&k=5&change=5');
  await page.getByText('There is none').waitFor();
  assert.equal(await page.getByRole('heading', { name: 'How it is made' }).count(), 0);
  await page.goto(page.url().replace(/#.*/, '#/cell?v=x'));
  await page.getByRole('heading', { name: 'Which cell?' }).waitFor();
});

test('what the server refuses is said', async (explorer) => {
  const page = await explorer.open('#/cell?v=5&k=50', { mayFail: /status of 4\d\d/ });
  assert.ok((await page.locator('.problem, .note').first().textContent()).length > 20);
});

test('around a cell without a design are lower bounds, in italics', async (explorer) => {
  const page = await explorer.open('#/cell?v=30&k=6&change=2&kind=circular&strength=3');
  const own = page.locator('.around-table a[aria-current]');
  await own.waitFor();
  const bound = await page.locator('.bounds tbody tr td').first().textContent();
  assert.match(bound, /^\d+$/);
  assert.equal(await own.textContent(), bound);
  assert.equal(await own.evaluate((it) => getComputedStyle(it).fontStyle), 'italic');
  await page.getByText('In italics: no design is known').waitFor();
  assert.equal(
    await page.getByRole('list', { name: 'Numbers of blocks' }).textContent(),
    `up to ${bound - 1}impossible${bound} or moreopen`,
  );
});

test('downloads are files of the server', async (explorer) => {
  const page = await explorer.open('#/cell?v=9&k=4');
  const waiting = page.waitForEvent('download');
  await page.getByRole('link', { name: 'Text', exact: true }).click();
  assert.match((await waiting).suggestedFilename(), /\.(txt|text)$/);
});

test('it looks right', async (explorer) => {
  const page = await explorer.open('#/cell?v=40&k=6');
  await look(page, 'cell');
  await phone(page, 'cell');
});

test('what the signs of a bound mean stands beside it', async (explorer) => {
  const page = await explorer.open('#/cell?v=20&k=5');
  const degree = page.locator('.bounds tr', { hasText: 'degree' });
  await degree.getByText('how many times').waitFor();
  const said = await degree.locator('.defined').textContent();
  for (const meaning of ['is introduced', 'how many blocks contain', 'newly covered again']) {
    assert.ok(said.includes(meaning), said);
  }
  assert.equal(
    await page.locator('.bounds tr', { hasText: 'end to end' }).locator('.defined').count(),
    0,
  );
});

test('recipes of triples lead to triples, and signs in them are set', async (explorer) => {
  const page = await explorer.open('#/cell?v=8&k=4&change=2&kind=circular&strength=3');
  assert.match(await page.locator('.recipe a').first().getAttribute('href'), /v=8&k=4.*strength=3/);
  await page.goto(page.url().replace(/#.*/, '#/cell?v=12&k=7'));
  const text = page.locator('.recipe-node', { hasText: 'short-long-runs' });
  await text.locator('math', { hasText: '∞' }).first().waitFor();
  assert.ok(!(await text.textContent()).includes('∞_'));
});

test('a dossier is a page with its style, works in words and no line wider than a phone', async (explorer) => {
  const page = await explorer.open('#/cell?v=9&k=3&change=1');
  const link = page.getByRole('link', { name: 'Write-up for a paper' });
  const to = await link.getAttribute('href');
  await page.goto(new URL(to, page.url()).href);
  const heading = page.getByRole('heading', { level: 1 });
  assert.equal(await heading.textContent(), 'A circular SCCD(9,3) with 18 blocks');
  const body = page.locator('body');
  assert.ok((await body.evaluate((it) => it.clientWidth)) < 900, 'its own style holds');
  assert.ok(!/\[[A-Z][A-Za-z]+\d{4}/.test(await body.textContent()), 'no keys in the text');
  await page
    .locator('li', { hasText: 'stays' })
    .getByRole('link', { name: /^Theorem 5/ })
    .waitFor();
  await page.emulateMedia({ colorScheme: 'dark' });
  assert.notEqual(
    await body.evaluate((it) => getComputedStyle(it).backgroundColor),
    'rgb(255, 255, 255)',
  );
  await page.setViewportSize({ width: 390, height: 844 });
  assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  await page
    .getByRole('link', { name: /^Theorem 5/ })
    .first()
    .click();
  // What it says stands below, and its proof is a click away.
  const quoted = page.locator('section#theorem-5');
  await quoted.getByText('a lower bound for every list').waitFor();
  await quoted.getByRole('link', { name: 'Theorem 5', exact: true }).click();
  await page.locator('#theorem-5.chosen').waitFor();
});

test('cells without designs are alike: why, and what is around', async (explorer) => {
  const page = await explorer.open('#/cell?v=4&k=5');
  for (const cell of ['v=4&k=5', 'v=6&k=5']) {
    await page.goto(page.url().replace(/#.*/, `#/cell?${cell}&change=2&kind=circular`));
    await page.locator('.note', { hasText: 'There is none: ' }).waitFor();
    await page.getByRole('heading', { name: 'Around this cell' }).waitFor();
  }
  await page.goto(page.url().replace(/#.*/, '#/cell?v=0&k=0'));
  await page.getByRole('heading', { name: 'Which cell?' }).waitFor();
});

test('a bound that rests on the stays links their theorem', async (explorer) => {
  const page = await explorer.open('#/cell?v=9&k=4&change=2&kind=linear');
  await page
    .locator('.bounds tr', { hasText: 'degree program' })
    .getByRole('link', { name: 'Theorem 5' })
    .waitFor();
});
