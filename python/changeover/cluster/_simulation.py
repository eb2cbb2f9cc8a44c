"""Simulates a cluster: with the real plans and decisions, and a clock that jumps from event to
event."""

from __future__ import annotations

import dataclasses
import heapq
import json
import math
import random
import time
from array import array
from typing import (
    Any, Callable, Dict, Iterable, Iterator, List, Optional, SupportsIndex, Tuple, Union)

from .. import _core
from .._made import Made, Progress, check_calls, count_of, fact, made
from .._notebook import Shown
from .._pairs_given import memory_of
from ..errors import BadInput
from ._engine import Event, Tell, tell_of
from ._job import Wanted, Work, cut_evenly
from ._team import NoWorkers, Team
from ._worker import Memory, Outcome

_exact_pairs = 2_000_000  # up to so many pairs the stretches are those that workers would get
_most_workers = 65_536
_most_number = 1e60  # seconds, bytes, bytes a second
_most_failures = 10  # of each worker, on average, while none of them finishes a stretch
_least_failures = 300  # in all, before that is looked at
_most_exponent = 30.0  # a stretch is finished with probability exp(-30): never


_too_short = "workers fail before they are done with a stretch"


class Simulation(Shown, Made):
    """The predicted result of a run on such a cluster."""

    seconds: float = fact("Until the last pair is done.")
    ideal_seconds: float = fact("If workers only computed, all the time, and none failed.")
    pairs: int = fact("That must be computed.")
    loads: int = fact("That were finished; what lost workers had in hand is loaded again.")
    planned_loads: int = fact("Of the plan, if each worker does its own part.")
    bytes: int = fact("That left the store, those of lost workers included.")
    workers: int = fact("At the start.")
    computing: float = fact("The share of the workers' time in which they computed.")
    loading: float = fact("In which they loaded, as fast as a worker alone would.")
    waiting: float = fact("In which loads took longer, as others loaded, too.")
    idle: float = fact("In which they had nothing to do, waited for a stretch to be handed out, or "
                       "were away after a failure.")
    wasted: float = fact("The share of their time that went into what was lost or done twice.")
    lost: int = fact("Failures of workers.")
    retried: int = fact("Stretches that were done again.")
    stolen: int = fact("How often an idle worker took a part of another's work.")
    copied: int = fact("Stretches that an idle worker did too, as they were late.")
    stretches: int = fact("Into which the work was cut.")
    exact: bool = fact("Each step was simulated; otherwise stretches are alike within a worker's "
                       "share.")

    def __repr__(self) -> str:
        lost = f", {self.lost} lost" if self.lost else ""
        return (f"<cluster.Simulation: {self.workers} workers, {self.seconds:.4g} s (ideal "
                f"{self.ideal_seconds:.4g} s), {self.bytes:.4g} bytes, idle {self.idle:.1%}{lost}>")

    def _on_page(self) -> Any:
        rows = [("seconds", f"{self.seconds:.4g}"), ("ideal seconds", f"{self.ideal_seconds:.4g}"),
                *((name.replace("_", " "), getattr(self, name)) for name in (
                    "pairs", "loads", "planned_loads", "bytes")),
                *((name, f"{getattr(self, name):.1%}") for name in (
                    "computing", "loading", "waiting", "idle", "wasted")),
                *((name, getattr(self, name)) for name in (
                    "lost", "retried", "stolen", "copied", "stretches"))]
        return (f"a simulated run with {count_of(self.workers, 'worker')}", (),
                ("figure", "value"), rows, len(rows))


@dataclasses.dataclass(frozen=True)
class _Cluster:
    mean_bytes: float
    pair_seconds: float
    bandwidth: float
    store: float
    latency: float
    overhead: float
    failures: float  # a second
    restart: Optional[float]
    stragglers: float
    slowness: float
    overlap: bool


class _Task:
    """A stretch at a worker: it loads, then computes, or both at the same time."""

    __slots__ = ("number", "worker", "bytes", "alone", "compute", "began", "ready", "outcome",
                 "loaded")

    def __init__(self, number: int, worker: str, size: float, alone: float, compute: float,
                 outcome: Outcome) -> None:
        self.number, self.worker, self.bytes = number, worker, size
        self.alone, self.compute, self.outcome = alone, compute, outcome
        self.began = self.ready = self.loaded = 0.0


