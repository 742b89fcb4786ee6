import math

import pytest

from evidence.studies.limit_system import LimitSystem, State
from evidence.studies.massless_limit import (
    ARRIVAL,
    SPEED,
    comparisons,
    drift_left,
    drifts,
    light,
    stopped_law,
)


def test_figure_7_comes_to_the_plane_as_the_paper_says_and_bounces():
    pieces = LimitSystem(0.5, 0.4).follow(State(0.0, 0.5, 0.0), 4.0)
    roll, right, left, rising = pieces
    assert (roll.ended_by, right.ended_by, left.ended_by) == ("slip", "stick", "bounce")
    assert roll.end == pytest.approx(math.log(5.0), rel=1e-12)
    assert left.end == pytest.approx(ARRIVAL, rel=1e-9)
    # b′ and V on both sides of the bounce: V = −1.2 is less than 2 μk v, and stops.
    before, after = left.at(left.end - left.begin - 1e-6), rising.at(1e-6)
    assert -math.sin(before.theta) * before.rate == pytest.approx(-SPEED, rel=1e-5)
    assert -math.sin(after.theta) * after.rate == pytest.approx(SPEED, rel=1e-5)
    assert before.slip - (1.0 + math.cos(before.theta)) * before.rate == pytest.approx(
        -1.2, rel=1e-9
    )
    assert after.slip == pytest.approx((1.0 + math.cos(after.theta)) * after.rate, rel=1e-9)


def test_slip_is_lost_in_the_set_and_at_its_border():
    system = LimitSystem(0.8, 0.6)
    inside = system.follow(State(0.5, -0.2, 0.6), 0.1)[0]
    assert inside.kind == "roll"
    assert inside.at(0.0).rate == pytest.approx(-0.5)
    first, second = system.follow(State(1.9, -1.5, 0.7), 0.9)
    at_border = first.at(first.end)
    assert first.ended_by == "set"
    assert math.tan(0.5 * at_border.theta) == pytest.approx(0.6, rel=1e-12)
    assert second.at(0.0).rate == pytest.approx(at_border.rate - 0.5 * at_border.slip, rel=1e-12)


def test_light_hoops_differ_from_the_limit_by_the_orders_of_the_theorem():
    found = comparisons(8, 200)  # those of the page, which are kept
    for power in (1.0, 0.5, 1.0 / 3.0):
        measured = sorted(one.measured for one in found if one.power == power)
        assert len(measured) > 15
        # Logarithms, and differences that vanish by chance, are in the tails.
        assert measured[len(measured) // 2] == pytest.approx(power, abs=0.03)
        assert measured[len(measured) // 6] > 0.8 * power
        assert measured[-len(measured) // 6] < 1.25 * power


@pytest.mark.parametrize("family", ["thin hoop", "no mass, only inertia"])
@pytest.mark.parametrize(("mu_s", "mu_k"), [(0.72, 0.6), (0.3, 0.25), (0.5, 0.5)])
def test_a_bounce_that_stops_the_slip_leaves_a_velocity_of_the_third_root(family, mu_s, mu_k):
    # By V at the end of rolling, b θ′ at δ³ = 2 μs Î, and the impulse after it.
    off = [
        drift_left(light(size, family, mu_k, mu_s)) / stopped_law(mu_s, mu_k) - 1.0
        for size in (1e-6, 1e-9)
    ]
    assert abs(off[1]) < 0.005
    assert abs(off[1]) < 0.5 * abs(off[0])


@pytest.mark.parametrize("theta", [0.3, -0.5])
@pytest.mark.parametrize("mu", [0.8, 1.5])
def test_a_light_hoop_that_loses_its_load_slips_against_the_sine(theta, mu):
    off = []
    for size in (1e-4, 1e-6):
        hoop = light(size, "no mass, only inertia", 0.9 * mu, mu)
        rate = math.copysign(0.95, theta)
        motion = hoop.simulate(theta=theta, theta_rate=rate, max_transitions=2)
        slip, slide = motion.transitions[0], motion.phases[1]
        assert slip.cause == "slip"
        assert slide.direction == -math.copysign(1.0, theta)
        # K − 4b is 4 μs Î/(μs b + |s|), of the first margin to vanish.
        b, s = 1.0 + math.cos(slip.state.theta), abs(math.sin(slip.state.theta))
        constant = (size + 2.0 * (1.0 + math.cos(theta))) * (1.0 + rate**2)
        off.append((constant - 4.0 * b) / size / (4.0 * mu / (mu * b + s)) - 1.0)
    assert abs(off[0]) < 0.05
    assert abs(off[1]) < 0.05 * abs(off[0]) + 1e-6


def test_a_bounce_without_drift_leaves_the_third_root_and_so_does_the_next():
    off = [
        [one - 1.0 for one in drifts(light(size, "no mass, only inertia", 0.6, 0.72), 2)]
        for size in (1e-5, 1e-8)
    ]
    for before, after in zip(*off, strict=True):
        assert abs(after) < 0.003
        # The error falls with the third root, too.
        assert abs(after) < 0.15 * abs(before)
