"""Load orders: items into memory such that every pair meets there, and the executor that goes by
them."""

from __future__ import annotations

import importlib
import itertools
import json
import operator
from array import array
from typing import (
    Any, Callable, Iterable, Iterator, List, Optional, SupportsIndex, Tuple, Union, overload)

from . import _core
from ._given import listed, rows_of, words_of
from ._made import Made, Progress, check_calls, fact, made
from ._notebook import shown, table
from .errors import BadInput

Step = Tuple[List[int], List[int]]
_most_items: int = _core.most_items


class LoadOrder(Made):
    """Steps (evict, load), lists of item numbers, after which every pair was in memory together."""

    items: int = fact()
    room: int = fact()
    loads: int = fact("All loads, the first ones included.")
    steps: int = fact()
    lower_bound: int = fact("No order has fewer loads.")
    reason: str = fact("Of the bound.")
    method: str = fact()
    certificate: str = fact("How it was verified, one line.")

    def to_json(self) -> str:
        """changeover-loads/1: an object for the order, then one for each step, a line each."""
        text: str = self._core.to_json()
        return text

    def to_frame(self) -> Any:
        """A pandas.DataFrame with one row for each step. Raises ImportError without pandas."""
        pandas: Any = importlib.import_module("pandas")
        frame = pandas.DataFrame(list(self), columns=["evict", "load"])
        frame.index = pandas.RangeIndex(1, len(frame) + 1, name="step")
        return frame

    def _repr_html_(self) -> str:
        most_shown = 20
        first = itertools.islice(self, most_shown)
        return shown(
            f"{self.loads} loads for {self.items} items, room for {self.room}",
            [f"at least {self.lower_bound} loads: {self.reason}", self.certificate],
            table(("step", "evict", "load"),
                  ((number, *step) for number, step in enumerate(first, 1))),
            f"<div>{most_shown} of {self.steps} steps</div>\n" if self.steps > most_shown else "")

    def __iter__(self) -> Iterator[Step]:
        steps: Iterator[Step] = self._core.steps(0)
        return steps

    def __len__(self) -> int:
        return self.steps

    def __repr__(self) -> str:
        return f"<LoadOrder: {self.loads} loads for {self.items} items, room for {self.room}>"


class WorkerLoads(Made):
    """A load order for several workers: steps (evict, load) of each, after which every pair was in
    the memory of one of them together."""

    items: int = fact()
    room: int = fact()
    loads: int = fact("Of all workers together.")
    worker_loads: List[int] = fact("Of each worker.")
    makespan: int = fact("The loads of the worker that has most.")
    makespan_bound: int = fact("However it is split, some worker has so many.")
    reason: str = fact("Of that bound.")
    certificate: str = fact("How it was verified, one line.")

    def to_json(self) -> str:
        """changeover-loads/1: an object for all workers, then one for each step, a line each."""
        text: str = self._core.to_json()
        return text

    def steps(self, worker: int) -> Iterator[Step]:
        """The steps of one worker, from 0."""
        if worker >= len(self):
            raise IndexError(f"there are {len(self)} workers")
        steps: Iterator[Step] = self._core.steps(worker)
        return steps

    def __len__(self) -> int:
        return len(self.worker_loads)

    def __repr__(self) -> str:
        return f"<WorkerLoads: {len(self)} workers, the busiest has {self.makespan} loads>"


class Report(Made):
    """What an out-of-core job did."""

    finished: bool = fact()
    steps: int = fact()
    steps_resumed: int = fact("Done by an earlier run, as the journal says.")
    loads: int = fact()
    bytes_read: int = fact()
    pairs: int = fact("Calls of compute().")
    most_in_memory: int = fact("Items.")


def _item(number: Any) -> int:
    item = operator.index(number)
    if not 0 <= item < _most_items:
        shown = _core.quoted(words_of(item))
        raise BadInput(f"pairs: items are numbered from 0 to {_most_items - 1}, not {shown}")
    return item


def _ends(pairs: Any) -> array[int]:
    """Both items of each pair, one after the other."""
    ends = array("I")
    for number, row in enumerate(rows_of("pairs", "rows of two items", pairs)):
        more = iter(listed("pairs", "rows of two items", row))
        for _ in range(2):
            for item in more:
                ends.append(_item(item))
                break
            else:
                raise BadInput(f"pairs: row {number} has fewer than two items; a pair has two")
        for _ in more:
            raise BadInput(f"pairs: row {number} has more than two items; a pair has two")
    return ends


@overload
def load_order(
    items: Optional[int], room: int, *, pairs: Optional[Iterable[Iterable[SupportsIndex]]] = None,
    against: Optional[int] = None, done_items: Optional[int] = None, workers: None = None,
    time: Optional[float] = None, threads: int = 1, seed: int = 1, progress: Progress = None,
) -> LoadOrder: ...
@overload
def load_order(
    items: Optional[int], room: int, *, pairs: Optional[Iterable[Iterable[SupportsIndex]]] = None,
    against: Optional[int] = None, done_items: Optional[int] = None, workers: int,
    time: Optional[float] = None, threads: int = 1, seed: int = 1, progress: Progress = None,
) -> WorkerLoads: ...


def load_order(
    items: Optional[int], room: int, *, pairs: Any = None, against: Optional[int] = None,
    done_items: Optional[int] = None, workers: Optional[int] = None, time: Optional[float] = None,
    threads: int = 1, seed: int = 1, progress: Progress = None,
) -> Union[LoadOrder, WorkerLoads]:
    """An order of loads after which every pair of `items` items was in memory together, with room
    for `room`; `time` seconds of search for a better one. Verified. Iterating gives steps (evict,
    load).

    pairs: only these must meet, rows of two item numbers, a NumPy array of shape (n, 2), too; items
    may then be None. against: each of the items with each of so many others, numbered after them.
    done_items: the pairs of the first so many have met before. workers: split it for so many, which
    gives WorkerLoads. Raises BadInput, ImpossibleParameters.
    """
    if sum(each is not None for each in (pairs, against, done_items)) > 1:
        raise BadInput("give one of pairs, against and done_items")
    if items is None and pairs is None:
        raise BadInput("give items, how many there are")
    if time is not None and not 0 <= time <= 1e9:
        raise ValueError("time is a number of seconds, 0 or more")
    asked = {"items": items, "room": room, "against": against, "done_items": done_items,
             "workers": workers}
    ends = None if pairs is None else _ends(pairs)
    core, facts = _core.load_order(
        json.dumps(asked), None if ends is None else ends.tobytes(), time, threads, seed, progress)
    if workers is None:
        return made(LoadOrder, facts, core)
    return made(WorkerLoads, facts, core)


def all_pairs(
    path: str, item_bytes: int, room: int,
    compute: Callable[[int, int, memoryview, memoryview], object], *, header_bytes: int = 0,
    threads: int = 1, journal: str = "",
) -> Report:
    """Runs an all-pairs job over a file of items of item_bytes each, never more than `room` of them
    in memory.

    compute(i, j, first, second) is called once for each pair i < j and for each item with itself (i
    = j), with read-only memoryviews that end with the call; what is made of them (slices, arrays)
    stays as it is, and keeps the item in memory beyond the room. With a journal a job that was
    ended goes on where it was. What compute raises ends the job. Raises BadInput, MissingResource.
    """
    return made(Report,
                _core.all_pairs(path, item_bytes, room, compute, header_bytes, threads, journal))


check_calls(globals())
