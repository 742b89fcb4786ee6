"""Links of the laboratory: a motion and an instant as the text after `#` in an address, and back."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any
from urllib.parse import quote, unquote

from .cases import CASES, case
from .hoop import Hoop
from .tables import HOOP, QUANTITIES, SI_HOOP, SI_START, START
from .trajectory import Trajectory

__all__ = ["LinkError", "keys_of", "link_of", "motion_of", "time_of"]

_CASE = "case"
_LAW = "restitution_law"
_UNTIL = "until"
_UNTIL_SI = "until_s"
_AT = "at"
_PROBLEM = {_CASE, _LAW, _UNTIL, _UNTIL_SI, _AT, *HOOP, *START, *SI_HOOP, *SI_START}
# How the page shows a motion.
_VIEW = {"rate", "speed", "loop", "map", "shows", "follow", "embed", "theme"}
# What the page shows first: what a link without a case does not say is that of it.
_FIRST = next(iter(CASES.values()))
_NUMBER = re.compile(r"[+-]?([0-9]+\.?[0-9]*|\.[0-9]+)(e[+-]?[0-9]+)?", re.IGNORECASE)
_BAD_PERCENT = re.compile("%(?![0-9a-fA-F]{2})")


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


def _decoded(text: str) -> str:
    """Return a part of a link without its escapes; as it stands, if they are none."""
    if _BAD_PERCENT.search(text):
        return text
    try:
        return unquote(text, errors="strict")
    except UnicodeDecodeError:
        return text


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
    return {_decoded(key): _decoded(value) for key, _, value in pairs}


def _number(keys: Mapping[str, str], key: str) -> float | None:
    """Return the number of a key, as the page reads it; None if the link does not have it."""
    if key not in keys:
        return None
    plain = keys[key].strip().replace("−", "-", 1)
    number = float(plain) if _NUMBER.fullmatch(plain) else math.nan
    if not math.isfinite(number):
        raise LinkError(key, keys[key], "not a number")
    return number


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
        As the page writes it: the name of a case, numbers of the hoop and the start, or both. What is not given is that
        of the case, without one that of the motion which the page shows first; in SI units it has to be there.

    Returns
    -------
    Trajectory

    Raises
    ------
    LinkError
        A ValueError that names the key: one that is not known, a number that cannot be read or is missing, an unknown
        case.
    ValueError
        For a link without a motion.
    ParameterError
        For values without physical meaning.
    """
    keys = keys_of(link)
    for key, text in keys.items():
        if key not in _PROBLEM and key not in _VIEW:
            raise LinkError(key, text, "this key is not known")
    if not any(key in _PROBLEM and key != _AT for key in keys):
        raise ValueError(f"no motion in the link '{link}'")
    base = _FIRST
    if _CASE in keys:
        try:
            base = case(keys[_CASE])
        except KeyError as error:
            raise LinkError(_CASE, keys[_CASE], error.args[0]) from None
    law = keys.get(_LAW, base.hoop.law)
    if any(key in QUANTITIES and QUANTITIES[key].is_si for key in keys):
        return _motion_in_si(keys, base.hoop.restitution, law)
    hoop: dict[str, Any] = {name: getattr(base.hoop, name) for name in HOOP}
    start: dict[str, Any] = dict(vars(base.start))
    for values in (hoop, start):
        values.update({name: number for name in values if (number := _number(keys, name)) is not None})
    return Hoop(**hoop, law=law).simulate(**start, until=_number(keys, _UNTIL))


def _motion_in_si(keys: Mapping[str, str], restitution: float | None, law: str | None) -> Trajectory:
    """Simulate a motion in SI units. Of a case it has what has no unit and may be left out."""

    def given(names: tuple[str, ...]) -> dict[str, Any]:
        numbers = {}
        for name in names:
            number = _number(keys, name)
            row = QUANTITIES[name]
            if number is None and row.default is None and not row.is_optional:
                raise LinkError(name, "", "the link does not give it")
            numbers[name] = row.default if number is None else number
        return numbers

    for key, text in keys.items():
        if key in QUANTITIES and key not in {*SI_HOOP, *SI_START, _UNTIL_SI}:
            raise LinkError(key, text, "it is not in SI units, as the rest of the link is")
    hoop, start = given(SI_HOOP), given(SI_START)
    if hoop["restitution"] is None:
        hoop["restitution"] = restitution
    # In Python every number of a start in SI units has its unit in its name, the angle too.
    start["theta_rad"] = start.pop("theta")
    return Hoop.from_si(**hoop, law=law).simulate_si(**start, until_s=_number(keys, _UNTIL_SI))


def time_of(link: str, motion: Trajectory) -> float:
    """Return the instant of a link, √(R/g): the start of the motion if it has none."""
    at = _number(keys_of(link), _AT)
    return motion.start.time if at is None else at
