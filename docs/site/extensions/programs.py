"""The directive `program-help`: the help of the command line.

It is as `--help` tells it, a section for each command.
"""

from __future__ import annotations

import os
import re
import subprocess
import sys
from typing import Any

from docutils import nodes
from littlewood.__main__ import OF_THE_PACKAGE
from sphinx.application import Sphinx
from sphinx.errors import ExtensionError
from sphinx.util.docutils import SphinxDirective

_HEADING = re.compile(r"^([A-Z][^:]*):$")
_OPTION = re.compile(r"^ {2,6}(-\w, )?(--[\w-]+.*|-\w.*|[<\[]\w.*)$")
_COMMAND = re.compile(r"^  ([a-z]+) +\S")


def _help(*command: str) -> list[str]:
    program = os.environ.get("LITTLEWOOD_BIN")
    if program is None:
        raise ExtensionError("LITTLEWOOD_BIN names no program")
    run = subprocess.run([program, *command, "--help"], capture_output=True, text=True, check=True)
    return run.stdout.splitlines()


def _help_of_the_package(command: str) -> list[str]:
    """The help of a command that the package adds, in another form."""
    words = [sys.executable, "-P", "-m", "littlewood", command, "--help"]
    wide = {**os.environ, "COLUMNS": "100"}
    return subprocess.run(
        words, capture_output=True, text=True, check=True, env=wide
    ).stdout.splitlines()


def _blocks(lines: list[str]) -> list[tuple[str, list[str]]]:
    """The text before the first heading, and then what stands below each heading."""
    blocks: list[tuple[str, list[str]]] = [("", [])]
    for line in lines:
        heading = _HEADING.match(line)
        if heading:
            blocks.append((heading[1], []))
        elif line.startswith("Usage: "):
            blocks.append(("Usage", [line.removeprefix("Usage: ")]))
        else:
            blocks[-1][1].append(line)
    return [(heading, "\n".join(block).strip("\n").split("\n")) for heading, block in blocks]


def _paragraphs(lines: list[str]) -> list[nodes.Node]:
    """Paragraphs and lists, their lines put together."""
    found: list[nodes.Node] = []
    for block in re.split(r"\n\s*\n", "\n".join(lines).strip("\n")):
        words: list[str] = []
        items: list[str] = []
        for line in map(str.strip, block.split("\n")):
            if line.startswith("- "):
                items.append(line.removeprefix("- "))
            elif items:
                items[-1] += f" {line}"
            else:
                words.append(line)
        if any(words):
            found.append(_paragraph(" ".join(words)))
        if items:
            found.append(
                nodes.bullet_list("", *(nodes.list_item("", _paragraph(it)) for it in items))
            )
    return found


def _paragraph(text: str) -> nodes.paragraph:
    parts = text.split("`")
    return nodes.paragraph(
        "",
        "",
        *(nodes.literal(it, it) if i % 2 else nodes.Text(it) for i, it in enumerate(parts) if it),
    )


def _code(lines: list[str]) -> nodes.literal_block:
    text = "\n".join(line.removeprefix("  ") for line in lines)
    return nodes.literal_block(text, text, language="text")


class ProgramHelp(SphinxDirective):
    """Shows the help of the program and of all its commands."""

    has_content = False

    def run(self) -> list[nodes.Node]:
        lines = _help()
        listed = dict(_blocks(lines)).get("Commands", [])
        commands = [
            match[1] for line in listed if (match := _COMMAND.match(line)) and match[1] != "help"
        ]
        if not commands:
            raise self.error("the help of the program lists no commands")
        sections = [self._section(name) for name in commands]
        return [*self._body("littlewood", lines), *sections]

    def _section(self, name: str) -> nodes.section:
        title = f"littlewood {name}"
        section = nodes.section(
            "",
            nodes.title("", "", nodes.literal(title, title)),
            ids=[f"littlewood-{name}"],
            names=[title],
        )
        if name in OF_THE_PACKAGE:
            section += _paragraph("In the program of the Python package:")
            section += _code(_help_of_the_package(name))
        else:
            section += self._body(name, _help(name))
        return section

    def _body(self, command: str, lines: list[str]) -> list[nodes.Node]:
        body: list[nodes.Node] = []
        for heading, block in _blocks(lines):
            if heading == "":
                body += _paragraphs(block)
            elif heading == "Usage":
                body.append(_code(block))
            elif heading == "Examples":
                body.append(nodes.rubric("", heading))
                body.append(_code([line for line in block if line.startswith("  ")]))
                body += _paragraphs([line for line in block if not line.startswith("  ")])
            else:
                body.append(nodes.rubric("", heading))
                body.append(self._options(command, block))
        return body

    def _options(self, command: str, lines: list[str]) -> nodes.definition_list:
        """Flags, arguments or commands, each with what is said of it."""
        listed = nodes.definition_list(classes=["flags"])
        entries: list[tuple[str, list[str]]] = []
        for line in lines:
            indent = len(line) - len(line.lstrip())
            if _OPTION.match(line) or (indent == 2 and line.strip()):
                head, _, text = line.strip().partition("  ")
                entries.append((head, [text]))
            elif entries:
                entries[-1][1].append(line)
        for head, text in entries:
            flag = re.search(r"--([\w-]+)", head)
            anchor = [f"{command}-{flag[1]}"] if flag else []
            term = nodes.term("", "", nodes.literal(head, head), ids=anchor)
            listed += nodes.definition_list_item("", term, nodes.definition("", *_paragraphs(text)))
        return listed


def setup(app: Sphinx) -> dict[str, Any]:
    app.add_directive("program-help", ProgramHelp)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
