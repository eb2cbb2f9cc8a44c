"""Faults that are planted into a source file, all of them into one text.

    faults = find_faults("src/verify/verdict.cpp", arguments)      # what the compiler is given
    text = plant(source, faults, without=set())

Each fault is a small change at one place: another operator, a constant that is one off, a condition
that is negated or lost, a statement that is dropped, two arguments exchanged. The text that `plant`
returns has them all, each behind a question that is asked when the program runs:

    a < b     becomes     (planted_fault(17) ? ((a) <= (b)) : planted_fault(18) ? ((a) >= (b)) : (a
                          < b))

so that one build serves every fault: the environment variable CHANGEOVER_FAULT says which of them
is real. The lines of the text are those of the source.

Where expressions begin and end is asked of libclang, not guessed.
"""

import re
from dataclasses import dataclass, field

from clang.cindex import CursorKind as Kind
from clang.cindex import Index, TypeKind

OTHER = {
    "<": ["<=", ">="],
    "<=": ["<", ">"],
    ">": [">=", "<="],
    ">=": [">", "<"],
    "==": ["!="],
    "!=": ["=="],
    "+": ["-"],
    "-": ["+"],
    "*": ["+"],
    "/": ["*"],
    "%": ["/"],
    "&": ["|"],
    "|": ["&"],
    "^": ["|"],
    "<<": [">>"],
    ">>": ["<<"],
    "+=": ["-="],
    "-=": ["+="],
    "*=": ["+="],
    "/=": ["*="],
    "%=": ["/="],
    "|=": ["&="],
    "&=": ["|="],
    "^=": ["|="],
    "<<=": [">>="],
    ">>=": ["<<="],
}
DECIDES = {"<", "<=", ">", ">=", "==", "!=", "&&", "||"}
# Exchanging the arguments of these changes nothing.
SYMMETRIC = {"min", "max", "gcd", "swap", "checked_add", "checked_multiply", "add_pair"}
LOOPS = {Kind.FOR_STMT, Kind.WHILE_STMT, Kind.DO_STMT, Kind.CXX_FOR_RANGE_STMT}
FUNCTIONS = {
    Kind.FUNCTION_DECL, Kind.CXX_METHOD, Kind.CONSTRUCTOR, Kind.DESTRUCTOR, Kind.FUNCTION_TEMPLATE,
    Kind.LAMBDA_EXPR, Kind.CONVERSION_FUNCTION,
}


@dataclass
class Fault:
    """One change. Where it stands is a place of the source; `how` tells it apart from others
    there."""
    path: str
    line: int
    start: int
    end: int
    how: str
    becomes: str  # an expression; "" if the statement is dropped
    number: int = 0

    def key(self, source_line):
        return f"{self.path} | {source_line.strip()} | {self.how}"


@dataclass
class Found:
    faults: list = field(default_factory=list)
    fixed: list = field(
        default_factory=list
    )  # (start, end, text, name): constants that are made at run time
    constants: list = field(default_factory=list)  # (start, end): where these are declared


def flat(text):
    """An expression on one line, without comments."""
    text = re.sub(r"//[^\n]*", " ", text)
    text = re.sub(r"/\*.*?\*/", " ", text, flags=re.S)
    return " ".join(text.split())


