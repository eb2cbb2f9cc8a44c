"""progress=True: a bar of tqdm where that is installed, or else a line on standard error."""

from __future__ import annotations

import importlib
import sys
from typing import Any, Dict, Optional, Tuple


class Bar:
    """Called with what a search says of itself, and closed when the call ends. What cannot be shown
    is not, without standard error, say: a search does not lose its result to that."""

    def __init__(self) -> None:
        self._show: Any = None
        self._bar: Any = None
        self._width = 0

    def __call__(self, said: Dict[str, Any]) -> None:
        try:
            if self._show is None:
                self._show = self._begin(said)
            self._show(said)
        except Exception:  # A closed stream, a full disk, what tqdm raises.
            self._show = lambda _: None

    def _begin(self, said: Dict[str, Any]) -> Any:
        try:
            bars: Any = importlib.import_module("tqdm.auto")
            self._bar = bars.tqdm(unit=f" {_measure(said)[2]}", unit_scale=True, leave=False)
        except Exception:
            return self._show_line
        return self._show_bar

    def _show_bar(self, said: Dict[str, Any]) -> None:
        self._bar.n, self._bar.total, _ = _measure(said)
        self._bar.set_description_str(", ".join(_words(said)), refresh=True)

    def _show_line(self, said: Dict[str, Any]) -> None:
        words = _words(said)
        done, total, unit = _measure(said)
        if total is not None:
            words.append(f"{done} of {total} {unit}")
        if unit != "s":
            words.append(f"{float(said.get('elapsed') or 0):.0f} s")
        line = ", ".join(words)
        sys.stderr.write("\r" + line.ljust(self._width))
        sys.stderr.flush()
        self._width = len(line)

    def close(self) -> None:
        try:
            if self._bar is not None:
                self._bar.close()
            elif self._width:
                sys.stderr.write("\r" + " " * self._width + "\r")
                sys.stderr.flush()
        except Exception:
            pass


def _measure(said: Dict[str, Any]) -> Tuple[int, Optional[int], str]:
    """How far it is, of how much, if that is known, and the unit: steps, or the seconds that a
    search has."""
    if said.get("of") or said.get("left") is None:
        return int(said.get("steps") or 0), said.get("of") or None, said.get("unit") or "steps"
    elapsed = float(said.get("elapsed") or 0)
    return int(elapsed), round(elapsed + said["left"]), "s"


def _words(said: Dict[str, Any]) -> list[str]:
    words = [str(said["phase"])] if said.get("phase") else []
    if said.get("best") is not None:
        words.append(f"best {said['best']}")
    return words
