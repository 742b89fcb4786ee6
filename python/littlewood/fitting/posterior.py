"""Probabilities of unknowns and sequences beyond a normal approximation, by weighted samples."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from .._internal.elementwise import Reals
from .problem import Problem

__all__ = ["Mode", "Posterior", "posterior"]


# Samples of each turn. They end where so many of all of them count in effect: these tell a variance
# to a seventh.
_SAMPLES = (200, 300, 1000)
_ENOUGH = 100.0
# Student's distribution with so many degrees of freedom has tails that bear curved valleys.
_FREEDOM = 5.0
# Fewer samples than this, in effect, tell nothing.
_FEWEST = 3.0
_TINY = 1e-14


@dataclass(frozen=True, eq=False)
class Mode:
    """A minimum of the sum of squares.

    Attributes
    ----------
    unknowns : ndarray
        Where it is.
    normal : ndarray
        Normal matrix there, with what is known beforehand.
    evidence : float
        Logarithm of its probability by Laplace's method.
    sequence : str
        Phases of its motion.
    """

    unknowns: Reals
    normal: Reals
    evidence: float
    sequence: str


@dataclass(frozen=True, eq=False)
class Posterior:
    """What samples say of the unknowns of a problem.

    Attributes
    ----------
    log_evidence : float
        Logarithm of the probability of the measurements.
    sequences : dict of str to float
        Probabilities of sequences of phases.
    samples : dict of str to ndarray
        The best sample of each of them.
    moments : ndarray
        Mean products of the distances from the best mode.
    effective : float
        How many samples count.
    """

    log_evidence: float
    sequences: dict[str, float]
    samples: dict[str, Reals]
    moments: Reals
    effective: float


def posterior(problem: Problem, modes: Sequence[Mode]) -> Posterior | None:
    """Weigh samples around modes, the best of which is the first; None where too few count.

    They are drawn from Student's distributions about the modes, then from one about what these
    weigh as well, and weighted by the likelihood over the density from which all are drawn.
    Beforehand each unknown is within about 1 of the best mode, in the units of the hoop.
    """
    random = np.random.default_rng(0)
    best = modes[0].unknowns
    moves = _moving(modes)
    size = int(moves.sum())
    centres = [one.unknowns[moves] for one in modes]
    roots = [_root(np.asarray(np.linalg.inv(one.normal[np.ix_(moves, moves)]))) for one in modes]
    shares = np.exp(np.clip([one.evidence - modes[0].evidence for one in modes], -50.0, 50.0))
    shares = np.maximum(shares / shares.sum(), 0.5 / len(modes))
    drawn, owned = np.empty((0, size)), np.zeros(0)
    logs: Reals = np.empty(0)
    names: list[str] = []
    for count in _SAMPLES:
        shares = shares / shares.sum()
        new = _drawn(random, shares, centres, roots, count)
        drawn = np.concatenate([drawn, new])
        found = [_likelihood(problem, best, one) for one in _whole(best, moves, new)]
        logs = np.append(logs, [log for log, _ in found])
        names += [name for _, name in found]
        # Of all samples so many are drawn about each centre: all turns are one mixture, so that a
        # sample in the tail of one of them, where another is dense, does not outweigh the rest.
        owned = np.append(owned, np.zeros(shares.size - owned.size)) + count * shares
        density = np.logaddexp.reduce(
            [
                math.log(part / logs.size) + _log_density(drawn, centre, root)
                for part, centre, root in zip(owned, centres, roots, strict=True)
            ]
        )
        ratios = logs - density
        most = float(np.max(ratios))
        if not math.isfinite(most):
            return None
        weights = np.exp(ratios - most)
        total = float(weights.sum())
        weights = weights / total
        effective = 1.0 / float(np.sum(np.square(weights)))
        if effective >= _ENOUGH:
            break
        if effective >= 2.0 * size:
            centres.append(np.asarray(weights @ drawn, dtype=np.float64))
            apart = drawn - centres[-1]
            roots.append(_root((weights * apart.T) @ apart))
            shares = np.append(shares, 1.0)
    if effective < _FEWEST:
        return None
    samples = _whole(best, moves, drawn)
    moved = samples - best
    sequences: dict[str, float] = {}
    samples_of: dict[str, Reals] = {}
    for k in np.argsort(-ratios):
        if weights[k] > 0.0:
            sequences[names[k]] = sequences.get(names[k], 0.0) + float(weights[k])
            samples_of.setdefault(names[k], samples[k])
    return Posterior(
        log_evidence=most + math.log(total / logs.size) - 0.5 * size * math.log(math.tau),
        sequences=sequences,
        samples=samples_of,
        moments=(weights * moved.T) @ moved,
        effective=effective,
    )


def _moving(modes: Sequence[Mode]) -> npt.NDArray[np.bool_]:
    """Return which unknowns are drawn.

    What no motion depends on stays as it is; but if it takes another sequence to another mode, as
    the excess of μs over μk does that is 0 at a bound, the sequences differ by its volume.
    """
    best = modes[0]
    moves = np.any([np.diag(one.normal) > 1.0 + _TINY for one in modes], axis=0)
    others = [one.unknowns != best.unknowns for one in modes if one.sequence != best.sequence]
    return np.asarray(moves | np.any(others, axis=0))


def _whole(best: Reals, moves: npt.NDArray[np.bool_], drawn: Reals) -> Reals:
    """Return all unknowns of samples of those that move."""
    samples = np.tile(best, (drawn.shape[0], 1))
    samples[:, moves] = drawn
    return samples


def _likelihood(problem: Problem, best: Reals, sample: Reals) -> tuple[float, str]:
    """Return the logarithm of the probability of a sample, and its sequence of phases."""
    low, high = problem.bounds()
    if np.any(sample < low) or np.any(sample > high):
        return -math.inf, ""
    moved = sample - best
    log = -problem.cost(sample) - 0.5 * float(moved @ moved)
    return log, problem.motion(sample).sequence


def _root(covariance: Reals) -> Reals:
    """Return a matrix whose product with its transpose is a covariance, rounded or not."""
    sizes = np.sqrt(np.maximum(np.diag(covariance), _TINY))
    values, vectors = np.linalg.eigh(covariance / sizes / sizes[:, None])
    values = np.maximum(values, _TINY * values[-1])
    return np.asarray(sizes[:, None] * vectors * np.sqrt(values), dtype=np.float64)


def _drawn(
    random: np.random.Generator,
    shares: Reals,
    centres: Sequence[Reals],
    roots: Sequence[Reals],
    count: int,
) -> Reals:
    """Draw from a mixture of Student's distributions."""
    owners = random.choice(len(centres), size=count, p=shares)
    normals = random.normal(size=(count, centres[0].size))
    wide = np.sqrt(_FREEDOM / random.chisquare(_FREEDOM, count))
    rows = zip(owners, normals, wide, strict=True)
    return np.array([centres[k] + roots[k] @ row * stretch for k, row, stretch in rows])


def _log_density(samples: Reals, centre: Reals, root: Reals) -> Reals:
    """Logarithm of the density of Student's distribution."""
    size = centre.size
    scaled = np.linalg.solve(root, (samples - centre).T)
    whole = 0.5 * (_FREEDOM + size)
    constant = math.lgamma(whole) - math.lgamma(0.5 * _FREEDOM)
    constant -= 0.5 * size * math.log(_FREEDOM * math.pi)
    constant -= float(np.linalg.slogdet(root)[1])
    return np.asarray(constant - whole * np.log1p(np.sum(np.square(scaled), axis=0) / _FREEDOM))
