"""`littlewood fit`: from the file of a film, or of a tracker, to the report."""

import base64
import builtins
import dataclasses
import inspect
import math
import os
import re
import shutil
import struct
import subprocess
import sys
import warnings
from pathlib import Path

import cv2
import numpy as np
import pytest

import littlewood as lw
from littlewood import video
from littlewood._commands import fit as fit_command
from littlewood._commands.fit import MissingAnswerError, WrongClockError, _check_clock, main
from littlewood.fitting import Doubt, report
from littlewood.fitting.fall import fall_of
from littlewood.fitting.report import report_html
from littlewood.fitting.shares import shares
from littlewood.fitting.table_options import PYTHON

CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium")
RATE = 120.0
KNOWN = {"disc_mass_kg": 0.25, "particle_mass_kg": 0.25, "radius_m": 0.3, "offset_m": 0.27}
TRUE = {"mu_s": 0.5, "mu_k": 0.4, "inertia": 0.9344, "restitution": 0.5}
CAMERA = video.Camera(
    (-1.0, 0.8, 3.4), (-1.2, 0.35, 0.0), focal_px=330.0, width=360, height=200, roll_rad=0.03
)
FLAGS = [f"--{name.replace('_', '-')}={value}" for name, value in KNOWN.items()]


@pytest.fixture(scope="module")
def motion():
    true = lw.Hoop.from_si(
        **KNOWN, inertia_kg_m2=0.25 * 0.29**2, mu_s=0.5, mu_k=0.4, restitution=0.5
    )
    assert true.inertia == pytest.approx(TRUE["inertia"], abs=1e-4)
    return true.simulate(theta=math.pi / 2, theta_rate=2.0)


@pytest.fixture(scope="module")
def film(motion, tmp_path_factory):
    path = tmp_path_factory.mktemp("films") / "film.avi"
    video.synthetic_video(path, motion, CAMERA, fps=RATE, exposure_s=1 / 500, seconds=0.75)
    return path


def estimates(text):
    """Values and standard errors of a printed table, or of the text of a page."""
    found = re.findall(r"^(\w+) +(-?[\d.]+) ± ([\d.]+)$", text, re.MULTILINE)
    return {name: (float(value), float(error)) for name, value, error in found}


def test_a_film_becomes_a_report(film, tmp_path, capsys):
    out = tmp_path / "page.html"
    assert main([str(film), f"--rate={RATE}", "--slope=0", *FLAGS, f"--out={out}"]) == 0
    said = capsys.readouterr()
    found = estimates(said.out)
    for name, true in TRUE.items():
        value, error = found[name]
        # Four standard errors, and those are small.
        assert abs(value - true) < 4.0 * error < 0.08, name
    assert "doubt" not in said.out
    assert str(out) in said.err and str(out.with_suffix(".jpg")) in said.err
    page = out.read_text(encoding="utf-8")
    # It holds all that it shows: no other file, no script.
    assert not re.findall(r'(?:src|href)="(?!data:)', page) and "<script" not in page
    pictures = re.findall(r'src="data:image/(jpeg|svg\+xml);base64,([^"]*)"', page)
    assert [kind for kind, _ in pictures] == ["jpeg", *["svg+xml"] * 4]
    assert base64.b64decode(pictures[0][1]) == out.with_suffix(".jpg").read_bytes()
    assert "@page { size: A4" in page and "What your hoop would do with more friction" in page
    assert "The fit has no doubts" in page


def test_the_picture_shows_hoop_track_and_floor(film, motion):
    plane = video.Plane.from_camera(CAMERA)
    track = lw.track_video(film, motion.hoop, plane=plane, fps=RATE)
    picture = video.overlay_picture(film, motion, plane=plane, fps=RATE, track=track, count=4)
    still, _ = video.tracking.median_and_noise(video.tracking.frames_all_over(film, 0, None))
    assert picture.shape == still.shape
    violet = np.array(
        [int(lw.style.ACCENTS["violet"].lstrip("#")[k : k + 2], 16) for k in (4, 2, 0)]
    )
    is_violet = np.abs(picture.astype(int) - violet).max(axis=2) < 40
    for k in range(0, 60, 7):
        sample = motion(track.time[k])
        u, v = plane.to_pixels(0.3 * float(sample.x), 0.3 * float(sample.centre_y))
        assert is_violet[
            round(float(v)) - 1 : round(float(v)) + 2, round(float(u)) - 1 : round(float(u)) + 2
        ].any()
    # The floor, where no hoop is.
    u, v = plane.to_pixels(0.45, 0.0)
    assert is_violet[round(float(v)) - 1 : round(float(v)) + 2, round(float(u))].any()


