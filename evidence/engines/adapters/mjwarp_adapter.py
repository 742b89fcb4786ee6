"""MuJoCo Warp: MuJoCo's method in Warp, on Warp's processor device.

The hoop is MuJoCo's own model.

engine: MuJoCo Warp
contact: compliant
settings: default careful
requires: absl-py==2.5.1 etils==1.15.0 fsspec==2026.9.0 glfw==2.11.0 mujoco==4.0.0
  mujoco-core==4.0.0 mujoco-studio==4.0.0 mujoco-warp==4.0.0 numpy==2.4.6 PyOpenGL==3.1.10
  typing_extensions==4.16.0 warp-lang==1.19.0 websockets==17.4 zipp==4.1.2
rolling: as MuJoCo.
docs: https://github.com/google-deepmind/mujoco_warp

default and careful: as in mujoco_adapter.py. Everything is in single precision. On the processor a
step takes some milliseconds, as it starts a hundred kernels: the engine is made for many motions at
once on a GPU.
Cannot express: mu_s and mu_k (one coefficient); a coefficient of restitution. See there.
"""

import mujoco
import mujoco_warp
import warp
from adapter import main, stepped
from mujoco_adapter import model_of, row_of, start_of


def simulate(case, step, setting):
    """Yield rows."""
    warp.config.quiet = True
    model = model_of(case, step, setting)
    data = mujoco.MjData(model)
    data.qpos[:], data.qvel[:] = start_of(case)
    mujoco.mj_forward(model, data)
    with warp.ScopedDevice("cpu"):
        there, here = mujoco_warp.put_model(model), mujoco_warp.put_data(model, data)
        # The kernels are translated before the first row.
        mujoco_warp.step(there, mujoco_warp.put_data(model, data))

        def row(time):
            columns = (one.numpy()[0].tolist() for one in (here.qpos, here.qvel))
            return row_of(case, time, *columns, float(here.qfrc_constraint.numpy()[0, 1]))

        yield from stepped(case, step, lambda: mujoco_warp.step(there, here), row)


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
