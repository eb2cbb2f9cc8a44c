// Triples and larger sets that meet, against a count that knows no ranks.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { load } from './support/source.mjs';

const { Sets } = await load('pages/design/sets.ts');

/** All sets of t of these elements. */
const subsets = (elements, t) =>
  t === 0
    ? [[]]
    : elements.flatMap((x, i) => subsets(elements.slice(i + 1), t - 1).map((set) => [x, ...set]));

test('sets: when each first meets, how often it is newly covered, and both by pair', () => {
  const blocks = [
    [5, 0, 2, 1],
    [0, 2, 3, 4],
    [4, 3, 1, 5],
    [1, 4, 0, 2],
    [0, 1, 2, 3],
  ];
  for (const t of [3, 4]) {
    for (const kind of ['linear', 'circular']) {
      const sets = Sets.of({ v: 6, k: 4, change: 2, kind, strength: t, blocks });
      const has = (block, set) => set.every((x) => block.includes(x));
      const all = subsets([0, 1, 2, 3, 4, 5], t);
      assert.equal(sets.all, all.length);
      const first = (set) => blocks.findIndex((block) => has(block, set)) + 1;
      blocks.forEach((_, i) => {
        const here = all.filter((set) => first(set) === i + 1);
        assert.deepEqual(sets.fresh(i + 1).sort(), here.sort());
        assert.equal(sets.met[i + 1] - sets.met[i], here.length);
      });
      const times = (set) =>
        blocks.filter((block, i) => {
          const before = i > 0 ? blocks[i - 1] : kind === 'circular' ? blocks.at(-1) : [];
          return has(block, set) && !has(before, set);
        }).length;
      assert.deepEqual([...sets.times].sort(), all.map(times).sort());
      for (const [x, y] of subsets([0, 1, 2, 3, 4, 5], 2)) {
        const both = all.filter((set) => set.includes(x) && set.includes(y));
        assert.equal(sets.withPair, both.length);
        const at = x * 6 + y;
        const early = both.filter((set) => [1, 2, 3].includes(first(set)));
        assert.equal(sets.metByPair(3)[at], early.length);
        assert.equal(
          sets.excessByPair()[at],
          both.reduce((sum, set) => sum + Math.max(0, times(set) - 1), 0),
        );
        const last = both.every((set) => first(set) > 0) ? Math.max(...both.map(first)) : 0;
        assert.equal(sets.completeByPair()[at], last);
      }
    }
  }
});

test('sets: pairs are counted elsewhere, and too many sets are not', () => {
  const blocks = [[0, 1, 2]];
  assert.equal(Sets.of({ v: 3, k: 3, change: 1, kind: 'linear', blocks }), null);
  assert.equal(Sets.of({ v: 400, k: 3, change: 1, kind: 'linear', strength: 3, blocks }), null);
});
