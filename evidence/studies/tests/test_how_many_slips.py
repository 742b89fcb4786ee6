import math
from dataclasses import replace

import littlewood as lw
import numpy as np
import pytest

from evidence.studies.contact import Contact
from evidence.studies.grazing import Margin, grazing_orbits
from evidence.studies.hoops import random_hoops, thin_hoop
from evidence.studies.how_many_slips import bottom_rate, counted, last_slips, scaled
from evidence.studies.roots import zero


def test_the_top_is_where_a_rolling_hoop_comes_nearest_to_leaving_the_plane():
    for drawn, random in random_hoops(4, 300):
        contact = Contact.of(drawn)
        top = contact.energy(0.0, 1.0 / contact.h)
        c = random.uniform(0.05, 1.0)
        assert contact.energy(math.acos(c), 1.0 / (contact.h * c)) >= top * (1.0 - 1e-12)


def test_the_margin_and_its_derivatives_are_those_of_the_forces():
    for drawn, random in random_hoops(5, 300):
        contact, mu = Contact.of(drawn), drawn.mu_s
        margin = Margin(contact, mu)
        theta, u = random.uniform(-math.pi, math.pi), random.exponential() / contact.h
        d = contact.denominator(theta)
        normal, friction = contact.rolling(theta, u)
        a, b = margin.terms(theta)
        assert a[0] - d * (1.0 + u) * b[0] == pytest.approx(
            (mu * normal - friction) * d**2,
            abs=1e-10 * d**2 * (contact.m + abs(normal) + abs(friction)),
        )
        step = 1e-4
        after, before = margin.terms(theta + step), margin.terms(theta - step)
        for one, high, low in zip((a, b), after, before, strict=True):
            size = max(map(abs, one)) + max(map(abs, high))
            assert (high[0] - low[0]) / (2.0 * step) == pytest.approx(one[1], abs=1e-6 * size)
            assert (high[1] - low[1]) / (2.0 * step) == pytest.approx(one[2], abs=1e-6 * size)


def orbits(seed, count):
    """Yield random hoops with equal coefficients that lead to an orbit which grazes the limit, with
    the orbit.
    """
    for drawn, random in random_hoops(seed, count):
        hoop = replace(drawn, mu_s=drawn.mu_k)
        contact = Contact.of(hoop)
        if not 0.05 < hoop.h < 0.9 or hoop.mu_k < 0.02:
            continue
        for orbit in grazing_orbits(contact, hoop.mu_k)[:1]:
            if orbit.energy > contact.m * contact.h:
                yield hoop, orbit, random


def test_a_slip_with_equal_coefficients_costs_c_times_the_square_of_the_distance():
    found = 0
    for hoop, orbit, _ in orbits(6, 400):
        ratios = []
        size = orbit.normal / orbit.rise
        for distance in (1e-3 * size, 1e-4 * size):
            rate = bottom_rate(hoop, orbit.energy + distance)
            motion = hoop.simulate(theta=math.pi, theta_rate=rate, max_transitions=2, proof="none")
            if [one.cause for one in motion.transitions] != ["slip", "stick"]:
                break
            slide = motion.phases[1]
            expected = orbit.loss(hoop.mu_k) * (slide.energy_start - orbit.energy) ** 2
            # The loss is the difference of two energies.
            if expected > 1e-12 * (1.0 + abs(orbit.energy)):
                ratios.append(slide.energy_lost / expected)
        if len(ratios) == 2 and abs(ratios[0] - 1.0) < 0.2:
            found += 1
            # What is neglected goes with the root of the distance, which is a third; it may change
            # its sign.
            assert abs(ratios[1] - 1.0) < max(0.6 * abs(ratios[0] - 1.0), 0.05)
    assert found > 20


