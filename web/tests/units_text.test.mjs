// Nothing that docs/theorems.md says is lost on the way to the page: its letters and digits are
// those of what is shown, as it is written and once its formulas are set.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from './support/source.mjs';

/** As much of a document as text and formulas need. */
class FakeNode {
  childNodes = [];
  style = {};
  classList = { add() {}, remove() {} };
  constructor(text = '') {
    this.own = text;
  }
  appendChild(child) {
    this.childNodes.push(...(child.isFragment ? child.childNodes : [child]));
    return child;
  }
  replaceChildren(...children) {
    this.childNodes = children;
  }
  get textContent() {
    return this.own + this.childNodes.map((child) => child.textContent).join('');
  }
  set textContent(text) {
    this.own = text;
    this.childNodes = [];
  }
  setAttribute() {}
  addEventListener() {}
  checkVisibility() {
    return false;
  }
}

/** What is called before a page is printed: it sets all formulas. */
const print = [];
Object.assign(globalThis, {
  window: {
    addEventListener: (name, call) => name === 'beforeprint' && print.push(call),
  },
  document: {
    compatMode: 'CSS1Compat',
    createElement: () => new FakeNode(),
    createElementNS: () => new FakeNode(),
    createTextNode: (text) => new FakeNode(text),
    createDocumentFragment: () => Object.assign(new FakeNode(), { isFragment: true }),
  },
  requestAnimationFrame() {},
});

/** Letters and digits; marks above and below them, and signs of sums, are none. */
const letters = (text) =>
  text
    .normalize('NFKD')
    .replace(/[Σ∑]/g, '')
    .toLowerCase()
    .replace(/[^\p{L}\p{N}]/gu, '');

const here = dirname(fileURLToPath(import.meta.url));
const works = JSON.parse(readFileSync(join(here, '../references.json'), 'utf8'));

/** The letters of Markdown, without what is markup. */
const lettersOf = (markdown) =>
  letters(
    markdown
      .replace(/^ {0,3}\d+\. /gm, '') // The browser numbers lists.
      .replace(/\]\((?:[^()]|\([^()]*\))*\)/g, ']'),
  );

/** Where two texts differ first. */
function difference(one, other) {
  let at = 0;
  while (at < one.length && one[at] === other[at]) {
    ++at;
  }
  return [one, other].map((text) => text.slice(Math.max(0, at - 40), at + 40)).join(' | ');
}

test('no letter of docs/theorems.md is lost, as it is written and as it is set', async () => {
  const { markup, prepare, spoken } = await load('../tests/support/text.ts');
  const source = readFileSync(join(here, '../../docs/theorems.md'), 'utf8');
  await prepare();
  // Works are shown by their names.
  const names = Object.keys(works).map((key) => [letters(spoken(key)), letters(key)]);
  const keyed = (text) => names.reduce((all, [name, key]) => all.replaceAll(name, key), text);
  for (const section of source.split(/^(?=## )/m)) {
    const wanted = keyed(lettersOf(section));
    assert.ok(wanted.length > 200);
    const shown = markup(section);
    const text = () => keyed(letters(shown.map((each) => each.textContent).join(' ')));
    assert.ok(text() === wanted, difference(text(), wanted));
    print.forEach((call) => call());
    assert.ok(text() === wanted, difference(text(), wanted));
  }
});

test('base blocks have the names of the design, and an origin is told once', async () => {
  const { indexed, told } = await load('parts/recipe.ts').then(async (recipe) => ({
    ...recipe,
    ...(await load('lib/words.ts')),
  }));
  const text =
    'Written down in the catalog as 4.2.1.circular.6.00000000: changeover search 4 2; ' +
    'changeover 0.1.0; Someone; 2026-11-21. Develop the base blocks {0,3}, {1,2} over 2 copies ' +
    'of Z_2.';
  const labels = ['0_0', '1_0', '0_1', '1_1'];
  assert.equal(
    told(text, { labels, withoutOrigin: true }),
    'Develop the base blocks {0_0, 1_1}, {1_0, 0_1} over 2 copies of Z_2.',
  );
  assert.equal(told(text), text);
  assert.equal(
    told(
      'Develop the base block {0,4} over 2 copies of Z_2 and a fixed element: 2j + i is i of copy ' +
        'j, written i_j; 4 is fixed, written ∞.',
      { labels: [...labels, '∞'] },
    ),
    'Develop the base block {0_0, ∞} over 2 copies of Z_2 and a fixed element ∞: i_j is i of copy j.',
  );
  const alone = text.slice(0, text.indexOf(' Develop'));
  assert.equal(told(alone, { withoutOrigin: true }), '', 'all of it is told elsewhere');
  assert.deepEqual(['∞_0', '1_12', 'a_b', '7'].map(indexed), ['∞₀', '1₁₂', 'a_b', '7']);
});

test('a search for base blocks that found none says so plainly', async () => {
  const { plainly } = await load('pages/search/words.ts');
  const said = (why, tried, none) =>
    plainly(
      `No base blocks found (${why}): of ${tried} tried the SAT solver says none exist in ${none}.`,
    );
  assert.match(said('exhausted', '3 shapes', 3), /All that fit, 3 shapes, were tried: for each a/);
  assert.match(said('time limit', '1 shape', 0), /1 shape was tried before .* none was decided/);
  assert.equal(plainly('something else'), 'something else');
});
