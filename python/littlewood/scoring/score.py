"""A motion that a solver has computed, held against the exact one."""

from __future__ import annotations

import itertools
import math
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .episodes import Event, Tolerances, events, exact_episodes, recorded_episodes
from .matching import match
from .record import Record

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..trajectory import Trajectory

__all__ = ["EventScore", "Score", "score"]

_Reals = npt.NDArray[np.float64]

_CHANNELS = ("x", "y", "theta")


@dataclass(frozen=True)
class EventScore:
    """An event of the exact motion, of the solver, or of both.

    Attributes
    ----------
    kind : str
        stick, slip, reversal, lift_off, landing, or impact (between two flights).
    exact : float or None
        Its time in the exact motion, √(R/g); None for a spurious event.
    found : float or None
        Its time in the record, √(R/g); None where it was missed.
    """

    kind: str
    exact: float | None
    found: float | None

    @property
    def error(self) -> float | None:
        """How much later the solver has it, √(R/g)."""
        return None if self.exact is None or self.found is None else self.found - self.exact


@dataclass(frozen=True, eq=False)
class Score:
    """How far a record is from the exact motion. Everything is dimensionless.

    Attributes
    ----------
    motion : Trajectory
        The exact motion.
    record : Record
        The scored part of the record, up to the end of the exact motion.
    tolerances : Tolerances
        Within which a hoop counts as in contact, or as rolling.
    events : tuple of EventScore
        All events in order.
    errors : dict of ndarray
        x, y (R) and theta (rad) of the record less those of the exact motion, at the times of the record.
    energy_error : ndarray
        Energy between two instants of the record, from its differences, less that of the exact motion there, m2 g R.
    slip_while_rolling : float
        Largest way that the point of contact slides in a phase in which the exact motion rolls, R.
    penetration : float
        Largest depth of the rim under the plane, R.
    """

    motion: Trajectory
    record: Record
    tolerances: Tolerances
    events: tuple[EventScore, ...]
    errors: dict[str, _Reals]
    energy_error: _Reals
    slip_while_rolling: float
    penetration: float

    @property
    def missed(self) -> tuple[EventScore, ...]:
        """Events of the exact motion that the record does not have."""
        return tuple(event for event in self.events if event.found is None)

    @property
    def spurious(self) -> tuple[EventScore, ...]:
        """Events of the record that the exact motion does not have."""
        return tuple(event for event in self.events if event.exact is None)

    @property
    def error(self) -> _Reals:
        """Distance of the states at each instant: the largest of the errors of x, y and θ."""
        distance: _Reals = np.max(np.abs([self.errors[name] for name in _CHANNELS]), axis=0)
        return distance

    @property
    def largest_error(self) -> float:
        """Largest distance of the states."""
        return float(np.max(self.error))

    @property
    def energy_gained(self) -> float:
        """Largest energy above that of the exact motion, m2 g R; 0 if there is none."""
        return max(0.0, float(np.max(self.energy_error)))

    @property
    def between(self) -> tuple[tuple[float, float, float], ...]:
        """Largest distance of the states from one exact event to the next: begin, end, distance."""
        times = [event.exact for event in self.events if event.exact is not None]
        first, last = float(self.record.time[0]), float(self.record.time[-1])
        edges = [first, *sorted(time for time in times if first < time < last), last]
        found = []
        for begin, end in itertools.pairwise(edges):
            inside = (self.record.time >= begin) & (self.record.time <= end)
            if inside.any():
                found.append((begin, end, float(np.max(self.error[inside]))))
        return tuple(found)

    def as_dict(self) -> dict[str, Any]:
        """Return everything but the columns, as JSON can have it."""
        return {
            "tolerances": asdict(self.tolerances),
            "step": self.record.step,
            "until": float(self.record.time[-1]),
            "events": [{**asdict(event), "error": event.error} for event in self.events],
            "missed": len(self.missed),
            "spurious": len(self.spurious),
            "largest_error": {
                "state": self.largest_error,
                **{name: float(np.max(np.abs(self.errors[name]))) for name in _CHANNELS},
            },
            "error_at_end": {name: float(self.errors[name][-1]) for name in _CHANNELS},
            "between_events": [
                {"begin": begin, "end": end, "largest_error": error} for begin, end, error in self.between
            ],
            "energy": {"gained": self.energy_gained, "error_at_end": float(self.energy_error[-1])},
            "slip_while_rolling": self.slip_while_rolling,
            "penetration": self.penetration,
        }

    def plot(self) -> Figure:
        """Draw the paths of both motions, and the errors over time.

        Returns
        -------
        matplotlib.figure.Figure
        """
        from .picture import draw

        return draw(self)

    def __str__(self) -> str:
        return "\n".join(_lines(self))