def test_the_hoop_is_the_ruler(film, motion):
    true, found = video.Plane.from_camera(CAMERA), video.find_plane(film, 0.3)
    x, y = np.meshgrid(np.linspace(-2.2, 0.2, 9), np.linspace(0.05, 0.6, 4))
    across, up = found.to_metres(*true.to_pixels(x.ravel(), y.ravel()))
    # The size of the rim, 32 pixels, is told to a third of a pixel, and with it the scale to a per
    # cent.
    scale = float(across @ x.ravel() / (x.ravel() @ x.ravel()))
    assert abs(scale - 1.0) < 0.01
    # But for the scale it is the true plane, to a pixel: x = 0 is the first place of the hoop, y =
    # 0 the floor.
    there, here = true.to_pixels(across / scale, up / scale), true.to_pixels(x.ravel(), y.ravel())
    assert np.max(np.hypot(there[0] - here[0], there[1] - here[1])) < 1.0


def test_points_may_be_measured_instead(film, tmp_path, capsys):
    plane = video.Plane.from_camera(CAMERA)
    points = []
    for x, y in [(-2.2, 0.0), (0.2, 0.0), (0.2, 0.8), (-2.2, 0.8)]:
        u, v = plane.to_pixels(x, y)
        points += ["--point", f"{float(u)}", f"{float(v)}", f"{x}", f"{y}"]
    out = tmp_path / "page.html"
    free = [
        "--free",
        "mu_k",
        "--mu-s=0.5",
        "--inertia-kg-m2=0.021025",
        "--restitution=0.5",
        "--last=60",
    ]
    assert (
        main([str(film), f"--rate={RATE}", "--slope=0", *FLAGS, *points, *free, f"--out={out}"])
        == 0
    )
    value, error = estimates(capsys.readouterr().out)["mu_k"]
    assert abs(value - 0.4) < 4.0 * error < 0.02


def test_a_table_of_a_tracker_makes_the_same_report(motion, tmp_path, capsys):
    units = motion.hoop.units
    seconds = np.arange(0.0, 0.6, 1 / RATE)
    seen = motion(seconds / units.time_s).in_si(units)
    random = np.random.default_rng(3)
    table = tmp_path / "track.csv"
    columns = [seconds, np.degrees(seen["theta_rad"]) + random.normal(0, 0.3, seconds.size)]
    columns.append(seen["x_m"] + random.normal(0, 0.001, seconds.size))
    np.savetxt(
        table, np.column_stack(columns), delimiter=",", header="time_s,theta_deg,x_m", comments=""
    )
    free = ["--free", "mu_k", "--mu-s=0.5", "--inertia-kg-m2=0.021025", "--slope-deg=0"]
    assert main([str(table), *FLAGS, *free]) == 0
    value, error = estimates(capsys.readouterr().out)["mu_k"]
    assert abs(value - 0.4) < 4.0 * error < 0.1
    page = (tmp_path / "track-report.html").read_text(encoding="utf-8")
    assert page.count("<img") == 4 and not (tmp_path / "track-report.jpg").exists()


def refused(capsys, *arguments):
    """The last line of what it says where it ends with 2."""
    assert main([str(one) for one in arguments]) == 2
    said = capsys.readouterr()
    assert said.out == ""
    return said.err.splitlines()[-1]


