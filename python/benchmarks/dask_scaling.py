"""Scaling of an outcome map over workers of Dask, side by side with the threads of one process.

Every worker is a process with one thread, and the workers write to Zarr. Runs alternate, so that
whatever else the machine does disturbs all of them alike; shown are medians, and the median of the
ratios within a round. On an idle machine:

    python benchmarks/dask_scaling.py --starts 4000000 --workers 1 2
"""

import argparse
import statistics
import tempfile
import time
from pathlib import Path

import numpy as np
from distributed import Client, LocalCluster

import littlewood as lw

HOOP = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)


def local(axes: dict[str, np.ndarray]) -> float:
    began = time.perf_counter()
    lw.outcome_map(HOOP, **axes)
    return time.perf_counter() - began


def on_workers(count: int, axes: dict[str, np.ndarray]) -> float:
    with (
        LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=None) as cluster,
        Client(cluster),
        tempfile.TemporaryDirectory() as folder,
    ):
        # Imports and the first connections are not what is measured.
        few = {name: axis[:64] for name, axis in axes.items()}
        lw.outcome_map(HOOP, **few, chunks=16).to_zarr(
            Path(folder) / "few.zarr", consolidated=False
        )
        began = time.perf_counter()
        lw.outcome_map(HOOP, **axes, chunks=500).to_zarr(
            Path(folder) / "map.zarr", consolidated=False
        )
        return time.perf_counter() - began


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--starts", type=int, default=4_000_000, help="number of starts")
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2], help="numbers of workers")
    parser.add_argument("--rounds", type=int, default=5, help="runs of each")
    arguments = parser.parse_args()
    side = round(arguments.starts**0.5)
    axes = {"theta": np.linspace(-np.pi, np.pi, side), "theta_rate": np.linspace(-4, 4, side)}

    rounds = [
        {0: local(axes)} | {count: on_workers(count, axes) for count in arguments.workers}
        for _ in range(arguments.rounds)
    ]
    base = arguments.workers[0]
    for count in (0, *arguments.workers):
        seconds = statistics.median(one[count] for one in rounds)
        ratio = statistics.median(one[base] / one[count] for one in rounds)
        name = (
            f"Dask to Zarr, {count} worker{'s' if count > 1 else ''}"
            if count
            else "one process, all cores"
        )
        print(
            f"{name:<26}{seconds:8.2f} s{side * side / seconds / 1e6:8.2f} million starts/s"
            f"{ratio:8.2f} times {base} worker{'s' if base > 1 else ''}"
        )


if __name__ == "__main__":
    main()
