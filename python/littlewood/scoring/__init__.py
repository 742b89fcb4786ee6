"""Scores of contact solvers: the motion that a solver has computed, held against the exact one.

:func:`score` compares, :class:`Record` is what the solver has computed, and ``littlewood score CASE FILE`` is the same
from the command line.
"""

from .convergence import Convergence, convergence
from .episodes import Tolerances
from .record import Record, RecordError
from .score import EventScore, Score, score

__all__ = ["Convergence", "EventScore", "Record", "RecordError", "Score", "Tolerances", "convergence", "score"]
