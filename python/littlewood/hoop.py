"""The body: a hoop or disc with a particle fixed to it."""

from __future__ import annotations

import warnings
from dataclasses import dataclass

from . import _core
from ._frozen import Frozen
from ._html import hoop_html
from ._internal.elementwise import real
from .bouncing import BouncingOrbit
from .motion import ClassAt, Classification, RollingEnd, Start, Threshold
from .phase_plane import PhasePlane
from .tables import HOOP, MAX_SLIDES, MAX_TRANSITIONS, PROOF, QUANTITIES, SI_HOOP, SI_START
from .trajectory import Trajectory
from .units import Units

__all__ = ["STANDARD_GRAVITY", "Hoop"]

STANDARD_GRAVITY = _core.STANDARD_GRAVITY
"""Standard acceleration of free fall, m/s²."""


@dataclass(frozen=True, kw_only=True)
class Hoop:
    """A hoop or disc with a particle, in the dimensionless parameters of (2.9).

    Its mass is m1, that of the particle m2.

    Parameters
    ----------
    mass_ratio : float
        Mass of the disc over that of the particle, m1/m2 ≥ 0.
    offset : float
        Distance of the particle from the centre over the radius, 0 ≤ ℓ/R ≤ 1.
    inertia : float
        Moment of inertia of the disc about its centre, I_zz/(m2 R²) ≥ 0. A thin hoop has m1/m2, a
        uniform disc half of it, Littlewood's massless hoop 0.
    mu_s : float
        Coefficient of static friction, μs ≥ μk.
    mu_k : float
        Coefficient of kinetic friction, μk ≥ 0.
    rolling_resistance : float, optional
        Coefficient χ ≥ 0 of rolling resistance, a length over the radius. With χ > 0 the hoop
        can come to rest.
    slope : float, optional
        Angle α by which the plane rises to the right, rad, |α| < π/2. On a slope x is measured
        along the plane and θ from its normal.
    restitution : float, optional
        Coefficient of restitution of the impact of the rim on the plane, 0 ≤ e ≤ 1. Without one
        (None) a motion ends where the rim lands; with one it continues. A massless hoop has none:
        an impulse would accelerate its rim without bound.
    restitution_law : {"energetic", "poisson", "newton"}, optional
        Definition of e, a ratio of works (Stronge; the default where e is given), impulses or
        velocities. Only the last can gain energy.
    units : Units, optional
        Units of the hoop; :meth:`from_si` sets them.

    Raises
    ------
    ParameterError
        A ValueError that names the first value without physical meaning, the bound it breaks and
        the unit.

    Examples
    --------
    The hoop of Figure 3 slides, rolls, slides and jumps:

    >>> import math, littlewood as lw
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> motion = hoop.simulate(theta=math.pi / 2, theta_rate=2)
    >>> [phase.mode for phase in motion.phases]
    ['sliding', 'rolling', 'sliding', 'flight']

    The same hoop with e = 0 lands without a rebound, slides, and rolls in the end:

    >>> soft = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0)
    >>> [phase.mode for phase in soft.simulate(theta=math.pi / 2, theta_rate=2).phases][3:]
    ['flight', 'sliding', 'rolling']
    """

    mass_ratio: float
    offset: float
    inertia: float
    mu_s: float
    mu_k: float
    rolling_resistance: float = 0.0
    slope: float = 0.0
    restitution: float | None = None
    restitution_law: str | None = None
    units: Units | None = None

    def __post_init__(self) -> None:
        for name in HOOP:
            value = getattr(self, name)
            if value is not None or not QUANTITIES[name].is_optional:
                object.__setattr__(self, name, real(value, name))
        object.__setattr__(self, "restitution_law", self._derived["restitution_law"])

    @classmethod
    def from_si(
        cls,
        *,
        disc_mass_kg: float,
        particle_mass_kg: float,
        radius_m: float,
        offset_m: float,
        inertia_kg_m2: float,
        mu_s: float,
        mu_k: float,
        rolling_resistance_m: float = 0.0,
        slope: float = 0.0,
        restitution: float | None = None,
        restitution_law: str | None = None,
        gravity_m_per_s2: float = STANDARD_GRAVITY,
    ) -> Hoop:
        """Make a hoop from SI units.

        Parameters
        ----------
        disc_mass_kg : float
            Mass m1 of the disc or hoop, kg.
        particle_mass_kg : float
            Mass m2 of the particle, kg.
        radius_m : float
            Outer radius R, m.
        offset_m : float
            Distance ℓ of the particle from the geometric centre, m; 0 ≤ ℓ ≤ R.
        inertia_kg_m2 : float
            Moment of inertia I_zz of the disc about its centre, kg m²: m1 R² for a thin hoop.
        mu_s, mu_k : float
            Coefficients of static and kinetic friction, 0 ≤ μk ≤ μs.
        rolling_resistance_m : float, optional
            Coefficient of rolling resistance, m.
        slope : float, optional
            Angle by which the plane rises to the right, rad.
        restitution, restitution_law : optional
            Coefficient of restitution and its law, as those of :class:`Hoop`.
        gravity_m_per_s2 : float, optional
            Gravitational acceleration g, m/s².

        Returns
        -------
        Hoop
            With its `units`.

        Raises
        ------
        ParameterError
            For a value without physical meaning.
        """
        given: dict[str, float | None] = {
            "disc_mass_kg": disc_mass_kg,
            "particle_mass_kg": particle_mass_kg,
            "radius_m": radius_m,
            "offset_m": offset_m,
            "inertia_kg_m2": inertia_kg_m2,
            "gravity_m_per_s2": gravity_m_per_s2,
            "mu_s": mu_s,
            "mu_k": mu_k,
            "rolling_resistance_m": rolling_resistance_m,
            "slope": slope,
            "restitution": restitution,
        }
        checked = [
            None
            if QUANTITIES[name].is_optional and given[name] is None
            else real(given[name], name)
            for name in SI_HOOP
        ]
        found = _core.hoop_from_si(checked, restitution_law)
        most = disc_mass_kg * radius_m**2
        # The product may be rounded.
        if inertia_kg_m2 > most * (1.0 + 1e-12):
            warnings.warn(
                f"inertia_kg_m2 = {inertia_kg_m2:g} exceeds {most:.4g}, that of a disc with all "
                f"its mass at the rim "
                "(disc_mass_kg radius_m²)",
                stacklevel=2,
            )
        return cls(**found["hoop"], restitution_law=restitution_law, units=Units(**found["units"]))

    @property
    def _given(self) -> tuple[list[float | None], str | None]:
        """The hoop as the core takes it."""
        return [getattr(self, name) for name in HOOP], self.restitution_law

    @property
    def _derived(self) -> _core._DerivedHoop:
        """What follows from its parameters."""
        return _core.check_hoop(self._given)

    @property
    def attributes(self) -> dict[str, float | str]:
        """Attributes of data sets.

        The parameters of the hoop but those that go without saying, and the law of restitution, if
        any.
        """
        named = {name: getattr(self, name) for name in HOOP}
        named = {
            name: value
            for name, value in named.items()
            if not (QUANTITIES[name].goes_without_saying and value == QUANTITIES[name].default)
        }
        named["restitution_law"] = self.restitution_law
        return {name: value for name, value in named.items() if value is not None}

    @property
    def mass(self) -> float:
        """Total mass m = 1 + m1/m2, m2."""
        return self._derived["mass"]

    @property
    def h(self) -> float:
        """Distance of the mass centre from the geometric centre, h = ℓ̂/m (2.4), R."""
        return self._derived["h"]

    @property
    def inertia_about_mass_centre(self) -> float:
        """Moment of inertia about the mass centre, Î of (2.9), m2 R²."""
        return self._derived["inertia_about_mass_centre"]

    @property
    def phase_plane(self) -> PhasePlane:
        """The (θ, θ′) plane of its rolling motions."""
        return PhasePlane(self)

    def simulate(
        self,
        *,
        theta: float,
        theta_rate: float,
        slip: float = 0.0,
        gap_rate: float = 0.0,
        x: float = 0.0,
        time: float = 0.0,
        until: float | None = None,
        max_transitions: int = MAX_TRANSITIONS,
        max_slides: int = MAX_SLIDES,
        proof: str = PROOF,
    ) -> Trajectory:
        """Simulate a motion to its end, or to a limit.

        Each transition is isolated as a root of the solution and located to machine precision.

        Parameters
        ----------
        theta : float
            Angle θ of the particle from the upward vertical, counterclockwise, rad.
        theta_rate : float
            Rate θ′, √(g/R). Rolling to the right has θ′ < 0.
        slip : float, optional
            Slip velocity η′ of the contact point (2.7), √(gR).
        gap_rate : float, optional
            Rate ≥ 0 at which the gap under the rim opens, √(gR): that of a hoop thrown from the
            plane.
        x : float, optional
            Position of the geometric centre along the plane, R.
        time : float, optional
            Time τ of the start, √(R/g).
        until : float, optional
            Time τ at which to stop, √(R/g). By default to the end of the motion.
        max_transitions : int, optional
            Largest number of transitions: a light hoop on a nearly smooth plane may have very many.
        max_slides : int, optional
            Largest length of all slides together, √(Δτ² + Δθ²) each but at most 32, times 1 +
            ln(1 + m/Î): on a plane with hardly any friction they are long and many.
        proof : {"endless", "contact", "none"}, optional
            Proof that ends a motion without a time limit: that it is periodic or slips for ever;
            also, as soon as possible, that it never lifts off; or only that a phase is endless.

        Returns
        -------
        Trajectory

        Raises
        ------
        ParameterError
            For a start or a limit without physical meaning.
        """
        start = Start(
            time=time, theta=theta, theta_rate=theta_rate, slip=slip, gap_rate=gap_rate, x=x
        )
        return Trajectory(self, start, until, max_transitions, max_slides, proof)

    def simulate_si(
        self,
        *,
        theta_rad: float,
        theta_rate_rad_per_s: float,
        slip_m_per_s: float = 0.0,
        gap_rate_m_per_s: float = 0.0,
        x_m: float = 0.0,
        time_s: float = 0.0,
        until_s: float | None = None,
        max_transitions: int = MAX_TRANSITIONS,
        max_slides: int = MAX_SLIDES,
        proof: str = PROOF,
    ) -> Trajectory:
        """Simulate a motion from a start in SI units.

        Parameters
        ----------
        theta_rad : float
            Angle θ, rad.
        theta_rate_rad_per_s : float
            Rate dθ/dt, rad/s.
        slip_m_per_s : float, optional
            Slip velocity dη/dt, m/s.
        gap_rate_m_per_s : float, optional
            Rate ≥ 0 at which the gap under the rim opens, m/s.
        x_m : float, optional
            Position of the geometric centre along the plane, m.
        time_s, until_s : float, optional
            Time of the start, and time at which to stop, s.
        max_transitions, max_slides, proof : optional
            As in :meth:`simulate`.

        Returns
        -------
        Trajectory
            Dimensionless; its `to_pandas(si=True)` and `to_xarray(si=True)` are in SI units.

        Raises
        ------
        ValueError
            If the hoop has no units: it was not made by :meth:`from_si`.
        ParameterError
            For a start or a limit without physical meaning.
        """
        given = {
            "theta": theta_rad,
            "theta_rate_rad_per_s": theta_rate_rad_per_s,
            "slip_m_per_s": slip_m_per_s,
            "gap_rate_m_per_s": gap_rate_m_per_s,
            "x_m": x_m,
            "time_s": time_s,
        }
        found = _core.start_from_si(
            self.require_units().scales,
            [real(given[name], "theta_rad" if name == "theta" else name) for name in SI_START],
            None if until_s is None else real(until_s, "until_s"),
        )
        start = Start(**found["start"])
        return Trajectory(self, start, found["until"], max_transitions, max_slides, proof)

    def classify(
        self, *, theta: float, theta_rate: float, slip: float = 0.0, gap_rate: float = 0.0
    ) -> Classification:
        """Return the region of a start and the motion that begins there, without simulating it.

        Parameters
        ----------
        theta, theta_rate, slip, gap_rate : float
            Start: θ in rad, θ′ in √(g/R), η′ and the rate of the gap in √(gR).

        Returns
        -------
        littlewood.motion.Classification

        Raises
        ------
        ParameterError
            For a start without physical meaning.
        """
        start = Start(
            time=0.0, theta=theta, theta_rate=theta_rate, slip=slip, gap_rate=gap_rate, x=0.0
        )
        found = _core.classify(self._given, start.numbers)
        end = found["rolling_end"] and RollingEnd(**found["rolling_end"])
        return Classification(**{**found, "rolling_end": end, "details": Frozen(found["details"])})

    def threshold(
        self,
        *,
        of: str,
        between: tuple[float, float] | None = None,
        theta: float,
        theta_rate: float,
        slip: float = 0.0,
        gap_rate: float = 0.0,
        until: float | None = None,
    ) -> Threshold | None:
        """Find the value of a quantity at which the class of a motion changes, to the last digit.

        A motion counts up to its first landing. The search takes 200 steps, then halves the one in
        which the class changes: what changes twice within a step is not seen.

        Parameters
        ----------
        of : str
            A quantity of the hoop or of the start, such as `mu_s`, `slope` or `theta_rate`.
        between : tuple of float, optional
            Search from the first number on to the second. Without it the search goes from the value
            of the motion to both sides, over the usual range of the quantity.
        theta, theta_rate, slip, gap_rate : float
            Start: θ in rad, θ′ in √(g/R), η′ and the rate of the gap in √(gR).
        until : float, optional
            Follow motions to this time, √(R/g).

        Returns
        -------
        littlewood.motion.Threshold or None
            None where the class does not change.

        Raises
        ------
        ParameterError
            For a name that is none, and for a value without physical meaning.

        Examples
        --------
        A disc at rest on a plane with χ = 0.1 begins to roll where tan α = χ:

        >>> import littlewood as lw
        >>> disc = lw.Hoop(
        ...     mass_ratio=1, offset=0, inertia=0.5, mu_s=0.5, mu_k=0.4, rolling_resistance=0.1
        ... )
        >>> found = disc.threshold(of="slope", between=(0, 0.3), theta=0, theta_rate=0)
        >>> f"{found.below.class_name}, {found.above.class_name}, {found.above.value:.6f}"
        'rests, rolls_forever, 0.099669'
        """
        start = Start(
            time=0.0, theta=theta, theta_rate=theta_rate, slip=slip, gap_rate=gap_rate, x=0.0
        )
        ends = None
        if between is not None:
            first, last = between
            ends = (real(first, "between[0]"), real(last, "between[1]"))
        limit = None if until is None else real(until, "until")
        found = _core.threshold(self._given, start.numbers, of, ends, limit)
        if found["sides"] is None:
            return None
        below, above = (ClassAt(**side) for side in found["sides"])
        return Threshold(of, below, above, found["has_unresolved_between"], found["text"])

    def bouncing_orbit(self, angle: float) -> BouncingOrbit | None:
        """Return the motion that bounces for ever with impacts at this angle.

        It needs e = 1 and enough static friction in the impacts: simulate its start with a hoop of
        `restitution=1`.

        Parameters
        ----------
        angle : float
            Angle φ of the impacts, 0 < φ < π, rad.

        Returns
        -------
        littlewood.bouncing.BouncingOrbit or None
            None for a massless or a balanced hoop, for an angle out of range, and where the rim
            would cross the plane.

        Examples
        --------
        >>> import littlewood as lw
        >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=1)
        >>> orbit = hoop.bouncing_orbit(1.0)
        >>> motion = hoop.simulate(**vars(orbit.start), until=3 * orbit.period)
        >>> {phase.mode for phase in motion.phases}
        {'flight'}
        """
        angle = real(angle, "angle")
        found = _core.bouncing_orbit(self._given, angle)
        if found is None:
            return None
        return BouncingOrbit(
            angle=angle,
            top_rate=found["top_rate"],
            bottom_rate=found["bottom_rate"],
            gap_rate=found["gap_rate"],
            friction=found["friction"],
            period=found["period"],
            start=Start(**found["start"]),
        )

    def require_units(self) -> Units:
        """Return the units, or raise ValueError if the hoop has none."""
        if self.units is None:
            raise ValueError("this hoop has no units: make it by Hoop.from_si to work in SI units")
        return self.units

    def _repr_html_(self) -> str:
        return hoop_html(self)
