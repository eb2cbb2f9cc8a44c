"""Lower bounds with their reasons, what is known, and tables of both."""

from __future__ import annotations

import importlib
from typing import (
    Any, Dict, Iterable, List, Literal, Optional, SupportsIndex, Tuple, Union, overload)

from . import _core
from ._given import attempt
from ._made import Kind, Made, check_calls, count_of, fact, in_a_line, known, made, name_of, whole
from ._notebook import Prose, Shown, shown, table as html_table
from .designs import Design
from .errors import BadInput
from .pictures import Picture, Theme, drawn

Range = Union[int, range, Tuple[int, int]]


class Bound(Made):
    """A number of blocks that no design goes below, and why."""

    blocks: int = fact("No design has fewer.")
    name: str = fact("'counting', 'degree', 'stays', …")
    reason: str = fact("One line of plain mathematics.")

    def __repr__(self) -> str:
        return f"<at least {self.blocks} ({self.name})>"


class Counted(Made):
    """The number of all designs with a given number of blocks: `classify` counted them once."""

    b: int = fact("Blocks of each.")
    standard_forms: int = fact()
    classes: int = fact("Isomorphism classes.")
    tight: int = fact("Classes of tight designs.")
    group_orders: Dict[int,
                       int] = fact("How many classes have an automorphism group of each order.")

    def __repr__(self) -> str:
        return f"<{count_of(self.classes, 'class', 'classes')}>"


class Bounds(Shown, Made):
    """What is known of the least number of blocks."""

    v: int = fact()
    k: int = fact()
    change: int = fact()
    kind: str = fact("'linear' or 'circular'.")
    strength: int = fact()
    lower_bound: Optional[int] = fact("The largest lower bound; None if no design exists.")
    reason: str = fact("Of the bound, or why no design exists; one line.")
    best_known: Optional[int] = fact("Blocks of the best design that is known, or None.")
    construction: str = fact("What makes that design.")
    reported: Optional[Tuple[int, str]] = fact(
        "Fewer blocks that a publication reports and that are not held here, so not verified, "
        "and its key in the references; or None.")
    classified: Optional[Counted] = fact(
        "How many designs have as many blocks as the best one; None if they were not counted.")
    all: List[Bound] = fact("Every bound that applies, largest first.")
    status: str = fact("'minimum', 'best-known', 'open' or 'impossible'.")

    def __repr__(self) -> str:
        return f"<{self._core}: {self.status}>"

    def to_latex(self) -> str:
        """A list of the bounds with \\cite commands, as `changeover bounds --format latex` has it.
        """
        return self._latex(", cited")

    def _repr_latex_(self) -> str:
        return self._latex("")

    def _latex(self, cited: str) -> str:
        text: str = _core.known("bounds in LaTeX" + cited, v=self.v, k=self.k, change=self.change,
                                kind=self.kind, strength=self.strength)
        return text

    def _on_page(self) -> Any:
        how = "found by a search" if self.construction == "found" else f"by {self.construction}"
        lines = [f"best known: {count_of(self.best_known, 'block')}, {how}"] if (
            self.best_known is not None) else []
        rows = [(each.blocks, each.name, Prose(each.reason)) for each in self.all]
        if not rows:
            lines.append(Prose(self.reason))
        return (f"{self._core}: {self.status}", lines, ("at least", "bound", "reason"), rows,
                len(rows))


class Cell(Made):
    """What is known of one set of parameters: a cell of a table."""

    v: int = fact()
    k: int = fact()
    change: int = fact()
    kind: str = fact()
    b: Optional[int] = fact("Blocks of the best design that is known, or None.")
    lower_bound: Optional[int] = fact()
    reason: str = fact()
    status: str = fact("'minimum', 'best-known', 'open' or 'impossible'.")
    construction: Optional[str] = fact("What makes the best design that is known, by name.")

    def __repr__(self) -> str:
        return f"<{self._core}: {self.status}>"


class Table(List[Cell]):
    """Cells by kind, k, v: a list, which notebooks show with a row for each v. Parts and sums of
    tables are tables."""

    @overload
    def __getitem__(self, index: SupportsIndex) -> Cell: ...
    @overload
    def __getitem__(self, index: slice) -> Table: ...

    def __getitem__(self, index: Any) -> Any:
        found = super().__getitem__(index)
        return Table(found) if isinstance(index, slice) else found

    def __add__(self, other: Any) -> Any:
        both = super().__add__(other)
        return Table(both) if isinstance(other, Table) else both

    def to_frame(self) -> Any:
        """A pandas.DataFrame with one row for each cell. Raises ImportError without pandas."""
        return _frame_of(self)

    def to_latex(self) -> str:
        """A table with \\cite commands for booktabs and longtable, as
        `changeover table --format latex` has it. Raises BadInput for a table that is not a whole
        range."""
        text = self._latex(True)
        if text is None:
            raise BadInput("these are not all cells of a range of v and k, in LaTeX a table is; "
                           "changeover.table() makes one")
        return text

    def draw(
        self, measure: Literal["ratio", "status", "gap"] = "ratio", *, theme: Theme = "light"
    ) -> Picture:
        """A picture with a square for each cell, whose colour says how many times the lower bound
        the blocks are, what is known, or how many blocks more than the bound; kinds below each
        other. Raises BadInput if there is no cell, or there are too many."""
        places = self._places()
        if places is None:
            raise BadInput("a picture is of cells of one change number, each once; "
                           "changeover.table() makes such a table")
        return drawn(_core.draw_heatmap(places, self[0].change, measure, theme))

    def _places(self) -> Optional[List[Tuple[int, int, str]]]:
        places = [(cell.v, cell.k, cell.kind) for cell in self]
        whole = len(set(places)) == len(places) and len({cell.change for cell in self}) == 1
        return places if whole else None

    def _latex(self, cited: bool) -> Optional[str]:
        places = self._places()
        if places is None:
            return None
        text: Optional[str] = _core.latex_grid(places, self[0].change, cited)
        return text

    def _repr_latex_(self) -> Optional[str]:
        return self._latex(False)

    def _repr_svg_(self) -> Optional[str]:
        most_cells = 4000
        return self.draw().svg if len(self) <= most_cells and self._places() else None

    def _repr_html_(self) -> str:
        parts = []
        for kind in dict.fromkeys(cell.kind for cell in self):
            cells = {(cell.v, cell.k): cell for cell in self if cell.kind == kind}
            ks = sorted({k for _, k in cells})
            rows = [[v, *(_in_a_word(cells.get((v, k))) for k in ks)]
                    for v in sorted({v for v, _ in cells})]
            change = {1: "single", 2: "double"}.get(self[0].change, str(self[0].change))
            parts.append(shown(
                f"{kind} {change}-change covering designs: blocks of the best known "
                "(= minimum, - none exists)", (),
                html_table(["v", *(f"k={k}" for k in ks)], rows, len(rows))))
        return "\n".join(parts)


