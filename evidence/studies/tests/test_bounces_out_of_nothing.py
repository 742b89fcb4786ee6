import itertools
import math
from dataclasses import replace
from fractions import Fraction

import littlewood as lw
import numpy as np
import pytest

from evidence.studies.bounces_out_of_nothing import (
    ANGLES,
    BODIES,
    EXAMPLE,
    SEEN,
    Contact,
    equilibrium_range,
    example,
    hoop_on,
    least_slope,
    out_of,
    saddle,
    state_seen,
    survey,
)
from evidence.studies.hoops import thin_hoop


def contacts(seed, count):
    random = np.random.default_rng(seed)
    for _ in range(count):
        h = random.uniform(0.05, 0.97)
        kappa = (1.0 - h * h) * 10.0 ** random.uniform(-2.0, 0.0)
        contact = Contact(h, kappa, np.array([random.uniform(0.05, 3.1)]), random.uniform(0.1, 3.0))
        yield (
            contact,
            random.uniform(0.1, 0.99),
            str(random.choice(["energetic", "poisson"])),
            random,
        )


def test_the_program_has_the_ratios_of_the_page():
    found = survey()
    assert found["wrong"] == 0
    assert found["grows"] > 300
    assert found["above e"] > 3000


def test_the_identities_of_the_proofs_are_exact():
    # κ, arm h s, lever 1 + h c, μ, |a|, w
    for kappa, arm, lever, mu, a, w in (
        (
            Fraction(2, 7),
            Fraction(3, 5),
            Fraction(9, 8),
            Fraction(4, 3),
            Fraction(5, 9),
            Fraction(6, 7),
        ),
        (
            Fraction(1, 9),
            Fraction(5, 8),
            Fraction(2, 3),
            Fraction(7, 4),
            Fraction(1, 5),
            Fraction(9, 10),
        ),
    ):
        big_a, big_b, big_c = 1 + lever**2 / kappa, arm * lever / kappa, 1 + arm**2 / kappa
        b, braking = big_b / big_a, mu * big_a - big_b
        k1, k2 = big_c - mu * big_b, big_c - b * big_b
        assert k2 - k1 == b * braking
        assert b == arm * lever / (kappa + lever**2)
        normal = (w + b * a) / k2
        friction = (big_b * normal + a) / big_a
        # Newton and Euler: neither slip nor gap accelerates.
        assert a - big_a * friction + big_b * normal == 0
        assert -w - big_b * friction + big_c * normal == 0
        # μ N − |F| has the sign of w M − |a| k1.
        assert (mu * normal - friction) * big_a * k2 == w * braking - a * k1


def test_no_law_exceeds_the_bound_and_the_interval_is_where_the_ratio_exceeds_1():
    inside = 0
    for contact, e, law, random in contacts(1, 4000):
        rho = np.exp(random.uniform(-4.0, 3.0, 40))
        ratio = contact.ratio(rho, e, law)
        bound = e * (1.0 + 2.0 * contact.stick * rho)
        assert np.all(ratio <= bound * (1.0 + 1e-9))
        (low,), (high,) = contact.range(e, law)
        clear = np.abs(ratio - 1.0) > 1e-9
        assert np.array_equal((ratio > 1.0)[clear], ((rho > low) & (rho < high))[clear])
        inside += int(np.count_nonzero(ratio > 1.0))
    assert inside > 5000


def test_much_friction_attains_the_bound():
    contact = Contact(0.6, 0.3, np.array([1.4]), 1e9)
    for law in ("energetic", "poisson"):
        low, _ = contact.range(0.7, law)
        assert float(low[0]) == pytest.approx(
            (1.0 / 0.7 - 1.0) / (2.0 * float(contact.stick[0])), rel=1e-6
        )


