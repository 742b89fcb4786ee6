"""Certificates: a motion in balls, as JSON."""

from __future__ import annotations

import hashlib
import json
from typing import Any

from .balls import Ball, Beyond, Undecided, arb, ball, precision, text
from .body import Body, State
from .case import Case
from .motion import Event, Motion, Phase, Walk

FORMAT = "littlewood-certificate"
VERSION = 1

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
        except RecursionError:
            reason = f"intervals are divided without end with {bits} bits"
    return _sealed({"format": FORMAT, "version": VERSION, "certified": False, "reason": reason, "case": case.written()})


def digest(certificate: dict[str, Any]) -> str:
    """Return the SHA-256 of a certificate without its digest."""
    rest = {key: value for key, value in certificate.items() if key != "digest"}
    return hashlib.sha256(json.dumps(rest, sort_keys=True, separators=(",", ":")).encode()).hexdigest()


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

    def text(self, name: str, value: Ball) -> list[str]:
        """Return the text of a quantity."""
        return text(value * self.of[name])


def _written(case: Case, walk: Walk) -> dict[str, Any]:
    scales = Scales(case)
    motion = walk.follow()
    body = motion.body
    sliding = sum((_lost(body, p) for p in motion.phases), arb(0))
    impacts = sum((e.impact.lost for e in motion.events if e.impact is not None), arb(0))
    start = body.energy(walk.state)
    return {
        "format": FORMAT,
        "version": VERSION,
        "certified": True,
        "case": case.written(),
        "initial": {
            "mode": motion.initial.mode,
            "direction": motion.initial.direction,
            "evidence": _evidence(motion.initial.evidence),
        },
        "phases": [_phase(scales, body, phase) for phase in motion.phases],
        "events": [_event(scales, body, event) for event in motion.events],
        "end": _end(scales, motion),
        "energy": {
            "start": scales.text("energy", start),
            "lost_in_slides": scales.text("energy", sliding),
            "lost_in_impacts": scales.text("energy", impacts),
        },
    }


def _lost(body: Body, phase: Phase) -> Ball:
    if phase.mode != "sliding" or phase.end is None:
        return arb(0)
    return body.energy(phase.start) - body.energy(phase.end)


def _evidence(numbers: dict[str, Ball]) -> dict[str, list[str]]:
    return {name: text(value) for name, value in numbers.items()}


def _state(scales: Scales, body: Body, state: State) -> dict[str, list[str]]:
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
    return {name: scales.text(name, value) for name, value in values.items()}


def _phase(scales: Scales, body: Body, phase: Phase) -> dict[str, Any]:
    samples = [
        _state(scales, body, state)
        | {"normal": scales.text("normal", normal), "friction": scales.text("friction", friction)}
        for state, normal, friction in phase.samples
    ]
    return {"mode": phase.mode, "direction": phase.direction, "proof": phase.proof, "samples": samples}


def _event(scales: Scales, body: Body, event: Event) -> dict[str, Any]:
    written: dict[str, Any] = {
        "cause": event.cause,
        "to": event.to,
        "direction": event.direction,
        "state": _state(scales, body, event.after),
        "evidence": _evidence(event.evidence),
    }
    if event.impact is not None:
        hit = event.impact
        written["impact"] = {
            "case": hit.case,
            "normal_impulse": scales.text("normal_impulse", hit.normal),
            "friction_impulse": scales.text("friction_impulse", hit.friction),
            "energy_lost": scales.text("energy_lost", hit.lost),
        }
        if event.cause != "settle":
            before = _state(scales, body, event.before)
            written["impact"]["before"] = {name: before[name] for name in ("theta_rate", "slip", "gap_rate")}
    return written


def _end(scales: Scales, motion: Motion) -> dict[str, Any]:
    end: dict[str, Any] = {"kind": motion.ending}
    if motion.end is not None:
        end["state"] = _state(scales, motion.body, motion.end)
    for name, value in motion.detail.items():
        end[name] = value if isinstance(value, str) else scales.text(name, value)
    return end
