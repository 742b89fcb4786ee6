"""The equations of the theory at random states: against Newton's and Euler's laws, and against the
library.
"""

import math

import littlewood as lw
import numpy as np
import pytest

RANDOM = np.random.default_rng(2019)


class Body:
    """A random heavy hoop and a state, with the symbols of the text."""

    def __init__(self, steep: bool = False) -> None:
        m1, self.l = RANDOM.uniform(0.05, 3), RANDOM.uniform(0.1, 1)
        izz = RANDOM.uniform(0.1, 1) * m1 * (0.05 if steep else 1)
        self.mu_k = RANDOM.uniform(0.05, 4 if steep else 0.8)
        self.mu_s = self.mu_k * RANDOM.uniform(1, 1.5)
        self.hoop = lw.Hoop(
            mass_ratio=m1, offset=self.l, inertia=izz, mu_s=self.mu_s, mu_k=self.mu_k
        )
        self.m, self.h = 1 + m1, self.l / (1 + m1)
        self.I = izz + m1 * self.l**2 / self.m  # (T1.1)
        self.theta, self.rate, self.slip = (
            RANDOM.uniform(-math.pi, math.pi),
            RANDOM.normal(0, 1.5),
            RANDOM.normal(),
        )
        self.at(self.theta)
        self.u = self.rate**2

    def at(self, theta: float) -> None:
        m, h, inertia = self.m, self.h, self.I
        self.s, self.c = math.sin(theta), math.cos(theta)
        lever = 1 + h * self.c
        self.A, self.B, self.C = (
            1 / m + lever**2 / inertia,
            h * self.s * lever / inertia,
            1 / m + (h * self.s) ** 2 / inertia,
        )
        self.D = inertia + m * (1 + h * h) + 2 * self.l * self.c  # (T1.7)

    @property
    def w(self) -> float:
        return 1 - self.h * self.c * self.u

    def newton(
        self, friction: float, normal: float, couple: float = 0, slope: float = 0
    ) -> tuple[float, float, float]:
        """(θ″, η″, y″) of (T1.4), by the accelerations of the mass centre."""
        m, h, s, c = self.m, self.h, self.s, self.c
        turn = (h * s * normal + (1 + h * c) * friction + couple) / self.I
        along, up = friction / m - math.sin(slope), normal / m - math.cos(slope)
        # x̄ = x − h sin θ and ȳ = 1 + y + h cos θ, differentiated twice.
        x = along + h * (c * turn - s * self.u)
        y = up + h * (s * turn + c * self.u)
        return turn, x + turn, y

    def slide(self, sigma: float) -> tuple[float, float, float]:
        """(P, q, N) of (T2.2)."""
        f = self.mu_k * sigma
        q = self.h * self.s - f * (1 + self.h * self.c)
        p = self.I + self.m * self.h * self.s * q
        return p, q, self.m * self.I * self.w / p


def bodies(count: int = 200, steep: bool = False) -> list[Body]:
    return [Body(steep) for _ in range(count)]


def test_body():
    for it in bodies():
        assert it.hoop.inertia_about_mass_centre == pytest.approx(it.I, rel=1e-14)
        friction, normal = RANDOM.normal(), RANDOM.normal()
        _, slip, gap = it.newton(friction, normal)
        assert slip == pytest.approx(
            -it.h * it.s * it.u + it.A * friction + it.B * normal
        )  # (T1.5)
        assert gap == pytest.approx(-it.w + it.B * friction + it.C * normal)
        assert it.A * it.C - it.B**2 == pytest.approx(it.D / (it.m**2 * it.I))
        # (T1.8) and (T1.9): the power, by a small step of a body with a gap.
        gap_rate = RANDOM.normal()

        def energy(theta, rate, slip, gap, gap_rate, it=it):
            s, c = math.sin(theta), math.cos(theta)
            along, up = slip - (1 + it.h * c) * rate, gap_rate - it.h * s * rate  # (T1.3)
            return 0.5 * it.m * (along**2 + up**2) + 0.5 * it.I * rate**2 + it.m * gap + it.l * c

        turn, slip_rate, gap_acceleration = it.newton(friction, normal)
        step = 1e-6
        ends = [
            energy(
                it.theta + d * it.rate,
                it.rate + d * turn,
                it.slip + d * slip_rate,
                d * gap_rate,
                gap_rate + d * gap_acceleration,
            )
            for d in (-step, step)
        ]
        assert (ends[1] - ends[0]) / (2 * step) == pytest.approx(
            friction * it.slip + normal * gap_rate, rel=1e-6, abs=1e-6
        )


