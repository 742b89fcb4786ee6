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
from ..trajectory import Trajectory
from .convergence import convergence
from .episodes import Tolerances
from .record import Record
from .score import score

__all__ = ["main"]

_REFUSED = 2
"""Exit code of what is refused."""


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="littlewood score", description="Hold motions that a solver has computed against the exact one."
    )
    parser.add_argument(
        "case",
        metavar="CASE",
        help="name of the exact motion, as `littlewood simulate` takes it, or a certificate (.json)",
    )
    parser.add_argument(
        "files",
        metavar="FILE",
        nargs="+",
        type=Path,
        help="tables with the columns time, x, y, theta (or time_s, x_m, y_m, theta_rad), perhaps contact; "
        "several with different steps also give the order of convergence",
    )
    parser.add_argument("--json", action="store_true", help="write JSON")
    parser.add_argument("--plot", metavar="PICTURE", type=Path, help="draw a picture: .png, .svg or .pdf")
    usual = Tolerances()
    for name, meaning in (
        ("gap", "height of the rim up to which it counts as in contact, R"),
        ("slip", "slip velocity up to which the hoop counts as rolling, sqrt(g R)"),
        ("time", "an event farther from the exact one is not the same, sqrt(R/g)"),
    ):
        value = getattr(usual, name)
        parser.add_argument(f"--{name}", type=float, default=value, help=f"{meaning} (default {value:g})")
    return parser


def _motion(text: str) -> Trajectory:
    """The exact motion of a name, or of the case of a certificate."""
    if not text.endswith(".json"):
        return case(text).simulate()
    try:
        certificate = checker.read(Path(text).read_bytes())
        checker.intact(certificate)
    except (checker.Refused, checker.Unreadable) as error:
        raise ValueError(f"{text} is not a certificate: {error}") from None
    return simulated(certificate["case"])


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command.

    Parameters
    ----------
    arguments : sequence of str, optional
        Those of the command; of the process by default.

    Returns
    -------
    int
        Exit code: 0, or 2 where something was refused.
    """
    options = _parser().parse_args(arguments)
    try:
        tolerances = Tolerances(options.gap, options.slip, options.time)
        motion = _motion(options.case)
        records = [Record.from_csv(path, motion.hoop.units) for path in options.files]
        scores = [score(motion, record, tolerances) for record in records]
        order = convergence(scores) if len({one.record.step for one in scores}) > 1 else None
        if options.plot is not None:
            figure = scores[0].plot() if order is None else order.plot()
            figure.savefig(options.plot, dpi=200)
    except (ValueError, KeyError, OSError, ImportError) as error:
        message = error.args[0] if isinstance(error, KeyError) else error
        print(f"error: {message}", file=sys.stderr)
        return _REFUSED
    if options.json:
        whole: dict[str, Any] = {"case": options.case, "scores": [one.as_dict() for one in scores]}
        if order is not None:
            whole["order"] = order.order
        print(json.dumps(whole, indent=2, allow_nan=False))
        return 0
    for path, one in zip(options.files, scores, strict=True):
        if len(scores) > 1:
            print(f"{path}:")
        print(one, end="\n\n" if len(scores) > 1 else "\n")
    if order is not None:
        print(order)
    return 0
