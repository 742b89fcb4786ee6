import itertools
import math
from dataclasses import replace

import numpy as np
import pytest
from mpmath import iv, mp

from evidence.studies.hoops import DEGREE, random_hoops, thin_hoop
from evidence.studies.slip_before_jump import (
    FRICTIONS,
    LIKE_FILMS,
    Body,
    beside,
    best_turn,
    climb,
    climbs,
    hoops,
    jump,
    logarithmic_slope,
    on,
    slope_of,
)


def bodies(seed, count):
    random = np.random.default_rng(seed)
    for _ in range(count):
        h = random.uniform(0.05, 0.95)
        yield Body(h, (1.0 - h * h) * random.uniform(0.05, 1.0)), random.uniform(0.05, 1.4)


def test_the_forces_are_those_of_the_program():
    for hoop, random in random_hoops(3, 200):
        slope = random.uniform(-1.3, 1.3)
        theta, rate = random.uniform(-3.0, 3.0), random.uniform(-2.0, 2.0)
        plane = on(hoop, slope, 1.0).phase_plane
        normal, friction = Body.of(hoop).forces(theta, rate * rate, slope)
        size = 1e-12 * hoop.mass * (2.0 + rate * rate)
        assert float(plane.normal(theta, rate)) == pytest.approx(
            hoop.mass * float(normal), abs=size
        )
        assert float(plane.friction(theta, rate)) == pytest.approx(
            hoop.mass * float(friction), abs=size
        )


def test_both_forces_vanish_in_one_state_and_have_the_ratio_of_the_page():
    for body, slope in bodies(1, 300):
        normal, friction = body.forces(-slope, 1.0 / body.h, slope)
        assert abs(float(normal)) + abs(float(friction)) < 1e-14
        # Nowhere else: both are linear in u; where N = 0, F = 0 only there.
        theta = np.linspace(-math.pi, math.pi, 2001)
        (n0, f0), (n1, f1) = body.forces(theta, 0.0, slope), body.forces(theta, 1.0, slope)
        with np.errstate(all="ignore"):
            u = -n0 / (n1 - n0)
        left = np.abs(f0 + (f1 - f0) * u)
        far = np.abs(theta + slope) > 0.05
        assert np.all(left[far & (u > 0.0)] > 1e-4 * math.sin(slope))
        # Before it, on its orbit.
        before = -1e-6
        level = body.level(slope) - float(body.potential(before, slope))
        u = 2.0 * level / float(body.denominator(before - slope))
        normal, friction = body.forces(before - slope, u, slope)
        assert float(normal) > 0.0
        assert abs(float(friction)) / float(normal) == pytest.approx(
            body.least_friction(slope), rel=1e-3, abs=1e-4
        )


def test_with_less_friction_it_slips_and_with_more_it_does_not():
    hoop = hoops()[LIKE_FILMS]
    for degrees in (15.0, 30.0, 45.0):
        slope = degrees * DEGREE
        body = Body.of(hoop)
        (release,) = body.releases(slope)
        critical = body.least_friction(slope)
        found = jump(on(hoop, slope, 1.0), release)
        assert found is not None
        assert found.slides <= 1
        assert found.slip < 1e-12
        # From a place next to the end, so that friction holds before.
        psi = -0.2
        rate = math.sqrt(
            2.0
            * (body.level(slope) - float(body.potential(psi, slope)))
            / float(body.denominator(psi - slope))
        )
        found = jump(on(hoop, slope, 0.9 * critical), psi, rate)
        assert found is not None
        assert found.slip > 1e-9
        found = jump(on(hoop, slope, 1.02 * critical), psi, rate)
        assert found is not None
        assert found.slip < 1e-12


def test_on_a_level_plane_friction_gives_way_before_the_state():
    # F is of first order, N of second.
    for body, _ in bodies(2, 100):
        level = 0.5 * float(body.denominator(0.0)) / body.h + body.h
        demands = []
        for psi in (-1e-2, -1e-3):
            u = 2.0 * (level - body.h * math.cos(psi)) / float(body.denominator(psi))
            normal, friction = body.forces(psi, u, 0.0)
            demands.append(abs(float(friction) / float(normal)))
        assert demands[1] / demands[0] == pytest.approx(10.0, rel=0.05)


def test_the_slip_is_the_cube():
    for name, mu in ((LIKE_FILMS, 1.0), ("loaded disc", 0.6), ("rim hoop, h = 0.5", 0.6)):
        for degrees in (30.0, 40.0):
            hoop = on(hoops()[name], degrees * DEGREE, mu)
            for delta in (-1e-3, 1e-3):
                law = Body.of(hoop).slip_law(hoop.slope, mu, delta)
                nearer = Body.of(hoop).slip_law(hoop.slope, mu, 0.1 * delta)
                assert nearer == pytest.approx(1e-3 * law, rel=1e-9)
                assert beside(hoop, 10.0 * delta) == pytest.approx(1e3 * law, rel=0.2)
                assert beside(hoop, delta) == pytest.approx(law, rel=0.02)


