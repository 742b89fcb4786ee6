"""Roots: the first fall of a function through zero, and all roots of a polynomial."""

import flint
import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie, Work
from .series import slope, value


def root(f, slope_of_f, low, high, sign):
    """Root of f between low and high, where sign*f goes from plus to minus.

    By bisection, then Newton's method.
    """
    a, b = low, high
    t = (a + b) / 2
    for _ in range(30):
        for _ in range(40):
            t = (a + b) / 2
            if sign * f(t) > 0:
                a = t
            else:
                b = t
        t = (a + b) / 2
        for _ in range(8):
            step = f(t) / slope_of_f(t)
            if not a <= t - step <= b:
                break
            t -= step
            if abs(step) < mpfr(10) ** -40 * abs(t):
                for _ in range(2):
                    t -= f(t) / slope_of_f(t)
                return t
    return t


def first_fall(f, df, low, high, parts=8):
    """First time in (low, high] at which f, positive behind low, falls through zero.

    Extrema between points are included.
    """
    width = high - low
    before = low
    slope_before = df(low)
    for k in range(1, parts + 1):
        t = high if k == parts else low + width * k / parts
        here, slope_here = f(t), df(t)
        if here <= 0:
            top = before
            if slope_before > 0:
                top = root(df, lambda x: (df(x + 1e-25) - df(x - 1e-25)) / 2e-25, before, t, 1)
            return root(f, df, top, t, 1)
        if slope_before < 0 < slope_here:
            a, b = before, t
            for _ in range(int(Work.bits * 0.9)):
                middle = (a + b) / 2
                if df(middle) < 0:
                    a = middle
                else:
                    b = middle
            lowest = f(a)
            if abs(lowest) < 1e-38:
                raise Tie("touches")
            if lowest < 0:
                return root(f, df, before, a, 1)
        before, slope_before = t, slope_here
    return None


def fall_of(p, length, known=0):
    """The same for a polynomial on (0, length], with `known` roots at 0 divided out."""
    p = p[known:]
    if stays(p, length):
        return None
    d = slope(p)
    return first_fall(lambda t: value(p, t), lambda t: value(d, t), mpfr(0), mpfr(length))


def stays(p, length):
    """Whether the first coefficient of a polynomial outweighs all others on (0, length]."""
    if p[0] > 0:
        numbers, total, power = [abs(float(v)) for v in p], 0.0, 1.0
        for v in numbers[1:]:
            power *= length
            total += v * power
        return numbers[0] > 1.001 * total
    if p[0] < 0:
        raise Tie("an event is over where its phase begins")
    return False


def arb(v):
    """An mpfr as an exact number of Arb."""
    mantissa, exponent = v.as_mantissa_exp() if v else (0, 0)
    return flint.arb(int(mantissa)) * flint.arb(2) ** int(exponent)


def number(v):
    """The middle of a ball."""
    man, exp = v.mid().man_exp()
    return (
        gmpy2.mul_2exp(mpfr(int(man)), int(exp))
        if int(exp) >= 0
        else gmpy2.div_2exp(mpfr(int(man)), -int(exp))
    )


def all_roots(p):
    """Balls that hold the roots of a polynomial, one each."""
    for bits in (4 * Work.bits, 16 * Work.bits):
        flint.ctx.prec = bits
        try:
            return flint.acb_poly([arb(v) for v in p]).roots(tol=flint.arb(2) ** (-Work.bits))
        except ValueError:
            pass
    raise Tie("a double root")


def highest(f, low, high):
    """Where a function of one top between two places has it, by golden section."""
    golden = (gmpy2.sqrt(mpfr(5)) - 1) / 2
    for _ in range(90):
        a, b = high - golden * (high - low), low + golden * (high - low)
        low, high = (low, b) if f(a) > f(b) else (a, high)
    return low
