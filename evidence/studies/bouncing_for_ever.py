"""Bouncing for ever: the motions with e = 1 that turn or rock.

Their stability, and what losses do.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels, power
from littlewood.style import ACCENTS, ARROW_COLOURS, CURVE, FAINT, FINE, HATCH, INK
from matplotlib.figure import Figure

from .attacks import said
from .hoops import DEGREE, random_hoops, thin_hoop
from .page import table
from .roots import zero
from .study import Study

Matrix = list[list[Any]]


@dataclass(frozen=True)
class Orbit:
    """A motion that bounces for ever; everything is for a unit of the total mass.

    The numbers may be of any kind that has arithmetic: floats, arrays, fractions, balls.

    Parameters
    ----------
    arm : number
        a = h sin φ.
    lever : number
        L = 1 + h cos φ.
    alpha : number
        α = 1 − ja, j the jump of the rate over that of the gap.
    rate : number
        ω1, the rate of the flight over the top.
    gap_rate : number
        v, the rate of the gap after each impact.
    rough : bool
        Whether the impacts stick; if not, there is no friction at all.
    """

    arm: Any
    lever: Any
    alpha: Any
    rate: Any
    gap_rate: Any
    rough: bool = True

    @property
    def kappa(self) -> Any:
        """j: an impact that meets the plane at the rate v turns ω into ω + jv."""
        return (1 - self.alpha) / self.arm

    @property
    def inertia(self) -> Any:
        """Inertia about the point that an impact holds: D/m, or Î/m + a² without friction."""
        return 2 * self.arm / self.kappa

    @property
    def second_rate(self) -> Any:
        """ω2, the rate of the flight under the bottom."""
        return self.rate + self.kappa * self.gap_rate

    @property
    def friction(self) -> Any:
        """Coefficient of friction that sticking in the impacts needs."""
        return self.arm * self.lever / (self.inertia - self.arm * self.arm)

    @property
    def halves(self) -> tuple[Any, Any]:
        """Half the angles of the two flights, φ and π − φ, by the equations of the motion."""
        first = self.rate * (self.gap_rate + self.arm * self.rate)
        return first, self.second_rate * (self.gap_rate - self.arm * self.second_rate)

    @property
    def energy(self) -> Any:
        """Energy after an impact over m g R."""
        kinetic = self.inertia * self.rate * self.rate + self.gap_rate * self.gap_rate
        return kinetic / 2 + self.arm * self.rate * self.gap_rate + self.lever - 1

    @property
    def slope_of_kappa(self) -> Any:
        """dj/dφ."""
        c = self.lever - 1
        square = self.kappa * self.kappa
        return self.kappa * c / self.arm + (square if self.rough else -square * c)

    @property
    def tangent(self) -> tuple[Any, Any]:
        """dω1/dφ and dv/dφ along the family of the hoop."""
        a, c, w, v = self.arm, self.lever - 1, self.rate, self.gap_rate
        w2, k, slope = self.second_rate, self.kappa, self.slope_of_kappa
        # The derivatives of ω1 (v + a ω1) = φ and of ω2 (v − a ω2) = π − φ, two linear equations.
        p, q, r = v + 2 * a * w, w, 1 - c * w * w
        s = v - 2 * a * w2
        t, u = s * k + w2, c * w2 * w2 - 1 - s * slope * v
        determinant = p * t - q * s
        return (r * t - q * u) / determinant, (p * u - s * r) / determinant

    @property
    def energy_slope(self) -> Any:
        """dE/dφ over m g R along the family."""
        a, c, w, v = self.arm, self.lever - 1, self.rate, self.gap_rate
        dw, dv = self.tangent
        # Of the inertia: D has 2h cos φ in it, and the smooth one a².
        change = -2 * a if self.rough else 2 * a * c
        return (
            change * w * w / 2
            + self.inertia * w * dw
            + c * w * v
            + a * (dw * v + w * dv)
            + v * dv
            - a
        )

    @property
    def tilt(self) -> Any:
        """Γ: zero where impacts not opposite to each other fit, too, in the first order."""
        c = self.lever - 1
        share = (1 - self.alpha + 2 * c) / (1 + self.alpha) if self.rough else c
        first, second = self.halves
        return self.arm * self.arm + share * first * second / (self.rate * self.second_rate)

    @property
    def determinant(self) -> Any:
        """ζ1 ζ2."""
        if not self.rough:
            return 1
        pull = 2 * self.friction
        first, second = self.halves
        over = 1 - pull * first * first / (self.rate * self.gap_rate)
        return over * (1 + pull * second * second / (self.second_rate * self.gap_rate))

    @property
    def product(self) -> Any:
        """(1 − ζ1)(1 − ζ2)."""
        a, alpha, v = self.arm, self.alpha, self.gap_rate
        squares = self.rate * self.rate + self.second_rate * self.second_rate
        size = a * a * squares + alpha * (1 - alpha) * v * v
        return 8 * alpha * (1 - alpha) * size / (a * a * a * v * v) * self.tilt * self.energy_slope

    @property
    def margin(self) -> Any:
        """Positive where both multipliers are inside the unit circle.

        Or on it without friction, and not at ±1.
        """
        q, d = self.product, self.determinant
        inner = np.minimum(q, 2 * (1 + d) - q)
        return np.minimum(inner, 1 - d) if self.rough else inner

    @property
    def multipliers(self) -> tuple[complex, complex]:
        """ζ1 and ζ2: what a disturbance is multiplied by in a turn.

        Beside them is the 1 of the family itself.
        """
        d = self.determinant
        half = 0.5 * (1.0 + d - self.product)
        root = cmath.sqrt(half * half - d)
        return half + root, half - root

    @property
    def decay(self) -> Any:
        """Energy over m g R that a turn loses, over 1 − e, for small losses."""
        return (1 + self.alpha) * self.gap_rate * self.gap_rate

    def turn(self) -> Matrix:
        """Return the derivative of a turn.

        From (θ, θ′, v) after an impact at −φ to that after the next there.
        """
        top, bottom = self.flight(first=True), self.flight(first=False)
        return product(self.impact(-1), product(bottom, product(self.impact(1), top)))

    def flight(self, *, first: bool) -> Matrix:
        """Return the derivative of a flight, and of the loss of slip at its end.

        It goes over the top or under the bottom.
        """
        c, v = self.lever - 1, self.gap_rate
        begin, w = (-self.arm, self.rate) if first else (self.arm, self.second_rate)
        end = -begin
        time = 2 * (v + end * w)
        arms = end - begin
        # The end of the flight, from the gap, which is zero there, and closes with v.
        late = [(arms - c * w * time) / v, arms * time / v, time / v]
        angle = [1 + w * late[0], time + w * late[1], w * late[2]]
        opening = [
            c * w * (angle[0] - 1) - late[0],
            arms + c * w * angle[1] - late[1],
            1 + c * w * angle[2] - late[2],
        ]
        slip = [-w * (end * angle[0] - begin), -w * end * angle[1], -w * end * angle[2]]
        pull = self.friction / self.arm if self.rough else 0
        rate = [-pull * slip[0], 1 - pull * slip[1], -pull * slip[2]]
        return [
            angle,
            rate,
            [one - end * pull * other for one, other in zip(opening, slip, strict=True)],
        ]

    def impact(self, side: int) -> Matrix:
        """Return the derivative of an impact without slip, at φ (side 1) or −φ."""
        return [[1, 0, 0], [self.slope_of_kappa * self.gap_rate, 1, -side * self.kappa], [0, 0, -1]]


def product(left: Matrix, right: Matrix) -> Matrix:
    """Return the product of two matrices of any numbers."""
    columns = list(zip(*right, strict=True))
    return [
        [sum(x * y for x, y in zip(row, column, strict=True)) for column in columns] for row in left
    ]


def family(h: Any, gyration: Any, angle: Any, *, rough: bool = True) -> Orbit:
    """Return the motions of hoops with impacts at ±φ, NaN where there are none.

    Parameters
    ----------
    h : float or ndarray
        Distance of the mass centre from the centre.
    gyration : float or ndarray
        Î/m, the square of the radius of gyration about the mass centre.
    angle : float or ndarray
        φ.
    rough : bool, optional
        Whether the impacts stick; if not, there is no friction.
    """
    arm, lever = h * np.sin(angle), 1.0 + h * np.cos(angle)
    inertia = gyration + arm * arm + (lever * lever if rough else 0.0)
    kappa = 2.0 * arm / inertia
    alpha = 1.0 - kappa * arm
    square, linear = arm * alpha * (1.0 + alpha), math.pi - 2.0 * alpha * alpha * angle
    constant = alpha * kappa * angle * angle
    with np.errstate(invalid="ignore", divide="ignore"):
        root = np.sqrt(linear * linear + 4.0 * square * constant)
        top = np.sqrt(
            np.where(
                linear > 0.0, 2.0 * constant / (linear + root), (root - linear) / (2.0 * square)
            )
        )
        fits = (alpha > 0.0) & (angle / top > 2.0 * np.sqrt(h) * np.sin(0.5 * angle))
        rate = np.where(fits, top, np.nan)
        return Orbit(arm, lever, alpha, rate, angle / rate - arm * rate, rough)


def orbit(h: float, gyration: float, angle: float, *, rough: bool = True) -> Orbit | None:
    """Return one motion of the family in floats, or None."""
    found = family(h, gyration, angle, rough=rough)
    if not math.isfinite(found.rate):
        return None
    arm, lever, alpha = float(found.arm), float(found.lever), float(found.alpha)
    return Orbit(arm, lever, alpha, float(found.rate), float(found.gap_rate), rough)


def rocking(h: float, gyration: float, angle: float, *, rough: bool = True) -> Orbit:
    """Return the motion that rocks under the bottom between impacts at φ and 2π − φ.

    Its two rates are opposite.
    """
    arm, lever = h * math.sin(angle), 1.0 + h * math.cos(angle)
    rest = gyration + (lever * lever if rough else 0.0)
    inertia = rest + arm * arm
    rate = math.sqrt((math.pi - angle) * arm / rest)
    return Orbit(arm, lever, 1.0 - 2.0 * arm * arm / inertia, -rate, rate * inertia / arm, rough)


def rocked(motion: Orbit) -> Matrix:
    """Return the derivative of a half period of rocking.

    From after an impact to the mirror image of the next.
    """
    mirror: Matrix = [[-1, 0, 0], [0, -1, 0], [0, 0, 1]]
    return product(mirror, product(motion.impact(-1), motion.flight(first=False)))


def smooth_rocking(h: float) -> list[float]:
    """Return the angles at which rocking of a thin hoop gains or loses stability.

    Without friction.
    """

    def margin(angle: float) -> float:
        half = rocked(rocking(h, thin(h), angle, rough=False))
        return 2.0 - abs(float(half[0][0] + half[1][1] + half[2][2]) - 1.0)

    angles = [float(angle) for angle in np.linspace(0.01, math.pi - 0.01, 600)]
    signs = [margin(angle) > 0.0 for angle in angles]
    places = [i for i in range(len(angles) - 1) if signs[i] != signs[i + 1]]
    return [zero(margin, angles[i], angles[i + 1]) for i in places]


def thin(h: Any) -> Any:
    """Return Î/m of a thin hoop with the particle on its rim."""
    return 1.0 - h * h


@cache
def stable(h: float, *, rough: bool = True) -> tuple[tuple[float, float], ...]:
    """Return the intervals of φ whose motions are stable for a thin hoop, to the last digits."""
    angles: Any = np.linspace(0.02, math.pi - 0.02, 4000)
    grid = family(h, thin(h), angles, rough=rough)
    borders = []
    # A simple zero of Γ or dE/dφ borders a stable interval where |ζ1 ζ2| < 1, which may be narrower
    # than the grid.
    for name in ("tilt", "energy_slope"):
        values = getattr(grid, name)

        def value(angle: float, name: str = name) -> float:
            return float(getattr(family(h, thin(h), angle, rough=rough), name))

        for step in np.nonzero(values[1:] * values[:-1] < 0.0)[0]:
            border = zero(value, float(angles[step]), float(angles[step + 1]))
            borders += [border - 1e-6, border + 1e-6]
    angles = np.sort(np.concatenate([angles, borders]))
    margins = family(h, thin(h), angles, rough=rough).margin
    inside = np.nan_to_num(margins, nan=-1.0) > 0.0

    def margin(angle: float) -> float:
        found = orbit(h, thin(h), angle, rough=rough)
        return -1.0 if found is None else float(found.margin)

    steps = np.nonzero(inside[1:] != inside[:-1])[0]
    ends = [zero(margin, float(angles[step]), float(angles[step + 1])) for step in steps]
    return tuple(zip(ends[::2], ends[1::2], strict=True))


def life(h: float, low: float, high: float) -> float:
    """Return the turns times 1 − e in which small losses take a thin hoop to another angle."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    angles = 0.5 * (low + high) + 0.5 * (high - low) * nodes
    orbits = family(h, thin(h), angles)
    return float(abs(0.5 * (high - low) * np.sum(weights * orbits.energy_slope / orbits.decay)))


