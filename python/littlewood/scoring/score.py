"""A motion that a solver has computed, held against the exact one."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from .._internal.elementwise import Reals
from .._internal.terminal import printable
from .doubts import doubts, start_rates
from .episodes import Event, Tolerances, read_events
from .matching import is_same, match, may_show
from .record import Record

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ..trajectory import Trajectory

__all__ = ["EventScore", "Score", "score", "true_events"]


_CHANNELS = ("x", "y", "theta")

_LASTING = 4
"""Intervals over which energies are compared.

Energy that is higher for fewer is a jump of the positions, of which velocities are differences.
"""

_MANY = 10
"""Spurious events beyond so many are counted, not listed."""


@dataclass(frozen=True)
class EventScore:
    """An event of the exact motion, of the solver, or of both.

    Attributes
    ----------
    kind : str
        The cause of the exact transition (an `impact` is a landing that goes on in flight); of what
        only the record has stick, slip, reversal, lift_off, landing or impact.
    exact : float or None
        Time of the exact event, √(R/g); None for what is none.
    read : float or None
        Where the rule that reads the record finds it in the exact motion at the same instants: the
        floor of the reading. None where it does not.
    found : float or None
        Its time in the record, √(R/g).
    is_cut : bool
        Whether the record ends too early to tell.
    """

    kind: str
    exact: float | None
    read: float | None
    found: float | None
    is_cut: bool = False

    @property
    def error(self) -> float | None:
        """How much later the solver has it than the exact motion, √(R/g).

        Both are read in the same way.
        """
        at = self.exact if self.read is None else self.read
        return None if at is None or self.found is None else self.found - at

    @property
    def verdict(self) -> str:
        """One of found, missed, spurious, unreadable, cut, and artefact.

        Unreadable it is in the exact motion, too; an artefact is one of the reading.
        """
        if self.found is not None:
            if self.exact is not None:
                return "found"
            return "spurious" if self.read is None else "artefact"
        if self.exact is None:
            return "artefact"
        return "cut" if self.is_cut else "unreadable" if self.read is None else "missed"


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
        x, y (R) and theta (rad) of the record less those of the exact motion, at the times of the
        record.
    energy_error : ndarray
        Energy of the record less that of the exact motion, m2 g R: at its instants if it has rates,
        otherwise between two of them, by differences of both motions.
    slip_while_rolling : float
        Largest way that the point of contact slides in a phase in which the exact motion rolls, R.
    penetration : float
        Largest depth of the rim under the plane, R.
    doubts : tuple of str
        What looks like a mistake of the record rather than of the solver: a sign, a unit, another
        case.
    """

    motion: Trajectory
    record: Record
    tolerances: Tolerances
    events: tuple[EventScore, ...]
    errors: dict[str, Reals]
    energy_error: Reals
    slip_while_rolling: float
    penetration: float
    doubts: tuple[str, ...] = ()

    @property
    def missed(self) -> tuple[EventScore, ...]:
        """Events of the exact motion that can be read in it, and that the record does not have."""
        return tuple(event for event in self.events if event.verdict == "missed")

    @property
    def spurious(self) -> tuple[EventScore, ...]:
        """Events of the record that the exact motion does not have."""
        return tuple(event for event in self.events if event.verdict == "spurious")

    @property
    def error(self) -> Reals:
        """Distance of the states at each instant: the largest of the errors of x, y and θ."""
        distance: Reals = np.max(np.abs([self.errors[name] for name in _CHANNELS]), axis=0)
        return distance

    @property
    def largest_error(self) -> float:
        """Largest distance of the states."""
        return float(np.max(self.error))

    @property
    def energy_gained(self) -> float:
        """Largest energy above that of the exact motion for four intervals or longer, m2 g R.

        0 if there is none.
        """
        count = min(_LASTING, self.energy_error.size)
        lasting = np.lib.stride_tricks.sliding_window_view(self.energy_error, count).min(axis=1)
        return max(0.0, float(np.max(lasting)))

    @property
    def beyond_rates(self) -> float | None:
        """Largest way (R, rad) of x, y or θ that the rates of the record do not account for.

        From one instant to the next a coordinate moves with a rate between those at both, whatever
        the scheme; what it moves beyond is added up. None for a record without rates.
        """
        if self.record.rates is None:
            return None
        step, worst = np.diff(self.record.time), 0.0
        for name, rate in zip(_CHANNELS, self.record.rates, strict=True):
            moved = np.diff(getattr(self.record, name))
            at = rate[1:] * step, rate[:-1] * step
            beyond = moved - np.clip(moved, np.minimum(*at), np.maximum(*at))
            worst = max(worst, float(np.max(np.abs(np.cumsum(beyond)))))
        return worst

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
            "units": None if self.motion.hoop.units is None else asdict(self.motion.hoop.units),
            "doubts": list(self.doubts),
            "events": [
                {**asdict(event), "error": event.error, "verdict": event.verdict}
                for event in self.events
            ],
            "missed": len(self.missed),
            "spurious": len(self.spurious),
            "largest_error": {
                "state": self.largest_error,
                **{name: float(np.max(np.abs(self.errors[name]))) for name in _CHANNELS},
            },
            "error_at_end": {name: float(self.errors[name][-1]) for name in _CHANNELS},
            "between_events": [
                {"begin": begin, "end": end, "largest_error": error}
                for begin, end, error in self.between
            ],
            "energy": {"gained": self.energy_gained, "error_at_end": float(self.energy_error[-1])},
            "slip_while_rolling": self.slip_while_rolling,
            "penetration": self.penetration,
            "beyond_rates": self.beyond_rates,
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
        return printable("\n".join(_lines(self)))


