import math
import pickle

import numpy as np
import pytest
from conftest import RESISTANCE, resisted_hoop

import littlewood as lw

# Figure 3, from an integration of the Newton-Euler equations at 40 digits: time, θ, θ′, η′, x.
FIGURE_3 = {
    "stick": (
        0.564107553101996750,
        2.91722565678924913,
        2.93644326144529653,
        0.0,
        -1.42267101158774882,
    ),
    "slip": (
        0.973223074772405405,
        4.06633287423929561,
        2.46087950463497717,
        0.0,
        -2.57177822903779530,
    ),
    "lift_off": (
        1.51867021381943700,
        5.23673577087816789,
        1.99870593711413988,
        0.607696268534750732,
        -3.60928484639080078,
    ),
}


@pytest.fixture
def motion(hoop):
    return hoop.simulate(theta=math.pi / 2, theta_rate=2.0)


def test_figure_3(motion):
    found = {transition.cause: transition.state for transition in motion.transitions}
    for cause, expected in FIGURE_3.items():
        state = found[cause]
        assert (state.time, state.theta, state.theta_rate, state.slip, state.x) == pytest.approx(
            expected, abs=2e-15 * 8
        )
    assert found["landing"].time == pytest.approx(3.84739555668689420, abs=1e-14)
    assert [phase.mode for phase in motion.phases] == ["sliding", "rolling", "sliding", "flight"]
    assert [phase.direction for phase in motion.phases] == [-1, 0, 1, 0]
    assert motion.outcome.kind == "landing"
    assert motion.outcome.is_final
    assert motion.outcome.details["gap_rate"] < 0.0


def test_a_transition_has_a_state_on_either_side(motion):
    for transition, phase, following in zip(
        motion.transitions, motion.phases, motion.phases[1:], strict=False
    ):
        assert transition.state == phase.end
        assert transition.after == following.start
        # No velocity jumps at these transitions, and so there is no impact.
        assert transition.impact is None
        assert transition.after == transition.state
    assert motion.transitions[-1].to_mode is None


def test_phases_hang_together(motion):
    for phase, following in zip(motion.phases, motion.phases[1:], strict=False):
        assert phase.end == following.start
        assert phase.duration == phase.end_time - phase.start_time
    assert sum(phase.energy_lost for phase in motion.phases) == pytest.approx(motion.energy_lost)


def test_at_keeps_the_shape(motion):
    times = np.linspace(0.0, 3.8, 12).reshape(3, 4)
    samples = motion(times)
    assert samples.theta.shape == (3, 4)
    assert np.array_equal(samples.time, times)
    # One by one, the same bits; strided and reversed arrays, too.
    one_by_one = [motion(time).x for time in times.ravel()]
    assert np.array_equal(samples.x.ravel(), one_by_one)
    assert np.array_equal(motion(times[::-1, ::2]).energy, samples.energy[::-1, ::2])
    assert isinstance(motion(0.5).theta, float)


def test_at_hands_its_arrays_over(motion):
    samples = motion(np.linspace(0.0, 3.0, 1000))
    owner = samples.theta
    while isinstance(owner, np.ndarray):
        owner = owner.base
    # The memory is that of a vector of Rust, which the array keeps: it was not copied into one of
    # NumPy.
    assert type(owner).__name__ == "PySliceContainer"
    assert samples.theta.flags.writeable


def test_outside_the_motion_there_is_nothing(motion):
    samples = motion([-1.0, 0.0, 4.0, math.nan])
    assert samples["mode"].tolist() == [-1, 1, -1, -1]
    assert samples.mode_names.tolist() == ["", "sliding", "", ""]
    assert samples.is_outside.tolist() == [True, False, True, True]
    assert samples.is_in("sliding").tolist() == [False, True, False, False]
    with pytest.raises(KeyError):
        samples.is_in("sliding ←")
    assert np.isnan(samples.theta).tolist() == [True, False, True, True]
    assert samples.time[0] == -1.0


def test_at_a_transition_the_next_motion_begins(motion):
    stick = motion.transitions[0].time
    assert motion(stick).mode_names == "rolling"
    samples = motion.sample(11)
    assert len(samples.time) == 11 + 2 * 3
    assert np.sum(samples.time == stick) == 2


def test_positions_follow_from_the_angle(motion):
    samples = motion(np.linspace(0.0, 3.8, 50))
    np.testing.assert_allclose(samples.particle_x, samples.x - np.sin(samples.theta), atol=1e-14)
    np.testing.assert_allclose(
        samples.mass_centre_y, samples.centre_y + 0.5 * np.cos(samples.theta), atol=1e-14
    )
    np.testing.assert_allclose(samples.centre_y, 1.0 + samples.gap, atol=1e-15)


