"""What pictures and pages ask of hoops and motions.

Types, so that they need not import what shows itself.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy.typing as npt

from .motion import Outcome, Phase, Start, Transition
from .samples import Samples
from .units import Units


class HoopLike(Protocol):
    """A hoop: :class:`littlewood.Hoop`."""

    @property
    def offset(self) -> float:
        """Distance of the particle from the centre, R."""

    @property
    def h(self) -> float:
        """Distance of the mass centre from the centre, R."""

    @property
    def slope(self) -> float:
        """Angle by which the plane rises to the right, rad."""

    @property
    def restitution_law(self) -> str | None:
        """Law of restitution, if it has one."""

    @property
    def units(self) -> Units | None:
        """Its units, if it has some."""

    @property
    def attributes(self) -> dict[str, float | str]:
        """Parameters by name."""

    @property
    def _given(self) -> tuple[list[float | None], str | None]:
        """The hoop as the core takes it."""


class MotionLike(Protocol):
    """A motion: :class:`littlewood.Trajectory`."""

    @property
    def hoop(self) -> HoopLike:
        """Its hoop."""

    @property
    def start(self) -> Start:
        """Its start."""

    @property
    def phases(self) -> Sequence[Phase]:
        """Its phases."""

    @property
    def transitions(self) -> Sequence[Transition]:
        """Its transitions."""

    @property
    def outcome(self) -> Outcome:
        """How it ended."""

    @property
    def sequence(self) -> str:
        """The phases, one letter each."""

    @property
    def shown_until(self) -> float:
        """Time up to which it is shown, √(R/g)."""

    def __call__(self, times: npt.ArrayLike) -> Samples:
        """Return instants."""

    def sample(self, count: int) -> Samples:
        """Return evenly spaced instants."""
