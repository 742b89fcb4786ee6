"""Motions that start beside a curve on which two events coincide.

40 digits are compared with the library.

Needs gmpy2, python-flint and cargo: the library's answers are those of the example `transitions` of
the core, built from this checkout.

What is independent here.  Rolling and sliding are integrated by Taylor series of the balances of
momentum and of moment of momentum themselves, solved order by order for (theta'', N, F); no reduced
equation, no first integral, no elliptic integral.  A gliding hoop hangs on a particle in free fall:
the rests of its slip are the roots of a polynomial of degree six in the time, all of them, from
Arb.  The gap of a flight is that of a rigid body whose mass centre falls. Every event is a root in
a step of the series in which the signs at eight points and at the extrema between them are known.
Inputs are IEEE doubles and taken exactly.

What is compared.  The sequence of modes, causes and directions of slip, and time, angle, rate, slip
velocity and place at each transition.  A number that the doubles of the start do not determine to
its last digit cannot be right to its last digit: its unit is 2^-52 of itself (of a place, at least
2^-52 of the radius) or, where that is more, the largest change among SHAKES repetitions in which
every number of the hoop and of the state at the start of each phase is changed by 2^-52 of itself,
up or down (zeros and offset = 1, which are exact by their nature, stay).  Errors are given in these
units.  A start whose sequence changes in such a repetition is not decided by its doubles; there the
library has to give one of the sequences that occur.

Units: mass of the particle, radius and gravity are 1.
"""