def test_a_motion_that_lasts_for_ever():
    motion = lw.case("figure-2-libration").simulate()
    assert motion.end_time == math.inf
    assert motion.phases[-1].end is None
    period = motion.outcome.period
    before, after = motion([1.0, 1.0 + 1e6 * period]).theta
    assert before == pytest.approx(after, abs=1e-8)
    assert motion.shown_until == 2 * period


def test_a_motion_with_rolling_resistance_comes_to_rest():
    reference = RESISTANCE[0]
    start = reference["start"]
    motion = resisted_hoop(reference).simulate(**start)
    assert [phase.mode for phase in motion.phases] == ["rolling", "rolling", "rest"]
    assert motion.sequence == "R0"
    assert [one.cause for one in motion.transitions] == ["turning_point"] * 2
    for found, expected in zip(motion.transitions, reference["transitions"], strict=True):
        for name in ("time", "theta", "theta_rate", "slip", "x"):
            assert getattr(found.state, name) == pytest.approx(float(expected[name]), abs=1e-12)
    lost = [float(one["lost"]["resistance"]) for one in reference["transitions"]]
    assert motion.phases[0].energy_lost == pytest.approx(lost[0], abs=1e-13)
    assert motion.rolling_resistance_energy_lost == pytest.approx(lost[1], abs=1e-13)
    assert motion.energy_lost == motion.rolling_resistance_energy_lost
    assert math.copysign(1.0, motion.impact_energy_lost) == 1.0
    outcome = motion.outcome
    assert (outcome.kind, outcome.is_final, outcome.period) == ("rests", True, None)
    assert dict(outcome.details) == {"half_swings": 2}
    assert "after 2 half swings" in str(motion)
    # What follows for ever is shown for a while, and stands still.
    rest = motion.phases[-1]
    assert (rest.end, motion.end_time) == (None, math.inf)
    table = motion.to_pandas()
    still = table[table["mode"] == "rest"]
    assert len(still) > 1 and set(still["theta"]) == {rest.start.theta}
    assert set(still["x"]) == {rest.start.x} and set(still["theta_rate"]) == {0.0}
    dataset = motion.to_xarray()
    assert dataset.attrs["outcome"] == "rests"
    assert dataset.attrs["rolling_resistance"] == reference["hoop"]["rolling_resistance"]


def test_no_motion_is_consistent():
    motion = lw.case("painleve").simulate()
    assert motion.phases == ()
    assert motion.outcome.kind == "inconsistent"
    assert motion.outcome.details["solvability_positive"] < 0.0
    assert motion.outcome.details["consistent"] == []
    assert "Rigid bodies have no answer here" in str(motion)
    assert "Rigid bodies have no answer here" in motion._repr_html_()


def test_proofs_that_end_a_motion():
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.5)
    start = {"theta": 3.0, "theta_rate": 2.36}
    motion = hoop.simulate(**start)
    assert (motion.outcome.kind, motion.outcome.is_final) == ("slips_forever", True)
    assert motion.outcome.details["grazing_energy"] == pytest.approx(4.390439266391853, abs=1e-13)
    followed = hoop.simulate(**start, proof="none", max_transitions=50)
    assert (followed.outcome.kind, len(followed.transitions)) == ("transition_limit", 50)
    known = lw.simulate_many(hoop, theta=3.0, theta_rate=[0.1, 2.36], proof="contact")
    assert [lw.tables.OUTCOMES[code] for code in known.outcome.values] == [
        "stays_in_contact",
        "slips_forever",
    ]
    assert known.attrs["proof"] == "contact"
    with pytest.raises(lw.ParameterError, match="no proof named"):
        lw.simulate_many(hoop, theta=2.5, theta_rate=0.1, proof="")


def test_limits(hoop):
    motion = hoop.simulate(theta=math.pi / 2, theta_rate=2.0, until=0.7)
    assert (motion.outcome.kind, motion.outcome.is_final, motion.end_time) == (
        "time_limit",
        False,
        0.7,
    )
    stopped = hoop.simulate(theta=math.pi / 2, theta_rate=2.0, max_transitions=1)
    assert (stopped.outcome.kind, stopped.outcome.details["transitions"]) == ("transition_limit", 1)
    with pytest.raises(ValueError, match="max_transitions = -1 must not be less than 0"):
        hoop.simulate(theta=0.0, theta_rate=1.0, max_transitions=-1)
    with pytest.raises(lw.ParameterError, match="no proof named 'perhaps'"):
        hoop.simulate(theta=0.0, theta_rate=1.0, proof="perhaps")
    with pytest.raises(ValueError, match="count = 1"):
        motion.sample(1)
    with pytest.raises(ValueError, match="until = nan"):
        motion.sample(10, math.nan)


