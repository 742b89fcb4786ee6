"""The paradox of rolling resistance, half swings to rest, and the rotation down a slope."""

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
from littlewood.plot.sheet import listed, panels, power
from littlewood.style import BOLD, FAINT

from .attacks import said
from .compliant import Yielding
from .contact import Contact
from .page import table
from .study import Study

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Array = npt.NDArray[np.float64]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(60)

JAM = lw.Hoop(mass_ratio=1e-3, offset=1.0, inertia=1e-3, mu_s=0.6, mu_k=0.6, rolling_resistance=0.5)
"""A light hoop whose rolling has no solution next to the bottom."""

JAM_START = (math.pi - 0.45, 0.8)
"""Its θ and θ′."""

SWINGING = lw.Hoop(mass_ratio=1.0, offset=0.5, inertia=0.8, mu_s=2.0, mu_k=2.0)
"""The hoop of the tables of rolling."""


@dataclass(frozen=True)
class Swings:
    """First order of rolling with a small resistance: the loss of half swings and turns."""

    contact: Contact

    @classmethod
    def of(cls, hoop: lw.Hoop) -> Swings:
        """Return that of a hoop."""
        return cls(Contact.of(hoop))

    @property
    def both(self) -> tuple[float, float]:
        """A and ℓ̂ of D = A + 2 ℓ̂ cos θ."""
        hoop = self.contact
        return hoop.inertia + hoop.m * (1.0 + hoop.h**2), hoop.m * hoop.h

    def loss(self, amplitude: Array) -> Array:
        """Return g: a half swing takes χ g off the amplitude."""
        (a, offset), m, h = self.both, self.contact.m, self.contact.h
        root = math.sqrt(a * a - 4.0 * offset**2)
        part = math.sqrt((a + 2.0 * offset) / (a - 2.0 * offset))
        inverse = 4.0 / root * np.arctan(part * np.tan(0.5 * amplitude))
        mean = (a * inverse - 2.0 * amplitude) / (2.0 * offset)
        level = a - 2.0 * offset * np.cos(amplitude)
        bracket = 2.0 * amplitude - h * np.sin(amplitude) + 0.5 * h * level * mean
        result: Array = m * bracket / (offset * np.sin(amplitude))
        return result

    def number(self, amplitude: float) -> float:
        """Return ∫ da/g from 0: half swings to rest times χ."""
        nodes = 0.5 * amplitude * (1.0 + NODES)
        return float(0.5 * amplitude * np.sum(WEIGHTS / self.loss(nodes)))

    @property
    def excess(self) -> float:
        """κ: of the normal force of a turn."""
        a, offset = self.both
        return a / math.sqrt(a * a - 4.0 * offset**2) - 1.0

    def slope(self, level: float) -> float:
        """Return tan α/χ of the periodic rotation with the constant K."""
        return 1.0 + self.excess * level / (4.0 * self.contact.m)

    def top(self) -> float:
        """Return the least K of a rotation."""
        a, offset = self.both
        return a + 2.0 * offset

    def grip(self, mu: float) -> float:
        """Return the greatest K with |F| ≤ μ N at all angles, N and F being linear in it."""
        (a, offset), h = self.both, self.contact.h
        theta = np.linspace(-math.pi, math.pi, 20_001)
        s, c = np.sin(theta), np.cos(theta)
        d = a + 2.0 * offset * c
        # N/m = L − K n and F/m = −h s + K f.
        normal = h * (c / d + offset * s * s / d**2)
        friction = h * s / d - (1.0 + h * c) * offset * s / d**2
        least = math.inf
        for side in (1.0, -1.0):
            free = mu * (1.0 + h * c) - side * h * s
            fall = mu * normal - side * friction
            least = min(least, float(np.min(free[fall > 0.0] / fall[fall > 0.0])))
        return least


def body(hoop: lw.Hoop, stiffness: float, damping: float) -> Yielding:
    """Return a hoop on a plane that yields."""
    return Yielding(
        mass=hoop.mass,
        h=hoop.h,
        inertia=hoop.inertia_about_mass_centre,
        mu=hoop.mu_k,
        chi=hoop.rolling_resistance,
        stiffness=stiffness,
        damping=damping,
    )


@dataclass(frozen=True)
class DeadStop:
    """The jam of rolling: impulses, energy lost to the couple and given to the contact."""

    normal: float
    friction: float
    couple: float
    contact: float

    @classmethod
    def of(cls, hoop: lw.Hoop, theta: float, rate: float) -> DeadStop:
        """Return that of the closed form."""
        m, h, inertia = hoop.mass, hoop.h, hoop.inertia_about_mass_centre
        arm, lever = h * abs(math.sin(theta)), 1.0 + h * math.cos(theta)
        j = inertia + m * lever**2
        chi = hoop.rolling_resistance
        lost = 0.5 * chi * j * rate**2 / (chi - arm)
        return cls(
            m * arm * abs(rate),
            m * lever * rate,
            lost,
            0.5 * (j + m * arm**2) * rate**2 - lost,
        )


