// The site in a real browser, opened as files: nothing is asked of the network, nothing is missing,
// formulas are drawn, and both searches find things. CHANGEOVER_SITE is its folder. With
// CHANGEOVER_SCREENSHOTS, where pictures of it go, every page is opened, else one in six.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, readdirSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

const { launch } = await import(pathToFileURL(join(process.cwd(), 'tests/support/chromium.mjs')));
const site = process.env.CHANGEOVER_SITE;
const pictures = process.env.CHANGEOVER_SCREENSHOTS;
let context;
let quit;
let faults = [];

before(async () => {
  ({ context, quit } = await launch({ viewport: { width: 1280, height: 900 } }));
  context.setDefaultTimeout(120000); // On a loaded machine a page takes long.
  context.setDefaultNavigationTimeout(120000);
  context.on('request', (request) => {
    const url = request.url();
    if (!/^(file|data|blob|about|chrome):/.test(url)) {
      faults.push(`a request left the machine: ${url}`);
    } else if (url.startsWith('file:') && !existsSync(fileURLToPath(url.replace(/[?#].*$/, '')))) {
      faults.push(`a file is missing: ${url}`);
    }
  });
});
after(() => quit());

const address = (page) => pathToFileURL(join(site, page)).href;

/** Opens a page; what is wrong with it is in `faults`. */
async function open(page, hash = '') {
  const tab = await context.newPage();
  tab.on('pageerror', (error) => faults.push(`${page}: ${error.message}`));
  await tab.goto(address(page) + hash);
  return tab;
}

/** No page is wider than the screen, whatever stands on it scrolls by itself. */
async function fits(tab, page) {
  const wider = await tab.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(wider <= 1, `${page} is ${wider} pixels wider than the screen`);
}

test('pages of the guide open and ask for nothing elsewhere', async () => {
  const pages = readdirSync(site).filter((name) => name.endsWith('.html'));
  assert.ok(pages.length > 20);
  for (const page of pages.filter((_, i) => pictures || i % 6 === 0)) {
    const tab = await open(page);
    await tab.waitForLoadState('load');
    await fits(tab, page);
    await tab.close();
  }
  assert.deepEqual(faults.splice(0), []);
});

test('formulas are drawn', async () => {
  for (const [page, least] of [['theory.html', 30], ['theorems.html', 8]]) {
    const tab = await open(page);
    await tab.waitForFunction((n) => document.querySelectorAll('.math svg').length >= n, least);
    assert.equal(await tab.locator('.MathJax_Error, .merror').count(), 0);
    await tab.close();
  }
  assert.deepEqual(faults.splice(0), []);
});

test('the search of the guide finds pages', async () => {
  const tab = await open('index.html');
  await tab.locator('input[name=q]').first().fill('stays');
  await tab.keyboard.press('Enter');
  await tab.locator('#search-results li a', { hasText: 'Theorems' }).first().waitFor();
  await tab.locator('#search-results li a', { hasText: 'Theory in ten minutes' }).first().click();
  await tab.getByRole('heading', { name: 'Stays' }).waitFor();
  await tab.close();
  assert.deepEqual(faults.splice(0), []);
});

test('the search of the C++ reference finds names', async (t) => {
  if (!existsSync(join(site, 'cpp'))) {
    t.skip('built without it');
    return;
  }
  const tab = await open('cpp/index.html');
  await tab.locator('#MSearchField').click();
  await tab.keyboard.type('lower_bou', { delay: 30 });
  const results = tab.frameLocator('#MSearchResults').locator('.SRResult:visible a', { hasText: 'lower_bound' }).first();
  await results.waitFor();
  await tab.close();
  const header = await open('cpp/verdict_8hpp.html');
  await header.locator('.fragment').first().waitFor();
  await header.close();
  assert.deepEqual(faults.splice(0), []);
});

test('light, dark and on a phone', async () => {
  for (const [name, width, height, colorScheme] of [['light', 1280, 900, 'light'], ['dark', 1280, 900, 'dark'], ['phone', 390, 844, 'light']]) {
    for (const page of ['index', 'theory', 'python_reference', 'plan']) {
      const tab = await context.newPage();
      await tab.setViewportSize({ width, height });
      await tab.emulateMedia({ colorScheme });
      await tab.goto(address(`${page}.html`));
      await fits(tab, `${page} (${name})`);
      if (pictures) {
        mkdirSync(pictures, { recursive: true });
        const file = join(pictures, `site-${page}-${name}.png`);
        await tab.screenshot({ path: file });
        assert.ok(statSync(file).size > 1000);
      }
      const ground = await tab.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const [red] = /\d+/.exec(ground);
      assert.equal(Number(red) < 100, colorScheme === 'dark', `${page} is ${ground} where ${colorScheme} was asked for`);
      await tab.close();
    }
  }
  assert.deepEqual(faults.splice(0), []);
});
