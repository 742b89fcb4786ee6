"""Gradients through contact: exact derivatives, differences, and derivatives of time stepping."""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable
from dataclasses import replace
from functools import cache

import littlewood as lw
import numpy as np
from littlewood.plot.canvas import key
from littlewood.plot.sheet import listed, panels
from littlewood.style import ARROW_COLOURS, FAINT, FINE, INK, LIST_DASHES
from littlewood.tables import CAUSE_LABELS
from matplotlib.figure import Figure

from .page import table
from .study import Study

CASE = lw.case("figure-3")
# Thrown from the plane without friction and without loss, it lands once before END.
BOUNCES = lw.Hoop(mass_ratio=1.0, offset=1.0, inertia=1.0, mu_s=0.0, mu_k=0.0, restitution=1.0)
THETA, RATE, RISE, END = 1.0, 1.0, 1.0, 2.5
COMPLEX_STEP = 1e-100
# Durations of a contact with a spring: this time, and so many steps.
SOFT, STEPS_IN_CONTACT = 0.1, 50
DIFFERENCE = 0.02

Scheme = Callable[[lw.Hoop, float, complex], complex]


class Body:
    """A hoop without friction in the air, complex.

    Angle, height of the mass centre, and their rates.
    """

    def __init__(self, hoop: lw.Hoop, rise: complex) -> None:
        self.h, self.mass, self.inertia = hoop.h, hoop.mass, hoop.inertia_about_mass_centre
        self.theta, self.rate = complex(THETA), complex(RATE)
        self.height = 1.0 + self.h * cmath.cos(self.theta)
        self.up = rise - self.h * cmath.sin(self.theta) * self.rate

    @property
    def gap(self) -> complex:
        """The gap under the rim."""
        return self.height - 1.0 - self.h * cmath.cos(self.theta)

    @property
    def gap_rate(self) -> complex:
        """Its rate."""
        return self.up + self.h * cmath.sin(self.theta) * self.rate

    def push(self, impulse: complex) -> None:
        """Apply an impulse of the plane."""
        self.up += impulse / self.mass
        self.rate += self.h * cmath.sin(self.theta) * impulse / self.inertia

    def move(self, step: float) -> None:
        """Make a step of the semi-implicit Euler method."""
        self.up -= step
        self.height += step * self.up
        self.theta += step * self.rate

    def compliance(self) -> complex:
        """Return C, by which an impulse changes the rate of the gap."""
        return 1.0 / self.mass + (self.h * cmath.sin(self.theta)) ** 2 / self.inertia


def with_impacts(hoop: lw.Hoop, step: float, rise: complex) -> complex:
    """Return θ at the end: an impact at the end of the step in which the rim reaches the plane."""
    body = Body(hoop, rise)
    for _ in range(round(END / step)):
        body.move(step)
        if body.gap.real < 0.0 and body.gap_rate.real < 0.0:
            body.push(-2.0 * body.gap_rate / body.compliance())
    return body.theta


def with_spring(hoop: lw.Hoop, step: float, rise: complex, duration: float = SOFT) -> complex:
    """Return θ at the end.

    A spring at the plane is so stiff that the body above it stays for about this time.
    """
    body = Body(hoop, rise)
    stiffness = hoop.mass * (math.pi / duration) ** 2
    for _ in range(round(END / step)):
        if body.gap.real < 0.0:
            body.push(-step * stiffness * body.gap)
        body.move(step)
    return body.theta


def with_stiff_spring(hoop: lw.Hoop, step: float, rise: complex) -> complex:
    """Return θ at the end: a spring that is the stiffer the shorter the step is."""
    return with_spring(hoop, step, rise, STEPS_IN_CONTACT * step)


def automatic(scheme: Scheme, hoop: lw.Hoop, step: float) -> float:
    """Return the derivative by the rate of the start, by a complex step.

    So does automatic differentiation.
    """
    return scheme(hoop, step, complex(RISE, COMPLEX_STEP)).imag / COMPLEX_STEP


def difference(scheme: Scheme, hoop: lw.Hoop, step: float) -> float:
    """Return the central difference with a step of `DIFFERENCE`."""
    ends = [scheme(hoop, step, complex(RISE + side * DIFFERENCE)).real for side in (-1, 1)]
    return (ends[1] - ends[0]) / (2.0 * DIFFERENCE)


def motion_of(hoop: lw.Hoop) -> lw.Trajectory:
    """Return the motion that the schemes follow."""
    return hoop.simulate(theta=THETA, theta_rate=RATE, gap_rate=RISE, until=END)


