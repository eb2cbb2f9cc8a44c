// What the pages compute without a browser: Markdown, ranges, the look-up box, and the steps of a
// design.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { load } from './support/source.mjs';

const { parse, inline } = await load('lib/markdown.ts');
const { readRange } = await load('lib/range.ts');
const { understand } = await load('pages/catalog/look_up.ts');
const { inWords } = await load('pages/plan/document.ts');
const { compare } = await load('pages/catalog/cells.ts');
const { Steps } = await load('pages/design/steps.ts');
const { asText, asCsv } = await load('parts/downloads.ts');

const text = (it) => ({ is: 'text', text: it });
const words = (parts) => parts.map((each) => each.text ?? words(each.inside)).join('');

test('Markdown: emphasis, code, links', () => {
  assert.deepEqual(inline('a *b* **c** `d*e*` [f](#g).'), [
    text('a '),
    { is: 'em', inside: [text('b')] },
    text(' '),
    { is: 'strong', inside: [text('c')] },
    text(' '),
    { is: 'code', text: 'd*e*' },
    text(' '),
    { is: 'link', to: '#g', inside: [text('f')] },
    text('.'),
  ]);
  assert.deepEqual(inline('[ChafeeStevens2025, Theorem 2] stays'), [
    text('[ChafeeStevens2025, Theorem 2] stays'),
  ]);
  assert.deepEqual(inline('2 * 3 * 4'), [text('2 * 3 * 4')]);
  assert.deepEqual(inline('*open'), [text('*open')]);
  assert.deepEqual(inline('*a **b** c*')[0].is, 'em');
  assert.deepEqual(inline('<b>&amp;'), [text('<b>&amp;')]);
});

test('Markdown: subscripts and superscripts of mathematics, and no others', () => {
  const sub = (it) => ({ is: 'sub', inside: [text(it)] });
  assert.deepEqual(inline('B_{i+1} ∖ B_i'), [text('B'), sub('i+1'), text(' ∖ B'), sub('i')]);
  assert.deepEqual(inline('x̄_p, T_{x′}, n_12'), [
    text('x̄'),
    sub('p'),
    text(', T'),
    sub('x′'),
    text(', n'),
    sub('12'),
  ]);
  assert.deepEqual(inline('Σ_x i_x'), [text('Σ'), sub('x'), text(' i'), sub('x')]);
  assert.deepEqual(inline('v^2'), [text('v'), { is: 'sup', inside: [text('2')] }]);
  assert.deepEqual(inline('a_{b_c}')[1], { is: 'sub', inside: [text('b'), sub('c')] });
  assert.deepEqual(inline('in a_file, _x, a _ b, open_{brace'), [
    text('in a_file, _x, a _ b, open_{brace'),
  ]);
});

test('Markdown: paragraphs, headings, lists, tables, formulas', () => {
  const parts = parse(
    '# One\n\nfirst\nline\n- a\n- b\n  more\n\n  second\n\n1. x\n2. y\n   - z\n\nand\n\n    E ' +
      '+ 1  *if* v\n    F\n\n| a | |\n|---|---|\n| b | c |\n',
  );
  assert.deepEqual(
    parts.map((part) => part.is),
    ['heading', 'paragraph', 'list', 'list', 'paragraph', 'formula', 'table'],
  );
  assert.equal(words(parts[1].inside), 'first\nline');
  assert.deepEqual(
    parts[2].items.map((item) => item.length),
    [1, 2],
  );
  assert.equal(parts[3].ordered, true);
  assert.deepEqual(
    parts[3].items[1].map((part) => part.is),
    ['paragraph', 'list'],
  );
  assert.equal(parts[5].lines.length, 2);
  assert.deepEqual(
    parts[6].rows.map((row) => row.map(words)),
    [['b', 'c']],
  );
  assert.deepEqual(parse(''), []);
  assert.equal(parse('p = 3\n4. is no list here')[0].is, 'paragraph');
});

