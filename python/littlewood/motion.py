"""The parts of a motion: states, phases, transitions, outcome."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

from . import _core
from ._internal.elementwise import real
from ._internal.terminal import printable
from .tables import FINAL_OUTCOMES, IMPACT_LABELS, OUTCOME_LABELS, START

__all__ = [
    "EDGES",
    "ClassAt",
    "Classification",
    "ContactVelocities",
    "Edge",
    "Impact",
    "Impulse",
    "Outcome",
    "Phase",
    "RollingEnd",
    "Start",
    "State",
    "Threshold",
    "Transition",
]


@dataclass(frozen=True)
class State:
    """The state of the body at an instant. In flight `slip` is that of a landing there.

    Attributes
    ----------
    time : float
        Time τ, √(R/g).
    theta : float
        Angle θ of the particle from the upward vertical, counterclockwise, not reduced; rad.
    theta_rate : float
        Rate θ′, √(g/R).
    slip : float
        Slip velocity η′ of the contact point (2.7), √(gR).
    x : float
        Position of the geometric centre along the plane, R.
    """

    time: float
    theta: float
    theta_rate: float
    slip: float
    x: float


@dataclass(frozen=True)
class Start(State):
    """A start with the rim at the plane.

    Attributes
    ----------
    time, theta, theta_rate, slip, x : float
        As those of :class:`littlewood.motion.State`.
    gap_rate : float
        Rate at which the gap under the rim opens, zero or positive, √(gR): that of a hoop thrown
        from the plane.
    """

    gap_rate: float = 0.0

    @property
    def numbers(self) -> list[float]:
        """The numbers of a start, as the core takes them."""
        return [real(getattr(self, name), name) for name in START]


@dataclass(frozen=True)
class Phase:
    """A phase of motion in one mode.

    Attributes
    ----------
    mode : str
        Mode of motion, one of :data:`littlewood.tables.MODES`.
    direction : {-1, 0, 1}
        Sign of the slip velocity; 0 for rolling, rest and flight.
    start : State
        State at the start.
    end : State or None
        State at the end; None for an endless phase.
    energy_start : float
        Energy at the start (2.8), m2 g R.
    energy_lost : float
        Energy lost to friction and rolling resistance during the phase, m2 g R, without an impact
        that ends it.
    is_small_inertia_limit : bool
        False for a glide that is not the limit of motions of a heavy hoop as its inertia vanishes.
    ended_by : int or None
        Index of the transition that ends it; None if there is none.
    """

    mode: str
    direction: int
    start: State
    end: State | None
    energy_start: float
    energy_lost: float
    is_small_inertia_limit: bool
    ended_by: int | None

    @property
    def start_time(self) -> float:
        """Time at the start, √(R/g)."""
        return self.start.time

    @property
    def end_time(self) -> float:
        """Time at the end, √(R/g); infinite for an endless phase."""
        return math.inf if self.end is None else self.end.time

    @property
    def duration(self) -> float:
        """Duration, √(R/g)."""
        return self.end_time - self.start_time


class Impulse(NamedTuple):
    """The impulse of the plane on the body in an impact, m2 √(gR).

    `normal` upwards, `friction` along E1.
    """

    normal: float
    friction: float


class ContactVelocities(NamedTuple):
    """The velocities that an impact changes.

    They are θ′ in √(g/R), and η′ and the rate of the gap in √(gR).
    """

    theta_rate: float
    slip: float
    gap_rate: float


@dataclass(frozen=True)
class Impact:
    """An impact, or the sum of those by which a hoop settles.

    Attributes
    ----------
    case : str
        Course of the slip, one of :data:`littlewood.tables.IMPACT_CASES`.
    before, after : ContactVelocities
        Velocities on either side.
    impulse : Impulse
        Impulse of the plane on the body, m2 √(gR).
    normal_work, friction_work : float
        Works of the two parts of the impulse, m2 g R.
    resistance_work : float
        Work of the couple of rolling resistance, m2 g R; zero or negative.
    energy_lost : float
        Energy lost, m2 g R. Negative where Newton's law gains energy.
    gains_energy : bool
        Whether the law has gained energy, by more than rounding, which only Newton's can.
    """

    case: str
    before: ContactVelocities
    after: ContactVelocities
    impulse: Impulse
    normal_work: float
    friction_work: float
    resistance_work: float
    energy_lost: float
    gains_energy: bool

    @property
    def label(self) -> str:
        """The case in words."""
        return IMPACT_LABELS[self.case]


@dataclass(frozen=True)
class Transition:
    """A change of the mode of motion, or the event that ends the simulation.

    Attributes
    ----------
    state : State
        State just before.
    after : State
        State just after: the same, unless there is an impact.
    impact : Impact or None
        The impact, if the velocities jump; for `settle` the sum of those of all bounces.
    from_mode : str or None
        Mode that ends; None where a hoop jams without a consistent motion before.
    to_mode : str or None
        Mode that begins; None where the motion ends.
    direction : {-1, 0, 1}
        Sign of the slip velocity of the motion that begins.
    cause : str
        Event, one of :data:`littlewood.tables.CAUSES`.
    """

    state: State
    after: State
    impact: Impact | None
    from_mode: str | None
    to_mode: str | None
    direction: int
    cause: str

    @property
    def time(self) -> float:
        """Time τ, √(R/g)."""
        return self.state.time


@dataclass(frozen=True)
class Outcome:
    """How a motion ended.

    Attributes
    ----------
    kind : str
        Name, one of :data:`littlewood.tables.OUTCOMES`.
    state : State
        State at the end, or at the start of an endless phase.
    details : mapping
        More data: `gap_rate` of a landing; `half_swings` before rest; `recurrence`, `period`,
        `theta_min`, `theta_max`, `theta_limit` of an endless motion, and of the orbit that one with
        `slips_forever` approaches; of that orbit `grazing_energy`, `grazing_theta` and
        `grazing_theta_rate`, and `slips_to_halve` its distance; `theta_gained` and `transitions` in
        the period of a periodic one; `transitions` at their limit; `consistent`, `rolling_normal`,
        `rolling_friction`, `contact`, `solvability_negative`, `solvability_positive` where no
        motion or several are consistent, and `resisted_denominator` where a jam is one of them;
        `solvability` of a singular slide; what an unresolved motion depends on: `compared`, its
        `value` and the `bound` of its rounding, or of its range.
    sentence : str
        The end in words.
    """

    kind: str
    state: State
    details: Mapping[str, Any]
    sentence: str

    @property
    def is_final(self) -> bool:
        """Whether the motion ended, rather than reached a limit."""
        return self.kind in FINAL_OUTCOMES

    @property
    def label(self) -> str:
        """The kind in words."""
        return OUTCOME_LABELS[self.kind]

    @property
    def period(self) -> float | None:
        """Period of an endless motion, √(R/g); None if it has none."""
        period: float | None = self.details.get("period")
        return period

    def __str__(self) -> str:
        return printable(self.sentence)


class RollingEnd(NamedTuple):
    """How rolling ends: the time until then, √(R/g), θ and θ′ there, and the cause."""

    elapsed: float
    theta: float
    theta_rate: float
    cause: str


@dataclass(frozen=True)
class Classification:
    """The region of a start, and the motion that begins.

    Attributes
    ----------
    region : str
        One of :data:`littlewood.tables.REGIONS`.
    mode : str or None
        Mode that begins, if exactly one is consistent.
    direction : {-1, 0, 1}
        Sign of the slip velocity that begins.
    energy : float
        Energy (2.8), m2 g R.
    rolling_normal, rolling_friction : float
        N and F that rolling would need (2.12), or rest where rolling resistance holds the angle,
        m2 g.
    contact : float
        1 − h cos θ θ′²: negative where the body leaves the plane.
    rolling_type : str or None
        "I", "II" or "III" for Littlewood's hoop in R (section 3a). None with rolling resistance.
    rolling_end : littlewood.motion.RollingEnd or None
        How rolling ends, if it does. None with rolling resistance.
    reverse_chatter : float or None
        Ratio of successive bounces, if bounces can grow out of rolling: on a slope, with
        restitution.
    details : mapping
        As those of :class:`Outcome`, for a start that rolls for ever or is undecided.
    """

    region: str
    mode: str | None
    direction: int
    energy: float
    rolling_normal: float
    rolling_friction: float
    contact: float
    rolling_type: str | None
    rolling_end: RollingEnd | None
    reverse_chatter: float | None
    details: Mapping[str, Any]


class ClassAt(NamedTuple):
    """A value of a quantity, and the class of its motion: a name of `lw.tables.CLASSES`."""

    value: float
    class_name: str


@dataclass(frozen=True)
class Threshold:
    """Where the class of a motion changes with a quantity: two neighbouring numbers.

    Attributes
    ----------
    quantity : str
        Name of the quantity.
    below, above : littlewood.motion.ClassAt
        The last number of the one class and the first of the other.
    has_unresolved_between : bool
        Whether there are numbers between them where rounding decides.
    text : str
        The same in words.
    """

    quantity: str
    below: ClassAt
    above: ClassAt
    has_unresolved_between: bool
    text: str


@dataclass(frozen=True)
class Edge:
    """An edge of the automaton.

    Attributes
    ----------
    body : {"heavy", "massless"}
        Bodies that have it.
    from_mode : str or None
        Mode that ends; None where no motion was consistent.
    cause : str
        Event.
    guard : str
        Condition, in the symbols of the paper.
    reset : str
        Values set at the transition; everything else is continuous.
    to_mode : str or None
        Mode that begins; None where the simulation ends.
    source : str
        Place in the paper.
    """

    body: str
    from_mode: str | None
    cause: str
    guard: str
    reset: str
    to_mode: str | None
    source: str


EDGES: tuple[Edge, ...] = tuple(Edge(**edge) for edge in _core.edges())
"""All edges of the automaton; no motion takes another."""
