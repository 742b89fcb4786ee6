"""Tracks in files: exports of trackers as they are, and what is refused."""

import math
import os
import re
from pathlib import Path

import numpy as np
import pytest

import littlewood as lw
from littlewood._commands import fit as fit_command
from littlewood.certify import __main__ as certify
from littlewood.fitting import TableFileError

TRACKS = Path(__file__).parent / "tracks"
RADIUS, OFFSET = 0.3, 0.27
# The files have a hoop of this radius that rolls at 0.6 m/s, with its particle up at first, at 240
# frames a second.
TIME_S = np.arange(12) / 240.0
X_M, THETA = 0.6 * TIME_S, -2.0 * TIME_S


@pytest.fixture(scope="module")
def units():
    hoop = lw.Hoop.from_si(
        disc_mass_kg=0.25,
        particle_mass_kg=0.25,
        radius_m=RADIUS,
        offset_m=OFFSET,
        inertia_kg_m2=0.02,
        mu_s=0.5,
        mu_k=0.4,
    )
    return hoop.units


def assert_rolls(track, units, channels, *, atol=2e-6, missing=()):
    assert tuple(track.channels) == channels
    np.testing.assert_allclose(track.time * units.time_s, TIME_S, atol=6e-6)
    true = {"theta": THETA, "x": X_M / RADIUS, "y": np.ones(12)}
    for name, values in track.channels.items():
        seen = np.isfinite(values)
        assert np.flatnonzero(~seen).tolist() == list(missing if name == "theta" else ())
        np.testing.assert_allclose(values[seen], true[name][seen], atol=atol)


def test_tracker_exports_one_point_mass(units):
    assert_rolls(lw.Track.from_csv(TRACKS / "tracker.txt", units), units, ("x", "y"))


def test_tracker_exports_centre_and_marker(units):
    track = lw.Track.from_csv(TRACKS / "tracker-two.csv", units, centre="hub", marker="weight")
    assert_rolls(track, units, ("theta", "x", "y"), missing=(5,))
    # The names say it.
    assert_rolls(
        lw.Track.from_csv(TRACKS / "tracker-two.csv", units),
        units,
        ("theta", "x", "y"),
        missing=(5,),
    )


def test_tracker_separates_by_spaces(units):
    # A point that was not seen leaves its separators; names have spaces, too.
    track = lw.Track.from_csv(TRACKS / "tracker-space.txt", units)
    assert_rolls(track, units, ("theta", "x", "y"), missing=(5,))


@pytest.mark.parametrize(
    ("file", "said", "atol", "missing"),
    [
        ("kinovea.txt", {"time_unit": "s", "length_unit": "cm"}, 1e-5, ()),
        ("kinovea.txt", {"fps": 240, "length_unit": "cm"}, 1e-5, ()),
        ("kinovea.csv", {"time_unit": "s"}, 2e-6, (3,)),
        ("kinovea-milliseconds.txt", {"time_unit": "ms", "length_unit": "cm"}, 1e-5, ()),
        ("kinovea-milliseconds.txt", {"fps": 240, "length_unit": "cm"}, 1e-5, ()),
        ("kinovea-frames.csv", {"fps": 240}, 5e-6, ()),
        ("kinovea-frames.csv", {"fps": 240, "time_unit": "frame"}, 5e-6, ()),
    ],
)
def test_kinovea_exports_trajectories(units, file, said, atol, missing):
    track = lw.Track.from_csv(TRACKS / file, units, **said)
    assert_rolls(track, units, ("theta", "x", "y"), atol=atol, missing=missing)


@pytest.mark.parametrize("thousandth", ["", "0"])
def test_kinovea_exports_time_codes(tmp_path, units, thousandth):
    # Hundredths, or thousandths of films with more than 100 frames a second.
    text = (TRACKS / "kinovea-timecodes.txt").read_text(encoding="utf-8")
    path = tmp_path / "codes.txt"
    path.write_text(re.sub(r"^(0:00:00:\d\d)", rf"\g<1>{thousandth}", text, flags=re.MULTILINE))
    track = lw.Track.from_csv(path, units, length_unit="cm")
    np.testing.assert_allclose(track.time * units.time_s, 0.04 * np.arange(12), atol=1e-12)
    np.testing.assert_allclose(track.x * RADIUS, 0.6 * 0.04 * np.arange(12), atol=1e-4)


