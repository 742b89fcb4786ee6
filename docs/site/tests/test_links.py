"""Every link of the built site leads to a page, and to a place that is there; nothing is asked of
another host.
"""

import os
from collections.abc import Iterator
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

SITE = Path(os.environ["LITTLEWOOD_SITE"])
PAGES = sorted(
    page
    for page in SITE.rglob("*.html")
    if not {"rust", "lab", "_static"} & set(page.relative_to(SITE).parts)
)

# What a page loads, as against what it links to.
LOADS = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href"}
LINK_RELATIONS = {"stylesheet", "icon", "preload", "prefetch"}


class Page(HTMLParser):
    """Links, loads and places of a page."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.loads: list[str] = []
        self.places: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = {name: value or "" for name, value in attrs}
        self.places |= {given[name] for name in ("id", "name") if name in given}
        if tag == "a" and "href" in given:
            self.links.append(given["href"])
        loaded = given.get(LOADS.get(tag, ""))
        if loaded and (tag != "link" or LINK_RELATIONS & set(given.get("rel", "").split())):
            self.loads.append(loaded)


@cache
def parsed(path: Path) -> Page:
    return Page(path)


def broken(page: Path) -> Iterator[str]:
    for address in [*parsed(page).links, *parsed(page).loads]:
        parts = urlsplit(address)
        if parts.scheme or parts.netloc:
            continue
        goal = (page.parent / unquote(parts.path)).resolve() if parts.path else page
        if not goal.is_file():
            yield f"{address}: no such file"
        elif (
            parts.fragment and goal in PAGES and unquote(parts.fragment) not in parsed(goal).places
        ):
            yield f"{address}: no such place"


def test_there_are_pages():
    assert len(PAGES) > 35


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(SITE)))
def test_links_lead_somewhere(page):
    assert list(broken(page)) == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(SITE)))
def test_a_page_asks_nothing_of_another_host(page):
    assert [load for load in parsed(page).loads if urlsplit(load).netloc] == []


def test_equations_have_numbers_and_are_formulas():
    for chapter in (
        "body",
        "contact",
        "rolling",
        "sliding",
        "jumps",
        "massless",
        "impact",
        "rolling-resistance",
        "errata",
    ):
        text = (SITE / "docs" / "theory" / f"{chapter}.html").read_text(encoding="utf-8")
        assert text.count('class="eqno">(T') >= 2, chapter
        assert text.count("<math") > 10, chapter
        assert "katex-error" not in text
