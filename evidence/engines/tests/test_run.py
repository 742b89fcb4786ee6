"""The parts of evidence/engines/run.py and report.py that need no engine, and the template."""

import itertools
import json
import math
import re
import subprocess
import sys
from pathlib import Path

import littlewood as lw
import pytest
from littlewood.scoring import BENCHMARK

FOLDER = Path(__file__).resolve().parents[1]


def causes(name):
    return [one.cause for one in BENCHMARK[name].motion.transitions]


def test_the_cases_have_the_events_that_they_are_for():
    assert causes("one-coefficient")[:4] == ["stick", "slip", "lift_off", "landing"]
    assert (
        causes("pritchett-wagon")[:5]
        == causes("comsol")[:5]
        == ["slip", "stick", "slip", "lift_off", "landing"]
    )
    assert causes("slides-and-sticks") == ["stick"]
    assert not causes("rolls") and not causes("nearly-slips")
    assert causes("just-slips") == ["slip", "stick"]
    assert causes("lands") == ["landing", "stick"]
    assert causes("jam-16") == ["jam", "lift_off"]


def test_published_hoops_are_those_of_their_authors():
    """γ is the part of the mass in the load: the ring has (1 − γ)/γ of it, at the rim."""
    for name, part, mu_s, mu_k in (("pritchett-wagon", 0.95, 1.0, 0.8), ("comsol", 0.75, 1.0, 1.0)):
        hoop = BENCHMARK[name].motion.hoop
        assert (hoop.mu_s, hoop.mu_k, hoop.offset) == (mu_s, mu_k, 1.0)
        assert hoop.mass_ratio == hoop.inertia == pytest.approx((1.0 - part) / part, rel=1e-15)


def test_the_ramps_are_those_of_the_closed_forms():
    """ℓ = 0: x″ = −m sin α/D without slip, D = Î + m, and −sin α + μ cos α with it; rest next to
    the equilibrium.
    """
    sin, cos = math.sin, math.cos
    for name, rate in (
        ("ramp-rolls", -sin(0.3) * 2 / 3),
        ("ramp-slips", 0.1 * cos(0.5) - sin(0.5)),
    ):
        motion = BENCHMARK[name].motion
        assert not motion.transitions
        assert motion(5.0).x == pytest.approx(12.5 * rate, rel=1e-14)
    motion = BENCHMARK["ramp-rests"].motion
    assert abs(sin(motion.start.theta + motion.hoop.slope) + 2 * sin(motion.hoop.slope)) < 1e-5
    assert abs(motion(5.0).x) < 2e-5
    assert causes("ramp-jumps")[:4] == ["stick", "slip", "lift_off", "landing"]


def bounce(name, law):
    given = BENCHMARK[name].given
    hoop = lw.Hoop(**(given["hoop"] | {"restitution_law": law}))
    return hoop.simulate(**given["start"], until=given["until"])


def test_laws_of_restitution_agree_where_slip_does_not_end_in_an_impact():
    for name, count in {"bounces": 3, "bounces-high": 5}.items():
        motions = [bounce(name, law) for law in ("newton", "poisson", "energetic")]
        times = [[t.time for t in motion.transitions] for motion in motions]
        assert len(times[0]) == count
        assert times[1] == pytest.approx(times[0], abs=1e-9)
        assert times[2] == pytest.approx(times[0], abs=1e-9)
        for transition in motions[0].transitions:
            assert transition.impact.after.slip * transition.impact.before.slip > 0.0
            ratio = transition.impact.after.gap_rate / transition.impact.before.gap_rate
            assert ratio == pytest.approx(-motions[0].hoop.restitution, abs=1e-9)


def test_the_law_cases_differ_by_far_more_than_an_error_of_a_solver():
    impacts = {
        law: BENCHMARK[f"law-{law}"].motion.transitions[0].impact
        for law in ("energetic", "poisson", "newton")
    }
    before = {(one.before.slip, one.before.gap_rate) for one in impacts.values()}
    assert len(before) == 1
    rates = sorted(one.after.gap_rate for one in impacts.values())
    assert min(b - a for a, b in itertools.pairwise(rates)) > 0.1
    newton = impacts["newton"]
    assert newton.after.gap_rate == pytest.approx(-0.8 * newton.before.gap_rate, rel=1e-12)


