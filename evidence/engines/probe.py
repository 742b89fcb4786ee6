"""Measures what engines cut, damp or leave out, and compares it with what their adapters say.

python evidence/engines/probe.py [NAME ...] [--changed COMMIT] [--out FOLDER]

Each probe is a short motion of a balanced disc, of mass 1 and inertia 1/2, with R = g = 1 and a
step of 1e-3, through the adapter. results/limits.csv has a row for each setting of an engine; the
adapters say the same in the lines `limits:` of their first comments, with these names. The exit
code is 1 if they differ.

own_turn, own_speed: what the package as it comes cuts θ′ and x′ to; turn, speed: what is left of
that in the adapter, by which `run.py` refuses a case. A number with /step is an angle, or a way,
in a step. damping: rates of decay of x′ and θ′ in flight, as the package comes. sleep: the largest
rate of rolling at which a disc is stopped, as the package comes. bounce: the least velocity of a
landing after which it bounces. friction: how the coefficients of two bodies combine, or that there
is one for the pair. force: the reported force after the first step of a body at rest, over its
weight, and how many steps later than the velocity it changes in a landing. rolling, rolling_small:
the couple that brakes a disc over χ N R, for χ = 0.1 and 1e-4 at a rate of 1; rolling_slow: for
1e-4 at a rate of 0.01.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import sys
import tempfile
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from pathlib import Path

import numpy as np
from run import (
    RESULTS,
    Engine,
    changed,
    engines,
    prepared,
    read_rows,
    run_adapter,
    write_rows,
)

STEP = 1e-3
NAMES = (
    "own_turn",
    "turn",
    "own_speed",
    "speed",
    "damping",
    "sleep",
    "bounce",
    "friction",
    "force",
    "rolling",
    "rolling_small",
    "rolling_slow",
)
COLUMNS = ("engine", "setting", *NAMES, "version", "date")

FASTEST = {"turn": 1e4, "speed": 1e4}
"""What is tried, rad/s and m/s."""

LANDINGS = (3.0, 1.9, 1.5, 1.05, 0.95, 0.7, 0.5, 0.3, 0.19, 0.14, 0.08, 0.04)
ROLLS = (1.0, 0.3, 0.1, 0.03, 0.01, 0.003)
HOOP, PLANE = 0.4, 0.1
"""Coefficients whose combination is measured."""

COMBINED = {
    "product": HOOP * PLANE,
    "root": math.sqrt(HOOP * PLANE),
    "mean": 0.5 * (HOOP + PLANE),
    "harmonic": 2.0 * HOOP * PLANE / (HOOP + PLANE),
    "least": PLANE,
    "greatest": HOOP,
}

Columns = dict[str, np.ndarray]
Try = Callable[..., Columns | None]


class FailedError(Exception):
    """An adapter ended with an error, or yields no rates: nothing is known."""


def case(**given: float) -> dict[str, float]:
    """The case of a probe: a balanced disc at rest, but for what is given."""
    disc = {
        "mass": 1.0,
        "h": 0.0,
        "inertia": 0.5,
        "slope": 0.0,
        "mu_s": 0.5,
        "mu_k": 0.5,
    }
    start = {
        "rolling_resistance": 0.0,
        "restitution": 0.0,
        "theta": 0.0,
        "theta_rate": 0.0,
    }
    units = {"slip": 0.0, "gap_rate": 0.0, "radius": 1.0, "g": 1.0, "unit_of_mass": 1.0}
    return disc | start | units | given


def trier(engine: Engine, setting: str, folder: Path) -> Try:
    """What runs a probe: its columns, or None where the adapter refuses it."""
    prefix, file, record = prepared(engine), folder / "case.json", folder / "record.csv"

    def run(step: float = STEP, **given: float) -> Columns | None:
        file.write_text(json.dumps(case(**given)), encoding="utf-8")
        ran = run_adapter(prefix, file, step, setting, record, folder / "log")
        if ran["status"] == "refused":
            return None
        if ran["status"] != "scored":
            raise FailedError
        with record.open(encoding="utf-8", newline="") as text:
            rows = list(csv.DictReader(text))
        columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}
        if "theta_rate" not in columns:
            raise FailedError
        return columns

    return run


def cut(run: Try, name: str, *, is_untouched: bool) -> str:
    """The fastest of a fast flight: empty where nothing is cut, an angle a step with /step."""
    size, left = FASTEST[name], []
    for step in (1e-2, 1e-3):
        rates = {"theta_rate": size, "slip": size} if name == "turn" else {"slip": size}
        found = run(step, gap_rate=1.0, until=5 * step, is_untouched=is_untouched, **rates)
        if found is None:
            return "?"
        rate = found["theta_rate" if name == "turn" else "x_rate"]
        left.append(float(np.max(np.abs(rate[1:]))))
    coarse, fine = left
    if fine > 0.99 * size and coarse > 0.99 * size:
        return ""
    is_per_step = coarse < 0.5 * fine
    return f"{coarse * 1e-2:.3g}/step" if is_per_step else f"{fine:.3g}"


def damping(run: Try) -> str:
    """Rates of decay in a flight of 1."""
    found = run(gap_rate=1.0, slip=2.0, theta_rate=1.0, until=1.0, is_untouched=True)
    if found is None:
        return "?"
    left = (float(found[name][-1]) for name in ("x_rate", "theta_rate"))
    rates = [max(0.0, -math.log(max(one, 1e-9))) for one in left]
    return "" if max(rates) < 1e-5 else ",".join(f"{one:.2g}" for one in rates)


def sleep(run: Try) -> str:
    """The largest rate of rolling from which a disc comes to rest."""
    for rate in ROLLS:
        found = run(theta_rate=-rate, until=4.0, is_untouched=True)
        if found is None:
            return "?"
        if np.ptp(found["x"][-50:]) == 0.0:
            return f"{rate:g}"
    return ""


def bounce(run: Try) -> str:
    """The least velocity of those tried from which a body bounces; empty if from all."""

    def rises(velocity: float) -> bool | None:
        found = run(gap_rate=velocity, restitution=0.5, until=2.5 * velocity)
        if found is None:
            return None
        behind = found["time"] > 2.05 * velocity
        return bool(np.max(found["y"][behind]) - 1.0 > 0.25 * 0.125 * velocity**2)

    low, high = 0, len(LANDINGS)  # all before low bounce, none from high on
    while low < high:
        middle = (low + high) // 2
        said = rises(LANDINGS[middle])
        if said is None:
            return "none"
        low, high = (middle + 1, high) if said else (low, middle)
    return "never" if low == 0 else "" if low == len(LANDINGS) else f"{LANDINGS[low - 1]:g}"


def friction(run: Try) -> str:
    """How two coefficients combine."""
    found = run(slip=1.0, mu_s=HOOP, mu_k=HOOP, plane=PLANE, until=0.5)
    if found is None:
        return "pair"
    first, last = found["x_rate"][100], found["x_rate"][-1]
    mine = float(first - last) / 0.4
    name = min(COMBINED, key=lambda one: abs(math.log(COMBINED[one] / max(mine, 1e-9))))
    return name if abs(mine / COMBINED[name] - 1.0) < 0.1 else f"{mine:.2g}"


def force(run: Try) -> str:
    """The force after the first step at rest, and how late it is in a landing."""
    rest = run(until=0.02, has_force=True)
    if rest is None or "force" not in rest:
        return "none"
    fall = run(gap_rate=0.1, until=0.4, has_force=True)
    if fall is None:
        return "?"
    change = np.diff(fall["y_rate"]) + STEP
    braked = int(np.flatnonzero(change > 0.5 * STEP)[0]) + 1
    pushed = np.flatnonzero(fall["force"] > 1e-3)
    late = "never" if pushed.size == 0 else f"{int(pushed[0]) - braked:+d}"
    return f"{rest['force'][1]:.2f},{late}"


def rolling(run: Try, size: float, rate: float) -> str:
    """The couple that brakes a disc, over χ N R."""
    found = run(theta_rate=-rate, rolling_resistance=size, until=2.0)
    if found is None:
        return "none"
    first, last = (float(found["theta_rate"][i]) for i in (1000, -1))
    return f"{(last - first) * 1.5 / (size * 1.0):.2g}"


def measured(run: Try) -> dict[str, str]:
    """All limits of one setting; `fails` where the adapter ends with an error."""
    probes: dict[str, Callable[[], str]] = {
        "own_turn": lambda: cut(run, "turn", is_untouched=True),
        "turn": lambda: cut(run, "turn", is_untouched=False),
        "own_speed": lambda: cut(run, "speed", is_untouched=True),
        "speed": lambda: cut(run, "speed", is_untouched=False),
        "damping": lambda: damping(run),
        "sleep": lambda: sleep(run),
        "bounce": lambda: bounce(run),
        "friction": lambda: friction(run),
        "force": lambda: force(run),
        "rolling": lambda: rolling(run, 0.1, 1.0),
        "rolling_small": lambda: rolling(run, 1e-4, 1.0),
        "rolling_slow": lambda: rolling(run, 1e-4, 0.01),
    }
    found = {}
    for name in NAMES:
        try:
            found[name] = probes[name]()
        except FailedError:
            found[name] = "fails"
    return found


def differences(engine: Engine, setting: str, found: dict[str, str]) -> list[str]:
    """What the adapter says otherwise than it was measured."""
    said = engine.limits(setting)
    names = [name for name in NAMES if said.get(name, "") != found[name]]
    return [f"{name}={found[name]}, the adapter says {said.get(name, '')}" for name in names]


def main(arguments: Sequence[str] | None = None) -> int:
    """Measure, write, compare."""
    every = {name: one for name, one in engines().items() if one.said["contact"] != "events"}
    parser = argparse.ArgumentParser(description="Measure the limits of engines.")
    parser.add_argument("names", nargs="*", metavar="NAME", choices=[*every, []])
    parser.add_argument("--changed", metavar="COMMIT", help="those whose adapter differs from it")
    parser.add_argument("--out", type=Path, default=RESULTS)
    options = parser.parse_args(arguments)
    path = options.out / "limits.csv"
    different = 0
    names = options.names or every
    if options.changed is not None:
        names = [name for name in changed(options.changed) if name in every]
    for name in names:
        engine = every[name]
        rows = []
        for setting in engine.settings:
            with tempfile.TemporaryDirectory() as folder:
                found = measured(trier(engine, setting, Path(folder)))
            said = differences(engine, setting, found)
            different += len(said)
            print(name, setting, "; ".join(said) or "as its adapter says", flush=True)
            version = {
                "version": engine.version,
                "date": datetime.now(UTC).date().isoformat(),
            }
            rows.append({"engine": name, "setting": setting, **found, **version})
        rows += [row for row in read_rows(path) if row["engine"] != name]
        rows.sort(key=lambda row: list(every).index(row["engine"]))
        write_rows(path, COLUMNS, rows)
    return 1 if different else 0


if __name__ == "__main__":
    sys.exit(main())
