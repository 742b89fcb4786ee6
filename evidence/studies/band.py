"""The band in which the plane holds the rim though rolling would need N < 0."""

from __future__ import annotations

import math
from functools import cache

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key, of_curve
from littlewood.plot.sheet import listed, panels
from littlewood.style import LINE
from matplotlib.figure import Figure

from .attacks import said
from .hoops import thin_hoop
from .page import table
from .study import Study


def thickness(h: float, kappa: float, theta: float) -> float:
    """Return the thickness of the band in 1/(hθ′²) where cos θ ≥ 0; ϱ = Î/m."""
    lever = 1.0 + h * math.cos(theta)
    return h * math.sin(theta) ** 2 * lever / (kappa + lever**2)


def upper(h: float, kappa: float, theta: float) -> float:
    """Return 1/(hθ′²) where the normal force of rolling vanishes."""
    return math.cos(theta) + thickness(h, kappa, theta)


def last_angle(h: float, kappa: float) -> float:
    """Return the angle up to which there is a band."""
    mean = (1.0 + h * h + kappa) / (2.0 * h)
    return math.acos(-1.0 / (mean + math.sqrt(mean * mean - 1.0)))


def area(h: float, kappa: float) -> float:
    """Return the area of the band over θ and 1/(hθ′²), of a whole turn."""
    end = last_angle(h, kappa)
    # Gauss's rule for the half turn on both sides of π/2, where the lower border has a corner.
    nodes, weights = np.polynomial.legendre.leggauss(60)
    total = 0.0
    for low, high in ((0.0, 0.5 * math.pi), (0.5 * math.pi, end)):
        for node, weight in zip(nodes, weights, strict=True):
            theta = 0.5 * (low + high) + 0.5 * (high - low) * float(node)
            total += (
                float(weight) * (high - low) * (upper(h, kappa, theta) - max(math.cos(theta), 0.0))
            )
    return total


def rim(h: float) -> float:
    """Return ϱ of a thin hoop with the particle on the rim."""
    return 1.0 - h * h


OFFSETS = (0.5, 0.75, 0.9)


STARTS = 2000


@cache
def starts(h: float) -> tuple[np.ndarray, np.ndarray]:
    """Return starts spread evenly over the band in θ and 1/(hθ′²)."""
    random = np.random.default_rng(3)
    kappa = rim(h)
    end = last_angle(h, kappa)
    found: list[tuple[float, float]] = []
    while len(found) < STARTS:
        theta, inverse = random.uniform(-end, end), random.uniform(0.0, 1.0 + h)
        if max(math.cos(theta), 0.0) < inverse < upper(h, kappa, theta):
            found.append((theta, random.choice([-1.0, 1.0]) / math.sqrt(h * inverse)))
    pairs = np.array(found)
    return pairs[:, 0], pairs[:, 1]


FRICTIONS = (0.1, 0.6)


@cache
def fates(h: float, mu_k: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return of the starts whether the mass centre rises, the sequences, and the outcomes."""
    hoop = thin_hoop(h, mu_k=mu_k, mu_s=1.25 * mu_k)
    theta, rate = starts(h)
    result = lw.simulate_many(hoop, theta=theta, theta_rate=rate, max_transitions=20_000, threads=1)
    names = lw.sequence_names(result.sequence.values)
    return (
        np.sin(theta) * rate < 0.0,
        names,
        np.array([lw.tables.OUTCOMES[int(one)] for one in result.outcome.values]),
    )


def share_table() -> list[str]:
    """What becomes of the starts, by their direction."""
    rows = []
    for h in OFFSETS:
        for mu_k in FRICTIONS:
            rises, names, outcome = fates(h, mu_k)
            first = np.isin(names, ("+F", "-F"))
            cells = [f"{np.sum(first & one)} of {np.sum(one)}" for one in (rises, ~rises)]
            rows.append([f"{h:g}", f"{mu_k:g}", *cells, str(np.sum(outcome == "rolls_forever"))])
    heads = [
        "h",
        "μk",
        "rising: off in the first slide",
        "falling: off in the first slide",
        "roll for ever",
    ]
    return table(heads, rows)


def picture() -> Figure:
    """The band in the phase plane, its thickness, and its area."""
    figure, (left, middle, right) = panels(3)
    h, kappa = 0.5, 0.75
    angles = np.linspace(-last_angle(h, kappa) + 1e-3, last_angle(h, kappa) - 1e-3, 600)
    low = np.array([1.0 / math.sqrt(h * upper(h, kappa, float(angle))) for angle in angles])
    cosine = np.cos(angles)
    high = np.where(cosine > 1e-3, 1.0 / np.sqrt(h * np.maximum(cosine, 1e-3)), 99.0)
    left.fill_between(np.degrees(angles), low, high, color=LINE, linewidth=0, label="the band")
    left.plot(
        np.degrees(angles), low, **of_curve("normal_force_zero"), label="*n*: *N* = 0 in rolling"
    )
    left.plot(np.degrees(angles), high, **of_curve("lift_off"), label="*w* = 0: lift-off")
    left.set(
        ylim=(0, 6),
        xlim=(-130, 130),
        xlabel="*θ*, degrees",
        ylabel="*θ*′, √(*g*/*R*)",
        xticks=range(-120, 121, 60),
    )
    left.text(0, 3.4, "off the plane", ha="center")
    left.text(0, 0.7, "rolls or slides", ha="center")
    key(left)
    degrees = np.linspace(0.0, 90.0, 200)
    for ratio, line in listed((0.01, 0.3, 1.0, 10.0)):
        values = [thickness(0.5, ratio, math.radians(float(degree))) for degree in degrees]
        middle.plot(degrees, values, **line, label=f"*ϱ* = {ratio:g}")
        offsets = np.linspace(0.01, 0.99, 80)
        sizes = [area(float(one), ratio) for one in offsets]
        right.plot(offsets, sizes, **line, label=f"*ϱ* = {ratio:g}")
    middle.set(
        xlabel="*θ*, degrees",
        ylabel="thickness in 1/(*hθ*′²), *h* = 0.5",
        xlim=(0, 90),
        xticks=range(0, 91, 30),
    )
    right.set(xlabel="*h*, *R*", ylabel="area over *θ* and 1/(*hθ*′²)", xlim=(0, 1))
    for axes in (middle, right):
        axes.set_ylim(bottom=0)
        key(axes)
    return figure


STUDY = Study(
    name="band",
    texts={"attack": lambda: said("band", "motion"), "shares": share_table},
    pictures={"band": picture},
)
