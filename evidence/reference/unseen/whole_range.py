"""States of all sizes without resistance: the library against 60 digits, up to the second event."""

from __future__ import annotations

import random
from collections import Counter

import gmpy2
from accuracy.measure import FEWEST, FOREVER, course, size, unit
from follower.arithmetic import COARSE, FINEST, ULP, Tie, Work
from follower.motion import NUMBERS, follow
from gmpy2 import mpfr

from .draws import of_the_whole_range
from .library import simulated

EVENTS = 2  # that are compared
SHAKES = 3
STEPS = 60  # steps of a phase
LIMIT = 1000  # units of conditioning beyond which a number has lost digits
WRONG = 1e-6  # of a number, beyond which it is wrong
# Library's outcomes after which it prints no events.
ENDLESS = ("rolls_forever", "slides_forever", "slips_forever", "bounces_forever", "repeats_forever")


def exact(given, setting, noise=None, last=None):
    """Return the transitions as far as they can be followed, and the word where they end."""
    hoop = (*given.hoop[:5], given.hoop[6])
    Work.use(setting, STEPS)
    try:
        return follow(hoop, given.start, FOREVER, noise, given.bounce, EVENTS, last)[1:3]
    except Tie as tie:
        return tie.transitions, str(tie)
    except (ArithmeticError, ValueError) as error:
        return [], type(error).__name__


def of_one(seed, number):
    """Compare one start: a word, how many events were compared, and what differs."""
    given = of_the_whole_range(seed, number)
    answer = simulated(given)
    dice = random.Random(f"shaken range {seed} {number}")

    def noise():
        return 1 + dice.choice((-1, 1)) * mpfr(ULP)

    rough, ended = exact(given, COARSE)
    if not rough and ended == "rolls_forever":
        said = [one[:2] for one in answer.transitions[:EVENTS]]
        return ("events", 0, f"none, library {said}") if said else ("rolls for ever", 0, "")
    if not rough:
        return f"not followed: {ended}", 0, ""
    shaken = [rough, *(exact(given, COARSE, noise, len(rough))[0] for _ in range(SHAKES))]
    decided = 0
    while (
        decided < min(map(len, shaken)) and len({course(one, decided + 1) for one in shaken}) == 1
    ):
        decided += 1
    if not decided:
        return "undecided", 0, ""
    transitions = exact(given, FINEST, last=decided)[0]
    return compared(answer, transitions[:decided], [one[:decided] for one in shaken[1:]])


def compared(answer, transitions, others):
    """Compare what doubles decide of the first events with those of the library."""
    theirs = [
        dict(zip(NUMBERS, numbers), cause=cause, to=to or "none", direction=direction)
        for cause, to, direction, numbers in answer.transitions
    ]
    count = len(transitions)
    if answer.outcome in ENDLESS or answer.outcome == "unresolved":
        count = min(count, len(theirs))
    settles = next((k for k, one in enumerate(theirs) if one["cause"] == "settle"), count)
    count = min(count, settles)
    if count == 0:
        return f"no event by the library: {answer.outcome}", 0, ""
    if course(theirs, count) != course(transitions, count):
        found = [(one["cause"], one["to"]) for one in transitions[:count]]
        said = [(one["cause"], one["to"]) for one in theirs[:count]]
        return "events", 0, f"{found}, library {said} {answer.outcome}"
    lost = ""
    for k in range(count):
        for name in NUMBERS:
            true = transitions[k][name]
            if not gmpy2.is_finite(true) or size(transitions[k], name) == 0:
                continue
            conditioning = unit(transitions[k], name, [one[k] for one in others])
            if conditioning > FEWEST:
                return "same", k, ""
            off = abs(mpfr(theirs[k][name]) - true) / (mpfr(ULP) * size(transitions[k], name))
            what = f"{k}: {transitions[k]['cause']} {name} by {float(off):.3g} units, "
            what += f"conditioning {conditioning:.3g}"
            if off > LIMIT * conditioning and off * ULP > WRONG:
                return "numbers", k, what
            if off > LIMIT * conditioning:
                lost = what
    if lost:
        return "digits lost", count, lost
    return "same", count, ""


def attack(seed, numbers):
    """Compare starts; return the counts of what was found, events compared, and differences."""
    Work.use(FINEST)
    counts, events, different = Counter(), 0, []
    for number in numbers:
        word, compared_events, what = of_one(seed, number)
        counts[word] += 1
        events += compared_events
        if word == "digits lost":
            print(f"start {number} loses digits, {what}")
        elif what:
            different.append((number, word, what))
    return counts, events, different
