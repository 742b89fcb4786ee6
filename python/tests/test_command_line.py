"""The package and the command line show the results of one core: they agree bit for bit."""

import math
import os
import re
import subprocess
import sys

import numpy as np
import pytest
import xarray
from conftest import flags

import littlewood as lw
from littlewood.__main__ import OF_THE_PACKAGE


def random_problems(count):
    random = np.random.default_rng(2019)
    for i in range(count):
        massless = i % 5 == 4
        mu_k = random.uniform(0.05, 0.8)
        hoop = {
            "mass_ratio": 0.0 if massless else random.uniform(0.0, 3.0),
            "offset": random.choice([1.0, random.uniform(0.1, 1.0)]),
            "inertia": 0.0 if massless else random.uniform(0.1, 3.0),
            "mu_s": mu_k + random.uniform(0.0, 0.4),
            "mu_k": mu_k,
        }
        start = {
            "theta": random.uniform(-math.pi, math.pi),
            "theta_rate": random.uniform(-3.0, 3.0),
            "slip": random.choice([0.0, random.uniform(-2.0, 2.0)]),
        }
        yield {k: float(v) for k, v in hoop.items()}, {k: float(v) for k, v in start.items()}


@pytest.mark.parametrize("name", lw.CASES)
def test_both_print_the_same_page(command, name):
    # The command line says which flag allows more.
    page = command("simulate", name).stdout.replace("         --max-transitions allows more\n", "")
    assert page.startswith(name)
    assert page[page.index("Hoop  ") :].rstrip() == str(lw.case(name).simulate())


def with_impacts(count):
    """Hoops that are not massless, with a coefficient of restitution and a law.

    Some are thrown from the plane.
    """
    random = np.random.default_rng(1986)
    problems = (
        (hoop, start)
        for hoop, start in random_problems(2 * count)
        if hoop["mass_ratio"] + hoop["inertia"] > 0
    )
    for i, (hoop, start) in zip(range(count), problems, strict=False):
        e = float(random.choice([0.0, 1.0, random.uniform(0.05, 0.9)]))
        thrown = {"gap_rate": float(random.uniform(0.1, 1.5))} if i % 3 == 0 else {}
        yield (
            {**hoop, "restitution": e, "restitution_law": lw.tables.RESTITUTION_LAWS[i % 3]},
            {**start, **thrown},
        )


def same(ours, said):
    # JSON has no infinity: the rate of a particle that has reached the plane is null.
    return (not math.isfinite(ours)) if said is None else ours == said


def compare(motion, said):
    assert motion.outcome.kind == said["outcome"]["kind"]
    for key, value in motion.outcome.details.items():
        if isinstance(value, float):
            assert same(value, said["outcome"][key]), key
    assert len(motion.transitions) == len(said["transitions"])
    for ours, theirs in zip(motion.transitions, said["transitions"], strict=True):
        assert (ours.from_mode, ours.to_mode, ours.direction, ours.cause) == tuple(
            theirs[key] for key in ("from", "to", "direction", "cause")
        )
        for key in vars(ours.after):
            assert same(getattr(ours.after, key), theirs[key]), key
        compare_impacts(ours.impact, theirs.get("impact"))
    for ours, theirs in zip(motion.phases, said["phases"], strict=True):
        assert (ours.mode, ours.direction) == (theirs["mode"], theirs["direction"])
        assert same(ours.duration, theirs["duration"])
        assert same(ours.energy_start, theirs["energy_start"])
        assert same(ours.energy_lost, theirs["energy_lost"])
        assert ours.is_small_inertia_limit == theirs["small_inertia_limit"]
    if said["samples"]:
        samples = motion.sample(7, said["sampled_until"])
        for i, row in enumerate(said["samples"]):
            # Just before a jam there is none.
            assert samples.mode_names[i] == (row["mode"] or "")
            for key, value in row.items():
                if key != "mode":
                    assert same(float(samples[key][i]), value), key


def compare_impacts(ours, theirs):
    assert (ours is None) == (theirs is None)
    if ours is not None:
        assert ours.case == theirs["case"]
        assert ours.impulse == (theirs["normal_impulse"], theirs["friction_impulse"])
        assert ours.energy_lost == theirs["energy_lost"]
        assert ours.before._asdict() == theirs["before"]
        assert ours.after.gap_rate == theirs["gap_rate"]


