"""Designs: made, read, verified, written, compared, enlarged, streamed."""

from __future__ import annotations

import collections.abc
import copyreg
import importlib
import json
import re
import operator
import zlib
from array import array
from typing import (
    Any, Dict, Iterator, List, Literal, Optional, Sequence, SupportsIndex, Tuple, Union, overload,
)

from . import _core
from ._given import Path, attempt, in_bytes, listed, rows_in_buffer, rows_of, words_of
from ._made import Kind, Made, check_calls, count_of, fact, in_a_line, known, made
from ._notebook import Shown, latex, shown, table
from .errors import BadInput, ImpossibleParameters
from .pictures import Picture, PictureKind, Theme, picture_of

Block = Tuple[int, ...]


class Blocks(Shown, _core.Memory):
    """Blocks in order: a read-only sequence of tuples of element numbers, and a buffer of shape (b,
    k) of unsigned 32-bit integers that NumPy wraps without a copy: numpy.asarray(blocks)."""

    __slots__ = ()

    @property
    def shape(self) -> Tuple[int, int]:
        """(b, k)"""
        rows, k = self._view().shape or (0, 0)
        return rows, k

    def tolist(self) -> List[List[int]]:
        """A list of lists of int."""
        rows: Any = self._view().tolist()
        return list(rows)

    @overload
    def __getitem__(self, index: slice) -> Blocks: ...
    @overload
    def __getitem__(self, index: SupportsIndex) -> Block: ...

    def __getitem__(self, index: Any) -> Any:
        count = len(self)
        if isinstance(index, slice):
            first, stop, step = index.indices(count)
            return self.part(first, len(range(first, stop, step)), step)
        if not hasattr(type(index), "__index__"):
            shown = _core.quoted(words_of(index if isinstance(index, str) else repr(index)))
            raise TypeError(f"blocks are indexed by a whole number or a slice, not by {shown}")
        place = operator.index(index)
        if not -count <= place < count:
            raise IndexError(f"the design has {count_of(count, 'block')}")
        return self.row(place % count)

    def index(self, block: Any) -> int:
        """The place of the first block that is this tuple. Raises ValueError if there is none."""
        return list(self).index(block)

    def count(self, block: Any) -> int:
        """How many blocks are this tuple."""
        return list(self).count(block)

    def __len__(self) -> int:
        return self.shape[0]

    def __iter__(self) -> Iterator[Block]:
        return (self.row(place) for place in range(len(self)))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Blocks):
            return NotImplemented
        return self.shape == other.shape and self._view() == other._view()

    def __hash__(self) -> int:
        return hash((self.shape, self._view().tobytes()))

    def __reduce_ex__(self, _protocol: Any = 2) -> Any:
        state = self._view().tobytes()
        return _blocks_again, (state, self.shape[1], zlib.crc32(state, self.shape[1]))

    __reduce__ = __reduce_ex__

    def _on_page(self) -> Any:
        rows = ((place, list(block)) for place, block in enumerate(self, 1))
        return repr(self)[1:-1], (), ("block", "elements"), rows, len(self)

    def _view(self) -> memoryview:
        exporter: Any = self
        return memoryview(exporter)

    def __repr__(self) -> str:
        return "<{} of {} elements>".format(count_of(self.shape[0], "block"), self.shape[1])


def _blocks_again(state: bytes, k: int, checksum: int) -> Blocks:
    """What pickle has of blocks. Raises BadInput for what is damaged."""
    fits = isinstance(k, int) and 0 < k < 2**32
    if not fits or zlib.crc32(state, k) != checksum:
        raise BadInput("this pickle of Blocks is damaged; create it again")
    blocks: Blocks = _core.blocks_of_bytes(Blocks, state, k)
    return blocks


