import math
import os
import struct
import warnings
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import littlewood as lw
from littlewood import video
from littlewood.fitting.calibration import CALIBRATION
from littlewood.video.capture_rate import capture_rate
from littlewood.video.synthetic import _instants

RATE, EXPOSURE = 120.0, 1 / 400
CAMERA = video.Camera(
    (-0.9, 0.9, 3.2), (-1.2, 0.3, 0.0), focal_px=430.0, width=480, height=270, roll_rad=0.02
)


@pytest.fixture(scope="module")
def hoop():
    return lw.Hoop.from_si(
        disc_mass_kg=0.25,
        particle_mass_kg=0.25,
        radius_m=0.3,
        offset_m=0.27,
        inertia_kg_m2=0.25 * 0.29**2,
        mu_s=0.5,
        mu_k=0.4,
        restitution=0.5,
    )


@pytest.fixture(scope="module")
def motion(hoop):
    return hoop.simulate(theta=math.pi / 2, theta_rate=2.0)


@pytest.fixture(scope="module")
def film(motion, tmp_path_factory):
    path = tmp_path_factory.mktemp("films") / "film.avi"
    plane = video.synthetic_video(path, motion, CAMERA, fps=RATE, exposure_s=EXPOSURE, seconds=0.8)
    return path, plane


@pytest.fixture(scope="module")
def track(film, hoop):
    path, plane = film
    return lw.track_video(path, hoop, plane=plane, fps=RATE)


def exact(motion, track, exposure=EXPOSURE):
    """The mean of θ, x and y over the exposures, of 200 instants each."""
    instants = exposure / motion.hoop.units.time_s * (np.arange(200) + 0.5) / 200
    samples = motion((track.time[:, None] + instants).ravel())
    return [
        values.reshape(-1, 200).mean(axis=1)
        for values in (samples.theta, samples.x, samples.centre_y)
    ]


def errors(motion, track, exposure=EXPOSURE):
    theta, x, y = exact(motion, track, exposure)
    turned = np.mod(track.theta - theta + math.pi, math.tau) - math.pi
    return turned, track.x - x, track.y - y


def root_mean_square(values):
    return float(np.sqrt(np.mean(np.square(values))))


def test_a_track_is_the_motion_that_was_filmed(track, motion):
    assert track.time.size == 97
    np.testing.assert_allclose(np.diff(track.time) * motion.hoop.units.time_s, 1 / RATE, rtol=1e-12)
    theta, x, y = errors(motion, track)
    # A rim of 42 pixels radius: a hundredth of a pixel is 0.00024 R. The floor below is darker than
    # the wall, and the hoop has a shadow.
    assert np.max(np.abs(x)) < 0.0005
    assert root_mean_square(x) < 0.00015
    assert root_mean_square(y) < 0.0003
    assert root_mean_square(theta) < 0.003
    assert set(track.errors) == {"theta", "x", "y"}
    assert np.all(track.errors["x"] > 0.0)
    assert set(track.calibration) == set(CALIBRATION)


def fitted(track, hoop, motion, **more):
    start = {"theta": motion.start.theta, "theta_rate": motion.start.theta_rate}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", lw.fitting.IdentifiabilityWarning)
        free = ("mu_s", "mu_k", "inertia", "restitution")
        return lw.fit(track, hoop, free=free, start=start, search=False, **more)


def test_a_film_tells_what_was_put_in(track, hoop, motion):
    result = fitted(track, hoop, motion)
    for name in ("mu_k", "inertia", "restitution"):
        low, high = result.estimates[name].interval(0.999)
        assert low < getattr(hoop, name) < high
    assert result.estimates["mu_k"].std_error < 0.005
    # The plane is that of the camera: nothing was wrong.
    for name in ("floor", "turn", "scale", "stretch", "shear"):
        estimate = result.estimates[f"camera_{name}"]
        assert abs(estimate.value) < 4.0 * estimate.std_error < 0.02


