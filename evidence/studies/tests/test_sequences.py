import csv
import math
from collections import Counter
from fractions import Fraction
from itertools import pairwise, product, zip_longest

import littlewood as lw
import numpy as np
import pytest

from evidence.studies.boundaries import boundaries, rate_of
from evidence.studies.contact import Contact
from evidence.studies.frictionless import degenerate_rates, quadratic
from evidence.studies.grazing import Margin
from evidence.studies.longest_turns import search
from evidence.studies.roots import zero
from evidence.studies.sequences import (
    CORNER,
    GAMMAS,
    LEAST,
    MOST,
    RIM,
    SCAN,
    UNFOUND,
    Recapture,
    family,
    listed_starts,
    longest_rows,
)
from evidence.studies.study import load
from evidence.studies.turns import first_turn, hoop_of, names_of

# First turns and boundaries.


def starts(count, seed, least=LEAST):
    """Return random γ, μ and rates of the family."""
    random = np.random.default_rng(seed)
    gamma, part = random.uniform(GAMMAS[0], GAMMAS[-1], count), random.uniform(0.0, 1.0, count)
    return (
        gamma,
        np.exp(random.uniform(math.log(least), math.log(MOST), count)),
        rate_of(gamma, part),
    )


def test_turns_of_a_batch_are_those_of_single_motions_whose_phases_are_sampled():
    columns = starts(1500, 1)
    single = [first_turn(*(float(one) for one in row)).name for row in zip(*columns, strict=True)]
    assert names_of(*columns).tolist() == single
    assert len(set(single)) > 25


def test_every_boundary_is_a_coincidence():
    found = family().found
    assert len(found) > 2000
    # Of the order of the width of a boundary, or of its root where two events come out of nothing.
    limits = {
        "a roll without duration": 1e-10,
        "a slide without duration": 1e-10,
        "a slip out of nothing": 1e-4,
        "a slip that touches zero": 1e-4,
    }
    untold = [one for one in found if one.kind == "not told"]
    assert len(untold) < 0.005 * len(found)
    stops = Counter()
    for one in found:
        turns = one.turns
        shortest = min(min(turn.durations, default=math.inf) for turn in turns)
        slides = max(max(turn.durations) for turn in turns)
        if one.kind in limits:
            assert shortest < limits[one.kind]
        elif one.kind == "an event at the stop":
            stops[shortest < 1e-6 or slides > 10.0] += 1
        elif one.kind == "not told":
            assert slides > 10.0
    # Rounding may leave the phase that begins at the stop behind it.
    assert stops[False] <= 0.005 * stops[True]


def test_across_a_boundary_few_phases_change():
    for one in family().found:
        below, above = (name.split()[0] for name in one.sides)
        same = 0
        while same < min(len(below), len(above)) and below[same] == above[same]:
            same += 1
        tail = 0
        while tail < min(len(below), len(above)) - same and below[-1 - tail] == above[-1 - tail]:
            tail += 1
        # At most two slips come out of nothing at once, each with the roll behind it.
        assert max(len(below), len(above)) - same - tail <= 4


def test_a_slip_comes_out_of_nothing_where_the_orbit_grazes_the_limit_of_friction():
    lines = [(gamma, part) for gamma in (0.4, 0.5, 0.6) for part in (0.4, 0.5, 0.6)]
    found = boundaries(lines, 0.1, 2.0, 12)
    for gamma, part in lines:
        last = [one for one in found if (one.gamma, one.part) == (gamma, part)][-1]
        assert last.above == "R revolution"
        assert last.kind == "a slip out of nothing"
        contact = Contact.of(hoop_of(last.mu, gamma))
        margin = Margin(contact, last.mu)
        constant = contact.denominator(0.0) * (1.0 + last.rate**2)

        def slope(theta, margin=margin, constant=constant):
            a, b = margin.terms(theta)
            return a[1] - constant * b[1]

        least = math.inf
        for low, high in pairwise(np.linspace(0.0, 2.0 * math.pi, 361)):
            if slope(low) < 0.0 <= slope(high):
                a, b = margin.terms(zero(slope, low, high))
                least = min(least, (a[0] - constant * b[0]) / abs(a[0]))
        assert abs(least) < 1e-9


def test_a_finer_scan_of_a_line_finds_the_same_boundaries():
    lines = [(0.45, 0.55), (0.62, 0.3), (0.71, 0.21)]
    coarse, fine = ([one.mu for one in boundaries(lines, 0.02, 2.0, count)] for count in (15, 90))
    assert coarse == pytest.approx(fine, rel=1e-9)
    assert len(coarse) > 15


