#!/usr/bin/env python3
"""How fast each kind of motion is: `littlewood map` and a peer on the same starts, in one run.

    python3 evidence/bench/regimes.py [--rounds 3] [--seconds 2] [--only WORD] [--json FILE]
    python3 evidence/bench/regimes.py --random 150 [--seed 1] [--seconds 1]

Ours follows a grid of starts on one thread, to the end of each motion and to tau = 50, as large a
grid as it takes to keep it busy for so many seconds, up to 300 x 300. The peer, heyoka or else
SciPy, follows starts picked from that grid to tau = 50, as many as it manages in the same time.
Time is that of the processor, so that other work on the machine counts little: ours without what a
map of four starts takes, the peer's without compiling. The fastest of the rounds counts. Regimes
that the peers have no equations for (the massless hoop, impacts, the balanced hoop, whose normal
force heyoka refuses because it is constant) and those in which each point is another hoop, which a
peer would have to compile, have none.

With --random hoops are drawn instead, of ordinary proportions, with friction from 0.03 to 2 and
kinetic coefficients that are less, nearly as large, or as large; ours alone, once each, and the
slowest are listed: regimes that nobody thought of.
"""

import argparse
import json
import math
import os
import random
import resource
import subprocess
import sys
import tempfile
from dataclasses import dataclass, field
from pathlib import Path

from compare import HERE, install, python_peer, significant, why_missing

ROOT = HERE.parents[1]
LARGEST, SMALLEST = 300, 17  # starts along an axis; so many that a hoop is prepared
UNTIL = 50.0
PEER_STARTS = 400
FLAGSHIP = "figure 2"
AT_ONCE, LATER, IN_CONTACT = 0, 1, 2  # as in peers/physics.py
STAYS = ("rolls_forever", "repeats_forever", "slips_forever", "in_contact")
PLACES = {"leaves_at_once": AT_ONCE, "lifts_off_later": LATER, **dict.fromkeys(STAYS, IN_CONTACT)}


@dataclass
class Regime:
    """A plane of starts over a hoop, as flags of the command line."""

    name: str
    hoop: dict = field(default_factory=dict)
    start: dict = field(default_factory=dict)
    x: tuple = ("theta", -math.pi, math.pi)
    y: tuple = ("theta_rate", -4.0, 4.0)
    has_peer: bool = True

    def quantities(self):
        hoop = {"mass_ratio": 1.0, "offset": 1.0, "inertia": 1.0, "mu_s": 0.5, "mu_k": 0.4}
        return {
            **hoop,
            "theta": math.pi / 2,
            "theta_rate": 2.0,
            "slip": 0.0,
            **self.hoop,
            **self.start,
        }

    def flags(self):
        varied = {self.x[0], self.y[0]}
        given = {name: value for name, value in self.quantities().items() if name not in varied}
        return [f"--{name.replace('_', '-')}={value!r}" for name, value in given.items()]


def friction(mu_s, mu_k):
    return {"mu_s": mu_s, "mu_k": mu_k}


