#!/usr/bin/python3
"""What Doxygen reads in the place of a header: its plain comments as comments for Doxygen.

The comment that opens a header becomes the text of that file; in a C header (/* … */) each comment
that stands before a declaration becomes that of the declaration. In all of them an example, which
is indented by five blanks, becomes a piece of code, and a line indented by two to four begins an
item. See HACKING.md: headers read as manuals.
"""

import pathlib
import re
import sys


def escaped(text: str) -> str:
    """Words that Doxygen must not obey; what stands in `…` and the commands of a comment stay."""
    parts = re.split(r"(`[^`]*`)", text)
    for i in range(0, len(parts), 2):
        part = re.sub(r"\\(?=\w)", r"\\\\", parts[i])
        part = re.sub(r"@(?!(throws|param|return|file)\b)", r"\\@", part)
        part = re.sub(r"<(?=[A-Za-z/!])", r"\\<", part)
        part = re.sub(r"#(?=\w)", r"\\#", part)
        parts[i] = re.sub(r"&(?=\w+;)", r"\\&", part)
    return "".join(parts)


def translated(lines: list, language: str) -> list:
    """The lines of one comment, without their marks, in Doxygen's words."""
    out, state = [], ""
    for line in lines:
        deep = len(line) - len(line.lstrip(" "))
        if line.strip() and deep >= 5 and state != "list":
            if state != "code":
                out += ["", f"@code{{{language}}}"]
                state = "code"
            out.append("\0" + line[5:])  # The mark keeps its own indentation.
            continue
        if state == "code":
            if not line.strip():
                out.append("")
                continue
            while out and not out[-1]:
                out.pop()
            out += ["@endcode", ""]
            state = ""
        if not line.strip():
            state = ""
        elif 2 <= deep <= 4:
            text = line.strip()
            if state != "list" or (
                deep <= 3 and not text.startswith(("- ", "* ")) and deep == item
            ):
                if not re.match(r"[-*] |\d+\. ", text):
                    text = "- " + re.sub(r"  +", ": ", text, count=1)
                if state != "list":
                    out.append("")
                    item = deep
                line = " " * deep + text
            state = "list"
        elif deep < 2:
            if state == "list":
                out.append("")
            state = ""
        out.append(escaped(line))
    if state == "code":
        while out and not out[-1]:
            out.pop()
        out.append("@endcode")
    return out


def without_margin(lines: list) -> list:
    """Without the blank that follows the mark of a comment."""
    return [line[1:] if line.startswith((" ", "\0")) else line for line in lines]


def as_comment(lines: list, indent: str = "") -> list:
    return [f"{indent}/// {line}".rstrip() for line in lines]


def of_cpp(lines: list) -> list:
    out, i = [], 0
    while i < len(lines):
        opening = re.match(r"(\s*)//(/?)(?!/)(?!<)", lines[i])
        # A comment that stands alone, with a gap after it, is of the file as the one at its head
        # is.
        end = i
        while end < len(lines) and lines[end].startswith("//") and not lines[end].startswith("///"):
            end += 1
        is_head = (i == 0 and end > 0) or (
            end > i + 1 and end < len(lines) and not lines[end] and not lines[i - 1]
        )
        if not opening or not (is_head or opening.group(2)):
            code, mark, words = lines[i].partition(
                "///<"
            )  # What stands behind a member is the member's.
            out.append(code + mark + escaped(words))
            i += 1
            continue
        indent, mark = opening.group(1), "//" + opening.group(2)
        comment = []
        while i < len(lines) and re.match(re.escape(indent + mark) + r"(?![/<])", lines[i]):
            text = lines[i][len(indent) + len(mark):]
            comment.append(text)
            i += 1
        body = without_margin(translated(comment, ".cpp"))
        # Only the first sentence of the first comment is the file's summary.
        out += as_comment(
            (["@file", "" if len(out) == 0 else "@details"] if is_head else []) + body, indent
        )
        if is_head:
            out.append("")
    return out


def of_c(text: str) -> list:
    """Comments /* … */ on their own lines belong to what follows, behind a member to the member."""
    out, lines, i, is_head = [], text.split("\n"), 0, True
    while i < len(lines):
        if not lines[i].startswith("/*"):
            out.append(re.sub(r"/\* (.*?) \*/$", r"/**< \1 */", lines[i]))
            i += 1
            continue
        comment = []
        while True:
            line = re.sub(r"^ ?(/\*|\*(?!/))", "", lines[i])
            done = "*/" in line
            comment.append(line.replace("*/", "").rstrip())
            i += 1
            if done:
                break
        body = without_margin(translated(comment, ".c"))
        out += as_comment((["@file", ""] if is_head else []) + body)
        if is_head:
            out.append("")
        is_head = False
    return out


def main() -> None:
    path = pathlib.Path(sys.argv[1])
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".hpp":
        text = "\n".join(of_cpp(text.split("\n")))
    elif path.suffix == ".h":
        text = "\n".join(of_c(text))
    sys.stdout.write(text)


if __name__ == "__main__":
    main()
