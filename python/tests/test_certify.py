import ast
import cmath
import copy
import csv
import hashlib
import importlib.util
import io
import itertools
import json
import math
import operator
import random
import re
import shutil
import subprocess
import sys
import tarfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from fractions import Fraction
from pathlib import Path
from typing import Any

import flint
import pytest
from conftest import RESISTANCE

from littlewood.certify import Case, CaseError, Refused, certify, check, checker, dump
from littlewood.certify.__main__ import main
from littlewood.certify.checker import Range, digest, pi, precision, sine_and_cosine
from littlewood.certify.compare import differences, simulated
from littlewood.scoring import CASES

ROOT = Path(__file__).resolve().parents[2]
TRUTH = ROOT / "evidence" / "truth"
THIN = (1.0, 1.0, 1.0, 0.5, 0.4)
FIGURE_3 = Case(THIN, (math.pi / 2, 2.0, 0.0, 0.0))
THROWN = Case(THIN, (0.4, -1.0, 0.25, 0.1))
NAMES = ("time", "theta", "theta_rate", "slip", "x")


@pytest.fixture(scope="module")
def figure_3() -> dict[str, Any]:
    return certify(FIGURE_3)


@pytest.fixture(scope="module")
def thrown() -> dict[str, Any]:
    return certify(THROWN)


