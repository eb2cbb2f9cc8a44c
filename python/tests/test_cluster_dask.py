"""Runs on a real Dask cluster: a scheduler and workers, processes of their own, on this machine."""

import collections
import itertools
import logging
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest

try:
    import numpy
    from distributed import Client, LocalCluster
except ImportError as fault:
    print(f"skipped: {fault}")
    sys.exit(77)

import changeover
from changeover import cluster

here = os.path.dirname(os.path.abspath(__file__))


def start(workers, threads=1):
    return LocalCluster(n_workers=workers, threads_per_worker=threads, dashboard_address=None,
                        silence_logs=logging.CRITICAL)


def load(x):
    return numpy.full(1000, x, numpy.int64)


def compute(i, j, first, second):
    return int(first[0] * 1000 + second[-1])


def slow_compute(i, j, first, second):
    time.sleep(0.003)
    return compute(i, j, first, second)


def odd():
    raise RuntimeError("odd")


class Unreadable:
    def __reduce__(self):
        return odd, ()


class Sink:
    def __init__(self, test):
        self.test, self.got = test, {}

    def __call__(self, i, j, result):
        self.test.assertNotIn((i, j), self.got)
        self.test.assertEqual(result, 1000 * i + j)
        self.got[i, j] = result

    def check(self, pairs):
        self.test.assertEqual(set(self.got), set(pairs))


