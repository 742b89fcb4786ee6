"""Every page has the numbers that its command computes, and all of its pictures."""

import html
import re

import pytest
from littlewood.plot import look

from evidence.studies.__main__ import computed
from evidence.studies.pictures import said
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
    for picture in study.pictures:
        file = study.folder / f"{picture}.svg"
        drawn = file.read_text(encoding="utf-8")
        words = [
            html.unescape(re.search(rf"<{tag}>(.*?)</{tag}>", drawn)[1])
            for tag in ("title", "desc")
        ]
        assert tuple(words) == said(study.page, file)


@pytest.mark.parametrize("name", NAMES)
def test_the_words_of_a_picture_are_on_its_sheet(name):
    for picture in load(name).pictures.values():
        with look():
            figure = picture()
            figure.draw_without_rendering()
        words = [*figure.texts]
        for axes in figure.axes:
            words += [*axes.texts, axes.xaxis.label, axes.yaxis.label]
            words += [] if axes.get_legend() is None else axes.get_legend().get_texts()
        for text in (one for one in words if one.get_visible() and one.get_text()):
            box = text.get_window_extent()
            assert box.x0 >= -0.5 and box.y0 >= -0.5, text
            assert box.x1 <= figure.bbox.x1 + 0.5 and box.y1 <= figure.bbox.y1 + 0.5, text


def test_the_index_has_every_study():
    text = (PAGES / "index.md").read_text(encoding="utf-8")
    assert [name for name in re.findall(r"\]\(([\w-]+)\.md\)", text) if name in NAMES] == list(
        NAMES
    )
