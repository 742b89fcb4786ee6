import itertools
import math
from dataclasses import replace
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx

from evidence.studies.bouncing_for_ever import (
    ENDS,
    Orbit,
    differences,
    drift,
    expected_turns,
    family,
    orbit,
    product,
    random_orbits,
    rocked,
    rocking,
    smooth_rocking,
    stable,
    thin,
)
from evidence.studies.hoops import thin_hoop


def exact_orbits(rough, count=40):
    """Orbits in fractions.

    Every identity between rational functions must hold to the last digit.
    """
    random = np.random.default_rng(5)
    for _ in range(count):
        a, c, rate, v = (
            Fraction(int(random.integers(1, 60)), int(random.integers(1, 60))) for _ in range(4)
        )
        sign = int(random.choice([-1, 1]))
        yield Orbit(a, 1 + sign * c, Fraction(int(random.integers(1, 50)), 50), rate, v, rough)


def energy_gradient(one):
    """Of E/m = I ω²/2 − h sin θ ω v + v²/2 + h cos θ by θ, ω and v at θ = −φ, I being D/m or Î/m +
    (h sin θ)².
    """
    a, c, w, v = one.arm, one.lever - 1, one.rate, one.gap_rate
    half_slope = a if one.rough else -a * c
    return [half_slope * w * w - c * w * v + a, one.inertia * w + a * v, a * w + v]


@pytest.mark.parametrize("rough", [True, False])
def test_the_products_of_the_multipliers_are_those_of_the_derivative(rough):
    for one in exact_orbits(rough):
        m = one.turn()
        determinant = sum(
            m[0][i]
            * (m[1][(i + 1) % 3] * m[2][(i + 2) % 3] - m[1][(i + 2) % 3] * m[2][(i + 1) % 3])
            for i in range(3)
        )
        trace = m[0][0] + m[1][1] + m[2][2]
        assert determinant == one.determinant
        # The third multiplier is 1.
        assert 2 - trace + determinant == one.product


@pytest.mark.parametrize("rough", [True, False])
def test_the_family_and_the_energy_are_vectors_of_the_multiplier_one(rough):
    for one in exact_orbits(rough):
        m = one.turn()
        along = [[-1], [one.tangent[0]], [one.tangent[1]]]
        assert product(m, along) == along
        gradient = [energy_gradient(one)]
        assert product(gradient, m) == gradient
        assert product(gradient, along) == [[one.energy_slope]]


def test_the_family_is_that_of_the_library_and_its_slopes_are_those_of_its_numbers():
    found = 0
    for hoop, one, angle in random_orbits(8, 300):
        library = hoop.bouncing_orbit(angle)
        assert library is not None
        found += 1
        assert one.rate == pytest.approx(library.top_rate, rel=1e-12)
        assert one.gap_rate == pytest.approx(library.gap_rate, rel=1e-9)
        assert one.friction == pytest.approx(library.friction, rel=1e-12)
        assert one.halves == pytest.approx((angle, math.pi - angle), rel=1e-9)
        step = 1e-5
        ahead, back = hoop.bouncing_orbit(angle + step), hoop.bouncing_orbit(angle - step)
        if ahead is not None and back is not None:
            slope = (ahead.top_rate - back.top_rate) / (2.0 * step)
            assert slope == pytest.approx(one.tangent[0], rel=1e-5, abs=1e-5 * one.rate)
    assert found > 100


def test_the_derivative_of_a_turn_is_that_of_simulated_motions():
    found = 0
    for hoop, one, angle in random_orbits(4, 120):
        exact = np.array(one.turn())
        if np.max(np.abs(exact)) > 1e3:
            continue
        found += 1
        assert np.array(differences(hoop, one, angle)) == pytest.approx(
            exact, abs=2e-6 * np.max(np.abs(exact))
        )
    assert found > 30