REGIMES = [
    Regime(FLAGSHIP),
    Regime(
        "massless",
        {"mass_ratio": 0.0, "inertia": 0.0, **friction(0.5, 0.5)},
        y=("theta_rate", -2.0, 2.0),
        has_peer=False,
    ),
    Regime("theta against slip", y=("slip", -2.0, 2.0)),
    Regime("no friction", friction(0.0, 0.0)),
    Regime(
        "axes mu_s and mass_ratio", x=("mu_s", 0.4, 2.0), y=("mass_ratio", 0.0, 5.0), has_peer=False
    ),
    Regime(
        "axes offset and inertia", x=("offset", 0.05, 1.0), y=("inertia", 0.05, 3.0), has_peer=False
    ),
    Regime("mu_k = 0.4999", friction(0.5, 0.4999)),
    Regime("mu_k = 0.499", friction(0.5, 0.499)),
    Regime(
        "mu_k = 0.1999, slow slips", {"mass_ratio": 2.0, "inertia": 0.5, **friction(0.2, 0.1999)}
    ),
    Regime("P <= 0 somewhere", {"mass_ratio": 0.2, "inertia": 0.1, **friction(1.5, 1.4)}),
    Regime("mu_s = mu_k = 0.5", friction(0.5, 0.5)),
    Regime("painleve", {"mass_ratio": 1 / 3, "inertia": 1 / 3, **friction(1.0, 1.0)}),
    Regime("mu_k = 0", friction(0.5, 0.0)),
    Regime("mu = 1e-3, slip 1", friction(1e-3, 1e-3), {"slip": 1.0}),
    Regime("inertia 0.001", {"mass_ratio": 0.0, "inertia": 0.001}),
    Regime(
        "inertia 0.001, mu_s = mu_k", {"mass_ratio": 0.0, "inertia": 0.001, **friction(0.5, 0.5)}
    ),
    Regime("mu = 1e-6, slip 1", friction(1e-6, 1e-6), {"slip": 1.0}),
    Regime("light, mass_ratio 0.01", {"mass_ratio": 0.01, "inertia": 0.01}),
    Regime("balanced, offset 0", {"offset": 0.0}, {"slip": 1.0}, has_peer=False),
    Regime("rough, mu_s = mu_k = 100", friction(100.0, 100.0)),
    Regime("fast, |theta'| to 100", y=("theta_rate", -100.0, 100.0)),
    Regime("restitution 0", {"restitution": 0.0}, has_peer=False),
    Regime("restitution 0.5", {"restitution": 0.5}, has_peer=False),
    Regime("restitution 1", {"restitution": 1.0}, has_peer=False),
    *(
        Regime(f"slope of {slope}", {"slope": slope}, has_peer=False)
        for slope in (0.001, 0.01, 0.1, 1.0)
    ),
]


def processor_time():
    """Of the programs that have been run."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run(program, words):
    """The report, and the processor time that it took."""
    before = processor_time()
    done = subprocess.run(
        [program, *words, "--threads=1", "--format=json"], capture_output=True, text=True
    )
    if done.returncode:
        sys.exit(f"littlewood {' '.join(words)}\n{done.stderr}")
    return json.loads(done.stdout), processor_time() - before


def mapped(program, regime, cells, limits):
    axes = [
        f"--{side}={name}={low!r}:{high!r}:{cells}"
        for side, (name, low, high) in (("x", regime.x), ("y", regime.y))
    ]
    with tempfile.TemporaryDirectory() as folder:
        # A store, for a picture would follow many more starts along the boundaries of its regions.
        return run(program, ["map", *regime.flags(), *axes, *limits, f"--out={folder}/map.zarr"])


def ours(program, regime, limits, seconds):
    """A grid that keeps the program busy for a while, its report, and starts per second."""
    _, idle = mapped(program, REGIMES[0], 2, limits)
    cells = SMALLEST
    while True:
        report, took = mapped(program, regime, cells, limits)
        took = max(took - idle, 1e-3)
        if took > 0.5 * seconds or cells == LARGEST:
            return cells, report, cells**2 / took
        cells = min(LARGEST, max(cells + 1, math.floor(cells * math.sqrt(0.8 * seconds / took))))


def picked(regime, cells):
    """Angle, rate and slip of some starts of the grid, in an order that mixes them."""

    def value(axis, i):
        return axis[1] + (axis[2] - axis[1]) * i / (cells - 1)

    places = [(i, j) for i in range(cells) for j in range(cells)]
    random.Random(2019).shuffle(places)
    for i, j in places[:PEER_STARTS]:
        at = {
            **regime.quantities(),
            regime.x[0]: value(regime.x, i),
            regime.y[0]: value(regime.y, j),
        }
        yield at["theta"], at["theta_rate"], at["slip"]


def write_list(path, starts):
    rows = [",".join(map(repr, start)) for start in starts]
    path.write_text("\n".join(["theta,theta_rate,slip", *rows]) + "\n")


def peer_of(names, regime, cells, seconds):
    """What the first peer that there is makes of starts of the grid.

    Its answer, and the starts that it has followed.
    """
    hoop = regime.quantities()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "starts.csv"
        starts = list(picked(regime, cells))
        write_list(path, starts)
        environment = {
            "LITTLEWOOD_HOOP": " ".join(
                repr(hoop[name]) for name in ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
            ),
            "LITTLEWOOD_STARTS": str(path),
        }
        peer = python_peer(names[0], environment)
        reason = peer.start()
        if reason:
            sys.exit(f"{peer.name}: {reason}")
        try:
            answer = peer.ask("regime", max(1, round(seconds)))
        finally:
            peer.stop()
        return answer, starts[: len(answer["outcomes"])]


def same_starts(program, regime, starts):
    """Ours of the starts that the peer has followed: counts as the peer has them."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "starts.csv"
        write_list(path, starts)
        words = [
            "sweep",
            *regime.flags(),
            f"--until={UNTIL}",
            f"--starts={path}",
            f"--out={folder}/motions.parquet",
        ]
        counts = run(program, words)[0]["counts"]
    found = [0, 0, 0, 0]
    for name, count in counts.items():
        found[PLACES.get(name, 3)] += count
    return found


