"""Exudyn: a rigid body with a sphere on a triangle, a penalty contact with regularised friction.

engine: Exudyn
contact: compliant
settings: default careful
requires: exudyn==1.13.6 numpy==2.4.6
docs: https://exudyn.readthedocs.io/en/latest/

default: the generalised-alpha method as it comes, and friction regularised below 0.001 m/s. Exudyn
has no stiffness of its own: it is 1e5 N/m.
careful: the trapezoidal rule, a stiffness of 100 over the step, friction regularised below a tenth
of the step; both as for 1e-4 with a smaller step, as iterations fail with more.
Cannot express: mu_s and mu_k (one coefficient). Contact is compliant. Restitution, at any speed, is
that of Exudyn's impact model 2. Without it damping is ten times the critical one of 1 kg: a
critical damper that pushes only gives back 0.14.
"""

import math

import exudyn as exu
import exudyn.utilities as utilities
import numpy as np
from adapter import SHORTEST, main

FAR = 1e3


def simulate(case, step, setting):
    """Yield rows."""
    mu = case.one_coefficient()
    coarse = max(step, 1e-4)
    stiffness, zone = (1e5, 1e-3) if setting == "default" else (100.0 / coarse, 0.1 * coarse)
    bounces = case.restitution > 0.0
    container = exu.SystemContainer()
    mbs = container.AddSystem()
    about_reference = (case.inertia + case.mass * case.h**2) * np.eye(3)
    about_reference[2, 2] = case.inertia
    # Counterclockwise, with x to the right and z upwards, is about -y.
    hoop = mbs.CreateRigidBody(
        inertia=utilities.RigidBodyInertia(
            case.mass, about_reference, com=np.array([0.0, 0.0, case.h])
        ),
        nodeType=exu.NodeType.RotationEulerParameters,
        referencePosition=[0.0, 0.0, case.radius],
        referenceRotationMatrix=utilities.RotationMatrixY(-case.theta),
        initialVelocity=[case.x_rate, 0.0, case.gap_rate],
        initialAngularVelocity=[0.0, -case.theta_rate, 0.0],
        gravity=[case.gravity[0], 0.0, case.gravity[1]],
    )
    ground = mbs.AddObject(utilities.ObjectGround())
    markers = [mbs.AddMarker(utilities.MarkerBodyRigid(bodyNumber=body)) for body in (hoop, ground)]
    history = mbs.AddNode(
        utilities.NodeGenericData(initialCoordinates=[0.0] * 4, numberOfDataCoordinates=4)
    )
    mbs.AddObject(
        utilities.ObjectContactSphereTriangle(
            markerNumbers=markers,
            nodeNumber=history,
            sphereRadius=case.radius,
            trianglePoints=exu.Vector3DList([[-FAR, -FAR, 0.0], [FAR, -FAR, 0.0], [0.0, FAR, 0.0]]),
            dynamicFriction=mu,
            frictionProportionalZone=zone,
            contactStiffness=stiffness,
            contactDamping=0.0 if bounces else 20.0 * math.sqrt(stiffness),
            restitutionCoefficient=case.restitution if bounces else 1.0,
            impactModel=2 if bounces else 0,
        )
    )
    kinds = exu.OutputVariableType
    place, turn, velocity, turning = (
        mbs.AddSensor(
            utilities.SensorBody(bodyNumber=hoop, storeInternal=True, outputVariableType=kind)
        )
        for kind in (kinds.Position, kinds.RotationMatrix, kinds.Velocity, kinds.AngularVelocity)
    )
    mbs.Assemble()
    settings = exu.SimulationSettings()
    settings.solutionSettings.writeSolutionToFile = False
    settings.solutionSettings.sensorsWritePeriod = max(step, SHORTEST * case.second)
    settings.timeIntegration.numberOfSteps, settings.timeIntegration.endTime = (
        round(case.until / step),
        case.until,
    )
    settings.timeIntegration.verboseMode = 0
    solvers = exu.DynamicSolverType
    solver = solvers.GeneralizedAlpha if setting == "default" else solvers.TrapezoidalIndex2
    yield 0.0, 0.0, case.radius, case.theta, case.x_rate, case.gap_rate, case.theta_rate
    mbs.SolveDynamic(settings, solverType=solver)
    places, turns, velocities, rates = (
        np.array(mbs.GetSensorStoredData(sensor)) for sensor in (place, turn, velocity, turning)
    )
    angles = np.unwrap(np.arctan2(-turns[:, 3], turns[:, 9]))
    angles += case.theta - angles[0]
    columns = places[1:], angles[1:], velocities[1:], rates[1:]
    for (time, x, _, height), angle, (_, vx, _, vy), rate in zip(*columns, strict=True):
        yield time, x, height, angle, vx, vy, -rate[2]


if __name__ == "__main__":
    main(simulate)
