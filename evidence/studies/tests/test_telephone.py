import math

import pytest

from evidence.studies.telephone import (
    HOOP,
    MM_PER_PX,
    RADIUS_MM,
    UNITS,
    ideal,
    lift_off,
    motion,
    seconds_until,
)


def test_a_gap_opens_with_the_third_power_of_time():
    # N = 0 at the lift-off and grows evenly without contact: the gap has the third derivative of
    # the acceleration that the contact would need.
    for gap_mm in (1e-3, 1e-2):
        ratio = seconds_until(8.0 * gap_mm) / seconds_until(gap_mm)
        assert ratio == pytest.approx(2.0, rel=0.02)
    begin = motion()(lift_off())
    assert abs(float(begin.gap)) < 1e-12 and abs(float(begin.gap_rate)) < 1e-12


def test_gaps_are_those_of_free_fall():
    # In flight the mass centre falls with g and the hoop turns evenly: the gap in closed form.
    h = HOOP.h
    state = next(one.after for one in motion().transitions if one.cause == "lift_off")
    for gap_mm in (0.1, MM_PER_PX, 10.0):
        t = seconds_until(gap_mm) / UNITS.time_s
        height = (
            h * math.cos(state.theta)
            - h * math.sin(state.theta) * state.theta_rate * t
            - 0.5 * t * t
        )
        gap = height - h * math.cos(state.theta + state.theta_rate * t)
        assert gap * RADIUS_MM == pytest.approx(gap_mm, rel=1e-6)


def test_standard_errors_are_proportional_to_errors_of_places():
    # Samples of the likelihood tell μk: a hundred tell its error to a part of 1/√200; here three.
    small, large = ideal(120.0, 0.02), ideal(120.0, 0.2)
    sampled = 3.0 / math.sqrt(200.0)
    for name, bound in {
        "mu_s": 0.02,
        "mu_k": sampled,
        "inertia": 0.02,
        "restitution": 0.02,
    }.items():
        ratio = large.estimates[name].std_error / small.estimates[name].std_error
        assert ratio == pytest.approx(10.0, rel=bound)
