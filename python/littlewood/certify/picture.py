"""The proof behind a certificate.

Where no event can be, which there are, and how narrowly they are enclosed.
"""

from __future__ import annotations

import itertools
import math
import textwrap
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from .. import _core
from .._internal.extras import require
from ..plot.canvas import PictureError, look, pi_ticks, sheet, sign
from ..style import FAINT, HATCH, INK, LINE, MODE_COLOURS, MODE_DASHES, PAPER
from ..tables import CAUSE_LABELS, MODES, SAMPLE_COLUMNS
from .checker import CONTACT, DOWN, GAP, NORMAL, SLIP, SOLVABLE, TURNING, UP
from .stretch import Box, ProofLike, Stretch, quantity_of

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_GRIP = f"{sign('mu_s')}(1 + cos {sign('theta')})"
_GUARDS = {
    False: {
        SLIP: f"|{sign('slip')}|",
        TURNING: f"|{sign('theta_rate')}|",
        CONTACT: "w",
        SOLVABLE: "P",
        UP: f"{sign('mu_s')}{sign('normal')} − {sign('friction')}",
        DOWN: f"{sign('mu_s')}{sign('normal')} + {sign('friction')}",
        GAP: sign("gap"),
    },
    True: {
        NORMAL: f"1 − {sign('theta_rate')}²",
        UP: f"{_GRIP}\n+ sin {sign('theta')}",
        DOWN: f"{_GRIP}\n− sin {sign('theta')}",
        SLIP: f"|{sign('slip')}|",
    },
}
"""Signs of the guards of a hoop with mass, and of one without, in the order of their rows.

They stand in docs/checker.md.
"""

_MOST_LINES = 12
"""Lines of events below the picture."""

_NEAR = 1e-3
"""Where a guard comes so near to 0, for the height of its row, its bound is written."""

# Letters in points; lengths in millimetres, those of digits and of letters on average.
_LETTERS, _DIGIT, _LETTER, _LINE, _BOLD, _TITLE = 6.5, 1.46, 1.28, 3.0, 1.66, 4.0
_EDGE, _ANGLE, _ROW, _RADIUS, _SKIP, _AXIS, _KEY = 2.0, 24.0, 8.5, 20.0, 2.0, 9.0, 19.0
_NARROWEST, _WIDEST = 60.0, 1000.0


def draw(found: ProofLike, width_mm: float) -> Figure:
    """Draw a proof; :func:`littlewood.plot.proof` says what the picture has."""
    if not _NARROWEST <= width_mm <= _WIDEST:
        raise PictureError(f"a picture is {_NARROWEST:g} to {_WIDEST:g} mm wide, not {width_mm:g}")
    with look(width_mm):
        return _drawn(found, width_mm)


def _drawn(found: ProofLike, width_mm: float) -> Figure:
    labels = _labels(found)
    left = _EDGE + _DIGIT * (
        5 + max(len(line) for text in ("radius", *labels.values()) for line in text.split("\n"))
    )
    handles, listed = _handles(found), _listed(found, width_mm)
    words = textwrap.wrap(caption(found), int((width_mm - 2 * _EDGE) / _LETTER))
    columns = int((width_mm - 2 * _EDGE) / _KEY)
    heights = [_ANGLE, *[_ROW] * len(labels), _RADIUS]
    heading = textwrap.wrap(title(found), int((width_mm - 2 * _EDGE) / _BOLD))
    above = 2.0 + _TITLE * len(heading)
    top = above + 1.0 + _LINE * (math.ceil(len(handles) / columns) + 1)
    foot = _AXIS + _LINE * (len(listed) + len(words) + 0.7)
    height = top + sum(heights) + _SKIP * len(heights) + foot
    figure = sheet(width_mm / 25.4, height / 25.4)
    figure.set_layout_engine("none")

    def write(x: float, y: float, text: str, **style: Any) -> None:
        figure.text(
            x / width_mm, y / height, text, va="top", color=INK, **({"size": _LETTERS} | style)
        )

    for number, line in enumerate(heading):
        write(_EDGE, height - 1.5 - _TITLE * number, line, size=8.0)
    figure.legend(
        handles=handles, loc="upper left", ncols=columns,
        bbox_to_anchor=(_EDGE / width_mm, 1.0 - above / height),
        fontsize=_LETTERS, handlelength=2.4, borderaxespad=0.0, columnspacing=1.2, labelspacing=0.0,
    )  # fmt: skip
    rows: list[Axes] = []
    y = height - top
    across = width_mm - left - _EDGE - 1.0
    for size in heights:
        box = (left / width_mm, (y - size) / height, across / width_mm, size / height)
        rows.append(figure.add_axes(box, sharex=rows[0] if rows else None))
        y -= size + _SKIP
    until = max(
        one.tube[-1].time if one.end is None or one.repeats else one.end for one in found.stretches
    )
    for axes in rows:
        axes.set_xlim(0.0, until)
        axes.tick_params(labelsize=_LETTERS, length=2.0, pad=1.5, labelbottom=axes is rows[-1])
        for event in found.certificate["events"]:
            axes.axvline(_middle(event, "time"), color=LINE, linewidth=0.5, zorder=0)
    _draw_angle(found, rows[0], until / across)
    for (name, label), axes in zip(labels.items(), rows[1:-1], strict=True):
        _draw_guard(found, name, axes, until)
        _name(axes, _core.marked(label))
    _draw_radius(found, rows[-1])
    clock = _core.marked(f"{sign('time')}  ({_unit(found, 'time')})")
    rows[-1].set_xlabel(clock, size=_LETTERS, labelpad=1.0, color=INK)
    y = foot - _AXIS
    for cells in listed:
        for x, text in zip(_columns(listed), cells, strict=True):
            write(
                x,
                y,
                _core.marked(text)
                if cells is listed[0] and text.startswith(sign("time"))
                else text,
            )
        y -= _LINE
    for line in words:
        for symbol in (sign("theta"), sign("time")):
            line = line.replace(symbol, _core.marked(symbol))
        write(_EDGE, y - 0.5 * _LINE, line)
        y -= _LINE
    return figure


