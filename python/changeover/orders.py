"""Load orders, which bring items into memory such that every pair meets there, and their executors.
"""

from __future__ import annotations

import importlib
import json
import operator
import pickle
import zlib
from array import array
from typing import (
    Any, Callable, Dict, Iterable, Iterator, List, NamedTuple, Optional, Set, Tuple, Union, overload,
)

from . import _core
from ._given import Path, file_name, in_bytes, listed, of_search, share_of
from ._made import (
    Made, Progress, check_calls, count_of, fact, fact_names, frozen, in_a_line, made)
from ._notebook import Prose, Shown
from ._pairs_given import cost_rows, given_ends, group_rows, memory_of, size_rows
from ._recorded import Asked, Recorded, Step
from .errors import BadInput, InternalError
from .pictures import Picture, Theme, stays_of



class WorkStep(NamedTuple):
    """A step with everything that was requested; other members are empty. In this order: the items
    of `evict` leave memory, except the last `late` of them; `store` names the evicted items that
    have changed and are written back before; the items of `load` are loaded; `pairs` are computed.
    With prefetch the next loads begin then, `overlap` is computed while they run, and the late
    items of the next step leave when it is over. With two levels `fast_evict` leave the accelerator
    first, and `fast_load` are transferred to it before `pairs` are computed there."""

    number: int
    worker: int
    evict: List[int]
    load: List[int]
    store: List[int]
    pairs: List[Tuple[int, int]]
    overlap: List[Tuple[int, int]]
    late: int
    epoch: int
    fast_evict: List[int] = []
    fast_load: List[int] = []

    def __hash__(self) -> int:
        return hash(frozen(tuple(self)))


def _made_again(kind: Any, state: bytes, checksum: int) -> Any:
    """The content of pickles: the request, or the steps if making them took a search."""
    if zlib.crc32(state) != checksum:
        raise BadInput(f"this pickle of a {kind.__name__} is damaged; create it again")
    facts, asked, ends, text = pickle.loads(state)
    if isinstance(text, str):
        raise BadInput("another version of changeover pickled this load order; create it again")
    core: Any = None if text is None else Recorded(Asked(asked, ends, facts["fast_room"]), *text)
    if core is None:
        core = _core.Loads.planned(json.dumps({**asked, "verify_beside": False}), ends, None)
        again = _facts(core, kind)
        # One that is verified beside the work is read at once when it is made again.
        if {**again, "certificate": ""} != {**facts, "certificate": ""}:
            raise BadInput("another version of changeover pickled this load order, and made "
                           "another one; create it again")
        facts = again
    return made(kind, {**facts, "_asked": (asked, ends, text is not None)}, core)


def _facts(core: Any, kind: Any) -> Dict[str, Any]:
    """What the first line of the document says, under the names that it has in Python."""
    head: Dict[str, Any] = json.loads(core.head())
    said = {**head, "certificate": head["verified"], "bytes": head.get("bytes_loaded"),
            "reason": head.get("makespan_bound_reason", head["lower_bound_reason"]),
            "steps": head["steps"] - ("stores" in head)}  # without the one that only stores
    return {name: said.get(name) for name in fact_names(kind)}


def _panel(headline: str, note: str, items: int, steps: Iterable[Step]
           ) -> Tuple[str, str, List[str], List[List[int]]]:
    """What is in memory after each step, for stays_of()."""
    memory: Set[int] = set()
    held = []
    for evict, load in steps:
        memory.difference_update(evict)
        memory.update(load)
        held.append(sorted(memory))
    return headline, note, list(map(str, range(items))), held


