// Made by types.mjs of docs/schema: ./dev web build writes it anew.

export type Kind = 'linear' | 'circular';
export type Block = number[];
export type Job = {
  format?: 'changeover-job/1';
  /** CSV or .xlsx: one part per line, optionally with its change cost */
  parts?:
    | (
        | number
        | (
            | string
            | {
                name: string | number | null;
                cost?: string | number | null;
                slot?: string | number | null;
                quantity?: string | number | null;
              }
          )[]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** instead of parts: parameters with their values and rules, in the language of PICT or ACTS */
  model?: (string | {file: string} | {text: string}) | null;
  /** the first row of the parts list has the names of the columns */
  header?: boolean | null;
  /** the first row of the parts list is a part */
  no_header?: boolean | null;
  /** name of the column of the parts list with the change costs, or - for none */
  cost_column?: string | null;
  /** use N parts named 1 to N */
  items?: number | null;
  /** how many parts fit at once (default: as many as the slots hold) */
  at_once?: number | null;
  /** cost of one test */
  test_cost?: (number | string) | null;
  /** what mounting a part costs where the list does not say */
  change_cost?: (number | string) | null;
  /**
   * a square table: cost of replacing the part of the row by the part of the column; of a model:
   * one parameter,value,cost per line
   */
  change_costs?:
    | (
        | [string | number | null, ...(string | number | null)[]][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** unit of all costs; with a unit of time, the sheet shows a clock (default: as the list says) */
  cost_unit?: ('money' | 'seconds' | 'minutes' | 'hours') | null;
  /** 2: every two parts must meet; 3: every three (default: 2) */
  strength?: number | null;
  /** pairs that must meet (default: all) */
  pairs?:
    | (
        | [string | number | null, string | number | null][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** pairs that must never share a set-up, one A,B,why per line (why may be left out) */
  never?:
    | (
        | [string | number | null, string | number | null]
        | [string | number | null, string | number | null, string | number | null][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** how many parts a set-up has in each slot, one slot,least,most per line */
  slots?:
    | (
        | {
            name: string | number | null;
            least?: string | number | null;
            most?: string | number | null;
          }[]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** the same in one line, e.g. CPU=1,disk=2..4,fan=..2 */
  slot?: string | null;
  /** parts that stay mounted in every set-up */
  mounted?: (string | number | null)[] | null;
  /** parts that are mounted before the first test */
  start?: (string | number | null)[] | null;
  /** set-ups to run first, in this order, the parts of one per line */
  first?:
    | (
        | (
            | [string | number | null, ...(string | number | null)[]]
            | {
                /** @minItems 1 */
                parts: [string | number | null, ...(string | number | null)[]];
                bench?: string | number | null;
              }
          )[]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** what pairs are worth, one A,B,weight per line (default: each is worth 1) */
  weights?:
    | (
        | [string | number | null, string | number | null, string | number | null][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** test as many pairs as this pays for */
  budget?: (number | string) | null;
  /** tests already run (one set-up per line, or a run sheet); plans the remaining tests */
  done?:
    | (
        | (
            | (string | number | null)[]
            | {
                parts: (string | number | null)[];
                result?: string | null;
                bench?: string | number | null;
              }
          )[]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** only the first N of them were done (default: all) */
  done_first?: number | null;
  /** pairs that met only in tests that did not pass count as tested, and are not needed again */
  trust_failed?: boolean | null;
  /**
   * parts, or values of a model, that can no longer be used; tests already run with them still
   * count
   */
  without?: (string | number | null)[] | null;
  /** how many benches work side by side, or a file that lists them, one per line */
  benches?:
    | (
        | number
        | (
            | string
            | {
                name?: string | number | null;
                at_once?: string | number | null;
                test_cost?: string | number | null;
                change_factor?: string | number | null;
                slots?:
                  | (string | number | null)
                  | {
                      name: string | number | null;
                      least?: string | number | null;
                      most?: string | number | null;
                    }[];
                mounted?: (string | number | null) | (string | number | null)[];
                start?: (string | number | null) | (string | number | null)[];
                own?: (string | number | null) | (string | number | null)[];
                without?: (string | number | null) | (string | number | null)[];
                hours?: string | number | null;
                down?: boolean | string | null;
              }
          )[]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /**
   * of several benches: the earliest end of the last test (makespan) or the least cost together;
   * of a model, on one bench or several: the least cost or the fewest tests (default: makespan of
   * benches, cost of a model on one)
   */
  objective?: ('makespan' | 'cost' | 'tests') | null;
  /** hours of work a day, for benches that give none; costs are then in hours */
  hours?: (number | string) | null;
  /** the day of the first tests, e.g. 2025-03-31; steps then have dates */
  first_day?: string | null;
  /** work on Saturdays and Sundays, too */
  weekends?: boolean | null;
  /** show which plan is cheapest at which ratio of change cost to test cost */
  what_if?: boolean | null;
  /** leave out the complete set-ups; print in two columns */
  compact?: boolean | null;
  /** swap interchangeable parts at random, with this seed */
  shuffle?: number | null;
  /** find the part or pair that explains the failed tests, and the next test to run */
  diagnose?: boolean | null;
  /** the heading of the run sheet */
  title?: string | null;
  /** moves of each local search (default: chosen automatically) */
  steps?: number | null;
  /**
   * how long to search (default: command line: 60; server: 10, at most 60 (followed: 60, at most
   * 3600); Python: until it ends)
   */
  seconds?: number | null;
  /** threads to use (default: command line: all cores; Python: 1) */
  threads?: number | null;
  /** seed of the random numbers (default: 1) */
  seed?: number | null;
};
export type LoadRequest = {
  format?: 'changeover-load-request/1';
  /** items, e.g. partitions of a file */
  items?: number | null;
  /** how many items fit in memory at once */
  room?: number | null;
  /**
   * only the pairs listed there, two items per line (text, CSV, .xlsx); "-": standard input; with
   * --workers a third column may say what a pair costs
   */
  pairs?:
    | (
        | [string | number | null, string | number | null]
        | [string | number | null, string | number | null, string | number | null][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** only the pairs within the groups listed there, one group of items per line */
  groups?:
    | (
        | [string | number | null, ...(string | number | null)[]][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** each of the P items with each of B others */
  against?: number | null;
  /** the pairs of the first N items are done */
  done_items?: number | null;
  /** number of the items in memory that fit on an accelerator, where pairs meet */
  fast_room?: number | null;
  /** bytes an item, to say how many are moved */
  item_bytes?: number | null;
  /**
   * items differ in size: an item and its bytes per line, or the bytes of items 0, 1, … in turn;
   * --memory says how many fit
   */
  sizes?:
    | (
        | ((string | number) | [string | number | null, string | number | null])[]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** bytes in memory at once, of items with --sizes */
  memory?: number | null;
  /** bytes of the memory that fit on an accelerator, where pairs meet */
  fast_memory?: number | null;
  /** split it for W workers with room C each (default: 1) */
  workers?: number | null;
  /** only the steps of worker I of these, from 0 */
  worker?: number | null;
  /** spread pairs evenly over the workers that have them (default: yes) */
  balance?: boolean | null;
  /** the first worker that has a pair computes it */
  first_holder?: boolean | null;
  /**
   * what pairs cost to compute, two items and a number per line; costs are spread evenly over
   * workers (default: 1 each)
   */
  pair_cost?:
    | (
        | [string | number | null, string | number | null, string | number | null][]
        | {file: string}
        | {text: string}
        | {workbook: string; sheet?: string}
      )
    | null;
  /** begin at step N, which loads all that is in memory then; not for workers or new pairs */
  from_step?: number | null;
  /**
   * every pair meets in each of N epochs, back and forth: what is in memory at the end of one
   * stays for the next (default: 1)
   */
  epochs?: number | null;
  /**
   * begin at once: steps are read while they are written, and the end says whether they are right
   */
  verify_beside?: boolean | null;
  /** workers step together and never hold one item twice, so that items may change */
  disjoint?: boolean | null;
  /** items change while they are held: say what is stored when */
  write_back?: boolean | null;
  /** say what is computed when, so that loads overlap computation */
  prefetch?: boolean | null;
  /** say of each step which pairs are computed */
  new_pairs?: boolean | null;
  /** pairs both ways: (i,j) and (j,i) */
  ordered?: boolean | null;
  /** each item with itself, too: (i,i) */
  self?: boolean | null;
  /** pairs of a step in random order, by --seed */
  shuffle?: boolean | null;
  /** each pair at random in one of the steps that hold both items, evenly, by --seed */
  spread?: boolean | null;
  /**
   * how long to search for a better order (default: command line: no search; server: no search, at
   * most 30; Python: no search)
   */
  seconds?: number | null;
  /** threads to use (default: command line: all cores; Python: 1) */
  threads?: number | null;
  /** seed of the random numbers (default: 1) */
  seed?: number | null;
};
export type Loads = Head | Step;
export type Status = 'minimum' | 'best-known' | 'impossible' | 'open';
export type SearchWay = 'local' | 'exact' | 'base-blocks' | 'locked';
/** The names of one or two elements where all others are numbers: perhaps a slip. */
export type NamesAmongNumbers = string[];

export interface Documents {
  benches: Benches;
  design: Design;
  diagnosis: Diagnosis;
  dossier: Dossier;
  job: Job;
  'load-request': LoadRequest;
  loads: Loads;
  plan: Plan;
  'what-if': WhatIf;
  explorer: Explorer;
  verify: Verify;
  refusal: Refusal;
}
export interface Benches {
  format: 'changeover-benches/1';
  title: string;
  benches: number;
  objective: 'makespan' | 'cost' | 'tests';
  cost: number;
  makespan: number;
  tests: number;
  changes: number;
  pairs_needed: number;
  pairs_tested: number;
  triples_needed: number;
  triples_tested: number;
  lower_bound: {
    cost: number;
    tests: number;
    makespan: number;
    cost_reason: string;
    makespan_reason: string;
    finish?: {day: number; hour: number; date?: string};
  };
  budget: number | null;
  tests_done: number;
  met_only_in_failed: number;
  trust_failed: boolean;
  weight: {needed: number; tested: number; most: number | null} | null;
  stock: {name: string; quantity: number}[];
  finish?: {day: number; hour: number; date?: string};
  cost_unit: null | 'seconds' | 'minutes' | 'hours';
  places: {number: number; slot: null | string}[];
  parameters?: {
    name: string;
    values: {value: string; part: string; names: string[]; out_of_range: boolean}[];
  }[];
  proved_fewest_tests?: boolean;
  rules?: number;
  sheets: {
    bench: number;
    name: string;
    down: boolean;
    tests_done: number;
    start: string[];
    hours: number | null;
    tests: number;
    changes: number;
    cost: number;
    end: number;
    steps: {
      step: number;
      values?: {[k: string]: string};
      take_out: string[];
      put_in: string[];
      set_up: string[];
      places: (null | string)[];
      new_pairs?: number;
      cost: number;
      cost_so_far: number;
      new_triples?: number;
      replaced?: string[][];
      begin: number;
      end: number;
      day?: number;
      hour?: number;
      date?: string;
      finish?: {day: number; hour: number; date?: string};
      again?: string[];
    }[];
  }[];
  handovers: {
    part: string;
    from: string;
    to: string;
    step: number;
    early: boolean;
    after: number | null;
  }[];
  candidates: {
    name: string;
    how: string;
    tests: number;
    changes: number;
    cost: number;
    makespan: number;
    pairs_tested: number;
    triples_tested: number;
  }[];
  /**
   * why the search ended: nothing better is possible, it was over by itself, a clock stopped it or
   * a part of it, or the user did
   */
  why_stopped: 'found' | 'step limit' | 'time limit' | 'interrupted';
  notes: string[];
}
export interface Design {
  format: 'changeover-design/1';
  v: number;
  k: number;
  change: number;
  kind: Kind;
  /** 2 if it is left out. */
  strength?: number;
  /** In order, each k numbers from 0 to v-1. */
  blocks: Block[];
  /** Names of the elements 0 to v-1; without them they are numbers. */
  labels?: string[];
  recipe?: Recipe;
  verdict?: Verdict;
  /** Its label in the catalog, or null. Only the server says it. */
  label?: string | null;
}
/** How it is made: `changeover design --recipe` builds the same blocks. */
export interface Recipe {
  construction: string;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  /** 2 if it is left out. */
  strength?: number;
  arguments: {[k: string]: number};
  /** The designs that it is made of. */
  inputs: Recipe[];
  /** Lists of numbers that belong to the recipe: blocks, positions or elements. */
  blocks?: number[][];
  provenance?: string;
}
/** What the verifier found. What reads a design does not believe it. */
export interface Verdict {
  valid: boolean;
  /** Every pair is newly covered exactly once. */
  tight: boolean;
  /** It has as many blocks as the counting bound. */
  economical: boolean;
  b: number;
  /** No design with these parameters has fewer blocks. */
  lower_bound: number;
  minimum: 'proved' | 'unknown';
}
export interface Diagnosis {
  format: 'changeover-diagnosis/1';
  passed: number;
  failed: number;
  unread: number;
  first_unread: {place: string; result: string}[];
  notes: string[];
  faults: [string] | [string, string][];
  suspects: [string] | [string, string][];
  at_least: number;
  explanations_known: number;
  all_explanations: boolean;
  /** @maxItems 100 */
  explanations: [string] | [string, string][][];
  looked_at: string[] | null;
  contradictions: {failed: string[]; passed: string[] | null}[];
  next: null | {
    set_up: string[];
    take_out: string[];
    put_in: string[];
    places: {number: number; part: null | string}[];
    cost: number;
    proves: [string] | [string, string] | null;
    why: string;
    if_it_fails: {
      left: number;
      /** @maxItems 100 */
      explanations: [string] | [string, string][][];
    };
    if_it_passes: {
      left: number;
      /** @maxItems 100 */
      explanations: [string] | [string, string][][];
    };
  };
  least_tests: number;
}
export interface Dossier {
  format: 'changeover-dossier/1';
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength: number;
  b: number;
  /** A sentence: what there is. */
  statement: string;
  /** Tight, economical, minimum, and by which bound. */
  quality: string;
  /** How the program verified it. */
  verified: string;
  status: 'minimum' | 'best-known';
  /** In the catalog; null if it is not there. */
  label: string | null;
  credit: string | null;
  /** SHA-256 of the blocks: one block per line, elements separated by a blank. */
  hash: string;
  /**
   * Every lower bound, the largest first.
   *
   * @minItems 1
   */
  bounds: [
    {lower_bound: number; name: string; reason: string},
    ...{lower_bound: number; name: string; reason: string}[]
  ];
  /** A publication that reports fewer blocks. */
  reported: {blocks: number; cites: string} | null;
  /**
   * The constructions of the recipe, the outermost first.
   *
   * @minItems 1
   */
  steps: [
    {
      /** How many constructions it stands within. */
      depth: number;
      design: string;
      how: string;
      citation: string;
    },
    ...{
      /** How many constructions it stands within. */
      depth: number;
      design: string;
      how: string;
      citation: string;
    }[]
  ];
  recipe: Recipe;
  /** Null where there are more than 600, or more than 6,000 elements in all of them. */
  blocks: number[][] | null;
  /**
   * Commands that write the design and check it, and the proof that there is none with fewer blocks.
   *
   * @minItems 2
   */
  check: [string, string, ...string[]];
  /** Keys of docs/references.bib. */
  cites: string[];
  bibtex: string;
}
/** The first line: the schedule as a whole. */
export interface Head {
  format: 'changeover-loads/1';
  items: number;
  room: number;
  /** All pairs meet in each of them. */
  epochs?: number;
  /** The loads of each epoch. */
  epoch_loads?: number[];
  wanted?: string;
  wanted_pairs?: number;
  fast_room?: number;
  /** Bytes in memory at once, if items have sizes; room is the most items that fit then. */
  memory?: number;
  /** The most that are in memory at once. */
  most_bytes?: number;
  /** No order loads fewer bytes. */
  bytes_bound?: number;
  bytes_bound_reason?: string;
  /** With sizes and two levels: bytes on the accelerator. */
  fast_memory?: number;
  /** No order transfers fewer bytes to the accelerator. */
  transfer_bytes_bound?: number;
  transfer_bytes_bound_reason?: string;
  /** With workers: of the one that loads most bytes. */
  makespan_bytes?: number;
  /** With --disjoint: the bytes of the slowest worker of each step, added up. */
  span_bytes?: number;
  /** However it is split, some worker loads so many bytes. */
  makespan_bytes_bound?: number;
  makespan_bytes_bound_reason?: string;
  loads: number;
  transfers?: number;
  steps: number;
  lower_bound: number;
  lower_bound_reason: string;
  transfer_bound?: number;
  transfer_bound_reason?: string;
  item_bytes?: number;
  bytes_loaded?: number;
  bytes_transferred?: number;
  group_items?: number;
  method?: string;
  explanation: string;
  workers?: number;
  makespan?: number;
  span?: number;
  makespan_bound?: number;
  makespan_bound_reason?: string;
  /** How many pairs the worker with most of them computes, and the mean. */
  pairs_per_worker?: {max: number; mean: number};
  /** Some worker computes so many at least. */
  pairs_per_worker_bound?: number;
  /** The same of what pairs cost, if that was said. */
  cost_per_worker?: {max: number; mean: number};
  /** Only its steps follow. */
  worker?: number;
  /** The steps begin with this one, which loads what is in memory then. */
  from_step?: number;
  groups?: number;
  order_room?: number;
  /** With prefetch, if a place is kept for what loads: no order for order_room has fewer loads. */
  order_bound?: number;
  order_bound_reason?: string;
  /** The same with workers: for order_room some worker has so many loads, however it is split. */
  order_makespan_bound?: number;
  order_makespan_bound_reason?: string;
  /** With prefetch and sizes: the bytes that are used; the others are for what loads. */
  order_memory?: number;
  pairs?: number;
  /** --time was too short for all that is done without it. */
  time_is_up?: true;
  /**
   * With prefetch at two levels: so many loads start in a step before the first transfer of the
   * item.
   */
  loads_ahead?: number;
  overlapped?: number;
  /** How many pairs the fullest step computes, of one worker, and the mean. */
  pairs_per_step?: {max: number; mean: number};
  stores?: number;
  store_bound?: number;
  disjoint?: true;
  gap?: number;
  verified: string;
  worker_loads?: number[];
  /** What each worker loads, if items have sizes. */
  worker_bytes?: number[];
  /** What each worker computes. */
  worker_pairs?: number[];
  /** What these pairs cost, if that was said. */
  worker_costs?: number[];
}
/**
 * Each other line: a step, of one worker if there are several. What is evicted goes before what is
 * loaded comes.
 */
export interface Step {
  worker?: number;
  /** From 1, if there are several. */
  epoch?: number;
  step: number;
  /** Items: Its number, or its name where pairs are listed by names. */
  load: (number | string)[];
  /** Items: Its number, or its name where pairs are listed by names. */
  evict: (number | string)[];
  /** Items: Its number, or its name where pairs are listed by names. */
  store?: (number | string)[];
  /** Items: Its number, or its name where pairs are listed by names. */
  fast_evict?: (number | string)[];
  /** Items: Its number, or its name where pairs are listed by names. */
  fast_load?: (number | string)[];
  /** Items: Its number, or its name where pairs are listed by names. */
  evict_first?: (number | string)[];
  /** Items: Its number, or its name where pairs are listed by names. */
  evict_late?: (number | string)[];
  before?: [number | string, number | string][];
  compute?: [number | string, number | string][];
  new_pairs?: [number | string, number | string][];
}
export interface Plan {
  format: 'changeover-plan/1';
  title: string;
  parts: {name: string; change_cost: number; slot?: null | string}[];
  at_once: number;
  slots: {name: string; least: number; most: number}[];
  test_cost: number;
  mounted: string[];
  start: string[];
  first: string[][];
  tests_done: number;
  met_only_in_failed: number;
  trust_failed: boolean;
  tests: number;
  changes: number;
  cost: number;
  pairs_needed: number;
  pairs_tested: number;
  proved_cheapest: boolean;
  lower_bound: {cost: number; tests: number; changes: number; reason: string};
  budget: null | number;
  triples_needed: number;
  triples_tested: number;
  weight: null | {needed: number; tested: number; most: null | number};
  cost_unit: null | 'seconds' | 'minutes' | 'hours';
  places: {number: number; slot: null | string}[];
  steps: {
    step: number;
    take_out: string[];
    put_in: string[];
    set_up: string[];
    places: (null | string)[];
    new_pairs: string[][];
    cost: number;
    cost_so_far: number;
    weight_so_far?: number;
    new_triples?: string[][];
    replaced?: string[][];
    values?: {[k: string]: string};
  }[];
  candidates: {
    name: string;
    how: string;
    tests: number;
    changes: number;
    cost: number;
    pairs_tested: number;
    triples_tested: number;
    weight: number;
  }[];
  /**
   * why the search ended: nothing better is possible, it was over by itself, a clock stopped it or
   * a part of it, or the user did
   */
  why_stopped: 'found' | 'step limit' | 'time limit' | 'interrupted';
  notes: string[];
  replace_costs?: (null | number)[][];
  parameters?: {
    name: string;
    values: {value: string; part: string; names: string[]; out_of_range: boolean}[];
  }[];
  rules?: number;
  objective?: 'cost' | 'tests';
  proved_fewest_tests?: boolean;
}
export interface WhatIf {
  format: 'changeover-what-if/1';
  by: string;
  asked: null | number;
  /** the same exactly, over/under */
  asked_exact: null | string;
  ranges: {
    from: null | number;
    /** the same exactly, over/under */
    from_exact: null | string;
    to: null | number;
    /** the same exactly, over/under */
    to_exact: null | string;
    plan: {
      name: string;
      how: string;
      tests: number;
      changes: number;
      cost: number;
      pairs_tested: number;
      triples_tested: number;
      weight: number;
      /** the parts of each test */
      set_ups: string[][];
    };
  }[];
  met_only_in_failed: number;
  trust_failed: boolean;
  /**
   * why the search ended: nothing better is possible, it was over by itself, a clock stopped it or
   * a part of it, or the user did
   */
  why_stopped: 'found' | 'step limit' | 'time limit' | 'interrupted';
  notes: string[];
}
export interface Explorer {
  get: {
    about: About;
    table: TableCell[];
    atlas: AtlasDocument;
    groups: GroupsDocument;
    cell: CellDetail;
    bounds: {
      v: number;
      k: number;
      change: number;
      kind: Kind;
      strength: number;
      lower_bound: number | null;
      reason: string;
      status: Status;
      reported: Reported | null;
      classified: Classified | null;
      best_known: number | null;
      construction: string | null;
      bounds: {lower_bound: number; name: string; reason: string}[];
    };
    explain: Explanation;
    design: Design;
    completeness: Completeness[];
    constructions: Construction[];
    theorems: Theorem[];
    search: SearchJob[];
    'search?id': SearchJob;
    'plan/job': PlanJob;
    run: RunHead[];
    'run?id': Run;
  };
  post: {
    verify: Verified;
    repair: Repaired;
    plan: Planned;
    'plan/read': ReadJob;
    'plan/start': Started;
    'plan/stop': Nothing;
    run: RunRevisions;
    'run/result': RunRevisions;
    'run/remove': Nothing;
    loadorder: Ordered;
    search: Started;
    'search/stop': Nothing;
    'search/keep': Kept;
    'catalog/add': Kept;
  };
  body: {
    plan: Job;
    'plan/read': Job;
    'plan/start': Job;
    run: RunToKeep;
    'run/result': ResultToKeep;
    search: SearchOrder;
    /** changeover-load-request-1.json; bytes_per_item is an older name of its item_bytes. */
    loadorder: {bytes_per_item?: number};
  };
}
/** Files for any web server have no limits. */
export interface About {
  version: string;
  catalog: {designs: number; cells: number; version: string};
  write: boolean;
  files: {index: number; name: string}[];
  static: boolean;
  /** Of files for any web server: where the program can be got, if that was said. */
  sources?: string;
  /** Of files for any web server: the cells that they have. */
  range?: {k_from: number; k_to: number; v_from: number; v_to: number; changes: number[]};
  limits?: {body_bytes: number; seconds: number; memory: number; searches: number};
}
export interface TableCell {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  b: number | null;
  lower_bound: number | null;
  status: Status;
  construction: string | null;
  label: string | null;
}
/** All cells of a range in columns: a value for each cell, by k, then v. */
export interface AtlasDocument {
  change: number;
  kind: Kind;
  strength: number;
  k_from: number;
  k_to: number;
  v_from: number;
  v_to: number;
  constructions: string[];
  b: (number | null)[];
  /** null where no design exists */
  lower_bound: (number | null)[];
  /** an index into constructions */
  construction: (number | null)[];
  /** the digits at the end of the label; null: not in the catalog */
  label: (string | null)[];
}
/** The orders of the groups of the best designs of these cells, in decimal. */
export interface GroupsDocument {
  change: number;
  kind: Kind;
  strength: number;
  k_from: number;
  k_to: number;
  v_from: number;
  v_to: number;
  order: (string | null)[];
}
export interface CellDetail {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength: number;
  lower_bound: number | null;
  reason: string;
  status: Status;
  reported: Reported | null;
  bounds: Bound[];
  best: {
    b: number;
    label: string | null;
    status: Status;
    construction: string;
    recipe: Recipe;
  } | null;
  designs: CatalogEntry[];
  offers: {construction: string; b: number; recipe?: Recipe}[];
  history: {date: string; b: number; label: string; credit: string; how: string}[];
  classified: Classified | null;
  impossible: string | null;
}
/** Fewer blocks that a publication has, without the design. */
export interface Reported {
  blocks: number;
  cites: string;
}
export interface Bound {
  name: string;
  blocks: number;
  reason: string;
}
export interface CatalogEntry {
  label: string;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  b: number;
  lower_bound: number;
  reason: string;
  status: 'minimum' | 'best-known' | 'retracted';
  construction: string;
  credit: Credit;
  cites: string[];
  hash: string;
  strength?: number;
  note?: string;
  retracted?: string;
}
export interface Credit {
  who: string;
  date: string;
  program: string;
  command: string;
}
/** How many designs with so many blocks there are: all of them, by exhaustive search. */
export interface Classified {
  b: number;
  standard_forms: number;
  classes: number;
  /** classes of tight designs */
  tight: number;
  /** orders of groups, and how many classes have a group of that order */
  groups: {order: number; classes: number}[];
}
export interface Explanation {
  recipe: Recipe;
  tree: TreeNode;
}
export interface TreeNode {
  construction: string;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  explanation: string;
  citation: string;
  b: number;
  verdict: Verdict | null;
  inputs: TreeNode[];
}
export interface Completeness {
  strength: number;
  change: number;
  kind: Kind;
  k: number;
  v_from: number;
  v_to: number;
  cells: number;
  minimum: number;
  mean_ratio: number;
}
export interface Construction {
  name: string;
  summary: string;
  citation: string;
  serves: string;
  gives: string;
  example: Example | null;
}
export interface Example {
  v: number;
  k: number;
  change: number;
  kind: Kind;
}
export interface Theorem {
  number: string;
  title: string;
  statement: string;
  proof: string;
  example: Example | null;
}
export interface SearchJob {
  id: number;
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength: number;
  way: SearchWay;
  state: 'running' | 'done' | 'stopped' | 'failed';
  best: number | null;
  lower_bound: number | null;
  start_best: number | null;
  seconds: number;
  limit: number;
  threads: number;
  seed: number;
  restarts: number | null;
  message: string;
  steps: number;
  /** What a step is: moves, or kB of proof. */
  unit: string;
  /** Of an exact search: whether there is a design with so many blocks. */
  decisions: {
    blocks: number;
    outcome: 'running' | 'found' | 'none' | 'unknown';
    seconds: number;
    steps: number;
  }[];
  points?: {seconds: number; best: number | null; lower_bound: number | null; rate: number}[];
}
/** A plan that is searched for: the best so far against its bound; the answer at last. */
export interface PlanJob {
  id: number;
  state: 'running' | 'done' | 'stopped' | 'failed';
  seconds: number;
  limit: number;
  phase: string;
  tests: number | null;
  best: number | null;
  bound: number | null;
  message: string;
  answer?: Planned | null;
}
/** One of the four documents; a plan also in the keys from before it was a document. */
export interface Planned {
  plan?: Plan;
  benches?: Benches;
  what_if?: WhatIf;
  diagnosis?: Diagnosis;
  tests?: {
    number: number;
    parts: string[];
    out: string[];
    in: string[];
    cost: number;
    changes: number;
    done: boolean;
  }[];
  cost?: number;
  changes?: number;
  bound?: number;
  reason?: string;
  cheapest?: boolean;
  met_only_in_failed?: number;
  alternatives?: {
    name: string;
    how: string;
    change: number | null;
    tests: number;
    changes: number;
    cost: number;
    bound: number;
  }[];
  verified?: boolean;
  csv?: string;
}
/** A run that the server keeps. */
export interface RunHead {
  id: string;
  title: string;
  revision: number;
  sheet_revision: number;
  changed: string;
  tests: number;
  done: number;
}
export interface Run {
  format: 'changeover-run/1';
  id: string;
  title: string;
  revision: number;
  sheet_revision: number;
  changed: string;
  tests: number;
  sheet: {};
  results: RunResult[];
}
export interface RunResult {
  test: string;
  result: string;
  notes: string;
  by: string;
  at: string;
}
/** What verify --json says, more examples, and the design as it was understood. */
export interface Verified {
  valid: boolean;
  verdict: Verdict;
  bound: Proof;
  details: Details;
  names_among_numbers: NamesAmongNumbers;
  bad_steps: {block: number; why: string}[];
  uncovered_pairs: number[][];
  design: Design | null;
}
/** Which bound, and why it holds. */
export interface Proof {
  name: string;
  reason: string;
}
export interface Details {
  v: number;
  k: number;
  change: number;
  kind: Kind;
  strength: number;
  valid: boolean;
  tight: boolean;
  economical: boolean;
  b: number;
  counting_bound: number | null;
  bad_steps: number;
  bad_step_examples: {from: number; to: number; changes: number}[];
  subsets: number;
  uncovered: number;
  uncovered_examples: (number | string)[][];
  covered: number;
  never_newly_covered: number;
  excess: number;
  fixed: (number | string)[];
  degree_identity: boolean | null;
  unchanged_subsets: number | null;
  never_unchanged: (number | string)[];
  elements: {
    element: number | string;
    introductions: number;
    blocks: number;
    covered: number;
    excess: number;
  }[];
}
/** What a list of blocks became with few blocks changed. */
export interface Repaired {
  given: number;
  kept: number;
  bad_steps: number;
  uncovered: number;
  design: Design | null;
}
/** What files say of a job: its lists as rows, and tests that have results. */
export interface ReadJob {
  request: Job;
  done: {
    places: {number: number; slot: string | null}[];
    tests: {
      /** On which it was; null if that is not known. */
      bench: string | null;
      places: string[];
      result: string;
      /** What the planner reads in it. */
      verdict: '' | 'pass' | 'fail' | 'done' | 'not run' | 'other';
      notes: string;
    }[];
  };
  notes: string[];
}
export interface Started {
  id: number;
}
export interface Nothing {}
export interface RunRevisions {
  id: string;
  revision: number;
  sheet_revision: number;
}
/** What a load order comes to, its first steps, and samples of what happens. */
export interface Ordered {
  order: Head;
  loads: number;
  lower_bound: number;
  reason: string;
  method: string;
  explanation: string;
  bytes: number;
  bytes_bound: number;
  step_count: number;
  steps: Step[];
  truncated: boolean;
  sample_every: number;
  memory: number[];
  pairs_done: number[];
  pairs: number;
  verified: true;
  makespan?: number;
  makespan_bound?: number;
  worker_loads?: number[];
  makespan_bytes?: number;
  makespan_bytes_bound?: number;
  /** bytes that each worker loads, if items have sizes */
  worker_bytes?: number[];
  /** pairs that each worker computes */
  worker_pairs?: number[];
  /** of the room or of the memory, for what is loading */
  spare?: number;
  /** whether something that is tried without a search was left out */
  time_is_up?: boolean;
}
export interface Kept {
  label: string;
  already: boolean;
}
/** A new run, or with an id another sheet for it in place of that of sheet_revision. */
export interface RunToKeep {
  id?: string;
  sheet_revision?: number;
  title: string;
  tests: number;
  sheet: {};
  results?: RunResult[];
}
export interface ResultToKeep {
  test: string;
  sheet_revision: number;
  result?: string;
  notes?: string;
  by?: string;
}
/** What is asked of a search. */
export interface SearchOrder {
  v: number;
  k: number;
  change?: number;
  kind?: Kind;
  strength?: number;
  way?: SearchWay;
  blocks?: number;
  first?: number[];
  last?: number[];
  expansion_set?: boolean;
  anew?: boolean;
  seconds?: number;
  threads?: number;
  seed?: number;
}
export interface Verify {
  verdict: Verdict;
  bound: Proof;
  details: Details;
  names_among_numbers: NamesAmongNumbers;
}
export interface Refusal {
  error: {message: string; line?: number; column?: number};
}
