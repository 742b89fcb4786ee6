"""Docstrings as people write them, of which Sphinx would make something else."""

from __future__ import annotations

import re
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.environment import BuildEnvironment
from sphinx.util.nodes import make_refnode

_BAR = re.compile(r"(?<!\\)\|")
_SEVERAL = re.compile(r":(ivar|vartype) (\w+(?:, \w+)+):(.*)")


def _before(
    app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]
) -> None:
    """Bars of absolute values, and colons, as reStructuredText needs them.

    It takes bars for substitutions, and the first colon of a property for the end of a type.
    """
    lines[:] = [line if ">>>" in line else _BAR.sub(r"\\|", line) for line in lines]
    if what in ("attribute", "property", "data") and lines and ": " in lines[0]:
        first, rest = lines[0].split(": ", 1)
        lines[:1] = [f"{first}:", rest]


def _after(
    app: Sphinx, what: str, name: str, obj: object, options: object, lines: list[str]
) -> None:
    """Attributes that share a line of a docstring have one each."""
    several: list[str] = []
    for line in lines:
        found = _SEVERAL.fullmatch(line)
        if found is None:
            several.append(line)
        else:
            kind, names, rest = found.groups()
            several += [f":{kind} {one}:{rest}" for one in names.split(", ")]
    lines[:] = several


def _by_last_name(
    app: Sphinx, env: BuildEnvironment, node: nodes.Element, content: nodes.TextElement
) -> nodes.reference | None:
    """The one object of the package whose name ends so.

    Docstrings name classes as people do, without the module.
    """
    if node.get("refdomain") != "py":
        return None
    objects = env.get_domain("py").objects
    ending = "." + node["reftarget"]
    found = [
        (name, it)
        for name, it in objects.items()
        if ("." + name).endswith(ending) and not it.aliased
    ]
    if len(found) != 1:
        return None
    name, it = found[0]
    return make_refnode(app.builder, node["refdoc"], it.docname, it.node_id, content, name)


def setup(app: Sphinx) -> dict[str, Any]:
    # Around napoleon, which has the priority 500.
    app.connect("autodoc-process-docstring", _before, priority=400)
    app.connect("autodoc-process-docstring", _after, priority=600)
    app.connect("missing-reference", _by_last_name)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
