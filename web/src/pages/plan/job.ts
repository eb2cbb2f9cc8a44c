// What is to be planned, as the form has it, and the arithmetic on costs and lists.

export interface Part {
  name: string;
  /** What putting it in costs; null: what it costs for all. */
  cost: number | null;
  /** '' is none. */
  slot: string;
  /** How many there are; null: as many as are needed. */
  quantity: number | null;
  /** It broke or went away: no later test can have it. */
  gone: boolean;
}

/** How many parts of it a set-up has; '' is no limit. */
export interface Slot {
  name: string;
  least: string;
  most: string;
}

/**
 * What a bench has instead of what the job says; '' is as the job says. Lists of parts have commas
 * between them.
 */
export interface Bench {
  name: string;
  hours: string;
  atOnce: string;
  testCost: string;
  changeFactor: string;
  without: string;
  own: string;
  start: string;
  mounted: string;
  slots: string;
  down: boolean;
}

export type PairMode = 'all' | 'only' | 'skip';
export type Unit = '' | 'money' | 'seconds' | 'minutes' | 'hours';

export interface Job {
  title: string;
  source: 'parts' | 'model';
  parts: Part[];
  /** Parameters, values and rules in the language of PICT or ACTS. */
  model: string;
  /** null: as many as the slots hold. */
  atOnce: number | null;
  testCost: number;
  changeCost: number;
  unit: Unit;
  strength: number;
  pairMode: PairMode;
  /** Two names a line, with a comma between. */
  pairs: string;
  slots: Slot[];
  never: string;
  mounted: string;
  start: string;
  first: string;
  weights: string;
  budget: string;
  changeCosts: string;
  benches: Bench[];
  objective: '' | 'cost' | 'tests';
  hours: string;
  firstDay: string;
  /** When a day of work begins, as 08:00; '' is not said. Only what is shown follows it. */
  dayBegins: string;
  weekends: boolean;
  trustFailed: boolean;
  /** How long is searched; 0: as long as it brings something. */
  seconds: number;
}

/** What is wrong with the field of a key of the document. */
export class FieldFault extends Error {
  constructor(
    message: string,
    readonly key: string,
  ) {
    super(message);
  }
}

export function emptyJob(): Job {
  return {
    title: 'Run sheet',
    source: 'parts',
    parts: [],
    model: '',
    atOnce: 3,
    testCost: 1,
    changeCost: 1,
    unit: '',
    strength: 2,
    pairMode: 'all',
    pairs: '',
    slots: [],
    never: '',
    mounted: '',
    start: '',
    first: '',
    weights: '',
    budget: '',
    changeCosts: '',
    benches: [],
    objective: '',
    hours: '',
    firstDay: '',
    dayBegins: '08:00',
    weekends: false,
    trustFailed: false,
    seconds: 0,
  };
}

export function emptyBench(): Bench {
  return {
    name: '',
    hours: '',
    atOnce: '',
    testCost: '',
    changeFactor: '',
    without: '',
    own: '',
    start: '',
    mounted: '',
    slots: '',
    down: false,
  };
}

export function partOf(
  name: string,
  cost: number | null = null,
  slot = '',
  quantity: number | null = null,
): Part {
  return { name, cost, slot, quantity, gone: false };
}

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

/**
 * Rounded to the millionths that costs have, so that sums of decimals are shown as people add them.
 */
export function exact(cost: number): number {
  return Math.round(cost * 1e6) / 1e6;
}

/** Writes costs with as many decimals as all of `costs` need: none, or two and more. */
export function moneyOf(costs: readonly number[]): (cost: number) => string {
  const decimals = Math.max(
    0,
    ...costs.map((cost) => (String(exact(cost)).split('.')[1] ?? '').length),
  );
  return (cost) => exact(cost).toFixed(decimals === 0 ? 0 : Math.max(2, decimals));
}

/**
 * A cost of a plan that was never made, as prices would make it: to the hundredth, as far as it has
 * any.
 */
