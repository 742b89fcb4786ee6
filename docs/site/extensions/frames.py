"""The directive `lab`: the laboratory in a page, whole or as a frame of one motion."""

from __future__ import annotations

import shutil
from html import escape
from pathlib import Path
from typing import Any, ClassVar

from docutils import nodes
from docutils.parsers.rst import directives
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective
from sphinx.util.osutil import relative_uri

_PAGE = Path(__file__).parents[3] / "web" / "dist"


class Frame(nodes.General, nodes.Element):
    """A frame of the laboratory."""


class Lab(SphinxDirective):
    """Shows the laboratory with a link: ``{lab} case=figure-3&embed=1``."""

    required_arguments = 1
    final_argument_whitespace = False
    has_content = False
    option_spec: ClassVar[dict[str, Any]] = {
        "height": directives.positive_int,
        "title": directives.unchanged_required,
    }

    def run(self) -> list[nodes.Node]:
        title = self.options.get("title", "The laboratory of Littlewood’s hoop")
        return [Frame(link=self.arguments[0], height=self.options.get("height", 420), title=title)]


def _visit(writer: Any, node: Frame) -> None:
    page = relative_uri(
        writer.builder.get_target_uri(writer.builder.current_docname), "lab/index.html"
    )
    address = escape(f"{page}#{node['link']}")
    title = escape(node["title"])
    whole = "embed=1" not in node["link"].split("&")
    kind = "lab-frame whole" if whole else "lab-frame"
    writer.body.append(
        f'<div class="{kind}"><iframe src="{address}" title="{title}" height="{node["height"]}" '
        f'allow="clipboard-write" data-link="{escape(node["link"])}"></iframe></div>'
    )
    # A frame without controls has such a link of its own.
    if whole:
        writer.body.append(
            f'<p class="lab-more"><a href="{address}">Open it in the whole window</a></p>'
        )
    raise nodes.SkipNode


def _skip(_: Any, node: Frame) -> None:
    raise nodes.SkipNode


def _copy(app: Sphinx, error: Exception | None) -> None:
    if error is not None or app.builder.format != "html":
        return
    if not (_PAGE / "index.html").exists():
        raise ExtensionError("the laboratory is not built: run web/build.sh")
    shutil.copytree(_PAGE, Path(app.outdir) / "lab", dirs_exist_ok=True)


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_node(Frame, html=(_visit, None), text=(_skip, None))
    app.add_directive("lab", Lab)
    app.connect("build-finished", _copy)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
