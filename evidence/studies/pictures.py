"""Pictures of pages, in the look of the project.

They have the title and the description that their page gives them.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from html.entities import html5
from pathlib import Path
from typing import TYPE_CHECKING

from littlewood.plot import look
from littlewood.plot.sheet import svg

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SIGNS = {"varphi": "φ", "sqrt": "√", "hat": "", "mathcal": "", "ln": "ln ", "tan": "tan "}
SMALL = {"_": str.maketrans("012sk", "₀₁₂ₛₖ"), "^": str.maketrans("*-0123456789", "∗⁻⁰¹²³⁴⁵⁶⁷⁸⁹")}


def write(picture: Callable[[], Figure], file: Path, page: Path) -> None:
    """Draw a picture of a page."""
    with look():
        file.write_text(svg(picture(), *said(page, file)), encoding="utf-8")


def said(page: Path, file: Path) -> tuple[str, str]:
    """Return the title of a picture in its page, and the paragraph below it, in plain letters.

    Raises
    ------
    ValueError
        If the page does not show the picture, with a paragraph.
    """
    link = re.escape(file.relative_to(page.parent).as_posix())
    found = re.search(
        rf"^!\[([^\n]+)\]\({link}\)\n\n(\S.*?)\n\n", page.read_text(encoding="utf-8"), re.M | re.S
    )
    if found is None:
        raise ValueError(f"{page.name} does not show {file.name} with a paragraph below it")
    return plain(found[1]), plain(found[2])


def plain(text: str) -> str:
    """Return a text of a page without its marks."""
    text = re.sub(
        r"<!--.*?-->", "", re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", text.replace("\n", " "))
    )
    parts = text.split("$")
    return "".join(
        formula(part) if k % 2 else re.sub("[*`]", "", part) for k, part in enumerate(parts)
    )


def formula(tex: str) -> str:
    """Return a formula of TeX in letters of Unicode."""

    def small(one: re.Match[str]) -> str:
        text, signs = one[2] or one[3], SMALL[one[1]]
        return (
            text.translate(signs)
            if all(ord(letter) in signs for letter in text)
            else f"{one[1]}({text})"
            if text[1:]
            else one[0]
        )

    # HTML calls the other signs as TeX does.
    def sign(name: re.Match[str]) -> str:
        return SIGNS[name[1]] if name[1] in SIGNS else html5[f"{name[1]};"] + name[2]

    tex = re.sub(
        r"\\([A-Za-z]+)( ?)",
        sign,
        tex.replace(r"\hat I", "Î").replace(r"\tfrac12", "½").replace("'", "′"),
    )
    tex = re.sub(r"([_^])(?:\{(.*?)\}|(.))", small, tex)
    return tex.replace("-", "−").replace("{", "").replace("}", "")
