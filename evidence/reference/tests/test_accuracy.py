"""The page on accuracy has the numbers and the picture of the measurement."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from accuracy.page import PAGE, PICTURE, content, filled, fingerprint


def test_the_page_has_the_numbers_of_the_measurement():
    page = PAGE.read_text(encoding="utf-8")
    assert filled(page, content()) == page


def test_the_picture_shows_the_measurement():
    assert fingerprint(content()) in PICTURE.read_text(encoding="utf-8")
