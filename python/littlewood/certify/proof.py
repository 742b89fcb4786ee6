"""The proof behind a certificate, as the checker finds it.

Where the guards of each phase are enclosed above 0.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from . import checker, picture
from .checker import SLIP, TURNING, FlightStep, Followed, Given, Guard, Range
from .stretch import Box, Instant, Stretch, quantity_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class NoCertificate(ValueError):
    """What has not the shape of a certificate."""


@dataclass(frozen=True)
class Proof:
    """The stretches between the events of a motion, and the bits of the checker.

    With these it has enclosed them.

    Each bounce that the certificate does not list has a stretch, too.
    """

    certificate: Mapping[str, Any]
    bits: int
    massless: bool
    stretches: list[Stretch]

    @classmethod
    def of(cls, certificate: Any) -> Proof:
        """Check a certificate, and return its proof.

        Parameters
        ----------
        certificate : dict
            What a file of a certificate says.

        Returns
        -------
        Proof

        Raises
        ------
        NoCertificate
            If it has another shape.
        Refused
            If nothing is certified, or with the first thing that is not right.
        """
        try:
            checker.valid(certificate)
        except checker.Refused as refused:
            raise NoCertificate(f"this is no certificate: {refused}") from None
        walk = checker.followed(certificate, _Recorded)
        return cls(certificate, walk.bits, walk.given.massless, walk.stretches)

    @property
    def intervals(self) -> int:
        """How many intervals the guards are enclosed on."""
        return sum(one.intervals for one in self.stretches)

    def plot(self, width_mm: float = 120.0) -> Figure:
        """Draw it: :func:`littlewood.plot.proof`."""
        return picture.draw(self, width_mm)


_PARTS = 4
"""Parts of an interval whose ends have an enclosure of θ."""


class _Recorded(checker.Walk):
    """A walk that keeps its proof."""

    def __init__(self, case: Mapping[str, Any]) -> None:
        super().__init__(case)
        self.bits, self.stretches = Range.bits, list[Stretch]()

    def run(self, phase: checker.Phase) -> Followed:
        """Follow a phase, and keep the proof that nothing happens before its end."""
        run = super().run(phase)
        self.stretches.append(_stretch(self.given, run))
        return run


def _stretch(given: Given, run: Followed) -> Stretch:
    first, last = run.phase.start.time, None if run.end is None else run.end.time
    until = last if run.turn is None else first + run.turn.period
    # Both times have the radius of the start, which the time between them has not.
    length = None if until is None else Range((until - first).m)
    guards: dict[str, list[Box]] = {}
    tube: list[Instant] = []
    if not run.steps:
        # It rests; the certificate has the first four units of what is endless.
        tube = [
            _instant(given, time, run.phase.start.theta)
            for time in (first, first + 4 if last is None else last)
        ]
    enclosed, intervals = first, 0
    for step, free in zip(run.steps, run.free, strict=True):
        for low, high in _intervals(step, free, length):
            intervals += 1
            points = [low + (high - low) * k / _PARTS for k in range(_PARTS)] + [high]
            moments = [step.moment(s) for s in points]
            tube += [_instant(given, first + tau, theta) for tau, theta, _ in moments]
            times = [first + tau for tau, *_ in moments]
            enclosed = times[-1]
            # A bounce may be one interval: its parts show its shape.
            apart = 1 if isinstance(step, FlightStep) and step.order else _PARTS
            for k in range(0, _PARTS, apart):
                start, end = (float(time * given.clock) for time in (times[k], times[k + apart]))
                for name, guard in step.guards.items():
                    quantity = quantity_of(name, given.massless)
                    unit = 1.0 if quantity is None else float(given.scale[quantity])
                    bottom, top = _enclosed(step, name, guard, points[k], points[k + apart])
                    guards.setdefault(name, []).append(Box(start, end, unit * bottom, unit * top))
    return Stretch(
        run.phase.mode,
        float(first * given.clock),
        float(enclosed * given.clock),
        None if last is None else float(last * given.clock),
        run.turn is not None,
        intervals,
        guards,
        tube,
    )


def _intervals(
    step: checker.AnyStep, free: list[checker.Interval], end: Range | None
) -> list[checker.Interval]:
    """Return the intervals of a step up to the end of its phase.

    In the last one a guard may fall to its zero there.
    """
    if end is None or not checker.exceeds(step.length, end - step.tau):
        return free
    stop = Range(((end - step.tau) / step.length).m)
    before = [(low, high) for low, high in free if checker.exceeds(stop, high)]
    return [*before, (before[-1][1] if before else Range(0), stop)]


def _enclosed(
    step: checker.AnyStep, name: str, guard: Guard, low: Range, high: Range
) -> tuple[float, float]:
    """Return bounds of a guard between two places in a step.

    The zero at its start is divided out.
    """
    between = guard.between(low, high)
    # What is not enclosed above 0 is monotone.
    ends = [between] if checker.exceeds(between, 0) else [guard.value(low), guard.value(high)]
    values = [float(end) for one in ends for end in one.ends()]
    orders = {SLIP: step.phase.order, TURNING: step.phase.turning_order}
    order, unit, more = orders.get(name, 0) if step.tau.is_zero() else 0, 1.0, 0.0
    if isinstance(step, FlightStep):
        order, unit = step.order, float(step.length)
        # A leap encloses a lower bound of the gap, which leaves h (1 − cos θ) out.
        more = 2 * float(step.phase.body.h) if step.leaps else 0.0
    return min(values) * (float(low) * unit) ** order, max(values) * (
        float(high) * unit
    ) ** order + more


def _instant(given: Given, time: Range, theta: Range) -> Instant:
    radius = (math.log2(max(theta.r, 1)) - Range.bits) * math.log10(2)
    return Instant(float(time * given.clock), float(theta), radius)
