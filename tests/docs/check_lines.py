#!/usr/bin/env python3
"""Finds lines of more than 100 columns in prose, Python and CMake.

usage: check_lines.py ROOT   prints FILE:LINE: its columns; exit code 1 if there are any

In Markdown only prose counts: tables, headings, code, displayed formulas, pictures and comments may
be longer. In Python a line that is one string is data and may be longer. Generated pages are left
out, and so are the folders of LEFT_OUT, whose lines were written before this check.
"""

import pathlib
import re
import sys

COLUMNS = 100
READ = (
    "README.md", "CHANGELOG.md", "HACKING.md", "CONTRIBUTING.md", "SECURITY.md", "CMakeLists.txt",
    "pyproject.toml", "CITATION.cff", "dev", ".ci", "docs", "examples", "python", "src", "apps",
    "tests/docs",
)
SUFFIXES = {".md", ".py", ".pyi", ".cmake", ".sh", ".toml", ".cff"}
# Programs without a suffix, and lists of CMake.
NAMES = {"dev", "artifacts", "bare_machine", "nightly", "release", "run", "CMakeLists.txt"}
GENERATED = {
    "docs/constructions.md", "docs/doors.md", "docs/errors.md", "docs/minima.md", "docs/paper.md"
}
LEFT_OUT = ("python/changeover/",)


def files(root):
    for name in READ:
        top = root / name
        for path in [top] if top.is_file() else sorted(top.rglob("*")):
            place = path.relative_to(root).as_posix()
            if (path.is_file() and (path.suffix in SUFFIXES or path.name in NAMES)
                    and "__pycache__" not in path.parts and place not in GENERATED
                    and not place.startswith(LEFT_OUT)):
                yield path


def prose(lines):
    """The lines of a page that are prose, with their numbers."""
    fenced = formula = in_text = False
    for number, line in enumerate(lines, 1):
        words = line.strip()
        if words.startswith("```"):
            fenced, in_text = not fenced, False
        elif words.startswith("$$") or formula:
            begins = not formula and not (words.endswith("$$") and len(words) > 2)
            formula = begins or (formula and not words.endswith("$$"))
        elif not fenced:
            code = line.startswith("    ") and not in_text
            other = code or words.startswith(("|", "#", "<!--", "!["))
            in_text = bool(words) and not other
            if in_text:
                yield number, line


def checked(path):
    lines = path.read_text(encoding="utf-8").split("\n")
    if path.suffix == ".md":
        return prose(lines)
    if path.suffix in {".py", ".pyi"}:
        data = re.compile(r"\s*[rfb]*(\"(?!\"\")|')")
        return ((n, line) for n, line in enumerate(lines, 1) if not data.match(line))
    return enumerate(lines, 1)


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[0])
    read = found = 0
    for path in files(root):
        read += 1
        for number, line in checked(path):
            if len(line) > COLUMNS:
                found += 1
                print(f"{path.relative_to(root).as_posix()}:{number}: {len(line)} columns; "
                      f"break the line at {COLUMNS}")
    if read == 0:
        print(f"{root}: nothing to read here: {', '.join(READ)}")
    return 1 if found or read == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