def test_contact():
    for it in bodies(steep=True):
        det = it.A * it.C - it.B**2
        normal = (it.A * it.w - it.B * it.h * it.s * it.u) / det  # (T2.1)
        friction = (it.C * it.h * it.s * it.u - it.B * it.w) / det
        assert it.newton(friction, normal)[1:] == pytest.approx(
            (0, 0), abs=1e-9 * (abs(normal) + abs(friction) + 1)
        )
        found = it.hoop.classify(theta=it.theta, theta_rate=it.rate)
        assert (found.rolling_normal, found.rolling_friction) == pytest.approx(
            (normal, friction), rel=1e-9, abs=1e-9
        )
        for sigma in (-1, 1):
            p, _, held = it.slide(sigma)
            f = it.mu_k * sigma
            _, slip, gap = it.newton(-f * held, held)
            assert gap == pytest.approx(0, abs=1e-9 * (1 + abs(held)))
            assert slip == pytest.approx(
                -it.D / (it.m * p) * (friction + f * normal), rel=1e-7, abs=1e-8
            )  # (T2.3)
            # (T2.4): P < 0 where σ s > 0 and μk exceeds the threshold.
            least = it.C / abs(it.B)
            assert (p < 0) == (sigma * it.s > 0 and it.mu_k > least)


def test_least_painleve():
    for h in (0.5, 0.75, 0.9):
        theta = np.linspace(1e-4, math.pi - 1e-4, 200_001)
        m, inertia = 1 / h, (1 - h * h) / h
        least = (
            (inertia + m * (h * np.sin(theta)) ** 2)
            / (m * h * np.sin(theta) * (1 + h * np.cos(theta)))
        ).min()
        assert least == pytest.approx(math.sqrt(1 - h * h) / h, rel=1e-8)  # (T2.5)


def test_rolling():
    for it in bodies():
        k = 2 * (0.5 * it.D * it.u + it.l * it.c) + it.I + it.m * (1 + it.h**2)
        assert it.u + 1 == pytest.approx(k / it.D)  # (T3.1)
        found = it.hoop.classify(theta=it.theta, theta_rate=it.rate)
        normal, friction = found.rolling_normal, found.rolling_friction
        assert it.newton(friction, normal)[0] == pytest.approx(
            it.l * it.s * k / it.D**2, abs=1e-9
        )  # (T3.2)
        square, rest = it.D**2, it.I + it.m * it.h**2 + it.l * it.c
        assert normal * square == pytest.approx(
            (it.m + it.l * it.c) * square - it.l * k * (it.l * it.s**2 + it.c * it.D)
        )
        assert friction * square == pytest.approx(
            it.l * it.s * (k * rest - square), abs=1e-9
        )  # (T3.3)
        for side in (-1, 1):
            a = (it.mu_s * (it.m + it.l * it.c) + side * it.l * it.s) * square
            b = it.l * (it.mu_s * (it.l * it.s**2 + it.c * it.D) + side * it.s * rest)
            assert (it.mu_s * normal - side * friction) * square == pytest.approx(
                a - k * b
            )  # (T3.4)


def test_time_of_rolling():
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=5, mu_k=5)
    motion = hoop.simulate(theta=1.0, theta_rate=0.2)
    period = motion.outcome.period
    m, h, inertia = 2, 0.5, 1.5
    lowest = inertia + m * (1 - h) ** 2
    k = (inertia + m * (1 + h * h) + 2 * math.cos(1.0)) * (0.2**2 + 1)
    # From the bottom to the turning point, z = z1 sin ψ takes the singularity away.
    z1 = math.sqrt((k - lowest) / 4)
    nodes, weights = np.polynomial.legendre.leggauss(200)
    psi = (nodes + 1) * math.pi / 4
    z = z1 * np.sin(psi)
    # (T3.5), where K − D = 4ℓ(z1² − z²) and dz = z1 cos ψ dψ.
    quarter = 2 * np.sum(weights * np.sqrt((lowest + 4 * z * z) / 4 / (1 - z * z))) * math.pi / 4
    assert 4 * quarter == pytest.approx(period, rel=1e-12)