class Row:
    """The measurements of a regime, over the rounds."""

    def __init__(self, regime):
        self.regime, self.rates, self.peer, self.counts, self.cells, self.classes = (
            regime,
            {},
            None,
            None,
            None,
            None,
        )

    def measure(self, program, peers, seconds):
        for key, limits in (("end", []), ("limit", [f"--until={UNTIL}"])):
            cells, report, rate = ours(program, self.regime, limits, seconds)
            self.rates[key] = max(self.rates.get(key, 0.0), rate)
            if key == "end":
                self.cells, self.classes = cells, report["counts"]
        if not (peers and self.regime.has_peer):
            return
        answer, starts = peer_of(peers, self.regime, self.cells, seconds)
        rate = len(answer["seconds"]) / sum(answer["seconds"])
        self.peer = answer["name"], max(rate, self.peer[1] if self.peer else 0.0)
        theirs = [answer["outcomes"].count(code) for code in (AT_ONCE, LATER, IN_CONTACT)]
        theirs.append(len(starts) - sum(theirs))
        self.counts = {"ours": same_starts(program, self.regime, starts), "peer": theirs}

    def record(self, flagship):
        record = {
            "regime": self.regime.name,
            "flags": self.regime.flags(),
            "axes": [list(self.regime.x), list(self.regime.y)],
            "cells": self.cells,
            "classes": self.classes,
            "starts_per_second": self.rates["end"],
            "of_the_flagship": self.rates["end"] / flagship,
            "starts_per_second_to_50": self.rates["limit"],
        }
        if self.peer:
            name, rate = self.peer
            record |= {
                "peer": name,
                "peer_starts_per_second": rate,
                "to_the_peer": self.rates["limit"] / rate,
            }
            record["counts"] = self.counts
        return record


def line(record):
    cells = [
        record["regime"].replace("|", "\\|"),
        f"{record['cells']} × {record['cells']}",
        significant(record["starts_per_second"]),
        f"1/{significant(1.0 / record['of_the_flagship'])}",
        significant(record["starts_per_second_to_50"]),
    ]
    if "peer" not in record:
        return f"| {' | '.join(cells)} | – | – | |"
    mine, theirs = record["counts"]["ours"], record["counts"]["peer"]
    note = (
        f"{sum(theirs)} starts, same counts"
        if mine == theirs
        else f"{sum(theirs)} starts, {mine} and {theirs}"
    )
    rate, ratio = significant(record["peer_starts_per_second"]), significant(record["to_the_peer"])
    return f"| {' | '.join(cells)} | {rate} | {ratio} | {note} |"


def drawn(source, number):
    """A hoop of ordinary proportions, with friction that is neither next to none nor huge."""

    def spread(low, high):
        return low * (high / low) ** source.random()

    mass_ratio = spread(0.03, 3.0)
    inertia = mass_ratio * source.uniform(0.1, 1.0) + (
        spread(0.01, 1.0) if source.random() < 0.2 else 0.0
    )
    mu_s = spread(0.03, 2.0)
    mu_k = mu_s * source.choice(
        [1.0, 1.0 - spread(1e-5, 0.1), source.uniform(0.2, 1.0), source.uniform(0.2, 1.0)]
    )
    hoop = {
        "mass_ratio": mass_ratio,
        "offset": source.uniform(0.1, 1.0),
        "inertia": inertia,
        **friction(mu_s, mu_k),
    }
    return Regime(
        f"hoop {number}",
        {name: float(f"{value:.5g}") for name, value in hoop.items()},
        has_peer=False,
    )