@pytest.mark.parametrize(
    ("file", "said", "message"),
    [
        (
            "kinovea.txt",
            {"length_unit": "cm"},
            r'column T: has no unit; its rows are 0.004167 apart; say it: time_unit="s" \(240 a',
        ),
        ("kinovea.csv", {}, r'column Time: has no unit; .* time_unit="s" \(240 a second\)$'),
        ("kinovea-milliseconds.txt", {}, r'are 4.167 apart; say it: time_unit="ms" \(240 a'),
        (
            "kinovea-frames.csv",
            {},
            r'1 apart; say it: time_unit="ms" \(1000 .*, or time_unit="frame" with fps=240',
        ),
        (
            "kinovea-milliseconds.txt",
            {"fps": 120},
            r'no frames at 120 a second; say it: time_unit="ms" \(240 a second\)$',
        ),
        # Whoever says a unit may be wrong, too.
        ("kinovea-milliseconds.txt", {"time_unit": "s"}, r'say it: time_unit="ms"'),
        (
            "kinovea-milliseconds.txt",
            {"time_unit": "ms"},
            r"column Y: has no unit; the lowest height of the centre is 30, the radius of the hoop "
            r'0.3 m; say it: length_unit="cm"; or give the plane',
        ),
        # Played at 30 a second, or each eighth frame: the table does not say which.
        ("kinovea.csv", {"time_unit": "s", "fps": 1920}, "8 frames at 1920 a second; leave out"),
        ("tracker.txt", {"fps": 120}, "column t: has times 0.004167 s apart, 0.5 frames at 120"),
        ("tracker.txt", {"length_unit": "mm"}, "is 0.3, 0.001 radii of the hoop; y grows upwards"),
        ("tracker.txt", {"dimensionless": True}, "is in SI units; leave out dimensionless=True"),
        ("capstone.csv", {"run": 1, "time_unit": "ms"}, 'is in s; leave out time_unit="ms"'),
    ],
)
def test_units_that_may_be_several_are_asked_for(units, file, said, message):
    with pytest.raises(TableFileError, match=message):
        lw.Track.from_csv(TRACKS / file, units, **said)


def test_capstone_exports_runs(units):
    with pytest.raises(TableFileError, match=r"has runs 1, 2; choose one: run=1"):
        lw.Track.from_csv(TRACKS / "capstone.csv", units)
    assert_rolls(lw.Track.from_csv(TRACKS / "capstone.csv", units, run=1), units, ("theta", "x"))
    second = lw.Track.from_csv(TRACKS / "capstone.csv", units, run=2)
    assert second.time.size == 8
    np.testing.assert_allclose(second.theta, 1.0 + THETA[:8], atol=2e-6)


def test_vernier_exports_data_sets(units):
    path = TRACKS / "logger-pro.csv"
    with pytest.raises(TableFileError, match=r'has runs Latest, 1; choose one: run="Latest"'):
        lw.Track.from_csv(path, units)
    with pytest.raises(TableFileError, match=r"has runs Latest, 1, run=2 is none of them"):
        lw.Track.from_csv(path, units, run=2)
    assert_rolls(lw.Track.from_csv(path, units, run="Latest"), units, ("x", "y"))
    first = lw.Track.from_csv(path, units, run=1)
    np.testing.assert_allclose(first.x, (X_M[:8] + 1.0) / RADIUS, atol=2e-6)
    track = lw.Track.from_csv(TRACKS / "graphical-analysis.csv", units)
    assert_rolls(track, units, ("x", "y"), atol=2e-6)


def test_opencv_writes_frames_and_pixels(units):
    plane = lw.video.Plane.from_ground_line((100, 300), (500, 300), 1.0)
    track = lw.Track.from_csv(TRACKS / "opencv.csv", units, fps=240, plane=plane)
    np.testing.assert_allclose(track.time * units.time_s, TIME_S + 1 / 240, atol=1e-12)
    assert np.flatnonzero(~np.isfinite(track.x)).tolist() == [7]
    seen = np.isfinite(track.x)
    np.testing.assert_allclose(track.x[seen], X_M[seen] / RADIUS, atol=1e-5)
    np.testing.assert_allclose(track.y[seen], 1.0, atol=1e-5)
    np.testing.assert_allclose(track.theta[seen], THETA[seen], atol=2e-6)


