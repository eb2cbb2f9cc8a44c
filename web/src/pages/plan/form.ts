// The form of a job: what every job has, and the rest in groups that open.
import { field, fill, h, select } from '../../lib/dom';
import { count } from '../../lib/words';
import {
  cells,
  decimal,
  emptyJob,
  FieldFault,
  namesIn,
  partOf,
  type Job,
  type PairMode,
  type Part,
  type Slot,
  type Unit,
} from './job';
import { group as folded, type Group } from '../../parts/group';
import { lead } from '../../parts/lead';
import { benchFields } from './bench_fields';
import { partsGrid } from './parts';
import { rowsTable } from './rows';
import { reword } from './wording';

const pairModes: readonly (readonly [PairMode, string])[] = [
  ['all', 'every two parts must meet'],
  ['only', 'only the pairs listed must meet'],
  ['skip', 'the pairs listed need not meet'],
];
const strengths: readonly (readonly [string, string])[] = [
  ['2', 'every two together'],
  ['3', 'every three together'],
];
const units: readonly (readonly [Unit, string])[] = [
  ['', 'as in the list'],
  ['minutes', 'minutes, with clock'],
  ['hours', 'hours, with clock'],
  ['seconds', 'seconds, with clock'],
];
const times: readonly (readonly [string, string])[] = [
  ['0', 'automatic'],
  ['1', '1 second'],
  ['5', '5 seconds'],
  ['30', '30 seconds'],
  ['60', '1 minute'],
  ['600', '10 minutes'],
];

export interface Form {
  readonly element: HTMLElement;
  readonly go: HTMLButtonElement;
  /** @throws Error with a line that can be shown. */
  read(): Job;
  set(job: Job): void;
  /** Says below a list how it was read; `unit`: what its costs are, unless that is said already. */
  told(notes: readonly string[], unit: Unit | null): void;
  /** Selects these letters of the model, in sight. */
  mark(from: number, to: number): void;
  /** Writes a text in their place. */
  write(from: number, to: number, text: string): void;
  /** Shows the choice whether what met only in failed tests counts as tested. */
  trust(): void;
  /** Puts the element below the field of a key of the document; false if that is not to be seen. */
  show(key: string, element: HTMLElement): boolean;
}

/**
 * `reads` makes parts of what was pasted, or says why it cannot; `retimed` hears when days begin.
 */
