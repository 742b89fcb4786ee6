"""The scorer finds errors that were planted, and says how large they are."""

import json
import math
import subprocess
from pathlib import Path

import numpy as np
import pytest

import littlewood as lw
from littlewood._commands.score import main
from littlewood.certify.checker import digest
from littlewood.certify.compare import simulated
from littlewood.scoring.cases import CATEGORIES
from littlewood.scoring.episodes import Event
from littlewood.scoring.matching import match

STEP = 1e-3
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def motion():
    """Slides, sticks, rolls, slips, lifts off, lands."""
    return lw.case("figure-3").simulate()


@pytest.fixture(scope="module")
def instants(motion):
    return np.arange(0.0, motion.end_time, STEP)


@pytest.fixture(scope="module")
def columns(motion, instants):
    samples = motion(instants)
    return {"x": samples.x, "y": samples.centre_y, "theta": samples.theta}


def scored(motion, instants, columns, **changed):
    return lw.scoring.score(motion, lw.scoring.Record(instants, **{**columns, **changed}))


def times(motion):
    return {transition.cause: transition.time for transition in motion.transitions}


def test_the_exact_motion_has_no_error(motion, instants, columns):
    score = scored(motion, instants, columns)
    assert [event.kind for event in score.events] == [
        "slip",
        "stick",
        "slip",
        "lift_off",
        "landing",
    ]
    assert not score.missed and not score.spurious
    # A line through velocities, and through heights, leaves out the second order of the step.
    assert max(abs(event.error) for event in score.events) < 5.0 * STEP**2
    assert score.largest_error == score.energy_gained == score.penetration == 0.0
    assert score.slip_while_rolling < 1e-14


def test_the_events_are_those_of_the_motion(motion, instants, columns):
    score = scored(motion, instants, columns)
    exact = times(motion)
    # The first slip is only read: the hoop starts to slide.
    assert score.events[0].verdict == "artefact" and score.events[0].exact is None
    for event in score.events[1:]:
        assert event.exact == exact[event.kind]
        # The limits of slip velocity and height shift where they are read, a lift-off the most: the
        # gap begins with τ³.
        assert abs(event.read - event.exact) < (0.15 if event.kind == "lift_off" else 0.03)
        assert event.error == event.found - event.read


@pytest.mark.parametrize("late", [0.02, 0.1])
def test_events_that_come_late_are_found_and_sized(motion, instants, columns, late):
    stick = times(motion)["stick"]
    warped = np.where(instants < stick + 0.05, instants, np.maximum(stick + 0.05, instants - late))
    samples = motion(warped)
    score = scored(
        motion, instants, {"x": samples.x, "y": samples.centre_y, "theta": samples.theta}
    )
    errors = {event.kind: event.error for event in score.events[2:] if event.error is not None}
    assert errors["slip"] == pytest.approx(late, abs=1e-4)
    assert errors["lift_off"] == pytest.approx(late, abs=1e-4)


def test_a_missed_stick_is_found_and_its_slip_measured(motion, instants, columns):
    stick, slip = times(motion)["stick"], times(motion)["slip"]
    creep = 0.05 * np.maximum(instants - stick + 0.2, 0.0)
    score = scored(motion, instants, columns, x=columns["x"] - creep)
    assert [event.kind for event in score.missed] == ["stick"]
    # It comes to rest where the hoop slips, for a moment.
    assert [event.kind for event in score.spurious] == ["stick"] and 0.0 < score.spurious[
        0
    ].found - slip < 0.1
    assert score.slip_while_rolling == pytest.approx(0.05 * (slip - stick), rel=0.01)
    assert score.largest_error == pytest.approx(creep[-1], rel=1e-12)


def test_a_lift_off_that_is_none_and_a_rim_in_the_plane_are_found(motion, instants, columns):
    stick = times(motion)["stick"]
    bump = 0.01 * np.where(
        np.abs(instants - stick - 0.2) < 0.1, np.cos(5.0 * np.pi * (instants - stick - 0.2)), 0.0
    )
    score = scored(motion, instants, columns, y=columns["y"] + bump)
    assert [event.kind for event in score.spurious][:1] == ["lift_off"] and not score.missed
    assert abs(score.spurious[0].found - (stick + 0.1)) < 0.02
    score = scored(
        motion, instants, columns, y=columns["y"] - 0.004 * np.exp(-((instants - 0.3) ** 2))
    )
    assert score.penetration == pytest.approx(0.004, rel=1e-5) and not score.spurious


