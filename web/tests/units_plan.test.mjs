// The sheet of a plan after a test was added to it.
//
//     node --test tests/units_plan.test.mjs
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './support/source.mjs';

const slots = ['OS', 'Browser', 'Locale'];
const places = slots.map((slot, i) => ({ number: i + 1, slot }));

function rowOf(parts, cost) {
  const values = Object.fromEntries(slots.map((slot, i) => [slot, parts[i]]));
  return { set_up: parts, places: parts, values, cost };
}

const steps = [
  rowOf(['Mac', 'Edge', 'en'], 6),
  rowOf(['Mac', 'Firefox', 'en'], 4),
  rowOf(['Linux', 'Firefox', 'en'], 4),
  rowOf(['Linux', 'Edge', 'de'], 5),
];
const size = { tests: 4, changes: 7, cost: 19, triples_needed: 0 };
const rest = {
  pairs_needed: 9,
  pairs_tested: 9,
  cost_unit: null,
  notes: [],
  candidates: [],
  places,
  budget: null,
};
const next = {
  set_up: ['Linux', 'Edge', 'en'],
  put_in: ['Linux'],
  cost: 4,
  places: ['Linux', 'Edge', 'en'].map((part, i) => ({ number: i + 1, part })),
};

test('a test added to the sheet of a model has its columns, and costs follow', async () => {
  const { csv, outcomeOf } = await load('pages/plan/outcome.ts');
  const { partWords, withNext } = await load('pages/plan/insertion.ts');
  const { emptyJob } = await load('pages/plan/job.ts');
  const job = { ...emptyJob(), source: 'model', testCost: 3, changeCost: 1 };
  const plan = { ...size, ...rest, start: [], steps, lower_bound: { cost: 19, reason: 'r' } };
  const outcome = outcomeOf({ plan }, job, [], []);
  outcome.tests[0].result = 'fail';
  const added = withNext(outcome, next, job);
  assert.equal(
    csv(added),
    'step,OS,Browser,Locale,cost,cost_so_far,result,notes\n1,Mac,Edge,en,6,6,fail,\n' +
      '2,Linux,Edge,en,4,10,,\n3,Mac,Firefox,en,5,15,,\n4,Linux,Firefox,en,4,19,,\n' +
      '5,Linux,Edge,de,5,24,,\n',
  );
  assert.deepEqual([added.cost, added.together, added.changes], [24, 24, 9]);
  assert.equal(outcome.tests.length, 4);
  const words = partWords(outcome);
  assert.deepEqual(['Linux', 'Fan'].map(words), ['OS = Linux', 'part Fan']);
});

test('on a bench of its own costs, and where hours were planned', async () => {
  const { outcomeOf } = await load('pages/plan/outcome.ts');
  const { withNext } = await load('pages/plan/insertion.ts');
  const { emptyBench, emptyJob } = await load('pages/plan/job.ts');
  const benches = [
    { ...emptyBench(), name: 'A', testCost: '10', changeFactor: '2' },
    { ...emptyBench(), name: 'B' },
  ];
  const job = { ...emptyJob(), source: 'model', testCost: 3, changeCost: 1, benches };
  const timed = steps.slice(0, 2).map((each, i) => ({ ...each, day: 1, hour: 9 + i }));
  const plan = {
    ...size,
    ...rest,
    objective: 'makespan',
    makespan: 10,
    finish: null,
    lower_bound: { cost: 19, makespan: 9, makespan_reason: 'r', cost_reason: 'r' },
    sheets: [
      { name: 'A', down: false, end: 10, start: [], hours: 8, steps: timed },
      { name: 'B', down: false, end: 9, start: [], hours: null, steps: steps.slice(2) },
    ],
  };
  const outcome = outcomeOf({ benches: plan }, job, [], []);
  outcome.tests[0].result = 'fail';
  const added = withNext(outcome, next, job);
  assert.deepEqual(
    added.tests.map(({ bench, cost, when }) => [bench, cost, when]),
    [
      ['A', 6, 'day 1, 9:00'],
      ['A', 4, undefined],
      ['A', 14, undefined],
      ['B', 4, undefined],
      ['B', 5, undefined],
    ],
  );
  assert.deepEqual([added.benches[0].end, added.cost, added.together], [24, 24, 33]);
  assert.equal(added.notes.length, 1);
});

