"""Stretches: parts of a load order that any worker can do, cut by the pairs that they compute."""

from __future__ import annotations

import collections
import dataclasses
import itertools
from array import array
from typing import (
    Any, Callable, Deque, Dict, Iterable, Iterator, List, NamedTuple, Optional, Tuple)

Items = Tuple[int, ...]
Cost = Callable[[int, int], float]


class Step(NamedTuple):
    """Evictions, then loads, then computed pairs: the items of the pairs in turn."""

    evict: Items
    load: Items
    ends: array[int]
    cost: float


@dataclasses.dataclass(frozen=True)
class Stretch:
    """The message to a worker."""

    number: int
    hold: Items  # must be in memory at the start
    keep: Items  # is not dropped if it is there: the worker needs it again later
    steps: Tuple[Tuple[Items, Items, array[int]], ...]
    pairs: int
    cost: float
    loads: int  # of a worker whose memory is empty
    sizes: Optional[Dict[int, int]] = None  # the bytes of what it loads, if they are known

    def with_sizes(self, size: Callable[[int], int]) -> Stretch:
        every = itertools.chain(self.hold, *(load for _, load, _ in self.steps))
        return dataclasses.replace(self, sizes={x: size(x) for x in every})

    def each_pair(self) -> Iterator[Tuple[int, int]]:
        for _, _, ends in self.steps:
            yield from zip(ends[::2], ends[1::2])


def held_at_start(steps: Iterable[Any]) -> set[int]:
    """The items that are used before they are loaded."""
    needed: set[int] = set()
    loaded: set[int] = set()
    for step in steps:
        loaded.update(step[1])
        needed.update(set(step[2]) - loaded)
    return needed


def trimmed(steps: Iterable[Step]) -> List[Step]:
    """The same pairs, with items loaded when they are first needed and evicted after their last
    use. Stays that bring no pair are left out."""
    given = list(steps)
    come: dict[int, List[int]] = {}
    go: dict[int, List[int]] = {}
    stays: dict[int, int] = {}  # item: where it was used last, or -1
    for place, step in enumerate(given):
        for x in step.evict:
            last = stays.pop(x, -1)
            if last >= 0:
                go.setdefault(last + 1, []).append(x)
        for x in step.load:
            stays[x] = -1
        for x in dict.fromkeys(step.ends):
            if stays[x] < 0:
                come.setdefault(place, []).append(x)
            stays[x] = place
    made: List[Step] = []
    gone: List[int] = []
    for place, step in enumerate(given):
        gone += go.get(place, [])
        if step.ends:
            made.append(Step(tuple(gone), tuple(come.get(place, ())), step.ends, step.cost))
            gone = []
    return made