def test_energy_that_is_gained_is_sized(motion, instants, columns):
    lift_off = times(motion)["lift_off"]
    push = 0.1
    score = scored(
        motion, instants, columns, x=columns["x"] + push * np.maximum(instants - lift_off, 0.0)
    )
    # In flight the mass centre keeps its horizontal velocity v: m ((v + push)² − v²)/2.
    centre = motion(np.array([lift_off + 0.5, lift_off + 1.5])).mass_centre_x
    velocity = float(np.diff(centre)[0])
    expected = motion.hoop.mass * (velocity * push + 0.5 * push**2)
    assert score.energy_error[-1] == pytest.approx(expected, rel=1e-6)
    assert score.energy_gained == pytest.approx(max(expected, 0.0), rel=1e-6)


def test_errors_are_told_from_event_to_event(motion, instants, columns):
    lift_off = times(motion)["lift_off"]
    score = scored(
        motion, instants, columns, theta=columns["theta"] + 0.01 * (instants > lift_off + 0.2)
    )
    errors = [error for _, _, error in score.between]
    assert errors[:-1] == [0.0] * (len(errors) - 1) or errors[-1] == pytest.approx(0.01)
    assert score.between[0][0] == 0.0 and score.between[-1][1] == instants[-1]
    assert all(a[1] == b[0] for a, b in zip(score.between[:-1], score.between[1:], strict=True))


def test_bounces_are_impacts(columns):
    motion = lw.case("figure-3-bounces").simulate()
    instants = np.arange(0.0, 5.0, STEP)
    samples = motion(instants)
    record = lw.scoring.Record(instants, samples.x, samples.centre_y, samples.theta)
    (impact,) = [
        event for event in lw.scoring.score(motion, record).events if event.kind == "impact"
    ]
    landing = next(one.time for one in motion.transitions if one.impact is not None)
    # The hoop is lower than the limit for two thousandths after it.
    assert abs(impact.exact - landing) < 2e-3 and abs(impact.error) < 1e-5
    # Steps so long that no instant is near the plane: the lines before and behind meet there.
    coarse = slice(None, None, 37)
    record = lw.scoring.Record(
        instants[coarse], samples.x[coarse], samples.centre_y[coarse], samples.theta[coarse]
    )
    (impact,) = [
        event for event in lw.scoring.score(motion, record).events if event.kind == "impact"
    ]
    assert abs(impact.found - landing) < 37 * STEP


def test_a_landing_that_sticks_is_one_event():
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.5, restitution=0.0)
    motion = hoop.simulate(theta=math.pi / 2, theta_rate=2.0, until=5.0)
    for step in (1e-2, 1e-3, 1e-4):
        instants = np.arange(0.0, 5.0, step)
        samples = motion(instants)
        score = lw.scoring.score(
            motion, lw.scoring.Record(instants, samples.x, samples.centre_y, samples.theta)
        )
        assert score.events[-1].kind == "landing" and not score.missed and not score.spurious


@pytest.mark.parametrize("end", [5.0, None])
def test_flags_of_contact_are_believed(motion, instants, columns, end):
    samples = motion(instants)
    if end is None:
        record = lw.scoring.Record(instants, **columns, contact=~samples.is_in("flight"))
        score = lw.scoring.score(motion, record)
        # The landing is the end of the motion, behind the last row.
        assert score.events[-1].verdict == "cut"
        (lift_off,) = [event for event in score.events if event.kind == "lift_off"]
    else:
        later = np.arange(0.0, end, STEP)
        lands = lw.scoring.CASES["two-coefficients"].motion
        samples = lands(later)
        record = lw.scoring.Record(
            later, samples.x, samples.centre_y, samples.theta, ~samples.is_in("flight")
        )
        score = lw.scoring.score(motion, record)
        lift_off, landing = score.events[-2:]
        assert landing.error == 0.0 and landing.found == pytest.approx(motion.end_time, abs=STEP)
    assert lift_off.error == 0.0 and lift_off.found == pytest.approx(
        times(motion)["lift_off"], abs=STEP
    )
    assert not score.missed and not score.spurious


@pytest.mark.parametrize(("late", "verdict"), [(0.02, "cut"), (-0.02, "found")])
def test_a_landing_at_the_end_of_a_record_is_not_missed(motion, late, verdict):
    """The record stops where the exact motion does.

    A late landing cannot be in it, an early one is.
    """
    end = motion.end_time
    instants = np.append(np.arange(0.0, end, STEP), end)
    flies = np.maximum(instants - late, 0.0)
    samples = motion(np.minimum(np.where(instants > 3.0, flies, instants), end))
    record = lw.scoring.Record(instants, samples.x, samples.centre_y, samples.theta)
    score = lw.scoring.score(motion, record)
    landing = score.events[-1]
    assert landing.kind == "landing" and landing.exact == end and landing.verdict == verdict
    assert not score.missed and not score.spurious
    # With rows behind the end the late one is found, and sized.
    instants = np.append(instants, end + np.arange(1, 50) * STEP)
    samples = motion(np.minimum(np.where(instants > 3.0, instants - late, instants), end))
    score = lw.scoring.score(
        motion, lw.scoring.Record(instants, samples.x, samples.centre_y, samples.theta)
    )
    assert (
        score.events[-1].error == pytest.approx(late, abs=2e-5)
        and not score.missed
        and not score.spurious
    )