def random_orbits(seed: int, count: int) -> Iterator[tuple[lw.Hoop, Orbit, float]]:
    """Yield random hoops with a motion that bounces for ever, and its angle.

    They are rough enough, and e = 1.
    """
    for drawn, random in random_hoops(seed, count):
        angle = random.uniform(0.3, 2.9)
        found = orbit(drawn.h, drawn.inertia_about_mass_centre / drawn.mass, angle)
        if found is None or abs(found.friction) > 5.0:
            continue
        mu = found.friction + 0.2
        yield (
            replace(drawn, mu_s=mu, mu_k=mu, restitution=1.0, restitution_law="energetic"),
            found,
            angle,
        )


def after_turn(
    hoop: lw.Hoop, theta: float, rate: float, gap_rate: float, slip: float = 0.0
) -> list[float]:
    """Return θ, θ′ and the rate of the gap after two impacts, as the library simulates them."""
    motion = hoop.simulate(
        theta=theta, theta_rate=rate, gap_rate=gap_rate, slip=slip, max_transitions=2
    )
    last = motion.transitions[1]
    assert last.impact is not None
    return [
        last.after.theta - 2.0 * math.pi,
        last.impact.after.theta_rate,
        last.impact.after.gap_rate,
    ]


def differences(hoop: lw.Hoop, motion: Orbit, angle: float, step: float = 1e-7) -> Matrix:
    """Return the derivative of a turn by central differences of simulated motions.

    The step is small because the second derivatives of an impact jump where the slip changes its
    sign.
    """
    start = [-angle, motion.rate, motion.gap_rate]
    columns = []
    for i in range(3):
        ahead, back = list(start), list(start)
        size = step * (1.0 if i == 0 else start[i])
        ahead[i] += size
        back[i] -= size
        pairs = zip(after_turn(hoop, *ahead), after_turn(hoop, *back), strict=True)
        columns.append([(x - y) / (2.0 * size) for x, y in pairs])
    return [list(row) for row in zip(*columns, strict=True)]