def test_beyond_painleves_friction_motions_below_the_orbit_fly_out_of_a_pressed_contact():
    hoop = hoops()["loaded disc"]
    slope = 30.0 * DEGREE
    body = Body.of(hoop)
    for factor, is_wedged in ((1.03, True), (0.97, False)):
        tilted = on(hoop, slope, factor * body.painleve(slope))
        psi, delta = -0.05, -1e-3
        kinetic = body.level(slope) - float(body.potential(psi, slope))
        rate = math.sqrt((2.0 * kinetic + delta) / float(body.denominator(psi - slope)))
        motion = tilted.simulate(theta=psi - slope, theta_rate=rate, max_transitions=3)
        modes = [phase.mode for phase in motion.phases]
        assert modes == (["rolling", "flight"] if is_wedged else ["rolling", "sliding", "flight"])
        end = motion.phases[0].end
        normal, friction = body.forces(end.theta, end.theta_rate**2, slope)
        assert abs(float(friction / normal)) == pytest.approx(tilted.mu_s, rel=1e-9)
        # Without forces the rim falls away from the plane, though rolling presses.
        assert float(normal) > 0.0
        assert (body.h * math.cos(end.theta) * end.theta_rate**2 > math.cos(slope)) == is_wedged


def test_the_height_of_a_climb_is_that_of_two_rests():
    for turn in np.linspace(0.3, 6.0, 40):
        sine = slope_of(float(turn))
        gamma = math.asin(sine)
        assert math.cos(gamma) - math.cos(gamma + turn) == pytest.approx(turn * sine, abs=1e-12)
        s, c = math.sin(turn), math.cos(turn)
        formula = turn * (1.0 - c) / math.hypot(1.0 - c, turn - s)
        assert climb(float(turn)) == pytest.approx(formula, rel=1e-12)


def test_there_is_one_highest_climb():
    assert climb(best_turn()) == pytest.approx(1.7342504, abs=1e-7)
    mp.prec = iv.prec = 80
    edges = [0.5 + 1.5 * i / 1500 for i in range(1501)]
    for low, high in itertools.pairwise(edges):
        y = iv.mpf([low, high])
        s2, double = iv.sin(y) ** 2, iv.sin(2 * y)
        below = y * y - y * double + s2
        # d/dy of 2 y sin² y/below
        above, rise = 2 * y * s2, 2 * s2 + 2 * y * double
        fall = 2 * y - double - 2 * y * iv.cos(2 * y) + double
        derivative = -1 / y**2 - 2 / s2 - (rise * below - above * fall) / below**2
        assert derivative < 0
    assert logarithmic_slope(0.5) > 0.0 > logarithmic_slope(2.0)
    # The formula of the derivative that was bounded.
    step = 1e-5
    for y in (0.7, 1.3, 1.9):
        slope = (math.log(climb(2.0 * (y + step))) - math.log(climb(2.0 * (y - step)))) / (
            2.0 * step
        )
        assert slope == pytest.approx(logarithmic_slope(y), rel=1e-7, abs=1e-8)


@pytest.mark.parametrize("mu", FRICTIONS)
def test_the_highest_climbs_are_without_slip(mu):
    best = max(climbs()[mu])
    assert best.height < climb(best_turn()) * best.h
    hoop = replace(thin_hoop(best.h, mu_k=mu), slope=best.slope)
    motion = hoop.simulate(theta=best.psi - best.slope, theta_rate=0.0)
    # Rest next to the saddle is a motion, too.
    if best.psi + math.asin(math.sin(best.slope) / best.h) > 2.0 * math.pi - 1e-9:
        motion = hoop.simulate(theta=best.psi - 1e-3 - best.slope, theta_rate=0.0)
    assert motion.outcome.kind == "rolls_forever"
    assert not motion.transitions
    reach = motion.outcome.details["theta_max"] - motion.outcome.details["theta_min"]
    assert reach * math.sin(best.slope) == pytest.approx(best.height, abs=2e-3)


def test_no_motion_from_rest_climbs_beyond_twice_h():
    for hoop, random in random_hoops(7, 150):
        slope = random.uniform(0.05, 1.0)
        tilted = on(hoop, slope, random.uniform(0.2, 2.0))
        motion = tilted.simulate(
            theta=random.uniform(-3.1, 3.1), theta_rate=0.0, max_transitions=20, until=20.0
        )
        x = np.array([0.0] + [one.state.x for one in motion.transitions])
        assert np.all(x * math.sin(slope) <= 2.0 * hoop.h + 1e-9)


def test_the_hypothesis_on_bounces_is_needed_and_the_program_says_so():
    # A rest with P > 0 at all angles from which bounces grow, so that motions leave rolling there.
    hoop = replace(thin_hoop(0.5, mu_k=1.0, restitution=0.9), slope=25.0 * DEGREE)
    assert Body.of(hoop).painleve(hoop.slope) > 1.0
    assert hoop.classify(theta=-1.4433, theta_rate=0.0).reverse_chatter == pytest.approx(
        1.0795, abs=1e-4
    )
    calm = replace(hoop, restitution=0.0)
    assert not calm.classify(theta=-1.4433, theta_rate=0.0).reverse_chatter
