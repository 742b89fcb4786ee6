"""The picture of docs/accuracy.md."""

import matplotlib as mpl
from littlewood.style import ACCENTS, FAINT, INK, LINE, PAPER
from matplotlib.figure import Figure

from .page import PICTURE, fingerprint

QUANTITIES = {
    "theta_rate": "|θ′| at the start",
    "theta": "|θ| at the start",
    "inertia": "Î",
    "mu_s": "μs",
    "events": "number of the event",
}

TITLE = "Errors of printed numbers against the rate, the angle, the inertia, the friction and the number of the event"


def edges(rows):
    """Edges of neighbouring bins."""
    return [row["low"] for row in rows] + [rows[-1]["high"]]


def draw(data):
    """Errors against each quantity: median, 99 % and largest, and what conditioning alone gives in 99 %."""
    mpl.rcParams["svg.hashsalt"] = "littlewood"
    figure = Figure(figsize=(6.6, 7.6), layout="constrained", facecolor=PAPER)
    axes = figure.subplots(3, 2, sharey=True).flat
    violet, teal = ACCENTS["violet"], ACCENTS["teal"]
    styles = (("median", violet, "solid", 1.6), ("99 %", teal, (0, (5, 1.5)), 1.6), ("largest", INK, (0, (1, 1.2)), 1.6))
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
            one.stairs([row["conditioning"][1] for row in run], edges(run), baseline=0.01, fill=True, color=FAINT, alpha=0.6, linewidth=0)
            for k, (_, colour, dashes, width) in enumerate(styles):
                one.stairs(
                    [max(row["error"][k], 0.01) for row in run], edges(run), baseline=None, color=colour, linestyle=dashes, linewidth=width
                )
        one.set_yscale("log")
        one.set_ylim(0.05, 3 * top)
        if quantity != "events":
            one.set_xscale("log")
        one.set_xlim(rows[0]["low"], rows[-1]["high"])
        one.set_xlabel(label, fontsize=12, color=INK)
        one.set_facecolor(PAPER)
        one.grid(color=LINE, linewidth=0.4, alpha=0.5)
        one.tick_params(colors=INK, labelsize=11)
        for spine in one.spines.values():
            spine.set_color(LINE)
    last = axes[5]
    last.axis("off")
    handles = [
        mpl.lines.Line2D([], [], color=colour, linestyle=dashes, linewidth=width, label=name) for name, colour, dashes, width in styles
    ]
    handles.append(mpl.patches.Patch(color=FAINT, alpha=0.6, linewidth=0, label="conditioning, 99 %"))
    last.legend(
        handles=handles,
        title="error of a printed number,\nin units of its last place",
        loc="center",
        frameon=False,
        fontsize=12,
        title_fontsize=12,
    )
    return figure


def save(data, path=PICTURE):
    """The picture as a file that depends on the data alone."""
    about = {"Date": None, "Title": TITLE, "Description": fingerprint(data)}
    draw(data).savefig(path, metadata=about if path == PICTURE else None)