@pytest.mark.parametrize("step", [0.05, 1e-2, 1e-3])
@pytest.mark.parametrize("flags", [False, True])
def test_the_exact_motion_is_never_blamed(step, flags):
    """A motion of each family, sampled and read: the floor of the reading."""
    families = {one.given["family"]: one.motion for one in lw.scoring.CASES.values()}
    verdicts = set()
    for motion in families.values():
        instants = np.arange(0.0, min(motion.end_time, 4.0), step)
        if instants.size < 4:
            continue
        samples = motion(instants)
        contact = ~samples.is_in("flight") if flags else None
        record = lw.scoring.Record(instants, samples.x, samples.centre_y, samples.theta, contact)
        score = lw.scoring.score(motion, record)
        assert not score.missed and not score.spurious and not score.doubts
        assert all(event.error in (None, 0.0) for event in score.events if event.read is not None)
        assert score.energy_gained < 1e-12
        verdicts |= {event.verdict for event in score.events}
    assert verdicts == {"found", "unreadable", "cut", "artefact"}


def test_a_coarse_record_says_what_can_not_be_read(motion):
    verdicts = [
        (event.kind, event.verdict) for event in scored(motion, *sampled(motion, 0.3)).events
    ]
    # The hoop rolls for less than two rows.
    assert verdicts[1:] == [
        ("stick", "unreadable"),
        ("slip", "unreadable"),
        ("lift_off", "found"),
        ("landing", "cut"),
    ]


def sampled(motion, step):
    instants = np.arange(0.0, motion.end_time, step)
    samples = motion(instants)
    return instants, {"x": samples.x, "y": samples.centre_y, "theta": samples.theta}


def test_bounces_are_impacts_as_long_as_they_can_be_read_and_then_they_settle():
    motion = lw.scoring.CASES["settles-sticking-04"].motion
    instants = np.arange(0.0, 4.0, STEP)
    samples = motion(instants)
    record = lw.scoring.Record(instants, samples.x, samples.centre_y, samples.theta)
    score = lw.scoring.score(motion, record)
    found = [event for event in score.events if event.verdict == "found"]
    impact, settle, *_ = found
    assert (impact.kind, settle.kind) == ("impact", "settle")
    first, last = (
        motion.transitions[0],
        next(one for one in motion.transitions if one.cause == "settle"),
    )
    assert impact.exact == first.time and abs(impact.read - first.time) < 5e-3
    # The last bounces are lower than what counts as contact.
    assert settle.exact == last.time and -0.2 < settle.read - last.time < 0.0


def test_velocities_are_used_if_given():
    """The energy is that of the velocities, not of differences of the positions."""
    motion = lw.scoring.BENCHMARK["lands"].motion
    instants = np.arange(0.0, 2.0, 0.01)
    samples = motion(instants)
    rates = samples.slip - samples.theta_rate, samples.gap_rate, samples.theta_rate
    place = samples.x, samples.centre_y, samples.theta
    score = lw.scoring.score(motion, lw.scoring.Record(instants, *place, None, *rates))
    assert score.energy_error.size == instants.size and np.max(np.abs(score.energy_error)) < 1e-13
    faster = lw.scoring.Record(instants, *place, None, rates[0], rates[1], rates[2] + 0.1)
    exact = samples.energy
    spins = lw.scoring.score(motion, faster).energy_error
    hoop = motion.hoop
    sin, cos = np.sin(place[2]), np.cos(place[2])
    moved = rates[0] - hoop.h * cos * faster.theta_rate, rates[1] - hoop.h * sin * faster.theta_rate
    kinetic = (
        hoop.mass * (moved[0] ** 2 + moved[1] ** 2)
        + hoop.inertia_about_mass_centre * faster.theta_rate**2
    )
    expected = 0.5 * kinetic + hoop.mass * (place[1] - 1.0 + hoop.h * cos) - exact
    assert spins[1] == pytest.approx(expected[1], rel=1e-9)
    with pytest.raises(ValueError, match="x_rate without the others"):
        lw.scoring.Record(instants, *place, None, rates[0])


