"""The program of rolling resistance.

Without it the older references; closed forms, energy, and the numbers of the theory.
"""

import itertools
import json
import math
import sys
from pathlib import Path

import gmpy2
import mpmath as mp
import numpy as np
import pytest
from gmpy2 import mpfr

sys.path.insert(0, str(Path(__file__).parents[1]))

from follower.arithmetic import FINE, Tie, Work
from resistance import survey
from resistance.__main__ import BOUNCES, STEPS, motions
from resistance.balances import Body, State, answer, contact_mode
from resistance.choice import consistent, possible
from resistance.downhill import rotation
from resistance.impact import Velocities, impact, rates
from resistance.motion import follow
from resistance.written import NUMBERS, PLACE, START, entry

FOLDER = Path(__file__).parents[1]
PLACES = ("time", *PLACE)


def read(name):
    return json.loads((FOLDER / f"{name}.json").read_text(encoding="ascii"))


@pytest.fixture(autouse=True)
def precision():
    Work.use(FINE, STEPS)


@pytest.fixture(scope="module")
def file():
    return read("resistance")


def of_hoop(hoop, chi=0.0):
    names = ("mass_ratio", "offset", "inertia", "mu_s", "mu_k")
    return Body(*(hoop[name] for name in names), chi, hoop.get("slope") or 0.0)


def agree(found, expected, error):
    for value, text in zip(found, expected, strict=True):
        assert abs(value - mpfr(text)) <= error * max(1, abs(value))


def test_without_resistance_the_motions_are_those_of_the_reference():
    for given in read("motions")["motions"]:
        start = given["start"]
        state = start["theta"], start["theta_rate"], start["slip"], 0.0
        found = follow(of_hoop(given["hoop"]), state, given["until"])
        rows = given["transitions"]
        assert [one.cause for one in found.transitions] == [row["cause"] for row in rows]
        for one, row in zip(found.transitions, rows, strict=True):
            agree((one.time, *one.state), [row[name] for name in PLACES], mpfr("1e-24"))
        agree((found.time, *found.state), [given["end"][name] for name in PLACES], mpfr("1e-24"))


def test_without_resistance_bounces_settle_as_in_the_reference():
    Work.use(BOUNCES, STEPS)
    count = 0
    for given in read("bounces")["bounces"]:
        if given["restitution"] > 0.5:
            continue
        end, law = given["end"], (given["restitution"], given["law"])
        found = follow(Body(*given["hoop"], 0.0), given["start"], float(end["time"]) + 1e-3, law)
        settled = next(one for one in found.transitions if one.cause == "settle")
        after = settled.landing[1].after
        values = settled.time, settled.state.theta, after.rate, after.slip
        agree(values, [end[name] for name in ("time", "theta", "theta_rate", "slip")], 1e-24)
        count += 1
    assert count > 8


def test_the_file_is_what_the_program_makes(file):
    for name in ("discs", "impacts", "jams_of_rolling", "paradoxes", "ambiguous"):
        made = [entry(name, one, body, motion) for one, body, motion, _ in motions(name)]
        kept = [row for row in file["motions"] if row["family"] == name]
        assert json.loads(json.dumps(made)) == kept
    assert len(file["motions"]) >= 120


def given_body(row):
    return Body(*(row["hoop"][name] for name in NUMBERS))


def test_mirrored_starts_have_mirrored_motions(file):
    for row in file["motions"][::12]:
        hoop = [row["hoop"][name] for name in NUMBERS]
        start = [row["start"][name] for name in START]
        bounce = None if row["law"] is None else (row["restitution"], row["law"])
        Work.use(BOUNCES if bounce else FINE, STEPS)
        mirrored = follow(
            Body(*hoop[:-1], -hoop[-1]), [-v for v in start[:3]] + start[3:], row["until"], bounce
        )
        end = [row["end"][name] for name in PLACES]
        values = mirrored.time, *(-v for v in mirrored.state)
        assert mirrored.ended == row["ended"]
        agree(values, end, mpfr("1e-28"))


