"""Finds the messages of the sources: what is thrown, and what is given to functions that throw.

A message is the words of one literal (adjacent literals are one) with a blank in it, inside a
`throw` of an exception of ours, a call of a function that is marked [[noreturn]], a call or the
body of a function of MAKERS, which words messages for others to throw, or a `raise` of Python.
Holes, which are filled at run time, stand as "{}".
"""

import ast
import pathlib
import re

SOURCES = ("include", "src", "apps", "python/src", "python/changeover")
BUG = "InternalError"  # exit code 5: what is thrown there is never seen if we are right
EXCEPTIONS = (
    "BadInput", "BadOption", "ImpossibleParameters", "MissingResource", "ReaderGone", BUG,
    "Refusal", "UsageError", "value_error", "type_error", "index_error", "key_error",
)
# Functions and lambdas that throw what they are given, beside those that are [[noreturn]].
REFUSERS = {"fail", "refuse", "refused", "doubtful"}
# Functions that word messages which others throw, as patterns of their names.
MAKERS = (
    r"\w*_defect",
    "defect", "defect_of", "complaint", "how_to_mend", "has_no_design", "left_out", "impossibility",
    "why_forbidden", "refusal", "fault_of_entry", r"simple_reason", "model_defect", "broken_line",
    "rules",  # between options: their lines are data
)

LITERAL = re.compile(r'(?:u8|L)?"((?:[^"\\\n]|\\.)*)"')
RAW = re.compile(r'R"([^(\s]*)\((.*?)\)\1"', re.DOTALL)
CHARACTER = re.compile(r"(?<![0-9A-Za-z_])'(?:[^'\\\n]|\\.[0-7a-fA-F]*)'")
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
HOLE = re.compile(r"\{\{|\}\}|\{[^{}]*\}")
NORETURN = re.compile(r"\[\[noreturn\]\][^;{(]*?(\w+)\(")
# What a throw without its own words may pass on: a fault that was caught, or what a function of
# MAKERS or a parameter says.
PASSED_ON = re.compile(
    r"\b(?:what|message|defect|why|line|fault|missing|left_out_)\b|"
    + "|".join(rf"\b{m}\(" for m in MAKERS)
)
THROW = re.compile(r"\bthrow\s+(?:\w+::)*(?P<kind>" + "|".join(EXCEPTIONS) + r")\s*[({]")


class Message:
    """Words of a source, and where they stand. `parts` is what stands between the holes."""

    def __init__(self, path, line, kind, text):
        self.path, self.line, self.kind = path, line, kind
        self.text = HOLE.sub(lambda hole: {"{{": "{", "}}": "}"}.get(hole.group(), "\0"), text)
        self.parts = [part for part in self.text.split("\0") if part.strip()]
        self.shown = self.text.replace("\0", "{}").strip()

    def is_in(self, said):
        """Do the words stand in `said`, in their order?"""
        at = 0
        for part in self.parts:
            at = said.find(part, at)
            if at < 0:
                return False
            at += len(part)
        return True


def unescaped(literal):
    plain = {"n": "\n", "t": "\t", "\\": "\\", '"': '"', "'": "'", "0": "\0"}
    return re.sub(r"\\(.)", lambda escape: plain.get(escape.group(1), escape.group(1)), literal)


def without_comments(text):
    """The same length and lines, with blanks in place of comments."""
    out, at = [], 0
    token = re.compile(
        "|".join(f"(?:{each.pattern})" for each in (RAW, LITERAL, CHARACTER, COMMENT)).replace(
            r"\1", r"\1"
        ),
        re.DOTALL,
    )
    for match in token.finditer(text):
        if match.group().startswith(("//", "/*")):
            out += [text[at:match.start()], re.sub(r"[^\n]", " ", match.group())]
            at = match.end()
    return "".join([*out, text[at:]])


def scanned(text, opening):
    """The literals between the bracket at `opening` and the one that closes it, adjacent ones as
    one; and where that ends."""
    depth, at, found, current = 0, opening, [], None
    while at < len(text):
        raw, plain, character = (each.match(text, at) for each in (RAW, LITERAL, CHARACTER))
        literal = raw or plain
        if literal:
            words = raw.group(2) if raw else unescaped(plain.group(1))
            current = (at, words) if current is None else (current[0], current[1] + words)
            at = literal.end()
            continue
        if not text[at].isspace() and current is not None:
            found.append(current)
            current = None
        if character:
            at = character.end()
            continue
        depth += text[at] in "({["
        depth -= text[at] in ")}]"
        at += 1
        if depth == 0:
            break
    return found, at


