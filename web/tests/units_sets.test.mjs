// Triples and larger sets that meet, against a count that knows no ranks.
import assert from 'node:assert/strict';
import { createHash, webcrypto } from 'node:crypto';
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

test('pairs: how often each is newly covered', async () => {
  const { timesOf } = await load('pages/design/times.ts');
  const of = (kind, blocks) => {
    const times = timesOf({ v: 4, kind, blocks });
    return subsets([0, 1, 2, 3], 2).map(([x, y]) => {
      assert.equal(times[x * 4 + y], times[y * 4 + x]);
      return times[x * 4 + y];
    });
  };
  // The third block introduces 03 again, and from there 03 goes on to the first block.
  const blocks = [
    [3, 0, 1],
    [1, 3, 2],
    [2, 0, 3],
  ];
  assert.deepEqual(of('linear', blocks), [1, 1, 2, 1, 1, 1]);
  assert.deepEqual(of('circular', blocks), [1, 1, 1, 1, 1, 1]);
  // One block alone introduces all of its elements.
  assert.deepEqual(of('circular', [[0, 1, 2]]), [1, 1, 0, 1, 0, 0]);
});

test('the checksum of a design is that of its blocks as text', async () => {
  const { checksumOf } = await load('lib/checksum.ts');
  globalThis.crypto ??= webcrypto; // Node 18 has no such global.
  const hex = createHash('sha256').update('0 1 2\n2 3 0\n').digest('hex');
  const blocks = [
    [0, 1, 2],
    [2, 3, 0],
  ];
  assert.equal(await checksumOf(2, 3, (i) => blocks[i]), hex);
  const flat = Int32Array.from(blocks.flat());
  assert.equal(await checksumOf(2, 3, (i) => flat.subarray(3 * i, 3 * i + 3)), hex);
  const never = () => assert.fail('too many blocks are not read');
  assert.equal(await checksumOf(2_000_000, 3, never), null);
});

test('a cell as the command line takes it, with its strength', async () => {
  const { cellArguments } = await load('parts/command.ts');
  const cell = { v: 9, k: 4, change: 1, kind: 'linear' };
  assert.equal(cellArguments(cell), '9 4 --change 1 --linear');
  assert.equal(cellArguments({ ...cell, strength: 3 }), '9 4 --change 1 --linear --strength 3');
});
