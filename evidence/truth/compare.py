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


def table() -> tuple[list[str], list[str]]:
    """The table, and the motions that have another sequence."""
    motions: dict[str, int] = {}
    numbers: dict[str, list[float]] = {}
    others = []
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
            others.append(f"{path.stem}: {other}")
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
    return rows, others


def filled(text: str, rows: list[str]) -> str:
    """The page with the table in its place."""
    before, after = text.index(BEGIN) + len(BEGIN), text.index(END)
    return text[:before] + "\n".join(rows) + "\n" + text[after:]


def main() -> int:
    """Compare all motions, and put the table in its place."""
    rows, others = table()
    PAGE.write_text(filled(PAGE.read_text(encoding="utf-8"), rows), encoding="utf-8")
    print("\n".join([*others, f"{len(others)} motions with another sequence"]))
    return 1 if others else 0


if __name__ == "__main__":
    sys.exit(main())
