"""Littlewood's hoop: exact simulation of a hoop with a particle fixed to it, on a rough plane.

The body is that of A. Bronars and O. M. O'Reilly, *Gliding motions of a rigid body: the curious dynamics of
Littlewood's rolling hoop* (Proc. R. Soc. A 475, 2019), whose equation numbers the documentation cites. A disc or hoop
of mass m1, radius R and moment of inertia I_zz carries a particle of mass m2 at the distance ℓ from its centre. θ is
the angle of the particle from the upward vertical, counterclockwise; η = x + θ, so that η′ is the slip velocity of the
contact point.
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

from . import closed_form, plot, video
from ._core import ParameterError, __version__
from .bouncing import BouncingOrbit
from .cases import CASES, Case, case
from .fit_result import Estimate, FitResult, IdentifiabilityWarning
from .fitting import fit
from .hoop import STANDARD_GRAVITY, Hoop
from .many import outcome_map, sequence_names, simulate_many
from .motion import (
    EDGES,
    Classification,
    ContactVelocities,
    Edge,
    Impact,
    Impulse,
    Outcome,
    Phase,
    Start,
    State,
    Transition,
)
from .noise import Noise
from .phase_plane import Equilibrium, PhasePlane
from .samples import Samples
from .scoring import Convergence, EventScore, Record, RecordError, Score, Tolerances, convergence, score
from .tables import CAUSES, CLASSES, IMPACT_CASES, MODES, OUTCOMES, PROOFS, REGIONS, RESTITUTION_LAWS
from .track import Track
from .trajectory import Trajectory
from .units import Units
from .video.tracking import track_video

__all__ = [
    "CASES",
    "CAUSES",
    "CLASSES",
    "EDGES",
    "IMPACT_CASES",
    "MODES",
    "OUTCOMES",
    "PROOFS",
    "REGIONS",
    "RESTITUTION_LAWS",
    "STANDARD_GRAVITY",
    "BouncingOrbit",
    "Case",
    "Classification",
    "ContactVelocities",
    "Convergence",
    "Edge",
    "Equilibrium",
    "Estimate",
    "EventScore",
    "FitResult",
    "Hoop",
    "IdentifiabilityWarning",
    "Impact",
    "Impulse",
    "Noise",
    "Outcome",
    "ParameterError",
    "Phase",
    "PhasePlane",
    "Record",
    "RecordError",
    "Samples",
    "Score",
    "Start",
    "State",
    "Tolerances",
    "Track",
    "Trajectory",
    "Transition",
    "Units",
    "__version__",
    "case",
    "closed_form",
    "convergence",
    "fit",
    "outcome_map",
    "plot",
    "score",
    "sequence_names",
    "simulate_many",
    "track_video",
    "video",
]
