"""Chooses the cases of the data set, with a fixed seed.

It adds those that littlewood.scoring does not have yet.

    python3 choose.py

Hoops and starts are drawn with few decimals, followed by the library, and sorted into families by
the events that they have.
"""

from __future__ import annotations

import json
import math
import random
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import littlewood as lw
from littlewood.certify import Case, certify

HERE = Path(__file__).parent
SEED = 20260815

Draw = dict[str, Any]
LAWS = ("energetic", "poisson", "newton")


def hoops(rng: random.Random) -> Draw:
    """Draw a hoop: thin with the particle on the rim, or inside, or a disc."""
    ratio = rng.choice([0.1, 0.25, 0.5, 1.0, 1.0, 2.0, 4.0])
    offset = rng.choice([1.0, 1.0, 1.0, 0.9, 0.75, 0.5])
    inertia = ratio * rng.choice([1.0, 1.0, 0.75, 0.5])
    mu_s = round(rng.uniform(0.1, 0.9), 2)
    mu_k = round(mu_s * rng.choice([1.0, 0.9, 0.8, 0.6]), 3)
    return dict(mass_ratio=ratio, offset=offset, inertia=inertia, mu_s=mu_s, mu_k=mu_k)


def starts(rng: random.Random, slips: bool, fastest: float = 3.0) -> Draw:
    """Draw a start."""
    slip = round(rng.uniform(-1.5, 1.5), 2) if slips else 0.0
    return dict(
        theta=round(rng.uniform(-3.1, 3.1), 2),
        theta_rate=round(rng.uniform(-fastest, fastest), 2),
        slip=slip,
    )


def follow(hoop: Draw, start: Draw, until: float | None) -> Any:
    """Follow a motion with the library."""
    return lw.Hoop(**named(hoop)).simulate(**start, until=until)


def named(hoop: Draw) -> Draw:
    """Return a hoop with the names of the library."""
    return {"restitution_law" if name == "law" else name: value for name, value in hoop.items()}


def causes(motion: Any) -> list[str]:
    """Return the causes of its events."""
    return [one.cause for one in motion.transitions]


def case(family: str, number: int, hoop: Draw, start: Draw, until: float | None) -> Draw:
    """Return a case as the certifier reads it."""
    given = named(hoop)
    if "restitution" in given:
        given.setdefault("restitution_law", "energetic")
    return dict(
        name=f"{family}-{number:02d}",
        family=family,
        units="dimensionless",
        hoop=given,
        start={"gap_rate": 0.0} | start,
        until=until,
    )


def searched(
    family: str,
    count: int,
    draw: Callable[[random.Random], tuple[Draw, Draw, float | None]],
    fits: Callable[[Any], bool],
    part: str = "",
) -> Iterator[Draw]:
    """Draw until so many motions fit; each part of a family draws by itself."""
    rng = random.Random(f"{SEED} {family} {part}".rstrip())
    found = 0
    for _ in range(30_000):
        if found == count:
            return
        hoop, start, until = draw(rng)
        try:
            motion = follow(hoop, start, until)
        except ValueError:
            continue
        if motion.outcome.kind in (
            "unresolved",
            "ambiguous",
            "inconsistent",
            "singular",
        ) or not fits(motion):
            continue
        found += 1
        yield case(family, found, hoop, start, until)
    raise RuntimeError(f"too few motions of {family}")


def within(
    times: float, slips: bool = True, fastest: float = 3.0
) -> Callable[[random.Random], tuple[Draw, Draw, float | None]]:
    """Draw any hoop and start, followed up to a time."""
    return lambda rng: (hoops(rng), starts(rng, slips, fastest), times)


def in_order(found: list[str], wanted: list[str]) -> bool:
    """Whether events occur in this order, others between them."""
    rest = iter(found)
    return all(any(one == cause for one in rest) for cause in wanted)


def slide_roll_slip() -> Iterator[Draw]:
    """Stick and slip, the rim at the plane."""
    yield from searched(
        "slide-roll-slip",
        40,
        within(6.0),
        lambda m: in_order(causes(m), ["stick", "slip"]) and "lift_off" not in causes(m),
    )


def lift_off() -> Iterator[Draw]:
    """A slide that leaves the plane, up to the landing."""
    yield from searched(
        "lift-off",
        30,
        within(12.0),
        lambda m: "lift_off" in causes(m) and m.outcome.kind == "landing",
    )


