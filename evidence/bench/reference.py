"""Prints the reference of the motion that rolls for ever (compare.py holds it).

It has 30 digits, from the integral for the time.

On the orbit D (theta'^2 + 1) = K with D = 4 + 2 cos theta, so that the time is the integral of
sqrt(D / (K - D)).
"""

import mpmath as mp

mp.mp.dps = 40
K = mp.mpf(6) * (1 + mp.mpf(1) / 4)  # theta = 0, theta' = 0.5


def slowness(theta):
    d = 4 + 2 * mp.cos(theta)
    return mp.sqrt(d / (K - d))


def time(theta):
    return mp.quad(slowness, mp.linspace(0, theta, 9))


REVOLUTION = time(2 * mp.pi)
for until in (10, 10**6):
    turns = mp.floor(until / REVOLUTION)
    rest = until - turns * REVOLUTION
    angle = mp.findroot(lambda theta: time(theta) - rest, rest / REVOLUTION * 2 * mp.pi)
    print(until, mp.nstr(2 * mp.pi * turns + angle, 30))