def test_a_motion_that_was_written_is_read(tmp_path, units):
    motion = lw.Hoop(mass_ratio=1, offset=0.9, inertia=1, mu_s=0.5, mu_k=0.4, units=units).simulate(
        theta=1.0, theta_rate=2.0
    )
    time = np.linspace(0.0, motion.end_time, 30)
    motion.to_pandas(time, si=True).to_csv(tmp_path / "motion.csv", index=False)
    track = lw.Track.from_csv(tmp_path / "motion.csv", units)
    np.testing.assert_allclose(track.y, motion(time).centre_y, rtol=1e-12)
    motion.to_pandas(time).to_csv(tmp_path / "plain.csv", index=False)
    np.testing.assert_array_equal(
        lw.Track.from_csv(tmp_path / "plain.csv").theta, motion(time).theta
    )


def own_table(names, columns):
    """A table of one's own, with these names over the numbers."""
    rows = [",".join(f"{value:.6f}" for value in row) for row in zip(*columns, strict=True)]
    return "\n".join([names, *rows, ""])


@pytest.mark.parametrize("names", ["time,theta,x,y", "t,theta,x,y"])
def test_names_without_units_are_in_si_if_the_sizes_say_so(tmp_path, units, names):
    path = tmp_path / "own.csv"
    height = np.full(12, RADIUS)
    path.write_text(own_table(names, [TIME_S, THETA, X_M, height]))
    assert_rolls(lw.Track.from_csv(path, units), units, ("theta", "x", "y"), atol=5e-6)
    # Of a hoop with a radius of about a metre nothing tells radii from metres; without heights
    # nothing does at all.
    for table, radius_m, message in [
        ([TIME_S, THETA, X_M, height / RADIUS], 1.1, "is 1, the radius of the hoop 1.1 m"),
        ([TIME_S, THETA, X_M, height / RADIUS], RADIUS, "is 1, the radius of the hoop 0.3 m"),
        ([TIME_S, THETA, X_M], RADIUS, "has no units, the radius of the hoop 0.3 m"),
        ([TIME_S, np.degrees(THETA), X_M, height], RADIUS, "column theta: has no unit; name it"),
        ([1e3 * TIME_S, THETA, X_M, height], RADIUS, r'say it: time_unit="ms" \(240 a second'),
        ([TIME_S, THETA, X_M, -height], RADIUS, "y grows upwards from the floor"),
    ]:
        path.write_text(own_table(",".join(names.split(",")[: len(table)]), table))
        other = lw.units.Units(0.25, radius_m, math.sqrt(radius_m / 9.8), 9.8)
        with pytest.raises(TableFileError, match=message):
            lw.Track.from_csv(path, other)
    path.write_text(own_table(names, [TIME_S, THETA, X_M / 0.6, height / 0.6]))
    large = lw.units.Units(0.25, 0.5, math.sqrt(0.5 / 9.8), 9.8)
    np.testing.assert_allclose(lw.Track.from_csv(path, large).y, 1.0, atol=1e-5)
    plain = [TIME_S / units.time_s, THETA, X_M / RADIUS, height / RADIUS]
    path.write_text(own_table(names, plain))
    for said in ({"units": units, "dimensionless": True}, {}):
        assert_rolls(lw.Track.from_csv(path, **said), units, ("theta", "x", "y"), atol=5e-6)


def test_pixels_are_known_by_their_size(tmp_path, units):
    path = tmp_path / "pixels.csv"
    u, v = 100.0 + 300.0 * X_M, np.full(12, 250.25)
    for names, columns, message in [
        ("time_s,x_m,y_m", [TIME_S, u, v], "834 radii of the hoop; name its unit"),
        ("time_s,centre/x_m,centre/y_m,marker/x_m,marker/y_m", [TIME_S, u, v, u, v + 99], "834"),
        ("frame,x,y", [np.arange(12.0), u, v], "is 250.25, the radius of the hoop 0.3 m"),
        ("frame,x,y", [np.arange(12.0), np.round(40 * u), v], "has whole numbers without a unit"),
        ("time,x,y", [TIME_S, u, v], "is 250.25, 834 radii of the hoop"),
    ]:
        path.write_text(own_table(names, columns))
        with pytest.raises(TableFileError, match=message):
            lw.Track.from_csv(path, units, fps=240)
    path.write_text("\tmass A\t\t\n" + own_table("t,x,y", [TIME_S, u, v]).replace(",", "\t"))
    with pytest.raises(TableFileError, match=r'say it: length_unit="mm"; or give the plane'):
        lw.Track.from_csv(path, units)
    # Level axes may have their origin anywhere on a ramp, but a marker is on its hoop.
    names = "time_s,centre/x_m,centre/y_m,marker/x_m,marker/y_m"
    path.write_text(own_table(names, [TIME_S, u, v, u, v + 99]))
    with pytest.raises(TableFileError, match="distance of the marker is 99, 330 radii"):
        lw.Track.from_csv(path, units, level=True)
    path.write_text(own_table("time_s,x_m,y_m", [TIME_S, X_M, X_M - 2.0]))
    assert lw.Track.from_csv(path, units, level=True).time.size == 12


