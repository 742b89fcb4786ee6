"""Derivatives of certified motions as balls, with respect to every quantity of hoop and start.

    python3 derivatives.py [MOTION ...]        writes derivatives.json beside this file

A certificate proves which phases and events a motion has, and encloses their times and states. Here
the flow of each phase is differentiated, in ball arithmetic: Taylor steps of the equations together
with their variational equations, with the remainder of Lagrange over a box that Picard's condition
proves to hold the solution. At an event g(y, p) = 0 the time moves by δτ = −δg/ġ, where ġ is a ball
without 0, so that the derivative exists; impacts are differentiated as they stand. The states that
come out must overlap with those of the certificate.

Not differentiated: motions in SI units, of massless hoops and of balanced ones; what comes after a
jam, or after infinitely many bounces; a slip or a gap rate that is 0 at the start, and two equal
coefficients of friction, as these have one side only.

Needs python-flint.
"""

from __future__ import annotations

import argparse
import json
import math
import multiprocessing
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import flint
from flint import arb, arb_series
from littlewood.certify.balls import Undecided
from littlewood.certify.body import Body, State
from littlewood.certify.impact import impact

HERE = Path(__file__).parent
HOOP = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "slope", "restitution")
START = ("theta", "theta_rate", "slip", "gap_rate")
NUMBERS = ("time", "theta", "theta_rate", "slip", "x")
BITS, ORDER = 128, 20
LONGEST, SHORTEST = 1 / 64, 1 / 8192
"""Steps, powers of two."""
DIGITS = 20
MOST = 5
"""Events of a motion."""
LARGEST = 1e-9
"""Radius of a ball over its number, or over 1 if that is smaller."""


class BoxError(ArithmeticError):
    """A step is too long for its box."""


class Number:
    """A ball, or a series, and its derivatives; None stands for those that are all 0."""

    __slots__ = ("d", "v")

    def __init__(self, v: Any, d: list[Any] | None = None) -> None:
        self.v, self.d = v, d

    def chained(self, v: Any, slope: Any) -> Number:
        """Return a function of it by its value and slope."""
        return Number(v, None if self.d is None else [slope * one for one in self.d])

    def __add__(self, other: Any) -> Number:
        other = of(other)
        if self.d is None or other.d is None:
            return Number(self.v + other.v, other.d if self.d is None else self.d)
        return Number(self.v + other.v, [a + b for a, b in zip(self.d, other.d, strict=True)])

    def __neg__(self) -> Number:
        return Number(-self.v, None if self.d is None else [-one for one in self.d])

    def __sub__(self, other: Any) -> Number:
        return self + -of(other)

    def __mul__(self, other: Any) -> Number:
        other = of(other)
        one, two = self.chained(self.v, other.v), other.chained(other.v, self.v)
        return Number(self.v * other.v, (Number(0, one.d) + Number(0, two.d)).d)

    def __truediv__(self, other: Any) -> Number:
        other = of(other)
        quotient = self.v / other.v
        if other.d is None:
            return self.chained(quotient, 1 / other.v)
        top = [arb(0)] * len(other.d) if self.d is None else self.d
        inverse = 1 / other.v
        return Number(
            quotient, [(a - quotient * b) * inverse for a, b in zip(top, other.d, strict=True)]
        )

    __radd__, __rmul__ = __add__, __mul__

    def __rsub__(self, other: Any) -> Number:
        return of(other) - self

    def __rtruediv__(self, other: Any) -> Number:
        return of(other) / self

    def __abs__(self) -> Number:
        return self if self.v > 0 else -self

    def __gt__(self, other: Any) -> bool:
        return bool(self.v > of(other).v)

    def __lt__(self, other: Any) -> bool:
        return bool(self.v < of(other).v)

    def is_zero(self) -> bool:
        """Whether it is exactly 0, derivatives aside."""
        return bool(self.v.is_zero())

    def sin(self) -> Number:
        """Return the sine."""
        return self.chained(self.v.sin(), self.v.cos())

    def cos(self) -> Number:
        """Return the cosine."""
        return self.chained(self.v.cos(), -self.v.sin())

    def sqrt(self) -> Number:
        """Return the root."""
        root = self.v.sqrt()
        return self.chained(root, 1 / (2 * root))


def of(value: Any) -> Number:
    """The number itself, or a constant."""
    return (
        value
        if isinstance(value, Number)
        else Number(value if isinstance(value, arb_series) else arb(value))
    )


Vector = list[Number]


