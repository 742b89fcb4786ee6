"""Runs the engines, checks and scores what they compute, and writes their rows.

Each runs in its own virtual environment.

python evidence/engines/run.py [NAME ...] [--changed COMMIT] [--step STEP ...] [--case CASE ...]
[--setting SETTING ...]
                               [--out FOLDER]
python evidence/engines/run.py --compare [--minutes MINUTES] [NAME ...]

An engine is one file, adapters/NAME_adapter.py (.cjs, .rs), whose first comment says what it is and
needs; template.py is one. The Python that runs this has the package of this repository;
environments and logs are made under target/engines, or where LITTLEWOOD_ENGINES says.
results/NAME.csv has a row for each run, results/machines.csv what each engine ran on. What is run
replaces the runs of the same case and setting; all others stay.

--compare writes nothing: it runs the engines that are soon installed at the step of the tables, and
names each row of the results that has moved, and what there was no time for.
"""

from __future__ import annotations

import argparse
import csv
import json
import math
import os
import platform
import re
import subprocess
import sys
import tempfile
import time
import venv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import numpy as np
from littlewood.scoring import BENCHMARK, Record, score, score_gradient
from littlewood.scoring.gradient import read_gradient

HERE = Path(__file__).resolve().parent
ADAPTERS = HERE / "adapters"
ENVIRONMENTS = Path(os.environ.get("LITTLEWOOD_ENGINES", HERE.parents[1] / "target" / "engines"))
RESULTS = HERE / "results"

REFUSED = 3
"""Exit code of an adapter whose engine cannot express the case; adapters/adapter.py has it, too."""

PATIENCE = 120.0
"""Seconds that an adapter may take."""

STEPS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5)
COARSE = (1e-2, 1e-3, 1e-4)
"""Steps of every case but the first, which has all."""

LEAST_STEP = 1e-4
"""Of an engine that chooses its steps itself: a smaller one only writes more rows."""

DEBIAN = "/usr/bin/python3"
"""The Python of packages of Debian; LITTLEWOOD_SYSTEM_PYTHON names another."""

KEYS = (
    "engine",
    "contact",
    "settings",
    "steps",
    "requires",
    "gradients",
    "docs",
    "rolling",
    r"limits(?: \w+)?",
    "reply",
)
CONTACTS = ("events", "rigid", "compliant")


