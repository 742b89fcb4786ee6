#!/usr/bin/env python3
"""Asks integrators with events about events that are known exactly, and writes what they report.

    python3 evidence/bench/events.py [--only NAME]

The questions are in events/problems.py. The table goes into docs/compare.md, between markers; with
`--only` it is printed instead. Two minutes, and as many more the first time, when the packages of
events/requirements.txt are installed and diffsol is built.
"""

import argparse
import json
import os
import subprocess
import sys
import venv
from pathlib import Path

from compare import cargo_peer
from write import place

HERE = Path(__file__).resolve().parent
EVENTS = HERE / "events"
PAGE = HERE.parents[1] / "docs" / "compare.md"
FOLDER = EVENTS / ".venv"
PYTHON = FOLDER / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
ACCUMULATION = 3.0
PEERS = ("heyoka", "scipy", "diffrax", "diffsol", "casadi")
FATES = ("both", "one by one", "one lost")
DIPS = ("1e-9", "1e-6", "1e-3")

HEAD = (
    "| integrator | setting | cleared, touched | dips 1e-9, 1e-6, 1e-3 deep "
    "| two at once: both, one by one, one lost | thrown up | down | bounces | derivative |\n"
    "|---|---|---|---|---|---|---|---|---|\n"
)


def install():
    """An environment of its own: one that compares speed needs none of these packages."""
    if not PYTHON.exists():
        venv.create(FOLDER, with_pip=True)
    pip = [PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    subprocess.run([*pip, "-r", EVENTS / "requirements.txt"], check=True)


def answers(name):
    """What a peer reports, a setting after the other."""
    command = [PYTHON, EVENTS / f"{name}_events.py"]
    if name == "diffsol":
        peer = cargo_peer("diffsol events", "diffsol", "events")
        subprocess.run(peer.build, check=True)
        command += peer.command
    print(f"asking {name}", file=sys.stderr)
    done = subprocess.run(command, check=True, capture_output=True, text=True)
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def bounced(answer):
    """How many bounces, and how the motion ends."""
    if isinstance(answer, str):
        return "an error: " + ("`CV_ILL_INPUT`" if "CV_ILL_INPUT" in answer else answer)
    early = ACCUMULATION - answer["last"]
    where = f" {early:.0e} before 3" if early > 1e-12 else ""
    return f"{answer['bounces']}, {answer['end']}{where}"


def row(answer):
    """A line of the table."""
    touching, at_start = answer["touching"], dict(answer["at_start"])
    down = at_start.pop("down")
    cells = (
        answer["tool"],
        answer["setting"],
        f"{touching['cleared']}, {touching['touched']}",
        ", ".join(touching[dip] for dip in DIPS),
        ", ".join(str(answer["together"][fate]) for fate in FATES),
        ", ".join(at_start.values()) if len(set(at_start.values())) > 1 else at_start["1"],
        down,
        bounced(answer["accumulating"]),
        answer["derivative"],
    )
    return "| " + " | ".join(cells) + " |\n"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--only", choices=PEERS, action="append")
    only = arguments.parse_args().only
    install()
    table = HEAD + "".join(row(one) for name in only or PEERS for one in answers(name))
    if only:
        print(table)
    else:
        place(PAGE, "events", table)


if __name__ == "__main__":
    main()
