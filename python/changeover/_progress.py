"""progress=True: a bar of tqdm where that is installed, or else a line on standard error."""

from __future__ import annotations

import importlib
import sys
from typing import Any, Dict


class Bar:
    """Called with what a search says of itself, and closed when the call ends."""

    def __init__(self) -> None:
        try:
            bars: Any = importlib.import_module("tqdm.auto")
            self._bar: Any = bars.tqdm(unit=" steps", unit_scale=True, leave=False)
        except ImportError:
            self._bar = None
        self._width = 0

    def __call__(self, said: Dict[str, Any]) -> None:
        words = [str(said["phase"])] if said.get("phase") else []
        if said.get("best") is not None:
            words.append(f"best {said['best']}")
        if self._bar is not None:
            self._bar.n = int(said.get("steps") or 0)
            self._bar.set_description(", ".join(words), refresh=True)
            return
        words.append(f"{float(said.get('elapsed') or 0):.0f} s")
        line = ", ".join(words)
        sys.stderr.write("\r" + line.ljust(self._width))
        sys.stderr.flush()
        self._width = len(line)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
        elif self._width:
            sys.stderr.write("\r" + " " * self._width + "\r")
            sys.stderr.flush()
