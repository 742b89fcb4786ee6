"""What follows a roll that gives way, for the peers, where both coefficients are equal."""

import importlib.util
from itertools import pairwise
from pathlib import Path

import pytest

HOOPS = ["1 1 1 0.5 0.5", "0.3333333333333333 1 0.3333333333333333 1 1", "0 1 0.001 0.5 0.5"]


@pytest.fixture(params=HOOPS)
def physics(request, monkeypatch):
    """The module of the peers, for a hoop."""
    monkeypatch.setenv("LITTLEWOOD_HOOP", request.param)
    path = Path(__file__).parents[1] / "peers" / "physics.py"
    spec = importlib.util.spec_from_file_location("physics", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def last_and_first(physics, rate):
    """Neighbouring angles, between which a hoop that turns forwards begins to slip."""

    def holds(theta):
        return min(physics.slip_margins(theta, rate)) > 0.0

    steps = [k / 64 for k in range(-201, 202)]
    low, high = next(
        (pair for pair in pairwise(steps) if holds(pair[0]) > holds(pair[1])),
        (0.0, 0.0),
    )
    while low < (middle := (low + high) / 2) < high:
        low, high = (middle, high) if holds(middle) else (low, middle)
    return [low, high] if low < high else []


def test_the_limit_that_is_reached_says_which_way_the_hoop_slips(physics):
    """On the limit rolling and sliding agree, so that rounding decides on everything else."""
    found = 0
    for rate in (k / 32 for k in range(1, 128)):
        for theta in last_and_first(physics, rate):
            toward_negative, toward_positive = physics.slip_margins(theta, rate)
            event, way = (0, -1) if toward_negative < toward_positive else (1, 1)
            assert physics.mode_after(physics.ROLL, event, theta, rate) == way, (theta, rate)
            found += 1
    assert found > 20
