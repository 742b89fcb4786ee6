"""The best hop: what a hoop can jump with a given energy.

Also what it takes to jump at all, and how often it hops.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache
from typing import Any

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import FAINT, FINE, INK, LINE
from matplotlib.figure import Figure

from .attacks import said
from .hoops import DEGREE, random_hoops, thin_hoop
from .one_angle import rise, turned_at_top, turned_in_air
from .page import table
from .roots import zero
from .study import Study

FRICTIONS = (0.1, 0.3, 0.6, 1.0)
ENERGIES = (1.2, 1.5, 2.0, 3.0, 5.0, 10.0)
"""Energies over m g R; 0 is that of a hoop at rest with its mass centre at the height of its
centre."""


@dataclass(frozen=True)
class Body:
    """A hoop by the two numbers on which its motion depends.

    Parameters
    ----------
    h : float or ndarray
        Distance of the mass centre from the centre.
    gyration : float or ndarray
        Î/m, the square of the radius of gyration about the mass centre.
    """

    h: Any
    gyration: Any

    @classmethod
    def thin(cls, h: Any) -> Body:
        """Make a thin hoop with the particle on its rim."""
        return cls(h, 1.0 - h * h)

    def about_contact(self, angle: float) -> Any:
        """Return D/m."""
        return self.gyration + 1.0 + self.h * self.h + 2.0 * self.h * math.cos(angle)

    def hoop(self, mu: float) -> lw.Hoop:
        """Return the hoop with a coefficient of friction."""
        given: dict[str, Any] = {name: float(value) for name, value in self.parameters.items()}
        return lw.Hoop(**given, mu_s=mu, mu_k=mu)

    @property
    def parameters(self) -> dict[str, Any]:
        """Mass ratio, offset and inertia of a hoop with these numbers."""
        # A particle on the rim if the inertia allows it, and else the disc is a point at the
        # centre.
        ratio = np.minimum(1.0 / self.h - 1.0, self.gyration / (self.h * self.h))
        mass = 1.0 + ratio
        return {
            "mass_ratio": ratio,
            "offset": self.h * mass,
            "inertia": np.maximum(mass * self.gyration - ratio * mass * self.h * self.h, 0.0),
        }

    def lift_off_energy(self, angle: Any) -> Any:
        """Return the least energy over m g R to leave a slide at an angle before the top."""
        c = np.cos(angle)
        return 0.5 * (self.gyration + self.h * self.h) / (self.h * c) + 0.5 * self.h * c

    @property
    def least_energy(self) -> Any:
        """E_lift/(m g R): no hoop in contact with less lifts off."""
        return 0.5 * self.gyration / self.h + self.h

    def earliest(self, energy: float) -> float:
        """Return the largest angle before the top at which a slide of an energy can end, or NaN."""
        square = energy * energy - self.gyration - self.h * self.h
        if energy < self.least_energy or square < 0.0:
            return math.nan
        return math.acos((energy - math.sqrt(square)) / self.h)


def height(h: float, angle: float) -> float:
    """Return the height of a jump out of a slide that ends at an angle before the top."""
    return h * rise(angle, turned_at_top(angle))


@cache
def law() -> tuple[Any, Any]:
    """Return angles of lift-off, and the angles turned in the air."""
    angles = np.linspace(1e-3, 88.0 * DEGREE, 3000)
    return angles, np.array([turned_in_air(float(angle)) for angle in angles])


def reach(body: Body, energy: float, angle: Any, turned: Any) -> Any:
    """Return how far the centre can go in a jump out of a slide.

    The slide has an energy, and ends at an angle.
    """
    spare = np.maximum(energy - body.lift_off_energy(angle), 0.0)
    swing = np.abs(body.h * (np.sin(turned - angle) + np.sin(angle)))
    return np.sqrt(2.0 * spare) * turned * np.sqrt(body.h * np.cos(angle)) + swing


def farthest(body: Body, energy: float) -> tuple[float, float]:
    """Return the bound of the length of a jump, and the angle of the lift-off that has it."""
    angles, turned = law()
    lengths = np.where(
        angles <= body.earliest(energy), reach(body, energy, angles, turned), -np.inf
    )
    place = int(np.argmax(lengths))
    return float(lengths[place]), float(angles[place])


def thrown(body: Body, angle: float, along: float, mu: float) -> lw.Trajectory:
    """Return the motion of a hoop that starts at the end of a slide.

    Its mass centre has a speed along the plane.
    """
    rate = 1.0 / math.sqrt(body.h * math.cos(angle))
    hoop = body.hoop(mu)
    # A little below the rate of lift-off, so that it slides first.
    rate *= 1.0 - 1e-9
    slip = along + (1.0 + body.h * math.cos(angle)) * rate
    return hoop.simulate(theta=-angle, theta_rate=rate, slip=slip, max_transitions=2)


def flight(motion: lw.Trajectory) -> lw.motion.Phase:
    """Return the first flight of a motion."""
    return next(phase for phase in motion.phases if phase.mode == "flight")


def rolled(body: Body, energy: float, mu: float) -> Any:
    """Return the heights of the first jumps, or NaN.

    The hoops roll at the bottom with an energy over m g R.
    """
    rate = np.sqrt(2.0 * (energy + body.h) / body.about_contact(math.pi))
    found = lw.simulate_many(
        theta=math.pi,
        theta_rate=rate,
        mu_s=mu,
        mu_k=mu,
        proof="contact",
        max_transitions=1000,
        threads=2,
        **body.parameters,
    )
    return found.jump_height.to_numpy()


def searched(energy: float, mu: float, share: float) -> tuple[Any, Any]:
    """Return offsets, and heights of jumps of hoops with a share of the inertia of thin ones."""
    offsets = np.linspace(0.02, 0.99, 98)
    return offsets, rolled(Body(offsets, share * (1.0 - offsets * offsets)), energy, mu)


@cache
def jump_from_top(h: float, mu: float, rate: float) -> lw.Trajectory:
    """Return the motion of a thin hoop that rolls over the top with a rate."""
    return thin_hoop(h, mu_k=mu).simulate(
        theta=0.0, theta_rate=rate, proof="contact", max_transitions=1000
    )


@cache
def least_push(h: float, mu: float) -> float:
    """Return the least rate at the top with which a thin hoop that rolls jumps later."""
    low, high = math.sqrt(0.5 * (1.0 - h) / h), 1.0 / math.sqrt(h)
    rates = np.linspace(low, high * (1.0 - 1e-6), 64)
    ratio = 1.0 / h - 1.0
    found = lw.simulate_many(
        theta=0.0,
        theta_rate=rates,
        mass_ratio=ratio,
        offset=1.0,
        inertia=ratio,
        mu_s=mu,
        mu_k=mu,
        proof="contact",
        max_transitions=1000,
        threads=2,
    )
    jumps = np.nonzero(~np.isnan(found.jump_height.to_numpy()))[0]
    if len(jumps) == 0:
        return math.nan
    first = int(jumps[0])

    def leaves(rate: float) -> float:
        return 1.0 if jump_from_top(h, mu, rate).sequence.endswith("F") else -1.0

    return zero(leaves, float(rates[max(first - 1, 0)]), float(rates[first]))


# Hops of a bouncing hoop, by what an eye or a film would count.


def hops(hoop: lw.Hoop, speed: float, least: float, most: int = 9) -> int:
    """Return how many flights are higher than a gap, no more than `most`.

    The hoop rolls over the bottom.
    """
    motion = hoop.simulate(theta=math.pi, theta_rate=-speed, until=40.0, max_transitions=400)
    after = {
        one.time: one.impact.after.gap_rate for one in motion.transitions if one.impact is not None
    }
    count = 0
    for phase in motion.phases:
        if phase.mode != "flight" or phase.end is None:
            continue
        times = np.linspace(0.0, phase.duration, 41)
        angle, rate = phase.start.theta, phase.start.theta_rate
        opening = after.get(phase.start.time, 0.0) - hoop.h * math.sin(angle) * rate
        gaps = (
            opening * times
            - 0.5 * times**2
            - hoop.h * (np.cos(angle + rate * times) - math.cos(angle))
        )
        count += bool(np.max(gaps) > least)
        if count == most:
            break
    return count


RING, RADIUS = 0.124, 0.14
"""The published build: a hoop of 124 g and 14 cm, which hops once with about 51 g, and twice with
about 66 g."""


def build(weight: float, mu: float, restitution: float) -> lw.Hoop:
    """Return the published hoop with a weight in kg on its rim."""
    return lw.Hoop.from_si(
        disc_mass_kg=RING,
        particle_mass_kg=weight,
        radius_m=RADIUS,
        offset_m=RADIUS,
        inertia_kg_m2=RING * RADIUS**2,
        mu_s=mu,
        mu_k=mu,
        restitution=restitution,
    )


@cache
def window(mu: float, restitution: float, seen: float, step: float = 0.02) -> tuple[float, ...]:
    """Return the speeds of the hoop at the bottom, m/s, at which 51 g hops once and 66 g twice."""
    light, heavy = build(0.051, mu, restitution), build(0.066, mu, restitution)
    unit = math.sqrt(lw.hoop.STANDARD_GRAVITY * RADIUS)

    def count(hoop: lw.Hoop, place: int, most: int) -> int:
        return hops(hoop, place * step / unit, seen / RADIUS, most)

    # Coarse steps to where the light weight begins to hop, and then single ones.
    place = 120
    while count(light, place + 5, 1) == 0:
        place += 5
    found: list[float] = []
    while (once := count(light, place, 2)) < 2:
        if once == 1 and count(heavy, place, 3) == 2:
            found.append(place * step)
        place += 1
    return tuple(found)


def nudges() -> str:
    """Random hoops that are let go next to the top, and how many of them leave the plane."""
    drawn = [hoop for hoop, _ in random_hoops(2027, 3000)]
    columns: dict[str, Any] = {
        name: np.array([getattr(hoop, name) for hoop in drawn])
        for name in ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
    }
    found = lw.simulate_many(
        theta=1e-4, theta_rate=1e-4, proof="contact", max_transitions=1000, threads=2, **columns
    )
    lifted, hard = (
        int(np.sum(~np.isnan(found.lift_off_time.to_numpy()))),
        int(np.sum(found.painleve.to_numpy() != 0)),
    )
    return f"{lifted} of {len(drawn)} leave the plane, and {hard} come to a place with P ≤ 0"


def bounds() -> list[str]:
    """The bounds for thin hoops, over all of them, for several energies."""
    rows = []
    for energy in ENERGIES:
        angle = Body.thin(1.0).earliest(energy)
        offsets = np.linspace(0.1, 0.999, 150)
        lengths = [
            farthest(Body.thin(float(h)), energy)[0]
            for h in offsets
            if energy > Body.thin(float(h)).least_energy
        ]
        turns = turned_in_air(angle) / (2.0 * math.pi)
        numbers = [
            f"{angle / DEGREE:.2f}",
            f"{height(1.0, angle):.4g}",
            f"{turns:.3f}",
            f"{max(lengths):.3g}",
        ]
        rows.append([f"{energy:g}", *numbers])
    return table(
        ["E/(m g R)", "lift-off at most, °", "height, R", "turns in the air", "length, R"], rows
    )


def two_turns() -> str:
    """What it takes to turn twice in the air."""
    angle = zero(lambda angle: turned_in_air(angle) - 4.0 * math.pi, 1.36, 1.5)
    energy = float(Body.thin(1.0).lift_off_energy(angle))
    return (
        f"a lift-off {angle / DEGREE:.1f}° before the top, and at least E = {energy:.2f} m g R in "
        "a thin hoop"
    )


SHARES = (1.0, 0.5, 0.1)
"""Inertias to search, as shares of that of a thin hoop."""


@cache
def search() -> dict[tuple[float, float, float], tuple[float, float]]:
    """Offset and height of the highest jump, by energy, friction and share."""
    found = {}
    for energy in ENERGIES:
        for mu in FRICTIONS:
            for share in SHARES:
                offsets, heights = searched(energy, mu, share)
                high = int(np.nanargmax(heights))
                found[energy, mu, share] = float(offsets[high]), float(heights[high])
    return found


def highest() -> str:
    """Where the highest jump was found."""
    edge = sum(h == 0.99 for (*_, share), (h, _) in search().items() if share == 1.0)
    least = sum(
        search()[energy, mu, SHARES[-1]][1]
        == max(search()[energy, mu, share][1] for share in SHARES)
        for energy in ENERGIES
        for mu in FRICTIONS
    )
    count = len(ENERGIES) * len(FRICTIONS)
    return (
        f"In {edge} of {count} searches over thin hoops the highest jump was that of the largest h "
        "that was tried, "
        f"0.99, and in {least} of {count} the least inertia that was tried, a tenth of a thin "
        "hoop's, jumped highest"
    )


MUS = (0.2, 0.4, 0.6, 1.0)
RESTITUTIONS = (0.0, 0.2, 0.4, 0.6, 0.8)
SEEN = (0.002, 0.005, 0.01)
"""Gaps from which on a flight counts as a hop, m."""


def least_of_build() -> str:
    """The least speed at the top with which the published hoop can jump, by the bound."""
    hoop = build(0.066, 0.5, 0.0)
    rate = math.sqrt(0.5 * (1.0 - hoop.h) / hoop.h)
    return f"{rate * math.sqrt(lw.hoop.STANDARD_GRAVITY * RADIUS):.2f} m/s"


def speeds() -> str:
    """Between which speeds all of the windows are."""
    found = [
        speed for seen in SEEN for mu in MUS for e in RESTITUTIONS for speed in window(mu, e, seen)
    ]
    return f"{min(found):.2f} to {max(found):.2f} m/s"


def push_picture() -> Figure:
    """What it takes to jump, how high hoops jump, and the bound by energy.

    The hoops are pushed over the top.
    """
    figure, (left, middle, right) = panels(3)
    shown = np.linspace(0.03, 0.985, 150)
    left.plot(shown, np.sqrt(0.5 * (1.0 - shown)), color=FAINT, label="bound, proved")
    offsets = [*np.arange(1, 20) / 20, 0.97]
    for mu, look in listed(FRICTIONS):
        line = [least_push(float(one), mu) * math.sqrt(one) for one in offsets]
        left.plot(offsets, line, **look, label=f"*μ* = {mu:g}")
    left.axhline(1.0, color=INK, linewidth=FINE)
    left.text(0.03, 1.03, "flies at the top")
    left.set(xlim=(0, 1), ylim=(0, 1.1), xlabel="offset of the mass centre *h*, *R*")
    left.set_ylabel("least rate at the top, √(*g*/(*Rh*))")
    key(left)
    wide, rates = np.meshgrid(
        np.linspace(0.03, 0.98, 90), np.linspace(0.55, 0.999, 80), indexing="ij"
    )
    ratio = 1.0 / wide - 1.0
    found = lw.simulate_many(
        theta=0.0,
        theta_rate=rates / np.sqrt(wide),
        mass_ratio=ratio,
        offset=1.0,
        inertia=ratio,
        mu_s=0.3,
        mu_k=0.3,
        proof="contact",
        max_transitions=1000,
        threads=2,
    )
    heights = found.jump_height.to_numpy()
    levels = [0.001, 0.01, 0.03, 0.1, 0.3, 0.6, 1.0, 1.5]
    lines = middle.contour(
        wide, rates, np.nan_to_num(heights), levels=levels, colors=[INK], linewidths=FINE
    )
    middle.clabel(lines, fmt="%g")
    middle.set(xlim=(0, 1), ylim=(0.55, 1.0), xlabel="offset of the mass centre *h*, *R*")
    middle.set_ylabel("rate at the top, √(*g*/(*Rh*))")
    middle.set_title("height of the jump, *R*; *μ* = 0.3")
    energies = np.linspace(1.001, 10.0, 200)
    tops = [height(1.0, Body.thin(1.0).earliest(float(energy))) for energy in energies]
    right.plot(energies, tops, color=FAINT, label="bound, proved")
    for (h, look), marker in zip(listed((0.99, 0.7, 0.5, 0.3)), "osD^", strict=True):
        jumps = [
            (energy, float(rolled(Body.thin(np.array([h])), energy, 0.3)[0])) for energy in ENERGIES
        ]
        right.plot(*zip(*jumps, strict=True), marker, color=look["color"], label=f"*h* = {h:g}")
    right.set(xlim=(1, 10.2), ylim=(0, 12), xlabel="energy over *mgR*", xticks=(1, 4, 7, 10))
    right.set_ylabel("height of the jump, *R*")
    key(right, "hoops that roll first, *μ* = 0.3")
    return figure


def hops_picture() -> Figure:
    """How often the published build hops, by the speed at the bottom."""
    figure, axes = panels(2)
    unit = math.sqrt(lw.hoop.STANDARD_GRAVITY * RADIUS)
    speeds = np.arange(2.7, 3.6, 0.02)
    for ax, (mu, restitution) in zip(axes, ((0.4, 0.0), (0.4, 0.6)), strict=True):
        for weight, look in listed((0.051, 0.066)):
            hoop = build(weight, mu, restitution)
            counts = [hops(hoop, speed / unit, 0.005 / RADIUS) for speed in speeds]
            ax.step(speeds, counts, where="mid", **look, label=f"{1000 * weight:.0f} g")
        found = window(mu, restitution, 0.005)
        if found:
            ax.axvspan(
                found[0] - 0.01,
                found[-1] + 0.01,
                color=LINE,
                alpha=0.6,
                linewidth=0,
                label="once and twice",
            )
        ax.set(
            ylim=(0, 9.5),
            xlabel="speed of the centre at the bottom, m/s",
            ylabel="hops higher than 5 mm",
        )
        key(ax, f"*μ* = {mu:g}, *e* = {restitution:g}", columns=3)
    return figure


STUDY = Study(
    name="best-hop",
    texts={
        "attack": lambda: said("best-hop", "angle"),
        "nudges": nudges,
        "bounds": bounds,
        "highest": highest,
        "two turns": two_turns,
        "least of the build": least_of_build,
        "speeds": speeds,
    },
    pictures={"push": push_picture, "hops": hops_picture},
)
