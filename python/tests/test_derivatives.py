import json
import math
from pathlib import Path

import numpy as np
import pytest

import littlewood as lw

EVIDENCE = Path(__file__).resolve().parents[2] / "evidence" / "reference" / "derivatives.json"
STATE = ("time", "theta", "theta_rate", "slip", "x")


def test_rolling_of_littlewoods_hoop_from_the_top():
    # sin(θ/2) = s = θ0′ sinh(τ/2), and θ′ = θ0′ cosh(τ/2)/cos(θ/2).
    rate = 0.5
    motion = lw.case("figure-7").simulate()
    times = np.linspace(0.0, 0.99 * math.log(5), 40)
    found = motion.derivatives_at(times, ["theta_rate"]).sel(quantity="theta_rate")
    sinh, cosh = np.sinh(times / 2), np.cosh(times / 2)
    cos = np.sqrt(1 - (rate * sinh) ** 2)
    np.testing.assert_allclose(found.theta, 2 * sinh / cos, atol=1e-13)
    np.testing.assert_allclose(found.theta_rate, cosh / cos**3, atol=1e-13)
    # The centre rolls to the left by as much as the hoop turns.
    np.testing.assert_allclose(found.x, -2 * sinh / cos, atol=1e-13)
    np.testing.assert_allclose(found.slip, 0.0, atol=1e-14)


def test_slip_of_littlewoods_hoop_from_the_top():
    # It slips at tan(θ/2) = μs, that is at sinh(τ/2) = sin(θ/2)/θ0′.
    mu_s, rate = 0.5, 0.5
    slip = (
        lw.case("figure-7")
        .simulate()
        .derivatives(["theta_rate", "mu_s", "mu_k"])
        .isel(transition=0)
    )
    half_sine, half_cosine = mu_s / math.hypot(1, mu_s), 1 / math.hypot(1, mu_s)
    angle = 2 / (1 + mu_s**2)
    cosh = math.hypot(1, half_sine / rate)
    by_rate = -2 * half_sine / rate**2 / cosh
    by_friction = angle * half_cosine / rate / cosh
    np.testing.assert_allclose(slip.time, [by_rate, by_friction, 0.0], atol=1e-13)
    np.testing.assert_allclose(slip.theta, [0.0, angle, 0.0], atol=1e-13)


MOTIONS = json.loads(EVIDENCE.read_text(encoding="utf-8"))["motions"]


@pytest.mark.parametrize("row", MOTIONS[::8], ids=lambda row: row["kind"])
def test_derivatives_are_those_of_differences_with_40_digits(row):
    hoop = lw.Hoop(**row["hoop"])
    events = row["events"]
    motion = hoop.simulate(**row["start"], max_transitions=len(events))
    names = list(events[0]["after"])
    found = motion.derivatives(names)
    assert set(found.reason.values.ravel()) == {""}
    inertia = hoop.inertia
    # A light hoop amplifies rounding once it passes the bottom.
    bound = 1e-11 * (1 + (hoop.offset / inertia if inertia > 0 else 0))
    for i, event in enumerate(events):
        assert motion.transitions[i].cause == event["cause"]
        for name in names:
            ours = [float(found[column].sel(transition=i, quantity=name)) for column in STATE]
            theirs = np.array(event["after"][name])
            np.testing.assert_allclose(
                ours, theirs, rtol=0, atol=bound * max(1.0, np.abs(theirs).max())
            )


def test_the_command_line_has_the_same_bits(command_json):
    said = command_json("simulate", "figure-3-bounces", "--derivatives", "all")
    found = lw.case("figure-3-bounces").simulate().derivatives()
    assert found.sizes["transition"] == len(said["transitions"])
    for prefix, data, row in [
        ("end_", found, said["outcome"]),
        *(("", found.isel(transition=i), row) for i, row in enumerate(said["transitions"])),
    ]:
        theirs = row["derivatives"]
        assert list(theirs) == found["quantity"].values.tolist()
        for name, numbers in theirs.items():
            ours = data.sel(quantity=name)
            assert str(ours[prefix + "reason"].values) == numbers.get("reason", "")
            for column in numbers.keys() & {*STATE}:
                assert float(ours[prefix + column]) == numbers[column]
    recurrence = {"period", "theta_min", "theta_max"} & said["outcome"]["derivatives"][
        "mu_k"
    ].keys()
    assert recurrence
    for name in recurrence:
        assert [float(value) for value in found[name] if not math.isnan(value)] == [
            numbers[name] for numbers in said["outcome"]["derivatives"].values() if name in numbers
        ]


def test_a_derivative_that_does_not_exist_has_a_reason():
    found = lw.case("figure-7").simulate().derivatives()
    singular = found.isel(transition=2).sel(quantity="theta_rate")
    one_sided = found.isel(transition=0).sel(quantity=["mass_ratio", "inertia", "slip", "gap_rate"])
    assert str(singular.reason.values) == "singular"
    assert set(one_sided.reason.values) == {"one_sided"}
    for column in STATE:
        assert np.array_equal(np.isnan(found[column]), found.reason != "")
        assert np.array_equal(np.isnan(found["end_" + column]), found.end_reason != "")
    assert set(found.end_reason.sel(quantity=["theta", "theta_rate"]).values) == {"singular"}
    assert "period" not in found


