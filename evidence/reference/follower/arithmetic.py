"""The precision in which a motion is followed."""

import gmpy2

ULP = 2.0**-52
FINEST = (280, 72, 1e-62)  # bits, order of the series, error of a step
FINE = (220, 42, 1e-42)
COARSE = (220, 20, 1e-22)  # for repetitions, which need only a difference


class Tie(Exception):
    """Where the follower gives up.

    Two events that 40 digits cannot separate, a state with no consistent motion, or one too
    long.

    What was followed until then is in `first` and `transitions`.
    """

    first, transitions = None, ()


class Work:
    """The setting with which series and roots are found, and the most steps of a phase."""

    bits, order, error = FINE
    steps = 100

    @classmethod
    def use(cls, setting, steps=100):
        cls.bits, cls.order, cls.error = setting
        cls.steps = steps
        gmpy2.get_context().precision = cls.bits