def derivative_error(seed: int, count: int) -> list[float]:
    """Return how far derivatives of random motions are from differences.

    Over their largest element.
    """
    found = []
    for hoop, motion, angle in random_orbits(seed, count):
        exact: Any = np.array(motion.turn())
        measured: Any = np.array(differences(hoop, motion, angle))
        found.append(float(np.max(np.abs(exact - measured)) / np.max(np.abs(exact))))
    return found


@dataclass(frozen=True)
class Drift:
    """What a motion with small losses does: the turns, and the mean angle of the impacts of each.

    Parameters
    ----------
    turns, angles : ndarray
        Of each turn, its number and half the angle between its impacts.
    """

    turns: Any
    angles: Any

    def at(self, turn: float) -> float:
        """Return the angle after a number of turns."""
        return float(np.interp(turn, self.turns, self.angles))


@cache
def drift(h: float, angle: float, loss: float, turns: int) -> Drift:
    """Return the simulated motion of a thin hoop with e = 1 − loss.

    It starts as a motion that bounces for ever.
    """
    hoop = thin_hoop(h, mu_k=0.5, restitution=1.0 - loss)
    begin = orbit(h, thin(h), angle)
    assert begin is not None
    motion = hoop.simulate(
        theta=-angle, theta_rate=begin.rate, gap_rate=begin.gap_rate, max_transitions=2 * turns + 2
    )
    places = np.array([one.state.theta for one in motion.transitions if one.cause == "landing"])
    # Half of what the hoop turns over the top: also right where the two impacts are not opposite.
    tops = 0.5 * (places[2::2] - places[1:-1:2])
    return Drift(np.arange(1, len(tops) + 1), tops)


