"""The pairs that are done: in memory, and in a journal from which a killed run continues."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import stat
import warnings
import zlib
from array import array
from typing import Any, BinaryIO, Dict, Iterator, List, Optional, Tuple

from .. import _core
from ..errors import BadInput, MissingResource

_format = "changeover-cluster-journal/1"
_most_bits = 1 << 32
_longest_line, _longest_head = 64, 1 << 16


class PairSet:
    """Pairs i <= j of a number of items: one bit each unless there are too many."""

    def __init__(self, items: int) -> None:
        self._items = items
        bits = items * (items + 1) // 2
        self._bits = bytearray((bits + 7) // 8) if bits <= _most_bits else None
        self._set: set[int] = set()
        self.count = 0

    def _place(self, i: int, j: int) -> int:
        return i * self._items - i * (i - 1) // 2 + j - i

    def __contains__(self, pair: Tuple[int, int]) -> bool:
        place = self._place(*pair)
        if self._bits is None:
            return place in self._set
        return bool(self._bits[place >> 3] >> (place & 7) & 1)

    def add(self, i: int, j: int) -> bool:
        """False if the pair was there already."""
        place = self._place(i, j)
        if self._bits is None:
            if place in self._set:
                return False
            self._set.add(place)
        else:
            if self._bits[place >> 3] >> (place & 7) & 1:
                return False
            self._bits[place >> 3] |= 1 << (place & 7)
        self.count += 1
        return True


def name_of_job(items: int, listed: Optional[List[Tuple[int, int]]], kind: str,
                name: str) -> Dict[str, Any]:
    """The identity of a job: its name, its items and its pairs, in any order."""
    job: Dict[str, Any] = {"format": _format, "name": name, "items": items, "wanted": kind}
    if listed is not None:
        digest = hashlib.sha256()
        for i, j in sorted(listed):
            digest.update(b"%d %d\n" % (i, j))
        job["pairs"] = digest.hexdigest()
    return job


class Journal:
    """One line per pair, written after sink() has returned: `i j checksum`. The checksum includes
    everything before it, also the head, so a line counts only where it was written.

    A killed process leaves every complete line in the file. After a loss of power, anything may
    follow the last checkpoint: lines from the first wrong checksum on do not count.
    """

    def __init__(self, path: str, job: Dict[str, Any]) -> None:
        self._path = path
        self._changed = False
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_NONBLOCK, 0o666)
        except ValueError as fault:
            raise BadInput(f"journal: {_core.quoted(path)} is not a file name; remove the zero byte") from fault
        except OSError as fault:
            raise MissingResource(f"{path}: cannot open the journal: {fault.strerror}") from fault
        try:
            if not stat.S_ISREG(os.fstat(self._file).st_mode):
                raise BadInput(f"{path}: a journal is a file, and this is none")
            self._lock()
            self._begin(json.dumps(job, sort_keys=True).encode() + b"\n", job)
        except BaseException:
            os.close(self._file)
            raise

    def _begin(self, head: bytes, job: Dict[str, Any]) -> None:
        self._done = array("I")
        try:
            with open(os.dup(self._file), "rb") as file:
                first = file.readline(max(len(head), _longest_head))
                if head.startswith(first) and first != head:  # Empty, or cut off.
                    whole = 0
                else:
                    self._check_job(first, job)
                    whole = self._read(file, first, job["items"])
                size = file.seek(0, os.SEEK_END)
        except OSError as fault:
            raise MissingResource(
                f"{self._path}: cannot read the journal: {fault.strerror}; check the path and the "
                "permissions") from fault
        if whole < size:
            try:
                os.ftruncate(self._file, whole)
            except OSError as fault:
                raise self._unwritten(fault) from fault
        if whole == 0:
            self._checksum = zlib.crc32(head)
            self._write(head)

    def _lock(self) -> None:
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as fault:
            raise MissingResource(
                f"{self._path}: another run uses this journal; wait until it finishes, or name "
                "another one") from fault

    def _check_job(self, line: bytes, job: Dict[str, Any]) -> None:
        try:
            said = json.loads(line) if line.endswith(b"\n") else None
        except (ValueError, RecursionError):
            said = None
        if not isinstance(said, dict) or said.get("format") != _format:
            raise BadInput(f"{self._path}: this file is not a journal of a run on a cluster")
        for key, value in job.items():
            if said.get(key) != value:
                raise BadInput(
                    f"{self._path}: the journal is of another job, whose {key} differs; name "
                    "another journal, or remove this one")

    def _read(self, file: BinaryIO, head: bytes, items: int) -> int:
        """The end of the lines that count."""
        self._checksum = zlib.crc32(head)
        place = len(head)
        while (line := file.readline(_longest_line)) and (
                line.endswith(b"\n") or len(line) == _longest_line):
            pair, _, checksum = line.rpartition(b" ")
            sum_here = zlib.crc32(pair, self._checksum)
            try:
                if checksum != b"%08x\n" % sum_here:
                    raise ValueError
                i, j = map(int, pair.split(b" "))
                if not 0 <= i <= j < items:
                    raise ValueError
            except ValueError:
                warnings.warn(f"{self._path}: damaged at byte {place}; pairs that were recorded "
                              "from there on are computed again", stacklevel=8)
                return place
            self._done.extend((i, j))
            self._checksum = sum_here
            place += len(line)
        return place

    def _write(self, line: bytes) -> None:
        self._changed = True
        try:
            while line:
                line = line[os.write(self._file, line):]
        except OSError as fault:
            raise self._unwritten(fault) from fault

    def _unwritten(self, fault: OSError) -> MissingResource:
        return MissingResource(f"{self._path}: cannot write the journal: {fault.strerror}")

    def done(self) -> Iterator[Tuple[int, int]]:
        return zip(self._done[::2], self._done[1::2])

    def record(self, i: int, j: int) -> None:
        pair = b"%d %d" % (i, j)
        checksum = zlib.crc32(pair, self._checksum)
        self._write(b"%s %08x\n" % (pair, checksum))
        self._checksum = checksum

    def checkpoint(self) -> None:
        """Makes the records survive a loss of power."""
        if self._changed:
            try:
                os.fsync(self._file)
            except OSError as fault:
                raise self._unwritten(fault) from fault
            self._changed = False

    def close(self) -> None:
        try:
            self.checkpoint()
        finally:
            os.close(self._file)


def ends_of(pairs: Iterator[Tuple[int, int]]) -> array[int]:
    ends = array("I")
    for pair in pairs:
        ends.extend(pair)
    return ends