def landing() -> Iterator[Draw]:
    """Each coefficient of restitution by each law: twice, followed through the first impacts."""
    number = 0
    for e in (0.0, 0.5, 0.8, 1.0):
        for law in LAWS:
            rng = random.Random(f"{SEED} landing {e} {law}")
            found = 0
            while found < 4:
                hoop, start = hoops(rng), starts(rng, True)
                if found % 2:
                    start["gap_rate"] = round(rng.uniform(0.2, 1.0), 2)
                hoop |= dict(restitution=e, law=law)
                motion = follow(hoop, start, 12.0)
                times = [one.state.time for one in motion.transitions if one.impact is not None]
                if not times or motion.outcome.kind in (
                    "unresolved",
                    "ambiguous",
                    "inconsistent",
                    "singular",
                ):
                    continue
                # Up to the third impact, and a little more.
                until = round((times[3] + times[2]) / 2 if len(times) > 3 else times[-1] + 0.5, 2)
                if until >= 12 or "settle" in causes(follow(hoop, start, until)):
                    continue
                found += 1
                number += 1
                yield case("landing", number, hoop, start, until)


def settlement() -> Iterator[Draw]:
    """Bounces that accumulate, and what follows."""
    for family, sticks, count in (("settles-sticking", True, 14), ("settles-sliding", False, 14)):

        def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
            hoop = hoops(rng) | dict(
                restitution=rng.choice([0.3, 0.5, 0.5, 0.8]),
                law=rng.choice(LAWS),
            )
            return (
                hoop,
                starts(rng, True, 1.0) | dict(gap_rate=round(rng.uniform(0.1, 0.6), 2)),
                4.0,
            )

        def fits(motion: Any, sticks: bool = sticks) -> bool:
            settled = [one for one in motion.transitions if one.cause == "settle"]
            return len(settled) == 1 and (settled[0].to_mode == "rolling") == sticks

        yield from searched(family, count, draw, fits)


def jam() -> Iterator[Draw]:
    """Painlevé: no motion is consistent, and an impact without a collision resolves it."""

    def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
        ratio = rng.choice([0.05, 0.1, 0.125, 0.2])
        mu = round(rng.uniform(0.6, 1.2), 2)
        hoop = dict(
            mass_ratio=ratio,
            offset=1.0,
            inertia=ratio,
            mu_s=mu,
            mu_k=mu,
            restitution=rng.choice([0.0, 0.0, 0.5]),
            law="energetic",
        )
        return hoop, starts(rng, True, 1.0), 1.5

    yield from searched("jam", 20, draw, lambda m: causes(m)[:1] == ["jam"])


def reversals() -> Iterator[Draw]:
    """Slides that reverse their direction without sticking."""

    def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
        hoop = hoops(rng)
        hoop["mu_s"] = round(rng.uniform(0.02, 0.15), 3)
        hoop["mu_k"] = round(hoop["mu_s"] * rng.choice([0.5, 0.8, 0.9]), 4)
        return hoop, starts(rng, True), 4.0

    yield from searched("reversal-chain", 20, draw, lambda m: causes(m).count("reversal") >= 2)


def near_ties() -> Iterator[Draw]:
    """Rolling that just slips, and just does not: μs beside the largest demand of the orbit."""
    rng = random.Random(f"{SEED} near-tie")
    number = 0
    while number < 30:
        hoop, start = hoops(rng), starts(rng, False, 1.5)

        def rolls(mu: float, hoop: Draw = hoop, start: Draw = start) -> bool:
            motion = follow(hoop | dict(mu_s=mu, mu_k=round(0.5 * mu, 4)), start, None)
            return motion.outcome.kind == "rolls_forever" and not motion.transitions

        low, high = 0.02, 3.0
        if rolls(low) or not rolls(high) or start["theta_rate"] == 0:
            continue
        while math.nextafter(low, 4) < high:
            middle = (low + high) / 2
            low, high = (low, middle) if rolls(middle) else (middle, high)
        for distance in (1e-3, 1e-6, 1e-9, 1e-12, 1e-14):
            for mu in (high * (1 + distance), low * (1 - distance)):
                number += 1
                until = None if mu > high else 8.0
                yield case(
                    "near-tie", number, hoop | dict(mu_s=mu, mu_k=round(0.5 * mu, 4)), start, until
                )


def periodic() -> Iterator[Draw]:
    """Restitution 1: the energy stays but for friction.

    The bounces up to the time limit are all there are.
    """

    def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
        hoop = hoops(rng) | dict(restitution=1.0, law=rng.choice(LAWS))
        return hoop, starts(rng, True, 1.0) | dict(gap_rate=round(rng.uniform(0.3, 1.2), 2)), 5.0

    yield from searched("elastic", 12, draw, lambda m: 2 <= causes(m).count("landing") <= 12)


