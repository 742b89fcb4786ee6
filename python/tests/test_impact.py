"""What follows the landing: the numbers of the notes, both sides of each jump, what is refused."""

import dataclasses
import math
import pickle

import numpy as np
import pytest
from conftest import RESISTANCE, flags, resisted_hoop

import littlewood as lw

START = {"theta": math.pi / 2, "theta_rate": 2.0}
GOOD = {"mass_ratio": 1.0, "offset": 1.0, "inertia": 1.0, "mu_s": 0.5, "mu_k": 0.4}
LAWS = lw.tables.RESTITUTION_LAWS


def bouncing(hoop, e, law=None):
    return dataclasses.replace(hoop, restitution=e, restitution_law=law)


def landing(motion):
    return next(one for one in motion.transitions if one.cause == "landing")


# Figure 3, from the closed form of the impact at 40 digits: case, mode that follows, θ′, η′ and the
# rate of the gap after, energy lost.
FIGURE_3 = {
    0.0: (
        "slides",
        "sliding",
        1.989854986135947259,
        -0.025733797279415870,
        0.0,
        4.27572946865290831,
    ),
    0.5: (
        "sticks_in_restitution",
        "flight",
        1.803947379026181191,
        0.0,
        0.978517419970790811,
        3.36244341922728,
    ),
}


@pytest.mark.parametrize("e", FIGURE_3)
def test_the_landing_of_figure_3(e, hoop):
    case, to, *after, lost = FIGURE_3[e]
    event = landing(bouncing(hoop, e).simulate(**START))
    impact = event.impact
    assert event.time == pytest.approx(3.847395556686894, abs=1e-12)
    assert impact.before.slip == pytest.approx(-0.785244687128996169, abs=1e-12)
    assert impact.before.gap_rate == pytest.approx(-1.913012569038374656, abs=1e-12)
    assert (impact.case, event.to_mode) == (case, to)
    assert impact.after == pytest.approx(after, abs=1e-12)
    assert impact.energy_lost == pytest.approx(lost, abs=1e-12)
    # The impulses change the velocities by the compliances at the contact point.
    a, b, c = 0.704169493845475073, -0.0829493464295526, 0.533700402266253778
    normal, friction = impact.impulse
    assert a * friction + b * normal == pytest.approx(
        impact.after.slip - impact.before.slip, abs=1e-12
    )
    assert b * friction + c * normal == pytest.approx(
        impact.after.gap_rate - impact.before.gap_rate, abs=1e-12
    )


def test_an_impact_with_rolling_resistance_has_the_work_of_its_couple():
    # The hoop jams as it rolls, and the impact leaves it at rest.
    reference = next(
        one
        for one in RESISTANCE
        if one["family"] == "jams_of_rolling" and len(one["transitions"]) == 1
    )
    motion = resisted_hoop(reference).simulate(**reference["start"])
    (event,) = motion.transitions
    assert (event.cause, event.to_mode, motion.outcome.kind) == ("jam", "rest", "rests")
    lost = {name: float(value) for name, value in reference["lost"].items()}
    impact = event.impact
    assert -impact.resistance_work == pytest.approx(lost["resistance"], abs=1e-13)
    assert -(impact.normal_work + impact.friction_work) == pytest.approx(
        lost["sliding"] + lost["restitution"], abs=1e-13
    )
    assert impact.energy_lost == pytest.approx(sum(lost.values()), abs=1e-13)
    # It is lost in an impact, not to the resistance of a phase.
    assert motion.rolling_resistance_energy_lost == 0.0
    assert motion.impact_energy_lost == impact.energy_lost