@dataclass(frozen=True)
class Engine:
    """An adapter and what its first comment says."""

    name: str
    adapter: Path

    @cached_property
    def said(self) -> dict[str, str]:
        """The lines `key: value`; one that begins with two spaces goes on with the one before."""
        text = self.adapter.read_text(encoding="utf-8").replace("\n//! ", "\n").split("\nimport")[0]
        text = re.sub(r"\n  (?=\S)", " ", text)
        return dict(re.findall(rf"^({'|'.join(KEYS)}): (.+)$", text, re.MULTILINE))

    @property
    def title(self) -> str:
        """Its name for people."""
        return self.said["engine"]

    @property
    def settings(self) -> tuple[str, ...]:
        """Its settings."""
        return tuple(self.said["settings"].split())

    @property
    def requires(self) -> list[str]:
        """Packages with exact versions.

        They are of PyPI, or with npm:, cargo:, debian: or git: before them.
        """
        return self.said.get("requires", "").split()

    @property
    def gradients(self) -> list[str]:
        """Quantities with respect to which it has derivatives."""
        return self.said.get("gradients", "").split()

    @property
    def version(self) -> str:
        """That of the engine itself."""
        words = {
            "box2d3": "pyb2d3",
            "mjwarp": "mujoco-warp",
            "mjx": "mujoco-mjx",
            "physx": "sapien",
            "hoppinghoop": "hopping-hoop",
            "rapier": "rapier2d",
        }
        name, packages = words.get(self.name, self.name), self.requires
        if packages and packages[0].startswith("cargo:"):
            lock = (HERE / "requirements" / self.name / "Cargo.lock").read_text(encoding="utf-8")
            packages = re.findall(r'name = "([\w-]+)"\nversion = "([\w.]+)"', lock)
            packages = ["==".join(one) for one in packages]
        package = next((one for one in packages if name in one.lower()), "")
        return package.rpartition("@")[2][:10] if "@" in package else package.rpartition("==")[2]

    def limits(self, setting: str) -> dict[str, str]:
        """What the engine cuts, damps or leaves out, as its adapter says it, with R = g = 1."""
        said = f"{self.said.get('limits', '')} {self.said.get(f'limits {setting}', '')}"
        return dict(one.split("=") for one in said.split())

    def refusal(self, case: str, setting: str, step: float) -> str | None:
        """Why a case is beyond a limit of the engine, with the numbers."""
        limits = self.limits(setting)
        if not {"turn", "speed"} & set(limits):
            return None
        fastest = speeds(case)
        # Where R is the same in the engine whatever the case, the limit is one in R.
        metre = 1.0 if "radius" in limits else fastest.metre
        reached = {"turn": fastest.turn, "speed": fastest.speed * metre}
        for name, unit in {"turn": "rad/s", "speed": "m/s"}.items():
            if limits.get(name, "fails") == "fails":
                continue
            number, *per_step = limits[name].split("/")
            # An angle, or a way, that a body makes in a step at most.
            most = float(number) / (step * fastest.second if per_step else 1.0)
            size = reached[name] / fastest.second
            if size > most:
                return f"limit: {most:.3g} {unit}, the case reaches {size:.4g}"
        return None

    @property
    def is_adaptive(self) -> bool:
        """Whether it chooses its steps itself."""
        return "steps" in self.said

    def check(self) -> None:
        """Refuse an adapter that does not say what it must."""
        begin = f"error: {self.adapter.name}:"
        for key in ("engine", "contact", "settings", "docs"):
            if key not in self.said:
                raise SystemExit(
                    f"{begin} its first comment has no line `{key}: …`, as template.py has"
                )
        if self.said["contact"] not in CONTACTS:
            raise SystemExit(
                f"{begin} contact is {self.said['contact']}, not {' or '.join(CONTACTS)}"
            )
        for one in self.requires:
            if not re.fullmatch(
                r"cargo:\w+|git:[\w/.-]+@[0-9a-f]{40}|(npm:|debian:)?[\w@/.-]+==[\w.+]+", one
            ):
                raise SystemExit(
                    f"{begin} requires {one}, which has no exact version: NAME==VERSION"
                )


def engines() -> dict[str, Engine]:
    """All engines by name, rigid and compliant apart."""
    found = [Engine(path.name.split("_adapter.")[0], path) for path in ADAPTERS.glob("*_adapter.*")]
    for one in found:
        one.check()
    found.sort(key=lambda one: (CONTACTS.index(one.said["contact"]), one.title.lower()))
    return {one.name: one for one in found}


def prepared(engine: Engine) -> list[str]:
    """The command that runs an adapter.

    Its environment is made if it is not there or has other versions.
    """
    adapter, folder, needs = engine.adapter, ENVIRONMENTS / engine.name, engine.requires
    if not needs:
        return [sys.executable, str(adapter)]
    if needs[0].startswith("debian:"):
        return [os.environ.get("LITTLEWOOD_SYSTEM_PYTHON", DEBIAN), str(adapter)]
    if needs[0].startswith("cargo:"):
        manifest = HERE / "requirements" / needs[0].removeprefix("cargo:") / "Cargo.toml"
        options = [
            "--quiet",
            "--release",
            "--locked",
            "--manifest-path",
            str(manifest),
            "--target-dir",
            str(folder),
        ]
        subprocess.run(["cargo", "build", *options], check=True)
        return [str(folder / "release" / adapter.stem)]
    made = folder.with_suffix(".txt")
    known = made.read_text(encoding="utf-8") if folder.exists() and made.exists() else ""
    if known != "\n".join(needs):
        make(folder, needs)
        made.write_text("\n".join(needs), encoding="utf-8")
    if needs[0].startswith("npm:"):
        return ["env", f"NODE_PATH={folder / 'node_modules'}", "node", str(adapter)]
    return [
        "env",
        f"LITTLEWOOD_SOURCES={folder / 'sources'}",
        str(folder / "bin" / "python"),
        str(adapter),
    ]