def title(found: ProofLike) -> str:
    """Return what is proved."""
    name, count = found.certificate["case"]["name"] or "A motion", len(found.certificate["events"])
    if not count:
        return f"{name}: no event, proved"
    return f"{name}: {count} event{'s' * (count > 1)} and no other{'s' * (count > 1)}, proved"


def caption(found: ProofLike) -> str:
    """Return what the picture shows."""
    last, unit = found.stretches[-1], _unit(found, "time")
    said = [
        f"A phase lasts while all its guards are above 0. The checker has enclosed them (dark) "
        f"above 0 on "
        f"{found.intervals} intervals, so that no event is missed (shaded). White: the phase has "
        f"no such guard.",
        f"{sign('theta')} is enclosed far more narrowly than a line is wide: its radius as the "
        f"checker has it (line, "
        f"{found.bits} bits), and as the certificate states it, in 30 digits.",
    ]
    if last.repeats:
        until = "for ever" if last.end is None else f"up to {sign('time')} = {last.end:.6g} {unit}"
        said.append(
            f"Rolling repeats itself after {last.enclosed - last.start:.6g} {unit}, {until}."
        )
    elif not last.guards:
        said.append("At the end the hoop rests.")
    elif _falls(found):
        said.append(
            "Hatched: by a closed form the slip does not end before the particle is at the plane."
        )
    return " ".join(said)


def description(found: ProofLike) -> str:
    """Return the caption, and the events with all their digits."""
    lines = [" ".join(cells).strip() for cells in _listed(found, _WIDEST)]
    return "; ".join([caption(found).removesuffix("."), *lines]) + "."


def _falls(found: ProofLike) -> bool:
    last = found.stretches[-1]
    return (
        bool(last.guards) and not last.repeats and last.end is not None and last.enclosed < last.end
    )


def _labels(found: ProofLike) -> dict[str, str]:
    """Return the signs of the guards that the motion has, with their units."""
    used = {name for one in found.stretches for name in one.guards}
    quantities = {name: quantity_of(name, found.massless) for name in used}
    units = {
        name: f"\n({_unit(found, quantity)})"
        for name, quantity in quantities.items()
        if quantity is not None
    }
    return {
        name: text + units.get(name, "")
        for name, text in _GUARDS[found.massless].items()
        if name in used
    }


def _listed(found: ProofLike, width_mm: float) -> list[tuple[str, str, str]]:
    """Return number, cause and time of each event, below a head; impacts in a row have one line."""
    numbered = list(enumerate(found.certificate["events"], 1))
    lines: list[tuple[int, int, str]] = []
    for bounces, run in itertools.groupby(
        numbered, lambda one: one[1]["to"] == "flight" and "impact" in one[1]
    ):
        group = list(run)
        if bounces and len(group) > 2:
            lines.append((group[0][0], group[-1][0], f"{len(group)} impacts"))
        else:
            lines += [(number, number, CAUSE_LABELS[event["cause"]]) for number, event in group]
    if len(lines) > _MOST_LINES:
        lines[_MOST_LINES - 1 :] = [(lines[_MOST_LINES - 1][0], len(numbered), "other events")]
    if not lines:
        return []
    numbers = [str(a) if a == b else f"{a}–{b}" for a, b, _ in lines]
    head = ("", "event", f"{sign('time')}  ({_unit(found, 'time')})")
    room = (
        width_mm
        - _EDGE
        - _columns([head, *zip(numbers, (label for *_, label in lines), numbers, strict=True)])[2]
    )
    balls = [[event["state"]["time"] for _, event in numbered[a - 1 : b]] for a, b, _ in lines]
    times = [_times(some, int(room / _DIGIT)) for some in balls]
    return [head, *zip(numbers, (label for *_, label in lines), times, strict=True)]