def script(name: str) -> Any:
    """A program of the data set."""
    spec = importlib.util.spec_from_file_location(name, TRUTH / f"{name}.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def sealed(certificate: dict[str, Any]) -> dict[str, Any]:
    return certificate | {"digest": digest(certificate)}


def numbers(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The places of all pairs of midpoint and radius."""
    if isinstance(value, list) and len(value) == 2 and all(isinstance(one, str) for one in value):
        return [path]
    found = (
        value.items()
        if isinstance(value, dict)
        else enumerate(value)
        if isinstance(value, list)
        else ()
    )
    return [place for key, one in found for place in numbers(one, (*path, key))]


def with_another_digit(
    certificate: dict[str, Any], place: tuple[Any, ...], part: int
) -> dict[str, Any]:
    """The certificate with the last digit of a number changed, and its digest made to fit."""
    changed = copy.deepcopy(certificate)
    at = changed
    for key in place:
        at = at[key]
    text = at[part]
    mantissa, exponent = text.split("e") if "e" in text else (text, None)
    last = str((int(mantissa[-1]) + 1) % 10)
    at[part] = mantissa[:-1] + last + ("" if exponent is None else f"e{exponent}")
    return sealed(changed)


def test_the_table_of_figure_3(figure_3: dict[str, Any]) -> None:
    # The 18 digits of an integration of the full equations by other means.
    table = {
        "stick": ("0.564107553101996775", "2.91722565678924913", "2.93644326144529657"),
        "slip": ("0.973223074772405418", "4.06633287423929559", "2.46087950463497721"),
        "lift_off": ("1.51867021381943699", "5.23673577087816786", "1.99870593711413992"),
        "landing": ("3.84739555668689421", "9.89117293957551575", "1.99870593711413992"),
    }
    assert [event["cause"] for event in figure_3["events"]] == list(table)
    for event, row in zip(figure_3["events"], table.values(), strict=True):
        for name, digits in zip(NAMES, row, strict=False):
            assert abs(Fraction(event["state"][name][0]) - Fraction(digits)) < Fraction(1, 10**16)


@pytest.mark.parametrize(
    "name",
    [
        "figure_3", "slide_sticks", "turning_point_in_slide", "equal_friction", "band",
        "ramp_jump", "steep", "uphill_slide", "falls_away_to_the_right",
    ],
)  # fmt: skip
def test_certificates_contain_the_references_of_40_digits(name: str) -> None:
    data = json.loads((ROOT / "evidence" / "reference" / "motions.json").read_text())
    motion = next(one for one in data["motions"] if one["name"] == name)
    hoop = tuple(
        float(motion["hoop"][key]) for key in ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
    )
    start = tuple(float(motion["start"][key]) for key in ("theta", "theta_rate", "slip"))
    certificate = certify(
        Case(hoop, (*start, 0.0), float(motion["until"]), slope=motion["hoop"].get("slope", 0.0))
    )
    assert certificate["certified"]
    events = certificate["events"]
    assert [one["cause"] for one in events] == [one["cause"] for one in motion["transitions"]]
    for event, transition in zip(events, motion["transitions"], strict=True):
        assert (event["to"], event["direction"]) == (transition["to"], transition["direction"] or 0)
        for key in NAMES:
            middle, radius = map(Fraction, event["state"][key])
            reference = Fraction(transition[key])
            # The reference is rounded to 25 digits.
            assert abs(middle - reference) <= radius + abs(reference) * Fraction(6, 10**25), (
                event["cause"],
                key,
            )


def test_the_library_is_within_its_ulps(figure_3: dict[str, Any], thrown: dict[str, Any]) -> None:
    for certificate, most in ((figure_3, 16), (thrown, 8)):
        found = differences(certificate)
        assert len(found) == 5 * len(certificate["events"])
        assert max(one.ulps for one in found) < most


def test_a_planted_error_is_seen_by_the_comparison(figure_3: dict[str, Any]) -> None:
    planted = copy.deepcopy(figure_3)
    time = planted["events"][0]["state"]["time"]
    time[0] = str(float(time[0]) + 2.0**-40)
    found = next(one for one in differences(planted) if one.quantity == "time")
    assert found.ulps == pytest.approx(4096, rel=0.01)


def test_the_checker_finds_every_number_again(figure_3: dict[str, Any]) -> None:
    assert check(figure_3)["numbers"] == len(numbers(figure_3))


def test_the_checker_refuses_any_changed_digit(thrown: dict[str, Any]) -> None:
    places = numbers(thrown)
    assert len(places) == check(thrown)["numbers"] > 40
    for place in places:
        for part in (0, 1):
            with pytest.raises(Refused):
                check(with_another_digit(thrown, place, part))


def test_the_checker_refuses_changed_digits_of_slides_and_rolling(figure_3: dict[str, Any]) -> None:
    for place in (
        ("events", 0, "state", "time"),
        ("initial", "evidence", "contact"),
        ("phases", 0, "samples", 0, "x"),
    ):
        for part in (0, 1):
            with pytest.raises(Refused):
                check(with_another_digit(figure_3, place, part))


@pytest.fixture(scope="module")
def mutate() -> Any:
    return script("mutate")


@pytest.mark.thorough
def test_the_checker_refuses_forgeries_of_each_family(mutate: Any) -> None:
    families = {one.given["family"] for one in CASES.values()}
    assert {CASES[name].given["family"] for name in mutate.QUICK} == families
    kinds, count = set(), 0
    for name in mutate.QUICK:
        certificate = mutate.read(name)
        assert mutate.accepted(certificate), name
        for kind, text in mutate.texts(certificate):
            assert digest(checker.read(text)) == certificate["digest"]
            assert not mutate.accepted(text), (name, kind)
        forged = [*mutate.mutations(certificate), *mutate.structures(certificate)]
        # `mutate.py` itself tries all of them.
        for kind, changed in random.Random(name).sample(forged, min(len(forged), 160)):
            assert changed != certificate and changed.get("digest") in (None, digest(changed))
            assert not mutate.accepted(changed), (name, kind)
            kinds.add(kind)
            count += 1
    assert count > 2000 and len(kinds) > 150


def test_the_checker_refuses_bounces_that_are_left_out_before_a_settlement(mutate: Any) -> None:
    certificate = mutate.read("settles-sticking-04")
    assert [one["cause"] for one in certificate["events"]][:6] == ["landing"] * 5 + ["settle"]
    forged = list(mutate.behind_settle(certificate))
    assert len(forged) == 4
    assert [one["cause"] for one in forged[-1]["events"]][:2] == ["landing", "settle"]
    assert float(forged[-1]["events"][0]["state"]["gap_rate"][0]) > 0.1
    for one in forged:
        with pytest.raises(Refused, match=r"phases\[\d\].samples are \d, not 0"):
            check(sealed(one))


def test_only_a_bounce_below_the_listed_rate_is_left_to_the_settlement() -> None:
    for path in sorted((TRUTH / "certificates").glob("*settl*.json")):
        events = json.loads(path.read_text())["events"]
        for before, event in itertools.pairwise(events):
            if (
                event["cause"] in ("landing", "settle")
                and before["to"] == "flight"
                and "impact" in before
            ):
                assert (float(before["state"]["gap_rate"][0]) < 1e-3) == (
                    event["cause"] == "settle"
                ), path.stem


def test_the_checker_is_one_file_that_takes_nothing_from_the_package(tmp_path: Path) -> None:
    file = Path(checker.__file__)
    for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
        assert not (isinstance(node, ast.ImportFrom) and node.level)
        if isinstance(node, ast.Import | ast.ImportFrom):
            names = (
                [one.name for one in node.names]
                if isinstance(node, ast.Import)
                else [node.module or ""]
            )
            assert {one.split(".")[0] for one in names} <= sys.stdlib_module_names
    # Alone in a folder, without packages and without the folders of this process.
    alone = shutil.copy(file, tmp_path / "checker.py")
    command = [
        sys.executable,
        "-I",
        "-S",
        str(alone),
        *(str(TRUTH / "certificates" / f"{name}.json") for name in ALONE),
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=tmp_path)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.endswith(f"{len(ALONE)} of {len(ALONE)} are right\n")
    for name in ALONE:
        found = check(json.loads((TRUTH / "certificates" / f"{name}.json").read_text()))
        assert (
            f"{name}.json: {found['numbers']} numbers of {found['events']} events are right"
            in done.stdout
        )


ALONE = ("landing-18", "jam-13", "thrown-01")


def test_a_change_of_anything_else_breaks_the_digest(thrown: dict[str, Any]) -> None:
    for key, part in (("case", "name"), ("case", "family"), ("phases", 0), ("end", "kind")):
        changed = copy.deepcopy(thrown)
        changed[key][part] = thrown["phases"][0] | {"samples": []} if part == 0 else "another"
        with pytest.raises(Refused, match="digest"):
            check(changed)


def test_the_checker_refuses_another_mode_and_a_missing_event(figure_3: dict[str, Any]) -> None:
    changed = copy.deepcopy(figure_3)
    changed["initial"]["direction"] = 1
    with pytest.raises(Refused, match=r"initial.direction is -1, not 1"):
        check(sealed(changed))
    changed = copy.deepcopy(figure_3)
    del changed["events"][0]
    with pytest.raises(Refused):
        check(sealed(changed))


def test_a_certificate_has_the_same_bytes_whatever_the_precision(thrown: dict[str, Any]) -> None:
    from littlewood.certify import certificate as maker

    before = maker.PRECISIONS
    try:
        maker.PRECISIONS = (400,)
        again = certify(THROWN)
    finally:
        maker.PRECISIONS = before
    for place in numbers(thrown):
        one, other = thrown, again
        for key in place:
            one, other = one[key], other[key]
        assert one == other, place


def test_committed_certificates_are_made_again() -> None:
    for name in RECERTIFIED:
        committed = (TRUTH / "certificates" / f"{name}.json").read_text()
        assert dump(certify(Case.read(CASES[name].given))) == committed, name


RECERTIFIED = (
    "paper-01",
    "lift-off-02",
    "landing-04",
    "landing-16",
    "landing-28",
    "landing-40",
    "elastic-01",
    "near-tie-01",
    "long-rolling-11",
    "thrown-01",
    "leaves-at-once-01",
    "si-09",
    "jam-13",
    "landing-33",
    "massless-17",
    "rests-rolling-04",
    "rests-sliding-01",
    "rests-landing-12",
    "ramp-rests-13",
    "rests-massless-04",
    "rests-elastic-07",
    "ramp-settles-02",
    "ramp-settles-09",
    "rests-si-01",
)


def test_every_case_of_the_list_has_its_certificate() -> None:
    files = {path.stem for path in (TRUTH / "certificates").glob("*.json")}
    assert files == set(CASES)
    assert f"- {len(files)} [certified motions]" in (ROOT / "docs" / "index.md").read_text()
    for name, one in CASES.items():
        certificate = json.loads((TRUTH / "certificates" / f"{name}.json").read_text())
        assert certificate["case"] == Case.read(one.given).written()
        assert certificate["digest"] == digest(certificate)
        assert certificate["certified"] or certificate["reason"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (dict(hoop=(-1.0, 1.0, 1.0, 0.5, 0.4)), "hoop.mass_ratio = -1.0 must be at least 0"),
        (dict(hoop=(1.0, 1.5, 1.0, 0.5, 0.4)), "hoop.offset = 1.5 must be at most 1"),
        (dict(hoop=(1.0, 1.0, -1.0, 0.5, 0.4)), "hoop.inertia = -1.0 must be at least 0"),
        (dict(hoop=(1.0, 1.0, 1.0, 0.3, 0.4)), "hoop.mu_k = 0.4 must be at most mu_s = 0.3"),
        (dict(hoop=(1.0, 1.0, 1.0, 0.3, -0.1)), "hoop.mu_k = -0.1 must be at least 0"),
        (
            dict(hoop=(0.0, 1.0, 0.5, 0.5, 0.4)),
            "hoop.inertia = 0.5 must be 0 if the mass of the hoop, 0.0, is",
        ),
        (dict(hoop=(0.0, 0.5, 0.0, 0.5, 0.4)), "hoop.offset = 0.5 must be the radius, 1"),
        (
            dict(hoop=(0.0, 1.0, 0.0, 0.5, 0.4), start=(0.0, 0.0, 0.0, 1.0)),
            "start.gap_rate = 1.0 must be 0",
        ),
        (dict(slope=1.6), "hoop.slope = 1.6 must be at most 1.5707963267948966"),
        (dict(slope=-1.6), "hoop.slope = -1.6 must be at least -1.5707963267948966"),
        (
            dict(hoop=(0.0, 1.0, 0.0, 0.5, 0.4), slope=0.1),
            "hoop.slope = 0.1 must be 0: the hoop has no mass",
        ),
        (dict(start=(math.nan, 1.0, 0.0, 0.0)), "start.theta = nan must be finite"),
        (dict(start=(0.0, 1.0, 0.0, -1.0)), "start.gap_rate = -1.0 must be at least 0"),
        (dict(until=0.0), "until = 0.0 must be above 0"),
        (dict(until=math.inf), "until = inf must be finite"),
        (dict(restitution=1.5), "hoop.restitution = 1.5 must be at most 1"),
        (dict(restitution=0.5, law="foo"), "hoop.restitution_law = 'foo' must be one of energetic"),
        (dict(units="furlong"), "units = 'furlong' must be one of dimensionless, si"),
    ],
)
def test_bad_cases_are_refused_by_maker_and_checker(
    change: dict[str, Any], message: str, thrown: dict[str, Any]
) -> None:
    whole: dict[str, Any] = dict(hoop=THIN, start=(0.0, 1.0, 0.0, 0.0)) | change
    with pytest.raises(CaseError, match=re.escape(message)):
        Case(**whole)
    names = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
    hoop: dict[str, Any] = dict(zip(names, whole["hoop"], strict=True))
    hoop |= {"slope": whole["slope"]} if "slope" in whole else {}
    if "restitution" in whole:
        hoop |= {
            "restitution": whole["restitution"],
            "restitution_law": whole.get("law", "energetic"),
        }
    start = dict(zip(("theta", "theta_rate", "slip", "gap_rate"), whole["start"], strict=True))
    case = dict(
        name="", family="", units=whole.get("units", "dimensionless"), hoop=hoop, start=start
    )
    with pytest.raises(Refused, match=re.escape("case." + message)):
        check(sealed(thrown | {"case": case | {"until": whole.get("until")}}))


@pytest.mark.parametrize(
    ("hoop", "message"),
    [
        ({"mass_ratio": "1/4"}, "case.hoop.mass_ratio = '1/4' must be a number"),
        ({"mass_ratio": True}, "case.hoop.mass_ratio = True must be a number"),
        ({"mass_ratio": 10**400}, "must be finite, and exactly a double"),
        ({"mass_ratio": 2**53 + 1}, "must be finite, and exactly a double"),
        ({"colour": 1.0}, "case.hoop = an object must not have 'colour'"),
        ({"restitution": 0.5}, "case.hoop = an object must have restitution_law"),
    ],
)
def test_the_checker_takes_no_other_form_of_an_input(
    hoop: dict[str, Any], message: str, thrown: dict[str, Any]
) -> None:
    case = thrown["case"] | {"hoop": thrown["case"]["hoop"] | hoop}
    with pytest.raises(Refused, match=re.escape(message)):
        check(sealed(thrown | {"case": case}))


@pytest.mark.parametrize(
    ("text", "double"),
    [
        ("0.400000000000000022204460492503", "0.4"),
        ("0.40", "0.4"),
        ("4e-1", "0.4"),
        ("1e-400", "0.0"),
        ("-1e-400", "-0.0"),
        ("-0", "-0.0"),
        ("2.4703282292062328e-324", "5e-324"),
        ("12345678901234567.0", "1.2345678901234568e+16"),
    ],
)
def test_the_checker_takes_no_other_text_of_an_input(
    text: str, double: str, thrown: dict[str, Any], tmp_path: Path
) -> None:
    written = copy.deepcopy(thrown)
    written["case"]["start"]["theta"] = float(double)
    written = sealed(written)
    right = json.dumps(written)
    checker.intact(checker.read(right))
    other = right.replace(f'"theta": {double}', f'"theta": {text}', 1)
    assert other != right and json.loads(other) == written
    message = f"start.theta = {text} must be written {double}, the shortest text of its double"
    with pytest.raises(Refused, match=re.escape(message)):
        check(checker.read(other))
    file = tmp_path / "case.json"
    file.write_text(other)
    assert main(["--case", str(file)]) == 2


def test_a_case_is_read_with_its_defaults_and_nothing_else() -> None:
    hoop = dict(mass_ratio=1, offset=1.0, inertia=1.0, mu_s=0.5, mu_k=0.4)
    start = dict(theta=0.4, theta_rate=-1.0, slip=0.25)
    found = Case.read(dict(hoop=hoop | dict(restitution=0.5), start=start))
    assert found == Case(THIN, (0.4, -1.0, 0.25, 0.0), restitution=0.5)
    assert Case.read(found.written()) == found
    for change, message in (
        (dict(hoop=None), "the case = an object must have hoop"),
        (dict(hoop=hoop | dict(mass_ratio="1")), "hoop.mass_ratio = '1' must be a number"),
        (dict(colour=1), "the case = an object must not have 'colour'"),
        (dict(start=dict(theta=0.4)), "start = an object must have theta_rate"),
    ):
        with pytest.raises(CaseError, match=re.escape(message)):
            Case.read(dict(hoop=hoop, start=start) | change)


def test_what_is_not_certified_says_what_and_where() -> None:
    # Bounces with e = 1 that slip throughout do not settle, and are too slow to be listed.
    certificate = certify(
        Case((1.0, 0.5, 1.0, 0.3, 0.0), (0.4, 0.0, 1.0, 9e-4), 1.0, 1.0), most_bits=200
    )
    reason = certificate["reason"]
    assert (
        "time is up while bounces accumulate; flight from time 0.99" in reason
        and "theta 0." in reason
    ), reason
    with pytest.raises(Refused, match="nothing is certified: time is up"):
        check(certificate)


@pytest.mark.parametrize("chi", [0.0, 0.1])
def test_bounces_settle_on_a_slope(chi: float) -> None:
    """They do, and mirrored ones do so at the same time."""
    found = []
    for side in (1, -1):
        start = (side * 2.5, side * 0.3, side * 0.1, 0.05)
        case = Case(THIN, start, 1.0, 0.3, slope=side * 0.1, rolling_resistance=chi)
        certificate = certify(case)
        settled = [one for one in certificate["events"] if one["cause"] == "settle"]
        assert len(settled) == 1
        found.append([settled[0]["state"]["time"], settled[0]["impact"]["normal_impulse"]])
        check(certificate)
    assert found[0] == found[1]


def test_held_bounces_on_a_slope_are_a_geometric_series() -> None:
    """Nothing turns: θ stays, each flight takes 2 v/cos α, and friction ends its slip."""
    v, e, alpha = 0.25, 0.5, 0.125
    hoop, start = (1.0, 0.5, 0.5, 0.5, 0.5), (0.25, 0.0, 0.0, v)
    certificate = certify(Case(hoop, start, 9.0, e, slope=alpha, rolling_resistance=2.0))
    causes = [one["cause"] for one in certificate["events"]]
    assert causes == ["landing"] * 8 + ["settle"] and certificate["end"]["kind"] == "rests"
    with checker.precision(256):
        sin, cos = sine_and_cosine(Range.of(Fraction(alpha)))
        # 2 v/(cos α (1 − e)), and the place: −sin α Σ τ²/2, as the slip begins anew each time.
        time = 2 * Range.of(Fraction(v)) / (cos * Range.of(1 - Fraction(e)))
        first = 2 * Range.of(Fraction(v)) / cos
        place = -(sin * (first * first) / 2) / Range.of(1 - Fraction(e) ** 2)
        end = certificate["end"]["state"]
        assert end["time"] == checker.text_of(time)
        assert end["x"] == checker.text_of(place)
    check(certificate)


def test_mirrored_slopes_have_mirrored_certificates() -> None:
    """α, θ, θ′ and η′ with the other sign: the same motion from behind, to the last digit."""
    start = (1.26, -0.19, 0.18, 0.0)
    one = certify(Case((1.0, 0.9, 0.5, 0.9, 0.81), start, 12.0, slope=-0.74))
    other = certify(
        Case((1.0, 0.9, 0.5, 0.9, 0.81), (*(-value for value in start[:3]), 0.0), 12.0, slope=0.74)
    )
    assert (
        [event["cause"] for event in one["events"]]
        == [event["cause"] for event in other["events"]]
        != []
    )
    for mine, its in zip(one["events"], other["events"], strict=True):
        for name, (middle, radius) in mine["state"].items():
            factor = 1 if name in ("time", "gap", "gap_rate", "energy") else -1
            assert Fraction(its["state"][name][0]) == factor * Fraction(middle), name
            assert its["state"][name][1] == radius


WEDGED = (0.2, 0.9, 0.2, 2.29)
"""Mass ratio, offset, inertia and μs of a hoop that may roll on a slope where w < 0."""


def test_a_start_with_rolling_and_flight_is_ambiguous() -> None:
    for mu_k in (0.35, 0.9):
        case = Case((0.2, 1.0, 0.1, 1.0, mu_k), (0.5, -0.8, 0.0, 0.0), 1.0, slope=-1.1)
        certificate = certify(case)
        assert certificate["initial"]["mode"] == certificate["end"]["kind"] == "ambiguous"
        assert check(certificate)["phases"] == 0
        assert simulated(certificate["case"]).outcome.kind == "ambiguous"


@pytest.mark.parametrize("mu_k", [0.3, 2.29])
def test_rolling_goes_on_where_flight_is_consistent_and_gives_way_to_it(mu_k: float) -> None:
    """With μk = μs, too, where η″ vanishes and the next derivative decides."""
    case = Case((*WEDGED, mu_k), (0.73, -0.89, 0.0, 0.0), 1.0, slope=-1.1)
    certificate = certify(case)
    assert certificate["initial"]["mode"] == "rolling"
    (event,) = certificate["events"]
    assert (event["cause"], event["to"]) == ("slip", "flight")
    assert (
        float(event["evidence"]["contact"][0]) < 0 < float(event["evidence"]["rolling_normal"][0])
    )
    assert check(certificate)["events"] == 1
    assert max(one.ulps for one in differences(certificate)) < 4


def test_a_landing_at_rest_rolls_where_flight_is_consistent() -> None:
    """The contact is compressed, and in stick its force relaxes to that of rolling."""
    case = Case((0.2, 0.9, 0.1, 2.03, 0.3), (2.5, -1.1, -0.3, 0.68), 3.0, 0.0, slope=-1.0)
    certificate = certify(case)
    landing, slip = certificate["events"]
    assert (landing["cause"], landing["to"]) == ("landing", "rolling")
    assert float(landing["evidence"]["contact"][0]) < 0
    assert (slip["cause"], slip["to"]) == ("slip", "flight")
    assert check(certificate)["events"] == 2
    assert max(one.ulps for one in differences(certificate)) < 64


def test_rolling_down_a_slope_has_its_closed_form() -> None:
    """With ℓ = 0, x″ = −m sin α/D with D = Î + m.

    At the end of time θ = θ0 + θ0′ t + m sin α t²/2D.
    """
    certificate = certify(Case((1.0, 0.0, 0.5, 0.5, 0.4), (0.25, 0.5, 0.0, 0.0), 3.0, slope=0.3))
    with precision(256):
        sin, _ = sine_and_cosine(Range.of(Fraction(0.3)))
        theta = Range.of(Fraction(0.25) + Fraction(0.5) * 3) + sin * 9 * 2 / 5
        low, high = theta.ends()
    middle, radius = map(Fraction, certificate["end"]["state"]["theta"])
    assert middle - radius <= low and high <= middle + radius
    assert not certificate["events"]
    assert check(certificate)["events"] == 0


def of_families(most: int) -> Iterator[dict[str, Any]]:
    """So many motions of each family of the program of rolling resistance that can be proved."""
    counts: dict[str, int] = {}
    for motion in RESISTANCE:
        # A certificate of a massless hoop has its particle on the rim; discs roll for a long time.
        if motion["family"] == "massless" and motion["hoop"]["offset"] != 1:
            continue
        if motion["family"] == "discs" and motion["ended"] != "rests":
            continue
        counts[motion["family"]] = counts.get(motion["family"], 0) + 1
        if counts[motion["family"]] <= most:
            yield motion


def resisted(motion: dict[str, Any]) -> Case:
    """The case of a motion of the program of rolling resistance."""
    hoop, start = motion["hoop"], motion["start"]
    return Case(
        tuple(hoop[name] for name in ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")),
        (start["theta"], start["theta_rate"], start["slip"], start["gap_rate"]),
        motion["until"],
        motion["restitution"],
        motion["law"] or "energetic",
        slope=hoop["slope"],
        rolling_resistance=hoop["rolling_resistance"],
    )


def contains(ball: list[str], reference: str) -> bool:
    """Whether a ball contains a reference rounded to 30 digits, to rounding of its last steps."""
    middle, radius, number = *map(Fraction, ball), Fraction(reference)
    return abs(middle - number) <= radius + max(1, abs(number)) * Fraction(1, 10**29)


@pytest.mark.parametrize(
    "motion",
    list(of_families(2)),
    ids=lambda motion: f"{motion['family']} {motion['start']['theta']:.3f}",
)
def test_certificates_contain_the_motions_of_the_program_of_rolling_resistance(
    motion: dict[str, Any],
) -> None:
    certificate = certify(resisted(motion))
    assert certificate["certified"], certificate["reason"]
    names = {"turning": "turning_point", "none": "inconsistent"}
    transitions = motion["transitions"]
    assert [one["cause"] for one in certificate["events"]] == [
        names.get(one["cause"], one["cause"]) for one in transitions
    ]
    for event, transition in zip(certificate["events"], transitions, strict=True):
        to = transition["to"]
        if to is not None:
            turning = 0 if to["mode"] == "flight" else to["turning"]
            assert (event["to"], event["direction"], event["rotation"]) == (
                to["mode"],
                to["direction"],
                turning,
            )
        reached = transition | transition.get("after", {}) if "impact" in event else transition
        for key in NAMES:
            assert contains(event["state"][key], reached[key]), (event["cause"], key)
    assert certificate["end"]["kind"] == names.get(motion["ended"], motion["ended"])
    if "state" in certificate["end"]:
        for key in NAMES:
            assert contains(certificate["end"]["state"][key], motion["end"][key]), key
    lost, energy = motion["lost"], certificate["energy"]
    hits = [one["impact"]["energy_lost"] for one in certificate["events"] if "impact" in one]
    if not hits:
        assert contains(energy["lost_in_slides"], lost["sliding"])
        assert contains(energy["lost_in_rolling_resistance"], lost["resistance"])
    whole = sum(Fraction(energy[name][0]) for name in energy if name != "start")
    assert abs(whole - sum(map(Fraction, lost.values()))) < Fraction(1, 10**27)


@pytest.mark.parametrize(
    "motion",
    [one for one in of_families(1) if one["family"] not in ("downhill", "librates", "rotates")],
    ids=operator.itemgetter("family"),
)
def test_the_checker_finds_motions_with_rolling_resistance_again(motion: dict[str, Any]) -> None:
    certificate = certify(resisted(motion))
    assert check(certificate)["numbers"] == len(numbers(certificate))


def test_a_skid_that_does_not_end_at_rest() -> None:
    """The motion of docs/theory/rolling-resistance.md, and its skid in closed form."""
    certificate = json.loads((TRUTH / "certificates" / "rests-sliding-01.json").read_text())
    skid, turn, rest = certificate["events"]
    assert certificate["initial"]["mode"] == "skidding"
    assert [(one["cause"], one["to"], one["rotation"]) for one in (skid, turn, rest)] == [
        ("stick", "rolling", 1),
        ("turning_point", "rolling", -1),
        ("turning_point", "rest", 0),
    ]
    for event, time in ((skid, "1.666666667"), (turn, "9.273748402"), (rest, "14.997017142")):
        assert abs(Fraction(event["state"]["time"][0]) - Fraction(time)) < Fraction(1, 10**9)
    # η′ falls from 1/2 by μk a unit of time, and the place by its integral.
    slip, mu_k = Fraction(0.5), Fraction(0.3)
    assert contains(skid["state"]["time"], str(slip / mu_k))
    assert contains(skid["state"]["x"], str(slip * slip / (2 * mu_k)))
    assert certificate["end"] == {"kind": "rests", "state": rest["state"], "half_swings": 2}


def test_a_disc_that_rests_on_a_slope_has_its_closed_form() -> None:
    """θ″ = m (sin α − ς χ cos α)/(Î + m): uphill it stops, and χ > tan α holds it."""
    theta_rate, chi, slope = 1.5, 0.25, 0.2
    certificate = certify(
        Case(
            (1.0, 0.0, 0.5, 0.9, 0.9),
            (0.25, -theta_rate, 0.0, 0.0),
            slope=slope,
            rolling_resistance=chi,
        )
    )
    (event,) = certificate["events"]
    assert (event["cause"], event["to"]) == ("turning_point", "rest")
    assert certificate["end"]["half_swings"] == 0
    with precision(256):
        sin, cos = sine_and_cosine(Range.of(Fraction(slope)))
        slowing = (sin + cos * Range.of(Fraction(chi))) * 4 / 5
        for name, value in (
            ("time", Range.of(Fraction(theta_rate)) / slowing),
            ("x", Range.of(Fraction(theta_rate) ** 2 / 2) / slowing),
        ):
            low, high = value.ends()
            middle, radius = map(Fraction, event["state"][name])
            assert middle - radius <= low and high <= middle + radius
    assert check(certificate)["phases"] == 2


def test_what_a_motion_with_rolling_resistance_loses_is_what_its_kinds_of_friction_take() -> None:
    found = 0
    for name, one in CASES.items():
        if not {"rolling_resistance", "rolling_resistance_m"} & one.given["hoop"].keys():
            continue
        certificate = json.loads((TRUTH / "certificates" / f"{name}.json").read_text())
        energy, state = certificate["energy"], certificate["end"]["state"]
        # The particle at the plane has no finite rate to count.
        if "energy" not in state:
            continue
        lost = [Fraction(energy[name][0]) for name in energy if name.startswith("lost")]
        left = Fraction(energy["start"][0]) - Fraction(state["energy"][0])
        gains = one.given["hoop"].get("restitution_law") == "newton"
        assert abs(left - sum(lost)) < Fraction(1, 10**26) and (min(lost) >= 0 or gains), name
        found += 1
    assert found >= 110


def test_a_state_with_no_motion_by_rolling_resistance_and_one_with_two() -> None:
    light, start = 0.0005256407325, (0.119757, 0.704997, 0.0, 0.0)
    hoop = (light, 1.0, light, 0.0809887, 0.0354555)
    for chi, kind in ((0.4198477, "inconsistent"), (0.0, "rolling")):
        certificate = certify(Case(hoop, start, 0.01, rolling_resistance=chi))
        assert certificate["initial"]["mode"] == kind
        check(certificate)
    # Complete rest on a slope with μk < μs: friction holds the rim, or the couple the angle.
    slope = Case(
        (0.18, 1.0, 0.091, 2.05, 0.2),
        (-0.6, 0.0, 0.0, 0.0),
        1.0,
        slope=1.13,
        rolling_resistance=0.44,
    )
    certificate = certify(slope)
    assert certificate["initial"]["mode"] == "ambiguous" == certificate["end"]["kind"]
    check(certificate)


@pytest.mark.parametrize(
    ("case", "reason"),
    [
        (
            Case((1.0, 0.6, 0.5, 0.4, 0.0), (0.1, 0.0, 0.5, 0.0), None, rolling_resistance=0.5),
            "a skid never ends",
        ),
        (
            Case((0.14, 1.0, 0.14, 2.36, 2.36), (1.45, 2.06, 0.0, 0.0), rolling_resistance=3.39),
            "rolling is not stable where D_χ is negative",
        ),
        # The couple holds the angle, and nothing takes energy: no bounce is the last.
        (
            Case((1.0, 0.6, 0.5, 0.5, 0.5), (0.1, 0.0, 0.0, 5e-4), None, 1.0, rolling_resistance=1),
            "the motion takes more than 20000 pieces",
        ),
        # Each impact reverses the slip of its flight, in proportion to the rate of the gap.
        (
            Case(
                (0.1, 0.9, 0.07500000000000001, 0.53, 0.53),
                (0.21, -0.7, 0.0, 0.26),
                6.0,
                0.5,
                "poisson",
                slope=-0.31,
                rolling_resistance=0.24,
            ),
            "bounces are not seen to settle",
        ),
        (
            Case((0.0, 1.0, 0.0, 0.5, 0.4), (2.0, 0.0, 0.0, 0.0), None, rolling_resistance=0.1),
            "whether particle_height or slip vanishes is not decided",
        ),
        (
            Case((0.0, 1.0, 0.0, 0.5, 0.4), (0.0, 0.0, 0.5, 0.0), None, rolling_resistance=0.1),
            "a glide begins with the particle above or below the centre",
        ),
    ],
)
def test_what_rolling_resistance_leaves_unproved_is_named(case: Case, reason: str) -> None:
    certificate = certify(case)
    assert certificate["reason"].startswith(reason), certificate["reason"]


def test_a_loss_that_vanishes_is_no_number_by_definition() -> None:
    """With e = 1 and the angle held an impact loses nothing: 0, with a radius."""
    hoop, start = (1.0, 0.6, 0.5, 0.4, 0.3), (0.1, 0.0, 0.0, 0.1)
    # It lands at 0.2, 0.4, …; at 0.9 it flies.
    certificate = certify(Case(hoop, start, 0.9, 1.0, rolling_resistance=0.1))
    assert {tuple(one["impact"]["energy_lost"]) for one in certificate["events"]} == {
        ("0", "1e-40")
    }
    check(certificate)


def test_digits_that_are_not_decided_are_named_and_more_bits_decide_them() -> None:
    slow = Case(THIN, (0.4, 0.3, 0.0, 1e-12), 1.0, 0.5)
    assert certify(slow, most_bits=200)["reason"] == (
        "the digits of a number are not decided: time of event 1 with 144 bits"
    )
    certificate = certify(slow)
    assert [one["cause"] for one in certificate["events"]] == ["landing", "settle"]
    assert check(certificate)["events"] == 2


def test_a_motion_of_too_many_pieces_is_given_up_soon(monkeypatch: pytest.MonkeyPatch) -> None:
    from littlewood.certify import motion

    monkeypatch.setattr(motion, "MOST_PIECES", 5)
    certificate = certify(FIGURE_3)
    assert not certificate["certified"]
    assert (
        "too many pieces; sliding from time 0 on, theta 1.57079633, after 0 events"
        in certificate["reason"]
    )
    monkeypatch.setattr(checker, "MOST_STEPS", 20)
    with pytest.raises(Refused, match="more than 19 steps"):
        check(sealed(json.loads((TRUTH / "certificates" / "paper-01.json").read_text())))


@pytest.mark.parametrize(
    "start", [(-2.4, 1e6, 0.7, 0.0), (-0.4, 1e6, 0.7, 0.0), (0.4, 9e5, 0.7, 1e6)]
)
def test_fast_hoops_are_certified_and_checked(start: tuple[float, float, float, float]) -> None:
    certificate = certify(Case(THIN, start))
    assert certificate["certified"] and certificate["end"]["kind"] == "landing"
    assert check(certificate)["events"] == len(certificate["events"])
    # The rim is at the plane: the gap in closed form, from the state where the flight begins, by 60
    # digits.
    events = certificate["events"]
    state = {name: arb60(one) for name, one in events[-1]["state"].items()}
    first = (
        {name: arb60(one) for name, one in events[-2]["state"].items()} if len(events) > 1 else None
    )
    with flint.ctx.workprec(300):
        theta, rate, opening, since = (
            (flint.arb(start[0]), flint.arb(start[1]), flint.arb(start[3]), flint.arb(0))
            if first is None
            else (first["theta"], first["theta_rate"], flint.arb(0), first["time"])
        )
        tau = state["time"] - since
        h = flint.arb(1) / 2
        gap = (
            (opening - h * theta.sin() * rate) * tau
            - tau * tau / 2
            - h * ((theta + rate * tau).cos() - theta.cos())
        )
        # As far as 30 digits of θ, of θ′ and of the time tell.
        assert gap.contains(0) and gap.rad() < 1e-9 * abs(start[1])


def arb60(number: list[str]) -> Any:
    return flint.arb(f"{number[0]} +/- {number[1]}")


@pytest.mark.parametrize(
    ("name", "time"),
    [
        # By an independent program, and the limit of its bounces.
        ("elastic-settling-01", "26.92382338"),
        ("elastic-settling-02", "0.75336272576"),
        ("elastic-settling-03", "1.0595254130021934"),
    ],
)
def test_bounces_of_restitution_1_settle_where_another_program_has_it(name: str, time: str) -> None:
    events = json.loads((TRUTH / "certificates" / f"{name}.json").read_text())["events"]
    found = [one["state"]["time"][0] for one in events if one["cause"] == "settle"]
    assert len(found) == 1
    assert abs(Fraction(found[0]) - Fraction(time)) < Fraction(1, 10 ** len(time.split(".")[1]))


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "certificate.json"
    hoop = ["--mass-ratio=1", "--offset=1", "--inertia=1", "--mu-s=0.5", "--mu-k=0.4"]
    assert (
        main(
            [
                *hoop,
                "--theta=0.4",
                "--theta-rate=-1",
                "--slip=0.25",
                "--gap-rate=0.1",
                "--out",
                str(file),
            ]
        )
        == 0
    )
    assert json.loads(file.read_text())["events"][0]["cause"] == "landing"
    assert main(["--check", str(file)]) == 0
    assert "numbers" in capsys.readouterr().out
    file.write_text(file.read_text().replace("0.4", "0.5", 1))
    assert main(["--check", str(file)]) == 1
    assert "refused: the digest" in capsys.readouterr().err
    assert main(hoop[:2]) == 2
    assert "a hoop needs --inertia" in capsys.readouterr().err
    assert main(["--check", str(tmp_path / "none.json")]) == 2


@pytest.mark.parametrize(
    ("data", "code", "message"),
    [
        (b"[]", 1, "certificate = a list must be an object"),
        (b"5", 1, "certificate = 5 must be an object"),
        (b"null", 1, "certificate = None must be an object"),
        (b'{"case": {}}', 1, "must have format"),
        (b"\x89PNG\r\n\x1a\n\x00\xff", 2, "this is no JSON"),
        (b"[" * 200_000, 2, "too deep"),
        (b'{"a":' * 200_000, 2, "too deep"),
        (b'{"format": "littlewood-cert', 2, "this is no JSON"),
        (b"", 2, "this is no JSON"),
        (b"NaN", 2, "NaN is no number"),
        (b'{"a": -Infinity}', 2, "-Infinity is no number"),
        (b"1" * 5000, 2, "this is no JSON"),
        (b'{"a": 1, "a": 2}', 2, "a name stands twice"),
    ],
)
def test_no_file_is_a_traceback(
    data: bytes, code: int, message: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "file.json"
    file.write_bytes(data)
    assert main(["--check", str(file)]) == code
    assert message in capsys.readouterr().err
    assert main(["--case", str(file)]) == 2
    assert "error: " in capsys.readouterr().err


def test_no_changed_byte_is_a_traceback(thrown: dict[str, Any]) -> None:
    rng, text = random.Random(8), dump(thrown).encode()
    for _ in range(300):
        data = bytearray(text)
        for _ in range(rng.choice([1, 1, 5])):
            data[rng.randrange(len(data))] = rng.randrange(256)
        try:
            found = checker.read(bytes(data[: rng.choice([len(data), rng.randrange(len(data))])]))
        except checker.Unreadable:
            continue
        if found != thrown:
            with pytest.raises(Refused):
                check(found)


def test_without_the_extra_the_message_names_it() -> None:
    code = (
        "import sys; sys.modules['flint'] = None\n"
        "from littlewood.certify.__main__ import main\n"
        "sys.exit(main(['--mass-ratio=1','--offset=1','--inertia=1','--mu-s=0.5','--mu-k=0.4']))"
    )
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert 'pip install "littlewood[certify]"' in done.stderr


@pytest.fixture
def bits() -> Iterator[None]:
    with precision(256):
        yield


@pytest.mark.usefixtures("bits")
def test_the_arithmetic_of_the_checker_encloses() -> None:
    digits = "3.14159265358979323846264338327950288419716939937510582097494459"
    low, high = pi().ends()
    assert low < Fraction(digits) + Fraction(1, 10**60) and high > Fraction(digits) - Fraction(
        1, 10**60
    )
    for angle in (Fraction(1, 3), Fraction(-29, 7), Fraction(355, 2)):
        sin, cos = sine_and_cosine(Range.of(angle))
        one = sin * sin + cos * cos
        assert one.ends()[0] <= 1 <= one.ends()[1]
        assert float(sin) == pytest.approx(math.sin(angle), abs=1e-14)
        assert float(cos) == pytest.approx(math.cos(angle), abs=1e-14)
    third = Range.of(Fraction(1)) / Range.of(Fraction(3))
    assert third.ends()[0] < Fraction(1, 3) < third.ends()[1]
    root = Range.of(Fraction(2)).sqrt()
    assert root.ends()[0] ** 2 < 2 < root.ends()[1] ** 2


@pytest.mark.usefixtures("bits")
def test_the_series_of_the_checker_solve_their_equation() -> None:
    # x′ = y/z, y′ = x z and z′ = −z, from x = 0 and y = z = 1: the residual, by exact fractions.
    one, length = Range.of(1), Range.of(Fraction(1, 4))
    x, y, z = (
        checker.Integral(Range(0), length),
        checker.Integral(one, length),
        checker.Integral(one, length),
    )
    x.of, y.of, z.of = y / z, x * z, -z
    count = 20
    middle = {
        name: [Fraction(of[k].m, 1 << 256) for k in range(count)]
        for name, of in (("x", x), ("y", y), ("z", z))
    }

    def product(a: list[Fraction], b: list[Fraction], k: int) -> Fraction:
        return sum((a[j] * b[k - j] for j in range(k + 1)), Fraction(0))

    for k in range(count - 1):
        slope = [[4 * (j + 1) * middle[name][j + 1] for j in range(k + 1)] for name in "xyz"]
        for residual in (
            product(slope[0], middle["z"], k) - middle["y"][k],
            slope[1][k] - product(middle["x"], middle["z"], k),
            slope[2][k] + middle["z"][k],
        ):
            assert abs(residual) < Fraction(1, 10**70)
    assert all(0 < x[k].r < 100 for k in range(1, count))
    tenth = checker.at((z[k] for k in range(count - 1, -1, -1)), Range.of(Fraction(2, 5)))
    assert float(tenth) == pytest.approx(math.exp(-0.1), abs=1e-15)


def guard(coefficients: list[Fraction]) -> Any:
    return checker.Guard([Range.of(one) for one in coefficients], Range(1), Range(1))


def product(*roots: Fraction) -> list[Fraction]:
    """The coefficients of the product of all r − s."""
    found = [Fraction(1)]
    for root in roots:
        found = [
            root * a - b for a, b in zip([*found, Fraction(0)], [Fraction(0), *found], strict=True)
        ]
    return found


@pytest.mark.usefixtures("bits")
def test_a_guard_that_falls_without_a_zero_does_not_hide_the_first_one_of_another() -> None:
    slip = guard(product(Fraction(1, 10), Fraction(1, 5), Fraction(4, 5)))
    contact = guard([Fraction(1), Fraction(-3, 10), Fraction(-69, 100)])
    for guards in (
        {"slip": slip},
        {"slip": slip, "contact": contact},
        {"contact": contact, "slip": slip},
    ):
        _, found = checker.first_zero(guards)
        assert found is not None
        name, s = found
        assert name == "slip" and s.ends()[0] <= Fraction(1, 10) <= s.ends()[1] and s.r < 100


@pytest.mark.usefixtures("bits")
def test_the_first_zero_of_random_polynomials_is_the_least_of_their_roots() -> None:
    rng, none = random.Random(3), 0
    for _ in range(150):
        roots: dict[str, list[Fraction]] = {}
        for name in "abc"[: rng.choice([1, 2, 3])]:
            inside = [
                Fraction(rng.randrange(1, 1000), 1000) for _ in range(rng.choice([0, 0, 1, 2, 3]))
            ]
            roots[name] = inside + [
                Fraction(rng.randrange(1001, 3000), 1000) for _ in range(rng.choice([0, 1, 2]))
            ]
        every = [root for found in roots.values() for root in found if root < 1]
        if len(set(every)) < len(every):
            # A double zero is not decided, and two guards that vanish together are not.
            continue
        expected = min(
            ((root, name) for name, found in roots.items() for root in found if root < 1),
            default=None,
        )
        free, found = checker.first_zero(
            {name: guard(product(*one)) for name, one in roots.items()}
        )
        # Where nothing happens is all that comes before.
        ends = [float(end) for interval in free for end in interval]
        assert ends[1:-1:2] == ends[2::2] and ends[:1] in ([], [0.0])
        if expected is None:
            assert found is None and ends[-1] == 1.0
            none += 1
        else:
            assert max(ends, default=0.0) < expected[0]
            assert found is not None and found[0] == expected[1]
            assert found[1].ends()[0] <= expected[0] <= found[1].ends()[1] and found[1].r < 1 << 60
    assert 5 < none < 75


def test_solutions_part_by_no_more_than_the_checker_says() -> None:
    # The exponential series by fractions, as far as its terms matter; where it is not bounded,
    # nothing is said.
    rng = random.Random(4)
    for _ in range(60):
        a, b, time = (10 ** rng.uniform(-4, 2) for _ in range(3))
        theta, rate = rng.uniform(0, 9), rng.uniform(0, 9)
        fastest = max(1.0, (b + math.sqrt(b * b + 4 * a)) / 2)
        alpha = checker.Disc(0.0, 0.0, a, b)
        if fastest * time > 40.001:
            with pytest.raises(checker.Inconclusive, match="part too fast"):
                checker.Apart(theta, rate).after(time, alpha)
            continue
        if fastest * time > 39.999:
            continue
        term = all_of_it = (Fraction(theta), Fraction(rate))
        for k in range(1, 400):
            scale = Fraction(time) / k
            term = (term[1] * scale, (Fraction(a) * term[0] + Fraction(b) * term[1]) * scale)
            term = (term[0].limit_denominator(10**80), term[1].limit_denominator(10**80))
            all_of_it = (all_of_it[0] + term[0], all_of_it[1] + term[1])
        found = checker.Apart(theta, rate).after(time, alpha)
        assert found.theta >= all_of_it[0] and found.rate >= all_of_it[1]
        assert (
            found.theta <= float(all_of_it[0]) * 1.01 + 1e-9
            and found.rate <= float(all_of_it[1]) * 1.01 + 1e-9
        )


def test_the_precision_is_that_of_one_check_alone(thrown: dict[str, Any]) -> None:
    before = Range.bits
    cases = [thrown, json.loads((TRUTH / "certificates" / "landing-18.json").read_text())]
    with ThreadPoolExecutor(4) as pool:
        jobs = [pool.submit(check, cases[k % 2], (192 + 64 * k, 1024)) for k in range(8)]
        assert [job.result()["events"] for job in jobs] == [
            len(cases[k % 2]["events"]) for k in range(8)
        ]
    assert Range.bits == before


@pytest.mark.usefixtures("bits")
def test_the_radius_of_a_number_is_that_of_the_rule() -> None:
    # Of 31 digits, so that the distance is a whole number of tenths of a unit, and of numbers
    # between.
    for tail, radius in (
        ("0", "1"),
        ("1", "11"),
        ("4", "41"),
        ("6", "41"),
        ("9", "11"),
        ("12345", "13"),
    ):
        number = Fraction(int("1" * 30 + tail), 10 ** (len(tail) + 29))
        assert checker.text_of(
            Range.of(number) if tail == "12345" else Range.of(number).widened(Range(1))
        )[1] == (f"{radius}e-31")


@pytest.mark.usefixtures("bits")
def test_ends_on_both_sides_of_the_digits_do_not_tell_the_radius() -> None:
    """Both ends are 0.19 units from the digits, and what is enclosed may be those digits."""
    from littlewood.certify import balls

    number, spread = Fraction(int("1" * 30), 10**29), Fraction(19, 10**31)
    wide = Range.of(number).widened(Range.of(spread))
    with pytest.raises(checker.Inconclusive, match="the digits of a number are not decided"):
        checker.text_of(wide)
    with balls.precision(256):
        ball = balls.ball(number) + balls.arb(0, 1) * balls.ball(spread)
        with pytest.raises(balls.Undecided, match="the digits of a number are not decided"):
            balls.text(ball)


def test_the_discs_of_the_checker_enclose() -> None:
    rng = random.Random(6)

    def function(s: Any, c: Any, omega: Any) -> Any:
        return (s * omega * omega - 3) * c / (c * 2 + omega + 7)

    for _ in range(200):
        theta, rate = rng.uniform(-9, 9), rng.uniform(-2, 2)
        wide, fast = rng.uniform(0, 0.5), rng.uniform(0, 0.5)
        bounds = function(
            *checker.angle_and_rate(checker.Disc(theta, wide), checker.Disc(rate, fast))
        )
        for _ in range(20):
            z = theta + cmath.rect(wide * rng.random(), rng.uniform(0, 7))
            w = rate + cmath.rect(fast * rng.random(), rng.uniform(0, 7))
            value = function(cmath.sin(z), cmath.cos(z), w)
            assert abs(value - bounds.c) <= bounds.r
            d = 1e-6
            by_theta = (function(cmath.sin(z + d), cmath.cos(z + d), w) - value) / d
            by_rate = (function(cmath.sin(z), cmath.cos(z), w + d) - value) / d
            assert abs(by_theta) <= bounds.by_theta + 1e-4
            assert abs(by_rate) <= bounds.by_rate + 1e-4
    with pytest.raises(checker.Wide):
        checker.Disc(1.0) / checker.Disc(0.5, 0.5)


@pytest.fixture(scope="module")
def schema() -> Any:
    jsonschema = pytest.importorskip("jsonschema")
    found = json.loads((TRUTH / "certificate.schema.json").read_text())
    jsonschema.Draft202012Validator.check_schema(found)
    return jsonschema.Draft202012Validator(found)


def test_certificates_follow_their_schema(schema: Any) -> None:
    families = set()
    for path in sorted((TRUTH / "certificates").glob("*.json")):
        certificate = json.loads(path.read_text())
        checker.intact(certificate)
        family = certificate["case"]["family"]
        if family not in families:
            schema.validate(certificate)
        families.add(family)
    text = (TRUTH / "families.md").read_text()
    assert all(family in text for family in families)


def test_the_checker_reads_what_the_schema_allows(schema: Any) -> None:
    rng = random.Random(1)
    names = ("paper-02", "si-01", "landing-18", "settles-sticking-02", "long-rolling-08")
    names += ("rests-sliding-01", "rests-landing-12")
    documents = [
        json.loads((TRUTH / "certificates" / f"{name}.json").read_text()) for name in names
    ]
    documents.append({key: documents[0][key] for key in ("format", "version", "case", "digest")})
    documents[-1] |= {"certified": False, "reason": "another"}
    counts = [0, 0]
    for _ in range(500):
        document = with_another_shape(rng.choice(documents), rng)
        allowed = schema.is_valid(document)
        counts[allowed] += 1
        try:
            checker.valid(document)
        except Refused as refused:
            assert not allowed, refused
        else:
            assert allowed, next(schema.iter_errors(document)).message
    assert min(counts) > 20


VALUES = (
    None, True, False, 0, 1, -1, 2, 0.5, -0.5, 1.0, 2.0, 1e308, "", "rolling", "1/4", "0.5",
    "si", "dimensionless", "energetic", [], {}, ["0", "0"], ["0"], ["0", "0", "0"], ["x", "0"],
    {"a": ["0", "1e-40"]}, {"restitution": 1},
)  # fmt: skip
KEYS = (
    "reason",
    "proof",
    "restitution",
    "restitution_law",
    "impact",
    "before",
    "period",
    "state",
    "radius_m",
    "initial",
)


def with_another_shape(document: Any, rng: random.Random) -> Any:
    """A document with one or two values replaced, deleted or added, most of them not deep in it."""

    def places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
        for key, one in (
            value.items()
            if isinstance(value, dict)
            else enumerate(value)
            if isinstance(value, list)
            else ()
        ):
            yield (*path, key)
            yield from places(one, (*path, key))

    document = copy.deepcopy(document)
    for _ in range(rng.choice([1, 1, 2])):
        every = list(places(document))
        place = rng.choice([one for one in every if len(one) < 4 or rng.random() < 0.01])
        parent, value = document, copy.deepcopy(rng.choice(VALUES))
        for key in place[:-1]:
            parent = parent[key]
        change = rng.choice(["replace", "replace", "delete", "add", "add"])
        if change == "replace":
            parent[place[-1]] = value
        elif change == "delete":
            del parent[place[-1]]
        elif isinstance(parent, dict):
            parent[rng.choice(KEYS)] = value
        else:
            parent.insert(place[-1], value)
    return document


SI = ("kg", "m", "m2", "s2")
"""Ends of the names of columns that have their unit in their name."""


def test_the_archive_has_the_same_bytes_and_its_package_describes_it() -> None:
    archive = script("archive")
    files = archive.contents()
    one = archive.archive(files)
    assert one == archive.archive(dict(reversed(files.items())))
    with tarfile.open(fileobj=io.BytesIO(one)) as tar:
        assert {entry.mtime for entry in tar} == {0}
        assert len(tar.getnames()) == len(files)
    sums = dict(reversed(line.split("  ")) for line in files["SHA256SUMS"].decode().splitlines())
    assert sums.keys() | {"SHA256SUMS"} == files.keys()
    assert all(hashlib.sha256(files[name]).hexdigest() == found for name, found in sums.items())
    described = json.loads(files["datapackage.json"])
    for resource in described["resources"]:
        data = files[resource["path"]]
        assert resource["hash"] == f"sha256:{hashlib.sha256(data).hexdigest()}"
        header = data.split(b"\n", 1)[0].decode().split(",")
        fields = resource["schema"]["fields"]
        assert header == [field["name"] for field in fields]
        assert all(field["description"] for field in fields)
        numbers = [
            field
            for field in fields
            if field["type"] == "number" and field["name"].split("_")[-1] not in SI
        ]
        assert all(field["unit"] and field["unit_si"] for field in numbers)
        rows = list(csv.DictReader(io.StringIO(data.decode())))
        keys = [tuple(row[key] for key in resource["schema"]["primaryKey"]) for row in rows]
        assert len(set(keys)) == len(rows) > 0
        assert {row["motion"] for row in rows} <= set(CASES)
    assert described["contributors"] and described["description"]
    assert {
        "README.md",
        "LICENSE",
        "CITATION.cff",
        "families.md",
        "checker.py",
        "cases.json",
        "derivatives.json",
    } <= set(files)
    for row in csv.DictReader(io.StringIO(files["tables/motions.csv"].decode())):
        given = CASES[row["motion"]].given
        assert all(
            # In one column, whose unit the column of units tells.
            float(row["rolling_resistance" if key == "rolling_resistance_m" else key]) == value
            for key, value in given["hoop"].items()
            if key != "restitution_law"
        )
        assert all(float(row[f"start_{key}"]) == value for key, value in given["start"].items())
        assert row["until"] == ("" if given["until"] is None else str(given["until"]))
    rows = list(csv.DictReader(io.StringIO(files["tables/events.csv"].decode())))
    slip = next(row for row in rows if row["motion"] == "paper-01" and row["cause"] == "slip")
    assert slip["time"].startswith("0.97322307477240541")
    # An impulse changes the gap rate; the certificate has both.
    landing = next(row for row in rows if row["motion"] == "landing-16" and row["impact"])
    assert float(landing["normal_impulse"]) > 0.0 and float(landing["gap_rate_before"]) < 0.0
