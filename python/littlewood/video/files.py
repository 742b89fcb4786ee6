"""Videos as files: reading and writing by OpenCV."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.extras import require
from .errors import UnreadableVideoError, UnwritableVideoError

__all__ = ["Frame", "FrameWriter", "codecs", "frames", "open_video"]

Frame = npt.NDArray[np.uint8]
"""A frame: rows, columns, and blue, green, red, as OpenCV has them."""

_CODECS = {".mp4": "mp4v", ".mov": "mp4v", ".avi": "MJPG"}
"""Codecs by the ending of a file: both are in every build of OpenCV, and play almost everywhere."""


def codecs() -> dict[str, str]:
    """Return the endings of videos that are written, and their codecs."""
    return dict(_CODECS)


def open_video(path: str | Path) -> Any:
    """Open a video as OpenCV reads it; refuse what is no file, or none that it decodes."""
    cv2 = require("cv2")
    if not Path(path).exists():
        raise UnreadableVideoError(str(path), "there is no such file")
    if not Path(path).is_file():
        raise UnreadableVideoError(str(path), "it is a folder, a pipe or a device, not a file")
    capture = cv2.VideoCapture(str(path))
    if not capture.isOpened():
        raise UnreadableVideoError(
            str(path),
            "OpenCV cannot decode it: is it a video? If it is, convert it: ffmpeg -i FILE "
            "converted.mp4",
        )
    return capture


def frames(path: str | Path, wanted: Collection[int] | None = None) -> Iterator[Frame]:
    """Yield the frames of a video.

    Parameters
    ----------
    path : str or Path
        The video.
    wanted : collection of int, optional
        Numbers of the frames, from 0; all by default.

    Raises
    ------
    UnreadableVideoError
        If there is no such file, or OpenCV cannot decode it.
    """
    capture = open_video(path)
    number = 0
    try:
        while capture.grab():
            if wanted is None or number in wanted:
                found, frame = capture.retrieve()
                if not found or frame is None:
                    raise UnreadableVideoError(
                        str(path),
                        f"OpenCV cannot decode frame {number}; "
                        "convert the video: ffmpeg -i FILE converted.mp4",
                    )
                yield frame
            number += 1
    finally:
        capture.release()


class FrameWriter:
    """Writes frames into a `.mp4`, `.mov` (MPEG-4) or `.avi` (Motion JPEG).

    By default they play in slow motion.
    """

    def __init__(self, path: str | Path, size: tuple[int, int], fps: float = 30.0) -> None:
        cv2 = require("cv2")
        ending = Path(path).suffix.lower()
        if ending not in _CODECS:
            raise UnwritableVideoError(
                str(path), f"the extension must be one of {', '.join(_CODECS)}"
            )
        if not Path(path).parent.is_dir():
            raise UnwritableVideoError(str(path), "there is no such folder")
        code = cv2.VideoWriter.fourcc(*_CODECS[ending])
        # OpenCV's own writer of Motion JPEG has a quality, that of FFmpeg has not.
        backend = cv2.CAP_OPENCV_MJPEG if ending == ".avi" else cv2.CAP_ANY
        self._writer = cv2.VideoWriter(str(path), backend, code, fps, size)
        if not self._writer.isOpened():
            raise UnwritableVideoError(str(path), f"this OpenCV cannot write {_CODECS[ending]}")
        if ending == ".avi":
            self._writer.set(cv2.VIDEOWRITER_PROP_QUALITY, 95.0)

    def write(self, frame: Frame) -> None:
        """Append a frame."""
        self._writer.write(frame)

    def close(self) -> None:
        """Finish the file."""
        self._writer.release()

    def __enter__(self) -> FrameWriter:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        at: TracebackType | None,
    ) -> None:
        self.close()
