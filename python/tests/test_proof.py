import json
import math
import re
from fractions import Fraction
from html import escape
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg

from littlewood.certify import NoCertificate, Proof, Refused, checker
from littlewood.certify.__main__ import main
from littlewood.certify.checker import DOWN, GAP, SLIP, TURNING, UP, Range
from littlewood.certify.picture import caption, description, title
from littlewood.certify.proof import _enclosed
from littlewood.plot.canvas import PictureError
from littlewood.tables import CAUSE_LABELS

CERTIFICATES = Path(__file__).resolve().parents[2] / "evidence" / "truth" / "certificates"
DRAWN = Path(__file__).resolve().parents[2] / "docs" / "proofs"


def of_each_family():
    """The shortest certificate of each family, and more.

    Two of the paper that glide and settle, and a throw with a leap.
    """
    names = {}
    for path in sorted(CERTIFICATES.glob("*.json"), key=lambda one: one.stat().st_size):
        names.setdefault(json.loads(path.read_text(encoding="utf-8"))["case"]["family"], path.stem)
    return sorted({*names.values(), "paper-02", "paper-04", "thrown-12"})


@pytest.fixture(scope="module", params=of_each_family())
def proof(request):
    return proof_of(request.param)


def proof_of(name):
    return Proof.of(json.loads((CERTIFICATES / f"{name}.json").read_text(encoding="utf-8")))


def time(state):
    return float(state["time"][0])


def test_the_stretches_are_the_time_between_the_events(proof):
    whole = proof.certificate
    assert proof.stretches[0].start == 0.0
    for one, after in pairwise(proof.stretches):
        # Infinitely many bounces fill less than a last place.
        assert one.end == one.enclosed and abs(after.start - one.end) <= math.ulp(one.end)
    last, end = proof.stretches[-1], whole["end"]
    if end["kind"] == "rolls_forever":
        assert last.end is None
        assert last.repeats == ("period" in end) == bool(last.guards)
        if last.repeats:
            period = float(end["period"][0])
            assert last.enclosed - last.start == pytest.approx(
                period, abs=2 * math.ulp(last.enclosed)
            )
    elif end["kind"] == "rests":
        assert (last.mode, last.end, last.guards) == ("rest", None, {})
        assert abs(last.start - time(end["state"])) <= math.ulp(last.start)
    else:
        assert abs(last.end - time(end["state"])) <= math.ulp(last.end)
        assert (
            last.enclosed == last.end
            or last.repeats
            or end["kind"] == "particle_at_plane"
            or not last.guards
        )
    # Each event ends a stretch, but a jam at the start; each stretch but the last ends with an
    # event or a bounce.
    ends = [0.0] + [one.end for one in proof.stretches if one.end is not None]
    events = [time(event["state"]) for event in whole["events"]]
    assert all(min(abs(at - one) for one in ends) <= math.ulp(at) for at in events)
    settled = [one for one, event in enumerate(whole["events"]) if event["cause"] == "settle"]
    for one in proof.stretches[:-1]:
        listed = min(abs(one.end - at) for at in events) <= math.ulp(one.end)
        assert listed or any(events[k - 1] <= one.end <= events[k] for k in settled)


def test_guards_are_enclosed_without_a_gap_and_above_0(proof):
    for one in proof.stretches:
        times = {tuple((box.start, box.end) for box in boxes) for boxes in one.guards.values()}
        assert len(times) == (1 if one.guards else 0)
        for boxes in one.guards.values():
            assert boxes[0].start == one.start and boxes[-1].end == one.enclosed
            assert all(box.end == after.start for box, after in pairwise(boxes))
            # The value where two meet is in both.
            assert all(
                max(box.low, after.low) <= min(box.high, after.high)
                for box, after in pairwise(boxes)
            )
            # Slip and gap may begin with a zero, and one guard ends with one.
            assert all(0.0 < box.low <= box.high for box in boxes[1:-1])
            assert boxes[0].low >= 0.0 or len(boxes) == 1
        # The shortest bounce takes more than 2⁻¹⁵¹, and time has 192 bits: so well is its end
        # known.
        zeros = [
            boxes[-1].low <= 2.0**-40 * max(box.high for box in boxes)
            for boxes in one.guards.values()
        ]
        assert sum(zeros) == 1 or (one is proof.stretches[-1] and sum(zeros) == 0)


