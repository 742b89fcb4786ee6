import dataclasses
import math
import os
import signal
import subprocess
import sys
import threading

import numpy as np
import pytest
import xarray

import littlewood as lw


def test_the_counts_of_other_solvers(hoop):
    # 40,000 starts of the Figure 2 hoop, counted with independent solvers.
    plane = lw.outcome_map(
        hoop,
        theta=np.linspace(-math.pi, math.pi, 200),
        theta_rate=np.linspace(-4, 4, 200),
        until=50.0,
    )
    at_once = int((plane.lift_off_time == 0.0).sum())
    later = int((plane.lift_off_time > 0.0).sum())
    assert (at_once, later, plane.outcome.size - at_once - later) == (9784, 12690, 17526)


def digits(motion):
    """To how many digits a sweep agrees with the simulation: docs/engine.md."""
    bound = 1e-12 * (1 + len(motion.transitions))
    return {"rel": bound, "abs": bound}


def test_a_few_starts_are_those_of_simulate(hoop):
    theta = np.linspace(-3.0, 3.0, 7)
    result = lw.simulate_many(hoop, theta=theta, theta_rate=2.0, until=30.0)
    for i, angle in enumerate(theta):
        motion = hoop.simulate(theta=angle, theta_rate=2.0, until=30.0)
        assert lw.tables.OUTCOMES[int(result.outcome[i])] == motion.outcome.kind
        assert str(lw.sequence_names(result.sequence)[i]) == motion.sequence
        assert float(result.end_time[i]) == pytest.approx(
            motion.outcome.state.time, **digits(motion)
        )
        assert result.transitions[i] == len(motion.transitions)


def test_rolling_resistance_is_an_axis(hoop):
    axes = {"rolling_resistance": np.array([0.0, 0.05, 0.2]), "theta": np.array([2.0, 2.5, 3.1])}
    plane = lw.outcome_map(hoop, **axes, theta_rate=0.0)
    assert dict(plane.sizes) == {"rolling_resistance": 3, "theta": 3}
    for i, chi in enumerate(axes["rolling_resistance"]):
        body = dataclasses.replace(hoop, rolling_resistance=chi)
        for j, angle in enumerate(axes["theta"]):
            motion = body.simulate(theta=angle, theta_rate=0)
            point = plane.isel(rolling_resistance=i, theta=j)
            assert lw.tables.OUTCOMES[int(point.outcome)] == motion.outcome.kind
            assert str(lw.sequence_names(point.sequence)) == motion.sequence
            swings = motion.outcome.details.get("half_swings", 0)
            assert int(point.half_swings) == swings
    # sin θ of the band of rest: the couple χN, N = 1 + m, holds the weight of the particle.
    assert plane.half_swings.sel(theta=3.1).values.tolist()[1:] == [0, 0]
    assert abs(math.sin(3.1)) < 0.05 * 2


def impacts_of(motion):
    """Number of landings, energy lost in impacts, and a time.

    From that time on the rim stays at the plane.
    """
    events = [one for one in motion.transitions if one.impact is not None]
    stays = [one.time for one in events if one.from_mode == "flight" and one.to_mode != "flight"]
    away = any(
        phase.mode == "flight" for phase in motion.phases if stays and phase.start_time >= stays[-1]
    )
    settle = math.nan if away or not stays else stays[-1]
    landings = sum(one.cause == "landing" for one in motion.transitions)
    return landings, sum(one.impact.energy_lost for one in events), settle


@pytest.mark.parametrize("law", lw.tables.RESTITUTION_LAWS)
def test_what_follows_a_landing_is_that_of_simulate(law, hoop):
    e = np.array([0.0, 0.25, 0.5, 0.8, 1.0])
    theta = np.linspace(-3.0, 3.0, 7)
    result = lw.outcome_map(
        hoop, restitution=e, theta=theta, theta_rate=2.5, restitution_law=law, until=12.0
    )
    assert dict(result.sizes) == {"restitution": 5, "theta": 7}
    assert result.attrs["restitution_law"] == law
    assert result.restitution.attrs["long_name"] == "coefficient of restitution"
    assert result.landings.dtype == np.uint32
    for i, j in np.ndindex(5, 7):
        point = result.isel(restitution=i, theta=j)
        bounces = dataclasses.replace(hoop, restitution=e[i], restitution_law=law)
        motion = bounces.simulate(theta=theta[j], theta_rate=2.5, until=12.0)
        landings, lost, settle = impacts_of(motion)
        assert lw.tables.OUTCOMES[int(point.outcome)] == motion.outcome.kind
        assert point.landings == landings
        assert float(point.end_theta) == pytest.approx(motion.outcome.state.theta, **digits(motion))
        assert float(point.impact_energy_lost) == pytest.approx(lost, **digits(motion))
        assert float(point.settle_time) == pytest.approx(settle, **digits(motion), nan_ok=True)
    assert result.landings.max() > 3
    assert result.settle_time.notnull().any()


