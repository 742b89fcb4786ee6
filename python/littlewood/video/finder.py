"""The hoop and its marker in one frame."""

from __future__ import annotations

import copy
import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from .files import Frame
from .plane import Plane

__all__ = ["MARKERS", "Circle", "Finder", "Marker"]


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
# Part of the radius on both sides of the rim in which its edge is sought, at first and around a
# circle that was fitted.
_WINDOW, _NARROW = 0.25, 0.12
# Part of the radius on both sides of its middle in which a rim is that is blurred as far as it may
# be; how far beside a blurred edge the size of pixels still shows, pixels.
_REACH, _FOOT_PX = 0.2, 0.8
# Angle from straight down, rad, within which the shadow on the floor moves what is seen of the rim;
# rays that are left out beside those on which the marker is; least part of the rays that has to be
# left.
_SHADOW = math.radians(55.0)
_BESIDE_MARKER = 4
_LEAST_RAYS = 0.3
# How far from a circle a rim may seem to be, radii; how much more a radius away; how well a frame
# tells it.
_OVAL, _OVAL_SLOPE, _OVAL_ERROR = 0.02, 0.005, 0.001
# A share of the rim that is none.
_NOTHING = 1e-6
# What stands for "outside of the frame" among shares of light, which are about 0 to 1.
_OUTSIDE = -1e3
# A radius that differs by more from the measured one is that of something else.
_RADIUS_TOLERANCE = 0.08
# Least part of the rim that has to be seen, and a distance over the radius: an edge farther off is
# another's.
_LEAST_RIM = 0.5
_OUTLIER = 0.02
# How many standard deviations of the noise are something.
_SIGNAL = 6.0
# Least part of the largest signal that belongs to the marker: its blurred ends count.
_FLOOR = 0.1
# Least part of the colour of a marker that the background there does not have.
_APART = 0.2
# What levels are of light.
_GAMMA = 2.2
_LIGHT = ((np.arange(256) / 255.0) ** _GAMMA).astype(np.float32)
_ANGLES = math.tau * (np.arange(_RAYS) + 0.5) / _RAYS


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
        Standard error of a coordinate of the centre, from the scatter of the edge about the circle,
        m.
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
    light : float
        How much light of its colour there is, over all pixels: the same however it is blurred.
    """

    x_m: float
    y_m: float
    error_m: float
    light: float


class Finder:
    """Finds a rim of known radius, and a marker by its colour.

    The background stands still.

    The edge of the rim is sought along rays of the plane of the motion, so that a circle is fitted
    to a circle and not to the ellipse of the frame.

    Parameters
    ----------
    plane : Plane
        The plane of the motion.
    background : ndarray
        The frame without the hoop.
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
        self._levels = np.clip(np.rint(background), 0, 255).astype(np.uint8)
        self._background = np.asarray((background / 255.0) ** _GAMMA, dtype=np.float32)
        self._noise = noise
        self._oval = np.zeros((3, 2))
        self._radius = radius_m
        self._marker = marker_m
        hue = np.array(colour[::-1], dtype=np.float64)
        hue -= hue.mean()
        if np.linalg.norm(hue) < 1.0:
            raise ValueError(f"marker = {colour} is grey: a marker needs a colour")
        self._hue = (hue / np.linalg.norm(hue)).astype(np.float32)

    def difference(self, frame: Frame) -> npt.NDArray[np.uint8]:
        """Return by how much a frame differs from the background, grey levels.

        It is smoothed over a pixel.
        """
        cv2 = require("cv2")
        apart = cv2.transform(cv2.absdiff(frame, self._levels), np.full((1, 3), 1.0 / 3.0))
        return np.asarray(cv2.GaussianBlur(apart, (0, 0), 0.8), dtype=np.uint8)

    def circle(self, frame: Frame) -> Circle | None:
        """Find the rim; None if less than half of it is seen.

        The rim is the outline of the difference from the background. Its centre is then that of the
        mean line of the rim, in light: the mean over the exposure, however the hoop moves
        meanwhile, and however bright the background is. Of a disc, which has no inner edge, it is
        that of the outer edge.
        """
        found = self._line_of(frame)
        if found is None:
            return None
        outline, seen, line = found
        circle, scatter, kept = _fit_circle(*line, outline, self._radius)
        # Neighbouring rays share pixels: there are no more independent edges than pixels along the
        # rim.
        pixels = math.tau * self._radius * self._plane.pixels_per_metre(*circle[:2])
        error = scatter * math.sqrt(2.0 / min(float(kept.sum()), pixels))
        return Circle(circle[0], circle[1], outline[2], error, seen)

    def _outline(
        self, frame: Frame
    ) -> tuple[npt.NDArray[np.uint8], tuple[float, float, float], float] | None:
        """Return what differs from the background, the circle about it, and a part.

        The part is that of the rim that is seen.
        """
        difference = self.difference(frame)
        guess = self._guess(difference)
        if guess is None:
            return None
        outline = (*guess, self._radius)
        for window in (_WINDOW, _NARROW):
            outer = self._outer_edge(_Profiles(self._plane, difference, outline, window))
            if outer[0].size < _LEAST_RIM * _RAYS:
                return None
            outline, _, kept = _fit_circle(*outer, outline, self._radius)
        if (
            abs(outline[2] / self._radius - 1.0) > _RADIUS_TOLERANCE
            or kept.sum() < _LEAST_RIM * _RAYS
        ):
            return None
        return difference, outline, float(kept.sum()) / _RAYS

    def _line_of(
        self, frame: Frame
    ) -> tuple[tuple[float, float, float], float, tuple[Reals, Reals]] | None:
        """Return the outline, which part of the rim is seen, and points of its mean line."""
        found = self._outline(frame)
        line = None if found is None else self._line(frame, found[0], found[1])
        return None if found is None or line is None else (found[1], found[2], line)

    def rim(self, frame: Frame) -> tuple[Reals, Reals, float] | None:
        """Return points of the mean line of the rim in pixels, and its outer radius over theirs.

        None if unseen.
        """
        found = self._line_of(frame)
        if found is None:
            return None
        outline, _, line = found
        circle, _, _ = _fit_circle(*line, outline, self._radius)
        return (*self._plane.to_pixels(*line), outline[2] / circle[2])

    def rounded(self, frames: Iterable[Frame]) -> Finder:
        """Return a finder that also fits the deviation of the rim from a circle.

        It is one by errors of the plane.

        A plane with a wrong perspective makes an oval of a circle, and a part of the rim that is
        hidden then moves its centre. Which oval it is depends on the place: evenly, to first order.

        Parameters
        ----------
        frames : iterable of ndarray
            Frames all over the video.
        """
        rows, ovals = [], []
        for frame in frames:
            seen = self._line_of(frame)
            if seen is not None:
                outline, _, line = seen
                rows.append(outline[:2])
                ovals.append(_oval(outline[:2], *line))
        found = copy.copy(self)
        if rows:
            places = np.column_stack([np.ones(len(rows)), np.array(rows) / self._radius])
            # As if somebody had measured it before: none, to within these.
            before = np.diag(_OVAL_ERROR / np.array([_OVAL, _OVAL_SLOPE, _OVAL_SLOPE]))
            matrix, values = (
                np.vstack([places, before]),
                np.vstack([np.array(ovals), np.zeros((3, 2))]),
            )
            for _ in range(3):
                found._oval, *_ = np.linalg.lstsq(matrix, values, rcond=None)
                off = np.abs(places @ found._oval - values[: len(rows)]).max(axis=1)
                weights = np.concatenate([off <= 4.0 * np.median(off) + 1e-12, np.ones(3)])[:, None]
                matrix, values = matrix * weights, values * weights
        return found

    def _outer_edge(self, profiles: _Profiles) -> tuple[Reals, Reals]:
        """Return where rays from the centre leave the rim.

        The outermost half of the largest value near it.
        """
        seen = profiles.values
        last = (
            seen.shape[1] - 1 - np.argmax((seen > 0.5 * profiles.largest[:, None])[:, ::-1], axis=1)
        )
        usable = (
            (profiles.largest > _SIGNAL * self._noise)
            & (last < seen.shape[1] - 1)
            & profiles.inside
        )
        rays = np.flatnonzero(usable)
        return profiles.points(rays, profiles.crossing(rays, last[usable], last[usable] + 1))

    def _line(
        self, frame: Frame, difference: npt.NDArray[np.uint8], circle: tuple[float, float, float]
    ) -> tuple[Reals, Reals] | None:
        """Return points of the mean line of the rim; None where there are too few."""
        x, y, radius = circle
        cut = self._cut(x, y, (1.0 + 1.5 * _WINDOW) * radius)
        if cut is None:
            return None
        light = _light(frame[cut])
        colour = self._colour_of_rim(light, difference, circle, cut)
        # Which part of the light of a pixel is that of the rim: 0 for the background, 1 for the
        # rim.
        contrast = colour - self._background[cut]
        square = np.sum(contrast * contrast, axis=2)
        share = np.sum((light - self._background[cut]) * contrast, axis=2)
        share /= np.maximum(square, 0.1 * float(np.median(square)) + 1e-12)
        smooth = require("cv2").GaussianBlur(share.astype(np.float32), (0, 0), 0.8)
        profiles = _Profiles(self._plane, smooth, circle, _NARROW, cut)
        usable = profiles.inside & ~self._hidden(light, circle, cut)
        below = profiles.values < 0.5 * profiles.largest[:, None]
        places, count = np.arange(below.shape[1]), below.shape[1]
        top = np.argmax(profiles.values, axis=1)[:, None]
        outer = np.where(below & (places > top), places, count).min(axis=1)
        inner = np.where(below & (places < top), places, -1).max(axis=1)
        usable &= outer < count
        rays = np.flatnonzero(usable & (inner >= 0))
        if rays.size < max(_LEAST_RAYS * _RAYS, 0.5 * usable.sum()):
            rays = np.flatnonzero(usable)
            if rays.size < _LEAST_RAYS * _RAYS:
                return None
            distances = profiles.crossing(rays, outer[rays] - 1, outer[rays])
        else:
            midway = 0.5 * profiles.crossing(rays, outer[rays] - 1, outer[rays])
            midway += 0.5 * profiles.crossing(rays, inner[rays] + 1, inner[rays])
            middle, *_ = _fit_circle(*profiles.points(rays, midway), circle, self._radius)
            profiles = _Profiles(self._plane, share, circle, _WINDOW, cut)
            rays = rays[profiles.inside[rays]]
            if rays.size < _LEAST_RAYS * _RAYS:
                return None
            distances = self._means(profiles, rays, middle)
        cosine, sine = np.array([1.0, x / self._radius, y / self._radius]) @ self._oval
        angles = 2.0 * _ANGLES[rays]
        return profiles.points(
            rays, distances / (1.0 + cosine * np.cos(angles) + sine * np.sin(angles))
        )

    def _means(
        self, profiles: _Profiles, rays: npt.NDArray[Any], circle: tuple[float, float, float]
    ) -> Reals:
        """Return the mean distances of the rim along rays.

        They are as if it had not been displaced across them.

        The share of the rim along a ray is the mean over the exposure of a rim that moves along it.
        As long as there is a point that the rim never leaves, the mean is where half of the share
        is on either side; else, with more noise, it is the first moment. A displacement q across
        the ray takes q²/2ρ off the distance of a circle of the radius ρ. Displacements along rays
        add their variance to the second moment, and those across one are those along another: what
        the second moment has of twice the angle tells the blur.
        """
        middle = profiles.distances_of(rays, circle)
        angles = 2.0 * _ANGLES[rays]
        waves = np.column_stack([np.ones_like(angles), np.cos(angles), np.sin(angles)])
        half = np.full(rays.size, _REACH * self._radius)
        foot = _FOOT_PX / self._plane.pixels_per_metre(*profiles.centre)
        for last in (False, True):
            width, mean, halves, variance = profiles.moments(rays, middle, half)
            off = np.abs(variance - np.median(variance))
            kept = off <= 6.0 * np.median(off)
            sizes, *_ = np.linalg.lstsq(waves[kept], variance[kept], rcond=None)
            along = waves[:, 1:] @ sizes[1:]
            # A motion that speeds up evenly from rest is at most √5 standard deviations from its
            # mean, an even one √3.
            rim = 0.5 * float(np.median(width))
            blur = np.sqrt(5.0 * np.maximum(along + math.hypot(*sizes[1:]), 0.0))
            if not last:
                half = np.minimum(rim + blur + foot, half)
        found: Reals = np.where(blur < rim, halves, mean) - along / (2.0 * circle[2])
        return found

    def _cut(self, x: float, y: float, reach: float) -> tuple[slice, slice] | None:
        """Return the part of a frame in which a square of the plane is."""
        u, v = self._plane.to_pixels(
            x + reach * np.array([-1.0, 1.0, -1.0, 1.0]),
            y + reach * np.array([-1.0, -1.0, 1.0, 1.0]),
        )
        height, width = self._levels.shape[:2]
        left, right = max(0, math.floor(u.min())), min(width, math.ceil(u.max()) + 1)
        top, bottom = max(0, math.floor(v.min())), min(height, math.ceil(v.max()) + 1)
        return (
            None
            if right - left < 4 or bottom - top < 4
            else (slice(top, bottom), slice(left, right))
        )

    def _colour_of_rim(
        self,
        light: npt.NDArray[np.float32],
        difference: npt.NDArray[np.uint8],
        circle: tuple[float, float, float],
        cut: tuple[slice, slice],
    ) -> npt.NDArray[np.float32]:
        """Return the light of the rim, where it differs most from the background."""
        most = _Profiles(self._plane, difference, circle, _NARROW)
        rays = np.arange(_RAYS)
        u, v = self._plane.to_pixels(
            *most.points(rays, most.distances[np.argmax(most.values, axis=1)])
        )
        # To the nearest pixel: the median of all rays needs no more.
        rows = np.clip(np.rint(v).astype(int) - cut[0].start, 0, light.shape[0] - 1)
        columns = np.clip(np.rint(u).astype(int) - cut[1].start, 0, light.shape[1] - 1)
        return np.asarray(np.median(light[rows, columns], axis=0), dtype=np.float32)

    def _hidden(
        self,
        light: npt.NDArray[np.float32],
        circle: tuple[float, float, float],
        cut: tuple[slice, slice],
    ) -> npt.NDArray[np.bool_]:
        """Return the rays on which the marker or the shadow is beside the rim."""
        hue = _Profiles(self._plane, light @ self._hue, circle, _NARROW, cut)
        excess = hue.largest - np.median(hue.largest)
        noise = _SIGNAL * self._noise * _GAMMA / 255.0
        marked = excess > max(0.15 * float(excess.max()), noise)
        for _ in range(_BESIDE_MARKER):
            marked = marked | np.roll(marked, 1) | np.roll(marked, -1)
        down = np.abs(np.mod(_ANGLES + 0.5 * math.pi + math.pi, math.tau) - math.pi)
        return np.asarray(marked | (down < _SHADOW))

    def outlines(self, difference: npt.NDArray[np.uint8]) -> tuple[Reals, Reals] | None:
        """Return the points of the outlines of what differs from the background, m."""
        cv2 = require("cv2")
        level = max(_SIGNAL * self._noise, 0.25 * float(np.percentile(difference, 99.9)))
        mask = (difference > level).astype(np.uint8)
        mask = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        long = [one[:, 0, :] for one in contours if len(one) >= 8]
        if not long:
            return None
        pixels = np.concatenate(long).astype(np.float64)
        return self._plane.to_metres(pixels[:, 0], pixels[:, 1])

    def _guess(self, difference: npt.NDArray[np.uint8]) -> tuple[float, float] | None:
        """Find where a circle of the known radius has most outlines.

        They are those of what differs from the background.
        """
        found = self.outlines(difference)
        if found is None or found[0].size < 20:
            return None
        x, y = found
        # Two points and the radius make two circles. The draws are the same for every frame.
        random = np.random.default_rng(0)
        some = random.integers(0, x.size, 200)
        i, j = random.integers(0, x.size, (2, 200))
        half_x, half_y = 0.5 * (x[j] - x[i]), 0.5 * (y[j] - y[i])
        half = np.hypot(half_x, half_y)
        usable = (half > 0.3 * self._radius) & (half < 0.98 * self._radius)
        if not np.any(usable):
            return None
        i, half_x, half_y, half = i[usable], half_x[usable], half_y[usable], half[usable]
        height = np.sqrt(self._radius**2 - half**2) / half
        centre_x = np.concatenate(
            [x[i] + half_x - height * half_y, x[i] + half_x + height * half_y]
        )
        centre_y = np.concatenate(
            [y[i] + half_y + height * half_x, y[i] + half_y - height * half_x]
        )
        distance = np.hypot(x[some] - centre_x[:, None], y[some] - centre_y[:, None])
        votes = np.sum(np.abs(distance / self._radius - 1.0) < 0.04, axis=1)
        best = int(np.argmax(votes))
        if votes[best] < 0.2 * some.size:
            return None
        return float(centre_x[best]), float(centre_y[best])

    def marker(self, frame: Frame, circle: Circle) -> Marker | None:
        """Find the marker on a hoop; None if its colour is not seen."""
        cut = self._cut(circle.x_m, circle.y_m, 1.3 * self._radius)
        if cut is None:
            return None
        rows, columns = np.mgrid[cut]
        x, y = self._plane.to_metres(columns, rows)
        on_ring = (
            np.abs(np.hypot(x - circle.x_m, y - circle.y_m) - self._marker) < 0.22 * self._radius
        )
        # As light and not as levels, in which the parts of a blurred marker do not add up.
        hue, behind = (
            255.0 * light @ self._hue for light in (_light(frame[cut]), self._background[cut])
        )
        usual = float(np.median(hue[on_ring])) if np.any(on_ring) else 0.0
        for ground in (usual, np.maximum(usual, behind)):
            score = hue - ground
            smooth = np.where(on_ring, require("cv2").GaussianBlur(score, (0, 0), 1.0), 0.0)
            spot = self._spot(smooth)
            if spot is None:
                return None
            weights = np.where(spot, smooth, 0.0)
            # What has the colour in the background, too, is no marker: only what is more of it than
            # the background.
            if float((weights * (hue - behind)).sum()) > _APART * float((weights * score).sum()):
                total = float(weights.sum())
                mean_x, mean_y = (
                    float((weights * x).sum()) / total,
                    float((weights * y).sum()) / total,
                )
                spread = float((((x - mean_x) ** 2 + (y - mean_y) ** 2) * spot).sum()) / 2.0
                return Marker(mean_x, mean_y, self._noise * math.sqrt(spread) / total, total)
        return None

    def _spot(self, smooth: npt.NDArray[Any]) -> npt.NDArray[np.bool_] | None:
        """Return the pixels of the connected spot with the largest sum; None if all is noise."""
        largest = float(smooth.max())
        if largest < _SIGNAL * self._noise:
            return None
        least = max(_FLOOR * largest, 2.0 * self._noise)
        count, labels = require("cv2").connectedComponents((smooth > least).astype(np.uint8))
        sums = np.bincount(labels.ravel(), weights=smooth.ravel(), minlength=count)
        sums[0] = 0.0
        found: npt.NDArray[np.bool_] = labels == int(np.argmax(sums))
        return found


