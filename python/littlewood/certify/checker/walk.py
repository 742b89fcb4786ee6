"""A motion followed again from its start, each of its parts held against the certificate as soon as it is found."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from .body import State
from .bounces import SLOWEST, rest_of_bounces
from .decide import AMBIGUOUS, INCONSISTENT, Next, decide
from .digits import text_of
from .follow import Followed, follow
from .given import Given
from .impact import impact
from .phase import (
    CONTACT,
    FLIGHT,
    GAP,
    GLIDING,
    NORMAL,
    PLANE,
    SLIDING,
    SLIP,
    SOLVABLE,
    TIME,
    UP,
    Phase,
    energy,
)
from .ranges import Inconclusive, Range, exceeds, sine_and_cosine


class Refused(Exception):
    """What in a certificate is not so."""


class Walk:
    """Follows one motion."""

    def __init__(self, certificate: Mapping[str, Any]) -> None:
        self.certificate, self.given = certificate, Given(certificate["case"])
        self.phases, self.events, self.numbers = 0, 0, 0
        self.slides, self.impacts = Range(0), Range(0)

    def same(self, found: Any, claimed: Any, where: str, name: str = "") -> None:
        """Compare what is found with what is claimed: a number passes if its text is the same."""
        if isinstance(found, Range):
            scale = self.given.scale.get(name)
            found = text_of(found if scale is None else found * scale)
            self.numbers += 1
            if found != claimed:
                raise Refused(f"{where} is {' ± '.join(found)}, not {claimed}")
        elif isinstance(found, dict):
            if set(found) != set(claimed):
                raise Refused(f"{where} has {', '.join(sorted(found))}, not {', '.join(sorted(claimed))}")
            for key, value in found.items():
                self.same(value, claimed[key], f"{key} of {where}", "" if where.startswith("evidence") else key)
        elif found != claimed or type(found) is not type(claimed):
            raise Refused(f"{where} is {found}, not {claimed}")

    def of(self, state: State) -> dict[str, Range]:
        """Return a state as a certificate has it."""
        return {
            "time": state.time, "theta": state.theta, "theta_rate": state.rate, "slip": state.slip, "x": state.x,
            "gap": state.gap, "gap_rate": state.gap_rate, "energy": energy(self.given.body, state),
        }  # fmt: skip

    def follow(self) -> dict[str, int]:
        """Follow the motion to its end; return how much has been compared."""
        given, claimed = self.given, self.certificate
        state = given.start
        now = decide(given, state) if state.gap_rate.is_zero() else _opening(state)
        initial = {"mode": now.mode, "direction": now.direction, "evidence": now.evidence}
        self.same(initial, claimed["initial"], "the start")
        start = energy(given.body, state)
        end: dict[str, Any] | None = None
        while end is None:
            if now.mode == INCONSISTENT and given.restitution is not None:
                state, now = self.hit("jam", state)
            elif now.mode in (INCONSISTENT, AMBIGUOUS):
                end = {"kind": now.mode, "state": self.of(state)}
            elif now.mode == FLIGHT and self.claimed("events").get("cause") == "settle":
                state, now = self.settle(state)
            else:
                state, now, end = self.pass_phase(state, now)
        self.same(end, claimed["end"], "the end")
        if (self.phases, self.events) != (len(claimed["phases"]), len(claimed["events"])):
            raise Refused("the certificate has more phases or events than the motion")
        energies = {"start": start, "lost_in_slides": self.slides, "lost_in_impacts": self.impacts}
        self.same(energies, claimed["energy"], "energy")
        return {"phases": self.phases, "events": self.events, "numbers": self.numbers}

    def claimed(self, part: str) -> Mapping[str, Any]:
        """Return what the certificate has as the next phase or event."""
        number, parts = getattr(self, part), self.certificate[part]
        return parts[number] if number < len(parts) else {}

    def event(self, cause: str, state: State, following: Next | None, **more: Any) -> None:
        """Compare the next event."""
        evidence = more.pop("evidence", {})
        found = {"cause": cause, "to": None, "direction": 0, "evidence": evidence, "state": self.of(state)} | more
        if following is not None:
            found |= {"to": following.mode, "direction": following.direction, "evidence": evidence | following.evidence}
        if cause == "particle_at_plane":
            # θ′ is infinite there.
            del found["state"]["theta_rate"], found["state"]["energy"]
        self.same(found, self.claimed("events"), f"event {self.events}")
        self.events += 1

    def pass_phase(self, state: State, now: Next) -> tuple[State, Next, dict[str, Any] | None]:
        """Follow and compare a phase, and the event at its end."""
        given = self.given
        phase = Phase(given, state, now.mode, now.direction, now.order)
        claimed = self.claimed("phases")
        times = [Range.of(Fraction(one["time"][0])) / given.clock for one in claimed["samples"]]
        run = follow(given, phase, times[-1] if times else None)
        self.same_phase(run, claimed, times)
        if run.end is None:
            turn = run.turn
            kind = "rest" if turn is None else "libration" if turn.angle.is_zero() else "rotation"
            found: dict[str, Any] = {"kind": "rolls_forever", "recurrence": kind}
            return state, now, found if turn is None else found | {"period": turn.period}
        end = run.end
        if now.mode == SLIDING:
            self.slides += energy(given.body, state) - energy(given.body, end)
        if run.guard == TIME:
            return end, now, {"kind": TIME, "state": self.of(end)}
        if run.guard == GAP and given.restitution is not None:
            return *self.hit("landing", end), None
        if run.guard == GAP:
            self.event("landing", end, None, evidence={"gap_rate": end.gap_rate})
            return end, now, {"kind": "landing", "state": self.of(end)}
        if run.guard == PLANE:
            self.event("particle_at_plane", end, None)
            found = self.of(end)
            del found["theta_rate"], found["energy"]
            return end, now, {"kind": "particle_at_plane", "state": found}
        cause, now = self.after(run.guard, end, now.direction)
        self.event(cause, end, now)
        return end, now, None

    def after(self, guard: str, state: State, sigma: int) -> tuple[str, Next]:
        """Return the cause and what follows where a guard of a phase on the plane vanishes."""
        if guard == CONTACT:
            s, _ = sine_and_cosine(state.theta)
            opens = -(self.given.body.h * s * state.rate * state.rate * state.rate)
            if opens.sign() <= 0:
                raise Refused("the gap does not open where w vanishes")
            return "lift_off", Next(FLIGHT, 0, {"gap_third_derivative": opens}, 3)
        if guard == SLIP:
            following = decide(self.given, state)
            return ("reversal" if following.direction else "stick"), following
        if guard == SOLVABLE:
            raise Refused("the slide runs into P = 0")
        if guard == NORMAL:
            return "normal_force_zero", Next(GLIDING, -state.rate.sign(), {}, 2)
        return "slip", decide(self.given, state, -1 if guard == UP else 1)

    def same_phase(self, run: Followed, claimed: Mapping[str, Any], times: list[Range]) -> None:
        """Compare mode, direction and samples of a phase; its cover is protected by the digest alone."""
        mode, direction = run.phase.mode, run.phase.sigma
        where = f"phase {self.phases}"
        if set(claimed) != {"mode", "direction", "proof", "samples"}:
            raise Refused(f"{where} has other keys")
        self.same({"mode": mode, "direction": direction}, {k: claimed[k] for k in ("mode", "direction")}, where)
        for time, sample in zip(times, claimed["samples"], strict=True):
            if not (exceeds(time, run.phase.start.time) and (run.end is None or exceeds(run.end.time, time))):
                raise Refused(f"a sample of {where} is not within it")
            state = run.at(time)
            normal, friction = run.phase.forces(state)
            self.same(self.of(state) | {"normal": normal, "friction": friction}, sample, f"a sample of {where}")
        self.phases += 1

    def hit(self, cause: str, before: State) -> tuple[State, Next]:
        """Follow and compare an impact."""
        given = self.given
        assert given.restitution is not None
        hit = impact(given.body, before, given.restitution, given.law)
        after = hit.after
        now = decide(given, after) if after.gap_rate.is_zero() else _opening(after)
        lost = energy(given.body, before) - energy(given.body, after)
        self.impacts += lost
        found = {
            "case": hit.case,
            "normal_impulse": hit.normal,
            "friction_impulse": hit.friction,
            "energy_lost": lost,
            "before": {"theta_rate": before.rate, "slip": before.slip, "gap_rate": before.gap_rate},
        }
        self.event(cause, after, now, impact=found, evidence=hit.evidence)
        return after, now

    def settle(self, first: State) -> tuple[State, Next]:
        """Follow bounces one by one, enclose those that remain, and compare all of them together."""
        given = self.given
        if given.restitution is None:
            raise Refused("nothing bounces")
        claimed = self.claimed("phases")
        self.same(
            {"mode": FLIGHT, "direction": 0, "samples": []}, {k: claimed[k] for k in ("mode", "direction", "samples")},
            f"phase {self.phases}",
        )  # fmt: skip
        self.phases += 1
        state, normal, friction = first, Range(0), Range(0)
        for _ in range(100_000):
            if exceeds(Range(1 << max(0, Range.bits - SLOWEST)), state.gap_rate):
                break
            run = follow(given, Phase(given, state, FLIGHT, 0, 1))
            if run.end is None or run.guard != GAP:
                raise Refused("bounces do not settle before the time limit")
            hit = impact(given.body, run.end, given.restitution, given.law)
            state, normal, friction = hit.after, normal + hit.normal, friction + hit.friction
        rest = rest_of_bounces(given.body, state, given.restitution)
        end, following = rest.end, decide(given, rest.end)
        lost = energy(given.body, first) - energy(given.body, end)
        self.impacts += lost
        found = {
            "case": "sticks" if end.slip.is_zero() else "slides",
            "normal_impulse": normal + rest.normal,
            "friction_impulse": friction + rest.friction,
            "energy_lost": lost,
        }
        self.event("settle", end, following, impact=found)
        return end, following


def _opening(state: State) -> Next:
    """Return the flight of a gap that opens."""
    if state.gap_rate.sign() < 0:
        raise Inconclusive("the gap closes where a flight begins")
    return Next(FLIGHT, 0, {"gap_rate": state.gap_rate}, 1)
