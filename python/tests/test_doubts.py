"""Fits that are wrong say so."""

import dataclasses
import math
import re
import warnings

import numpy as np
import pytest

import littlewood as lw
from littlewood.fitting import DOUBTS, USUAL_ERRORS, FitWarning, diagnostics

# It slides, rolls, slips and lifts off.
THROW = {"theta": -1.7, "theta_rate": 1.0, "slip": -1.6}
NOISE = 0.005
FREE = ("mu_s", "mu_k", "inertia")


@pytest.fixture(scope="module")
def motion():
    return lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4).simulate(**THROW)


def track_of(motion, seed=1, *, channels=("theta", "x"), scale=1.0, marker=0.0):
    random = np.random.default_rng(seed)
    time = np.linspace(0.0, 0.98 * motion.end_time, 300)
    seen = motion(time)
    values = {"theta": seen.theta + marker, "x": scale * seen.x, "y": scale * seen.centre_y}
    return lw.Track(
        time, **{name: values[name] + random.normal(0.0, NOISE, time.size) for name in channels}
    )


def fitted(track, motion, **more):
    """Fit from the truth on; return the result and the doubts that were raised."""
    given = {"free": FREE, "slips_at_start": True, "start": THROW, "search": False} | more
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = lw.fit(track, given.pop("hoop", motion.hoop), **given)
    raised = [
        warning.message.doubt for warning in caught if isinstance(warning.message, FitWarning)
    ]
    assert raised == list(result.doubts)
    assert {one.name for one in raised} <= set(DOUBTS)
    return result, {one.name: one for one in raised}


def test_a_good_fit_has_no_doubts(motion):
    result, raised = fitted(track_of(motion), motion)
    assert raised == {}
    assert result.sequences == {"-R+F": 1.0}
    assert "doubt" not in str(result)


def test_a_held_coefficient_that_the_track_contradicts(motion):
    """The how-to for films held μs at a guess of 0.6.

    It printed a friction that was wrong by 34 standard errors.
    """
    wrong = dataclasses.replace(motion.hoop, mu_s=0.6)
    result, raised = fitted(track_of(motion), motion, hoop=wrong, free=("mu_k", "inertia"))
    assert "mu_s" in raised["held"].parameters
    # μs itself, not its excess over μk.
    size, error = re.search(r"mu_s (\S+) ± (\S+) in", raised["held"].message).groups()
    assert abs(float(size) - 0.5) < 4.0 * float(error) < 0.03
    # It is named in the result, in the table and in the picture.
    assert "doubt             held: by" in str(result)
    assert "Doubt: held" in result._repr_html_()
    assert any("Doubt: held" in text.get_text() for text in result.plot().texts)


def test_a_wrong_scale_without_heights(motion):
    track = track_of(motion, scale=1.03)
    _, raised = fitted(track, motion)
    assert "camera_scale" in raised["camera"].parameters
    # It can be estimated from a position along the floor alone; it was left out there once, without
    # a word.
    result, raised = fitted(track, motion, calibration=("scale",))
    assert not raised
    scale = result.estimates["camera_scale"]
    assert abs(scale.value - 0.03) < 4.0 * scale.std_error < 0.02
    assert abs(result.hoop.mu_s - 0.5) < 4.0 * result.estimates["mu_s"].std_error


@pytest.mark.parametrize("factor", [0.96, 1.04])
def test_a_clock_that_is_wrong_is_named_with_its_size(motion, factor):
    """A score alone is a step that is too short: half of it, and less."""
    good = track_of(motion, channels=("theta", "x", "y"))
    wrong = dataclasses.replace(good, time=factor * good.time)
    _, raised = fitted(wrong, motion)
    assert "clock" in raised["held"].parameters
    size, error = re.search(r"clock (\S+) ± (\S+) in", raised["held"].message).groups()
    assert abs(float(size) - (1.0 / factor - 1.0)) < 4.0 * float(error) < 0.02


@pytest.mark.parametrize("factor", [0.96, 1.04])
def test_a_clock_is_named_where_no_derivative_leads_to_it(factor):
    """Bounces that hang on each other: the fit ends in another minimum, with waves and outliers.

    Derivatives there asked for the masses, the offset, or a camera that is not level.
    """
    start = {"theta": math.pi / 2, "theta_rate": 2.0}
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, restitution=0.5)
    random, time = np.random.default_rng(1), np.linspace(0.0, 4.0, 120)
    bounces = hoop.simulate(**start)
    seen = bounces(time)
    values = {"theta": seen.theta, "x": seen.x, "y": seen.centre_y}
    noisy = {name: one + random.normal(0.0, NOISE, time.size) for name, one in values.items()}
    track = lw.Track(factor * time, **noisy)
    _, raised = fitted(
        track,
        bounces,
        free=(*FREE, "restitution"),
        start=start,
        slips_at_start=False,
    )
    assert raised["held"].parameters == ("clock",)
    size, error = re.search(r"clock (\S+) ± (\S+) in", raised["held"].message).groups()
    assert abs(float(size) - (1.0 / factor - 1.0)) < 4.0 * float(error) < 0.002
    assert ("longer" if factor < 1.0 else "shorter") in raised["held"].message


