"""Writes the tables and the picture of docs/engines.md from results/.

python evidence/engines/report.py        needs Matplotlib and the package of this repository
"""

from __future__ import annotations

import math
import sys
from typing import Any

import numpy as np
from littlewood.plot.sheet import panels
from littlewood.scoring import BENCHMARK
from littlewood.scoring.cases import CATEGORIES
from littlewood.style import BOLD, FINE, INK, LINE, LIST_DASHES
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from probe import NAMES as LIMITS
from run import HERE, RESULTS, TABLE_STEP, Engine, engines, read, read_rows

sys.path.insert(0, str(HERE.parents[1]))

from evidence.studies.pictures import write

PAGE = HERE.parents[1] / "docs" / "engines.md"
PICTURE = PAGE.parent / "engines" / "work.svg"

FIRST = next(iter(BENCHMARK))
DASHES = (LIST_DASHES[1], LIST_DASHES[0], LIST_DASHES[2])
"""Of the settings of an engine, in their order."""

GOAL = 1e-2
"""The error at which costs are compared."""

LEAST = 1e-6
"""Below it are only those that know the equations of this body."""

Run = dict[str, Any]
Runs = dict[str, list[Run]]


def scored(runs: list[Run], case: str, setting: str) -> list[Run]:
    """The scored runs of a case with a setting, by falling step."""
    found = [
        run
        for run in runs
        if (run["case"], run["setting"], run["status"]) == (case, setting, "scored")
    ]
    return sorted(found, key=lambda run: -run["step"])


def number(value: float | None) -> str:
    """Two digits, or a dash."""
    return "–" if value is None or math.isnan(value) else f"{value:.1e}"


def cell(runs: list[Run], case: str, setting: str) -> str:
    """The error at the step of the tables, and how many events are wrong; or why there is none."""
    mine = [run for run in runs if (run["case"], run["setting"]) == (case, setting)]
    cut = next(
        (run for run in mine if run["step"] == TABLE_STEP and run["status"] != "scored"), None
    )
    if cut is not None and cut["reason"].startswith("limit: "):
        return cut["reason"].split(",")[0]
    at = next(
        (run for run in mine if run["status"] == "scored" and run["step"] == TABLE_STEP), None
    )
    if at is not None:
        wrong = at["missed"] + at["spurious"]
        return number(at["error"]) + (f", {wrong} wrong" if wrong else "")
    other = min(
        (run for run in mine if run["status"] == "scored"),
        key=lambda run: run["step"],
        default=None,
    )
    if other is not None:
        return f"({number(other['error'])})"
    word = {"refused": "cannot", "timeout": "too long", "failed": "failed"}
    return word[mine[0]["status"]] if mine else "–"


def rows_of(every: dict[str, Engine], runs: Runs) -> list[tuple[Engine, str]]:
    """Engines that have run, with their settings."""
    return [(every[name], setting) for name in runs for setting in every[name].settings]


def category(name: str, every: dict[str, Engine], runs: Runs) -> list[str]:
    """The table of the cases of a category."""
    cases = [one.name for one in BENCHMARK.values() if one.category == name]
    rows = [
        f"| engine | contact | setting | {' | '.join(f'`{one}`' for one in cases)} |",
        "|---" * (len(cases) + 3) + "|",
    ]
    for engine, setting in rows_of(every, runs):
        cells = [cell(runs[engine.name], case, setting) for case in cases]
        if not set(cells) <= {"–", "cannot"}:
            rows.append(
                f"| {' | '.join([engine.title, engine.said['contact'], setting, *cells])} |"
            )
    return rows


def listed(name: str) -> list[str]:
    """What the cases of a category are."""
    return [f"- `{one.name}`: {one.what}" for one in BENCHMARK.values() if one.category == name]


def order(runs: list[Run]) -> float | None:
    """Exponent of the step in the largest error; None below three steps.

    By least squares of the logarithms.
    """
    pairs = [(run["step"], run["error"]) for run in runs if run["error"] > 0.0]
    if len(pairs) < 3:
        return None
    steps, errors = np.log(pairs).T
    return float(np.polyfit(steps, errors, 1)[0])


