"""The modules of the package.

Which names users see, and that none import each other in a circle.
"""

import ast
import subprocess
import sys
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import littlewood as lw

PACKAGE = Path(lw.__file__).parent
# A motion hands out the hoop that it is of, and a hoop makes motions: the types of both are what
# users name.
TYPE_OF_THE_HOOP = ("trajectory", "hoop")
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


def _name(file):
    """Return the name of a module within the package; "" for the package itself."""
    return (
        ".".join(file.relative_to(PACKAGE).with_suffix("").parts)
        .removesuffix("__init__")
        .removesuffix(".")
    )


MODULES = {_name(file): file for file in sorted(PACKAGE.rglob("*.py"))}


def _statements(node):
    """Yield what runs when a module is imported, or a type checker reads it.

    Nothing within functions.
    """
    for child in ast.iter_child_nodes(node):
        if not isinstance(child, FUNCTIONS):
            yield child
            yield from _statements(child)


def _imported(module):
    """Return the modules that one imports, by itself or for its types."""
    file = MODULES[module]
    folder = file.relative_to(PACKAGE).parent.parts
    found = set()
    for node in _statements(ast.parse(file.read_text(encoding="utf-8"))):
        assert not (
            isinstance(node, ast.Import) and any("littlewood" in one.name for one in node.names)
        )
        if not isinstance(node, ast.ImportFrom):
            continue
        assert node.level or (node.module or "").partition(".")[0] != "littlewood", file
        if node.level:
            base = [
                *folder[: len(folder) + 1 - node.level],
                *([node.module] if node.module else []),
            ]
            for one in node.names:
                inner = ".".join([*base, one.name])
                # The compiled module imports nothing.
                if inner != "_core" and base != ["_core"]:
                    found.add(inner if inner in MODULES else ".".join(base))
    return found - {module}


IMPORTS = {module: _imported(module) for module in MODULES}


def _rooms():
    rooms = {}
    for module, imported in IMPORTS.items():
        room = module.partition(".")[0]
        others = {one.partition(".")[0] for one in imported} - {room}
        rooms.setdefault(room, set()).update(others)
    return rooms


@pytest.mark.parametrize("graph", [IMPORTS, _rooms()], ids=["files", "rooms"])
def test_none_import_each_other_in_a_circle(graph):
    module, imported = TYPE_OF_THE_HOOP
    assert imported in graph[module]
    graph = graph | {module: graph[module] - {imported}}
    assert {one for many in graph.values() for one in many} <= set(graph)
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        pytest.fail(" imported by ".join(error.args[1]))


def test_a_circle_would_be_found():
    assert IMPORTS["hoop"] >= {"trajectory", "phase_plane", "_html", "_internal.elementwise"}
    assert "certify" in IMPORTS[""], "imports for types count"
    assert "lab" not in IMPORTS["trajectory"], "those within functions do not"
    with pytest.raises(CycleError):
        TopologicalSorter(IMPORTS).prepare()


def test_dir_shows_what_a_user_needs_and_nothing_else():
    modules = {
        "bouncing",
        "certify",
        "closed_form",
        "fitting",
        "lab",
        "motion",
        "phase_plane",
        "plot",
    }
    modules |= {"scoring", "style", "tables", "video"}
    classes = {
        "FitResult",
        "Hoop",
        "Noise",
        "ParameterError",
        "Samples",
        "Start",
        "Track",
        "Trajectory",
    }
    functions = {"case", "fit", "outcome_map", "sequence_names", "simulate_many", "track_video"}
    expected = sorted(modules | classes | functions | {"CASES", "Units", "__version__"})
    assert dir(lw) == sorted(lw.__all__) == expected
    assert all(getattr(lw, name) is not None for name in expected)
    with pytest.raises(AttributeError, match="has no attribute 'many'"):
        lw.many  # noqa: B018


def test_a_motion_needs_none_of_the_rooms():
    script = (
        "import sys, littlewood as lw\n"
        "str(lw.case('figure-3').simulate())\n"
        "print(*sorted({m.split('.')[1] for m in sys.modules if m.startswith('littlewood.')}))"
    )
    done = subprocess.run(
        [sys.executable, "-c", script], capture_output=True, text=True, check=True
    )
    rooms = {"certify", "fitting", "lab", "plot", "scoring", "sweep", "video", "_commands"}
    assert not rooms & set(done.stdout.split())
