"""Change covering designs: made, verified, searched, scheduled.

    >>> import changeover
    >>> d = changeover.design(61, 4, kind="circular")
    >>> d.b, d.verdict.tight, d.verdict.minimum
    (366, True, True)
    >>> d.blocks[0]
    (0, 1, 38, 43)

An m-change covering design is an ordered list of k-element blocks over v elements in which every pair of elements
meets in some block and consecutive blocks differ in exactly m elements (``change``); circular if the last and the first
block do so too. Everything that is handed out was verified. What takes long lets other threads run, and Ctrl-C ends it.
"""

from __future__ import annotations

import sys as _sys

from . import _calls, _core

_calls.say_all_in_one_line(_core)

from ._core import (  # noqa: E402
    BadInput,
    BenchSheets,
    Blocks,
    Bound,
    Bounds,
    Cell,
    Classification,
    Design,
    Entry,
    Error,
    ImpossibleParameters,
    InternalError,
    LoadOrder,
    MissingResource,
    Report,
    RunSheet,
    SearchResult,
    Stream,
    Verdict,
    WorkerLoads,
    __version__,
    all_pairs,
    bounds,
    catalog,
    classify,
    constructions,
    design,
    explain,
    load_order,
    loads,
    plan,
    read,
    search,
    stream,
    verify,
)
from ._core import _table

_sys.modules[__name__ + ".catalog"] = catalog

__all__ = [
    "BadInput", "BenchSheets", "Blocks", "Bound", "Bounds", "Cell", "Classification", "Design", "Entry", "Error",
    "ImpossibleParameters", "InternalError", "LoadOrder", "MissingResource", "Report", "RunSheet", "SearchResult",
    "Stream", "Verdict", "WorkerLoads", "__version__", "all_pairs", "bounds", "catalog", "classify", "constructions", "design",
    "explain", "load_order", "loads", "plan", "read", "search", "stream", "table", "to_pandas", "to_sage", "verify",
]


def _ends(what, name: str) -> tuple[int, int]:
    """The first and the last of an int, a range or a pair."""
    if isinstance(what, range):
        if len(what) == 0 or what.step != 1:
            raise BadInput(f"{name} is a range without gaps, not {what}")
        return what[0], what[-1]
    if isinstance(what, tuple):
        first, last = what
        return first, last
    return what, what


def table(k, v, change: int = 2, kind: str | None = None) -> list[Cell]:
    """The best known design for every v and k of a range, with its lower bound.

    ``k`` and ``v`` are an int, a range such as ``range(3, 9)``, or a pair (first, last). Cells come by kind (circular
    first if none is named), k, v. A few milliseconds a cell; raises BadInput beyond v = 1000.
    """
    return _table(*_ends(k, "k"), *_ends(v, "v"), change, kind)


def to_pandas(what):
    """A pandas.DataFrame of a table (a row a cell), a design (a row a block), or a run sheet (a row a test).

    Raises ImportError without pandas.
    """
    import pandas

    if isinstance(what, RunSheet):
        return pandas.DataFrame(what.steps).set_index("number")
    if isinstance(what, Design):
        names = [f"element_{i + 1}" for i in range(what.k)]
        frame = pandas.DataFrame(what.blocks.tolist(), columns=names)
        if what.labels:
            frame = frame.apply(lambda column: column.map(dict(enumerate(what.labels))))
        frame.index = pandas.RangeIndex(1, what.b + 1, name="block")
        return frame
    columns = ("v", "k", "change", "kind", "b", "lower_bound", "status", "construction")
    return pandas.DataFrame([[getattr(cell, name) for name in columns] for cell in what], columns=columns)


def to_sage(what: Design):
    """A design as Sage's IncidenceStructure, blocks in their order. Raises ImportError outside of Sage."""
    from sage.combinat.designs.incidence_structures import IncidenceStructure

    points = list(range(what.v)) if what.labels is None else what.labels
    return IncidenceStructure(points, [[points[x] for x in block] for block in what.blocks])