def test_a_film_tells_that_its_plane_is_wrong(film, hoop, motion):
    path, plane = film
    corners = np.array([(-2.4, 0.0), (0.0, 0.0), (0.0, 0.9), (-2.4, 0.9)])
    pixels = np.column_stack(plane.to_pixels(*corners.T))
    # The board is measured two per cent too long, and stands higher than it was thought to.
    wrong = video.Plane.from_points(pixels, [1.02, 1.02] * corners + [0.0, 0.003])
    track = lw.track_video(path, hoop, plane=wrong, fps=RATE, exposure_s=EXPOSURE)
    assert "exposure" not in track.calibration
    result = fitted(track, hoop, motion)
    scale, floor = result.estimates["camera_scale"], result.estimates["camera_floor"]
    assert scale.value == pytest.approx(0.02, abs=4.0 * scale.std_error)
    assert floor.value == pytest.approx(0.01, abs=4.0 * floor.std_error)
    assert scale.std_error < 0.002
    for name in ("mu_k", "inertia", "restitution"):
        estimate = result.estimates[name]
        assert abs(estimate.value - getattr(hoop, name)) < 4.0 * estimate.std_error
    with pytest.warns(lw.fitting.FitWarning) as caught:
        believed = fitted(track, hoop, motion, calibration=())
    doubts = {warning.message.doubt.name: warning.message for warning in caught}
    assert {"camera_scale", "camera_floor"} <= set(doubts["camera"].parameters)
    off = [
        abs(believed.estimates[name].value - getattr(hoop, name))
        / believed.estimates[name].std_error
        for name in ("mu_k", "inertia", "restitution")
    ]
    assert max(off) > 4.0


def test_a_disc_has_no_inner_edge(hoop, motion, tmp_path):
    path = tmp_path / "disc.avi"
    plane = video.synthetic_video(
        path, motion, CAMERA, exposure_s=EXPOSURE, seconds=0.4, look=video.Look(rim=1.0)
    )
    track = lw.track_video(path, hoop, plane=plane, fps=RATE)
    _, x, y = errors(motion, track)
    # In a few pictures the disc covers what the background, the median, has of it.
    for values in (x, y):
        assert np.median(np.abs(values - np.median(values))) < 0.0008
        assert root_mean_square(values) < 0.005


def test_the_same_seed_makes_the_same_film(motion):
    def first(seed):
        return next(iter(video.synthetic_frames(motion, CAMERA, seed=seed)))

    np.testing.assert_array_equal(first(3), first(3))
    assert np.any(first(3) != first(4))


def test_a_long_exposure_blurs_and_does_not_shift(hoop, motion, tmp_path):
    path = tmp_path / "blurred.avi"
    plane = video.synthetic_video(path, motion, CAMERA, exposure_s=1 / RATE, seconds=0.4)
    track = lw.track_video(path, hoop, plane=plane, fps=RATE)
    _, x, y = errors(motion, track, 1 / RATE)
    # The hoop moves by a tenth of its radius meanwhile.
    assert np.max(np.abs(np.diff(track.x))) > 0.1
    assert root_mean_square(x) < 0.0005
    assert root_mean_square(y) < 0.001


def without_noise(motion, part):
    """Errors of the centre in pictures without noise.

    By how much middle and mean of an exposure differ.
    """
    exposure = part / RATE
    look = video.Look(noise=0.0, texture=0.0)
    seen = list(video.synthetic_frames(motion, CAMERA, exposure_s=exposure, look=look, seconds=0.8))
    finder = video.Finder(
        video.Plane.from_camera(CAMERA), np.median(seen, axis=0), 0.5, 0.3, 0.27, (255, 0, 0)
    )
    circles = [finder.circle(picture) for picture in seen]
    time = np.arange(len(seen)) / RATE / motion.hoop.units.time_s
    _, x, y = exact(motion, lw.Track(time, x=time), exposure)
    middle = motion(time + 0.5 * exposure / motion.hoop.units.time_s)
    found = np.array([(circle.x_m, circle.y_m) for circle in circles]) / 0.3
    return found - np.column_stack([x, y]), np.column_stack([x - middle.x, y - middle.centre_y])


@pytest.mark.parametrize("part", [0.7, 1.0])
def test_a_blurred_rim_is_found_at_the_mean_over_the_exposure(motion, part):
    errors, skew = without_noise(motion, part)
    # Half-way between its edges it would be up to a part of `skew` away, and by the blur across the
    # rays: 10⁻³ R.
    assert np.max(np.abs(skew)) > 1e-3
    assert np.max(np.abs(errors - np.median(errors, axis=0))) < 1.2e-4
    for k in range(2):
        assert abs(np.polyfit(skew[:, k], errors[:, k], 1)[0]) < 0.05


