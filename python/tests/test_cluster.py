"""Runs on clusters, without one: stretches, memory of a worker, journals, shares, simulations."""

import collections
import itertools
import os
import random
import sys
import tempfile
import threading
import unittest
import warnings

import changeover
from changeover import cluster
from changeover.cluster import _job, _journal, _simulation, _stretches, _team, _worker


_plans = {}
_plan = _job._plan


def _planned_once(asked, ends, seconds=None):
    question = repr((asked, ends))
    if question not in _plans:
        _plans[question] = _plan(asked, ends, seconds)
    return _plans[question]


def setUpModule():
    unittest.addModuleCleanup(setattr, _job, "_plan", _plan)
    _job._plan = _planned_once


def wanted(items, room, pairs=None, **named):
    given = {"against": None, "done_items": None, "with_self": False, "cost": None, **named}
    return _job.Wanted(items, room, pairs, **given)


def shares_of(items, room, workers, pairs=None, **named):
    return wanted(items, room, pairs, **named).shares(workers)[0]


def taken(run, most, rng):
    stretches = []
    while run:
        stretches.append(run.take(len(stretches), rng.uniform(0.5, most)))
    return stretches


def jobs(count):
    """Random questions: items, room, workers, pairs or None. Each test has the same ones, so that
    each is planned once: for a list of pairs that takes a second."""
    rng = random.Random(1)
    for _ in range(count):
        items = rng.randint(2, 24)
        every = list(itertools.combinations(range(items), 2))
        pairs = None if rng.random() < 0.5 else rng.sample(every, rng.randint(1, len(every)))
        yield items, rng.randint(2, 8), rng.randint(1, 5), pairs


def memory(room, log=None, **named):
    def load(x):
        if log is not None:
            log.append(x)
        return x * 10
    return _worker.Memory(load, lambda i, j, a, b: (i, j, a, b), room, **named)


class Stretches(unittest.TestCase):
    def test_any_worker_may_do_any_stretch(self):
        rng = random.Random(1)
        for items, room, workers, pairs in jobs(60):
            done = collections.Counter()
            memories = [memory(room) for _ in range(3)]
            for run in shares_of(items, room, workers, pairs):
                for stretch in taken(run, 12, rng):
                    outcome = rng.choice(memories).run(stretch)
                    self.assertIsNone(outcome.failure)
                    self.assertLessEqual(outcome.most_held, room)
                    for (i, j), result in zip(stretch.each_pair(), outcome.results, strict=True):
                        self.assertEqual(result, (i, j, 10 * i, 10 * j))
                        done[i, j] += 1
            every = pairs if pairs is not None else itertools.combinations(range(items), 2)
            self.assertEqual(done, collections.Counter(dict.fromkeys(every, 1)))

    def test_one_after_the_other_they_load_what_was_planned(self):
        rng = random.Random(2)
        for items, room, workers, pairs in jobs(60):
            for run in shares_of(items, room, workers, pairs):
                planned, loads = run.loads, 0
                worker = memory(room)
                for stretch in taken(run, 7, rng):
                    loads += worker.run(stretch).loads
                self.assertLessEqual(loads, planned)

    def test_the_plan_is_that_of_load_order(self):
        for items, room in ((32, 8), (20, 5), (7, 9)):
            (run,) = shares_of(items, room, 1)
            self.assertEqual(run.loads, changeover.load_order(items, room).loads)

    def test_runs_are_cut_in_two_anywhere(self):
        rng = random.Random(3)
        for items, room, workers, pairs in jobs(60):
            for run in shares_of(items, room, workers, pairs):
                every = [pair for step in run for pair in zip(step.ends[::2], step.ends[1::2])]
                runs = [run]
                for _ in range(4):
                    each = rng.choice(runs)
                    runs.insert(runs.index(each) + 1, each.split(rng.uniform(0, 1.2 * each.cost)))
                self.assertEqual(every, [pair for each in runs for step in each
                                         for pair in zip(step.ends[::2], step.ends[1::2])])
                self.assertAlmostEqual(sum(each.cost for each in runs), len(every))
                for each in runs:
                    worker = memory(room)
                    for stretch in taken(each, 9, rng):
                        self.assertIsNone(worker.run(stretch).failure)

    def test_what_is_done_needs_no_load(self):
        rng = random.Random(4)
        for items, room, workers, pairs in jobs(60):
            for run in shares_of(items, room, workers, pairs):
                every = [pair for step in run for pair in zip(step.ends[::2], step.ends[1::2])]
                done = set(rng.sample(every, rng.randint(0, len(every))))
                rest = _stretches.without(run, lambda i, j: (i, j) in done, None)
                left = [pair for step in rest for pair in zip(step.ends[::2], step.ends[1::2])]
                self.assertEqual(left, [pair for pair in every if pair not in done])
                self.assertLessEqual(rest.loads, run.loads)
                needed = {x for pair in left for x in pair}
                self.assertLessEqual({x for step in rest for x in step.load}, needed)

    def test_costs_say_where_to_cut(self):
        costs = {pair: 1 + 9 * (pair[0] < 4) for pair in itertools.combinations(range(16), 2)}
        (run,) = shares_of(16, 5, 1, cost=lambda i, j: costs[i, j])
        self.assertEqual(run.cost, sum(costs.values()))
        stretches = []
        while run:
            stretches.append(run.take(0, 40))
        spent = [sum(costs[pair] for pair in each.each_pair()) for each in stretches]
        self.assertEqual(spent, [each.cost for each in stretches])
        self.assertLess(max(spent), 60)
        self.assertGreater(len({each.pairs for each in stretches}), 2)

    def test_a_stretch_is_done_again_after_its_first_pairs(self):
        (run,) = shares_of(12, 4, 1)
        stretch = run.take(1, 30)
        pairs = list(stretch.each_pair())
        for after in range(len(pairs) + 1):
            again = _stretches.Run.of(stretch, None, 0, after)
            outcome = memory(4).run(again.take(2, 1e9)) if again else None
            done = [] if outcome is None else [result[:2] for result in outcome.results]
            self.assertEqual(done, pairs[after:])


