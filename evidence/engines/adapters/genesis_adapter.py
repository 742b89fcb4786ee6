"""Genesis: a sphere on a plane, on the processor, in double precision.

Two slides and a hinge are at the geometric centre.

engine: Genesis
contact: compliant
settings: default
requires: annotated-types==0.8.0 av==18.1.0 cffi==2.1.1 coacd==1.0.14 colorama==0.4.6
  contourpy==1.3.3 cuda-bindings==13.5.0 cuda-pathfinder==1.9.1 cuda-toolkit==13.2.2 cycler==0.12.1
  dataclasses-json==0.6.7 decorator==5.3.1 Deprecated==1.3.1 dill==0.4.1 DracoPy==2.2.0
  fast_simplification==0.2.0 filelock==4.3.1 fonttools==4.68.0 freetype-py==2.5.1 frozendict==2.5.1
  fsspec==2026.9.0 genesis-world==1.4.5 glfw==2.11.0 gs-madrona==0.0.10 ImageIO==2.38.1
  imageio-ffmpeg==0.8.1 Jinja2==3.1.6 kiwisolver==1.5.1 lazy-loader==0.6 libigl==2.6.3
  llvmlite==0.50.0 markdown-it-py==4.3.0 MarkupSafe==3.0.4 marshmallow==3.26.2 matplotlib==3.11.2
  mdurl==0.1.2 moviepy==2.2.1 mpmath==1.3.0 mujoco==4.0.0 mujoco-core==4.0.0 mujoco-studio==4.0.0
  mypy_extensions==1.2.0 networkx==3.6.1 numba==0.68.1 numpy==2.4.6 nvidia-cublas==13.4.1.3
  nvidia-cuda-cccl==13.3.5.0.6 nvidia-cuda-cupti==13.2.86 nvidia-cuda-nvrtc==13.2.86
  nvidia-cuda-nvrtc-cu12==12.9.86 nvidia-cuda-runtime==13.2.86 nvidia-cudnn-cu13==9.26.0.51
  nvidia-cufft==12.2.0.57 nvidia-cufile==1.17.1.22 nvidia-cusolver==12.2.0.11
  nvidia-cusparse==12.7.10.12 nvidia-cusparselt-cu13==0.8.1 nvidia-nccl-cu13==2.30.7
  nvidia-nvjitlink==13.5.37 nvidia-nvjitlink-cu12==12.9.86 nvidia-nvshmem-cu13==3.7.2
  nvidia-nvtx==13.2.86 opencv-python==5.0.0.93 OpenEXR==3.5.3 packaging==26.4 pillow==11.3.0
  plotly==5.24.1 proglog==0.1.12 psutil==7.2.2 py-cpuinfo==9.0.0 pycollada==0.9.3 pycparser==3.12
  pydantic==2.14.4 pydantic_core==2.50.5 PyGEL3D==0.8.2 pyglet==2.1.19 pygltflib==1.16.0
  Pygments==2.21.0 pymeshlab==2025.7.post1 PyOpenGL==3.1.10 pyparsing==3.3.3 pysplashsurf==0.14.1.0
  python-dateutil==4.0.0 python-dotenv==1.2.4 PyYAML==6.0.4 quadrants==1.3.3 rich==15.0.0
  rtree==1.4.1 scikit-image==0.26.0 scipy==1.17.1 sympy==1.14.0 tenacity==9.2.1 tetgen==0.8.2
  tifffile==2026.3.3 torch==2.15.0 tqdm==4.70.1 trimesh==5.2.0 triton==3.9.0 typing-inspect==0.9.0
  typing-inspection==0.4.5 typing_extensions==4.16.0 tzdata==2026.6 vtk==9.7.2 websockets==17.4
  wrapt==2.5.2 xacro==2.1.1 z3-solver==4.15.4.0 zstandard==0.25.0
rolling: one budget for friction and couple, as MuJoCo's, by its documentation; the coefficient, a
  length, is the larger of those of both bodies, χ R. It was not run.
docs: https://genesis-world.readthedocs.io/

default: as the package comes: a pyramidal cone, constraints with a time constant of 0.01, Newton's
method. Rolling friction is switched on where the case has some. Its kernels are translated at the
first run, for six minutes on two cores, and kept: such a run is ended for its time.
Cannot express: mu_s and mu_k (one coefficient, the larger of two bodies); a coefficient of
restitution.
"""

import tempfile
from pathlib import Path

import genesis
from adapter import main, stepped

MODEL = """
<mujoco><worldbody><body pos="0 0 {radius!r}">
  <inertial pos="0 0 {h!r}" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>
  <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 0 1"/><joint type="hinge" axis="0 -1
  0"/> <geom type="sphere" size="{radius!r}"/>
</body></worldbody></mujoco>
"""


def simulate(case, step, _):
    """Yield rows."""
    case.without_restitution()
    mu = case.one_coefficient()
    genesis.init(backend=genesis.cpu, precision="64", logging_level="error")
    rolls = case.rolling_resistance > 0.0
    along, away = case.gravity
    scene = genesis.Scene(
        show_viewer=False,
        sim_options=genesis.options.SimOptions(dt=step, gravity=(along, 0.0, away)),
        rigid_options=genesis.options.RigidOptions(
            enable_torsional_friction=rolls, enable_rolling_friction=rolls
        ),
    )

    def material(friction):
        # Nothing turns about the normal, so that torsional friction may be what it is.
        return genesis.materials.Rigid(friction=friction, friction_rolling=case.rolling_resistance)

    plane = material(case.friction_of_plane(mu))
    scene.add_entity(genesis.morphs.Plane(), material=plane)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "hoop.xml"
        path.write_text(
            MODEL.format(h=case.h, mass=case.mass, inertia=case.inertia, radius=case.radius),
            encoding="utf-8",
        )
        hoop = scene.add_entity(genesis.morphs.MJCF(file=str(path)), material=material(mu))
        scene.build()
    # One step is made for the translation of kernels, and undone.
    scene.step()
    scene.reset()
    hoop.set_dofs_position([0.0, 0.0, case.theta])
    hoop.set_dofs_velocity([case.x_rate, case.gap_rate, case.theta_rate])

    def row(time):
        x, height, theta = hoop.get_dofs_position().tolist()
        rates = hoop.get_dofs_velocity().tolist()
        return case.forced((time, x, case.radius + height, theta, *rates), force)

    def force():
        return float(hoop.get_links_net_contact_force()[-1, 2])

    yield from stepped(case, step, scene.step, row)


if __name__ == "__main__":
    main(simulate, has_rolling_friction=True)