test('why not less, in lines', async () => {
  const { linesOf } = await load('pages/plan/reason_lines.ts');
  const numbers =
    'at least 7 tests (the parts are in at least 27 set-ups in all, 4 in each), at least 15 ' +
    'changes (one change at a time takes 12 blocks: SCCD(9,4)), and j changes of 4 bring at most ' +
    'C(j,2) + j(4-j) new pairs: 7 tests with 16 changes cost least';
  const lines = [
    ['At least 7 tests', 'the parts are in at least 27 set-ups in all, 4 in each'],
    [
      'At least 15 changes',
      'with one change at a time it takes 12 tests, as in the design SCCD(9,4): 4 parts for the ' +
        'first test and 11 changes after it',
    ],
    [
      'Together at least 155.00',
      'j changes of 4 bring at most C(j,2) + j(4-j) new pairs: 7 tests with 16 changes cost least',
    ],
  ];
  const said = (reason) => linesOf(reason, '155.00').map(({ said, why }) => [said, why]);
  assert.deepEqual(said(numbers), lines);
  assert.deepEqual(
    said(
      'of all lists, looked through from the cheapest on in 400006 states, none costs less; ' +
        `without that, ${numbers}`,
    ).at(-1),
    ['Together at least 155.00', 'all cheaper lists were tried (400 006 states)'],
  );
  const each = 'each value that is set takes the place of another';
  assert.deepEqual(said(`${each}: ${numbers}`), [['', each], ...lines]);
  assert.deepEqual(said('nothing is left to test'), [['', 'nothing is left to test']]);
});

test('what is mounted first, as a job and a plan say it; a failed test that comes again', async () => {
  const { outcomeOf, repeats, step } = await load('pages/plan/outcome.ts');
  const { emptyBench, emptyJob } = await load('pages/plan/job.ts');
  const benches = [{ ...emptyBench(), name: 'A', start: 'Mac, Edge' }];
  const job = { ...emptyJob(), benches };
  const sheet = { name: 'A', down: false, end: 10, hours: null, steps };
  const plan = {
    ...size,
    ...rest,
    objective: 'cost',
    lower_bound: { cost: 19, makespan: 9, makespan_reason: 'r', cost_reason: 'r' },
  };
  const before = { ...plan, sheets: [{ ...sheet, start: ['Mac', 'Edge'] }] };
  const first = outcomeOf({ benches: before }, job, [], places);
  assert.deepEqual(step(first, 0), { out: [], in: ['en'] });
  // A replanned sheet begins where the last test left it; the first of all began where the job says.
  const done = [{ ...first.tests[0], result: 'fail' }];
  const after = { ...plan, sheets: [{ ...sheet, start: steps[0].set_up }] };
  const again = outcomeOf({ benches: after }, job, done, places);
  assert.deepEqual(step(again, 0), { out: [], in: ['en'] });
  assert.deepEqual(step(again, 1), { out: [], in: [] });
  assert.equal(repeats(again, 1), 'repeats failed A, test 1');
  assert.equal(repeats(again, 2), '');
});

test('how long a bench waits, by the longest day of the benches that work', async () => {
  const { idleOf } = await load('pages/plan/strip.ts');
  const bench = (name, hours, down = false) => ({ name, hours, down, end: 0, start: [] });
  const of = (benches, spans, unit = null) => {
    const tests = spans.map((span) => ({ bench: 'A', cost: span[1] - span[0], span }));
    return idleOf({ benches, unit, tests }, 'A');
  };
  const nextDay = [
    [0, 4],
    [4, 8],
    [24, 28],
  ];
  // A bench without hours works day and night.
  assert.equal(of([bench('A', 8), bench('B', null)], nextDay), 0);
  assert.equal(of([bench('A', 8), bench('B', 10)], [...nextDay.slice(0, 2), [10, 14]]), 0);
  const minutes = nextDay.map((span) => span.map((at) => 60 * at));
  assert.equal(of([bench('A', 8), bench('B', 24)], minutes, 'minutes'), 0);
  // One that is out of order has no day.
  const gap = [
    [0, 4],
    [12, 16],
  ];
  assert.equal(of([bench('A', 8), bench('B', 8), bench('C', 24, true)], gap), 8);
  assert.equal(of([bench('A', null), bench('C', 8, true)], gap), 8);
});

