"""Five questions about events whose answers are known exactly, for integrators that find them.

Every margin is positive while the motion goes on and ends it where it falls through zero.
"""

import json
import math
from dataclasses import dataclass

TOUCHES = 100
CLEARANCES = {"cleared": 1e-9, "touched": 0.0, "1e-9": -1e-9, "1e-6": -1e-6, "1e-3": -1e-3}
"""By which a swing clears the margin, as a part of its height; negative, it dips below."""
PAIRS = 20
THROWS = (1.0, 1e-3, 1e-6, 1e-9)
"""Speeds of a ball thrown up from a margin that is exactly 0; it lands after twice as long."""
RESTITUTION = 0.5
AFTER = 3.5
"""A ball dropped from 1/2 with half the speed after each bounce has made them all at 3."""
BOUNCES = 60
"""More than a double can tell apart: the last would take 1e-17."""


@dataclass(frozen=True)
class System:
    """Rates and margins as functions of the state and of one parameter."""

    name: str
    order: int
    rates: object
    margins: object


SWING = System("swing", 2, lambda y: (y[1], -y[0]), lambda y, top: (top - y[0],))
BALL = System("ball", 2, lambda y: (y[1], -1.0), lambda y, _: (y[0],))
BALLS = System("balls", 4, lambda y: (y[1], -1.0, y[3], -1.0), lambda y, _: (y[0], y[2]))


@dataclass(frozen=True)
class Stop:
    """Where an integrator stops, and the numbers of the margins that it names."""

    time: float
    state: tuple
    named: tuple


def touching(peer):
    """Of 100 swings with the same top at different times, those in which an event is reported."""
    counts = {}
    for name, clearance in CLEARANCES.items():
        reported, refused = 0, 0
        for i in range(TOUCHES):
            early = 2.0 * i / TOUCHES
            start = (-math.sin(early), math.cos(early))
            try:
                reported += peer.first(SWING, 1.0 + clearance, start, early + 3.0) is not None
            except RuntimeError:
                refused += 1
        counts[name] = f"{reported} ({refused} errors)" if refused else f"{reported}"
    return counts


def together(peer):
    """Two balls land at 1, from another height in each of some pairs: how many are reported."""
    counts = {"both": 0, "one by one": 0, "one lost": 0}
    for i in range(PAIRS):
        height = 0.5 + (i + 1) / PAIRS
        first = peer.first(BALLS, 0.0, (0.5, 0.0, height, 0.5 - height), 2.0)
        counts[fate(peer, first)] += 1
    return counts


def fate(peer, first):
    """What becomes of two balls of which the first report is known."""
    if len(first.named) == 2:
        return "both"
    # The ball that is named bounces; the other one still has to land.
    state, one = list(first.state), first.named[0]
    state[2 * one], state[2 * one + 1] = 0.0, -RESTITUTION * state[2 * one + 1]
    second = peer.first(BALLS, 0.0, tuple(state), 0.1)
    lands = second is not None and 1 - one in second.named
    return "one by one" if lands else "one lost"


def at_start(peer):
    """What is reported of a ball thrown up from 0, and of one thrown down."""
    answers = {}
    for speed in THROWS:
        stop = peer.first(BALL, 0.0, (0.0, speed), 3.0 * speed)
        late = None if stop is None else stop.time / (2.0 * speed) - 1.0
        if late is None:
            answers[f"{speed:g}"] = "missed"
        elif abs(late) < 1e-2:
            answers[f"{speed:g}"] = "lands"
        else:
            answers[f"{speed:g}"] = f"{late:+.0%}"
    stop = peer.first(BALL, 0.0, (0.0, -1.0), 1.0)
    answers["down"] = "missed" if stop is None else "seen"
    return answers


def accumulating(peer):
    """Bounces until none is found any more, and how this ends."""
    if hasattr(peer, "bounce"):
        return peer.bounce()
    time, state, count = 0.0, (0.5, 0.0), 0
    while count < BOUNCES:
        stop = peer.first(BALL, 0.0, state, AFTER - time)
        if stop is None:
            return {"bounces": count, "last": time, "end": "falls through"}
        time += stop.time
        state, count = (0.0, -RESTITUTION * stop.state[1]), count + 1
        if state[1] <= 0.0:
            return {"bounces": count, "last": time, "end": "stops"}
    return {"bounces": count, "last": time, "end": "goes on"}


def derivative(peer):
    """Of the time at which a ball dropped from 1/2 lands, by the height: it is 1."""
    return f"{peer.derivative():.6f}" if hasattr(peer, "derivative") else "–"


def answer(peer):
    """Print what a peer makes of each question, as JSON."""
    result = {"tool": peer.tool, "setting": peer.setting}
    for question in (touching, together, at_start, accumulating, derivative):
        try:
            result[question.__name__] = question(peer)
        except Exception as error:  # of whatever kind: what it says is the answer
            words = " ".join(str(error).split())
            result[question.__name__] = f"{type(error).__name__}: {words[-200:]}"
    print(json.dumps(result), flush=True)
