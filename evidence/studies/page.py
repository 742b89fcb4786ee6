"""Pages with computed places.

Each is a text between a mark `<!-- label -->` and its end `<!-- /label -->`.
"""

from __future__ import annotations

from collections.abc import Sequence

from scipy.stats import binomtest


def table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the lines of a table."""
    lines = [heads, ["---"] * len(heads), *rows]
    return [f"| {' | '.join(cells)} |" for cells in lines]


def put(text: str, label: str, content: list[str] | str) -> str:
    """Return a page with the content of a place: lines of their own, or a part of a sentence.

    Raises
    ------
    ValueError
        If the page does not have the place exactly once.
    """
    begin, end = f"<!-- {label} -->", f"<!-- /{label} -->"
    if text.count(begin) != 1 or text.count(end) != 1:
        raise ValueError(
            f"the page has {text.count(begin)} places {begin} and {text.count(end)} ends of it, "
            "not one"
        )
    before, rest = text.split(begin)
    after = rest.split(end)[1]
    body = content if isinstance(content, str) else "\n" + "\n".join(content) + "\n"
    return f"{before}{begin}{body}{end}{after}"


def share(count: int, total: int) -> str:
    """Return a share with its 95 % interval, Clopper and Pearson's."""
    if total == 0:
        return "–"
    interval = binomtest(count, total).proportion_ci(0.95)
    low, high = 100.0 * interval.low, 100.0 * interval.high
    return f"{100.0 * count / total:.0f} % ({low:.0f} to {high:.0f})"
