"""The precision in which a motion is followed."""

import gmpy2

ULP = 2.0**-52
FINE = (220, 42, 1e-42)          # bits, order of the series, error of a step
COARSE = (220, 20, 1e-22)        # for repetitions, which need only a difference


class Tie(Exception):
    """Two events that 40 digits do not tell apart, or a state without a motion of its own."""


class Work:
    """The setting with which series and roots are found."""

    bits, order, error = FINE

    @classmethod
    def use(cls, setting):
        cls.bits, cls.order, cls.error = setting
        gmpy2.get_context().precision = cls.bits
