"""The laboratory in a notebook: a widget, with the whole page in it, that needs no network."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import anywidget
import traitlets

from ..trajectory import Trajectory
from .link import link_of, motion_of, time_of

__all__ = ["Laboratory"]

_MODULE = Path(__file__).with_name("laboratory.js")


class Laboratory(anywidget.AnyWidget):  # type: ignore[misc, unused-ignore]
    """The page in which a hoop is dragged and watched, in a notebook.

    :meth:`littlewood.Trajectory.lab` makes it.

    Page and Python share one state: dragging the start changes `motion`, the time line sets `time`,
    and values set here are shown there. ``laboratory.observe(function, "motion")`` calls a function
    when the motion changes.

    Attributes
    ----------
    motion : Trajectory
        The motion that is shown.
    time : float
        The instant that is shown, √(R/g).
    link : str
        Everything that is shown, as the part of an address after `#`.
    height : int
        Height of the widget, in pixels.
    """

    motion = traitlets.Instance(Trajectory)
    time = traitlets.Float()
    link = traitlets.Unicode().tag(sync=True)
    height = traitlets.Int(820, min=200).tag(sync=True)

    def __init__(
        self, motion: Trajectory, *, time: float | None = None, height: int = 820, **more: Any
    ) -> None:
        if not _MODULE.exists():
            raise RuntimeError(
                "this build of littlewood has no laboratory: run web/build.sh in the repository "
                "(it needs node 20 and "
                "`rustup target add wasm32-unknown-unknown`), then build and install the wheel "
                "again"
            )
        self._esm = _MODULE.read_text(encoding="utf-8")
        instant = motion.start.time if time is None else time
        super().__init__(
            motion=motion, time=instant, link=link_of(motion, instant), height=height, **more
        )
        self.observe(self._take_link, "link")
        self.observe(self._write_link, ["motion", "time"])

    def _take_link(self, _: object) -> None:
        """Let motion and instant follow the page.

        The motion stays the same object while its numbers stay.
        """
        shown = motion_of(self.link)
        same = link_of(shown, 0.0) == link_of(self.motion, 0.0)
        motion = self.motion if same else shown
        with self.hold_trait_notifications():
            self.motion = motion
            self.time = time_of(self.link, motion)

    def _write_link(self, _: object) -> None:
        """Let the page follow motion and instant, unless it shows them already."""
        shown = motion_of(self.link)
        instant = time_of(self.link, shown)
        if link_of(shown, instant) != link_of(self.motion, self.time):
            self.link = link_of(self.motion, self.time, self.link)
