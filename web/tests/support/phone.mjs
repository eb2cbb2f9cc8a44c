import assert from 'node:assert/strict';
import { look, settled } from './browser.mjs';

/** Whether all of an element is in the window. */
export const inSight = (locator) =>
  locator.evaluate((element) => {
    const { top, bottom } = element.getBoundingClientRect();
    return top >= 0 && bottom <= window.innerHeight;
  });

/**
 * The page as a phone shows it: nothing sticks out at the side, and no word of a table reaches into
 * the next cell.
 */
export async function phone(page, name) {
  await page.setViewportSize({ width: 390, height: 844 });
  await settled(page);
  await page.waitForLoadState('networkidle');
  const wide = await page.evaluate(
    () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
  );
  assert.equal(wide, 0, `${name} is ${wide} px wider than a phone`);
  const over = await page.evaluate(() =>
    [...document.querySelectorAll('#main :is(th, td)')]
      .filter(
        (cell) =>
          cell.checkVisibility() && cell.clientWidth > 1 && cell.scrollWidth > cell.clientWidth + 1,
      )
      .map((cell) => cell.textContent),
  );
  assert.deepEqual(over, [], `cells of ${name} that are too narrow`);
  await look(page, `${name}-phone`, { inLight: true });
}