class _Loads(Shown, Made):
    """Shared by both kinds."""

    _most_rows = 20

    items: int = fact("How many there are.")
    room: int = fact("Of items with sizes the most that fit.")
    method: str = fact("How the order was made, by name.")
    certificate: str = fact("How it was verified, one line.")
    fast_room: Optional[int] = fact("Of two levels: the most items on the accelerator.")
    transfers: Optional[int] = fact("To the accelerator, of all workers together.")
    transfer_bound: Optional[int] = fact("No order transfers fewer items.")
    bytes_transferred: Optional[int] = fact("If items have sizes.")
    transfer_bytes_bound: Optional[int] = fact("No order transfers fewer bytes.")

    def to_json(self) -> str:
        """changeover-loads/1: an object for the order, then one for each step, one per line."""
        text: str = self._core.in_format("jsonl")
        return text

    def _panels(self) -> List[Tuple[str, str, List[str], List[List[int]]]]:
        raise NotImplementedError

    def _size(self) -> int:
        """No fewer than the steps."""
        raise NotImplementedError

    def draw(self, *, theme: Theme = "light") -> Picture:
        """A picture of the memory: a row for each item, a bar for each time that it is there, step
        by step; workers below each other. Raises BadInput if it would be too large."""
        most_items, most_steps = 2_000, 20_000
        if self.items > most_items or self._size() > most_steps:
            raise BadInput(f"a picture has at most {most_items} items and {most_steps} steps")
        return stays_of([panel for panel in self._panels() if panel[3]], "item", "step", theme)

    def _repr_svg_(self) -> Optional[str]:
        most_items, most_steps = 60, 500
        if self.items > most_items or self._size() > most_steps:
            return None
        return self.draw().svg

    def _picture(self) -> str:
        return self._repr_svg_() or ""

    def verified(self) -> bool:
        """True when all steps have been read and are right; with verify_beside it waits until they
        are. Raises InternalError if they are wrong."""
        fault = self._core.fault()
        if fault:
            raise InternalError(fault)
        return True

    def for_colmap(self) -> str:
        """The pairs in the order of the steps, as COLMAP's match list: two items per line,
        and an empty line between steps. Raises BadInput if a pair would occur twice."""
        text: str = self._core.in_format("colmap")
        return text

    def request_json(self) -> str:
        """What was asked, as the document that `changeover loadorder --request` reads."""
        asked, ends, _ = self._facts["_asked"]
        if ends is not None:
            items = array("I", ends)
            asked = {**asked, "pairs": list(zip(items[::2], items[1::2]))}
        text: str = _core.load_request_json(json.dumps(asked))
        return text

    def _said(self) -> Any:
        facts = dict(self._facts)
        asked, ends, searched = facts.pop("_asked")
        # One that is verified beside the work says so, and is the same order.
        del facts["certificate"]
        asked = {key: value for key, value in asked.items()
                 if key not in ("seconds", "threads", "verify_beside")}
        return facts, asked, ends, self._steps_said() if searched else None

    def _steps_said(self) -> str:
        """The document without its first line."""
        return self.to_json().partition("\n")[2]

    def __reduce_ex__(self, _protocol: Any = 2) -> Any:
        facts = dict(self._facts)
        asked, ends, searched = facts.pop("_asked")
        about = Asked(asked, ends, self.fast_room)
        recorded = Recorded.of(self._core, about).state() if searched else None
        state = pickle.dumps((facts, asked, ends, recorded), 4)
        return _made_again, (type(self), state, zlib.crc32(state))


