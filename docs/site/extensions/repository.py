"""Links of documents to files of the repository that are no pages of the site.

They lead to the repository where it is public.
"""

from __future__ import annotations

import posixpath
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx import addnodes
from sphinx.application import Sphinx
from sphinx.util import logging

_log = logging.getLogger(__name__)


def _address(app: Sphinx, path: str, fragment: str) -> str | None:
    kind = "tree" if (Path(app.srcdir) / path).is_dir() else "blob"
    base = app.config.repository_url
    return None if base is None else f"{base}/{kind}/main/{path}{fragment}"


def _within(app: Sphinx, document: str, target: str) -> str | None:
    """The path of a target in the repository; none if there is nothing, or if it is a page."""
    path = posixpath.normpath(posixpath.join(posixpath.dirname(document), target))
    if path.startswith("..") or not (Path(app.srcdir) / path).exists():
        return None
    return None if posixpath.splitext(path)[0] in app.env.found_docs else path


def _replace(app: Sphinx, node: nodes.Element, path: str, fragment: str = "") -> None:
    address = _address(app, path, fragment)
    children = node.children
    if address is None:
        node.replace_self(children)
    else:
        node.replace_self(nodes.reference("", "", *children, refuri=address, internal=False))


def _link(app: Sphinx, tree: nodes.document) -> None:
    document = app.env.docname
    for node in list(tree.findall(addnodes.download_reference)):
        path = _within(app, document, node["reftarget"].lstrip("/")) or _within(
            app, "", node["reftarget"].lstrip("/")
        )
        if path is not None:
            _replace(app, node, path)
    for node in list(tree.findall(addnodes.pending_xref)):
        if node.get("reftype") != "myst":
            continue
        target, hash_, fragment = node["reftarget"].partition("#")
        path = (_within(app, document, target) or _within(app, "", target)) if target else None
        if path is not None:
            _replace(app, node, path, hash_ + fragment)


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_config_value("repository_url", None, "env")
    app.connect("doctree-read", _link)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
