"""Certificates: a motion in balls, as JSON."""

from __future__ import annotations

import json
from typing import Any

from .balls import Ball, Beyond, Undecided, arb, ball, precision, text
from .body import Body, State
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
        The certificate. Where something is not decided at the last precision, its `certified` is false and `reason`
        says what.
    """
    reason = "no precision is allowed"
    for bits in PRECISIONS:
        if bits > most_bits:
            break
        try:
            with precision(bits):
                return _sealed(_written(case, Walk(case)))
        except Undecided as undecided:
            reason = f"{undecided} with {bits} bits"
        except Beyond as beyond:
            reason = str(beyond)
            break
    return _sealed({"format": FORMAT, "version": VERSION, "certified": False, "reason": reason, "case": case.written()})


def dump(certificate: dict[str, Any]) -> str:
    """Return the text of a certificate: each event, phase and sample has a line."""
    return _lines(certificate, 2) + "\n"


def _lines(value: Any, depth: int) -> str:
    if depth and isinstance(value, dict) and value:
        return "{\n" + ",\n".join(f"{json.dumps(k)}: {_lines(v, depth - 1)}" for k, v in value.items()) + "\n}"
    if depth and isinstance(value, list) and value and isinstance(value[0], dict):
        return "[\n" + ",\n".join(_lines(one, 0) for one in value) + "\n]"
    return json.dumps(value, separators=(",", ":"))


def _sealed(certificate: dict[str, Any]) -> dict[str, Any]:
    return certificate | {"digest": digest(certificate)}


class Scales:
    """The units in which a certificate is written."""

    def __init__(self, case: Case) -> None:
        mass, length, gravity = (ball(scale) for scale in case.scales())
        self.time = (length / gravity).sqrt()
        self.of = {
            "time": self.time,
            "theta": arb(1),
            "theta_rate": 1 / self.time,
            "slip": length / self.time,
            "x": length,
            "gap": length,
            "gap_rate": length / self.time,
            "energy": mass * gravity * length,
            "energy_lost": mass * gravity * length,
            "normal": mass * gravity,
            "friction": mass * gravity,
            "normal_impulse": mass * length / self.time,
            "friction_impulse": mass * length / self.time,
            "period": self.time,
        }

    def text(self, name: str, value: Ball, where: str) -> list[str]:
        """Return the text of a quantity."""
        return _text(value * self.of[name], f"{name} of {where}")


def _text(value: Ball, what: str) -> list[str]:
    try:
        return text(value)
    except Undecided as undecided:
        raise Undecided(f"{undecided}: {what}") from None


def _written(case: Case, walk: Walk) -> dict[str, Any]:
    scales = Scales(case)
    motion = walk.follow()
    body = motion.body
    sliding = sum((_lost(body, p) for p in motion.phases), arb(0))
    impacts = sum((e.impact.lost for e in motion.events if e.impact is not None), arb(0))
    energies = {"start": body.energy(walk.state), "lost_in_slides": sliding, "lost_in_impacts": impacts}
    return {
        "format": FORMAT,
        "version": VERSION,
        "certified": True,
        "case": case.written(),
        "initial": {
            "mode": motion.initial.mode,
            "direction": motion.initial.direction,
            "evidence": _evidence(motion.initial.evidence, "the start"),
        },
        "phases": [_phase(scales, body, phase, f"phase {k}") for k, phase in enumerate(motion.phases)],
        "events": [_event(scales, body, event, f"event {k}") for k, event in enumerate(motion.events)],
        "end": _end(scales, motion),
        "energy": {name: scales.text("energy", value, f"{name} in all") for name, value in energies.items()},
    }


def _lost(body: Body, phase: Phase) -> Ball:
    if phase.mode != "sliding" or phase.end is None:
        return arb(0)
    return body.energy(phase.start) - body.energy(phase.end)


def _evidence(numbers: dict[str, Ball], where: str) -> dict[str, list[str]]:
    return {name: _text(value, f"{name} of {where}") for name, value in numbers.items()}


def _state(scales: Scales, body: Body, state: State, where: str) -> dict[str, list[str]]:
    values = {
        "time": state.time,
        "theta": state.theta,
        "theta_rate": state.rate,
        "slip": state.slip,
        "x": state.x,
        "gap": state.gap,
        "gap_rate": state.gap_rate,
        "energy": body.energy(state),
    }
    if state.rate.is_nan():
        # The particle is at the plane: θ′ is infinite there, and its energy is that of before.
        del values["theta_rate"], values["energy"]
    return {name: scales.text(name, value, where) for name, value in values.items()}


def _phase(scales: Scales, body: Body, phase: Phase, where: str) -> dict[str, Any]:
    samples = [
        _state(scales, body, state, where)
        | {
            "normal": scales.text("normal", normal, where),
            "friction": scales.text("friction", friction, where),
        }
        for state, normal, friction in phase.samples
    ]
    return {"mode": phase.mode, "direction": phase.direction, "samples": samples}


def _event(scales: Scales, body: Body, event: Event, where: str) -> dict[str, Any]:
    written: dict[str, Any] = {
        "cause": event.cause,
        "to": event.to,
        "direction": event.direction,
        "state": _state(scales, body, event.after, where),
        "evidence": _evidence(event.evidence, where),
    }
    if event.impact is not None:
        hit = event.impact
        written["impact"] = {
            "case": hit.case,
            "normal_impulse": scales.text("normal_impulse", hit.normal, where),
            "friction_impulse": scales.text("friction_impulse", hit.friction, where),
            "energy_lost": scales.text("energy_lost", hit.lost, where),
        }
        if event.cause != "settle":
            before = _state(scales, body, event.before, f"before {where}")
            written["impact"]["before"] = {name: before[name] for name in ("theta_rate", "slip", "gap_rate")}
    return written


def _end(scales: Scales, motion: Motion) -> dict[str, Any]:
    end: dict[str, Any] = {"kind": motion.ending}
    if motion.end is not None:
        end["state"] = _state(scales, motion.body, motion.end, "the end")
    for name, value in motion.detail.items():
        end[name] = value if isinstance(value, str) else scales.text(name, value, "the end")
    return end
