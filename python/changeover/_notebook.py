"""What notebooks show of objects: a line or two, and a table."""

from __future__ import annotations

from html import escape
from typing import Any, Iterable, List, Optional, Sequence

_shown_rows = 60


def shown(title: str, lines: Iterable[str] = (), *more: str) -> str:
    """A part of a page. What is in `more` is HTML already."""
    said = "".join(f"<div>{escape(line)}</div>\n" for line in lines)
    return f"<div>\n<strong>{escape(title)}</strong>\n{said}{''.join(more)}</div>"


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
