"""Video and simulation together."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from .._internal.extras import require
from ..fitting.result import FitResult
from ..fitting.track import Track
from ..style import ACCENTS, MODE_COLOURS
from ..trajectory import Trajectory
from .clock import clock_of
from .errors import UnreadableVideoError
from .files import Frame, FrameWriter, frames
from .plane import Plane
from .tracking import frames_all_over, median_and_noise

__all__ = ["draw_motion", "overlay_picture", "overlay_video"]


def _colour(text: str) -> tuple[int, int, int]:
    """Return a colour as OpenCV takes it."""
    text = text.lstrip("#")
    return int(text[4:6], 16), int(text[2:4], 16), int(text[0:2], 16)


def draw_motion(frame: Frame, motion: Trajectory, plane: Plane, time: float) -> Frame:
    """Return a frame with the simulated hoop drawn over it, in the colour of its mode of motion.

    Parameters
    ----------
    frame : ndarray
        The frame.
    motion : Trajectory
        The motion, of a hoop with units.
    plane : Plane
        The plane of the motion in a frame.
    time : float
        Time τ, √(R/g).

    Returns
    -------
    ndarray
        A copy; without a hoop before the start and after the end of the motion.
    """
    cv2 = require("cv2")
    drawn = frame.copy()
    mode = _draw_hoop(drawn, motion, plane, time)
    if mode is None:
        return drawn
    seconds = (time - motion.start.time) * motion.hoop.require_units().time_s
    size = frame.shape[0] / 540.0
    at = (round(16 * size), round(32 * size))
    for ink, width in (((255, 255, 255), 4), ((20, 20, 20), 1)):
        words = f"{seconds:.3f} s  {mode}"
        cv2.putText(
            drawn,
            words,
            at,
            cv2.FONT_HERSHEY_SIMPLEX,
            0.7 * size,
            ink,
            max(1, round(width * size)),
            cv2.LINE_AA,
        )
    return drawn


def _points(plane: Plane, x: Any, y: Any) -> Any:
    """Return points of the plane, m, as OpenCV draws them: in sixteenths of a pixel."""
    u, v = plane.to_pixels(x, y)
    return np.rint(16.0 * np.column_stack([u, v])).astype(np.int32).reshape(-1, 1, 2)


def _draw_hoop(drawn: Frame, motion: Trajectory, plane: Plane, time: float) -> str | None:
    """Draw the simulated hoop into a frame, and return its mode of motion.

    None outside of the motion.
    """
    cv2 = require("cv2")
    r = motion.hoop.require_units().length_m
    sample: Any = motion(np.array([time]))
    if bool(sample.is_outside[0]) or time < motion.start.time:
        return None
    x, y, theta = (float(values[0]) for values in (sample.x, sample.centre_y, sample.theta))
    mode = str(sample.mode_names[0])
    angles = np.linspace(0.0, math.tau, 181)
    offset = motion.hoop.offset
    particle = (x - offset * math.sin(theta), y + offset * math.cos(theta))
    small = 0.06 * np.array([np.cos(angles), np.sin(angles)])
    for at_x, at_y in (
        (x + np.cos(angles), y + np.sin(angles)),
        (np.array([x, particle[0]]), np.array([y, particle[1]])),
        (particle[0] + small[0], particle[1] + small[1]),
    ):
        line = _points(plane, at_x * r, at_y * r)
        cv2.polylines(
            drawn, [line], False, _colour(MODE_COLOURS[mode]), 2, lineType=cv2.LINE_AA, shift=4
        )
    return mode


def overlay_picture(
    video: str | Path,
    fitted: FitResult | Trajectory,
    *,
    plane: Plane,
    fps: float | None = None,
    track: Track | None = None,
    count: int = 5,
) -> Frame:
    """Return several instants of a video in one picture, with the simulated hoop over each.

    Parameters
    ----------
    video : str or Path
        The video.
    fitted : FitResult or Trajectory
        The motion; its time counts from the first frame of the video.
    plane : Plane
        The plane of the motion in a frame, whose floor is drawn, too.
    fps : float, optional
        Rate at which the frames were taken, as in :func:`littlewood.track_video`.
    track : Track, optional
        What was found: the centres and the markers of all frames are dots.
    count : int, optional
        How many instants, evenly spread over the motion.

    Returns
    -------
    ndarray
        Rows, columns, and blue, green, red.

    Raises
    ------
    UnreadableVideoError
        If the video is missing or cannot be decoded.
    """
    cv2 = require("cv2")
    motion = fitted.motion if isinstance(fitted, FitResult) else fitted
    r, time_s = motion.hoop.require_units().length_m, motion.hoop.require_units().time_s
    clock = clock_of(video)
    # A millionth of an interval is rounding.
    first, end = motion.start.time * time_s, motion.shown_until * time_s
    if track is not None:
        end = min(end, float(track.time[-1]) * time_s)
    times = clock.seconds(fps)
    early = 1e-6 / clock.require_rate(fps)
    begin = int(np.searchsorted(times, first - early))
    # The last frame before each instant.
    instants = np.linspace(first, end - early, count)[1:]
    numbers = sorted({begin, *(np.searchsorted(times, instants, "right") - 1).tolist()})
    some = list(frames(video, numbers))
    if not some:
        raise UnreadableVideoError(str(video), "it has no frame of the motion")
    still, _ = median_and_noise(frames_all_over(video, 0, None, clock))
    picture, farthest = still, np.zeros(still.shape[:2])
    for frame in some:
        # What differs most from the background is a hoop.
        apart = np.abs(frame - still).sum(axis=2)
        picture = np.where((apart > farthest)[:, :, None], frame, picture)
        farthest = np.maximum(apart, farthest)
    drawn = np.ascontiguousarray(picture, dtype=np.uint8)
    for number in numbers:
        if 0 <= number < times.size:
            _draw_hoop(drawn, motion, plane, times[number] / time_s)
    style = {"lineType": cv2.LINE_AA, "shift": 4}
    x, _ = plane.to_metres([0.0, drawn.shape[1] - 1.0], plane.to_pixels([0.0, 0.0], [0.0, 0.0])[1])
    cv2.polylines(
        drawn, [_points(plane, x, np.zeros(2))], False, _colour(ACCENTS["violet"]), 1, **style
    )
    if track is not None and track.x is not None:
        y = np.ones_like(track.x) if track.y is None else track.y
        dots = [(track.x, y)]
        if track.theta is not None:
            offset = motion.hoop.offset
            dots.append((track.x - offset * np.sin(track.theta), y + offset * np.cos(track.theta)))
        for at_x, at_y in dots:
            seen = np.isfinite(at_x) & np.isfinite(at_y)
            for point in _points(plane, at_x[seen] * r, at_y[seen] * r)[:, 0]:
                cv2.circle(
                    drawn,
                    tuple(int(value) for value in point),
                    20,
                    _colour(ACCENTS["violet"]),
                    -1,
                    **style,
                )
    return drawn


def overlay_video(
    video: str | Path,
    fitted: FitResult | Trajectory,
    out: str | Path,
    *,
    plane: Plane,
    fps: float | None = None,
) -> int:
    """Write a video with the simulated hoop drawn over the filmed one.

    Parameters
    ----------
    video : str or Path
        The video.
    fitted : FitResult or Trajectory
        The motion; its time counts from the first frame of the video, as that of a track does.
    out : str or Path
        The new file: `.mp4` (MPEG-4) or `.avi` (Motion JPEG).
    plane : Plane
        The plane of the motion in a frame.
    fps : float, optional
        Rate at which the frames were taken, as in :func:`littlewood.track_video`.

    Returns
    -------
    int
        Number of frames.

    Raises
    ------
    UnreadableVideoError
        If the video is missing or cannot be decoded.
    UnwritableVideoError
        If `out` cannot be written.
    """
    motion = fitted.motion if isinstance(fitted, FitResult) else fitted
    time_s = motion.hoop.require_units().time_s
    times = clock_of(video).seconds(fps)
    count, writer = 0, None
    try:
        for frame, time in zip(frames(video), times, strict=False):
            if writer is None:
                writer = FrameWriter(out, (frame.shape[1], frame.shape[0]))
            writer.write(draw_motion(frame, motion, plane, time / time_s))
            count += 1
    finally:
        if writer is not None:
            writer.close()
    return count
