"""The laboratory in a notebook, and the links of the page.

web/tests/notebook.spec.ts tests the side of the page.
"""

import math

import numpy as np
import pytest

import littlewood as lw
from littlewood.lab import LinkError, link_of, motion_of, time_of, widget
from littlewood.tables import HOOP

HULA = (
    "disc_mass_kg=0.4&particle_mass_kg=0.14&radius_m=0.45&offset_m=0.45&inertia_kg_m2=0.081"
    "&mu_s=0.5&mu_k=0.4"
)


@pytest.fixture(autouse=True)
def _module(tmp_path, monkeypatch):
    """A module in place of the page, which a build of the package may be without."""
    module = tmp_path / "laboratory.js"
    module.write_text("export default { render() {} };", encoding="utf-8")
    monkeypatch.setattr(widget, "_MODULE", module)


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
    motion = motion_of(f"{HULA}&theta=1.2&theta_rate_rad_per_s=11&until_s=2")
    known = dict(
        disc_mass_kg=0.4, particle_mass_kg=0.14, radius_m=0.45, offset_m=0.45, inertia_kg_m2=0.081
    )
    same = lw.Hoop.from_si(**known, mu_s=0.5, mu_k=0.4).simulate_si(
        theta_rad=1.2, theta_rate_rad_per_s=11.0, until_s=2
    )
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
    assert lab.link == "case=figure-3&at=0.7"
    lab.link += "&shows=hops"
    lab.time = 1.0
    assert lab.link == "case=figure-3&at=1&shows=hops"
    lab.motion = lw.case("figure-3-bounces").simulate(until=20.0)
    assert f"&restitution=0.5&restitution_law=energetic&theta={math.pi / 2!r}&" in lab.link
    assert lab.link.endswith("&until=20&at=1&shows=hops")


def test_a_build_without_the_page_says_so(tmp_path, monkeypatch):
    monkeypatch.setattr(widget, "_MODULE", tmp_path / "none.js")
    with pytest.raises(
        RuntimeError,
        match=r"run web/build\.sh in the repository .* then build and install the wheel again",
    ):
        lw.case("figure-3").simulate().lab()


# The page's own links (web/tests/link.spec.ts), and what it shows: numbers as the page reads them.
@pytest.mark.parametrize(
    ("link", "changed"),
    [
        ("case=figure-3&mu_k=0.3", {"mu_k": 0.3}),
        (
            "#case=figure-3&at=0.3&embed=1&theme=dark&rate=4&speed=0.25&loop=1&map=0&shows=hops"
            "&follow=0",
            {},
        ),
        (
            "case=figure-3&mu_k=0.37&theta=1.234567890123456&slip=-0.25",
            {"mu_k": 0.37, "theta": 1.234567890123456, "slip": -0.25},
        ),
        ("mu_k=%200.3%20", {"mu_k": 0.3}),
        ("theta=−1", {"theta": -1.0}),
        ("theta=%E2%88%921.5e0", {"theta": -1.5}),
        ("theta=%2D1", {"theta": -1.0}),
        ("theta=+.5&slip=1.", {"theta": 0.5, "slip": 1.0}),
        ("mu_k=0.1&mu_k=0.2", {"mu_k": 0.2}),
        ("&&mu_k=0.2&", {"mu_k": 0.2}),
        ("slip=-0", {"slip": -0.0}),
        (
            "restitution=0.5&restitution_law=newton&gap_rate=0.25",
            {"restitution": 0.5, "restitution_law": "newton", "gap_rate": 0.25},
        ),
        ("restitution=0.5", {"restitution": 0.5, "restitution_law": "energetic"}),
    ],
)
def test_a_link_of_the_page_is_that_of_a_case_with_what_it_says(link, changed):
    base = lw.case("figure-3")
    motion = motion_of(link)
    wanted = {
        **{name: getattr(base.hoop, name) for name in (*HOOP, "restitution_law")},
        **vars(base.start),
        **changed,
    }
    found = {
        **{name: getattr(motion.hoop, name) for name in (*HOOP, "restitution_law")},
        **vars(motion.start),
    }
    assert {name: repr(value) for name, value in found.items()} == {
        name: repr(value) for name, value in wanted.items()
    }


