"""Errors, by who can correct them."""


class Error(Exception):
    """Base of every fault of this package."""


class BadInput(Error, ValueError):
    """What was given is malformed; one line says what, where, and how to correct it."""


class ImpossibleParameters(Error, ValueError):
    """Nothing with these parameters can exist, or they exceed what is supported."""


class MissingResource(Error, OSError):
    """Something outside is missing: memory, room on the disk, a file, a permission."""


class InternalError(Error, RuntimeError):
    """A bug of this library: a result failed its own verification."""
