"""`python -m evidence.studies.mujoco_runs`: the table of runs of the study of MuJoCo's cone.

It needs the package `mujoco`, and overwrites docs/studies/mujoco-cone/runs.csv; a second.
"""

from __future__ import annotations

import csv
import math
from dataclasses import asdict, dataclass, fields, replace
from typing import Any

from .study import PAGES

TABLE = PAGES / "mujoco-cone" / "runs.csv"

MODEL = """
<mujoco>
  <option timestep="{timestep}" gravity="{along} 0 {down}" cone="elliptic" impratio="{impratio}"
          iterations="200" tolerance="1e-12"/>
  <worldbody>
    <geom type="plane" size="0 0 1" condim="6" friction="{mu} 0 {chi}" solref="{stiffness} 1"/>
    <body pos="0 0 1">
      <joint type="slide" axis="1 0 0"/>
      <joint type="slide" axis="0 0 1"/>
      <joint type="hinge" axis="0 1 0"/>
      <geom type="sphere" size="1" mass="1" condim="6" friction="{mu} 0 {chi}"
            solref="{stiffness} 1"/>
    </body>
  </worldbody>
</mujoco>
"""
"""A ball, R = m = g = 1; its torsional friction does not matter in a plane motion."""


@dataclass(frozen=True, kw_only=True)
class Run:
    """A run: what was given, and speed of the centre and rate of the ball at its end.

    `stiffness` is MuJoCo's time constant of the contact, `solref`.
    """

    part: str
    mu: float
    chi: float
    tangent: float = 0.0
    begin: float = 0.0
    until: float
    impratio: float = 1.0
    timestep: float = 1e-3
    stiffness: float = 2e-3
    speed: float = math.nan
    spin: float = math.nan
    version: str = ""


def starting_slope(mu: float, chi: float) -> float:
    """Return tan α at which what rolls starts downhill."""
    return mu * chi / math.hypot(mu, chi)


def planned() -> list[Run]:
    """Return the runs, not yet run."""
    pairs = ((0.1, 0.1), (0.5, 0.1), (0.5, 0.02), (1.0, 0.3))
    slopes = [
        Run(part="slope", mu=mu, chi=chi, tangent=part * starting_slope(mu, chi), until=until)
        for mu, chi in pairs
        for part in (0.9, 0.99, 1.01, 1.1)
        for until in (2.0, 4.0)
    ]
    level = [
        Run(part="level", mu=mu, chi=chi, begin=1.0, until=until)
        for mu, chi in pairs
        for until in (1.0, 4.0)
    ]
    soft = [
        Run(
            part="soft",
            mu=1.0,
            chi=chi,
            begin=begin,
            until=1.0,
            impratio=impratio,
            stiffness=0.02,
        )
        for impratio in (1.0, 100.0)
        for chi in (1e-4, 1e-3, 1e-2)
        for begin in (1.0, 0.1)
    ]
    return slopes + level + soft


def run(one: Run) -> Run:
    """Return a run with its end."""
    import mujoco  # type: ignore[import-not-found]  # not a package of the tests

    angle = math.atan(one.tangent)
    text = MODEL.format(along=math.sin(angle), down=-math.cos(angle), **asdict(one))
    model: Any = mujoco.MjModel.from_xml_string(text)
    data: Any = mujoco.MjData(model)
    data.qvel[:] = [one.begin, 0.0, one.begin]
    for _ in range(round(one.until / one.timestep)):
        mujoco.mj_step(model, data)
    speed, _, spin = map(float, data.qvel)
    return replace(one, speed=speed, spin=spin, version=mujoco.__version__)


def main() -> None:
    """Write the table."""
    TABLE.parent.mkdir(exist_ok=True)
    with TABLE.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(one.name for one in fields(Run))
        for one in map(run, planned()):
            writer.writerow(
                f"{value:.9g}" if isinstance(value, float) else value
                for value in asdict(one).values()
            )


if __name__ == "__main__":
    main()