def energy(row, place, gap=0, gap_rate=0):
    """Energy of both bodies, from numbers as they are written, and the rounding of these."""
    hoop = {name: mp.mpf(row["hoop"][name]) for name in NUMBERS}
    theta, rate, slip, x = (mp.mpf(place[name]) for name in PLACE)
    s, c, offset, m1 = mp.sin(theta), mp.cos(theta), hoop["offset"], hoop["mass_ratio"]
    vx, vy = slip - rate, mp.mpf(gap_rate)
    particle = (vx - offset * c * rate) ** 2 + (vy - offset * s * rate) ** 2
    kinetic = (m1 * (vx**2 + vy**2) + hoop["inertia"] * rate**2 + particle) / 2
    high = mp.cos(hoop["slope"]) * (offset * c + (1 + m1) * gap)
    far = mp.sin(hoop["slope"]) * ((1 + m1) * x - offset * s)
    # 30 digits of each number: of squares twice their error, of the angle that of all its turns.
    size = 4 * kinetic + abs(high) + abs(far) + abs(theta) + (1 + m1) * (abs(x) + slip**2 + rate**2)
    return kinetic + high + far, size * mp.mpf("1e-29")


def lost(row):
    return sum(mp.mpf(v) for v in row["lost"].values())


def test_energy_goes_where_the_ledger_says(file):
    mp.mp.dps = 40
    count = 0
    for row in file["motions"]:
        start = row["start"] | {"x": 0.0}
        begin, error = energy(row, start, 0, start["gap_rate"])
        before = mp.mpf(0)
        for event in row["transitions"]:
            # A row of an impact has the state before it, and what is lost after it.
            after = event.get("after", {"gap_rate": event.get("gap_rate", 0)})
            now, rounding = energy(row, event | after, 0, after["gap_rate"])
            rounding += error + lost(event) * mp.mpf("1e-29")
            assert abs(begin - now - lost(event)) <= rounding
            assert lost(event) >= before - rounding or row["law"] == "newton"
            before, count = lost(event), count + 1
        for phase in row["phases"]:
            one = phase["sample"]
            if one:
                flight = mp.mpf(one.get("gap", 0)), one.get("gap_rate", 0)
                now, rounding = energy(row, one, *flight)
                assert abs(now - mp.mpf(one["energy"])) <= rounding
    assert count > 400


def accelerations(row, phase):
    """(theta'', eta'') of a disc in a phase."""
    hoop = {name: mp.mpf(row["hoop"][name]) for name in NUMBERS}
    m, inertia = 1 + hoop["mass_ratio"], hoop["inertia"]
    down, along = mp.cos(hoop["slope"]), mp.sin(hoop["slope"])
    chi, friction = phase["turning"] * hoop["rolling_resistance"], phase["direction"] * hoop["mu_k"]
    if phase["mode"] == "rolling":
        return m * (along - chi * down) / (inertia + m), mp.mpf(0)
    turn = mp.mpf(0) if phase["mode"] == "skidding" else -m * down * (friction + chi) / inertia
    return turn, turn - friction * down - along


def test_discs_are_in_closed_form(file):
    """Constant accelerations, from event to event; a disc skids if and only if mu_k <= chi."""
    mp.mp.dps = 40
    for row in (row for row in file["motions"] if row["family"] == "discs"):
        hoop = row["hoop"]
        place = {"time": 0.0, **row["start"], "x": 0.0}
        for phase, event in zip(row["phases"], [*row["transitions"], row["end"]], strict=False):
            turn, slip = accelerations(row, phase)
            if phase["mode"] == "skidding":
                assert hoop["mu_k"] <= hoop["rolling_resistance"]
            now, then = ({n: mp.mpf(p[n]) for n in PLACES} for p in (place, event))
            t = then["time"] - now["time"]
            expected = {
                "theta": now["theta"] + now["theta_rate"] * t + turn * t**2 / 2,
                "theta_rate": now["theta_rate"] + turn * t,
                "slip": now["slip"] + slip * t,
                "x": now["x"] + (now["slip"] - now["theta_rate"]) * t + (slip - turn) * t**2 / 2,
            }
            for name, value in expected.items():
                assert abs(value - then[name]) < mp.mpf("1e-27") * (1 + abs(value))
            zero = {"stick": "slip", "turning": "theta_rate"}.get(event.get("cause"))
            assert zero is None or then[zero] == 0
            place = event


