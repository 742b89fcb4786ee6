"""The (θ, θ′) plane of rolling: regions N and R (2.14), boundary curves, separatrix, equilibria."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
import numpy.typing as npt

from . import _core
from ._internal.elementwise import broadcast
from ._protocols import HoopLike

__all__ = ["Equilibrium", "PhasePlane"]


@dataclass(frozen=True)
class Equilibrium:
    """An equilibrium of rolling (2.10), at θ′ = 0.

    Attributes
    ----------
    theta : float
        Angle, rad.
    stability : {"stable", "unstable", "neutral"}
        Centre, saddle, or one of the many of a homogeneous disc.
    rate : float
        Angular frequency √(ℓ̂/D(π)) of small oscillations about a centre, exponent √(ℓ̂/D(0)) of a
        saddle; √(g/R).
    """

    theta: float
    stability: str
    rate: float


class PhasePlane:
    """The phase plane of the rolling motions of one hoop.

    All methods broadcast over arrays of any shape (and xarray objects). Angles in rad, rates in
    √(g/R), forces in m2 g, energies in m2 g R. Curves are |θ′| over θ, NaN where they do not exist.

    With rolling resistance rolling one way has other limits than rolling the other, and no energy:
    forces and regions of states are there, of the curves as functions of θ only that of lift-off,
    and no equilibria. ``hoop.plot()`` draws the curves of each way and the band of rest.

    Parameters
    ----------
    hoop : Hoop
        The hoop.

    Examples
    --------
    >>> import littlewood as lw
    >>> plane = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4).phase_plane
    >>> bool(plane.in_rolling_region(0.5, 0.2))
    True
    """

    def __init__(self, hoop: HoopLike) -> None:
        self.hoop = hoop
        self._core = _core.PhasePlane(hoop._given)

    def __reduce__(self) -> tuple[Any, ...]:
        return PhasePlane, (self.hoop,)

    def __repr__(self) -> str:
        return f"PhasePlane({self.hoop!r})"

    def normal(self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
        """Normal force N that rolling needs (2.12)."""
        return broadcast(self._core.normal, theta, theta_rate)

    def friction(self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
        """Friction force F along E1 that rolling needs (2.12)."""
        return broadcast(self._core.friction, theta, theta_rate)

    def energy(self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
        """Energy E of rolling (2.8), constant along an orbit without rolling resistance."""
        return broadcast(self._core.energy, theta, theta_rate)

    def in_contact_region(self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
        """Region N of (2.14): N > 0."""
        return broadcast(self._core.in_contact_region, theta, theta_rate, dtype=np.bool_)

    def in_rolling_region(self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
        """Region R of (2.14): |F| ≤ μs N and N > 0."""
        return broadcast(self._core.in_rolling_region, theta, theta_rate, dtype=np.bool_)

    def region(
        self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike, slip: npt.ArrayLike = 0.0
    ) -> Any:
        """Part of the state space that starts lie in.

        Parameters
        ----------
        theta, theta_rate, slip : array_like
            Starts: θ in rad, θ′ in √(g/R), η′ in √(gR).

        Returns
        -------
        ndarray of uint8, or scalar
            Codes, the places of the names in :data:`littlewood.tables.REGIONS`.

        Raises
        ------
        ParameterError
            For a start that is not finite.
        """
        return broadcast(self._core.regions, theta, theta_rate, slip, dtype=np.uint8)

    def normal_force_rate(self, theta: npt.ArrayLike) -> Any:
        """|θ′| on the curve n, where N = 0 in rolling."""
        return broadcast(self._core.normal_force_rate, theta)

    def slip_rate(self, theta: npt.ArrayLike, direction: Literal[-1, 1]) -> Any:
        """|θ′| on the curve f, where |F| = μs N and the following slip has this direction.

        For a massless hoop f is a vertical line: :func:`littlewood.closed_form.slip_angle`.
        """
        if direction not in (-1, 1):
            raise ValueError(f"direction = {direction} must be -1 or +1")
        core = self._core
        return broadcast(
            core.positive_slip_rate if direction > 0 else core.negative_slip_rate, theta
        )

    def lift_off_rate(self, theta: npt.ArrayLike) -> Any:
        """|θ′| above which the body cannot stay in contact, h cos θ θ′² = cos α.

        Below this curve and above n the body slides at once although rolling would need N < 0.
        """
        return broadcast(self._core.lift_off_rate, theta)

    def separatrix_rate(self, theta: npt.ArrayLike) -> Any:
        """|θ′| on the separatrix through the unstable equilibrium, θ′² = 4ℓ̂ sin²(θ/2)/D(θ)."""
        return broadcast(self._core.separatrix_rate, theta)

    def reverse_chatter(self, theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
        """Ratio of successive bounces where bounces can grow out of rolling, NaN elsewhere.

        Only on a slope, and with a coefficient of restitution.
        """
        return broadcast(self._core.reverse_chatter, theta, theta_rate)

    def level_rate(self, theta: npt.ArrayLike, energy: npt.ArrayLike) -> Any:
        """|θ′| on the orbit of energy E, θ′² = 2(E − ℓ̂ cos θ)/D(θ)."""
        return broadcast(self._core.level_rate, theta, energy)

    @property
    def equilibria(self) -> tuple[Equilibrium, ...]:
        """The equilibria in (−π, π]."""
        return tuple(Equilibrium(**one) for one in self._core.equilibria())