class LoadOrder(_Loads):
    """Steps (evict, load), lists of item numbers; after the last one every pair has been in memory
    together."""

    _row = "step"
    loads: int = fact("All loads, the first ones included.")
    steps: int = fact("How many there are.")
    lower_bound: int = fact("No order has fewer loads.")
    reason: str = fact("Of the bound.")
    epoch_loads: Optional[List[int]] = fact("Of each epoch, if there are several.")
    bytes: Optional[int] = fact("That are loaded, if items have sizes.")
    bytes_bound: Optional[int] = fact("No order loads fewer.")

    def for_marius(self) -> List[Dict[str, Any]]:
        """The order in the form of Marius, a dict for each epoch: `buffer_states` are the
        partitions in the buffer, state by state; `edge_buckets_per_buffer` the buckets (i, j) that
        are trained on in each, in both directions and with i = j; also `epoch`, `num_partitions`
        and `buffer_capacity`. Raises BadInput for orders with prefetch."""
        return [json.loads(line) for line in self._core.in_format("marius").splitlines()]

    def to_frame(self) -> Any:
        """A pandas.DataFrame with one row for each step. Raises ImportError without pandas."""
        pandas: Any = importlib.import_module("pandas")
        frame = pandas.DataFrame(list(self), columns=["evict", "load"])
        frame.index = pandas.RangeIndex(1, len(frame) + 1, name="step")
        return frame

    def _panels(self) -> List[Tuple[str, str, List[str], List[List[int]]]]:
        return [_panel("Load order", repr(self)[len("<LoadOrder: "):-1], self.items, self)]

    def _size(self) -> int:
        return self.steps

    def _on_page(self) -> Any:
        lines = [Prose(f"at least {self.lower_bound} loads: {self.reason}"),
                 Prose(self.certificate)]
        return (repr(self)[len("<LoadOrder: "):-1], lines, ("step", "evict", "load"),
                ((number, *step) for number, step in enumerate(self, 1)), self.steps)

    def __iter__(self) -> Iterator[Step]:
        steps: Iterator[Step] = self._core.steps(0)
        return steps

    def steps_from(self, step: int) -> Iterator[Step]:
        """Yields the steps from number `step` on, counted from 1; the first of them loads all that
        is in memory then."""
        if not 1 <= step <= self.steps:
            raise IndexError(f"there is no step {step}; they are numbered from 1 to {self.steps}")
        steps: Iterator[Step] = self._core.steps_from(step)
        return steps

    def work(self) -> Iterator[WorkStep]:
        """The steps with the pairs that each computes and the items that it stores, if requested.
        """
        return map(WorkStep._make, self._core.full_steps(None))

    def __len__(self) -> int:
        return self.steps

    def __repr__(self) -> str:
        return (f"<LoadOrder: {count_of(self.loads, 'load')} for {count_of(self.items, 'item')}, "
                f"room for {self.room}>")


class WorkerLoads(_Loads):
    """A load order for several workers: steps (evict, load) for each; after the last one every pair
    has been together in the memory of some worker."""

    _row = "worker"
    loads: int = fact("Of all workers together.")
    worker_loads: List[int] = fact("Of each worker.")
    makespan: int = fact("The loads of the worker that has most.")
    makespan_bound: int = fact("A lower bound on makespan, for every split.")
    reason: str = fact("Of that bound.")
    worker_pairs: Optional[List[int]] = fact(
        "The pairs that each worker computes; the mean is the fewest that the fullest can have.")
    worker_costs: Optional[List[float]] = fact("What they cost, if pairs have costs.")
    span: Optional[int] = fact(
        "Of workers in lockstep: the most loads of one of them in a step, added up.")
    span_bytes: Optional[int] = fact("The same sum of bytes, if items have sizes.")
    epoch_loads: Optional[List[int]] = fact("Of all workers in each epoch, if there are several.")
    bytes: Optional[int] = fact("That all workers load, if items have sizes.")
    worker_bytes: Optional[List[int]] = fact("Of each worker.")
    makespan_bytes: Optional[int] = fact("Of the worker that loads most bytes.")
    makespan_bytes_bound: Optional[int] = fact("A lower bound on makespan_bytes, for every split.")

    def steps(self, worker: int) -> Iterator[Step]:
        """The steps of one worker, from 0."""
        self._check_worker(worker)
        steps: Iterator[Step] = self._core.steps(worker)
        return steps

    def work(self, worker: int) -> Iterator[WorkStep]:
        """The same with the pairs that each step computes and the items that it stores, if
        requested."""
        self._check_worker(worker)
        return map(WorkStep._make, self._core.full_steps(worker))

    def _check_worker(self, worker: int) -> None:
        if worker >= len(self):
            raise IndexError(f"there is no worker {worker} of {len(self)}; count from 0")

    def __len__(self) -> int:
        return len(self.worker_loads)

    def to_frame(self) -> Any:
        """A pandas.DataFrame with one row for each step of each worker. Raises ImportError without
        pandas."""
        pandas: Any = importlib.import_module("pandas")
        rows = [(worker, number, *step) for worker in range(len(self))
                for number, step in enumerate(self.steps(worker), 1)]
        frame = pandas.DataFrame(rows, columns=["worker", "step", "evict", "load"])
        return frame.set_index(["worker", "step"])

    def _panels(self) -> List[Tuple[str, str, List[str], List[List[int]]]]:
        return [_panel(f"Worker {worker}", count_of(self.worker_loads[worker], "load"), self.items,
                       self.steps(worker)) for worker in range(len(self))]

    def _size(self) -> int:
        return sum(self.worker_loads)

    def _on_page(self) -> Any:
        columns = {"loads": self.worker_loads, "bytes": self.worker_bytes,
                   "pairs": self.worker_pairs, "cost": self.worker_costs}
        known = {name: each for name, each in columns.items() if each is not None}
        lines = [Prose(f"at least {self.makespan_bound} loads: {self.reason}"),
                 Prose(self.certificate)]
        return (repr(self)[len("<WorkerLoads: "):-1], lines, ("worker", *known),
                ((w, *(each[w] for each in known.values())) for w in range(len(self))),
                len(self))

    def __repr__(self) -> str:
        return (f"<WorkerLoads: {count_of(len(self), 'worker')}, the busiest has "
                f"{count_of(self.makespan, 'load')}>")