def test_a_disc_slips_by_its_own_resistance():
    """Rolling on the level needs |F|/N = chi m/(I + m)."""
    body = Body(1.0, 0.0, 1.0, 0.3, 0.2, 0.7)
    modes = possible(body, State(mpfr(0.4), mpfr(1), mpfr(0), mpfr(0)))
    demand = body.chi * body.m / (body.i + body.m)
    assert demand > body.mu_s and [mode.name for mode in modes] == ["sliding"]


def swings(body, amplitude, until):
    """Distances of the turning points from the bottom."""
    motion = follow(body, (math.pi - amplitude, 0.0, 0.0, 0.0), until)
    bottom = gmpy2.const_pi()
    angles = [math.pi - amplitude]
    angles += [one.state.theta for one in motion.transitions if one.cause == "turning"]
    return motion, [abs(mpfr(theta) - bottom) for theta in angles]


def test_small_swings_lose_twice_the_arm_of_resistance():
    """2 chi/h a half swing, to the square of the amplitude; a rest where |h sin theta| <= chi."""
    body = Body(1.0, 0.6, 0.5, 0.9, 0.9, 3e-8)
    motion, found = swings(body, 1e-6, 1e4)
    for before, after in itertools.pairwise(found):
        assert abs((before - after) / (2 * body.chi / body.h) - 1) < 1e-11
    assert motion.ended == "rests" and len(found) == 6
    assert found[-1] <= body.chi / body.h < found[-2]


def real(v):
    """A number of gmpy2 as one of mpmath."""
    return mp.mpf(f"{v:.50g}") if isinstance(v, mpfr) else mp.mpf(v)


def loss_of_a_half_swing(body, amplitude):
    """The first order in chi, in closed form but for a quadrature."""
    m, h, offset, chi = (real(v) for v in (body.m, body.h, body.l, body.chi))
    a = real(body.i) + m * (1 + h * h)
    k = a - 2 * offset * mp.cos(amplitude)
    whole = mp.quad(
        lambda psi: mp.cos(psi) / (a - 2 * offset * mp.cos(psi)), [-amplitude, amplitude]
    )
    arms = 2 * amplitude - h * mp.sin(amplitude) + h * k * whole / 2
    return chi * m * arms / (offset * mp.sin(amplitude))


def test_large_swings_lose_what_the_first_order_says():
    mp.mp.dps = 30
    for numbers in ((1.0, 1.0, 1.0), (0.5, 0.4, 0.3), (2.0, 0.9, 1.5)):
        errors = []
        for chi in (1e-5, 1e-6):
            body = Body(*numbers, 9.0, 9.0, chi)
            _, found = swings(body, 1.25, 12)
            first = loss_of_a_half_swing(body, real(found[0]))
            errors.append(abs(real(found[0] - found[1]) / first - 1) / chi)
        # The next order is proportional to chi.
        assert errors[0] < 40 and errors[1] == pytest.approx(errors[0], rel=0.01)
    body = Body(0.8, 0.9, 0.5, 9.0, 9.0, 0.002)
    _, found = swings(body, 1.0, 5)
    assert float(loss_of_a_half_swing(body, mp.mpf(1))) == pytest.approx(0.010315, abs=5e-7)
    assert float(found[0] - found[1]) == pytest.approx(0.010290, abs=5e-7)