def test_tables_change_only_the_last_digits_of_what_follows_a_landing(hoop):
    soft = dataclasses.replace(hoop, restitution=0.0)
    theta = np.linspace(-3.0, 3.0, 100)
    tabulated = lw.simulate_many(soft, theta=theta, theta_rate=2.5, until=20.0)
    # Each with a hoop of its own there are none.
    exact = lw.simulate_many(soft, theta=theta, theta_rate=2.5, until=20.0, mu_s=np.full(100, 0.5))
    parts = [
        lw.simulate_many(soft, theta=part, theta_rate=2.5, until=20.0)
        for part in np.split(theta, 5)
    ]
    for name in ("outcome", "sequence", "landings"):
        np.testing.assert_array_equal(
            tabulated[name], np.concatenate([part[name] for part in parts])
        )
        np.testing.assert_array_equal(exact[name], tabulated[name])
    for name in ("end_theta", "impact_energy_lost", "settle_time"):
        np.testing.assert_allclose(
            tabulated[name], np.concatenate([part[name] for part in parts]), rtol=1e-10
        )


def test_a_rate_of_the_gap_is_an_axis(hoop):
    result = lw.outcome_map(hoop, gap_rate=[0.0, 0.5, 1.0], theta=0.5, theta_rate=0.0)
    assert dict(result.sizes) == {"gap_rate": 3}
    assert result.gap_rate.attrs["scale"] == "sqrt(g R)"
    # At rest a thrown hoop comes down after 2v.
    assert result.end_time.values[1:] == pytest.approx([1.0, 2.0], abs=1e-14)
    assert lw.tables.OUTCOMES[int(result.outcome[0])] != "landing"


def test_without_a_coefficient_there_is_none(hoop):
    result = lw.simulate_many(hoop, theta=[1.5, 2.0], theta_rate=2.0, until=10.0)
    assert "restitution" not in result.coords
    assert "restitution_law" not in result.attrs
    assert result.landings.values.tolist() == [1, 1]
    assert result.impact_energy_lost.values.tolist() == [0.0, 0.0]
    with_one = lw.simulate_many(hoop, restitution=0.5, theta=[1.5, 2.0], theta_rate=2.0, until=10.0)
    assert with_one.restitution.values == 0.5
    assert with_one.attrs["restitution_law"] == "energetic"
    # NaN is no way to say that there is none.
    with pytest.raises(
        lw.ParameterError, match="restitution = NaN must be a finite number"
    ) as caught:
        lw.simulate_many(hoop, restitution=[0.5, math.nan], theta=1.5, theta_rate=2.0)
    assert caught.value.index == 1
    with pytest.raises(lw.ParameterError, match=r"restitution = 1.5 must not exceed 1") as caught:
        lw.outcome_map(hoop, restitution=[0.5, 1.0, 1.5], theta=1.5, theta_rate=2.0)
    assert caught.value.index == 2
    with pytest.raises(lw.ParameterError, match="without a coefficient the motion ends"):
        lw.simulate_many(hoop, restitution_law="newton", theta=[1.5], theta_rate=2.0)


def test_a_massless_hoop_has_no_impact(hoop):
    massless = lw.case("figure-7").hoop
    with pytest.raises(lw.ParameterError, match=r"restitution = 0.25 of a massless hoop"):
        lw.simulate_many(massless, restitution=[0.25, 0.5], theta=0.0, theta_rate=0.5)
    with pytest.raises(lw.ParameterError, match=r"restitution = 0.5 of a massless hoop"):
        lw.simulate_many(massless, restitution=0.5, theta=[0.0, 1.0], theta_rate=0.5)
    # Where both vary, the hoops that contradict themselves are marked.
    mixed = lw.outcome_map(
        massless, restitution=[0.0, 0.5], inertia=[0.0, 1.0], theta=0.0, theta_rate=0.5, until=5.0
    )
    assert (mixed.outcome == 255).values.tolist() == [[True, False], [True, False]]
    # Nor is it thrown.
    with pytest.raises(lw.ParameterError, match=r"gap_rate = 0.5 of a massless hoop"):
        lw.outcome_map(massless, gap_rate=[0.0, 0.5], theta=0.0, theta_rate=0.5)
    thrown = lw.outcome_map(
        massless, gap_rate=[0.0, 0.5], inertia=[0.0, 1.0], theta=0.0, theta_rate=0.5
    )
    assert (thrown.outcome == 255).values.tolist() == [[False, False], [True, False]]


