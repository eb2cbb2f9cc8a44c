from typing import Literal

from . import Design, Entry

_Kind = Literal["linear", "circular"]

def find(label: str) -> Entry | None: ...
def cell(v: int, k: int, change: int = 2, kind: _Kind = "linear", strength: int = 2) -> list[Entry]: ...
def entries(
    *,
    v_from: int | None = None,
    v_to: int | None = None,
    k_from: int | None = None,
    k_to: int | None = None,
    change: int | None = None,
    kind: _Kind | None = None,
    status: str = "",
    best_only: bool = True,
    users_only: bool = False,
) -> list[Entry]: ...
def add(design: Design, *, who: str, date: str, note: str = "") -> str: ...
