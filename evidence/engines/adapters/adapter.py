"""What every adapter shares: the case it reads, the record it writes, its cost.

An adapter is run as ``python NAME_adapter.py CASE.json STEP SETTING RECORD.csv`` in an environment
that has its engine. It writes the columns time, x, y, theta (and x_rate, y_rate, theta_rate, if it
yields them), and prints one line of JSON: ``cpu_s``, the processor time of the loop over the steps
(all threads), and ``steps``. Where the case names a ``gradient``, the columns are time and the
derivatives of x and theta with respect to that quantity. Lengths are in R, times in sqrt(R/g),
masses in m2. x and y are those of the geometric centre of the hoop along the plane and from it,
theta is the angle of the particle from the normal of the plane, counterclockwise. On a ramp the
plane stays where it is, and gravity is inclined.
"""

import json
import math
import sys
import time
from dataclasses import dataclass
from pathlib import Path

SHORTEST = 1e-4
"""Time between two rows, at least: finer steps are taken, and not all of them written."""

REFUSED = 3
"""Exit code of an adapter whose engine cannot express the case."""


@dataclass(frozen=True)
class Case:
    """A hoop and its start, as the case file has them."""

    mass: float
    h: float
    inertia: float
    slope: float
    mu_s: float
    mu_k: float
    restitution: float
    theta: float
    theta_rate: float
    slip: float
    gap_rate: float
    until: float
    gradient: str = ""

    @property
    def x_rate(self):
        """Velocity of the geometric centre along the plane: slip = x' + theta'."""
        return self.slip - self.theta_rate

    @property
    def gravity(self):
        """Gravity along the plane, which rises to the right by the slope, and away from it."""
        return -math.sin(self.slope), -math.cos(self.slope)

    def mass_centre(self):
        """Its place at the start, the hoop touching the plane at x = 0."""
        return -self.h * math.sin(self.theta), 1.0 + self.h * math.cos(self.theta)

    def mass_centre_rates(self):
        """Its velocity at the start."""
        c, s = math.cos(self.theta), math.sin(self.theta)
        return (
            self.x_rate - self.h * c * self.theta_rate,
            self.gap_rate - self.h * s * self.theta_rate,
        )

    def row(self, time, x, y, theta):
        """A row of the record from the place of the mass centre."""
        return time, x + self.h * math.sin(theta), y - self.h * math.cos(theta), theta

    def one_coefficient(self):
        """The coefficient of friction, for an engine that has one."""
        if self.mu_s != self.mu_k:
            refuse(
                f"the engine has one coefficient of friction, the case mu_s = {self.mu_s}, mu_k = "
                f"{self.mu_k}"
            )
        return self.mu_k

    def without_restitution(self):
        """Refuse a case that bounces, for an engine that has no coefficient of restitution."""
        if self.restitution != 0.0:
            refuse(f"the engine has no coefficient of restitution, the case e = {self.restitution}")


def refuse(reason):
    """End: the engine cannot express the case."""
    print(reason, file=sys.stderr)
    sys.exit(REFUSED)


def rows_of(case, step):
    """How many rows follow that of the start, and how many steps lie between two rows."""
    each = max(1, round(SHORTEST / step))
    return round(case.until / step) // each, each


def stepped(case, step, advance, row):
    """Yield the rows of an engine that is asked for one step after the other."""
    count, each = rows_of(case, step)
    yield row(0.0)
    for i in range(1, count + 1):
        for _ in range(each):
            advance()
        yield row(i * each * step)


COLUMNS = {
    3: "time,x,theta",
    4: "time,x,y,theta",
    7: "time,x,y,theta,x_rate,y_rate,theta_rate",
}
"""Names of the columns of a row, by their number."""


def main(simulate, gradient=None):
    """Run one case.

    `simulate(case, step, setting)` yields rows, and prepares the engine before the first.

    `gradient`, which takes the same, yields rows of derivatives with respect to `case.gradient`.
    """
    file, step, setting, out = sys.argv[1:]
    case, step = Case(**json.loads(Path(file).read_text(encoding="utf-8"))), float(step)
    if case.gradient and gradient is None:
        refuse("the adapter has no derivatives")
    rows = gradient(case, step, setting) if case.gradient else simulate(case, step, setting)
    kept = [next(rows)]
    start = time.process_time()
    kept += rows
    cost = time.process_time() - start
    with Path(out).open("w", encoding="utf-8") as table:
        table.write(f"{COLUMNS[len(kept[0])]}\n")
        table.writelines(",".join(f"{value:.17g}" for value in row) + "\n" for row in kept)
    print(json.dumps({"cpu_s": cost, "steps": round(case.until / step)}))