def _columns(lines: list[tuple[str, str, str]]) -> tuple[float, float, float]:
    """Return where the columns of a list begin."""
    first, second = (max(len(cells[k]) for cells in lines) for k in (0, 1))
    return (
        _EDGE,
        _EDGE + _DIGIT * (first + 1),
        _EDGE + _DIGIT * (first + 1) + _LETTER * (second + 2),
    )


def _times(balls: list[list[str]], room: int) -> str:
    """Return a time with its radius, or the first and the last of several with the largest.

    In so many digits.
    """
    widest = max((radius for _, radius in balls), key=float)
    radius = f" ± {_radius(widest)}" if float(widest) else ", exactly"
    if len(balls) > 1:
        first, last = float(balls[0][0]), float(balls[-1][0])
        text = f"{first:.6g} … {last:.6g}, each{radius} at most"
        return text if len(text) <= room else f"{first:.4g} … {last:.4g},{radius}"
    # Raised digits are small.
    text, room = balls[0][0], room - len(radius) + 1
    return (text if len(text) <= room else text[: room - 1] + "…") + radius


def _handles(found: ProofLike) -> list[Any]:
    """Return what the key explains."""
    lines, patches = require("matplotlib.lines"), require("matplotlib.patches")
    modes = {one.mode for one in found.stretches}
    handles = [
        lines.Line2D(
            [], [], color=MODE_COLOURS[mode], linestyle=MODE_DASHES[mode], linewidth=1.2, label=mode
        )
        for mode in MODES
        if mode in modes
    ]
    handles += [patches.Patch(facecolor=FAINT, alpha=_PALE, linewidth=0.0, label="no event")]
    if _falls(found):
        handles.append(patches.Patch(**_HATCHED, label="closed form"))
    balls = _balls(found)
    handles += [
        lines.Line2D([], [], linewidth=0.0, label=name, **_BALLS[name])
        for name in balls
        if balls[name]
    ]
    return handles


_PALE = 0.25
_HATCHED: dict[str, Any] = {
    "facecolor": "none",
    "edgecolor": HATCH,
    "hatch": "/////",
    "linewidth": 0.0,
}
_BALLS: dict[str, dict[str, Any]] = {
    "event": {
        "marker": "s",
        "markersize": 3.2,
        "color": INK,
        "markerfacecolor": PAPER,
        "markeredgewidth": 0.7,
    },
    "sample": {"marker": ".", "markersize": 2.0, "color": INK},
}


def _joined(found: ProofLike) -> list[tuple[str, list[Stretch]]]:
    """Return the stretches in a row that have one mode, such as bounces."""
    return [
        (mode, list(some))
        for mode, some in itertools.groupby(found.stretches, lambda one: one.mode)
    ]


def _draw_tube(found: ProofLike, axes: Axes, which: str) -> None:
    for mode, some in _joined(found):
        tube = [at for one in some for at in one.tube]
        times, values = [at.time for at in tube], [getattr(at, which) for at in tube]
        axes.plot(
            times, values, color=MODE_COLOURS[mode], linestyle=MODE_DASHES[mode], linewidth=1.2
        )


def _balls(found: ProofLike) -> dict[str, list[dict[str, list[str]]]]:
    """Return the states of the certificate."""
    samples = [sample for one in found.certificate["phases"] for sample in one["samples"]]
    return {"event": [event["state"] for event in found.certificate["events"]], "sample": samples}


def _draw_balls(found: ProofLike, axes: Axes, height: Callable[[list[str]], float]) -> None:
    """Mark the states of the certificate, at a height that their angle has."""
    for name, states in _balls(found).items():
        times, values = (
            [float(one["time"][0]) for one in states],
            [height(one["theta"]) for one in states],
        )
        order = 5.0 if name == "event" else 1.5
        axes.plot(times, values, linewidth=0.0, zorder=order, clip_on=False, **_BALLS[name])


