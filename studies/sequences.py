"""The sequences of the first turn, and the boundaries between them, where two events coincide."""

from __future__ import annotations

import math
from collections import Counter
from dataclasses import dataclass
from functools import cache

import littlewood as lw
import numpy as np
from littlewood.style import INK
from matplotlib.figure import Figure

from .axes import COLOURS, panels
from .page import table
from .study import Study

GAMMA = 0.5
"""Distance of the mass centre from the centre."""

INSTANTS = np.linspace(0.0, 1.0, 33)[1:]
"""Instants of a phase at which it is asked whether the turn has stopped."""

PHASES = 60
"""Phases after which a turn is given up."""


@dataclass(frozen=True)
class Turn:
    """A first turn: its phases with their durations up to the stop, and the stop."""

    word: str
    stop: str
    durations: tuple[float, ...]

    @property
    def name(self) -> str:
        """Phases and stop."""
        return f"{self.word} {self.stop}"


def hoop_of(mu: float, gamma: float = GAMMA) -> lw.Hoop:
    """Return the hoop of Theron and Maritz, with its particle so far out that the mass centre is at gamma."""
    return lw.Hoop(mass_ratio=1.0 / 3.0, offset=gamma / 0.75, inertia=1.0 / 3.0, mu_s=mu, mu_k=mu)


def first_turn(mu: float, rate: float, gamma: float = GAMMA) -> Turn:
    """Follow a hoop from the top to a revolution, a reversal of θ′ or a lift-off."""
    motion = hoop_of(mu, gamma).simulate(theta=0.0, theta_rate=rate, proof="none", max_transitions=PHASES)
    word = ""
    durations: list[float] = []
    for phase in motion.phases:
        if phase.mode == "flight":
            return Turn(word + "F", "lifts off", tuple(durations))
        word += "R" if phase.mode == "rolling" else "+" if phase.direction > 0 else "-"
        if phase.end is None:
            durations.append(math.inf)
            turns = phase.energy_start > motion.hoop.offset
            return Turn(word, "revolution" if turns else "turns back", tuple(durations))
        ends = phase.end.theta_rate <= 0.0 or phase.end.theta >= 2.0 * math.pi
        if ends or phase.duration > 0.5:
            samples = motion.at(phase.start.time + phase.duration * INSTANTS, side="before")
            back = np.flatnonzero(np.asarray(samples["theta_rate"]) <= 0.0)
            around = np.flatnonzero(np.asarray(samples["theta"]) >= 2.0 * math.pi)
            first_back = int(back[0]) if len(back) else len(INSTANTS)
            first_around = int(around[0]) if len(around) else len(INSTANTS)
            place = min(first_back, first_around)
            if place < len(INSTANTS):
                durations.append(phase.duration * _stop(motion, phase, place))
                return Turn(word, "turns back" if first_back <= first_around else "revolution", tuple(durations))
        durations.append(phase.duration)
    return Turn(word, "is given up", tuple(durations))


def _stop(motion: lw.Trajectory, phase: lw.Phase, place: int) -> float:
    """Return the part of a phase that is over at the stop, between two of its instants."""
    low, high = float(INSTANTS[place - 1]) if place else 0.0, float(INSTANTS[place])
    for _ in range(40):
        middle = 0.5 * (low + high)
        sample = motion.at(phase.start.time + phase.duration * middle)
        if float(sample["theta_rate"]) <= 0.0 or float(sample["theta"]) >= 2.0 * math.pi:
            high = middle
        else:
            low = middle
    return high