def compliance() -> list[str]:
    """The jam of a contact that yields, over the closed form."""
    law = DeadStop.of(JAM, *JAM_START)
    rows = []
    for damping in (0.0, 1.0):
        for stiffness in (1e4, 1e6, 1e9):
            end = body(JAM, stiffness, damping).jam(*JAM_START)[:, -1]
            ratios = (end[5] / law.normal, end[6] / law.friction, end[7] / law.couple)
            rows.append(
                [
                    f"{damping:g}",
                    f"{stiffness:.0e}",
                    *(f"{one:.5f}" for one in ratios),
                    f"{end[3] / JAM_START[1]:.0e}",
                ]
            )
    heads = ["damping", "k", "∫N over m|aθ′|", "∫F over mdθ′", "loss by the couple", "θ′ left"]
    return table(heads, rows)


def swings(hoop: lw.Hoop, amplitude: float) -> int:
    """Return the half swings of a hoop that is let go and rolls to rest, −1 if it slips."""
    motion = hoop.simulate(
        theta=math.pi - amplitude, theta_rate=0.0, max_transitions=20_000, proof="none"
    )
    rolls = all(phase.mode == "rolling" for phase in motion.phases[:-1])
    return len(motion.transitions) if rolls and motion.outcome.kind == "rests" else -1


def counts() -> list[str]:
    """Half swings of one hoop, and the law."""
    rows = []
    law = Swings.of(SWINGING)
    for degrees in (10.0, 45.0, 90.0, 135.0, 170.0):
        amplitude = math.radians(degrees)
        cells = [f"{degrees:g}", f"{law.number(amplitude):.4f}"]
        for chi in (0.02, 0.01, 0.002):
            expected = law.number(amplitude) / chi - 0.5
            seen = swings(replace(SWINGING, rolling_resistance=chi), amplitude)
            cells += [f"{expected:.2f}", str(seen)]
        rows.append(cells)
    heads = [one for chi in (0.02, 0.01, 0.002) for one in (f"law, χ = {chi:g}", "seen")]
    return table(["a₀, °", "S(a₀)", *heads], rows)


@cache
def random_swings(seed: int = 1, count: int = 200) -> tuple[tuple[float, float, int], ...]:
    """Return χ, S/χ − ½ and the half swings of random hoops that roll to rest."""
    random = np.random.default_rng(seed)
    found: list[tuple[float, float, int]] = []
    while len(found) < count:
        ratio, chi = 10.0 ** random.uniform(-1.0, 1.0), 10.0 ** random.uniform(-3.0, -1.7)
        hoop = lw.Hoop(
            mass_ratio=ratio,
            offset=random.uniform(0.3, 1.0),
            inertia=ratio * random.uniform(0.3, 1.0),
            mu_s=50.0,
            mu_k=50.0,
            rolling_resistance=chi,
        )
        amplitude = random.uniform(0.3, 2.9)
        seen = swings(hoop, amplitude)
        if seen >= 0:
            found.append((chi, Swings.of(hoop).number(amplitude) / chi - 0.5, seen))
    return tuple(found)


def random_counts() -> str:
    """How many of random hoops make as many half swings as the law says."""
    right = sum(math.ceil(law) == seen for _, law, seen in random_swings())
    rest = [
        f"{law:.3f}, and made {seen}" for _, law, seen in random_swings() if math.ceil(law) != seen
    ]
    words = f"{right} of {len(random_swings())}"
    return f"{words}; the other had {'; '.join(rest)}" if rest else words


def downhill(mu: float, chi: float, ratio: float) -> Counter[str]:
    """Return the events of a rotation down a slope of tan α = ratio χ that begins as the law's."""
    slope, law = math.atan(chi * ratio), Swings.of(SWINGING)
    level = max(4.0 * law.contact.m * (ratio - 1.0) / law.excess, 1.001 * law.top())
    hoop = replace(SWINGING, mu_s=mu, mu_k=mu, rolling_resistance=chi, slope=slope, restitution=0.0)
    motion = hoop.simulate(
        theta=0.0,
        theta_rate=math.sqrt((level / law.top() - 1.0) * math.cos(slope)),
        max_transitions=600,
        until=20.0 / chi,
        proof="none",
    )
    found = Counter(one.cause for one in motion.transitions)
    if motion.outcome.kind == "rests":
        found["rest"] += 1
    return found


