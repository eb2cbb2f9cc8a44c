"""All pairs on a cluster: the request, its plan, and the handling of results."""

from __future__ import annotations

import itertools
import json
import math
import operator
import time
from array import array
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Set, Tuple

from .. import _core
from .._given import leads_from_keys, listed, rows_of, words_of
from .._made import count_of
from ..errors import BadInput, ImpossibleParameters, InternalError
from .._pairs_given import given_ends, item_number
from ._failed import failed
from ._journal import Journal, PairSet, ends_of, name_of_job
from ._stretches import Run, Step, Stretch, loads_in_turn, step_of, trimmed, without
from ._worker import Failure, Outcome, unpacked_result

Pair = Tuple[int, int]
_most_pairs = 1 << 28
_few_pairs = 20_000  # a list of so many is planned in less time than its order is worth
_replan_seconds = 0.1
_most_cost = 1e60  # so that sums of them, and products with seconds, are numbers


class Wanted:
    """The pairs, the number of items, and the cost of each pair."""

    def __init__(self, items: Optional[int], room: Optional[int], pairs: Any,
                 against: Optional[int], done_items: Optional[int], with_self: bool, cost: Any,
                 any_count: bool = False, groups: Any = None, sizes: Any = None,
                 memory: Optional[int] = None, overlap: bool = False,
                 sizes_are: str = "sizes") -> None:
        if (room is None) == (memory is None):
            raise BadInput("give room, how many items a worker holds, or sizes and memory, how "
                           "many bytes")
        if memory is not None and sizes is None:
            raise BadInput("memory is in bytes, and needs sizes, the bytes of each item")
        if overlap and room is not None and room < 3:
            raise BadInput("overlap keeps one place for what is loading; give room 3 or more")
        if sum(each is not None for each in (pairs, groups, against, done_items)) > 1:
            raise BadInput("give one of pairs, groups, against and done_items")
        if groups is not None:
            if cost is not None and not callable(cost):
                raise BadInput("cost is a function cost(i, j); a list of costs goes with a list of "
                               "pairs")
            pairs = _pairs_within(groups)
        self.asked: Dict[str, Any] = {"items": items, "against": against, "done_items": done_items}
        self.list: Optional[List[Pair]] = None
        self.alone: set[int] = set()  # items that are computed with themselves
        costs = None
        if pairs is not None:
            ends = given_ends(pairs)
            rows = list(zip(ends[::2], ends[1::2]))
            if cost is not None and not callable(cost):
                costs = _costs_of(rows, cost)
            self.alone = {i for i, j in rows if i == j}
            self.list = sorted({(min(row), max(row)) for row in rows if row[0] != row[1]})
            most = max((max(row) for row in rows), default=-1) + 1
            if items is not None and most > items:
                what = "pairs" if groups is None else "groups"
                raise BadInput(f"{what}: there are {items} items, numbered from 0, and a "
                               f"{what[:-1]} has number {most - 1}; correct it, or give more items")
            items = most if items is None else items
            if not rows:
                raise BadInput("pairs is empty; list at least one pair")
        elif items is None:
            raise BadInput("give items, how many there are")
        elif cost is not None and not callable(cost):
            raise BadInput("cost is a function cost(i, j); a list of costs goes with a list of "
                           "pairs")
        self.items = items + (against or 0)
        if with_self:
            self.alone |= (set(range(self.items)) if self.list is None else
                           {x for pair in self.list for x in pair})
        self.with_self = with_self
        self.kind = (f"{items} against {against}" if against is not None else
                     f"beyond {done_items}" if done_items is not None else
                     "listed" if pairs is not None else "all") + (" alone" if with_self else "")
        self.cost: Optional[Callable[[int, int], float]] = None
        if costs is not None:
            by_pair = costs
            self.cost = lambda i, j: by_pair[i, j]
        elif cost is not None:
            self.cost = _checked_cost(cost)
        self.size = sizes_of(sizes, self.items, sizes_are)
        self.room, self.memory = room, memory
        self.place = (self._bytes(overlap) if room is None else  # for a plan
                      {"room": room - 1 if overlap else room})
        if self.count > _most_pairs and not any_count:
            raise ImpossibleParameters(
                f"{self.count} pairs are too many to be handed out one by one; group items into "
                "larger ones, and have compute() do the pairs of two groups")

    def _bytes(self, overlap: bool) -> Dict[str, Any]:
        """The memory for a plan: with overlap the bytes of the largest item stay free."""
        assert self.size is not None and self.memory is not None
        bytes_of = [self.size(x) for x in range(self.items)]
        spare = 0
        if overlap:
            needed = (range(self.items) if self.list is None else
                      {x for pair in self.list for x in pair} | self.alone)
            spare = max((bytes_of[x] for x in needed), default=0)
            two = (sum(sorted(bytes_of)[-2:]) if self.list is None else
                   max((bytes_of[i] + bytes_of[j] for i, j in self.list), default=0))
            if two + spare > self.memory:
                raise BadInput(f"memory: overlap keeps {spare} bytes for what is loading, beside "
                               f"two items of {two} bytes; give {two + spare} or more")
        return {"sizes": [[str(x), str(each)] for x, each in enumerate(bytes_of)],
                "memory": self.memory - spare}

    @property
    def count(self) -> int:
        if self.list is not None:
            return len(self.list) + len(self.alone)
        if self.asked["against"] is not None:
            against = int(self.asked["against"])
            return (self.items - against) * against + len(self.alone)
        done = self.asked["done_items"] or 0
        return (self.items * (self.items - 1) - done * (done - 1)) // 2 + len(self.alone)

    def journal_name(self, name: str) -> Dict[str, Any]:
        listed = None if self.list is None else self.list + [(x, x) for x in self.alone]
        return name_of_job(self.items, listed, self.kind, name)

    def shares(self, workers: int) -> Tuple[List[Run], int]:
        """The load order of each worker as a run, and the bound on the loads of all workers."""
        ends = None
        if self.list is not None:
            ends = ends_of(iter(self.list))
            for x in self.alone:
                ends.extend((x, x))
        seconds = None if ends is None else min(5.0, max(0.05, len(ends) / 4000))
        asked = {**self.asked, **self.place, "workers": workers if workers > 1 else None}
        core = _plan(asked, ends, seconds)
        shares = [Run(trimmed(steps), self.cost) for steps in self._steps(core)]
        planned = sum(run.pairs for run in shares)
        if planned != self.count:
            raise InternalError(f"{planned} of {self.count} pairs are planned: this is a bug")
        return shares, json.loads(core.head())["lower_bound"] if workers <= 1 else 0

    def _steps(self, core: Any) -> Iterator[List[Step]]:
        alone = set(self.alone)
        current: List[Step] = []
        number = 0
        for worker, evict, load, pairs in core.work():
            if worker != number:
                yield current
                current, number = [], worker
            ends = array("I")
            for x in load:
                if x in alone:
                    alone.discard(x)
                    ends.extend((x, x))
            ends.frombytes(pairs)
            current.append(step_of(evict, load, ends, self.cost))
        yield current


