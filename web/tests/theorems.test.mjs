// Theorems and constructions, with mathematics as such.
import assert from 'node:assert/strict';
import { look, settled } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
import { test } from './support/tests.mjs';

test('statements with subscripts, and no raw marks', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await page.locator('#theorem-5 math').first().waitFor();
  // Those in sight are set first, in pieces of some milliseconds, and then the hundreds below: the
  // page never stands still for long.
  const seen = await page.evaluate(() =>
    [...document.querySelectorAll('.math')]
      .filter((each) => each.getBoundingClientRect().top < innerHeight && each.checkVisibility())
      .map((each) => each.matches('.plain')),
  );
  assert.ok(seen.length > 5 && !seen.includes(true), 'what is in sight is set');
  await page.waitForFunction(
    () =>
      [...document.querySelectorAll('article .prose')].every(
        (prose) => prose.childElementCount > 0,
      ) && document.querySelectorAll('.math.plain').length === 0,
    null,
    { timeout: 60_000 },
  );
  const all = await page.locator('#main').textContent();
  assert.ok(!/\*\*|_\{/.test(all), /.{20}(\*\*|_\{).{20}/.exec(all)?.[0]);
  await page.locator('#theorem-5 math msub').first().waitFor();
  assert.ok((await page.locator('.statement').count()) > 40);
});

test('a link leads to a theorem or a construction', async (explorer) => {
  const page = await explorer.open('#/theorems?construction=cyclic');
  const chosen = page.locator('#construction-cyclic.chosen');
  await chosen.waitFor();
  assert.ok(await chosen.evaluate((it) => it.getBoundingClientRect().top < window.innerHeight));
  assert.equal(await chosen.getAttribute('open'), '');
  await chosen
    .getByRole('link', { name: /^Example/ })
    .locator('svg, canvas')
    .waitFor({ state: 'attached' });
  await chosen.getByRole('link', { name: /^Example/ }).click();
  await page.getByRole('tab', { name: 'Steps' }).waitFor();
  await page.close();
  const none = await explorer.open('#/theorems?theorem=99');
  await none.getByRole('alert').filter({ hasText: 'no Theorem 99' }).waitFor();
  await none.close();
});

test('contents stay, proofs unfold, works are listed', async (explorer) => {
  const page = await explorer.open('#/theorems');
  const contents = page.getByRole('navigation', { name: 'Contents' });
  await contents.getByRole('link', { name: /^7 / }).click();
  assert.equal(new URLSearchParams(page.url().split('?').at(-1)).get('theorem'), '7');
  assert.ok(await contents.getByRole('link', { name: /^1 / }).isVisible());
  await contents.locator('a[aria-current]', { hasText: /^7 / }).waitFor();
  const proof = page.locator('#theorem-2 details.proof');
  await proof.getByText('Proof', { exact: true }).click();
  await proof.locator('p').first().waitFor();
  assert.ok((await proof.textContent()).length > 200);
  await contents.getByRole('link', { name: 'References' }).click();
  await page.locator('.references a[href^="https://arxiv.org"]').first().waitFor();
  await page.close();
  const work = await explorer.open('#/theorems?reference=McSorley1999');
  await work.locator('#reference-McSorley1999.chosen').waitFor();
  await work.close();
});

test('a way through the contents ends where the part begins, and it stays there', async (explorer) => {
  const page = await explorer.open('#/theorems');
  const contents = page.getByRole('navigation', { name: 'Contents' });
  const top = (number) =>
    page.locator(`#theorem-${number}`).evaluate((it) => it.getBoundingClientRect().top);
  for (const number of [12, 29]) {
    await contents.getByRole('link', { name: new RegExp(`^${number} `) }).click();
    // What is above is laid out after the jump, and pictures come.
    await page.waitForLoadState('networkidle');
    await page.waitForTimeout(800);
    assert.ok(Math.abs(await top(number)) < 20, `Theorem ${number} is at ${await top(number)}`);
  }
  await page.reload();
  await settled(page);
  await page.waitForLoadState('networkidle');
  await page.waitForTimeout(800);
  assert.ok(Math.abs(await top(29)) < 20, `from its address Theorem 29 is at ${await top(29)}`);
  // The reader goes on from there.
  await page.mouse.move(640, 400);
  await page.mouse.wheel(0, 500);
  await page.waitForFunction(
    () => document.querySelector('#theorem-29').getBoundingClientRect().top < -300,
  );
});

test('statements come first, and proofs are folded', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await page.waitForFunction(() =>
    [...document.querySelectorAll('article .prose')].every((prose) => prose.childElementCount > 0),
  );
  const unfolded = await page
    .locator('article.statement:not(:has(details.proof))')
    .evaluateAll((all) => all.map((each) => each.id));
  assert.deepEqual(unfolded, []);
  // The items of Theorem 23 are conditions with a proof each.
  await page.locator('#theorem-23').getByText('The conditions and their proofs').waitFor();
});

