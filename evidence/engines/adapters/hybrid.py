"""The hoop as a hybrid system, for integrators of differential equations with events.

The state is (x, y, theta, slip, gap rate, theta rate). With J and P the forces along the plane and
upwards, at the point of contact, and gravity (gx, gy), slip' = A J + B P + gx - h s theta'^2 and
gap'' = B J + C P + gy + h c theta'^2.
"""

import math

ROLL, FLIGHT = "roll", "flight"
SLIDES = {1: "slide +", -1: "slide -"}
SIGN = {name: sign for sign, name in SLIDES.items()}
MODES = (ROLL, *SIGN, FLIGHT)


class Hoop:
    """Equations of motion, what ends them, and what follows; `lib` has cos and sin."""

    def __init__(self, case):
        self.case = case

    def coefficients(self, theta, lib=math):
        """A, B and C."""
        m, h, inertia = self.case.mass, self.case.h, self.case.inertia
        c, s = 1.0 + h * lib.cos(theta), h * lib.sin(theta)
        return 1.0 / m + c * c / inertia, c * s / inertia, 1.0 / m + s * s / inertia

    def free(self, theta, rate, lib=math):
        """Accelerations of the contact point without forces, slip' and gap''.

        The other way round.
        """
        h, (along, away) = self.case.h, self.case.gravity
        return h * lib.sin(theta) * rate * rate - along, -away - h * lib.cos(theta) * rate * rate

    def forces(self, mode, theta, rate, lib=math):
        """J and P."""
        slipping, falling = self.free(theta, rate, lib)
        a, b, c = self.coefficients(theta, lib)
        if mode == ROLL:
            d = a * c - b * b
            return (c * slipping - b * falling) / d, (a * falling - b * slipping) / d
        if mode == FLIGHT:
            return 0.0, 0.0
        mu = self.case.mu_k * SIGN[mode]
        normal = falling / (c - mu * b)
        return -mu * normal, normal

    def rates(self, mode, state, lib=math):
        """Right-hand sides."""
        _, _, theta, slip, gap_rate, rate = state
        h = self.case.h
        a, b, _ = self.coefficients(theta, lib)
        along, up = self.forces(mode, theta, rate, lib)
        slipping, falling = self.free(theta, rate, lib)
        slip_rate = a * along + b * up - slipping
        turning = ((1.0 + h * lib.cos(theta)) * along + h * lib.sin(theta) * up) / self.case.inertia
        return (
            slip - rate,
            gap_rate,
            rate,
            0.0 if mode == ROLL else slip_rate,
            -falling if mode == FLIGHT else 0.0,
            turning,
        )

    def ends(self, mode, state, lib=math):
        """Functions of the state that fall through zero where the mode ends."""
        _, y, theta, slip, _, rate = state
        if mode == FLIGHT:
            return [y - 1.0]
        along, up = self.forces(mode, theta, rate, lib)
        if mode == ROLL:
            return [self.case.mu_s * up - along, self.case.mu_s * up + along]
        return [slip * SIGN[mode], self.free(theta, rate, lib)[1]]

    def follows(self, state):
        """The mode in which a hoop in contact goes on, from its accelerations."""
        _, _, theta, slip, _, rate = state
        if slip != 0.0:
            mode = SLIDES[int(math.copysign(1, slip))]
            return mode if self.forces(mode, theta, rate)[1] > 0.0 else FLIGHT
        along, up = self.forces(ROLL, theta, rate)
        if up > 0.0 and abs(along) <= self.case.mu_s * up:
            return ROLL
        mode = SLIDES[-int(math.copysign(1, along))]
        return mode if self.forces(mode, theta, rate)[1] > 0.0 else FLIGHT

    def impact(self, state):
        """The state after a landing, the normal impulse being the time in it.

        Restitution is Poisson's; in an impact in which slip does not end, all laws agree.
        """
        x, _, theta, slip, gap_rate, rate = state
        mu, h = self.case.mu_k, self.case.h
        a, b, c = self.coefficients(theta)
        sign = math.copysign(1.0, slip)
        to_stick = abs(slip) / (mu * a - sign * b) if mu * a > sign * b else math.inf
        opening = c - mu * sign * b
        can_stick = abs(b) <= self.case.mu_s * a
        later = -b / a if can_stick else -math.copysign(mu, b)
        if opening > 0.0 and to_stick >= -gap_rate / opening:
            compression = -gap_rate / opening
        else:
            compression = to_stick - (gap_rate + opening * to_stick) / (c + b * later)
        up = (1.0 + self.case.restitution) * compression
        sliding = min(up, to_stick)
        along = -mu * sign * sliding + later * (up - sliding)
        sticks = can_stick and up > to_stick
        turning = (
            (1.0 + h * math.cos(theta)) * along + h * math.sin(theta) * up
        ) / self.case.inertia
        bounces = self.case.restitution > 0.0
        slip_after = 0.0 if sticks else slip + a * along + b * up
        gap_rate_after = gap_rate + b * along + c * up if bounces else 0.0
        return x, 1.0, theta, slip_after, gap_rate_after, rate + turning

    def follow(self, advance, step):
        """Yield rows.

        `advance(mode, time, state, until)` returns the end, its state, which event, a dense output.
        """
        case = self.case
        state, time = ((0.0, 1.0, case.theta, case.slip, case.gap_rate, case.theta_rate), 0.0)
        # What an impact at the start changes is not yet in the first row.
        yield 0.0, 0.0, 1.0, case.theta, case.x_rate, case.gap_rate, case.theta_rate
        mode = FLIGHT if case.gap_rate > 0.0 else self.follows(state)
        if (
            mode == FLIGHT
            and case.gap_rate == 0.0
            and self.free(case.theta, case.theta_rate)[1] > 0.0
        ):
            # The plane holds the rim, and no slide is consistent: an impact without a collision.
            state = self.impact(state)
            mode = FLIGHT if state[4] > 0.0 else self.follows(state)
        instants = (i * step for i in range(1, round(case.until / step) + 1))
        at = next(instants)
        while True:
            end, state, event, dense = advance(mode, time, state, case.until)
            while at is not None and at <= end:
                x, y, theta, slip, gap_rate, rate = dense(at)
                yield at, x, y, theta, slip - rate, gap_rate, rate
                at = next(instants, None)
            if event is None or at is None:
                return
            time = end
            x, y, theta, _, _, rate = state
            if mode == FLIGHT:
                state = self.impact(state)
                mode = FLIGHT if state[4] > 0.0 else self.follows(state)
            elif mode == ROLL:
                # Slip begins against the friction that would be needed.
                mode = SLIDES[-1 if event == 0 else 1]
            elif event == 1:
                mode = FLIGHT
            else:
                state = (x, y, theta, 0.0, 0.0, rate)
                mode = self.follows(state)
