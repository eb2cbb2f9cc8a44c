// The page that checks designs.
import assert from 'node:assert/strict';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { look, settled } from './support/browser.mjs';
import { inSight, phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

const design = [
  '# changeover design v=7 k=3 change=2 kind=circular',
  '0 1 3',
  '1 2 4',
  '2 3 5',
  '3 4 6',
  '0 4 5',
  '1 5 6',
  '0 2 6',
  '',
].join('\n');
const box = (page) => page.getByRole('textbox', { name: /^The design/ });

test('an empty page says what to do; nothing to check is said there', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page.getByRole('link', { name: 'a good one' }).waitFor();
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByRole('alert').getByText('nothing to check yet').waitFor();
  await look(page, 'verify-empty');
});

test('a good design: the verdict, its reasons, facts and elements', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page.getByRole('link', { name: 'a good one' }).click();
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page.getByText('It is minimum').waitFor();
  const fact = (name) =>
    page
      .locator('table.facts tr', { has: page.getByRole('rowheader', { name, exact: true }) })
      .locator('td')
      .first();
  assert.equal(await fact('blocks b').textContent(), '8');
  assert.equal(await fact('tight').textContent(), 'no');
  assert.equal(await fact('minimum').textContent(), 'yes, proved');
  assert.equal(await fact('excess').textContent(), '5 of 41 newly covered');
  assert.equal(
    await page
      .getByRole('list', { name: /^Elements/ })
      .getByRole('listitem')
      .count(),
    9,
  );
  const rows = page.getByRole('list', { name: 'The 8 blocks' }).getByRole('listitem');
  assert.equal(await rows.count(), 8);
  assert.deepEqual((await rows.nth(1).locator('.element.in').allTextContents()).sort(), ['2', '5']);
  assert.deepEqual(
    (await rows.nth(1).locator('s').allTextContents()).map((text) => text.trim()).sort(),
    ['1', '3'],
  );
  await look(page, 'verify-good');
});

test('a wrong step is marked in its place; buttons lead to the next', async (explorer) => {
  const page = await explorer.open('#/verify?example=steps');
  await page.getByRole('heading', { name: '✗ Not a design' }).waitFor();
  const bad = page.locator('.block.bad');
  await bad.first().waitFor();
  assert.equal(await bad.count(), 2);
  await bad.first().getByText('3 elements change, 2 should').waitFor();
  await page.getByText('1 of 2: the step from block 5 to block 6', { exact: true }).waitFor();
  await page.getByRole('button', { name: 'Next wrong step ›' }).click();
  await page.getByText('2 of 2: the step from block 7 to block 8', { exact: true }).waitFor();
  await look(page, 'verify-steps');
});

test('an uncovered pair leads to its elements, and the choice is in the link', async (explorer) => {
  const page = await explorer.open('#/verify?example=pairs');
  const pair = page.getByRole('button', { name: '{6, 7}' });
  await pair.click();
  await page.getByText('No block has all of them').waitFor();
  assert.equal(await pair.getAttribute('aria-pressed'), 'true');
  assert.ok((await page.locator('.element.of-pair').count()) > 0);
  await page.reload();
  await settled(page);
  assert.equal(
    await page.getByRole('button', { name: '{6, 7}' }).getAttribute('aria-pressed'),
    'true',
  );
  await look(page, 'verify-pairs');
});

test('a typing error is shown at its line and column', async (explorer) => {
  const page = await explorer.open('#/verify?example=typing', { mayFail: /status of 422/ });
  await page.getByRole('alert').waitFor();
  await page.locator('.excerpt-line.here', { hasText: '2 3 4 4' }).waitFor();
  await page.getByRole('button', { name: 'Go to line 5 in the text' }).click();
  assert.equal(
    await box(page).evaluate((field) =>
      field.value.slice(field.selectionStart, field.selectionEnd),
    ),
    '2 3 4 4',
  );
  await look(page, 'verify-typing');
});

