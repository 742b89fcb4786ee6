#!/usr/bin/env bash
# CasADi 3.8.2, integrator `erk`: of two events at the same instant one is lost.
#
# Ball 1 is dropped from 1/2, ball 2 thrown down from 1 with 1/2; g = 1, and both reach the floor at the time 1 exactly.
# Each has an indicator in `zero`, and the transition turns the velocity of the ball whose index it is given, as in CasADi's example of a bouncing ball.
# At 3/2 both must be 3/8 and 5/8 high. Seen: the other ball has gone through the floor, and the tolerance decides which one.
#
#   default tolerance:  heights  0.3750 -0.8750, transitions 1 0
#   tolerance 1e-12:    heights -0.6250  0.6250, transitions 0 1
#
# The output grid (1, 10 or 100 intervals) makes no difference. 32 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages casadi==3.8.2 numpy==2.4.6

python - <<'PYTHON'
import casadi as ca
import numpy as np


def heights_and_transitions(intervals, **tolerances):
    x = ca.MX.sym("x", 6)
    dae = {"x": x, "ode": ca.vertcat(x[1], -1, x[3], -1, 0, 0), "zero": ca.vertcat(x[0], x[2])}
    index, time, now = ca.MX.sym("index"), ca.MX.sym("t"), ca.MX.sym("x", 6)
    first = ca.vertcat(now[0], -now[1], now[2], now[3], now[4] + 1, now[5])
    second = ca.vertcat(now[0], now[1], now[2], -now[3], now[4], now[5] + 1)
    after = {"index": index, "t": time, "x": now, "post_x": ca.if_else(index == 0, first, second)}
    transition = ca.Function("transition", after, ca.event_in(), ca.event_out())
    grid = np.linspace(0.0, 1.5, intervals + 1)[1:]
    run = ca.integrator("run", "erk", dae, 0.0, grid, {"transition": transition, **tolerances})
    return np.array(run(x0=[0.5, 0, 1, -0.5, 0, 0])["xf"])[[0, 2, 4, 5], -1]


for intervals in (1, 10, 100):
    usual = heights_and_transitions(intervals)
    tight = heights_and_transitions(intervals, abstol=1e-12, reltol=1e-12)
    print(intervals, usual, tight)
    assert np.allclose(usual, [0.375, -0.875, 1, 0], atol=1e-6), usual
    assert np.allclose(tight, [-0.625, 0.625, 0, 1], atol=1e-6), tight
PYTHON
