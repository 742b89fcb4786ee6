"""A motion with 60 digits, how well its doubles determine it, and the library's errors."""

import random

import gmpy2
from follower.arithmetic import COARSE, FINEST, ULP, Tie, Work
from follower.motion import NUMBERS, follow
from gmpy2 import mpfr

MOST = 12  # events of a motion
SHAKES = 3
STEPS = 100  # steps of a phase
# Outcomes that the library proves, after which it prints no events.
ENDLESS = ("rolls_forever", "slides_forever", "slips_forever", "bounces_forever", "repeats_forever")
# A slip that has ended, whatever follows.
RESTS = {"reversal": "stick", "graze": "stick"}
FOREVER = 2.0**100  # time limit
FEWEST = 2.0**40  # conditioning of a number that has hardly a digit


def exact(task, setting, noise=None, last=None):
    """(transitions, how it ended), as far as the motion can be followed."""
    numbers, start, bounce = task
    Work.use(setting, STEPS)
    try:
        return follow(numbers, start, FOREVER, noise, bounce, MOST, last)[1:3]
    except Tie as tie:
        return tie.transitions, str(tie)
    except (ArithmeticError, ValueError) as error:
        # Numbers next to the end of the doubles, with which lengths of steps are estimated.
        return [], f"{type(error).__name__}"


def course(transitions, count):
    """What has to agree to the letter, of the first `count` transitions.

    What follows the last of them is not yet compared.
    """
    last = transitions[count - 1]["cause"] if count <= len(transitions) else None
    return tuple((t["cause"], t["to"], t["direction"]) for t in transitions[: count - 1]) + (
        RESTS.get(last, last),
    )


def one(numbered):
    """A numbered motion: (task, motion, conditioning).

    The conditioning is that of the numbers of the transitions that doubles decide.
    """
    name, task = numbered
    dice = random.Random(f"accuracy {name}")
    rough, ended = exact(task, COARSE)
    shaken = [rough] if rough else []
    while shaken and len(shaken) <= SHAKES:
        shaken.append(
            exact(task, COARSE, lambda: 1 + dice.choice((-1, 1)) * mpfr(ULP), len(rough))[0]
        )
    decided = 0
    while (
        shaken
        and decided < min(map(len, shaken))
        and len({course(one, decided + 1) for one in shaken}) == 1
    ):
        decided += 1
    transitions = exact(task, FINEST, last=decided)[0] if decided else []
    units = []
    for k, transition in enumerate(transitions):
        row = {
            n: unit(transition, n, [one[k] for one in shaken[1:]])
            for n in NUMBERS
            if gmpy2.is_finite(transition[n]) and size(transition, n) != 0
        }
        if max(row.values()) > FEWEST:
            break
        units.append(row)
    return task, (transitions, ended), units


def size(transition, name):
    """What the error of a number is measured by.

    A place is that of a body of radius 1, whose rim slips and turns.
    """
    least = {"x": 1, "slip": abs(transition["theta_rate"])}.get(name, 0)
    return max(abs(transition[name]), mpfr(least))


def unit(transition, name, others):
    """Conditioning: how far the last digit of all numbers moves a number.

    It is in units of 2^-52 of that number, and at least one.
    """
    scale = mpfr(ULP) * size(transition, name)
    return max(1.0, *(float(abs(other[name] - transition[name]) / scale) for other in others))


def compared(result, answer):
    """(whether the events are the same, rows of (transition, number, error, conditioning))."""
    _, (transitions, _), units = result
    theirs = answer[0]
    count = min(
        len(units), next((k for k, t in enumerate(theirs) if t["cause"] == "settle"), len(units))
    )
    if answer[1] in ENDLESS:
        count = min(count, len(theirs))
    if count and course(theirs, count) != course(transitions, count):
        return False, []
    return True, [
        (
            k,
            name,
            float(
                abs(mpfr(theirs[k][name]) - transitions[k][name])
                / (mpfr(ULP) * size(transitions[k], name))
            ),
            conditioning,
        )
        for k in range(count)
        for name, conditioning in units[k].items()
    ]
