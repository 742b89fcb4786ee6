"""Reference motions of the loaded hoop, to 25 digits.

    python3 -m pip install mpmath gmpy2        (gmpy2 only makes it faster)
    python3 motions.py                         writes motions.json beside this file
    python3 motions.py --list [NAME ...]       prints the transitions, writes nothing

What is independent here.  None of the reduced equations of motion is used.  At each evaluation the balances of
linear momentum of the mass centre (two), the balance of moment about it and one statement about the contact point
are set up as a linear system in (theta'', eta'', N, F) and solved by elimination.  The mass centre and the inertia
come from the two bodies (hoop and particle), and the energy is the sum over the two bodies.  Phases are integrated
by mpmath's Taylor method (odefun) with 40 digits, each event is found on a scan and refined until the event function
is seen to change sign within 1e-35 of the time given.  The whole of each motion in CHECKED is repeated with 50
digits, a finer scan and other orders of the Taylor method; the largest difference is written into the file.

Units: mass of the particle, radius and gravity are 1.  theta: angle of the particle from the upward vertical,
counterclockwise; eta' = x' + theta': velocity of the lowest point of the hoop, x being the centre of the hoop.
"""
import json
import os
import sys
import time

import mpmath as mp
from mpmath import mpf

DIGITS = 25                      # significant digits written
CHECKED = ("figure_3", "many_transitions", "very_light_hoop", "equal_friction")
PI = 3.141592653589793

# name: (mass_ratio, offset, inertia, mu_s, mu_k), (theta, theta_rate, slip), until
MOTIONS = {
    "figure_3": ((1.0, 1.0, 1.0, 0.5, 0.4), (PI / 2, 2.0, 0.0), 10.0),
    "equal_friction": ((1.0, 1.0, 1.0, 0.4, 0.4), (PI / 2, 2.0, 0.0), 10.0),
    "slide_reverses": ((1.0, 1.0, 1.0, 0.2, 0.15), (0.5, -1.2, 0.5), 10.0),
    "slide_sticks": ((1.0, 0.5, 1.0, 0.8, 0.6), (2.0, 1.0, 0.8), 3.0),
    "frictionless": ((2.0, 0.8, 1.0, 0.0, 0.0), (1.0, 1.1, 0.0), 7.0),
    # with mu_k = 0 a slide that began at the static limit also ends at it: the run stops before that tie
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
}


class Hoop:
    """Mass, place of the mass centre and inertia about it, from the hoop and the particle."""

    def __init__(self, mass_ratio, offset, inertia, mu_s, mu_k):
        self.m1, self.l, self.izz, self.mu_s, self.mu_k = map(mpf, (mass_ratio, offset, inertia, mu_s, mu_k))
        self.m = self.m1 + 1
        self.h = self.l / self.m                                                  # centre of hoop to mass centre
        self.i = self.izz + self.m1 * self.h**2 + (self.l - self.h)**2            # Huygens-Steiner, twice


def eliminate(rows):
    """Gauss with partial pivoting on an augmented n x (n+1) matrix: (solution, determinant)."""
    n, det = len(rows), mpf(1)
    for k in range(n):
        p = max(range(k, n), key=lambda r: abs(rows[r][k]))
        if p != k:
            rows[k], rows[p], det = rows[p], rows[k], -det
        det *= rows[k][k]
        for r in rows[k + 1:]:
            if r[k]:
                f = r[k] / rows[k][k]
                for j in range(k + 1, n + 1):
                    if rows[k][j]:
                        r[j] -= f * rows[k][j]
    out = [mpf(0)] * n
    for k in reversed(range(n)):
        out[k] = (rows[k][n] - sum(rows[k][j] * out[j] for j in range(k + 1, n) if rows[k][j])) / rows[k][k]
    return out, det


