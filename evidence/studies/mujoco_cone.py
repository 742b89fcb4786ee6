"""MuJoCo's cone: one ellipse for friction and rolling resistance, and what it does to a ball."""

from __future__ import annotations

import csv
import math
from functools import cache
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import INK

from .attacks import said
from .mujoco_runs import TABLE, Run, starting_slope
from .page import table
from .study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BALL = 0.4
"""Î/m of a ball."""

STEPS = 1000
"""Runge–Kutta steps in a unit of time."""


@cache
def runs(part: str) -> tuple[Run, ...]:
    """Return the runs of a part of the table."""
    with TABLE.open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["part"] == part]
    words = ("part", "version")
    return tuple(
        Run(**{name: text if name in words else float(text) for name, text in row.items()})  # type: ignore[arg-type]
        for row in rows
    )


def creep(mu: float, chi: float, inertia: float = BALL) -> float:
    """Return η′/θ′ of the motion on a level plane in which it stays the same.

    The negative root of μ² κ² − (μ² (1 + ϱ) − χ²) κ − χ² = 0.
    """
    half = 0.5 * (mu**2 * (1.0 + inertia) - chi**2)
    root = math.hypot(half, mu * chi)
    # The smaller of the two roots, without cancellation.
    return -(chi**2) / (half + root) if half > 0.0 else (half - root) / mu**2


def braking(mu: float, chi: float, inertia: float = BALL) -> float:
    """Return the deceleration of the centre in that motion, over g."""
    kappa = creep(mu, chi, inertia)
    return mu**2 * abs(kappa) / math.hypot(mu * kappa, chi)


def forces(mu: float, chi: float, slip: float, spin: float) -> tuple[float, float]:
    """Return F and K over N: on the ellipse, where they dissipate most."""
    size = math.hypot(mu * slip, chi * spin)
    return (-(mu**2) * slip / size, -(chi**2) * spin / size) if size else (0.0, 0.0)


def ideal(mu: float, chi: float, until: float) -> npt.NDArray[np.float64]:
    """Return rows (time, speed, spin) of a ball that begins to roll, by the cone alone."""

    def change(state: npt.NDArray[np.float64]) -> npt.NDArray[np.float64]:
        friction, couple = forces(mu, chi, state[0] - state[1], state[1])
        return np.array([friction, (couple - friction) / BALL])

    steps = round(until * STEPS)
    step, state = until / steps, np.array([1.0, 1.0])
    rows = [(0.0, 1.0, 1.0)]
    for k in range(steps):
        one = change(state)
        two = change(state + 0.5 * step * one)
        three = change(state + 0.5 * step * two)
        four = change(state + step * three)
        state = state + step / 6.0 * (one + 2.0 * two + 2.0 * three + four)
        rows.append(((k + 1) * step, float(state[0]), float(state[1])))
    return np.array(rows)


def version() -> str:
    """Return the version of MuJoCo that ran."""
    return "MuJoCo " + ", ".join(sorted({one.version for one in runs("slope")}))


def slopes() -> list[str]:
    """Accelerations on slopes next to the one at which the cone gives way."""
    found: dict[tuple[float, float], dict[float, dict[float, float]]] = {}
    for one in runs("slope"):
        part = round(one.tangent / starting_slope(one.mu, one.chi), 4)
        found.setdefault((one.mu, one.chi), {}).setdefault(part, {})[one.until] = one.speed
    rows = []
    for (mu, chi), parts in found.items():
        cells = [f"{0.5 * (speeds[4.0] - speeds[2.0]):.5f}" for speeds in parts.values()]
        rows.append([f"{mu:g}", f"{chi:g}", f"{starting_slope(mu, chi):.5f}", *cells])
    heads = [f"{part:g} tan α" for part in next(iter(found.values()))]
    return table(["μ", "χ", "tan α", *heads], rows)


def levels() -> list[str]:
    """What rolls on a level plane: MuJoCo, the cone alone, and separate limits."""
    rows = []
    for one in runs("level"):
        _, speed, spin = ideal(one.mu, one.chi, one.until)[-1]
        # Without creep v falls by χ/(1 + ϱ) until the ball rests.
        separate = max(0.0, 1.0 - one.chi * one.until / (1.0 + BALL))
        rows.append(
            [
                f"{one.mu:g}",
                f"{one.chi:g}",
                f"{one.until:g}",
                f"{one.speed:.4f}",
                f"{speed:.4f}",
                f"{separate:.4f}",
                f"{(one.spin - one.speed) / one.spin:.4f}",
                f"{(spin - speed) / spin:.4f}",
                f"{creep(one.mu, one.chi):.4f}",
            ]
        )
    heads = ["μ", "χ", "τ", "v, MuJoCo", "v, cone", "v, two limits"]
    return table([*heads, "η′/θ′, MuJoCo", "η′/θ′, cone", "its limit κ"], rows)


def softness() -> list[str]:
    """Braking over that of the law, where the contact is as soft as by default."""
    found: dict[tuple[float, float], list[str]] = {}
    for one in runs("soft"):
        share = (one.begin - one.speed) * (1.0 + BALL) / (one.chi * one.until)
        found.setdefault((one.chi, one.begin), []).append(f"{share:.3f}")
    rows = [[f"{chi:g}", f"{begin:g}", *cells] for (chi, begin), cells in found.items()]
    return table(["χ", "v", "impratio 1", "impratio 100"], rows)


def picture() -> Figure:
    """Speed and creep of a ball, and the slope on which it starts."""
    figure, axes = panels(2)
    left, right = axes
    pairs = sorted({(one.mu, one.chi) for one in runs("level")})
    for (mu, chi), look in listed(pairs):
        rows = ideal(mu, chi, 4.0)[:: STEPS // 50]
        left.plot(rows[:, 0], rows[:, 1], **look, label=f"*μ* = {mu:g}, *χ* = {chi:g}")
        seen = [one for one in runs("level") if (one.mu, one.chi) == (mu, chi)]
        left.plot(
            [one.until for one in seen], [one.speed for one in seen], "o", color=look["color"]
        )
    left.plot([], [], "o", color=INK, label="MuJoCo")
    left.set(xlim=(0, 4.2), ylim=(0, 1.05), xlabel="time *τ*, √(*R*/*g*)", ylabel="speed of a ball")
    ratio = np.linspace(0.0, 2.0, 201)
    lines = (
        (ratio / np.hypot(1.0, ratio), "cone: *χ*/√(*μ*² + *χ*²)"),
        (np.minimum(ratio, 1.0), "two limits"),
    )
    for (values, label), look in listed(list(lines)):
        right.plot(ratio, values, **look, label=label)
    right.set(xlim=(0, 2), ylim=(0, 1.1), xlabel="*χ*/*μ*", ylabel="tan *α* of the start over *μ*")
    for axis in axes:
        key(axis)
    return figure


STUDY = Study(
    name="mujoco-cone",
    texts={
        "attack": lambda: said("mujoco-cone", "creep"),
        "version": version,
        "slopes": slopes,
        "levels": levels,
        "softness": softness,
    },
    pictures={"ball": picture},
)
