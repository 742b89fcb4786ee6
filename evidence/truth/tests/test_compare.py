"""The page on the certified motions has the errors of the library as it is."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from compare import PAGE, filled, table


def test_all_motions_have_the_certified_events_and_the_page_has_their_errors():
    rows, others = table()
    assert not others
    page = PAGE.read_text(encoding="utf-8")
    assert filled(page, rows) == page
