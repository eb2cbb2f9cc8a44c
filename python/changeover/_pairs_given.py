"""Pairs, groups, costs and sizes of items as callers give them, made into rows of a request."""

from __future__ import annotations

import itertools
import operator
import re
from array import array
from typing import Any, Iterable, List, Optional

from . import _core
from ._given import (
    attempt, has_numbered_rows, is_data_frame, is_text, leads_from_keys, listed,
    rows_in_buffer, rows_of)
from ._made import in_a_line, whole
from .errors import BadInput

_most_items: int = _core.most_items


def item_number(argument: str, number: Any) -> int:
    item = attempt(operator.index, number)
    if item is None:
        mend = "; give int(...) of it, or astype(int) of an array" if attempt(float.is_integer, number) else ""
        raise TypeError(f"{argument}: items are whole numbers, not {in_a_line(number)}{mend}")
    if not 0 <= item < _most_items:
        raise BadInput(
            f"{argument}: items are numbered from 0 to {_most_items - 1}, not {in_a_line(number)}")
    return item


def _ends_at_once(pairs: Any) -> Optional[array[int]]:
    """What given_ends() has of a buffer of whole numbers, or of a list of pairs of them, where
    nothing is wrong; None of anything else."""
    if is_data_frame(pairs) and has_numbered_rows(pairs):
        pairs = attempt(lambda frame: frame.to_numpy(), pairs)
    found = rows_in_buffer(pairs)
    numbers: Iterable[int]
    if found is not None:
        numbers, in_a_row = found
    else:
        is_plain = type(pairs) in (list, tuple) and all(
            type(row) in (list, tuple) and len(row) == 2 for row in pairs)
        numbers, in_a_row = itertools.chain.from_iterable(pairs) if is_plain else (), 2
    if in_a_row != 2 or (found is None and not is_plain):
        return None
    ends = attempt(lambda read: array("I", read), numbers)  # Negative numbers do not fit.
    return ends if ends and max(ends) < _most_items else None


def given_ends(pairs: Any, costs: Optional[List[List[str]]] = None) -> array[int]:
    """Both items of each pair, one after the other. With `costs` rows may have a third column, all
    or none, whose rows are put there."""
    if isinstance(pairs, tuple) and len(pairs) == 2 and all(
            getattr(each, "ndim", None) == 1 for each in pairs):
        raise TypeError("pairs is a tuple of two columns, as of numpy.nonzero(); give "
                        "numpy.column_stack(...) of it")
    at_once = _ends_at_once(pairs)
    if at_once is not None:
        return at_once
    ends = array("I")
    most = "more than two items; a pair has two" if costs is None else (
        "more than two items and a cost; a pair has two")
    for number, row in enumerate(rows_of("pairs", "rows of two items", pairs)):
        more = iter(listed("a row of pairs", "two items", row))
        for _ in range(2):
            for item in more:
                ends.append(item_number("pairs", item))
                break
            else:
                raise BadInput(f"pairs: row {number} has fewer than two items; a pair has two")
        if costs is not None:
            for given in itertools.islice(more, 1):
                cost = attempt(float, given)
                if cost is None:
                    raise BadInput(f"pairs: row {number} has {in_a_line(given)} for a cost; give a "
                                   "number, 0 or more")
                costs.append([str(ends[-2]), str(ends[-1]), repr(cost)])
            if len(costs) not in (0, number + 1):
                raise BadInput(
                    f"pairs: only some of the rows 0 to {number} have a cost; give one to "
                    "every pair or to none"
                )
        for _ in more:
            raise BadInput(f"pairs: row {number} has {most}")
    if not ends:
        raise BadInput("pairs: no pair is listed; give rows of two items")
    return ends


def group_rows(groups: Any) -> List[List[str]]:
    """Rows of the items of each group."""
    rows = [[str(item_number("groups", item))
             for item in listed("a group of groups", "items", group)]
            for group in rows_of("groups", "groups of items", groups)]
    if not all(rows):
        raise BadInput(f"groups: group {rows.index([])} has no items; leave it out")
    return rows


def cost_rows(pair_cost: Any) -> List[List[str]]:
    """Rows of two items and a cost, of a mapping from pairs or of such rows."""
    holds = "rows of two items and a number"
    rows = ((*listed("pair_cost", "pairs of items", pair), cost)
            for pair, cost in pair_cost.items()) if leads_from_keys(pair_cost) else pair_cost
    made_rows: List[List[str]] = []
    for number, row in enumerate(rows_of("pair_cost", holds, rows)):
        *items, cost = list(listed("pair_cost", holds, row)) or [None]
        cost = attempt(float, cost)
        if len(items) != 2 or cost is None:
            raise BadInput(f"pair_cost: row {number} is not (item, item, cost); correct it")
        made_rows.append([*(str(item_number("pair_cost", item)) for item in items), repr(cost)])
    return made_rows


def size_rows(sizes: Any) -> List[Any]:
    """The bytes of items in turn, or rows of an item and its bytes."""
    def size_of(given: Any) -> Any:
        if isinstance(given, str):
            return given
        # pandas makes floats of whole numbers where one is missing.
        size = int(given) if attempt(float.is_integer, given) else attempt(operator.index, given)
        if size is None:
            raise BadInput(f"sizes: {in_a_line(given)} is not a whole number of bytes")
        return int(size)
    if leads_from_keys(sizes):
        return [[str(item_number("sizes", item)), str(size_of(size))]
                for item, size in sizes.items()]
    return [size_of(size) for size in listed("sizes", "numbers of bytes", sizes)]


def memory_of(argument: str, given: Any) -> Optional[int]:
    """Bytes, as a number or as sizes may be: "4M"."""
    if given is None:
        return None
    if not is_text(given):
        number = attempt(whole, given)
        if number is not None:
            return number
        raise TypeError(f"{argument} is a number of bytes, or as in '4M', not {in_a_line(given)}")
    read: Any = re.fullmatch(r"([0-9]{1,15}) ?([KMGTB]?)", str(given))
    if not read:
        raise BadInput(f"{argument}: {in_a_line(given)} is not a number of bytes; write a whole "
                       "number, or with K, M, G or T, as in '4M'")
    size = int(read[1]) * 1000 ** "BKMGT".index(read[2] or "B")
    return int(size)