def test_figure_3_settles(hoop):
    motion = bouncing(hoop, 0.5).simulate(**START)
    event = motion.transitions[-1]
    assert (event.cause, event.from_mode, event.to_mode) == ("settle", "flight", "rolling")
    state = event.after
    expected = (6.92468208301851365, 15.4568461360609139, 2.20041054290320475, 0.0)
    assert (state.time, state.theta, state.theta_rate, state.slip) == pytest.approx(
        expected, abs=1e-12
    )
    rolls = motion(event.time)
    # The notes have ten and four digits of these.
    assert rolls.normal == pytest.approx(6.515077719, abs=1e-9)
    assert abs(rolls.friction) / rolls.normal == pytest.approx(0.07326, abs=1e-5)
    # The effective coefficient of restitution, from one of the last bounces to the next.
    last = motion.impacts().gap_rate_after.iloc[-4:-1].to_numpy()
    assert last[1:] / last[:-1] == pytest.approx(0.492024505882643, abs=1e-6)


def rows_of(motion):
    """The rows of the table of a motion as it is printed."""
    lines = str(motion).splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("─")) + 1
    return lines[first : lines.index("", first)]


def test_the_jam_of_the_notes():
    case = lw.case("jam")
    without = dataclasses.replace(case.hoop, restitution=None, restitution_law=None).simulate(
        **vars(case.start)
    )
    assert without.outcome.kind == "inconsistent"
    assert without.outcome.details["solvability_positive"] == pytest.approx(
        -0.199638284830513, abs=1e-12
    )
    motion = case.simulate()
    event = motion.transitions[0]
    assert (event.from_mode, event.cause, event.impact.case, event.time) == (
        None,
        "jam",
        "jams",
        0.0,
    )
    assert event.after.theta_rate == -1.0
    assert event.after.slip == 0.0
    # It ends no phase: the first one ends by the next transition.
    assert motion.end_of(motion.phases[0]) is motion.transitions[1]
    assert [motion.end_of(phase) for phase in motion.phases] == [*motion.transitions[1:], None]
    assert rows_of(motion)[0].split()[:2] == ["jam", "0"]


def test_both_sides_of_a_jump(hoop):
    for motion in (bouncing(hoop, 0.5).simulate(**START), lw.case("two-hops").simulate()):
        # Where bounces are as short as the distance of doubles, one time is that of several.
        events = [one for one in motion.transitions if one.impact is not None][:6]
        times = np.array([one.time for one in events])
        before, after = motion(times, side="before"), motion(times)
        assert np.array_equal(motion(times, side="after").theta_rate, after.theta_rate)
        for k, event in enumerate(events):
            for samples, velocities in ((before, event.impact.before), (after, event.impact.after)):
                for name in ("theta_rate", "slip"):
                    assert samples[name][k] == getattr(velocities, name)
                assert samples.gap_rate[k] == pytest.approx(velocities.gap_rate, abs=1e-13)
            assert before.mode_names[k] == event.from_mode
            assert after.mode_names[k] == event.to_mode
            assert before.theta[k] == after.theta[k]
            # The energy of the samples knows nothing of the works of the impulses.
            assert before.energy[k] - after.energy[k] == pytest.approx(
                event.impact.energy_lost, abs=1e-12
            )
        samples = motion.sample(11)
        for event in events:
            two = np.flatnonzero(samples.time == event.time)
            assert samples.theta_rate[two].tolist() == [
                event.state.theta_rate,
                event.after.theta_rate,
            ]


def test_sides_where_nothing_jumps(hoop):
    motion = hoop.simulate(**START)
    times = np.linspace(-0.5, 4.0, 19)
    before, after = motion(times, side="before"), motion(times)
    for name in after:
        np.testing.assert_array_equal(before[name], after[name])
    stick, slip = motion.transitions[:2]
    assert motion([stick.time, slip.time], side="before").mode_names.tolist() == [
        "sliding",
        "rolling",
    ]
    # Start and end have one side.
    ends = [motion.start.time, motion.end_time]
    assert motion(ends, side="before").mode_names.tolist() == motion(ends).mode_names.tolist()
    assert motion([math.inf, math.nan], side="before")["mode"].tolist() == [-1, -1]
    forever = lw.case("figure-2-libration").simulate()
    assert forever([math.inf, 5.0], side="before")["mode"].tolist() == [-1, 0]
    with pytest.raises(ValueError, match="side = 'left' must be"):
        motion(0.0, side="left")


