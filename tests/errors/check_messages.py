#!/usr/bin/env python3
"""Every message of the sources is run or has its reason.

usage: check_messages.py ROOT

A message is accounted for if a row of the table (tests/data/errors, which errors.py runs) says its
words, if a test of the project holds them, or else if tests/data/errors/elsewhere.txt names it with
a reason. What is thrown as an InternalError is a bug of ours, and no row can show it.
"""

import pathlib
import re
import sys

import errors
import messages

TESTS = ("tests", "python/tests", "web/tests", "bench")
SUFFIXES = (".cpp", ".hpp", ".c", ".py", ".sh", ".mjs")
NO_TESTS = ("tests/errors", "tests/docs")  # they hold words of messages, and run none
LIMITS = (
    "docs/limits.md"  # tests try each row of its tables, and hold the last column to what is said
)
SHORTEST = 16  # characters in a row of a message that a test must repeat
LEAST = 10     # characters of a message that has holes between them, where a test has all of it
LITERALS = re.compile(r'"((?:[^"\\\n]|\\.)*)"|\'((?:[^\'\\\n]|\\.)*)\'')


def words_of_tests(root):
    """The literals of the tests that can hold a message: those with blanks, and long enough to be
    of no other message."""
    words = set()
    for top in TESTS:
        for path in sorted((root / top).rglob("*")) if (root / top).is_dir() else []:
            if (
                path.suffix in SUFFIXES
                and "__pycache__" not in path.parts
                and not path.relative_to(root).as_posix().startswith(NO_TESTS)
            ):
                text = re.sub(
                    r'"\s*\n\s*f?"', "", path.read_text(encoding="utf-8", errors="replace")
                )
                words.update(literal for quoted in LITERALS.findall(text) for literal in quoted)
    # Those of Python are patterns.
    words = {re.sub(r"\\(.)", r"\1", literal).strip("^$") for literal in words}
    if (root / LIMITS).is_file():
        words.update(
            re.findall(r"`([^`]+)` \|$", (root / LIMITS).read_text(encoding="utf-8"), re.MULTILINE)
        )
    return {literal for literal in words if len(literal) >= SHORTEST and " " in literal.strip()}


def held(found, tests):
    """The messages, as they are shown, that a test holds: it has all their words, with what fills
    the holes, or words that are of no other message."""
    by_longest, shown = {}, set()
    for message in found:
        by_longest.setdefault(longest(message), []).append(message)
    all_parts = "\n".join(part for message in found for part in message.parts)
    all_words = "\n".join(tests)
    candidates = [(words, messages) for words, messages in by_longest.items() if words in all_words]
    for literal in tests:
        within = [
            message for words, messages in candidates if words in literal for message in messages
        ]
        shown |= {
            message.shown
            for message in within
            if sum(len(part.strip()) for part in message.parts) >= LEAST and message.is_in(literal)
        }
        parts = {message.shown for message in within if len(longest(message)) >= SHORTEST}
        if literal in all_parts:
            parts |= {
                message.shown for message in found for part in message.parts if literal in part
            }
        shown |= parts if len(parts) == 1 else set()
    return shown


def elsewhere(root):
    """Rows of elsewhere.txt: (line number, words, reason)."""
    path = root / errors.TABLE / "elsewhere.txt"
    rows, lines = [], path.read_text(encoding="utf-8").split("\n") if path.is_file() else []
    for number, line in enumerate(lines, 1):
        if line.startswith("    ") and rows and not rows[-1][2]:
            rows[-1] = (*rows[-1][:2], line.strip())
        elif line and not line.startswith(("#", " ")):
            rows.append((number, line, ""))
        elif line.startswith(" "):
            rows.append((number, "", ""))
    return rows


def longest(message):
    return max(message.parts, key=len, default="").strip()


def accounts(root, found):
    """For each message how it is accounted for: "row", "test", "elsewhere", "bug" or ""; and the
    rows of elsewhere that were used."""
    said = [row.message for section in errors.table(root) for row in section.rows()]
    in_tests = held(found, words_of_tests(root))
    reasons = elsewhere(root)
    used = set()
    how = []
    for message in found:
        if any(message.is_in(line) for line in said):
            how.append("row")
        elif message.kind == messages.BUG:
            how.append("bug")
        elif message.shown in in_tests:
            how.append("test")
        elif matching := [
            number
            for number, shown, _ in reasons
            if shown and shown in (message.shown, f"{message.path}: *")
        ]:
            used.update(matching)
            how.append("elsewhere")
        else:
            how.append("")
    return how, used


def faults(root):
    found, bare = messages.of_sources(root)
    how, used = accounts(root, found)
    missing = [
        f"{message.path}:{message.line}: '{message.shown}': no row of {errors.TABLE} says it, and "
        "no test"
        for message, account in zip(found, how)
        if not account
    ]
    for number, shown, reason in elsewhere(root):
        place = f"{errors.TABLE}/elsewhere.txt:{number}"
        if not shown or not reason:
            missing.append(
                f"{place}: words of a message on a line, and below it a reason, indented by four "
                "blanks"
            )
        elif number not in used:
            missing.append(
                f"{place}: '{shown}': no message of the sources, or one that a row or a test says"
            )
        for test in re.findall(r"\btests/[\w./]+\w", reason):
            if not (root / test).exists():
                missing.append(f"{place}: there is no {test}")
    missing += [
        f"{path}:{line}: {kind} is thrown with words that come from nowhere; word it here or in a "
        "function ..._defect()"
        for path, line, kind in bare
    ]
    counts = {account: how.count(account) for account in ("row", "test", "elsewhere", "bug")}
    return counts, missing


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    counts, missing = faults(pathlib.Path(arguments[0]))
    for line in missing:
        print(line)
    print(
        f"{sum(counts.values())} messages: {counts['row']} in the table, {counts['test']} in other "
        "tests, "
        f"{counts['elsewhere']} with a reason, {counts['bug']} bugs of ours; {len(missing)} faults"
    )
    return 1 if missing or not counts["row"] else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