test('Markdown: nothing of docs/theorems.md is lost', () => {
  const source = readFileSync(
    join(dirname(fileURLToPath(import.meta.url)), '../../docs/theorems.md'),
    'utf8',
  );
  const all = (part) =>
    part.is === 'list'
      ? part.items.flat().map(all).join(' ')
      : part.is === 'table'
        ? [part.head, ...part.rows].flat().map(words).join(' ')
        : part.is === 'formula'
          ? part.lines.map(words).join(' ')
          : words(part.inside);
  const shown = parse(source).map(all).join(' ');
  // Letters and digits in their order, whatever marks stood between them; targets of links and
  // rules of tables are no words.
  const letters = (it) => it.replace(/[^\p{L}\p{N}]+/gu, '');
  const plain = source
    .replace(/\]\([^)]*\)/g, ']')
    .replace(/^(\d+)\. /gm, '')
    .replace(/^( *)(\d+)\. /gm, '');
  assert.equal(letters(shown), letters(plain));
  assert.ok(!/\*\*|_\{/.test(shown), /.{20}(\*\*|_\{).{20}/.exec(shown)?.[0]);
});

test('ranges', () => {
  assert.deepEqual(readRange('3..12'), { from: 3, to: 12 });
  assert.deepEqual(readRange('5'), { from: 5, to: 5 });
  assert.deepEqual(readRange('..40'), { from: 0, to: 40 });
  assert.deepEqual(readRange('7–9'), { from: 7, to: 9 });
  for (const wrong of ['', '..', 'a', '9..3', '1..2..3', '-4x']) {
    assert.equal(readRange(wrong), null, wrong);
  }
});

test('the look-up box understands cells, labels and designs', () => {
  const to = (typed) => understand(typed, 2, 'circular').to;
  const cell = '#/cell?v=20&k=5&change=2&kind=circular';
  for (const typed of [
    '20 5',
    '20,5',
    ' (20, 5) ',
    '20;5',
    'v=20 k=5',
    'k = 5, v = 20',
    'DCCD(20,5)',
    'circular double-change (20,5)',
    '20.5.2.circular',
    '20x5',
    '20 × 5',
    '20.5.2',
    '20.5',
    '20 5 29',
  ]) {
    assert.equal(to(typed), cell, typed);
  }
  assert.equal(to('88 blocks'), '#/catalog?change=2&kind=circular&blocks=88');
  assert.equal(to('20 5 1 linear'), '#/cell?v=20&k=5&change=1&kind=linear');
  assert.equal(to('SCCD(20,5)'), '#/cell?v=20&k=5&change=1&kind=circular');
  assert.equal(to('v=20 k=5 m=3'), '#/cell?v=20&k=5&change=3&kind=circular');
  assert.equal(to('6.4.1.linear.t3'), '#/cell?v=6&k=4&change=1&kind=linear&strength=3');
  assert.equal(to('20.5.2.circular.29.17482f88'), '#/design?label=20.5.2.circular.29.17482f88');
  assert.equal(to('20.5.2.circular.29'), '#/design?label=20.5.2.circular.29');
  assert.equal(to('0 1 2\n1 2 3'), '#/verify?pasted=1');
  assert.equal(understand('{"v":3}', 2, 'linear').paste, '{"v":3}');
  assert.equal(understand('0 1 2; 1 2 3 ;0 1 3', 2, 'linear').paste, '0 1 2\n1 2 3\n0 1 3');
  for (const wrong of ['', '20', 'hello', '20 5 6 7', '20 5 kangaroo']) {
    assert.ok('problem' in understand(wrong, 2, 'linear'), wrong);
  }
  assert.equal(understand('220ffAED', 2, 'linear').checksum, '220ffaed');
  assert.equal(understand('a'.repeat(64), 2, 'linear').checksum, 'aaaaaaaa');
  assert.match(understand('5 23', 2, 'linear').problem, /write v first, as 23 5\.$/);
  assert.match(understand('-3 5', 2, 'linear').problem, /without a sign/);
  assert.match(understand('0 0', 2, 'linear').problem, /v = 0, k = 0: both .* from 1 on/);
  assert.equal(to('5 5'), '#/cell?v=5&k=5&change=2&kind=circular');
});

test('messages about a job name the fields of the form', () => {
  assert.equal(
    inWords('give at_once, how many parts fit at once: Sensor is in no slot'),
    'Sensor has no slot, so say how many parts fit at once, or give it a slot.',
  );
  assert.equal(inWords('give at_once, how many parts fit at once'), 'write “How many fit at once”');
  assert.equal(inWords('parts[2]: no name'), 'Parts, row 3: no name');
  assert.equal(inWords('other: as it is'), 'other: as it is');
});