def test_massless_rolling():
    hoop = lw.Hoop(mass_ratio=0, offset=1, inertia=0, mu_s=0.5, mu_k=0.5)
    for theta, rate in RANDOM.uniform(-0.9, 0.9, (50, 2)):
        found = hoop.classify(theta=theta, theta_rate=rate)
        assert found.rolling_normal == pytest.approx(
            math.cos(theta / 2) ** 2 * (1 - rate**2)
        )  # (T3.6)
        assert found.rolling_friction == pytest.approx(-0.5 * math.sin(theta) * (1 - rate**2))
        motion = hoop.simulate(theta=theta, theta_rate=rate)
        end = motion.phases[0].end
        assert end is not None
        t = np.linspace(0, end.time, 5)[1:-1]
        z, slope = math.sin(theta / 2), math.cos(theta / 2) * rate / 2
        expected = z * np.cosh(t / 2) + 2 * slope * np.sinh(t / 2)  # (T3.7)
        assert np.sin(motion(t)["theta"] / 2) == pytest.approx(expected, abs=1e-13)
    slow, fast = (hoop.simulate(theta=0, theta_rate=rate).transitions[0] for rate in (0.3, 0.9))
    assert slow.time == pytest.approx(2 * math.asinh(math.sin(math.atan(0.5)) / 0.3), rel=1e-13)
    assert fast.time == pytest.approx(math.acosh(1 / 0.9**2), rel=1e-13)  # (T3.8)
    corner = 1 + 2 * math.cos(2 * math.atan(0.5))  # (T6.6)
    types = [
        hoop.classify(theta=0, theta_rate=math.sqrt((corner - 1) / 2 + d)).rolling_type
        for d in (-1e-6, 1e-6)
    ]
    assert types == ["III", "I"]


def test_sliding():
    for it in bodies():
        sigma = math.copysign(1, it.slip)
        p, q, normal = it.slide(sigma)
        f = it.mu_k * sigma
        turn, slip, _ = it.newton(-f * normal, normal)
        assert turn == pytest.approx(it.m * q * it.w / p)  # (T4.1)
        lever = 1 + it.h * it.c
        assert slip == pytest.approx((it.m * lever * q - f * it.I) * it.w / p - it.h * it.s * it.u)


def test_slides_are_one_family():
    hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
    motions = [
        hoop.simulate(theta=0.3, theta_rate=rate, slip=6.0, until=0.6) for rate in (0.9, 1.1, 1.4)
    ]
    thetas = np.linspace(0.4, 0.7, 5)

    def square(motion):
        times = np.linspace(0, 0.6, 20_001)
        samples = motion(times)
        return np.interp(thetas, samples["theta"], samples["theta_rate"] ** 2)

    one, two, three = map(square, motions)
    # u = U_p + k U_h: differences of slides are multiples of one function (T4.3).
    assert (two - one) / (three - one) == pytest.approx(
        (1.1**2 - 0.9**2) / (1.4**2 - 0.9**2), rel=1e-6
    )


def test_first_integrals_of_a_slide():
    hoop = lw.Hoop(mass_ratio=0.7, offset=0.8, inertia=0.5, mu_s=0.5, mu_k=0.4)
    motion = hoop.simulate(theta=0.3, theta_rate=-1.2, slip=5.0)
    t = np.linspace(0, 0.9 * motion.transitions[0].time, 7)
    it, h, f = motion(t), hoop.h, 0.4
    s, c = np.sin(it["theta"]), np.cos(it["theta"])
    first = it["slip"] - it["theta_rate"] * (1 + h * c + f * h * s) + f * t  # (T4.4)
    assert first == pytest.approx(first[0], abs=1e-13)
    second = it["x"] - h * s + f * (1 + h * c + t**2 / 2)
    assert np.diff(second, 2) == pytest.approx(np.zeros(5), abs=1e-13)


def lifts_off(count: int) -> list[lw.Trajectory]:
    """Motions that slide off the plane and land, of random hoops."""
    found: list[lw.Trajectory] = []
    while len(found) < count:
        it = Body()
        motion = it.hoop.simulate(
            theta=it.theta, theta_rate=2 * it.rate, slip=it.slip, until=50, max_transitions=50
        )
        causes = [one.cause for one in motion.transitions]
        if causes[-2:] == ["lift_off", "landing"]:
            found.append(motion)
    return found


