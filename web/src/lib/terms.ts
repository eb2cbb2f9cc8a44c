// The field's terms, a sentence each, for the place where a newcomer meets them.
import { setsOf, setWord } from './words';

export const terms = {
  v: 'number of elements',
  k: 'number of elements in a block',
  change: 'number of elements in which consecutive blocks differ',
  kind: 'circular: the last block and the first are consecutive, too; linear: they need not be',
  blocks: 'number of blocks in the list, b for short',
  bound: 'proved: no design with these parameters has fewer blocks than this',
  valid: 'every pair of elements is in some block, and every step changes exactly m elements',
  tight: 'every pair is newly covered exactly once, so nothing is wasted',
  economical: 'has exactly as many blocks as counting pairs requires',
  minimum: 'no design with these parameters has fewer blocks',
  excess: 'how many times, in all, pairs are newly covered after their first time',
  covered: 'two elements are covered when they are together in a block',
  introduced: 'an element is introduced in a block if it was not in the block before',
  leaving: 'an element is leaving if it is not in the next block',
  unchanged: 'what two consecutive blocks have in common',
  introductions: 'i_x: how many times x is introduced',
  occurrences: 'r_x: how many blocks contain x',
  surplus: 'e_x: how often pairs with x are newly covered again, after their first time',
} as const;

/** The same for designs of that strength: those of pairs say what they are of triples. */
export function termsOf(strength: number): Record<keyof typeof terms, string> {
  const set = setWord(strength);
  const sets = setsOf(strength);
  return strength === 2
    ? terms
    : {
        ...terms,
        valid: `every ${set} of elements is in some block, and every step changes exactly m elements`,
        tight: `every ${set} is newly covered exactly once, so nothing is wasted`,
        economical: `has exactly as many blocks as counting ${sets} requires`,
        excess: `how many times, in all, ${sets} are newly covered after their first time`,
        surplus: `e_x: how often ${sets} with x are newly covered again`,
      };
}

/** All terms, in the order in which a newcomer meets them. */
export const glossary: readonly (readonly [term: string, meaning: string])[] = [
  [
    'change covering design',
    'a list of blocks, each with k of v elements; every two elements are together in some ' +
      'block, and consecutive blocks differ in exactly m elements',
  ],
  [
    'SCCD(v, k), DCCD(v, k)',
    'single-change (m = 1) and double-change (m = 2) covering designs; a third number is that of ' +
      'blocks: DCCD(v, k, b)',
  ],
  [
    'element',
    'what the blocks are made of: parts of a test, items of a data set, or numbers 0 to v − 1',
  ],
  ['block', 'a set of k elements that are together at one time'],
  ['v', terms.v],
  ['k, block size', terms.k],
  ['m, change number', terms.change],
  ['b', 'number of blocks in the list'],
  ['circular, linear', terms.kind],
  ['strength t', 'every t elements are together in some block; 2 unless another number is given'],
  ['introduced', terms.introduced],
  ['leaving', terms.leaving],
  ['unchanged subset', terms.unchanged],
  [
    'stay',
    'consecutive blocks that all contain an element: from the block where it is introduced to ' +
      'the last one before it leaves',
  ],
  ['covered', terms.covered],
  [
    'newly covered',
    'a pair in a block is newly covered there if it was not together in the block before; in the first block of a linear design every pair is newly covered',
  ],
  ['lower bound', terms.bound],
  ['gap', 'number of blocks of the best known design minus the lower bound'],
  ['minimum', terms.minimum],
  ['best known', 'the design with the fewest blocks that is known; one with fewer may exist'],
  [
    'open',
    'of a number of blocks: no design with so many is known, and none is excluded; of a cell: its minimum is not known',
  ],
  ['tight', 'every pair is newly covered exactly once'],
  ['economical', terms.economical],
  ['excess', terms.excess],
  [
    'waste',
    'number of pairs that the blocks could newly cover, less those that there are: 0 if it is tight',
  ],
  [
    'end to end',
    'a lower bound: some element comes late, some leaves early, and these two must meet between',
  ],
  ['cell', 'one choice of v, k, m, kind and t, with everything known about it'],
  [
    'label',
    'a permanent name of one design: v.k.m.kind.b and eight digits of the checksum of its blocks',
  ],
  ['construction', 'a method that makes designs, with a proof that it does'],
  ['recipe', 'how one design is made: a tree of constructions'],
  ['base block', 'a block from which others are made by applying a symmetry again and again'],
  [
    'develop, Z_n',
    'to make all blocks of base blocks: 1 is added to every number, again and again; Z_n has the ' +
      'numbers 0 to n − 1, and 0 follows n − 1',
  ],
  [
    'orbit, cycle',
    'elements that a symmetry carries to one another: those of one copy of Z_n, or a fixed one',
  ],
  [
    'rotation',
    'a symmetry of a circular design that carries each block to the one so many places later',
  ],
  [
    'automorphism, group',
    'a relabelling of the elements that maps the design to itself; they form a group, whose ' +
      'order counts them',
  ],
  [
    'standard form, class',
    'designs counted up to names of elements are standard forms; up to rotation, too, they are ' +
      'classes',
  ],
  [
    'expansion set',
    'unchanged subsets at different positions that together contain every element once',
  ],
  ['load', 'reading one item from the disk into memory'],
  ['room', 'number of items that fit into memory at once'],
  ['evict', 'removing an item from memory'],
  [
    'makespan',
    'of a load order: number of loads of the busiest worker; of a plan for several benches: ' +
      'the end of the last test',
  ],
  ['accelerator', 'a device with its own memory, into which items are loaded, as a GPU'],
  ['epoch', 'one pass of a training through all that it has to read'],
  ['test, set-up', 'parts that are mounted together at one time'],
  ['change', 'of a run sheet: one part that is put in before a test; each can have its own cost'],
  ['slot', 'a place of a set-up that takes parts of one kind only'],
  ['bench', 'a place where tests run; several benches share the tests of one plan'],
  ['needed pair', 'two parts that must be together in some test'],
  ['forbidden pair', 'two parts that must never be in one set-up'],
];

