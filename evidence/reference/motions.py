"""Reference motions of the loaded hoop, to 25 digits, with samples of each phase.

    python3 motions.py                         writes motions.json beside this file
    python3 motions.py --list [NAME ...]       prints the transitions, writes nothing

The package `follower` follows each motion with 60 digits, and again to each sample; the motions in
CHECKED also with 40: the largest difference is written into the file.  What is computed here:
forces by elimination at a state, the gap of a flight from the fall of its mass centre, and the
energy, the sum over the two bodies.

Needs gmpy2 and python-flint.
"""

import json
import sys
from pathlib import Path

import gmpy2
from follower.arithmetic import FINE, FINEST, Work
from follower.contact import drift
from follower.hoop import Hoop, rolling_forces, slide_acceleration
from follower.motion import NUMBERS, follow
from gmpy2 import mpfr

DIGITS = 25  # significant digits written
MOST = 1000  # transitions of a motion
CHECKED = ("figure_3", "many_transitions", "very_light_hoop", "equal_friction")
HOOP, START = (
    ("mass_ratio", "offset", "inertia", "mu_s", "mu_k", "slope"),
    ("theta", "theta_rate", "slip"),
)
PI = 3.141592653589793

# name: (mass_ratio, offset, inertia, mu_s, mu_k[, slope]), (theta, theta_rate, slip), until
MOTIONS = {
    "figure_3": ((1.0, 1.0, 1.0, 0.5, 0.4), (PI / 2, 2.0, 0.0), 10.0),
    "equal_friction": ((1.0, 1.0, 1.0, 0.4, 0.4), (PI / 2, 2.0, 0.0), 10.0),
    "slide_reverses": ((1.0, 1.0, 1.0, 0.2, 0.15), (0.5, -1.2, 0.5), 10.0),
    "slide_sticks": ((1.0, 0.5, 1.0, 0.8, 0.6), (2.0, 1.0, 0.8), 3.0),
    "frictionless": ((2.0, 0.8, 1.0, 0.0, 0.0), (1.0, 1.1, 0.0), 7.0),
    # with mu_k = 0 a slide that began at the static limit also ends at it: the run stops before
    # that tie
    "no_kinetic_friction": ((1.0, 1.0, 1.0, 0.3, 0.0), (2.0, 1.7, 0.1), 3.0),
    "no_kinetic_friction_reversal": ((1.0, 1.0, 1.0, 0.3, 0.0), (PI / 2, 2.0, 0.0), 6.0),
    "strong_friction": ((1.0, 0.7, 0.8, 1.5, 1.2), (1.2, 2.6, 0.0), 8.0),
    "light_hoop": ((0.01, 1.0, 0.01, 0.5, 0.4), (0.2, 0.95, 0.0), 8.0),
    "very_light_hoop": ((1e-4, 1.0, 1e-4, 0.5, 0.4), (0.3, 0.5, 0.0), 4.5),
    "small_offset": ((0.5, 0.3, 0.4, 0.2, 0.15), (PI, 3.0, 0.0), 5.0),
    "no_offset": ((1.0, 0.0, 0.5, 0.3, 0.25), (0.3, 1.5, -0.9), 4.0),
    "negative_rate": ((0.7, 0.8, 0.6, 0.35, 0.25), (-1.1, -1.7, 0.2), 10.0),
    "turning_point_in_slide": ((1.0, 0.9, 0.7, 0.25, 0.2), (1.6, -0.5, 0.9), 5.0),
    "immediate_flight": ((1.0, 1.0, 1.0, 0.5, 0.4), (0.0, 4.0, 0.0), 10.0),
    "immediate_flight_with_slip": ((1.0, 1.0, 1.0, 0.5, 0.4), (0.4, 2.5, 0.7), 10.0),
    "many_transitions": ((1.0, 1.0, 1.0, 0.2, 0.1), (2.5, 1.5, -0.4), 8.0),
    "heavy_hoop": ((10.0, 1.0, 10.0, 0.08, 0.05), (1.5, 3.0, 0.4), 5.0),
    # rolling would need N <= 0, yet the contact holds: slides at once
    "band": ((1.0, 1.0, 1.0, 0.5, 0.4), (0.8, 1.62, 0.0), 10.0),
    "rolls_on": ((1.0, 1.0, 1.0, 1.0, 0.8), (PI, 2.0, 0.0), 4.0),
    "uphill_disc": ((1.0, 0.8, 0.5, 0.8, 0.6, 0.15), (-1.0, 0.0, 0.0), 12.0),
    "ramp_jump": ((2.0, 0.8, 1.0, 1.0, 1.0, 0.2617993877991494), (PI / 6, 0.0, 0.0), 20.0),
    "steep": ((1.0, 1.0, 1.0, 0.5, 0.4, 1.4), (2.0, -1.0, 0.3), 6.0),
    "uphill_slide": ((0.5, 0.9, 0.6, 0.3, 0.2, 0.1), (0.4, -2.5, 0.8), 8.0),
    "falls_away_to_the_right": ((1.0, 0.7, 0.8, 0.6, 0.5, -0.4), (-2.0, 0.5, 0.0), 12.0),
}


