#!/usr/bin/env python3
"""The table of all messages of faults, tests/data/errors/*.txt: runs it, and makes docs/errors.md
of it.

usage: errors.py run ROOT BUILD [--write] [NAME...]   runs all rows, or those of the files that are
                                                      named (without .txt); with --write the table
                                                      gets what was said where it said otherwise
       errors.py page ROOT                            writes the page to standard output

A file of the table is one session in its own folder, from top to bottom; blank lines separate
what follows.

    # Heading of the page            the first lines of a file; what stands below it until a blank
                                     line is put there
    file NAME                        makes a file of the lines below, which are indented by four
                                     blanks
    setup COMMAND                    a line for bash that makes one which cannot stand here
    python STATEMENT                 a line of Python that rows of Python need
    needs PROGRAM                    the row that comes next is run where there is such a program
    $ COMMAND                        a row: a line for bash, below it
    3 parts.csv:1:1: MESSAGE         the exit code and the message, without "changeover: " before it
      WHAT IT MEANS                  below that, if the message alone does not say it, indented by
                                     two blanks, what the page says of it
    >>> EXPRESSION                   a row of Python, and a class of exceptions in place of the exit
                                     code
    GET /api/ADDRESS                 a row of `changeover serve`, and the status in place of the
                                     exit code
    POST /api/ADDRESS BODY           the same with a body, JSON; {"text":…} sent as text where BODY
                                     begins with "text "

"…" in a message stands for anything: numbers that vary, words of the system. To add a row, write
"?" in place of the exit code and the message, run the table with --write, and read what it says.
"""

import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import threading
import urllib.error
import urllib.request

TABLE = "tests/data/errors"
PROGRESS = re.compile(r"changeover: .*; [\d:]+ (s|min|h|d)(, [\d:]+ (s|min|h|d) left)?")
EXIT_CODES = {"2": "usage", "3": "bad input", "4": "missing resource", "5": "a bug of ours"}
ONE_FOLDER = threading.Lock()  # rows of Python run in this process, which has one current folder
INTRODUCTION = """\
# Errors

Every message with which Changeover refuses something: a reference, to look up a line that it printed. Each line begins with
the program's name, `changeover: `, which is left out here.

A message names the place (a file with line and column, or an option). Then it says what is wrong there, and behind a
semicolon how to mend it. It is the only line on standard error. Standard output stays empty, and files that were there
before stay as they were.

The exit code says whose fault it is: 2 the command line; 3 what a file holds; 4 no construction serves these parameters, or
a file, memory or disk space is missing; 5 a bug of ours. In Python the class of the exception says it, on the server the
status of the answer.

<!-- This page is made of tests/data/errors by `tests/errors/errors.py page .`, and each of its lines was run. -->
"""


class Row:
    """What is typed, what is answered with (exit code, class or status) and the message."""

    def __init__(self, path, line, typed):
        self.path, self.line, self.typed = path, line, typed
        self.place = f"{path.name}:{line + 1}"
        self.answer, self.message, self.meaning, self.needs = "", "", [], None

    def is_said(self, said):
        return (
            re.fullmatch(".*".join(map(re.escape, self.message.split("…"))), said, re.DOTALL)
            is not None
        )


class Section:
    def __init__(self, path):
        self.path, self.heading, self.text, self.steps = path, "", [], []

    def rows(self):
        return [step for step in self.steps if isinstance(step, Row)]