/** Where to read on: terms that a reader of a term asks for next. */
export const seeAlso: Readonly<Record<string, readonly string[]>> = {
  'change covering design': ['block', 'm, change number', 'covered'],
  block: ['k, block size', 'element'],
  introduced: ['leaving', 'stay'],
  leaving: ['introduced', 'unchanged subset'],
  'unchanged subset': ['expansion set', 'leaving'],
  stay: ['introduced', 'leaving'],
  covered: ['newly covered'],
  'newly covered': ['excess', 'tight'],
  'lower bound': ['gap', 'minimum'],
  gap: ['lower bound', 'best known'],
  minimum: ['lower bound', 'best known'],
  'best known': ['minimum', 'open'],
  open: ['best known', 'lower bound'],
  tight: ['newly covered', 'excess', 'economical'],
  economical: ['tight', 'lower bound'],
  excess: ['newly covered', 'tight', 'waste'],
  waste: ['excess', 'tight'],
  'base block': ['develop, Z_n', 'orbit, cycle'],
  'develop, Z_n': ['base block', 'orbit, cycle'],
  'orbit, cycle': ['automorphism, group', 'develop, Z_n'],
  rotation: ['automorphism, group', 'circular, linear'],
  'automorphism, group': ['rotation', 'orbit, cycle'],
  recipe: ['construction'],
  construction: ['recipe'],
  load: ['room', 'evict'],
  room: ['load', 'evict'],
  change: ['test, set-up'],
  'test, set-up': ['change', 'slot', 'bench'],
  'needed pair': ['forbidden pair'],
  'forbidden pair': ['needed pair'],
};

/** A term in an address: "standard-form-class". */
export const termAt = (term: string): string =>
  term
    .toLowerCase()
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-|-$/g, '');

/** The term that an address names, by all of its words or by one of its names; null if none is. */
export function termOf(address: string): string | null {
  const wanted = termAt(address);
  const all = glossary.map(([term]) => term);
  return (
    all.find((term) => termAt(term) === wanted) ??
    all.find((term) => term.split(', ').some((name) => termAt(name) === wanted)) ??
    null
  );
}
