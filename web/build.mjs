// Builds the pages into dist/, which is kept beside the sources so that a machine without Node
// builds the explorer too.
//
//     node build.mjs            write dist/
//     node build.mjs --check    compare dist/ with the sources; exit code 1 if they differ
//     node build.mjs --watch    write dist/ whenever a source changes (for work on pages)
//
// dist/sources.sha256 has the checksum of each source: it tells without Node whether dist/ is of
// these sources.
import { createHash } from 'node:crypto';
import { mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const dist = join(here, 'dist');

/** @returns {Promise<string[]>} every file below `folder`, sorted */
async function filesBelow(folder) {
  const entries = await readdir(folder, { withFileTypes: true });
  const lists = await Promise.all(
    entries.map((entry) => {
      const path = join(folder, entry.name);
      return entry.isDirectory() ? filesBelow(path) : [path];
    }),
  );
  return lists.flat().sort();
}

async function checksums() {
  const paths = [
    ...(await filesBelow(join(here, 'src'))),
    join(here, 'answers.d.ts'),
    join(here, 'references.json'),
    join(here, 'build.mjs'),
    join(here, 'types.mjs'),
    join(here, 'package.json'),
    join(here, 'package-lock.json'),
    join(here, 'tsconfig.json'),
  ];
  const lines = await Promise.all(
    paths.map(async (path) => {
      const hash = createHash('sha256')
        .update(await readFile(path))
        .digest('hex');
      return `${hash}  ${relative(here, path)}\n`;
    }),
  );
  return lines.sort((a, b) => (a.slice(66) < b.slice(66) ? -1 : 1)).join('');
}

const styles = {
  name: 'styles',
  setup: ({ onLoad }) =>
    onLoad({ filter: /\.css$/ }, async ({ path }) => {
      const [[, css]] = await bundled({ 'assets/style': path });
      return { contents: Buffer.from(css).toString(), loader: 'text' };
    }),
};

/** What these sources are bundled into. Scripts have styles as texts. */
async function bundled(entryPoints, plugins = []) {
  const built = await esbuild.build({
    plugins,
    absWorkingDir: here,
    entryPoints,
    outdir: 'dist',
    bundle: true,
    minify: true,
    write: false,
    format: 'esm',
    splitting: true,
    chunkNames: 'assets/[name]',
    target: ['es2022', 'chrome110', 'firefox110', 'safari16.4'],
    legalComments: 'eof',
    charset: 'utf8',
    logLevel: 'warning',
  });
  return built.outputFiles.map((file) => [relative(dist, file.path), file.contents]);
}

/** @returns {Promise<Map<string, Uint8Array>>} path below dist/ to content */
async function pages() {
  // The worker by itself: nothing that both need is a file of its own, which would come later.
  const files = new Map([
    ...(await bundled({ 'assets/app': 'src/first.ts' }, [styles])),
    ...(await bundled({ 'assets/verify-worker': 'src/pages/verify/worker.ts' })),
  ]);
  // What is bundled comes with its licence.
  const licences = { uPlot: 'uplot/LICENSE', Temml: 'temml/LICENSE' };
  const parts = [
    ['uPlot', (path, text) => path.endsWith('.js') && text.includes('u-legend')],
    [
      'Temml',
      (path, text) =>
        path.endsWith('.js') && text.includes('\\\\mathrm') && text.includes('mtable'),
    ],
  ];
  for (const [path, content] of files) {
    const text = Buffer.from(content).toString('utf8');
    for (const [name, has] of parts) {
      if (has(path, text)) {
        const licence = await readFile(join(here, 'node_modules', licences[name]), 'utf8');
        files.set(
          path,
          Buffer.concat([
            Buffer.from(`/*! With ${name}:\n${licence.trim()}\n*/\n`),
            files.get(path),
          ]),
        );
      }
    }
  }
  // The first style is in the page: nothing else is asked for before the first paint.
  const [[, style]] = await bundled({ 'assets/first': 'src/style/first.css' });
  const page = await readFile(join(here, 'src/index.html'), 'utf8');
  files.set(
    'index.html',
    Buffer.from(
      page.replace(
        '<style></style>',
        () => `<style>${Buffer.from(style).toString().trim()}</style>`,
      ),
    ),
  );
  files.set('assets/icon.svg', await readFile(join(here, 'src/icon.svg')));
  files.set('sources.sha256', Buffer.from(await checksums()));
  return new Map([...files].sort());
}

async function write() {
  const files = await pages();
  await rm(dist, { recursive: true, force: true });
  for (const [path, content] of files) {
    await mkdir(dirname(join(dist, path)), { recursive: true });
    await writeFile(join(dist, path), content);
  }
  return files;
}

async function check() {
  const files = await pages();
  const kept = (await filesBelow(dist)).map((path) => relative(dist, path));
  const wrong = kept.filter((path) => !files.has(path));
  for (const [path, content] of files) {
    const old = await readFile(join(dist, path)).catch(() => undefined);
    if (!old || Buffer.compare(old, Buffer.from(content)) !== 0) {
      wrong.push(path);
    }
  }
  return wrong;
}

const mode = process.argv[2] ?? '';
if (mode === '--check') {
  const wrong = await check();
  if (wrong.length > 0) {
    console.error(
      `web/dist is not what web/src makes: ${wrong.join(', ')}; run ./dev web build and commit ` +
        `dist`,
    );
    process.exit(1);
  }
} else if (mode === '--watch') {
  const { watch } = await import('node:fs');
  await write();
  let timer;
  watch(join(here, 'src'), { recursive: true }, () => {
    clearTimeout(timer);
    timer = setTimeout(() => write().catch((error) => console.error(error.message)), 100);
  });
} else if (mode === '') {
  let bytes = 0;
  for (const content of (await write()).values()) {
    bytes += content.length;
  }
  console.log(`dist: ${bytes} bytes`);
} else {
  console.error('usage: node build.mjs [--check|--watch]');
  process.exit(2);
}
