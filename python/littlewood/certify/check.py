"""The checker: follows the motion of a certificate again, by other means, and compares every number.

It has its own arithmetic (:mod:`.ranges`), its own solution of the equations (Taylor series in time,
:mod:`.motion_of_contact`) and its own impacts (the impulse is followed). A number passes if its text is that of the
number found here, so that no digit can be changed; a mode passes if the conditions of docs/theory/contact.md choose
it.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from .motion_of_contact import Guard, Hoop, State, Step
from .ranges import Inconclusive, Range, Series, exceeds, pi, sine_and_cosine
from .text_of import text_of


class Refused(Exception):
    """What in a certificate is not so."""


@dataclass
class Run:
    """A phase that was followed: its steps, and where and by which guard it ended."""

    steps: list[Step] = field(default_factory=list)
    guard: str = ""
    end: State | None = None
    turn: tuple[Range, Range] | None = None
    """Of rolling without end: the time after which it repeats itself, and the angle by which it has turned."""

    def at(self, time: Range) -> State:
        """Return the state at a time; beyond the first turn of rolling from that turn."""
        first = self.steps[0].start
        ahead = None
        if self.turn is not None:
            period, angle = self.turn
            count = int(float(time - first.time) / float(period))
            ahead, time = (period * count, angle * count), time - period * count
        for step in self.steps:
            passed = time - step.start.time
            if not exceeds(passed, step.length):
                found = step.state(passed)
                if ahead is not None:
                    found = replace(
                        found, time=found.time + ahead[0], theta=found.theta + ahead[1], x=found.x - ahead[1]
                    )
                return found
        raise Refused("a sample is not within its phase")


def check(certificate: Mapping[str, Any], bits: tuple[int, ...] = (192, 320, 512, 1024, 2048)) -> dict[str, int]:
    """Check a certificate.

    Parameters
    ----------
    certificate : mapping
        What a file of a certificate says.
    bits : tuple of int, optional
        Precisions that are tried, one after the other.

    Returns
    -------
    dict
        How many numbers, phases and events were found again.

    Raises
    ------
    Refused
        With the first number that is not right.
    """
    rest = {key: value for key, value in certificate.items() if key != "digest"}
    found = hashlib.sha256(json.dumps(rest, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
    if found != certificate.get("digest"):
        raise Refused("the digest is not that of the certificate")
    if (certificate.get("format"), certificate.get("version")) != ("littlewood-certificate", 1):
        raise Refused("this is no certificate of a known version")
    if certificate.get("certified") is not True:
        raise Refused(f"nothing is certified: {certificate.get('reason')}")
    reason = ""
    settles = any(event.get("cause") == "settle" for event in certificate.get("events", ()))
    for number in bits:
        if settles and number < 320:
            continue
        Range.bits = number
        try:
            return Checker(certificate).run()
        except Inconclusive as inconclusive:
            reason = f"{inconclusive} with {number} bits"
        except (KeyError, TypeError, IndexError) as error:
            raise Refused(f"the certificate is not complete: {error!r}") from error
    raise Refused(f"the check is inconclusive: {reason}")


class Checker:
    """Follows one motion."""

    def __init__(self, certificate: Mapping[str, Any]) -> None:
        self.certificate, case = certificate, certificate["case"]
        hoop, start = case["hoop"], case["start"]
        if case["units"] == "si":
            mass, length, gravity = (Fraction(hoop[k]) for k in ("particle_mass_kg", "radius_m", "gravity_m_per_s2"))
            ratio, offset = Fraction(hoop["disc_mass_kg"]) / mass, Fraction(hoop["offset_m"]) / length
            own = Fraction(hoop["inertia_kg_m2"]) / (mass * length * length)
        else:
            mass = length = gravity = Fraction(1)
            ratio, offset, own = (Fraction(hoop[k]) for k in ("mass_ratio", "offset", "inertia"))
        m, of = 1 + ratio, Range.of
        h = offset / m
        # About the mass centre: the hoop at the distance h, the particle at the distance ℓ − h.
        inertia = own + ratio * h**2 + (offset - h) ** 2
        self.hoop = Hoop(of(m), of(h), of(inertia), of(offset), of(Fraction(hoop["mu_s"])), of(Fraction(hoop["mu_k"])))
        self.massless = ratio == 0 and own == 0
        self.balanced, self.equal = offset == 0, hoop["mu_s"] == hoop["mu_k"]
        self.clock = of(length / gravity).sqrt()
        self.speed = of(length * gravity).sqrt()
        weight, energy = of(mass * gravity), of(mass * gravity * length)
        impulse = of(mass) * self.speed
        self.scale = {"time": self.clock, "period": self.clock, "theta_rate": 1 / self.clock}
        self.scale |= dict.fromkeys(("slip", "gap_rate"), self.speed)
        self.scale |= dict.fromkeys(("x", "gap"), of(length))
        self.scale |= dict.fromkeys(("energy", "energy_lost"), energy)
        self.scale |= dict.fromkeys(("normal", "friction"), weight)
        self.scale |= dict.fromkeys(("normal_impulse", "friction_impulse"), impulse)
        self.e = None if hoop.get("restitution") is None else of(Fraction(hoop["restitution"]))
        self.law = hoop.get("restitution_law")
        self.until = None if case["until"] is None else of(Fraction(case["until"])) / self.clock
        zero = Range(0)
        self.state = State(
            zero,
            of(Fraction(start["theta"])),
            of(Fraction(start["theta_rate"])) * self.clock,
            of(Fraction(start["slip"])) / self.speed,
            zero,
            zero,
            of(Fraction(start["gap_rate"])) / self.speed,
        )
        self.numbers = 0

    def same(self, what: str, value: Range, claimed: Any, name: str = "") -> None:
        """Compare a number with what the certificate says."""
        scale = self.scale.get(name)
        text = text_of(value if scale is None else value * scale)
        self.numbers += 1
        if text != claimed:
            raise Refused(f"{what} is {' ± '.join(text)}, not {' ± '.join(map(str, claimed))}")

    def same_state(self, what: str, state: State, claimed: Mapping[str, Any], some: bool = False) -> None:
        """Compare a state; of some of its numbers where not all are claimed."""
        values = {
            "time": state.time, "theta": state.theta, "theta_rate": state.rate, "slip": state.slip, "x": state.x,
            "gap": state.gap, "gap_rate": state.gap_rate, "energy": self.energy(state),
        }  # fmt: skip
        for name in claimed if some else values:
            if name in values:
                self.same(f"{name} {what}", values[name], claimed[name], name)

    def energy(self, state: State) -> Range:
        """Return kinetic and potential energy, of the mass centre and about it."""
        hoop = self.hoop
        sin, cos = sine_and_cosine(state.theta)
        along = state.slip - state.rate - hoop.h * cos * state.rate
        up = state.gap_rate - hoop.h * sin * state.rate
        kinetic = hoop.m * (along * along + up * up) + hoop.inertia * state.rate * state.rate
        return kinetic / 2 + hoop.m * state.gap + hoop.offset * cos

    def run(self) -> dict[str, int]:
        """Follow the motion through all phases."""
        certificate, state = self.certificate, self.state
        events = list(certificate["events"])
        phases = list(certificate["phases"])
        counts = {"phases": len(phases), "events": len(events)}
        lost = {"sliding": Range(0), "impacts": Range(0)}
        self.same("energy at the start", self.energy(state), certificate["energy"]["start"], "energy")
        if state.gap_rate.is_zero():
            mode, direction, evidence, order = self.decide(state)
        else:
            mode, direction, evidence, order = "flight", 0, {"gap_rate": state.gap_rate}, 1
        self.same_choice("at the start", (mode, direction, evidence), certificate["initial"], "mode")
        while True:
            if mode == "inconsistent" and self.e is not None:
                event = events.pop(0)
                state, (mode, direction, evidence, order) = self.hit("jam", state, event, lost)
                continue
            if mode in ("inconsistent", "ambiguous"):
                self.same_end(mode, state)
                break
            phase = phases.pop(0)
            if (phase["mode"], phase["direction"]) != (mode, direction):
                raise Refused(f"the phase is {mode} {direction}, not {phase['mode']} {phase['direction']}")
            if mode == "flight" and events and events[0]["cause"] == "settle":
                event = events.pop(0)
                state, (mode, direction, evidence, order) = self.settle(state, event, lost)
                continue
            times = [Range.of(Fraction(one["time"][0])) / self.clock for one in phase["samples"]]
            run = self.phase(state, mode, direction, order, times[-1] if times else state.time)
            self.samples(run, phase)
            if run.end is None:
                self.same_endless(run)
                break
            before, state = state, run.end
            if run.guard == "slip":
                state = replace(state, slip=Range(0))
            if mode == "sliding":
                lost["sliding"] += self.energy(before) - self.energy(state)
            if run.guard == "time_limit":
                self.same_end("time_limit", state)
                break
            event = events.pop(0)
            if run.guard == "plane":
                self.same_choice("at the plane", (None, 0, {}), event, "to")
                self.same_cause("particle_at_plane", event)
                self.same_plane(state, event["state"])
                self.same_plane(state, certificate["end"]["state"])
                if certificate["end"]["kind"] != "particle_at_plane":
                    raise Refused("the motion ends with the particle at the plane")
                break
            if run.guard == "gap":
                if self.e is None:
                    self.same_choice("at the landing", (None, 0, {"gap_rate": state.gap_rate}), event, "to")
                    self.same_cause("landing", event)
                    self.same_state("at the landing", state, event["state"])
                    self.same_end("landing", state)
                    break
                state, (mode, direction, evidence, order) = self.hit("landing", state, event, lost)
                continue
            cause, (mode, direction, evidence, order) = self.after(run, state, direction)
            self.same_cause(cause, event)
            self.same_choice(f"after the {cause}", (mode, direction, evidence), event, "to")
            self.same_state(f"at the {cause}", state, event["state"])
        if events or phases:
            raise Refused("the certificate has more phases or events than the motion")
        energy = certificate["energy"]
        self.same("energy lost in slides", lost["sliding"], energy["lost_in_slides"], "energy")
        self.same("energy of impacts", lost["impacts"], energy["lost_in_impacts"], "energy")
        return counts | {"numbers": self.numbers}

    def after(self, run: Run, state: State, direction: int) -> tuple[str, tuple[Any, ...]]:
        """Return the cause and what follows where a phase in contact has ended."""
        if run.guard == "contact":
            sin, _ = sine_and_cosine(state.theta)
            opens = -self.hoop.h * sin * state.rate * state.rate * state.rate
            if opens.sign() <= 0:
                raise Refused("the gap does not open")
            return "lift_off", ("flight", 0, {"gap_third_derivative": opens}, 3)
        if run.guard == "slip":
            following = self.decide(state)
            return ("stick" if following[0] == "rolling" else "reversal"), following
        if run.guard == "solvability":
            raise Refused("the slide runs into P = 0")
        if run.guard == "normal":
            return "normal_force_zero", ("gliding", -state.rate.sign(), {}, 2)
        return "slip", self.decide(state, -1 if run.guard == "margin_positive" else 1)

    def same_plane(self, state: State, claimed: Mapping[str, Any]) -> None:
        """Compare the state with the particle at the plane, which has an infinite rate."""
        if set(claimed) != {"time", "theta", "slip", "x", "gap", "gap_rate"}:
            raise Refused("the state with the particle at the plane has other numbers")
        self.same_state("at the plane", state, claimed, some=True)

    def same_cause(self, cause: str, event: Mapping[str, Any]) -> None:
        """Compare the name of an event."""
        if event["cause"] != cause:
            raise Refused(f"the event is {cause}, not {event['cause']}")

    def same_choice(self, where: str, found: tuple[Any, ...], claimed: Mapping[str, Any], key: str) -> None:
        """Compare what follows, and the numbers that decide it."""
        mode, direction, evidence = found
        if (claimed[key], claimed["direction"]) != (mode, direction):
            raise Refused(f"{where} follows {mode} {direction}, not {claimed[key]} {claimed['direction']}")
        if set(claimed["evidence"]) != set(evidence):
            raise Refused(f"{where} other numbers decide: {', '.join(sorted(evidence))}")
        for name, value in evidence.items():
            self.same(f"{name} {where}", value, claimed["evidence"][name])

    def same_end(self, kind: str, state: State) -> None:
        """Compare the end."""
        end = self.certificate["end"]
        if end["kind"] != kind:
            raise Refused(f"the motion ends by {kind}, not {end['kind']}")
        self.same_state("at the end", state, end["state"])

    def same_endless(self, run: Run) -> None:
        """Compare how the hoop rolls for ever."""
        end = self.certificate["end"]
        angle = None if run.turn is None else run.turn[1]
        kind = "rest" if angle is None else "libration" if angle.is_zero() else "rotation"
        if (end["kind"], end["recurrence"]) != ("rolls_forever", kind):
            raise Refused(f"the hoop rolls for ever ({kind}), not {end['kind']}")
        if run.turn is not None:
            self.same("the period", run.turn[0], end["period"], "period")

    def samples(self, run: Run, phase: Mapping[str, Any]) -> None:
        """Compare the samples of a phase."""
        for one in phase["samples"]:
            state = run.at(Range.of(Fraction(one["time"][0])) / self.clock)
            self.same_state(f"of the sample at {one['time'][0]}", state, one)
            normal, friction = self.forces(state, phase["mode"], phase["direction"])
            self.same("normal force of a sample", normal, one["normal"], "normal")
            self.same("friction of a sample", friction, one["friction"], "friction")

    def forces(self, state: State, mode: str, sigma: int) -> tuple[Range, Range]:
        """Return N and F by the two lines of the contact: η″ = −h s u + A F + B N, 0 = −w + B F + C N, times m Î."""
        hoop = self.hoop
        if mode in ("flight", "gliding"):
            return Range(0), Range(0)
        sin, cos = sine_and_cosine(state.theta)
        a, b, c = hoop.compliances(sin, cos)
        u = state.rate * state.rate
        pull, w = hoop.h * sin * u, 1 - hoop.h * cos * u
        over = hoop.m * hoop.inertia
        if mode == "sliding":
            normal = over * w / (c - hoop.mu_k * b * sigma)
            return normal, -(hoop.mu_k * normal) * sigma
        # A C − B², of which one Î divides out.
        sum_of_squares = (1 + hoop.h * cos) * (1 + hoop.h * cos) + hoop.h * sin * hoop.h * sin
        determinant = hoop.inertia + hoop.m * sum_of_squares
        return hoop.m * (a * w - b * pull) / determinant, hoop.m * (c * pull - b * w) / determinant

    def decide(self, state: State, gives_way: int = 0) -> tuple[str, int, dict[str, Range], int]:
        """Return mode, direction, the numbers that decide, and the order of the zero with which the phase begins."""
        if self.massless:
            return self.decide_massless(state, gives_way)
        hoop = self.hoop
        sin, cos = sine_and_cosine(state.theta)
        _, b, c = hoop.compliances(sin, cos)
        w = 1 - hoop.h * cos * state.rate * state.rate
        evidence = {"contact": w}
        pressed = w.sign()
        solvable = {sigma: c - hoop.mu_k * b * sigma for sigma in (-1, 1)}
        moving = state.slip.sign()
        if pressed == 0:
            raise Refused("1 − h cos θ θ′² vanishes where a motion begins")
        if moving:
            evidence["solvability"] = solvable[moving]
            names = {(1, 1): ("sliding", moving, 0), (-1, 1): ("flight", 0, 2), (1, -1): ("inconsistent", moving, 0)}
            mode, direction, order = names.get((pressed, solvable[moving].sign()), ("ambiguous", 0, 0))
            return mode, direction, evidence, order
        normal, friction = self.forces(state, "rolling", 0)
        evidence |= {"rolling_normal": normal, "rolling_friction": friction}
        if not gives_way and pressed > 0:
            limit = hoop.mu_s * normal
            up, down = limit - friction, limit + friction
            holds = normal.sign() > 0 and (self.balanced or (up.sign() > 0 and down.sign() > 0))
            if holds:
                return "rolling", 0, evidence, 0
        evidence |= {"solvability_negative": solvable[-1], "solvability_positive": solvable[1]}
        if pressed < 0:
            if not (solvable[-1].sign() > 0 and solvable[1].sign() > 0):
                raise Refused("a flight begins where P is not positive")
            return "flight", 0, evidence, 2
        direction = gives_way or -friction.sign()
        drive = -(friction * direction) - hoop.mu_k * normal
        if solvable[direction].sign() <= 0 or (not (gives_way and self.equal) and drive.sign() <= 0):
            raise Refused("no slide begins")
        return "sliding", direction, evidence, 2 if gives_way and self.equal else 1

    def decide_massless(self, state: State, gives_way: int) -> tuple[str, int, dict[str, Range], int]:
        """Return the same for a massless hoop: it rolls, or glides without any force."""
        moving = state.slip.sign()
        if moving:
            return "gliding", moving, {}, 0
        sin, cos = sine_and_cosine(state.theta)
        normal, friction = self.forces(state, "rolling", 0)
        evidence = {"rolling_normal": normal, "rolling_friction": friction}
        presses = (1 - state.rate * state.rate).sign()
        if not gives_way and presses > 0 and (self.hoop.mu_s * (1 + cos) - abs(sin)).sign() > 0:
            return "rolling", 0, evidence, 0
        # η″ = (1 + c)(1 − θ′²)/s.
        direction = sin.sign() * presses
        if direction == 0:
            raise Refused("no glide begins")
        return "gliding", direction, evidence, 1

    def plane(self, start: State, sigma: int) -> State | None:
        """Return the end of a glide in which the particle falls to the plane, if its slip does not come to rest.

        Y = cos θ falls freely with V = Y′, and η′ = v − side V √((1 + Y)/(1 − Y)), whose last term is at most
        r √((1 + Y0)/(1 − Y0)) from here on, r the speed at the plane.
        """
        sin, cos = sine_and_cosine(start.theta)
        fall = sin * start.rate
        if not exceeds(fall, 0) or float(cos) > -0.5:
            return None
        r = (fall * fall + 2 * (1 + cos)).sqrt()
        drift = start.slip - (1 + cos) * start.rate
        if not exceeds(drift * sigma, r * ((1 + cos) / (1 - cos)).sqrt()):
            return None
        time = r - fall
        turns = round(float(start.theta) / 6.283185307179586)
        theta = pi() * (2 * turns + sin.sign())
        x = start.x + drift * time - sin
        return State(start.time + time, theta, Range(0), drift, x, Range(0), Range(0))

    def phase(self, start: State, mode: str, sigma: int, order: int, last: Range | None = None) -> Run:
        """Follow a phase, all guards enclosed and positive, to the zero of one of them."""
        run = Run()
        if mode == "rolling" and start.rate.is_zero() and (self.balanced or start.theta.is_zero()):
            normal, friction = self.forces(start, mode, 0)
            if not exceeds(self.hoop.mu_s * normal, abs(friction)) and not self.balanced:
                raise Inconclusive("rest is not decided")
            run.steps, run.end = [Step(self.hoop, start, mode, 0, 0, None, False)], None
            if self.until is not None:
                run.guard, run.end = "time_limit", replace(start, time=self.until)
            return run
        state, zeros = start, [start.time] if start.rate.is_zero() else []
        while True:
            short = mode == "flight" and order == 1 and float(start.gap_rate) < 0.1
            stop = self.until if run.turn is None else start.time + run.turn[0]
            step = Step(self.hoop, state, mode, sigma, order, stop, short)
            run.steps.append(step)
            found = self.first_zero(step)
            if found is not None:
                run.guard, time = found
                run.end = step.state(time)
                if run.guard == "gap":
                    rate = step.landing_rate(time) if len(run.steps) == 1 and order == 1 else run.end.gap_rate
                    run.end = replace(run.end, gap=Range(0), gap_rate=rate)
                return run
            ahead = step.state(step.length)
            if mode == "gliding" and (last is None or exceeds(ahead.time, last)):
                plane = self.plane(ahead, sigma)
                if plane is not None and (self.until is None or exceeds(self.until, plane.time)):
                    run.guard, run.end = "plane", plane
                    return run
            if self.until is not None and not exceeds(self.until, ahead.time) and run.turn is None:
                run.guard, run.end = "time_limit", step.state(self.until - state.time)
                return run
            if mode == "rolling" and run.turn is None:
                run.turn = self.turn(step, ahead, start, zeros)
            if run.turn is not None and not exceeds(start.time + run.turn[0], ahead.time):
                if self.until is not None:
                    run.guard, run.end = "time_limit", run.at(self.until)
                return run
            state, order = ahead, 0
            if len(run.steps) > 100_000:
                raise Refused("a phase has too many steps")

    def turn(self, step: Step, ahead: State, start: State, zeros: list[Range]) -> tuple[Range, Range] | None:
        """Return period and angle once rolling has repeated itself: after a turn, or after the second turning point."""
        if not self.balanced and step.start.rate.sign() * ahead.rate.sign() <= 0 and not step.start.rate.is_zero():
            series = step.series["theta_rate"]
            side = step.start.rate.sign()
            guard = Guard(series, step.size["theta_rate"], 0)
            at = self.zero(step, guard, Range(0), step.length, side)
            zeros.append(step.start.time + at)
            if len(zeros) == 2:
                return (zeros[1] - zeros[0]) * 2, Range(0)
        round_ = 2 * pi()
        if exceeds(abs(ahead.theta - start.theta), round_) and not zeros:
            side = ahead.rate.sign()
            series = step.series["theta"]
            shifted = Series(step.start.theta - start.theta - round_ * side)
            for k in range(1, len(series.m)):
                shifted.append(series[k])
            at = self.zero(step, Guard(shifted, step.size["theta"] + 7, 0), Range(0), step.length, -side)
            return step.start.time + at - start.time, round_ * side
        return None

    def first_zero(self, step: Step) -> tuple[str, Range] | None:
        """Return the first zero of a guard in a step, all others being positive up to it."""
        work = [(Range(0), step.length)]
        while work:
            low, high = work.pop()
            doubtful = []
            for name, guard in step.guards.items():
                if not exceeds(step.between(guard, low, high), 0):
                    slope = step.slope(guard, low, high)
                    steady = exceeds(slope, 0) or exceeds(-slope, 0)
                    ends = (step.value(guard, low), step.value(guard, high))
                    if steady and all(exceeds(end, 0) for end in ends):
                        continue
                    doubtful.append((name, steady and exceeds(ends[0], 0) and exceeds(-ends[1], 0)))
            if not doubtful:
                continue
            if len(doubtful) == 1 and doubtful[0][1]:
                name = doubtful[0][0]
                return name, self.zero(step, step.guards[name], low, high, 1)
            middle = Range(((low + high) / 2).m)
            if (high - low).m < 1 << (Range.bits // 4):
                raise Inconclusive(f"whether {doubtful[0][0]} vanishes is not decided")
            work += [(middle, high), (low, middle)]
        return None

    @staticmethod
    def zero(step: Step, guard: Guard, low: Range, high: Range, side: int) -> Range:
        """Return the one zero of a guard between two times, at the first of which it has the sign `side`."""
        while True:
            slope = step.slope(guard, low, high)
            if exceeds(-(slope * side), 0):
                break
            middle = Range(((low + high) / 2).m)
            if step.value(guard, middle).sign() == side:
                low = middle
            else:
                high = middle
            if (high - low).m < 1 << (Range.bits // 4):
                raise Inconclusive("a zero is not simple")
        while True:
            width = high.m - low.m
            middle = Range(((low + high) / 2).m)
            value = step.value(guard, middle)
            at = middle - value / step.slope(guard, low, high)
            first, last = max(at.m - at.r, low.m), min(at.m + at.r, high.m)
            if first > last:
                raise Refused("a zero is not where it has to be")
            low, high = Range(first), Range(last)
            if 2 * (last - first) > width:
                # As narrow as the radius of the guard allows, or not yet: then the middle tells a half.
                middle = Range((first + last) // 2)
                value = step.value(guard, middle) * side
                if exceeds(value, 0):
                    low = middle
                elif exceeds(-value, 0):
                    high = middle
                else:
                    return Range(middle.m, (last - first) // 2 + 1)

    def hit(
        self, cause: str, before: State, event: Mapping[str, Any], lost: dict[str, Range]
    ) -> tuple[State, tuple[Any, ...]]:
        """Follow an impact, and compare it."""
        self.same_cause(cause, event)
        after, normal, friction, case, evidence = self.impact(before)
        claimed = event["impact"]
        if claimed["case"] != case:
            raise Refused(f"the impact {case}, not {claimed['case']}")
        self.same_state("before the impact", before, claimed["before"], some=True)
        self.same("normal impulse", normal, claimed["normal_impulse"], "normal_impulse")
        self.same("friction impulse", friction, claimed["friction_impulse"], "friction_impulse")
        gone = self.energy(before) - self.energy(after)
        self.same("energy lost in an impact", gone, claimed["energy_lost"], "energy_lost")
        lost["impacts"] += gone
        following = self.leave(after)
        found = (following[0], following[1], evidence | following[2])
        self.same_choice("after an impact", found, event, "to")
        self.same_state("after an impact", after, event["state"])
        return after, following

    def leave(self, after: State) -> tuple[str, int, dict[str, Range], int]:
        """Return what follows an impact."""
        if after.gap_rate.is_zero():
            return self.decide(after)
        if after.gap_rate.sign() < 0:
            raise Refused("the gap closes after an impact")
        return "flight", 0, {"gap_rate": after.gap_rate}, 1

    def impact(self, before: State) -> tuple[State, Range, Range, str, dict[str, Range]]:
        """Follow an impact in its normal impulse p: two stretches on which gap rate v and slip are straight lines."""
        assert self.e is not None
        hoop, e = self.hoop, self.e
        sin, cos = sine_and_cosine(before.theta)
        scaled = hoop.compliances(sin, cos)
        a, b, c = (one / (hoop.m * hoop.inertia) for one in scaled)
        sigma, v0 = before.slip.sign(), before.gap_rate
        f = -(hoop.mu_k * sigma)
        stays = hoop.mu_s * a - abs(b)
        sticks = stays.sign() >= 0
        then = -(b / a) if sticks else -(hoop.mu_k * b.sign())
        k1, k2 = c + b * f, c + b * then
        evidence = {"k1": k1, "k2": k2, "sticks": stays}
        bend: Range | None = Range(0)
        if sigma:
            slowing = evidence["slowing"] = hoop.mu_k * a - b * sigma
            bend = abs(before.slip) / slowing if slowing.sign() > 0 else None
        # Where the gap stops closing: on the first stretch, or else on the second.
        jams = sigma != 0 and k1.sign() < 0
        on_first = bend is None or (sigma != 0 and not jams and (bend * k1 + v0).sign() > 0)
        if bend is None and jams:
            raise Refused("an impact jams for ever")
        v1 = None if bend is None else v0 + k1 * bend
        if on_first:
            turn = -v0 / k1
        else:
            assert bend is not None and v1 is not None
            turn = bend - v1 / k2
        # By each law as if the stretch on which the gap stops closing went on.
        slope = k1 if on_first else k2
        if self.law == "energetic" and not on_first:
            assert bend is not None and v1 is not None
            compressed = -(v0 + v1) * bend + v1 * v1 / k2
            opening = e * (compressed * k2).sqrt() if not e.is_zero() else Range(0)
        elif self.law == "poisson":
            opening = e * turn * slope
        else:
            opening = -(e * v0)
        normal = turn + opening / slope
        crosses = on_first and bend is not None and self.passes(normal - bend)
        if crosses:
            assert bend is not None and v1 is not None
            if self.law == "poisson":
                normal = (1 + e) * turn
                opening = v1 + k2 * (normal - bend)
            else:
                if self.law == "energetic":
                    # Work e² v0²/(2 k1) of restitution, of which v1²/(2 k1) is given back before the bend.
                    left = e * e * v0 * v0 / k1 - v1 * v1 / k1
                    opening = (v1 * v1 + left * k2).sqrt()
                normal = bend + (opening - v1) / k2
        first = normal if on_first and not crosses else bend
        assert first is not None
        friction = f * first + then * (normal - first)
        slides = on_first and not crosses
        word = "sticks" if sticks else "reverses"
        case = "slides" if slides else "jams" if jams else f"{word}_in_{'restitution' if crosses else 'compression'}"
        slip = Range(0) if sticks and not slides else before.slip + a * friction + b * normal
        if not slides:
            assert v1 is not None
            evidence["slip_ends"] = v1
        arm, lever = hoop.h * sin, 1 + hoop.h * cos
        after = replace(
            before,
            rate=before.rate + (arm * normal + lever * friction) / hoop.inertia,
            slip=slip,
            gap=Range(0),
            gap_rate=opening,
        )
        return after, normal, friction, case, evidence

    @staticmethod
    def passes(beyond: Range) -> bool:
        """Whether an impulse goes beyond the end of slip."""
        return beyond.sign() > 0

    def settle(self, state: State, event: Mapping[str, Any], lost: dict[str, Range]) -> tuple[State, tuple[Any, ...]]:
        """Follow bounces until half of the bits are left for the gap rate, and enclose those that remain."""
        self.same_cause("settle", event)
        first, normal, friction = state, Range(0), Range(0)
        for _ in range(100_000):
            if exceeds(Range(1 << (Range.bits // 2 + 10)), state.gap_rate):
                break
            run = self.phase(state, "flight", 0, 1)
            if run.guard != "gap" or run.end is None:
                raise Refused("bounces do not settle before the time limit")
            state, one, other, _, _ = self.impact(run.end)
            normal, friction = normal + one, friction + other
        end, one, other = self.rest_of_bounces(state)
        claimed = event["impact"]
        if claimed["case"] != ("sticks" if state.slip.is_zero() else "slides"):
            raise Refused("the bounces settle in another way")
        self.same("normal impulse of the bounces", normal + one, claimed["normal_impulse"], "normal_impulse")
        self.same("friction impulse of the bounces", friction + other, claimed["friction_impulse"], "friction_impulse")
        gone = self.energy(first) - self.energy(end)
        self.same("energy lost in the bounces", gone, claimed["energy_lost"], "energy_lost")
        lost["impacts"] += gone
        following = self.decide(end)
        self.same_choice("after the bounces", following[:3], event, "to")
        self.same_state("after the bounces", end, event["state"])
        return end, following

    def rest_of_bounces(self, start: State) -> tuple[State, Range, Range]:
        """Enclose what infinitely many bounces still do, by the argument of :mod:`.settling`, without its code."""
        assert self.e is not None
        hoop, e = self.hoop, self.e
        v = start.gap_rate.largest()
        margin = v * (1 << 24)
        theta, rate = start.theta.widened(margin), start.rate.widened(margin)
        sin, cos = sine_and_cosine(theta)
        pull = 1 - hoop.h * cos * rate * rate
        weakest, strongest = pull.least(), pull.largest()
        if weakest.m <= 0:
            raise Inconclusive("bounces are not pulled back")
        uneven = (strongest / weakest).sqrt()
        shrink = (e * uneven).largest()
        if not exceeds(Range(1 << Range.bits), shrink):
            raise Inconclusive("bounces do not shrink")
        a, b, c = (x / (hoop.m * hoop.inertia) for x in hoop.compliances(sin, cos))
        all_rates = v * uneven / (1 - shrink)
        time = (2 * v / weakest / (1 - shrink)).largest()
        drift = (hoop.h * sin * rate * rate).largest()
        size = b.largest()
        if start.slip.is_zero():
            if not (exceeds(sin, 0) or exceeds(-sin, 0)) or not exceeds(hoop.mu_s * a, size):
                raise Inconclusive("bounces are not seen to stick")
            back = v * (weakest / strongest).sqrt()
            least = abs(b).least()
            if not exceeds((1 + e) * back * (hoop.mu_k * a + least), drift * 2 * v / weakest * (c + hoop.mu_k * size)):
                raise Inconclusive("bounces are not seen to stick")
            press, hold, slip = c - b * b / a, hoop.mu_s, Range(0)
        else:
            press, hold, slip = c - hoop.mu_k * b * start.slip.sign(), hoop.mu_k, start.slip
        normal = ((1 + e) * all_rates / press).largest()
        if press.sign() <= 0:
            raise Inconclusive("bounces are not pressed back")
        friction = (hold * normal).largest()
        change = a * friction + size * normal + drift * time
        if not slip.is_zero():
            if not exceeds(abs(slip) - change, (hoop.mu_k * a - b * slip.sign()) * normal):
                raise Inconclusive("the slip may end")
            slip = slip.widened(change.largest())
        turn = rate.largest() * time
        spin = (hoop.h * normal + (1 + hoop.h) * friction) / hoop.inertia
        if exceeds(turn, margin) or exceeds(spin, margin):
            raise Inconclusive("bounces go too far")
        far = (rate.largest() + abs(start.slip).largest() + change) * time
        half = Range((time / 2).m)
        end = State(
            (start.time + half).widened((time / 2).largest()),
            start.theta.widened(turn.largest()),
            start.rate.widened(spin.largest()),
            slip,
            start.x.widened(far.largest()),
            Range(0),
            Range(0),
        )
        return end, (normal / 2).widened((normal / 2).largest()), Range(0).widened(friction)
