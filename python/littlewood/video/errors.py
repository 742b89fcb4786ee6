"""Errors of videos."""

from __future__ import annotations

__all__ = [
    "NoHoopError",
    "NoMarkerError",
    "TooFewFramesError",
    "UnreadableVideoError",
    "UnwritableVideoError",
    "VideoError",
    "VideoFileError",
]


class VideoError(ValueError):
    """A video that cannot be used."""


class VideoFileError(VideoError):
    """A file that cannot be used, and why.

    Attributes
    ----------
    path : str
        The file.
    """

    def __init__(self, path: str, reason: str) -> None:
        super().__init__(f"{path}: {reason}")
        self.path = path


class UnreadableVideoError(VideoFileError):
    """A file that is missing, or that OpenCV cannot decode."""


class UnwritableVideoError(VideoFileError):
    """A file that cannot be written: an unknown ending, a codec that this OpenCV does not have, or a missing folder."""


class TooFewFramesError(VideoError):
    """A video, or a part of it, too short to detect motion.

    Attributes
    ----------
    frames : int
        How many there are.
    least : int
        How many are needed.
    """

    def __init__(self, frames: int, least: int) -> None:
        super().__init__(f"{frames} frames are too few: at least {least} are needed")
        self.frames = frames
        self.least = least


class NoHoopError(VideoError):
    """A video in which the hoop is not to be seen in enough frames.

    Attributes
    ----------
    frames : int
        How many frames were searched.
    found : int
        In how many of them the hoop was found.
    """

    def __init__(self, frames: int, found: int, least: int, reason: str) -> None:
        super().__init__(
            f"the hoop was found in {found} of {frames} frames, {least} are needed: {reason}"
        )
        self.frames = frames
        self.found = found


class NoMarkerError(VideoError):
    """A video in which the marker is not to be seen in enough of the frames with a hoop.

    Attributes
    ----------
    frames : int
        In how many frames the hoop was found.
    found : int
        In how many of them the marker was.
    """

    def __init__(self, frames: int, found: int, marker: str | tuple[int, int, int]) -> None:
        super().__init__(
            f"the marker was found in {found} of {frames} frames with a hoop, half of them are needed: "
            f"is it {marker}, and at the distance from the centre that was given?"
        )
        self.frames = frames
        self.found = found