def _pairs_within(groups: Any) -> Set[Pair]:
    """The pairs of items within each group, every pair once."""
    pairs: Set[Pair] = set()
    for group in rows_of("groups", "groups of items", groups):
        items = sorted({item_number("groups", item)
                        for item in listed("groups", "groups of items", group)})
        pairs.update(itertools.combinations(items, 2))
        if len(pairs) > _most_pairs:
            raise ImpossibleParameters(
                f"groups want more than {_most_pairs} pairs, too many to be handed out one by one; "
                "give smaller groups")
    if not pairs:
        raise BadInput("groups has no pair; give groups of two items or more")
    return pairs


def _plan(asked: Dict[str, Any], ends: Optional[array[int]],
          seconds: Optional[float] = None) -> Any:
    limits = {} if seconds is None else {"seconds": seconds}
    return _core.Loads.planned(
        json.dumps({**asked, **limits}), None if ends is None else ends.tobytes(), None)


def _costs_of(rows: List[Pair], cost: Any) -> Dict[Pair, float]:
    given = [_number(each) for each in listed("cost", "a number for each pair", cost)]
    if len(given) != len(rows):
        raise BadInput(f"cost has {count_of(len(given), 'number')} for "
                       f"{count_of(len(rows), 'pair')}; give one for each")
    costs: Dict[Pair, float] = {}
    for (i, j), each in zip(rows, given):
        pair = (min(i, j), max(i, j))
        costs[pair] = max(each, costs.get(pair, 0.0))
    return costs