def test_a_tie_is_told_by_little_friction():
    """What holds, and what gives way, differs by 2 % of the coefficient."""
    holds, gives = (
        BENCHMARK["nearly-slips"].motion.hoop.mu_s,
        BENCHMARK["just-slips"].motion.hoop.mu_s,
    )
    assert 0.02 < holds / gives - 1.0 < 0.025
    barely = lw.Hoop(
        mass_ratio=1, offset=1, inertia=1, mu_s=holds * 0.998, mu_k=holds * 0.998, restitution=0
    )
    assert barely.simulate(theta=2.0, theta_rate=0.9, until=4.0).transitions


def test_new_runs_replace_those_of_their_case_and_setting(run):
    def one(case, setting, step, status="scored"):
        return {"case": case, "setting": setting, "step": step, "status": status}

    old = [
        one("lands", "default", 1e-2),
        one("bounces", "default", 1e-2),
        one("bounces", "careful", 1e-2),
    ]
    new = [one("bounces", "default", 1e-3), one("bounces", "default", 1e-1, "failed")]
    assert run.merged(old, new, ("default", "careful")) == [old[0], new[1], new[0], old[2]]


def test_two_coefficients_is_the_motion_of_the_paper():
    mine = BENCHMARK["two-coefficients"].motion
    paper = lw.case("figure-3").simulate()
    assert [t.time for t in mine.transitions[:3]] == [t.time for t in paper.transitions[:3]]


def test_an_adapter_reads_what_is_written(run):
    text = (FOLDER / "adapters" / "adapter.py").read_text(encoding="utf-8")
    fields = re.search(r"class Case:(.*?)@property", text, re.DOTALL)[1]
    written = run.case_file(BENCHMARK["lands"])
    assert list(written) == re.findall(r"^    (\w+): float$", fields, re.MULTILINE)
    assert written["mass"] == 2.0


def test_adapters_are_short_and_say_what_they_are(run):
    found = run.engines()
    assert len(found) == len(list((FOLDER / "adapters").glob("*_adapter.*"))) >= 20
    for engine in found.values():
        text = engine.adapter.read_text(encoding="utf-8")
        assert len(text.splitlines()) <= 150
        assert re.search(r"^(?://! )?(Cannot|Can) express:", text, re.MULTILINE), engine.name
        assert all(setting in text.split("docs: ")[1] for setting in engine.settings), engine.name
        assert (
            engine.said["docs"].startswith("https://")
            or (FOLDER.parents[1] / engine.said["docs"]).exists()
        )


@pytest.mark.parametrize(
    ("line", "other", "message"),
    [
        ("contact: rigid", "", "has no line `contact: …`"),
        ("contact: rigid", "contact: hard", "contact is hard, not events or rigid or compliant"),
        ("numpy==2.4.6", "numpy", "requires numpy, which has no exact version"),
        ("numpy==2.4.6", "git:owner/name@main", "which has no exact version"),
    ],
)
def test_an_adapter_that_does_not_say_what_it_must_is_refused(run, tmp_path, line, other, message):
    text = (FOLDER / "template_adapter.py").read_text(encoding="utf-8")
    path = tmp_path / "mine_adapter.py"
    path.write_text(text.replace(line, other), encoding="utf-8")
    with pytest.raises(SystemExit, match=re.escape(message)):
        run.Engine("mine", path).check()


def test_the_template_runs_as_it_is_and_falls_through_the_plane(run, tmp_path):
    template = FOLDER / "template_adapter.py"
    assert len(template.read_text(encoding="utf-8").splitlines()) <= 40
    run.Engine("template", template).check()
    copy = tmp_path / "mine_adapter.py"
    copy.write_bytes(template.read_bytes())
    (tmp_path / "adapter.py").write_bytes((FOLDER / "adapters" / "adapter.py").read_bytes())
    case, record, log = (tmp_path / "case.json", tmp_path / "record.csv", tmp_path / "log")
    case.write_text(json.dumps(run.case_file(BENCHMARK["lands"])), encoding="utf-8")
    ran = run.run_adapter([sys.executable, str(copy)], case, 1e-2, "default", record, log)
    assert ran["status"] == "scored" and ran["steps"] == 200
    score = run.scored("lands", record, log)
    assert score["missed"] >= 1 and score["penetration"] > 0.1
    # One with an obvious mistake has failed, and says why.
    text = copy.read_text(encoding="utf-8")
    copy.write_text(
        text.replace("case.row(time, x, y, theta, vx, vy, case.theta_rate)", "(time, x, y, theta)"),
        encoding="utf-8",
    )
    assert (
        run.run_adapter([sys.executable, str(copy)], case, 1e-2, "default", record, log)["status"]
        == "scored"
    )
    failed = run.scored("lands", record, log)
    assert failed["status"] == "failed" and "mass centre" in failed["reason"]


