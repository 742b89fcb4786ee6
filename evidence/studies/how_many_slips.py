"""How many slips: the laws at and near equal coefficients of friction."""

from __future__ import annotations

import math
from functools import cache

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import FAINT, FINE, INK
from matplotlib.figure import Figure

from .attacks import said
from .contact import Contact
from .grazing import Grazing, grazing_orbits
from .hoops import thin_hoop
from .study import Study

ROLLS = next(code for code, name in lw.tables.OUTCOMES.items() if name == "rolls_forever")


EXAMPLES = (
    ("Figure 2", 0.5, 0.5),
    ("heavy hoop", 0.25, 0.2),
    ("light hoop", 0.75, 0.7),
    ("small offset", 0.1, 0.2),
)
"""Names, h and μ of thin hoops with the particle on the rim."""


def bottom_rate(hoop: lw.Hoop, energy: float) -> float:
    """Return θ′ at the bottom on the orbit of rolling with an energy."""
    contact = Contact.of(hoop)
    return math.sqrt(2.0 * (energy + contact.m * contact.h) / contact.denominator(math.pi))


def counted(hoop: lw.Hoop, energy: float) -> int:
    """Return the number of slips of a motion that rolls and slips in turn.

    It starts at the bottom, and rolls in the end.
    """
    result = lw.simulate_many(
        hoop,
        theta=math.pi,
        theta_rate=bottom_rate(hoop, energy),
        max_transitions=10_000_000,
        threads=1,
    )
    name = str(lw.sequence_names(result.sequence.values))
    if "+-" in name or "-+" in name or int(result.outcome) != ROLLS:
        raise ValueError(f"{name} is no chain of slips and sticks that ends in rolling")
    return int(result.transitions) // 2


@cache
def near(h: float, mu: float, gap: float, distance: float) -> tuple[int, float]:
    """Return the number of slips from a distance above E*, and that of the formula."""
    hoop = thin_hoop(h, mu_k=mu, mu_s=mu + gap)
    orbit = grazing_orbits(Contact.of(hoop), hoop.mu_s, mu)[0]
    return counted(hoop, orbit.energy + distance), orbit.slips_from(mu, gap, distance)


def example(h: float, mu: float) -> tuple[lw.Hoop, Grazing]:
    """Return an example with equal coefficients, and its grazing orbit."""
    hoop = thin_hoop(h, mu_k=mu)
    return hoop, grazing_orbits(Contact.of(hoop), mu)[0]


@cache
def distances(h: float, mu: float, start: float, count: int) -> tuple[float, ...]:
    """Return the distances ε of the energy from E* before each slip, with equal coefficients."""
    hoop, orbit = example(h, mu)
    motion = hoop.simulate(
        theta=math.pi,
        theta_rate=bottom_rate(hoop, orbit.energy + start),
        max_transitions=2 * count,
        proof="none",
    )
    return tuple(one.energy_start - orbit.energy for one in motion.phases if one.mode == "sliding")


COUNT = 2000
START = 0.05


def scaled(hoop: lw.Hoop, x: float) -> tuple[float, float]:
    """Return the scaled distance of the energy at a slip, and what it takes off, scaled.

    The distance is x or a little less.
    """
    gap = hoop.mu_s - hoop.mu_k
    orbit = grazing_orbits(Contact.of(hoop), hoop.mu_s, hoop.mu_k)[0]
    unit = gap * orbit.normal / (2.0 * orbit.rise)
    motion = hoop.simulate(
        theta=math.pi,
        theta_rate=bottom_rate(hoop, orbit.energy + x * unit),
        max_transitions=2,
        proof="none",
    )
    slide = motion.phases[1]
    if [one.cause for one in motion.transitions] != ["slip", "stick"]:
        raise ValueError(f"{motion.transitions} is no slip and stick")
    loss = slide.energy_lost * orbit.fall / (hoop.mu_k * orbit.mobility * orbit.normal**3 * gap**2)
    return (slide.energy_start - orbit.energy) / unit, loss


def rate_text() -> str:
    """The rate at which the distance falls over that of the law."""
    parts = []
    for name, h, mu in EXAMPLES:
        orbit = example(h, mu)[1]
        fallen = distances(h, mu, START * orbit.energy, COUNT)
        rate = (1.0 / fallen[COUNT - 1] - 1.0 / fallen[0]) / (orbit.loss(mu) * (COUNT - 1))
        parts.append(f"{rate:.3f} ({name}, h = {h:g}, μ = {mu:g})")
    return f"{', '.join(parts)}, n = {COUNT - 1}"


def last_text() -> str:
    """How often a slip is the last."""
    heavy, thin = (len(last_slips(5, 20_000, lightest)) for lightest in (0.01, 1.0))
    return f"{heavy} with I_zz from a hundredth of m1 R² on, and {thin} of thin hoops"


def gap_text() -> str:
    """Numbers of slips for coefficients that are nearly equal."""
    parts = []
    for name, h, mu in EXAMPLES:
        slips, told = near(h, mu, 1e-3 * mu, 0.02 * example(h, mu)[1].energy)
        parts.append(f"{slips} ({told:.0f}; {name})")
    return ", ".join(parts)


