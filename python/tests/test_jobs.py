"""Jobs with all that they may be told: run sheets with slots, pairs, budgets, larger designs."""

import collections
import itertools
import json
import pathlib
import signal
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction

import changeover


def pairs_of(setup):
    return {frozenset(pair) for pair in itertools.combinations(setup, 2)}


def met_by(sheet):
    return set().union(*(pairs_of(step["setup"]) for step in sheet.steps))


class Plans(unittest.TestCase):
    def plan(self, parts, at_once, **more):
        return changeover.plan(parts, at_once, **{"test_cost": 2, "change_cost": 1, **more})

    def test_only_the_pairs_that_are_listed_must_meet(self):
        wanted = [("a", "b"), ("b", "c"), ("c", "d")]
        sheet = self.plan("a b c d e f".split(), 2, pairs=wanted)
        self.assertTrue({frozenset(pair) for pair in wanted} <= met_by(sheet))
        self.assertEqual((sheet.tests, sheet.changes, sheet.pairs_needed), (3, 4, 3))
        self.assertTrue(sheet.cheapest)

    def test_what_stays_mounted_is_in_every_setup(self):
        sheet = self.plan(7, 4, mounted=[1], start=[1, "2"])
        self.assertTrue(all("1" in step["setup"] for step in sheet.steps))
        self.assertEqual(len(met_by(sheet)), 21)
        first = set(sheet.steps[0]["put_in"])
        self.assertEqual(sheet.changes, sum(len(step["put_in"]) for step in sheet.steps))
        self.assertTrue(first.isdisjoint({"1", "2"}))

    def test_what_comes_first_comes_first(self):
        first = [["a", "b", "c"], ["d", "b", "c"]]
        sheet = self.plan("a b c d e".split(), 3, first=first)
        self.assertEqual(
            [set(step["setup"]) for step in sheet.steps[:2]], [set(each) for each in first]
        )
        self.assertEqual(len(met_by(sheet)), 10)

    def test_numbers_of_slots_are_any_whole_numbers(self):
        class One:  # as those of NumPy
            def __index__(self):
                return 1

        asked = dict(
            slot_of={"a": "CPU", "b": "CPU", "c": "disk", "d": "disk"},
            test_cost=1,
            change_cost=1,
            steps=10,
        )
        plans = [
            changeover.plan(list("abcd"), slots={"CPU": room, "disk": 1}, **asked).steps
            for room in (1, True, One(), (1, One()), iter([1, 1]))
        ]
        self.assertEqual(plans, plans[:1] * 5)

    def test_slots_are_kept(self):
        slot_of = {"P1": "CPU", "P2": "CPU", "P3": "CPU", "D1": "disk", "D2": "disk", "D3": "disk"}
        sheet = self.plan(
            list(slot_of) + ["fan"], 5, slots={"CPU": 1, "disk": (1, 2)}, slot_of=slot_of
        )
        for step in sheet.steps:
            kinds = [slot_of.get(part) for part in step["setup"]]
            self.assertEqual(kinds.count("CPU"), 1)
            self.assertTrue(1 <= kinds.count("disk") <= 2)
        apart = pairs_of(["P1", "P2", "P3"])
        self.assertEqual(met_by(sheet), pairs_of(list(slot_of) + ["fan"]) - apart)
        self.assertTrue(sheet.complete)

    def test_three_at_a_time(self):
        sheet = self.plan(7, 4, strength=3)
        met = {
            frozenset(each)
            for step in sheet.steps
            for each in itertools.combinations(step["setup"], 3)
        }
        self.assertEqual(len(met), 35)

    def test_a_budget_is_kept_and_buys_what_is_worth_most(self):
        whole = self.plan(8, 3)
        self.assertTrue(whole.complete)
        heavy = {("7", "8"): 100}
        sheet = self.plan(8, 3, budget=9, weights=heavy)
        self.assertLessEqual(sheet.cost, 9)
        self.assertFalse(sheet.complete)
        self.assertIn(frozenset("78"), met_by(sheet))
        self.assertEqual(sheet.pairs_tested, len(met_by(sheet)))

    def test_costs_by_what_is_replaced(self):
        names = "a b c d".split()
        costs = {
            (out, into): 1 if out < into else "0.5"
            for out in names
            for into in names
            if out != into
        }
        sheet = changeover.plan(names, 2, test_cost=1, change_cost=3, change_costs=costs)
        total, mounted = Decimal(0), []
        for step in sheet.steps:
            total += 1
            out, into = step["take_out"], step["put_in"]
            pairings = [
                sum(Decimal(str(costs[pair])) for pair in zip(order, into))
                for order in itertools.permutations(out)
            ]
            total += min(pairings) if out else 3 * len(into)
            mounted = step["setup"]
        self.assertEqual(len(mounted), 2)
        self.assertEqual(total, sheet.cost)
        del costs["a", "b"]
        with self.assertRaisesRegex(
            changeover.BadInput, "no cost of putting in 'b' where 'a' was taken out"
        ):
            changeover.plan(names, 2, test_cost=1, change_costs=costs)

    def test_what_cannot_be_meant_is_refused(self):
        for wrong, words in (
            ({"pairs": []}, "^pairs: no pair is listed"),
            ({"pairs": [("a", "a")]}, "pairs is pairs of two parts"),
            ({"pairs": [("a", "b", "c")]}, "pairs is pairs of two parts"),
            ({"mounted": ["z"]}, "^mounted: there is no part 'z'"),
            ({"strength": 4}, "^strength 4: give 2"),
            ({"strength": 3, "pairs": [("a", "b")]}, "^pairs applies to pairs"),
            ({"slots": {"CPU": 1}}, "slots and slot_of come together"),
            ({"slots": {"CPU": -1}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            ({"slots": {"CPU": 2**64}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            ({"slots": {"CPU": (1.5, None)}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            (
                {"slots": {"CPU": (2, 1)}, "slot_of": {"a": "CPU", "b": "CPU"}},
                "slot 'CPU' has at least 2 and at most 1",
            ),
            ({"mounted": itertools.repeat("a")}, "mounted names more parts than there are"),
            ({"done": [itertools.repeat("a")]}, "done names more parts than there are"),
            ({"mounted": ["x" * 10**5]}, "there is no part 'x{20,99}…'; "),
            ({"slots": {"CPU": "many"}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            ({"slots": {"CPU": b"12"}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            ({"slots": {"CPU": {0: 1, 1: 1}}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            ({"slots": {"CPU": {1, 2}}, "slot_of": {"a": "CPU"}}, "slots says how many"),
            ({"slots": {"CPU": 1}, "slot_of": {"a": "disk"}}, "disk"),
            ({"weights": [("a", "b")]}, "weights is a dict"),
            ({"first": [["a", "b", "c", "d"]]}, "^first.0.: 4 parts, but only 3 fit"),
            ({"never": [("a", "b")], "pairs": [("a", "b")]}, "a"),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(
                changeover.BadInput, words
            ) as caught:
                self.plan("a b c d".split(), 3, **wrong)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(changeover.BadInput, "parts is a number from 2 to 1000"):
            self.plan(itertools.count(), 3)
        for wrong in ({"mounted": ["\ud800"]}, {"budget": "\ud800"}):
            with self.subTest(wrong=wrong), self.assertRaises(UnicodeEncodeError):
                self.plan("a b c d".split(), 3, **wrong)

    def test_a_request_and_its_answer_are_documents(self):
        sheet = changeover.plan(
            {"a": 1, "b": "2.50", "c": 3},
            2,
            test_cost=1,
            done=[(["a", "b"], "FAILED - hang")],
            title="T",
        )
        asked = json.loads(sheet.request_json())
        self.assertEqual(
            asked["parts"],
            [{"name": "a", "cost": 1}, {"name": "b", "cost": "2.50"}, {"name": "c", "cost": 3}],
        )
        self.assertEqual(asked["done"], [{"parts": ["a", "b"], "result": "FAILED - hang"}])
        answer = json.loads(sheet.to_json())
        self.assertEqual(
            (answer["format"], answer["title"], answer["met_only_in_failed"]),
            ("changeover-plan/1", "T", 1),
        )
        self.assertTrue(sheet.to_xlsx().startswith(b"PK"))
        self.assertIn("| step |", sheet.to_markdown())
        self.assertIn("3 parts, 2 at a time", sheet.to_text())
        two = changeover.plan(5, 2, test_cost=1, change_cost=1, benches=2)
        self.assertEqual(json.loads(two.to_json())["format"], "changeover-benches/1")
        self.assertEqual(json.loads(two.request_json())["items"], 5)

    def test_numbers_are_parts_only_where_no_name_is_a_number(self):
        self.assertEqual(self.plan(list("abc"), 2, pairs=[(1, "b")]).pairs_needed, 1)
        with self.assertRaisesRegex(changeover.BadInput, "there is no part '1'"):
            self.plan(["101", "102", "103"], 2, pairs=[(1, 2)])
        with self.assertRaisesRegex(changeover.BadInput, "there is no part '1'"):
            self.plan(["101", "102", "103"], 2, mounted=[1])

    def test_options_are_those_of_the_command_line(self):
        sheet = self.plan(6, 3, done=[[1, 2, 3], [4, 5, 6]], done_first=1, steps=100, shuffle=3)
        self.assertEqual(sheet.pairs_needed, 12)
        self.assertTrue(any("shuffled with seed 3" in note for note in sheet.notes), sheet.notes)
        with self.assertRaisesRegex(changeover.BadInput, "^done_first is for done; give both"):
            self.plan(6, 3, done_first=1)
        with self.assertRaisesRegex(changeover.BadInput, "^shuffle has no meaning with benches"):
            self.plan(6, 3, shuffle=3, benches=2)

    def test_what_does_not_hold_what_is_meant_is_refused(self):
        pair = {"a", "b"}
        for name in ("pairs", "never", "first", "done", "mounted", "start"):
            for wrong in ("ab", b"ab", bytearray(b"ab"), {("a", "b"): 1}, 5):
                with self.subTest(name=name, wrong=wrong), self.assertRaisesRegex(
                    TypeError, f"^{name} has .*not .*$"
                ):
                    self.plan("a b c d".split(), 3, **{name: wrong})
        for name in ("pairs", "never", "first", "done"):
            for wrong in ("ab", b"ab", {"a": 1, "b": 2}):
                if name in ("done", "first") and isinstance(wrong, dict):
                    continue  # a test with its result or bench, or a BadInput
                with self.subTest(name=name, wrong=[wrong]), self.assertRaisesRegex(
                    TypeError, f"^{name} has .*not .*$"
                ):
                    self.plan("a b c d".split(), 3, **{name: [wrong]})
        for wrong in ("abcd", b"abcd", {"a", "b", "c"}, 5.5):
            with self.subTest(parts=wrong), self.assertRaisesRegex(TypeError, "^parts has names"):
                self.plan(wrong, 3)
        with self.assertRaisesRegex(
            TypeError, "^first has set-ups in an order, and a set has none"
        ):
            self.plan("a b c d".split(), 3, first={("a", "b", "c")})
        # A pair and a set-up have no order, and neither have pairs.
        self.assertEqual(
            self.plan("a b c".split(), 2, never=[pair]).cost,
            self.plan("a b c".split(), 2, never={("b", "a")}).cost,
        )
        self.assertEqual(
            len(self.plan((name for name in "abc"), 2, pairs=(pair for _ in range(2))).steps), 1
        )

    def test_what_is_no_name_is_refused(self):
        for wrong in (
            ("x", 5),
            ["x"],
            {"name": "x"},
            None,
            b"x",
            bytearray(b"x"),
            float("nan"),
            Decimal("nan"),
            range(2),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(
                TypeError, r"^parts has names, texts or numbers, not .*$"
            ):
                self.plan(["a", wrong, "b"], 2)
        for wrong in (memoryview(b"abc"), collections.UserString("abc")):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(TypeError, "^parts has names"):
                self.plan(wrong, 2)
        self.assertEqual(self.plan([1, 2.5, Decimal("3"), "x"], 2).tests, 6)

    def test_numbers_and_results_of_numpy_are_what_they_say(self):
        try:
            import numpy
        except ImportError:
            self.skipTest("NumPy is not installed")
        self.assertEqual(self.plan(numpy.int64(5), 2).tests, self.plan(5, 2).tests)
        with self.assertRaisesRegex(TypeError, "^parts has names, texts or numbers"):
            self.plan(numpy.array([["a", "b"], ["c", "d"]]), 2)
        setup = ["a", "b"]
        for result, same in (
            (numpy.bool_(True), True),
            (numpy.bool_(False), False),
            (float("nan"), None),
        ):
            plain = self.plan(list("abc"), 2, done=[(setup, same)])
            with self.subTest(result=result):
                self.assertEqual(
                    self.plan(list("abc"), 2, done=[(numpy.array(setup), result)]).steps,
                    plain.steps,
                )
                self.assertEqual(
                    self.plan(list("abc"), 2, done=[(frozenset(setup), result)]).cost, plain.cost
                )

    def test_a_test_without_a_result_was_not_run_where_another_has_one(self):
        passed = (["a", "b"], True)
        for rest, needed in (
            (["b", "c"], 1),
            ((["b", "c"], None), 2),
            ({"parts": ["b", "c"], "result": None}, 2),
            ({"parts": ["b", "c"]}, 1),
        ):
            with self.subTest(rest=rest):
                self.assertEqual(
                    self.plan(list("abc"), 2, done=[passed, rest]).pairs_needed, needed
                )

    def test_nothing_of_a_table_is_dropped(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        frame = pandas.DataFrame
        plan = lambda parts, **more: self.plan(parts, 2, **more)
        columns = {"name": ["nan", "b", "c", "d"], "cost": [1, 2, 3, 4]}
        # Rows that were left out leave gaps in the index, and a part may be called "nan".
        self.assertEqual(
            plan(frame(columns)[lambda each: each.cost != 2]).cost,
            plan({"nan": 1, "c": 3, "d": 4}).cost,
        )
        for wrong, said in (
            (frame({"name": ["a", None, "c"]}), "parts: a row without a name; name the part"),
            (
                frame({"name": ["a", "b"], "weight": [5, 6]}),
                " is not read; leave it out, or have one column each called name",
            ),
            (frame({**columns, "colour": "red"}), "the column 'colour' is not read"),
            (frame({**columns, "part": "x"}), "the column 'part' is not read"),
            (frame(columns, index=list("pqrs")), "the column 'index' is not read"),
            (
                frame(columns, index=pandas.Index(range(4, 8), name="id")),
                "the column 'id' is not read",
            ),
            (frame({"cost": [1, 2]}), "no column has the names"),
            (frame([["a", 1, 2], ["b", 3, 4]]), "is not read"),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(changeover.BadInput, said):
                plan(wrong)
        for wrong in (
            pandas.Series(["a", "b"]),
            pandas.Series([5, 6]),
            pandas.Series(["a", "b"], index=[3, 5]),
        ):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(
                TypeError, "^parts is a Series with numbers as its index; give list"
            ):
                plan(wrong)
        self.assertEqual(plan(list(pandas.Series(["a", "b"]))).tests, 1)
        # Within a list a table would be the names of its columns; an index says something.
        table = frame({"a": [1], "b": [2]})
        for name in ("pairs", "never", "first", "done"):
            with self.subTest(name=name), self.assertRaisesRegex(
                TypeError, f"^{name} has parts, not a DataFrame"
            ):
                plan(list("abcd"), **{name: [table]})
            with self.subTest(name=name), self.assertRaisesRegex(
                TypeError, f"^{name}" ": the index of the DataFrame would be lost; give reset_index"
            ):
                plan(list("abcd"), **{name: frame({"x": ["b"], "y": ["c"]}, index=["a"])})
        with self.assertRaisesRegex(TypeError, "^start has parts, not a DataFrame"):
            plan(list("abcd"), start=table)
        with self.assertRaisesRegex(TypeError, "^blocks has lists of elements, not a DataFrame"):
            changeover.Design([table, table])
        with self.assertRaises(TypeError) as told:
            changeover.design(7, 3).blocks[table]
        self.assertNotIn("\n", str(told.exception))

    def test_columns_are_read_as_a_file_of_them_would_be(self):
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        names, costs, slots = (
            ["lens a", "b,c", 'd"e', "f"],
            ["1", "2.50", "3", "4"],
            ["x", "x", "y", ""],
        )
        plan = lambda parts, **more: changeover.plan(parts, 2, test_cost=10, **more).to_csv()
        wanted = plan(dict(zip(names, costs)))
        frame = pandas.DataFrame({"part": names, "cost": [1, 2.5, 3, 4]})
        self.assertEqual(plan(frame), wanted)
        self.assertEqual(plan(frame.set_index("part")), wanted)
        self.assertEqual(plan(frame.set_index("part").rename_axis(None)), wanted)
        self.assertEqual(plan(frame.set_index("part")["cost"]), wanted)
        self.assertEqual(plan(frame[["cost", "part"]]), wanted)
        self.assertEqual(plan(frame[["part"]], change_cost=3), plan(names, change_cost=3))
        gaps = pandas.DataFrame({"part": names, "cost": [1, None, 3, 4]})
        self.assertEqual(plan(gaps, change_cost="2.5"), wanted)
        with self.assertRaisesRegex(changeover.BadInput, "give change_cost"):
            plan(gaps)
        in_slots = frame.assign(slot=slots)
        room = {"x": 1, "y": (0, 1)}
        by_dicts = plan(dict(zip(names, costs)), slots=room, slot_of=dict(zip(names, slots[:3])))
        self.assertEqual(plan(in_slots, slots=room), by_dicts)
        for more, words in (
            (
                {},
                "parts has a column slot; give slots, how many parts each has, or leave the column out",
            ),
            (
                {"slots": room, "slot_of": {"f": "x"}},
                "parts has a column slot, and slot_of says the same; give one of them",
            ),
        ):
            with self.subTest(more=more), self.assertRaisesRegex(changeover.BadInput, words):
                plan(in_slots, **more)
        with self.assertRaisesRegex(changeover.BadInput, "same name|twice"):
            plan(pandas.Series([1, 2, 3], index=["a", "b", "a"]))
        pairs = pandas.DataFrame({"first": ["f"], "second": ["b,c"]})
        self.assertEqual(plan(frame, never=pairs), plan(frame, never=[("f", "b,c")]))
        edges = pandas.DataFrame({"i": [0, 1, 2], "j": [1, 2, 3]})
        self.assertEqual(
            changeover.load_order(4, 2, pairs=edges).loads,
            changeover.load_order(4, 2, pairs=edges.to_numpy()).loads,
        )
        blocks = pandas.DataFrame([[0, 1, 2], [0, 1, 3]])
        self.assertEqual(
            changeover.Design(blocks, change=1), changeover.Design([[0, 1, 2], [0, 1, 3]], change=1)
        )

    def test_a_dict_that_changes_while_it_is_read_is_read_as_it_was(self):
        class Part:
            costs = {}

            def __str__(self):
                self.costs.clear()
                return str(id(self))

        Part.costs = {Part(): cost for cost in range(1, 6)}
        sheet = self.plan(Part.costs, 5, change_cost=None)
        self.assertEqual((sheet.tests, sheet.cost), (1, 2 + 15))


class Benches(unittest.TestCase):
    def test_all_benches_together_do_the_job(self):
        for benches, objective in itertools.product((1, 2, 3), ("makespan", "cost")):
            both = changeover.plan(
                list("abcdefghi"),
                3,
                test_cost="1.5",
                change_cost=2,
                benches=benches,
                objective=objective,
            )
            self.assertEqual(len(both), benches)
            met = set()
            costs = []
            for steps in both.sheets:
                here, cost = set(), Decimal(0)
                for step in steps:
                    cost += Decimal("1.5") + 2 * len(set(step["setup"]) - here)
                    here = set(step["setup"])
                    self.assertLessEqual(len(here), 3)
                    met |= pairs_of(here)
                costs.append(cost)
            self.assertEqual(len(met), 36)
            self.assertTrue(both.complete)
            self.assertEqual((both.cost, both.makespan), (sum(costs), max(costs)))
            self.assertEqual(both.tests, sum(len(steps) for steps in both.sheets))
            self.assertGreaterEqual(both.cost, both.lower_bound)
            self.assertGreaterEqual(both.makespan, both.makespan_bound)
            self.assertFalse(both.interrupted)

    def test_wrong_ones_are_refused(self):
        for wrong in (
            {"benches": 0},
            {"benches": 65},
            {"benches": 2, "objective": "time"},
            {"benches": 2, "compact": True},
            {"benches": []},
            {"benches": [{"colour": 1}]},
            {"benches": [{"hours": 25}]},
            {"benches": ["A", "A"]},
            {"benches": [{"start": ["x"]}]},
            {"benches": 2, "first_day": "2025-03-31"},
            {"hours": 8},
            {"without": ["x"]},
            {"benches": 2, "weights": {(1, 2): 3}},
            {"objective": "cost"},
            {"quantities": {"x": 1}, "benches": 2},
        ):
            with self.assertRaises(changeover.BadInput, msg=wrong):
                changeover.plan(9, 3, test_cost=1, change_cost=1, **wrong)
        with self.assertRaises(TypeError):
            changeover.plan(9, 3, test_cost=1, change_cost=1, benches="two")

    def test_benches_as_they_are(self):
        def lab(**more):
            return changeover.plan(
                ["H100", "A40", "Epyc", "Xeon", "NVMe"],
                3,
                test_cost=1,
                change_cost="0.5",
                steps=3000,
                quantities={"H100": 1},
                first_day="2025-03-07",
                benches=[
                    {"name": "North", "hours": 8, "start": ["H100"]},
                    {"name": "South", "hours": 6, "without": ["A40"]},
                ],
                **more,
            )

        both = lab()
        self.assertEqual(both.benches, ["North", "South"])
        self.assertEqual(both.finish["date"], max(sheet[-1]["date"] for sheet in both.sheets))
        self.assertTrue(both.complete)
        self.assertNotIn("A40", {part for step in both.sheets[1] for part in step["setup"]})
        held = [
            [(step["begin"], step["end"]) for step in sheet if "H100" in step["setup"]]
            for sheet in both.sheets
        ]
        for one, other in itertools.product(*held):
            self.assertTrue(one[1] <= other[0] or other[1] <= one[0])
        done = [{"parts": both.sheets[0][0]["setup"], "bench": "North", "result": True}]
        rest = lab(done=done, without=["Xeon"])
        self.assertEqual(rest.sheets[0][0]["number"], 2)
        self.assertNotIn(
            "Xeon", {part for sheet in rest.sheets for step in sheet for part in step["setup"]}
        )
        self.assertIn("without: left out from now on: Xeon", rest.notes)
        asked = json.loads(rest.request_json())
        self.assertEqual(asked["benches"][0], {"name": "North", "start": ["H100"], "hours": "8"})
        self.assertEqual(asked["done"], [{**done[0], "result": "pass"}])


class Ratios(unittest.TestCase):
    def test_ranges_have_no_gaps_and_break_even_where_they_meet(self):
        sheet = changeover.plan(11, 4, test_cost=3, change_cost=1)
        answer = sheet.what_if()
        ranges = answer["ranges"]
        self.assertEqual(answer["asked"], Fraction(1, 3))
        self.assertGreater(len(ranges), 1)
        self.assertIsNone(ranges[0]["from"])
        self.assertIsNone(ranges[-1]["to"])
        for one, next_one in zip(ranges, ranges[1:]):
            self.assertEqual(one["to"], next_one["from"])
            at = [each["tests"] + one["to"] * each["changes"] for each in (one, next_one)]
            self.assertEqual(at[0], at[1])
        for each in ranges:
            setups = [set(setup) for setup in each["setups"]]
            self.assertEqual(len(set().union(*map(pairs_of, setups))), 55)
            self.assertEqual(each["tests"], len(setups))
            self.assertEqual(
                each["changes"], sum(len(b - a) for a, b in zip([set(), *setups], setups))
            )

    def test_it_has_limits_and_hands_out_progress(self):
        sheet = changeover.plan(30, 6, test_cost=3, change_cost=1)
        self.assertTrue(sheet.what_if(time=0.05)["ranges"])
        said = []
        sheet.what_if(time=0.5, progress=said.append)
        self.assertTrue(all("phase" in each for each in said))
        costs = {(x, y): 1 for x in "abcd" for y in "abcd" if x != y}
        sheet = changeover.plan(list("abcd"), 2, test_cost=1, change_cost=1, change_costs=costs)
        self.assertTrue(sheet.what_if()["ranges"])


class Diagnoses(unittest.TestCase):
    def test_asking_again_and_again_leads_to_what_is_wrong(self):
        names = list("abcdefgh")
        sheet = changeover.plan(names, 3, test_cost=1, change_cost=1)
        faults = [(x,) for x in names] + list(itertools.combinations(names, 2))
        for fault in faults:
            def passes(setup):
                return not set(fault) <= set(setup)
            found = sheet.diagnose([passes(step["setup"]) for step in sheet.steps])
            self.assertIn(fault, found["suspects"])
            self.assertEqual(found["passed"] + found["failed"], sheet.tests)
            results = [passes(step["setup"]) for step in sheet.steps]
            while found["next"]:
                then = found["next"]
                after = then["if_it_passes" if passes(then["setup"]) else "if_it_fails"]
                self.assertTrue(then["proves"] or (fault,) in after["explanations"])
                self.assertEqual(
                    [part for _, part in sorted(then["places"].items()) if part],
                    list(filter(None, then["places"].values())),
                )
                self.assertEqual(set(filter(None, then["places"].values())), set(then["setup"]))
                results.append((then["setup"], passes(then["setup"])))
                self.assertLess(len(results), 40)
                found = sheet.diagnose(results)
            self.assertEqual(found["suspects"], [fault])
            self.assertEqual(found["faults"], [fault])

    def test_results_of_other_setups_count_and_wrong_ones_are_refused(self):
        sheet = changeover.plan(list("abcdef"), 3, test_cost=1, change_cost=1)
        found = sheet.diagnose([(["a", "b"], False), (["a"], True), (("a", "b", "c"), True)])
        self.assertEqual(found["contradictions"], [(["a", "b"], ["a", "b", "c"])])
        self.assertEqual(sheet.diagnose([])["suspects"], [])
        self.assertEqual(sheet.diagnose([None, None, True])["passed"], 1)
        for wrong in (
            [1],
            [b"pass"],
            [([], False)],
            [("abcd", False)],
            [(list("abcd"), False)],
            [True] * 99,
            [(["a"], 1)],
            [(["a"],)],
            [(["z"], True)],
            [("ab", True)],
            "ab",
            [(["a", "a"], True)],
        ):
            with self.assertRaises((changeover.BadInput, TypeError), msg=wrong):
                sheet.diagnose(wrong)
        with self.assertRaises(TypeError):
            sheet.diagnose(7)

    def test_texts_are_read_and_what_is_not_understood_is_named(self):
        sheet = changeover.plan(9, 3, test_cost=1, change_cost=5)
        found = sheet.diagnose(
            ["passed", None, "FAILED - hang", "hot", "skipped", (["1", "2"], "n.i.O.")]
        )
        self.assertEqual((found["passed"], found["failed"]), (1, 2))
        self.assertEqual(found["unread"], [(3, "hot")])
        self.assertEqual(sheet.diagnose([True])["unread"], [])

    def test_what_met_only_in_failed_tests_is_needed_again(self):
        def planned(*done, **more):
            return changeover.plan(4, 3, test_cost=1, change_cost=1, done=done, **more)

        for failed in (False, "FAILED - hang", "hot"):
            for test in (
                ([1, 2, 3], failed),
                ((1, 2, 3), failed),
                {"parts": [1, 2, 3], "result": failed},
            ):
                sheet = planned([1, 4], test)
                self.assertEqual((sheet.pairs_needed, sheet.met_only_in_failed), (5, 3))
                trusting = planned([1, 4], test, trust_failed=True)
                self.assertEqual((trusting.pairs_needed, trusting.met_only_in_failed), (2, 3))
        for passed in (True, None, "ok", "done"):
            self.assertEqual(planned(([1, 2, 3], passed)).pairs_needed, 3)
        self.assertEqual(planned(([1, 2, 3], "blocked")).pairs_needed, 6)
        self.assertEqual(planned((1, 2), (3, 4)).pairs_needed, 4)
        for wrong in (
            ([1, 2], 3),
            {"parts": [1, 2], "results": True},
            {"result": True},
            {"parts": [1, 2], "result": 7},
        ):
            with self.assertRaises(changeover.BadInput, msg=wrong):
                planned(wrong)

    def test_the_first_test_comes_after_the_last_that_was_made(self):
        for more in ({}, {"start": ["1", "2", "3"]}, {"done": [["1", "2", "3"]]}):
            sheet = changeover.plan(9, 3, test_cost=1, change_cost=5, **more)
            first = sheet.diagnose([True, True, False])["next"]
            there = set(sheet.steps[2]["setup"])
            self.assertEqual(set(first["take_out"]), there - set(first["setup"]))
            self.assertEqual(set(first["put_in"]), set(first["setup"]) - there)
            self.assertEqual(first["cost"], 1 + 5 * len(first["put_in"]))

    def test_two_faults_are_said_once(self):
        sheet = changeover.plan(5, 3, test_cost=1, change_cost=1)
        found = sheet.diagnose([False, False, False, True])
        two = found["explanations"]
        self.assertEqual(found["at_least"], 2)
        self.assertGreater(len(two), 0)
        self.assertEqual(len({frozenset(both) for both in two}), found["explanations_known"])
        self.assertTrue(all(len(both) == 2 for both in two))

    def test_parts_keep_their_places_from_sheet_to_sheet(self):
        sheet = changeover.plan(list("abcdefgh"), 3, test_cost=1, change_cost=1)
        for before, step in zip(sheet.steps, sheet.steps[1:]):
            for part in set(before["setup"]) & set(step["setup"]):
                self.assertEqual(before["places"].index(part), step["places"].index(part))
        done = [(step["places"], True) for step in sheet.steps[:2]]
        rest = changeover.plan(list("abcdefgh"), 3, test_cost=1, change_cost=1, done=done)
        last = sheet.steps[1]["places"]
        for part in set(last) & set(rest.steps[0]["setup"]):
            self.assertEqual(last.index(part), rest.steps[0]["places"].index(part))
        gap = changeover.plan(
            list("abcd"),
            3,
            test_cost=1,
            change_cost=1,
            mounted=["b"],
            done=[(["a", None, "b"], True)],
        )
        self.assertEqual(gap.steps[0]["places"][2], "b")
        self.assertEqual([each["number"] for each in gap.places], [1, 2, 3])

    def test_a_file_or_a_workbook_is_read_as_the_command_line_reads_it(self):
        with tempfile.TemporaryDirectory() as folder:
            parts = pathlib.Path(folder) / "parts.csv"
            parts.write_text("Component,Price,Swap time (min)\nA,100,5\nB,200,4\nC,90,2\nD,80,1\n")
            sheet = changeover.plan(parts, 2, test_cost=10)
            self.assertIn(
                "change costs in 'Swap time (min)'; not used: 'Price'", "".join(sheet.notes)
            )
            dear = changeover.plan(parts, 2, test_cost=10, cost_column="price")
            self.assertGreater(dear.cost, sheet.cost)
            run = pathlib.Path(folder) / "run.xlsx"
            run.write_bytes(sheet.to_xlsx())
            again = changeover.plan(run)
            self.assertEqual((again.steps, again.cost), (sheet.steps, sheet.cost))
            self.assertEqual(changeover.plan(run, test_cost=20).cost, sheet.cost + 10 * sheet.tests)
            with self.assertRaises(changeover.BadInput):
                changeover.plan(parts, 2, test_cost=1, slot_of={"A": "x"})
            with self.assertRaises(changeover.MissingResource):
                changeover.plan(pathlib.Path(folder) / "none.csv", 2, test_cost=1)
        with self.assertRaises(changeover.BadInput):
            changeover.plan(3, 2, test_cost=1, change_cost=1, never=[("1", "2", "why", "how")])
        with self.assertRaises(changeover.BadInput):
            changeover.plan(["A", "B"])

    def test_triples_have_neither_ratios_nor_diagnoses(self):
        sheet = changeover.plan(7, 4, strength=3, test_cost=1, change_cost=1)
        self.assertEqual((sheet.triples_tested, sheet.triples_needed), (35, 35))
        for call in (sheet.what_if, lambda: sheet.diagnose([False])):
            with self.assertRaisesRegex(changeover.BadInput, "triples"):
                call()


class Signals(unittest.TestCase):
    """Ctrl-C ends each call, also where Python runs no code of its own."""

    def interrupt(self, call, after=0.3):
        before = signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, after)
        try:
            with self.assertRaises(KeyboardInterrupt):
                call()
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def test_they_end_what_has_no_end(self):
        costs = {"test_cost": 1, "change_cost": 1}
        self.interrupt(lambda: changeover.plan(4, 3, pairs=itertools.repeat((1, 2)), **costs))
        self.interrupt(lambda: changeover.plan(4, 3, done=itertools.repeat((1, 2)), **costs))
        self.interrupt(lambda: changeover.load_order(None, 3, pairs=itertools.repeat((0, 1))))
        self.interrupt(lambda: changeover.verify(itertools.repeat([1, 2, 3])))
        self.interrupt(lambda: changeover.verify([itertools.repeat(1)]))
        sheet = changeover.plan(4, 3, **costs)
        self.interrupt(lambda: sheet.diagnose(itertools.repeat(([1, 2], True))))

    def test_they_end_a_diagnosis_and_what_was_found_of_ratios_is_kept(self):
        # A test of five hundred parts failed. What to test next is chosen for 124,750 suspects,
        # which takes ten times as long as the signal waits.
        sheet = changeover.plan(1000, 500, test_cost=1, change_cost=1, time=0)
        self.interrupt(lambda: sheet.diagnose([False]), after=0.1)
        before = signal.signal(signal.SIGALRM, signal.default_int_handler)
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        try:
            self.assertTrue(
                changeover.plan(60, 9, test_cost=1, change_cost=1, time=0).what_if(time=60)[
                    "interrupted"
                ]
            )
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)

    def test_they_end_what_takes_long_before_a_search(self):
        # Ten of A are wanted, but they are nine kinds of which no two parts can be together: for
        # each two others many choices fail.
        slot_of = {str(i): "A" for i in range(63)}
        never = [(str(i), str(j)) for i in range(63) for j in range(i) if i % 9 == j % 9]
        never += [(str(i), str(i + 1)) for i in range(63, 899)]  # each part is a case of its own
        job = {
            "test_cost": 1,
            "change_cost": 1,
            "slots": {"A": 10},
            "slot_of": slot_of,
            "never": never,
        }
        self.interrupt(lambda: changeover.plan([str(i) for i in range(900)], 20, **job))
        self.interrupt(lambda: changeover.load_order(10**6, 3, against=9 * 10**6))
        larger = changeover.design(3001, 20, kind="circular")
        self.interrupt(lambda: larger.expand())


class Larger(unittest.TestCase):
    def test_designs_grow_as_they_are_told(self):
        design = changeover.design(15, 5, kind="circular")
        self.assertEqual((design.expand().v, design.expand().b), (21, 30))
        for w in range(1, 7):
            larger = design.expand(new_elements=w)
            self.assertEqual(larger.v, 15 + w)
            self.assertTrue(larger.verdict.valid)
        self.assertEqual(design.expand(set=2).v, 21)
        with self.assertRaisesRegex(changeover.MissingResource, "expansion sets"):
            design.expand(set=10**6)
        with self.assertRaisesRegex(changeover.BadInput, "not both"):
            design.expand(set=1, new_elements=2)
        with self.assertRaisesRegex(changeover.BadInput, "'circle' or 'doubled'"):
            design.expand(factorization="square")

    def test_what_is_no_design_does_not_grow(self):
        with self.assertRaisesRegex(changeover.BadInput, "no valid"):
            changeover.Design([[0, 1, 2], [1, 2, 3]]).expand()


if __name__ == "__main__":
    unittest.main()
