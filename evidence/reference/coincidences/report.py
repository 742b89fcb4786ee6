"""What all comparisons say, and the file with it."""

import json
from pathlib import Path

from .comparison import rounded

LIMIT = 64.0  # units beyond which a number is listed
KEPT = 15  # starts of each family that the file keeps with their numbers


def report(compared):
    """What the file has of each family, what disagrees, and the starts that it keeps."""
    families, different, kept = {}, [], []
    for name in dict.fromkeys(c.family for c in compared):
        mine = [c for c in compared if c.family == name]
        worst = max(mine, key=lambda c: c.worst[0])
        every = sorted(e for c in mine for e, _, _ in c.errors)
        families[name] = dict(
            starts=len(mine),
            transitions=sum(len(c.motion[1]) for c in mine),
            undecided=sum(not c.decided for c in mine),
            another_sequence_of_an_undecided_start=sum(c.possible and not c.same for c in mine),
            numbers=len(every),
            median=rounded(every[len(every) // 2]) if every else None,
            above_8=sum(e > 8 for e in every),
            largest=rounded(worst.worst[0]),
            largest_at=dict(worst.described(), number=worst.worst[1], transition=worst.worst[2]),
        )
        for c in mine:
            if not c.possible:
                different.append(
                    dict(
                        c.described(),
                        kind="sequence",
                        library=listed(c.answer),
                        exact=listed(c.motion),
                    )
                )
            elif c.worst[0] > LIMIT:
                different.append(
                    dict(
                        c.described(),
                        kind="number",
                        number=c.worst[1],
                        transition=c.worst[2],
                        units=rounded(c.worst[0]),
                    )
                )
        kept += [c.kept() for c in mine if c.errors and c.motion[1]][:KEPT]
    return families, different, kept


def listed(motion):
    """A motion in words."""
    return (
        [f"{motion[0][0]} {motion[0][1]}"]
        + [f"{t['cause']} {t['to']} {t['direction']} {float(t['time'])!r}" for t in motion[1]]
        + [str(motion[2])]
    )


def write(starts, families, different, kept):
    """The file, with a line for each start that it keeps."""
    top = dict(
        made_by="coincidences",
        starts=starts,
        limit=LIMIT,
        families=families,
        disagreements=different,
    )
    lines = ",\n".join("  " + json.dumps(item, separators=(",", ":")) for item in kept)
    text = json.dumps(top, indent=1)[:-2] + ',\n "kept": [\n' + lines + "\n ]\n}\n"
    Path(__file__).parent.with_suffix(".json").write_text(text, encoding="ascii")