def newton_euler(b, theta, rate, mode, sigma=0, mu=None):
    """((theta'', eta'', N, F), determinant) of the hoop on the ground.

    Mass centre at (x - h sin theta, y + h cos theta) with x'' = eta'' - theta'' and y'' = 0 (the contact holds);
    contact point relative to the mass centre at (h sin theta, -1 - h cos theta).
    """
    c, s = mp.cos_sin(theta)
    px, py, u, zero, one = b.h * s, -1 - b.h * c, rate * rate, mpf(0), mpf(1)
    mu = b.mu_k if mu is None else mu
    return eliminate([
        [-b.m - b.m * b.h * c, b.m, zero, -one, -b.m * b.h * s * u],              # m xG'' = F
        [-b.m * b.h * s, zero, -one, zero, b.m * b.h * c * u - b.m],              # m yG'' = N - m
        [b.i, zero, -px, py, zero],                                               # I theta'' = px N - py F
        [zero, one, zero, zero, zero] if mode == "rolling" else [zero, zero, mu * sigma, one, zero],
    ])


def leaves_ground(b, theta, rate):
    """With no contact force the mass centre falls with 1 and theta'' = 0: does the lowest point then rise?"""
    return -1 + b.h * mp.cos(theta) * rate**2 > 0


def slides(b, theta, rate, sigma):
    """eta'' of the slide in direction sigma, or None where it would pull at the ground or has no regular solution."""
    (_, eta_acc, n, _), det = newton_euler(b, theta, rate, "sliding", sigma)
    smooth = newton_euler(b, theta, rate, "sliding", sigma, mpf(0))[1]
    return eta_acc if n > 0 and det * smooth > 0 else None


def first_mode(b, theta, rate, slip):
    """(mode, direction) that follows the given state on the ground; refuses what is not settled by the rules."""
    if slip != 0:
        sigma = 1 if slip > 0 else -1
        if slides(b, theta, rate, sigma) is not None and not leaves_ground(b, theta, rate):
            return "sliding", sigma
        assert leaves_ground(b, theta, rate)
        return "flight", 0
    _, _, n, f = newton_euler(b, theta, rate, "rolling")[0]
    assert n <= 0 or abs(abs(f) - b.mu_s * n) > mpf(10)**-9, "a tie: choose another motion"
    if n > 0 and abs(f) <= b.mu_s * n:
        return "rolling", 0
    ways = [g for g in (1, -1) if (slides(b, theta, rate, g) or 0) * g > 0]
    assert len(ways) + leaves_ground(b, theta, rate) == 1, (ways, leaves_ground(b, theta, rate))
    return ("sliding", ways[0]) if ways else ("flight", 0)


class Phase:
    """One phase from time t0 and state (theta, theta', eta', x): state at any later time and event functions.

    An event function is positive inside the phase and falls through zero where the phase ends.
    """

    def __init__(self, b, mode, sigma, t0, y0, degree=None):
        self.b, self.mode, self.sigma, self.t0, self.y0 = b, mode, sigma, t0, y0
        if mode == "flight":
            c, s = mp.cos_sin(y0[0])
            vx = y0[2] - y0[1]
            self.g0 = (y0[3] - b.h * s, 1 + b.h * c)                              # mass centre and its velocity
            self.v0 = (vx - b.h * c * y0[1], -b.h * s * y0[1])
            self.events = {"landing": lambda t: self.gap(t)[0]}
            return

        def derivative(_, y):
            a, e, _, _ = newton_euler(b, y[0], y[1], mode, sigma)[0]
            return [y[1], a, e, y[2] - y[1]]

        self.series = mp.odefun(derivative, t0, y0, degree=degree)
        if mode == "rolling":
            self.events = {"slip -": lambda t: self.margin(t, -1), "slip +": lambda t: self.margin(t, 1)}
        else:
            self.events = {"lift_off": lambda t: self.forces(t)[0], "stop": lambda t: sigma * self.state(t)[2]}

    def gap(self, t):
        """Height of the lowest point of the hoop over the ground, and its rate (zero unless in flight)."""
        if self.mode != "flight":
            return mpf(0), mpf(0)
        d = t - self.t0
        c, s = mp.cos_sin(self.y0[0] + self.y0[1] * d)
        return self.g0[1] + self.v0[1] * d - d * d / 2 - self.b.h * c - 1, self.v0[1] - d + self.b.h * s * self.y0[1]

    def state(self, t):
        if self.mode != "flight":
            return self.series(t)
        d, w = t - self.t0, self.y0[1]
        c, s = mp.cos_sin(self.y0[0] + w * d)
        return [self.y0[0] + w * d, w, self.v0[0] + self.b.h * c * w + w, self.g0[0] + self.v0[0] * d + self.b.h * s]

    def forces(self, t):
        """(N, F), with the sign of the determinant of the frictionless slide upheld."""
        if self.mode == "flight":
            return mpf(0), mpf(0)
        y = self.state(t)
        (_, _, n, f), det = newton_euler(self.b, y[0], y[1], self.mode, self.sigma)
        if self.mode == "sliding":
            assert det * newton_euler(self.b, y[0], y[1], "sliding", 0)[1] > 0, "slide without a regular solution"
        return n, f

    def margin(self, t, way):
        n, f = self.forces(t)
        return self.b.mu_s * n + way * f          # way: the direction of the slide that follows, against the force

    def energy(self, t):
        """Sum over hoop and particle; the potential energy is that of the paper plus mass times gap."""
        y, (gap, rise), b = self.state(t), self.gap(t), self.b
        c, s = mp.cos_sin(y[0])
        vx = y[2] - y[1]
        particle = (vx - b.l * c * y[1])**2 + (rise - b.l * s * y[1])**2
        return (b.m1 * (vx**2 + rise**2) + b.izz * y[1]**2 + particle) / 2 + b.l * c + b.m * gap


