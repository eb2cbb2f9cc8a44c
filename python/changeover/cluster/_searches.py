"""Searches in independent shares: seeds, cubes and subtrees. Results of workers are verified on
arrival."""

from __future__ import annotations

import datetime
import itertools
import operator
import time
import warnings
from typing import Any, Callable, Dict, Iterable, List, Optional, Tuple, Union

from .. import _core, catalog
from .._made import (
    Kind, Made, Progress, check_calls, fact, linear_unless_said, made)
from ..designs import Design, design, design_of
from ..errors import BadInput, Error
from ..known import bounds
from ..searches import Classification, SearchResult
from ..searches import classify as classify_here
from ..searches import search as search_here
from ._bag import Bag, Over, run_bag, unless_over
from ._engine import tell_of
from ._exact import Cell, Tree, Walk, received

_most_cubes = 4096
_most_numbers = 10_000  # of v, and of k


class Improvement(Made):
    """A design that a search on a cluster found, better than the known ones."""

    v: int = fact()
    k: int = fact()
    change: int = fact()
    kind: str = fact()
    strength: int = fact()
    before: Optional[int] = fact("The blocks of the best design that was known.")
    b: int = fact("Those of the design that was found.")
    lower_bound: int = fact()
    label: Optional[str] = fact("In the user's catalog; None if it was not put there.")
    how: str = fact("How the best design was found, one line.")
    design: Design = fact("Verified where it arrived.")

    def __repr__(self) -> str:
        kind = {1: "SCCD", 2: "DCCD"}.get(self.change, f"{self.change}-change CCD")
        return f"<{self.kind} {kind}({self.v},{self.k}): {self.before} -> {self.b} blocks>"


# What workers do. `over` says that the result is not wanted any more.


def _improve_part(over: Callable[[], bool], threads: int, cell: Cell, seconds: float, seed: int,
                  target: Optional[int], start: Optional[Design]) -> Dict[str, Any]:
    v, k, change, kind, strength = cell
    result = search_here(v, k, change, kind, strength, time=seconds, threads=threads, seed=seed,
                         target=target, start=start, progress=unless_over(over))
    if result.interrupted:
        raise Over
    return {"design": result.design, "b": result.b, "how": result.how, "moves": result.moves}


def _decide_part(over: Callable[[], bool], threads: int, cell: Cell, b: int, cubes: int,
                 share: Tuple[int, int], seconds: Optional[float]) -> Dict[str, Any]:
    v, k, change, kind, strength = cell
    facts: Dict[str, Any] = _core.decide_share(
        v, k, change, kind, strength, b, cubes, share, seconds, threads, unless_over(over))
    if facts["interrupted"]:
        raise Over
    found = facts["design"]
    return {**facts, "design": found and design_of(found)}


def _classify_part(over: Callable[[], bool], threads: int, cell: Cell, b: int, reversal: bool,
                   keep: int, share: Tuple[int, int], seconds: Optional[float]) -> Dict[str, Any]:
    v, k, change, kind, _ = cell
    all_of_it = classify_here(v, k, b, change, kind, reversal=reversal, keep=keep, time=seconds,
                              threads=threads, progress=unless_over(over), share=share)
    if all_of_it.interrupted:
        raise Over
    return {"complete": all_of_it.complete, "standard_forms": all_of_it.standard_forms,
            "classes": all_of_it.classes, "tight": all_of_it.tight,
            "group_orders": all_of_it.group_orders, "prefixes": all_of_it.prefixes,
            "designs": all_of_it.designs}


# Local search