test('after a replan the clock starts again: tests that are done are in no lane', async () => {
  const { outcomeOf } = await load('pages/plan/outcome.ts');
  const { idleOf } = await load('pages/plan/strip.ts');
  const { packed, unpacked } = await load('pages/plan/store.ts');
  const { emptyBench, emptyJob } = await load('pages/plan/job.ts');
  const job = { ...emptyJob(), benches: [{ ...emptyBench(), name: 'A' }] };
  const timed = [
    { ...steps[1], begin: 0, end: 4 },
    { ...steps[2], begin: 6, end: 10 },
  ];
  const plan = {
    ...size,
    ...rest,
    objective: 'makespan',
    makespan: 10,
    finish: null,
    lower_bound: { cost: 19, makespan: 9, makespan_reason: 'r', cost_reason: 'r' },
    sheets: [{ name: 'A', down: false, end: 10, start: [], hours: null, steps: timed }],
  };
  const times = { when: 'day 1, 0:00', ends: 'day 1, 6:00', span: [0, 6] };
  const written = { result: 'pass', notes: '', by: '', at: '' };
  const [{ set_up: parts, cost }] = steps;
  const done = { bench: 'A', parts, places: parts, cost, ...times, ...written };
  const outcome = outcomeOf({ benches: plan }, job, [done], places);
  assert.deepEqual(
    outcome.tests.map(({ span, when, ends }) => [span, when, ends]),
    [undefined, [0, 4], [6, 10]].map((span) => [span, undefined, undefined]),
  );
  assert.equal(idleOf(outcome, 'A'), 2);
  // A link keeps it so.
  const state = { id: 'a', job, outcome };
  const kept = unpacked(JSON.parse(JSON.stringify(packed(state)))).outcome.tests;
  assert.deepEqual(
    kept.map(({ span, ends }) => [span, ends]),
    outcome.tests.map(({ span, ends }) => [span, ends]),
  );
  // What stands on the page as words is words.
  const soonest = (value) =>
    unpacked(packed({ ...state, outcome: { ...outcome, soonest: value } }));
  assert.equal(soonest('day 1, 9:00').outcome.soonest, 'day 1, 9:00');
  assert.equal(soonest({}), null);
});

test('times of a day are hours and minutes, whatever the unit of costs, and long tests end later', async () => {
  const { outcomeOf } = await load('pages/plan/outcome.ts');
  const { emptyBench, emptyJob } = await load('pages/plan/job.ts');
  const job = { ...emptyJob(), benches: [{ ...emptyBench(), name: 'A' }] };
  // Eight hours a day; the first test takes ten.
  const of = (cost_unit, hour) => {
    const timed = { begin: 0, end: 10 * hour, day: 1, hour: 0, finish: { day: 2, hour: 2 * hour } };
    const finish = { day: 2, hour: 2.5 * hour, date: '2025-04-01' };
    const plan = {
      ...size,
      ...rest,
      cost_unit,
      objective: 'makespan',
      makespan: 10 * hour,
      finish,
      lower_bound: { cost: 0, makespan: 0, makespan_reason: '', cost_reason: '', finish },
      sheets: [
        {
          name: 'A',
          down: false,
          end: 10 * hour,
          start: [],
          hours: 8,
          steps: [{ ...steps[0], ...timed }],
        },
      ],
    };
    const outcome = outcomeOf({ benches: plan }, job, [], places);
    const [{ when, ends }] = outcome.tests;
    return [when, ends, outcome.finish, outcome.soonest];
  };
  const said = ['day 1, 0:00', 'day 2, 2:00', '2025-04-01, 2:30', '2025-04-01, 2:30'];
  assert.deepEqual(of(null, 1), said);
  assert.deepEqual(of('hours', 1), said);
  assert.deepEqual(of('minutes', 60), said);
  assert.deepEqual(of('seconds', 3600), said);
});

