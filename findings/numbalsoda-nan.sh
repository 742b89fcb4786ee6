#!/usr/bin/env bash
# numbalsoda 0.3.4, `lsoda`: success with NaN for a time at which everything is regular.
#
# y' = 1 + 0 sqrt(1 - t) is 1 to t = 1, and the root of a negative number, NaN, from there on; asked for at 0, 1/2 and 2.
# Seen: the flag of success is True, and the value at 1/2 is NaN, also where nothing later is asked for: the method has stepped beyond 1.
# `dop853` of the same package reports the failure, and has the value at 1/2.
# Its wheels are for Python 3.10 and before: PYTHON=python3.10 findings/numbalsoda-nan.sh. 121 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages numbalsoda==0.3.4 numba==0.61.2 numpy==2.2.6

python - <<'PYTHON'
import math

import numba
import numpy as np
from numbalsoda import dop853, lsoda, lsoda_sig


@numba.cfunc(lsoda_sig)
def rates(t, y, dy, parameters):
    dy[0] = 1.0 + 0.0 * np.sqrt(1.0 - t)


def solve(method, times):
    values, success = method(rates.address, np.array([0.0]), np.array(times), rtol=1e-8, atol=1e-10)
    return values[1, 0], success


alone, lost = solve(lsoda, [0.0, 0.5]), solve(lsoda, [0.0, 0.5, 2.0])
kept = solve(dop853, [0.0, 0.5, 2.0])
print("lsoda to 1/2", alone, "to 2", lost, "dop853 to 2", kept)
assert alone[1] and math.isnan(alone[0])
assert lost[1] and math.isnan(lost[0])
assert not kept[1] and abs(kept[0] - 0.5) < 1e-7
PYTHON
