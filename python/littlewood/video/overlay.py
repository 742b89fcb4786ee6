"""Video and simulation together."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np

from ..extras import require
from ..fit_result import FitResult
from ..style import MODE_COLOURS
from ..trajectory import Trajectory
from .files import Frame, FrameWriter, frames
from .plane import Plane

__all__ = ["draw_motion", "overlay_video"]


def _colour(mode: str) -> tuple[int, int, int]:
    """Return the colour of a mode of motion as OpenCV takes it."""
    text = MODE_COLOURS[mode].lstrip("#")
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
    units = motion.hoop.require_units()
    drawn = frame.copy()
    sample: Any = motion(np.array([time]))
    if bool(sample.is_outside[0]) or time < motion.start.time:
        return drawn
    x, y, theta = (float(values[0]) for values in (sample.x, sample.centre_y, sample.theta))
    mode = str(sample.mode_names[0])
    angles = np.linspace(0.0, math.tau, 181)
    r = units.length_m

    def points(at_x: Any, at_y: Any) -> Any:
        u, v = plane.to_pixels(np.asarray(at_x) * r, np.asarray(at_y) * r)
        # Sixteenths of a pixel.
        return np.rint(16.0 * np.column_stack([u, v])).astype(np.int32).reshape(-1, 1, 2)

    offset = motion.hoop.offset
    particle = (x - offset * math.sin(theta), y + offset * math.cos(theta))
    style = {"lineType": cv2.LINE_AA, "shift": 4}
    colour = _colour(mode)
    cv2.polylines(drawn, [points(x + np.cos(angles), y + np.sin(angles))], False, colour, 2, **style)
    cv2.polylines(drawn, [points([x, particle[0]], [y, particle[1]])], False, colour, 2, **style)
    small = 0.06 * np.array([np.cos(angles), np.sin(angles)])
    cv2.polylines(drawn, [points(particle[0] + small[0], particle[1] + small[1])], False, colour, 2, **style)
    seconds = (time - motion.start.time) * units.time_s
    size = frame.shape[0] / 540.0
    at = (round(16 * size), round(32 * size))
    for ink, width in (((255, 255, 255), 4), ((20, 20, 20), 1)):
        words = f"{seconds:.3f} s  {mode}"
        cv2.putText(
            drawn, words, at, cv2.FONT_HERSHEY_SIMPLEX, 0.7 * size, ink, max(1, round(width * size)), cv2.LINE_AA
        )
    return drawn


def overlay_video(
    video: str | Path,
    fitted: FitResult | Trajectory,
    out: str | Path,
    *,
    plane: Plane,
    fps: float,
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
    fps : float
        Rate at which the frames were taken.

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
    count, writer = 0, None
    try:
        for frame in frames(video):
            if writer is None:
                writer = FrameWriter(out, (frame.shape[1], frame.shape[0]))
            writer.write(draw_motion(frame, motion, plane, count / fps / time_s))
            count += 1
    finally:
        if writer is not None:
            writer.close()
    return count