@pytest.mark.parametrize("begins_with_start", [True, False])
def test_a_jam_at_the_start_is_before_or_in_the_first_row(begins_with_start):
    """Both sides of the jam are exact at that instant: neither is charged with an event."""
    motion = lw.scoring.BENCHMARK["jam-16"].motion
    instants = np.arange(0.0, 1.5, STEP)
    samples = motion(instants)
    slip, theta_rate = np.array(samples.slip), np.array(samples.theta_rate)
    assert (slip[0], theta_rate[0]) == (0.0, pytest.approx(-1.145))
    if begins_with_start:
        slip[0], theta_rate[0] = 0.89, -0.7
    place = samples.x, samples.centre_y, samples.theta
    rates = slip - theta_rate, samples.gap_rate, theta_rate
    score = lw.scoring.score(motion, lw.scoring.Record(instants, *place, None, *rates))
    assert not score.missed and not score.spurious
    jam = next(event for event in score.events if event.kind == "jam")
    assert jam.verdict == ("found" if begins_with_start else "unreadable")
    assert np.max(np.abs(score.energy_error)) < 1e-14
    if begins_with_start:
        # The hoop slides on the other way. One that is slightly faster is seen to do so at once.
        faster = slip - np.where(instants > 0.0, 0.02, 0.0)
        rates = faster - theta_rate, samples.gap_rate, theta_rate
        score = lw.scoring.score(motion, lw.scoring.Record(instants, *place, None, *rates))
        assert not score.missed and not score.spurious
        jam = next(event for event in score.events if event.kind == "jam")
        assert jam.verdict == "found" and 0.0 < jam.found < 3.0 * STEP


def test_rates_that_contradict_the_positions_are_told_by_their_size():
    """Positions that go with a rate of their step are no contradiction, a slow turn is one."""
    motion = lw.scoring.BENCHMARK["lands"].motion
    instants = np.arange(0.0, 2.0, 1e-3)
    samples = motion(instants)
    place = {"x": samples.x, "y": samples.centre_y, "theta": samples.theta}
    rates = {
        "x_rate": samples.slip - samples.theta_rate,
        "y_rate": samples.gap_rate,
        "theta_rate": samples.theta_rate,
    }

    def score(**changed):
        return lw.scoring.score(motion, lw.scoring.Record(instants, **place | rates | changed))

    assert lw.scoring.score(motion, lw.scoring.Record(instants, **place)).beyond_rates is None
    exact = score()
    assert exact.beyond_rates < 1e-7 and not exact.doubts
    assert exact.as_dict()["beyond_rates"] == exact.beyond_rates
    # Semi-implicit Euler: each position by the rate at the end of its step, to rounding.
    euler = np.concatenate(([2.5], 2.5 + np.cumsum(samples.theta_rate[1:] * 1e-3)))
    assert score(theta=euler).beyond_rates < 1e-7
    # A turn that is 1 % too slow, all the way.
    slow = 2.5 + 0.99 * (samples.theta - 2.5)
    assert score(theta=slow).beyond_rates == pytest.approx(
        0.01 * (samples.theta[-1] - 2.5), rel=1e-2
    )
    # A step of the height without a velocity, as a correction of an overlap is.
    assert score(y=place["y"] + 0.01 * (instants > 0.5)).beyond_rates == pytest.approx(
        0.01, rel=0.1
    )
    assert "moved beyond rates  1.0" in str(score(y=place["y"] + 0.01 * (instants > 0.5)))


def test_rates_of_the_mass_centre_are_named():
    motion = lw.scoring.BENCHMARK["lands"].motion
    instants = np.arange(0.0, 2.0, 0.01)
    samples = motion(instants)
    along = samples.slip - samples.theta_rate
    record = lw.scoring.Record(
        instants,
        samples.x,
        samples.centre_y,
        samples.theta,
        None,
        along - motion.hoop.h * np.cos(samples.theta) * samples.theta_rate,
        samples.gap_rate - motion.hoop.h * np.sin(samples.theta) * samples.theta_rate,
        samples.theta_rate,
    )
    (doubt,) = lw.scoring.score(motion, record).doubts
    assert "off in x_rate by 0.2" in doubt and "geometric centre" in doubt


def test_rim_in_the_plane_for_a_while_gains_no_energy(motion, instants, columns):
    deep = (instants > 0.6) & (instants < 0.8)
    score = scored(motion, instants, columns, y=columns["y"] - 0.004 * deep)
    assert score.penetration == pytest.approx(0.004) and score.energy_gained < 1e-12


MISTAKES = {
    "theta has the other sign": lambda r, h: {"theta": -r["theta"]},
    "theta is in degrees": lambda r, h: {"theta": np.degrees(r["theta"])},
    "theta is whole turns off": lambda r, h: {"theta": r["theta"] + 4 * math.pi},
    "another direction": lambda r, h: {"theta": r["theta"] + math.pi / 2},
    "mass centre": lambda r, h: {
        "x": r["x"] - h * np.sin(r["theta"]),
        "y": r["y"] + h * np.cos(r["theta"]),
    },
    "y is the gap": lambda r, h: {"y": r["y"] - 1.0},
    "time is in thousandths": lambda r, h: {"time": 1e3 * r["time"]},
    "x and y are in thousandths": lambda r, h: {"x": 1e3 * r["x"], "y": 1e3 * r["y"]},
    "x does not begin at 0": lambda r, h: {"x": r["x"] + 3.0},
    "x has the other sign": lambda r, h: {"x": -r["x"]},
}