def parsed(path):
    """A file of the table. Raises ValueError, which says where it is not understood."""
    section = Section(path)
    lines = path.read_text(encoding="utf-8").split("\n")
    at, needs = 0, None

    def indented(blanks):
        nonlocal at
        found = []
        while at < len(lines) and (
            lines[at].startswith(blanks)
            or (
                not lines[at]
                and blanks == "    "
                and "".join(lines[at : at + 2]).startswith(blanks)
            )
        ):
            found.append(lines[at][len(blanks) :])
            at += 1
        return found

    while at < len(lines):
        line, place = lines[at], f"{path.name}:{at + 1}"
        at += 1
        word, _, rest = line.partition(" ")
        if not line:
            continue
        if word == "#" and not section.heading:
            section.heading = rest
            while at < len(lines) and lines[at]:
                section.text.append(lines[at])
                at += 1
        elif word == "file":
            section.steps.append(("file", rest, "\n".join(indented("    ")) + "\n"))
        elif word in ("setup", "python"):
            section.steps.append((word, rest, place))
        elif word == "needs":
            needs = rest
        elif word in ("$", ">>>", "GET", "POST"):
            row = Row(path, at - 1, line)
            row.needs, needs = needs, None
            row.answer, _, row.message = (lines[at] if at < len(lines) else "").partition(" ")
            if row.answer != "?" and (
                not re.fullmatch(r"[1-5]|[45]\d\d|[A-Z]\w+", row.answer) or not row.message
            ):
                raise ValueError(f"{place}: below a row stand its exit code and its message")
            at += 1
            row.meaning = indented("  ")
            section.steps.append(row)
        else:
            raise ValueError(f"{place}: {line!r} is not understood")
    if not section.heading:
        raise ValueError(f"{path.name}: the first line is a heading, # WORDS")
    return section


def table(root):
    return [
        parsed(path) for path in sorted((root / TABLE).glob("*.txt")) if path.stem != "elsewhere"
    ]


class Session:
    """A folder where rows are run, with the programs of a build."""

    def __init__(self, build):
        self.build, self.server, self.address = build, None, ""
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="changeover_errors_"))
        self.catalog = pathlib.Path(tempfile.mkdtemp(prefix="changeover_errors_"))
        self.environment = {
            **os.environ,
            "PATH": f"{build}:{build / 'examples'}:{os.environ['PATH']}",
            "LC_ALL": "C.UTF-8",
            "CHANGEOVER_CATALOG": str(self.catalog / "catalog.db"),
            "PYTHONPATH": str(build / "python"),
        }
        self.names = {}

    def close(self):
        if self.server:
            self.server.terminate()
            self.server.communicate(timeout=60)
        for folder in (self.folder, self.catalog):
            shutil.rmtree(folder, ignore_errors=True)

    def bash(self, command):
        # Most are plain words, for which bash takes as long as the program.
        plain = re.fullmatch(r"changeover( [\w.,:+/@-]+)+", command)
        done = subprocess.run(
            [self.build / "changeover", *command.split()[1:]] if plain else ["bash", "-c", command],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=240,
        )
        return (
            done.returncode,
            done.stdout.decode("utf-8", "replace"),
            done.stderr.decode("utf-8", "replace"),
        )

    def typed(self, command):
        code, out, err = self.bash(command)
        lines = [line for line in err.split("\n")[:-1] if not PROGRESS.fullmatch(line)]
        said = "\n".join(lines)
        return str(code), re.sub(r"^changeover: ", "", said), out if code in (2, 3, 5) else ""

    def python(self, expression):
        with ONE_FOLDER:
            os.chdir(self.folder)
            os.environ["CHANGEOVER_CATALOG"] = self.environment["CHANGEOVER_CATALOG"]
            sys.path[:1] = [str(self.build / "python")]
            try:
                if not self.names:
                    exec("import changeover", self.names)
                exec(expression, self.names)
            except Exception as fault:  # pylint: disable=broad-exception-caught
                return type(fault).__name__, str(fault), ""
            return "", "", ""

    def started(self):
        self.server = subprocess.Popen(
            [self.build / "changeover", "serve", "--port", "0"],
            cwd=self.folder,
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )
        printed = self.server.stdout.readline()
        found = re.search(r"(http://[^/\s]+/)\S*token=(\w+)", printed)
        self.address, self.token = found.group(1), found.group(2)

    def asked(self, line):
        if not self.server:
            self.started()
        method, address, *body = line.split(" ", 2)
        sent = body[0] if body else None
        kind = "text/plain" if sent and sent.startswith("text ") else "application/json"
        request = urllib.request.Request(
            self.address + address.lstrip("/"),
            method=method,
            data=sent.removeprefix("text ").encode() if sent is not None else None,
        )
        request.add_header("X-Changeover-Token", self.token)
        request.add_header("Content-Type", kind)
        try:
            with urllib.request.urlopen(request, timeout=60) as answer:
                return str(answer.status), "", answer.read().decode("utf-8", "replace")
        except urllib.error.HTTPError as refused:
            text = refused.read().decode()
            try:
                text = json.loads(text)["error"]["message"]
            except (ValueError, KeyError, TypeError):
                pass
            return str(refused.code), text.rstrip("\n"), ""

    def fault_of(self, step):
        """What is wrong with a step, or nothing; of a row also what was said."""
        if not isinstance(step, Row):
            what, name, rest = step
            if what == "file":
                path = self.folder / name
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_text(rest, encoding="utf-8")
                return None, None
            if what == "python":
                fault = self.python(name)
                return (f"{rest}: {': '.join(fault)}" if fault[0] else None), None
            code, _, err = self.bash(name)
            return (f"{rest}: the setup ended with {code}: {err}" if code else None), None
        if step.needs and not shutil.which(step.needs):
            return None, None
        word, _, rest = step.typed.partition(" ")
        answer, said, out = {"$": lambda: self.typed(rest), ">>>": lambda: self.python(rest)}.get(
            word, lambda: self.asked(step.typed))()
        if answer == step.answer and step.is_said(said) and not out:
            return None, None
        return (
            f"{step.place}: {step.typed}\n  the table: {step.answer} {step.message}\n  the run:   "
            f"{answer} {said}"
            + (f"\n  and on standard output: {out[:200]}" if out else ""),
            f"{answer} {said}",
        )