def elastic_settling() -> Iterator[Draw]:
    """Restitution 1 and bounces that settle all the same.

    The contact sticks in each: friction takes the energy.
    """
    names = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
    for number, (law, numbers, start, until) in enumerate(
        [
            ("energetic", (1.0, 1.0, 1.0, 0.5, 0.5), (1.0, 0.3, 0.5, 0.5), 27.5),
            (
                "energetic",
                (
                    1.7348422673698543,
                    0.3937041272098101,
                    1.28811503780063,
                    0.7856205442037261,
                    0.7856205442037261,
                ),
                (0.9633791393074782, 3.9276452086581672, 0.0, 0.0),
                2.0,
            ),
            (
                "poisson",
                (
                    2.293298154652688,
                    0.869142754233778,
                    1.2550335485153497,
                    0.49625337032117806,
                    0.49625337032117806,
                ),
                (-0.8343654715312427, -2.6327833968121177, 0.0, 0.0),
                2.0,
            ),
            ("poisson", (1.0, 1.0, 1.0, 0.33, 0.33), (-1.62, -0.82, 0.0, 0.17), 3.0),
            ("energetic", (0.25, 0.9, 0.125, 0.75, 0.75), (-2.78, -2.53, 0.0, 0.11), 1.5),
            ("energetic", (0.25, 1.0, 0.1875, 0.67, 0.603), (-2.7, -1.72, -0.11, 0.29), 4.0),
            ("energetic", (2.0, 0.75, 2.0, 0.5, 0.5), (2.87, 1.55, 0.0, 0.1), 5.0),
            ("energetic", (1.0, 1.0, 0.5, 0.32, 0.256), (-2.27, -1.62, 0.0, 0.11), 2.5),
            ("energetic", (0.5, 1.0, 0.25, 0.62, 0.62), (2.71, -2.63, 0.0, 0.29), 4.0),
            ("energetic", (2.0, 0.75, 2.0, 0.63, 0.504), (1.33, 1.08, 0.0, 0.02), 1.5),
            ("poisson", (0.25, 1.0, 0.25, 0.79, 0.632), (-2.62, -2.05, 0.0, 0.1), 1.5),
            ("poisson", (0.5, 0.75, 0.5, 0.54, 0.486), (0.11, -1.12, 0.0, 0.05), 2.5),
        ],
        1,
    ):
        hoop = dict(zip(names, numbers, strict=True)) | dict(restitution=1.0, law=law)
        first = dict(zip(("theta", "theta_rate", "slip", "gap_rate"), start, strict=True))
        yield case("elastic-settling", number, hoop, first, until)


def long_rolling() -> Iterator[Draw]:
    """Rolling for ever, which is proved, or for a long time."""
    yield from searched(
        "long-rolling",
        10,
        lambda rng: (hoops(rng), starts(rng, True, 1.5), None),
        lambda m: m.outcome.kind == "rolls_forever" and len(m.transitions) < 6,
    )
    for count, one in enumerate(
        searched(
            "long-rolling",
            8,
            lambda rng: (hoops(rng), starts(rng, False, 1.5), 1000.0),
            lambda m: not m.transitions and m.phases[0].mode == "rolling",
        )
    ):
        yield one | dict(name=f"long-rolling-{11 + count}")


def thrown() -> Iterator[Draw]:
    """Starts in flight."""

    def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
        return hoops(rng), starts(rng, True) | dict(gap_rate=round(rng.uniform(0.1, 2.0), 2)), None

    yield from searched("thrown", 12, draw, lambda m: m.outcome.kind == "landing")


def unloaded() -> Iterator[Draw]:
    """Starts at which the plane cannot hold the rim."""
    yield from searched(
        "leaves-at-once",
        12,
        lambda rng: (hoops(rng), starts(rng, True, 5.0), None),
        lambda m: m.sequence.startswith("F"),
    )


def massless() -> Iterator[Draw]:
    """Littlewood's own hoop: rolling, then gliding without any force."""

    def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
        mu_s = round(rng.uniform(0.1, 1.5), 2)
        hoop = dict(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=mu_s, mu_k=round(0.8 * mu_s, 3))
        return hoop, starts(rng, rng.random() < 0.4, 1.2), 6.0

    yield from searched(
        "massless", 28, draw, lambda m: any(phase.mode == "gliding" for phase in m.phases)
    )


