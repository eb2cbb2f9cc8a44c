// Takes the pictures of docs/pages.md: every page of the explorer at work, made small; in light
// (NAME-after.webp), in dark (NAME-dark.webp), and on a phone (NAME-phone.webp).
//
//     node docs/tools/page_pictures.mjs [--site FOLDER] [NAME...]
//
// writes into docs/img/pages what the program in build/release shows, all pages unless some are
// named; with --site also the first page of the site in that folder (`./dev docs` makes
// build/site). `./dev web pictures` runs it. What web/tests needs must be installed
// (`./dev web install`). The pictures "before" were taken by this script, too: CHANGEOVER_PROGRAM
// names the program whose pages it shows, and --as before what stands behind the names; then there
// is only the one in light.
import { mkdirSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { start } from "../../web/tests/support/browser.mjs";
import { launch } from "../../web/tests/support/chromium.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "..", "..");
const { values, positionals } = parseArgs({
  options: {
    as: { type: "string", default: "after" },
    site: { type: "string" },
    out: { type: "string", default: join(root, "docs/img/pages") },
  },
  allowPositionals: true,
});
const desktop = { width: 1280, height: 800 };
/** What stands behind the names, how wide pictures become, and how many bytes they may have. */
const shapes = [
  {
    as: values.as,
    viewport: desktop,
    colorScheme: "light",
    wide: 900,
    most: 40_000,
  },
  {
    as: "dark",
    viewport: desktop,
    colorScheme: "dark",
    wide: 700,
    most: 30_000,
  },
  {
    as: "phone",
    viewport: { width: 390, height: 844 },
    colorScheme: "light",
    wide: 320,
    most: 26_000,
  },
].filter(({ as }) => values.as === "after" || as === values.as);

/** Brings an element to the top of the window, if there is one. */
const toTop = (page, which) =>
  page.evaluate((selector) => {
    const found = document.querySelector(selector);
    if (found) {
      window.scrollTo(
        0,
        found.getBoundingClientRect().top + window.scrollY - 16,
      );
    }
  }, which);
const soon = { timeout: 90_000 };

/** Name, address and what is done there; the same in all versions. */
const pages = [
  [
    "start",
    "#/home",
    (page) => page.locator("canvas.drawn").first().waitFor(soon),
  ],
  [
    "catalog",
    "#/catalog",
    async (page) => page.locator("table.cells a").first().waitFor(soon),
  ],
  ["triples", "#/catalog?strength=3", async (page) => page.waitForTimeout(500)],
  [
    "cell",
    "#/cell?v=40&k=6&change=2&kind=circular",
    (page) => page.locator(".recipe-node").first().waitFor(soon),
  ],
  ["design", "#/design?v=20&k=5&change=2&kind=circular&show=steps&at=12"],
  [
    "verify",
    "#/verify",
    async (page) => {
      await page.getByText("one with bad steps").click();
      await page.locator(".verdict").first().waitFor(soon);
      await page.waitForTimeout(4000);
      await toTop(page, ".verdict");
    },
  ],
  [
    "plan",
    "#/plan",
    async (page) => {
      await page.getByRole("button", { name: "Try it: a pump bench" }).click();
      await page.getByText("What if").first().waitFor(soon);
      await page.waitForTimeout(2000);
      await toTop(page, ".verdict");
    },
  ],
  [
    "loadorder",
    "#/loadorder?items=64&room=16&workers=4",
    async (page) => {
      await page.locator("#main canvas, #main svg").first().waitFor(soon);
      await page.waitForTimeout(1000);
      await toTop(page, ".result, .verdict, .answer");
    },
  ],
  [
    "search",
    "#/search?v=40&k=6&change=2&kind=circular",
    async (page) => {
      await page.getByRole("button", { name: "Start" }).click();
      await page.waitForTimeout(10_000);
    },
  ],
  ["theorems", "#/theorems"],
];

/** A small WebP of what is in sight, as sharp as its bytes allow. */
async function picture(context, page, name, { as, viewport, wide, most }) {
  const protocol = await context.newCDPSession(page);
  const y = await page.evaluate(() => window.scrollY);
  for (let quality = 90; ; quality -= 5) {
    const { data } = await protocol.send("Page.captureScreenshot", {
      format: "webp",
      quality,
      clip: { x: 0, y, ...viewport, scale: wide / viewport.width },
    });
    const bytes = Buffer.from(data, "base64");
    if (bytes.length <= most || quality === 10) {
      const file = join(values.out, `${name}-${as}.webp`);
      writeFileSync(file, bytes);
      console.log(`${file}: ${bytes.length} bytes, quality ${quality}`);
      break;
    }
  }
  await protocol.detach();
}

const named = (name) => positionals.length === 0 || positionals.includes(name);
mkdirSync(values.out, { recursive: true });
for (const shape of shapes) {
  const explorer = await start(shape);
  for (const [name, fragment, act] of pages.filter(([name]) => named(name))) {
    const page = await explorer.open(fragment);
    await page.waitForLoadState("networkidle");
    await act?.(page);
    await page.waitForTimeout(1500);
    await picture(explorer.context, page, name, shape);
    await page.close();
  }
  await explorer.stop();
}
if (values.site && named("site")) {
  const [shape] = shapes;
  const { context, quit } = await launch({ viewport: shape.viewport });
  const page = await context.newPage();
  await page.goto(pathToFileURL(join(resolve(values.site), "index.html")).href);
  await page.waitForTimeout(1500);
  await picture(context, page, "site", shape);
  await quit();
}