def test_an_exposure_is_averaged_over_its_impacts(motion):
    """The mean over the instants of a picture is that of the motion, though it bends there."""
    jumps = [one.time for one in motion.transitions if one.impact is not None]
    for before in (0.005, 0.02, 0.04):
        begin, end = jumps[0] - before, jumps[0] - before + 0.045
        instants, weights, _ = _instants(motion, begin, end, 40.0)
        samples, dense = (
            motion(instants),
            motion(begin + (end - begin) * (np.arange(20000) + 0.5) / 20000),
        )
        assert weights.sum() == pytest.approx(1.0, abs=1e-12)
        for name in ("theta", "x", "centre_y"):
            assert weights @ getattr(samples, name) == pytest.approx(
                getattr(dense, name).mean(), abs=1e-7
            )


def test_points_and_a_camera_agree_on_the_plane():
    plane = video.Plane.from_camera(CAMERA)
    corners = np.array([(-2.0, 0.0), (0.0, 0.0), (0.0, 1.0), (-2.0, 1.0), (-1.0, 0.4)])
    pixels = np.column_stack(plane.to_pixels(*corners.T))
    again = video.Plane.from_points(pixels, corners)
    np.testing.assert_allclose(np.column_stack(again.to_metres(*pixels.T)), corners, atol=1e-9)
    np.testing.assert_allclose(abs(again.matrix), abs(plane.matrix), atol=1e-9)


def test_a_pinhole_projects_by_similar_triangles():
    camera = video.Camera((0.0, 1.0, 4.0), (0.0, 1.0, 0.0), focal_px=800.0, width=641, height=481)
    u, v = video.Plane.from_camera(camera).to_pixels(0.5, 0.0)
    assert (float(u), float(v)) == pytest.approx((320.0 + 800.0 * 0.5 / 4.0, 240.0 + 800.0 / 4.0))


def test_a_ground_line_gives_scale_and_tilt():
    plane = video.Plane.from_ground_line((100.0, 400.0), (500.0, 430.0), 2.0)
    assert [float(value) for value in plane.to_metres(500.0, 430.0)] == pytest.approx([2.0, 0.0])
    # A turn by a right angle, counterclockwise: upward in the picture.
    assert [float(value) for value in plane.to_pixels(0.0, 2.0)] == pytest.approx([130.0, 0.0])
    assert plane.pixels_per_metre(1.0, 1.0) == pytest.approx(math.hypot(400.0, 30.0) / 2.0)


def test_the_overlay_has_film_and_simulation(film, motion, tmp_path):
    path, plane = film
    for name in ("both.avi", "both.mp4"):
        count = video.overlay_video(path, motion, tmp_path / name, plane=plane, fps=RATE)
        drawn = list(video.frames(tmp_path / name))
        assert count == len(drawn) == 97
    picture = next(iter(video.frames(path)))
    drawn = video.draw_motion(picture, motion, plane, 0.0)
    assert drawn.shape == picture.shape
    u, v = plane.to_pixels(0.0, 0.6)
    changed = np.any(drawn != picture, axis=2)
    # The top of the rim is drawn over, the wall beside the hoop is not.
    assert changed[round(float(v)) - 1 : round(float(v)) + 2, round(float(u))].any()
    assert not changed[:, : round(float(u)) - 100][60:].any()
    assert not np.any(video.draw_motion(picture, motion, plane, -1.0) != picture)


def test_a_marker_may_be_anywhere_on_the_rim(film, hoop, track):
    path, plane = film
    shifted = lw.track_video(
        path, hoop, plane=plane, fps=RATE, marker=(220, 40, 30), marker_angle=0.5
    )
    turned = np.mod(track.theta - shifted.theta - 0.5 + math.pi, math.tau) - math.pi
    assert np.max(np.abs(turned)) < 0.01


