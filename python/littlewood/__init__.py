"""Littlewood's hoop: exact simulation of a hoop with a particle fixed to it, on a rough plane.

The body is that of A. Bronars and O. M. O'Reilly, *Gliding motions of a rigid body: the curious
dynamics of Littlewood's rolling hoop* (Proc. R. Soc. A 475, 2019), whose equation numbers the
documentation cites. A disc or hoop of mass m1, radius R and moment of inertia I_zz carries a
particle of mass m2 at the distance ℓ from its centre. θ is the angle of the particle from the
upward vertical, counterclockwise; η = x + θ, so that η′ is the slip velocity of the contact point.
Everything is dimensionless, m2 = R = g = 1 (2.9); :meth:`Hoop.from_si` converts.

Examples
--------
>>> import math
>>> import littlewood as lw
>>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
>>> motion = hoop.simulate(theta=math.pi / 2, theta_rate=2)
>>> [transition.cause for transition in motion.transitions]
['stick', 'slip', 'lift_off', 'landing']
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

from . import bouncing, closed_form, motion, phase_plane, tables
from ._core import ParameterError, __version__
from .cases import CASES, case
from .hoop import Hoop
from .motion import Start
from .samples import Samples
from .trajectory import Trajectory
from .units import Units

if TYPE_CHECKING:
    from . import certify, fitting, lab, plot, scoring, style, video
    from .fitting import FitResult, Noise, Track, fit
    from .sweep import outcome_map, sequence_names, simulate_many
    from .video import track_video

__all__ = [
    "CASES",
    "FitResult",
    "Hoop",
    "Noise",
    "ParameterError",
    "Samples",
    "Start",
    "Track",
    "Trajectory",
    "Units",
    "__version__",
    "bouncing",
    "case",
    "certify",
    "closed_form",
    "fit",
    "fitting",
    "lab",
    "motion",
    "outcome_map",
    "phase_plane",
    "plot",
    "scoring",
    "sequence_names",
    "simulate_many",
    "style",
    "tables",
    "track_video",
    "video",
]

_ROOMS = ("certify", "fitting", "lab", "plot", "scoring", "style", "video")
_ROOM_OF = {
    "FitResult": "fitting",
    "Noise": "fitting",
    "Track": "fitting",
    "fit": "fitting",
    "outcome_map": "sweep",
    "sequence_names": "sweep",
    "simulate_many": "sweep",
    "track_video": "video",
}


def __dir__() -> list[str]:
    return sorted(__all__)


# The type checker knows the names from the imports above.
if not TYPE_CHECKING:

    def __getattr__(name: str) -> Any:
        # What one motion does not need is imported when it is used for the first time.
        if name in _ROOMS:
            return import_module(f".{name}", __name__)
        if name in _ROOM_OF:
            found = globals()[name] = getattr(import_module(f".{_ROOM_OF[name]}", __name__), name)
            return found
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
