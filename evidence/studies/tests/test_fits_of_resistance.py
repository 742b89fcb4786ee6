"""Fits of hoops that lose by rolling: intervals hold the truth, and what is wrong is doubted."""

import math

import pytest

from evidence.studies.film.command import KINDS
from evidence.studies.film.resistance import ALL, FITS, HEAD, lines_of, resistance_rows
from evidence.studies.measured_data import WRONG, pulls, strong, worst
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
