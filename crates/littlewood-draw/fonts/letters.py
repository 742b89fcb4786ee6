"""Makes letters.txt, the letters of all pictures as outlines, from STIX Two Math.

    pip install fonttools==4.68.0 brotli
    npm pack @fontsource/stix-two-math@5.3.0   # unpack it
    python letters.py package/files/stix-two-math-latin-400-normal.woff2

STIX Two Math holds the upright letters, the italic ones of formulas (as mathematical alphanumeric
symbols) and the script letters of the paper in one drawing. A line is a letter: its face (r
upright, i italic), its code, its width and its outline as an SVG path, in thousandths of the size,
upwards positive. Licence: OFL.txt.
"""

import sys
from pathlib import Path

from fontTools.pens.basePen import BasePen
from fontTools.pens.transformPen import TransformPen
from fontTools.ttLib import TTFont

GREEK = "αβγδεζηθκλμνξπρϱστφχψωΓΔΘΛΣΦΨΩ"
SYMBOLS = "é−±×·∗°′″ℓ√∞∂≤≥≈≠→←↑↓½–—‘’…§₀\u0304\u0302"
SCRIPT = "𝓡𝓝𝓢"
ASCII = "".join(map(chr, range(0x20, 0x7F)))
# Accents are drawn for small letters, but stand over italic capitals: the bar over X, the hat over
# I.
LIFTS = {0x0304: (20, 656 - 473), 0x0302: (177, 656 - 473)}


def italic_symbols() -> dict[int, int]:
    """Plain letter -> mathematical italic symbol."""
    table = {}
    for i in range(26):
        table[ord("A") + i] = 0x1D434 + i
        table[ord("a") + i] = 0x1D44E + i
    table[ord("h")] = 0x210E
    for i in range(25):
        table[ord("α") + i] = 0x1D6FC + i
    for i in range(17):
        table[ord("Α") + i] = 0x1D6E2 + i
    for i in range(18, 25):
        table[ord("Α") + i] = 0x1D6E2 + i
    table[ord("ϱ")] = 0x1D71A
    return {plain: symbol for plain, symbol in table.items() if chr(plain) in ASCII + GREEK}


class Outline(BasePen):
    """An outline in the letters of an SVG path."""

    def __init__(self, glyphs):
        super().__init__(glyphs)
        self.path = ""

    def add(self, letter, *points):
        self.path += letter + " ".join(f"{value:g}" for point in points for value in point)

    def _moveTo(self, to):
        self.add("M", to)

    def _lineTo(self, to):
        self.add("L", to)

    def _qCurveToOne(self, handle, to):
        self.add("Q", handle, to)

    def _curveToOne(self, first, second, to):
        self.add("C", first, second, to)

    def _closePath(self):
        self.add("Z")


def main() -> None:
    (source,) = sys.argv[1:]
    font = TTFont(source)
    assert font["head"].unitsPerEm == 1000
    names, glyphs = font.getBestCmap(), font.getGlyphSet()
    plain = sorted(set(map(ord, ASCII + GREEK + SYMBOLS + SCRIPT)))
    print("not in the source:", [chr(code) for code in plain if code not in names])
    places = [("r", code, code) for code in plain] + [
        ("i", code, own) for code, own in sorted(italic_symbols().items())
    ]
    lines = []
    for face, code, own in places:
        if own in names:
            glyph, pen = glyphs[names[own]], Outline(glyphs)
            right, up = LIFTS.get(code, (0, 0))
            glyph.draw(TransformPen(pen, (1, 0, 0, 1, right, up)))
            lines.append(f"{face} {code:x} {glyph.width:g} {pen.path}".rstrip() + "\n")
    Path(__file__).with_name("letters.txt").write_text("".join(lines))


if __name__ == "__main__":
    main()