class Dask(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cluster = start(2)
        cls.client = Client(cls.cluster)
        cls.every = set(itertools.combinations(range(32), 2))
        cls.job = {"items": 32, "room": 8, "load": load, "compute": compute}

    @classmethod
    def tearDownClass(cls):
        cls.client.close()
        cls.cluster.close()

    def setUp(self):
        while len(self.client.nthreads()) != 2:  # A test before may have started or killed some.
            time.sleep(0.05)
        self.sink = Sink(self)

    def run_job(self, **named):
        return cluster.all_pairs(self.client, **{**self.job, "sink": self.sink, **named})

    def test_every_pair_comes_once_and_loads_are_near_the_plan(self):
        told = []
        report = self.run_job(compute=slow_compute, sizes=8000, progress=told.append)
        self.sink.check(self.every)
        self.assertEqual((report.pairs, report.resumed, report.lost), (496, 0, 0))
        self.assertLessEqual(report.loads, 1.15 * report.planned_loads)
        self.assertLessEqual(report.most_held, 8)
        self.assertEqual(report.bytes, 8000 * report.loads)
        self.assertEqual(report.planned_bytes, 8000 * report.planned_loads)
        self.assertEqual(sum(each["pairs"] for each in report.workers), 496)
        self.assertEqual(sum(each["loads"] for each in report.workers), report.loads)
        self.assertEqual(told[-1]["steps"], 496)
        self.assertRegex(repr(report), r"^<cluster.Report: 496 pairs by 2 workers, \d+ loads")
        # Nothing of the job stays at the workers.
        left = self.client.run(lambda: len(
            __import__("changeover.cluster._worker", fromlist=["x"])._performers))
        self.assertEqual(set(left.values()), {0})

    def test_a_worker_holds_so_many_bytes(self):
        sizes = [800 * (1 + x % 5) for x in range(32)]
        report = self.run_job(
            load=lambda x: numpy.full(100 * (1 + x % 5), x, numpy.int64), room=None, sizes=sizes,
            memory=20_000, compute=lambda i, j, a, b: int(a[0]) * 1000 + int(b[-1]))
        self.sink.check(self.every)
        self.assertLessEqual(report.most_bytes, 20_000)
        self.assertGreater(report.most_bytes, 10_000)
        self.assertLessEqual(report.bytes, 1.2 * report.planned_bytes)

    def test_lists_closures_costs_and_items_alone(self):
        pairs = [(i, (i + 1) % 30) for i in range(30)] + [(4, 4)]
        offset = 1000
        report = self.run_job(items=None, pairs=pairs, cost=[1 + i % 3 for i in range(31)],
                              compute=lambda i, j, a, b: int(a[0]) * offset + int(b[0]), room=3)
        self.sink.check({(min(pair), max(pair)) for pair in pairs})
        self.assertEqual(report.pairs, 31)

    def test_items_of_any_kind_of_store(self):
        try:
            import h5py
        except ImportError:
            self.skipTest("h5py is not installed")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "items.h5")
            with h5py.File(path, "w") as file:
                file["items"] = numpy.arange(12)[:, None] * numpy.ones((1, 1000), int)

            def read(x):
                import h5py
                with h5py.File(path, "r") as file:
                    return file["items"][x]

            report = self.run_job(items=12, room=4, load=read, overlap=True)
        self.sink.check(itertools.combinations(range(12), 2))
        self.assertLessEqual(report.most_held, 4)
        self.assertEqual(report.bytes, 8000 * report.loads)

    def test_what_raises_ends_the_run_and_is_named(self):
        def bad_load(x):
            if x == 17:
                raise OSError("disk on fire")
            return load(x)

        def bad_compute(i, j, first, second):
            if (i, j) == (3, 21):
                raise ZeroDivisionError("by nothing")
            return compute(i, j, first, second)

        def leave(i, j, first, second):
            if (i, j) == (3, 21):
                sys.exit(4)
            return compute(i, j, first, second)

        def unreadable(i, j, first, second):
            return Unreadable() if (i, j) == (3, 21) else compute(i, j, first, second)

        def bad_sink(i, j, result):
            if i == 5:
                raise LookupError("no place for it")

        class Own(Exception):
            pass

        def enough(said):
            raise Own

        for named, kind, says in (
            ({"load": bad_load}, OSError, r"load\(17\) raised OSError: disk on fire \(on tcp:"),
            ({"compute": bad_compute}, ZeroDivisionError, r"compute\(3, 21\) raised ZeroDiv"),
            ({"compute": leave}, cluster.Failed, r"compute\(3, 21\) raised SystemExit: 4"),
            ({"compute": unreadable}, RuntimeError,
             r"unpickling the result of compute\(3, 21\) raised RuntimeError: odd \(on tcp:"),
            ({"sink": bad_sink}, LookupError, r"sink\(5, \d+\) raised LookupError: no place"),
            ({"progress": enough}, Own, ""),
        ):
            self.sink.got.clear()
            with self.subTest(named), self.assertRaisesRegex(kind, says):
                self.run_job(**named)
        with self.assertRaisesRegex(TypeError, "load and compute cannot be sent to workers"):
            self.run_job(load=lambda x, lock=threading.Lock(): x)
        self.sink.got.clear()
        self.run_job()  # The workers are as good as before.
        self.sink.check(self.every)

    def test_what_fails_now_and_then_is_tried_again(self):
        def first_to_make(path):  # Of two workers at the same moment, one.
            try:
                with open(path, "x"):
                    return True
            except FileExistsError:
                return False

        with tempfile.TemporaryDirectory() as folder:
            def flaky(x):
                if x % 5 == 0 and first_to_make(os.path.join(folder, str(x))):
                    raise ConnectionError("try again")
                return load(x)

            report = self.run_job(load=flaky, retries=1)
        self.sink.check(self.every)
        self.assertGreaterEqual(report.retried, 7)

    def test_a_worker_is_killed(self):
        began = threading.Event()

        def kill():
            began.wait(20)
            pid = next(iter(self.cluster.workers.values())).process.pid
            os.kill(pid, signal.SIGKILL)

        thread = threading.Thread(target=kill)
        thread.start()

        def sink(i, j, result):
            began.set()
            self.sink(i, j, result)

        report = self.run_job(compute=slow_compute, sink=sink)
        thread.join()
        self.sink.check(self.every)
        self.assertEqual(report.lost, 1)
        self.assertGreaterEqual(report.retried, 1)

    def test_a_straggler_does_not_hold_up_the_others(self):
        straggler = next(iter(self.client.nthreads()))

        def uneven(i, j, first, second):
            from distributed import get_worker
            time.sleep(0.03 if get_worker().address == straggler else 0.002)
            return compute(i, j, first, second)

        report = self.run_job(compute=uneven)
        self.sink.check(self.every)
        pairs = {each["worker"]: each["pairs"] for each in report.workers}
        self.assertLess(pairs[straggler], 150)
        self.assertGreater(report.stolen, 0)

    def test_a_worker_that_comes_late_gets_its_part(self):
        """The others wait for it after some pairs, however long its process takes to start."""
        with tempfile.TemporaryDirectory() as folder:
            there = os.path.join(folder, "there")

            def compute_some_then_wait(i, j, first, second):
                from distributed import get_worker
                worker = get_worker()
                worker.pairs_so_far = getattr(worker, "pairs_so_far", 0) + 1
                while worker.pairs_so_far > 20 and not os.path.exists(there):
                    time.sleep(0.01)
                time.sleep(0.012)
                return compute(i, j, first, second)

            def bring_a_worker():
                self.cluster.scale(3)
                self.client.wait_for_workers(3, timeout=120)
                open(there, "w").close()

            thread = threading.Thread(target=bring_a_worker)
            thread.start()
            report = self.run_job(compute=compute_some_then_wait)
            thread.join()
        self.cluster.scale(2)
        self.sink.check(self.every)
        self.assertEqual(len(report.workers), 3)
        self.assertGreater(min(each["pairs"] for each in report.workers), 0)

    def test_a_client_that_was_killed_goes_on_with_other_workers(self):
        with tempfile.TemporaryDirectory() as folder:
            journal, results = (os.path.join(folder, name) for name in ("journal", "results"))
            program = (
                "import sys; sys.path.insert(0, sys.argv[1])\n"
                "import os, test_cluster_dask as t\n"
                "from changeover import cluster\n"
                "if __name__ == '__main__':\n"
                "    out = os.open(sys.argv[3], os.O_WRONLY | os.O_CREAT | os.O_APPEND)\n"
                "    client = t.Client(sys.argv[4])\n"
                "    cluster.all_pairs(client, items=32, room=8, load=t.load, compute=t.slow_compute,\n"
                "        sink=lambda i, j, r: os.write(out, b'%d %d %d\\n' % (i, j, r)),\n"
                "        journal=sys.argv[2])\n")
            process = subprocess.Popen(
                [sys.executable, "-c", program, here, journal, results,
                 self.cluster.scheduler_address])
            while not os.path.exists(results) or os.path.getsize(results) < 800:
                self.assertIsNone(process.poll())
                time.sleep(0.01)
            process.kill()
            process.wait()
            with open(results) as file:
                lines = [tuple(map(int, line.split())) for line in file]
            for line in dict.fromkeys(lines):  # The pair at which it was killed may come again.
                self.sink(*line)
            self.assertLess(len(self.sink.got), 496)
            with start(3) as others, Client(others) as client:
                report = cluster.all_pairs(
                    client, **self.job, journal=journal,
                    sink=lambda i, j, r: self.sink(i, j, r) if (i, j) != lines[-1][:2] else None)
                self.sink.check(self.every)
                self.assertIn(report.resumed, (len(lines) - 1, len(lines)))
                self.assertEqual(report.resumed + report.pairs, 496)
                again = cluster.all_pairs(client, **self.job, journal=journal, sink=self.sink)
                self.assertEqual((again.pairs, again.resumed, again.loads), (0, 496, 0))
                with self.assertRaisesRegex(changeover.BadInput, "journal is of another job"):
                    cluster.all_pairs(client, **{**self.job, "items": 33}, journal=journal)

    def test_a_worker_that_hangs_does_not_hold_up_the_others(self):
        hanging = next(iter(self.client.nthreads()))
        for when in ("at once", "later"):
            with tempfile.TemporaryDirectory() as folder, self.subTest(when=when):
                hold = os.path.join(folder, "hold")
                open(hold, "w").close()

                def hang(i, j, first, second, when=when):
                    from distributed import get_worker
                    if get_worker().address == hanging and (when == "at once" or i > 20):
                        while os.path.exists(hold):
                            time.sleep(0.01)
                    return compute(i, j, first, second)

                self.sink.got.clear()
                report = self.run_job(compute=hang)
                self.sink.check(self.every)
                self.assertEqual(report.lost, 0)
                self.assertGreater(report.copied, 0)
        self.sink.got.clear()
        self.run_job()
        self.sink.check(self.every)

    def test_several_clients_at_once(self):
        sinks = [Sink(self) for _ in range(3)]
        faults = []

        def run(sink):
            try:
                with Client(self.cluster.scheduler_address) as client:
                    for _ in range(3):
                        sink.got.clear()
                        cluster.all_pairs(client, **self.job, sink=sink, threads=2)
                        sink.check(self.every)
            except BaseException as fault:
                faults.append(fault)

        threads = [threading.Thread(target=run, args=(each,)) for each in sinks]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(faults, [])

    def test_a_closed_client_is_refused(self):
        client = Client(self.cluster.scheduler_address)
        client.close()
        with self.assertRaisesRegex(changeover.BadInput, "client is closed; give one that"):
            cluster.all_pairs(client, **self.job)

        client = Client(self.cluster.scheduler_address)
        with self.assertRaisesRegex(changeover.MissingResource, "or the client was closed"):
            cluster.all_pairs(client, **{**self.job, "compute": slow_compute},
                              sink=lambda *_: client.close())

    def test_ctrl_c_ends_it(self):
        some = threading.Event()

        def ctrl_c():
            some.wait()
            os.kill(os.getpid(), signal.SIGINT)

        def sink(i, j, result):
            self.sink(i, j, result)
            if len(self.sink.got) == 20:
                some.set()

        thread = threading.Thread(target=ctrl_c)
        with tempfile.TemporaryDirectory() as folder:
            journal = os.path.join(folder, "journal")
            thread.start()
            with self.assertRaises(KeyboardInterrupt):
                self.run_job(compute=lambda i, j, a, b: time.sleep(0.05) or compute(i, j, a, b),
                             journal=journal, sink=sink)
            thread.join()
            report = self.run_job(journal=journal)
        self.sink.check(self.every)
        self.assertGreater(report.resumed, 0)

    def test_searches_in_shares(self):
        alone = changeover.classify(9, 4, 6, 2, "circular")
        shared = cluster.classify(self.client, 9, 4, 6, 2, "circular")
        self.assertTrue(shared.complete)
        for fact in ("standard_forms", "classes", "tight", "group_orders"):
            self.assertEqual(getattr(shared, fact), getattr(alone, fact))
        self.assertEqual({each.to_string() for each in shared.designs},
                         {each.to_string() for each in alone.designs})
        result = cluster.search(self.client, 9, 5, 2, exact=True, cubes=16)
        self.assertTrue(result.minimum)
        self.assertEqual(result.b, changeover.bounds(9, 5, 2).lower_bound)
        self.assertIn("checked proofs", result.reason)
        start_design = changeover.design(14, 4, 1, "linear", construction="hold-and-stream")
        result = cluster.search(self.client, 14, 4, 1, start=start_design, time=20, each=1)
        self.assertEqual(result.b, changeover.bounds(14, 4, 1, "linear").best_known)
        self.assertEqual(cluster.improve(self.client, 9, 4, change=1, time=2, each=1), [])


if __name__ == "__main__":
    unittest.main()