def test_what_a_pull_request_touches_is_run(run, monkeypatch):
    changed = (
        "evidence/engines/adapters/pymunk_adapter.py\n"
        "evidence/engines/requirements/rapier/Cargo.lock\ndocs/x.md\n"
    )
    done = subprocess.CompletedProcess([], 0, stdout=changed, stderr="")
    monkeypatch.setattr(run.subprocess, "run", lambda *_, **__: done)
    assert run.changed("main") == ["pymunk", "rapier"]


def test_a_case_beyond_a_limit_is_refused_with_the_number(run, tmp_path):
    """fast turns at 300 rad/s; tiny at 132 rad/s where R is 5 mm, its mass centre at 0.54 m/s."""
    text = (FOLDER / "template_adapter.py").read_text(encoding="utf-8")
    path = tmp_path / "mine_adapter.py"

    def refusal(line, case, step):
        path.write_text(text.replace("docs: ", f"{line}\ndocs: "), encoding="utf-8")
        return run.Engine("mine", path).refusal(case, "default", step)

    assert refusal("limits: turn=100", "fast", 1e-3) == "limit: 100 rad/s, the case reaches 300"
    assert "132" in refusal("limits: turn=100", "tiny", 1e-3)
    assert refusal("limits: turn=100", "rolls", 1e-3) is None
    assert refusal("limits: friction=product", "fast", 1e-3) is None
    assert refusal("limits: turn=1.57/step", "fast", 1e-2).startswith("limit: 157 rad/s")
    assert refusal("limits: turn=1.57/step", "fast", 1e-3) is None
    assert refusal("limits: speed=0.5", "tiny", 1e-3).startswith("limit: 0.5 m/s")
    assert refusal("limits: speed=0.6", "tiny", 1e-3) is None
    # Where R is 10 m in the engine whatever the case, that is 107 R a second.
    assert refusal("limits: speed=0.6 radius=10", "tiny", 1e-3) is not None
    assert refusal("limits: speed=200 radius=10", "tiny", 1e-3) is None
    # Those of another setting say nothing.
    assert refusal("limits careful: turn=100", "fast", 1e-3) is None


def test_an_adapter_has_the_units_of_the_engine(run, tmp_path, monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER / "adapters"))
    import adapter

    path = tmp_path / "case.json"
    path.write_text(json.dumps(run.case_file(BENCHMARK["tiny"])), encoding="utf-8")
    mine, plain = adapter.Case.read(path, True), adapter.Case.read(path, False)
    assert (mine.radius, mine.g) == (0.005, 9.80665) and (plain.radius, plain.g) == (1.0, 1.0)
    assert mine.theta_rate == pytest.approx(88.57) and mine.until == pytest.approx(0.113)
    assert mine.mass == pytest.approx(0.002) and mine.h == pytest.approx(0.0025)
    # The particle has 1 g, the hoop 1 g at its rim: about the mass centre 2 g (R² − h²).
    assert mine.inertia == pytest.approx(0.002 * (0.005**2 - 0.0025**2))
    x, y = mine.mass_centre()
    vx, vy = mine.mass_centre_rates()
    there = mine.row(0.0, x, y, mine.theta, vx, vy, mine.theta_rate)
    rates = (plain.x_rate, plain.gap_rate, plain.theta_rate)
    assert mine.without_dimension(there) == pytest.approx((0.0, 0.0, 1.0, mine.theta, *rates))


def test_a_row_that_moved_is_named(run):
    old = run.read(run.RESULTS)["moreau"]
    assert not [one for one in old if run.moves(old, one)]
    one = next(one for one in old if one["status"] == "scored" and one["error"] > 1e-4)
    assert not run.moves(old, one | {"error": one["error"] * 1.005})
    assert run.moves(old, one | {"error": one["error"] * 1.02})[0].startswith("error ")
    assert run.moves(old, one | {"spurious": one["spurious"] + 1})[0].startswith("spurious ")
    assert run.moves(old, one | {"status": "failed", "reason": "gone"}) == [
        "scored became failed gone"
    ]
    assert run.moves(old, one | {"step": 0.5}) == ["there is no such row"]
    refused = next(one for one in old if one["status"] == "refused")
    assert not run.moves(old, refused | {"step": 0.5})
    assert run.moves(old, one | {"step": 0.5, "status": "refused"}) == ["there is no such row"]


