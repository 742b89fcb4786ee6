"""The directive `core-table`: tables of the core, as the Python package has them.

No page repeats them.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import littlewood as lw
from docutils import nodes
from littlewood.tables import (
    CAUSE_LABELS,
    CLASS_LABELS,
    IMPACT_LABELS,
    OUTCOME_LABELS,
    QUANTITIES,
    SAMPLE_COLUMNS,
    SUMMARY_COLUMNS,
)
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

Rows = tuple[Sequence[str], Iterable[Sequence[str | nodes.Node]]]


def _code(text: str) -> nodes.Node:
    return nodes.literal(text, text)


def _edges() -> Rows:
    head = ("body", "from", "event", "condition", "sets", "to", "source")
    return head, (
        (
            it.body,
            it.from_mode or "–",
            CAUSE_LABELS[it.cause],
            it.guard,
            it.reset,
            it.to_mode or "ends",
            it.source,
        )
        for it in lw.motion.EDGES
    )


def _quantities(si: bool) -> Rows:
    head = ("name", "symbol", "meaning", "unit", "if left out")
    chosen = (
        it
        for it in QUANTITIES.values()
        if it.is_si == si or (si and it.twin is None and not it.is_si)
    )
    return head, (
        (_code(it.name), it.sign, it.long_name, it.unit_sign or "1", _default(it)) for it in chosen
    )


def _default(quantity: Any) -> str:
    if quantity.is_optional:
        return "none"
    return "needed" if quantity.default is None else f"{quantity.default:g}"


def _samples() -> Rows:
    head = ("column", "with `--si`", "symbol", "meaning", "unit")
    return head, (
        (
            _code(it.name),
            _code(it.si_name) if it.si_name else "–",
            it.sign,
            it.long_name,
            it.unit_sign or "–",
        )
        for it in SAMPLE_COLUMNS.values()
    )


def _summaries() -> Rows:
    head = ("column", "type", "unit", "meaning")
    return head, (
        (_code(it.name), it.dtype, it.scale, it.long_name) for it in SUMMARY_COLUMNS.values()
    )


def _names(labels: Iterable[tuple[str, str]]) -> Rows:
    return ("name", "in words"), ((_code(name), label) for name, label in labels)


def _cases() -> Rows:
    return ("name", "what it does", "source"), (
        (_code(it.name), it.title, it.source) for it in lw.CASES.values()
    )


_TABLES = {
    "edges": _edges,
    "quantities": lambda: _quantities(si=False),
    "si-quantities": lambda: _quantities(si=True),
    "samples": _samples,
    "summaries": _summaries,
    "outcomes": lambda: _names(OUTCOME_LABELS.items()),
    "causes": lambda: _names(CAUSE_LABELS.items()),
    "impacts": lambda: _names(IMPACT_LABELS.items()),
    "classes": lambda: _names(CLASS_LABELS.items()),
    "cases": _cases,
}


class CoreTable(SphinxDirective):
    """Shows a table of the core by its name."""

    required_arguments = 1
    has_content = False

    def run(self) -> list[nodes.Node]:
        name = self.arguments[0]
        if name not in _TABLES:
            raise self.error(f"no table '{name}': one of {', '.join(_TABLES)}")
        head, rows = _TABLES[name]()
        return [_table(head, [list(row) for row in rows])]


def _table(head: Sequence[str], rows: list[list[str | nodes.Node]]) -> nodes.table:
    group = nodes.tgroup("", cols=len(head))
    group += [nodes.colspec("", colwidth=1) for _ in head]
    group += nodes.thead("", _row(head))
    group += nodes.tbody("", *(_row(row) for row in rows))
    return nodes.table("", group, classes=["core-table"])


def _row(cells: Sequence[str | nodes.Node]) -> nodes.row:
    return nodes.row("", *(nodes.entry("", _paragraph(cell)) for cell in cells))


def _paragraph(cell: str | nodes.Node) -> nodes.paragraph:
    if isinstance(cell, nodes.Node):
        return nodes.paragraph("", "", cell)
    # Names in backticks stay names.
    parts = cell.split("`")
    return nodes.paragraph(
        "", "", *(_code(it) if i % 2 else nodes.Text(it) for i, it in enumerate(parts) if it)
    )


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_directive("core-table", CoreTable)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
