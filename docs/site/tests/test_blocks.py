"""The commands of the pages, run as they stand, and what they print.

python/tests/test_docs.py runs the Python of the pages.
"""

import json
import os
import re
import shlex
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[3]
PROGRAM = os.environ["LITTLEWOOD_BIN"]
PAGES = sorted(
    {ROOT / "README.md", *(ROOT / "docs").rglob("*.md")}
    - set((ROOT / "docs" / "site").rglob("*.md"))
)
BLOCK = re.compile(r"^```(\w+)\n(.*?)^```", re.MULTILINE | re.DOTALL)

# What is not run, and why: a part of the command.
NOT_RUN = {
    "littlewood figures --out figures": "draws everything, as gallery.rs of the crate does",
    ".mp4": "needs ffmpeg",
    "lab": "serves until it is stopped",
}
# Grids and pictures are made smaller, so that a page takes seconds.
SMALLER = (
    (re.compile(r":\d{2,}\b(?!:)"), ":8"),
    (re.compile(r"--fps \d+"), "--fps 5"),
    (re.compile(r"--size \w+"), "--size 160x160"),
)


def commands(text: str) -> list[str]:
    """The commands of a block for a shell, their lines put together."""
    lines = text.replace("\\\n", " ").splitlines()
    return [line.removeprefix("$ ") for line in lines if re.match(r"(\$ )?littlewood ", line)]


def blocks(page: Path) -> list[tuple[str, str]]:
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def run(command: str, folder: Path) -> str:
    arguments = shlex.split(command, comments=True)[1:]
    done = subprocess.run(
        [PROGRAM, *arguments], cwd=folder, capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, f"{command}\n{done.stderr}"
    return done.stdout


def is_run(command: str) -> bool:
    return not any(part in command for part in NOT_RUN) and command.split()[1] != "lab"


WITH_COMMANDS = [
    page
    for page in PAGES
    if any(commands(text) for kind, text in blocks(page) if kind in ("sh", "console"))
]


@pytest.mark.parametrize("page", WITH_COMMANDS, ids=lambda page: str(page.relative_to(ROOT)))
def test_commands_run(page, tmp_path):
    for example in (ROOT / "crates" / "littlewood-cli" / "examples").iterdir():
        if example.suffix in {".toml", ".csv"}:
            (tmp_path / example.name).write_bytes(example.read_bytes())
    for kind, text in blocks(page):
        if kind != "sh":
            continue
        for command in filter(is_run, commands(text)):
            for large, small in SMALLER:
                command = large.sub(small, command)
            run(command, tmp_path)


def sessions() -> list[tuple[str, str, list[str]]]:
    """Commands with what the page says they print."""
    found = []
    for page in WITH_COMMANDS:
        for kind, text in blocks(page):
            if kind != "console":
                continue
            for part in re.split(r"^\$ ", text, flags=re.MULTILINE)[1:]:
                command, *lines = part.rstrip("\n").split("\n")
                found.append((str(page.relative_to(ROOT)), command, lines))
    return found


@pytest.mark.parametrize(("page", "command", "lines"), sessions())
def test_programs_print_what_the_page_says(page, command, lines, tmp_path):
    printed = [line.rstrip() for line in run(command, tmp_path).splitlines()]
    at = 0
    # What stands before the table may be left out, and what "…" stands for.
    free = True
    for line in lines:
        if line.strip() == "…":
            free = True
            continue
        place = printed.index(line.rstrip(), at) if free and line.rstrip() in printed[at:] else at
        assert printed[place : place + 1] == [line.rstrip()], (
            f"{command} of {page} printed\n" + "\n".join(printed)
        )
        at, free = place + 1, False
    # A page may leave out what follows the table.
    assert free or printed[at : at + 1] in ([], [""]), (
        f"{command} of {page} printed more:\n" + "\n".join(printed[at:])
    )


def test_there_are_sessions_and_commands():
    assert len(sessions()) >= 3
    assert len(WITH_COMMANDS) >= 5


def test_the_keys_of_a_document_are_those_of_the_page(tmp_path):
    page = (ROOT / "docs" / "reference" / "files.md").read_text(encoding="utf-8")
    table = page.partition("## JSON of a motion")[2].partition("\n## ")[0]
    listed = {
        name
        for row in re.findall(r"^\| (`.*?) \|", table, re.MULTILINE)
        for name in re.findall(r"`(\w+)`", row)
    }
    documents = (
        "littlewood simulate figure-3-bounces --format json --samples 3",
        "littlewood simulate figure-3 --particle-mass-kg 0.14 --radius-m 0.45 --si --format json",
    )
    keys = {key for command in documents for key in json.loads(run(command, tmp_path))}
    assert listed == keys
