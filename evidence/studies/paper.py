"""`python -m evidence.studies.paper FOLDER`: what docs/paper/paper.tex takes from the studies.

Numbers and figures.
"""

from __future__ import annotations

import argparse
import re
from pathlib import Path

from littlewood.plot import look

from .study import load

NUMBERS = {
    "whole": ("one-angle", "whole"),
    "steep": ("one-angle", "steep"),
    "agreement": ("one-angle", "agreement"),
    "near": ("jam", "near"),
    "rolling": ("jam", "rolling"),
    "comsolzone": ("jam", "comsol zone"),
    "orders": ("massless-limit", "orders"),
    "stopped": ("massless-limit", "stopped"),
}
"""Parts of sentences, \\numNAME in the text, by the study and the place of its page."""

TABLES = {"rimbounds": ("jam", "rim bounds")}
"""Tables, \\tabNAME."""

FIGURES = (("one-angle", "law"), ("jam", "hoops"), ("jam", "phase"), ("massless-limit", "system"))
"""Figures, STUDY-NAME.pdf."""

WIDTH_MM = 164.0
"""Of the text."""

SYMBOLS = (
    (r"Î\^⅓", r"$\\hat I^{1/3}$"),
    (r"\bI_zz\b", r"$\\hat I_{zz}$"),
    (r"μ([sk])\b", r"$\\mu_\1$"),
    (r"θ_P\b", r"$\\theta_P$"),
    (r"\b1e-0?(\d+)\b", r"$10^{-\1}$"),
    (r"\b([\d.]+)e-0?(\d+)\b", r"$\1\\cdot10^{-\2}$"),
    (r"(?<![\w.{])-(?=\d)", r"$-$"),
    (r" %", r"\\,\\%"),
)
"""What a page writes in plain letters, and TeX."""


def escaped(text: str) -> str:
    """Return the text of a page for TeX."""
    for pattern, replacement in SYMBOLS:
        text = re.sub(pattern, replacement, text)
    return text


def number(study: str, place: str) -> str:
    """Return the text of a place of a page."""
    content = load(study).texts[place]()
    if not isinstance(content, str):
        raise TypeError(f"{study} has a table at {place}, no part of a sentence")
    return escaped(content)


def tabular(study: str, place: str) -> str:
    """Return a table of a page."""
    head, _, *rows = [
        [cell.strip() for cell in line.strip("|").split("|")] for line in load(study).texts[place]()
    ]
    lines = [" & ".join(map(escaped, cells)) + r" \\" for cells in (head, *rows)]
    body = "\n".join([lines[0], r"\midrule", *lines[1:]])
    return (
        f"\\begin{{tabular}}{{{'r' * len(head)}}}\n\\toprule\n{body}\n\\bottomrule\n"
        f"\\end{{tabular}}"
    )


def main() -> None:
    """Write numbers.tex and the figures."""
    parser = argparse.ArgumentParser(prog="python -m evidence.studies.paper", description=__doc__)
    parser.add_argument("folder", type=Path)
    folder: Path = parser.parse_args().folder
    macros = [f"\\newcommand{{\\num{name}}}{{{number(*place)}}}" for name, place in NUMBERS.items()]
    macros += [
        f"\\newcommand{{\\tab{name}}}{{{tabular(*place)}}}" for name, place in TABLES.items()
    ]
    (folder / "numbers.tex").write_text("\n".join(macros) + "\n", encoding="utf-8")
    for study, name in FIGURES:
        with look(WIDTH_MM):
            load(study).pictures[name]().savefig(
                folder / f"{study}-{name}.pdf", metadata={"CreationDate": None}
            )


if __name__ == "__main__":
    main()