def test_before_a_jam_there_is_no_mode():
    motion = lw.case("jam").simulate()
    before, after = motion(0.0, side="before"), motion(0.0)
    assert (before.mode_names, after.mode_names) == ("", "rolling")
    assert (before.theta_rate, before.slip) == (-0.5, 1.0)
    assert math.isnan(before.normal)
    samples = motion.sample(5)
    assert samples.mode_names[:2].tolist() == ["", "rolling"]
    assert samples.theta_rate[:2].tolist() == [-0.5, -1.0]


def test_impacts_are_a_table(hoop):
    motion = bouncing(hoop, 0.5).simulate(**START)
    table = motion.impacts()
    events = [(i, one) for i, one in enumerate(motion.transitions) if one.impact is not None]
    assert table.index.name == "transition"
    assert table.index.tolist() == [i for i, _ in events]
    for i, event in events:
        row = table.loc[i]
        assert (row.time, row.theta, row.cause, row["case"], row["to"]) == (
            event.time,
            event.state.theta,
            event.cause,
            event.impact.case,
            event.to_mode,
        )
        for side in ("before", "after"):
            for name, value in getattr(event.impact, side)._asdict().items():
                assert row[f"{name}_{side}"] == value
        assert (row.normal_impulse, row.friction_impulse) == event.impact.impulse
        assert row.energy_lost == event.impact.energy_lost
    assert list(table["case"].cat.categories) == list(lw.tables.IMPACT_CASES)
    assert table.energy_lost.sum() == pytest.approx(motion.impact_energy_lost, abs=1e-14)
    # A motion that ends at its landing has the same columns and no rows.
    empty = hoop.simulate(**START).impacts()
    assert list(empty.columns) == list(table.columns)
    assert len(empty) == 0
    assert dict(empty.dtypes) == dict(table.dtypes)


def test_energies_add_up(hoop):
    for law in LAWS:
        motion = bouncing(hoop, 0.5, law).simulate(**START)
        samples = motion.sample(11)
        assert samples.energy[0] - samples.energy[-1] == pytest.approx(
            motion.energy_lost, abs=1e-12
        )
        slides = sum(phase.energy_lost for phase in motion.phases)
        assert motion.energy_lost - motion.impact_energy_lost == pytest.approx(slides, abs=1e-12)


def test_only_newtons_law_gains_energy():
    random = np.random.default_rng(1991)
    gains = dict.fromkeys(LAWS, 0)
    for _ in range(200):
        mu = float(random.uniform(0.1, 1.5))
        hoop = lw.Hoop(
            mass_ratio=random.uniform(0, 0.3),
            offset=1,
            inertia=random.uniform(0.01, 0.3),
            mu_s=mu,
            mu_k=mu,
        )
        start = {
            "theta": random.uniform(-3, 3),
            "theta_rate": random.uniform(-4, 4),
            "slip": random.uniform(-2, 2),
            "gap_rate": 1.0,
        }
        for law in LAWS:
            motion = bouncing(hoop, 0.9, law).simulate(**start, max_transitions=2)
            event = motion.transitions[0]
            assert (event.cause, event.to_mode) == ("landing", "flight")
            change = motion(event.time, side="before").energy - motion(event.time).energy
            assert change == pytest.approx(event.impact.energy_lost, abs=1e-10)
            gains[law] += event.impact.gains_energy
    assert gains["energetic"] == gains["poisson"] == 0
    assert gains["newton"] > 0


def test_a_law_alone_is_named_and_a_coefficient_alone_is_energetic(hoop):
    assert hoop.restitution is hoop.restitution_law is None
    assert bouncing(hoop, 0.5).restitution_law == "energetic"
    assert bouncing(hoop, 0.5) == bouncing(hoop, 0.5, "energetic")
    newton = bouncing(hoop, 1, "newton")
    assert pickle.loads(pickle.dumps(newton)) == newton == eval(repr(newton), {"Hoop": lw.Hoop})
    assert isinstance(newton.restitution, float)
    motion = newton.simulate(**START, until=20.0)
    assert pickle.loads(pickle.dumps(motion)).transitions == motion.transitions
    assert motion.to_xarray().attrs["restitution_law"] == "newton"
    assert motion.to_xarray().attrs["restitution"] == 1.0
    assert not {"restitution", "restitution_law"} & set(hoop.simulate(**START).to_xarray().attrs)


