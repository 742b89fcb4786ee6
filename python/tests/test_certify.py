import ast
import cmath
import copy
import csv
import hashlib
import importlib.util
import io
import json
import math
import random
import subprocess
import sys
import tarfile
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from littlewood.certify import Case, CaseError, Refused, certify, check, dump
from littlewood.certify.__main__ import main
from littlewood.certify.certificate import digest
from littlewood.certify.checker import discs, series
from littlewood.certify.checker.ranges import Range, pi, sine_and_cosine
from littlewood.certify.compare import differences

ROOT = Path(__file__).resolve().parents[2]
TRUTH = ROOT / "truth"
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
    found = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    return [place for key, one in found if key != "proof" for place in numbers(one, (*path, key))]


def with_another_digit(certificate: dict[str, Any], place: tuple[Any, ...], part: int) -> dict[str, Any]:
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


@pytest.mark.parametrize("name", ["figure_3", "slide_sticks", "turning_point_in_slide", "equal_friction", "band"])
def test_certificates_contain_the_references_of_40_digits(name: str) -> None:
    data = json.loads((ROOT / "reference" / "motions.json").read_text())
    motion = next(one for one in data["motions"] if one["name"] == name)
    hoop = tuple(float(motion["hoop"][key]) for key in ("mass_ratio", "offset", "inertia", "mu_s", "mu_k"))
    start = tuple(float(motion["start"][key]) for key in ("theta", "theta_rate", "slip"))
    certificate = certify(Case(hoop, (*start, 0.0), float(motion["until"])))
    assert certificate["certified"]
    events = certificate["events"]
    assert [one["cause"] for one in events] == [one["cause"] for one in motion["transitions"]]
    for event, transition in zip(events, motion["transitions"], strict=True):
        assert (event["to"], event["direction"]) == (transition["to"], transition["direction"] or 0)
        for key in NAMES:
            middle, radius = map(Fraction, event["state"][key])
            reference = Fraction(transition[key])
            # The reference is rounded to 25 digits.
            assert abs(middle - reference) <= radius + abs(reference) * Fraction(6, 10**25), (event["cause"], key)


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
    for place in (("events", 0, "state", "time"), ("initial", "evidence", "contact"), ("phases", 0, "samples", 0, "x")):
        for part in (0, 1):
            with pytest.raises(Refused):
                check(with_another_digit(figure_3, place, part))


@pytest.fixture(scope="module")
def mutate() -> Any:
    return script("mutate")


def test_the_checker_refuses_a_changed_digit_or_name_in_each_family(mutate: Any) -> None:
    families = {one["family"] for one in json.loads((TRUTH / "cases.json").read_text())}
    assert {name.rsplit("-", 1)[0] for name in mutate.QUICK} == families
    kinds = set()
    for name in mutate.QUICK:
        certificate = mutate.read(name)
        found = list(mutate.mutations(certificate))
        # Of families that are checked within a tenth of a second every kind of number and of name, of others twelve.
        quick = name.startswith(("elastic", "jam", "landing", "leaves-at-once", "lift-off", "si", "thrown"))
        for kind, changed in found if quick else random.Random(name).sample(found, 12):
            assert changed != certificate
            assert not mutate.accepted(changed), (name, kind)
            kinds.add(kind)
    assert len(kinds) > 100


def test_the_checker_takes_nothing_from_the_maker() -> None:
    import littlewood.certify.checker as checker

    files = list(Path(checker.__path__[0]).glob("*.py"))
    assert len(files) > 10
    for file in files:
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.level:
                assert node.level == 1, file.name
            elif isinstance(node, ast.Import | ast.ImportFrom):
                names = [one.name for one in node.names] if isinstance(node, ast.Import) else [node.module or ""]
                assert {one.split(".")[0] for one in names} <= sys.stdlib_module_names, file.name


def test_a_change_of_anything_else_breaks_the_digest(thrown: dict[str, Any]) -> None:
    for key in ("version", "case", "phases", "end"):
        changed = copy.deepcopy(thrown)
        changed[key] = "another"
        with pytest.raises(Refused, match="digest"):
            check(changed)


def test_the_checker_refuses_another_mode_and_a_missing_event(figure_3: dict[str, Any]) -> None:
    changed = copy.deepcopy(figure_3)
    changed["initial"]["direction"] = 1
    with pytest.raises(Refused, match="direction of the start"):
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
    cases = {one["name"]: one for one in json.loads((TRUTH / "cases.json").read_text())}
    for name in RECERTIFIED:
        committed = (TRUTH / "certificates" / f"{name}.json").read_text()
        assert dump(certify(Case.read(cases[name]))) == committed, name


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
)


def test_every_case_of_the_list_has_its_certificate() -> None:
    cases = json.loads((TRUTH / "cases.json").read_text())
    files = {path.stem for path in (TRUTH / "certificates").glob("*.json")}
    assert files == {one["name"] for one in cases}
    assert len(files) >= 300
    for one in cases:
        certificate = json.loads((TRUTH / "certificates" / f"{one['name']}.json").read_text())
        assert certificate["case"] == Case.read(one).written()
        assert certificate["digest"] == digest(certificate)
        assert certificate["certified"] or certificate["reason"]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (dict(hoop=(-1.0, 1.0, 1.0, 0.5, 0.4)), "mass_ratio = -1.0 must not be negative"),
        (dict(hoop=(1.0, 1.5, 1.0, 0.5, 0.4)), "at most 1 R"),
        (dict(hoop=(1.0, 1.0, 1.0, 0.3, 0.4)), "must not be below mu_k = 0.4"),
        (dict(start=(math.nan, 1.0, 0.0, 0.0)), "theta = nan must be finite"),
        (dict(until=0.0), "until = 0.0"),
        (dict(restitution=1.5), "from 0 to 1"),
        (dict(law="elastic"), "must be one of energetic"),
    ],
)
def test_bad_cases_are_refused_with_the_bound(change: dict[str, Any], message: str) -> None:
    with pytest.raises(CaseError, match=message):
        Case(**(dict(hoop=THIN, start=(0.0, 1.0, 0.0, 0.0)) | change))