def si() -> Iterator[Draw]:
    """The same kinds of motion in kilograms, metres and seconds."""
    rng = random.Random(f"{SEED} si")
    number = 0
    while number < 24:
        disc, particle = (
            rng.choice([0.124, 0.0244, 0.186, 0.14]),
            rng.choice([0.051, 0.066, 0.0355, 0.14]),
        )
        radius, inside = rng.choice([0.14, 0.3, 0.45]), rng.choice([0.0, 0.0, 0.02])
        hoop = dict(
            disc_mass_kg=disc,
            particle_mass_kg=particle,
            radius_m=radius,
            offset_m=radius - inside,
            inertia_kg_m2=float(f"{disc * radius**2:.6g}"),
            mu_s=round(rng.uniform(0.2, 0.7), 2),
            mu_k=0.2,
            gravity_m_per_s2=9.80665,
        )
        rate = round(rng.uniform(-15, 15), 1)
        start = dict(
            theta=round(rng.uniform(-3.1, 3.1), 2),
            theta_rate=rate,
            slip=round(rng.uniform(-1, 1), 2) if number % 2 else 0.0,
        )
        body = lw.Hoop.from_si(**hoop)
        units = body.units
        motion = body.simulate(
            theta=start["theta"],
            theta_rate=start["theta_rate"] * units.time_s,
            slip=start["slip"] * units.time_s / units.length_m,
            until=2.0 / units.time_s,
        )
        if len(motion.transitions) < 2 or motion.outcome.kind in (
            "ambiguous",
            "inconsistent",
            "singular",
            "unresolved",
        ):
            continue
        number += 1
        yield case("si", number, hoop, start, 2.0) | dict(units="si")


def paper() -> Iterator[Draw]:
    """Figure 3, and the motions of the reference data that are certified there."""
    thin = dict(mass_ratio=1.0, offset=1.0, inertia=1.0, mu_s=0.5, mu_k=0.4)
    start = dict(theta=math.pi / 2, theta_rate=2.0, slip=0.0)
    yield case("paper", 1, thin, start, None)
    yield case(
        "paper",
        2,
        dict(mass_ratio=0.0, offset=1.0, inertia=0.0, mu_s=0.5, mu_k=0.4),
        dict(theta=0.0, theta_rate=0.5, slip=0.0),
        None,
    )
    for number, (e, law) in enumerate(
        [
            (0.0, "energetic"),
            (0.5, "energetic"),
            (0.5, "poisson"),
            (0.5, "newton"),
            (0.8, "energetic"),
        ]
    ):
        yield case("paper", 3 + number, thin | dict(restitution=e, law=law), start, None)


def ramps() -> Iterator[Draw]:
    """Rolling, sliding and jumps on slopes."""

    def on_slope(hoop: Draw, rng: random.Random, steepest: float) -> Draw:
        return hoop | dict(slope=round(rng.uniform(0.05, steepest) * rng.choice([-1, 1]), 2))

    def drawn(
        steepest: float, until: float | None, slips: bool, rests: bool = False
    ) -> Callable[[random.Random], tuple[Draw, Draw, float | None]]:
        def draw(rng: random.Random) -> tuple[Draw, Draw, float | None]:
            start = starts(rng, slips, 2.0) | (dict(theta_rate=0.0) if rests else {})
            return on_slope(hoops(rng), rng, steepest), start, until

        return draw

    def balanced(rng: random.Random) -> tuple[Draw, Draw, float | None]:
        hoop, start, _ = drawn(0.9, 6.0, True)(rng)
        return hoop | dict(offset=0.0), start, 6.0

    def rolls_on(motion: Any) -> bool:
        return motion.outcome.kind == "rolls_forever" and len(motion.transitions) < 4

    parts = [
        ("ramp-rolling", 6, drawn(0.4, None, False, True), rolls_on),
        ("ramp-rolling", 4, drawn(0.4, None, True), lambda m: rolls_on(m) and bool(m.transitions)),
        (
            "ramp-rolling",
            4,
            drawn(0.4, 12.0, False),
            lambda m: not m.transitions and m.sequence == "R",
        ),
        ("ramp-rolling", 4, balanced, lambda m: m.sequence.endswith("R")),
        (
            "ramp-sliding",
            12,
            drawn(0.8, 6.0, True),
            lambda m: in_order(causes(m), ["stick", "slip"]) and on_plane(m),
        ),
        (
            "ramp-sliding",
            4,
            drawn(1.3, 4.0, True),
            lambda m: "reversal" in causes(m) and on_plane(m),
        ),
        (
            "ramp-jump",
            8,
            drawn(0.8, 20.0, False, True),
            lambda m: "lift_off" in causes(m) and lands(m),
        ),
        ("ramp-jump", 6, drawn(1.3, 12.0, True), lambda m: "lift_off" in causes(m) and lands(m)),
        ("ramp-jump", 2, drawn(1.3, 12.0, True), lambda m: m.sequence.startswith("F") and lands(m)),
    ]
    numbers: dict[str, int] = {}
    for part, (family, count, draw, fits) in enumerate(parts):
        for one in searched(family, count, draw, fits, str(part)):
            numbers[family] = numbers.get(family, 0) + 1
            yield one | dict(name=f"{family}-{numbers[family]:02d}")


