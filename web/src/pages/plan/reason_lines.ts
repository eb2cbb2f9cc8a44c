// A reason of the planner, taken apart: what there must be at least, and why.
import { number } from '../../lib/words';

const searched = new RegExp(
  '^of all lists, looked through from the cheapest on in (\\d+) states?, none costs less; ' +
    'without that, ',
);
const least = /^(?:, )?at least (\d+ (?:tests?|changes?)) \(/;

/** Where the bracket that opens at `from` closes; -1: nowhere. */
function closing(text: string, from: number): number {
  for (let at = from, depth = 0; at < text.length; ++at) {
    depth += text[at] === '(' ? 1 : text[at] === ')' ? -1 : 0;
    if (depth === 0) {
      return at;
    }
  }
  return -1;
}

/** What is said of designs, as it is of tests. */
function plainly(why: string): string {
  return why.replace(
    /^one change at a time takes (\d+) blocks: (SCCD\((\d+),(\d+)\))$/,
    (_, tests: string, design: string, _v, k: string) =>
      `with one change at a time it takes ${tests} tests, as in the design ${design}: ${k} parts ` +
      `for the first test and ${Number(tests) - 1} changes after it`,
  );
}

/** The first words of a line are what it says, the rest is why. */
interface ReasonLine {
  said: string;
  why: string;
}

/**
 * The reason as the library writes it, in lines. `bound` is the cost that no plan undercuts, as it
 * is shown.
 */
export function linesOf(reason: string, bound: string): ReasonLine[] {
  const lines: ReasonLine[] = [];
  let rest = reason;
  const states = searched.exec(rest);
  rest = rest.replace(searched, '');
  // What holds of the numbers that follow comes before them.
  const before = /^([^()]+): (?=at least \d+ tests? \()/.exec(rest)?.[1];
  if (before) {
    lines.push({ said: '', why: before });
    rest = rest.slice(before.length + 2);
  }
  for (let found = least.exec(rest); found; found = least.exec(rest)) {
    const open = found[0].length - 1;
    const end = closing(rest, open);
    if (end < 0) {
      break;
    }
    lines.push({ said: `At least ${found[1]}`, why: plainly(rest.slice(open + 1, end)) });
    rest = rest.slice(end + 1);
  }
  rest = rest.replace(/^, (?:and )?/, '').replace(/ \(docs\/plan\.md, The lower bound\)/g, '');
  if (rest !== '') {
    const together = lines.some(({ said }) => said !== '');
    // Where all lists were looked through, that says more.
    const whole = states ? 'Together' : `Together at least ${bound}`;
    lines.push({ said: together ? whole : '', why: rest });
  }
  if (states) {
    lines.push({
      said: `Together at least ${bound}`,
      why: `all cheaper lists were tried (${number(Number(states[1]))} states)`,
    });
  }
  return lines;
}
