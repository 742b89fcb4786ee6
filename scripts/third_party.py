"""Prints the licences of all crates that the program for a target is made of.

The target is the argument; each has its notices.
"""

import json
import subprocess
import sys
from pathlib import Path


def metadata(target: str) -> dict:
    command = [
        "cargo",
        "metadata",
        "--format-version",
        "1",
        "--locked",
        "--all-features",
        "--filter-platform",
        target,
    ]
    return json.loads(subprocess.run(command, check=True, capture_output=True).stdout)


def linked(graph: dict, root: str) -> set[str]:
    """The packages that a program is linked with.

    Neither those that build it nor those that test it.
    """
    nodes = {node["id"]: node for node in graph["resolve"]["nodes"]}
    found: set[str] = set()
    waiting = [next(package["id"] for package in graph["packages"] if package["name"] == root)]
    while waiting:
        name = waiting.pop()
        if name in found:
            continue
        found.add(name)
        for edge in nodes[name]["deps"]:
            if any(kind["kind"] is None for kind in edge["dep_kinds"]):
                waiting.append(edge["pkg"])
    return found


def notices(package: dict) -> list[Path]:
    folder = Path(package["manifest_path"]).parent
    names = ("license", "licence", "copying", "notice", "copyright", "unlicense")
    return sorted(
        path for path in folder.iterdir() if path.is_file() and path.name.lower().startswith(names)
    )


def main() -> None:
    graph = metadata(sys.argv[1])
    inside = linked(graph, "littlewood-cli")
    for package in sorted(graph["packages"], key=lambda package: package["name"]):
        if package["id"] not in inside or package["source"] is None:
            continue
        print(f"==== {package['name']} {package['version']}: {package['license'] or 'see below'}")
        for path in notices(package):
            print(f"---- {path.name}\n{path.read_text(encoding='utf-8', errors='replace').strip()}")
        print()


main()
