"""Every drawing of the documents says what it shows, and its texts can be searched."""

import re
from pathlib import Path
from xml.etree import ElementTree

import pytest

DOCS = Path(__file__).parents[2]
PICTURES = sorted(
    path for path in DOCS.rglob("*.svg") if "site" not in path.relative_to(DOCS).parts
)
SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.parametrize("picture", PICTURES, ids=lambda path: path.relative_to(DOCS).as_posix())
def test_a_picture_has_a_title_a_description_and_searchable_texts(picture):
    root = ElementTree.parse(picture).getroot()
    assert root.get("role") == "img"
    title, description, *_ = root
    assert (title.tag, description.tag) == (f"{SVG}title", f"{SVG}desc")
    labels = [group.get("aria-label") for group in root.iter(f"{SVG}g") if group.get("aria-label")]
    assert labels
    # Letters are outlines, so that they look the same everywhere.
    assert root.find(f".//{SVG}text") is None
    for text in (title.text, description.text, *labels):
        assert text.strip()
        # Marks of texts, and of TeX, are taken off.
        assert not re.search(r"\\|\$|[_^]\{|\*", text), text


def test_there_are_pictures():
    assert len(PICTURES) > 40
