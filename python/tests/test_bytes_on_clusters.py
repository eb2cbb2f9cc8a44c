"""Workers that hold so many bytes, by the sizes of items."""

import itertools
import random
import unittest

import changeover
from changeover import cluster
from test_cluster import jobs, memory, taken, wanted


class Bytes(unittest.TestCase):
    def test_no_worker_holds_more_bytes_than_there_are(self):
        rng = random.Random(6)
        for items, _, workers, pairs in jobs(60):
            sizes = [rng.randint(1, 40) for _ in range(items)]
            overlap = rng.random() < 0.5
            room = sum(sorted(sizes)[-2:]) + max(sizes) + rng.randint(0, 80)
            asked = wanted(items, None, pairs, sizes=sizes, memory=room, overlap=overlap)
            memories = [memory(None, memory=room, overlap=overlap) for _ in range(2)]
            done = []
            for run in asked.shares(workers)[0]:
                for stretch in taken(run, 12, rng):
                    outcome = rng.choice(memories).run(stretch.with_sizes(asked.size))
                    self.assertIsNone(outcome.failure)
                    self.assertLessEqual(outcome.most_bytes, room)
                    done += [tuple(result[:2]) for result in outcome.results]
            every = itertools.combinations(range(items), 2) if pairs is None else pairs
            self.assertEqual(sorted(done), sorted(every))

    def test_what_must_not_fit_does_not(self):
        stretch = wanted(4, 4).shares(1)[0][0].take(1, 100)
        outcome = memory(None, memory=39).run(stretch.with_sizes(lambda x: 9))
        self.assertEqual(outcome.most_bytes, 36)
        with self.assertRaises(changeover.InternalError):
            memory(None, memory=39).run(stretch.with_sizes(lambda x: 10))

    def test_wrong_jobs_are_refused(self):
        for given, says in (
                (dict(room=None), "give room, how many items a worker holds, or sizes and memory"),
                (dict(room=4, sizes=1, memory=9), "give room, how many items"),
                (dict(room=None, memory=9), "memory is in bytes, and needs sizes"),
                (dict(room=2, overlap=True), "give room 3 or more"),
                (dict(room=None, sizes=4, memory=11, overlap=True),
                 "overlap keeps 4 bytes for what is loading, beside two items of 8 bytes; give 12 "
                 "or more")):
            with self.assertRaisesRegex(changeover.BadInput, says):
                wanted(5, **given)
        with self.assertRaisesRegex(
                changeover.BadInput, "memory is for up to 2000000 pairs, or for listed ones; give "
                "room, how many items a worker holds"):
            cluster.simulate(items=3000, memory=9, item_bytes=1, workers=2, pair_seconds=1)
        with self.assertRaisesRegex(changeover.BadInput, "items 4 and 3 have 9 bytes together"):
            wanted(5, None, sizes=[1, 2, 3, 4, 5], memory=8).shares(1)

    def test_pairs_of_a_lost_worker_are_planned_in_bytes(self):
        sizes = [1 + x % 7 for x in range(40)]
        said = cluster.simulate(items=40, memory=40, item_bytes=sizes, workers=4, pair_seconds=1,
                                failures=20, restart=30, seed=3)
        self.assertGreater(said.lost, 0)
        self.assertEqual(said.pairs, 780)


if __name__ == "__main__":
    unittest.main()
