"""Fits of tracks of a motion.

Tracks, their errors, estimates of what is not known, and what speaks against them.
"""

from .diagnostics import DOUBTS, Doubt
from .estimate import Estimate
from .least_squares import fit
from .noise import Noise
from .result import FitResult, FitWarning, IdentifiabilityWarning
from .track import TableFileError, Track
from .usual_errors import USUAL_ERRORS

__all__ = [
    "DOUBTS",
    "USUAL_ERRORS",
    "Doubt",
    "Estimate",
    "FitResult",
    "FitWarning",
    "IdentifiabilityWarning",
    "Noise",
    "TableFileError",
    "Track",
    "fit",
]
