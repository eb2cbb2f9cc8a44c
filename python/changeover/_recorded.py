"""The pickled form of load orders whose making took a search."""

from __future__ import annotations

import io
import itertools
import json
from array import array
from typing import Any, Dict, Iterable, Iterator, List, NamedTuple, Optional, Set, Tuple

from . import _core
from .errors import BadInput

Step = Tuple[List[int], List[int]]
PairBytes = List[List[Tuple[bytes, bytes]]]


def _bytes_of(pairs: Iterable[Tuple[int, int]]) -> bytes:
    return array("I", itertools.chain.from_iterable(pairs)).tobytes()


def _pairs_of(ends: bytes) -> List[Tuple[int, int]]:
    items = array("I", ends)
    return list(zip(items[::2], items[1::2]))


class Asked(NamedTuple):
    """What an order is the answer to: the request, the items of listed pairs as bytes, and the room
    on the accelerator."""

    request: Dict[str, Any]
    ends: Optional[bytes]
    fast_room: Optional[int]


class Recorded:
    """The pickled form of an order that took a search: its steps as they were written. `counts` is
    how many of them load, by worker: where changed items are stored, one more may only store.
    `pairs` is what work() has and the text has not, or in another order: by worker and step, the
    bytes of the items of pairs and of overlap."""

    def __init__(self, asked: Asked, text: str, counts: Tuple[int, ...],
                 pairs: Optional[PairBytes]) -> None:
        self._asked = asked
        self._text = text
        self._counts = counts
        self._pairs = pairs

    @classmethod
    def of(cls, core: Any, about: Asked) -> Recorded:
        if isinstance(core, cls):
            return core
        asked = about.request
        workers = range(asked.get("workers", 1))
        counts = tuple(sum(1 for _ in core.steps(worker)) for worker in workers)
        pairs = None
        are_written = asked.get("new_pairs") or asked.get("prefetch")
        if (asked.get("write_back") and not are_written) or asked.get("shuffle"):
            pairs = [[(_bytes_of(step[5]), _bytes_of(step[6])) for step in core.full_steps(worker)]
                     for worker in (workers if "workers" in asked else (None,))]
        return cls(about, core.in_format("jsonl"), counts, pairs)

    def state(self) -> Tuple[str, Tuple[int, ...], Optional[PairBytes]]:
        return self._text, self._counts, self._pairs

    def in_format(self, format: str) -> str:
        if format == "jsonl":
            return self._text
        asked = self._asked.request
        # Which of several workers computes a pair that several have is not found again.
        is_split = "workers" in asked and not asked.get("disjoint")
        if is_split and not asked.get("new_pairs"):
            raise BadInput("this order from a pickle does not have the pairs of each worker; plan "
                           "it again, with new_pairs=True")
        text: str = _core.recorded_in_format(
            json.dumps(asked), self._asked.ends, self._asked.fast_room,
            self._as_written(), is_split, format)
        return text

    def fault(self) -> str:
        return ""

    def _lines(self, worker: Optional[int]) -> Iterator[Dict[str, Any]]:
        for line in itertools.islice(io.StringIO(self._text), 1, None):
            step = json.loads(line)
            if worker is None or step.get("worker", 0) == worker:
                yield step

    def _as_written(self) -> Iterator[Tuple[Any, ...]]:
        for step in itertools.islice(self._lines(None), sum(self._counts)):
            yield (step["step"], step.get("worker", 0), step["evict"], step["load"], [],
                   step.get("new_pairs", []), [], 0, step.get("epoch", 1),
                   step.get("fast_evict", []), step.get("fast_load", []))

    def steps(self, worker: int) -> Iterator[Step]:
        return ((step["evict"], step["load"])
                for step in itertools.islice(self._lines(worker), self._counts[worker]))

    def steps_from(self, number: int) -> Iterator[Step]:
        memory: Set[int] = set()
        for step in itertools.islice(self._lines(None), self._counts[0]):
            memory.difference_update(step["evict"])
            memory.update(step["load"])
            if step["step"] == number:
                yield [], sorted(memory)
            elif step["step"] > number:
                yield step["evict"], step["load"]

    def full_steps(self, worker: Optional[int]) -> Iterator[Tuple[Any, ...]]:
        for number, step in enumerate(self._lines(worker)):
            late = step.get("evict_late", [])
            first = step.get("evict_first", step["evict"])
            pairs: List[Any]
            overlap: List[Any]
            if self._pairs is None:
                pairs = [tuple(pair) for pair in step.get("new_pairs", step.get("before", []))]
                overlap = [tuple(pair) for pair in step.get("compute", [])]
            else:
                pairs, overlap = map(_pairs_of, self._pairs[worker or 0][number])
            yield (step["step"], step.get("worker", 0), first + late, step["load"],
                   step.get("store", []), pairs, overlap, len(late), step.get("epoch", 1),
                   step.get("fast_evict", []), step.get("fast_load", []))
