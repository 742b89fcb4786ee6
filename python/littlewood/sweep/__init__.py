"""Many motions: one data set of all of them, whole or in blocks, with derivatives."""

from .many import Quantities, outcome_map, sequence_names, simulate_many

__all__ = ["Quantities", "outcome_map", "sequence_names", "simulate_many"]
