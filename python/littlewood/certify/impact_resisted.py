"""An impact with rolling resistance, segment by segment (docs/theory/rolling-resistance.md).

In each segment the contact slips or sticks, and turns or holds; all rates are constant in the
normal impulse p. A segment ends where η′ or θ′ vanishes.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass, replace

from .balls import Ball, Beyond, Undecided, arb, sign
from .body import Body, State
from .impact import Impact
from .resisted import Held


@dataclass(frozen=True)
class _Segment:
    """A segment: the signs of slip and θ′, 0 where held, and the changes by p."""

    slips: int
    turns: int
    rate: Ball
    slip: Ball
    gap_rate: Ball
    friction: Ball
    couple: Ball


class _Course:
    """The velocities of an impact on its way, and what it has done so far."""

    def __init__(self, body: Body, before: State) -> None:
        self.body, self.rate, self.slip = body, before.rate, before.slip
        self.gap_rate = before.gap_rate
        self.arm, self.lever = body.h * before.theta.sin(), 1 + body.h * before.theta.cos()
        self.normal, self.friction, self.lost, self.work = (arb(0) for _ in range(4))
        self.spin = arb(0)
        """What has been added to θ′, without the radius of θ′ itself."""
        self.segments: list[_Segment] = []
        self.begins: list[tuple[Ball, bool]] = []
        """Normal impulses at which segments begin, and whether the rim still comes down there."""
        self.compressed: tuple[Ball, Ball] | None = None
        """Normal impulse, and work taken, where the gap rate has vanished; then `work` is new."""

    def _with(self, slips: int, turns: int) -> _Segment | None:
        """Return the segment of two signs, where its friction and its couple allow it."""
        body, a, d, chi = self.body, self.arm, self.lever, self.body.chi
        m, inertia, zero = body.mass, body.inertia, arb(0)
        slides = -body.mu_k * slips
        if turns == 0:
            couple = a + d * slides
            if sign(chi - abs(couple), "what holds the angle in an impact") < 0:
                return None
            if slips and self.slip.is_zero():
                # Friction alone acts along the plane, against any slip.
                return None
            return _Segment(slips, 0, zero, slides / m, 1 / m, slides, -couple)
        arm = a - chi * turns
        if slips == 0:
            j = inertia + m * d * d
            if sign(body.mu_s * j - abs(m * d * arm), "what sticks in an impact") < 0:
                return None
            found = _Segment(
                0, turns, arm / j, zero, 1 / m + a * arm / j, -m * d * arm / j, -chi * turns
            )
        else:
            q = arm + d * slides
            along = slides / m + d * q / inertia
            if self.slip.is_zero() and sign(along, "the slip of an impact") != slips:
                return None
            found = _Segment(
                slips, turns, q / inertia, along, 1 / m + a * q / inertia, slides, -chi * turns
            )
        if self.rate.is_zero() and sign(found.rate, "the spin of an impact") != turns:
            return None
        return found

    def next(self) -> _Segment:
        """Return the segment that follows; what holds more excludes what holds less."""
        slips, turns = sign(self.slip, "η′ in an impact"), sign(self.rate, "θ′ in an impact")
        signs = list(
            itertools.product((slips,) if slips else (0, -1, 1), (turns,) if turns else (0, -1, 1))
        )
        for zeros in (2, 1, 0):
            tried = [self._with(*pair) for pair in signs if pair.count(0) == zeros]
            found = [one for one in tried if one is not None]
            if len(found) > 1:
                break
            if found:
                self._began(found[0])
                return found[0]
        raise Undecided("an impact has no segment, or two")

    def _began(self, one: _Segment) -> None:
        last = self.segments[-1] if self.segments else None
        if last is None or (last.slips, last.turns) != (one.slips, one.turns):
            self.segments.append(one)
            self.begins.append((self.normal, self.compressed is None))

    @property
    def case(self) -> str:
        """What the slip does: as without resistance."""
        first = self.segments[0]
        if first.gap_rate < 0:
            return "jams"
        for one, (_, compresses) in zip(self.segments, self.begins, strict=True):
            if one.slips == 0 or one.slips != first.slips:
                where = "compression" if compresses else "restitution"
                return f"{'reverses' if one.slips else 'sticks'}_in_{where}"
        return "slides"

    def end_of(self, one: _Segment) -> tuple[Ball | None, str]:
        """Return the impulse after which a segment ends, and which velocity vanishes there."""
        ends = []
        for name, value, change in (("slip", self.slip, one.slip), ("rate", self.rate, one.rate)):
            if not value.is_zero() and sign(change, f"the change of {name}") == -sign(value, name):
                ends.append((-value / change, name))
        if len(ends) < 2:
            return ends[0] if ends else (None, "")
        return ends[sign(ends[0][0] - ends[1][0], "which velocity vanishes first") > 0]

    def move(self, one: _Segment, by: Ball, zero: str, gap_rate: Ball | None = None) -> None:
        """Add a normal impulse, after which a velocity vanishes, or the gap rate is known."""
        rate, slip = self.rate + one.rate * by, self.slip + one.slip * by
        if gap_rate is None:
            gap_rate = self.gap_rate + one.gap_rate * by
        work = by * (self.gap_rate + gap_rate) / 2
        self.work += work
        self.lost -= work + by * one.friction * (self.slip + slip) / 2
        self.lost -= by * one.couple * (self.rate + rate) / 2
        self.normal, self.friction = self.normal + by, self.friction + one.friction * by
        self.spin += one.rate * by
        self.rate = arb(0) if zero == "rate" else rate
        self.slip = arb(0) if zero == "slip" else slip
        self.gap_rate = gap_rate

    def last(self, one: _Segment, closing: Ball, e: Ball, law: str) -> tuple[Ball, Ball] | None:
        """Return the impulse after which compression ends, or the impact, and the gap rate there.

        None if the gap does not open.
        """
        opens = sign(one.gap_rate, "the gap rate in an impact")
        if self.compressed is None:
            return (-self.gap_rate / one.gap_rate, arb(0)) if opens > 0 else None
        if opens <= 0:
            raise Beyond("the gap closes twice in an impact, which is not proved")
        normal, taken = self.compressed
        if law == "poisson":
            by = (1 + e) * normal - self.normal
            return by, self.gap_rate + one.gap_rate * by
        if law == "newton":
            opening = e * closing
        else:
            left = e * e * taken - self.work
            opening = (self.gap_rate * self.gap_rate + 2 * one.gap_rate * left).sqrt()
        return (opening - self.gap_rate) / one.gap_rate, opening


def impact_resisted(body: Body, before: State, e: Ball, law: str) -> tuple[Impact, Held]:
    """Follow an impact, or a jam, which has no gap rate; and what its last segment holds."""
    course = _followed(body, before, e, law)
    evidence = {f"k{k}": one.gap_rate for k, one in enumerate(course.segments, 1)}
    evidence |= {f"segment_{k}": at for k, (at, _) in enumerate(course.begins[1:], 2)}
    after = replace(
        before, rate=course.rate, slip=course.slip, gap=arb(0), gap_rate=course.gap_rate
    )
    last = course.segments[-1]
    hit = Impact(course.case, course.normal, course.friction, course.lost, after, evidence)
    return hit, Held(last.slips == 0, last.turns == 0)


def _followed(body: Body, before: State, e: Ball, law: str) -> _Course:
    course = _Course(body, before)
    while True:
        one = course.next()
        to_end, name = course.end_of(one)
        last = course.last(one, -before.gap_rate, e, law)
        if last is None and to_end is None:
            raise Undecided("an impact has no end")
        if last is None or (
            to_end is not None and sign(to_end - last[0], "which end of a segment comes first") < 0
        ):
            course.move(one, to_end, name)
            continue
        course.move(one, last[0], "", last[1])
        if course.compressed is not None or e.is_zero():
            return course
        course.compressed, course.work = (course.normal, -course.work), arb(0)


def impact_of_bounce(
    body: Body, start: State, unit: State | None, landing: State, e: Ball, law: str
) -> Impact:
    """Follow the impact after a short flight: in rates over its gap rate, where it has no slip.

    So the radius of the gap rate does not grow from bounce to bounce.
    """
    if unit is None:
        return impact_resisted(body, landing, e, law)[0]
    v = start.gap_rate
    course = _followed(body, replace(unit, rate=start.rate / v), e, law)
    after = replace(
        unit,
        rate=arb(0) if course.rate.is_zero() else course.spin,
        slip=course.slip,
        gap=arb(0),
        gap_rate=course.gap_rate,
    )
    hit = Impact(course.case, course.normal, course.friction, course.lost, after, {})
    hit = hit.times(v, start.rate)
    return replace(hit, after=replace(hit.after, rate=arb(0))) if course.rate.is_zero() else hit
