"""evidence/engines/run.py as a module."""

import importlib.util
import sys
from pathlib import Path

import pytest


@pytest.fixture(scope="session")
def run():
    path = Path(__file__).resolve().parents[1] / "run.py"
    specification = importlib.util.spec_from_file_location("engines_run", path)
    module = importlib.util.module_from_spec(specification)
    sys.modules[specification.name] = module
    specification.loader.exec_module(module)
    return module
