// The job of the form as the document that the server takes, and back.
import type { Job as Request } from '../../../answers';
import {
  cells,
  checkJob,
  emptyBench,
  emptyJob,
  lineOf,
  namesIn,
  wantedPairs,
  type Bench,
  type Job,
  type Slot,
  type Unit,
} from './job';

type Field = string | number | boolean | null | undefined;

const text = (field: Field): string => (field === null || field === undefined ? '' : String(field));
const listText = (value: Field | readonly Field[]): string =>
  Array.isArray(value) ? lineOf(value.map(text)) : text(value as Field);

function benchRow(bench: Bench): Record<string, string | boolean> {
  const { name, hours, atOnce, testCost, changeFactor, without, own, start, mounted, slots, down } =
    bench;
  const all = {
    name,
    hours,
    at_once: atOnce,
    test_cost: testCost,
    change_factor: changeFactor,
    without,
    own,
    start,
    mounted,
    slots,
  };
  return {
    ...Object.fromEntries(Object.entries(all).filter(([, value]) => value.trim() !== '')),
    ...(down ? { down: true } : {}),
  };
}

/** Rows of names: a first row that names no part heads the others. */
function listed(list: string, job: Job): string[][] {
  const rows = cells(list).map((row) =>
    row.filter((field, i) => field !== '' || i + 1 < row.length),
  );
  const names = new Set(job.parts.map(({ name }) => name));
  const heads =
    job.source === 'parts' &&
    rows.length > 1 &&
    !rows[0]!.some((field) => names.has(field) || /^\d+$/.test(field));
  return heads ? rows.slice(1) : rows;
}

/**
 * Pairs that must never meet, with why behind them: after a comma, or after a colon or in brackets
 * if no part has that in its name.
 */
