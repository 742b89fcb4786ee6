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

from . import bouncing, closed_form, motion, phase_plane, plot, scoring, tables, video
from ._core import ParameterError, __version__
from .cases import CASES, case
from .fitting.fit import fit
from .fitting.noise import Noise
from .fitting.result import FitResult
from .fitting.track import Track
from .hoop import Hoop
from .motion import Start
from .samples import Samples
from .sweep.many import outcome_map, sequence_names, simulate_many
from .trajectory import Trajectory
from .units import Units
from .video.tracking import track_video

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
    "closed_form",
    "fit",
    "motion",
    "outcome_map",
    "phase_plane",
    "plot",
    "scoring",
    "sequence_names",
    "simulate_many",
    "tables",
    "track_video",
    "video",
]