def test_a_marker_beside_the_particle(motion):
    track = track_of(motion, marker=math.radians(3.0))
    _, raised = fitted(track, motion)
    assert "camera_marker" in raised["camera"].parameters


def test_frames_in_which_the_tracker_was_lost(motion):
    track = track_of(motion)
    track.x[[50, 51, 200]] += 0.3
    _, raised = fitted(track, motion)
    assert raised["outliers"].parameters == ("x",)
    assert (
        "3 frames" in raised["outliers"].message
        and "number 50, 51, 200" in raised["outliers"].message
    )
    _, raised = fitted(track, motion, loss="soft_l1")
    assert "outliers" not in raised


def test_waves_in_the_residuals(motion):
    track = track_of(motion)
    track.x[:] += 0.02 * np.sin(6.0 * track.time)
    _, raised = fitted(track, motion)
    assert raised["structure"].parameters == ("x",)


def test_errors_that_are_smaller_than_they_are(motion):
    _, raised = fitted(track_of(motion), motion, sigma={"theta": NOISE, "x": NOISE / 3})
    assert raised["misfit"].parameters == ("x",)
    ratio = float(raised["misfit"].message.split(" are ")[1].split(" times")[0])
    assert ratio == pytest.approx(3.0, rel=0.15)


def test_a_parameter_at_its_bound(motion):
    """μs is held below the true μk: the fit ends where they are equal."""
    wrong = dataclasses.replace(motion.hoop, mu_s=0.3, mu_k=0.2)
    result, raised = fitted(track_of(motion), motion, hoop=wrong, free=("mu_k",))
    assert result.hoop.mu_k == pytest.approx(0.3, abs=1e-3)
    assert raised["bound"].parameters == ("mu_k",)


def test_sequences_that_compete(motion):
    """Just after a slip out of rolling the motion hardly differs from rolling on."""
    assert [transition.cause for transition in motion.transitions[:2]] == ["stick", "slip"]
    random = np.random.default_rng(0)
    time = np.linspace(0.0, motion.transitions[1].time + 0.27, 120)
    seen = motion(time)
    track = lw.Track(
        time,
        theta=seen.theta + random.normal(0.0, NOISE, 120),
        x=seen.x + random.normal(0.0, NOISE, 120),
    )
    result, raised = fitted(track, motion)
    assert set(result.sequences) == {"-R", "-R+"}
    assert sum(result.sequences.values()) == pytest.approx(1.0)
    assert result.motion.sequence == next(iter(result.sequences))
    assert raised["sequences"].parameters == tuple(result.sequences)[1:]


def test_a_held_coefficient_that_the_track_does_not_show():
    """A slip that follows a slide at once.

    So μk makes up for μs, and the residuals are those of noise.
    """
    hoop = lw.Hoop(mass_ratio=0.54, offset=0.9, inertia=0.52, mu_s=0.6, mu_k=0.5)
    start = {"theta": -2.41, "theta_rate": -1.89, "slip": 1.4}
    motion = hoop.simulate(**start)
    assert motion.sequence == "+R-F"
    track = track_of(motion, channels=("theta", "x", "y"))
    wrong = dataclasses.replace(hoop, mu_s=0.72)
    result, raised = fitted(track, motion, hoop=wrong, free=("mu_k", "inertia"), start=start)
    assert abs(result.hoop.mu_k - 0.5) > 4.0 * result.estimates["mu_k"].std_error
    assert raised["unseen"].parameters[0] == "mu_s"
    assert re.search(r"of mu_k \d.*Measure mu_s to \d.* %", raised["unseen"].message)


