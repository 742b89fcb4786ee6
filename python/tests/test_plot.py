import dataclasses
import io
import math
import random
import re
from pathlib import Path
from xml.etree import ElementTree

import matplotlib
import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray
from fontTools.pens.boundsPen import ControlBoundsPen
from fontTools.ttLib import TTFont
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.colors import to_hex
from PIL import Image

import littlewood as lw
from littlewood import _core, plot
from littlewood.plot.canvas import PictureError
from littlewood.plot.sheet import Sheet, listed, panels, power, svg
from littlewood.style import BOLD, CLASS_COLOURS, CURVE, CURVE_COLOURS, FINE, INK, MODE_COLOURS
from littlewood.tables import AXES, CAUSE_LABELS, CLASS_LABELS, MODE_CODES, OUTCOMES

CODE_OF = {name: code for code, name in OUTCOMES.items()}


@pytest.fixture
def motion():
    return lw.case("figure-3").simulate()


def test_a_motion_is_drawn_in_the_colours_of_its_modes(motion):
    figure = motion.plot()
    path, *panels = figure.axes
    colours = {to_hex(line.get_color()) for line in path.get_lines()}
    assert {MODE_COLOURS[name] for name in ("rolling", "sliding", "flight")} <= colours
    assert MODE_COLOURS["gliding"] not in colours
    labels = [text.get_text() for text in path.get_legend().get_texts()]
    assert labels == ["rolling", "sliding", "flight", "mass centre", "centre *C*"]
    # Equal scales: a hoop is round.
    assert path.get_aspect() == 1.0
    words = {text.get_text() for text in path.texts}
    assert words == {"start", "stick", "slip", "lift-off", "landing"}
    assert panels[-1].get_xlabel() == "*τ*  (√(*R*/*g*))"
    assert [axes.get_ylabel() for axes in panels] == [
        "*θ*  (rad)",
        "*θ*′  (√(*g*/*R*))",
        "*η*′  (√(*gR*))",
        "*N*  (*m*_{2}*g*)",
        "*F*  (*m*_{2}*g*)",
        "gap  (*R*)",
    ]
    # The figure belongs to the caller: nothing is left open.
    assert plt.get_fignums() == []


def seen_texts(figure, renderer):
    """All texts that are seen, with their boxes and what they belong to."""
    for axes in [None, *figure.axes]:
        if axes is None:
            own = list(figure.texts)
        else:
            own = [*axes.texts, axes.xaxis.label, axes.yaxis.label, axes._left_title]
            own += [*axes.get_xticklabels(), *axes.get_yticklabels()]
            own += axes.get_legend().get_texts() if axes.get_legend() else []
        for text in own:
            if text.get_visible() and text.get_text().strip():
                yield axes, text, text.get_window_extent(renderer).padded(-0.5)


def runs_in(axes, box):
    """Points of the lines of an axes in pixels, within a box."""
    for line in axes.get_lines():
        if len(np.atleast_1d(line.get_xdata())) > 2:
            points = line.get_transform().transform(np.ma.filled(line.get_xydata(), np.nan))
            inside = (points > box.p0).all(axis=1) & (points < box.p1).all(axis=1)
            yield line, points[inside]


