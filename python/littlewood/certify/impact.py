"""The impact in closed form (docs/theory/impact.md), its case decided by balls."""

from __future__ import annotations

from dataclasses import dataclass, replace

from .balls import Ball, Undecided, arb, sign
from .body import Body, State


@dataclass(frozen=True)
class Impact:
    """An impact: its case, the impulses, the energy lost and the state after it."""

    case: str
    normal: Ball
    friction: Ball
    lost: Ball
    after: State
    evidence: dict[str, Ball]

    def times(self, v: Ball, rate: Ball) -> Impact:
        """Return the impact with all rates v times as large, and with θ′ beside that before it."""
        after = self.after
        after = replace(
            after, rate=rate + after.rate * v, slip=after.slip * v, gap_rate=after.gap_rate * v
        )
        return replace(
            self,
            after=after,
            normal=self.normal * v,
            friction=self.friction * v,
            lost=self.lost * v * v,
        )


def impact(body: Body, before: State, restitution: Ball, law: str) -> Impact:
    """Compute the impact of a rim that comes down, or, with no gap rate, of one that jams."""
    a, b, c = body.compliance(before.theta)
    slip, closing = before.slip, -before.gap_rate
    sigma = sign(slip, "the slip velocity before an impact")
    tangent = -body.mu_k * sigma
    e = restitution
    k1 = c + tangent * b
    stays = body.mu_s * a - abs(b)
    sticks = sign(stays, "μs A − |B|") >= 0
    r2 = -b / a if sticks else -body.mu_k * sign(b, "B")
    k2 = c + r2 * b
    evidence = {"k1": k1, "k2": k2, "sticks": stays}
    first: Ball | None = arb(0)
    if sigma != 0:
        slowing = body.mu_k * a - sigma * b
        first = abs(slip) / slowing if sign(slowing, "μk A − σ B") > 0 else None
        evidence["slowing"] = slowing
    jams = sigma != 0 and sign(k1, "k1") < 0
    whole = (1 + e) * closing
    if (
        not jams
        and sigma
        and (first is None or sign(k1 * first - whole, "whether slip ends in an impact") >= 0)
    ):
        case, normal, opening = "slides", whole / k1, e * closing
        slipping = normal
    else:
        if first is None:
            raise Undecided("an impact jams without an end of slip")
        slipping = first
        v1 = k1 * first - closing if sigma != 0 else -closing
        if sigma == 0 or sign(v1, "the gap rate where slip ends") <= 0:
            compression = first - v1 / k2
            if law == "energetic":
                work = (closing - v1) * first / 2 + v1 * v1 / (2 * k2)
                opening = e * (2 * work * k2).sqrt() if not e.is_zero() else arb(0)
            elif law == "poisson":
                opening = e * compression * k2
            else:
                opening = e * closing
            normal = compression + opening / k2
            case = "jams" if jams else f"{'sticks' if sticks else 'reverses'}_in_compression"
        else:
            if law == "energetic":
                opening = (v1 * v1 + k2 / k1 * (e * e * closing * closing - v1 * v1)).sqrt()
            elif law == "poisson":
                opening = v1 + k2 * (whole / k1 - first)
            else:
                opening = e * closing
            normal = first + (opening - v1) / k2
            case = f"{'sticks' if sticks else 'reverses'}_in_restitution"
        evidence["slip_ends"] = v1
    friction = tangent * slipping + r2 * (normal - slipping)
    after_slip = slip + a * friction + b * normal
    if case != "slides" and sticks:
        after_slip = arb(0)
    arm, lever = body.h * before.theta.sin(), 1 + body.h * before.theta.cos()
    after = replace(
        before,
        rate=before.rate + (arm * normal + lever * friction) / body.inertia,
        slip=after_slip,
        gap=arb(0),
        gap_rate=opening,
    )
    lost = -(friction * (slip + after_slip) + normal * (before.gap_rate + opening)) / 2
    return Impact(case, normal, friction, lost, after, evidence)
