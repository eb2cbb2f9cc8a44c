"""Every public class: its objects are pickled, compared, hashed and sent to other processes."""

import copy
import functools
import inspect
import json
import multiprocessing
import os
import pathlib
import pickle
import random
import tempfile
import threading
import unittest
import zlib

import changeover
from changeover import cluster

MODEL = "OS: Debian, Fedora\nBrowser: Firefox, Chromium\nDisk: small, large\n"


def plan(**given):
    return changeover.plan(
        **{"parts": 9, "at_once": 3, "test_cost": 1, "change_cost": 5, "steps": 500, **given})


SHEETS = {
    "parts": {},
    "a model": {"parts": None, "at_once": None, "model": MODEL, "objective": "tests",
                "test_cost": None, "change_cost": None},
    "a budget and weights": {"budget": 60, "weights": {(1, 2): 7, (3, 4): 2}},
    "costs by what is replaced": {
        "parts": 4, "at_once": 2, "change_cost": None,
        "change_costs": {(i, j): i + 2 * j for i in range(1, 5) for j in range(1, 5) if i != j}},
    "slots": {"parts": ["a", "b", "c", "d"], "at_once": None, "slots": {"CPU": 1, "disk": (1, 2)},
              "slot_of": {"a": "CPU", "b": "CPU", "c": "disk", "d": "disk"}},
    "what was done": {"done": [([1, 2, 3], True), ([1, 4, 5], "FAILED - hang"), [6, 7, 8]],
                      "never": [(1, 9, "too hot")], "start": [1, 2, 3]},
    "a shuffle and a time": {"shuffle": 3, "time": 0.2, "steps": None, "title": "Pumps"},
    "three at once": {"parts": 6, "at_once": 4, "strength": 3},
}
BENCHES = {
    "two benches": {"benches": 2},
    "different ones": {
        "benches": [{"name": "a", "without": ["1"], "hours": 8}, {"name": "b", "at_once": 4}],
        "hours": 9, "first_day": "2025-03-31", "quantities": {2: 1}, "parts": 8},
    "the least cost within a budget": {"benches": 2, "objective": "cost", "budget": 70},
}


def loads(**given):
    return changeover.load_order(**{"items": 20, "room": 5, **given})