def test_hints_on_tables_are_flags_and_lead_to_the_fit(motion, tmp_path, capsys):
    units = motion.hoop.units
    seconds = np.arange(0.0, 0.6, 1 / RATE)
    seen = motion(seconds / units.time_s).in_si(units)
    x, y, theta = (seen[name] for name in ("x_m", "centre_y_m", "theta_rad"))
    random = np.random.default_rng(5)
    places = [x, y, x - 0.27 * np.sin(theta), y + 0.27 * np.cos(theta)]
    places = [1e2 * (one + random.normal(0, 0.001, seconds.size)) for one in places]
    # As Kinovea has it, in milliseconds and centimetres, with a column of one's own.
    table = tmp_path / "track.csv"
    names = "Time,my note,Hub/0/X,Hub/0/Y,Spot/0/X,Spot/0/Y"
    # From the calendar on, as a computer counts.
    rows = np.column_stack([1e3 * (1764331234.5 + seconds), seconds, *places])
    np.savetxt(table, rows, delimiter=",", header=names, comments="")
    free = ["--free", "mu_k", "--mu-s=0.5", "--inertia-kg-m2=0.021025", "--slope-deg=0"]
    given = [table, *FLAGS, *free]
    for said, answer in [
        ("; --ignore 'my note' passes over it", ["--ignore", "my note"]),
        ("; say it: --time-unit ms (120 a second)", ["--time-unit=ms"]),
        ("--length-unit cm; or give the plane of the motion", ["--length-unit=cm"]),
    ]:
        assert said in refused(capsys, *given)
        given += answer
    assert main([str(one) for one in given]) == 0
    printed = capsys.readouterr()
    assert "note: The times of the table count from its first row, 1.7643" in printed.err
    value, error = estimates(printed.out)["mu_k"]
    assert abs(value - 0.4) < 4.0 * error < 0.1


def test_each_option_of_a_table_has_a_flag():
    assert set(fit_command._FLAGS.forms) == set(PYTHON.forms)
    options = set(inspect.signature(lw.Track.from_csv).parameters)
    flags = fit_command._parser().format_help()
    for name, form in PYTHON.forms.items():
        assert name in options and form.startswith(f"{name}=")
        assert f"{fit_command._FLAGS.forms[name].split()[0].rstrip(',')} " in flags


def test_without_a_terminal_nothing_is_asked(film, capsys):
    slope = "--slope=0"
    assert refused(capsys, film, slope, *FLAGS).startswith(
        "error: --rate is missing: Frames a second at which"
    )
    assert "it is played at 30" in refused(capsys, film, slope, *FLAGS)
    for k, name in enumerate(KNOWN):
        rest = [*FLAGS[:k], *FLAGS[k + 1 :]]
        flag = "--" + name.replace("_", "-")
        assert refused(capsys, film, slope, f"--rate={RATE}", *rest).startswith(
            f"error: {flag} is missing: "
        )
    assert "--slope-deg is missing" in refused(capsys, film, f"--rate={RATE}", *FLAGS)


def test_at_a_terminal_it_asks(monkeypatch, capsys):
    class Terminal:
        def isatty(self):
            return True

    asked, answers = [], iter(["", "two", "0,25", "0.25", "0.3", "0.27", "5"])

    def answer(question):
        asked.append(question)
        return next(answers)

    monkeypatch.setattr(sys, "stdin", Terminal())
    monkeypatch.setattr(builtins, "input", answer)
    assert fit_command._ask("Rate", "--rate", 30.0) == 30.0
    hoop = fit_command._hoop_of(fit_command._parser().parse_args(["film.mp4"]))
    assert (hoop.mass_ratio, hoop.offset, hoop.units.length_m) == (1.0, pytest.approx(0.9), 0.3)
    assert hoop.slope == pytest.approx(math.radians(5.0))
    # A thin rim, until the fit says what it is.
    assert hoop.inertia == pytest.approx(1.0)
    assert asked[0] == "Rate [30]: " and asked[1].startswith("Mass m1 of the disc or hoop, kg")
    assert "'two' is not a number" in capsys.readouterr().err
    monkeypatch.setattr(builtins, "input", lambda question: "x")
    with pytest.raises(MissingAnswerError) as caught:
        fit_command._ask("Rate", "--rate")
    assert caught.value.flag == "--rate"


