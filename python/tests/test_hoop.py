import dataclasses
import math
import pickle

import pytest
from conftest import flags

import littlewood as lw

GOOD = {"mass_ratio": 1.0, "offset": 1.0, "inertia": 1.0, "mu_s": 0.5, "mu_k": 0.4}
GOOD_SI = {
    "disc_mass_kg": 0.4,
    "particle_mass_kg": 0.14,
    "radius_m": 0.45,
    "offset_m": 0.45,
    "inertia_kg_m2": 0.081,
    "mu_s": 0.5,
    "mu_k": 0.4,
}


@pytest.mark.parametrize(
    "change",
    [
        {"mu_k": 0.6},
        {"offset": 1.5},
        {"offset": math.nan},
        {"mass_ratio": -1.0},
        {"mass_ratio": math.inf},
        {"inertia": -0.25},
        {"inertia": 1e10},
        {"mu_s": -0.1, "mu_k": -0.2},
        {"offset": 0.0, "inertia": 0.0, "mass_ratio": 0.0},
    ],
)
def test_a_bad_hoop_is_refused_in_the_words_of_the_command_line(change, command):
    with pytest.raises(lw.ParameterError) as caught:
        lw.Hoop(**{**GOOD, **change})
    assert isinstance(caught.value, ValueError)
    done = command("simulate", *flags(**{**GOOD, **change}, theta=1.0, theta_rate=0.0))
    assert done.returncode == 2
    said = " ".join(done.stderr.replace("│", " ").split())
    assert str(caught.value) in said
    assert caught.value.hint in said


@pytest.mark.parametrize(
    "change", [{"radius_m": 0.0}, {"offset_m": 0.5}, {"particle_mass_kg": -1.0}]
)
def test_a_bad_hoop_in_si_is_refused_in_the_words_of_the_command_line(change, command):
    with pytest.raises(lw.ParameterError) as caught:
        lw.Hoop.from_si(**{**GOOD_SI, **change})
    start = {"theta": 1.0, "theta_rate_rad_per_s": 0.0}
    done = command("simulate", *flags(**{**GOOD_SI, **change}, **start))
    assert done.returncode == 2, done.stdout
    assert str(caught.value) in " ".join(done.stderr.replace("│", " ").split())


@pytest.mark.parametrize(
    ("start", "name"),
    [
        ({"theta": math.nan, "theta_rate": 0.0}, "theta"),
        ({"theta": 0.0, "theta_rate": 1e7}, "theta_rate"),
        ({"theta": 0.0, "theta_rate": 0.0, "until": -1.0}, "until"),
        ({"theta": 0.0, "theta_rate": 0.0, "slip": -math.inf}, "slip"),
    ],
)
def test_a_bad_start_is_refused_in_the_words_of_the_command_line(start, name, hoop, command):
    with pytest.raises(lw.ParameterError) as caught:
        hoop.simulate(**start)
    assert caught.value.quantity == name
    done = command("simulate", *flags(**GOOD, **start))
    assert done.returncode == 2
    assert str(caught.value) in " ".join(done.stderr.replace("│", " ").split())


def test_arguments_are_named_and_numbers():
    with pytest.raises(TypeError):
        lw.Hoop(1, 1, 1, 0.5, 0.4)
    with pytest.raises((TypeError, ValueError)):
        lw.Hoop(**{**GOOD, "offset": "rim"})
    assert lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4) == lw.Hoop(**GOOD)


def test_a_hoop_is_a_value(hoop):
    assert pickle.loads(pickle.dumps(hoop)) == hoop
    assert eval(repr(hoop), {"Hoop": lw.Hoop}) == hoop
    assert len({hoop, lw.Hoop(**GOOD)}) == 1
    rougher = dataclasses.replace(hoop, mu_s=0.9)
    assert (rougher.mu_s, rougher.mu_k) == (0.9, 0.4)
    with pytest.raises(dataclasses.FrozenInstanceError):
        hoop.mu_s = 1.0


def test_derived_numbers_are_those_of_the_paper(hoop):
    # (2.1), (2.4): m = 2, h = 1/2, I = 1 + 1/2.
    assert (hoop.mass, hoop.h, hoop.inertia_about_mass_centre) == (2.0, 0.5, 1.5)


def test_si_units():
    hoop = lw.Hoop.from_si(**GOOD_SI, gravity_m_per_s2=9.81)
    units = hoop.units
    assert hoop.mass_ratio == pytest.approx(0.4 / 0.14, rel=1e-15)
    assert hoop.inertia == pytest.approx(0.081 / (0.14 * 0.45**2), rel=1e-15)
    assert units.time_s == pytest.approx(math.sqrt(0.45 / 9.81), rel=1e-15)
    assert units.velocity_m_per_s == pytest.approx(math.sqrt(0.45 * 9.81), rel=1e-15)
    assert units.energy_j == pytest.approx(0.14 * 9.81 * 0.45, rel=1e-15)


def test_a_start_in_si_is_that_of_the_command_line(command_json):
    hoop = lw.Hoop.from_si(**GOOD_SI)
    start = {
        "theta_rate_rad_per_s": 9.0,
        "slip_m_per_s": 0.3,
        "x_m": 1.0,
        "time_s": 0.25,
        "until_s": 2.0,
    }
    motion = hoop.simulate_si(theta_rad=1.5, **start)
    said = command_json("simulate", "--si", *flags(**GOOD_SI, theta=1.5, **start))
    assert [transition.time for transition in motion.transitions] == [
        t["time"] for t in said["transitions"]
    ]
    assert motion.start.theta_rate == said["start"]["theta_rate"]


def test_without_units_there_are_no_seconds(hoop):
    with pytest.raises(ValueError, match="from_si"):
        hoop.simulate_si(theta_rad=0.0, theta_rate_rad_per_s=1.0)
    si = lw.Hoop.from_si(**GOOD_SI)
    with pytest.raises(lw.ParameterError, match="until_s = 0 s must not be less than time_s = 1 s"):
        si.simulate_si(theta_rad=0.0, theta_rate_rad_per_s=1.0, time_s=1.0, until_s=0.0)


def test_html_shows_the_parameters():
    page = lw.Hoop.from_si(**GOOD_SI)._repr_html_()
    for piece in ("<svg", "m₁/m₂", "2.85714", "0.45 m", "0.14 kg"):
        assert piece in page


def test_cases_and_edges_are_those_of_the_command_line(command_json):
    said = command_json("cases")
    assert [case["name"] for case in said] == list(lw.CASES)
    for case in said:
        assert lw.case(case["name"]).title == case["title"]
    with pytest.raises(KeyError, match="figure-3"):
        lw.case("figure3")
    assert {edge.cause for edge in lw.motion.EDGES} >= {"slip", "stick", "lift_off", "landing"}