def test_a_slip_and_a_gap_that_begin_with_0_are_enclosed_with_it(proof):
    start = proof.certificate["case"]["start"]
    at_rest = {
        time(event["state"]): event["state"]["slip"][0] == "0"
        for event in proof.certificate["events"]
    }
    at_rest[0.0] = start["slip"] == 0.0 or at_rest.get(0.0, False)
    for one in proof.stretches:
        if GAP in one.guards:
            assert one.guards[GAP][0].low <= 0.0
        if SLIP in one.guards:
            nearest = min(at_rest, key=lambda at: abs(at - one.start))
            # One interval may also end with a zero.
            boxes = one.guards[SLIP]
            assert (boxes[0].low <= 0.0) == at_rest[nearest] or (
                len(boxes) == 1 and not at_rest[nearest]
            )


def test_at_one_place_of_a_flight_the_gap_is_enclosed_narrowly():
    case = json.loads((CERTIFICATES / "thrown-12.json").read_text(encoding="utf-8"))["case"]
    with checker.precision(192):
        given = checker.Given(case)
        run = checker.follow(given, checker.Phase(given, given.start, "flight", 0, 1), 100)
        leaps = 0
        for step in run.steps:
            middle = Range.of(Fraction(1, 2))
            low, high = _enclosed(step, GAP, step.guards[GAP], middle, middle)
            gap = float(run.phase.state(*step.moment(middle)).gap)
            # A leap knows it to 2 h.
            wide = 2 * float(given.body.h) if step.leaps else 0.0
            assert high - low == pytest.approx(wide, abs=1e-15)
            assert low - 1e-15 <= gap <= high + 1e-15
            leaps += step.leaps
        assert 0 < leaps < len(run.steps)


def guards_of(sample, mode, hoop):
    """What guards are at a sample of a hoop with mass."""
    normal, friction = float(sample["normal"][0]), float(sample["friction"][0])
    slip = {SLIP: abs(float(sample["slip"][0]))}
    turns = {TURNING: abs(float(sample["theta_rate"][0]))} if "couple" in sample else {}
    return {
        "rolling": {UP: hoop["mu_s"] * normal - friction, DOWN: hoop["mu_s"] * normal + friction}
        | turns,
        "sliding": slip | turns,
        "flight": {GAP: float(sample["gap"][0])},
        "skidding": slip,
        "rest": {},
    }[mode]


def test_the_samples_of_the_certificate_are_within_the_enclosures(proof):
    """The maker has found them, too, by other means."""
    whole = proof.certificate
    if proof.massless:
        pytest.skip("its samples have no forces")
    compared = 0
    for phase in whole["phases"]:
        for sample in phase["samples"]:
            stretch = next(
                one
                for one in proof.stretches
                if one.start < time(sample) and (one.end is None or time(sample) < one.end)
            )
            assert stretch.mode == phase["mode"]
            for name, value in guards_of(sample, phase["mode"], whole["case"]["hoop"]).items():
                for box in stretch.guards[name]:
                    if box.start <= time(sample) <= box.end:
                        # Rounding of the margin: two products and a sum.
                        more = 4 * 2.0**-52 * max(1.0, abs(float(sample["normal"][0])))
                        assert box.low - more <= value <= box.high + more
                        compared += 1
    assert compared or proof.stretches[-1].repeats or not proof.stretches[-1].guards


@pytest.fixture(scope="module")
def paper():
    return proof_of("paper-01")


def spans(axes):
    """The stretches that a row shades, from its left to its right edge."""
    boxes = [patch.get_extents().transformed(axes.transData.inverted()) for patch in axes.patches]
    return [(box.x0, box.x1) for box in boxes]