def files():
    """Runs over a file of items."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "items"
        path.write_bytes(bytes(8 * 6))
        yield changeover.all_pairs(str(path), 8, 3, lambda *_: None)
        yield changeover.update_pairs(
            str(path), 8, 3, lambda *_: None, journal=str(path.with_suffix(".journal")))


def on_a_cluster():
    yield cluster.simulate(items=200, room=20, workers=2, pair_seconds=0.001, item_bytes=10**6)


DESIGN = changeover.design(9, 4)

# What makes objects of each public class; all of them, see test_no_class_is_forgotten.
OBJECTS = {
    changeover.Design: lambda: [
        DESIGN, changeover.design(8, 5, kind="circular"),
        changeover.Design([["a", "b"], ["b", "c"], ["c", "a"]]),
        changeover.Design([[0, 1], [2, 3]])],
    changeover.Blocks: lambda: [DESIGN.blocks, DESIGN.blocks[1:3], DESIGN.blocks[::-2],
                                DESIGN.blocks[:0]],
    changeover.Verdict: lambda: [DESIGN.verdict, changeover.Design([[0, 1], [2, 3]]).verdict],
    changeover.Picture: lambda: [DESIGN.draw(), changeover.design(61, 4).draw("stays")],
    changeover.Bound: lambda: changeover.bounds(9, 4).all,
    changeover.Bounds: lambda: [changeover.bounds(9, 4), changeover.bounds(4, 2, change=1)],
    changeover.Answer: lambda: [
        changeover.plan(9, 3, test_cost=1, change_cost=5, steps=300).what_if()],
    changeover.Counted: lambda: [changeover.bounds(9, 4, 1, "circular").classified],
    changeover.Cell: lambda: list(changeover.table(4, (4, 9))),
    changeover.Table: lambda: [changeover.table((2, 4), (4, 9))],
    changeover.Entry: lambda: changeover.catalog.cell(20, 5)[:3]
        + changeover.catalog.entries(v_to=12)[:3],
    changeover.SearchResult: lambda: [
        changeover.search(9, 4, change=1, time=1, target=9),
        changeover.search(6, 3, 1, exact=True)],
    changeover.Classification: lambda: [changeover.classify(9, 4, 6, 2, "circular")],
    changeover.RunSheet: lambda: [plan(**given) for given in SHEETS.values()],
    changeover.BenchSheets: lambda: [plan(**given) for given in BENCHES.values()],
    changeover.LoadOrder: lambda: [
        loads(), loads(epochs=2, new_pairs=True), loads(time=0.2, pairs=[(i, (3 * i + 1) % 20)
                                                        for i in range(20) if i != 3 * i + 1])],
    changeover.WorkerLoads: lambda: [loads(workers=2), loads(workers=2, disjoint=True)],
    changeover.WorkStep: lambda: list(loads(new_pairs=True, write_back=True).work())[:3],
    changeover.Report: lambda: list(files())[:1],
    changeover.UpdateReport: lambda: list(files())[1:],
    cluster.Simulation: lambda: list(on_a_cluster()),
}

# Public classes whose objects are not pickled, and why.
NOT_PICKLED = {
    changeover.Stream: "it is read once",
}

# Public classes that need a cluster: test_faults_on_clusters.py pickles objects of them.
OF_CLUSTERS = {cluster.Report, cluster.Improvement}


def public_classes():
    found = {getattr(module, name) for module in (changeover, cluster) for name in module.__all__
             if inspect.isclass(getattr(module, name))}
    return {each for each in found if not issubclass(each, BaseException)}


class Values(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.made = {kind: make() for kind, make in OBJECTS.items()}

    def each(self):
        for kind, objects in self.made.items():
            self.assertGreater(len(objects), 0, kind)
            for number, one in enumerate(objects):
                self.assertIs(type(one), kind, number)
                yield one

    def test_no_class_is_forgotten(self):
        self.assertEqual(public_classes(), set(OBJECTS) | set(NOT_PICKLED) | OF_CLUSTERS)

    def test_they_are_what_they_were(self):
        for one in self.each():
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                again = pickle.loads(pickle.dumps(one, protocol))
                self.assertEqual(again, one)
                if type(one).__hash__:
                    self.assertEqual(hash(again), hash(one))
                self.assertEqual(repr(again), repr(one))
            for name in dir(type(one)):
                if isinstance(getattr(type(one), name), property):
                    self.assertEqual(getattr(again, name), getattr(one, name), name)
            # And a pickle of what came out of one.
            self.assertEqual(pickle.loads(pickle.dumps(again)), one)

    def test_copies_are_equal_and_keys(self):
        for one in self.each():
            self.assertEqual(copy.copy(one), one)
            self.assertEqual(copy.deepcopy(one), one)
            # What can be changed is no key.
            self.assertEqual(type(one).__hash__ is None, isinstance(one, (list, dict)))
            if type(one).__hash__:
                self.assertEqual(len({copy.deepcopy(one), one}), 1)

    def test_different_ones_are_told_apart(self):
        of_four, of_five = changeover.design(9, 4).blocks[:0], changeover.design(8, 5).blocks[:0]
        self.assertNotEqual(of_four, of_five)
        for kind, objects in self.made.items():
            for i, one in enumerate(objects):
                for other in objects[:i]:
                    self.assertNotEqual(one, other, kind)
                self.assertNotEqual(one, None)
        self.assertNotEqual(changeover.bounds(9, 4), changeover.bounds(9, 4).all[0])

    def test_sheets_are_written_as_before(self):
        for kind in (changeover.RunSheet, changeover.BenchSheets):
            for one in self.made[kind]:
                again = pickle.loads(pickle.dumps(one))
                for name in ("csv", "html", "json", "markdown", "text", "xlsx"):
                    write = f"to_{name}"
                    self.assertEqual(getattr(again, write)(), getattr(one, write)(), write)
                self.assertEqual(again.request_json(), one.request_json())

    def test_sheets_answer_as_before(self):
        one = plan()
        again = pickle.loads(pickle.dumps(one))
        results = [True] * 3 + [False] + [True] * 3
        self.assertEqual(again.diagnose(results), one.diagnose(results))
        self.assertEqual(again.what_if(), one.what_if())

    def test_sheets_of_files_need_no_files(self):
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            parts, model, book = (folder / name for name in ("parts.csv", "model.pict", "run.xlsx"))
            parts.write_text("name,cost\nPump A,5\nMotor,2\nValve,3\nHose,4\n", encoding="utf-8")
            model.write_text(MODEL, encoding="utf-8")
            first = plan(parts=parts, at_once=2, change_cost=None)
            book.write_bytes(first.to_xlsx())
            sheets = [first, plan(**{**SHEETS["a model"], "model": model}),
                      changeover.plan(book, steps=500)]
            texts = [pickle.dumps(sheet) for sheet in sheets]
            for file in (parts, model, book):
                file.unlink()
            for text, sheet in zip(texts, sheets):
                again = pickle.loads(text)
                self.assertEqual(again, sheet)
                self.assertEqual(again.to_xlsx(), sheet.to_xlsx())
                self.assertEqual(pickle.loads(pickle.dumps(again)), sheet)

    def test_a_sheet_of_what_is_read_once_says_so(self):
        with tempfile.TemporaryDirectory() as folder:
            pipe = pathlib.Path(folder) / "parts"
            os.mkfifo(pipe)
            writer = threading.Thread(target=pipe.write_text, args=("name\na\nb\nc\nd\n",))
            writer.start()
            sheet = plan(parts=pipe, at_once=2)
            writer.join()
            self.assertEqual(sheet.pairs_needed, 6)
            with self.assertRaisesRegex(
                changeover.BadInput,
                "^a plan of a file that is gone, or can be read only once, cannot be pickled or "
                "copied; read the parts from a regular file$",
            ):
                pickle.dumps(sheet)

    def test_processes_exchange_sheets(self):
        with multiprocessing.get_context("spawn").Pool(2) as pool:
            asked = functools.partial(changeover.plan, at_once=3, test_cost=1, change_cost=5,
                                      steps=500)
            self.assertEqual(pool.map(asked, [6, 7, 9]), [asked(parts) for parts in (6, 7, 9)])
            self.assertEqual(pool.starmap(changeover.bounds, [(9, 4), (8, 5)]),
                             [changeover.bounds(9, 4), changeover.bounds(8, 5)])

    def test_what_was_damaged_is_refused(self):
        for one in (DESIGN.blocks, plan(), changeover.catalog.cell(20, 5)[0]):
            rebuild, state = one.__reduce_ex__(4)
            place = next(i for i, each in enumerate(state) if isinstance(each, bytes))
            for _ in range(50):
                wrong = bytearray(state[place])
                wrong[random.randrange(len(wrong))] ^= 1 << random.randrange(8)
                given = [*state[:place], bytes(wrong), *state[place + 1:]]
                with self.assertRaisesRegex(changeover.BadInput, "is damaged; create it again"):
                    rebuild(*given)

    def test_sheets_that_do_not_count_as_they_say_are_refused(self):
        one = plan()
        rebuild, (kind, state, _) = one.__reduce_ex__(4)
        facts, kept = pickle.loads(state)

        def again(facts, kept):
            text = pickle.dumps((facts, kept), 4)
            return rebuild(kind, text, zlib.crc32(text))

        self.assertEqual(again(facts, kept), one)
        other = plan(change_cost=6)._kept()
        for wrong in ((facts, other), ({**facts, "tests": facts["tests"] - 1}, kept)):
            with self.assertRaisesRegex(changeover.BadInput, "counted it differently; create it "
                                        "again"):
                again(*wrong)
        for wrong in (kept[:-1], (*kept[:4], None, None), (kept[0], "{}", *kept[2:])):
            with self.assertRaisesRegex(changeover.BadInput, "does not fit this one.*create it "
                                        "again"):
                again(facts, wrong)

        rebuild, (kind, state, _) = changeover.catalog.cell(20, 5)[0].__reduce_ex__(4)
        facts, kept = pickle.loads(state)
        with self.assertRaisesRegex(
            changeover.BadInput,
            "^another version of changeover pickled this Entry; find it again$",
        ):
            again({**facts, "b": 3}, kept)
        with self.assertRaisesRegex(ValueError, "^these are not rows of that many numbers$"):
            DESIGN.blocks.__reduce_ex__(4)[0](b"12345", 1, zlib.crc32(b"12345", 1))
        rebuild, (state, k, checksum) = DESIGN.blocks.__reduce_ex__(4)
        for wrong in (0, -1, k - 1, 2 * k, 2**32, 2**62, 2**63, None, "4"):
            for text in (state, b""):
                with self.assertRaisesRegex(changeover.BadInput, "^this pickle of Blocks is damag"):
                    rebuild(text, wrong, checksum)

    def test_numbers_that_are_none_of_the_job_are_refused(self):
        one = plan(**BENCHES["different ones"])
        rebuild, (kind, state, _) = one.__reduce_ex__(4)
        facts, kept = pickle.loads(state)
        place, bench = next((i, bench) for i, bench in enumerate(kept[4][0]) if bench)
        (setup, begin, _), *later = bench
        for again in ([8], [77777]):
            benches = [*kept[4][0]]
            benches[place] = [(setup, begin, again), *later]
            text = pickle.dumps((facts, (*kept[:4], (benches, *kept[4][1:]))), 4)
            with self.assertRaisesRegex(changeover.BadInput, "put in again is none of the job"):
                rebuild(kind, text, zlib.crc32(text))

        rebuild, (kind, state, _) = loads(pairs=[(1, 2), (2, 3)]).__reduce_ex__(4)
        facts, asked, ends, *rest = pickle.loads(state)
        for wrong in (b"a", ends + b"a", ends[:-1], ends[:-4]):
            text = pickle.dumps((facts, asked, wrong, *rest), 4)
            with self.assertRaisesRegex(changeover.BadInput, "are not whole pairs"):
                rebuild(kind, text, zlib.crc32(text))

    def test_an_order_that_is_verified_beside_the_work(self):
        one = loads(verify_beside=True)
        for other in (pickle.loads(pickle.dumps(one)), copy.copy(one)):
            self.assertEqual(list(other), list(loads()))
            self.assertTrue(other.verified())

    def test_what_cannot_be_pickled_says_so(self):
        stream = changeover.stream(61, 4)
        for refused in (pickle.dumps, copy.copy, copy.deepcopy):
            with self.assertRaisesRegex(TypeError, "^a Stream cannot be pickled or copied: "
                                        f"{NOT_PICKLED[changeover.Stream]}; call"):
                refused(stream)
        self.assertEqual(len({stream, stream, changeover.stream(61, 4)}), 2)

    def test_faults_are_pickled(self):
        for name in changeover.__all__:
            kind = getattr(changeover, name)
            if inspect.isclass(kind) and issubclass(kind, BaseException):
                again = pickle.loads(pickle.dumps(kind("a line")))
                self.assertEqual((type(again), str(again)), (kind, "a line"))

    def test_what_is_asked_goes_there_too(self):
        self.assertEqual(json.loads(pickle.loads(pickle.dumps(plan())).request_json())["at_once"],
                         3)


if __name__ == "__main__":
    unittest.main()