def test_jumps():
    for motion in lifts_off(40):
        off, land = motion.transitions[-2:]
        h = motion.hoop.h
        start = math.remainder(off.state.theta, 2 * math.pi)
        assert h * math.cos(start) * off.state.theta_rate**2 == pytest.approx(1, rel=1e-12)
        assert start * off.state.theta_rate < 0  # (T4.6)
        phi = abs(land.state.theta - off.state.theta)
        big, small = math.cos(phi) - 1 + phi**2 / 2, phi - math.sin(phi)
        assert big / small == pytest.approx(math.tan(abs(start)), rel=1e-10)  # (T5.5)
        assert land.time - off.time == pytest.approx(
            phi * math.sqrt(h * math.cos(start)), rel=1e-12
        )  # (T5.6)
        top = motion(off.time + 0.5 * (land.time - off.time))
        turned = 0.5 * phi
        gap = -h * (
            math.cos(start) * (math.cos(turned) - 1 + turned**2 / 2)
            - math.sin(abs(start)) * (turned - math.sin(turned))
        )
        assert float(top["gap"]) == pytest.approx(gap, rel=1e-9)  # (T5.4)


def test_one_landing():
    phi = np.linspace(1e-3, 40, 4001)
    big, small = np.cos(phi) - 1 + phi**2 / 2, phi - np.sin(phi)
    square = (phi * np.cos(phi / 2) - 2 * np.sin(phi / 2)) ** 2
    assert small**2 - big * (1 - np.cos(phi)) == pytest.approx(square, abs=1e-10)  # (T5.7)
    graze = 8.986818915818128
    assert math.tan(graze / 2) == pytest.approx(graze / 2, rel=1e-12)
    angle = math.atan((math.cos(graze) - 1 + graze**2 / 2) / (graze - math.sin(graze)))
    assert angle == pytest.approx(1.3518, abs=5e-5)
    tiny = 0.01
    assert ((math.cos(tiny) - 1 + tiny**2 / 2) / (tiny - math.sin(tiny))) == pytest.approx(
        tiny / 4, rel=1e-4
    )  # (T5.8)
    assert (tiny - math.sin(tiny)) / (1 - math.cos(tiny)) == pytest.approx(tiny / 3, rel=1e-4)


def test_jump_of_figure_3():
    off, land = lw.case("figure-3").simulate().transitions[-2:]
    assert off.state.theta == pytest.approx(5.2367, abs=5e-5)
    assert 2 * math.pi - off.state.theta == pytest.approx(1.0464, abs=5e-5)
    assert land.state.theta - off.state.theta == pytest.approx(4.6544, abs=5e-5)


def test_gliding():
    hoop = lw.Hoop(mass_ratio=0, offset=0.8, inertia=0, mu_s=0.5, mu_k=0.4)
    motion = hoop.simulate(theta=1.4, theta_rate=0.5, slip=0.7)
    phase = motion.phases[0]
    assert phase.mode == "gliding" and phase.end is not None
    t = np.linspace(0, 0.9 * phase.end.time, 6)
    it, h = motion(t), 0.8
    s, c, rate = np.sin(it["theta"]), np.cos(it["theta"]), it["theta_rate"]
    vertical = 0.5 * (h * s * rate) ** 2 + h * c
    along = it["slip"] - (1 + h * c) * rate
    assert vertical == pytest.approx(vertical[0], abs=1e-13)  # (T6.2)
    assert along == pytest.approx(along[0], abs=1e-13)
    fallen = h * math.sin(1.4) * 0.5 * t + t**2 / 2
    assert h * c == pytest.approx(h * math.cos(1.4) - fallen, abs=1e-13)  # (T6.3)
    assert (np.asarray(it["normal"]) == 0).all()
    figure_7 = lw.case("figure-7").simulate()
    assert figure_7.end_time - figure_7.transitions[0].time == pytest.approx(
        (math.sqrt(89) - 3) / 5, rel=1e-13
    )


