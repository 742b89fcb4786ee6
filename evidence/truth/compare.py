"""Compares the library's doubles with the certificates, and writes the table of docs/truth.md.

python3 compare.py
"""

from __future__ import annotations

import json
import statistics
import sys
from pathlib import Path

from littlewood.certify.compare import OtherSequence, differences

HERE = Path(__file__).parent
PAGE = HERE.parents[1] / "docs" / "truth.md"
BEGIN, END = "<!-- ulps -->\n", "<!-- /ulps -->"


def main() -> int:
    """Compare all motions, and put the table in its place."""
    motions: dict[str, int] = {}
    numbers: dict[str, list[float]] = {}
    others = 0
    for path in sorted((HERE / "certificates").glob("*.json")):
        certificate = json.loads(path.read_text(encoding="utf-8"))
        family = certificate["case"]["family"]
        found = numbers.setdefault(family, [])
        if not certificate["certified"]:
            continue
        motions[family] = motions.get(family, 0) + 1
        try:
            found += [one.ulps for one in differences(certificate)]
        except OtherSequence as other:
            others += 1
            print(f"{path.stem}: {other}")
    rows = [
        "| family | certified | numbers compared | median | 99 in 100 below | largest |",
        "|---|---|---|---|---|---|",
    ]
    for family, found in sorted(numbers.items()):
        if found:
            upper = sorted(found)[(99 * len(found)) // 100]
            cells = f"{statistics.median(found):.2g} | {upper:.2g} | {max(found):.2g}"
        else:
            cells = "| |"
        rows.append(f"| {family} | {motions.get(family, 0)} | {len(found)} | {cells} |")
    text = PAGE.read_text(encoding="utf-8")
    before, after = text.index(BEGIN) + len(BEGIN), text.index(END)
    PAGE.write_text(text[:before] + "\n".join(rows) + "\n" + text[after:], encoding="utf-8")
    print(f"{sum(motions.values())} motions, {others} with another sequence")
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main())