def test_the_number_of_slips_follows_the_logarithm_of_three():
    found = 0
    random = np.random.default_rng(7)
    for _ in range(40):
        mass_ratio, mu_k = 1.0 / random.uniform(0.15, 0.7) - 1.0, random.uniform(0.2, 0.8)
        inertia = mass_ratio * random.uniform(0.3, 1.0)
        errors = []
        for ratio in (1e-2, 1e-3):
            gap = ratio * mu_k
            nearly = lw.Hoop(
                mass_ratio=mass_ratio,
                offset=1.0,
                inertia=inertia,
                mu_s=mu_k + gap,
                mu_k=mu_k,
            )
            touching = grazing_orbits(Contact.of(nearly), nearly.mu_s, nearly.mu_k)[:1]
            if not touching or touching[0].slips(nearly.mu_k) / gap > 6e4:
                break
            distance = 3.0 * gap * touching[0].normal / touching[0].rise
            try:
                number = counted(nearly, touching[0].energy + distance)
            except ValueError:
                break
            errors.append(number / touching[0].slips_from(nearly.mu_k, gap, distance) - 1.0)
        if len(errors) == 2 and abs(errors[0]) < 0.2:
            found += 1
            assert abs(errors[1]) < 0.05
            assert abs(errors[1]) < 0.6 * abs(errors[0]) + 2e-3
    assert found > 20


def test_no_slide_begins_with_less_than_a_slip_out_of_rolling():
    reversals = 0
    for hoop, random in random_hoops(31, 4000):
        m, h, inertia = hoop.mass, hoop.h, hoop.inertia_about_mass_centre
        theta, u = random.uniform(-math.pi, math.pi), 10.0 ** random.uniform(-2.0, 1.0)
        s, lever = math.sin(theta), 1.0 + h * math.cos(theta)
        a, b, c = (
            1.0 / m + lever**2 / inertia,
            h * s * lever / inertia,
            1.0 / m + (h * s) ** 2 / inertia,
        )
        w, d, gap = 1.0 - h * math.cos(theta) * u, a * c - b * b, hoop.mu_s - hoop.mu_k
        normal = (a * w - b * h * s * u) / d
        force = (h * s * u - b * normal) / a
        if w <= 0.0 or abs(force) <= hoop.mu_s * normal or gap == 0.0:
            continue
        sigma = -math.copysign(1.0, force)
        kinetic, static = (c - mu * sigma * b for mu in (hoop.mu_k, hoop.mu_s))
        if static <= 0.0:
            continue
        pressed = w / kinetic
        begins = sigma * ((b - a * hoop.mu_k * sigma) * pressed - h * s * u)
        reversals += 1
        assert begins >= gap * d * w / (kinetic * static) * (1.0 - 1e-9)
    assert reversals > 200


def test_the_loss_of_a_slip_in_scaled_variables():
    random = np.random.default_rng(51)
    found = 0
    for _ in range(40):
        mass_ratio, mu_k = 1.0 / random.uniform(0.15, 0.7) - 1.0, random.uniform(0.2, 0.8)
        inertia, x = mass_ratio * random.uniform(0.3, 1.0), random.uniform(0.1, 6.0)
        off = []
        for ratio in (1e-3, 1e-5):
            mu_s = mu_k * (1.0 + ratio)
            hoop = lw.Hoop(mass_ratio=mass_ratio, offset=1.0, inertia=inertia, mu_s=mu_s, mu_k=mu_k)
            if not grazing_orbits(Contact.of(hoop), mu_s, mu_k):
                break
            try:
                place, loss = scaled(hoop, x)
            except ValueError:
                break
            # ℓ(x) by the zero S of 1 + t0 s − s²/3 and the integral of s + t0 s² − s³/3.
            t0 = math.sqrt(place)
            end = max(np.roots([-1.0 / 3.0, t0, 1.0]).real)
            off.append(loss / (end**2 / 2.0 + t0 * end**3 / 3.0 - end**4 / 12.0) - 1.0)
        if len(off) == 2 and abs(off[0]) < 0.2:
            found += 1
            # What is neglected goes with the root of μs − μk, which is a tenth.
            assert abs(off[1]) < max(0.25 * abs(off[0]), 3e-3)
    assert found > 15