def _lines(score: Score) -> list[str]:
    units = score.motion.hoop.units
    second, metre, joule = (
        (1.0, 1.0, 1.0) if units is None else (units.time_s, units.length_m, units.energy_j)
    )

    def time(value: float | None) -> str:
        return f"{'–' if value is None else format(value * second, '.6f'):>12}"

    lines = [f"{'event':10}{'exact':>12}{'read there':>12}{'found':>12}{'error':>13}"]
    are_many = len(score.spurious) > _MANY
    for event in score.events:
        if are_many and event.verdict == "spurious":
            continue
        word = (
            event.verdict
            if event.error is None or event.exact is None
            else f"{event.error * second:.2e}"
        )
        lines.append(
            f"{event.kind:10}{time(event.exact)}{time(event.read)}{time(event.found)}{word:>13}"
        )
    if are_many:
        lines += _summarised(score, second)
    sizes = {
        name: np.max(np.abs(score.errors[name])) * (1.0 if name == "theta" else metre)
        for name in _CHANNELS
    }
    lines += [
        "",
        f"largest error       {', '.join(f'{name} {size:.2e}' for name, size in sizes.items())}",
        f"energy              gained {score.energy_gained * joule:.2e}, "
        f"error at the end {score.energy_error[-1] * joule:.2e}",
        f"slip while rolling  {score.slip_while_rolling * metre:.2e}",
        f"penetration         {score.penetration * metre:.2e}",
        f"step                {score.record.step * second:.3g}, up to "
        f"{score.record.time[-1] * second:.6g}",
        f"units               "
        f"{'s, m, rad, J' if units else '(2.9): time √(R/g), length R, angle rad, energy m₂gR'}",
    ]
    if score.beyond_rates is not None:
        lines.insert(-2, f"moved beyond rates  {score.beyond_rates:.2e} R or rad")
    return lines


def _summarised(score: Score, second: float) -> list[str]:
    """Spurious events by kind, and whether noise of the positions explains them."""
    lines = []
    for kind in dict.fromkeys(event.kind for event in score.spurious):
        times = [
            event.found
            for event in score.spurious
            if event.kind == kind and event.found is not None
        ]
        span = f"from {min(times) * second:.6g} to {max(times) * second:.6g}"
        lines.append(f"{kind:10}{len(times):>12} times {span}, spurious")
    noise = slip_noise(score.record)
    if noise > score.tolerances.slip:
        lines.append(
            f"The slip velocity has noise of about {noise:.1e} √(gR), above the tolerance "
            f"{score.tolerances.slip:g}: "
            "rounded or noisy positions at so short a step. Give velocities, fewer rows, or a "
            "larger --slip."
        )
    return lines


def slip_noise(record: Record) -> float:
    """Return the size of the noise of the slip velocity, √(gR).

    From differences that a smooth motion has not.
    """
    slip = record.slip_between
    if slip.size < _LASTING:
        return 0.0
    # Third differences of white noise have the variance 20, first ones 2; a median over 0.6745 is a
    # deviation.
    return float(np.median(np.abs(np.diff(slip, 2))) / 0.6745 * math.sqrt(2.0 / 20.0))


