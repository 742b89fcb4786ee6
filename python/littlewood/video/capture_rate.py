"""The rate at which a telephone took a video, as its file says it.

The key `com.android.capture.fps`.

OpenCV does not show it. A file of MPEG-4 or QuickTime consists of boxes, each with its length and
its kind, of which some hold others. Those of the movie hold a table of keys and a list of values.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO, NamedTuple

__all__ = ["CAPTURE_RATE", "capture_rate"]

CAPTURE_RATE = "com.android.capture.fps"
"""The key of the rate at which the frames were taken."""

# No more boxes than that are looked at, and no larger table of metadata is read.
_MOST_BOXES = 10_000
_MOST_BYTES = 1 << 20
# Types of values by their codes.
_TEXT = 1
_NUMBERS = {23: ">f", 24: ">d"}
_INTEGERS = {21: True, 22: False}


class _Box(NamedTuple):
    kind: bytes
    begin: int
    end: int


def capture_rate(path: str | Path) -> float | None:
    """Return the frames a second at which a video was taken, as its file says it.

    None where it does not.

    Metadata that cannot be understood say nothing.
    """
    with Path(path).open("rb") as file:
        size = file.seek(0, 2)
        left = iter(range(_MOST_BOXES))
        for movie in _boxes(file, 0, size, left):
            if movie.kind != b"moov":
                continue
            inner = list(_boxes(file, movie.begin, movie.end, left))
            # In the movie itself, or among what its user may add.
            inner += [
                one
                for box in inner
                if box.kind == b"udta"
                for one in _boxes(file, box.begin, box.end, left)
            ]
            for box in inner:
                if box.kind == b"meta" and box.end - box.begin <= _MOST_BYTES:
                    rate = _in_metadata(file, box, left)
                    if rate is not None and rate > 0.0 and math.isfinite(rate):
                        return rate
    return None


def _boxes(file: BinaryIO, begin: int, end: int, left: Iterator[int]) -> Iterator[_Box]:
    """Yield the boxes between two places of a file, as long as they are whole."""
    while begin + 8 <= end and next(left, None) is not None:
        file.seek(begin)
        head = file.read(16)
        if len(head) < 8:
            return
        length, kind = struct.unpack(">I4s", head[:8])
        inner = begin + 8
        if length == 1 and len(head) == 16:
            (length,) = struct.unpack(">Q", head[8:])
            inner = begin + 16
        elif length == 0:
            length = end - begin
        if begin + length > end or begin + length < inner:
            return
        yield _Box(kind, inner, begin + length)
        begin += length


def _in_metadata(file: BinaryIO, box: _Box, left: Iterator[int]) -> float | None:
    """Return the rate of a box of metadata.

    That of the place which the key has in the table of keys.
    """
    begin = box.begin
    file.seek(begin + 4)
    # QuickTime puts the boxes at once, MPEG-4 a version before them.
    if file.read(4) != b"hdlr":
        begin += 4
    inner = {one.kind: one for one in _boxes(file, begin, box.end, left)}
    keys, values = inner.get(b"keys"), inner.get(b"ilst")
    if keys is None or values is None:
        return None
    # A key has a length and a name space before its name, as a box has; a version and a count come
    # first.
    names = []
    for key in _boxes(file, keys.begin + 8, keys.end, left):
        file.seek(key.begin)
        names.append(file.read(min(key.end - key.begin, 100)))
    for value in _boxes(file, values.begin, values.end, left):
        place = int.from_bytes(value.kind, "big")
        if 1 <= place <= len(names) and names[place - 1] == CAPTURE_RATE.encode():
            for data in _boxes(file, value.begin, value.end, left):
                if data.kind == b"data":
                    file.seek(data.begin)
                    return _number(file.read(min(data.end - data.begin, 64)))
    return None


def _number(data: bytes) -> float | None:
    """Return a value: four bytes are its type, four its language."""
    kind, payload = int.from_bytes(data[:4], "big"), data[8:]
    try:
        if kind in _NUMBERS:
            return float(struct.unpack(_NUMBERS[kind], payload)[0])
        if kind in _INTEGERS:
            return float(int.from_bytes(payload, "big", signed=_INTEGERS[kind]))
        return float(payload.decode("ascii")) if kind == _TEXT else None
    except (struct.error, ValueError):
        return None