def test_random_starts_have_the_sequences_of_the_lines():
    columns = starts(4000, 2, 0.02)
    missing = [name for name in names_of(*columns).tolist() if name not in listed_starts()]
    assert len(missing) <= 4


def test_the_lines_do_not_have_all_sequences_and_two_searches_do_not_either():
    # Starts of an independent search, with another program.
    found = Recapture.of(CORNER, listed_starts()).found
    for start, name, is_found in (
        (UNFOUND, "R-R+R-R+R-R revolution", False),
        (
            (0.2864325030024969, 0.010817605465116668, 0.7212563050567887),
            "R+R-R+R-R+-R revolution",
            True,
        ),
        (
            (0.3655039952264185, 0.008390902203133984, 0.7124488114235097),
            "R+-R-R+-R revolution",
            True,
        ),
    ):
        gamma, mu, part = start
        assert first_turn(gamma, mu, part / math.sqrt(gamma)).name == name
        assert name not in listed_starts()
        assert (name in found) == is_found


def test_each_start_of_the_list_has_its_sequence():
    rows = list(
        csv.DictReader(
            load("sequences").folder.joinpath("list.csv").read_text(encoding="utf-8").splitlines()
        )
    )
    assert len({(row["family"], row["sequence"], row["stop"]) for row in rows}) == len(rows) > 200
    for row in rows:
        gamma, part, mu = (float(row[name]) for name in ("gamma", "rate_times_root_gamma", "mu"))
        turn = first_turn(gamma, mu, part / math.sqrt(gamma), rim=row["family"] == "rim")
        assert turn.name == f"{row['sequence']} {row['stop']}"


def test_the_number_of_a_set_is_estimated_by_capture_and_recapture():
    # The estimate has no bias where every member is as easy to find: E = N for n1 + n2 ≥ N (Chapman
    # 1951).
    random = np.random.default_rng(3)
    everything = [str(name) for name in range(60)]
    found = [
        Recapture(
            set(random.choice(everything, 40, False)), set(random.choice(everything, 35, False))
        ).estimate
        for _ in range(4000)
    ]
    assert np.mean(found) == pytest.approx(60.0, abs=4.0 * np.std(found) / math.sqrt(len(found)))


def test_turns_of_a_batch_of_rim_hoops_are_those_of_single_motions():
    random = np.random.default_rng(7)
    gamma, part = random.uniform(*RIM.gamma, 1000), random.uniform(*RIM.part, 1000)
    mu, rate = np.exp(random.uniform(*np.log(RIM.mu), 1000)), rate_of(gamma, part)
    rows = zip(gamma, mu, rate, strict=True)
    single = [first_turn(*(float(one) for one in row), rim=True).name for row in rows]
    assert names_of(gamma, mu, rate, rim=True).tolist() == single
    assert len(set(single)) > 20
    # The hoops with γ = 0.75 belong to both families.
    assert first_turn(0.75, 0.2, 0.6, rim=True) == first_turn(0.75, 0.2, 0.6)


# Surfaces.


def test_lines_that_links_do_not_know_have_the_boundaries_of_the_surfaces():
    grid = family()
    random = np.random.default_rng(5)
    links = [grid.links[k] for k in random.choice(len(grid.links), 50, replace=False)]
    lines, guesses = [], []
    for link in links:
        start, end = grid.found[link.start], grid.found[link.end]
        assert start.sides == end.sides
        # At a third of the way, with the friction of the parabola through start, middle and end.
        lines.append(
            (
                start.gamma ** (2 / 3) * end.gamma ** (1 / 3),
                start.part ** (2 / 3) * end.part ** (1 / 3),
            )
        )
        guesses.append(start.mu ** (2 / 9) * link.mu ** (8 / 9) * end.mu ** (-1 / 9))
    found = boundaries(lines, LEAST, MOST, SCAN)
    for link, line, guess in zip(links, lines, guesses, strict=True):
        sides = grid.found[link.start].sides
        near = [
            abs(math.log(one.mu / guess))
            for one in found
            if (one.gamma, one.part) == line and one.sides == sides
        ]
        assert min(near, default=math.inf) < 0.01


# The theorem.