class _Store:
    """Shares a bandwidth among loading workers: each gets at most its own limit, otherwise a share
    by weight. Time is counted in bytes per unit of weight."""

    def __init__(self, each: float, total: float) -> None:
        self._each, self._total = each, total
        self._weight = 0.0
        self._clock, self._now = 0.0, 0.0
        self._loading: List[Tuple[float, int, _Task, float]] = []
        self._gone: set[int] = set()

    def _rate(self) -> float:
        if self._weight <= 0:
            return self._each
        return min(self._each, self._total / self._weight)

    def advance(self, now: float) -> None:
        self._clock += (now - self._now) * self._rate()
        self._now = now

    def start(self, task: _Task, weight: float) -> None:
        heapq.heappush(self._loading,
                       (self._clock + task.bytes / weight, task.number, task, weight))
        self._weight += weight

    def cancel(self, number: int) -> None:
        self._gone.add(number)
        for _, each, _, weight in self._loading:
            if each == number:
                self._weight -= weight

    def next_time(self) -> float:
        while self._loading and self._loading[0][1] in self._gone:
            self._gone.discard(heapq.heappop(self._loading)[1])
        if not self._loading:
            self._weight = 0.0
            return math.inf
        left = max(0.0, self._loading[0][0] - self._clock)
        return self._now + left / self._rate()

    def finish(self) -> _Task:
        _, _, task, weight = heapq.heappop(self._loading)
        self._weight -= weight
        return task


class _Simulated:
    """An engine with simulated workers."""

    def __init__(self, cluster: _Cluster, workers: int, seed: int,
                 do: Callable[[str, Any], Outcome], forget: Callable[[str], object]) -> None:
        self._cluster = cluster
        self._random = random.Random(seed)
        self._do, self._forget = do, forget
        self._now = 0.0
        self._store = _Store(cluster.bandwidth, cluster.store)
        self._events: List[Tuple[float, int, str, str, int]] = []
        self._count = 0
        self._tasks: Dict[int, _Task] = {}
        self._at: Dict[str, _Task] = {}
        self._slow: Dict[str, float] = {}
        self._done: Dict[int, _Task] = {}
        self._away: Dict[str, float] = {}
        self._up: List[str] = []
        self.bytes = self.computing = self.loading = self.waiting = self.wasted = 0.0
        self._failures = 0  # since the last stretch was done
        self._most_failures = max(_least_failures, _most_failures * workers)
        for number in range(workers):
            self._up.append(str(number))
            self._start(str(number))
        slow = self._random.sample(self._up, round(cluster.stragglers * workers))
        self._slow = dict.fromkeys(slow, cluster.slowness)

    def _push(self, when: float, kind: str, worker: str, number: int = -1) -> None:
        self._count += 1
        heapq.heappush(self._events, (when, self._count, kind, worker, number))

    def _start(self, worker: str) -> None:
        if self._cluster.failures > 0:
            self._push(self._now + self._random.expovariate(self._cluster.failures), "fails",
                       worker)

    def workers(self) -> List[str]:
        return list(self._up)

    def now(self) -> float:
        return self._now

    def submit(self, worker: str, stretch: Any) -> None:
        cluster = self._cluster
        slow = self._slow.get(worker, 1.0)
        outcome = self._do(worker, stretch)
        size = float(outcome.bytes_loaded or 0)
        alone = size / cluster.bandwidth * slow + outcome.loads * cluster.latency
        task = _Task(stretch.number, worker, size + outcome.loads * cluster.latency *
                     cluster.bandwidth / slow, alone, stretch.cost * cluster.pair_seconds * slow,
                     outcome)
        task.began = self._now
        outcome.load_seconds = alone
        self._tasks[task.number] = self._at[worker] = task
        self._push(self._now + cluster.overhead, "begins", worker, task.number)

    def wait(self, _seconds: float) -> List[Event]:
        while True:
            loaded = self._store.next_time()
            if not self._events and loaded == math.inf:
                raise NoWorkers("all workers failed, and none is replaced; give restart, or fewer "
                                "failures")
            if self._events and self._events[0][0] <= loaded:
                when, _, kind, worker, number = heapq.heappop(self._events)
                self._advance(when)
                events = self._happens(kind, worker, number)
                if events:
                    return events
            else:
                self._advance(loaded)
                self._has_loaded(self._store.finish())

    def _advance(self, when: float) -> None:
        self._store.advance(when)
        self._now = when

    def _happens(self, kind: str, worker: str, number: int) -> List[Event]:
        if kind == "fails":
            return self._fails(worker)
        if kind == "comes":
            self._away.pop(worker, None)
            self._start(worker)
            return [Event("joined", worker)]
        task = self._tasks.get(number)
        if task is None:
            return []
        if kind == "begins":
            if task.bytes > 0:
                self._store.start(task, 1.0 / self._slow.get(worker, 1.0))
                if self._cluster.overlap:
                    task.ready = self._now + task.compute
            else:
                self._has_loaded(task)
            return []
        return self._ends(task)

    def _has_loaded(self, task: _Task) -> None:
        task.loaded = self._now
        end = max(self._now, task.ready) if task.ready else self._now + task.compute
        self._push(end, "ends", task.worker, task.number)

    def _ends(self, task: _Task) -> List[Event]:
        self._failures = 0
        del self._tasks[task.number]
        self._at.pop(task.worker, None)
        self._done[task.number] = task
        took = self._now - task.began
        task.outcome.seconds = took
        self.bytes += task.outcome.bytes_loaded or 0
        self.computing += task.compute
        rest = max(0.0, took - task.compute - self._cluster.overhead)
        self.loading += min(rest, task.alone)
        self.waiting += max(0.0, rest - task.alone)
        return [Event("done", task.worker, task.number)]

    def _fails(self, worker: str) -> List[Event]:
        self._failures += 1
        if self._failures > self._most_failures:
            raise NoWorkers(_too_short)
        task = self._at.pop(worker, None)
        if task is not None:
            del self._tasks[task.number]
            if not task.loaded and self._now > task.began + self._cluster.overhead:
                self._store.cancel(task.number)
            self.wasted += self._now - task.began
            self.bytes += task.outcome.bytes_loaded or 0
        self._forget(worker)
        if self._cluster.restart is not None:
            self._push(self._now + self._cluster.restart, "comes", worker)
        return [Event("lost", worker)]

    def outcome(self, number: int) -> Outcome:
        return self._done.pop(number).outcome

    def drop(self, number: int) -> None:
        task = self._done.pop(number, None)
        if task is not None:  # A copy that came too late.
            self.computing -= task.compute
            self.wasted += task.compute

    def close(self) -> None:
        """Runs nothing."""


