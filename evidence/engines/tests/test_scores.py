"""SciPy, pymunk and the scheme of ours, run with two steps: what each must reach."""

import pytest

COARSE, FINE = 4e-3, 1e-3
CASES = (
    "one-coefficient",
    "two-coefficients",
    "lands",
    "bounces",
    "ramp-rests",
    "ramp-rolls",
    "ramp-slips",
    "ramp-jumps",
)

LARGEST = {
    ("scipy", "default"): 3e-2,
    ("scipy", "careful"): 1e-10,
    ("moreau", "default"): 1e-2,
    ("pymunk", "default"): 1e-2,
    ("pymunk", "careful"): 1e-2,
}
"""Largest error of x, y and theta at the fine step."""

ONE_COEFFICIENT = ("moreau", "pymunk")
"""Engines without a coefficient of its own at rest; their errors fall with the step."""


@pytest.fixture(scope="module")
def scores(run, tmp_path_factory):
    folder = tmp_path_factory.mktemp("results")
    options = [word for case in CASES for word in ("--case", case)] + [
        "--step",
        str(COARSE),
        "--step",
        str(FINE),
    ]
    assert run.main(["scipy", *ONE_COEFFICIENT, *options, "--out", str(folder)]) == 0
    return {
        (name, one["setting"], one["case"], one["step"]): one
        for name, runs in run.read(folder).items()
        for one in runs
    }


def test_each_is_scored_or_refuses_what_it_cannot_express(scores):
    for (name, _, case, _), one in scores.items():
        refuses = case == "two-coefficients" and name in ONE_COEFFICIENT
        assert one["status"] == ("refused" if refuses else "scored"), (name, case, one["reason"])
    assert {case for _, _, case, _ in scores} == set(CASES)


@pytest.mark.parametrize(("name", "setting"), LARGEST)
def test_a_fine_step_misses_no_event_and_is_close(scores, name, setting):
    found = [
        scores[name, setting, case, FINE] for case in CASES if (name, setting, case, FINE) in scores
    ]
    scored = [one for one in found if one["status"] == "scored"]
    assert len(scored) == len(CASES) - (name in ONE_COEFFICIENT)
    assert not any(one["missed"] for one in scored)
    assert max(one["error"] for one in scored) <= LARGEST[name, setting]


@pytest.mark.parametrize("name", ONE_COEFFICIENT)
def test_errors_fall_with_the_step(scores, name):
    coarse, fine = (
        scores[name, "default", "one-coefficient", step]["error"] for step in (COARSE, FINE)
    )
    assert 2.0 < coarse / fine < 8.0