test('times of a plan as people say them: when days begin, and dates', async () => {
  const { timeWords } = await load('pages/plan/times.ts');
  const said = (begins, ...times) => times.map((time) => timeWords(time, begins));
  assert.deepEqual(said('08:00', 'day 1, 0:00', 'day 2, 5:15'), ['day 1, 8:00', 'day 2, 13:15']);
  assert.deepEqual(said('', 'day 1, 2:15'), ['day 1, after\u00a02:15\u00a0h']);
  assert.deepEqual(said('08:30', '2026-12-04, 5:00'), ['Fri 4 Dec, 13:30']);
  // Of a bench that works day and night.
  assert.deepEqual(said('08:00', 'day 1, 16:00', 'day 1, 20:00', '2026-12-31, 17:05'), [
    'day 1, 24:00',
    'day 2, 4:00',
    'Fri 1 Jan, 1:05',
  ]);
  assert.deepEqual(said('00:00', 'day 3, 0:00'), ['day 3, 0:00']);
  assert.deepEqual(said('08:00', '37 hours'), ['37 hours']);
});

test('parts that two benches have at one time, where nobody said how many there are', async () => {
  const { piecesInWords, severalOf } = await load('pages/plan/shared.ts');
  const { emptyBench, emptyJob, partOf } = await load('pages/plan/job.ts');
  const tests = [
    ['A', 'Fan Pump', [0, 2]],
    ['A', 'Fan Motor', [2, 4]],
    ['A', 'Pump Motor', [4, 6]],
    ['B', 'Motor Valve', [0, 2]],
    ['B', 'Fan Valve', [3, 5]],
    ['C', 'Fan Valve', [3, 4]],
  ].map(([bench, parts, span]) => ({ bench, parts: parts.split(' '), span }));
  const parts = ['Fan', 'Pump', 'Motor', 'Valve'].map((name) => partOf(name));
  const benches = [{ ...emptyBench(), name: 'C' }];
  const of = (job) => severalOf({ ...emptyJob(), parts, benches, ...job }, { benches, tests });
  // The motor leaves B when it comes to A.
  const several = of({});
  assert.deepEqual(several, [
    ['Fan', 3],
    ['Valve', 2],
  ]);
  assert.equal(piecesInWords(several), 'three of Fan; two of Valve');
  assert.deepEqual(of({ benches: [{ ...benches[0], own: 'Valve, Fan' }] }), [['Fan', 2]]);
  assert.deepEqual(of({ parts: [partOf('Fan', null, '', 1), ...parts.slice(1)] }), []);
});

test('tests that were passed over are named', async () => {
  const { skippedWords } = await load('pages/plan/skipped.ts');
  const of = (...results) =>
    skippedWords({ tests: results.map((result) => ({ bench: null, result, parts: [] })) });
  assert.equal(of('pass', '', ''), '');
  assert.match(of('', 'fail', ''), /^Test 1 has no result, but a later test has one\. Was it /);
  assert.match(of('', '', 'pass'), /^Test 1; test 2 have no result/);
  assert.equal(of('not run', 'pass'), '');
});

test('why two parts never meet, after a comma, a colon or in brackets', async () => {
  const { neverRows } = await load('pages/plan/document.ts');
  const { emptyJob, partOf } = await load('pages/plan/job.ts');
  const parts = ['Boiler S', 'Boiler L', 'Hose: long', 'Cap (red)'].map((name) => partOf(name));
  const of = (never, more = {}) => neverRows({ ...emptyJob(), parts, never, ...more });
  assert.deepEqual(of('Boiler S, Boiler L: one at a time'), [
    ['Boiler S', 'Boiler L', 'one at a time'],
  ]);
  assert.deepEqual(of('Boiler S, Boiler L (one, at a time)'), [
    ['Boiler S', 'Boiler L', 'one, at a time'],
  ]);
  assert.deepEqual(of('Boiler S, Hose: long\nBoiler L, Cap (red), hot'), [
    ['Boiler S', 'Hose: long'],
    ['Boiler L', 'Cap (red)', 'hot'],
  ]);
  assert.deepEqual(of('Boiler S, Boiler X: no such'), [['Boiler S', 'Boiler X: no such']]);
  const model = { source: 'model', parts: [], model: 'OS: Mac, Linux\nDisk: c, d' };
  assert.deepEqual(of('Mac, d: never', model), [['Mac', 'd', 'never']]);
});

