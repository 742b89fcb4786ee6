"""The text of a number that is enclosed, by the rule of the format; the checker's own reading of that rule."""

from __future__ import annotations

from fractions import Fraction

from .ranges import Inconclusive, Range


def text_of(value: Range) -> list[str]:
    """Return 30 digits and their error in hundredths of the last, rounded up; both ends have to agree on it."""
    low, high = value.ends()
    if low == high == 0:
        return ["0", "0"]
    if max(-low, high) <= Fraction(1, 10**40):
        return ["0", "1e-40"]
    if low <= 0 <= high:
        raise Inconclusive("a number is not told apart from 0")
    one, other = _digits(low), _digits(high)
    if one != other:
        raise Inconclusive("the digits of a number are not decided")
    return one


def _digits(x: Fraction) -> list[str]:
    size, power = abs(x), 0
    power = len(str(size.numerator)) - len(str(size.denominator))
    while Fraction(10) ** power > size:
        power -= 1
    unit = Fraction(10) ** (power - 29)
    count = round(x / unit)
    error = int(100 * abs(x / unit - count) + Fraction(1, 1000)) + 1
    digits = str(abs(count))
    if len(digits) == 31:
        digits, power = digits[:30], power + 1
    sign = "-" if x < 0 else ""
    digits = digits.rstrip("0")
    if 0 <= power <= 29:
        digits = digits.ljust(power + 1, "0")
        tail = digits[power + 1 :]
        body = digits[: power + 1] + ("." + tail if tail else "")
    elif -5 <= power < 0:
        body = "0." + "0" * (-power - 1) + digits
    else:
        body = digits[0] + ("." + digits[1:] if len(digits) > 1 else "") + f"e{power}"
    return [sign + body, f"{error}e{power - 31}"]
