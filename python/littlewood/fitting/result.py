"""The result of a fit."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import dataclass, field
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from .._internal.terminal import printable
from ..hoop import Hoop
from ..motion import State
from ..plot import canvas
from ..style import FAINT, FINE, INK, LINE, MODE_COLOURS, MODE_DASHES
from ..trajectory import Trajectory
from .diagnostics import Doubt
from .estimate import Estimate
from .noise import Noise
from .problem import Problem
from .profile import profile_interval
from .track import Track
from .track_columns import COLUMN_OF

if TYPE_CHECKING:
    from matplotlib.figure import Figure

__all__ = ["FitResult", "FitWarning", "IdentifiabilityWarning"]


class FitWarning(UserWarning):
    """A doubt about a fit.

    Attributes
    ----------
    doubt : littlewood.fitting.Doubt
        Its name, what was found, and what it is about.
    """

    def __init__(self, doubt: Doubt) -> None:
        super().__init__(doubt)
        self.doubt = doubt

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of what it is about."""
        return self.doubt.parameters


class IdentifiabilityWarning(FitWarning):
    """A parameter leaves no trace in the motion that was tracked."""


@dataclass(frozen=True, eq=False)
class FitResult:
    """A fitted motion.

    Attributes
    ----------
    hoop : Hoop
        The hoop with the estimated parameters.
    start : littlewood.motion.State
        The estimated start.
    estimates : mapping of str to littlewood.fitting.Estimate
        Estimates of everything that was free: parameters of the hoop, of the start by
        `start_theta`, …, and of the camera by `camera_floor`, …
    covariance : ndarray
        Covariance of the estimates, in their order; infinite on the diagonal for those not
        identifiable.
    motion : Trajectory
        The fitted motion.
    track : Track
        The fitted track.
    residuals : mapping of str to ndarray
        Measured minus fitted, by channel: rad, R, R.
    noise : mapping of str to Noise
        Errors of the measurements, given or estimated, by channel.
    reduced_chi_square : float
        Sum eᵀV⁻¹e of the residuals over the number of measurements less that of free parameters; 1
        for a good fit.
    mu_s_at_least : float
        Largest friction |F|/N of rolling in the fitted motion, a lower bound of μs.
    message : str
        How the optimiser ended.
    doubts : tuple of littlewood.fitting.Doubt
        What speaks against the fit, each also a :class:`littlewood.fitting.FitWarning`; empty
        for a good fit.
    sequences : mapping of str to float
        Sequences of phases that were fitted with the final errors, the most probable first, and
        their posterior probabilities.
    """

    hoop: Hoop
    start: State
    estimates: Mapping[str, Estimate]
    covariance: npt.NDArray[np.float64]
    motion: Trajectory
    track: Track
    residuals: Mapping[str, npt.NDArray[np.float64]]
    noise: Mapping[str, Noise]
    reduced_chi_square: float
    mu_s_at_least: float
    message: str
    doubts: tuple[Doubt, ...]
    sequences: Mapping[str, float]
    _problem: Problem = field(repr=False)
    _unknowns: npt.NDArray[np.float64] = field(repr=False)

    @property
    def sigma(self) -> dict[str, float]:
        """Standard deviation of a measurement by channel.

        Where the track has errors, at their median.
        """
        return {name: noise.sigma for name, noise in self.noise.items()}

    @property
    def inertia_kg_m2(self) -> float:
        """Estimated moment of inertia of the disc in kg m²; needs a hoop with units."""
        return self.hoop.inertia * self.hoop.require_units().inertia_kg_m2

    def __str__(self) -> str:
        lines: dict[str, object] = {
            **self.estimates,
            "mu_s at least": f"{self.mu_s_at_least:.4g}",
            "motion": f"{self.motion.sequence}: {self.motion.outcome}",
            **{f"σ of {name}": noise for name, noise in self.noise.items()},
            "reduced χ²": f"{self.reduced_chi_square:.3f}",
        }
        width = max(18, 2 + max(map(len, lines)))
        doubts = [f"{'doubt':<{width}}{doubt}" for doubt in self.doubts]
        return printable(
            "\n".join([*(f"{name:<{width}}{value}" for name, value in lines.items()), *doubts])
        )

    def _repr_html_(self) -> str:
        rows = "".join(
            '<tr style="background:none"><td style="text-align:left;padding:2px 10px">'
            f'{name}</td><td style="text-align:left;padding:2px 10px">{estimate}</td></tr>'
            for name, estimate in self.estimates.items()
        )
        return (
            f"<div><b>Fitted motion</b> {self.motion.sequence}: "
            f"{self.motion.outcome}<table>{rows}</table>"
            f"<small>μs is at least {self.mu_s_at_least:.4g}; reduced χ² "
            f"{self.reduced_chi_square:.3f}</small>"
            + "".join(
                f"<div><b>Doubt: {doubt.name}</b> {escape(doubt.message)}</div>"
                for doubt in self.doubts
            )
            + "</div>"
        )

    def profile_interval(self, name: str, confidence: float = 0.95) -> tuple[float, float]:
        """Return the interval of the profile likelihood, which holds where that is no parabola.

        The ends are where the least sum of squares, over all other unknowns, exceeds that of the
        fit by the square of the normal quantile.

        Parameters
        ----------
        name : str
            A parameter of the hoop that was free.
        confidence : float, optional
            Probability that it contains the true value.

        Returns
        -------
        tuple of float
            Its ends; a bound, or infinite, where the track does not exclude the values beyond.
        """
        return profile_interval(
            self._problem, self._unknowns, self.covariance, name, self.estimates[name], confidence
        )

    @canvas.on_sheet
    def plot(self, *, with_doubts: bool = True) -> Figure:
        """Draw data, fitted motion and residuals.

        Parameters
        ----------
        with_doubts : bool, optional
            Whether to write the doubts below.

        Returns
        -------
        matplotlib.figure.Figure
        """
        channels = self.track.channels
        figure = canvas.sheet(max(5.5, 4.2 * len(channels)), 5.2)
        axes: Any = figure.subplots(
            2, len(channels), squeeze=False, sharex=True, gridspec_kw={"height_ratios": (2.0, 1.0)}
        )
        end = min(float(self.track.time[-1]), self.motion.end_time)
        samples = self.motion.sample(1001, end)
        plane = {channel: samples[column] for channel, column in COLUMN_OF.items()}
        seen = self.track.as_seen(plane, self.hoop.slope)
        for k, (name, measured) in enumerate(channels.items()):
            above, below = axes[0, k], axes[1, k]
            above.plot(
                self.track.time, measured, "o", ms=2.6, mfc="none", mec=FAINT, label="measured"
            )
            fitted = seen[name]
            for mode, part in canvas.phase_slices(samples):
                line = {"color": MODE_COLOURS[mode], "ls": MODE_DASHES[mode], "label": mode}
                above.plot(samples.time[part], fitted[part], **line)
            label = canvas.words(above, canvas.axis_label(COLUMN_OF[name]))
            above.set_ylabel(label)
            if name == "theta":
                canvas.pi_ticks(above, "y", most=7)
                above.set_ylabel(canvas.words(above, canvas.sign(name)))
            below.axhspan(-self.sigma[name], self.sigma[name], color=LINE, alpha=0.5, lw=0)
            below.axhline(0.0, color=INK, lw=FINE)
            below.plot(self.track.time, self.residuals[name], "o", ms=2.6, color=INK)
            below.set_ylabel(f"residual of {label}")
            below.set_xlabel(canvas.words(below, canvas.axis_label("time")))
            for one in (above, below):
                for transition in self.motion.transitions:
                    if transition.time <= end:
                        one.axvline(transition.time, color=FAINT, lw=FINE, zorder=0)
        handles, labels = axes[0, 0].get_legend_handles_labels()
        unique = dict(zip(labels, handles, strict=True))
        figure.legend(unique.values(), unique.keys(), loc="outside upper left", ncols=5)
        if self.doubts and with_doubts:
            words = "\n".join(
                textwrap.fill(f"Doubt: {doubt}", 62 * max(2, len(channels)))
                for doubt in self.doubts
            )
            figure.supxlabel(words, fontsize="small", ha="left", x=0.02)
        figure.align_ylabels()
        return figure
