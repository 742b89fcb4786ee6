#!/usr/bin/env bash
# MuJoCo 4.0.0: a small torsional friction brakes a spinning ball a twentieth as much as its law says.
#
# A ball of R = 0.1 m spins upright on a plane, condim 4, torsional friction c = 1e-4 m: the law's moment c m g slows it by 2.5 c g/R² = 0.245 rad/s².
# Seen, as a part of that, with a time step of 1 ms:
#
#   cone        impratio 1   10     100
#   pyramidal   0.05         0.39   1.00
#   elliptic    0.11         1.00   1.00
#
# The first column has the defaults of impratio and cone. With c = 1e-3 m the defaults reach 0.40, elliptic cones 1.00. 128 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages mujoco==4.0.0 numpy==2.4.6

python - <<'PYTHON'
import mujoco

RADIUS, STEP, GRAVITY = 0.1, 1e-3, 9.81


def part_of_the_law(coefficient, cone, impratio):
    friction = f'condim="4" friction="1 {coefficient} 0"'
    model = mujoco.MjModel.from_xml_string(f"""
<mujoco>
  <option timestep="{STEP}" impratio="{impratio}" cone="{cone}"/>
  <worldbody>
    <geom type="plane" size="1 1 1" {friction}/>
    <body pos="0 0 {RADIUS}"><freejoint/><geom type="sphere" size="{RADIUS}" {friction}/></body>
  </worldbody>
</mujoco>""")
    data = mujoco.MjData(model)
    data.qvel[5] = 10.0
    spins = []
    for _ in range(400):
        mujoco.mj_step(model, data)
        spins.append(data.qvel[5])
    slowing = (spins[199] - spins[399]) / (200 * STEP)
    return slowing / (2.5 * coefficient * GRAVITY / RADIUS**2)


for coefficient, cone, expected in (
    (1e-4, "pyramidal", (0.052, 0.393, 1.0)),
    (1e-4, "elliptic", (0.113, 1.0, 1.0)),
    (1e-3, "pyramidal", (0.400, 1.0, 1.0)),
    (1e-3, "elliptic", (1.0, 1.0, 1.0)),
):
    parts = [part_of_the_law(coefficient, cone, ratio) for ratio in (1, 10, 100)]
    print(coefficient, cone, [round(part, 3) for part in parts])
    assert all(abs(part - right) < 0.02 for part, right in zip(parts, expected)), parts
PYTHON
