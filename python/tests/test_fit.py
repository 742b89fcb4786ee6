import dataclasses
import math
import warnings

import numpy as np
import pytest

import littlewood as lw
from littlewood.fitting import least_squares
from littlewood.fitting.noise import Noise
from littlewood.fitting.problem import Problem

# A throw with backspin: it slides, rolls, slips, and lifts off. Few starts tell as much about both
# coefficients.
THROW = {"theta": -1.7, "theta_rate": 1.0, "slip": -1.6}
NOISE = 0.005
# As a track has it, whose angles begin between 0 and 2π.
TRUTH = THROW | {"theta": THROW["theta"] % (2 * math.pi), "x": 0.0}


@pytest.fixture
def guess(hoop):
    return dataclasses.replace(hoop, inertia=0.8, mu_s=0.8, mu_k=0.2)


def tracked(motion, seed, *, count=300, end=None, channels=("theta", "x")):
    """A motion as a video shows it: angles up to a turn, and noise."""
    random = np.random.default_rng(seed)
    time = np.linspace(0.0, 0.98 * motion.end_time if end is None else end, count)
    seen = motion(time)
    values = {"theta": seen.theta, "x": seen.x, "y": seen.centre_y}
    noisy = {name: values[name] + random.normal(0.0, NOISE, count) for name in channels}
    if "theta" in noisy:
        noisy["theta"] = noisy["theta"] % (2 * math.pi)
    return lw.Track(time, **noisy)


def searched(seed):
    """Whether a fit of many searches for the minimum. The others begin in it.

    What they test is its width.
    """
    return seed < 2


def test_it_recovers_what_was_put_in(hoop, guess):
    motion = hoop.simulate(**THROW)
    assert motion.sequence == "-R+F"
    pulls = []
    for seed in range(16):
        first, start = (guess, {}) if searched(seed) else (hoop, TRUTH)
        track = tracked(motion, seed)
        result = lw.fit(track, first, slips_at_start=True, start=start, search=searched(seed))
        assert result.motion.sequence == "-R+F"
        for name in ("mu_s", "mu_k", "inertia"):
            estimate = result.estimates[name]
            assert estimate.identifiable
            pulls.append((estimate.value - getattr(hoop, name)) / estimate.std_error)
        assert result.sigma["theta"] == pytest.approx(NOISE, rel=0.25)
        assert result.estimates["mu_s"].std_error < 0.01
        assert result.estimates["mu_k"].std_error < 0.003
    # Errors over standard errors are numbers of a standard normal distribution: 48 of them, 3 and 3
    # of each motion correlated. Their mean square is 1, to about √(2/16).
    assert np.max(np.abs(pulls)) < 4.5
    assert 0.4 < np.mean(np.square(pulls)) < 2.0


# Figure 3 with e = 0.5: a landing that sticks, two that slip, and bounces that settle in rolling.
BOUNCES = {"theta": math.pi / 2, "theta_rate": 2.0}
RESTITUTION = ("mu_s", "mu_k", "inertia", "restitution")


# Bounces hang on each other: their likelihood is no parabola, and the fit says so.
@pytest.mark.thorough
@pytest.mark.filterwarnings("ignore:interval")
def test_it_recovers_the_restitution_from_bounces(hoop, guess):
    motion = dataclasses.replace(hoop, restitution=0.5).simulate(**BOUNCES)
    pulls = []
    for seed in range(6):
        track = tracked(motion, seed, end=8.5, channels=("theta", "x", "y"))
        # Nothing is known of the coefficient at first, not even that there is one.
        first, start = (guess, {}) if searched(seed) else (motion.hoop, BOUNCES)
        result = lw.fit(track, first, free=RESTITUTION, start=start, search=searched(seed))
        assert result.motion.sequence == motion.sequence
        assert result.hoop.restitution_law == "energetic"
        assert result.reduced_chi_square == pytest.approx(1.0, abs=0.1)
        for name in ("mu_k", "inertia", "restitution"):
            estimate = result.estimates[name]
            assert estimate.identifiable
            true = 0.5 if name == "restitution" else getattr(hoop, name)
            pulls.append((estimate.value - true) / estimate.std_error)
        assert result.estimates["restitution"].std_error < 0.001
    # 18 errors over standard errors, 3 of each motion correlated: a mean square of 1, to about
    # √(2/6).
    assert np.max(np.abs(pulls)) < 4.5
    assert np.mean(np.square(pulls)) < 1.0 + 4.0 * math.sqrt(2 / 6)


