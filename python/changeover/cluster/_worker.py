"""The code that runs on a worker: stretches, with a memory that stays between them."""

from __future__ import annotations

import concurrent.futures
import dataclasses
import importlib
import itertools
import math
import operator
import pickle
import threading
import time
import traceback
from array import array
from typing import Any, Callable, Dict, Iterable, Iterator, List, Optional, Protocol, Tuple

from ..errors import InternalError
from ._stretches import Stretch

Load = Callable[[int], Any]
Compute = Callable[[int, int, Any, Any], Any]


@dataclasses.dataclass(frozen=True)
class Failure:
    """An exception of the caller's functions, in a form that travels."""

    what: str  # 'load' or 'compute'
    items: Tuple[int, ...]
    raised: str  # the name of its class
    says: str
    trace: str
    pickled: Optional[bytes]

    @classmethod
    def of(cls, what: str, items: Tuple[int, ...], fault: BaseException) -> Failure:
        trace = "".join(traceback.format_exception(type(fault), fault, fault.__traceback__))
        try:
            pickled: Optional[bytes] = pickle.dumps(fault)
            pickle.loads(pickle.dumps(fault))
        except Exception:  # Its class is not known elsewhere, or it holds what cannot be sent.
            pickled = None
        try:
            says = str(fault)
        except Exception:
            says = ""
        return cls(what, items, type(fault).__name__, says, trace, pickled)

    def exception(self) -> Optional[BaseException]:
        try:
            fault = pickle.loads(self.pickled) if self.pickled else None
        except Exception:
            return None
        return fault if isinstance(fault, BaseException) else None


@dataclasses.dataclass
class Outcome:
    """The result of a stretch: results in the order of its pairs, fewer if it ended early."""

    number: int
    results: List[Any] = dataclasses.field(default_factory=list)
    loads: int = 0
    bytes_loaded: Optional[int] = 0  # None: an item does not say its size
    most_held: int = 0
    most_bytes: int = 0  # by sizes
    load_seconds: float = 0.0
    seconds: float = 0.0
    held: Tuple[int, ...] = ()  # at the end
    failure: Optional[Failure] = None
    stopped: bool = False


class Part(Protocol):
    """The message to a worker."""

    @property
    def number(self) -> int: ...


class Performer(Protocol):
    """Does the parts of a job on a worker."""

    def run(self, part: Any, stopped: Callable[[], bool] = lambda: False) -> Outcome: ...

    def is_busy(self) -> bool: ...

    def close(self) -> None:
        """Ends this job; running parts end soon."""


class _Failed(Exception):
    def __init__(self, failure: Failure) -> None:
        super().__init__(failure.what)
        self.failure = failure


class _Stopped(Exception):
    pass


def size_of(item: Any) -> Optional[int]:
    """The bytes of an item that has nbytes."""
    try:
        if isinstance(item, (bytes, bytearray)):
            return len(item)
        said: Any = getattr(item, "nbytes", None)
        size = operator.index(said)
    except Exception:  # It has none, or what it has is no number.
        return None
    return size if size >= 0 else None


def is_interrupt(fault: BaseException) -> bool:
    """Ctrl-C, which reaches main threads, as opposed to an exception of a function."""
    return (isinstance(fault, KeyboardInterrupt)
            and threading.current_thread() is threading.main_thread())


@dataclasses.dataclass(frozen=True)
class Packed:
    """A result to be sent, pickled separately: one that cannot be pickled is reported with its
    pair."""

    pickled: bytes


_plain = (type(None), bool, int, float, complex, str, bytes)


def _is_plain(result: Any, depth: int = 2) -> bool:
    """Whether it can certainly be sent without a separate pickle."""
    kind = type(result)
    if kind in _plain:
        return True
    if kind is tuple:
        return depth > 0 and len(result) <= 16 and all(_is_plain(x, depth - 1) for x in result)
    dtype = getattr(result, "dtype", None) if kind.__module__ == "numpy" else None
    return getattr(dtype, "kind", "O") not in "OV"  # an array or a number of NumPy's


def packed_result(result: Any) -> Any:
    """The form in which a result is sent. Raises exceptions of pickling."""
    if _is_plain(result):
        return result
    try:
        return Packed(pickle.dumps(result, pickle.HIGHEST_PROTOCOL))
    except Exception:
        try:
            pickler: Any = importlib.import_module("cloudpickle")  # Functions of a script, ...
        except ImportError:
            pickler = pickle
        return Packed(pickler.dumps(result))


def unpacked_result(sent: Any) -> Any:
    """The result. Raises exceptions of unpickling."""
    return pickle.loads(sent.pickled) if isinstance(sent, Packed) else sent


