"""Surfaces in the space of γ, μ and θ′.

Boundaries of neighbouring lines that a line halfway between has, too.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from .boundaries import Boundary, Line, boundaries, points_between

WIDTHS = (1e-3, 0.01, 0.05, 0.2)
"""Half widths of the intervals in which a boundary is looked for halfway, as parts of the
friction."""

TOLERANCE = 1e-5
"""Part of the friction to which it is told there."""

MARGIN, SCAN, NARROW = 1.5, 12, 1e-8
"""Where no such interval has just the two sequences: how far beyond both frictions the line halfway
is scanned, in how
many values, and to which part of the friction."""


@dataclass(frozen=True)
class Link:
    """Two boundaries of neighbouring lines with the same sequences, and that of a line halfway."""

    start: int
    end: int
    gamma: float
    part: float
    mu: float


@dataclass(frozen=True)
class Grid:
    """Lines of γ and parts, the boundaries on them, and what links those.

    Parameters
    ----------
    gammas, parts : sequence of float
        Values of the lines.
    found : sequence of Boundary
        Boundaries, line by line with rising friction.
    """

    gammas: Sequence[float]
    parts: Sequence[float]
    found: Sequence[Boundary]

    @cached_property
    def lines(self) -> dict[Line, list[int]]:
        """Places of the boundaries of each line."""
        lines: dict[Line, list[int]] = {
            (gamma, part): [] for gamma in self.gammas for part in self.parts
        }
        for place, one in enumerate(self.found):
            lines[one.gamma, one.part].append(place)
        return lines

    @cached_property
    def links(self) -> list[Link]:
        """Links along θ′ and along γ."""
        pairs = []
        for row, gamma in enumerate(self.gammas):
            for column, part in enumerate(self.parts):
                for other in (
                    (gamma, *self.parts[column + 1 : column + 2]),
                    (*self.gammas[row + 1 : row + 2], part),
                ):
                    if len(other) == 2:
                        pairs += self._aligned(self.lines[gamma, part], self.lines[other])
        return self._continued(pairs)

    def _aligned(self, one: list[int], other: list[int]) -> list[tuple[int, int]]:
        """Return the most boundaries that two lines have in the same order.

        They may be continued into each other.
        """
        most = np.zeros((len(one) + 1, len(other) + 1), dtype=int)
        same = [[self.found[i].sides == self.found[j].sides for j in other] for i in one]
        for i in range(len(one) - 1, -1, -1):
            for j in range(len(other) - 1, -1, -1):
                most[i, j] = max(most[i + 1, j], most[i, j + 1], most[i + 1, j + 1] + same[i][j])
        pairs, i, j = [], 0, 0
        while i < len(one) and j < len(other):
            if same[i][j] and most[i, j] == most[i + 1, j + 1] + 1:
                pairs.append((one[i], other[j]))
                i, j = i + 1, j + 1
            elif most[i + 1, j] >= most[i, j + 1]:
                i += 1
            else:
                j += 1
        return pairs

    def _continued(self, pairs: list[tuple[int, int]]) -> list[Link]:
        """Return the pairs between which a line halfway has a boundary with the same sequences."""
        ends = [(self.found[i], self.found[j]) for i, j in pairs]
        gamma = np.array([math.sqrt(a.gamma * b.gamma) for a, b in ends])
        part = np.array([math.sqrt(a.part * b.part) for a, b in ends])
        guess = np.array([math.sqrt(a.mu * b.mu) for a, b in ends])
        sides = [a.sides for a, _ in ends]
        mu = points_between(gamma, part, guess, sides, WIDTHS, TOLERANCE)
        left = np.flatnonzero(np.isnan(mu))
        low = np.array([min(ends[k][0].mu, ends[k][1].mu) / MARGIN for k in left])
        high = np.array([max(ends[k][0].mu, ends[k][1].mu) * MARGIN for k in left])
        lines = [(float(gamma[k]), float(part[k])) for k in left]
        halfway = defaultdict(list)
        for one in boundaries(lines, low, high, SCAN, NARROW):
            halfway[one.gamma, one.part, one.sides].append(one.mu)
        for k, line in zip(left, lines, strict=True):
            near = halfway.get((*line, sides[k]), [])
            mu[k] = min(near, key=lambda one: abs(math.log(one / guess[k])), default=math.nan)
        found = zip(pairs, gamma, part, mu, strict=True)
        return [
            Link(i, j, float(a), float(b), float(c))
            for (i, j), a, b, c in found
            if math.isfinite(c)
        ]

    def curves(self, gamma: float) -> list[tuple[list[int], list[tuple[float, float]]]]:
        """Return the curves of a plane: places of boundaries and the points through them.

        Points (part, μ) halfway, too.
        """
        onwards = {link.start: link for link in self.links if self._in_plane(link, gamma)}
        begun = {link.end for link in onwards.values()}
        curves = []
        for place, one in enumerate(self.found):
            if one.gamma != gamma or place in begun:
                continue
            places, points = [place], [(one.part, one.mu)]
            while places[-1] in onwards:
                link = onwards[places[-1]]
                places.append(link.end)
                points += [
                    (link.part, link.mu),
                    (self.found[link.end].part, self.found[link.end].mu),
                ]
            curves.append((places, points))
        return curves

    def _in_plane(self, link: Link, gamma: float) -> bool:
        return self.found[link.start].gamma == self.found[link.end].gamma == gamma
