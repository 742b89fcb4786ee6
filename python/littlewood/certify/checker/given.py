"""What a case says, as ranges."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from .body import Body, State
from .ranges import Range


class Given:
    """The body, the start, the law of restitution, where to stop, and the unit of each number."""

    def __init__(self, case: Mapping[str, Any]) -> None:
        hoop, start, of = case["hoop"], case["start"], Range.of
        if case["units"] == "si":
            mass, length, gravity = (Fraction(hoop[k]) for k in ("particle_mass_kg", "radius_m", "gravity_m_per_s2"))
            ratio, offset = Fraction(hoop["disc_mass_kg"]) / mass, Fraction(hoop["offset_m"]) / length
            own = Fraction(hoop["inertia_kg_m2"]) / (mass * length * length)
        else:
            mass = length = gravity = Fraction(1)
            ratio, offset, own = (Fraction(hoop[k]) for k in ("mass_ratio", "offset", "inertia"))
        m = 1 + ratio
        h = offset / m
        # About the mass centre: the hoop at the distance h, the particle at the distance ℓ − h.
        inertia = own + ratio * h**2 + (offset - h) ** 2
        self.body = Body(of(m), of(h), of(inertia), of(offset), of(Fraction(hoop["mu_s"])), of(Fraction(hoop["mu_k"])))
        self.massless = ratio == 0 and own == 0
        self.balanced, self.equal = offset == 0, hoop["mu_s"] == hoop["mu_k"]
        self.restitution = None if hoop.get("restitution") is None else of(Fraction(hoop["restitution"]))
        self.law = hoop.get("restitution_law")
        self.clock = of(length / gravity).sqrt()
        speed = of(length * gravity).sqrt()
        self.until = None if case["until"] is None else of(Fraction(case["until"])) / self.clock
        zero = Range(0)
        self.start = State(
            zero,
            of(Fraction(start["theta"])),
            of(Fraction(start["theta_rate"])) * self.clock,
            of(Fraction(start["slip"])) / speed,
            zero,
            zero,
            of(Fraction(start["gap_rate"])) / speed,
        )
        self.scale = {"time": self.clock, "period": self.clock, "theta_rate": 1 / self.clock}
        self.scale |= dict.fromkeys(("slip", "gap_rate"), speed) | dict.fromkeys(("x", "gap"), of(length))
        self.scale |= dict.fromkeys(("normal", "friction"), of(mass * gravity))
        self.scale |= dict.fromkeys(("normal_impulse", "friction_impulse"), of(mass) * speed)
        energies = ("energy", "energy_lost", "start", "lost_in_slides", "lost_in_impacts")
        self.scale |= dict.fromkeys(energies, of(mass * gravity * length))
