"""The catalog that comes with the package, and the user's own."""

from __future__ import annotations

import datetime
import json
import re
import typing
from typing import Any, Dict, List, Optional, Union

from . import _core
from ._given import day_of
from ._made import Kind, Made, check_calls, fact, in_a_line, made
from ._notebook import Prose, Shown
from .designs import Design, design_of
from .errors import BadInput

__all__ = ["add", "cell", "entries", "find"]
_statuses = ("", "minimum", "best-known", "retracted")


class Entry(Shown, Made):
    """A design of the catalog, with all that is said of it."""

    label: str = fact("Permanent; made of the parameters and the blocks alone.")
    v: int = fact()
    k: int = fact()
    change: int = fact()
    kind: str = fact()
    strength: int = fact()
    b: int = fact()
    lower_bound: int = fact("That was known when the entry was written.")
    reason: str = fact()
    status: str = fact("'minimum', 'best-known' or 'retracted'.")
    credit: Dict[str, str] = fact("A dict with who, date, program, command.")
    cites: List[str] = fact("Keys of the references.")
    note: str = fact("What was said when it was added.")
    retracted: str = fact("Why it is no longer vouched for; empty if it is.")

    if not typing.TYPE_CHECKING:  # Only for what is not there.

        def __getattr__(self, name):
            """The facts, when the first of them is asked for: lists of entries are long."""
            if name != "_facts":
                return super().__getattr__(name)
            self._facts = self._core.facts()
            return self._facts

    def _kept(self) -> Any:
        return self._core.line()

    @classmethod
    def _core_again(cls, kept: Any, facts: Dict[str, Any]) -> Any:
        core = _core.Entry.of_line(kept)
        if core.facts() != facts:
            raise BadInput("another version of changeover pickled this Entry; find it again")
        return core

    @property
    def recipe(self) -> Dict[str, Any]:
        """How its blocks are made."""
        recipe: Dict[str, Any] = json.loads(self._core.recipe())
        return recipe

    def design(self) -> Design:
        """Its blocks, built and verified."""
        return design_of(self._core.design())

    def __repr__(self) -> str:
        return f"<{self.label}>"

    def _on_page(self) -> Any:
        credit = ", ".join(self.credit[key] for key in ("who", "date") if self.credit.get(key))
        rows = [("blocks", self.b), ("lower bound", self.lower_bound),
                ("reason", Prose(self.reason)), ("status", self.status),
                ("construction", self.recipe["construction"]), ("credit", credit),
                ("references", self.cites), ("note", self.note), ("retracted", self.retracted)]
        said = [row for row in rows if row[1] not in ("", [])]
        return self.label, (), ("entry", "value"), said, len(said)


def _entry(core: Any) -> Any:
    return core and made(Entry, None, core)


def find(label: str) -> Optional[Entry]:
    """The entry of a label, of an alias, or of the beginning of one label alone; None if there is
    none. Raises BadInput for the beginning of several, or of none if it ends before the number of
    blocks."""
    entry: Optional[Entry] = _entry(_core.Entry.find(label))
    return entry


def cell(
    v: int, k: int, change: int = 2, kind: Optional[Kind] = None, strength: int = 2
) -> List[Entry]:
    """All entries of a cell, of both kinds if none is named, fewest blocks first, retracted ones
    too."""
    found = [_entry(core) for each in (["circular", "linear"] if kind is None else [kind])
             for core in _core.Entry.cell(v, k, change, each, strength)]
    return sorted(found, key=lambda entry: entry.b)


def entries(
    *, v_from: Optional[int] = None, v_to: Optional[int] = None, k_from: Optional[int] = None,
    k_to: Optional[int] = None, change: Optional[int] = None, kind: Optional[Kind] = None,
    status: str = "", best_only: bool = True, users_only: bool = False,
) -> List[Entry]:
    """A list of the entries that are asked for, by change, kind, k, v, b; the best of each cell
    only unless said."""
    if status not in _statuses:
        raise BadInput(f"status is 'minimum', 'best-known' or 'retracted', not {in_a_line(status)}")
    found = _core.Entry.all(v_from, v_to, k_from, k_to, change, kind, status, best_only, users_only)
    return [_entry(core) for core in found]


def add(design: Design, *, who: str, date: Union[str, datetime.date], note: str = "") -> str:
    """Puts a design into the user's catalog and returns its label. Raises BadInput if it is
    none."""
    try:
        label: str = _core.Entry.add(design._core, who, day_of("date", date), note)
    except BadInput as fault:
        # No file has the line that is at fault.
        words = re.sub(r"^the design:\d+:\d+: ", "", str(fault))
        raise BadInput(words) from None
    return label


check_calls(globals())
