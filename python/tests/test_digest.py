"""The module computes the same bits as every other build: `./test.sh bits` compares all blocks."""

from pathlib import Path

import pytest

from littlewood import _core

DIGEST = Path(__file__).parents[2] / "crates" / "littlewood-digest" / "digest.txt"
COMMITTED = DIGEST.read_text(encoding="utf-8").splitlines()


def test_there_are_a_hundred_blocks():
    assert len(COMMITTED) == 100


@pytest.mark.parametrize("block", range(0, 100, 5))
def test_a_block_has_the_committed_bits(block):
    assert _core.digest_line(block) == COMMITTED[block]
