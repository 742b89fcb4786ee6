"""Which motion follows (docs/theory/contact.md): each is held against its conditions, and one has to be left.

With w, P and the forces N and F of rolling: where the contact slips towards σ it slides if w > 0 and P > 0, flies if
w < 0 and P > 0, no motion is consistent if w > 0 > P and two are if both are negative. At rest
*rolling* needs N > 0 and |F| < μs N; *sliding* towards σ needs w/P > 0 and σ η″ > 0, that is −(σ F + μk N) P > 0,
and is left out where rolling is consistent; *flight* needs w < 0.
"""

from __future__ import annotations

from dataclasses import dataclass

from .body import State
from .given import Given
from .phase import FLIGHT, GLIDING, ROLLING, SLIDING
from .ranges import Inconclusive, Range, sine_and_cosine

INCONSISTENT, AMBIGUOUS = "inconsistent", "ambiguous"


@dataclass(frozen=True)
class Next:
    """What follows, the numbers that decide it, and the order of the zero with which its slip or its gap begins."""

    mode: str
    direction: int
    evidence: dict[str, Range]
    order: int = 0


def decide(given: Given, state: State, gives_way: int = 0) -> Next:
    """Decide what follows on the plane; static friction has just given way to this direction, if it is not 0."""
    body, (s, c), omega = given.body, sine_and_cosine(state.theta), state.rate
    moving = state.slip.sign()
    normal, friction = body.forces(s, c, omega, body.rolling(s, c, omega))
    forces = {"rolling_normal": normal, "rolling_friction": friction}
    if given.massless:
        return _massless(given, state, moving, forces, gives_way)
    w = body.weight(c, omega)
    evidence, presses = {"contact": w}, w.sign()
    if presses == 0:
        raise Inconclusive("w vanishes where a motion begins")
    if moving:
        p = evidence["solvability"] = body.solvability(s, c, moving)
        mode = {(1, 1): SLIDING, (-1, 1): FLIGHT, (1, -1): INCONSISTENT}.get((presses, p.sign()), AMBIGUOUS)
        return Next(mode, moving if presses > 0 else 0, evidence, 2 if mode == FLIGHT else 0)
    evidence |= forces
    grip = body.mu_s * normal
    holds = not gives_way and normal.sign() > 0
    holds = holds and (given.balanced or ((grip - friction).sign() > 0 and (grip + friction).sign() > 0))
    if holds and presses > 0:
        return Next(ROLLING, 0, evidence)
    solvable = {sigma: body.solvability(s, c, sigma) for sigma in (-1, 1)}
    evidence |= {"solvability_negative": solvable[-1], "solvability_positive": solvable[1]}
    consistent = [Next(ROLLING, 0, evidence)] if holds else []
    for sigma, p in solvable.items():
        if holds or p.sign() != presses:
            continue
        # Where static friction gives way and kinetic friction is equal, η″ = 0 and η‴ drives the slip.
        tie = gives_way == sigma and given.equal and presses > 0
        if tie or (-(friction * sigma + body.mu_k * normal) * p).sign() > 0:
            consistent.append(Next(SLIDING, sigma, evidence, 2 if tie else 1))
    if presses < 0:
        consistent.append(Next(FLIGHT, 0, evidence, 2))
    if len(consistent) == 1:
        return consistent[0]
    return Next(AMBIGUOUS if consistent else INCONSISTENT, 0, evidence)


def _massless(given: Given, state: State, moving: int, forces: dict[str, Range], gives_way: int) -> Next:
    """Decide for a massless hoop: it rolls, or glides without any force."""
    if moving:
        return Next(GLIDING, moving, {})
    s, c = sine_and_cosine(state.theta)
    presses = (1 - state.rate * state.rate).sign()
    if not gives_way and presses > 0 and (given.body.mu_s * (1 + c) - abs(s)).sign() > 0:
        return Next(ROLLING, 0, forces)
    # Gliding has η″ = (1 + c) (1 − θ′²)/s.
    direction = s.sign() * presses
    if direction == 0:
        raise Inconclusive("a glide begins without any acceleration of slip")
    return Next(GLIDING, direction, forces, 1)