def gap_of(hoop, begin, t):
    """Gap and its rate in a flight that has begun at a state."""
    theta, rate, d = begin["theta"], begin["theta_rate"], t - begin["time"]
    (s0, c0), (s, c) = gmpy2.sin_cos(theta), gmpy2.sin_cos(theta + rate * d)
    up = -hoop.h * s0 * rate
    return up * d - hoop.down * d * d / 2 - hoop.h * (
        c - c0
    ), up - hoop.down * d + hoop.h * s * rate


def energy(hoop, state, gap):
    """Sum over hoop and particle.

    The potential energy is that of the paper plus mass times gap, and that of the fall along the
    plane.
    """
    (height, rise), rate, m1, izz = (
        gap,
        state["theta_rate"],
        *map(mpfr, (hoop.numbers[0], hoop.numbers[2])),
    )
    s, c = gmpy2.sin_cos(state["theta"])
    vx = state["slip"] - rate
    particle = (vx - hoop.l * c * rate) ** 2 + (rise - hoop.l * s * rate) ** 2
    up = hoop.down * (hoop.l * c + hoop.m * height) + hoop.along * (
        hoop.m * state["x"] - hoop.l * s
    )
    return (m1 * (vx**2 + rise**2) + izz * rate**2 + particle) / 2 + up


def sample(hoop, mode, sigma, begin, state):
    """A state in a phase that has begun at another, with forces, energy and, in flight, the gap."""
    theta, rate = state["theta"], state["theta_rate"]
    gap = gap_of(hoop, begin, state["time"]) if mode == "flight" else (mpfr(0), mpfr(0))
    if mode == "rolling":
        _, normal, friction = rolling_forces(hoop, theta, rate)
    elif mode == "sliding":
        normal = slide_acceleration(hoop, theta, rate, sigma)[1]
        friction = -hoop.mu_k * sigma * normal
    else:
        normal = friction = mpfr(0)
    out = dict(state, normal=normal, friction=friction, energy=energy(hoop, state, gap))
    return dict(out, gap=gap[0], gap_rate=gap[1]) if mode == "flight" else out


