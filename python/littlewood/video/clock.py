"""When the frames of a video were taken: by the times and the rates that its file has."""

from __future__ import annotations

import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from .._internal.elementwise import Reals, real
from .._internal.extras import require
from .capture_rate import CAPTURE_RATE, capture_rate
from .errors import UnreadableVideoError
from .files import open_video

__all__ = ["Clock", "clock_of", "rate_of"]

# Files keep times in whole ticks: of a GIF of 10 ms, of Matroska and WebM of 1 ms.
_GRAINS_S = (0.01, 0.001)
_ROUNDING_S = 1e-6
# From which part of an interval on its error is said.
_UNEVEN = 0.1
# A film that was taken at about the rate at which it is played is no slow motion: cameras take
# fewer frames in the dark. Slow motion is slower by a whole factor, to the error of the rates.
_REAL_TIME = 1.5
_SAME_RATE = 0.02


@dataclass(frozen=True, eq=False)
class Clock:
    """The times of the frames of a video.

    Attributes
    ----------
    time_s : ndarray
        When the file shows each frame, from the first on, s.
    rate : float
        Frames a second at which it is played; lost frames are not counted.
    captured : float or None
        Frames a second at which it was taken, where the file says it: `com.android.capture.fps`.
    lost : int
        How many frames are missing.
    gaps : int
        At how many places they are.
    is_even : bool
        Whether the others are evenly spaced.
    """

    time_s: Reals
    rate: float
    captured: float | None
    lost: int
    gaps: int
    is_even: bool

    @property
    def taken(self) -> float | None:
        """Frames a second at which they were taken, as far as the file says it."""
        if self.captured is None:
            return None
        slower = self.captured / self.rate
        if 1.0 / _REAL_TIME < slower < _REAL_TIME:
            return self.rate
        whole = round(slower)
        if whole > 1 and abs(slower / whole - 1.0) < _SAME_RATE:
            return whole * self.rate
        return self.captured

    def require_rate(self, fps: float | None) -> float:
        """Return the rate at which the frames were taken: what was said, else what the file says.

        Raises
        ------
        ValueError
            If nobody says it.
        """
        if fps is None:
            fps = self.taken
        if fps is None:
            raise ValueError(
                f"fps is missing: the video is played at {self.rate:.6g} frames a second, and its "
                f"file "
                "does not say at which rate they were taken; in slow motion they are more"
            )
        fps = real(fps, "fps")
        if not (fps > 0.0 and math.isfinite(fps)):
            raise ValueError(f"fps = {fps} must be positive")
        return fps

    def seconds(self, fps: float | None = None) -> Reals:
        """Return when the frames were taken, from the first on, s.

        `fps` as that of :func:`littlewood.track_video`.
        """
        return self.time_s * (self.rate / self.require_rate(fps))

    def facts(self, fps: float | None = None) -> list[str]:
        """Return what was taken for the times, as sentences."""
        rate = self.require_rate(fps)
        who = "as was said" if fps is not None else f"as the file says ({CAPTURE_RATE})"
        return [
            f"The film has {self.time_s.size} frames, played at {self.rate:.4g} a second "
            f"and taken at {rate:.4g}, {who}."
        ]

    def doubts(self, fps: float | None = None) -> list[str]:
        """Return what is odd about the times, as sentences."""
        rate = self.require_rate(fps)
        said = []
        if fps is not None and self.taken is not None:
            if abs(rate / self.taken - 1.0) > _SAME_RATE:
                said.append(
                    f"The file says that the film was taken at {self.taken:.4g} frames a second "
                    f"({CAPTURE_RATE}), {rate:g} were given: those count."
                )
        steps = np.diff(self.seconds(rate)) if self.time_s.size > 1 else np.zeros(1)
        if self.lost:
            said.append(
                f"The film has {self.gaps} {'gap' if self.gaps == 1 else 'gaps'}, in which "
                f"{self.lost} {'frame is' if self.lost == 1 else 'frames are'} lost; the largest "
                f"takes "
                f"{steps.max():.3g} s. Times are those of the file."
            )
        if not self.is_even:
            said.append(
                f"The frames of the film are not evenly spaced: {steps.min():.3g} to "
                f"{steps.max():.3g} s. Times are those of the file."
            )
        return said


def clock_of(path: str | Path) -> Clock:
    """Return the times of the frames of a video, by its file.

    Parameters
    ----------
    path : str or Path
        The video, in any format that OpenCV decodes.

    Returns
    -------
    Clock

    Raises
    ------
    UnreadableVideoError
        If there is no such file, OpenCV cannot decode it, it has no frames, or times that do not
        grow.
    """
    cv2 = require("cv2")
    capture = open_video(path)
    stamps = []
    try:
        stated = float(capture.get(cv2.CAP_PROP_FPS))
        # The time after each frame is that of the file; asking for a time is not exact.
        while capture.grab():
            stamps.append(capture.get(cv2.CAP_PROP_POS_MSEC))
    finally:
        capture.release()
    if not stamps:
        raise UnreadableVideoError(str(path), "it has no frames")
    time_s = (np.array(stamps) - stamps[0]) / 1000.0
    captured = capture_rate(path)
    if not time_s.any():
        # A stream without times, or a single frame.
        rate = stated if stated > 0.0 and math.isfinite(stated) else 1.0
        return Clock(np.arange(time_s.size) / rate, rate, captured, 0, 0, True)
    falls = np.flatnonzero(~(np.diff(time_s) > 0.0))
    if falls.size:
        i = int(falls[0])
        raise UnreadableVideoError(
            str(path),
            f"frame {i + 1} is at {time_s[i + 1]:.6g} s, that before at {time_s[i]:.6g} s: times "
            f"must "
            "grow; convert it: ffmpeg -i FILE converted.mp4",
        )
    step, counts, grain = _regular(time_s)
    apart = np.abs(np.diff(time_s) - step * counts)
    gaps = counts > 1
    return Clock(
        time_s,
        1.0 / step,
        captured,
        int((counts - 1).sum()),
        int(gaps.sum()),
        bool(np.all(apart <= np.maximum(_UNEVEN * step, 1.5 * grain))),
    )


def rate_of(path: str | Path) -> float:
    """Return the frames per second at which a file is played, by the times of its frames.

    Slow motion is played slower than it was taken: see :class:`littlewood.video.Clock`.
    """
    return clock_of(path).rate


def _regular(time_s: Reals) -> tuple[float, Reals, float]:
    """Return the usual interval, how many there are between frames, and the tick.

    The tick is that of the file.
    """
    steps = np.diff(time_s)
    grain = next(
        (
            grain
            for grain in _GRAINS_S
            if np.all(np.abs(time_s - grain * np.rint(time_s / grain)) < _ROUNDING_S)
        ),
        0.0,
    )
    # Ticks and lost frames: the mean interval counts frames right where few are lost, the median
    # one where intervals are whole ticks or differ little.
    for usual in (float(np.mean(steps)), float(np.median(steps))):
        counts = np.maximum(1.0, np.rint(steps / usual))
        step = float(time_s[-1] / counts.sum())
        error = np.max(np.abs(time_s[1:] - step * np.cumsum(counts)))
        if error <= grain + _ROUNDING_S:
            return step, counts, grain
    # Frames without a regular clock: the median is what most of them have.
    return usual, counts, grain