def _lines(score: Score) -> list[str]:
    def time(value: float | None) -> str:
        return f"{'–' if value is None else format(value, '.6f'):>12}"

    lines = [f"{'event':10}{'exact τ':>12}{'found τ':>12}{'error':>12}"]
    for event in score.events:
        if event.error is None:
            word = "missed" if event.found is None else "is none"
        else:
            word = f"{event.error:.2e}"
        lines.append(f"{event.kind:10}{time(event.exact)}{time(event.found)}{word:>12}")
    parts = ", ".join(f"{name} {np.max(np.abs(score.errors[name])):.2e}" for name in _CHANNELS)
    lines += [
        "",
        f"largest error       {parts}",
        f"energy              gained {score.energy_gained:.2e}, error at the end {score.energy_error[-1]:.2e}",
        f"slip while rolling  {score.slip_while_rolling:.2e}",
        f"penetration         {score.penetration:.2e}",
        f"step                {score.record.step:.3g}, up to τ = {score.record.time[-1]:.6g}",
        "units (2.9): time √(R/g), length R, angle rad, energy m₂gR",
    ]
    return lines


def score(motion: Trajectory, record: Record, tolerances: Tolerances | None = None) -> Score:
    """Hold a motion that a solver has computed against the exact one.

    Parameters
    ----------
    motion : Trajectory
        The exact motion, of :meth:`littlewood.Hoop.simulate` or :meth:`littlewood.cases.Case.simulate`.
    record : Record
        The record of the solver.
    tolerances : Tolerances, optional
        Within which a hoop counts as in contact, or as rolling.

    Returns
    -------
    Score

    Raises
    ------
    ValueError
        If the record has fewer than three instants within the exact motion.

    Notes
    -----
    Only positions are compared, so that any solver can be scored. The hoop counts as in flight where the rim is higher
    than a tolerance, and as rolling where the point of contact slides more slowly than another; both are asked of the
    exact motion in the same way, so that they shift an event of both by the same. Velocities are differences of
    positions, those of the exact motion, too.
    """
    within = tolerances or Tolerances()
    part = _within(motion, record)
    samples = motion(part.time)
    exact = {"x": samples.x, "y": samples.centre_y, "theta": samples.theta}
    pairs = match(
        events(exact_episodes(motion, float(part.time[-1]), within), part.step, within),
        events(recorded_episodes(part, within), part.step, within),
        within.time,
    )
    return Score(
        motion=motion,
        record=part,
        tolerances=within,
        events=tuple(_event(one, other) for one, other in pairs),
        errors={name: np.asarray(getattr(part, name) - exact[name]) for name in _CHANNELS},
        energy_error=_energy_error(motion, part),
        slip_while_rolling=_slip_while_rolling(motion, part),
        penetration=max(0.0, float(np.max(1.0 - part.y))),
    )


def _within(motion: Trajectory, record: Record) -> Record:
    """The part of a record that the exact motion has."""
    first, last = motion.start.time, motion.end_time
    if motion.outcome.is_final and math.isfinite(last) and motion.transitions and motion.transitions[-1].to_mode:
        # It goes on for ever in its last phase.
        last = math.inf
    kept = (record.time >= first) & (record.time <= last) & np.isfinite(motion(record.time).theta)
    if np.count_nonzero(kept) < 3:
        raise ValueError(
            f"the record, from time = {record.time[0]} to {record.time[-1]} sqrt(R/g), has fewer than three instants "
            f"within the motion, from {first} to {last} sqrt(R/g)"
        )
    columns = {name: getattr(record, name)[kept] for name in ("time", *_CHANNELS)}
    return Record(**columns, contact=None if record.contact is None else record.contact[kept])


def _event(exact: Event | None, found: Event | None) -> EventScore:
    one = exact or found
    assert one is not None
    return EventScore(one.kind, exact.time if exact else None, found.time if found else None)


def _energy_error(motion: Trajectory, record: Record) -> _Reals:
    """Energy (2.8) in the middle of two instants less that of the exact motion; 0 about an impact, which has none."""
    hoop = motion.hoop
    step = np.diff(record.time)
    middle = 0.5 * (record.time[1:] + record.time[:-1])

    def energy(x: Any, y: Any, theta: Any) -> _Reals:
        centre_x, centre_y = x - hoop.h * np.sin(theta), y + hoop.h * np.cos(theta)
        square = (np.diff(centre_x) ** 2 + np.diff(centre_y) ** 2) * hoop.mass
        square += hoop.inertia_about_mass_centre * np.diff(theta) ** 2
        raised = centre_y * math.cos(hoop.slope) + centre_x * math.sin(hoop.slope)
        height = 0.5 * (raised[1:] + raised[:-1])
        result: _Reals = 0.5 * square / step**2 + hoop.mass * height
        return result

    samples = motion(record.time)
    # The same differences of the exact motion: what they leave out is in both.
    exact = energy(samples.x, samples.centre_y, samples.theta)
    found = energy(record.x, record.y, record.theta)
    hit = np.zeros(middle.size, dtype=np.bool_)
    for transition in motion.transitions:
        if transition.impact is not None:
            hit |= np.abs(middle - transition.time) <= 2.0 * record.step
    return np.where(hit, 0.0, found - exact)


def _slip_while_rolling(motion: Trajectory, record: Record) -> float:
    way = record.x + record.theta
    worst = 0.0
    for phase in motion.phases:
        if phase.mode == "rolling":
            inside = (record.time >= phase.start_time) & (record.time <= phase.end_time)
            if inside.any():
                worst = max(worst, float(np.ptp(way[inside])))
    return worst
