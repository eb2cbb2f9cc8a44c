// Formulas in text and alone: what the pages find and where lines end.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from './support/source.mjs';

test('formulas in text: what is mathematics and what is not', async () => {
  const { pieces, texOf } = await load('lib/formula.ts');
  const set = (text) =>
    pieces(text)
      .map((piece) => ('tex' in piece ? `⟦${piece.tex}⟧` : piece.text))
      .join('');
  for (const [text, shown] of [
    [
      'at most 9 of C(40,2) = 780 pairs: b >= ceil(780 / 9) = 87 (a design with elements in ' +
        'every block needs no fewer)',
      'at most 9 of ⟦\\tbinom{40}{2}=780⟧ pairs: ⟦b\\ge \\lceil 780/9\\rceil =87⟧ (a design with ' +
        'elements in every block needs no fewer)',
    ],
    ['3-subsets of a v-set, end to end', '3-subsets of a v-set, end to end'],
    ['an element x of B_{i+1}', 'an element ⟦x⟧ of ⟦B_{i+1}⟧'],
    ['2*n1 + n2 <= 3k', '⟦2\\cdot n_{1}+n_{2}\\le 3k⟧'],
    ['d ≡ e ≢ 0', '⟦d\\equiv e\\not\\equiv 0⟧'],
    ['x − a with a in A', '⟦x-a⟧ with ⟦a⟧ in ⟦A⟧'],
    [
      'in a block. A further one has A in common, A+1 too',
      'in a block. A further one has ⟦A⟧ in common, ⟦A+1⟧ too',
    ],
    ['1, 2, …, v of 3, 4', '⟦1,\\, 2,\\, \\dots ,\\, v⟧ of 3, 4'],
    ['put ∞_s into blocks', 'put ⟦\\infty _{s}⟧ into blocks'],
    ['DCCD(61,4)', '⟦\\mathrm{DCCD}(61,4)⟧'],
    ['A = {0, 1, …, n−1} ⊂ Z_v', '⟦A=\\{0,\\, 1,\\, \\dots ,\\, n-1\\}\\subset Z_{v}⟧'],
    ['b = (x+y)(z+1) = k(v−1)+m(b−1) = 3v − 3k', '⟦b=(x+y)(z+1)⟧⟦{}=k(v-1)+m(b-1)⟧⟦{}=3v-3k⟧'],
    ['b = tp + 1 and cu + 2t − 1, at least', '⟦b=tp+1⟧ and ⟦cu+2t-1⟧, at least'],
    ['Σ A_x ≤ nk, at most sn, which', '⟦\\sum A_{x}\\le nk⟧, at most ⟦sn⟧, which'],
    ['it is so: by ms and km, of us', 'it is so: by ms and km, of us'],
    ['It is a design. A list, or a 3-design:', 'It is a design. A list, or a 3-design:'],
    ['(a) the first, as a list = a design', '(a) the first, as a list = a design'],
    ['over all T and I that', 'over all ⟦T⟧ and ⟦I⟧ that'],
    ['T + max(A, B, C). Here A, B and C', '⟦T+ \\max (A,\\, B,\\, C)⟧. Here ⟦A⟧, ⟦B⟧ and ⟦C⟧'],
    ['at least 5k − 3 − 2a − b stays', 'at least ⟦5k-3-2a-b⟧ stays'],
    ['put min(a, k−1) for a, and', 'put ⟦\\min (a,\\, k-1)⟧ for ⟦a⟧, and'],
    ['min(b, k−1−a) for every a.', '⟦\\min (b,\\, k-1-a)⟧ for every ⟦a⟧.'],
    ['for a ≠ b, and P_{aa} ≤ C(c_a,2)', 'for ⟦a\\ne b⟧, and ⟦P_{aa}\\le \\tbinom{c_{a}}{2}⟧'],
    ['fewer than 1 + a + b parameters', 'fewer than ⟦1+a+b⟧ parameters'],
    ['the theorem’s proof', 'the theorem’s proof'],
  ]) {
    assert.equal(set(text), shown, text);
  }
  assert.equal(texOf('s = 2  if v even'), 's=2\\quad \\text{ if }v\\text{ even }');
});