def test_a_known_restitution_follows_the_landing(hoop, guess):
    bouncy = dataclasses.replace(hoop, restitution=0.3, restitution_law="newton")
    motion = bouncy.simulate(**BOUNCES)
    wrong = dataclasses.replace(bouncy, mu_k=0.3)
    result = lw.fit(
        tracked(motion, 5, end=6.0, channels=("theta", "x", "y")), wrong, free=("mu_k",)
    )
    assert (result.hoop.restitution, result.hoop.restitution_law) == (0.3, "newton")
    estimate = result.estimates["mu_k"]
    assert abs(estimate.value - hoop.mu_k) < 4.5 * estimate.std_error
    assert result.reduced_chi_square == pytest.approx(1.0, abs=0.1)


def test_without_an_impact_there_is_no_restitution_to_see(hoop):
    rolling = hoop.simulate(theta=2.5, theta_rate=0.0)
    with pytest.warns(
        lw.fitting.IdentifiabilityWarning, match="restitution .no impact was seen"
    ) as caught:
        result = lw.fit(
            tracked(rolling, 1, end=15.0, count=60), hoop, free=("inertia", "restitution")
        )
    assert caught[0].message.parameters == ("restitution",)
    assert result.estimates["restitution"].std_error == math.inf


def test_given_sigmas_are_taken(hoop, guess):
    track = tracked(hoop.simulate(**THROW), 0)
    result = lw.fit(track, guess, slips_at_start=True, sigma={"theta": NOISE, "x": NOISE})
    assert result.sigma == {"theta": NOISE, "x": NOISE}
    assert result.reduced_chi_square == pytest.approx(1.0, abs=0.25)


def test_without_a_slip_there_is_no_friction_to_see(hoop, guess):
    rolling = hoop.simulate(theta=2.5, theta_rate=0.0)
    with pytest.warns(
        lw.fitting.IdentifiabilityWarning, match="mu_s .*only mu_s >= .*mu_k .no slide"
    ) as caught:
        result = lw.fit(tracked(rolling, 1, end=15.0), guess)
    assert caught[0].message.parameters == ("mu_s", "mu_k")
    assert not result.estimates["mu_s"].identifiable
    assert result.estimates["mu_s"].std_error == math.inf
    inertia = result.estimates["inertia"]
    assert abs(inertia.value - hoop.inertia) < 4 * inertia.std_error
    # What rolling needed is what is known of the static friction: here less than there was.
    assert 0.0 < result.mu_s_at_least < hoop.mu_s
    assert "not identifiable" in str(result)


def test_one_thing_at_a_time(hoop):
    track = tracked(hoop.simulate(**THROW), 3)
    wrong = dataclasses.replace(hoop, mu_k=0.2)
    result = lw.fit(track, wrong, free=["mu_k"], slips_at_start=True)
    assert result.hoop.mu_s == hoop.mu_s
    assert result.hoop.inertia == hoop.inertia
    assert abs(result.hoop.mu_k - 0.4) < 4 * result.estimates["mu_k"].std_error


@pytest.mark.parametrize("channels", [("x",), ("x", "y")])
def test_the_centre_alone(hoop, guess, channels):
    """A position says nothing of the angle, nor of its rate where the hoop slips.

    The fit finds both.
    """
    result = lw.fit(
        tracked(hoop.simulate(**THROW), 5, channels=channels), guess, slips_at_start=True
    )
    assert result.motion.sequence == "-R+F"
    for name in ("mu_s", "mu_k", "inertia"):
        estimate = result.estimates[name]
        assert abs(estimate.value - getattr(hoop, name)) < 4.5 * estimate.std_error


def test_missing_frames_and_outliers(hoop, guess):
    track = tracked(hoop.simulate(**THROW), 7)
    track.theta[40:60] = np.nan
    track.x[::37] += 0.5
    result = lw.fit(
        track, guess, slips_at_start=True, sigma={"theta": NOISE, "x": NOISE}, loss="soft_l1"
    )
    assert abs(result.hoop.mu_k - 0.4) < 0.02
    assert np.isnan(result.residuals["theta"][40:60]).all()


