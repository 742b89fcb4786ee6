import math

import numpy as np
import pytest

from evidence.studies.best_hop import (
    Body,
    build,
    farthest,
    flight,
    height,
    hops,
    jump_from_top,
    law,
    least_push,
    reach,
    rolled,
    thrown,
)
from evidence.studies.hoops import random_hoops
from evidence.studies.one_angle import before_top, jumps_of, rise, turned_at_top, turned_in_air


def test_the_body_of_two_numbers_has_them():
    random = np.random.default_rng(3)
    for _ in range(200):
        h = random.uniform(0.02, 0.98)
        body = Body(h, random.uniform(0.01, 1.0) * (1.0 - h * h))
        hoop = body.hoop(0.3)
        assert hoop.h == pytest.approx(h, rel=1e-12)
        assert hoop.inertia_about_mass_centre / hoop.mass == pytest.approx(body.gyration, rel=1e-9)
    thin = Body.thin(0.4).parameters
    assert (thin["mass_ratio"], thin["offset"], thin["inertia"]) == pytest.approx((1.5, 1.0, 1.5))


def test_no_lift_off_is_earlier_than_its_energy_allows_and_no_jump_higher_or_longer():
    found = 0
    for hoop, motion, place in jumps_of(31, 1200):
        phase = motion.phases[place]
        body = Body(hoop.h, hoop.inertia_about_mass_centre / hoop.mass)
        energy, angle = phase.energy_start / hoop.mass, before_top(phase.start.theta)
        limit = body.earliest(energy)
        assert energy >= body.least_energy * (1.0 - 1e-12)
        assert angle <= limit * (1.0 + 1e-9)
        assert energy >= body.lift_off_energy(angle) * (1.0 - 1e-12)
        if limit < 87.0 * math.pi / 180.0 and angle > 1e-3:
            found += 1
            assert height(hoop.h, angle) <= height(hoop.h, limit) * (1.0 + 1e-9)
            length = abs(phase.end.x - phase.start.x)
            assert length <= reach(body, energy, angle, turned_in_air(angle)) * (1.0 + 1e-9) + 1e-12
            if limit > 0.1:
                assert length <= farthest(body, energy)[0] * (1.0 + 1e-2)
    assert found > 80


def test_a_hoop_that_is_thrown_without_a_speed_of_its_mass_centre_attains_the_bound():
    random = np.random.default_rng(12)
    for _ in range(60):
        h, angle = random.uniform(0.1, 0.9), random.uniform(0.2, 1.4)
        body = Body(h, random.uniform(0.2, 1.0) * (1.0 - h * h))
        motion = thrown(body, angle, 0.0, 0.3)
        jump = flight(motion)
        assert motion.phases[0].energy_start / motion.hoop.mass == pytest.approx(
            body.lift_off_energy(angle), rel=1e-7
        )
        assert before_top(jump.start.theta) == pytest.approx(angle, rel=1e-6)
        energy = jump.energy_start / motion.hoop.mass
        assert body.earliest(energy) == pytest.approx(angle, rel=1e-5)
        times = np.linspace(0.0, jump.duration, 4001)
        theta, rate = jump.start.theta, jump.start.theta_rate
        gaps = (
            -h * math.sin(theta) * rate * times
            - times**2 / 2
            - h * (np.cos(theta + rate * times) - math.cos(theta))
        )
        assert np.max(gaps) == pytest.approx(height(h, angle), rel=1e-4)


def test_the_largest_gap_of_a_jump_is_the_largest():
    for degrees in (20.0, 60.0, 77.0, 80.0, 84.0, 86.0):
        angle = math.radians(degrees)
        gaps = [rise(angle, turned_in_air(angle) * i / 5000) for i in range(1, 5000)]
        assert max(gaps) <= rise(angle, turned_at_top(angle)) <= max(gaps) * (1.0 + 1e-5)


def test_the_height_and_the_turn_grow_with_the_angle_of_lift_off():
    angles, turned = law()
    heights = [rise(float(angle), turned_at_top(float(angle))) for angle in angles[::30]]
    assert np.all(np.diff(heights) > 0.0) and np.all(np.diff(turned) > 0.0)


def test_a_hoop_that_is_let_go_at_the_top_never_leaves_the_plane():
    for hoop, random in random_hoops(77, 250):
        motion = hoop.simulate(
            theta=random.choice([0.0, 1e-6, 1e-3]),
            theta_rate=1e-6,
            proof="contact",
            max_transitions=300,
        )
        assert "F" not in motion.sequence


def test_a_push_below_the_bound_makes_no_jump_and_rolled_hoops_need_more():
    for h, mu in ((0.2, 0.3), (0.5, 0.1), (0.5, 1.0), (0.8, 0.6)):
        bound, push = math.sqrt(0.5 * (1.0 - h) / h), least_push(h, mu)
        assert bound < push < 1.0 / math.sqrt(h)
        assert jump_from_top(h, mu, push * (1.0 + 1e-9)).sequence.endswith("F")
        for rate in np.linspace(0.2, 0.999, 7) * push:
            assert "F" not in jump_from_top(h, mu, float(rate)).sequence


def test_the_bound_of_the_push_is_the_energy_of_a_lift_off():
    for hoop, _ in random_hoops(5, 100):
        body = Body(hoop.h, hoop.inertia_about_mass_centre / hoop.mass)
        push = math.sqrt(body.gyration / (body.h * body.about_contact(0.0)))
        energy = 0.5 * body.about_contact(0.0) * push**2 + body.h
        assert energy == pytest.approx(body.least_energy, rel=1e-12)
        if abs(body.gyration - 1.0 + body.h**2) < 1e-12:
            assert push == pytest.approx(math.sqrt(0.5 * (1.0 - body.h) / body.h), rel=1e-9)


def test_rolled_hoops_stay_below_the_bound():
    offsets = np.linspace(0.1, 0.95, 18)
    for energy in (1.5, 3.0, 8.0):
        for mu in (0.05, 0.5, 1.5):
            heights = rolled(Body.thin(offsets), energy, mu)
            for h, top in zip(offsets, heights, strict=True):
                if not math.isnan(top):
                    assert top <= height(float(h), Body.thin(float(h)).earliest(energy)) * (
                        1.0 + 1e-9
                    )


def test_hops_are_flights_above_a_gap():
    hoop = build(0.066, 0.4, 0.0)
    assert hops(hoop, 0.5, 0.01) == 0
    motion = hoop.simulate(theta=math.pi, theta_rate=-3.0, until=40.0, max_transitions=400)
    assert hops(hoop, 3.0, 0.0, 100) == sum(
        phase.mode == "flight" and phase.end is not None for phase in motion.phases
    )


def test_the_second_hop_of_the_published_build_needs_no_restitution():
    speed = 3.08 / math.sqrt(9.80665 * 0.14)
    assert [hops(build(weight, 0.4, 0.0), speed, 0.005 / 0.14) for weight in (0.051, 0.066)] == [
        1,
        2,
    ]