def dip(f, a, b):
    """Least value of f on [a, b], by golden section to a width far below the scan: (time, value)."""
    r = (mp.sqrt(5) - 1) / 2
    p, q = b - r * (b - a), a + r * (b - a)
    fp, fq = f(p), f(q)
    for _ in range(30):
        if fp < fq:
            b, q, fq = q, p, fp
            p = b - r * (b - a)
            fp = f(p)
        else:
            a, p, fp = p, q, fq
            q = a + r * (b - a)
            fq = f(q)
    return min(((p, fp), (q, fq)), key=lambda v: v[1])


def refine(f, a, b):
    """Root of f in [a, b] with f(a) > 0 >= f(b); the sign must change within 1e-35."""
    t = mp.findroot(f, (a, b), solver="anderson", tol=mpf(10)**(-2 * mp.mp.dps), maxsteps=200, verify=False)
    w = mpf(10)**(5 - mp.mp.dps)
    assert a < t <= b and f(t - w) > 0 > f(t + w), "the root is not certain"
    return t


def next_event(phase, until, step):
    """(name, time) of the first event of the phase, or None.  The scan starts with ever smaller steps at t0."""
    grid = [phase.t0] + [phase.t0 + step / 2**k for k in range(10, 0, -1)]
    while grid[-1] < until:
        grid.append(min(grid[-1] + step, until))
    names, last, values = list(phase.events), [], None
    for k, t in enumerate(grid):
        values = {n: phase.events[n](t) for n in names}
        last = (last + [(t, values)])[-3:]
        if k == 0:
            continue
        found = []
        for n in names:
            f = phase.events[n]
            if values[n] <= 0:
                assert k > 1 or last[0][1][n] > 0, "the phase ends as it starts"
                found.append((refine(f, last[-2][0], t), n))
            elif k > 1 and last[1][1][n] < min(last[0][1][n], values[n]):
                at, low = dip(f, last[0][0], t)
                assert abs(low) > mpf(10)**-9, "grazing: choose another motion"
                if low < 0:
                    found.append((refine(f, last[0][0], at), n))
        if found:
            at, n = min(found)
            return n, at
    return None


