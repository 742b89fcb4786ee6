"""What `Hoop::digits` claims, against random motions with 60 digits.

    python3 digits.py heavy --motions 1000 --workers 2 --kept heavy.jsonl python3 digits.py heavy
    --motions 120 --write     writes digits-heavy.json, with which the tests of the core compare
    python3 digits.py hard --write                    the same for some of the heavy motions

Draws motions of a kind (`any`, `heavy`, `usual` or `resisted`, as the example `motions` of
littlewood-random has them), and follows their first events with 60 digits. Exact motions are kept
in a file, if one is named, each with its hoop and start: the library draws them, and computes some
of them, such as a start on the limit of friction. A claim of d digits is that the printed number
differs from the exact one by at most 10^-d of that. Printed are, for each decade of the rate at the
start, how many numbers have how many digits more than was claimed: below 0 the claim was too high.

Needs gmpy2, python-flint, cargo, and the packages `follower` and `resistance` beside it.
"""

import argparse
import collections
import json
import math
import multiprocessing
import signal
import subprocess
import sys
from pathlib import Path

from follower.arithmetic import FINEST, Tie, Work
from follower.motion import NUMBERS, follow
from gmpy2 import log10, mpfr
from resistance import motion as resisted
from resistance.balances import Body

HOOP, START = (
    ("mass_ratio", "offset", "inertia", "mu_s", "mu_k"),
    ("theta", "theta_rate", "slip", "gap_rate", "x", "time"),
)
EVENTS, STEPS, SECONDS = 8, 100, 60  # of a motion, of a phase, of a motion
EDGES = (-1, 0, 1, 2, 3)
# Heavy motions that begin with a short arc of rolling, or within rounding of a margin or of the
# limit of friction; and particles near the rim, next to the plane.
HARD = (225, 492, 2243, 2543, 2699, 3231, 7133, 7698)
COARSEST = -6  # decade of rates, for all below it


def library(kind, count):
    """Motions as the library draws and follows them, with its claims."""
    if kind == "hard":
        lines = library("heavy", max(HARD) + 1)
        return {f"heavy {number}": lines[f"heavy {number}"] for number in HARD}
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
        [*cargo, str(count), "2019", kind, str(EVENTS), "digits"],
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parent,
    )
    if run.returncode:
        sys.exit(run.stderr)
    return {f"{kind} {line['number']}": line for line in map(json.loads, run.stdout.splitlines())}


def too_long(*_):
    raise Tie("too long")


def given(line):
    return [line["hoop"], line["start"]]


def followed(hoop, start, bounce):
    """The first transitions."""
    numbers, place = [hoop[k] for k in HOOP], [start[k] for k in START]
    chi, slope = hoop["rolling_resistance"], hoop["slope"]
    if not chi:
        return follow([*numbers, slope], place, 2.0**100, None, bounce, EVENTS)[1]
    resisted.RECORDED = mpfr(0)
    body = Body(*numbers, chi, slope)
    try:
        rows = resisted.follow(body, place[:4], 2.0**100, bounce, EVENTS).transitions
    except Tie as tie:
        rows = tie.transitions
    return [named_as_here(row, start) for row in rows]


def named_as_here(row, start):
    """A transition of the package `resistance` as one of `follower`."""
    state = row.state
    numbers = (start["time"] + row.time, *state[:3], start["x"] + state.x)
    cause = "turning_point" if row.cause == "turning" else row.cause
    return {"cause": cause, **dict(zip(NUMBERS, numbers))}


def exact(named):
    """Name, hoop and start, cause and numbers of the transitions with 60 digits, as text."""
    name, line = named
    hoop, start = line["hoop"], line["start"]
    bounce = (
        None
        if hoop["restitution"] is None
        else (hoop["restitution"], hoop["restitution_law"] or "energetic")
    )
    Work.use(FINEST, STEPS)
    signal.signal(signal.SIGALRM, too_long)
    signal.alarm(SECONDS)
    try:
        transitions = followed(hoop, start, bounce)
    except Tie as tie:
        transitions = tie.transitions
    except (ArithmeticError, ValueError):
        transitions = []
    signal.alarm(0)
    return (
        name,
        given(line),
        [[t["cause"], *("{0:.60g}".format(t[number]) for number in NUMBERS)] for t in transitions],
    )


