"""How the hoop falls in the flights of a track: whether its clock is right."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from statistics import NormalDist

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .._internal.extras import require
from ..hoop import Hoop
from .noise import EFFICIENCY, LEAST_ERROR, error_of_frames
from .track import Track

__all__ = ["Fall", "fall_of", "never_flies"]


# A clock is called wrong where good tracks are by chance once in so many.
_GOOD_TRACKS = 10_000
# By which part lengths may be wrong, and the distance of the mass centre from the middle, each a
# standard deviation: the scale of a film is known to a per cent, masses and offset to two.
_SCALE, _MASS_CENTRE = 0.01, 0.02
# A hoop is in the air where it is higher than errors of the plane and of its frames, R.
_HIGH = 0.03
# How far a floor may seem to be from its place, R: beyond, the lowest frames are no contact.
_FLOOR = 0.1
# Each landing is two unknowns more, height and speed of the next flight: that is its price, after
# Akaike. A flight that ends in the air, because frames are wrong, is not that cheap.
_LANDING = 2.0
_BROKEN = 28.0
_FEWEST = 4
_TURNS = 8
# A variance that changes by less, as a part, remains.
_SAME = 0.02


@dataclass(frozen=True, kw_only=True)
class Fall:
    """How the mass centre falls between contacts.

    Attributes
    ----------
    gravity : float
        Its acceleration over that of free fall.
    std_error : float
        Standard error of that, for lengths that are right.
    is_wrong : bool
        Whether it is not that of free fall, by more than errors of frames, lengths and masses
        explain in one of 10,000 good tracks.
    """

    gravity: float
    std_error: float
    is_wrong: bool

    @property
    def clock(self) -> float:
        """By how much the true times are longer than those of the track, over these."""
        return math.sqrt(self.gravity) - 1.0

    @property
    def clock_error(self) -> float:
        """Standard error of `clock`."""
        return 0.5 * self.std_error / math.sqrt(self.gravity)

    @property
    def noticed(self) -> float:
        """By how much a clock is off that is called wrong in 95 % of such tracks.

        The acceleration is as the square of times, and lengths have an error of their own.
        """
        normal = NormalDist()
        beyond = normal.inv_cdf(1.0 - 0.5 / _GOOD_TRACKS) + normal.inv_cdf(0.95)
        return 0.5 * beyond * math.hypot(self.std_error / self.gravity, _SCALE)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Frames:
    """Frames in the air, one run of them after the other.

    Attributes
    ----------
    time, height, arm, weight : ndarray
        Times; heights of the mass centre; by how much they grow with its distance from the middle,
        over this; inverse variances.
    begins : ndarray
        Whether a run of frames in the air begins with a frame.
    lands : ndarray
        Whether there may be a contact between a frame and the one before it.
    floor : float
        Height of the middle in contact.
    known : float
        Degrees of freedom of the variances.
    """

    time: Reals
    height: Reals
    arm: Reals
    weight: Reals
    begins: npt.NDArray[np.bool_]
    lands: npt.NDArray[np.bool_]
    floor: float
    known: float


@dataclass(frozen=True, kw_only=True)
class _Fit:
    """Flights that have been fitted with parabolas of one acceleration.

    Attributes
    ----------
    gravity, std_error : float
        The acceleration, and its error for errors of frames of size 1.
    squares : float
        Sum of squares over variances, with what is known beforehand.
    price : float
        That of the landings.
    left : int
        Frames less unknowns.
    """

    gravity: float
    std_error: float
    squares: float
    price: float
    left: int

    @property
    def cost(self) -> float:
        return self.squares + self.price


def fall_of(track: Track, hoop: Hoop) -> Fall | None:
    """Return how a hoop falls in the flights of a track; None where these do not tell.

    Flights are parts of the track above the floor. Each is a parabola of the mass centre or, where
    the hoop is low enough to land between two frames, several. All have one acceleration, which is
    compared with that of free fall by the F test of one against all others: with the flights that
    fit each best, with lengths known to 1 % and the mass centre to 2 %.
    """
    frames = _in_the_air(track, hoop)
    if frames is None:
        return None
    fall = math.cos(hoop.slope)
    # Where the floor seems elsewhere, the scale is wrong, or the radius: a body then falls with
    # anything between.
    right = [1.0, frames.floor] if abs(frames.floor - 1.0) < _FLOOR else [1.0]
    for _ in range(_TURNS):
        cuts = [_flights(frames, None), *(_flights(frames, one * fall) for one in right)]
        best = min((_settled(frames, one, fall) for one in cuts), key=lambda one: one.cost)
        if best.left < 1 or not best.gravity > 0.0:
            return None
        variance, left = _variance(best, frames.known)
        variance = max(variance, float(np.max(frames.weight)) * LEAST_ERROR**2)
        # The price of a landing is for errors of size 1.
        if abs(variance - 1.0) < _SAME:
            break
        frames = replace(frames, weight=frames.weight / variance)
    cuts.append(_flights(frames, best.gravity * fall))
    held = min(
        _fitted(frames, cut, fall, near=one).cost
        for cut in cuts
        for one in (*right, min(max(best.gravity, min(right)), max(right)))
    )
    fdtri = require("scipy.special").fdtri
    limit = variance * float(fdtri(1.0, left, 1.0 - 1.0 / _GOOD_TRACKS))
    return Fall(
        gravity=best.gravity,
        std_error=best.std_error * math.sqrt(variance),
        is_wrong=bool(held - best.cost > limit),
    )


def never_flies(track: Track, hoop: Hoop) -> bool:
    """Whether a track shows that the hoop is never above the plane, but for errors of frames."""
    plane = _in_the_plane(track, hoop)
    if plane is None or plane.time.size < _FEWEST:
        return False
    return not np.any(plane.y > plane.floor + plane.chance)


def _variance(best: _Fit, known: float) -> tuple[float, float]:
    """Return the variance of frames over what is thought of it, and its degrees of freedom.

    It is that of the flights and that of the differences from frame to frame together. That of the
    flights alone counts where it is larger at 0.5 %, and where it is so much smaller that the
    differences must be those of a fast motion: else a short flight that is straight by chance would
    be trusted.
    """
    fdtri = require("scipy.special").fdtri
    own, left = best.squares / best.left, float(best.left)
    if not fdtri(left, known, 1.0 / _GOOD_TRACKS) < own < fdtri(left, known, 0.995):
        return own, left
    return (best.squares + known) / (left + known), left + known


@dataclass(frozen=True, kw_only=True, eq=False)
class _InPlane:
    """A track in the axes of the plane, where both its angle and its height were seen.

    Attributes
    ----------
    time, theta, y : ndarray
        Times, angles, heights of the middle.
    sigma : float
        Standard deviation of a height from frame to frame.
    chance : float
        So far above the floor is, by chance, half a frame of all if none is in the air.
    floor : float
        Height in contact.
    """

    time: Reals
    theta: Reals
    y: Reals
    sigma: float
    chance: float
    floor: float


def _in_the_plane(track: Track, hoop: Hoop) -> _InPlane | None:
    theta, y = track.theta, track.y
    if theta is None or y is None:
        return None
    if track.level and hoop.slope != 0.0:
        if track.x is None:
            return None
        theta = theta - hoop.slope
        y = y * math.cos(hoop.slope) - track.x * math.sin(hoop.slope)
    seen = np.isfinite(theta) & np.isfinite(y)
    time, theta, y = track.time[seen], theta[seen], y[seen]
    if time.size < _FEWEST:
        return None
    sigma = error_of_frames(y)
    chance = NormalDist().inv_cdf(1.0 - 0.5 / time.size) * sigma
    floor = float(np.median(y[y <= np.sort(y)[2] + 2.0 * chance]))
    return _InPlane(time=time, theta=theta, y=y, sigma=sigma, chance=chance, floor=floor)


def _in_the_air(track: Track, hoop: Hoop) -> _Frames | None:
    """Return the frames in which a hoop is above the plane."""
    plane = _in_the_plane(track, hoop)
    if plane is None:
        return None
    time, theta, y, floor = plane.time, plane.theta, plane.y, plane.floor
    high = y > floor + max(_HIGH, plane.chance)
    if not high.any():
        return None
    speed = np.diff(y) / np.diff(time)
    # A hoop comes down from one frame and goes up to the next as fast as anywhere in the track, or
    # twice as fast: between two frames it turns and falls faster than on their mean.
    reach = 2.0 * (float(np.max(np.abs(speed))) * np.diff(time) + plane.chance)
    lands = np.concatenate([[True], y[:-1] + y[1:] - 2.0 * floor <= reach])
    begins = high & ~np.concatenate([[False], high[:-1]])
    variance = plane.sigma**2 + np.square(hoop.h * np.sin(theta) * error_of_frames(theta))
    return _Frames(
        time=time[high],
        height=(y + hoop.h * np.cos(theta))[high],
        arm=hoop.h * np.cos(theta)[high],
        weight=1.0 / variance[high],
        begins=begins[high],
        lands=lands[high],
        floor=floor,
        known=EFFICIENCY * time.size,
    )


def _flights(frames: _Frames, gravity: float | None) -> list[slice]:
    """Divide the frames into flights so that the squares and the prices of landings are least.

    Without an acceleration each flight has its own.
    """
    edges = [*np.flatnonzero(frames.begins), frames.time.size]
    found = []
    for first, last in itertools.pairwise(edges):
        squares = _squares_of_flights(frames, slice(first, last), gravity)
        price = np.where(frames.lands[first:last], _LANDING, _BROKEN)
        price[0] = 0.0
        count = last - first
        least, before = np.zeros(count + 1), np.zeros(count + 1, dtype=np.intp)
        for end in range(1, count + 1):
            costs = least[:end] + price[:end] + squares[:end, end - 1]
            before[end] = int(np.argmin(costs))
            least[end] = costs[before[end]]
        end, flights = count, []
        while end > 0:
            flights.append(slice(first + int(before[end]), first + end))
            end = int(before[end])
        found += flights[::-1]
    return found


def _squares_of_flights(frames: _Frames, run: slice, gravity: float | None) -> Reals:
    """Return the sum of squares of a flight from each frame of a run to each other."""
    time = frames.time[run] - frames.time[run].mean()
    height, weight = frames.height[run] - frames.height[run].mean(), frames.weight[run]
    powers = 3
    if gravity is not None:
        height, powers = height + 0.5 * gravity * np.square(time), 2
    time = time / max(float(np.max(np.abs(time))), 1e-9)

    def sums(values: Reals) -> Reals:
        """Sums from each frame to each other one."""
        total = np.concatenate([[0.0], np.cumsum(weight * values)])
        return np.asarray(total[None, 1:] - total[:-1, None])

    moments = [sums(time**k) for k in range(2 * powers - 1)]
    normal = np.stack([np.stack(moments[k : k + powers], axis=-1) for k in range(powers)], axis=-2)
    right = np.stack([sums(height * time**k) for k in range(powers)], axis=-1)
    first, last = np.indices(normal.shape[:2])
    # So many frames as unknowns, or fewer, are on a parabola.
    tells = last - first >= powers
    found = np.zeros(tells.shape)
    solved = np.linalg.solve(normal[tells], right[tells][..., None])[..., 0]
    explained = np.sum(solved * right[tells], axis=-1)
    found[tells] = np.maximum(sums(np.square(height))[tells] - explained, 0.0)
    return found


def _settled(frames: _Frames, flights: list[slice], fall: float) -> _Fit:
    """Return the fit in which acceleration and flights belong to each other."""
    best = _fitted(frames, flights, fall)
    for _ in range(_TURNS):
        if not best.gravity > 0.0:
            break
        found = _fitted(frames, _flights(frames, best.gravity * fall), fall)
        if found.cost >= best.cost:
            break
        best = found
    return best


def _fitted(
    frames: _Frames, flights: Sequence[slice], fall: float, near: float | None = None
) -> _Fit:
    """Fit flights with one acceleration, which is free, or near a value but for the scale."""
    heights: list[Reals] = []
    drops: list[Reals] = []
    arms: list[Reals] = []
    for one in flights:
        time, weight = frames.time[one], np.sqrt(frames.weight[one])
        time = time - time.mean()
        # What is left beside a straight line: height and speed of a flight are anything.
        lines, _ = np.linalg.qr(np.column_stack([weight, weight * time]))
        drop = 0.5 * fall * np.square(time)
        for found, values in (
            (heights, frames.height[one]),
            (drops, drop),
            (arms, frames.arm[one]),
        ):
            rows = weight * values
            found.append(rows - lines @ (lines.T @ rows))
    starts = [one.start for one in flights]
    price = np.where(frames.lands[starts], _LANDING, _BROKEN)[~frames.begins[starts]]
    # Unknowns: the acceleration, and by which part the mass centre is further from the middle.
    columns = np.column_stack([-np.concatenate(drops), -np.concatenate(arms)])
    surely = 0.0 if near is None else 1.0 / (_SCALE * near)
    matrix = np.vstack([columns, np.diag([surely, 1.0 / _MASS_CENTRE])])
    right = np.concatenate([*heights, [surely * (near or 0.0), 0.0]])
    normal = matrix.T @ matrix
    if not normal[0, 0] > 0.0:
        return _Fit(gravity=math.nan, std_error=math.inf, squares=0.0, price=0.0, left=0)
    inverse = np.linalg.inv(normal)
    unknowns = inverse @ (matrix.T @ right)
    rest = right - matrix @ unknowns
    return _Fit(
        gravity=float(unknowns[0]),
        std_error=math.sqrt(float(inverse[0, 0])),
        squares=float(rest @ rest),
        price=float(price.sum()),
        left=sum(max(0, one.stop - one.start - 2) for one in flights) - 1,
    )