def proved(
    family: str,
    parts: list[tuple[int, Callable[[random.Random], Draw], Callable[[Draw], bool]]],
    *first: Draw,
    most_bits: int = 1000,
    screened: bool = False,
) -> Iterator[Draw]:
    """Yield named cases, then draw until so many certificates of each part fit.

    The maker follows what is drawn, with so many bits; a motion has few events. What is screened
    has to fit by the library, too, which is faster.
    """
    found = 0
    for one in first:
        found += 1
        yield one | dict(name=f"{family}-{found:02d}")
    for part, (count, draw, fits) in enumerate(parts):
        rng = random.Random(f"{SEED} {family} {part}")
        wanted = found + count
        while found < wanted:
            one = draw(rng) | dict(family=family, name=f"{family}-{found + 1:02d}")
            if screened and not fits(sketch(one)):
                continue
            certificate = certify(Case.read(one), most_bits)
            if certificate["certified"] and len(certificate["events"]) < 14 and fits(certificate):
                found += 1
                yield one


def sketch(one: Draw) -> Draw:
    """Return what a certificate of a case would have of phases, events and end, by the library."""
    motion = follow(one["hoop"], one["start"], one["until"])
    end = {"theta_rate": [str(motion.outcome.state.theta_rate), "0"]}
    return dict(
        case=one,
        phases=[{"mode": phase.mode} for phase in motion.phases],
        events=[{"cause": event.cause, "to": event.to_mode} for event in motion.transitions],
        end={"kind": motion.outcome.kind, "state": end},
    )


def resisted(
    rng: random.Random,
    start: tuple[float, float, float],
    chi: tuple[float, float],
    mu_s: tuple[float, float],
    until: float | None = None,
    **hoop: float,
) -> Draw:
    """Return a hoop with rolling resistance, a start of θ, θ′ and η′, and a limit."""
    drawn = hoops(rng)
    drawn["mu_s"] = round(rng.uniform(*mu_s), 2)
    drawn["mu_k"] = round(drawn["mu_s"] * rng.choice([1.0, 0.9, 0.8, 0.6]), 3)
    drawn["rolling_resistance"] = float(f"{math.exp(rng.uniform(*map(math.log, chi))):.2g}")
    first = dict(
        zip(("theta", "theta_rate", "slip"), (round(one, 2) for one in start), strict=True)
    )
    return case("", 0, drawn | hoop, first, until)


def modes(certificate: Draw) -> list[str]:
    """Return the modes of the phases of a certificate."""
    return [one["mode"] for one in certificate["phases"]]


def rests_in(certificate: Draw, *wanted: str) -> bool:
    """Whether a motion comes to rest, and has all of these modes or causes on its way."""
    causes = [one["cause"] for one in certificate["events"]]
    return certificate["end"]["kind"] == "rests" and {*wanted} <= {*modes(certificate), *causes}


def angles(certificate: Draw) -> tuple[float, float]:
    """Return θ at the start and at the end."""
    return certificate["case"]["start"]["theta"], float(certificate["end"]["state"]["theta"][0])


def rests_rolling() -> Iterator[Draw]:
    """Librations and rotations that come to rest without a slip."""

    def librates(rng: random.Random) -> Draw:
        theta = math.pi + rng.uniform(0.4, 2.4) * rng.choice([-1, 1])
        return resisted(rng, (theta, 0.0, 0.0), (0.02, 0.2), (0.4, 1.2))

    def rotates(rng: random.Random) -> Draw:
        rate = rng.uniform(1.5, 3.5) * rng.choice([-1, 1])
        return resisted(rng, (rng.uniform(-3.1, 3.1), rate, 0.0), (0.06, 0.4), (1.0, 2.0))

    def rolls_only(certificate: Draw) -> bool:
        return rests_in(certificate) and {*modes(certificate)} == {"rolling", "rest"}

    def turned(certificate: Draw) -> float:
        start, end = angles(certificate)
        return abs(end - start)

    def far_side(certificate: Draw) -> bool:
        start, end = (math.sin(angle) for angle in angles(certificate))
        return len(certificate["events"]) == 1 and start * end < -0.02

    yield from proved(
        "rests-rolling",
        [
            (10, librates, lambda c: rolls_only(c) and len(c["events"]) > 1),
            (4, librates, lambda c: rolls_only(c) and far_side(c)),
            (10, rotates, lambda c: rolls_only(c) and turned(c) > 7),
        ],
    )


