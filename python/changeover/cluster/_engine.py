"""Engines: what brings parts of a job to workers and outcomes back. Each knows one kind of
client."""

from __future__ import annotations

import dataclasses
import sys
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Protocol

from .._made import Progress
from ..errors import BadInput
from ._worker import Outcome, Part, Performer

_most_threads, _most_workers = 4096, 65_536

Tell = Optional[Callable[[Dict[str, Any]], object]]  # where progress goes


def tell_of(progress: Progress) -> Tell:
    return progress if callable(progress) else None


class Event(NamedTuple):
    """What happened. `number` is that of a part; 'joined' and 'lost' are of a worker."""

    kind: str  # 'done', 'lost', 'joined'
    worker: str
    number: int = -1


class Lost(Exception):
    """The outcome went with its worker."""


class Engine(Protocol):
    def workers(self) -> List[str]:
        """Those that are there now, as far as events have told."""

    def submit(self, worker: str, part: Part) -> None:
        """Has one of them do it; an event tells when it is done."""

    def wait(self, seconds: float) -> List[Event]:
        """Returns at the first event, or after so many seconds."""

    def outcome(self, number: int) -> Outcome:
        """Of a part that is done. Raises Lost."""

    def drop(self, number: int) -> None:
        """The outcome of this part is of no interest any more."""

    def now(self) -> float:
        """The seconds of its clock."""

    def close(self) -> None:
        """Has the workers end what they do and forget the job."""


class RealTime:
    def now(self) -> float:
        return time.monotonic()


def kind_of(client: Any) -> str:
    """'dask', 'mpi' or 'ray'; nothing is imported. Raises TypeError for what is no client."""
    for each in type(client).__mro__:
        if each.__module__.split(".")[0] == "distributed" and each.__name__ == "Client":
            return "dask"
        if each.__module__.split(".")[0] == "mpi4py" and each.__name__ == "Comm":
            return "mpi"
    if client is not None and client is sys.modules.get("ray"):
        return "ray"
    raise TypeError("client is a distributed.Client, an mpi4py communicator or the module ray, not "
                    f"{type(client).__name__}")


def packed(maker: Any, pickler: Any) -> bytes:
    """A maker with the caller's functions as bytes. Raises TypeError for what cannot be sent."""
    try:
        made: bytes = pickler.dumps(maker)
        return made
    except Exception as fault:
        raise TypeError(
            f"load and compute cannot be sent to workers: {' '.join(str(fault).split())}"
        ) from fault


@dataclasses.dataclass(frozen=True)
class Task:
    """What an engine's workers perform: `maker` makes a performer of the settings and a number of
    threads."""

    maker: Callable[..., Performer]
    settings: Dict[str, Any]
    threads: Optional[int] = None  # of each worker; None: as many as the engine says, or 1

    def performer(self, threads: int = 1) -> Performer:
        return self.maker(**self.settings, threads=self.threads or threads)


def check_team(threads: Optional[int], workers: Optional[int]) -> None:
    if threads is not None and not 1 <= threads <= _most_threads:
        raise BadInput(f"threads is a number from 1 to {_most_threads}")
    if workers is not None and not 1 <= workers <= _most_workers:
        raise BadInput(f"workers is a number from 1 to {_most_workers}")
