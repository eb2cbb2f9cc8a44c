"""docs/stability.md promises the names of changeover.__all__, their arguments and attributes."""

import inspect
import pathlib
import unittest

import changeover

PROMISED = pathlib.Path(__file__).parents[2] / "tests" / "data" / "promised" / "python.txt"


def arguments(function):
    return [name for name in inspect.signature(function).parameters if name not in ("self", "cls")]


def names_of(name, thing):
    """A line for the name, each argument of a function and each attribute of a class."""
    yield name
    if inspect.isfunction(thing):
        yield from (f"{name}({argument})" for argument in arguments(thing))
    elif inspect.isclass(thing):
        for inner in dir(thing):
            if not inner.startswith("_") and not hasattr(Exception, inner):
                yield from names_of(f"{name}.{inner}", getattr(thing, inner))
    elif inspect.ismodule(thing):
        for inner in thing.__all__:
            yield from names_of(f"{name}.{inner}", getattr(thing, inner))


def names_now():
    return {line for name in changeover.__all__
            for line in names_of(name, getattr(changeover, name))}


class Promised(unittest.TestCase):
    def test_names_stay(self):
        promised = set(PROMISED.read_text(encoding="utf-8").splitlines())
        self.assertEqual(sorted(promised - names_now()), [], "promised, and gone")
        self.assertEqual(sorted(names_now() - promised), [], f"new; add them to {PROMISED.name}")


if __name__ == "__main__":
    unittest.main()
