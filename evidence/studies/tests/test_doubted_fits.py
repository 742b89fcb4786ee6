"""Fits of faulty films are doubted; the table has what its command makes."""

import numpy as np
import pytest

from evidence.studies.doubted_fits import doubts_of, rows_of, silent, unsaid
from evidence.studies.film.faults import FAULTS, line_of, thrown
from evidence.studies.film.soft import rolling_on_soft_ground


def test_without_resistance_the_soft_ground_is_the_exact_one():
    film = thrown(np.random.default_rng([0, 12]), 240.0)
    theta, x = rolling_on_soft_ground(film.hoop, film.start, film.time, 0.0)
    assert theta.size > 40
    # A transition is found to a step of 2e-4; the noise of the films is ten times as large as what
    # that makes.
    np.testing.assert_allclose(theta, film.theta[: theta.size], atol=4e-4)
    np.testing.assert_allclose(x, film.x[: x.size], atol=4e-4)


# Not of a marker: those tracks do not determine e, and the optimum depends on the last digits of
# the linear algebra of the machine.
@pytest.mark.parametrize("fault", ["none", "scale", "held"])
def test_a_line_of_the_table_is_made_again(fault):
    cells = line_of(fault, 0)
    row = rows_of(fault)[0]
    assert (cells[0], cells[1]) == (row["fault"], row["film"]) == (fault, "0")
    assert float(cells[2]) == pytest.approx(float(row["worst"]), abs=0.05)
    assert bool(doubts_of(row)) == (fault != "none")


@pytest.mark.parametrize("fault", FAULTS)
def test_wrong_answers_without_a_doubt_are_rare(fault):
    rows = rows_of(fault)
    assert len(rows) >= 15
    assert unsaid(rows) <= 0.02 * len(rows)
    # A good track has no fault that a doubt could name.
    assert fault == "none" or silent(rows) <= 0.02 * len(rows)
