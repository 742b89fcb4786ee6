"""How hoops and motions look in notebooks."""

from __future__ import annotations

import math
from collections.abc import Iterable
from html import escape

from . import _core
from ._protocols import HoopLike
from .style import FAINT, MODE_COLOURS
from .tables import HOOP, LAW_LABELS, QUANTITIES, SAMPLE_COLUMNS

# Colours follow the page, so that dark themes stay readable.
_CELL = "padding:2px 10px;text-align:{};border:none;background:none"


def _hoop_rows(hoop: HoopLike) -> list[tuple[str, str, str]]:
    """Return sign, value and meaning of each parameter that a hoop has."""
    values = [(QUANTITIES[name], hoop.attributes.get(name)) for name in HOOP]
    rows = [
        (one.sign, f"{value:.6g}", one.long_name)
        for one, value in values
        if isinstance(value, float)
    ]
    law = hoop.restitution_law
    return rows if law is None else [*rows, ("", LAW_LABELS[law], "law of restitution")]


def _table(head: tuple[str, ...], rows: list[tuple[str, ...]], left: tuple[int, ...]) -> str:
    def cells(tag: str, row: tuple[str, ...]) -> str:
        return "".join(
            f'<{tag} style="{_CELL.format("left" if k in left else "right")}">{cell}</{tag}>'
            for k, cell in enumerate(row)
        )

    body = "".join(f'<tr style="background:none">{cells("td", row)}</tr>' for row in rows)
    header = f"<thead><tr>{cells('th', head)}</tr></thead>" if head else ""
    return (
        '<table style="border-collapse:collapse;font-variant-numeric:tabular-nums;margin:4px 0">'
        f"{header}<tbody>{body}</tbody></table>"
    )


def page_html(blocks: Iterable[_core._Block]) -> str:
    """Return the page of a motion for a notebook: facts, tables and notes."""
    parts = []
    for block in blocks:
        head, rows = block["head"], block["rows"]
        if block["kind"] == "table":
            left = tuple(set(range(len(head))) - set(block["numbers"]))
            parts.append(_table(tuple(map(escape, head)), [_coloured(row) for row in rows], left))
        elif block["kind"] == "fact":
            lines = "<br>".join(escape(line) for row in rows for line in row["cells"])
            label = f'<b style="min-width:6em">{escape(head[0])}</b>'
            # The spaces between quantities stay as they are.
            parts.append(
                f'<div style="display:flex">{label}<div '
                f'style="white-space:pre-wrap">{lines}</div></div>'
            )
        else:
            parts.append(f"<div><small>{escape(head[0])}</small></div>")
    return f"<div>{''.join(parts)}</div>"


def _coloured(row: _core._Row) -> tuple[str, ...]:
    """Return a row of phases with the mark of its mode before the name of the motion."""
    mode = row["mode"]
    order, name, *rest = map(escape, row["cells"])
    paint = f"background:{MODE_COLOURS[mode]};border:1px solid {FAINT}" if mode is not None else ""
    size = "display:inline-block;width:0.7em;height:0.7em;margin-right:0.5em"
    mark = f'<span style="{size};{paint}"></span>'
    return (order, mark + name, *rest)


def _sketch(hoop: HoopLike) -> str:
    # The particle at 45° from the vertical, as in Figure 1 of the paper.
    def along(distance: float) -> str:
        reach = 40.0 * distance * math.sqrt(0.5)
        return f'cx="{50 - reach:.2f}" cy="{50 - reach:.2f}"'

    end = 50.0 - 40.0 * hoop.offset * math.sqrt(0.5)
    return (
        '<svg width="100" height="100" viewBox="0 0 100 100" role="img" aria-label="the hoop" '
        'style="vertical-align:middle">'
        '<line x1="4" y1="90.7" x2="96" y2="90.7" stroke="currentColor" stroke-width="1.4"/>'
        f'<circle cx="50" cy="50" r="40" fill="none" stroke="{FAINT}" stroke-width="1.6"/>'
        f'<line x1="50" y1="50" x2="{end:.2f}" y2="{end:.2f}" stroke="{FAINT}" stroke-width="1.2"/>'
        f'<circle {along(hoop.offset)} r="5" fill="currentColor"/>'
        f'<circle {along(hoop.h)} r="2.8" fill="none" stroke="currentColor" '
        f'stroke-width="1.4"/></svg>'
    )


def hoop_html(hoop: HoopLike) -> str:
    """Return a hoop as a sketch and a table for a notebook."""
    table: list[tuple[str, ...]] = [
        (sign, value, escape(name)) for sign, value, name in _hoop_rows(hoop)
    ]
    if hoop.units is not None:
        for name, value in (
            ("radius_m", hoop.units.length_m),
            ("particle_mass_kg", hoop.units.mass_kg),
        ):
            quantity = QUANTITIES[name]
            table.append(
                (quantity.sign, f"{value:.6g} {quantity.unit_sign}", escape(quantity.long_name))
            )
        time = SAMPLE_COLUMNS["time"]
        table.append(
            (str(time.unit_sign), f"{hoop.units.time_s:.6g} {time.si_unit}", "unit of time")
        )
    parts = _sketch(hoop) + _table((), table, (0, 2))
    return f'<div style="display:flex;align-items:center;gap:16px">{parts}</div>'