def _light(frame: npt.NDArray[np.uint8]) -> npt.NDArray[np.float32]:
    """Return levels as light, 0 to 1."""
    return np.asarray(_LIGHT[frame])


def _oval(centre: tuple[float, float], x: Reals, y: Reals) -> Reals:
    """Return the cosine and sine of twice the angle of an oval over its radius."""
    angles, distances = (
        np.arctan2(y - centre[1], x - centre[0]),
        np.hypot(x - centre[0], y - centre[1]),
    )
    waves = [
        np.ones_like(angles),
        *(wave(k * angles) for k in (1.0, 2.0) for wave in (np.cos, np.sin)),
    ]
    matrix = np.column_stack(waves)
    kept = np.ones(angles.size, dtype=np.bool_)
    for _ in range(3):
        sizes, *_ = np.linalg.lstsq(matrix[kept], distances[kept], rcond=None)
        off = np.abs(matrix @ sizes - distances)
        kept = off <= 4.0 * np.median(off)
    return np.asarray(sizes[3:] / sizes[0])


class _Profiles:
    """Values of a frame along rays of the plane, to so many radii on both sides of a circle.

    The image has one value a pixel; `cut` says which part of the frame it is.
    """

    def __init__(
        self,
        plane: Plane,
        image: npt.NDArray[Any],
        circle: tuple[float, float, float],
        window: float,
        cut: tuple[slice, slice] = (slice(0, None), slice(0, None)),
    ) -> None:
        self.centre = circle[:2]
        radius = circle[2]
        count = max(24, math.ceil(8.0 * window * radius * plane.pixels_per_metre(*self.centre)))
        self.distances = np.linspace((1.0 - window) * radius, (1.0 + window) * radius, count)
        u, v = plane.to_pixels(
            self.centre[0] + np.outer(np.cos(_ANGLES), self.distances),
            self.centre[1] + np.outer(np.sin(_ANGLES), self.distances),
        )
        cv2 = require("cv2")
        self.values = cv2.remap(
            image.astype(np.float32),
            (u - cut[1].start).astype(np.float32),
            (v - cut[0].start).astype(np.float32),
            cv2.INTER_LINEAR,
            borderValue=(_OUTSIDE, 0.0, 0.0, 0.0),
        )
        self.largest = self.values.max(axis=1)
        # A value beside the border is a mean with what is outside of it.
        self.inside = self.values.min(axis=1) > 1e-3 * _OUTSIDE

    def crossing(
        self, rays: npt.NDArray[Any], above: npt.NDArray[Any], below: npt.NDArray[Any]
    ) -> Reals:
        """Return the distances at which rays fall to half of their largest value.

        They lie between two neighbouring places.
        """
        high, low = self.values[rays, above], self.values[rays, below]
        part = (high - 0.5 * self.largest[rays]) / (high - low)
        found: Reals = self.distances[above] + part * (
            self.distances[below] - self.distances[above]
        )
        return found

    def distances_of(self, rays: npt.NDArray[Any], circle: tuple[float, float, float]) -> Reals:
        """Return the distances at which rays from near its centre meet a circle."""
        x, y = circle[0] - self.centre[0], circle[1] - self.centre[1]
        cosine, sine = np.cos(_ANGLES[rays]), np.sin(_ANGLES[rays])
        across = y * cosine - x * sine
        found: Reals = x * cosine + y * sine + np.sqrt(np.square(circle[2]) - np.square(across))
        return found

    def moments(
        self, rays: npt.NDArray[Any], middle: Reals, half: Reals
    ) -> tuple[Reals, Reals, Reals, Reals]:
        """Return sum, mean, median and variance of distances weighted by the values.

        Those up to so far from the middle count.

        On a ray without values they are far away, and no circle takes them.
        """
        away = self.distances - middle[:, None]
        weights = np.where(np.abs(away) < half[:, None], self.values[rays], 0.0)
        total = np.maximum(weights.sum(axis=1), _NOTHING)
        mean = (weights * away).sum(axis=1) / total
        variance = (weights * np.square(away)).sum(axis=1) / total - np.square(mean)
        step = float(self.distances[1] - self.distances[0])
        # The weight of a place is in the step about it.
        beyond = np.cumsum(weights, axis=1) - 0.5 * total[:, None]
        place = np.argmax(beyond > 0.0, axis=1)[:, None]
        there, too_much = (
            np.take_along_axis(one, place, axis=1)[:, 0] for one in (weights, beyond)
        )
        median = self.distances[place[:, 0]] + (0.5 - too_much / np.maximum(there, _NOTHING)) * step
        return total * step, middle + mean, median, variance

    def points(self, rays: npt.NDArray[Any], distances: Reals) -> tuple[Reals, Reals]:
        """Return points on rays, m."""
        angles = _ANGLES[rays]
        return self.centre[0] + distances * np.cos(angles), self.centre[1] + distances * np.sin(
            angles
        )


