"""Bounces out of nothing: reverse chatter of a loaded hoop on a slope."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass, replace
from functools import cache
from typing import TYPE_CHECKING

import littlewood as lw
import numpy as np
import numpy.typing as npt
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import ACCENTS, CURVE_COLOURS, FINE, INK, PAPER, REGION

from .attacks import said
from .hoops import DEGREE, random_hoops, thin_hoop
from .page import table
from .study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

EXAMPLE = {"h": 0.8, "slope": 35.0 * DEGREE, "mu": 1.0, "e": 0.8}
"""A light hoop with a heavy particle on its rim and a tyre of rubber."""

ANGLES = np.linspace(1e-3, math.pi - 1e-3, 6283)
"""|θ| of the least slopes: they are flat next to their minimum."""


@dataclass(frozen=True)
class Contact:
    """Compliances of a contact point, times the mass, at an angle whose sine is taken positive.

    Parameters
    ----------
    h, kappa : float
        Distance of the mass centre from the centre, and Î/m.
    theta : float or ndarray
        |θ|.
    mu : float
        Friction in slip.
    """

    h: float
    kappa: float
    theta: Array
    mu: float

    @property
    def lever(self) -> Array:
        """1 + h c."""
        return 1.0 + self.h * np.cos(self.theta)

    @property
    def stick(self) -> Array:
        """The friction b = |B|/A that a stick needs in an impact."""
        result: Array = self.h * np.sin(self.theta) * self.lever / (self.kappa + self.lever**2)
        return result

    @property
    def braking(self) -> Array:
        """M = μ A − |B|."""
        result: Array = (self.mu - self.stick) * (1.0 + self.lever**2 / self.kappa)
        return result

    @property
    def slopes(self) -> tuple[Array, Array]:
        """k1 and k2."""
        arm = self.h * np.sin(self.theta)
        c = 1.0 + arm**2 / self.kappa
        b = arm * self.lever / self.kappa
        return c - self.mu * b, c - b * self.stick

    def ratio(self, rho: Array, e: float, law: str) -> Array:
        """Return the ratio of successive bounces at ρ = |a|/w, where a B > 0."""
        k1, k2 = self.slopes
        p = 2.0 * rho / np.where(self.braking > 0.0, self.braking, np.nan)
        gain = 2.0 * self.stick * rho
        early = k1 * p <= 1.0
        if law == "poisson":
            found = np.where(early, e * (1.0 + gain), (1.0 + e) * k2 / k1 - 1.0 - gain)
        else:
            late = (e * e * k2 - (k2 - k1) * (k1 * p - 1.0) ** 2) / k1
            found = np.sqrt(
                np.where(early, e * e * (1.0 + gain * (2.0 - k1 * p)), np.maximum(late, 0.0))
            )
        return np.where((self.braking > 0.0) & (k1 * p < 1.0 + e), found, e)

    def range(self, e: float, law: str) -> tuple[Array, Array]:
        """Return the two ρ between which bounces grow: infinity and zero where they do not."""
        k1, k2 = self.slopes
        gain, braking = k2 - k1, self.braking
        with np.errstate(all="ignore"):
            if law == "poisson":
                grows = e * k2 > k1
                low, high = (1.0 - e) / (e * gain), ((1.0 + e) * k2 / k1 - 2.0) / gain
            else:
                grows = e * e * k2 > k1
                z = np.sqrt((e * e * k2 - k1) / gain)
                low, high = (1.0 - e * e) / (e * gain * (e + z)), (1.0 + z) / k1
            high = np.where(k1 > 0.0, high, np.inf)
        grows = grows & (braking > 0.0)
        return np.where(grows, 0.5 * braking * low, np.inf), np.where(
            grows, 0.5 * braking * high, 0.0
        )


def rim(h: float) -> float:
    """Return Î/m of the thin hoop with the particle on its rim."""
    return 1.0 - h * h


def loaded_disc() -> tuple[float, float]:
    """Return h and Î/m of a disc with half the mass of a particle at ℓ = 0.8 R."""
    h = 0.8 / 1.5
    return h, (0.25 + 0.5 * h * h + (0.8 - h) ** 2) / 1.5


BODIES = {
    "rim hoop, h = 0.5": (0.5, rim(0.5)),
    "rim hoop, h = 0.8": (0.8, rim(0.8)),
    "rim hoop, h = 0.95": (0.95, rim(0.95)),
    "loaded disc": loaded_disc(),
}


def least_slope(
    h: float, kappa: float, mu: float, e: float, law: str = "energetic"
) -> tuple[float, float]:
    """Return the least slope on which bounces grow out of rest, and |θ| there.

    There ρ = tan α at rest.
    """
    low, _ = Contact(h, kappa, ANGLES, mu).range(e, law)
    best = int(np.argmin(low))
    return math.atan(float(low[best])), float(ANGLES[best])


def equilibrium_grows(
    h: float, kappa: float, slope: float, mu: float, e: float, *, stable: bool
) -> bool:
    """Whether bounces grow (energetic law) out of an equilibrium, which static friction holds."""
    turned = math.asin(math.sin(slope) / h)
    theta = math.pi + turned - slope if stable else -turned - slope
    low, high = Contact(h, kappa, np.array([abs(math.remainder(theta, 2.0 * math.pi))]), mu).range(
        e, "energetic"
    )
    return math.tan(slope) <= mu and float(low[0]) < math.tan(slope) < float(high[0])


def equilibrium_range(
    h: float, kappa: float, mu: float, e: float, *, stable: bool
) -> tuple[float, float] | None:
    """Return the slopes between which bounces grow out of an equilibrium, if there are any."""
    slopes = np.linspace(1e-3, math.asin(h) - 1e-6, 4001)
    inside = [s for s in slopes if equilibrium_grows(h, kappa, float(s), mu, e, stable=stable)]
    return (float(inside[0]), float(inside[-1])) if inside else None


def least() -> str:
    """The least slope of the hoop of the pictures."""
    slope, _ = least_slope(EXAMPLE["h"], rim(EXAMPLE["h"]), EXAMPLE["mu"], EXAMPLE["e"])
    return f"on slopes from {slope / DEGREE:.1f}° on"


def equilibria() -> list[str]:
    """Slopes on which an equilibrium is not the only motion."""
    rows = []
    for name, (h, kappa) in BODIES.items():
        cells = []
        for stable in (False, True):
            found = equilibrium_range(h, kappa, 1.0, 0.9, stable=stable)
            cells.append(
                "none" if found is None else f"{found[0] / DEGREE:.1f} to {found[1] / DEGREE:.1f}"
            )
        rows.append([name, *cells, f"{min(math.asin(h), math.atan(1.0)) / DEGREE:.1f}"])
    return table(["", "unstable, °", "stable, °", "equilibria to, °"], rows)


def hoop_on(slope: float, hoop: lw.Hoop, e: float, law: str) -> lw.Hoop:
    """Return the same hoop on a slope, with restitution."""
    return replace(hoop, slope=slope, restitution=e, restitution_law=law)


@cache
def survey() -> Counter[str]:
    """Counts of rolling states of random hoops on slopes, by the formulas and by the library."""
    counts: Counter[str] = Counter()
    for hoop, random in random_hoops(35, 4000):
        law = str(random.choice(["energetic", "poisson"]))
        e, slope = random.uniform(0.3, 0.95), random.uniform(-1.3, 1.3)
        bouncing = hoop_on(slope, hoop, e, law)
        for theta, rate in zip(
            random.uniform(-math.pi, math.pi, 8), random.uniform(-1.5, 1.5, 8), strict=True
        ):
            found = bouncing.classify(theta=theta, theta_rate=rate)
            if found.region != "rolling_region":
                continue
            counts["rolling"] += 1
            sine, u = math.sin(theta), rate * rate
            drift = -hoop.h * sine * u - math.sin(slope)
            weight = math.cos(slope) - hoop.h * math.cos(theta) * u
            if drift * sine <= 0.0:
                counts["no drift"] += 1
                counts["wrong"] += found.reverse_chatter is not None
                continue
            kappa = hoop.inertia_about_mass_centre / hoop.mass
            contact = Contact(hoop.h, kappa, np.array([abs(theta)]), hoop.mu_k)
            ratio = float(contact.ratio(np.array([abs(drift) / weight]), e, law)[0])
            counts["above e"] += e * (1.0 + 1e-12) < ratio < 1.0
            counts["grows"] += ratio > 1.0
            near = abs(ratio - 1.0) < 1e-9
            counts["wrong"] += not near and (found.reverse_chatter is not None) != (ratio > 1.0)
            if found.reverse_chatter is not None:
                counts["wrong"] += abs(found.rolling_friction) > hoop.mu_k * found.rolling_normal
    return counts


def counted() -> str:
    """The survey as a sentence."""
    found = survey()
    return (
        f"of {found['rolling']} rolling states of random hoops on slopes up to 74°, e from 0.3 to "
        "0.95, "
        f"{found['grows']} grow, {found['above e']} have a ratio between e and 1, "
        f"and {found['wrong']} differ from the program"
    )


def example(law: str = "energetic", e: float | None = None) -> lw.Hoop:
    """Return the hoop of the pictures."""
    hoop = thin_hoop(EXAMPLE["h"], mu_k=EXAMPLE["mu"])
    return hoop_on(EXAMPLE["slope"], hoop, EXAMPLE["e"] if e is None else e, law)


def saddle() -> float:
    """Return θ of its unstable equilibrium."""
    return -math.asin(math.sin(EXAMPLE["slope"]) / EXAMPLE["h"]) - EXAMPLE["slope"]


def out_of(
    hoop: lw.Hoop, theta: float, theta_rate: float, gap_rate: float, bounces: int
) -> tuple[Array, Array]:
    """Return the times of the bounces out of a state, and the rate of the gap after each."""
    motion = hoop.simulate(
        theta=theta, theta_rate=theta_rate, gap_rate=gap_rate, max_transitions=bounces
    )
    hits = [
        (one.state.time, one.impact.after.gap_rate)
        for one in motion.transitions
        if one.impact is not None
    ]
    times, rates = zip(*hits, strict=True)
    return np.array(times), np.array(rates)


SEEN = 1e-3
"""Rate of the gap at which motions out of nothing are compared."""


def state_seen(share: float, generations: int) -> tuple[float, float, float]:
    """Return θ, θ′ and the gap rate after the first bounce beyond `SEEN`.

    It is thrown with Λ^(share − generations) of it.
    """
    hoop, theta = example(), saddle()
    ratio = hoop.classify(theta=theta, theta_rate=0.0).reverse_chatter
    assert ratio is not None
    motion = hoop.simulate(
        theta=theta,
        theta_rate=0.0,
        gap_rate=SEEN * ratio ** (share - generations),
        max_transitions=generations + 20,
    )
    for one in motion.transitions:
        if one.impact is not None and one.impact.after.gap_rate > SEEN:
            return one.after.theta, one.after.theta_rate, one.impact.after.gap_rate
    raise ValueError("the bounces do not grow")


def ratios() -> str:
    """The ratio of the example in its unstable equilibrium, by two laws."""
    by = {
        law: example(law).classify(theta=saddle(), theta_rate=0.0).reverse_chatter
        for law in ("energetic", "poisson")
    }
    return f"{by['energetic']:.3f} by the energetic law and {by['poisson']:.3f} by Poisson's"


def plane() -> Figure:
    """The region in the phase plane, and the least slopes."""
    figure, axes = panels(2)
    hoop = example()
    theta, rate = np.meshgrid(np.linspace(-math.pi, 0.0, 500), np.linspace(-1.6, 1.6, 400))
    portrait = hoop.phase_plane
    rolls = portrait.in_rolling_region(theta, rate)
    ratio = portrait.reverse_chatter(theta, rate)
    left = axes[0]
    left.contourf(
        theta / DEGREE, rate, np.where(rolls, 1.0, 0.0), levels=[0.5, 1.5], colors=[REGION]
    )
    known = np.where(np.isnan(ratio), 0.0, ratio)
    tints = [(ACCENTS["violet"], depth) for depth in (0.3, 0.55, 0.85)]
    left.contourf(theta / DEGREE, rate, known, levels=[1.0, 1.1, 1.2, 10.0], colors=tints)
    left.contour(
        theta / DEGREE,
        rate,
        known,
        levels=[1.0],
        colors=[CURVE_COLOURS["chatter"]],
        linestyles="dotted",
    )
    for one in portrait.equilibria:
        angle = one.theta - 2.0 * math.pi if one.theta > 0.0 else one.theta
        stable = one.stability == "stable"
        left.plot(
            angle / DEGREE,
            0.0,
            "o",
            color=INK,
            markerfacecolor=INK if stable else PAPER,
            label=f"{one.stability} equilibrium",
        )
    left.fill_between([], [], color=REGION, label="can roll")
    left.plot([], [], color=CURVE_COLOURS["chatter"], linestyle="dotted", label="growth = 1")
    for tint, growth in zip(tints, (1, 1.1, 1.2), strict=True):
        left.fill_between([], [], color=tint, linewidth=0, label=f"growth ≥ {growth}")
    left.set(xlabel="*θ*, degrees", ylabel="*θ*′, √(*g*/*R*)", xticks=range(-180, 1, 45))
    key(left)
    right = axes[1]
    e = np.linspace(0.4, 0.995, 60)
    for (name, (h, kappa)), look in listed(list(BODIES.items())):
        least = [least_slope(h, kappa, 1.0, float(one))[0] / DEGREE for one in e]
        right.plot(
            e,
            np.where(np.array(least) < 89.9, least, np.nan),
            **look,
            label=name.replace("h =", "*h* ="),
        )
    shown = EXAMPLE["e"], EXAMPLE["slope"] / DEGREE
    right.plot(*shown, "D", color=INK, label="hoop of (a)")
    right.set(xlabel="*e*", ylabel="least slope, degrees", ylim=(0, 75))
    key(right)
    return figure


def motions() -> Figure:
    """Three motions out of one rest."""
    figure, axes = panels(2)
    hoop, theta = example(), saddle()
    ratio = hoop.classify(theta=theta, theta_rate=0.0).reverse_chatter
    assert ratio is not None
    left, right = axes
    for share, look in listed([0.0, 1.0 / 3.0, 2.0 / 3.0]):
        thrown = 1e-9 * ratio**share
        times, rates = out_of(hoop, theta, 0.0, thrown, 300)
        landings, openings = np.concatenate([[0.0], times]), np.concatenate([[thrown], rates])
        clock, gap = [], []
        for begin, end, rate in zip(landings[:-1], landings[1:], openings[:-1], strict=True):
            if 0.35 < end and begin < 1.3:
                s = np.linspace(0.0, 1.0, 20)
                clock.extend(begin + s * (end - begin))
                gap.extend(rate * s * (1.0 - s) * (end - begin))
        left.plot(clock, np.array(gap) * 1e3, **look, label=f"{thrown * 1e9:.3g}")
        if share == 0.0:
            right.loglog(times, rates, "o", color=look["color"], markersize=2.2, label="bounces")
    line = np.array([1e-9, 20.0])
    weight = math.cos(hoop.slope)
    right.loglog(
        line,
        0.5 * weight * (ratio - 1.0) * line,
        color=INK,
        linewidth=FINE,
        label="proportional to *τ*",
    )
    left.set(xlim=(0.35, 1.3), ylim=(0, None), xlabel="*τ*, √(*R*/*g*)", ylabel="gap, *R*/1000")
    key(left, "gap rate at the start, 10^{−9}√(*gR*)", columns=3)
    right.set(
        xlim=(1e-8, 20),
        ylim=(1e-9, 1),
        xlabel="*τ*, √(*R*/*g*)",
        ylabel="gap rate after a bounce, √(*gR*)",
    )
    key(right)
    return figure


STUDY = Study(
    name="bounces-out-of-nothing",
    texts={
        "attack": lambda: said("bounces-out-of-nothing", "ratio"),
        "survey": counted,
        "least": least,
        "equilibria": equilibria,
        "ratios": ratios,
    },
    pictures={"plane": plane, "motions": motions},
)
