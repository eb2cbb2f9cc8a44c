// A real browser against the real program. What a test of support/tests.mjs is given:
//
//     const page = await explorer.open('#/catalog'); // fails the test on errors and on
// requests that leave the machine
//     await look(page, 'catalog');                   // what axe-core finds in light and dark
//
// CHANGEOVER_PROGRAM names the program (default: the one in build/release), CHANGEOVER_ASSETS a
// folder of pages to serve in place of those in the program. With CHANGEOVER_SCREENSHOTS, a
// folder, `look` is thorough: it puts pictures there, and axe-core sees every row, and a phone in
// dark, too.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { launch } from './chromium.mjs';

const root = join(dirname(fileURLToPath(import.meta.url)), '..', '..', '..');
export const program = process.env.CHANGEOVER_PROGRAM ?? join(root, 'build/release/changeover');
export const screenshots = process.env.CHANGEOVER_SCREENSHOTS;
const axeSource = readFileSync(
  createRequire(import.meta.url).resolve('axe-core/axe.min.js'),
  'utf8',
);

/** Starts `changeover serve` with more arguments; resolves when it has printed its address. */
export async function serve(arguments_ = []) {
  const home = mkdtempSync(join(tmpdir(), 'changeover-browser-'));
  const assets = process.env.CHANGEOVER_ASSETS ? ['--assets', process.env.CHANGEOVER_ASSETS] : [];
  const child = spawn(program, ['serve', '--port', '0', ...assets, ...arguments_], {
    env: { ...process.env, XDG_DATA_HOME: home, CHANGEOVER_CATALOG: join(home, 'catalog.db') },
    stdio: ['ignore', 'pipe', 'pipe'],
  });
  let said = '';
  let complaints = '';
  child.stderr.on('data', (data) => (complaints += data));
  const address = await new Promise((resolve, reject) => {
    child.stdout.on('data', (data) => {
      said += data;
      const found = /http:\/\/\S+/.exec(said);
      if (found) {
        resolve(found[0]);
      }
    });
    child.once('error', reject);
    child.once('exit', (code) =>
      reject(new Error(`changeover serve ended with exit code ${code}: ${complaints}`)),
    );
  });
  return {
    address,
    origin: new URL(address).origin,
    async stop() {
      const ended = new Promise((resolve) => child.once('exit', resolve));
      child.kill('SIGTERM');
      const code = child.exitCode ?? (await ended);
      rmSync(home, { recursive: true, force: true });
      return code;
    },
  };
}

/**
 * A server and a browser, for programs of their own. Options: `serve` (arguments), `viewport`,
 * `colorScheme`.
 */
export async function start(options = {}) {
  const server = await serve(options.serve);
  const { context, quit } = await launch(shapeOf(options));
  const seen = watch(context, server);
  return {
    server,
    context,
    open: seen.open,
    async stop() {
      await quit();
      const code = await server.stop();
      assert.deepEqual(seen.faults, []);
      assert.equal(code, 0, 'serve ends with exit code 0 when it is asked to stop');
    },
  };
}

const shapeOf = ({ viewport = { width: 1280, height: 900 }, colorScheme = 'light' }) => ({
  viewport,
  colorScheme,
});

/**
 * What a test has: `server`, and a `context` for its windows. `end()` is at fault if something was,
 * and leaves the context empty.
 */
export async function explore(context, server) {
  const seen = watch(context, server);
  const others = [];
  return {
    server,
    context,
    open: seen.open,
    /** The same with a server of its own, started with these arguments. */
    async another(options = {}) {
      const other = await explore(await newContext(context.browser()), await serve(options.serve));
      others.push(other);
      return other;
    },
    async end() {
      for (const other of others) {
        await other.context.close();
        const code = await other.server.stop();
        assert.equal(code, 0, 'serve ends with exit code 0 when it is asked to stop');
        assert.deepEqual(other.faults, []);
      }
      seen.end();
      await emptied(context, server);
      assert.deepEqual(seen.faults, []);
    },
    faults: seen.faults,
  };
}

/** A context of that browser, whose storage, cookies and windows no other one sees. */
export const newContext = (browser) => browser.newContext(shapeOf({}));

/**
 * As new, but for what it has read from servers and compiled: that takes half of the time. One page
 * stays, which is empty.
 */
async function emptied(context, server) {
  const [first = await context.newPage(), ...others] = context.pages();
  await Promise.all(others.map((page) => page.close()));
  if (first.url() !== 'about:blank') {
    await first.evaluate(() => sessionStorage.clear());
    await first.goto('about:blank');
  }
  const protocol = await context.newCDPSession(first);
  await protocol.send('Storage.clearDataForOrigin', {
    origin: server.origin,
    storageTypes: 'cookies,file_systems,indexeddb,local_storage,cache_storage,service_workers',
  });
  await protocol.detach();
  await context.unrouteAll();
  await first.unrouteAll();
  first.removeAllListeners();
  const { viewport, colorScheme } = shapeOf({});
  await first.setViewportSize(viewport);
  await first.emulateMedia({ media: null, colorScheme, reducedMotion: null });
}

