"""Jobs with all that they may be told: run sheets with slots, pairs, budgets, larger designs."""

import collections
import itertools
import json
import unittest
from decimal import Decimal

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
            for room in (1, One(), (1, One()), iter([1, 1]))
        ]
        self.assertEqual(plans, plans[:1] * 4)

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
            ({"pairs": [("a", "a")]}, "pairs has a pair that is not two different parts"),
            ({"pairs": [("a", "b", "c")]}, "pairs has a pair that is not two different parts"),
            ({"mounted": ["z"]}, "^mounted: there is no part 'z'"),
            ({"strength": 4}, "^strength 4: give 2"),
            ({"strength": 3, "pairs": [("a", "b")]}, "^pairs needs strength 2"),
            ({"slots": {"CPU": 1}}, "belong together; give both"),
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
                TypeError if words.endswith("is a dict") else changeover.BadInput, words
            ) as caught:
                self.plan("a b c d".split(), 3, **wrong)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(changeover.BadInput, "more than 1000 parts"):
            self.plan(itertools.count(), 3)
        for wrong in ({"mounted": ["\ud800"]}, {"budget": "\ud800"}):
            with self.subTest(wrong=wrong), self.assertRaisesRegex(
                changeover.BadInput, r"^'\\ud800' cannot be written as UTF-8"
            ):
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
                    TypeError, f"^{name} must be a list of .*not .*$"
                ):
                    self.plan("a b c d".split(), 3, **{name: wrong})
        for name in ("pairs", "never", "first", "done"):
            for wrong in ("ab", b"ab", {"a": 1, "b": 2}):
                if name in ("done", "first") and isinstance(wrong, dict):
                    continue  # a test with its result or bench, or a BadInput
                with self.subTest(name=name, wrong=[wrong]), self.assertRaisesRegex(
                    TypeError, f"^{name} must be a list of .*not .*$"
                ):
                    self.plan("a b c d".split(), 3, **{name: [wrong]})
        for wrong in ("abcd", b"abcd", {"a", "b", "c"}, 5.5):
            with self.subTest(parts=wrong), self.assertRaisesRegex(
                TypeError, "^parts must be a list of names"
            ):
                self.plan(wrong, 3)
        with self.assertRaisesRegex(
            TypeError, "^first must be a list of set-ups in an order, and a set has none"
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
            with self.subTest(wrong=wrong), self.assertRaisesRegex(
                TypeError, "^parts must be a list of names"
            ):
                self.plan(wrong, 2)
        self.assertEqual(self.plan([1, 2.5, Decimal("3"), "x"], 2).tests, 6)

    def test_true_is_no_number(self):
        with self.assertRaisesRegex(TypeError, "^parts must be a list of names, or their number"):
            self.plan(True, 2)
        with self.assertRaisesRegex(TypeError, "^benches must be a list of names or dicts"):
            self.plan(4, 2, benches=True)
        with self.assertRaisesRegex(TypeError, r"^plan\(\): at_once is a whole number"):
            self.plan(4, True)
        with self.assertRaisesRegex(changeover.BadInput, "^slots says how many parts are in 'CPU'"):
            self.plan(["a", "b"], 2, slots={"CPU": True}, slot_of={"a": "CPU"})

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
                TypeError, f"^{name} must be a list of parts, not a DataFrame"
            ):
                plan(list("abcd"), **{name: [table]})
            with self.subTest(name=name), self.assertRaisesRegex(
                TypeError, f"^{name}" ": the index of the DataFrame would be lost; give reset_index"
            ):
                plan(list("abcd"), **{name: frame({"x": ["b"], "y": ["c"]}, index=["a"])})
        with self.assertRaisesRegex(TypeError, "^start must be a list of parts, not a DataFrame"):
            plan(list("abcd"), start=table)
        with self.assertRaisesRegex(
            TypeError, "^block 1 must be a list of elements, not a DataFrame"
        ):
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
        with self.assertRaisesRegex(changeover.BadInput, "a second part is called|twice"):
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
        with self.assertRaisesRegex(changeover.BadInput, "not a valid"):
            changeover.Design([[0, 1, 2], [1, 2, 3]]).expand()


if __name__ == "__main__":
    unittest.main()
