"""Pictures in the style of the project.

Colours that the colour-blind tell apart, ticks at multiples of π, symbols.

Each function draws on axes of your own, or makes a figure. Nothing depends on a style sheet or a
backend; :func:`look` gives your figures the letters, frames and lines of ours.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Protocol

from .canvas import look, pi_ticks
from .course import history, path
from .outcome_chart import classes, outcomes
from .overview import trajectory
from .plane import phase_plane

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = [
    "classes",
    "history",
    "look",
    "outcomes",
    "path",
    "phase_plane",
    "pi_ticks",
    "proof",
    "trajectory",
]


class _Proof(Protocol):
    def plot(self, width_mm: float) -> Figure: ...


def proof(found: _Proof, *, width_mm: float = 120.0) -> Figure:
    """Draw the proof that a motion has the events of its certificate, and no others.

    The picture has θ with the events; a row for each guard, which the checker encloses above 0
    interval by interval as long as a phase lasts; the radius of θ; and each event with its digits.

    Parameters
    ----------
    found : littlewood.certify.Proof
        What the checker has found.
    width_mm : float, optional
        Width of the figure, 60 to 1000. Letters have one size; a narrow figure has fewer digits.

    Returns
    -------
    matplotlib.figure.Figure

    Raises
    ------
    PictureError
        For another width.
    """
    return found.plot(width_mm)
