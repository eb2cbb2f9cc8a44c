"""Searches and classifications: they end when they are asked to, and keep what they found."""

from __future__ import annotations

import operator
from typing import Any, Dict, Iterable, List, Optional, Tuple

from . import _core
from ._given import is_whole, listed, share_of
from ._made import Kind, Made, Progress, check_calls, count_of, fact, linear_unless_said, made
from ._notebook import Prose, Shown
from .designs import Design, design_of


class SearchResult(Shown, Made):
    """What a search found before it ended; the best so far if it was stopped."""

    design: Optional[Design] = fact("The best design, verified, or None.")
    b: Optional[int] = fact("Its number of blocks, or None.")
    lower_bound: int = fact("No design that was asked for has fewer blocks.")
    reason: str = fact("Of the bound, if the search was exact.")
    minimum: bool = fact(
        "Proved: nothing that was asked for has fewer blocks than `design`, or nothing exists.")
    why_stopped: str = fact("'found', 'exhausted', 'time limit', 'interrupted', …")
    interrupted: bool = fact("Ctrl-C ended it.")
    how: str = fact("How the design was found, one line.")
    moves: int = fact("Proposals of the local search.")
    seconds: float = fact()

    def __repr__(self) -> str:
        found = "no design" if self.b is None else count_of(self.b, "block")
        return f"<SearchResult: {found}, at least {self.lower_bound}, {self.why_stopped}>"

    def _on_page(self) -> Any:
        lines = [Prose(line) for line in (self.how, self.reason) if line]
        if self.minimum:
            lines.append(Prose("proved: no design that was asked for has fewer blocks"))
        title = repr(self)[len("<SearchResult: "):-1]
        if self.design is None:
            return title, lines, (), (), 0
        return (title, lines, *self.design._rows())


class Classification(Shown, Made):
    """All designs with a given number of blocks, up to isomorphism."""

    standard_forms: int = fact()
    classes: int = fact("Isomorphism classes.")
    tight: int = fact("Classes of tight designs.")
    complete: bool = fact("These are all; otherwise the search was stopped, and these are some.")
    interrupted: bool = fact()
    group_orders: Dict[int,
                       int] = fact("How many classes have an automorphism group of each order.")
    designs: List[Design] = fact("The first `keep` representatives.")
    prefixes: int = fact("Into which the search was cut; more shares than these have nothing to "
                         "do. 0 if shares were taken by a cluster.")
    prefixes_done: int = fact("Those that were explored to their end: how far a search came that "
                              "was stopped.")

    def __repr__(self) -> str:
        rest = "" if self.complete else ", not all"
        return f"<{count_of(self.classes, 'class', 'classes')}{rest}>"

    def _on_page(self) -> Any:
        lines = [f"{count_of(self.standard_forms, 'design')} in standard form, "
                 f"{self.tight} of the classes tight"]
        rows = sorted(self.group_orders.items())
        return (repr(self)[1:-1], lines, ("order of the group", "classes"), rows, len(rows))


def _elements(argument: str, elements: Any) -> List[int]:
    numbers = list(listed(argument, "elements, whole numbers from 0 to v-1", elements))
    if any(not is_whole(x) or not 0 <= operator.index(x) < 1 << 32 for x in numbers):
        raise TypeError(f"{argument} must be a list of elements, whole numbers from 0 to v-1")
    return [operator.index(x) for x in numbers]


def search(
    v: int, k: int, change: int = 2, kind: Optional[Kind] = None, strength: int = 2, *,
    time: Optional[float] = 60.0, threads: int = 1, seed: int = 1, target: Optional[int] = None,
    start: Optional[Design] = None, exact: bool = False, progress: Progress = None,
    first: Iterable[int] = (), last: Iterable[int] = (), expansion_set: bool = False,
    contains: Iterable[Iterable[int]] = (), anew: bool = False,
) -> SearchResult:
    """Looks for a design with fewer blocks than any that is known, for `time` seconds (None: until
    it is the lower bound) with `threads` threads. kind is 'linear' unless said.

    exact=True walks up from the lower bound and proves each number of blocks impossible, with
    checked proofs, until there is a design: the minimum. first and last: elements of the first and
    of the last block. expansion_set: unchanged subsets together hold every other element once.
    contains: blocks that are in it, one after another. With any of these the result, and with
    exact=True what is proved, is about designs that have them; anew=True begins with no known
    design, else with the best one that has them. progress is called now and then with a
    dict (phase, steps, best, elapsed, left, ...); what it raises ends the search and arrives here.
    Ctrl-C ends it and keeps the best so far, marked interrupted. With one thread the result of a
    search that no clock ends depends on the seed alone.
    """
    facts = _core.search(
        v, k, change, linear_unless_said(kind), strength, time, threads, seed, target,
        start and start._core, exact, progress, _elements("first", first),
        _elements("last", last), expansion_set,
        [_elements("contains", block) for block in listed("contains", "blocks", contains, True)],
        anew)
    core = facts["design"]
    found = core and design_of(core)
    return made(SearchResult, {**facts, "design": found, "b": found and found.b})


def classify(
    v: int, k: int, b: int, change: int = 2, kind: Optional[Kind] = None, *,
    reversal: bool = False, keep: int = 100, time: Optional[float] = None, threads: int = 1,
    progress: Progress = None, share: Optional[Tuple[int, int]] = None,
) -> Classification:
    """All designs with exactly b blocks up to names of elements and rotation, and reversal if asked
    for. kind is 'linear' unless said.

    share: (part, parts), from (0, n) to (n - 1, n): only that part of the search. Every class is
    found by one part, so the counts of all parts add up.
    Raises ImpossibleParameters above 64 elements or 4096 blocks. Exponential in b.
    """
    facts = _core.classify(
        v, k, b, change, linear_unless_said(kind), reversal, keep, time, threads, progress,
        share_of(share))
    orders = {int(order): count for order, count in facts["group_orders"]}
    designs = [design_of(core) for core in facts["designs"]]
    return made(Classification, {**facts, "group_orders": orders, "designs": designs})


check_calls(globals())
