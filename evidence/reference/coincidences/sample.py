"""A start with its motion, and with repetitions of it."""

import math
import random

from follower.arithmetic import COARSE, FINE, ULP, Tie, Work
from follower.motion import follow
from gmpy2 import mpfr

from .families import FAMILIES

SHAKES = 2
MORE_SHAKES = (
    12  # of starts with an error above SUSPECT units, which few repetitions may have made small
)
SUSPECT = 32.0


def one(task):
    """A start of a family, its motion, and repetitions of it."""
    family, index = task
    make_hoop, make = FAMILIES[family]
    dice = random.Random(f"{family} {index}")
    for _ in range(400):
        Work.use(FINE)
        made = make(dice, make_hoop(dice))
        if not made or not all(map(math.isfinite, made[0] + made[1])):
            continue
        numbers, start, until = made
        try:
            motion = follow(numbers, start, until)
        except Tie:
            continue
        return (
            family,
            index,
            numbers,
            start,
            until,
            motion,
            shaken(dice, numbers, start, until, SHAKES),
        )
    raise AssertionError(f"no start of {family}")


def shaken(dice, numbers, start, until, count):
    """Repetitions in which every number is changed by 2^-52 of itself, up or down."""
    Work.use(COARSE)
    motions = []
    for _ in range(count):
        try:
            motions.append(
                follow(numbers, start, until, lambda: 1 + dice.choice((-1, 1)) * mpfr(ULP))
            )
        except Tie:
            motions.append(None)
    return motions


def closer(result):
    """The same start with more repetitions."""
    family, index, numbers, start, until, motion, few = result
    dice = random.Random(f"{family} {index} closer")
    return *result[:6], few + shaken(dice, numbers, start, until, MORE_SHAKES)