class UpdateReport(Made):
    """The result of a job whose items change."""

    finished: bool = fact()
    steps: int = fact("Of all epochs.")
    steps_resumed: int = fact("Done by an earlier run, as the journal says.")
    loads: int = fact("How many items were loaded.")
    stores: int = fact("Of items that were evicted.")
    checkpoint_stores: int = fact("Of items that were held at checkpoints.")
    updates: int = fact("Calls of update().")
    note: str = fact("About lines of the journal that do not count, or empty.")

    def __repr__(self) -> str:
        resumed = f", {self.steps_resumed} of them earlier" if self.steps_resumed else ""
        return (f"<UpdateReport: {self.steps} steps{resumed}, {self.loads} loads, {self.stores} "
                f"stores and {self.checkpoint_stores} at checkpoints, {self.updates} updates>")


class Report(Made):
    """The result of an out-of-core job."""

    finished: bool = fact()
    steps: int = fact("How many there are.")
    steps_resumed: int = fact("Done by an earlier run, as the journal says.")
    loads: int = fact("How many items were loaded.")
    bytes_read: int = fact("Of the file.")
    pairs: int = fact("Calls of compute().")
    most_in_memory: int = fact("Items.")

    def __repr__(self) -> str:
        resumed = f", {self.steps_resumed} of them earlier" if self.steps_resumed else ""
        return (f"<Report: {'finished' if self.finished else 'not finished'}, {self.steps} steps"
                f"{resumed}, {self.loads} loads, {self.bytes_read} bytes, {self.pairs} pairs>")


@overload
def load_order(
    items: Optional[int], room: Optional[int] = None, *,
    pairs: Any = None, groups: Any = None, against: Optional[int] = None,
    done_items: Optional[int] = None, workers: None = None, disjoint: bool = False,
    write_back: bool = False, new_pairs: bool = False, prefetch: bool = False,
    ordered: bool = False, with_self: bool = False, shuffle: bool = False,
    first_holder: bool = False, pair_cost: Any = None, verify_beside: bool = False,
    epochs: Optional[int] = None, spread: bool = False, sizes: Any = None,
    memory: Union[int, str, None] = None, fast_room: Optional[int] = None,
    fast_memory: Union[int, str, None] = None, time: Optional[float] = None, threads: int = 1,
    seed: int = 1, progress: Progress = None) -> LoadOrder: ...
