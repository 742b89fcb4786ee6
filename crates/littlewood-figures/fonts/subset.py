"""Makes littlewood-regular.ttf and littlewood-italic.ttf, the letters of the figures, from STIX Two Math.

    pip install fonttools==4.68.0 brotli
    npm pack @fontsource/stix-two-math@5.3.0   # unpack it
    python subset.py package/files/stix-two-math-latin-400-normal.woff2

STIX Two Math holds the upright letters, the italic ones of formulas (as mathematical alphanumeric symbols) and the
script letters of the paper in one drawing. The italic face carries the italic symbols at the places of the plain
letters, so that a figure says "θ", which can be searched for, and shows it as formulas have it. The family gets a name
of its own: nobody has it installed, so that what is seen is what is embedded. Licence: OFL.txt.
"""

import sys

from fontTools import subset
from fontTools.ttLib import TTFont

GREEK = "αβγδεηθλμνπρστφψωΓΔΘΛΣΦΨΩ"
SYMBOLS = "é−±×·°′″ℓ√∞≤≥≈≠→←↑↓½–—‘’…§\u0304\u0302"
SCRIPT = "𝓡𝓝"
# Heights of capital and small letters, in thousandths of the size.
CAPITAL, SMALL = 656, 473
ASCII = "".join(map(chr, range(0x20, 0x7F)))


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
    return {plain: symbol for plain, symbol in table.items() if chr(plain) in ASCII + GREEK}


def face(source: str, characters: list[int], places: dict[int, int], style: str, out: str) -> None:
    """One face with these characters of the source; `places` maps the code to carry -> the code to take it from."""
    font = TTFont(source, recalcTimestamp=False)
    options = subset.Options(
        hinting=False, notdef_outline=True, layout_features=["kern"], name_IDs=[], drop_tables=["MATH"]
    )
    worker = subset.Subsetter(options)
    worker.populate(unicodes=[places.get(code, code) for code in characters])
    worker.subset(font)
    moved = {symbol: plain for plain, symbol in places.items()}
    for table in font["cmap"].tables:
        table.cmap = {moved.get(code, code): glyph for code, glyph in table.cmap.items()}
    # A table for codes up to 0xffff lost what lay above; take all from the full one.
    full = max((table.cmap for table in font["cmap"].tables), key=len)
    for table in font["cmap"].tables:
        wide = table.format == 12
        table.cmap = {code: glyph for code, glyph in full.items() if wide or code <= 0xFFFF}
    # The bar stands over a capital, X, and not every renderer lifts it there.
    bar = full.get(0x0304)
    if bar is not None:
        font["glyf"][bar].coordinates.translate((20, CAPITAL - SMALL))
        font["glyf"][bar].recalcBounds(font["glyf"])
    names = font["name"]
    names.names = []
    for identifier, text in {
        0: "Copyright 2001-2021 The STIX Fonts Project Authors (https://github.com/stipub/stixfonts)",
        1: "Littlewood",
        2: style,
        4: f"Littlewood {style}",
        6: f"Littlewood-{style}",
        13: "This Font Software is licensed under the SIL Open Font License, Version 1.1.",
        14: "https://openfontlicense.org",
    }.items():
        names.setName(text, identifier, 3, 1, 0x409)
    italic = style == "Italic"
    font["OS/2"].fsSelection = 0x01 if italic else 0x40
    font["head"].macStyle = 2 if italic else 0
    font.flavor = None
    font.save(out)


def main() -> None:
    (source,) = sys.argv[1:]
    plain = sorted(set(map(ord, ASCII + GREEK + SYMBOLS + SCRIPT)))
    known = TTFont(source).getBestCmap()
    missing = [chr(code) for code in plain if code not in known]
    if missing:
        print("not in the source:", missing)
    plain = [code for code in plain if code in known]
    face(source, plain, {}, "Regular", "littlewood-regular.ttf")
    symbols = italic_symbols()
    # With all other letters as they are: a renderer that misses one may take the whole text from another face.
    face(source, plain, symbols, "Italic", "littlewood-italic.ttf")


if __name__ == "__main__":
    main()
