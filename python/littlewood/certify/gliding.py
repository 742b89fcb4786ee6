"""Gliding of Littlewood's hoop.

No force acts, the particle falls freely, and the hoop turns as it has to.

With the height Y = cos θ of the particle, V = Y′ and r² = V0² + 2 (1 + Y0) the particle is at the
plane, Y = −1, at τ = V0 + r. In p with τ = V0 + r − p², p from below to 0, everything is analytic
up to that end: 1 + Y = p² A with A = r − p²/2, V = p² − r, and η′ = v − side (r − p²) p √(A/(1 −
Y)), side the sign of sin θ, v = η′ − (1 + cos θ) θ′ a constant.
"""

from __future__ import annotations

from collections.abc import Iterator

from .balls import Ball, Beyond, Undecided, arb, discs, sign
from .body import Body, Next, State
from .model import Model, polynomial
from .phase import Piece

SLIP, PLANE, TURNING = "slip", "particle_height", "theta_rate"


class Glide:
    """A glide from a state in a direction; the slip begins with a zero of this order.

    With rolling resistance it ends where the particle is highest, and θ′ = 0.
    """

    def __init__(self, start: State, sigma: int, order: int, resists: bool) -> None:
        self.start, self.sigma, self.order = start, sigma, order
        sin, cos = start.theta.sin(), start.theta.cos()
        self.sin = sin
        self.side = sign(sin, "sin θ")
        if self.side == 0:
            raise Beyond("a glide begins with the particle above or below the centre")
        rise = -sin * start.rate
        if not cos + rise * rise / 2 < 1:
            raise Beyond("the particle comes to the top with velocity to spare")
        self.drift = start.slip - (1 + cos) * start.rate
        self.turns_back = resists and sign(rise, "θ′ of a glide") > 0
        self.root = (rise * rise + 2 * (1 + cos)).sqrt()
        self.whole = rise + self.root
        self.turns = round(float((start.theta / (2 * arb.pi())).mid()))

    def pieces(self) -> Iterator[Piece]:
        """Yield the glide piece by piece, to a little beyond the end."""
        at, order = -self.whole.sqrt(), self.order
        while at < 0.1:
            radius, size = self._disc(at)
            p = polynomial([at, arb(1)], radius)
            square = p * p
            a = square * arb(-0.5) + self.root
            b = 2 - square * a
            ratio = Model((a.series / b.series).sqrt(), size, radius)
            slip = ((square - self.root) * p * ratio * self.side + self.drift) * self.sigma
            elapsed = self.whole - square
            guards = {SLIP: slip.without_zero(order), PLANE: -p}
            if self.turns_back:
                guards[TURNING] = square - self.root
            yield Piece(arb(0), (radius / 4).mid(), elapsed, guards, self._at(at))
            at, order = at + (radius / 4).mid(), 0
        raise Undecided("the end of a glide is not seen")

    def _at(self, center: Ball):  # type: ignore[no-untyped-def]
        return lambda at: self.state(center + at)

    def at_time(self, time: Ball) -> State:
        """Return the state at a time, from which p follows in closed form."""
        return self.state(-(self.whole - (time - self.start.time)).sqrt())

    def _disc(self, at: Ball) -> tuple[Ball, Ball]:
        for radius, near in discs(at, arb(0.5)):
            a = self.root - near * near / 2
            b = 2 - near * near * a
            # Away from 0, and from the cut of the square root.
            if a.real > 0 and b.real > 0:
                return radius, (abs(a).upper() / b.real.lower()).sqrt().upper()
        raise Undecided("the particle is too near the top")

    def state(self, p: Ball, at_end: bool = False) -> State:
        """Return the state; at the end, where p = 0, without a rate, which is infinite there."""
        start, square = self.start, p * p
        a = self.root - square / 2
        above, below = (2 - square * a).sqrt(), -p * a.sqrt()
        theta = 2 * arb.pi() * self.turns + self.side * 2 * arb.atan2(above, below)
        sin = self.side * above * below
        elapsed = self.whole - square
        slip = self.drift + self.side * (square - self.root) * p * a.sqrt() / above
        rate = arb.nan() if at_end else (self.root - square) / sin
        x = start.x + self.drift * elapsed + sin - self.sin
        return State(start.time + elapsed, theta, rate, slip, x, arb(0), arb(0))


def decide_massless(body: Body, state: State, arrival: str = "") -> Next:
    """Decide which motion of the massless hoop follows.

    Static friction or the normal force has just given way.
    """
    normal, friction = body.rolling_forces(state.theta, state.rate)
    evidence = {"rolling_normal": normal, "rolling_friction": friction}
    slips = sign(state.slip, "the slip velocity")
    if slips:
        return Next("gliding", slips, {})
    if arrival == "normal":
        del evidence["rolling_normal"], evidence["rolling_friction"]
        return Next("gliding", -sign(state.rate, "θ′"), evidence, 2)
    presses = sign(1 - state.rate * state.rate, "the normal force of rolling")
    if not arrival and presses > 0:
        margin = body.mu_s * (1 + state.theta.cos()) - abs(state.theta.sin())
        if sign(margin, "the margin of static friction") > 0:
            return Next("rolling", 0, evidence)
    side = sign(state.theta.sin(), "sin θ")
    if side == 0 or presses == 0:
        raise Beyond(
            "a glide begins with the particle above or below the centre, or without any "
            "acceleration of slip"
        )
    return Next("gliding", side * presses, evidence, 1)