test('how a list was read, below it, and the unit that its heading names', async () => {
  const { othersOf, readFrom, readWords, unitIn } = await load('pages/plan/document.ts');
  const note = "parts: the first row is a header: names in 'name', change costs in 'hours'";
  assert.equal(
    readWords(note),
    'First row taken as headings: names in “name”, change costs in “hours”.',
  );
  assert.equal(unitIn([note]), 'hours');
  assert.equal(unitIn([note.replace('hours', 'Cost (min)')]), 'minutes');
  assert.equal(unitIn([note.replace('hours', 'change cost')]), null);
  assert.deepEqual(readFrom('a.csv', [note, 'done: more']).length, 2);
  assert.deepEqual(readFrom('a.txt', ['a.txt: the model']), ['Read from a.txt.']);
  assert.deepEqual(othersOf('a.csv', [note, 'done: more', 'a.csv: slots']), ['a.csv: more']);
});

test('the word of a model that is wrong is marked as a whole', async () => {
  const { wordLength } = await load('pages/plan/model_faults.ts');
  const line = 'IF [Browsr] = "Edge 2" THEN OS-x';
  const at = (word) => wordLength(line, line.indexOf(word) + 1);
  assert.deepEqual(['[', '"', 'OS-x', '= '].map(at), [8, 8, 4, 1]);
});

