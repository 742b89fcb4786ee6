"""Summaries of motions as functions that JAX differentiates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any

from ._internal.extras import require
from .hoop import Hoop
from .sweep.differentiable import FIRST_ONLY, Problem

__all__ = ["summary"]


def summary(
    columns: Iterable[str], hoop: Hoop | None = None, **fixed: Any
) -> Callable[[Mapping[str, Any]], dict[str, Any]]:
    """Return a function of quantities whose values are columns of a summary.

    It has exact derivatives.

    The function has a ``jax.custom_jvp``: ``jax.grad``, ``jax.jvp`` and the others take the
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
        the columns.

    Raises
    ------
    TypeError, ValueError
        For a name that is unknown, or given both here and there, before anything is traced;
        for a second derivative (``jax.hessian``), since only first ones exist.

    Notes
    -----
    An event that does not happen has the value NaN and the derivative 0, whatever is computed from
    it: in a batch, ``~jnp.isnan(value)`` is the mask of the starts that have one, and the others
    do not touch the gradient. A derivative that does not exist of an event that happens, as where
    the motion grazes, is NaN; ``jax.vmap`` of the gradient tells which start it is.

    JAX computes in single precision unless `jax_enable_x64` is set; the motions are followed in
    double precision.

    Examples
    --------
    >>> import jax, littlewood as lw, littlewood.jax
    >>> jax.config.update("jax_enable_x64", True)
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> jump = littlewood.jax.summary(["lift_off_time"], hoop, theta=2.5, theta_rate=3.0)
    >>> slope = jax.grad(lambda mu_k: jump({"mu_k": mu_k})["lift_off_time"])(0.4)

    The mean over those starts of a batch that lift off:

    >>> import jax.numpy as jnp
    >>> batch = littlewood.jax.summary(["lift_off_time"], hoop, theta=2.5)
    >>> def mean(mu_k):
    ...     time = batch({"theta_rate": jnp.array([0.1, 3.0]), "mu_k": mu_k})["lift_off_time"]
    ...     happens = ~jnp.isnan(time)
    ...     return jnp.where(happens, time, 0.0).sum() / happens.sum()
    >>> bool(jax.grad(mean)(0.4) == slope)
    True
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

    def numbers_and_slopes(values: Mapping[str, Any]) -> Any:
        count = len(problem.columns) * (1 + len(values))
        return on_host(problem.numbers_and_slopes, count, values)

    def no_second_rule(primals: Any, tangents: Any) -> Any:
        raise TypeError(FIRST_ONLY)

    first_only = jax.custom_jvp(numbers_and_slopes)
    first_only.defjvp(no_second_rule)

    def rule(primals: Any, tangents: Any) -> Any:
        (values,), (rates,) = primals, tangents
        names = sorted(values)
        count = len(problem.columns)
        found = first_only(values)
        summaries = dict(zip(problem.columns, found[:count], strict=True))
        changes = {}
        for place, column in enumerate(problem.columns):
            slopes = found[count + place * len(names) :][: len(names)]
            change = sum(slope * rates[name] for slope, name in zip(slopes, names, strict=True))
            # Also where the program has made a rate of NaN out of the NaN of the column.
            changes[column] = jnp.where(jnp.isnan(summaries[column]), 0.0, change)
        return summaries, changes

    follow = jax.custom_jvp(numbers)
    follow.defjvp(rule)

    def evaluate(values: Mapping[str, Any]) -> dict[str, Any]:
        problem.check(values)
        found: dict[str, Any] = follow(values)
        return found

    return evaluate


def _as_type(compute: Callable[..., Any], dtype: Any, *arrays: Any) -> Any:
    return tuple(array.astype(dtype) for array in compute(*arrays))