def _fit_circle(
    x: Reals, y: Reals, guess: tuple[float, float, float], scale: float
) -> tuple[tuple[float, float, float], float, npt.NDArray[np.bool_]]:
    """Fit a circle by distances, with Tukey's weights.

    Circle, scatter of the edge, and which points belong to it.
    """
    a, b, radius = guess
    width = 4.0 * _OUTLIER * scale
    for _ in range(30):
        distance = np.hypot(x - a, y - b)
        residual = distance - radius
        ratio = np.minimum(np.abs(residual) / width, 1.0)
        root = 1.0 - ratio**2
        matrix = np.array([(x - a) / distance, (y - b) / distance, np.ones_like(x)]) * root
        step, *_ = np.linalg.lstsq(matrix @ matrix.T, matrix @ (residual * root), rcond=None)
        a, b, radius = a + step[0], b + step[1], radius + step[2]
        typical = 1.4826 * float(np.median(np.abs(residual)))
        width = min(width, max(4.7 * typical, 1e-4 * scale))
        if float(np.abs(step).max()) < 1e-7 * scale:
            break
    residual = np.hypot(x - a, y - b) - radius
    kept = np.abs(residual) < width
    scatter = float(np.sqrt(np.mean(residual[kept] ** 2))) if kept.any() else math.inf
    return (float(a), float(b), float(radius)), scatter, kept
