"""Assigns work: sends stretches to workers, lets idle workers take some from others, and plans lost
work again.

It has neither an engine nor a clock, so that a simulation makes the same decisions.
"""

from __future__ import annotations

import collections
import dataclasses
import heapq
import itertools
import math
from typing import Callable, Deque, Dict, List, NamedTuple, Optional, Protocol, Tuple

from ..errors import InternalError
from ._engine import Engine, Lost
from ._stretches import Run, Stretch
from ._worker import Outcome

_patience = 0.5  # seconds after which progress is told, at the latest, and idle workers looked at
_without_workers = 300.0  # seconds after which a run without any worker ends
_most_losses = 8  # of workers while they had one pair and nothing else
_some_workers = 200  # of very many, that are looked at for what has least to do
_no_twin, _settled = -1, -2  # _settled: the other one was ready first
# Stealing may cost up to such a part of the planned loads if it saves such a part of the time.
_worth = ((0.04, 0.0), (0.1, 0.05), (math.inf, 0.15))
_worth_after_losses = 0.02


class Flight(NamedTuple):
    """A stretch in progress."""

    stretch: Stretch
    worker: str
    began: float
    losses: int
    twin: int  # the number of the same stretch at another worker


class Deliver(Protocol):
    """Receives the results of a stretch; returns how many of its first pairs are settled."""

    def __call__(self, stretch: Stretch, worker: str, outcome: Outcome) -> int: ...


class _Member:
    """The state of a worker."""

    def __init__(self) -> None:
        self.queue: Deque[Run] = collections.deque()
        self.left = 0.0  # cost in the queue
        self.flight = -1  # the number of its stretch
        self.held: frozenset[int] = frozenset()
        self.rate = math.nan  # seconds a cost, its loads included
        self.pairs = self.loads = 0
        self.busy = 0.0

    def put(self, runs: List[Run], in_front: bool = False) -> None:
        for run in reversed(runs) if in_front else runs:
            (self.queue.appendleft if in_front else self.queue.append)(run)
            self.left += run.cost


