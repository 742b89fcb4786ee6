"""Pictures of pages, in the look of the project.

They have the title and the description that their page gives them.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping
from html.entities import html5
from pathlib import Path
from statistics import NormalDist
from typing import TYPE_CHECKING

import numpy as np
from littlewood.plot import look
from littlewood.plot.canvas import key, words
from littlewood.plot.sheet import listed, svg
from littlewood.style import FINE, INK, LINE
from littlewood.tables import QUANTITIES

if TYPE_CHECKING:
    from matplotlib.axes import Axes
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


def part_within(values: Collection[float], level: float) -> float:
    """Return the part of errors, in standard errors, that are within the interval of a level."""
    half = NormalDist().inv_cdf(0.5 + 0.5 * level)
    return sum(abs(value) < half for value in values) / len(values)


def calibration(
    axis: Axes, errors: Mapping[str, Collection[float]], count: int, heading: str
) -> None:
    """Draw how often intervals contain the truth, against how often they say.

    Parameters
    ----------
    axis : Axes
        Where.
    errors : mapping of str to collection of float
        Errors over standard errors of each quantity.
    count : int
        Number of films or tracks of the band of chance.
    heading : str
        What stands above the key.
    """
    levels = np.linspace(0.02, 0.99, 98)
    for quantity, look_of in listed(list(errors)):
        parts = [100.0 * part_within(errors[quantity], float(level)) for level in levels]
        axis.plot(100.0 * levels, parts, **look_of, label=words(axis, QUANTITIES[quantity].sign))
    spread = 200.0 * np.sqrt(levels * (1.0 - levels) / count)
    axis.fill_between(
        100.0 * levels,
        100.0 * levels - spread,
        100.0 * levels + spread,
        color=LINE,
        alpha=0.6,
        lw=0,
        label="±2*σ*",
    )
    axis.plot([0, 100], [0, 100], color=INK, lw=FINE, label="as they say")
    axis.set(
        xlim=(0, 100),
        ylim=(0, 100),
        xlabel="level of the interval, %",
        ylabel="contain the truth, %",
    )
    key(axis, heading, columns=3)