@pytest.mark.parametrize(("h", "mu"), [(0.5, 0.2), (0.3, 0.15), (0.75, 0.3), (0.5, 0.1296)])
def test_an_orbit_may_touch_the_limit_where_it_turns_back(h, mu):
    hoop = thin_hoop(h, mu_k=mu)
    contact = Contact.of(hoop)
    margin = Margin(contact, mu)

    def left(theta):
        a, b = margin.terms(theta)
        return a[0] - contact.denominator(theta) * b[0]

    theta = zero(left, math.pi, 1.5 * math.pi)
    (a, b), d = margin.terms(theta), contact.denominator(theta)
    push, slope = contact.m * contact.h * math.sin(theta), (a[1] - d * b[1]) / d**2
    energy, rise, fall = (
        contact.m * contact.h * math.cos(theta),
        b[0] / d**2 + slope / (2.0 * push),
        0.5 * slope * push / d,
    )
    normal, friction = contact.rolling(theta, 0.0)
    mobility = d / (contact.m * contact.solvability(theta, -math.copysign(mu, friction)))
    off = []
    for distance in (1e-3, 1e-4):
        motion = hoop.simulate(
            theta=math.pi,
            theta_rate=bottom_rate(hoop, energy + distance),
            max_transitions=4,
            proof="none",
        )
        slides = [one for one in motion.phases if one.mode == "sliding"]
        assert len(slides) == 2
        for slide in slides:
            c = 9.0 * mu * normal * rise**2 * mobility / fall
            off.append(slide.energy_lost / (c * (slide.energy_start - energy) ** 2) - 1.0)
    # At a turning point the next term is of the order of the distance.
    assert max(map(abs, off[:2])) < 0.01
    assert max(map(abs, off[2:])) < 0.15 * max(map(abs, off[:2]))


def test_next_to_the_top_slips_come_in_one_order_only():
    # At hθ′² = 1 and w → 0: a part of −+R−, and the flight.
    seen = set()
    for hoop, random in random_hoops(61, 3000):
        h, inertia, m = hoop.h, hoop.inertia_about_mass_centre, hoop.mass
        if not 0.05 < h < 0.9 or inertia < 0.25 * m * hoop.mu_k**2 * (1.0 + h) ** 2:
            continue
        near = 1e-3 * min(1.0, h)
        theta = -near * random.uniform(0.0, 1.0)
        slip = random.choice([0.0, 1.0, -1.0, -1.0]) * near**2 * random.uniform(0.0, 1.0)
        rate = math.sqrt((1.0 - near * random.uniform(0.0, 0.1)) / (h * math.cos(theta)))
        motion = hoop.simulate(
            theta=theta, theta_rate=rate, slip=slip, until=2.0 * near / rate, max_transitions=20
        )
        slides = {1: "+", -1: "-", 0: "R"}
        word = "".join(slides[one.direction] for one in motion.phases if one.mode != "flight")
        rest = iter("-+R-")
        assert all(letter in rest for letter in word), word
        seen.add(word)
    assert {"-+R-", "-+-", "+-", "R-"} <= seen, seen


def test_with_equal_coefficients_a_slip_may_be_the_last():
    found = last_slips(6, 20_000, 0.01)
    assert len(found) > 10
    for motion in found:
        before, slide, after = motion.phases
        assert (before.mode, slide.mode, after.mode) == ("rolling", "sliding", "rolling")
        contact = Contact.of(motion.hoop)
        margin = Margin(contact, motion.hoop.mu_k)
        mean = contact.inertia + contact.m * (1.0 + contact.h**2)
        least = []
        for energy in (slide.energy_start, slide.energy_start - slide.energy_lost):
            constant = 2.0 * energy + mean
            # The margins of both directions on the orbit, mirror images, over D².
            angles = np.linspace(-math.pi, math.pi, 4_001)
            on_orbit = [t for t in angles if contact.denominator(float(t)) <= constant]
            values = []
            for theta in on_orbit:
                a, b = margin.terms(float(theta))
                values.append((a[0] - constant * b[0]) / contact.denominator(float(theta)) ** 2)
            least.append(min(values))
        assert least[0] < 0.0 < least[1] + 1e-9