class _Cells:
    """The next cell to search: the one with the least search effort relative to its distance from
    the bound."""

    def __init__(self, cells: Iterable[Cell], each: float, seed: int, end: float,
                 target: Optional[int], start: Optional[Design]) -> None:
        self.each, self.end, self.target = each, end, target
        self._seeds = itertools.count(seed)
        self.best: Dict[Cell, Optional[Design]] = {}
        self.before: Dict[Cell, Optional[int]] = {}
        self.bound: Dict[Cell, int] = {}
        self.how: Dict[Cell, str] = {}
        self._spent: Dict[Cell, float] = {}
        self.moves = 0
        self.on_better: Callable[[Cell], None] = lambda cell: None
        for cell in cells:
            v, k, change, kind, strength = cell
            known = bounds(v, k, change, kind, strength)
            if known.lower_bound is None:
                continue
            best = design(v, k, change, kind, strength)
            if start is not None and (best is None or start.b < best.b):
                best = start
            self.best[cell] = best
            self.before[cell] = None if best is None else best.b
            self.bound[cell] = known.lower_bound
            self.how[cell] = "best recipe"
            self._spent[cell] = 0.0

    def is_settled(self, cell: Cell) -> bool:
        best = self.best[cell]
        return best is not None and best.b <= max(self.bound[cell], self.target or 0)

    def over(self) -> bool:
        return time.monotonic() >= self.end or all(map(self.is_settled, self.best))

    def next(self) -> Optional[Dict[str, Any]]:
        left = self.end - time.monotonic()
        open_cells = [cell for cell in self.best if not self.is_settled(cell)]
        if not open_cells or left < 0.05:
            return None

        def need(cell: Cell) -> float:
            best = self.best[cell]
            gap = 1.0 if best is None else (best.b - self.bound[cell]) / self.bound[cell]
            return self._spent[cell] / gap

        cell = min(open_cells, key=need)
        best = self.best[cell]
        self._spent[cell] += self.each
        return {"cell": cell, "seconds": min(self.each, left), "seed": next(self._seeds),
                "target": self.target, "start": best}

    def take(self, arguments: Dict[str, Any], result: Dict[str, Any]) -> None:
        cell = arguments["cell"]
        self.moves += result["moves"]
        best = self.best[cell]
        if result["design"] is not None and (best is None or result["b"] < best.b):
            self.best[cell] = received(result["design"], cell, result["b"])
            self.how[cell] = result["how"]
            self.on_better(cell)


def _each_number(argument: str, value: Any) -> List[int]:
    try:
        some = [value] if hasattr(type(value), "__index__") else itertools.islice(
            value, _most_numbers + 1)
        numbers = [operator.index(each) for each in some]
    except TypeError as fault:
        raise BadInput(f"{argument} is a whole number, or several of them") from fault
    if len(numbers) > _most_numbers:
        raise BadInput(f"{argument} has more than {_most_numbers} numbers; give fewer")
    return numbers


def _limits(time_limit: float, each: float) -> None:
    if not 0 < time_limit <= 1e9 or not 0 < each <= 1e9:
        raise BadInput("time and each are numbers of seconds, more than 0")


def improve(
    client: Any, v: Union[int, Iterable[int]], k: Union[int, Iterable[int]], change: int = 2,
    kind: Optional[Kind] = None, strength: int = 2, *, time: float = 600.0, each: float = 60.0,
    seed: int = 1, threads: Optional[int] = None, who: str = "", workers: Optional[int] = None,
    progress: Progress = None,
) -> List[Improvement]:
    """Searches for better designs on the workers of a cluster, for `time` seconds, in cells that
    are farthest from their bound. Returns the designs that are better than the known ones.

    client: as in all_pairs(). v and k: numbers, or several of each, such as range(20, 41); kind:
    both if None. each: seconds per part, which is a cell with its own seed, starting from the best
    design so far; a lost worker loses at most one part. who: your name: each find is verified and
    added to the user's catalog where this call is made, with this credit; a find that cannot be
    added is still returned, with a warning. Ctrl-C ends the search and keeps its finds.
    """
    _limits(time, each)
    kinds: List[Kind] = ["linear", "circular"] if kind is None else [kind]
    cells = [(a, b, change, c, strength) for a in _each_number("v", v)
             for b in _each_number("k", k) for c in kinds if b <= a]
    labels: Dict[Cell, str] = {}
    faults: Dict[Cell, Error] = {}

    def begin() -> Bag:
        state.append(_Cells(cells, each, seed, _now() + time, None, None))
        state[0].on_better = keep
        return Bag(state[0].take, state[0].next, state[0].over)

    def keep(cell: Cell) -> None:
        found = state[0].best[cell]
        if who and found is not None:
            today = datetime.date.today().isoformat()
            try:
                labels[cell] = catalog.add(found, who=who, date=today)
            except Error as fault:  # The search is worth more than the entry.
                labels.pop(cell, None)
                faults[cell] = fault
            else:
                faults.pop(cell, None)

    def finish(_: Bag) -> Dict[str, Any]:
        run = state[0]
        return {"finds": [(cell, run.before[cell], found, run.bound[cell], labels.get(cell),
                           run.how[cell])
                          for cell, found in run.best.items()
                          if found is not None and found.b != run.before[cell]]}

    state: List[_Cells] = []
    answer = run_bag(client, _improve_part, begin, finish, tell_of(progress), threads,
                     lambda _: {"best": None, "moves": state[0].moves}, workers)
    finds = []
    for cell, before, found, bound, label, how in answer["finds"]:
        names = ("v", "k", "change", "kind", "strength")
        finds.append(made(Improvement, {
            **dict(zip(names, cell)), "before": before, "b": found.b, "lower_bound": bound,
            "label": label, "how": how, "design": found}))
    for fault in dict.fromkeys(map(str, faults.values())):
        warnings.warn(f"finds are in the answer, and not in the catalog: {fault}", stacklevel=3)
    return finds