def make(folder: Path, needs: list[str]) -> None:
    """Make an environment."""
    packages = [one for one in needs if ":" not in one]
    npm = [one.removeprefix("npm:").replace("==", "@") for one in needs if one.startswith("npm:")]
    if npm:
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run(
            ["npm", "install", "--silent", "--no-save", "--prefix", str(folder), *npm], check=True
        )
        return
    venv.create(folder, clear=True, with_pip=True)
    install = [
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
        "--no-deps",
        *packages,
    ]
    subprocess.run([folder / "bin" / "python", *install], check=True)
    for one in needs:
        if one.startswith("git:"):
            source, commit = one.removeprefix("git:").split("@")
            into = folder / "sources" / source.split("/")[1]
            # A copy that is there already is as good, where the host can't be reached.
            origin = os.environ.get("LITTLEWOOD_GIT", "https://github.com/") + source
            subprocess.run(["git", "clone", "--quiet", origin, str(into)], check=True)
            subprocess.run(["git", "-C", str(into), "checkout", "--quiet", commit], check=True)


def case_file(given: Any) -> dict[str, float]:
    """What an adapter reads of a case."""
    hoop, start, units = given.motion.hoop, given.motion.start, given.motion.hoop.units
    second = 1.0 if units is None else units.time_s
    return {
        "mass": hoop.mass,
        "h": hoop.h,
        "inertia": hoop.inertia_about_mass_centre,
        "slope": hoop.slope,
        "mu_s": hoop.mu_s,
        "mu_k": hoop.mu_k,
        "rolling_resistance": hoop.rolling_resistance,
        "restitution": hoop.restitution or 0.0,
        **{name: getattr(start, name) for name in ("theta", "theta_rate", "slip", "gap_rate")},
        "until": given.given["until"] / second,
        "radius": 1.0 if units is None else units.length_m,
        "g": 1.0 if units is None else units.gravity_m_per_s2,
        "unit_of_mass": 1.0 if units is None else units.mass_kg,
    }


@dataclass(frozen=True)
class Fastest:
    """The largest |θ′| and velocity of the mass centre of a motion, and the units of its case."""

    turn: float
    speed: float
    metre: float
    second: float


@cache
def speeds(case: str) -> Fastest:
    """Those of the exact motion of a case."""
    motion = BENCHMARK[case].motion
    hoop, start, units = motion.hoop, motion.start, motion.hoop.units
    samples = motion(np.linspace(0.0, case_file(BENCHMARK[case])["until"], 2001)[1:])
    # Just after the start an impact may have changed it.
    theta, turning, slip, rising = (
        np.append(np.array(samples[name]), getattr(start, name))
        for name in ("theta", "theta_rate", "slip", "gap_rate")
    )
    along = slip - turning - hoop.h * np.cos(theta) * turning
    up = rising - hoop.h * np.sin(theta) * turning
    return Fastest(
        turn=float(np.nanmax(np.abs(turning))),
        speed=float(np.nanmax(np.hypot(along, up))),
        metre=1.0 if units is None else units.length_m,
        second=1.0 if units is None else units.time_s,
    )


def steps_of(case: str, engine: Engine) -> list[float]:
    """The steps with which an engine runs a case."""
    steps = STEPS if case == next(iter(BENCHMARK)) else COARSE
    return [step for step in steps if not engine.is_adaptive or step >= LEAST_STEP]


def outcome(code: int | None, message: str) -> dict[str, str]:
    """What became of an adapter that wrote no record."""
    last = message.strip().splitlines()[-1:] or [""]
    if code is None:
        return {"status": "timeout", "reason": f"longer than {PATIENCE:g} s"}
    return {"status": "refused" if code == REFUSED else "failed", "reason": last[0]}


