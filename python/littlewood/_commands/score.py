"""The command ``littlewood score``."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from ..cases import case
from ..certify import checker
from ..certify.compare import simulated
from ..plot.canvas import save
from ..scoring.cases import BENCHMARK, CASES
from ..scoring.convergence import convergence
from ..scoring.episodes import Tolerances
from ..scoring.gradient import read_gradient, score_gradient
from ..scoring.record import Record
from ..scoring.score import score
from ..trajectory import Trajectory

__all__ = ["main"]

_REFUSED = 2
"""Exit code of what is refused."""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="littlewood score",
        description="Hold motions that a solver has computed against the exact one.",
    )
    parser.add_argument(
        "case",
        metavar="CASE",
        help="the exact motion: a name, of the benchmark (--list), of the data set or of "
        "`littlewood simulate`, "
        "or a certificate (.json)",
    )
    parser.add_argument(
        "files",
        metavar="FILE",
        nargs="*",
        type=Path,
        help="tables with the columns time, x, y, theta (or time_s, x_m, y_m, theta_rad), perhaps "
        "contact, "
        "x_rate, y_rate, theta_rate; several with different steps also give the order of "
        "convergence",
    )
    parser.add_argument("--list", action=_List, help="list the cases of the benchmark")
    parser.add_argument(
        "--steps",
        metavar="STEP",
        type=float,
        nargs="+",
        help="the steps of the solver for each FILE, sqrt(R/g), where it has made several between "
        "two rows",
    )
    parser.add_argument(
        "--gradient",
        metavar="QUANTITY",
        help="FILE has the derivatives of x and theta at fixed times with respect to this "
        "quantity, such as mu_k",
    )
    parser.add_argument("--json", action="store_true", help="write JSON")
    parser.add_argument(
        "--plot", metavar="PICTURE", type=Path, help="draw a picture: .png, .svg or .pdf"
    )
    usual = Tolerances()
    for name, meaning in (
        ("gap", "height of the rim up to which it counts as in contact, R"),
        ("slip", "slip velocity up to which the hoop counts as rolling, sqrt(g R)"),
        ("time", "an event farther from the exact one is not the same, sqrt(R/g)"),
    ):
        value = getattr(usual, name)
        parser.add_argument(
            f"--{name}", type=float, default=value, help=f"{meaning} (default {value:g})"
        )
    return parser


class _List(argparse.Action):
    """Prints the cases of the benchmark, as --help prints the options."""

    def __init__(self, option_strings: Sequence[str], dest: str, help: str) -> None:
        super().__init__(option_strings, dest, nargs=0, help=help)

    def __call__(self, parser: argparse.ArgumentParser, *_: object) -> None:
        for name, one in BENCHMARK.items():
            print(f"{name:18} {one.category:8} {one.what}")
        parser.exit()


def _motion(text: str) -> tuple[Trajectory, list[tuple[str, float]] | None]:
    """The exact motion of a name or a certificate, and the events of the latter."""
    if not text.endswith(".json"):
        return (CASES[text].motion if text in CASES else _named(text)), None
    try:
        certificate = checker.read_file(Path(text))
        checker.intact(certificate)
    except (checker.Refused, checker.Unreadable) as error:
        raise ValueError(f"{text} is not a certificate: {error}") from None
    motion = simulated(certificate["case"])
    if not certificate["certified"]:
        raise ValueError(f"{text} certifies nothing: {certificate['reason']}")
    clock = 1.0 if motion.hoop.units is None else motion.hoop.units.time_s
    return motion, [
        (
            "impact" if one["cause"] == "landing" and one["to"] == "flight" else one["cause"],
            float(one["state"]["time"][0]) / clock,
        )
        for one in certificate["events"]
    ]


def _named(name: str) -> Trajectory:
    """The motion of a case of the command line."""
    try:
        return case(name).simulate()
    except KeyError as error:
        raise ValueError(f"{error.args[0]} `littlewood score --list` has the benchmark") from None


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; exit code 0, or 2 where something was refused."""
    parser = _parser()
    options = parser.parse_args(arguments)
    if not options.files:
        parser.error("FILE is missing: the table that the solver has written")
    try:
        return _gradients(options) if options.gradient else _scores(options)
    except (ValueError, OSError, ImportError) as error:
        print(f"error: {error}", file=sys.stderr)
        return _REFUSED


def _gradients(options: argparse.Namespace) -> int:
    motion, _ = _motion(options.case)
    scores = [
        score_gradient(motion, *read_gradient(path), options.gradient) for path in options.files
    ]
    if options.json:
        print(
            json.dumps(
                {"case": options.case, "gradients": [one.as_dict() for one in scores]}, indent=2
            )
        )
        return 0
    for path, one in zip(options.files, scores, strict=True):
        print(f"{path}:\n{one}" if len(scores) > 1 else one)
    return 0


def _scores(options: argparse.Namespace) -> int:
    tolerances = Tolerances(options.gap, options.slip, options.time)
    motion, events = _motion(options.case)
    records = [Record.from_csv(path, motion.hoop.units) for path in options.files]
    scores = [score(motion, record, tolerances, events=events) for record in records]
    steps = options.steps or [one.record.step for one in scores]
    order = convergence(scores, steps) if options.steps or len(set(steps)) > 1 else None
    if options.plot is not None:
        figure = scores[0].plot() if order is None else order.plot()
        names = ", ".join(path.name for path in options.files)
        save(
            figure,
            options.plot,
            f"Score of {names}",
            f"What a solver has computed against the exact motion, {options.case}",
        )
    if options.json:
        whole: dict[str, Any] = {"case": options.case, "scores": [one.as_dict() for one in scores]}
        if order is not None:
            whole["order"] = order.order
        print(json.dumps(whole, indent=2, allow_nan=False))
        return 0
    for path, one in zip(options.files, scores, strict=True):
        for doubt in one.doubts:
            print(f"warning: {path}: {doubt}", file=sys.stderr)
        if len(scores) > 1:
            print(f"{path}:")
        print(one, end="\n\n" if len(scores) > 1 else "\n")
    if order is not None:
        print(order)
    return 0
