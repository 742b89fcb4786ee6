"""A motion in doubles, from event to event."""

from __future__ import annotations

import math
from typing import NamedTuple

from .balances import (
    FLIGHT,
    ORDER,
    Hoop,
    Mode,
    Series,
    Singular,
    State,
    Tie,
    contact,
    first_fall,
)
from .choice import arrived, fits, possible
from .impact import impact

STEPS = 4000  # steps of a phase
SETTLED = 1e-12  # rate of the gap below which bounces have settled
SHORTEST = 1e-6  # step below which a phase runs into a singularity


class Event(NamedTuple):
    """An event: its cause, the state before it, the mode that follows, the last one before."""

    cause: str
    state: State
    to: str | None
    direction: int


class Walk:
    """A motion on its way."""

    def __init__(self, hoop, start, bounce, until, most):
        self.hoop, self.bounce, self.until, self.most = hoop, bounce, until, most
        theta, rate, slip, gap_rate = start
        self.state = State(0.0, theta, rate, slip, 0.0, gap_rate)
        self.events, self.ended, self.first = [], "", None
        self.mode, self.order = None, 0

    def follow(self):
        """Follow the motion; `ended` says how far it was followed."""
        try:
            self.begin()
            while not self.ended:
                if len(self.events) >= self.most:
                    self.ended = "most"
                elif self.mode is None:
                    self.jam()
                elif self.mode.name == "rest":
                    self.ended = "rests"
                elif self.mode is FLIGHT:
                    self.fly()
                elif self.mode.name == "gliding":
                    self.glide()
                else:
                    self.touch()
        except Tie as tie:
            self.ended = f"tie: {tie}"
        except Singular as singular:
            self.ended = f"singular: {singular}"
        return self

    def begin(self):
        """Decide the first mode: nothing is held before."""
        if self.state.opening:
            self.mode, self.order = FLIGHT, 1
        else:
            self.choose(possible(self.hoop, self.state))
        self.first = (self.mode.name, self.mode.slips) if self.mode else (self.ended or "none", 0)

    def choose(self, modes):
        """Take the one mode that is possible."""
        self.order = 0
        if len(modes) == 1:
            self.mode = modes[0]
            if self.mode is FLIGHT:
                self.order = 2
        elif modes:
            self.mode, self.ended = None, "ambiguous"
        else:
            self.mode = None
            self.ended = "" if self.bounce else "inconsistent"

    def event(self, cause, modes, before):
        """Record an event, and take what follows it."""
        state, last = self.state, self.mode
        self.choose(modes)
        if cause == "stick" and self.mode is not None and self.mode.slips:
            cause = "graze" if self.mode.slips == last.slips else "reversal"
        if cause == "stick" and self.mode is FLIGHT:
            cause = "lift_off"
        to = self.mode.name if self.mode else None
        self.events.append(Event(cause, before or state, to, self.mode.slips if self.mode else 0))

    def jam(self):
        """Follow an impact without a collision."""
        self.land("jam", self.state._replace(opening=0.0))

    def land(self, cause, before):
        """Follow an impact, without a law the end."""
        if self.bounce is None:
            self.events.append(Event(cause, before, None, 0))
            self.ended = cause
            return
        rate, slip, v, last = impact(self.hoop, before, *self.bounce)
        self.state = before._replace(rate=rate, slip=slip, opening=v)
        if 0 < v < SETTLED:
            self.state, cause = self.state._replace(opening=0.0), "settle"
            last = Mode("", slip != 0, rate != 0)
        if self.state.opening:
            self.mode, self.order = FLIGHT, 1
            self.events.append(Event(cause, before, "flight", 0))
            return
        self.event(cause, arrived(possible(self.hoop, self.state), last), before)

    def fly(self):
        """Fly to the landing, by Taylor series of the gap."""
        hoop, start = self.hoop, self.state
        h, w = hoop.h, start.rate
        s0, c0 = math.sin(start.theta), math.cos(start.theta)
        up, along = start.opening - h * s0 * w, start.slip - w - h * c0 * w
        tau, order = 0.0, self.order
        length = min(1.0, 1.0 / (abs(w) + 0.1))

        def moved(tau):
            theta = start.theta + w * tau
            s, c = math.sin(theta), math.cos(theta)
            x = along * tau - hoop.along * tau**2 / 2 + h * (s - s0)
            slip = along - hoop.along * tau + w + h * c * w
            opening = up - hoop.down * tau + h * s * w
            return State(start.time + tau, theta, w, slip, start.x + x, opening)

        for _ in range(STEPS):
            here = moved(tau)
            s, c = math.sin(here.theta), math.cos(here.theta)
            gap = up * tau - hoop.down * tau**2 / 2 - h * (c - c0) if tau else 0.0
            series, factor = [gap, here.opening], 1.0
            for k in range(2, ORDER):
                factor = w**k / math.factorial(k)
                series.append(-h * factor * (c, -s, -c, s)[k % 4] - (k == 2) * hoop.down / 2)
            left = self.until - here.time
            if order:
                series = [0.0] * order + series[order:]
            found = first_fall(series, min(length, left), order)
            if found is not None:
                self.land("landing", moved(tau + found))
                return
            if left <= length:
                self.state, self.ended = moved(tau + left), "time_limit"
                return
            tau, order = tau + length, 0
        raise Tie("a long flight")

    def guards(self, series, first):
        """Return (polynomial, order of its zero, cause, direction) of each guard."""
        hoop, mode = self.hoop, self.mode
        found = []
        if mode.slips:
            slip = [mode.slips * v for v in series.slip]
            order = self.order if first else 0
            found.append((slip, order, "stick", 0))
            if mode.name == "sliding":
                found.append((series.normal, 0, "lift_off", 0))
        elif mode.turns and hoop.massless:
            found.append((series.normal, 0, "normal_force_zero", 0))
            # F/N by the moment alone, which needs no force.
            for way in (1, -1):
                grip = [
                    hoop.mu_s * hoop.h * c - way * hoop.h * s
                    for s, c in zip(series.sin, series.cos)
                ]
                grip[0] += hoop.mu_s + way * hoop.chi * mode.turns
                found.append((grip, 0, "slip", way))
        elif mode.turns:
            for way in (1, -1):
                grip = [hoop.mu_s * n + way * f for n, f in zip(series.normal, series.friction)]
                found.append((grip, 0, "slip", way))
        if mode.turns and hoop.chi:
            rate = [mode.turns * v for v in series.rate]
            found.append((rate, 1 if first and not self.state.rate else 0, "turning_point", 0))
        return found

    def touch(self):
        """Follow a phase on the plane to its event."""
        hoop, mode = self.hoop, self.mode
        if mode.slips and not self.state.slip and not self.order:
            self.order = 1
        first = True
        for _ in range(STEPS):
            series = Series(hoop, mode, self.state)
            length, left = series.reach(), self.until - self.state.time
            if length < SHORTEST:
                raise Singular(mode.name)
            ahead = []
            for p, order, cause, way in self.guards(series, first):
                at = first_fall(p, min(length, left), order)
                if at is not None:
                    ahead.append((at, cause, way))
            ahead.sort()
            if len(ahead) > 1 and ahead[1][0] - ahead[0][0] < 1e-10:
                raise Tie("two events at once")
            if ahead:
                self.state = series.at(ahead[0][0])
                self.ends(*ahead[0][1:])
                return
            if left <= length:
                self.state, self.ended = series.at(left), "time_limit"
                return
            self.state, first = series.at(length), False
        raise Tie("a long phase")

    def glide(self):
        """Follow a glide: the particle of a massless hoop falls freely, and the hoop turns so.

        What vanishes is looked for on a grid that is dense at the end, where θ′ is infinite.
        """
        hoop, start, side = self.hoop, self.state, math.copysign(1, math.sin(self.state.theta))
        turns = 2 * math.pi * round(start.theta / (2 * math.pi))
        height, rise = math.cos(start.theta), -math.sin(start.theta) * start.rate
        pull = hoop.down / hoop.h
        along = start.slip - (1 + hoop.h * height) * start.rate
        place = start.x - hoop.h * math.sin(start.theta)
        to_top = rise > 0 and height + rise * rise / (2 * pull) > 1
        whole = (rise + math.sqrt(rise * rise + 2 * pull * (1 + height))) / pull
        if to_top:
            left_over = math.sqrt(rise**2 - 2 * pull * (1 - height))
            whole, cause = 2 * (1 - height) / (rise + left_over), "particle_at_top"
        elif rise > 0 and hoop.chi:
            whole, cause = rise / pull, "turning_point"
        else:
            cause = "particle_at_plane" if hoop.h == 1 else "particle_at_bottom"

        def moved(left):
            """Return the state so long before the end, by what falls from or to there."""
            tau = whole - left
            speed = rise - pull * tau
            if cause.startswith("particle_at_") and not to_top:
                above = left * (pull * whole - rise - pull * left / 2)  # 1 + cos θ
                theta = 2 * math.atan2(math.sqrt(max(0, 2 - above)), math.sqrt(max(0, above)))
            else:
                theta = math.acos(min(1, height + rise * tau - pull * tau * tau / 2))
            theta = turns + side * theta
            rate = -speed / math.sin(theta)
            slip = along - hoop.along * tau + (1 + hoop.h * math.cos(theta)) * rate
            x = place + along * tau - hoop.along * tau**2 / 2 + hoop.h * math.sin(theta)
            return State(start.time + tau, theta, rate, slip, x)

        grid = [whole * (1 - k / 600) ** 2 for k in range(1, 600)]
        sigma, before = self.mode.slips, None
        for left in grid:
            now = sigma * moved(left).slip > 0
            if before is not None and not now:
                cause, whole_left = "stick", bisected(lambda v: sigma * moved(v).slip, before, left)
                break
            if before is None and not now:
                raise Tie("a glide that slips back at once")
            before = left
        else:
            whole_left = 0.0
        if start.time + whole - whole_left > self.until:
            self.state, self.ended = moved(start.time + whole - self.until), "time_limit"
        elif cause == "stick" or cause == "turning_point":
            self.state = moved(whole_left)
            self.ends(cause, 0)
        else:
            state = State(start.time + whole, *(math.nan,) * 4)
            self.events.append(Event(cause, state, None, 0))
            self.ended = cause

    def ends(self, cause, way):
        """Take what follows a phase on the plane."""
        hoop, mode = self.hoop, self.mode
        if cause == "stick":
            self.state = self.state._replace(slip=0.0)
            self.event(cause, arrived(possible(hoop, self.state), mode), None)
        elif cause == "turning_point":
            self.state = self.state._replace(rate=0.0)
            self.event(cause, arrived(possible(hoop, self.state), mode), None)
        elif cause == "lift_off":
            self.event(cause, [FLIGHT], None)
            self.order = 3
        elif cause == "normal_force_zero":
            ways = [contact(s, mode.turns, True) for s in (1, -1)]
            series = [Series(hoop, one, self.state).slip for one in ways]
            drive = series[0][2] or series[0][3]
            self.event(cause, [ways[0 if drive > 0 else 1]], None)
            self.order = 2
        else:
            slide = contact(way, mode.turns, hoop.massless)
            tie = hoop.mu_s == hoop.mu_k and not hoop.massless
            follows = [slide] if tie or fits(hoop, slide, self.state) else []
            if not follows:
                follows = [m for m in possible(hoop, self.state) if m.slips or m is FLIGHT]
            self.event(cause, follows, None)
            self.order = 2 if tie else 1


def bisected(function, low, high):
    """Return where a function that is positive at `low` vanishes."""
    for _ in range(200):
        middle = (low + high) / 2
        if middle in (low, high):
            break
        low, high = (middle, high) if function(middle) > 0 else (low, middle)
    return (low + high) / 2


def follow(given, most=60):
    """Follow what is given: numbers of the hoop, start, law of restitution or None, time limit."""
    return Walk(Hoop(*given.hoop), given.start, given.bounce, given.until, most).follow()