class Run:
    """Consecutive steps, from whose front stretches are taken, and which can be cut in two."""

    def __init__(self, steps: Iterable[Step], cost: Optional[Cost] = None,
                 losses: int = 0) -> None:
        self.losses = losses  # so many workers were lost while they had it
        self._steps: Deque[Step] = collections.deque(step for step in steps if step.ends)
        self._cost_of = cost
        self.cost = sum(step.cost for step in self._steps)
        self._held = held_at_start(self._steps)  # before the next step, as planned

    @classmethod
    def of(cls, stretch: Stretch, cost: Optional[Cost], losses: int, after: int = 0) -> Run:
        """The same without the first pairs."""
        steps: List[Step] = []
        for evict, load, ends in stretch.steps:
            rest = ends[2 * after:]
            after = max(0, after - len(ends) // 2)
            steps.append(step_of(evict, load, rest, cost))
        if steps:
            steps[0] = steps[0]._replace(load=(*stretch.hold, *steps[0].load))
        return cls(trimmed(steps), cost, losses)

    def __bool__(self) -> bool:
        return bool(self._steps)

    def __iter__(self) -> Iterator[Step]:
        return iter(self._steps)

    @property
    def pairs(self) -> int:
        return sum(len(step.ends) // 2 for step in self._steps)

    @property
    def loads(self) -> int:
        return len(held_at_start(self._steps)) + sum(len(step.load) for step in self._steps)

    @property
    def hold(self) -> set[int]:
        return held_at_start(self._steps)

    def loads_to_begin(self, held: frozenset[int]) -> int:
        """The items that a worker that holds these must load before the first step."""
        return len(self.hold - held)

    def loads_to_split(self, cost: float, held: frozenset[int]) -> int:
        """The same for the part at the end with about this cost."""
        tail: Deque[Step] = collections.deque()
        for step in reversed(self._steps):
            tail.appendleft(step)
            cost -= step.cost
            if cost <= 0:
                break
        return len(held_at_start(tail) - held)

    def take(self, number: int, cost: float) -> Stretch:
        """A stretch from the front with about this cost; at least one pair."""
        taken: List[Step] = []
        spent = 0.0
        while self._steps and (not taken or spent < cost):
            step = self._steps[0]
            if spent + step.cost > 1.25 * cost and len(step.ends) > 2:
                first, rest = self._halves(step, cost - spent, 0 if taken else 1)
                if not first.ends:
                    break
                self._steps[0] = rest
                taken.append(first)
                spent += first.cost
                break
            taken.append(self._steps.popleft())
            spent += step.cost
        self.cost = self.cost - spent if self._steps else 0.0
        keep = self._held - set(taken[0].evict if taken else ())
        for step in taken:
            self._held.difference_update(step.evict)
            self._held.update(step.load)
        return _stretch(number, taken, spent, keep)

    def split(self, cost: float) -> Run:
        """Cuts off a part at the end with about this cost; either side may then be empty."""
        cut: Deque[Step] = collections.deque()
        spent = 0.0
        while self._steps and spent < cost:
            step = self._steps[-1]
            if spent + step.cost > 1.25 * cost and len(step.ends) > 2:
                first, rest = self._halves(step, step.cost - (cost - spent), 0)
                if rest.ends:
                    self._steps[-1] = first
                    cut.appendleft(rest)
                    spent += rest.cost
                    if not first.ends:
                        self._steps.pop()
                break
            cut.appendleft(self._steps.pop())
            spent += step.cost
        self.cost = self.cost - spent if self._steps else 0.0
        return Run(cut, self._cost_of, self.losses)

    def _halves(self, step: Step, cost: float, least: int) -> Tuple[Step, Step]:
        pairs = len(step.ends) // 2
        if self._cost_of is None:
            count = min(pairs, max(least, round(cost)))
        else:
            count, spent = 0, 0.0
            while count < pairs and (count < least or spent < cost):
                spent += self._cost_of(step.ends[2 * count], step.ends[2 * count + 1])
                count += 1
        first, rest = step.ends[:2 * count], step.ends[2 * count:]
        spent = _cost_of(first, self._cost_of)
        return (Step(step.evict, step.load, first, spent),
                Step((), (), rest, step.cost - spent))


def _cost_of(ends: array[int], cost: Optional[Cost]) -> float:
    if cost is None:
        return len(ends) / 2
    return sum(cost(i, j) for i, j in zip(ends[::2], ends[1::2]))


def step_of(evict: Iterable[int], load: Iterable[int], ends: array[int],
            cost: Optional[Cost]) -> Step:
    return Step(tuple(evict), tuple(load), ends, _cost_of(ends, cost))


def _stretch(number: int, steps: List[Step], cost: float, keep: set[int]) -> Stretch:
    hold = held_at_start(steps)
    first_evict = (steps[0]._replace(evict=()), *steps[1:]) if steps else ()
    return Stretch(number, tuple(sorted(hold)), tuple(sorted(keep)),
                   tuple(step[:3] for step in first_evict),
                   sum(len(step.ends) for step in steps) // 2, cost,
                   len(hold) + sum(len(step.load) for step in steps))


def loads_in_turn(runs: Iterable[Run]) -> int:
    """The loads of one worker that does them in sequence, starting with an empty memory."""
    held: set[int] = set()
    loads = 0
    for run in runs:
        hold = run.hold
        loads += len(hold - held)
        held = hold
        for step in run:
            held = held - set(step.evict)
            loads += len(set(step.load) - held)
            held.update(step.load)
    return loads


def without(run: Run, is_done: Callable[[int, int], bool], cost: Optional[Cost]) -> Run:
    """The pairs that are not done; items that no other pair needs are not loaded."""
    steps: List[Step] = []
    hold = run.hold
    for step in run:
        ends = array("I")
        for i, j in zip(step.ends[::2], step.ends[1::2]):
            if not is_done(i, j):
                ends.extend((i, j))
        load = step.load if steps else tuple(dict.fromkeys((*sorted(hold), *step.load)))
        steps.append(step_of(step.evict if steps else (), load, ends, cost))
    return Run(trimmed(steps), cost)
