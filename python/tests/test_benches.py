"""Run sheets for several benches."""

import itertools
import json
import unittest
from decimal import Decimal

import changeover


def pairs_of(setup):
    return {frozenset(pair) for pair in itertools.combinations(setup, 2)}


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
            self.assertIn(both.why_stopped, ("found", "step limit"))

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
        self.assertIn(both.finish, [sheet[-1]["finish"] for sheet in both.sheets])
        # A test of ten hours on a day of eight ends on the next one.
        long = changeover.plan(3, 2, test_cost=600, change_cost=0, cost_unit="minutes",
                               benches=[{"hours": 8}])
        self.assertEqual(long.sheets[0][0]["finish"], {"day": 2, "hour": 120})
        self.assertEqual([step["day"] for step in long.sheets[0]], [1, 3, 5])
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


if __name__ == "__main__":
    unittest.main()
