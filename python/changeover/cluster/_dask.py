"""Workers of a Dask cluster."""

from __future__ import annotations

import importlib
import queue
import threading
import time
import uuid
from typing import Any, Callable, Dict, List, Optional

from ..errors import BadInput, MissingResource
from ._engine import Event, Lost, RealTime, Task, packed
from ._worker import Outcome, Part, forget_job, perform


def _clients(dask_scheduler: Any) -> List[str]:
    return [str(client) for client in dask_scheduler.clients]


def _gone() -> MissingResource:
    return MissingResource("the scheduler of Dask is gone, or the client was closed or restarted")


class DaskEngine(RealTime):
    """Each part is a future for one worker. The scheduler is asked whether workers exist, since a
    future whose worker is lost would wait for it."""

    def __init__(self, client: Any, task: Task) -> None:
        if getattr(client, "asynchronous", False):
            raise TypeError("client is asynchronous; give one that is not: Client(address)")
        if client.status != "running":
            raise BadInput(f"client is {client.status}; give one that is connected")
        self._client = client
        self._task = task
        self._job = (str(client.id), f"changeover-{uuid.uuid4().hex}")
        try:
            self._clients: Optional[List[str]] = client.run_on_scheduler(_clients)
        except Exception:  # It does not say.
            self._clients = None
        self._done: queue.SimpleQueue[int] = queue.SimpleQueue()
        self._futures: Dict[int, Any] = {}
        self._worker_of: Dict[int, str] = {}
        self._known: Dict[str, int] = self._nthreads()
        self._looked = time.monotonic()
        # Sent with the first parts of each worker, and no separate task: such a task may get to
        # a worker that hangs, and then all would wait for it.
        self._maker = packed(task.maker, importlib.import_module("cloudpickle"))
        self._have_maker: set[str] = set()

    def _nthreads(self) -> Dict[str, int]:
        try:
            answer: Dict[str, int] = dict(self._client.nthreads())
        except Exception as fault:  # Of which class depends on how it went.
            raise _gone() from fault
        return answer

    def workers(self) -> List[str]:
        return sorted(self._known)

    def submit(self, worker: str, part: Part) -> None:
        threads = self._task.threads or self._known.get(worker, 1)
        number = part.number
        try:
            future = self._client.submit(
                perform, self._job, worker,
                None if worker in self._have_maker else self._maker,
                {**self._task.settings, "threads": threads}, self._clients, part,
                workers=[worker], allow_other_workers=False, pure=False,
                key=f"{self._job[1]}-{number}")
        except Exception as fault:
            if self._client.status == "running":
                raise
            raise _gone() from fault
        self._futures[number] = future
        self._worker_of[number] = worker
        future.add_done_callback(lambda _: self._done.put(number))

    def wait(self, seconds: float) -> List[Event]:
        end = time.monotonic() + seconds
        pause = max(0.1, 0.001 * len(self._known))
        while True:
            events = self._take(min(pause, max(0.0, end - time.monotonic())))
            if time.monotonic() - self._looked >= pause:
                events += self._look()
            if events or time.monotonic() >= end:
                return events

    def _take(self, seconds: float) -> List[Event]:
        events = []
        try:
            number = self._done.get(timeout=max(seconds, 0.001))
            while True:
                if number in self._futures:
                    events.append(Event("done", self._worker_of[number], number))
                number = self._done.get_nowait()
        except queue.Empty:
            return events

    def _look(self) -> List[Event]:
        now = self._nthreads()
        self._looked = time.monotonic()
        events = [Event("lost", worker) for worker in self._known if worker not in now]
        events += [Event("joined", worker) for worker in now if worker not in self._known]
        self._known = now
        return events

    def outcome(self, number: int) -> Outcome:
        future = self._futures[number]
        worker = self._worker_of[number]
        while True:
            try:
                outcome: Outcome = future.result(timeout=2)
                break
            except Exception as fault:
                kinds = {kind.__name__ for kind in type(fault).__mro__}
                if "TimeoutError" in kinds and future.status in ("pending", "finished"):
                    # Its data are on their way, or went with the worker.
                    if worker in self._nthreads():
                        continue
                elif not kinds & {"KilledWorker", "CancelledError", "TimeoutError"}:
                    self.drop(number)
                    raise MissingResource(
                        f"worker {worker} cannot do its part: {type(fault).__name__}: "
                        f"{' '.join(str(fault).split())}; see the log of this worker") from fault
                if self._client.status != "running":
                    raise _gone() from fault
                self.drop(number)
                raise Lost from fault
        self.drop(number)
        if outcome.stopped:  # Perhaps it is another process by now, which has no functions.
            self._have_maker.discard(worker)
        else:
            self._have_maker.add(worker)
        return outcome

    def drop(self, number: int) -> None:
        future = self._futures.pop(number, None)
        self._worker_of.pop(number, None)
        if future is not None:
            self._quietly(future.release)

    def close(self) -> None:
        for number in list(self._futures):
            self.drop(number)
        workers = list(self._known)

        def forget() -> None:
            self._client.run(forget_job, self._job, workers=workers, on_error="ignore")

        # Workers that hang must not keep the caller.
        thread = threading.Thread(target=self._quietly, args=(forget,), daemon=True)
        thread.start()
        thread.join(10)

    @staticmethod
    def _quietly(work: Callable[[], Any]) -> None:
        try:
            work()
        except Exception:
            pass