@pytest.mark.parametrize("mistake", MISTAKES)
@pytest.mark.parametrize("name", ["one-coefficient", "bounces", "comsol"])
def test_the_usual_mistakes_are_named(mistake, name):
    motion = lw.scoring.BENCHMARK[name].motion
    instants, columns = sampled(motion, 4e-3)
    changed = {"time": instants, **columns}
    changed |= MISTAKES[mistake](changed, motion.hoop.h)
    record = lw.scoring.Record(**changed)
    if mistake == "time is in thousandths":
        # Too few rows are within the motion to score anything.
        with pytest.raises(ValueError, match=r"fewer than three instants.*time is in thousandths"):
            lw.scoring.score(motion, record)
        return
    (doubt,) = lw.scoring.score(motion, record).doubts
    assert mistake in doubt


def test_two_mistakes_and_another_case_are_named(motion):
    instants, columns = sampled(motion, 4e-3)
    both = {**columns, "theta": np.degrees(columns["theta"]), "y": columns["y"] - 1.0}
    (doubt,) = scored(motion, instants, both).doubts
    assert "theta is in degrees" in doubt and "y is the gap" in doubt
    other = lw.scoring.BENCHMARK["lands"].motion
    instants, columns = sampled(other, 4e-3)
    (doubt,) = scored(motion, instants, columns).doubts
    assert "is it the case lands?" in doubt


def test_a_wrapped_angle_is_named():
    motion = lw.scoring.BENCHMARK["one-coefficient"].motion
    instants, columns = sampled(motion, 4e-3)
    wrapped = np.angle(np.exp(1j * columns["theta"]))
    assert np.max(np.abs(np.diff(wrapped))) > 6.0
    (doubt,) = scored(motion, instants, columns, theta=wrapped).doubts
    assert "is it wrapped?" in doubt


def test_noise_is_counted_and_not_listed(motion, instants, columns):
    noise = np.random.default_rng(1).normal(0.0, 1e-5, instants.size)
    score = scored(motion, instants, columns, x=columns["x"] + noise)
    assert len(score.spurious) > 50
    printed = str(score)
    assert len(printed.splitlines()) < 25 and "times from" in printed
    # Differences of white noise: its size times √2 over the step.
    size = float(printed.split("noise of about ")[1].split()[0])
    assert size == pytest.approx(1e-5 * math.sqrt(2.0) / STEP, rel=0.2)


def test_the_steps_of_the_solver_may_be_other_than_those_of_the_rows(motion):
    scores = []
    for step in (0.01, 0.005):
        instants, columns = sampled(motion, 0.02)
        scores.append(
            scored(motion, instants, columns, theta=columns["theta"] + step**2 * instants)
        )
    assert lw.scoring.convergence(scores, [0.01, 0.005]).order == pytest.approx(2.0)
    with pytest.raises(ValueError, match="1 different steps"):
        lw.scoring.convergence(scores)
    with pytest.raises(ValueError, match="1 steps, and 2 scores"):
        lw.scoring.convergence(scores, [0.01])
    with pytest.raises(ValueError, match="must be positive"):
        lw.scoring.convergence(scores, [0.01, 0.0])


@pytest.mark.parametrize("order", [1, 2, 4])
def test_the_order_of_convergence(motion, order):
    scores = []
    for step in (0.04, 0.02, 0.01, 0.005):
        instants = np.arange(0.0, 3.8, step)
        samples = motion(instants)
        theta = samples.theta + step**order * np.sin(instants / instants[-1] * math.pi / 2)
        scores.append(
            lw.scoring.score(
                motion, lw.scoring.Record(instants, samples.x, samples.centre_y, theta)
            )
        )
    assert lw.scoring.convergence(scores).order == pytest.approx(order, abs=1e-5)
    with pytest.raises(ValueError, match="1 different steps"):
        lw.scoring.convergence(scores[:1])


def test_what_ends_later_than_the_motion_is_left_out(motion, columns, instants):
    longer = np.append(instants, [10.0, 11.0])
    record = lw.scoring.Record(
        longer, *(np.append(columns[name], [0.0, 0.0]) for name in ("x", "y", "theta"))
    )
    assert lw.scoring.score(motion, record).largest_error == 0.0
    with pytest.raises(ValueError, match="fewer than three instants"):
        lw.scoring.score(motion, lw.scoring.Record([20.0, 21.0, 22.0], *np.ones((3, 3))))


def test_pairs_are_in_order_and_the_nearest():
    def event(kind, time):
        return Event(kind, time)

    exact = [event("stick", 1.0), event("slip", 2.0), event("stick", 3.0)]
    found = [event("stick", 0.9), event("stick", 3.1), event("lift_off", 3.2)]
    assert match(exact, found, 0.25) == [
        (exact[0], found[0]),
        (exact[1], None),
        (exact[2], found[1]),
        (None, found[2]),
    ]
    # Nearer than farther, and never across.
    assert match([event("slip", 1.0)], [event("slip", 0.8), event("slip", 1.1)], 0.25)[1] == (
        event("slip", 1.0),
        event("slip", 1.1),
    )
    assert match(exact, [], 0.25) == [(one, None) for one in exact]