def exact(hoop: lw.Hoop) -> float:
    """Return the exact derivative."""
    return float(motion_of(hoop).derivatives_at(END, ["gap_rate"]).theta[0])


def without_delay(hoop: lw.Hoop) -> float:
    """Return what an impact gives whose time does not depend on the start.

    It is R_y (δy)_τ, continued in flight.
    """
    motion = motion_of(hoop)
    (landing,) = motion.transitions
    assert landing.impact is not None
    h, inertia, time = hoop.h, hoop.inertia_about_mass_centre, landing.time
    sine = math.sin(landing.state.theta)
    # In flight θ does not depend on the rate of the gap: (δθ)_τ = (δθ′)_τ = 0, (δgap′)_τ = 1.
    compliance = 1.0 / hoop.mass + (h * sine) ** 2 / inertia
    return (END - time) * -2.0 * h * sine / inertia / compliance


def schemes() -> list[str]:
    """Derivatives of two schemes of time stepping, at shorter and shorter steps."""
    rows = []
    for power in (2, 3, 4, 5):
        step = 10.0**-power
        state = abs(
            with_impacts(BOUNCES, step, complex(RISE)).real - float(motion_of(BOUNCES)(END).theta)
        )
        values = [
            automatic(with_impacts, BOUNCES, step),
            difference(with_impacts, BOUNCES, step),
            automatic(with_spring, BOUNCES, step),
            automatic(with_stiff_spring, BOUNCES, step),
        ]
        rows.append([f"$10^{{-{power}}}$", f"{state:.0e}", *(f"{value:.4f}" for value in values)])
    found = f"{exact(BOUNCES):.4f}"
    rows.append(["exact", "", *[found] * 4])
    heads = [
        "impacts, automatic",
        "impacts, differences",
        "soft spring, automatic",
        "stiff spring, automatic",
    ]
    return table(["step", "error of θ, impacts", *heads], rows)


def limit() -> str:
    """Return the limit of the derivative of the impacts."""
    return f"{without_delay(BOUNCES):.4f}"


def landing_of(mu_k: float) -> float:
    """Return x at the landing of Figure 3 with another friction."""
    motion = replace(CASE.hoop, mu_k=mu_k).simulate(**vars(CASE.start))
    return motion.transitions[-1].state.x


@cache
def errors(step: float) -> tuple[float, float]:
    """Return the relative errors of a forward and a central difference.

    Of x at the landing of Figure 3.
    """
    true = float(CASE.simulate().derivatives(["mu_k"]).x.isel(transition=-1).sel(quantity="mu_k"))
    below, here, above = (landing_of(CASE.hoop.mu_k + side * step) for side in (-1, 0, 1))
    return abs((above - here) / step / true - 1.0), abs((above - below) / (2.0 * step) / true - 1.0)


def picture() -> Figure:
    """Derivatives at fixed times, which jump at events; errors of differences."""
    figure, (left, right) = panels(2)
    motion = CASE.simulate()
    for name, label, look in (
        ("theta_rate", "*θ*", {"color": INK}),
        ("slip", "*η*", {"color": ARROW_COLOURS["slip"], "linestyle": LIST_DASHES[1]}),
    ):
        for i, phase in enumerate(motion.phases):
            # At its end the next phase begins.
            times = np.linspace(phase.start_time, np.nextafter(phase.end_time, 0.0), 80)
            found = motion.derivatives_at(times, ["mu_k"])[name].sel(quantity="mu_k")
            left.plot(times, found, **look, label=f"∂{label}′/∂*μ*ₖ" if i == 0 else None)
    for transition in motion.transitions[:-1]:
        left.axvline(transition.time, color=FAINT, linewidth=FINE)
        left.text(
            transition.time + 0.03, 1.65, CAUSE_LABELS[transition.cause], rotation=90, va="top"
        )
    left.set(xlim=(0, motion.end_time), xlabel="time *τ*, √(*R*/*g*)")
    left.set_ylabel("derivative at fixed *τ*, √(*g*/*R*), √(*gR*)")
    steps = np.logspace(-13, -1, 73)
    both = np.array([errors(float(step)) for step in steps])
    for (column, label), look in listed(((0, "forward"), (1, "central"))):
        right.loglog(steps, both[:, column], **look, label=f"{label} difference")
    right.set(xlabel="step of *μ*ₖ", ylabel="relative error")
    for axes in (left, right):
        key(axes)
    return figure


STUDY = Study(
    name="gradients-through-contact",
    texts={"schemes": schemes, "limit": limit},
    pictures={"derivatives": picture},
)
