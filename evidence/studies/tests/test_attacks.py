"""A few tries of each attack; `python -m evidence.studies.attacks` makes thousands."""

import math

import numpy as np
import pytest

from evidence.studies import attacks, grazing, rolling_resistance, slip_before_jump
from evidence.studies.attacks import ATTACKS, Body, results, search, thrown

FEW = {
    "without slip": 6,
    "bounce": 3,
    "climb": 12,
    "fades": 12,
    "dead stop": 6,
    "swings": 3,
    "jam": 6,
    "creep": 1,
}
"""Draws of the slow ones; of the others 30."""


@pytest.mark.parametrize("attack", ATTACKS, ids=lambda one: f"{one.study}/{one.theorem}")
def test_a_few_tries_find_nothing(attack):
    _, found = search(attack, FEW.get(attack.theorem, 30), seed=7)
    assert not found


def test_the_long_search_tried_each_theorem_and_found_nothing():
    assert set(results()) == {(one.study, one.theorem) for one in ATTACKS}
    assert all(tried >= 50 and contradict == 0 for tried, contradict in results().values())


def wrong(theorem, attempt, tries):
    (attack,) = (one for one in ATTACKS if (one.study, one.theorem) == theorem)
    assert attack.attempt is attempt
    return search(attack, tries, seed=7)[1]


def test_a_false_law_of_half_swings_is_found(monkeypatch):
    right = rolling_resistance.Swings.number
    monkeypatch.setattr(
        rolling_resistance.Swings, "number", lambda law, amplitude: 1.1 * right(law, amplitude)
    )
    assert wrong(("rolling-resistance", "swings"), attacks.half_swings, 8)


def test_a_false_law_of_slips_that_fade_is_found(monkeypatch):
    right = grazing.Grazing.loss
    monkeypatch.setattr(grazing.Grazing, "loss", lambda orbit, mu: 1.2 * right(orbit, mu))
    assert wrong(("how-many-slips", "fades"), attacks.slips_fade, 8)


def test_a_bound_of_climbs_that_is_too_low_is_found(monkeypatch):
    right = slip_before_jump.climb
    monkeypatch.setattr(slip_before_jump, "climb", lambda turn: 0.99 * right(turn))
    assert wrong(("slip-before-jump", "climb"), attacks.highest_climb, 20)


def test_a_theorem_on_motions_without_its_bound_is_found(monkeypatch):
    # With a bound of ten times 2 √(Î/m) there are states without a motion.
    monkeypatch.setattr(Body, "rho", property(lambda body: 100.0 * body.hoop.i / body.hoop.m))
    assert wrong(("rolling-resistance", "motion"), attacks.has_a_motion, 600)


def test_motions_leave_out_of_rolling_where_bounces_grow():
    # The rest that shows that slip-before-jump needs e = 0 or Λ ≤ 1: P > 0 at all angles.
    body = Body(mass_ratio=1.0, offset=1.0, inertia=1.0, mu_s=1.0, mu_k=1.0, slope=math.radians(25))
    assert attacks.least_p(body, 1.0) > 0.0
    modes = attacks.choice.possible(body.hoop, attacks.balances.State(0.0, -1.4433, 0.0, 0.0, 0.0))
    assert [one.name for one in modes] != []
    *_, ratio = thrown(body, -1.4433, 0.0, 0.9)
    assert ratio == pytest.approx(1.0795, abs=1e-4)
    *_, ratio = thrown(body, -1.4433, 0.0, 0.5)
    assert ratio < 1.0


def test_draws_are_the_same_each_time():
    first, second = (attacks.any_body(np.random.default_rng([1, 2])) for _ in range(2))
    assert first == second
