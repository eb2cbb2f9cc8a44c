"""Load orders with all that they may be told: pairs of every kind, workers, what steps compute and store."""

import itertools
import os
import pickle
import tempfile
import unittest

import changeover


def pairs_of(setup):
    return {frozenset(pair) for pair in itertools.combinations(setup, 2)}


class Loads(unittest.TestCase):
    def check(self, order, wanted, room):
        memory, met, loads = set(), set(), 0
        for evict, load in order:
            self.assertTrue(set(evict) <= memory and memory.isdisjoint(load))
            memory = (memory - set(evict)) | set(load)
            loads += len(load)
            self.assertLessEqual(len(memory), room)
            met |= pairs_of(memory)
        self.assertTrue(wanted <= met)
        self.assertEqual(loads, order.loads)
        self.assertGreaterEqual(loads, order.lower_bound)

    def test_only_some_pairs(self):
        circle = [(i, (i + 1) % 30) for i in range(30)]
        order = changeover.load_order(None, 4, pairs=circle)
        self.check(order, {frozenset(pair) for pair in circle}, 4)
        self.assertLess(order.loads, 45)
        self.assertEqual(order.items, 30)
        self.assertEqual(changeover.load_order(40, 4, pairs=circle, time=0.2).items, 40)

    def test_pairs_of_numpy(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("numpy is not installed")
        rows = numpy.random.default_rng(1).integers(0, 50, (200, 2))
        order = changeover.load_order(50, 8, pairs=rows)
        self.check(order, {frozenset(map(int, row)) for row in rows if row[0] != row[1]}, 8)

    def test_two_sets_and_what_is_new(self):
        self.check(
            changeover.load_order(5, 4, against=7),
            {frozenset(pair) for pair in itertools.product(range(5), range(5, 12))},
            4,
        )
        self.check(
            changeover.load_order(14, 5, done_items=10),
            pairs_of(range(14)) - pairs_of(range(10)),
            5,
        )

    def test_wrong_pairs_are_refused(self):
        for wrong, words in (
            ({"pairs": [(1, 2, 3)]}, "row 0 has more than two items"),
            ({"pairs": [(1, 2), (1,)]}, "row 1 has fewer than two items"),
            ({"pairs": [itertools.repeat(1)]}, "row 0 has more than two items"),
            ({"pairs": [(1, -2)]}, "items are numbered from 0"),
            ({"pairs": [(1, 10**8)]}, "items are numbered from 0"),
            ({"pairs": [(1, 9)]}, "9"),
            ({"pairs": [(1, 2)], "against": 3}, "one of pairs, against and done_items"),
            ({"done_items": 8}, ""),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(changeover.BadInput, words) as caught:
                changeover.load_order(8, 3, **wrong)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaises(TypeError):
            changeover.load_order(8, 3, pairs=[("a", "b")])
        with self.assertRaisesRegex(changeover.BadInput, "give items"):
            changeover.load_order(None, 3)


class Orders(unittest.TestCase):
    def test_orders_say_what_their_steps_compute_and_store(self):
        order = changeover.load_order(20, 6, new_pairs=True, with_self=True)
        self.assertEqual(order.steps, len(list(order.work())))
        pairs = [pair for step in order.work() for pair in step.pairs]
        self.assertEqual(sorted(pairs), [(i, j) for i in range(20) for j in range(i, 20)])
        both = changeover.load_order(20, 6, new_pairs=True, ordered=True)
        self.assertEqual(len({pair for step in both.work() for pair in step.pairs}), 380)
        stored = changeover.load_order(20, 6, write_back=True)
        for step in stored.work():
            self.assertLessEqual(set(step.store), set(step.evict))
        ahead = list(changeover.load_order(20, 6, prefetch=True).work())
        self.assertEqual(sum(len(step.pairs) + len(step.overlap) for step in ahead), 190)
        self.assertEqual([(step.evict, step.load) for step in changeover.load_order(9, 4).work()],
                         list(changeover.load_order(9, 4)))

    def test_workers_that_are_disjoint_never_hold_one_item_twice(self):
        split = changeover.load_order(24, 5, workers=3, disjoint=True, new_pairs=True)
        self.assertIsInstance(split, changeover.WorkerLoads)
        memory = [set(), set(), set()]
        for steps in zip(*(split.work(worker) for worker in range(3))):
            for step in steps:
                memory[step.worker] -= set(step.evict)
            for step in steps:
                memory[step.worker] |= set(step.load)
                self.assertTrue(all(set(pair) <= memory[step.worker] for pair in step.pairs))
            self.assertEqual(len(set.union(*memory)), sum(map(len, memory)))
        self.assertGreaterEqual(split.span, split.makespan)

    def test_pairs_are_spread_over_workers(self):
        split = changeover.load_order(60, 30, workers=4, new_pairs=True)
        self.assertEqual(sum(split.worker_pairs), 1770)
        self.assertLessEqual(max(split.worker_pairs), 443 * 1.05)
        done = [{pair for step in split.work(worker) for pair in step.pairs} for worker in range(4)]
        self.assertEqual([len(pairs) for pairs in done], split.worker_pairs)
        self.assertEqual(len(set.union(*done)), 1770)
        first = changeover.load_order(60, 12, workers=4, first_holder=True)
        self.assertEqual(sum(first.worker_pairs), 1770)
        costs = {(0, i): 30 for i in range(1, 24)}
        spread = changeover.load_order(24, 8, workers=3, pair_cost=costs)
        self.assertAlmostEqual(sum(spread.worker_costs), 23 * 30 + 253)
        self.assertLess(max(spread.worker_costs), 350)
        self.assertIsNone(split.worker_costs)
        for wrong, says in (({(0, 1): -1}, "0 or more"), ({(0, 99): 1}, "99"), ([(0, 1)], "not two items"),
                            ({(0, "x"): 1}, "")):
            with self.assertRaisesRegex((changeover.BadInput, TypeError), says):
                changeover.load_order(24, 8, workers=3, pair_cost=wrong)

    def test_orders_are_read_from_any_step(self):
        order = changeover.load_order(30, 7)
        memory, steps = set(), list(order)
        for number, (evict, load) in enumerate(steps, 1):
            memory = memory - set(evict) | set(load)
            later = order.steps_from(number)
            self.assertEqual(set(next(later)[1]), memory)
            self.assertEqual(list(later), steps[number:])
        with self.assertRaises(IndexError):
            order.steps_from(0)
        with self.assertRaises(IndexError):
            order.steps_from(order.steps + 1)

    def test_orders_can_be_pickled(self):
        made = [changeover.load_order(30, 7), changeover.load_order(30, 7, workers=3, new_pairs=True),
                changeover.load_order(None, 3, pairs=[(0, 1), (1, 2), (2, 0), (2, 3)]),
                changeover.load_order(30, 7, time=0.1, new_pairs=True)]
        for each in made:
            again = pickle.loads(pickle.dumps(each))
            self.assertIs(type(again), type(each))
            self.assertEqual(again.to_json(), each.to_json())
            if isinstance(each, changeover.LoadOrder):
                self.assertEqual(list(again), list(each))
                self.assertEqual(list(again.steps_from(2)), list(each.steps_from(2)))
                self.assertEqual(list(again.work()), list(each.work()))
            else:
                self.assertEqual(list(again.work(2)), list(each.work(2)))
            self.assertEqual(pickle.loads(pickle.dumps(again)).to_json(), each.to_json())
            call, (kind, state, checksum) = each.__reduce_ex__(4)
            with self.assertRaisesRegex(changeover.BadInput, "is damaged"):
                call(kind, state[:-1] + b"x", checksum)

    def test_orders_may_be_verified_beside(self):
        order = changeover.load_order(300, 20, verify_beside=True)
        self.assertEqual(len(list(order)), order.steps)
        self.assertTrue(order.verified())
        self.assertTrue(changeover.load_order(30, 7, workers=3, verify_beside=True).verified())

    def test_other_shares_go_on_with_a_job(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "items")
            with open(path, "wb") as file:
                file.write(bytes(range(40)))
            seen = []
            journals = [os.path.join(folder, f"journal.{i}") for i in range(5)]

            def compute(i, j, first, second):
                if len(seen) == 200:
                    raise OSError("stop")
                seen.append((i, j))

            with self.assertRaises(OSError):
                changeover.all_pairs(path, 1, 8, compute, journal=journals[0], share=(0, 2))
            before = len(seen)
            self.assertEqual(before, 200)
            recorded = []
            for i in range(3):
                report = changeover.all_pairs(
                    path, 1, 8, lambda i, j, first, second: recorded.append((i, j)),
                    journal=journals[1 + i], share=(i, 3), earlier=journals[:1])
                self.assertTrue(report.finished)
                self.assertIn("finished", repr(report))
            self.assertEqual(len(recorded), len(set(recorded)))
            everything = {(i, j) for i in range(40) for j in range(i, 40)}
            self.assertEqual(set(recorded) | set(seen), everything)
            self.assertLess(len(recorded), len(everything))

    def test_workers_share_a_load_order(self):
        split = changeover.load_order(24, 6, workers=3)
        self.assertEqual((len(split), split.makespan, split.loads), (3, max(split.worker_loads), sum(split.worker_loads)))
        self.assertLessEqual(split.makespan_bound, split.makespan)
        met = set()
        for worker in range(3):
            held, loads = set(), 0
            for evict, load in split.steps(worker):
                held = held - set(evict) | set(load)
                loads += len(load)
                self.assertLessEqual(len(held), 6)
                met |= set(itertools.combinations(sorted(held), 2))
            self.assertEqual(loads, split.worker_loads[worker])
        self.assertEqual(len(met), 24 * 23 // 2)
        some = changeover.load_order(30, 4, pairs=[(i, i + 1) for i in range(29)], workers=2)
        self.assertEqual(sum(some.worker_loads), some.loads)
        with self.assertRaises(IndexError):
            split.steps(3)
        for wrong, words in (({"workers": 0}, "^workers 0: give at least 1"), ({"workers": 2**40}, "^workers 1099511627776: give 1 to")):
            with self.assertRaisesRegex(changeover.BadInput, words):
                changeover.load_order(24, 6, **wrong)


if __name__ == "__main__":
    unittest.main()