def test_a_skid_need_not_end_at_rest():
    motion = follow(Body(1.0, 0.6, 0.5, 0.4, 0.3, 0.1), (1.21625, 0.0, 0.5, 0.0), 100)
    assert [phase.mode.name for phase in motion.phases] == ["skidding", "rolling", "rolling"]
    times = [float(one.time) for one in motion.transitions]
    assert times == pytest.approx([0.5 / 0.3, 9.273748402, 14.997017142], abs=6e-10)
    assert motion.ended == "rests" and motion.transitions[-1].to.name == "rest"


def reduced(body, state):
    """a = h sin theta, d = 1 + h cos theta, J, and D_chi of a hoop that turns."""
    s, c = gmpy2.sin_cos(state.theta)
    a, d = body.h * s, 1 + body.h * c
    j = body.i + body.m * d * d
    return a, d, j, j + body.m * a * (a - gmpy2.sign(state.rate) * body.chi)


def test_where_rolling_has_a_paradox():
    """D_chi <= 0 somewhere if and only if 1 + m1 + Izz + l^2 <= l sqrt(4 + chi^2)."""
    random = np.random.default_rng(4)
    theta, seen = np.linspace(-np.pi, np.pi, 20_001), set()
    for _ in range(300):
        chi, offset = 10 ** random.uniform(-0.5, 0.7), random.uniform(0.5, 1)
        mass_ratio, inertia = random.uniform(0, 0.4, 2)
        body = Body(mass_ratio, offset, inertia, 1.0, 1.0, chi)
        m, h, i = float(body.m), float(body.h), float(body.i)
        a, d = h * np.sin(theta), 1 + h * np.cos(theta)
        least = (i + m * d * d + m * a * (a - chi)).min()
        expected = 1 + mass_ratio + inertia + offset**2 <= offset * math.sqrt(4 + chi**2)
        assert (least <= 0) == expected or abs(least) < 1e-6
        seen.add(expected)
    assert seen == {True, False}


def test_one_orbit_of_rolling_passes_through_the_zero_of_its_denominator():
    """It has u = kappa/beta and a positive normal force there; its neighbours stop or speed up."""
    body = Body(0.001, 1.0, 0.001, 9.0, 9.0, 0.5)
    m, h, chi = body.m, body.h, body.chi
    a0 = body.i + m * (1 + h * h)
    # 2 cos - chi sin = -A/l with D_chi falling in the direction of motion.
    theta = gmpy2.acos(-a0 / body.l / gmpy2.sqrt(4 + chi**2)) - gmpy2.atan2(chi, mpfr(2))
    s, c = gmpy2.sin_cos(theta)
    a, slope = h * s, -2 * body.l * s - chi * body.l * c
    kappa, beta = chi - a, a + h * c * chi
    assert abs(a0 + 2 * body.l * c - chi * body.l * s) < 1e-50
    assert slope < 0 < beta
    u = kappa / beta
    # du/dtheta = 2 m B/D_chi as a quotient of derivatives, B = a - chi + u (a + h c chi).
    steep = 2 * m * (h * c + u * (h * c - h * s * chi)) / (slope - 2 * m * beta)
    near = mpfr("1e-12")
    on, beside = [], []
    for step in (-near, near):
        square = u + steep * step
        for found, add in ((on, 0), (beside, mpfr("1e-6"))):
            state = State(theta + step, gmpy2.sqrt(square + add), mpfr(0), mpfr(0))
            found.append(answer(body, contact_mode(0, 1), state).normal)
    assert on[0] > 0.01 and abs(on[0] - on[1]) < 1e-9
    # Beside it the normal force has a pole.
    assert beside[0] * beside[1] < 0 and min(map(abs, beside)) > 1e3


