"""Summaries of motions as functions that PyTorch differentiates."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from ._internal.extras import require
from .hoop import Hoop
from .sweep.differentiable import Problem

__all__ = ["summary"]


def summary(
    columns: Iterable[str], hoop: Hoop | None = None, **fixed: Any
) -> Callable[[Mapping[str, Any]], dict[str, Any]]:
    """Return a function of quantities whose values are columns of a summary.

    It has exact derivatives.

    Its gradients are the derivatives of :func:`littlewood.simulate_many`, also through stick, slip,
    lift-off and impacts: an ``torch.autograd.Function``, which is differentiated once. The motions
    are simulated on the processor in double precision; results have the type and the device of the
    first quantity.

    Parameters
    ----------
    columns, hoop, **fixed
        As in :func:`littlewood.jax.summary`.

    Returns
    -------
    evaluate : callable
        It takes a dictionary of quantities, tensors that broadcast, and returns one of the columns.
        As in :func:`littlewood.jax.summary`, an event that does not happen has the value NaN and
        the derivative 0: ``~value.isnan()`` is the mask of a batch.

    Examples
    --------
    >>> import torch, littlewood as lw, littlewood.torch
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> jump = littlewood.torch.summary(["lift_off_time"], hoop, theta=2.5, theta_rate=3.0)
    >>> mu_k = torch.tensor(0.4, dtype=torch.float64, requires_grad=True)
    >>> jump({"mu_k": mu_k})["lift_off_time"].backward()
    """
    torch = require("torch")
    problem = Problem(columns, hoop, fixed)

    function: Any = torch.autograd.Function

    class Summary(function):  # type: ignore[misc]
        @staticmethod
        def forward(ctx: Any, names: tuple[str, ...], *values: Any) -> Any:
            arrays = [value.detach().cpu().double().numpy() for value in values]
            compute = problem.numbers_and_slopes if any(ctx.needs_input_grad) else problem.numbers
            found = [
                torch.from_numpy(array.copy()).to(values[0]) for array in compute(names, *arrays)
            ]
            ctx.save_for_backward(*found)
            # A column that is not used has no rate: its derivative, which may be NaN, then counts
            # for nothing.
            ctx.set_materialize_grads(False)
            return tuple(found[: len(problem.columns)])

        @staticmethod
        @torch.autograd.function.once_differentiable  # type: ignore[untyped-decorator]
        def backward(ctx: Any, *rates: Any) -> Any:
            columns, slopes = ctx.saved_tensors[: len(rates)], ctx.saved_tensors[len(rates) :]
            count = len(slopes) // len(rates)

            def of_quantity(place: int) -> Any:
                rows = zip(columns, slopes[place::count], rates, strict=True)
                # Also where the program has made a rate of NaN out of the NaN of the column.
                terms = [
                    (slope * rate).masked_fill(column.isnan(), 0.0)
                    for column, slope, rate in rows
                    if rate is not None
                ]
                return sum(terms) if terms else None

            return (None, *(of_quantity(place) for place in range(count)))

    def evaluate(values: Mapping[str, Any]) -> dict[str, Any]:
        problem.check(values)
        names = tuple(sorted(values))
        # Outside of the function, so that what is broadcast is summed again.
        tensors = torch.broadcast_tensors(*(values[name] for name in names))
        return dict(zip(problem.columns, Summary.apply(names, *tensors), strict=True))

    return evaluate