@pytest.mark.parametrize(
    ("change", "quantity"),
    [
        ({"restitution": -0.1}, "restitution"),
        ({"restitution": 1.5}, "restitution"),
        ({"restitution": math.nan}, "restitution"),
        ({"restitution": math.inf}, "restitution"),
        ({"restitution_law": "newton"}, "restitution"),
        ({"restitution": 0.5, "mass_ratio": 0.0, "inertia": 0.0}, "restitution"),
        ({"restitution": 1.5, "mass_ratio": 0.0, "inertia": 0.0}, "restitution"),
    ],
)
def test_a_bad_restitution_is_refused_in_the_words_of_the_command_line(change, quantity, command):
    with pytest.raises(lw.ParameterError) as caught:
        lw.Hoop(**{**GOOD, **change})
    assert caught.value.quantity == quantity
    done = command("simulate", *flags(**{**GOOD, **change}, theta=1.0, theta_rate=0.0))
    assert done.returncode == 2
    said = " ".join(done.stderr.replace("│", " ").split())
    assert str(caught.value) in said
    assert caught.value.hint in said
    # So are sweeps, before anything is computed.
    with pytest.raises(lw.ParameterError) as again:
        lw.simulate_many(**{**GOOD, **change}, theta=[1.0, 2.0], theta_rate=0.0)
    assert str(again.value) == str(caught.value)


def test_an_unknown_law_is_refused_with_the_names(hoop):
    with pytest.raises(
        lw.ParameterError, match="'elastic'; there are energetic, poisson, newton"
    ) as caught:
        bouncing(hoop, 0.5, "elastic")
    assert (caught.value.quantity, caught.value.hint) == (
        "restitution_law",
        "leave it out for the energetic law",
    )
    with pytest.raises(lw.ParameterError, match="'elastic'"):
        lw.simulate_many(
            hoop, restitution=0.5, restitution_law="elastic", theta=[0.0], theta_rate=1.0
        )
    with pytest.raises(TypeError):
        bouncing(hoop, 0.5, 1)
    with pytest.raises(TypeError):
        lw.Hoop(**{**GOOD, "mu_s": None})


@pytest.mark.parametrize("gap_rate", [-0.5, math.nan, 1e7])
def test_a_bad_rate_of_the_gap_is_refused_in_the_words_of_the_command_line(gap_rate, hoop, command):
    with pytest.raises(lw.ParameterError) as caught:
        hoop.simulate(**START, gap_rate=gap_rate)
    assert caught.value.quantity == "gap_rate"
    done = command("simulate", *flags(**GOOD, **START, gap_rate=gap_rate))
    assert done.returncode == 2
    assert str(caught.value) in " ".join(done.stderr.replace("│", " ").split())


def test_a_massless_hoop_is_not_thrown():
    massless = lw.case("figure-7").hoop
    with pytest.raises(lw.ParameterError, match="massless hoop") as caught:
        massless.simulate(theta=0.5, theta_rate=0.0, gap_rate=1.0)
    assert caught.value.quantity == "gap_rate"
    assert "moment of inertia" in caught.value.hint