def test_the_jam_of_rolling_stops_the_hoop_dead(file):
    """P = m |a theta'|, friction impulse m d theta', loss D theta'^2/2; then the hoop rests."""
    count = 0
    for row in (row for row in file["motions"] if row["family"] == "jams_of_rolling"):
        body = given_body(row)
        state = State(
            mpfr(row["start"]["theta"]), mpfr(row["start"]["theta_rate"]), mpfr(0), mpfr(0)
        )
        a, d, _, gap = reduced(body, state)
        before = Velocities(state.rate, state.slip, mpfr(0))
        found = impact(body, state.theta, before, mpfr(0), "energetic")
        if gap > 0 or found.segments[0] != [0, int(gmpy2.sign(state.rate))]:
            continue
        count += 1
        assert found.segments[-1] == [0, 0] and found.after == (0, 0, 0)
        whole = body.i + body.m * (a * a + d * d)
        loss = found.resistance + found.sliding + found.restitution
        assert abs(loss - whole * state.rate**2 / 2) < 1e-50
        assert row["ended"] == "rests" or row["restitution"]
    assert count > 1


def test_a_start_without_slip_and_without_motion():
    """With chi = 0 exactly one motion follows on the level; with chi it need not."""
    light = 5.256407325e-4
    numbers = light, 1.0, light, 0.0809887, 0.0354555
    state = State(mpfr(0.1197570), mpfr(0.7049970), mpfr(0), mpfr(0))
    assert consistent(Body(*numbers, 0.4198477), state) == []
    assert [mode.name for mode in possible(Body(*numbers, 0.0), state)] == ["rolling"]


def closed_form(body, start, theta, heading):
    """theta'^2 of rolling at an angle, from a start."""
    m, h, offset, chi, down, along, i = (
        real(v) for v in (body.m, body.h, body.l, body.chi, body.down, body.along, body.i)
    )
    a = i + m * (1 + h * h)
    chi = heading * chi
    root = mp.sqrt(a * a - offset * offset * (4 + chi * chi))

    def whole(angle):
        turns = mp.floor((angle + mp.pi) / (2 * mp.pi))
        arc = mp.atan(((a - 2 * offset) * mp.tan(angle / 2) - chi * offset) / root)
        return 2 * (arc + turns * mp.pi) / root

    def d(angle):
        return a + 2 * offset * mp.cos(angle) - chi * offset * mp.sin(angle)

    def g(angle):
        power = (d(angle) / d(start[0])) ** (-chi * chi / (4 + chi * chi))
        return power * mp.exp(
            2 * chi / (4 + chi * chi) * (angle - start[0] - a * (whole(angle) - whole(start[0])))
        )

    def gain(angle):
        arm, lever = h * mp.sin(angle), 1 + h * mp.cos(angle)
        return ((arm - chi) * down + lever * along) / g(angle)

    nodes = [start[0] + (theta - start[0]) * k / 12 for k in range(13)]
    return g(theta) * (d(start[0]) * start[1] ** 2 + 2 * m * mp.quad(gain, nodes)) / d(theta)


def test_rolling_is_in_closed_form():
    mp.mp.dps = 40
    for numbers, start, until in (
        ((1.0, 0.6, 0.5, 9.0, 9.0, 0.1, 0.0), (0.5, 1.5), 3.0),
        ((0.4, 0.9, 0.3, 9.0, 9.0, 0.05, 0.2), (2.0, 0.8), 6.0),
        ((2.0, 0.5, 1.0, 9.0, 9.0, 0.3, -0.1), (-2.0, -1.5), 4.0),
    ):
        body = Body(*numbers)
        found = follow(body, (*start, 0.0, 0.0), until)
        assert {phase.mode.name for phase in found.phases} == {"rolling"}
        end = found.transitions[0].state if found.transitions else found.state
        square = closed_form(
            body, tuple(map(mp.mpf, start)), real(end.theta), int(np.sign(start[1]))
        )
        assert abs(square - real(end.rate) ** 2) < mp.mpf("1e-30")