class Memory(unittest.TestCase):
    def test_threads_and_overlap_change_nothing(self):
        rng = random.Random(5)
        for items, room, _, pairs in jobs(25):
            if room < 3:
                continue
            (run,) = shares_of(items, room - 1, 1, pairs)
            stretches = taken(run, 30, rng)
            for named in ({"threads": 3}, {"overlap": True}, {"threads": 2, "overlap": True}):
                log = []
                worker = memory(room, log, **named)
                for stretch in stretches:
                    outcome = worker.run(stretch)
                    self.assertIsNone(outcome.failure)
                    self.assertEqual([each[:2] for each in outcome.results],
                                     list(stretch.each_pair()))
                    self.assertLessEqual(outcome.most_held, room)
                worker.close()

    def test_loads_overlap_computation(self):
        (run,) = shares_of(12, 4, 1)
        stretch = run.take(1, 1e9)
        loading, computing = threading.Event(), threading.Event()

        def load(x):
            if computing.is_set():
                loading.set()
            return x

        def compute(i, j, a, b):
            computing.set()
            self.assertTrue(loading.wait(20), "nothing is loaded while pairs are computed")

        worker = _worker.Memory(load, compute, 5, overlap=True)
        self.assertIsNone(worker.run(stretch).failure)
        worker.close()

    def test_what_is_raised_names_the_item_or_the_pair(self):
        (run,) = shares_of(12, 4, 1)
        stretch = run.take(1, 1e9)

        def load(x):
            if x == 7:
                raise OSError("no such file")
            return x

        def compute(i, j, a, b):
            if (i, j) == (2, 9):
                raise KeyError("nothing")

        for threads in (1, 3):
            outcome = _worker.Memory(load, lambda *_: None, 4, threads=threads).run(stretch)
            self.assertEqual((outcome.failure.what, outcome.failure.items), ("load", (7,)))
            worker = _worker.Memory(lambda x: x, compute, 4, threads=threads)
            outcome = worker.run(stretch)
            self.assertEqual((outcome.failure.what, outcome.failure.items), ("compute", (2, 9)))
            # What was computed before it is not lost.
            self.assertLess(len(outcome.results), stretch.pairs)
            self.assertNotIn((2, 9), list(stretch.each_pair())[:len(outcome.results)])

    def test_failures_are_of_the_class_that_was_raised(self):
        def failure(fault):
            return _pairs_failed(_worker.Failure.of("load", (3,), fault))
        from changeover.cluster._failed import failed

        def _pairs_failed(each):
            return failed(each, "a worker")

        for fault in (KeyError("x"), OSError(2, "gone"), ValueError("bad"), StopIteration(),
                      UnicodeDecodeError("utf-8", b"x", 0, 1, "odd"), changeover.BadInput("odd")):
            with self.subTest(fault=fault):
                made = failure(fault)
                self.assertIsInstance(made, cluster.Failed)
                self.assertIsInstance(made, type(fault))
                self.assertIn("load(3) raised", str(made))
                self.assertEqual((made.what, made.items), ("load", (3,)))

        class Local(Exception):
            pass

        self.assertIs(type(failure(Local("here only"))), cluster.Failed)

    def test_results_that_cannot_be_sent_name_their_pair(self):
        (run,) = shares_of(12, 4, 1)
        stretch = run.take(1, 1e9)
        outcome = _worker.Memory(lambda x: x, lambda *_: threading.Lock(), 4).run(stretch)
        self.assertEqual(outcome.failure.items, next(iter(stretch.each_pair())))
        self.assertIn("pickle", outcome.failure.says)

    def test_it_stops_when_it_is_told(self):
        (run,) = shares_of(12, 4, 1)
        stretch = run.take(1, 1e9)
        outcome = memory(4).run(stretch, iter([False] * 10 + [True] * 1000).__next__)
        self.assertTrue(outcome.stopped)
        self.assertLess(len(outcome.results), stretch.pairs)


