// The page of searches: they run in the server, and one stream of events tells all pages of a
// window about them.
import assert from 'node:assert/strict';
import { look, settled } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
import { ownServer, test } from './support/tests.mjs';

ownServer();

async function begin(page, v, k, { seconds = '10', change = '2', kind = 'linear' } = {}) {
  await page.getByRole('spinbutton', { name: 'Elements v' }).fill(String(v));
  await page.getByRole('spinbutton', { name: 'Block size k' }).fill(String(k));
  await page.getByRole('combobox', { name: 'Change number' }).selectOption(change);
  await page.getByRole('combobox', { name: 'Kind' }).selectOption(kind);
  await page.getByRole('combobox', { name: 'Time' }).selectOption(seconds);
  // Where there is nothing to find it offers less.
  await page.getByRole('button', { name: /^(Start|Search all the same)$/ }).click();
}
const watched = (page) => page.locator('.watch');

test('what is missing is said', async (explorer) => {
  const page = await explorer.open('#/search');
  await page.locator('.stream[data-state=open]').waitFor({ state: 'attached' });
  await page.getByRole('button', { name: 'Start' }).click();
  await page.getByRole('alert').getByText('Write v').waitFor();
  await look(page, 'search-empty');
});

test('before a search the page says where to begin', async (explorer) => {
  const page = await explorer.open('#/search');
  const begin = page.locator('.search-begin');
  await begin.getByText(/^In \d+ cells of the circular double-change designs/).waitFor();
  await page.getByRole('combobox', { name: 'Kind' }).selectOption('linear');
  await begin.getByText(/^In \d+ cells of the linear double-change designs/).waitFor();
  const cell = begin.getByRole('link', { name: /^linear DCCD/ }).last();
  const [, v, k] = /\((\d+),(\d+)\)/.exec(await cell.textContent());
  await cell.click();
  await page.getByText(/^Gap 1: a design with/).waitFor();
  assert.equal(await page.getByRole('spinbutton', { name: 'Elements v' }).inputValue(), v);
  assert.equal(await page.getByRole('spinbutton', { name: 'Block size k' }).inputValue(), k);
  await begin.getByRole('link', { name: 'linear DCCD(9,5)' }).click();
  await page.getByText('Goes up from the lower bound').waitFor();
});

test('a cell comes with the link, and what is known of it is said', async (explorer) => {
  const page = await explorer.open('#/search?v=9&k=4&change=2&kind=linear');
  await page.getByText('Gap 0: a design with 8 blocks is known, and none has fewer').waitFor();
  assert.equal(await page.getByRole('spinbutton', { name: 'Elements v' }).inputValue(), '9');
});

test('a search: started, watched, stopped; it survives reloads', async (explorer) => {
  const page = await explorer.open('#/search');
  await begin(page, 30, 6, { seconds: '60' });
  await watched(page)
    .getByText(/^Running after/)
    .waitFor();
  // Flat lines are not drawn: what is open is said, and a curve comes when the best has moved.
  assert.match(
    await watched(page).getByRole('list', { name: 'Numbers of blocks' }).textContent(),
    /^up to \d+impossible\d+(–\d+)?open\d+best known/,
  );
  assert.match(page.url(), /id=\d+/);
  // The gap and what follows from it come first, the speed is folded.
  assert.match(
    await watched(page).locator('.figures').textContent(),
    /^gap\d+best\d+lower bound\d+last improvement/,
  );
  await watched(page)
    .locator('.advice', { hasText: /early|No improvement/ })
    .waitFor();
  assert.equal(
    await watched(page).locator('details', { hasText: 'Speed' }).getAttribute('open'),
    null,
  );
  await look(page, 'search-running');
  await page.reload();
  await settled(page);
  await watched(page)
    .getByText(/^Running after/)
    .waitFor();
  await page.getByRole('link', { name: 'Theorems' }).click();
  await page.goBack();
  await watched(page).getByRole('button', { name: 'Stop' }).click();
  await watched(page)
    .getByText(/^Stopped after/)
    .waitFor();
  await page.locator('.searches .badge.stopped').first().waitFor();
  await watched(page)
    .getByRole('heading', { name: /^(No better design was found: )?\d+ blocks/ })
    .waitFor();
  await look(page, 'search-stopped');
  // Again means longer, from another beginning.
  await watched(page).getByRole('link', { name: 'Search again' }).click();
  await page.waitForURL(/seconds=600&seed=2|seed=2.*seconds=600/);
  // The address changes before the page is drawn.
  await page
    .getByRole('combobox', { name: 'Time' })
    .locator('option:checked', { hasText: '10 minutes' })
    .waitFor({ state: 'attached' });
});

