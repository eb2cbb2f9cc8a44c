"""Workers of a Ray cluster: one actor for each processor."""

from __future__ import annotations

import pickle
import time
from typing import Any, Dict, List, Optional

from ..errors import MissingResource
from ._engine import Event, Lost, RealTime, Task, packed
from ._worker import Outcome, Part, Performer


class _Actor:
    def __init__(self, maker: bytes, settings: Dict[str, Any]) -> None:
        self._performer: Performer = pickle.loads(maker)(**settings)

    def run(self, part: Part) -> Outcome:
        return self._performer.run(part)


class RayEngine(RealTime):
    """Each part is a call of an actor. An actor that dies is not restarted; the others do its part.
    """

    def __init__(self, ray: Any, task: Task, workers: Optional[int]) -> None:
        threads = task.threads or 1
        self._ray = ray
        if not ray.is_initialized():
            ray.init()
        count = workers or max(1, int(ray.cluster_resources().get("CPU", 1)) // threads)
        maker = ray.put(packed(task.maker, ray.cloudpickle))
        make = ray.remote(num_cpus=threads)(_Actor)
        settings = {**task.settings, "threads": threads}
        self._actors = {f"actor {number}": make.remote(maker, settings)
                        for number in range(count)}
        self._calls: Dict[Any, int] = {}  # by what ray.wait() takes
        self._call_of: Dict[int, Any] = {}
        self._worker_of: Dict[int, str] = {}
        self._dead: List[str] = []

    def workers(self) -> List[str]:
        return sorted(self._actors)

    def submit(self, worker: str, part: Part) -> None:
        if worker not in self._actors:
            return  # It is about to be told as lost.
        call = self._actors[worker].run.remote(part)
        self._calls[call] = part.number
        self._call_of[part.number] = call
        self._worker_of[part.number] = worker

    def wait(self, seconds: float) -> List[Event]:
        events = [Event("lost", worker) for worker in self._dead]
        self._dead = []
        if events:
            return events
        if not self._calls:
            time.sleep(seconds)
            return []
        ready, _ = self._ray.wait(list(self._calls), num_returns=1, timeout=seconds)
        numbers = [self._calls.pop(call) for call in ready]
        return [Event("done", self._worker_of[number], number) for number in numbers]

    def outcome(self, number: int) -> Outcome:
        call, worker = self._call_of.pop(number), self._worker_of.pop(number)
        try:
            outcome: Outcome = self._ray.get(call)
            return outcome
        except self._ray.exceptions.RayActorError as fault:
            if self._actors.pop(worker, None) is not None:
                self._dead.append(worker)
            raise Lost from fault
        except self._ray.exceptions.RayError as fault:
            raise MissingResource(f"{worker} cannot do its part: {fault}; see the log of this "
                                  "worker") from fault

    def drop(self, number: int) -> None:
        call = self._call_of.pop(number, None)
        self._worker_of.pop(number, None)
        if call is not None:
            self._calls.pop(call, None)

    def close(self) -> None:
        for actor in self._actors.values():
            self._ray.kill(actor)
        self._actors.clear()