class Journal(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "journal")
        self.job = _journal.name_of_job(9, None, "all", "")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, pairs, every=4):
        journal = _journal.Journal(self.path, self.job)
        for number, pair in enumerate(pairs):
            journal.record(*pair)
            if number % every == every - 1:
                journal.checkpoint()
        return journal

    def read(self):
        journal = _journal.Journal(self.path, self.job)
        done = list(journal.done())
        journal.close()
        return done

    def test_what_was_recorded_is_found_again(self):
        pairs = list(itertools.combinations(range(9), 2))
        self.write(pairs[:7]).close()
        self.assertEqual(self.read(), pairs[:7])
        self.write(pairs[7:9]).close()
        self.assertEqual(self.read(), pairs[:9])

    def test_a_line_that_was_cut_off_does_not_count(self):
        pairs = list(itertools.combinations(range(9), 2))
        self.write(pairs[:11]).close()
        with open(self.path, "rb") as file:
            whole = file.read()
        head = whole.index(b"\n") + 1
        for end in range(head, len(whole)):
            with open(self.path, "wb") as file:
                file.write(whole[:end])
            done = self.read()
            self.assertEqual(done, pairs[:whole[head:end].count(b"\n")])

    def test_what_was_damaged_does_not_count(self):
        pairs = list(itertools.combinations(range(9), 2))
        self.write(pairs[:12]).close()
        with open(self.path, "rb") as file:
            whole = file.read()
        head = whole.index(b"\n") + 1
        rng = random.Random(6)
        for _ in range(200):
            place = rng.randrange(head, len(whole) - 1)
            wrong = bytes([whole[place] ^ 1 << rng.randrange(8)])
            with open(self.path, "wb") as file:
                file.write(whole[:place] + wrong + whole[place + 1:])
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                done = self.read()
            self.assertEqual(done, pairs[:whole[head:place].count(b"\n")])
            self.assertEqual(len(said), 1)
            self.assertIn("damaged at byte", str(said[0].message))

    def test_others_are_refused(self):
        journal = self.write([(0, 1)])
        with self.assertRaisesRegex(changeover.MissingResource, "another run uses this journal"):
            _journal.Journal(self.path, self.job)
        journal.close()
        for other in (_journal.name_of_job(10, None, "all", ""),
                      _journal.name_of_job(9, [(0, 1)], "listed", ""),
                      _journal.name_of_job(9, None, "all", "mine")):
            with self.assertRaisesRegex(changeover.BadInput, "journal is of another job"):
                _journal.Journal(self.path, other)
        self.assertEqual(self.read(), [(0, 1)])
        with open(self.path, "w") as file:
            file.write("my notes\n")
        with self.assertRaisesRegex(changeover.BadInput, "not a journal"):
            _journal.Journal(self.path, self.job)
        with open(self.path) as file:
            self.assertEqual(file.read(), "my notes\n")
        with self.assertRaises(changeover.MissingResource):
            _journal.Journal(os.path.join(self.folder.name, "no", "such"), self.job)

    def test_pairs_are_known_again(self):
        for items in (5, 100_000_000):
            pairs = _journal.PairSet(items)
            self.assertTrue(pairs.add(1, 3))
            self.assertFalse(pairs.add(1, 3))
            self.assertTrue(pairs.add(items - 2, items - 1))
            self.assertTrue(pairs.add(4, 4))
            self.assertIn((1, 3), pairs)
            self.assertNotIn((1, 2), pairs)
            self.assertEqual(pairs.count, 3)