def body_of(hoop: dict[str, Number]) -> Body:
    """The hoop of the maker, its numbers with derivatives."""
    body = Body.__new__(Body)
    offset, mass_ratio = hoop["offset"], hoop["mass_ratio"]
    body.offset, body.mass = offset, mass_ratio + 1
    body.h = offset / body.mass
    body.inertia = hoop["inertia"] + mass_ratio * offset * offset / body.mass
    body.mu_s, body.mu_k = hoop["mu_s"], hoop["mu_k"]
    body.chi = Number(0)  # No certificate with rolling resistance has derivatives.
    body.down, body.back = hoop["slope"].cos(), hoop["slope"].sin()
    body.constant = body.inertia + body.mass * (body.h * body.h + 1)
    return body


def field(body: Body, mode: str, sigma: int) -> Callable[[Vector], Vector]:
    """Return the rates of (θ, θ′, slip, x): Newton's law with the forces of a mode."""

    def rates(at: Vector) -> Vector:
        theta, rate, slip, _ = at
        sin, cos = theta.sin(), theta.cos()
        rolls = mode == "rolling"
        normal, friction = (
            body.rolling_forces(theta, rate) if rolls else body.sliding_forces(theta, rate, sigma)
        )
        lever = body.h * cos + 1
        turning = (body.h * sin * normal + lever * friction) / body.inertia
        if rolls:
            return [rate, turning, Number(0 * slip.v), -rate]
        slipping = friction / body.mass - body.back + lever * turning - body.h * sin * rate * rate
        return [rate, turning, slipping, slip - rate]

    return rates


def series(rates: Callable[[Vector], Vector], at: Vector, order: int) -> Vector:
    """Return the Taylor series of the solution through a point or a box."""
    columns = len(next(one.d for one in at if one.d is not None))
    start = [[one.v, *(one.d or [arb(0)] * columns)] for one in at]
    now = [[arb_series([value]) for value in row] for row in start]
    for length in range(2, order + 2):
        flint.ctx.cap = length
        slopes = rates([Number(row[0], row[1:]) for row in now])
        now = []
        for row, slope in zip(start, slopes, strict=True):
            parts = [slope.v, *(slope.d or [arb_series([0])] * columns)]
            now.append(
                [
                    value + of(part).v.integral()
                    if isinstance(part, arb_series)
                    else arb_series([value, part])
                    for value, part in zip(row, parts, strict=True)
                ]
            )
    return [Number(row[0], row[1:]) for row in now]


def flat(at: Vector, columns: int) -> list[Any]:
    """All balls of a state, values and derivatives."""
    return [part for one in at for part in (one.v, *(one.d or [arb(0)] * columns))]


def packed(balls: Sequence[Any], columns: int) -> Vector:
    """The state with these balls."""
    width = columns + 1
    return [Number(balls[i], list(balls[i + 1 : i + width])) for i in range(0, len(balls), width)]


def stepped(rates: Callable[[Vector], Vector], at: Vector, step: Any, columns: int) -> Vector:
    """Return the solution a step later."""
    start = flat(at, columns)
    slopes = flat(rates(at), columns)
    for _ in range(12):
        # Half as large again as the way that these slopes lead, to both sides.
        box = [
            a + arb(0, 1.5) * step * (abs(b).upper() + arb(2) ** -20)
            for a, b in zip(start, slopes, strict=True)
        ]
        slopes = flat(rates(packed(box, columns)), columns)
        # Picard's condition: the slopes in the box do not lead out of it.
        if all(
            a.contains(b + step.union(arb(0)) * c)
            for a, b, c in zip(box, start, slopes, strict=True)
        ):
            break
    else:
        raise BoxError("no box holds the solution")
    try:
        near, far = series(rates, at, ORDER - 1), series(rates, packed(box, columns), ORDER)
    except ValueError:
        raise BoxError("a denominator may vanish in the box") from None
    power = step**ORDER
    found = []
    for one, rest in zip(flat(near, columns), flat(far, columns), strict=True):
        value = arb(0)
        for k in reversed(range(ORDER)):
            value = value * step + (
                one[k] if isinstance(one, arb_series) else one if k == 0 else arb(0)
            )
        found.append(value + (rest[ORDER] if isinstance(rest, arb_series) else arb(0)) * power)
    return packed(found, columns)


def along(function: Callable[[Vector], Number], at: Vector, slopes: Vector) -> Any:
    """Return the derivative of a function in the direction of the flow."""
    there = function([Number(one.v, [slope.v]) for one, slope in zip(at, slopes, strict=True)])
    return there.d[0] if there.d is not None else arb(0)


