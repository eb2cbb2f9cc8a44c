"""What may go wrong in a run on a cluster, without one: functions that raise anything, results
that cannot travel, journals that were cut and spliced, workers that hang, jobs that were left,
absurd numbers."""

import functools
import gc
import itertools
import json
import math
import os
import pickle
import sys
import tempfile
import threading
import unittest
import warnings

import changeover
from changeover import cluster
from changeover.cluster import (
    _bag, _failed, _job, _journal, _searches, _simulation, _worker)
from test_cluster import play, shares_of
from test_engines import Bags, RayStandIn


def only_stretch(items=12, room=4):
    (run,) = shares_of(items, room, 1)
    return run.take(1, 1e9)


def raises(fault):
    raise fault


class HasNoWords(Exception):
    def __str__(self):
        raise RuntimeError("no words")


class GoneAway:
    """Can be pickled; unpickling it raises."""

    def __reduce__(self):
        return raises, (OSError("no such class here"),)


class Functions(unittest.TestCase):
    def test_whatever_they_raise_names_the_item_or_the_pair(self):
        class Local(BaseException):
            pass

        stretch = only_stretch()
        for fault in (SystemExit(3), GeneratorExit(), Local(), HasNoWords(), MemoryError()):
            for named in ({}, {"threads": 3}, {"overlap": True}):
                with self.subTest(fault=type(fault), **named):
                    worker = _worker.Memory(
                        lambda x: raises(fault) if x == 7 else x, lambda *_: 1, 5, **named)
                    failure = worker.run(stretch).failure
                    self.assertEqual((failure.what, failure.items), ("load", (7,)))
                    worker.close()
                    worker = _worker.Memory(
                        lambda x: x, lambda i, j, *_: raises(fault) if (i, j) == (2, 9) else 1, 5,
                        **named)
                    failure = worker.run(stretch).failure
                    self.assertEqual((failure.what, failure.items), ("compute", (2, 9)))
                    self.assertIn(type(fault).__name__, str(_failed.failed(failure, "")))
                    worker.close()

    def test_ctrl_c_is_not_taken_for_theirs(self):
        worker = _worker.Memory(lambda x: x, lambda *_: raises(KeyboardInterrupt()), 4)
        with self.assertRaises(KeyboardInterrupt):  # As Ctrl-C in a main thread would.
            worker.run(only_stretch())
        failures = []
        thread = threading.Thread(
            target=lambda: failures.append(worker.run(only_stretch()).failure))
        thread.start()
        thread.join()
        self.assertEqual(failures[0].raised, "KeyboardInterrupt")

    def test_failures_travel_between_processes(self):
        for fault in (KeyError("x"), OSError(2, "gone"), HasNoWords(), SystemExit(3)):
            made = _failed.failed(_worker.Failure.of("load", (3,), fault), "a worker")
            again = pickle.loads(pickle.dumps(made))
            self.assertEqual((str(again), again.what, again.items, again.trace),
                             (str(made), made.what, made.items, made.trace))
            self.assertEqual([kind.__name__ for kind in type(again).__mro__],
                             [kind.__name__ for kind in type(made).__mro__])
        bare = pickle.loads(pickle.dumps(cluster.Failed("by hand")))
        self.assertEqual(str(bare), "by hand")

    def test_costs_and_sizes_that_cannot_be_are_refused(self):
        for wrong in (-1, math.nan, math.inf, 1e61, "much", None, 10**400):
            with self.subTest(wrong=str(wrong)[:20]), self.assertRaisesRegex(
                    changeover.BadInput, "cost has numbers from 0 to 1e\\+60"):
                shares_of(5, 3, 1, cost=lambda i, j: wrong)
        with self.assertRaisesRegex(cluster.Failed, r"sizes\(4\) raised KeyError: 4"):
            _job.sizes_of({}.__getitem__, 5)(4)
        with self.assertRaisesRegex(changeover.BadInput, "sizes has whole numbers"):
            _job.sizes_of(lambda x: 0.5, 5)(4)

    def test_pairs_that_cost_nothing_are_computed_like_others(self):
        for cost in (lambda i, j: 0, lambda i, j: (i + j) % 3, lambda i, j: 1e60 * (i == 0)):
            for failures in (0.0, 0.02):
                got = set()
                play(14, 5, 3, None, 1, lambda i, j, _: got.add((i, j)), cost=cost,
                     pair_seconds=1e-60, failures=failures)
                self.assertEqual(got, set(itertools.combinations(range(14), 2)))


