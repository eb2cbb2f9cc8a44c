// Takes the pictures of the explorer that the documents show: node screenshots.mjs FOLDER
// One viewport each, in light or dark, some as a phone shows them; the pages are those of the
// program (CHANGEOVER_PROGRAM).
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { smallPng } from './small_png.mjs';
import { settled, start } from './tests/support/browser.mjs';
import { planned } from './tests/support/plan.mjs';

const folder = process.argv[2];
if (!folder) {
  console.error('usage: node screenshots.mjs FOLDER');
  process.exit(2);
}
const onPhone = (page) => page.setViewportSize({ width: 390, height: 844 });
const pictures = [
  [
    'home',
    'light',
    '#/home',
    async (page) => {
      await page.locator('canvas.drawn').waitFor({ timeout: 60_000 });
    },
  ],
  ['catalog', 'light', '#/catalog?change=2&kind=circular'],
  ['catalog', 'dark', '#/catalog?change=1&kind=linear&k=3..16&v=8..40&at=26.6'],
  ['cell', 'light', '#/cell?v=40&k=6&change=2&kind=circular'],
  ['design', 'dark', '#/design?v=20&k=5&change=2&kind=circular&show=steps&at=12'],
  ['stays', 'light', '#/design?v=61&k=4&change=2&kind=circular&show=stays&sel=7'],
  ['circle', 'light', '#/design?v=61&k=4&change=2&kind=circular&show=circle'],
  [
    'verify',
    'light',
    '#/verify',
    async (page) => {
      await page.getByText('one with bad steps').click();
      await page.locator('.repair-lines').waitFor({ timeout: 60_000 });
      await page
        .locator('.verdict')
        .evaluate((verdict) => window.scrollTo(0, verdict.offsetTop - 20));
    },
  ],
  [
    'plan',
    'light',
    '#/plan',
    async (page) => {
      await page.setViewportSize({ width: 1280, height: 1500 });
      await page.getByRole('link', { name: 'a server with slots' }).click();
      await planned(page);
      for (const [test, result] of [
        [1, 'pass'],
        [2, 'pass'],
        [3, 'fail'],
      ]) {
        await page
          .locator('.sheets')
          .getByRole('button', { name: `Test ${test}: ${result}`, exact: true })
          .click();
      }
      await page.getByText('This run is kept on the server').waitFor();
      await page.evaluate(() =>
        window.scrollTo(0, document.querySelector('.job-box').offsetTop - 20),
      );
    },
  ],
  [
    'loadorder',
    'dark',
    '#/loadorder?items=64&room=16&workers=4',
    async (page) => {
      await page.setViewportSize({ width: 1280, height: 1400 });
      await page.locator('.timeline-canvas').waitFor({ timeout: 60_000 });
    },
  ],
  [
    'search',
    'light',
    '#/search?v=40&k=6&change=2&kind=circular',
    async (page) => {
      await page.getByRole('button', { name: 'Start' }).click();
      await page.waitForTimeout(8000);
    },
  ],
  ['theorems', 'light', '#/theorems'],
  ['catalog-phone', 'light', '#/catalog', onPhone],
  ['design-phone', 'dark', '#/design?v=20&k=5&change=2&kind=circular&show=steps&at=12', onPhone],
  [
    'plan-phone',
    'light',
    '#/plan',
    async (page) => {
      await onPhone(page);
      await page.getByRole('link', { name: 'a server with slots' }).click();
      await planned(page);
      await page.evaluate(() =>
        window.scrollTo(0, document.querySelector('.next-test').offsetTop - 20),
      );
    },
  ],
];
const explorer = await start({ viewport: { width: 1280, height: 860 } });
for (const [name, colorScheme, fragment, act] of pictures) {
  const page = await explorer.open(fragment);
  await page.emulateMedia({ colorScheme });
  await act?.(page);
  await settled(page);
  await page.waitForTimeout(1500);
  writeFileSync(
    join(folder, `explorer-${name}-${colorScheme}.png`),
    smallPng(await page.screenshot()),
  );
  await page.close();
}
await explorer.stop();
