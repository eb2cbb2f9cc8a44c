"""What callers have at hand: paths, tables, mappings, arrays and numbers of other packages."""

import datetime
import json
import os
import pathlib
import tempfile
import types
import unittest
from decimal import Decimal

import changeover

try:
    import numpy
    import pandas
except ImportError:
    numpy = pandas = None

needs_pandas = unittest.skipIf(pandas is None, "pandas is not installed")


def plan(parts, at_once=3, **more):
    return changeover.plan(parts, at_once, **{"test_cost": 1, "change_cost": 5, **more})


class Paths(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.design = changeover.design(8, 5)

    def test_files_are_named_by_strings_bytes_and_paths(self):
        file = self.folder / "design.txt"
        file.write_text(self.design.to_string(), encoding="utf-8")
        for path in (file, str(file), bytes(file)):
            self.assertEqual(changeover.read(path), self.design)
            self.design.draw().save(pathlib.Path(self.folder, "picture.svg"))
        self.assertTrue((self.folder / "picture.svg").read_text().startswith("<svg"))
        with self.assertRaisesRegex(TypeError, "path is a string or a pathlib.Path, not 3"):
            changeover.read(3)

    def test_names_that_are_no_utf_8(self):
        name = os.fsencode(self.folder) + b"/\xff.txt"
        with open(name, "w", encoding="utf-8") as file:
            file.write(self.design.to_string())
        self.assertEqual(changeover.read(name), self.design)
        self.assertEqual(changeover.read(os.fsdecode(name)), self.design)
        os.unlink(name)
        with self.assertRaisesRegex(changeover.MissingResource, r"xff.txt: cannot read"):
            changeover.read(name)

    def test_jobs_take_paths(self):
        items = self.folder / "items"
        items.write_bytes(bytes(80))
        journal = self.folder / "journal"
        report = changeover.all_pairs(items, 8, 4, lambda *_: None, journal=journal)
        self.assertEqual(report.pairs, 55)
        self.assertTrue(journal.exists())
        again = changeover.all_pairs(items, 8, 4, lambda *_: None, earlier=[journal])
        self.assertEqual(again.pairs, 0)
        self.assertEqual(
            changeover.all_pairs(items, 8, 4, lambda *_: None, journal=None).pairs, 55)
        updates = self.folder / "updates"
        self.assertTrue(
            changeover.update_pairs(items, 8, 4, lambda *_: None, journal=updates).finished)
        for call in (changeover.all_pairs, changeover.update_pairs):
            with self.assertRaisesRegex(
                changeover.BadInput, "^/dev/full: is not a regular file, so it cannot be a journal"
            ):
                call(items, 8, 4, lambda *_: None, journal="/dev/full")
        with self.assertRaisesRegex(changeover.BadInput, "or give short_last=True$"):
            changeover.all_pairs(items, 7, 4, lambda *_: None)
        with self.assertRaisesRegex(changeover.BadInput, "its header of 100 leaves no item"):
            changeover.all_pairs(items, 8, 4, lambda *_: None, header_bytes=100)
        with self.assertRaisesRegex(changeover.BadInput, "^1099511627776 threads are too many"):
            changeover.all_pairs(items, 8, 4, lambda *_: None, threads=2**40)


class Sheets(unittest.TestCase):
    @needs_pandas
    def test_a_sheet_without_tests_is_a_frame_without_rows(self):
        all_done = {"done": [(["1", "2", "3"], True)]}
        some = plan(4).to_frame()
        for sheet, heads in (
            (plan(3, **all_done), list(some.columns)),
            (plan(3, budget=0), list(some.columns)),
            (plan(3, benches=2, **all_done), [*some.columns, "begin", "end"]),
        ):
            self.assertEqual(sheet.tests, 0)
            keys = ["number"] if isinstance(sheet, changeover.RunSheet) else ["bench", "number"]
            for frame in (sheet.to_frame(), changeover.to_pandas(sheet)):
                self.assertEqual((len(frame), list(frame.columns), list(frame.index.names)),
                                 (0, heads, keys))
        both = plan(4, benches=2).to_frame()
        self.assertEqual(list(both.columns), [*some.columns, "begin", "end"])

    def test_a_bench_is_down_or_not(self):
        def tests(down):
            sheets = plan(6, benches=[{"name": "N", "down": down}, {"name": "S"}]).sheets
            return [len(sheet) for sheet in sheets]

        self.assertEqual(tests(True)[0], 0)
        for up in (False, 0, None):
            self.assertGreater(tests(up)[0], 0)
        for words in ("no", "False", "0", "yes", ["x"]):
            with self.assertRaisesRegex(TypeError, "^benches: down is True or False, not "):
                tests(words)

    def test_results_are_a_list(self):
        sheet = plan(5)
        wrong = [{"FAIL": 1}, {True, False}, "fail", b"fail"]
        if pandas:
            wrong.append(pandas.DataFrame({"result": ["fail", "pass"]}))
            told = sheet.diagnose(pandas.Series([True, False]))
            self.assertEqual((told["passed"], told["failed"]), (1, 1))
        for results in wrong:
            with self.assertRaisesRegex(TypeError, "^results must be a list"):
                sheet.diagnose(results)

    def test_costs_are_numbers_however_they_are_written(self):
        for cost, amount in ((Decimal(100).normalize(), 100), (0.00002, "0.00002"),
                             (1e-5, "0.00001"), (Decimal("1E-6"), "0.000001"), ("12.50", "12.5")):
            self.assertEqual(plan(3, test_cost=cost, change_cost=1).cost, Decimal(amount) + 3)
        for cost in (1e300, float("nan"), "1E+2"):
            with self.assertRaisesRegex(changeover.BadInput, "is not a cost"):
                plan(3, test_cost=cost)

    def test_mappings_are_mappings(self):
        class Names(dict):
            pass

        plain = plan(list("abcd"), budget=22, weights={("a", "b"): 10})
        kinds = [types.MappingProxyType, Names]
        if pandas:
            kinds.append(pandas.Series)
        for kind in kinds:
            with self.subTest(kind=kind):
                self.assertEqual(
                    plan(list("abcd"), budget=22, weights=kind({("a", "b"): 10})), plain)
                slots = plan(list("abc"), 2, slots=kind({"x": 1}), slot_of=kind({"a": "x"}))
                self.assertEqual(slots.pairs_needed, 2)
                benches = plan(5, benches=[kind({"name": "N", "at_once": 3}), "S"])
                self.assertEqual(benches.benches, ["N", "S"])
        done = types.MappingProxyType({"parts": ["1", "2", "3"], "result": True})
        self.assertEqual(plan(4, done=[done]).pairs_needed, 3)
        for wrong in ([("a", "b")], "ab", 3):
            for name in ("weights", "quantities", "change_costs"):
                with self.assertRaisesRegex(TypeError, f"^{name} is a dict, not "):
                    plan(list("abcd"), **{name: wrong})

    @needs_pandas
    def test_columns_with_an_empty_cell(self):
        parts = pandas.DataFrame({"name": list("abcd"), "quantity": [1, None, 2, 1]})
        self.assertEqual(plan(parts, benches=2).pairs_needed, 6)
        benches = pandas.DataFrame({"name": ["N", "S"], "at_once": [2, None]})
        for given in (benches, benches.to_dict("records")):
            sheets = plan(5, benches=given)
            self.assertEqual(sheets.benches, ["N", "S"])
            self.assertEqual({len(step["setup"]) for step in sheets.sheets[0]} - {2}, set())
        self.assertEqual(plan(4, benches=2, quantities={1: 1.0, 2: numpy.float64(2)}).tests,
                         plan(4, benches=2, quantities={1: 1, 2: 2}).tests)

    def test_parts_of_which_there_is_none_are_named(self):
        sheet = plan(list("abcde"), quantities={"a": 0})
        self.assertEqual((sheet.pairs_needed, sheet.notes),
                         (6, ["parts: left out, since there is none: 'a'"]))

    def test_what_all_benches_refuse_is_refused(self):
        for benches in (None, 1, 2):
            with self.assertRaisesRegex(changeover.BadInput, "^3 and 4 must meet, but beside"):
                plan(6, mounted=["1", "2"], benches=benches)

    def test_numbers_that_are_names_are_names(self):
        with self.assertRaisesRegex(
            changeover.BadInput, "there is no part '1'; give a name of the parts list$"
        ):
            plan(["3", "x", "y", "w"], done=[[1, 2]])

    def test_days_are_dates(self):
        days = ["2025-03-03", datetime.date(2025, 3, 3), datetime.datetime(2025, 3, 3, 8)]
        if pandas:
            days.append(pandas.Timestamp("2025-03-03"))
        for day in days:
            sheets = plan(6, benches=2, hours=8, change_cost=1, first_day=day)
            self.assertEqual(sheets.sheets[0][0]["date"], "2025-03-03")
        with self.assertRaisesRegex(TypeError, "^first_day is a day, as '2025-03-31'"):
            plan(6, benches=2, hours=8, change_cost=1, first_day=20250303)

    def test_words_are_those_of_python(self):
        for wrong, words in (
            (dict(parts=[]), "^parts: no part is listed; give a name for each$"),
            (dict(parts=3, pairs=[]), r"^pairs: no pair is listed; give \(a, b\) for each$"),
            (dict(parts=list("abc"), change_cost=None, change_costs={("a", "b"): 1}),
             "^change_costs has no cost for 'c'; give one for every two parts$"),
            (dict(parts=list("ab"), slots={"x": -1}, slot_of={"a": "x"}), "not '-1'$"),
            (dict(parts=3, done=[([1, 2], 1)]), "True, False, None or a text, not '1'$"),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(changeover.BadInput, words):
                plan(**wrong)


class Loads(unittest.TestCase):
    @needs_pandas
    def test_sizes_have_the_items_of_their_index(self):
        sizes = {0: 8, 1: 1, 2: 1, 3: 1, 4: 1, 5: 1}
        mine = pandas.Series(sizes).sort_values()
        orders = [changeover.load_order(None, sizes=given, memory=10)
                  for given in (sizes, mine, mine.astype(float))]
        self.assertEqual({order.bytes for order in orders}, {orders[0].bytes})
        memory, held = set(), []
        for evict, load in orders[1]:
            memory = memory - set(evict) | set(load)
            held.append(sum(sizes[x] for x in memory))
        self.assertLessEqual(max(held), 10)

    def test_memory_is_written_as_sizes_are(self):
        order = changeover.load_order(None, sizes=["4M"] * 6, memory="16M")
        self.assertEqual(order, changeover.load_order(None, sizes=["4M"] * 6, memory=16 * 10**6))
        with self.assertRaisesRegex(changeover.BadInput, "^memory: '16 boxes' is not a number of"):
            changeover.load_order(None, sizes=[1, 2], memory="16 boxes")
        with self.assertRaisesRegex(TypeError, "^memory is a number of bytes, or as in '4M', not"):
            changeover.load_order(None, sizes=[1, 2], memory=1.5)

    @needs_pandas
    def test_pairs_of_arrays_are_those_of_lists(self):
        pairs = [(i, (7 * i + 1) % 60) for i in range(60) if i != (7 * i + 1) % 60]
        wanted = changeover.load_order(None, 4, pairs=pairs)
        array = numpy.array(pairs)
        for given in (array, array.astype("u1"), numpy.asfortranarray(array), array.tolist(),
                      memoryview(array), pandas.DataFrame(array), iter(pairs),
                      array.astype(">i4"), map(list, pairs), [tuple(row) for row in array]):
            with self.subTest(kind=type(given)):
                order = changeover.load_order(None, 4, pairs=given)
                self.assertEqual(list(order), list(wanted))
                self.assertEqual(json.loads(order.request_json())["pairs"],
                                 json.loads(wanted.request_json())["pairs"])

    @needs_pandas
    def test_arrays_that_are_no_pairs(self):
        for wrong, fault, words in (
            (numpy.array([[0.0, 1]]), TypeError, "are whole numbers, not 0.0; give int"),
            (numpy.array([[0, -1]]), changeover.BadInput, "numbered from 0 to [0-9]*, not -1"),
            (numpy.array([[0, 10**7]]), changeover.BadInput, "numbered from 0 to"),
            (numpy.array([[0, 1, 2, 3]]), changeover.BadInput, "row 0 has more than two items"),
            (numpy.nonzero(numpy.eye(4, k=1)), TypeError, "give numpy.column_stack"),
            (numpy.array(3), TypeError, "^pairs must be a list of rows"),
            (numpy.array([1, 2]), TypeError, "^a row of pairs must be a list of two items"),
            (memoryview(numpy.eye(3)), TypeError, "give tolist"),
            (numpy.ma.array([[0, 1], [1, 2]], mask=[[1, 0], [0, 0]]), TypeError, "masked"),
            ([], changeover.BadInput, "^pairs: no pair is listed; give rows of two items$"),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(fault, words):
                changeover.load_order(None, 3, pairs=wrong)
        with self.assertRaisesRegex(TypeError, "give numpy.column_stack"):
            changeover.load_order(None, 3, workers=2, pairs=numpy.nonzero(numpy.eye(4, k=1)))

    def test_limits_are_those_of_other_searches(self):
        for wrong, words in (({"time": -1}, "^time is a number of seconds, 0 to 3153600000$"),
                             ({"time": float("inf")}, "^time is a number of seconds"),
                             ({"time": float("nan")}, "^time is a number of seconds"),
                             ({"threads": 0}, "^threads 0 is out of range; give 1 to 1024$")):
            with self.assertRaisesRegex(changeover.BadInput, words):
                changeover.load_order(9, 4, **wrong)
            with self.assertRaisesRegex(changeover.BadInput, words):
                plan(9, **wrong)
            with self.assertRaisesRegex(changeover.BadInput, "^(time|threads) is a number"):
                changeover.search(9, 4, **wrong)


class Designs(unittest.TestCase):
    def test_a_design_of_a_design_has_its_names(self):
        mine = changeover.Design([["a", "b", "c"], ["b", "c", "d"], ["c", "d", "a"]])
        self.assertEqual(changeover.Design(mine), mine)
        circular = changeover.Design(mine, kind="circular")
        self.assertEqual((circular.labels, circular.kind), (list("abcd"), "circular"))
        self.assertIsNone(changeover.Design(mine, v=5).labels)

    def test_derived_classes_have_attributes_of_their_own(self):
        class Mine(changeover.Design):
            def __init__(self, blocks):
                super().__init__(blocks)
                self.extra = 3

        self.assertEqual(Mine([[0, 1, 2], [1, 2, 3]]).extra, 3)
        with self.assertRaises(AttributeError):
            changeover.design(7, 3).extra = 3

    @needs_pandas
    def test_what_is_masked_is_no_element(self):
        blocks = [[0, 1, 2], [1, 2, 3]]
        with self.assertRaisesRegex(TypeError, "^block 1: elements are .*not masked"):
            changeover.Design(numpy.ma.array(blocks, mask=[[1, 0, 0], [0, 0, 0]]))
        self.assertEqual(changeover.Design(numpy.ma.array(blocks)), changeover.Design(blocks))
        with self.assertRaisesRegex(TypeError, "^block 1 must be a list of elements, not"):
            changeover.Design(numpy.array([0, 1, 2]))

    def test_blocks_are_a_sequence(self):
        design = changeover.design(8, 5)
        for each in (design, design.blocks):
            self.assertEqual((each.index(design[2]), each.count(design[2])), (2, 1))
            with self.assertRaises(ValueError):
                each.index((0, 0, 0, 0, 0))

    @needs_pandas
    def test_frames_of_whatever_has_one(self):
        self.assertEqual(len(changeover.to_pandas(changeover.load_order(9, 4))), 12)
        cells = changeover.table(4, range(9, 12))
        for each in (cells, list(cells), iter(cells), cells[:3] + cells[3:]):
            self.assertEqual(len(changeover.to_pandas(each)), 6)
        self.assertIsInstance(cells[:3] + cells[3:], changeover.Table)
        for wrong in (3, [1], "abc"):
            with self.assertRaisesRegex(TypeError, r"^to_pandas\(\): what is a table, a design"):
                changeover.to_pandas(wrong)

    def test_the_catalog_knows_its_words(self):
        with self.assertRaisesRegex(changeover.BadInput, "'retracted', not 'foo'$"):
            changeover.catalog.entries(status="foo")

    def test_every_fact_says_what_it_is(self):
        for name in changeover.__all__:
            each = getattr(changeover, name)
            for inner, fact in vars(each).items() if isinstance(each, type) else ():
                if isinstance(fact, property):
                    self.assertTrue(fact.__doc__, f"{name}.{inner}")
        self.assertEqual(repr(changeover.stream(61, 4)),
                         "<Stream: circular, 366 blocks of 4 of 61 elements>")


if __name__ == "__main__":
    unittest.main()