def expected_turns(h: float, begin: float, end: float) -> Callable[[float], float]:
    """Return the turns times 1 − e until the losses have brought a motion to an angle.

    As a function of the angle.
    """
    angles = np.linspace(begin, end, 400)
    orbits = family(h, thin(h), angles)
    rates = np.abs(orbits.energy_slope / orbits.decay)
    steps = 0.5 * (rates[1:] + rates[:-1]) * np.abs(np.diff(angles))
    sums = np.concatenate([[0.0], np.cumsum(steps)])
    order = np.argsort(angles)
    return lambda angle: float(np.interp(angle, angles[order], sums[order]))


def agreement() -> str:
    """How well the derivative agrees with differences of simulated motions."""
    errors = np.sort(derivative_error(2026, 400))
    return (
        f"{len(errors)} random hoops and motions: half of them to {errors[len(errors) // 2]:.0e} "
        "of the largest "
        f"element, all to {errors[-1]:.0e}"
    )


def spans(bands: Iterable[tuple[float, float]], digits: int) -> Iterator[str]:
    """Yield intervals in degrees, with more digits where the ends would look alike."""
    for low, high in bands:
        shown = digits
        while f"{low / DEGREE:.{shown}f}" == f"{high / DEGREE:.{shown}f}":
            shown += 1
        yield f"{low / DEGREE:.{shown}f}–{high / DEGREE:.{shown}f}"


