// Runs tests of pages: in one browser, which is opened once, and on one server, unless a file has
// one of its own. Each file has a new context of that browser, which is emptied after each test.
// Two files at a time, for a browser waits as often as it works. On a loaded machine a test can
// miss a limit of time: what fails is tried once more, alone, and that is said.
//
//     node tests/run.mjs FILE...              all tests of these files
//     node tests/run.mjs --only WORDS FILE... those whose names, behind that of their file, have
//                                             these words
import assert from 'node:assert/strict';
import { basename, resolve } from 'node:path';
import { after, describe, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { explore, newContext, serve } from './support/browser.mjs';
import { launchBrowser } from './support/chromium.mjs';
import { read } from './support/tests.mjs';

const { values, positionals } = parseArgs({
  options: { only: { type: 'string', default: '' } },
  allowPositionals: true,
});

/** What is made when it is first asked for, and once. */
function once(make) {
  let made = null;
  return { get: () => (made ??= make()), made: () => made };
}
const browser = once(launchBrowser);
const shared = once(() => serve());

async function stop(server) {
  const code = await (await server.made())?.stop();
  assert.equal(code ?? 0, 0, 'serve ends with exit code 0 when it is asked to stop');
}

async function run(body, context, server) {
  const explorer = await explore(await context.get(), await server.get());
  try {
    await body(explorer);
  } catch (fault) {
    await explorer.end().catch((also) => console.log(also.message));
    throw fault;
  }
  await explorer.end();
}

const files = [];
for (const path of positionals) {
  const name = basename(path, '.test.mjs');
  const { tests, serve: own } = await read(pathToFileURL(resolve(path)).href, name);
  const server = own ? once(own) : shared;
  const context = once(async () => newContext(await browser.get()));
  files.push({
    name,
    own: own !== null,
    server,
    tests: tests
      .map((each) => ({
        name: `${name}: ${each.name}`,
        run: () => run(each.body, context, server),
      }))
      .filter((each) => each.name.includes(values.only)),
  });
}
assert.ok(
  files.some(({ tests }) => tests.length > 0),
  `no test of ${positionals.join(', ') || 'no file'} has the words “${values.only}”`,
);

const missed = [];
describe('pages', { concurrency: 2 }, () => {
  for (const { name, tests } of files) {
    describe(name, { concurrency: 1 }, () => {
      for (const each of tests) {
        test(each.name, async (t) => {
          try {
            await each.run();
          } catch (fault) {
            missed.push(each);
            t.diagnostic(`failed, and is tried once more at the end: ${fault.stack}`);
          }
        });
      }
    });
  }
});
test('what failed, once more', async (t) => {
  for (const each of missed) {
    await t.test(each.name, each.run);
  }
});
test('servers end with exit code 0 when they are asked to stop', async () => {
  await Promise.all([...new Set(files.map(({ server }) => server))].map(stop));
});
after(async () => (await browser.made())?.close());