def exact_motions(lines, workers, path):
    rows = (
        map(json.loads, Path(path).read_text().splitlines()) if path and Path(path).exists() else []
    )
    kept = {
        name: transitions
        for name, problem, transitions in rows
        if name in lines and given(lines[name]) == problem
    }
    todo = [item for item in lines.items() if item[0] not in kept and item[1]["transitions"]]
    with multiprocessing.Pool(workers) as pool:
        for name, problem, transitions in pool.imap_unordered(exact, todo, chunksize=4):
            kept[name] = transitions
            if path:
                with open(path, "a") as file:
                    file.write(json.dumps([name, problem, transitions]) + "\n")
    return kept


def surplus(value, truth, claimed):
    """Digits that a number has beyond those that are claimed."""
    if truth == "inf" or value is None or claimed == 0:
        return None
    truth = mpfr(truth, 240)
    # At rest the exact slip is a root, known to its last digits.
    if value == truth or value == 0 and abs(truth) < 1e-40:
        return 15 - claimed
    return (min(15, -float(log10(abs((value - truth) / truth)))) if truth else 0) - claimed


def compared(ours, theirs):
    """(surplus or None, name, transition) of each number with a claim.

    None is for one whose event is another.
    """
    for k, (it, (cause, *numbers)) in enumerate(zip(ours, theirs)):
        if it["digits"] is None or it["cause"] == "settle":
            return
        # What follows a rest with which the exact motion ends is not known.
        if it["cause"] != cause and not (k + 1 == len(theirs) and cause == "stick"):
            yield None, "event", k
            return
        for name, truth in zip(NUMBERS, numbers):
            found = surplus(it["before"][name], truth, it["digits"][name])
            if found is not None:
                yield found, name, k


def write(kind, lines, motions):
    """The motions that have events, with 25 digits, a line each."""
    rows = []
    for name, line in lines.items():
        if motions.get(name):
            events = [
                [cause, *("{0:.25g}".format(mpfr(text, 240)) for text in numbers)]
                for cause, *numbers in motions[name]
            ]
            rows.append(
                json.dumps({"hoop": line["hoop"], "start": line["start"], "events": events})
            )
    Path(__file__).with_name(f"digits-{kind}.json").write_text("[\n" + ",\n".join(rows) + "\n]\n")


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("kind", choices=("any", "heavy", "usual", "resisted", "hard"))
    parser.add_argument("--motions", type=int, default=1000)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--kept")
    parser.add_argument("--write", action="store_true")
    parser.add_argument(
        "--worst", type=int, default=10, help="how many of the claims that are too high are printed"
    )
    options = parser.parse_args()
    lines = library(options.kind, options.motions)
    exact_ones = exact_motions(lines, options.workers, options.kept)
    if options.write:
        write(options.kind, lines, exact_ones)
    table, over, motions = collections.defaultdict(collections.Counter), [], 0
    for name, theirs in exact_ones.items():
        if name not in lines:
            continue
        motions += bool(theirs)
        rate = abs(lines[name]["start"]["theta_rate"])
        decade = max(math.floor(math.log10(rate)), COARSEST) if rate else COARSEST
        for found, number, k in compared(lines[name]["transitions"], theirs):
            table[decade][
                "another event" if found is None else sum(found >= edge for edge in EDGES)
            ] += 1
            if found is None or found < 0:
                over.append((found, number, k, name))
    columns = (*range(len(EDGES) + 1), "another event")
    titles = [f"< {EDGES[0]}", *(f"≥ {edge}" for edge in EDGES), "event"]
    print(f"{motions} motions")
    for title, rows in [
        ("rate", None),
        *((f"1e{decade:+d}", table[decade]) for decade in sorted(table)),
    ]:
        print(
            f"{title:6}",
            *(
                f"{cell:>7}"
                for cell in (titles if rows is None else (rows[column] for column in columns))
            ),
        )
    for row in sorted(over, key=lambda row: (row[0] is not None, row[0]))[: options.worst]:
        print(*row)


if __name__ == "__main__":
    main()
