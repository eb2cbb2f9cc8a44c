// Writes answers.d.ts: the types of what is asked and answered, from the JSON Schemas in docs/schema.
//
//     node types.mjs            write it
//     node types.mjs --check    compare; exit code 1 if the schemas say something else
import { readdir, readFile, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { compile } from 'json-schema-to-typescript';

const here = dirname(fileURLToPath(import.meta.url));
const schemas = join(here, '../docs/schema');
const kept = join(here, 'answers.d.ts');

const files = (await readdir(schemas)).filter((name) => name.endsWith('.json')).sort();
const short = (file) => file.replace(/^changeover-|-\d+\.json$/g, '');
const names = new Map();
for (const file of files) {
  names.set(JSON.parse(await readFile(join(schemas, file), 'utf8')).title, short(file));
}
const documents = {
  title: 'documents',
  type: 'object',
  required: [...files.map(short), 'refusal'],
  properties: {
    ...Object.fromEntries(files.map((file) => [short(file), { $ref: file }])),
    refusal: { $ref: 'explorer-1.json#/$defs/refusal' },
  },
};
const written = await compile(documents, 'documents', {
  cwd: `${schemas}/`,
  additionalProperties: false,
  bannerComment: '// Made by types.mjs of docs/schema: ./dev web build writes it anew.',
  customName: ({ title }, key) => names.get(title) ?? title ?? key,
  style: { singleQuote: true, printWidth: 140, objectWrap: 'collapse' },
});
const made = written.replace(/\/\*\*\n *\* (.*)\n *\*\//g, '/** $1 */');
if (!process.argv.includes('--check')) {
  await writeFile(kept, made);
} else if ((await readFile(kept, 'utf8').catch(() => '')) !== made) {
  console.error('web/answers.d.ts is not what docs/schema says; run ./dev web build and commit it');
  process.exit(1);
}
