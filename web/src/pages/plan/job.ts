// What is to be planned, and what was planned: the plain data of the page, and the arithmetic on it.

export interface Part {
  name: string;
  /** What putting it in costs; null: what it costs for all. */
  cost: number | null;
  /** It broke or went away: no later test can have it. */
  gone?: boolean;
}

export type PairMode = 'all' | 'only' | 'skip';

export interface Job {
  title: string;
  parts: Part[];
  atOnce: number;
  testCost: number;
  changeCost: number;
  pairMode: PairMode;
  /** Two names a line, with a comma between. */
  pairs: string;
  /** How long is searched; 0: as long as it brings something. */
  seconds: number;
}

export interface Test {
  parts: string[];
  cost: number;
  done: boolean;
}

/** A way to run the tests, known by its numbers alone. */
export interface Alternative {
  name: string;
  tests: number;
  changes: number;
  /** At the costs that were planned with. */
  cost: number;
}

export interface Outcome {
  tests: Test[];
  /** Of the tests that the last planning was about: those done before are not in it. */
  cost: number;
  bound: number;
  reason: string;
  /** The plan itself is the first. */
  alternatives: Alternative[];
  testCost: number;
  changeCost: number;
  /** How many tests were done when this was planned. */
  doneBefore: number;
}

export interface State {
  id: string;
  job: Job;
  outcome: Outcome | null;
}

export function emptyJob(): Job {
  return { title: 'Run sheet', parts: [], atOnce: 3, testCost: 1, changeCost: 1, pairMode: 'all', pairs: '', seconds: 0 };
}

export const exampleJob: Job = {
  ...emptyJob(),
  title: 'Pump bench',
  parts: [
    ['Gear pump', 6.5],
    ['Vane pump', 7],
    ['Relief valve', 2.5],
    ['Check valve', 1.5],
    ['Filter', 1],
    ['Cooler', 4],
    ['Motor A', 9],
    ['Motor B', 9],
    ['Flow meter', 3],
  ].map(([name, cost]) => ({ name: String(name), cost: Number(cost) })),
  atOnce: 4,
  testCost: 12.5,
  changeCost: 3,
};

/** A decimal with a point or a comma. @throws Error with a line that can be shown. */
export function decimal(text: string, what: string): number {
  const trimmed = text.trim();
  if (/^\d{1,3},\d{3}$/.test(trimmed)) {
    throw new Error(`${what}: “${trimmed}” may be a thousand or one: write it without the comma`);
  }
  if (!/^(\d+([.,]\d{0,6})?|[.,]\d{1,6})$/.test(trimmed)) {
    throw new Error(`${what}: “${trimmed}” is not a cost: write a number such as 12.50`);
  }
  return Number(trimmed.replace(',', '.'));
}

/** Rounded to the millionths that costs have, so that sums of decimals are shown as people add them. */
export function exact(cost: number): number {
  return Math.round(cost * 1e6) / 1e6;
}

/** Writes costs with as many decimals as all of `costs` need: none, or two and more. */
export function moneyOf(costs: readonly number[]): (cost: number) => string {
  const decimals = Math.max(0, ...costs.map((cost) => (String(exact(cost)).split('.')[1] ?? '').length));
  return (cost) => exact(cost).toFixed(decimals === 0 ? 0 : Math.max(2, decimals));
}

/** A cost of a plan that was never made, as prices would make it: to the hundredth, as far as it has any. */
export function about(cost: number): string {
  const rounded = Number(cost.toFixed(2));
  return rounded === 0 && cost !== 0
    ? String(Number(cost.toPrecision(3)))
    : Number.isInteger(rounded)
      ? String(rounded)
      : rounded.toFixed(2);
}

