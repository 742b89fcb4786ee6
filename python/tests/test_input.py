"""What Python is given: kinds of arrays, chunks, hoops; and what is pickled."""

import math
import pickle
from decimal import Decimal
from fractions import Fraction

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray
from conftest import flags

import littlewood as lw
from littlewood.tables import SI_START, START


def pickled(motion):
    """One object of each public kind."""
    elastic = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=1)
    return {
        "hoop": motion.hoop,
        "start": motion.start,
        "phase": motion.phases[0],
        "transition": motion.transitions[0],
        "outcome": motion.outcome,
        "classification": motion.hoop.classify(theta=1.0, theta_rate=1.0),
        "orbit": elastic.bouncing_orbit(1.0),
        "equilibria": motion.hoop.phase_plane.equilibria,
        "case": lw.case("figure-3"),
        "cases": lw.CASES,
        "quantities": lw.tables.QUANTITIES,
        "camera": lw.video.Camera((0.0, 0.0, 3.0), (0.0, 0.0, 0.0), 400.0),
        "noise": lw.Noise(1.0),
    }


@pytest.fixture
def motion(hoop):
    return hoop.simulate(theta=math.pi / 2, theta_rate=2.0)


def test_public_objects_are_pickled(motion):
    for name, value in pickled(motion).items():
        assert pickle.loads(pickle.dumps(value)) == value, name
    again = pickle.loads(pickle.dumps(motion))
    assert again.transitions == motion.transitions
    for samples in (motion(0.5), motion.sample(5)):
        found = pickle.loads(pickle.dumps(samples))
        assert {name: np.asarray(found[name]).tolist() for name in found} == {
            name: np.asarray(samples[name]).tolist() for name in samples
        }
    plane = pickle.loads(pickle.dumps(motion.hoop.phase_plane))
    assert plane.in_rolling_region(0.5, 0.2) == motion.hoop.phase_plane.in_rolling_region(0.5, 0.2)
    track = pickle.loads(pickle.dumps(lw.Track([0.0, 1.0], theta=[0.0, 0.1])))
    assert track.theta.tolist() == [0.0, 0.1]


def test_tables_do_not_change():
    with pytest.raises(TypeError):
        lw.CASES["new"] = None
    with pytest.raises(AttributeError, match="does not change"):
        lw.CASES._items = {}


def test_chunks_are_checked(hoop):
    pytest.importorskip("dask.array")
    values = {"theta": np.linspace(0.0, 1.0, 20), "theta_rate": 1.0}
    with pytest.raises(ValueError, match="chunks has thta; the dimensions are theta"):
        lw.outcome_map(hoop, **values, chunks={"thta": 10})
    for bad in ({"theta": 0}, 0, -2):
        with pytest.raises(ValueError, match="must be at least 1, or -1 for the whole dimension"):
            lw.outcome_map(hoop, **values, chunks=bad)
    assert lw.outcome_map(hoop, **values, chunks={"theta": -1}).chunks["theta"] == (20,)


@pytest.mark.parametrize("values", [np.array(["2020-01-01"], "datetime64[D]"), ["1", "2"], [1j]])
def test_what_is_no_number_is_refused(hoop, motion, values):
    with pytest.raises(
        TypeError, match=r"theta must hold real numbers: .* is not a type of real numbers"
    ):
        lw.simulate_many(hoop, theta=values, theta_rate=1.0)
    plane = motion.hoop.phase_plane
    for take in (
        motion,
        motion.to_pandas,
        motion.derivatives_at,
        lambda values: plane.normal(values, 1.0),
        lambda values: lw.closed_form.slip_angle(values),
        lambda values: lw.Track([0.0], theta=values[:1]),
        lambda values: lw.Track(values[:1], theta=[0.0]),
        lambda values: lw.Track.from_si(
            lw.Units(1.0, 1.0, 1.0, 1.0), time_s=[0.0], theta_rad=values[:1]
        ),
        lambda values: lw.scoring.Record(np.arange(3.0), np.zeros(3), np.ones(3), [values[0]] * 3),
    ):
        with pytest.raises(TypeError, match="is not a type of real numbers"):
            take(values)


KNOWN = {
    "disc_mass_kg": 0.25,
    "particle_mass_kg": 0.25,
    "radius_m": 0.3,
    "offset_m": 0.27,
    "inertia_kg_m2": 0.02,
    "mu_s": 0.5,
    "mu_k": 0.4,
}


