#!/usr/bin/python3
"""Runs what a page shows, and compares what comes of it with what the page says.

usage: run_pages.py ROOT BUILD [--slow] [--write] PAGE...

A page is one session in its own folder, from top to bottom. A command is a line of an indented
block that begins with "$ "; what it prints, on either stream, is what stands below it in that
block, up to the next command.

    $ changeover design 6 4 --format text | head -n 1
    # changeover design v=6 k=4 change=2 kind=circular

Output is compared line by line, but

    a line "…"            stands for any lines, and for none
    "…" within a line     for anything
    times, dates, rates   "0.11 s", "2026-11-21", "3.5 MB/s" and versions of the program stand for
                          any of their kind
    progress              lines that say how far it is, which come after some seconds, do not count
    nothing               if nothing is shown, what is printed is not looked at; then the command
                          must have succeeded (exit code 0, or 10, 20 or 30 of a search)

"$ cat FILE" of a file that is not there yet makes it: it is shown to be put there. Comments in
HTML, which no reader sees, say the rest, for the block that comes next:

    <!-- not run: why -->     it is not run
    <!-- slow -->             it is run with --slow only
    <!-- quick: OPTIONS -->   without --slow, commands of changeover get these options, too:
                              fewer moves of a search whose figures are not shown
    <!-- first: COMMAND -->   COMMAND is run before, at its place in the session
    <!-- needs: PROGRAM -->   it is run where there is such a program; module:NAME, where
                              Python has it
    <!-- is in: FILE -->      the fenced code that comes next is a part of FILE, line for line

Fenced code in C++ (```cpp) must compile. With --write what was printed is put where a difference
was found.
"""

import argparse
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ANY_KIND = [
    (re.compile(r"\b\d[\d.,]*\s?[kMG]?i?B/s"), "RATE"),
    (re.compile(r"\b\d[\d.,:]*\s(µs|ms|s|min|h)\b(?!/)"), "TIME"),
    (re.compile(r"\b\d{4}-\d\d-\d\d\b"), "DATE"),
    (re.compile(r"\bchangeover \d+\.\d+\.\d+\b"), "VERSION"),
]
SUCCESS = {0, 10, 20, 30}
PROGRESS = re.compile(r"changeover: .*; [\d:]+ (s|min|h|d)(, [\d:]+ (s|min|h|d) left)?")


class Command:
    def __init__(self, line, text):
        self.line, self.text, self.shown, self.first, self.slow, self.skip, self.quick = (
            line,
            text,
            [],
            [],
            False,
            False,
            "",
        )


class Code:
    def __init__(self, line, language, text, part_of):
        self.line, self.language, self.text, self.part_of = line, language, text, part_of


def parse(text):
    """The commands and fenced code of a page, in order; ValueError if a mark leads to nothing."""
    found, marks, i = [], [], 0
    lines = text.split("\n")
    while i < len(lines):
        mark = re.match(r"<!-- (not run|slow|quick|first|needs|is in)(?:: (.*))? -->$", lines[i])
        fence = re.match(r"```(\w*)", lines[i])
        if mark:
            marks.append((i, mark.group(1), mark.group(2)))
        elif fence:
            begin = i + 1
            i = begin
            while lines[i] != "```":
                i += 1
            part_of = next((words for _, what, words in marks if what == "is in"), None)
            found.append(Code(begin, fence.group(1), lines[begin:i], part_of))
            marks = [mark for mark in marks if mark[1] != "is in"]
        elif lines[i].startswith("    $ ") and (i == 0 or not lines[i - 1].strip() or marks):
            before = next((line for line in reversed(lines[:i]) if line.strip()), "")
            if re.match(r"\s*([-*+]|\d+[.)]) |  ", before):
                raise ValueError(
                    f"line {i + 1}: this is read as a part of the list before it; "
                    "put a sentence between them"
                )
            kinds = {what for _, what, _ in marks}
            first = [words for _, what, words in marks if what == "first"]
            needs = [words for _, what, words in marks if what == "needs"]
            quick = "".join(f" {words}" for _, what, words in marks if what == "quick")
            marks = []
            while i < len(lines) and (lines[i].startswith("    ") or not lines[i].strip()):
                if lines[i].startswith("    $ "):
                    found.append(Command(i, lines[i][6:]))
                    found[-1].slow, found[-1].skip = "slow" in kinds, "not run" in kinds or not all(
                        map(is_there, needs)
                    )
                    found[-1].first, first = first, []
                    found[-1].quick = quick if found[-1].text.startswith("changeover ") else ""
                else:
                    found[-1].shown.append(lines[i][4:])
                i += 1
            for command in found:
                while (
                    isinstance(command, Command) and command.shown and not command.shown[-1].strip()
                ):
                    command.shown.pop()
            continue
        elif (
            lines[i].startswith("    ") and marks and all(what == "not run" for _, what, _ in marks)
        ):
            marks = []
        i += 1
    if marks:
        raise ValueError(f"line {marks[0][0] + 1}: nothing comes after this mark")
    return found


def is_there(needed):
    kind, _, name = needed.rpartition(":")
    return (
        importlib.util.find_spec(name) if kind == "module" else shutil.which(needed)
    ) is not None


def usual(line):
    for pattern, word in ANY_KIND:
        line = pattern.sub(word, line)
    return line.rstrip()


def line_matches(shown, printed):
    shown, printed = usual(shown), usual(printed)
    if shown == printed:
        return True
    return (
        "…" in shown
        and re.fullmatch(".*".join(map(re.escape, shown.split("…"))), printed) is not None
    )


