"""Writes the tables and pictures of docs/engines.md from results/.

python evidence/engines/report.py        needs Matplotlib and the package of this repository, for its colours
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import matplotlib as mpl
import numpy as np
from littlewood.style import FAINT, INK, LINE
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from run import CASES, ENGINES, HERE, PATIENCE, RAMPS, RESULTS, read, read_engines

DOCS = HERE.parents[1] / "docs"
PAGE = DOCS / "engines.md"
PICTURES = DOCS / "engines"

FIRST = next(iter(CASES))
TABLE_STEP = 1e-3
ADAPTIVE = {engine.title for engine in ENGINES.values() if engine.is_adaptive}

COLOURS = {
    "scipy": "#000000",
    "heyoka": "#7f7f7f",
    "moreau": "#0072b2",
    "pymunk": "#d55e00",
    "box2d": "#cc79a7",
    "planck": "#882255",
    "rapier": "#661100",
    "bullet": "#009e73",
    "dart": "#332288",
    "mujoco": "#e69f00",
    "mjx": "#6b4c00",
    "newton": "#117733",
    "drake": "#56b4e9",
    "exudyn": "#999933",
    "siconos": "#aa4499",
}
MARKS = {
    "scipy": "s",
    "heyoka": "D",
    "moreau": "o",
    "pymunk": "^",
    "box2d": "v",
    "planck": "<",
    "rapier": ">",
    "bullet": "P",
    "dart": "p",
    "mujoco": "X",
    "mjx": "+",
    "newton": "H",
    "drake": "*",
    "exudyn": "h",
    "siconos": "d",
}
BELOW = ("mjx",)
"""Drawn below the others, with larger marks: its errors are MuJoCo's."""
DASHES: dict[str, Any] = {"default": (0, (4, 2)), "careful": "solid", "continuous": (0, (1, 1.2))}

Run = dict[str, Any]
Quantity = Callable[[Run], float]


def chosen(engine: dict[str, Any], case: str, setting: str) -> list[Run]:
    """The scored runs of a case with a setting, by falling step."""
    found = [run for run in engine["runs"] if (run["case"], run["setting"], run["status"]) == (case, setting, "scored")]
    return sorted(found, key=lambda run: -run["step"])


def takes_too_long(engine: dict[str, Any], case: str, setting: str) -> bool:
    """Whether a run with the step of the tables, or one before it, was ended."""
    return any(
        (run["case"], run["setting"], run["status"]) == (case, setting, "timeout") and run["step"] >= TABLE_STEP
        for run in engine["runs"]
    )


def settings(engine: dict[str, Any]) -> list[str]:
    """Settings in the order in which they were run."""
    return list(dict.fromkeys(run["setting"] for run in engine["runs"]))


def event(run: Run, kind: str) -> float:
    """Error of the last event of a kind that both have; nan where it was missed."""
    errors = [one["error"] for one in run["events"] if one["kind"] == kind and one["error"] is not None]
    return abs(errors[-1]) if errors else math.nan


def state(run: Run) -> float:
    """Largest error of x, y and θ."""
    return float(run["error"])


def order(runs: list[Run]) -> float | None:
    """Exponent of the step in the largest error, by least squares of the logarithms; None below three steps."""
    pairs = [(run["step"], state(run)) for run in runs if state(run) > 0.0]
    if len(pairs) < 3:
        return None
    steps, errors = np.log(pairs).T
    return float(np.polyfit(steps, errors, 1)[0])


QUANTITIES: dict[str, tuple[str, Quantity]] = {
    "lift-off": ("error of the lift-off, √(R/g)", lambda run: event(run, "lift_off")),
    "landing": ("error of the landing, √(R/g)", lambda run: event(run, "landing")),
    "state": ("largest error of x, y, θ", state),
    "energy": ("energy at the end, error, m₂gR", lambda run: abs(run["energy_error_at_end"])),
    "penetration": ("penetration, R", lambda run: run["penetration"] or math.nan),
    "wrong": ("events missed or that are none", lambda run: run["missed"] + run["spurious"]),
}

FLOORS = {"state": 1e-6, "energy": 1e-7}
"""Below them are only those that know the equations of this body, far from all others."""


def lines(axes: Axes, engines: dict[str, Any], across: Quantity, up: Quantity) -> None:
    """One line for each engine and setting."""
    for name, engine in engines.items():
        for setting in settings(engine):
            runs = chosen(engine, FIRST, setting)
            axes.plot(
                [across(run) for run in runs],
                [up(run) for run in runs],
                color=COLOURS[name],
                marker=MARKS[name],
                markersize=(4.5 if setting == "careful" else 2.5) * (2.0 if name in BELOW else 1.0),
                zorder=1.9 if name in BELOW else 2.0,
                linestyle=DASHES[setting],
                linewidth=1.4 if setting == "careful" else 0.6,
            )