def play(items, room, workers, pairs, seed, sink, retries=0, faulty=None, cost=None,
         **cluster_named):
    """A run with a simulated engine whose workers really compute."""
    named = {"mean_bytes": 1.0, "pair_seconds": 1.0, "bandwidth": 1.0,
             "store": 3.0, "latency": 0.0, "overhead": 0.1, "failures": 0.0, "restart": 20.0,
             "stragglers": 0.3, "slowness": 5.0, "overlap": False, **cluster_named}
    setting = _simulation._Cluster(**named)
    work = _job.Work(wanted(items, room, pairs, cost=cost), sink, retries, "", "")
    memories = {}

    def compute(i, j, a, b):
        if faulty is not None:
            faulty(i, j)
        return i, j, a, b

    def do(worker, stretch):
        if worker not in memories:
            memories[worker] = _worker.Memory(lambda x: 10 * x, compute, room)
        outcome = memories[worker].run(stretch)
        outcome.bytes_loaded = outcome.loads
        assert outcome.most_held <= room
        return outcome

    engine = _simulation._Simulated(
        setting, workers, seed, do, lambda each: memories.pop(each, None)
    )
    team = _team.Team(engine, work.deliver, work.replan, work.again, 8, lambda _: None)
    shares, _ = work.first_shares(workers)
    team.planned_loads = sum(run.loads for share in shares for run in share)
    team.run(shares, lambda: work.left == 0)
    return team


class Teams(unittest.TestCase):
    def test_every_pair_comes_once_whatever_happens_to_workers(self):
        rng = random.Random(7)
        lost = stolen = copied = 0
        for seed, (items, room, workers, pairs) in enumerate([*jobs(60)] * 2):
            got = {}

            def sink(i, j, result):
                self.assertNotIn((i, j), got)
                self.assertEqual(result, (i, j, 10 * i, 10 * j))
                got[i, j] = result

            team = play(items, room, workers, pairs, seed, sink,
                        failures=rng.choice([0, 0.005, 0.02]))
            every = pairs if pairs is not None else itertools.combinations(range(items), 2)
            self.assertEqual(set(got), set(every))
            lost, stolen, copied = lost + team.lost, stolen + team.stolen, copied + team.copied
        self.assertGreater(lost, 100)
        self.assertGreater(stolen, 20)
        self.assertGreater(copied, 5)

    def test_without_faults_loads_are_near_the_plan(self):
        for items, room, workers in ((32, 8, 2), (48, 10, 4), (64, 16, 4), (100, 20, 6)):
            team = play(items, room, workers, None, 1, lambda *_: None, stragglers=0.0, store=1e9)
            self.assertLessEqual(team.loads, 1.15 * team.planned_loads)
            self.assertGreaterEqual(team.loads, team.planned_loads)

    def test_functions_that_raise_are_called_again_so_often(self):
        tries = collections.Counter()

        def sometimes(i, j):
            tries[i, j] += 1
            if (i + j) % 7 == 0 and tries[i, j] < 3:
                raise ValueError("not yet")

        got = collections.Counter()
        team = play(14, 5, 3, None, 1, lambda i, j, _: got.update([(i, j)]), retries=2,
                    faulty=sometimes)
        self.assertEqual(got, collections.Counter(itertools.combinations(range(14), 2)))
        self.assertEqual(max(tries.values()), 3)
        self.assertGreater(team.retried, 5)
        tries.clear()
        with self.assertRaisesRegex(
            cluster.Failed, r"compute\(\d+, \d+\) raised ValueError: not yet"
        ):
            play(14, 5, 3, None, 1, None, retries=1, faulty=sometimes)

    def test_what_kills_its_workers_is_named(self):
        class Kills(_simulation._Simulated):
            def submit(self, worker, part):
                super().submit(worker, part)
                if (3, 8) in part.each_pair():
                    self._push(self.now() + 0.05, "fails", worker)

        original = _simulation._Simulated
        _simulation._Simulated = Kills
        try:
            with self.assertRaisesRegex(
                _team.NoWorkers,
                r"the pair \(3, 8\) was under way on 8 workers when they were lost; does it take more memory than they have\?",
            ):
                play(14, 5, 3, None, 1, None, restart=1.0)
        finally:
            _simulation._Simulated = original

    def test_lists_of_fragments_are_planned_anew(self):
        rng = random.Random(8)
        every = list(itertools.combinations(range(40), 2))
        work = _job.Work(wanted(40, 8), None, 0, "", "")
        shares, _ = work.first_shares(1)
        done = set(rng.sample(every, 700))
        rest = [_stretches.without(run, lambda i, j: (i, j) in done, None) for run in shares[0]]
        fragments = []
        for run in rest:
            while run:
                fragments.append(_stretches.Run.of(run.take(0, 3), None, 0))
        before = sum(run.loads for run in fragments)
        anew = work.replan(fragments, 2)
        self.assertEqual(sorted(pair for share in anew for run in share for step in run
                                for pair in zip(step.ends[::2], step.ends[1::2])),
                         sorted(set(every) - done))
        self.assertLess(sum(run.loads for share in anew for run in share), before)