def test_a_hundred_random_starts(command_json):
    sequences = set()
    for hoop, start in random_problems(100):
        said = command_json("simulate", *flags(**hoop, **start, until=40.0), "--samples", "7")
        motion = lw.Hoop(**hoop).simulate(**start, until=40.0)
        sequences.add(motion.sequence[:2])
        compare(motion, said)
    # The starts are of many kinds.
    assert len(sequences) >= 8, sequences


def test_random_motions_with_impacts(command_json):
    seen = set()
    for hoop, start in with_impacts(60):
        said = command_json("simulate", *flags(**hoop, **start, until=20.0), "--samples", "7")
        motion = lw.Hoop(**hoop).simulate(**start, until=20.0)
        compare(motion, said)
        assert said["hoop"]["restitution_law"] == motion.hoop.restitution_law
        assert motion.energy_lost == said["energy_lost"]
        seen |= {(one.cause, one.to_mode) for one in motion.transitions if one.impact is not None}
    # Landings with and without a rebound, and the ends of bounces.
    assert seen >= {
        ("landing", "flight"),
        ("landing", "rolling"),
        ("landing", "sliding"),
        ("settle", "rolling"),
    }


@pytest.mark.parametrize(
    "name", [name for name, case in lw.CASES.items() if case.hoop.restitution is not None]
)
def test_cases_with_impacts(name, command_json):
    said = command_json("simulate", name, "--until", "50", "--samples", "7")
    motion = lw.case(name).simulate(until=50.0)
    compare(motion, said)
    assert any(one.impact is not None for one in motion.transitions)
    for name in ("restitution", "restitution_law"):
        assert said["hoop"][name] == getattr(motion.hoop, name)


@pytest.mark.parametrize(
    ("axes", "fixed"),
    [
        ({"theta": (-3.0, 3.0, 23), "theta_rate": (-4.0, 4.0, 31)}, {}),
        ({"mu_k": (0.1, 0.5, 5), "theta_rate": (0.5, 3.0, 26)}, {"theta": 0.3}),
        ({"mu_k": (0.1, 0.9, 9), "mu_s": (0.2, 1.0, 5)}, {"theta": 2.5, "theta_rate": 3.0}),
        ({"restitution": (0.0, 1.0, 11), "theta_rate": (1.0, 4.0, 7)}, {"theta": 1.5}),
        (
            {"theta": (-3.0, 3.0, 13), "gap_rate": (0.0, 2.0, 9)},
            {"theta_rate": 1.5, "restitution": 0.5, "restitution_law": "newton"},
        ),
    ],
)
def test_a_map_is_the_store_of_the_command_line(axes, fixed, command, hoop, tmp_path):
    path = tmp_path / "map.zarr"
    (x, y) = axes.items()
    spans = [f"{name}={low!r}:{high!r}:{count}" for name, (low, high, count) in (x, y)]
    done = command(
        "map",
        "figure-3",
        "--x",
        spans[0],
        "--y",
        spans[1],
        *flags(**fixed, until=50.0),
        "--out",
        str(path),
    )
    assert done.returncode == 0, done.stderr
    said = xarray.open_zarr(path, consolidated=False, mask_and_scale=False).load()
    values = {name: said[name].to_numpy() for name in axes}
    ours = lw.outcome_map(hoop, **values, **fixed, until=50.0)
    assert ours.outcome.dims == said.outcome.dims
    assert set(ours.data_vars) == set(said.data_vars)
    for name, variable in said.data_vars.items():
        assert ours[name].dtype == variable.dtype
        assert ours[name].to_numpy().tobytes() == variable.to_numpy().tobytes(), name
        attributes = {key: value for key, value in variable.attrs.items() if key != "_FillValue"}
        # JSON has no types of numbers; what is computed here has those of CF.
        described = {
            key: value.tolist() if isinstance(value, np.ndarray) else value
            for key, value in ours[name].attrs.items()
        }
        assert described == attributes
    for name in axes:
        assert ours[name].attrs == said[name].attrs
    assert ours.attrs["Conventions"] == said.attrs["Conventions"]
    names = np.vectorize(lw.tables.OUTCOMES.__getitem__)(ours.outcome)
    assert np.any(names == "invalid") == ("mu_s" in axes)
    # Where both agree bit for bit, so do the classes that maps show.
    np.testing.assert_array_equal(lw.plot.classes(ours), lw.plot.classes(said))


