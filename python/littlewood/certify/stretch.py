"""What a proof consists of: the stretches of a motion that are proved to be free of events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple, Protocol

from .checker import DOWN, GAP, SLIP, TURNING, UP


class Box(NamedTuple):
    """Between two times a guard is between two values.

    It is above 0, but where its zero begins or ends a phase.
    """

    start: float
    end: float
    low: float
    high: float


class Instant(NamedTuple):
    """An enclosure of θ at a time, with the decimal logarithm of its radius."""

    time: float
    theta: float
    radius: float


@dataclass(frozen=True)
class Stretch:
    """A phase that is proved to be free of events, in the units of its certificate.

    Guards are enclosed from the start up to the time `enclosed`. Where that is not the end, rolling
    `repeats` itself from there on; or the particle of a massless hoop falls to the plane, by a
    closed form; or the hoop is at rest, and there are no guards. An endless phase has no end.
    """

    mode: str
    start: float
    enclosed: float
    end: float | None
    repeats: bool
    intervals: int
    guards: Mapping[str, list[Box]]
    tube: list[Instant]


class ProofLike(Protocol):
    """What the picture shows: :class:`littlewood.certify.Proof`, which is drawn by it."""

    @property
    def certificate(self) -> Mapping[str, Any]: ...  # noqa: D102
    @property
    def bits(self) -> int: ...  # noqa: D102
    @property
    def massless(self) -> bool: ...  # noqa: D102
    @property
    def stretches(self) -> list[Stretch]: ...  # noqa: D102
    @property
    def intervals(self) -> int: ...  # noqa: D102


QUANTITY_OF = {
    SLIP: "slip",
    TURNING: "theta_rate",
    GAP: "gap",
    UP: "normal",
    DOWN: "normal",
}
"""The quantities that have the units of guards.

Other guards have none, nor have those of friction without mass.
"""


def quantity_of(guard: str, massless: bool) -> str | None:
    """Return the quantity that has the unit of a guard, if it has one."""
    return None if massless and guard != SLIP else QUANTITY_OF.get(guard)