def test_quantities_of_a_motion(hoop):
    motion = hoop.simulate(theta=math.pi / 2, theta_rate=2.0)
    found = motion.derivatives()
    assert found["quantity"].values.tolist() == [
        *(name for name in lw.tables.HOOP if name != "restitution"),
        *lw.tables.START,
    ]
    assert dict(found.sizes) == {"transition": 4, "quantity": 13}
    # Time and place of the start shift the motion.
    np.testing.assert_allclose(found.x.sel(quantity="x"), 1.0)
    np.testing.assert_array_equal(found.time.sel(quantity="time"), 1.0)
    bounces = lw.case("figure-3-bounces").simulate().derivatives()
    assert "restitution" in bounces["quantity"]
    with pytest.raises(
        lw.ParameterError, match="no quantity of a hoop or a start named 'mu'"
    ) as raised:
        motion.derivatives(["mu"])
    assert "mu_s, mu_k" in raised.value.hint
    with pytest.raises(
        lw.ParameterError, match="no derivatives with respect to restitution"
    ) as raised:
        motion.derivatives_at(1.0, ["mu_k", "restitution"])
    assert raised.value.quantity == "restitution"
    with pytest.raises(TypeError):
        motion.derivatives("mu_k")
    assert dict(motion.derivatives([]).sizes) == {"transition": 4, "quantity": 0}


def test_at_fixed_times(hoop):
    motion = hoop.simulate(theta=math.pi / 2, theta_rate=2.0)
    found = motion.derivatives_at([-1.0, 0.0, 1.0, 9.0], ["theta_rate", "x", "mu_k"])
    assert dict(found.sizes) == {"time": 4, "quantity": 3}
    assert found.reason.values.tolist() == [["outside"] * 3, [""] * 3, [""] * 3, ["outside"] * 3]
    assert np.array_equal(np.isnan(found.theta), found.reason == "outside")
    assert found.isel(time=1).theta_rate.values.tolist() == [1.0, 0.0, 0.0]
    one = motion.derivatives_at(1.0, ["theta_rate", "x", "mu_k"])
    assert dict(one.sizes) == {"quantity": 3}
    np.testing.assert_array_equal(one.theta, found.theta[2])
    with pytest.raises(ValueError, match=r"times of shape \(1, 2\)"):
        motion.derivatives_at([[0.0, 1.0]])


@pytest.mark.parametrize("index", [0, 1, 2])
def test_along_an_event_they_are_those_at_its_time_and_its_delay(hoop, index):
    # δy = δy(fixed τ) + y′ δτ, with y′ from the motion that begins: θ″ by a difference within it.
    motion = hoop.simulate(theta=math.pi / 2, theta_rate=2.0)
    names = ["theta_rate", "mu_k", "mu_s", "offset"]
    event = motion.derivatives(names).isel(transition=index)
    state = motion.transitions[index].after
    fixed = motion.derivatives_at(state.time, names)
    np.testing.assert_allclose(event.theta, fixed.theta + state.theta_rate * event.time, atol=1e-12)
    step = 1e-4
    near = motion(state.time + np.array([1, 2]) * step).theta_rate
    rate = (4 * near[0] - near[1] - 3 * state.theta_rate) / (2 * step)
    np.testing.assert_allclose(event.theta_rate, fixed.theta_rate + rate * event.time, atol=1e-6)


def test_they_have_no_units():
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
    start = motion.start
    plain = lw.Hoop(**{name: getattr(hoop, name) for name in lw.tables.HOOP}).simulate(
        **vars(start)
    )
    found = motion.derivatives()
    assert found.equals(plain.derivatives())
    for name, variable in found.data_vars.items():
        assert variable.attrs["long_name"]
        assert name.endswith("reason") or variable.attrs["units"] == "1"
    assert (found.time.attrs["scale"], found.end_slip.attrs["scale"]) == ("sqrt(R/g)", "sqrt(g R)")
    assert (
        lw.case("figure-2-libration").simulate().derivatives().period.attrs["scale"] == "sqrt(R/g)"
    )


def test_what_follows_a_jam_without_a_motion_before_is_not_differentiated():
    # The jam of a start ends no phase; its impact changes all that follows.
    motion = lw.case("jam").simulate()
    assert (motion.transitions[0].cause, motion.transitions[0].from_mode) == ("jam", None)
    found = motion.derivatives(["theta", "slip", "mu_k"])
    assert set(found.reason.values.ravel()) == set(found.end_reason.values) == {"singular"}
    fixed = motion.derivatives_at([motion.start.time, 1.0], ["theta"])
    assert set(fixed.reason.values.ravel()) == {"singular"}
