"""Derivatives in sweeps, and the functions that JAX and PyTorch differentiate."""

from __future__ import annotations

import importlib.util

import numpy as np
import pytest

import littlewood as lw

HOOP = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0.5)
START = {"theta": 2.5, "theta_rate": 3.0, "until": 20.0}
NAMES = [
    "jump_length_by_mu_k",
    "end_x_by_theta_rate",
    "energy_by_inertia",
    "lift_off_time_by_theta",
]
# The environment of the tests has no torch, which is gigabytes.
has_torch = pytest.mark.skipif(
    importlib.util.find_spec("torch") is None, reason="torch is not installed"
)


def _of_motion(name: str, **start: float) -> float:
    """The derivative from one motion, by the transitions that the column is read off."""
    column, quantity = name.split("_by_")
    motion = HOOP.simulate(**start)
    found = motion.derivatives([quantity]).isel(quantity=0)
    causes = [transition.cause for transition in motion.transitions]
    if column == "lift_off_time":
        return float(found.time[causes.index("lift_off")])
    assert column == "jump_length"
    off, down = causes.index("lift_off"), causes.index("landing")
    sign = np.sign(motion.transitions[down].after.x - motion.transitions[off].after.x)
    return float(sign * (found.x[down] - found.x[off]))


def test_columns_are_the_derivatives_of_the_events() -> None:
    names = [
        "jump_length_by_mu_k",
        "jump_length_by_theta",
        "lift_off_time_by_theta",
        "lift_off_time_by_inertia",
        # From within: the hoop has none.
        "lift_off_time_by_rolling_resistance",
    ]
    rates = np.array([2.8, 3.0, 3.2])
    found = lw.simulate_many(HOOP, theta=2.5, theta_rate=rates, until=20.0, derivatives=names)
    assert np.isfinite(found.jump_length).all()
    for name in names:
        expected = [_of_motion(name, theta=2.5, theta_rate=rate, until=20.0) for rate in rates]
        np.testing.assert_allclose(found[name], expected, rtol=1e-12, atol=1e-14)
    assert found["lift_off_time_by_theta"].attrs == {
        "long_name": "derivative of the time of lift-off by the angle of the particle from the "
        "upward vertical",
        "units": "rad-1",
        "scale": "sqrt(R/g)",
    }


def test_what_does_not_happen_and_what_has_no_derivative_is_nan() -> None:
    # At rest at the bottom nothing happens; at the start of a slip from rest the two sides differ.
    found = lw.simulate_many(
        HOOP,
        theta=[np.pi, 2.5],
        theta_rate=[0.0, 3.0],
        until=20.0,
        derivatives=["jump_length_by_mu_k", "end_x_by_slip", "end_theta_by_theta"],
    )
    assert np.isnan(found.jump_length_by_mu_k[0])
    assert np.isnan(found.end_x_by_slip).all()
    assert np.isfinite(found.end_theta_by_theta).all()


def test_blocks_give_the_same_derivatives() -> None:
    theta, rate = np.linspace(-2, 2, 5), np.linspace(0.5, 3, 4)
    whole = lw.outcome_map(HOOP, theta=theta, theta_rate=rate, until=10.0, derivatives=NAMES)
    lazy = lw.outcome_map(
        HOOP, theta=theta, theta_rate=rate, until=10.0, derivatives=NAMES, chunks=2
    )
    assert lazy[NAMES[0]].chunks is not None
    assert whole.identical(lazy.compute())