/** Cells of a table as spreadsheets copy it (tabs) or write it (CSV with commas or semicolons, fields quoted or not). */
export function cells(text: string): string[][] {
  const lines = text.replace(/\r\n?/g, '\n').replace(/^\ufeff/, '');
  const bare = lines.replace(/"[^"]*"/g, '').trimStart(); // What is in quotes separates nothing.
  const separator = /^[^\n]*\t/.test(bare) || !/[,;]/.test(bare) ? '\t' : /^[^\n,]*;/m.test(bare) ? ';' : ',';
  const rows: string[][] = [];
  let row: string[] = [];
  let field = '';
  let quoted = false;
  let comment = false; // The row begins with #, and not within quotes.
  const endRow = () => {
    row.push(field.trim());
    field = '';
    if (row.some((each) => each !== '') && !comment) {
      rows.push(row);
    }
    row = [];
    comment = false;
  };
  for (let i = 0; i < lines.length; ++i) {
    const letter = lines[i]!;
    if (quoted) {
      if (letter === '"' && lines[i + 1] === '"') {
        field += '"';
        ++i;
      } else if (letter === '"') {
        quoted = false;
      } else {
        field += letter;
      }
    } else if (letter === '"' && field.trim() === '') {
      quoted = true;
      field = '';
    } else if (letter === separator) {
      row.push(field.trim());
      field = '';
    } else if (letter === '\n') {
      endRow();
    } else {
      comment ||= letter === '#' && row.length === 0 && field.trim() === '';
      field += letter;
    }
  }
  if (quoted) {
    throw new Error('a quotation mark opens a field that does not end: close it with another');
  }
  endRow();
  return rows;
}

/** What headings this page understands, as the command line does; every other column is refused by its name. */
const headings = {
  name: /^(name|part|component|item|device|module)s?$/i,
  cost: /^((change|swap|set-?up|mounting)[ _-]?)?(cost|price)s?$/i,
  slot: /^slots?$/i,
};
/** In a row that is one of headings: more words for costs, whole ones as in the command line: “Europe” is no price in euros. */
const saysCost =
  /(?<!\p{L})(costs?|prices?|pricing|preise?|preises|kosten|aufwand|prix|co[ûu]ts?|precios?|costes?|cost[oi]s?|prezz[oi]|pre[çc]os?|custos?|prijs|prijzen|euros?|eur|usd|gbp|chf|€|£|dollars?|\p{L}{3,}(costs?|prices?|preise?|kosten|aufwand))(?!\p{L})/iu;

/**
 * Parts of a pasted table or a file: a name and, if there is one, a cost; with or without a first row of headings.
 * @throws Error for bytes that are not UTF-8, and for columns that this page does not use: nothing is dropped.
 */
export function partsOf(text: string): Part[] {
  if (text.startsWith('PK\u0003\u0004') || /[\u0000-\u0008\u000e-\u001f\ufffd]/.test(text)) {
    throw new Error('this file is not text: in the spreadsheet, save the list as CSV, or give the file to “changeover plan”');
  }
  const rows = cells(text);
  const numeric = (cell: string | undefined) => /^[\d.,]+$/.test(cell ?? '');
  const first = rows[0] ?? [];
  const heads =
    headings.name.test(first[0] ?? '') ||
    first.some((cell, column) => headings.cost.test(cell) || (column > 0 && headings.slot.test(cell))) ||
    (rows.length > 1 && first.length > 1 && !numeric(first[1]) && first[1] !== '' && numeric(rows[1]![1]));
  const list = heads ? rows.slice(1) : rows;
  const find = (heading: RegExp, otherwise: number) => {
    const found = heads ? first.findIndex((cell) => heading.test(cell)) : -1;
    return found < 0 ? otherwise : found;
  };
  const name = find(headings.name, 0);
  // A column is not read as a cost because of its place where it says something else.
  const cost = find(saysCost, !heads || (name === 0 && first.length === 2 && first[1] === '') ? 1 : -1);
  for (let column = 0; column < Math.max(first.length, ...list.map((row) => row.length)); ++column) {
    if (column !== name && column !== cost && list.some((row) => (row[column] ?? '') !== '')) {
      const which = heads && first[column] ? `the column “${first[column]}”` : `column ${column + 1}`;
      throw new Error(`${which} is not used on this page: take it out of the list, or give the file to “changeover plan”`);
    }
  }
  return list.map((row) => {
    const each = row[name] ?? '';
    const price = row[cost] ?? '';
    return { name: each, cost: price === '' ? null : decimal(price, each) };
  });
}

