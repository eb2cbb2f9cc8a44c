// Tests of pages, which tests/run.mjs runs: all of them in one browser and most on one server, each
// in a context of its own.
//
//     test('a click opens a cell', async (explorer) => {
//       const page = await explorer.open('#/catalog');
//     });
import { serve } from './browser.mjs';

let file = null;

/** A test of the file that is read. */
export function test(name, body) {
  fileThatIsRead().tests.push({ name, body });
}

/** The tests of this file have a server of their own, which keeps what they leave there. */
export const ownServer = () => served(() => serve());

/** The same, made by that function. */
export function served(make) {
  fileThatIsRead().serve = make;
}

function fileThatIsRead() {
  if (!file) {
    throw new Error('tests of pages are run by tests/run.mjs: node tests/run.mjs FILE...');
  }
  return file;
}

/** The tests of a file, and `serve` where they have a server of their own. */
export async function read(url, name) {
  file = { name, tests: [], serve: null };
  await import(url);
  const whole = file;
  file = null;
  return whole;
}