def moved(at: Vector, slopes: Vector, delay: list[Any]) -> Vector:
    """Return a state along an event from that at a fixed time: δy + f δτ."""
    return [
        Number(
            one.v,
            [a + slope.v * b for a, b in zip(one.d or [arb(0)] * len(delay), delay, strict=True)],
        )
        for one, slope in zip(at, slopes, strict=True)
    ]


def delay_of(change: Number, rate: Any) -> list[Any]:
    """Return δτ = −δg/ġ."""
    if rate.contains(0):
        raise ArithmeticError("the event function may have a double root")
    assert change.d is not None
    return [-one / rate for one in change.d]


def without_derivatives(body: Body) -> Body:
    """The same hoop, its quantities fixed."""
    fixed = Body.__new__(Body)
    for name, value in vars(body).items():
        setattr(fixed, name, Number(value.v) if isinstance(value, Number) else value)
    return fixed


def ball(pair: Sequence[str]) -> Any:
    """The ball of a certificate."""
    return arb(pair[0]) + arb(0, 1) * arb(pair[1])


def differentiated(certificate: dict[str, Any]) -> dict[str, Any]:
    """Return the derivatives of the events of a motion."""
    flint.ctx.prec = BITS
    case = certificate["case"]
    given = {"slope": 0.0, **case["hoop"]}
    law = given.pop("restitution_law", None)
    start = case["start"]
    names = [name for name in (*HOOP, *START) if name in given or name in start]
    if given["mu_s"] == given["mu_k"]:
        names = [name for name in names if name not in ("mu_s", "mu_k")]
    names = [name for name in names if not (name in ("slip", "gap_rate") and start[name] == 0)]
    names = [name for name in names if not (name == "restitution" and given[name] == 0)]
    columns = len(names)

    def variable(name: str, value: float) -> Number:
        return Number(arb(value), [arb(name == one) for one in names])

    hoop = {name: variable(name, value) for name, value in given.items()}
    body = body_of(hoop)
    at = [variable(name, start[name]) for name in ("theta", "theta_rate", "slip")] + [
        Number(arb(0), [arb(0)] * columns)
    ]
    gap_rate = variable("gap_rate", start["gap_rate"])
    time, delay, rows = arb(0), [arb(0)] * columns, []
    mode, sigma = certificate["initial"]["mode"], certificate["initial"]["direction"]
    for event in certificate["events"][:MOST]:
        cause, state = event["cause"], event["state"]
        if mode not in ("rolling", "sliding", "flight") or cause in (
            "settle",
            "jam",
            "singularity",
            "graze",
        ):
            break
        end = ball(state["time"])
        closing = None
        if mode == "flight":
            at, delay, closing = flown(body, at, gap_rate, end - time, delay)
        else:
            at, delay = followed(body, mode, sigma, at, end - time, delay, cause)
            if cause in ("stick", "reversal", "slip"):
                at[2] = Number(arb(0), [arb(0)] * columns)
        gap_rate = Number(arb(0), [arb(0)] * columns)
        if closing is not None and law is not None:
            before = State(of(0), at[0], at[1], at[2], at[3], of(0), closing)
            hit = impact(body, before, hoop["restitution"], law)
            at[1], at[2], gap_rate = of(hit.after.rate), of(hit.after.slip), of(hit.after.gap_rate)
        found = [Number(end, delay), *at]
        for name, one in zip(NUMBERS, found, strict=True):
            assert one.v.overlaps(ball(state[name])), (case["name"], cause, name)
        row = {name: texts(names, one, columns) for name, one in zip(NUMBERS, found, strict=True)}
        if not all(is_small(*pair) for one in row.values() for pair in one.values()):
            # Long motions widen the balls: more bits, and shorter steps, would go on.
            break
        rows.append({"cause": cause, **row})
        # The certificate's balls are smaller.
        at = [
            Number(ball(state[n]), one.d or [arb(0)] * columns)
            for n, one in zip(NUMBERS[1:], at, strict=True)
        ]
        time, mode, sigma = end, event["to"], event["direction"]
    return {"motion": case["name"], "events": rows}


def is_small(middle: str, radius: str) -> bool:
    """Whether a ball says something."""
    return float(radius) <= LARGEST * max(1.0, abs(float(middle)))


