"""A sheet of markers to print.

Spots for the hoop, targets for the plane of the motion, and a ruler.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from .finder import MARKERS

__all__ = ["marker_sheet"]

# Millimetres: the sheet is A4.
_WIDTH, _HEIGHT, _MARGIN = 210, 297, 20
_DIAMETERS = (20, 30, 40)
_COLOURS = ("red", "green", "blue", "magenta")
_TARGETS, _TARGET_RADIUS = 4, 15
_RULER = 170


def marker_sheet(path: str | Path | None = None) -> str:
    """Make the sheet of markers, A4, as SVG: print it at 100 %, and check its ruler with another.

    Parameters
    ----------
    path : str or Path, optional
        Where to write it.

    Returns
    -------
    str
        The text of the file.
    """
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{_WIDTH}mm" height="{_HEIGHT}mm" '
        f'viewBox="0 0 {_WIDTH} {_HEIGHT}" font-family="sans-serif" font-size="3.8">',
        "<title>Markers for a hoop</title>",
        f"<style>@page {{ size: {_WIDTH}mm {_HEIGHT}mm; margin: 0 }}</style>",
        f'<rect width="{_WIDTH}" height="{_HEIGHT}" fill="white"/>',
        *_text(_MARGIN, 20, "Markers for a hoop", size=7),
        *_text(
            _MARGIN,
            28,
            f"Print at 100 %, A4. Then the ruler is {_RULER} mm long; check it with another.",
        ),
        *_ruler(_MARGIN, 36),
        *_text(
            _MARGIN,
            60,
            "For the weight: one spot, a tenth to a fifth of the radius across, towards the "
            "camera.",
        ),
        *_text(_MARGIN, 65, "Its colour must be nowhere else in the picture."),
        *_spots(72),
        *_text(
            _MARGIN,
            205,
            "For the plane, if the hoop is not to be the ruler: four targets, whose places you "
            "measure.",
        ),
        *_targets(226),
        *_text(_MARGIN, 252, "littlewood fit film.mp4 --marker red"),
        "</svg>",
    ]
    text = "\n".join(lines) + "\n"
    if path is not None:
        Path(path).write_text(text, encoding="utf-8")
    return text


def _text(
    x: float, y: float, words: str, *, size: float = 3.8, middle: bool = False
) -> Iterator[str]:
    anchor = ' text-anchor="middle"' if middle else ""
    yield f'<text x="{x:g}" y="{y:g}" font-size="{size:g}"{anchor}>{words}</text>'


def _ruler(left: float, top: float) -> Iterator[str]:
    yield (
        f'<g id="ruler" stroke="black" stroke-width="0.2"><path d="M{left} {top}H{left + _RULER}"/>'
    )
    for mm in range(_RULER + 1):
        length = 7 if mm % 10 == 0 else 5 if mm % 5 == 0 else 3
        yield f'<path d="M{left + mm} {top}v{length}"/>'
    yield "</g>"
    for cm in range(0, _RULER // 10 + 1):
        yield from _text(
            left + 10 * cm, top + 11, str(10 * cm) + " mm" * (cm == 0), size=3.2, middle=True
        )


def _spots(top: float) -> Iterator[str]:
    step = (_WIDTH - 2 * _MARGIN) / len(_COLOURS)
    for k, name in enumerate(_COLOURS):
        x, y = _MARGIN + (k + 0.5) * step, top
        colour = "#{:02x}{:02x}{:02x}".format(*MARKERS[name])
        for diameter in _DIAMETERS:
            y += diameter / 2 + 2
            yield f'<circle cx="{x:g}" cy="{y:g}" r="{diameter / 2:g}" fill="{colour}"/>'
            yield f'<path d="M{x - 2:g} {y:g}h4m-2 -2v4" stroke="white" stroke-width="0.3"/>'
            y += diameter / 2 + 6
            yield from _text(x, y - 1, f"{name}, {diameter} mm", size=3.2, middle=True)


def _targets(y: float) -> Iterator[str]:
    step, r = (_WIDTH - 2 * _MARGIN) / _TARGETS, _TARGET_RADIUS
    for k in range(_TARGETS):
        x = _MARGIN + (k + 0.5) * step
        yield (
            f'<circle cx="{x:g}" cy="{y:g}" r="{r}" fill="none" stroke="black" stroke-width="0.3"/>'
        )
        yield (
            f'<path d="M{x:g} {y:g}v{-r}a{r} {r} 0 0 1 {r} {r}zm0 0v{r}a{r} {r} 0 0 1 {-r} {-r}z"/>'
        )