def test_what_was_measured_and_the_track_does_not_show():
    """A floor on which it slides and rolls: mass ratio and inertia do the same.

    The fit was wrong by twenty standard errors, without a word.
    """
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    start = {"theta": 2.3, "theta_rate": -1.4, "slip": 0.6}
    motion = hoop.simulate(**start, until=5.0)
    assert motion.sequence == "+R"
    random, time = np.random.default_rng(2), np.linspace(0.0, 4.9, 120)
    seen = motion(time)
    track = lw.Track(
        time,
        theta=seen.theta + random.normal(0.0, NOISE, 120),
        x=seen.x + random.normal(0.0, NOISE, 120),
    )
    wrong = dataclasses.replace(hoop, mass_ratio=0.95)
    result, raised = fitted(track, motion, hoop=wrong, start=start)
    inertia = result.estimates["inertia"]
    assert abs(inertia.value - 1.0) > 4.0 * inertia.std_error
    assert {"mass_ratio", "offset", "clock"} <= set(raised["unseen"].parameters)
    # It says what usual errors do: as much as a fit finds that is told them.
    wider, told = re.search(
        r"inertia (\S+) in place of (\S+)\. ", raised["unseen"].message
    ).groups()
    assert float(told) == pytest.approx(inertia.std_error, rel=0.1)
    result, raised = fitted(track, motion, hoop=wrong, start=start, errors=USUAL_ERRORS)
    inertia = result.estimates["inertia"]
    assert float(wider) == pytest.approx(inertia.std_error, rel=0.1)
    assert abs(inertia.value - 1.0) < 3.0 * inertia.std_error < 0.5
    assert "unseen" not in raised
    # Who says how well they are known has an interval that includes it, and no doubt of it.
    result, raised = fitted(
        track, motion, hoop=wrong, start=start, errors={"mass_ratio": 0.05, "offset": 0.01}
    )
    inertia = result.estimates["inertia"]
    assert abs(inertia.value - 1.0) < 2.0 * inertia.std_error < 0.3
    assert "unseen" not in raised
    for bad in ({"mass": 0.1}, {"offset": 0.0}, {"clock": math.inf}):
        with pytest.raises(ValueError, match="error"):
            fitted(track, motion, hoop=wrong, start=start, errors=bad)


def test_errors_of_what_was_measured_are_those_of_a_fit_that_frees_it(motion):
    """To first order one gets the same as with the slope among the unknowns."""
    track = track_of(motion)
    held, _ = fitted(track, motion, errors={"slope": 100.0})
    freed, _ = fitted(track, motion, free=(*FREE, "slope"))
    for name in FREE:
        shift = held.estimates[name].value - freed.estimates[name].value
        both = math.hypot(freed.estimates[name].std_error, shift)
        assert held.estimates[name].std_error == pytest.approx(both, rel=0.1)


def test_the_profile_is_that_of_a_normal_error_where_the_model_is_nearly_linear(motion):
    result, _ = fitted(track_of(motion), motion)
    for name in FREE:
        normal, profile = result.estimates[name].interval(0.9), result.profile_interval(name, 0.9)
        assert (
            np.max(np.abs(np.subtract(normal, profile)))
            < 0.15 * result.estimates[name].std_error * 1.645
        )
    with pytest.raises(ValueError, match="must be one of mu_s, mu_k, inertia"):
        result.profile_interval("start_theta")
    with pytest.raises(ValueError, match="confidence = 1"):
        result.profile_interval("mu_k", 1.5)


def test_the_profile_has_one_side_where_there_is_no_slip():
    """Without a slip out of rolling every μs above the friction that it needed is as good."""
    rolling = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4).simulate(
        theta=2.5, theta_rate=0.0
    )
    random = np.random.default_rng(4)
    time = np.linspace(0.0, 15.0, 200)
    track = lw.Track(time, theta=rolling(time).theta + random.normal(0.0, NOISE, 200))
    result, raised = fitted(
        track,
        rolling,
        free=("mu_s",),
        slips_at_start=False,
        start={"theta": 2.5, "theta_rate": 0.0},
    )
    assert raised["identifiability"].parameters == ("mu_s",)
    low, high = result.profile_interval("mu_s")
    assert low == pytest.approx(result.mu_s_at_least, abs=0.01) or low == 0.4
    assert high > 100.0


def test_tests_of_residuals_seldom_speak_of_noise():
    """Of 2,000 series of noise at most a handful may be doubted.

    Each test is one of 4.2 standard deviations.
    """
    random, spoken = np.random.default_rng(5), 0
    for _ in range(2000):
        noise = random.normal(0.0, 0.01, 150)
        frames = np.arange(150)
        one = diagnostics._Channel(
            frames, noise, np.ones(150), diagnostics._from_frame_to_frame(noise, frames)
        )
        spoken += len(list(diagnostics._structure({"x": one}))) + len(
            list(diagnostics._outliers({"x": one}))
        )
    assert spoken <= 6
    # The size of what differs from frame to frame is right, with waves or without.
    waves = random.normal(0.0, 0.01, 5000) + np.sin(np.arange(5000) / 30.0)
    assert diagnostics._from_frame_to_frame(waves, np.arange(5000)) == pytest.approx(0.01, rel=0.1)