def hoops(count, seed):
    """Yield random hoops with one coefficient of friction.

    And random generators for their states.
    """
    random = np.random.default_rng(seed)
    for _ in range(count):
        mu = float(np.exp(random.uniform(math.log(0.02), math.log(2.0))))
        ratio, offset, inertia = (
            float(one) for one in random.uniform((0.1, 0.1, 0.0), (5.0, 1.0, 3.0))
        )
        hoop = lw.Hoop(mass_ratio=ratio, offset=offset, inertia=inertia, mu_s=mu, mu_k=mu)
        yield hoop, Contact.of(hoop), mu, random


def slide(contact, mu, sigma, theta, u):
    """Return θ″ and η″ of a slide, from Newton's and Euler's equations."""
    c, s = math.cos(theta), math.sin(theta)
    h, m, inertia = contact.h, contact.m, contact.inertia
    # Unknown θ″, η″ and N, with F = −μσN.
    matrix = [
        [-m * (1.0 + h * c), m, mu * sigma],
        [-m * h * s, 0.0, -1.0],
        [inertia, 0.0, -(h * s - mu * sigma * (1.0 + h * c))],
    ]
    right = [-m * h * s * u, m * h * c * u - m, 0.0]
    turning, slipping, _ = np.linalg.solve(matrix, right)
    return turning, slipping


def test_slides_differ_from_rolling_by_the_excess_of_friction():
    for _, contact, mu, random in hoops(300, 6):
        theta, u = random.uniform(0.0, 2.0 * math.pi), random.uniform(0.0, 4.0)
        normal, friction = contact.rolling(theta, u)
        d, lever = contact.denominator(theta), 1.0 + contact.h * math.cos(theta)
        rolling = contact.m * contact.h * math.sin(theta) * (1.0 + u) / d
        for sigma in (1.0, -1.0):
            turning, slipping = slide(contact, mu, sigma, theta, u)
            excess = -(sigma * friction + mu * normal)
            scale = d / (contact.m * contact.solvability(theta, mu * sigma))
            assert slipping == pytest.approx(sigma * scale * excess, rel=1e-9, abs=1e-9)
            assert turning == pytest.approx(
                rolling + contact.m * lever / d * slipping, rel=1e-9, abs=1e-9
            )


def test_at_most_one_slide_begins_and_the_other_is_kept_off_by_friction():
    met = 0
    for _, contact, mu, random in hoops(300, 7):
        for _ in range(20):
            theta, u = random.uniform(0.0, 2.0 * math.pi), random.uniform(0.0, 4.0)
            if (
                contact.pressure(theta, u) <= 0.0
                or min(contact.solvability(theta, one) for one in (mu, -mu)) <= 0.0
            ):
                continue
            normal, friction = contact.rolling(theta, u)
            assert min(friction - mu * normal, -friction - mu * normal) < 0.0
            met += 1
    assert met > 3000


class Trigonometric:
    """A polynomial in c, and another times s, by the coefficients of powers of c."""

    def __init__(self, even=(), odd=()):
        self.even, self.odd = ([Fraction(one) for one in terms] for terms in (even, odd))

    def __add__(self, other):
        both = ((self.even, other.even), (self.odd, other.odd))
        return Trigonometric(
            *([sum(pair) for pair in zip_longest(*terms, fillvalue=0)] for terms in both)
        )

    def __mul__(self, other):
        if not isinstance(other, Trigonometric):
            return self * Trigonometric([other])
        size = max(map(len, (self.even, self.odd))) + max(map(len, (other.even, other.odd))) + 1
        even, odd = [0] * size, [0] * size
        for one, two, terms, shifts in (
            (self.even, other.even, even, ((0, 1),)),
            (self.odd, other.odd, even, ((0, 1), (2, -1))),
            (self.even, other.odd, odd, ((0, 1),)),
            (self.odd, other.even, odd, ((0, 1),)),
        ):
            for (i, x), (j, y) in product(enumerate(one), enumerate(two)):
                for shift, sign in shifts if x and y else ():
                    terms[i + j + shift] += sign * x * y
        return Trigonometric(even, odd)


def test_the_margin_of_friction_vanishes_along_no_orbit_of_rolling():
    random = np.random.default_rng(8)
    cosine, sine = Trigonometric([0, 1]), Trigonometric([], [1])
    for _ in range(40):
        m, h, inertia, mu, constant = (Fraction(int(one), 97) for one in random.integers(1, 400, 5))
        sigma = int(random.choice((-1, 1)))
        offset = m * h
        d = cosine * (2 * offset) + Trigonometric([inertia + m * (1 + h * h)])
        # N and F of rolling times D², from u = K/D − 1 and θ″ = ℓsK/D².
        squared = d * constant + d * d * -1
        normal = (
            d * d * m + sine * sine * (-offset * offset * constant) + cosine * squared * -offset
        )
        friction = sine * squared * offset + (cosine * offset + Trigonometric([m])) * sine * (
            -offset * constant
        )
        margin = normal * mu + friction * sigma
        even, odd = margin.even, margin.odd
        # The third harmonics of c³ and of s c² have the coefficient 1/4; there is no higher one.
        assert even[3] / 4 == offset**3 * mu
        assert odd[2] / 4 == -(offset**3) * sigma
        assert not any(even[4:])
        assert not any(odd[3:])


