"""Load orders with all their options: pairs of every kind, workers, what steps compute."""

import collections
import copy
import itertools
import json
import os
import pathlib
import pickle
import random
import tempfile
import unittest

import changeover


def pairs_of(setup):
    return {frozenset(pair) for pair in itertools.combinations(setup, 2)}


def in_formats(order):
    """What COLMAP and Marius are given, or why they cannot be."""
    said = []
    for write in ("for_colmap", "for_marius"):
        try:
            said.append(getattr(order, write, str)())
        except changeover.BadInput as fault:
            said.append(str(fault))
    return said


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

    def test_pairs_within_groups(self):
        groups = [(i, i + 1, i + 2, (7 * i) % 30) for i in range(28)]
        wanted = {frozenset(pair) for group in groups for pair in itertools.combinations(group, 2)}
        wanted = {pair for pair in wanted if len(pair) == 2}
        order = changeover.load_order(None, 6, groups=groups)
        self.check(order, wanted, 6)
        listed = changeover.load_order(None, 6, pairs=[sorted(pair) for pair in wanted])
        self.assertEqual(list(order), list(listed))
        again = pickle.loads(pickle.dumps(order))
        self.assertEqual(list(again), list(order))

    def test_what_listed_pairs_cost_is_spread(self):
        rows = [(i, j, 1 + i * j % 7) for j in range(24) for i in range(j)]
        by_rows = changeover.load_order(None, 6, pairs=rows, workers=3)
        by_both = changeover.load_order(None, 6, pairs=[row[:2] for row in rows], workers=3,
                                        pair_cost=[*rows])
        self.assertEqual(by_rows.worker_costs, by_both.worker_costs)
        self.assertAlmostEqual(sum(by_rows.worker_costs), sum(row[2] for row in rows))

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
            ({"pairs": [(1, 2, 3)]}, "costs are for workers"),
            ({"pairs": [(1, 2, 3)], "workers": 2, "pair_cost": {}}, "costs are for workers"),
            (
                {"pairs": [(1, 2, 3), (2, 3)], "workers": 2},
                "only some of the rows 0 to 1 have a cost",
            ),
            ({"pairs": [(1, 2), (2, 3, 1)], "workers": 2}, "only some of the rows"),
            ({"pairs": [(1, 2, 3, 4)]}, "row 0 has more than two items"),
            ({"groups": [(1, 2), (8, 9)]}, "item 8 does not exist; items are 0 to 7"),
            ({"groups": [(1, -2)]}, "groups: items are numbered from 0"),
            ({"groups": [(1,)]}, "no pair is in a group"),
            ({"groups": [(1, 2)], "pairs": [(1, 2)]}, "pairs, groups, against and done_items"),
            ({"pairs": [(1, 2), (1,)]}, "row 1 has fewer than two items"),
            ({"pairs": [itertools.repeat(1)]}, "row 0 has more than two items"),
            ({"pairs": [(1, -2)]}, "items are numbered from 0"),
            ({"pairs": [(1, 10**8)]}, "items are numbered from 0"),
            ({"pairs": [(1, 9)]}, "9"),
            ({"pairs": [(1, 2)], "against": 3}, "pairs, groups, against and done_items exclude"),
            ({"done_items": 8}, ""),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(
                changeover.BadInput, words
            ) as caught:
                changeover.load_order(8, 3, **wrong)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaises(TypeError):
            changeover.load_order(8, 3, pairs=[("a", "b")])
        with self.assertRaisesRegex(changeover.BadInput, "items are required, unless pairs"):
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
        for wrong, says in (
            ({(0, 1): -1}, "0 or more"),
            ({(0, 99): 1}, "99"),
            ([(0, 1)], "is not .item, item, cost.; correct it"),
            ({(0, "x"): 1}, ""),
        ):
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
        made = [
            changeover.load_order(30, 7),
            changeover.load_order(30, 7, workers=3, new_pairs=True),
            changeover.load_order(None, 3, pairs=[(0, 1), (1, 2), (2, 0), (2, 3)]),
            changeover.load_order(30, 7, time=0.1, new_pairs=True),
            changeover.load_order(20, 5, time=0.1, write_back=True),
            changeover.load_order(20, 5, time=0.1, write_back=True, new_pairs=True),
            changeover.load_order(20, 5, time=0.1, write_back=True, epochs=2),
            changeover.load_order(20, 5, time=0.1, write_back=True, spread=True),
            changeover.load_order(20, 5, time=0.1, write_back=True, prefetch=True),
            changeover.load_order(20, 5, time=0.1, write_back=True, workers=3, disjoint=True),
            changeover.load_order(20, 5, time=0.1, workers=3, spread=True, shuffle=True),
            changeover.load_order(20, 5, time=0.1, shuffle=True, new_pairs=True),
            changeover.load_order(20, 5, time=0.1, epochs=2, spread=True),
            changeover.load_order(20, 5, time=0.1, workers=3, new_pairs=True),
            changeover.load_order(20, 5, time=0.1, workers=3, disjoint=True),
            changeover.load_order(20, 8, fast_room=5, time=0.1),
            changeover.load_order(None, 3, time=0.1, pairs=[(0, 4), (4, 2), (2, 1), (2, 3)]),
            changeover.load_order(None, sizes=[3, 4, 5, 6, 7], memory=14, time=0.1),
            changeover.load_order(30, 7, verify_beside=True),
            changeover.load_order(30, 7, verify_beside=True, time=0.1),
        ]
        for each in made:
            again = pickle.loads(pickle.dumps(each))
            self.assertIs(type(again), type(each))
            self.assertEqual((again, hash(again)), (each, hash(each)))
            self.assertEqual(copy.deepcopy(again), each)
            self.assertEqual(again.to_json().splitlines()[1:], each.to_json().splitlines()[1:])
            self.assertEqual(again.loads, each.loads)
            self.assertEqual(in_formats(again), in_formats(each))
            if isinstance(each, changeover.LoadOrder):
                self.assertEqual(list(again), list(each))
                self.assertEqual(len(again), len(list(again)))
                self.assertEqual(list(again.steps_from(2)), list(each.steps_from(2)))
                self.assertEqual(list(again.work()), list(each.work()))
                self.assertEqual(again.draw(), each.draw())
            else:
                for worker in range(3):
                    self.assertEqual(list(again.steps(worker)), list(each.steps(worker)))
                    self.assertEqual(list(again.work(worker)), list(each.work(worker)))
            self.assertEqual(pickle.loads(pickle.dumps(again)).to_json(), again.to_json())
            call, (kind, state, checksum) = each.__reduce_ex__(4)
            with self.assertRaisesRegex(changeover.BadInput, "is damaged"):
                call(kind, state[:-1] + b"x", checksum)

    def test_which_worker_has_a_pair_is_not_found_again(self):
        order = changeover.load_order(20, 5, time=0.1, workers=3)
        self.assertEqual(len(order.for_colmap().split()), 380)
        with self.assertRaisesRegex(changeover.BadInput, "plan it again, with new_pairs=True$"):
            pickle.loads(pickle.dumps(order)).for_colmap()

    def test_what_was_asked_is_a_document(self):
        for asked in (
            dict(items=9, room=3),
            dict(items=9, room=3, workers=2, disjoint=True, new_pairs=True, with_self=True),
            dict(items=None, room=3, pairs=[(0, 1), (1, 4)]),
            dict(items=None, memory=9, sizes=[3, 4, 5]),
            dict(items=9, room=3, time=0.1, seed=5),
        ):
            order = changeover.load_order(**asked)
            with self.subTest(asked=asked):
                said = json.loads(order.request_json())
                self.assertEqual(said["format"], "changeover-load-request/1")
                self.assertEqual(said.get("items"), asked["items"])
                self.assertEqual(said.get("seconds"), asked.get("time"))
                self.assertEqual(said.get("self"), asked.get("with_self"))
                if "pairs" in asked:
                    self.assertEqual(said["pairs"], [["0", "1"], ["1", "4"]])
                again = pickle.loads(pickle.dumps(order))
                self.assertEqual(again.request_json(), order.request_json())

    def test_orders_may_be_verified_beside(self):
        order = changeover.load_order(300, 20, verify_beside=True)
        self.assertEqual(len(list(order)), order.steps)
        self.assertTrue(order.verified())
        self.assertTrue(changeover.load_order(30, 7, workers=3, verify_beside=True).verified())

    def test_a_short_last_item_is_meant_or_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "items")
            with open(path, "wb") as file:
                file.write(bytes(102))
            sizes = set()

            def compute(i, j, first, second):
                sizes.add(len(first))

            with self.assertRaisesRegex(changeover.BadInput, "the last one would have 2"):
                changeover.all_pairs(path, 10, 4, compute)
            self.assertTrue(
                changeover.all_pairs(path, 10, 4, compute, header_bytes=2).finished)
            self.assertEqual(sizes, {10})
            self.assertTrue(changeover.all_pairs(path, 10, 4, compute, short_last=True).finished)
            self.assertEqual(sizes, {2, 10})

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
        self.assertEqual(
            (len(split), split.makespan, split.loads),
            (3, max(split.worker_loads), sum(split.worker_loads)),
        )
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
        for wrong, words in (
            ({"workers": 0}, "^workers 0: give at least 1"),
            ({"workers": 2**40}, "^workers 1099511627776: give 1 to"),
        ):
            with self.assertRaisesRegex(changeover.BadInput, words):
                changeover.load_order(24, 6, **wrong)