class Verdict(Shown, Made):
    """What is true of a list of blocks; a true value if it is a design."""

    _hidden = ("name",)
    valid: bool = fact("It is a change covering design with these parameters.")
    tight: bool = fact("Every pair is newly covered exactly once.")
    economical: bool = fact("It has as many blocks as the counting bound.")
    minimum: bool = fact("Proved: no design with these parameters has fewer blocks.")
    b: int = fact("Number of blocks.")
    lower_bound: int = fact("No design with these parameters has fewer blocks.")
    v: int = fact()
    k: int = fact()
    change: int = fact()
    kind: str = fact()
    strength: int = fact()
    bad_steps: int = fact("How many steps do not change exactly `change` elements.")
    bad_step_examples: List[Tuple[int, int,
        int]] = fact("Up to twenty (from, to, changes); blocks are numbered from 1.")
    uncovered: int = fact("How many pairs are in no block.")
    uncovered_examples: List[List[int]] = fact("Up to twenty of them.")
    excess: int = fact("Newly covered pairs, with repetition, less the distinct ones.")
    fixed: List[int] = fact("Elements that are in every block.")
    introductions: List[int] = fact("i_x: by element, in how many blocks it is introduced.")
    memberships: List[int] = fact("r_x: by element, how many blocks contain it.")

    def _said(self) -> Any:
        # These are counted for blocks that were given or read, and not for those that were made.
        return {**self._facts, "unchanged_subsets": None}

    def as_dict(self) -> Dict[str, Any]:
        """Everything that the verifier found, as `changeover verify --json` has it under
        "details"."""
        said: Dict[str, Any] = json.loads(self._core)
        return said

    def __bool__(self) -> bool:
        return self.valid

    def __repr__(self) -> str:
        found = "not valid" if not self.valid else "valid, tight" if self.tight else "valid"
        return f"<Verdict: {self._facts['name']}, {count_of(self.b, 'block')}, {found}>"

    def _on_page(self) -> Any:
        rows = [(name.replace("_", " "), str(getattr(self, name))) for name in (
            "valid", "tight", "economical", "minimum", "b", "lower_bound", "bad_steps",
            "uncovered", "excess")]
        return self._facts["name"], (), ("verdict", "value"), rows, len(rows)


def _verdict(core: Any) -> Verdict:
    text = core.verdict()
    said = json.loads(text)
    bound = core.lower_bound()
    return made(
        Verdict,
        {
            **said,
            "name": core.facts()["name"],
            "lower_bound": bound,
            "minimum": said["valid"] and said["b"] == bound,
            "bad_step_examples": [
                (step["from"], step["to"], step["changes"]) for step in said["bad_step_examples"]
            ],
            "introductions": [each["introductions"] for each in said["elements"]],
            "memberships": [each["blocks"] for each in said["elements"]],
        },
        text,
    )