class Questions(unittest.TestCase):
    def test_wrong_ones_are_refused(self):
        for named in (
            {}, {"items": 5, "pairs": [(0, 1)], "against": 3}, {"items": 3, "pairs": [(0, 3)]},
            {"items": 5, "pairs": []}, {"items": 5, "cost": [1, 2]},
            {"items": None, "pairs": [(0, 1), (1, 2)], "cost": [1]},
            {"items": None, "pairs": [(0, 1)], "cost": ["much"]},
            {"items": None, "pairs": [(0, 1)], "cost": [-1]},
        ):
            with self.subTest(**named), self.assertRaises(changeover.BadInput):
                wanted(named.pop("items", None), 4, **named)
        with self.assertRaisesRegex(cluster.Failed, r"cost\(0, 1\) raised ZeroDivisionError"):
            shares_of(5, 3, 1, cost=lambda i, j: 1 / 0)
        with self.assertRaises(changeover.ImpossibleParameters):
            wanted(60_000, 100)
        for client in (None, 3, "tcp://127.0.0.1:1", sys):
            with self.assertRaisesRegex(TypeError, "client is a distributed.Client"):
                cluster.all_pairs(client, items=5, room=3, load=abs, compute=max)
        with self.assertRaisesRegex(TypeError, "load is a function"):
            cluster.all_pairs(None, items=5, room=3, load="path", compute=max)

    def test_pairs_of_every_kind(self):
        def pairs_of(*given, **named):
            each = wanted(*given, **named)
            found = [pair for run in each.shares(2)[0] for step in run
                     for pair in zip(step.ends[::2], step.ends[1::2])]
            self.assertEqual(len(found), each.count)
            self.assertEqual(len(found), len(set(found)))
            return set(found)
        self.assertEqual(pairs_of(4, 3, against=3), set(itertools.product(range(4), range(4, 7))))
        self.assertEqual(pairs_of(7, 3, done_items=5),
                         {(i, j) for i, j in itertools.combinations(range(7), 2) if j >= 5})
        self.assertEqual(pairs_of(None, 3, [(3, 1), (1, 3), (2, 2), (0, 3)]),
                         {(1, 3), (2, 2), (0, 3)})
        self.assertEqual(pairs_of(None, 3, groups=[[0, 1, 2], [2, 1, 4], [3], []]),
                         {(0, 1), (0, 2), (1, 2), (1, 4), (2, 4)})
        self.assertEqual(pairs_of(5, 3, with_self=True),
                         set(itertools.combinations_with_replacement(range(5), 2)))

    def test_pairs_are_said_in_one_way(self):
        for ask, fault in ((lambda: wanted(5, 3, [(0, 1)], against=2), "give one of pairs, groups"),
                           (lambda: wanted(None, 3), "give items, how many there are")):
            with self.assertRaisesRegex(changeover.BadInput, fault):
                ask()
        for groups, fault in (([], "groups has no pair"), ([[1], [2]], "groups has no pair"),
                              ([[0, 7]], "groups: there are 5 items, .* a group has number 7"),
                              ([[0, -1]], "groups: items are numbered"),
                              ([3], "groups")):
            with self.assertRaisesRegex((changeover.BadInput, TypeError), fault):
                wanted(5, 3, groups=groups)
        with self.assertRaisesRegex(
            changeover.BadInput, "a list of costs goes with a list of pairs"
        ):
            wanted(5, 3, groups=[[0, 1]], cost=[1])

    def test_a_simulation_takes_groups(self):
        said = cluster.simulate(items=12, room=4, workers=2, pair_seconds=1, item_bytes=10,
                                groups=[[0, 1, 2, 3], [3, 4, 5]])
        self.assertEqual(said.pairs, 9)

    def test_sizes(self):
        self.assertEqual(_job.sizes_of(7, 3)(2), 7)
        self.assertEqual(_job.sizes_of([1, 2, 3], 3)(2), 3)
        self.assertEqual(_job.sizes_of(lambda x: x * x, 3)(2), 4)
        self.assertIsNone(_job.sizes_of(None, 3))
        for wrong in ([1, 2], [1, 2, -1], "big", [1, 2, 0.5]):
            with self.assertRaises((changeover.BadInput, TypeError)):
                _job.sizes_of(wrong, 3)