test('theorems are found by words, in the contents, too; terms say what they mean', async (explorer) => {
  const page = await explorer.open('#/theorems');
  const contents = page.getByRole('navigation', { name: 'Contents' });
  await contents.getByText('Run sheets and loads').waitFor();
  await page.getByLabel('Find').fill('benches');
  await page.locator('#theorem-26').waitFor();
  assert.ok(await page.locator('#theorem-1').isHidden());
  assert.ok(await contents.getByText('Double change').isHidden());
  const several = contents.getByRole('link', { name: 'What one of several benches must mount' });
  assert.ok(await several.isVisible());
  // What is hidden is not what is read.
  await contents.locator('[aria-current]:visible', { hasText: 'benches' }).waitFor();
  await page.getByLabel('Find').fill('');
  const term = page.locator('#theorem-1 a.term').first();
  await term.focus();
  await page.getByRole('tooltip').getByText('every pair is newly covered exactly once').waitFor();
  await page.keyboard.press('Enter');
  // The glossary opens over the page, at that term.
  const glossary = page.getByRole('dialog', { name: 'Glossary' });
  await glossary.locator('dt.chosen', { hasText: 'tight' }).waitFor();
  await page.getByRole('tooltip').waitFor({ state: 'detached' });
  assert.match(await term.getAttribute('href'), /#\/glossary\?term=tight/);
  await page.keyboard.press('Escape');
  await glossary.waitFor({ state: 'hidden' });
  // A finger's first tap shows the meaning and the second leads there; no tap is one that scrolls.
  const touched = { pointerType: 'touch', bubbles: true };
  for (const scrolls of [false, true]) {
    await page.locator('h1').click();
    await term.dispatchEvent('pointerdown', touched);
    await page.getByRole('tooltip').waitFor();
    await term.dispatchEvent(scrolls ? 'pointercancel' : 'click', {
      bubbles: true,
      cancelable: true,
    });
    await settled(page);
    assert.ok(await glossary.isHidden());
    await term.dispatchEvent('click', { bubbles: true, cancelable: true });
    await glossary.waitFor();
    await page.keyboard.press('Escape');
    await glossary.waitFor({ state: 'hidden' });
  }
});

test('constructions are found by words', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await page.getByLabel('Find').fill('single-change cyclic');
  const shown = await page.locator('details[id^=construction-]:visible').count();
  assert.ok(shown > 0 && shown < 20);
  await page.reload();
  await settled(page);
  assert.equal(await page.locator('details[id^=construction-]:visible').count(), shown);
  await page.getByLabel('Find').fill('no such words');
  await page.getByText('Nothing here says that').waitFor();
});

test('names in the pictures of examples can be read', async (explorer) => {
  const page = await explorer.open('#/theorems');
  const names = page.locator('.small-picture svg text');
  await names.first().waitFor();
  const heights = await names.evaluateAll((all) =>
    all.map((text) => Number(text.getAttribute('font-size')) * text.getScreenCTM().a),
  );
  assert.ok(Math.min(...heights) >= 8, `names of ${Math.min(...heights)} px`);
});