def write(path, header, rows):
    path.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    return path


@pytest.mark.parametrize(
    ("header", "rows", "line", "column", "reason"),
    [
        (
            "time,x,y,theta",
            ["0,0,1,0", "1,0,1,zero", "2,0,1,0"],
            3,
            "theta",
            "'zero' is not a finite number",
        ),
        (
            "time,x,y,theta",
            ["0,0,1,0", "1,nan,1,0", "2,0,1,0"],
            3,
            "x",
            "'nan' is not a finite number",
        ),
        (
            "time,x,y,theta",
            ["0,0,1,0", "", "1,0,1", "2,0,1,0"],
            4,
            None,
            "has 3 cells, the line of names has 4",
        ),
        (
            "time,x,y,theta",
            ["0,0,1,0", "1,0,1,0", "1,0,1,0"],
            4,
            "time",
            "must be greater than 1 of line 3",
        ),
        ("time,x,theta", ["0,0,0"], 1, "y", "is missing among time, x, theta"),
        ("t,x,y,theta", ["0,0,1,0"], 1, "time", "is missing among t, x, y, theta; is t meant?"),
        ("time,X,y,theta", ["0,0,1,0"], 1, "x", "is X meant?"),
        ("0,0.5,1,2", ["1,0,1,0"], 1, None, "has no line of names; write one above the numbers"),
        ("time,x,y,theta,x_rate", ["0,0,1,0,0"], 1, "y_rate", "is missing among"),
        ("time,x,y,theta,x", ["0,0,1,0,0"], 1, "x", "occurs twice"),
        ("time_s,x,y_m,theta_rad", ["0,0,1,0"], 1, "time_s", "x has no dimension"),
        ("time_s,x_m,y_m,theta_rad", ["0,0,1,0"], 1, "time_s", "the hoop has none"),
        (
            "time,x,y,theta,contact",
            ["0,0,1,0,1", "1,0,1,0,2", "2,0,1,0,1"],
            3,
            "contact",
            "must be 0 or 1",
        ),
        ("time,x,y,theta", ["0,0,1,0"], None, None, "at least 3"),
        ("", [], None, None, "is empty"),
        ("time,x,y,theta", [], 1, None, "has no rows"),
    ],
)
def test_a_bad_file_is_refused_with_line_and_column(tmp_path, header, rows, line, column, reason):
    path = write(tmp_path / "bad.csv", header, rows)
    with pytest.raises(lw.scoring.TableFileError) as caught:
        lw.scoring.Record.from_csv(path)
    assert (caught.value.line, caught.value.column) == (line, column)
    assert reason in str(caught.value) and str(path) in str(caught.value)


def test_bad_records_are_refused():
    with pytest.raises(ValueError, match="at least 3 instants"):
        lw.scoring.Record([0.0, 1.0], [0.0, 0.0], [1.0, 1.0], [0.0, 0.0])
    with pytest.raises(ValueError, match=r"x has shape \(2,\)"):
        lw.scoring.Record([0.0, 1.0, 2.0], [0.0, 0.0], [1.0, 1.0, 1.0], [0.0, 0.0, 0.0])
    with pytest.raises(ValueError, match=r"y\[1\] = inf must be finite"):
        lw.scoring.Record([0.0, 1.0, 2.0], np.zeros(3), [1.0, math.inf, 1.0], np.zeros(3))
    with pytest.raises(ValueError, match=r"time\[2\] = 1.0 must be greater"):
        lw.scoring.Record([0.0, 1.0, 1.0], np.zeros(3), np.ones(3), np.zeros(3))
    with pytest.raises(ValueError, match=r"gap = -1.0 R must be positive"):
        lw.scoring.Tolerances(gap=-1.0)


def test_a_mark_at_the_begin_of_a_file_is_no_name(tmp_path):
    path = tmp_path / "marked.csv"
    path.write_text("time,x,y,theta\n0,0,1,0\n1,0,1,0\n2,0,1,0\n", encoding="utf-8-sig")
    assert lw.scoring.Record.from_csv(path).time.tolist() == [0.0, 1.0, 2.0]
    # Other separators and decimal marks are those of the tracks.
    path.write_text("time;x;y;theta\n0;0,5;1;0\n1;0;1;0\n2;0;1;0\n", encoding="utf-8")
    assert lw.scoring.Record.from_csv(path).x.tolist() == [0.5, 0.0, 0.0]


