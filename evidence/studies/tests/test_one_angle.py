import math

import pytest

from evidence.studies.hoops import thin_hoop
from evidence.studies.one_angle import (
    before_top,
    jumps_of,
    second_sample,
    turned_at_top,
    turned_in_air,
    whole_turns,
)
from evidence.studies.roots import zero


def test_every_hoop_that_slides_off_the_plane_turns_by_the_same_angle():
    found = 0
    for _, motion, place in jumps_of(11, 1500):
        flight = motion.phases[place]
        angle = before_top(flight.start.theta)
        if not 1e-3 < angle < 1.3:
            continue
        found += 1
        # The angle of lift-off is known to some units of its last digit, which the law does not
        # amplify here.
        assert abs(flight.end.theta - flight.start.theta) == pytest.approx(
            turned_in_air(angle), rel=1e-11
        )
    assert found > 100


def test_small_angles_are_turned_four_times_and_the_gap_is_largest_after_three():
    for angle in (1e-3, 1e-2):
        assert turned_in_air(angle) == pytest.approx(4.0 * angle, rel=angle**2)
        assert turned_at_top(angle) == pytest.approx(3.0 * angle, rel=angle**2)


def test_the_angle_with_a_vertical_tangent_lands_without_a_rate():
    # tan(φ/2) = φ/2 at φ = 8.98681891581…
    turned = 8.986818915818
    c, s = math.cos(turned) - 1.0 + 0.5 * turned**2, turned - math.sin(turned)
    assert math.atan(c / s) == pytest.approx(1.3518, abs=1e-4)
    assert turned_in_air(math.atan(c / s) - 1e-4) < turned < turned_in_air(math.atan(c / s) + 1e-4)


def test_whole_turns_in_the_air_have_a_closed_form():
    for number in range(1, 8):
        assert turned_in_air(whole_turns(number)) == pytest.approx(
            2.0 * math.pi * number, rel=1e-12
        )
    # A slide that is about to lift off there, of a hoop that was not used for this.
    h, angle = 0.7, math.atan(math.pi)
    hoop = thin_hoop(h, mu_k=0.2)
    rate = 1.0 / math.sqrt(h * math.cos(angle))
    flight = next(
        phase
        for phase in hoop.simulate(
            theta=-angle, theta_rate=rate * (1.0 - 1e-13), slip=1.0, max_transitions=2
        ).phases
        if phase.mode == "flight"
    )
    assert flight.end.theta - flight.start.theta == pytest.approx(2.0 * math.pi, abs=1e-6)


def test_vertical_tangents_are_where_the_tangent_is_the_angle_and_half_turns():
    for number in (1, 2, 3):
        low, high = 0.5 * math.pi - 1.0 / (number * math.pi), 0.5 * math.pi - 1e-9
        place = zero(lambda angle: math.tan(angle) - angle - number * math.pi, low, high)  # noqa: B023
        # The landing moves with the cube root of the distance there.
        steps = [turned_in_air(place) - turned_in_air(place - 10.0**-k) for k in (6, 8)]
        assert steps[0] / steps[1] == pytest.approx(100.0 ** (1.0 / 3.0), rel=0.01)


def test_three_numbers_tell_the_second_hop_where_the_slip_goes_on():
    through = [(turned, told) for case, turned, told in second_sample() if case == "slides"]
    assert len(through) > 100
    for turned, told in through:
        assert turned == pytest.approx(told, rel=1e-9)


def test_more_than_three_numbers_tell_it_where_the_slip_ends():
    ends = [
        abs(turned / told - 1.0)
        for case, turned, told in second_sample()
        if case == "sticks_in_compression"
    ]
    assert sorted(ends)[len(ends) // 2] > 1e-3
