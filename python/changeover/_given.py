"""What callers give where several kinds of objects would do: lists, tables of columns, texts."""

from __future__ import annotations

import collections
import collections.abc
import datetime
import operator
import os
from typing import Any, Callable, Dict, Iterable, NoReturn, Optional, Tuple, TypeVar, Union

from . import _core
from .errors import BadInput

T = TypeVar("T")
_most_seconds = 3153600000  # a hundred years
_most_threads = 1024
Path = Union[str, "os.PathLike[str]"]


def words_of(value: Any) -> str:
    """The words of a value; BadInput for what is not text in UTF-8."""
    text = str(value)
    try:
        text.encode()
    except UnicodeEncodeError:
        raise BadInput(f"{ascii(text)[:80]} cannot be written as UTF-8; remove what is half of a "
                       "character") from None
    return text


def day_of(argument: str, day: Any) -> str:
    """A day as 2025-03-31: of a text as it is, of a date or a time its day."""
    if is_text(day):
        return words_of(day)
    if not isinstance(day, datetime.date):
        raise TypeError(f"{argument} is a day, as '2025-03-31' or a datetime.date, not "
                        f"{_core.quoted(words_of(repr(day)))}")
    return f"{day.year:04}-{day.month:02}-{day.day:02}"


def is_text(value: Any) -> bool:
    return isinstance(value, (str, collections.UserString))


def is_bytes(value: Any) -> bool:
    return isinstance(value,
                      (bytes, bytearray)) or (isinstance(value, memoryview) and value.format == "B")


def file_name(argument: str, path: Any) -> Optional[str]:
    """The name of a file, with what is no UTF-8 as Python has it; None for what names none. Raises
    BadInput for one with a zero byte, of which what opens files takes the beginning."""
    if isinstance(path, collections.UserString):
        path = str(path)
    name = attempt(os.fsdecode, path)
    if name is not None and "\0" in name:
        shown = _core.quoted(name.encode(errors="backslashreplace").decode())
        raise BadInput(f"{argument}: {shown} is not a file name; remove the zero byte")
    return name


def in_bytes(path: Any) -> bytes:
    """The name of a file for the compiled module."""
    return os.fsencode(path)


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
    if time is not None and not 0 <= time <= _most_seconds:
        raise BadInput(f"time is a number of seconds, 0 to {_most_seconds}")
    if not 1 <= threads <= _most_threads:
        raise BadInput(f"threads {threads} is out of range; give 1 to {_most_threads}")
    limits = {"seconds": time,
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


def rows_in_buffer(value: Any) -> Optional[Tuple[memoryview, int]]:
    """The numbers of a buffer of two dimensions of whole numbers, row by row, and how many are in a
    row; None of anything else. An array with a mask is something else: some of it is not there."""
    if getattr(value, "mask", None) is not None:
        return None
    view = attempt(memoryview, value)
    form = view.format if view is not None else ""
    kinds = [sizes for letters, sizes in (("bhilqn", "bhiq"), ("BHILQN", "BHIQ"))
             if form[-1:] and form[-1:] in letters]
    if view is None or view.ndim != 2 or not kinds or not (len(form) == 1 or form[0] in "=@<"):
        return None
    letter: Any = kinds[0][view.itemsize.bit_length() - 1]
    return memoryview(view.tobytes()).cast(letter), (view.shape or (0, 0))[1]


def truth_of(argument: str, value: Any) -> bool:
    """Not of a text: 'no' would be true."""
    if not hasattr(type(value), "__bool__"):
        shown = words_of(value if is_text(value) else repr(value))
        raise TypeError(f"{argument} is True or False, not {_core.quoted(shown)}")
    return bool(value)


def has_numbered_rows(table: Any) -> bool:
    """Whether the index, of a table or of a Series, is whole numbers."""
    return getattr(getattr(table.index, "dtype", None), "kind", "") in ("i", "u")


def listed(argument: str, holds: str, value: Any, ordered: bool = False) -> Iterable[Any]:
    """Returns the value if it is an iterable of the expected items, `holds`.

    Raises TypeError for a string, bytes, a mapping or a DataFrame, whose iteration gives something
    else, and, if `ordered`, for a set.
    """
    def refuse(what: str) -> NoReturn:
        raise TypeError(f"{argument} must be a list of {holds}{what}")
    if is_text(value):
        refuse(", not a string")
    if is_bytes(value):
        refuse(", not bytes")
    if isinstance(value, collections.abc.Mapping):
        refuse(", not a dict, whose values would be lost; give keys() or values() of it")
    if is_data_frame(value):
        refuse(", not a DataFrame; give to_dict('records') of it, or one of its columns")
    if isinstance(value, memoryview) and value.ndim != 1:
        refuse(", not a memoryview of other than one dimension; give tolist() of it")
    if hasattr(value, "tocoo"):
        refuse(", not a sparse matrix; give numpy.column_stack(x.nonzero()) of it for its places")
    some: Iterable[Any] = value
    if attempt(iter, some) is None:  # An array without dimensions has no rows.
        refuse(f", not {_core.quoted(words_of(repr(value)))}")
    if ordered and isinstance(value, (set, frozenset)):
        holds = holds.partition(",")[0]
        refuse(" in an order, and a set has none; give sorted(...) of it")
    return some


def rows_of(argument: str, holds: str, value: Any, ordered: bool = False) -> Iterable[Any]:
    """The same; of a table of columns its rows, if its index says nothing."""
    if not is_data_frame(value):
        return listed(argument, holds, value, ordered)
    if not has_numbered_rows(value):
        raise TypeError(
            f"{argument}: the index of the DataFrame would be lost; give reset_index() of it")
    rows: Iterable[Any] = value.itertuples(index=False, name=None)
    return rows
