"""The sheet of markers is what its documentation links, and its ruler is one."""

import re
from pathlib import Path
from xml.etree import ElementTree

from littlewood import video
from littlewood.video.finder import MARKERS

SVG = "{http://www.w3.org/2000/svg}"


def test_the_sheet_is_that_of_the_documentation(tmp_path):
    text = video.marker_sheet(tmp_path / "sheet.svg")
    assert (tmp_path / "sheet.svg").read_text(encoding="utf-8") == text
    linked = Path(__file__).parents[1] / "docs" / "marker-sheet.svg"
    assert linked.read_text(encoding="utf-8") == text
    assert "(marker-sheet.svg)" in (linked.parent / "video.md").read_text(encoding="utf-8")


def test_the_ruler_is_true_and_the_spots_have_their_size():
    sheet = ElementTree.fromstring(video.marker_sheet())
    # A unit of the drawing is a millimetre of the page.
    assert (sheet.get("width"), sheet.get("height"), sheet.get("viewBox")) == (
        "210mm",
        "297mm",
        "0 0 210 297",
    )
    (ruler,) = (group for group in sheet.iter(f"{SVG}g") if group.get("id") == "ruler")
    places = [re.match(r"M(\d+) (\d+)v", one.get("d")) for one in ruler.iter(f"{SVG}path")][1:]
    assert [int(place[1]) - 20 for place in places] == list(range(171))
    labels = {
        one.text: float(one.get("x")) - 20 for one in sheet.iter(f"{SVG}text") if one.text.isdigit()
    }
    assert labels == {str(mm): mm for mm in range(10, 171, 10)}
    spots = [one for one in sheet.iter(f"{SVG}circle") if one.get("fill") != "none"]
    said = [one.text for one in sheet.iter(f"{SVG}text") if re.fullmatch(r"\w+, \d+ mm", one.text)]
    for spot, words in zip(spots, said, strict=True):
        colour, diameter = re.fullmatch(r"(\w+), (\d+) mm", words).groups()
        assert 2.0 * float(spot.get("r")) == float(diameter)
        assert tuple(bytes.fromhex(spot.get("fill")[1:])) == MARKERS[colour]
    # Nothing leaves the page, and no two spots touch.
    circles = [
        tuple(float(one.get(key)) for key in ("cx", "cy", "r"))
        for one in sheet.iter(f"{SVG}circle")
    ]
    for k, (x, y, r) in enumerate(circles):
        assert r < x < 210 - r and r < y < 297 - r
        for u, v, s in circles[:k]:
            assert (x - u) ** 2 + (y - v) ** 2 > (r + s) ** 2
    assert len(circles) == 16
