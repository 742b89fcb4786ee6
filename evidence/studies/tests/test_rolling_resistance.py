import math
from dataclasses import replace

import numpy as np
import pytest

from evidence.studies.attacks import any_body, balances, choice
from evidence.studies.rolling_resistance import (
    JAM,
    JAM_START,
    SWINGING,
    DeadStop,
    Swings,
    body,
    downhill,
    random_swings,
)


def test_the_energy_without_the_vertical_motion_falls_in_the_band():
    # T0' = N (a θ' − χ |θ'| + F η'/N) in every mode, by the balances alone.
    random = np.random.default_rng(3)
    seen = set()
    for _ in range(400):
        drawn = any_body(random, chi=10.0 ** random.uniform(-2.0, 0.0))
        hoop, theta = drawn.hoop, random.uniform(-math.pi, math.pi)
        rate, slip = (float(random.normal() * random.choice([0.0, 1.0])) for _ in range(2))
        state = balances.State(0.0, theta, rate, slip, 0.0)
        for mode in choice.possible(hoop, state):
            if mode.name == "flight":
                continue
            x2, turn, normal, friction, _ = balances.solved(hoop, mode, state)
            arm, c = hoop.h * math.sin(theta), math.cos(theta)
            # The mass centre is at x − h sin θ along the plane, and x' = η' − θ'.
            speed = slip - (1.0 + hoop.h * c) * rate
            gain = x2 - hoop.h * c * turn + arm * rate**2
            change = hoop.i * rate * turn + hoop.m * speed * gain
            expected = normal * (arm * rate - hoop.chi * abs(rate)) + friction * slip
            size = 1.0 + abs(normal) * (1.0 + abs(rate)) + abs(hoop.m * speed * gain)
            assert change == pytest.approx(expected, abs=1e-9 * size)
            bound = (hoop.chi - abs(arm)) * abs(rate) + hoop.mu_k * abs(slip)
            assert expected <= -normal * bound + 1e-9 * size
            seen.add(mode.name)
    assert seen == {"rolling", "sliding", "skidding", "rest"}


def test_a_dead_stop_takes_all_of_the_energy():
    stop = DeadStop.of(JAM, *JAM_START)
    end = body(JAM, 1e8, 0.5).jam(*JAM_START)[:, -1]
    assert end[5:8] == pytest.approx([stop.normal, stop.friction, stop.couple], rel=4e-3)
    # An undamped contact stores the rest.
    end = body(JAM, 1e10, 0.0).jam(*JAM_START)[:, -1]
    assert 0.5 * 1e10 * end[0] ** 2 == pytest.approx(stop.contact, rel=1e-2)


def test_a_half_swing_takes_chi_off_the_law_up_to_its_cube():
    law, off = Swings.of(SWINGING), []
    for chi in (0.01, 0.005):
        motion = replace(SWINGING, rolling_resistance=chi).simulate(
            theta=math.pi - 1.5, theta_rate=0.0, max_transitions=1
        )
        end = abs(motion.transitions[0].state.theta - math.pi)
        off.append(law.number(1.5) - law.number(end) - chi)
    assert off[0] / off[1] == pytest.approx(8.0, rel=0.1)


def test_a_small_half_swing_loses_twice_chi_over_h():
    for mass_ratio, offset in ((0.1, 1.0), (2.0, 0.4)):
        hoop = replace(SWINGING, mass_ratio=mass_ratio, offset=offset)
        assert float(Swings.of(hoop).loss(np.array(1e-3))) == pytest.approx(2.0 / hoop.h, rel=1e-5)


def test_hoops_make_as_many_half_swings_as_the_law_says():
    for chi, law, seen in random_swings():
        assert -2.0 * chi < seen - law < 1.0 + 2.0 * chi


def test_a_rotation_downhill_rolls_slips_and_leaves_the_plane():
    law = Swings.of(SWINGING)
    slip = law.slope(law.grip(0.5))
    assert not downhill(0.5, 0.01, slip - 0.01)
    beyond = downhill(0.5, 0.01, slip + 0.005)
    assert beyond["slip"] == beyond["stick"] > 200
    assert not beyond["lift_off"]
    assert downhill(0.5, 0.01, slip + 0.02)["lift_off"]
    assert downhill(0.5, 0.01, law.slope(law.top()) - 0.01) == {"turning_point": 1, "rest": 1}


def test_far_above_the_bound_a_state_without_slip_has_no_motion():
    hoop = balances.Hoop(5.256407325e-4, 1.0, 5.256407325e-4, 0.0809887, 0.0354555, 0.4198477, 0.0)
    state = balances.State(0.0, 0.1197570, 0.7049970, 0.0, 0.0)
    assert not choice.possible(hoop, state)
    arm, lever = hoop.h * math.sin(state.theta), 1.0 + hoop.h * math.cos(state.theta)
    assert hoop.chi > arm + hoop.i / hoop.m / arm + hoop.mu_k * lever
    assert choice.possible(balances.Hoop(5.3e-4, 1.0, 5.3e-4, 0.081, 0.0355, 0.06, 0.0), state)