@dataclass(frozen=True)
class Boundary:
    """A friction at which the sequence changes, at one θ′ of the start."""

    mu: float
    rate: float
    below: Turn
    above: Turn

    @property
    def kind(self) -> str:
        """What coincides: told by the phase that has next to no duration on one of the sides."""
        longer = self.below if len(self.below.word) >= len(self.above.word) else self.above
        other = self.above if longer is self.below else self.below
        shortest, turn = min((min(one.durations, default=math.inf), one is other) for one in (longer, other))
        if shortest > 1e-3:
            return "two stops" if self.below.word.rstrip("F") == self.above.word.rstrip("F") else "not told"
        found = other if turn else longer
        place = found.durations.index(shortest)
        if place == len(found.durations) - 1 and found.stop != "lifts off":
            return "an event at the stop"
        if found.word[place] == "R":
            return "a roll without duration"
        before, after = found.word[place - 1 : place], found.word[place + 1 : place + 2]
        return "a slip out of nothing" if (before, after) == ("R", "R") else "a slide without duration"


def boundaries(rate: float, least: float, most: float, count: int, gamma: float = GAMMA) -> list[Boundary]:
    """Return where the sequence changes between neighbours of a scan, each to the last digits of μ."""
    values = [float(value) for value in np.geomspace(least, most, count)]
    turns = [first_turn(mu, rate, gamma) for mu in values]
    open_pairs = list(zip(values, turns, values[1:], turns[1:], strict=False))[::-1]
    found = []
    while open_pairs:
        low, below, high, above = open_pairs.pop()
        if below.name == above.name:
            continue
        middle = 0.5 * (low + high)
        if high - low < 1e-12 * high:
            found.append(Boundary(middle, rate, below, above))
            continue
        turn = first_turn(middle, rate, gamma)
        open_pairs.append((middle, turn, high, above))
        open_pairs.append((low, below, middle, turn))
    return found


LEAST, MOST = 0.02, 2.0
RATES = tuple(float(one) for one in np.linspace(0.06, 0.98, 16) / math.sqrt(GAMMA))


@cache
def plane(count: int, least: float = LEAST) -> tuple[Boundary, ...]:
    """Return the boundaries on all lines."""
    return tuple(one for rate in RATES for one in boundaries(rate, least, MOST, count))


def names(found: tuple[Boundary, ...]) -> set[str]:
    """Return the sequences on both sides of all boundaries."""
    return {turn.name for one in found for turn in (one.below, one.above)}


SCAN = 30


def kind_table() -> list[str]:
    """What coincides at the boundaries."""
    found = plane(SCAN)
    counts = Counter(one.kind for one in found)
    rows = []
    for kind, number in counts.most_common():
        example = next(one for one in found if one.kind == kind)
        rows.append(
            [
                kind,
                str(number),
                f"`{example.below.name}`",
                f"`{example.above.name}`",
                f"{example.mu:.12g}, {example.rate:.5g}",
            ]
        )
    return table(["coincidence", "boundaries", "for example below", "and above", "μ, θ′"], rows)


