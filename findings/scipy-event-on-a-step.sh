#!/usr/bin/env bash
# SciPy 1.17.1, `solve_ivp`: an event that falls on the end of a step is counted twice.
#
# y' = 1 from 0, event y - 1 with steps of 1/4: y is exact, and one crossing exists, at the time 1.
# Seen for RK23, Radau, BDF and LSODA: `t_events` is [1, 1], once for each of the two steps that meet there.
# RK45 and DOP853, whose value is below 1 by rounding, report it once.
# With `terminal = 2`, which is to stop at the second crossing, these four methods stop at the first. 63 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages scipy==1.17.1 numpy==2.4.6

python - <<'PYTHON'
from scipy.integrate import solve_ivp


def solve(method, terminal):
    def event(t, y):
        return y[0] - 1.0

    event.terminal = terminal
    return solve_ivp(
        lambda t, y: [1.0], (0.0, 2.0), [0.0], method, events=event, first_step=0.25, max_step=0.25
    )


counts = {"RK23": 2, "Radau": 2, "BDF": 2, "LSODA": 2, "RK45": 1, "DOP853": 1}
for method, count in counts.items():
    times, end = solve(method, False).t_events[0], solve(method, 2).t[-1]
    print(method, times, "stops at", end)
    assert len(times) == count and all(abs(times - 1.0) < 1e-12), times
    assert end == (1.0 if count == 2 else 2.0), end
PYTHON