def test_what_is_drawn_is_the_time_between_the_events_and_the_boxes_of_the_events(paper):
    figure = paper.plot()
    angle, *guards, radius = figure.axes
    labels = [axes.get_ylabel() for axes in guards]
    # Symbols are set in italics.
    labels = [re.sub("[*_{}]", "", label) for label in labels]
    assert labels == ["|η′|\n(√(gR))", "w", "P", "μsN − F\n(m2g)", "μsN + F\n(m2g)", "gap\n(R)"]
    events = [time(event["state"]) for event in paper.certificate["events"]]
    stick, slip, lift_off, landing = events
    between = [(0.0, stick), (stick, slip), (slip, lift_off), (lift_off, landing)]
    sliding, rolling, flight = [between[0], between[2]], [between[1]], [between[3]]
    for axes, expected in zip(guards, [sliding] * 3 + [rolling] * 2 + [flight], strict=True):
        assert np.allclose(spans(axes), expected, rtol=0.0, atol=1e-12)
    # The paper's hoop lifts off at h cos θ θ′² = 1; the time is that of the README.
    assert lift_off == pytest.approx(1.518670213819437, abs=1e-15)
    for axes, heights in (
        (angle, [float(event["state"]["theta"][0]) for event in paper.certificate["events"]]),
        (
            radius,
            [
                math.log10(float(event["state"]["theta"][1]))
                for event in paper.certificate["events"]
            ],
        ),
    ):
        (marks,) = [line for line in axes.get_lines() if line.get_marker() == "s"]
        assert marks.get_xdata().tolist() == events and marks.get_ydata().tolist() == pytest.approx(
            heights
        )


RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")


def test_each_event_is_listed_with_its_digits_and_its_width(paper):
    words = [text.get_text() for text in paper.plot().texts]
    for number, event in enumerate(paper.certificate["events"], 1):
        middle, radius = event["state"]["time"]
        place = words.index(str(number))
        assert words[place + 1] == CAUSE_LABELS[event["cause"]]
        found, mantissa, power = re.fullmatch(
            "(.+) ± ([0-9.]+)·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", words[place + 2]
        ).groups()
        assert found == middle
        assert Fraction(mantissa) * Fraction(10) ** int(power.translate(RAISED)) == Fraction(radius)
    # A narrow picture has fewer digits, and says so.
    digits = [text.get_text() for text in paper.plot(60.0).texts if "±" in text.get_text()]
    assert len(digits) == 4 and all(re.match("[0-9]\\.[0-9]{8,}…", one) for one in digits)


@pytest.mark.parametrize(
    ("name", "words"),
    [
        (
            "paper-02",
            "Hatched: by a closed form the slip does not end before the particle is at the plane.",
        ),
        ("paper-04", "Rolling repeats itself after 4.47968 √(R/g), for ever."),
        ("near-tie-29", "Rolling repeats itself after 9.22116 √(R/g), for ever."),
    ],
)
def test_the_caption_says_what_is_proved_without_enclosures(name, words):
    found = proof_of(name)
    assert caption(found).endswith(words)
    hatched = [patch for axes in found.plot().axes for patch in axes.patches if patch.get_hatch()]
    assert bool(hatched) == words.startswith("Hatched")


def test_the_least_bound_of_a_near_tie_is_written():
    found = proof_of("near-tie-29")
    # By its choice μs exceeds the largest |F|/N of the orbit by 10⁻¹⁴ of it, so that the margins
    # are less than that.
    samples = found.certificate["phases"][0]["samples"]
    most = (
        1.01e-14
        * found.certificate["case"]["hoop"]["mu_s"]
        * max(float(one["normal"][0]) for one in samples)
    )
    written = [text.get_text() for axes in found.plot().axes[1:-1] for text in axes.texts]
    assert len(written) == 2
    for text in written:
        mantissa, power = re.fullmatch("> ([0-9.]+)·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)", text).groups()
        assert 0.0 < float(mantissa) * 10.0 ** int(power.translate(RAISED)) < most


@pytest.mark.parametrize("width", [60.0, 84.0, 178.0])
def test_words_are_within_the_picture_and_beside_each_other(proof, width):
    figure = proof.plot(width)
    FigureCanvasAgg(figure).draw()
    shown = [
        *figure.texts,
        *figure.legends[0].get_texts(),
        *(text for axes in figure.axes for text in axes.texts),
    ]
    for axes in figure.axes:
        shown += [axes.xaxis.label, axes.yaxis.label]
        for axis in (axes.xaxis, axes.yaxis):
            low, high = axis.get_view_interval()
            shown += [
                tick.label1 for tick in axis.get_major_ticks() if low <= tick.get_loc() <= high
            ]
    boxes = [
        (one.get_text(), one.get_window_extent())
        for one in shown
        if one.get_text() and one.get_visible()
    ]
    whole = figure.bbox
    for k, (text, box) in enumerate(boxes):
        assert (
            whole.x0 <= box.x0 and box.x1 <= whole.x1 and whole.y0 <= box.y0 and box.y1 <= whole.y1
        ), text
        for other, beside in boxes[:k]:
            across = min(box.x1, beside.x1) - max(box.x0, beside.x0)
            along = min(box.y1, beside.y1) - max(box.y0, beside.y0)
            # Boxes of letters have room for what hangs down; digits are half as high.
            room = 0.4 if re.fullmatch("[0-9.]+", text + other) else 0.15
            assert across <= 0.0 or along <= room * box.height, (text, other)