def scaled_loss(x: float) -> float:
    """Return ℓ(x): what a slip takes off the energy, for nearly equal coefficients."""
    v = 0.25 * (3.0 * math.sqrt(x) + math.sqrt(9.0 * x + 12.0)) ** 2
    return v * (v + 6.0) / 36.0


@cache
def last_slips(seed: int, count: int, lightest: float) -> tuple[lw.Trajectory, ...]:
    """Return the motions of random hoops that roll, slip once, and roll on.

    μs = μk, and the particle is on the rim.

    I_zz/(m1 R²) is drawn from `lightest` to 1, that of thin hoops, by its logarithm.
    """
    random = np.random.default_rng(seed)
    h, mu = random.uniform(0.05, 0.95, count), 10.0 ** random.uniform(-2.5, 0.3, count)
    theta, rate = (
        random.uniform(-math.pi, math.pi, count),
        random.uniform(0.0, 1.5, count) / np.sqrt(h),
    )
    ratio = 1.0 / h - 1.0
    inertia = ratio * lightest ** random.uniform(0.0, 1.0, count)
    result = lw.simulate_many(
        mass_ratio=ratio,
        offset=1.0,
        inertia=inertia,
        mu_s=mu,
        mu_k=mu,
        theta=theta,
        theta_rate=rate,
        max_transitions=3,
        threads=1,
    )
    names = lw.sequence_names(result.sequence.values)
    found = np.flatnonzero((result.outcome.values == ROLLS) & np.isin(names, ("R-R", "R+R")))
    return tuple(
        lw.Hoop(
            mass_ratio=float(ratio[k]),
            offset=1.0,
            inertia=float(inertia[k]),
            mu_s=float(mu[k]),
            mu_k=float(mu[k]),
        ).simulate(theta=float(theta[k]), theta_rate=float(rate[k]))
        for k in found
    )


def picture() -> Figure:
    """The fall of the distance, the number near equal coefficients, and Λ over all thin hoops."""
    figure, (left, map_, middle, right) = panels(4)
    for ((name, h, mu), look), marker in zip(listed(EXAMPLES), "osD^", strict=True):
        _, orbit = example(h, mu)
        values = np.array(distances(h, mu, START * orbit.energy, COUNT))
        c = orbit.loss(mu)
        n = np.arange(len(values))
        left.loglog(n[1:], c * values[1:], **look, label=name)
        gaps = np.array([1e-1, 1e-2, 1e-3])
        counts = [near(h, mu, float(gap) * mu, 0.02 * orbit.energy)[0] for gap in gaps]
        fine = np.geomspace(1e-1, 1e-3, 60)
        law = []
        for gap in fine:
            other = grazing_orbits(Contact.of(thin_hoop(h, mu_k=mu)), mu * (1 + gap), mu)[0]
            law.append(other.slips_from(mu, float(gap) * mu, 0.02 * orbit.energy))
        middle.loglog(fine, law, **look, label=name)
        middle.loglog(gaps, counts, "o", color=look["color"])
        nearly = thin_hoop(h, mu_k=mu, mu_s=mu + 1e-3 * mu)
        seen = [scaled(nearly, float(x)) for x in np.linspace(0.05, 4.0, 12)]
        map_.plot(
            *zip(*seen, strict=True), marker, color=look["color"], fillstyle="none", label=name
        )
    x = np.linspace(0.0, 4.0, 200)
    map_.plot(x, [scaled_loss(float(one)) for one in x], color=INK, label="*ℓ*(*x*)")
    map_.set(xlabel="*x* = 2*aε*/(*δN*)", ylabel="Δ*E k*/(*μβN*³*δ*²)", ylim=(0, None))
    n = np.array([1.0, COUNT])
    left.loglog(n, 1.0 / n, color=FAINT, linewidth=FINE, label="*cε* = 1/*n*")
    left.set(xlabel="number *n* of the slip", ylabel="*cε* = *c* (*E* − *E*∗)", ylim=(2e-5, 1))
    middle.plot([], [], "o", color=INK, label="counted")
    middle.plot([], [], color=INK, label="formula")
    middle.set(xlabel="*μ*ₛ/*μ*ₖ − 1", ylabel="number of slips")
    for h, look in listed((0.05, 0.1, 0.25, 0.5)):
        most = min(1.0, 0.95 * math.sqrt(1.0 - h * h) / h)
        shown, values_of = [], []
        for mu in np.geomspace(0.01, most, 60):
            contact = Contact.of(thin_hoop(h, mu_k=float(mu)))
            orbits = grazing_orbits(contact, float(mu))
            if orbits:
                shown.append(mu)
                values_of.append(orbits[0].slips(float(mu)) / mu)
        right.loglog(shown, values_of, **look, label=f"*h* = {h:g}")
    right.set(xlabel="*μ*ₖ", ylabel="*Λ*/*μ*ₖ", ylim=(5, 1e4))
    for axes in (left, map_, middle):
        key(axes, columns=3)
    key(right)
    return figure


STUDY = Study(
    name="how-many-slips",
    texts={
        "attack": lambda: said("how-many-slips", "begins"),
        "attack fades": lambda: said("how-many-slips", "fades"),
        "rate": rate_text,
        "gap": gap_text,
        "last": last_text,
    },
    pictures={"slips": picture},
)
