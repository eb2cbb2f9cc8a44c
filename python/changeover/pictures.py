"""Pictures as SVG and TikZ; notebooks show them."""

from __future__ import annotations

import os
from typing import Any, List, Literal, Optional, Tuple

from . import _core
from ._given import Path, in_bytes
from ._made import Made, check_calls, fact, made
from .errors import BadInput

PictureKind = Literal["array", "stays", "coverage", "circle", "recipe"]
Theme = Literal["light", "dark"]


class Picture(Made):
    """A picture; what draw() of designs, tables, run sheets and load orders returns."""

    _hidden = ("tikz", "defect")
    svg: str = fact("A whole SVG file.")
    title: str = fact("What the picture shows.")

    @property
    def tikz(self) -> str:
        """A tikzpicture, for the LaTeX package tikz. Raises BadInput if it is too large for TeX."""
        if self._facts["defect"]:
            raise BadInput(_in_python(self._facts["defect"]))
        text: str = self._facts["tikz"]
        return text

    def save(self, path: Path) -> None:
        """Writes a file, whole or not at all: .svg, .tikz or .tex. Raises BadInput for another
        ending, MissingResource if it cannot be written."""
        ending = os.path.splitext(os.fsdecode(path))[1].lower()
        if ending not in (".svg", ".tikz", ".tex"):
            raise BadInput(f"{path}: unknown file extension; use .svg, .tikz or .tex")
        _core.write_file(in_bytes(path), self.svg if ending == ".svg" else self.tikz)

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"<Picture: {self.title}>"


def _in_python(message: str) -> str:
    """With the names of arguments instead of options of the command line."""
    return message.replace("--from", "first").replace("--to", "last")


def stays_of(panels: List[Tuple[str, str, List[str], List[List[int]]]], row: str, step: str,
             theme: str) -> Picture:
    """Below each other: headline, note, names of the rows, and which rows are there, by step."""
    return drawn(_core.draw_stays(panels, row, step, theme))


def picture_of(core: Any, picture: str, theme: str, order: str, colour: str, leaving: bool,
               first: int, last: Optional[int]) -> Picture:
    try:
        svg, tikz, defect, title = core.draw(
            picture, theme, order, colour, leaving, first, last)
    except BadInput as fault:
        raise BadInput(_in_python(str(fault)))
    return drawn((svg, tikz, defect, title))


def drawn(written: Tuple[str, str, str, str]) -> Picture:
    svg, tikz, defect, title = written
    return made(Picture, {"svg": svg, "tikz": tikz, "defect": defect, "title": title})


check_calls(globals())