# Shares of so many pairs that they are not listed: stretches are alike within a share.


@dataclasses.dataclass(frozen=True)
class _BulkStretch:
    number: int
    run: int
    first: int
    loads: int
    pairs: int
    cost: float

    def each_pair(self) -> Iterator[Tuple[int, int]]:
        """A number of pairs, without their items."""
        yield from ((self.run, self.number) for _ in range(self.pairs))


class _Bulk:
    """Like _stretches.Run, with numbers only."""

    _next = 0

    def __init__(self, first: int, rest: float, pairs: float, losses: int = 0) -> None:
        _Bulk._next += 1
        self._name = _Bulk._next
        self._first, self._rest = first, rest
        self.cost = pairs
        self.losses = losses

    def __bool__(self) -> bool:
        return self.cost >= 0.5

    @property
    def pairs(self) -> int:
        return round(self.cost)

    @property
    def loads(self) -> int:
        return round(self._first + self._rest)

    def loads_to_begin(self, held: frozenset[int]) -> int:
        return 0 if self._name in held else self._first

    def loads_to_split(self, _cost: float, _held: frozenset[int]) -> int:
        return self._first

    def take(self, number: int, cost: float) -> _BulkStretch:
        part = 1.0 if self.cost < 1.25 * cost else cost / self.cost
        taken = self.cost * part
        loads = self._rest * part
        self._rest -= loads
        self.cost = self.cost - taken if part < 1 else 0.0
        return _BulkStretch(number, self._name, self._first, round(loads), round(taken), taken)

    def split(self, cost: float) -> _Bulk:
        part = 1.0 if cost >= self.cost else max(0.0, cost / self.cost)
        cut = _Bulk(self._first, self._rest * part, self.cost * part, self.losses)
        self._rest -= self._rest * part
        self.cost = self.cost * (1 - part)
        return cut

    @classmethod
    def of(cls, stretch: _BulkStretch, losses: int, after: int) -> _Bulk:
        left = 1 - after / max(1, stretch.pairs)
        return cls(stretch.first, stretch.loads * left, stretch.cost * left, losses)


