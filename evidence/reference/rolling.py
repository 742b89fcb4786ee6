"""Reference times of rolling, to 25 digits.

    python3 -m pip install mpmath gmpy2 python-flint
    python3 rolling.py                         writes rolling.json beside this file

While the hoop rolls, D (1 + theta'^2) = K is constant, D = A + 2 l cos(theta), A = I + m (1 + h^2),
and so d(tau) = sqrt(D / (K - D)) |d(theta)|.  The times are quadratures of this (tanh-sinh, mpmath)
and know nothing of elliptic integrals.  Two substitutions keep the integrand smooth:

* rotation (K > A + 2 l): theta itself, cut at distances 1/10, 1/100, ... from the tops, where K - D
  nearly vanishes;
* libration: sin((theta - bottom)/2) = k sin(psi), which takes the root out at both turning points,
  cut in the same
  way towards psi = +-pi/2.

Each value is found with 50 digits and again with 65 and other cuts.  That the quadrature describes
the rolling hoop is seen on the items in INTEGRATED, where the balances of momentum of `follower`
(no K, no D) are integrated for the time found and the angle reached is compared with theta1.  All
differences are written into the file.
"""

import json
import os

import mpmath as mp
from follower.arithmetic import FINE, Work
from follower.contact import drift
from follower.hoop import Hoop
from gmpy2 import mpfr
from mpmath import mpf

DIGITS = 25
PI = 3.141592653589793

# name: (mass_ratio, offset, inertia), theta0, theta_rate0, theta1 (one arc, no turning point
# inside)
ARCS = {
    "rotation": ((1.0, 1.0, 1.0), 0.5, 1.5, 2.5),
    "rotation_many_turns": ((1.0, 1.0, 1.0), 0.5, 1.5, 40.0),
    "rotation_negative_rate": ((0.7, 0.8, 0.6), 1.0, -1.3, -7.0),
    "rotation_fast": ((1.0, 0.9, 0.3), 2.0, 25.0, 9.0),
    "through_pi": ((2.0, 0.8, 1.5), 2.0, 0.9, 4.5),
    "through_zero": ((2.0, 0.8, 1.5), -0.75, 0.8, 1.25),
    "through_zero_negative_rate": ((2.0, 0.8, 1.5), 0.75, -0.8, -1.25),
    "libration": ((1.0, 1.0, 1.0), 2.5, 0.3, 3.25),
    "libration_negative_rate": ((1.0, 0.5, 0.4), 4.0, -0.2, 2.5),
    "libration_from_rest": ((1.0, 1.0, 1.0), 2.0, 0.0, 4.0),
    "libration_far_from_zero": ((1.0, 1.0, 1.0), -22.5, 0.3, -21.5),
    "separatrix_outside": ((1.0, 1.0, 1.0), PI, 1.4142135625436166, 8.0),
    "separatrix_inside": ((1.0, 1.0, 1.0), PI, 1.4142135622031738, 6.28),
    "separatrix_inside_negative_rate": ((1.0, 1.0, 1.0), PI, -1.4142135622031738, 0.001),
    "from_the_top": ((1.0, 1.0, 1.0), 0.0, 1e-08, 3.0),
    "small_libration": ((1.0, 1.0, 1.0), 3.140592653589793, 0.0, 3.142),
    "massless": ((0.0, 0.5, 0.0), 0.1, 0.6, 5.0),
    "massless_libration": ((0.0, 0.5, 0.0), 2.5, -0.4, 2.4),
    "massless_on_the_rim": ((0.0, 1.0, 0.0), 0.25, 0.5, 3.0),
    "tiny_offset": ((1.0, 1e-08, 1.0), 0.5, 0.7, 6.0),
    "tiny_offset_slow": ((1.0, 1e-08, 1.0), 0.5, 1e-05, 2.0),
    "no_offset": ((1.0, 0.0, 0.5), 0.25, -0.75, -3.5),
    "short_arc": ((1.0, 1.0, 1.0), 1.0, 1.25, 1.000001),
    "short_arc_at_pi": ((0.5, 0.75, 0.25), 3.1415926, 2.0, 3.1415927),
    "short_arc_from_rest": ((1.0, 1.0, 1.0), 2.0, 0.0, 2.000001),
    "heavy": ((10.0, 1.0, 10.0), 1.5, 0.4, 7.5),
    "very_light": ((1e-4, 1.0, 1e-4), 0.3, 0.5, 6.0),
}
# name: the same without theta1; the period of theta, in rotation the time of one turn
PERIODS = {
    "rotation": ((1.0, 1.0, 1.0), 0.5, 1.5),
    "rotation_negative_rate": ((0.7, 0.8, 0.6), 1.0, -1.3),
    "rotation_fast": ((1.0, 0.9, 0.3), 2.0, 25.0),
    "libration": ((1.0, 1.0, 1.0), 2.5, 0.3),
    "libration_from_rest": ((1.0, 1.0, 1.0), 2.0, 0.0),
    "separatrix_outside": ((1.0, 1.0, 1.0), PI, 1.4142135625436166),
    "separatrix_inside": ((1.0, 1.0, 1.0), PI, 1.4142135622031738),
    "small_libration": ((1.0, 1.0, 1.0), 3.140592653589793, 0.0),
    "massless": ((0.0, 0.5, 0.0), 0.1, 0.6),
    "massless_libration": ((0.0, 0.5, 0.0), 2.5, -0.4),
    "tiny_offset": ((1.0, 1e-08, 1.0), 0.5, 0.7),
    "heavy": ((10.0, 1.0, 10.0), 1.5, 0.4),
    "very_light": ((1e-4, 1.0, 1e-4), 0.3, 0.5),
}
INTEGRATED = (
    "rotation",
    "rotation_negative_rate",
    "libration",
    "through_zero_negative_rate",
    "massless",
)


