"""Change covering designs: made, verified, searched, scheduled.

    >>> import changeover
    >>> d = changeover.design(61, 4, kind="circular")
    >>> d.b, d.verdict.tight, d.verdict.minimum
    (366, True, True)
    >>> d.blocks[0]
    (0, 1, 38, 43)

An m-change covering design is an ordered list of k-element blocks over v elements in which every
pair of elements meets in some block and consecutive blocks differ in exactly m elements
(``change``); circular if the last and the first block do so too. Everything that is handed out was
verified. What takes long lets other threads run, and Ctrl-C ends it.
"""

import importlib
import typing

from . import _core, catalog
from .catalog import Entry
from .designs import (
    Blocks, Design, Stream, Verdict, constructions, design, explain, loads, read, stream, verify)
from .errors import BadInput, Error, ImpossibleParameters, InternalError, MissingResource
from .known import Bound, Bounds, Cell, Counted, Table, bounds, table, to_pandas, to_sage
from .orders import (
    LoadOrder, Report, UpdateReport, WorkerLoads, WorkStep, all_pairs, load_order, update_pairs)
from .pictures import Picture
from .plans import Answer, BenchSheets, RunSheet, plan
from .searches import Classification, SearchResult, classify, search

if typing.TYPE_CHECKING:
    from . import cluster as cluster
else:

    def __getattr__(name):
        """changeover.cluster is loaded when it is needed."""
        if name == "cluster":
            return importlib.import_module("changeover.cluster")
        raise AttributeError(f"module 'changeover' has no attribute '{name}'")


__version__: str = _core.__version__

__all__ = [
    "Answer", "BadInput", "BenchSheets", "Blocks", "Bound", "Bounds", "Cell", "Classification",
    "Counted", "Design", "Entry", "Error", "ImpossibleParameters", "InternalError", "LoadOrder",
    "MissingResource", "Picture", "Report", "RunSheet", "SearchResult", "Stream", "Table",
    "UpdateReport", "Verdict", "WorkStep", "WorkerLoads", "__version__", "all_pairs", "bounds",
    "catalog", "classify", "constructions", "design", "explain", "load_order", "loads", "plan",
    "read", "search", "stream", "table", "to_pandas", "to_sage", "update_pairs", "verify",
]
