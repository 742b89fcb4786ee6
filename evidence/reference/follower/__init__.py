"""Motions of the loaded hoop, to 40 or 60 digits, of any length that their number of turns allows.

Needs gmpy2 and python-flint.

What is independent here.  Rolling and sliding are integrated by Taylor series of the balances of
momentum and of moment of momentum themselves: in the time, solved order by order for (theta'', N,
F), or, where the hoop turns fast enough, in the angle, in which they are linear in theta'^2.  No
first integral of a slide, no elliptic integral.  A gliding hoop hangs on a particle in free fall:
the rests of its slip are the roots of a polynomial of degree six in the time, all of them, from
Arb.  The gap of a flight is that of a rigid body whose mass centre falls. An impact has no table of
cases: Newton's and Euler's equations are followed in the normal impulse from event to event. Every
event is a root in a step of the series in which the signs at eight points and at the extrema
between them are known.  Inputs are IEEE doubles and taken exactly.

Units: mass of the particle, radius and gravity are 1.
"""
