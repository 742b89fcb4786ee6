import json
import os
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import matplotlib
import pytest

import littlewood as lw

matplotlib.use("agg")

ROOT = Path(__file__).resolve().parents[2]

# Motions with rolling resistance, from a program that has nothing of this one.
RESISTANCE = json.loads((ROOT / "evidence" / "reference" / "resistance.json").read_text())[
    "motions"
]


@pytest.fixture(scope="session")
def binary() -> Path:
    """The command line.

    It is LITTLEWOOD_BIN, or what `cargo build -p littlewood-cli --features full` makes.
    """
    target = Path(os.environ.get("CARGO_TARGET_DIR", ROOT / "target"))
    path = Path(os.environ.get("LITTLEWOOD_BIN", target / "debug" / "littlewood"))
    if not path.is_file():
        pytest.fail(
            f"no command line at {path}: run `cargo build -p littlewood-cli --features full`, or "
            f"set LITTLEWOOD_BIN"
        )
    return path


@pytest.fixture(scope="session")
def command(binary: Path) -> Callable[..., subprocess.CompletedProcess[str]]:
    def run(*arguments: str) -> subprocess.CompletedProcess[str]:
        return subprocess.run([binary, *arguments], capture_output=True, text=True, check=False)

    return run


@pytest.fixture(scope="session")
def command_json(command: Callable[..., subprocess.CompletedProcess[str]]) -> Callable[..., Any]:
    def run(*arguments: str) -> Any:
        done = command(*arguments, "--format", "json")
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    return run


@pytest.fixture
def hoop() -> lw.Hoop:
    """The hoop of Figure 3."""
    return lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)


def resisted_hoop(motion: dict[str, Any]) -> lw.Hoop:
    """The hoop of one of those motions."""
    return lw.Hoop(
        **motion["hoop"], restitution=motion["restitution"], restitution_law=motion["law"]
    )


def flags(**values: float | str) -> list[str]:
    """Values as flags, to the last digit."""
    texts = {
        name: value if isinstance(value, str) else repr(value) for name, value in values.items()
    }
    return [f"--{name.replace('_', '-')}={text}" for name, text in texts.items()]