def score(
    motion: Trajectory,
    record: Record,
    tolerances: Tolerances | None = None,
    *,
    events: Sequence[tuple[str, float]] | None = None,
) -> Score:
    """Hold a motion that a solver has computed against the exact one.

    Parameters
    ----------
    motion : Trajectory
        The exact motion, of :meth:`littlewood.Hoop.simulate` or
        :meth:`littlewood.cases.Case.simulate`.
    record : Record
        The record of the solver.
    tolerances : Tolerances, optional
        Within which a hoop counts as in contact, or as rolling.
    events : sequence of (str, float), optional
        Cause and time, √(R/g), of the exact events, such as those of a certificate; by default
        those of `motion`.

    Returns
    -------
    Score

    Raises
    ------
    ValueError
        If the record has fewer than three instants within the exact motion.

    Notes
    -----
    Events are read from positions, which every solver has, and from the flags of contact and
    the rates that it gives. The hoop counts as in flight where the rim is higher than a
    tolerance, and as rolling where the point of contact slides more slowly than another. The
    exact motion is read in the same way at the same instants: what can't be read there is held
    against no solver, and the error of an event is that of the solver alone.
    """
    within = tolerances or Tolerances()
    true = list(true_events(motion) if events is None else (Event(*one) for one in events))
    doubtful = tuple(doubts(motion, record))
    part, longer = _parts(motion, record, within, doubtful)
    samples = motion(part.time)
    exact = {"x": samples.x, "y": samples.centre_y, "theta": samples.theta}
    return Score(
        motion=motion,
        record=part,
        tolerances=within,
        events=tuple(
            _held(
                true,
                read_events(_exactly(motion, longer), within),
                longer,
                within,
                _landing(motion),
            )
        ),
        errors={name: np.asarray(getattr(part, name) - exact[name]) for name in _CHANNELS},
        energy_error=_energy_error(motion, part),
        slip_while_rolling=_slip_while_rolling(motion, part),
        penetration=max(0.0, float(np.max(1.0 - part.y))),
        doubts=doubtful,
    )


def true_events(motion: Trajectory) -> list[Event]:
    """Return the transitions of a motion; a landing that goes on in flight is an impact."""
    return [
        Event(
            "impact" if one.cause == "landing" and one.to_mode == "flight" else one.cause, one.time
        )
        for one in motion.transitions
    ]


def _held(
    true: list[Event], read: list[Event], record: Record, within: Tolerances, landing: float | None
) -> Iterator[EventScore]:
    """The events of the exact motion, of its reading, and of the record."""
    found = read_events(record, within)
    if landing is not None:
        # The motion ends there, and what the solver goes on with is not judged.
        read, found = (_up_to_landing(some, landing - within.time) for some in (read, found))
    last = float(record.time[-1])
    known = match(
        [one for one in true if one.time <= last + within.time], read, within.time, may_show
    )
    # Of an event that is not read its true time is all that there is.
    places = [seen or one for one, seen in known]
    at = {id(place): pair for place, pair in zip(places, known, strict=True)}

    def may_be(place: Event, mine: Event) -> bool:
        one, seen = at[id(place)]
        if seen is None:
            return may_show(place, mine)
        return is_same(seen, mine, one and one.kind)

    for place, mine in match([place for place in places if place], found, within.time, may_be):
        one, seen = at[id(place)] if place is not None else (None, None)
        if one is None and seen is not None and mine is None:
            continue
        kind = (one or seen or mine).kind  # type: ignore[union-attr]
        is_cut = mine is None and place is not None and place.time > last - within.time
        yield EventScore(kind, one and one.time, seen and seen.time, mine and mine.time, is_cut)


def _up_to_landing(events: list[Event], earliest: float) -> list[Event]:
    """Events up to the first landing that may be the one that ends the motion."""
    for at, event in enumerate(events):
        if event.kind in ("landing", "impact") and event.time >= earliest:
            return [*events[:at], Event("landing", event.time)]
    return events


def _landing(motion: Trajectory) -> float | None:
    """When the motion ends by landing, if it does."""
    last = motion.transitions[-1] if motion.transitions else None
    return last.time if last is not None and last.cause == "landing" and not last.to_mode else None