def test_a_system_of_rolle_s_kind_has_at_most_as_many_zeros_as_equations():
    random = np.random.default_rng(9)
    steps, count, length = 400, 500, 0.2
    for order in (1, 2, 3, 4):
        # Coefficients that jump, and a start near a polynomial with all its zeros inside.
        jumps = np.tril(random.uniform(-1.0, 1.0, (20, count, order, order)))
        polynomials = [
            np.polynomial.Polynomial.fromroots(one)
            for one in random.uniform(0.0, length, (count, order))
        ]
        z = np.array(
            [[one.deriv(k)(0.0) if k else one(0.0) for k in range(order)] for one in polynomials]
        )
        signs = []
        for step in range(steps):
            signs.append(z[:, 0] > 0.0)
            top = np.full((count, 1), float(math.factorial(order)))
            slope = np.concatenate((z[:, 1:], top), axis=1) + np.einsum(
                "nij,nj->ni", jumps[step * 20 // steps], z
            )
            z = z + length / steps * slope
        changes = np.sum(np.diff(np.array(signs), axis=0), axis=0)
        assert changes.max() == order


def test_the_moment_about_the_contact_changes_as_if_there_were_no_forces():
    phases = 0
    for hoop, contact, _, random in hoops(40, 10):
        motion = hoop.simulate(
            theta=0.0, theta_rate=float(random.uniform(0.1, 0.99) / math.sqrt(contact.h)), until=8.0
        )
        offset = contact.m * contact.h
        for phase in motion.phases:
            if phase.mode == "flight":
                break
            length = min(phase.duration, 8.0 - phase.start.time)
            if length < 1e-3:
                continue
            times_ = phase.start.time + length * np.linspace(1e-9, 1.0 - 1e-9, 401)
            samples = motion(times_)
            theta, rate, slip = (
                np.asarray(samples[name]) for name in ("theta", "theta_rate", "slip")
            )
            denominator = np.array([contact.denominator(one) for one in theta])
            moment = denominator * rate - contact.m * (1.0 + contact.h * np.cos(theta)) * slip
            slope = offset * np.sin(theta) * (1.0 - rate**2 + rate * slip)
            weights = np.ones(401)
            weights[1:-1:2], weights[2:-1:2] = 4.0, 2.0
            change = float(weights @ slope) * (times_[1] - times_[0]) / 3.0
            assert moment[-1] - moment[0] == pytest.approx(
                change, abs=1e-6 * max(1.0, np.abs(moment).max())
            )
            phases += phase.mode == "sliding"
    assert phases > 60


def test_near_the_top_and_the_bottom_slow_hoops_roll():
    for _, contact, mu, random in hoops(200, 11):
        theta = random.choice((0.0, math.pi))
        u = random.uniform(0.0, 0.5)
        normal, friction = contact.rolling(theta, u)
        assert normal == pytest.approx(contact.m * contact.pressure(theta, u))
        assert abs(friction) < 1e-12 < mu * normal


def test_where_contact_is_lost_at_the_top_both_slips_fall():
    for _, contact, mu, _ in hoops(100, 12):
        h = contact.h
        for sigma in (1.0, -1.0):
            rate = 1.0 / math.sqrt(h)
            step = 1e-6
            values = []
            for sign in (-1.0, 1.0):
                theta = sign * step * rate
                turning, _ = slide(contact, mu, sigma, 0.0, rate**2)
                values.append(
                    slide(contact, mu, sigma, theta, (rate + sign * step * turning) ** 2)[1]
                )
            assert (values[1] - values[0]) / (2.0 * step) == pytest.approx(-rate, rel=1e-4)


def test_no_slide_begins_where_it_would_need_a_negative_pressure():
    met = 0
    for gamma, mu, rate in zip(*starts(1500, 13), strict=True):
        hoop = hoop_of(float(mu), float(gamma))
        contact = Contact.of(hoop)
        motion = hoop.simulate(theta=0.0, theta_rate=float(rate), proof="none", max_transitions=8)
        for phase in motion.phases:
            if phase.mode == "sliding" and phase.start.theta < 2.0 * math.pi:
                assert contact.solvability(phase.start.theta, float(mu) * phase.direction) > 0.0
                met += 1
    assert met > 1500


# Small friction.


def turns_with_next_to_no_friction(count):
    """Yield the reversals of the frictionless turn, from its cubic equation, with the turns at two
    small frictions.
    """
    random = np.random.default_rng(4)
    for _ in range(count):
        gamma = random.uniform(0.1, 0.7)
        rate = random.uniform(0.1, 0.95) / math.sqrt(gamma)
        roots = np.roots(quadratic(Contact.of(hoop_of(0.0, gamma)), rate)[::-1])
        inside = [one.real for one in roots if abs(one.imag) < 1e-9 and -0.995 < one.real < 0.995]
        if not any(0.99 < abs(one) < 1.01 and abs(one.imag) < 0.05 for one in roots):
            yield 2 * len(inside), first_turn(gamma, 1e-9, rate), first_turn(gamma, 1e-11, rate)


def slides(turn):
    """Return the durations of the slides of a turn."""
    return [
        duration for mode, duration in zip(turn.word, turn.durations, strict=True) if mode != "R"
    ]


def test_without_friction_reversals_are_the_roots_of_a_cubic_equation():
    found = set()
    for reversals, turn, _ in turns_with_next_to_no_friction(120):
        assert turn.stop == "revolution"
        long = [duration > 0.01 for duration in slides(turn)]
        assert sum(long) == 1 + reversals
        assert all(long[:-1])
        found.add(sum(long))
    assert found == {1, 3, 5}


def test_a_last_slide_just_before_the_top_is_as_long_as_the_root_of_friction():
    found = 0
    for reversals, turn, other in turns_with_next_to_no_friction(120):
        assert other.word == turn.word
        if len(slides(turn)) == 2 + reversals:
            assert slides(turn)[-1] == pytest.approx(10.0 * slides(other)[-1], rel=0.01)
            found += 1
    assert found > 80


def test_degenerate_rates_are_those_at_which_the_number_of_reversals_changes():
    for gamma in np.linspace(0.1, 0.7, 13):
        contact = Contact.of(hoop_of(0.0, float(gamma)))
        rates = np.linspace(0.05, 0.99, 1880) / math.sqrt(gamma)
        roots = [np.roots(quadratic(contact, rate)[::-1]) for rate in rates]
        counts = [sum(abs(one.imag) < 1e-12 and abs(one) < 1.0 for one in both) for both in roots]
        changes = [
            0.5 * (rates[k] + rates[k + 1])
            for k in range(len(rates) - 1)
            if counts[k] != counts[k + 1]
        ]
        assert sorted(degenerate_rates(contact)) == pytest.approx(changes, abs=2e-3)


def test_a_hoop_that_glides_without_turning_loses_slip_with_friction_and_parts_from_neighbours():
    for _, contact, mu, _ in hoops(100, 14):
        h = contact.h
        for sigma in (1.0, -1.0):
            # q = hs − σμ(1 + hc) is zero twice, if at all; the smaller angle is the unstable one.
            size = h * math.hypot(1.0, mu)
            if mu >= size:
                continue
            theta = sigma * (math.asin(mu / size) + math.atan(mu))
            turning, slipping = slide(contact, mu, sigma, theta, 0.0)
            assert turning == pytest.approx(0.0, abs=1e-12)
            assert slipping == pytest.approx(-sigma * mu)
            squared = (
                contact.m * h * (math.cos(theta) + sigma * mu * math.sin(theta)) / contact.inertia
            )
            step = 1e-6
            ahead, behind = (
                slide(contact, mu, sigma, theta + one, 0.0)[0] for one in (step, -step)
            )
            assert (ahead - behind) / (2.0 * step) == pytest.approx(squared, rel=1e-6, abs=1e-6)
            assert squared > 0.0


@pytest.mark.parametrize("family_of", ["shift", "rim"])
def test_the_search_moves_towards_many_slides_and_finds_no_more_than_the_table(family_of):
    rows = [row for row in longest_rows() if row["family"] == family_of]
    most = max(count for row in rows for count in range(10) if int(row[f"slides_{count}"]))
    assert all(
        sum(int(row[f"slides_{count}"]) for count in range(10)) == int(row["turns"]) for row in rows
    )
    counts = search(family_of, 9, 12_000)
    assert counts[most] > sum(counts) / 5
    assert not any(counts[most + 1 :])