def worded(text, opening, offset=0):
    """The literals between two brackets that are words of a message: with a blank, and longer than
    a connective."""
    return [
        (at + offset, words)
        for at, words in scanned(text, opening)[0]
        if " " in words.strip() and len(words) > 6
    ]


def between(text, opening):
    """What stands between a bracket and the one that closes it."""
    return text[opening:scanned(text, opening)[1]]


def of_variables(text, names):
    """Words that are given to variables of these names: `name = …;`."""
    found = []
    for name in set(names):
        for match in re.finditer(rf"\b{name}(?:\[\])? ?\+?=(?!=)", text):
            found += worded(
                "(" + text[match.end() : text.find(";\n", match.end())] + ")", 0, match.end() - 1
            )
    return found


def of_cpp(path, text, functions):
    """Messages of a source, and the sites that throw words which stand elsewhere: (line, kind)."""
    text = without_comments(text)
    site = re.compile(
        THROW.pattern + r"|(?<![\w\"])(?P<function>" + "|".join(sorted(functions)) + r")\("
    )
    body = re.compile(
        r"(?<=[\s*&:])(?P<maker>" + "|".join(MAKERS) + r")\([^;{}]*\)(?: const)?(?: noexcept)? \{"
    )
    found, bare, seen = [], [], set()
    for match in [*site.finditer(text), *body.finditer(text)]:
        opening = match.end() - 1
        groups = match.groupdict()
        kind = groups.get("kind") or groups.get("function") or groups.get("maker")
        own = worded(text, opening)
        for at, words in own:
            if at not in seen:
                seen.add(at)
                found.append(Message(path, text.count("\n", 0, at) + 1, kind, words))
        if not own and groups.get("kind") and kind != BUG:
            said = between(text, opening)
            named = of_variables(text, re.findall(r"\b[a-z]\w*\b", LITERAL.sub("", said)))
            for at, words in named:
                if at not in seen:
                    seen.add(at)
                    found.append(Message(path, text.count("\n", 0, at) + 1, kind, words))
            if not named and not PASSED_ON.search(said):
                bare.append((text.count("\n", 0, match.start()) + 1, kind))
    return found, bare


def of_python(path, text):
    found = []
    for node in ast.walk(ast.parse(text)):
        if not isinstance(node, ast.Raise) or not isinstance(node.exc, ast.Call):
            continue
        kind = ast.unparse(node.exc.func)
        for part in ast.walk(node.exc):
            if isinstance(part, ast.JoinedStr):
                words = "".join(
                    piece.value.replace("{", "{{").replace("}", "}}")
                    if isinstance(piece, ast.Constant)
                    else "{}"
                    for piece in part.values
                )
            elif isinstance(part, ast.Constant) and isinstance(part.value, str):
                words = part.value.replace("{", "{{").replace("}", "}}")
            else:
                continue
            if " " in words.strip() and len(words) > 6:
                found.append(Message(path, part.lineno, kind, words))
    pieces = {(message.line, message.shown) for message in found}
    return [
        message
        for message in found
        if not any(
            line <= message.line and message.shown in shown and message.shown != shown
            for line, shown in pieces
        )
    ]


def of_sources(root):
    """All messages of the sources below `root`, and the sites without words of their own: (path,
    line, kind)."""
    files = [
        path
        for top in SOURCES
        for path in sorted((root / top).rglob("*"))
        if path.suffix in (".cpp", ".hpp", ".h", ".py")
    ]
    texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8") for path in files}
    functions = {name for text in texts.values() for name in NORETURN.findall(text)} | REFUSERS
    messages, bare = [], []
    for path, text in texts.items():
        if path.endswith(".py"):
            messages += of_python(path, text)
        else:
            found, without = of_cpp(path, text, functions)
            messages += found
            bare += [(path, line, kind) for line, kind in without]
    return messages, bare
