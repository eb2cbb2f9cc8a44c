import assert from 'node:assert/strict';
import { look, settled } from './browser.mjs';

/** The page as a phone shows it: nothing sticks out at the side. */
export async function phone(page, name) {
  await page.setViewportSize({ width: 390, height: 844 });
  await settled(page);
  await page.waitForLoadState('networkidle');
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(wide, 0, `${name} is ${wide} px wider than a phone`);
  await look(page, `${name}-phone`);
}
