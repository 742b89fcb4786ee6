"""Animation of a motion, as a notebook shows it."""

from __future__ import annotations

import itertools
import math
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from .._internal.counts import checked_count
from .._internal.elementwise import real
from .._internal.extras import require
from .._protocols import MotionLike
from ..style import CURVE, INK, MODE_COLOURS
from .canvas import draw_hoop, draw_plane, level, on_sheet, seen_heights, sheet

if TYPE_CHECKING:
    from matplotlib.animation import FuncAnimation


__all__ = ["Animation"]

# An hour and a half of a video.
_MOST_FRAMES = 300_000
# Seconds that √(R/g) takes by default: that of a hoop of about a metre.
_SECONDS = math.sqrt(0.1)
_GIF = ".gif"
# What ffmpeg puts H.264 into, as Matplotlib calls it.
_BY_FFMPEG = (".mp4", ".mov", ".mkv")
# A GIF counts hundredths of a second, in 16 bits; programs show for a tenth what is to be shown for
# less than two.
_LEAST_DELAY, _MOST_DELAY = 2, 65_535


class Animation:
    """A motion as a video.

    The hoop on the plane, its particle drawing its path in the colour of the mode.

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
        self, motion: MotionLike, *, frames: int = 150, seconds: float | None = None
    ) -> None:
        checked_count("frames", frames, 2, _MOST_FRAMES)
        if not motion.phases:
            raise ValueError(f"there is no motion to show: {motion.outcome}")
        begin, end = motion.start.time, motion.shown_until
        self.motion = motion
        self.seconds = (end - begin) * _SECONDS if seconds is None else real(seconds, "seconds")
        if not (self.seconds > 0.0 and math.isfinite(self.seconds)):
            raise ValueError(f"seconds = {self.seconds} s must be a finite number greater than 0")
        self._times = np.linspace(begin, end, frames)
        self._samples = motion(self._times)

    def __repr__(self) -> str:
        return (
            f"<Animation of {self.motion.sequence}, {len(self._times)} frames, "
            f"{self.seconds:.3g} s>"
        )

    @on_sheet
    def to_matplotlib(self) -> FuncAnimation:
        """Return the animation of Matplotlib.

        Returns
        -------
        matplotlib.animation.FuncAnimation
        """
        return self._drawn(range(len(self._times)))

    def _drawn(self, shown: Sequence[int]) -> FuncAnimation:
        """Return the animation of some of the frames."""
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
            frames=shown,
            init_func=lambda: [],
            interval=1000.0 * self.seconds / len(shown),
            blit=False,
        )
        return video

    def save(self, path: str | Path) -> None:
        """Write a video, which plays in the seconds that were asked for.

        Parameters
        ----------
        path : str or Path
            A `.gif`; a `.mp4`, `.mov` or `.mkv` where ffmpeg is installed. A GIF shows at most 50
            frames a second: of more, some are left out, evenly.

        Raises
        ------
        UnwritableVideoError
            A ValueError: for another ending, a folder that is not there, without ffmpeg or where it
            fails, and for frames that are shown for longer than a GIF can say.
        """
        from ..video.errors import UnwritableVideoError

        ending = Path(path).suffix.lower()
        if ending != _GIF and ending not in _BY_FFMPEG:
            raise UnwritableVideoError(
                str(path),
                f"the ending {ending!r} must be one of {', '.join((_GIF, *_BY_FFMPEG))}; "
                "a .gif needs no other program",
            )
        if not Path(path).parent.is_dir():
            raise UnwritableVideoError(str(path), "there is no such folder")
        if ending == _GIF:
            self._save_gif(path)
            return
        if not require("matplotlib.animation").writers.is_available("ffmpeg"):
            raise UnwritableVideoError(
                str(path),
                "a video needs ffmpeg, which is not found: install it (apt install ffmpeg, "
                "brew install ffmpeg, winget install ffmpeg), or write a .gif",
            )
        # Its annotations have whole numbers; it hands over any.
        rate: Any = len(self._times) / self.seconds
        try:
            self.to_matplotlib().save(str(path), writer="ffmpeg", fps=rate)
        except subprocess.CalledProcessError as error:
            said = str(error.stderr or "").strip()
            words = said.splitlines()[-1:] or [f"exit code {error.returncode}"]
            raise UnwritableVideoError(
                str(path),
                f"ffmpeg failed: {words[0]}; it must be able to write H.264 (libx264); "
                "or write a .gif",
            ) from None

    def _save_gif(self, path: str | Path) -> None:
        from ..video.errors import UnwritableVideoError

        delays = gif_delays(self.seconds, len(self._times))
        if not delays or max(delays) > _MOST_DELAY:
            least, most = _LEAST_DELAY / 50, _MOST_DELAY / 100 * len(self._times)
            raise UnwritableVideoError(
                str(path),
                f"seconds = {self.seconds:g} s must be from {least:g} to {most:g} s "
                f"for a GIF of {len(self._times)} frames",
            )
        shown = np.linspace(0, len(self._times) - 1, len(delays)).round().astype(int).tolist()

        # That of Matplotlib has one delay for all frames, in whole milliseconds, of which Pillow
        # keeps whole hundredths of a second.
        class Writer(require("matplotlib.animation").PillowWriter):  # type: ignore[misc]
            def finish(self) -> None:
                first, *more = self._frames
                first.save(
                    self.outfile,
                    save_all=True,
                    append_images=more,
                    duration=[10 * delay for delay in delays],
                    loop=0,
                )

        on_sheet(self._drawn)(shown).save(str(path), writer=Writer())

    def _repr_html_(self) -> str:
        matplotlib = require("matplotlib")
        # Pages count whole milliseconds, and Matplotlib rounds them down.
        interval = max(1, round(1000.0 * self.seconds / len(self._times)))
        # Frames small enough that all of them go into the page.
        with matplotlib.rc_context({"animation.embed_limit": 60.0, "savefig.dpi": 72.0}):
            rate: Any = 1000.0 / (interval + 0.5)
            html: str = self.to_matplotlib().to_jshtml(fps=rate, default_mode="once")
        return html


def gif_delays(seconds: float, frames: int) -> list[int]:
    """Return how long a GIF shows its frames, hundredths of a second.

    All together take so many seconds.

    Each is the whole number of hundredths up to which its end rounds, as in the films of the
    program: no error adds up. There are fewer frames where each would be shown for less than two
    hundredths, and none where there would not be two of them.
    """
    count = min(frames, math.floor(100.0 * seconds / _LEAST_DELAY + 1e-9))
    if count < 2:
        return []
    ends = [math.floor(100.0 * seconds * k / count + 0.5) for k in range(count + 1)]
    return [end - begin for begin, end in itertools.pairwise(ends)]
