import math
from itertools import pairwise

import numpy as np
import pytest

from studies.contact import Contact
from studies.grazing import Margin
from studies.roots import zero
from studies.sequences import STEPS, boundaries, curves, first_turn, hoop_of


def test_a_slip_comes_out_of_nothing_where_the_orbit_grazes_the_limit_of_friction():
    found = 0
    for gamma in (0.4, 0.5, 0.6):
        for part in (0.4, 0.5, 0.6):
            rate = part / math.sqrt(gamma)
            last = boundaries(rate, 0.1, 2.0, 12, gamma)[-1]
            assert last.above.word == "R"
            contact = Contact.of(hoop_of(last.mu, gamma))
            margin = Margin(contact, last.mu)
            constant = contact.denominator(0.0) * (1.0 + rate**2)

            def slope(theta, margin=margin, constant=constant):
                a, b = margin.terms(theta)
                return a[1] - constant * b[1]

            angles = np.linspace(0.0, 2.0 * math.pi, 361)
            least = math.inf
            for low, high in pairwise(angles):
                if slope(low) < 0.0 <= slope(high):
                    a, b = margin.terms(zero(slope, low, high))
                    least = min(least, (a[0] - constant * b[0]) / abs(a[0]))
            assert abs(least) < 1e-9
            found += last.kind == "a slip out of nothing"
    assert found >= 7


def turns_with_next_to_no_friction(count):
    """Yield the reversals of the frictionless turn, from its cubic equation, with the turns at two small frictions."""
    random = np.random.default_rng(4)
    for _ in range(count):
        gamma = random.uniform(0.1, 0.7)
        rate = random.uniform(0.1, 0.95) / math.sqrt(gamma)
        contact = Contact.of(hoop_of(0.0, gamma))
        m, h, inertia = contact.m, contact.h, contact.inertia
        lever = np.polynomial.Polynomial([1.0, h])
        c = np.polynomial.Polynomial([0.0, 1.0])
        cubic = lever**2 * (inertia * rate**2 + 2.0 * m * h * (1.0 - c))
        cubic -= rate**2 * (1.0 + h) ** 2 * (inertia + m * h * h * (1.0 - c**2))
        roots = cubic.roots()
        inside = [one.real for one in roots if abs(one.imag) < 1e-9 and -0.995 < one.real < 0.995]
        near = [one for one in roots if 0.99 < abs(one) < 1.01 and abs(one.imag) < 0.05]
        if len(near) == 1:
            yield 2 * len(inside), first_turn(1e-9, rate, gamma), first_turn(1e-11, rate, gamma)


def slides(turn):
    """Return the durations of the slides of a turn."""
    return [duration for mode, duration in zip(turn.word, turn.durations, strict=True) if mode != "R"]


def test_without_friction_reversals_are_the_roots_of_a_cubic_equation():
    counts = set()
    for reversals, turn, _ in turns_with_next_to_no_friction(120):
        assert turn.stop == "revolution"
        long = [duration > 0.01 for duration in slides(turn)]
        assert sum(long) == 1 + reversals
        assert all(long[:-1])
        counts.add(sum(long))
    assert counts == {1, 3, 5}


def test_a_last_slide_just_before_the_top_is_as_long_as_the_root_of_friction():
    found = 0
    for reversals, turn, other in turns_with_next_to_no_friction(120):
        assert other.word == turn.word
        if len(slides(turn)) == 2 + reversals:
            assert slides(turn)[-1] == pytest.approx(10.0 * slides(other)[-1], rel=0.01)
            found += 1
    assert found > 80


def test_a_finer_scan_of_a_line_finds_the_same_boundaries():
    coarse = [one.mu for one in boundaries(0.8, 0.05, 2.0, 15)]
    assert coarse == pytest.approx([one.mu for one in boundaries(0.8, 0.05, 2.0, 90)], rel=1e-9)
    assert len(coarse) > 2


def test_curves_go_through_the_boundaries_of_another_scan():
    lines = curves()
    assert max(len(points) for _, points in lines) > 6 * STEPS
    whole = [(kind, points) for kind, points in lines if len(points) > 2 * STEPS]
    found = 0
    for kind, points in whole:
        # Halfway along, which is between two lines as a rule.
        rate, mu = points[len(points) // 2]
        near = boundaries(rate, 0.8 * mu, 1.25 * mu, 9)
        found += any(one.kind == kind and one.mu == pytest.approx(mu, rel=1e-5) for one in near)
    assert found == len(whole)
