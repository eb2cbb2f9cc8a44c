"""Calls of the core that say in one line what does not fit. pybind11 says it in many, and names no argument."""

from __future__ import annotations

import ast
import copyreg
import functools
import inspect
import operator
import reprlib
import types
import typing


def signature_of(function, classes: dict[str, type]) -> inspect.Signature:
    """What the first line of a docstring of pybind11 says, with the types that it means where Python has one."""
    line = function.__doc__.split("\n", 1)[0]
    written = ast.parse(f"def {line}: ...").body[0]
    assert isinstance(written, ast.FunctionDef)
    known = {**vars(typing), "int": int, "str": str, "float": float, "bool": bool, "list": list, "dict": dict,
             "object": object, "function": typing.Callable}

    def type_of(node):
        if isinstance(node, ast.Attribute):  # changeover._core.Design
            return classes.get(node.attr, object)
        if isinstance(node, ast.Subscript):
            inner = type_of(node.slice)
            return typing.Optional[inner] if ast.unparse(node.value) == "Optional" else object
        if isinstance(node, ast.Constant):
            return node.value
        return known.get(node.id, object)

    empty = inspect.Parameter.empty

    def parameters(how, arguments, defaults):
        for each, default in zip(arguments, defaults):
            yield inspect.Parameter(each.arg, how, default=empty if default is None else ast.literal_eval(default),
                                    annotation=empty if each.arg == "self" else type_of(each.annotation))

    given = written.args
    without = [None] * (len(given.args) - len(given.defaults))
    return inspect.Signature([
        *parameters(inspect.Parameter.POSITIONAL_OR_KEYWORD, given.args, [*without, *given.defaults]),
        *parameters(inspect.Parameter.KEYWORD_ONLY, given.kwonlyargs, given.kw_defaults)])


def _succeeds(what, *args) -> bool:
    try:
        what(*args)
    except Exception:  # Of whoever wrote the value.
        return False
    return True


def _whole(value) -> bool:
    """As pybind11 has it: what Python takes for an index, and what becomes an int without being a float or a text."""
    try:
        return 0 <= operator.index(value) < 1 << 64
    except Exception:
        if isinstance(value, (float, str, bytes, bytearray)) or _succeeds(operator.index, value):
            return False
    try:
        return 0 <= int(value) < 1 << 64
    except Exception:
        return False


def _shown(value) -> str:
    """A value in a line, whatever its repr() does."""
    try:
        text = " ".join(reprlib.repr(value).split())
    except Exception:  # Such as an int of more digits than Python writes.
        text = f"<{type(value).__name__}>"
    return text if len(text) <= 80 else f"<{type(value).__name__}>"


def _what_does_not_fit(wanted, value) -> str:
    """What an argument of a type is, in words; nothing if the value is one. What pybind11 takes, fits."""
    inner = [each for each in typing.get_args(wanted) if each is not type(None)]
    if typing.get_origin(wanted) is typing.Union:
        text = "" if value is None else _what_does_not_fit(inner[0], value)
        return text and f"{text} or None"
    if wanted is int:
        return "" if _whole(value) else "a whole number from 0 to 2**64 - 1"
    if wanted is float:
        fits = not isinstance(value, (str, bytes, bytearray)) and _succeeds(float, value)
        return "" if fits else "a number"
    if wanted is bool:
        fits = value is None or (hasattr(type(value), "__bool__") and _succeeds(bool, value))
        return "" if fits else "True or False"
    if wanted is str:
        if isinstance(value, str):
            return "" if _succeeds(value.encode) else "a string that can be written as UTF-8"
        return "" if isinstance(value, (bytes, bytearray)) else "a string"
    if wanted is typing.Iterable:
        return "" if _succeeds(iter, value) else "an iterable"
    if wanted is typing.Callable:
        return "" if callable(value) else "a function"
    if isinstance(wanted, type) and wanted is not inspect.Parameter.empty:
        return "" if isinstance(value, wanted) else f"a {wanted.__name__}"
    return ""


def _why(name: str, owner: type, signature: inspect.Signature, args, kwargs) -> str:
    try:
        given = signature.bind(*args, **kwargs).arguments
    except TypeError as fault:
        names = ", ".join(each for each in signature.parameters if each != "self")
        return f"{name}(): {fault}; its arguments are {names or 'none'}"
    for argument, value in given.items():
        wanted = owner if argument == "self" else signature.parameters[argument].annotation
        text = _what_does_not_fit(wanted, value)
        if text:
            return f"{name}(): {argument} is {text}, not {_shown(value)}"
    return f"{name}(): an argument has a type that it does not take; help() says which it does"


def in_one_line(function, classes: dict[str, type], name: str, owner: type = object):
    """The same function, whose TypeErrors are one line."""
    signature = signature_of(function, classes)

    @functools.wraps(function)
    def call(*args, **kwargs):
        try:
            return function(*args, **kwargs)
        except TypeError as fault:
            below = fault.__traceback__ and fault.__traceback__.tb_next  # Python, such as a callback.
            if below or not str(fault).startswith(f"{function.__name__}(): incompatible "):
                raise
        raise TypeError(_why(name, owner, signature, args, kwargs))

    call.__qualname__ = name if owner is object else f"{owner.__qualname__}.{function.__name__}"
    setattr(call, "__signature__", signature)
    return call


def _not_by_hand(made, *_args, **_kwargs):
    """Without a constructor there is nothing in it."""
    raise TypeError(f"{made.__name__} is what functions of changeover return, and is not made by hand")


def _reduce(self, _protocol=2):
    """As Python has it from protocol 2 on; for 0 and 1 it would make an object of pybind11's base, which ends the process."""
    if not hasattr(type(self), "__setstate__"):
        raise TypeError(f"a {type(self).__name__} cannot be pickled or copied")
    return copyreg.__newobj__, (type(self),), self.__getstate__()


def say_all_in_one_line(module) -> None:
    """Replaces the functions of a module of pybind11, and the methods of its classes."""
    classes = {name: each for name, each in vars(module).items() if isinstance(each, type)}
    for name, each in list(vars(module).items()):
        if inspect.isbuiltin(each):
            setattr(module, name, in_one_line(each, classes, name.lstrip("_")))
        elif inspect.ismodule(each):
            say_all_in_one_line(each)
    for owner, each in classes.items():
        if not issubclass(each, BaseException):
            setattr(each, "__reduce_ex__", _reduce)
            setattr(each, "__reduce__", _reduce)
        if isinstance(vars(each).get("__init__"), types.WrapperDescriptorType) and not issubclass(each, BaseException):
            setattr(each, "__new__", _not_by_hand)
        for name, method in list(vars(each).items()):
            described = (getattr(method, "__doc__", None) or "").startswith(f"{name}(self: ")
            if described and (name in ("__init__", "__setstate__") or not name.startswith("__")):
                shown = owner if name == "__init__" else f"{owner}.{name}"
                setattr(each, name, in_one_line(method, classes, shown, each))