@overload
def load_order(
    items: Optional[int], room: Optional[int] = None, *,
    pairs: Any = None, groups: Any = None, against: Optional[int] = None,
    done_items: Optional[int] = None, workers: int, disjoint: bool = False,
    write_back: bool = False, new_pairs: bool = False, prefetch: bool = False,
    ordered: bool = False, with_self: bool = False, shuffle: bool = False,
    first_holder: bool = False, pair_cost: Any = None, verify_beside: bool = False,
    epochs: Optional[int] = None, spread: bool = False, sizes: Any = None,
    memory: Union[int, str, None] = None, fast_room: Optional[int] = None,
    fast_memory: Union[int, str, None] = None, time: Optional[float] = None, threads: int = 1,
    seed: int = 1, progress: Progress = None) -> WorkerLoads: ...


def load_order(
    items: Optional[int], room: Optional[int] = None, *,
    pairs: Any = None, groups: Any = None, against: Optional[int] = None,
    done_items: Optional[int] = None, workers: Optional[int] = None,
    disjoint: bool = False, write_back: bool = False, new_pairs: bool = False,
    prefetch: bool = False, ordered: bool = False, with_self: bool = False, shuffle: bool = False,
    first_holder: bool = False, pair_cost: Any = None, verify_beside: bool = False,
    epochs: Optional[int] = None, spread: bool = False, sizes: Any = None,
    memory: Union[int, str, None] = None, fast_room: Optional[int] = None,
    fast_memory: Union[int, str, None] = None, time: Optional[float] = None, threads: int = 1,
    seed: int = 1, progress: Progress = None,
) -> Union[LoadOrder, WorkerLoads]:
    """Returns a load order with room for `room` items, after which every pair of `items` items has
    been in memory together. Searches for a better one for `time` seconds. Verified. Iterating gives
    steps (evict, load); work() gives everything that was requested. Orders can be pickled.

    pairs: only these must meet; rows of two item numbers, or a NumPy array of shape (n, 2); `items`
    may then be None. With workers, rows may be (i, j, cost), as for pair_cost. groups: the pairs
    within each of these groups of items. against: pairs of each of the items with each of this many
    others, numbered after them. done_items: the number of first items whose pairs have met before.

    workers: split the order for this many workers, which gives WorkerLoads. Pairs are spread evenly
    over the workers that have them; with first_holder the first worker that has a pair computes it.
    pair_cost: a mapping from pairs to numbers, or rows of two items and a number; 1 by default.
    Costs are then spread instead of numbers of pairs. disjoint: workers step together and never
    hold the same item at the same time.

    new_pairs: work() has the pairs that a step computes; ordered: in both directions; with_self:
    also each item with itself; shuffle: in random order. write_back: work() has the changed items
    that are stored. prefetch: work() has the pairs that are computed while loads run. epochs: every
    pair meets in each of them; epochs alternate between forward and backward, and memory stays as
    it is between them. spread: a pair goes to a random one of the steps that have it, balanced over
    the steps, by seed; without write_back this implies new_pairs.

    sizes, instead of room: the bytes of the items, in turn or as a mapping from item to bytes, each
    a number or as in "4M"; `memory` bytes are held at a time, by each worker. fast_room, or with
    sizes fast_memory in bytes: so much of it is on an accelerator, where pairs must be together.
    verify_beside: return before the steps are verified; verified() waits for that. Raises BadInput,
    ImpossibleParameters.
    """
    if room is not None and items is None and pairs is None and groups is None and sizes is None:
        raise BadInput("items are required, unless pairs or groups have them; give their number")
    costs: List[List[str]] = []
    ends = None if pairs is None else given_ends(pairs, costs).tobytes()
    if costs and (workers is None or pair_cost is not None):
        raise BadInput("pairs: costs are for workers, and without pair_cost; give rows of two "
                       "items")
    given: Dict[str, Any] = {
        "items": items, "room": room, "pairs": None if ends is None else [],
        "groups": None if groups is None else group_rows(groups), "against": against,
        "done_items": done_items, "workers": workers, "disjoint": disjoint,
        "write_back": write_back,
        "new_pairs": new_pairs or (spread and not (write_back or prefetch)),
        "prefetch": prefetch, "ordered": ordered, "self": with_self, "shuffle": shuffle,
        "first_holder": first_holder,
        "pair_cost": costs or (None if pair_cost is None else cost_rows(pair_cost)),
        "verify_beside": verify_beside, "epochs": epochs, "spread": spread,
        "sizes": None if sizes is None else size_rows(sizes), "memory": memory_of("memory", memory),
        "fast_room": fast_room, "fast_memory": memory_of("fast_memory", fast_memory),
        **of_search(time, threads, seed)}
    asked = {key: value for key, value in given.items() if value is not None and value is not False}
    core = _core.Loads.planned(json.dumps(asked), ends, progress)
    kind: Any = LoadOrder if workers is None else WorkerLoads
    # What a search finds is not found again: a pickle holds its steps.
    facts = {**_facts(core, kind), "_asked": (asked, ends, time is not None)}
    order: Union[LoadOrder, WorkerLoads] = made(kind, facts, core)
    return order


