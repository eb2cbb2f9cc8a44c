// How long an automatic search may bring nothing.
import type { PlanJob } from '../../lib/api';
import type { Outcome } from './outcome';

/** Seconds. */
const leastPatience = 15;

/** Of a search that goes on as long as it brings something: how long it may bring nothing. */
export class Patience {
  private best = Infinity;
  private since = 0;
  private waited = 0;

  constructor(private readonly ends: boolean) {}

  /** Whether nothing came for as long as it took to get there, and for some seconds at least. */
  isOut({ best, seconds }: PlanJob): boolean {
    if (!this.ends || best === null || this.waited > 0) {
      return false;
    }
    if (best < this.best) {
      this.best = best;
      this.since = seconds;
    }
    const waited = seconds - this.since;
    this.waited = waited > Math.max(leastPatience, this.since) ? Math.floor(waited) : 0;
    return this.waited > 0;
  }

  /** The plan says so if it was. */
  noted(outcome: Outcome): Outcome {
    const note = `nothing better came for ${this.waited} seconds`;
    return this.waited > 0 ? { ...outcome, notes: [...outcome.notes, note] } : outcome;
  }
}