/** Windows of a context that may ask that server only; what is wrong with them is in `faults`. */
function watch(context, server) {
  const faults = [];
  let [free] = context.pages();
  const asked = (request) => {
    const url = request.url();
    if (!url.startsWith(server.origin) && !/^(data|blob):/.test(url)) {
      faults.push(`a request left the machine: ${url}`);
    }
  };
  context.on('request', asked);
  return {
    faults,
    end: () => context.off('request', asked),
    /**
     * A page at that fragment, drawn to its end. Errors of its scripts are faults unless `mayFail`
     * matches them.
     */
    async open(fragment = '', { mayFail } = {}) {
      const page = free ?? (await context.newPage());
      free = undefined;
      const note = (text) => {
        if (!mayFail?.test(text)) {
          faults.push(text);
        }
      };
      page.on('pageerror', (error) => note(`error on the page: ${error.message}`));
      page.on(
        'console',
        (message) =>
          message.type() === 'error' &&
          note(`console: ${message.text()} (${message.location().url})`),
      );
      await page.goto(server.address + fragment);
      await settled(page);
      return page;
    },
  };
}

/** Waits until the page has drawn what it is drawing. */
export async function settled(page) {
  await page.locator('#main:not([aria-busy]) h1').first().waitFor();
}

// Signs of a formula bear the colours of the sentence around it, which is what axe-core looks at;
// that they do is told far faster here.
const coloursOfFormulas = () => {
  const wrong = new Set();
  for (const formula of document.querySelectorAll('math')) {
    const { color } = getComputedStyle(formula.parentElement);
    for (const sign of [formula, ...formula.querySelectorAll('*')]) {
      const style = getComputedStyle(sign);
      if (
        style.color !== color ||
        style.backgroundColor !== 'rgba(0, 0, 0, 0)' ||
        style.opacity !== '1'
      ) {
        wrong.add(`a sign of a formula has colours of its own: ${formula.textContent}`);
      }
    }
  }
  return [...wrong];
};

// Rows and statements that are like those before them: axe-core takes as long for each. Their
// places are kept.
const putRowsAside = (most) => {
  const lists = 'tbody, ol, ul, select, svg, svg g, :has(> .statement)';
  globalThis.aside = [...document.querySelectorAll(lists)].flatMap((list) =>
    [...list.children].slice(most, -1).map((row) => {
      const place = document.createComment('');
      row.replaceWith(place);
      return [row, place];
    }),
  );
};
const putRowsBack = () => globalThis.aside.forEach(([row, place]) => place.replaceWith(row));

/**
 * What axe-core finds wrong, a line each. The page's policy forbids foreign scripts, so it is run
 * from outside of it.
 * `onlyColours`: the page has been looked at in its other colours, and only those can be wrong now.
 * `rows`: so many rows of each table and list, and statements, are looked at, and the last one.
 */
export async function accessibility(page, { onlyColours = false, rows = Infinity } = {}) {
  if (!(await page.evaluate(() => 'axe' in globalThis))) {
    await page.evaluate(axeSource);
  }
  await page.evaluate(putRowsAside, rows);
  const found = await faultsByAxe(page, onlyColours);
  await page.evaluate(putRowsBack);
  return found;
}

async function faultsByAxe(page, onlyColours) {
  const colours = await page.evaluate(async () => {
    // Formulas are most of what some pages have: a letter stands for each, and their signs are
    // looked at below.
    const formulas = [...document.querySelectorAll('math')].map((formula) => [
      formula,
      document.createTextNode('x'),
    ]);
    formulas.forEach(([formula, place]) => formula.replaceWith(place));
    const { violations } = await globalThis.axe.run(document, {
      resultTypes: ['violations'],
      runOnly: ['color-contrast', 'link-in-text-block'],
    });
    formulas.forEach(([formula, place]) => place.replaceWith(formula));
    return violations;
  });
  const others = onlyColours
    ? []
    : await page.evaluate(() =>
        globalThis.axe
          .run(document, {
            resultTypes: ['violations'],
            rules: {
              'color-contrast': { enabled: false },
              'link-in-text-block': { enabled: false },
            },
          })
          .then(({ violations }) => violations),
      );
  return [
    ...[...colours, ...others].flatMap(({ id, help, nodes }) =>
      nodes.map((node) => `${id}: ${help}: ${node.target.join(' ')}`),
    ),
    ...(await page.evaluate(coloursOfFormulas)),
  ];
}

/**
 * No accessibility fault in light nor in dark. Where pictures are wanted they are NAME-light.png
 * and NAME-dark.png.
 * `inLight`: in dark only where the look is thorough.
 */
export async function look(page, name, { inLight = false } = {}) {
  // A window behind others draws once a second.
  await page.bringToFront();
  for (const colorScheme of inLight && !screenshots ? ['light'] : ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    await settled(page);
    await page.waitForLoadState('networkidle');
    if (screenshots) {
      mkdirSync(screenshots, { recursive: true });
      await page.screenshot({
        path: join(screenshots, `${name}-${colorScheme}.png`),
        fullPage: true,
      });
    }
    assert.deepEqual(
      await accessibility(page, {
        onlyColours: colorScheme === 'dark',
        rows: screenshots ? Infinity : 8,
      }),
      [],
      `${name} in ${colorScheme}`,
    );
  }
  await page.emulateMedia({ colorScheme: 'light' });
}