class Memory:
    """At most `room` items of one job, or `memory` bytes of them by the sizes in the stretches.
    Items that no stretch holds stay as long as there is room."""

    def __init__(self, load: Load, compute: Compute, room: Optional[int] = None, threads: int = 1,
                 overlap: bool = False, memory: Optional[int] = None) -> None:
        self._load = load
        self._compute = compute
        self._room = math.inf if room is None else room
        self._memory = math.inf if memory is None else memory
        self._overlap = overlap
        self._threads = threads
        self._items: Dict[int, Any] = {}
        self._coming: Dict[int, concurrent.futures.Future[Any]] = {}
        self._sizes: Dict[int, int] = {}  # of both
        self._busy = threading.Lock()
        self._pool: Optional[concurrent.futures.ThreadPoolExecutor] = None
        if threads > 1 or overlap:
            self._pool = concurrent.futures.ThreadPoolExecutor(
                threads + (1 if overlap else 0), thread_name_prefix="changeover")
        self.over = False  # set from outside: no more of this job

    def is_busy(self) -> bool:
        return self._busy.locked()

    def close(self) -> None:
        self.over = True
        if self._busy.acquire(blocking=False):  # Otherwise the stretch that runs does it.
            self._forget()
            self._busy.release()

    def _forget(self) -> None:
        self._items.clear()
        self._coming.clear()
        self._sizes.clear()
        if self._pool is not None:
            self._pool.shutdown(wait=False)

    def run(self, stretch: Stretch, stopped: Callable[[], bool] = lambda: False) -> Outcome:
        """Computes one at a time, for any number of callers. Never raises exceptions of load() and
        compute()."""
        with self._busy:
            outcome = Outcome(stretch.number)
            begin = time.perf_counter()
            try:
                if self.over:  # What it would need is gone.
                    raise _Stopped
                self._run(stretch, outcome, lambda: self.over or stopped())
            except _Failed as fault:
                outcome.failure = fault.failure
            except _Stopped:
                outcome.stopped = True
            outcome.seconds = time.perf_counter() - begin
            outcome.held = tuple(self._items)
            if self.over:
                self._forget()
            return outcome

    def _run(self, stretch: Stretch, outcome: Outcome, stopped: Callable[[], bool]) -> None:
        self._sizes.update(stretch.sizes or {})
        next_load: Dict[int, int] = {}  # item: the first step that loads it
        for place, step in enumerate(stretch.steps):
            for x in step[1]:
                next_load.setdefault(x, place)
        held = set(stretch.keep)
        self._bring(stretch.hold, held, next_load, outcome, stopped)
        for place, (evict, load, ends) in enumerate(stretch.steps):
            held.difference_update(evict)
            held.update(load)
            self._bring(load, held, next_load, outcome, stopped)
            if self._overlap and place + 1 < len(stretch.steps):
                self._start_loads(stretch.steps[place + 1][1], held, next_load)
            self._compute_pairs(ends, outcome, stopped)

    def _bytes(self, items: Iterable[int]) -> int:
        return sum(self._sizes.get(x, 0) for x in items)

    def _drop(self, held: set[int], next_load: Dict[int, int], coming: List[int]) -> bool:
        """Makes room for these items: evicts items that are loaded again last, never held ones."""
        spare = len(self._items) + len(self._coming) + len(coming) - self._room
        size = self._bytes(itertools.chain(self._items, self._coming, coming)) - self._memory
        if spare > 0 or size > 0:
            free = [x for x in self._items if x not in held]
            free.sort(key=lambda x: next_load.get(x, len(next_load) + 1), reverse=True)
            for x in free:
                if spare <= 0 and size <= 0:
                    break
                del self._items[x]
                spare -= 1
                size -= self._sizes.get(x, 0)
        return spare <= 0 and size <= 0

    def _start_loads(self, load: Tuple[int, ...], held: set[int],
                     next_load: Dict[int, int]) -> None:
        """Loads while pairs are computed, as far as there is room."""
        assert self._pool is not None
        for x in load:
            if x not in self._items and x not in self._coming:
                if not self._drop(held | set(load), next_load, [x]):
                    return
                self._coming[x] = self._pool.submit(self._load_timed, x)

    def _load_timed(self, x: int) -> Tuple[Any, float]:
        """The item, or the failure; an exception in a future would keep the items of its frames
        alive."""
        begin = time.perf_counter()
        try:
            return self._load(x), time.perf_counter() - begin
        except BaseException as fault:
            if is_interrupt(fault):
                raise
            return _failure("load", (x,), fault), 0.0

    def _bring(self, load: Tuple[int, ...], held: set[int], next_load: Dict[int, int],
               outcome: Outcome, stopped: Callable[[], bool]) -> None:
        for x in list(self._coming):
            if x in held:
                self._take(x, self._coming.pop(x).result(), outcome)
        missing = [x for x in load if x not in self._items]
        if not missing:
            return
        for x in [x for x in self._coming if x not in held]:  # Of a stretch that was given up.
            coming = self._coming.pop(x)
            if not coming.cancel() and not isinstance(coming.result()[0], Failure):
                self._take(x, coming.result(), outcome)
            del coming  # It would keep its item alive.
        if not self._drop(held, next_load, missing):
            raise InternalError("a stretch needs more room than there is: this is a bug")
        if self._pool is None or len(missing) == 1:
            for x in missing:
                if stopped():
                    raise _Stopped
                self._take(x, self._load_timed(x), outcome)
            return
        begin = time.perf_counter()
        futures = {x: self._pool.submit(self._load_timed, x) for x in missing}
        try:
            for x, future in futures.items():
                self._take(x, (future.result()[0], 0.0), outcome)
                if stopped():
                    raise _Stopped
        finally:
            for future in futures.values():
                future.cancel()
            concurrent.futures.wait(futures.values())
        outcome.load_seconds += time.perf_counter() - begin

    def _take(self, x: int, loaded: Tuple[Any, float], outcome: Outcome) -> None:
        item, seconds = loaded
        if isinstance(item, Failure):
            raise _Failed(item)
        self._items[x] = item
        size = self._sizes[x] if x in self._sizes else size_of(item)
        outcome.loads += 1
        outcome.load_seconds += seconds
        outcome.bytes_loaded = (None if size is None or outcome.bytes_loaded is None
                                else outcome.bytes_loaded + size)
        outcome.most_held = max(outcome.most_held, len(self._items) + len(self._coming))
        if self._sizes:
            outcome.most_bytes = max(outcome.most_bytes,
                                     self._bytes(itertools.chain(self._items, self._coming)))

    def _compute_pairs(self, ends: array[int], outcome: Outcome,
                       stopped: Callable[[], bool]) -> None:
        pairs = list(zip(ends[::2], ends[1::2]))
        if self._threads == 1 or len(pairs) < 2:
            before = len(outcome.results)
            failure = self._compute_some(pairs, outcome.results, stopped)
            if failure is not None:
                raise _Failed(failure)
            if len(outcome.results) < before + len(pairs):
                raise _Stopped
            return
        assert self._pool is not None
        pieces: List[Tuple[List[Tuple[int, int]], List[Any]]] = [
            (pairs[begin:end], []) for begin, end in _pieces(len(pairs), 4 * self._threads)]
        futures = [self._pool.submit(self._compute_some, some, results, stopped)
                   for some, results in pieces]
        concurrent.futures.wait(futures)
        for future, (some, results) in zip(futures, pieces):
            outcome.results += results  # Up to the first that is missing.
            failure = future.result()
            if failure is not None:
                raise _Failed(failure)
            if len(results) < len(some):
                raise _Stopped

    def _compute_some(self, pairs: List[Tuple[int, int]], results: List[Any],
                      stopped: Callable[[], bool]) -> Optional[Failure]:
        """Ends early if it is stopped or fails."""
        for i, j in pairs:
            if stopped():
                return None
            try:
                results.append(packed_result(
                    self._compute(i, j, self._items[i], self._items[j])))
            except BaseException as fault:
                if is_interrupt(fault):
                    raise
                return _failure("compute", (i, j), fault)
        return None


