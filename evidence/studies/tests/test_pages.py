"""Every page has the numbers that its command computes, and all of its pictures."""

import html
import re

import pytest

from evidence.studies.__main__ import computed
from evidence.studies.study import NAMES, PAGES, load


@pytest.mark.parametrize("name", NAMES)
def test_a_page_has_the_numbers_of_its_command(name):
    study = load(name)
    assert study.page.read_text(encoding="utf-8") == computed(study)
    for file, content in study.files.items():
        assert (study.folder / file).read_text(encoding="utf-8") == content()


@pytest.mark.parametrize("name", NAMES)
def test_a_page_shows_its_pictures_and_its_command(name):
    study = load(name)
    text = study.page.read_text(encoding="utf-8")
    shown = set(re.findall(rf"\({name}/([\w-]+)\.svg\)", text))
    assert shown == set(study.pictures)
    assert all((study.folder / f"{picture}.svg").is_file() for picture in shown)
    assert f"python -m evidence.studies {name}\n" in text


@pytest.mark.parametrize("name", NAMES)
def test_pictures_have_the_title_and_the_description_of_their_page(name):
    study = load(name)
    text = study.page.read_text(encoding="utf-8")
    for picture in study.pictures:
        drawn = (study.folder / f"{picture}.svg").read_text(encoding="utf-8")
        title, description = (
            html.unescape(re.search(rf"<{tag}>(.*?)</{tag}>", drawn, re.S).group(1))
            for tag in ("title", "dc:description")
        )
        assert f"![{title}]({name}/{picture}.svg)\n\n{description}" in text


def test_the_index_has_every_study():
    text = (PAGES / "index.md").read_text(encoding="utf-8")
    assert [name for name in re.findall(r"\]\(([\w-]+)\.md\)", text) if name in NAMES] == list(NAMES)