class Team:
    """One run. `replan` makes runs for the workers from lost runs; `again` makes a run of the rest
    of a stretch after its first pairs."""

    def __init__(self, engine: Engine, deliver: Deliver,
                 replan: Callable[[List[Run], int], List[List[Run]]],
                 again: Callable[[Stretch, int, int], Run], stretches: int,
                 tell: Callable[[str], None],
                 size: Optional[Callable[[int], int]] = None) -> None:
        self.engine = engine
        self._deliver = deliver
        self._replan = replan
        self._run_of = again
        self._stretches = stretches
        self._tell = tell
        self._size = size  # of items, for the stretches that are sent
        self._look_again = 0.0
        self._suspects: Dict[Tuple[int, int], Tuple[int, int]] = {}
        self._extra = 0  # loads that stealing has cost
        self.members: Dict[str, _Member] = {}
        self.gone: Dict[str, _Member] = {}
        self._flights: Dict[int, Flight] = {}
        self._orphans: List[Run] = []
        self._victims: List[Tuple[float, str]] = []  # those with most left first; may be stale
        self._idle: Dict[str, None] = {}
        self._next = 0
        self._target = 1.0
        self._load_seconds, self._loads_timed = 0.0, 0
        self._rate_seconds, self._rate_cost = 0.0, 0.0
        self._any_done = False
        self._alone_since: Optional[float] = None
        self.loads = self.planned_loads = 0
        self.retried = self.lost = self.stolen = self.copied = self.sent = 0
        self.bytes_loaded: Optional[int] = 0
        self.most_held = self.most_bytes = 0

    # The run as a whole

    def run(self, shares: List[List[Run]], is_over: Callable[[], bool]) -> None:
        """Runs until `is_over`. Raises MissingResource if no worker comes, and exceptions of
        `deliver`."""
        for worker in self.engine.workers():
            self.members[worker] = _Member()
        total = sum(run.cost for runs in shares for run in runs)
        workers = max(1, len(self.members))
        self._target = total / (workers * self._stretches)
        self._begin = self.engine.now()
        for member, runs in zip(self.members.values(), shares):
            member.put(runs)
        self._orphans = [run for runs in shares[len(self.members):] for run in runs]
        self._hand_out_orphans()
        for worker in list(self.members):
            self._note(worker)
        for worker in list(self.members):
            self._give(worker)
        while not is_over():
            self._turn()

    def _turn(self) -> None:
        self._tell("computing" if self.members else "waiting for workers")
        if not self.members:
            self._wait_for_workers()
        elif not self._flights and not any(each.queue for each in self.members.values()):
            raise InternalError("pairs are left that no stretch has: this is a bug")
        for event in self.engine.wait(_patience):
            if event.kind == "joined":
                self._join(event.worker)
            elif event.kind == "lost":
                self._lose(event.worker)
            else:
                self._done(event.number)
        if self._idle and self.engine.now() >= self._look_again:
            usual = self._target * self._rate_seconds / (self._rate_cost or 1.0)
            self._look_again = self.engine.now() + max(_patience, usual / 10)
            self._use_idle()

    def _wait_for_workers(self) -> None:
        now = self.engine.now()
        if self._alone_since is None:
            self._alone_since = now
        elif now - self._alone_since > _without_workers:
            raise NoWorkers(f"all workers were lost, and none came for {_without_workers:.0f} s")

    # Workers

    def _join(self, worker: str) -> None:
        if worker in self.members:
            return
        self.members[worker] = self.gone.pop(worker, _Member())
        self._alone_since = None
        self._hand_out_orphans()
        self._give(worker)

    def _lose(self, worker: str) -> None:
        member = self.members.pop(worker, None)
        if member is None:
            return
        self.lost += 1
        self._idle.pop(worker, None)
        runs = list(member.queue)
        if member.flight in self._flights:
            again = self._again(member.flight)
            # What was lost before waits until the rest is done: it may be what workers are lost of.
            runs = again + runs if not again or again[0].losses < 2 else runs + again
        member.queue.clear()
        member.left, member.flight, member.held = 0.0, -1, frozenset()
        self.gone[worker] = member
        self._orphans += runs
        self._hand_out_orphans()

    def _again(self, number: int) -> List[Run]:
        """The part of a stretch that must be done again after its worker was lost."""
        flight = self._flights.pop(number)
        self.engine.drop(number)
        if flight.twin == _settled:
            return []
        if flight.twin in self._flights:
            self._flights[flight.twin] = self._flights[flight.twin]._replace(twin=_no_twin)
            return []
        if flight.stretch.pairs == 1:
            self._suspect(next(iter(flight.stretch.each_pair())))
        self.retried += 1
        return [self._run_of(flight.stretch, flight.losses + 1, 0)]

    def _suspect(self, pair: Tuple[int, int]) -> None:
        """Raises NoWorkers for a pair that was in progress alone when many workers were lost, if
        fewer were lost without it."""
        times, since = self._suspects.get(pair, (0, self.lost - 1))
        self._suspects[pair] = (times + 1, since)
        if times + 1 >= _most_losses and 2 * (times + 1) > self.lost - since:
            raise NoWorkers(f"the pair {pair} was under way on {times + 1} workers when they were "
                            "lost; does it take more memory than they have?")

    def _hand_out_orphans(self) -> None:
        if not self._orphans or not self.members:
            return
        runs, self._orphans = self._orphans, []
        cost = sum(run.cost for run in runs)
        # Each part fills its memory again, and should load as much again.
        loads = sum(run.loads for run in runs)
        most = len(self.members)
        parts = max(1, min(most, int(min(most, 2 * cost / self._target)) if self._target else most,
                           loads // max(1, self.most_held)))
        shares = self._replan(runs, parts) if parts > 1 else [runs]
        some = itertools.islice(self.members, max(len(shares), _some_workers))
        least = heapq.nsmallest(len(shares), dict.fromkeys((*self._idle, *some)), key=self._seconds)
        shares.sort(key=lambda share: -sum(run.cost for run in share))
        for worker, share in zip(least, shares):
            self.members[worker].put(share)
            self._note(worker)
            if worker in self._idle:
                self._give(worker)

    # Stretches

    def _rate(self, member: _Member) -> float:
        if not math.isnan(member.rate):
            return member.rate
        return self._rate_seconds / self._rate_cost if self._rate_cost else 0.0

    def _seconds(self, worker: str) -> float:
        """The estimated time from now until the worker has finished all its stretches."""
        member = self.members[worker]
        return member.left * self._rate(member) + self._flying(member)

    def _flying(self, member: _Member) -> float:
        flight = self._flights.get(member.flight)
        if flight is None:
            return 0.0
        expected = flight.stretch.cost * self._rate(member)
        return max(expected - (self.engine.now() - flight.began), 0.05 * expected)

    def _note(self, worker: str) -> None:
        member = self.members[worker]
        if member.queue:
            heapq.heappush(self._victims, (-member.left * (self._rate(member) or 1.0), worker))

    def _give(self, worker: str) -> None:
        """Sends the worker its next stretch, or one of another worker, or a copy of a late one."""
        member = self.members[worker]
        if not member.queue and not self._steal(worker):
            self._idle[worker] = None
            return
        run = member.queue[0]
        cost = self._target / 4.0**min(run.losses, 20)
        if len(member.queue) == 1:  # Towards the end there is more to share in small pieces.
            cost = min(cost, max(run.cost / 2, self._target / 4))
        before = run.cost
        self._next += 1
        stretch = run.take(self._next, cost)
        member.left -= before - run.cost
        if not run:
            member.queue.popleft()
            member.left = member.left if member.queue else 0.0
        self._send(worker, stretch, run.losses)

    def _send(self, worker: str, stretch: Stretch, losses: int, twin: int = _no_twin) -> None:
        self._idle.pop(worker, None)
        self.members[worker].flight = stretch.number
        self._flights[stretch.number] = Flight(stretch, worker, self.engine.now(), losses, twin)
        self.sent += 1
        self.engine.submit(worker, stretch if self._size is None else
                           stretch.with_sizes(self._size))

    def _done(self, number: int) -> None:
        flight = self._flights.get(number)
        if flight is None:
            return
        worker = flight.worker
        member = self.members[worker]
        # The next one is under way while the results of this one are taken.
        if member.flight == number:
            member.flight = -1
            self._give(worker)
        if flight.twin == _settled:
            del self._flights[number]
            self.engine.drop(number)
            return
        try:
            outcome = self.engine.outcome(number)
        except Lost:
            if number in self._flights:
                self._orphans += self._again(number)
                self._hand_out_orphans()
            return
        self._flights.pop(number, None)
        if flight.twin in self._flights:
            self._flights[flight.twin] = self._flights[flight.twin]._replace(twin=_settled)
        self._learn(member, flight, outcome)
        settled = self._deliver(flight.stretch, worker, outcome)
        member.pairs += settled
        if settled < flight.stretch.pairs and worker in self.members:
            self.retried += 1
            again = self._run_of(flight.stretch, flight.losses, settled)
            other = min((each for each in self.members if each != worker or len(self.members) == 1),
                        key=self._seconds)
            self.members[other].put([again], in_front=True)
            self._note(other)
            if other in self._idle:
                self._give(other)

    def _learn(self, member: _Member, flight: Flight, outcome: Outcome) -> None:
        self._any_done = True
        self.loads += outcome.loads
        member.loads += outcome.loads
        member.busy += outcome.seconds
        member.held = frozenset(outcome.held)
        if outcome.bytes_loaded is None or self.bytes_loaded is None:
            self.bytes_loaded = None
        else:
            self.bytes_loaded += outcome.bytes_loaded
        self.most_held = max(self.most_held, outcome.most_held)
        self.most_bytes = max(self.most_bytes, outcome.most_bytes)
        self._load_seconds += outcome.load_seconds
        self._loads_timed += outcome.loads
        if outcome.failure is None and flight.stretch.cost > 0:
            seconds = self.engine.now() - flight.began
            rate = seconds / flight.stretch.cost
            member.rate = rate if math.isnan(member.rate) else (member.rate + rate) / 2
            self._rate_seconds += seconds
            self._rate_cost += flight.stretch.cost

    # Stealing

    def _steal(self, thief: str) -> bool:
        """Takes enough from the worker that finishes last so that both finish at the same time."""
        while self._victims:
            _, victim = self._victims[0]
            member = self.members.get(victim)
            if member is None or not member.queue or victim == thief:
                heapq.heappop(self._victims)
                continue
            key = -member.left * (self._rate(member) or 1.0)
            if key > self._victims[0][0]:  # It has less now.
                heapq.heapreplace(self._victims, (key, victim))
                continue
            if not self._steal_from(member, self.members[thief]):
                return False
            self._note(thief)
            return True
        return False

    def _steal_from(self, victim: _Member, thief: _Member) -> bool:
        rate, own = self._rate(victim), self._rate(thief)
        if self._is_stuck(victim):
            part = math.inf
        elif rate == 0.0:  # Nothing is known yet.
            part = victim.left / 2
        else:
            a_load = self._load_seconds / self._loads_timed if self._loads_timed else 0.0
            ready = self._flying(victim) + victim.left * rate
            part = min(ready / (own + rate), victim.left)
            hold = victim.queue[-1].loads_to_split(part, thief.held)
            part = min((ready - hold * a_load) / (own + rate), victim.left)
            saves = ready - max(hold * a_load + part * own, ready - part * rate)
            if saves <= 0 or part < 0.1 * min(self._target, victim.left):
                return False
            if saves < self._worth(hold) * (self.engine.now() - self._begin):
                return False
        taken: List[Run] = []
        missing = part
        while victim.queue and missing > 0:
            run = victim.queue[-1]
            if run.cost <= missing:
                victim.queue.pop()
                stolen = run
            else:
                stolen = run.split(missing)
                if not run:
                    victim.queue.pop()
                if not stolen:
                    break
            taken.insert(0, stolen)
            missing -= stolen.cost
        victim.left = sum(run.cost for run in victim.queue)
        if not taken:
            return False
        self._extra += taken[0].loads_to_begin(thief.held)
        thief.put(taken)
        self.stolen += 1
        return True

    def _is_stuck(self, member: _Member) -> bool:
        """Whether its stretch was also given to another worker, so that the rest may not return to
        it."""
        flight = self._flights.get(member.flight)
        return flight is not None and flight.twin != _no_twin and self._is_late(flight)

    def _is_late(self, flight: Flight) -> bool:
        return self.engine.now() - flight.began > max(1.0, 3 * self._usual(flight))

    def _usual(self, flight: Flight) -> float:
        return flight.stretch.cost * self._rate_seconds / (self._rate_cost or 1.0)

    def _worth(self, loads: int) -> float:
        if self.lost:
            return _worth_after_losses
        part = (self._extra + loads) / max(1, self.planned_loads)
        return next(time for most, time in _worth if part <= most)

    def _use_idle(self) -> None:
        for worker in list(self._idle):
            self._give(worker)
            if worker in self._idle:
                break  # What is not worth its loads for one is not for others.
        late = []
        for each in self._flights.values() if self._idle and self._any_done else ():
            if each.twin == _no_twin and self._is_late(each):
                late.append((each.began + self._usual(each), each.stretch.number))
        for (_, number), worker in zip(sorted(late), list(self._idle)):
            self._copy(number, worker)

    def _copy(self, number: int, worker: str) -> None:
        """An idle worker repeats a stretch that takes another worker much longer than it should."""
        flight = self._flights[number]
        self._next += 1
        self._flights[number] = flight._replace(twin=self._next)
        self.copied += 1
        self._send(worker, dataclasses.replace(flight.stretch, number=self._next), flight.losses,
                   twin=number)


class NoWorkers(Exception):
    """The run cannot go on."""
