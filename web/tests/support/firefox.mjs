// Firefox without a window, driven by Marionette, its own protocol: JSON over a socket of this
// machine. FIREFOX names the program.
import { spawn } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { connect } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { setTimeout as wait } from 'node:timers/promises';

const program =
  process.env.FIREFOX ??
  ['/usr/bin/firefox-esr', '/usr/bin/firefox'].find((path) => existsSync(path));

// It opens its socket at a free port, and asks for nothing on the network.
const preferences = {
  'marionette.port': 0,
  'browser.shell.checkDefaultBrowser': false,
  'browser.startup.page': 0,
  'datareporting.policy.dataSubmissionEnabled': false,
  'network.captive-portal-service.enabled': false,
  'network.connectivity-service.enabled': false,
  'app.normandy.enabled': false,
  'services.settings.server': 'data:,',
};

/** Resolves to what `attempt` returns as soon as that is not undefined. */
async function until(attempt, what, seconds = 60) {
  for (let end = Date.now() + seconds * 1000; Date.now() < end; await wait(100)) {
    const result = await attempt();
    if (result !== undefined) {
      return result;
    }
  }
  throw new Error(`Firefox: ${what} for ${seconds} s`);
}

/**
 * Messages are `LENGTH:[0, NUMBER, COMMAND, VALUES]`, answers `LENGTH:[1, NUMBER, ERROR, VALUE]`.
 */
async function converse(port) {
  const socket = connect(port, '127.0.0.1');
  const waiting = new Map();
  let bytes = Buffer.alloc(0);
  let greeted;
  const greeting = new Promise((resolve) => (greeted = resolve));
  const end = (error) => waiting.forEach(({ reject }) => reject(error));
  const take = (message) => {
    if (!Array.isArray(message)) {
      greeted();
      return;
    }
    const [, number, error, value] = message;
    const { command, resolve, reject } = waiting.get(number);
    waiting.delete(number);
    if (error) {
      reject(new Error(`${command}: ${error.error}: ${error.message}`));
    } else {
      resolve(value?.value);
    }
  };
  socket.on('error', end);
  socket.on('close', () => end(new Error('Firefox closed the connection')));
  socket.on('data', (data) => {
    bytes = Buffer.concat([bytes, data]);
    for (;;) {
      const colon = bytes.indexOf(':');
      const length = Number(bytes.subarray(0, Math.max(colon, 0)).toString());
      if (colon < 0 || bytes.length < colon + 1 + length) {
        return;
      }
      const message = bytes.subarray(colon + 1, colon + 1 + length).toString();
      bytes = bytes.subarray(colon + 1 + length);
      take(JSON.parse(message));
    }
  });
  await greeting;
  let last = 0;
  return {
    send: (command, values = {}) =>
      new Promise((resolve, reject) => {
        const text = JSON.stringify([0, ++last, command, values]);
        waiting.set(last, { command, resolve, reject });
        socket.write(`${Buffer.byteLength(text)}:${text}`);
      }),
    close: () => socket.destroy(),
  };
}

/** A Firefox with a profile of its own, which `quit` takes away. */
export async function launchFirefox() {
  const profile = mkdtempSync(join(tmpdir(), 'changeover-firefox-'));
  const lines = Object.entries(preferences).map(
    ([name, value]) => `user_pref(${JSON.stringify(name)}, ${JSON.stringify(value)});\n`,
  );
  writeFileSync(join(profile, 'user.js'), lines.join(''));
  const child = spawn(
    program,
    // Errors on pages are told by the console of the browser, which is the system's.
    [
      ...['--headless', '--marionette', '--remote-allow-system-access'],
      ...['--no-remote', '--profile', profile],
    ],
    { stdio: 'ignore', env: { ...process.env, HOME: profile, MOZ_CRASHREPORTER_DISABLE: '1' } },
  );
  const ended = new Promise((resolve) => child.once('exit', resolve));
  const failed = new Promise((_, reject) => child.once('error', reject));
  const quit = async () => {
    child.kill('SIGTERM');
    await ended;
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  };
  const port = await Promise.race([
    failed,
    until(() => {
      if (child.exitCode !== null) {
        throw new Error(`Firefox ended with exit code ${child.exitCode}`);
      }
      const path = join(profile, 'MarionetteActivePort');
      return existsSync(path) ? Number(readFileSync(path, 'utf8')) || undefined : undefined;
    }, 'it did not listen'),
  ]);
  const { send, close } = await converse(port);
  await send('WebDriver:NewSession', {});
  const run = (script, ...args) => send('WebDriver:ExecuteScript', { script, args });
  return {
    version: () => run('return navigator.userAgent'),
    size: (width, height) => send('WebDriver:SetWindowRect', { width, height }),
    goto: (url) => send('WebDriver:Navigate', { url }),
    /** What the body of a function returns on the page. */
    run,
    /** Waits until that is true on the page. */
    waitFor: (condition, seconds) =>
      until(
        async () => ((await run(`return ${condition}`)) ? true : undefined),
        `not true: ${condition}`,
        seconds,
      ),
    picture: async () =>
      Buffer.from(await send('WebDriver:TakeScreenshot', { full: false }), 'base64'),
    /** What the console has of errors on pages of that server, and forgets then. */
    async faults(origin) {
      await send('Marionette:SetContext', { value: 'chrome' });
      const found = await run(
        `const found = Services.console.getMessageArray()
           .filter((each) => each instanceof Ci.nsIScriptError)
           .filter((each) => !(each.flags & Ci.nsIScriptError.warningFlag))
           .filter((each) => each.sourceName.startsWith(arguments[0]))
           .map((each) => each.category + ': ' + each.errorMessage + ' (' + each.sourceName + ')');
         Services.console.reset();
         return found;`,
        origin,
      );
      await send('Marionette:SetContext', { value: 'content' });
      return found;
    },
    async quit() {
      close();
      await quit();
    },
  };
}
