"""What every adapter shares: the case it reads, the record it writes, its cost.

An adapter is run as ``python NAME_adapter.py CASE.json STEP SETTING RECORD.csv`` in an environment
that has its engine. It writes the columns time, x, y, theta, and the engine's own velocities
x_rate, y_rate, theta_rate if it yields them, and prints one line of JSON: ``cpu_s``, the processor
time of the loop over the steps (all threads), and ``steps``. Where the case names a ``gradient``,
the columns are time and the derivatives of x and theta with respect to that quantity. In the files
lengths are in R, times in sqrt(R/g), masses in m2; an adapter has the units of the engine, in which
R is ``case.radius`` and g ``case.g`` (1 and 1 but in the cases about units), and yields rows in
them. x and y are those of the geometric centre of the hoop along the plane and from it, theta is
the angle of the particle from the normal of the plane, counterclockwise. On a ramp the plane stays
where it is, and gravity is inclined.
"""

import dataclasses
import json
import math
import sys
import time
from dataclasses import dataclass
from pathlib import Path

SHORTEST = 1e-4
"""Time between two rows, at least, sqrt(R/g): finer steps are taken, not all of them written."""

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
    rolling_resistance: float
    restitution: float
    theta: float
    theta_rate: float
    slip: float
    gap_rate: float
    until: float
    radius: float
    g: float
    unit_of_mass: float
    gradient: str = ""
    # Of a probe: the coefficient of the plane where it is another than that of the hoop, damping
    # and sleep left as the package has them, and the force as a last column of the rows.
    plane: float = -1.0
    is_untouched: bool = False
    has_force: bool = False

    @classmethod
    def read(cls, path, has_units):
        """The case of a file, in the units of the engine."""
        given = cls(**json.loads(Path(path).read_text(encoding="utf-8")))
        if not has_units:
            return dataclasses.replace(given, radius=1.0, g=1.0, unit_of_mass=1.0)
        length, mass = given.radius, given.unit_of_mass
        rate = math.sqrt(given.g / length)
        return dataclasses.replace(
            given,
            mass=given.mass * mass,
            h=given.h * length,
            inertia=given.inertia * mass * length**2,
            rolling_resistance=given.rolling_resistance * length,
            theta_rate=given.theta_rate * rate,
            slip=given.slip * length * rate,
            gap_rate=given.gap_rate * length * rate,
            until=given.until / rate,
        )

    @property
    def second(self):
        """The unit of time, sqrt(R/g)."""
        return math.sqrt(self.radius / self.g)

    def without_dimension(self, row):
        """A row of the file from one in the units of the engine."""
        length, second = self.radius, self.second
        time, x, *others = row
        if len(others) == 1 or self.gradient:
            return (time / second, x / length, *others)
        y, theta, *rates = others
        if rates:
            along, up, turning, *force = rates
            weight = self.unit_of_mass * self.g
            force = [one / weight for one in force]
            rates = [
                along * second / length,
                up * second / length,
                turning * second,
                *force,
            ]
        return (time / second, x / length, y / length, theta, *rates)

    def forced(self, row, force):
        """A row, with the normal force that `force()` returns if it is asked for."""
        return (*row, force()) if self.has_force else row

    def friction_of_plane(self, neutral):
        """The coefficient of the plane: `neutral`, with which that of the hoop is the contact's."""
        return neutral if self.plane < 0.0 else self.plane

    def friction_of_pair(self):
        """The coefficient, for an engine that has one for each pair of bodies."""
        if self.plane >= 0.0:
            refuse("the coefficient is that of the pair")
        return self.one_coefficient()

    @property
    def x_rate(self):
        """Velocity of the geometric centre along the plane: slip = x' + R theta'."""
        return self.slip - self.radius * self.theta_rate

    @property
    def gravity(self):
        """Gravity along the plane, which rises to the right by the slope, and away from it."""
        return -self.g * math.sin(self.slope), -self.g * math.cos(self.slope)

    def mass_centre(self):
        """Its place at the start, the hoop touching the plane at x = 0."""
        x, y = -self.h * math.sin(self.theta), self.h * math.cos(self.theta)
        return x, self.radius + y

    def mass_centre_rates(self):
        """Its velocity at the start."""
        c, s = math.cos(self.theta), math.sin(self.theta)
        return (
            self.x_rate - self.h * c * self.theta_rate,
            self.gap_rate - self.h * s * self.theta_rate,
        )

    def centre_rates(self, theta, vx, vy, turning):
        """Velocity of the geometric centre, and the rate of theta, from that of the mass centre."""
        c, s = self.h * math.cos(theta), self.h * math.sin(theta)
        return vx + c * turning, vy + s * turning, turning

    def row(self, time, x, y, theta, vx, vy, turning):
        """A row of the record from place and velocity of the mass centre."""
        place = x + self.h * math.sin(theta), y - self.h * math.cos(theta), theta
        return (time, *place, *self.centre_rates(theta, vx, vy, turning))

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
    each = max(1, round(SHORTEST * case.second / step))
    return round(case.until / step) // each, each


def stepped(case, step, advance, row):
    """Yield the rows of an engine that is asked for one step after the other."""
    count, each = rows_of(case, step)
    yield row(0.0)
    for i in range(1, count + 1):
        for _ in range(each):
            advance()
        yield row(i * each * step)


COLUMNS = ("time", "x", "y", "theta", "x_rate", "y_rate", "theta_rate", "force")
"""Of a row, from the first on; rates may be missing. A row of derivatives has no y."""


def main(simulate, gradient=None, has_rolling_friction=False, has_units=True):
    """Run one case.

    `simulate(case, step, setting)` yields rows, and prepares the engine before the first.

    `gradient`, which takes the same, yields rows of derivatives with respect to `case.gradient`.

    `has_rolling_friction` says that the adapter knows `case.rolling_resistance`. Without units, as
    equations need none, R and g are 1 in every case.
    """
    file, step, setting, out = sys.argv[1:]
    case = Case.read(file, has_units)
    step = float(step) * case.second
    if case.gradient and gradient is None:
        refuse("the adapter has no derivatives")
    if case.rolling_resistance != 0.0 and not has_rolling_friction:
        refuse(f"the adapter sets up no rolling friction, the case chi = {case.rolling_resistance}")
    rows = gradient(case, step, setting) if case.gradient else simulate(case, step, setting)
    kept = [next(rows)]
    start = time.process_time()
    kept += rows
    cost = time.process_time() - start
    names = ("time", "x", "theta") if case.gradient else COLUMNS[: len(kept[0])]
    with Path(out).open("w", encoding="utf-8") as table:
        table.write(f"{','.join(names)}\n")
        for row in map(case.without_dimension, kept):
            table.write(",".join(f"{value:.17g}" for value in row) + "\n")
    print(json.dumps({"cpu_s": cost, "steps": round(case.until / step)}))