def _draw_angle(found: ProofLike, axes: Axes, per_mm: float) -> None:
    _draw_tube(found, axes, "theta")
    _draw_balls(found, axes, lambda ball: float(ball[0]))
    pi_ticks(axes, "y", most=5)
    _name(axes, _core.marked(sign("theta")))
    # Numbers that have room.
    free = -math.inf
    for number, event in enumerate(found.certificate["events"], 1):
        time, half = _middle(event, "time"), (0.4 + 0.5 * len(str(number))) * _DIGIT * per_mm
        if time - half >= free:
            axes.annotate(
                str(number), (time, 1.0), xycoords=("data", "axes fraction"), xytext=(0, 1.5),
                textcoords="offset points", ha="center", va="bottom", size=_LETTERS, color=INK,
            )  # fmt: skip
            free = time + half


def _draw_guard(found: ProofLike, name: str, axes: Axes, until: float) -> None:
    dips: list[Box] = []
    for mode, some in _joined(found):
        boxes = [box for one in some for box in one.guards.get(name, [])]
        if not boxes:
            continue
        times, lows, highs = (
            [one.start for one in boxes],
            [max(one.low, 0.0) for one in boxes],
            [one.high for one in boxes],
        )
        axes.axvspan(
            boxes[0].start, boxes[-1].end, color=MODE_COLOURS[mode], alpha=_PALE, linewidth=0.0
        )
        axes.fill_between(
            [*times, boxes[-1].end], [*lows, lows[-1]], [*highs, highs[-1]], step="post",
            color=MODE_COLOURS[mode], linewidth=0.6,
        )  # fmt: skip
        if some[-1] is found.stretches[-1] and _falls(found):
            axes.axvspan(some[-1].enclosed, until, **_HATCHED)
        # Where the guard is least without being 0.
        around = [math.inf, *(one.low for one in boxes), math.inf]
        dips += [
            one for k, one in enumerate(boxes) if 0.0 < one.low <= min(around[k], around[k + 2])
        ]
    height = 1.15 * max(box.high for one in found.stretches for box in one.guards.get(name, []))
    axes.set_ylim(0.0, height)
    axes.yaxis.set_major_locator(require("matplotlib.ticker").MaxNLocator(2, steps=[1, 2, 5, 10]))
    least = min(dips, key=lambda one: one.low, default=None)
    if least is not None and least.low < _NEAR * height:
        side = (
            "left"
            if least.start < until / 3
            else "right"
            if least.start > until * 2 / 3
            else "center"
        )
        axes.annotate(
            f"> {_bound(least.low)}", ((least.start + least.end) / 2, 1.0),
            xycoords=("data", "axes fraction"), textcoords="offset points",
            xytext=({"left": 2, "center": 0, "right": -2}[side], -2), ha=side, va="top",
            size=_LETTERS, color=INK,
        )  # fmt: skip


def _draw_radius(found: ProofLike, axes: Axes) -> None:
    ticker = require("matplotlib.ticker")
    _draw_tube(found, axes, "radius")
    _draw_balls(
        found, axes, lambda ball: math.log10(float(ball[1])) if float(ball[1]) else math.nan
    )
    axes.margins(y=0.12)
    axes.yaxis.set_major_locator(ticker.MaxNLocator(4, integer=True))
    axes.yaxis.set_major_formatter(
        ticker.FuncFormatter(lambda value, _: f"10{_raised(round(value))}")
    )
    _name(axes, f"radius\nof {_core.marked(sign('theta'))}")


def _name(axes: Axes, label: str) -> None:
    axes.set_ylabel(label, size=_LETTERS, rotation=0, ha="right", va="center", color=INK)


def _middle(one: Mapping[str, Any], name: str) -> float:
    return float(one["state"][name][0])


def _unit(found: ProofLike, name: str) -> str:
    """Return the unit of a quantity in the system of the certificate."""
    column = SAMPLE_COLUMNS[name]
    return (
        column.si_unit if found.certificate["case"]["units"] == "si" else column.unit_sign
    ) or ""


def _raised(power: int) -> str:
    return str(power).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))


def _radius(text: str) -> str:
    """Return a radius such as 41e-31 as 4.1·10⁻³⁰."""
    digits, _, exponent = text.partition("e")
    rest = digits[1:].rstrip("0")
    return (
        f"{digits[0]}{'.' + rest if rest else ''}·10{_raised(int(exponent or 0) + len(digits) - 1)}"
    )


def _bound(value: float) -> str:
    """Return two digits that are not above a number."""
    power = math.floor(math.log10(value))
    return f"{math.floor(value / 10.0 ** (power - 1)) / 10:g}·10{_raised(power)}"