def run_adapter(
    prefix: list[str], case: Path, step: float, setting: str, record: Path, log: Path
) -> dict[str, Any]:
    """Run one adapter once: its status, and its cost. What it prints is in the log."""
    command = [*prefix, str(case), repr(step), setting, str(record)]
    record.unlink(missing_ok=True)
    try:
        done = subprocess.run(
            command, capture_output=True, text=True, timeout=PATIENCE, check=False
        )
    except subprocess.TimeoutExpired:
        log.write_text(f"longer than {PATIENCE:g} s\n", encoding="utf-8")
        return outcome(None, "")
    log.write_text(done.stdout + done.stderr, encoding="utf-8")
    if done.returncode != 0:
        return outcome(done.returncode, done.stderr)
    try:
        cost = json.loads(done.stdout.strip().splitlines()[-1])
        return {"status": "scored", "cpu_s": float(f"{cost['cpu_s']:.2g}"), "steps": cost["steps"]}
    except (IndexError, KeyError, ValueError):
        return {
            "status": "failed",
            "reason": "the last line that it prints is not the JSON of adapter.main",
        }


def kept(score: dict[str, Any]) -> dict[str, Any]:
    """What of a score goes into the results, with four digits."""
    whole: dict[str, Any] = rounded(score)
    error, energy = whole["largest_error"], whole["energy"]
    return {
        "missed": whole["missed"],
        "spurious": whole["spurious"],
        "error": error["state"],
        "error_x": error["x"],
        "error_y": error["y"],
        "error_theta": error["theta"],
        "energy_gained": energy["gained"],
        "energy_error_at_end": energy["error_at_end"],
        "slip_while_rolling": whole["slip_while_rolling"],
        "penetration": whole["penetration"],
        "beyond_rates": whole["beyond_rates"],
        # Of events that are none, of which there may be hundreds, the number says enough.
        "events": [event for event in score["events"] if event["exact"] is not None],
    }


def rounded(value: Any) -> Any:
    """The same with four digits; times, which have an error beside them, with eight."""
    if isinstance(value, float):
        return float(f"{value:.4g}")
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    return [rounded(one) for one in value] if isinstance(value, list) else value


def runs(
    engine: Engine, options: argparse.Namespace, end: float = math.inf
) -> Iterator[dict[str, Any]]:
    """Run an engine with all its cases, settings and steps, up to a time of the clock."""
    prefix, today = prepared(engine), datetime.now(UTC).date().isoformat()
    logs = ENVIRONMENTS / "logs" / engine.name
    logs.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        file, record = Path(folder) / "case.json", Path(folder) / "record.csv"
        for label in options.case or BENCHMARK:
            file.write_text(json.dumps(case_file(BENCHMARK[label])), encoding="utf-8")
            for setting in engine.settings:
                if options.setting and setting not in options.setting:
                    continue
                for step in options.step or steps_of(label, engine):
                    if time.monotonic() > end:
                        return
                    log = logs / f"{label}-{setting}-{step:g}.log"
                    run = {"case": label, "setting": setting, "step": step}
                    run |= {"version": engine.version, "date": today}
                    refusal = engine.refusal(label, setting, step)
                    if refusal is None:
                        run |= run_adapter(prefix, file, step, setting, record, log)
                    else:
                        run |= {"status": "refused", "reason": refusal}
                    if run["status"] == "scored":
                        run |= scored(label, record, log)
                    said = run.get("error", run.get("reason"))
                    print(engine.name, label, setting, step, run["status"], said, flush=True)
                    yield run
                    # With a smaller step an engine turns less in each.
                    if run["status"] == "timeout" or (
                        run["status"] == "refused" and refusal is None
                    ):
                        break