test('what it found opens in the viewer and is kept in the catalog', async (explorer) => {
  const page = await explorer.open('#/search?v=12&k=5&change=1&kind=linear&strength=3&seconds=10');
  await page.getByText('No design is known yet; none').waitFor();
  await page.getByText('Starts from random blocks').waitFor();
  await page.getByRole('button', { name: 'Start' }).click();
  await watched(page)
    .getByText(/^(Done|Stopped) after/)
    .waitFor({ timeout: 60_000 });
  // It is not a known one.
  await watched(page)
    .getByRole('heading', { name: /^The first design: \d+ blocks$/ })
    .waitFor();
  await watched(page).locator('.ladder .best', { hasText: 'this search' }).waitFor();
  await watched(page).getByText('no design was known before').waitFor();
  await watched(page).getByRole('button', { name: 'Add to my catalog' }).click();
  // The result comes first, then what can be done with it.
  const [result, open, reasons] = await Promise.all(
    ['.watch-result', '.button[href*="design"]', '.button[href*="cell"]'].map((each) =>
      watched(page).locator(each).boundingBox(),
    ),
  );
  assert.ok(result.y < open.y && open.y === reasons.y && result.height > 30);
  const label = await watched(page).locator('a[href*="label="]').textContent();
  assert.match(label, /^12\.5\.1\.linear\.t3\.\d+\./);
  await watched(page).getByRole('link', { name: 'Open the design' }).click();
  await page.waitForURL(/design\?job=\d+/);
});

test('where no better design was found, the next step is another search', async (explorer) => {
  const page = await explorer.open('#/search?v=40&k=6&seconds=10');
  await page.getByText(/^Gap 1: a design with 88 blocks/).waitFor();
  await page.getByRole('button', { name: 'Start' }).click();
  await watched(page)
    .getByRole('heading', { name: 'No better design was found: 88 blocks, as before' })
    .waitFor({ timeout: 60_000 });
  assert.deepEqual(
    await watched(page)
      .locator('.next-steps > :visible')
      .evaluateAll((all) => all.map((each) => [each.textContent, each.matches('.plain')])),
    [
      ['Search again …', false],
      ['Open the design', true],
      ['What is known of the gap', true],
    ],
  );
  await page.locator('.of-server tr.own', { hasText: '88 blocks, no better' }).waitFor();
});

test('exact, from base blocks, with locked sets', async (explorer) => {
  const page = await explorer.open('#/search', { mayFail: /status of 4/ });
  await page.getByRole('combobox', { name: 'Method' }).selectOption('exact');
  assert.ok(await page.getByRole('spinbutton', { name: 'Seed' }).isHidden());
  await begin(page, 8, 4, { change: '1', seconds: '60' });
  await watched(page)
    .getByRole('heading', { name: /^\d+ blocks, the minimum$/ })
    .waitFor({ timeout: 60_000 });
  await watched(page).locator('.advice', { hasText: 'Nothing is left to find' }).waitFor();
  // Number by number: what was decided, how long it took, and the bound that rises with it.
  await begin(page, 9, 5, { seconds: '60' });
  await watched(page)
    .locator('.decisions tr.none', { hasText: 'there is none: the proof was checked' })
    .waitFor({ timeout: 60_000 });
  assert.match(
    await watched(page).locator('.figures').textContent(),
    /^gap0best6lower bound6numbers decided1$/,
  );
  assert.ok(!(await watched(page).textContent()).includes('not decided'));
  await begin(page, 15, 6, { seconds: '60' });
  await watched(page)
    .locator('.decisions tr.running', { hasText: /^12being decided/ })
    .waitFor();
  assert.match(
    await watched(page).locator('.figures').textContent(),
    /^gap1best13lower bound12deciding now12 blocks$/,
  );
  await watched(page).getByRole('button', { name: 'Stop' }).click();
  await watched(page).locator('.decisions tr.unknown').waitFor();
  await page.getByRole('combobox', { name: 'Method' }).selectOption('locked');
  await page.getByRole('button', { name: 'Start' }).click();
  await page.getByRole('alert').filter({ hasText: 'first, last or expansion_set' }).waitFor();
  await page.getByLabel('In the first block').fill('0, 1');
  await begin(page, 9, 4, { change: '1' });
  await watched(page)
    .getByText(/locked sets$/)
    .waitFor();
  await watched(page)
    .getByRole('heading', { name: /^\d+ blocks/ })
    .waitFor({ timeout: 60_000 });
  await page.getByRole('combobox', { name: 'Method' }).selectOption('base-blocks');
  await begin(page, 9, 4, { change: '1', kind: 'circular' });
  await watched(page)
    .getByText(/base blocks$/)
    .waitFor();
  await look(page, 'search-ways');
});

