#!/usr/bin/env python3
"""Installs the peers, runs every benchmark side by side in alternating rounds and prints one table.

python3 evidence/bench/compare.py [--rounds 5] [--quick] [--only NAME]
"""

import argparse
import contextlib
import json
import os
import statistics
import subprocess
import sys
import venv
from fractions import Fraction
from pathlib import Path

HERE = Path(__file__).resolve().parent
PYTHON = HERE / ".venv" / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
BENCHMARKS = ("trajectory", "map", "rolling", "threads")

# Times of stick, slip and lift-off in figure 3 (reference/), and the angles that reference.py
# prints.
FIGURE_3 = ("0.5641075531019967503127", "0.9732230747724054053601", "1.518670213819436998469")
ANGLES = {10: "7.95652637323792101906061003586", 10**6: "849826.504764716712183225172032"}
COUNTS = [9784, 12690, 17526, 0]  # of 200 x 200 starts: at once, later, in contact to 50, failed
STARTS = 200


class Peer:
    """A program that answers one line with one line; `start` returns why it cannot run, or None."""

    def __init__(self, name, *command, build=None, environment=None):
        self.name, self.command, self.build, self.process = name, command, build, None
        self.environment = os.environ | (environment or {})

    def start(self):
        if self.build:
            print(f"building {self.name}", file=sys.stderr)
            built = subprocess.run(self.build, capture_output=True, text=True)
            if built.returncode:
                return last_line(built.stderr)
        self.process = subprocess.Popen(
            list(map(str, self.command)),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
            env=self.environment,
        )
        return None

    def ask(self, benchmark, number=0):
        print(f"{self.name}: {benchmark} {number}", file=sys.stderr)
        try:
            print(benchmark, number, file=self.process.stdin, flush=True)
            answer = self.process.stdout.readline()
        except BrokenPipeError:
            answer = ""
        if not answer:
            raise RuntimeError(
                f"stopped with exit status {self.process.wait()}; see its message above"
            )
        return json.loads(answer)

    def stop(self):
        if self.process:
            with contextlib.suppress(BrokenPipeError):  # it has stopped before
                self.process.stdin.close()
            self.process.wait()


def last_line(text):
    return (text.strip().splitlines() or ["no message"])[-1].replace("|", "/")


def python_peer(name, environment=None):
    return Peer(name, PYTHON, HERE / "peers" / f"{name.lower()}_peer.py", environment=environment)


def cargo_peer(name, folder, binary):
    manifest = HERE / folder / "Cargo.toml"
    target = HERE / folder / "target"  # whatever CARGO_TARGET_DIR says
    build = [
        "cargo",
        "build",
        "--release",
        "--manifest-path",
        str(manifest),
        "--target-dir",
        str(target),
    ]
    suffix = ".exe" if os.name == "nt" else ""
    return Peer(name, target / "release" / (binary + suffix), build=build)


