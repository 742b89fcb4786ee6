"""One impact, followed in its normal impulse p (docs/theory/impact.md).

The gap rate v is a line in p, of slope k1 = C − σ μk B while the contact slips, up to the *bend* where the slip ends,
bend = |η′|/(μk A − σ B); from there on of slope k2 = C + B r, r = −B/A if it sticks (μs A ≥ |B|), else it slips back,
r = −μk sign B. Compression ends where v = 0. Restitution ends where v = −e v0 (Newton's law), p is 1 + e times that
of compression (Poisson's), or the work of the normal impulse is e² times that of compression (energetic).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from .body import Body, State
from .ranges import Inconclusive, Range, sine_and_cosine


@dataclass(frozen=True)
class Impact:
    """The state after it, its impulses, its case, and the numbers that decide it."""

    after: State
    normal: Range
    friction: Range
    case: str
    evidence: dict[str, Range]


def impact(body: Body, before: State, e: Range, law: str) -> Impact:
    """Follow an impact; without a gap rate it is a jam."""
    s, c = sine_and_cosine(before.theta)
    a, b, across = body.compliances(s, c)
    sigma, v0 = before.slip.sign(), before.gap_rate
    grip = body.mu_s * a - abs(b)
    sticks = grip.sign() >= 0
    f, r = -(body.mu_k * sigma), -(b / a) if sticks else -(body.mu_k * b.sign())
    k1, k2 = across + b * f, across + b * r
    falls = b * (f - r)
    evidence = {"k1": k1, "k2": k2, "sticks": grip}
    bend: Range | None = Range(0)
    if sigma:
        slowing = evidence["slowing"] = body.mu_k * a - b * sigma
        bend = abs(before.slip) / slowing if slowing.sign() > 0 else None
    jams = sigma != 0 and k1.sign() < 0
    v1 = None if bend is None else v0 + k1 * bend
    # Whether compression, and then restitution, ends before the slip does.
    first = sigma != 0 and not jams and (v1 is None or v1.sign() > 0)
    whole = -(v0 / k1) * (1 + e) if first else None
    if whole is not None and (bend is None or (bend - whole).sign() >= 0):
        case, normal, opening, slipping = "slides", whole, -(e * v0), whole
        slip = before.slip + (a * f + b) * normal
    elif bend is None or v1 is None:
        raise Inconclusive("an impact jams for ever")
    else:
        evidence["slip_ends"], slipping = v1, bend
        # In v0 and the bend with small factors, so that radii do not grow from bounce to bounce.
        if law == "newton":
            opening = -(e * v0)
        elif law == "poisson" and whole is not None:
            opening = v0 * (1 - k2 / k1 * (1 + e)) + falls * bend
        elif law == "poisson":
            opening = -(e * (v0 + falls * bend))
        elif whole is not None:
            opening = (e * e * v0 * v0 * k2 / k1 + v1 * v1 * falls / k1).sqrt()
        elif e.is_zero():
            opening = Range(0)
        else:
            opening = e * (v0 * v0 + falls * bend * (2 * v0 + k1 * bend)).sqrt()
        normal = (opening - v0 - falls * bend) / k2
        end = "jams" if jams else ("restitution" if first else "compression")
        case = end if jams else f"{'sticks' if sticks else 'reverses'}_in_{end}"
        slip = Range(0) if sticks else before.slip + a * (f - r) * bend + (a * r + b) * normal
    friction = r * normal + (f - r) * slipping
    spin = (body.h * s * normal + (1 + body.h * c) * friction) / body.inertia
    after = replace(before, rate=before.rate + spin, slip=slip, gap=Range(0), gap_rate=opening)
    return Impact(after, normal, friction, case, evidence)