def test_bad_films_are_refused(film, hoop, motion, tmp_path):
    path, plane = film
    given = {"plane": plane, "fps": RATE}
    with pytest.raises(video.UnreadableVideoError, match="no such file") as missing:
        lw.track_video(tmp_path / "none.avi", hoop, **given)
    assert isinstance(missing.value, video.VideoFileError)
    assert missing.value.path == str(tmp_path / "none.avi")
    broken = tmp_path / "broken.avi"
    broken.write_bytes(b"no film" * 100)
    with pytest.raises(video.UnreadableVideoError, match="cannot decode"):
        lw.track_video(broken, hoop, **given)
    with pytest.raises(video.TooFewFramesError, match="5 frames are too few: at least 10") as short:
        lw.track_video(path, hoop, last=5, **given)
    assert (short.value.frames, short.value.least) == (5, 10)
    empty = tmp_path / "empty.avi"
    with video.files.FrameWriter(empty, (480, 270), 30.0) as writer:
        for k in range(12):
            writer.write(np.random.default_rng(k).integers(120, 136, (270, 480, 3), dtype=np.uint8))
    with pytest.raises(video.NoHoopError, match="found in 0 of 12 frames") as nothing:
        lw.track_video(empty, hoop, **given)
    assert nothing.value.found == 0
    with pytest.raises(ValueError, match=r"exposure_s = 0\.1 must be from 0 to 0\.0083"):
        lw.track_video(path, hoop, exposure_s=0.1, **given)
    with pytest.raises(ValueError, match="must be one of red"):
        lw.track_video(path, hoop, marker="beige", **given)
    with pytest.raises(ValueError, match="is grey"):
        lw.track_video(path, hoop, marker=(9, 9, 9), **given)
    for fps in (0.0, -30.0, math.nan, math.inf):
        with pytest.raises(ValueError, match=r"fps = .* must be positive"):
            lw.track_video(path, hoop, plane=plane, fps=fps)
    with pytest.raises(TypeError, match="fps = '120' must be a real number"):
        lw.track_video(path, hoop, plane=plane, fps="120")
    with pytest.raises(ValueError, match="from_si"):
        lw.track_video(
            path, lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4), **given
        )
    with pytest.raises(video.UnwritableVideoError, match=r"extension must be one of \.mp4"):
        video.synthetic_video(tmp_path / "film.gif", motion, CAMERA)
    with pytest.raises(video.UnwritableVideoError, match="no such folder"):
        video.synthetic_video(tmp_path / "nowhere" / "film.avi", motion, CAMERA)
    with pytest.raises(ValueError, match=r"exposure_s = 0\.01"):
        next(iter(video.synthetic_frames(motion, CAMERA, exposure_s=0.01)))
    assert issubclass(video.VideoError, ValueError)


def test_bad_planes_and_cameras_are_refused():
    with pytest.raises(ValueError, match="on a line"):
        video.Plane.from_points([(0, 0), (1, 0), (2, 0), (3, 1)], [(0, 0), (1, 0), (2, 0), (3, 1)])
    with pytest.raises(ValueError, match="at least 4 pairs"):
        video.Plane.from_points([(0, 0)], [(0, 0)])
    with pytest.raises(ValueError, match="must have a length"):
        video.Plane.from_ground_line((100.0, 0.0), (0.0, 0.0), 1.0)
    with pytest.raises(ValueError, match="in front of the plane"):
        video.Camera((0.0, 1.0, -1.0), (0.0, 0.0, 0.0), 500.0)


def test_codecs_are_those_that_are_written():
    assert video.codecs() == {".mp4": "mp4v", ".mov": "mp4v", ".avi": "MJPG"}
    assert Path("film.avi").suffix in video.codecs()


FILMS = Path(__file__).parent / "films"


def box(kind, *content):
    """A box of MPEG-4: its length, its kind, what is in it."""
    inner = b"".join(content)
    return struct.pack(">I4s", 8 + len(inner), kind) + inner


def changed(content, path, change):
    """The boxes of a file of MPEG-4, of which that at a path is changed.

    Lengths of those around it follow.
    """
    out, begin = b"", 0
    while begin < len(content):
        length, kind = struct.unpack_from(">I4s", content, begin)
        inner = content[begin + 8 : begin + length]
        if kind == path[0]:
            inner = change(inner) if len(path) == 1 else changed(inner, path[1:], change)
        out += box(kind, inner)
        begin += length
    return out