export function about(cost: number): string {
  const rounded = Number(cost.toFixed(2));
  return rounded === 0 && cost !== 0
    ? String(Number(cost.toPrecision(3)))
    : Number.isInteger(rounded)
      ? String(rounded)
      : rounded.toFixed(2);
}

/** "Pump bench" as the name of a file. */
export function fileOf(title: string): string {
  return (
    title
      .normalize('NFC')
      .replace(/[^\p{L}\p{N}.-]+/gu, '_')
      .replace(/^[._]+|[._]+$/g, '')
      .toLowerCase()
      .slice(0, 60) || 'run_sheet'
  );
}

/**
 * Cells of a table as spreadsheets copy it (tabs) or write it (CSV with commas or semicolons,
 * fields quoted or not).
 */
export function cells(text: string): string[][] {
  const lines = text.replace(/\r\n?/g, '\n').replace(/^\ufeff/, '');
  // What is in quotes or in a comment separates nothing.
  const bare = lines
    .replace(/^[ \t]*#.*$/gm, '')
    .replace(/"[^"]*"/g, '')
    .trimStart();
  const separator =
    /^[^\n]*\t/.test(bare) || !/[,;]/.test(bare) ? '\t' : /^[^\n,]*;/m.test(bare) ? ';' : ',';
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

function listed(job: Job): [string, string][] {
  const names = new Set(job.parts.map(({ name }) => name));
  return cells(job.pairs).map((row, i) => {
    const [one = '', other = '', third] = row.filter((each) => each !== '');
    if (third !== undefined) {
      throw new Error(
        `pair ${i + 1}: “${third}” is a third field: write two parts with a comma between`,
      );
    }
    for (const name of [one, other]) {
      if (!names.has(name)) {
        const fault =
          name === ''
            ? 'write two parts with a comma between'
            : `“${name}” is not in the list of parts`;
        throw new Error(`pair ${i + 1}: ${fault}`);
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
  const key = (one: string, other: string) =>
    one < other ? `${one}\n${other}` : `${other}\n${one}`;
  const skipped = new Set(listed(job).map(([one, other]) => key(one, other)));
  const names = job.parts.map(({ name }) => name).filter((name) => !gone.has(name));
  const pairs: [string, string][] = [];
  names.forEach((one, i) =>
    names.slice(i + 1).forEach((other) => skipped.has(key(one, other)) || pairs.push([one, other])),
  );
  return pairs;
}

/** Names of parts in one line or more, with commas between them. */
export function namesIn(text: string): string[] {
  return cells(text)
    .flat()
    .filter((name) => name !== '');
}

/** A row as a line that `cells` reads back. */
export function lineOf(fields: readonly string[]): string {
  return fields
    .map((text) => (/[",;\t\n]|^\s|\s$|^#/.test(text) ? `"${text.replaceAll('"', '""')}"` : text))
    .join(', ');
}

/**
 * @throws Error with a line that can be shown, if this job cannot be planned. What needs the lists
 * read is said by the server.
 */
export function checkJob(job: Job): void {
  if (job.source === 'model') {
    if (job.model.trim() === '') {
      throw new FieldFault(
        'There is no model: write its parameters, one a line, as in “Browser: Firefox, ' +
          'Chrome”, or take an example.',
        'model',
      );
    }
    return;
  }
  const left = job.parts.filter((part) => !part.gone);
  if (left.length < 2) {
    throw new FieldFault(
      'There are fewer than two parts: type them, paste them from a spreadsheet, or take an ' +
        'example.',
      'parts',
    );
  }
  const seen = new Set<string>();
  for (const [i, { name }] of job.parts.entries()) {
    if (name === '') {
      throw new FieldFault(`Part ${i + 1} has no name.`, 'parts');
    }
    if (seen.has(name)) {
      throw new FieldFault(`Part ${i + 1}: “${name}” is in the list twice.`, 'parts');
    }
    seen.add(name);
  }
  if (job.atOnce !== null && (!Number.isInteger(job.atOnce) || job.atOnce < 2)) {
    throw new FieldFault('How many fit at once: a pair needs room for two.', 'at_once');
  }
}