test('who takes a part out for another bench, and where it comes from, is on the sheet', async () => {
  const { csv, outcomeOf, step } = await load('pages/plan/outcome.ts');
  const { fromWords, givesNow, givesWords, outAlready } = await load('pages/plan/handover.ts');
  const { emptyJob } = await load('pages/plan/job.ts');
  const { packed, unpacked } = await load('pages/plan/store.ts');
  const row = (step, set_up, begin, more = {}) => ({
    step,
    set_up,
    places: set_up,
    cost: 3,
    begin,
    end: begin + 3,
    ...more,
  });
  const places = [1, 2].map((number) => ({ number, slot: null }));
  const sheet = (name, steps) => ({ name, down: false, end: 9, start: [], hours: null, steps });
  const plan = {
    ...size,
    ...rest,
    places,
    makespan: 9,
    lower_bound: { makespan: 9, makespan_reason: 'r', cost: 9, cost_reason: 'r', tests: 4 },
    sheets: [
      sheet('A', [row(1, ['Fan', 'Pump'], 0), row(2, ['Valve', 'Pump'], 6)]),
      sheet('B', [row(1, ['Fan', 'Case'], 4, { day: 1, hour: 4 })]),
    ],
    handovers: [{ part: 'Fan', from: 'A', to: 'B', step: 1, early: true, after: 1 }],
  };
  const benches = ['A', 'B'].map((name) => ({ name, start: '' }));
  const job = { ...emptyJob(), benches };
  const kept = unpacked(
    JSON.parse(
      JSON.stringify(
        packed({ id: 'x', job: emptyJob(), outcome: outcomeOf({ benches: plan }, job, [], []) }),
      ),
    ),
  );
  const { outcome } = kept;
  const [first, , receiving] = outcome.tests;
  const time = (planned) => `at ${planned}`;
  const said = 'after this test take out Fan: B needs it for test 1, at day 1, 4:00';
  assert.deepEqual(givesWords(first, time), [said]);
  assert.equal(fromWords(receiving, 'Fan'), 'from A');
  assert.deepEqual([...outAlready(outcome, 1)], ['Fan']);
  assert.deepEqual(givesNow(outcome, 'A', time), [], 'its first test is still to be done');
  first.result = 'pass';
  assert.deepEqual(givesNow(outcome, 'A', time), [said.replace('after this test', 'now')]);
  receiving.result = 'pass';
  assert.deepEqual(givesNow(outcome, 'A', time), [], 'the other bench has had it');
  assert.match(csv(outcome, time), /^bench,step,take_out,put_in,hand_over,slot_1/);
  assert.match(csv(outcome, time), /"after this test take out Fan: B needs/);
  // The last test of A is planned anew: what was to be done before it is said of the one before.
  const later = {
    ...plan,
    sheets: [sheet('A', [row(2, ['Valve', 'Pump'], 6)]), sheet('B', [row(1, ['Fan', 'Case'], 4)])],
    handovers: [{ part: 'Fan', from: 'A', to: 'B', step: 1, early: true, after: null }],
  };
  const again = outcomeOf({ benches: later }, job, [{ ...first, bench: 'A', number: 1 }], places);
  assert.deepEqual(givesWords(again.tests[0], time), [
    'after this test take out Fan: B needs it for test 1',
  ]);
  assert.deepEqual(step({ ...again, tests: [{ ...first, again: ['Fan'] }] }, 0).in, [
    'Fan',
    'Pump',
  ]);
});

test('a test keeps its number when the rest is planned anew', async () => {
  const { csv, keysOf, namesOf, outcomeOf } = await load('pages/plan/outcome.ts');
  const { emptyJob } = await load('pages/plan/job.ts');
  const numbered = steps.map((each, i) => ({ ...each, step: i + 1 }));
  const plan = {
    ...size,
    ...rest,
    start: [],
    steps: numbered,
    lower_bound: { cost: 1, reason: '' },
  };
  const { tests, places: there } = outcomeOf({ plan }, emptyJob(), [], []);
  const done = [0, 2].map((i) => ({ ...tests[i], result: 'pass' }));
  const left = [1, 3].map((i, at) => ({ ...steps[i], step: 4 + at }));
  const outcome = outcomeOf({ plan: { ...plan, steps: left } }, emptyJob(), done, there);
  assert.deepEqual(namesOf(outcome), ['1', '3', '4', '5']);
  assert.deepEqual(keysOf(outcome), ['1', '2', '3', '4']);
  assert.match(csv(outcome), /\n3,Linux,Firefox,en,/);
});

test('the end of a plan as a time of the calendar: days of work, weekends free', async () => {
  const { calendarOf } = await load('pages/plan/times.ts');
  const { emptyBench, emptyJob } = await load('pages/plan/job.ts');
  const benches = ['A', 'B'].map((name) => ({ ...emptyBench(), name }));
  const job = { ...emptyJob(), benches, hours: '7' };
  assert.equal(calendarOf(job)(27), 'day 4, 14:00');
  assert.equal(calendarOf(job)(63), 'day 9, 15:00', 'the end of a day is still of that day');
  assert.equal(calendarOf({ ...job, unit: 'minutes' })(420 + 90), 'day 2, 9:30');
  const friday = { ...job, firstDay: '2026-12-04' };
  assert.equal(calendarOf(friday)(27), 'Wed 9 Dec, 14:00');
  assert.equal(calendarOf({ ...friday, weekends: true })(27), 'Mon 7 Dec, 14:00');
  assert.equal(calendarOf({ ...friday, firstDay: '2026-12-05' })(6), 'Mon 7 Dec, 14:00');
  assert.equal(calendarOf({ ...job, hours: '' }), null);
});

test('an automatic search ends when nothing came for as long as it took to get there', async () => {
  const { Patience } = await load('pages/plan/patience.ts');
  const heard = (ends, ...news) => {
    const patience = new Patience(ends);
    const at = news.findIndex(([seconds, best]) => patience.isOut({ seconds, best }));
    return [at, patience.noted({ notes: [] }).notes];
  };
  const long = [
    [1, null],
    [2, 44],
    [14, 44],
    [17.5, 44],
    [40, 44],
  ];
  assert.deepEqual(heard(true, ...long), [3, ['nothing better came for 15 seconds']]);
  assert.deepEqual(heard(true, [2, 44], [14, 43], [28, 43], [30, 43])[0], 3);
  assert.deepEqual(heard(true, [2, 44], [25, 43], [45, 43])[0], -1);
  assert.deepEqual(heard(false, ...long), [-1, []]);
});