def with_steps(path, steps):
    """Give the frames of an MPEG-4 these durations, in intervals of its own rate."""

    def table(inner):
        (tick,) = struct.unpack_from(">I", inner, 12)
        rows = (struct.pack(">II", 1, step * tick) for step in steps)
        return inner[:4] + struct.pack(">I", len(steps)) + b"".join(rows)

    places = [b"moov", b"trak", b"mdia", b"minf", b"stbl", b"stts"]
    content = changed(path.read_bytes(), places, table)
    # The list of edits would end the film when it ended before.
    path.write_bytes(changed(content, places[:2], lambda inner: inner.replace(b"edts", b"free", 1)))


def with_key(path, kind, payload, of_user=False, name=b"com.android.capture.fps"):
    """Add a key to the metadata of an MPEG-4, as telephones do, or among the data of its user."""
    handler = box(b"hdlr", bytes(8), b"mdta", bytes(13))
    keys = box(
        b"keys", struct.pack(">II", 0, 2), box(b"mdta", b"com.android.version"), box(b"mdta", name)
    )
    values = box(
        b"ilst",
        box(struct.pack(">I", 1), box(b"data", struct.pack(">II", 1, 0), b"14")),
        box(struct.pack(">I", 2), box(b"data", struct.pack(">II", kind, 0), payload)),
    )
    meta = box(b"meta", bytes(4) if of_user else b"", handler, keys, values)
    more = box(b"udta", meta) if of_user else meta
    path.write_bytes(changed(path.read_bytes(), [b"moov"], lambda inner: inner + more))


def plain_film(path, count=24, rate=30.0):
    """A film in which every frame differs."""
    with video.files.FrameWriter(path, (64, 48), rate) as writer:
        for k in range(count):
            writer.write(np.full((48, 64, 3), 9 * k % 256, dtype=np.uint8))
    return path


def test_lost_frames_do_not_shift_the_motion(film, hoop, motion, tmp_path):
    path, plane = film
    # Ten frames of the flight are not there.
    kept = [k for k in range(97) if not 60 <= k < 70]
    lost = tmp_path / "lost.mp4"
    with video.files.FrameWriter(lost, (480, 270)) as writer:
        for frame in video.frames(path, kept):
            writer.write(frame)
    with_steps(lost, [*np.diff(kept).tolist(), 1])
    with pytest.warns(
        video.VideoWarning, match=r"1 gap, in which 10 frames are lost; the largest takes 0\.0917 s"
    ):
        track = lw.track_video(lost, hoop, plane=plane, fps=RATE)
    np.testing.assert_allclose(
        track.time * motion.hoop.units.time_s, np.array(kept) / RATE, atol=1e-12
    )
    assert any("10 frames are lost" in note for note in track.notes)
    assert "played at 30 a second and taken at 120, as was said" in track.notes[0]
    _, x, y = errors(motion, track)
    assert np.max(np.abs(x)) < 0.005 and np.max(np.abs(y)) < 0.005
    # By their numbers the last frames would be half a radius off.
    by_number = lw.Track(np.arange(len(kept)) / RATE / motion.hoop.units.time_s, x=track.x)
    assert np.max(np.abs(track.x - exact(motion, by_number)[1])) > 0.5
    # A part of the film has the times of the whole.
    with pytest.warns(video.VideoWarning):
        part = lw.track_video(lost, hoop, plane=plane, fps=RATE, first=40, last=80)
    np.testing.assert_array_equal(part.time, track.time[40:80])
    # The simulation is drawn at those times, too.
    drawn = tmp_path / "drawn.avi"
    assert video.overlay_video(lost, motion, drawn, plane=plane, fps=RATE) == len(kept)
    picture = list(video.frames(drawn))[-1].astype(int)
    frame = list(video.frames(lost))[-1]
    here = video.draw_motion(frame, motion, plane, track.time[-1])
    there = video.draw_motion(frame, motion, plane, by_number.time[-1])
    assert np.abs(picture - here).mean() < 0.5 * np.abs(picture - there).mean()


