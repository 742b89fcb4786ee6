import math

import littlewood as lw
import numpy as np
import pytest

from evidence.studies.massless_limit import (
    ARRIVAL,
    FAMILIES,
    SPEED,
    after,
    bottom,
    figure_7,
    friction_at_bottom,
    jams,
    light,
    log_factor,
    massless,
    starts,
)


@pytest.mark.parametrize("mu", [0.2, 0.5, 0.7])
@pytest.mark.parametrize("rate", [0.1, 0.4])
def test_the_angle_of_slip_moves_by_its_coefficient(mu, rate):
    b, k = 2.0 / (1.0 + mu * mu), 4.0 * (1.0 + rate * rate)
    for size in (1e-4, 1e-6):
        motion = light(size, "no mass, only inertia", mu, mu).simulate(
            theta=0.0, theta_rate=rate, max_transitions=1
        )
        angle = motion.transitions[0].state.theta
        assert (angle - 2.0 * math.atan(mu)) / size == pytest.approx(
            mu * k / (b * (4.0 * b - k)), rel=200.0 * size + 1e-7
        )


@pytest.mark.parametrize("rate", [0.1, 0.4])
def test_thin_hoops_slip_later_by_half_the_friction(rate):
    mu, (b, k) = 0.5, (1.6, 4.0 * (1.0 + rate * rate))
    hoop = light(1e-6, "thin hoop", mu, mu)
    angle = hoop.simulate(theta=0.0, theta_rate=rate, max_transitions=1).transitions[0].state.theta
    shift = (angle - 2.0 * math.atan(mu)) / hoop.inertia_about_mass_centre
    assert shift == pytest.approx(0.5 * mu + mu * k / (b * (4.0 * b - k)), rel=1e-4)


@pytest.mark.parametrize(
    ("mu", "rate", "time"), [(0.5, 0.5, 2.2), (0.3, 0.4, 2.3), (0.4, 0.6, 2.0)]
)
def test_equal_coefficients_have_the_factor_of_their_logarithm(mu, rate, time):
    ring = lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=mu, mu_k=mu)
    there = ring.simulate(theta=0.0, theta_rate=rate, until=time)(time).theta
    off = []
    for size in (1e-6, 1e-7):
        hoop = light(size, "no mass, only inertia", mu, mu)
        here = hoop.simulate(theta=0.0, theta_rate=rate, until=time, max_transitions=40)(time).theta
        off.append(float(here - there) / size)
    assert (off[1] - off[0]) / math.log(10.0) == pytest.approx(log_factor(mu, rate, time), rel=2e-3)


@pytest.mark.parametrize("family", FAMILIES)
@pytest.mark.parametrize("mu", [0.2, 0.4])
def test_friction_changes_the_passage_of_the_bottom_by_the_root_of_the_inertia(family, mu):
    hoop = light(1e-6, family, mu)
    root = math.sqrt(hoop.inertia_about_mass_centre)
    _, rate = bottom(hoop)
    assert (rate * root - SPEED) / root == pytest.approx(friction_at_bottom(family, mu), rel=1e-2)


@pytest.mark.parametrize("family", FAMILIES)
def test_rolling_and_gliding_are_off_by_the_first_order(family):
    off = []
    for size in (1e-4, 1e-5, 1e-6):
        hoop = light(size, family)
        here, there = figure_7(hoop)(2.5), massless()(2.5)
        off.append(
            [
                float(here[name] - there[name]) / size
                for name in ("theta", "theta_rate", "slip", "x")
            ]
        )
    assert np.allclose(off[1], off[2], rtol=1e-2)
    assert np.allclose(off[0], off[1], rtol=1e-1)


@pytest.mark.parametrize("family", FAMILIES)
def test_the_bottom_is_passed_late_and_fast(family):
    numbers = []
    for size in (1e-4, 1e-5, 1e-6):
        hoop = light(size, family)
        inertia = hoop.inertia_about_mass_centre
        time, rate = bottom(hoop)
        numbers.append((time - ARRIVAL) / inertia - math.log(1.0 / inertia) / (4.0 * SPEED))
        assert rate * math.sqrt(inertia) == pytest.approx(SPEED, abs=math.sqrt(inertia))
    assert numbers[1] == pytest.approx(numbers[2], abs=2e-3)


def test_the_particle_rebounds_with_its_speed():
    # Little friction takes little off: the height reached again is that of the speed of arrival,
    # v²/2.
    hoop = lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=1e-6, mu_s=0.5, mu_k=0.001)
    times = np.linspace(0.02, 0.1, 20)
    arrival, _ = bottom(hoop)
    height = 1.0 + np.cos(figure_7(hoop)(arrival + times).theta)
    assert height == pytest.approx(SPEED * times - 0.5 * times**2, abs=2e-3)


def test_a_light_hoop_jams_where_gliding_is_no_limit_and_the_flag_says_so():
    empty = 0
    for mu, theta, rate, slip in starts(8, 200):
        ring = lw.Hoop(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=mu, mu_k=mu)
        assert (
            not ring.simulate(theta=theta, theta_rate=rate, slip=slip)
            .phases[0]
            .is_small_inertia_limit
        )
        assert (
            ring.simulate(theta=-theta, theta_rate=-rate, slip=slip)
            .phases[0]
            .is_small_inertia_limit
        )
        thin = light(1e-7, "thin hoop", mu, mu, 0.0)
        jam = thin.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=1).transitions[
            0
        ]
        assert jam.cause == "jam"
        assert jam.after.theta_rate == pytest.approx(rate - 0.5 * slip, abs=1e-9)
        assert jam.impact.energy_lost == pytest.approx(
            0.5 * (slip * math.sin(0.5 * theta)) ** 2, abs=1e-5
        )
        assert jam.to_mode == after(theta, rate, slip)
        empty += 1
    assert empty == 200


def test_what_follows_is_told_by_the_limit():
    assert len(jams()) > 1500
    assert sum(expected != found for expected, found, _, _ in jams()) <= 2


@pytest.mark.parametrize("law", ["energetic", "poisson"])
@pytest.mark.parametrize("family", FAMILIES)
def test_a_jam_rebounds_with_a_limit(law, family):
    for mu, theta, rate, slip in starts(9, 50):
        base = light(1e-7, family, mu, mu, 0.6)
        hoop = lw.Hoop(
            mass_ratio=base.mass_ratio,
            offset=1.0,
            inertia=base.inertia,
            mu_s=mu,
            mu_k=mu,
            restitution=0.6,
            restitution_law=law,
        )
        impact = (
            hoop.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=1)
            .transitions[0]
            .impact
        )
        tangent = math.tan(0.5 * theta)
        assert impact.after.gap_rate == pytest.approx(0.6 * abs(slip * tangent), rel=1e-3, abs=1e-4)
        expected = rate - 0.5 * slip * (1.0 - 0.6 * tangent**2)
        assert impact.after.theta_rate == pytest.approx(expected, rel=1e-3, abs=1e-3)