class Orbit:
    def __init__(self, hoop, theta0, rate0, ratio):
        m1, self.l, izz = map(mpf, hoop)
        h = self.l / (1 + m1)
        # The inertia about the contact point is a + 2 l cos theta.
        self.a, self.ratio = (
            izz + m1 * h**2 + (self.l - h) ** 2 + (1 + m1) * (1 + h**2),
            ratio,
        )  # ratio of the cuts
        self.theta0, self.rate0 = mpf(theta0), mpf(rate0)
        self.gain = self.d(self.theta0) * self.rate0**2  # K - D at the start
        short = mp.sin(self.theta0 / 2) ** 2 - self.gain / (4 * self.l) if self.l else -self.gain
        assert short != 0, "on the separatrix"
        self.turns = short < 0  # passes over the top
        if not self.turns:
            self.bottom = mp.pi * (2 * mp.floor(self.theta0 / (2 * mp.pi)) + 1)
            self.k = mp.sqrt(
                mp.sin((self.theta0 - self.bottom) / 2) ** 2 + self.gain / (4 * self.l)
            )
            self.short = short  # 1 - k^2

    def d(self, theta):
        return self.a + 2 * self.l * mp.cos(theta)

    def left(self, theta):
        """K - D.

        The difference of the cosines is a product, so that nothing cancels near a turning point.
        """
        return self.gain + 4 * self.l * mp.sin((theta + self.theta0) / 2) * mp.sin(
            (theta - self.theta0) / 2
        )

    def psi(self, theta):
        left = self.left(theta)
        assert abs(theta - self.bottom) < mp.pi and left >= 0, "beyond the turning point"
        return mp.atan2(mp.sin((theta - self.bottom) / 2), mp.sqrt(left / (4 * self.l)))

    def cuts(self, a, b, around):
        """a, b (a < b) and, between them, points that close in on each member of around."""
        near = [p + g * self.ratio**-j for p in around for j in range(13) for g in (1, -1)] + list(
            around
        )
        return [a] + sorted(p for p in near if a < p < b) + [b]

    def time(self, a, b):
        """Time from theta = a to theta = b; in a libration a and b are values of psi."""
        a, b = min(a, b), max(a, b)
        if self.turns:
            tops = [
                2 * mp.pi * n
                for n in range(int(mp.floor(a / (2 * mp.pi))), int(mp.ceil(b / (2 * mp.pi))) + 1)
            ]
            # the bottoms too, where D is least
            places = self.cuts(a, b, tops + [t + mp.pi for t in tops])
            return mp.quad(lambda t: mp.sqrt(self.d(t) / self.left(t)), places)

        def g(psi):
            z = self.k * mp.sin(psi)
            # theta = bottom + 2 asin z: cos theta = 2 z^2 - 1; cos^2(psi) + (1 - k^2) sin^2(psi) =
            # 1 - z^2
            left = mp.cos(psi) ** 2 + self.short * mp.sin(psi) ** 2
            return mp.sqrt((self.a + 2 * self.l * (2 * z * z - 1)) / (self.l * left))

        return mp.quad(g, self.cuts(a, b, [-mp.pi / 2, mpf(0), mp.pi / 2]))