export function neverRows(job: Job): string[][] {
  const names = new Set(job.parts.map(({ name }) => name));
  const known = (name: string) =>
    job.source === 'model' ? job.model.includes(name) : names.has(name);
  return listed(job.never, job).map(([one = '', other = '', ...why]) => {
    const [, name = '', reason = ''] = /^(.*?\S)\s*[:(]\s*(.*)$/.exec(other) ?? [];
    return name === '' || known(other) || !known(name)
      ? [one, other, ...why]
      : [one, name, ...[[reason, ...why].join(', ').replace(/^([^(]*)\)$/, '$1')].filter(Boolean)];
  });
}

/**
 * The document, without the tests that were done. @throws Error with a line that can be shown, for
 * what the form itself can tell.
 */
export function requestOf(job: Job): Request {
  checkJob(job);
  const model = job.source === 'model';
  const onBenches = /^bench\s*[,;\t]/i.test(job.first);
  const lists = {
    never: job.never,
    ...(onBenches ? {} : { first: job.first }),
    ...(model ? {} : { weights: job.weights }),
  };
  const request: Request = {
    format: 'changeover-job/1',
    title: job.title,
    test_cost: job.testCost,
    change_cost: job.changeCost,
    ...Object.fromEntries(
      Object.entries(lists).flatMap(([key, rows]) =>
        rows.trim() === '' ? [] : [[key, key === 'never' ? neverRows(job) : listed(rows, job)]],
      ),
    ),
    ...(onBenches ? { first: { text: `${job.first}\n` } } : {}),
    ...(job.changeCosts.trim() === '' ? {} : { change_costs: { text: `${job.changeCosts}\n` } }),
  };
  if (model) {
    request.model = job.model;
  } else {
    const quantities = job.parts.some(({ quantity }) => quantity !== null);
    const slots = job.slots.some(
      ({ name, least, most }) => name !== '' && (least !== '' || most !== ''),
    );
    request.parts = job.parts.map(({ name, cost, slot, quantity }) => ({
      name,
      cost: cost ?? job.changeCost,
      ...(slots && slot !== '' ? { slot } : {}),
      ...(quantities ? { quantity: quantity ?? 1 } : {}),
    }));
    if (slots) {
      request.slots = job.slots.filter(({ name }) => name !== '');
    }
    if (job.atOnce !== null) {
      request.at_once = job.atOnce;
    }
    const pairs = wantedPairs(job);
    if (pairs) {
      request.pairs = pairs;
    }
    const gone = job.parts.filter((part) => part.gone).map(({ name }) => name);
    if (gone.length > 0) {
      request.without = gone;
    }
  }
  const [mounted, start] = [namesIn(job.mounted), namesIn(job.start)];
  Object.assign(
    request,
    job.unit === '' ? {} : { cost_unit: job.unit },
    job.strength === 2 ? {} : { strength: job.strength },
    mounted.length > 0 ? { mounted } : {},
    start.length > 0 ? { start } : {},
    job.budget.trim() === '' ? {} : { budget: job.budget.trim() },
    job.seconds > 0 ? { seconds: job.seconds } : {},
  );
  const benches = job.benches.map(benchRow);
  if (benches.length > 0) {
    request.benches = benches;
    Object.assign(
      request,
      job.objective === 'cost' || (model && job.objective === 'tests')
        ? { objective: job.objective }
        : {},
      job.hours.trim() === '' ? {} : { hours: job.hours.trim() },
      job.firstDay === '' ? {} : { first_day: job.firstDay },
      job.weekends && job.firstDay !== '' ? { weekends: true } : {},
    );
  } else if (model && job.objective === 'tests') {
    request.objective = 'tests';
  }
  return request;
}

const rows = (list: unknown): string =>
  Array.isArray(list)
    ? (list as unknown[])
        .map((row) =>
          lineOf((Array.isArray(row) ? row : (row as { parts: Field[] }).parts).map(text)),
        )
        .join('\n')
    : list !== null && typeof list === 'object' && 'text' in list
      ? String(list.text)
      : '';

/**
 * Set-ups that come first, a line each; where some do so on one bench only, as a run sheet with a
 * column for the bench.
 */
function firstOf(list: Request['first']): string {
  if (!Array.isArray(list) || list.every((row) => Array.isArray(row) || !row.bench)) {
    return rows(list);
  }
  const all = list.map((row) => (Array.isArray(row) ? { bench: '', parts: row } : row));
  const width = Math.max(...all.map(({ parts }) => parts.length));
  const head = ['bench', ...Array.from({ length: width }, (_, i) => `slot_${i + 1}`)];
  return [
    head,
    ...all.map(({ bench, parts }) => [
      text(bench),
      ...Array.from({ length: width }, (_, i) => text(parts[i])),
    ]),
  ]
    .map(lineOf)
    .join('\n');
}

function benchOf(row: string | Record<string, unknown>): Bench {
  if (typeof row === 'string') {
    return { ...emptyBench(), name: row };
  }
  const of = (key: string) => listText(row[key] as Field | Field[]);
  return {
    name: of('name'),
    hours: of('hours'),
    atOnce: of('at_once'),
    testCost: of('test_cost'),
    changeFactor: of('change_factor'),
    without: of('without'),
    own: of('own'),
    start: of('start'),
    mounted: of('mounted'),
    slots: Array.isArray(row['slots'])
      ? (row['slots'] as { name: Field; least?: Field; most?: Field }[])
          .map((slot) => `${text(slot.name)}=${text(slot.least)}..${text(slot.most)}`)
          .join(', ')
      : of('slots'),
    down: row['down'] === true || /^(yes|true|1|x)$/i.test(text(row['down'] as Field)),
  };
}

/**
 * What a document says, in the place of what `job` says; what it does not say stays, but for the
 * lists that belong to its parts.
 */
export function jobOf(request: Request, job: Job): Job {
  const empty = emptyJob();
  const numberOf = (value: number | string | null | undefined, usual: number) =>
    value === null || value === undefined || value === '' ? usual : Number(value);
  const next: Job = { ...job };
  if (request.model) {
    const { title, testCost, changeCost, seconds } = job;
    Object.assign(next, empty, {
      title,
      testCost,
      changeCost,
      seconds,
      source: 'model',
      model: typeof request.model === 'string' ? request.model : rows(request.model),
    });
  } else if (Array.isArray(request.parts)) {
    const { title, testCost, changeCost, seconds, benches, objective } = job;
    const { hours, firstDay, dayBegins, weekends } = job;
    Object.assign(next, empty, {
      title,
      testCost,
      changeCost,
      seconds,
      benches,
      objective,
      hours,
      firstDay,
      dayBegins,
      weekends,
    });
    next.parts = request.parts.map((part) => {
      const row = typeof part === 'string' ? { name: part } : part;
      return {
        name: text(row.name),
        cost: text(row.cost) === '' ? null : Number(row.cost),
        slot: text(row.slot),
        quantity: text(row.quantity) === '' ? null : Number(row.quantity),
        gone: false,
      };
    });
    next.slots = Array.isArray(request.slots)
      ? request.slots.map(({ name, least, most }): Slot => ({
          name: text(name),
          least: text(least) === '0' ? '' : text(least),
          most: text(most),
        }))
      : [];
    next.atOnce = request.at_once ?? (next.slots.length > 0 ? null : job.atOnce);
  }
  next.testCost = numberOf(request.test_cost, next.testCost);
  next.changeCost = numberOf(request.change_cost, next.changeCost);
  const given: Partial<Job> = {
    ...(request.title ? { title: request.title } : {}),
    ...(request.cost_unit ? { unit: request.cost_unit as Unit } : {}),
    ...(request.strength ? { strength: request.strength } : {}),
    ...(request.pairs ? { pairMode: 'only', pairs: rows(request.pairs) } : {}),
    ...(request.never ? { never: rows(request.never) } : {}),
    ...(request.first ? { first: firstOf(request.first) } : {}),
    ...(request.weights ? { weights: rows(request.weights) } : {}),
    ...(request.change_costs ? { changeCosts: rows(request.change_costs) } : {}),
    ...(request.mounted?.length ? { mounted: lineOf(request.mounted.map(text)) } : {}),
    ...(request.start?.length ? { start: lineOf(request.start.map(text)) } : {}),
    ...(request.budget ? { budget: text(request.budget) } : {}),
    ...(request.trust_failed ? { trustFailed: true } : {}),
    ...(request.hours ? { hours: text(request.hours) } : {}),
    ...(request.first_day ? { firstDay: request.first_day } : {}),
    ...(request.weekends ? { weekends: true } : {}),
    ...(request.objective === 'cost' || request.objective === 'tests'
      ? { objective: request.objective }
      : {}),
  };
  Object.assign(next, given);
  if (typeof request.benches === 'number') {
    next.benches = Array.from({ length: Math.min(64, request.benches) }, (_, i) => ({
      ...emptyBench(),
      name: `Bench ${i + 1}`,
    }));
  } else if (Array.isArray(request.benches)) {
    next.benches = request.benches.map((row) => benchOf(row as string | Record<string, unknown>));
  }
  for (const name of request.without ?? []) {
    const part = next.parts.find((each) => each.name === text(name));
    if (part) {
      part.gone = true;
    }
  }
  return next;
}

/** What the document says when tests were done. */
export function withDone(request: Request, job: Job, done: string): Request {
  return { ...request, done: { text: done }, ...(job.trustFailed ? { trust_failed: true } : {}) };
}

/** The same as a question about results, or about other costs, which needs less. */
export function forDiagnosis({
  title,
  budget,
  first,
  weights,
  trust_failed,
  seconds,
  ...request
}: Request): Request {
  return { ...request, diagnose: true };
}
export function forWhatIf({ title, budget, weights, ...request }: Request): Request {
  return { ...request, what_if: true };
}

const labels: Record<string, string> = {
  at_once: 'How many fit at once',
  test_cost: 'Cost of a test',
  change_cost: 'Cost of a change',
  never: 'Forbidden pairs',
  first: 'First tests',
  weights: 'Priorities',
  pairs: 'Pairs',
  slots: 'Slots',
  benches: 'Benches',
  parts: 'Parts',
  mounted: 'What stays mounted',
  start: 'What is on the bench',
  budget: 'Budget',
};

/** Which key of the document a message of the server begins with. */
export function keyIn(message: string): string | null {
  return (
    Object.keys(labels).find((key) => message.startsWith(`${labels[key]}:`)) ??
    /^(?:give )?([a-z_]+)(?=[:,\s.[]|$)/.exec(message)?.[1] ??
    null
  );
}

/** Whether a note is of how the list of parts was read. */
const ofList = (note: string): boolean => /^parts: .*(header|not used)/.test(note);

/** A note on how a list was read, as it stands below that list. */
export function readWords(note: string): string {
  const words = note
    .replace(/^parts: /, '')
    .replace(/^the first row is a header: /, 'First row taken as headings: ')
    .replace(/'([^']*)'/g, '“$1”');
  return `${words[0]?.toUpperCase() ?? ''}${words.slice(1)}${/[.!?]$/.test(words) ? '' : '.'}`;
}

/** What is said of a file below the list or the model that was read from it. */
export function readFrom(file: string, notes: readonly string[]): string[] {
  const what = notes.find((note) => note.startsWith(`${file}: `))?.slice(file.length + 2);
  const words = what === undefined || what === 'the model' ? '' : `: ${what}`;
  return [`Read from ${file}${words}.`, ...notes.filter(ofList).map(readWords)];
}

/** What else is to be said of it. */
export function othersOf(file: string, notes: readonly string[]): string[] {
  return notes
    .filter((note) => !ofList(note) && !note.startsWith(`${file}: `))
    .map((note) => note.replace(/^(parts|done)(?=[:\s])/, file));
}

/** The unit that the heading of the costs names; null: none. */
export function unitIn(notes: readonly string[]): Unit | null {
  const heading = notes.map((note) => /change costs in '([^']*)'/.exec(note)?.[1]).find(Boolean);
  const found = (Object.entries(unitNames) as [Unit, RegExp][]).filter(([, names]) =>
    names.test(heading ?? ''),
  );
  return found.length === 1 ? found[0]![0] : null;
}

const unitNames = {
  seconds: /\b(s|secs?|seconds?|sekunden?)\b/i,
  minutes: /\b(min|mins|minutes?|minuten?)\b/i,
  hours: /\b(h|hrs?|hours?|stunden?)\b/i,
};

/** The message in the words of the form. */
export function inWords(message: string): string {
  const free = /^give at_once, .*: (.*) is in no slot$/.exec(message);
  return free
    ? `${free[1]} has no slot, so say how many parts fit at once, or give it a slot.`
    : message
        .replace(/^give at_once, how many parts fit at once/, `write “${labels.at_once}”`)
        .replace(/^([a-z_]+)(?:\[(\d+)\])?:/, (all, key: string, row?: string) =>
          labels[key]
            ? `${labels[key]}${row === undefined ? '' : `, row ${Number(row) + 1}`}:`
            : all,
        );
}
