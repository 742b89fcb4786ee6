"""The hoop and its marker in one picture."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from ..extras import require
from .files import Picture
from .plane import Plane

__all__ = ["MARKERS", "Circle", "Finder", "Marker"]

_Reals = npt.NDArray[np.float64]

MARKERS = {
    "red": (255, 0, 0),
    "orange": (255, 128, 0),
    "yellow": (255, 255, 0),
    "green": (0, 255, 0),
    "blue": (0, 0, 255),
    "magenta": (255, 0, 255),
}
"""Colours of markers by name: red, green, blue."""

_RAYS = 360
# Part of the radius on both sides of the rim in which its edge is sought, at first and around a circle that was fitted.
_WINDOW, _NARROW = 0.25, 0.12
# A radius that differs by more from the measured one is that of something else.
_RADIUS_TOLERANCE = 0.08
# Least part of the rim that has to be seen, and a distance over the radius: an edge farther off is another's.
_LEAST_RIM = 0.5
_OUTLIER = 0.02
# How many standard deviations of the noise are something.
_SIGNAL = 6.0
# Least part of the largest signal that belongs to the marker: its blurred ends count.
_FLOOR = 0.1
# What levels are of light.
_GAMMA = 2.2


@dataclass(frozen=True)
class Circle:
    """A rim that was found.

    Attributes
    ----------
    x_m, y_m : float
        Its centre, m.
    radius_m : float
        Its radius, m.
    error_m : float
        Standard error of a coordinate of the centre, from the scatter of the edge about the circle, m.
    seen : float
        Part of the rim that was seen, 0 to 1.
    """

    x_m: float
    y_m: float
    radius_m: float
    error_m: float
    seen: float


@dataclass(frozen=True)
class Marker:
    """A marker that was found.

    Attributes
    ----------
    x_m, y_m : float
        Its middle, m.
    error_m : float
        Standard error of a coordinate, m.
    """

    x_m: float
    y_m: float
    error_m: float


class Finder:
    """Finds a rim of known radius before a background that stands still, and a marker by its colour.

    The edge of the rim is sought along rays of the plane of the motion, so that a circle is fitted to a circle and not
    to the ellipse of the picture.

    Parameters
    ----------
    plane : Plane
        The plane of the motion.
    background : ndarray
        The picture without the hoop.
    noise : float
        Standard deviation of the noise of a pixel, grey levels.
    radius_m : float
        Radius of the rim, m.
    marker_m : float
        Distance of the marker from the centre, m.
    colour : tuple of int
        Colour of the marker, red, green, blue.
    """

    def __init__(
        self,
        plane: Plane,
        background: npt.NDArray[Any],
        noise: float,
        radius_m: float,
        marker_m: float,
        colour: tuple[int, int, int],
    ) -> None:
        self._plane = plane
        self._background = background.astype(np.float32)
        self._noise = noise
        self._radius = radius_m
        self._marker = marker_m
        hue = np.array(colour[::-1], dtype=np.float64)
        hue -= hue.mean()
        if np.linalg.norm(hue) < 1.0:
            raise ValueError(f"marker = {colour} is grey: a marker needs a colour")
        self._hue = (hue / np.linalg.norm(hue)).astype(np.float32)

    def difference(self, picture: Picture) -> npt.NDArray[np.float32]:
        """Return by how much a picture differs from the background, grey levels, smoothed over a pixel."""
        distance = np.sqrt(np.square(picture.astype(np.float32) - self._background).sum(axis=2) / np.float32(3.0))
        return np.asarray(require("cv2").GaussianBlur(distance, (0, 0), 0.8), dtype=np.float32)

    def circle(self, picture: Picture) -> Circle | None:
        """Find the rim; None where there is none, or less than a half of it."""
        difference = self.difference(picture)
        guess = self._guess(difference)
        if guess is None:
            return None
        found = (*guess, self._radius)
        for window in (_WINDOW, _NARROW, _NARROW):
            x, y = self._edge(difference, found, window)
            if x.size < _LEAST_RIM * _RAYS:
                return None
            circle, scatter, kept = _fit_circle(x, y, found, self._radius)
            found = circle
        if abs(found[2] / self._radius - 1.0) > _RADIUS_TOLERANCE or kept.sum() < _LEAST_RIM * _RAYS:
            return None
        # Neighbouring rays share pixels: there are no more independent edges than pixels along the rim.
        independent = min(float(kept.sum()), math.tau * self._radius * self._plane.pixels_per_metre(found[0], found[1]))
        return Circle(*found, scatter * math.sqrt(2.0 / independent), float(kept.sum()) / _RAYS)

    def _guess(self, difference: npt.NDArray[np.float32]) -> tuple[float, float] | None:
        """Find where a circle of the known radius has most of the outlines of what differs from the background."""
        cv2 = require("cv2")
        level = max(_SIGNAL * self._noise, 0.25 * float(np.percentile(difference, 99.9)))
        mask = (difference > level).astype(np.uint8)
        mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
        outlines, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        outlines = [one[:, 0, :] for one in outlines if len(one) >= 8]
        if not outlines:
            return None
        pixels = np.concatenate(outlines).astype(np.float64)
        x, y = self._plane.to_metres(pixels[:, 0], pixels[:, 1])
        if x.size < 20:
            return None
        # Two points and the radius make two circles. The draws are the same for every picture.
        random = np.random.default_rng(0)
        some = random.integers(0, x.size, 400)
        i, j = random.integers(0, x.size, (2, 300))
        half_x, half_y = 0.5 * (x[j] - x[i]), 0.5 * (y[j] - y[i])
        half = np.hypot(half_x, half_y)
        usable = (half > 0.3 * self._radius) & (half < 0.98 * self._radius)
        if not np.any(usable):
            return None
        i, half_x, half_y, half = i[usable], half_x[usable], half_y[usable], half[usable]
        height = np.sqrt(self._radius**2 - half**2) / half
        centre_x = np.concatenate([x[i] + half_x - height * half_y, x[i] + half_x + height * half_y])
        centre_y = np.concatenate([y[i] + half_y + height * half_x, y[i] + half_y - height * half_x])
        distance = np.hypot(x[some] - centre_x[:, None], y[some] - centre_y[:, None])
        votes = np.sum(np.abs(distance / self._radius - 1.0) < 0.04, axis=1)
        best = int(np.argmax(votes))
        if votes[best] < 0.2 * some.size:
            return None
        return float(centre_x[best]), float(centre_y[best])

    def _edge(
        self, difference: npt.NDArray[np.float32], circle: tuple[float, float, float], window: float
    ) -> tuple[_Reals, _Reals]:
        """Return where rays from the centre leave the rim: the outermost half of the largest difference near it."""
        x, y, radius = circle
        pixels = radius * self._plane.pixels_per_metre(x, y)
        count = max(24, math.ceil(8.0 * window * pixels))
        distances = np.linspace((1.0 - window) * radius, (1.0 + window) * radius, count)
        angles = math.tau * (np.arange(_RAYS) + 0.5) / _RAYS
        at_x = x + np.outer(np.cos(angles), distances)
        at_y = y + np.outer(np.sin(angles), distances)
        u, v = self._plane.to_pixels(at_x, at_y)
        cv2 = require("cv2")
        seen = cv2.remap(
            difference, u.astype(np.float32), v.astype(np.float32), cv2.INTER_LINEAR, borderValue=(-1.0, 0.0, 0.0, 0.0)
        )
        largest = seen.max(axis=1)
        above = seen > 0.5 * largest[:, None]
        last = count - 1 - np.argmax(above[:, ::-1], axis=1)
        usable = (largest > _SIGNAL * self._noise) & (last < count - 1) & (seen.min(axis=1) >= 0.0)
        rows, last = np.flatnonzero(usable), last[usable]
        here, beyond = seen[rows, last], seen[rows, last + 1]
        part = (here - 0.5 * largest[rows]) / (here - beyond)
        distance = distances[last] + part * (distances[1] - distances[0])
        return x + distance * np.cos(angles[rows]), y + distance * np.sin(angles[rows])

    def marker(self, picture: Picture, circle: Circle) -> Marker | None:
        """Find the marker on a hoop that was found; None where its colour is not to be seen."""
        reach = 1.3 * self._radius
        u, v = self._plane.to_pixels(
            circle.x_m + reach * np.array([-1.0, 1.0, -1.0, 1.0]), circle.y_m + reach * np.array([-1.0, -1.0, 1.0, 1.0])
        )
        height, width = picture.shape[:2]
        left, right = max(0, math.floor(u.min())), min(width, math.ceil(u.max()) + 1)
        top, bottom = max(0, math.floor(v.min())), min(height, math.ceil(v.max()) + 1)
        if right - left < 4 or bottom - top < 4:
            return None
        rows, columns = np.mgrid[top:bottom, left:right]
        x, y = self._plane.to_metres(columns, rows)
        on_ring = np.abs(np.hypot(x - circle.x_m, y - circle.y_m) - self._marker) < 0.22 * self._radius
        cut = picture[top:bottom, left:right].astype(np.float32)
        # As light and not as levels, in which the parts of a blurred marker do not add up.
        score = 255.0 * (cut / np.float32(255.0)) ** np.float32(_GAMMA) @ self._hue
        score -= np.median(score[on_ring]) if np.any(on_ring) else 0.0
        cv2 = require("cv2")
        smooth = np.where(on_ring, cv2.GaussianBlur(score, (0, 0), 1.0), 0.0)
        largest = float(smooth.max())
        if largest < _SIGNAL * self._noise:
            return None
        least = max(_FLOOR * largest, 2.0 * self._noise)
        count, labels = cv2.connectedComponents((smooth > least).astype(np.uint8))
        sums = np.bincount(labels.ravel(), weights=smooth.ravel(), minlength=count)
        sums[0] = 0.0
        spot = labels == int(np.argmax(sums))
        weights = np.where(spot, smooth, 0.0)
        total = float(weights.sum())
        mean_x, mean_y = float((weights * x).sum()) / total, float((weights * y).sum()) / total
        spread = float((((x - mean_x) ** 2 + (y - mean_y) ** 2) * spot).sum()) / 2.0
        return Marker(mean_x, mean_y, self._noise * math.sqrt(spread) / total)


def _fit_circle(
    x: _Reals, y: _Reals, guess: tuple[float, float, float], scale: float
) -> tuple[tuple[float, float, float], float, npt.NDArray[np.bool_]]:
    """Fit a circle by distances, with Tukey's weights: circle, scatter of the edge, and which points belong to it."""
    a, b, radius = guess
    width = 4.0 * _OUTLIER * scale
    for _ in range(30):
        distance = np.hypot(x - a, y - b)
        residual = distance - radius
        ratio = np.minimum(np.abs(residual) / width, 1.0)
        root = 1.0 - ratio**2
        matrix = np.column_stack([(x - a) / distance, (y - b) / distance, np.ones_like(x)]) * root[:, None]
        step, *_ = np.linalg.lstsq(matrix, residual * root, rcond=None)
        a, b, radius = a + step[0], b + step[1], radius + step[2]
        typical = 1.4826 * float(np.median(np.abs(residual)))
        width = min(width, max(4.7 * typical, 1e-4 * scale))
        if float(np.abs(step).max()) < 1e-9 * scale:
            break
    residual = np.hypot(x - a, y - b) - radius
    kept = np.abs(residual) < width
    scatter = float(np.sqrt(np.mean(residual[kept] ** 2))) if kept.any() else math.inf
    return (float(a), float(b), float(radius)), scatter, kept