def rests_sliding() -> Iterator[Draw]:
    """Slides and skids on a level plane, up to rest."""

    def slips(rng: random.Random) -> Draw:
        slip = rng.choice([0.0, rng.uniform(-1, 1)])
        start = rng.uniform(-3.1, 3.1), rng.uniform(-2.5, 2.5), slip
        return resisted(rng, start, (0.02, 0.5), (0.1, 0.5))

    def reverses(rng: random.Random) -> Draw:
        start = rng.uniform(-3.1, 3.1), rng.uniform(-2.5, 2.5), rng.uniform(-0.3, 0.3)
        return resisted(rng, start, (0.1, 0.5), (0.03, 0.2))

    def skids(rng: random.Random) -> Draw:
        rate = rng.choice([0.0, rng.uniform(-0.3, 0.3)])
        start = rng.uniform(-3.1, 3.1), rate, rng.uniform(-1.5, 1.5)
        return resisted(rng, start, (0.05, 0.8), (0.1, 0.8), 40.0)

    skid = dict(mass_ratio=1.0, offset=0.6, inertia=0.5, mu_s=0.4, mu_k=0.3, rolling_resistance=0.1)
    yield from proved(
        "rests-sliding",
        [
            (10, slips, lambda c: rests_in(c, "slip", "stick")),
            (4, reverses, lambda c: rests_in(c, "reversal")),
            (5, skids, lambda c: rests_in(c, "skidding")),
            (5, skids, lambda c: rests_in(c, "skidding", "rolling")),
        ],
        case("rests-sliding", 1, skid, dict(theta=1.21625, theta_rate=0.0, slip=0.5), None),
    )


def rests_landing() -> Iterator[Draw]:
    """Thrown hoops with rolling resistance in their impacts, and jams."""

    def thrown(rng: random.Random, e: float, until: float | None) -> Draw:
        start = rng.uniform(-3.1, 3.1), rng.uniform(-1, 1), rng.uniform(-0.6, 0.6)
        found = resisted(rng, start, (0.05, 1.0), (0.1, 1.0), until, restitution=e)
        found["start"]["gap_rate"] = round(rng.uniform(0.3, 1.5), 2)
        return found | dict(hoop=found["hoop"] | dict(restitution_law=law(rng)))

    def law(rng: random.Random) -> str:
        return rng.choice(LAWS)

    def falls(rng: random.Random) -> Draw:
        return thrown(rng, 0.0, None)

    def bounces(rng: random.Random) -> Draw:
        return thrown(rng, rng.choice([0.3, 0.6, 0.9]), 4.0)

    def jams(rng: random.Random) -> Draw:
        ratio, mu = rng.choice([0.05, 0.1, 0.125, 0.2]), round(rng.uniform(0.6, 2.5), 2)
        start = (
            rng.uniform(-3.1, 3.1),
            rng.uniform(-1.5, 1.5),
            rng.choice([0.0, rng.uniform(-1, 1)]),
        )
        light = dict(mass_ratio=ratio, offset=1.0, inertia=ratio, mu_k=mu)
        found = resisted(rng, start, (0.3, 4.0), (mu, mu), restitution=0.0, **light)
        return found | dict(hoop=found["hoop"] | dict(restitution_law=law(rng)))

    yield from proved(
        "rests-landing",
        [
            (8, falls, lambda c: rests_in(c, "landing")),
            (4, bounces, lambda c: c["end"]["kind"] == "time_limit"),
            (4, jams, lambda c: rests_in(c, "jam")),
        ],
    )


def rests_massless() -> Iterator[Draw]:
    """Massless hoops with rolling resistance: they rest, or glide until the particle is down."""

    def drawn(rng: random.Random) -> Draw:
        rate = rng.choice([0.0, rng.uniform(-0.9, 0.9)])
        start = rng.uniform(-3.1, 3.1), rate, rng.choice([0.0, rng.uniform(-0.8, 0.8)])
        without = dict(mass_ratio=0.0, offset=1.0, inertia=0.0)
        return resisted(rng, start, (0.02, 0.6), (0.1, 1.5), 40.0, **without)

    def falls(certificate: Draw) -> bool:
        glides = modes(certificate).count("gliding") > 1 or "rolling" in modes(certificate)
        return certificate["end"]["kind"] == "particle_at_plane" and glides

    yield from proved(
        "rests-massless",
        [
            (3, drawn, lambda c: rests_in(c, "skidding")),
            (3, drawn, lambda c: rests_in(c, "rolling")),
            (2, drawn, lambda c: "normal_force_zero" in [one["cause"] for one in c["events"]]),
            (4, drawn, falls),
        ],
        most_bits=224,
        screened=True,
    )