def _in_a_word(cell: Optional[Cell]) -> str:
    if cell is None:
        return ""
    if cell.b is None:
        return "-" if cell.status == "impossible" else "?"
    return f"{cell.b}=" if cell.status == "minimum" else str(cell.b)


def bounds(
    v: int, k: int, change: int = 2, kind: Optional[Kind] = None, strength: int = 2
) -> Bounds:
    """Lower bounds on the number of blocks with their reasons, and the best design that is known.

    kind 'linear' or 'circular', or None: that of design(), which has fewer blocks known, circular
    if both have as many. Raises ImpossibleParameters if no such blocks can be written down.
    """
    facts = known("bounds", v=v, k=k, change=change, kind=kind, strength=strength)
    facts["all"] = [made(Bound, {**each, "blocks": each.pop("lower_bound")})
                    for each in facts.pop("bounds")]
    facts["construction"] = facts["construction"] or ""
    reported = facts["reported"]
    facts["reported"] = reported and (reported["blocks"], reported["cites"])
    counted = facts["classified"]
    if counted is not None:
        counted["group_orders"] = {each["order"]: each["classes"] for each in counted.pop("groups")}
        facts["classified"] = made(Counted, counted)
    return made(Bounds, facts, name_of(**facts))


def _ends(what: Any, name: str) -> Tuple[int, int]:
    """The first and the last of an int, a range or a pair."""
    if isinstance(what, range):
        if len(what) == 0 or what.step != 1:
            raise BadInput(f"{name} must be a range with step 1 that is not empty, not {what}")
        return what[0], what[-1]
    pair = what if isinstance(what, tuple) and len(what) == 2 else (what, what)
    first, last = (attempt(whole, end) for end in pair)
    if first is None or last is None:
        raise TypeError(f"table(): {name} is a whole number, a range or a pair (first, last), not "
                        f"{in_a_line(what)}")
    return first, last


def table(k: Range, v: Range, change: int = 2, kind: Optional[Kind] = None) -> Table:
    """The best known design for every v and k of a range, with its lower bound.

    ``k`` and ``v`` are an int, a range such as ``range(3, 9)``, or a pair (first, last). Cells come
    by kind (circular first if none is named), k, v. A few milliseconds a cell; raises BadInput
    beyond v = 1000.
    """
    (k_from, k_to), (v_from, v_to) = _ends(k, "k"), _ends(v, "v")
    cells = known("table", k_from=k_from, k_to=k_to, v_from=v_from, v_to=v_to, change=change,
                  kind=kind)
    return Table(made(Cell, facts, name_of(**facts)) for facts in cells)


def to_pandas(what: Any) -> Any:
    """A pandas.DataFrame of a table (one row per cell), a design (one row per block), run sheets
    (one row per test), or a load order (one row per step).

    Raises ImportError without pandas, TypeError for anything else.
    """
    if hasattr(type(what), "to_frame"):
        return what.to_frame()
    cells: Optional[List[Any]] = attempt(list, what)
    if cells is None or not all(isinstance(cell, Cell) for cell in cells):
        raise TypeError("to_pandas(): what is a table, a design, a run sheet, or what else has "
                        f"to_frame(), not {in_a_line(what)}")
    return _frame_of(cells)


def _frame_of(cells: Iterable[Cell]) -> Any:
    pandas: Any = importlib.import_module("pandas")
    columns = ("v", "k", "change", "kind", "b", "lower_bound", "status", "construction")
    frame = pandas.DataFrame([[getattr(cell, name) for name in columns] for cell in cells],
                             columns=columns)
    # Whole numbers also where some cells have none.
    return frame.astype({"b": "Int64", "lower_bound": "Int64"})


def to_sage(what: Design) -> Any:
    """A design as Sage's IncidenceStructure, blocks in their order. Raises ImportError outside of
    Sage."""
    sage: Any = importlib.import_module("sage.combinat.designs.incidence_structures")
    points: List[Any] = list(range(what.v)) if what.labels is None else what.labels
    return sage.IncidenceStructure(points, [[points[x] for x in block] for block in what.blocks])


check_calls(globals())
