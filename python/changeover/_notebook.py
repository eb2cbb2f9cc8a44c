"""What notebooks show of objects: a line or two, and a table. As HTML on a page; as LaTeX where a
notebook is printed, which takes no HTML."""

from __future__ import annotations

import itertools
from decimal import Decimal
from html import escape
from typing import Any, Iterable, List, Optional, Sequence, Tuple

from . import _core

_shown_rows = 60
Rows = Iterable[Sequence[Any]]


class Shown:
    """What has a title, lines and a table."""

    __slots__ = ()

    def _on_page(self) -> Tuple[str, Iterable[str], Sequence[str], Rows, Optional[int]]:
        """Title, lines, heads, rows, and how many there are."""
        raise NotImplementedError

    def _repr_html_(self) -> str:
        title, lines, heads, rows, count = self._on_page()
        return shown(title, lines, table(heads, rows, count))

    def _repr_latex_(self) -> str:
        return latex(*self._on_page())


def shown(title: str, lines: Iterable[str] = (), *more: str) -> str:
    """A part of a page. What is in `more` is HTML already."""
    said = "".join(f"<div>{escape(line)}</div>\n" for line in lines)
    return f"<div>\n<strong>{escape(title)}</strong>\n{said}{''.join(more)}</div>"


def latex(title: str, lines: Iterable[str], heads: Sequence[str], rows: Rows,
          count: Optional[int]) -> str:
    """The same for LaTeX with the packages booktabs and longtable."""
    some = list(itertools.islice(rows, _shown_rows + 1))
    said = [f"\\noindent\\textbf{{{_core.latex_prose(title)}}}\\par"]
    said += [f"\\noindent {_core.latex_prose(line)}\\par" for line in lines]
    numbers = [all(row[i] is None or isinstance(row[i], (int, float, Decimal)) for row in some)
               for i in range(len(heads))]
    if some:
        said.append("\\medskip\\noindent\n" + _core.latex_table(
            list(zip(heads, numbers)), [list(map(_words, row)) for row in some[:_shown_rows]]))
    if len(some) > _shown_rows:
        said.append(f"\\noindent {_shown_rows} of {count} rows\\par" if count else "\\dots")
    return "\n".join(said) + "\n"


def _words(value: Any) -> List[str]:
    if value is None:
        return []
    return list(map(str, value)) if isinstance(value, (list, tuple)) else [str(value)]


def table(heads: Sequence[str], rows: Iterable[Sequence[Any]], count: Optional[int] = None) -> str:
    """Numbers to the right. Of more than 60 rows the first ones, and how many there are."""
    body: List[str] = []
    number = 0
    for number, row in enumerate(rows, 1):
        if number > _shown_rows:
            break
        body.append("<tr>" + "".join(map(_cell, row)) + "</tr>\n")
    left = ""
    if number > _shown_rows:
        left = f"<div>{_shown_rows} of {count} rows</div>\n" if count else "<div>…</div>\n"
    head = "".join(f"<th>{escape(each)}</th>" for each in heads)
    return f"<table>\n<thead><tr>{head}</tr></thead>\n<tbody>\n{''.join(body)}</tbody>\n</table>\n{left}"


def _cell(value: Any) -> str:
    if value is None:
        return "<td></td>"
    if isinstance(value, (list, tuple)):
        return f"<td>{escape(', '.join(map(str, value)))}</td>"
    text = escape(str(value))
    return (
        f"<td>{text}</td>"
        if isinstance(value, str)
        else f'<td style="text-align:right">{text}</td>'
    )
