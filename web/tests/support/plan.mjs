// What the tests of the page Plan share.
import { settled } from './browser.mjs';

export const nameOf = (page, i) =>
  page.getByRole('textbox', { name: `Name of part ${i}`, exact: true });
export const sheetRows = (page) => page.locator('.run-sheet tbody tr');
/** The page itself searches for 60 s at most, and takes them where the machine has other work. */
export const planned = (page, most = 90_000) =>
  page.locator('.verdict h2').waitFor({ timeout: most });
export const sheetButton = (page, test, result) =>
  page.locator('.sheets').getByRole('button', { name: `Test ${test}: ${result}`, exact: true });
/** For a test that asks nothing of how good a plan is. */
export const briefly = (page) =>
  page.getByRole('combobox', { name: 'Time to search' }).selectOption('1');
/** The same for an example, which is planned at once and as long as it may be. */
export const hurried = (page) =>
  page.route('**/api/plan/start*', (route) =>
    route.continue({
      postData: JSON.stringify({ ...route.request().postDataJSON(), seconds: 1 }),
    }),
  );
export const press = (page, test, result = 'pass') => sheetButton(page, test, result).click();
export const give = (page, name, buffer) =>
  page
    .getByLabel('A file with a list of parts')
    .setInputFiles({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(buffer) });
/** What is in at each test, as the sheet says it; of a sheet with slots, slot by slot. */
export const setUps = (page) =>
  page.locator('.run-sheet tbody tr').evaluateAll((rows) =>
    rows.map((row) => {
      const copy = row.cloneNode(true);
      copy.querySelectorAll('.replaced, .place.leave').forEach((left) => left.remove());
      return [...copy.querySelectorAll('.set-up, .in-slot')]
        .map((cell) =>
          cell.matches('.in-slot') ? `${cell.dataset.label} ${cell.textContent}` : cell.textContent,
        )
        .join(' ')
        .trim();
    }),
  );
export const open = (page, group) => page.locator('.group summary', { hasText: group }).click();

/** A window that may look only: it does not have the token. */
export async function withoutToken(explorer, fragment) {
  const page = await explorer.context.newPage();
  await page.goto(`${explorer.server.origin}/${fragment}`);
  await settled(page);
  return page;
}

/** Nine parts, three at a time, one a test, five a change: the example of docs/plan.md. */
export async function planNine(page) {
  await page.getByRole('spinbutton', { name: 'How many parts' }).fill('9');
  await page.getByRole('button', { name: 'numbered parts' }).click();
  await page.getByRole('spinbutton', { name: 'How many fit at once' }).fill('3');
  await page.getByRole('textbox', { name: 'Cost of a test' }).fill('1');
  await page.getByRole('textbox', { name: 'Cost of a change' }).fill('5');
  await page.getByRole('button', { name: 'Plan', exact: true }).click();
  await planned(page);
}
