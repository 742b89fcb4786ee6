"""Links of the laboratory.

A motion and an instant as the text after `#` in an address, and back.
"""

from __future__ import annotations

from .. import _core
from ..hoop import Hoop
from ..trajectory import Trajectory
from ..units import Units

__all__ = ["LinkError", "link_of", "motion_of", "time_of"]


class LinkError(ValueError):
    """A link of which a key, or the text of one, has no meaning.

    Attributes
    ----------
    key : str
        The key.
    text : str
        What the link says there.
    """

    def __init__(self, key: str, text: str, reason: str) -> None:
        super().__init__(f"{key}={text}: {reason}")
        self.key = key
        self.text = text


def _read(link: str) -> tuple[bool, float | None]:
    """Return whether a link says anything of a motion, and its instant.

    Refuse one that cannot be read.
    """
    read = _core.read_link(link)
    if read["refusal"] is not None:
        raise LinkError(**read["refusal"])
    return read["has_problem"], read["at"]


def link_of(motion: Trajectory, time: float, shown: str = "") -> str:
    """Write a motion and an instant as a link, without dimension and with every digit.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    time : float
        The instant, √(R/g).
    shown : str, optional
        A link with settings of the page.

    Returns
    -------
    str
    """
    at = None if time == motion.start.time else time
    return _core.write_link(motion.hoop._given, motion.start.numbers, motion.until, at, shown)


def motion_of(link: str) -> Trajectory:
    """Simulate the motion of a link.

    Parameters
    ----------
    link : str
        As the page writes it: the name of a case, numbers of the hoop and the start, or both. What
        is not given is that of the case, without one that of the motion which the page shows first;
        in SI units it has to be there.

    Returns
    -------
    Trajectory

    Raises
    ------
    LinkError
        A ValueError that names the key: one that is not known, a number that cannot be read or is
        missing, an unknown case.
    ValueError
        For a link without a motion.
    ParameterError
        For values without physical meaning.
    """
    if not _read(link)[0]:
        raise ValueError(f"no motion in the link '{link}'")
    found = _core.problem_of_link(link)
    units = None if found["units"] is None else Units(**found["units"])
    hoop = Hoop(**found["hoop"], restitution_law=found["restitution_law"], units=units)
    return hoop.simulate(**found["start"], until=found["until"])


def time_of(link: str, motion: Trajectory) -> float:
    """Return the instant of a link, √(R/g): the start of the motion if it has none."""
    at = _read(link)[1]
    return motion.start.time if at is None else at