class Finder:
    def __init__(self, path, shown_as, arguments):
        self.path = path
        self.shown_as = shown_as
        self.source = open(path, encoding="utf-8").read()
        self.bytes = self.source.encode()
        self.found = Found()
        self.seen = set()
        unit = Index.create().parse(path, args=arguments)
        serious = [str(d) for d in unit.diagnostics if d.severity >= 3]
        if serious:
            raise SystemExit(f"mutate: libclang cannot read {shown_as}: {serious[0]}")
        for cursor in unit.cursor.get_children():
            if cursor.location.file and cursor.location.file.name == path:
                self.visit(cursor, None, False)

    # ---- Places
    # -----------------------------------------------------------------------------------------

    def range(self, cursor):
        return cursor.extent.start.offset, cursor.extent.end.offset

    def text(self, cursor):
        start, end = self.range(cursor)
        return flat(self.bytes[start:end].decode())

    def mine(self, cursor):
        start, end = self.range(cursor)
        file = cursor.extent.start.file
        return file is not None and file.name == self.path and start < end

    def add(self, cursor, how, becomes, end=None):
        start, own_end = self.range(cursor)
        key = (start, end or own_end, becomes)
        if not self.mine(cursor) or key in self.seen:
            return
        self.seen.add(key)
        line = self.bytes[:start].count(b"\n") + 1
        self.found.faults.append(Fault(self.shown_as, line, start, end or own_end, how, becomes))

    def children(self, cursor):
        return [c for c in cursor.get_children() if self.mine(c)]

    def bare(self, cursor):
        """Without what the compiler put around it, and parentheses."""
        while cursor.kind in (Kind.UNEXPOSED_EXPR, Kind.PAREN_EXPR):
            inner = self.children(cursor)
            if len(inner) != 1:
                break
            cursor = inner[0]
        return cursor

    def operator(self, cursor):
        """The operator with two operands that the cursor is, with them, or None."""
        is_call = cursor.kind == Kind.CALL_EXPR and cursor.spelling.startswith("operator")
        if (
            cursor.kind not in (Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR)
            and not is_call
        ):
            return None
        inner = self.children(cursor)
        if len(inner) < 2:
            return None
        left, right = inner[0], inner[-1]
        between = flat(self.bytes[self.range(left)[1]:self.range(right)[0]].decode())
        between = between.strip("() ")
        return (between, left, right) if between in OTHER or between in ("&&", "||", "=") else None

    # ---- Faults
    # -----------------------------------------------------------------------------------------

    def visit(self, cursor, parent, in_loop):
        kind = cursor.kind
        if kind in (
            Kind.STATIC_ASSERT, Kind.ENUM_DECL, Kind.TYPEDEF_DECL, Kind.TYPE_ALIAS_DECL,
            Kind.CASE_STMT, Kind.TEMPLATE_NON_TYPE_PARAMETER, Kind.USING_DECLARATION,
        ):
            if kind != Kind.CASE_STMT:
                return
        if kind in (Kind.VAR_DECL, Kind.FIELD_DECL) and not self.variable(cursor):
            return
        self.faults_at(cursor)
        if kind in FUNCTIONS:
            in_loop = False
        if kind in LOOPS:
            in_loop = True
        self.statements(cursor, parent, in_loop)
        inner = list(cursor.get_children())
        if kind == Kind.CASE_STMT:
            inner = inner[1:]
        if kind in (Kind.VAR_DECL, Kind.FIELD_DECL):  # what stands before the name is a type
            inner = [c for c in inner if c.extent.start.offset >= cursor.location.offset]
        for child in inner:
            self.visit(child, cursor, in_loop)

    def variable(self, cursor):
        """Whether faults may be planted in what it is initialised with. Constants are made at run
        time."""
        start, end = self.range(cursor)
        text = self.bytes[start:end].decode()
        head = re.match(r"(static\s+)?(inline\s+)?constexpr\b", text)
        if not head:
            return "[" not in text.split("=")[0] or cursor.kind == Kind.VAR_DECL and "{" in text
        if cursor.type.get_canonical().kind not in (
            TypeKind.INT,
            TypeKind.UINT,
            TypeKind.LONG,
            TypeKind.ULONG,
        ):
            return False
        self.found.constants.append((start, end))
        in_class = cursor.semantic_parent.kind in (
            Kind.CLASS_DECL,
            Kind.STRUCT_DECL,
            Kind.CLASS_TEMPLATE,
        )
        self.found.fixed.append(
            (
                start,
                start + len(head.group(0)),
                "inline static const" if in_class else "static const",
                cursor.spelling,
            )
        )
        return True

    def faults_at(self, cursor):
        found = self.operator(cursor)
        if found:
            self.operators(cursor, *found)
        if cursor.kind == Kind.UNARY_OPERATOR:
            self.unary(cursor)
        if cursor.kind == Kind.INTEGER_LITERAL:
            self.constant(cursor)
        if cursor.kind == Kind.CXX_BOOL_LITERAL_EXPR and not self.endless(cursor):
            text = self.text(cursor)
            other = {"true": "false", "false": "true"}.get(text)
            if other:
                self.add(cursor, f"{text} -> {other}", other)
        if cursor.kind in (Kind.IF_STMT, Kind.WHILE_STMT, Kind.CONDITIONAL_OPERATOR):
            inner = self.children(cursor)
            if inner and inner[0].kind.is_expression():
                self.negate(inner[0])
        if cursor.kind == Kind.RETURN_STMT:
            inner = self.children(cursor)
            if inner and inner[0].type.get_canonical().kind == TypeKind.BOOL:
                self.negate(inner[0])
        if cursor.kind == Kind.CALL_EXPR:
            self.call(cursor)

    def endless(self, literal):
        """Whether it is the condition of while (true): what follows such a loop is nothing."""
        start = self.range(literal)[0]
        return re.search(rb"while\s*\($", self.bytes[:start]) is not None

    def operators(self, cursor, operator, left, right):
        a, b = self.text(left), self.text(right)
        if operator in ("&&", "||"):
            self.add(cursor, f"'{b}' is not asked", f"!!({a})")
            self.add(cursor, f"'{a}' is not asked", f"!!({b})")
            self.negate(left)
            self.negate(right)
            return
        if operator in ("<<", ">>", "|", "&") and cursor.kind == Kind.CALL_EXPR:
            return  # streams, paths
        for other in OTHER.get(operator, []):
            self.add(cursor, f"'{a} {operator} {b}': {operator} -> {other}", f"({a}) {other} ({b})")

    def unary(self, cursor):
        text = self.text(cursor)
        if text.startswith(("++", "--")):
            other = "--" if text[0] == "+" else "++"
            self.add(cursor, f"{text} -> {other}{text[2:]}", other + text[2:])
        elif text.endswith(("++", "--")):
            other = "--" if text[-1] == "+" else "++"
            self.add(cursor, f"{text} -> {text[:-2]}{other}", text[:-2] + other)
        elif text.startswith("!"):
            self.add(cursor, f"{text} -> {text[1:]}", f"!!({text[1:]})")
        elif text.startswith("-") or text.startswith("~"):
            inner = self.children(cursor)
            if inner and self.bare(inner[0]).kind != Kind.INTEGER_LITERAL:
                self.add(cursor, f"{text} -> {text[1:]}", f"({text[1:]})")

    def constant(self, cursor):
        text = self.text(cursor)
        match = re.fullmatch(r"(0[xX][0-9a-fA-F']+|[0-9][0-9']*)([uUlL]*)", text)
        if not match:
            return
        value = int(
            match.group(1).replace("'", ""), 0 if match.group(1)[:2] in ("0x", "0X") else 10
        )
        changes = (1,) if value == 0 or match.group(1)[:2] in ("0x", "0X") else (1, -1)
        for change in changes:
            self.add(cursor, f"{text} -> {value + change}", f"{value + change}{match.group(2)}")

    def negate(self, cursor):
        bare = self.bare(cursor)
        found = self.operator(bare)
        if (found and found[0] in DECIDES) or (
            bare.kind == Kind.UNARY_OPERATOR and self.text(bare)[0] == "!"
        ):
            return
        if bare.kind in (Kind.INTEGER_LITERAL, Kind.CXX_BOOL_LITERAL_EXPR):
            return
        text = self.text(cursor)
        if "[&]" not in text:
            self.add(cursor, f"{text} -> !({text})", f"!({text})")

    def call(self, cursor):
        inner = self.children(cursor)
        text = self.text(cursor)
        name = cursor.spelling
        if not name and inner:
            name = self.text(inner[0]).split("<")[0].split("::")[-1]
        if name in ("min", "max"):
            other = "max" if name == "min" else "min"
            self.add(
                cursor, f"{text}: {name} -> {other}", re.sub(rf"\b{name}\b", other, text, count=1)
            )
        if (
            name.startswith("operator")
            or name in SYMMETRIC
            or "[&" in text
            or "[](" in text
            or "[=" in text
        ):
            return
        given = [a for a in cursor.get_arguments() if a is not None and self.mine(a)]
        start, _ = self.range(cursor)
        for left, right in zip(given, given[1:]):
            a, b = self.text(left), self.text(right)
            same = left.type.get_canonical().spelling.replace(
                "const ", ""
            ) == right.type.get_canonical().spelling.replace("const ", "")
            if (
                not same
                or a == b
                or a.endswith("begin()")
                or self.range(left)[1] >= self.range(right)[0]
            ):
                continue
            _, end = self.range(cursor)
            exchanged = (self.bytes[start:self.range(left)[0]].decode() + b +
                         self.bytes[self.range(left)[1]:self.range(right)[0]].decode() + a +
                         self.bytes[self.range(right)[1]:end].decode())
            self.add(cursor, f"{name}: '{a}' and '{b}' exchanged", flat(exchanged))

    # ---- Statements
    # ---------------------------------------------------------------------------------------

    def statements(self, cursor, parent, in_loop):
        """Those directly inside the cursor that can be dropped."""
        inner = self.children(cursor)
        if cursor.kind == Kind.COMPOUND_STMT:
            last_of_function = (
                inner[-1] if inner and parent is not None and parent.kind in FUNCTIONS else None
            )
            for child in inner:
                last = last_of_function is not None and child == last_of_function
                if last and (
                    self.bare(child).kind in (Kind.RETURN_STMT, Kind.CXX_THROW_EXPR)
                    or b"noreturn"
                    in self.bytes[max(0, self.range(parent)[0] - 16) : self.range(child)[0]]
                ):
                    continue  # a function that must not end there: the compiler may assume that it does not
                self.drop(child, in_loop)
        elif cursor.kind in LOOPS or cursor.kind == Kind.IF_STMT:
            for child in inner[1:]:
                if self.next_byte(child) == b";" and self.before(child) in (b")", b"e"):
                    self.drop(child, in_loop)

    def next_byte(self, cursor):
        return self.bytes[self.range(cursor)[1]:].lstrip()[:1]

    def before(self, cursor):
        return self.bytes[:self.range(cursor)[0]].rstrip()[-1:]

    def drop(self, child, in_loop):
        bare = self.bare(child)
        effect = bare.kind in (
            Kind.CALL_EXPR, Kind.BINARY_OPERATOR, Kind.COMPOUND_ASSIGNMENT_OPERATOR,
            Kind.CONDITIONAL_OPERATOR, Kind.UNARY_OPERATOR, Kind.CXX_THROW_EXPR, Kind.RETURN_STMT,
            Kind.CONTINUE_STMT, Kind.UNEXPOSED_EXPR,
        )
        if bare.kind == Kind.BREAK_STMT and in_loop:
            effect = True
        if bare.kind == Kind.UNARY_OPERATOR and self.text(bare)[:2] in ("++", "--"):
            pass
        if not effect or not self.mine(child):
            return
        end = self.range(child)[1]
        semicolon = self.bytes.find(b";", end)
        if semicolon < 0 or self.bytes[end:semicolon].strip():
            return
        self.add(child, f"'{self.text(child)}' is dropped", "", semicolon + 1)