def test_the_way_tells_the_unit_where_nothing_else_does(tmp_path, units):
    path = tmp_path / "way.txt"
    rows = "\n".join(f"{t:.6f}\t{2.0 * t:.6f}" for t in np.arange(100) / 240.0)
    path.write_text(f"\tmass A\t\nt\tx\t\n{rows}\n")
    track = lw.Track.from_csv(path, units)
    assert track.x[-1] == pytest.approx(2.0 * 99 / 240 / RADIUS, rel=1e-5)
    rows = "\n".join(f"{t:.6f}\t{200.0 * t:.6f}" for t in np.arange(100) / 240.0)
    path.write_text(f"\tmass A\t\nt\tx\t\n{rows}\n")
    with pytest.raises(
        TableFileError,
        match=r'column x: has no unit; the way of the centre is 82.5, .* length_unit="cm"; or give',
    ):
        lw.Track.from_csv(path, units)


def test_times_of_the_calendar_count_from_the_first(tmp_path, units):
    path = tmp_path / "unix.csv"
    for name, unit in (("time_s", 1.0), ("time_ms", 1e-3)):
        path.write_text(own_table(f"{name},x_m", [(1764331234.5 + TIME_S) / unit, X_M]))
        track = lw.Track.from_csv(path, units)
        # A double tells times of the calendar to a quarter of a microsecond.
        np.testing.assert_allclose(track.time * units.time_s, TIME_S, atol=1e-6)
        assert track.notes[0].startswith("The times of the table count from its first row, 17643")


@pytest.mark.parametrize(
    ("encoding", "separator", "mark", "end"),
    [
        ("utf-8-sig", ",", ".", "\n"),
        ("utf-16", "\t", ",", "\r\n"),
        ("utf-8", ";", ",", "\r"),
        ("utf-8", " ", ".", "\n"),
    ],
)
def test_separators_marks_and_encodings_are_found(tmp_path, encoding, separator, mark, end, units):
    rows = [["time_s", "theta_deg", "x_mm"]]
    rows += [
        [
            f"{t:.9f}".replace(".", mark),
            f"{math.degrees(a):.9f}".replace(".", mark),
            f"{1e3 * x:.9f}".replace(".", mark),
        ]
        for t, a, x in zip(TIME_S, THETA, X_M, strict=True)
    ]
    (tmp_path / "track.csv").write_bytes(
        end.join(separator.join(row) for row in rows).encode(encoding)
    )
    assert_rolls(lw.Track.from_csv(tmp_path / "track.csv", units), units, ("theta", "x"), atol=1e-8)


NAMES = {
    "a line of units": "t,Angle,x\n(s),[deg],m\n",
    "a line of units that the names have": "t (s),theta_deg,x_m\n,,m\n",
    "units over which it is": "t/s,φ / °,x / m\n",
    "words of units": "Time [sec],Angle (degrees),X (meters)\n",
    "German": "Zeit (s),Winkel (°),x (m)\n",
    "names in a comment": "# film 7\n# time_s,theta_deg,x_m\n",
}