_now = time.monotonic


def search(
    client: Any, v: int, k: int, change: int = 2, kind: Optional[Kind] = None, strength: int = 2, *,
    time: Optional[float] = 600.0, each: float = 60.0, seed: int = 1, target: Optional[int] = None,
    start: Optional[Design] = None, exact: bool = False, cubes: Optional[int] = None,
    threads: Optional[int] = None, workers: Optional[int] = None, progress: Progress = None,
) -> SearchResult:
    """changeover.search() on the workers of a cluster; kind is 'linear' unless said.

    Without exact, each part is a seed and improves the best design so far for `each` seconds.
    exact=True goes up from the lower bound: the question whether there is a design with b blocks is
    split into `cubes` cubes (None: 64), always the same ones, and workers take shares of them. A
    share that takes longer than `each` seconds is ended and divided into four, which may take twice
    as long, and so on; a lost worker loses at most one share.

    A number of blocks is excluded when every cube is excluded by a proof that was checked on its
    worker; a check here shows that the cubes cover all cases. Designs are verified here. Ctrl-C
    ends the search and keeps the best design.
    """
    _limits(1e9 if time is None else time, each)
    if cubes is not None and not 2 <= cubes <= _most_cubes:
        raise BadInput(f"cubes is a number from 2 to {_most_cubes}")
    cell: Cell = (v, k, change, linear_unless_said(kind), strength)
    end = _now() + (1e9 if time is None else time)
    if exact:
        if target is not None:
            raise BadInput("target has no meaning with exact=True, which ends at the minimum; leave "
                           "it out")
        walk = Walk(cell, each, end, cubes, start)
        answer = run_bag(client, _decide_part, walk.begin, walk.finish, tell_of(progress), threads,
                         walk.progress, workers)
    else:
        state: List[_Cells] = []

        def begin() -> Bag:
            state.append(_Cells([cell], each, seed, end, target, start))
            return Bag(state[0].take, state[0].next, state[0].over)

        def finish(_: Bag) -> Dict[str, Any]:
            run = state[0]
            best = run.best.get(cell)
            settled = best is not None and best.b == run.bound[cell]
            return {"design": best, "lower_bound": run.bound.get(cell, 1),
                    "reason": "", "minimum": settled, "how": run.how.get(cell, ""),
                    "moves": run.moves,
                    "why_stopped": "found" if best and run.is_settled(cell) else "time limit"}

        answer = run_bag(client, _improve_part, begin, finish, tell_of(progress), threads,
                         lambda _: {"moves": state[0].moves}, workers)
    found = answer["design"]
    if answer["interrupted"]:
        answer["why_stopped"] = "interrupted"
    return made(SearchResult, {**answer, "b": found and found.b})


def classify(
    client: Any, v: int, k: int, b: int, change: int = 2, kind: Optional[Kind] = None, *,
    reversal: bool = False, keep: int = 100, time: Optional[float] = None, each: float = 60.0,
    threads: Optional[int] = None, workers: Optional[int] = None, progress: Progress = None,
) -> Classification:
    """changeover.classify() on the workers of a cluster, which take shares of the search tree.
    kind is 'linear' unless said. A share that takes longer than `each` seconds is ended and divided
    into four, which may take twice as long, and so on; a lost worker loses at most one share.

    The counts of shares add up, as each class is found in exactly one. The kept designs are
    verified here and checked to be different: up to `keep` of them, the smallest of those received.
    """
    _limits(1e9 if time is None else time, each)
    cell: Cell = (v, k, change, linear_unless_said(kind), 2)
    tree = Tree(cell, b, reversal, keep, each, _now() + (1e9 if time is None else time))
    answer = run_bag(client, _classify_part, tree.begin, tree.finish, tell_of(progress), threads,
                     tree.progress, workers)
    return made(Classification, answer)


check_calls(globals())
