"""Scaling of an outcome map over workers of Dask, side by side with the threads of one process.

Every worker is a process with one thread. Each line is the median of some runs of the same map, written to Zarr by the
workers. Run it on an idle machine:

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


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--starts", type=int, default=4_000_000, help="number of starts")
    parser.add_argument("--workers", type=int, nargs="+", default=[1, 2], help="numbers of workers")
    parser.add_argument("--runs", type=int, default=3, help="runs of each")
    arguments = parser.parse_args()
    side = round(arguments.starts**0.5)
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    axes = {"theta": np.linspace(-np.pi, np.pi, side), "theta_rate": np.linspace(-4, 4, side)}

    def show(name: str, seconds: list[float], base: float | None = None) -> float:
        median = statistics.median(seconds)
        ratio = "" if base is None else f"   {base / median:.2f} times 1 worker"
        print(f"{name:<28}{median:8.2f} s   {side * side / median / 1e6:6.2f} million starts/s{ratio}", flush=True)
        return median

    seconds = []
    for _ in range(arguments.runs):
        began = time.perf_counter()
        lw.outcome_map(hoop, **axes)
        seconds.append(time.perf_counter() - began)
    show("one process, all cores", seconds)

    base = None
    for count in arguments.workers:
        with (
            LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=None) as cluster,
            Client(cluster) as client,
        ):
            client.run(lambda: lw.__version__)
            # Imports and the first connections are not what is measured.
            lw.outcome_map(hoop, theta=axes["theta"][:64], theta_rate=axes["theta_rate"][:64], chunks=16).compute()
            seconds = []
            for _ in range(arguments.runs):
                with tempfile.TemporaryDirectory() as folder:
                    began = time.perf_counter()
                    lazy = lw.outcome_map(hoop, **axes, chunks=500)
                    lazy.to_zarr(Path(folder) / "map.zarr", consolidated=False)
                    seconds.append(time.perf_counter() - began)
            median = show(f"Dask, {count} worker{'s' if count > 1 else ''}, to Zarr", seconds, base)
            base = median if base is None else base


if __name__ == "__main__":
    main()