@pytest.mark.parametrize("name", BODIES)
@pytest.mark.parametrize("e", [0.8, 0.9])
def test_the_program_finds_the_least_slopes(name, e):
    h, kappa = BODIES[name]
    slope, angle = least_slope(h, kappa, 1.0, e)
    mass = 1.5 if name == "loaded disc" else 1.0 / h
    hoop = lw.Hoop(
        mass_ratio=mass - 1.0,
        offset=h * mass,
        inertia=0.25 if name == "loaded disc" else mass - 1.0,
        mu_s=1.0,
        mu_k=1.0,
    )
    assert hoop.inertia_about_mass_centre / hoop.mass == pytest.approx(kappa, rel=1e-12)
    above, below = (
        hoop_on(factor * slope, hoop, e, "energetic").phase_plane for factor in (1.0001, 0.9999)
    )
    assert above.reverse_chatter(-angle, 0.0) > 1.0
    assert np.all(np.isnan(below.reverse_chatter(-ANGLES, 0.0)))


def test_in_an_equilibrium_the_weight_has_no_moment():
    for h, slope in ((0.5, 0.4), (0.8, 0.6)):
        turned = math.asin(math.sin(slope) / h)
        for theta in (-turned - slope, math.pi + turned - slope):
            assert -h * math.sin(theta) == pytest.approx(
                (1.0 + h * math.cos(theta)) * math.tan(slope), rel=1e-12
            )


def test_a_loaded_disc_leaves_its_stable_equilibrium():
    h, kappa = BODIES["loaded disc"]
    disc = lw.Hoop(mass_ratio=0.5, offset=0.8, inertia=0.25, mu_s=1.0, mu_k=1.0)
    low, high = equilibrium_range(h, kappa, 1.0, 0.9, stable=True)
    for slope, grows in ((low - 0.01, False), (0.5 * (low + high), True)):
        hoop = hoop_on(slope, disc, 0.9, "energetic")
        (rest,) = (one for one in hoop.phase_plane.equilibria if one.stability == "stable")
        found = hoop.classify(theta=rest.theta, theta_rate=0.0)
        assert (found.reverse_chatter is not None) == grows
        motion = hoop.simulate(
            theta=rest.theta, theta_rate=0.0, gap_rate=1e-9, max_transitions=1000
        )
        rates = [one.impact.after.gap_rate for one in motion.transitions if one.impact is not None]
        if grows:
            # It never comes back: it bounces down the slope.
            assert max(rates) > 10.0
            assert motion.transitions[-1].state.x < -100.0
        else:
            assert max(rates) < 1e-9
            assert motion.outcome.kind == "rolls_forever"


def test_motions_out_of_nothing_have_a_limit_and_are_a_circle():
    # Thrown n bounces earlier, with Λ^-n of the rate, the motion at a given size changes by Λ^-n.
    ratio = example().classify(theta=saddle(), theta_rate=0.0).reverse_chatter
    for share in (0.0, 0.4, 0.8):
        states = [np.array(state_seen(share, n)) for n in (10, 20, 30, 50)]
        changes = [float(np.abs(state - states[-1]).max()) for state in states[:-1]]
        assert changes[0] < 1e-3
        for before, after in itertools.pairwise(changes):
            assert after / before == pytest.approx(ratio**-10, rel=0.2)
    sizes = [state_seen(share, 50)[2] for share in (0.0, 0.4, 0.8)]
    assert np.ptp(sizes) > 0.1 * SEEN
    # A whole turn of the circle comes back to the same motion.
    assert state_seen(1.0, 51) == pytest.approx(state_seen(0.0, 50), abs=1e-9)


def test_the_rate_grows_as_the_time():
    hoop = example()
    ratio = hoop.classify(theta=saddle(), theta_rate=0.0).reverse_chatter
    times, rates = out_of(hoop, saddle(), 0.0, 1e-9, 60)
    here = (rates > 1e-7) & (rates < 1e-5)
    assert np.all(
        np.abs(rates[here] / times[here] / (0.5 * math.cos(hoop.slope) * (ratio - 1.0)) - 1.0)
        < 0.02
    )


def test_without_a_slope_or_by_newtons_law_there_is_none():
    theta, rate = np.meshgrid(np.linspace(-3.1, 3.1, 60), np.linspace(-1.5, 1.5, 31))
    hoop = thin_hoop(EXAMPLE["h"], mu_k=EXAMPLE["mu"])
    for other in (
        hoop_on(0.0, hoop, 1.0, "poisson"),
        hoop_on(0.6, hoop, 0.8, "newton"),
        replace(hoop, slope=0.6),
    ):
        assert np.all(np.isnan(other.phase_plane.reverse_chatter(theta, rate)))