def test_a_csv_in_si_units(tmp_path):
    hoop = lw.Hoop.from_si(
        disc_mass_kg=0.4,
        particle_mass_kg=0.14,
        radius_m=0.45,
        offset_m=0.45,
        inertia_kg_m2=0.075,
        mu_s=0.45,
        mu_k=0.35,
    )
    motion = hoop.simulate_si(theta_rad=-1.7, theta_rate_rad_per_s=4.7, slip_m_per_s=-3.4)
    random = np.random.default_rng(0)
    table = motion.to_pandas(np.linspace(0, 0.98 * min(motion.end_time, 8.0), 250), si=True)
    path = tmp_path / "video.csv"
    with path.open("w") as file:
        file.write("frame,time_s,theta_deg,x_m\n")
        for i, row in table.iterrows():
            angle = math.degrees(row.theta_rad) + random.normal(0, 0.2)
            file.write(
                f"{i},{row.time_s},{angle if i % 50 else ''},{row.x_m + random.normal(0, 0.002)}\n"
            )
    guess = dataclasses.replace(hoop, mu_s=0.6, mu_k=0.2, inertia=2.0)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.IdentifiabilityWarning)
        result = lw.fit(path, guess, slips_at_start=True)
    estimate = result.estimates["mu_k"]
    assert estimate.identifiable
    assert abs(estimate.value - 0.35) < 4 * estimate.std_error
    assert result.inertia_kg_m2 == pytest.approx(0.075, rel=0.1)
    with pytest.raises(ValueError, match="from_si"):
        lw.Track.from_csv(path)


# On a ramp it slides, rolls, slips, and lifts off, too.
SLOPE = 0.2


def on_ramp(motion, seed, *, level):
    """The same as a camera sees it on a ramp: with axes along the ramp, or level."""
    track = tracked(motion, seed, channels=("theta", "x", "y"))
    if not level:
        return track
    sin, cos = math.sin(SLOPE), math.cos(SLOPE)
    # Noise of equal size in x and y is the same in turned axes.
    x, y = track.x * cos - track.y * sin, track.x * sin + track.y * cos
    return lw.Track(track.time, theta=track.theta + SLOPE, x=x, y=y, level=True)


@pytest.mark.parametrize("level", [False, True])
def test_a_track_on_a_ramp_of_a_known_slope(hoop, guess, level):
    ramp = dataclasses.replace(hoop, slope=SLOPE)
    motion = ramp.simulate(**THROW)
    assert motion.sequence == "-R+F"
    pulls = []
    for seed in range(4):
        track = on_ramp(motion, seed, level=level)
        first, start = (dataclasses.replace(guess, slope=SLOPE), {}) if seed == 0 else (ramp, TRUTH)
        result = lw.fit(track, first, slips_at_start=True, start=start, search=seed == 0)
        assert (result.motion.sequence, result.hoop.slope) == ("-R+F", SLOPE)
        assert result.reduced_chi_square == pytest.approx(1.0, abs=0.15)
        for name in ("mu_s", "mu_k", "inertia"):
            estimate = result.estimates[name]
            pulls.append((estimate.value - getattr(hoop, name)) / estimate.std_error)
    assert np.max(np.abs(pulls)) < 4.5
    # The plane for a level one does not fit, and the fit says that it is steep.
    with pytest.warns(lw.fitting.FitWarning) as caught:
        wrong = lw.fit(
            track,
            guess,
            free=("mu_s", "mu_k", "inertia"),
            slips_at_start=True,
            sigma=dict.fromkeys(track.channels, NOISE),
        )
    assert wrong.reduced_chi_square > 2.0
    assert any(warning.message.doubt.name == "misfit" for warning in caught)
    assert any("slope" in warning.message.parameters for warning in caught)


