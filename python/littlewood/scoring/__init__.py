"""Scores of contact solvers: the motion that a solver has computed, held against the exact one.

:func:`score` compares, :class:`Record` is what the solver has computed, and ``littlewood score CASE
FILE`` is the same from the command line.
"""

from .._internal.text_table import TableFileError
from .cases import BENCHMARK, CASES, BenchmarkCase
from .convergence import Convergence, convergence
from .episodes import Tolerances
from .gradient import GradientScore, PhaseGradient, score_gradient
from .record import Record
from .score import EventScore, Score, score

__all__ = [
    "BENCHMARK",
    "CASES",
    "BenchmarkCase",
    "Convergence",
    "EventScore",
    "GradientScore",
    "PhaseGradient",
    "Record",
    "Score",
    "TableFileError",
    "Tolerances",
    "convergence",
    "score",
    "score_gradient",
]
