/* Jolt (jolt-physics, its build for WebAssembly): a sphere with its mass centre off its centre, on a large box.

engine: Jolt
contact: rigid
settings: default careful
requires: npm:jolt-physics==1.1.0
limits: own_turn=47.1 damping=0.05,0.05 friction=root force=none rolling=none rolling_small=none
  rolling_slow=none
limits default: own_speed=500 sleep=0.03 bounce=1.05
limits careful: own_speed=50 sleep=0.003 radius=10
docs: https://jrouwe.github.io/JoltPhysics/

default: as the package comes: 10 velocity and 2 position iterations, a slop of 0.02 m, no damping.
careful: R is 10 m, a slop of 1e-4 m, no speculative contact, 100 and 20 iterations, restitution at any speed.
Cannot express: mu_s and mu_k (one coefficient, the root of the product of those of two bodies). Restitution, the larger
of two, acts above 1 m/s by default. Everything is in single precision. */
"use strict";
const { join } = require("node:path");
const { pathToFileURL } = require("node:url");
const { centreRates, frictionOfPlane, main, massCentre, oneCoefficient } = require("./adapter.cjs");

const RADII = { default: null, careful: 10 };
const HALF = 100;

function prepare(Jolt, hoop, step, setting) {
  const radius = RADII[setting] ?? hoop.radius;
  const size = radius / hoop.radius;
  const friction = oneCoefficient(hoop);
  const settings = new Jolt.JoltSettings();
  const layers = new Jolt.ObjectLayerPairFilterTable(2);
  layers.EnableCollision(0, 1);
  const broad = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
  for (const i of [0, 1]) broad.MapObjectToBroadPhaseLayer(i, new Jolt.BroadPhaseLayer(i));
  settings.mObjectLayerPairFilter = layers;
  settings.mBroadPhaseLayerInterface = broad;
  settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(broad, 2, layers, 2);
  const world = new Jolt.JoltInterface(settings);
  const physics = world.GetPhysicsSystem();
  const options = physics.GetPhysicsSettings();
  options.mAllowSleeping = Boolean(hoop.is_untouched);
  if (setting === "careful") {
    Object.assign(options, { mPenetrationSlop: 1e-4, mSpeculativeContactDistance: 0, mMinVelocityForRestitution: 0 });
    Object.assign(options, { mNumVelocitySteps: 100, mNumPositionSteps: 20 });
  }
  physics.SetPhysicsSettings(options);
  physics.SetGravity(new Jolt.Vec3(-hoop.g * Math.sin(hoop.slope) * size, -hoop.g * Math.cos(hoop.slope) * size, 0));
  const bodies = physics.GetBodyInterface();
  const add = (shape, place, angle, type, layer, change) => {
    const turned = new Jolt.Quat(0, 0, Math.sin(angle / 2), Math.cos(angle / 2));
    const given = new Jolt.BodyCreationSettings(shape, place, turned, type, layer);
    Object.assign(given, { mFriction: friction, mRestitution: hoop.restitution });
    if (!hoop.is_untouched) Object.assign(given, { mLinearDamping: 0, mAngularDamping: 0 });
    change(given);
    const body = bodies.CreateBody(given);
    bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
    return body;
  };
  const floor = new Jolt.BoxShape(new Jolt.Vec3(HALF * radius, radius, radius), 0);
  add(floor, new Jolt.RVec3(0, -radius, 0), 0, Jolt.EMotionType_Static, 0, (given) => {
    given.mFriction = frictionOfPlane(hoop, friction);
  });
  const sphere = new Jolt.SphereShape(radius);
  const shape = new Jolt.OffsetCenterOfMassShape(sphere, new Jolt.Vec3(0, hoop.h * size, 0));
  const body = add(shape, new Jolt.RVec3(0, radius, 0), hoop.theta, Jolt.EMotionType_Dynamic, 1, (given) => {
    const mass = new Jolt.MassProperties();
    mass.mMass = hoop.mass;
    mass.mInertia = Jolt.Mat44.prototype.sScale(hoop.inertia * size * size);
    given.mMassPropertiesOverride = mass;
    given.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    given.mAllowedDOFs = Jolt.EAllowedDOFs_Plane2D;
    if (!hoop.is_untouched) Object.assign(given, { mMaxAngularVelocity: 1e4, mMaxLinearVelocity: 1e5 });
  });
  const { vx, vy } = massCentre(hoop);
  body.SetLinearVelocity(new Jolt.Vec3(vx * size, vy * size, 0));
  body.SetAngularVelocity(new Jolt.Vec3(0, 0, hoop.theta_rate));
  let turns = hoop.theta;
  return {
    advance: () => world.Step(step, 1),
    row: () => {
      const at = body.GetPosition();
      const turn = body.GetRotation();
      // A quaternion knows an angle up to whole turns.
      const angle = 2 * Math.atan2(turn.GetZ(), turn.GetW());
      turns += (((angle - turns + Math.PI) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI) - Math.PI;
      const v = body.GetLinearVelocity();
      const rates = centreRates(hoop, turns, v.GetX() / size, v.GetY() / size, body.GetAngularVelocity().GetZ());
      return [at.GetX() / size, at.GetY() / size, turns, ...rates];
    },
  };
}

const file = join(process.env.NODE_PATH, "jolt-physics", "dist", "jolt-physics.wasm-compat.js");
import(pathToFileURL(file)).then(async (module) => {
  const Jolt = await module.default();
  main((hoop, step, setting) => prepare(Jolt, hoop, step, setting));
});
