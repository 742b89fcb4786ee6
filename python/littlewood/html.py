"""How hoops and motions look: tables in plain text and in notebooks."""

from __future__ import annotations

import math
from html import escape
from typing import TYPE_CHECKING

from .style import FAINT, MODE_COLOURS
from .tables import ARROWS, CAUSE_LABELS, HOOP, QUANTITIES, SAMPLE_COLUMNS

if TYPE_CHECKING:
    from .hoop import Hoop
    from .motion import Phase
    from .trajectory import Trajectory

# Colours follow the page, so that dark themes stay readable.
_CELL = "padding:2px 10px;text-align:{};border:none;background:none"


def _number(value: float) -> str:
    return "∞" if math.isinf(value) else f"{value:.5f}"


def _ends(motion: Trajectory, phase: Phase) -> str:
    end = motion.end_of(phase)
    return motion.outcome.label if end is None else CAUSE_LABELS[end.cause]


_TIME = SAMPLE_COLUMNS["time"]
# What is told of the start of a phase besides the time.
_TOLD = [SAMPLE_COLUMNS[name] for name in ("theta", "theta_rate", "slip")]
_HEADINGS = ("#", "motion", f"from {_TIME.sign}", "duration", *(one.sign for one in _TOLD), "lost", "ends by")


def _row(motion: Trajectory, i: int, phase: Phase) -> tuple[str, ...]:
    start = phase.start
    return (
        str(i + 1),
        f"{phase.mode} {ARROWS[phase.direction]}".strip(),
        *(_number(value) for value in (start.time, phase.duration, *(getattr(start, one.name) for one in _TOLD))),
        _number(phase.energy_lost),
        _ends(motion, phase),
    )


def trajectory_text(motion: Trajectory) -> str:
    """Return a motion as a table in plain text."""
    rows = [_HEADINGS, *(_row(motion, i, phase) for i, phase in enumerate(motion.phases))]
    widths = [max(len(row[k]) for row in rows) for k in range(len(_HEADINGS))]
    left = (0, 1, 8)
    lines = [
        "  ".join(
            cell.ljust(width) if k in left else cell.rjust(width)
            for k, (cell, width) in enumerate(zip(row, widths, strict=True))
        ).rstrip()
        for row in rows
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
    rows = []
    for i, phase in enumerate(motion.phases):
        number, mode, *rest = _row(motion, i, phase)
        mark = (
            f'<span style="display:inline-block;width:0.7em;height:0.7em;margin-right:0.5em;'
            f'background:{MODE_COLOURS[phase.mode]};border:1px solid {FAINT}"></span>'
        )
        rows.append((number, mark + escape(mode), *(escape(cell) for cell in rest)))
    start = motion.start
    hoop = ", ".join(f"{QUANTITIES[name].sign} = {getattr(motion.hoop, name):.6g}" for name in HOOP)
    state = ", ".join(f"{one.sign} = {getattr(start, one.name):.6g}" for one in _TOLD)
    outcome = motion.outcome
    final = "" if outcome.is_final else ", not its end"
    measured = [f"{one.sign} in {one.unit_sign or 'rad'}" for one in (_TIME, *_TOLD)]
    units = f"<small>{', '.join(measured)}, energy lost in {SAMPLE_COLUMNS['energy'].unit_sign}</small>"
    table = _table(_HEADINGS, rows, (0, 1, 8)) if rows else ""
    return (
        f"<div><div><b>Motion of a hoop</b> with {escape(hoop)}</div><div>from {escape(state)}</div>{table}"
        f"<div>Outcome: <b>{escape(str(outcome))}</b> at {_TIME.sign} = {outcome.state.time:.6g}{final}</div>"
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
    rows: list[tuple[str, ...]] = [
        (QUANTITIES[name].sign, f"{getattr(hoop, name):.6g}", escape(QUANTITIES[name].long_name)) for name in HOOP
    ]
    if hoop.units is not None:
        for name, value in (("radius_m", hoop.units.length_m), ("particle_mass_kg", hoop.units.mass_kg)):
            quantity = QUANTITIES[name]
            rows.append((quantity.sign, f"{value:.6g} {quantity.unit_sign}", escape(quantity.long_name)))
        rows.append((str(_TIME.unit_sign), f"{hoop.units.time_s:.6g} {_TIME.si_unit}", "unit of time"))
    return f'<div style="display:flex;align-items:center;gap:16px">{_sketch(hoop)}{_table((), rows, (0, 2))}</div>'