test('a search of nonsense is refused in words', async (explorer) => {
  const page = await explorer.open('#/search', { mayFail: /status of 4/ });
  await begin(page, 5, 9);
  await page.getByRole('alert').waitFor();
});

test('a link to a search that the server has forgotten says so', async (explorer) => {
  const page = await explorer.open('#/search?id=999', { mayFail: /status of 404/ });
  await page.getByText('The server forgets its searches when it stops').waitFor();
});

test('the window has one stream of events, however often its pages change', async (explorer) => {
  const page = await explorer.open('#/theorems');
  let streams = 0;
  page.on('request', (request) => request.url().endsWith('/api/events') && ++streams);
  for (let i = 0; i < 3; ++i) {
    await page.getByRole('link', { name: 'Search', exact: true }).click();
    await page.locator('.stream[data-state=open]').waitFor({ state: 'attached' });
    await page.getByRole('link', { name: 'Verify', exact: true }).click();
    await page.getByRole('heading', { name: 'Verify a design' }).waitFor();
  }
  assert.equal(streams, 1);
});

test('without the token the page looks on, and says how to get it', async (explorer) => {
  const page = await explorer.context.newPage();
  await page.goto(`${explorer.server.origin}/#/search`);
  await settled(page);
  await page.getByText('it was opened without the token').waitFor();
  assert.ok(await page.getByRole('button', { name: 'Start' }).isDisabled());
});

test('a server that only reads says so; one that is gone is noticed', async (explorer) => {
  const reader = await explorer.another({ serve: ['--no-write'] });
  const page = await reader.open('#/search', { mayFail: /ERR_|status of/ });
  await page.getByText('--no-write').first().waitFor();
  assert.ok(await page.getByRole('button', { name: 'Start' }).isDisabled());
  await page.locator('.stream[data-state=open]').waitFor({ state: 'attached' });
  await reader.server.stop();
  await page.getByText('The server does not answer.').waitFor();
  await page.getByRole('button', { name: 'Try now' }).focus();
  await page.keyboard.press('Enter');
  await page.getByText('Trying again in').waitFor();
});

test('on a phone nothing scrolls sideways but the frames', async (explorer) => {
  const page = await explorer.open('#/search?v=30&k=6&change=2&kind=linear');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.locator('.searches tbody tr').first().waitFor();
  await page.locator('.searches button').first().click();
  await watched(page).getByText(/after/).waitFor();
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await phone(page, 'search');
});

test('a search that finds nothing stands beside what is known of its cell', async (explorer) => {
  const page = await explorer.open('#/search?v=9&k=4&way=base-blocks&seconds=10');
  await page.getByRole('button', { name: 'Search all the same' }).click();
  const bar = page.getByRole('list', { name: 'Numbers of blocks' });
  await bar.getByText('the minimum').waitFor();
  await bar.locator('.beside', { hasText: 'this search' }).waitFor();
  assert.deepEqual(await bar.locator('.best strong').allTextContents(), ['8']);
});

test('threads that there are not are marked in their field', async (explorer) => {
  const page = await explorer.open('#/search?v=9&k=4&threads=-3', { mayFail: /422/ });
  await page.getByRole('button', { name: 'Search all the same' }).click();
  await page.getByText(/^threads: write 1 to \d+/).waitFor();
  const threads = page.getByRole('spinbutton', { name: 'Threads' });
  assert.equal(await threads.getAttribute('aria-invalid'), 'true');
});