class Results(unittest.TestCase):
    def test_what_is_sent_is_what_was_returned(self):
        for result in (None, True, 3, 2.5, 1j, "x", b"y", (1, "two", (3.0,)), [1, [2]], {"a": 1},
                       {1, 2}, (1, [2]), ((((1,),),),), tuple(range(100)), bytearray(b"z"),
                       OSError("kept")):
            sent = _worker.packed_result(result)
            self.assertEqual(repr(_worker.unpacked_result(pickle.loads(pickle.dumps(sent)))),
                             repr(result))
        mutable = [1]
        sent = _worker.packed_result(mutable)
        mutable.append(2)
        self.assertEqual(_worker.unpacked_result(sent), [1])

    def test_arrays_of_numbers_are_sent_as_they_are(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("NumPy is not installed")
        array = numpy.arange(5.0)
        self.assertIs(_worker.packed_result(array), array)
        number = numpy.float32(2)
        self.assertIs(_worker.packed_result(number), number)
        with self.assertRaises(Exception):
            _worker.packed_result(numpy.array([threading.Lock()], dtype=object))

    def test_any_that_cannot_be_sent_names_its_pair(self):
        """Not only the first one of a worker."""
        stretch = only_stretch()
        for wrong in (threading.Lock(), [threading.Lock()], (1, (2, threading.Lock()))):
            for threads in (1, 3):
                worker = _worker.Memory(lambda x: x,
                                        lambda i, j, *_: wrong if (i, j) == (2, 9) else [i], 4,
                                        threads=threads)
                failure = worker.run(stretch).failure
                self.assertEqual((failure.what, failure.items), ("compute", (2, 9)))
                worker.close()

    def test_any_that_cannot_be_read_names_its_pair(self):
        stretch = only_stretch()
        work = _job.Work(_job.Wanted(12, 4, None, None, None, False, None), lambda *_: None, 0,
                         "", "")
        outcome = _worker.Memory(
            lambda x: x, lambda i, j, *_: GoneAway() if (i, j) == (2, 9) else i, 4).run(stretch)
        self.assertIsNone(outcome.failure)
        with self.assertRaisesRegex(OSError, r"^unpickling the result of compute\(2, 9\) raised "
                                             r"OSError: no such class here \(on worker 5\)$"):
            work.deliver(stretch, "worker 5", outcome)

    def test_sizes_that_items_claim(self):
        class Item:
            def __init__(self, nbytes):
                self.size = nbytes

            @property
            def nbytes(self):
                return self.size() if callable(self.size) else self.size

        self.assertEqual(_worker.size_of(b"abc"), 3)
        self.assertEqual(_worker.size_of(Item(7)), 7)
        for wrong in (-5, 0.5, math.nan, "many", None, lambda: 1 / 0):
            self.assertIsNone(_worker.size_of(Item(wrong)))
        self.assertIsNone(_worker.size_of(3))


class Memory(unittest.TestCase):
    class Item:
        alive = most = 0
        guard = threading.Lock()

        def __init__(self):
            kind = type(self)
            with kind.guard:
                kind.alive += 1
                kind.most = max(kind.most, kind.alive)

        def __del__(self):
            with type(self).guard:
                type(self).alive -= 1

    def test_failures_keep_no_items(self):
        """Nor do exceptions that wait for the collection of garbage."""
        room = 4
        gc.disable()
        try:
            for named in ({}, {"threads": 3}, {"overlap": True}):
                kind = type("Item", (self.Item,), {"alive": 0, "most": 0})
                worker = _worker.Memory(
                    lambda x: kind(),
                    lambda i, j, first, second: raises(ValueError("no")) if (i + j) % 3 == 0 else 1,
                    room, **named)
                (run,) = shares_of(12, room - (1 if named.get("overlap") else 0), 1)
                failures = 0
                while run:
                    failures += worker.run(run.take(1, 5)).failure is not None
                self.assertGreater(failures, 5)
                self.assertLessEqual(kind.most, room, named)
                worker.close()
                del worker
                self.assertEqual(kind.alive, 0)
        finally:
            gc.enable()

    def test_after_its_end_it_does_nothing(self):
        loads = []
        worker = _worker.Memory(loads.append, lambda *_: None, 4, threads=2)
        worker.close()
        outcome = worker.run(only_stretch())
        self.assertTrue(outcome.stopped)
        self.assertEqual((outcome.results, loads), ([], []))


class Jobs(unittest.TestCase):
    """Of processes that stay: perform() and forget_job()."""

    class Maker:
        made = []

        def __init__(self, **settings):
            self.closed = False
            Jobs.Maker.made.append(self)

        def run(self, part):
            return _worker.Outcome(part.number, [self.closed])

        def is_busy(self):
            return True

        def close(self):
            self.closed = True

    def setUp(self):
        self.Maker.made.clear()

    def tearDown(self):
        _worker._performers.clear()

    def perform(self, job, maker=True, clients=("one", "two"), worker="w"):
        return _worker.perform(
            job, worker, pickle.dumps(functools.partial(Jobs.Maker)) if maker else None, {},
            clients, _bag.Call(5, {}))

    def test_a_process_without_the_functions_says_so(self):
        self.assertTrue(self.perform(("one", "job"), maker=False).stopped)
        self.assertFalse(self.perform(("one", "job")).stopped)
        self.assertFalse(self.perform(("one", "job"), maker=False).stopped)
        self.assertEqual(len(self.Maker.made), 1)
        self.assertTrue(self.perform(("one", "job"), maker=False, worker="another").stopped)

    def test_jobs_of_clients_that_are_gone_end(self):
        for job in ("one", "two", "killed"):
            self.perform((job, "job"), clients=("one", "two", "killed"))
        one, two, killed = self.Maker.made
        self.perform(("one", "another job"))
        self.assertEqual((one.closed, two.closed, killed.closed), (False, False, True))
        _worker.forget_job(("one", "job"))
        self.assertEqual((one.closed, two.closed), (True, False))
        self.assertTrue(self.perform(("one", "job")).stopped)


class Journals(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = os.path.join(self.folder.name, "journal")
        self.job = _journal.name_of_job(9, None, "all", "")
        self.pairs = list(itertools.combinations(range(9), 2))

    def tearDown(self):
        self.folder.cleanup()

    def written(self, pairs, job=None):
        journal = _journal.Journal(self.path, job or self.job)
        for pair in pairs:
            journal.record(*pair)
        journal.close()
        return self.bytes()

    def bytes(self):
        with open(self.path, "rb") as file:
            return file.read()

    def read(self, text, *warned):
        with open(self.path, "wb") as file:
            file.write(text)
        with warnings.catch_warnings(record=True) as said:
            warnings.simplefilter("always")
            journal = _journal.Journal(self.path, self.job)
        done = list(journal.done())
        journal.close()
        self.assertEqual(len(said), len(warned))
        for each, words in zip(said, warned):
            self.assertIn(words, str(each.message))
        return done

    def test_lines_count_only_where_they_were_written(self):
        whole = self.written(self.pairs[:12])
        lines = whole.splitlines(keepends=True)
        for cut in range(1, 11):  # A line is missing, or stands elsewhere.
            self.assertEqual(self.read(b"".join(lines[:cut] + lines[cut + 1:]), "damaged at byte"),
                             self.pairs[:cut - 1])
            swapped = [*lines[:cut], lines[cut + 1], lines[cut], *lines[cut + 2:]]
            self.assertEqual(self.read(b"".join(swapped), "damaged"), self.pairs[:cut - 1])
        self.assertEqual(self.read(whole + lines[1], "damaged"), self.pairs[:12])
        self.assertEqual(self.read(whole + b"x" * 10**6, "damaged"), self.pairs[:12])
        os.remove(self.path)
        other = self.written([(7, 8)], _journal.name_of_job(9, None, "all", "other"))
        self.assertEqual(self.read(lines[0] + other.splitlines(keepends=True)[1], "damaged"), [])

    def test_what_was_cut_off_goes_on(self):
        whole = self.written(self.pairs[:3])
        for end in range(len(whole) + 1):
            done = self.read(whole[:end])
            self.assertEqual(done, self.pairs[:max(0, whole[:end].count(b"\n") - 1)])
            journal = _journal.Journal(self.path, self.job)
            journal.record(7, 8)
            journal.close()
            self.assertEqual(self.read(self.bytes()), done + [(7, 8)])

    def test_what_is_no_journal_stays_as_it_is(self):
        for text in (b"{}", b"\x00\x01bin", b"   ", b"[" * 100_000, b"no end of line",
                     b'{"format": "changeover-cluster-journal/0"}\n', b"\n\n", b"1 2 00000000\n",
                     json.dumps(self.job).encode(), b"x" * 200_000 + b"\n"):
            with open(self.path, "wb") as file:
                file.write(text)
            with self.assertRaisesRegex(changeover.BadInput, "not a journal of a run on a cluster"):
                _journal.Journal(self.path, self.job)
            self.assertEqual(self.bytes(), text)

    def test_what_is_no_file_is_refused(self):
        pipe = os.path.join(self.folder.name, "pipe")
        os.mkfifo(pipe)
        for path, kind, says in (
                (pipe, changeover.BadInput, "a journal is a file, and this is none"),
                ("/dev/null", changeover.BadInput, "a journal is a file, and this is none"),
                ("a\0b", changeover.BadInput,
                 "journal: .* is not a file name; remove the zero byte"),
                (self.folder.name, changeover.MissingResource, "cannot open the journal")):
            with self.subTest(path=path), self.assertRaisesRegex(kind, says):
                _journal.Journal(path, self.job)

    def test_a_full_disk_ends_the_run_and_loses_one_pair_at_most(self):
        write, sync = os.write, os.fsync
        for room in range(0, 60):
            left = [len(self.written([])) + room]
            os.remove(self.path)

            def scarce(file, text):
                text = text[:left[0]]
                if not text:
                    raise OSError(28, "No space left on device")
                left[0] -= len(text)
                return write(file, text)

            journal, done = None, 0
            os.write = scarce
            try:
                with self.assertRaisesRegex(changeover.MissingResource, "No space left"):
                    journal = _journal.Journal(self.path, self.job)
                    for pair in self.pairs:
                        journal.record(*pair)
                        done += 1
            finally:
                os.write = write
            journal.close()
            self.assertEqual(self.read(self.bytes()), self.pairs[:done])
            os.remove(self.path)
        journal = _journal.Journal(self.path, self.job)
        journal.record(0, 1)
        os.fsync = lambda _: raises(OSError(5, "Input/output error"))
        try:
            with self.assertRaisesRegex(changeover.MissingResource, "Input/output error"):
                journal.close()
        finally:
            os.fsync = sync

    def test_the_warning_is_at_the_call(self):
        job = {"items": 6, "room": 3, "load": abs, "compute": _first, "journal": self.path}
        before = sys.modules.get("ray")
        sys.modules["ray"] = ray = RayStandIn()
        try:
            self.assertEqual(cluster.all_pairs(ray, **job).pairs, 15)
            with open(self.path, "r+b") as file:
                file.seek(-3, os.SEEK_END)
                file.write(b"?")
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                report = cluster.all_pairs(ray, **job)
        finally:
            sys.modules.pop("ray")
            if before is not None:
                sys.modules["ray"] = before
        self.assertEqual((report.resumed, report.pairs), (14, 1))
        self.assertEqual({pickle.loads(pickle.dumps(report))}, {report})
        self.assertEqual([each.filename for each in said], [__file__])


def _first(i, j, first, second):
    return first


class Workers(unittest.TestCase):
    def test_one_that_hangs_is_done_without(self):
        """What it has in hand, and what waits for it."""
        class Hangs(_simulation._Simulated):
            def submit(self, worker, part):
                super().submit(worker, part)
                if worker == "1":
                    self._tasks.pop(part.number)

            def wait(self, seconds):
                if not self._tasks and not self._events:  # Time goes on where nothing happens.
                    self._now += seconds
                    return []
                return super().wait(seconds)

        original = _simulation._Simulated
        _simulation._Simulated = Hangs
        try:
            for seed in range(1, 6):
                got = set()
                team = play(14, 5, 3, None, seed, lambda i, j, _: got.add((i, j)), stragglers=0.0)
                self.assertEqual(got, set(itertools.combinations(range(14), 2)))
                self.assertEqual((team.lost, team.members["1"].pairs), (0, 0))
                self.assertGreater(team.copied, 0)
        finally:
            _simulation._Simulated = original

    def test_parts_of_searches_that_were_stopped_are_done_again(self):
        """A result without them would not be complete."""
        class Stops(Bags.Engine):
            def outcome(self, number):
                outcome = super().outcome(number)
                return _worker.Outcome(number, stopped=True) if number in (2, 5) else outcome

        got = []
        bag = _bag.Bag(lambda arguments, result: got.append(result))
        for each in range(6):
            bag.put({"each": each})
        bag.run(Stops(lambda each, over, threads: each, ["a", "b"]), lambda _: None)
        self.assertEqual(sorted(got), list(range(6)))
        self.assertEqual((bag.retried, bag.parts), (2, 8))


class Searches(unittest.TestCase):
    def setUp(self):
        self.before = sys.modules.get("ray")
        sys.modules["ray"] = self.ray = RayStandIn()

    def tearDown(self):
        sys.modules.pop("ray")
        if self.before is not None:
            sys.modules["ray"] = self.before

    def test_wrong_ones_are_refused(self):
        for named in ({"v": range(10**12)}, {"v": "9"}, {"v": [9.5]}, {"k": 4.0}, {"v": None},
                      {"time": 0}, {"time": math.nan}, {"each": -1}, {"threads": 0},
                      {"workers": 0}, {"workers": 10**9}, {"threads": 10**6}):
            with self.subTest(**named), self.assertRaises((changeover.BadInput, TypeError)):
                cluster.improve(self.ray, **{"v": 9, "k": 4, "time": 1, **named})
        for named in ({"threads": 0}, {"workers": 0}):
            with self.subTest(**named), self.assertRaises(changeover.BadInput):
                cluster.all_pairs(self.ray, items=5, room=3, load=abs, compute=_first, **named)

    def test_a_find_that_the_catalog_refuses_is_not_lost(self):
        before = _searches.design
        _searches.design = lambda v, k, change, kind, strength: changeover.design(
            v, k, change, kind, strength, construction="hold-and-stream")
        try:
            with warnings.catch_warnings(record=True) as said:
                warnings.simplefilter("always")
                finds = cluster.improve(self.ray, 14, 4, change=1, kind="linear", time=20, each=0.5,
                                        who="a name\nof two lines")
        finally:
            _searches.design = before
        (find,) = finds
        self.assertTrue(find.design.verdict.valid)
        self.assertLess(find.b, find.before)
        self.assertIsNone(find.label)
        self.assertEqual({pickle.loads(pickle.dumps(find))}, {find})
        self.assertEqual([each.filename for each in said], [__file__])
        self.assertIn("and not in the catalog: ", str(said[0].message))


class Simulations(unittest.TestCase):
    setting = {"items": 30, "room": 8, "workers": 3, "pair_seconds": 0.1, "item_bytes": 10**6}

    def test_absurd_numbers_end(self):
        for wrong in ({"pair_seconds": 1e300}, {"pair_seconds": math.inf}, {"latency": 1e200},
                      {"bandwidth": 1e-300}, {"bandwidth": 5e-324}, {"slowness": 1e-200},
                      {"store": math.nan}, {"restart": math.inf}, {"failures": 1e100},
                      {"overlap": True, "room": 2}):
            with self.subTest(**wrong), self.assertRaises(changeover.BadInput):
                cluster.simulate(**{**self.setting, **wrong})
        for huge in ({"pair_seconds": 1e59}, {"latency": 1e59}, {"bandwidth": 1e-59},
                     {"slowness": 1e59, "stragglers": 1.0}, {"store": math.inf},
                     {"item_bytes": 10**40}, {"pair_seconds": 0.0}, {"bandwidth": 1e60}):
            with self.subTest(**huge):
                said = cluster.simulate(**{**self.setting, **huge})
                self.assertEqual(said.pairs, 435)
                self.assertTrue(math.isfinite(said.seconds))

    def test_workers_that_fail_all_the_time(self):
        before, _simulation._least_failures = _simulation._least_failures, 30
        try:
            for named in ({"failures": 1e9}, {"failures": 1e9, "restart": 0.0},
                          {"failures": 3600.0, "pair_seconds": 1e6},
                          {"failures": 3600.0, "item_bytes": 10**15}):
                with self.subTest(**named), self.assertRaisesRegex(
                        changeover.BadInput, "the simulated run does not end: workers fail"):
                    cluster.simulate(**{**self.setting, **named})
        finally:
            _simulation._least_failures = before


if __name__ == "__main__":
    unittest.main()
