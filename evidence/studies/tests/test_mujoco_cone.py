import math

import numpy as np
import pytest

from evidence.studies.mujoco_cone import BALL, braking, creep, forces, ideal, runs
from evidence.studies.mujoco_runs import planned, starting_slope


def test_the_force_is_on_the_ellipse_and_dissipates_most():
    angles = np.linspace(0.0, 2.0 * math.pi, 100_001)
    for mu, chi, slip, spin in ((0.5, 0.1, -0.3, 1.0), (0.1, 0.4, 2.0, 0.7)):
        friction, couple = forces(mu, chi, slip, spin)
        assert (friction / mu) ** 2 + (couple / chi) ** 2 == pytest.approx(1.0)
        best = np.min(mu * np.cos(angles) * slip + chi * np.sin(angles) * spin)
        assert friction * slip + couple * spin == pytest.approx(best, rel=1e-8)


def test_the_creep_is_that_of_equal_ratios_of_accelerations():
    for mu, chi in ((0.1, 0.1), (0.5, 0.02), (0.2, 1.0)):
        kappa = creep(mu, chi)
        friction, couple = forces(mu, chi, kappa, 1.0)
        turn = (friction + couple) / BALL
        assert (friction + turn) / turn == pytest.approx(kappa, rel=1e-12)
        assert friction == pytest.approx(braking(mu, chi))
        assert kappa < 0.0
    assert creep(1.0, 1e-3) == pytest.approx(-1e-6 / (1.0 + BALL), rel=1e-5)


def test_mujoco_starts_where_the_cone_gives_way():
    speeds = {(one.mu, one.chi, one.tangent, one.until): one for one in runs("slope")}
    for (mu, chi, tangent, until), one in speeds.items():
        if until == 4.0:
            gained = one.speed - speeds[mu, chi, tangent, 2.0].speed
            starts = tangent > starting_slope(mu, chi)
            assert (gained > 1e-4) if starts else abs(gained) < 1e-9


def test_mujoco_creeps_as_the_cone_does():
    for one in runs("level"):
        _, speed, spin = ideal(one.mu, one.chi, one.until)[-1]
        assert (one.spin - one.speed) / one.spin == pytest.approx((spin - speed) / spin, rel=0.05)


def test_the_table_has_the_runs_that_are_planned():
    kept = [*runs("slope"), *runs("level"), *runs("soft")]
    for plan, one in zip(planned(), kept, strict=True):
        given = (plan.mu, plan.chi, plan.begin, plan.until, plan.impratio, plan.stiffness)
        assert given == (one.mu, one.chi, one.begin, one.until, one.impratio, one.stiffness)
        assert one.tangent == pytest.approx(plan.tangent, rel=1e-8)