def figure(engines: dict[str, Any], parts: list[tuple[str, Quantity, str]]) -> Figure:
    """Panels side by side, with one legend."""
    drawn = Figure(figsize=(4.3 * len(parts), 5.2), layout="constrained")
    panels = drawn.subplots(1, len(parts), squeeze=False)[0]
    for axes, (across, value, what) in zip(panels, parts, strict=True):
        label, up = QUANTITIES[what]
        lines(axes, engines, value, up)
        axes.set_xscale("log")
        axes.set_yscale("symlog" if what == "wrong" else "log", **({"linthresh": 10} if what == "wrong" else {}))
        axes.set_xlabel(across)
        axes.set_title(label, fontsize=10, loc="left", color=INK)
        axes.grid(color=FAINT, linewidth=0.5)
        axes.tick_params(colors=INK, labelsize=9)
        for spine in axes.spines.values():
            spine.set_color(LINE)
        if what == "wrong":
            axes.set_ylim(bottom=-0.5)
        elif what in FLOORS:
            axes.set_ylim(bottom=FLOORS[what])
    keys = [
        Line2D([], [], color=COLOURS[name], marker=MARKS[name], linestyle="none", label=engine["title"])
        for name, engine in engines.items()
    ]
    keys += [Line2D([], [], color=INK, linestyle=dash, label=name) for name, dash in DASHES.items()]
    drawn.legend(handles=keys, loc="outside lower center", ncols=2 * len(parts), frameon=False, fontsize=9)
    return drawn


def step(run: Run) -> float:
    """The step."""
    return float(run["step"])


def cost(run: Run) -> float:
    """Processor time."""
    return float(run["cpu_s"])


STEP, COST = "step, √(R/g)", "processor time, s"
PICTURE_PARTS = {
    "events": [(STEP, step, "lift-off"), (STEP, step, "landing"), (STEP, step, "wrong")],
    "cost": [(COST, cost, "lift-off"), (COST, cost, "state")],
    "state": [(STEP, step, "state"), (STEP, step, "energy"), (STEP, step, "penetration")],
}


def number(value: float | None) -> str:
    """Two digits, or a dash."""
    return "–" if value is None or math.isnan(value) else f"{value:.1e}"


def summary(engines: dict[str, Any]) -> list[str]:
    """The table of the first case."""
    rows = [
        "| engine | setting | stick | lift-off | landing | x, y, θ | energy | missed | spurious | order | time, s |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for engine in engines.values():
        for setting in settings(engine):
            runs = chosen(engine, FIRST, setting)
            at = next((run for run in runs if run["step"] == TABLE_STEP), None)
            if at is None:
                if takes_too_long(engine, FIRST, setting):
                    rows.append(f"| {engine['title']} | {setting} {'| – ' * 8}| above {PATIENCE:g} |")
                continue
            law = order(runs)
            cells = [engine["title"], setting, *(number(event(at, kind)) for kind in ("stick", "lift_off", "landing"))]
            cells += [number(state(at)), number(at["energy_error_at_end"]), str(at["missed"]), str(at["spurious"])]
            has_order = engine["title"] not in ADAPTIVE and setting != "continuous" and law is not None
            cells += [f"{round(law, 1) + 0.0:.1f}" if has_order else "–", number(cost(at))]
            rows.append(f"| {' | '.join(cells)} |")
    return rows


def others(labels: list[str], engines: dict[str, Any]) -> list[str]:
    """The table of some cases: largest error, and events missed or that are none."""
    rows = [
        f"| engine | setting | {' | '.join(CASES[label].what for label in labels)} |",
        "|---" * (len(labels) + 2) + "|",
    ]
    for engine in engines.values():
        for setting in settings(engine):
            cells = [engine["title"], setting]
            for label in labels:
                mine = [run for run in engine["runs"] if run["case"] == label and run["setting"] == setting]
                at = next((run for run in mine if run["step"] == TABLE_STEP and run["status"] == "scored"), None)
                if at is None:
                    slow = "too long" if takes_too_long(engine, label, setting) else "–"
                    cells.append("cannot" if any(run["status"] == "refused" for run in mine) else slow)
                    continue
                wrong = at["missed"] + at["spurious"]
                cells.append(number(state(at)) + (f", {wrong} wrong" if wrong else ""))
            rows.append(f"| {' | '.join(cells)} |")
    return rows


def machines(engines: dict[str, Any]) -> list[str]:
    """Versions, and on what they ran."""
    rows = ["| engine | version |", "|---|---|"]
    for name, engine in engines.items():
        packages = (package.split("==") for package in engine["ran"]["packages"].split())
        version = next((version for package, version in packages if name in package.lower()), "–")
        rows.append(f"| {engine['title']} | {version} |")
    one = next(iter(engines.values()))["ran"]
    return [*rows, "", f"{one['system']}, {one['processor']}, {one['cores']} cores, Python {one['python']}."]


def put(text: str, label: str, rows: list[str]) -> str:
    """The page with a table in its place."""
    begin, end = f"<!-- {label} -->\n", f"<!-- /{label} -->"
    before, rest = text.split(begin)
    return before + begin + "\n".join(rows) + "\n" + end + rest.split(end)[1]


def main() -> None:
    """Write everything."""
    ran = read_engines(RESULTS)
    engines = {
        name: {"title": ENGINES[name].title, "runs": runs, "ran": ran[name]} for name, runs in read(RESULTS).items()
    }
    mpl.rcParams["svg.hashsalt"] = "littlewood"
    PICTURES.mkdir(exist_ok=True)
    for name, parts in PICTURE_PARTS.items():
        figure(engines, parts).savefig(PICTURES / f"{name}.svg", metadata={"Date": None})
    text = PAGE.read_text(encoding="utf-8")
    level = [label for label in CASES if label != FIRST and label not in RAMPS]
    tables = {"figure 3": summary(engines), "cases": others(level, engines), "ramps": others([*RAMPS], engines)}
    for label, rows in (tables | {"versions": machines(engines)}).items():
        text = put(text, label, rows)
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