def _bulk_shares(wanted: Wanted, workers: int) -> List[List[Any]]:
    asked = json.dumps({**wanted.asked, **wanted.place, "workers": workers})
    core = _core.Loads.planned(asked, None, None)
    shapes: array[int] = array("Q")
    shapes.frombytes(core.shapes())
    rows = list(zip(shapes[::3], shapes[1::3], shapes[2::3]))
    scale = wanted.count / max(1, sum(pairs for _, _, pairs in rows))
    shares = [[_Bulk(first, loads - first, pairs * scale)] for loads, first, pairs in rows]
    return [[run for run in share if run] for share in shares]


def simulate(
    *, items: int, workers: int, pair_seconds: float,
    item_bytes: Union[int, Iterable[int], Callable[[int], int]],
    pairs: Optional[Iterable[Iterable[SupportsIndex]]] = None,
    groups: Optional[Iterable[Iterable[SupportsIndex]]] = None,
    cost: Union[None, Callable[[int, int], float], Iterable[float]] = None,
    room: Optional[int] = None, memory: Union[int, str, None] = None, bandwidth: float = 1e9,
    store: Optional[float] = None, latency: float = 0.0, overhead: float = 0.01,
    failures: float = 0.0, restart: Optional[float] = 60.0, stragglers: float = 0.0,
    slowness: float = 4.0, overlap: bool = False, stretches: int = 16, seed: int = 1,
    progress: Progress = None,
) -> Simulation:
    """Predicts what all_pairs() would take with this many workers. The plan and the decisions are
    the real ones; only workers, clock and storage are simulated.

    pair_seconds: time to compute a pair, multiplied by its cost. item_bytes: as sizes of
    all_pairs(), or one number. bandwidth: bytes per second that one worker can load; store: the
    limit for all workers together, None for no limit. latency: seconds before the first byte of an
    item. overhead: seconds for sending a stretch. failures: per worker and hour; restart: seconds
    until a lost worker is replaced, None for never. stragglers: the proportion of workers that are
    slower by the factor `slowness`. room, memory, overlap, stretches, pairs, groups, cost: as in
    all_pairs().

    Up to 2,000,000 pairs each step is simulated; above that, the stretches of a worker are treated
    as equal, and pairs are counted by group or by load. Raises BadInput, ImpossibleParameters.
    """
    numbers = {"pair_seconds": pair_seconds, "latency": latency, "overhead": overhead,
               "failures": failures, "stragglers": stragglers, "slowness": slowness,
               "bandwidth": bandwidth, "store": math.inf if store is None else store,
               "restart": restart or 0.0}
    for argument, number in numbers.items():
        if not 0 <= number <= (math.inf if argument == "store" else _most_number) or (
                number < 1e-60 and argument in ("bandwidth", "store", "slowness")):
            least = "above 0, up to" if argument in ("bandwidth", "store", "slowness") else "from 0 to"
            raise BadInput(f"{argument} must be {least} {_most_number:g}, not {number:g}")
    if stragglers > 1:
        raise BadInput("stragglers is a share of the workers, from 0 to 1")
    if not 1 <= workers <= _most_workers:
        raise BadInput(f"workers is a number from 1 to {_most_workers}")
    if not 1 <= stretches <= 10_000:
        raise BadInput("stretches is a number from 1 to 10000")
    exact = pairs is not None or groups is not None or items * (items - 1) // 2 <= _exact_pairs
    if not exact and memory is not None:
        raise BadInput("memory is for up to 2000000 pairs, or for listed ones; give room, how many "
                       "items a worker holds")
    wanted = Wanted(items, room, pairs, None, None, False, cost, any_count=not exact, groups=groups,
                    sizes=item_bytes, memory=memory_of("memory", memory), overlap=overlap,
                    sizes_are="item_bytes")
    if not exact and cost is not None:
        raise BadInput("cost with more than 2000000 pairs is not supported; list the pairs, or "
                       "leave cost out")
    size = wanted.size
    assert size is not None
    mean = (size(0) if isinstance(item_bytes, int) else
            sum(map(size, range(wanted.items))) / wanted.items)
    if failures / 3600 * (overhead + (pair_seconds if cost is None else 0.0)) > _most_exponent:
        raise _endless(_too_short)
    cluster = _Cluster(mean, pair_seconds, bandwidth, numbers["store"], latency, overhead,
                       failures / 3600, restart, stragglers, slowness, overlap)
    return made(Simulation, (_exactly if exact else _in_bulk)(
        cluster, wanted, workers, stretches, seed, tell_of(progress)))