def test_the_derivative_of_a_turn_at_fifty_digits():
    ctx.dps = 60
    h, gyration, mu, step = arb("0.5"), arb("0.6"), arb("0.45"), arb("1e-20")

    def impact(theta, w, u, v):
        """Energetic impact with e = 1 whose slip ends in compression."""
        a, lever = h * theta.sin(), 1 + h * theta.cos()
        aa, b, c = 1 + lever * lever / gyration, a * lever / gyration, 1 + a * a / gyration
        side = 1 if u > 0 else -1
        k1, k2 = c - mu * side * b, c - b * b / aa
        p1 = abs(u) / (mu * aa - side * b) if u != 0 else arb(0)
        v1 = v + k1 * p1
        work = -(v + v1) * p1 / 2 + v1 * v1 / (2 * k2)
        p = p1 - v1 / k2 + (2 * work / k2).sqrt()
        j = -mu * side * p1 - b / aa * (p - p1)
        return w + (a * p + lever * j) / gyration, v + b * j + c * p

    def turn(theta, w, v, guesses):
        for guess in guesses:
            arm, height, time = h * theta.sin(), h * theta.cos(), arb(guess)
            for _ in range(9):
                gap = (v - arm * w) * time - time * time / 2 - h * (theta + w * time).cos() + height
                time = (time - gap / (v - arm * w - time + h * w * (theta + w * time).sin())).mid()
            end = theta + w * time
            opening = v - arm * w - time + h * w * end.sin()
            w, v = impact(end, w, w * (h * end.cos() - height), opening)
            theta, w, v = end.mid(), w.mid(), v.mid()
        return [theta, w, v]

    found = orbit(0.5, 0.6, 1.9)
    # The start is the orbit to the digits of a float: the derivative of the map is that there to as
    # many.
    start = [arb(-1.9), arb(found.rate), arb(found.gap_rate)]
    guesses = [3.8 / found.rate, 2.0 * (math.pi - 1.9) / found.second_rate]
    measured = np.empty((3, 3))
    for i in range(3):
        ahead, back = list(start), list(start)
        ahead[i] += step
        back[i] -= step
        pairs = zip(turn(*ahead, guesses), turn(*back, guesses), strict=True)
        measured[:, i] = [float(((x - y) / (2 * step)).mid()) for x, y in pairs]
    assert measured == pytest.approx(np.array(found.turn()), rel=1e-11, abs=1e-11)


def test_a_slip_that_kinetic_friction_does_not_stop_makes_a_jump_however_small_it_is():
    found = 0
    for hoop, one, angle in random_orbits(17, 150):
        # Holds what sticks, but not what slips.
        torn = replace(hoop, mu_s=one.friction + 0.2, mu_k=0.6 * one.friction)
        after = []
        for slip in (1e-7, -1e-7):
            motion = torn.simulate(
                theta=-angle,
                theta_rate=one.rate,
                gap_rate=one.gap_rate,
                slip=slip,
                max_transitions=1,
            )
            after.append(motion.transitions[0].impact)
        towards, against = after
        if towards.case != "slides":
            continue
        found += 1
        gyration = hoop.inertia_about_mass_centre / hoop.mass
        b = one.arm * one.lever / gyration
        impulse = 2.0 * one.gap_rate / (1.0 + one.arm**2 / gyration - torn.mu_k * b)
        slid = one.rate + impulse * (one.arm - torn.mu_k * one.lever) / gyration
        assert towards.after.theta_rate == pytest.approx(slid, rel=1e-5)
        assert against.after.theta_rate == pytest.approx(one.second_rate, rel=1e-5)
    assert found > 30


def test_an_unstable_motion_is_left_at_the_pace_of_its_multiplier():
    for h, angle in ((0.5, 1.2), (0.3, 1.4), (0.7, 2.0)):
        one = orbit(h, thin(h), angle)
        largest = max(one.multipliers, key=abs)
        hoop = thin_hoop(h, mu_k=one.friction + 0.2, restitution=1.0)
        motion = hoop.simulate(
            theta=-angle, theta_rate=one.rate + 1e-8, gap_rate=one.gap_rate, max_transitions=12
        )
        undisturbed = hoop.simulate(
            theta=-angle, theta_rate=one.rate, gap_rate=one.gap_rate, max_transitions=12
        )
        turns = zip(motion.transitions[1::2], undisturbed.transitions[1::2], strict=False)
        off = [a.after.theta_rate - b.after.theta_rate for a, b in turns]
        # A part of the kick goes along the family, and stays as it is.
        grown = [y - x for x, y in itertools.pairwise(off)]
        paces = [y / x for x, y in itertools.pairwise(grown) if abs(y) < 1e-2]
        assert paces[2] == pytest.approx(largest.real, rel=2e-3)


