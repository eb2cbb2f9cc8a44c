// The same pages as files, behind any file server, in a folder of it.
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import { createReadStream, mkdtempSync, readFileSync, rmSync, statSync } from 'node:fs';
import { createServer } from 'node:http';
import { tmpdir } from 'node:os';
import { extname, join } from 'node:path';
import { gunzipSync } from 'node:zlib';
import { look, program, settled } from './support/browser.mjs';
import { phone } from './support/phone.mjs';
import { load } from './support/source.mjs';
import { served, test } from './support/tests.mjs';

const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
  '.gz': 'application/gzip',
};
const folder = mkdtempSync(join(tmpdir(), 'changeover-export-'));
const asked = [];

served(async () => {
  const assets = process.env.CHANGEOVER_ASSETS ? ['--assets', process.env.CHANGEOVER_ASSETS] : [];
  execFileSync(
    program,
    [
      'serve',
      '--export',
      join(folder, 'site'),
      '--k',
      '4..5',
      '--v',
      '6..20',
      '--change',
      '2',
      '--sources',
      'https://example.org/changeover',
      ...assets,
    ],
    { stdio: 'pipe', env: { ...process.env, CHANGEOVER_CATALOG: '' } },
  );
  const files = createServer((request, response) => {
    const path = new URL(request.url, 'http://localhost').pathname;
    asked.push(path);
    const name = /^\/some\/where(\/.*)$/.exec(path)?.[1].replace(/\/$/, '/index.html');
    const file = name && !name.includes('..') ? join(folder, 'site', name) : null;
    if (!file || !statSync(file, { throwIfNoEntry: false })?.isFile()) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'Content-Type': types[extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(response);
  });
  await new Promise((resolve) => files.listen(0, '127.0.0.1', resolve));
  const origin = `http://127.0.0.1:${files.address().port}`;
  return {
    address: `${origin}/some/where/`,
    origin,
    async stop() {
      files.close();
      files.closeAllConnections();
      rmSync(folder, { recursive: true, force: true });
      return 0;
    },
  };
});

test('catalog, cell, design, theorems', async (explorer) => {
  const page = await explorer.open('#/catalog');
  assert.ok((await page.locator('table.cells tbody tr').count()) > 10);
  await look(page, 'export-catalog');
  await page.locator('table.cells a', { hasText: /^20$/ }).first().click();
  await page.locator('.known').waitFor();
  await page.locator('.recipe-node').first().waitFor();
  await page.getByRole('button', { name: /^Cite/ }).first().click();
  await page.locator('.bibtex pre', { hasText: '@misc{' }).waitFor();
  await page.getByRole('link', { name: 'Open the design' }).click();
  await page.locator('.block-text', { hasText: 'Block 1 of' }).waitFor();
  await page.keyboard.press('End');
  await page.locator('.met', { hasText: '(100 %)' }).waitFor();
  // Pictures are drawn by the page.
  await page.getByRole('tab', { name: 'Array' }).click();
  await page.locator('.array-table td.fresh').first().waitFor();
  await page.getByRole('tab', { name: 'Stays' }).click();
  await page.locator('.timeline-canvas').waitFor();
  await page.getByRole('tab', { name: 'Coverage' }).click();
  await page.locator('.matrix-canvas').waitFor();
  const waiting = page.waitForEvent('download');
  await page.getByRole('link', { name: 'Text', exact: true }).click();
  assert.match((await waiting).suggestedFilename(), /^20\.\d\.2\..*\.txt$/);
  await page.goto(page.url().replace(/#.*/, '#/theorems'));
  await page.locator('#theorem-1').waitFor();
});

test('a best design that a construction makes is there, too', async (explorer) => {
  const page = await explorer.open('#/cell?v=14&k=5&kind=circular');
  await page.locator('.known').waitFor();
  assert.equal(await page.locator('.known .code').count(), 0, 'it has no label');
  await page.getByRole('link', { name: 'Open the design' }).click();
  await page.locator('.block-text', { hasText: 'Block 1 of' }).waitFor();
  await page.keyboard.press('End');
  await page.locator('.met', { hasText: '(100 %)' }).waitFor();
});

test('the window of the map, groups and permanent addresses', async (explorer) => {
  const page = await explorer.open('#/catalog?k=4&v=6..10&group=1');
  await page.locator('.filter-says', { hasText: 'with a group of order > 1' }).waitFor();
  assert.ok((await page.locator('table.cells tbody tr').count()) > 0);
  await page.goto(`${page.url().replace(/[?#].*/, '')}?cell=20.5.2.linear`);
  await page.getByRole('heading', { name: /^Linear.*20 elements in blocks of 5/ }).waitFor();
});

test('cells of files are those of the program', async (explorer) => {
  const page = await explorer.open('#/cell?v=20&k=5');
  await page.locator('.known').waitFor();
  const data = (name) => JSON.parse(gunzipSync(readFileSync(join(folder, 'site/data', name))));
  const ask = (...words) =>
    spawnSync(program, words, {
      encoding: 'utf8',
      env: { ...process.env, CHANGEOVER_CATALOG: '' },
    }).stdout; // "[]", with exit code 4, if there is no design
  const forms = data('citations.json.gz');
  let designs = 0;
  for (const kind of ['circular', 'linear']) {
    for (const [v, cell] of Object.entries(data(`cell/2.${kind}.5.json.gz`))) {
      const known = JSON.parse(ask('catalog', 'show', v, '5', `--${kind}`, '--json'));
      assert.equal(cell.designs.length, known.length);
      known.forEach((design, i) => {
        const beside = { v: cell.v, k: cell.k, change: cell.change, kind: cell.kind };
        const { reason, lower_bound } = cell;
        assert.deepEqual({ ...beside, reason, lower_bound, ...cell.designs[i] }, design);
        const filled = forms[cell.cite[i]].replace(/<(\w+)>/g, (_, word) => design[word]);
        assert.equal(filled, ask('catalog', 'cite', design.label));
        ++designs;
      });
      if (cell.best) {
        const made = JSON.parse(ask('explain', v, '5', `--${kind}`, '--json'));
        assert.deepEqual({ recipe: cell.best.recipe, tree: cell.tree }, made);
      }
    }
  }
  assert.ok(designs > 20, `${designs} designs`);
  // And so the page has them.
  await page.getByRole('button', { name: /^Cite/ }).first().click();
  const shown = page.locator('.bibtex pre').first();
  await shown.waitFor();
  const label = /catalog label ([\w.]+)/.exec(await shown.textContent())[1];
  assert.equal((await shown.textContent()).trim(), ask('catalog', 'cite', label).trim());
});

test('every design is the one whose label it has', async (explorer) => {
  const page = await explorer.open('#/design?v=20&k=5');
  const label = await page.locator('.under .code').textContent();
  const text = await page.evaluate(async () => {
    document.querySelector('[role=tab][id=tab-blocks]').click();
    return document.querySelector('pre.blocks').textContent;
  });
  const { createHash } = await import('node:crypto');
  const blocks = text
    .split('\n')
    .filter((line) => line && !line.startsWith('#'))
    .map((line) => `${line}\n`)
    .join('');
  assert.equal(
    createHash('sha256').update(blocks).digest('hex').slice(0, 8),
    label.split('.').at(-1),
  );
});

test('no link leads to what the copy does not have', async (explorer) => {
  // The copy has k 4 and 5, v 6 to 20 and change number 2.
  const held = (href) => {
    const params = new URLSearchParams(href.split('?')[1]);
    const [v, k, change] = (params.get('label') ?? '').split('.').map(Number);
    const cell = params.has('label')
      ? { v, k, change }
      : {
          v: Number(params.get('v')),
          k: Number(params.get('k')),
          change: Number(params.get('change') ?? 2),
        };
    return cell.change === 2 && cell.v >= 6 && cell.v <= 20 && (cell.k === 4 || cell.k === 5);
  };
  const page = await explorer.open('#/cell?v=20&k=5');
  for (const [at, some] of [
    ['#/cell?v=20&k=5', '.neighbours a'],
    ['#/cell?v=19&k=4&kind=linear', '.recipe-node'],
    ['#/theorems', '.statement'],
    ['#/home', '.door'],
  ]) {
    await page.goto(page.url().replace(/#.*/, at));
    await page.locator(some).first().waitFor();
    await settled(page);
    await page.waitForLoadState('networkidle');
    const links = await page
      .locator('main :is(a[href^="#/cell?"], a[href^="#/design?"])')
      .evaluateAll((anchors) => anchors.map((anchor) => anchor.getAttribute('href')));
    assert.deepEqual(
      links.filter((href) => !held(href)),
      [],
      at,
    );
  }
  await page.goto(page.url().replace(/#.*/, '#/cell?v=20&k=5'));
  const ways = await page.locator('.neighbours li').allTextContents();
  assert.deepEqual(ways, ['← v = 19', '↑ k = 4', 'linear', 'on the map']);
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowLeft');
  await page.getByRole('heading', { name: /on 19 elements in blocks of 5/ }).waitFor();
  await page.goto(page.url().replace(/#.*/, '#/catalog'));
  await page.locator('table.cells a').first().waitFor();
  assert.equal(await page.getByLabel('Change number').locator('option').count(), 1);
});

test('what the copy does not have is said', async (explorer) => {
  const page = await explorer.open('#/cell?v=50&k=5');
  const note = page.locator('.note', { hasText: 'static copy does not have it: it has designs' });
  await note.filter({ hasText: /k\s=\s\d+ to \d+ and v\s=\s\d+ to \d+/ }).waitFor();
  await note.getByRole('link', { name: 'on the map' }).click();
  await page.getByRole('heading', { name: 'Catalog', level: 1 }).waitFor();
  // The map is no higher than its few rows need.
  const { height } = await page.locator('.atlas').boundingBox();
  assert.ok(height < 330, `${height} px`);
  await page.close();
  const none = await explorer.open('#/design?label=99.5.2.circular.1.00000000', {
    mayFail: /status of 404/,
  });
  await none.getByRole('alert').filter({ hasText: 'static copy does not have it' }).waitFor();
  await none.close();
});

test('lists are verified by the page itself, as by the program', async (explorer) => {
  const page = await explorer.open('#/verify?example=good');
  await page.getByRole('heading', { name: '✓ Valid' }).waitFor();
  await page.locator('.verify-citation', { hasText: 'best known design' }).waitFor();
  await look(page, 'export-verify');
  await page.goto(page.url().replace(/#.*/, '#/verify?example=pairs'));
  await page.getByRole('heading', { name: '✗ Not a design' }).waitFor();
  await page.locator('.to-copy', { hasText: 'changeover search --repair FILE' }).waitFor();
  await page.goto(page.url().replace(/#.*/, '#/verify?example=typing'));
  await page.getByRole('alert').filter({ hasText: 'block 4 has 4 twice' }).waitFor();

  const { verifyAlone } = await load('pages/verify/alone.ts');
  const whole = spawnSync(program, ['design', '20', '5', '--format', 'json'], {
    encoding: 'utf8',
  }).stdout;
  const plain = '1 3 7 8\n2 5 7 8\n0 2 3 8\n2 3 4 5\n1 2 3 6\n0 1 5 6\n0 1 4 7\n4 6 7 8\n';
  const ring = 'a b c\nb c d\nc d e\nd e a\ne a b\n';
  let compared = 0;
  for (const [text, asked] of [
    [whole, {}],
    [whole, { kind: 'linear' }],
    [plain, {}],
    [plain, { kind: 'circular' }],
    [plain, { v: '10' }],
    [plain.replace('0 1 5 6\n0 1 4 7', '0 1 4 7\n0 1 5 6'), {}],
    [plain.replaceAll('4', '40').replace('1 2 3 6', '1 2 3 x'), {}],
    [ring, {}],
    [ring, { kind: 'circular' }],
    [ring, { change: '2', v: '6' }],
    ['0 1 2 9\n0 1 3 9\n0 2 3 9\n0 4 1 9\n', { kind: 'circular' }],
    [`# changeover design v=5 change=1 kind=circular\n# labels: e d c b a\n${ring}`, {}],
    ['one two three\n', {}],
  ]) {
    const alone = verifyAlone(text, { v: '', change: '', kind: '', ...asked });
    const options = Object.entries(asked).flatMap(([name, value]) =>
      name === 'kind' ? [`--${value}`] : [name === 'v' ? '-v' : `--${name}`, value],
    );
    const { stdout, stderr } = spawnSync(program, ['verify', '-', '--json', ...options], {
      input: text,
      encoding: 'utf8',
    });
    const said = JSON.parse(stdout || stderr);
    // A page knows fewer bounds.
    assert.ok(alone.verdict.lower_bound <= said.verdict.lower_bound, text);
    const { lower_bound, minimum } = said.verdict;
    assert.deepEqual({ ...alone.verdict, lower_bound, minimum }, said.verdict, text);
    assert.deepEqual(alone.details, said.details, `${text}${options}`);
    assert.deepEqual(alone.names_among_numbers, said.names_among_numbers, text);
    ++compared;
  }
  assert.equal(compared, 13);
});

test('pages that need the program say how to get it', async (explorer) => {
  const page = await explorer.open();
  for (const name of ['Plan', 'Load order', 'Search']) {
    await page.locator('nav a', { hasText: name }).click();
    await page.getByRole('heading', { name, level: 1 }).waitFor();
    await settled(page);
    await page.locator('.note', { hasText: 'changeover serve' }).waitFor();
    assert.match(await page.locator('.to-copy code').textContent(), /^changeover (\w+) /);
    assert.equal(await page.locator('.note a').getAttribute('href'), '#/get');
  }
  await phone(page, 'export-search');
  // The question of the address is that of the command.
  await page.goto(page.url().replace(/#.*/, '#/search?v=30&k=6&kind=linear&change=1'));
  await page
    .locator('.to-copy', { hasText: 'changeover search 30 6 --linear --change 1 --time 1m' })
    .waitFor();
  await page.locator('.note a').click();
  await page.getByRole('heading', { name: 'Get the program', level: 1 }).waitFor();
  await page.locator('main a[href="https://example.org/changeover"]').waitFor();
  await look(page, 'export-get');
  // Every command that is shown is one that the program takes.
  for (const line of await page.locator('.asked .to-copy code').allTextContents()) {
    const [name, ...words] = line.split(' ');
    assert.equal(name, 'changeover');
    const asked = spawnSync(program, [...words.slice(0, 1), '--help'], { encoding: 'utf8' });
    assert.equal(asked.status, 0, line);
    for (const option of words.slice(1).filter((word) => word.startsWith('-'))) {
      assert.ok(asked.stdout.includes(option), `${line}: ${option}`);
    }
  }
});

test('nothing but files was asked for', () => {
  assert.deepEqual(
    asked.filter((path) => !path.startsWith('/some/where/') || path.includes('/api/')),
    [],
  );
});

test('what a copy lacks is said, and not asked for', async (explorer) => {
  const page = await explorer.open('#/cell?v=20&k=5&change=1&kind=circular');
  await page.getByText(/it has designs with m\s=\s2, .* and none with m\s=\s1/).waitFor();
  assert.ok(!asked.some((path) => /cells.*20\.5\.1/.test(path)), 'no file is asked for');
});