def test_arrays_may_start_anywhere_in_memory(hoop):
    theta = np.linspace(-3.0, 3.0, 200)
    # As in a file with a header of three bytes, or in a message of another process.
    shifted = np.frombuffer(b"abc" + theta.tobytes(), dtype=np.float64, offset=3)
    assert not shifted.flags.aligned
    ours = lw.simulate_many(hoop, theta=shifted, theta_rate=2.0, until=30.0)
    expected = lw.simulate_many(hoop, theta=theta, theta_rate=2.0, until=30.0)
    assert ours.identical(expected)
    np.testing.assert_array_equal(
        lw.closed_form.alpha(shifted, 0.5), lw.closed_form.alpha(theta, 0.5)
    )
    np.testing.assert_array_equal(
        hoop.phase_plane.region(shifted, 0.5), hoop.phase_plane.region(theta, 0.5)
    )
    motion = hoop.simulate(theta=1.0, theta_rate=0.0)
    np.testing.assert_array_equal(motion(shifted).x, motion(theta).x)
    bits = expected.sequence.to_numpy()
    moved = np.frombuffer(b"a" + bits.tobytes(), dtype=np.uint64, offset=1)
    np.testing.assert_array_equal(lw.sequence_names(moved), lw.sequence_names(bits))
    np.testing.assert_array_equal(
        lw.plot.classes(expected.assign(sequence=("start", moved))), lw.plot.classes(expected)
    )


def test_dimensions_of_arrays(hoop):
    assert lw.simulate_many(hoop, theta=0.0, theta_rate=1.0).sizes == {}
    assert dict(lw.simulate_many(hoop, theta=[0.0, 1.0], theta_rate=1.0).sizes) == {"start": 2}
    grid = lw.simulate_many(
        hoop, theta=np.zeros((2, 1)), theta_rate=np.ones((1, 3)), mu_s=np.full(3, 0.6)
    )
    assert dict(grid.sizes) == {"dim_0": 2, "dim_1": 3}
    assert grid.theta.dims == ("dim_0",)
    assert grid.mu_s.dims == ("dim_1",)
    assert grid.mu_k.ndim == 0
    with pytest.raises(ValueError, match="broadcast"):
        lw.simulate_many(hoop, theta=np.zeros(2), theta_rate=np.zeros(3))


def test_dimensions_of_data_arrays(hoop):
    theta = xarray.DataArray([0.1, 0.2], dims="throw", coords={"throw": ["soft", "hard"]})
    mu_k = xarray.DataArray([0.1, 0.2, 0.3], dims="floor")
    result = lw.simulate_many(hoop, theta=theta, theta_rate=1.5, mu_k=mu_k)
    assert result.outcome.dims == ("floor", "throw") or result.outcome.dims == ("throw", "floor")
    assert result.throw.values.tolist() == ["soft", "hard"]
    alone = lw.simulate_many(hoop, theta=0.2, theta_rate=1.5, mu_k=0.3)
    assert result.end_time.sel(throw="hard").isel(floor=2) == alone.end_time
    # A quantity is what was given, not a coordinate of the same name that an array happens to
    # carry.
    stale = lw.simulate_many(hoop, theta=theta.assign_coords(theta_rate=9.0), theta_rate=1.5)
    assert stale.theta_rate == 1.5
    with pytest.raises(TypeError, match="DataArray"):
        lw.simulate_many(hoop, theta=theta, theta_rate=np.zeros(2))


def test_axes_keep_their_order(hoop):
    assert list(lw.outcome_map(hoop, theta_rate=[1.0, 2.0], theta=[0.0, 1.0, 2.0]).sizes) == [
        "theta_rate",
        "theta",
    ]
    plane = lw.outcome_map(hoop, mu_s=[0.5, 0.6], theta=0.3, theta_rate=[1.0, 2.0])
    assert list(plane.sizes) == ["mu_s", "theta_rate"]
    assert plane.sel(mu_s=0.6, theta_rate=2.0).theta == 0.3


def test_variables_describe_themselves(hoop):
    result = lw.outcome_map(hoop, theta=[0.0, 1.0], theta_rate=[1.0, 2.0])
    for name, variable in result.variables.items():
        assert variable.attrs["long_name"], name
        assert (
            "units" in variable.attrs or "flag_meanings" in variable.attrs or name == "sequence"
        ), name
    flags = result.outcome.attrs
    meanings = dict(zip(flags["flag_values"], flags["flag_meanings"].split(), strict=True))
    assert meanings[0] == "landing"
    assert meanings[255] == "invalid"


@pytest.mark.parametrize("threads", [1, 2, 5])
def test_threads_change_nothing(threads, hoop):
    starts = {"theta": np.linspace(-3, 3, 60), "theta_rate": np.linspace(-4, 4, 50)}
    one = lw.outcome_map(hoop, **starts, threads=threads)
    assert one.identical(lw.outcome_map(hoop, **starts))