def test_small_losses_drive_a_stable_motion_along_the_family():
    for h, (begin, side) in ENDS.items():
        law = expected_turns(h, begin, stable(h)[0][side])
        middle = 0.5 * (begin + stable(h)[0][side])
        off = [
            abs(
                drift(h, begin, loss, int(1.1 * law(middle) / loss) + 5).at(law(middle) / loss)
                - middle
            )
            for loss in (1e-4, 1e-5)
        ]
        assert off[1] < 1e-3 and off[1] < 0.2 * off[0] + 1e-4


def test_impacts_lose_what_the_formula_says_in_a_turn():
    found = 0
    for hoop, one, angle in random_orbits(23, 60):
        loss = 1e-6
        motion = replace(hoop, restitution=1.0 - loss).simulate(
            theta=-angle, theta_rate=one.rate, gap_rate=one.gap_rate, max_transitions=2
        )
        told = loss * float(one.decay) * hoop.mass
        if max(abs(value) for value in one.multipliers) < 50.0:
            found += 1
            assert motion.impact_energy_lost == pytest.approx(told, rel=1e-3)
    assert found > 10


def test_smooth_motions_are_those_of_a_simulation_without_friction():
    for h, angle in ((0.3, 1.84), (0.5, 2.2), (0.6, 0.5)):
        one = orbit(h, thin(h), angle, rough=False)
        hoop = thin_hoop(h, mu_k=0, restitution=1)
        assert np.array(differences(hoop, one, angle)) == pytest.approx(
            np.array(one.turn()), rel=1e-5, abs=1e-5
        )
        assert one.determinant == 1


def test_a_multiplier_is_one_where_the_energy_of_the_family_is_least():
    for h in (0.2, 0.3, 0.5):
        (low, high), *_ = stable(h)
        # At one end of the interval the energy has its minimum, at the other G is zero.
        angles = np.linspace(low - 0.1, high + 0.1, 2001)
        energies = family(h, thin(h), angles).energy
        least = angles[np.argmin(energies)]
        assert min(abs(least - low), abs(least - high)) < 2e-4


def lossless(hoop, theta, rate, gap_rate, impacts):
    """The places and rates after the impacts of a motion, none of which loses energy."""
    motion = hoop.simulate(theta=theta, theta_rate=rate, gap_rate=gap_rate, max_transitions=impacts)
    assert [one.cause for one in motion.transitions] == ["landing"] * impacts
    assert all(abs(one.impact.energy_lost) < 1e-12 for one in motion.transitions)
    assert all(
        one.impact.after.gap_rate == pytest.approx(gap_rate, rel=1e-9) for one in motion.transitions
    )
    return [(one.after.theta, one.impact.after.theta_rate) for one in motion.transitions]