@pytest.mark.parametrize("bad", ["1", b"1", None, 1j, [1.0], np.array(["1"])])
def test_a_number_is_no_text(hoop, bad):
    plain = {name: getattr(hoop, name) for name in ("mass_ratio", "offset", "inertia")}
    plain |= {"mu_s": 0.5, "mu_k": 0.4}
    si = lw.Hoop.from_si(**KNOWN)
    motion = hoop.simulate(theta=1.5, theta_rate=2.0)
    start = {"theta": 1.5, "theta_rate": 2.0}
    start_si = {"theta_rad": 1.5, "theta_rate_rad_per_s": 9.0}
    track = lw.Track(np.arange(30.0) / 10, theta=motion(np.arange(30.0) / 10).theta)
    optional = {"until": None, "until_s": None, "seconds": None, "restitution": None}
    calls = [
        *((lw.Hoop, plain, name) for name in (*plain, "slope", "restitution")),
        *((lw.Hoop.from_si, KNOWN, name) for name in (*KNOWN, "gravity_m_per_s2")),
        *((hoop.simulate, start, name) for name in (*START, "until")),
        *((si.simulate_si, start_si, name) for name in (*start_si, *SI_START[2:], "until_s")),
        *((hoop.classify, start, name) for name in ("theta", "theta_rate", "slip", "gap_rate")),
        (hoop.bouncing_orbit, {}, "angle"),
        (lambda until: lw.simulate_many(hoop, **start, until=until), {}, "until"),
        (lw.Units, dict.fromkeys(("length_m", "time_s", "gravity_m_per_s2"), 1.0), "mass_kg"),
        (lambda until: motion.sample(5, until=until), {}, "until"),
        (lambda seconds: motion.animate(seconds=seconds), {}, "seconds"),
    ]
    for call, given, name in calls:
        if bad is None and name in optional:
            continue
        with pytest.raises(TypeError, match=f"^{name} = .* must be a real number"):
            call(**{**given, name: bad})
    if bad is not None:
        with pytest.raises(TypeError, match=r"start of theta = .* must be a real number"):
            lw.fit(track, hoop, start={"theta": bad})
        with pytest.raises(TypeError, match=r"sigma of theta = .* must be a real number"):
            lw.fit(track, hoop, sigma={"theta": bad})


def test_a_count_is_no_text(hoop):
    start = {"theta": 1.5, "theta_rate": 2.0}
    motion = hoop.simulate(**start)
    for name in ("max_transitions", "max_slides"):
        with pytest.raises(TypeError, match=f"{name} = '9' must be a whole number"):
            hoop.simulate(**start, **{name: "9"})
    with pytest.raises(TypeError, match="threads = '2' must be a whole number"):
        lw.simulate_many(hoop, **start, threads="2")
    with pytest.raises(TypeError, match="frames = '9' must be a whole number"):
        motion.animate(frames="9")


def test_numbers_of_any_kind_are_taken(hoop):
    start = hoop.simulate(theta=Fraction(3, 2), theta_rate=Decimal(2)).start
    assert (
        start.numbers == hoop.simulate(theta=np.float32(1.5), theta_rate=np.array(2)).start.numbers
    )
    assert start.numbers[:2] == [1.5, 2.0]


def test_texts_among_objects_are_no_numbers(hoop):
    objects = np.array(["1", "2"], dtype=object)
    with pytest.raises(TypeError, match="theta must hold real numbers: a text is not"):
        lw.simulate_many(hoop, theta=objects, theta_rate=1.0)
    assert lw.simulate_many(hoop, theta=np.array([1, 2.5], dtype=object), theta_rate=1.0).start.size
    array = pytest.importorskip("dask.array")
    for values in (["1", "2"], np.array(["1"], dtype="U1")):
        with pytest.raises(TypeError, match="theta must hold real numbers"):
            lw.simulate_many(hoop, theta=array.from_array(np.array(values)), theta_rate=1.0)


def test_masked_values_are_missing(hoop, motion):
    masked = np.ma.masked_array([0.0, 1.0], mask=[False, True])
    assert np.isnan(motion(masked).theta).tolist() == [False, True]
    assert np.isnan(motion.to_pandas(masked).theta).tolist() == [False, True]
    assert np.isnan(motion.derivatives_at(masked, ["mu_k"]).theta).to_numpy().ravel().tolist() == [
        False,
        True,
    ]
    assert np.isnan(motion.hoop.phase_plane.normal(masked, 1.0)).tolist() == [False, True]
    units = lw.Units(1.0, 2.0, 1.0, 1.0)
    track = lw.Track.from_si(units, time_s=[0.0, 1.0], theta_rad=[0.0, 1.0], x_m=masked)
    assert np.isnan(track.x).tolist() == [False, True]
    with pytest.raises(ValueError, match=r"x\[1\] = nan must be finite"):
        lw.scoring.Record(
            np.arange(3.0), np.ma.masked_array(np.zeros(3), mask=[0, 1, 0]), np.ones(3), np.zeros(3)
        )
    with pytest.raises(lw.ParameterError, match="theta"):
        lw.simulate_many(hoop, theta=masked, theta_rate=1.0)


def test_a_name_is_no_hoop():
    with pytest.raises(
        TypeError, match=r"must be a Hoop: littlewood.case\('figure-3'\).hoop is one"
    ):
        lw.simulate_many("figure-3", theta=1.0, theta_rate=1.0)


def test_a_motion_as_comma_separated_values(motion, tmp_path):
    head, first, *rows = motion.to_csv(count=5).splitlines()
    assert head.split(",")[:4] == list(motion.to_pandas(count=5).columns[:4])
    assert len(rows) + 1 == len(motion.to_pandas(count=5)) and first.startswith("0.0,")
    assert motion.to_csv(tmp_path / "motion.csv", [0.0, 0.5]) is None
    assert (tmp_path / "motion.csv").read_text().count("\n") == 3


