"""What Python is given: kinds of arrays, chunks, hoops; and what is pickled."""

import math
import pickle

import matplotlib.pyplot as plt
import numpy as np
import pytest

import littlewood as lw


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
    with pytest.raises(TypeError, match=r"theta must hold real numbers: .* is not a type of real numbers"):
        lw.simulate_many(hoop, theta=values, theta_rate=1.0)
    with pytest.raises(TypeError, match="is not a type of real numbers"):
        motion(values)


def test_masked_values_are_missing(hoop, motion):
    masked = np.ma.masked_array([0.0, 1.0], mask=[False, True])
    assert np.isnan(motion(masked).theta).tolist() == [False, True]
    with pytest.raises(lw.ParameterError, match="theta"):
        lw.simulate_many(hoop, theta=masked, theta_rate=1.0)


def test_a_name_is_no_hoop():
    with pytest.raises(TypeError, match=r"must be a Hoop: littlewood.case\('figure-3'\).hoop is one"):
        lw.simulate_many("figure-3", theta=1.0, theta_rate=1.0)


def test_a_motion_as_comma_separated_values(motion, tmp_path):
    head, first, *rows = motion.to_csv(count=5).splitlines()
    assert head.split(",")[:4] == list(motion.to_pandas(count=5).columns[:4])
    assert len(rows) + 1 == len(motion.to_pandas(count=5)) and first.startswith("0.0,")
    assert motion.to_csv(tmp_path / "motion.csv", [0.0, 0.5]) is None
    assert (tmp_path / "motion.csv").read_text().count("\n") == 3


def test_axes_of_equal_factors_are_logarithmic(hoop):
    many = {"theta": 1.0, "theta_rate": np.linspace(1.0, 2.0, 4), "until": 2.0}
    plane = lw.outcome_map(hoop, **many, inertia=np.geomspace(0.01, 10.0, 4))
    axes = lw.plot.outcomes(plane, x="inertia")
    assert (axes.get_xscale(), axes.get_yscale()) == ("log", "linear")
    plt.close("all")


def test_an_inertia_beyond_the_rim_is_doubted():
    known = {"disc_mass_kg": 1.0, "particle_mass_kg": 1.0, "radius_m": 0.3, "offset_m": 0.3, "mu_s": 0.5, "mu_k": 0.4}
    with pytest.warns(UserWarning, match="inertia_kg_m2 = 100 exceeds 0.09, that of a disc with all its mass"):
        lw.Hoop.from_si(**known, inertia_kg_m2=100.0)
    lw.Hoop.from_si(**known, inertia_kg_m2=1.0 * 0.3**2)
