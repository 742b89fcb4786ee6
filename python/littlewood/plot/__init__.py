"""Pictures in the style of the project: colours that the colour-blind tell apart, ticks at multiples of π, symbols.

Each function draws on axes of your own, or makes a figure. Nothing depends on a style sheet or a backend.
"""

from .canvas import pi_ticks
from .course import history, path, trajectory
from .outcome_chart import classes, outcomes
from .plane import phase_plane

__all__ = ["classes", "history", "outcomes", "path", "phase_plane", "pi_ticks", "trajectory"]
