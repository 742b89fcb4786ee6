"""Holds the scores that evidence/engines/test.sh has made against what each engine must reach, and fails if one does not."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

COARSE, FINE = 4e-3, 1e-3

LARGEST = {
    ("scipy", "default"): 3e-2,
    ("scipy", "careful"): 1e-10,
    ("moreau", "default"): 1e-2,
    ("pymunk", "default"): 1e-2,
    ("pymunk", "careful"): 1e-2,
}
"""Largest error of x, y and theta at the fine step."""

FIRST_ORDER = ("moreau", "pymunk")
"""Engines whose errors fall with the step."""

ONE_COEFFICIENT = ("moreau", "pymunk")


def wrong(engines: dict[str, Any]) -> list[str]:
    """What is not as expected."""
    found = []
    runs = {(name, run["setting"], run["case"], run["step"]): run for name in engines for run in engines[name]["runs"]}
    for (name, setting, case, step), run in runs.items():
        label = f"{name}, {setting}, {case}, step {step:g}"
        status = "refused" if case == "two-coefficients" and name in ONE_COEFFICIENT else "scored"
        if run["status"] != status:
            found.append(f"{label}: {run['status']}, not {status}: {run.get('reason')}")
        elif status == "scored" and step == FINE and (name, setting) in LARGEST:
            error, bound = run["largest_error"]["state"], LARGEST[name, setting]
            if error > bound:
                found.append(f"{label}: largest error {error:.1e} is above {bound:.1e}")
            if run["missed"]:
                found.append(f"{label}: missed {run['missed']} events")
    for name in FIRST_ORDER:
        coarse, fine = (runs[name, "default", "figure-3", step]["largest_error"]["state"] for step in (COARSE, FINE))
        if not 2.0 < coarse / fine < 8.0:
            found.append(f"{name}: a step four times as small makes the error {coarse / fine:.1f} times as small")
    expected = {"scipy", *FIRST_ORDER}
    if expected - engines.keys():
        found.append(f"not run: {', '.join(sorted(expected - engines.keys()))}")
    return found


def main() -> int:
    """Say what is wrong."""
    found = wrong(json.loads(Path(sys.argv[1]).read_text(encoding="utf-8"))["engines"])
    for line in found:
        print(line, file=sys.stderr)
    print(f"{len(found)} of the scores are not as expected")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
