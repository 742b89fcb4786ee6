"""What the comparisons say: for all motions, for parts of the range, and against each quantity."""

import math

from .measure import NUMBERS, compared

KEPT = 40  # motions that the file keeps with their numbers
WORST = 12  # numbers and sequences that the file lists


def inertia(hoop):
    """That about the mass centre."""
    mass_ratio, offset, about_centre = hoop[:3]
    return about_centre + mass_ratio * offset**2 / (1 + mass_ratio)


# What a number is drawn against: its place among the events, or a number of its motion; and the
# edges of the bins.
AGAINST = {
    "theta_rate": (lambda task, k: abs(task[1][1]), [10.0**k for k in range(-6, 7, 2)]),
    "theta": (lambda task, k: abs(task[1][0]), [10.0**k for k in range(-9, 10, 2)]),
    "inertia": (lambda task, k: inertia(task[0]), [10.0**k for k in range(-9, 10, 2)]),
    "mu_s": (lambda task, k: task[0][3], [10.0**k for k in range(-9, 10, 2)]),
    "events": (lambda task, k: k + 1, [k + 0.5 for k in range(13)]),
}


# Parts of the range, as the page has them.
def ordinary(hoop, start):
    return max(map(abs, start[:4])) <= 10 and 1e-3 <= inertia(hoop) <= 1e3 and 1e-3 <= hoop[3] <= 10


def vanishing(hoop, start):
    """Whether a number of the hoop or the start is next to the smallest doubles.

    There digits end.
    """
    return any(0 < abs(value) < 1e-100 for value in (*hoop, *start))


PARTS = {
    "all": lambda hoop, start: True,
    "ordinary": ordinary,
    "fast": lambda hoop, start: abs(start[1]) > 10,
    "far": lambda hoop, start: abs(start[0]) > 10,
    "light": lambda hoop, start: inertia(hoop) < 1e-3,
    "slippery": lambda hoop, start: hoop[3] < 1e-3,
    "rough": lambda hoop, start: hoop[3] > 10,
    "bouncing": lambda hoop, start: True,
}


def rounded(v):
    """Three digits; JSON has no infinite numbers."""
    return float(f"{v:.3g}") if math.isfinite(v) else "inf"


def share(values, part):
    """The value below which a part of all lies."""
    return rounded(sorted(values)[min(len(values) - 1, int(part * len(values)))])


def spread(values):
    """Median, 99 %, largest."""
    return [share(values, 0.5), share(values, 0.99), rounded(max(values))]


def row(numbers):
    """Of pairs (error, conditioning): how many, spreads, and the share of ratios above 8.

    The spreads are those of the errors and of the ratios.
    """
    return dict(
        numbers=len(numbers),
        error=spread([e for e, _ in numbers]),
        conditioning=spread([c for _, c in numbers]),
        lost=spread([e / c for e, c in numbers]),
        above_8=rounded(sum(e > 8 * c for e, c in numbers) / len(numbers)),
    )


def table(results, answers):
    """The content of the file."""
    found = [
        (result, answer, *compared(result, answer)) for result, answer in zip(results, answers)
    ]
    every = [(task, *one) for (task, _, _), _, same, mine in found if same for one in mine]
    rows = [one for one in every if not vanishing(*one[0][:2])]
    parts = {
        name: [
            (e, c)
            for (hoop, start, bounce), _, _, e, c in rows
            if holds(hoop, start) and (name != "bouncing" or bounce is not None)
        ]
        for name, holds in PARTS.items()
    }
    parts["vanishing"] = [
        (e, c) for (hoop, start, _), _, _, e, c in every if vanishing(hoop, start)
    ]
    against = {}
    for quantity, (of, edges) in AGAINST.items():
        bins = [[] for _ in edges[1:]]
        for task, k, _, e, c in rows:
            value = of(task, k)
            if edges[0] <= value <= edges[-1]:
                bins[max(j for j in range(len(bins)) if edges[j] <= value)].append((e, c))
        against[quantity] = [
            dict(low=low, high=high, **row(numbers))
            for low, high, numbers in zip(edges, edges[1:], bins)
            if len(numbers) >= 20
        ]
    names = {name: row([(e, c) for _, _, n, e, c in rows if n == name]) for name in NUMBERS}
    ended = {}
    for (_, (_, how), _), _, _, _ in found:
        ended[how] = ended.get(how, 0) + 1
    lost = sorted(
        (
            (e / c if math.isfinite(e) else math.inf, result, answer, k, n, c)
            for result, answer, same, mine in found
            if not vanishing(*result[0][:2])
            for k, n, e, c in mine
        ),
        key=lambda w: -w[0],
    )
    return dict(
        motions=len(found),
        with_events=sum(bool(result[2]) for result, *_ in found),
        numbers=len(rows),
        events=sum(len(result[2]) for result, _, same, _ in found if same),
        ended=dict(sorted(ended.items(), key=lambda v: -v[1])),
        other_sequences=sum(not same for _, _, same, _ in found),
        other_sequences_of_ordinary=sum(
            not same and ordinary(*result[0][:2]) for result, _, same, _ in found
        ),
        parts={name: row(numbers) for name, numbers in parts.items() if numbers},
        names=names,
        against=against,
        most_lost=[
            dict(
                described(result),
                event=k + 1,
                number=n,
                units=rounded(w),
                conditioning=rounded(c),
                printed=repr(answer[0][k][n]),
                true=f"{result[1][0][k][n]:.20e}",
            )
            for w, result, answer, k, n, c in lost[:WORST]
        ],
        others=[
            dict(
                described(result),
                exact=words(result[1], len(result[2])),
                printed=words(answer, len(result[2]) + 1),
            )
            for result, answer, same, _ in found
            if not same
        ][:WORST],
        kept=[
            dict(
                described(result),
                lost=rounded(max(e / c for _, _, e, c in mine)),
                events=[
                    dict(cause=t["cause"], **{n: [f"{t[n]:.20e}", rounded(unit[n])] for n in unit})
                    for t, unit in zip(result[1][0], result[2][: mine[-1][0] + 1])
                ],
            )
            for result, _, same, mine in found
            if same and mine and not vanishing(*result[0][:2])
        ][:KEPT],
    )


def described(result):
    """A motion, by its numbers."""
    hoop, start, bounce = result[0]
    return dict(hoop=hoop, start=start, restitution=bounce)


def words(motion, count):
    """A motion in words."""
    return [
        f"{t['cause']} {t['to']} {t['direction']} {float(t['time'])!r}" for t in motion[0][:count]
    ] + [str(motion[1])]
