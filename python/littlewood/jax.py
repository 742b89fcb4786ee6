"""Summaries of motions as functions that JAX differentiates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any

from .differentiable import Problem
from .extras import require
from .hoop import Hoop

__all__ = ["summary"]


def summary(
    columns: Iterable[str], hoop: Hoop | None = None, **fixed: Any
) -> Callable[[Mapping[str, Any]], dict[str, Any]]:
    """Return a function of quantities whose values are columns of a summary, with exact derivatives.

    The function is a ``jax.custom_jvp``: ``jax.grad``, ``jax.jvp`` and the others take the
    derivatives of :func:`littlewood.simulate_many`, also through stick, slip, lift-off and impacts.
    It can be compiled (``jax.jit``) and mapped (``jax.vmap``); the motions are simulated on the
    host, many at once.

    Parameters
    ----------
    columns : iterable of str
        Variables of :func:`littlewood.simulate_many` that are real numbers, such as
        `"jump_length"`.
    hoop : Hoop, optional
        Supplies the parameters of the hoop that are given nowhere else.
    **fixed
        Quantities of the start and the hoop that stay as they are, and the limits (`until`, …) of
        :func:`littlewood.simulate_many`.

    Returns
    -------
    evaluate : callable
        It takes a dictionary of quantities, numbers or arrays that broadcast, and returns one of
        the columns. What does not happen is NaN, and so is a derivative that does not exist.

    Notes
    -----
    JAX computes in single precision unless `jax_enable_x64` is set; the motions are followed in double precision.

    Examples
    --------
    >>> import jax, littlewood as lw, littlewood.jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> jump = littlewood.jax.summary(["lift_off_time"], hoop, theta=2.5, theta_rate=3.0)
    >>> slope = jax.grad(lambda mu_k: jump({"mu_k": mu_k})["lift_off_time"])(0.4)
    """
    jax = require("jax")
    jnp = require("jax.numpy")
    problem = Problem(columns, hoop, fixed)

    def on_host(compute: Callable[..., Any], count: int, values: Mapping[str, Any]) -> Any:
        names = tuple(sorted(values))
        arrays = jnp.broadcast_arrays(
            *(jnp.asarray(values[name], jnp.result_type(float)) for name in names)
        )
        result = jax.ShapeDtypeStruct(arrays[0].shape, arrays[0].dtype)
        call = partial(_as_type, partial(compute, names), arrays[0].dtype)
        return jax.pure_callback(call, (result,) * count, *arrays, vmap_method="broadcast_all")

    def numbers(values: Mapping[str, Any]) -> dict[str, Any]:
        return dict(
            zip(
                problem.columns, on_host(problem.numbers, len(problem.columns), values), strict=True
            )
        )

    def rule(primals: Any, tangents: Any) -> Any:
        (values,), (rates,) = primals, tangents
        names = sorted(values)
        count = len(problem.columns)
        found = on_host(problem.numbers_and_slopes, count * (1 + len(names)), values)
        summaries = dict(zip(problem.columns, found[:count], strict=True))
        changes = {}
        for place, column in enumerate(problem.columns):
            slopes = found[count + place * len(names) :][: len(names)]
            changes[column] = sum(
                slope * rates[name] for slope, name in zip(slopes, names, strict=True)
            )
        return summaries, changes

    evaluate: Callable[[Mapping[str, Any]], dict[str, Any]] = jax.custom_jvp(numbers)
    evaluate.defjvp(rule)  # type: ignore[attr-defined]
    return evaluate


def _as_type(compute: Callable[..., Any], dtype: Any, *arrays: Any) -> Any:
    return tuple(array.astype(dtype) for array in compute(*arrays))
