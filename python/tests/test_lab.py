"""The laboratory in a notebook, and the links of the page. web/tests/notebook.spec.ts tests the side of the page."""

import math

import pytest

import littlewood as lw
from littlewood import laboratory
from littlewood.link import keys_of, link_of, motion_of, time_of


@pytest.fixture(autouse=True)
def _module(tmp_path, monkeypatch):
    """A module in place of the page, which a build of the package may be without."""
    module = tmp_path / "laboratory.js"
    module.write_text("export default { render() {} };", encoding="utf-8")
    monkeypatch.setattr(laboratory, "_MODULE", module)


@pytest.mark.parametrize("name", lw.CASES)
def test_a_link_has_every_bit_of_a_motion(name):
    case = lw.case(name)
    motion = case.simulate(until=20.0)
    again = motion_of(link_of(motion, 1.25))
    assert (again.hoop, again.start, again.until) == (case.hoop, case.start, 20.0)
    assert [one.state for one in again.transitions] == [one.state for one in motion.transitions]
    assert time_of(link_of(motion, 1.25), again) == 1.25
    assert time_of(link_of(motion, motion.start.time), again) == motion.start.time


def test_links_of_the_page_are_read():
    assert motion_of("#case=figure-7&at=2").hoop == lw.case("figure-7").hoop
    hula = "disc_mass_kg=0.4&particle_mass_kg=0.14&radius_m=0.45&offset_m=0.45&inertia_kg_m2=0.081&mu_s=0.5&mu_k=0.4"
    motion = motion_of(f"{hula}&theta=1.2&theta_rate_rad_per_s=11&until_s=2")
    known = dict(disc_mass_kg=0.4, particle_mass_kg=0.14, radius_m=0.45, offset_m=0.45, inertia_kg_m2=0.081)
    same = lw.Hoop.from_si(**known, mu_s=0.5, mu_k=0.4).simulate_si(theta_rad=1.2, theta_rate_rad_per_s=11.0, until_s=2)
    assert (motion.hoop, motion.start, motion.until) == (same.hoop, same.start, same.until)
    with pytest.raises(ValueError, match="no motion in the link 'loop=1'"):
        motion_of("loop=1")


def test_python_follows_the_page():
    lab = lw.case("figure-3").simulate().lab()
    first, seen = lab.motion, []
    lab.observe(lambda change: seen.append(change.new), "motion")
    lab.link = "case=figure-3&at=1.2&shows=hops"
    assert lab.motion is first
    assert (lab.time, seen) == (1.2, [])
    lab.link = "mass_ratio=1&offset=1&inertia=1&mu_s=0.5&mu_k=0.4&theta=0.5&theta_rate=1&slip=0"
    assert seen == [lab.motion]
    assert (lab.motion.sequence, lab.time) == ("R", 0.0)


def test_the_page_follows_python():
    lab = lw.case("figure-3").simulate().lab(time=0.7, height=500)
    assert lab.get_state()["height"] == 500
    assert lab.get_state()["_esm"].startswith("export default")
    assert keys_of(lab.link)["at"] == "0.7"
    lab.link += "&shows=hops"
    lab.time = 1.0
    assert (keys_of(lab.link)["at"], keys_of(lab.link)["shows"]) == ("1.0", "hops")
    lab.motion = lw.case("figure-3-bounces").simulate()
    keys = keys_of(lab.link)
    assert (keys["restitution"], keys["restitution_law"], keys["shows"]) == ("0.5", "energetic", "hops")
    assert float(keys["theta"]) == math.pi / 2


def test_a_build_without_the_page_says_so(tmp_path, monkeypatch):
    monkeypatch.setattr(laboratory, "_MODULE", tmp_path / "none.js")
    with pytest.raises(RuntimeError, match=r"run web/build\.sh before building the wheel"):
        lw.case("figure-3").simulate().lab()