def write(row, said):
    lines = row.path.read_text(encoding="utf-8").split("\n")
    lines[row.line + 1] = said
    row.path.write_text("\n".join(lines), encoding="utf-8")


def run_section(section, build, writes):
    session, faults = Session(build), []
    try:
        for step in section.steps:
            fault, said = session.fault_of(step)
            if writes and said and said.partition(" ")[2] and "\n" not in said:
                write(step, said)
            faults += [fault] if fault else []
    finally:
        session.close()
    return faults


def run(root, build, names, writes):
    sections = [section for section in table(root) if not names or section.path.stem in names]
    with concurrent.futures.ThreadPoolExecutor(max_workers=2) as pool:
        faults = [
            fault
            for found in pool.map(lambda section: run_section(section, build, writes), sections)
            for fault in found
        ]
    rows = sum(len(section.rows()) for section in sections)
    for fault in faults:
        print(fault)
    print(f"{rows} messages, {len(faults)} wrong")
    return 1 if faults or not rows else 0


def code_span(text):
    return f"`` {text} ``" if "`" in text else f"`{text}`"


def page(root):
    parts = [INTRODUCTION]
    for section in table(root):
        parts.append(f"## {section.heading}\n")
        parts += ["\n".join(section.text) + "\n"] if section.text else []
        items = []
        for row in section.rows():
            typed = row.typed.removeprefix("$ ")
            meaning = " " + " ".join(row.meaning) if row.meaning else ""
            items.append(
                f"- {code_span(row.message)}\\\n  {row.answer}: {code_span(typed)}.{meaning}"
            )
        parts.append("\n".join(items) + "\n")
    return "\n".join(parts)


def main(arguments):
    writes = "--write" in arguments
    arguments = [argument for argument in arguments if argument != "--write"]
    if len(arguments) >= 3 and arguments[0] == "run":
        return run(
            pathlib.Path(arguments[1]).resolve(),
            pathlib.Path(arguments[2]).resolve(),
            arguments[3:],
            writes,
        )
    if len(arguments) == 2 and arguments[0] == "page":
        sys.stdout.write(page(pathlib.Path(arguments[1])))
        return 0
    print(__doc__.strip(), file=sys.stderr)
    return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
