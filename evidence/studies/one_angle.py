"""One angle for all jumps: the flight after a slide, and what is left of its law after a bounce."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cache

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import FAINT, INK
from littlewood.tables import IMPACT_LABELS
from matplotlib.figure import Figure

from .attacks import said
from .hoops import DEGREE, random_hoops
from .page import table
from .roots import zero
from .study import Study


def rise(angle: float, turned: float) -> float:
    """Return the gap over h when the hoop has turned by an angle.

    It lifted off at θ0 = −angle.
    """
    # C = cos φ − 1 + φ²/2 and S = φ − sin φ without the cancellation of small angles.
    if turned < 0.5:
        powers = [(-1) ** k * turned ** (4 + 2 * k) / math.factorial(4 + 2 * k) for k in range(9)]
        odd = [(-1) ** k * turned ** (3 + 2 * k) / math.factorial(3 + 2 * k) for k in range(9)]
        c, s = math.fsum(powers), math.fsum(odd)
    else:
        c, s = math.cos(turned) - 1.0 + 0.5 * turned**2, turned - math.sin(turned)
    return math.sin(angle) * s - math.cos(angle) * c


@cache
def turned_in_air(angle: float) -> float:
    """Return the angle by which a hoop turns in the air.

    It lifted off `angle` before the top.
    """
    # C/S < φ/2, so that the landing is behind 2 tan, and C/S > φ/2 − 2/φ − 1 puts an end behind it.
    return zero(
        lambda turned: rise(angle, turned), 2.0 * angle, 2.0 * math.tan(angle) + 2.0 * math.pi
    )


@cache
def turned_at_top(angle: float) -> float:
    """Return the angle at which the gap is largest: its derivative is that of −(c0 C + s0 S)."""

    def rate(turned: float) -> float:
        return math.sin(angle) * (1.0 - math.cos(turned)) - math.cos(angle) * (
            turned - math.sin(turned)
        )

    # In a jump of more than a turn the gap has several maxima, at least a turn apart or so.
    end = turned_in_air(angle)
    steps = 40 + int(20.0 * end)
    best = max(range(1, steps), key=lambda step: rise(angle, end * step / steps))
    return zero(rate, end * (best - 1) / steps, end * (best + 1) / steps)


@dataclass(frozen=True)
class Bounce:
    """A rebound with three numbers.

    Parameters
    ----------
    e : float
        Coefficient of restitution.
    kappa : float
        ϱ/h² = I/(m h²): square of the radius of gyration about the mass centre over its distance
        from the centre.
    psi : float
        ψ = μk σ (1 + h cos θ)/h at the landing; 0 without friction.
    """

    e: float
    kappa: float
    psi: float = 0.0

    def second(self, angle: float) -> float | None:
        """Return the angle of the second hop, if the slip lasts through the impact.

        None where the first grazes.
        """
        turned = turned_in_air(angle)
        landing = turned - angle
        rate = -self._fall(angle, turned)
        if rate < 1e-9:
            return None
        s = math.sin(landing)
        # P over m h θ′, from Δw = (C − μk σ B) P with m C = 1 + h² s²/ϱ and m B = h s (1 + hc)/ϱ.
        impulse = (1.0 + self.e) * rate / (1.0 + s * (s - self.psi) / self.kappa)
        spin = 1.0 + impulse * (s - self.psi) / self.kappa
        return self._next(landing, spin, self.e * rate, 1.0 / math.cos(angle))

    @staticmethod
    def _fall(angle: float, turned: float) -> float:
        """Return the rate of the gap at the landing over h θ0′.

        It is the derivative of `rise` by the angle.
        """
        return math.sin(angle) * (1.0 - math.cos(turned)) - math.cos(angle) * (
            turned - math.sin(turned)
        )

    @staticmethod
    def _next(start: float, spin: float, rate: float, square: float) -> float:
        """Return the angle turned until the gap closes again.

        `spin` is θ′ over that of the first flight, `rate` the rate of the gap over h θ0′, and
        1/`square` = h θ0′².
        """

        # In the time t = θ0′ τ: gap/h = (rate − s1 spin) t − t²/2 cos θ0 − cos(θ1 + spin t) + c1.
        def gap(t: float) -> float:
            half = 0.5 * spin * t
            turn = -2.0 * math.sin(half) * math.sin(start + half)
            return (rate - math.sin(start) * spin) * t - 0.5 * t * t / square - turn

        # The gap over t begins with `rate`, and grows no faster than a step of this length can
        # tell.
        step = min(0.01, 0.02 * rate * square)
        t = step
        while gap(t) > 0.0:
            t += step
        return abs(spin) * zero(gap, t - step, t)


def jumps_of(
    seed: int, count: int, restitution: float | None = None
) -> Iterator[tuple[lw.Hoop, lw.Trajectory, int]]:
    """Yield motions of random hoops with a lift-off out of a slide, and the place of its flight."""
    for drawn, random in random_hoops(seed, count):
        hoop = replace(drawn, restitution=restitution)
        # Fast enough that some of the starts leave the plane, and slow enough that they slide
        # first.
        rate = random.uniform(0.5, 1.2) / math.sqrt(hoop.h)
        motion = hoop.simulate(
            theta=random.uniform(-math.pi, math.pi),
            theta_rate=rate * random.choice([-1.0, 1.0]),
            slip=random.choice([0.0, random.normal()]),
            until=60.0 + 40.0 / rate,
            max_transitions=200,
        )
        phases = motion.phases
        for place in range(1, len(phases)):
            last = motion.transitions[place - 1]
            if (
                phases[place].mode == "flight"
                and phases[place - 1].mode == "sliding"
                and last.cause == "lift_off"
            ):
                if phases[place].end is not None and motion.outcome.kind != "time_limit":
                    yield hoop, motion, place
                break


def before_top(theta: float) -> float:
    """Return the distance of an angle from the nearest top."""
    return abs(math.remainder(theta, 2.0 * math.pi))


def laws() -> list[str]:
    """The law as a table."""
    rows = []
    for degrees in (5, 10, 20, 30, 45, 60, 70, 75, 80, 85):
        angle = degrees * DEGREE
        turned = turned_in_air(angle)
        rows.append(
            [
                f"{degrees}",
                f"{turned / DEGREE:.3f}",
                f"{turned / angle:.4f}",
                f"{(turned - angle) / DEGREE:.3f}",
                f"{turned * math.sqrt(math.cos(angle)):.4f}",
                f"{rise(angle, turned_at_top(angle)):.4g}",
            ]
        )
    heads = [
        "lift-off before the top, °",
        "turned in the air, °",
        "over \\|θ0\\|",
        "lands behind the top, °",
        "τ/√h",
    ]
    return table([*heads, "height/h"], rows)


def whole_turns(number: int) -> float:
    """Return the angle of lift-off before the top for so many turns in the air."""
    return math.atan(number * math.pi)


def whole() -> str:
    """The first of these angles."""
    first, second, third = (whole_turns(number) / DEGREE for number in (1, 2, 3))
    return f"{first:.3f}°, {second:.3f}°, {third:.3f}° …"


def steep() -> str:
    """How far the landing moves with a tenth of a degree beside the first vertical tangent."""
    place = zero(lambda angle: math.tan(angle) - angle - math.pi, 1.3, 1.4)
    below, at, above = (turned_in_air(place + step * DEGREE) for step in (-0.1, 0.0, 0.1))
    return f"{(at - below) / DEGREE:.0f}° below and {(above - at) / DEGREE:.0f}° above"


@cache
def sample() -> list[tuple[float, float]]:
    """Return angles of lift-off and of the turn in the air of random hoops.

    The library simulates them.
    """
    found = []
    for _, motion, place in jumps_of(2026, 3000):
        phase = motion.phases[place]
        assert phase.end is not None
        found.append((before_top(phase.start.theta), abs(phase.end.theta - phase.start.theta)))
    return found


def agreement() -> str:
    """How many of the random hoops jump, and by how much they differ from the law."""
    # Where the law is steep its own input, the angle of lift-off, is known to its last digit only.
    worst = max(
        abs(turned / turned_in_air(angle) - 1.0) for angle, turned in sample() if 0.01 < angle < 1.3
    )
    return (
        f"{len(sample())} of 3000 leave the plane out of a slide; the largest relative difference "
        f"is {worst:.0e}"
    )


@cache
def second_sample() -> list[tuple[str, float, float]]:
    """Angles of the second hop of random hoops.

    Case of the impact, angle as simulated, angle by three numbers.
    """
    found = []
    for hoop, motion, place in jumps_of(7, 3000, restitution=0.5):
        if place + 1 >= len(motion.phases) or motion.phases[place + 1].mode != "flight":
            continue
        first, second = motion.phases[place], motion.phases[place + 1]
        impact = motion.transitions[place].impact
        if impact is None or first.end is None or second.end is None:
            continue
        angle = before_top(first.start.theta)
        if not 0.05 < angle < 1.3:
            continue
        # In the frame in which the hoop turns counterclockwise.
        sigma = math.copysign(1.0, impact.before.slip) * math.copysign(1.0, first.start.theta_rate)
        h = hoop.h
        psi = hoop.mu_k * sigma * (1.0 + h * math.cos(first.end.theta)) / h
        expected = Bounce(0.5, hoop.inertia_about_mass_centre / (hoop.mass * h * h), psi).second(
            angle
        )
        if expected is not None:
            found.append((impact.case, abs(second.end.theta - second.start.theta), expected))
    return found


def second_agreement() -> list[str]:
    """By the case of the impact: how far three numbers tell the angle of the second hop."""
    rows = []
    for case in lw.tables.IMPACT_CASES:
        both = [(turned, expected) for kind, turned, expected in second_sample() if kind == case]
        if both:
            off = np.sort([abs(turned / expected - 1.0) for turned, expected in both])
            rows.append(
                [IMPACT_LABELS[case], str(len(both)), f"{off[len(off) // 2]:.0e}", f"{off[-1]:.0e}"]
            )
    return table(["impact", "hops", "median difference", "largest difference"], rows)


def law_picture() -> Figure:
    """The law, with the hoops that were simulated; time and height; the second hop."""
    figure, (left, middle, right) = panels(3)
    angles = np.linspace(0.2, 88.0, 400) * DEGREE
    turned = np.array([turned_in_air(float(angle)) for angle in angles])
    first, second = (look for _, look in listed("ab"))
    left.plot(angles / DEGREE, turned / DEGREE, **first, label="turned in the air")
    left.plot(angles / DEGREE, (turned - angles) / DEGREE, **second, label="landing behind the top")
    for factor in (4, 3):
        left.plot(
            [0, 60], [0, 60 * factor], color=FAINT, linestyle="dotted", label="4 |*θ*₀|, 3 |*θ*₀|"
        )
    points = np.array(sample()) / DEGREE
    left.plot(*points.T, ".", color=INK, markersize=2.5, label="random hoops")
    whole = np.arctan(math.pi * np.arange(1, 4)) / DEGREE
    left.plot(
        whole,
        [360, 720, 1080],
        "o",
        color=INK,
        markersize=6,
        fillstyle="none",
        zorder=4,
        label="whole turns",
    )
    left.set(ylim=(0, 1170), ylabel="degrees", yticks=range(0, 1081, 180))
    times = turned * np.sqrt(np.cos(angles))
    middle.plot(angles / DEGREE, times, **first, label="time in the air over √*h*, √(*R*/*g*)")
    heights = [rise(float(angle), turned_at_top(float(angle))) for angle in angles]
    middle.plot(angles / DEGREE, heights, **second, label="height over *h*, *R*")
    middle.set_ylim(0, 5)
    shown = np.linspace(2.0, 77.0, 160) * DEGREE
    for kappa, look in listed((0.3, 1.0, 3.0, 30.0)):
        values = [Bounce(0.5, kappa).second(float(angle)) for angle in shown]
        line = [math.nan if value is None else value / DEGREE for value in values]
        right.plot(shown / DEGREE, line, **look, label=f"*ϱ*/*h*² = {kappa:g}")
    right.set_ylabel("turned in the second hop, degrees")
    right.set_ylim(bottom=0)
    for axes, columns, heading in (
        (left, 2, None),
        (middle, 1, None),
        (right, 2, "*e* = 0.5, no friction in the impact"),
    ):
        axes.set(
            xlim=(0, 90), xticks=range(0, 91, 30), xlabel="lift-off before the top |*θ*₀|, degrees"
        )
        key(axes, heading, columns=columns)
    return figure


STUDY = Study(
    name="one-angle",
    texts={
        "attack": lambda: said("one-angle", "angle"),
        "laws": laws,
        "whole": whole,
        "steep": steep,
        "agreement": agreement,
        "second hop": second_agreement,
    },
    pictures={"law": law_picture},
)
