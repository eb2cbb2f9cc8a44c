"""The exception of a run on a cluster when a function of its caller raises."""

from __future__ import annotations

from typing import Any, Optional, Tuple, Type

from ..errors import Error
from ._worker import Failure


class Failed(Error):
    """load(), compute() or sink() raised: the message names the item or the pair. It is also an
    instance of the class that was raised, if that class is available here: `except KeyError` works.
    """

    what: str = ""  # 'load', 'compute', 'sink', 'cost', 'sizes'; 'result': it cannot be unpickled
    items: Tuple[int, ...] = ()  # the item, or both items of the pair
    trace: str = ""  # of the worker
    _made_of: Optional[Tuple[Failure, str]] = None  # from which other processes make it, too

    def __str__(self) -> str:
        return str(self.args[0]) if self.args else ""

    def __reduce__(self) -> Any:  # Its class is made when it is raised, and has no name to find.
        return super().__reduce__() if self._made_of is None else (failed, self._made_of)


def failed(failure: Failure, where: str) -> Failed:
    """The exception for a failure; its cause is the original one, if that could be sent."""
    cause = failure.exception()
    what = "unpickling the result of compute" if failure.what == "result" else failure.what
    call = f"{what}({', '.join(map(str, failure.items))})"
    says = " ".join(failure.says.split())
    message = f"{call} raised {failure.raised}" + (f": {says}" if says else "")
    if where:
        message += f" (on {where})"
    fault = _instance(message, type(cause) if cause is not None else None)
    fault.what, fault.items, fault.trace = failure.what, failure.items, failure.trace
    fault.__cause__ = cause
    fault._made_of = failure, where
    return fault


def _instance(message: str, also: Optional[Type[BaseException]]) -> Failed:
    if also is not None and issubclass(also, Exception) and not issubclass(Failed, also):
        try:
            kind: Any = type(f"Failed{also.__name__}", (Failed, also), {"__module__": __name__})
            fault: Failed = kind.__new__(kind, message)
            fault.args = (message,)
            return fault
        except Exception:  # Classes that cannot be mixed.
            pass
    return Failed(message)
