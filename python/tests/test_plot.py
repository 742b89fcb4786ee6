import math

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.colors import to_hex

import littlewood as lw
from littlewood import plot
from littlewood.style import MODE_COLOURS


@pytest.fixture
def motion():
    return lw.case("figure-3").simulate()


def test_a_motion_is_drawn_in_the_colours_of_its_modes(motion):
    figure = motion.plot()
    path, angle, _, forces = figure.axes
    colours = {to_hex(line.get_color()) for line in path.get_lines()}
    assert {MODE_COLOURS[name] for name in ("rolling", "sliding", "flight")} <= colours
    assert MODE_COLOURS["gliding"] not in colours
    labels = [text.get_text() for text in path.get_legend().get_texts()]
    assert labels == ["sliding", "rolling", "flight"]
    # Equal scales: a hoop is round.
    assert path.get_aspect() == 1.0
    words = {text.get_text() for text in path.texts}
    assert {"start", "stick", "slip", "lift-off", "landing"} <= words
    assert angle.get_xlabel() == "τ  (√(R/g))"
    assert {text.get_text() for text in forces.texts} == {"N", "F"}
    # The figure belongs to the caller: nothing is left open.
    assert plt.get_fignums() == []


def test_angles_have_ticks_at_multiples_of_pi(motion):
    axes = plot.phase_plane(motion.hoop, motion=motion)
    axes.figure.canvas.draw()
    labels = [text.get_text() for text in axes.get_xticklabels()]
    assert {"−π", "−π/2", "0", "3π/4", "π"} <= set(labels)
    assert axes.get_xlabel() == "θ"
    assert axes.get_ylabel() == "θ′  (√(g/R))"


def test_a_map_has_a_legend_with_shares(motion):
    dataset = lw.outcome_map(
        motion.hoop, theta_rate=np.linspace(-4, 4, 40), theta=np.linspace(-math.pi, math.pi, 50), until=50.0
    )
    axes = plot.outcomes(dataset, x="theta")
    words = [text.get_text() for text in axes.get_legend().get_texts()]
    assert [word.split("\n")[0] for word in words] == [
        "leaves at once",
        "lifts off later",
        "rolls for ever",
        "in contact at the limit",
    ]
    shares = [float(word.split("\n")[1].removesuffix(" %")) for word in words]
    assert sum(shares) == pytest.approx(100.0, abs=0.3)
    assert axes.get_xlabel() == "θ"
    with pytest.raises(ValueError, match="two dimensions"):
        plot.outcomes(dataset.isel(theta=0))


def test_classes_tell_jumps_apart(motion):
    dataset = lw.simulate_many(motion.hoop, theta=[0.0, math.pi / 2, 2.5], theta_rate=[4.0, 2.0, 0.0])
    found = plot.classes(dataset)
    names = found.attrs["flag_meanings"].split()
    assert [names[code] for code in found.values] == ["leaves_at_once", "lifts_off_later", "rolls_for_ever"]


def test_axes_of_ones_own(motion):
    figure, axes = plt.subplots()
    assert plot.path(motion, axes) is axes
    assert plot.history(motion, plt.figure().add_subplot(), quantities=("energy",)).get_ylabel() == "E"
    plt.close("all")
    assert figure.axes == [axes]


def test_nothing_to_draw():
    motion = lw.case("painleve").simulate()
    assert "inconsistent" in motion.plot().axes[0].get_title()
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


@pytest.mark.parametrize("name", list(lw.CASES))
def test_every_case_can_be_drawn(name):
    motion = lw.case(name).simulate()
    motion.plot().canvas.draw()
    plot.phase_plane(motion.hoop, motion=motion).figure.canvas.draw()