@pytest.mark.parametrize("names", NAMES.values(), ids=NAMES)
def test_names_and_units_as_people_write_them(tmp_path, units, names):
    rows = [
        f"{t:.9f},{math.degrees(a):.9f},{x:.9f}" for t, a, x in zip(TIME_S, THETA, X_M, strict=True)
    ]
    # What people write into rows in which the point was not seen, and below the table.
    for k, mark in enumerate(("", "NaN", "#N/A", "None", "-"), start=3):
        rows[k] = f"{TIME_S[k]:.9f},{mark},{mark}"
    path = tmp_path / "own.csv"
    path.write_text("\ufeff" + names + "\n".join(rows) + "\n# tracked by hand\n", encoding="utf-8")
    track = lw.Track.from_csv(path, units)
    assert np.flatnonzero(np.isnan(track.theta)).tolist() == [3, 4, 5, 6, 7]
    seen = np.isfinite(track.theta)
    np.testing.assert_allclose(track.time * units.time_s, TIME_S, atol=1e-8)
    np.testing.assert_allclose(track.theta[seen], THETA[seen], atol=1e-8)
    np.testing.assert_allclose(track.x[seen] * units.length_m, X_M[seen], atol=1e-8)


REFUSED = {
    "a misspelt column": (
        "time_s,tehta_deg\n0,1\n",
        "line 1, column 'tehta_deg': is not a column of a track; is it theta_deg?",
    ),
    "a word for a number": (
        "time_s,theta_deg\n0,1\n0.1,abc-97.4\n",
        "line 3, column theta_deg: 'abc-97.4' is not a finite number; leave a cell empty",
    ),
    "an infinite number": (
        "time_s,x_m\n0,1\n0.1,inf\n",
        "line 3, column x_m: 'inf' is not a finite number",
    ),
    "no time": ("time_s,x_m\n0,1\n,2\n", "line 3, column time_s: '' is not a finite number"),
    "one quantity twice": (
        "time_s,theta_deg,theta_rad\n0,1,2\n",
        "line 1: theta_deg and theta_rad: two columns of one quantity; remove one",
    ),
    "a name twice": ("time_s,x_m,x_m\n0,1,2\n", "x_m: two columns of one quantity; remove one$"),
    "two decimal marks": (
        "time_s;x_m\n0;1,5\n1;1.6\n",
        "line 3, column x_m: '1.6' has another decimal mark",
    ),
    "a short row": (
        "time_s,x_m\n0,1\n0.1\n",
        "line 3: has 1 cells, the line of names has 2; cells are separated by commas",
    ),
    "a long row": ("time_s,x_m\n0,1,5\n", "line 2: has 3 cells"),
    "nothing": ("", "is empty; a table has a line of names"),
    "a line of names alone": ("time_s,x_m\n", "line 1: has no rows"),
    "numbers alone": ("0,1\n1,2\n", "line 1: has no line of names; write one above the numbers"),
    "a title": (
        "Hoop 3;;\ntime_s;x_m;y_m\n0;1;2\n",
        "line 2: has 3 cells, the line of names has 1; the line of names comes first",
    ),
    "a time of day": (
        "time,x_m\n00:10.000,1\n00:10.033,1\n",
        "line 2, column time: '00:10.000' is not a finite number; each row needs a number",
    ),
    "ms without a unit": (
        "time,theta_deg\n0,1\n16.7,2\n33.3,3\n",
        'line 1, column theta_deg: .* name the time time_ms, or say time_unit="ms"',
    ),
    "a mark for what was not seen": (
        "time_s,x_m,y_m\n0,0.5,0.3\n0.1,-1,-1\n0.2,0.7,0.3\n",
        "line 3: has -1 in all columns of the track, .*; leave these cells empty",
    ),
    "the origin for what was not seen": (
        "time_s,theta_deg,y_m\n0,0,0.3\n0.1,0,0\n0.2,7,0.3\n",
        "line 3: has 0 in all columns of the track",
    ),
    "heights that grow downwards": (
        "time_s,x_m,y_m\n0,0,0.78\n0.1,0.1,0.78\n0.2,0.2,0.7\n0.3,0.3,0.78\n",
        "line 1, column y_m: has no height in contact, .*; y grows upwards from the floor",
    ),
    "no channel": ("time_s,vx\n0,1\n", "line 1: has neither an angle nor a position"),
    "an empty channel": (
        "time_s,theta_deg,x_m\n0,,1\n1,,2\n",
        "column theta_deg: has no number; remove the column",
    ),
    "times that stand": (
        "time_s,x_m\n0,1\n\n0,2\n",
        "line 4, column time_s: '0' must be greater than 0 of line 2",
    ),
    "a length without a unit": (
        "time_s,x\n0,1\n",
        "line 1, column x: has no dimension, time_s is in SI units; name it x_m",
    ),
    "a time without a unit": (
        "time,x_m\n0,1\n",
        "line 1, column x_m: is in SI units, time has no dimension",
    ),
    "an angle without a unit": (
        "\tA\t\nt\tθ\t\n0\t1\n1\t2\n",
        "line 2, column θ: has no unit; name it theta_deg or theta_rad",
    ),
    "a unit of another kind": ("time_s,x_deg\n0,1\n", "column 'x_deg': is not a column"),
    "an unknown unit": ("time_s,x (furlong)\n0,1\n", r"column 'x \(furlong\)': is not a column"),
    "frames": (
        "frame,x_m\n0,1\n",
        "line 1, column frame: has numbers of frames and no time; give the rate",
    ),
    "pixels": ("time_s,x_px,y_px\n0,1,2\n", "line 1, column x_px: is in pixels; give the plane"),
    "pixels without a name": (
        "time,x,y\n0,100,40\n1,120,40\n",
        "line 1, column x: has whole numbers without a unit",
    ),
    "points without a role": (
        "\tA\t\tB\t\nt\tx\ty\tx\ty\t\n0\t1\t2\t3\t4\n",
        "has the points A, B; say which are",
    ),
    "a marker alone": (
        "\tmarker\t\t\nt\tx\ty\t\n0\t0\t0.57\n0.01\t0\t0.57\n",
        "line 2: has the point 'marker' alone, .*; track the centre, too; or if it is the centre: "
        'centre="marker"',
    ),
    "a name twice in Tracker": (
        "#multi:\n\tA\t\tA\t\nt\tx\ty\tx\ty\n0\t1\t2\t3\t4\n",
        "line 3: x: two columns of one quantity; remove one$",
    ),
    "a point over no column": (" a\nt\n0\n", "line 1: has 1 names of points over 0 columns"),
    "points whose names do not fit": (
        " a b  c  \nt x y x\n0 1 2 3\n",
        "line 1: has 2 names of points over 3 columns; export the data with tabs",
    ),
    "a name twice in Kinovea": (
        "#Kinovea Trajectory data export\n#T X Y\n\n# Trajectory 1\n0 1 2\n\n# Trajectory 1\n",
        "line 7: has a second trajectory with the name 'Trajectory 1'; give each its own name",
    ),
    "decimals or thousands": (
        "time_s\tx_mm\n0\t1,010\n1\t1,013\n",
        "line 2, column x_mm: '1,010' may be 1010 or 1.010; write decimals with a point",
    ),
    "a table with an index": (
        ",time_s,x_m\n0,0,1\n1,0.1,1\n",
        r"line 1, column '': is not a column .* ignore=\(\"\",\) passes over it",
    ),
    "an export of DeepLabCut": (
        "scorer,DLC_resnet50,DLC_resnet50,DLC_resnet50\nbodyparts,hub,hub,hub\n"
        "coords,x,y,likelihood\n0,12.5,20.25,0.99\n",
        "line 1: is an export of DeepLabCut: pixels, .*; write a table with the columns frame,",
    ),
    "an export of SLEAP": (
        "track,frame_idx,instance.score,hub.score,hub.x,hub.y\nhoop,0,0.9,0.9,100.0,200.0\n",
        "line 1: is an export of SLEAP: pixels, .*; write a table with the columns frame,",
    ),
    "an export of phyphox": (
        '"Time (s)";"Linear Acceleration x (m/s^2)";"Linear Acceleration y (m/s^2)"\n0;1;2\n',
        "line 1: is an export of phyphox: what a telephone felt, .*; film the hoop, and track it",
    ),
    "a text of Logger Pro": (
        "Vernier Format 2\nUntitled.cmbl 5/5/2019 9:37:43 .\nRun 1\nTime\tX\nt\tx\ns\tm\n\n0\t1\n",
        "line 1: is the text format of Logger Pro; choose File > Export As > CSV in Logger Pro",
    ),
    "three words in Kinovea": (
        "#Kinovea Trajectory data export\n#T X Y\n\n# A\n0 1\n",
        "line 5: has 2 cells",
    ),
    "an instant twice in Kinovea": (
        "#Kinovea Trajectory data export\n#T X Y\n0:00:00:00 1 2\n0:00:00:00 1 2\n",
        "line 4, column T: '0:00:00:00' occurs twice; choose milliseconds",
    ),
}