@pytest.mark.thorough
@pytest.mark.parametrize("level", [False, True])
def test_the_slope_of_a_ramp_is_found(hoop, guess, level):
    motion = dataclasses.replace(hoop, slope=SLOPE).simulate(**THROW)
    pulls, inside = [], 0
    for seed in range(8):
        track = on_ramp(motion, seed, level=level)
        free = ("mu_s", "mu_k", "inertia", "slope")
        first, start = (
            (dataclasses.replace(guess, slope=0.12), {}) if searched(seed) else (motion.hoop, TRUTH)
        )
        result = lw.fit(
            track, first, free=free, slips_at_start=True, start=start, search=searched(seed)
        )
        assert result.motion.sequence == "-R+F"
        estimate = result.estimates["slope"]
        assert estimate.identifiable and result.hoop.slope == estimate.value
        pulls.append((estimate.value - SLOPE) / estimate.std_error)
        low, high = estimate.interval(0.999)
        inside += low <= SLOPE <= high
        # Along the ramp only the dynamics tell of it; level axes show its direction.
        assert estimate.std_error < (0.001 if level else 0.004)
    assert inside == 8
    # A mean square of 1, to about √(2/8).
    assert 0.1 < np.mean(np.square(pulls)) < 1.0 + 4.0 * math.sqrt(2 / 8)


def test_a_level_camera_on_a_level_plane_changes_nothing(hoop, guess):
    track = tracked(hoop.simulate(**THROW), 2)
    level = lw.Track(track.time, theta=track.theta, x=track.x, level=True)
    found = [lw.fit(one, guess, slips_at_start=True).estimates for one in (track, level)]
    assert found[0] == found[1]


def test_bad_tracks_are_refused(tmp_path, hoop):
    with pytest.raises(ValueError, match=r"time\[2\] = 1.0 must be greater than time\[1\] = 1.0"):
        lw.Track([0.0, 1.0, 1.0], theta=[0, 0, 0])
    with pytest.raises(ValueError, match="theta or x"):
        lw.Track([0.0, 1.0])
    with pytest.raises(ValueError, match="shape"):
        lw.Track([0.0, 1.0], theta=[0.0])
    with pytest.raises(ValueError, match="not enough for 7 unknowns"):
        lw.fit(lw.Track([0.0, 1.0, 2.0], theta=[0, 0.1, 0.2], x=[0, 0, 0.0]), hoop)
    with pytest.raises(ValueError, match="must name some of"):
        lw.fit(lw.Track([0.0, 1.0], theta=[0.0, 0.1]), hoop, free=["colour"])
    path = tmp_path / "video.csv"
    path.write_text("time,theta_rad\n0,1\n1,2\n")
    with pytest.raises(ValueError, match="line 1, column theta_rad: is in SI units"):
        lw.Track.from_csv(path)
    path.write_text("theta\n1\n2\n")
    with pytest.raises(ValueError, match="no column time"):
        lw.Track.from_csv(path)


def test_residuals_are_plotted(hoop, guess):
    result = lw.fit(tracked(hoop.simulate(**THROW), 2), guess, slips_at_start=True)
    figure = result.plot()
    above, _, below, right = figure.axes
    assert below.get_ylabel() == "residual of *θ*  (rad)"
    assert right.get_xlabel() == "*τ*  (√(*R*/*g*))"
    points = [line for line in below.get_lines() if line.get_marker() == "o"]
    np.testing.assert_array_equal(points[0].get_ydata(), result.residuals["theta"])
    assert any(line.get_label() == "measured" for line in above.get_lines())
    assert "reduced χ²" in result._repr_html_()