def test_a_motion_as_json_is_that_of_the_command_line(command, tmp_path):
    for name in ("figure-3", "figure-3-bounces", "ramp-jump"):
        motion = lw.case(name).simulate(until=20.0)
        for samples in (None, 7):
            more = [] if samples is None else [f"--samples={samples}"]
            said = command("simulate", name, "--until", "20", *more, "--format", "json").stdout
            # The name of the case is all that a motion does not know.
            assert motion.to_json(samples=samples) == said.replace(f'  "case": "{name}",\n', "")
    hula = {
        "disc_mass_kg": 0.4,
        "particle_mass_kg": 0.14,
        "radius_m": 0.45,
        "offset_m": 0.45,
        "inertia_kg_m2": 0.081,
    }
    hoop = lw.Hoop.from_si(**hula, mu_s=0.5, mu_k=0.4)
    motion = hoop.simulate_si(theta_rad=1.5, theta_rate_rad_per_s=9.0)
    given = flags(**hula, mu_s=0.5, mu_k=0.4, theta=1.5, theta_rate_rad_per_s=9.0)
    said = command("simulate", "--si", *given, "--samples=5", "--format", "json").stdout
    assert motion.to_json(samples=5) == said
    assert motion.to_json(tmp_path / "motion.json", samples=5) is None
    assert (tmp_path / "motion.json").read_text(encoding="utf-8") == said
    for count in (1, 10**7 + 1):
        with pytest.raises(ValueError, match=f"samples = {count} must not"):
            motion.to_json(samples=count)


def test_both_coefficients_of_friction_as_one_axis(hoop, command, tmp_path):
    rates = np.linspace(0.5, 3.0, 6)
    plane = lw.outcome_map(
        hoop, mu=np.linspace(0.1, 0.9, 5), theta_rate=rates, theta=1.5, until=20.0
    )
    assert plane.outcome.dims == ("mu", "theta_rate")
    assert plane.mu.attrs["long_name"] == "coefficient of static and kinetic friction"
    for name in ("mu_s", "mu_k"):
        assert (plane[name].dims, plane[name].to_numpy().tolist()) == (
            ("mu",),
            plane.mu.to_numpy().tolist(),
        )
    many = lw.simulate_many(
        hoop, mu=plane.mu.to_numpy()[:, None], theta_rate=rates, theta=1.5, until=20.0
    )
    np.testing.assert_array_equal(many.end_time, plane.end_time)
    path = tmp_path / "map.zarr"
    axes = ("--x", "mu=0.1:0.9:5", "--y", "theta_rate=0.5:3.0:6")
    assert (
        command(
            "map", "figure-3", *axes, "--theta=1.5", "--until=20", "--out", str(path)
        ).returncode
        == 0
    )
    said = xarray.open_zarr(path, consolidated=False, mask_and_scale=False).load()
    for name, variable in said.data_vars.items():
        assert plane[name].to_numpy().tobytes() == variable.to_numpy().tobytes(), name
    assert plane.mu.attrs == said.mu.attrs
    number = lw.outcome_map(hoop, mu=float(plane.mu[1]), theta=1.5, theta_rate=rates, until=20.0)
    np.testing.assert_array_equal(number.end_time, plane.end_time[1])
    lazy = lw.outcome_map(
        hoop, mu=plane.mu.to_numpy(), theta_rate=rates, theta=1.5, until=20.0, chunks={"mu": 2}
    )
    assert lazy.chunks["mu"] == (2, 2, 1)
    np.testing.assert_array_equal(lazy.end_time, plane.end_time)
    axes = lw.plot.outcomes(plane)
    assert axes.get_xlabel() == "*μ*"
    with pytest.raises(TypeError, match="mu and mu_k: mu gives both coefficients of friction"):
        lw.outcome_map(hoop, mu=[0.1, 0.2], mu_k=0.1, theta=0.0, theta_rate=1.0)
    with pytest.raises(lw.ParameterError, match="must not be negative"):
        lw.outcome_map(hoop, mu=[-0.1, 0.2], theta=0.0, theta_rate=1.0)


def test_axes_of_equal_factors_are_logarithmic(hoop):
    many = {"theta": 1.0, "theta_rate": np.linspace(1.0, 2.0, 4), "until": 2.0}
    plane = lw.outcome_map(hoop, **many, inertia=np.geomspace(0.01, 10.0, 4))
    axes = lw.plot.outcomes(plane, x="inertia")
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "linear")
    plt.close("all")


def test_an_inertia_beyond_the_rim_is_doubted():
    known = {
        "disc_mass_kg": 1.0,
        "particle_mass_kg": 1.0,
        "radius_m": 0.3,
        "offset_m": 0.3,
        "mu_s": 0.5,
        "mu_k": 0.4,
    }
    with pytest.warns(
        UserWarning, match="inertia_kg_m2 = 100 exceeds 0.09, that of a disc with all its mass"
    ):
        lw.Hoop.from_si(**known, inertia_kg_m2=100.0)
    lw.Hoop.from_si(**known, inertia_kg_m2=1.0 * 0.3**2)