def followed(
    body: Body, mode: str, sigma: int, at: Vector, length: Any, delay: list[Any], cause: str
) -> tuple[Vector, list[Any]]:
    """Return the state along the event that ends a contact phase, and the time's derivatives."""
    columns, rates = len(delay), field(body, mode, sigma)
    fixed = without_derivatives(body)
    at = moved(at, rates(at), [-one for one in delay])
    left, step = length, LONGEST
    while True:
        is_last = bool(left < step)
        try:
            at = stepped(rates, at, left if is_last else arb(step), columns)
        except BoxError:
            step /= 2
            if step < SHORTEST:
                raise
            continue
        if is_last:
            break
        left, step = left - step, min(LONGEST, 2 * step)

    def ends(body: Body) -> Callable[[Vector], Number]:
        def function(at: Vector) -> Number:
            if cause == "lift_off":
                return body.contact(at[0], at[1])
            if cause == "slip":
                normal, friction = body.rolling_forces(at[0], at[1])
                return body.mu_s * normal - abs(friction)
            return at[2]

        return function

    slopes = field(fixed, mode, sigma)(at)
    change = ends(body)(at)
    assert change.v.contains(0), (cause, change.v)
    later = delay_of(change, along(ends(fixed), at, slopes))
    return moved(at, slopes, later), later


def flown(
    body: Body, at: Vector, gap_rate: Number, length: Any, delay: list[Any]
) -> tuple[Vector, list[Any], Number]:
    """Return the state along the landing, the time's derivatives, and the gap rate before it."""
    theta, rate, slip, x = at
    sin, cos = theta.sin(), theta.cos()
    up = gap_rate - body.h * sin * rate
    # The mass centre moves along at x′ − h cos θ θ′, which gravity changes on a slope.
    ahead = slip - rate - body.h * cos * rate

    def there(length: Number) -> tuple[Number, Number, Vector]:
        half = length * length / 2
        angle = theta + rate * length
        gap = up * length - body.down * half + body.h * cos - body.h * angle.cos()
        opening = up - body.down * length + body.h * angle.sin() * rate
        place = x - body.h * sin + ahead * length - body.back * half + body.h * angle.sin()
        sliding = ahead - body.back * length + body.h * angle.cos() * rate + rate
        return gap, opening, [angle, rate, sliding, place]

    gap, opening, _ = there(Number(length, [-one for one in delay]))
    assert gap.v.contains(0), gap.v
    later = delay_of(gap, opening.v)
    _, opening, state = there(Number(length, [a - b for a, b in zip(later, delay, strict=True)]))
    return state, later, opening


def texts(names: Sequence[str], one: Number, columns: int) -> dict[str, list[str]]:
    """Return midpoints and radii of the derivatives of a number."""
    found = {}
    for name, value in zip(names, one.d or [arb(0)] * columns, strict=True):
        middle = value.mid().str(DIGITS, radius=False)
        radius = abs(value - arb(middle)).upper()
        found[name] = [
            middle,
            "0" if radius.is_zero() else f"{math.nextafter(float(radius), math.inf) * 1.01:.1e}",
        ]
    return found


def attempted(name: str) -> dict[str, Any] | None:
    """Return the derivatives of a motion, or None where one of its events has none."""
    certificate = json.loads((HERE / "certificates" / f"{name}.json").read_text(encoding="utf-8"))
    try:
        found = differentiated(certificate)
    except (ArithmeticError, Undecided) as error:
        print(f"{name}: {error}", flush=True)
        return None
    print(name, len(found["events"]), "events", flush=True)
    return found if found["events"] else None


def is_within(certificate: dict[str, Any]) -> bool:
    """Whether a motion is one of those that are differentiated."""
    case = certificate["case"]
    has_inertia = case["hoop"].get("inertia", 0) > 0 and case["hoop"].get("offset", 0) > 0
    return bool(
        certificate["certified"]
        and certificate["events"]
        and has_inertia
        and not case["hoop"].get("rolling_resistance")
        and case["units"] == "dimensionless"
    )


def main() -> None:
    """Differentiate motions."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "motions",
        nargs="*",
        help="by default, those that it can differentiate: 33 minutes of one core",
    )
    given = parser.parse_args().motions
    paths = sorted((HERE / "certificates").glob("*.json"))
    can = [path.stem for path in paths if is_within(json.loads(path.read_text(encoding="utf-8")))]
    with multiprocessing.Pool() as pool:
        found = [one for one in pool.imap(attempted, given or can) if one is not None]
    if given:
        print(json.dumps(found, indent=1))
        return
    lines = ",\n".join(json.dumps(one) for one in found)
    head = json.dumps({"made_by": "derivatives.py", "numbers": NUMBERS})[:-1]
    (HERE / "derivatives.json").write_text(
        f'{head}, "motions": [\n{lines}\n]}}\n', encoding="ascii"
    )
    print(len(found), "motions")


if __name__ == "__main__":
    main()
