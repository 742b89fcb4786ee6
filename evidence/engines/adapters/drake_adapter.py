"""Drake: MultibodyPlant, a sphere on a half space, point contact.

A planar joint is at the geometric centre.

engine: Drake
contact: compliant
settings: default careful continuous
requires: contourpy==1.3.3 cycler==0.12.1 drake==1.51.1 fonttools==4.68.0 kiwisolver==1.5.1
  matplotlib==3.11.2 Mosek==11.1.2 numpy==2.4.6 packaging==26.3 pillow==13.0.0 pydot==4.0.1
  pyparsing==3.3.3 python-dateutil==4.0.0 PyYAML==6.0.3 tzdata==2026.6
limits: bounce=none friction=harmonic rolling=none rolling_small=none rolling_slow=none
limits default: force=0.34,+0
limits careful: force=0.98,+0
limits continuous: force=0.30,+0
docs: https://drake.mit.edu/doxygen_cxx/

default: the discrete plant as it comes (its step is that of the case).
careful: discrete, a stiff contact (1e8 N/m), a stiction tolerance of 1e-5 m/s.
continuous: the penalty model of the continuous plant with both coefficients (1e6 N/m, dissipation
300 s/m), integrated at an accuracy of 1e-6; the step is that of the record and the largest of the
integrator.
Cannot express: in discrete plants mu_s and mu_k (one coefficient); restitution anywhere. Contact is
compliant.
"""

import numpy as np
from adapter import main, stepped
from pydrake.geometry import AddContactMaterial, HalfSpace, ProximityProperties, Sphere
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.plant import AddMultibodyPlantSceneGraph, CoulombFriction
from pydrake.multibody.tree import FixedOffsetFrame, PlanarJoint, SpatialInertia, UnitInertia
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder

MATERIALS = {
    "default": {},
    "careful": {"point_stiffness": 1e8},
    "continuous": {"point_stiffness": 1e6, "dissipation": 300.0},
}


def simulate(case, step, setting):
    """Yield rows."""
    case.without_restitution()
    continuous = setting == "continuous"
    if not continuous:
        case.one_coefficient()
    builder = DiagramBuilder()
    plant, _ = AddMultibodyPlantSceneGraph(builder, time_step=0.0 if continuous else step)
    plant.mutable_gravity_field().set_gravity_vector([case.gravity[0], 0.0, case.gravity[1]])
    about_centre = UnitInertia(*[case.inertia / case.mass] * 3)
    com = np.array([0.0, 0.0, case.h])
    inertia = SpatialInertia.MakeFromCentralInertia(case.mass, com, case.mass * about_centre)
    hoop = plant.AddRigidBody("hoop", inertia)
    properties = ProximityProperties()
    friction = CoulombFriction(case.mu_s, case.mu_k)
    AddContactMaterial(properties=properties, friction=friction, **MATERIALS[setting])
    if setting != "default":
        plant.set_stiction_tolerance(1e-5)
    other = case.friction_of_plane(case.mu_k)
    ground = properties
    if other != case.mu_k:
        ground, rubs = ProximityProperties(), CoulombFriction(other, other)
        AddContactMaterial(properties=ground, friction=rubs, **MATERIALS[setting])
    plant.RegisterCollisionGeometry(
        plant.world_body(), RigidTransform(), HalfSpace(), "plane", ground
    )
    rim = Sphere(case.radius)
    plant.RegisterCollisionGeometry(hoop, RigidTransform(), rim, "rim", properties)
    # The joint's x and y are the world's x and z, so that it turns counterclockwise about -y.
    axes = RigidTransform(
        RotationMatrix(np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])), [0.0, 0.0, case.radius]
    )
    own = RigidTransform(axes.rotation())
    base = plant.AddFrame(FixedOffsetFrame("base", plant.world_frame(), axes))
    middle = plant.AddFrame(FixedOffsetFrame("middle", hoop.body_frame(), own))
    plant.AddJoint(PlanarJoint("plane", base, middle, np.zeros(3)))
    plant.Finalize()
    diagram = builder.Build()
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    plant.SetPositions(context, [0.0, 0.0, case.theta])
    plant.SetVelocities(context, [case.x_rate, case.gap_rate, case.theta_rate])
    if continuous:
        simulator.get_mutable_integrator().set_maximum_step_size(step)
        simulator.get_mutable_integrator().request_initial_step_size_target(step)
        simulator.get_mutable_integrator().set_target_accuracy(1e-6)
    simulator.Initialize()
    done = 0

    def advance():
        nonlocal done
        done += 1
        simulator.AdvanceTo(done * step)

    def row(time):
        x, height, theta = plant.GetPositions(context)
        there = (time, x, case.radius + height, theta, *plant.GetVelocities(context))
        return case.forced(there, force)

    def force():
        results = plant.get_contact_results_output_port().Eval(context)
        pairs = range(results.num_point_pair_contacts())
        return sum(abs(results.point_pair_contact_info(i).contact_force()[2]) for i in pairs)

    yield from stepped(case, step, advance, row)


if __name__ == "__main__":
    main(simulate)
