"""A hoop with rolling resistance, its modes, and its balances of force and moment."""

from typing import NamedTuple

import gmpy2
from follower.arithmetic import Tie
from follower.hoop import Hoop
from gmpy2 import mpfr

TIE = mpfr("1e-38")  # margins below this are not told from zero


class Body(Hoop):
    """The hoop of `follower`, with the coefficient of rolling resistance before the slope."""

    def __init__(self, mass_ratio, offset, inertia, mu_s, mu_k, chi, slope=0):
        super().__init__(mass_ratio, offset, inertia, mu_s, mu_k, slope)
        self.chi = mpfr(chi)


class Mode(NamedTuple):
    """A mode of motion: the signs of eta' and of theta', 0 where the contact holds them at zero."""

    name: str
    slips: int
    turns: int


class State(NamedTuple):
    """Angle, its rate, slip velocity, and place of the centre."""

    theta: mpfr
    rate: mpfr
    slip: mpfr
    x: mpfr


class Answer(NamedTuple):
    """What the balances determine at an instant."""

    along: mpfr  # x''
    turn: mpfr  # theta''
    normal: mpfr
    friction: mpfr
    couple: mpfr


FLIGHT = Mode("flight", 0, 0)


def contact_mode(slips, turns, massless=False):
    """The mode in contact with these signs. A massless hoop that slips and turns glides."""
    slide = "gliding" if massless else "sliding"
    names = {(False, False): "rest", (False, True): "rolling", (True, False): "skidding"}
    return Mode(names.get((slips != 0, turns != 0), slide), slips, turns)


def inverse(matrix):
    """Inverse of a matrix, by Gauss's and Jordan's elimination with pivots."""
    size = len(matrix)
    rows = [[*map(mpfr, row), *(mpfr(k == j) for j in range(size))] for k, row in enumerate(matrix)]
    for k in range(size):
        best = max(range(k, size), key=lambda j: abs(rows[j][k]))
        if abs(rows[best][k]) < TIE:
            raise Tie("no regular solution")
        rows[k], rows[best] = rows[best], rows[k]
        pivot = rows[k][k]
        rows[k] = [v / pivot for v in rows[k]]
        for j in range(size):
            if j != k and rows[j][k]:
                factor = rows[j][k]
                rows[j] = [v - factor * p for v, p in zip(rows[j], rows[k])]
    return [row[size:] for row in rows]


def balances(body, mode, sine, cosine):
    """Matrix of the balances for (x'', theta'', N, F, K) with y'' = 0.

    Mass centre at (x - h sin theta, 1 + h cos theta); contact point from it at (h sin theta, -1 - h
    cos theta). Rows: m xG'' = F - m sin slope, m yG'' = N - m cos slope,
    I theta'' = h sin theta N + (1 + h cos theta) F + K;
    then eta'' = x'' + theta'' = 0 or F = -mu_k sign(eta') N;
    then theta'' = 0 or K = -chi sign(theta') N.
    """
    m, h = body.m, body.h
    sticks, slides = (1, 1, 0, 0, 0), (0, 0, body.mu_k * mode.slips, 1, 0)
    holds, turns = (0, 1, 0, 0, 0), (0, 0, body.chi * mode.turns, 0, 1)
    return [
        (m, -m * h * cosine, 0, -1, 0),
        (0, -m * h * sine, -1, 0, 0),
        (0, body.i, -h * sine, -(1 + h * cosine), -1),
        slides if mode.slips else sticks,
        turns if mode.turns else holds,
    ]


def answer(body, mode, state):
    """Accelerations, forces and couple in a mode of contact."""
    s, c = gmpy2.sin_cos(state.theta)
    m, h, u = body.m, body.h, state.rate * state.rate
    known = (-m * (h * s * u + body.along), m * (h * c * u - body.down), 0, 0, 0)
    solution = inverse(balances(body, mode, s, c))
    return Answer(*(sum(v * k for v, k in zip(row, known)) for row in solution))


def rises(body, state):
    """y'' without a force of the plane: positive where free fall of the centre lifts the rim."""
    return body.h * gmpy2.cos(state.theta) * state.rate * state.rate - body.down


def energy(body, state, gap=0, gap_rate=0):
    """Kinetic energy, and the potential energy as in `motions.py`."""
    s, c = gmpy2.sin_cos(state.theta)
    m, h, rate = body.m, body.h, state.rate
    along, up = state.slip - rate - h * c * rate, gap_rate - h * s * rate
    high = body.down * (h * c + gap) + body.along * (state.x - h * s)
    return m * (along * along + up * up) / 2 + body.i * rate * rate / 2 + m * high
