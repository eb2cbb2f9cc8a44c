"""Workers that mpirun or srun started: every process makes the call; process 0 leads and works,
too."""

from __future__ import annotations

import pickle
import queue
import threading
import time
from typing import Any, Dict, List, Optional, Union

from ._engine import Event, RealTime, Task
from ._failed import Failed, failed
from ._worker import Outcome, Part

_to_worker, _to_leader = 1, 2
_shortest_pause, _longest_pause = 0.0002, 0.005


class _Mail:
    """Messages of one communicator, received without busy waiting: MPI's own waiting keeps the
    processor busy, which slows down processes that share it."""

    def __init__(self, comm: Any) -> None:
        self.comm = comm
        self._sent: List[Any] = []

    def send(self, message: Any, to: int, tag: int) -> None:
        """Returns at once; the message is kept until it has arrived."""
        self._sent = [each for each in self._sent if not each.test()[0]]
        self._sent.append(self.comm.isend(message, dest=to, tag=tag))

    def receive(self, tag: int) -> Optional[Any]:
        """A pair (sender, message), if there is one."""
        from mpi4py import MPI
        status = MPI.Status()
        message = self.comm.improbe(MPI.ANY_SOURCE, tag, status)
        if message is None:
            return None
        return status.Get_source(), message.recv()

    def arrived(self) -> bool:
        self._sent = [each for each in self._sent if not each.test()[0]]
        return not self._sent


def _pause(idle: int) -> None:
    time.sleep(min(_longest_pause, _shortest_pause * 1.5**min(idle, 20)))


class MpiEngine(RealTime):
    """For process 0. Leaving the context makes the other processes leave the call, too: with the
    report, or with the exception."""

    def __init__(self, comm: Any, task: Task) -> None:
        self._mail = _Mail(comm.Dup())
        self._outcomes: Dict[int, Outcome] = {}
        self._worker_of: Dict[int, str] = {}
        self._own: queue.SimpleQueue[Optional[Part]] = queue.SimpleQueue()
        self._own_done: queue.SimpleQueue[Union[Outcome, BaseException]] = queue.SimpleQueue()
        self._performer = task.performer()
        self._thread = threading.Thread(target=self._work, daemon=True)
        self._report: Optional[Dict[str, Any]] = None

    def __enter__(self) -> MpiEngine:
        self._thread.start()
        return self

    def _work(self) -> None:
        while True:
            part = self._own.get()
            if part is None:
                return
            try:
                self._own_done.put(self._performer.run(part))
            except BaseException as fault:  # Otherwise process 0 would wait for it.
                self._own_done.put(fault)

    def workers(self) -> List[str]:
        return [_name(rank) for rank in range(self._mail.comm.size)]

    def submit(self, worker: str, part: Part) -> None:
        self._worker_of[part.number] = worker
        rank = int(worker.split()[-1])
        if rank == 0:
            self._own.put(part)
        else:
            self._mail.send(("part", part), rank, _to_worker)

    def wait(self, seconds: float) -> List[Event]:
        end = time.monotonic() + seconds
        idle = 0
        while True:
            events = self._take()
            if events or time.monotonic() >= end:
                return events
            _pause(idle)
            idle += 1

    def _take(self) -> List[Event]:
        events: List[Event] = []

        def take(came: Union[Outcome, BaseException]) -> None:
            if isinstance(came, BaseException):
                raise came
            self._outcomes[came.number] = came
            events.append(Event("done", self._worker_of[came.number], came.number))

        while not self._own_done.empty():
            take(self._own_done.get())
        while (mail := self._mail.receive(_to_leader)) is not None:
            take(mail[1])
        return events

    def outcome(self, number: int) -> Outcome:
        del self._worker_of[number]
        return self._outcomes.pop(number)

    def drop(self, number: int) -> None:
        self._outcomes.pop(number, None)

    def close(self) -> None:
        """__exit__ informs the other processes."""

    def tell_all(self, report: Dict[str, Any]) -> None:
        self._report = report

    def __exit__(self, _kind: Any, fault: Optional[BaseException], _trace: Any) -> None:
        self._performer.close()
        self._own.put(None)
        last = ("over", self._report) if fault is None else ("fault", _sendable(fault))
        ranks = set(range(1, self._mail.comm.size))
        for rank in ranks:
            self._mail.send(last, rank, _to_worker)
        idle = 0
        while ranks or not self._mail.arrived():
            mail = self._mail.receive(_to_leader)
            if mail is None:
                _pause(idle)
                idle += 1
            elif mail[1] is None:  # It has left.
                ranks.discard(mail[0])
        self._mail.comm.Free()


def _name(rank: int) -> str:
    return f"process {rank}"


def _sendable(fault: BaseException) -> Any:
    """The exception that the other processes raise: the same one, or one with the same message."""
    if isinstance(fault, Failed):
        return fault._made_of
    try:
        pickle.loads(pickle.dumps(fault))
        return fault
    except Exception:
        return RuntimeError(str(fault))


def serve(comm: Any, task: Task) -> Dict[str, Any]:
    """For the other processes: does parts until process 0 ends the run. Returns the facts of the
    report; raises the exception of process 0."""
    mail = _Mail(comm.Dup())
    performer = task.performer()
    last: Optional[tuple[str, Any]] = None
    looked = time.monotonic()

    def over() -> bool:
        nonlocal last, looked
        if last is None and time.monotonic() - looked > 0.05:
            looked = time.monotonic()
            found = mail.receive(_to_worker)
            if found is not None:  # While it works, nothing but the end comes.
                last = found[1]
        return last is not None

    idle = 0
    interrupted = False
    while last is None or last[0] not in ("over", "fault"):
        try:
            found = ((0, last) if last is not None else mail.receive(_to_worker))
            last = None
            if found is None:
                _pause(idle)
                idle += 1
                continue
            idle = 0
            what, content = found[1]
            if what != "part":
                last = found[1]
            elif not interrupted:
                mail.send(performer.run(content, over), 0, _to_leader)
        except KeyboardInterrupt as fault:
            # Process 0 ends the run for all; without it the others would wait for this one.
            if interrupted:
                raise
            interrupted = True
            mail.send(fault, 0, _to_leader)
        except Exception as fault:
            mail.send(RuntimeError(f"process {comm.rank} cannot send what it computed: {fault}"),
                      0, _to_leader)
    performer.close()
    mail.send(None, 0, _to_leader)
    idle = 0
    while not mail.arrived():
        _pause(idle)
        idle += 1
    mail.comm.Free()
    if last[0] == "fault":
        if isinstance(last[1], BaseException):
            raise last[1]
        raise failed(*last[1])
    facts: Dict[str, Any] = last[1]
    return facts