test('what is not known is sorted behind the rest', () => {
  assert.deepEqual([3, null, 1].sort(compare), [1, 3, null]);
  assert.deepEqual(['b', null, 'a'].sort(compare), ['a', 'b', null]);
});

/** Pairs together in one of the first n blocks, counted anew. */
function pairsOf(blocks) {
  const met = new Set();
  for (const block of blocks) {
    for (const x of block) {
      for (const y of block) {
        if (x < y) {
          met.add(`${x} ${y}`);
        }
      }
    }
  }
  return met.size;
}

test('steps: slots, who enters and leaves, pairs', () => {
  const blocks = [];
  // 300 blocks of 4 over 30 elements, so that several kept slots are used.
  let state = 12345;
  const random = (n) => (state = (state * 1103515245 + 12345) % 2147483648) % n;
  let block = [0, 1, 2, 3];
  for (let i = 0; i < 300; ++i) {
    blocks.push([...block]);
    const out = random(4);
    let next = random(30);
    while (block.includes(next)) {
      next = (next + 1) % 30;
    }
    block = block.map((each, j) => (j === out ? next : each)).sort(() => random(3) - 1);
  }
  const steps = Steps.of({ v: 30, blocks });
  let before = null;
  for (let n = 1; n <= 300; ++n) {
    const { slots, entered, left } = steps.step(n);
    assert.deepEqual(
      [...slots].sort((a, b) => a - b),
      [...blocks[n - 1]].sort((a, b) => a - b),
    );
    if (before) {
      assert.equal(entered.length, 1);
      assert.equal(left.length, 1);
      const moved = [...slots].filter((each, i) => each !== before[i]);
      assert.deepEqual(moved, entered, 'who stays keeps the slot');
    }
    before = [...slots];
    assert.equal(steps.pairs[n], pairsOf(blocks.slice(0, n)));
  }
  assert.equal(steps.first[blocks[0][0] * 30 + blocks[0][1]], 1);
});

test('steps: names, many elements, lists that are no designs', async () => {
  const placed = Steps.of({
    v: 3,
    labels: ['ann', 'bob', 'cy'],
    blocks: [
      [0, 1],
      [1, 2],
    ],
  });
  assert.deepEqual([placed.v, ...placed.names], [3, 'ann', 'bob', 'cy']);
  assert.deepEqual([...placed.block(2)], [1, 2]);
  const wrong = Steps.of({
    v: 6,
    blocks: [
      [0, 1, 2],
      [0, 1, 2],
      [3, 4, 5],
    ],
  });
  assert.deepEqual(wrong.step(2).left, []);
  assert.equal(wrong.step(3).entered.length, 3);
  const many = Steps.of({ v: 1000, blocks: Array.from({ length: 999 }, (_, i) => [i, i + 1]) });
  const leaving = new AbortController();
  const shares = [];
  const later = await Steps.soon(
    {
      v: 3000,
      blocks: Array.from({ length: 200000 }, (_, i) => [i % 3000, (i + 1) % 3000, (i + 2) % 3000]),
    },
    leaving.signal,
    (share) => shares.push(share),
  );
  assert.equal(later.pairs[200000], 6000);
  assert.ok(shares.every((share, i) => share >= (shares[i - 1] ?? 0) && share <= 1));
  assert.equal(many.first, null);
  assert.equal(many.pairs[999], 999);
});

test('files that a page makes itself', () => {
  const design = {
    v: 3,
    k: 2,
    change: 1,
    kind: 'linear',
    blocks: [
      [0, 1],
      [1, 2],
    ],
  };
  assert.equal(asText(design), '# changeover design v=3 k=2 change=1 kind=linear\n0 1\n1 2\n');
  assert.equal(
    asText({ ...design, labels: ['a', 'b', 'c'] }),
    '# changeover design v=3 k=2 change=1 kind=linear\n# labels: a b c\na b\nb c\n',
  );
  assert.equal(
    asCsv({ ...design, labels: ['a,b', 'c', 'd'] }),
    'block,element_1,element_2,v,change,kind\n1,"a,b",c,3,1,linear\n2,c,d,3,1,linear\n',
  );
});

