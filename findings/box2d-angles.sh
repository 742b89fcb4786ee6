#!/usr/bin/env bash
# Box2D 3.1.1 (pyb2d3 0.11.1): a rotation made from an angle has another angle, by up to 1.7e-3 rad, a tenth of a degree.
#
# Single precision would be right to 1e-7. Seen, over 2,001 angles from −π to π:
#
#   make_rot(angle) against the angle      1.65e-3
#   angle of a body against its rotation   2.8e-5
#
# A ramp that is set up at 10° rises by 10.09°. A rotation that is made from cosine and sine is right. 22 s, most of it installing.
# shellcheck source=findings/common.sh
source "$(dirname "$0")/common.sh"
packages pyb2d3==0.11.1 numpy==2.4.6

python - <<'PYTHON'
import math

import pyb2d3 as b2

world = b2.World(gravity=(0.0, 0.0))
ANGLES = [math.pi * k / 1000 for k in range(-1000, 1001)]


def apart(one, other):
    return abs(math.remainder(one - other, math.tau))


def made(angle):
    rotation = b2.make_rot(angle)
    return math.atan2(rotation.s, rotation.c)


def read(angle):
    rotation = b2.Rot()
    rotation.c, rotation.s = math.cos(angle), math.sin(angle)
    return world.create_dynamic_body(rotation=rotation).angle


worst = max(ANGLES, key=lambda angle: apart(made(angle), angle))
of_made, of_read = apart(made(worst), worst), max(apart(read(angle), angle) for angle in ANGLES)
ramp = math.degrees(made(math.radians(10.0)))
print(f"a ramp of 10° has {ramp:.3f}°")
print(f"make_rot: {of_made:.2e} at {math.degrees(worst):.1f}°; angle of a body: {of_read:.1e}")
assert 10.09 < ramp < 10.095
assert 1.6e-3 < of_made < 1.7e-3 and 2e-5 < of_read < 4e-5
PYTHON