def follow(hoop, start, until, step, degree=None):
    b, t, y = Hoop(*hoop), mpf(0), [mpf(v) for v in start] + [mpf(0)]
    until = mpf(until)
    mode, sigma = first_mode(b, *y[:3])
    transitions, phases, ended = [], [], None
    while ended is None:
        phase = Phase(b, mode, sigma, t, y, degree)
        event = next_event(phase, until, mpf(step))
        stop = event[1] if event else until
        # samples at doubles, so that a program in double precision can be asked at the same times
        times = [mpf(float(t + (stop - t) * k / 6)) for k in range(1, 6)]
        phases.append(dict(mode=mode, direction=sigma, start=t, end=stop, samples=[sample(phase, v) for v in times]))
        t, y = stop, list(phase.state(stop))
        cause = event[0] if event else None
        if cause is None:
            ended = "time_limit"
            break
        if cause == "landing":
            mode, sigma, ended = None, None, "landing"
        elif cause == "lift_off":
            mode, sigma = "flight", 0
        elif cause == "stop":
            y[2], before = mpf(0), sigma
            mode, sigma = first_mode(b, *y[:3])
            assert (mode, sigma) == ("rolling", 0) or (mode, sigma) == ("sliding", -before), (mode, sigma)
            cause = "stick" if mode == "rolling" else "reversal"
        else:
            y[2] = mpf(0)
            cause, mode, sigma = "slip", "sliding", 1 if cause == "slip +" else -1
            accel = slides(b, y[0], y[1], sigma)
            assert accel is not None and (accel * sigma > 0 or b.mu_s == b.mu_k)
        transitions.append(dict(cause=cause, time=t, theta=y[0], theta_rate=y[1], slip=y[2], x=y[3], to=mode,
                                direction=sigma))
    end = sample(phase, t)
    return dict(initial={k: phases[0][k] for k in ("mode", "direction")}, transitions=transitions, phases=phases,
                ended=ended, end=end)


def sample(phase, t):
    y, (n, f), gap = phase.state(t), phase.forces(t), phase.gap(t)
    out = dict(time=t, theta=y[0], theta_rate=y[1], slip=y[2], x=y[3], normal=n, friction=f, energy=phase.energy(t))
    return dict(out, gap=gap[0], gap_rate=gap[1]) if phase.mode == "flight" else out


def written(v):
    """The tree with every mpf as a decimal string; what is zero but for rounding becomes 0.0."""
    if isinstance(v, dict):
        return {k: written(w) for k, w in v.items()}
    if isinstance(v, list):
        return [written(w) for w in v]
    return mp.nstr(v if abs(v) > mpf(10)**-34 else mpf(0), DIGITS) if isinstance(v, mpf) else v


def numbers(v):
    for w in v.values() if isinstance(v, dict) else v if isinstance(v, list) else ():
        yield from [w] if isinstance(w, mpf) else numbers(w)


def checked(name, found):
    """Largest difference of all numbers of a motion (relative above 1) from a run with 50 digits."""
    with mp.workdps(50):
        again = follow(*MOTIONS[name], step=0.004, degree=70)
        pairs = list(zip(numbers(found), numbers(again), strict=True))
        # the times of the samples are doubles taken from the same instants, hence equal
        return max(abs(p - q) / max(1, abs(q)) for p, q in pairs)


def main(args):
    mp.mp.dps = 40
    names = [a for a in args if not a.startswith("-")] or list(MOTIONS)
    out, checks, drift = [], {}, mpf(0)
    for name in names:
        began = time.time()
        hoop, start, until = MOTIONS[name]
        found = follow(hoop, start, until, step=0.005)
        print(f"{name}: {found['initial']} {found['ended']}  ({time.time() - began:.1f} s)", flush=True)
        for e in found["transitions"]:
            print("   ", e["cause"], "->", e["to"], e["direction"],
                  *(mp.nstr(e[k], 20) for k in ("time", "theta", "theta_rate", "slip", "x")))
        # energy may change in a slide with friction only
        for p in found["phases"]:
            if p["mode"] != "sliding" or hoop[4] == 0:
                e = [s["energy"] for s in p["samples"]]
                drift = max(drift, max(e) - min(e))
        if name in CHECKED and "--list" not in args:
            checks[name] = mp.nstr(checked(name, found), 3)
            print("    largest difference from 50 digits:", checks[name], flush=True)
        keys = zip(("hoop", "start"), (("mass_ratio", "offset", "inertia", "mu_s", "mu_k"),
                                       ("theta", "theta_rate", "slip")), (hoop, start))
        out.append(dict({"name": name}, **{k: dict(zip(f, v)) for k, f, v in keys}, until=until, **written(found)))
    print("largest change of the energy within a conservative phase:", mp.nstr(drift, 3))
    if "--list" in args:
        return
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "motions.json")
    with open(path, "w", encoding="ascii") as file:
        json.dump(dict(made_by="motions.py", working_digits=40, written_digits=DIGITS,
                       largest_difference_from_50_digits=checks, largest_energy_drift=mp.nstr(drift, 3),
                       motions=out), file, indent=1)
        file.write("\n")


if __name__ == "__main__":
    main(sys.argv[1:])