test('lists as people write them', async () => {
  const { cells, lineOf, namesIn, wantedPairs, emptyJob, partOf } = await load('pages/plan/job.ts');
  const read = (text) =>
    cells(text)
      .map((row) => row.join('='))
      .join(' ');
  for (const [text, rows] of [
    ['a\nb', 'a b'],
    ['a,1\rb,2\r', 'a=1 b=2'],
    ['"#1 pump",5\n# a comment\nb,2', '#1 pump=5 b=2'],
    ['"a\tb",5\nc,\t6', 'a\tb=5 c=6'],
    ['"b ""c"" d";2', 'b "c" d=2'],
    ['# hot; cold\na,1\n', 'a=1'],
  ]) {
    assert.equal(read(text), rows, JSON.stringify(text));
  }
  assert.throws(() => read('"a,1\nb,2'), /a quotation mark opens a field that does not end/);
  assert.deepEqual(namesIn('Frame, "Pump, large"\nMotor'), ['Frame', 'Pump, large', 'Motor']);
  for (const names of [
    ['a', 'b'],
    ['a, b', 'c'],
    ['"x"', '#1'],
    [' a ', 'b'],
  ]) {
    assert.deepEqual(
      cells(lineOf(names))[0].map((name) => name.trim()),
      names.map((name) => name.trim()),
    );
  }
  const job = {
    ...emptyJob(),
    parts: ['a', 'b', 'c'].map((name) => partOf(name)),
    pairMode: 'only',
  };
  assert.equal(wantedPairs({ ...job, pairs: 'a,b\nb,c' }).length, 2);
  assert.throws(() => wantedPairs({ ...job, pairs: 'a,b,c' }), /third field/);
  assert.throws(() => wantedPairs({ ...job, pairs: 'a,b,2.5' }), /third field/);
});

test(
  'a job becomes a document and comes back; a link holds it whole, and a link of strangers ' +
    'is refused',
  async () => {
    const { requestOf, jobOf, keyIn, inWords } = await load('pages/plan/document.ts');
    const { emptyJob, emptyBench, partOf } = await load('pages/plan/job.ts');
    const { packed, unpacked } = await load('pages/plan/store.ts');
    const job = {
      ...emptyJob(),
      title: 'Week',
      parts: [
        partOf('A', 3, 'CPU', 2),
        partOf('B, large', null, 'CPU'),
        { ...partOf('C', 1), gone: true },
        partOf('D'),
      ],
      atOnce: 3,
      testCost: 12.5,
      unit: 'minutes',
      slots: [{ name: 'CPU', least: '1', most: '' }],
      never: '"B, large", D, too hot',
      mounted: 'D',
      start: 'A, "B, large"',
      budget: '600',
      benches: [
        { ...emptyBench(), name: 'North', hours: '8', down: true },
        { ...emptyBench(), name: 'South', without: 'A' },
      ],
      objective: 'cost',
      seconds: 5,
    };
    const request = requestOf(job);
    assert.deepEqual(request.parts[0], { name: 'A', cost: 3, slot: 'CPU', quantity: 2 });
    assert.deepEqual(request.parts[1], { name: 'B, large', cost: 1, slot: 'CPU', quantity: 1 });
    assert.deepEqual(
      [request.without, request.mounted, request.start],
      [['C'], ['D'], ['A', 'B, large']],
    );
    assert.deepEqual(request.benches, [
      { name: 'North', hours: '8', down: true },
      { name: 'South', without: 'A' },
    ]);
    assert.deepEqual(
      [request.budget, request.objective, request.seconds, request.cost_unit],
      ['600', 'cost', 5, 'minutes'],
    );
    assert.ok(!('pairs' in request) && !('strength' in request) && !('weights' in request));
    const back = jobOf(request, emptyJob());
    assert.deepEqual(requestOf({ ...back, seconds: 5 }), request);
    assert.deepEqual(request.never, [['B, large', 'D', 'too hot']]);
    assert.deepEqual(requestOf({ ...job, never: 'Part A\tPart B\tWhy\nA\tD\thot' }).never, [
      ['A', 'D', 'hot'],
    ]);
    const ofModel = {
      ...emptyJob(),
      source: 'model',
      model: 'A: x, y\nB: 1, 2\n',
      objective: 'tests',
    };
    const model = requestOf(ofModel);
    assert.deepEqual(
      [model.model, model.objective, model.benches, model.parts],
      ['A: x, y\nB: 1, 2\n', 'tests', undefined, undefined],
    );
    // The fewest tests may be wanted on several benches, too.
    const onBenches = requestOf({ ...ofModel, benches: job.benches });
    assert.deepEqual([onBenches.objective, onBenches.benches], ['tests', request.benches]);
    assert.throws(() => requestOf(emptyJob()), /fewer than two parts/);
    assert.equal(keyIn('never[1]: “X” is no part'), 'never');
    assert.equal(inWords('never[1]: “X” is no part'), 'Forbidden pairs, row 2: “X” is no part');
    assert.equal(keyIn('The server does not answer.'), null);

    const state = { id: 'abc', job, outcome: null };
    assert.deepEqual(unpacked(JSON.parse(JSON.stringify(packed(state)))), state);
    for (const bad of [
      null,
      [],
      {},
      { id: '../x', job: {} },
      { id: 'a', job: { parts: [[1]] }, outcome: null },
      { id: 'a', job: { title: 7 }, outcome: null },
      { id: 'a', job: { source: 'other' }, outcome: null },
      { id: 'a', job: { surprise: 1 }, outcome: null },
      { id: 'a', job: {}, outcome: { tests: [] } },
    ]) {
      assert.equal(unpacked(bad), null, JSON.stringify(bad));
    }
  },
);

