"""The page on accuracy has the numbers and the picture of the measurement."""

import sys
from pathlib import Path

ROOT = Path(__file__).parents[3]
sys.path.insert(0, str(ROOT / "evidence" / "reference"))

from accuracy.page import PAGE, PICTURE, content, filled, fingerprint  # noqa: E402


def test_the_page_has_the_numbers_of_the_measurement():
    page = PAGE.read_text(encoding="utf-8")
    assert filled(page, content()) == page


def test_the_picture_shows_the_measurement():
    assert fingerprint(content()) in PICTURE.read_text(encoding="utf-8")
