// Several benches: a card for each, and what all of them have.
import { field, h, select } from '../../lib/dom';
import { count } from '../../lib/words';
import { benchTable } from './bench_table';
import { emptyBench, type Bench, type Job } from './job';

export interface BenchFields {
  /** What stands in their group. */
  readonly content: HTMLElement[];
  readonly table: HTMLElement;
  /** Fields by the keys of a request. */
  readonly controls: Record<string, HTMLElement>;
  /** In a few words; '' is one bench. */
  said(): string;
  benches(): Bench[];
  read(): Pick<Job, 'benches' | 'hours' | 'firstDay' | 'dayBegins' | 'weekends'>;
  aim(): Job['objective'];
  set(job: Job): void;
  /** Words for parts or for values of a model. */
  reword(source: Job['source']): void;
  refresh(): void;
}

/** `usual` is what a bench has where its own field is empty; `retimed` hears when days begin. */
export function benchFields(
  touched: () => void,
  retimed: (dayBegins: string) => void,
  usual: { room: () => string; testCost: () => string },
): BenchFields {
  const hours = h('input', {
    type: 'text',
    inputmode: 'decimal',
    class: 'cost',
    placeholder: 'no end',
    oninput: touched,
  });
  const firstDay = h('input', { type: 'date', onchange: touched });
  const dayBegins = h('input', { type: 'time', onchange: () => retimed(dayBegins.value) });
  const weekends = h('input', { type: 'checkbox', onchange: touched });
  const objective = select(
    '',
    [
      ['', 'done as early as possible'],
      ['cost', 'least cost together'],
      ['tests', 'fewest tests together'],
    ],
    touched,
  );
  const fewestTests = objective.options[2]!;
  const rows = benchTable(touched, {
    ...usual,
    hours: () => hours.value.trim() || 'no end',
  });
  const benchParts = h(
    'span',
    {},
    'In the parts list, “how many” says how many there are of a part. Left empty throughout, ' +
      'there are enough for every bench.',
  );
  const benchValues = h('span', { hidden: true }, 'A bench “cannot have” values of the model.');
  const alike = (n: number): Bench[] =>
    Array.from({ length: n }, (_, i) => ({ ...emptyBench(), name: `Bench ${i + 1}` }));
  const button = (words: string, benches: () => Bench[]) =>
    h(
      'button',
      {
        type: 'button',
        class: 'plain small',
        onclick: () => (rows.set(benches()), touched()),
      },
      words,
    );
  return {
    content: [
      h(
        'p',
        { class: 'hint' },
        'A card for each bench, with what is different there; a new one begins with its name. ',
        benchParts,
        benchValues,
      ),
      h(
        'div',
        { class: 'row' },
        ...[2, 3, 4].map((n) => button(`${n} alike`, () => alike(n))),
        button('One bench', () => []),
      ),
      rows.element,
      h(
        'div',
        { class: 'row bench-days' },
        field('Aim of several benches', objective),
        field('Hours of work a day', hours),
        field('Day begins at', dayBegins),
        field('First day', firstDay),
        h('label', { class: 'check' }, weekends, 'Weekends too'),
      ),
    ],
    table: rows.element,
    controls: { benches: rows.element, hours, first_day: firstDay, objective },
    said() {
      const named = rows.read();
      const day = hours.value.trim();
      return named.length === 0
        ? ''
        : `${count(named.length, 'bench', 'benches')}${day === '' ? '' : `, ${day} h a day`}`;
    },
    benches: rows.read,
    read: () => ({
      benches: rows.read(),
      hours: hours.value,
      firstDay: firstDay.value,
      dayBegins: dayBegins.value,
      weekends: weekends.checked,
    }),
    aim: () =>
      (fewestTests.hidden && fewestTests.selected ? '' : objective.value) as Job['objective'],
    set(job) {
      [hours.value, firstDay.value, dayBegins.value] = [job.hours, job.firstDay, job.dayBegins];
      weekends.checked = job.weekends;
      objective.value = job.objective;
      rows.set(job.benches);
    },
    reword(source) {
      benchParts.hidden = source !== 'parts';
      benchValues.hidden = source !== 'model';
      // Only of a model the number of tests alone can be made small.
      fewestTests.hidden = source !== 'model';
      fewestTests.disabled = fewestTests.hidden;
      rows.element.classList.toggle('of-model', source === 'model');
    },
    refresh: rows.refresh,
  };
}