@pytest.mark.parametrize(("text", "message"), REFUSED.values(), ids=REFUSED)
def test_what_cannot_be_read_is_refused_with_its_place(tmp_path, units, text, message):
    path = tmp_path / "bad.csv"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(TableFileError, match=message) as caught:
        lw.Track.from_csv(path, units)
    assert str(caught.value).startswith(str(path))


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"PK\x03\x04rest", "is a spreadsheet or an archive: save the sheet as CSV"),
        (b"<?xml version='1.0'?>", "is a project or a web page: export the data"),
        (b'{"coordinates": []}', "is JSON: export the data of the track as CSV"),
        (b"\x89HDF\r\n\x1a\n", "is HDF5: export the data of the track as CSV"),
        (b"time_s,x_m\n0,\x00\n", "is not text: byte 13 is 0"),
        (b"time_s,x_m\n0,\xb5\n", "line 2: byte 0xb5 is not UTF-8; save the file as UTF-8"),
    ],
)
def test_files_that_are_no_text_are_refused(tmp_path, units, content, message):
    (tmp_path / "bad").write_bytes(content)
    with pytest.raises(TableFileError, match=message):
        lw.Track.from_csv(tmp_path / "bad", units)


def test_what_need_not_end_is_refused(tmp_path, units, capsys):
    pipe, huge, folder = tmp_path / "pipe.csv", tmp_path / "huge.csv", tmp_path / "folder.csv"
    os.mkfifo(pipe)
    folder.mkdir()
    with huge.open("wb") as file:
        # It takes no room on the disk.
        file.truncate(1 << 36)
    readers = [
        lambda path: lw.Track.from_csv(path, units),
        lambda path: lw.scoring.Record.from_csv(path, units),
    ]
    for read in readers:
        for path in (Path("/dev/zero"), pipe, folder):
            with pytest.raises(TableFileError, match="is a folder, a pipe or a device, not a file"):
                read(path)
        with pytest.raises(TableFileError, match="has more than 268435456 bytes"):
            read(huge)
    flags = [
        "--disc-mass-kg=1",
        "--particle-mass-kg=1",
        "--radius-m=1",
        "--offset-m=1",
        "--slope=0",
    ]
    for command, path, said in (
        (fit_command.main, pipe, "a pipe or a device"),
        (fit_command.main, "/dev/zero", "a pipe or a device"),
        (certify.main, pipe, "a pipe or a device"),
        (certify.main, "/dev/zero", "a pipe or a device"),
        (certify.main, huge, "has more than 268435456 bytes"),
    ):
        given = [str(path), *flags] if command is fit_command.main else [f"--check={path}"]
        assert command(given) == 2
        assert said in capsys.readouterr().err


