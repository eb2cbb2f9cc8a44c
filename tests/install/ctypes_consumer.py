"""The shared library, called from Python: prints the loads of the order that the program in C goes
through."""

import ctypes
import sys


class Step(ctypes.Structure):
    _fields_ = [
        ("number", ctypes.c_uint64),
        ("evict", ctypes.POINTER(ctypes.c_uint32)),
        ("evict_count", ctypes.c_size_t),
        ("load", ctypes.POINTER(ctypes.c_uint32)),
        ("load_count", ctypes.c_size_t),
    ]


library = ctypes.CDLL(sys.argv[1])
library.changeover_loadorder_open.restype = ctypes.c_void_p
library.changeover_loadorder_open.argtypes = [
    ctypes.c_uint64,
    ctypes.c_uint64,
    ctypes.c_char_p,
    ctypes.c_size_t,
]
library.changeover_loadorder_next.argtypes = [ctypes.c_void_p, ctypes.POINTER(Step)]
library.changeover_loadorder_close.argtypes = [ctypes.c_void_p]
library.changeover_loadorder_close.restype = None

items, room = 50, 9
error = ctypes.create_string_buffer(512)
order = library.changeover_loadorder_open(items, room, error, len(error))
if not order:
    sys.exit(error.value.decode())
step, inside, met, loads = Step(), set(), set(), 0
while (status := library.changeover_loadorder_next(order, ctypes.byref(step))) == 1:
    inside -= set(step.evict[: step.evict_count])
    new = set(step.load[: step.load_count])
    inside |= new
    loads += len(new)
    assert len(inside) <= room
    met |= {frozenset((x, y)) for x in new for y in inside if x != y}
assert status == 0 and len(met) == items * (items - 1) // 2
library.changeover_loadorder_close(order)
print(loads)
