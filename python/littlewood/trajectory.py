"""A simulated motion."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
import numpy.typing as npt

from . import _core
from ._frozen import Frozen
from ._html import page_html
from ._internal import derivatives
from ._internal.counts import checked_count, checked_limits
from ._internal.elementwise import flat, real, reals
from ._internal.extras import require
from ._internal.terminal import printable
from ._internal.variables import CONVENTIONS
from .motion import ContactVelocities, Impact, Impulse, Outcome, Phase, Start, State, Transition
from .samples import Samples
from .tables import CAUSES, IMPACT_CASES, MODES, SAMPLE_COLUMNS, SampleColumn

if TYPE_CHECKING:
    import pandas
    import xarray
    from matplotlib.figure import Figure

    from .hoop import Hoop
    from .plot.animation import Animation

__all__ = ["Trajectory"]


class Trajectory:
    """A motion: its phases, transitions, outcome, and the state at any time.

    :meth:`littlewood.Hoop.simulate` makes it.

    Examples
    --------
    >>> import littlewood as lw
    >>> motion = lw.case("figure-3").simulate()
    >>> motion.sequence, motion.outcome.kind
    ('-R+F', 'landing')
    >>> motion([0.0, 0.7]).mode_names.tolist()
    ['sliding', 'rolling']

    With a coefficient of restitution it continues after the landing:

    >>> motion = lw.case("figure-3-bounces").simulate()
    >>> motion.outcome.kind, motion.transitions[-1].cause
    ('rolls_forever', 'settle')
    """

    def __init__(
        self,
        hoop: Hoop,
        start: Start,
        until: float | None,
        max_transitions: int,
        max_slides: int,
        proof: str,
    ) -> None:
        counts = checked_limits(max_transitions, max_slides)
        until = None if until is None else real(until, "until")
        self._hoop = hoop
        self._start = start
        self._until = until
        self._counts = counts
        self._proof = proof
        self._core = _core.simulate(hoop._given, start.numbers, until, *counts, proof)

    def __reduce__(self) -> tuple[Any, ...]:
        return Trajectory, (self._hoop, self._start, self._until, *self._counts, self._proof)

    @property
    def hoop(self) -> Hoop:
        """The hoop."""
        return self._hoop

    @property
    def start(self) -> Start:
        """The start."""
        return self._start

    @property
    def until(self) -> float | None:
        """Given time limit, √(R/g)."""
        return self._until

    @cached_property
    def phases(self) -> tuple[Phase, ...]:
        """The phases in order.

        Empty where no motion, or more than one, is consistent at the start.
        """
        return tuple(
            Phase(
                mode=one["mode"],
                direction=one["direction"],
                start=State(**one["start"]),
                end=None if one["end"] is None else State(**one["end"]),
                energy_start=one["energy_start"],
                energy_lost=one["energy_lost"],
                is_small_inertia_limit=one["is_small_inertia_limit"],
                ended_by=one["ended_by"],
            )
            for one in self._core.phases()
        )

    @cached_property
    def transitions(self) -> tuple[Transition, ...]:
        """The transitions in order.

        Each ends a phase, except a jam without a consistent motion before; :meth:`end_of` finds
        that of a phase.
        """
        return tuple(
            Transition(
                state=State(**one["before"]),
                after=State(**one["after"]),
                impact=None if one["impact"] is None else _impact(one["impact"]),
                from_mode=one["from_mode"],
                to_mode=one["to_mode"],
                direction=one["direction"],
                cause=one["cause"],
            )
            for one in self._core.transitions()
        )

    def end_of(self, phase: Phase) -> Transition | None:
        """Return the transition that ends a phase.

        None for the last of a stopped or endless motion.
        """
        return None if phase.ended_by is None else self.transitions[phase.ended_by]

    def impacts(self) -> pandas.DataFrame:
        """Return the impacts as a table, one row each.

        The index is that of :attr:`transitions`. Columns: `time`, √(R/g); `cause` (`landing`,
        `settle` or `jam`), `case` and `to`, the mode that begins, as categories; `theta`, rad;
        `theta_rate`, √(g/R), `slip` and `gap_rate`, √(gR), each with `_before` and `_after`;
        `normal_impulse` upwards and `friction_impulse` along E1, m2 √(gR); `energy_lost`, m2 g R,
        which is negative where Newton's law gains energy. The bounces by which a hoop settles are
        one row, that of `settle`.

        Returns
        -------
        pandas.DataFrame
        """
        pd = require("pandas")
        found = [
            (i, one, one.impact) for i, one in enumerate(self.transitions) if one.impact is not None
        ]
        table: dict[str, Any] = {
            "time": [one.time for _, one, _ in found],
            "cause": pd.Categorical([one.cause for _, one, _ in found], categories=list(CAUSES)),
            "case": pd.Categorical(
                [impact.case for *_, impact in found], categories=list(IMPACT_CASES)
            ),
            "to": pd.Categorical([one.to_mode for _, one, _ in found], categories=list(MODES)),
            "theta": [one.state.theta for _, one, _ in found],
        }
        for side in ("before", "after"):
            for name in ContactVelocities._fields:
                table[f"{name}_{side}"] = [
                    getattr(getattr(impact, side), name) for *_, impact in found
                ]
        for name in Impulse._fields:
            table[f"{name}_impulse"] = [getattr(impact.impulse, name) for *_, impact in found]
        table["energy_lost"] = [impact.energy_lost for *_, impact in found]
        index = pd.Index([i for i, *_ in found], name="transition", dtype=np.int64)
        frame: pandas.DataFrame = pd.DataFrame(table, index=index)
        return frame

    @cached_property
    def outcome(self) -> Outcome:
        """How the motion ended."""
        end = self._core.outcome()
        return Outcome(
            kind=end["kind"],
            state=State(**end["state"]),
            details=Frozen(end["details"]),
            sentence=end["sentence"],
        )

    @property
    def sequence(self) -> str:
        """The phases, one letter each.

        R rolling; + and - sliding with positive and negative slip velocity; g, n and G gliding with
        positive, negative and without slip velocity; F flight; 0 rest; S and s skidding with
        positive and negative slip velocity; … where there are more than 15.
        """
        return self._core.sequence()

    @property
    def end_time(self) -> float:
        """Time at which the motion ends, √(R/g); infinite if it is endless."""
        return self._core.end_time()

    @property
    def energy_lost(self) -> float:
        """Energy lost, m2 g R: to friction, to rolling resistance, and in impacts."""
        return self._core.energy_lost()

    @property
    def rolling_resistance_energy_lost(self) -> float:
        """Energy lost to rolling resistance, m2 g R, without its part in impacts."""
        return self._core.rolling_resistance_energy_lost()

    @property
    def impact_energy_lost(self) -> float:
        """Energy lost in impacts, m2 g R."""
        return self._core.impact_energy_lost()

    def __call__(
        self, times: npt.ArrayLike, *, side: Literal["after", "before"] = "after"
    ) -> Samples:
        """Return the motion at some times, as the dense output of a SciPy solver does.

        ``motion(t)``.

        Parameters
        ----------
        times : array_like
            Times τ, √(R/g): one, or an array of any shape.
        side : {"after", "before"}, optional
            Which side of a transition it is where a time is that of one, to the last bit: the first
            instant of the motion that begins, or the last of the motion that ends. Forces may jump
            there, and velocities in an impact.

        Returns
        -------
        Samples
            Of the same shape, with everything by name: ``motion(t).theta``. Before the start and
            after the end `mode` is -1 and the rest NaN. The start and the end have one side only;
            but for a start that jams, before which no motion is consistent: `mode` is -1 and forces
            are NaN.

        Examples
        --------
        >>> import littlewood as lw
        >>> motion = lw.case("lands-and-rolls").simulate()
        >>> landing = motion.impacts().time.iloc[0]
        >>> [str(motion(landing, side=side).mode_names) for side in ("before", "after")]
        ['flight', 'rolling']
        """
        if side not in ("after", "before"):
            raise ValueError(f"side = {side!r} must be 'after' or 'before'")
        return Samples(self._core.at(flat(reals(times)), side == "before"), np.shape(times))

    def sample(self, count: int = 1001, until: float | None = None) -> Samples:
        """Return evenly spaced instants, and both sides of each transition in between.

        Parameters
        ----------
        count : int, optional
            Number of evenly spaced instants, 2 to 10⁷.
        until : float, optional
            Last time, √(R/g); by default the end of the motion, or two periods of an endless one.

        Returns
        -------
        Samples
            Of shape (n,). A transition appears twice, as the last instant of the phase that ends
            and as the first of the phase that begins, because forces may jump there, and velocities
            in an impact.
        """
        number = checked_count("count", count, **_core.SAMPLE_COUNTS)
        if until is None:
            until = self.shown_until
        until = real(until, "until")
        if not (math.isfinite(until) and until >= self.start.time):
            bound = f"a finite number not less than time = {self.start.time} sqrt(R/g)"
            raise ValueError(f"until = {until} sqrt(R/g) must be {bound}")
        return Samples(self._core.sample_evenly(number, until))

    @property
    def shown_until(self) -> float:
        """Time up to which plots and tables show the motion by default, √(R/g)."""
        return self._core.shown_until()

    def _instants(self, times: npt.ArrayLike | None, count: int) -> Samples:
        return self.sample(count) if times is None else self(np.atleast_1d(reals(times)))

    def to_xarray(
        self, times: npt.ArrayLike | None = None, *, count: int = 1001, si: bool = False
    ) -> xarray.Dataset:
        """Return instants of the motion as a data set with units and long names.

        Parameters
        ----------
        times : array_like, optional
            Times τ, √(R/g), of shape (n,). By default evenly spaced ones and both sides of each
            transition.
        count : int, optional
            Number of evenly spaced instants.
        si : bool, optional
            Whether the values should be in SI units, with the unit in each name; `times` are
            dimensionless anyway.

        Returns
        -------
        xarray.Dataset
            Of dimension `time` (or `time_s`).
        """
        xr = require("xarray")
        samples = self._instants(times, count)
        columns: Mapping[str, Any] = samples.in_si(self.hoop.require_units()) if si else samples
        variables = dict(_attributes(column, si) for column in SAMPLE_COLUMNS.values())
        time, _ = _attributes(SAMPLE_COLUMNS["time"], si)
        dataset: xarray.Dataset = xr.Dataset(
            {name: (time, columns[name], attributes) for name, attributes in variables.items()},
            attrs={
                "Conventions": CONVENTIONS,
                "title": "motion of Littlewood's hoop",
                "source": f"littlewood {_core.__version__}",
                "sequence": self.sequence,
                "outcome": self.outcome.kind,
                **self.hoop.attributes,
            },
        )
        with_time: xarray.Dataset = dataset.set_coords(time)
        return with_time

    def to_pandas(
        self, times: npt.ArrayLike | None = None, *, count: int = 1001, si: bool = False
    ) -> pandas.DataFrame:
        """Return instants of the motion as a table, with the columns of the command line's CSV.

        Parameters
        ----------
        times, count, si
            As in :meth:`to_xarray`.

        Returns
        -------
        pandas.DataFrame
            One row an instant; `mode` is a category.
        """
        pd = require("pandas")
        samples = self._instants(times, count)
        table: dict[str, Any] = dict(samples.in_si(self.hoop.require_units()) if si else samples)
        table["mode"] = pd.Categorical.from_codes(
            np.asarray(samples["mode"]), categories=list(MODES)
        )
        frame: pandas.DataFrame = pd.DataFrame(table)
        return frame

    def to_csv(
        self,
        path: str | Path | None = None,
        times: npt.ArrayLike | None = None,
        *,
        count: int = 1001,
        si: bool = False,
    ) -> str | None:
        """Write instants as comma-separated values, with the columns of :meth:`to_pandas`.

        Parameters
        ----------
        path : str or Path, optional
            The file; without one the text is returned.
        times, count, si : optional
            As those of :meth:`to_pandas`.

        Returns
        -------
        str or None
        """
        text: str | None = self.to_pandas(times, count=count, si=si).to_csv(path, index=False)
        return text

    def to_json(self, path: str | Path | None = None, *, samples: int | None = None) -> str | None:
        """Write the motion as JSON: as ``littlewood simulate --format json`` does.

        Parameters
        ----------
        path : str or Path, optional
            The file; without one the text is returned.
        samples : int, optional
            Number of evenly spaced instants, 2 to 10⁷, that follow the phases; none by default.

        Returns
        -------
        str or None

        Notes
        -----
        A number reads back as the same number; what is not finite is null. Of a hoop with
        units it has SI values, too.
        """
        count = (
            None if samples is None else checked_count("samples", samples, **_core.SAMPLE_COUNTS)
        )
        text = self._core.json(count, None if self.hoop.units is None else self.hoop.units.scales)
        if path is None:
            return text
        Path(path).write_text(text, encoding="utf-8")
        return None

    def derivatives(self, quantities: Sequence[str] | None = None) -> xarray.Dataset:
        r"""Return the exact derivatives of each transition and of the outcome.

        Parameters
        ----------
        quantities : list of str, optional
            Names of quantities of the hoop and of the start, as "mu_k" or "theta_rate"; by default
            all that the motion has, and "restitution" only with a coefficient.

        Returns
        -------
        xarray.Dataset
            Of the dimensions `transition` and `quantity`: `time`, `theta`, `theta_rate`, `slip` and
            `x`, the derivatives of the time and of the state after each transition, along it; and
            `reason`. The same of the outcome with `end_` before their names, of the dimension
            `quantity`; and `period`, `theta_min` and `theta_max` of rolling for ever that swings,
            `period` of rolling that turns. Where a derivative does not exist it is NaN, and
            `reason` or `end_reason` says why: "grazing", "one_sided", "singular" or "too_long"; it
            is empty where there is one.

        Raises
        ------
        ParameterError
            For a name that is no such quantity, or "restitution" without a coefficient; `hint` has
            the names.

        See Also
        --------
        derivatives_at : At fixed times.

        Notes
        -----
        An event g(y, p) = 0 ends a phase y′ = f(y, p), and y⁺ = R(y, p) is the state after
        it. With a quantity p, and the derivative (δy)_τ at a fixed time,

        .. math:: \delta\tau = -\frac{g_y (\delta y)_\tau + g_p}{g'}, \qquad
                  \delta y = (\delta y)_\tau + y' \delta\tau, \qquad \delta y^+ = R_y\, \delta y +
                  R_p .

        They are exact to rounding: there is no step. All are dimensionless (2.9), those of a hoop
        in SI units, too: in SI units one is multiplied by the unit of what is differentiated over
        that of the quantity.

        Examples
        --------
        >>> import littlewood as lw
        >>> motion = lw.case("figure-3").simulate()
        >>> found = motion.derivatives(["mu_k", "gap_rate"])
        >>> lift_off = found.isel(transition=2)
        >>> round(float(lift_off.time.sel(quantity="mu_k")), 5), lift_off.reason.values.tolist()
        (0.05073, ['', 'one_sided'])
        """
        return derivatives.of_motion(self._core, quantities)

    def derivatives_at(
        self, times: npt.ArrayLike, quantities: Sequence[str] | None = None
    ) -> xarray.Dataset:
        r"""Return the exact derivatives of state and gap at fixed times.

        Parameters
        ----------
        times : array_like
            Times τ, √(R/g): one, or of shape (n,).
        quantities : list of str, optional
            As in :meth:`derivatives`.

        Returns
        -------
        xarray.Dataset
            Of the dimensions `time` (n, absent for one time) and `quantity`: `theta`, `theta_rate`,
            `slip`, `x`, `gap` and `reason`. At a transition they are those of the motion that
            begins. Outside the motion they are NaN with the reason "outside".

        Raises
        ------
        ParameterError
            As in :meth:`derivatives`.
        ValueError
            For times of more than one dimension.

        Notes
        -----
        After an event at τₑ with derivatives δτₑ and δy⁺ the state at a fixed time begins with

        .. math:: (\delta y)_\tau = \delta y^+ - f(y^+, p)\, \delta\tau_e .

        Units are those of :meth:`derivatives`: dimensionless.

        Examples
        --------
        >>> import littlewood as lw
        >>> motion = lw.case("figure-3").simulate()
        >>> motion.derivatives_at([0.5, 1.0, 2.0], ["theta"]).theta.shape
        (3, 1)
        """
        return derivatives.at_times(self._core, times, quantities)

    def plot(self, *, width_mm: float | None = None) -> Figure:
        """Draw the path in the plane and what changes over time: θ, θ′, η′, forces, gap.

        Parameters
        ----------
        width_mm : float, optional
            Width in print, where the letters of ticks have 7 points; by default the figure is for a
            screen.

        Returns
        -------
        matplotlib.figure.Figure

        See Also
        --------
        littlewood.plot.path : The path in the plane, on axes of your own.
        littlewood.plot.history : θ, θ′, η′ and the forces over time, on axes of your own.
        """
        from . import plot

        return plot.trajectory(self, width_mm=width_mm)

    def animate(self, *, frames: int = 150, seconds: float | None = None) -> Animation:
        """Animate the motion; a notebook shows it with buttons to play and step.

        Parameters
        ----------
        frames : int, optional
            Number of frames.
        seconds : float, optional
            How long it plays; by default as long as the motion would take with R/g = 0.1 s², as for
            a metre.

        Returns
        -------
        Animation
            Its `save` writes a GIF or a video.
        """
        from .plot.animation import Animation

        return Animation(self, frames=frames, seconds=seconds)

    def lab(self, *, time: float | None = None, height: int = 820) -> Any:
        """Show the laboratory with this motion in a notebook, where its start can be dragged.

        Parameters
        ----------
        time : float, optional
            Instant that is shown first, √(R/g); by default the start.
        height : int, optional
            Height in pixels.

        Returns
        -------
        littlewood.lab.Laboratory
            A widget. Its `motion` and `time` follow what is done in the page, and the page follows
            them.

        Raises
        ------
        ImportError
            If anywidget is not installed.
        RuntimeError
            If the package was built without the page.
        """
        from .lab import Laboratory

        return Laboratory(self, time=time, height=height)

    def __repr__(self) -> str:
        return f"<Trajectory {self.sequence or 'of no phase'}: {self.outcome.label}>"

    def __str__(self) -> str:
        return printable(self._core.text().rstrip())

    def _repr_html_(self) -> str:
        return page_html(self._core.blocks())


def _impact(given: _core._Impact) -> Impact:
    return Impact(
        case=given["case"],
        before=ContactVelocities(**given["before"]),
        after=ContactVelocities(**given["after"]),
        impulse=Impulse(**given["impulse"]),
        normal_work=given["normal_work"],
        friction_work=given["friction_work"],
        resistance_work=given["resistance_work"],
        energy_lost=given["energy_lost"],
        gains_energy=given["gains_energy"],
    )


def _attributes(column: SampleColumn, si: bool) -> tuple[str, dict[str, Any]]:
    """Return the name of a column in a data set, and its attributes."""
    attributes: dict[str, Any] = {"long_name": column.long_name}
    if column.name == "mode":
        attributes["flag_values"] = np.arange(_core.OUTSIDE, len(MODES), dtype=np.int8)
        attributes["flag_meanings"] = " ".join(["outside", *MODES])
        return column.name, attributes
    if column.si_name is None:
        return column.name, {**attributes, "units": "1", "symbol": column.sign}
    units = {"units": column.si_unit} if si else {"units": column.cf_unit, "scale": column.scale}
    return column.si_name if si else column.name, {**attributes, **units, "symbol": column.sign}
