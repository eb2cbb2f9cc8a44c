#!/usr/bin/env python3
"""Finds words that readers stumble over (docs/style.md): in what the program, its pages and its
documentation say, and in comments.

usage: check_words.py ROOT   prints FILE:LINE: the words, and what to say instead; exit code 1 if
                             there are any
"""

import pathlib
import re
import sys

READ = (
    "README.md", "CHANGELOG.md", "HACKING.md", "CONTRIBUTING.md", "SECURITY.md", "CITATION.cff",
    "CMakeLists.txt", "pyproject.toml", "dev", ".ci", ".github", "src", "apps", "include", "python",
    "docs", "web/src", "examples", "bench", "cmake", "fuzz", "tests",
)
# Proofs and histories stay as they were written; style.md, this check and its test show the words.
LEFT_OUT = (
    "docs/theorems.md", "docs/style.md", "tests/docs/check_words.py", "tests/docs/check_words_test.py",
)
SUFFIXES = {
    ".cpp", ".hpp", ".c", ".h", ".py", ".pyi", ".md", ".ts", ".css", ".html", ".json", ".csv",
    ".bib", ".txt", ".sh", ".in", ".dox", ".cmake", ".svg", ".cff", ".toml", ".yml", ".mjs",
}
# Programs without a suffix.
NAMES = {"dev", "artifacts", "bare_machine", "nightly", "release", "run", "pre-commit", "pre-push"}

# Each as a pattern, in which a space is any gap (also one between two lines of a comment), and what
# to say instead.
WORDS = [
    ("nobody", "none, no other thread, no caller, …"),
    ("whoever", "the caller, the reader, a process that, …"),
    ("somebody|someone|anybody", "the caller, the user, another process, …"),
    ("(give|gives|given|giving) leave", "allow"),
    ("(is|are) not given away", "cannot be used as"),
    ("(begin|begins|began|begun|beginning) anew", "restart, start again"),
    ("(made|make|planned|plan|found|find|drawn|draw|read|counted|count) anew", "again"),
    ("the dearest|dearer|dear parts", "the most expensive, that costs more"),
    ("an? [a-z]+ of (its|their) own", "its own …, a separate …"),
    ("wait for its end", "wait until it finishes"),
    ("nothing else can come beside", "no other element fits"),
    ("make items larger", "group items into larger ones"),
    ("that are no text|which are no text", "unprintable characters, bytes that are not UTF-8"),
    ("is no key of", "unknown key"),
    ("which format is that", "unknown file extension"),
    ("what came of", "the outcome of, the result of"),
    ("and how good", "and its quality"),
    ("what is known is said here", "Details of …"),
    ("what the words mean", "Glossary"),
    ("colou?r says what|what a colou?r says", "Colour by, what a colour shows"),
    ("point at a cell", "select a cell"),
    (
        "an? (test|set-up|part|pair|slot|bench|block|file|line|step|row|item|object|rule|colou?r|"
        "script|column|byte) an? (line|row|kind|file|bench|cell|block|part|picture|page|factor)",
        "one … per …",
    ),
    ("parts called", "parts named"),
    ("the results of --done blame", "explain the failed tests"),
    ("simply|obviously|of course|basically", "(leave it out)"),
    ("in order to", "to"),
    ("utili[sz]e|leverage|seamless|seamlessly", "use"),
    ("whereof|wherefrom|whereto|thereof|therein|heretofore", "of which, in it, …"),
]

# What stands between two words of one sentence: blanks, line ends, the marks of comments, the
# quotes of a string that goes on.
GAP = r"[\s/#*\"]+"


def patterns():
    for words, better in WORDS:
        yield re.compile(
            r"(?<![\w-])(?:" + words.replace(" ", GAP) + r")(?![\w-])", re.IGNORECASE
        ), better


def any_pattern():
    """Matches, in small letters, where any of the patterns does: most files are done with it."""
    return re.compile(r"\b(?:" + "|".join(words.replace(" ", GAP) for words, _ in WORDS) + ")")


def files(root):
    for name in READ:
        top = root / name
        for path in [top] if top.is_file() else sorted(top.rglob("*")):
            if (path.is_file() and (path.suffix in SUFFIXES or path.name in NAMES)
                    and not {"__pycache__", "corpus"} & set(path.parts)
                    and not path.is_relative_to(root / "tests/data")
                    and path.relative_to(root).as_posix() not in LEFT_OUT):
                yield path


def faults(root):
    """How many files were read, and a line for each place."""
    found = []
    read = 0
    known = list(patterns())
    any_of_them = any_pattern()
    for path in files(root):
        text = path.read_text(encoding="utf-8")
        read += 1
        if not any_of_them.search(text.lower()):
            continue
        for pattern, better in known:
            for match in pattern.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                words = " ".join(re.split(GAP, match.group()))
                found.append((path.relative_to(root).as_posix(), line, f"'{words}'; say: {better}"))
    return read, [f"{name}:{line}: {what}" for name, line, what in sorted(found)]


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    read, found = faults(pathlib.Path(arguments[0]))
    for line in found:
        print(line)
    if read == 0:
        print(f"{arguments[0]}: nothing to read here: {', '.join(READ)}")
    return 1 if found or read == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