class Design(Made):
    """Blocks with their verdict: changeover.design() makes one, and Design(blocks, ...) is one of
    yours: what is not said is as in verify()."""

    v: int = fact("Number of elements.")
    k: int = fact("Elements in a block.")
    change: int = fact("Elements in which consecutive blocks differ.")
    kind: str = fact("'linear' or 'circular'.")
    strength: int = fact()
    b: int = fact("Number of blocks.")
    labels: Optional[List[str]] = fact("Names of the elements, or None if they are numbers.")

    def __new__(cls, *_args: Any, **_named: Any) -> Any:
        return object.__new__(cls)

    def __init__(
        self, blocks: Any, v: Optional[int] = None, change: Optional[int] = None,
        kind: Optional[Kind] = None, strength: int = 2,
    ) -> None:
        self._take(_core_of(blocks, v, change, kind, strength))

    def _take(self, core: Any) -> Any:
        self._core = core
        self._facts = core.facts()
        return self

    @property
    def blocks(self) -> Blocks:
        """The blocks, shape (b, k), without a copy."""
        blocks: Blocks = self._core.blocks(Blocks)
        return blocks

    @property
    def verdict(self) -> Verdict:
        """What the verifier found."""
        if "verdict" not in self._facts:
            self._facts["verdict"] = _verdict(self._core)
        verdict: Verdict = self._facts["verdict"]
        return verdict

    @property
    def recipe(self) -> Optional[Dict[str, Any]]:
        """How the blocks are made, as a dict, if that is known."""
        recipe: Optional[Dict[str, Any]] = json.loads(self._core.recipe())
        return recipe

    @property
    def transitions(self) -> List[Tuple[Block, Block, Block]]:
        """A list of (block, introduced, leaving), tuples of element numbers."""
        steps: List[Tuple[Block, Block, Block]] = self._core.transitions()
        return steps

    @property
    def group_order(self) -> int:
        """Order of the automorphism group, exact."""
        return int(self._core.group_order())

    def expand(
        self, *, new_elements: Optional[int] = None, set: Optional[int] = None,
        factorization: Literal["circle", "doubled"] = "circle",
    ) -> Design:
        """A design on more elements, verified: by the recursion with an expansion set, the one that
        is found as number `set` if given; where there is none, and for a number of new_elements (0:
        the best one), at unchanged subsets that may overlap. factorization, circle or doubled, is
        that of the new elements. Raises MissingResource with the reason if there is no such set or
        the elements cannot be inserted."""
        return design_of(self._core.expand(new_elements, set, factorization))

    def to_string(self, format: str = "text") -> str:
        """As text, json, csv, gap, sage, designtheory, ljcr or latex."""
        text: str = self._core.to_string(format)
        return text

    def to_json(self) -> str:
        """The document changeover-design/1: the same bytes as `changeover design ... --json`."""
        return self.to_string("json")

    def draw(
        self, picture: PictureKind = "array", *, theme: Theme = "light",
        order: Literal["first", "stays", "given"] = "first",
        colour: Literal["length", "ordinal"] = "length", leaving: bool = False, first: int = 1,
        last: Optional[int] = None,
    ) -> Picture:
        """A picture, which notebooks show: the blocks as an array, the stays of the elements, which
        pairs are covered when, the base blocks on a circle, or the tree of the recipe.

        theme: light or dark. order: of the elements in stays and coverage, by their first blocks,
        by their numbers of stays, or as they are numbered. colour: what that of a stay says, its
        length or its number among those of its element. leaving: an array marks leaving elements,
        too. first, last: blocks, from 1. Raises BadInput if the picture would be too large, or
        there is no recipe."""
        return picture_of(self._core, picture, theme, order, colour, leaving, first, last)

    def to_frame(self) -> Any:
        """A pandas.DataFrame with one row for each block. Raises ImportError without pandas."""
        pandas: Any = importlib.import_module("pandas")
        names = [f"element_{i + 1}" for i in range(self.k)]
        frame = pandas.DataFrame(self.blocks.tolist(), columns=names)
        if self.labels:
            frame = frame.apply(lambda column: column.map(dict(enumerate(self.labels))))
        frame.index = pandas.RangeIndex(1, self.b + 1, name="block")
        return frame

    def is_same_as(self, other: Design, reversal: bool = False) -> bool:
        """Whether they are the same up to names of elements and, if circular, rotation."""
        return bool(self._core.is_same_as(other._core, reversal))

    def canonical(self, reversal: bool = False) -> Design:
        """The same design for all designs that are the same as this one."""
        return design_of(self._core.canonical(reversal))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Design):
            return NotImplemented
        return bool(self._core.equals(other._core))

    def __hash__(self) -> int:
        return hash((self.v, self.change, self.kind, self.blocks))

    @overload
    def __getitem__(self, index: slice) -> Blocks: ...
    @overload
    def __getitem__(self, index: SupportsIndex) -> Block: ...

    def __getitem__(self, index: Any) -> Any:
        return self.blocks[index]

    def index(self, block: Any) -> int:
        """The place of the first block that is this tuple. Raises ValueError if there is none."""
        return self.blocks.index(block)

    def count(self, block: Any) -> int:
        """How many blocks are this tuple."""
        return self.blocks.count(block)

    def _title(self) -> str:
        known = self.verdict
        quality = ", ".join(
            [word for word in ("tight", "economical", "minimum") if getattr(known, word)]
            if known.valid else ["not valid"])
        return (f"{self._facts['name']}, {count_of(self.b, 'block')}"
                + (f": {quality}" if quality else ""))

    def _rows(self) -> Tuple[Sequence[str], Iterator[Tuple[int, List[str]]], int]:
        """Heads, rows and their number of a table of the blocks."""
        names = self.labels or range(self.v)
        rows = ((i, [str(names[x]) for x in block]) for i, block in enumerate(self.blocks, 1))
        return ("block", "elements"), rows, self.b

    def _repr_html_(self) -> str:
        drawn = self._repr_svg_()
        return shown(self._title(), (), table(*self._rows()) if drawn is None else drawn)

    def _repr_svg_(self) -> Optional[str]:
        most_blocks, most_elements = 48, 600
        if self.b > most_blocks or self.b * self.k > most_elements:
            return None
        return self.draw().svg

    def _repr_latex_(self) -> str:
        most_blocks, most_elements = 24, 300
        names = self.labels or range(self.v)
        if self.b > most_blocks or self.b * self.k > most_elements or not all(
                _fits_math(str(name)) for name in names):
            return latex(self._title(), (), *self._rows(), 60, "row")
        heads = " & ".join(f"B_{{{i + 1}}}" for i in range(self.b))
        rows = [" & ".join(_math(str(names[block[row]])) for block in self.blocks)
                for row in range(self.k)]
        lines = " \\\\\n".join([heads, *rows])
        return f"$$\\begin{{array}}{{{'l' * self.b}}}\n{lines}\n\\end{{array}}$$"

    def __getstate__(self) -> Tuple[str]:
        return (self.to_string("json"),)

    def __setstate__(self, state: Any) -> None:
        if not isinstance(state, tuple) or len(state) != 1 or not isinstance(state[0], str):
            raise TypeError("Design.__setstate__(): not the state of a pickled Design; pass what "
                            "__getstate__() returned")
        self._take(_core.Design.read_text(state[0], ""))

    def __reduce_ex__(self, _protocol: Any = 2) -> Any:
        return getattr(copyreg, "__newobj__"), (type(self),), self.__getstate__()

    __reduce__ = __reduce_ex__

    def __len__(self) -> int:
        return self.b

    def __iter__(self) -> Iterator[Block]:
        return iter(self.blocks)

    def __repr__(self) -> str:
        fault = "" if self._facts["valid"] else ", not valid"
        return f"<{self._facts['name']}, {count_of(self.b, 'block')}{fault}>"


