// Parts that a plan has on several benches at the same time, where the list does not say how many there are.
import type { Job } from './job';
import type { Outcome } from './outcome';

/** The most benches that have it at one time; `own` names benches with their own piece. */
function mostAtOnce({ tests }: Outcome, part: string, own: ReadonlySet<string>): number {
  const ends: [at: number, by: 1 | -1][] = [];
  for (const bench of new Set(tests.map((test) => test.bench))) {
    let until: number | null = null;
    for (const test of own.has(bench ?? '') ? [] : tests) {
      if (test.bench !== bench || !test.span) {
        continue;
      }
      const [from, to] = test.span;
      if (!test.parts.includes(part)) {
        until = null;
        continue;
      }
      // It stays on the bench from one test to the next.
      if (until === null) {
        ends.push([from, 1], [to, -1]);
      } else {
        ends.at(-1)![0] = to;
      }
      until = to;
    }
  }
  ends.sort(([one, by], [other, also]) => one - other || by - also);
  let now = 0;
  return ends.reduce((most, [, by]) => Math.max(most, (now += by)), 0);
}

/** The parts of which the plan needs several, each with how many, the most of one first. */
export function severalOf(job: Job, outcome: Outcome): [part: string, pieces: number][] {
  const open =
    job.source === 'parts' &&
    outcome.benches !== null &&
    job.parts.every(({ quantity }) => quantity === null);
  return (open ? job.parts : [])
    .map(({ name }): [string, number] => {
      const own = job.benches.filter((bench) =>
        bench.own.split(',').some((each) => each.trim() === name),
      );
      return [name, mostAtOnce(outcome, name, new Set(own.map((bench) => bench.name)))];
    })
    .filter(([, pieces]) => pieces > 1)
    .sort(([, one], [, other]) => other - one);
}

const numbers = ['', '', 'two', 'three', 'four', 'five', 'six'];
/** So many are named. */
const mostNamed = 6;

/** "two of Alpha and Delta, three of Zeta" */
export function piecesInWords(several: readonly (readonly [string, number])[]): string {
  const shown = several.slice(0, mostNamed);
  const said = [...new Set(shown.map(([, pieces]) => pieces))].map((pieces) => {
    const names = shown.filter(([, each]) => each === pieces).map(([name]) => name);
    const last = names.length > 1 ? ` and ${names.pop()!}` : '';
    return `${numbers[pieces] ?? pieces} of ${names.join(', ')}${last}`;
  });
  const more = several.length - shown.length;
  return said.join('; ') + (more > 0 ? `; and several of ${more} more parts` : '');
}
