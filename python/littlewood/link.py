"""Links of the laboratory: a motion and an instant as the text after `#` in an address, and back."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any
from urllib.parse import quote, unquote

from .cases import case
from .hoop import Hoop
from .tables import HOOP, SI_HOOP, SI_START, START
from .trajectory import Trajectory

__all__ = ["keys_of", "link_of", "motion_of", "time_of"]

_LAW = "restitution_law"
_UNTIL = "until"
_UNTIL_SI = "until_s"
_AT = "at"
_PROBLEM = {"case", _LAW, _UNTIL, _UNTIL_SI, _AT, *HOOP, *START, *SI_HOOP, *SI_START}


def keys_of(link: str) -> dict[str, str]:
    """Split a link into its keys and their texts.

    Parameters
    ----------
    link : str
        The part of an address after `#`; a `#` before it does no harm.

    Returns
    -------
    dict of str to str
    """
    pairs = (part.partition("=") for part in link.removeprefix("#").split("&") if part)
    return {unquote(key): unquote(value) for key, _, value in pairs}


def link_of(motion: Trajectory, time: float, view: Mapping[str, str] | None = None) -> str:
    """Write a motion and an instant as a link, without dimension and with every digit.

    Parameters
    ----------
    motion : Trajectory
        The motion.
    time : float
        The instant, √(R/g).
    view : mapping of str to str, optional
        Keys that say how the page shows it; those of the motion are left out.

    Returns
    -------
    str
    """
    hoop, start = motion.hoop, motion.start
    numbers = {name: getattr(hoop, name) for name in HOOP} | {name: getattr(start, name) for name in START}
    keys = {name: repr(float(value)) for name, value in numbers.items() if value is not None}
    if hoop.law is not None:
        keys[_LAW] = hoop.law
    if motion.until is not None:
        keys[_UNTIL] = repr(float(motion.until))
    if time != start.time:
        keys[_AT] = repr(float(time))
    keys |= {key: value for key, value in (view or {}).items() if key not in _PROBLEM}
    return "&".join(f"{quote(key)}={quote(value)}" for key, value in keys.items())


def motion_of(link: str) -> Trajectory:
    """Simulate the motion of a link.

    Parameters
    ----------
    link : str
        As the page writes it: every number of the hoop and the start, or the name of a case.

    Returns
    -------
    Trajectory

    Raises
    ------
    ValueError
        For a link without a motion, or with a number that cannot be read.
    ParameterError
        For values without physical meaning.
    """
    keys = keys_of(link)
    until = keys.get(_UNTIL, keys.get(_UNTIL_SI))
    limit = None if until is None else float(until)
    if "case" in keys:
        return case(keys["case"]).simulate(until=limit)
    is_si = any(name in keys for name in SI_HOOP if name not in HOOP)
    names = SI_HOOP if is_si else HOOP
    given: dict[str, Any] = {name: float(keys[name]) for name in names if name in keys}
    if not given:
        raise ValueError(f"no motion in the link '{link}'")
    start: dict[str, Any] = {name: float(keys[name]) for name in (SI_START if is_si else START) if name in keys}
    law = keys.get(_LAW)
    if is_si:
        # In Python every number of a start in SI units has its unit in its name, the angle too.
        start["theta_rad"] = start.pop("theta")
        return Hoop.from_si(**given, law=law).simulate_si(**start, until_s=limit)
    return Hoop(**given, law=law).simulate(**start, until=limit)


def time_of(link: str, motion: Trajectory) -> float:
    """Return the instant of a link, √(R/g): the start of the motion if it has none."""
    at = keys_of(link).get(_AT)
    return motion.start.time if at is None else float(at)
