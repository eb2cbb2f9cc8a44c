"""What is asked of a job beside its sheet: ranges of ratios, what failed tests say, Ctrl-C."""

import itertools
import json
import pathlib
import pickle
import signal
import tempfile
import unittest
from fractions import Fraction

import changeover


def pairs_of(setup):
    return {frozenset(pair) for pair in itertools.combinations(setup, 2)}


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

    def test_answers_are_documents(self):
        sheet = changeover.plan(7, 3, test_cost=3, change_cost=1)
        document = json.loads(sheet.what_if().to_json())
        self.assertEqual(document["format"], "changeover-what-if/1")
        self.assertEqual([Fraction(each["to_exact"]) for each in document["ranges"][:-1]],
                         [each["to"] for each in sheet.what_if()["ranges"][:-1]])
        found = sheet.diagnose([False])
        self.assertEqual(json.loads(found.to_json())["format"], "changeover-diagnosis/1")
        again = pickle.loads(pickle.dumps(found))
        self.assertEqual((again, again.to_json()), (found, found.to_json()))

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
            costly = changeover.plan(parts, 2, test_cost=10, cost_column="price")
            self.assertGreater(costly.cost, sheet.cost)
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
    """Ctrl-C ends each call, also where no Python code runs."""

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
        never += [(str(i), str(i + 1)) for i in range(63, 899)]  # each part is a separate case
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


if __name__ == "__main__":
    unittest.main()