def test_limits_are_those_that_were_measured(run, monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER))
    import probe

    known, rows = run.engines(), run.read_rows(run.RESULTS / "limits.csv")
    assert len({row["engine"] for row in rows}) >= 5
    for row in rows:
        assert not probe.differences(known[row["engine"]], row["setting"], row), row["engine"]


def test_a_probe_tells_a_refusal_from_a_failure(run, monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER))
    import probe

    def refuses(*_, **given):
        """Refuses a second coefficient, rebounds and rolling friction; the rest fails."""
        if {"plane", "restitution", "rolling_resistance"} & set(given):
            return None
        raise probe.FailedError

    found = probe.measured(refuses)
    assert set(found) == set(probe.NAMES)
    assert (found["friction"], found["bounce"], found["rolling"]) == ("pair", "none", "none")
    assert {found[name] for name in ("turn", "own_speed", "damping", "force")} == {"fails"}


def test_what_has_run_is_kept_where_the_rest_is_interrupted(run, tmp_path, monkeypatch):
    ran = next(one for one in run.read(run.RESULTS)["moreau"] if one["status"] == "scored")

    def interrupted(*_):
        yield ran
        raise KeyboardInterrupt

    monkeypatch.setattr(run, "runs", interrupted)
    with pytest.raises(KeyboardInterrupt):
        run.main(["moreau", "--out", str(tmp_path)])
    assert run.read(tmp_path)["moreau"] == [ran]
    assert [row["engine"] for row in run.read_rows(tmp_path / "machines.csv")] == ["moreau"]


def test_an_environment_that_is_gone_is_made_again(run, tmp_path, monkeypatch):
    engine, made = run.engines()["pymunk"], []
    monkeypatch.setattr(run, "ENVIRONMENTS", tmp_path)
    monkeypatch.setattr(run, "make", lambda folder, _: made.append(folder.mkdir()))
    for count in (1, 1):
        run.prepared(engine)
        assert len(made) == count
    (tmp_path / "pymunk").rmdir()
    run.prepared(engine)
    assert len(made) == 2


def test_outcomes_without_a_record(run):
    assert run.outcome(None, "")["status"] == "timeout"
    assert run.outcome(run.REFUSED, "one\nthe engine has one coefficient\n") == {
        "status": "refused",
        "reason": "the engine has one coefficient",
    }
    assert run.outcome(1, "")["status"] == "failed"


def test_scores_are_kept_with_four_digits(run):
    assert run.rounded({"a": [math.pi, None, "word"], "b": 3}) == {
        "a": [3.142, None, "word"],
        "b": 3,
    }
    event = {"kind": "slip", "exact": 1.0, "read": 1.25, "found": 1.5}
    assert run.event_of(run.event_text(event)) == event | {"error": 0.25}
    assert run.event_of(run.event_text(event | {"read": None, "found": None}))["error"] is None


def test_the_results_are_of_the_cases_and_have_no_path(run):
    every, known = run.read(run.RESULTS), run.engines()
    assert (
        set(every)
        == {row["engine"] for row in run.read_rows(run.RESULTS / "machines.csv")}
        <= set(known)
    )
    assert len(every) >= 20
    for name, runs in every.items():
        assert {one["setting"] for one in runs} <= set(known[name].settings)
        assert {one["case"] for one in runs} <= set(BENCHMARK), name
        assert any(one["status"] == "scored" for one in runs), name
    texts = [path.read_text(encoding="utf-8") for path in run.RESULTS.iterdir()]
    assert not any(re.search(r"/(work|home|tmp|usr|root)/", text) for text in texts)
    rows = run.read_rows(run.RESULTS / "gradients.csv")
    assert len({row["engine"] for row in rows if row["status"] == "scored"}) >= 3


def test_the_results_are_written_as_they_are_read(run, tmp_path):
    for name, runs in run.read(run.RESULTS).items():
        run.write(tmp_path, name, runs)
        assert (tmp_path / f"{name}.csv").read_bytes() == (run.RESULTS / f"{name}.csv").read_bytes()


def test_the_page_has_the_results(run, monkeypatch):
    monkeypatch.syspath_prepend(str(FOLDER))
    import report

    page = report.PAGE.read_text(encoding="utf-8")
    every, runs = run.engines(), run.read(run.RESULTS)
    tables = [report.summary(every, runs), report.gradients(every), report.settings(every, runs)]
    tables += [report.limits(every), report.rolling(every)]
    for name in report.CATEGORIES:
        tables += [report.listed(name), report.category(name, every, runs)]
    for rows in tables:
        assert "\n".join(rows) in page
