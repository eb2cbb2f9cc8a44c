// What all pages share: navigation, theme, links, the token.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { settled, start } from './support/browser.mjs';

let explorer;
before(async () => {
  explorer = await start();
});
after(() => explorer.stop());

test('the token leaves the address and survives a reload', async () => {
  const page = await explorer.open('#/theorems');
  assert.ok(!page.url().includes('token'));
  await page.reload();
  await settled(page);
  assert.ok(await page.evaluate(() => sessionStorage.getItem('changeover-token')));
});

test('every page of the navigation is reached by keyboard alone', async () => {
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

test('an address without a page says so and leads home', async () => {
  const page = await explorer.open('#/nowhere');
  await page.getByRole('link', { name: 'Go to the catalog' }).click();
  await page.locator('nav a[aria-current=page]', { hasText: 'Catalog' }).waitFor();
});

test('light and dark are a choice that lasts', async () => {
  const page = await explorer.open('#/theorems');
  await page.getByRole('button', { name: /light and dark/ }).click();
  assert.equal(await page.locator('html').getAttribute('data-theme'), 'dark');
  await page.reload();
  await settled(page);
  assert.equal(await page.locator('html').getAttribute('data-theme'), 'dark');
});
