"""Random motions of the whole accepted range.

The library's example `motions` draws and answers them.
"""

import json
import math
import subprocess
import sys
from pathlib import Path

SEED = "2019"
HOOP, START = (
    ("mass_ratio", "offset", "inertia", "mu_s", "mu_k"),
    ("theta", "theta_rate", "slip", "gap_rate", "x", "time"),
)


def motions(kind, count):
    """[(task, answer)]: what is drawn, and what the library says of it."""
    cargo = [
        "cargo",
        "run",
        "--release",
        "--quiet",
        "--locked",
        "-p",
        "littlewood-random",
        "--example",
        "motions",
        "--",
    ]
    run = subprocess.run(
        [*cargo, str(count), SEED, kind],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parent,
    )
    if run.returncode:
        sys.exit(run.stderr)
    return [parsed(json.loads(line)) for line in run.stdout.splitlines()]


def parsed(line):
    """A motion: (given, (transitions, outcome)).

    `given` is (numbers of the hoop, start, coefficient and law of restitution or None).
    """
    hoop, start = line["hoop"], line["start"]
    bounce = (
        None
        if hoop["restitution"] is None
        else (hoop["restitution"], hoop["restitution_law"] or "energetic")
    )
    task = tuple(hoop[k] for k in HOOP), tuple(start[k] for k in START), bounce
    # JSON has no infinite numbers: the rate of a massless hoop at its end.
    return task, (
        [
            dict(
                {k: math.inf if v is None else v for k, v in t["before"].items()},
                cause=t["cause"],
                to=t["to"] or "none",
                direction=t["direction"],
            )
            for t in line["transitions"]
        ],
        line["outcome"],
    )
