"""What callers give where several kinds of objects would do: lists, tables of columns, texts."""

from __future__ import annotations

import collections
import collections.abc
import math
import operator
from typing import Any, Callable, Dict, Iterable, NoReturn, Optional, Tuple, TypeVar

from . import _core
from .errors import BadInput

T = TypeVar("T")


def words_of(value: Any) -> str:
    """The words of a value; UnicodeEncodeError, a ValueError, for what is not text in UTF-8."""
    text = str(value)
    text.encode()
    return text


def is_text(value: Any) -> bool:
    return isinstance(value, (str, collections.UserString))


def is_bytes(value: Any) -> bool:
    return isinstance(value,
                      (bytes, bytearray)) or (isinstance(value, memoryview) and value.format == "B")


def file_name(argument: str, name: str) -> str:
    """The name; BadInput for one with a zero byte, of which what opens files takes the beginning."""
    if "\0" in name:
        raise BadInput(f"{argument}: {_core.quoted(name)} is not a file name; remove the zero byte")
    return name


def attempt(read: Callable[[Any], T], value: Any) -> Optional[T]:
    """What it reads, or None, whatever the class of the value raises."""
    try:
        return read(value)
    except Exception:
        return None


def share_of(share: Any) -> Tuple[int, int]:
    """(part, parts), the whole if it is None."""
    try:
        part, parts = (0, 1) if share is None else map(operator.index, share)
    except Exception:
        part, parts = 1, 0
    if not 0 <= part < parts < 1 << 64:
        raise BadInput("share is (part, parts), two numbers, the first from 0 and below the second")
    return part, parts


def of_search(time: Optional[float], threads: int, seed: int) -> Dict[str, Any]:
    """The keys of a request for the arguments of a search."""
    limits = {"seconds": time if time is None or math.isfinite(time) else str(time),
              "threads": None if threads == 1 else threads, "seed": None if seed == 1 else seed}
    return {key: value for key, value in limits.items() if value is not None}


def is_whole(value: Any) -> bool:
    """Whether it is one whole number: True is none, and an array of NumPy has an index, too."""
    kind = type(value)
    return (hasattr(kind, "__index__") and not hasattr(kind, "__iter__")
            and not isinstance(value, bool))


def is_data_frame(value: Any) -> bool:
    return hasattr(value, "itertuples") and hasattr(value, "columns")


def leads_from_keys(value: Any) -> bool:
    """Whether it is a mapping, or pandas' Series."""
    return isinstance(value, collections.abc.Mapping) or (
        hasattr(value, "items") and hasattr(value, "index") and not is_data_frame(value))


def is_missing(value: Any) -> bool:
    """Whether a value is None, NaN, or pandas.NA or NaT."""
    if value is None or type(value).__name__ in ("NAType", "NaTType"):
        return True
    try:
        return not is_text(value) and bool(value != value)
    except Exception:  # An array has no answer.
        return False


def has_numbered_rows(table: Any) -> bool:
    """Whether the index, of a table or of a Series, is whole numbers."""
    return getattr(getattr(table.index, "dtype", None), "kind", "") in ("i", "u")


def listed(argument: str, holds: str, value: Any, ordered: bool = False) -> Iterable[Any]:
    """The value, if going through it gives what is meant; TypeError for a string, whose letters
    that would be, and the like."""
    def refuse(what: str) -> NoReturn:
        raise TypeError(f"{argument} must be a list of {holds}{what}")
    if is_text(value):
        refuse(", not a string")
    if is_bytes(value):
        refuse(", not bytes")
    if isinstance(value, collections.abc.Mapping):
        refuse(", not a dict, whose values would be lost")
    if is_data_frame(value):
        refuse(", not a DataFrame; give its rows, or one of its columns")
    if not isinstance(value, collections.abc.Iterable):
        refuse(f", not {_core.quoted(words_of(repr(value)))}")
    if ordered and isinstance(value, (set, frozenset)):
        holds = holds.partition(",")[0]
        refuse(" in an order, and a set has none; give sorted(...) of it")
    return value


def rows_of(argument: str, holds: str, value: Any, ordered: bool = False) -> Iterable[Any]:
    """The same; of a table of columns its rows, if its index says nothing."""
    if not is_data_frame(value):
        return listed(argument, holds, value, ordered)
    if not has_numbered_rows(value):
        raise TypeError(
            f"{argument}: the index of the DataFrame would be lost; give reset_index() of it")
    rows: Iterable[Any] = value.itertuples(index=False, name=None)
    return rows