def test_an_axis_that_contradicts_a_fixed_value_is_refused_by_both(command, hoop):
    done = command(
        "map",
        "figure-3",
        "--x",
        "mu_k=0.1:0.9:9",
        "--y",
        "theta_rate=0:1:5",
        "--out",
        "unused.zarr",
    )
    assert done.returncode == 2
    with pytest.raises(lw.ParameterError) as caught:
        lw.outcome_map(
            hoop, theta=0.0, mu_k=np.linspace(0.1, 0.9, 9), theta_rate=np.linspace(0, 1, 5)
        )
    assert str(caught.value) in " ".join(done.stderr.replace("│", " ").split())


def test_the_program_knows_the_commands_of_the_package(command):
    # Lines are as long as the terminal lets them be; those that go on are indented more.
    one_line = re.sub(r"\n {4,}", " ", command("--help").stdout)
    named = re.findall(r"^  (\w+) .*\(in the Python package\)$", one_line, re.MULTILINE)
    assert sorted(named) == sorted(OF_THE_PACKAGE)


@pytest.mark.parametrize("encoding", ["cp1252", "ascii", "cp437", "utf-8"])
def test_what_is_printed_fits_the_terminal(encoding):
    code = """
import littlewood as lw
motion = lw.case("figure-3-bounces").simulate()
doubt = lw.fitting.Doubt("held", "μₛ, Δτ ≤ 1, Î, Ŝ²")
for one in (motion, motion.outcome, lw.Noise(0.1, 0.2, 3.0), doubt):
    print(one)
"""
    environment = {**os.environ, "PYTHONIOENCODING": encoding}
    done = subprocess.run(
        [sys.executable, "-P", "-c", code], env=environment, capture_output=True, check=True
    )
    lines = done.stdout.decode(encoding).splitlines()
    if encoding == "utf-8":
        assert lines[0].startswith(
            "Hoop     m₁/m₂ = 1   ℓ/R = 1   Izz/(m₂R²) = 1   μₛ = 0.5   μₖ = 0.4"
        )
        return
    assert re.match(
        r"Hoop     m1/m2 = 1 +l/R = 1 +Izz/\(m2R(²|\^2)\) = 1 +mu_s = 0.5 +mu_k = 0.4",
        lines[0].replace("µ", "mu"),
    )
    head = next(k for k, line in enumerate(lines) if line.startswith(" #  motion"))
    # The columns are where they were: numbers end below the end of their heading.
    exact = str(lw.case("figure-3-bounces").simulate()).splitlines()
    rows = [(lines[k], exact[k]) for k in (head, *range(head + 2, head + 10))]
    for heading in ("duration", "lost"):
        assert lines[head].index(heading) == exact[head].index(heading)
    for plain, row in rows[1:]:
        assert plain[-8:] == row[-8:] and len(plain) == len(row)
    assert any("sliding <-        0   0.56411" in line for line in lines)
    assert any(line.startswith("31  rolling") and " 6.92468 " in line for line in lines)
    assert lines[-1].startswith("held: ") and "<= 1" in lines[-1].replace("≤", "<=")


def test_commands_of_the_package_print_on_any_terminal():
    for name in OF_THE_PACKAGE:
        for encoding in ("cp1252", "ascii"):
            done = subprocess.run(
                [sys.executable, "-P", "-m", "littlewood", name, "--help"],
                env={**os.environ, "PYTHONIOENCODING": encoding},
                capture_output=True,
                check=True,
            )
            assert done.stdout.decode(encoding).startswith("usage: ")
    # The program writes UTF-8 whatever the locale is.
    done = subprocess.run(
        [sys.executable, "-P", "-m", "littlewood", "simulate", "figure-3"],
        env={**os.environ, "PYTHONIOENCODING": "ascii", "LC_ALL": "C"},
        capture_output=True,
        check=True,
    )
    assert "θ′" in done.stdout.decode("utf-8")


def test_every_letter_of_our_tables_has_a_plain_one():
    texts = [text for one in lw.tables.QUANTITIES.values() for text in (one.help, one.symbol)]
    texts += [
        text for one in lw.tables.SAMPLE_COLUMNS.values() for text in (one.long_name, one.sign)
    ]
    texts += [str(lw.case(name).simulate(until=20.0)) for name in lw.CASES]
    plain = "".join(texts).encode("ascii", "littlewood").decode("ascii")
    assert plain.count("?") == "".join(texts).count("?")
