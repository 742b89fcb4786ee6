"""Names, codes, labels, units and colours stand in the core.

What the package says by itself agrees with them.
"""

import dataclasses
import inspect
import re
from pathlib import Path

import numpy as np
import pytest

import littlewood as lw
from littlewood import _core, style, tables
from littlewood._internal import variables
from littlewood.plot.canvas import axis_label
from littlewood.sweep import Quantities

PACKAGE = Path(lw.__file__).parent
LIMITS = ["until", "max_transitions", "max_slides", "proof"]
STATE = [*lw.case("figure-3").simulate()._core.outcome()["state"]]
SI_STATE = [tables.SAMPLE_COLUMNS[name].si_name for name in STATE]


def arguments(function):
    return {
        name: one
        for name, one in inspect.signature(function).parameters.items()
        if name not in ("self", "cls")
    }


@pytest.mark.parametrize(
    ("function", "names"),
    [
        (lw.Hoop, [*tables.HOOP, "restitution_law", "units"]),
        (lw.Hoop.from_si, [*tables.SI_HOOP, "restitution_law"]),
        (lw.Hoop.simulate, [*tables.START, *LIMITS]),
        (
            lw.Hoop.simulate_si,
            [*SI_STATE, "gap_rate_m_per_s", "until_s", "max_transitions", "max_slides", "proof"],
        ),
        (lw.motion.State, STATE),
    ],
)
def test_arguments_are_those_of_the_table(function, names):
    assert sorted(arguments(function)) == sorted(names)


def test_a_sweep_takes_the_axes_of_the_table():
    assert sorted(Quantities.__annotations__) == sorted((*tables.AXES, tables.FRICTION))
    for function in (lw.simulate_many, lw.outcome_map):
        assert list(arguments(function))[-1] == "quantities"
        for name in (*tables.AXES, tables.FRICTION):
            assert re.search(rf"^    .*\b{name}\b.* : ", function.__doc__, re.MULTILINE), name


@pytest.mark.parametrize(
    "function", [lw.Hoop, lw.Hoop.from_si, lw.Hoop.simulate, lw.Hoop.simulate_si]
)
def test_defaults_are_those_of_the_table(function):
    # What a start in SI units calls `theta_rad` has the name `theta` in the table.
    other = [
        "restitution_law",
        "units",
        "until",
        "until_s",
        "max_transitions",
        "max_slides",
        "proof",
    ]
    ours = {"theta_rad": "theta", **dict.fromkeys(other)}
    for name, one in arguments(function).items():
        row = ours.get(name, name)
        if row is not None:
            default = None if one.default is inspect.Parameter.empty else one.default
            assert default == tables.QUANTITIES[row].default, name
            # What may be left out without a default is absent: None.
            assert (one.default is None) == tables.QUANTITIES[row].is_optional, name


def test_a_start_is_a_state_and_the_rate_of_the_gap():
    names = [field.name for field in dataclasses.fields(lw.Start)]
    assert sorted(tables.START) == sorted(names)
    assert [name for name in names if name not in STATE] == ["gap_rate"]
    assert all(isinstance(case.start, lw.Start) for case in lw.CASES.values())


@pytest.mark.parametrize(
    ("names", "rows"),
    [
        (lw.tables.MODES, _core.MODES),
        (lw.tables.CAUSES, _core.CAUSES),
        (lw.tables.CLASSES, _core.CLASSES),
        (lw.tables.REGIONS, _core.REGIONS),
        (lw.tables.IMPACT_CASES, _core.IMPACT_CASES),
        (lw.tables.RESTITUTION_LAWS, _core.RESTITUTION_LAWS),
    ],
)
def test_codes_are_places(names, rows):
    assert [(row["code"], row["name"]) for row in rows] == list(enumerate(names))
    assert len(set(names)) == len(names)


def test_codes_of_types_of_rolling_are_places():
    rows = [(row["code"], row["name"]) for row in _core.ROLLING_TYPES]
    assert [(0, ""), *rows] == list(enumerate(lw.closed_form.ROLLING_TYPES))


def test_outcomes_have_their_codes_in_attributes():
    attributes = variables.result_attributes("outcome")
    assert attributes["flag_values"].tolist() == list(lw.tables.OUTCOMES)
    assert attributes["flag_values"].dtype == lw.tables.SUMMARY_COLUMNS["outcome"].dtype
    assert attributes["flag_meanings"].split() == list(lw.tables.OUTCOMES.values())
    assert set(lw.tables.OUTCOMES.values()) == set(tables.OUTCOME_LABELS)


