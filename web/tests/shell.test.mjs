// What all pages share: navigation, theme, links, the token.
import assert from 'node:assert/strict';
import { accessibility, look, settled } from './support/browser.mjs';
import { inSight, phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

test('the token leaves the address and survives a reload', async (explorer) => {
  const page = await explorer.open('#/theorems');
  assert.ok(!page.url().includes('token'));
  await page.reload();
  await settled(page);
  assert.ok(await page.evaluate(() => sessionStorage.getItem('changeover-token')));
});

test('a page that opens the explorer has no hold on it', async (explorer) => {
  const other = await explorer.context.newPage();
  await other.goto('data:text/html,<p>elsewhere');
  const [opened] = await Promise.all([
    explorer.context.waitForEvent('page'),
    other.evaluate((address) => {
      globalThis.held = window.open(address);
    }, explorer.server.origin),
  ]);
  await settled(opened);
  assert.equal(await opened.evaluate(() => window.opener), null);
  await other.waitForFunction(() => globalThis.held.closed);
  await Promise.all([opened.close(), other.close()]);
});

test('every page of the navigation is reached by keyboard alone', async (explorer) => {
  const page = await explorer.open();
  const names = await page.locator('nav a').allTextContents();
  assert.ok(names.length >= 6);
  for (const name of names) {
    await page.locator('nav a', { hasText: name }).focus();
    await page.keyboard.press('Enter');
    await page.locator('nav a[aria-current=page]', { hasText: name }).waitFor();
    await settled(page);
  }
});

test('an address without a page says so and leads home', async (explorer) => {
  const page = await explorer.open('#/nowhere');
  assert.equal(await page.title(), 'No such page · Changeover');
  await page.getByRole('navigation').getByRole('link', { name: 'Plan' }).waitFor();
  await page.getByRole('link', { name: 'Go to the start page' }).click();
  await page.getByRole('heading', { name: 'Study designs' }).waitFor();
});

test('light and dark are a choice that lasts', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await page.getByRole('button', { name: /light and dark/ }).click();
  assert.equal(await page.locator('html').getAttribute('data-theme'), 'dark');
  await page.reload();
  await settled(page);
  assert.equal(await page.locator('html').getAttribute('data-theme'), 'dark');
});

test('the start page has three doors, a picture and an action each', async (explorer) => {
  const page = await explorer.open('#/home');
  assert.deepEqual(await page.locator('.door h2').allTextContents(), [
    'Test parts',
    'Load data',
    'Study designs',
  ]);
  assert.equal(await page.locator('.door-picture > *').count(), 3);
  await look(page, 'home');
  await phone(page, 'home');
  assert.ok(
    await inSight(page.getByRole('button', { name: 'Look up' })),
    'the look-up comes first',
  );
  await page.setViewportSize({ width: 1280, height: 900 });
  for (const [action, heading] of [
    ['Plan tests', /Plan/],
    ['Order loads', 'Load order'],
    ['Browse the catalog', 'Catalog'],
  ]) {
    await page.getByRole('link', { name: action }).click();
    await page.getByRole('heading', { name: heading, level: 1 }).waitFor();
    await page.goBack();
    await settled(page);
  }
});

test('the glossary is a click away on every page', async (explorer) => {
  const page = await explorer.open('#/home');
  for (const path of ['home', 'catalog', 'verify', 'theorems']) {
    await page.goto(page.url().replace(/#.*/, `#/${path}`));
    await settled(page);
    await page.getByRole('button', { name: 'Glossary' }).click();
    const dialog = page.getByRole('dialog', { name: 'Glossary' });
    await dialog.locator('dfn').getByText('tight', { exact: true }).waitFor();
    await dialog.getByLabel('Find a term').fill('evict');
    assert.equal(await dialog.locator('dt').count(), 1);
    await dialog.getByLabel('Find a term').fill('');
    assert.deepEqual(await accessibility(page), []);
    await page.keyboard.press('Escape');
    await dialog.waitFor({ state: 'hidden' });
  }
});

test('"?" lists the keys of the page, and a button does', async (explorer) => {
  const page = await explorer.open('#/cell?v=20&k=5');
  await page.keyboard.press('Shift+?');
  const keys = page.getByRole('dialog', { name: 'Keys of this page' });
  await keys.getByText('one element less or more').waitFor();
  await accessibility(page, 'keys');
  await page.keyboard.press('Escape');
  await keys.waitFor({ state: 'detached' }).catch(() => keys.waitFor({ state: 'hidden' }));
  await page.goto(page.url().replace(/#.*/, '#/catalog'));
  await settled(page);
  // A field takes the sign as it is.
  await page.getByLabel('Look up a design').press('Shift+?');
  assert.equal(await page.getByLabel('Look up a design').inputValue(), '?');
  assert.ok(await keys.isHidden());
  await page.getByRole('button', { name: 'Keys of this page' }).click();
  await keys.getByText('to the next cell').waitFor();
});

test('permanent addresses lead to cells and designs', async (explorer) => {
  const page = await explorer.context.newPage();
  await page.goto(`${explorer.server.origin}/?cell=20.5.2.circular`);
  await page.getByRole('heading', { name: /20 elements in blocks of 5/ }).waitFor();
  await page.goto(`${explorer.server.origin}/?design=20.5.2.circular.29.17482f88`);
  await page.getByRole('heading', { name: /29 blocks/ }).waitFor();
});

test('with less motion nothing moves by itself', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await page.emulateMedia({ reducedMotion: 'reduce' });
  assert.equal(
    await page.evaluate(() => getComputedStyle(document.documentElement).scrollBehavior),
    'auto',
  );
  assert.equal(await page.evaluate(() => document.getAnimations().length), 0);
});

test('each term has an address', async (explorer) => {
  const page = await explorer.open('#/glossary?term=group');
  const chosen = page.locator('dt.chosen');
  assert.equal(await chosen.locator('dfn').textContent(), 'automorphism, group');
  assert.ok(await chosen.evaluate((it) => it.getBoundingClientRect().bottom < window.innerHeight));
  await page.getByRole('link', { name: 'Link to tight', exact: true }).click();
  await page.locator('dt.chosen', { hasText: 'tight' }).waitFor();
  assert.match(page.url(), /#\/glossary\?term=tight$/);
  await look(page, 'glossary');
  await page.goto(page.url().replace(/#.*/, '#/glossary?term=nothing'));
  await page.getByRole('alert').filter({ hasText: 'no term “nothing”' }).waitFor();
});