def test_what_is_not_certified_says_why() -> None:
    certificate = certify(Case((0.0, 1.0, 0.0, 0.3, 0.2), (3.0, 0.5, 0.5, 0.0), 1.0), most_bits=200)
    if not certificate["certified"]:
        assert certificate["reason"]
        with pytest.raises(Refused, match="nothing is certified"):
            check(certificate)


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "certificate.json"
    hoop = ["--mass-ratio=1", "--offset=1", "--inertia=1", "--mu-s=0.5", "--mu-k=0.4"]
    assert main([*hoop, "--theta=0.4", "--theta-rate=-1", "--slip=0.25", "--gap-rate=0.1", "--out", str(file)]) == 0
    assert json.loads(file.read_text())["events"][0]["cause"] == "landing"
    assert main(["--check", str(file)]) == 0
    assert "numbers" in capsys.readouterr().out
    file.write_text(file.read_text().replace("0.4", "0.5", 1))
    assert main(["--check", str(file)]) == 1
    assert "refused" in capsys.readouterr().err
    assert main(hoop[:2]) == 2
    assert "a hoop needs --inertia" in capsys.readouterr().err
    assert main(["--check", str(tmp_path / "none.json")]) == 2


def test_without_the_extra_the_message_names_it() -> None:
    code = (
        "import sys; sys.modules['flint'] = None\n"
        "from littlewood.certify.__main__ import main\n"
        "sys.exit(main(['--mass-ratio=1','--offset=1','--inertia=1','--mu-s=0.5','--mu-k=0.4']))"
    )
    done = subprocess.run([sys.executable, "-P", "-c", code], capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert 'pip install "littlewood[certify]"' in done.stderr


def test_the_arithmetic_of_the_checker_encloses() -> None:
    Range.bits = 200
    digits = "3.14159265358979323846264338327950288419716939937510582097494459"
    low, high = pi().ends()
    assert low < Fraction(digits) + Fraction(1, 10**60) and high > Fraction(digits) - Fraction(1, 10**60)
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


def test_the_series_of_the_checker_solve_their_equation() -> None:
    # x′ = y/z, y′ = x z and z′ = −z, from x = 0 and y = z = 1: the residual, by exact fractions.
    Range.bits = 256
    one, length = Range.of(1), Range.of(Fraction(1, 4))
    x, y, z = series.Integral(Range(0), length), series.Integral(one, length), series.Integral(one, length)
    x.of, y.of, z.of = y / z, x * z, -z
    count = 20
    middle = {name: [Fraction(of[k].m, 1 << 256) for k in range(count)] for name, of in (("x", x), ("y", y), ("z", z))}

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
    tenth = series.at((z[k] for k in range(count - 1, -1, -1)), Range.of(Fraction(2, 5)))
    assert float(tenth) == pytest.approx(math.exp(-0.1), abs=1e-15)


def test_the_discs_of_the_checker_enclose() -> None:
    rng = random.Random(6)

    def function(s: Any, c: Any, omega: Any) -> Any:
        return (s * omega * omega - 3) * c / (c * 2 + omega + 7)

    for _ in range(200):
        theta, rate = rng.uniform(-9, 9), rng.uniform(-2, 2)
        wide, fast = rng.uniform(0, 0.5), rng.uniform(0, 0.5)
        bounds = function(*discs.angle_and_rate(discs.Disc(theta, wide), discs.Disc(rate, fast)))
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
    with pytest.raises(discs.Wide):
        discs.Disc(1.0) / discs.Disc(0.5, 0.5)


def test_certificates_follow_their_schema() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = json.loads((TRUTH / "certificate.schema.json").read_text())
    validator = jsonschema.Draft202012Validator(schema)
    validator.check_schema(schema)
    families = set()
    for path in sorted((TRUTH / "certificates").glob("*.json")):
        certificate = json.loads(path.read_text())
        family = certificate["case"]["family"]
        if family in families and certificate["certified"]:
            continue
        families.add(family)
        validator.validate(certificate)
        with pytest.raises(jsonschema.ValidationError):
            validator.validate(certificate | {"version": 2})
    text = (TRUTH / "families.md").read_text()
    assert all(family in text for family in families)


def test_the_archive_has_the_same_bytes_and_its_package_describes_it() -> None:
    archive = script("archive")
    files = archive.contents()
    one = archive.archive(files)
    assert one == archive.archive(dict(reversed(files.items())))
    with tarfile.open(fileobj=io.BytesIO(one)) as tar:
        assert {entry.mtime for entry in tar} == {0}
        assert len(tar.getnames()) == len(files)
    described = json.loads(files["datapackage.json"])
    for resource in described["resources"]:
        data = files[resource["path"]]
        assert resource["hash"] == f"sha256:{hashlib.sha256(data).hexdigest()}"
        header = data.split(b"\n", 1)[0].decode().split(",")
        assert header == [field["name"] for field in resource["schema"]["fields"]]
    rows = list(csv.DictReader(io.StringIO(files["tables/events.csv"].decode())))
    slip = next(row for row in rows if row["motion"] == "paper-01" and row["cause"] == "slip")
    assert slip["time"].startswith("0.97322307477240541")
