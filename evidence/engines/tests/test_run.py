"""The parts of evidence/engines/run.py that need no engine."""

import math
import re
from pathlib import Path

import littlewood as lw
import pytest

FOLDER = Path(__file__).resolve().parents[1]


def test_the_cases_have_the_events_that_they_are_for(run):
    assert [t.cause for t in run.CASES["figure-3"].motion().transitions][:4] == ["stick", "slip", "lift_off", "landing"]
    assert [t.cause for t in run.CASES["slides-and-sticks"].motion().transitions] == ["stick"]
    assert not run.CASES["rolls"].motion().transitions
    assert [t.cause for t in run.CASES["lands"].motion().transitions] == ["landing", "stick"]


def test_the_ramps_are_those_of_the_closed_forms(run):
    """ℓ = 0: x″ = −m sin α/D without slip, D = Î + m, and −sin α + μ cos α with it; rest next to the equilibrium."""
    sin, cos = math.sin, math.cos
    for name, rate in (("ramp-rolls", -sin(0.3) * 2 / 3), ("ramp-slips", 0.1 * cos(0.5) - sin(0.5))):
        motion = run.CASES[name].motion()
        assert not motion.transitions
        assert motion(5.0).x == pytest.approx(12.5 * rate, rel=1e-14)
    case = run.CASES["ramp-rests"]
    assert abs(sin(case.theta + case.slope) + 2 * sin(case.slope)) < 1e-5
    assert abs(case.motion()(5.0).x) < 2e-5
    causes = [transition.cause for transition in run.CASES["ramp-jumps"].motion().transitions]
    assert causes[:4] == ["stick", "slip", "lift_off", "landing"]


def test_all_laws_of_restitution_agree_on_the_cases_that_bounce(run):
    bouncing = {label: case for label, case in run.CASES.items() if case.restitution > 0.0}
    assert {label: case.restitution for label, case in bouncing.items()} == {"bounces": 0.5, "bounces-high": 0.8}
    for label, case in bouncing.items():
        motions = [case.motion(law) for law in ("newton", "poisson", "energetic")]
        times = [[t.time for t in motion.transitions] for motion in motions]
        assert len(times[0]) == {"bounces": 3, "bounces-high": 5}[label]
        assert times[1] == pytest.approx(times[0], abs=1e-9)
        assert times[2] == pytest.approx(times[0], abs=1e-9)
        for transition in motions[0].transitions:
            assert transition.impact.after.slip * transition.impact.before.slip > 0.0
            ratio = transition.impact.after.gap_rate / transition.impact.before.gap_rate
            assert ratio == pytest.approx(-case.restitution, abs=1e-9)


def test_new_runs_replace_those_of_their_case_and_setting(run):
    def one(case, setting, step, status="scored"):
        return {"case": case, "setting": setting, "step": step, "status": status}

    old = [one("figure-3", "default", 1e-2), one("rolls", "default", 1e-2), one("rolls", "careful", 1e-2)]
    new = [one("rolls", "default", 1e-3), one("rolls", "default", 1e-1, "failed")]
    assert run.merged(old, new, ("default", "careful")) == [old[0], new[1], new[0], old[2]]


def test_two_coefficients_is_the_motion_of_the_paper(run):
    mine = run.CASES["two-coefficients"].motion()
    paper = lw.case("figure-3").simulate()
    assert [t.time for t in mine.transitions[:3]] == [t.time for t in paper.transitions[:3]]


def test_an_adapter_reads_what_is_written(run):
    case = run.CASES["lands"]
    hoop = case.motion().hoop
    text = (FOLDER / "adapters" / "adapter.py").read_text(encoding="utf-8")
    fields = re.search(r"class Case:(.*?)@property", text, re.DOTALL)[1]
    assert list(case.file(hoop)) == re.findall(r"^    (\w+): float$", fields, re.MULTILINE)
    assert case.file(hoop)["mass"] == 2.0


def test_adapters_are_short_and_say_what_they_cannot(run):
    assert len(list((FOLDER / "adapters").glob("*_adapter.*"))) == len(run.ENGINES)
    for name in run.ENGINES:
        text = run.adapter_of(name).read_text(encoding="utf-8")
        assert len(text.splitlines()) <= 150
        assert re.search(r"^(?://! )?(Cannot|Can) express:", text, re.MULTILINE), name
        assert all(setting in text for setting in run.ENGINES[name].settings)


def test_versions_are_exact(run):
    assert run.versions("numpy==2.4.6\nscipy==1.17.1\n") == {"numpy": "2.4.6", "scipy": "1.17.1"}
    assert run.versions('[package]\nversion = "0.0.0"\n[dependencies]\nserde = "=1.0.2"\n') == {"serde": "1.0.2"}
    files = list((FOLDER / "requirements").iterdir())
    assert len(files) == len(run.ENGINES) - 1
    for path in files:
        assert path.stem in run.ENGINES
        assert run.versions(run.requirements(path.stem).read_text(encoding="utf-8"))


def test_outcomes_without_a_record(run):
    assert run.outcome(None, "")["status"] == "timeout"
    assert run.outcome(run.REFUSED, "one\nthe engine has one coefficient\n") == {
        "status": "refused",
        "reason": "the engine has one coefficient",
    }
    assert run.outcome(1, "")["status"] == "failed"


def test_scores_are_kept_with_eight_digits(run):
    assert run.rounded({"a": [math.pi, None, "word"], "b": 3}) == {"a": [3.1415927, None, "word"], "b": 3}


def test_the_results_have_every_engine_and_no_path(run):
    every = run.read(run.RESULTS)
    assert list(every) == list(run.read_engines(run.RESULTS)) == list(run.ENGINES)
    for name, runs in every.items():
        assert {one["setting"] for one in runs} == set(run.ENGINES[name].settings)
        assert {one["case"] for one in runs} in (set(run.CASES), set(run.CASES) - set(run.RAMPS)), name
    assert sum(any(one["case"] in run.RAMPS for one in runs) for runs in every.values()) >= 10
    texts = [path.read_text(encoding="utf-8") for path in run.RESULTS.iterdir()]
    assert len(texts) == 2
    assert not any(re.search(r"/(work|home|tmp|usr)/", text) for text in texts)


def test_the_results_are_written_as_they_are_read(run, tmp_path):
    run.write(tmp_path, run.read(run.RESULTS), run.read_engines(run.RESULTS))
    for path in run.RESULTS.iterdir():
        assert (tmp_path / path.name).read_bytes() == path.read_bytes()