@pytest.mark.parametrize(
    ("names", "message"),
    [
        (["outcome_by_theta"], "there is no derivative named 'outcome_by_theta'"),
        (["end_x_by_gravity"], "NUMBER_by_QUANTITY"),
        (["end_x"], "there is no derivative named 'end_x'"),
    ],
)
def test_unknown_names_are_refused(names: list[str], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        lw.simulate_many(HOOP, theta=1.0, theta_rate=1.0, derivatives=names)


def test_restitution_without_restitution_is_refused() -> None:
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    with pytest.raises(ValueError, match="no coefficient of restitution"):
        lw.simulate_many(hoop, theta=1.0, theta_rate=1.0, derivatives=["end_x_by_restitution"])


def test_jax_takes_gradients_and_maps() -> None:
    jax = pytest.importorskip("jax")
    import littlewood.jax

    jax.config.update("jax_enable_x64", True)
    jump = littlewood.jax.summary(["jump_length", "settle_time", "first_slip_time"], HOOP, **START)
    expected = lw.simulate_many(
        HOOP, **START, derivatives=["jump_length_by_mu_k", "jump_length_by_inertia"]
    )
    values = {"mu_k": 0.4, "inertia": 1.0}
    slopes = jax.grad(lambda given: jump(given)["jump_length"])(values)
    assert float(slopes["mu_k"]) == float(expected.jump_length_by_mu_k)
    assert float(slopes["inertia"]) == float(expected.jump_length_by_inertia)
    compiled = jax.jit(
        jax.value_and_grad(lambda mu_k: jump({"mu_k": mu_k, "inertia": 1.0})["jump_length"] ** 2)
    )
    value, slope = compiled(0.4)
    assert float(value) == float(expected.jump_length) ** 2
    np.testing.assert_allclose(
        slope, 2 * float(expected.jump_length) * float(expected.jump_length_by_mu_k), rtol=1e-15
    )
    each = jax.vmap(jax.grad(lambda mu_k: jump({"mu_k": mu_k})["jump_length"]))(
        np.array([0.35, 0.4])
    )
    many = lw.simulate_many(HOOP, **START, mu_k=[0.35, 0.4], derivatives=["jump_length_by_mu_k"])
    np.testing.assert_array_equal(each, many.jump_length_by_mu_k)
    # One vector of starts, and its tangents.
    rates = np.array([2.8, 3.0, 3.2])
    start = {name: value for name, value in START.items() if name != "theta_rate"}
    of_rates = littlewood.jax.summary(["end_x"], HOOP, **start)
    _, changes = jax.jvp(of_rates, ({"theta_rate": rates},), ({"theta_rate": np.ones(3)},))
    straight = lw.simulate_many(
        HOOP, **start, theta_rate=rates, derivatives=["end_x_by_theta_rate"]
    )
    np.testing.assert_array_equal(changes["end_x"], straight.end_x_by_theta_rate)


def test_jax_refuses_what_has_no_derivative_by_name() -> None:
    pytest.importorskip("jax")
    import littlewood.jax

    with pytest.raises(ValueError, match=r"columns has 'outcome'; it can have end_time"):
        littlewood.jax.summary(["outcome"], HOOP)


# The first start never lifts off; of the second and third the jump is measured.
BATCH = np.array([0.1, 2.8, 3.2])


def _of_batch() -> tuple[np.ndarray, float]:
    """Derivatives of the mean jump of a batch: by each rate of the start, and by mu_k."""
    found = lw.simulate_many(
        HOOP,
        theta=2.5,
        theta_rate=BATCH,
        until=20.0,
        derivatives=["jump_length_by_theta_rate", "jump_length_by_mu_k"],
    )
    assert np.isnan(found.jump_length.to_numpy()).tolist() == [True, False, False]
    each = np.nan_to_num(found.jump_length_by_theta_rate.to_numpy()) / 2
    return each, float(found.jump_length_by_mu_k[1:].sum()) / 2


@pytest.mark.parametrize("compiled", [False, True])
def test_jax_takes_the_gradient_of_a_batch_without_the_starts_that_do_not_jump(
    compiled: bool,
) -> None:
    jax = pytest.importorskip("jax")
    import jax.numpy as jnp

    import littlewood.jax

    jax.config.update("jax_enable_x64", True)
    jump = littlewood.jax.summary(["jump_length"], HOOP, theta=2.5, until=20.0)

    def mean(rates, mu_k):
        length = jump({"theta_rate": rates, "mu_k": mu_k})["jump_length"]
        happens = ~jnp.isnan(length)
        return jnp.where(happens, length, 0.0).sum() / happens.sum()

    def through_nan(rates, mu_k):
        # The logarithm makes a rate of NaN of the start that does not jump.
        length = jump({"theta_rate": rates, "mu_k": mu_k})["jump_length"]
        return jnp.where(jnp.isnan(length), 0.0, jnp.log(length**2)).sum()

    follow = jax.jit if compiled else (lambda function: function)
    each, shared = _of_batch()
    of_each, of_shared = follow(jax.grad(mean, (0, 1)))(BATCH, 0.4)
    np.testing.assert_allclose(of_each, each, rtol=1e-14)
    np.testing.assert_allclose(of_shared, shared, rtol=1e-14)
    of_each, of_shared = follow(jax.grad(through_nan, (0, 1)))(BATCH, 0.4)
    assert of_each[0] == 0.0
    assert np.isfinite(of_each).all() and np.isfinite(of_shared)
    # Forwards, and start by start.
    _, change = follow(lambda mu_k: jax.jvp(lambda m: mean(BATCH, m), (mu_k,), (1.0,)))(0.4)
    np.testing.assert_allclose(change, shared, rtol=1e-14)
    alone = jax.grad(lambda rate, mu_k: jump({"theta_rate": rate, "mu_k": mu_k})["jump_length"], 1)
    mapped = follow(jax.vmap(alone, (0, None)))(BATCH, 0.4)
    assert mapped[0] == 0.0
    np.testing.assert_allclose(mapped.sum() / 2, shared, rtol=1e-14)


def test_a_derivative_that_does_not_exist_of_an_event_that_happens_stays_nan() -> None:
    jax = pytest.importorskip("jax")
    import littlewood.jax

    jax.config.update("jax_enable_x64", True)
    end = littlewood.jax.summary(["end_x"], HOOP, **START)
    value, slope = jax.value_and_grad(lambda slip: end({"slip": slip})["end_x"])(0.0)
    assert np.isfinite(value) and np.isnan(slope)


def _names_that_are_refused() -> list[tuple[dict[str, float], dict[str, float], str]]:
    return [
        (START, {"theta_rate": 3.0}, "theta_rate: given here, and fixed before"),
        ({"theta": 2.5}, {"thetarate": 3.0}, "there is no quantity thetarate; there are theta,"),
        ({"theta": 2.5}, {"mu_k": 0.4}, "missing: theta_rate"),
        (START, {"mu": 0.4}, "mu has no derivative: give mu_s and mu_k the same value"),
        ({**START, "mu": 0.4}, {"mu_k": 0.4}, "mu and mu_k: mu gives both"),
        (START, {}, "no quantity is given"),
    ]


@pytest.mark.parametrize(("fixed", "values", "message"), _names_that_are_refused())
def test_names_are_refused_before_anything_is_traced(fixed, values, message) -> None:
    jax = pytest.importorskip("jax")
    import littlewood.jax

    jump = littlewood.jax.summary(["jump_length"], HOOP, **fixed)

    def traced(values):
        return jump(values)["jump_length"]

    for call in (traced, jax.jit(traced), jax.grad(traced)):
        # Not the error of a callback, which is of another type.
        with pytest.raises((ValueError, TypeError), match=message) as caught:
            call(values)
        assert caught.type in (ValueError, TypeError)


def test_a_misspelt_name_that_is_fixed_is_refused_at_once() -> None:
    pytest.importorskip("jax")
    import littlewood.jax

    with pytest.raises(TypeError, match="nothing is named thetarate, untill; there are theta"):
        littlewood.jax.summary(["jump_length"], HOOP, theta=2.5, thetarate=3.0, untill=20.0)


def test_a_second_derivative_is_refused_by_name() -> None:
    jax = pytest.importorskip("jax")
    import littlewood.jax

    jump = littlewood.jax.summary(["jump_length"], HOOP, **START)

    def length(mu_k):
        return jump({"mu_k": mu_k})["jump_length"]

    for second in (jax.hessian(length), jax.grad(jax.grad(length)), jax.jit(jax.hessian(length))):
        with pytest.raises(TypeError, match="first derivatives only: no Hessian"):
            second(0.4)


@has_torch
def test_torch_takes_the_gradient_of_a_batch_without_the_starts_that_do_not_jump() -> None:
    import torch

    import littlewood.torch

    jump = littlewood.torch.summary(["jump_length"], HOOP, theta=2.5, until=20.0)
    rates = torch.tensor(BATCH, requires_grad=True)
    mu_k = torch.tensor(0.4, dtype=torch.float64, requires_grad=True)
    each, shared = _of_batch()
    length = jump({"theta_rate": rates, "mu_k": mu_k})["jump_length"]
    happens = ~length.isnan()
    (torch.where(happens, length, 0.0).sum() / happens.sum()).backward()
    np.testing.assert_allclose(rates.grad.numpy(), each, rtol=1e-14)
    np.testing.assert_allclose(float(mu_k.grad), shared, rtol=1e-14)
    # The logarithm makes a rate of NaN of the start that does not jump.
    rates.grad = mu_k.grad = None
    length = jump({"theta_rate": rates, "mu_k": mu_k})["jump_length"]
    torch.where(length.isnan(), 0.0, (length**2).log()).sum().backward()
    assert rates.grad[0] == 0.0
    assert torch.isfinite(rates.grad).all() and torch.isfinite(mu_k.grad)


@has_torch
@pytest.mark.parametrize(("fixed", "values", "message"), _names_that_are_refused())
def test_torch_refuses_the_same_names(fixed, values, message) -> None:
    import littlewood.torch

    jump = littlewood.torch.summary(["jump_length"], HOOP, **fixed)
    with pytest.raises((ValueError, TypeError), match=message):
        jump(values)


@has_torch
def test_torch_takes_gradients() -> None:
    import torch

    import littlewood.torch

    jump = littlewood.torch.summary(["jump_length", "first_slip_time"], HOOP, **START)
    mu_k = torch.tensor([0.35, 0.4], dtype=torch.float64, requires_grad=True)
    inertia = torch.tensor(1.0, dtype=torch.float64, requires_grad=True)
    # A column that is not used may be without a derivative.
    jump({"mu_k": mu_k, "inertia": inertia})["jump_length"].sum().backward()
    many = lw.simulate_many(
        HOOP,
        **START,
        mu_k=[0.35, 0.4],
        derivatives=["jump_length_by_mu_k", "jump_length_by_inertia"],
    )
    np.testing.assert_array_equal(mu_k.grad.numpy(), many.jump_length_by_mu_k)
    np.testing.assert_allclose(
        float(inertia.grad), float(many.jump_length_by_inertia.sum()), rtol=1e-15
    )
    assert torch.autograd.gradcheck(
        lambda m: jump({"mu_k": m})["jump_length"], (mu_k,), eps=1e-6, atol=1e-5
    )
