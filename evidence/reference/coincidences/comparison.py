"""A motion beside the library's answer."""

import math

import gmpy2
from follower.arithmetic import ULP
from follower.motion import MOST, NUMBERS
from gmpy2 import mpfr


def rounded(v):
    return float(f"{v:.3g}")


def kind_of(motion):
    """What has to agree to the letter."""
    first, transitions, ended, _ = motion
    return first, tuple((t["cause"], t["to"], t["direction"]) for t in transitions), ended


def units(motion, shaken):
    """Of every number of every transition and of the end."""

    def rows(of):
        return of[1] + ([of[3]] if of[3] else [])

    out = []
    for k, row in enumerate(rows(motion)):
        unit = {}
        for name in NUMBERS:
            exact = row[name]
            spread = (
                [abs(rows(other)[k][name] - exact) for other in shaken]
                if gmpy2.is_finite(exact)
                else []
            )
            # A place is that of a body of radius 1.
            size = max(abs(exact), mpfr(1)) if name == "x" else abs(exact)
            unit[name] = float(max([mpfr(ULP) * size] + spread)) if spread else 0.0
        out.append(unit)
    return out


def same_kind(answer, motion):
    """Whether the library tells of the same events."""
    first, transitions, ended, end = motion
    theirs = answer[1]
    if ended == "more":
        theirs = theirs[:MOST]
    if kind_of((first, transitions, None, None)) != kind_of((answer[0], theirs, None, None)):
        return False
    mode = transitions[-1]["to"] if transitions else first[0]
    if ended in ("rolling", "sliding", "gliding", "flight"):
        return answer[2] == "time_limit" or (answer[2] == "rolls_forever" and mode == "rolling")
    return ended == "more" or answer[2] == ended


def errors(answer, motion, unit):
    """(error in units, number, place) of every number."""
    _, transitions, ended, end = motion
    pairs = list(zip(answer[1], transitions, unit))
    if end and answer[2] == "time_limit":
        pairs.append((answer[3], end, unit[-1]))
    for place, (ours, exact, scale) in enumerate(pairs):
        for name in NUMBERS:
            mine, right = ours[name], exact[name]
            if not gmpy2.is_finite(right):
                yield (0.0 if mine == right else math.inf), name, place
            elif scale[name]:
                yield abs(float(mpfr(mine) - right)) / scale[name], name, place
            else:
                yield (0.0 if mine == right else math.inf), name, place


class Compared:
    """A start, its motion, and how the library's answer compares."""

    def __init__(self, result, answer):
        self.family, self.index, self.numbers, self.start, self.until, self.motion, shakes = result
        self.answer = answer
        self.same = same_kind(answer, self.motion)
        alike = [v for v in shakes if v and kind_of(v) == kind_of(self.motion)]
        self.decided = len(alike) == len(shakes)
        self.possible = self.same or any(v and same_kind(answer, v) for v in shakes)
        self.units = units(self.motion, alike) if self.decided else None
        self.errors = (
            list(errors(answer, self.motion, self.units)) if self.same and self.decided else []
        )
        self.worst = max(self.errors, default=(0.0, "", 0))

    def described(self):
        return dict(
            family=self.family,
            index=self.index,
            hoop=self.numbers,
            start=self.start,
            until=self.until,
        )

    def kept(self):
        """The start, and what the library has to say of it, with the unit of each number."""
        first, transitions, ended, _ = self.motion
        return dict(
            self.described(),
            first=first,
            outcome=ended,
            transitions=[
                dict(
                    cause=t["cause"],
                    to=t["to"],
                    direction=t["direction"],
                    **{
                        n: [
                            f"{t[n]:.20e}" if gmpy2.is_finite(t[n]) else str(float(t[n])),
                            rounded(u[n]),
                        ]
                        for n in NUMBERS
                    },
                )
                for t, u in zip(transitions, self.units)
            ],
        )
