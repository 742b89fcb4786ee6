"""The glide of a massless hoop, which hangs on a particle in free fall."""

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Tie
from .roots import all_roots, number
from .series import value


def glide(hoop, state, known, until):
    """A glide to its first event, as `smooth`; the direction is that of the glide itself."""
    theta, rate, slip, x = state
    l = hoop.l
    s, c = gmpy2.sin_cos(theta)
    if s == 0:
        raise Tie("at the top")
    side = 1 if s > 0 else -1
    vx = slip - rate * (1 + l * c)  # of the particle
    vy = -l * s * rate
    g, pulled = hoop.down, hoop.along
    height = [l * c, vy, -g / 2]  # l cos theta in the time
    times = []
    for level in (-l, l):
        half = vy * vy + 2 * g * (l * c - level)
        if half > 0:
            times += [
                v / g
                for v in (vy - gmpy2.sqrt(half), vy + gmpy2.sqrt(half))
                if v > 0 and (level < 0 or v == vy - gmpy2.sqrt(half))
            ]
        if level > 0 and abs(half) < 1e-38:
            raise Tie("just reaches the top")
    end = min(times)
    at_top = vy > 0 and vy * vy + 2 * g * (l * c - l) > 0

    def multiply(p, q):
        out = [mpfr(0)] * (len(p) + len(q) - 1)
        for i, a in enumerate(p):
            for j, b in enumerate(q):
                out[i + j] += a * b
        return out

    # With y = l cos theta, (l sin theta)^2 = l^2 - y^2 and eta' l sin theta = v l sin theta + (g
    # t - vy)(1 + y), v = vx - t sin slope: where it vanishes, v^2 (l^2 - y^2) = (g t - vy)^2 (1 +
    # y)^2. On the rim both sides have the factor 1 + y.
    above, lever = [-v for v in height], [1 + height[0], height[1], height[2]]
    above[0] = l - l * c
    rim = l == 1
    arm = above if rim else multiply(above, [l + height[0], height[1], height[2]])
    drive = multiply([-vy, g], [-vy, g])
    push = multiply([vx, -pulled], [vx, -pulled])
    sextic = [-v for v in multiply(drive, lever if rim else multiply(lever, lever))]
    term = multiply(push, arm)
    sextic += [mpfr(0)] * (len(term) - len(sextic))
    for k, v in enumerate(term):
        sextic[k] += v
    for _ in range(known):
        # At rest at the start; on a level plane also at the same height again.
        if abs(sextic[0]) > 1e-30 * max(map(abs, sextic)):
            raise AssertionError("not at rest at the start")
        sextic = sextic[1:]
        if pulled == 0:
            for k in range(len(sextic) - 2, -1, -1):
                sextic[k] += 2 * vy * sextic[k + 1]
            sextic = sextic[1:]

    def position(t):
        y = value(height, t)
        sine = side * gmpy2.sqrt(l * l - y * y)  # l sin theta
        turn_rate = (g * t - vy) / sine
        turned = gmpy2.atan2(sine, y)
        return turned, turn_rate, vx - pulled * t + turn_rate * (1 + y), sine

    lap = gmpy2.rint((theta - gmpy2.atan2(s, c)) / (2 * gmpy2.const_pi()))
    turn = 2 * gmpy2.const_pi() * lap
    free = vx == 0 and pulled == 0
    rests = [vy] if free and 0 < vy < end else []  # eta' = theta' (1 + l cos theta)
    for z in () if free else all_roots(sextic):
        if not z.imag.contains(0):
            continue
        t = number(z.real)
        if 0 < t <= 1e-40:
            raise Tie("a rest where the glide begins")
        if 1e-40 < t < end - 1e-38 * (1 + end) and (vx - pulled * t) * side * (g * t - vy) < 0:
            rests.append(t)
    rests.sort()
    if any(b - a < 1e-30 for a, b in zip(rests, rests[1:])):
        raise Tie("touches")
    first = rests[0] if rests else None
    direction = 1 if position((first or end) / 2)[2] > 0 else -1
    mass_centre = x - l * s
    if first is not None and first < until:
        turned, turn_rate, _, sine = position(first)
        return (
            "stick",
            first,
            (
                turn + turned,
                turn_rate,
                mpfr(0),
                mass_centre + vx * first - pulled * first**2 / 2 + sine,
            ),
            direction,
        )
    if end >= until:
        turned, turn_rate, now, sine = position(mpfr(until))
        return (
            None,
            mpfr(until),
            (
                turn + turned,
                turn_rate,
                now,
                mass_centre + vx * until - pulled * until**2 / 2 + sine,
            ),
            direction,
        )
    place = mass_centre + vx * end - pulled * end**2 / 2
    vx -= pulled * end
    infinite = mpfr("inf")
    if at_top:
        return "particle_at_top", end, (turn, -side * infinite, -side * infinite, place), direction
    return (
        "particle_at_plane" if rim else "particle_at_bottom",
        end,
        (turn + side * gmpy2.const_pi(), side * infinite, vx if rim else side * infinite, place),
        direction,
    )
