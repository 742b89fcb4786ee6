"""Runs the engines, each in its own virtual environment, and scores what they compute.

python evidence/engines/run.py [NAME ...] [--step STEP ...] [--case CASE ...] [--setting SETTING ...] [--out FOLDER]

The Python that runs this has the package of this repository; environments are made under target/engines, or where
LITTLEWOOD_ENGINES says. Results are two tables in results/: runs.csv has a row for each run, engines.csv what each
engine ran on. What is run replaces the runs of the same engine, case and setting; all others stay.
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
import venv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
ENVIRONMENTS = Path(os.environ.get("LITTLEWOOD_ENGINES", HERE.parents[1] / "target" / "engines"))
RESULTS = HERE / "results"

REFUSED = 3
"""Exit code of an adapter whose engine cannot express the case; adapters/adapter.py has it, too."""

PATIENCE = 120.0
"""Seconds that an adapter may take."""


@dataclass(frozen=True)
class Case:
    """A hoop (mass ratio and inertia 1) and its start."""

    what: str
    until: float
    theta: float
    theta_rate: float
    slip: float = 0.0
    gap_rate: float = 0.0
    mu_s: float = 0.5
    mu_k: float = 0.5
    restitution: float = 0.0
    offset: float = 1.0
    slope: float = 0.0

    def motion(self, law: str | None = None) -> Any:
        """The exact motion; all laws of restitution agree on it, as slip does not end within an impact that bounces."""
        import littlewood as lw

        parameters = {"mu_s": self.mu_s, "mu_k": self.mu_k, "restitution": self.restitution, "slope": self.slope}
        hoop = lw.Hoop(mass_ratio=1, offset=self.offset, inertia=1, restitution_law=law, **parameters)
        start = {"theta": self.theta, "theta_rate": self.theta_rate, "slip": self.slip, "gap_rate": self.gap_rate}
        return hoop.simulate(**start, until=self.until)

    def file(self, hoop: Any) -> dict[str, float]:
        """What an adapter reads."""
        return {
            "mass": hoop.mass,
            "h": hoop.h,
            "inertia": hoop.inertia_about_mass_centre,
            "slope": self.slope,
            "mu_s": self.mu_s,
            "mu_k": self.mu_k,
            "restitution": self.restitution,
            "theta": self.theta,
            "theta_rate": self.theta_rate,
            "slip": self.slip,
            "gap_rate": self.gap_rate,
            "until": self.until,
        }


CASES = {
    "figure-3": Case("Figure 3 with μs = μk: slides, rolls, slides, jumps, lands", 5.0, math.pi / 2, 2.0),
    "two-coefficients": Case("Figure 3: μs = 0.5, μk = 0.4", 5.0, math.pi / 2, 2.0, mu_k=0.4),
    "slides-and-sticks": Case("slides and sticks", 3.0, 2.0, 0.5, slip=1.0),
    "rolls": Case("rolls", 3.0, 3.0, 1.0),
    "lands": Case("is thrown, lands sliding, sticks", 2.0, 2.5, 0.5, slip=0.5, gap_rate=0.5),
    "bounces": Case("bounces three times, e = 0.5", 2.9, 1.7, -0.4, slip=3.5, gap_rate=0.7, restitution=0.5),
    "bounces-high": Case("bounces five times, e = 0.8", 4.6, -2.4, -1.5, slip=3.5, gap_rate=0.5, restitution=0.8),
    # Next to the equilibrium, in which the mass centre is over the point of contact: it rocks by 5e-6.
    "ramp-rests": Case("ramp: rests, the particle low", 5.0, -2.93298, 0.0, slope=0.2),
    "ramp-rolls": Case("ramp: balanced, rolls down without slip", 5.0, 0.0, 0.0, offset=0.0, slope=0.3),
    "ramp-slips": Case(
        "ramp: balanced, rolls down with slip", 5.0, 0.0, 0.0, mu_s=0.1, mu_k=0.1, offset=0.0, slope=0.5
    ),
    "ramp-jumps": Case("ramp: slides, rolls, slides, jumps, lands", 3.9, math.pi / 2, 2.0, slope=0.2),
}

STEPS = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5)
COARSE = (1e-2, 1e-3, 1e-4)
"""Steps of every case but the first, which has all."""

RAMPS = tuple(name for name in CASES if name.startswith("ramp-"))
"""Cases on a slope, which engines need not have run."""


@dataclass(frozen=True)
class Engine:
    """A solver: its name for people, its settings, and whether it chooses its steps itself."""

    title: str
    settings: tuple[str, ...] = ("default", "careful")
    is_adaptive: bool = False
    interpreter: str = ""
    """A Python that has the engine, where no registry has it; LITTLEWOOD_SYSTEM_PYTHON names another."""

    @property
    def least_step(self) -> float:
        """An engine that chooses its steps itself only writes more rows with a smaller one."""
        return 1e-4 if self.is_adaptive else 0.0


ENGINES = {
    "scipy": Engine("SciPy solve_ivp", is_adaptive=True),
    "heyoka": Engine("heyoka", is_adaptive=True),
    "moreau": Engine("Moreau time stepping (ours)", ("default",)),
    "pymunk": Engine("pymunk (Chipmunk)"),
    "box2d": Engine("Box2D 2.3"),
    "planck": Engine("planck (Box2D, double precision)"),
    "rapier": Engine("Rapier"),
    "bullet": Engine("Bullet"),
    "dart": Engine("DART"),
    "mujoco": Engine("MuJoCo"),
    "mjx": Engine("MJX (MuJoCo in JAX)"),
    "newton": Engine("Newton (Warp)"),
    "drake": Engine("Drake", ("default", "careful", "continuous")),
    "exudyn": Engine("Exudyn"),
    "siconos": Engine("Siconos", interpreter="/usr/bin/python3"),
}


def requirements(name: str) -> Path:
    """The file with the versions of an engine: of packages, or the manifest of a crate; an engine of ours has none."""
    manifest = HERE / "requirements" / name / "Cargo.toml"
    return manifest if manifest.exists() else HERE / "requirements" / f"{name}.txt"


def versions(text: str) -> dict[str, str]:
    """Packages and their versions in a file of requirements, or in a manifest, which names those that are exact."""
    if "[dependencies]" in text:
        return dict(re.findall(r'^([\w-]+) = "=([\w.]+)"$', text, re.MULTILINE))
    return dict(
        re.fullmatch(r"([\w.-]+)==([\w.]+)", line.strip()).groups() for line in text.splitlines() if line.strip()
    )


def adapter_of(name: str) -> Path:
    """The adapter of an engine, for Python, node or in Rust."""
    return next((HERE / "adapters").glob(f"{name}_adapter.*"))


def prepared(name: str) -> list[str]:
    """The command that runs an adapter; its environment is made if it is not there or has other versions."""
    file, adapter = requirements(name), adapter_of(name)
    if not file.exists():
        return [sys.executable, str(adapter)]
    if ENGINES[name].interpreter:
        return [os.environ.get("LITTLEWOOD_SYSTEM_PYTHON", ENGINES[name].interpreter), str(adapter)]
    folder = ENVIRONMENTS / name
    if adapter.suffix == ".rs":
        options = ["--quiet", "--release", "--locked", "--manifest-path", str(file), "--target-dir", str(folder)]
        subprocess.run(["cargo", "build", *options], check=True)
        return [str(folder / "release" / adapter.stem)]
    python, made = folder / "bin" / "python", folder / "requirements.txt"
    is_node = adapter.suffix == ".cjs"
    if not made.exists() or made.read_bytes() != file.read_bytes():
        if is_node:
            packages = [
                f"{package}@{version}" for package, version in versions(file.read_text(encoding="utf-8")).items()
            ]
            folder.mkdir(parents=True, exist_ok=True)
            subprocess.run(["npm", "install", "--silent", "--no-save", "--prefix", str(folder), *packages], check=True)
        else:
            venv.create(folder, clear=True, with_pip=True)
            install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement", str(file)]
            subprocess.run([python, *install], check=True)
        made.write_bytes(file.read_bytes())
    if is_node:
        return ["env", f"NODE_PATH={folder / 'node_modules'}", "node", str(adapter)]
    return [str(python), str(adapter)]


def steps_of(case: str, engine: Engine) -> list[float]:
    """The steps with which an engine runs a case."""
    return [step for step in (STEPS if case == next(iter(CASES)) else COARSE) if step >= engine.least_step]


def outcome(code: int | None, message: str) -> dict[str, str]:
    """What became of an adapter that wrote no record."""
    last = message.strip().splitlines()[-1:] or [""]
    if code is None:
        return {"status": "timeout", "reason": f"longer than {PATIENCE:g} s"}
    return {"status": "refused" if code == REFUSED else "failed", "reason": last[0]}


def run_adapter(prefix: list[str], case: Path, step: float, setting: str, record: Path) -> dict[str, Any]:
    """Run one adapter once: its status, and its cost."""
    command = [*prefix, str(case), repr(step), setting, str(record)]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired:
        return outcome(None, "")
    if done.returncode != 0:
        return outcome(done.returncode, done.stderr)
    return {"status": "scored", **json.loads(done.stdout.strip().splitlines()[-1])}


def kept(score: dict[str, Any]) -> dict[str, Any]:
    """What of a score goes into the results, with eight digits."""
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
        # Of events that are none, of which there may be hundreds, the number says enough.
        "events": [event for event in whole["events"] if event["exact"] is not None],
    }


def rounded(value: Any) -> Any:
    """The same with eight digits."""
    if isinstance(value, float):
        return float(f"{value:.8g}")
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    return [rounded(one) for one in value] if isinstance(value, list) else value


def runs(name: str, options: argparse.Namespace) -> Iterator[dict[str, Any]]:
    """Run an engine with all its cases, settings and steps."""
    import littlewood as lw

    engine, prefix = ENGINES[name], prepared(name)
    with tempfile.TemporaryDirectory() as folder:
        file, record = Path(folder) / "case.json", Path(folder) / "record.csv"
        for label in options.case or CASES:
            motion = CASES[label].motion()
            file.write_text(json.dumps(CASES[label].file(motion.hoop)), encoding="utf-8")
            for setting in engine.settings:
                if options.setting and setting not in options.setting:
                    continue
                for step in options.step or steps_of(label, engine):
                    run = {"case": label, "setting": setting, "step": step}
                    run |= run_adapter(prefix, file, step, setting, record)
                    if run["status"] == "scored":
                        try:
                            run |= kept(lw.scoring.score(motion, lw.scoring.Record.from_csv(record)).as_dict())
                        except ValueError as error:
                            run |= {"status": "failed", "reason": str(error).replace(str(record), "the record")}
                    print(
                        name,
                        label,
                        setting,
                        step,
                        run["status"],
                        run.get("error", run.get("reason")),
                        flush=True,
                    )
                    yield run
                    if run["status"] in ("refused", "timeout"):
                        break


NUMBERS = (
    "step",
    "cpu_s",
    "steps",
    "missed",
    "spurious",
    "error",
    "error_x",
    "error_y",
    "error_theta",
    "energy_gained",
    "energy_error_at_end",
    "slip_while_rolling",
    "penetration",
)
COUNTS = ("steps", "missed", "spurious")
COLUMNS = ("engine", "case", "setting", "status", *NUMBERS, "events", "reason")
"""Columns of runs.csv. An event is its kind, its exact time, the time found and the error, or `missed`."""


def event_text(event: dict[str, Any]) -> str:
    """One event of a cell."""
    if event["found"] is None:
        return f"{event['kind']} {event['exact']!r} missed"
    return f"{event['kind']} {event['exact']!r} {event['found']!r} {event['error']!r}"


def event_of(text: str) -> dict[str, Any]:
    """The event of a text."""
    kind, exact, *rest = text.split()
    found, error = (None, None) if rest == ["missed"] else map(float, rest)
    return {"kind": kind, "exact": float(exact), "found": found, "error": error}


def read(folder: Path) -> dict[str, list[dict[str, Any]]]:
    """The runs of each engine; a number that a run has not is None."""
    found: dict[str, list[dict[str, Any]]] = {}
    if not (folder / "runs.csv").exists():
        return found
    with (folder / "runs.csv").open(encoding="utf-8", newline="") as file:
        for row in csv.DictReader(file):
            run: dict[str, Any] = dict(row)
            for name in NUMBERS:
                run[name] = (int if name in COUNTS else float)(row[name]) if row[name] else None
            run["events"] = [event_of(text) for text in row["events"].split("; ") if text]
            found.setdefault(run.pop("engine"), []).append(run)
    return found


def read_engines(folder: Path) -> dict[str, dict[str, str]]:
    """What each engine ran on."""
    if not (folder / "engines.csv").exists():
        return {}
    with (folder / "engines.csv").open(encoding="utf-8", newline="") as file:
        return {row["engine"]: row for row in csv.DictReader(file)}


def write(folder: Path, runs: dict[str, list[dict[str, Any]]], engines: dict[str, dict[str, str]]) -> None:
    """Write both tables, engines in their order."""
    folder.mkdir(parents=True, exist_ok=True)
    names = [name for name in ENGINES if name in runs]
    with (folder / "runs.csv").open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(COLUMNS)
        for name in names:
            for run in runs[name]:
                numbers = ["" if run.get(key) is None else repr(run[key]) for key in NUMBERS]
                events = "; ".join(event_text(event) for event in run.get("events", []))
                table.writerow(
                    [name, run["case"], run["setting"], run["status"], *numbers, events, run.get("reason", "")]
                )
    with (folder / "engines.csv").open("w", encoding="utf-8", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["engine", *machine(), "packages"])
        table.writerows(engines[name].values() for name in names)


def merged(old: list[dict[str, Any]], new: list[dict[str, Any]], settings: Sequence[str]) -> list[dict[str, Any]]:
    """Runs, of which new ones replace those of the same case and setting; by case, setting and falling step."""
    again = {(run["case"], run["setting"]) for run in new}
    kept_runs = [run for run in old if (run["case"], run["setting"]) not in again and run["case"] in CASES]
    order = {label: at for at, label in enumerate(CASES)}
    return sorted(
        [*kept_runs, *new], key=lambda run: (order[run["case"]], settings.index(run["setting"]), -run["step"])
    )


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


def main(arguments: Sequence[str] | None = None) -> int:
    """Run engines and write their results."""
    parser = argparse.ArgumentParser(description="Run engines and score them.")
    parser.add_argument("names", nargs="*", metavar="NAME", help=f"engines, by default all: {', '.join(ENGINES)}")
    parser.add_argument("--case", action="append", choices=CASES)
    parser.add_argument("--setting", action="append")
    parser.add_argument("--step", action="append", type=float)
    parser.add_argument("--out", type=Path, default=RESULTS)
    options = parser.parse_args(arguments)
    for name in options.names:
        if name not in ENGINES:
            parser.error(f"no engine {name}: there are {', '.join(ENGINES)}")
    for name in options.names or ENGINES:
        found = list(runs(name, options))
        file = requirements(name)
        packages = versions(file.read_text(encoding="utf-8")) if file.exists() else {}
        every, engines = read(options.out), read_engines(options.out)
        every[name] = merged(every.get(name, []), found, ENGINES[name].settings)
        text = " ".join(f"{package}=={version}" for package, version in packages.items())
        engines[name] = {"engine": name, **machine(), "packages": text}
        write(options.out, every, engines)
    return 0


if __name__ == "__main__":
    sys.exit(main())