class Sizes(unittest.TestCase):
    def test_what_is_held_fits_into_the_memory(self):
        sizes = [(1 + i * i % 13) * 1000 for i in range(20)]
        order = changeover.load_order(None, sizes=sizes, memory=50_000, new_pairs=True)
        held, loaded, pairs = set(), 0, []
        for step in order.work():
            held -= set(step.evict)
            held |= set(step.load)
            loaded += sum(sizes[item] for item in step.load)
            self.assertLessEqual(sum(sizes[item] for item in held), 50_000)
            pairs += step.pairs
        self.assertEqual((loaded, len(set(pairs)), len(pairs)), (order.bytes, 190, 190))
        self.assertLessEqual(order.bytes_bound, order.bytes)
        self.assertIsNone(changeover.load_order(6, 3).bytes)
        listed = changeover.load_order(
            None, pairs=[(0, 2), (2, 3)], sizes={0: 5, 2: 4, 3: 3}, memory=9
        )
        self.assertEqual(listed.bytes, 12)

    def replayed(self, work, sizes, memory):
        """Bytes that the steps load and the pairs that they compute; checks what is held."""
        held, loaded, pairs, overlap = set(), 0, [], []
        for step in work:
            early = step.evict[: len(step.evict) - step.late]
            self.assertLessEqual(set(step.evict), held)
            held -= set(early)
            come = sum(sizes[item] for item in step.load)
            self.assertLessEqual(sum(sizes[item] for item in held) + come, memory)
            for pair in overlap:  # while these items load
                self.assertLessEqual(set(pair), held)
            held -= set(step.evict)
            self.assertFalse(held & set(step.load))
            held |= set(step.load)
            loaded += come
            for pair in step.pairs:
                self.assertLessEqual(set(pair), held)
            pairs += overlap + step.pairs
            overlap = step.overlap
        for pair in overlap:
            self.assertLessEqual(set(pair), held)
        return loaded, pairs + overlap

    def test_random_lists_for_workers_and_with_prefetch(self):
        chance = random.Random(5)
        for round in range(12):
            items = chance.randint(4, 20)
            sizes = [chance.randint(1, 40) for _ in range(items)]
            every = list(itertools.combinations(range(items), 2))
            wanted = chance.sample(every, chance.randint(items - 1, len(every)))
            memory = max(sizes[a] + sizes[b] for a, b in wanted) + chance.randint(0, 60)
            workers = chance.randint(2, 6)
            how = {"prefetch": True} if round % 2 else {"new_pairs": True}
            asked = {"pairs": wanted, "sizes": sizes, "memory": memory, **how}
            split = changeover.load_order(items, workers=workers, **asked)
            shares = [self.replayed(split.work(w), sizes, memory) for w in range(workers)]
            self.assertEqual([loaded for loaded, _ in shares], split.worker_bytes)
            self.assertEqual(max(split.worker_bytes), split.makespan_bytes)
            self.assertEqual(sum(split.worker_bytes), split.bytes)
            self.assertGreaterEqual(split.makespan_bytes, split.makespan_bytes_bound)
            self.assertEqual(sorted(pair for _, its in shares for pair in its), sorted(wanted))
            order = changeover.load_order(items, **asked)
            loaded, pairs = self.replayed(order.work(), sizes, memory)
            self.assertEqual((loaded, sorted(pairs)), (order.bytes, sorted(wanted)))
        self.assertIsNone(changeover.load_order(12, 4, workers=2).worker_bytes)

    def test_two_levels(self):
        """Both levels are replayed, with items of one size and of several, for workers and epochs.
        """
        sizes = [1 + i * i % 13 for i in range(14)]
        ones = [1] * 14
        bytes_at_once = {"sizes": sizes, "memory": 50, "fast_memory": 30}
        for more, size, memory, fast in (
            ({"room": 7, "fast_room": 4}, ones, 7, 4),
            ({"room": 7, "fast_room": 4, "workers": 3}, ones, 7, 4),
            ({"room": 7, "fast_room": 4, "workers": 2, "epochs": 3}, ones, 7, 4),
            ({"room": 7, "fast_room": 4, "against": 5}, [1] * 19, 7, 4),
            (bytes_at_once, sizes, 50, 30),
            ({**bytes_at_once, "workers": 3}, sizes, 50, 30),
            ({**bytes_at_once, "epochs": 2}, sizes, 50, 30),
        ):
            order = changeover.load_order(14, new_pairs=True, **more)
            workers = more.get("workers")
            pairs, transfers, transferred = [], 0, 0
            for work in [order.work()] if workers is None else map(order.work, range(workers)):
                held, there = set(), set()
                for step in work:
                    self.assertLessEqual(set(step.fast_evict), there)
                    there -= set(step.fast_evict)
                    self.assertFalse(set(step.evict) & there)
                    held = held - set(step.evict) | set(step.load)
                    self.assertLessEqual(set(step.fast_load), held - there)
                    there |= set(step.fast_load)
                    self.assertLessEqual(sum(size[x] for x in held), memory)
                    self.assertLessEqual(sum(size[x] for x in there), fast)
                    self.assertTrue(all(set(pair) <= there for pair in step.pairs))
                    pairs += [(step.epoch, *pair) for pair in step.pairs]
                    transfers += len(step.fast_load)
                    transferred += sum(size[x] for x in step.fast_load)
            wanted = 14 * 5 if "against" in more else 91
            self.assertEqual(len(set(pairs)), len(pairs))
            self.assertEqual(len(pairs), wanted * more.get("epochs", 1))
            self.assertEqual(transfers, order.transfers)
            self.assertGreaterEqual(order.transfers, order.transfer_bound)
            if "sizes" in more:
                self.assertEqual(transferred, order.bytes_transferred)
                self.assertGreaterEqual(transferred, order.transfer_bytes_bound)
            again = pickle.loads(pickle.dumps(order))
            self.assertEqual(again.to_json(), order.to_json())
        self.assertIsNone(changeover.load_order(6, 3).transfers)

    def test_what_does_not_fit_is_refused(self):
        for more, why in (
            ({"sizes": [3, 6], "memory": 8}, "9 bytes together"),
            ({"sizes": [3, 6], "memory": 9, "fast_memory": 10}, "fast_memory 10: of memory 9"),
            ({"sizes": [3, 6], "memory": 9, "fast_memory": 8}, "the accelerator"),
            ({"sizes": [3, 6], "memory": 9, "fast_room": 2}, "fast_memory"),
            ({"sizes": [3, 6]}, "memory"),
            ({"sizes": [3, 0.5], "memory": 9}, "whole number of bytes"),
            ({}, "items (and room )?are required"),
        ):
            with self.assertRaisesRegex(changeover.BadInput, why):
                changeover.load_order(None, **more)