function listed(job: Job): [string, string][] {
  const names = new Set(job.parts.map(({ name }) => name));
  return cells(job.pairs).map((row, i) => {
    const [one = '', other = '', third] = row.filter((each) => each !== '');
    if (third !== undefined) {
      throw new Error(`pair ${i + 1}: “${third}” is a third field: write two parts with a comma between`);
    }
    for (const name of [one, other]) {
      if (!names.has(name)) {
        throw new Error(`pair ${i + 1}: ${name === '' ? 'write two parts with a comma between' : `“${name}” is not in the list of parts`}`);
      }
    }
    if (one === other) {
      throw new Error(`pair ${i + 1}: “${one}” is there twice`);
    }
    return [one, other];
  });
}

/** The pairs that must meet, or undefined for all of those that are left. */
export function wantedPairs(job: Job): [string, string][] | undefined {
  const gone = new Set(job.parts.filter((part) => part.gone).map(({ name }) => name));
  if (job.pairMode === 'all') {
    return undefined;
  }
  if (job.pairMode === 'only') {
    return listed(job).filter(([one, other]) => !gone.has(one) && !gone.has(other));
  }
  const key = (one: string, other: string) => (one < other ? `${one}\n${other}` : `${other}\n${one}`);
  const skipped = new Set(listed(job).map(([one, other]) => key(one, other)));
  const names = job.parts.map(({ name }) => name).filter((name) => !gone.has(name));
  const pairs: [string, string][] = [];
  names.forEach((one, i) => names.slice(i + 1).forEach((other) => skipped.has(key(one, other)) || pairs.push([one, other])));
  return pairs;
}

/** @throws Error with a line that can be shown, if this job cannot be planned. */
export function checkJob(job: Job): void {
  const left = job.parts.filter((part) => !part.gone);
  if (left.length < 2) {
    throw new Error('There are fewer than two parts: type them, paste them from a spreadsheet, or take the example.');
  }
  const seen = new Set<string>();
  for (const [i, { name }] of job.parts.entries()) {
    if (name === '') {
      throw new Error(`Part ${i + 1} has no name.`);
    }
    if (seen.has(name)) {
      throw new Error(`Part ${i + 1}: “${name}” is in the list twice.`);
    }
    seen.add(name);
  }
  if (!Number.isInteger(job.atOnce) || job.atOnce < 2) {
    throw new Error('At once: at least two parts must fit, or no pair ever meets.');
  }
}

/** What is taken out for a test and what is put in. */
export function step(tests: readonly Test[], i: number): { out: string[]; in: string[] } {
  const before = i === 0 ? [] : tests[i - 1]!.parts;
  const now = tests[i]!.parts;
  return { out: before.filter((name) => !now.includes(name)), in: now.filter((name) => !before.includes(name)) };
}

/** The run sheet as CSV with the columns of the command line, which reads it back as `--done`. */
export function csv(outcome: Outcome): string {
  const most = Math.max(...outcome.tests.map(({ parts }) => parts.length));
  // A spreadsheet would compute what begins like a formula.
  const safe = (name: string) => (/^[=+\-@\t]/.test(name) ? `'${name}` : name);
  const quote = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const slots = Array.from({ length: most }, (_, i) => `slot_${i + 1}`);
  let sum = 0;
  const rows = outcome.tests.map((test, i) => {
    const { out, in: put } = step(outcome.tests, i);
    sum = exact(sum + test.cost);
    return [
      String(i + 1),
      safe(out.join(', ')),
      safe(put.join(', ')),
      ...slots.map((_, j) => safe(test.parts[j] ?? '')),
      String(test.cost),
      String(sum),
      test.done ? 'done' : '',
    ];
  });
  return (
    [['step', 'take_out', 'put_in', ...slots, 'cost', 'cost_so_far', 'result'], ...rows].map((row) => row.map(quote).join(',')).join('\n') +
    '\n'
  );
}
