"""Engines bring the parts of a job to workers and the results back. Each supports one kind of
client."""

from __future__ import annotations

import dataclasses
import sys
import time
from typing import Any, Callable, Dict, List, NamedTuple, Optional, Protocol

from .. import _core
from .._made import Progress
from ..errors import BadInput
from ._worker import Outcome, Part, Performer

_most_workers = 65_536

Tell = Optional[Callable[[Dict[str, Any]], object]]  # where progress goes


def tell_of(progress: Progress) -> Tell:
    return progress if callable(progress) else None


class Event(NamedTuple):
    """An event. `number` is that of a part; 'joined' and 'lost' concern a worker."""

    kind: str  # 'done', 'lost', 'joined'
    worker: str
    number: int = -1


class Lost(Exception):
    """The result was lost with its worker."""


class Engine(Protocol):
    def workers(self) -> List[str]:
        """The current workers, according to the events so far."""

    def submit(self, worker: str, part: Part) -> None:
        """Sends a part to a worker; an event tells when it is done."""

    def wait(self, seconds: float) -> List[Event]:
        """Returns at the first event, or after the given number of seconds."""

    def outcome(self, number: int) -> Outcome:
        """The result of a part that is done. Raises Lost."""

    def drop(self, number: int) -> None:
        """The result of this part is not needed any more."""

    def now(self) -> float:
        """The seconds of the engine's clock."""

    def close(self) -> None:
        """Makes the workers end their parts and forget the job."""


class RealTime:
    def now(self) -> float:
        return time.monotonic()


def kind_of(client: Any) -> str:
    """'dask', 'mpi' or 'ray'; nothing is imported. Raises TypeError for other objects."""
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
    """A maker with the caller's functions as bytes. Raises TypeError for functions that cannot be
    sent."""
    try:
        made: bytes = pickler.dumps(maker)
        return made
    except Exception as fault:
        raise TypeError(
            f"load and compute cannot be sent to workers: {' '.join(str(fault).split())}"
        ) from fault


@dataclasses.dataclass(frozen=True)
class Task:
    """The work of an engine's workers: `maker` makes a performer from the settings and a number of
    threads."""

    maker: Callable[..., Performer]
    settings: Dict[str, Any]
    threads: Optional[int] = None  # of each worker; None: as many as the engine says, or 1

    def performer(self, threads: int = 1) -> Performer:
        return self.maker(**self.settings, threads=self.threads or threads)


def check_team(threads: Optional[int], workers: Optional[int]) -> None:
    if threads is not None and not 1 <= threads <= _core.most_threads:
        raise BadInput(f"threads is a number from 1 to {_core.most_threads}")
    if workers is not None and not 1 <= workers <= _most_workers:
        raise BadInput(f"workers is a number from 1 to {_most_workers}")