def scored(label: str, record: Path, log: Path) -> dict[str, Any]:
    """The score of a record.

    One with an obvious mistake has failed, as a number would say nothing of the engine.
    """
    try:
        one = score(BENCHMARK[label].motion, Record.from_csv(record))
    except ValueError as error:
        return {"status": "failed", "reason": str(error).replace(str(record), "the record")}
    with log.open("a", encoding="utf-8") as file:
        print(one, *(f"warning: {doubt}" for doubt in one.doubts), sep="\n", file=file)
    # A question names what would explain the first rows; a solver that is far off soon is another
    # matter, and the case is the one that was asked for.
    mistakes = [
        doubt
        for doubt in one.doubts
        if doubt.startswith("the first row is not")
        or (doubt.endswith("?") and "is it the case" not in doubt)
    ]
    return {"status": "failed", "reason": mistakes[0]} if mistakes else kept(one.as_dict())


def gradient_runs(engine: Engine, options: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """Derivatives of the cases at the steps of the tables, with respect to what the engine can."""
    prefix = prepared(engine)
    logs = ENVIRONMENTS / "logs" / engine.name
    logs.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as folder:
        file, record = Path(folder) / "case.json", Path(folder) / "gradient.csv"
        for label in GRADIENT_CASES:
            if options.case and label not in options.case:
                continue
            settings = [
                one for one in engine.settings if not options.setting or one in options.setting
            ]
            # A slip that is 0 at the start has no derivative.
            quantities = [
                one for one in engine.gradients if BENCHMARK[label].given["start"].get(one) != 0.0
            ]
            for setting, quantity in ((one, other) for one in settings for other in quantities):
                for step in options.step or GRADIENT_STEPS:
                    file.write_text(
                        json.dumps({**case_file(BENCHMARK[label]), "gradient": quantity}),
                        encoding="utf-8",
                    )
                    run: dict[str, Any] = {
                        "engine": engine.name,
                        "case": label,
                        "quantity": quantity,
                    }
                    run |= {"setting": setting, "step": step}
                    log = logs / f"gradient-{label}-{quantity}-{setting}-{step:g}.log"
                    ran = run_adapter(prefix, file, step, setting, record, log)
                    print(
                        engine.name,
                        label,
                        quantity,
                        setting,
                        step,
                        ran["status"],
                        ran.get("reason", ""),
                        flush=True,
                    )
                    if ran["status"] != "scored":
                        yield run | {"phase": "", "status": ran["status"], "reason": ran["reason"]}
                        continue
                    found = score_gradient(
                        BENCHMARK[label].motion, *read_gradient(record), quantity
                    )
                    for number, phase in enumerate(found.phases):
                        numbers = {
                            "exact": phase.size,
                            "error": phase.error,
                            "wrong_signs": phase.wrong_signs,
                        }
                        yield run | {
                            "phase": f"{number} {phase.mode}",
                            "status": "scored",
                            **rounded(numbers),
                        }


GRADIENT_CASES = ("rolls", "slides-and-sticks", "lands", "bounces")
GRADIENT_STEPS = (1e-2, 1e-3)
GRADIENT_COLUMNS = (
    "engine",
    "case",
    "quantity",
    "setting",
    "step",
    "phase",
    "status",
    "exact",
    "error",
    "wrong_signs",
    "reason",
)

NUMBERS = (
    "step",
    "error",
    "missed",
    "spurious",
    "energy_error_at_end",
    "energy_gained",
    "penetration",
    "slip_while_rolling",
    "error_x",
    "error_y",
    "error_theta",
    "beyond_rates",
    "cpu_s",
    "steps",
)
COUNTS = ("steps", "missed", "spurious")
COLUMNS = ("case", "setting", "status", *NUMBERS, "version", "date", "events", "reason")
"""Columns of results/NAME.csv. An event is its kind, its exact time, where the rule reads it in the
exact motion, and
in the record; a dash where it does not."""


def event_text(event: dict[str, Any]) -> str:
    """One event of a cell."""
    times = (
        "-" if event[key] is None else f"{event[key]:.8g}" for key in ("exact", "read", "found")
    )
    return f"{event['kind']} {' '.join(times)}"


def event_of(text: str) -> dict[str, Any]:
    """The event of a text."""
    kind, *times = text.split()
    exact, seen, found = (None if time == "-" else float(time) for time in times)
    at = exact if seen is None else seen
    error = None if found is None or at is None else found - at
    return {"kind": kind, "exact": exact, "read": seen, "found": found, "error": error}


def read(folder: Path) -> dict[str, list[dict[str, Any]]]:
    """The runs of each engine; a number that a run has not is None."""
    found: dict[str, list[dict[str, Any]]] = {}
    for name in engines():
        path = folder / f"{name}.csv"
        if not path.exists():
            continue
        with path.open(encoding="utf-8", newline="") as file:
            for row in csv.DictReader(file):
                run: dict[str, Any] = dict(row)
                for key in NUMBERS:
                    text = row.get(key)
                    run[key] = (int if key in COUNTS else float)(text) if text else None
                run["events"] = [event_of(text) for text in row["events"].split("; ") if text]
                found.setdefault(name, []).append(run)
    return found


def read_rows(path: Path) -> list[dict[str, str]]:
    """The rows of a table, if it is there."""
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def write_rows(path: Path, columns: Sequence[str], rows: list[dict[str, Any]]) -> None:
    """Write a table."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w", encoding="utf-8", newline="") as file:
        table = csv.DictWriter(file, columns, lineterminator="\n", restval="")
        table.writeheader()
        table.writerows(rows)


def write(folder: Path, name: str, runs: list[dict[str, Any]]) -> None:
    """Write the runs of an engine."""
    rows = []
    for run in runs:
        row = {key: "" if run.get(key) is None else run[key] for key in COLUMNS}
        row["step"] = f"{run['step']:g}"
        rows.append(
            row | {"events": "; ".join(event_text(event) for event in run.get("events") or [])}
        )
    write_rows(folder / f"{name}.csv", COLUMNS, rows)


def merged(
    old: list[dict[str, Any]], new: list[dict[str, Any]], settings: Sequence[str]
) -> list[dict[str, Any]]:
    """Runs by case, setting and falling step.

    New ones replace those of the same case and setting.
    """
    again = {(run["case"], run["setting"]) for run in new}
    kept_runs = [
        run
        for run in old
        if (run["case"], run["setting"]) not in again and run["case"] in BENCHMARK
    ]
    order = {label: at for at, label in enumerate(BENCHMARK)}
    return sorted(
        [*kept_runs, *new],
        key=lambda run: (order[run["case"]], settings.index(run["setting"]), -run["step"]),
    )


QUICK = ("moreau", "mujoco", "bullet", "box2d", "pymunk", "planck", "jolt")
"""Engines that are installed within a minute, in this order."""

TABLE_STEP = 1e-3
"""The step of the tables."""

MOVED = 0.01
"""Of its size: by so much an error may differ on another machine."""


def moves(old: list[dict[str, Any]], new: dict[str, Any]) -> list[str]:
    """What of a run differs from the row of the results."""
    mine = [one for one in old if all(one[name] == new[name] for name in ("case", "setting"))]
    row = next((one for one in mine if one["step"] == new["step"]), None)
    if row is None and new["status"] == "refused":
        # What an engine cannot express has a row of the first step that was tried.
        row = next((one for one in mine if one["status"] == "refused"), None)
    if row is None:
        return ["there is no such row"]
    if row["status"] != new["status"]:
        return [f"{row['status']} became {new['status']} {new.get('reason', '')}".strip()]
    found = []
    for name in ("missed", "spurious", "error", "beyond_rates", "energy_gained", "penetration"):
        was, now = row[name] or 0.0, new.get(name) or 0.0
        slack = 0.0 if name in COUNTS else MOVED * max(abs(was), abs(now), 1e-6)
        if abs(now - was) > slack:
            found.append(f"{name} {was:.4g} became {now:.4g}")
    return found


def compare(names: Sequence[str], options: argparse.Namespace) -> int:
    """Run engines, and name the rows that have moved; 1 if one has."""
    end = time.monotonic() + 60.0 * options.minutes
    every, known = engines(), read(RESULTS)
    moved = same = 0
    for name in names:
        for run in runs(every[name], options, end):
            said = moves(known.get(name, []), run)
            same, moved = (same, moved + 1) if said else (same + 1, moved)
            if said:
                print(f"moved: {name} {run['case']} {run['setting']}: {'; '.join(said)}")
        if time.monotonic() > end:
            left = ", ".join(names[list(names).index(name) :])
            print(f"no time was left for all of {left}: --minutes is {options.minutes:g}")
            break
    print(f"{same} rows as before, {moved} moved")
    return 1 if moved else 0


def machine() -> dict[str, str]:
    """The machine in general words."""
    info = Path("/proc/cpuinfo")
    text = info.read_text(encoding="utf-8") if info.exists() else ""
    model = re.search(r"model name\s*: (.*)", text)
    return {
        "processor": model[1] if model else platform.machine(),
        "cores": str(os.cpu_count()),
        "system": platform.system(),
        "python": platform.python_version(),
    }


def keep(folder: Path, every: dict[str, Engine], name: str, found: list[dict[str, Any]]) -> None:
    """Write the runs of an engine beside those that are known, and what they ran on."""
    if not found:
        return
    known = read(folder).get(name, [])
    write(folder, name, merged(known, found, every[name].settings))
    machines = {row["engine"]: row for row in read_rows(folder / "machines.csv")}
    machines[name] = {"engine": name, **machine()}
    ordered = [machines[one] for one in every if one in machines]
    write_rows(folder / "machines.csv", list(ordered[0]), ordered)


def changed(commit: str) -> list[str]:
    """Engines whose adapter, or manifest, differs from a commit."""
    command = ["git", "diff", "--name-only", "--diff-filter=d", commit, "--", str(HERE)]
    paths = subprocess.run(
        command, capture_output=True, text=True, check=True, cwd=HERE
    ).stdout.split()
    return [
        name
        for name in engines()
        if any(f"/{name}_adapter." in one or f"/{name}/" in one for one in paths)
    ]


def main(arguments: Sequence[str] | None = None) -> int:
    """Run engines and write their results; 1 if one fails on any case."""
    parser = argparse.ArgumentParser(description="Run engines, score them, and write their rows.")
    every = engines()
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help=f"engines, by default all: {', '.join(every)}"
    )
    parser.add_argument(
        "--changed", metavar="COMMIT", help="those whose adapter differs from this commit"
    )
    parser.add_argument("--case", action="append", choices=BENCHMARK)
    parser.add_argument("--setting", action="append")
    parser.add_argument("--step", action="append", type=float)
    parser.add_argument("--gradients", action="store_true", help="derivatives instead of motions")
    parser.add_argument("--out", type=Path, default=RESULTS)
    parser.add_argument("--compare", action="store_true", help="name the rows that have moved")
    parser.add_argument("--minutes", type=float, default=10.0, help="for --compare, 10 by default")
    options = parser.parse_args(arguments)
    for name in options.names:
        if name not in every:
            parser.error(
                f"no engine {name}: there are {', '.join(every)}; adapters/{name}_adapter.py would "
                "be one"
            )
    if options.compare:
        options.step = options.step or [TABLE_STEP]
        return compare(options.names or QUICK, options)
    names = options.names or (list(every) if options.changed is None else changed(options.changed))
    failed = 0
    for name in names:
        engine = every[name]
        if options.gradients:
            path = options.out / "gradients.csv"
            rows = list(gradient_runs(engine, options))
            rows += [row for row in read_rows(path) if row["engine"] != name]
            write_rows(
                path,
                GRADIENT_COLUMNS,
                sorted(rows, key=lambda row: list(every).index(row["engine"])),
            )
            continue
        found: list[dict[str, Any]] = []
        try:
            found.extend(runs(engine, options))
        finally:
            # What has run is kept where the rest is interrupted.
            keep(options.out, every, name, found)
        failed += sum(run["status"] == "failed" for run in found)
    if failed:
        print(f"{failed} runs failed; logs are in {ENVIRONMENTS / 'logs'}", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