def test_the_documentation_lists_the_columns(hoop):
    samples = hoop.simulate(theta=1.0, theta_rate=0.0)([0.0])
    assert list(samples) == list(tables.SAMPLE_COLUMNS)
    listed = re.findall(r"^    ([a-z_, ]+) : ndarray", lw.Samples.__doc__, re.MULTILINE)
    assert sorted(", ".join(listed).split(", ")) == sorted(samples)
    returned = lw.simulate_many.__doc__.split("Returns")[1].split("Raises")[0]
    assert set(re.findall(r"`(\w+)`", returned)) >= set(tables.SUMMARY_COLUMNS)


def test_the_documentation_knows_the_numbers():
    for text in (lw.sequence_names.__doc__, lw.Trajectory.sequence.__doc__):
        assert f"more than {_core.SEQUENCE_CAPACITY}" in text
        for letter in (row["name"] for row in _core.PHASES):
            assert re.search(rf"(^|[\s(]){re.escape(letter)}[\s,;]", text), letter


def test_details_that_are_documented(hoop):
    documented = lw.motion.Outcome.__doc__
    seen = set()
    for case in lw.CASES.values():
        seen |= set(case.simulate(until=50.0).outcome.details)
    seen |= set(hoop.simulate(theta=1.5, theta_rate=2.0, max_transitions=1).outcome.details)
    level = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.5)
    smooth = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.2, mu_k=0.0)
    for endless, rate in ((level, 2.36), (smooth, 1.2)):
        seen |= set(endless.simulate(theta=3.0, theta_rate=rate).outcome.details)
    assert len(seen) > 10
    for name in seen:
        assert f"`{name}`" in documented, name


def test_results_have_the_types_of_the_table(hoop):
    result = lw.simulate_many(hoop, theta=[0.0, 1.0], theta_rate=1.0)
    assert list(result.data_vars) == list(tables.SUMMARY_COLUMNS)
    for name, column in tables.SUMMARY_COLUMNS.items():
        assert result[name].dtype == np.dtype(column.dtype), name


def test_units_are_those_of_the_conventions(hoop):
    result = lw.simulate_many(hoop, theta=[0.0, 1.0], theta_rate=1.0)
    motion = hoop.simulate(theta=1.0, theta_rate=0.0).to_xarray()
    for dataset in (result, motion):
        assert dataset.attrs["Conventions"] == "CF-1.11"
        for name, variable in dataset.variables.items():
            assert variable.attrs.get("units", "1") in ("1", "rad"), name
    # The scale tells what a number is a multiple of.
    assert result.end_time.attrs["scale"] == "sqrt(R/g)"
    assert result.theta_rate.attrs["scale"] == "sqrt(g/R)"
    assert motion.normal.attrs["scale"] == "m2 g"


def test_every_mode_class_and_curve_has_a_look():
    assert list(style.MODE_COLOURS) == list(style.MODE_DASHES) == list(lw.tables.MODES)
    assert list(style.CLASS_COLOURS) == list(lw.tables.CLASSES)
    assert list(style.CURVE_COLOURS) == list(style.CURVE_DASHES) == list(style.CURVE_WIDTHS)
    light, dark = (
        {(row["group"], row["name"]) for row in _core.swatches(paper)} for paper in (False, True)
    )
    assert light == dark
    for colour in (row["colour"] for row in _core.swatches(False)):
        assert re.fullmatch("#[0-9a-f]{6}", colour)


def test_labels_of_axes_are_those_of_the_table():
    assert axis_label("inertia") == "Izz/(m₂R²)"
    assert axis_label("theta_rate") == "θ′  (√(g/R))"
    assert axis_label("centre_y") == "y  (R)"
    assert axis_label("mass") == "mass"


def test_no_source_repeats_a_table():
    """Colours, labels and codes of the core are not typed again anywhere in the package."""
    labels = {
        *tables.CAUSE_LABELS.values(),
        *tables.OUTCOME_LABELS.values(),
        *tables.CLASS_LABELS.values(),
    }
    labels |= {*tables.IMPACT_LABELS.values(), *tables.LAW_LABELS.values()}
    # One word is a name or plain English; words with a blank between them are not met by chance.
    labels = {label for label in labels if " " in label}
    assert len(labels) > 10
    sources = [path for path in PACKAGE.rglob("*.py") if "__pycache__" not in path.parts]
    assert len(sources) > 20
    for path in sources:
        text = path.read_text(encoding="utf-8")
        assert not re.search(r"[\"']#[0-9a-fA-F]{3,8}[\"']", text), path
        for label in labels:
            assert f'"{label}"' not in text, (path, label)
        assert not re.search(r"\bI/\(m", text), path