def find_faults(path, shown_as, arguments):
    """@return what can be planted into the file, in order of place."""
    found = Finder(path, shown_as, arguments).found
    found.faults.sort(key=lambda f: (f.start, -f.end))
    return found


def plant(data, found, without, fixed_without):
    """The source with all faults but those whose number is in `without`.
    @param fixed_without names of constants that stay constants."""
    sites = {}
    for fault in found.faults:
        if fault.number not in without:
            sites.setdefault((fault.start, fault.end), []).append(fault)
    order = sorted(sites, key=lambda place: (place[0], -place[1]))
    # A place that overlaps another one without lying in it cannot be rewritten.
    for start, end, text, name in found.fixed:
        if name not in fixed_without:
            sites[(start, end)] = text
            order.append((start, end))
    order.sort(key=lambda place: (place[0], -place[1]))

    def asks(fault):
        constant = any(start <= fault.start < end for start, end in found.constants)
        return f"planted_{'constant' if constant else 'fault'}({fault.number})"

    def render(start, end, index):
        out = []
        at = start
        while index < len(order) and order[index][0] < end:
            place = order[index]
            if place[0] < at or place[1] > end:
                index += 1
                continue
            out.append(data[at:place[0]].decode())
            if isinstance(sites[place], str):
                inner, index = sites[place], index + 1
                out.append(inner)
            else:
                inner, index = render(place[0], place[1], index + 1)
                drops = [f for f in sites[place] if f.becomes == ""]
                others = [f for f in sites[place] if f.becomes != ""]
                if others:
                    inner = ("(" + "".join(f"{asks(f)} ? ({f.becomes}) : " for f in others) +
                             f"({inner}))")
                if drops:
                    inner = "{ if (!%s) { %s } }" % (asks(drops[0]), inner)
                out.append(inner)
            at = place[1]
        out.append(data[at:end].decode())
        return "".join(out), index

    text, _ = render(0, len(data), 0)
    return text