def _number(value: Any) -> float:
    try:
        number = float(value)
    except Exception:
        number = math.nan
    if not 0 <= number <= _most_cost:
        raise BadInput(f"cost has numbers from 0 to {_most_cost:g}, not {_core.quoted(str(value))}")
    return number


def _checked_cost(cost: Callable[[int, int], Any]) -> Callable[[int, int], float]:
    def call(i: int, j: int) -> float:
        return _number(_called("cost", cost, i, j))
    return call


def _called(name: str, function: Callable[..., Any], *items: int) -> Any:
    try:
        return function(*items)
    except Exception as fault:
        raise failed(Failure.of(name, items, fault), "") from fault


def sizes_of(sizes: Any, items: int, argument: str = "sizes") -> Optional[Callable[[int], int]]:
    """The bytes of an item: one number for all, a list, a mapping by item, or a function."""
    if sizes is None:
        return None
    if callable(sizes):
        return lambda x: _size(argument, _called("sizes", sizes, x))
    if isinstance(sizes, float) or (
            hasattr(type(sizes), "__index__") and not hasattr(type(sizes), "__iter__")):
        size = _size(argument, sizes)
        return lambda x: size
    if leads_from_keys(sizes):
        by_item = {item_number(argument, x): _size(argument, size) for x, size in sizes.items()}
        lacks = next((x for x in range(items) if x not in by_item), None)
        if lacks is not None:
            raise BadInput(f"{argument} has nothing for item {lacks}; give one for each")
        return by_item.__getitem__
    given = [_size(argument, each)
             for each in listed(argument, "the bytes of each item", sizes)]
    if len(given) != items:
        raise BadInput(f"{argument} has {count_of(len(given), 'number')} for "
                       f"{count_of(items, 'item')}; give one for each")
    return given.__getitem__


def _size(argument: str, value: Any) -> int:
    try:
        size = operator.index(value)
    except Exception:
        size = -1
    if size < 0:
        raise BadInput(
            f"{argument} has whole numbers of bytes, not {_core.quoted(words_of(value))}")
    return size


def planned_bytes(runs: Iterable[Run], size: Callable[[int], int]) -> int:
    total = 0
    for run in runs:
        total += sum(size(x) for x in run.hold)
        total += sum(size(x) for step in run for x in step.load)
    return total


