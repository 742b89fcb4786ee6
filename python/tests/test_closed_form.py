import math

import numpy as np
import pytest
import xarray

import littlewood as lw
from littlewood import closed_form as cf


def test_figure_7():
    # θ = 0, θ′ = 1/2, μs = 1/2: τ_s = ln 5, cos θ_s = 3/5, τ_g − τ_s = (√89 − 3)/5.
    assert cf.slip_time_from_top(0.5, 0.5) == pytest.approx(math.log(5), rel=1e-15)
    theta = cf.slip_angle(0.5)
    assert math.cos(theta) == pytest.approx(0.6, rel=1e-15)
    assert cf.rolling_angle(0.0, 0.5, math.log(5)) == pytest.approx(theta, rel=1e-14)
    assert cf.gliding_time_to_plane(theta, 0.75) == pytest.approx(
        (math.sqrt(89) - 3) / 5, rel=1e-14
    )
    motion = lw.case("figure-7").simulate()
    assert motion.transitions[0].time == pytest.approx(math.log(5), rel=1e-14)


def test_they_broadcast():
    theta = np.linspace(-1.0, 1.0, 5)
    rate = np.linspace(-0.9, 0.9, 7)[:, None]
    energy = cf.rolling_energy(theta, rate)
    assert energy.shape == (7, 5)
    np.testing.assert_allclose(energy, (1 + np.cos(theta)) * rate**2 + np.cos(theta), rtol=1e-15)
    np.testing.assert_allclose(
        cf.rolling_normal(theta, rate), np.cos(theta / 2) ** 2 * (1 - rate**2), rtol=1e-14
    )
    assert isinstance(cf.alpha(0.3, 0.2), float)
    with pytest.raises(ValueError, match="broadcast"):
        cf.alpha(np.zeros(3), np.zeros(4))


def test_they_broadcast_by_names():
    theta = xarray.DataArray([0.0, 0.5], dims="theta", coords={"theta": [0.0, 0.5]})
    rate = xarray.DataArray([0.1, 0.2, 0.3], dims="rate")
    found = cf.in_rolling_region(theta, rate, 0.5)
    assert found.dims == ("theta", "rate")
    assert found.dtype == bool
    x, y = cf.gliding_path(theta, 0.1, 0.0, rate)
    assert x.dims == y.dims == ("theta", "rate")
    lazy = cf.rolling_energy(theta.chunk(1), rate)
    np.testing.assert_array_equal(lazy.compute(), cf.rolling_energy(theta, rate))


def test_the_three_types():
    mu_s = 0.5
    both = 1 + 2 * 0.6
    energies = [0.5, 1.0, both - 0.1, both + 0.1, 3.5, math.nan]
    assert [cf.ROLLING_TYPES[code] for code in cf.rolling_type(energies, mu_s)] == [
        "",
        "III",
        "III",
        "I",
        "",
        "",
    ]


def test_what_does_not_exist_is_nan_or_infinite():
    assert math.isnan(cf.rolling_angle(0.0, 0.5, 10.0))
    assert math.isinf(
        cf.rolling_time_to_plane(0.8, cf.stable_manifold_rate(0.8) * 0 - math.tan(0.4))
    ) or (cf.rolling_time_to_plane(0.8, -math.tan(0.4)) > 60)
    assert cf.rolling_time_to_plane(0.0, 0.0) == math.inf
    # Footnote 7: with the particle inside, enough friction always suffices: μs ≥ ℓ/√(1 − ℓ²).
    assert math.isnan(cf.slip_angle(1.0, 0.6))
    assert cf.slip_angle([0.5, 0.5], [1.0, 0.9]).tolist()[0] == pytest.approx(2 * math.atan(0.5))
    with pytest.raises(lw.ParameterError, match=r"offset = 1\.5"):
        cf.slip_angle(0.5, 1.5)


def test_the_phase_plane(hoop):
    plane = hoop.phase_plane
    theta = np.linspace(-3.0, 3.0, 61)
    rate = plane.slip_rate(theta, 1)
    there = np.isfinite(rate)
    assert 0 < there.sum() < there.size
    needed, most = np.abs(plane.friction(theta, rate)), 0.5 * plane.normal(theta, rate)
    np.testing.assert_allclose(needed[there], most[there], atol=1e-13)
    n = plane.normal_force_rate(theta)
    np.testing.assert_allclose(plane.normal(theta, n)[np.isfinite(n)], 0.0, atol=1e-12)
    lift = plane.lift_off_rate(theta)
    np.testing.assert_allclose((0.5 * np.cos(theta) * lift**2)[np.isfinite(lift)], 1.0, rtol=1e-14)
    assert plane.level_rate(0.0, 1.0) == 0.0
    assert plane.separatrix_rate(0.0) == 0.0
    with pytest.raises(ValueError, match="direction"):
        plane.slip_rate(0.0, 0)


def test_regions_have_names(hoop):
    theta, rate = np.array([0.0, 0.0, -1.2, 1.5707963]), np.array([0.5, 4.0, 2.0, 2.0])
    codes = hoop.phase_plane.region(theta, rate)
    assert [lw.tables.REGIONS[code] for code in codes] == [
        "rolling_region",
        "loss_of_contact",
        "sliding_band",
        "beyond_friction",
    ]
    # One by one they are those of the classification.
    assert [lw.tables.REGIONS[c] for c in codes] == [
        hoop.classify(theta=a, theta_rate=b).region for a, b in zip(theta, rate, strict=True)
    ]
    assert hoop.phase_plane.region(theta, rate[:, None]).shape == (4, 4)
    with pytest.raises(lw.ParameterError) as caught:
        hoop.phase_plane.region([0.0, math.inf], 0.0)
    assert caught.value.index == 1


def test_equilibria(hoop):
    top, bottom = hoop.phase_plane.equilibria
    # D(0) = 1.5 + 2 · 1.5² = 6, D(π) = 1.5 + 2 · 0.5² = 2.
    assert (top.theta, top.stability, top.rate) == (
        0.0,
        "unstable",
        pytest.approx(math.sqrt(1 / 6)),
    )
    assert (bottom.theta, bottom.stability, bottom.rate) == (
        math.pi,
        "stable",
        pytest.approx(math.sqrt(1 / 2)),
    )
    assert len(lw.case("figure-7").hoop.phase_plane.equilibria) == 1