def test_impacts():
    for law in ("energetic", "poisson", "newton"):
        for _ in range(20):
            it = Body()
            e = RANDOM.uniform(0, 1)
            slip, gap = RANDOM.normal(), -RANDOM.uniform(0.1, 2)
            sigma = math.copysign(1, slip)
            k1 = it.C - it.mu_k * sigma * it.B  # (T7.3)
            p, *_ = it.slide(sigma)
            assert k1 == pytest.approx(p / (it.m * it.I))
            first = (
                abs(slip) / (it.mu_k * it.A - sigma * it.B)
                if it.mu_k * it.A > sigma * it.B
                else math.inf
            )
            sticks = abs(it.B) <= it.mu_s * it.A
            k2 = (it.A * it.C - it.B**2) / it.A if sticks else it.C - it.mu_k * abs(it.B)  # (T7.4)
            assert k2 > 0
            late = -it.B / it.A if sticks else -it.mu_k * math.copysign(1, it.B)
            rate = gap + k1 * first if first < math.inf else math.inf
            if k1 <= 0 and first == math.inf:
                continue
            if rate >= -e * gap:
                total = (1 + e) * -gap / k1
                tangential = -it.mu_k * sigma * total
            else:
                if rate <= 0:
                    most, work = first - rate / k2, -(gap + rate) * first / 2 + rate**2 / (2 * k2)
                    total = {
                        "energetic": most + e * math.sqrt(2 * work / k2),
                        "poisson": (1 + e) * most,
                        "newton": most - e * gap / k2,
                    }[law]
                else:
                    end = math.sqrt(rate**2 + k2 / k1 * (e**2 * gap**2 - rate**2))  # (T7.6)
                    total = {
                        "energetic": first + (end - rate) / k2,
                        "poisson": (1 + e) * -gap / k1,
                        "newton": first + (-e * gap - rate) / k2,
                    }[law]
                tangential = -it.mu_k * sigma * first + late * (total - first)
            turn = it.rate + (it.h * it.s * total + (1 + it.h * it.c) * tangential) / it.I  # (T7.1)
            after = (
                turn,
                slip + it.A * tangential + it.B * total,
                gap + it.B * tangential + it.C * total,
            )
            assert stepped(it, slip, gap, e, law) == pytest.approx(after[1:], rel=2e-3, abs=2e-3)


def stepped(it: Body, slip: float, gap: float, e: float, law: str) -> tuple[float, float]:
    """An impact in small steps of the normal impulse, without a table of cases."""
    step = 2e-5 * (1 - gap) / it.C
    u, v, done, back, p, most = slip, gap, 0.0, 0.0, 0.0, None
    while True:
        if (
            abs(u) < 2 * step * (it.A + abs(it.B) / min(it.mu_k, 1) + 1)
            and abs(it.B) <= it.mu_s * it.A
        ):
            u, friction = 0.0, -it.B / it.A
        else:
            friction = -it.mu_k * math.copysign(1, u)
        u += (it.A * friction + it.B) * step
        grow = (it.B * friction + it.C) * step
        if v < 0:
            done -= (v + grow / 2) * step
        else:
            most = p if most is None else most
            back += (v + grow / 2) * step
        v, p = v + grow, p + step
        if most is not None or v >= 0:
            reached = {
                "energetic": back >= e * e * done,
                "poisson": p >= (1 + e) * (most or p),
                "newton": v >= -e * gap,
            }[law]
            if reached:
                return u, v