def bands() -> list[str]:
    """Where motions of thin hoops are stable: by h, the intervals with friction and life."""
    rows = []
    for h in (0.1, 0.3, 0.5, 0.7, 0.9):
        smooth = "; ".join(spans(stable(h, rough=False), 1))
        for place, (low, high) in enumerate(stable(h)):
            friction = float(np.max(family(h, thin(h), np.linspace(low, high, 200)).friction))
            rows.append(
                [
                    f"{h:g}" if place == 0 else "",
                    next(spans([(low, high)], 2)),
                    f"{friction:.3f}",
                    f"{life(h, low, high):.2g}",
                    smooth if place == 0 else "",
                ]
            )
    return table(
        ["h", "stable, rough: φ, °", "friction needed", "turns × (1 − e)", "stable, smooth: φ, °"],
        rows,
    )


def rocks() -> str:
    """The motion of the hoop of Figure 2 that rocks."""
    found = rocking(0.5, 0.75, 2.0)
    return (
        f"θ′ = ±{found.second_rate:.5f}, v = {found.gap_rate:.5f} and a friction of "
        f"{found.friction:.4f} or more"
    )


def rocking_text() -> str:
    """Where thin hoops rock stably without friction."""
    parts = []
    for h in (0.1, 0.5, 0.9):
        ends = [*smooth_rocking(h), math.pi]
        parts.append(
            f"{' and '.join(spans(zip(ends[::2], ends[1::2], strict=True), 1))} (h = {h:g})"
        )
    return f"φ = {', '.join(parts)} degrees"


ENDS = {0.5: (2.22, 1), 0.3: (1.85, 0)}
"""For some h: an angle within the stable interval, and to which of its ends losses drive it."""

LOSSES = (1e-3, 1e-4, 1e-5)


def followed(h: float, loss: float) -> tuple[Drift, Callable[[float], float], float, float]:
    """Return a drift, the law for it, and the angles between which it goes."""
    begin, side = ENDS[h]
    end = stable(h)[0][side]
    law = expected_turns(h, begin, end)
    return drift(h, begin, loss, int(1.25 * law(end) / loss) + 2), law, begin, end


STABLE = (ACCENTS["violet"], 0.6)