@cache
def end_of(mu: float, chi: float, cause: str, low: float, high: float) -> float:
    """Return tan α/χ from which an event occurs, `low` being without it, or with it if above."""
    for _ in range(9):
        middle = 0.5 * (low + high)
        low, high = (low, middle) if downhill(mu, chi, middle)[cause] else (middle, high)
    return 0.5 * (low + high)


def windows() -> list[str]:
    """Where a periodic rotation rolls, slips in each turn, and leaves the plane."""
    law, rows = Swings.of(SWINGING), []
    for mu in (0.5, 1.0):
        first, slip = law.slope(law.top()), law.slope(law.grip(mu))
        for chi in (0.01, 0.005):
            seen = (
                end_of(1.0, chi, "rest", first + 0.01, first - 0.01),
                end_of(mu, chi, "slip", slip - 0.01, slip + 0.01),
                end_of(mu, chi, "lift_off", slip, slip + 0.03),
            )
            cells = [f"{one:.4f}" for one in (first, seen[0], slip, *seen[1:])]
            rows.append([f"{mu:g}", f"{chi:g}", *cells])
    heads = ["rolls from, law", "computed", "slips from, law", "computed", "leaves the plane from"]
    return table(["μ", "χ", *heads], rows)


def figures() -> list[str]:
    """Events of the paper's figures with rolling resistance."""
    rows = []
    for name, title, causes in (
        ("figure-3", "3", ("stick", "slip", "lift_off")),
        ("figure-7", "7", ("slip", "reversal", "particle_at_plane")),
    ):
        case = lw.CASES[name]
        for chi in (0.0, 0.002, 0.01, 0.02):
            hoop = replace(case.hoop, rolling_resistance=chi)
            motion = hoop.simulate(**vars(case.start), max_transitions=10)
            seen = {one.cause: one.state for one in motion.transitions}
            cells = [
                f"{cause.replace('_', ' ')} {seen[cause].time:.4f}, {seen[cause].theta:.4f}"
                for cause in causes
            ]
            rows.append([title, f"{chi:g}", *cells])
    return table(["figure", "χ", "τ, θ of the first", "of the second", "of the third"], rows)


def libration() -> str:
    """How often the hoop of Figure 2 that rocks for ever rocks with resistance."""
    case = lw.CASES["figure-2-libration"]
    numbers = []
    for chi in (0.002, 0.01, 0.02):
        motion = replace(case.hoop, rolling_resistance=chi).simulate(
            **vars(case.start), max_transitions=2000, proof="none"
        )
        numbers.append(f"{len(motion.transitions)} for χ = {chi:g}")
    return ", ".join(numbers)


def attack(theorem: str) -> str:
    """Return what was tried against a theorem of the page."""
    return said("rolling-resistance", theorem)


def picture() -> Figure:
    """Amplitudes of half swings, and a jam of a contact that yields."""
    figure, axes = panels(2)
    left, right = axes
    law = Swings.of(SWINGING)
    amplitudes = np.linspace(1e-3, 2.9, 200)
    numbers = np.array([law.number(float(one)) for one in amplitudes])
    left.plot(numbers[-1] - numbers, amplitudes, color=FAINT, linewidth=2.0 * BOLD, label="law")
    for chi, look in listed((0.05, 0.02, 0.01)):
        motion = replace(SWINGING, rolling_resistance=chi).simulate(
            theta=math.pi - 2.9, theta_rate=0.0, max_transitions=2000
        )
        turns = [2.9] + [abs(one.state.theta - math.pi) for one in motion.transitions]
        count = chi * np.arange(len(turns))
        left.plot(count, turns, "o", markersize=3, color=look["color"], label=f"*χ* = {chi:g}")
    left.set(
        xlim=(0, None), ylim=(0, 3), xlabel="half swings times *χ*", ylabel="amplitude, radians"
    )
    stop = DeadStop.of(JAM, *JAM_START)
    for stiffness, look in listed((1e2, 1e3, 1e5)):
        states = body(JAM, stiffness, 1.0).jam(*JAM_START)
        part = states[5] / stop.normal
        right.plot(part, states[3], **look, label=f"*k* = {power(stiffness)}")
        right.plot(part, states[1], **{**look, "label": None})
    right.set(xlabel="impulse ∫*N* d*τ* over *m*|*aθ*′|", ylabel="*θ*′ (above) and rate of the gap")
    for axis in axes:
        key(axis)
    return figure


STUDY = Study(
    name="rolling-resistance",
    texts={
        "compliance": compliance,
        "counts": counts,
        "random counts": random_counts,
        "windows": windows,
        "figures": figures,
        "libration": libration,
        "attack rest": lambda: attack("rest"),
        "attack dead stop": lambda: attack("dead stop"),
        "attack motion": lambda: attack("motion"),
        "attack jam": lambda: attack("jam"),
        "attack swings": lambda: attack("swings"),
    },
    pictures={"stops": picture},
)