def test_errors_have_their_parts(tmp_path, units):
    path = tmp_path / "bad.csv"
    path.write_text("time_s,x_m\n0,1\n0.1,two\n")
    with pytest.raises(TableFileError) as caught:
        lw.Track.from_csv(path, units)
    error = caught.value
    assert (error.path, error.line, error.column, error.value) == (str(path), 3, "x_m", "two")
    assert error.hint is not None
    # A column is passed over by name only.
    path.write_text("time_s,x_m,mood\n0,1,good\n0.1,1,bad\n")
    assert lw.Track.from_csv(path, units, ignore=("mood",)).time.size == 2
    with pytest.raises(TableFileError, match="has no column mud"):
        lw.Track.from_csv(path, units, ignore=("mood", "mud"))
    with pytest.raises(TableFileError, match="from_si"):
        lw.Track.from_csv(path, ignore=("mood",))
    for said in ({"length_unit": "inch"}, {"time_unit": "min"}, {"fps": 0.0}):
        with pytest.raises(ValueError, match="must be"):
            lw.Track.from_csv(path, units, **said)


def test_tracks_of_arrays_lose_nothing():
    masked = np.ma.masked_array([0.0, 0.1, 9.0], mask=[False, False, True])
    assert np.isnan(lw.Track([0.0, 1.0, 2.0], theta=masked).theta[2])
    with pytest.raises(ValueError, match=r"x\[1\] = inf must be finite, or NaN"):
        lw.Track([0.0, 1.0], x=[0.0, math.inf])
    with pytest.raises(ValueError, match="theta has no finite value: leave it out"):
        lw.Track([0.0, 1.0], theta=[math.nan, math.nan], x=[0.0, 1.0])
