"""Engines of clusters, without one: searches in shares, Ray's actors, what is found and kept."""

import collections
import itertools
import os
import subprocess
import sys
import tempfile
import types
import unittest
from unittest import mock

import changeover
from changeover import cluster
from changeover.cluster import _bag, _dask, _exact, _team


class Bags(unittest.TestCase):
    """Searches in shares, on an engine that does each part at once."""

    class Engine:
        def __init__(self, function, workers, dies=()):
            self.caller, self.names, self.dies = _bag.Caller(function), workers, set(dies)
            self.done, self.number = {}, 0

        def workers(self):
            return list(self.names)

        def submit(self, worker, part):
            self.number += 1
            if self.number in self.dies:
                self.names.remove(worker)
                self.names.append(worker + "'")
                self.events = [("lost", worker), ("joined", worker + "'")]
            else:
                self.done[part.number] = self.caller.run(part)
                self.events = [("done", worker)]
            self.queue = getattr(self, "queue", [])
            self.queue += [_team_event(kind, each, part.number) for kind, each in self.events]

        def wait(self, _seconds):
            events, self.queue = getattr(self, "queue", []), []
            return events

        def outcome(self, number):
            return self.done.pop(number)

    def test_shares_that_take_too_long_are_divided(self):
        everything = set(range(1000))

        def part(over, threads, cell, b, reversal, keep, share, seconds):
            mine = {each for each in everything if each % share[1] == share[0]}
            complete = seconds is None or len(mine) < 5
            found.update(mine if complete else ())
            return {"complete": complete, "standard_forms": len(mine), "classes": len(mine),
                    "tight": 0, "group_orders": {1: len(mine)}, "prefixes": 1000, "designs": []}

        found = collections.Counter()
        tree = _exact.Tree((9, 4, 2, "linear", 2), 6, False, 0, 1.0, 1e18)
        bag = tree.begin()
        bag.run(self.Engine(part, ["a", "b", "c"], dies=(3, 10, 11, 40)), lambda _: None)
        self.assertEqual(found, collections.Counter(dict.fromkeys(everything, 1)))
        answer = tree.finish(bag)
        self.assertTrue(answer["complete"])
        self.assertEqual((answer["classes"], bag.lost, bag.retried), (1000, 4, 4))

    def test_a_part_that_kills_its_workers_ends_the_run(self):
        bag = _bag.Bag(lambda *_: None)
        bag.put({})
        engine = self.Engine(lambda over, threads: 1, ["a"], dies=range(1, 10))
        with self.assertRaisesRegex(
            changeover.MissingResource,
            " workers were lost, one after the other, while they had the same part",
        ):
            bag.run(engine, lambda _: None)

    def test_without_workers_a_run_ends(self):
        bag = _bag.Bag(lambda *_: None)
        with self.assertRaisesRegex(
            changeover.MissingResource, "there are no workers; start some, and wait for them"
        ):
            bag.run(self.Engine(lambda over, threads: 1, []), lambda _: None)
        bag.put({})
        engine = self.Engine(lambda over, threads: 1, ["a"], dies=[1])
        engine.wait = lambda _: [_team_event("lost", "a", 1)] if engine.names else []
        with mock.patch.object(_bag, "_without_workers", -1.0), self.assertRaisesRegex(
            changeover.MissingResource, "all workers were lost, and none came for"
        ):
            bag.run(engine, lambda _: None)

    def test_a_client_of_dask_that_cannot_be_used_is_named(self):
        class Client:
            asynchronous = False
            status = "closed"

        client = Client()
        with self.assertRaisesRegex(
            changeover.BadInput, "client is closed; give one that is connected"
        ):
            _dask.DaskEngine(client, None)
        client.asynchronous = True
        with self.assertRaisesRegex(
            TypeError, "client is asynchronous; give one that is not: Client"
        ):
            _dask.DaskEngine(client, None)

    def test_cubes_that_leave_something_out_are_noticed(self):
        walk = _exact.Walk((9, 4, 1, "linear", 2), 1.0, 1e18, 2, None)
        walk._lower, walk._bag = 11, _bag.Bag(walk._take)
        walk._best = None
        walk._ask()
        none = {"outcome": "none", "proof_bytes": 1}
        asked = {"b": 11}
        walk._take({**asked, "share": (0, 2)}, {**none, "excluded": [[1]]})
        with self.assertRaisesRegex(changeover.InternalError, "leave something out"):
            walk._take({**asked, "share": (1, 2)}, {**none, "excluded": [[-1, 2]]})

    def test_what_is_no_design_is_refused(self):
        design = changeover.design(9, 4, 1, "linear")
        cell = (9, 4, 1, "linear", 2)
        self.assertIs(_exact.received(design, cell, design.b), design)
        wrong = changeover.Design([[0, 1, 2, 3], [1, 2, 3, 4]], v=9, change=1, kind="linear")
        for each, b in ((design, design.b - 1), (wrong, 2)):
            with self.assertRaises(changeover.InternalError):
                _exact.received(each, cell, b)


