"""First turns of the hoops of Theron and Maritz, many at once.

From the top to a revolution, θ′ = 0 or lift-off.

Of their hoops with a mass ratio of 1/3, or, with `rim`, of thin hoops with a particle on the rim.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import littlewood as lw
import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import xarray as xr

Floats = npt.NDArray[np.float64]
Texts = npt.NDArray[np.str_]

PHASES = 15
"""Phases after which a turn is given up: as many as a summary has."""

INSTANTS = np.linspace(0.0, 1.0, 33)[1:]
"""Instants of a slide at which it is asked whether the turn has stopped, as parts of it."""

SWING = 6.0
"""A slide that lasts longer is sampled: it may have swung forth and back, and forth again beyond
where it began.

In a slide u depends on θ alone, so that this takes a whole period, 4.7 at least for the family with
μ up to 0.3; swings are far from small, and with more friction slides are over sooner.
"""

TRANSITION_LIMIT = next(
    code for code, name in lw.tables.OUTCOMES.items() if name == "transition_limit"
)

TURN = 2.0 * math.pi


@dataclass(frozen=True)
class Turn:
    """A first turn: its phases with their durations up to the stop, and the stop."""

    word: str
    stop: str
    durations: tuple[float, ...]

    @property
    def name(self) -> str:
        """Phases and stop."""
        return f"{self.word} {self.stop}"


def body_of(gamma: Floats, *, rim: bool) -> tuple[Floats, Floats]:
    """Return m1/m2, which is I_zz, too, and ℓ of the bodies whose mass centre is at gamma."""
    return (
        (1.0 / gamma - 1.0, np.ones_like(gamma))
        if rim
        else (np.full_like(gamma, 1.0 / 3.0), gamma / 0.75)
    )


def hoop_of(mu: float, gamma: float, *, rim: bool = False) -> lw.Hoop:
    """Return the hoop whose mass centre is at gamma."""
    ratio, offset = (float(one[0]) for one in body_of(np.array([gamma]), rim=rim))
    return lw.Hoop(mass_ratio=ratio, offset=offset, inertia=ratio, mu_s=mu, mu_k=mu)


def first_turn(
    gamma: float, mu: float, rate: float, phases: int = 4 * PHASES, *, rim: bool = False
) -> Turn:
    """Follow a hoop from the top to a revolution, to θ′ = 0 or to lift-off, in so many phases."""
    hoop = hoop_of(mu, gamma, rim=rim)
    motion = hoop.simulate(theta=0.0, theta_rate=rate, proof="none", max_transitions=phases)
    word = ""
    durations: list[float] = []
    for phase in motion.phases:
        if phase.mode == "flight":
            return Turn(word + "F", "lifts off", tuple(durations))
        word += "R" if phase.mode == "rolling" else "+" if phase.direction > 0 else "-"
        if phase.end is None:
            durations.append(math.inf)
            return Turn(word, _rolling_stop(phase.energy_start, hoop.offset), tuple(durations))
        found = _stop_of(motion, phase)
        if found is not None:
            durations.append(found[1])
            return Turn(word, found[0], tuple(durations))
        durations.append(phase.duration)
    return Turn(word, "is given up", tuple(durations))


def _rolling_stop(energy: float, rest: float) -> str:
    """Return what stops a turn that rolls on.

    The energy at rest on the top decides, which is m h.
    """
    return "revolution" if energy > rest else "turns back"


def _stop_of(motion: lw.Trajectory, phase: lw.motion.Phase) -> tuple[str, float] | None:
    """Return the stop in a phase, and when since its beginning."""
    low, high = 0.0, phase.duration
    stop = ""
    for _ in range(7):
        times = low + (high - low) * INSTANTS
        samples = motion(phase.start.time + times, side="before")
        back, around = (
            np.asarray(samples["theta_rate"]) <= 0.0,
            np.asarray(samples["theta"]) >= TURN,
        )
        over = np.flatnonzero(back | around)
        if not len(over):
            return (stop, high) if stop else None
        place = int(over[0])
        stop = "revolution" if around[place] else "turns back"
        low, high = float(times[place - 1]) if place else low, float(times[place])
    return stop, high


def names_of(gamma: Floats, mu: Floats, rate: Floats, *, rim: bool = False) -> Texts:
    """Return the phases and stops of many first turns."""
    ratio, offset = body_of(gamma, rim=rim)
    # Small swings of the slides of a rim hoop have the period 2π √(k²/h).
    swing = (
        np.minimum(SWING, SWING * np.sqrt((1.0 - gamma**2) / gamma))
        if rim
        else np.full_like(gamma, SWING)
    )
    names = np.full(len(mu), "", dtype="U32")
    going = np.arange(len(mu))
    theta, time = np.zeros(len(mu)), np.zeros(len(mu))
    for count in range(1, PHASES + 1):
        if not len(going):
            break
        state = lw.simulate_many(
            mass_ratio=ratio[going],
            inertia=ratio[going],
            offset=offset[going],
            mu_s=mu[going],
            mu_k=mu[going],
            theta=0.0,
            theta_rate=rate[going],
            proof="none",
            max_transitions=count,
        )
        words = lw.sequence_names(state["sequence"].to_numpy())
        stops, asked = _stops(words, state, offset[going], theta, time, swing[going])
        for place in np.flatnonzero(asked):
            one = going[place]
            turn = first_turn(float(gamma[one]), float(mu[one]), float(rate[one]), count, rim=rim)
            names[one], stops[place] = turn.name, turn.stop.replace("is given up", "")
        told = ~asked & (stops != "")
        names[going[told]] = np.char.add(np.char.add(words[told], " "), stops[told])
        left = stops == ""
        theta, time = state["end_theta"].to_numpy()[left], state["end_time"].to_numpy()[left]
        going = going[left]
    names[going] = "is given up"
    return names


def slides_of(name: str) -> int:
    """Return the number of slides of a sequence."""
    return sum(mark in "+-" for mark in name.split()[0])


def _stops(
    words: Texts, state: xr.Dataset, rest: Floats, theta: Floats, time: Floats, swing: Floats
) -> tuple[Texts, npt.NDArray[np.bool_]]:
    """Return what stops the turns in their last phases, and where only samples can tell.

    Empty where nothing does.

    A hoop rolls through an angle forwards and backwards with the same friction, so that it slips at
    the first passage; and a slide has one u for an angle. So the ends of a phase tell, but where a
    slide may have swung to and fro, or has turned back after passing the top.
    """
    end, rate, energy = (
        state[name].to_numpy() for name in ("end_theta", "end_theta_rate", "energy")
    )
    last = np.array([word[-1] for word in words])
    endless = state["outcome"].to_numpy() != TRANSITION_LIMIT
    past, back = end >= TURN, rate <= 0.0
    stops = np.full(len(words), "", dtype="U10")
    slides = last != "R"
    over = np.where(slides, past | back, past | back | endless)
    top = np.where(slides, past, energy > rest)
    stops[over] = np.where(top[over], "revolution", "turns back")
    stops[last == "F"] = "lifts off"
    swung = slides & ~past & (end <= theta)
    stops[swung] = "turns back"
    asked = ~over & ~swung & (state["end_time"].to_numpy() - time > swing)
    return stops, slides & (last != "F") & (asked | ((swung | back) & ~past & (last == "+")))
