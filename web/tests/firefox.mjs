// Every page of the explorer in Firefox: does it draw, and without an error? The other tests use
// Chromium; this one is for what browsers do differently. CHANGEOVER_SCREENSHOTS, a folder, gets a
// picture of each page.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { setTimeout as wait } from 'node:timers/promises';
import { screenshots, serve } from './support/browser.mjs';
import { launchFirefox } from './support/firefox.mjs';

const drawing = '#main svg, #main canvas';
const design = '#/design?v=61&k=4&change=2&kind=circular&show=';
/** Pages, what each has drawn when it is whole, and what is clicked before that. */
const pages = [
  ['home', '#/home', 'canvas.drawn'],
  ['catalog', '#/catalog?change=2&kind=circular', drawing],
  ['cell', '#/cell?v=40&k=6&change=2&kind=circular', '#main canvas'],
  ...['steps', 'stays', 'coverage', 'circle'].map((view) => [view, design + view, drawing]),
  ['array', `${design}array`, '.array-table'],
  ['recipe', `${design}recipe`, '#main .recipe'],
  ['blocks', `${design}blocks`, '#main pre.blocks'],
  ['verify', '#/verify', '.verdict', 'one with bad steps'],
  ['plan', '#/plan', '.verdict h2', 'three benches'],
  ['loadorder', '#/loadorder?items=64&room=16&workers=4', '.timeline-canvas'],
  ['search', '#/search?v=9&k=5&change=2&kind=linear', '.watch', 'Start'],
  ['theorems', '#/theorems', '#main math'],
];

/**
 * Drawings on the page that have one colour only, or no size. What lies over another one shows what
 * is pointed at: nothing here.
 */
const blank = `(() => {
  const empty = [];
  for (const canvas of document.querySelectorAll('#main canvas:not([class$=-over])')) {
    if (!canvas.checkVisibility()) continue;
    const { width, height } = canvas;
    const pixels = width && height
      ? canvas.getContext('2d').getImageData(0, 0, width, height).data.buffer
      : new ArrayBuffer();
    if (new Set(new Uint32Array(pixels)).size < 2) empty.push('canvas.' + canvas.className);
  }
  for (const picture of document.querySelectorAll('#main svg')) {
    const box = picture.getBoundingClientRect();
    const drawn = box.width > 0 && box.height > 0 && picture.children.length > 0;
    if (picture.checkVisibility() && !drawn) {
      empty.push('svg.' + picture.getAttribute('class'));
    }
  }
  return empty.join(', ');
})()`;

let server;
let firefox;
before(async () => {
  server = await serve();
  firefox = await launchFirefox();
  await firefox.size(1280, 950);
});
after(async () => {
  await firefox?.quit();
  assert.equal(await server?.stop(), 0, 'serve ends with exit code 0 when it is asked to stop');
});

for (const [name, fragment, whole, pressed] of pages) {
  test(`${name} draws in Firefox`, async () => {
    await firefox.goto('about:blank');
    await firefox.goto(server.address + fragment);
    await firefox.waitFor("document.querySelector('#main:not([aria-busy]) h1') !== null");
    if (pressed) {
      const found = `[...document.querySelectorAll('#main :is(a, button)')].find((each) =>
        each.textContent === ${JSON.stringify(pressed)})`;
      await firefox.waitFor(`${found} !== undefined`);
      await firefox.run(`${found}.click()`);
    }
    await firefox.waitFor(`document.querySelector(${JSON.stringify(whole)}) !== null`, 120);
    await firefox.waitFor(`document.getAnimations().every((each) => each.playState !== 'running')`);
    if (screenshots) {
      mkdirSync(screenshots, { recursive: true });
      writeFileSync(join(screenshots, `firefox-${name}.png`), await firefox.picture());
    }
    let empty;
    for (let tries = 0; tries < 100 && empty !== ''; ++tries) {
      await wait(tries === 0 ? 0 : 200);
      empty = await firefox.run(`return ${blank}`);
    }
    assert.equal(empty, '', 'drawings without anything drawn');
    assert.deepEqual(await firefox.faults(server.origin), []);
  });
}
