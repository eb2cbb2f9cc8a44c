"""What the modules of the package share: calls that say in one line what does not fit, and objects
that only functions make."""

from __future__ import annotations

import collections.abc
import functools
import inspect
import json
import operator
import pickle
import reprlib
import types
import typing
import zlib
from typing import Any, Callable, Dict, Literal, Optional, Type, TypeVar, Union

from . import _core
from ._given import file_name
from ._progress import Bar
from .errors import BadInput

Kind = Literal["linear", "circular"]
Progress = Union[Callable[[Dict[str, Any]], object], bool, None]
T = TypeVar("T")
_names_of_files = ("path", "journal")


class _Closed(type):
    """Objects of the classes of this package have no attributes but those that their class says."""

    def __new__(cls, name: str, bases: tuple[type, ...], space: dict[str, Any]) -> _Closed:
        # Those that callers derive have what attributes they like.
        ours = str(space.get("__module__")).partition(".")[0] == __name__.partition(".")[0]
        return super().__new__(cls, name, bases, {"__slots__": (), **space} if ours else space)


def _not_pickled(self: Any, _protocol: Any = 2) -> Any:
    name = type(self).__name__
    raise TypeError(f"{'an' if name[0] in 'AEIO' else 'a'} {name} cannot be pickled or copied; "
                    "create it again where it is needed")


def frozen(value: Any) -> Any:
    """The same for equal values, and hashable."""
    if isinstance(value, dict):
        return frozenset((key, frozen(each)) for key, each in value.items())
    return tuple(map(frozen, value)) if isinstance(value, (list, tuple)) else value


class Made(metaclass=_Closed):
    """What functions return: it is not made by hand, and has either facts, or what the compiled
    module keeps of it."""

    __slots__ = ("_core", "_facts", "__weakref__")
    _core: Any
    _facts: dict[str, Any]
    _hidden: tuple[str, ...] = ()  # facts that are no properties

    def __new__(cls, *_args: Any, **_named: Any) -> Any:
        raise TypeError(
            f"{cls.__name__} objects cannot be constructed; call a function of changeover that "
            "returns one")

    def _said(self) -> Any:
        """What two of them are equal in."""
        return self._facts

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Made) or type(other) is not type(self):
            return NotImplemented
        return self is other or bool(self._said() == other._said())

    def __hash__(self) -> int:
        return hash((type(self).__name__, frozen(self._said())))

    def _kept(self) -> Any:
        """What pickles have of what the compiled module keeps."""
        return self._core if self._core is None or isinstance(self._core, str) else (
            _not_pickled(self))

    @classmethod
    def _core_again(cls, kept: Any, _facts: dict[str, Any]) -> Any:
        """That again, of what a pickle has."""
        return kept

    def __reduce_ex__(self, _protocol: Any = 2) -> Any:
        state = pickle.dumps((self._facts, self._kept()), 4)
        return _made_again, (type(self), state, zlib.crc32(state))

    __reduce__ = __reduce_ex__

    if not typing.TYPE_CHECKING:  # Only for what is not there.

        def __getattr__(self, name):
            if name in Made.__slots__:
                raise TypeError(
                    "this object is empty, made without its constructor; call a function that "
                    "returns one")
            raise AttributeError(f"'{type(self).__name__}' object has no attribute '{name}'")


# Nor is what the compiled module has made by hand: pybind11 would hand out what is empty.
for _each in vars(_core).values():
    if isinstance(_each, type):
        setattr(_each, "__new__", Made.__new__)
        setattr(_each, "__reduce_ex__", _not_pickled)


def made(kind: Type[T], facts: Optional[dict[str, Any]], core: Any = None) -> T:
    """Without facts one that finds them itself when they are needed."""
    one: Any = object.__new__(kind)
    one._core = core
    if facts is not None:
        one._facts = facts
    return typing.cast(T, one)


def fact_names(kind: Type[Any]) -> list[str]:
    return [name for owner in kind.__mro__ for name, each in vars(owner).items()
            if isinstance(each, _Fact)]


def known(about: str, **asked: Any) -> Any:
    """The document of "bounds", of a "table", of the "tree" of a design, or of "constructions"."""
    return json.loads(_core.known(about, **asked))


def name_of(v: int, k: int, change: int, kind: str, strength: int = 2, **_: Any) -> str:
    """What designs with these parameters are called."""
    short = {1: "SCCD", 2: "DCCD"}.get(change, f"{change}-change covering design ")
    return f"{kind} {short}({v},{k})" + ("" if strength == 2 else f", t = {strength}")


