// Parts of the pages that need no browser, for tests:
//
//     const { parse } = await load('lib/markdown.ts');
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import * as esbuild from 'esbuild';

const src = join(dirname(fileURLToPath(import.meta.url)), '..', '..', 'src');

export async function load(path) {
  const built = await esbuild.build({
    entryPoints: [join(src, path)],
    bundle: true,
    write: false,
    format: 'esm',
    target: 'node18',
    logLevel: 'warning',
  });
  return import(
    `data:text/javascript;base64,${Buffer.from(built.outputFiles[0].contents).toString('base64')}`
  );
}
