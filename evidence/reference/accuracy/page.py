"""Table and numbers of docs/accuracy.md, from accuracy.json alone."""

import hashlib
import json
from pathlib import Path

HERE = Path(__file__).parents[1]
DATA = HERE / "accuracy.json"
PAGE = HERE.parents[1] / "docs" / "accuracy.md"
PICTURE = HERE.parents[1] / "docs" / "accuracy.svg"

NAMES = {
    "all": "all but the last row",
    "ordinary": "ordinary: start ≤ 10, 10⁻³ ≤ Î ≤ 10³, 10⁻³ ≤ μs ≤ 10",
    "fast": "fast: \\|θ′\\| > 10",
    "far": "far: \\|θ\\| > 10",
    "light": "light: Î < 10⁻³",
    "slippery": "slippery: μs < 10⁻³",
    "rough": "rough: μs > 10",
    "bouncing": "with restitution",
    "vanishing": "a number between 0 and 10⁻¹⁰⁰",
}


def content():
    """The content of the file."""
    return json.loads(DATA.read_text(encoding="utf-8"))


def short(value):
    """Two digits, as the page has them."""
    if value == "inf":
        return "∞"
    if 0.01 <= value < 1000:
        return f"{value:.2g}" if value < 100 else f"{value:.0f}"
    mantissa, power = f"{value:.1e}".split("e")
    return f"{mantissa} · 10{''.join('⁰¹²³⁴⁵⁶⁷⁸⁹'[int(d)] for d in str(abs(int(power))))}".replace(
        "10", "10⁻" if value < 1 else "10", 1
    )


def filled(text, data):
    """The page with its places filled: between a mark and its end."""
    rows = [
        "| part of the range | numbers | error: median, 99 %, largest | conditioning | error / "
        "conditioning | above 8 |",
        "|---|---|---|---|---|---|",
    ]
    for part, row in data["parts"].items():
        rows.append(
            " | ".join(
                [
                    f"| {NAMES[part]}",
                    f"{row['numbers']:,}",
                    *(", ".join(map(short, row[k])) for k in ("error", "conditioning", "lost")),
                    f"{100 * row['above_8']:.2g} %",
                ]
            )
            + " |"
        )
    ordinary, every = data["parts"]["ordinary"], data["parts"]["all"]
    places = {
        "parts": "\n" + "\n".join(rows) + "\n",
        "motions": f"{data['motions']:,}",
        "numbers": f"{data['numbers']:,}",
        "events": f"{data['events']:,}",
        "others": f"{data['other_sequences']:,}",
        "ordinary-others": f"{data['other_sequences_of_ordinary']:,}",
        "median": short(ordinary["lost"][0]),
        "ordinary-most": short(ordinary["lost"][1]),
        "ordinary-largest": short(ordinary["lost"][2]),
        "share": f"{100 * (1 - every['above_8']):.1f} %",
        "largest": short(every["lost"][2]),
    }
    for label, new in places.items():
        begin, end = f"<!-- {label} -->", f"<!-- /{label} -->"
        if text.count(begin) != 1 or text.count(end) != 1:
            raise ValueError(f"the page must have the place {begin} once")
        before, rest = text.split(begin)
        text = before + begin + new + end + rest.split(end)[1]
    return text


def fingerprint(data):
    """Of what the picture shows; the picture carries it."""
    return hashlib.sha256(json.dumps(data["against"]).encode()).hexdigest()