test('sheets: what is taken out, what results say, the CSV for the planner', async () => {
  const { csv, isDone, namesOf, outcomeOf, step, verdictOf } = await load('pages/plan/outcome.ts');
  const { emptyJob, partOf } = await load('pages/plan/job.ts');
  const { packed, unpacked } = await load('pages/plan/store.ts');
  for (const [result, verdict] of [
    ['pass', 'pass'],
    ['PASSED', 'pass'],
    ['ok', 'pass'],
    ['FAILED - hang', 'fail'],
    ['fail', 'fail'],
    ['done', 'done'],
    ['not run', 'not run'],
    ['no power', 'fail'],
    ['maybe', 'other'],
    ['', ''],
  ]) {
    assert.equal(verdictOf({ result }), verdict, result);
  }
  const stepOf = (parts, places, cost) => ({ set_up: parts, places, cost });
  const plan = {
    tests: 2,
    changes: 3,
    cost: 7,
    triples_needed: 0,
    pairs_needed: 3,
    pairs_tested: 3,
    lower_bound: { cost: 7, reason: 'r' },
    budget: null,
    cost_unit: null,
    start: [],
    notes: [],
    candidates: [],
    places: [
      { number: 1, slot: 'CPU' },
      { number: 2, slot: null },
    ],
    steps: [stepOf(['a', 'b'], ['a', 'b'], 4), stepOf(['a', '=c'], ['a', '=c'], 3)],
  };
  const job = { ...emptyJob(), parts: ['a', 'b', '=c'].map((name) => partOf(name)) };
  const outcome = outcomeOf({ plan }, job, [], []);
  assert.deepEqual(namesOf(outcome), ['1', '2']);
  assert.deepEqual(step({ ...outcome, start: ['b'] }, 0), { out: [], in: ['a'] });
  assert.deepEqual(step(outcome, 1), { out: ['b'], in: ['=c'] });
  outcome.tests[0].result = 'pass';
  outcome.tests[0].notes = 'fine, so far';
  assert.equal(
    csv(outcome),
    'step,take_out,put_in,slot_1 CPU,slot_2,cost,cost_so_far,result,notes\n1,,"a, ' +
      'b",a,b,4,4,pass,"fine, so far"\n2,b,\'=c,a,\'=c,3,7,,\n',
  );
  const state = { id: 'a', job, outcome };
  assert.deepEqual(unpacked(JSON.parse(JSON.stringify(packed(state)))), state);
  const small = JSON.parse(JSON.stringify(packed(state)));
  small.outcome.tests[0][0] = [99];
  assert.equal(unpacked(small), null);
  const later = outcomeOf(
    {
      plan: {
        ...plan,
        places: [
          { number: 2, slot: null },
          { number: 1, slot: 'CPU' },
        ],
      },
    },
    job,
    outcome.tests.filter(isDone),
    outcome.places,
  );
  assert.deepEqual(later.tests[0].places, ['b', 'a']);
  assert.deepEqual([later.doneBefore, later.tests.length], [1, 3]);
});

