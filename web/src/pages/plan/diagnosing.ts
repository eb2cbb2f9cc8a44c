// What the failed tests say, asked for once and kept in sight until results change.
import type { Diagnosis } from '../../lib/api';
import { fill, h } from '../../lib/dom';
import { diagnosisPanel } from './diagnosis';
import { partWords } from './insertion';
import { namesOf, testName, verdictOf, type Outcome } from './outcome';

export interface Asks {
  /** @throws Error with a line that can be shown. */
  ask(): Promise<Diagnosis>;
  /** Puts the test that tells most on the sheet. */
  add(next: NonNullable<Diagnosis['next']>): void;
  /** Forbids pairs that fail together, and plans anew. */
  forbid(faults: string[][]): void;
  fail(fault: unknown): void;
}

/** The results, in any order of the tests. */
const resultsOf = ({ tests }: Outcome): string =>
  JSON.stringify(
    tests
      .filter((test) => verdictOf(test) !== '')
      .map((test) => [test.bench, [...test.parts].sort(), verdictOf(test)])
      .map((row) => JSON.stringify(row))
      .sort(),
  );

export class Diagnosing {
  readonly element = h('div', { class: 'diagnosis-place' });
  private found: { diagnosis: Diagnosis; results: string } | null = null;

  constructor(private readonly asks: Asks) {}

  async ask(outcome: Outcome): Promise<void> {
    const results = resultsOf(outcome);
    try {
      fill(this.element, h('p', { class: 'hint', role: 'status' }, 'Weighing the results …'));
      this.found = { diagnosis: await this.asks.ask(), results };
      this.show(outcome);
      this.element.scrollIntoView({ block: 'nearest' });
    } catch (fault) {
      this.forget();
      this.asks.fail(fault);
    }
  }

  forget(): void {
    this.found = null;
    fill(this.element);
  }

  /** After the sheet or its results have changed. */
  refresh(outcome: Outcome): void {
    if (this.found && this.found.results !== resultsOf(outcome)) {
      this.forget();
    }
  }

  /** The same on a new sheet, as long as its results are those that were asked about. */
  show(outcome: Outcome): void {
    this.refresh(outcome);
    if (!this.found) {
      fill(this.element);
      return;
    }
    const { diagnosis } = this.found;
    const names = namesOf(outcome);
    fill(
      this.element,
      diagnosisPanel(
        diagnosis,
        outcome.tests.flatMap((test, i) =>
          verdictOf(test) === 'fail'
            ? [{ name: testName(test, names[i]!), parts: test.parts }]
            : [],
        ),
        partWords(outcome),
        outcome.tests.some(({ values }) => values) ? 'values' : 'parts',
        () => (this.forget(), this.asks.add(diagnosis.next!)),
        (faults) => (this.forget(), this.asks.forbid(faults)),
      ),
    );
  }
}
