"""Formulas as HTML and MathML, made once by KaTeX when the site is built.

A reader needs no network and no script.
"""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util import logging

_KATEX = Path(__file__).parents[3] / "web" / "node_modules" / "katex"
_PROGRAM = """
const katex = require(process.argv[1]);
const lines = require('readline').createInterface({ input: process.stdin });
lines.on('line', (line) => {
  const { tex, displayMode } = JSON.parse(line);
  let answer;
  try {
    const options = { displayMode, throwOnError: true, strict: 'error', output: 'htmlAndMathml' };
    answer = { html: katex.renderToString(tex, options) };
  } catch (error) {
    answer = { error: error.message };
  }
  process.stdout.write(JSON.stringify(answer) + '\\n');
});
"""

_log = logging.getLogger(__name__)


class _Renderer:
    """A process of KaTeX that answers one formula after the other."""

    def __init__(self) -> None:
        self._process: subprocess.Popen[str] | None = None
        self._known: dict[tuple[str, bool], str] = {}

    def render(self, tex: str, display: bool, place: Any) -> str:
        key = (tex, display)
        if key not in self._known:
            self._known[key] = self._ask(tex, display, place)
        return self._known[key]

    def _ask(self, tex: str, display: bool, place: Any) -> str:
        if self._process is None:
            if not _KATEX.is_dir():
                raise ExtensionError("KaTeX is not there: run `npm ci` in web")
            command = ["node", "-e", _PROGRAM, str(_KATEX)]
            self._process = subprocess.Popen(
                command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8"
            )
        assert self._process.stdin and self._process.stdout
        self._process.stdin.write(json.dumps({"tex": tex, "displayMode": display}) + "\n")
        self._process.stdin.flush()
        answer = json.loads(self._process.stdout.readline())
        if "error" in answer:
            _log.warning("formula: %s", answer["error"], location=place)
        html: str = answer.get("html", "")
        return html

    def close(self, *_: object) -> None:
        if self._process is not None and self._process.stdin:
            self._process.stdin.close()
            self._process.wait()
            self._process = None


_renderer = _Renderer()


def _inline(writer: Any, node: nodes.math) -> None:
    writer.body.append(_renderer.render(node.astext(), False, node))
    raise nodes.SkipNode


def _block(writer: Any, node: nodes.math_block) -> None:
    writer.body.append(writer.starttag(node, "div", CLASS="formula"))
    if node["number"]:
        numbers = writer.builder.fignumbers.get("displaymath", {}).get(
            node["ids"][0], (node["number"],)
        )
        number = writer.config.math_eqref_format.format(number=".".join(map(str, numbers)))
        writer.body.append(f'<span class="eqno">{number}')
        writer.add_permalink_ref(node, "Link to this equation")
        writer.body.append("</span>")
    tex = node.astext()
    # Lines that are aligned without saying so.
    if "&" in tex and "\\begin" not in tex:
        tex = f"\\begin{{aligned}}{tex}\\end{{aligned}}"
    writer.body.append(_renderer.render(tex, True, node))
    writer.body.append("</div>")
    raise nodes.SkipNode


def _copy(app: Sphinx, error: Exception | None) -> None:
    _renderer.close()
    if error is not None or app.builder.format != "html":
        return
    target = Path(app.outdir) / "_static" / "katex"
    (target / "fonts").mkdir(parents=True, exist_ok=True)
    for font in (_KATEX / "dist" / "fonts").glob("*.woff2"):
        shutil.copy(font, target / "fonts")
    style = (_KATEX / "dist" / "katex.min.css").read_text(encoding="utf-8")
    # Every browser that the site is for reads WOFF2; the other formats are left out.
    (target / "katex.css").write_text(style, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_html_math_renderer(
        "katex", inline_renderers=(_inline, None), block_renderers=(_block, None)
    )
    app.config.html_math_renderer = "katex"
    app.add_css_file("katex/katex.css")
    app.connect("build-finished", _copy)
    return {"parallel_read_safe": True, "parallel_write_safe": False}