def test_what_the_command_line_simulates_is_read(binary, tmp_path, motion):
    path = tmp_path / "exact.csv"
    subprocess.run(
        [binary, "simulate", "figure-3", "--samples", "2000", "--format", "csv", "--out", path],
        check=True,
    )
    score = lw.scoring.score(motion, lw.scoring.Record.from_csv(path))
    assert score.largest_error < 1e-14 and not score.missed and not score.spurious


def test_a_file_in_si_units_is_the_same(tmp_path):
    hoop = lw.Hoop.from_si(
        disc_mass_kg=0.3,
        particle_mass_kg=0.2,
        radius_m=0.4,
        offset_m=0.38,
        inertia_kg_m2=0.045,
        mu_s=0.4,
        mu_k=0.3,
    )
    motion = hoop.simulate(theta=1.0, theta_rate=1.5, until=2.0)
    instants = np.linspace(0.0, 2.0, 801)
    samples = motion(instants)
    rows = np.column_stack(
        [
            instants * hoop.units.time_s,
            samples.x * hoop.units.length_m,
            samples.centre_y * hoop.units.length_m,
            samples.theta,
        ]
    )
    path = tmp_path / "si.csv"
    np.savetxt(
        path, rows, fmt="%.17g", delimiter=",", header="time_s,x_m,y_m,theta_rad", comments=""
    )
    score = lw.scoring.score(motion, lw.scoring.Record.from_csv(path, hoop.units))
    assert score.largest_error < 1e-14
    # What is printed is in SI units, too.
    event = score.events[-1]
    assert f"{event.exact * hoop.units.time_s:.6f}" in str(score) and "s, m, rad, J" in str(score)


def test_the_command_prints_and_draws(motion, columns, instants, tmp_path, capsys):
    files = []
    for stride in (2, 4):
        table = np.column_stack(
            [instants, columns["x"], columns["y"], columns["theta"] + 1e-6 * stride]
        )[::stride]
        path = tmp_path / f"{stride}.csv"
        np.savetxt(path, table, fmt="%.17g", delimiter=",", header="time,x,y,theta", comments="")
        files.append(str(path))
    assert main(["figure-3", files[0], "--plot", str(tmp_path / "one.png")]) == 0
    printed = capsys.readouterr().out
    assert "lift_off" in printed and "theta 2.00e-06" in printed
    assert main(["figure-3", *files, "--plot", str(tmp_path / "two.svg")]) == 0
    assert "order of convergence  1.00" in capsys.readouterr().out
    assert (tmp_path / "one.png").stat().st_size > 10_000
    assert "<title>Score of 2.csv, 4.csv</title>" in (tmp_path / "two.svg").read_text(
        encoding="utf-8"
    )
    assert main(["figure-3", files[0], "--plot", str(tmp_path / "one.bmp")]) == 2
    assert "must end in .svg, .pdf or .png" in capsys.readouterr().err
    assert main(["figure-3", *files, "--json"]) == 0
    whole = json.loads(capsys.readouterr().out)
    assert whole["case"] == "figure-3" and whole["scores"][0]["largest_error"][
        "theta"
    ] == pytest.approx(2e-6)
    assert whole["order"] == pytest.approx(1.0)


