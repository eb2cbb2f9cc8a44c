// The benches of a job, one a card, with what is different there.
import { emptyBench, type Bench } from './job';
import { rowsTable } from './rows';

/** `usual`: what a bench has where its own field is empty. */
export function benchTable(
  touched: () => void,
  usual: { hours: () => string; room: () => string; testCost: () => string },
): ReturnType<typeof rowsTable<Bench>> {
  return rowsTable<Bench>(
    'Benches',
    [
      { key: 'name', title: 'bench', label: 'Name of bench', placeholder: 'name' },
      {
        key: 'hours',
        title: 'hours a day',
        label: 'Hours a day of bench',
        kind: 'number',
        placeholder: usual.hours,
      },
      {
        key: 'atOnce',
        title: 'room',
        label: 'How many parts fit on bench',
        kind: 'number',
        placeholder: usual.room,
        hint: 'How many parts fit there, if not as many as everywhere',
      },
      {
        key: 'start',
        title: 'is on it now',
        label: 'What is now on bench',
        placeholder: 'nothing',
        hint: 'Parts that are there before its first test, with commas between them',
      },
      {
        key: 'without',
        title: 'cannot have',
        label: 'Parts that cannot be on bench',
        placeholder: 'has all',
        hint: 'Parts that cannot be mounted there; of a model values that it cannot have',
        rare: true,
      },
      {
        key: 'own',
        title: 'has its own',
        label: 'Own parts of bench',
        placeholder: 'parts only here',
        hint: 'Parts of which this bench has its own piece, which no other bench waits for',
        rare: true,
      },
      {
        key: 'mounted',
        title: 'always has',
        label: 'What stays on bench',
        placeholder: 'nothing',
        hint: 'Parts that stay mounted there',
        rare: true,
      },
      {
        key: 'slots',
        title: 'slots',
        label: 'Slots of bench',
        placeholder: 'disk=2..4',
        hint: 'disk=2..4, CPU=1',
        rare: true,
      },
      {
        key: 'testCost',
        title: 'test costs',
        label: 'Test cost of bench',
        kind: 'number',
        placeholder: usual.testCost,
        rare: true,
      },
      {
        key: 'changeFactor',
        title: 'changes ×',
        label: 'Factor of change costs of bench',
        kind: 'number',
        placeholder: '1',
        hint: '2: a change costs twice as much there',
        rare: true,
      },
      {
        key: 'down',
        title: 'out of order',
        label: 'Out of order, bench',
        kind: 'check',
        hint: 'No test is planned for it',
        rare: true,
      },
    ],
    emptyBench,
    touched,
    'cards',
  );
}
