"""How hoops and motions look: tables in plain text and in notebooks."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

from .phase_table import HEADINGS, LEFT, TIME, TOLD, rows
from .style import FAINT, MODE_COLOURS
from .tables import HOOP, LAW_LABELS, QUANTITIES, SAMPLE_COLUMNS

if TYPE_CHECKING:
    from .hoop import Hoop
    from .trajectory import Trajectory

# Colours follow the page, so that dark themes stay readable.
_CELL = "padding:2px 10px;text-align:{};border:none;background:none"


def _hoop_rows(hoop: Hoop) -> list[tuple[str, str, str]]:
    """Return sign, value and meaning of each parameter that a hoop has."""
    values = [(QUANTITIES[name], getattr(hoop, name)) for name in HOOP]
    rows = [(one.sign, f"{value:.6g}", one.long_name) for one, value in values if value is not None]
    return rows if hoop.law is None else [*rows, ("", LAW_LABELS[hoop.law], "law of restitution")]


def trajectory_text(motion: Trajectory) -> str:
    """Return a motion as a table in plain text."""
    table = [HEADINGS, *(row.cells for row in rows(motion))]
    widths = [max(len(row[k]) for row in table) for k in range(len(HEADINGS))]
    lines = [
        "  ".join(
            cell.ljust(width) if k in LEFT else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in table
    ]
    lines.insert(1, "─" * max(len(line) for line in lines))
    if not motion.phases:
        lines.append(f"no phase: {motion.outcome.label}")
    return "\n".join(lines)


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


def trajectory_html(motion: Trajectory) -> str:
    """Return a motion as a table for a notebook."""
    body = []
    for mode, (order, name, *rest) in rows(motion):
        paint = f"background:{MODE_COLOURS[mode]};border:1px solid {FAINT}" if mode is not None else ""
        mark = f'<span style="display:inline-block;width:0.7em;height:0.7em;margin-right:0.5em;{paint}"></span>'
        body.append((order, mark + escape(name), *(escape(cell) for cell in rest)))
    start = motion.start
    hoop = ", ".join(f"{sign} = {value}" if sign else value for sign, value, _ in _hoop_rows(motion.hoop))
    told = [SAMPLE_COLUMNS["gap_rate"], *TOLD] if start.gap_rate > 0.0 else TOLD
    state = ", ".join(f"{one.sign} = {getattr(start, one.name):.6g}" for one in told)
    outcome = motion.outcome
    final = "" if outcome.is_final else ", not its end"
    measured = [f"{one.sign} in {one.unit_sign or 'rad'}" for one in (TIME, *TOLD)]
    units = f"<small>{', '.join(measured)}, energy lost in {SAMPLE_COLUMNS['energy'].unit_sign}</small>"
    table = _table(HEADINGS, body, LEFT) if body else ""
    return (
        f"<div><div><b>Motion of a hoop</b> with {escape(hoop)}</div><div>from {escape(state)}</div>{table}"
        f"<div>Outcome: <b>{escape(str(outcome))}</b> at {TIME.sign} = {outcome.state.time:.6g}{final}</div>"
        f"{units}</div>"
    )


def _sketch(hoop: Hoop) -> str:
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
        f'<circle {along(hoop.h)} r="2.8" fill="none" stroke="currentColor" stroke-width="1.4"/></svg>'
    )


def hoop_html(hoop: Hoop) -> str:
    """Return a hoop as a sketch and a table for a notebook."""
    table: list[tuple[str, ...]] = [(sign, value, escape(name)) for sign, value, name in _hoop_rows(hoop)]
    if hoop.units is not None:
        for name, value in (("radius_m", hoop.units.length_m), ("particle_mass_kg", hoop.units.mass_kg)):
            quantity = QUANTITIES[name]
            table.append((quantity.sign, f"{value:.6g} {quantity.unit_sign}", escape(quantity.long_name)))
        table.append((str(TIME.unit_sign), f"{hoop.units.time_s:.6g} {TIME.si_unit}", "unit of time"))
    return f'<div style="display:flex;align-items:center;gap:16px">{_sketch(hoop)}{_table((), table, (0, 2))}</div>'