def event(run: Run, kind: str) -> float | None:
    """Size of the error of the last event of a kind; None where it was missed."""
    errors = [
        abs(one["error"])
        for one in run["events"]
        if one["kind"] == kind and one["error"] is not None
    ]
    return errors[-1] if errors else None


def cost(runs: list[Run]) -> float | None:
    """Processor time at which the error is GOAL.

    A line through the logarithms leads from run to run.
    """
    for coarse, fine in zip([None, *runs], runs, strict=False):
        if fine["error"] <= GOAL:
            if (
                coarse is None
                or coarse["cpu_s"] == fine["cpu_s"]
                or coarse["error"] <= fine["error"]
            ):
                return float(fine["cpu_s"])
            share = math.log(GOAL / coarse["error"]) / math.log(fine["error"] / coarse["error"])
            return float(coarse["cpu_s"] * (fine["cpu_s"] / coarse["cpu_s"]) ** share)
    return None


def summary(every: dict[str, Engine], runs: Runs) -> list[str]:
    """The table of the first case: events, state, energy, order, cost at equal error."""
    rows = [
        "| engine | contact | setting | stick | lift-off | landing | x, y, θ | energy | wrong | "
        f"rates | order | s to {GOAL:g} |",
        "|---|---|---|---|---|---|---|---|---|---|---|---|",
    ]
    for engine, setting in rows_of(every, runs):
        mine = scored(runs[engine.name], FIRST, setting)
        at = next((run for run in mine if run["step"] == TABLE_STEP), None)
        head = [engine.title, engine.said["contact"], setting]
        if at is None:
            why = cell(runs[engine.name], FIRST, setting)
            if why != "–":
                rows.append(f"| {' | '.join([*head, *['–'] * 3, why, *['–'] * 5])} |")
            continue
        law = None if engine.is_adaptive else order(mine)
        cells = [number(event(at, kind)) for kind in ("stick", "lift_off", "landing")]
        cells += [
            number(at["error"]),
            number(abs(at["energy_error_at_end"])),
            str(at["missed"] + at["spurious"]),
            number(at["beyond_rates"]),
        ]
        cells += ["–" if law is None else f"{round(law, 1) + 0.0:.1f}", number(cost(mine))]
        rows.append(f"| {' | '.join([*head, *cells])} |")
    return rows


def gradients(every: dict[str, Engine]) -> list[str]:
    """The table of derivatives: error over size in each phase, and signs that are wrong."""
    rows = [
        "| engine | setting | case | with respect to | step | phases |",
        "|---|---|---|---|---|---|",
    ]
    found: dict[tuple[str, ...], list[str]] = {}
    for row in read_rows(RESULTS / "gradients.csv"):
        key = tuple(row[name] for name in ("engine", "setting", "case", "quantity", "step"))
        if row["status"] != "scored":
            continue
        size, error = float(row["exact"]), float(row["error"])
        wrong = round(100 * float(row["wrong_signs"]))
        text = f"{row['phase'].split()[1]} {number(error / size) if size else number(error)}"
        found.setdefault(key, []).append(text + (f", {wrong} % of signs wrong" if wrong else ""))
    for (name, setting, case, quantity, step), phases in found.items():
        cells = [every[name].title, setting, f"`{case}`", quantity, step, "; ".join(phases)]
        rows.append(f"| {' | '.join(cells)} |")
    return rows