class Simulations(unittest.TestCase):
    setting = {"items": 60, "room": 12, "workers": 5, "pair_seconds": 0.1, "item_bytes": 10**7}

    def test_the_same_seed_gives_the_same(self):
        named = {**self.setting, "failures": 60.0, "stragglers": 0.2, "store": 1e9}
        first, second = (cluster.simulate(**named, seed=3) for _ in range(2))
        self.assertEqual(first.seconds, second.seconds)
        self.assertEqual(first.bytes, second.bytes)
        self.assertGreater(first.lost, 0)

    def test_shares_of_time_add_up(self):
        for named in ({}, {"store": 2e8}, {"overlap": True}, {"failures": 40.0},
                      {"stragglers": 0.4}, {"latency": 0.5}):
            with self.subTest(**named):
                each = cluster.simulate(**{**self.setting, **named})
                whole = each.computing + each.loading + each.waiting + each.idle + each.wasted
                self.assertAlmostEqual(whole, 1, places=3)
                self.assertGreaterEqual(each.seconds, each.ideal_seconds)
                self.assertEqual(each.pairs, 60 * 59 // 2)

    def test_one_worker_takes_what_can_be_reckoned(self):
        each = cluster.simulate(items=32, room=8, workers=1, pair_seconds=2, item_bytes=100,
                                bandwidth=50, overhead=0)
        loads = changeover.load_order(32, 8).loads
        self.assertEqual((each.loads, each.bytes), (loads, 100 * loads))
        self.assertAlmostEqual(each.seconds, 2 * 496 + 2 * loads)
        self.assertAlmostEqual(each.ideal_seconds, 2 * 496)

    def test_the_store_is_shared(self):
        free = cluster.simulate(**self.setting, overhead=0)
        shared = cluster.simulate(**self.setting, overhead=0, store=1e8)
        self.assertGreaterEqual(shared.seconds, shared.bytes / 1e8)
        self.assertGreater(shared.seconds, free.seconds)
        self.assertAlmostEqual(free.waiting, 0)

    def test_very_many_workers(self):
        each = cluster.simulate(items=100_000, room=1000, workers=500, pair_seconds=1e-6,
                                item_bytes=10**6, store=1e11, failures=0.05, stragglers=0.05)
        self.assertFalse(each.exact)
        self.assertEqual(each.pairs, 100_000 * 99_999 // 2)
        self.assertGreater(each.loads, 0.9 * each.planned_loads)
        self.assertLess(each.idle, 0.9)

    def test_both_ways_to_count_agree(self):
        exact = cluster.simulate(
            items=600, room=60, workers=20, pair_seconds=0.01, item_bytes=10**6
        )
        most, _simulation._exact_pairs = _simulation._exact_pairs, 1000
        try:
            bulk = cluster.simulate(items=600, room=60, workers=20, pair_seconds=0.01,
                                    item_bytes=10**6)
        finally:
            _simulation._exact_pairs = most
        self.assertTrue(exact.exact and not bulk.exact)
        self.assertAlmostEqual(bulk.planned_loads / exact.planned_loads, 1, delta=0.15)
        self.assertAlmostEqual(bulk.seconds / exact.seconds, 1, delta=0.15)

    def test_wrong_ones_are_refused(self):
        for named in ({"pair_seconds": -1}, {"bandwidth": 0}, {"store": 0}, {"stragglers": 1.5},
                      {"workers": 0}, {"stretches": 0}, {"item_bytes": -1}, {"room": 1},
                      {"pair_seconds": float("nan")}):
            with self.subTest(**named), self.assertRaises(changeover.BadInput):
                cluster.simulate(**{**self.setting, **named})
        with self.assertRaisesRegex(changeover.BadInput, "does not end"):
            cluster.simulate(**{**self.setting, "items": 12, "room": 4}, failures=3600,
                             restart=None)


if __name__ == "__main__":
    unittest.main()