class Work:
    """One job in progress: the pairs that are done, and the receiver of results."""

    def __init__(self, wanted: Wanted, sink: Optional[Callable[[int, int, Any], Any]],
                 retries: int, journal: str, name: str) -> None:
        self.wanted = wanted
        self._sink = sink
        self._retries = retries
        self._tries: Dict[Tuple[Any, ...], int] = {}
        self.done = PairSet(wanted.items)
        self._journal = Journal(journal, wanted.journal_name(name)) if journal else None
        if self._journal is not None:
            for i, j in self._journal.done():
                self.done.add(i, j)
        self.resumed = self.done.count
        self.sink_seconds = 0.0

    @property
    def left(self) -> int:
        return self.wanted.count - self.done.count

    def close(self) -> None:
        if self._journal is not None:
            self._journal.close()

    # Plans

    def first_shares(self, workers: int) -> Tuple[List[List[Run]], int]:
        """A run for each worker for the remaining pairs, and a bound on the loads if it is known.
        """
        shares, bound = self.wanted.shares(workers)
        if not self.resumed:
            return [[run] for run in shares], bound
        rest = [without(run, lambda i, j: (i, j) in self.done, self.wanted.cost)
                for run in shares]
        return self.replan([run for run in rest if run], workers, min_fragments=1), 0

    def replan(self, runs: List[Run], workers: int, min_fragments: int = 3) -> List[List[Run]]:
        """The pairs of these runs for another number of workers: the runs cut again, or a new
        order, whichever has fewer loads."""
        shares = cut_evenly(runs, workers)
        if len(runs) < min_fragments or sum(run.pairs for run in runs) > _few_pairs:
            return shares
        if any(run.losses > 2 for run in runs):  # What makes workers fail is kept apart.
            return shares
        anew = self._order_of(_pairs_of(shares), workers)
        old = sum(loads_in_turn(share) for share in shares)
        return anew if sum(loads_in_turn(share) for share in anew) < old else shares

    def _order_of(self, pairs: List[Pair], workers: int) -> List[List[Run]]:
        alone = {i for i, j in pairs if i == j}
        asked = {"items": self.wanted.items, **self.wanted.place,
                 "workers": workers if workers > 1 else None}
        core = _plan(asked, ends_of(iter(pairs)), _replan_seconds)
        part = object.__new__(Wanted)
        part.alone, part.cost = alone, self.wanted.cost
        return [[run] for run in
                (Run(trimmed(steps), part.cost) for steps in part._steps(core)) if run]

    def again(self, stretch: Stretch, losses: int, after: int) -> Run:
        return Run.of(stretch, self.wanted.cost, losses, after)

    # Results

    def deliver(self, stretch: Stretch, worker: str, outcome: Outcome) -> int:
        """Passes each result to the sink once, and returns how many pairs are settled."""
        begin = time.perf_counter()
        for (i, j), sent in zip(stretch.each_pair(), outcome.results):
            if not self.done.add(i, j):
                continue  # Of a copy that was ready first.
            if self._sink is not None:
                try:
                    result = unpacked_result(sent)
                except Exception as fault:
                    raise failed(Failure.of("result", (i, j), fault), worker) from fault
                try:
                    self._sink(i, j, result)
                except Exception as fault:
                    raise failed(Failure.of("sink", (i, j), fault), "") from fault
            if self._journal is not None:
                self._journal.record(i, j)
        if self._journal is not None:
            self._journal.checkpoint()
        self.sink_seconds += time.perf_counter() - begin
        if outcome.failure is not None:
            key = (outcome.failure.what, *outcome.failure.items)
            self._tries[key] = self._tries.get(key, 0) + 1
            if self._tries[key] > self._retries:
                raise failed(outcome.failure, worker)
        return len(outcome.results)


def _pairs_of(shares: List[List[Run]]) -> List[Pair]:
    return [pair for share in shares for run in share for step in run
            for pair in zip(step.ends[::2], step.ends[1::2])]


def cut_evenly(runs: List[Run], workers: int) -> List[List[Run]]:
    """The same sequence in `parts` parts of about equal cost."""
    left = sum(run.cost for run in runs)
    queue = list(reversed(runs))
    shares: List[List[Run]] = []
    for part in range(workers, 0, -1):
        share: List[Run] = []
        spent, wanted = 0.0, left / part
        while queue and (part == 1 or spent < wanted):
            run = queue.pop()
            if part > 1 and run.cost > 1.25 * (wanted - spent):
                rest = run.split(run.cost - (wanted - spent))
                if not run:  # It cannot be cut so early.
                    if share:
                        queue.append(rest)
                        break
                    run = rest
                elif rest:
                    queue.append(rest)
            share.append(run)
            spent += run.cost
        left -= spent
        if share:
            shares.append(share)
    return shares