# Through slips, a lift-off and bounces; a level camera on a ramp, and one that is turned and whose
# pictures are exposed for a while.
@pytest.mark.parametrize("level", [False, True])
@pytest.mark.parametrize("camera", [("turn", "scale"), ("perspective_y", "marker", "exposure")])
def test_exact_derivatives_of_the_residuals_are_their_differences(level, camera):
    hoop = lw.Hoop(
        mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, slope=0.1, restitution=0.5
    )
    motion = hoop.simulate(theta=2.5, theta_rate=3)
    causes = [one.cause for one in motion.transitions]
    assert causes[:4] == ["slip", "lift_off", "landing", "landing"]
    # No frame is at an impact, where a velocity has two values.
    bounces = [one.time for one in motion.transitions[2:4]]
    time = np.linspace(0.0, np.mean(bounces), 60)
    seen = motion(time)
    track = lw.Track(time, theta=seen.theta, x=seen.x, y=seen.centre_y, level=level)
    names = ("mu_s", "mu_k", "inertia", "restitution", "slope", "start_theta")
    names += ("start_theta_rate", "start_x")
    first = {"theta": 2.5, "theta_rate": 3.0, "slip": 0.0, "x": 0.0}
    problem = Problem(track, hoop, names, first, dict.fromkeys(track.channels, Noise(1.0)), False)
    problem, unknowns = problem.with_camera(camera, problem.guess())
    unknowns[len(names) :] = (0.02, 0.01, 0.03)[: len(camera)]
    # All are those of the motion; none is a difference.
    assert all(
        np.isfinite(rows).all() for rows in problem._exact(problem.values(unknowns)).values()
    )
    found = problem.derivatives(unknowns)
    for k in range(unknowns.size):
        step = 1e-5 * np.eye(unknowns.size)[k]
        above, below = problem.residuals(unknowns + step), problem.residuals(unknowns - step)
        for name in found:
            difference = (above[name] - below[name]) / 2e-5
            # An exposure with an impact in it is a sum whose pieces move.
            np.testing.assert_allclose(found[name][:, k], difference, atol=2e-6)


def test_three_frames_are_enough_for_five_unknowns(hoop):
    time = np.array([0.0, 0.1, 0.2])
    seen = hoop.simulate(theta=2.5, theta_rate=3)(time)
    track = lw.Track(time, theta=seen.theta, x=seen.x)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        result = lw.fit(track, hoop, free=("mu_k",), slips_at_start=True)
    assert result.start.theta_rate == pytest.approx(3.0, abs=0.1)


def test_a_track_that_never_leaves_the_floor_is_given_no_bounces():
    """It was fitted as bounces too low to be seen; and as a start that slips, which rolls."""
    known = {"mass_ratio": 0.304332, "offset": 0.935033, "mu_s": 0.28737, "mu_k": 0.23889}
    motion = lw.Hoop(**known, inertia=0.273046).simulate(theta=-2.3988, theta_rate=-1.87994)
    assert motion.sequence.startswith("+R-R+R-R")
    track = tracked(motion, 1, count=320, end=9.0, channels=("theta", "x", "y"))
    first = lw.Hoop(mass_ratio=0.304332, offset=0.935033, inertia=0.304332, mu_s=0.5, mu_k=0.3)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        result = lw.fit(track, first, free=RESTITUTION, slips_at_start=True)
    true = motion.hoop.simulate(theta=-2.3988, theta_rate=-1.87994, until=9.0).sequence
    assert result.sequences[true] > 0.01
    assert not any("F" in sequence for sequence in result.sequences)
    assert not result.estimates["restitution"].identifiable
    for name in ("mu_s", "mu_k", "inertia"):
        estimate = result.estimates[name]
        assert abs(estimate.value - getattr(motion.hoop, name)) < 4.0 * estimate.std_error < 0.1


CHI = 0.01


def swings(chi, **more):
    """A motion that slides, rolls and slips several times, and never flies."""
    hoop = lw.Hoop(
        mass_ratio=1, offset=0.9, inertia=0.93, mu_s=0.5, mu_k=0.4, rolling_resistance=chi, **more
    )
    return hoop.simulate(theta=0.5, theta_rate=0.3, slip=-2.0, until=8.0)


@pytest.mark.filterwarnings("ignore:interval")
@pytest.mark.parametrize("chi", [0.0, 0.002, CHI])
def test_rolling_resistance_is_found_within_its_interval(chi):
    motion = swings(chi)
    pulls, inside = [], 0
    for seed in range(6):
        track = tracked(motion, seed, count=150, end=8.0)
        start = {"theta": 0.5, "theta_rate": 0.3, "slip": -2.0}
        known = dataclasses.replace(motion.hoop, rolling_resistance=0.0)
        result = lw.fit(track, known, slips_at_start=True, start=start, search=False)
        estimate = result.estimates["rolling_resistance"]
        assert estimate.identifiable and estimate.std_error < 0.001 and estimate.value >= 0.0
        assert result.hoop.rolling_resistance == estimate.value
        assert {doubt.name for doubt in result.doubts} <= {"interval", "unseen"}
        pulls.append((estimate.value - chi) / estimate.std_error)
        low, high = result.profile_interval("rolling_resistance", 0.999)
        inside += max(low, 0.0) <= chi <= high
    assert inside == 6
    # A mean square of 1, to about √(2/6); half of that where it cannot be negative.
    assert np.mean(np.square(pulls)) < 1.0 + 4.0 * math.sqrt(2 / 6)