def census(program, count, seed, seconds):
    """Starts per second of random hoops: the slowest, and the quantiles."""
    source = random.Random(seed)
    found = []
    for number in range(1, count + 1):
        regime = drawn(source, number)
        cells, _, rate = ours(program, regime, [], seconds)
        found.append((rate, cells, regime))
        print(f"{regime.name} of {count}: {significant(rate)}", file=sys.stderr, flush=True)
    found.sort(key=lambda one: one[0])
    print("| starts/s | grid | hoop |")
    print("|---|---|---|")
    for rate, cells, regime in found[:20]:
        print(
            f"| {significant(rate)} | {cells} × {cells} | "
            f"{', '.join(f'{name} {value:g}' for name, value in regime.hoop.items())} |"
        )
    at = [found[min(count - 1, math.floor(part * count))][0] for part in (0.05, 0.25, 0.5, 0.75)]
    print(
        f"\n{count} hoops, seed {seed}; starts a second at 5, 25, 50, 75 %: "
        f"{', '.join(map(significant, at))}."
    )


def arguments(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--rounds", type=int, default=3, metavar="N", help="rounds of every regime (default 3)"
    )
    parser.add_argument(
        "--seconds", type=float, default=2.0, metavar="S", help="time for a measurement (default 2)"
    )
    parser.add_argument(
        "--only", metavar="WORD", help="regimes with this word in their names, and the flagship"
    )
    parser.add_argument(
        "--random",
        type=int,
        metavar="COUNT",
        help="so many random hoops, and which are the slowest",
    )
    parser.add_argument(
        "--seed", type=int, default=1, metavar="N", help="of the random hoops (default 1)"
    )
    parser.add_argument(
        "--json", type=Path, metavar="FILE", help="write the numbers to this file, too"
    )
    return parser.parse_args(words)


def built():
    """The program: that of LITTLEWOOD, or what the sources make."""
    if program := os.environ.get("LITTLEWOOD"):
        return program
    manifest = str(ROOT / "Cargo.toml")
    build = [
        "cargo",
        "build",
        "--release",
        "--locked",
        "--manifest-path",
        manifest,
        "--package",
        "littlewood-cli",
        "--features",
        "sweep",
    ]
    if subprocess.run(build).returncode:
        sys.exit("the program does not build")
    return Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target")) / "release" / "littlewood"


def measured(options):
    """What is known of each regime."""
    program = built()
    install()
    peers = [name for name in ("heyoka", "SciPy") if why_missing(name) is None]
    rows = [
        Row(regime)
        for regime in REGIMES
        if options.only is None or options.only in regime.name or regime.name == FLAGSHIP
    ]
    for turn in range(options.rounds):
        for row in rows:
            print(f"round {turn + 1}: {row.regime.name}", file=sys.stderr)
            row.measure(program, peers, options.seconds)
            print(row.rates, row.peer, row.counts, file=sys.stderr, flush=True)
    flagship = rows[0].rates["end"]
    return [row.record(flagship) for row in rows]


def shown(records, rounds):
    """The table in Markdown."""
    peer = next((record["peer"] for record in records if "peer" in record), "no peer")
    yield (
        f"| regime | grid | starts/s | of the flagship | starts/s to τ = 50 | {peer} | ratio | at "
        "once, later, in contact, else |"
    )
    yield "|---|---|---|---|---|---|---|---|"
    yield from map(line, records)
    load = f", load {os.getloadavg()[0]:.2f}" if hasattr(os, "getloadavg") else ""
    yield ""
    yield (
        f"Rounds: {rounds}, of which the fastest counts; one core of {os.cpu_count()}{load}; each "
        "start to the end of its motion unless said."
    )


def main():
    options = arguments()
    if options.random is not None:
        return census(built(), options.random, options.seed, options.seconds)
    records = measured(options)
    print("\n".join(shown(records, options.rounds)))
    if options.json:
        options.json.write_text(json.dumps(records, indent=2) + "\n")


if __name__ == "__main__":
    main()