test('a pasted text: keyboard alone, in the link, survives a reload', async (explorer) => {
  const page = await explorer.open('#/verify');
  await box(page).focus();
  await page.keyboard.insertText(design);
  await page.keyboard.press('Control+Enter');
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page
    .getByText('circular double-change covering design on 7 elements in blocks of 3')
    .waitFor();
  assert.match(page.url(), /text=/);
  const other = await explorer.open(new URL(page.url()).hash);
  await other.getByRole('heading', { name: '✓ Valid' }).waitFor();
  assert.equal(await box(other).inputValue(), design);
});

test('what the file says can be overruled', async (explorer) => {
  const page = await explorer.open('#/verify?example=good');
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page.getByRole('combobox', { name: 'Change number' }).selectOption('1');
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByRole('heading', { name: '✗ Not a design' }).waitFor();
  await page.getByText('7 steps do not change exactly 1 element').waitFor();
  assert.match(page.url(), /change=1/);
});

test('a file is chosen; the design opens in the viewer', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page
    .getByLabel('A file with a design')
    .setInputFiles({ name: 'fano.txt', mimeType: 'text/plain', buffer: Buffer.from(design) });
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page.getByRole('link', { name: 'Open in the viewer' }).click();
  await page.waitForURL(/design\?local=1/);
  const local = await page.evaluate(() => JSON.parse(sessionStorage.getItem('changeover-local')));
  assert.equal(local.v, 7);
  assert.deepEqual(local.blocks[1], [1, 2, 4]);
});

test('a valid design goes into the catalog, once', async (explorer) => {
  const page = await explorer.open('#/verify?example=good');
  const add = page.getByRole('button', { name: 'Add to my catalog' });
  await add.click();
  const label = await page.locator('.actions a[href*="label="]').textContent();
  assert.match(label, /^9\.4\.2\.linear\.8\./);
  await page.reload();
  await settled(page);
  await add.click();
  await page.getByText('Your catalog has it already').waitFor();
});

test('a file is dropped; what another page hands over is checked at once', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page.locator('.verify-form').evaluate((form, text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], 'dropped.txt', { type: 'text/plain' }));
    form.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
  }, design);
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  assert.equal(await box(page).inputValue(), design);
  const other = await explorer.open('#/verify');
  await other.evaluate((text) => sessionStorage.setItem('changeover-text', text), design);
  await other.goto(new URL('#/verify?pasted=1', other.url()).href);
  await other.getByRole('heading', { name: '✓ Valid' }).waitFor();
});

test('names of elements are kept', async (explorer) => {
  const page = await explorer.open('#/verify');
  await box(page).fill('a b c\nc d a\nd e a\n');
  await page.getByRole('combobox', { name: 'Change number' }).selectOption('1');
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByRole('button', { name: '{b, d}' }).click();
  await page.getByText('b is in block 1; d is in blocks 2, 3. No block has all of them.').waitFor();
});

/** A file with so many rounds of a circular design: valid steps all the way. */
function rounds(count) {
  const folder = mkdtempSync(join(tmpdir(), 'changeover-large-'));
  const path = join(folder, 'large.txt');
  writeFileSync(
    path,
    '# changeover design v=7 k=3 change=2 kind=circular\n' +
      '0 1 3\n1 2 4\n2 3 5\n3 4 6\n0 4 5\n1 5 6\n0 2 6\n'.repeat(count),
  );
  return { path, remove: () => rmSync(folder, { recursive: true }) };
}

test('a large file is read beside the page, and its list goes to the end', async (explorer) => {
  const page = await explorer.open('#/verify');
  const file = rounds(28_000);
  const worker = page.waitForEvent('worker');
  await page.getByLabel('A file with a design').setInputFiles(file.path);
  await worker;
  await page.getByText('too long to be shown here').waitFor();
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor({ timeout: 120_000 });
  file.remove();
  const list = page.getByRole('group', { name: /^The 196.000 blocks/ });
  await list.focus();
  await page.keyboard.press('End');
  await page.locator('.block-number', { hasText: /^196.000$/ }).waitFor();
  assert.ok((await list.getByRole('listitem').count()) < 100);
  await look(page, 'verify-large');
});

