// The browser that tests use: CHROMIUM names it. chromium-headless-shell is Chromium without
// windows, the same engine for less of the processor.
import { existsSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const executablePath =
  process.env.CHROMIUM ??
  ['/usr/bin/chromium-headless-shell', '/usr/bin/chromium'].find((path) => existsSync(path));

const settings = {
  executablePath,
  args: [
    '--disable-gpu',
    '--disable-quic',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
  ],
  chromiumSandbox: process.getuid?.() !== 0,
};

/** A browser without a window. */
export const launchBrowser = () => chromium.launch(settings);

/** Its context, with a profile of its own that `quit` takes away. */
export async function launch(options) {
  const profile = mkdtempSync(join(tmpdir(), 'changeover-chromium-'));
  const context = await chromium.launchPersistentContext(profile, { ...settings, ...options });
  const quit = async () => {
    await context.close();
    rmSync(profile, { recursive: true, force: true });
  };
  return { context, quit };
}
