// The benches of a job, one a card, with what is different there.
import { emptyBench, type Bench } from './job';
import { rowsTable } from './rows';

export function benchTable(touched: () => void): ReturnType<typeof rowsTable<Bench>> {
  return rowsTable<Bench>(
    'Benches',
    [
      { key: 'name', title: 'bench', label: 'Name of bench' },
      { key: 'hours', title: 'hours a day', label: 'Hours a day of bench', kind: 'number' },
      {
        key: 'atOnce',
        title: 'room',
        label: 'How many parts fit on bench',
        kind: 'number',
        hint: 'How many parts fit there, if not as many as everywhere',
      },
      {
        key: 'without',
        title: 'cannot have',
        label: 'Parts that cannot be on bench',
        hint: 'Parts that cannot be mounted there; of a model values that it cannot have',
      },
      {
        key: 'start',
        title: 'is on it now',
        label: 'What is now on bench',
        hint: 'Parts that are there before its first test',
      },
      {
        key: 'own',
        title: 'has its own',
        label: 'Own parts of bench',
        hint: 'Parts of which this bench has its own piece',
      },
      {
        key: 'mounted',
        title: 'always has',
        label: 'What stays on bench',
        hint: 'Parts that stay mounted there',
      },
      { key: 'slots', title: 'slots', label: 'Slots of bench', hint: 'disk=2..4, CPU=1' },
      { key: 'testCost', title: 'test costs', label: 'Test cost of bench', kind: 'number' },
      {
        key: 'changeFactor',
        title: 'changes ×',
        label: 'Factor of change costs of bench',
        kind: 'number',
        hint: '2: a change costs twice as much there',
      },
      {
        key: 'down',
        title: 'failed',
        label: 'Out of order, bench',
        kind: 'check',
        hint: 'It is out of order: no test is planned for it',
      },
    ],
    emptyBench,
    touched,
    'cards',
  );
}
