import dataclasses
import os
import signal
import time

import dask
import numpy as np
import pytest
import xarray
from distributed import Client, LocalCluster, wait

import littlewood as lw

THETA = np.linspace(-np.pi, np.pi, 240)
THETA_RATE = np.linspace(-4.0, 4.0, 200)


def bits(dataset):
    return {name: variable.to_numpy().tobytes() for name, variable in dataset.data_vars.items()}


@pytest.fixture(scope="module")
def client():
    """Two workers, each a process of its own."""
    with (
        dask.config.set({"distributed.scheduler.allowed-failures": 5}),
        LocalCluster(
            n_workers=2, threads_per_worker=1, processes=True, dashboard_address="127.0.0.1:0"
        ) as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture
def local(hoop):
    return lw.outcome_map(hoop, theta=THETA, theta_rate=THETA_RATE, until=50.0)


def test_blocks_are_lazy(hoop):
    lazy = lw.outcome_map(
        hoop, theta=THETA, theta_rate=THETA_RATE, chunks={"theta": 100, "theta_rate": 50}
    )
    assert dict(lazy.chunksizes) == {"theta": (100, 100, 40), "theta_rate": (50,) * 4}
    for variable in lazy.data_vars.values():
        assert dask.is_dask_collection(variable.data)
    # The graph holds no results: its size does not grow with the number of points in a block.
    assert lazy.theta.dims == ("theta",)


def test_a_block_is_computed_once(hoop, monkeypatch):
    from littlewood.sweep import lazy as module

    calls = []
    compute = module.compute

    def counting(*arguments, **keywords):
        calls.append(1)
        return compute(*arguments, **keywords)

    monkeypatch.setattr(module, "compute", counting)
    lazy = lw.outcome_map(hoop, theta=THETA, theta_rate=THETA_RATE, chunks=120)
    with dask.config.set(scheduler="synchronous"):
        dask.compute(lazy)
    assert len(calls) == 4


@pytest.mark.thorough
def test_workers_get_the_bits_of_one_machine(hoop, local, client):
    pids = client.run(os.getpid)
    assert len(set(pids.values()) | {os.getpid()}) == 3
    lazy = lw.outcome_map(
        hoop, theta=THETA, theta_rate=THETA_RATE, until=50.0, chunks={"theta": 37, "theta_rate": 64}
    )
    assert bits(lazy.compute()) == bits(local)


def test_coordinates_of_dask(hoop, client):
    theta = xarray.DataArray(np.linspace(-3, 3, 50), dims="start").chunk(start=7)
    rate = xarray.DataArray(np.linspace(1, 3, 50), dims="start").chunk(start=9)
    mu_k = xarray.DataArray([0.2, 0.3, 0.4], dims="floor")
    lazy = lw.simulate_many(hoop, theta=theta, theta_rate=rate, mu_k=mu_k, until=30.0)
    assert dask.is_dask_collection(lazy.outcome.data)
    assert dask.is_dask_collection(lazy.theta.data)
    eager = lw.simulate_many(
        hoop, theta=theta.compute(), theta_rate=rate.compute(), mu_k=mu_k, until=30.0
    )
    assert bits(lazy.compute()) == bits(eager)
    # Arrays of Dask by themselves, too.
    plain = lw.simulate_many(hoop, theta=theta.data, theta_rate=rate.data, until=30.0)
    assert plain.outcome.dims == ("start",)
    assert bits(plain.compute()) == bits(eager.isel(floor=2))


def test_bounces_have_the_bits_of_one_machine(hoop, client):
    axes = {
        "restitution": np.linspace(0.0, 0.9, 10),
        "theta": np.linspace(-3, 3, 40),
        "theta_rate": np.array([1.5, 2.5]),
    }
    eager = lw.outcome_map(hoop, **axes, restitution_law="poisson", until=20.0)
    lazy = lw.outcome_map(
        hoop, **axes, restitution_law="poisson", until=20.0, chunks={"restitution": 3, "theta": 17}
    )
    assert bits(lazy.compute()) == bits(eager)
    assert lazy.attrs["restitution_law"] == "poisson"
    # Another law is another result.
    assert bits(lw.outcome_map(hoop, **axes, restitution_law="newton", until=20.0)) != bits(eager)
    thrown = {"theta": axes["theta"], "theta_rate": 1.0, "gap_rate": np.linspace(0.0, 1.0, 5)}
    bouncy = dataclasses.replace(hoop, restitution=0.5)
    eager = lw.outcome_map(bouncy, **thrown, until=20.0)
    assert bits(lw.outcome_map(bouncy, **thrown, until=20.0, chunks=9).compute()) == bits(eager)


def test_few_starts_a_block_change_no_bit(hoop, client):
    # Blocks of less than a tables' worth of starts: the choice of tables is that of the whole.
    theta = np.linspace(-3, 3, 40)
    eager = lw.outcome_map(hoop, theta=theta, theta_rate=[1.4, 2.0], until=30.0)
    lazy = lw.outcome_map(hoop, theta=theta, theta_rate=[1.4, 2.0], until=30.0, chunks=3)
    assert bits(lazy.compute()) == bits(eager)


@pytest.mark.thorough
def test_a_worker_that_is_killed_costs_nothing(hoop, local, client, tmp_path):
    path = tmp_path / "map.zarr"
    chunks = {"theta": 24, "theta_rate": 40}
    lazy = lw.outcome_map(hoop, theta=THETA, theta_rate=THETA_RATE, until=50.0, chunks=chunks)
    future = client.compute(lazy.to_zarr(path, compute=False, consolidated=False))
    victim = next(iter(client.run(os.getpid).values()))
    # In the middle: some chunks are on disk, others are not.
    total = (240 // 24) * (200 // 40)
    while not (done := len(list((path / "outcome" / "c").glob("*/*")))):
        time.sleep(0.005)
    os.kill(victim, signal.SIGKILL)
    assert done < total
    wait(future, timeout=300)
    assert future.status == "finished"
    stored = xarray.open_zarr(path, consolidated=False, mask_and_scale=False).load()
    assert bits(stored) == bits(local)
    assert stored.outcome.attrs["flag_meanings"].split()[0] == "landing"
    assert stored.theta.attrs["units"] == "rad"
    client.wait_for_workers(2, timeout=300)
    assert victim not in client.run(os.getpid).values()


def test_a_refusal_comes_back_from_a_worker(hoop, client):
    theta = np.linspace(0, 1, 10)
    theta[7] = np.nan
    lazy = lw.simulate_many(hoop, theta=theta, theta_rate=1.0, chunks=4)
    with pytest.raises(lw.ParameterError, match="theta = NaN rad"):
        lazy.compute()
    with pytest.raises(ValueError, match="progress"):
        lw.simulate_many(hoop, theta=theta, theta_rate=1.0, chunks=4, progress=True)
