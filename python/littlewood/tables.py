"""The tables of the core: quantities, modes, causes, outcomes, classes, regions, phases, columns.

Names, codes, labels and units stand in the core alone; this module gives them types.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from . import _core
from ._frozen import Frozen


class Quantity(NamedTuple):
    """A quantity: names, units, bounds and default.

    One that is optional has no default, and a meaning where it is absent. The default of one that
    goes without saying is left out of attributes. `cf_unit` and `scale` are those of a value in the
    system of (2.9): the value is a multiple of the scale.
    """

    name: str
    group: str
    is_si: bool
    twin: str | None
    symbol: str
    sign: str
    unit: str
    unit_sign: str
    cf_unit: str
    scale: str
    long_name: str
    help: str
    bounds: list[str]
    default: float | None
    is_optional: bool
    goes_without_saying: bool


class SampleColumn(NamedTuple):
    """A column of samples. Codes have no units."""

    name: str
    sign: str
    long_name: str
    unit_sign: str | None
    cf_unit: str | None
    scale: str | None
    si_name: str | None
    si_unit: str | None


class SummaryColumn(NamedTuple):
    """A column of summaries; `kind` is outcome, sequence, count, flag or real."""

    name: str
    kind: str
    dtype: str
    cf_unit: str
    scale: str
    long_name: str


def _labels(rows: Iterable[_core._Coded]) -> Mapping[str, str]:
    return Frozen((row["name"], row["label"]) for row in rows)


QUANTITIES: Mapping[str, Quantity] = Frozen(
    (row["name"], Quantity(**row)) for row in _core.quantities()
)
"""All quantities by their names, in SI units as well."""

HOOP: tuple[str, ...] = tuple(_core.HOOP)
"""Names of the parameters of a hoop."""

START: tuple[str, ...] = tuple(_core.START)
"""Names of the numbers of a start."""

FRICTION: str = _core.FRICTION["name"]
"""Name of the axis that both coefficients of friction share."""

AXES: tuple[str, ...] = tuple(_core.AXES)
"""Names of what a sweep can vary."""

SI_HOOP: tuple[str, ...] = tuple(_core.SI_HOOP)
"""Names of the numbers of a hoop in SI units."""

SI_START: tuple[str, ...] = tuple(_core.SI_START)
"""Names of the numbers of a start in SI units."""

SAMPLE_COLUMNS: Mapping[str, SampleColumn] = Frozen(
    (row["name"], SampleColumn(**row)) for row in _core.sample_columns()
)
"""Columns of samples by their names."""

SUMMARY_COLUMNS: Mapping[str, SummaryColumn] = Frozen(
    (row["name"], SummaryColumn(**row)) for row in _core.summary_columns()
)
"""Columns of summaries by their names."""

MAX_TRANSITIONS: int = _core.MAX_TRANSITIONS
"""Number of transitions after which a motion is stopped by default."""

MAX_SLIDES: int = _core.MAX_SLIDES
"""Length of all slides together after which a motion is stopped by default."""

PROOFS: tuple[str, ...] = tuple(_core.PROOFS)
"""Names of what may be enough to end a motion."""

PROOF: str = _core.PROOF
"""What is enough by default."""

MODES: tuple[str, ...] = tuple(row["name"] for row in _core.MODES)
"""Names of the modes of motion.

Their places are the codes in arrays. Outside a motion the code is -1.
"""

MODE_CODES: Mapping[str, int] = Frozen((row["name"], row["code"]) for row in _core.MODES)
"""Codes of the modes by their names."""

CAUSES: tuple[str, ...] = tuple(row["name"] for row in _core.CAUSES)
"""Names of the causes of transitions."""

CAUSE_LABELS: Mapping[str, str] = _labels(_core.CAUSES)
"""Causes in words."""

IMPACT_CASES: tuple[str, ...] = tuple(row["name"] for row in _core.IMPACT_CASES)
"""Names of what the contact point does in an impact."""

IMPACT_LABELS: Mapping[str, str] = _labels(_core.IMPACT_CASES)
"""The same in words."""

RESTITUTION_LAWS: tuple[str, ...] = tuple(row["name"] for row in _core.RESTITUTION_LAWS)
"""Names of the laws of restitution."""

LAW_LABELS: Mapping[str, str] = _labels(_core.RESTITUTION_LAWS)
"""Laws of restitution in words."""

OUTCOMES: Mapping[int, str] = Frozen((row["code"], row["name"]) for row in _core.OUTCOMES)
"""Names of the outcomes by their codes in arrays.

`not_computed` and `invalid` are those of points without a motion.
"""

OUTCOME_LABELS: Mapping[str, str] = _labels(_core.OUTCOMES)
"""Outcomes in words."""

FINAL_OUTCOMES: frozenset[str] = frozenset(row["name"] for row in _core.OUTCOMES if row["is_final"])
"""Names of the outcomes of motions that have been followed to their end."""

CLASSES: tuple[str, ...] = tuple(row["name"] for row in _core.CLASSES)
"""Names of the classes of outcomes that maps show; their places are the codes in arrays."""

CLASS_LABELS: Mapping[str, str] = _labels(_core.CLASSES)
"""Classes in words."""

REGIONS: tuple[str, ...] = tuple(row["name"] for row in _core.REGIONS)
"""Names of the regions that a start lies in.

Their places are the codes of :meth:`littlewood.phase_plane.PhasePlane.region`.
"""

ROLLING_TYPES: tuple[str, ...] = ("", *(row["name"] for row in _core.ROLLING_TYPES))
"""Names of the types of rolling; their places are the codes in arrays, 0 for none."""
