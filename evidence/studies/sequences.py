"""The sequences of the first turn, and the boundaries between them, where two events coincide."""

from __future__ import annotations

import csv
import math
from collections import Counter, defaultdict
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import numpy as np
from littlewood.plot.sheet import panels
from littlewood.style import ACCENTS, FAINT, INK, LINE, LIST_DASHES, SOFT
from matplotlib.figure import Figure

from .boundaries import boundaries, rate_of
from .contact import Contact
from .frictionless import degenerate_rates
from .study import PAGES, Study
from .surfaces import Grid
from .turns import Floats, Turn, first_turn, hoop_of, names_of, slides_of

LEAST, MOST = 0.005, 2.0
"""Range of the friction."""

GAMMAS = tuple(round(0.05 * k, 2) for k in range(2, 16))
"""Planes. In the last the particle is on the rim."""

PARTS = tuple((k + 0.5) / 32 for k in range(32))
"""Lines of a plane: θ′ at the top as a part of 1/√γ, above which the hoop leaves the ground at
once."""

SCAN = 30
"""Values of the friction on a line, between which boundaries are looked for."""


@cache
def family() -> Grid:
    """Return the boundaries on all lines of all planes."""
    return Grid(
        GAMMAS,
        PARTS,
        boundaries([(gamma, part) for gamma in GAMMAS for part in PARTS], LEAST, MOST, SCAN),
    )


def kinds_text() -> str:
    """What coincides at the boundaries."""
    return ", ".join(
        f"{count} {kind}"
        for kind, count in Counter(one.kind for one in family().found).most_common()
    )


@cache
def listed_starts() -> dict[str, tuple[float, float, float]]:
    """Return the widest interval of μ of each sequence with its stop on the lines.

    By γ, the part and the middle.
    """
    grid = family()
    widest: dict[str, tuple[float, tuple[float, float, float]]] = {}
    for (gamma, part), line in grid.lines.items():
        found = [grid.found[place] for place in line]
        if not found:
            continue
        ends = [LEAST, *(one.mu for one in found), MOST]
        for name, low, high in zip(
            [found[0].below, *(one.above for one in found)], ends, ends[1:], strict=False
        ):
            if high / low > widest.get(name, (0.0,))[0]:
                widest[name] = high / low, (gamma, part, math.sqrt(low * high))
    return {name: start for name, (_, start) in widest.items()}


def degenerate_parts(gamma: float) -> list[float]:
    """Return θ′√γ at the top at which the turn without friction gains or loses reversals."""
    return [one * math.sqrt(gamma) for one in degenerate_rates(Contact.of(hoop_of(0.0, gamma)))]


def listed_text() -> str:
    """How many sequences with stops the lines have."""
    return str(len(listed_starts()))


DRAWN = 20_000


@cache
def drawn() -> tuple[tuple[Floats, Floats, Floats], Counter[str]]:
    """Return random starts of the family, and how often each sequence is theirs."""
    random = np.random.default_rng(16)
    gamma, part = random.uniform(GAMMAS[0], GAMMAS[-1], DRAWN), random.uniform(0.0, 1.0, DRAWN)
    mu = np.exp(random.uniform(math.log(LEAST), math.log(MOST), DRAWN))
    rate = rate_of(gamma, part)
    return (gamma, mu, rate), Counter(names_of(gamma, mu, rate).tolist())


def drawn_text() -> str:
    """How many random starts have a sequence that the list has not."""
    number = drawn()[1]
    missing = {name: count for name, count in number.items() if name not in listed_starts()}
    return f"{sum(missing.values())} of {DRAWN:,} starts, with {len(missing)} sequences"


@dataclass(frozen=True)
class Region:
    """A region of starts of one family, and how many of them are drawn in a search.

    Parameters
    ----------
    gamma, part, mu : pair of float
        Ranges; μ is drawn by its logarithm.
    rim : bool
        Whether the hoops are thin ones with the particle on the rim.
    """

    gamma: tuple[float, float]
    part: tuple[float, float]
    mu: tuple[float, float]
    count: int
    rim: bool = False