@pytest.mark.parametrize(
    ("steps", "lost", "gaps"),
    [
        ([1] * 24, 0, 0),
        ([1, 2] * 12, 12, 12),
        ([1] * 10 + [11] + [1] * 13, 10, 1),
        ([2] * 5 + [1] * 19, 5, 5),
    ],
)
def test_times_are_those_of_the_file(tmp_path, steps, lost, gaps):
    path = plain_film(tmp_path / "film.mp4")
    with_steps(path, steps)
    clock = video.clock_of(path)
    times = np.concatenate([[0], np.cumsum(steps)])[:24] / 30.0
    np.testing.assert_allclose(clock.time_s, times, atol=1e-12)
    # The duration of the last frame ends no interval.
    assert clock.gaps == gaps - (steps[-1] > 1) and clock.lost == lost - (steps[-1] - 1)
    if gaps < 12:
        assert clock.rate == pytest.approx(30.0, rel=1e-12)
    np.testing.assert_allclose(
        clock.seconds(60.0), times * clock.rate / 60.0, rtol=1e-12, atol=1e-15
    )
    assert bool(clock.doubts(60.0)) == (clock.lost > 0)
    assert video.rate_of(path) == clock.rate


def test_uneven_frames_are_said(tmp_path):
    path = plain_film(tmp_path / "film.mp4")
    # From thirty frames a second to twenty-four, in ticks of a 120th.
    with_steps(path, [4] * 12 + [5] * 12)
    clock = video.clock_of(path)
    assert not clock.is_even and clock.lost == 0
    assert "not evenly spaced: 0.133 to 0.167 s" in clock.doubts(clock.rate)[0]


def test_matroska_has_its_times_too():
    # ffmpeg -f lavfi -i testsrc2=size=32x24:rate=30:duration=1 -c:v libvpx -b:v 10k
    #   -vf "select='not(between(n,10,13))'" -fps_mode vfr lost.webm
    clock = video.clock_of(FILMS / "lost.webm")
    times = np.array([k for k in range(30) if not 10 <= k < 14]) / 30.0
    # It counts milliseconds.
    assert np.max(np.abs(clock.time_s - times)) <= 0.0005 + 1e-9
    assert (clock.lost, clock.gaps, clock.is_even) == (4, 1, True)
    assert clock.rate == pytest.approx(30.0, rel=0.001)


@pytest.mark.parametrize("rate", [10, 24, 25, 30, 50, 60, 100])
def test_the_rate_of_a_gif_is_that_at_which_it_plays(tmp_path, rate):
    path = tmp_path / "film.gif"
    frames = [Image.fromarray(np.full((8, 8), 4 * k, dtype=np.uint8)) for k in range(60)]
    ends = np.floor(100.0 * np.arange(61) / rate + 0.5)
    frames[0].save(
        path, save_all=True, append_images=frames[1:], duration=(10 * np.diff(ends)).tolist()
    )
    # Each time is rounded to a hundredth of a second.
    assert video.rate_of(path) == pytest.approx(rate, rel=0.006 * rate / 59)
    clock = video.clock_of(path)
    np.testing.assert_allclose(clock.time_s, ends[:-1] / 100.0, atol=1e-9)
    assert clock.is_even and clock.lost == 0


@pytest.mark.parametrize("of_user", [False, True])
@pytest.mark.parametrize(
    ("kind", "payload"),
    [
        (23, struct.pack(">f", 240.0)),
        (24, struct.pack(">d", 240.0)),
        (1, b"240.000000"),
        (22, bytes([0, 240])),
        (21, struct.pack(">i", 240)),
    ],
)
def test_the_rate_of_slow_motion_is_in_its_file(tmp_path, kind, payload, of_user):
    path = plain_film(tmp_path / "film.mp4")
    assert video.clock_of(path).captured is None and video.clock_of(path).taken is None
    with pytest.raises(
        ValueError, match="fps is missing: the video is played at 30 frames a second"
    ):
        video.clock_of(path).seconds()
    with_key(path, kind, payload, of_user)
    clock = video.clock_of(path)
    assert (clock.captured, clock.taken) == (240.0, pytest.approx(240.0))
    np.testing.assert_allclose(clock.seconds(), np.arange(24) / 240.0, atol=1e-12)
    assert "taken at 240, as the file says (com.android.capture.fps)" in clock.facts()[0]
    assert clock.doubts() == [] and clock.doubts(240.0) == []
    # Who says another rate is believed, and told.
    np.testing.assert_allclose(clock.seconds(120.0), np.arange(24) / 120.0, atol=1e-12)
    assert "was taken at 240 frames a second" in clock.doubts(120.0)[0]
    assert "120 were given: those count" in clock.doubts(120.0)[0]


