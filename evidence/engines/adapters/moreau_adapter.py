"""Moreau's time stepping in a few lines: contact by impulses, after a half step of the positions.

engine: Moreau time stepping (ours)
contact: rigid
settings: default
rolling: separate limits.
limits: friction=pair force=none rolling=1 rolling_small=1 rolling_slow=1
docs: python/docs/score.md

The scheme of python/docs/score.md, with sweeps of projected Gauss-Seidel until nothing changes.
There is one setting, default.
Can express: one coefficient of friction, Newton's restitution at any speed. An impact is that of
Moreau's rule, one impulse with friction by the slip velocity at its end, not that of the theory of
impacts with friction.
"""

import math

from adapter import main, stepped

MOST_SWEEPS = 1000
ENOUGH = 1e-15


def simulate(case, step, _):
    """Yield rows."""
    m, h, inertia, mu = case.mass, case.h, case.inertia, case.friction_of_pair()
    x, y = case.mass_centre()
    vx, vy = case.mass_centre_rates()
    theta, rate, radius, chi = (case.theta, case.theta_rate, case.radius, case.rolling_resistance)

    def advance():
        nonlocal x, y, theta, vx, vy, rate
        x, y, theta = (x + 0.5 * step * vx, y + 0.5 * step * vy, theta + 0.5 * step * rate)
        c, s = math.cos(theta), math.sin(theta)
        rebound = case.restitution * (vy + h * s * rate)
        vx, vy = vx + step * case.gravity[0], vy + step * case.gravity[1]
        if y - h * c <= radius:
            arm = radius + h * c
            a, b, d = (
                1.0 / m + arm * arm / inertia,
                arm * h * s / inertia,
                1.0 / m + (h * s) ** 2 / inertia,
            )
            slip, closing = vx + arm * rate, vy + h * s * rate
            along = up = couple = 0.0
            for _ in range(MOST_SWEEPS):
                before = along, up, couple
                up = max(0.0, -(closing + rebound + b * along + h * s * couple / inertia) / d)
                rub = -(slip + b * up + arm * couple / inertia) / a
                along = min(mu * up, max(-mu * up, rub))
                brake = -(inertia * rate + arm * along + h * s * up)
                couple = min(chi * up, max(-chi * up, brake))
                now = along, up, couple
                if sum(abs(a - b) for a, b in zip(now, before, strict=True)) < ENOUGH:
                    break
            vx, vy = vx + along / m, vy + up / m
            rate += (arm * along + h * s * up + couple) / inertia
        x, y, theta = (x + 0.5 * step * vx, y + 0.5 * step * vy, theta + 0.5 * step * rate)

    yield from stepped(case, step, advance, lambda time: case.row(time, x, y, theta, vx, vy, rate))


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