CORNER = Region((0.2, 0.37), (0.68, 0.8), (10**-2.9, 10**-1.7), 150_000)
"""Where most of the sequences are that the lines do not have."""

RIM = Region((0.1, 0.97), (0.0, 1.0), (LEAST, MOST), 50_000, rim=True)


@cache
def searched(region: Region, seed: int) -> dict[str, tuple[float, float, float]]:
    """Return the sequences of random starts of a region.

    Each has γ, the part and μ of its start of the largest μ.
    """
    random = np.random.default_rng(seed)
    gamma, part = (
        random.uniform(*region.gamma, region.count),
        random.uniform(*region.part, region.count),
    )
    mu = np.exp(random.uniform(math.log(region.mu[0]), math.log(region.mu[1]), region.count))
    words = names_of(gamma, mu, rate_of(gamma, part), rim=region.rim)
    order = np.argsort(mu)
    starts = zip(gamma[order].tolist(), part[order].tolist(), mu[order].tolist(), strict=True)
    return dict(zip(words[order].tolist(), starts, strict=True))


@dataclass(frozen=True)
class Recapture:
    """Two independent searches of a region, and what they say of the number of its sequences.

    Parameters
    ----------
    first, second : set of str
        Sequences that each has found.
    """

    first: set[str]
    second: set[str]

    @classmethod
    def of(cls, region: Region, known: Iterable[str] = ()) -> Recapture:
        """Search a region twice for sequences that are not known."""
        one, two = (searched(region, seed) for seed in (1, 2))
        return cls(set(one) - set(known), set(two) - set(known))

    @property
    def found(self) -> set[str]:
        """All that are found."""
        return self.first | self.second

    @property
    def estimate(self) -> float:
        """Chapman's estimate of how many there are, were all equally easy to find."""
        return (len(self.first) + 1) * (len(self.second) + 1) / (
            len(self.first & self.second) + 1
        ) - 1

    @property
    def told(self) -> str:
        """The numbers in words."""
        both = len(self.first & self.second)
        return (
            f"{len(self.first)} and {len(self.second)} sequences with stops, {both} of them both, "
            f"{len(self.found)} together, and the estimate is {self.estimate:.1f}"
        )


def corner_text() -> str:
    """What two searches find in the corner."""
    return Recapture.of(CORNER, listed_starts()).told


UNFOUND = (0.249967916028383, 0.007794611384076971, 0.7063085869522819)
"""γ, μ and θ′√γ of a start in the corner, from another search, with a sequence that neither of the
two has."""


def unfound() -> Turn:
    """Return the turn of that start."""
    gamma, mu, part = UNFOUND
    return first_turn(gamma, mu, part / math.sqrt(gamma))


def unfound_text() -> str:
    """The sequence of that start."""
    gamma, mu, part = UNFOUND
    return f"`{unfound().word}` ({gamma!r}, {part!r}, {mu!r})"


def rim_text() -> str:
    """What two searches of rim hoops find."""
    return Recapture.of(RIM).told


def most_slides() -> tuple[int, int]:
    """Return the largest number of slides of all starts of the searches.

    And their phases at most.
    """
    every = {*listed_starts(), *drawn()[1], *Recapture.of(CORNER).found, *Recapture.of(RIM).found}
    return max(map(slides_of, every)), max(len(name.split()[0]) for name in every)


def slides_text() -> str:
    """The largest numbers of slides and of phases."""
    most, phases = most_slides()
    return f"{most} slides or {phases} phases"


def longest_rows() -> list[dict[str, str]]:
    """Return the lines of the search for many slides."""
    with (PAGES / "sequences" / "longest.csv").open(encoding="utf-8") as file:
        return list(csv.DictReader(file))


def longest_text() -> str:
    """How many turns the search has, and how many of these the most slides."""
    told = []
    for family_of, hoops in (
        ("shift", "of these hoops"),
        ("rim", "of thin hoops with the particle on the rim"),
    ):
        rows = [row for row in longest_rows() if row["family"] == family_of]
        counts = [sum(int(row[f"slides_{count}"]) for row in rows) for count in range(10)]
        most = max(count for count, number in enumerate(counts) if number)
        share = f"{counts[most] / 1e6:.1f} million with {most} slides and none with more"
        told.append(f"{sum(counts) / 1e6:g} million turns {hoops}, {share}")
    return "; ".join(told)