test('a list with more blocks than a page can show is checked all the same', async (explorer) => {
  const page = await explorer.open('#/verify');
  const file = rounds(230_000);
  await page.getByLabel('A file with a design').setInputFiles(file.path);
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor({ timeout: 120_000 });
  file.remove();
  await page.getByText(/its 1.610.000 blocks are too many/).waitFor();
  await page.locator('table.facts').waitFor();
});

test('on a phone nothing scrolls sideways but the frames', async (explorer) => {
  const page = await explorer.open('#/verify?example=pairs');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.getByRole('heading', { name: '✗ Not a design' }).waitFor();
  assert.ok((await page.evaluate(() => document.documentElement.scrollWidth)) <= 390);
  await phone(page, 'verify');
});

test('on a phone the verdict comes into sight when it was asked for', async (explorer) => {
  const page = await explorer.open('#/verify?example=good');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await page.locator('.verdict').waitFor();
  assert.equal(await page.evaluate(() => window.scrollY), 0, 'a link is read from its top');
  const verdict = page.locator('.verdict h2');
  const led = () => page.waitForFunction(() => document.activeElement?.matches('.verdict h2'));
  await page.getByRole('link', { name: 'one with bad steps' }).click();
  await page.getByRole('heading', { name: 'Not a design' }).waitFor();
  await led();
  assert.ok(await inSight(verdict));
  await page.getByRole('textbox', { name: 'The design' }).fill(design);
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByRole('heading', { name: 'Valid' }).waitFor();
  await led();
  assert.ok(await inSight(verdict));
  // In a wide window who goes on writing is left there, and nothing moves that is in sight.
  await page.setViewportSize({ width: 1280, height: 900 });
  const text = page.getByRole('textbox', { name: 'The design' });
  await text.fill(design.replace('0 1 3', '0 1 5'));
  await page.evaluate(() => window.scrollTo(0, 0));
  await text.press('Control+Enter');
  await page.getByRole('heading', { name: 'Not a design' }).waitFor();
  assert.ok(await text.evaluate((element) => element === document.activeElement));
  assert.equal(await page.evaluate(() => window.scrollY), 0);
});

test('a repair is suggested, and used', async (explorer) => {
  const page = await explorer.open('#/verify?example=steps');
  await page.getByText(/keeps \d of your 8 blocks/).waitFor({ timeout: 60_000 });
  // What is said is what is marked, and together it is the list that was given and the new one.
  const said = await page.locator('.repair p', { hasText: 'keeps' }).textContent();
  const [, b, kept, had, gone, come] =
    /with (\d+) blocks.*keeps (\d+) of your (\d+) blocks, removes (\w+) and adds (\w+)\./.exec(
      said,
    );
  const figure = (word) => (word === 'none' ? 0 : Number(word));
  assert.ok(figure(come) > 0);
  assert.equal(await page.locator('.repair-new').count(), figure(come));
  assert.equal(await page.locator('.repair-old').count(), figure(gone));
  assert.equal(figure(kept) + figure(gone), figure(had));
  assert.equal(figure(kept) + figure(come), figure(b));
  await look(page, 'verify-repair');
  await page.getByRole('button', { name: 'Use the repaired list' }).click();
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
});

test('where a name stands among numbers a repair without it is offered', async (explorer) => {
  const page = await explorer.open('#/verify');
  const text = '1 3 7 8\n2 5 7 8\n0 2 3 8\n2 3 4 5\n1 2 3 6\n0 1 5 6\n0 x 4 7\n4 6 7 8\n';
  await page.getByRole('textbox').first().fill(text);
  await page.getByRole('button', { name: 'Check' }).click();
  await page.getByText('All elements are numbers but x in block 7').waitFor();
  const without = page.locator('.repair', { hasText: 'Repair without x' });
  await without.locator('.repair-lines').waitFor({ timeout: 60_000 });
  assert.ok(!(await without.locator('.repair-lines').textContent()).includes('x'));
  assert.equal(await page.locator('.repair h2', { hasText: 'Repair with x' }).count(), 1);
  await without.getByRole('button', { name: 'Use the repaired list' }).click();
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page.getByText('linear double-change covering design on 9 elements').waitFor();
});

