import math
from dataclasses import replace

import numpy as np
import pytest

from evidence.studies.band import area, fates, last_angle, thickness, upper
from evidence.studies.contact import Contact
from evidence.studies.hoops import random_hoops
from evidence.studies.one_angle import jumps_of


def inside(seed, count):
    """Yield random hoops with a start in the band."""
    for hoop, random in random_hoops(seed, count):
        kappa = hoop.inertia_about_mass_centre / hoop.mass
        end = last_angle(hoop.h, kappa)
        theta = random.uniform(-0.99, 0.99) * end
        low, high = max(math.cos(theta), 0.0), upper(hoop.h, kappa, theta)
        inverse = low + random.uniform(0.05, 0.95) * (high - low)
        if high - low > 1e-6:
            yield hoop, random, theta, random.choice([-1.0, 1.0]) / math.sqrt(hoop.h * inverse)


def test_in_the_band_rolling_would_need_a_negative_normal_force_and_the_plane_holds_the_rim():
    for hoop, _, theta, rate in inside(1, 500):
        contact = Contact.of(hoop)
        assert contact.rolling(theta, rate**2)[0] < 0.0
        assert contact.pressure(theta, rate**2) > 0.0
        kappa = hoop.inertia_about_mass_centre / hoop.mass
        # Just outside of it one of both fails.
        border = 1.0 / (hoop.h * upper(hoop.h, kappa, theta))
        assert contact.rolling(theta, border * (1.0 - 1e-6))[0] > 0.0


def test_every_start_in_the_band_slides_against_the_sine_for_every_friction():
    for drawn, random, theta, rate in inside(2, 500):
        mu = 10.0 ** random.uniform(-3.0, 2.0)
        hoop = replace(drawn, mu_s=1.5 * mu, mu_k=mu)
        phase = hoop.simulate(theta=theta, theta_rate=rate, max_transitions=1, proof="none").phases[
            0
        ]
        assert (phase.mode, phase.direction) == ("sliding", -math.copysign(1.0, math.sin(theta)))


def test_the_band_ends_where_a_quadratic_equation_says_and_vanishes_with_the_offset():
    for hoop, _ in random_hoops(3, 200):
        h, kappa = hoop.h, hoop.inertia_about_mass_centre / hoop.mass
        c = math.cos(last_angle(h, kappa))
        assert h * c * c + (1.0 + h * h + kappa) * c + h == pytest.approx(
            0.0, abs=1e-12 * (1.0 + kappa)
        )
        assert thickness(h, kappa, 0.0) == 0.0
        assert thickness(h, kappa, 1.0) > 0.0
        # Linear in a small offset, where it is h sin²θ/(1 + κ).
        assert thickness(1e-6, kappa, 1.0) == pytest.approx(
            1e-6 * math.sin(1.0) ** 2 / (1.0 + kappa), rel=1e-4
        )


def test_the_area_is_that_of_a_sum_over_a_fine_grid():
    for h, kappa in ((0.3, 0.5), (0.8, 0.01)):
        angles = (np.arange(200_000) + 0.5) / 200_000 * math.pi
        tops = np.cos(angles) + h * np.sin(angles) ** 2 * (1 + h * np.cos(angles)) / (
            kappa + (1 + h * np.cos(angles)) ** 2
        )
        heights = np.maximum(tops - np.maximum(np.cos(angles), 0.0), 0.0)
        assert area(h, kappa) == pytest.approx(
            2.0 * float(heights.sum()) * math.pi / 200_000, rel=1e-6
        )


def test_nothing_leaves_the_plane_at_once_from_the_band():
    _, names, outcome = fates(0.5, 0.3)
    assert not any(name.startswith("F") for name in names)
    assert set(outcome) == {"landing"}


def test_a_falling_hoop_does_not_lift_off():
    lifted = 0
    for _, motion, place in jumps_of(5, 600):
        start = motion.phases[place].start
        lifted += 1
        assert math.sin(start.theta) * start.theta_rate < 0.0
    assert lifted > 50
    for h in (0.5, 0.9):
        rises, names, _ = fates(h, 0.3)
        assert set(np.isin(names[~rises], ("+F", "-F"))) == {False}


def test_a_falling_hoop_falls_faster_in_its_first_slide():
    falls = 0
    for hoop, _, theta, rate in inside(9, 400):
        slide = hoop.simulate(
            theta=abs(theta), theta_rate=abs(rate), max_transitions=1, proof="none"
        )
        seen = slide(np.linspace(0.0, slide.phases[0].end_time * (1.0 - 1e-9), 60))
        rates = np.asarray(seen.theta_rate)[np.asarray(seen.theta) < math.pi]
        assert np.all(np.diff(rates) > -1e-12 * rates[0])
        falls += len(rates) > 10
    assert falls > 100
