"""Power series in the time: products, values, steps, and those of rolling and sliding."""

import math
from operator import mul

import gmpy2
from gmpy2 import mpfr

from .arithmetic import Work


def conv(a, b, k):
    """Coefficient k of the product of two series."""
    return sum(map(mul, a[: k + 1], b[k::-1]))


def value(p, t):
    v = mpfr(0)
    for coefficient in reversed(p):
        v = v * t + coefficient
    return v


def slope(p):
    return [k * coefficient for k, coefficient in enumerate(p)][1:]


def circle(th):
    """Series of sine and cosine."""
    s, c = ([v] for v in gmpy2.sin_cos(th[0]))
    rate = slope(th)
    for k in range(len(th) - 1):
        s.append(conv(rate, c, k) / (k + 1))
        c.append(-conv(rate, s, k) / (k + 1))
    return s, c


def series(hoop, state, sigma):
    """Taylor series of theta, theta', eta', N and F from a state.

    They are those of rolling for sigma None, else of sliding.

    Mass centre at (x - h sin theta, 1 + h cos theta); contact point from it at (h sin theta, -1 - h
    cos theta). m xG'' = F - m sin slope, m yG'' = N - m cos slope, I theta'' = h sin theta N + (1 +
    h cos theta) F.
    """
    m, h, i = hoop.m, hoop.h, hoop.i
    th, w, eta = [state[0]], [state[1]], [state[2]]
    sn, cs = gmpy2.sin_cos(state[0])
    s, c, a, u, n, f = [sn], [cs], [], [], [], []
    lever = [1 + h * cs]
    friction = None if sigma is None else -hoop.mu_k * sigma
    if sigma is not None:
        q = [h * sn + friction * lever[0]]
        weight = i + m * h * sn * q[0]
    else:
        weight = i + m * (h * sn) ** 2 + m * lever[0] ** 2
    for k in range(Work.order):
        u.append(conv(w, w, k))
        cu, su = conv(c, u, k), conv(s, u, k)
        sa, ca = (sum(map(mul, a, s[k:0:-1])), sum(map(mul, a, c[k:0:-1]))) if k else (0, 0)
        n0 = -m * h * (sa + cu) + (m * hoop.down if k == 0 else 0)
        f0 = -m * h * (ca - su) + (m * hoop.along if k == 0 else 0)
        if sigma is None:
            low = h * sum(map(mul, s[1:], n[::-1])) + sum(map(mul, lever[1:], f[::-1])) if k else 0
            ak = (low + h * s[0] * n0 + lever[0] * f0) / weight
            nk = n0 - m * h * s[0] * ak
            f.append(f0 - m * lever[0] * ak)
            eta.append(mpfr(0))
        else:
            low = sum(map(mul, q[1:], n[::-1])) if k else 0
            ak = (low + q[0] * n0) / weight
            nk = n0 - m * h * s[0] * ak
            f.append(friction * nk)
            pulled = hoop.along if k == 0 else 0
            eta.append((ak + h * (ca + c[0] * ak - su) + f[k] / m - pulled) / (k + 1))
        a.append(ak)
        n.append(nk)
        th.append(w[k] / (k + 1))
        s.append(conv(w, c, k) / (k + 1))
        c.append(-conv(w, s, k) / (k + 1))
        w.append(ak / (k + 1))
        lever.append(h * c[k + 1])
        if sigma is not None:
            q.append(h * s[k + 1] + friction * lever[k + 1])
    return th, w, eta, n, f


def reach(parts):
    """Length of a step by the last two coefficients of each part."""
    length = 1e3
    for part in parts:
        allowed = math.log2(Work.error * max(1.0, abs(float(part[0]))))
        for k in (len(part) - 1, len(part) - 2):
            if part[k]:
                length = min(length, 2.0 ** ((allowed - float(gmpy2.log2(abs(part[k])))) / k))
    return 0.9 * length
