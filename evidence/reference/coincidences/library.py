"""The library's answers."""

import subprocess
import sys
from pathlib import Path

from follower.motion import NUMBERS


def parsed(line):
    """The library's answer, in the form of `follow`."""
    parts = [part.split() for part in line.split(" | ")]
    transitions = [
        dict(cause=p[0], to=p[1], direction=int(p[2]), **dict(zip(NUMBERS, map(float, p[3:]))))
        for p in parts[1:-1]
    ]
    end = dict(zip(NUMBERS, map(float, parts[-1][1:])))
    return (parts[0][0], int(parts[0][1])), transitions, parts[-1][0], end


def library(tasks):
    """Answers of the library to starts."""
    cargo = [
        "cargo",
        "run",
        "--release",
        "--quiet",
        "--locked",
        "-p",
        "littlewood",
        "--example",
        "transitions",
    ]
    lines = "".join(
        " ".join(map(repr, numbers + start + (until,))) + "\n" for numbers, start, until in tasks
    )
    run = subprocess.run(
        cargo, input=lines, capture_output=True, text=True, check=False, cwd=Path(__file__).parent
    )
    if run.returncode:
        sys.exit(run.stderr)
    return [parsed(line) for line in run.stdout.splitlines()]