def arc(hoop, theta0, rate0, theta1, ratio=10):
    o = Orbit(hoop, theta0, rate0, ratio)
    assert (theta1 - theta0) * rate0 > 0 or rate0 == 0
    return (
        o.time(mpf(theta0), mpf(theta1))
        if o.turns
        else o.time(o.psi(mpf(theta0)), o.psi(mpf(theta1)))
    )


def period(hoop, theta0, rate0, ratio=10):
    o = Orbit(hoop, theta0, rate0, ratio)
    return o.time(-mp.pi, mp.pi) if o.turns else 2 * o.time(-mp.pi / 2, mp.pi / 2)


def twice(f, *given):
    """The value with 50 digits and its relative difference from another.

    That one has 65 digits, and other cuts.
    """
    with mp.workdps(50):
        value = f(*given)
    with mp.workdps(65):
        other = f(*given, ratio=7)
        return value, abs(value / other - 1)


def integrated(hoop, theta0, rate0, theta1, time):
    """Distance from theta1 of the hoop rolling for that time by Newton-Euler."""
    Work.use(FINE)
    theta = drift(
        Hoop(*hoop, 0, 0),
        "rolling",
        0,
        (mpfr(theta0), mpfr(rate0), mpfr(0)),
        mpfr(mp.nstr(time, 50)),
    )[0]
    return abs(theta - theta1)


def item(name, hoop, theta0, rate0, **more):
    given = dict(
        mass_ratio=hoop[0], offset=hoop[1], inertia=hoop[2], theta0=theta0, theta_rate0=rate0
    )
    return dict(name=name, **given, **more)


def main():
    arcs, periods, worst, reached = [], [], mpf(0), {}
    for name, given in ARCS.items():
        value, difference = twice(arc, *given)
        worst = max(worst, difference)
        arcs.append(item(name, *given[:3], theta1=given[3], time=mp.nstr(value, DIGITS)))
        print(f"{name:32} {arcs[-1]['time']:32} {mp.nstr(difference, 3)}", flush=True)
        if name in INTEGRATED:
            reached[name] = "{0:.3g}".format(integrated(*given, value))
            print("    integrated:", reached[name], flush=True)
    for name, given in PERIODS.items():
        value, difference = twice(period, *given)
        worst = max(worst, difference)
        kind = "rotation" if Orbit(*given, 10).turns else "libration"
        periods.append(item(name, *given, kind=kind, period=mp.nstr(value, DIGITS)))
        print(f"{name:32} {periods[-1]['period']:32} {mp.nstr(difference, 3)} {kind}", flush=True)
    assert worst < mpf(10) ** -28
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "rolling.json")
    with open(path, "w", encoding="ascii") as file:
        json.dump(
            dict(
                made_by="rolling.py",
                written_digits=DIGITS,
                largest_relative_difference=mp.nstr(worst, 3),
                angle_missed_by_newton_euler=reached,
                arcs=arcs,
                periods=periods,
            ),
            file,
            indent=1,
        )
        file.write("\n")


if __name__ == "__main__":
    main()