def linear_unless_said(kind: Optional[Kind]) -> Kind:
    """The kind of what is searched for, as on the command line."""
    return "linear" if kind is None else kind


def count_of(number: int, one: str, many: str = "") -> str:
    """A number and the word for what it counts: "1 block", "2 blocks"."""
    return f"{number} {one if number == 1 else many or one + 's'}"


def _made_again(kind: Any, *state: Any) -> Any:
    """What pickle has of an object: facts and core as bytes, and their checksum. Raises BadInput for
    what is damaged or misses facts that this version has."""
    if not (isinstance(kind, type) and issubclass(kind, Made)):
        raise TypeError("not the state of a pickled changeover object; load what pickle.dumps() "
                        "returned")
    if len(state) != 2 or not isinstance(state[0], bytes):
        raise BadInput(f"another version of changeover pickled this {kind.__name__}; create it "
                       "again")
    if zlib.crc32(state[0]) != state[1]:
        raise BadInput(f"this pickle of a {kind.__name__} is damaged; create it again")
    facts, kept = pickle.loads(state[0])
    for name in (*kind._hidden, *fact_names(kind)):
        if name not in facts:
            raise BadInput(f"another version of changeover pickled this {kind.__name__}, which has "
                           f"no {name}; create it again")
    return made(kind, facts, kind._core_again(kept, facts))


def _own(value: Any) -> Any:
    """A copy that the caller may change."""
    if isinstance(value, list):
        return [_own(each) for each in value]
    return {key: _own(each) for key, each in value.items()} if isinstance(value, dict) else value


_facts_of_many = {
    "v": "Number of elements.", "k": "Elements in a block.", "b": "Number of blocks.",
    "change": "Elements in which consecutive blocks differ.", "kind": "'linear' or 'circular'.",
    "strength": "How many elements meet in some block, whichever they are: 2, 3 or 4.",
    "reason": "Of the bound, one line.", "lower_bound": "No design has fewer blocks.",
    "standard_forms": "Designs in standard form.", "finished": "All of it is done.",
    "seconds": "How long it took.", "interrupted": "Ctrl-C ended it."}


class _Fact(property):
    def __set_name__(self, owner: type, name: str) -> None:
        text = self.__doc__ or _facts_of_many.get(name)
        property.__init__(self, lambda one: _own(one._facts[name]))
        self.__doc__ = text


def fact(doc: Optional[str] = None) -> Any:
    """A property: the fact of its name."""
    one = _Fact()
    one.__doc__ = doc
    return one


class _Misfit(Exception):
    """What an argument is, in words."""


def _text(value: Any) -> str:
    if isinstance(value, str):
        value.encode()
        return value
    if not isinstance(value, (bytes, bytearray)):
        raise ValueError
    return value.decode()


def whole(value: Any) -> int:
    """What Python takes for an index, and what is as much as an int without being a float or a
    text: Decimal(2), an array of one number."""
    try:
        number = operator.index(value)
        if isinstance(value, bool):
            raise ValueError
    except Exception:
        if isinstance(value, (bool, float, str, bytes, bytearray)):
            raise
        number = int(value)
        if not bool(number == value):  # Decimal("2.5"), numpy.float32(2.5)
            raise
    if not 0 <= number < 1 << 64:
        raise ValueError
    return number


def _number(value: Any) -> float:
    if isinstance(value, (str, bytes, bytearray)):
        raise ValueError
    return float(value)


def _truth(value: Any) -> bool:
    if value is not None and not hasattr(type(value), "__bool__"):
        raise ValueError
    return bool(value)


def _same_if(fits: Callable[[Any], object]) -> Callable[[Any], Any]:
    def same(value: Any) -> Any:
        if not fits(value):
            raise ValueError
        return value
    return same


_readers: dict[Any, tuple[Callable[[Any], Any], str]] = {
    int: (whole, "a whole number from 0 to 2**64 - 1"), float: (_number,
        "a number"), bool: (_truth, "True or False"),
    str: (_text, "a string"), Literal: (_text,
        "a string"), collections.abc.Callable: (_same_if(callable), "a function"),
    collections.abc.Iterable: (_same_if(lambda value: iter(value) is not None), "an iterable")}


