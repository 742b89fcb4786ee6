"""A study: one question, with the tables and pictures of its page."""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from matplotlib.figure import Figure

PAGES = Path(__file__).parents[2] / "docs" / "studies"

NAMES = (
    "one-angle",
    "jam",
    "massless-limit",
    "best-hop",
    "bouncing-for-ever",
    "slip-before-jump",
    "bounces-out-of-nothing",
    "how-many-slips",
    "band",
    "gradients-through-contact",
    "real-film",
    "doubted-fits",
    "measured-data",
    "telephone",
    "sequences",
    "rolling-resistance",
    "mujoco-cone",
)
"""All studies, in the order of their index; each is a module of this package."""


@dataclass(frozen=True, kw_only=True)
class Study:
    """What a page takes from its computation.

    Parameters
    ----------
    name : str
        Name of the page in docs/studies, and of the folder of its pictures.
    texts : mapping of str to callable
        What stands between the marks of a label: lines of a table, or one number in a sentence.
    pictures : mapping of str to callable
        Figures by the names of their files.
    files : mapping of str to callable
        Texts of files beside the pictures, by their names.
    """

    name: str
    texts: Mapping[str, Callable[[], list[str] | str]]
    pictures: Mapping[str, Callable[[], Figure]]
    files: Mapping[str, Callable[[], str]] = field(default_factory=dict)

    @property
    def page(self) -> Path:
        """The page."""
        return PAGES / f"{self.name}.md"

    @property
    def folder(self) -> Path:
        """Where its pictures are."""
        return PAGES / self.name


def load(name: str) -> Study:
    """Import a study of `NAMES`."""
    study: Study = importlib.import_module(f".{name.replace('-', '_')}", __package__).STUDY
    return study
