import math
from dataclasses import replace
from fractions import Fraction

import littlewood as lw
import numpy as np
import pytest

from evidence.studies.hoops import random_hoops, thin_hoop
from evidence.studies.jam import SPENT, Body, after_jam, rim_one, sample, shares, slip_left, zone


def bodies(count):
    random = np.random.default_rng(5)
    for _ in range(count):
        h = random.uniform(0.02, 0.98)
        yield Body(h, (1.0 - h * h) * 10.0 ** random.uniform(-4.0, 0.0))


def solvability(body, mu, theta):
    """P/m for a slip to the right."""
    s, c = math.sin(theta), math.cos(theta)
    return body.k2 + body.h * s * (body.h * s - mu * (1.0 + body.h * c))


def test_the_exponent_is_that_of_the_equation_of_slides():
    for body in bodies(200):
        mu = body.lower + 0.4 * (body.upper - body.lower)
        theta, step = body.angle(mu), 1e-5
        slope = (solvability(body, mu, theta + step) - solvability(body, mu, theta - step)) / (
            2.0 * step
        )
        s, c = math.sin(theta), math.cos(theta)
        assert solvability(body, mu, theta) == pytest.approx(0.0, abs=1e-12)
        assert body.exponent(c) == pytest.approx(2.0 * body.k2 * c / (s * slope), rel=1e-5)
        assert 0.0 < body.exponent(c) < 1.0


def test_between_painleves_threshold_and_the_lower_bound_the_exponent_is_above_one():
    for body in bodies(200):
        assert body.painleve < body.lower < body.upper
        mu = body.painleve + 0.7 * (body.lower - body.painleve)
        assert body.exponent(math.cos(body.angle(mu))) > 1.0


def test_the_cubics_have_one_positive_zero_and_factor_for_rim_hoops():
    # Exactly, in fractions: the two forms of each cubic, and the division by 1 + γ c.
    for h, k2, c in (
        (Fraction(1, 3), Fraction(2, 7), Fraction(3, 5)),
        (Fraction(5, 6), Fraction(1, 9), Fraction(-4, 7)),
    ):
        s2 = 1 - c * c
        j = h**2 * c**3 + h * (4 * k2 + h**2) * c**2 + (3 * k2 - h**2) * c - h * (k2 + h**2)
        assert j == k2 * (4 * h * c**2 + 3 * c - h) - h**2 * s2 * (c + h)
        g = h**2 * s2 * (c + h) - k2 * (c + h * (2 * c * c - 1))
        assert j == 2 * k2 * c * (1 + h * c) - g
        rim = 1 - h * h
        assert h**2 * c**3 + h * (4 * rim + h**2) * c**2 + (3 * rim - h**2) * c - h * (
            rim + h**2
        ) == (1 + h * c) * (h * c * c + 3 * rim * c - h)


@pytest.mark.parametrize("gamma", [0.2, 0.5, 0.75, 0.95])
def test_a_rim_hoop_has_closed_forms(gamma):
    body = Body.rim(gamma)
    assert body.painleve == pytest.approx(math.sqrt(1.0 - gamma**2) / gamma, rel=1e-12)
    assert body.upper == pytest.approx(1.0 / gamma, rel=1e-12)
    assert body.one == pytest.approx(rim_one(gamma), rel=1e-12)
    c = rim_one(gamma)
    s = math.sqrt(1.0 - c * c)
    assert body.lower == pytest.approx(
        4.0 * gamma * s * c / (4.0 * gamma * c * c + 3.0 * c - gamma), rel=1e-9
    )


def test_the_limits_of_rim_hoops():
    small, light = Body.rim(1e-3), Body.rim(1.0 - 1e-7)
    assert (small.upper - small.lower) / (small.upper - small.painleve) == pytest.approx(
        5.0 / 9.0, rel=1e-4
    )
    assert light.lower / light.painleve == pytest.approx(2.0 / math.sqrt(3.0), rel=1e-5)


def test_random_slides_end_as_expected():
    ends = {kind: 0 for kind in ("jam", "lift-off", "end of slip")}
    for trial, found in sample():
        assert found == trial.expected
        ends[found] += 1
        if found == "jam":
            assert trial.exponent < 1.0
    assert min(ends.values()) > 100