def _endless(why: object) -> BadInput:
    return BadInput(f"the simulated run does not end: {why}")


def _exactly(cluster: _Cluster, wanted: Wanted, workers: int, stretches: int, seed: int,
             progress: Tell) -> Dict[str, Any]:
    memories: Dict[str, Memory] = {}

    def do(worker: str, stretch: Any) -> Outcome:
        memory = memories.setdefault(
            worker, Memory(_nothing, _nothing, wanted.room, memory=wanted.memory))
        return memory.run(stretch)

    work = Work(wanted, None, 0, "", "")
    shares, _ = work.first_shares(workers)
    engine = _Simulated(cluster, workers, seed, do, lambda worker: memories.pop(worker, None))
    team = Team(engine, work.deliver, work.replan, work.again, stretches,
                _teller(progress, lambda: work.done.count, wanted.count), size=wanted.size)
    return _run(cluster, engine, team, shares, wanted, lambda: work.left == 0, True)


def _nothing(*_given: Any) -> None:
    return None


def _in_bulk(cluster: _Cluster, wanted: Wanted, workers: int, stretches: int, seed: int,
             progress: Tell) -> Dict[str, Any]:
    held: Dict[str, int] = {}
    done = [0.0]

    def do(worker: str, stretch: Any) -> Outcome:
        loads = stretch.loads + (0 if held.get(worker) == stretch.run else stretch.first)
        held[worker] = stretch.run
        return Outcome(stretch.number, loads=loads, bytes_loaded=round(loads * cluster.mean_bytes),
                       held=(stretch.run,))

    def deliver(stretch: Any, worker: str, outcome: Outcome) -> int:
        done[0] += stretch.cost
        pairs: int = stretch.pairs
        return pairs

    shares = _bulk_shares(wanted, workers)
    total = float(sum(run.cost for share in shares for run in share))
    engine = _Simulated(cluster, workers, seed, do, lambda worker: held.pop(worker, None))
    again: Any = _Bulk.of
    team = Team(engine, deliver, cut_evenly, again, stretches,
                _teller(progress, lambda: round(done[0]), wanted.count))
    return _run(cluster, engine, team, shares, wanted, lambda: done[0] >= total * (1 - 1e-9) - 0.5,
                False)


def _teller(progress: Tell, done: Callable[[], int], total: int) -> Callable[[str], None]:
    last = [time.monotonic()]

    def tell(_phase: str) -> None:
        if progress is not None and time.monotonic() - last[0] >= 0.5:
            last[0] = time.monotonic()
            progress({"phase": "simulating", "steps": done(), "of": total, "unit": "pairs"})
    return tell


def _run(cluster: _Cluster, engine: _Simulated, team: Team, shares: List[List[Any]],
         wanted: Wanted, is_over: Callable[[], bool], exact: bool) -> Dict[str, Any]:
    team.planned_loads = sum(run.loads for share in shares for run in share)
    workers = len(engine.workers())
    total = sum(run.cost for share in shares for run in share)
    try:
        team.run(shares, is_over)
    except NoWorkers as fault:
        raise _endless(fault) from fault
    seconds = engine.now()
    time_of_all = max(seconds * workers, 1e-300)
    spent = engine.computing + engine.loading + engine.waiting + engine.wasted
    return {
        "seconds": seconds, "ideal_seconds": total * cluster.pair_seconds / workers,
        "pairs": wanted.count, "loads": team.loads, "planned_loads": team.planned_loads,
        "bytes": round(engine.bytes), "workers": workers,
        "computing": engine.computing / time_of_all, "loading": engine.loading / time_of_all,
        "waiting": engine.waiting / time_of_all, "wasted": engine.wasted / time_of_all,
        "idle": max(0.0, 1 - spent / time_of_all), "lost": team.lost, "retried": team.retried,
        "stolen": team.stolen, "copied": team.copied, "stretches": team.sent, "exact": exact}


check_calls(globals())