export function jobForm(
  changed: () => void,
  submitted: () => void,
  reads: (text: string) => Promise<Part[] | null>,
  pickFile: () => void,
  retimed: (dayBegins: string) => void,
): Form {
  let source: Job['source'] = 'parts';
  const groups: Record<string, Group> = {};
  const touched = () => (refresh(), changed());
  const line = (placeholder: string) =>
    h('input', {
      type: 'text',
      placeholder,
      autocomplete: 'off',
      spellcheck: 'false',
      oninput: touched,
    });
  const area = (placeholder: string) =>
    h('textarea', { class: 'list-text', spellcheck: 'false', placeholder, oninput: touched });
  const cost = () =>
    h('input', { type: 'text', inputmode: 'decimal', class: 'cost', oninput: touched });

  /** What is said of a list or a model that was read, below it. */
  const told = {
    parts: h('div', { class: 'told', role: 'status' }),
    model: h('div', { class: 'told', role: 'status' }),
  };
  const grid = partsGrid(touched, reads, namedSlots);
  const slotNames = h('datalist', { id: 'slot-names' });
  const model = area(
    'OS: Debian, Windows 11\nBrowser: Firefox, Chrome, Edge\n\nIF [Browser] = "Edge" THEN [OS] ' +
      '= "Windows 11";',
  );
  model.addEventListener('input', () => fill(told.model));
  const title = h('input', { type: 'text', oninput: touched });
  /** Whether the room was said, and is not what every new job begins with. */
  let ownRoom = false;
  const atOnce = h('input', {
    type: 'number',
    placeholder: 'by slots',
    oninput: () => ((ownRoom = true), touched()),
  });
  const testCost = cost();
  const changeCost = cost();
  const unit = select('', units, touched);
  const seconds = select('0', times, touched);
  const slots = rowsTable<Slot>(
    'Slots',
    [
      { key: 'name', title: 'slot', label: 'Name of slot' },
      { key: 'least', title: 'at least', label: 'Least of slot', kind: 'number' },
      { key: 'most', title: 'at most', label: 'Most of slot', kind: 'number' },
    ],
    () => ({ name: '', least: '', most: '' }),
    touched,
  );
  const strength = select('2', strengths, touched);
  const pairMode = select(
    'all',
    pairModes,
    () => ((pairsField.hidden = pairMode.value === 'all'), touched()),
  );
  const pairs = area('Motor A, Cooler\nMotor B, Cooler');
  const pairsField = field('Pairs, two parts a line with a comma between', pairs);
  const never = area('');
  const mounted = line('');
  const start = line('');
  const first = area('');
  const weights = area('Gear pump, Motor A, 10\nVane pump, Motor A, 5');
  const budget = cost();
  const trustFailed = h('input', { type: 'checkbox', onchange: touched });
  const changeCosts = area('');
  const benches = benchFields(touched, retimed, {
    room: () => atOnce.value || 'by slots',
    testCost: () => testCost.value,
  });
  const aim = select(
    '',
    [
      ['', 'least cost'],
      ['tests', 'fewest tests'],
    ],
    touched,
  );
  const many = h('input', {
    type: 'number',
    min: 2,
    max: 1000,
    placeholder: '12',
    'aria-label': 'How many parts, to be called 1, 2, 3, …',
  });
  const aimField = field('Aim', aim);
  const go = h('button', { type: 'submit' }, 'Plan');
  const inBar = h('span', { class: 'plan-bar-said' });
  function showAim(): void {
    // The aims of several benches differ from those of one.
    aimField.hidden = source !== 'model' || benches.benches().length > 0;
  }
  function refresh(): void {
    Object.values(groups).forEach((group) => group.refresh());
    benches.refresh();
    showAim();
    inBar.textContent = barWords();
    model.rows = Math.min(15, Math.max(9, model.value.split('\n').length + 1));
  }
  /** What is planned, as far as it can be told while it is written. */
  function barWords(): string {
    const n = source === 'parts' ? grid.names().length : 0;
    const several = benches.said();
    const room = atOnce.value === '' ? '' : `${atOnce.value} at once`;
    return n === 0 ? several : join(count(n, 'part'), room, several);
  }

  /**
   * Slots that parts are of hold one part each until their limits are written: a slot that is named
   * is never passed over. A list of parts names slots without limits.
   */
  function namedSlots(names: string[]): void {
    const there = slots.read().filter(({ least, most }) => least !== '' || most !== '');
    const missing = names.filter((name) => !there.some((slot) => slot.name === name));
    if (missing.length > 0) {
      slots.set([...there, ...missing.map((name) => ({ name, least: '1', most: '1' }))]);
      groups['slots']!.element.open = true;
      groups['slots']!.refresh();
      atOnce.value = ownRoom ? atOnce.value : '';
    }
    fill(
      slotNames,
      names.map((name) => h('option', { value: name })),
    );
  }

  function group(
    name: string,
    heading: string,
    said: () => string,
    ...content: (HTMLElement | null)[]
  ): HTMLDetailsElement {
    const made = folded(heading, said, ...content);
    groups[name] = made;
    return made.element;
  }
  const lines = (text: string) => {
    try {
      return cells(text).length;
    } catch {
      return text.trim().split('\n').length; // It is said when it is planned.
    }
  };
  const some = (text: string, what: string) => (text.trim() === '' ? '' : count(lines(text), what));
  const join = (...words: string[]) => words.filter((word) => word !== '').join(', ');
  const span = ({ name, least, most }: Slot) =>
    least === '' && most === ''
      ? ''
      : `${name} ${least === most ? most : `${least || '0'}–${most || '∞'}`}`;
  const check = (input: HTMLInputElement, text: string) =>
    h('label', { class: 'check' }, input, text);

  const onlyParts: HTMLElement[] = [
    group(
      'slots',
      'Slots',
      () => join(...slots.read().map(span)),
      h(
        'p',
        { class: 'hint' },
        'A server has exactly one processor and two to four disks: name the slot of each part ' +
          'in the list, and write here how many parts of it a set-up has. It is one until you ' +
          'write another number; an empty field sets no limit.',
      ),
      slots.element,
    ),
  ];
  const meeting = group(
    'pairs',
    'What must meet',
    () =>
      join(
        strength.value === '3' ? 'every three' : '',
        pairMode.value === 'all' ? '' : some(pairs.value, 'pair'),
        never.value.trim() === '' ? '' : `${lines(never.value)} forbidden`,
      ),
    field('Tested together', strength),
    field('Pairs', pairMode),
    pairsField,
    field(
      'Must never be in one set-up',
      never,
      'two a line; after a comma or a colon why, which is printed',
    ),
  );
  const mounting = group(
    'mounted',
    'What is mounted',
    () =>
      join(
        some(mounted.value, '') === '' ? '' : `always ${mounted.value.trim()}`,
        start.value.trim() === '' ? '' : `now ${start.value.trim()}`,
      ),
    field('', mounted),
    field('', start, 'is not paid for in the first test'),
  );
  const order = group(
    'budget',
    'Budget, priorities, first tests',
    () =>
      join(
        budget.value.trim() === '' ? '' : `budget ${budget.value.trim()}`,
        some(weights.value, 'priority').replace('prioritys', 'priorities'),
        some(first.value, 'first test'),
      ),
    field('Budget', budget, 'test as much as this pays for; empty: test everything'),
    field(
      'What pairs are worth: two parts and a number a line',
      weights,
      'others are worth 1; heavy pairs come early, or first within a budget',
    ),
    field('Set-ups to run first, one a line', first),
    check(trustFailed, 'What met only in failed tests counts as tested'),
  );
  const severalBenches = group('benches', 'Several benches', benches.said, ...benches.content);
  const replacing = group(
    'change_costs',
    'Costs by what is replaced',
    () => some(changeCosts.value, 'row'),
    field(
      'Costs',
      changeCosts,
      'of parts: a square table, a row for what is taken out, a column for what is put in; of ' +
        'a model: parameter, value, cost a line',
    ),
  );

  const partsSection = h(
    'section',
    { 'aria-label': 'Parts' },
    h(
      'p',
      { class: 'hint' },
      'Type names, or paste a table from a spreadsheet into the first field.',
    ),
    grid.element,
    told.parts,
    h(
      'div',
      { class: 'row list-tools' },
      h('button', { type: 'button', class: 'plain', onclick: pickFile }, 'Open a file …'),
      h(
        'button',
        {
          type: 'button',
          class: 'plain',
          onclick: () => (grid.set([]), fill(told.parts), touched()),
        },
        'Clear the list',
      ),
      h(
        'span',
        { class: 'together' },
        many,
        h(
          'button',
          {
            type: 'button',
            class: 'plain',
            onclick: () => (
              grid.set(
                Array.from({ length: Math.min(1000, Number(many.value || 12)) }, (_, i) =>
                  partOf(String(i + 1)),
                ),
              ),
              touched()
            ),
          },
          'Fill in numbered parts',
        ),
      ),
    ),
  );
  const modelSection = h(
    'section',
    { 'aria-label': 'Model', class: 'model' },
    field('Parameters, values and rules, as PICT or ACTS write them', model),
    h(
      'div',
      { class: 'row' },
      h('button', { type: 'button', class: 'plain', onclick: pickFile }, 'Open a file …'),
    ),
    told.model,
  );
  const choices = (['parts', 'model'] as const).map((name) => {
    const input = h('input', {
      type: 'radio',
      name: 'source',
      value: name,
      onchange: () => (setSource(name), touched()),
    });
    return [
      input,
      h('label', {}, input, name === 'parts' ? 'Parts' : 'Parameters with values'),
    ] as const;
  });
  const atOnceField = field('How many fit at once', atOnce);
  function setSource(next: Job['source']): void {
    source = next;
    choices.forEach(([input]) => (input.checked = input.value === next));
    partsSection.hidden = next !== 'parts';
    modelSection.hidden = next !== 'model';
    reword(next, { changeCost, unit, never, mounted, start, first });
    mounting.querySelector('.group-name')!.textContent =
      next === 'parts' ? 'What is mounted' : 'Fixed values';
    benches.reword(next);
    showAim();
    atOnceField.hidden = next !== 'parts';
    replacing.querySelector('.group-name')!.textContent =
      next === 'parts' ? 'Costs by what is replaced' : 'Costs of values';
    [pairMode.parentElement!, ...onlyParts].forEach(
      (element) => (element.hidden = next !== 'parts'),
    );
    pairsField.hidden = next !== 'parts' || pairMode.value === 'all';
  }

  const element = h(
    'form',
    {
      class: 'plan-form no-print',
      novalidate: true, // What is wrong is said where it is, in our words.
      onsubmit: (event) => (event.preventDefault(), submitted()),
    },
    slotNames,
    h(
      'div',
      { class: 'plan-input' },
      h(
        'div',
        { class: 'plan-what' },
        h(
          'div',
          { class: 'source', role: 'radiogroup', 'aria-label': 'What is combined' },
          choices.map(([, label]) => label),
        ),
        partsSection,
        modelSection,
      ),
      h(
        'section',
        { 'aria-label': 'Costs and rules' },
        h(
          'div',
          { class: 'fields' },
          atOnceField,
          field('Cost of a test', testCost),
          field('Cost of a change', changeCost, ' '),
          field('Costs are', unit),
          field('Title of the sheet', title),
          field('Time to search', seconds),
          aimField,
        ),
      ),
    ),
    h('h2', { class: 'more-rules' }, 'Options'),
    h(
      'div',
      { class: 'plan-options' },
      h('div', {}, onlyParts[0]!, meeting, mounting),
      h('div', {}, severalBenches, order, replacing),
    ),
    h('div', { class: 'plan-bar' }, go, inBar),
  );
  /** What each key of a request is written into. */
  const controls: Record<string, HTMLElement> = {
    at_once: atOnce,
    test_cost: testCost,
    change_cost: changeCost,
    unit,
    title,
    seconds,
    parts: grid.element,
    model,
    slots: slots.element,
    slot: slots.element,
    pairs,
    strength,
    never,
    mounted,
    start,
    budget,
    weights,
    first,
    ...benches.controls,
    change_costs: changeCosts,
  };

  return {
    element,
    go,
    read() {
      if (atOnce.validity.badInput) {
        throw new FieldFault('How many fit at once: write a whole number.', 'at_once');
      }
      namesIn(mounted.value); // Throws for what cannot be a list.
      return {
        title: title.value.trim() || 'Run sheet',
        source,
        parts: source === 'parts' ? grid.read() : [],
        model: source === 'model' ? model.value : '',
        atOnce: atOnce.value === '' ? null : Number(atOnce.value),
        testCost: decimal(testCost.value, 'Cost of a test'),
        changeCost: decimal(changeCost.value, 'Cost of a change'),
        unit: unit.value as Unit,
        strength: Number(strength.value),
        pairMode: source === 'parts' ? (pairMode.value as PairMode) : 'all',
        pairs: pairs.value,
        slots: slots.read(),
        never: never.value,
        mounted: mounted.value,
        start: start.value,
        first: first.value,
        weights: weights.value,
        budget: budget.value,
        changeCosts: changeCosts.value,
        ...benches.read(),
        objective: aimField.hidden ? benches.aim() : (aim.value as Job['objective']),
        trustFailed: trustFailed.checked,
        seconds: Number(seconds.value),
      };
    },
    set(job) {
      slots.set(job.slots);
      grid.set(job.parts);
      benches.set(job);
      const texts = {
        model,
        title,
        pairs,
        never,
        mounted,
        start,
        first,
        weights,
        budget,
        changeCosts,
      };
      for (const [key, control] of Object.entries(texts)) {
        control.value = job[key as keyof typeof texts];
      }
      atOnce.value = job.atOnce === null ? '' : String(job.atOnce);
      testCost.value = String(job.testCost);
      changeCost.value = String(job.changeCost);
      unit.value = job.unit;
      strength.value = String(job.strength);
      pairMode.value = job.pairMode;
      aim.value = job.objective === 'tests' ? 'tests' : '';
      trustFailed.checked = job.trustFailed;
      seconds.value = times.some(([value]) => value === String(job.seconds))
        ? String(job.seconds)
        : '0';
      ownRoom = job.atOnce !== null && job.atOnce !== emptyJob().atOnce;
      namedSlots([...new Set(job.parts.map(({ slot }) => slot))].filter((slot) => slot !== ''));
      setSource(job.source);
      refresh();
      fill(told.parts);
      fill(told.model);
    },
    told(notes, named) {
      fill(
        told[source],
        notes.map((note) => h('p', { class: 'hint' }, note)),
      );
      if (named && unit.value === '') {
        unit.value = named;
        told[source].append(h('p', { class: 'hint' }, `Costs are ${named}, as the heading says.`));
      }
    },
    mark(from, to) {
      model.focus({ preventScroll: true });
      model.setSelectionRange(from, to);
      const line = model.value.slice(0, from).split('\n').length;
      model.scrollTop = (model.scrollHeight * (line - 3)) / model.value.split('\n').length;
    },
    write(from, to, text) {
      model.setRangeText(text, from, to, 'end');
      model.focus();
      fill(told.model);
      touched();
    },
    trust() {
      groups['budget']!.element.open = true;
      lead(trustFailed, groups['budget']!.element, 'center');
    },
    show(key, element) {
      const control = controls[key];
      const labelled = control?.closest<HTMLElement>('.field');
      const place = labelled ?? control;
      if (!place || place.closest('[hidden]')) {
        return false;
      }
      const inside = place.closest('details.group') as HTMLDetailsElement | null;
      if (inside) {
        inside.open = true;
      }
      labelled ? labelled.append(element) : place.after(element);
      return true;
    },
  };
}