def settled(
    rng: random.Random, e: float, laws: tuple[str, ...], slope: float, **hoop: float
) -> Draw:
    """Return a thrown hoop with rolling resistance whose bounces may settle."""
    start = rng.uniform(-3.1, 3.1), rng.uniform(-1, 1), rng.choice([0.0, rng.uniform(-0.6, 0.6)])
    found = resisted(rng, start, (0.02, 0.6), (0.1, 1.5), 6.0, restitution=e, **hoop)
    found["start"]["gap_rate"] = round(rng.uniform(0.02, 0.3), 2)
    if slope:
        found["hoop"]["slope"] = slope
    return found | dict(hoop=found["hoop"] | dict(restitution_law=rng.choice(laws)))


def settles(certificate: Draw) -> bool:
    """Whether bounces settle."""
    return "settle" in [one["cause"] for one in certificate["events"]]


def rests_elastic() -> Iterator[Draw]:
    """Full restitution with rolling resistance: bounces that settle by friction, and that do not.

    Where the couple holds the angle, and Newton's law returns all of the rate, they bounce on.
    """

    def bounces(rng: random.Random) -> Draw:
        return settled(rng, 1.0, ("energetic", "poisson"), 0.0)

    def goes_on(rng: random.Random) -> Draw:
        return settled(rng, 1.0, ("newton",), 0.0) | dict(until=2.0)

    def held(rng: random.Random) -> Draw:
        found = settled(rng, 1.0, ("energetic", "poisson"), 0.0) | dict(until=2.0)
        found["start"]["theta_rate"] = found["start"]["slip"] = 0.0
        return found

    def still(certificate: Draw) -> bool:
        last = certificate["end"].get("state", {})
        return certificate["end"]["kind"] == "time_limit" and float(last["theta_rate"][0]) == 0

    yield from proved(
        "rests-elastic",
        [
            (6, bounces, settles),
            (1, goes_on, lambda c: len(c["events"]) > 3),
            (1, held, lambda c: len(c["events"]) > 3 and still(c)),
        ],
        most_bits=224,
        screened=True,
    )


def ramp_settles() -> Iterator[Draw]:
    """Bounces that settle on a slope, with rolling resistance and without."""

    def steep(rng: random.Random) -> float:
        return round(rng.uniform(0.03, 0.35) * rng.choice([-1, 1]), 2)

    def bounces(rng: random.Random) -> Draw:
        return settled(rng, rng.choice([0.3, 0.5, 0.8]), LAWS, steep(rng))

    def plain(rng: random.Random) -> Draw:
        found = bounces(rng)
        del found["hoop"]["rolling_resistance"]
        return found

    def held(rng: random.Random) -> Draw:
        found = settled(rng, rng.choice([0.3, 0.5, 0.8]), LAWS, steep(rng), rolling_resistance=1.5)
        found["start"]["theta_rate"] = 0.0
        return found

    def into(mode: str) -> Callable[[Draw], bool]:
        def fits(certificate: Draw) -> bool:
            return any(
                one["cause"] == "settle" and one["to"] == mode for one in certificate["events"]
            )

        return fits

    yield from proved(
        "ramp-settles",
        [
            (3, bounces, into("rolling")),
            (3, bounces, into("sliding")),
            (2, held, into("rest")),
            (1, held, into("skidding")),
            (3, plain, into("rolling")),
            (2, plain, into("sliding")),
        ],
        most_bits=224,
        screened=True,
    )


def rests_si() -> Iterator[Draw]:
    """Rolling resistance in kilograms, metres and seconds: a length of millimetres."""

    def drawn(rng: random.Random) -> Draw:
        disc, particle = rng.choice([0.124, 0.0244, 0.186]), rng.choice([0.051, 0.066, 0.14])
        radius = rng.choice([0.14, 0.3, 0.45])
        mu_s = round(rng.uniform(0.2, 0.8), 2)
        hoop = dict(
            disc_mass_kg=disc,
            particle_mass_kg=particle,
            radius_m=radius,
            offset_m=round(radius * rng.choice([1.0, 0.9, 0.6]), 4),
            inertia_kg_m2=float(f"{disc * radius**2:.6g}"),
            mu_s=mu_s,
            mu_k=round(mu_s * rng.choice([1.0, 0.8]), 3),
            gravity_m_per_s2=9.80665,
            rolling_resistance_m=round(radius * rng.uniform(0.02, 0.3), 4),
        )
        slip = rng.choice([0.0, round(rng.uniform(-1, 1), 2)])
        start = dict(theta=round(rng.uniform(-3.1, 3.1), 2), slip=slip)
        start["theta_rate"] = round(rng.uniform(-15, 15), 1)
        return case("", 0, hoop, start, None) | dict(units="si")

    yield from proved(
        "rests-si",
        [
            (5, drawn, lambda c: rests_in(c, "rolling")),
            (3, drawn, lambda c: rests_in(c, "sliding", "rolling")),
        ],
    )


