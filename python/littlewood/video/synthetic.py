"""Videos of simulated motions, as a camera would have taken them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from ..trajectory import Trajectory
from .camera import Camera
from .files import Frame, FrameWriter
from .plane import Plane

__all__ = ["Look", "synthetic_frames", "synthetic_video"]

RATE = 120.0
"""Frames per second of a video, unless another rate is asked for."""

EXPOSURE_S = 1 / 500
"""How long its frames are exposed, s."""

_Pixels = npt.NDArray[np.float32]

_GAMMA = 2.2
# Depth of the floor behind the plane of the motion, up to a wall, m.
_WALL_M = 0.6
# Displacement between two instants of an exposure that are averaged, pixels, and the most of them
# between transitions; the most transitions of an exposure, of which those that follow upon each
# other without end are ever smaller.
_STEP_PX = 0.7
_MOST_INSTANTS = 48
_MOST_TRANSITIONS = 16


@dataclass(frozen=True)
class Look:
    """The scene. Colours are red, green, blue, 0 to 255.

    Parameters
    ----------
    hoop, marker, wall, floor : tuple of int, optional
        Colours of the hoop, of the marker at the particle, of the wall behind and of the floor.
    rim : float, optional
        Width of the rim over the radius; 1 is a disc.
    marker_radius : float, optional
        Radius of the marker over that of the hoop. Parts outside the rim are cut off.
    texture : float, optional
        How uneven wall and floor are, grey levels.
    shadow : float, optional
        How much of the light the shadow on the floor takes, 0 to 1.
    noise : float, optional
        Standard deviation of the noise of a pixel, grey levels.
    """

    hoop: tuple[int, int, int] = (38, 48, 66)
    marker: tuple[int, int, int] = (225, 45, 35)
    wall: tuple[int, int, int] = (205, 203, 196)
    floor: tuple[int, int, int] = (150, 140, 128)
    rim: float = 0.09
    marker_radius: float = 0.09
    texture: float = 6.0
    shadow: float = 0.4
    noise: float = 3.0


def _light(colour: tuple[int, int, int]) -> _Pixels:
    """Return a colour as light, blue, green, red."""
    return np.asarray((np.array(colour[::-1]) / 255.0) ** _GAMMA, dtype=np.float32)


class _Scene:
    """The frame without the hoop, and where its pixels are on the plane and on the floor."""

    def __init__(self, camera: Camera, look: Look, random: np.random.Generator) -> None:
        self.plane = Plane.from_camera(camera)
        v, u = np.mgrid[0 : camera.height, 0 : camera.width]
        x, y = self.plane.to_metres(u, v)
        self.x, self.y = x.astype(np.float32), y.astype(np.float32)
        height, depth = camera.position_m[1], camera.position_m[2]
        # The line of sight of a pixel meets the floor after `reach` times its way to the plane of
        # the motion.
        with np.errstate(divide="ignore"):
            reach = np.where(height > y, height / (height - y), np.inf)
            self.floor_z = (depth * (1.0 - reach)).astype(np.float32)
            self.floor_x = (camera.position_m[0] + reach * (x - camera.position_m[0])).astype(
                np.float32
            )
        self.is_floor = self.floor_z > -_WALL_M
        self.background = self._background(camera, look, random)
        self.levels = _levels(self.background)
        # A pool that is larger than a frame: noise is a part of it, at a place by chance.
        self.noise = random.normal(
            0.0, look.noise, (camera.height + 64, camera.width + 64, 3)
        ).astype(np.float32)

    def _background(self, camera: Camera, look: Look, random: np.random.Generator) -> _Pixels:
        colours = np.where(
            self.is_floor[:, :, None], np.array(look.floor[::-1]), np.array(look.wall[::-1])
        )
        grain = np.zeros((camera.height, camera.width))
        for cells in (6, 24, 96):
            rows = np.linspace(0.0, cells - 1.001, camera.height)
            columns = np.linspace(0.0, cells - 1.001, camera.width)
            (i, a), (j, b) = (np.divmod(rows, 1.0)), (np.divmod(columns, 1.0))
            values = random.normal(0.0, look.texture / math.sqrt(3.0), (cells, cells))
            i, j, a = i.astype(int), j.astype(int), a[:, None]
            above = values[i][:, j] * (1 - b) + values[i][:, j + 1] * b
            below = values[i + 1][:, j] * (1 - b) + values[i + 1][:, j + 1] * b
            grain += above * (1 - a) + below * a
        levels = np.clip(colours + grain[:, :, None], 0.0, 255.0)
        return np.asarray((levels / 255.0) ** _GAMMA, dtype=np.float32)


def synthetic_frames(
    motion: Trajectory,
    camera: Camera,
    *,
    fps: float = RATE,
    exposure_s: float = EXPOSURE_S,
    seconds: float | None = None,
    look: Look | None = None,
    seed: int = 0,
) -> Iterator[Frame]:
    """Yield the frames that a camera takes of a motion, with perspective, motion blur and noise.

    The light of the hoop is averaged over the exposure, at instants less than a pixel apart, and
    turned into levels by a gamma of 2.2. Frame number k is exposed from k/`fps` on, for
    `exposure_s`.

    Parameters
    ----------
    motion : Trajectory
        The motion, of a hoop with units; x = 0 is that of the plane.
    camera : Camera
        The camera.
    fps : float, optional
        Rate at which frames are taken.
    exposure_s : float, optional
        How long each is exposed, s; not longer than the time between two of them.
    seconds : float, optional
        Duration, s. To the end of the motion by default; 2 s for one without end.
    look : Look, optional
        Colours, noise.
    seed : int, optional
        The same seed makes the same video.

    Yields
    ------
    ndarray
        Rows, columns, and blue, green, red.

    Raises
    ------
    ValueError
        If the hoop has no units, or the exposure is no part of the time between two frames.
    """
    units = motion.hoop.require_units()
    if not (fps > 0.0 and math.isfinite(fps)):
        raise ValueError(f"fps = {fps} must be positive")
    if not 0.0 < exposure_s * fps <= 1.0 + 1e-9:
        raise ValueError(
            f"exposure_s = {exposure_s} must be positive and at most {1.0 / fps:.6g} s"
        )
    look = Look() if look is None else look
    random = np.random.default_rng(seed)
    scene = _Scene(camera, look, random)
    last = motion.end_time * units.time_s - exposure_s
    end = (
        min(last, 2.0 if not math.isfinite(last) else last)
        if seconds is None
        else min(seconds, last)
    )
    for k in range(max(0, math.floor(end * fps + 1e-9)) + 1):
        yield _frame(scene, motion, look, k / fps, exposure_s, random)


def _frame(
    scene: _Scene,
    motion: Trajectory,
    look: Look,
    begin: float,
    exposure: float,
    random: np.random.Generator,
) -> Frame:
    units = motion.hoop.require_units()
    radius = units.length_m
    ends = motion(np.array([begin, begin + exposure]) / units.time_s)
    middle_x, middle_y = float(ends.x.mean()) * radius, float(ends.centre_y.mean()) * radius
    scale = scene.plane.pixels_per_metre(middle_x, middle_y)
    instants, weights, way = _instants(
        motion, float(ends.time[0]), float(ends.time[1]), radius * scale
    )
    samples = motion(instants)
    rim, marker, here = _coverage(
        scene, samples, weights, motion.hoop.offset, radius, look, scale, way / scale
    )
    light = scene.background.copy()
    near = _shade(scene, light, middle_x, middle_y - radius, radius, look.shadow)
    # The marker hides the rim: `rim` is what is seen of it.
    light[here] += rim[:, None] * (_light(look.hoop) - light[here]) + marker[:, None] * (
        _light(look.marker) - light[here]
    )
    # Levels of what is not changed are known.
    levels = scene.levels.copy()
    for changed in (near, here):
        levels[changed] = _levels(light[changed])
    i, j = random.integers(0, 64, 2)
    levels += scene.noise[i : i + levels.shape[0], j : j + levels.shape[1]]
    return np.clip(np.rint(levels), 0, 255).astype(np.uint8)


def _instants(
    motion: Trajectory, begin: float, end: float, scale: float
) -> tuple[Reals, Reals, float]:
    """Return instants of an exposure, √(R/g), their weights, and a way.

    The way is that of a point of the rim, pixels.

    The instants are those of Gauss between one transition and the next: the mean over them is that
    of the motion, which steps of equal length miss by a hundredth of a pixel at an impact.
    """
    jumps = [one.time for one in motion.transitions if begin < one.time < end]
    cuts = np.array([begin, *jumps[:_MOST_TRANSITIONS], end])
    at_cuts = motion(cuts)
    ways = scale * sum(
        np.abs(np.diff(values)) for values in (at_cuts.x, at_cuts.centre_y, at_cuts.theta)
    )
    instants, weights = [], []
    for first, last, way in zip(cuts, cuts[1:], ways, strict=False):
        # Two at least: one would miss how the motion bends.
        nodes, shares = np.polynomial.legendre.leggauss(
            min(2 + int(way / _STEP_PX), _MOST_INSTANTS)
        )
        instants.append(first + 0.5 * (last - first) * (1.0 + nodes))
        weights.append(0.5 * (last - first) / (end - begin) * shares)
    return np.concatenate(instants), np.concatenate(weights), float(np.sum(ways))


def _levels(light: _Pixels) -> _Pixels:
    """Return light as grey levels."""
    return np.asarray(
        255.0 * np.power(np.clip(light, 0.0, 1.0), np.float32(1.0 / _GAMMA)), dtype=np.float32
    )


def _coverage(
    scene: _Scene,
    samples: Any,
    weights: Reals,
    offset: float,
    radius: float,
    look: Look,
    scale: float,
    way: float,
) -> tuple[_Pixels, _Pixels, tuple[Any, ...]]:
    """Return how much of a pixel rim and marker cover on the average.

    With it come the pixels that they touch.
    """
    x = np.asarray(samples.x * radius, dtype=np.float32)
    y = np.asarray(samples.centre_y * radius, dtype=np.float32)
    inner, spot = (1.0 - look.rim) * radius, look.marker_radius * radius
    distance = np.hypot(scene.x - weights @ x, scene.y - weights @ y)
    border = way + 2.0 / scale
    lowest = min(inner, offset * radius - spot) - border
    here = np.nonzero((distance > lowest) & (distance < radius + border))
    at_x, at_y = scene.x[here], scene.y[here]
    rim = np.zeros(at_x.size, dtype=np.float32)
    marker = np.zeros(at_x.size, dtype=np.float32)
    for k in range(x.size):
        to_rim = np.hypot(at_x - x[k], at_y - y[k])
        spot_x = x[k] - np.float32(math.sin(samples.theta[k]) * offset * radius)
        spot_y = y[k] + np.float32(math.cos(samples.theta[k]) * offset * radius)
        inside = _clip((radius - to_rim) * scale)
        covered = _clip((spot - np.hypot(at_x - spot_x, at_y - spot_y)) * scale) * inside
        share = np.float32(weights[k])
        rim += (
            share
            * (inside - (_clip((inner - to_rim) * scale) if inner > 0.0 else 0.0))
            * (1.0 - covered)
        )
        marker += share * covered
    return rim, marker, here


def _clip(signed: Any) -> _Pixels:
    """Return the part of a pixel behind an edge at a signed distance, pixels."""
    return np.asarray(np.clip(signed + 0.5, 0.0, 1.0), dtype=np.float32)


def _shade(
    scene: _Scene, light: _Pixels, x: float, gap: float, radius: float, shadow: float
) -> tuple[npt.NDArray[Any], ...]:
    """Darken the floor below the hoop; return the pixels in which it is."""
    near = np.nonzero(
        scene.is_floor
        & (np.abs(scene.floor_x - x) < 2.0 * radius)
        & (np.abs(scene.floor_z) < 0.9 * radius)
    )
    square = ((scene.floor_x[near] - x) / (0.6 * radius)) ** 2 + (
        scene.floor_z[near] / (0.25 * radius)
    ) ** 2
    light[near] *= (1.0 - shadow * math.exp(-gap / radius) * np.exp(-square))[:, None]
    return near


def synthetic_video(
    path: str | Path,
    motion: Trajectory,
    camera: Camera,
    *,
    fps: float = RATE,
    exposure_s: float = EXPOSURE_S,
    seconds: float | None = None,
    look: Look | None = None,
    seed: int = 0,
) -> Plane:
    """Write a video of a motion as a camera would take it.

    Arguments are those of :func:`synthetic_frames`.

    Parameters
    ----------
    path : str or Path
        The file, `.avi` (Motion JPEG) or `.mp4` (MPEG-4, which loses more).
    motion, camera, fps, exposure_s, seconds, look, seed : optional
        As those of :func:`synthetic_frames`.

    Returns
    -------
    Plane
        The plane of the motion in the video.

    Raises
    ------
    ValueError
        As :func:`synthetic_frames`.
    UnwritableVideoError
        If OpenCV cannot write the file.
    """
    require("cv2")
    with FrameWriter(path, (camera.width, camera.height)) as writer:
        for frame in synthetic_frames(
            motion,
            camera,
            fps=fps,
            exposure_s=exposure_s,
            seconds=seconds,
            look=look,
            seed=seed,
        ):
            writer.write(frame)
    return Plane.from_camera(camera)
