"""What notebooks show of objects: a line or two, and a table. As HTML on a page; as LaTeX where a
notebook is printed, which takes no HTML."""

from __future__ import annotations

import itertools
import re
from decimal import Decimal
from html import escape
from typing import Any, Iterable, List, Optional, Sequence, Tuple

from . import _core

Rows = Iterable[Sequence[Any]]


class Prose(str):
    """A sentence of the program with formulas, and without names of the caller."""

    __slots__ = ()


class Shown:
    """What has a title, lines and a table, of which the first rows are shown."""

    __slots__ = ()
    _most_rows = 60
    _row = "row"

    def _on_page(self) -> Tuple[str, Iterable[str], Sequence[str], Rows, Optional[int]]:
        """Title, lines, heads, rows, and how many there are."""
        raise NotImplementedError

    def _repr_html_(self) -> str:
        title, lines, heads, rows, count = self._on_page()
        return shown(title, lines, self._picture(),
                     table(heads, rows, count, self._most_rows, self._row))

    def _repr_latex_(self) -> str:
        return latex(*self._on_page(), self._most_rows, self._row)

    def _picture(self) -> str:
        """SVG between lines and table."""
        return ""


def shown(title: str, lines: Iterable[str] = (), *more: str) -> str:
    """A part of a page. What is in `more` is HTML already."""
    said = "".join(f"<div>{_html(line)}</div>\n" for line in lines)
    return f"<div>\n<strong>{escape(title)}</strong>\n{said}{''.join(more)}</div>"


def latex(title: str, lines: Iterable[str], heads: Sequence[str], rows: Rows,
          count: Optional[int], most: int, row: str) -> str:
    """The same for LaTeX with the packages booktabs and longtable."""
    some = list(itertools.islice(rows, most + 1))
    said = [f"\\noindent\\textbf{{{_core.latex_escaped(title)}}}\\par"]
    said += [f"\\noindent {_core.latex_prose(line)}\\par" if isinstance(line, Prose) else
             f"\\noindent {_core.latex_escaped(line)}\\par" for line in lines]
    kinds = [_kind([each[i] for each in some]) for i in range(len(heads))]
    if some:
        said.append("\\medskip\\noindent\n" + _core.latex_table(
            list(zip(heads, kinds)), [list(map(_words, each)) for each in some[:most]]))
    if len(some) > most:
        said.append(f"\\noindent {most} of {count} {row}s\\par" if count else "\\dots")
    return "\n".join(said) + "\n"


def _kind(values: Sequence[Any]) -> str:
    """Of a column."""
    if all(each is None or isinstance(each, (int, float, Decimal)) for each in values):
        return "number"
    return "prose" if all(isinstance(each, Prose) for each in values) else "names"


def _html(line: str) -> str:
    text: str = _core.html_prose(line) if isinstance(line, Prose) else escape(line)
    return text


def _words(value: Any) -> List[str]:
    if value is None:
        return []
    return list(map(str, value)) if isinstance(value, (list, tuple)) else [str(value)]


def table(heads: Sequence[str], rows: Rows, count: Optional[int] = None, most: int = 60,
          row: str = "row") -> str:
    """Numbers to the right, texts to the left. Of more rows than `most` the first ones, and how
    many there are; nothing of no rows."""
    some = list(itertools.islice(rows, most + 1))
    if not some:
        return ""
    body = "".join("<tr>" + "".join(map(_cell, each)) + "</tr>\n" for each in some[:most])
    left = ""
    if len(some) > most:
        left = f"<div>{most} of {count} {row}s</div>\n" if count else "<div>…</div>\n"
    head = "".join(f"<th{_side(value)}>{escape(each)}</th>" for each, value in zip(heads, some[-1]))
    return (f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{body}</tbody>\n</table>\n"
            f"{left}")


def _side(value: Any) -> str:
    """Notebooks have all cells to the right, where only numbers belong, and "29=" of tables."""
    text = not re.fullmatch(r"\d+=?|[-?]", value) if isinstance(value, str) else (
        value is None or isinstance(value, (list, tuple)))
    return f' style="text-align:{"left" if text else "right"}"'


def _cell(value: Any) -> str:
    text = _html(value) if isinstance(value, Prose) else escape(", ".join(_words(value)))
    return f"<td{_side(value)}>{text}</td>"
