"""Questions that are divided until no part takes too long: cubes of a formula, subtrees of an
enumeration."""

from __future__ import annotations

import time
from typing import Any, Dict, List, Optional, Tuple

from .. import _core
from .._made import Kind
from ..designs import Design, design
from ..errors import InternalError
from ..known import bounds
from ._bag import Bag

Cell = Tuple[int, int, int, Kind, int]  # v, k, change, kind, strength
Share = Tuple[int, int]
_pieces = 4  # into which a share is divided that took too long
_first_shares = 64  # enough for many workers to begin; there are more as shares take long


def received(found: Design, cell: Cell, b: int) -> Design:
    """A design from a worker, read and verified on arrival. Raises InternalError if it is invalid.
    """
    if not found.verdict.valid or found.b != b or cell != (
            found.v, found.k, found.change, found.kind, found.strength):
        raise InternalError(f"a worker sent what is not a {cell[3]} design with v = {cell[0]}, k = "
                            f"{cell[1]} and {b} blocks")
    return found


def divided(share: Share) -> List[Share]:
    part, parts = share
    return [(part + each * parts, _pieces * parts) for each in range(_pieces)]


def seconds_for(share: Share, each: float) -> float:
    """The time limit doubles with each division, since the work that all shares do first may take
    longer than `each`."""
    times = 1.0
    parts = _first_shares
    while parts < share[1]:
        parts, times = _pieces * parts, 2 * times
    return each * times


class Walk:
    """Goes up from the lower bound, one number of blocks after another, to the minimum."""

    def __init__(self, cell: Cell, each: float, end: float, cubes: Optional[int],
                 start: Optional[Design]) -> None:
        self._cell, self._each, self._end = cell, each, end
        self._cubes = cubes or 64
        self._best = start
        self._bag: Optional[Bag] = None
        self._excluded: List[Any] = []
        self._left: set[Share] = set()
        self._proofs = self._proof_bytes = 0
        self._reason = ""
        self._over = False
        self._lower = 1
        self._impossible = False

    def begin(self) -> Bag:
        v, k, change, kind, strength = self._cell
        known = bounds(v, k, change, kind, strength)
        self._bag = Bag(self._take, is_over=self._is_over)
        if known.lower_bound is None:
            self._impossible = self._over = True
            self._reason = known.reason
            return self._bag
        # What other searches have excluded is excluded again.
        paper = [each for each in known.all if each.name != "checked proofs"]
        self._lower, self._reason = max(((each.blocks, each.reason) for each in paper),
                                        key=lambda each: each[0], default=(1, "trivial"))
        best = design(v, k, change, kind, strength)
        if best is not None and (self._best is None or best.b < self._best.b):
            self._best = best
        self._ask()
        return self._bag

    def _is_over(self) -> bool:
        return self._over or time.monotonic() >= self._end

    def _ask(self) -> None:
        if self._best is not None and self._best.b <= self._lower:
            self._over = True
            return
        self._excluded = []
        shares = min(_first_shares, self._cubes)
        self._left = {(part, shares) for part in range(shares)}
        for share in sorted(self._left):
            self._put(share)

    def _put(self, share: Share) -> None:
        assert self._bag is not None
        alone = share[1] >= self._cubes
        self._bag.put({"cell": self._cell, "b": self._lower, "cubes": self._cubes, "share": share,
                       "seconds": None if alone else seconds_for(share, self._each)})

    def _take(self, arguments: Dict[str, Any], result: Dict[str, Any]) -> None:
        if arguments["b"] != self._lower or arguments["share"] not in self._left:
            return
        share = arguments["share"]
        if result["outcome"] == "found":
            self._best = received(result["design"], self._cell, self._lower)
            self._over = True
            return
        self._left.discard(share)
        if result["outcome"] == "none":
            self._excluded += result["excluded"]
            self._proofs += len(result["excluded"])
            self._proof_bytes += result["proof_bytes"]
        else:
            for part in divided(share):
                self._left.add(part)
                self._put(part)
        if not self._left:
            if not _core.cubes_cover_everything(self._excluded):
                raise InternalError(f"the cubes that were excluded for {self._lower} blocks leave "
                                    "something out")
            self._lower += 1
            self._reason = (f"fewer blocks were excluded, by {self._proofs} checked proofs of "
                            f"{self._proof_bytes} bytes together")
            self._ask()

    def progress(self, _bag: Bag) -> Dict[str, Any]:
        return {"lower_bound": self._lower, "best": self._best and self._best.b,
                "missing": len(self._left)}

    def finish(self, _bag: Bag) -> Dict[str, Any]:
        settled = self._impossible or self._best is not None and self._best.b == self._lower
        return {"design": None if self._impossible else self._best,
                "lower_bound": self._lower, "reason": self._reason, "minimum": settled,
                "how": "exact search", "moves": 0,
                "why_stopped": "exhausted" if settled else "time limit"}


class Tree:
    """A classification."""

    def __init__(self, cell: Cell, b: int, reversal: bool, keep: int, each: float,
                 end: float) -> None:
        self._cell, self._b, self._reversal, self._keep = cell, b, reversal, keep
        self._each, self._end = each, end
        self._bag: Optional[Bag] = None
        self._prefixes: Optional[int] = None
        self._left: set[Share] = set()
        self._counts = {"standard_forms": 0, "classes": 0, "tight": 0}
        self._orders: Dict[int, int] = {}
        self._designs: List[Design] = []

    def begin(self) -> Bag:
        self._bag = Bag(self._take, is_over=lambda: time.monotonic() >= self._end)
        self._left = {(part, _first_shares) for part in range(_first_shares)}
        for share in sorted(self._left):
            self._put(share)
        return self._bag

    def _put(self, share: Share) -> None:
        assert self._bag is not None
        alone = self._prefixes is not None and share[1] >= self._prefixes
        v, k, change, kind, _ = self._cell
        self._bag.put({"cell": self._cell, "b": self._b, "reversal": self._reversal,
                       "keep": self._keep, "share": share,
                       "seconds": None if alone else seconds_for(share, self._each)})

    def _take(self, arguments: Dict[str, Any], result: Dict[str, Any]) -> None:
        share = arguments["share"]
        if share not in self._left:
            return
        self._left.discard(share)
        if not result["complete"]:
            self._prefixes = max(self._prefixes or 0, result["prefixes"]) or None
            for part in divided(share):
                self._left.add(part)
                self._put(part)
            return
        for key in self._counts:
            self._counts[key] += result[key]
        for order, count in result["group_orders"].items():
            self._orders[order] = self._orders.get(order, 0) + count
        self._designs += [received(each, self._cell, self._b) for each in result["designs"]]
        self._designs.sort(key=lambda each: each.blocks.tolist())
        del self._designs[self._keep:]

    def progress(self, _bag: Bag) -> Dict[str, Any]:
        return {"classes": self._counts["classes"], "missing": len(self._left)}

    def finish(self, _bag: Bag) -> Dict[str, Any]:
        complete = not self._left
        seen = {each.canonical(reversal=self._reversal).to_string() for each in self._designs}
        if len(seen) != len(self._designs):
            raise InternalError("two shares of a classification found the same class")
        return {**self._counts, "group_orders": self._orders, "designs": self._designs,
                "complete": complete, "prefixes": 0, "prefixes_done": 0}