def test_a_hoop_thrown_upwards_is_in_flight(hoop):
    # A balanced hoop is a ball: it comes down after 2v, and its bounces are done after 2v/(1 − e).
    ball = lw.Hoop(mass_ratio=1, offset=0, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0.5)
    motion = ball.simulate(theta=0.0, theta_rate=0.0, gap_rate=1.5)
    assert motion.start.gap_rate == 1.5
    assert motion.transitions[0].time == pytest.approx(3.0, abs=1e-14)
    assert motion.transitions[-1].time == pytest.approx(6.0, abs=1e-13)
    assert float(motion(1.5).gap) == pytest.approx(1.125, abs=1e-14)
    assert hoop.classify(theta=1.0, theta_rate=0.5, gap_rate=0.5).mode == "flight"
    si = lw.Hoop.from_si(
        disc_mass_kg=0.4,
        particle_mass_kg=0.14,
        radius_m=0.45,
        offset_m=0.0,
        inertia_kg_m2=0.081,
        mu_s=0.5,
        mu_k=0.4,
        restitution=0.25,
        restitution_law="poisson",
    )
    assert (si.restitution, si.restitution_law) == (0.25, "poisson")
    motion = si.simulate_si(theta_rad=0.0, theta_rate_rad_per_s=0.0, gap_rate_m_per_s=2.0)
    first = motion.transitions[0].time * si.units.time_s
    assert first == pytest.approx(2 * 2.0 / lw.hoop.STANDARD_GRAVITY, rel=1e-14)


def test_motions_that_bounce_for_ever(hoop):
    ball = bouncing(hoop, 1.0)
    for angle in (0.5, 1.0, 1.6, 2.2):
        orbit = ball.bouncing_orbit(angle)
        # Each flight is symmetric: the gap closes as fast as it has opened.
        h, sin = hoop.h, math.sin(angle)
        assert orbit.gap_rate == pytest.approx(
            angle / orbit.top_rate - h * sin * orbit.top_rate, abs=1e-13
        )
        rest = math.pi - angle
        assert orbit.gap_rate == pytest.approx(
            rest / orbit.bottom_rate + h * sin * orbit.bottom_rate, abs=1e-13
        )
        assert orbit.period == pytest.approx(
            2 * (angle / orbit.top_rate + rest / orbit.bottom_rate), abs=1e-13
        )
        if orbit.friction < hoop.mu_s:
            motion = ball.simulate(**vars(orbit.start), until=4.0 * orbit.period)
            assert {one.impact.case for one in motion.transitions} == {"sticks_in_compression"}
            state = motion(np.arange(4) * orbit.period * (1 + 1e-15))
            assert state.theta - 2 * math.pi * np.arange(4) == pytest.approx(-angle, abs=1e-10)
            assert motion.impact_energy_lost == pytest.approx(0.0, abs=1e-11)
    assert ball.bouncing_orbit(0.0) is None
    assert lw.case("figure-7").hoop.bouncing_orbit(1.0) is None
    start = lw.case("bounces-forever").start
    orbit = ball.bouncing_orbit(-start.theta)
    for name in ("theta", "theta_rate", "gap_rate"):
        assert getattr(orbit.start, name) == pytest.approx(getattr(start, name), abs=1e-12)


def test_named_cases_go_on():
    assert lw.case("lands-and-rolls").simulate().sequence == "+FR"
    assert lw.case("two-hops").simulate().sequence == "-R+FR+FR"
    assert lw.case("figure-3-bounces").hoop.restitution_law == "energetic"
    assert lw.case("bounces-forever").simulate(until=30.0).outcome.kind == "time_limit"
    assert lw.case("figure-3").hoop.restitution is None


def test_many_bounces_share_a_row(hoop):
    motion = bouncing(hoop, 0.5).simulate(**START)
    rows = rows_of(motion)
    (row,) = [row for row in rows if "bounces" in row]
    # After four flights one by one, those up to the end of settling.
    begin, end = 8, len(motion.phases) - 1
    assert row.split()[:3] == [f"{begin}…", f"{end - begin + 1}", "bounces"]
    assert row.endswith("settles")
    order = [row.split()[0] for row in rows if "impact" not in row]
    assert order == [*"1234567", f"{begin}…", f"{end + 1}"]
    told = [float(row.split()[5]) for row in rows if "impact" in row] + [float(row.split()[8])]
    assert sum(told) == pytest.approx(motion.impact_energy_lost, abs=5e-5)
    page = motion._repr_html_()
    assert page.count("<tr") == 1 + len(rows)
    assert "e = 0.5 (energetic)" in page
    assert (
        "gap′ = 1" in bouncing(hoop, 0.5).simulate(**START, gap_rate=1.0, until=1.0)._repr_html_()
    )
