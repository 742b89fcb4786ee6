#!/usr/bin/env python3
"""Measures the speed, and writes it into the pages that state it, between markers in them.

    python3 evidence/bench/write.py [--only compare|regimes|ablation] [--quick]

Ten minutes on an idle machine, and more the first time, when the peers are installed and built.
"""

import argparse
import os
import platform
import re
import subprocess
from datetime import UTC, datetime
from pathlib import Path

import compare
import regimes
import tomllib

ROOT = Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
ENGINE = ROOT / "docs/engine.md"
BENCH = ROOT / "evidence/bench/README.md"


def place(page, name, text):
    """Replaces the text between the two markers of a name, which stand on lines of their own."""
    whole = page.read_text(encoding="utf-8")
    before, start, rest = whole.partition(f"<!-- {name} -->\n")
    _, end, after = rest.partition(f"<!-- /{name} -->")
    if not (start and end):
        raise SystemExit(f"{page} has no markers of {name}")
    page.write_text(f"{before}{start}{text.strip()}\n{end}{after}", encoding="utf-8")


def output(*command):
    done = subprocess.run(command, cwd=ROOT, check=True, stdout=subprocess.PIPE, text=True)
    return done.stdout.strip()


def conditions():
    """Of what, on what and when."""
    manifest = tomllib.loads((ROOT / "Cargo.toml").read_text(encoding="utf-8"))
    version = manifest["workspace"]["package"]["version"]
    commit = output("git", "rev-parse", "--short=8", "HEAD")
    information = Path("/proc/cpuinfo")
    names = re.findall(
        "model name\\s*: (.*)", information.read_text() if information.exists() else ""
    )
    processor = names[0] if names else platform.processor() or platform.machine()
    today = datetime.now(UTC).date()
    return f"Version {version} ({commit}), {processor}, {os.cpu_count()} cores, {today}."


def times(ratio):
    """A ratio as a sentence has it: two digits."""
    return f"{float(f'{ratio:.2g}'):,.3g}" if ratio < 1000 else f"{float(f'{ratio:.2g}'):,.0f}"


def write_compare(is_quick):
    words = ["--rounds", "1", "--quick"] if is_quick else ["--rounds", "3"]
    table = compare.compared(compare.arguments(words))
    place(BENCH, "compare", "\n".join([conditions(), "", *compare.shown(table)]))

    def ratio(section, name):
        return times(table.median(section, name) / table.median(section, "Engine"))

    figure_3 = "trajectory"
    # The smaller of the maps, which the peers compute, too.
    plane = next(section for section in table.rows if section.startswith("map"))
    heyoka, heyoka_map = (f"heyoka, fast_math, tol {tolerance}" for tolerance in ("1e-12", "1e-9"))
    if heyoka in table.rows[figure_3]:
        place(
            README,
            "speed",
            "A summary of the motion of Figure 3 takes "
            f"{compare.duration(table.median(figure_3, 'Engine'))}; heyoka, the fastest general "
            f"integrator that we measured, takes {ratio(figure_3, heyoka)} times as long, and "
            f"{ratio(plane, heyoka_map)} times for a map of outcomes "
            "([benchmarks](evidence/bench/README.md)).",
        )
    place(
        ENGINE,
        "speed",
        f"{ratio(figure_3, 'Hoop::simulate')} times for Figure 3, and "
        f"{ratio(plane, 'Hoop::simulate')} times "
        "for a map of the plane of Figure 2 to τ = 50 ([benchmarks](../evidence/bench/README.md)).",
    )


def write_regimes(is_quick):
    seconds = "0.2" if is_quick else "1"
    options = regimes.arguments(["--rounds", "1", "--seconds", seconds])
    records = regimes.measured(options)
    place(BENCH, "regimes", "\n".join([conditions(), "", *regimes.shown(records, options.rounds)]))


def write_ablation(_):
    bench = ["cargo", "bench", "--quiet", "--locked", "-p", "littlewood", "--features", "ablation"]
    place(ENGINE, "ablation", "\n\n".join([conditions(), output(*bench, "--bench", "ablation")]))


WRITERS = {"compare": write_compare, "regimes": write_regimes, "ablation": write_ablation}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", choices=WRITERS, help="only this part of the pages")
    parser.add_argument("--quick", action="store_true", help="a trial, with smaller maps")
    options = parser.parse_args()
    for name, write in WRITERS.items():
        if options.only in (None, name):
            write(options.quick)


if __name__ == "__main__":
    main()