test('symmetries: rotations, twins, none', async () => {
  const { symmetryOf, cyclesOf, groupWords } = await load('lib/symmetry.ts');
  const developed = Array.from({ length: 7 }, (_, j) => [0, 1, 3].map((x) => (x + j) % 7));
  const turned = symmetryOf({ v: 7, kind: 'circular', blocks: developed });
  assert.deepEqual([turned.rotations, turned.shift, turned.order], [7, 1, '7']);
  assert.equal(groupWords(turned), 'order 7, 7 rotations');
  developed.forEach((block, i) =>
    assert.deepEqual(block.map((x) => turned.map[x]).sort(), [...developed[(i + 1) % 7]].sort()),
  );
  assert.deepEqual(
    cyclesOf(turned.map).map((cycle) => cycle.length),
    [7],
  );
  const linear = symmetryOf({ v: 7, kind: 'linear', blocks: developed });
  assert.deepEqual([linear.rotations, linear.order], [1, '1']);
  const twins = symmetryOf({
    v: 6,
    kind: 'circular',
    blocks: [
      [0, 1, 2, 3],
      [0, 1, 4, 5],
      [2, 3, 4, 5],
    ],
  });
  assert.equal(twins.order, '24');
  assert.equal(groupWords(twins), 'order 24, 3 rotations');
  const large = { ...twins, rotations: 1, order: '1307674368000000' };
  assert.equal(groupWords(large), 'order about 10^15');
  assert.equal(twins.twins.length, 3);
});

test('tight and economical in numbers', async () => {
  const { counted } = await load('lib/atlas.ts');
  const of = (v, k, change, kind, b, strength = 2) => counted({ v, k, change, kind, b, strength });
  assert.deepEqual(of(12, 4, 1, 'linear', 21), { tight: true, economical: true });
  assert.deepEqual(of(20, 5, 2, 'circular', 29), { tight: false, economical: false });
  assert.deepEqual(of(61, 4, 2, 'circular', 366), { tight: true, economical: true });
  assert.deepEqual(of(6, 4, 1, 'linear', 7, 3), { tight: false, economical: true });
});

test('stays: when elements are there, and together', async () => {
  const { Stays } = await load('parts/stays.ts');
  const stays = new Stays({
    v: 4,
    blocks: [
      [0, 1],
      [1, 2],
      [0, 2],
      [0, 3],
      [1, 3],
    ],
  });
  assert.deepEqual(stays.of(0), [
    [1, 1],
    [3, 4],
  ]);
  assert.deepEqual(stays.at(0, 4), [3, 4]);
  assert.equal(stays.at(0, 2), null);
  assert.deepEqual(stays.shared(1, 3), [[5, 5]]);
  assert.deepEqual(stays.shared(1, 0), [[1, 1]]);
});

test('a repair is shown as what stays, goes and comes', async () => {
  const { compared } = await load('pages/verify/repair.ts');
  const signs = compared(
    [
      [1, 2],
      [3, 4],
      [5, 6],
    ],
    [
      [2, 1],
      [3, 5],
      [5, 6],
      [6, 7],
    ],
  ).map(({ sign, block }) => `${sign}${block}`);
  assert.deepEqual(signs, ['2,1', '−3,4', '+3,5', '5,6', '+6,7']);
});

test('the glossary of the pages is that of docs/glossary.md', async () => {
  const { glossary } = await load('lib/terms.ts');
  const page = readFileSync(
    join(dirname(fileURLToPath(import.meta.url)), '../../docs/glossary.md'),
    'utf8',
  );
  const rows = page
    .split('\n')
    .filter((line) => line.startsWith('| ') && line !== '| term | meaning |');
  assert.deepEqual(
    rows,
    glossary.map(([term, meaning]) => `| ${term} | ${meaning} |`),
  );
  assert.ok(glossary.length > 20);
});

test('a small part is not none, and nearly all is not all', async () => {
  const { percent } = await load('lib/words.ts');
  for (const [part, all, said] of [
    [0, 12720, '0 %'],
    [6, 12720, '< 1 %'],
    [128, 12720, '1 %'],
    [12719, 12720, '99 %'],
    [12720, 12720, '100 %'],
    [0, 0, '100 %'],
  ]) {
    assert.equal(percent(part, all), said);
  }
});