def regions_picture() -> Figure:
    """Where motions are stable, for rough and for smooth thin hoops."""
    figure, axes = panels(2, height=400.0)
    h, angle = np.meshgrid(
        np.linspace(0.003, 0.997, 500), np.linspace(0.01, math.pi - 0.01, 700), indexing="ij"
    )
    degrees = angle / DEGREE
    for ax, rough, name in zip(
        axes, (True, False), ("rough: impacts stick", "smooth: no friction"), strict=True
    ):
        orbits = family(h, thin(h), angle, rough=rough)
        none = np.isnan(orbits.rate)
        firm = (np.nan_to_num(orbits.margin, nan=-1.0) > 0.0).astype(float)
        ax.contourf(
            degrees, h, none.astype(float), levels=[0.5, 1.5], colors="none", hatches=["////"]
        )
        ax.contourf(degrees, h, firm, levels=[0.5, 1.5], colors=[STABLE])
        ax.contour(degrees, h, orbits.energy_slope, levels=[0.0], colors=[INK])
        ax.contour(degrees, h, orbits.tilt, levels=[0.0], colors=[INK], linestyles="dashed")
        flip = 2.0 * (1.0 + orbits.determinant) - orbits.product
        ax.contour(degrees, h, flip, levels=[0.0], colors=[INK], linestyles="dotted")
        if rough:
            friction = np.where(none, np.nan, orbits.friction)
            lines = ax.contour(
                degrees,
                h,
                friction,
                levels=[0.1, 0.3, 0.6],
                colors=[ARROW_COLOURS["friction_force"]],
            )
            ax.clabel(lines, fmt=lambda mu: f"{mu:g}", manual=[(45, 0.25), (70, 0.55), (85, 0.8)])
            ax.plot([], [], color=ARROW_COLOURS["friction_force"], label="*μ* that it needs")
        ax.set(
            xlim=(0, 180),
            ylim=(0, 1),
            xlabel="angle of the impacts *φ*, degrees",
            xticks=range(0, 181, 30),
        )
        for style, label in (
            ("solid", "d*E*/d*φ* = 0"),
            ("dashed", "*Γ* = 0"),
            ("dotted", "*ζ* = −1"),
        ):
            ax.plot([], [], color=INK, linestyle=style, label=label)
        ax.fill_between([], [], color=STABLE, label="stable")
        ax.fill_between(
            [],
            [],
            facecolor="none",
            edgecolor=HATCH,
            hatch="////",
            linewidth=0,
            label="no such motion",
        )
        ax.set_ylabel("offset of the mass centre *h*, *R*")
        key(ax, name, columns=3)
    return figure


def losses_picture() -> Figure:
    """Multipliers and energy along the family, and what losses do."""
    figure, (left, middle, right) = panels(3)
    angles = np.linspace(0.5, 2.7, 1200)
    for h, look in listed((0.1, 0.3, 0.5, 0.6)):
        orbits = family(h, thin(h), angles)
        half = 0.5 * (1.0 + orbits.determinant - orbits.product)
        root = np.sqrt(half * half - orbits.determinant + 0j)
        largest = np.maximum(abs(half + root), abs(half - root))
        left.semilogy(angles / DEGREE, largest, **look, label=f"*h* = {h:g}")
        middle.plot(angles / DEGREE, orbits.energy, **look, label=f"*h* = {h:g}")
        for low, high in stable(h):
            firm = np.linspace(low, high, 50)
            middle.plot(
                firm / DEGREE,
                family(h, thin(h), firm).energy,
                color=look["color"],
                linewidth=4.0 * CURVE,
                alpha=0.45,
            )
    left.axhline(1.0, color=INK, linewidth=FINE)
    left.set(
        xlim=(28, 150),
        ylim=(0.2, 200),
        ylabel="largest multiplier |*ζ*|",
        xticks=range(30, 151, 30),
    )
    middle.plot([], [], color=FAINT, linewidth=4.0 * CURVE, label="stable")
    middle.set(
        xlim=(60, 150), ylim=(1, 8), ylabel="energy *E* over *mgR*", xticks=range(60, 151, 30)
    )
    for axes in (left, middle):
        axes.set_xlabel("angle of the impacts *φ*, degrees")
        key(axes, columns=3)
    for (loss, look), marker in zip(listed(LOSSES), "sDo", strict=True):
        found, law, begin, end = followed(0.5, loss)
        right.plot(
            found.turns * loss,
            found.angles / DEGREE,
            marker,
            color=look["color"],
            markersize=2.5,
            label=power(loss),
        )
    shown = np.linspace(begin, end, 200)
    right.plot([law(angle) for angle in shown], shown / DEGREE, color=INK, label="law")
    right.set(xlim=(0, 1.25 * law(end)), ylim=(126, 138), xlabel="turns × (1 − *e*)")
    right.set_ylabel("angle of the impacts *φ*, degrees")
    key(right, "1 − *e*")
    return figure


STUDY = Study(
    name="bouncing-for-ever",
    texts={
        "attack": lambda: said("bouncing-for-ever", "turning"),
        "agreement": agreement,
        "bands": bands,
        "rocks": rocks,
        "rocking": rocking_text,
    },
    pictures={"regions": regions_picture, "losses": losses_picture},
)
