"""An orbit of rolling: its rates, its friction demand, its time."""

import gmpy2
from follower.hoop import rolling_forces
from gmpy2 import mpfr


def rolled(hoop, theta, rate, other):
    """Square of the rate at another angle of the same rolling orbit."""

    def weight(angle):
        return hoop.i + hoop.m * (1 + hoop.h**2 + 2 * hoop.h * gmpy2.cos(angle))

    return weight(theta) * (rate * rate + 1) / weight(other) - 1


def demand(hoop, theta, rate_squared):
    """|F|/N of rolling, and N."""
    _, n, f = rolling_forces(hoop, theta, gmpy2.sqrt(rate_squared))
    return abs(f) / n, n


def travel(hoop, theta, rate, other):
    """Rough time of rolling to another angle."""
    rates = [
        float(rolled(hoop, theta, rate, mpfr(theta + (other - theta) * (k + 0.5) / 100)))
        for k in range(100)
    ]
    return abs(other - theta) / 100 * sum(max(v, 1e-4) ** -0.5 for v in rates)
