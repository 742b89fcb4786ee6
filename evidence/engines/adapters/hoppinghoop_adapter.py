"""The hopping-hoop simulator of hellpig: this hoop's own equations.

SciPy integrates them with events, phase by phase.

engine: hopping-hoop-simulator
contact: events
settings: default careful
steps: its own
requires: numpy==2.4.6 scipy==1.17.1
  git:hellpig/hopping-hoop-simulator@588c77d61595f2dfc3b2e7abd72831be979f8534
docs: https://github.com/hellpig/hopping-hoop-simulator

Its functions `rollWithoutSliding`, `rollWithSliding`, `hop` and `land` run as they are; the order
in which they follow one another is that of its main loop, which starts out of rolling alone. It
plots 101 points a phase, a number that it says may be changed, and adds up v_x for x: here the
points are as dense as the rows.
default: Radau with tolerances of 1e-9, as it comes; where mu_s = mu_k, mu_s is 1e-5 larger, as its
page advises.
careful: DOP853 with 1e-12, mu_s larger by 1e-9.
Can express: mu_s > mu_k, a particle on the rim, a landing without rebound. It has no slope and no
start in the air.
"""

import contextlib
import io
import math
import os
import re
import sys
from pathlib import Path
from unittest import mock

import numpy as np
from adapter import main, refuse
from scipy.integrate import cumulative_trapezoid

MORE = {"default": 1e-5, "careful": 1e-9}


def functions(case, step, setting):
    """Its functions, with the hoop and the tolerances of a case."""
    if case.slope != 0.0 or case.gap_rate != 0.0 or abs(case.mass * case.h - 1.0) > 1e-12:
        refuse("the program has a level plane, a start in contact and a particle on the rim")
    case.without_restitution()
    source = Path(os.environ["LITTLEWOOD_SOURCES"], "hopping-hoop-simulator", "hop.py").read_text(
        encoding="utf-8"
    )
    source = source.split("# driver code")[0].replace(
        "num=101", f"num={min(200_000, round(10.0 / step) + 1)}"
    )
    mass = case.mass - 1.0
    # It refuses I > m r^2, and so one that is larger by rounding.
    about_centre = min(case.inertia + case.mass * case.h**2 - 1.0, mass * (1.0 - 1e-15))
    values = {"g": 1.0, "r": 1.0, "m": mass, "I": about_centre, "M": 1.0}
    values |= {"mu_k": case.mu_k, "mu_s": max(case.mu_s, case.mu_k + MORE[setting])}
    values |= {"theta0": case.theta + math.pi / 2, "omega0": case.theta_rate}
    if setting == "careful":
        values |= {"abs_tol": 1e-12, "rel_tol": 1e-12}
        source = source.replace("integrate_method = 'Radau'", "integrate_method = 'DOP853'")
    for name, value in values.items():
        source = re.sub(rf"^{name} = .*$", f"{name} = {value!r}", source, flags=re.MULTILINE)
    plots = mock.MagicMock()
    plots.subplots.return_value = mock.MagicMock(), mock.MagicMock()
    sys.modules.update(
        {"matplotlib": plots, "matplotlib.pyplot": plots, "matplotlib.animation": plots}
    )
    plots.pyplot = plots
    space = {"big": [[] for _ in range(6)], "hopCount": 0}
    exec(compile(source, "hop.py", "exec"), space)
    space |= {"makePlots": lambda: None, "animate": lambda: None}
    return space


def follow(space, case):
    """Phases in the order of its main loop, up to the end of the case."""
    time, state = 0.0, (case.theta + math.pi / 2, case.theta_rate, case.x_rate)
    rolls = case.slip == 0.0 and space["maxFriction_minus_requiredFriction"](0, state[:2]) > 0.0
    starts_at_rest = case.slip == 0.0
    while time < case.until:
        if rolls:
            time, state = space["rollWithoutSliding"](time, state[:2])
        space["rollingWithoutSliding"] = rolls or starts_at_rest
        time, state, rolls = space["rollWithSliding"](time, state)
        starts_at_rest = False
        hops = not rolls
        while hops and time < case.until:
            time, state = space["hop"](time, state)
            space["hopCount"] += 1
            state, rolls, hops = space["land"](state)


def simulate(case, step, setting):
    """Yield rows."""
    space = functions(case, step, setting)
    yield 0.0, 0.0, 1.0, case.theta
    # It ends by exit() where nothing more happens, and where it does not know how to go on.
    with contextlib.redirect_stdout(io.StringIO()) as said, contextlib.suppress(SystemExit):
        follow(space, case)
    time, theta, _, _, along, height = map(np.asarray, space["big"])
    end = time[-1] if time.size else 0.0
    if end < case.until:
        refuse(f"the program stops at {end:.4f}: {' '.join(said.getvalue().split()[-8:])}")
    x = cumulative_trapezoid(along, x=time, initial=0)
    instants = np.arange(1, round(case.until / step) + 1) * step
    columns = (
        np.interp(instants, time, column) for column in (x, 1.0 + height, theta - math.pi / 2)
    )
    yield from zip(instants, *columns, strict=True)


if __name__ == "__main__":
    main(simulate, has_units=False)