class Epochs(unittest.TestCase):
    def test_every_pair_is_computed_once_in_each_epoch(self):
        for more in ({}, {"workers": 3}, {"workers": 2, "disjoint": True}, {"write_back": True}):
            order = changeover.load_order(
                16,
                5,
                epochs=3,
                new_pairs=True,
                spread=True,
                ordered=True,
                with_self=True,
                seed=2,
                **more,
            )
            self.assertEqual(len(order.epoch_loads), 3)
            self.assertEqual(sum(order.epoch_loads), order.loads)
            seen = collections.Counter()
            for worker in range(more.get("workers", 1)):
                held = set()
                for step in order.work(worker) if "workers" in more else order.work():
                    held -= set(step.evict)
                    held |= set(step.load)
                    self.assertLessEqual(len(held), 5)
                    for i, j in step.pairs:
                        self.assertTrue({i, j} <= held)
                        seen[step.epoch, i, j] += 1
            self.assertEqual(
                seen, collections.Counter(itertools.product((1, 2, 3), range(16), range(16)))
            )
            again = pickle.loads(pickle.dumps(order))
            self.assertEqual((again.loads, again.epoch_loads), (order.loads, order.epoch_loads))

    def test_what_marius_needs_is_what_the_order_says(self):
        order = changeover.load_order(16, 4, epochs=2, new_pairs=True, spread=True)
        first, second = order.for_marius()
        self.assertEqual(first["buffer_states"][-1], second["buffer_states"][0])
        for epoch in (first, second):
            self.assertEqual((epoch["num_partitions"], epoch["buffer_capacity"]), (16, 4))
            buckets = [
                tuple(bucket) for each in epoch["edge_buckets_per_buffer"] for bucket in each
            ]
            self.assertEqual(sorted(buckets), list(itertools.product(range(16), range(16))))
            for state, each in zip(epoch["buffer_states"], epoch["edge_buckets_per_buffer"]):
                self.assertEqual(len(set(state)), 4)
                self.assertTrue(set(sum(each, [])) <= set(state))
        alone = changeover.load_order(16, 4, epochs=2, spread=True)
        self.assertEqual(alone.for_marius(), order.for_marius())
        with self.assertRaisesRegex(changeover.BadInput, "one buffer"):
            changeover.load_order(16, 4, prefetch=True).for_marius()
        # Not only the command line holds to what fits into memory.
        with self.assertRaisesRegex(
            changeover.BadInput, "epochs 100000: with spread or for Marius"
        ):
            changeover.load_order(64, 16, epochs=100000).for_marius()
        with self.assertRaisesRegex(changeover.BadInput, "give epochs 49603 or less"):
            changeover.load_order(64, 16, epochs=100000, new_pairs=True, spread=True)

    def test_colmap_is_given_each_pair_once(self):
        groups = [[0, 1, 2], [1, 2, 3], [3, 4]]
        wanted = {pair for group in groups for pair in itertools.combinations(group, 2)}
        for more in (dict(), dict(workers=2)):
            text = changeover.load_order(None, 3, groups=groups, **more).for_colmap()
            pairs = [tuple(map(int, line.split())) for line in text.splitlines() if line]
            self.assertEqual(sorted(pairs), sorted(wanted))
            self.assertTrue(all(len(set(block.split())) <= 3 for block in text.split("\n\n")))
        with self.assertRaisesRegex(changeover.BadInput, "each pair once"):
            changeover.load_order(16, 4, epochs=2).for_colmap()

    def test_items_change_and_a_job_that_raised_goes_on(self):
        def run(folder, workers, stops=()):
            data = os.path.join(folder, "data")
            if not os.path.exists(data):
                pathlib.Path(data).write_bytes(bytes(12 * 8))
            calls = []

            def update(i, j, first, second):
                calls.append((i, j))
                if len(calls) in stops:
                    raise OSError("stopped")
                for view, other in ((first, j), (second, i)):
                    view[:2] = (int.from_bytes(view[:2], "little") + other + 1).to_bytes(
                        2, "little"
                    )

            return (
                changeover.update_pairs(
                    data,
                    8,
                    4,
                    update,
                    journal=os.path.join(folder, "journal"),
                    workers=workers,
                    epochs=3,
                    spread=True,
                    shuffle=True,
                    checkpoint_every=5,
                ),
                pathlib.Path(data).read_bytes(),
            )

        for workers in (1, 2):
            with tempfile.TemporaryDirectory() as folder, tempfile.TemporaryDirectory() as other:
                report, data = run(folder, workers)
                self.assertEqual((report.finished, report.updates), (True, 3 * 66))
                with self.assertRaisesRegex(OSError, "stopped"):
                    run(other, workers, stops=(120,))
                again, same = run(other, workers)
                self.assertEqual(same, data)
                self.assertGreater(again.steps_resumed, 0)
                self.assertEqual(int.from_bytes(data[:2], "little"), 3 * sum(range(2, 13)))

    def test_a_checkpoint_every_0_steps_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            data = os.path.join(folder, "data")
            pathlib.Path(data).write_bytes(bytes(64))
            with self.assertRaisesRegex(changeover.BadInput, "checkpoint_every 0: give at least 1"):
                changeover.update_pairs(data, 8, 3, lambda i, j, a, b: None,
                                        journal=os.path.join(folder, "journal"), checkpoint_every=0)
            self.assertEqual(os.listdir(folder), ["data"])

    def test_what_update_keeps_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            data = os.path.join(folder, "data")
            pathlib.Path(data).write_bytes(bytes(64))
            kept = []
            with self.assertRaisesRegex(changeover.BadInput, "has kept memory of item"):
                changeover.update_pairs(data, 8, 3, lambda i, j, a, b: kept.append(a[1:3]),
                                        journal=os.path.join(folder, "journal"))


if __name__ == "__main__":
    unittest.main()
