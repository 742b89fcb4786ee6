"""What the theme leaves out for those who listen to a page: names of its side bars, and the level of their headings."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

_MENDED = {
    '<aside class="sidebar-drawer">': '<aside class="sidebar-drawer" aria-label="Pages of the site">',
    '<aside class="toc-drawer">': '<aside class="toc-drawer" aria-label="On this page">',
    '<aside class="toc-drawer no-toc">': '<aside class="toc-drawer no-toc" aria-label="On this page">',
    'class="caption" role="heading">': 'class="caption" role="heading" aria-level="2">',
}


def _mend(app: Sphinx, error: Exception | None) -> None:
    if error is not None or app.builder.format != "html":
        return
    for document in [*app.env.found_docs, "genindex", "search", "py-modindex"]:
        page = Path(app.outdir) / f"{document}.html"
        if page.exists():
            text = page.read_text(encoding="utf-8")
            for old, new in _MENDED.items():
                text = text.replace(old, new)
            page.write_text(text, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("build-finished", _mend)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