def test_no_slide_jams_outside_the_bounds():
    jams = 0
    for base, random in random_hoops(21, 1500):
        body = Body.of(base)
        if body.k2 < 1e-4 or body.upper > 50.0:
            continue
        inside = body.lower + (body.upper - body.lower) * random.uniform(0.3, 0.8)
        outside = random.choice(
            [body.painleve + 0.9 * (body.lower - body.painleve), 1.5 * body.upper]
        )
        for mu in (inside, outside):
            hoop = replace(base, mu_s=mu, mu_k=mu)
            start = body.angle(min(mu, 0.999 * body.upper)) + 10.0 ** random.uniform(-2.5, 0.0)
            motion = hoop.simulate(
                theta=start, theta_rate=-0.3 / math.sqrt(body.h), slip=10.0, max_transitions=0
            )
            ended = motion.outcome.kind == "singular"
            if mu == outside and ended:
                # Close to λ = 0 and λ = 1 the slip or the contact ends nearer to P = 0 than doubles
                # resolve.
                exponent = body.exponent(math.cos(motion.outcome.state.theta))
                assert -0.15 < exponent < 0.0 or 1.0 < exponent < 1.15
            jams += ended
    assert jams > 50


def test_a_jam_conserves_the_angular_momentum_about_the_contact_and_throws_the_hoop():
    seen = 0
    for trial, found in sample():
        if found == "jam":
            seen += 1
            motion = trial.hoop.simulate(
                theta=trial.theta, theta_rate=trial.rate, slip=trial.slip, max_transitions=3
            )
            jam, body = motion.transitions[0], Body.of(trial.hoop)
            rate, lost = after_jam(
                body, math.cos(jam.state.theta), jam.state.theta_rate, jam.state.slip
            )
            assert jam.cause == "jam"
            assert jam.to_mode == "flight"
            assert jam.after.slip == pytest.approx(0.0, abs=1e-9)
            assert jam.after.theta_rate == pytest.approx(rate, rel=1e-9)
            assert jam.impact.energy_lost == pytest.approx(trial.hoop.mass * lost, rel=1e-6)
    assert seen > 100


def test_comsols_hoop_jams_in_its_zone_only():
    body, hoop = Body.rim(0.75), thin_hoop(0.75, mu_k=1.0)
    # sin(θ + 45°) = 2√2/3
    theta = math.pi - math.asin(2.0 * math.sqrt(2.0) / 3.0) - 0.25 * math.pi
    assert body.angle(1.0) == pytest.approx(theta, rel=1e-12)
    width = zone(body, 1.0)
    for part in (0.1, 0.5, 0.98):
        assert (
            hoop.simulate(theta=theta + part * width, theta_rate=-1e-4, slip=5.0).outcome.kind
            == "singular"
        )
    for rate in (0.0, 0.01, 0.5, 1.0, 1.5):
        assert (
            hoop.simulate(theta=theta + 1.02 * width, theta_rate=-rate, slip=5.0).outcome.kind
            != "singular"
        )


def test_a_slip_that_still_lasts_next_to_p_0_need_not_jam():
    hoop, (theta, rate, slip) = SPENT
    motion = hoop.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=1)
    (end,) = motion.transitions
    assert (end.cause, end.to_mode) == ("stick", "rolling")
    assert slip_left(hoop, (theta, rate, slip), end.state.time) < -0.01
    # It slips where its distance from P = 0 is already 1e-9: the sign of the slip there would tell
    # a jam.
    last = motion(np.nextafter(end.state.time, 0.0) - 1e-9)
    assert float(last["slip"]) > 0.01
    assert 0.0 < float(last["theta"]) - Body.of(hoop).angle(hoop.mu_k) < 1e-8