def test_the_periodic_rotation_downhill(file):
    mp.mp.dps = 40
    for row in file["rotations"]:
        body = Body(*row["hoop"])
        a = body.i + body.m * (1 + body.h**2)
        root = gmpy2.sqrt(a * a - body.l**2 * (4 + body.chi**2))
        exponent = -4 * gmpy2.const_pi() * body.chi / (4 + body.chi**2) * (a / root - 1)
        assert abs(gmpy2.exp(exponent) - mpfr(row["contraction"])) < mpfr("1e-28")
        heading = 1 if body.along > 0 else -1
        square = mp.mpf(row["square_rate"])
        after = closed_form(
            body, (mp.mpf(0), heading * mp.sqrt(square)), heading * 2 * mp.pi, heading
        )
        assert abs(after - square) < mp.mpf("1e-27")
    assert len(file["rotations"]) == 8


def test_the_window_of_the_rotation():
    """u + cos slope = K/D to first order; a steeper slope makes it slip before it loses contact."""

    def body(ratio, mu=9.0):
        return Body(1.0, 0.5, 0.8, mu, mu, 0.01, math.atan(0.01 * ratio))

    for ratio in (1.06, 1.1, 1.14):
        it = body(ratio)
        a = it.i + it.m * (1 + it.h**2)
        kappa = a / gmpy2.sqrt(a * a - 4 * it.l**2) - 1
        k = 4 * it.m * it.down * (it.along / it.down / it.chi - 1) / kappa
        found = rotation(it, 1.0, 1)
        assert found.square_rate == pytest.approx(k / (a + 2 * it.l) - it.down, rel=1e-4)
    edges = [1 + kappa * (a + 2 * it.l) * f / (4 * it.m) for f in (1, 1 + 1 / it.h)]
    assert edges == pytest.approx([1.0296, 1.1481], abs=5e-5)
    # Rotations slower than the periodic one do not slip: to three decimals from 1.128 and 1.141 on.
    for mu, slips in ((0.5, 1.128), (1.0, 1.141)):
        assert rotation(body(slips - 5e-4, mu), 2.0, 1).demand < mu
        with pytest.raises(Tie, match="slip"):
            rotation(body(slips + 5e-4, mu), 2.0, 1)


def test_where_a_periodic_rotation_presses_least():
    """At the top if K (A - 2 l) >= (A + 2 l)^2, else where D^3 = K (A^2 - 4 l^2); g_n = 1."""
    random = np.random.default_rng(6)
    theta, at_top = np.linspace(0, np.pi, 20_001), set()
    for _ in range(200):
        mass_ratio, offset = random.uniform(0.05, 3), random.uniform(0.2, 1)
        m, h = 1 + mass_ratio, offset / (1 + mass_ratio)
        a = m + mass_ratio * random.uniform(0.3, 1) + offset**2
        k = (a + 2 * offset) * (1 + random.uniform(0, 1) / h)
        d, s, c = a + 2 * offset * np.cos(theta), np.sin(theta), np.cos(theta)
        # u = K/D - 1, and theta'' = u'/2.
        normal = 1 - h * s * offset * s * k / d**2 - h * c * (k / d - 1)
        least = d[normal.argmin()]
        is_top = k * (a - 2 * offset) >= (a + 2 * offset) ** 2
        expected = a + 2 * offset if is_top else np.cbrt(k * (a * a - 4 * offset**2))
        assert least == pytest.approx(expected, rel=1e-3)
        at_top.add(bool(is_top))
    assert at_top == {True, False}