def faults_of(figure):
    """What a reader would stumble over."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    texts = list(seen_texts(figure, canvas.renderer))
    for k, (axes, text, box) in enumerate(texts):
        said = text.get_text()
        if not figure.bbox.padded(1.0).containsx(box.x0 + 1) or not (
            figure.bbox.x0 <= box.x0
            and box.x1 <= figure.bbox.x1
            and figure.bbox.y0 <= box.y0
            and box.y1 <= figure.bbox.y1
        ):
            yield f"{said!r} is outside"
        for _, other, place in texts[:k]:
            if box.overlaps(place):
                yield f"{said!r} over {other.get_text()!r}"
        if axes is not None and text in axes.texts and axes.bbox.fully_overlaps(box):
            for _, points in runs_in(axes, box):
                if len(points):
                    yield f"{said!r} over a line"
    drawn = set()
    for axes in figure.axes:
        spans = [np.ptp(points, axis=0) for _, points in runs_in(axes, axes.bbox) if len(points)]
        if not axes.patches and not any(np.max(span) > 1.0 for span in spans):
            yield f"{axes.get_ylabel()}: no ink"
        lines = [(line, points) for line, points in runs_in(axes, axes.bbox) if len(points) > 1]
        drawn |= {to_hex(one.get_color()) for one, at in lines if np.max(np.ptp(at, axis=0)) > 0.5}
        drawn |= {to_hex(patch.get_facecolor()) for patch in axes.patches}
        if axes is not figure.axes[0]:
            low, high = axes.get_ylim()
            values = [line.get_ydata() for line in axes.get_lines() if line.get_marker() == "None"]
            values = [one for one in values if len(one) > 2]
            beyond = any(np.nanmax(one) > high or np.nanmin(one) < low for one in values)
            if beyond and not any("goes" in text.get_text() for text in axes.texts):
                yield f"{axes.get_ylabel()}: cut without a word"
    legend = figure.axes[0].get_legend()
    for line in legend.get_lines() if legend else []:
        if to_hex(line.get_color()) not in drawn | {INK}:
            yield f"{line.get_label()} is in the key alone"


def drawn_motion(kind, rng):
    """A random motion of a kind: hoops far from home."""
    mass, mu_s = 10 ** rng.uniform(-0.7, 0.7), 10 ** rng.uniform(-1.5, 0.5)
    hoop = {"mass_ratio": mass, "offset": rng.uniform(0.2, 1.0), "mu_s": mu_s}
    hoop |= {"inertia": mass * rng.uniform(0.5, 1.0), "mu_k": mu_s * rng.uniform(0.4, 1.0)}
    start = {"theta": rng.uniform(-math.pi, math.pi), "theta_rate": rng.uniform(-3.0, 3.0)}
    until = 20.0
    match kind:
        case "light" | "heavy":
            hoop["mass_ratio"] = hoop["inertia"] = 10 ** (-4.0 if kind == "light" else 4.0)
        case "massless":
            hoop |= {"mass_ratio": 0.0, "inertia": 0.0, "offset": 1.0}
        case "slope":
            hoop["slope"] = rng.uniform(-0.7, 0.7)
        case "resisted":
            hoop["rolling_resistance"] = 10 ** rng.uniform(-3.0, -0.7)
            until = None
        case "bounces":
            hoop["restitution"] = rng.uniform(0.2, 0.95)
        case "long":
            hoop |= {"mu_s": 0.01, "mu_k": 0.008}
            start |= {"theta_rate": 8.0, "slip": 2.0}
            until = 500.0
        case "rests":
            hoop["rolling_resistance"] = 0.3
            start = {"theta": math.pi, "theta_rate": 0.0}
        case "ends":
            hoop |= {"mass_ratio": 0.0, "inertia": 0.0, "offset": 1.0}
            start = {"theta": 0.0, "theta_rate": 1.0}
        case "thrown":
            start["gap_rate"] = rng.uniform(0.5, 9.0)
        case "si":
            of = {"disc_mass_kg": 0.2, "particle_mass_kg": 0.1, "radius_m": 0.3, "offset_m": 0.28}
            si = lw.Hoop.from_si(**of, inertia_kg_m2=0.015, mu_s=0.4, mu_k=0.3, restitution=0.5)
            return si.simulate(**start, until=until)
    return lw.Hoop(**hoop).simulate(**start, until=until)


KINDS = ("usual", "light", "heavy", "massless", "slope", "resisted", "bounces", "long", "rests")


@pytest.mark.parametrize("kind", [*KINDS, "ends", "thrown", "si"])
def test_a_picture_of_any_motion_can_be_read(kind):
    rng = random.Random(kind)
    for width_mm in (84.0, 160.0, None):
        motion = drawn_motion(kind, rng)
        figure = motion.plot(width_mm=width_mm)
        assert list(faults_of(figure)) == [], (width_mm, repr(motion))
    with pytest.raises(PictureError, match="60 to 420 mm wide, not 20"):
        motion.plot(width_mm=20.0)


def test_angles_have_ticks_at_multiples_of_pi(motion):
    axes = plot.phase_plane(motion.hoop, motion=motion)
    axes.figure.draw_without_rendering()
    labels = [text.get_text() for text in axes.get_xticklabels()]
    assert {"−π", "−π/2", "0", "3π/4", "π"} <= set(labels)
    assert axes.get_xlabel() == _core.unicode("*θ*")
    assert axes.get_ylabel() == _core.unicode("*θ*′  (√(*g*/*R*))")


def test_a_map_has_a_legend_with_shares(motion):
    dataset = lw.outcome_map(
        motion.hoop,
        theta_rate=np.linspace(-4, 4, 40),
        theta=np.linspace(-math.pi, math.pi, 50),
        until=50.0,
    )
    axes = plot.outcomes(dataset, x="theta")
    words = [text.get_text() for text in axes.get_legend().get_texts()]
    assert [word.split("\n")[0] for word in words] == [
        "leaves at once",
        "lifts off later",
        "rolls for ever",
        "in contact",
    ]
    shares = [float(word.split("\n")[1].removesuffix(" %")) for word in words]
    assert sum(shares) == pytest.approx(100.0, abs=0.3)
    assert axes.get_xlabel() == "*θ*"
    with pytest.raises(ValueError, match="two dimensions"):
        plot.outcomes(dataset.isel(theta=0))


def test_classes_tell_jumps_apart(motion):
    dataset = lw.simulate_many(
        motion.hoop, theta=[0.0, math.pi / 2, 2.5], theta_rate=[4.0, 2.0, 0.0]
    )
    found = plot.classes(dataset)
    names = found.attrs["flag_meanings"].split()
    assert tuple(names) == lw.tables.CLASSES
    assert found.attrs["flag_values"] == list(range(len(names)))
    assert [names[code] for code in found.values] == [
        "leaves_at_once",
        "lifts_off_later",
        "rolls_forever",
    ]


def summaries(outcome, *, letter="R", lift_off_time=math.nan):
    """Summaries of motions of one phase, with these outcomes."""
    code = next(row["code"] for row in lw._core.PHASES if row["name"] == letter)
    return xarray.Dataset(
        {
            "outcome": ("start", np.array(outcome, dtype=np.uint8)),
            "sequence": ("start", np.full(len(outcome), code, dtype=np.uint64)),
            "lift_off_time": ("start", np.full(len(outcome), lift_off_time)),
        }
    )


def test_every_outcome_has_a_class():
    found = plot.classes(summaries(list(OUTCOMES)))
    of_outcome = dict(
        zip(OUTCOMES.values(), (lw.tables.CLASSES[code] for code in found.values), strict=True)
    )
    # What has not been computed is not what cannot be computed.
    assert of_outcome["not_computed"] == "not_computed"
    assert of_outcome["invalid"] == "invalid"
    assert of_outcome["time_limit"] == of_outcome["transition_limit"] == "in_contact"
    assert (
        of_outcome["inconsistent"]
        == of_outcome["ambiguous"]
        == of_outcome["singular"]
        == "painleve"
    )
    assert of_outcome["particle_at_top"] == "particle_at_top"
    # Every class is met, those of flights by flights.
    at_once = plot.classes(summaries([0], letter="F", lift_off_time=0.0))
    assert [lw.tables.CLASSES[code] for code in at_once.values] == ["leaves_at_once"]
    assert {*of_outcome.values(), "leaves_at_once"} == set(lw.tables.CLASSES)


def test_a_motion_in_flight_at_the_time_limit_has_lifted_off(motion):
    # Figure 3 lifts off at 1.52 and lands at 3.85.
    dataset = lw.simulate_many(motion.hoop, theta=[math.pi / 2], theta_rate=2.0, until=2.0)
    assert OUTCOMES[int(dataset.outcome[0])] == "time_limit"
    assert lw.tables.CLASSES[int(plot.classes(dataset)[0])] == "lifts_off_later"


def test_classes_of_blocks_are_those_of_the_whole(motion):
    dataset = lw.outcome_map(
        motion.hoop, theta=np.linspace(-3, 3, 11), theta_rate=np.linspace(-4, 4, 7), until=20.0
    )
    lazy = plot.classes(dataset.chunk(5))
    assert lazy.chunks is not None
    np.testing.assert_array_equal(lazy.compute(), plot.classes(dataset))
    with pytest.raises(ValueError, match="mask_and_scale=False"):
        plot.classes(dataset.assign(outcome=dataset.outcome.astype(float)))
    with pytest.raises(ValueError, match="code 77"):
        plot.classes(summaries([77]))


def test_a_map_has_the_colours_and_words_of_the_classes(motion):
    dataset = lw.outcome_map(
        motion.hoop, theta=np.linspace(-3, 3, 21), theta_rate=np.linspace(-4, 4, 15), until=20.0
    )
    axes = plot.outcomes(dataset, x="theta")
    (mesh,) = axes.collections
    drawn = {to_hex(colour) for colour in mesh.to_rgba(mesh.get_array()).reshape(-1, 4)}
    shown = {lw.tables.CLASSES[code] for code in np.unique(plot.classes(dataset))}
    assert len(shown) >= 3
    assert drawn == {CLASS_COLOURS[name] for name in shown}
    patches = axes.get_legend().get_patches()
    words = [text.get_text().split("\n")[0] for text in axes.get_legend().get_texts()]
    assert words == [CLASS_LABELS[name] for name in lw.tables.CLASSES if name in shown]
    assert [to_hex(patch.get_facecolor()) for patch in patches] == [
        CLASS_COLOURS[name] for name in lw.tables.CLASSES if name in shown
    ]


@pytest.mark.parametrize("axis", AXES)
def test_every_axis_has_a_label_that_can_be_drawn(axis, motion):
    other = "theta_rate" if axis == "theta" else "theta"
    fixed = {"theta": 1.0, "theta_rate": 2.0, "mu_k": 0.1}
    fixed = {name: value for name, value in fixed.items() if name not in (axis, other)}
    dataset = lw.outcome_map(
        motion.hoop, **{axis: [0.4, 0.5], other: [0.0, 1.0]}, **fixed, until=5.0
    )
    axes = plot.outcomes(dataset, x=axis)
    # A letter that the font does not have would be a warning, which is an error here.
    axes.figure.draw_without_rendering()
    assert axes.get_xlabel() not in ("", axis)


@pytest.mark.parametrize("slope", [0.3, -1.2])
def test_on_a_ramp_the_hoop_is_drawn_on_the_ramp(slope):
    hoop = lw.Hoop(mass_ratio=1, offset=0.5, inertia=1, mu_s=0.9, mu_k=0.9, slope=slope)
    motion = hoop.simulate(theta=0.5, theta_rate=1.0, slip=0.3, until=2.0)
    axes = plot.path(motion)
    assert axes.get_aspect() == 1.0
    sin, cos = math.sin(slope), math.cos(slope)
    plane, *lines = axes.get_lines()
    assert plane.get_slope() == pytest.approx(math.tan(slope))
    centres = [line for line in lines if line.get_linewidth() == FINE]
    assert centres
    samples = motion.sample(1001)
    for line in centres:
        x, y = (np.asarray(values) for values in line.get_data())
        along, away = x * cos + y * sin, y * cos - x * sin
        assert np.all((along > samples.x.min() - 1e-12) & (along < samples.x.max() + 1e-12))
        assert np.all(away > 1.0 - 1e-12)
    rims = [patch for patch in axes.patches if getattr(patch, "radius", 0.0) == 1.0]
    particles = [patch for patch in axes.patches if getattr(patch, "radius", 0.0) == 0.085]
    x, y = rims[0].center
    # At the start the contact point is the origin; the particle is at θ from the normal.
    assert (x, y) == pytest.approx((-sin, cos), abs=1e-12)
    assert particles[0].center == pytest.approx(
        (x - 0.5 * math.sin(0.5 + slope), y + 0.5 * math.cos(0.5 + slope))
    )
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    for x, y in (rim.center for rim in rims):
        assert left < x - 1.0 and x + 1.0 < right and low < y - 1.0 and y + 1.0 < high
    assert motion.animate(frames=3, seconds=0.3)._repr_html_().count("data:image/png;base64") == 3


@pytest.mark.parametrize(
    ("case", "changes", "quantities"),
    [
        ("figure-3", {"mu_s": 0.1, "mu_k": 0.05, "restitution": 0.9}, ("normal", "friction")),
        ("figure-7", {}, ("theta_rate",)),
    ],
)
def test_a_line_that_is_cut_is_marked(case, changes, quantities):
    case = lw.case(case)
    case = dataclasses.replace(case, hoop=dataclasses.replace(case.hoop, **changes))
    motion = case.simulate(until=20.0)
    axes = plot.history(motion, quantities=quantities)
    samples = motion.sample(1001)
    values = samples[quantities[0]]
    low, high = axes.get_ylim()
    at = int(np.argmax(values))
    assert values[at] > high
    marks = [line for line in axes.get_lines() if line.get_marker() in (6, 7)]
    assert (samples.time[at], high) in [
        (line.get_xdata()[0], line.get_ydata()[0]) for line in marks
    ]
    # The farthest value, and no mark where nothing is cut.
    number = "∞" if math.isinf(values[at]) else f"{values[at]:.4g}"
    (note,) = axes.texts
    assert note.get_text().endswith(f"up to {number}")
    is_below = any(np.any(samples[name] < low) for name in quantities)
    assert is_below == any(line.get_marker() == 7 for line in marks) == ("down" in note.get_text())
    whole = plot.history(motion, quantities=("theta",))
    assert not any(line.get_marker() in (6, 7) for line in whole.get_lines())


def test_what_a_line_cannot_show_is_shaded():
    hoop = lw.Hoop(mass_ratio=1, offset=0.5, inertia=1, mu_s=9, mu_k=9, rolling_resistance=1e-3)
    motion = hoop.simulate(theta=2.0, theta_rate=0.0)
    axes = plt.figure(figsize=(1.2, 2.0)).add_subplot()
    plot.history(motion, axes, quantities=("theta_rate",), count=20_001)
    plt.close("all")
    assert [text.get_text() for text in axes.texts] == ["shaded from least to greatest"]
    # The shade has the extremes of another sample, in the colours of the modes.
    rates = motion.sample(30_001).theta_rate
    tops = [patch.get_y() + patch.get_height() for patch in axes.patches]
    assert max(tops) == pytest.approx(rates.max(), abs=0.01)
    assert min(patch.get_y() for patch in axes.patches) == pytest.approx(rates.min(), abs=0.01)
    assert MODE_COLOURS["rolling"] in {to_hex(patch.get_facecolor()) for patch in axes.patches}
    assert not [
        line for line in axes.get_lines() if to_hex(line.get_color()) in MODE_COLOURS.values()
    ]


def test_where_outcomes_change_more_finely_than_a_map_there_is_one_tint():
    codes = np.where(
        np.random.default_rng(8).random((60, 80)) < 0.5,
        CODE_OF["rolls_forever"],
        CODE_OF["time_limit"],
    )
    codes[:, 40:] = CODE_OF["rolls_forever"]
    dataset = summaries(codes.ravel()).assign_coords(start=np.arange(codes.size))
    dataset = dataset.assign_coords(
        y=("start", np.repeat(np.arange(60), 80)), x=("start", np.tile(np.arange(80), 60))
    )
    dataset = dataset.set_index(start=("y", "x")).unstack("start")
    axes = plot.outcomes(dataset, x="x")
    (mesh,) = axes.collections
    drawn = np.asarray(mesh.get_array()).reshape(60, 80)
    mixed = drawn == len(lw.tables.CLASSES)
    assert mixed[3:-3, 3:36].mean() > 0.99 and not mixed[:, 44:].any()
    words = [text.get_text() for text in axes.get_legend().get_texts()]
    assert words[-1].startswith("mixed more finely\nthan drawn\n")
    assert float(words[-1].split("\n")[-1].removesuffix(" %")) == pytest.approx(
        100.0 * mixed.mean(), abs=0.06
    )
    # Too few motions tell nothing.
    few = plot.outcomes(dataset.isel(y=slice(0, 20)), x="x").collections[0].get_array()
    assert np.max(few) < len(lw.tables.CLASSES)


def test_axes_of_ones_own(motion):
    figure, axes = plt.subplots()
    assert plot.path(motion, axes) is axes
    assert (
        plot.history(motion, plt.figure().add_subplot(), quantities=("energy",)).get_ylabel()
        == "E  (m₂gR)"
    )
    plt.close("all")
    assert figure.axes == [axes]


def test_nothing_to_draw():
    motion = lw.case("painleve").simulate()
    assert "no motion is consistent" in motion.plot().axes[0].get_title(loc="left")
    with pytest.raises(ValueError, match="no motion to show"):
        motion.animate()


def test_an_animation_shows_in_a_notebook(motion, tmp_path):
    animation = motion.animate(frames=8, seconds=1.0)
    page = animation._repr_html_()
    assert page.count("data:image/png;base64") == 8
    animation.save(tmp_path / "motion.gif")
    assert (tmp_path / "motion.gif").read_bytes()[:4] == b"GIF8"
    with pytest.raises(ValueError, match="frames = 1"):
        motion.animate(frames=1)
    with pytest.raises(ValueError, match="seconds = -1"):
        motion.animate(seconds=-1)


def shown_for(path):
    """Delays of the frames of a GIF, hundredths of a second, by Pillow and by its bytes."""
    with Image.open(path) as film:
        delays = []
        for k in range(film.n_frames):
            film.seek(k)
            delays.append(film.info["duration"] / 10)
    # Graphic control extensions: introducer, label, size, flags, delay, transparent colour, end.
    found = re.findall(rb"\x21\xf9\x04.(..).\x00", path.read_bytes(), re.DOTALL)
    assert [int.from_bytes(delay, "little") for delay in found] == delays
    return delays


@pytest.mark.parametrize(
    ("frames", "seconds", "shown"),
    [(60, 1.0, 50), (20, 2.7, 20), (7, 0.5, 7), (30, 1.0, 30), (3, 0.05, 2), (150, None, 60)],
)
def test_a_gif_plays_in_the_seconds_that_were_asked_for(motion, tmp_path, frames, seconds, shown):
    animation = motion.animate(frames=frames, seconds=seconds)
    animation.save(tmp_path / "motion.gif")
    delays = shown_for(tmp_path / "motion.gif")
    # Programs show for a tenth of a second what is to be shown for less than two hundredths.
    assert len(delays) == shown and min(delays) >= 2 and max(delays) - min(delays) <= 1
    assert sum(delays) == pytest.approx(100 * animation.seconds, abs=0.5)
    # No error adds up over the frames: each ends when it should.
    ends = 100 * animation.seconds / shown * np.arange(1, shown + 1)
    assert np.max(np.abs(np.cumsum(delays) - ends)) <= 0.5 + 1e-9


def test_a_page_plays_in_the_seconds_that_were_asked_for(motion):
    for frames, seconds, interval in ((6, 0.1, 17), (4, 6.0, 1500)):
        page = motion.animate(frames=frames, seconds=seconds)._repr_html_()
        assert re.search(r"new Animation\(frames, img_id, slider_id, (\S+),", page)[1] == (
            f"{interval}.0"
        )


def test_a_film_that_cannot_be_written_is_refused(motion, tmp_path, monkeypatch):
    animation = motion.animate(frames=3, seconds=0.3)

    def refusal(path, animation=animation):
        with pytest.raises(lw.video.UnwritableVideoError) as caught:
            animation.save(path)
        assert caught.value.path == str(path) and not Path(path).exists()
        return str(caught.value)

    endings = r"must be one of \.gif, \.mp4, \.mov, \.mkv; a \.gif needs no other program"
    assert re.search(rf"the ending '\.xyz' {endings}", refusal(tmp_path / "a.xyz"))
    assert re.search(rf"the ending '' {endings}", refusal(tmp_path / "film"))
    assert "no such folder" in refusal(tmp_path / "nowhere" / "a.gif")
    for seconds in (0.03, 1e5):
        assert re.search(
            r"must be from 0\.04 to 1966\.05 s for a GIF of 3 frames",
            refusal(tmp_path / "a.gif", motion.animate(frames=3, seconds=seconds)),
        )
    program = tmp_path / "ffmpeg"
    monkeypatch.setitem(matplotlib.rcParams, "animation.ffmpeg_path", str(program))
    assert "needs ffmpeg, which is not found" in refusal(tmp_path / "a.mp4")
    program.write_text("#!/bin/sh\necho 'Unknown encoder' >&2\nexit 1\n", encoding="utf-8")
    program.chmod(0o755)
    assert "ffmpeg failed: Unknown encoder; it must" in refusal(tmp_path / "a.mp4")
    # It is told the rate, whole or not.
    said = tmp_path / "arguments"
    program.write_text(f'#!/bin/sh\necho "$@" >{said}\ncat >/dev/null\n', encoding="utf-8")
    motion.animate(frames=3, seconds=2.0).save(tmp_path / "a.mp4")
    assert re.search(r"-framerate (\S+)", said.read_text(encoding="utf-8"))[1] == "1.5"


def modes_drawn(axes, width):
    """Modes of the lines of this width, by their colours, in the order of the modes."""
    colours = {
        to_hex(line.get_color()) for line in axes.get_lines() if line.get_linewidth() == width
    }
    assert colours <= set(MODE_COLOURS.values())
    return [mode for mode in lw.tables.MODES if MODE_COLOURS[mode] in colours]


def motion_of(name):
    """The motion of a case, of one that bounces for ever its first turns."""
    return lw.case(name).simulate(until=20.0 if name == "bounces-forever" else None)


@pytest.mark.parametrize("name", list(lw.CASES))
def test_a_picture_of_every_case_shows_its_phases(name):
    motion = motion_of(name)
    figure = motion.plot()
    figure.draw_without_rendering()
    if not motion.phases:
        (axes,) = figure.axes
        assert axes.get_title(loc="left") == f"no phase: {motion.outcome.label}"
        assert axes.patches
        return
    path, *panels = figure.axes
    shown = [phase for phase in motion.phases if phase.start_time <= motion.shown_until]
    modes = sorted({phase.mode for phase in shown}, key=MODE_CODES.__getitem__)
    # The path: a line of the mass centre for each phase, all of it, and every mode in the legend.
    centres = [line for line in path.get_lines() if line.get_linewidth() == BOLD]
    assert len(centres) == len(shown)
    for line, phase in zip(centres, shown, strict=True):
        x, y = (np.asarray(values, dtype=float) for values in line.get_data())
        assert np.isfinite(x).all() and np.isfinite(y).all()
        assert to_hex(line.get_color()) == MODE_COLOURS[phase.mode]
        first = motion(phase.start_time)
        # Back in the coordinates of the plane, which is tilted.
        sin, cos = math.sin(motion.hoop.slope), math.cos(motion.hoop.slope)
        start = x[0] * cos + y[0] * sin, y[0] * cos - x[0] * sin
        assert start == pytest.approx((first.mass_centre_x, first.mass_centre_y), abs=1e-12)
    # The key has the modes that can be seen; a hoop at rest has no path.
    legend = path.get_legend()
    labels = [text.get_text() for text in legend.get_texts()] if legend else []
    named = [label for label in labels if label in MODE_COLOURS]
    assert set(named) <= set(modes) and (named or modes == ["rest"])
    # What marks the hoops along the path: the start, and causes in their words.
    words = [text.get_text() for text in path.texts]
    assert words[0] == "start"
    assert set(words[1:]) <= {CAUSE_LABELS[transition.cause] for transition in motion.transitions}
    if motion.transitions:
        assert len(words) > 1
    # The histories: a line for each phase, of what changes.
    for axes in panels:
        assert modes_drawn(axes, CURVE) == modes
        lines = [line for line in axes.get_lines() if line.get_linewidth() == CURVE]
        assert len(lines) == len(shown)
        assert any(np.isfinite(line.get_ydata()).any() for line in lines)
        assert np.ptp(np.concatenate([line.get_ydata() for line in lines])) != 0.0


def check_motion_over_plane(axes, motion):
    """The motion is drawn over the plane, in the modes that it has."""
    over = [line for line in axes.get_lines() if line.get_linewidth() == BOLD]
    shown = [phase for phase in motion.phases if phase.start_time <= motion.shown_until]
    assert [to_hex(line.get_color()) for line in over] == [
        MODE_COLOURS[phase.mode] for phase in shown
    ]
    for line in over:
        angle = np.asarray(line.get_xdata(), dtype=float)
        assert np.isfinite(angle).all()
        assert -math.pi <= angle.min() and angle.max() <= math.pi


def denominator(hoop, theta, rate):
    """Return D_χ of rolling (docs/theory/rolling-resistance.md)."""
    mass, h = 1.0 + hoop.mass_ratio, hoop.h
    about_contact = (
        hoop.inertia
        + hoop.mass_ratio * hoop.offset * h
        + mass * (1.0 + 2.0 * h * np.cos(theta) + h**2)
    )
    return about_contact - np.sign(rate) * hoop.rolling_resistance * mass * h * np.sin(theta)


@pytest.mark.parametrize("name", list(lw.CASES))
def test_the_plane_of_every_case_shows_its_curves(name):
    motion = motion_of(name)
    axes = plot.phase_plane(motion.hoop, motion=motion)
    axes.figure.draw_without_rendering()
    plane = motion.hoop.phase_plane
    drawn = {}
    for collection in axes.collections:
        if isinstance(collection, LineCollection) and len(collection.get_segments()) > 0:
            is_solid = collection.get_linestyle()[0][1] is None
            drawn[to_hex(collection.get_color()[0]), is_solid] = np.concatenate(
                collection.get_segments()
            ).T
    check_motion_over_plane(axes, motion)
    theta, rate = drawn.get((CURVE_COLOURS["lift_off"], False), np.empty((2, 0)))
    lift_off = motion.hoop.h * np.cos(theta) * rate**2
    np.testing.assert_allclose(lift_off, math.cos(motion.hoop.slope), rtol=1e-12)
    resists = motion.hoop.rolling_resistance > 0.0
    assert ((CURVE_COLOURS["band_of_rest"], True) in drawn) == resists
    # Where they are drawn their equations hold; where rates are large forces are, and their errors.
    # With rolling resistance a hoop may press, or hold, wherever it is.
    if not resists or (CURVE_COLOURS["normal_force_zero"], True) in drawn:
        theta, rate = drawn[CURVE_COLOURS["normal_force_zero"], True]
        # With rolling resistance the curve ends at a zero of the denominator of N, D_χ.
        normal = plane.normal(theta, rate) * (
            denominator(motion.hoop, theta, rate) if resists else 1
        )
        np.testing.assert_allclose(normal / (1.0 + rate**2), 0.0, atol=1e-12)
    if not resists or (CURVE_COLOURS["slip_limit"], False) in drawn:
        theta, rate = drawn[CURVE_COLOURS["slip_limit"], False]
        miss = np.abs(plane.friction(theta, rate)) - motion.hoop.mu_s * plane.normal(theta, rate)
        np.testing.assert_allclose(miss / (1.0 + rate**2), 0.0, atol=1e-12)
    # Region R is where the hoop can roll.
    region = next(one for one in axes.collections if isinstance(one, PolyCollection))
    grid = np.stack(
        np.meshgrid(np.linspace(-3.0, 3.0, 41), np.linspace(-3.9, 3.9, 41)), axis=-1
    ).reshape(-1, 2)
    inside = np.any([path.contains_points(grid) for path in region.get_paths()], axis=0)
    # Off its boundary, which is drawn as chords.
    margin = motion.hoop.mu_s * plane.normal(*grid.T) - np.abs(plane.friction(*grid.T))
    clear = np.minimum(np.abs(margin), np.abs(plane.normal(*grid.T))) > 0.005
    assert np.mean(clear) > 0.9
    assert (inside[clear] == plane.in_rolling_region(*grid[clear].T)).all()
    assert np.mean(inside == plane.in_rolling_region(*grid.T)) > 0.99
    # A curve that is not there has no letter: a disc that rolls has neither limit.
    assert (len(axes.texts) >= 1) == (motion.hoop.h > 0.0)
    assert {text.get_text() for text in axes.texts} <= {_core.unicode("*f*"), _core.unicode("*n*")}


def test_the_font_draws_the_letters_of_the_figures():
    font = TTFont(io.BytesIO(_core.font()))
    glyphs, names = font.getGlyphSet(), font.getBestCmap()
    source = Path(__file__).parents[2] / "crates" / "littlewood-draw" / "fonts" / "letters.txt"
    lines = [line.split(" ", 3) for line in source.read_text(encoding="utf-8").splitlines()]
    assert len(lines) > 200
    for face, code, width, *path in lines:
        letter = chr(int(code, 16))
        glyph = glyphs[names[ord(_core.unicode(f"*{letter}*") if face == "i" else letter)]]
        assert glyph.width == 2 * float(width)
        # The same box in units of half the size, on whose edges outlines have points.
        pen = ControlBoundsPen(glyphs)
        glyph.draw(pen)
        numbers = [
            2.0 * float(number) for number in re.findall(r"-?[\d.]+", path[0] if path else "")
        ]
        expected = (
            (min(numbers[::2]), min(numbers[1::2]), max(numbers[::2]), max(numbers[1::2]))
            if numbers
            else None
        )
        assert pen.bounds == pytest.approx(expected, abs=0.5)


def test_texts_have_their_marks_and_can_be_searched(motion):
    with plot.look():
        figure, (axes,) = panels(1)
        axes.set(
            xscale="log", xlim=(1e-7, 1e3), xlabel="*μ*_{s} of *I*_{zz}", ylabel="*θ*′^{2} <&>"
        )
    text = svg(figure, "A title & more", "What it <shows>")
    root = ElementTree.fromstring(text)
    space = "{http://www.w3.org/2000/svg}"
    assert [child.tag for child in root][:2] == [f"{space}title", f"{space}desc"]
    assert [child.text for child in root][:2] == ["A title & more", "What it <shows>"]
    labels = {group.get("aria-label") for group in root.iter(f"{space}g")}
    assert {"μₛ of Izz", "θ′² <&>", "10⁻⁵", "0.1", "10", "10³"} <= labels
    # Letters are outlines, each of which the file has once, as in the figures.
    assert "<text" not in text and "DejaVu" not in text
    assert svg(figure, "A title & more", "What it <shows>") == text


def test_a_look_is_that_of_the_figures_on_a_screen_and_in_print():
    def drawn(width_mm):
        with plot.look(width_mm), plot.look():
            figure, axes = panels(4)
            figure.draw_without_rendering()
            ends = {round(one.get_position().x0, 2) for one in axes}
            return figure.get_figwidth(), axes[0].get_xticklabels()[0].get_fontsize(), len(ends)

    assert drawn(None) == pytest.approx((860 / 96, 12.5 * 0.75, 2))
    # In a column of a journal panels stand below each other.
    assert drawn(84.0) == pytest.approx((84 / 25.4, 7.0, 1))
    assert plt.rcParams["font.family"] == ["sans-serif"]


def test_lists_have_as_many_looks_as_can_be_told_apart():
    colours, dashes = zip(
        *((look["color"], str(look["linestyle"])) for _, look in listed("abcd")), strict=True
    )
    assert len(set(colours)) == len(set(dashes)) == 4
    assert not set(colours) & {
        *MODE_COLOURS.values(),
        *CLASS_COLOURS.values(),
        CURVE_COLOURS["slip_limit"],
    }
    with pytest.raises(ValueError, match="5 lines in a panel: there are colours for 4"):
        listed("abcde")


@pytest.mark.parametrize(
    ("value", "text"),
    [(0.0, "0"), (0.1, "0.1"), (20.0, "20"), (1e-5, "10^{−5}"), (-2e6, "−2·10^{6}")],
)
def test_numbers_of_one_digit(value, text):
    assert power(value) == text


def test_axes_of_ones_own_keep_their_letters(motion):
    axes = plt.figure().add_subplot()
    plot.phase_plane(motion.hoop, axes)
    assert axes.get_xlabel() == "θ" and not isinstance(axes.figure, Sheet)
    assert axes.xaxis.label.get_fontfamily() == ["sans-serif"]
    plt.close("all")