test('on a phone formulas break, and what cannot scrolls in its frame', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.locator('.displayed math').first().waitFor();
  await page.waitForFunction(() => !document.querySelector('.displayed .plain'), null, {
    timeout: 60_000,
  });
  const found = await page.evaluate(() => {
    document.querySelectorAll('details').forEach((each) => (each.open = true));
    document
      .querySelectorAll('article.statement')
      .forEach((each) => (each.style.contentVisibility = 'visible'));
    const frames = [...document.querySelectorAll('.formula')];
    const right = (element) => element.getBoundingClientRect().right;
    return {
      wider: document.documentElement.scrollWidth - innerWidth,
      frames: frames.length,
      wide: frames.filter((frame) => frame.scrollWidth > frame.clientWidth).length,
      outside: frames.filter((frame) => right(frame) > innerWidth).length,
      // A part that fits into the frame is in sight.
      cut: frames.flatMap((frame) =>
        [...frame.querySelectorAll('.math')]
          .filter((part) => part.offsetWidth <= frame.clientWidth - 24)
          .filter((part) => right(part) > right(frame) + 1)
          .map((part) => part.textContent),
      ),
    };
  });
  assert.equal(found.wider, 0, 'the page scrolls sideways');
  assert.ok(found.frames > 10);
  assert.ok(found.wide < found.frames / 4, `${found.wide} of ${found.frames} formulas scroll`);
  assert.equal(found.outside, 0);
  assert.deepEqual(found.cut, []);
});

test('on a phone a line says which part is read, and leads to the others', async (explorer) => {
  const page = await explorer.open('#/theorems?theorem=5');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.reload();
  await settled(page);
  const here = page.locator('.contents-here');
  await here.filter({ hasText: /^5 / }).waitFor();
  await page.locator('.contents summary').click();
  await page.locator('.contents a', { hasText: /^27 / }).click();
  await here.filter({ hasText: /^27 / }).waitFor();
  assert.equal(await page.locator('.contents details').getAttribute('open'), null);
  const [line, part] = await Promise.all([
    page.locator('.contents').boundingBox(),
    page.locator('#theorem-27 h3').boundingBox(),
  ]);
  assert.ok(part.y >= line.y + line.height, 'the heading is below the line');
  // A table of few columns with much in them: a row below the other, each with its name.
  await page.locator('#theorem-12 .proof summary').click();
  const tables = page.locator('#theorem-12 .long');
  await tables.first().waitFor();
  const wide = await tables.evaluateAll(
    (all) => all.filter((table) => table.scrollWidth > table.parentElement.clientWidth).length,
  );
  assert.equal(wide, 0);
  assert.equal(
    await tables
      .first()
      .locator('td')
      .first()
      .evaluate((cell) => getComputedStyle(cell, '::before').content),
    '"window "',
  );
});

test('it looks right', async (explorer) => {
  const page = await explorer.open('#/theorems');
  await look(page, 'theorems');
  await phone(page, 'theorems');
});

test('formulas in sight are set before all others', async (explorer) => {
  const page = await explorer.open('#/home');
  await page.setViewportSize({ width: 390, height: 844 });
  await page.evaluate(() => {
    window.order = [];
    new MutationObserver((changes) => {
      for (const { target } of changes) {
        if (target.matches('.math:not(.plain)')) {
          const { top, bottom } = target.getBoundingClientRect();
          window.order.push(
            target.checkVisibility({ contentVisibilityAuto: true }) &&
              bottom >= 0 &&
              top <= innerHeight,
          );
        }
      }
    }).observe(document, { attributes: true, attributeFilter: ['class'], subtree: true });
  });
  await page.evaluate(() => (window.location.hash = '#/theorems'));
  await page.waitForFunction(
    () => window.order.length > 100 && !document.querySelector('.math.plain'),
  );
  const order = await page.evaluate(() => window.order);
  const seen = order.filter(Boolean).length;
  assert.ok(seen > 5 && order.length > 5 * seen, `${seen} of ${order.length} in sight`);
  assert.ok(order.slice(0, seen).every(Boolean), 'those in sight came first');
});

test('works across lines are named, constructions linked, and examples are of the theorem', async (explorer) => {
  const page = await explorer.open('#/theorems?theorem=3');
  await page.locator('#theorem-3 .example', { hasText: 'DCCD' }).waitFor();
  await page.locator('#theorem-2 details.proof summary').click();
  await page
    .locator('#theorem-2')
    .getByRole('link', { name: 'Chafee and Stevens 2025, Theorem 3' })
    .waitFor();
  const construction = page
    .locator('#theorem-16')
    .getByRole('link', { name: 'cyclic-with-groups' });
  assert.equal(
    await construction.getAttribute('href'),
    '#/theorems?construction=cyclic-with-groups',
  );
  for (const number of [18, 23, 25, 26]) {
    const statement = await page
      .locator(`#theorem-${number} .prose > :not(details)`)
      .allInnerTexts();
    assert.ok(!/P_a|_of_|cost_bound|at_once|\.hpp/.test(statement.join(' ')), `Theorem ${number}`);
  }
});