def _parts(
    motion: Trajectory, record: Record, within: Tolerances, doubtful: tuple[str, ...]
) -> tuple[Record, Record]:
    """The part of a record that the exact motion has, and that which may have its events."""
    first, last = motion.start.time, motion.end_time
    if (
        motion.outcome.is_final
        and math.isfinite(last)
        and motion.transitions
        and motion.transitions[-1].to_mode
    ):
        # It goes on for ever in its last phase.
        last = math.inf
    is_inside = (
        (record.time >= first) & (record.time <= last) & np.isfinite(motion(record.time).theta)
    )
    if np.count_nonzero(is_inside) < 3:
        raise ValueError(
            f"the record, from time = {record.time[0]} to {record.time[-1]} sqrt(R/g), has fewer "
            f"than three instants "
            f"within the motion, from {first} to {last} "
            f"sqrt(R/g){''.join(f'; {doubt}' for doubt in doubtful)}"
        )
    landing = _landing(motion)
    is_behind = (record.time > last) & (record.time <= last + within.time) & (landing is not None)
    return record.kept(is_inside), record.kept(is_inside | is_behind)


def _exactly(motion: Trajectory, record: Record) -> Record:
    """The exact motion as a record with the instants and columns of another.

    Behind its landing the hoop rests.
    """
    samples = motion(np.minimum(record.time, motion.end_time))
    x, y, theta = (np.array(samples[name]) for name in ("x", "centre_y", "theta"))
    is_behind = record.time > motion.end_time
    y[is_behind] = 1.0
    is_high = np.asarray(samples.is_in("flight")) & ~is_behind
    rates: tuple[Reals, Reals, Reals] | tuple[None, None, None] = (None, None, None)
    if record.rates is not None:
        at = np.array(samples.theta_rate), np.array(samples.slip), np.array(samples.gap_rate)
        for column in at:
            column[is_behind] = 0.0
        rates = exact = at[1] - at[0], at[2], at[0]
        before = start_rates(motion)
        mine, after = (np.array(some)[:, 0] for some in (record.rates, exact))
        is_start = record.time[0] == motion.start.time
        if is_start and math.dist(mine, before) < math.dist(mine, after):
            # What changes at once is not yet in a record whose first row is the start.
            for column, rate in zip(exact, before, strict=True):
                column[0] = rate
    return Record(record.time, x, y, theta, None if record.contact is None else ~is_high, *rates)


def _energy_error(motion: Trajectory, record: Record) -> Reals:
    """Energy (2.8) less that of the exact motion.

    0 about an impact, where it depends on the instant.
    """
    exact = _exactly(motion, record)
    # The same differences of the exact motion: what they leave out is in both.
    time, error = record.time, _energy(motion, record) - _energy(motion, exact)
    if record.rates is None:
        time = 0.5 * (time[1:] + time[:-1])
    hit = np.zeros(time.size, dtype=np.bool_)
    for transition in motion.transitions:
        if transition.impact is not None:
            hit |= np.abs(time - transition.time) <= 2.0 * record.step
    return np.where(hit, 0.0, error)


def _energy(motion: Trajectory, record: Record) -> Reals:
    """Energy at the instants of a record with rates, between those of one without."""
    hoop = motion.hoop
    sin, cos = np.sin(record.theta), np.cos(record.theta)
    centre_x, centre_y = record.x - hoop.h * sin, record.y + hoop.h * cos
    raised = centre_y * math.cos(hoop.slope) + centre_x * math.sin(hoop.slope)
    if record.rates is None:
        step = np.diff(record.time)
        along, up, turning = (
            np.diff(values) / step for values in (centre_x, centre_y, record.theta)
        )
        raised = 0.5 * (raised[1:] + raised[:-1])
    else:
        x_rate, y_rate, turning = record.rates
        along, up = x_rate - hoop.h * cos * turning, y_rate - hoop.h * sin * turning
    kinetic = hoop.mass * (along**2 + up**2) + hoop.inertia_about_mass_centre * turning**2
    energy: Reals = 0.5 * kinetic + hoop.mass * raised
    return energy


def _slip_while_rolling(motion: Trajectory, record: Record) -> float:
    way = record.x + record.theta
    worst = 0.0
    for phase in motion.phases:
        if phase.mode == "rolling":
            inside = (record.time >= phase.start_time) & (record.time <= phase.end_time)
            if inside.any():
                worst = max(worst, float(np.ptp(way[inside])))
    return worst