for _each in (Blocks, Design):
    collections.abc.Sequence.register(_each)


def _math(name: str) -> str:
    if name.isdecimal():
        return name
    at_infinity = re.fullmatch("∞(?:_?([A-Za-z0-9]+))?", name)
    if at_infinity:
        return "\\infty" + (f"_{{{at_infinity[1]}}}" if at_infinity[1] else "")
    plain = "".join("\\" + c if c in "#%&_{}" else c for c in name)
    return f"\\text{{{plain}}}"


def _fits_math(name: str) -> bool:
    """Whether LaTeX and MathJax show it alike within a formula."""
    return not set(name) & set("\\$^~")


def design_of(core: Any) -> Design:
    """A design of the compiled module."""
    design: Design = Design.__new__(Design)._take(core)
    return design


class Stream(Made):
    """Batches of blocks, one after another; verified when the last one was read."""

    b: int = fact("Number of blocks of the whole stream.")
    v: int = fact()
    k: int = fact()
    kind: str = fact()

    def _kept(self) -> Any:
        raise TypeError("a Stream cannot be pickled or copied: it is read once; "
                        "call changeover.stream() again")

    # Each has its own place among the blocks.
    __eq__ = object.__eq__
    __hash__ = object.__hash__

    def __iter__(self) -> Stream:
        return self

    def __next__(self) -> Blocks:
        blocks: Blocks = self._core.next(Blocks)
        return blocks

    def __repr__(self) -> str:
        blocks = count_of(self.b, "block")
        return f"<Stream: {self.kind}, {blocks} of {self.k} of {self.v} elements>"


def _from_numbers(blocks: Any, v: Optional[int], change: Optional[int], *more: Any) -> Any:
    """Of a buffer of two dimensions of whole numbers: those below a v that was said, or all that
    occur if these are 0, 1, …, n−1. None if it is something else, or the numbers are names."""
    found = rows_in_buffer(blocks)
    if found is None:
        return None
    numbers, k = found
    if not len(numbers):
        return None
    if min(numbers) < 0:
        place = next(place for place, number in enumerate(numbers) if number < 0)
        raise BadInput(f"block {place // k + 1}: an element is negative; elements are 0, 1, ...")
    largest = max(numbers)
    if largest >= (_core.most_elements if v is None else min(v, _core.most_elements)) or (
            v is None and len(set(numbers)) <= largest):
        return None
    if change is None:
        change = len(set(numbers[k:2 * k]).difference(numbers[:k])) or 2
    elements = array("I", numbers).tobytes()
    count = largest + 1 if v is None else v
    try:
        return _core.Design.from_numbers(elements, k, count, change, *more)
    except (BadInput, ImpossibleParameters):
        return None  # What is wrong is said of any blocks in the same words.


