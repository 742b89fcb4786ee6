"""Exudyn: a rigid body with a sphere on a triangle, a penalty contact with regularised friction.

engine: Exudyn
contact: compliant
settings: default careful
requires: exudyn==1.13.6 numpy==2.4.6
limits: friction=pair rolling=none rolling_small=none rolling_slow=none
limits default: own_turn=fails turn=fails force=6.37,+0
limits careful: force=6.37,-1
docs: https://exudyn.readthedocs.io/en/latest/

default: the generalised-alpha method as it comes, and friction regularised below 0.001 sqrt(gR).
Exudyn has no stiffness of its own: it is 1e5 m2 g/R, that is N/m where R is 1 m.
careful: the trapezoidal rule, a stiffness of 100 over the step, friction regularised below a tenth
of the step; both as for 1e-4 with a smaller step, as iterations fail with more.
Cannot express: mu_s and mu_k (one coefficient). Contact is compliant. Restitution, at any speed, is
that of Exudyn's impact model 2. Without it damping is ten times the critical one of m2: a critical
damper that pushes only gives back 0.14.
"""

import math

import exudyn as exu
import exudyn.utilities as utilities
import numpy as np
from adapter import SHORTEST, main

FAR = 1e3
"""Half the size of the plane, R."""


def simulate(case, step, setting):
    """Yield rows."""
    mu = case.friction_of_pair()
    coarse = max(step / case.second, 1e-4)
    stiffness, zone = (1e5, 1e-3) if setting == "default" else (100.0 / coarse, 0.1 * coarse)
    stiffness *= case.unit_of_mass * case.g / case.radius
    zone *= math.sqrt(case.g * case.radius)
    bounces = case.restitution > 0.0
    far = FAR * case.radius
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
    contact = mbs.AddObject(
        utilities.ObjectContactSphereTriangle(
            markerNumbers=markers,
            nodeNumber=history,
            sphereRadius=case.radius,
            trianglePoints=exu.Vector3DList([[-far, -far, 0.0], [far, -far, 0.0], [0.0, far, 0.0]]),
            dynamicFriction=mu,
            frictionProportionalZone=zone,
            contactStiffness=stiffness,
            contactDamping=0.0 if bounces else 20.0 * math.sqrt(stiffness * case.unit_of_mass),
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
    push = mbs.AddSensor(
        utilities.SensorObject(
            objectNumber=contact, storeInternal=True, outputVariableType=kinds.Force
        )
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
    start = 0.0, 0.0, case.radius, case.theta, case.x_rate, case.gap_rate, case.theta_rate
    yield case.forced(start, lambda: 0.0)
    mbs.SolveDynamic(settings, solverType=solver)
    places, turns, velocities, rates, forces = (
        np.array(mbs.GetSensorStoredData(sensor))
        for sensor in (place, turn, velocity, turning, push)
    )
    angles = np.unwrap(np.arctan2(-turns[:, 3], turns[:, 9]))
    angles += case.theta - angles[0]
    for i in range(1, len(places)):
        (time, x, _, height), (_, vx, _, vy) = places[i], velocities[i]
        there = time, x, height, angles[i], vx, vy, -rates[i][2]
        yield case.forced(there, lambda i=i: abs(forces[i][3]))


if __name__ == "__main__":
    main(simulate)