def all_pairs(
    path: Path, item_bytes: int, room: int,
    compute: Callable[[int, int, memoryview, memoryview], object], *, header_bytes: int = 0,
    threads: int = 1, journal: Optional[Path] = "", share: Optional[Tuple[int, int]] = None,
    earlier: Iterable[Path] = (), verify_beside: bool = False, short_last: bool = False,
) -> Report:
    """Runs an all-pairs job over a file of items of item_bytes each, with at most `room` of them in
    memory.

    compute(i, j, first, second) is called once for each pair i < j and for each item with itself (i
    = j). Its read-only memoryviews end with the call. Slices and arrays that are made of them stay
    valid, and keep the item in memory beyond the room. With a journal, a job that was ended
    continues where it was. share: (i, n) computes the i-th of n shares, from 0; earlier: journals
    of a run with another number of shares, whose pairs are not computed again. verify_beside: start
    before the order is verified. short_last: the last item may have fewer bytes; without it, a file
    that is not whole items is refused. An exception of compute ends the job. Raises BadInput,
    MissingResource.
    """
    journals = []
    for path_of_one in listed("earlier", "paths of journals", earlier):
        name = file_name("earlier", path_of_one)
        if name is None:
            raise TypeError(f"earlier has paths of journals, not {in_a_line(path_of_one)}")
        journals.append(in_bytes(name))
    try:
        return made(Report, _core.all_pairs(
            in_bytes(path), item_bytes, room, compute, header_bytes, threads,
            in_bytes(journal or ""), *share_of(share), journals, verify_beside, short_last))
    except BadInput as fault:
        said = str(fault)
        in_python = said.replace("or allow a short last one", "or give short_last=True")
        if in_python == said:
            raise
        raise BadInput(in_python) from None


def update_pairs(
    path: Path, item_bytes: int, room: int,
    update: Callable[[int, int, memoryview, memoryview], object], *, journal: Path,
    workers: int = 1, epochs: int = 1, ordered: bool = False, with_self: bool = False,
    shuffle: bool = False, spread: bool = False, seed: int = 1, checkpoint_every: int = 100,
) -> UpdateReport:
    """Runs a job whose items change, as in training, over a file of items of item_bytes each, with
    at most `room` of them in the memory of each worker.

    update(i, j, first, second) is called for each pair i < j in each epoch, with writable
    memoryviews, which end with the call: copy data that must stay. Workers are threads, and no two
    have the same item at the same time. ordered: also (j, i); with_self: also (i, i); shuffle,
    spread: as in load_order().

    Changed items are stored when they are evicted, and all of them after every checkpoint_every
    steps. With its journal, a job that was ended continues from the last checkpoint, with the same
    result. Until it has finished, `path` belongs together with the journal and the file
    `path`.versions. An exception of update ends the job. Raises BadInput, MissingResource.
    """
    return made(UpdateReport, _core.update_pairs(
        in_bytes(path), item_bytes, room, update, in_bytes(journal), operator.index(workers), operator.index(epochs),
        ordered, with_self, shuffle, spread, operator.index(seed),
        operator.index(checkpoint_every)))


check_calls(globals())