def test_xarray_has_units_and_long_names(motion):
    dataset = motion.to_xarray(count=101)
    assert dict(dataset.sizes) == {"time": 101 + 6}
    assert (dataset.coords["time"].attrs["units"], dataset.coords["time"].attrs["scale"]) == (
        "1",
        "sqrt(R/g)",
    )
    assert dataset["theta"].attrs["units"] == "rad"
    for variable in dataset.variables.values():
        assert variable.attrs["long_name"]
    assert dataset["mode"].attrs["flag_meanings"].split() == ["outside", *lw.tables.MODES]
    assert dataset.attrs["outcome"] == "landing"
    times = np.array([0.1, 0.2])
    np.testing.assert_array_equal(motion.to_xarray(times)["theta"], motion(times).theta)


def test_tables_have_the_columns_of_the_command_line(motion, command):
    done = command("simulate", "figure-3", "--format", "csv", "--samples", "5")
    assert done.returncode == 0, done.stderr
    header, *rows = done.stdout.splitlines()
    table = motion.to_pandas(count=5)
    # The command line adds the transitions' edges to each row; the shared columns come first or by
    # name.
    names = header.split(",")
    shared = [name for name in table.columns if name in names]
    assert set(table.columns) <= set(names)
    assert len(rows) == len(table)
    for row, (_, ours) in zip(rows, table.iterrows(), strict=True):
        said = dict(zip(names, row.split(","), strict=True))
        for name in shared:
            assert said[name] == ours[name] if name == "mode" else float(said[name]) == ours[name]


def test_si_tables(command):
    hoop = lw.Hoop.from_si(
        disc_mass_kg=0.4,
        particle_mass_kg=0.14,
        radius_m=0.45,
        offset_m=0.45,
        inertia_kg_m2=0.081,
        mu_s=0.5,
        mu_k=0.4,
    )
    motion = hoop.simulate_si(theta_rad=1.5, theta_rate_rad_per_s=9.0)
    table = motion.to_pandas(count=11, si=True)
    plain = motion.to_pandas(count=11)
    assert table["time_s"].iloc[-1] == pytest.approx(plain["time"].iloc[-1] * hoop.units.time_s)
    assert table["theta_rate_rad_per_s"].iloc[0] == pytest.approx(9.0)
    np.testing.assert_allclose(
        table["normal_n"], plain["normal"] * 0.14 * lw.hoop.STANDARD_GRAVITY, rtol=1e-15
    )
    dataset = motion.to_xarray(si=True)
    assert dataset["energy_j"].attrs["units"] == "J"
    with pytest.raises(ValueError, match="from_si"):
        lw.case("figure-3").simulate().to_pandas(si=True)


def test_it_survives_a_trip(motion):
    again = pickle.loads(pickle.dumps(motion))
    assert again.transitions == motion.transitions
    assert again.hoop == motion.hoop


def test_words(motion):
    assert repr(motion) == "<Trajectory -R+F: lands>"
    row = next(line.split() for line in str(motion).splitlines() if line.startswith("4"))
    assert row == [
        "4",
        "flight",
        "1.51867",
        "2.32873",
        "5.23674",
        "1.99871",
        "0.60770",
        "0",
        "landing",
    ]
    page = motion._repr_html_()
    assert page.count("<tr") == 5
    assert "lift-off" in page


def test_thresholds_are_closed_forms_to_the_last_digit():
    # With the particle at the top the rim leaves the plane where h θ′² = 1, and h is 1/2.
    top = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=1, mu_k=1)
    found = top.threshold(of="theta_rate", between=(1.4, 2), theta=0, theta_rate=1)
    assert found.above.value == pytest.approx(math.sqrt(2), abs=4e-15)
    assert found.below.class_name != found.above.class_name
    assert found.quantity == "theta_rate" and "1.41421356" in found.text
    assert top.threshold(of="x", between=(0, 1), theta=0, theta_rate=1) is None
    with pytest.raises(lw.ParameterError, match="mu_z"):
        top.threshold(of="mu_z", theta=0, theta_rate=1)
    with pytest.raises(lw.ParameterError, match="mu_k"):
        top.threshold(of="mu_k", between=(-1, 0.5), theta=0, theta_rate=1)


def test_classification(hoop):
    found = hoop.classify(theta=-1.2, theta_rate=2.0)
    assert (found.region, found.mode) == ("sliding_band", "sliding")
    assert found.rolling_normal < 0.0 < found.contact
    massless = lw.case("figure-7").hoop.classify(theta=0.0, theta_rate=0.5)
    assert massless.rolling_type == "III"
    end = massless.rolling_end
    # Figure 7: τ_s = ln 5, cos θ_s = 3/5, θ′ = 3/4.
    assert (end.elapsed, math.cos(end.theta), end.theta_rate, end.cause) == (
        pytest.approx(math.log(5)),
        pytest.approx(0.6),
        pytest.approx(0.75),
        "slip",
    )