def test_a_film_in_real_time_is_no_slow_motion(tmp_path):
    for captured, taken in [(30.0, 25.0), (25.0, 25.0), (99.5, 100.0), (1.0, 1.0), (90.0, 90.0)]:
        path = plain_film(tmp_path / "film.mp4", rate=25.0)
        with_key(path, 23, struct.pack(">f", captured))
        assert video.clock_of(path).taken == pytest.approx(taken)


def test_metadata_that_nobody_understands_say_nothing(tmp_path):
    path = plain_film(tmp_path / "film.mp4")
    plain = path.read_bytes()
    for kind, payload in [
        (23, b"\0"),
        (1, b"fast"),
        (23, struct.pack(">f", math.nan)),
        (99, b"240"),
    ]:
        path.write_bytes(plain)
        with_key(path, kind, payload)
        assert video.clock_of(path).captured is None
    path.write_bytes(plain)
    with_key(path, 1, b"240", name=b"com.android.capture.fp")
    assert video.clock_of(path).captured is None
    # Files that end anywhere, and boxes of any length.
    path.write_bytes(plain)
    with_key(path, 1, b"240")
    whole = path.read_bytes()
    random = np.random.default_rng(8)
    begin = whole.index(b"moov") - 4
    odd = tmp_path / "odd.mp4"
    for _ in range(300):
        content = bytearray(whole)
        for at in random.integers(begin, len(whole), 3):
            content[at] = random.integers(256)
        odd.write_bytes(content[: random.integers(begin, len(whole) + 1)])
        assert capture_rate(odd) in (None, 240.0) or capture_rate(odd) > 0.0
    odd.write_bytes(box(b"moov") * 200_000)
    assert capture_rate(odd) is None


def test_a_telephone_says_the_rate_of_its_slow_motion(film, hoop, motion, tmp_path):
    path, plane = film
    slow = tmp_path / "slow.mp4"
    with video.files.FrameWriter(slow, (480, 270)) as writer:
        for frame in video.frames(path):
            writer.write(frame)
    with_key(slow, 23, struct.pack(">f", RATE))
    track = lw.track_video(slow, hoop, plane=plane)
    np.testing.assert_allclose(np.diff(track.time) * motion.hoop.units.time_s, 1 / RATE, rtol=1e-9)
    assert "taken at 120, as the file says" in track.notes[0]
    with pytest.warns(video.VideoWarning, match="at 120 frames a second .* 60 were given"):
        other = lw.track_video(slow, hoop, plane=plane, fps=60.0)
    np.testing.assert_allclose(other.time, 2.0 * track.time, rtol=1e-9)


def test_an_interlaced_film_is_named(hoop):
    # ffmpeg -f lavfi -i testsrc2=size=64x48:rate=25:duration=0.48 -c:v mpeg2video
    #   -flags +ilme+ildct -field_order tt -q:v 20 interlaced.mpg
    path = FILMS / "interlaced.mpg"
    plane = video.Plane.from_ground_line((0.0, 40.0), (60.0, 40.0), 1.0)
    for use in (
        lambda: lw.track_video(path, hoop, plane=plane, fps=25.0),
        lambda: video.find_plane(path, 0.3),
    ):
        with pytest.raises(video.NoPictureError, match=r"interlaced video.* -vf bwdif") as caught:
            use()
        assert isinstance(caught.value, video.UnreadableVideoError)
        assert (caught.value.path, caught.value.frames) == (str(path), 12)


def test_a_video_is_a_file(tmp_path):
    os.mkfifo(tmp_path / "pipe.mp4")
    for path in ("/dev/zero", tmp_path / "pipe.mp4", tmp_path):
        with pytest.raises(video.UnreadableVideoError, match="a folder, a pipe or a device"):
            video.rate_of(path)
