// Files that are dropped or chosen: parts lists, workbooks, run sheets, models, lists of benches.
// The library reads them; the page only tells which of them a file is.
import { post, type ReadJob } from '../../lib/api';
import type { Job as Request } from '../../../answers';
import { jobOf } from './document';
import { cells, emptyBench, type Bench, type Job } from './job';
import { isPlaced } from './model_faults';
import { noted, verdictOf, type Place, type Test, type Verdict } from './outcome';

export interface Taken {
  job: Job;
  /** Tests with results that were on it. */
  done: { places: Place[]; tests: Test[] };
  /** What was made of it, a line each. */
  notes: string[];
  /** It was taken as it is, and this is wrong with it. */
  fault?: Error;
}

const most = 700_000; // The server takes 1 MB of JSON, and base64 is a third longer.

function base64(bytes: Uint8Array): string {
  let text = '';
  for (let i = 0; i < bytes.length; i += 0x8000) {
    text += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  }
  return btoa(text);
}

/**
 * A result in its own words, with the planner's word first where these words do not show what it
 * understood.
 */
function understood(result: string, verdict: Verdict): string {
  return verdict === '' || verdict === verdictOf({ result })
    ? result
    : verdict === 'other'
      ? `? ${result}`
      : `${verdict}: ${result}`;
}

function taken(answer: ReadJob, job: Job): Taken {
  const places = answer.done.places;
  const tests = answer.done.tests.map(({ bench, places: row, result, verdict, notes }): Test => ({
    bench,
    parts: row.filter((name) => name !== ''),
    places: places.map((_, i) => row[i] || null),
    cost: 0,
    result: understood(result, verdict),
    notes,
    by: '',
    at: '',
  }));
  return { job: jobOf(answer.request, job), done: { places, tests }, notes: noted(answer.notes) };
}

/** Parts of what a spreadsheet copies; with or without heads. */
export async function readParts(text: string, job: Job, signal: AbortSignal): Promise<Taken> {
  const read = (more: object) =>
    post('plan/read', {}, { parts: { text: `${text}\n` }, ...more }, signal);
  let answer: ReadJob;
  try {
    answer = await read({});
  } catch (fault) {
    if (!/may be a header or a part/.test(String(fault))) {
      throw fault;
    }
    answer = await read({ no_header: true });
  }
  return taken(answer, job);
}

const benchHeads: Record<string, keyof Bench> = {
  bench: 'name',
  name: 'name',
  hours: 'hours',
  at_once: 'atOnce',
  test_cost: 'testCost',
  change_factor: 'changeFactor',
  without: 'without',
  own: 'own',
  start: 'start',
  mounted: 'mounted',
  slots: 'slots',
  down: 'down',
};

function benchesOf(rows: string[][]): Bench[] {
  const heads = rows[0]!.map(
    (head) =>
      benchHeads[
        head
          .trim()
          .toLowerCase()
          .replace(/[\s-]+/g, '_')
      ],
  );
  const unknown = heads.findIndex((head) => head === undefined);
  if (unknown >= 0) {
    throw new Error(
      `the column “${rows[0]![unknown]}” says nothing of a bench; columns are ` +
        `${Object.keys(benchHeads).join(', ')}`,
    );
  }
  return rows.slice(1).map((row) => {
    const bench = emptyBench();
    heads.forEach((head, i) =>
      Object.assign(bench, {
        [head!]: head === 'down' ? /^(yes|true|1|x)$/i.test(row[i] ?? '') : (row[i] ?? ''),
      }),
    );
    return bench;
  });
}

function isModel(name: string, text: string): boolean {
  const lines = text.split(/\r?\n/).filter((line) => line.trim() !== '' && !/^\s*#/.test(line));
  const parameters = lines.filter((line) => /^[^,:;\t]+:\s*\S/.test(line)).length;
  return (
    /\.(pict|acts|model)$/i.test(name) ||
    /^\s*\[system\]/i.test(text) ||
    (parameters >= 2 && parameters * 2 >= lines.length)
  );
}

/**
 * What a file says, put into `job`. `asked` makes the document of the form, for files that say
 * nothing without it.
 */
export async function readFile(
  file: File,
  job: Job,
  asked: () => Request,
  signal: AbortSignal,
): Promise<Taken> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  if (bytes.length > most) {
    throw new Error(
      `${file.name}: ${(bytes.length / 1e6).toFixed(1)} MB are more than this page takes (0.7 ` +
        `MB); give it to “changeover plan”`,
    );
  }
  const named = (fault: unknown) =>
    new Error(String((fault as Error).message).replace(/^(parts|done|model)(?=[:\s])/, file.name));
  const read = async (request: Request) => {
    try {
      return taken(await post('plan/read', {}, request, signal), job);
    } catch (fault) {
      throw signal.aborted ? fault : named(fault);
    }
  };
  if (bytes[0] === 0x50 && bytes[1] === 0x4b) {
    return read({ parts: { workbook: base64(bytes) } });
  }
  let text: string;
  try {
    text = new TextDecoder('utf-8', { fatal: true }).decode(bytes);
  } catch {
    throw new Error(
      `${file.name}: this is neither text in UTF-8 nor a workbook (.xlsx); save it as one of these`,
    );
  }
  if (/^\s*\{/.test(text)) {
    return read(JSON.parse(text) as Request);
  }
  const said = (words: string, next: Job): Taken => ({
    job: next,
    done: { places: [], tests: [] },
    notes: [`${file.name}: ${words}`],
  });
  if (isModel(file.name, text)) {
    try {
      return taken(await post('plan/read', {}, { model: text }, signal), job);
    } catch (fault) {
      // A slip is mended in the text, so it must be there.
      if (signal.aborted || !isPlaced((fault as Error).message)) {
        throw signal.aborted ? fault : named(fault);
      }
      return { ...said('the model', jobOf({ model: text }, job)), fault: fault as Error };
    }
  }
  const rows = cells(text);
  const head = (rows[0] ?? []).map((cell) => cell.toLowerCase());
  if (head.includes('step') && head.some((cell) => /^result/.test(cell))) {
    return read({ ...asked(), done: { text } });
  }
  if (/^bench(es)?$/.test(head[0] ?? '')) {
    return said('benches', { ...job, benches: benchesOf(rows) });
  }
  if (/^slots?$/.test(head[0] ?? '') && head.length <= 3) {
    const slots = rows
      .slice(1)
      .map(([name = '', least = '', greatest]) => ({ name, least, most: greatest ?? least }));
    return said('slots', { ...job, slots });
  }
  if (/never|forbid|conflict|incompat/i.test(file.name)) {
    return said('forbidden pairs', { ...job, never: text.trim() });
  }
  if (/priorit|weight/i.test(file.name)) {
    return said('priorities', { ...job, weights: text.trim() });
  }
  if (/^parameter$/.test(head[0] ?? '') || /cleaning|change.?cost/i.test(file.name)) {
    return said('costs', { ...job, changeCosts: text.trim() });
  }
  try {
    return await readParts(text, job, signal);
  } catch (fault) {
    throw signal.aborted ? fault : named(fault);
  }
}
