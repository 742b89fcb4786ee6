"""The questions to integrators, answered by closed forms: an exact one gets everything right."""

import importlib.util
import math
import sys
from pathlib import Path

import pytest


@pytest.fixture
def problems(monkeypatch):
    """The module of the questions."""
    path = Path(__file__).parents[1] / "events" / "problems.py"
    spec = importlib.util.spec_from_file_location("problems", path)
    module = importlib.util.module_from_spec(spec)
    monkeypatch.setitem(sys.modules, "problems", module)
    spec.loader.exec_module(module)
    return module


class Exact:
    """Swings and falls without integration."""

    def __init__(self, problems):
        self.problems = problems

    def first(self, system, parameter, state, until):
        """The first fall of a margin through zero."""
        if system.name == "swing":
            height = math.hypot(*state)
            # Half an ulp decides whether a touch is one: it counts as none.
            if parameter >= height * (1.0 - 1e-15):
                return None
            time = math.asin(parameter / height) - math.atan2(state[0], state[1])
            return self.problems.Stop(time, (parameter, math.sqrt(height**2 - parameter**2)), (0,))
        falls = [
            speed + math.sqrt(speed**2 + 2.0 * height)
            for height, speed in zip(state[::2], state[1::2], strict=True)
        ]
        time = min(falls)
        if time > until:
            return None
        end = [
            part
            for height, speed in zip(state[::2], state[1::2], strict=True)
            for part in (height + speed * time - time * time / 2.0, speed - time)
        ]
        named = tuple(i for i, fall in enumerate(falls) if fall - time < 1e-12)
        return self.problems.Stop(time, tuple(end), named)


def test_an_exact_answer_gets_full_marks(problems):
    """No alarm, no dip missed, both of two, every landing, and the bounces up to their limit."""
    peer = Exact(problems)
    touching = problems.touching(peer)
    assert touching == {"cleared": "0", "touched": "0", "1e-9": "100", "1e-6": "100", "1e-3": "100"}
    assert problems.together(peer) == {"both": 20, "one by one": 0, "one lost": 0}
    assert set(problems.at_start(peer).values()) == {"lands", "seen"}
    bounces = problems.accumulating(peer)
    assert bounces["bounces"] == problems.BOUNCES
    assert math.isclose(bounces["last"], 3.0)


def test_a_refusal_is_counted_and_not_hidden(problems):
    """An integrator that raises has found nothing."""

    class Refusing:
        def first(self, *_):
            raise RuntimeError("no")

    assert problems.touching(Refusing())["1e-3"] == "0 (100 errors)"