def motion(numbers, start, until, times=None):
    """Transitions, phases with samples, and the end, with the precision that is set.

    With the times of the samples of another run.
    """
    hoop, begins = Hoop(*numbers), dict(zip(NUMBERS, map(mpfr, (0, *start, 0))))

    def to(time):
        first, transitions, how, end = follow(numbers, (*start, 0), time, most=MOST)
        if how == "rolls_forever" and end["time"] < time:
            # It has turned once: on to the limit.
            theta, rate, _ = drift(
                hoop, "rolling", 0, (end["theta"], end["theta_rate"], mpfr(0)), time - end["time"]
            )
            end = dict(
                end,
                time=mpfr(time),
                theta=theta,
                theta_rate=rate,
                x=end["x"] - (theta - end["theta"]),
            )
        return first, transitions, how, end

    (mode, sigma), transitions, how, end = to(until)
    initial, phases = dict(mode=mode, direction=sigma), []
    for stop in [*transitions, *([] if how == "landing" else [end])]:
        first, last = begins["time"], stop["time"]
        # Samples at doubles, so that a program in double precision can be asked at the same times.
        at = (
            times[len(phases)]
            if times
            else [float(first + (last - first) * k / 6) for k in range(1, 6)]
        )
        samples = [sample(hoop, mode, sigma, begins, to(t)[3]) for t in at]
        phases.append(dict(mode=mode, direction=sigma, start=first, end=last, samples=samples))
        landed = stop.get("cause") == "landing"
        last_phase = mode, sigma, begins
        if "cause" in stop and not landed:
            mode, sigma, begins = stop["to"], stop["direction"], stop
    rows = [
        dict(
            cause=t["cause"],
            **{k: t[k] for k in NUMBERS},
            to=None if t["cause"] == "landing" else t["to"],
            direction=None if t["cause"] == "landing" else t["direction"],
        )
        for t in transitions
    ]
    return dict(
        initial=initial,
        transitions=rows,
        phases=phases,
        ended="landing" if how == "landing" else "time_limit",
        end=sample(hoop, *last_phase, end),
    )


def written(v):
    """The tree with every number as a decimal string; what is zero but for rounding becomes 0.0."""
    if isinstance(v, dict):
        return {k: written(w) for k, w in v.items()}
    if isinstance(v, list):
        return [written(w) for w in v]
    if not isinstance(v, type(mpfr(0))):
        return v
    return "{0:.{1}g}".format(v, DIGITS) if abs(v) > 1e-34 else "0.0"


def numbers_in(v):
    for w in v.values() if isinstance(v, dict) else v if isinstance(v, list) else ():
        yield from [w] if isinstance(w, type(mpfr(0))) else numbers_in(w)


def checked(given, found):
    """Largest difference of all numbers of a motion from a run with 40 digits.

    It is relative above 1.
    """
    Work.use(FINE)
    times = [[float(one["time"]) for one in phase["samples"]] for phase in found["phases"]]
    pairs = list(zip(numbers_in(found), numbers_in(motion(*given, times)), strict=True))
    Work.use(FINEST)
    return max(abs(p - q) / max(1, abs(p)) for p, q in pairs)


def main(args):
    Work.use(FINEST)
    out, checks, drift = [], {}, mpfr(0)
    for name in [a for a in args if not a.startswith("-")] or MOTIONS:
        found = motion(*MOTIONS[name])
        print(f"{name}: {found['initial']} {found['ended']}", flush=True)
        for e in found["transitions"]:
            print(
                "   ",
                e["cause"],
                "->",
                e["to"],
                e["direction"],
                *("{0:.20g}".format(e[k]) for k in NUMBERS),
            )
        hoop, start, until = MOTIONS[name]
        # Energy may change in a slide with friction only.
        for p in found["phases"]:
            if p["mode"] != "sliding" or hoop[4] == 0:
                energies = [s["energy"] for s in p["samples"]]
                drift = max(drift, max(energies) - min(energies))
        if name in CHECKED and "--list" not in args:
            checks[name] = "{0:.3g}".format(checked(MOTIONS[name], found))
        out.append(
            dict(
                name=name,
                hoop=dict(zip(HOOP, hoop)),
                start=dict(zip(START, start)),
                until=until,
                **written(found),
            )
        )
    print(f"largest change of the energy within a conservative phase: {drift:.3g}", checks)
    if "--list" not in args:
        head = dict(
            made_by="motions.py",
            working_digits=60,
            written_digits=DIGITS,
            largest_difference_from_40_digits=checks,
        )
        text = json.dumps(dict(head, largest_energy_drift=f"{drift:.3g}", motions=out), indent=1)
        Path(__file__).with_name("motions.json").write_text(text + "\n", encoding="ascii")


if __name__ == "__main__":
    main(sys.argv[1:])
