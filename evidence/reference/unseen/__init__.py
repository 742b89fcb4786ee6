"""Starts that nobody has seen: the library against programs that share no code with it.

    python3 -m unseen resistance                  2,000 starts with rolling resistance: minutes
    python3 -m unseen range                       2,000 of the whole range without it: minutes
    python3 -m unseen resistance 200 --seed 7     so many, with another seed

Needs the Python package `littlewood`, gmpy2 and python-flint.

*With rolling resistance*: moderate hoops, level planes and slopes, each law of restitution, one
hoop in six massless, followed to their end. The program of this package integrates in doubles:
Newton's and Euler's balances for (x″, θ″, N, F, couple) by Taylor series of order 22, events as
real eigenvalues of companion matrices, all modes tried at each event, impacts in the impulse; a
massless hoop that glides hangs on a particle in free fall. It repeats each motion with all that is
given changed by 1e-9, which says how well the doubles determine each number, and up to which event
the motion.

*Of the whole range*: hoops without resistance whose masses, friction and rates have any size, on
slopes up to 1.5, up to the second event. The package `follower` follows them with 60 digits, as in
`accuracy`, whose motions have no slopes.

With resistance a number differs if its error is 1,000 times what a change of the last digits of
the doubles makes, and 100,000 times after bounces have settled, which the program in doubles cuts
off at a rate of 1e-12. Of the whole range it differs if it is also wrong in the sixth digit; where
it is not, it has lost digits, as docs/accuracy.md measures, and is printed.
"""
