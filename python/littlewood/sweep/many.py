"""Simulate many starts into one data set: on all cores, or in blocks on a cluster."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, TypedDict

import numpy as np
import numpy.typing as npt

from .. import _core
from .._internal.counts import checked_count
from .._internal.elementwise import flat
from .._internal.extras import progress_bar, require
from .._internal.variables import CONVENTIONS, RESULTS, checked_derivatives, result_attributes
from ..hoop import Hoop
from ..tables import MAX_SLIDES, MAX_TRANSITIONS, PROOF
from .block import Limits, compute
from .lazy import lazy_columns
from .points import Points, broadcast, check_hoop, fill, grid

if TYPE_CHECKING:
    import xarray
    from typing_extensions import Unpack

__all__ = ["outcome_map", "sequence_names", "simulate_many"]


class Quantities(TypedDict, total=False):
    """What can vary: arrays, DataArrays, arrays of Dask, or numbers."""

    theta: Any
    theta_rate: Any
    slip: Any
    gap_rate: Any
    mass_ratio: Any
    offset: Any
    inertia: Any
    mu_s: Any
    mu_k: Any
    mu: Any
    rolling_resistance: Any
    slope: Any
    restitution: Any


def simulate_many(
    hoop: Hoop | None = None,
    *,
    restitution_law: str | None = None,
    until: float | None = None,
    max_transitions: int = MAX_TRANSITIONS,
    max_slides: int = MAX_SLIDES,
    proof: str = PROOF,
    chunks: Any = None,
    threads: int | None = None,
    progress: bool = False,
    derivatives: Iterable[str] = (),
    **quantities: Unpack[Quantities],
) -> xarray.Dataset:
    """Simulate many motions and keep a summary of each.

    Starts and hoops broadcast: NumPy arrays by position, DataArrays by the names of their
    dimensions. All cores are used, the GIL is released, and Ctrl-C stops at once.

    Parameters
    ----------
    hoop : Hoop, optional
        Supplies the parameters of the hoop that are not given by name.
    restitution_law : {"energetic", "poisson", "newton"}, optional
        Law of restitution, for all; that of the hoop by default.
    theta, theta_rate : array_like
        Angle θ, rad, and rate θ′, √(g/R).
    slip : array_like, optional
        Slip velocity η′, √(gR); 0 by default.
    gap_rate : array_like, optional
        Rate at which the gap under the rim opens, √(gR); 0 by default.
    mass_ratio, offset, inertia, slope, restitution : array_like, optional
        Parameters of the hoop, as in :class:`Hoop`. Without a coefficient of restitution motions
        end where the rim lands; NaN is not allowed.
    mu_s, mu_k, mu, rolling_resistance : array_like, optional
        Friction of the hoop, likewise; `mu` is both coefficients of friction.
    until : float, optional
        Time τ at which to stop, √(R/g). By default to the end of each motion.
    max_transitions : int, optional
        Largest number of transitions of a motion.
    max_slides : int, optional
        Largest length of all slides of a motion together, as in :meth:`Hoop.simulate`.
    proof : {"endless", "contact", "none"}, optional
        Proof that ends a motion without a time limit: that it is periodic or slips for ever; also,
        as soon as possible, that it never lifts off; or only that a phase is endless.
    chunks : int, dict, tuple or "auto", optional
        Sizes of blocks, as in :meth:`xarray.Dataset.chunk`, for a lazy result of Dask arrays.
        Quantities given as Dask arrays also make it lazy.
    threads : int, optional
        Number of threads, at most 1024; all cores by default. Blocks of Dask take one each.
    progress : bool, optional
        Whether to show a progress bar (tqdm); for lazy results Dask has its own.
    derivatives : iterable of str, optional
        Derivatives to compute, as `"jump_length_by_mu_k"`: of one of the variables that are real
        numbers by a quantity of the hoop or the start. NaN where it does not exist, or the number
        is absent. Each motion is then simulated once more, which takes some tenths of a
        millisecond.

    Returns
    -------
    xarray.Dataset
        Of the common shape, with `outcome`, `sequence`, `transitions`, `painleve`, `end_time`,
        `end_theta`, `end_theta_rate`, `end_slip`, `end_x`, `energy`, `first_slip_time`,
        `lift_off_time`, `jump_length` and `jump_height` of the first flight, `landings`,
        `impact_energy_lost`, `settle_time` and `half_swings`, with their units and long names, and
        the derivatives. Events that do not happen are NaN. Dimensions are those of the DataArrays;
        of arrays `start`, or `dim_0`, `dim_1`, … The attribute `restitution_law` has the law of
        restitution, if there is one.

    Raises
    ------
    ParameterError
        For the first start or hoop, in the order of the points, with a value without physical
        meaning; `index` is its index. Where two parameters that vary contradict each other (μk >
        μs, a point mass at the centre, an impact of a massless hoop) the outcome is `invalid`
        instead.

    Notes
    -----
    256 starts or more of one hoop, along dimensions that its parameters do not have, share the
    series of its slides, which is faster and changes times by a few units in the last place.
    Results do not depend on blocks or threads.

    Of such a hoop long chains of slips, of hundreds to many thousands, are interpolated: the map
    from one slip to the next is computed at nodes, checked halfway between them, and not proved
    elsewhere, so that a phase, and with it an outcome, could be missed. The tests search for such a
    motion and have found none. :meth:`Hoop.simulate` solves every slip.

    Examples
    --------
    >>> import numpy as np, littlewood as lw
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> result = lw.simulate_many(hoop, theta=0.0, theta_rate=np.array([0.5, 4.0]))
    >>> lw.sequence_names(result.sequence).tolist()
    ['R', 'F']
    """
    values = fill(hoop, quantities)
    law = _law(hoop, restitution_law, values)
    points = broadcast(values, law)
    return _simulate(
        points, until, max_transitions, max_slides, proof, chunks, threads, progress, derivatives
    )


def outcome_map(
    hoop: Hoop | None = None,
    *,
    restitution_law: str | None = None,
    until: float | None = None,
    max_transitions: int = MAX_TRANSITIONS,
    max_slides: int = MAX_SLIDES,
    proof: str = PROOF,
    chunks: Any = None,
    threads: int | None = None,
    progress: bool = False,
    derivatives: Iterable[str] = (),
    **quantities: Unpack[Quantities],
) -> xarray.Dataset:
    """Simulate a grid of motions.

    Each quantity that is given as a one-dimensional array is an axis.

    Parameters
    ----------
    hoop, restitution_law, until, max_transitions, max_slides, proof : optional
        As in :func:`simulate_many`.
    chunks, threads, progress, derivatives : optional
        As in :func:`simulate_many`.
    theta, theta_rate, slip, gap_rate : array_like, optional
        Axes of the start, of shape (n,), in the given order, or numbers. `theta` and `theta_rate`
        are required.
    mass_ratio, offset, inertia, slope, restitution : array_like, optional
        Axes of the hoop, likewise.
    mu_s, mu_k, mu, rolling_resistance : array_like, optional
        Axes of its friction, likewise; `mu` is both coefficients of friction.

    Returns
    -------
    xarray.Dataset
        The variables of :func:`simulate_many`, over dimensions named by the axes: as in a Zarr
        store of `littlewood map` or `littlewood sweep`.

    Raises
    ------
    ParameterError
        As :func:`simulate_many`.

    Examples
    --------
    >>> import numpy as np, littlewood as lw
    >>> hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    >>> theta, rate = np.linspace(-3, 3, 7), np.linspace(-4, 4, 9)
    >>> plane = lw.outcome_map(hoop, theta=theta, theta_rate=rate, until=50)
    >>> dict(plane.sizes)
    {'theta': 7, 'theta_rate': 9}
    """
    values = fill(hoop, quantities)
    law = _law(hoop, restitution_law, values)
    points = grid(values, law, [name for name, value in quantities.items() if value is not None])
    return _simulate(
        points, until, max_transitions, max_slides, proof, chunks, threads, progress, derivatives
    )


def sequence_names(sequence: npt.ArrayLike) -> npt.NDArray[np.str_]:
    """Return sequences of phases with one letter a phase.

    Parameters
    ----------
    sequence : array_like of uint64
        The variable `sequence` of a result.

    Returns
    -------
    ndarray of str
        Of the same shape: R rolling; + and - sliding; g, n and G gliding; F flight; 0 rest; S and s
        skidding; … where there are more than 15.
    """
    names = _core.sequence_names(flat(sequence, np.uint64))
    return np.array(names, dtype=np.str_).reshape(np.shape(sequence))


def _law(hoop: Hoop | None, law: str | None, values: Mapping[str, Any]) -> str | None:
    """Return the law of restitution of a sweep; refuse hoops without physical meaning."""
    return check_hoop(values, hoop.restitution_law if law is None and hoop is not None else law)


def _simulate(
    points: Points,
    until: float | None,
    max_transitions: int,
    max_slides: int,
    proof: str,
    chunks: Any,
    threads: int | None,
    progress: bool,
    derivatives: Iterable[str],
) -> xarray.Dataset:
    names = checked_derivatives(derivatives, "restitution" in points.variables)
    limits = Limits.checked(until, max_transitions, max_slides, proof)
    if threads is not None:
        checked_count("threads", threads, 1, _core.MOST_THREADS, "leave it out for all cores")
    if chunks is not None:
        points = points.chunked(chunks)
    elif not points.is_lazy and points.count > _core.MOST_POINTS:
        raise ValueError(
            f"{points.count} points at once: there can be {_core.MOST_POINTS}; chunks= computes "
            f"more"
        )
    data: Mapping[str, Any]
    if points.is_lazy:
        if progress:
            raise ValueError(
                "progress=True is for results that are computed at once; use the bars of Dask"
            )
        data = lazy_columns(points, limits, names)
    else:
        arrays = {name: variable.data for name, variable in points.variables.items()}
        with progress_bar(points.count, "starts", progress) as show:
            data = compute(
                arrays,
                points.axes,
                points.law,
                limits,
                points.starts,
                threads or 0,
                show if progress else None,
                names,
            )
    dimensions = tuple(points.sizes)
    dataset: xarray.Dataset = require("xarray").Dataset(
        {name: (dimensions, data[name], result_attributes(name)) for name in (*RESULTS, *names)},
        coords=points.coordinates,
        attrs={
            "Conventions": CONVENTIONS,
            "title": "sweep of Littlewood's hoop",
            "source": f"littlewood {_core.__version__}",
            "max_transitions": limits.max_transitions,
            "max_slides": limits.max_slides,
            "proof": limits.proof,
            **({} if points.law is None else {"restitution_law": points.law}),
            **({} if limits.until is None else {"until": limits.until}),
        },
    )
    return dataset