def test_a_link_of_any_motion_is_read_to_the_last_bit():
    random = np.random.default_rng(34)
    for i in range(200):
        mu_k = random.uniform(0.0, 1.0)
        parameters = {
            "mass_ratio": 10 ** random.uniform(-9, 3),
            "offset": random.uniform(1e-9, 1.0),
            "inertia": 0.5,
        }
        parameters |= {
            "mu_s": mu_k + random.uniform(0.0, 1.0),
            "mu_k": mu_k,
            "restitution": [None, 0.25][i % 2],
        }
        hoop = lw.Hoop(**parameters)
        start = lw.Start(*random.uniform(-3.0, 3.0, 5), gap_rate=0.0)
        motion = hoop.simulate(**vars(start), until=start.time, max_transitions=0)
        link = link_of(motion, float(random.uniform(0.0, 9.0)))
        again = motion_of(link)
        assert (again.hoop, again.start, again.until) == (motion.hoop, motion.start, motion.until)
        assert link_of(again, time_of(link, again)) == link


@pytest.mark.parametrize("name", lw.CASES)
def test_every_number_after_a_case_is_taken(name):
    case = lw.case(name)
    # Values that contradict nothing: a massless hoop stays one.
    numbers = {
        "theta": 0.25,
        "theta_rate": 0.5,
        "slip": 0.125,
        "x": 3.0,
        "time": 2.0,
        "mu_s": 2.0,
        "mu_k": 0.0625,
        "offset": 0.75,
    }
    if case.hoop.inertia > 0.0:
        numbers |= {"mass_ratio": 1.5, "inertia": 1.25, "restitution": 0.375, "gap_rate": 0.0625}
    for key, value in numbers.items():
        motion = motion_of(f"case={name}&{key}={value}&until=30")
        of_hoop = {key: value} if key in HOOP else {}
        wanted = {one: getattr(case.hoop, one) for one in HOOP} | of_hoop
        assert {one: getattr(motion.hoop, one) for one in HOOP} == wanted
        assert vars(motion.start) == vars(case.start) | ({} if of_hoop else {key: value})
        assert motion.until == 30.0
    if case.hoop.restitution is not None:
        assert motion_of(f"case={name}&restitution_law=poisson").hoop.restitution_law == "poisson"


def test_the_short_name_of_a_case_is_taken():
    assert lw.case("libration") is lw.case("figure-2-libration")
    assert motion_of("case=libration&at=1").hoop == lw.case("figure-2-libration").hoop
    with pytest.raises(KeyError, match="no case named 'librations'"):
        lw.case("librations")


@pytest.mark.parametrize(
    ("link", "key", "text", "reason"),
    [
        ("case=no-such-case", "case", "no-such-case", "no case named 'no-such-case'"),
        ("case=figure-3&colour=red", "colour", "red", "not known"),
        ("theta=nonsense", "theta", "nonsense", "not a number"),
        ("theta=NaN", "theta", "NaN", "not a number"),
        ("theta=inf", "theta", "inf", "not a number"),
        ("theta=1_0", "theta", "1_0", "not a number"),
        ("theta=0x10", "theta", "0x10", "not a number"),
        ("theta=１", "theta", "１", "not a number"),
        ("theta=1e400", "theta", "1e400", "not a number"),
        ("theta=", "theta", "", "not a number"),
        ("mu_s=%", "mu_s", "%", "not a number"),
        ("mu_s=%F0%9F", "mu_s", "%F0%9F", "not a number"),
        ("case=figure-3&until=soon", "until", "soon", "not a number"),
        ("radius_m=0.3&case=figure-3", "disc_mass_kg", "", "does not give it"),
        (f"{HULA}&theta=1&theta_rate_rad_per_s=1&slip=1", "slip", "1", "not in SI units"),
    ],
)
def test_a_bad_link_names_its_key(link, key, text, reason):
    with pytest.raises(LinkError, match=reason) as caught:
        motion_of(link)
    assert (caught.value.key, caught.value.text) == (key, text)
    assert f"{key}={text}" in str(caught.value)


# What the page says of them beside the field.
@pytest.mark.parametrize(
    ("link", "message"),
    [
        ("mu_k=7", "mu_k = 7 must not exceed mu_s = 0.5"),
        ("offset=1.5", "offset = 1.5 must not exceed 1"),
        ("theta_rate=1e9", "must lie between -1e6 and 1e6"),
        ("mass_ratio=-1", "must not be negative"),
        ("restitution=1.5", "restitution = 1.5 must not exceed 1"),
        ("restitution_law=newton", "restitution_law = newton without restitution"),
        ("mass_ratio=0&inertia=0&restitution=0.5", "massless"),
    ],
)
def test_a_link_without_physical_meaning_is_refused_as_by_the_page(link, message):
    with pytest.raises(lw.ParameterError, match=message):
        motion_of(link)


def test_a_bad_instant_is_refused():
    with pytest.raises(LinkError, match="at=soon: 'soon' is not a number"):
        time_of("case=figure-3&at=soon", lw.case("figure-3").simulate())
