"""The cases by which solvers are scored.

Those of the data set, of which the benchmark is a part, by name.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from importlib.resources import files
from types import MappingProxyType
from typing import Any

from ..certify.compare import simulated
from ..trajectory import Trajectory

__all__ = ["BENCHMARK", "CASES", "CATEGORIES", "VERSION", "BenchmarkCase"]


@dataclass(frozen=True)
class BenchmarkCase:
    """A hoop, a start and a time at which to stop, as a certificate has them.

    Attributes
    ----------
    name : str
        Its name, also that of its certificate.
    given : mapping
        The case as the file has it.
    what : str
        The motion in words; empty for a case that is not of the benchmark.
    category : str
        What it tests, a key of :data:`CATEGORIES`; empty for a case that is not of the benchmark.
    """

    name: str
    given: Mapping[str, Any]
    what: str = ""
    category: str = ""

    @cached_property
    def motion(self) -> Trajectory:
        """The exact motion."""
        return simulated(self.given)


_FILE: Mapping[str, Any] = json.loads(
    (files(__package__) / "cases.json").read_text(encoding="utf-8")
)

VERSION: str = _FILE["version"]
"""Version of the cases.

A name stands for the same motion as long as its first number does not change.
"""

CATEGORIES: Mapping[str, str] = MappingProxyType(_FILE["categories"])
"""What the benchmark tests: names, and what they mean."""

CASES: Mapping[str, BenchmarkCase] = MappingProxyType(
    {
        one["name"]: BenchmarkCase(one["name"], one, **_FILE["benchmark"].get(one["name"], {}))
        for one in _FILE["cases"]
    }
)
"""All cases by name."""

BENCHMARK: Mapping[str, BenchmarkCase] = MappingProxyType(
    {name: CASES[name] for name in _FILE["benchmark"]}
)
"""Those that engines run, in their order."""