@pytest.mark.parametrize("mean", [3.0, 0.4, 0.0, -1.3, -15.0, -25.0])
def test_what_is_positive_and_has_a_normal_error(mean):
    """Against a sum over its density."""
    size, value = 0.01, max(mean, 0.0) * 0.01
    at = 12.0 * size / max(1.0, -0.2 * mean) * (np.arange(200_000) + 0.5) / 200_000
    density = np.exp(-0.5 * np.square(at / size - mean) + 0.5 * min(mean, 0.0) ** 2)
    expected = float(np.sum(density * np.square(at - value)) / np.sum(density))
    found = least_squares._square_above_nothing(mean * size, size, value)
    # What the tail of an exponential distribution leaves out is 6/400 of it.
    assert found == pytest.approx(expected, rel=0.02 if mean < -20.0 else 1e-4)


def test_a_held_rolling_resistance_that_is_wrong_is_named():
    """A fit of a hoop that loses energy was wrong by friction and inertia, in silence."""
    track = tracked(swings(CHI), 1, count=150, end=8.0)
    start = {"theta": 0.5, "theta_rate": 0.3, "slip": -2.0}
    with pytest.warns(lw.fitting.FitWarning) as caught:
        lw.fit(
            track,
            dataclasses.replace(swings(CHI).hoop, rolling_resistance=0.0),
            free=("mu_s", "mu_k", "inertia"),
            slips_at_start=True,
            start=start,
            search=False,
        )
    held = [one.message.doubt for one in caught if one.message.doubt.name == "held"]
    assert held[0].parameters[0] == "rolling_resistance"
    assert "free" in held[0].message
    # Nobody is asked for a hoop that gains by rolling.
    uphill = tracked(swings(0.0, slope=0.01), 1, count=150, end=8.0)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        lw.fit(
            uphill,
            swings(0.0).hoop,
            free=("inertia",),
            slips_at_start=True,
            start=start,
            search=False,
        )
    for one in caught:
        assert "rolling_resistance -" not in str(one.message)


def test_on_a_ramp_that_is_only_rolled_down_slope_and_resistance_are_one():
    """A disc tells them apart only where it rolls up and down."""
    ramp = lw.Hoop(
        mass_ratio=1,
        offset=0.05,
        inertia=0.9,
        mu_s=0.5,
        mu_k=0.4,
        slope=-0.05,
        rolling_resistance=CHI,
    )
    free = ("inertia", "rolling_resistance", "slope")
    for rate, end, are_told in ((0.0, 7.0, False), (0.3, 30.0, True)):
        start = {"theta": 0.5, "theta_rate": rate}
        track = tracked(ramp.simulate(**start), 3, count=400, end=end)
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            result = lw.fit(track, ramp, free=free, start=start, search=False)
        words = [
            str(one.message)
            for one in caught
            if isinstance(one.message, lw.fitting.IdentifiabilityWarning)
        ]
        assert result.estimates["rolling_resistance"].identifiable == are_told
        assert bool(words) != are_told
        if not are_told:
            assert "roll up and down" in words[0]
            # What is not told widens the interval of the slope.
            assert 0.02 < result.estimates["slope"].std_error < 0.1


def test_a_flight_says_nothing_of_rolling_resistance():
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4, rolling_resistance=CHI)
    start = {"theta": 0.0, "theta_rate": 2.0}
    thrown = hoop.simulate(**start)
    assert thrown.sequence == "F"
    track = tracked(thrown, 0, count=60, channels=("theta", "x", "y"))
    with pytest.warns(lw.fitting.IdentifiabilityWarning, match="rolling_resistance .the hoop"):
        result = lw.fit(track, hoop, free=("rolling_resistance",), start=start, search=False)
    assert result.estimates["rolling_resistance"].std_error == math.inf
