"""The track of a hoop in a video."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.extras import progress_bar
from ..fitting.calibration import CALIBRATION
from ..fitting.track import Track
from ..hoop import Hoop
from .clock import Clock, clock_of
from .errors import (
    NoHoopError,
    NoMarkerError,
    NoPictureError,
    TooFewFramesError,
    VideoWarning,
)
from .files import Frame, frames
from .finder import MARKERS, Finder
from .plane import Plane

__all__ = [
    "LEAST_PICTURES",
    "colour_of",
    "finder_of",
    "frames_all_over",
    "median_and_noise",
    "track_video",
]

LEAST_PICTURES = 10
# Least part of the frames with a hoop in which the marker has to be seen.
_LEAST_MARKED = 0.5
# By which factor the light of a marker may differ from the usual one.
_OTHER_LIGHT = 4.0
# Frames of which the background is the median, and in which the shape of the rim is measured.
_SPREAD = 41


def track_video(
    path: str | Path,
    hoop: Hoop,
    *,
    plane: Plane,
    fps: float | None = None,
    marker: str | tuple[int, int, int] = "red",
    marker_offset: float | None = None,
    marker_angle: float = 0.0,
    first: int = 0,
    last: int | None = None,
    background: npt.ArrayLike | None = None,
    exposure_s: float | None = None,
    progress: bool = False,
) -> Track:
    """Find the hoop and its marker in every frame of a video.

    The camera must stand still. The rim is the outermost edge of what differs from the background;
    a circle is fitted to it in the plane of the motion, so that the perspective is corrected. The
    marker is what has its colour near the rim. Each frame is searched for itself, and nothing is
    smoothed.

    Parameters
    ----------
    path : str or Path
        The video, in any format that OpenCV decodes.
    hoop : Hoop
        The hoop, made by :meth:`Hoop.from_si`: its radius is taken, and its offset for the place of
        the marker.
    plane : Plane
        Where the frame shows the plane of the motion.
    fps : float, optional
        Rate at which the frames were taken. In slow motion it is not the rate at which the file is
        played. By default what the file says of it (`com.android.capture.fps`); if it says nothing
        it is required.
    marker : str or tuple of int, optional
        Colour of the marker: red, orange, yellow, green, blue, magenta, or red, green, blue from 0
        to 255.
    marker_offset : float, optional
        Distance of the marker from the centre, R; the offset of the particle by default.
    marker_angle : float, optional
        Angle from the particle to the marker, counterclockwise, rad; π for a marker opposite to the
        particle.
    first, last : int, optional
        First frame that is used, and the one after the last. The time counts from the first frame
        of the video.
    background : array_like, optional
        A frame without the hoop. By default the median of up to 41 frames, for which the hoop has
        to move by more than its width.
    exposure_s : float, optional
        How long a frame was exposed, s. By default it is not known, and the fit estimates it.
    progress : bool, optional
        Whether to show a progress bar (tqdm).

    Returns
    -------
    Track
        Dimensionless, with the standard errors of every frame, NaN where hoop or marker were not
        found, and with constant errors of the camera for a fit to estimate. Its `notes` say what
        was taken for the times.

    Raises
    ------
    ValueError
        If the hoop has no units, a rate, a colour or a range of frames makes no sense, or nobody
        says the rate.
    UnreadableVideoError
        If the file is missing or cannot be decoded; as :class:`~littlewood.video.NoPictureError` if
        all frames are the same, as those of an interlaced video are to OpenCV.
    TooFewFramesError
        If there are fewer than ten frames.
    NoHoopError
        If the hoop is found in fewer than ten.
    NoMarkerError
        If the marker is found in fewer than half of the frames in which the hoop is.

    Warns
    -----
    littlewood.video.VideoWarning
        If frames are lost or not evenly spaced, or if the file says another rate than `fps`.

    Notes
    -----
    The time of a frame is that which the file has for it, times the rate at which the file is
    played over `fps`: that of the beginning of its exposure. What was found is the mean over
    it.
    """
    units = hoop.require_units()
    if first < 0 or (last is not None and last <= first):
        raise ValueError(f"empty frame range: {first} to {last}")
    colour_of(marker)
    clock = clock_of(path)
    rate = clock.require_rate(fps)
    if exposure_s is not None and not 0.0 <= exposure_s * rate <= 1.0 + 1e-9:
        raise ValueError(f"exposure_s = {exposure_s} must be from 0 to {1.0 / rate:.6g} s")
    finder = finder_of(
        path,
        hoop,
        plane=plane,
        marker=marker,
        marker_offset=marker_offset,
        first=first,
        last=last,
        background=background,
        clock=clock,
    )
    doubts = clock.doubts(fps)
    for doubt in doubts:
        warnings.warn(doubt, VideoWarning, stacklevel=2)
    numbers = range(first, clock.time_s.size if last is None else min(last, clock.time_s.size))
    rows = []
    with progress_bar(len(numbers), "frames", progress) as show:
        for number, frame in zip(numbers, frames(path, numbers), strict=False):
            rows.append((number, *_in_frame(finder, frame)))
            show(len(rows))
    found = np.array(rows)
    _without_others(found)
    theta = np.mod(found[:, 3] - marker_angle + math.pi, math.tau) - math.pi
    count = int(np.isfinite(found[:, 1]).sum())
    if count < LEAST_PICTURES:
        reason = "is its radius right, does it move, and does it differ from the background?"
        raise NoHoopError(len(rows), count, LEAST_PICTURES, reason)
    marked = int(np.isfinite(theta).sum())
    if marked < _LEAST_MARKED * count:
        raise NoMarkerError(count, marked, marker)
    length = units.length_m
    return Track(
        clock.seconds(rate)[found[:, 0].astype(int)] / units.time_s,
        theta=theta,
        x=found[:, 1] / length,
        y=found[:, 2] / length,
        errors={"theta": found[:, 5], "x": found[:, 4] / length, "y": found[:, 4] / length},
        exposure=0.0 if exposure_s is None else exposure_s / units.time_s,
        calibration=tuple(name for name in CALIBRATION if name != "exposure" or exposure_s is None),
        notes=(*clock.facts(fps), *doubts),
    )


def _without_others(found: npt.NDArray[np.float64]) -> None:
    """Forget the markers with far more or far less light than is usual.

    Something else has their colour.
    """
    light = found[:, 6]
    seen = np.isfinite(light)
    if seen.any():
        ratio = light / float(np.median(light[seen]))
        other = seen & ~((ratio > 1.0 / _OTHER_LIGHT) & (ratio < _OTHER_LIGHT))
        found[other, 3] = found[other, 5] = math.nan


def _in_frame(finder: Finder, frame: Frame) -> tuple[float, float, float, float, float, float]:
    """Return x, y, θ of the marker, the errors of a coordinate and of θ, and its light.

    NaN for what is not found.
    """
    circle = finder.circle(frame)
    if circle is None:
        return (math.nan,) * 6
    marker = finder.marker(frame, circle)
    if marker is None:
        return circle.x_m, circle.y_m, math.nan, circle.error_m, math.nan, math.nan
    x, y = marker.x_m - circle.x_m, marker.y_m - circle.y_m
    error = math.hypot(marker.error_m, circle.error_m) / math.hypot(x, y)
    return circle.x_m, circle.y_m, math.atan2(-x, y), circle.error_m, error, marker.light


def finder_of(
    path: str | Path,
    hoop: Hoop,
    *,
    plane: Plane,
    marker: str | tuple[int, int, int] = "red",
    marker_offset: float | None = None,
    first: int = 0,
    last: int | None = None,
    background: npt.ArrayLike | None = None,
    clock: Clock | None = None,
) -> Finder:
    """Return the finder of the hoop in single frames.

    Its arguments are those of :func:`littlewood.track_video`.

    `clock` is that of the video, where it is known.

    Returns
    -------
    Finder
    """
    colour = colour_of(marker)
    some = frames_all_over(path, first, last, clock)
    still, noise = median_and_noise(some)
    if background is not None:
        given = np.asarray(background)
        if given.shape != still.shape:
            raise ValueError(f"the background has shape {given.shape}, a frame {still.shape}")
        still = given
    radius = hoop.require_units().length_m
    offset = hoop.offset if marker_offset is None else marker_offset
    finder = Finder(plane, still, noise, radius, offset * radius, colour)
    return finder.rounded(some)


def colour_of(marker: str | tuple[int, int, int]) -> tuple[int, int, int]:
    """Return the colour of a marker: red, green, blue."""
    if not isinstance(marker, str):
        return marker
    if marker not in MARKERS:
        raise ValueError(
            f"marker = {marker!r} must be one of {', '.join(MARKERS)}, or three numbers"
        )
    return MARKERS[marker]


def frames_all_over(
    path: str | Path, first: int, last: int | None, clock: Clock | None = None
) -> list[Frame]:
    """Return frames all over a video; refuse one whose frames are all the same."""
    # Counted, because files often state it wrongly.
    count = (clock or clock_of(path)).time_s.size
    end = count if last is None else min(count, last)
    if end - first < LEAST_PICTURES:
        raise TooFewFramesError(max(0, end - first), LEAST_PICTURES)
    wanted = set(np.linspace(first, end - 1, _SPREAD).round().astype(int).tolist())
    found = list(frames(path, wanted))
    if all(np.array_equal(frame, found[0]) for frame in found[1:]):
        raise NoPictureError(str(path), len(found))
    return found


def median_and_noise(some: list[Frame]) -> tuple[npt.NDArray[Any], float]:
    """Return the median of frames, and the standard deviation of the noise of a pixel."""
    kept = np.stack(some)
    still = np.median(kept, axis=0)
    distance = np.abs(kept[:: max(1, len(kept) // 5)] - still)
    # Of normal errors half are within 0.6745 standard deviations; rounding to whole levels leaves
    # 0.3 at least.
    noise = max(0.3, float(np.mean(distance)) * 1.2533)
    return still, noise
