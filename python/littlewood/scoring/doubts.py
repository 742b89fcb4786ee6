"""Mistakes that a record shows at its start: a sign, a unit, another point, another case."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from .._internal.elementwise import Reals
from .record import RATES, Record

if TYPE_CHECKING:
    from ..trajectory import Trajectory

__all__ = ["doubts", "start_rates"]


_AT_ONCE, _SOON = 1e-3, 0.05
"""What the first row, and those up to `_EARLY`, may be off (R, rad).

A start is exact, and errors grow.
"""

_EARLY = 0.3
"""Up to this time, √(R/g), rows tell units and signs of velocities."""

_MOST_ROWS = 60


class _Path(NamedTuple):
    """The columns of a record."""

    time: Reals
    x: Reals
    y: Reals
    theta: Reals


Change = Callable[["Trajectory", _Path], _Path]

_CHANGES: dict[str, Change] = {
    "theta has the other sign: counterclockwise is positive": lambda _, p: p._replace(
        theta=-p.theta
    ),
    "x has the other sign: it grows to the right": lambda _, p: p._replace(x=-p.x),
    "theta is in degrees: it must be in radians": lambda _, p: p._replace(
        theta=np.radians(p.theta)
    ),
    "theta is whole turns off": lambda m, p: p._replace(
        theta=p.theta + math.tau * round(_off(m, p) / math.tau)
    ),
    "theta is measured from another direction than the upward normal": lambda m, p: p._replace(
        theta=p.theta + _off(m, p)
    ),
    "x does not begin at 0": lambda m, p: p._replace(x=p.x - p.x[0] + float(m(p.time[0]).x)),
    "x and y are those of the mass centre: they must be those of the geometric "
    "centre": lambda m, p: p._replace(
        x=p.x + m.hoop.h * np.sin(p.theta), y=p.y - m.hoop.h * np.cos(p.theta)
    ),
    "y is the gap under the rim: it must be the height of the centre, 1 in contact": lambda _, p: (
        p._replace(y=p.y + 1)
    ),
    "time is in thousandths": lambda _, p: p._replace(time=p.time / 1e3),
    "x and y are in thousandths": lambda _, p: p._replace(x=p.x / 1e3, y=p.y / 1e3),
}


def _off(motion: Trajectory, path: _Path) -> float:
    """How much the first angle is off."""
    return float(motion(path.time[0]).theta) - float(path.theta[0])


def doubts(motion: Trajectory, record: Record) -> Iterator[str]:
    """Yield what looks like a mistake of the record rather than of the solver."""
    path = _Path(record.time, record.x, record.y, record.theta)
    yield from _wrapped(path)
    yield from _other_rates(motion, record)
    if not motion.start.time <= path.time[0] <= motion.end_time:
        return
    off = _distance(motion, path)
    if off is not None and off[0] <= _AT_ONCE and off[1] <= _SOON:
        return
    better = _explained(motion, path, math.inf if off is None else off[1])
    if off is None and not better:
        # So few rows that they say nothing.
        return
    first = ", ".join(
        f"{name} by {size:.2g}"
        for name, size in _first_row(motion, path).items()
        if size > _AT_ONCE
    )
    said = (
        f"the first row is not the start: it is off in {first}"
        if first
        else "the first rows leave the exact motion"
    )
    yield said + (f"; {' and '.join(better)}?" if better else "")


def _wrapped(path: _Path) -> Iterator[str]:
    jumps = np.flatnonzero(np.abs(np.diff(path.theta)) > 0.9 * math.tau)
    # A motion that turns so fast would do so in each of its steps.
    if 0 < jumps.size < 0.1 * path.theta.size:
        yield (
            f"theta jumps by {path.theta[jumps[0] + 1] - path.theta[jumps[0]]:.3g} at time = "
            f"{path.time[jumps[0] + 1]:.6g}: is it wrapped? A turn must be 2 pi more (numpy.unwrap)"
        )


def start_rates(motion: Trajectory) -> tuple[float, float, float]:
    """Return x′, y′ and θ′ of the start, before what changes them at once."""
    start = motion.start
    return start.slip - start.theta_rate, start.gap_rate, start.theta_rate


def _other_rates(motion: Trajectory, record: Record) -> Iterator[str]:
    """Rates of the first row that are not those of the start."""
    if record.rates is None or record.time[0] != motion.start.time:
        return
    exact = start_rates(motion)
    size = max(1.0, *map(abs, exact))
    for name, mine, rate in zip(RATES, record.rates, exact, strict=True):
        if abs(mine[0] - rate) > _AT_ONCE * size:
            yield (
                f"the first row is not the start: it is off in {name} by "
                f"{abs(mine[0] - rate):.2g}; rates are those of the geometric centre, with the "
                "signs of x, y and theta"
            )
            return


def _explained(motion: Trajectory, path: _Path, off: float) -> list[str]:
    """The fewest changes with which the first rows are those of the motion."""
    for count in (1, 2, 3):
        best: tuple[float, list[str]] | None = None
        for names in itertools.permutations(_CHANGES, count):
            changed = path
            for name in names:
                changed = _CHANGES[name](motion, changed)
            left = _distance(motion, changed)
            if left is None or left[0] > _AT_ONCE or left[1] > min(_SOON, 0.1 * off):
                continue
            # Of equals the first: what is listed first is the more usual.
            if best is None or left[1] < 0.5 * best[0]:
                best = left[1], list(names)
        if best is not None:
            return best[1]
    return _other_case(path) if math.isfinite(off) else []


def _other_case(path: _Path) -> list[str]:
    """Another case of the benchmark of which these are the first rows."""
    from .cases import CASES

    for name, one in CASES.items():
        if one.given["units"] == "dimensionless":
            left = _distance(one.motion, path)
            if left is not None and left[0] <= _AT_ONCE and left[1] <= _SOON:
                return [f"is it the case {name}"]
    return []


def _first_row(motion: Trajectory, path: _Path) -> dict[str, float]:
    at = motion(path.time[0])
    exact = {"x": at.x, "y": at.centre_y, "theta": at.theta}
    return {
        name: abs(float(getattr(path, name)[0]) - float(value)) for name, value in exact.items()
    }


def _distance(motion: Trajectory, path: _Path) -> tuple[float, float] | None:
    """How far the first row, and the early ones, are off.

    None if the motion has too few of them.
    """
    end = min(path.time[0] + _EARLY, motion.end_time)
    at = np.flatnonzero(path.time <= end)
    if at.size < 3:
        return None
    at = at[:: max(1, at.size // _MOST_ROWS)]
    samples = motion(path.time[at])
    off = np.max(
        np.abs(
            [path.x[at] - samples.x, path.y[at] - samples.centre_y, path.theta[at] - samples.theta],
        ),
        axis=0,
    )
    return float(off[0]), float(np.max(off))