def test_a_slow_motion_film_with_the_rate_of_its_file(film, capsys):
    said = refused(capsys, film, "--rate=30", "--slope=0", *FLAGS)
    fall = re.search(r"falls with (\S+) ± \S+ g, so the clock is (\d+) ± \S+ % off", said)
    # A sixteenth, to the errors of the places.
    assert float(fall[1]) == pytest.approx((30 / RATE) ** 2, rel=0.05)
    assert int(fall[2]) == pytest.approx(75, abs=2)
    rate = re.search(r"was the film taken at about (\d+) frames a second \(--rate\)", said)
    assert int(rate[1]) == pytest.approx(RATE, abs=3)


@pytest.mark.parametrize("slope,level", [(0.0, False), (0.15, False), (0.15, True)])
def test_a_clock_that_is_wrong_is_named_with_its_size(motion, slope, level, capsys):
    """Two flights with landings between frames; lengths may be wrong by a per cent."""
    hoop = dataclasses.replace(motion.hoop, units=motion.hoop.units, slope=slope)
    thrown = hoop.simulate(theta=math.pi / 2, theta_rate=2.0)
    time = np.arange(0.0, 5.0, 1.0 / RATE / hoop.units.time_s)
    seen = thrown(time)
    assert sum(one.impact is not None for one in thrown.transitions if one.time < 5.0) >= 2
    noise = np.random.default_rng(1).normal(0.0, 0.003, (3, time.size))
    plane = {"theta": seen.theta, "x": seen.x, "y": seen.centre_y}
    shown = lw.Track(time, theta=time, level=level).as_seen(plane, slope)
    noisy = {name: shown[name] + noise[k] for k, name in enumerate(shown)}
    for factor in (1.0, 1.005, 0.995):
        _check_clock(lw.Track(factor * time, **noisy, level=level), hoop, None, False)
    # What lengths that are known to 1 % leave of the clock, and these flights.
    assert (
        0.5 * 0.01 * (3.89 + 1.64)
        < fall_of(lw.Track(time, **noisy, level=level), hoop).noticed
        < 0.04
    )
    for factor in (0.96, 1.04, 0.5, 1000.0):
        wrong = lw.Track(factor * time, **noisy, level=level)
        with pytest.raises(
            WrongClockError, match=r"% off: were all times .* --any-clock"
        ) as caught:
            _check_clock(wrong, hoop, None, False)
        fall = caught.value.fall
        assert abs(fall.clock - (1.0 / factor - 1.0)) < 4.0 * fall.clock_error < 0.03 / factor
        # There is a way on, which is told.
        _check_clock(wrong, hoop, None, True)
        assert "note: in flight the mass centre falls with" in capsys.readouterr().err


TRACKS = Path(__file__).parent / "tracks"
RAMP_000 = {
    "disc_mass_kg": 0.39082,
    "particle_mass_kg": 0.32894,
    "radius_m": 0.223563,
    "offset_m": 0.19916,
}
RAMP_095 = {
    "disc_mass_kg": 0.399343,
    "particle_mass_kg": 0.456152,
    "radius_m": 0.262294,
    "offset_m": 0.24296,
}
LEVEL_192 = {
    "disc_mass_kg": 0.386548,
    "particle_mass_kg": 0.492087,
    "radius_m": 0.257638,
    "offset_m": 0.23897,
}