def test_there_are_lossless_motions_that_do_not_turn():
    # The rate is from an independent derivation, by the equations of Newton and Euler.
    hoop = thin_hoop(0.5, mu_k=0.5, restitution=1.0)
    one = rocking(0.5, 0.75, 2.0)
    assert one.second_rate == pytest.approx(0.61391, abs=5e-6)
    far = 2.0 * math.pi - 2.0
    found = lossless(hoop, 2.0, one.second_rate, one.gap_rate, 4)
    assert found == [
        pytest.approx(after, rel=1e-9)
        for after in 2 * [(far, -one.second_rate), (2.0, one.second_rate)]
    ]
    # With a pause: κ v and v² = χ/κα.
    v = math.sqrt((math.pi - 2.0) / (one.kappa * one.alpha))
    found = lossless(hoop, 2.0, one.kappa * v, v, 4)
    pauses = [(far, 0.0), (far, -one.kappa * v), (2.0, 0.0), (2.0, one.kappa * v)]
    assert found == [pytest.approx(after, rel=1e-9, abs=1e-9) for after in pauses]
    # With two rates, where a² = ϱ + L²: (h cos φ)² + h cos φ + 1 − h² = 0 in a thin hoop.
    h = 0.9
    angle = math.acos((math.sqrt(4.0 * h * h - 3.0) - 1.0) / (2.0 * h))
    a, chi = h * math.sin(angle), math.pi - angle
    v = 2.5 * math.sqrt(a * chi)
    slow, fast = ((v + side * math.sqrt(v * v - 4.0 * a * chi)) / (2.0 * a) for side in (-1.0, 1.0))
    rough = thin_hoop(h, mu_k=1.5 * (1.0 + h * math.cos(angle)) / a, restitution=1.0)
    found = lossless(rough, angle, fast, v, 2)
    assert found == [
        pytest.approx(after, rel=1e-9) for after in ((2.0 * math.pi - angle, -slow), (angle, fast))
    ]


def test_rocking_is_unstable_with_friction_and_conserves_area_without():
    for h, angle in ((0.3, 1.0), (0.5, 2.0), (0.8, 2.6)):
        one = rocking(h, thin(h), angle)
        half = np.array(rocked(one))
        assert np.linalg.det(half) == pytest.approx(
            1.0 + one.kappa * one.lever * (math.pi - angle), rel=1e-12
        )
        assert np.linalg.det(
            np.array(rocked(rocking(h, thin(h), angle, rough=False)))
        ) == pytest.approx(1.0, rel=1e-12)
        hoop = thin_hoop(h, mu_k=one.friction + 0.2, restitution=1.0)
        start, columns = [angle, one.second_rate, one.gap_rate], []
        for i in range(3):
            ends = []
            for step in (1e-7, -1e-7):
                theta, rate, gap_rate = (x + step * (i == j) for j, x in enumerate(start))
                motion = hoop.simulate(
                    theta=theta, theta_rate=rate, gap_rate=gap_rate, max_transitions=1
                )
                after = motion.transitions[0]
                ends.append(
                    [
                        -after.after.theta,
                        -after.impact.after.theta_rate,
                        after.impact.after.gap_rate,
                    ]
                )
            columns.append([(x - y) / 2e-7 for x, y in zip(*ends, strict=True)])
        assert np.transpose(columns) == pytest.approx(half, abs=2e-6 * np.max(np.abs(half)))


def test_smooth_rocking_is_stable_where_its_multipliers_are_on_the_unit_circle():
    for h in (0.1, 0.5, 0.7):
        for end in smooth_rocking(h):
            sizes = []
            for angle in (end - 1e-3, end + 1e-3):
                sizes.append(
                    max(
                        abs(
                            np.linalg.eigvals(
                                np.array(rocked(rocking(h, thin(h), angle, rough=False)))
                            )
                        )
                    )
                )
            assert min(sizes) == pytest.approx(1.0, abs=1e-6) and max(sizes) > 1.01


def test_bands_that_are_narrower_than_the_grid_are_found():
    for h, inside, outside in ((0.9, 155.458, (155.45, 155.47)), (0.95, 162.35, (162.33, 162.38))):
        low, high = next(band for band in stable(h) if band[0] < math.radians(inside) < band[1])
        assert math.radians(outside[0]) < low and high < math.radians(outside[1])
        for degrees in (inside, *outside):
            # By the eigenvalues of the matrix: one is 1, and both others are smaller inside the
            # band only.
            sizes = np.sort(
                abs(np.linalg.eigvals(np.array(orbit(h, thin(h), math.radians(degrees)).turn())))
            )
            assert sizes[1] < 1.0 - 1e-4 if degrees == inside else sizes[2] > 1.0 + 1e-4
