"""Independent parts: each worker has one at a time, and the part of a lost worker is done again."""

from __future__ import annotations

import collections
import dataclasses
import time
from typing import Any, Callable, Deque, Dict, List, Optional, Tuple

from ..errors import MissingResource
from ._engine import Engine, Lost, Task, Tell, check_team, kind_of
from ._engines import engine_for
from ._failed import failed
from ._worker import Failure, Outcome

_patience = 0.5
_without_workers = 300.0
_most_losses = 8


@dataclasses.dataclass(frozen=True)
class Call:
    """A part: the arguments of a function."""

    number: int
    arguments: Dict[str, Any]


class Caller:
    """Performs calls of one function; `over` tells it that its result is not needed any more."""

    def __init__(self, function: Callable[..., Any], threads: int = 1) -> None:
        self._function = function
        self._threads = threads
        self._running = 0
        self._over = False

    def run(self, part: Call, stopped: Callable[[], bool] = lambda: False) -> Outcome:
        outcome = Outcome(part.number)
        begin = time.perf_counter()

        def over() -> bool:
            return self._over or stopped()

        self._running += 1
        try:
            outcome.results.append(
                self._function(over=over, threads=self._threads, **part.arguments))
        except Over:
            outcome.stopped = True
        except Exception as fault:
            outcome.failure = Failure.of(self._function.__name__.lstrip("_"), (), fault)
        finally:
            self._running -= 1
        outcome.seconds = time.perf_counter() - begin
        return outcome

    def is_busy(self) -> bool:
        return self._running > 0

    def close(self) -> None:
        self._over = True


class Over(Exception):
    """Raised by progress functions of work whose result is not needed any more."""


def unless_over(over: Callable[[], bool]) -> Callable[[Dict[str, Any]], None]:
    """A progress function that ends such work."""
    def look(_said: Dict[str, Any]) -> None:
        if over():
            raise Over
    return look


class Bag:
    """`take(arguments, result)` receives the result of each part, and may add parts to the bag;
    `is_over` ends it before all are done."""

    def __init__(self, take: Callable[[Dict[str, Any], Any], None],
                 more: Callable[[], Optional[Dict[str, Any]]] = lambda: None,
                 is_over: Callable[[], bool] = lambda: False) -> None:
        self._take, self._more, self._is_over = take, more, is_over
        self._waiting: Deque[Tuple[Dict[str, Any], int]] = collections.deque()
        self._flights: Dict[int, Tuple[Dict[str, Any], str, int]] = {}
        self._idle: List[str] = []
        self._next = 0
        self.parts = self.lost = self.retried = 0
        self.workers = 0

    def put(self, arguments: Dict[str, Any]) -> None:
        self._waiting.append((arguments, 0))

    def empty(self) -> bool:
        return not self._waiting and not self._flights

    def flying(self) -> List[Dict[str, Any]]:
        """The arguments of parts in progress."""
        return [arguments for arguments, _, _ in self._flights.values()]

    def run(self, engine: Engine, tell: Callable[[str], None]) -> None:
        self._idle = engine.workers()
        self.workers = len(self._idle)
        if not self._idle:
            raise MissingResource("there are no workers; start some, and wait for them: with Dask "
                                  "client.wait_for_workers(1)")
        alone_since: Optional[float] = None
        self._give(engine)
        while not self._is_over() and self._flights or self._waiting and not self._is_over():
            tell("searching" if self.workers else "waiting for workers")
            for event in engine.wait(_patience):
                if event.kind == "joined":
                    self.workers += 1
                    self._idle.append(event.worker)
                elif event.kind == "lost":
                    self._lose(event.worker)
                else:
                    self._done(engine, event.number)
                if self._is_over():
                    return
            self._give(engine)
            now = time.monotonic()
            alone_since = None if self.workers else alone_since or now
            if alone_since is not None and now - alone_since > _without_workers:
                raise MissingResource(
                    f"all workers were lost, and none came for {_without_workers:.0f} s")

    def _give(self, engine: Engine) -> None:
        while self._idle and not self._is_over():
            if self._waiting:
                arguments, losses = self._waiting.popleft()
            else:
                made = self._more()
                if made is None:
                    return
                arguments, losses = made, 0
            worker = self._idle.pop()
            self._next += 1
            self.parts += 1
            self._flights[self._next] = (arguments, worker, losses)
            engine.submit(worker, Call(self._next, arguments))

    def _lose(self, worker: str) -> None:
        self.lost += 1
        self.workers -= 1
        if worker in self._idle:
            self._idle.remove(worker)
        for number in [number for number, (_, at, _) in self._flights.items() if at == worker]:
            self._again(number)

    def _again(self, number: int) -> None:
        arguments, _, losses = self._flights.pop(number)
        if losses + 1 >= _most_losses:
            raise MissingResource(f"{_most_losses} workers were lost, one after the other, while "
                                  "they had the same part; does it take more memory than they "
                                  "have?")
        self.retried += 1
        self._waiting.appendleft((arguments, losses + 1))

    def _done(self, engine: Engine, number: int) -> None:
        if number not in self._flights:
            return
        try:
            outcome = engine.outcome(number)
        except Lost:
            self._again(number)
            return
        arguments, worker, losses = self._flights.pop(number)
        self._idle.append(worker)
        if outcome.failure is not None:
            raise failed(outcome.failure, worker)
        if outcome.stopped:  # Its process had no function, or was told to end it.
            self.retried += 1
            self._waiting.appendleft((arguments, losses))
        else:
            self._take(arguments, outcome.results[0])


def run_bag(client: Any, function: Callable[..., Any], begin: Callable[[], Bag],
            finish: Callable[[Bag], Dict[str, Any]], tell_caller: Tell, threads: Optional[int],
            facts: Callable[[Bag], Dict[str, Any]], workers: Optional[int]) -> Dict[str, Any]:
    """Works on every engine: at the caller, `begin` makes the bag and `finish` its answer, which
    all processes of MPI return. Ctrl-C ends it with the results so far."""
    import functools
    check_team(threads, workers)
    task = Task(functools.partial(Caller, function), {}, threads)
    kind = kind_of(client)
    if kind == "mpi" and client.rank != 0:
        from ._mpi import serve
        return serve(client, task)

    def lead(engine: Engine) -> Dict[str, Any]:
        bag = begin()
        began = last = time.monotonic()

        def tell(phase: str) -> None:
            nonlocal last
            if tell_caller is not None and time.monotonic() - last >= _patience:
                last = time.monotonic()
                tell_caller({"phase": phase, "steps": bag.parts, "unit": "parts",
                             "workers": bag.workers, "elapsed": last - began, **facts(bag)})

        interrupted = False
        try:
            bag.run(engine, tell)
        except KeyboardInterrupt:
            interrupted = True
        return {**finish(bag), "interrupted": interrupted, "seconds": time.monotonic() - began,
                "parts": bag.parts, "lost": bag.lost, "retried": bag.retried}

    if kind == "mpi":
        from ._mpi import MpiEngine
        with MpiEngine(client, task) as mpi:
            answer = lead(mpi)
            mpi.tell_all(answer)
            return answer
    engine = engine_for(client, task, workers)
    try:
        return lead(engine)
    finally:
        engine.close()
