"""The laboratory in a notebook.

The page as a widget, and its links. :meth:`littlewood.Trajectory.lab` shows it.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._internal.extras import require
from .link import LinkError, link_of, motion_of, time_of

if TYPE_CHECKING:
    from .widget import Laboratory

__all__ = ["Laboratory", "LinkError", "link_of", "motion_of", "time_of"]


def __getattr__(name: str) -> Any:
    # The widget needs anywidget; links do not.
    if name == "Laboratory":
        require("anywidget")
        from .widget import Laboratory

        return Laboratory
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