def scan_table() -> list[str]:
    """Whether a finer scan finds more."""
    rows = []
    for count in (SCAN // 2, SCAN):
        found = plane(count)
        words = {turn.word for one in found for turn in (one.below, one.above)}
        rows.append([str(count), str(len(found)), str(len(names(found))), str(len(words)), str(max(map(len, words)))])
    return table(["values of μ on a line", "boundaries", "sequences with stops", "sequences", "longest"], rows)


def friction_table() -> list[str]:
    """The lists for least frictions."""
    rows = []
    found = plane(SCAN, 0.005)
    for least in (0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5):
        part = tuple(one for one in found if one.mu > least)
        words = {turn.word for one in part for turn in (one.below, one.above)}
        rows.append([f"{least:g}", str(len(names(part))), str(len(words)), str(max(map(len, words), default=0))])
    return table(["least μ", "sequences with stops", "sequences", "longest"], rows)


STEPS = 4
"""Steps of a curve from line to line."""


def between(low: float, high: float, rate: float, sides: tuple[str, str], gamma: float = GAMMA) -> float | None:
    """Return the friction at which one sequence passes into another, to 1e-6; None if the ends have others."""
    if (first_turn(low, rate, gamma).name, first_turn(high, rate, gamma).name) != sides:
        return None
    while high - low > 1e-6 * high:
        middle = 0.5 * (low + high)
        name = first_turn(middle, rate, gamma).name
        if name not in sides:
            return None
        low, high = (middle, high) if name == sides[0] else (low, middle)
    return 0.5 * (low + high)


def extrapolated(last: list[float]) -> float:
    """Return the next of up to three numbers, as if their logarithms were a polynomial's."""
    match last:
        case [one]:
            return one
        case [before, one]:
            return one * one / before
        case _:
            first, second, third = last
            return third * (third / second) ** 2 * first / second


def followed(start: Boundary, step: float) -> list[tuple[float, float]]:
    """Return the points (θ′, μ) of the curve from a boundary on, as far as it parts the same two sequences.

    The next point is looked for about the continuation of the last two, in an interval that grows: in the least that
    has both sequences at its ends no third boundary is hidden.
    """
    points = [(start.rate, start.mu)]
    sides = (start.below.name, start.above.name)
    while RATES[0] <= points[-1][0] + step <= RATES[-1] * (1.0 + 1e-12):
        rate = points[-1][0] + step
        guess = extrapolated([one for _, one in points[-3:]])
        tried = (between(guess / (1.0 + part), guess * (1.0 + part), rate, sides) for part in WIDTHS)
        found = next((one for one in tried if one is not None), None)
        if found is None or not LEAST <= found <= MOST:
            break
        points.append((rate, found))
    return points


WIDTHS = (1e-5, 1e-4, 1e-3, 3e-3, 0.01, 0.03, 0.1, 0.3)


@cache
def curves() -> tuple[tuple[str, tuple[tuple[float, float], ...]], ...]:
    """Return the curves through all boundaries, each with what coincides there."""
    step = (RATES[1] - RATES[0]) / STEPS
    found: list[tuple[str, tuple[str, str], tuple[tuple[float, float], ...]]] = []
    for one in plane(SCAN):
        sides = (one.below.name, one.above.name)
        known = (points for _, others, points in found if others == sides)
        if any(math.isclose(r, one.rate, rel_tol=1e-9) and math.isclose(mu, one.mu, rel_tol=1e-5)
               for points in known for r, mu in points):  # fmt: skip
            continue
        found.append((one.kind, sides, (*followed(one, -step)[:0:-1], *followed(one, step))))
    return tuple((kind, points) for kind, _, points in found)


def curve_table() -> list[str]:
    """How many boundaries lie on how many curves."""
    long = [points for _, points in curves() if len(points) > STEPS]
    rows = [[str(len(plane(SCAN))), str(len(curves())), str(len(long)), str(max(map(len, long)))]]
    return table(["boundaries on lines", "curves", "longer than from line to line", "points of the longest"], rows)


def picture() -> Figure:
    """Return the boundaries in the plane as curves, by what coincides."""
    figure, (left,) = panels(1, width=6.4, height=4.4)
    kinds = sorted({one.kind for one in plane(SCAN)})
    dashes: tuple[tuple[float, ...], ...] = ((), (1, 1.2), (6, 2), (3, 1.5), (6, 1.5, 1, 1.5))
    looks = zip([*COLOURS, INK, INK], "osv^D", dashes, strict=False)
    for kind, (colour, mark, dash) in zip(kinds, looks, strict=False):
        label: str | None = kind
        for points in (points for name, points in curves() if name == kind):
            rates, frictions = zip(*points, strict=True)
            (line,) = left.semilogx(frictions, rates, color=colour, linewidth=1.1, label=label)
            if dash:
                line.set_dashes(dash)
            if len(points) == 1:
                line.set(marker=mark, markersize=3.0)
            label = None
    left.set(xlabel="μ", ylabel="θ′ at the top, √(g/R)", xlim=(LEAST, MOST), ylim=(0.0, 1.05 / math.sqrt(GAMMA)))
    figure.legend(*left.get_legend_handles_labels(), loc="outside upper center", ncols=3, fontsize=8, frameon=False)
    return figure


STUDY = Study(
    name="sequences",
    texts={"kinds": kind_table, "scan": scan_table, "curves": curve_table, "friction": friction_table},
    pictures={"plane": picture},
)