def matches(shown, printed):
    """Do the lines that are shown stand for those that were printed?"""
    reachable = {0}  # How many printed lines the shown ones so far can stand for.
    for line in shown:
        if line.strip() == "…":
            reachable = set(range(min(reachable), len(printed) + 1)) if reachable else set()
        else:
            reachable = {
                n + 1 for n in reachable if n < len(printed) and line_matches(line, printed[n])
            }
    return len(printed) in reachable


class Session:
    def __init__(self, root, build, slow):
        self.root, self.build, self.slow = root, build, slow
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="changeover_page_"))
        shutil.copytree(
            root / "examples",
            self.folder / "examples",
            ignore=shutil.ignore_patterns("*.cpp", "*.hpp"),
        )
        # python3 is the one that the package was built for; Open MPI would refuse root and few
        # processors.
        own = self.folder / ".bin"
        own.mkdir()
        (own / "python3").symlink_to(sys.executable)
        path = f"{own}:{build}:{build / 'examples'}:{os.environ['PATH']}"
        self.environment = {
            **os.environ,
            "PATH": path,
            "COLUMNS": "100",
            "LC_ALL": "C.UTF-8",
            "CHANGEOVER_CATALOG": str(self.folder / ".catalog.db"),
            "PYTHONPATH": str(build / "python"),
            "OMPI_ALLOW_RUN_AS_ROOT": "1",
            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
            "OMPI_MCA_rmaps_base_oversubscribe": "1",
            "OMPI_MCA_btl_vader_single_copy_mechanism": "none",
        }

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)

    def run(self, text):
        done = subprocess.run(
            ["bash", "-c", text],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            timeout=1800 if self.slow else 240,
        )
        return done.returncode, done.stdout.decode("utf-8", "replace").rstrip("\n")

    def command(self, command):
        """What is wrong with it, or nothing; and what was printed."""
        for text in command.first:
            code, printed = self.run(text)
            if code:
                return f"{text!r} before it ended with code {code}: {printed}", None
        shown_file = re.fullmatch(r"cat ([\w.]+)", command.text)
        if shown_file and not (self.folder / shown_file.group(1)).exists():
            (self.folder / shown_file.group(1)).write_text(
                "\n".join(command.shown) + "\n", encoding="utf-8"
            )
            return None, None
        try:
            code, printed = self.run(command.text + ("" if self.slow else command.quick))
        except subprocess.TimeoutExpired:
            return "has not ended in time", None
        lines = (
            [line for line in printed.split("\n") if not PROGRESS.fullmatch(line)]
            if printed
            else []
        )
        if not command.shown:
            return (None if code in SUCCESS else f"ended with code {code}: {printed}"), None
        return (None if matches(command.shown, lines) else "printed something else"), lines

    def code(self, code):
        if code.part_of is not None:
            file = self.root / code.part_of
            return (
                None
                if file.is_file() and "\n".join(code.text) in file.read_text(encoding="utf-8")
                else f"is no part of {code.part_of}"
            )
        if code.language != "cpp":
            return None
        source = self.folder / "page.cpp"
        source.write_text("\n".join(code.text) + "\n", encoding="utf-8")
        done = subprocess.run(
            [
                os.environ.get("CXX", "c++"),
                "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror",
                f"-I{self.root / 'include'}", f"-I{self.build / 'generated' / 'include'}", source,
            ],
            capture_output=True,
            text=True,
        )
        return f"does not compile: {done.stderr}" if done.returncode else None


def difference(shown, printed):
    return "".join(
        [
            "  the page:\n",
            *(f"    {line}\n" for line in shown),
            "  printed:\n",
            *(f"    {line}\n" for line in printed),
        ]
    )


def run_page(page, session, write):
    """The number of things that were run, and of those that were wrong."""
    text = page.read_text(encoding="utf-8")
    ran = wrong = 0
    renewed = []
    for thing in parse(text):
        if isinstance(thing, Code):
            fault, printed = session.code(thing), None
            ran += thing.part_of is not None or thing.language == "cpp"
        elif thing.skip or (thing.slow and not session.slow):
            continue
        else:
            fault, printed = session.command(thing)
            ran += 1
        if fault is None:
            continue
        wrong += 1
        what = thing.text if isinstance(thing, Command) else f"{thing.language} code"
        print(f"{page}:{thing.line + 1}: {what}: {fault}")
        if printed is not None:
            print(difference(thing.shown, printed), end="")
            renewed.append((thing, printed))
    if write and renewed:
        lines = text.split("\n")
        for command, printed in reversed(renewed):
            begin = command.line + 1
            lines[begin:begin + len(command.shown)] = [f"    {line}".rstrip() for line in printed]
        page.write_text("\n".join(lines), encoding="utf-8")
    return ran, wrong


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("root", type=pathlib.Path)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--slow", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("pages", nargs="+", type=pathlib.Path)
    arguments = parser.parse_args()
    all_wrong = 0
    for page in arguments.pages:
        session = Session(arguments.root.resolve(), arguments.build.resolve(), arguments.slow)
        try:
            ran, wrong = run_page(page, session, arguments.write)
        except ValueError as fault:
            sys.exit(f"{page}: {fault}")
        finally:
            session.close()
        print(f"{page}: {ran} examples, {wrong} wrong")
        all_wrong += wrong
    sys.exit(1 if all_wrong else 0)


if __name__ == "__main__":
    main()
