"""What everyone does first with an installed package.

It has the motion of Figure 3, its types, its licences, and the program.
"""

import json
import math
import subprocess
import sys
import sysconfig
from importlib.metadata import distribution, version
from pathlib import Path

import littlewood as lw

hoop = lw.Hoop(mass_ratio=1, offset=1, inertia=1, mu_s=0.5, mu_k=0.4)
motion = hoop.simulate(theta=math.pi / 2, theta_rate=2)
assert [transition.cause for transition in motion.transitions] == [
    "stick",
    "slip",
    "lift_off",
    "landing",
]

files = [str(path) for path in distribution("littlewood").files or []]
for needed in ["py.typed", "_core.pyi", "LICENSE-MIT", "LICENSE-APACHE", "LICENSE-STIX"]:
    assert any(file.endswith(needed) for file in files), f"{needed} is missing: {files}"

script = next(Path(sysconfig.get_path("scripts")).glob("littlewood*"))
for program in [[sys.executable, "-m", "littlewood"], [str(script)]]:
    run = [*program, "simulate", "figure-3", "--format", "json"]
    printed = json.loads(
        subprocess.run(run, check=True, capture_output=True, encoding="utf-8").stdout
    )
    assert [it["time"] for it in printed["transitions"]] == [it.time for it in motion.transitions]
    refused = subprocess.run(
        [*program, "simulate", "figure-3", "--mu-s", "-1"], capture_output=True, check=False
    )
    assert refused.returncode == 2, refused
    told = subprocess.run(
        [*program, "--version"], check=True, capture_output=True, encoding="utf-8"
    ).stdout
    assert told == f"littlewood {version('littlewood')}\n", told
print(f"Python {sys.version.split()[0]}, littlewood {version('littlewood')}: ok")
