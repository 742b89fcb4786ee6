"""Fits of good tracks: intervals hold the truth, sequences are found, and what is wrong is doubted.

Hoops with and without rolling resistance; fits that begin at the truth, and where the command does.
"""

import math

import numpy as np
import pytest

from evidence.studies.film import clocks, command
from evidence.studies.film.clocks import OFF
from evidence.studies.film.command import ALL, FITS, KINDS, GoodTrack, filmed, is_of, random_motions
from evidence.studies.film.resistance import HEAD, lines_of, resistance_rows
from evidence.studies.film.throws import FREE
from evidence.studies.measured_data import (
    NAMED,
    WRONG,
    fits,
    fitted_clocks,
    is_named,
    least_told,
    pulls,
    strong,
    worst,
)
from evidence.studies.study import PAGES

ROWS = resistance_rows(PAGES / "measured-data")


def test_the_table_has_both_fits_of_each_track():
    tracks = {(row["kind"], row["track"]) for row in ROWS}
    assert len(ROWS) == len(FITS) * len(tracks)
    assert {kind for kind, _ in tracks} == set(KINDS)


@pytest.mark.parametrize("name", ALL)
def test_intervals_hold_the_truth_as_often_as_they_say(name):
    values = pulls([row for row in ROWS if row["fit"] == "estimated"], name)
    for half, level in ((0.994, 0.68), (1.96, 0.95)):
        # Three standard deviations of a binomial number; more where there is no resistance, of
        # which no estimate is negative.
        chance = 3.0 * math.sqrt(level * (1.0 - level) / values.size)
        assert level - chance < (abs(values) < half).mean() < level + 1.5 * chance


@pytest.mark.parametrize("fit", FITS)
def test_no_fit_of_a_hoop_with_resistance_is_wrong_in_silence(fit):
    rows = [
        row for row in ROWS if row["fit"] == fit and float(row["rolling_resistance_true"]) > 0.0
    ]
    silent = [row for row in rows if worst(row) > WRONG and not strong(row)]
    if fit == "held at 0":
        assert len(silent) <= 0.02 * len(rows)
    # Normal errors of five coefficients exceed three standard errors in one fit of eighty.
    else:
        chance = len(ALL) * 0.0027 * len(rows)
        assert len(silent) <= chance + 3.0 * math.sqrt(chance)


def test_a_track_of_the_table_comes_out_again():
    for cells in lines_of("slide", 2):
        made = dict(zip(HEAD, cells, strict=True))
        row = next(one for one in ROWS if all(one[k] == made[k] for k in ("kind", "track", "fit")))
        for name in ALL:
            if row[f"{name}_error"] not in ("", "inf"):
                error = float(row[f"{name}_error"])
                assert made[f"{name}_true"] == row[f"{name}_true"]
                assert abs(float(made[f"{name}_value"]) - float(row[f"{name}_value"])) < 0.1 * error


@pytest.mark.parametrize("fit", FITS)
def test_intervals_of_the_command_hold_the_truth_as_often_as_they_say(fit):
    rows = [row for row in fits() if row["fit"] == fit]
    assert {row["kind"] for row in rows} == set(KINDS)
    values = np.concatenate([pulls(rows, name) for name in FITS[fit]])
    for half, level in ((0.994, 0.68), (1.96, 0.95)):
        chance = 3.0 * math.sqrt(level * (1.0 - level) / values.size)
        assert level - chance < (abs(values) < half).mean() < level + 1.5 * chance


def test_the_command_finds_the_sequence_or_names_it():
    rows = fits()
    told = [row["phases"] == row["found"] or float(row["probability"]) > NAMED for row in rows]
    assert np.mean(told) > 0.95 - 3.0 * math.sqrt(0.95 * 0.05 / len(rows))


def test_a_fit_of_the_command_comes_out_again():
    row = next(one for one in fits() if one["kind"] == "slips" and one["fit"] == "held at 0")
    made = command.line_of(8, "slips", int(row["track"]), "held at 0")
    made = dict(zip(command.HEAD, made, strict=True))
    assert (made["phases"], made["found"]) == (row["phases"], row["found"])
    for name in ("mu_s", "mu_k", "inertia"):
        error = float(row[f"{name}_error"])
        assert abs(float(made[f"{name}_value"]) - float(row[f"{name}_value"])) < 0.1 * error


@pytest.mark.parametrize("kind,number", [("slips", 31), ("slide", 65)])
def test_sequences_that_were_missed(kind, number):
    """Waves were taken for slow errors, so that a hoop that rolls explained slips.

    And slips that are none, at μs = μk, had all of the probability of a slide that rolls on.
    """
    random = np.random.default_rng([7, KINDS.index(kind), number])
    motion = next(one for one in random_motions(random) if is_of(kind, one))
    rate, noise_m = float(random.choice([60.0, 120.0, 240.0])), random.choice([0.001, 0.002])
    track = filmed(motion, rate, noise_m, random.choice([0.004, 0.008]), random)
    one = GoodTrack(motion=motion, track=track, rate=rate, noise_m=noise_m)
    assert command.fitted(one, FREE).motion.sequence == motion.sequence


def test_a_clock_that_is_off_is_named_where_the_track_can_tell():
    rows = [row for row in fitted_clocks() if OFF / float(row["clock_error"]) >= least_told()]
    assert sum(map(is_named, rows)) >= 0.95 * len(rows)
    # Flights name it before the long work.
    row = next(row for row in rows if row["by_flights"] == "1")
    made = dict(zip(clocks.HEAD, clocks.line_of(int(row["throw"])), strict=True))
    assert {name: made[name] for name in ("factor", "by_flights", "doubts", "named")} == {
        name: row[name] for name in ("factor", "by_flights", "doubts", "named")
    }
    assert float(made["gravity"]) == pytest.approx(float(row["gravity"]), rel=1e-3)
    assert float(made["clock_error"]) == pytest.approx(float(row["clock_error"]), rel=0.1)