@pytest.mark.parametrize(
    "name,known,slope,sequence,true",
    [
        (
            "fit_on_ramp-000",
            RAMP_000,
            -0.196338,
            "+-FF",
            {"mu_k": 0.22313, "inertia": 1.17656, "restitution": 0.54733},
        ),
        (
            "fit_on_ramp-095",
            RAMP_095,
            0.134156,
            "-R+FFF",
            {"inertia": 0.82731, "restitution": 0.69782},
        ),
        # It rolls at the start; a slip there once made another sequence.
        (
            "none-192",
            LEVEL_192,
            0.0,
            "R-R+F",
            {"mu_s": 0.53055, "mu_k": 0.39280, "inertia": 0.77434},
        ),
    ],
)
def test_good_tracks_that_were_refused(name, known, slope, sequence, true):
    """Two flights were taken for one, or an error of 0.5 g for a fact."""
    flags = [f"--{one.replace('_', '-')}={value}" for one, value in known.items()]
    options = fit_command._parser().parse_args(["track.csv", f"--slope={slope}", *flags])
    hoop = fit_command._hoop_of(options)
    track = lw.Track.from_csv(TRACKS / f"{name}.csv", hoop.units)
    fall = fall_of(track, hoop)
    assert abs(fall.gravity - 1.0) < 4.0 * fall.std_error
    result = fit_command._fit(options, track, hoop, False)
    assert result.motion.sequence == sequence
    assert {doubt.name for doubt in result.doubts} <= {"identifiability", "interval", "unseen"}
    for one, value in true.items():
        estimate = result.estimates[one]
        # A rolling resistance that the track does not tell widens them.
        assert abs(estimate.value - value) < 4.0 * estimate.std_error < 0.1, one


def test_bounces_that_were_one_flight():
    """At 30 frames a second landings are between frames; it was refused as 0.26 g."""
    hoop = lw.Hoop.from_si(**KNOWN, inertia_kg_m2=0.02, mu_s=0.5, mu_k=0.3)
    track = lw.Track.from_csv(TRACKS / "good-bounces-30fps.csv", hoop.units)
    _check_clock(track, hoop, None, False)
    fall = fall_of(track, hoop)
    assert abs(fall.gravity - 1.0) < 4.0 * fall.std_error < 0.1


def test_a_floor_without_flights_says_nothing_of_the_clock(motion):
    time = np.linspace(0.0, 20.0, 200)
    rolled = motion.hoop.simulate(theta=3.0, theta_rate=0.0)(time)
    shown = {"theta": rolled.theta, "y": rolled.centre_y + 0.012 * np.sin(time)}
    assert fall_of(lw.Track(time, **shown), motion.hoop) is None
    assert fall_of(lw.Track(time, x=rolled.x, y=shown["y"]), motion.hoop) is None


def written(path, frames):
    frames = iter(frames)
    first = next(frames)
    with video.files.FrameWriter(path, (first.shape[1], first.shape[0])) as writer:
        writer.write(first)
        for frame in frames:
            writer.write(frame)
    return path


def with_capture_rate(path, rate):
    """Say in a film, as telephones do, at which rate it was taken."""

    def box(kind, *content):
        inner = b"".join(content)
        return struct.pack(">I4s", 8 + len(inner), kind) + inner

    key = box(b"mdta", b"com.android.capture.fps")
    value = box(b"data", struct.pack(">IIf", 23, 0, rate))
    meta = box(
        b"meta",
        box(b"hdlr", bytes(8), b"mdta", bytes(13)),
        box(b"keys", struct.pack(">II", 0, 1), key),
        box(b"ilst", box(struct.pack(">I", 1), value)),
    )
    content = path.read_bytes()
    # The movie is the last box.
    begin = content.rindex(b"moov") - 4
    path.write_bytes(content[:begin] + box(b"moov", content[begin + 8 :], meta))


def test_the_rate_that_a_telephone_says_is_not_asked_for(film, tmp_path, capsys):
    slow = tmp_path / "slow.mp4"
    written(slow, video.frames(film))
    with_capture_rate(slow, RATE)
    out = tmp_path / "page.html"
    free = ["--free", "mu_k", "--mu-s=0.5", "--inertia-kg-m2=0.021025", "--restitution=0.5"]
    given = [str(slow), "--slope=0", *FLAGS, *free, f"--out={out}", "--last=60"]
    assert main(given) == 0
    said = capsys.readouterr()
    note = "played at 30 a second and taken at 120, as the file says (com.android.capture.fps)."
    assert note in said.err and note in out.read_text(encoding="utf-8")
    value, error = estimates(said.out)["mu_k"]
    assert abs(value - 0.4) < 4.0 * error < 0.04
    # Another rate that is given counts, and is told.
    assert main([*given, "--rate=118"]) == 0
    assert "note: The film has 91 frames, played at 30 a second and taken at 118, as was said." in (
        capsys.readouterr().err
    )
    assert "falls with" in refused(capsys, *given, "--last=90", "--rate=60")


