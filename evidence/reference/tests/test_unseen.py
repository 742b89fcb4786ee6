"""The library against independent programs at starts that nobody has seen.

`python3 -m unseen` in evidence/reference tries thousands.
"""

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parents[1]))

from unseen.__main__ import KINDS, SEED


@pytest.mark.parametrize(("kind", "count", "least"), [("resistance", 40, 300), ("range", 24, 15)])
def test_no_start_differs(kind, count, least):
    counts, events, different = KINDS[kind](SEED, range(count))
    assert not different
    assert events > least, counts


def test_a_wrong_answer_is_found(monkeypatch):
    """Friction that is a millionth larger moves numbers by far more than their conditioning."""
    from unseen import resisted, whole_range

    for kind in (resisted, whole_range):
        right = kind.simulated

        def wrong(given, right=right):
            hoop = list(given.hoop)
            hoop[3:5] = (v * (1 + 1e-6) for v in hoop[3:5])
            return right(given._replace(hoop=tuple(hoop)))

        monkeypatch.setattr(kind, "simulated", wrong)
        _, _, different = kind.attack(SEED, range(12))
        assert different, kind
