"""The picture of docs/accuracy.md."""

import sys
from pathlib import Path

import matplotlib as mpl
from littlewood.plot.sheet import listed, panels
from littlewood.style import LINE

from .page import PAGE, PICTURE, fingerprint

sys.path.insert(0, str(Path(__file__).parents[3]))

from evidence.studies.pictures import write

QUANTITIES = {
    "theta_rate": "|*θ*′| at the start",
    "theta": "|*θ*| at the start",
    "inertia": "*Î*",
    "mu_s": "*μ*ₛ",
    "events": "number of the event",
}


def edges(rows):
    """Edges of neighbouring bins."""
    return [row["low"] for row in rows] + [rows[-1]["high"]]


def draw(data):
    """Errors against each quantity: median, 99 % and largest.

    Beside them is what conditioning alone gives in 99 %.
    """
    figure, axes = panels(len(QUANTITIES), height=240, sharey=True)
    figure.set_gid(fingerprint(data))
    looks = [{"label": label, **look} for label, look in listed(("median", "99 %", "largest"))]
    top = max(row["error"][2] for rows in data["against"].values() for row in rows)
    for one, (quantity, label) in zip(axes, QUANTITIES.items()):
        rows = data["against"][quantity]
        # A bin without numbers leaves a gap.
        runs = [[rows[0]]]
        for row in rows[1:]:
            if row["low"] == runs[-1][-1]["high"]:
                runs[-1].append(row)
            else:
                runs.append([row])
        for run in runs:
            one.stairs(
                [row["conditioning"][1] for row in run],
                edges(run),
                baseline=0.01,
                fill=True,
                color=LINE,
                alpha=0.6,
                linewidth=0,
            )
            for k, look in enumerate(looks):
                one.stairs(
                    [max(row["error"][k], 0.01) for row in run], edges(run), baseline=None, **look
                )
        one.set(
            yscale="log",
            ylim=(0.05, 3 * top),
            xlim=(rows[0]["low"], rows[-1]["high"]),
            xlabel=label,
        )
        if quantity != "events":
            one.set_xscale("log")
    handles = [mpl.lines.Line2D([], [], **look) for look in looks]
    handles.append(
        mpl.patches.Patch(color=LINE, alpha=0.6, linewidth=0, label="conditioning, 99 %")
    )
    heading = "error of a printed number, in units of its last place"
    figure.legend(
        handles=handles, title=heading, loc="outside upper left", ncols=4, alignment="left"
    )
    return figure


def save(data):
    """The picture as a file that depends on the data alone."""
    write(lambda: draw(data), PICTURE, PAGE)