def ramp_rests() -> Iterator[Draw]:
    """Hoops and discs that come to rest on a slope; some roll on downhill."""

    def slope(rng: random.Random, steepest: float) -> float:
        return round(rng.uniform(0.03, steepest) * rng.choice([-1, 1]), 2)

    def hoop(rng: random.Random) -> Draw:
        slip = rng.choice([0.0, rng.uniform(-1, 1)])
        start = rng.uniform(-3.1, 3.1), rng.uniform(-2, 2), slip
        return resisted(rng, start, (0.03, 0.5), (0.3, 1.5), 40.0, slope=slope(rng, 0.35))

    def released(rng: random.Random) -> Draw:
        start = rng.uniform(-3.1, 3.1), 0.0, 0.0
        return resisted(rng, start, (0.03, 0.3), (0.3, 1.5), 40.0, slope=slope(rng, 0.35))

    def disc(rng: random.Random) -> Draw:
        start = rng.uniform(-3, 3), rng.uniform(-2, 2), rng.choice([0.0, rng.uniform(-2, 2)])
        steep = slope(rng, 0.4)
        return resisted(rng, start, (0.03, 0.6), (0.1, 0.8), 6.0, offset=0.0, slope=steep)

    def downhill(rng: random.Random) -> Draw:
        found = resisted(rng, (3.14, 0.0, 0.0), (0.02, 0.3), (1.5, 1.5), 10.0)
        side, hoop = rng.choice([-1, 1]), found["hoop"]
        hoop["slope"] = round(side * math.atan(hoop["rolling_resistance"] * 1.25), 3)
        found["start"]["theta_rate"] = round(side * rng.uniform(1.5, 2.5), 2)
        return found

    def rolls_on(certificate: Draw) -> bool:
        start, end = certificate["case"]["start"]["theta"], certificate["end"].get("state")
        on = certificate["end"]["kind"] == "time_limit" and modes(certificate)[-1] == "rolling"
        return on and end is not None and abs(float(end["theta"][0]) - start) > 6

    yield from proved(
        "ramp-rests",
        [
            (8, hoop, lambda c: rests_in(c, "sliding", "rolling")),
            (4, released, lambda c: rests_in(c, "rolling")),
            (4, disc, lambda c: rests_in(c, "turning_point")),
            (2, disc, lambda c: rests_in(c, "skidding")),
            (2, disc, rolls_on),
            (4, downhill, rolls_on),
        ],
    )


def on_plane(motion: Any) -> bool:
    """Whether the rim stays at the plane."""
    return "lift_off" not in causes(motion)


def lands(motion: Any) -> bool:
    """Whether a motion ends with a landing."""
    return motion.outcome.kind == "landing"


FAMILIES = (
    paper,
    slide_roll_slip,
    lift_off,
    landing,
    settlement,
    jam,
    reversals,
    near_ties,
    periodic,
    elastic_settling,
    long_rolling,
    thrown,
    unloaded,
    massless,
    si,
    ramps,
    rests_rolling,
    rests_sliding,
    rests_landing,
    ramp_rests,
    rests_massless,
    rests_elastic,
    ramp_settles,
    rests_si,
)


def main() -> None:
    """Write the list.

    A case that is there stays, as that of a near tie depends on the last bits of the library.
    """
    path = HERE.parents[1] / "python" / "littlewood" / "scoring" / "cases.json"
    text = path.read_text(encoding="utf-8")
    listed = json.loads(text)["cases"]
    there = {one["name"]: one for one in listed}
    cases = [there.get(one["name"], one) for family in FAMILIES for one in family()]
    assert len({one["name"] for one in cases}) == len(cases)
    # Those of the benchmark are written by hand.
    cases += [one for one in listed if one["family"] == "engines"]
    head, _ = text.split('"cases": [')
    lines = ",\n".join(json.dumps(one) for one in cases)
    path.write_text(f'{head}"cases": [\n{lines}\n]}}\n', encoding="utf-8")
    print(len(cases), "cases")


if __name__ == "__main__":
    main()