def test_films_that_cannot_be_used(film, motion, tmp_path, capsys):
    given = [f"--rate={RATE}", "--slope=0", *FLAGS]
    random = np.random.default_rng(1)
    empty = (random.integers(120, 136, (200, 360, 3)).astype(np.uint8) for _ in range(30))
    said = refused(capsys, written(tmp_path / "empty.avi", empty), *given)
    assert "the hoop was found in 0 of" in said
    # A marker of another colour than was said; and one that hides after the first frames.
    assert "the marker was found in" in refused(capsys, film, *given, "--marker=green")
    look = video.Look(marker=video.Look().hoop)
    shown = video.synthetic_frames(motion, CAMERA, fps=RATE, seconds=0.1)
    hidden = list(video.synthetic_frames(motion, CAMERA, fps=RATE, seconds=0.75, look=look))
    said = refused(capsys, written(tmp_path / "lost.avi", [*shown, *hidden[13:]]), *given)
    found = re.search(r"the marker was found in (\d+) of (\d+) frames", said)
    assert 10 <= int(found[1]) <= 20 and int(found[2]) > 60
    broken = tmp_path / "broken.mp4"
    broken.write_bytes(b"no film" * 100)
    assert "cannot decode" in refused(capsys, broken, *given)
    assert "no such file" in refused(capsys, tmp_path / "none.mp4", *given)
    assert "none.csv" in refused(capsys, tmp_path / "none.csv", *given)
    assert "no such folder" in refused(
        capsys, film, *given, f"--out={tmp_path / 'nowhere' / 'page.html'}"
    )
    assert "radius_m = -1 m must be greater than 0" in refused(
        capsys, film, *given, "--radius-m=-1"
    )
    for flags in (["--rate=0"], ["--rate=inf"], ["--free", "colour"]):
        with pytest.raises(SystemExit) as caught:
            main([str(film), *given, *flags])
        assert caught.value.code == 2
    assert "must be one of red" in refused(capsys, film, *given, "--marker=beige")
    assert "8 frames are too few" in refused(capsys, film, *given, "--last=8")


def test_a_report_with_all_doubts_names_them(motion):
    time = np.linspace(0.0, 2.0, 150)
    seen = motion(time)
    track = lw.Track(time, theta=seen.theta, x=1.05 * seen.x + 0.02 * np.sin(6 * time))
    with pytest.warns(lw.fitting.FitWarning):
        result = lw.fit(track, motion.hoop, free=("mu_k",), search=False)
    assert result.doubts
    page = report_html(result, title="A <hoop>")
    for doubt in result.doubts:
        assert f"Doubt: {doubt.name}." in page
    assert "No flight tells the clock" in page
    assert "A &lt;hoop&gt;" in page and "The fit has no doubts" not in page


def test_a_report_says_nothing_by_what_the_motion_does_not_tell():
    """It multiplied a coefficient of static friction of 11 that no slip had shown."""
    hoop = lw.Hoop.from_si(**KNOWN, inertia_kg_m2=0.021, mu_s=0.5, mu_k=0.4)
    slide = hoop.simulate(theta=0.5, theta_rate=0.3, slip=-2.0)
    assert slide.sequence.startswith("-R+")
    begins = [one.time for one in slide.transitions]
    random = np.random.default_rng(1)
    for part, tells in ((0.5 * (begins[0] + begins[1]), False), (begins[2], True)):
        time = np.linspace(0.0, part, 150)
        seen, noise = slide(time), random.normal(0.0, 0.003, (2, time.size))
        track = lw.Track(time, theta=seen.theta + noise[0], x=seen.x + noise[1])
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", lw.fitting.FitWarning)
            start = {"theta": 0.5, "theta_rate": 0.3, "slip": -2.0}
            result = lw.fit(track, hoop, slips_at_start=True, start=start, search=False)
        assert result.estimates["mu_s"].identifiable == tells
        assert ("half as much friction more" in report._sentence(result)) == tells
        parts = shares(result)
        assert set(parts) == {
            name
            for name in ("mu_s", "mu_k", "inertia", "rolling_resistance")
            if result.estimates[name].identifiable
        }
        for one in parts.values():
            assert one.shape == time.shape and one.sum() == pytest.approx(1.0)
        # Nothing but the slide tells kinetic friction, and what follows where it ends.
        assert parts["mu_k"][time < 0.1 * begins[0]].sum() > 0.01
    # What tells static friction is what follows the slip out of rolling.
    assert parts["mu_s"][time > begins[1]].sum() > 0.5