def _element(element: Any, block: int) -> Union[str, int]:
    if isinstance(element, str):
        return element
    number = attempt(operator.index, element)
    if number is None:
        raise TypeError(
            f"block {block}: elements are whole numbers or strings, not {in_a_line(element)}")
    return number


def _core_of(blocks: Any, v: Any, change: Any, kind: Any, strength: int) -> Any:
    """A design of the compiled module, of a Design or Blocks, a two-dimensional buffer of whole
    numbers (a NumPy array), or any iterable of iterables of numbers or strings. What is not said is
    inferred by the rules of files."""
    if isinstance(blocks, Design):
        v = blocks.v if v is None else v
        change = blocks.change if change is None else change
        elements = blocks.blocks._view().tobytes()
        kind = kind or blocks.kind
        return _core.Design.from_numbers(elements, blocks.k, v, change, kind, strength,
                                         blocks.labels)
    if isinstance(blocks, (str, bytes)):
        raise TypeError("blocks are an array or a list of lists; changeover.loads() reads a text")
    parameters = v, change, kind, strength
    core = _from_numbers(blocks, *parameters)
    if core:
        return core
    # Anything else is written down as JSON and read as a file would be: one set of rules.
    rows = [[_element(element, number) for element in listed(f"block {number}", "elements", block)]
            for number, block in enumerate(rows_of("blocks", "lists of elements", blocks, True), 1)]
    text = words_of(json.dumps(rows, ensure_ascii=False, separators=(",", ":")))
    return _core.Design.read_text(text, "blocks", *parameters)


def design(
    v: int, k: int, change: int = 2, kind: Optional[Kind] = None, strength: int = 2, *,
    construction: str = "",
) -> Optional[Design]:
    """The best design that is known without search, verified, or None.

    v elements, blocks of k, consecutive blocks differ in `change` elements; kind 'linear' or
    'circular', or None: whichever has fewer blocks, circular if both have as many. Raises
    ImpossibleParameters if no such blocks can be written down, MissingResource if the design is too
    long for memory: see stream().
    """
    core = _core.Design.best_known(v, k, change, kind, strength, construction)
    return core and design_of(core)


def stream(v: int, k: int, change: int = 2, kind: Optional[Kind] = None, *,
           batch: int = 65536) -> Optional[Stream]:
    """The blocks of the same design as design() in batches: an iterator of Blocks of shape (at most
    batch, k), or None.

    For designs that are too long for memory. Raises InternalError at the end if what was read is no
    design.
    """
    core = _core.Stream.of(v, k, change, kind, batch)
    return core and made(Stream, core.facts(), core)


def explain(
    v: int, k: int, change: int = 2, kind: Optional[Kind] = None, strength: int = 2
) -> Optional[Dict[str, Any]]:
    """How the design of design() is built: a dict with construction, v, k, change, kind,
    explanation, citation, b and inputs, a list of the same for the designs that it is made of. None
    if nothing serves."""
    tree: Optional[Dict[str, Any]] = known("tree", v=v, k=k, change=change, kind=kind,
                                           strength=strength)
    return tree


def constructions() -> List[Dict[str, str]]:
    """A dict for each construction: name, summary, preconditions, guarantee, citation."""
    listed_: List[Dict[str, str]] = known("constructions")
    return listed_


def verify(
    blocks: Any, v: Optional[int] = None, change: Optional[int] = None, kind: Optional[Kind] = None,
    strength: int = 2,
) -> Verdict:
    """What is true of a list of blocks.

    blocks: a Design, an array of shape (b, k) of whole numbers, or lists of numbers or names. If v
    is not said, what occurs is the whole set; if change is not said, the first two blocks say it;
    kind is that of a Design, and 'linear' for other blocks, unless said. Raises BadInput for blocks
    of different sizes, repeated elements, or elements that are not below v. O(bk).
    """
    return _verdict(_core_of(blocks, v, change, kind, strength))


def read(path: Path) -> Design:
    """The design of a file of any format that is known: text, JSON, CSV, GAP, Sage, XML of
    designtheory.org, sets in brackets. Its verdict may be that it is none. Raises BadInput with line and column,
    MissingResource."""
    return design_of(_core.Design.read(in_bytes(path)))


def loads(text: str) -> Design:
    """The same for a text in memory."""
    return design_of(_core.Design.read_text(text, ""))


check_calls(globals())
