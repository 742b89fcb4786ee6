"""Littlewood's hoop in closed form (section 3 of the paper): massless, the particle on the rim.

Angles θ are in radians, times in √(R/g), rates θ′ in √(g/R), slip velocities in √(gR), energies e
in m2 g R, forces in m2 g. `theta`, `theta_rate` and `slip` are the state, or the start where there
is a time `elapsed` = Δτ since then. All arguments broadcast: arrays of any shape, scalars, or
xarray objects. Misprints of the paper are corrected and noted.
"""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _core
from ._internal.elementwise import broadcast
from .tables import ROLLING_TYPES

__all__ = [
    "ROLLING_TYPES",
    "alpha",
    "gliding_path",
    "gliding_time_to_plane",
    "in_rolling_region",
    "rolling_angle",
    "rolling_energy",
    "rolling_friction",
    "rolling_half_sine",
    "rolling_normal",
    "rolling_time_to_plane",
    "rolling_type",
    "slip_angle",
    "slip_time_from_top",
    "stable_manifold_rate",
    "unloading_time_from_top",
    "unstable_manifold_rate",
]


def rolling_energy(theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
    """Conserved energy of rolling, e = (1 + cos θ) θ′² + cos θ (3.2)."""
    return broadcast(_core.rolling_energy, theta, theta_rate)


def alpha(theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
    """Amplitude of the growing exponential in (3.3), α = sin(θ0/2) + θ0′ cos(θ0/2).

    It is zero on the stable manifold. Printed in (3.4) as sin(θ0/2) + √((e0 − cos θ0)/2), which
    holds for θ0′ ≥ 0 only.
    """
    return broadcast(_core.alpha, theta, theta_rate)


def rolling_half_sine(
    theta: npt.ArrayLike, theta_rate: npt.ArrayLike, elapsed: npt.ArrayLike
) -> Any:
    """Sine of half the angle while rolling.

    It is sin(θ/2) = sin(θ0/2) cosh(Δτ/2) + θ0′ cos(θ0/2) sinh(Δτ/2).

    This is (3.3) with the right α and with exponents ±(τ − τ0)/2 (printed: τ − τ0/2). It contains
    (3.5) to (3.7). Beyond ±1 the motion has ended before.
    """
    return broadcast(_core.rolling_half_sine, theta, theta_rate, elapsed)


def rolling_angle(theta: npt.ArrayLike, theta_rate: npt.ArrayLike, elapsed: npt.ArrayLike) -> Any:
    """Angle θ while rolling after Δτ, for a start with |θ0| ≤ π.

    NaN after the particle has reached the plane.
    """
    return broadcast(_core.rolling_angle, theta, theta_rate, elapsed)


def rolling_time_to_plane(theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
    """Time in which rolling without end would bring the particle to the plane, θ = ±π.

    Infinite on the stable manifold.
    """
    return broadcast(_core.rolling_time_to_plane, theta, theta_rate)


def stable_manifold_rate(theta: npt.ArrayLike) -> Any:
    """Rate θ′ = −tan(θ/2) on the stable manifold of the equilibrium θ = 0, where e = 1 (3.7)."""
    return broadcast(_core.stable_manifold_rate, theta)


def unstable_manifold_rate(theta: npt.ArrayLike) -> Any:
    """Rate θ′ = tan(θ/2) on the unstable manifold of the equilibrium θ = 0, where e = 1 (3.7)."""
    return broadcast(_core.unstable_manifold_rate, theta)


def rolling_normal(theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
    """Normal force while rolling, N = cos²(θ/2) (1 − θ′²) (3.8)."""
    return broadcast(_core.rolling_normal, theta, theta_rate)


def rolling_friction(theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
    """Friction force while rolling, F = (θ′² − 1) cos(θ/2) sin(θ/2) (3.8)."""
    return broadcast(_core.rolling_friction, theta, theta_rate)


def slip_angle(mu_s: npt.ArrayLike, offset: npt.ArrayLike = 1.0) -> Any:
    """Angle θ_s > 0 at which the hoop slips (3.9): 2 atan μs for the particle on the rim.

    For ℓ̂ < 1 (footnote 7) it is atan μs + asin(μs/(ℓ̂ √(1 + μs²))). NaN where static friction
    always suffices. The caption of Figure 5 has half of the right value.
    """
    return broadcast(_core.slip_angle, mu_s, offset)


def in_rolling_region(theta: npt.ArrayLike, theta_rate: npt.ArrayLike, mu_s: npt.ArrayLike) -> Any:
    """Region R of Littlewood's hoop (3.10): |θ| < θ_s and |θ′| < 1."""
    return broadcast(_core.in_rolling_region, theta, theta_rate, mu_s, dtype=np.bool_)


def rolling_type(energy: npt.ArrayLike, mu_s: npt.ArrayLike) -> Any:
    """Type of a motion that starts in R (section 3a), by its energy e (3.2).

    Type I (N vanishes before the hoop slips): 1 + 2 cos θ_s < e < 3; type II (both at once):
    e = 1 + 2 cos θ_s; type III (the hoop slips first): cos θ_s < e < 1 + 2 cos θ_s.
    The codes are 1, 2, 3; 0 where no motion in R has this energy. `ROLLING_TYPES` has the names.
    """
    return broadcast(_core.rolling_type, energy, mu_s, dtype=np.uint8)


def slip_time_from_top(theta_rate: npt.ArrayLike, mu_s: npt.ArrayLike) -> Any:
    """Time at which a hoop that rolls from the top slips, τ = 2 asinh(sin(θ_s/2)/θ0′) by (3.6)."""
    return broadcast(_core.slip_time_from_top, theta_rate, mu_s)


def unloading_time_from_top(theta_rate: npt.ArrayLike) -> Any:
    """Time at which N = 0 for a hoop that rolls from the top.

    It is τ = arccosh(1/θ0′²), where cos θ = θ0′².

    NaN for |θ0′| > 1.
    """
    return broadcast(_core.unloading_time_from_top, theta_rate)


def gliding_time_to_plane(theta: npt.ArrayLike, theta_rate: npt.ArrayLike) -> Any:
    """Time of a glide to θ = ±π, the positive root of (3.20).

    τ_g − τ0 = −θ0′ sin θ0 + √(θ0′² sin²θ0 + 2(1 + cos θ0)).
    """
    return broadcast(_core.gliding_time_to_plane, theta, theta_rate)


def gliding_path(
    theta: npt.ArrayLike, theta_rate: npt.ArrayLike, slip: npt.ArrayLike, elapsed: npt.ArrayLike
) -> tuple[Any, Any]:
    """Position of the particle of a gliding hoop after Δτ (3.19): a parabola, or a vertical line.

    Returns the horizontal distance from the start and the height over the plane, R.
    """
    x, y = broadcast(_core.gliding_path, theta, theta_rate, slip, elapsed, outputs=2)
    return x, y
