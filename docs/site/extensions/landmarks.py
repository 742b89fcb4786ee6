"""What the theme leaves out for those who listen to a page.

These are names of its side bars, and the level of their headings.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from sphinx.application import Sphinx

_LABELS = {
    "sidebar-drawer": "Pages of the site",
    "toc-drawer": "On this page",
    "toc-drawer no-toc": "On this page",
}
_MENDED = {
    **{
        f'<aside class="{name}">': f'<aside class="{name}" aria-label="{label}">'
        for name, label in _LABELS.items()
    },
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
