import math

import pytest

from evidence.studies.one_angle import before_top, jumps_of, second_sample, turned_at_top, turned_in_air


def test_every_hoop_that_slides_off_the_plane_turns_by_the_same_angle():
    found = 0
    for _, motion, place in jumps_of(11, 1500):
        flight = motion.phases[place]
        angle = before_top(flight.start.theta)
        if not 1e-3 < angle < 1.3:
            continue
        found += 1
        # The angle of lift-off is known to some units of its last digit, which the law does not amplify here.
        assert abs(flight.end.theta - flight.start.theta) == pytest.approx(turned_in_air(angle), rel=1e-11)
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


def test_three_numbers_tell_the_second_hop_where_the_slip_goes_on():
    through = [(turned, told) for case, turned, told in second_sample() if case == "slides"]
    assert len(through) > 100
    for turned, told in through:
        assert turned == pytest.approx(told, rel=1e-9)


def test_more_than_three_numbers_tell_it_where_the_slip_ends():
    ends = [abs(turned / told - 1.0) for case, turned, told in second_sample() if case == "sticks_in_compression"]
    assert sorted(ends)[len(ends) // 2] > 1e-3