def test_rolling_resistance():
    for it in bodies():
        chi, slope = RANDOM.uniform(0, 1), RANDOM.uniform(-1, 1)
        down, along = math.cos(slope), math.sin(slope)
        m, h, a, d = it.m, it.h, it.h * it.s, 1 + it.h * it.c
        w, j = down - h * it.c * it.u, it.I + m * d * d
        sigma, turning = math.copysign(1, it.slip), math.copysign(1, it.rate)
        # (T10.3): a slide.
        q = a - sigma * it.mu_k * d - turning * chi
        p = it.I + m * a * q
        normal = m * it.I * w / p
        turn, _, gap = it.newton(-sigma * it.mu_k * normal, normal, -turning * chi * normal, slope)
        assert (turn, gap) == pytest.approx((m * q * w / p, 0), rel=1e-7, abs=1e-9 * abs(normal))
        # (T10.4) and (T10.5): rolling.
        whole = it.D - turning * chi * m * a
        assert whole == pytest.approx(j + m * a * (a - turning * chi))
        turn = m * ((a - turning * chi) * w + d * (a * it.u + along)) / whole
        normal = m / whole * (j * w - m * a * d * (a * it.u + along))
        friction = m * (along - d * turn + a * it.u)
        found = it.newton(friction, normal, -turning * chi * normal, slope)
        scale = 1e-9 * (abs(turn) + abs(normal) + abs(friction) + 1)
        assert found == pytest.approx((turn, 0, 0), abs=scale)
        # (T10.6) and (T10.7): skidding and rest.
        it.u = 0.0
        skid = it.newton(
            -sigma * it.mu_k * m * down, m * down, (sigma * it.mu_k * d - a) * m * down, slope
        )
        assert skid == pytest.approx((0, -sigma * it.mu_k * down - along, 0), abs=1e-9)
        rest = it.newton(m * along, m * down, -(a * down + d * along) * m, slope)
        assert rest == pytest.approx((0, 0, 0), abs=1e-9)
        # (T10.12): the split of the closed form.
        total = it.I + m * (1 + h * h)
        slope_of_whole = -2 * it.l * it.s - turning * chi * it.l * it.c
        split = (2 * whole - turning * chi * slope_of_whole - 2 * total) / (4 + chi * chi)
        assert it.l * it.c == pytest.approx(split)
        # (T10.17): a slide with P ≤ 0.
        worst = min(
            it.I + m * a * (a - s * it.mu_k * d - z * chi) for s in (-1, 1) for z in (-1, 1)
        )
        assert (worst <= 0) == (it.mu_k * d + chi >= abs(a) + it.I / (m * abs(a)))


def test_massless_rolling_with_resistance():
    for theta, rate in RANDOM.uniform(-0.9, 0.9, (50, 2)):
        h, chi, turning = RANDOM.uniform(0.2, 1), RANDOM.uniform(0, 0.5), math.copysign(1, rate)
        s, c, u = math.sin(theta), math.cos(theta), rate**2
        a, d = h * s, 1 + h * c
        normal = d * (1 + h * c - h * (h + c) * u) / (d * d + a * (a - turning * chi))  # (T10.23)
        friction = -(a - turning * chi) / d * normal
        # The accelerations of the particle, at (x − h sin θ, 1 + h cos θ) with x″ = −θ″.
        turn = (h * s * u - friction) / d
        assert -h * (s * turn + c * u) == pytest.approx(normal - 1)


def test_ends():
    # (T8.1): the loss of a slip by quadrature of its slip velocity.
    a, omega, normal, mu, factor, small = RANDOM.uniform(0.5, 2, 6)
    begin = math.sqrt(2 * a * small / omega)
    t = np.linspace(-begin, 2 * begin, 200_001)
    excess = 2 * a * small - omega * t**2
    slip = factor * np.concatenate([[0], np.cumsum((excess[1:] + excess[:-1]) / 2 * np.diff(t))])
    assert slip[-1] == pytest.approx(0, abs=1e-8)
    lost = mu * normal * np.sum((slip[1:] + slip[:-1]) / 2 * np.diff(t))
    assert lost == pytest.approx(9 * mu * normal * a**2 * factor / omega * small**2, rel=1e-8)
    # (T8.2): the least energy on the curve of lift-off.
    for it in bodies(20):
        c = np.linspace(1e-3, 1, 100_001)
        energy = 0.5 * (it.I + it.m * it.h**2 * (1 - c**2)) / (it.h * c) + it.l * c
        assert energy.min() == pytest.approx(it.I / (2 * it.h) + it.l, rel=1e-12)


def test_errata():
    for theta, rate in RANDOM.uniform(-1, 1, (20, 2)):
        z, slope = math.sin(theta / 2), math.cos(theta / 2) * rate / 2
        t = RANDOM.uniform(0, 3)
        exponentials = 0.5 * (z + 2 * slope) * math.exp(t / 2) + 0.5 * (z - 2 * slope) * math.exp(
            -t / 2
        )
        assert exponentials == pytest.approx(
            z * math.cosh(t / 2) + 2 * slope * math.sinh(t / 2)
        )  # (T9.1)
        s, c = math.sin(theta), math.cos(theta)
        turn = (1 - c * rate**2) / s
        assert 0.5 * c * rate**3 + s * rate * turn - rate == pytest.approx(
            -0.5 * c * rate**3
        )  # (T9.2)
