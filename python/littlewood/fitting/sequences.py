"""Sequences of phases that explain a track, and their probabilities."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from .._internal.elementwise import Reals
from .posterior import Mode, Posterior, posterior
from .problem import FINE, OF_HOOP, ROUGH, Problem
from .search import explains

__all__ = ["Compared", "compared"]


# Neighbours of a fit whose sequences are looked at, how far they are in standard errors, how many
# other sequences are fitted.
_NEIGHBOURS = 40
_SPREAD = 3.0
_MOVES = (1.0, 2.0, 4.0, 8.0)
_LEAST_MOVE = 0.01
_RIVALS = 4
_STEPS_OF_RIVAL = 15
# A slip of the start that is hardly one, √(g R).
_LEAST_SLIP = 0.03
# Minima whose evidence is less by so much are not looked at; sequences of a smaller part of the
# probability of the first are not named.
_HOPELESS = 30.0
# Two minima are one if they are so near, squares of standard errors.
_NEAR = 0.1
# So many samples tell a probability of all to a third; of fewer only the parts are taken.
_TELLING = 10.0
_LEAST_PART = 1e-3


@dataclass(frozen=True, eq=False)
class Compared:
    """The most probable fit.

    Attributes
    ----------
    problem : Problem
        Its problem.
    best : scipy.optimize.OptimizeResult
        Its minimum.
    sequences : dict of str to float
        Sequences of phases, the most probable first, and their probabilities.
    told : Posterior or None
        What samples of the unknowns say; None where only a normal approximation tells.
    """

    problem: Problem
    best: Any
    sequences: dict[str, float]
    told: Posterior | None


@dataclass(frozen=True, eq=False)
class _Minimum:
    """A minimum of a problem, and the sequence of its motion."""

    problem: Problem
    best: Any
    sequence: str
    evidence: float

    @classmethod
    def from_guess(cls, of: Problem, guess: Reals) -> _Minimum:
        return cls.of(of, of.refine(guess, "linear", ROUGH, _STEPS_OF_RIVAL))

    @classmethod
    def of(cls, of: Problem, best: Any) -> _Minimum:
        return cls(of, best, of.motion(best.x).sequence, _evidence(best))

    def is_near(self, other: _Minimum) -> bool:
        """Whether it is another one, to a part of its errors."""
        if self.problem.names != other.problem.names or self.sequence != other.sequence:
            return False
        apart = self.best.x - other.best.x
        return float(apart @ _normal(self.best) @ apart) < _NEAR


def compared(
    problem: Problem, best: Any, others: list[Reals], may_slip: bool, flies: bool
) -> Compared:
    """Fit other sequences of phases, and the other kind of start, where the start is free.

    Their probabilities are those of samples around all minima, or where too few samples count,
    of each minimum by Laplace's method.
    """
    found = [_Minimum.of(problem, best)]

    def add(of: Problem, guess: Reals) -> _Minimum:
        other = _Minimum.from_guess(of, guess)
        if not any(one.is_near(other) for one in found):
            found.append(other)
        return other

    for guess in _neighbours(problem, best, others):
        add(problem, guess)
    if problem.slips:
        first = max(found, key=lambda one: one.evidence)
        rolling = problem.rolling()
        add(rolling, problem.moved(first.best.x, rolling))
    elif may_slip:
        slipping = problem.slipping()
        for slip in (-_LEAST_SLIP, _LEAST_SLIP):
            add(slipping, problem.moved(best.x, slipping, start_slip=slip))
    on_floor = [
        one for one in found if "F" not in one.sequence and explains(one.problem, one.best.x)
    ]
    if on_floor and not flies:
        found = on_floor
    found.sort(key=lambda one: -one.evidence)
    weighed = _weighed(found)
    parts = weighed.probabilities
    winner = found[0]
    for sequence in sorted(parts, key=lambda one: -parts[one]):
        of_sequence = [one for one in found if one.sequence == sequence]
        one = of_sequence[0] if of_sequence else add(*weighed.samples[sequence])
        if one.sequence == sequence:
            winner = one
            break
    if winner.best is not best:
        fine = winner.problem.refine(winner.best.x, "linear", FINE)
        winner = _Minimum.of(winner.problem, fine)
    parts.setdefault(winner.sequence, 0.0)
    order = sorted(parts, key=lambda one: (one != winner.sequence, -parts[one]))
    return Compared(
        winner.problem,
        winner.best,
        {one: parts[one] for one in order},
        weighed.told.get(winner.problem.names),
    )


@dataclass(frozen=True, eq=False)
class _Weighed:
    """Probabilities of sequences, a good sample of each, and what is told by names of unknowns."""

    probabilities: dict[str, float]
    samples: dict[str, tuple[Problem, Reals]]
    told: dict[tuple[str, ...], Posterior]


def _weighed(found: Sequence[_Minimum]) -> _Weighed:
    """Return the probabilities of sequences with a start that rolls, or slips, or both."""
    groups: dict[tuple[str, ...], list[_Minimum]] = {}
    for one in found:
        if one.evidence > found[0].evidence - _HOPELESS:
            groups.setdefault(one.problem.names, []).append(one)
    logs: dict[str, float] = {}
    samples: dict[str, tuple[Problem, Reals]] = {}
    all_told: dict[tuple[str, ...], Posterior] = {}
    for names, fits in groups.items():
        of = fits[0].problem
        modes = [Mode(one.best.x, _normal(one.best), one.evidence, one.sequence) for one in fits]
        told = posterior(of, modes)
        if told is None:
            for one in fits:
                log = logs.get(one.sequence, -math.inf)
                logs[one.sequence] = float(np.logaddexp(one.evidence, log))
            continue
        all_told[names] = told
        whole = told.log_evidence
        if told.effective < _TELLING:
            whole = float(np.logaddexp.reduce([one.evidence for one in fits]))
        for name, part in told.sequences.items():
            log = whole + math.log(part)
            if log > logs.get(name, -math.inf):
                samples[name] = of, told.samples[name]
            logs[name] = float(np.logaddexp(log, logs.get(name, -math.inf)))
    most = max(logs.values())
    # What is less probable than samples resolve is left out.
    parts = {name: math.exp(max(log - most, -700.0)) for name, log in logs.items()}
    parts = {name: part for name, part in parts.items() if part > _LEAST_PART}
    total = sum(parts.values())
    return _Weighed({name: part / total for name, part in parts.items()}, samples, all_told)


def _neighbours(problem: Problem, best: Any, others: list[Reals]) -> list[Reals]:
    """Return guesses near a fit, or where the search ended, that may lead to other minima.

    They are the best guesses of each other sequence; and other coefficients of restitution, because
    bounces that hang on each other have many minima in one sequence.
    """
    rest = len(problem.names) - len(problem.camera_names)
    random = np.random.default_rng(0)
    low, high = problem.bounds()
    # What the track does not tell is anything within about 1, as in `_evidence`.
    root = np.sqrt(np.diag(np.linalg.inv(_normal(best))))
    more: list[Reals] = []
    guesses = [np.concatenate([other[:rest], best.x[rest:]]) for other in others]
    # Neighbours within a few standard errors, in all directions and by one parameter, which may be
    # of another sequence.
    for k, name in enumerate(problem.names):
        if name in OF_HOOP:
            moves = np.zeros((2 * len(_MOVES), root.size))
            moves[:, k] = np.concatenate([_MOVES, np.negative(_MOVES)]) * max(root[k], _LEAST_MOVE)
            moved = list(np.clip(best.x + moves, low, high))
            guesses += moved
            if name == "restitution" and np.any(best.jac[:, k]):
                more += moved
    for _ in range(_NEIGHBOURS):
        guesses.append(np.clip(best.x + _SPREAD * root * random.normal(size=root.size), low, high))
    first = problem.motion(best.x).sequence
    nearest: dict[str, tuple[float, Reals]] = {}
    for guess in guesses:
        sequence = problem.motion(guess).sequence
        if sequence != first:
            misfit = problem.misfit(guess)
            if sequence not in nearest or misfit < nearest[sequence][0]:
                nearest[sequence] = misfit, guess
    rivals = sorted(nearest.values(), key=lambda one: one[0])[:_RIVALS]
    return [guess for _, guess in rivals] + more


def _evidence(found: Any) -> float:
    """Return the logarithm of the probability of the measurements for a sequence.

    By Laplace's method.

    Beforehand each unknown is anything within about 1, in the units of the hoop.
    """
    return -float(found.cost) - 0.5 * float(np.linalg.slogdet(_normal(found))[1])


def _normal(found: Any) -> Reals:
    """Return the normal matrix of a fit, with what is known beforehand."""
    return np.asarray(found.jac.T @ found.jac + np.eye(found.x.size))