class RayStandIn(types.ModuleType):
    """What the engine uses of Ray, as Ray's manual describes it: actors, calls that are waited for,
    and actors that die. The real one is used where it is installed (docs/cluster.md)."""

    class exceptions:
        class RayError(Exception):
            pass

        class RayActorError(RayError):
            pass

    class Actor:
        def __init__(self, ray, made):
            self.ray, self.made, self.alive = ray, made, True
            self.run = types.SimpleNamespace(remote=self.call)

        def call(self, part):
            self.ray.calls += 1
            if self.ray.calls in self.ray.deaths:
                self.alive = False
            ref = object()
            self.ray.results[ref] = self.made.run(part) if self.alive else None
            return ref

    def __init__(self, deaths=()):
        super().__init__("ray")
        import pickle
        self.cloudpickle, self.results, self.calls, self.deaths = pickle, {}, 0, set(deaths)
        self.killed = 0

    def is_initialized(self):
        return True

    def cluster_resources(self):
        return {"CPU": 4.0}

    def put(self, value):
        return value

    def remote(self, **_):
        return lambda kind: types.SimpleNamespace(
            remote=lambda *given: self.Actor(self, kind(*given)))

    def wait(self, refs, num_returns, timeout):
        return refs[:num_returns], refs[num_returns:]

    def get(self, ref):
        result = self.results.pop(ref)
        if result is None:
            raise self.exceptions.RayActorError("it died")
        return result

    def kill(self, actor):
        self.killed += 1


def _ray_load(x):
    return 10 * x


def _ray_compute(i, j, first, second):
    if (i, j) == (2, 50):
        raise ValueError("odd")
    return i, j, first, second


class Ray(unittest.TestCase):
    def run_job(self, items, deaths=()):
        ray = RayStandIn(deaths)
        before, sys.modules["ray"] = sys.modules.get("ray"), ray
        got = {}
        try:
            report = cluster.all_pairs(ray, items=items, room=6, load=_ray_load,
                                       compute=_ray_compute,
                                       sink=lambda i, j, result: got.setdefault((i, j), result))
        finally:
            sys.modules.pop("ray")
            if before is not None:
                sys.modules["ray"] = before
        self.assertEqual(got, {(i, j): (i, j, 10 * i, 10 * j)
                               for i, j in itertools.combinations(range(items), 2)})
        return ray, report

    def test_every_pair_comes_once(self):
        ray, report = self.run_job(24)
        self.assertEqual((report.pairs, len(report.workers), ray.killed), (276, 4, 4))

    def test_actors_that_die_are_done_without(self):
        ray, report = self.run_job(24, (3, 9, 20))
        self.assertEqual((report.lost, ray.killed), (3, 1))

    def test_without_actors_a_run_ends(self):
        with mock.patch.object(_team, "_without_workers", -1.0), self.assertRaisesRegex(
            changeover.MissingResource,
            "all workers were lost, and none came for -1 s; 0 of 276 pairs are done",
        ):
            self.run_job(24, (1, 2, 3, 4))

    def test_what_goes_wrong_with_an_actor_is_named(self):
        def fails(_ray, _ref):
            raise RayStandIn.exceptions.RayError("it is full")

        with mock.patch.object(RayStandIn, "get", fails), self.assertRaisesRegex(
            changeover.MissingResource,
            " cannot do its part: it is full; see the log of this worker",
        ):
            self.run_job(24)

    def test_what_raises_is_named(self):
        with self.assertRaisesRegex(
            ValueError, r"compute\(2, 50\) raised ValueError: odd \(on actor"
        ):
            self.run_job(60)


class Improvements(unittest.TestCase):
    def test_finds_are_verified_and_go_into_one_catalog(self):
        # A separate process: the user's catalog is opened once.
        program = (
            "import sys; sys.path.insert(0, sys.argv[1])\n"
            "import changeover, test_engines\n"
            "from changeover import cluster\n"
            "from changeover.cluster import _searches\n"
            "sys.modules['ray'] = ray = test_engines.RayStandIn()\n"
            "best = changeover.bounds(14, 4, 1).best_known\n"
            "_searches.design = lambda v, k, change, kind, strength: changeover.design(\n"
            "    v, k, change, kind, strength, construction='hold-and-stream')\n"
            "finds = cluster.improve(ray, 14, [4, 20], change=1, kind='linear', time=20, each=0.5,\n"
            "                        who='A Tester')\n"
            "(find,) = finds\n"
            "assert find.b == best < find.before, (find, best)\n"
            "assert find.design.verdict.valid and find.design.b == find.b\n"
            "entry = changeover.catalog.find(find.label)\n"
            "assert entry.b == find.b\n"
            "print(find, entry.design().b == find.b)\n")
        with tempfile.TemporaryDirectory() as folder:
            environment = {**os.environ, "CHANGEOVER_CATALOG": os.path.join(folder, "mine.db")}
            ended = subprocess.run(
                [sys.executable, "-c", program, os.path.dirname(os.path.abspath(__file__))],
                env=environment, capture_output=True, text=True, timeout=120)
        self.assertEqual((ended.returncode, ended.stderr), (0, ""))
        self.assertRegex(ended.stdout, r"^<linear SCCD\(14,4\): \d+ -> \d+ blocks> True$")


def _team_event(kind, worker, number):
    from changeover.cluster._engine import Event
    return Event(kind, worker, number if kind == "done" else -1)


if __name__ == "__main__":
    unittest.main()