def _failure(what: str, items: Tuple[int, ...], fault: BaseException) -> Failure:
    failure = Failure.of(what, items, fault)
    # The items that these functions had in hand go now, not at the next collection of garbage.
    traceback.clear_frames(fault.__traceback__)
    return failure


def _pieces(count: int, parts: int) -> Iterator[Tuple[int, int]]:
    parts = min(count, parts)
    for part in range(parts):
        yield count * part // parts, count * (part + 1) // parts


# Of this process, which may be several workers: who performs the jobs, by job and worker.
_performers: Dict[Tuple[Tuple[str, str], str], Performer] = {}
_over: List[Tuple[str, str]] = []
_guard = threading.Lock()


def perform(job: Tuple[str, str], worker: str, maker: Optional[bytes], settings: Dict[str, Any],
            clients: Optional[List[str]], part: Part) -> Outcome:
    """Where engines send parts to permanent processes, such as those of Dask. The name of a job
    begins with that of its client; jobs of clients that are not in `clients` were abandoned.
    Without a maker, and if none was made before, the part is not done: its result is "stopped"."""
    with _guard:
        if job in _over:
            return Outcome(part.number, stopped=True)
        performer = _performers.get((job, worker))
        if performer is None:
            if maker is None:
                return Outcome(part.number, stopped=True)
            for key, other in list(_performers.items()):
                if key[1] == worker and (not other.is_busy() if clients is None
                                         else key[0][0] not in clients):
                    _performers.pop(key).close()
            performer = _performers[job, worker] = pickle.loads(maker)(**settings)
    return performer.run(part)


def forget_job(job: Tuple[str, str]) -> None:
    """Ends its running parts and frees its items."""
    with _guard:
        _over.append(job)
        del _over[:-100]
        ended = [_performers.pop(key) for key in list(_performers) if key[0] == job]
    for performer in ended:
        performer.close()