def install():
    """The pinned packages, one by one: one that fails does not take the others with it."""
    if not PYTHON.exists():
        venv.create(HERE / ".venv", with_pip=True)
    for package in (HERE / "requirements.txt").read_text().split():
        print(f"installing {package}", file=sys.stderr)
        subprocess.run(
            [PYTHON, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", package]
        )


def why_missing(name):
    module = name.lower()
    tried = subprocess.run([PYTHON, "-c", f"import {module}"], capture_output=True, text=True)
    return last_line(tried.stderr) if tried.returncode else None


class Table:
    """Measurements by benchmark and tool, over the rounds."""

    def __init__(self):
        self.rows, self.missing, self.conditions = {}, [], ""

    def add(self, section, answers):
        for answer in answers:
            self.rows.setdefault(section, {}).setdefault(answer["name"], []).append(answer)

    def median(self, section, name):
        return statistics.median(answer["seconds"] for answer in self.rows[section][name])


def measure(table, peers, options):
    """One round after the other, and in each one tool after the other."""
    cells = 50 if options.quick else STARTS
    large = 200 if options.quick else 1000
    plan = []
    if "trajectory" in options.only:
        plan += [
            (name, "trajectory", 0, "trajectory")
            for name in ("ours", "heyoka", "SciPy", "numba", "diffsol")
        ]
    if "map" in options.only:
        plan += [
            (name, "map", cells, f"map {cells}") for name in ("ours", "heyoka", "SciPy", "numba")
        ]
        plan += [("ours", "map", large, f"map {large}"), ("ours", "final", large, f"final {large}")]
    if "rolling" in options.only:
        plan += [
            (name, "rolling", until, f"rolling {until}")
            for until in ANGLES
            for name in ("ours", "heyoka")
        ]
    if "threads" in options.only:
        plan += [("ours", "threads", large, f"threads {large}")]
    for turn in range(options.rounds):
        for name, benchmark, number, section in plan:
            if name not in peers or (name == "numba" and benchmark == "map" and turn):
                continue  # numba's map takes a minute: the first round only
            try:
                table.add(section, peers[name].ask(benchmark, number))
            except RuntimeError as error:
                table.missing.append((name, f"{benchmark}: {error}"))
                del peers[name]


def duration(seconds):
    for unit, scale in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= scale:
            return f"{seconds / scale:.3g} {unit}"
    return f"{seconds * 1e9:.3g} ns"


def significant(number):
    return f"{number:.3g}" if number < 1000 else f"{float(f'{number:.3g}'):,.0f}"


def row(section, tool, answers, base, per=1, error="", note=""):
    """One line: the median, the range over the rounds, and the ratio to ours.

    All are for one of `per`.
    """
    seconds = [answer["seconds"] / per for answer in answers]
    median = statistics.median(seconds)
    spread = (
        f"{duration(min(seconds))} to {duration(max(seconds))}" if len(seconds) > 1 else "one round"
    )
    ratio = significant(median / base) if base else "–"
    return f"| {section} | {tool} | {duration(median)} | {spread} | {ratio} | {error} | {note} |"


def trajectory_lines(table):
    rows = table.rows.get("trajectory")
    if not rows:
        return
    base = table.median("trajectory", "Engine")
    given = "order of the phases given"
    notes = {
        "Engine": "prepared; includes the landing; returns slip and lift-off",
        "Hoop::simulate": "nothing prepared; includes the landing and the trajectory itself",
    }
    for name, answers in rows.items():
        found = [
            (t, reference) for t, reference in zip(answers[-1]["times"], FIGURE_3) if t is not None
        ]
        worst = max(
            (abs(float(Fraction(t) - Fraction(reference))) for t, reference in found), default=None
        )
        error = "" if worst is None else f"{worst:.0e}"
        note = notes.get(name, given if name.startswith(("heyoka", "diffsol")) else "")
        yield row("figure 3", name, answers, base if found else None, error=error, note=note)


def map_lines(table):
    for section, rows in table.rows.items():
        kind, _, size = section.partition(" ")
        if kind not in ("map", "final"):
            continue
        cells = int(size)
        ours = rows["Engine"]
        label = f"map, {cells} × {cells}, to " + ("τ = 50" if kind == "map" else "the end")
        base = table.median(section, "Engine") / cells**2
        for name, answers in rows.items():
            last = answers[-1]
            outcomes = last.get("outcomes")
            counts = last.get("counts") or [outcomes.count(code) for code in "0129"]
            per = sum(counts)
            rate = per / statistics.median(answer["seconds"] for answer in answers)
            note = (
                f"{rate:,.0f} starts/s and core; {counts[0]:,} at once, {counts[1]:,} later, "
                f"{counts[2]:,} in contact"
            )
            note += f", {counts[3]:,} failed" if counts[3] else ""
            error = ""
            if name != "Engine":
                expected = ours[-1]["outcomes"]
                if last.get("pick"):
                    expected = "".join(
                        expected[i * cells + j] for i in last["pick"] for j in last["pick"]
                    )
                    note = f"{len(last['pick'])} × {len(last['pick'])} of the starts; " + note
                error = f"{sum(a != b for a, b in zip(outcomes, expected))} cells differ"
            elif cells == STARTS and kind == "map":
                error = "counts as they must be" if counts == COUNTS else f"counts must be {COUNTS}"
            yield row(label, name, answers, base, per, error, note)


def rolling_lines(table):
    for until, angle in ANGLES.items():
        for name, answers in table.rows.get(f"rolling {until}", {}).items():
            base = table.median(f"rolling {until}", "Hoop::simulate, Trajectory::at")
            error = abs(float(Fraction(answers[-1]["theta"]) - Fraction(angle)))
            yield row(f"rolling, state at τ = {until:,}", name, answers, base, error=f"{error:.0e}")


def thread_lines(table):
    for section, rows in table.rows.items():
        if section.startswith("threads"):
            cells = int(section.split()[1])
            one, two = rows["1"], rows["2"]
            shortest = [min(answer["seconds"] for answer in answers) for answers in (one, two)]
            same = all(a["counts"] == b["counts"] for a, b in zip(one, two))
            label, base = f"{cells} × {cells}, to the end", table.median(section, "1")
            yield row(label, "Engine, one thread", one, base)
            note = (
                f"{base / table.median(section, '2'):.2f} times as fast; shortest to shortest "
                f"{shortest[0] / shortest[1]:.2f}"
            )
            yield row(
                label,
                "Engine, two threads",
                two,
                base,
                error="same counts" if same else "counts differ",
                note=note,
            )


def arguments(words=None):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--rounds", type=int, default=5, metavar="N", help="rounds of every benchmark (default 5)"
    )
    parser.add_argument("--quick", action="store_true", help="fewer cells: 50 × 50 and 200 × 200")
    parser.add_argument("--only", choices=BENCHMARKS, help="only this benchmark")
    options = parser.parse_args(words)
    if options.rounds < 1:
        parser.error("at least one round")
    options.only = [options.only] if options.only else BENCHMARKS
    return options


def compared(options):
    """The measurements of this project and of the peers that there are."""
    ours = cargo_peer("ours", "ours", "ours")
    reason = ours.start()
    if reason:
        sys.exit(f"bench/ours does not build: {reason}")
    install()
    table, peers = Table(), {"ours": ours}
    for peer in (
        *map(python_peer, ("heyoka", "SciPy", "numba")),
        cargo_peer("diffsol", "diffsol", "diffsol-peer"),
    ):
        reason = why_missing(peer.name) if peer.build is None else None
        reason = reason or peer.start()
        if reason:
            table.missing.append((peer.name, reason))
        else:
            peers[peer.name] = peer
    started = list(peers.values())
    before = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    measure(table, peers, options)
    for peer in started:
        peer.stop()
    after = os.getloadavg()[0] if hasattr(os, "getloadavg") else float("nan")
    table.conditions = (
        f"Rounds: {options.rounds}; load before the first {before:.2f}, after the last {after:.2f}."
    )
    return table


def shown(table):
    """The table in Markdown."""
    yield "| benchmark | tool | median | over the rounds | to ours | error | remarks |"
    yield "|---|---|---|---|---|---|---|"
    for lines in (trajectory_lines, map_lines, rolling_lines, thread_lines):
        yield from lines(table) if table.rows else ()
    for name, reason in table.missing:
        yield f"| – | {name} | missing | | | | {reason} |"
    yield from ("", table.conditions)


def main():
    print("\n".join(shown(compared(arguments()))))


if __name__ == "__main__":
    main()