def test_contradictions_are_invalid_and_nonsense_is_refused(hoop):
    result = lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, mu_s=[0.5, 0.5], mu_k=[0.4, 0.6])
    assert result.outcome.values.tolist()[1] == 255
    assert math.isnan(result.end_time[1])
    # One that varies must not contradict one that does not.
    with pytest.raises(lw.ParameterError, match=r"mu_k = 0.6 must not exceed mu_s = 0.5"):
        lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, mu_k=[0.4, 0.6])
    with pytest.raises(lw.ParameterError, match="point mass at the centre"):
        lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, offset=0.0, inertia=[1.0, 0.0])
    with pytest.raises(lw.ParameterError, match=r"mu_k = 0.6 must not exceed mu_s = 0.5"):
        lw.simulate_many(hoop, theta=[0.0, 1.0], theta_rate=1.0, mu_k=0.6)
    with pytest.raises(
        lw.ParameterError, match="theta = NaN rad must be a finite number"
    ) as caught:
        lw.simulate_many(hoop, theta=[0.0, 1.0, math.nan, math.inf], theta_rate=1.0)
    assert caught.value.index == 2
    with pytest.raises(lw.ParameterError, match="offset = 2 must not exceed 1") as caught:
        lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, offset=[0.5, 2.0, 3.0])
    assert caught.value.index == 1
    with pytest.raises(lw.ParameterError, match="until = inf"):
        lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, until=math.inf)


def test_what_is_missing_is_named(hoop):
    with pytest.raises(TypeError, match=r"missing: theta_rate$"):
        lw.simulate_many(hoop, theta=0.0)
    with pytest.raises(TypeError, match="missing: mass_ratio, offset, inertia, mu_s; give a hoop"):
        lw.simulate_many(theta=0.0, theta_rate=1.0, mu_k=0.3)
    with pytest.raises(TypeError, match="there is no quantity friction"):
        lw.simulate_many(hoop, theta=0.0, theta_rate=1.0, friction=0.3)
    with pytest.raises(ValueError, match="theta is empty"):
        lw.outcome_map(hoop, theta=[], theta_rate=[1.0])
    with pytest.raises(ValueError, match="an axis has one"):
        lw.outcome_map(hoop, theta=np.zeros((2, 2)), theta_rate=[1.0])
    with pytest.raises(ValueError, match="threads = 0"):
        lw.outcome_map(hoop, theta=[0.0], theta_rate=[1.0], threads=0)
    # Far fewer than a system starts without an error, and than take seconds to start.
    for threads in (1025, 10**9, 10**30):
        with pytest.raises(ValueError, match=f"threads = {threads} must not exceed 1024"):
            lw.outcome_map(hoop, theta=[0.0], theta_rate=[1.0], threads=threads)
    with pytest.raises((TypeError, ValueError), match="theta must hold real numbers"):
        lw.simulate_many(hoop, theta=["up"], theta_rate=1.0)


def test_a_progress_bar(hoop, capsys):
    lw.outcome_map(
        hoop, theta=np.linspace(0, 1, 100), theta_rate=np.linspace(0, 1, 100), progress=True
    )
    assert "10.0k/10.0k" in capsys.readouterr().err


def test_the_interpreter_is_free_meanwhile(hoop):
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.wait(0.001):
            ticks.append(None)

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        # Every start has a hoop of its own: no tables, and so some tenths of a second of work.
        count = 20_000
        lw.simulate_many(
            hoop, theta=2.5, theta_rate=3.0, mu_s=np.linspace(0.5, 0.9, count), threads=1
        )
    finally:
        stop.set()
        thread.join()
    assert len(ticks) > 20


# A shell that starts tests in the background has them ignore the signal, and what they start.
SLEEPER = """
import signal, sys, numpy as np, littlewood as lw
signal.signal(signal.SIGINT, signal.default_int_handler)
hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
mu_s = np.linspace(0.5, 0.9, 30_000_000)
sys.stdout.write("ready"); sys.stdout.flush()
lw.simulate_many(hoop, theta=-2.6, theta_rate=-2.15, mu_s=mu_s)
"""


@pytest.mark.skipif(os.name == "nt", reason="there is no SIGINT for one process")
def test_ctrl_c_stops_the_work():
    process = subprocess.Popen(
        [sys.executable, "-c", SLEEPER], stdout=subprocess.PIPE, stderr=subprocess.PIPE
    )
    assert process.stdout is not None
    assert process.stdout.read(5) == b"ready"
    # It is at work now, for minutes if nobody stops it.
    with pytest.raises(subprocess.TimeoutExpired):
        process.communicate(timeout=1.0)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=20.0)
    assert process.returncode != 0
    assert b"KeyboardInterrupt" in said