def test_a_certificate_names_a_case(tmp_path, capsys):
    certificate = sorted((ROOT / "evidence" / "truth" / "certificates").glob("si-*.json"))[0]
    motion = simulated(json.loads(certificate.read_text(encoding="utf-8"))["case"])
    units = motion.hoop.require_units()
    instants = np.linspace(0.0, min(3.0, motion.end_time), 400)
    samples = motion(instants)
    lengths = units.length_m
    rows = [instants * units.time_s, samples.x * lengths, samples.centre_y * lengths, samples.theta]
    path = tmp_path / "si.csv"
    np.savetxt(
        path,
        np.column_stack(rows),
        fmt="%.17g",
        delimiter=",",
        header="time_s,x_m,y_m,theta_rad",
        comments="",
    )
    assert main([str(certificate), str(path), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["scores"][0]["largest_error"]["state"] < 1e-13
    changed = json.loads(certificate.read_text(encoding="utf-8"))
    # Another event, with the digest of what it says, is what it is scored against.
    events = json.loads(certificate.read_text(encoding="utf-8"))
    events["events"][0]["state"]["time"][0] = "0.25"
    events["digest"] = digest(events)
    other = write(tmp_path / "events.json", json.dumps(events), [])
    assert main([str(other), str(path), "--json"]) == 0
    first = json.loads(capsys.readouterr().out)["scores"][0]["events"]
    assert 0.25 / units.time_s in [event["exact"] for event in first]
    changed["events"][0]["state"]["time"][0] = "9.9"
    case_alone = {"case": changed["case"]}
    for text, reason in (
        ("{}", "must have format"),
        (json.dumps(case_alone), "must have format"),
        (json.dumps(changed), "the digest is not that of the certificate"),
        ("[" * 200_000, "too deep"),
        ("[", "this is no JSON"),
    ):
        other = write(tmp_path / "other.json", text, [])
        assert main([str(other), str(path)]) == 2
        message = capsys.readouterr().err
        assert "is not a certificate" in message and reason in message


def test_the_command_refuses_with_the_reason(tmp_path, capsys):
    path = write(tmp_path / "bad.csv", "time,x,y,theta", ["0,0,1,0", "1,0,1,?"])
    assert main(["figure-3", str(path)]) == 2
    assert "line 3, column theta: '?' is not a finite number" in capsys.readouterr().err
    assert main(["figure-33", str(path)]) == 2
    assert "did you mean 'figure-3'" in capsys.readouterr().err
    assert main(["figure-3", str(path), "--steps", "0.1", "0.2"]) == 2
    assert "line 3" in capsys.readouterr().err
    assert main(["figure-3", str(tmp_path / "none.csv")]) == 2
    assert "none.csv" in capsys.readouterr().err
    assert main(["figure-3", str(path), "--gap", "0"]) == 2
    assert "gap = 0.0 R must be positive" in capsys.readouterr().err


def test_the_program_of_the_package_has_the_command(monkeypatch, capsys):
    from littlewood import __main__

    monkeypatch.setattr("sys.argv", ["littlewood", "score", "--help"])
    with pytest.raises(SystemExit) as stopped:
        __main__.main()
    assert stopped.value.code == 0 and "littlewood score" in capsys.readouterr().out


def test_the_cases_have_one_name_everywhere(capsys):
    certificates = {
        path.stem for path in (ROOT / "evidence" / "truth" / "certificates").glob("*.json")
    }
    assert set(lw.scoring.CASES) == certificates
    assert not set(lw.scoring.CASES) & set(lw.CASES)
    assert {one.category for one in lw.scoring.BENCHMARK.values()} == set(CATEGORIES)
    assert all(one.what and one.given["until"] for one in lw.scoring.BENCHMARK.values())
    with pytest.raises(SystemExit) as stopped:
        main(["--list"])
    assert stopped.value.code == 0
    printed = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in printed] == list(lw.scoring.BENCHMARK)


def test_the_command_warns_of_a_mistake(tmp_path, capsys, motion):
    instants, columns = sampled(motion, 4e-3)
    rows = np.column_stack([instants, columns["x"], columns["y"], np.degrees(columns["theta"])])
    path = tmp_path / "degrees.csv"
    np.savetxt(path, rows, delimiter=",", header="time,x,y,theta", comments="")
    assert main(["figure-3", str(path)]) == 0
    assert "warning" in (err := capsys.readouterr().err) and "theta is in degrees" in err


def test_derivatives_are_scored_phase_by_phase(tmp_path, capsys, motion):
    instants = np.linspace(0.01, 3.8, 400)
    exact = motion.derivatives_at(instants, ["mu_k"])
    x, theta = (exact[name].values[:, 0] for name in ("x", "theta"))
    score = lw.scoring.score_gradient(motion, instants, x, theta, "mu_k")
    assert [phase.mode for phase in score.phases] == ["sliding", "rolling", "sliding", "flight"]
    assert score.largest_relative == 0.0
    # Central differences of the exact motion are a solver's with an error of second order.
    by = 1e-4
    hoops = (
        lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4 + way) for way in (by, -by)
    )
    sides = [hoop.simulate(theta=math.pi / 2, theta_rate=2.0) for hoop in hoops]
    distances = np.abs(instants[:, None] - [one.time for one in motion.transitions])
    away = instants[np.min(distances, axis=1) > 0.01]
    plus, minus = (side(away) for side in sides)
    found = [(plus[name] - minus[name]) / (2.0 * by) for name in ("x", "theta")]
    score = lw.scoring.score_gradient(motion, away, *found, "mu_k")
    assert score.largest_relative < 1e-5
    path = tmp_path / "gradient.csv"
    rows = np.column_stack([instants, x, 1.1 * theta])
    np.savetxt(path, rows, fmt="%.17g", delimiter=",", header="time,x,theta", comments="")
    assert main(["figure-3", str(path), "--gradient", "mu_k", "--json"]) == 0
    phases = json.loads(capsys.readouterr().out)["gradients"][0]["phases"]
    sliding = instants < motion.transitions[0].time
    assert phases[0]["error"] == pytest.approx(0.1 * np.max(np.abs(theta[sliding])), rel=1e-12)
    assert main(["figure-3", str(path), "--gradient", "mass"]) == 2
    assert "mass" in capsys.readouterr().err
    with pytest.raises(ValueError, match="slip = 0"):
        lw.scoring.score_gradient(motion, instants, x, theta, "slip")
    rows[3, 1] *= np.nan
    with pytest.raises(ValueError, match=r"x\[3\] must be finite"):
        lw.scoring.score_gradient(motion, *rows.T, "mu_k")