def listed() -> str:
    """Return the sequences of all searches as CSV, each with one start."""
    (gamma, mu, rate), _ = drawn()
    names_drawn = names_of(gamma, mu, rate).tolist()
    parts = (rate * np.sqrt(gamma)).tolist()
    rows: dict[tuple[str, str], tuple[str, tuple[float, float, float]]] = {}
    for family_of, source, starts in (
        ("shift", "lines", listed_starts()),
        (
            "shift",
            "random",
            dict(
                zip(names_drawn, zip(gamma.tolist(), parts, mu.tolist(), strict=True), strict=True)
            ),
        ),
        ("shift", "corner", {**searched(CORNER, 1), **searched(CORNER, 2)}),
        ("shift", "other", {unfound().name: (UNFOUND[0], UNFOUND[2], UNFOUND[1])}),
        ("rim", "rim", {**searched(RIM, 1), **searched(RIM, 2)}),
    ):
        for name, start in starts.items():
            rows.setdefault((family_of, name), (source, start))
    lines = ["family,sequence,stop,gamma,rate_times_root_gamma,mu,search"]
    for (family_of, name), (source, start) in sorted(rows.items()):
        word, stop = name.split(maxsplit=1)
        lines.append(
            ",".join([family_of, word, stop, *(repr(float(one)) for one in start), source])
        )
    return "\n".join(lines) + "\n"


SHOWN = (0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.75)


def picture() -> Figure:
    """Return the boundaries in planes of γ as curves, by what coincides."""
    grid = family()
    kinds = sorted({one.kind for one in grid.found} - {"not told"})
    colours = [*ACCENTS.values(), INK, SOFT, FAINT]
    dashes = (*LIST_DASHES[: len(colours) - 1], "solid")
    looks = dict(zip(kinds, zip(colours, dashes, strict=True), strict=True))
    figure, axes = panels(len(SHOWN), columns=3, height=230.0, sharex=True, sharey=True)
    for panel, gamma in zip(axes, SHOWN, strict=True):
        panel.set_title(f"*γ* = {gamma:g}")
        alone: defaultdict[str, list[tuple[float, float]]] = defaultdict(list)
        for places, points in grid.curves(gamma):
            kind = grid.found[places[0]].kind
            if len(points) == 1:
                alone[kind] += points
                continue
            colour, dash = looks.get(kind, (LINE, "solid"))
            parts, frictions = zip(*points, strict=True)
            panel.semilogx(frictions, parts, color=colour, linestyle=dash)
        for kind, points in alone.items():
            parts, frictions = zip(*points, strict=True)
            panel.semilogx(
                frictions, parts, ".", color=looks.get(kind, (LINE, ""))[0], markersize=2.5
            )
        for part in degenerate_parts(gamma):
            panel.plot([LEAST], [part], color=INK, marker=">", clip_on=False)
        panel.set(xlim=(LEAST, MOST), ylim=(0.0, 1.0))
    figure.supxlabel("*μ*")
    figure.supylabel("*θ*′√*γ* at the top")
    for kind, (colour, dash) in looks.items():
        axes[0].plot([], [], color=colour, linestyle=dash, label=kind)
    axes[0].plot([], [], ".", color=INK, markersize=2.5, label="the same, not continued")
    axes[0].plot([], [], ">", color=INK, label="degenerate without friction")
    handles, labels = axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper left", ncols=2)
    return figure


STUDY = Study(
    name="sequences",
    texts={
        "listed": listed_text,
        "kinds": kinds_text,
        "drawn": drawn_text,
        "corner": corner_text,
        "unfound": unfound_text,
        "rim": rim_text,
        "most": slides_text,
        "longest": longest_text,
    },
    pictures={"planes": picture},
    files={"list.csv": listed},
)