def test_a_report_of_rolling_alone_has_a_map_without_a_mark(monkeypatch):
    """It ended in a TypeError where neither coefficient of friction is known."""
    monkeypatch.setattr(report, "_GRID", (4, 3))
    hoop = lw.Hoop.from_si(**KNOWN, inertia_kg_m2=0.021, mu_s=0.9, mu_k=0.8)
    rolling, random = hoop.simulate(theta=2.5, theta_rate=0.5), np.random.default_rng(1)
    time = np.linspace(0.0, 8.0, 150)
    seen, noise = rolling(time), random.normal(0.0, 0.003, (2, time.size))
    track = lw.Track(time, theta=seen.theta + noise[0], x=seen.x + noise[1])
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        start = {"theta": 2.5, "theta_rate": 0.5}
        result = lw.fit(track, hoop, start=start, search=False)
    assert not any(result.estimates[name].identifiable for name in ("mu_s", "mu_k"))
    page = report_html(result, title="rolling")
    assert "With μₛ = μₖ = μ, up to the first landing" in page and "yours" not in page
    assert "so that only μₛ ≥ " in page and "mu_s" not in page
    assert "Izz (kg m²)" in page
    assert "the same over m₂R²" in page


@pytest.mark.parametrize("frames", [30, 61, 109, 120, 121])
def test_columns_of_the_picture_have_frames_each(frames):
    """Columns as wide as the time between frames had two of them or none, by rounding."""
    counts = np.diff([*report._firsts(frames), frames])
    assert np.all(counts[:-1] == counts[0]) and 0 < counts[-1] <= counts[0]
    assert counts.size <= 60


@pytest.mark.skipif(CHROMIUM is None, reason="no Chromium, which prints")
def test_a_report_prints_on_one_sheet_with_any_number_of_doubts(motion, tmp_path):
    time = np.linspace(0.0, 4.0, 120)
    seen = motion(time)
    clock = video.Clock(np.array([0.0, 0.1, 0.5]), 10.0, 240.0, 3, 1, False)
    notes = (*clock.facts(120.0), *clock.doubts(120.0))
    assert len(notes) == 4
    track = lw.Track(time, theta=seen.theta, x=seen.x, y=seen.centre_y, notes=notes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.FitWarning)
        free = ("mu_s", "mu_k", "inertia", "restitution")
        result = lw.fit(
            track, motion.hoop, free=free, search=False, sigma=dict.fromkeys(track.channels, 0.01)
        )
    frame = next(iter(video.synthetic_frames(motion, CAMERA)))
    photo = cv2.imencode(".jpg", frame)[1].tobytes()
    for count in (0, 12):
        doubt = Doubt(
            "structure",
            "residuals of theta come in waves, and this is said in more words than usual. " * 3,
        )
        page = tmp_path / f"{count}.html"
        doubted = dataclasses.replace(result, doubts=(doubt,) * count)
        page.write_text(report_html(doubted, title="A hoop", photo=photo), encoding="utf-8")
        printed = page.with_suffix(".pdf")
        flags = [
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--no-pdf-header-footer",
            f"--print-to-pdf={printed}",
        ]
        subprocess.run(
            [CHROMIUM, *flags, page.as_uri()], check=True, capture_output=True, timeout=120
        )
        assert len(re.findall(rb"/Type\s*/Page\b", printed.read_bytes())) == 1
