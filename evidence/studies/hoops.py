"""Hoops of the studies: thin ones with the particle on the rim, and random ones.

The random ones are for claims about every hoop.
"""

from __future__ import annotations

import math
from collections.abc import Iterator

import littlewood as lw
import numpy as np

DEGREE = math.pi / 180.0


def thin_hoop(
    h: float, *, mu_k: float, mu_s: float | None = None, restitution: float | None = None
) -> lw.Hoop:
    """Return the thin hoop with a particle on its rim whose mass centre is at the distance h.

    μs = μk if not given.
    """
    ratio = 1.0 / h - 1.0
    return lw.Hoop(
        mass_ratio=ratio,
        offset=1.0,
        inertia=ratio,
        mu_s=mu_k if mu_s is None else mu_s,
        mu_k=mu_k,
        restitution=restitution,
    )


def random_hoops(seed: int, count: int) -> Iterator[tuple[lw.Hoop, np.random.Generator]]:
    """Yield hoops with the generator that made them.

    m1/m2 and I_zz from 1e-3 to 1e3 by their logarithms, ℓ/R from 0.02 to 1, μk from 1e-3 to 2, and
    μs as large or up to twice as large.
    """
    random = np.random.default_rng(seed)
    for _ in range(count):
        mass_ratio = 10.0 ** random.uniform(-3.0, 3.0)
        mu_k = 10.0 ** random.uniform(-3.0, np.log10(2.0))
        yield (
            lw.Hoop(
                mass_ratio=mass_ratio,
                offset=random.uniform(0.02, 1.0),
                # A disc or hoop has its mass within the radius: I_zz ≤ m1 R².
                inertia=mass_ratio * 10.0 ** random.uniform(-3.0, 0.0),
                mu_s=mu_k * random.choice([1.0, random.uniform(1.0, 2.0)]),
                mu_k=mu_k,
            ),
            random,
        )