def test_what_is_left_of_the_slip_tells_jams_from_ends_of_slip_next_to_p_0():
    # Slides from 0.1 beside P = 0, at λ = 0.02, where the slip ends or jams closer than doubles
    # resolve.
    seen = {"jam": 0, "end of slip": 0}
    for body in bodies(150):
        if body.k2 < 1e-3:
            continue
        mu = body.friction_of(0.02)
        theta = body.angle(mu) + 0.1
        base = lw.Hoop(
            mass_ratio=0.0, offset=body.h, inertia=body.k2, mu_s=mu, mu_k=mu, restitution=0.0
        )
        for slip in (0.5, 1.0, 2.0, 4.0, 8.0):
            start = (theta, -0.5 / math.sqrt(body.h), slip)
            motion = base.simulate(theta=theta, theta_rate=start[1], slip=slip, max_transitions=1)
            end = motion.transitions[0].state
            if abs(end.theta - body.angle(mu)) > 1e-9:
                continue
            found = "jam" if motion.transitions[0].cause == "jam" else "end of slip"
            seen[found] += 1
            assert (slip_left(base, start, end.time) > 0.0) == (found == "jam")
    assert min(seen.values()) > 20, seen


def test_the_slip_of_rim_hoops_that_begins_does_so_below_a_rate():
    # Exactly: m P η″/(…) ≥ 0 in its two forms, ψ in P and in the first integral.
    for gamma, mu, t, u in (
        (Fraction(1, 3), Fraction(2, 7), Fraction(3, 5), Fraction(4, 3)),
        (Fraction(9, 10), Fraction(7, 9), Fraction(1, 4), Fraction(1, 5)),
        (Fraction(5, 8), Fraction(3, 2), Fraction(-2, 9), Fraction(2, 3)),
    ):
        s, c = 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)
        k2, q = 1 - gamma**2, gamma * s - mu * (1 + gamma * c)
        x, w, p = (1 + gamma * c) * q, 1 - gamma * c * u, k2 + gamma * s * q
        psi = gamma * (c + mu * s)
        assert p == (1 + gamma * c) * (1 - psi)
        assert (x - mu * k2) * w - gamma * s * u * p == x - mu * k2 - u * (x + mu * k2)


def test_a_slide_that_begins_without_slip_has_at_most_half_of_one_plus_g_of_the_rate_a_jam_needs():
    found = shares(11, 300)
    assert len(found) > 200
    assert all(part < bound < 1.0 for part, bound in found)
    # The bound is approached: by light hoops and little friction.
    assert max(part for part, _ in found) > 0.95


def test_slides_of_rim_hoops_that_begin_behind_the_bottom_jam_only_with_slip_to_begin_with():
    random = np.random.default_rng(12)
    jams = 0
    for _ in range(150):
        body = Body.rim(random.uniform(0.8, 0.99))
        mu = body.lower + (body.upper - body.lower) * random.uniform(0.1, 0.9)
        hoop = thin_hoop(body.h, mu_k=mu)
        theta = random.uniform(math.pi, 2.0 * math.pi)
        cosine = body.h * math.cos(theta)
        rate = -random.uniform(0.1, 1.0) * math.sqrt(
            min(1.0 / cosine if cosine > 0.0 else 9.0, 9.0)
        )
        ends = [
            hoop.simulate(theta=theta, theta_rate=rate, slip=slip, max_transitions=0).outcome.kind
            for slip in (1e-12, 30.0)
        ]
        assert ends[0] != "singular"
        jams += ends[1] == "singular"
    assert jams > 20


def test_the_energy_of_the_vertical_motion_changes_by_friction_alone():
    # Exactly: θ″ = q w m/P and N = m k² w m/P give dW/dθ = −μ (1 + h c) N/m.
    for h, k2, mu, t, u in (
        (Fraction(1, 3), Fraction(1, 5), Fraction(2, 7), Fraction(3, 5), Fraction(4, 3)),
        (Fraction(9, 10), Fraction(1, 8), Fraction(7, 9), Fraction(-5, 4), Fraction(1, 5)),
    ):
        s, c = 2 * t / (1 + t * t), (1 - t * t) / (1 + t * t)
        q = h * s - mu * (1 + h * c)
        w, p = 1 - h * c * u, k2 + h * s * q
        change = (k2 + h**2 * s**2) * q * w / p + h**2 * s * c * u - h * s
        assert change == -mu * (1 + h * c) * k2 * w / p
