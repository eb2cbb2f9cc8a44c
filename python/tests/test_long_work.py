"""Long work: limits, progress, Ctrl-C, threads; searches, plans, load orders, the executor."""

import contextlib
import itertools
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from decimal import Decimal

import changeover


def ctrl_c_once_there_is_a_best():
    """A progress function that presses Ctrl-C once, when it first hears of a best so far."""
    pressed = []

    def progress(said):
        if not pressed and said["best"] is not None:
            pressed.append(True)
            threading.Thread(target=os.kill, args=(os.getpid(), signal.SIGINT)).start()

    return progress


@contextlib.contextmanager
def ctrl_c_after(seconds):
    timer = threading.Timer(seconds, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    try:
        yield
    finally:
        timer.cancel()
        timer.join()


def run(program, *arguments):
    return subprocess.run([sys.executable, "-c", program, *arguments], capture_output=True,
                          text=True, timeout=60)


class Searches(unittest.TestCase):
    def test_an_exact_search_proves_the_minimum(self):
        result = changeover.search(8, 4, 1, exact=True)
        self.assertTrue(result.minimum)
        self.assertEqual(result.b, 9)
        self.assertTrue(result.design.verdict.valid)

    def test_what_is_wanted_is_found_or_excluded(self):
        result = changeover.search(6, 3, 1, exact=True, first=[0, 1], last=(1, 0), time=None)
        self.assertEqual((result.b, result.lower_bound, result.minimum), (8, 8, True))
        for block in (result.design.blocks[0], result.design.blocks[-1]):
            self.assertLessEqual({0, 1}, set(block))
        given = [[4, 1, 2], [1, 2, 0]]
        result = changeover.search(6, 3, 1, exact=True, contains=given, time=None)
        blocks = [set(block) for block in result.design.blocks]
        at = blocks.index({4, 1, 2})
        self.assertEqual(blocks[at + 1], {1, 2, 0})
        known = changeover.search(12, 4, 1, first=[0, 1, 2], expansion_set=True, target=21)
        self.assertEqual((known.b, known.moves), (21, 0))
        anew = changeover.search(
            12, 4, 1, first=[0, 1, 2], expansion_set=True, target=21, anew=True, time=60)
        self.assertEqual(anew.b, 21)
        self.assertGreater(anew.moves, 0)

    def test_a_search_ends_at_the_bound(self):
        result = changeover.search(9, 4, 1, time=30)
        self.assertTrue(result.minimum)
        self.assertEqual(result.design.b, result.lower_bound)

    def test_a_seed_says_the_result(self):
        first, second = (changeover.search(12, 4, 1, seed=5, time=None) for _ in range(2))
        self.assertEqual(first.design.blocks, second.design.blocks)
        self.assertEqual(first.moves, second.moves)

    def test_ctrl_c_keeps_the_best(self):
        result = changeover.search(40, 5, time=600, progress=ctrl_c_once_there_is_a_best())
        self.assertTrue(result.interrupted)
        self.assertEqual(result.why_stopped, "interrupted")
        self.assertTrue(result.design.verdict.valid)

    def test_ctrl_c_ends_what_has_no_best(self):
        with self.assertRaises(KeyboardInterrupt), ctrl_c_after(0.3):
            changeover.table((3, 40), (5, 900))

    def test_a_callback_that_raises_ends_the_search(self):
        told = []

        def progress(said):
            told.append(said)
            raise LookupError("enough")

        with self.assertRaisesRegex(LookupError, "enough"):
            changeover.search(40, 5, time=600, progress=progress)
        self.assertEqual(len(told), 1)
        self.assertIn("phase", told[0])

    def test_work_that_says_little_goes_on_in_time(self):
        told = []
        sheet = changeover.plan(30, 4, test_cost=1, change_cost=1, time=4, progress=told.append)
        self.assertEqual(sheet.why_stopped, "time limit")
        times = [said["elapsed"] for said in told]
        self.assertEqual(times, sorted(times))
        self.assertGreater(times[-1], 2)
        for said in told:
            self.assertAlmostEqual(said["elapsed"] + said["left"], 4, places=1)

    def test_other_threads_run_meanwhile(self):
        began = threading.Event()

        def tick_and_stop():
            began.wait()
            for _ in range(6):
                time.sleep(0.01)
            os.kill(os.getpid(), signal.SIGINT)

        thread = threading.Thread(target=tick_and_stop)
        thread.start()
        result = changeover.search(40, 5, time=600, progress=lambda said: began.set())
        thread.join()
        self.assertTrue(result.interrupted)  # by that thread, or the time would have been up

    def test_several_searches_at_once(self):
        results = [None] * 4

        def work(index):
            results[index] = changeover.search(11 + index, 4, 1, time=0.5)

        threads = [threading.Thread(target=work, args=(index,)) for index in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(all(result.design.verdict.valid for result in results))

    def test_wrong_limits_are_refused(self):
        for wrong in ({"time": -1}, {"time": float("nan")}, {"threads": 0}, {"threads": 10**9}):
            with self.assertRaises(ValueError):
                changeover.search(9, 4, **wrong)
        with self.assertRaises(TypeError):
            changeover.search(9, 4, progress="loud")

    def test_classification(self):
        all_ = changeover.classify(9, 4, 6, 2, "circular")
        self.assertTrue(all_.complete)
        self.assertEqual(sum(all_.group_orders.values()), all_.classes)
        for design in all_.designs:
            self.assertTrue(design.verdict.valid)


class Ends(unittest.TestCase):
    """Python ends while another thread works: that thread says nothing, and nothing breaks."""

    works = {
        "a search": "changeover.search(40, 5, time=600, progress=lambda said: None)",
        "plans": "changeover.plan(100, 5, test_cost=1, change_cost=1, time=600, progress=lambda said: None)",
        "short plans": "changeover.plan(9, 3, test_cost=1, change_cost=1)",
        "a stream": "[None for blocks in changeover.stream(3001, 20, kind='circular', batch=64)]",
        "an order": "[None for step in changeover.load_order(20000, 5)]",
        "all pairs": "changeover.all_pairs(sys.argv[1], 8, 5, lambda a, b, x, y: None, threads=2)",
        "a diagnosis": "sheet.diagnose((['1', '2'], True) for i in itertools.repeat(0))",
        "strange blocks": "changeover.verify([1, 2, 3] for i in itertools.repeat(0))",
        "a function that sleeps": "changeover.search(40, 5, time=600, progress=lambda said: time.sleep(1000))",
    }

    def test_python_ends_while_another_thread_works(self):
        with tempfile.TemporaryDirectory() as folder:
            items = os.path.join(folder, "items")
            with open(items, "wb") as file:
                file.write(bytes(8 * 4000))
            for name, work in self.works.items():
                with self.subTest(name):
                    program = (
                        "import changeover, itertools, sys, threading, time\n"
                        "sheet = changeover.plan(9, 3, test_cost=1, change_cost=5)\n"
                        "def go_on():\n"
                        "    while True:\n"
                        f"        {work}\n"
                        "threading.Thread(target=go_on, daemon=True).start()\n"
                        "time.sleep(0.5)\n"
                    )
                    ended = run(program, items)
                    self.assertEqual((ended.returncode, ended.stderr), (0, ""))

    def test_what_shall_be_done_at_the_end_still_works(self):
        program = (
            "import atexit, changeover\n"
            "atexit.register(lambda: print(changeover.search(9, 4, time=5).design.b))\n"
            "import os\n"
            "if os.fork() == 0:\n"
            "    raise SystemExit\n"
            "os.wait()\n"
        )
        ended = run(program)
        self.assertEqual((ended.returncode, ended.stderr, len(ended.stdout.split())), (0, "", 2))

    def test_a_thread_that_the_end_waits_for_still_works(self):
        program = (
            "import atexit, threading\n"
            "def work():\n"
            "    thread = threading.Thread(target=lambda: print(changeover.search(9, 4, time=5).design.b))\n"
            "    thread.start()\n"
            "    thread.join()\n"
            "atexit.register(work)\n"
            "import changeover\n"
        )
        ended = run(program)
        self.assertEqual((ended.returncode, ended.stderr, len(ended.stdout.split())), (0, "", 1))

    def test_a_progress_function_may_fork(self):
        for end in ("sys.exit(6)", "return"):
            program = (
                "import changeover, os, sys\n"
                "said = []\n"
                "def progress(each):\n"
                "    if not said:\n"
                "        said.append(each)\n"
                "        child = os.fork()\n"
                "        if child == 0:\n"
                f"            {end}\n"
                "        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))\n"
                "print(changeover.plan(30, 5, test_cost=1, change_cost=5, time=0.5, progress=progress).complete)\n"
            )
            ended = run(program)
            self.assertEqual(ended.returncode, 0)
            self.assertEqual(ended.stdout.split(), ["6" if "exit" in end else "1", "True"])
            self.assertEqual("forked by a progress function" in ended.stderr, end == "return")


class Catalog(unittest.TestCase):
    def test_labels_find_their_designs(self):
        entry = changeover.catalog.cell(20, 5)[0]
        self.assertEqual(changeover.catalog.find(entry.label).label, entry.label)
        self.assertEqual(entry.design().b, entry.b)
        self.assertIsNone(changeover.catalog.find("no.such.label"))
        cells = changeover.catalog.entries(k_from=4, k_to=4, v_from=10, v_to=12, change=1)
        self.assertEqual(
            {(each.v, each.kind) for each in cells},
            set(itertools.product((10, 11, 12), ("linear", "circular"))),
        )

    def test_beginnings_of_labels_are_told_from_what_is_not_there(self):
        for text in ("20", "20.5", "20.5.2", "20.5.2.circular", "20.5.2.circular.",
                     "9.4.1.linear.t3"):
            with self.assertRaisesRegex(
                changeover.BadInput, f"^'{text}' ends before the number of blocks, and is no alias"
            ):
                changeover.catalog.find(text)
        self.assertIsNone(changeover.catalog.find("20.5.2.circular.3"))
        label = changeover.catalog.cell(20, 5)[0].label
        self.assertEqual(changeover.catalog.find(label.rpartition(".")[0]).label, label)

    def test_ctrl_c_ends_a_long_list(self):
        def took(work):
            begin = time.process_time()
            work()
            return time.process_time() - begin

        def interrupted():
            with self.assertRaises(KeyboardInterrupt), ctrl_c_after(0.05):
                changeover.catalog.entries(best_only=False)

        whole = took(lambda: changeover.catalog.entries(best_only=False))
        self.assertLess(took(interrupted), whole / 2)


class Plans(unittest.TestCase):
    def test_a_sheet_tests_every_pair_and_costs_what_it_says(self):
        costs = {"Pump": 12.5, "Valve": "8", "Motor": Decimal("3.25"), "Fan": 1, "Belt": 2}
        sheet = changeover.plan(costs, 3, test_cost="10.10", never=[("Fan", "Belt")])
        mounted, total, met = set(), Decimal(0), set()
        for step in sheet.steps:
            total += Decimal("10.10") + sum(Decimal(str(costs[part])) for part in step["put_in"])
            mounted = (mounted - set(step["take_out"])) | set(step["put_in"])
            self.assertEqual(mounted, set(step["setup"]))
            self.assertLessEqual(len(mounted), 3)
            met |= {frozenset(pair) for pair in itertools.combinations(mounted, 2)}
        self.assertEqual(len(met), 9)
        self.assertNotIn(frozenset(("Fan", "Belt")), met)
        self.assertEqual(total, sheet.cost)
        self.assertGreaterEqual(sheet.cost, sheet.lower_bound)
        self.assertIn("Pump", sheet.to_csv())

    def test_what_was_done_need_not_be_done_again(self):
        first = changeover.plan(7, 3, test_cost=1, change_cost=5)
        rest = changeover.plan(
            7, 3, test_cost=1, change_cost=5, done=[step["setup"] for step in first.steps[:3]]
        )
        self.assertLess(rest.cost, first.cost)
        self.assertEqual(rest.steps[0]["number"], 4)

    def test_rules_too_hard_to_decide_end_with_the_time(self):
        parameters = [
            f"P{i}: " + ", ".join(map(str, range(11))) for i in range(12)
        ]  # all different, of eleven values
        rules = [f"[P{i}] <> [P{j}];" for i, j in itertools.combinations(range(12), 2)]
        began = time.monotonic()
        with self.assertRaises(TimeoutError):
            changeover.plan(model="\n".join(parameters + rules), objective="tests", time=0.5)
        self.assertLess(time.monotonic() - began, 30)

    def test_wrong_jobs_are_refused(self):
        for wrong in (
            {"parts": ["a", "a"], "at_once": 2, "test_cost": 1, "change_cost": 1},
            {"parts": 5, "at_once": 3, "test_cost": -1, "change_cost": 1},
            {"parts": 5, "at_once": 3, "test_cost": 1},
            {"parts": 1, "at_once": 3, "test_cost": 1, "change_cost": 1},
            {
                "parts": ["a", "b"],
                "at_once": 2,
                "test_cost": 1,
                "change_cost": 1,
                "never": [("a", "z")],
            },
        ):
            with self.assertRaises(changeover.BadInput):
                changeover.plan(**wrong)


class Loads(unittest.TestCase):
    def test_every_pair_meets(self):
        for items, room in ((5, 3), (12, 5), (64, 16)):
            order = changeover.load_order(items, room)
            memory, met, loads = set(), set(), 0
            for evict, load in order:
                memory = (memory - set(evict)) | set(load)
                loads += len(load)
                self.assertLessEqual(len(memory), room)
                met |= {frozenset(pair) for pair in itertools.combinations(memory, 2)}
            self.assertEqual(len(met), items * (items - 1) // 2)
            self.assertEqual(loads, order.loads)
            self.assertGreaterEqual(order.loads, order.lower_bound)

    def test_ctrl_c_keeps_the_order(self):
        order = changeover.load_order(60, 8, time=600, progress=ctrl_c_once_there_is_a_best())
        self.assertEqual(sum(len(load) for _, load in order), order.loads)

    def test_the_executor_computes_each_pair_once(self):
        data = bytes(range(256)) * 4
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "items")
            with open(path, "wb") as file:
                file.write(data)
            seen, kept = [], []

            def compute(i, j, first, second):
                seen.append(
                    (
                        i,
                        j,
                        bytes(first) == data[64 * i : 64 * i + 64],
                        bytes(second) == data[64 * j : 64 * j + 64],
                    )
                )
                kept.append(first)

            report = changeover.all_pairs(path, 64, 5, compute, threads=2)
            self.assertTrue(report.finished)
            self.assertEqual(report.pairs, 16 * 17 // 2)
            self.assertEqual(
                sorted(pair[:2] for pair in seen), [(i, j) for i in range(16) for j in range(i, 16)]
            )
            self.assertTrue(all(pair[2] and pair[3] for pair in seen))
            with self.assertRaises(ValueError):
                kept[0][0]  # the view ended with its call

            def fails(i, j, first, second):
                raise ArithmeticError("no")

            with self.assertRaisesRegex(ArithmeticError, "no") as caught:
                changeover.all_pairs(path, 64, 5, fails)
            if hasattr(caught.exception, "__notes__"):
                self.assertEqual(len(caught.exception.__notes__), 1)
                self.assertRegex(
                    caught.exception.__notes__[0], r"^compute\(\d+, \d+\) raised this$"
                )
            with self.assertRaises(changeover.MissingResource):
                changeover.all_pairs(path + "x", 64, 5, compute)

    def test_what_is_made_of_views_outlives_the_call(self):
        try:
            import numpy as np
        except ImportError:
            np = None
        data = os.urandom(64 * 60)
        item = lambda i: data[64 * i : 64 * i + 64]
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "items")
            with open(path, "wb") as file:
                file.write(data)
            kept = []

            def compute(i, j, first, second):
                kept.append((item(i)[:16], first[:16]))
                kept.append((item(j)[::-1], memoryview(second)[::-1]))
                kept.append((item(i), first.cast("H")))
                if np is not None:
                    kept.append((item(j), np.frombuffer(second, np.uint8)))

            report = changeover.all_pairs(path, 64, 4, compute, threads=2)
            self.assertEqual(report.pairs, 60 * 61 // 2)
            self.assertEqual(sum(bytes(view) != wanted for wanted, view in kept), 0)
            with self.assertRaises(TypeError):
                kept[0][1][0] = 1  # read-only
            # A fault keeps its views, too.
            faults = []

            def fails(i, j, first, second):
                faults.append((item(i), first[:]))
                raise ArithmeticError

            with self.assertRaises(ArithmeticError):
                changeover.all_pairs(path, 64, 4, fails)
            self.assertTrue(all(bytes(view) == wanted for wanted, view in faults))
            exporter = type(kept[0][1].obj)
            with self.assertRaises(TypeError):
                exporter()

    def test_a_gram_matrix_out_of_core(self):
        try:
            import numpy as np
        except ImportError:
            self.skipTest("numpy is not installed")
        with tempfile.TemporaryDirectory() as folder:
            vectors = np.random.default_rng(1).standard_normal((96, 10)).astype(np.float32)
            on_disk = np.memmap(os.path.join(folder, "v"), np.float32, "w+", shape=vectors.shape)
            on_disk[:] = vectors
            rows, room = 8, 5  # 12 chunks of 8 vectors, 5 chunks in memory
            gram = np.full((96, 96), np.nan, np.float32)
            memory = {}
            for evict, load in changeover.load_order(96 // rows, room):
                for x in evict:
                    del memory[x]
                memory.update((x, np.array(on_disk[x * rows : (x + 1) * rows])) for x in load)
                for x, y in itertools.product(load, memory):
                    part = memory[x] @ memory[y].T
                    gram[x * rows : (x + 1) * rows, y * rows : (y + 1) * rows] = part
                    gram[y * rows : (y + 1) * rows, x * rows : (x + 1) * rows] = part.T
            np.testing.assert_allclose(gram, vectors @ vectors.T, rtol=1e-4, atol=1e-4)


if __name__ == "__main__":
    unittest.main()
