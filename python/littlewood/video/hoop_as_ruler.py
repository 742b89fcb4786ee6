"""The plane of the motion, from the hoop itself.

Its rim is a circle of known radius, and the floor is below it.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from .errors import NoHoopError
from .files import Frame
from .finder import Finder
from .plane import Plane
from .tracking import LEAST_PICTURES, frames_all_over, median_and_noise

__all__ = ["find_plane"]


# Circles through three points of an outline that are tried in each frame, and how far a point may
# be off, radii.
_DRAWS = 400
_NEAR = 0.04
# Least part of the rim of a circle that is believed, and the least radius, pixels.
_LEAST_SEEN = 0.5
_LEAST_PX = 8.0
# How far a plane is from that of a camera that looks at it squarely, as if somebody had measured it
# before.
_PRIOR = 0.3
# Points of a rim that are as good as any more; how far they scatter, radii.
_POINTS = 90
_SCATTER = 2e-3
# The same again from a better plane: the rims of frames at the border are found by it.
_TURNS = 2
# A centre is as high as in contact to so many radii; the shortest way that tells the direction of
# the floor, radii.
_CONTACT = 0.01
_LEAST_WAY = 0.5


def find_plane(
    path: str | Path, radius_m: float, *, first: int = 0, last: int | None = None
) -> Plane:
    """Find the plane of the motion in a video by the hoop alone, without measured points.

    The rim is a circle of one radius in every frame: the homography is that which makes circles of
    the ovals that the frames show. The floor is the line below its lowest places.

    Parameters
    ----------
    path : str or Path
        The video. The camera stands still, and about upright.
    radius_m : float
        Outer radius of the hoop, m.
    first, last : int, optional
        First frame that is used, and the one after the last.

    Returns
    -------
    Plane
        x = 0 is the place of the hoop in the first frame in which it is seen, y = 0 the floor.

    Raises
    ------
    UnreadableVideoError
        If the file is missing or cannot be decoded.
    TooFewFramesError
        If there are fewer than ten frames.
    NoHoopError
        If a rim is found in fewer than ten of those that are looked at.

    Notes
    -----
    A homography has eight numbers, of which four are those of a similarity, which radius and
    floor give. The other four (two of perspective, a stretch and a shear) minimise the
    distances of the rims from circles of one radius. Constants of the camera that remain are
    estimated by :func:`littlewood.fit`. Measured points are better where the hoop covers a
    small part of the frame.
    """
    if not (radius_m > 0.0 and math.isfinite(radius_m)):
        raise ValueError(f"radius_m = {radius_m} must be positive, m")
    some = frames_all_over(path, first, last)
    background, noise = median_and_noise(some)
    # A plane whose unit is the pixel: its only use is that outlines are found in it.
    pixels = Plane(np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]))
    search = Finder(pixels, background, noise, 1.0, 1.0, (255, 0, 0))
    circles = [_largest_circle(search, frame, number) for number, frame in enumerate(some)]
    seen = [circle for circle in circles if circle is not None]
    if len(seen) < LEAST_PICTURES:
        raise NoHoopError(
            len(some),
            len(seen),
            LEAST_PICTURES,
            "does it move before a background that stands still, whole in sight?",
        )
    size = float(np.median([radius for _, _, radius in seen]))
    plane = Plane.from_ground_line((0.0, 0.0), (size / radius_m, 0.0), 1.0)
    for _ in range(_TURNS):
        finder = Finder(plane, background, noise, radius_m, radius_m, (255, 0, 0))
        rims = [rim for rim in map(finder.rim, some) if rim is not None]
        if len(rims) < LEAST_PICTURES:
            raise NoHoopError(
                len(some),
                len(rims),
                LEAST_PICTURES,
                "its rim is not that of a circle of one radius",
            )
        plane = _rectified(plane, rims, radius_m, some[0].shape)
    return plane


def _largest_circle(search: Finder, frame: Frame, number: int) -> tuple[float, float, float] | None:
    """Return the circle about what moves, in pixels; None where there is none."""
    outlines = search.outlines(search.difference(frame))
    if outlines is None or outlines[0].size < 20:
        return None
    x, y = outlines
    # The draws are the same whenever a film is read.
    random = np.random.default_rng(number)
    i, j, k = random.integers(0, x.size, (3, _DRAWS))
    ax, ay, bx, by = x[j] - x[i], y[j] - y[i], x[k] - x[i], y[k] - y[i]
    cross = 2.0 * (ax * by - ay * bx)
    usable = np.abs(cross) > 1e-9
    ax, ay, bx, by, cross, i = (
        ax[usable],
        ay[usable],
        bx[usable],
        by[usable],
        cross[usable],
        i[usable],
    )
    a, b = ax * ax + ay * ay, bx * bx + by * by
    dx, dy = (by * a - ay * b) / cross, (ax * b - bx * a) / cross
    radius = np.hypot(dx, dy)
    usable = (radius > _LEAST_PX) & (radius < 0.5 * min(frame.shape[:2]))
    if not np.any(usable):
        return None
    centre_x, centre_y, radius = (x[i] + dx)[usable], (y[i] + dy)[usable], radius[usable]
    off = np.abs(np.hypot(x - centre_x[:, None], y - centre_y[:, None]) - radius[:, None])
    # How much of the rim is there: an arc of a larger circle has as many points, and less of the
    # circle.
    part = np.sum(off < _NEAR * radius[:, None], axis=1) / (math.tau * radius)
    best = int(np.argmax(part))
    return (
        (float(centre_x[best]), float(centre_y[best]), float(radius[best]))
        if part[best] > _LEAST_SEEN
        else None
    )


def _rectified(
    plane: Plane, rims: list[tuple[Reals, Reals, float]], radius_m: float, shape: Any
) -> Plane:
    """Return the plane in which rims are circles, with the floor below them."""
    height, width = shape[:2]
    unit = 0.5 * max(height, width)
    middle = (
        np.array([[1.0, 0.0, -0.5 * width], [0.0, -1.0, 0.5 * height], [0.0, 0.0, unit]]) / unit
    )
    points = []
    for u, v, _ in rims:
        some = np.linspace(0, u.size - 1, min(u.size, _POINTS)).round().astype(int)
        points.append(middle @ np.array([u[some], v[some], np.ones(some.size)]))
    owners = np.repeat(np.arange(len(points)), [one.shape[1] for one in points])
    stacked = np.concatenate(points, axis=1)

    def matrix(unknowns: Reals) -> Reals:
        stretch, shear, across, up = unknowns
        return np.array(
            [[1.0 + stretch, shear, 0.0], [shear, 1.0 - stretch, 0.0], [across, up, 1.0]]
        )

    def residuals(unknowns: Reals) -> Reals:
        x, y, weight = matrix(unknowns) @ stacked
        _, distances = _circles(x / weight, y / weight, owners)
        return np.concatenate(
            [(distances / np.median(distances) - 1.0) / _SCATTER, unknowns / _PRIOR]
        )

    found = require("scipy.optimize").least_squares(residuals, np.zeros(4), loss="soft_l1")
    round_ = matrix(found.x) @ middle
    x, y, weight = matrix(found.x) @ stacked
    centres, distances = _circles(x / weight, y / weight, owners)
    # Rims are mean lines: the outer edge is farther out, by the same part in all frames.
    size = float(np.median(distances)) * float(np.median([wider for _, _, wider in rims]))
    slope, below = _floor(centres / size)
    scale = radius_m / size
    cosine, sine = scale * math.cos(slope), scale * math.sin(slope)
    turned = np.array([[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]])
    first_x = float((turned @ np.array([*centres[0], 1.0]))[0])
    moved = np.array([[1.0, 0.0, -first_x], [0.0, 1.0, radius_m * (1.0 - below)], [0.0, 0.0, 1.0]])
    return Plane(np.linalg.inv(moved @ turned @ round_))


def _circles(x: Reals, y: Reals, owners: npt.NDArray[np.intp]) -> tuple[Reals, Reals]:
    """Return the centres of circles through the points of each owner, and distances.

    They are those of the points from the centres.
    """
    count = int(owners[-1]) + 1

    def means(values: Reals) -> Reals:
        return np.asarray(np.bincount(owners, values, count) / np.bincount(owners, minlength=count))

    middle_x, middle_y = means(x), means(y)
    dx, dy = x - middle_x[owners], y - middle_y[owners]
    square = dx * dx + dy * dy
    xx, xy, yy = means(dx * dx), means(dx * dy), means(dy * dy)
    zx, zy = 0.5 * means(square * dx), 0.5 * means(square * dy)
    determinant = xx * yy - xy * xy
    a, b = (zx * yy - zy * xy) / determinant, (zy * xx - zx * xy) / determinant
    distances = np.hypot(dx - a[owners], dy - b[owners])
    return np.column_stack([middle_x + a, middle_y + b]), np.asarray(distances)


def _floor(centres: Reals) -> tuple[float, float]:
    """Return the angle of the floor, and the height of centres in contact, radii.

    The height is that in axes that are turned by the angle.
    """
    best, most = (0.0, float(centres[:, 1].min())), 0
    for i in range(len(centres)):
        for j in range(len(centres)):
            way = centres[j] - centres[i]
            if way[0] < _LEAST_WAY or abs(way[1]) > way[0]:
                continue
            angle = math.atan2(way[1], way[0])
            heights = centres[:, 1] * math.cos(angle) - centres[:, 0] * math.sin(angle)
            lowest = 0.5 * (heights[i] + heights[j])
            if np.any(heights < lowest - 2.0 * _CONTACT):
                continue
            count = int(np.sum(heights < lowest + _CONTACT))
            if count > most:
                best, most = (angle, float(lowest)), count
    if most == 0:
        return best
    angle, lowest = best
    touching = centres[:, 1] * math.cos(angle) - centres[:, 0] * math.sin(angle) < lowest + _CONTACT
    rise, _ = np.polyfit(centres[touching, 0], centres[touching, 1], 1)
    angle = math.atan(float(rise))
    heights = centres[touching, 1] * math.cos(angle) - centres[touching, 0] * math.sin(angle)
    return angle, float(np.median(heights))
