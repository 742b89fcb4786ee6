"""Every page has the numbers that its command computes, and all of its pictures."""

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


def test_the_index_has_every_study():
    text = (PAGES / "index.md").read_text(encoding="utf-8")
    assert [name for name in re.findall(r"\]\(([\w-]+)\.md\)", text) if name in NAMES] == list(NAMES)
