// Writes answers.d.ts: the types of what is asked and answered, from the JSON Schemas in
// docs/schema; and references.json: the works that are cited, from docs/references.bib.
//
//     node types.mjs            write them
//     node types.mjs --check    compare; exit code 1 if the schemas or the bibliography differ
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
  style: { singleQuote: true, printWidth: 100, objectWrap: 'collapse' },
});
/** The lines of a comment, each at most 100 columns. */
function comment(_, indent, text) {
  const lines = [''];
  for (const word of text.split(' ')) {
    const line = lines.at(-1);
    const longer = line === '' ? word : `${line} ${word}`;
    longer.length + indent.length > 96 ? lines.push(word) : (lines[lines.length - 1] = longer);
  }
  return lines.length === 1 && lines[0].length + indent.length < 94
    ? `${indent}/** ${lines[0]} */`
    : [`${indent}/**`, ...lines.map((line) => `${indent} * ${line}`), `${indent} */`].join('\n');
}
const made = written.replace(/^( *)\/\*\*\n *\* (.*)\n *\*\//gm, comment);

/** "Bean, Richard and Chafee, A. L." as "R. Bean and A. L. Chafee", or "Bean and Chafee" */
function authors(field, initialled = true) {
  const names = field.split(/\s+and\s+/).map((name) => {
    const [last, first] = name.split(/,\s*/);
    const initials = ((initialled && first) || '')
      .split(/\s+/)
      .filter(Boolean)
      .map((each) => `${each.replace(/\./g, '')[0]}.`);
    return [...initials, last].join(' ');
  });
  const listed = names.filter((name) => name !== 'others');
  return names.length > 3 || listed.length < names.length
    ? `${listed[0]} et al.`
    : names.length > 1
      ? `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`
      : names[0];
}

const marks = { "'": 0x301, '`': 0x300, '"': 0x308, '~': 0x303, '^': 0x302, c: 0x327, v: 0x30c };
const accented = (_, mark, letter) => (letter + String.fromCodePoint(marks[mark])).normalize('NFC');
const plain = (text) =>
  text
    .replace(/\s+/g, ' ')
    .replace(/\{\\(['"`~^cv])\s?\{?(\w)\}?\}/g, accented)
    .replace(/\\(['"`~^])\{?(\w)\}?/g, accented)
    .replace(/[{}\\]/g, '')
    .replace(/--/g, '–')
    .trim();

// "GE$^2$": what TeX sets as a power.
const powers = { 2: '²', 3: '³' };
const titled = (text) =>
  plain(text.replace(/\$\^\{?(\d)\}?\$/g, (all, digit) => powers[digit] ?? all));

/** "Utilitas Mathematica 47, 55–84 (1995)": where and when a work came out, as far as it is known */
function place({ where, volume, number, pages, year }) {
  const issue = [volume, number && `(${number})`].filter(Boolean).join('');
  const within = [[where, where && issue].filter(Boolean).join(' '), where && pages];
  const known = within.filter(Boolean).map(plain).join(', ');
  return known && year ? `${known} (${year})` : known || year || '';
}

const references = {};
for (const [, key, body] of (await readFile(join(here, '../docs/references.bib'), 'utf8')).matchAll(
  /^@\w+\{([^,]+),\n(.*?)^\}/gms,
)) {
  const field = (name) => {
    const found = new RegExp(
      `^\\s*${name}\\s*=\\s*\\{((?:[^{}]|\\{(?:[^{}]|\\{[^{}]*\\})*\\})*)\\}`,
      'm',
    ).exec(body)?.[1];
    return found === undefined ? null : found;
  };
  const names = ['author', 'title', 'year', 'doi', 'eprint', 'url', 'note'];
  const [author, title, year, doi, eprint, url, note] = names.map(field);
  const where = field('journal') ?? field('booktitle');
  const [volume, number, pages] = ['volume', 'number', 'pages'].map(field);
  references[key] = {
    name: [
      author ? plain(authors(author, false)) : key,
      author && (year ?? /\d{4}$/.exec(key)?.[0]),
    ]
      .filter(Boolean)
      .join(' '),
    // A work that we know only from others has no title: the note says what it is.
    text: [
      author && plain(authors(author)),
      title ? titled(title) : note && plain(note),
      place({ where, volume, number, pages, year }),
    ]
      .filter(Boolean)
      .join('. ')
      .replaceAll('..', '.'),
    url: doi
      ? `https://doi.org/${doi}`
      : eprint
        ? `https://arxiv.org/abs/${eprint}`
        : (url ?? null),
  };
}

// "[ChafeeStevens2025, Section 1]" in a note is "Chafee and Stevens 2025, Section 1".
for (const work of Object.values(references)) {
  work.text = work.text.replace(/\[([A-Z]\w+)([^\]]*)\]/g, (all, key, within) =>
    key in references ? references[key].name + within : all,
  );
}

const bibliography = join(here, 'references.json');
const listed = `${JSON.stringify(references, null, 1)}\n`;
const reading = (path) => readFile(path, 'utf8').catch(() => '');
if (!process.argv.includes('--check')) {
  await writeFile(kept, made);
  await writeFile(bibliography, listed);
} else if ((await reading(kept)) !== made || (await reading(bibliography)) !== listed) {
  console.error(
    'web/answers.d.ts or web/references.json is not what docs/schema and docs/references.bib ' +
      'say; run ./dev web build and commit them',
  );
  process.exit(1);
}
