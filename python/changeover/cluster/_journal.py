"""Which pairs are done: in memory, and in a journal from which a killed run goes on."""

from __future__ import annotations

import fcntl
import hashlib
import json
import os
import warnings
import zlib
from array import array
from typing import Any, Dict, Iterator, List, Optional, Tuple

from ..errors import BadInput, MissingResource

_format = "changeover-cluster-journal/1"
_most_bits = 1 << 32


class PairSet:
    """Pairs i <= j of so many items: a bit each if they are not too many."""

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
        """False if it was there."""
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
    """What tells a job from others: its name, its items and its pairs, in whatever order."""
    job: Dict[str, Any] = {"format": _format, "name": name, "items": items, "wanted": kind}
    if listed is not None:
        digest = hashlib.sha256()
        for i, j in sorted(listed):
            digest.update(b"%d %d\n" % (i, j))
        job["pairs"] = digest.hexdigest()
    return job


class Journal:
    """A line a pair, written when sink() has returned, and a checksum after each stretch.

    A process that is killed leaves every whole line in the file. Machines that lose power may leave
    anything after the last checksum: from the first line that is none on nothing counts.
    """

    def __init__(self, path: str, job: Dict[str, Any]) -> None:
        self._path = path
        self._lines: List[bytes] = []
        try:
            self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND, 0o666)
        except OSError as fault:
            raise MissingResource(f"{path}: cannot open the journal: {fault.strerror}") from fault
        try:
            self._lock()
            with open(path, "rb") as file:
                text = file.read()
            end = text.find(b"\n") + 1
            if end == 0:
                os.ftruncate(self._file, 0)
                self._write(json.dumps(job, sort_keys=True).encode() + b"\n")
                self._done: List[Tuple[int, int]] = []
            else:
                self._check_job(text[:end], job)
                self._done, whole = self._read(text, end, job["items"])
                if whole < len(text):
                    os.ftruncate(self._file, whole)
                self.checkpoint()
        except BaseException:
            os.close(self._file)
            raise

    def _lock(self) -> None:
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as fault:
            raise MissingResource(
                f"{self._path}: another run uses this journal; wait until it finishes, or name "
                "another one") from fault

    def _check_job(self, line: bytes, job: Dict[str, Any]) -> None:
        try:
            said = json.loads(line)
        except ValueError:
            said = None
        if not isinstance(said, dict) or said.get("format") != _format:
            raise BadInput(f"{self._path}: this file is no journal of a run on a cluster")
        for key, value in job.items():
            if said.get(key) != value:
                raise BadInput(
                    f"{self._path}: the journal is of another job, whose {key} differs; name "
                    "another journal, or remove this one")

    def _read(self, text: bytes, begin: int, items: int) -> Tuple[List[Tuple[int, int]], int]:
        """The pairs, and where what counts ends."""
        done: List[Tuple[int, int]] = []
        block = begin  # where the lines after the last checksum begin
        counted = 0
        place = begin
        while True:
            end = text.find(b"\n", place)
            if end < 0:
                break
            words = text[place:end].split(b" ")
            try:
                if words[0] == b"=":
                    if text[place:end] != b"= %08x" % zlib.crc32(text[block:place]):
                        raise ValueError
                    block, counted = end + 1, len(done)
                else:
                    i, j = map(int, words)
                    if not 0 <= i <= j < items:
                        raise ValueError
                    done.append((i, j))
            except (ValueError, IndexError):
                # What stands before it since the last checksum may be as wrong.
                warnings.warn(f"{self._path}: damaged at byte {place}; pairs recorded after byte "
                              f"{block} are computed again", stacklevel=6)
                return done[:counted], block
            place = end + 1
        self._lines = [text[block:place]] if place > block else []
        return done, place

    def _write(self, line: bytes) -> None:
        try:
            while line:
                line = line[os.write(self._file, line):]
        except OSError as fault:
            raise MissingResource(
                f"{self._path}: cannot write the journal: {fault.strerror}") from fault

    def done(self) -> Iterator[Tuple[int, int]]:
        return iter(self._done)

    def record(self, i: int, j: int) -> None:
        line = b"%d %d\n" % (i, j)
        self._write(line)
        self._lines.append(line)

    def checkpoint(self) -> None:
        if self._lines:
            self._write(b"= %08x\n" % zlib.crc32(b"".join(self._lines)))
            self._lines = []
            os.fsync(self._file)

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
