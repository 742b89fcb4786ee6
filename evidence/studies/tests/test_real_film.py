import math

import numpy as np
import pytest

from evidence.studies.film.hard import HARD
from evidence.studies.film.hard import line_of as of_hard
from evidence.studies.film.throws import FREE, throw
from evidence.studies.film.videos import film_of, track_of
from evidence.studies.film.videos import line_of as of_video
from evidence.studies.real_film import hard_rows, part_within, pulls, rows_of


def test_intervals_of_whole_videos_contain_the_truth_as_often_as_they_say():
    rows = rows_of("videos")
    assert [int(row["film"]) for row in rows] == list(range(200))
    for name in FREE:
        values = pulls(rows, name)
        assert len(values) >= 180
        for level in (0.5, 0.8, 0.95):
            chance = 3.0 * math.sqrt(level * (1.0 - level) / len(values))
            assert abs(part_within(values, level) - level) < chance
        # What 200 films leave to chance at 95 %.
        assert 0.92 < part_within(values, 0.95) < 0.98


def test_a_film_of_the_table_comes_out_again():
    row = rows_of("videos")[62]
    cells = dict(zip(row, map(float, of_video(62, track_of(film_of(62)))), strict=True))
    for name in FREE:
        assert cells[f"{name}_true"] == row[f"{name}_true"]
        assert cells[f"{name}_value"] == pytest.approx(
            row[f"{name}_value"], abs=0.1 * row[f"{name}_error"]
        )
        assert cells[f"{name}_error"] == pytest.approx(row[f"{name}_error"], rel=0.1)


def test_who_clicks_has_another_plane():
    film = film_of(7)
    pixels = film.clicked.to_pixels(*film.plane.to_metres([200.0, 450.0], [120.0, 250.0]))
    off = np.hypot(pixels[0] - [200.0, 450.0], pixels[1] - [120.0, 250.0])
    assert np.all((off > 0.01) & (off < 2.0))


@pytest.mark.parametrize("number", [31, 44])
def test_the_path_of_a_random_throw_is_in_the_picture(number):
    film = film_of(number)
    radius = film.thrown.hoop.units.length_m
    seen = film.thrown.motion(np.linspace(0.0, 1.0, 200) / film.thrown.hoop.units.time_s)
    for a in np.linspace(0.0, math.tau, 16):
        u, v = film.plane.to_pixels(
            (seen.x + math.cos(a)) * radius, (seen.centre_y + math.sin(a)) * radius
        )
        assert u.min() > 0.0 and u.max() < film.camera.width - 1
        assert v.min() > 0.0 and v.max() < film.camera.height - 1


def test_a_throw_slips_out_of_rolling_and_lands_twice():
    for seed in range(5):
        motion = throw(np.random.default_rng(seed)).motion
        causes = [transition.cause for transition in motion.transitions]
        assert "slip" in causes and "lift_off" in causes
        assert sum(transition.impact is not None for transition in motion.transitions) >= 2


def test_harder_films_are_those_of_the_page():
    rows = hard_rows()
    assert [(row["condition"], int(row["film"])) for row in rows] == [
        (name, film) for name, hard in HARD.items() for film in hard.films
    ]
    for row in rows:
        # The rim is found to a twentieth of a pixel, and a wrong fit is doubted.
        is_slow = HARD[row["condition"]].rate is not None
        assert float(row["centre_px"]) < (2.0 if is_slow else 1.0 / 20.0)
        assert float(row["worst_pull"]) < 4.0 or "structure" in row["doubts"]


def test_a_harder_film_comes_out_again():
    row = next(row for row in hard_rows() if (row["condition"], row["film"]) == ("noise", "2"))
    cells = dict(zip(row, of_hard("noise", 2), strict=True))
    assert (cells["hoops"], cells["markers"], cells["by_hoop"]) == (
        row["hoops"],
        row["markers"],
        row["by_hoop"],
    )
    for name in ("centre_px", "marker_px", "worst_pull"):
        assert float(cells[name]) == pytest.approx(float(row[name]), rel=0.02)
