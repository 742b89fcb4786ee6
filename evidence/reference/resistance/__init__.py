"""Motions of the loaded hoop with rolling resistance, to 40 digits.

    python3 -m resistance                      writes resistance.json beside this package

Needs gmpy2 and python-flint.

The plane acts on the rim with a normal force N, a friction force F and a couple K. While the hoop
turns, K = -chi N sign(theta'); while it does not, |K| <= chi N. chi is a length over the radius.

What is independent here. Contact is Newton's and Euler's equations of the centre and the angle, and
nothing else: five linear equations for (x'', theta'', N, F, K) with the laws of contact as the last
two, solved anew at each angle and, order by order, for the Taylor series of a phase. No reduced
equation, no first integral, no closed form, no orbit constant. Which motion follows is found by
trying all modes. An impact is followed in the normal impulse from event to event by the same
equations for impulses. Roots of events, precision, flights and series of sine and cosine are those
of the package `follower`, which knows no rolling resistance. Inputs are IEEE doubles and taken
exactly.

Units: mass of the particle, radius and gravity are 1.
"""