test('formulas in text: nothing is lost, and all of docs/theorems.md can be set', async () => {
  const { partsOf, pieces, texOf } = await load('lib/formula.ts');
  const { default: temml } = await import('temml');
  const source = readFileSync(
    join(dirname(fileURLToPath(import.meta.url)), '../../docs/theorems.md'),
    'utf8',
  );
  /** A formula that stands alone, and the parts in which it is set. */
  const displayed = (line) => {
    const parts = partsOf(line).flat();
    // But wide gaps around relations.
    const squeezed = (text) => text.replace(/ +/g, ' ');
    assert.equal(squeezed(parts.map((part) => part.text).join('')), squeezed(line));
    return [texOf(line), ...parts.map((part) => part.tex)];
  };
  let formulas = 0;
  for (const paragraph of source.split(/\n\n/)) {
    const found = pieces(paragraph);
    assert.equal(found.map((piece) => piece.text).join(''), paragraph);
    const all = /^ {4}/.test(paragraph)
      ? paragraph.split('\n').flatMap((line) => displayed(line.trim()))
      : found.flatMap((piece) => ('tex' in piece ? [piece.tex] : []));
    for (const tex of all) {
      assert.doesNotThrow(() => temml.renderToString(tex, { throwOnError: true }), tex);
      ++formulas;
    }
  }
  assert.ok(formulas > 2000, `${formulas}`);
});

test('a formula that stands alone ends its lines between parts, never in brackets', async () => {
  const { partsOf } = await load('lib/formula.ts');
  const shown = (line) =>
    partsOf(line).map((group) => group.map((part) => part.text.trim()).join(' ¦ '));
  assert.deepEqual(shown('x_p = pN + n,   y_p = −pN − 1   for −(c−1) ≤ p ≤ c.'), [
    'x_p = pN + n,',
    'y_p = −pN − 1',
    'for −(c−1) ¦ ≤ p ¦ ≤ c.',
  ]);
  assert.deepEqual(shown('c·u + (2c+1)w + max(0, w−K) + (c−1)·(k−2) blocks'), [
    'c·u + (2c+1)w ¦ + max(0, w−K) ¦ + (c−1) ¦ ·(k−2)',
    'blocks',
  ]);
  assert.deepEqual(shown('min_x (p + q, r)'), ['min_x (p + q, r)']);
  assert.equal(partsOf('min_x (p)')[0][0].tex, '\\min_{x} (p)');
});

test('fractions of formulas that stand alone', async () => {
  const { partsOf } = await load('lib/formula.ts');
  const set = (text) => partsOf(text).map((group) => group.map(({ tex }) => tex));
  assert.deepEqual(set('b ≥ (k−1)/2 · (v+1)'), [['b\\ge \\frac{k-1}{2}\\cdot (v+1)']]);
  assert.deepEqual(set('1 ≥ 2/C(s,t)'), [['1\\ge \\frac{2}{\\tbinom{s}{t}}']]);
  // Within brackets lines stay low, and products are not cut.
  assert.deepEqual(set('⌈v/2⌉'), [['\\lceil v/2\\rceil ']]);
  assert.deepEqual(set('v(v−1)/2'), [['v(v-1)/2']]);
});

test('a definition, a remainder in brackets, what stands in brackets after a name', async () => {
  const { pieces } = await load('lib/formula.ts');
  const tex = (text) => pieces(text).flatMap((piece) => ('tex' in piece ? [piece.tex] : []));
  assert.deepEqual(tex('let n := k−2'), ['n\\mathrel{:=}k-2']);
  assert.match(tex('if c ≡ 0 (mod 4)').join(), /mathrm\{mod\}/);
  assert.match(tex('if c mod 4 = 1').join(), /bmod/);
  assert.deepEqual(tex('A is part of B_{−1}'), ['A', 'B_{-1}']);
  const [design, ...others] = tex('a DCCD(c(4k−6)+1, k, c(c(4k−6)+1)) is');
  assert.match(design, /^\\mathrm\{DCCD\}.*\)$/);
  assert.deepEqual(others, []);
});

test('each theorem is in one group, with a short title', async () => {
  const { groups } = await load('pages/theorems/groups.ts');
  const text = readFileSync(new URL('../../docs/theorems.md', import.meta.url), 'utf8');
  const numbers = [...text.matchAll(/^## Theorem (\d+)$/gm)].map(([, number]) => number);
  const entries = groups.flatMap(([, some]) => some);
  assert.deepEqual(entries.map(([number]) => number).sort(), numbers.sort());
  for (const [number, title] of entries) {
    assert.ok(title.length <= 40, `Theorem ${number}: ${title}`);
  }
});
