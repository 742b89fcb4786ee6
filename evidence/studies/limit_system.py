"""The limit of light hoops: rolling, gliding, the loss of slip, and the bounce of the particle.

Slip is lost in a set of states.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

from .roots import zero

STEPS = 2000
"""Parts of a stretch of time in which the first event is looked for."""


@dataclass(frozen=True)
class State:
    """A state on the plane: θ in (−π, π), θ′ and η′."""

    theta: float
    rate: float
    slip: float


@dataclass(frozen=True)
class Piece:
    """A phase of the limit system.

    Parameters
    ----------
    kind : str
        "roll" or "glide".
    begin, end : float
        Times.
    at : callable
        The state after a time since the beginning.
    ended_by : str
        The event at its end; "time" where the motion was not followed further.
    """

    kind: str
    begin: float
    end: float
    at: Callable[[float], State]
    ended_by: str


def rolling(start: State) -> Callable[[float], State]:
    """Return the motion of rolling: z = sin(θ/2) has z″ = z/4."""
    z0, z1 = math.sin(0.5 * start.theta), 0.5 * math.cos(0.5 * start.theta) * start.rate

    def at(time: float) -> State:
        z = z0 * math.cosh(0.5 * time) + 2.0 * z1 * math.sinh(0.5 * time)
        rise = 0.5 * z0 * math.sinh(0.5 * time) + z1 * math.cosh(0.5 * time)
        z = min(max(z, -1.0), 1.0)
        half = math.sqrt((1.0 - z) * (1.0 + z))
        return State(2.0 * math.asin(z), 2.0 * rise / half if half else math.inf, 0.0)

    return at


def gliding(side: float, height: float, rise: float, drift: float) -> Callable[[float], State]:
    """Return the free fall of the particle with the velocity V = `drift`.

    It is at cos θ = `height` − 1 on a side, sign s.
    """

    def at(time: float) -> State:
        b = min(max(height + rise * time - 0.5 * time * time, 0.0), 2.0)
        s = side * math.sqrt(b * (2.0 - b))
        rate = -(rise - time) / s if s else math.inf
        return State(side * math.acos(b - 1.0), rate, drift + b * rate)

    return at


def first_event(events: dict[str, Callable[[float], float]], length: float) -> tuple[str, float]:
    """Return the first event, a function that becomes negative, and its time.

    It is "time" if there is none.
    """
    before = 0.0
    for k in range(1, STEPS + 1):
        # Events next to the start of a glide without slip are in its first steps.
        time = length * (k / STEPS) ** 2
        passed = [
            (zero(f, before, time), name)
            for name, f in events.items()
            if f(time) < 0.0 <= f(before)
        ]
        if passed:
            when, name = min(passed)
            return name, when
        before = time
    return "time", length


@dataclass(frozen=True)
class LimitSystem:
    """Light hoops with the particle on the rim, as their inertia vanishes.

    The rim does not rebound.
    """

    mu_s: float
    mu_k: float

    def rolls(self, state: State) -> bool:
        """Whether a hoop without slip rolls."""
        return abs(math.tan(0.5 * state.theta)) < self.mu_s and abs(state.rate) < 1.0

    def loses_slip(self, state: State) -> bool:
        """Whether a state is in the set where no light hoop slides."""
        return state.slip * state.theta > 0.0 and abs(math.tan(0.5 * state.theta)) < self.mu_k

    def follow(self, state: State, until: float) -> list[Piece]:
        """Return the motion up to a time, the particle at the top, or a flight."""
        pieces: list[Piece] = []
        while not pieces or (
            pieces[-1].end < until and pieces[-1].ended_by not in ("top", "lift-off")
        ):
            clock = pieces[-1].end if pieces else 0.0
            if self.loses_slip(state):
                state = State(state.theta, state.rate - 0.5 * state.slip, 0.0)
            if math.cos(state.theta) * state.rate**2 > 1.0:
                break
            before = pieces[-1].ended_by if pieces else ""
            # On a border the event says on which side the motion goes on.
            sticks = (
                abs(state.rate) < 1.0
                if before == "set"
                else self.rolls(state) and before not in ("slip", "unloaded")
            )
            if state.slip == 0.0 and sticks:
                at = rolling(state)
                events: dict[str, Callable[[float], float]] = {
                    "slip": lambda t, at=at: self.mu_s - abs(math.tan(0.5 * at(t).theta)),  # type: ignore[misc]
                    "unloaded": lambda t, at=at: 1.0 - abs(at(t).rate),  # type: ignore[misc]
                }
                name, length = first_event(events, until - clock)
                pieces.append(Piece("roll", clock, clock + length, at, name))
            else:
                side = math.copysign(1.0, state.theta)
                direction = math.copysign(1.0, state.slip)
                if state.slip == 0.0:
                    direction = -side if abs(state.rate) > 1.0 or before == "unloaded" else side
                b = 1.0 + math.cos(state.theta)
                fall = side, b, -math.sin(state.theta) * state.rate, state.slip - b * state.rate
                pieces.append(self._glide(clock, fall, direction, until))
                while pieces[-1].ended_by == "bounce":
                    fall = self._bounced(fall, pieces[-1].end - pieces[-1].begin)
                    # η′ = V at the bottom; where the bounce has stopped the slip, it has the sign
                    # of θ′ afterwards.
                    direction = math.copysign(1.0, fall[3]) if fall[3] else -fall[0]
                    pieces.append(self._glide(pieces[-1].end, fall, direction, until))
            state = pieces[-1].at(pieces[-1].end - pieces[-1].begin)
            if pieces[-1].ended_by == "set":
                state = State(state.theta, state.rate - 0.5 * state.slip, 0.0)
            elif pieces[-1].ended_by == "stick":
                state = State(state.theta, state.rate, 0.0)
        return pieces

    def _glide(
        self, clock: float, fall: tuple[float, float, float, float], direction: float, until: float
    ) -> Piece:
        """Return a glide of `gliding` with a direction of slip."""
        side, b, rise, _ = fall
        at = gliding(*fall)
        events: dict[str, Callable[[float], float]] = {
            "bounce": lambda t: b + rise * t - 0.5 * t * t,
            "top": lambda t: 2.0 - (b + rise * t - 0.5 * t * t),
            "stick": lambda t: direction * at(t).slip,
            "lift-off": lambda t: 1.0 - math.cos(at(t).theta) * at(t).rate ** 2,
        }
        if direction == side:
            events["set"] = lambda t: abs(math.tan(0.5 * at(t).theta)) - self.mu_k
        name, length = first_event(events, until - clock)
        return Piece("glide", clock, clock + length, at, name)

    def _bounced(
        self, fall: tuple[float, float, float, float], length: float
    ) -> tuple[float, float, float, float]:
        """Return the glide after the bounce at the end of another."""
        side, _, rise, drift = fall
        speed = length - rise
        return (
            -side,
            0.0,
            speed,
            drift - math.copysign(min(2.0 * self.mu_k * speed, abs(drift)), drift),
        )