def settings(every: dict[str, Engine], runs: Runs) -> list[str]:
    """Versions, where settings are documented, and what the authors say."""
    rows = ["| engine | version | rows of | settings | author's reply |", "|---|---|---|---|---|"]
    for name in runs:
        engine = every[name]
        version, dates = (
            ", ".join(sorted({run[key] for run in runs[name]})) for key in ("version", "date")
        )
        adapter = f"[adapter](../evidence/engines/adapters/{engine.adapter.name})"
        docs = engine.said["docs"]
        link = f"[documentation]({docs})" if docs.startswith("http") else f"[scheme](../{docs})"
        rows.append(
            f"| {engine.title} | {version or '–'} | {dates} | {adapter}, {link} | "
            f"{engine.said.get('reply', '–')} |"
        )
    machine = read_rows(RESULTS / "machines.csv")[0]
    said = (
        f"{machine['system']}, {machine['processor']}, {machine['cores']} cores, Python "
        f"{machine['python']}."
    )
    return [*rows, "", said]


def limits(every: dict[str, Engine]) -> list[str]:
    """What was measured of each engine besides the cases."""
    rows = [
        f"| engine | setting | {' | '.join(name.replace('_', ' ') for name in LIMITS)} |",
        "|---" * (len(LIMITS) + 2) + "|",
    ]
    for row in read_rows(RESULTS / "limits.csv"):
        cells = [row[name] or "–" for name in LIMITS]
        rows.append(f"| {' | '.join([every[row['engine']].title, row['setting'], *cells])} |")
    return rows


def rolling(every: dict[str, Engine]) -> list[str]:
    """Engines with rolling friction, and its law."""
    return [
        f"- {one.title}: {one.said['rolling']}" for one in every.values() if "rolling" in one.said
    ]


def picture(every: dict[str, Engine], runs: Runs) -> Figure:
    """A panel for each engine, dark, before all others."""
    lines = {
        name: [scored(runs[name], FIRST, setting) for setting in every[name].settings]
        for name in runs
        if any(scored(runs[name], FIRST, setting) for setting in every[name].settings)
    }
    drawn, axes = panels(
        len(lines), columns=4, height=165.0, letters=False, sharex=True, sharey=True
    )
    # One line with gaps is all others.
    gap = {"cpu_s": math.nan, "error": math.nan}
    others = [run for some in lines.values() for mine in some for run in (*mine, gap)]
    for panel, (name, some) in zip(axes, lines.items(), strict=True):
        panel.loglog(*points(others), color=LINE, linewidth=FINE, linestyle="solid")
        for mine, dashes in zip(some, DASHES, strict=False):
            panel.plot(
                *points(mine),
                color=INK,
                linewidth=BOLD,
                linestyle=dashes,
                marker="o",
                markersize=2.5,
            )
        panel.set_title(every[name].title.split(" (")[0])
    settings = [
        Line2D([], [], color=INK, lw=BOLD, ls=dashes, marker="o", ms=2.5) for dashes in DASHES
    ]
    drawn.legend(
        settings,
        ["first setting of the tables", "second", "third"],
        loc="outside upper left",
        ncols=3,
    )
    drawn.supxlabel("processor time, s")
    drawn.supylabel("largest error of *x*, *y*, *θ*")
    return drawn


def points(runs: list[Run]) -> tuple[list[float], list[float]]:
    """Costs and errors, those below LEAST drawn there."""
    return [run["cpu_s"] for run in runs], [np.maximum(run["error"], LEAST) for run in runs]


def put(text: str, label: str, rows: list[str]) -> str:
    """The page with a table in its place."""
    begin, end = f"<!-- {label} -->\n", f"<!-- /{label} -->"
    before, rest = text.split(begin)
    return before + begin + "\n".join(rows) + "\n" + end + rest.split(end)[1]


def main() -> None:
    """Write everything."""
    every, runs = engines(), read(RESULTS)
    write(lambda: picture(every, runs), PICTURE, PAGE)
    text = PAGE.read_text(encoding="utf-8")
    tables = {
        "summary": summary(every, runs),
        "gradients": gradients(every),
        "settings": settings(every, runs),
        "measured limits": limits(every),
        "rolling laws": rolling(every),
    }
    for name in CATEGORIES:
        tables[f"{name} cases"] = listed(name)
        tables[name] = category(name, every, runs)
    for label, rows in tables.items():
        text = put(text, label, rows)
    PAGE.write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
