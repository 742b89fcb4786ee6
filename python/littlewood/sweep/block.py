"""Points in arrays, and their results: at once, or as one block of many."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
import numpy.typing as npt

from .. import _core
from .._internal.counts import checked_limits
from .._internal.elementwise import flat, real
from ..tables import AXES


class Limits(NamedTuple):
    """When to stop a motion: at `until`, √(R/g), if any; after `max_transitions` or `max_slides`.

    By what `proof`.
    """

    until: float | None
    max_transitions: int
    max_slides: int
    proof: str

    @classmethod
    def checked(
        cls, until: float | None, max_transitions: int, max_slides: int, proof: str
    ) -> Limits:
        """Refuse limits without meaning, before anything is computed."""
        transitions, slides = checked_limits(max_transitions, max_slides)
        limits = cls(None if until is None else real(until, "until"), transitions, slides, proof)
        if limits.until is not None:
            _core.check_until(limits.until)
        _core.check_proof(proof)
        return limits


def compute(
    arrays: Mapping[str, npt.NDArray[np.float64]],
    axes: Mapping[str, tuple[int, ...]],
    law: str | None,
    limits: Limits,
    starts: int,
    threads: int,
    progress: Callable[[int], object] | None = None,
    derivatives: Sequence[str] = (),
) -> dict[str, npt.NDArray[Any]]:
    """Simulate the points of some arrays, each over its own `axes` of the result.

    The result may be a part of one in which each hoop has so many `starts`; 0 `threads` are all
    cores; `progress` is called with the number of points done.
    """
    sizes = {
        axis: n
        for name, array in arrays.items()
        for axis, n in zip(axes[name], array.shape, strict=True)
    }
    shape = tuple(sizes[axis] for axis in sorted(sizes))

    def column(name: str) -> npt.NDArray[np.float64]:
        array = arrays[name]
        if array.ndim == 0:
            # One value for all points is not repeated.
            return flat(array)
        order = sorted(range(array.ndim), key=axes[name].__getitem__)
        own = dict(zip(sorted(axes[name]), array.transpose(order).shape, strict=True))
        spread = array.transpose(order).reshape([own.get(axis, 1) for axis in range(len(shape))])
        return flat(np.broadcast_to(spread, shape))

    columns = _core.summaries(
        [column(name) if name in arrays else None for name in AXES],
        law,
        int(np.prod(shape, dtype=np.int64)),
        limits.until,
        limits.max_transitions,
        limits.max_slides,
        limits.proof,
        starts,
        threads,
        progress,
        derivatives,
    )
    return {name: values.reshape(shape) for name, values in columns.items()}
