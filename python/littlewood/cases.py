"""The motions that the paper shows or speaks of, and some that go on after it, by name."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from dataclasses import dataclass

from . import _core
from ._frozen import Frozen
from .hoop import Hoop
from .motion import Start
from .trajectory import Trajectory

__all__ = ["CASES", "Case", "case"]


@dataclass(frozen=True)
class Case:
    """A motion with a name: a hoop and a start.

    Attributes
    ----------
    name : str
        Name, as the command line takes it.
    title : str
        The motion in words.
    source : str
        Where the paper has it, if it does.
    hoop : Hoop
        The hoop.
    start : littlewood.Start
        The start.
    """

    name: str
    title: str
    source: str
    hoop: Hoop
    start: Start

    def simulate(self, *, until: float | None = None) -> Trajectory:
        """Follow the motion to its end, or until a time τ in √(R/g).

        Parameters
        ----------
        until : float, optional
            Time at which to stop, √(R/g).

        Returns
        -------
        Trajectory
        """
        return self.hoop.simulate(**vars(self.start), until=until)


def _case(given: _core._Case) -> Case:
    hoop = Hoop(**given["hoop"], restitution_law=given["restitution_law"])
    return Case(
        name=given["name"],
        title=given["title"],
        source=given["source"],
        hoop=hoop,
        start=Start(**given["start"]),
    )


CASES: Mapping[str, Case] = Frozen({one["name"]: _case(one) for one in _core.cases()})
"""All cases by their names."""


def case(name: str) -> Case:
    """Return the case of this name.

    Parameters
    ----------
    name : str
        A key of :data:`CASES`, or `libration`, which is short for `figure-2-libration`.

    Returns
    -------
    littlewood.cases.Case

    Raises
    ------
    KeyError
        If there is none; the message suggests similar names.
    """
    found = _core.name_of_case(name)
    if found is None:
        nearest = difflib.get_close_matches(name, CASES, cutoff=0.5) or list(CASES)
        names = " or ".join(repr(one) for one in nearest)
        raise KeyError(f"there is no case named {name!r}; did you mean {names}?")
    return CASES[found]
