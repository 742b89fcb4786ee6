"""Motions with rolling resistance: the library against this package's program in doubles."""

from __future__ import annotations

import math
import random
from collections import Counter
from typing import NamedTuple

from .draws import with_resistance
from .library import simulated
from .walk import follow

SHAKEN = 1e-9  # relative change of all that is given, by which conditioning is measured
REPEATED = 2  # times
ULP = 2.0**-52
LIMIT = 1000  # units of conditioning by which numbers may differ: both are doubles
SETTLED = 1e5  # the same after bounces have settled, which the program cuts off at 1e-12
MODES = ("rolling", "sliding", "gliding", "skidding", "rest", "flight")
ENDLESS = ("rolls_forever", "slides_forever", "slips_forever", "rests", "bounces_forever")


class Finding(NamedTuple):
    """What was found for a start: a word, how many events were compared, and what differs."""

    word: str
    events: int
    what: str = ""


def shaken(given, dice):
    """Return the same with every number changed a little; what is equal or 0 stays so."""

    def one(v):
        return v * (1 + dice.choice((-1, 1)) * SHAKEN)

    mass_ratio, offset, inertia, mu_s, mu_k, chi, slope = given.hoop
    static = one(mu_s)
    hoop = (
        one(mass_ratio),
        offset if offset == 1 else one(offset),
        one(inertia),
        static,
        static if mu_k == mu_s else one(mu_k),
        one(chi),
        one(slope),
    )
    bounce = given.bounce
    if bounce is not None and bounce[0] != 1:
        bounce = (one(bounce[0]), bounce[1])
    return given._replace(hoop=hoop, start=tuple(map(one, given.start)), bounce=bounce)


def names(events):
    """Return what has to agree to the letter."""
    return [(one.cause, one.to, one.direction) for one in events]


def same(mine, theirs):
    """Whether two ways of ending agree; the program follows no motion for ever."""
    if mine == "time_limit":
        return theirs == "time_limit" or theirs in ENDLESS and theirs != "rests"
    return mine == theirs


def of_one(seed, number):
    """Compare one start."""
    given = with_resistance(seed, number)
    theirs, mine = simulated(given), follow(given)
    dice = random.Random(f"shaken {seed} {number}")
    others = [follow(shaken(given, dice)) for _ in range(REPEATED)]
    if len({mine.first, *(one.first for one in others)}) > 1:
        return Finding("undecided", 0)
    if mine.first[0] in MODES and mine.first != theirs.first:
        return Finding("first mode", 0, f"{mine.first}, library {theirs.first}")
    decided = 0
    mine_names, their_names = names(mine.events), [names_of(one) for one in theirs.transitions]
    while decided < len(mine.events) and all(
        names(one.events)[: decided + 1] == mine_names[: decided + 1] for one in others
    ):
        decided += 1
    j = settled = 0
    for k in range(decided):
        if j >= len(their_names):
            if len(mine.events) > len(their_names):
                return Finding("events", k, f"{mine_names[k]}, library {theirs.outcome}")
            break
        if their_names[j][0] == "settle" and mine_names[k] == ("landing", "flight", 0):
            continue
        if mine_names[k] != their_names[j]:
            return Finding("events", k, f"{k}: {mine_names[k]}, library {their_names[j]}")
        settled |= their_names[j][0] == "settle"
        worst = worst_of(mine.events[k], [one.events[k] for one in others], theirs.transitions[j])
        if worst[0] > (SETTLED if settled else LIMIT):
            return Finding("numbers", k, f"{k}: {mine_names[k]} {worst[1]} by {worst[0]:.3g} units")
        j += 1
    if decided < len(mine.events):
        return Finding("undecided later", decided)
    if mine.ended.startswith(("tie", "singular", "most")):
        return Finding(mine.ended, decided)
    if any(one.ended != mine.ended for one in others):
        return Finding("undecided end", decided)
    if not same(mine.ended, theirs.outcome) or j != len(their_names):
        return Finding("outcome", decided, f"{mine.ended}, library {theirs.outcome}")
    return Finding("same", decided)


def names_of(transition):
    """Return what has to agree to the letter of a transition of the library."""
    return transition[:3]


def worst_of(event, others, theirs):
    """Return the largest error of the numbers of an event in units of their conditioning."""
    worst = 0.0, ""
    for k, (name, value) in enumerate(zip(event.state._fields, event.state)):
        # What a settlement has before it is what is left of a bounce.
        rates = ("rate", "slip") if event.cause == "settle" else ()
        if k > 4 or math.isnan(value) or name in rates:
            continue
        moved = max(abs(one.state[k] - value) for one in others)
        unit = ULP * max(1.0, abs(value)) + moved / SHAKEN * ULP
        worst = max(worst, (abs(theirs[3][k] - value) / unit, name))
    return worst


def attack(seed, numbers):
    """Compare starts; return the counts of what was found, events compared, and differences."""
    counts, events, different = Counter(), 0, []
    for number in numbers:
        found = of_one(seed, number)
        counts[found.word.split(":")[0]] += 1
        events += found.events
        if found.what:
            different.append((number, found.word, found.what))
    return counts, events, different
