"""Errors of videos."""

from __future__ import annotations

__all__ = [
    "NoHoopError",
    "NoMarkerError",
    "NoPictureError",
    "TooFewFramesError",
    "UnreadableVideoError",
    "UnwritableVideoError",
    "VideoError",
    "VideoFileError",
    "VideoWarning",
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


class NoPictureError(UnreadableVideoError):
    """A video of which OpenCV gives one picture for all frames, as of an interlaced one.

    Attributes
    ----------
    frames : int
        How many frames were looked at.
    """

    def __init__(self, path: str, frames: int) -> None:
        super().__init__(
            path,
            f"OpenCV gives the same picture for all of the {frames} frames that were looked at: it "
            "cannot decode interlaced video, or nothing moves. If it is interlaced, convert it: "
            "ffmpeg -i FILE -vf bwdif converted.mp4",
        )
        self.frames = frames


class UnwritableVideoError(VideoFileError):
    """A file that cannot be written.

    An unknown ending, a codec that this OpenCV does not have, or a missing folder.
    """


class VideoWarning(UserWarning):
    """Times of a video that are odd.

    Lost frames, uneven times, two rates that contradict each other.
    """


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
            f"the marker was found in {found} of {frames} frames with a hoop, half of them are "
            f"needed: "
            f"is it {marker}, and at the distance from the centre that was given?"
        )
        self.frames = frames
        self.found = found
