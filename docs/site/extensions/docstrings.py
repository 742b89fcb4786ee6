"""Docstrings as people write them: absolute values are bars, which reStructuredText takes for substitutions."""

from __future__ import annotations

import re
from typing import Any

from sphinx.application import Sphinx

_BAR = re.compile(r"(?<!\\)\|")


def _escape(app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]) -> None:
    lines[:] = [line if ">>>" in line else _BAR.sub(r"\\|", line) for line in lines]


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("autodoc-process-docstring", _escape)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
