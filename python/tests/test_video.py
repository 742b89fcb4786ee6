import math
import warnings
from pathlib import Path

import numpy as np
import pytest

import littlewood as lw
from littlewood import video
from littlewood.calibration import CALIBRATION
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
        warnings.simplefilter("ignore", lw.fit_result.IdentifiabilityWarning)
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
    with pytest.warns(lw.fit_result.FitWarning) as caught:
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
    """Errors of the centre in pictures without noise, and by how much middle and mean of an exposure differ."""
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
        for _ in range(12):
            writer.write(np.full((270, 480, 3), 128, dtype=np.uint8))
    with pytest.raises(video.NoHoopError, match="found in 0 of 12 frames") as nothing:
        lw.track_video(empty, hoop, **given)
    assert nothing.value.found == 0
    with pytest.raises(ValueError, match=r"exposure_s = 0\.1 must be from 0 to 0\.0083"):
        lw.track_video(path, hoop, exposure_s=0.1, **given)
    with pytest.raises(ValueError, match="must be one of red"):
        lw.track_video(path, hoop, marker="beige", **given)
    with pytest.raises(ValueError, match="is grey"):
        lw.track_video(path, hoop, marker=(9, 9, 9), **given)
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