def _fitted(wanted: Any, value: Any) -> Any:
    """The argument as its annotation says; any value where that says more than one thing."""
    origin, inner = typing.get_origin(wanted), typing.get_args(wanted)
    if origin is typing.Union:
        if len(inner) != 2 or inner[1] is not type(None):
            return value
        try:
            return None if value is None else _fitted(inner[0], value)
        except _Misfit as fault:
            raise _Misfit(f"{fault} or None")
    if isinstance(wanted, type) and wanted.__module__.startswith("changeover."):
        reader, words = _same_if(lambda given: isinstance(given, wanted)), f"a {wanted.__name__}"
    elif (origin or wanted) in _readers:
        reader, words = _readers[origin or wanted]
    else:
        return value
    try:
        return reader(value)
    except Exception:  # Whatever the class of the value raises.
        is_text = isinstance(value, str) and reader is _text
        raise _Misfit(words + " that can be written as UTF-8" if is_text else words)


def in_a_line(value: Any) -> str:
    """A value in a line, whatever its repr() does."""
    try:
        text = " ".join(reprlib.repr(value).split())
    except Exception:  # Such as an int of more digits than Python writes.
        text = f"<{type(value).__name__}>"
    return text if len(text) <= 80 else f"<{type(value).__name__}>"


def _bound(name: str, signature: inspect.Signature, given: tuple[Any, ...],
           named: dict[str, Any]) -> Any:
    """The arguments, or in a line why they are none."""
    try:
        bound = signature.bind(*given, **named)
    except TypeError as fault:
        names = ", ".join(each for each in signature.parameters if each != "self")
        return f"{name}(): {fault}; its arguments are {names or 'none'}"
    for argument, value in bound.arguments.items():
        if argument in _names_of_files:
            is_optional = signature.parameters[argument].default == ""
            read = "" if value is None and is_optional else file_name(argument, value)
            if read is None:
                return (f"{name}(): {argument} is a string or a pathlib.Path, "
                        f"not {in_a_line(value)}")
            bound.arguments[argument] = read
            continue
        try:
            bound.arguments[argument] = _fitted(signature.parameters[argument].annotation, value)
        except _Misfit as fault:
            words = "a whole number from 1 on" if argument == "threads" else fault
            return f"{name}(): {argument} is {words}, not {in_a_line(value)}"
        if argument == "progress":
            if not (value is None or isinstance(value, bool) or callable(value)):
                return (f"{name}(): progress is a function, True, False or None, "
                        f"not {in_a_line(value)}")
            bound.arguments[argument] = Bar() if value is True else value or None
    return bound


def checked(function: Callable[..., Any], name: str, owner: Optional[type] = None) -> Callable[...,
                                                                                               Any]:
    hints = typing.get_type_hints(function)
    written = inspect.signature(function)
    signature = written.replace(
        parameters=[each.replace(annotation=owner if each.name == "self"
                                 else hints.get(each.name, each.empty))
                    for each in written.parameters.values()],
        return_annotation=hints.get("return", written.return_annotation))

    @functools.wraps(function)
    def call(*given: Any, **named: Any) -> Any:
        bound = _bound(name, signature, given, named)
        if isinstance(bound, str):
            raise TypeError(bound)
        progress = bound.arguments.get("progress")
        try:
            return function(*bound.args, **bound.kwargs)
        finally:
            if isinstance(progress, Bar):
                progress.close()

    shown = [each.replace(annotation=each.empty) if each.name == "self" else each
             for each in signature.parameters.values()]
    setattr(call, "__signature__", signature.replace(parameters=shown))
    return call


def _check_methods(owner: type) -> None:
    """Those that it inherits, too: what does not fit is then said in its name."""
    for name in dir(owner):
        method = getattr(owner, name)
        if not isinstance(method, types.FunctionType) or hasattr(method, "__wrapped__"):
            continue
        if name == "__init__":
            setattr(owner, name, checked(method, owner.__name__, owner))
            given = list(inspect.signature(getattr(owner, name)).parameters.values())[1:]
            setattr(owner, "__signature__", inspect.Signature(given))
        elif not name.startswith("_"):
            setattr(owner, name, checked(method, f"{owner.__name__}.{name}", owner))


def check_calls(module: dict[str, Any]) -> None:
    """Has the public functions of a module, and the methods of its classes, called with what their
    annotations say, or refused."""
    for name, each in list(module.items()):
        if name.startswith("_") or getattr(each, "__module__", None) != module["__name__"]:
            continue
        if isinstance(each, types.FunctionType):
            module[name] = checked(each, name)
        elif isinstance(each, type):
            _check_methods(each)