def test_segments_of_an_impact():
    """Rates per normal impulse, and that their signs leave one segment in each state."""
    random = np.random.default_rng(9)
    for _ in range(200):
        body = Body(*random.uniform(0.1, 1, 5), random.uniform(0, 1))
        state = State(mpfr(random.uniform(-3, 3)), mpfr(1), mpfr(1), mpfr(0))
        a, d, j, _ = reduced(body, state)
        m, i, mu, chi = body.m, body.i, body.mu_k, body.chi
        for slips, turns in ((1, 1), (1, -1), (-1, 1), (0, 1), (0, -1), (1, 0), (0, 0)):
            q, arm = a - slips * mu * d - turns * chi, a - turns * chi
            expected = {
                (True, True): (q / i, -slips * mu / m + d * q / i, 1 / m + a * q / i),
                (False, True): (arm / j, 0, (j + m * a * arm) / (m * j)),
                (True, False): (0, -slips * mu / m, 1 / m),
                (False, False): (0, 0, 1 / m),
            }[slips != 0, turns != 0]
            found = rates(body, state.theta, contact_mode(slips, turns))
            assert all(abs(v - w) < 1e-50 for v, w in zip(found[:3], expected, strict=True))


def test_impacts_have_up_to_four_segments(file):
    counts = {
        len(row["segments"])
        for motion in file["motions"]
        for row in motion["transitions"]
        if "segments" in row
    }
    assert counts == {1, 2, 3, 4}


def test_forces_of_a_sample_satisfy_the_laws_of_contact(file):
    for row in file["motions"]:
        hoop = row["hoop"]
        for phase in row["phases"]:
            one = phase["sample"]
            if one is None or "gap" in one:
                continue
            normal, friction, couple = (float(one[n]) for n in ("normal", "friction", "couple"))
            assert normal > 0 or phase["mode"] == "gliding"
            slips, turns = phase["direction"], phase["turning"]
            if slips:
                assert friction == pytest.approx(-slips * hoop["mu_k"] * normal, abs=1e-15)
            else:
                assert abs(friction) <= hoop["mu_s"] * normal
            if turns:
                assert couple == pytest.approx(
                    -turns * hoop["rolling_resistance"] * normal, abs=1e-15
                )
            else:
                assert abs(couple) <= hoop["rolling_resistance"] * normal


def test_at_rest_on_the_level_exactly_one_motion_follows():
    """The row that the theory proves, at random states."""
    found = survey.sets(survey.draw(np.random.default_rng(7), 20_000, 0, 0, 0))
    assert set(found) == {"rest", "rolling", "sliding"}


def test_sets_of_modes_at_random_states():
    """The table of the theory: its sets, and the shares of states without a motion."""
    count, random = 20_000, np.random.default_rng(8)
    for slope, slips, turns in itertools.product((0, 1), repeat=3):
        found = survey.sets(survey.draw(random, count, slope, slips, turns))
        share = {(0, 0): 0, (0, 1): 0.10, (1, 0): 0.14, (1, 1): 0.23}[slips, turns]
        assert found.get("none", 0) / count == pytest.approx(share, abs=0.01)
        several = {name for name in found if " " in name}
        assert (
            several
            <= {
                (0, 0): {"rolling skidding"} if slope else set(),
                (0, 1): {"sliding flight", "rolling flight"},
                (1, 0): set(),
                (1, 1): {"sliding flight"},
            }[slips, turns]
        )


def test_without_resistance_a_level_state_without_slip_has_exactly_one_motion():
    """With one coefficient of friction; with resistance some have none, and a few several."""
    random = np.random.default_rng(5)
    states = survey.draw(random, 80_000, 0, 0, 1)
    states["mu_k"] = states["mu_s"]
    found = survey.sets(states)
    assert found["none"] > 1000 and any(" " in name for name in found)
    found = survey.sets(states | {"chi": np.zeros(80_000)})
    assert set(found) == {"rolling", "sliding", "flight"}


def test_a_massless_hoop_is_caught_where_its_particle_turns():
    """A glide whose particle is highest inside the band of skidding goes on without turning."""
    body = Body(0.0, 1.0, 0.0, 0.5, 0.4, 0.3)
    state = State(mpfr(0.9), mpfr(0), mpfr(0.4), mpfr(0))
    a, d, *_ = reduced(body, state)
    inside = abs(a - body.mu_k * d) <= body.chi
    assert inside and [mode.name for mode in possible(body, state)] == ["skidding"]
    assert answer(body, contact_mode(1, 0), state).normal == 1
