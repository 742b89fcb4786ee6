"""Certificates: a motion in balls, as JSON."""

from __future__ import annotations

import json
from typing import Any

from .balls import Ball, Beyond, Undecided, arb, precision, text
from .body import Next, State
from .case import Case
from .checker import digest
from .motion import Event, Motion, Phase, Walk

FORMAT = "littlewood-certificate"
VERSION = 2

PRECISIONS = (144, 224, 384, 640, 1000)
"""Bits that are tried, one after the other, until every sign and every digit is decided."""


def certify(case: Case, most_bits: int = PRECISIONS[-1]) -> dict[str, Any]:
    """Follow a motion with enclosures of all its numbers.

    Parameters
    ----------
    case : Case
        The hoop and the start.
    most_bits : int, optional
        Precision at which to give up.

    Returns
    -------
    dict
        The certificate. Where something is not decided at the last precision, its `certified` is
        false and `reason` says what.
    """
    reason = "no precision is allowed"
    for bits in PRECISIONS:
        if bits > most_bits:
            break
        try:
            with precision(bits):
                return _sealed(_Writer(case).written())
        except Undecided as undecided:
            reason = f"{undecided} with {bits} bits"
        except Beyond as beyond:
            reason = str(beyond)
            break
    return _sealed(
        {
            "format": FORMAT,
            "version": VERSION,
            "certified": False,
            "reason": reason,
            "case": case.written(),
        }
    )


def dump(certificate: dict[str, Any]) -> str:
    """Return the text of a certificate: each event, phase and sample has a line."""
    return _lines(certificate, 2) + "\n"


def _lines(value: Any, depth: int) -> str:
    if depth and isinstance(value, dict) and value:
        return (
            "{\n"
            + ",\n".join(f"{json.dumps(k)}: {_lines(v, depth - 1)}" for k, v in value.items())
            + "\n}"
        )
    if depth and isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join(_lines(one, 0) for one in value) + "\n]"
    return json.dumps(value, separators=(",", ":"))


def _sealed(certificate: dict[str, Any]) -> dict[str, Any]:
    return certificate | {"digest": digest(certificate)}


def _text(value: Ball, what: str) -> list[str]:
    try:
        return text(value)
    except Undecided as undecided:
        raise Undecided(f"{undecided}: {what}") from None


class _Writer:
    """Writes a motion in the units of its case."""

    def __init__(self, case: Case) -> None:
        self.case, self.walk = case, Walk(case)

    def written(self) -> dict[str, Any]:
        """Return the certificate, but for its digest."""
        motion, energy = self.walk.follow(), self.walk.body.energy
        initial = motion.initial
        sliding = sum(
            (
                energy(one.start) - energy(one.end) - one.resisted
                for one in motion.phases
                if one.mode in ("sliding", "skidding") and one.end is not None
            ),
            arb(0),
        )
        impacts = sum((one.impact.lost for one in motion.events if one.impact is not None), arb(0))
        energies = {
            "start": energy(self.walk.start),
            "lost_in_slides": sliding,
            "lost_in_impacts": impacts,
        }
        if self.walk.body.resists:
            energies["lost_in_rolling_resistance"] = sum(
                (one.resisted for one in motion.phases), arb(0)
            )
        return {
            "format": FORMAT,
            "version": VERSION,
            "certified": True,
            "case": self.case.written(),
            "initial": {
                "mode": initial.mode,
                "direction": initial.direction,
                **self._rotation(initial),
                "evidence": self._evidence(initial.evidence, "the start"),
            },
            "phases": [self._phase(phase, f"phase {k}") for k, phase in enumerate(motion.phases)],
            "events": [self._event(event, f"event {k}") for k, event in enumerate(motion.events)],
            "end": self._end(motion),
            "energy": {
                name: self._number("energy", value, f"{name} in all")
                for name, value in energies.items()
            },
        }

    def _rotation(self, one: Next | Phase | Event) -> dict[str, int]:
        return {"rotation": one.rotation} if self.walk.body.resists else {}

    def _number(self, name: str, value: Ball, where: str) -> list[str]:
        return _text(value * self.walk.scale[name], f"{name} of {where}")

    def _numbers(self, values: dict[str, Ball], where: str) -> dict[str, list[str]]:
        return {name: self._number(name, value, where) for name, value in values.items()}

    def _evidence(self, numbers: dict[str, Ball], where: str) -> dict[str, list[str]]:
        return {name: _text(value, f"{name} of {where}") for name, value in numbers.items()}

    def _state(self, state: State, where: str) -> dict[str, list[str]]:
        values = {
            "time": state.time,
            "theta": state.theta,
            "theta_rate": state.rate,
            "slip": state.slip,
            "x": state.x,
            "gap": state.gap,
            "gap_rate": state.gap_rate,
            "energy": self.walk.body.energy(state),
        }
        if state.rate.is_nan():
            # The particle is at the plane: θ′ is infinite there, and its energy is that of before.
            del values["theta_rate"], values["energy"]
        return self._numbers(values, where)

    def _phase(self, phase: Phase, where: str) -> dict[str, Any]:
        samples = [
            self._state(state, where)
            | self._numbers(
                dict(zip(("normal", "friction", "couple"), forces, strict=False)), where
            )
            for state, forces in phase.samples
        ]
        return {
            "mode": phase.mode,
            "direction": phase.direction,
            **self._rotation(phase),
            "samples": samples,
        }

    def _event(self, event: Event, where: str) -> dict[str, Any]:
        written: dict[str, Any] = {
            "cause": event.cause,
            "to": event.to,
            "direction": event.direction,
            **self._rotation(event),
            "state": self._state(event.after, where),
            "evidence": self._evidence(event.evidence, where),
        }
        if event.impact is not None:
            hit = event.impact
            numbers = {
                "normal_impulse": hit.normal,
                "friction_impulse": hit.friction,
                "energy_lost": hit.lost,
            }
            written["impact"] = {"case": hit.case, **self._numbers(numbers, where)}
            if event.cause != "settle":
                before = self._state(event.before, f"before {where}")
                written["impact"]["before"] = {
                    name: before[name] for name in ("theta_rate", "slip", "gap_rate")
                }
        return written

    def _end(self, motion: Motion) -> dict[str, Any]:
        end: dict[str, Any] = {"kind": motion.ending}
        if motion.end is not None:
            end["state"] = self._state(motion.end, "the end")
        if motion.half_swings is not None:
            end["half_swings"] = motion.half_swings
        if motion.recurrence:
            end["recurrence"] = motion.recurrence
        if motion.period is not None:
            end["period"] = self._number("period", motion.period, "the end")
        return end
