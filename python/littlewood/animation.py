"""Animation of a motion, as a notebook shows it."""

from __future__ import annotations

import math
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .counts import checked_count
from .extras import require
from .plot.canvas import draw_hoop, draw_plane, level, on_sheet, seen_heights, sheet
from .style import CURVE, INK, MODE_COLOURS

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation

    from .trajectory import Trajectory

__all__ = ["Animation"]

# An hour and a half of a video.
_MOST_FRAMES = 300_000
# Seconds that √(R/g) takes by default: that of a hoop of about a metre.
_SECONDS = math.sqrt(0.1)


class Animation:
    """A motion as a video: the hoop on the plane, its particle drawing its path in the colour of the mode.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    frames : int, optional
        Number of frames, evenly spaced in time, 2 to 300,000.
    seconds : float, optional
        How long it plays.
    """

    def __init__(
        self, motion: Trajectory, *, frames: int = 150, seconds: float | None = None
    ) -> None:
        checked_count("frames", frames, 2, _MOST_FRAMES)
        if not motion.phases:
            raise ValueError(f"there is no motion to show: {motion.outcome}")
        begin, end = motion.start.time, motion.shown_until
        self.motion = motion
        self.seconds = (end - begin) * _SECONDS if seconds is None else float(seconds)
        if not (self.seconds > 0.0 and math.isfinite(self.seconds)):
            raise ValueError(f"seconds = {self.seconds} s must be a finite number greater than 0")
        self._times = np.linspace(begin, end, frames)
        self._samples = motion(self._times)

    def __repr__(self) -> str:
        return f"<Animation of {self.motion.sequence}, {len(self._times)} frames, {self.seconds:.3g} s>"

    @property
    def _rate(self) -> int:
        # Frames a second, of which Matplotlib takes whole numbers.
        return max(1, round(len(self._times) / self.seconds))

    @on_sheet
    def to_matplotlib(self) -> FuncAnimation:
        """Return the animation of Matplotlib.

        Returns
        -------
        matplotlib.animation.FuncAnimation
        """
        agg = require("matplotlib.backends.backend_agg")
        animation = require("matplotlib.animation")
        samples, hoop = self._samples, self.motion.hoop
        across, _ = level(hoop.slope, samples.x, samples.centre_y)
        particle = level(hoop.slope, samples.particle_x, samples.particle_y)
        low, high = float(np.min(across)) - 1.3, float(np.max(across)) + 1.3
        bottom, highest = seen_heights(samples, hoop.slope)
        top = highest + 1.25
        width = 8.0
        height = min(6.0, max(2.2, width * (top - bottom + 0.3) / (high - low) + 0.4))
        figure = sheet(width, height)
        figure.set_layout_engine("none")
        agg.FigureCanvasAgg(figure)
        axes = figure.add_axes((0.01, 0.01, 0.98, 0.98))
        axes.set_xlim(low, high)
        axes.set_ylim(bottom - 0.3, top)
        axes.set_aspect("equal")
        axes.axis("off")
        draw_plane(axes, hoop.slope)
        label = axes.text(
            0.01, 0.98, "", transform=axes.transAxes, va="top", color=INK, size="large"
        )
        names = samples.mode_names
        moving: list[Any] = []

        def show(i: int) -> list[Any]:
            for artist in moving:
                artist.remove()
            moving.clear()
            moving.extend(
                draw_hoop(
                    axes,
                    hoop,
                    float(samples.x[i]),
                    float(samples.centre_y[i]),
                    float(samples.theta[i]),
                )
            )
            begin = 0
            for end in range(1, i + 2):
                if end == i + 1 or names[end] != names[begin]:
                    (line,) = axes.plot(
                        particle[0][begin : min(end, i) + 1],
                        particle[1][begin : min(end, i) + 1],
                        color=MODE_COLOURS[str(names[begin])],
                        linewidth=CURVE,
                        zorder=2,
                    )
                    moving.append(line)
                    begin = end
            label.set_text(f"*τ* = {self._times[i]:.2f}   {names[i]}")
            label.set_color(MODE_COLOURS[str(names[i])])
            return [*moving, label]

        video: FuncAnimation = animation.FuncAnimation(
            figure,
            show,
            frames=len(self._times),
            init_func=lambda: [],
            interval=1000.0 * self.seconds / len(self._times),
            blit=False,
        )
        return video

    def save(self, path: str | Path) -> None:
        """Write a video.

        Parameters
        ----------
        path : str or Path
            A `.gif`, or a `.mp4` where ffmpeg is installed.
        """
        writer = "pillow" if Path(path).suffix.lower() == ".gif" else "ffmpeg"
        self.to_matplotlib().save(str(path), writer=writer, fps=self._rate)

    def _repr_html_(self) -> str:
        matplotlib = require("matplotlib")
        # Frames small enough that all of them go into the page.
        with matplotlib.rc_context({"animation.embed_limit": 60.0, "savefig.dpi": 72.0}):
            html: str = self.to_matplotlib().to_jshtml(fps=self._rate, default_mode="once")
        return html
