"""Pictures in the style of the project: colours that the colour-blind tell apart, ticks at multiples of π, symbols.

Each function draws on axes of your own, or makes a figure. Nothing depends on a style sheet or a
backend; :func:`look` gives your figures the letters, frames and lines of ours.
"""

from .canvas import look, pi_ticks
from .course import history, path, trajectory
from .outcome_chart import classes, outcomes
from .plane import phase_plane
from .proof_chart import proof

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