def test_the_command_draws_each_format(tmp_path, capsys, paper):
    certificate = CERTIFICATES / "paper-01.json"
    for kind in ("svg", "pdf", "png"):
        path = tmp_path / f"proof.{kind}"
        assert main(["--check", str(certificate), "--picture", str(path), "--width-mm", "84"]) == 0
        assert capsys.readouterr().err == f"{path}: paper-01: 4 events and no others, proved\n"
        again = tmp_path / f"again.{kind}"
        assert main(["--check", str(certificate), "--picture", str(again), "--width-mm", "84"]) == 0
        capsys.readouterr()
        assert path.read_bytes() == again.read_bytes()
    svg = (tmp_path / "proof.svg").read_text(encoding="utf-8")
    assert (
        f"<title>{title(paper)}</title>" in svg
        and f"<desc>{escape(description(paper))}</desc>" in svg
    )
    assert re.search(r'width="238\.1[0-9]*pt"', svg)
    pdf = (tmp_path / "proof.pdf").read_bytes()
    assert b"/FontFile2" in pdf and b"/ToUnicode" in pdf and b"/Type3" not in pdf
    assert b"pHYs" in (tmp_path / "proof.png").read_bytes()


def test_what_is_no_certificate_is_not_drawn(tmp_path, capsys, paper):
    picture = tmp_path / "proof.svg"

    def refused(text, code, message):
        path = tmp_path / "certificate.json"
        path.write_text(text, encoding="utf-8")
        assert main(["--check", str(path), "--picture", str(picture)]) == code
        assert message in capsys.readouterr().err
        assert not picture.exists()

    refused(
        "{}", 2, "error: this is no certificate: certificate = an object must have format\nhint: "
    )
    refused('{"type": "FeatureCollection"}', 2, "error: this is no certificate: ")
    refused("[1, 2", 2, "error: this is no JSON")
    text = (CERTIFICATES / "paper-01.json").read_text(encoding="utf-8")
    refused(
        text.replace("1.51867", "1.51868"), 1, "refused: the digest is not that of the certificate"
    )
    with pytest.raises(NoCertificate, match="must have case"):
        Proof.of({key: value for key, value in paper.certificate.items() if key != "case"})
    with pytest.raises(Refused, match="digest"):
        Proof.of(paper.certificate | {"digest": "0" * 64})
    path = str(CERTIFICATES / "paper-01.json")
    assert main(["--check", path, "--picture", str(tmp_path / "proof.bmp")]) == 2
    assert "must end in .svg, .pdf or .png" in capsys.readouterr().err
    assert main(["--check", path, "--picture", str(picture), "--width-mm", "20"]) == 2
    assert "60 to 1000 mm wide, not 20" in capsys.readouterr().err
    for width in (59.0, 1001.0, math.nan):
        with pytest.raises(PictureError):
            paper.plot(width)
    assert list(tmp_path.glob("proof.*")) == []


def test_a_made_certificate_is_drawn(tmp_path, capsys):
    given = [
        "--mass-ratio=1",
        "--offset=1",
        "--inertia=1",
        "--mu-s=0.5",
        "--mu-k=0.4",
        "--theta=0.4",
        "--theta-rate=-1",
    ]
    given += ["--slip=0.25", "--gap-rate=0.1", "--out", str(tmp_path / "made.json")]
    assert main([*given, "--picture", str(tmp_path / "made.svg")]) == 0
    assert "1 event and no other, proved" in capsys.readouterr().err
    assert (tmp_path / "made.svg").stat().st_size > 10_000


@pytest.mark.parametrize("path", sorted(DRAWN.glob("*.svg")), ids=lambda path: path.stem)
def test_the_pictures_of_the_pages_are_those_of_the_certificates(path):
    found = proof_of(path.stem)
    text = path.read_text(encoding="utf-8")
    assert f"<title>{title(found)}</title>" in text
    assert f"<desc>{description(found)}</desc>" in text.replace("&gt;", ">")