test('a repair says how many blocks it removes, and marks them', async (explorer) => {
  const page = await explorer.open('#/verify?example=pairs');
  await page.locator('.repair-lines').waitFor({ timeout: 60_000 });
  const gone = await page.locator('.repair-old').count();
  assert.ok(gone > 0);
  await page.locator('.repair p', { hasText: `removes ${gone} and adds` }).waitFor();
  assert.equal(await page.locator('.repair-old', { hasText: 'removed' }).count(), gone);
});

test('a design that is known is cited, with the reason of its bound', async (explorer) => {
  const page = await explorer.open('#/verify?example=good');
  await page
    .locator('.verify-citation', { hasText: /9\.4\.2\.linear\.8\.|not the one in the catalog/ })
    .waitFor();
  await page.locator('.verify-citation pre', { hasText: '@misc{' }).waitFor();
  await page.locator('.verdict .reason math').first().waitFor();
});

test('what comes is said before a check, and that the server is gone', async (explorer) => {
  const other = await explorer.another();
  const page = await other.open('#/verify', { mayFail: /ERR_/ });
  await page.getByRole('heading', { name: 'What the answer says' }).waitFor();
  await other.server.stop();
  await page.getByRole('link', { name: 'a good one' }).click();
  await page.getByRole('heading', { name: 'This was not checked' }).waitFor();
  await page.getByRole('alert').getByText('The server does not answer.').waitFor();
  assert.equal(await page.getByRole('alert').locator('code').textContent(), 'changeover serve');
});

test('a list of triples is told in triples, and leads to what is known of them', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page
    .getByRole('textbox', { name: /one block per line/ })
    .fill(
      '# changeover design v=8 k=5 change=2 kind=circular strength=3\n' +
        '0 1 2 3 4\n0 1 2 5 6\n0 4 3 5 6\n0 3 1 5 7\n4 6 1 5 7\n2 6 1 3 7\n2 6 0 4 7\n2 3 5 4 7\n',
    );
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page.getByText('Every one of the 56 triples is in a block').waitFor();
  await page.locator('dfn[title^="every triple of elements is in some block"]').waitFor();
  assert.match(
    await page.getByRole('link', { name: 'What is known for these' }).getAttribute('href'),
    /strength=3/,
  );
});

test('a linear list that closes is told to be circular; one block is trivial', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page.locator('textarea').fill('a b c\nb c d\nc d e\nd e a\ne a b\n');
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await page.locator('.verdict', { hasText: 'also a circular design, and a tight one' }).waitFor();
  await page.getByRole('button', { name: 'Take it as circular' }).click();
  await page.locator('.verdict strong', { hasText: 'circular single-change' }).waitFor();
  const tight = page.locator('.verify-facts tr', { hasText: 'tight' }).first();
  assert.match(await tight.textContent(), /^tightyes/);
  await page.getByLabel('Kind').selectOption('');
  await page.locator('textarea').fill('hello world this is not');
  await page.getByRole('button', { name: 'Check', exact: true }).click();
  await page.getByRole('heading', { name: 'Valid, but trivial' }).waitFor();
  assert.equal(await page.locator('.bibtex').count(), 0);
});

test('the excess of a list with missing pairs is what is newly covered again', async (explorer) => {
  const page = await explorer.open('#/verify');
  await page.getByRole('link', { name: 'one with missing pairs' }).click();
  const excess = page.locator('.verify-facts tr', { hasText: 'excess' });
  // 33 of 36 pairs are covered: 41 − 33.
  await excess.getByText('8 of 41 newly covered').waitFor();
  await excess.locator('dfn').getByRole('link', { name: 'excess' }).waitFor();
});
